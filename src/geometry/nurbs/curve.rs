//! A NURBS curve in space.
use nalgebra::Vector4;

use super::basis::{Basis, validate_knots};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};

/// A NURBS curve: clamped or unclamped knots, homogeneous control points `(w x, w y, w z, w)`.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct NurbsCurve {
    /// Degree, at least 1.
    pub degree: usize,
    /// Knots, non-decreasing, `points.len() + degree + 1` of them.
    pub knots: Vec<f64>,
    /// Homogeneous control points `(w x, w y, w z, w)`, `w > 0`, mm.
    pub points: Vec<Vector4<f64>>,
}

impl NurbsCurve {
    /// Checks that the curve can be evaluated: all other methods may panic or give nonsense on a
    /// curve that fails here.
    ///
    /// # Errors
    /// Knots ([`validate_knots`]), points that are not finite, weights that are not positive.
    pub fn validate(&self) -> Result<()> {
        validate_knots(self.degree, self.points.len(), &self.knots)
            .and_then(|()| validate_points(&self.points))
            .map_err(|m| Error::io(Stage::Model, format!("NURBS curve: {m}")))
    }

    /// First and last parameter.
    pub fn domain(&self) -> [f64; 2] {
        [self.knots[self.degree], self.knots[self.points.len()]]
    }

    /// The point at `t`, mm.
    pub fn point(&self, t: f64) -> Point {
        let b = Basis::new(self.degree, self.points.len(), &self.knots, t);
        let h: Vector4<f64> = b.value().iter().zip(&self.points[b.first..]).map(|(n, p)| p * *n).sum();
        Point::from(h.xyz() / h.w)
    }

    /// Point, first and second derivative at `t` (quotient rule, *The NURBS Book* eq. 4.8), mm per
    /// unit of the parameter.
    pub fn derivatives(&self, t: f64) -> (Point, Vector, Vector) {
        let b = Basis::new(self.degree, self.points.len(), &self.knots, t);
        let (mut h, mut h1, mut h2) = (Vector4::zeros(), Vector4::zeros(), Vector4::zeros());
        for (j, p) in self.points[b.first..=b.first + self.degree].iter().enumerate() {
            h += p * b.value()[j];
            h1 += p * b.d1()[j];
            h2 += p * b.d2()[j];
        }
        let p = h.xyz() / h.w;
        let d1 = (h1.xyz() - p * h1.w) / h.w;
        let d2 = (h2.xyz() - d1 * (2.0 * h1.w) - p * h2.w) / h.w;
        (Point::from(p), d1, d2)
    }
}

/// Control points farther away are damage, mm: squares of squares of what is nearer do not
/// overflow. (The middle one of a half circle in one piece is 1e17 radii away.)
pub const FARTHEST_MM: f64 = 1e50;
/// Weights beyond these are damage, for the same reason.
const WEIGHTS: std::ops::RangeInclusive<f64> = 1e-50..=1e50;

/// Checks that homogeneous points are finite with positive weights.
pub(super) fn validate_points(points: &[Vector4<f64>]) -> std::result::Result<(), String> {
    for (i, p) in points.iter().enumerate() {
        if p.iter().any(|x| !x.is_finite()) {
            return Err(format!("control point {i} is not finite"));
        }
        if p.w <= 0.0 {
            return Err(format!("control point {i} has weight {}, which is not positive", p.w));
        }
        let far = p.xyz().amax() / p.w;
        if !(far <= FARTHEST_MM && WEIGHTS.contains(&p.w)) {
            return Err(format!(
                "control point {i} is out of all bounds: {far:.3e} mm from the origin, weight {:.3e}",
                p.w
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter circle of radius 2 as a rational quadratic.
    fn quarter() -> NurbsCurve {
        let w = std::f64::consts::FRAC_1_SQRT_2;
        NurbsCurve {
            degree: 2,
            knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            points: vec![
                Vector4::new(2.0, 0.0, 1.0, 1.0),
                Vector4::new(2.0 * w, 2.0 * w, w, w),
                Vector4::new(0.0, 2.0, 1.0, 1.0),
            ],
        }
    }

    #[test]
    fn circle_and_its_curvature() {
        let c = quarter();
        assert!(c.validate().is_ok());
        for i in 0..=50 {
            let t = i as f64 / 50.0;
            let (p, d1, d2) = c.derivatives(t);
            assert!((p - c.point(t)).norm() < 1e-15);
            assert!((p.x.hypot(p.y) - 2.0).abs() < 1e-14 && (p.z - 1.0).abs() < 1e-14);
            let curvature = d1.cross(&d2).norm() / d1.norm().powi(3);
            assert!((curvature - 0.5).abs() < 1e-12);
            let h = 1e-6;
            let (l, r) = (c.derivatives(t - h), c.derivatives(t + h));
            assert!(((r.0 - l.0) / (2.0 * h) - d1).norm() < 1e-8);
            assert!(((r.1 - l.1) / (2.0 * h) - d2).norm() < 1e-8);
        }
    }

    #[test]
    fn bad_weights_and_points_are_refused() {
        let mut c = quarter();
        c.points[1].w = 0.0;
        assert!(c.validate().is_err());
        for (x, w) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (1e51, 1.0), (1.0, 1e-51), (1.0, 1e51), (1.0, f64::NAN)] {
            let mut c = quarter();
            c.points[1] = Vector4::new(x, 0.0, 0.0, w);
            assert!(c.validate().is_err(), "{x} {w}");
        }
        // A half circle in one piece.
        let mut c = quarter();
        c.points[1] = Vector4::new(0.0, 2.0, 0.0, 6.1e-17);
        assert!(c.validate().is_ok());
        let mut c = quarter();
        c.points[2].x = f64::INFINITY;
        assert!(c.validate().is_err());
        let mut c = quarter();
        c.knots.pop();
        assert!(c.validate().is_err());
    }
}
