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
/// Most steps: none strays by more than 0.01 mm then on a way of a metre's radius.
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
    let strays = |n: usize| {
        let ends: Vec<_> = steps(n).collect();
        ends.windows(2).map(|w| stray(run, programmed, &w[0], &w[1])).fold(0.0, f64::max)
    };
    let n = (least..MOST_STEPS).find(|n| strays(*n) <= stray_mm).unwrap_or(MOST_STEPS);
    steps(n).chain([safe]).collect()
}

fn between(a: &[f64; 5], b: &[f64; 5], share: f64) -> [f64; 5] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share)
}

/// How far the linear axes are from evenly between two places in the middle, while the programmed point goes straight over the part, mm.
fn stray(run: &Run, programmed: Programmed, a: &[f64; 5], b: &[f64; 5]) -> f64 {
    let (machine, gauge) = (run.machine, run.tool.length_mm());
    let lift_mm = if programmed == Programmed::Tip { run.tool.radius_mm } else { 0.0 };
    let [p, q] = [a, b].map(|at| machine.forward(at, gauge).tip(lift_mm));
    let middle = between(a, b, 0.5);
    let rotary = [middle[3], middle[4]];
    let centre = nalgebra::center(&p, &q) + machine.axis_at(rotary) * lift_mm;
    let reached = Vector::from(machine.linear_at(&centre, rotary, gauge));
    (reached - Vector::new(middle[0], middle[1], middle[2])).norm()
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
