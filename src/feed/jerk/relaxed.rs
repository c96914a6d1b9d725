//! A convex problem whose least time is below that of every profile: its multipliers prove a bound
//! (`bound` module).
//!
//! What is not convex is that jerk may be greater where the motion is slower, `bracket ≤ 1/√x`.
//! Here every Bernstein coefficient of x has a slowness `p ≥ 1/√x` of its own, at a joint the same
//! for both cells; it pays for it in time and may have `bracket ≤ p` for it, without being slow. A
//! profile within the limits keeps all this with `p = 1/√x`. Rows may be left out, and stretches
//! are free at both ends: that only makes the bound lower.

use std::ops::Range;

use super::cells::{SHARES_OF_X, dot, of_x};
use super::rows::{Dual, JerkRows, Problem, Shares};
use crate::numerics::stages::{self, Inequality, Model, Options, Stage};

/// Rows that have not reached these shares of their limits in the profile are left out; jerks may
/// be a little below 0.
const SHARES: Shares = Shares { accelerations: 0.1, others: -0.2 };
/// The search begins with this share of the profile's ṡ² and u, and with slownesses greater by
/// this: strictly within all rows.
const SLOWER: f64 = 0.8;
const RISE: f64 = 1.1;
/// Least Bernstein coefficient of x, as a share of the profile's.
const FLOOR: f64 = 0.01;
/// Slack × multiplier of all rows at the beginning and at the end, as shares of the time.
const BEGIN: f64 = 0.3;
const TOLERANCE: f64 = 3e-3;
/// Rows may be missed by this: any multipliers prove a bound.
const EXCESS: f64 = 1e-3;
/// Iterations at most.
const ITERATIONS: usize = 60;

/// Multipliers of each cell and derivatives of the least time by u at their starts, over a range of
/// cells. `v`: a profile within all limits there.
pub(super) fn multipliers(problem: &Problem, range: Range<usize>, v: &[[f64; 3]]) -> Option<(Vec<Dual>, Vec<f64>)> {
    let relaxed = Relaxed::new(problem, range.clone(), v);
    let at_rest = usize::from(range.start == 0);
    let mut from: Vec<[f64; 6]> = Vec::with_capacity(v.len() + at_rest);
    let mut stages: Vec<Stage<3, 6>> = Vec::with_capacity(v.len() + at_rest);
    if range.start == 0 {
        let h = problem.ends[0][0];
        let [x, u, _] = v.first()?.map(|v| SLOWER * v);
        from.push([0.0, 0.0, 0.0, u, 0.0, RISE / x.sqrt()]);
        stages.push(Stage { dynamics: [wide([0.0, 0.0, 1.5 * h]), wide([0.0, 0.0, 1.0]), NEXT], ..Stage::default() });
    }
    for (i, v) in range.clone().zip(v) {
        let p = problem.x(i, v).map(|x| RISE / (SLOWER * x).sqrt());
        from.push([SLOWER * v[0], SLOWER * v[1], p[0], SLOWER * v[2], p[1], p[2]]);
    }
    stages.extend((0..range.len()).map(|i| relaxed.stage(i)));
    let count: usize = stages.iter().map(|s| s.rows.len()).sum();
    let mean = problem.time(range.start, v) / count as f64;
    let options = Options {
        fixed: [range.start == 0; 8],
        interior: true,
        tolerance: TOLERANCE * mean,
        excess: EXCESS,
        barrier: BEGIN * mean,
        iterations: ITERATIONS,
        ..Options::default()
    };
    let found = stages::solve(&mut stages, &from, &relaxed, &options)?;
    let mut row = 0;
    let mut duals = Vec::with_capacity(range.len());
    for (i, s) in stages[at_rest..].iter().enumerate() {
        // Slownesses and floors, the last six, are no limits.
        duals.push(relaxed.rows.dual(i, relaxed.length(i), &found.multipliers[row..row + s.rows.len() - 6]));
        row += s.rows.len();
    }
    Some((duals, found.costates[at_rest..].iter().map(|c| c[1]).collect()))
}

