//! The problem as stages of the solver: rest, the end of the first cell, the cells between, the start of the last cell.

use super::cells::{AXES, Cell, Limits, dot, greatest, of_x};
use crate::numerics::stages::{self, Model, Options, Row, Solution, Stage};

/// Least speed squared, as a share of the least of the start.
const FLOOR: f64 = 1e-3;
/// What may be left of the time by the solver's tolerance, as a share of it.
const GAP: f64 = 1e-5;
/// The solver is started again at most so often.
const RESTARTS: usize = 3;

/// What the solver's stages are made from.
pub(super) struct Profile<'a> {
    inner: &'a [Cell],
    /// Length and greatest x of the end cells.
    ends: [[f64; 2]; 2],
    limits: &'a Limits,
    /// Axes of each cell that have rows of acceleration and jerk.
    active: Vec<[bool; AXES]>,
    /// Brackets of the jerks of active axes over their limits, and where those of each cell begin.
    brackets: Vec<[[f64; 3]; 3]>,
    first: Vec<usize>,
    whole: f64,
    floor: f64,
}

/// What was found: `(x, u, w)` at the start of every inner cell and at the end of the last, and by how much of its time it may
/// be from the least, as a share.
pub(super) struct Fastest {
    pub v: Vec<[f64; 3]>,
    pub gap: f64,
    pub iterations: usize,
}

/// The fastest profile from a start within all limits. All steps stay within them, so there is always an answer.
pub(super) fn fastest(inner: &[Cell], ends: [[f64; 2]; 2], limits: &Limits, start: Vec<[f64; 3]>) -> Option<Fastest> {
    let n = inner.len();
    let model = Profile::new(inner, ends, limits, &start);
    let mut stages: Vec<Stage<2, 3>> = (0..=n + 1).map(|i| model.stage(i)).collect();
    let count: usize = stages.iter().map(|s| s.rows.len()).sum();
    // From rest: the control is u at the end of the first cell. The last cell's w follows from its end.
    let mut from = vec![[0.0, 0.0, start.first()?[1]]];
    from.extend(start);
    from[n][2] = 0.0;
    from[n + 1][2] = 0.0;
    let (mut gap, mut iterations) = (1.0, 0);
    for _ in 0..=RESTARTS {
        // Where the solver lost its way it starts again where it is, with multipliers that fit.
        let time = model.time(&from);
        let options = Options {
            fixed: [true; 8],
            interior: true,
            tolerance: GAP * time / count as f64,
            barrier: gap * time / count as f64,
            iterations: 100,
            ..Options::default()
        };
        let found: Solution<2, 3> = stages::solve(&mut stages, &from, &model, &options)?;
        from = found.v;
        gap = found.complementarity * count as f64 / model.time(&from);
        iterations += found.iterations;
        if found.converged || gap < 2.0 * GAP {
            break;
        }
        gap = gap.min(1.0);
    }
    let mut v: Vec<[f64; 3]> = from.into_iter().skip(1).collect();
    v[n - 1][2] = dot(&model.last_w(), &v[n - 1]);
    Some(Fastest { v, gap, iterations })
}

impl<'a> Profile<'a> {
    fn new(inner: &'a [Cell], ends: [[f64; 2]; 2], limits: &'a Limits, start: &[[f64; 3]]) -> Self {
        let active: Vec<[bool; AXES]> = inner.iter().map(|p| decisive(p, limits)).collect();
        let (mut brackets, mut first) = (Vec::new(), Vec::with_capacity(inner.len()));
        for (p, a) in inner.iter().zip(&active) {
            first.push(brackets.len());
            brackets.extend(
                (0..AXES).filter(|k| a[*k]).map(|k| p.bracket(k).map(|g| g.map(|v| v / (p.share * limits[k][2])))),
            );
        }
        let whole = inner.iter().map(|p| p.h).sum::<f64>() + ends[0][0] + ends[1][0];
        let least = |(v, c): (&[f64; 3], &Cell)| v[0].min(v[0] + c.h * v[1]);
        let floor = FLOOR * start.iter().zip(inner).map(least).fold(f64::INFINITY, f64::min);
        let mut out = Profile { inner, ends, limits, active, brackets, first, whole, floor };
        if let Some(from) = out.first.last().copied() {
            let last = out.last_w();
            out.brackets[from..].iter_mut().flatten().for_each(|g| *g = with_w(*g, last));
        }
        out
    }

    /// w of the last inner cell for which x and u at its end are those of constant jerk to rest, `x = −3/2 h u`, as a
    /// function of (x, u, ·).
    fn last_w(&self) -> [f64; 3] {
        let (h, l) = (self.inner.last().map_or(1.0, |c| c.h), 1.5 * self.ends[1][0]);
        let rest = h * (h + l);
        [-1.0 / rest, -(2.0 * h + l) / rest, 0.0]
    }

    fn is_last(&self, cell: usize) -> bool {
        cell + 1 == self.inner.len()
    }

    fn row(&self, cell: usize, g: [f64; 3], most: f64) -> Row<3> {
        Row { g: if self.is_last(cell) { with_w(g, self.last_w()) } else { g }, most }
    }

    /// Weight of `1/√x` at the start of stage `i`: the trapezoid rule; over an end cell the time is `3 h / √x`.
    fn weight(&self, i: usize) -> f64 {
        let length = |j: usize| match j {
            0 => 6.0 * self.ends[0][0],
            j => self.inner.get(j - 1).map_or(6.0 * self.ends[1][0], |c| c.h),
        };
        if i == 0 { 0.0 } else { 0.5 * (length(i - 1) + length(i)) / self.whole }
    }

