//! Control values that miss limits as little as can be, where not all limits can be kept.
//!
//! In: spans with limits, as [`super::bounded`] takes them. Out: the control values for which the
//! sum of the squares of what limits are missed by, each over half its width, is least; and span by
//! span the worst miss. Where all limits can be kept little is missed, see [`PULL`].
//!
//! ## Method
//! With `m(r)` the miss of a row and `c(r)` its distance from the middle, both over half the width,
//! least is `½ Σ m² + PULL/2 Σ c²`: convex, with a continuous gradient, quadratic where the rows
//! that are missed stay the same. Newton's method on these rows, each step as long as is best of
//! some halves, ends where they no longer change (Mangasarian 2002, "A finite Newton method for
//! classification", Optim. Methods Softw. 17). Each step is a system of `6 D − 1` diagonals.
//!
//! Unlike an interior point this does not stop at limits that contradict one another: it says how
//! much each span lacks.

use super::bounded::{Factor, Span};
use super::quintic::ORDER;
use crate::parallel;

/// Weight of the middle of a row beside its limits. Where all limits can be kept, the sum of the
/// squares of the misses is at most this share of the number of rows: that is the sum of any
/// control values within the limits.
const PULL: f64 = 1e-3;
/// Steps at most.
const MOST: usize = 14;
/// Halves of a step at most.
const HALVES: usize = 6;
/// The search ends when a step gains less than this share.
const LITTLE: f64 = 1e-3;
/// Spans of a unit of parallel work; fixed, so that sums are taken in the same order.
const CHUNK: usize = 64;

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest<const D: usize> {
    /// Control values.
    pub x: Vec<[f64; D]>,
    /// Of each span the worst miss, in halves of the width of its row; 0 where none is missed.
    pub missed: Vec<f64>,
}

/// A row: its factors, its middle and half its width.
struct Row<const W: usize> {
    g: [f64; W],
    middle: f64,
    half: f64,
    /// Distance from the middle over half the width.
    at: f64,
    /// What a whole step adds to that.
    change: f64,
}

impl<const W: usize> Row<W> {
    /// What it adds to the sum that is made least, `at` that place.
    fn cost(at: f64) -> f64 {
        let miss = (at.abs() - 1.0).max(0.0);
        0.5 * (miss * miss + PULL * at * at)
    }

    /// Derivative of that, and its second derivative.
    fn slope(&self) -> [f64; 2] {
        if self.at.abs() > 1.0 {
            [self.at - self.at.signum() + PULL * self.at, 1.0 + PULL]
        } else {
            [PULL * self.at, PULL]
        }
    }
}

/// Finds them; the objective of the spans counts for nothing. Rows with a limit that is not finite
/// are left out. `None` where numbers are not finite.
pub fn nearest<const D: usize, const W: usize>(spans: &[Span<D, W>]) -> Option<Nearest<D>> {
    let mut rows: Vec<Vec<Row<W>>> = parallel::map(spans, rows);
    let mut x = vec![0.0; (spans.len() + ORDER - 1) * D];
    let mut cost = f64::INFINITY;
    for _ in 0..MOST {
        let (band, mut d) = system::<D, W>(&rows);
        Factor::of(band)?.solve(&mut d);
        if !d.iter().all(|v| v.is_finite()) {
            return None;
        }
        for (i, own) in rows.iter_mut().enumerate() {
            let d = &d[i * D..i * D + W];
            own.iter_mut().for_each(|r| r.change = dot(&r.g, d) / r.half);
        }
        let after = |t: f64| {
            let of_span = |own: &Vec<Row<W>>| own.iter().map(|r| Row::<W>::cost(r.at + t * r.change)).sum::<f64>();
            rows.iter().map(of_span).sum::<f64>()
        };
        if cost == f64::INFINITY {
            cost = after(0.0);
        }
        let mut best = (0.0, cost);
        let mut t = 1.0;
        for _ in 0..HALVES {
            let there = after(t);
            if there < best.1 {
                best = (t, there);
            } else if best.0 > 0.0 {
                break;
            }
            t *= 0.5;
        }
        let (t, there) = best;
        x.iter_mut().zip(&d).for_each(|(x, d)| *x += t * d);
        rows.iter_mut().flatten().for_each(|r| r.at += t * r.change);
        let gained = cost - there;
        cost = there;
        if !(gained > LITTLE * there.abs()) {
            break;
        }
    }
    let worst = |own: &Vec<Row<W>>| own.iter().map(|r| r.at.abs() - 1.0).fold(0.0, f64::max);
    let missed = rows.iter().map(worst).collect();
    Some(Nearest { x: x.chunks_exact(D).map(|c| std::array::from_fn(|d| c[d])).collect(), missed })
}

