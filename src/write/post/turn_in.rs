//! Turning in, for controls that fix X Y Z to the table as it stands when tool-centre-point control comes on (Fanuc's manuals of `G43.4` and `G43.5`). It comes
//! on with the table at 0, where the frame of the control is the blade frame; only then the table turns to the first location.
//!
//! It turns under the end of travel in Z, where the linear axes stand still from step to step. Within a step the control moves the programmed point
//! straight over the part: the linear axes leave their place by the sagitta of its way round the table, and come back.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Run, cycle};
use crate::artifact::program::Programmed;
use crate::geometry::Vector;

/// Longest step: the shorter way to its end is the one meant, whatever the control takes.
const LONGEST_RAD: f64 = FRAC_PI_2;
/// Share of the clearance of the safe position that the linear axes may leave their place by.
const STRAY: f64 = 0.5;
/// Rounding of positions at an end of travel.
const ROUNDING_MM: f64 = 1e-9;
/// Places within a step that are looked at.
const WITHIN: usize = 8;
/// Most steps: none strays by more than 0.01 mm then on a way of a metre's radius. Where that still leaves travel, the program's checks find it.
const MOST_STEPS: usize = 1000;

/// Axis positions one after another: where tool-centre-point control comes on, the ends of the steps, the safe position over the first location.
pub(super) fn places(run: &Run, programmed: Programmed) -> Vec<[f64; 5]> {
    let first = &run.ends[0];
    let safe = run.axes_at(first, first.safe_mm);
    let stray_mm = STRAY * run.options.safe_clearance_mm;
    let mut turned = safe;
    // A tool may be longer than planned, and strays.
    turned[2] = safe[2].max(cycle::safe_z(run) - stray_mm);
    let mut zero = turned;
    let at_zero = [run.turns_before_rad(), 0.0];
    for (i, of_table) in run.machine.table_axes().into_iter().enumerate() {
        if of_table {
            zero[3 + i] = at_zero[i];
        }
    }
    let way = (turned[3] - zero[3]).abs().max((turned[4] - zero[4]).abs());
    let least = (way / LONGEST_RAD).ceil() as usize;
    let steps =
        |n: usize| (0..=n).map(move |k| between(&zero, &turned, if n == 0 { 1.0 } else { k as f64 / n as f64 }));
    let keeps = |n: usize| {
        let ends: Vec<_> = steps(n).collect();
        ends.windows(2).all(|w| (1..WITHIN).all(|k| keeps(run, programmed, w, k as f64 / WITHIN as f64, stray_mm)))
    };
    let n = (least..MOST_STEPS).find(|n| keeps(*n)).unwrap_or(MOST_STEPS);
    steps(n).chain([safe]).collect()
}

fn between(a: &[f64; 5], b: &[f64; 5], share: f64) -> [f64; 5] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

/// Whether the linear axes, at a share of the way between two places on which the programmed point goes straight over the part, are near the one where they stand at
/// both ends, and within their travel.
fn keeps(run: &Run, programmed: Programmed, ends: &[[f64; 5]], share: f64, stray_mm: f64) -> bool {
    let (machine, gauge) = (run.machine, run.tool.length_mm());
    let lift_mm = if programmed == Programmed::Tip { run.tool.radius_mm } else { 0.0 };
    let [p, q] = [0, 1].map(|k| machine.forward(&ends[k], gauge).tip(lift_mm));
    let [.., a, b] = between(&ends[0], &ends[1], share);
    let centre = p + (q - p) * share + machine.axis_at([a, b]) * lift_mm;
    let at = machine.linear_at(&centre, [a, b], gauge);
    let stands = &ends[0][..3];
    let off_mm = (Vector::from(at) - Vector::from_column_slice(stands)).norm();
    let limits = machine.limits();
    // Where an axis is beyond its travel anyhow, that is found as such.
    let inside = |i: usize| {
        let within =
            |[lo, hi]: [f64; 2]| (lo.min(stands[i]) - ROUNDING_MM..=hi.max(stands[i]) + ROUNDING_MM).contains(&at[i]);
        limits[i].travel.is_none_or(within)
    };
    off_mm <= stray_mm && (0..3).all(inside)
}

impl Run<'_> {
    /// Whole turns of the first rotary axis that a program drops: all dialects begin in the same one, from 0 on. None where it has ends of travel and
    /// stands where it is told. Rad.
    pub(super) fn turns_before_rad(&self) -> f64 {
        if self.machine.limits()[3].travel.is_some() {
            return 0.0;
        }
        let first = self.plan.axes().next().map_or(0.0, |q| q[3].to_degrees());
        TAU * (first / 360.0).floor()
    }
}
