//! Runs of polynomial pieces as curves of control points and knots (`G06.2` of Fanuc).
//!
//! Pieces of degree 3 that meet with two derivatives are one B-spline of degree 3: `n` of them have
//! `n + 3` control points, and four equal knots at either end. A control point is a value of the
//! blossom of a piece beside it (Ramshaw 1989, "Blossoms are polar forms"),
//!
//! ```text
//! f(r, s, t) = c₀ + c₁ (r + s + t)/3 + c₂ (r s + s t + t r)/3 + c₃ r s t
//! ```
//!
//! at three knots that follow one another. Whatever digits control points are rounded to, the curve
//! between them stays twice continuously differentiable. Where two curves meet, derivatives are off
//! by what rounding makes of the control points at their ends.
//!
//! The control takes one feed for a whole curve. So a curve ends where the planned speed would
//! leave that of the curve by more than [`SPREAD`]; it takes the time that is planned for it. It
//! ends too where a turn does, since programs can be begun there, and before its knots grow beyond
//! [`LONGEST_UM`].

use super::moves::WordBends;
use crate::artifact::Axes;

/// Degree of the curves.
pub(super) const DEGREE: usize = 3;
/// The planned speed at any piece of a curve is within this share of the curve's: what the time of
/// a line may be off when it is read back.
const SPREAD: f64 = 0.02;
/// Knots count micrometres along the path of the ball: with four decimals their rounding does not
/// move the curve, and nine digits reach so far.
const LONGEST_UM: f64 = 99_000.0;
/// Micrometres of a millimetre.
const UM: f64 = 1000.0;

/// A polynomial piece of all words, from where the one before ends.
pub(super) struct Piece {
    /// Coefficients of `p²` and `p³`, `p` from 0 to 1.
    pub(super) bend: WordBends,
    /// Where it ends, mm and degrees.
    pub(super) to: Axes,
    /// Length of its parameter, mm.
    pub(super) span_mm: f64,
    /// What F counts along it, mm or degrees.
    pub(super) way: f64,
    /// Time, s.
    pub(super) dt_s: f64,
}

/// How many of the first pieces make one curve: at least one where there is one.
pub(super) fn together(pieces: &[Piece]) -> usize {
    let (mut way, mut dt_s, mut span_mm) = (0.0, 0.0, 0.0);
    let [mut slowest, mut fastest] = [f64::INFINITY, 0.0f64];
    for (k, piece) in pieces.iter().enumerate() {
        let speed = piece.way / piece.dt_s;
        way += piece.way;
        dt_s += piece.dt_s;
        span_mm += piece.span_mm;
        (slowest, fastest) = (slowest.min(speed), fastest.max(speed));
        let mean = way / dt_s;
        let is_even = fastest <= (1.0 + SPREAD) * mean && mean <= (1.0 + SPREAD) * slowest;
        if k > 0 && !(is_even && UM * span_mm <= LONGEST_UM) {
            return k;
        }
    }
    pieces.len()
}

/// Knots of a curve of pieces: four at either end.
pub(super) fn knots(pieces: &[Piece]) -> Vec<f64> {
    let mut out = vec![0.0; 4];
    let mut at = 0.0;
    for piece in pieces {
        at += UM * piece.span_mm;
        out.push(at);
    }
    out.extend([at; 3]);
    out
}

