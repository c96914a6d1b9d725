//! The programmed curve: where ball centre and tool axis go between cutter locations, smooth to the
//! fourth derivative.

use crate::error::WhyLeft;
use crate::geometry::{Point, Vector};
use crate::numerics::quintic::{self, Breaks, DEGREE, ORDER};

/// A curve through a path. Between its stretches the path stays as it is: straight moves from
/// location to location.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// In order of arc length; none overlaps another.
    pub stretches: Vec<CurveStretch>,
    /// Where the path stays as it is, arc length, mm.
    pub left: Vec<LeftAsIs>,
}

/// A part of a path that has no smooth curve.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct LeftAsIs {
    /// From and to, arc length from the start of the path, mm.
    pub s_mm: [f64; 2],
    /// Why.
    pub why: WhyLeft,
}

/// A curve over an interval of the path. Its parameter is the arc length of the path that it
/// replaces, mm; its own arc length is the same within the room along the path.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveStretch {
    /// Breaks of its pieces: arc length from the start of the path, mm.
    pub breaks: Breaks,
    /// Control points of the ball centre, blade frame, mm.
    pub centre: Vec<[f64; 3]>,
    /// Breaks of θ, some of those of the ball centre.
    pub theta_breaks: Breaks,
    /// Control values of θ, rad.
    pub theta: Vec<f64>,
    /// What is known of it.
    pub proof: CurveProof,
}

/// What is known of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct CurveProof {
    /// Nowhere is the ball deeper in the part, mm.
    pub inwards_mm: f64,
    /// Nowhere is the ball farther off the part, mm.
    pub outwards_mm: f64,
    /// `½ ∫ |c'''|² ds`, 1/mm³, or what the options made least instead.
    pub square: f64,
    /// No curve on the same breaks within the same limits has less.
    pub bound: f64,
    /// No curve that is where this one may be at the breaks has less, whatever its form; absent
    /// where it was not asked for.
    pub bound_of_any: Option<f64>,
    /// `½ ∫ θ'''² ds`, rad²/mm⁵.
    pub theta_square: f64,
    /// No θ on the same breaks within the same limits has less.
    pub theta_bound: f64,
    /// No spline of degree 5 in the same parameter, as near to the cutter locations as the options
    /// and this curve are, has fewer pieces; absent where the aim was not to have few.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pieces_bound: Option<usize>,
}

/// A place of a curve: values and derivatives by the parameter, up to the fifth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePlace {
    /// Ball centre, mm, and its derivatives.
    pub centre: [[f64; 3]; ORDER],
    /// θ, rad, and its derivatives.
    pub theta: [f64; ORDER],
}

impl CurvePlace {
    /// The ball centre.
    pub fn point(&self) -> Point {
        Point::from(self.centre[0])
    }

    /// A derivative of the ball centre.
    pub fn derivative(&self, order: usize) -> Vector {
        self.centre.get(order).map_or(Vector::zeros(), |d| Vector::from(*d))
    }
}

impl CurveStretch {
    /// Ordinates of the ball centre and θ on piece `i`; the fourth component is θ.
    pub fn ordinates(&self, i: usize) -> [[f64; 4]; ORDER] {
        let [a, b] = self.breaks.span(i);
        let centre = quintic::apply(&self.breaks.ordinates(i, [a, b]), &self.centre[i..]);
        let k = self.theta_breaks.span_of(0.5 * (a + b));
        let map = self.theta_breaks.ordinates(k, [a, b]);
        let theta = |j: usize| (0..ORDER).map(|c| map[j][c] * self.theta[k + c]).sum();
        std::array::from_fn(|j| [centre[j][0], centre[j][1], centre[j][2], theta(j)])
    }

    /// The place at `s_mm`, the nearest end where it is on no piece.
    pub fn at(&self, s_mm: f64) -> CurvePlace {
        let i = self.breaks.span_of(s_mm);
        let [a, b] = self.breaks.span(i);
        let share = ((s_mm - a) / (b - a)).clamp(0.0, 1.0);
        let all = quintic::at(&self.ordinates(i), b - a, share);
        CurvePlace { centre: all.map(|[x, y, z, _]| [x, y, z]), theta: all.map(|d| d[3]) }
    }

    /// The place at a share of piece `i`. Derivatives of θ are taken over its own breaks: where
    /// those of the ball centre are micrometres apart, differences over a piece would be lost in
    /// rounding.
    pub fn on_piece(&self, i: usize, share: f64) -> CurvePlace {
        let [a, b] = self.breaks.span(i);
        let own = quintic::apply(&self.breaks.ordinates(i, [a, b]), &self.centre[i..]);
        let k = self.theta_breaks.span_of(0.5 * (a + b));
        let [from, to] = self.theta_breaks.span(k);
        let controls: [[f64; 1]; ORDER] = std::array::from_fn(|c| [self.theta[k + c]]);
        let theta = quintic::apply(&self.theta_breaks.ordinates(k, [from, to]), &controls);
        let at = ((a + (b - a) * share - from) / (to - from)).clamp(0.0, 1.0);
        CurvePlace { centre: quintic::at(&own, b - a, share), theta: quintic::at(&theta, to - from, at).map(|[v]| v) }
    }

    /// Number of pieces.
    pub fn pieces(&self) -> usize {
        self.centre.len() - DEGREE
    }

    /// From and to, mm.
    pub fn s_mm(&self) -> [f64; 2] {
        let all = self.breaks.all();
        [all[0], all[all.len() - 1]]
    }
}

impl Curve {
    /// The stretch at `s_mm`; `None` where the path stays as it is.
    pub fn stretch_at(&self, s_mm: f64) -> Option<&CurveStretch> {
        let k = self.stretches.partition_point(|c| c.s_mm()[1] < s_mm);
        self.stretches.get(k).filter(|c| c.s_mm()[0] <= s_mm)
    }

    /// Number of pieces of all stretches.
    pub fn pieces(&self) -> usize {
        self.stretches.iter().map(CurveStretch::pieces).sum()
    }
}
