//! Cuts as polynomials, for controls that interpolate them (`POLY` of the Siemens 840D).
//!
//! From a cutter location to the next the plan's ball centre goes straight and evenly with the arc
//! length, and θ follows the schedule's curve θ(S). Every word of a block, the coordinates of the
//! programmed point and the rotary axes, is a function `w(p)` of the share `p` of that way. It is
//! written as
//!
//! ```text
//! w(p) = w₀ + (w₁ − w₀ − Σ aₖ) p + Σ aₖ pᵏ,   k = 2 … degree,   p from 0 to 1
//! ```
//!
//! with `w₀` where the block before ended: only the end `w₁` and the `aₖ` are programmed. They are
//! those of the polynomial through `w` at the extremes of the Chebyshev polynomial of that degree,
//! ends among them. Where `A` turns with θ and the schedule's piece is a cubic in S, the polynomial
//! of A is that cubic itself; the tip, which the turning tool axis carries about the ball, is met
//! to what [`OFF_MM`] says. Where a word is farther off, the block is parted at a joint of the
//! curve's pieces, or halved on a long turn. With `p` up to 1, rounding of the `aₖ` counts no more
//! than that of the ends.
//!
//! A plan with a programmed curve is written piece by piece ([`super::spline`]) where the control
//! takes the fifth degree or spline lines; else every way between two locations follows the curve.
//!
//! **Not carried**: without a programmed curve, corners of the path of ball centres at the
//! locations stay, since the straight moves between them are what was checked;
//! θ on leads goes evenly from row to row as it was planned.

use nalgebra::{DMatrix, DVector};

use super::OperationRun;
use super::moves::{Move, WordBends, WordsOf};
use super::spline;
use crate::artifact::{Axes, Motion};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::numerics::quintic::DEGREE;

/// A polynomial is at most this far off its word, mm: half of what reading back allows.
const OFF_MM: f64 = 5e-4;
/// The same of rotary axes, degrees.
const OFF_DEG: f64 = 5e-4;
/// Places of a block looked at.
const LOOKED_AT: usize = 12;
/// A block is not parted nearer to its ends than this share.
const END: f64 = 0.05;
/// A block is halved at most so often.
const MOST_HALVINGS: usize = 12;

/// Solves for the coefficients of a degree.
struct Fit {
    degree: usize,
    /// Places that the polynomial goes through, without 0 and 1.
    at: Vec<f64>,
    /// Of `pᵏ − p` there, inverted.
    inverse: DMatrix<f64>,
}

impl Fit {
    fn new(degree: usize) -> Option<Self> {
        let at: Vec<f64> =
            (1..degree).map(|j| 0.5 - 0.5 * (std::f64::consts::PI * j as f64 / degree as f64).cos()).collect();
        let matrix = DMatrix::from_fn(degree - 1, degree - 1, |r, k| at[r].powi(k as i32 + 2) - at[r]);
        Some(Fit { degree, inverse: matrix.try_inverse()?, at })
    }

    /// Coefficients of `p²` and on, from a word's values at `at` less the straight way between its
    /// ends.
    fn solve(&self, off_straight: Vec<f64>) -> [f64; 4] {
        let solved = &self.inverse * DVector::from_vec(off_straight);
        std::array::from_fn(|k| if k + 2 <= self.degree { solved[k] } else { 0.0 })
    }
}

/// What a polynomial adds to the straight way.
fn bent(a: &[f64; 4], p: f64) -> f64 {
    a.iter().zip(2..).map(|(a, k)| a * (p.powi(k) - p)).sum()
}

/// Chords that the length of a polynomial is taken from.
const CHORDS: usize = 32;

/// Length of the way of a point from one place to another, its coordinates bent, mm.
pub(super) fn length(from: &[f64; 3], to: &[f64; 3], bend: [[f64; 4]; 3]) -> f64 {
    let at = |p: f64| -> [f64; 3] { std::array::from_fn(|k| from[k] + (to[k] - from[k]) * p + bent(&bend[k], p)) };
    let places = (0..=CHORDS).map(|k| at(k as f64 / CHORDS as f64)).collect::<Vec<_>>();
    places.windows(2).map(|w| (0..3).map(|k| (w[1][k] - w[0][k]).powi(2)).sum::<f64>().sqrt()).sum()
}

/// The way between two rows.
struct RowWay<'a> {
    from: Move,
    to: Move,
    motion: &'a Motion<'a>,
    /// Its first row.
    row: usize,
    words: &'a WordsOf<'a>,
    /// What a polynomial may be off each word.
    most_off: &'a [f64],
}

