//! What a program leaves standing between its passes.
//!
//! At samples of the surface, the height at which the normal meets the swept ball, as in
//! [`super::super::scallop`]. Nothing is known of how the passes lie, so a sample counts where it
//! lies *between* passes: the places of the swept centres nearest to its ball centre are on both
//! sides of it. The strip beyond the outermost passes has one on one side only. Places beside the
//! beginning or the end of a pass do not count either: there the ball comes down or goes up, and
//! beyond is nothing to be cut.
//!
//! One turn that is too wide may be a small share of the part, so the height is judged turn by turn
//! too.

use super::AuditScene;
use super::line_check::{LineCheck, LineLimit};
use crate::artifact::CheckId;
use crate::geometry::allowance::Allowed;
use crate::parallel;
use crate::verify::between::{Height, Heights, LEAST_REACH_MM, NEAR_MM, REACH_STEPOVERS, between, percentile, sorted};
use crate::verify::cutter::ridges::{self, Passes};
use crate::verify::height::{REACH_SLACK, lift};
use crate::verify::samples::{self, Sample};
use crate::verify::sweep::Sweep;

/// Turns with fewer samples are not judged by themselves.
const FEWEST: usize = 40;
/// Passes this many times as far apart as usual: one is missing between them.
const MISSING: f64 = 1.6;
/// Where no scallop is asked for, the greatest that is looked for, as a share of
/// the radius of ball or corner.
pub(in crate::verify) const WIDEST: f64 = 0.02;

/// The scallop that reaches are measured by, mm.
pub(super) fn widest_mm(scene: &AuditScene) -> f64 {
    scene.options.scallop_mm.unwrap_or(WIDEST * scene.bench.tool.corner_mm())
}

/// Measures.
pub(super) fn heights(scene: &AuditScene, sweep: &Sweep) -> Heights {
    if !scene.bench.tool.is_ball() {
        let passes = Passes {
            part: &scene.part,
            tool: scene.bench.tool,
            stands: &scene.legs.stands,
            turns: &scene.turns,
            is_helix: false,
            widest_mm: widest_mm(scene),
            samples: scene.options.settings.surface_samples as usize,
        };
        return ridges::heights(&passes, sweep);
    }
    of_ball(&scene.part, sweep, &[], widest_mm(scene), scene.options.settings.surface_samples as usize)
}

/// Heights between the passes of a ball, less what other balls take off there, too; at about so
/// many samples.
pub(in crate::verify) fn of_ball(
    part: &Allowed,
    sweep: &Sweep,
    others: &[&Sweep],
    widest_mm: f64,
    count: usize,
) -> Heights {
    let radius = sweep.radius_mm;
    let reach = (REACH_STEPOVERS * (8.0 * radius * widest_mm).sqrt()).max(LEAST_REACH_MM);
    let ends = near_ends(sweep, reach + (2.0 * radius * NEAR_MM).sqrt());
    let height = |s: &Sample| {
        let q = s.point + s.normal * radius;
        let (leg, gap_mm) =
            between(sweep, &q, reach, |legs| legs.iter().all(|(leg, _)| ends.get(*leg) == Some(&false)))?;
        let entries = others.iter().filter_map(|other| other.entry(&s.point, &s.normal, reach));
        let raw = entries.fold(sweep.entry(&s.point, &s.normal, reach)?, f64::min);
        // What no ball of this radius could reach is no fault of the passes.
        let up = lift(part, &s.point, &s.normal, radius, REACH_SLACK * widest_mm);
        Some(Height { height_mm: raw.min((raw - up).max(0.0)), point: s.point, leg, gap_mm })
    };
    let all = samples::near_path(part, sweep, reach, count);
    sorted(parallel::filter_map(&all.points, height))
}

/// Legs within so much way of the beginning or the end of a pass: there the ball comes down or goes
/// up on a lead, and beyond it nothing is to be cut.
fn near_ends(sweep: &Sweep, way_mm: f64) -> Vec<bool> {
    let n = sweep.centres.len().saturating_sub(1);
    let mut out = vec![false; n];
    let mut mark = |rows: &mut dyn Iterator<Item = usize>| {
        let mut way = 0.0;
        for i in rows {
            // Between passes the way begins anew.
            way = if sweep.counts(i) { way + (sweep.centres[i + 1] - sweep.centres[i]).norm() } else { 0.0 };
            out[i] |= way - (sweep.centres[i + 1] - sweep.centres[i]).norm() < way_mm;
        }
    };
    mark(&mut (0..n));
    mark(&mut (0..n).rev());
    out
}

