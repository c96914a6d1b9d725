//! A NURBS surface in space.
use nalgebra::Vector4;

use super::basis::{Basis, validate_knots};
use super::curve::validate_points;
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};

/// A tensor-product NURBS surface.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct NurbsSurface {
    /// Degree along u, at least 1.
    pub degree_u: usize,
    /// Degree along v, at least 1.
    pub degree_v: usize,
    /// Knots along u, non-decreasing, `n_u + degree_u + 1` of them.
    pub knots_u: Vec<f64>,
    /// Knots along v, non-decreasing, `n_v + degree_v + 1` of them.
    pub knots_v: Vec<f64>,
    /// Number of control points along u.
    pub n_u: usize,
    /// Number of control points along v.
    pub n_v: usize,
    /// Homogeneous control points `(w x, w y, w z, w)`, `w > 0`, mm; index `i_u * n_v + i_v`.
    pub points: Vec<Vector4<f64>>,
}

/// Point and derivatives of a surface at one parameter pair, mm per unit of the parameters.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceDerivatives {
    /// The point.
    pub p: Point,
    /// ∂S/∂u.
    pub du: Vector,
    /// ∂S/∂v.
    pub dv: Vector,
    /// ∂²S/∂u².
    pub duu: Vector,
    /// ∂²S/∂u∂v.
    pub duv: Vector,
    /// ∂²S/∂v².
    pub dvv: Vector,
}

/// Principal curvatures of a surface, signed towards `S_u × S_v` (a sphere whose normal points
/// outwards has two of −1/r).
#[derive(Clone, Copy, Debug)]
pub struct Principal {
    /// Curvatures, 1/mm, the greater first.
    pub curvature: [f64; 2],
    /// Unit directions in space, at right angles to one another.
    pub direction: [Vector; 2],
}

impl Principal {
    /// The same curvatures, signed towards the opposite normal.
    #[must_use]
    pub fn seen_from_behind(&self) -> Self {
        let [a, b] = self.direction;
        Principal { curvature: [-self.curvature[1], -self.curvature[0]], direction: [b, a] }
    }
}

impl SurfaceDerivatives {
    /// Unit normal `S_u × S_v`; `None` where the surface is degenerate (a pole, a cusp).
    pub fn normal(&self) -> Option<Vector> {
        let n = self.du.cross(&self.dv);
        // Relative: at a pole one derivative vanishes, and what is left of it is rounding.
        let size = self.du.norm() * self.dv.norm();
        if size > 0.0 && n.norm() > 1e-10 * size { Some(n.normalize()) } else { None }
    }

    /// The unit normal and the principal curvatures, the greater first: as [`Self::principal`],
    /// without directions, for a third of the time.
    pub fn bent(&self) -> Option<(Vector, [f64; 2])> {
        let n = self.normal()?;
        let (_, _, [w11, w12, w22]) = self.shape_operator(&n);
        let (mean, half) = (0.5 * (w11 + w22), 0.5 * (w11 - w22));
        let radius = (half * half + w12 * w12).sqrt();
        Some((n, [mean + radius, mean - radius]))
    }

    /// An orthonormal tangent frame, the first axis along S_u, and the second form in it: first,
    /// mixed, second.
    #[inline]
    fn shape_operator(&self, n: &Vector) -> (Vector, Vector, [f64; 3]) {
        // e1 along S_u, e2 = n × e1; S_u = a e1, S_v = b e1 + c e2.
        let a = self.du.norm();
        let e1 = self.du / a;
        let e2 = n.cross(&e1);
        let (b, c) = (self.dv.dot(&e1), self.dv.dot(&e2));
        let (l, m, nn) = (self.duu.dot(n), self.duv.dot(n), self.dvv.dot(n));
        // W = A⁻¹ II A⁻ᵀ for A rows (a, 0), (b, c).
        let w11 = l / (a * a);
        let w12 = (m - b * l / a) / (a * c);
        let w22 = (nn - 2.0 * b * m / a + b * b * l / (a * a)) / (c * c);
        (e1, e2, [w11, w12, w22])
    }

