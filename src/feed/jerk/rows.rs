//! The limits over cells as rows that are linear in `(x, u, w)`, and what multipliers of them come
//! to.

use std::ops::Range;

use crate::artifact::Axes;

use super::cells::{Cell, Derivatives, Limits, dot, greatest, mixed, of_x, places_of_x};

/// The path between the end cells.
pub(super) struct Problem<'a> {
    pub inner: &'a [Cell<'a>],
    /// Length and greatest x of the end cells.
    pub ends: [[f64; 2]; 2],
    pub limits: &'a Limits,
}

impl Problem<'_> {
    /// Weights of `1/√x` at the Bernstein coefficients of x of a cell: their sum is at least the
    /// time over the cell. Over an end cell the time is `3 h / √x`.
    pub fn weights(&self, cell: usize) -> [f64; 3] {
        let mut out = [self.inner[cell].h / 3.0; 3];
        if cell == 0 {
            out[0] += 3.0 * self.ends[0][0];
        }
        if cell + 1 == self.inner.len() {
            out[2] += 3.0 * self.ends[1][0];
        }
        out
    }

    /// Greatest Bernstein coefficients of x in a cell.
    pub fn caps(&self, cell: usize) -> [f64; 3] {
        let mut out = self.inner[cell].caps();
        if cell == 0 {
            out[0] = out[0].min(self.ends[0][1]);
        }
        if cell + 1 == self.inner.len() {
            out[2] = out[2].min(self.ends[1][1]);
        }
        out
    }

    /// Bernstein coefficients of x in a cell.
    pub fn x(&self, cell: usize, v: &[f64; 3]) -> [f64; 3] {
        of_x(self.inner[cell].h).map(|g| dot(&g, v))
    }

    /// The time over cells from one on, from above.
    pub fn time(&self, from: usize, v: &[[f64; 3]]) -> f64 {
        let of = |(i, v): (usize, &[f64; 3])| {
            let (weights, x) = (self.weights(from + i), self.x(from + i, v));
            (0..3).map(|b| weights[b] / x[b].sqrt()).sum::<f64>()
        };
        v.iter().enumerate().map(of).sum()
    }
}

/// The bracket of an axis' jerk over its limit, at place `b` of [`SHARES_OF_X`]: `g · v ≤ 1/√x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jerk {
    pub b: usize,
    pub g: [f64; 3],
}

/// Rows that have reached less of their limits than this are left out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares {
    pub accelerations: f64,
    pub others: f64,
}

impl Shares {
    pub const ALL: Shares = Shares { accelerations: f64::NEG_INFINITY, others: f64::NEG_INFINITY };
}

/// The rows of some cells.
pub(super) struct JerkRows {
    /// Of caps and accelerations: `g · v ≤ 1`.
    linear: Vec<[f64; 3]>,
    jerk: Vec<Jerk>,
    /// Where those of each cell begin.
    first: Vec<[usize; 2]>,
}

impl JerkRows {
    /// Of the cells in a range, all that have reached a share of their limit at `v`: one for caps
    /// and jerks, one for accelerations.
    pub fn of(problem: &Problem, range: Range<usize>, v: &[[f64; 3]], shares: Shares) -> JerkRows {
        let mut out = JerkRows { linear: Vec::new(), jerk: Vec::new(), first: vec![[0; 2]] };
        for (i, v) in range.zip(v) {
            let (c, x, limits) = (&problem.inner[i], problem.x(i, v), problem.limits);
            let caps = of_x(c.h).into_iter().zip(problem.caps(i)).map(|(g, cap)| g.map(|v| v / cap));
            out.linear.extend(caps.filter(|g| dot(g, v) > shares.others));
            let active = decisive(c, limits);
            for (axis, [_, a_max, j_max]) in
                c.axes.iter().zip(limits.iter()).zip(active.iter()).filter_map(|(a, on)| on.then_some(a))
            {
                for g in c.acceleration(axis).iter() {
                    let signed = [1.0, -1.0].map(|sign| g.map(|v| sign * v / a_max));
                    out.linear.extend(signed.into_iter().filter(|g| dot(g, v) > shares.accelerations));
                }
                let brackets = c.bracket(axis);
                for (b, g) in places_of_x(brackets.len()).iter().copied().zip(brackets.iter()) {
                    let signed = [1.0, -1.0].map(|sign| g.map(|v| sign * v / j_max));
                    let near = signed.into_iter().filter(|g| dot(g, v) * mixed(&x, b).sqrt() > shares.others);
                    out.jerk.extend(near.map(|g| Jerk { b, g }));
                }
            }
            out.first.push([out.linear.len(), out.jerk.len()]);
        }
        out
    }

