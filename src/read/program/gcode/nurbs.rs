//! Curves of control points and knots: `G06.2` of Fanuc, `P` its rank, `K` its knots.
//!
//! A line has a control point with a knot, those behind the last control point a knot alone, as
//! many as the rank. A curve is read into its polynomial pieces, each with the number of the line
//! whose control point is the last that it needs.
//!
//! **Not read**: weights other than 1, whose curves are no polynomials, steps (G91), inverse time,
//! inches, and a first line without a control point.

use super::LineWords;
use super::words::CodeWord;
use crate::read::program::block::{Bend, Destination};

/// Ranks that controls have: degrees 1 to 3.
const RANKS: std::ops::RangeInclusive<usize> = 2..=4;
/// The rank of a curve that says none.
const RANK: usize = 4;
/// X, Y, Z and A, B, C.
const AXES: usize = 6;

/// A curve that is being read.
pub(super) struct Curve {
    rank: usize,
    /// Whether its first line names an axis.
    named: [bool; AXES],
    /// Control points, and their lines.
    points: Vec<([f64; AXES], usize)>,
    knots: Vec<f64>,
    /// Its first line.
    line: usize,
}

/// A polynomial piece of a curve.
pub(super) struct CurvePiece {
    pub line: usize,
    pub place: Destination,
    pub bend: Bend,
}

impl Curve {
    /// The curve that a line with `G06.2` begins.
    pub(super) fn begun(line: usize, said: &LineWords) -> Result<Self, String> {
        let rank = match said.p {
            None => RANK,
            Some(p) if p.fract() == 0.0 && RANKS.contains(&(p as usize)) => p as usize,
            Some(p) => return Err(format!("a curve of rank P{p}: 2 to 4 are read")),
        };
        let named: [bool; AXES] = std::array::from_fn(|k| word(said, k).is_some());
        if !named.contains(&true) {
            return Err("a curve without a control point in its first line is not read".into());
        }
        let mut curve = Curve { rank, named, points: Vec::new(), knots: Vec::new(), line };
        curve.take(line, said)?;
        Ok(curve)
    }

    /// Takes a further line; whether the curve is whole.
    pub(super) fn take(&mut self, line: usize, said: &LineWords) -> Result<bool, String> {
        if said.ijk[0].is_some() || said.ijk[1].is_some() || said.abc3.iter().any(Option::is_some) {
            return Err("a vector within a curve is not read".into());
        }
        if said.radius.is_some_and(|weight| weight != 1.0) {
            return Err("a curve with weights other than 1 (R) is not read".into());
        }
        let knot = said.ijk[2].ok_or("a line of a curve without its knot K")?;
        if self.knots.last().is_some_and(|last| knot < *last) {
            return Err(format!("the knot K{knot} is smaller than the one before"));
        }
        self.knots.push(knot);
        let words: [Option<f64>; AXES] = std::array::from_fn(|k| word(said, k));
        if words.iter().any(Option::is_some) {
            if self.knots.len() != self.points.len() + 1 {
                return Err("a control point behind a knot that stands alone".into());
            }
            if words.iter().zip(self.named).any(|(word, named)| word.is_some() && !named) {
                return Err("a control point with an axis that the first line of the curve does not name".into());
            }
            let before = self.points.last().map_or([0.0; AXES], |(p, _)| *p);
            self.points.push((std::array::from_fn(|k| words[k].unwrap_or(before[k])), line));
        }
        if self.knots.len() < self.points.len() + self.rank {
            return Ok(false);
        }
        self.check()?;
        Ok(true)
    }

    /// Where it has to end, for messages.
    pub(super) fn unfinished(&self) -> String {
        let (points, rank) = (self.points.len(), self.rank);
        format!(
            "the curve that line {} begins has {} knots for {points} control points of rank {rank}: {} are needed",
            self.line,
            self.knots.len(),
            points + rank
        )
    }

    fn check(&self) -> Result<(), String> {
        let (rank, n) = (self.rank, self.points.len());
        if n < rank {
            return Err(format!("a curve of rank {rank} with {n} control points"));
        }
        let same = |knots: &[f64]| knots.iter().all(|k| Some(k) == knots.first());
        if !same(&self.knots[..rank]) || !same(&self.knots[n..]) {
            return Err(format!("a curve of rank {rank} needs {rank} equal knots at either end"));
        }
        if let Some(i) = (1..n).find(|i| same(&self.knots[*i..i + rank])) {
            return Err(format!("{rank} equal knots K{} within the curve", self.knots[i]));
        }
        if self.knots[0] >= self.knots[n] {
            return Err("a curve whose knots are all equal".into());
        }
        Ok(())
    }

    /// Its pieces, the first with where it begins.
    pub(super) fn pieces(&self) -> Vec<CurvePiece> {
        let degree = self.rank - 1;
        let spans = (degree..self.points.len()).filter(|i| self.knots[*i] < self.knots[i + 1]);
        let mut out = Vec::new();
        for i in spans {
            let ordinates: Vec<[f64; AXES]> = (0..=degree).map(|ends| self.blossom(i, ends)).collect();
            let mut bend = Bend::default();
            let (first, last) = (ordinates[0], ordinates[degree]);
            for k in 0..AXES {
                let o: Vec<f64> = ordinates.iter().map(|o| o[k]).collect();
                let [square, cube] = match o[..] {
                    [a, b, c, d] => [3.0 * (a - 2.0 * b + c), d - 3.0 * c + 3.0 * b - a],
                    [a, b, c] => [a - 2.0 * b + c, 0.0],
                    _ => [0.0; 2],
                };
                let of = if k < 3 { &mut bend.point } else { &mut bend.rotary };
                of[k % 3] = [square, cube, 0.0, 0.0];
            }
            if out.is_empty() {
                let back = |k: usize| if self.named[k] { first[k] - last[k] } else { 0.0 };
                bend.begins = Some([[back(0), back(1), back(2)], [back(3), back(4), back(5)]]);
            }
            let to = |k: usize| self.named[k].then_some(last[k]);
            let place = Destination::Words { point: [to(0), to(1), to(2)], rotary: [to(3), to(4), to(5)] };
            out.push(CurvePiece { line: self.points[i].1, place, bend });
        }
        out
    }

    /// The blossom of a span at its beginning and, so many times, at its end: de Boor's recursion
    /// with a place of its own in each round.
    fn blossom(&self, span: usize, ends: usize) -> [f64; AXES] {
        let degree = self.rank - 1;
        let mut d: Vec<[f64; AXES]> = self.points[span - degree..=span].iter().map(|(p, _)| *p).collect();
        for r in 1..=degree {
            let at = self.knots[if r <= ends { span + 1 } else { span }];
            for j in (r..=degree).rev() {
                let i = span - degree + j;
                let (a, b) = (self.knots[i], self.knots[i + degree - r + 1]);
                let share = (at - a) / (b - a);
                d[j] = std::array::from_fn(|k| d[j - 1][k] * (1.0 - share) + d[j][k] * share);
            }
        }
        d[degree]
    }
}

/// Whether a word may stand within a curve, or ends it.
pub(super) fn knows(word: &CodeWord) -> bool {
    match word.address {
        "G" => {
            ["0", "1", "2", "3", "6.2"].contains(&word.value.trim_start_matches('0'))
                || word.value.trim_matches('0').is_empty()
        }
        address => ["N", "K", "R", "X", "Y", "Z", "A", "B", "C", "I", "J"].contains(&address),
    }
}

/// The word of an axis.
fn word(said: &LineWords, k: usize) -> Option<f64> {
    if k < 3 { said.point[k] } else { said.rotary[k - 3] }
}
