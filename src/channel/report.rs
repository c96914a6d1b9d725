//! Where and why there is no channel, in words.

use crate::artifact::channel::{Binding, ChannelRow};
use crate::artifact::{AxisTravel, Blade, ToolPart, Toolpath};
use crate::error::{At, Bound, Error, Infeasible, Stage, turn_number};
use crate::geometry::Point;
use crate::geometry::part::Part;

use super::forbidden::{Free, ObstacleBody, ObstacleScene, PlaceSearch};
use super::samples::Sample;
use super::walls::{Crossing, binding};

/// What the messages need to know.
pub(super) struct Reporter<'a> {
    pub blade: &'a Blade,
    pub path: &'a Toolpath,
    pub scene: &'a ObstacleScene<'a>,
    pub samples: &'a [Sample],
    /// The first of them is where the tool starts.
    pub is_start: bool,
}

impl Reporter<'_> {
    /// No chain reaches sample `at`.
    pub fn closed(&self, layers: &[Vec<Free>], at: usize) -> Error {
        let Some(sample) = self.samples.get(at) else {
            return Error::infeasible(
                Stage::Channel,
                "the channel is closed everywhere",
                Infeasible::ChannelClosedEverywhere,
            );
        };
        let place = self.place(sample.row);
        let here = layers.get(at).map(Vec::as_slice).unwrap_or_default();
        if here.is_empty() {
            let (what, ends) = self.everything_taken(sample);
            let at_start = at == 0 && self.is_start;
            let start = if at_start { "the tool starts in collision: " } else { "" };
            let message = format!("{start}no angle of the tool axis is free at {place}: {what}");
            let what = Infeasible::NoFreeAngle {
                at: self.at(sample.row),
                at_start,
                bounds: self.bounds(&ends),
                region_may_end_mm: self.above(sample.row),
            };
            return Error::infeasible(Stage::Channel, message, what).advise(advice_for(&ends));
        }
        let before = at.checked_sub(1).and_then(|i| layers.get(i)).map(Vec::as_slice).unwrap_or_default();
        let ends: Vec<Binding> = here
            .iter()
            .chain(before)
            .flat_map(|f| [binding(f.lo_by, self.scene), binding(f.hi_by, self.scene)])
            .collect();
        let mut said: Vec<String> = Vec::new();
        for text in ends.iter().filter(|b| **b != Binding::Free).map(|b| self.blame(b)) {
            if !said.contains(&text) {
                said.push(text);
            }
        }
        Error::infeasible(
            Stage::Channel,
            format!(
                "the channel closes at {place}: its free angles there do not join on to those just before ({})",
                said.join("; ")
            ),
            Infeasible::ChannelCloses {
                at: self.at(sample.row),
                bounds: self.bounds(&ends),
                region_may_end_mm: self.above(sample.row),
            },
        )
        .advise(advice_for(&ends))
    }

    /// The channel closes on the move from sample `at` to the next.
    pub fn closed_between(&self, from: &Free, to: &Free, at: usize) -> Error {
        let row = self.samples.get(at).map_or(0, |s| s.row);
        let mut ends: Vec<Binding> = Vec::new();
        for by in [from.lo_by, from.hi_by, to.lo_by, to.hi_by] {
            let b = binding(by, self.scene);
            if b != Binding::Free && !ends.contains(&b) {
                ends.push(b);
            }
        }
        let said: Vec<String> = ends.iter().map(|b| self.blame(b)).collect();
        let widths_deg = [from, to].map(|f| (f.hi - f.lo).to_degrees());
        Error::infeasible(
            Stage::Channel,
            format!(
                "the channel closes on the move after {}: {:.3}° wide before it and {:.3}° after it, no straight walls lead \
                 through it ({})",
                self.place(row),
                widths_deg[0],
                widths_deg[1],
                said.join("; ")
            ),
            Infeasible::ChannelClosesOnMove {
                after: self.at(row),
                widths_deg,
                bounds: self.bounds(&ends),
                region_may_end_mm: self.above(row),
            },
        )
        .advise(advice_for(&ends))
    }

    /// The hulls cross.
    pub fn crossing(&self, rows: &[ChannelRow], crossing: Crossing) -> Error {
        let (Some(a), Some(b)) = (rows.get(crossing.low_row), rows.get(crossing.high_row)) else {
            return Error::infeasible(Stage::Channel, "no monotone schedule exists", Infeasible::NoMonotoneWay);
        };
        let ends = [a.binds_min.clone(), b.binds_max.clone()];
        Error::infeasible(
            Stage::Channel,
            format!(
                "no schedule without turning back exists: θ must be at least {:.2}° at {} ({}) but at most {:.2}° later at {} ({})",
                a.theta_min.to_degrees(),
                self.place(crossing.low_row),
                self.blame(&ends[0]),
                b.theta_max.to_degrees(),
                self.place(crossing.high_row),
                self.blame(&ends[1]),
            ),
            Infeasible::WallsCross {
                lower_at: self.at(crossing.low_row),
                lower_deg: a.theta_min.to_degrees(),
                upper_at: self.at(crossing.high_row),
                upper_deg: b.theta_max.to_degrees(),
                bounds: self.bounds(&ends),
                region_may_end_mm: self.above(crossing.high_row),
            },
        )
        .advise(advice_for(&ends))
    }

    /// The height at which the turn of this location begins, mm (of a helix that rises: ends): the
    /// turns above do without the location. `None` where fewer than two whole turns are left.
    pub fn above(&self, row: usize) -> Option<f64> {
        let turn = self.path.locations.get(row)?.turn as usize;
        if self.path.region_x_mm[1] > self.path.region_x_mm[0] {
            let next = self.path.turns.get(turn + 1).filter(|_| turn + 3 <= self.path.turns.len())?.first;
            return self.path.locations.get(next).map(|l| l.centre.x);
        }
        let first = self.path.turns.get(turn).filter(|_| turn >= 2)?.first;
        let (begin, own) = (self.path.locations.get(first)?.centre.x, self.path.locations.get(row)?.centre.x);
        // Turns that tilt may begin lower than they are at the location.
        let pitch = (8.0 * self.path.radius_mm * self.path.scallop_mm).sqrt();
        Some(if own > begin { own + pitch } else { begin })
    }

    pub fn at(&self, row: usize) -> At {
        at(self.path, row, |p| self.blade.model_from_blade * p)
    }

    /// Bindings as data, each once.
    fn bounds(&self, ends: &[Binding]) -> Vec<Bound> {
        let mut out: Vec<Bound> = Vec::new();
        for bound in ends.iter().filter_map(|b| bound(b, &self.blade.part)) {
            if !out.contains(&bound) {
                out.push(bound);
            }
        }
        out
    }

    pub fn place(&self, row: usize) -> String {
        let Some(l) = self.path.locations.get(row) else { return format!("location {row}") };
        let p = self.blade.model_from_blade * l.centre;
        format!(
            "turn {}, S = {:.2} mm, ball centre ({:.3}, {:.3}, {:.3}) mm in the model, {:.3} mm along the blade axis",
            turn_number(l.turn),
            l.turn_s_mm,
            p.x,
            p.y,
            p.z,
            l.centre.x
        )
    }

    fn blame(&self, b: &Binding) -> String {
        match b {
            Binding::Part { tool, face, triangle } => {
                let name = self.blade.part.face_name(*face);
                let corners = self.blade.part.mesh.corners(*triangle as usize);
                let at = (corners[0].coords + corners[1].coords + corners[2].coords) / 3.0;
                format!("{tool} against {name}, {:.2} mm along the blade axis", at.x)
            }
            Binding::Fixture { name, tool, .. } => format!("{tool} against {name}"),
            Binding::AxisLimit => "a limit of the rotary axis".into(),
            Binding::Travel { axis } => format!("the travel of {axis}"),
            Binding::ContactAngle => "the permitted range of contact angle".into(),
            Binding::Free => "nothing".into(),
        }
    }

    /// What takes the whole circle at a sample: the limits without which there would be free
    /// angles.
    fn everything_taken(&self, sample: &Sample) -> (String, Vec<Binding>) {
        let mut said = Vec::new();
        let mut ends = Vec::new();
        let mut wide = self.scene.options.clone();
        (wide.settings.contact_angle_min_deg, wide.settings.contact_angle_max_deg) = (0.0, 180.0);
        let parts = self.scene.bodies.first().map(|b| b.profile.parts.clone()).unwrap_or_default();
        for &part in &parts {
            if self.free_with(sample, &|p| p != part, self.scene.options).is_empty() {
                continue;
            }
            let by = self.free_with(sample, &|p| p == part, &wide).into_iter().find(|b| *b != Binding::Free);
            let b = by.unwrap_or(Binding::Part { tool: part, face: 0, triangle: 0 });
            said.push(format!("without the {part} there would be room ({})", self.blame(&b)));
            ends.push(b);
        }
        // What axes cut off comes after all else is free.
        if !self.free_with(sample, &|_| true, self.scene.options).is_empty() {
            ends = self.axes_short(sample);
            let words: Vec<String> = ends.iter().map(|b| self.blame(b)).collect();
            said = vec![format!("{} leaves none of what is free of all bodies", words.join(", or "))];
            if ends.is_empty() {
                // The windows of a cutter with a corner join on to one another.
                said = vec!["the surface turns faster there than the contact angle can follow".into()];
                ends.push(Binding::ContactAngle);
            }
        } else if !self.free_with(sample, &|_| true, &wide).is_empty() {
            said.push("with a wider range of contact angle there would be room".into());
            ends.push(Binding::ContactAngle);
        }
        if said.is_empty() {
            let parts: Vec<String> = parts.iter().map(ToString::to_string).collect();
            said.push(format!("{} together take it", parts.join(", ")));
        }
        (said.join("; "), ends)
    }

    /// The axes whose limits forbid an angle at a sample.
    fn axes_short(&self, sample: &Sample) -> Vec<Binding> {
        let options = self.scene.options;
        let short = |t: &&AxisTravel| t.forbidden(&sample.centre).next().is_some();
        let of_travel = options.travel.iter().filter(short).map(|t| Binding::Travel { axis: t.name.clone() });
        options.theta_limits_rad.map(|_| Binding::AxisLimit).into_iter().chain(of_travel).collect()
    }

    /// What ends the free intervals at a sample if the tool had only the parts that `keep` lets
    /// through; empty: nothing is free.
    fn free_with(
        &self,
        sample: &Sample,
        keep: &dyn Fn(ToolPart) -> bool,
        options: &super::options::ChannelOptions,
    ) -> Vec<Binding> {
        let mut scene = ObstacleScene { bodies: Vec::new(), options };
        for b in &self.scene.bodies {
            let profile = b.profile.only(|k| b.profile.parts.get(k).is_some_and(|p| keep(*p)));
            scene.bodies.push(ObstacleBody { profile, ..b.clone() });
        }
        let free = PlaceSearch::new(&scene).free(&sample.view(), &sample.normal, None);
        free.iter().flat_map(|f| [f.lo_by, f.hi_by]).map(|by| binding(by, &scene)).collect()
    }
}

