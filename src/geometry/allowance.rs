//! A part under an even allowance of stock: what a roughing or semi-finishing pass leaves on it.
//!
//! Its surface is the `stock_mm` level set of the distance to the part, so its own distance is that
//! to the part less the allowance, and its normals are those of the part. Everything that is
//! planned against a part or measured on one can be planned against this and measured on it
//! instead. With an allowance of 0 it is the part.

use super::Point;
use super::measured::Closest;
use super::nurbs::Principal;
use super::part::Part;

/// A part and the stock left on it; all that is not about distances is the part's own.
#[derive(Clone, Copy)]
pub struct Allowed<'a> {
    part: &'a Part,
    /// Thickness of the stock, mm.
    pub stock_mm: f64,
}

impl<'a> Allowed<'a> {
    /// `stock_mm` of stock on `part`.
    pub fn new(part: &'a Part, stock_mm: f64) -> Self {
        Allowed { part, stock_mm }
    }

    /// The closest point of the stock's surface to `q`, see [`Part::closest`]. `None` where it is
    /// farther than `cap_mm`.
    pub fn closest(&self, q: &Point, cap_mm: f64) -> Option<Closest> {
        if self.stock_mm == 0.0 {
            return self.part.closest(q, cap_mm);
        }
        let near = self.part.closest(q, cap_mm + self.stock_mm)?;
        let normal = (q - near.point).try_normalize(1e-12).unwrap_or(near.normal);
        let point = near.point + normal * self.stock_mm;
        let distance_mm = (near.distance_mm - self.stock_mm).abs();
        (distance_mm <= cap_mm).then_some(Closest { point, distance_mm, normal, ..near })
    }

    /// Principal curvatures of the stock's surface, see [`Part::curvature_at`]: every radius grows
    /// by the allowance. `None` also where a concave radius is no greater than the allowance.
    pub fn curvature_at(&self, at: &Closest) -> Option<Principal> {
        let bend = self.part.curvature_at(at)?;
        let [a, b] = bend.curvature.map(|k| 1.0 - k * self.stock_mm);
        (a > 0.0 && b > 0.0)
            .then(|| Principal { curvature: [bend.curvature[0] / a, bend.curvature[1] / b], direction: bend.direction })
    }

    /// Area of the stock's surface over an area of the part, by the curvature of the part there; 1
    /// where it is not known.
    pub fn area_ratio(&self, at: Option<&Closest>) -> f64 {
        let bend = at.and_then(|at| self.part.curvature_at(at));
        bend.map_or(1.0, |b| b.curvature.iter().map(|k| (1.0 - k * self.stock_mm).max(0.0)).product())
    }
}

impl std::ops::Deref for Allowed<'_> {
    type Target = Part;
    fn deref(&self) -> &Part {
        self.part
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::brep::{Brep, Face, SurfaceKind};
    use crate::geometry::nurbs::shapes::sphere;
    use crate::observe::Silent;

    #[test]
    fn stock_on_a_ball_is_a_greater_ball() {
        let face = Face {
            name: "ball".into(),
            kind: SurfaceKind::Sphere,
            surface: sphere(5.0),
            reversed: false,
            loops: vec![],
        };
        let part = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &Silent).unwrap();
        let stock = Allowed::new(&part, 0.7);
        let q = Point::new(3.0, 4.0, 6.0);
        let c = stock.closest(&q, 10.0).unwrap();
        assert!((c.distance_mm - (61f64.sqrt() - 5.7)).abs() < 1e-9);
        assert!((c.point.coords.norm() - 5.7).abs() < 1e-9 && (c.normal - q.coords.normalize()).norm() < 1e-9);
        assert!(stock.closest(&q, 2.0).is_none());
        // Within the stock, distances are to its surface too.
        let inside = stock.closest(&Point::new(5.5, 0.0, 0.0), 10.0).unwrap();
        assert!((inside.distance_mm - 0.2).abs() < 1e-9);
        let bend = stock.curvature_at(&c).unwrap();
        assert!(bend.curvature.iter().all(|k| (k + 1.0 / 5.7).abs() < 1e-9), "{:?}", bend.curvature);
        assert!((stock.area_ratio(Some(&c)) - (5.7f64 / 5.0).powi(2)).abs() < 1e-9);
        assert_eq!(Allowed::new(&part, 0.0).closest(&q, 10.0).unwrap().point, part.closest(&q, 10.0).unwrap().point);
    }
}