    pub fn linear(&self, cell: usize) -> &[[f64; 3]] {
        &self.linear[self.first[cell][0]..self.first[cell + 1][0]]
    }

    pub fn jerk(&self, cell: usize) -> &[Jerk] {
        &self.jerk[self.first[cell][1]..self.first[cell + 1][1]]
    }

    /// What multipliers of a cell's rows, linear ones first, come to. `h`: the cell's length.
    pub fn dual(&self, cell: usize, h: f64, multipliers: &[f64]) -> Dual {
        let mut out = Dual::default();
        let (linear, jerk) = multipliers.split_at(self.linear(cell).len());
        for (y, g) in linear.iter().zip(self.linear(cell)) {
            add(&mut out.linear, *y, g, h);
            out.most += y;
        }
        for (y, j) in jerk.iter().zip(self.jerk(cell)) {
            add(&mut out.jerk[j.b], *y, &j.g, h);
            out.sum[j.b] += y;
        }
        let finite = out.most + out.linear.iter().chain(out.jerk.iter().flatten()).chain(&out.sum).sum::<f64>();
        // Any multipliers will do: none, where a search has lost its way.
        if finite.is_finite() { out } else { Dual::default() }
    }
}

/// Multipliers of a cell's rows, summed up: what the Lagrangian has besides the time, by the
/// Bernstein coefficients of x.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Dual {
    /// Of caps and accelerations: factors of the coefficients.
    pub linear: [f64; 3],
    /// … and what they add up to at the limits.
    pub most: f64,
    /// Of the jerk at each place of [`SHARES_OF_X`]: factors of the coefficients.
    pub jerk: [[f64; 3]; 6],
    /// … and their sum, the factor of `−1/√x` there.
    pub sum: [f64; 6],
}

/// Adds a multiple of a row in `(x, u, w)` to one in the Bernstein coefficients of x.
fn add(to: &mut [f64; 3], factor: f64, g: &[f64; 3], h: f64) {
    let (u, w) = (g[1] / h, g[2] / (h * h));
    for (t, g) in to.iter_mut().zip([g[0] - u + w, u - 2.0 * w, w]) {
        *t += factor * g;
    }
}

/// Axes whose limits of acceleration or jerk may be reached in a cell. Where the limits of one axis
/// bound `|u|` and `√x |w|` so much that another cannot reach its own, the other is left out.
fn decisive(p: &Cell, limits: &Limits) -> Axes<bool> {
    let least = |q: &[f64]| {
        let one_sign = q.iter().all(|v| *v > 0.0) || q.iter().all(|v| *v < 0.0);
        if one_sign { q.iter().fold(f64::INFINITY, |m, v| m.min(v.abs())) } else { 0.0 }
    };
    let cap = p.cap[0].max(p.cap[1]);
    let speed = cap.sqrt();
    let (mut u, mut w) = (f64::INFINITY, f64::INFINITY);
    let each = || p.axes.iter().zip(limits.iter());
    for (axis, [_, a_max, _]) in each() {
        u = u.min((a_max + greatest(axis.second()) * cap) / least(axis.first()));
    }
    let rest = |axis: &Derivatives| 3.0 * greatest(axis.second()) * u * speed + greatest(axis.third()) * cap * speed;
    for (axis, [_, _, j_max]) in each() {
        w = w.min((j_max + rest(axis)) / least(axis.first()));
    }
    Axes::from_fn(limits.len(), |k| {
        let (axis, [_, a_max, j_max]) = (&p.axes[k], limits[k]);
        let q = greatest(axis.first());
        if q == 0.0 && axis.second().iter().all(|v| *v == 0.0) {
            return false;
        }
        let (a, j) = (q * u + greatest(axis.second()) * cap, q * w + rest(axis));
        !(a < a_max && j < j_max)
    })
}
