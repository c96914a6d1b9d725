//! How far single polynomials reach, and so how many pieces there are at least.
//!
//! ## Bound
//! A *gate* is what a curve keeps to at a cutter location: between two numbers along the normal,
//! across and along the path. Of a spline of degree 5 that goes through all gates, each piece is a
//! polynomial of degree 5 through those of its locations, and these follow one another. So there
//! are at least as many pieces as there are groups in the coarsest division of the gates into
//! consecutive groups that one polynomial each goes through. Smoothness at the joints is not asked
//! for, so splines need more.
//!
//! Groups are taken one after another, each as long as is not proven too long. Let `eₖ` be the end
//! of the k-th, and let its gates and one more, or a few more, be proven to have no polynomial. Of
//! any other division let the k-th group end at `fₖ`. If `fₖ₋₁ ≤ eₖ₋₁`, then `fₖ ≤ eₖ`: otherwise
//! the k-th group would contain gates that have no polynomial. So no division has fewer groups.
//!
//! ## Proof that there is no polynomial
//! Let `r` be the distances from the middles of the gates over half their widths. A polynomial goes
//! through them where all `|r| ≤ 1`; then `Σ w r² ≤ Σ w` for all weights `w ≥ 0`. So where the
//! *least* `Σ w r²` of all polynomials, which is a system of 18 equations, is greater than `Σ w`,
//! there is none. Lawson's weights (1961; Rice 1969, *The Approximation of Functions* II, §13),
//! each times `|r|` from step to step, raise that sum up to the square of the least greatest `|r|`.
//! Where neither is shown within [`STEPS`] the group is taken as one that has a polynomial.

use super::tube::frame_at;
use crate::artifact::toolpath::CutterLocation;
use crate::geometry::{Point, Vector};
use crate::numerics::bounded::Factor;
use crate::numerics::quintic::ORDER;

/// Steps of weights at most.
const STEPS: usize = 40;
/// `Σ w r²` is to be greater than `Σ w` by this share: for rounding.
const MARGIN: f64 = 1e-3;
/// Weights are no smaller than this share of the greatest.
const SMALLEST: f64 = 1e-7;
/// A group may be proven too long only with so many gates more, as a share of its own.
const MORE: usize = 40;

/// What a curve keeps to at a location.
pub(super) struct Gate {
    s_mm: f64,
    centre: Point,
    /// Normal, across and along the path.
    frame: [Vector; 3],
    middle: [f64; 3],
    half: [f64; 3],
}

impl Gate {
    /// Ends along the normal, across and along the path, mm from the ball centre.
    pub fn at(locations: &[CutterLocation], k: usize, ends: [[f64; 2]; 3]) -> Gate {
        let l = &locations[k];
        let middle = ends.map(|[lo, hi]| 0.5 * (lo + hi));
        let half = ends.map(|[lo, hi]| 0.5 * (hi - lo));
        Gate { s_mm: l.s_mm, centre: l.centre, frame: frame_at(locations, k), middle, half }
    }
}

/// Where the groups of the coarsest division begin, see the module's page.
pub(super) fn groups(gates: &[Gate]) -> Vec<usize> {
    let n = gates.len();
    let mut out = Vec::new();
    let (mut at, mut guess) = (0, 4 * ORDER);
    while at < n {
        out.push(at);
        // Not proven to be too long, and proven.
        let (mut fits, mut misses) = ((at + ORDER).min(n), None);
        let mut end = at + guess.max(ORDER + 1);
        while misses.is_none() && fits < n {
            end = end.min(n);
            if has_none(&gates[at..end]) {
                misses = Some(end);
            } else {
                fits = end;
                end = at + (end - at) * 5 / 4 + 1;
            }
        }
        let Some(mut long) = misses else { break };
        while long - fits > (1 + (fits - at) / MORE) {
            let middle = fits + (long - fits) / 2;
            if has_none(&gates[at..middle]) {
                long = middle;
            } else {
                fits = middle;
            }
        }
        guess = long - 1 - at;
        at = long - 1;
    }
    out
}

/// Whether it is proven that no polynomial goes through the gates.
fn has_none(gates: &[Gate]) -> bool {
    if gates.len() <= ORDER {
        return false;
    }
    let ends = [gates[0].s_mm, gates[gates.len() - 1].s_mm];
    let origin = gates[gates.len() / 2].centre;
    let basis: Vec<[f64; ORDER]> = gates.iter().map(|g| chebyshev(g.s_mm, ends)).collect();
    let mut weights = vec![[1.0; 3]; gates.len()];
    for _ in 0..STEPS {
        let Some((least, distances)) = weighted(gates, &basis, &weights, &origin) else { return false };
        let whole: f64 = weights.iter().flatten().sum();
        let worst = distances.iter().flatten().fold(0.0, |m: f64, r| m.max(r.abs()));
        if !(worst > 1.0) {
            return false;
        }
        if least > (1.0 + MARGIN) * whole {
            return true;
        }
        let mut greatest = 0.0_f64;
        for (w, r) in weights.iter_mut().flatten().zip(distances.iter().flatten()) {
            *w *= r.abs();
            greatest = greatest.max(*w);
        }
        weights.iter_mut().flatten().for_each(|w| *w = (*w / greatest).max(SMALLEST));
    }
    false
}

