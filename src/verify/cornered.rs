//! What is otherwise in the checks of a plan for a cutter with a corner: gouges, and what stays
//! between its passes.
//!
//! Locations have the disc's centre for that of a ball. Gouges are bounded over the motion, in
//! which θ turns ([`super::cutter`]); heights between passes are measured on the swept cutter
//! ([`super::cutter::ridges`]).

use super::audit::scallop::{Height, Heights};
use super::cutter::ridges::{self, Passes};
use super::cutter::{self, SweptCutter};
use super::gouge::{self, Gouge};
use super::options::VerifyOptions;
use super::sweep::Sweep;
use crate::artifact::report::{Check, Place};
use crate::artifact::{Blade, CheckId, CheckReport, Obstacle, Plan, Stand};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::geometry::near_disc::DiscSearch;
use crate::parallel;
use crate::tool::Tool;

/// Stands per unit of parallel work; fixed, so that the result does not depend on the number of
/// threads.
const CHUNK: usize = 128;

/// Locations of a plan as stands of its cutter.
fn stands(plan: &Plan) -> Vec<Stand> {
    (0..plan.toolpath.locations.len()).filter_map(|k| plan.stand(k)).collect()
}

/// Gouges of a way of the cutter.
pub(super) fn deepest(part: &Allowed, tool: &Tool, stands: &[Stand], resolution_mm: f64) -> Gouge {
    let wanted = vec![true; stands.len().saturating_sub(1)];
    cutter::measure_within(part, &SweptCutter { stands, wanted: &wanted, tool }, resolution_mm, 0.0)
}

/// The deepest cut of a way of the cutter into what stands about the part, but for the stock, as
/// [`gouge::in_obstacles`] has it of a ball.
pub(super) fn in_obstacles<'o>(
    obstacles: &'o [Obstacle],
    tool: &Tool,
    stands: &[Stand],
    resolution_mm: f64,
) -> Option<(&'o Obstacle, f64, Gouge)> {
    let one = |o: &'o Obstacle| {
        let part = Allowed::new(&o.part, 0.0);
        let mut g = deepest(&part, tool, stands, resolution_mm);
        if let Some(start) = stands.first().filter(|s| part.inside(&s.centre)) {
            let d = part.closest(&start.centre, f64::INFINITY).map_or(0.0, |c| c.distance_mm);
            let depth = tool.corner_mm() + d;
            g = Gouge { found_mm: depth, bound_mm: depth, segment: 0, centre: start.centre };
        }
        (o, g.bound_mm.max(g.found_mm) + o.part.deflection_mm, g)
    };
    let solid = obstacles.iter().filter(|o| !o.cut_by_the_tool);
    solid.map(one).reduce(|a, b| if b.1 > a.1 { b } else { a })
}

/// Heights between the passes of a plan, where passes are on both sides.
fn heights(plan: &Plan, part: &Allowed, tool: &Tool, options: &VerifyOptions) -> Heights {
    let (stands, samples) = (stands(plan), options.settings.surface_samples as usize);
    let turns: Vec<u32> = plan.toolpath.locations.iter().map(|l| l.turn).collect();
    let centres: Vec<Point> = stands.iter().map(|s| s.centre).collect();
    let sweep = Sweep::of(centres.clone(), centres, turns.clone(), tool.corner_mm(), None);
    let widest_mm = options.scallop_mm;
    let passes = Passes { part, tool, stands: &stands, turns: &turns, widest_mm, samples };
    ridges::heights(&passes, &sweep)
}

/// Heights as places of a report.
fn places(heights: &Heights) -> Vec<Place> {
    heights.sorted.iter().map(|h| Place { point: h.point, row: h.leg, height_mm: h.height_mm }).collect()
}

/// The places of heights between the passes of a plan.
pub(super) fn height_places(plan: &Plan, part: &Allowed, tool: &Tool, options: &VerifyOptions) -> Vec<Place> {
    places(&heights(plan, part, tool, options))
}

fn at(check: Check, row: usize, point: Option<Point>, plan: &Plan, blade: &Blade) -> Check {
    let point_mm = point.map(|p| (blade.model_from_blade * p).into());
    Check { row: Some(row), turn: plan.toolpath.locations.get(row).map(|l| l.turn), point_mm, ..check }
}