impl RowWay<'_> {
    fn at(&self, share: f64) -> Move {
        Move { stand: self.motion.curved(self.row, share).unwrap_or(self.to.stand), ..self.from }
    }

    fn words(&self, share: f64) -> Axes {
        (self.words)(&self.at(share))
    }

    /// The polynomials of a part of the way; `None`: they are too far off.
    fn bend(&self, fit: &Fit, [from, to]: [f64; 2]) -> Option<WordBends> {
        let at = |p: f64| self.words(from + (to - from) * p);
        let (first, last) = (at(0.0), at(1.0));
        let off_straight = |p: f64| {
            let here = at(p);
            Axes::from_fn(here.len(), |w| here[w] - first[w] - (last[w] - first[w]) * p)
        };
        let met: Vec<Axes> = fit.at.iter().map(|p| off_straight(*p)).collect();
        let bend = WordBends::from_fn(first.len(), |w| fit.solve(met.iter().map(|m| m[w]).collect()));
        let close = (0..LOOKED_AT).all(|k| {
            let p = (k as f64 + 0.5) / LOOKED_AT as f64;
            let off = off_straight(p);
            off.iter()
                .zip(bend.iter())
                .zip(self.most_off)
                .all(|((off, bend), most)| (off - bent(bend, p)).abs() <= *most)
        });
        close.then_some(bend)
    }

    /// The polynomials in order, the way parted where it must be.
    fn write(&self, fit: &Fit, part: [f64; 2], halvings: usize, out: &mut Vec<Move>) -> Result<()> {
        let [from, to] = part;
        if let Some(bend) = self.bend(fit, part) {
            let (a, b) = (&self.from, &self.to);
            let stretch = Motion::stretch_between(a.stretch, b.stretch);
            // The row itself, to the bit.
            let end = if to == 1.0 { *b } else { Move { stretch, ..self.at(to) } };
            out.push(Move { t_s: a.t_s + (b.t_s - a.t_s) * to, bend: Some(bend), ..end });
            return Ok(());
        }
        if halvings >= MOST_HALVINGS {
            let what = format!("no polynomial follows the motion after {:.3} s", self.from.t_s);
            let since = Infeasible::NoPolynomial { at_s: self.from.t_s };
            return Err(Error::infeasible(Stage::Post, what, since).advise("write the program with straight moves"));
        }
        let end = END * (to - from);
        let joint = self.motion.joint_between(self.row, from + end, to - end);
        let mid = joint.unwrap_or(0.5 * (from + to));
        self.write(fit, [from, mid], halvings + 1, out)?;
        self.write(fit, [mid, to], halvings + 1, out)
    }
}

/// The first row and all moves after it. `is_spline`: two derivatives are to meet where lines do,
/// whatever the degree.
///
/// # Errors
/// `Infeasible` where the motion turns so wildly that no polynomial of a short part follows it.
pub(super) fn all(run: &OperationRun, degree: usize, is_spline: bool, words: &WordsOf) -> Result<Vec<Move>> {
    let fit = Fit::new(degree)
        .ok_or_else(|| Error::usage(Stage::Post, format!("there are no polynomials of degree {degree} to write")))?;
    let plan = run.plan;
    let most_off: Vec<f64> = run.machine.axes().iter().map(|a| if a.is_rotary() { OFF_DEG } else { OFF_MM }).collect();
    let one = |motion: &Motion, row: usize, from: &Move, to: &Move, words: &WordsOf| {
        let mut out = Vec::new();
        let way = RowWay { from: *from, to: *to, motion, row, words, most_off: &most_off };
        way.write(&fit, [0.0, 1.0], 0, &mut out)?;
        Ok(out)
    };
    if let Some(curve) = plan.curve.as_ref().filter(|_| degree == DEGREE || is_spline) {
        return spline::all(run, curve, degree, words, one);
    }
    let motion = Motion::of(plan);
    let mut out: Vec<Move> = Vec::with_capacity(plan.toolpath.locations.len());
    let mut from: Option<Move> = None;
    for (k, next) in Move::rows(plan).enumerate() {
        match from {
            None => out.push(next),
            Some(from) => out.extend(one(&motion, k - 1, &from, &next, words)?),
        }
        from = Some(next);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn polynomials_of_the_degree_are_met_exactly() {
        for degree in 3..=5 {
            let fit = Fit::new(degree).unwrap();
            let a: [f64; 4] = std::array::from_fn(|k| if k + 2 <= degree { 0.3 - k as f64 } else { 0.0 });
            let got = fit.solve(fit.at.iter().map(|p| bent(&a, *p)).collect());
            assert!(got.iter().zip(a).all(|(g, a)| (g - a).abs() < 1e-10), "{got:?} {a:?}");
        }
    }
}
