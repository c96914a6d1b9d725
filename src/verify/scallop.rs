//! Scallop: what is left standing over the part between neighbouring turns, measured on the swept ball itself.
//!
//! * **Heights at points of the surface**: from each sample `p` with normal `n` the ray `p + t n` enters the swept ball at
//!   `t`: material left where `t > 0`, a gouge where `t < 0`. The machined band are the samples whose ball centre
//!   `p + R n` lies nearer to an inner turn than to the first or last one, and near the path at all; next to where the
//!   inner turns begin and end one neighbour is missing, so these places do not count.
//!   Where a ball in that place would cut into the part elsewhere (inner corners, edges between facets that form a
//!   valley) no ball of this radius can reach `p`: what it must be lifted by is uncut for good, whatever the stepover,
//!   and taken off the height; gouges are judged on heights as measured.
//! * **Ridges**: two neighbouring passes with centres `c1`, `c2`, `d` apart, meet in a circle of radius
//!   `sqrt(R² − d²/4)` about their middle, across `c2 − c1`. The ridge left between them is the circle's point nearest to
//!   the part; its distance from the part is the cusp's height.

use rayon::prelude::*;

use super::options::VerifyOptions;
use super::samples;
use super::sweep::Sweep;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckReport, Plan};
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};

/// Ridges are measured at most at so many places.
const MOST_RIDGES: usize = 6000;

/// A height and where it was measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Height {
    /// Height over the part, mm.
    pub height_mm: f64,
    /// Point of the part under it.
    pub point: Point,
    /// Row of the path.
    pub row: usize,
}

/// Percentile `q` (0 to 1) of sorted heights, interpolated linearly; 0 of none.
pub(super) fn percentile(sorted: &[Height], q: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
    let at = q * last as f64;
    let (lo, hi) = (sorted[at.floor() as usize].height_mm, sorted[(at.ceil() as usize).min(last)].height_mm);
    lo + (hi - lo) * at.fract()
}

fn sort(mut heights: Vec<Height>) -> Vec<Height> {
    heights.sort_by(|a, b| a.height_mm.total_cmp(&b.height_mm).then(a.row.cmp(&b.row)));
    heights
}

/// Stepover on a plane, the scale of all reaches here, mm.
fn flat_stepover(radius: f64, scallop: f64) -> f64 {
    (8.0 * radius * scallop).sqrt()
}

/// How far a ball that touches the part at `p` must be lifted along `n` until it cuts in nowhere by more than `slack_mm`:
/// 0 where it may touch. What it leaves under itself then, mm, is no fault of the stepover.
fn lift(part: &Part, p: &Point, n: &Vector, radius_mm: f64, slack_mm: f64) -> f64 {
    let mut up = 0.0;
    // A distance changes no faster than its point moves, so each step is safe; in a corner the steps grow geometrically few.
    for _ in 0..60 {
        match part.closest(&(p + n * (radius_mm + up)), radius_mm - slack_mm) {
            Some(c) if up < radius_mm => up += radius_mm - c.distance_mm,
            _ => break,
        }
    }
    up
}

/// How much a ball may cut in elsewhere and still count as touching, as a share of the scallop: rounding and exactness of
/// the distance only.
const REACH_SLACK: f64 = 0.02;
/// A place counts as uncut where the ball must be lifted by this share of the scallop.
const UNCUT: f64 = 0.5;

/// What was measured over the machined band.
pub(super) struct Band {
    /// Heights less what a ball must be lifted by at each place, sorted.
    pub heights: Vec<Height>,
    /// The lowest height as measured: the deepest gouge.
    pub lowest: Option<Height>,
    /// Samples that no ball of this radius can reach.
    pub uncut: usize,
}

/// Rows of the turns that have neighbours on both sides; where a turn follows on the first one, or runs into the last, the
/// neighbour is missing for as far as a pass reaches. All rows where there are fewer than three turns.
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

/// Heights at samples of the machined band.
pub(super) fn heights(part: &Part, sweep: &Sweep, scallop_mm: f64, count: usize) -> Band {
    // As far as a neighbouring pass may be: two and a half stepovers, so that a scallop six times too high is seen.
    let reach = (2.5 * flat_stepover(sweep.radius_mm, scallop_mm)).max(0.4);
    let inner = inner_rows(sweep, reach);
    let height = |s: samples::Sample| {
        let near = sweep.nearest(&(s.point + s.normal * sweep.radius_mm), reach, |_| true)?;
        let row = near.segment + usize::from(near.t > 0.5);
        if !inner.contains(&row) {
            return None;
        }
        let height_mm = sweep.entry(&s.point, &s.normal, reach)?;
        let up = lift(part, &s.point, &s.normal, sweep.radius_mm, REACH_SLACK * scallop_mm);
        Some((Height { height_mm, point: s.point, row }, up))
    };
    let all = samples::near_path(part, sweep, reach, count);
    let measured: Vec<(Height, f64)> = all.into_par_iter().filter_map(height).collect();
    let uncut = measured.iter().filter(|(_, up)| *up > UNCUT * scallop_mm).count();
    let lowest = sort(measured.iter().map(|(h, _)| *h).collect()).first().copied();
    let judged = |(h, up): &(Height, f64)| Height { height_mm: h.height_mm.min((h.height_mm - up).max(0.0)), ..*h };
    Band { heights: sort(measured.iter().map(judged).collect()), lowest, uncut }
}

/// Ridges between each turn and the next, sorted.
pub(super) fn ridges(part: &Part, sweep: &Sweep, scallop_mm: f64) -> Vec<Height> {
    let n = sweep.centres.len();
    let every = n.div_ceil(MOST_RIDGES);
    let rows: Vec<usize> = (0..n).step_by(every).collect();
    sort(rows.into_par_iter().filter_map(|row| ridge_at(part, sweep, row, REACH_SLACK * scallop_mm)).collect())
}

