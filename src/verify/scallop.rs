//! Scallop: what is left standing over the part between neighbouring turns, measured on the swept
//! ball itself.
//!
//! * **Heights at points of the surface**: from each sample `p` with normal `n` the ray `p + t n`
//!   enters the swept ball at `t`: material left where `t > 0`, a gouge where `t < 0`. The machined
//!   band are the samples whose ball centre `p + R n` lies nearer to an inner turn than to the
//!   first or last one, and near the path at all; next to where the inner turns begin and end one
//!   neighbour is missing, so these places do not count; nor do those where inner turns run along
//!   the first or last one. Where a ball in that place would cut into the part elsewhere (inner
//!   corners, edges between facets that form a valley) no ball of this radius can reach `p`: what
//!   it must be lifted by is uncut for good, whatever the stepover, and taken off the height;
//!   gouges are judged on heights as measured.
//! * **Ridges** ([`super::ridge`]), each counting by the area that it stands on.

use super::height::{Height, REACH_SLACK, UNCUT, flat_stepover, lift, percentile, sort};
use super::limit;
use super::options::VerifyOptions;
use super::ridge;
use super::samples;
use super::sweep::Sweep;
use super::uncut;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, CheckReport, Plan};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::observe::Doubt;
use crate::parallel;

/// What was measured over the machined band.
pub(super) struct Band {
    /// Heights less what a ball must be lifted by at each place, sorted.
    pub heights: Vec<Height>,
    /// The lowest height as measured: the deepest gouge.
    pub lowest: Option<Height>,
    /// Samples that no ball of this radius can reach.
    pub uncut: usize,
}

/// Rows of the turns that have neighbours on both sides; where a turn follows on the first one, or
/// runs into the last, the neighbour is missing for as far as a pass reaches. All rows where there
/// are fewer than three turns.
fn inner_rows(sweep: &Sweep, reach: f64) -> std::ops::Range<usize> {
    let (turns, centres) = (&sweep.turns, &sweep.centres);
    let (first, last) = (turns.first().copied().unwrap_or(0), turns.last().copied().unwrap_or(0));
    if last < first + 2 {
        return 0..turns.len();
    }
    let walk = |from: usize, rows: &mut dyn Iterator<Item = usize>| {
        let (mut at, mut way) = (from, 0.0);
        for row in rows.take_while(|row| *row < turns.len()) {
            way += (centres[row] - centres[at]).norm();
            at = row;
            if way >= reach {
                break;
            }
        }
        at
    };
    let begin = turns.partition_point(|t| *t <= first);
    let end = turns.partition_point(|t| *t < last);
    walk(begin, &mut (begin + 1..)).min(end)..walk(end, &mut (0..end).rev()).max(begin)
}

/// Turns nearer to the first or last one than this share of the flat stepover run along the end of
/// the region there.
const AT_END: f64 = 0.02;

/// The path runs along the first or the last turn at this row, so that one of its sides is not
/// machined.
fn runs_along_end(sweep: &Sweep, row: usize, within_mm: f64) -> bool {
    let turns = &sweep.turns;
    let (Some(first), Some(last)) = (turns.first(), turns.last()) else { return false };
    let ends = |i: usize| i + 1 < turns.len() && [first, last].iter().any(|e| turns[i] == **e && turns[i + 1] == **e);
    sweep.nearest(&sweep.centres[row], within_mm, |i| turns[row] != turns[i] && ends(i)).is_some()
}

