//! The least of a convex quadratic function of a spline's control values, within limits.
//!
//! In: a spline of degree 5 with `D` components on given breaks ([`super::quintic`]); for each span
//! its share of the objective `½ xᵀHx + gᵀx`, and limits: rows of factors on the control values of
//! the span, and *strips*, which hold the ordinates of one component on an interval of the span
//! between numbers. Out: control values within the limits, and a bound that no other control values
//! within the limits fall below.
//!
//! ## Method
//! A primal–dual interior point with Mehrotra's predictor and corrector (Nocedal and Wright,
//! *Numerical Optimization*, §16.6). With slacks `t = Gx − l`, `w = u − Gx` and multipliers `y`,
//! `z`, both sides of a row share one line of the system `(H + Gᵀ(Y/T + Z/W)G) dx = …`. It has
//! `6 D − 1` diagonals below the main one ([`Factor`]), so time and memory are linear in the number
//! of spans. Rows are scaled by half their width, the objective by its value at the start.
//!
//! ## Bound
//! With `r = Hx + g − Gᵀ(y − z)` and any `x'` within the limits, convexity gives
//! ```text
//! f(x') ≥ f(x) − Σ y (Gx − l) − Σ z (u − Gx) − Σ |rᵢ| |x'ᵢ − xᵢ|
//! ```
//! The caller says how far apart `x'` and `x` can be.
//!
//! ## Failure
//! [`Missed`] names spans where no control values keep all limits, or numbers are not finite. A
//! step is as long for all rows as the worst allows, so where some contradict one another many
//! others are still missed in the end. Multipliers show which: those of contradicting rows grow
//! without bound (Farkas' lemma), the others do not. The same bytes on any number of threads: sums
//! are taken in a fixed order.

use super::quintic::{Map, ORDER};
use crate::parallel;

/// Spans of a unit of parallel work; fixed, so that sums are taken in the same order.
const CHUNK: usize = 128;
/// Iterations at most.
const MOST: usize = 60;
/// Iterations without progress after which the search ends.
const PATIENCE: usize = 10;
/// Slack times multiplier at the start.
const START: f64 = 100.0;
/// Slack of a row at the start, at least, as a share of half its width.
const SLACK: f64 = 0.1;
/// A row is kept when it is missed by less than this share of half its width.
const KEPT: f64 = 1e-6;
/// Rows that contradict one another pull with multipliers so many times as great as those of half
/// the spans are.
const CONTRADICTS: f64 = 100.0;
/// A pivot that falls below this share of its diagonal entry is rounding: the column depends on
/// those before it.
const PIVOT: f64 = 1e-14;

/// Limits on a sum over the control values of a span: `lo ≤ Σ g[k] · x[k] ≤ hi`. One of the two may
/// be infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SumLimit<const W: usize> {
    /// Factors of the control values, one after another.
    pub g: [f64; W],
    /// Least value.
    pub lo: f64,
    /// Greatest value.
    pub hi: f64,
}

/// Limits on the ordinates of one component on an interval of a span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip<const D: usize> {
    /// From the span's control values to ordinates.
    pub map: Map,
    /// The component is the product with this.
    pub direction: [f64; D],
    /// Least values.
    pub lo: [f64; ORDER],
    /// Greatest values.
    pub hi: [f64; ORDER],
}

/// A span: its share of the objective, and its limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Span<const D: usize, const W: usize> {
    /// Second derivative by the control values, one after another; symmetric.
    pub hessian: Box<[[f64; W]; W]>,
    /// First derivative where all control values are 0.
    pub gradient: [f64; W],
    /// Single limits.
    pub rows: Vec<SumLimit<W>>,
    /// Limits on ordinates.
    pub strips: Vec<Strip<D>>,
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<const D: usize> {
    /// Control values.
    pub x: Vec<[f64; D]>,
    /// The objective less its value where all control values are 0.
    pub objective: f64,
    /// No control values within the limits have less.
    pub bound: f64,
    /// Iterations done.
    pub iterations: usize,
}

