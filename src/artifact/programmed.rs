//! The programmed curve of a plan, row by row: how ball centre and θ go between cutter locations.

use super::curve::{CurvePlace, CurveProof, LeftAsIs};
use super::{Axes, Toolpath, packed};
use crate::geometry::Vector;
use crate::numerics::quintic::{self, DEGREE, ORDER};

/// What begins at a cutter location.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// A straight move to the next location.
    #[default]
    Straight,
    /// A polynomial to the next location: a piece of the curve goes on.
    Within,
    /// A polynomial to the next location, with which a piece of the curve begins.
    Piece,
}

impl Way {
    /// The curve goes on to the next location.
    pub fn is_curved(self) -> bool {
        self != Way::Straight
    }
}

/// What the curve does at a cutter location.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CurveRow {
    /// Parameter of the curve, mm: arc length of the path that it was made from, from its start.
    pub s_mm: f64,
    /// First, second and third derivative of the ball centre by the parameter, blade frame, 1, 1/mm
    /// and 1/mm². Those of the curve where it comes here or goes on from here.
    pub centre: [[f64; 3]; 3],
    /// The same of θ, rad/mm, rad/mm² and rad/mm³.
    pub theta: [f64; 3],
    /// What begins here.
    pub way: Way,
}

/// What the motion was before the path was smoothed, under the same limits.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct BeforeCurve {
    /// Cutter locations.
    pub locations: usize,
    /// Time along the path, s.
    pub time_s: f64,
    /// Greatest jerk of each axis at the programmed feed held constant, mm/s³ or rad/s³.
    pub jerk: Axes,
    /// The same of the curve.
    pub jerk_now: Axes,
}

/// The curve. Between two locations it is, where the first says so, the polynomial of degree 5 with
/// the first's place and three derivatives, and the next one's first and second derivative; else
/// ball centre and θ go straight and evenly. A spline of degree 5 whose joints are among the
/// locations is met exactly: the place of the next location follows. Places are not differenced,
/// so third derivatives keep their digits where locations are micrometres apart.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ProgrammedCurve {
    /// One for each cutter location.
    #[serde(with = "rows")]
    pub rows: Vec<CurveRow>,
    /// Where the path stays as it is, in the curve's parameter.
    pub left: Vec<LeftAsIs>,
    /// What was proven of it: the worst of all its stretches.
    pub proof: CurveProof,
    /// What it was before.
    pub before: BeforeCurve,
}

/// Rows in files: a table of numbers.
mod rows {
    use serde::de::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::packed::Table;
    use super::{CurveRow, Way};

    const COLUMNS: [&str; 14] = [
        "s_mm", "c1_x", "c1_y", "c1_z", "c2_x", "c2_y", "c2_z", "c3_x", "c3_y", "c3_z", "theta1", "theta2", "theta3",
        "way",
    ];

    pub(super) fn serialize<S: Serializer>(rows: &[CurveRow], to: S) -> Result<S::Ok, S::Error> {
        let row = |r: &CurveRow| {
            let ([a, b, c], [t1, t2, t3]) = (r.centre, r.theta);
            let way = match r.way {
                Way::Straight => 0.0,
                Way::Within => 1.0,
                Way::Piece => 2.0,
            };
            [r.s_mm, a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], t1, t2, t3, way]
        };
        Table::of(COLUMNS, rows.iter().map(row)).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<CurveRow>, D::Error> {
        let rows = Table::deserialize(from)?.rows(COLUMNS).map_err(D::Error::custom)?;
        let row = |[s_mm, a0, a1, a2, b0, b1, b2, c0, c1, c2, t1, t2, t3, way]: [f64; 14]| {
            let way = match way {
                0.0 => Way::Straight,
                1.0 => Way::Within,
                2.0 => Way::Piece,
                _ => return Err(format!("{way} is no way of the curve: it is 0, 1 or 2")),
            };
            let centre = [[a0, a1, a2], [b0, b1, b2], [c0, c1, c2]];
            Ok(CurveRow { s_mm, centre, theta: [t1, t2, t3], way })
        };
        rows.into_iter().map(row).collect::<Result<_, String>>().map_err(D::Error::custom)
    }
}

/// A polynomial of ball centre and θ between two locations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {
    /// Where it begins; the fourth component is θ.
    pub from: [f64; 4],
    /// Coefficients of the Bernstein basis less the beginning.
    pub ordinates: [[f64; 4]; ORDER],
    /// Length of its parameter, mm.
    pub length_mm: f64,
}