/// Heights at samples of the machined band.
pub(super) fn heights(part: &Allowed, sweep: &Sweep, scallop_mm: f64, count: usize) -> Band {
    // As far as a neighbouring pass may be: two and a half stepovers, so that a scallop six times
    // too high is seen.
    let reach = (2.5 * flat_stepover(sweep.radius_mm, scallop_mm)).max(0.4);
    let inner = inner_rows(sweep, reach);
    let height = |s: samples::Sample| {
        let near = sweep.nearest(&(s.point + s.normal * sweep.radius_mm), reach, |_| true)?;
        let row = near.segment + usize::from(near.t > 0.5);
        if !inner.contains(&row) || runs_along_end(sweep, row, AT_END * flat_stepover(sweep.radius_mm, scallop_mm)) {
            return None;
        }
        let height_mm = sweep.entry(&s.point, &s.normal, reach)?;
        let up = lift(part, &s.point, &s.normal, sweep.radius_mm, REACH_SLACK * scallop_mm);
        Some((Height { height_mm, point: s.point, row, weight: 1.0 }, up))
    };
    let all = samples::near_path(part, sweep, reach, count);
    let measured: Vec<(Height, f64)> = parallel::filter_map(all.points, height);
    let uncut = measured.iter().filter(|(_, up)| *up > UNCUT * scallop_mm).count();
    let lowest = sort(measured.iter().map(|(h, _)| *h).collect()).first().copied();
    let judged = |(h, up): &(Height, f64)| Height { height_mm: h.height_mm.min((h.height_mm - up).max(0.0)), ..*h };
    Band { heights: sort(measured.iter().map(judged).collect()), lowest, uncut }
}

/// Heights and ridges; their places and the uncut ones go into `report`.
pub(super) fn measure(
    part: &Allowed,
    sweep: &Sweep,
    options: &VerifyOptions,
    report: &mut CheckReport,
) -> (Band, Vec<Height>) {
    let band = heights(part, sweep, options.scallop_mm, options.settings.surface_samples as usize);
    let ridges = ridge::all(part, sweep, options.scallop_mm, false);
    let places = |sorted: &[Height]| sorted.iter().map(Height::place).collect();
    (report.scallop, report.ridges) = (places(&band.heights), places(&ridges));
    (report.uncut, report.uncut_cell_mm2) =
        uncut::measure(part, sweep, options.scallop_mm, options.settings.surface_samples as usize / 2);
    (band, ridges)
}

/// Measures and judges the scallop; the percentiles go into `report`. Returns what there is to
/// doubt of it.
pub(super) fn check(
    plan: &Plan,
    blade: &Blade,
    part: &Allowed,
    sweep: &Sweep,
    options: &VerifyOptions,
    report: &mut CheckReport,
) -> Option<Doubt> {
    let (Band { heights: samples, lowest, uncut: unreached }, ridges) = measure(part, sweep, options, report);
    report.uncut_samples = unreached;
    report.uncut_area_mm2 = report.uncut.len() as f64 * report.uncut_cell_mm2;
    report.uncut_height_mm = report.uncut.iter().map(|p| p.left_mm).fold(0.0, f64::max);
    report.scallop_samples = samples.len();
    report.scallop_max_mm = percentile(&samples, 1.0);
    report.scallop_p99_mm = percentile(&samples, 0.99);
    report.scallop_p95_mm = percentile(&samples, 0.95);
    report.scallop_p50_mm = percentile(&samples, 0.50);
    report.scallop_p05_mm = percentile(&samples, 0.05);
    report.ridge_max_mm = percentile(&ridges, 1.0);
    report.ridge_p99_mm = percentile(&ridges, 0.99);
    report.ridge_p50_mm = percentile(&ridges, 0.50);
    report.ridge_p05_mm = percentile(&ridges, 0.05);
    report.limit = limit::measure(part, sweep, options.scallop_mm, options.settings.surface_samples as usize);
    let doubt = standing_out(plan, blade, &samples, options);
    let limit = options.settings.scallop_ratio * options.scallop_mm;
    let judge = |id: CheckId, quantity: &str, sorted: &[Height], enough: bool| {
        let p99 = percentile(sorted, 0.99);
        let at = sorted.last();
        let point = at.map(|h| blade.model_from_blade * h.point);
        Check {
            id,
            quantity: quantity.into(),
            worst: p99,
            limit,
            unit: "mm".into(),
            passed: enough && p99 <= limit,
            row: at.map(|h| h.row),
            turn: at.map(|h| plan.toolpath.locations[h.row].turn),
            point_mm: point.map(|p| [p.x, p.y, p.z]),
            note: format!(
                "{} places, highest {:.6}, median {:.6}, lowest {:.6}; the place given is the highest; {unreached} samples of the surface lie where no ball of this radius reaches; heights are over what such a ball leaves",
                sorted.len(),
                percentile(sorted, 1.0),
                percentile(sorted, 0.5),
                percentile(sorted, 0.0)
            ),
        }
    };
    let quantity = "99th percentile of the height left over the part in the machined band";
    report.checks.push(judge(CheckId::Scallop, quantity, &samples, !samples.is_empty()));
    let quantity = "99th percentile of the ridges between neighbouring turns";
    // On a mesh the edges between facets bend each ridge by more than the scallop; the samples
    // above judge there.
    if blade.part.brep.is_some() {
        report.checks.push(judge(CheckId::Ridge, quantity, &ridges, true));
    }
    let published = published_depths(part, sweep);
    report.checks.push(ray_gouge(blade, sweep, lowest, samples.len(), &published, options));
    doubt
}

