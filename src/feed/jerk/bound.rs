//! The least time that any profile can take, proved by multipliers.
//!
//! A profile is a chain of parabolas `x(s)`: its Bernstein coefficients are `x` at the joints and
//! one more in each cell, tied by `u` being the same on both sides of every joint. The time and all
//! limits are sums over these coefficients. With any multipliers `y ≥ 0` of the limits and any `r`
//! of the ties
//!
//! ```text
//! time ≥ min Σ (c − Σ y_jerk)/√x + k x − Σ y      over  0 < x ≤ cap,      k linear in y and r
//! ```
//!
//! and the least of each term is known in closed form, if only `c ≥ Σ y_jerk`; where that is not so
//! multipliers of jerk are made smaller. So the bound holds for all profiles on the grid that keep
//! the limits by their Bernstein coefficients, however far a search has come and although its
//! problem is not convex: multipliers only make the bound a good one. It is concave in `r`, and is
//! raised by one `r` after another.

use std::ops::Range;

use super::PER_THREAD;
use super::cells::SHARES_OF_X;
use super::rows::{Dual, Problem};
use crate::parallel;

/// Rounds in which every `r` is moved once end where they gain less than this share of the bound.
const ENOUGH: f64 = 1e-4;
/// Cuts of the way on which an `r` is moved, at most; they end where the derivative is less than
/// this share of the first.
const CUTS: usize = 8;
const FLAT: f64 = 1e-2;
/// Multipliers of jerk add up to at most this share of the time's weight.
const MOST: f64 = 0.999;

/// A time over a range of cells that no profile is shorter than, whatever it does before and after.
/// `r`: where the ties' multipliers begin, at the start of every cell; `rounds`: how often each is
/// moved at most.
pub(super) fn least_time(problem: &Problem, range: Range<usize>, duals: &[Dual], r: &[f64], rounds: usize) -> f64 {
    let bound = Bound::new(problem, range.clone(), duals);
    let n = range.len();
    let mut r: Vec<f64> = r.iter().chain([&0.0]).map(|r| if r.is_finite() { *r } else { 0.0 }).collect();
    // Where the path goes on there is no tie.
    let tied = usize::from(range.start > 0)..n + usize::from(range.end == problem.inner.len());
    r[0] *= f64::from(u8::from(tied.start == 0));
    let mut best = bound.value(&r);
    for _ in 0..rounds {
        // Each depends on its neighbours: every other one at the same time.
        for parity in 0..2 {
            let moved = (tied.start + parity..tied.end).step_by(2);
            let moved = parallel::map_short(PER_THREAD, moved, |j| bound.raised(&r, j));
            r[tied.clone()].iter_mut().skip(parity).step_by(2).zip(moved).for_each(|(r, to)| *r = to);
        }
        let value = bound.value(&r);
        let enough = value - best < ENOUGH * value.abs();
        best = best.max(value);
        if enough {
            break;
        }
    }
    // Without multipliers: everywhere as fast as the caps allow.
    best.max(Bound::new(problem, range, &vec![Dual::default(); n]).value(&vec![0.0; n + 1]))
}

/// `c/√x + k x` over `0 < x ≤ cap`.
#[derive(Clone, Copy, Debug, Default)]
struct Term {
    c: f64,
    k: f64,
    cap: f64,
}

impl Term {
    /// Where it is least with `more` added to `k`.
    fn place(&self, more: f64) -> f64 {
        let k = self.k + more;
        if k > 0.0 { (0.5 * self.c / k).cbrt().powi(2).min(self.cap) } else { self.cap }
    }

    fn least(&self, more: f64) -> f64 {
        let x = self.place(more);
        self.c / x.sqrt() + (self.k + more) * x
    }
}

struct Bound {
    /// Of the coefficients at the joints and between them.
    joints: Vec<Term>,
    middles: Vec<Term>,
    /// Inverse lengths of the cells, with those of one and a half times the end cells before and
    /// after: from and to rest `x = 3/2 h |u|`.
    per_length: Vec<f64>,
    most: f64,
}