impl Polynomial {
    /// With a place and its first three derivatives where it begins, and the first two where it
    /// ends; of each `[x, y, z, θ]`.
    pub fn between(from: [[f64; 4]; 4], to: [[f64; 4]; 2], length_mm: f64) -> Self {
        let h = length_mm;
        let at = |k: usize| {
            let ([_, d, dd, ddd], [e, ee]) = (from.map(|v| v[k]), to.map(|v| v[k]));
            let (first, second) = (h / 5.0, h * h / 20.0);
            let third = 3.0 * (first * d + second * dd) + h * h * h / 60.0 * ddd;
            let fourth = third + first * e - second * ee;
            [0.0, first * d, 2.0 * first * d + second * dd, third, fourth, fourth + first * e]
        };
        let of: [[f64; ORDER]; 4] = std::array::from_fn(at);
        Polynomial { from: from[0], ordinates: std::array::from_fn(|j| of.map(|o| o[j])), length_mm }
    }

    /// Place and derivatives by the parameter at a share of the way.
    pub fn at(&self, share: f64) -> CurvePlace {
        let mut all = quintic::at(&self.ordinates, self.length_mm, share);
        all[0] = std::array::from_fn(|c| self.from[c] + all[0][c]);
        CurvePlace { centre: all.map(|[x, y, z, _]| [x, y, z]), theta: all.map(|d| d[3]) }
    }

    /// How far the straight way from begin to end, ball centre and θ even, is off at the same share
    /// of it, at most: mm and rad, `h² max |c''|/8`.
    pub fn sagitta(&self) -> [f64; 2] {
        self.greatest(2).map(|d| d * self.length_mm * self.length_mm / 8.0)
    }

    /// Coefficients of the Bernstein basis of a derivative by the parameter: the first so many.
    pub fn derivative(&self, order: usize) -> ([[f64; 4]; ORDER], usize) {
        let mut o = self.ordinates;
        if order == 0 {
            o = o.map(|o| std::array::from_fn(|c| self.from[c] + o[c]));
        }
        for k in 0..order.min(DEGREE) {
            let factor = (DEGREE - k) as f64 / self.length_mm;
            for j in 0..DEGREE - k {
                o[j] = std::array::from_fn(|c| factor * (o[j + 1][c] - o[j][c]));
            }
        }
        (o, ORDER - order.min(DEGREE))
    }

    /// No derivative of the ball centre of that order is longer, nor any of θ greater.
    pub fn greatest(&self, order: usize) -> [f64; 2] {
        let (o, count) = self.derivative(order);
        o[..count].iter().fold([0.0; 2], |[c, t], v| [c.max(Vector::new(v[0], v[1], v[2]).norm()), t.max(v[3].abs())])
    }
}

impl ProgrammedCurve {
    /// The polynomial from a location to the next; `None` where the way is straight or there is no
    /// next one. `theta`: angles at the locations, rad.
    pub fn polynomial(&self, path: &Toolpath, theta: &[f64], row: usize) -> Option<Polynomial> {
        let (a, b) = (self.rows.get(row)?, self.rows.get(row + 1)?);
        let (p, theta) = (path.locations.get(row)?.centre, *theta.get(row)?);
        if !a.way.is_curved() {
            return None;
        }
        let derivative = |row: &CurveRow, k: usize| {
            let [x, y, z] = row.centre[k];
            [x, y, z, row.theta[k]]
        };
        let from = [[p.x, p.y, p.z, theta], derivative(a, 0), derivative(a, 1), derivative(a, 2)];
        Some(Polynomial::between(from, [derivative(b, 0), derivative(b, 1)], b.s_mm - a.s_mm))
    }

    /// Its rows with as many straight ones before and after, for leads. Parameters go on by
    /// `before_mm` and `after_mm`, lengths from the first location and from the last.
    #[must_use]
    pub fn extended(&self, before_mm: &[f64], after_mm: &[f64]) -> Self {
        let [first, last] = [self.rows.first(), self.rows.last()].map(|r| r.map_or(0.0, |r| r.s_mm));
        let straight = |s_mm: f64| CurveRow { s_mm, ..CurveRow::default() };
        let before = before_mm.iter().map(|d| straight(first + d));
        let after = after_mm.iter().map(|d| straight(last + d));
        let rows = before.chain(self.rows.iter().copied()).chain(after).collect();
        ProgrammedCurve { rows, ..self.clone() }
    }

