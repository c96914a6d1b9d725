//! The words of a programmed curve: splines of degree 5, one block for each piece.
//!
//! Ball centre and θ of a plan's curve are splines of degree 5, but the programmed tip is carried
//! about by the turning tool axis and is none. So every word is written as the spline of degree 5
//! that is nearest to it in the mean square over the parameter: four times continuously
//! differentiable like the curve itself, so that value and derivatives meet where two blocks do, up
//! to the rounding of digits. Breaks are some of the curve's own, as few as keep every word within
//! [`OFF_MM`] and [`OFF_DEG`]; where they all are not enough, halves of its pieces. The projection
//! is bounded on any breaks (Shadrin 2001, "The L∞-norm of the L2-spline projector is bounded
//! independently of the knot sequence", Acta Math. 187). Its ends are those of the word, so that
//! the lines before and after it need not be bent to it.
//!
//! For controls that read polynomials of degree 3 as spline lines, words are cubic splines through
//! themselves at the breaks, with their own slopes at the ends, so that value and two derivatives
//! meet. Halves of the curve's pieces are added until they too are as near.

use super::OperationRun;
use super::moves::{Move, WordBends, WordsOf};
use crate::artifact::programmed::Way;
use crate::artifact::{Axes, Motion, ProgrammedCurve};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::numerics::bounded::Factor;
use crate::numerics::quintic::{Breaks, DEGREE, ORDER, apply};
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::parallel;

/// A spline is at most this far off its word at the places looked at, mm.
const OFF_MM: f64 = 1e-4;
/// The same of rotary axes, degrees.
const OFF_DEG: f64 = 1e-5;
/// Gauss points of an interval, on [0, 1], and their weights: polynomials of degree 11 are
/// integrated exactly.
const GAUSS: [[f64; 2]; 6] = [
    [0.033_765_242_898_423_99, 0.085_662_246_189_585_17],
    [0.169_395_306_766_867_74, 0.180_380_786_524_069_3],
    [0.380_690_406_958_401_54, 0.233_956_967_286_345_5],
    [0.619_309_593_041_598_5, 0.233_956_967_286_345_5],
    [0.830_604_693_233_132_3, 0.180_380_786_524_069_3],
    [0.966_234_757_101_576, 0.085_662_246_189_585_17],
];
/// Places of an interval that are looked at, shares of it.
const LOOKED_AT: [f64; 8] = [0.0, 0.1, 0.25, 0.42, 0.58, 0.75, 0.9, 1.0];
/// Breaks begin no nearer to one another than this share of their mean distance.
const THINNED: f64 = 0.25;
/// Slopes at the ends of a cubic spline are those of polynomials through five places of this share
/// of its first or last piece.
const SLOPE: f64 = 0.1;
/// Rounds of adding breaks.
const ROUNDS: usize = 16;

/// A run of the curve without a gap.
struct CurveRun<'a> {
    run: &'a OperationRun<'a>,
    motion: &'a Motion<'a>,
    curve: &'a ProgrammedCurve,
    words: &'a (dyn Fn(&Move) -> Axes + Sync + 'a),
    moves: &'a [Move],
    /// Rows of the motion before the first location.
    before: usize,
    /// First and last location.
    ends: [usize; 2],
}