/// Control points of a curve of pieces that begins at a place.
pub(super) fn control_points(from: &Axes, pieces: &[Piece], knots: &[f64]) -> Vec<Axes> {
    let columns = from.len();
    let begins: Vec<&Axes> = std::iter::once(from).chain(pieces.iter().map(|p| &p.to)).collect();
    let of = |j: usize| {
        // The piece between the second and the third of its knots; at the ends the one beside it.
        let i = j.saturating_sub(1).min(pieces.len() - 1);
        let (begin, span) = (knots[i + 3], knots[i + 4] - knots[i + 3]);
        let [r, s, t] = [1, 2, 3].map(|k| (knots[j + k] - begin) / span);
        Axes::from_fn(columns, |k| {
            let ([square, cube, ..], a, b) = (pieces[i].bend[k], begins[i][k], pieces[i].to[k]);
            let even = b - a - square - cube;
            a + even * (r + s + t) / 3.0 + square * (r * s + s * t + t * r) / 3.0 + cube * r * s * t
        })
    };
    let mut out: Vec<Axes> = (0..pieces.len() + 3).map(of).collect();
    // To the bit: it is compared with where the tool stands.
    if let (Some(first), Some(last), Some(piece)) = (out.first().copied(), out.last_mut(), pieces.last()) {
        *last = piece.to;
        debug_assert!(first.iter().zip(from.iter()).all(|(a, b)| (a - b).abs() < 1e-9));
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::numerics::spline::{CubicSpline, SplineEnds};

    fn piece(way: f64, dt_s: f64, span_mm: f64) -> Piece {
        Piece { bend: WordBends::from_fn(1, |_| [0.0; 4]), to: Axes::from_fn(1, |_| 0.0), span_mm, way, dt_s }
    }

    /// A cubic spline through places is that of its control points: Cox and de Boor's recursion
    /// gives its places back.
    #[test]
    fn control_points_are_those_of_the_pieces() {
        let breaks: [f64; 7] = [0.0, 0.3, 0.45, 1.1, 1.2, 1.9, 2.0];
        let values: Vec<f64> = breaks.iter().flat_map(|s| [s.sin(), 3.0 * s * s - s]).collect();
        let ends = SplineEnds::Clamped { start: vec![1.0, -1.0], end: vec![2.0f64.cos(), 11.0] };
        let spline = CubicSpline::new(&breaks, &values, 2, &ends).unwrap();
        let at = |k: usize| Axes::from_fn(2, |c| values[2 * k + c]);
        let pieces: Vec<Piece> = (0..6)
            .map(|i| {
                let h = breaks[i + 1] - breaks[i];
                let bend = WordBends::from_fn(2, |c| {
                    let [_, _, square, cube] = spline.coefficients(i, c).unwrap();
                    [square * h * h, cube * h * h * h, 0.0, 0.0]
                });
                Piece { bend, to: at(i + 1), span_mm: h, ..piece(1.0, 1.0, h) }
            })
            .collect();
        let knots = knots(&pieces);
        let points = control_points(&at(0), &pieces, &knots);
        assert_eq!((points.len(), knots.len()), (9, 13));
        fn basis(knots: &[f64], j: usize, degree: usize, u: f64) -> f64 {
            if degree == 0 {
                return f64::from(u8::from(knots[j] <= u && u < knots[j + 1]));
            }
            let part = |of: f64, a: f64, b: f64| if b > a { of / (b - a) } else { 0.0 };
            part(u - knots[j], knots[j], knots[j + degree]) * basis(knots, j, degree - 1, u)
                + part(knots[j + degree + 1] - u, knots[j + 1], knots[j + degree + 1])
                    * basis(knots, j + 1, degree - 1, u)
        }
        for s in [0.0, 0.1, 0.3, 0.44, 0.8, 1.15, 1.6, 1.99] {
            for c in 0..2 {
                let want = spline.value(s, c);
                let is: f64 = (0..9).map(|j| points[j][c] * basis(&knots, j, 3, UM * s)).sum();
                assert!((is - want).abs() < 1e-12, "{s} {c}: {is} {want}");
            }
        }
    }

    #[test]
    fn a_curve_ends_where_the_speed_leaves_it_or_its_knots_would() {
        let even: Vec<Piece> = (0..50).map(|_| piece(0.3, 0.01, 0.3)).collect();
        assert_eq!(together(&even), 50);
        assert_eq!(together(&[]), 0);
        // The third is slower than the others by 5 %, and by 3 % than all.
        let slower = [piece(0.3, 0.01, 0.3), piece(0.3, 0.01, 0.3), piece(0.3, 0.01 * 1.05, 0.3)];
        assert_eq!(together(&slower), 2);
        let little = [piece(0.3, 0.01, 0.3), piece(0.3, 0.01, 0.3), piece(0.3, 0.01 * 1.01, 0.3)];
        assert_eq!(together(&little), 3);
        let long: Vec<Piece> = (0..5).map(|_| piece(30.0, 1.0, 30.0)).collect();
        assert_eq!(together(&long), 3);
        assert_eq!(together(&[piece(0.1, 0.0, 0.1), piece(0.3, 0.01, 0.3)]), 1);
    }
}
