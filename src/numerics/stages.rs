//! Convex problems along a line of stages, in linear time: a primal–dual interior-point method
//! whose linear systems are solved by a Riccati recursion.
//!
//! ```text
//! minimise  Σ ½ vᵀ H v + fᵀ v      v = (x, u) at every stage, X state components, V − X controls
//! such that x(next) = D v          (linear dynamics)
//!           g · v ≤ most           (any number of rows at every stage)
//! ```
//!
//! In: [`Stage`]s, a trajectory that follows the dynamics. Out: [`Solution`]: the trajectory, the
//! multipliers of the rows and the costates. Method: Mehrotra's predictor and corrector (Nocedal
//! and Wright, *Numerical Optimization*, ch. 16) on slacks of the rows; each Newton system is a
//! linear-quadratic problem (Rao, Wright and Rawlings 1998, "Application of interior-point methods
//! to model predictive control", JOTA 99). Because states are kept beside their differences, the
//! systems stay well conditioned where second differences of thousands of values would not.
//!
//! [`Model::refresh`] may change `H`, `f` and the rows after every step: a convex objective that is
//! not quadratic, or rows that are tangents of curved ones, are then solved by Newton's method in
//! the same iterations.
//!
//! Guaranteed: the trajectory follows the dynamics; linear time and memory per iteration; the same
//! result on any number of threads (there is one). Not guaranteed: that rows hold where no
//! trajectory satisfies all: [`Solution::excess`] is by how much the worst row is missed.

mod dense;

use dense::{first_state, invert_controls};

/// One inequality `g · v ≤ most`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inequality<const V: usize> {
    /// Coefficients.
    pub g: [f64; V],
    /// Right-hand side.
    pub most: f64,
}

/// One stage.
#[derive(Clone, Debug)]
pub struct Stage<const X: usize, const V: usize> {
    /// The next stage's state is `dynamics · v`.
    pub dynamics: [[f64; V]; X],
    /// Second derivative of the objective, symmetric, positive semidefinite.
    pub hessian: [[f64; V]; V],
    /// Linear part of the objective.
    pub gradient: [f64; V],
    /// Inequalities.
    pub rows: Vec<Inequality<V>>,
}

impl<const X: usize, const V: usize> Default for Stage<X, V> {
    fn default() -> Self {
        Stage { dynamics: [[0.0; V]; X], hessian: [[0.0; V]; V], gradient: [0.0; V], rows: Vec::new() }
    }
}

/// Changes stages between iterations; `()` changes nothing.
pub trait Model<const X: usize, const V: usize> {
    /// Brings stage `index` up to date at `v`, where its rows have these multipliers (before the
    /// first step there are none); the number of rows must stay.
    fn refresh(&self, index: usize, v: &[f64; V], multipliers: &[f64], stage: &mut Stage<X, V>);
}

impl<const X: usize, const V: usize> Model<X, V> for () {
    fn refresh(&self, _: usize, _: &[f64; V], _: &[f64], _: &mut Stage<X, V>) {}
}

/// Options of [`solve`].
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Components of the first state that keep their value.
    pub fixed: [bool; 8],
    /// Iterations at most.
    pub iterations: usize,
    /// Ends where the mean of slack × multiplier is below this (objective and rows of size 1).
    pub tolerance: f64,
    /// … and no row is missed by more than this.
    pub excess: f64,
    /// Least slack at the start.
    pub slack: f64,
    /// Slack × multiplier at the start.
    pub barrier: f64,
    /// The start keeps all rows, and rows that change only widen for an iterate that keeps them.
    /// All iterates then keep all rows, and each of them is an answer.
    pub interior: bool,
    /// Within the limits and the tolerance it goes on while every step gains much, down to this
    /// share of the tolerance.
    pub further: f64,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            fixed: [false; 8],
            iterations: 80,
            tolerance: 1e-10,
            excess: 1e-9,
            slack: 1e-2,
            barrier: 1e-2,
            interior: false,
            further: 1e-5,
        }
    }
}

/// Within the tolerance, steps that leave less than this share of slack × multiplier are worth
/// making.
const FAST: f64 = 0.2;

/// What was found.
#[derive(Clone, Debug)]
pub struct Solution<const X: usize, const V: usize> {
    /// State and controls at every stage.
    pub v: Vec<[f64; V]>,
    /// Multipliers of the rows, stage by stage.
    pub multipliers: Vec<f64>,
    /// Costates: derivative of the least objective by the state of each stage.
    pub costates: Vec<[f64; X]>,
    /// Iterations done.
    pub iterations: usize,
    /// Mean of slack × multiplier at the end.
    pub complementarity: f64,
    /// Greatest amount by which a row is missed.
    pub excess: f64,
    /// Ended within the tolerance.
    pub converged: bool,
}

