//! A stretch of the path as stages of the solver: speed and acceleration are given where it begins
//! and where it ends, or it begins or ends at rest.

use std::ops::Range;

use super::cells::{SHARES_OF_X, dot, jensen, mixed, of_x};
use super::rows::{Dual, Jerk, JerkRows, Problem, Shares};
use crate::numerics::stages::{self, Inequality, Model, Options, Stage};

/// Least Bernstein coefficient of ṡ² in a search, as a share of the one it begins with.
const FLOOR: f64 = 1e-3;
/// Least second derivative of the Lagrangian by a coefficient of ṡ², as a share of that of the
/// time.
const CONVEX: f64 = 0.05;
/// Iterations of one search at most.
const ITERATIONS: usize = 60;

/// How a search goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    /// The gap that the profile it begins with is taken to have, as a share of the time.
    pub begin: f64,
    /// It ends within this …
    pub tolerance: f64,
    /// … and goes on while every step gains much, down to this share of it.
    pub further: f64,
    /// Rows may be missed by this.
    pub excess: f64,
    /// Rows that have not reached these shares of their limits at the beginning are left out.
    pub shares: Shares,
}

/// What a search has found.
pub(super) struct Found {
    /// `(x, u, w)` at the start of every cell.
    pub v: Vec<[f64; 3]>,
    pub duals: Vec<Dual>,
    /// Derivatives of the least time by u at the start of every cell.
    pub costates: Vec<f64>,
}

/// The fastest profile over a range of cells, from a profile within all limits there. `None` where
/// numbers are not finite.
pub(super) fn search(problem: &Problem, range: Range<usize>, v: &[[f64; 3]], how: Search) -> Option<Found> {
    let window = Window::new(problem, range.clone(), v, how.shares);
    let at_rest = usize::from(range.start == 0);
    let mut from: Vec<[f64; 3]> = Vec::with_capacity(v.len() + at_rest);
    let mut stages: Vec<Stage<2, 3>> = Vec::with_capacity(v.len() + at_rest);
    if range.start == 0 {
        // From rest: the control is u at the end of the first cell.
        let h = problem.ends[0][0];
        from.push([0.0, 0.0, v.first()?[1]]);
        stages.push(Stage { dynamics: [[0.0, 0.0, 1.5 * h], [0.0, 0.0, 1.0]], ..Stage::default() });
    }
    from.extend(v.iter().zip(&window.ties).map(|(v, t)| [v[0], v[1], if t.is_some() { 0.0 } else { v[2] }]));
    stages.extend((0..range.len()).map(|i| window.stage(i)));
    let count: usize = stages.iter().map(|s| s.rows.len()).sum();
    let mean = problem.time(range.start, v) / count as f64;
    let options = Options {
        fixed: [true; 8],
        interior: true,
        tolerance: how.tolerance * mean,
        excess: how.excess,
        barrier: how.begin * mean,
        further: how.further,
        iterations: ITERATIONS,
        ..Options::default()
    };
    let found = stages::solve(&mut stages, &from, &window, &options)?;
    let mut row = 0;
    let mut duals = Vec::with_capacity(range.len());
    for (i, s) in stages[at_rest..].iter().enumerate() {
        // Floors, the first three, are no limits.
        duals.push(window.rows.dual(i, window.cell(i).h, &found.multipliers[row + 3..row + s.rows.len()]));
        row += s.rows.len();
    }
    Some(Found {
        v: found.v[at_rest..].iter().enumerate().map(|(i, v)| window.whole(i, v)).collect(),
        duals,
        costates: found.costates[at_rest..].iter().map(|c| c[1]).collect(),
    })
}

/// A control that the state decides: `w = [0] x + [1] u + [2]`.
type Tie = [f64; 3];

struct Window<'a> {
    problem: &'a Problem<'a>,
    range: Range<usize>,
    rows: JerkRows,
    /// Cells in which w follows from the state, since speed and acceleration are given at the end
    /// of the stretch.
    ties: Vec<Option<Tie>>,
    /// Least Bernstein coefficients of x in each cell.
    floor: Vec<[f64; 3]>,
}

impl<'a> Window<'a> {
    fn new(problem: &'a Problem<'a>, range: Range<usize>, v: &[[f64; 3]], shares: Shares) -> Self {
        let rows = JerkRows::of(problem, range.clone(), v, shares);
        let floor = range.clone().zip(v).map(|(i, v)| problem.x(i, v).map(|x| FLOOR * x));
        Window { problem, rows, ties: ties(problem, &range, v), floor: floor.collect(), range }
    }

