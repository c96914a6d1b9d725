//! Where the time of an operation goes: the one place that counts it.
//!
//! Feed moves take their way over their feed, the motion on leads and path its planned times,
//! rapids the time of the slowest axis under its own velocity and acceleration: a trapezoid, or a
//! triangle where it is short. Not counted is what no file says: the tool change, and the way from
//! wherever the machine stood to over the part.

use super::dialect::Dialect;
use super::{OperationRun, WayEnd, turn_in};
use crate::artifact::Axes;
use crate::artifact::plan::Stretch;
use crate::artifact::program::CycleTime;
use crate::numerics::angle::within_half_turn;

/// The time of an operation as a dialect writes it.
pub(super) fn time(run: &OperationRun, dialect: &Dialect) -> CycleTime {
    let [first, last] = &run.ends;
    let [lead_in_s, cutting_s, lead_out_s] = planned(run);
    let places = if dialect.turns_in() { turn_in::places(run, dialect.file.programmed) } else { Vec::new() };
    let (approach_s, retract_s) = (outside(run, first, &places), outside(run, last, &[]));
    let unwinding_s = unwinding(run, dialect, places.first().map(|p| &**p));
    let total_s = approach_s + lead_in_s + cutting_s + lead_out_s + retract_s + unwinding_s;
    CycleTime { approach_s, lead_in_s, cutting_s, lead_out_s, retract_s, unwinding_s, total_s }
}

/// Lead-in, path and lead-out by the plan's times.
fn planned(run: &OperationRun) -> [f64; 3] {
    let (mut first, mut path, mut last) = (None, [None; 2], 0.0);
    for row in run.plan.rows() {
        first = first.or(Some(row.t_s));
        last = row.t_s;
        if matches!(row.stretch, Stretch::Turn(_)) {
            path = [path[0].or(Some(row.t_s)), Some(row.t_s)];
        }
    }
    let [begins, ends] = path.map(|t| t.unwrap_or(last));
    [begins - first.unwrap_or(begins), ends - begins, last - ends]
}

/// Between the end of travel that programs retract to and an end of the path: a rapid to the safe
/// position, or by places one after another, the approach feed to the feed height, the plunge feed
/// from there on.
fn outside(run: &OperationRun, end: &WayEnd, by: &[Axes]) -> f64 {
    let (o, height) = (&run.options.settings, run.feed_height(end));
    let at = run.axes_at(end, end.safe_mm);
    let by = if by.is_empty() { std::slice::from_ref(&at) } else { by };
    let mut over = by[0];
    over[run.up()] = run.safe_up();
    let rapids: f64 = std::iter::once(&over).chain(by).zip(by).map(|(from, to)| run.machine.rapid_s(from, to)).sum();
    let at_feed = (end.safe_mm - height) / o.approach_feed_mm_min + height / o.plunge_feed_mm_min;
    60.0 * at_feed + rapids
}

/// The rotary axes back to where the program began with them: at `begun`, or at the first
/// location's.
fn unwinding(run: &OperationRun, dialect: &Dialect, begun: Option<&[f64]>) -> f64 {
    if dialect.unwind.is_empty() || !run.ends.iter().all(|e| e.clear) {
        return 0.0;
    }
    let [first, from] = [&run.ends[0], &run.ends[1]].map(|e| run.machine.turn_to(&e.stand, Some(&e.near)));
    let (to, axes, turning) = (begun.unwrap_or(&first), run.machine.axes(), run.machine.turning_axis());
    let mut way = Axes::from_fn(from.len(), |k| if axes[k].is_rotary() { from[k] - to[k] } else { 0.0 });
    if dialect.turns_back_by_the_shorter_way() && axes[turning].limits.travel.is_none() {
        way[turning] = within_half_turn(way[turning]);
    }
    run.machine.rapid_s(&way, &Axes::of_default(way.len()))
}