/// Why nothing was found: spans whose limits contradict one another, or where that cannot be told
/// all whose limits are missed, with the share of half the width of a row by which they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Missed(pub Vec<(usize, f64)>);

/// One side of a row.
#[derive(Clone, Copy, Debug)]
struct Side {
    /// Infinite where the row has no such side.
    slack: f64,
    /// 1/slack.
    inverse: f64,
    multiplier: f64,
    /// Product of the predictor's changes.
    second: f64,
}

/// A row while it is solved for; its numbers are multiplied by `scale`.
#[derive(Clone, Copy, Debug)]
struct Limit {
    scale: f64,
    value: f64,
    change: f64,
    ends: [f64; 2],
    sides: [Side; 2],
}

const SIGN: [f64; 2] = [1.0, -1.0];

impl Limit {
    fn new(lo: f64, hi: f64) -> Self {
        let half = 0.5 * (hi - lo);
        let scale = if half.is_finite() && half > 0.0 { 1.0 / half } else { 1.0 };
        let ends = [scale * lo, scale * hi];
        let sides = [0, 1].map(|k| {
            let slack = (-SIGN[k] * ends[k]).max(SLACK);
            let inverse = 1.0 / slack;
            Side { slack, inverse, multiplier: START * inverse, second: 0.0 }
        });
        Limit { scale, value: 0.0, change: 0.0, ends, sides }
    }

    /// What a side leaves.
    fn room(&self, k: usize) -> f64 {
        SIGN[k] * (self.value - self.ends[k])
    }

    fn sides(&self) -> impl Iterator<Item = (usize, &Side)> {
        self.sides.iter().enumerate().filter(|(_, s)| s.slack < f64::INFINITY)
    }

    fn missed(&self) -> f64 {
        -self.room(0).min(self.room(1)).min(0.0)
    }

    /// What the row adds to the matrix, for factors that are not scaled.
    fn weight(&self) -> f64 {
        self.scale * self.scale * self.sides().map(|(_, s)| s.multiplier * s.inverse).sum::<f64>()
    }

    /// The same for the right-hand side, towards slack × multiplier = `centre`.
    fn force(&self, centre: f64) -> f64 {
        let of = |(k, s): (usize, &Side)| {
            SIGN[k] * (centre - s.second - s.multiplier * (self.room(k) - s.slack)) * s.inverse
        };
        self.scale * self.sides().map(of).sum::<f64>()
    }

    /// Changes of slack and multiplier of a side.
    fn changes(&self, k: usize, centre: f64) -> [f64; 2] {
        let s = &self.sides[k];
        let d_slack = SIGN[k] * self.change + self.room(k) - s.slack;
        let d_multiplier = (centre - s.second - s.multiplier * d_slack) * s.inverse - s.multiplier;
        [d_slack, d_multiplier]
    }
}

/// When the search ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enough {
    /// Objective and bound differ by less than this share of the objective.
    pub gap: f64,
    /// Or by less than this share of an objective that counts as nothing.
    pub nothing: f64,
}