fn rows<const D: usize, const W: usize>(span: &Span<D, W>) -> Vec<Row<W>> {
    let row = |g, lo: f64, hi: f64| {
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        Row { g, middle, half, at: -middle / half, change: 0.0 }
    };
    let single = span.rows.iter().map(|r| row(r.g, r.lo, r.hi));
    let strips = span.strips.iter().flat_map(|s| {
        let of = |j: usize| {
            let g = std::array::from_fn(|a| s.map[j][a / D] * s.direction[a % D]);
            row(g, s.lo[j], s.hi[j])
        };
        (0..ORDER).map(of)
    });
    single.chain(strips).filter(|r| r.half > 0.0 && r.half.is_finite() && r.middle.is_finite()).collect()
}

/// Matrix and right-hand side of a step.
fn system<const D: usize, const W: usize>(rows: &[Vec<Row<W>>]) -> (Vec<[f64; W]>, Vec<f64>) {
    let of = |first: usize| {
        let end = (first + CHUNK).min(rows.len());
        let controls = (end - first + ORDER - 1) * D;
        let (mut band, mut side) = (vec![[0.0; W]; controls], vec![0.0; controls]);
        for (i, own) in rows[first..end].iter().enumerate() {
            let (band, side) = (&mut band[i * D..i * D + W], &mut side[i * D..i * D + W]);
            for r in own {
                let [slope, second] = r.slope();
                let (pull, weight) = (slope / r.half, second / (r.half * r.half));
                for a in 0..W {
                    side[a] -= pull * r.g[a];
                    let f = weight * r.g[a];
                    band[a][W - 1 - a..].iter_mut().zip(&r.g).for_each(|(o, g)| *o += f * g);
                }
            }
        }
        (first * D, band, side)
    };
    let each = parallel::map((0..rows.len()).step_by(CHUNK), of);
    let controls = (rows.len() + ORDER - 1) * D;
    let (mut band, mut side) = (vec![[0.0; W]; controls], vec![0.0; controls]);
    for (first, own, own_side) in each {
        for (o, l) in band[first..].iter_mut().zip(&own) {
            o.iter_mut().zip(l).for_each(|(o, l)| *o += l);
        }
        side[first..].iter_mut().zip(&own_side).for_each(|(o, l)| *o += l);
    }
    (band, side)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::bounded::{Strip, SumLimit};
    use super::super::quintic::{Breaks, apply};
    use super::*;
    use proptest::prelude::*;

    fn spans(breaks: &Breaks, limits: &[[f64; 2]]) -> Vec<Span<1, 6>> {
        let span = |i: usize| {
            let map = breaks.ordinates(i, breaks.span(i));
            let [lo, hi] = limits[i].map(|l| [l; 6]);
            let strips = vec![Strip { map, direction: [1.0], lo, hi }];
            Span { hessian: Box::new([[0.0; 6]; 6]), gradient: [0.0; 6], rows: Vec::new(), strips }
        };
        (0..breaks.spans()).map(span).collect()
    }

    proptest! {
        /// Limits about a spline that there is are kept, but for what the pull to the middle takes:
        /// the sum that is made least is no greater than that spline's own.
        #[test]
        fn limits_that_can_be_kept_are_kept(
            steps in prop::collection::vec(0.5..2.0f64, 2..9),
            values in prop::collection::vec(-1.0..1.0f64, 14), width in 0.05..0.5f64,
        ) {
            let mut s = vec![0.0];
            steps.iter().for_each(|d| s.push(s[s.len() - 1] + d));
            let breaks = Breaks::new(s).unwrap();
            let x: Vec<[f64; 1]> = values[..breaks.controls()].iter().map(|v| [*v]).collect();
            let mut all = spans(&breaks, &vec![[0.0; 2]; breaks.spans()]);
            for (i, span) in all.iter_mut().enumerate() {
                let own = apply(&span.strips[0].map, &x[i..]);
                span.strips[0].lo = own.map(|[v]| v - width * 0.1);
                span.strips[0].hi = own.map(|[v]| v + width);
            }
            let found = nearest(&all).unwrap();
            let rows = (ORDER * breaks.spans()) as f64;
            let own = PULL * rows * (0.45_f64 / 0.55).powi(2);
            let squares: f64 = found.missed.iter().map(|m| m * m).sum();
            prop_assert!(squares <= (1.0 + 2.0 * LITTLE) * own, "{:?} {own}", found.missed);
        }
    }

    #[test]
    fn limits_against_one_another_are_told_by_how_much() {
        let breaks = Breaks::new((0..=60).map(f64::from).collect()).unwrap();
        let mut all = spans(&breaks, &[[-1.0, 1.0]; 60]);
        let g = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        all[30].rows.push(SumLimit { g, lo: 3.0, hi: 5.0 });
        all[30].rows.push(SumLimit { g, lo: -5.0, hi: -3.0 });
        let found = nearest(&all).unwrap();
        // Both are missed by as much.
        assert!((found.missed[30] - 3.0).abs() < 0.05, "{}", found.missed[30]);
        assert!(found.missed[..24].iter().chain(&found.missed[37..]).all(|m| *m < 0.02));
    }
}