impl CurveRun<'_> {
    /// The location at or before a parameter, which is on a polynomial to the next, and the share
    /// of that.
    fn place(&self, s_mm: f64) -> (usize, f64) {
        let [first, last] = self.ends;
        let rows = &self.curve.rows;
        let k = (first + rows[first..=last].partition_point(|r| r.s_mm <= s_mm)).clamp(first + 1, last) - 1;
        let (a, b) = (rows[k].s_mm, rows[k + 1].s_mm);
        (k, ((s_mm - a) / (b - a)).clamp(0.0, 1.0))
    }

    /// The motion there.
    fn at(&self, s_mm: f64) -> Move {
        let (k, share) = self.place(s_mm);
        let (from, to) = (self.moves[self.before + k], self.moves[self.before + k + 1]);
        let stand = self.motion.curved(self.before + k, share).unwrap_or(to.stand);
        Move { stand, t_s: from.t_s + (to.t_s - from.t_s) * share, ..from }
    }

    fn words_at(&self, s_mm: f64) -> Axes {
        (self.words)(&self.at(s_mm))
    }

    /// Control values of all words on breaks, the nearest in the mean square. `None` where breaks
    /// are too near to one another for floating-point numbers.
    fn fit(&self, breaks: &Breaks, own: &Breaks) -> Option<Vec<Vec<f64>>> {
        let columns = self.run.machine.axes().len();
        let spans: Vec<Vec<([f64; ORDER], f64, Axes)>> = parallel::map_short(64, 0..breaks.spans(), |i| {
            let of = |[a, b]: [f64; 2]| {
                GAUSS.map(|[share, weight]| {
                    let s = a + (b - a) * share;
                    (breaks.weights(i, s), weight * (b - a), self.words_at(s))
                })
            };
            intervals(own, breaks.span(i)).into_iter().flat_map(of).collect()
        });
        let mut band = vec![[0.0; ORDER]; breaks.controls()];
        let mut sides = vec![vec![0.0; breaks.controls()]; columns];
        // Of what is left beside the word at the first place, so that few digits are lost.
        let origin = self.words_at(breaks.all()[0]);
        for (i, places) in spans.iter().enumerate() {
            for (w, weight, words) in places {
                for r in 0..ORDER {
                    for c in 0..=r {
                        band[i + r][DEGREE - r + c] += weight * w[r] * w[c];
                    }
                    for (k, side) in sides.iter_mut().enumerate() {
                        side[i + r] += weight * w[r] * (words[k] - origin[k]);
                    }
                }
            }
        }
        // The lines before and after the run end and begin at its ends: so does the spline, whose
        // first and last control values are its ends. Beside the origin the first is 0.
        let last = breaks.controls() - 1;
        let ends = self.words_at(breaks.all()[breaks.spans()]);
        for r in 1..=DEGREE {
            band[r][DEGREE - r] = 0.0;
            for (k, side) in sides.iter_mut().enumerate() {
                side[last - r] -= band[last][DEGREE - r] * (ends[k] - origin[k]);
            }
            band[last][DEGREE - r] = 0.0;
        }
        (band[0][DEGREE], band[last][DEGREE]) = (1.0, 1.0);
        for (k, side) in sides.iter_mut().enumerate() {
            (side[0], side[last]) = (0.0, ends[k] - origin[k]);
        }
        let factor = Factor::<ORDER>::of(band)?;
        for (side, from) in sides.iter_mut().zip(origin.iter()) {
            factor.solve(side);
            side.iter_mut().for_each(|v| *v += from);
        }
        sides.iter().flatten().all(|v| v.is_finite()).then_some(sides)
    }

    /// Whether a piece is too far off one of the words. `is`: what it has for a word at a share.
    fn is_off(&self, intervals: &[[f64; 2]], is: impl Fn(f64, usize) -> f64) -> bool {
        let axes = self.run.machine.axes();
        let places = intervals.iter().flat_map(|[a, b]| LOOKED_AT.map(|share| a + (b - a) * share));
        places.into_iter().any(|s| {
            let want = self.words_at(s);
            (0..axes.len()).any(|k| {
                let most = if axes[k].is_rotary() { OFF_DEG } else { OFF_MM };
                !((is(s, k) - want[k]).abs() <= most)
            })
        })
    }

    /// The cubic spline through the words at breaks. `None` where these are too near to one another
    /// for floating-point numbers.
    fn cubic(&self, breaks: &Breaks) -> Option<CubicSpline> {
        let all = breaks.all();
        let columns = self.run.machine.axes().len();
        let rows: Vec<Axes> = parallel::map_short(64, all, |s| self.words_at(*s));
        let slope = |from: f64, step: f64| {
            let at: [Axes; 5] = std::array::from_fn(|j| self.words_at(from + step * j as f64));
            let of = |k: usize| {
                (-25.0 * at[0][k] + 48.0 * at[1][k] - 36.0 * at[2][k] + 16.0 * at[3][k] - 3.0 * at[4][k])
                    / (12.0 * step)
            };
            (0..columns).map(of).collect::<Vec<f64>>()
        };
        let [[a, b], [c, d]] = [breaks.span(0), breaks.span(breaks.spans() - 1)];
        let ends = SplineEnds::Clamped { start: slope(a, SLOPE * (b - a)), end: slope(d, -SLOPE * (d - c)) };
        let values: Vec<f64> = rows.iter().flat_map(|r| r.iter().copied()).collect();
        CubicSpline::new(all, &values, columns, &ends).ok()
    }

    /// Blocks of the run, each ending where a piece does.
    fn blocks(&self, degree: usize) -> Result<Vec<Move>> {
        let rows = &self.curve.rows;
        let [first, last] = self.ends;
        let inner = (first + 1..last).filter(|k| rows[*k].way == Way::Piece);
        let own: Vec<f64> = [first].into_iter().chain(inner).chain([last]).map(|k| rows[k].s_mm).collect();
        let since = Infeasible::NoPolynomial { at_s: self.moves[self.before + first].t_s };
        let none = || {
            let what = format!("no polynomial follows the curve after {:.3} s", self.moves[self.before + first].t_s);
            Error::infeasible(Stage::Post, what, since.clone())
                .advise("write the program with straight moves, or leave feed.smooth out")
        };
        let own = Breaks::new(own).ok_or_else(none)?;
        let mean = (own.all()[own.spans()] - own.all()[0]) / own.spans() as f64;
        let mut breaks = own.thinned(THINNED * mean);
        let marked = |breaks: &Breaks, is_off: &(dyn Fn(usize) -> bool + Sync)| -> Vec<bool> {
            parallel::map_short(64, 0..breaks.spans(), is_off)
        };
        for _ in 0..ROUNDS {
            let off = if degree == DEGREE {
                let controls = self.fit(&breaks, &own).ok_or_else(none)?;
                let off = marked(&breaks, &|i| {
                    self.is_off(&intervals(&own, breaks.span(i)), |s, k| {
                        let w = breaks.weights(i, s);
                        (0..ORDER).map(|j| w[j] * controls[k][i + j]).sum()
                    })
                });
                if !off.contains(&true) {
                    return Ok(self.written(&breaks, |i, k| {
                        let map = breaks.ordinates(i, breaks.span(i));
                        let own = std::array::from_fn::<[f64; 1], ORDER, _>(|j| [controls[k][i + j]]);
                        let ordinates = apply(&map, &own).map(|[v]| v);
                        (bends(&ordinates), ordinates[DEGREE])
                    }));
                }
                off
            } else {
                let spline = self.cubic(&breaks).ok_or_else(none)?;
                let piece = |i: usize, k: usize| spline.coefficients(i, k).unwrap_or([f64::NAN; 4]);
                let off = marked(&breaks, &|i| {
                    let from = breaks.span(i)[0];
                    self.is_off(&intervals(&own, breaks.span(i)), |s, k| {
                        piece(i, k).iter().rev().fold(0.0, |v, c| v * (s - from) + c)
                    })
                });
                if !off.contains(&true) {
                    return Ok(self.written(&breaks, |i, k| {
                        let ([a, b], [p, m, c, d]) = (breaks.span(i), piece(i, k));
                        let h = b - a;
                        ([c * h * h, d * h * h * h, 0.0, 0.0], p + h * (m + h * (c + h * d)))
                    }));
                }
                off
            };
            breaks = finer(&breaks, &own, &off).ok_or_else(none)?;
        }
        Err(none())
    }

    /// Blocks of the pieces; `word`: how a word bends on a piece, and where it ends.
    fn written(&self, breaks: &Breaks, word: impl Fn(usize, usize) -> ([f64; 4], f64)) -> Vec<Move> {
        let columns = self.run.machine.axes().len();
        let of = |i: usize| {
            let [a, b] = breaks.span(i);
            let all: Vec<([f64; 4], f64)> = (0..columns).map(|k| word(i, k)).collect();
            let bend = WordBends::from_fn(columns, |k| all[k].0);
            let words = Axes::from_fn(columns, |k| all[k].1);
            // The row itself where it is one: its time to the bit.
            let end = if i + 1 == breaks.spans() { self.moves[self.before + self.ends[1]] } else { self.at(b) };
            let start = self.at(a);
            let stretch = if i + 1 == breaks.spans() { end.stretch } else { start.stretch };
            Move { bend: Some(bend), span_mm: b - a, words: Some(words), stretch, ..end }
        };
        (0..breaks.spans()).map(of).collect()
    }
}