/// The checks `scallop` and `scallop-turn`, where a scallop is asked for.
pub(super) fn checks(scene: &AuditScene, heights: &Heights) -> Vec<LineCheck> {
    let Some(asked) = scene.options.scallop_mm else { return Vec::new() };
    let all = &heights.sorted;
    let (Some(highest), Some(p99)) = (all.last(), percentile(all, 0.99)) else {
        return Vec::new();
    };
    let usual = median_gap(all);
    let limit = |id: CheckId, quantity: String, value: f64, ratio: f64| LineLimit {
        id,
        quantity,
        limit: ratio * asked,
        unit: "mm",
        passed: value <= ratio * asked,
    };
    let quantity = "99th percentile of the height left between passes".to_owned();
    let whole = limit(CheckId::Scallop, quantity, p99.height_mm, scene.options.settings.scallop_ratio);
    let note = format!(
        "{} places, highest {:.6}, median {:.6}; the place given is the highest{}",
        all.len(),
        highest.height_mm,
        heights.percentile(0.5),
        passes(highest, usual)
    );
    let mut out = vec![scene.judged(whole, &scene.on_leg(p99.height_mm, highest.leg, Some(highest.point)), note)];
    if let Some((turn, p95, top)) = worst_turn(scene, all) {
        let quantity = "95th percentile of the height left between passes over one turn".to_owned();
        let limit = limit(CheckId::ScallopTurn, quantity, p95.height_mm, scene.options.turn_ratio);
        let note = format!("highest {:.6}{}", top.height_mm, passes(&p95, usual));
        let mut check = scene.judged(limit, &scene.on_leg(p95.height_mm, top.leg, Some(top.point)), note);
        check.check.turn = Some(turn);
        out.push(check);
    }
    out
}

/// The turn with the highest 95th percentile, that, and its highest place.
fn worst_turn(scene: &AuditScene, sorted: &[Height]) -> Option<(u32, Height, Height)> {
    let turn = |h: &Height| scene.turns.get(h.leg).copied().unwrap_or(0) as usize;
    let count = sorted.iter().map(|h| turn(h) + 1).max()?;
    let mut by_turn: Vec<Vec<Height>> = vec![Vec::new(); count];
    for h in sorted {
        by_turn[turn(h)].push(*h);
    }
    let judged = by_turn.iter().enumerate().filter(|(_, list)| list.len() >= FEWEST);
    let each = judged.filter_map(|(k, list)| Some((k as u32, *percentile(list, 0.95)?, *list.last()?)));
    each.max_by(|a, b| a.1.height_mm.total_cmp(&b.1.height_mm).then(b.0.cmp(&a.0)))
}

/// The median, each pair of passes counting alike: a wide gap has more samples in it.
fn median_gap(heights: &[Height]) -> f64 {
    let mut gaps: Vec<f64> = heights.iter().map(|h| h.gap_mm).filter(|g| *g > 0.0).collect();
    gaps.sort_by(f64::total_cmp);
    let half = 0.5 * gaps.iter().map(|g| 1.0 / g).sum::<f64>();
    let mut sum = 0.0;
    let past = |g: &&f64| {
        sum += 1.0 / **g;
        sum >= half
    };
    gaps.iter().find(past).copied().unwrap_or(0.0)
}

/// How far the passes are apart there, in words.
fn passes(h: &Height, usual_mm: f64) -> String {
    let missing = if h.gap_mm > MISSING * usual_mm { ": a turn or a pass is missing between them" } else { "" };
    format!("; the passes beside it are {:.3} mm apart, usually {usual_mm:.3} mm{missing}", h.gap_mm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;

    #[test]
    fn legs_beside_the_ends_of_passes_are_known() {
        let centres: Vec<Point> = (0..=10).map(|i| Point::new(f64::from(i), 0.0, 0.0)).collect();
        let wanted = (0..10).map(|i| i != 5).collect();
        let sweep = Sweep::of(centres.clone(), centres, vec![0; 11], 1.0, Some(wanted));
        let near = near_ends(&sweep, 2.0);
        let far: Vec<usize> = (0..10).filter(|i| !near[*i]).collect();
        assert_eq!(far, [2]);
        assert!(near_ends(&sweep, 100.0).iter().all(|n| *n));
        // Midway between two passes, and beside the end of one.
        let mut rows: Vec<Point> = (0..=40).map(|i| Point::new(f64::from(i), 0.0, 0.0)).collect();
        rows.extend((0..=40).map(|i| Point::new(f64::from(i), 1.0, 0.0)));
        let wanted = (0..81).map(|i| i != 40).collect();
        let sweep = Sweep::of(rows.clone(), rows, vec![0; 82], 1.0, Some(wanted));
        let ends = near_ends(&sweep, 3.0);
        let q = |x: f64| between(&sweep, &Point::new(x, 0.4, 0.0), 2.0, |legs| legs.iter().all(|(leg, _)| !ends[*leg]));
        assert!(q(20.5).is_some_and(|(_, gap)| (gap - 1.0).abs() < 1e-9));
        assert_eq!((q(1.5), q(39.2)), (None, None));
    }
}