/// A location of a path as a place; `to_model` takes a point of the blade frame to the model frame.
pub(super) fn at(path: &Toolpath, row: usize, to_model: impl Fn(Point) -> Point) -> At {
    let l = path.locations.get(row);
    let centre = l.map_or(Point::origin(), |l| l.centre);
    At {
        location: row,
        turn: l.map_or(0, |l| l.turn),
        turn_s_mm: l.map_or(0.0, |l| l.turn_s_mm),
        centre_mm: to_model(centre).into(),
        height_mm: centre.x,
    }
}

/// A binding with the name of its face; `None`: nothing binds.
pub(super) fn bound(b: &Binding, part: &Part) -> Option<Bound> {
    match b {
        Binding::Part { tool, face, .. } => {
            Some(Bound::Part { tool: tool.to_string(), face: part.face_name(*face).to_string() })
        }
        Binding::Fixture { name, tool, .. } => Some(Bound::Fixture { tool: tool.to_string(), name: name.clone() }),
        Binding::AxisLimit => Some(Bound::AxisLimit),
        Binding::Travel { axis } => Some(Bound::Travel { axis: axis.clone() }),
        Binding::ContactAngle => Some(Bound::ContactAngle),
        Binding::Free => None,
    }
}

/// What to do about limits of these kinds.
fn advice_for(ends: &[Binding]) -> String {
    let mut out: Vec<&str> = Vec::new();
    let mut add = |s: &'static str| {
        if !out.contains(&s) {
            out.push(s);
        }
    };
    for b in ends {
        match b {
            Binding::Part { tool, .. } | Binding::Fixture { tool, .. } if tool.is_holder() => {
                add("let the tool stick out farther or take a slimmer holder");
            }
            Binding::Part { tool: ToolPart::Cutter, .. } => add("let the cutter lean more, or take a narrower one"),
            Binding::Part { tool: ToolPart::Taper, .. } => add("take a slimmer taper or less clearance"),
            Binding::Fixture { .. } => add("move the fixture, or let it keep less clearance"),
            Binding::Part { .. } => add("take a slimmer or longer shank, or less clearance"),
            Binding::AxisLimit => {
                add("clamp the part turned by another angle, or take a machine whose table turns farther")
            }
            Binding::Travel { .. } => {
                add("move the blade on the machine (mount.offset_mm), or take a machine with more travel");
            }
            Binding::ContactAngle => add("widen the range of contact angle"),
            Binding::Free => {}
        }
    }
    add("`bladewright advise` looks whether another B, stick-out, holder or shank opens it");
    out.join("; ")
}