fn dot<const V: usize>(a: &[f64; V], b: &[f64; V]) -> f64 {
    let mut sum = 0.0;
    for i in 0..V {
        sum += a[i] * b[i];
    }
    sum
}

/// What the recursion keeps of one stage.
#[derive(Clone, Copy)]
struct Gain<const X: usize, const V: usize> {
    /// Cost to go at this stage's state.
    cost: [[f64; X]; X],
    /// Rows `X..V`: controls as linear functions of the state.
    feedback: [[f64; X]; V],
    /// Inverse of the controls' block, in the places of the controls.
    inverse: [[f64; V]; V],
}

/// Working memory of one run.
struct Work<const X: usize, const V: usize> {
    first: Vec<usize>,
    slack: Vec<f64>,
    /// 1/slack.
    inverse: Vec<f64>,
    multiplier: Vec<f64>,
    residual: Vec<f64>,
    d_slack: Vec<f64>,
    d_multiplier: Vec<f64>,
    gains: Vec<Gain<X, V>>,
    /// Right-hand sides, then `p` of the cost to go in the state's places.
    side: Vec<[f64; V]>,
    d: Vec<[f64; V]>,
    /// Slack × multiplier and their changes' product, over all rows.
    products: f64,
    second: f64,
    /// Greatest amount by which a row is missed.
    excess: f64,
    /// A slack is not what its row leaves.
    missed: bool,
}

/// Solves; `start` must follow the dynamics (for the last stage only its own state and controls
/// count).
///
/// Returns `None` where lengths do not fit or a number is not finite. Where a system cannot be
/// solved, as near the limit of rounding, it returns the last iterate.
pub fn solve<const X: usize, const V: usize>(
    stages: &mut [Stage<X, V>],
    start: &[[f64; V]],
    model: &impl Model<X, V>,
    options: &Options,
) -> Option<Solution<X, V>> {
    let n = stages.len();
    if n == 0 || start.len() != n || X > V || X > options.fixed.len() {
        return None;
    }
    let mut v = start.to_vec();
    for (i, s) in stages.iter_mut().enumerate() {
        model.refresh(i, &v[i], &[], s);
    }
    let mut w = Work::new(stages, &v, options);
    if !w.residual.iter().all(|r| r.is_finite()) {
        return None;
    }
    let rows = w.slack.len();
    let mut out = Solution {
        v: Vec::new(),
        multipliers: Vec::new(),
        costates: vec![[0.0; X]; n],
        iterations: 0,
        complementarity: f64::INFINITY,
        excess: f64::INFINITY,
        converged: false,
    };
    let (mut stationarity, mut before) = (1.0, f64::INFINITY);
    for iteration in 0..options.iterations {
        let mu = w.products / rows.max(1) as f64;
        (out.iterations, out.complementarity, out.excess) = (iteration, mu, w.excess);
        let enough = mu < options.tolerance && w.excess <= options.excess && stationarity < 1e-6;
        // An iterate within the limits goes on while each step gains much.
        let gains = options.interior && mu < FAST * before && mu > options.further * options.tolerance;
        if rows > 0 && enough && !gains || rows == 0 && iteration > 1 {
            out.converged = true;
            break;
        }
        before = mu;
        let Some(begun) = w.factor(stages).and_then(|()| w.step(stages, &v, None, options)) else { break };
        let length = begun.length(1.0);
        let centre = mu * w.left(length).powi(3);
        let Some(stepped) = w.step(stages, &v, Some(centre), options) else { break };
        if !w.d.iter().flatten().all(|x| x.is_finite()) {
            break;
        }
        let length = stepped.length(if mu < 1e-6 { 0.999 } else { 0.99 });
        stationarity *= 1.0 - length;
        for i in 0..n {
            for k in 0..V {
                v[i][k] += length * w.d[i][k];
            }
            let gain = &w.gains[i];
            for a in 0..X {
                out.costates[i][a] = w.side[i][a] + (0..X).map(|b| gain.cost[a][b] * w.d[i][b]).sum::<f64>();
            }
        }
        if !v.iter().all(|a| a.iter().all(|x| x.is_finite())) {
            return None;
        }
        w.go(stages, &v, model, length, options);
        if length < 1e-9 {
            break;
        }
    }
    (out.v, out.multipliers) = (v, w.multiplier);
    Some(out)
}