    fn cell(&self, i: usize) -> &super::cells::Cell<'a> {
        &self.problem.inner[self.range.start + i]
    }

    /// A row in the state alone where w follows from it.
    fn tied(&self, i: usize, g: [f64; 3], most: f64) -> Inequality<3> {
        match self.ties[i] {
            Some(t) => Inequality { g: [g[0] + g[2] * t[0], g[1] + g[2] * t[1], 0.0], most: most - g[2] * t[2] },
            None => Inequality { g, most },
        }
    }

    /// `(x, u, w)` of what the solver knows of a cell.
    fn whole(&self, i: usize, v: &[f64; 3]) -> [f64; 3] {
        match self.ties[i] {
            Some(t) => [v[0], v[1], t[0] * v[0] + t[1] * v[1] + t[2]],
            None => *v,
        }
    }

    /// Rows that do not change, then those of jerk (filled in by `refresh`).
    fn stage(&self, i: usize) -> Stage<2, 3> {
        let h = self.cell(i).h;
        let mut out = Stage { dynamics: [[1.0, 2.0 * h, h * h], [0.0, 1.0, h]], ..Stage::default() };
        out.dynamics = out.dynamics.map(|g| self.tied(i, g, 0.0).g);
        let (linear, jerk) = (self.rows.linear(i), self.rows.jerk(i));
        out.rows.reserve_exact(3 + linear.len() + jerk.len());
        let floors = of_x(h).into_iter().zip(self.floor[i]);
        out.rows.extend(floors.map(|(g, floor)| self.tied(i, g.map(|v| -v / floor), -1.0)));
        out.rows.extend(linear.iter().map(|g| self.tied(i, *g, 1.0)));
        out.rows.extend(jerk.iter().map(|j| self.tied(i, j.g, 1.0)));
        out
    }
}

/// Speed and acceleration at the end of a stretch are given, so w of its last two cells follows
/// from the state at their start; at the end of the path, of the last: x and u are those of
/// constant jerk to rest, `x = −3/2 h u`.
fn ties(problem: &Problem, range: &Range<usize>, v: &[[f64; 3]]) -> Vec<Option<Tie>> {
    let n = range.len();
    let inner = &problem.inner[range.clone()];
    let mut out = vec![None; n];
    let meet = |h: f64, l: f64| [-1.0 / (h * (h + l)), -(2.0 * h + l) / (h * (h + l))];
    let with_rest = |[x, u]: [f64; 2], v: &[f64; 3]| Some([x, u, v[2] - x * v[0] - u * v[1]]);
    if range.end == problem.inner.len() {
        let [x, u] = meet(inner[n - 1].h, 1.5 * problem.ends[1][0]);
        out[n - 1] = Some([x, u, 0.0]);
        return out;
    }
    out[n - 1] = with_rest([0.0, -1.0 / inner[n - 1].h], &v[n - 1]);
    if n > 1 {
        out[n - 2] = with_rest(meet(inner[n - 2].h, inner[n - 1].h), &v[n - 2]);
    }
    out
}

/// The row of x at a place of [`SHARES_OF_X`], from those of its three coefficients.
fn at_place(bernstein: &[[f64; 3]; 3], place: usize) -> [f64; 3] {
    let shares = SHARES_OF_X[place];
    std::array::from_fn(|c| (0..3).map(|b| shares[b] * bernstein[b][c]).sum())
}

impl Model<2, 3> for Window<'_> {
    fn refresh(&self, stage: usize, v: &[f64; 3], multipliers: &[f64], of: &mut Stage<2, 3>) {
        let Some(i) = stage.checked_sub(usize::from(self.range.start == 0)) else { return };
        let bernstein = of_x(self.cell(i).h);
        let whole = self.whole(i, v);
        let x: [f64; 3] = std::array::from_fn(|b| dot(&bernstein[b], &whole).max(self.floor[i][b]));
        let inverse = x.map(|x| 1.0 / x.sqrt());
        let own = self.rows.jerk(i);
        // Places between are those of cells of degree 5 alone.
        let between = if own.iter().any(|j| j.b >= 3) { 6 } else { 3 };
        let (mut places, mut inverses) = ([0.0; 6], [0.0; 6]);
        for b in 0..between {
            places[b] = mixed(&x, b);
            inverses[b] = if b < 3 { inverse[b] } else { 1.0 / places[b].sqrt() };
        }
        // A jerk within 1/√x, by the tangent of that. Kept at the Bernstein coefficients it is kept
        // up to `jensen` between them.
        let share = 1.0 / jensen(x);
        let first = 3 + self.rows.linear(i).len();
        let mut sums = [0.0; 3];
        for (k, Jerk { b, g }) in (first..).zip(own) {
            let slope = 0.5 * share * inverses[*b] / places[*b];
            let row = if *b < 3 { bernstein[*b] } else { at_place(&bernstein, *b) };
            let g = std::array::from_fn(|c| g[c] + slope * row[c]);
            of.rows[k] = self.tied(i, g, 1.5 * share * inverses[*b]);
            let sum = share * multipliers.get(k).copied().unwrap_or(0.0);
            if *b < 3 {
                sums[*b] += sum;
            } else {
                sums.iter_mut().zip(SHARES_OF_X[*b]).for_each(|(s, of)| *s += of * sum);
            }
        }
        // The time to first order, the Lagrangian to second: the tangents bend against the time.
        let weights = self.problem.weights(self.range.start + i);
        (of.hessian, of.gradient) = ([[0.0; 3]; 3], [0.0; 3]);
        for b in 0..3 {
            let g = self.tied(i, bernstein[b], 0.0).g;
            let first = -0.5 * weights[b] * inverse[b] / x[b];
            let second = 0.75 * (weights[b] - sums[b]).max(CONVEX * weights[b]) * inverse[b] / (x[b] * x[b]);
            let linear = first - second * dot(&g, v);
            for r in 0..3 {
                of.gradient[r] += linear * g[r];
                for c in 0..3 {
                    of.hessian[r][c] += second * g[r] * g[c];
                }
            }
        }
    }
}