struct Relaxed<'a> {
    problem: &'a Problem<'a>,
    range: Range<usize>,
    rows: JerkRows,
    /// Least Bernstein coefficients of x in each cell.
    floor: Vec<[f64; 3]>,
}

/// Where x, u and w are among the numbers of a cell: `x`, `u` and the first slowness are its state,
/// `w` and two more slownesses its controls.
const STATE: [usize; 3] = [0, 1, 3];
/// … and the three slownesses.
const SLOWNESS: [usize; 3] = [2, 4, 5];
/// The first slowness of the next cell is the last of this one.
const NEXT: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// A row in `(x, u, w)` among those in all numbers of a cell.
fn wide(g: [f64; 3]) -> [f64; 6] {
    [g[0], g[1], 0.0, g[2], 0.0, 0.0]
}

impl<'a> Relaxed<'a> {
    fn new(problem: &'a Problem<'a>, range: Range<usize>, v: &[[f64; 3]]) -> Self {
        let floor = range.clone().zip(v).map(|(i, v)| problem.x(i, v).map(|x| FLOOR * x)).collect();
        Relaxed { problem, rows: JerkRows::of(problem, range.clone(), v, SHARES), floor, range }
    }

    fn length(&self, i: usize) -> f64 {
        self.problem.inner[self.range.start + i].h
    }

    /// Limits, then what `refresh` fills in: slownesses; then floors.
    fn stage(&self, i: usize) -> Stage<3, 6> {
        let h = self.length(i);
        let mut out = Stage { dynamics: [wide([1.0, 2.0 * h, h * h]), wide([0.0, 1.0, h]), NEXT], ..Stage::default() };
        for (at, weight) in SLOWNESS.into_iter().zip(self.problem.weights(self.range.start + i)) {
            out.gradient[at] = weight;
        }
        let (linear, jerk) = (self.rows.linear(i), self.rows.jerk(i));
        out.rows.reserve_exact(linear.len() + jerk.len() + 6);
        out.rows.extend(linear.iter().map(|g| Inequality { g: wide(*g), most: 1.0 }));
        for j in jerk {
            let mut g = wide(j.g);
            // Between coefficients a slowness is at most the mean of theirs.
            for (at, share) in SLOWNESS.into_iter().zip(SHARES_OF_X[j.b]).filter(|(_, share)| *share > 0.0) {
                g[at] = -share;
            }
            out.rows.push(Inequality { g, most: 0.0 });
        }
        out.rows.extend([Inequality { g: [0.0; 6], most: 0.0 }; 3]);
        let floors = of_x(h).into_iter().zip(self.floor[i]);
        out.rows.extend(floors.map(|(g, floor)| Inequality { g: wide(g.map(|v| -v / floor)), most: -1.0 }));
        out
    }
}

impl Model<3, 6> for Relaxed<'_> {
    fn refresh(&self, stage: usize, v: &[f64; 6], multipliers: &[f64], of: &mut Stage<3, 6>) {
        let Some(i) = stage.checked_sub(usize::from(self.range.start == 0)) else { return };
        let weights = self.problem.weights(self.range.start + i);
        let first = of.rows.len() - 6;
        let state = STATE.map(|at| v[at]);
        let mut hessian = [[0.0; 3]; 3];
        for (b, g) in of_x(self.length(i)).into_iter().enumerate() {
            let x = dot(&g, &state).max(self.floor[i][b]);
            let p = 1.0 / x.sqrt();
            let mut row = wide(g.map(|c| -0.5 * p / x * c));
            row[SLOWNESS[b]] = -1.0;
            of.rows[first + b] = Inequality { g: row, most: -1.5 * p };
            let second = 0.75 * p / (x * x) * multipliers.get(first + b).copied().unwrap_or(weights[b]);
            for r in 0..3 {
                for c in 0..3 {
                    hessian[r][c] += second * g[r] * g[c];
                }
            }
        }
        for (at, row) in STATE.into_iter().zip(&hessian) {
            of.hessian[at] = wide(*row);
            of.gradient[at] = -dot(row, &state);
        }
    }
}