/// Solves. `at_zero`: the objective where all control values are 0. `reach`: control values within
/// the limits differ by no more than this.
///
/// # Errors
/// [`Missed`], see the module's page.
pub fn solve<const D: usize, const W: usize>(
    spans: &[Span<D, W>],
    at_zero: f64,
    enough: Enough,
    reach: f64,
) -> Result<Solution<D>, Missed> {
    let mut w = Work::new(spans, at_zero);
    let nothing = w.unit * enough.nothing;
    let mut x = vec![0.0; (spans.len() + ORDER - 1) * D];
    let (mut iterations, mut stalls, mut best) = (0, 0, f64::INFINITY);
    let mut state = w.go(0.0, 0.0);
    loop {
        let whole = (w.unit * at_zero + w.objective(&x)).max(nothing);
        let gap = enough.gap * whole;
        let is_kept = state.missed <= KEPT && state.residual <= KEPT;
        let is_enough = is_kept && state.products <= gap && state.gap + w.off_balance(&x) * reach <= gap;
        let progress = state.missed + state.products / whole;
        stalls = if progress < 0.9 * best { 0 } else { stalls + 1 };
        best = best.min(progress);
        if is_enough || iterations == MOST || stalls > PATIENCE || !progress.is_finite() {
            break;
        }
        iterations += 1;
        let Some(factor) = w.factor() else { break };
        let mu = state.products / state.sides.max(1) as f64;
        let (_, ahead) = w.step(&factor, &x, None);
        let left = ahead.left(ahead.length()) / state.products.max(f64::MIN_POSITIVE);
        let centre = mu * left.powi(3).clamp(1e-4, 1.0);
        let (d, ahead) = w.step(&factor, &x, Some(centre));
        let length = (0.995 * ahead.length()).min(1.0);
        if !d.iter().all(|v| v.is_finite()) {
            break;
        }
        x.iter_mut().zip(&d).for_each(|(x, d)| *x += length * d);
        state = w.go(length, centre);
    }
    if !(state.missed <= 10.0 * KEPT) {
        return Err(w.missed());
    }
    let objective = w.objective(&x);
    let bound = (objective - state.gap - w.off_balance(&x) * reach) / w.unit;
    let x = x.chunks_exact(D).map(|c| std::array::from_fn(|d| c[d])).collect();
    Ok(Solution { x, objective: objective / w.unit, bound, iterations })
}

/// What all rows come to.
#[derive(Clone, Copy, Debug, Default)]
struct State {
    /// Slacks times multipliers.
    products: f64,
    /// What the rows leave times multipliers.
    gap: f64,
    sides: usize,
    missed: f64,
    residual: f64,
}

/// What a step would make of slacks and multipliers.
#[derive(Clone, Copy, Debug, Default)]
struct Ahead {
    /// Greatest share of a slack or multiplier that the whole step takes away.
    most: f64,
    /// Slacks times multipliers after a share of the step: coefficients by that share.
    products: [f64; 3],
}

impl Ahead {
    /// The longest step, at most 1, that keeps slacks and multipliers positive.
    fn length(&self) -> f64 {
        1.0 / self.most.max(1.0)
    }

    fn left(&self, length: f64) -> f64 {
        let [a, b, c] = self.products;
        a + length * (b + length * c)
    }
}

/// Consecutive spans and their rows: of each span the single ones, then those of its strips.
struct Chunk<'a, const D: usize, const W: usize> {
    first: usize,
    spans: &'a [Span<D, W>],
    limits: Vec<Limit>,
}

struct Work<'a, const D: usize, const W: usize> {
    chunks: Vec<Chunk<'a, D, W>>,
    /// Unit of the objective: multipliers are of size 1 in it.
    unit: f64,
    /// The objective's matrix, as [`Factor::of`] takes it, and gradient, in that unit.
    hessian: Vec<[f64; W]>,
    gradient: Vec<f64>,
}