fn ridge_at(part: &Part, sweep: &Sweep, row: usize, slack_mm: f64) -> Option<Height> {
    let (radius, turn) = (sweep.radius_mm, sweep.turns[row]);
    let c1 = sweep.centres[row];
    let next = sweep.nearest(&c1, 1.9 * radius, |i| sweep.turns[i] == turn + 1 && sweep.turns[i + 1] == turn + 1)?;
    let (i, d) = (next.segment, next.distance_mm);
    // An end of the next turn is not its nearest pass.
    let at_start = next.t == 0.0 && sweep.turns.get(i.wrapping_sub(1)) != Some(&(turn + 1));
    let at_end = next.t == 1.0 && sweep.turns.get(i + 2) != Some(&(turn + 1));
    if at_start || at_end || d < 1e-3 {
        return None;
    }
    let middle = c1 + (next.centre - c1) * 0.5;
    let e = (next.centre - c1) / d;
    let foot = part.closest(&middle, 2.0 * radius)?.point;
    let g = (middle - foot) - e * (middle - foot).dot(&e);
    let g = g.try_normalize(1e-9)?;
    let side = e.cross(&g);
    let circle = (radius * radius - 0.25 * d * d).sqrt();
    let point = |angle: f64| middle - (g * angle.cos() + side * angle.sin()) * circle;
    let (height_mm, point) = lowest(part, point, radius)?;
    let under = part.closest(&point, radius)?;
    // A ridge over a corner that no ball can reach is not one of the stepover's.
    let up = lift(part, &under.point, &under.normal, radius, slack_mm);
    (up == 0.0).then_some(Height { height_mm, point, row })
}

/// Lowest height of the points of a short arc about angle 0 over the part: three heights, a parabola through them.
fn lowest(part: &Part, point: impl Fn(f64) -> Point, radius: f64) -> Option<(f64, Point)> {
    const WIDTH: f64 = 0.02;
    let height = |angle: f64| {
        let q = point(angle);
        part.closest(&q, radius).map(|c| signed(&(q - c.point), &c.normal, c.distance_mm)).map(|h| (h, q))
    };
    let (lo, at, hi) = (height(-WIDTH)?.0, height(0.0)?.0, height(WIDTH)?.0);
    let bend = lo - 2.0 * at + hi;
    let best = if bend > 1e-9 { (0.5 * (lo - hi) / bend).clamp(-2.0, 2.0) * WIDTH } else { 0.0 };
    height(best)
}

fn signed(from_foot: &Vector, normal: &Vector, distance: f64) -> f64 {
    if from_foot.dot(normal) < 0.0 { -distance } else { distance }
}

/// Measures and judges the scallop; the percentiles go into `report`.
pub(super) fn check(plan: &Plan, blade: &Blade, sweep: &Sweep, options: &VerifyOptions, report: &mut CheckReport) {
    let Band { heights: samples, lowest, uncut } =
        heights(&blade.part, sweep, options.scallop_mm, options.surface_samples);
    let ridges = ridges(&blade.part, sweep, options.scallop_mm);
    report.uncut_samples = uncut;
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
    let limit = options.scallop_ratio * options.scallop_mm;
    let judge = |name: &str, quantity: &str, sorted: &[Height], enough: bool| {
        let p99 = percentile(sorted, 0.99);
        let at = sorted.last();
        let point = at.map(|h| blade.model_from_blade * h.point);
        Check {
            name: name.into(),
            quantity: quantity.into(),
            worst: p99,
            limit,
            unit: "mm".into(),
            passed: enough && p99 <= limit,
            row: at.map(|h| h.row),
            turn: at.map(|h| plan.toolpath.locations[h.row].turn),
            point_mm: point.map(|p| [p.x, p.y, p.z]),
            note: format!(
                "{} places, highest {:.6}, median {:.6}, lowest {:.6}; the place given is the highest; {uncut} samples of the surface lie where no ball of this radius reaches; heights are over what such a ball leaves",
                sorted.len(),
                percentile(sorted, 1.0),
                percentile(sorted, 0.5),
                percentile(sorted, 0.0)
            ),
        }
    };
    let quantity = "99th percentile of the height left over the part in the machined band";
    report.checks.push(judge("scallop", quantity, &samples, !samples.is_empty()));
    let quantity = "99th percentile of the ridges between neighbouring turns";
    // On a mesh the edges between facets bend each ridge by more than the scallop; the samples above judge there.
    if blade.part.brep.is_some() {
        report.checks.push(judge("ridge", quantity, &ridges, true));
    }
    report.checks.push(ray_gouge(blade, sweep, lowest, samples.len(), options));
}

/// The deepest place of the same samples: a second look at gouges, from the part's side.
fn ray_gouge(blade: &Blade, sweep: &Sweep, deepest: Option<Height>, samples: usize, options: &VerifyOptions) -> Check {
    let depth = deepest.map_or(0.0, |h| (-h.height_mm).max(0.0));
    let point = deepest.map(|h| blade.model_from_blade * h.point);
    Check {
        name: "gouge-surface".into(),
        quantity: "depth of the swept ball under samples of the surface".into(),
        worst: depth,
        limit: options.gouge_mm,
        unit: "mm".into(),
        passed: depth <= options.gouge_mm,
        row: deepest.map(|h| h.row),
        turn: deepest.and_then(|h| sweep.turns.get(h.row)).copied(),
        point_mm: point.map(|p| [p.x, p.y, p.z]),
        note: format!("{samples} samples"),
    }
}