    /// Pieces of the curve and straight moves: what a program of polynomials needs blocks for.
    pub fn blocks(&self) -> usize {
        let moves = self.rows.len().saturating_sub(1);
        self.rows[..moves].iter().filter(|r| r.way != Way::Within).count()
    }

    /// Locations at which the curve is, coming or going.
    pub fn is_on(&self, row: usize) -> bool {
        let curved = |k: usize| self.rows.get(k).is_some_and(|r| r.way.is_curved());
        curved(row) || row.checked_sub(1).is_some_and(curved)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_polynomial_has_what_it_is_made_of(v in prop::collection::vec(-2.0..2.0f64, 24), h in 0.05..3.0f64) {
            let of = |r: usize| std::array::from_fn(|c| v[4 * r + c]);
            let p = Polynomial::between([of(0), of(1), of(2), of(3)], [of(4), of(5)], h);
            let (from, to) = (p.at(0.0), p.at(1.0));
            for (got, order, row) in [(&from, 0, 0), (&from, 1, 1), (&from, 2, 2), (&from, 3, 3), (&to, 1, 4), (&to, 2, 5)] {
                let want: [f64; 4] = of(row);
                let size = 1e-12 * (1.0 + 400.0 / h.powi(order as i32));
                for c in 0..3 {
                    prop_assert!((got.centre[order][c] - want[c]).abs() < size, "{order}");
                }
                prop_assert!((got.theta[order] - want[3]).abs() < size, "{order}");
            }
            // Hulls hold.
            for order in 0..5 {
                let [most, turn] = p.greatest(order);
                for k in 0..=10 {
                    let at = p.at(f64::from(k) / 10.0);
                    prop_assert!(at.derivative(order).norm() <= most * (1.0 + 1e-9) + 1e-9);
                    prop_assert!(at.theta[order].abs() <= turn * (1.0 + 1e-9) + 1e-9);
                }
            }
        }
    }

    /// Third derivatives of a curve far from the origin, at locations two micrometres apart.
    #[test]
    fn short_steps_keep_third_derivatives() {
        let h = 2e-3;
        let wave = |s: f64, k: i32| if k % 2 == 0 { -(0.3 * s).sin() } else { (0.3 * s).cos() };
        let d = |s: f64, k: i32| wave(s, k) * 0.3f64.powi(k);
        let at = |s: f64| [d(s, 1), d(s, 2), -d(s, 3)];
        let row = |s: f64| at(s).map(|v| [v; 4]);
        let [a1, a2, a3] = row(0.4);
        let [b1, b2, _] = row(0.4 + h);
        let p = Polynomial::between([[300.0 + (0.3f64 * 0.4).sin(); 4], a1, a2, a3], [b1, b2], h);
        let (end, want) = (p.at(1.0), at(0.4 + h)[2]);
        assert!((end.theta[3] - want).abs() < 1e-8, "{} {want}", end.theta[3]);
        assert!((end.theta[0] - 300.0 - (0.3f64 * (0.4 + h)).sin()).abs() < 1e-13);
    }

    #[test]
    fn rows_come_back_from_files() {
        let row = CurveRow {
            s_mm: 0.1,
            centre: [[1.0, 2.0, 3.0], [4.0, 5.0, 6.5], [7.0, 8.0, 9.5]],
            theta: [0.3, -0.7, 0.1],
            way: Way::Piece,
        };
        let rows = vec![row, CurveRow { way: Way::Within, ..row }, CurveRow::default()];
        let curve = ProgrammedCurve { rows, ..ProgrammedCurve::default() };
        let text = serde_json::to_string(&curve).unwrap();
        assert_eq!(serde_json::from_str::<ProgrammedCurve>(&text).unwrap(), curve);
        assert_eq!((curve.blocks(), curve.is_on(2), curve.is_on(3)), (1, true, false));
        let longer = curve.extended(&[-2.0, -1.0], &[1.0]);
        let s: Vec<f64> = longer.rows.iter().map(|r| r.s_mm).collect();
        assert_eq!(s, [-1.9, -0.9, 0.1, 0.1, 0.0, 1.0]);
    }
}