impl<const X: usize, const V: usize> Work<X, V> {
    fn new(stages: &[Stage<X, V>], v: &[[f64; V]], options: &Options) -> Self {
        let mut first = Vec::with_capacity(stages.len() + 1);
        first.push(0);
        let mut slack = Vec::new();
        for (s, v) in stages.iter().zip(v) {
            let least = if options.interior { f64::MIN_POSITIVE } else { options.slack };
            slack.extend(s.rows.iter().map(|r| (r.most - dot(&r.g, v)).max(least)));
            first.push(slack.len());
        }
        let multiplier = slack.iter().map(|t| options.barrier / t).collect();
        let inverse = slack.iter().map(|t| 1.0 / t).collect();
        let (m, n) = (slack.len(), stages.len());
        let mut out = Work {
            first,
            slack,
            inverse,
            multiplier,
            residual: vec![0.0; m],
            d_slack: vec![0.0; m],
            d_multiplier: vec![0.0; m],
            gains: vec![Gain { cost: [[0.0; X]; X], feedback: [[0.0; X]; V], inverse: [[0.0; V]; V] }; n],
            side: vec![[0.0; V]; n],
            d: vec![[0.0; V]; n],
            products: 0.0,
            second: 0.0,
            excess: 0.0,
            missed: false,
        };
        for (i, s) in stages.iter().enumerate() {
            out.look(i, s, &v[i], false);
        }
        out
    }

    /// Makes a step of a length along what was found, in the multipliers and the slacks; the
    /// trajectory has made it.
    fn go(
        &mut self,
        stages: &mut [Stage<X, V>],
        v: &[[f64; V]],
        model: &impl Model<X, V>,
        length: f64,
        options: &Options,
    ) {
        (self.products, self.excess, self.missed) = (0.0, 0.0, false);
        for (i, s) in stages.iter_mut().enumerate() {
            let rows = self.first[i]..self.first[i + 1];
            for k in rows.clone() {
                self.slack[k] += length * self.d_slack[k];
                self.multiplier[k] += length * self.d_multiplier[k];
            }
            model.refresh(i, &v[i], &self.multiplier[rows], s);
            self.look(i, s, &v[i], options.interior);
        }
    }

    /// What the rows of a stage leave; `follow`: that is their slack, but for rounding.
    fn look(&mut self, i: usize, s: &Stage<X, V>, v: &[f64; V], follow: bool) {
        for (k, r) in (self.first[i]..).zip(&s.rows) {
            let room = r.most - dot(&r.g, v);
            if follow && room > 0.0 {
                self.slack[k] = room;
            }
            self.residual[k] = room - self.slack[k];
            self.missed |= self.residual[k] != 0.0;
            self.inverse[k] = 1.0 / self.slack[k];
            self.products += self.slack[k] * self.multiplier[k];
            self.excess = self.excess.max(-room);
        }
    }

    /// The share of slack × multiplier that the predictor leaves after a step of a length.
    fn left(&self, length: f64) -> f64 {
        let left = (1.0 - length) * self.products + length * length * self.second;
        if self.products > 0.0 { left / self.products } else { 0.0 }
    }

    /// The backward recursion on `H + Gᵀ (λ/t) G`.
    fn factor(&mut self, stages: &[Stage<X, V>]) -> Option<()> {
        let mut cost = [[0.0; X]; X];
        for (i, s) in stages.iter().enumerate().rev() {
            let mut m = s.hessian;
            for (k, r) in (self.first[i]..).zip(&s.rows) {
                let weight = self.multiplier[k] * self.inverse[k];
                for a in 0..V {
                    let g = weight * r.g[a];
                    if g != 0.0 {
                        for b in 0..=a {
                            m[a][b] += g * r.g[b];
                        }
                    }
                }
            }
            let last = i + 1 == stages.len();
            if !last {
                // P D, then Dᵀ P D; the lower half is enough.
                let mut pd = [[0.0; V]; X];
                for a in 0..X {
                    for c in 0..X {
                        let p = cost[a][c];
                        for b in 0..V {
                            pd[a][b] += p * s.dynamics[c][b];
                        }
                    }
                }
                for c in 0..X {
                    for a in 0..V {
                        let d = s.dynamics[c][a];
                        if d != 0.0 {
                            for b in 0..=a {
                                m[a][b] += d * pd[c][b];
                            }
                        }
                    }
                }
            }
            for a in X..V {
                // A control that nothing asks for stays.
                m[a][a] += if m[a][a] > 0.0 { 1e-13 } else { 1.0 };
            }
            let gain = &mut self.gains[i];
            gain.inverse = invert_controls::<X, V>(&m)?;
            for u in X..V {
                for x in 0..X {
                    gain.feedback[u][x] = -(X..V).map(|w| gain.inverse[u][w] * m[w][x]).sum::<f64>();
                }
            }
            for a in 0..X {
                for b in 0..=a {
                    let p = m[a][b] + (X..V).map(|u| m[u][a] * gain.feedback[u][b]).sum::<f64>();
                    (cost[a][b], cost[b][a]) = (p, p);
                }
            }
            gain.cost = cost;
        }
        Some(())
    }

