//! Turning in, for controls that fix X Y Z to the table as it stands when tool-centre-point control
//! comes on (Fanuc's manuals of `G43.4` and `G43.5`). It comes on with the table at 0, where the
//! frame of the control is the blade frame; only then the table turns to the first location.
//!
//! It turns under the end of travel that programs retract to, where the linear axes stand still
//! from step to step.
//! Within a step the control moves the programmed point straight over the part: the linear axes
//! leave their place by the sagitta of its way round the table, and come back.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::OperationRun;
use crate::artifact::Axes;
use crate::artifact::program::Programmed;
use crate::geometry::Vector;
use crate::machine::Carries;

/// Longest step: the shorter way to its end is the one meant, whatever the control takes.
const LONGEST_RAD: f64 = FRAC_PI_2;
/// Share of the clearance of the safe position that the linear axes may leave their place by.
const STRAY: f64 = 0.5;
/// Rounding of positions at an end of travel.
const ROUNDING_MM: f64 = 1e-9;
/// Places within a step that are looked at.
const WITHIN: usize = 8;
/// Most steps: none strays by more than 0.01 mm then on a way of a metre's radius. Where that still
/// leaves travel, the program's checks find it.
const MOST_STEPS: usize = 1000;

/// Axis positions one after another: where tool-centre-point control comes on, the ends of the
/// steps, the safe position over the first location.
pub(super) fn places(run: &OperationRun, programmed: Programmed) -> Vec<Axes> {
    let first = &run.ends[0];
    let safe = run.axes_at(first, first.safe_mm);
    let stray_mm = STRAY * run.options.settings.safe_clearance_mm;
    let mut turned = safe;
    // A tool may be longer than planned, and strays.
    let (up, sense) = run.machine.retract_axis();
    let end = run.safe_up() - sense * stray_mm;
    turned[up] = if sense < 0.0 { safe[up].min(end) } else { safe[up].max(end) };
    let mut zero = turned;
    let (axes, rotary) = (run.machine.axes(), run.machine.rotary());
    for k in rotary.clone().filter(|k| axes[*k].carries == Carries::Workpiece) {
        zero[k] = if k == run.machine.turning_axis() { run.turns_before_rad() } else { 0.0 };
    }
    let way = rotary.map(|k| (turned[k] - zero[k]).abs()).fold(0.0, f64::max);
    let least = (way / LONGEST_RAD).ceil() as usize;
    let steps = |n: usize| (0..=n).map(move |k| zero.toward(&turned, if n == 0 { 1.0 } else { k as f64 / n as f64 }));
    let keeps = |n: usize| {
        let ends: Vec<_> = steps(n).collect();
        ends.windows(2).all(|w| (1..WITHIN).all(|k| keeps(run, programmed, w, k as f64 / WITHIN as f64, stray_mm)))
    };
    let n = (least..MOST_STEPS).find(|n| keeps(*n)).unwrap_or(MOST_STEPS);
    steps(n).chain([safe]).collect()
}

/// Whether the linear axes, at a share of the way between two places on which the programmed point
/// goes straight over the part, are near the one where they stand at both ends, and within their
/// travel.
fn keeps(run: &OperationRun, programmed: Programmed, ends: &[Axes], share: f64, stray_mm: f64) -> bool {
    let (machine, gauge) = (run.machine, run.tool.length_mm());
    let lift_mm = if programmed == Programmed::Tip { run.tool.corner_mm() } else { 0.0 };
    let [p, q] = [0, 1].map(|k| machine.forward(&ends[k], gauge).tip(lift_mm));
    let turned = ends[0].toward(&ends[1], share);
    let centre = p + (q - p) * share + machine.axis_at(&turned) * lift_mm;
    let at = machine.linear_at(&centre, &turned, gauge);
    let (stands, linear, axes) = (&ends[0], machine.linear(), machine.axes());
    let off_mm = Vector::from(linear.map(|k| at[k] - stands[k])).norm();
    // Where an axis is beyond its travel anyhow, that is found as such.
    let inside = |i: &usize| {
        let i = *i;
        let within =
            |[lo, hi]: [f64; 2]| (lo.min(stands[i]) - ROUNDING_MM..=hi.max(stands[i]) + ROUNDING_MM).contains(&at[i]);
        axes[i].limits.travel.is_none_or(within)
    };
    off_mm <= stray_mm && linear.iter().all(inside)
}

impl OperationRun<'_> {
    /// Whole turns of the first rotary axis that a program drops: all dialects begin in the same
    /// one, from 0 on. None where it has ends of travel and stands where it is programmed. Rad.
    pub(super) fn turns_before_rad(&self) -> f64 {
        let turning = self.machine.turning_axis();
        if self.machine.axes()[turning].limits.travel.is_some() {
            return 0.0;
        }
        let first = self.plan.axes().next().map_or(0.0, |q| q[turning].to_degrees());
        TAU * (first / 360.0).floor()
    }
}