/// An interval, parted at the breaks of the curve inside it: between them words are smooth.
fn intervals(own: &Breaks, [a, b]: [f64; 2]) -> Vec<[f64; 2]> {
    let all = own.all();
    let inside = &all[all.partition_point(|s| *s <= a)..];
    let inside = inside.iter().copied().take_while(|s| *s < b);
    let ends: Vec<f64> = [a].into_iter().chain(inside).chain([b]).collect();
    ends.windows(2).map(|w| [w[0], w[1]]).collect()
}

/// Coefficients of `p²` to `p⁵`, from those of Bernstein's basis.
fn bends(o: &[f64; ORDER]) -> [f64; 4] {
    let mut d = *o;
    let mut out = [0.0; 4];
    for k in 1..=DEGREE {
        for j in 0..=DEGREE - k {
            d[j] = d[j + 1] - d[j];
        }
        if k >= 2 {
            out[k - 2] = crate::numerics::quintic::CHOOSE[k] * d[0];
        }
    }
    out
}

/// Further breaks in the spans that are marked: the one of the curve's own nearest to the middle,
/// or the middle.
fn finer(breaks: &Breaks, own: &Breaks, marked: &[bool]) -> Option<Breaks> {
    let mut out = Vec::new();
    for i in 0..breaks.spans() {
        let [a, b] = breaks.span(i);
        out.push(a);
        if marked[i] {
            let middle = 0.5 * (a + b);
            let within = own.all().iter().copied().filter(|s| *s > a && *s < b);
            out.push(within.min_by(|p, q| (p - middle).abs().total_cmp(&(q - middle).abs())).unwrap_or(middle));
        }
    }
    out.push(*breaks.all().last()?);
    Breaks::new(out)
}