/// The checks `gouge` and `obstacle-gouge`.
pub(super) fn gouges(
    plan: &Plan,
    blade: &Blade,
    obstacles: &[Obstacle],
    tool: &Tool,
    options: &VerifyOptions,
) -> Vec<Check> {
    let (part, stands) = (Allowed::new(&blade.part, plan.toolpath.stock_mm), stands(plan));
    let resolution_mm = options.settings.resolution_mm;
    let mut g = deepest(&part, tool, &stands, resolution_mm);
    // As for balls: a way that begins outside and never comes near the surface is outside.
    let inside = stands.first().is_some_and(|s| part.inside(&s.centre));
    if let Some(start) = stands.first().filter(|_| inside) {
        let depth = tool.corner_mm() + part.closest(&start.centre, f64::INFINITY).map_or(0.0, |c| c.distance_mm);
        g = Gouge { found_mm: depth, bound_mm: depth, segment: 0, centre: start.centre };
    }
    let bound = g.bound_mm.max(g.found_mm).max(0.0);
    let face = gouge::where_it_is(&part, &g.centre, bound > options.settings.gouge_mm);
    let inside = if inside { "the path lies inside the part; " } else { "" };
    let stock = if part.stock_mm > 0.0 { format!("into {} mm of stock; ", part.stock_mm) } else { String::new() };
    let note = format!("{inside}{stock}measured {:.6}, nowhere deeper than {bound:.6}; {face}", g.found_mm.max(0.0));
    let quantity = "depth of the swept cutter in the part, between locations too";
    let check = Check::at_most(CheckId::Gouge, quantity, bound, options.settings.gouge_mm, "mm", note);
    let nearest = part.closest(&g.centre, f64::INFINITY).map(|c| c.point);
    let mut out = vec![at(check, g.segment, nearest, plan, blade)];
    if let Some((o, depth, g)) = in_obstacles(obstacles, tool, &stands, resolution_mm) {
        let note = format!("nearest is {}; {:.6} mm of that for its triangles", o.name, o.part.deflection_mm);
        let quantity = "depth of the swept cutter in other bodies, between locations too; negative: room";
        let check = Check::at_most(CheckId::ObstacleGouge, quantity, depth, 0.0, "mm", note);
        let nearest = o.part.closest(&g.centre, f64::INFINITY).map(|c| c.point);
        out.push(at(check, g.segment, nearest, plan, blade));
    }
    out
}

/// The check `other-blade`, as [`gouge::check_touches`] has it of a ball.
pub(super) fn touches(plan: &Plan, blade: &Blade, tool: &Tool, options: &VerifyOptions) -> Check {
    let (part, stands) = (Allowed::new(&blade.part, plan.toolpath.stock_mm), stands(plan));
    let off_mm = parallel::flat_map(stands.chunks(CHUNK), |chunk| {
        let mut search = DiscSearch::new(&part);
        let mut off = |s: &Stand| {
            let near = search.closest(&tool.disc(s.centre, s.axis()), f64::INFINITY, 0.1 * options.settings.gouge_mm);
            near.map_or(f64::INFINITY, |n| n.distance_mm - tool.corner_mm() - part.stock_mm)
        };
        chunk.iter().map(&mut off).collect::<Vec<f64>>()
    });
    let (row, worst) = off_mm.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or((0, 0.0), |(k, v)| (k, *v));
    let note = "plan a blade that differs by itself: --axis chooses it".to_owned();
    let quantity = "distance of the blade from the cutter where that touches the blade that was planned";
    let limit = options.settings.gouge_mm;
    let check = Check::at_most(CheckId::OtherBlade, quantity, worst.max(0.0), limit, "mm", note);
    at(check, row, stands.get(row).map(|s| s.centre), plan, blade)
}

/// The checks `gouge`, `obstacle-gouge`, `gouge-surface` and `scallop`; their figures go into
/// `report`.
pub(super) fn check(
    plan: &Plan,
    blade: &Blade,
    obstacles: &[Obstacle],
    tool: &Tool,
    options: &VerifyOptions,
    report: &mut CheckReport,
) {
    report.checks.extend(gouges(plan, blade, obstacles, tool, options));
    report.gouge_mm = report.checks.iter().find(|c| c.id == CheckId::Gouge).map_or(0.0, |c| c.worst);
    let part = Allowed::new(&blade.part, plan.toolpath.stock_mm);
    let heights = heights(plan, &part, tool, options);
    let of = |q: f64| heights.percentile(q);
    report.scallop_samples = heights.sorted.len();
    (report.scallop_max_mm, report.scallop_p99_mm) = (of(1.0), of(0.99));
    (report.scallop_p95_mm, report.scallop_p50_mm, report.scallop_p05_mm) = (of(0.95), of(0.5), of(0.05));
    report.scallop = places(&heights);
    let (p99, limit) = (of(0.99), options.settings.scallop_ratio * options.scallop_mm);
    let note = format!(
        "{} places, highest {:.6}, median {:.6}, lowest {:.6}; the place given is the highest",
        heights.sorted.len(),
        of(1.0),
        of(0.5),
        of(0.0)
    );
    let quantity = "99th percentile of the height left over the part between passes";
    let check = Check::at_most(CheckId::Scallop, quantity, p99, limit, "mm", note);
    let check = Check { passed: !heights.sorted.is_empty() && p99 <= limit, ..check };
    let place = |h: Option<&Height>| h.map_or((0, None), |h| (h.leg, Some(h.point)));
    let (row, point) = place(heights.sorted.last());
    report.checks.push(at(check, row, point, plan, blade));
    let deepest = heights.sorted.first().map_or(0.0, |h| (-h.height_mm).max(0.0));
    let quantity = "how deep samples of the surface lie in the swept cutter";
    let note = format!("{} samples", heights.sorted.len());
    let check = Check::at_most(CheckId::GougeSurface, quantity, deepest, options.settings.gouge_mm, "mm", note);
    let (row, point) = place(heights.sorted.first());
    report.checks.push(at(check, row, point, plan, blade));
}