    /// Principal curvatures from the first and second fundamental forms (do Carmo, *Differential
    /// Geometry of Curves and Surfaces*, 3-3); `None` where there is no normal.
    pub fn principal(&self) -> Option<Principal> {
        let n = self.normal()?;
        let (e1, e2, [w11, w12, w22]) = self.shape_operator(&n);
        let (mean, half) = (0.5 * (w11 + w22), 0.5 * (w11 - w22));
        let radius = half.hypot(w12);
        let angle = 0.5 * w12.atan2(half);
        let d1 = e1 * angle.cos() + e2 * angle.sin();
        Some(Principal { curvature: [mean + radius, mean - radius], direction: [d1, n.cross(&d1)] })
    }
}

impl NurbsSurface {
    /// The bilinear surface over [0, 1]² through S(0,0), S(0,1), S(1,0), S(1,1), homogeneous; flat
    /// where they are.
    pub fn bilinear(corners: [Vector4<f64>; 4]) -> Self {
        let knots = vec![0.0, 0.0, 1.0, 1.0];
        NurbsSurface {
            degree_u: 1,
            degree_v: 1,
            knots_u: knots.clone(),
            knots_v: knots,
            n_u: 2,
            n_v: 2,
            points: corners.to_vec(),
        }
    }

    /// Checks that the surface can be evaluated: all other methods may panic or give nonsense on
    /// one that fails here.
    ///
    /// # Errors
    /// Knots ([`validate_knots`]), number of points, points that are not finite, weights that are
    /// not positive.
    pub fn validate(&self) -> Result<()> {
        let check = || {
            validate_knots(self.degree_u, self.n_u, &self.knots_u).map_err(|m| format!("along u: {m}"))?;
            validate_knots(self.degree_v, self.n_v, &self.knots_v).map_err(|m| format!("along v: {m}"))?;
            if self.n_u.checked_mul(self.n_v) != Some(self.points.len()) {
                return Err(format!("{} control points are not {} × {}", self.points.len(), self.n_u, self.n_v));
            }
            validate_points(&self.points)
        };
        check().map_err(|m| Error::io(Stage::Model, format!("NURBS surface: {m}")))
    }

    /// Parameter range: `[[u0, u1], [v0, v1]]`.
    pub fn domain(&self) -> [[f64; 2]; 2] {
        [[self.knots_u[self.degree_u], self.knots_u[self.n_u]], [self.knots_v[self.degree_v], self.knots_v[self.n_v]]]
    }

    /// The point at (u, v), mm.
    pub fn point(&self, u: f64, v: f64) -> Point {
        let (bu, bv) = self.bases(u, v);
        let mut h = Vector4::zeros();
        for (i, nu) in bu.value().iter().enumerate() {
            let row = &self.points[(bu.first + i) * self.n_v + bv.first..];
            h += bv.value().iter().zip(row).map(|(nv, p)| p * *nv).sum::<Vector4<f64>>() * *nu;
        }
        Point::from(h.xyz() / h.w)
    }

    /// Point and all first and second derivatives at (u, v): homogeneous sums, then the quotient
    /// rule (*The NURBS Book* eq. 4.20). Outside the domain the nearest polynomial piece is
    /// continued.
    pub fn derivatives(&self, u: f64, v: f64) -> SurfaceDerivatives {
        let (bu, bv) = self.bases(u, v);
        let mut h = [Vector4::zeros(); 6];
        let (nu, nu1, nu2) = (bu.value(), bu.d1(), bu.d2());
        for i in 0..=self.degree_u {
            let start = (bu.first + i) * self.n_v + bv.first;
            let row = &self.points[start..=start + self.degree_v];
            let (mut r, mut r1, mut r2) = (Vector4::zeros(), Vector4::zeros(), Vector4::zeros());
            for (((p, a), b), c) in row.iter().zip(bv.value()).zip(bv.d1()).zip(bv.d2()) {
                r += p * *a;
                r1 += p * *b;
                r2 += p * *c;
            }
            h[0] += r * nu[i];
            h[1] += r * nu1[i];
            h[2] += r1 * nu[i];
            h[3] += r * nu2[i];
            h[4] += r1 * nu1[i];
            h[5] += r2 * nu[i];
        }
        quotient(&h)
    }

    /// Unit normal `S_u × S_v`; `None` where the surface is degenerate.
    pub fn normal(&self, u: f64, v: f64) -> Option<Vector> {
        self.derivatives(u, v).normal()
    }