impl<'a, const D: usize, const W: usize> Work<'a, D, W> {
    fn new(spans: &'a [Span<D, W>], at_zero: f64) -> Self {
        let of = |(c, spans): (usize, &'a [Span<D, W>])| {
            let ends = |s: &'a Span<D, W>| {
                let strips = s.strips.iter().flat_map(|s| s.lo.into_iter().zip(s.hi));
                s.rows.iter().map(|r| (r.lo, r.hi)).chain(strips)
            };
            let limits = spans.iter().flat_map(ends).map(|(lo, hi)| Limit::new(lo, hi)).collect();
            Chunk { first: c * CHUNK, spans, limits }
        };
        let chunks: Vec<_> = parallel::map(spans.chunks(CHUNK).enumerate(), of);
        let count = chunks.iter().map(|c| c.limits.len()).sum::<usize>().max(1) as f64;
        let unit = if at_zero > 0.0 { count / at_zero } else { 1.0 };
        let controls = (spans.len() + ORDER - 1) * D;
        let (mut hessian, mut gradient) = (vec![[0.0; W]; controls], vec![0.0; controls]);
        for (i, s) in spans.iter().enumerate() {
            for a in 0..W {
                gradient[i * D + a] += unit * s.gradient[a];
                for b in 0..=a {
                    hessian[i * D + a][W - 1 - a + b] += unit * s.hessian[a][b];
                }
            }
        }
        Work { chunks, unit, hessian, gradient }
    }

    fn missed(&self) -> Missed {
        let of = |chunk: &Chunk<D, W>| {
            let mut limits = chunk.limits.iter();
            let worst = |s: &Span<D, W>| {
                let own = limits.by_ref().take(s.rows.len() + ORDER * s.strips.len());
                own.fold([0.0; 2], |[missed, pull], l| {
                    let (by, of) = (l.missed(), l.sides().map(|(_, s)| s.multiplier).fold(0.0, f64::max));
                    [if by <= missed { missed } else { by }, f64::max(pull, of)]
                })
            };
            chunk.spans.iter().map(worst).collect::<Vec<[f64; 2]>>()
        };
        let all: Vec<[f64; 2]> = self.chunks.iter().flat_map(of).collect();
        let mut pulls: Vec<f64> = all.iter().map(|[_, pull]| *pull).collect();
        pulls.sort_by(f64::total_cmp);
        let usual = pulls.get(pulls.len() / 2).copied().unwrap_or(0.0);
        let named = |least: f64| {
            let is_missed = |(_, [by, pull]): &(usize, [f64; 2])| !(*by <= 10.0 * KEPT) && *pull >= least;
            all.iter().copied().enumerate().filter(is_missed).map(|(i, [by, _])| (i, by)).collect::<Vec<_>>()
        };
        let contradicting = named(CONTRADICTS * usual);
        Missed(if contradicting.is_empty() { named(0.0) } else { contradicting })
    }

    /// `Hx`.
    fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; x.len()];
        for (i, row) in self.hessian.iter().enumerate() {
            let first = (W - 1).saturating_sub(i);
            let from = i + first + 1 - W;
            let mut sum = row[W - 1] * x[i];
            for (c, j) in (first..W - 1).zip(from..i) {
                sum += row[c] * x[j];
                out[j] += row[c] * x[i];
            }
            out[i] += sum;
        }
        out
    }

    /// The objective less its value where all control values are 0, in its unit.
    fn objective(&self, x: &[f64]) -> f64 {
        let product = self.product(x);
        x.iter().zip(product.iter().zip(&self.gradient)).map(|(x, (p, g))| x * (0.5 * p + g)).sum()
    }

    /// `Hx + g − Gᵀ force`, the force given for each row.
    fn side(&self, x: &[f64], force: impl Fn(&Limit) -> f64 + Sync) -> Vec<f64> {
        let of = |chunk: &Chunk<D, W>| {
            let mut out = vec![0.0; (chunk.spans.len() + ORDER - 1) * D];
            let mut forces = chunk.limits.iter().map(&force);
            for (i, s) in chunk.spans.iter().enumerate() {
                let out = &mut out[i * D..i * D + W];
                for (row, f) in s.rows.iter().zip(&mut forces) {
                    out.iter_mut().zip(&row.g).for_each(|(o, g)| *o += f * g);
                }
                for strip in &s.strips {
                    let mut sum = [0.0; ORDER];
                    for (weights, f) in strip.map.iter().zip(&mut forces) {
                        sum.iter_mut().zip(weights).for_each(|(s, w)| *s += f * w);
                    }
                    for a in 0..W {
                        out[a] += sum[a / D] * strip.direction[a % D];
                    }
                }
            }
            out
        };
        let each: Vec<Vec<f64>> = parallel::map(&self.chunks, of);
        let mut out = self.product(x);
        out.iter_mut().zip(&self.gradient).for_each(|(o, g)| *o += g);
        for (chunk, local) in self.chunks.iter().zip(&each) {
            out[chunk.first * D..].iter_mut().zip(local).for_each(|(o, l)| *o -= l);
        }
        out
    }

    /// Sum of the absolute values of `Hx + g − Gᵀ(y − z)`.
    fn off_balance(&self, x: &[f64]) -> f64 {
        let pull = |l: &Limit| l.scale * l.sides().map(|(k, s)| SIGN[k] * s.multiplier).sum::<f64>();
        self.side(x, pull).iter().map(|v| v.abs()).sum()
    }

    /// The factor of the matrix of a step.
    fn factor(&self) -> Option<Factor<W>> {
        let of = |chunk: &Chunk<D, W>| {
            let mut out = vec![[0.0; W]; (chunk.spans.len() + ORDER - 1) * D];
            let mut weights = chunk.limits.iter().map(Limit::weight);
            for (i, s) in chunk.spans.iter().enumerate() {
                let out = &mut out[i * D..i * D + W];
                for (row, weight) in s.rows.iter().zip(&mut weights) {
                    for (a, out) in out.iter_mut().enumerate() {
                        let f = weight * row.g[a];
                        out[W - 1 - a..].iter_mut().zip(&row.g).for_each(|(o, g)| *o += f * g);
                    }
                }
                for strip in &s.strips {
                    let mut square = [[0.0; ORDER]; ORDER];
                    for (row, weight) in strip.map.iter().zip(&mut weights) {
                        for j in 0..ORDER {
                            let f = weight * row[j];
                            for k in 0..=j {
                                square[j][k] += f * row[k];
                            }
                        }
                    }
                    for (a, out) in out.iter_mut().enumerate() {
                        let f = strip.direction[a % D];
                        for b in 0..=a {
                            out[W - 1 - a + b] += f * square[a / D][b / D] * strip.direction[b % D];
                        }
                    }
                }
            }
            out
        };
        let each: Vec<Vec<[f64; W]>> = parallel::map(&self.chunks, of);
        let mut band = self.hessian.clone();
        for (chunk, local) in self.chunks.iter().zip(&each) {
            let own = band[chunk.first * D..].iter_mut().zip(local);
            own.for_each(|(o, l)| o.iter_mut().zip(l).for_each(|(o, l)| *o += l));
        }
        Factor::of(band)
    }

    /// A Newton step towards slack × multiplier = `centre`, with the second-order term of the step
    /// before; without a centre, the predictor, of which that term is noted.
    fn step(&mut self, factor: &Factor<W>, x: &[f64], centre: Option<f64>) -> (Vec<f64>, Ahead) {
        let aim = centre.unwrap_or(0.0);
        let mut d = self.side(x, |l| l.force(aim));
        d.iter_mut().for_each(|v| *v = -*v);
        factor.solve(&mut d);
        let of = |chunk: &mut Chunk<D, W>| {
            let mut ahead = Ahead::default();
            let mut limits = chunk.limits.iter_mut();
            let mut note = |limit: &mut Limit, change: f64| {
                limit.change = limit.scale * change;
                for k in 0..2 {
                    let Side { slack, inverse, multiplier, .. } = limit.sides[k];
                    if slack == f64::INFINITY {
                        continue;
                    }
                    let [d_slack, d_multiplier] = limit.changes(k, aim);
                    ahead.most = ahead.most.max(-d_slack * inverse);
                    if -d_multiplier > ahead.most * multiplier {
                        ahead.most = -d_multiplier / multiplier;
                    }
                    let second = d_slack * d_multiplier;
                    let first = slack * d_multiplier + multiplier * d_slack;
                    let products = [slack * multiplier, first, second];
                    ahead.products.iter_mut().zip(products).for_each(|(s, p)| *s += p);
                    if centre.is_none() {
                        limit.sides[k].second = second;
                    }
                }
            };
            for (i, s) in chunk.spans.iter().enumerate() {
                let d = &d[(chunk.first + i) * D..][..W];
                for (row, limit) in s.rows.iter().zip(&mut limits) {
                    note(limit, dot(&row.g, d));
                }
                for strip in &s.strips {
                    let component: [f64; ORDER] = std::array::from_fn(|k| dot(&strip.direction, &d[k * D..]));
                    for (weights, limit) in strip.map.iter().zip(&mut limits) {
                        note(limit, dot(weights, &component));
                    }
                }
            }
            ahead
        };
        let each: Vec<Ahead> = parallel::map(&mut self.chunks, of);
        let all = each.into_iter().fold(Ahead::default(), |a, b| Ahead {
            most: a.most.max(b.most),
            products: std::array::from_fn(|k| a.products[k] + b.products[k]),
        });
        (d, all)
    }

    /// Makes a share of the step, and looks at what that leaves.
    fn go(&mut self, length: f64, centre: f64) -> State {
        let of = |chunk: &mut Chunk<D, W>| {
            let mut out = State::default();
            for l in &mut chunk.limits {
                let changes = [0, 1].map(|k| l.changes(k, centre));
                l.value += length * l.change;
                for (s, [d_slack, d_multiplier]) in l.sides.iter_mut().zip(changes) {
                    if length > 0.0 && s.slack < f64::INFINITY {
                        s.slack += length * d_slack;
                        s.inverse = 1.0 / s.slack;
                        s.multiplier += length * d_multiplier;
                    }
                    s.second = 0.0;
                }
                let missed = l.missed();
                // Not a number is no row that is kept.
                out.missed = if missed >= 0.0 { out.missed.max(missed) } else { f64::INFINITY };
                for (k, s) in l.sides() {
                    let room = l.room(k);
                    out.sides += 1;
                    out.residual = out.residual.max((room - s.slack).abs());
                    out.products += s.slack * s.multiplier;
                    out.gap += room * s.multiplier;
                }
            }
            out
        };
        let each: Vec<State> = parallel::map(&mut self.chunks, of);
        each.into_iter().fold(State::default(), |a, b| State {
            products: a.products + b.products,
            gap: a.gap + b.gap,
            sides: a.sides + b.sides,
            missed: a.missed.max(b.missed),
            residual: a.residual.max(b.residual),
        })
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Cholesky's factor of a symmetric matrix with `W − 1` diagonals below the main one.
#[derive(Clone, Debug)]
pub struct Factor<const W: usize>(Vec<[f64; W]>);

impl<const W: usize> Factor<W> {
    /// Of the rows of the lower half; the last of the `W` numbers of a row is on the diagonal,
    /// those before the first column are 0. A row that depends on those before leaves its unknown
    /// where it is. `None` where a diagonal entry is not positive, or not a number.
    pub fn of(mut band: Vec<[f64; W]>) -> Option<Self> {
        for i in 0..band.len() {
            let (before, rest) = band.split_at_mut(i);
            let row = &mut rest[0];
            let whole = row[W - 1];
            // Number c of this row is in column i + c + 1 − W.
            for c in (W - 1).saturating_sub(i)..W - 1 {
                let other = &before[i + c + 1 - W];
                let shift = W - 1 - c;
                let mut sum = row[c];
                for (a, b) in row[..c].iter().zip(&other[shift..]) {
                    sum -= a * b;
                }
                row[c] = sum * other[W - 1];
            }
            let left = whole - row[..W - 1].iter().map(|v| v * v).sum::<f64>();
            if !(whole > 0.0 && whole.is_finite()) {
                return None;
            }
            row[W - 1] = if left > PIVOT * whole { 1.0 / left.sqrt() } else { 0.0 };
        }
        Some(Factor(band))
    }

    /// Replaces the right-hand side by the solution.
    pub fn solve(&self, rhs: &mut [f64]) {
        for (i, row) in self.0.iter().enumerate() {
            let first = (W - 1).saturating_sub(i);
            let from = i + first + 1 - W;
            let sum: f64 = row[first..W - 1].iter().zip(&rhs[from..i]).map(|(a, b)| a * b).sum();
            rhs[i] = (rhs[i] - sum) * row[W - 1];
        }
        for (i, row) in self.0.iter().enumerate().rev() {
            let first = (W - 1).saturating_sub(i);
            let from = i + first + 1 - W;
            let x = rhs[i] * row[W - 1];
            rhs[i] = x;
            rhs[from..i].iter_mut().zip(&row[first..W - 1]).for_each(|(r, a)| *r -= a * x);
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::quintic::{Breaks, apply};
    use super::*;
    use proptest::prelude::*;

    const ENOUGH: Enough = Enough { gap: 1e-6, nothing: 1e-12 };

    /// `½ Σ (x − wish)²` over control values, shared out to the spans, and one strip for each span.
    fn nearest(breaks: &Breaks, wish: &[f64], limits: &[[f64; 2]]) -> (Vec<Span<1, 6>>, f64) {
        let span = |i: usize| {
            let mut hessian = Box::new([[0.0; 6]; 6]);
            let mut gradient = [0.0; 6];
            for k in 0..6 {
                let spans = (0..breaks.spans()).filter(|j| (*j..*j + 6).contains(&(i + k))).count() as f64;
                hessian[k][k] = 1.0 / spans;
                gradient[k] = -wish[i + k] / spans;
            }
            let map = breaks.ordinates(i, breaks.span(i));
            let [lo, hi] = limits[i].map(|l| [l; 6]);
            Span { hessian, gradient, rows: Vec::new(), strips: vec![Strip { map, direction: [1.0], lo, hi }] }
        };
        let value = 0.5 * wish.iter().map(|w| w * w).sum::<f64>();
        ((0..breaks.spans()).map(span).collect(), value)
    }

    proptest! {
        #[test]
        fn no_values_within_the_limits_have_less_than_the_bound(
            steps in prop::collection::vec(0.3..2.0f64, 2..7),
            wish in prop::collection::vec(-1.0..1.0f64, 12),
            widths in prop::collection::vec(0.05..1.5f64, 7),
            tries in prop::collection::vec(prop::collection::vec(-1.0..1.0f64, 12), 8),
        ) {
            let mut s = vec![0.0];
            steps.iter().for_each(|d| s.push(s[s.len() - 1] + d));
            let breaks = Breaks::new(s).unwrap();
            let wish = &wish[..breaks.controls()];
            let limits: Vec<[f64; 2]> = (0..breaks.spans()).map(|i| [-widths[i], 0.7 * widths[i]]).collect();
            let (spans, at_zero) = nearest(&breaks, wish, &limits);
            let found = solve(&spans, at_zero, ENOUGH, 1e3).unwrap();
            prop_assert!(found.bound <= found.objective + 1e-12);
            prop_assert!(found.objective - found.bound <= 1e-5 * at_zero + 1e-6, "{} {}", found.objective, found.bound);
            let ordinates = |x: &[[f64; 1]], i: usize| apply(&spans[i].strips[0].map, &x[i..]);
            for i in 0..breaks.spans() {
                for [v] in ordinates(&found.x, i) {
                    prop_assert!(limits[i][0] - 1e-5 <= v && v <= limits[i][1] + 1e-5);
                }
            }
            // Others, made small enough to keep the limits.
            for other in tries {
                let x: Vec<[f64; 1]> = other[..breaks.controls()].iter().map(|v| [*v]).collect();
                let over = |i: usize| {
                    ordinates(&x, i).iter().map(|[v]| (v / limits[i][1]).max(v / limits[i][0])).fold(0.0, f64::max)
                };
                let most = (0..breaks.spans()).map(over).fold(1.0, f64::max);
                let value: f64 = x.iter().zip(wish).map(|([v], w)| 0.5 * (v / most - w).powi(2)).sum();
                prop_assert!(value - at_zero >= found.bound - 1e-9, "{value} {at_zero} {found:?}");
            }
        }
    }

    #[test]
    fn one_active_limit_in_closed_form() {
        // The nearest control values to 0 whose span is nowhere under 1: all are 1.
        let breaks = Breaks::new(vec![0.0, 1.0]).unwrap();
        let (mut spans, _) = nearest(&breaks, &[0.0; 6], &[[1.0, f64::INFINITY]]);
        let found = solve(&spans, 1.0, ENOUGH, 10.0).unwrap();
        assert!(found.x.iter().all(|[v]| (v - 1.0).abs() < 1e-4), "{:?}", found.x);
        assert!((found.objective - 3.0).abs() < 1e-4);
        // A row on their sum alone: the same.
        spans[0].strips.clear();
        spans[0].rows.push(SumLimit { g: [1.0; 6], lo: 6.0, hi: 8.0 });
        let found = solve(&spans, 1.0, ENOUGH, 10.0).unwrap();
        assert!((found.objective - 3.0).abs() < 1e-4 && found.bound <= 3.0 + 1e-9);
    }

    #[test]
    fn limits_against_one_another_are_named() {
        let breaks = Breaks::new(vec![0.0, 1.0, 2.0, 3.0]).unwrap();
        let (mut spans, at_zero) = nearest(&breaks, &[0.5; 8], &[[-1.0, 1.0]; 3]);
        spans[1].rows.push(SumLimit { g: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], lo: 3.0, hi: 4.0 });
        spans[1].rows.push(SumLimit { g: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], lo: -4.0, hi: -3.0 });
        let Missed(missed) = solve(&spans, at_zero, ENOUGH, 1e3).unwrap_err();
        assert!(missed.iter().any(|(i, by)| *i == 1 && *by > 1.0), "{missed:?}");
        spans[1].rows[0].lo = f64::NAN;
        assert!(solve(&spans, at_zero, ENOUGH, 1e3).is_err());
    }

    /// Among hundreds of spans that all begin outside their limits, those that contradict one
    /// another are told from those that a short step left where they were.
    #[test]
    fn only_limits_against_one_another_are_named() {
        const SPANS: usize = 300;
        let breaks = Breaks::new((0..=SPANS).map(|k| k as f64).collect()).unwrap();
        let limits: Vec<[f64; 2]> = (0..SPANS).map(|i| [2.0 + 0.1 * (i % 7) as f64, 4.0]).collect();
        let (mut spans, at_zero) = nearest(&breaks, &vec![0.5; SPANS + 5], &limits);
        assert!(solve(&spans, at_zero, ENOUGH, 1e3).is_ok());
        for at in [40, 220] {
            spans[at].rows.push(SumLimit { g: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], lo: 3.0, hi: 4.0 });
            spans[at].rows.push(SumLimit { g: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], lo: -4.0, hi: 1.0 });
        }
        let Missed(missed) = solve(&spans, at_zero, ENOUGH, 1e3).unwrap_err();
        let is_near = |i: usize| i.abs_diff(40) <= 5 || i.abs_diff(220) <= 5;
        assert!(!missed.is_empty() && missed.iter().all(|(i, _)| is_near(*i)), "{missed:?}");
    }

    #[test]
    fn factors_solve() {
        // 4 on the diagonal, 1 beside it.
        let mut band = vec![[0.0, 1.0, 4.0]; 9];
        band[0] = [0.0, 0.0, 4.0];
        let want: Vec<f64> = (0..9).map(f64::from).collect();
        let at = |k: i32| if (0..9).contains(&k) { f64::from(k) } else { 0.0 };
        let mut x: Vec<f64> = (0..9).map(|k| at(k - 1) + 4.0 * at(k) + at(k + 1)).collect();
        let factor = Factor::<3>::of(band).unwrap();
        factor.solve(&mut x);
        assert!(x.iter().zip(&want).all(|(a, b)| (a - b).abs() < 1e-12));
        assert!(Factor::<2>::of(vec![[0.0, -1.0]]).is_none() && Factor::<2>::of(vec![[0.0, f64::NAN]]).is_none());
    }
}