/// The first row and all moves after it: blocks of the curve's pieces, as splines of degree 5 or 3,
/// and rows as `straight` has them elsewhere.
///
/// # Errors
/// `Infeasible` where no spline follows the curve.
pub(super) fn all(
    run: &OperationRun,
    curve: &ProgrammedCurve,
    degree: usize,
    words: &(dyn Fn(&Move) -> Axes + Sync),
    straight: impl Fn(&Motion, usize, &Move, &Move, &WordsOf) -> Result<Vec<Move>>,
) -> Result<Vec<Move>> {
    let motion = Motion::of(run.plan);
    let moves: Vec<Move> = Move::rows(run.plan).collect();
    let before = run.plan.leads[0].centres.len();
    let curved = |row: usize| {
        let way = row.checked_sub(before).and_then(|k| curve.rows.get(k)).map(|r| r.way);
        way.is_some_and(Way::is_curved)
    };
    let mut out = Vec::with_capacity(moves.len());
    out.extend(moves.first().copied());
    let mut row = 0;
    while row + 1 < moves.len() {
        if !curved(row) {
            out.extend(straight(&motion, row, &moves[row], &moves[row + 1], words)?);
            row += 1;
            continue;
        }
        let mut end = row + 1;
        while end + 1 < moves.len() && curved(end) {
            end += 1;
        }
        let ends = [row - before, end - before];
        let of = CurveRun { run, motion: &motion, curve, words, moves: &moves, before, ends };
        out.extend(of.blocks(degree)?);
        row = end;
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_those_of_the_polynomial() {
        let o = [0.3, -0.1, 0.7, 0.2, 0.9, -0.4];
        let a = bends(&o);
        for p in [0.0, 0.3, 0.8, 1.0f64] {
            let want = crate::numerics::quintic::at(&o.map(|v| [v]), 1.0, p)[0][0];
            let bent: f64 = a.iter().zip(2..).map(|(a, k)| a * (p.powi(k) - p)).sum();
            assert!((o[0] + (o[5] - o[0]) * p + bent - want).abs() < 1e-12, "{p}");
        }
    }

    #[test]
    fn breaks_are_added_from_the_curve_s_own_first() {
        let own = Breaks::new(vec![0.0, 1.0, 1.4, 2.0, 3.0]).expect("breaks");
        let thin = own.thinned(1.9);
        assert_eq!(thin.all(), [0.0, 3.0]);
        assert_eq!(intervals(&own, [0.5, 1.4]), [[0.5, 1.0], [1.0, 1.4]]);
        let once = finer(&thin, &own, &[true]).expect("breaks");
        assert_eq!(once.all(), [0.0, 1.4, 3.0]);
        let twice = finer(&once, &own, &[true, false]).expect("breaks");
        assert_eq!(finer(&twice, &own, &[true, false, false]).expect("breaks").all(), [0.0, 0.5, 1.0, 1.4, 3.0]);
    }
}