/// Places on edges that sewing or healing moved are this far apart, mm, at most.
const PUBLISHED_STEP_MM: f64 = 0.05;

/// How deep places along the edges of surface that the part has otherwise than its file lie in the
/// swept ball: there it stands out the most.
fn published_depths(part: &Allowed, sweep: &Sweep) -> Vec<Height> {
    let Some(published) = part.published().filter(|_| part.stock_mm == 0.0) else { return Vec::new() };
    let depth = |point: Point| {
        let near = sweep.nearest(&point, sweep.radius_mm, |_| true)?;
        let row = near.segment + usize::from(near.t > 0.5);
        Some(Height { height_mm: near.distance_mm - sweep.radius_mm, point, row, weight: 1.0 })
    };
    sort(parallel::filter_map(published.along_edges(PUBLISHED_STEP_MM), depth))
}

/// From so many times the scallop on, or the ratio that is allowed if that is more, single places
/// are reported: the verdict rests on the 99th percentile.
const STANDS_OUT: f64 = 1.5;

/// How much of the surface stands out and where the most; `None` where nothing does.
fn standing_out(plan: &Plan, blade: &Blade, sorted: &[Height], options: &VerifyOptions) -> Option<Doubt> {
    let ratio = STANDS_OUT.max(options.settings.scallop_ratio);
    let over = sorted.len() - sorted.partition_point(|h| h.height_mm <= ratio * options.scallop_mm);
    let highest = sorted.last().filter(|_| over > 0)?;
    let p = blade.model_from_blade * highest.point;
    Some(Doubt::StandsOut {
        share: over as f64 / sorted.len() as f64,
        ratio,
        height_mm: highest.height_mm,
        turn: plan.toolpath.locations[highest.row].turn,
        at_mm: p.into(),
    })
}

/// The deepest place of the same samples: a second look at gouges, from the part's side.
fn ray_gouge(
    blade: &Blade,
    sweep: &Sweep,
    deepest: Option<Height>,
    samples: usize,
    published: &[Height],
    options: &VerifyOptions,
) -> Check {
    let deepest =
        [deepest, published.first().copied()].into_iter().flatten().min_by(|a, b| a.height_mm.total_cmp(&b.height_mm));
    let besides = match published.len() {
        0 => String::new(),
        n => format!(", and {n} on edges as the file has them, which sewing or healing moved"),
    };
    let depth = deepest.map_or(0.0, |h| (-h.height_mm).max(0.0));
    let point = deepest.map(|h| blade.model_from_blade * h.point);
    let (quantity, note) =
        ("how deep samples of the surface lie in the swept ball", format!("{samples} samples{besides}"));
    Check {
        row: deepest.map(|h| h.row),
        turn: deepest.and_then(|h| sweep.turns.get(h.row)).copied(),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        ..Check::at_most(CheckId::GougeSurface, quantity, depth, options.settings.gouge_mm, "mm", note)
    }
}