    /// Principal curvatures at (u, v); `None` where the surface is degenerate.
    pub fn curvature(&self, u: f64, v: f64) -> Option<Principal> {
        self.derivatives(u, v).principal()
    }

    fn bases(&self, u: f64, v: f64) -> (Basis, Basis) {
        (Basis::new(self.degree_u, self.n_u, &self.knots_u, u), Basis::new(self.degree_v, self.n_v, &self.knots_v, v))
    }
}

/// From homogeneous (·, u, v, uu, uv, vv) to the point and its derivatives in space.
fn quotient(h: &[Vector4<f64>; 6]) -> SurfaceDerivatives {
    let w = 1.0 / h[0].w;
    let p = h[0].xyz() * w;
    let du = (h[1].xyz() - p * h[1].w) * w;
    let dv = (h[2].xyz() - p * h[2].w) * w;
    SurfaceDerivatives {
        p: Point::from(p),
        du,
        dv,
        duu: (h[3].xyz() - du * (2.0 * h[1].w) - p * h[3].w) * w,
        duv: (h[4].xyz() - du * h[2].w - dv * h[1].w - p * h[4].w) * w,
        dvv: (h[5].xyz() - dv * (2.0 * h[2].w) - p * h[5].w) * w,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::nurbs::shapes::{cylinder, loft, sphere, torus};

    fn differences(s: &NurbsSurface, tolerance: f64) {
        let [[u0, u1], [v0, v1]] = s.domain();
        let h = 1e-5;
        for i in 0..12 {
            for j in 0..12 {
                let (u, v) = (u0 + (u1 - u0) * (i as f64 + 0.37) / 12.0, v0 + (v1 - v0) * (j as f64 + 0.41) / 12.0);
                let d = s.derivatives(u, v);
                assert!((d.p - s.point(u, v)).norm() < 1e-12);
                let (l, r) = (s.derivatives(u - h, v), s.derivatives(u + h, v));
                let (b, t) = (s.derivatives(u, v - h), s.derivatives(u, v + h));
                let check =
                    |a: Vector, b: Vector| assert!((a - b).norm() < tolerance * (1.0 + 0.1 * b.norm()), "{a} {b}");
                check((r.p - l.p) / (2.0 * h), d.du);
                check((t.p - b.p) / (2.0 * h), d.dv);
                check((r.du - l.du) / (2.0 * h), d.duu);
                check((t.du - b.du) / (2.0 * h), d.duv);
                check((t.dv - b.dv) / (2.0 * h), d.dvv);
            }
        }
    }

    #[test]
    fn derivatives_match_differences() {
        differences(&cylinder(3.0, 10.0), 1e-6);
        differences(&sphere(4.0), 1e-6);
        differences(&torus(10.0, 3.0), 1e-6);
        differences(&loft(), 2e-5);
    }

    #[test]
    fn principal_curvatures_in_closed_form() {
        let c = cylinder(3.0, 10.0).curvature(0.3, 0.6).unwrap();
        assert!(c.curvature[0].abs() < 1e-12 && (c.curvature[1] + 1.0 / 3.0).abs() < 1e-12);
        assert!((c.direction[0].z.abs() - 1.0).abs() < 1e-12);
        let c = sphere(4.0).curvature(0.3, 0.6).unwrap();
        assert!(c.curvature.iter().all(|k| (k + 0.25).abs() < 1e-11), "{c:?}");
        let t = torus(10.0, 3.0);
        for (u, v) in [(0.1, 0.2), (0.6, 0.9), (0.33, 0.45)] {
            let d = t.derivatives(u, v);
            let rho = d.p.x.hypot(d.p.y);
            let c = d.principal().unwrap();
            let (a, b) = (-1.0 / 3.0, -(rho - 10.0) / (3.0 * rho));
            assert!((c.curvature[1] - a).abs() < 1e-11 && (c.curvature[0] - b).abs() < 1e-11, "{c:?} {b}");
        }
        assert!(sphere(4.0).normal(0.3, 0.0).is_none(), "a pole has no normal of its own");
    }

    #[test]
    fn bad_surfaces_are_refused() {
        let mut s = sphere(1.0);
        assert!(s.validate().is_ok());
        s.n_u += 1;
        assert!(s.validate().is_err());
        let mut s = sphere(1.0);
        s.points.pop();
        assert!(s.validate().is_err());
    }
}
