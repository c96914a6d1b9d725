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
    /// First and second derivative of the ball centre by the parameter, blade frame, 1 and 1/mm.
    /// Those of the curve where it comes here or goes on from here.
    pub centre: [[f64; 3]; 2],
    /// First and second derivative of θ, rad/mm and rad/mm².
    pub theta: [f64; 2],
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

/// The curve. Between two locations it is the one polynomial of degree 5 that has the places and
/// derivatives of both, where the first says so; else ball centre and θ go straight and evenly.
/// A spline of degree 5 whose joints are among the locations is met exactly: its pieces are fixed
/// by value, first and second derivative at both ends.
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

    const COLUMNS: [&str; 10] = ["s_mm", "c1_x", "c1_y", "c1_z", "c2_x", "c2_y", "c2_z", "theta1", "theta2", "way"];

    pub(super) fn serialize<S: Serializer>(rows: &[CurveRow], to: S) -> Result<S::Ok, S::Error> {
        let row = |r: &CurveRow| {
            let ([a, b], [t1, t2]) = (r.centre, r.theta);
            let way = match r.way {
                Way::Straight => 0.0,
                Way::Within => 1.0,
                Way::Piece => 2.0,
            };
            [r.s_mm, a[0], a[1], a[2], b[0], b[1], b[2], t1, t2, way]
        };
        Table::of(COLUMNS, rows.iter().map(row)).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<CurveRow>, D::Error> {
        let rows = Table::deserialize(from)?.rows(COLUMNS).map_err(D::Error::custom)?;
        let row = |[s_mm, a0, a1, a2, b0, b1, b2, t1, t2, way]: [f64; 10]| {
            let way = match way {
                0.0 => Way::Straight,
                1.0 => Way::Within,
                2.0 => Way::Piece,
                _ => return Err(format!("{way} is no way of the curve: it is 0, 1 or 2")),
            };
            Ok(CurveRow { s_mm, centre: [[a0, a1, a2], [b0, b1, b2]], theta: [t1, t2], way })
        };
        rows.into_iter().map(row).collect::<Result<_, String>>().map_err(D::Error::custom)
    }
}

/// A polynomial of ball centre and θ between two locations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {
    /// Coefficients of the Bernstein basis; the fourth component is θ.
    pub ordinates: [[f64; 4]; ORDER],
    /// Length of its parameter, mm.
    pub length_mm: f64,
}

impl Polynomial {
    /// Through places, first and second derivatives at both ends; of each `[x, y, z, θ]`.
    pub fn between(from: [[f64; 4]; 3], to: [[f64; 4]; 3], length_mm: f64) -> Self {
        let h = length_mm;
        let at = |k: usize| {
            let ([p, d, dd], [q, e, ee]) = (from.map(|v| v[k]), to.map(|v| v[k]));
            let (first, second) = (h / 5.0, h * h / 20.0);
            [p, p + first * d, p + 2.0 * first * d + second * dd, q - 2.0 * first * e + second * ee, q - first * e, q]
        };
        let of: [[f64; ORDER]; 4] = std::array::from_fn(at);
        Polynomial { ordinates: std::array::from_fn(|j| of.map(|o| o[j])), length_mm }
    }

    /// Place and derivatives by the parameter at a share of the way.
    pub fn at(&self, share: f64) -> CurvePlace {
        let all = quintic::at(&self.ordinates, self.length_mm, share);
        CurvePlace { centre: all.map(|[x, y, z, _]| [x, y, z]), theta: all.map(|d| d[3]) }
    }

    /// Coefficients of the Bernstein basis of a derivative by the parameter: the first so many.
    pub fn derivative(&self, order: usize) -> ([[f64; 4]; ORDER], usize) {
        let mut o = self.ordinates;
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
        let (p, q) = (path.locations.get(row)?, path.locations.get(row + 1)?);
        let (t, u) = (*theta.get(row)?, *theta.get(row + 1)?);
        if !a.way.is_curved() {
            return None;
        }
        let place = |row: &CurveRow, c: &crate::geometry::Point, theta: f64| {
            let [d, dd] = row.centre;
            [[c.x, c.y, c.z, theta], [d[0], d[1], d[2], row.theta[0]], [dd[0], dd[1], dd[2], row.theta[1]]]
        };
        Some(Polynomial::between(place(a, &p.centre, t), place(b, &q.centre, u), b.s_mm - a.s_mm))
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
            let of = |k: usize| std::array::from_fn(|r| std::array::from_fn(|c| v[12 * k + 4 * r + c]));
            let (from, to): ([[f64; 4]; 3], [[f64; 4]; 3]) = (of(0), of(1));
            let p = Polynomial::between(from, to, h);
            for (share, want) in [(0.0, from), (1.0, to)] {
                let got = p.at(share);
                for r in 0..3 {
                    let size = 1e-12 * 400.0 / h.powi(r as i32);
                    for c in 0..3 {
                        prop_assert!((got.centre[r][c] - want[r][c]).abs() < size.max(1e-12));
                    }
                    prop_assert!((got.theta[r] - want[r][3]).abs() < size.max(1e-12));
                }
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

    #[test]
    fn rows_come_back_from_files() {
        let row =
            CurveRow { s_mm: 0.1, centre: [[1.0, 2.0, 3.0], [4.0, 5.0, 6.5]], theta: [0.3, -0.7], way: Way::Piece };
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
