//! What the end of a tool cuts on its way: a ball, or a cutter with a corner.
//!
//! How deep is measured by [`super::gouge`] for balls and by [`super::cutter`] for cutters with a
//! corner, whose locations have the disc's centre for that of a ball and whose θ turns between
//! them; both bound what lies between locations.

use super::cutter::{self, SweptCutter};
use super::gouge::{self, Gouge};
use super::options::VerifyOptions;
use super::sweep::Sweep;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Obstacle, Stand};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::parallel;
use crate::tool::Tool;

/// The way of a tool's end.
#[derive(Clone, Copy)]
pub(super) struct EndWay<'a> {
    /// The ball; of a cutter with a corner, balls as large as that about the disc's centres.
    sweep: &'a Sweep,
    /// The cutter with its stands, where it is no ball.
    cutter: Option<(&'a Tool, &'a [Stand])>,
}

impl<'a> EndWay<'a> {
    /// Of a ball.
    pub fn of_ball(sweep: &'a Sweep) -> Self {
        EndWay { sweep, cutter: None }
    }

    /// Of the end that a tool has, whose centres are those of the stands.
    pub fn new(tool: &'a Tool, sweep: &'a Sweep, stands: &'a [Stand]) -> Self {
        EndWay { sweep, cutter: (!tool.is_ball()).then_some((tool, stands)) }
    }

    fn name(&self) -> &'static str {
        if self.cutter.is_none() { "ball" } else { "cutter" }
    }

    fn turn(&self, row: usize) -> Option<u32> {
        self.sweep.turns.get(row).copied()
    }

    /// Its deepest cut into a body, measured to `resolution_mm`.
    pub fn deepest(&self, part: &Allowed, resolution_mm: f64) -> Gouge {
        match self.cutter {
            None => gouge::measure(part, self.sweep, resolution_mm),
            Some((tool, stands)) => {
                let wanted = vec![true; stands.len().saturating_sub(1)];
                cutter::measure_within(part, &SweptCutter { stands, wanted: &wanted, tool }, resolution_mm, 0.0)
            }
        }
    }

    /// The cut of a way that begins inside a body: as deep as its beginning lies in there. A way is
    /// connected: if it begins outside and never comes near the surface, all of it is outside.
    fn begins_inside(&self, part: &Allowed) -> Option<Gouge> {
        let start = *self.sweep.centres.first().filter(|start| part.inside(start))?;
        let depth = self.sweep.radius_mm + part.closest(&start, f64::INFINITY).map_or(0.0, |c| c.distance_mm);
        Some(Gouge { found_mm: depth, bound_mm: depth, segment: 0, centre: start })
    }

    /// How far a body is off it at each location, mm, to `tolerance_mm`.
    fn off_mm(&self, part: &Allowed, tolerance_mm: f64) -> Vec<f64> {
        let radius_mm = self.sweep.radius_mm;
        let off = |c: &Point| part.closest(c, f64::INFINITY).map_or(f64::INFINITY, |p| p.distance_mm - radius_mm);
        match self.cutter {
            None => parallel::map(&self.sweep.centres, off),
            Some((tool, stands)) => cutter::off_mm(part, stands, tool, tolerance_mm),
        }
    }
}

/// The check `gouge`.
pub(super) fn check(blade: &Blade, part: &Allowed, way: &EndWay, options: &VerifyOptions) -> Check {
    // Openings near the path are refused before planning, so the nearest surface gives the side of
    // an open part too.
    let inside = way.begins_inside(part);
    let g = inside.unwrap_or_else(|| way.deepest(part, options.settings.resolution_mm));
    let at = part.closest(&g.centre, f64::INFINITY);
    let point = at.map(|c| blade.model_from_blade * c.point);
    let bound = g.bound_mm.max(g.found_mm).max(0.0);
    let face = gouge::where_it_is(part, &g.centre, bound > options.settings.gouge_mm);
    let inside = if inside.is_some() { "the path lies inside the part; " } else { "" };
    let stock = if part.stock_mm > 0.0 { format!("into {} mm of stock; ", part.stock_mm) } else { String::new() };
    let note = format!("{inside}{stock}measured {:.6}, nowhere deeper than {bound:.6}; {face}", g.found_mm.max(0.0));
    let quantity = format!("depth of the swept {} in the part, between locations too", way.name());
    Check {
        row: Some(g.segment),
        turn: way.turn(g.segment),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(CheckId::Gouge, &quantity, bound, options.settings.gouge_mm, "mm", note)
    }
}

/// The deepest cut into what stands about the part, but for the stock: the body, how deep at most,
/// mm, with what its triangles lie off it, and where. Negative: room. `None` where nothing stands
/// there.
pub(super) fn in_obstacles<'o>(
    obstacles: &'o [Obstacle],
    way: &EndWay,
    resolution_mm: f64,
) -> Option<(&'o Obstacle, f64, Gouge)> {
    let one = |o: &'o Obstacle| {
        let part = Allowed::new(&o.part, 0.0);
        let g = way.begins_inside(&part).unwrap_or_else(|| way.deepest(&part, resolution_mm));
        (o, g.bound_mm.max(g.found_mm) + o.part.deflection_mm, g)
    };
    let solid = obstacles.iter().filter(|o| !o.cut_by_the_tool);
    solid.map(one).reduce(|a, b| if b.1 > a.1 { b } else { a })
}

/// The check `other-blade`: how far a part is off the tool's end at the cutter locations, where
/// that should touch it.
pub(super) fn check_touches(blade: &Blade, part: &Allowed, way: &EndWay, options: &VerifyOptions) -> Check {
    let off_mm = way.off_mm(part, 0.1 * options.settings.gouge_mm);
    let (row, worst) = off_mm.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or((0, 0.0), |(k, v)| (k, *v));
    let note = "plan a blade that differs by itself: --axis chooses it".to_owned();
    let quantity =
        format!("distance of the blade from the {} where that touches the blade that was planned", way.name());
    let point = way.sweep.centres.get(row).map(|c| blade.model_from_blade * c);
    Check {
        row: Some(row),
        turn: way.turn(row),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(CheckId::OtherBlade, &quantity, worst.max(0.0), options.settings.gouge_mm, "mm", note)
    }
}

/// The check `obstacle-gouge`: the tool's end in what stands about the part; `None` where nothing
/// does.
pub(super) fn check_obstacles(
    blade: &Blade,
    obstacles: &[Obstacle],
    way: &EndWay,
    options: &VerifyOptions,
) -> Option<Check> {
    let (o, depth, g) = in_obstacles(obstacles, way, options.settings.resolution_mm)?;
    let point = o.part.closest(&g.centre, f64::INFINITY).map(|c| blade.model_from_blade * c.point);
    let note = format!("nearest is {}; {:.6} mm of that for its triangles", o.name, o.part.deflection_mm);
    let quantity = format!("depth of the swept {} in other bodies, between locations too; negative: room", way.name());
    Some(Check {
        row: Some(g.segment),
        turn: way.turn(g.segment),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(CheckId::ObstacleGouge, &quantity, depth, 0.0, "mm", note)
    })
}