    /// A Newton step towards slack × multiplier = `centre`, with the second-order term of the step
    /// before; without a centre, the predictor: towards 0, to first order.
    fn step(
        &mut self,
        stages: &[Stage<X, V>],
        v: &[[f64; V]],
        centre: Option<f64>,
        options: &Options,
    ) -> Option<StepReach> {
        let n = stages.len();
        let mut next = [0.0; X];
        for (i, s) in stages.iter().enumerate().rev() {
            let mut g = s.gradient;
            for a in 0..V {
                g[a] += dot(&s.hessian[a], &v[i]);
            }
            if centre.is_some() || self.missed {
                let k = self.first[i]..self.first[i + 1];
                let (y, inverse, residual) =
                    (&self.multiplier[k.clone()], &self.inverse[k.clone()], &self.residual[k.clone()]);
                let (d_slack, d_y) = (&self.d_slack[k.clone()], &self.d_multiplier[k]);
                for (k, r) in s.rows.iter().enumerate().take(y.len()) {
                    let target = centre.map_or(0.0, |c| c - d_slack[k] * d_y[k]);
                    let force = (target - y[k] * residual[k]) * inverse[k];
                    for a in 0..V {
                        g[a] += force * r.g[a];
                    }
                }
            }
            if i + 1 < n {
                for c in 0..X {
                    for a in 0..V {
                        g[a] += s.dynamics[c][a] * next[c];
                    }
                }
            }
            let gain = &self.gains[i];
            for x in 0..X {
                next[x] = g[x] + (X..V).map(|u| gain.feedback[u][x] * g[u]).sum::<f64>();
            }
            let mut side = [0.0; V];
            side[..X].copy_from_slice(&next);
            for u in X..V {
                side[u] = -(X..V).map(|w| gain.inverse[u][w] * g[w]).sum::<f64>();
            }
            self.side[i] = side;
        }
        let mut x = first_state::<X, V>(&self.gains[0].cost, &self.side[0], &options.fixed)?;
        let mut reach = StepReach::default();
        self.second = 0.0;
        for (i, s) in stages.iter().enumerate() {
            let mut d = [0.0; V];
            d[..X].copy_from_slice(&x);
            for u in X..V {
                d[u] = self.side[i][u] + (0..X).map(|a| self.gains[i].feedback[u][a] * x[a]).sum::<f64>();
            }
            for c in 0..X {
                x[c] = dot(&s.dynamics[c], &d);
            }
            let k = self.first[i]..self.first[i + 1];
            let (slack, y, inverse) = (&self.slack[k.clone()], &self.multiplier[k.clone()], &self.inverse[k.clone()]);
            let residual = &self.residual[k.clone()];
            let (d_slack, d_y) = (&mut self.d_slack[k.clone()], &mut self.d_multiplier[k]);
            for (k, r) in s.rows.iter().enumerate().take(slack.len()) {
                let target = centre.map_or(0.0, |c| c - d_slack[k] * d_y[k]);
                let change = residual[k] - dot(&r.g, &d);
                let of_y = (target - y[k] * (slack[k] + change)) * inverse[k];
                (d_slack[k], d_y[k]) = (change, of_y);
                self.second += change * of_y;
                reach.bind(slack[k], change);
                reach.bind(y[k], of_y);
            }
            self.d[i] = d;
        }
        Some(reach)
    }
}

/// How far a step can be gone: `1/most` with positive numbers kept positive.
#[derive(Clone, Copy, Default)]
struct StepReach {
    most: f64,
}

impl StepReach {
    fn bind(&mut self, value: f64, change: f64) {
        if -change > self.most * value {
            self.most = -change / value;
        }
    }

    /// The share `most` of the longest step, at most 1.
    fn length(self, most: f64) -> f64 {
        if self.most > most { most / self.most } else { 1.0 }
    }
}

#[cfg(test)]
mod tests;
