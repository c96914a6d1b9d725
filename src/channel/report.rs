//! Where and why there is no channel, in words.

use crate::artifact::channel::{Binding, ChannelRow};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Stage};

use super::arcs::Witness;
use super::forbidden::{Free, Scene, Search};
use super::samples::Sample;
use super::walls::{Crossing, binding};

/// What the messages need to know.
pub(super) struct Reporter<'a> {
    pub blade: &'a Blade,
    pub path: &'a Toolpath,
    pub scene: &'a Scene<'a>,
    pub samples: &'a [Sample],
}

impl Reporter<'_> {
    /// No chain reaches sample `at`.
    pub fn closed(&self, layers: &[Vec<Free>], at: usize) -> Error {
        let Some(sample) = self.samples.get(at) else {
            return Error::infeasible(Stage::Channel, "the channel is closed everywhere");
        };
        let place = self.place(sample.row);
        let here = layers.get(at).map(Vec::as_slice).unwrap_or_default();
        if here.is_empty() {
            let (what, advice) = self.everything_taken(sample);
            return Error::infeasible(Stage::Channel, format!("no angle of the tool axis is free at {place}: {what}"))
                .advise(advice)
                .region_may_end(self.above(sample.row));
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
        )
        .advise(advice_for(&ends))
        .region_may_end(self.above(sample.row))
    }

    /// The hulls cross.
    pub fn crossing(&self, rows: &[ChannelRow], crossing: Crossing) -> Error {
        let (Some(a), Some(b)) = (rows.get(crossing.low_row), rows.get(crossing.high_row)) else {
            return Error::infeasible(Stage::Channel, "no monotone schedule exists");
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
        )
        .advise(advice_for(&ends))
        .region_may_end(self.above(crossing.high_row))
    }

    /// The height at which the turn of this location begins, mm (of a helix that rises: ends): the turns above do without the
    /// location. `None` where fewer than two whole turns are left.
    fn above(&self, row: usize) -> Option<f64> {
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

    fn place(&self, row: usize) -> String {
        let Some(l) = self.path.locations.get(row) else { return format!("location {row}") };
        let p = self.blade.model_from_blade * l.centre;
        format!(
            "turn {}, S = {:.2} mm, ball centre ({:.3}, {:.3}, {:.3}) mm in the model, {:.3} mm along the blade axis",
            l.turn, l.turn_s_mm, p.x, p.y, p.z, l.centre.x
        )
    }

    fn blame(&self, b: &Binding) -> String {
        match b {
            Binding::Part { tool, face, triangle } => {
                let name = self.face_name(*face);
                let corners = self.scene.mesh.corners(*triangle as usize);
                let at = (corners[0].coords + corners[1].coords + corners[2].coords) / 3.0;
                format!("{tool} against {name}, {:.2} mm along the blade axis", at.x)
            }
            Binding::ContactAngle => "the permitted range of contact angle".into(),
            Binding::Free => "nothing".into(),
        }
    }

    fn face_name(&self, face: u32) -> String {
        let named = self.blade.part.brep.as_ref().and_then(|b| b.faces.get(face as usize));
        named.map_or_else(|| format!("face {face}"), |f| format!("face {face} ({})", f.name))
    }

    /// What takes the whole circle at a sample: the limits without which there would be free angles.
    fn everything_taken(&self, sample: &Sample) -> (String, String) {
        let mut said = Vec::new();
        let mut ends = Vec::new();
        let mut wide = self.scene.options.clone();
        (wide.contact_angle_min_rad, wide.contact_angle_max_rad) = (0.0, std::f64::consts::PI);
        for (k, name) in self.scene.profile.names.iter().enumerate() {
            let without = self.scene.profile.only(|i| i != k);
            if self.free_with(sample, without, self.scene.options).is_empty() {
                continue;
            }
            let only = self.scene.profile.only(|i| i == k);
            let by =
                self.free_with(sample, only, &wide).iter().flat_map(|f| [f.lo_by, f.hi_by]).find_map(|w| match w {
                    Witness::Tool { leaf, .. } => Some(self.scene.tree.triangle(leaf)),
                    _ => None,
                });
            let triangle = by.unwrap_or(0);
            let b = Binding::Part { tool: name.clone(), face: self.scene.mesh.face(triangle as usize), triangle };
            said.push(format!("without the {name} there would be room ({})", self.blame(&b)));
            ends.push(b);
        }
        if !self.free_with(sample, self.scene.profile.clone(), &wide).is_empty() {
            said.push("with a wider range of contact angle there would be room".into());
            ends.push(Binding::ContactAngle);
        }
        if said.is_empty() {
            said.push(format!("{} together take it", self.scene.profile.names.join(", ")));
        }
        (said.join("; "), advice_for(&ends))
    }

    fn free_with(
        &self,
        sample: &Sample,
        profile: super::profile::Profile,
        options: &super::options::ChannelOptions,
    ) -> Vec<Free> {
        let scene = Scene { mesh: self.scene.mesh, tree: self.scene.tree, profile, options };
        Search::new(&scene).free(&sample.centre, &sample.normal, sample.azimuth)
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
            Binding::Part { tool, .. } if tool.starts_with("holder") => {
                add("let the tool stick out farther or take a slimmer holder");
            }
            Binding::Part { tool, .. } if tool == "taper" => add("take a slimmer taper or less clearance"),
            Binding::Part { .. } => add("take a slimmer or longer shank, or less clearance"),
            Binding::ContactAngle => add("widen the range of contact angle"),
            Binding::Free => {}
        }
    }
    add("try another B or a smaller ball radius");
    out.join("; ")
}