impl Bound {
    fn new(problem: &Problem, range: Range<usize>, duals: &[Dual]) -> Bound {
        let n = range.len();
        let mut joints = vec![Term { cap: f64::INFINITY, ..Term::default() }; n + 1];
        let mut middles = vec![Term::default(); n];
        let mut sums = vec![0.0; n + 1];
        for (i, d) in duals.iter().enumerate() {
            let (c, cap) = (problem.weights(range.start + i), problem.caps(range.start + i));
            for (j, b) in [(i, 0), (i + 1, 2)] {
                joints[j].c += c[b];
                joints[j].cap = joints[j].cap.min(cap[b]);
                sums[j] += d.sum[b];
            }
            (middles[i].c, middles[i].cap) = (c[1], cap[1]);
        }
        // Jerks at places between coefficients: `1/√x` there is at most the mean of those at the
        // coefficients, whose weights they take.
        let between = |d: &Dual, a: usize| (3..6).map(|b| SHARES_OF_X[b][a] * d.sum[b]).sum::<f64>();
        for (i, d) in duals.iter().enumerate() {
            sums[i] += between(d, 0);
            sums[i + 1] += between(d, 2);
        }
        let share = |c: f64, sum: f64| if sum > MOST * c { MOST * c / sum } else { 1.0 };
        let at: Vec<f64> = joints.iter().zip(&sums).map(|(t, sum)| share(t.c, *sum)).collect();
        for (i, d) in duals.iter().enumerate() {
            let middle = d.sum[1] + between(d, 1);
            let shares = [at[i], share(middles[i].c, middle), at[i + 1]];
            // The least of the coefficients' shares: what is taken from their weights is no less.
            let least = |b: usize| (0..3).filter(|a| SHARES_OF_X[b][*a] > 0.0).map(|a| shares[a]).fold(1.0, f64::min);
            let k = |a: usize| {
                let own = d.linear[a] + (0..3).map(|b| shares[b] * d.jerk[b][a]).sum::<f64>();
                own + (3..6).map(|b| least(b) * d.jerk[b][a]).sum::<f64>()
            };
            joints[i].k += k(0);
            middles[i].k += k(1);
            joints[i + 1].k += k(2);
            middles[i].c -= shares[1] * middle;
        }
        for (t, (share, sum)) in joints.iter_mut().zip(at.iter().zip(&sums)) {
            t.c -= share * sum;
        }
        let inner = problem.inner[range].iter().map(|c| c.h);
        let [first, last] = problem.ends.map(|e| 1.5 * e[0]);
        let per_length = std::iter::once(first).chain(inner).chain([last]).map(|h| 1.0 / h).collect();
        Bound { joints, middles, per_length, most: duals.iter().map(|d| d.most).sum() }
    }

    fn value(&self, r: &[f64]) -> f64 {
        let slope = |j: usize| self.per_length[j] + self.per_length[j + 1];
        let of = |j: usize| {
            let middle = self.middles.get(j).map(|t| t.least(-(r[j] + r[j + 1]) * self.per_length[j + 1]));
            self.joints[j].least(r[j] * slope(j)) + middle.unwrap_or(0.0)
        };
        let all: Vec<f64> = parallel::map_short(PER_THREAD, 0..self.joints.len(), of);
        all.iter().sum::<f64>() - self.most
    }

    /// Derivative by the `r` of a joint where that is `at`; it falls with `at`.
    fn slope(&self, r: &[f64], j: usize, at: f64) -> f64 {
        let (before, after) = (self.per_length[j], self.per_length[j + 1]);
        let mut out = (before + after) * self.joints[j].place(at * (before + after));
        if j > 0 {
            out -= before * self.middles[j - 1].place(-(r[j - 1] + at) * before);
        }
        if let Some(t) = self.middles.get(j) {
            out -= after * t.place(-(at + r[j + 1]) * after);
        }
        out
    }

    /// The `r` of a joint with which the bound is greatest, others kept.
    fn raised(&self, r: &[f64], j: usize) -> f64 {
        let begin = r[j];
        let first = self.slope(r, j, begin);
        if first == 0.0 {
            return begin;
        }
        // A step as long as the difference quotient says, doubled until the derivative changes its
        // sign.
        let small = 1e-6 * (self.joints[j].c / self.per_length[j] + begin.abs());
        let mut step = small * first.signum();
        let change = self.slope(r, j, begin + step) - first;
        if change != 0.0 {
            step = (-first / change * step).abs() * first.signum();
        }
        let (mut low, mut at_low) = (begin, first);
        let mut high = begin + step;
        let mut at_high = self.slope(r, j, high);
        for _ in 0..60 {
            if at_high * first <= 0.0 {
                break;
            }
            step *= 2.0;
            (low, at_low, high) = (high, at_high, high + step);
            at_high = self.slope(r, j, high);
        }
        // Illinois; what is kept has not gone too far.
        for _ in 0..CUTS {
            if at_low.abs() < FLAT * first.abs() || at_high * first > 0.0 {
                break;
            }
            let middle = low + (high - low) * at_low / (at_low - at_high);
            let at_middle = self.slope(r, j, middle);
            if at_middle * first > 0.0 {
                (low, at_low, at_high) = (middle, at_middle, 0.5 * at_high);
            } else {
                (high, at_high, at_low) = (middle, at_middle, 0.5 * at_low);
            }
        }
        if low.is_finite() { low } else { begin }
    }
}
