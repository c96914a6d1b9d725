//! What stays between the passes of a plan for a cutter with a corner, measured on the swept cutter
//! ([`super::cutter::ridges`]).

use super::between::{Height, Heights};
use super::cutter::ridges::{self, Passes};
use super::options::VerifyOptions;
use super::sweep::Sweep;
use crate::artifact::report::{Check, Place};
use crate::artifact::{Blade, CheckId, CheckReport, Plan, Stand};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::tool::Tool;

/// Where the cutter stands at the locations of a plan, and its way.
pub(super) struct Stands<'a> {
    pub tool: &'a Tool,
    pub stands: &'a [Stand],
    pub sweep: &'a Sweep,
}

/// Heights between the passes, where passes are on both sides.
fn heights(part: &Allowed, of: &Stands, options: &VerifyOptions) -> Heights {
    let (widest_mm, samples) = (options.scallop_mm, options.settings.surface_samples as usize);
    let (tool, stands, turns) = (of.tool, of.stands, &of.sweep.turns[..]);
    ridges::heights(&Passes { part, tool, stands, turns, is_helix: true, widest_mm, samples }, of.sweep)
}

/// Heights between the passes as places of a report.
pub(super) fn places(part: &Allowed, of: &Stands, options: &VerifyOptions) -> Vec<Place> {
    to_places(&heights(part, of, options))
}

fn to_places(heights: &Heights) -> Vec<Place> {
    heights.sorted.iter().map(|h| Place { point: h.point, row: h.leg, height_mm: h.height_mm }).collect()
}

/// The checks `scallop` and `gouge-surface`; their figures go into `report`.
pub(super) fn check(
    plan: &Plan,
    blade: &Blade,
    part: &Allowed,
    of: &Stands,
    options: &VerifyOptions,
    report: &mut CheckReport,
) {
    let heights = heights(part, of, options);
    let at = |check: Check, h: Option<&Height>| {
        let (row, point) = h.map_or((0, None), |h| (h.leg, Some(h.point)));
        let point_mm = point.map(|p: Point| (blade.model_from_blade * p).into());
        Check { row: Some(row), turn: plan.toolpath.locations.get(row).map(|l| l.turn), point_mm, ..check }
    };
    let share = |q: f64| heights.percentile(q);
    report.scallop_samples = heights.sorted.len();
    (report.scallop_max_mm, report.scallop_p99_mm) = (share(1.0), share(0.99));
    (report.scallop_p95_mm, report.scallop_p50_mm, report.scallop_p05_mm) = (share(0.95), share(0.5), share(0.05));
    report.scallop = to_places(&heights);
    let (p99, limit) = (share(0.99), options.settings.scallop_ratio * options.scallop_mm);
    let note = format!(
        "{} places, highest {:.6}, median {:.6}, lowest {:.6}; the place given is the highest",
        heights.sorted.len(),
        share(1.0),
        share(0.5),
        share(0.0)
    );
    let quantity = "99th percentile of the height left over the part between passes";
    let check = Check::at_most(CheckId::Scallop, quantity, p99, limit, "mm", note);
    let check = Check { passed: !heights.sorted.is_empty() && p99 <= limit, ..check };
    report.checks.push(at(check, heights.sorted.last()));
    let deepest = heights.sorted.first().map_or(0.0, |h| (-h.height_mm).max(0.0));
    let quantity = "how deep samples of the surface lie in the swept cutter";
    let note = format!("{} samples", heights.sorted.len());
    let check = Check::at_most(CheckId::GougeSurface, quantity, deepest, options.settings.gouge_mm, "mm", note);
    report.checks.push(at(check, heights.sorted.first()));
}