/// Chebyshev's polynomials of degree 0 to 5 on an interval.
fn chebyshev(s_mm: f64, [a, b]: [f64; 2]) -> [f64; ORDER] {
    let t = (2.0 * s_mm - a - b) / (b - a);
    let mut out = [1.0, t, 0.0, 0.0, 0.0, 0.0];
    for k in 2..ORDER {
        out[k] = 2.0 * t * out[k - 1] - out[k - 2];
    }
    out
}

/// A number that the least weighted sum of squares is no less than, and the distances of the
/// polynomial that has about that least sum.
fn weighted(
    gates: &[Gate],
    basis: &[[f64; ORDER]],
    weights: &[[f64; 3]],
    origin: &Point,
) -> Option<(f64, Vec<[f64; 3]>)> {
    let mut band = vec![[0.0; 18]; 18];
    let mut x = vec![0.0; 18];
    for ((g, t), w) in gates.iter().zip(basis).zip(weights) {
        let away = g.centre - origin;
        let (mut square, mut side) = ([[0.0; 3]; 3], [0.0; 3]);
        for d in 0..3 {
            let (f, v) = (w[d] / (g.half[d] * g.half[d]), &g.frame[d]);
            let aim = f * (g.middle[d] + v.dot(&away));
            for p in 0..3 {
                side[p] += aim * v[p];
                (0..3).for_each(|q| square[p][q] += f * v[p] * v[q]);
            }
        }
        for (a, ta) in t.iter().enumerate() {
            for p in 0..3 {
                let row = 3 * a + p;
                x[row] += ta * side[p];
                for (b, tb) in t[..=a].iter().enumerate() {
                    let last = if b == a { p + 1 } else { 3 };
                    (0..last).for_each(|q| band[row][17 - row + 3 * b + q] += ta * tb * square[p][q]);
                }
            }
        }
    }
    let factor = Factor::<18>::of(band)?;
    factor.solve(&mut x);
    let (mut sum, mut slope) = (0.0, vec![0.0; 18]);
    let mut distances = Vec::with_capacity(gates.len());
    for ((g, t), w) in gates.iter().zip(basis).zip(weights) {
        let c = Vector::from(std::array::from_fn::<f64, 3, _>(|d| (0..ORDER).map(|k| t[k] * x[3 * k + d]).sum()));
        let away = c - (g.centre - origin);
        let r: [f64; 3] = std::array::from_fn(|d| (g.frame[d].dot(&away) - g.middle[d]) / g.half[d]);
        for d in 0..3 {
            sum += w[d] * r[d] * r[d];
            for (k, t) in t.iter().enumerate() {
                (0..3).for_each(|p| slope[3 * k + p] += w[d] * r[d] / g.half[d] * g.frame[d][p] * t);
            }
        }
        distances.push(r);
    }
    // What rounding left to gain: the square of the slope, by the inverse of the matrix.
    let mut step = slope.clone();
    factor.solve(&mut step);
    let gain: f64 = step.iter().zip(&slope).map(|(a, b)| a * b).sum();
    sum.is_finite().then_some((sum - 2.0 * gain.abs(), distances))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::numerics::quintic::{Breaks, weighed};
    use proptest::prelude::*;

    /// A gate about a place, turned about x, y and z.
    fn gate(s_mm: f64, place: [f64; 3], turn: f64, half: [f64; 3], shift: f64) -> Gate {
        let turn = nalgebra::Rotation3::from_euler_angles(turn, 0.7 * turn, -turn);
        let frame = [Vector::x(), Vector::y(), Vector::z()].map(|v| turn * v);
        // The place is within, at any share of the width.
        Gate { s_mm, centre: Point::from(place), frame, middle: half.map(|h| shift * h), half }
    }

    proptest! {
        /// No spline has fewer pieces than there are groups of the gates that it goes through.
        #[test]
        fn groups_are_no_more_than_the_pieces_of_any_spline(
            steps in prop::collection::vec(0.5..2.0f64, 1..6),
            values in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 10),
            per_piece in 3usize..25, half in prop::array::uniform3(1e-4..1e-2f64), turn in -2.0..2.0f64,
        ) {
            let mut s = vec![0.0];
            steps.iter().for_each(|d| s.push(s[s.len() - 1] + d));
            let breaks = Breaks::new(s).unwrap();
            let end = breaks.all()[breaks.spans()];
            let count = per_piece * breaks.spans();
            let gates: Vec<Gate> = (0..=count)
                .map(|k| {
                    let s = end * k as f64 / count as f64;
                    let i = breaks.span_of(s);
                    let place = weighed(&values[i..], &breaks.weights(i, s));
                    gate(s, place, turn * s, half, (7.0 * s).sin())
                })
                .collect();
            let found = groups(&gates);
            prop_assert!(!found.is_empty() && found.len() <= breaks.spans(), "{found:?} {}", breaks.spans());
        }
    }

    #[test]
    fn kinks_ask_for_one_group_each() {
        // Straight to and fro: between two kinks one polynomial reaches.
        let at = |k: usize| {
            let s = k as f64 / 20.0;
            let y = (s.rem_euclid(2.0) - 1.0).abs();
            gate(s, [s, y, 0.0], 0.0, [1e-3; 3], 0.0)
        };
        let gates: Vec<Gate> = (0..=100).map(at).collect();
        let found = groups(&gates);
        assert_eq!(found.len(), 5, "{found:?}");
        // Wide gates let one through.
        let wide: Vec<Gate> = gates.into_iter().map(|g| Gate { half: [0.6; 3], ..g }).collect();
        assert_eq!(groups(&wide), [0]);
    }
}