    fn time(&self, v: &[[f64; 3]]) -> f64 {
        v.iter().enumerate().skip(1).map(|(i, v)| self.weight(i) / v[0].sqrt()).sum()
    }

    /// Rows that do not change, then those of jerk (filled in by `refresh`).
    fn stage(&self, i: usize) -> Stage<2, 3> {
        let mut out = Stage::<2, 3>::default();
        let floor = |g: [f64; 3]| Row { g: g.map(|v| -v / self.floor), most: -1.0 };
        let Some(cell) = i.checked_sub(1) else {
            let h = self.ends[0][0];
            out.dynamics = [[0.0, 0.0, 1.5 * h], [0.0, 0.0, 1.0]];
            out.rows.push(Row { g: [0.0, 0.0, 1.5 * h / self.ends[0][1]], most: 1.0 });
            return out;
        };
        let Some(p) = self.inner.get(cell) else {
            out.rows.push(floor([1.0, 0.0, 0.0]));
            out.rows.push(Row { g: [1.0 / self.ends[1][1], 0.0, 0.0], most: 1.0 });
            return out;
        };
        let h = p.h;
        out.dynamics = [[1.0, 2.0 * h, h * h], [0.0, 1.0, h]];
        if self.is_last(cell) {
            let last = self.last_w();
            out.dynamics = out.dynamics.map(|g| with_w(g, last));
            out.hessian[2][2] = 1.0;
        }
        let x = of_x(h);
        out.rows.extend(x.iter().take(2).map(|g| floor(*g)));
        out.rows.extend(x.iter().zip(p.caps()).map(|(g, cap)| self.row(cell, g.map(|v| v / cap), 1.0)));
        for k in 0..AXES {
            if !self.active[cell][k] {
                continue;
            }
            for g in p.acceleration(k) {
                let g = g.map(|v| v / self.limits[k][1]);
                out.rows.push(self.row(cell, g, 1.0));
                out.rows.push(self.row(cell, g.map(|v| -v), 1.0));
            }
        }
        let jerks = 6 * self.count(cell);
        out.rows.extend(std::iter::repeat_n(Row { g: [0.0; 3], most: 1.0 }, jerks));
        out
    }

    fn count(&self, cell: usize) -> usize {
        self.active[cell].iter().filter(|a| **a).count()
    }
}

/// A row with w replaced by a function of the state.
fn with_w(g: [f64; 3], w: [f64; 3]) -> [f64; 3] {
    [g[0] + g[2] * w[0], g[1] + g[2] * w[1], 0.0]
}

impl Model<2, 3> for Profile<'_> {
    fn refresh(&self, i: usize, v: &[f64; 3], stage: &mut Stage<2, 3>) {
        let Some(cell) = i.checked_sub(1) else { return };
        // The time to second order.
        let weight = self.weight(i);
        let x = v[0].max(self.floor);
        let (first, second) = (-0.5 * weight * x.powf(-1.5), 0.75 * weight * x.powf(-2.5));
        stage.hessian[0][0] = second;
        stage.gradient[0] = first - second * v[0];
        let Some(p) = self.inner.get(cell) else { return };
        let mut bernstein = of_x(p.h);
        if self.is_last(cell) {
            let last = self.last_w();
            bernstein = bernstein.map(|g| with_w(g, last));
        }
        let at = bernstein.map(|g| dot(&g, v).max(self.floor));
        let root = at.map(f64::sqrt);
        let count = self.count(cell);
        let mut row = stage.rows.len() - 6 * count;
        for bracket in self.brackets.iter().skip(self.first[cell]).take(count) {
            for b in 0..3 {
                let (g, x) = (&bracket[b], &bernstein[b]);
                for sign in [root[b], -root[b]] {
                    let row_g = std::array::from_fn(|c| sign * g[c] + 0.5 / at[b] * x[c]);
                    if let Some(r) = stage.rows.get_mut(row) {
                        *r = Row { g: row_g, most: 1.5 };
                    }
                    row += 1;
                }
            }
        }
    }
}

/// Axes whose limits of acceleration or jerk may be reached in a cell. Where the limits of one axis bound `|u|` and `√x |w|`
/// so much that another cannot reach its own, the other is left out.
fn decisive(p: &Cell, limits: &Limits) -> [bool; AXES] {
    let least = |q: &[f64; 3]| {
        let one_sign = q.iter().all(|v| *v > 0.0) || q.iter().all(|v| *v < 0.0);
        if one_sign { q.iter().fold(f64::INFINITY, |m, v| m.min(v.abs())) } else { 0.0 }
    };
    let cap = p.cap[0].max(p.cap[1]);
    let speed = cap.sqrt();
    let (mut u, mut w) = (f64::INFINITY, f64::INFINITY);
    for k in 0..AXES {
        u = u.min((limits[k][1] + greatest(&p.q2[k]) * cap) / least(&p.q1[k]));
    }
    let rest = |k: usize| 3.0 * greatest(&p.q2[k]) * u * speed + p.q3[k].abs() * cap * speed;
    for k in 0..AXES {
        w = w.min((limits[k][2] + rest(k)) / least(&p.q1[k]));
    }
    std::array::from_fn(|k| {
        let q = greatest(&p.q1[k]);
        if q == 0.0 && p.q2[k] == [0.0; 2] {
            return false;
        }
        let (a, j) = (q * u + greatest(&p.q2[k]) * cap, q * w + rest(k));
        !(a < limits[k][1] && j < limits[k][2])
    })
}
