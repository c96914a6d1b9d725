//! Geometry shared by all stages: points, meshes, NURBS, boundary representation, distance to a
//! part. Millimetres and radians throughout.

pub mod allowance;
pub mod boundary;
pub mod brep;
pub mod bvh;
pub mod disc;
pub mod exact;
pub mod measured;
pub mod mesh;
pub mod near_disc;
pub mod nurbs;
pub mod opposite;
pub mod part;
pub mod profile;
pub mod slice;
pub mod tessellate;
pub mod triangle;

/// A point, mm.
pub type Point = nalgebra::Point3<f64>;
/// A vector, mm or without unit.
pub type Vector = nalgebra::Vector3<f64>;
/// A rigid motion; `a_from_b * point_in_b` is the point in `a`.
pub type Rigid = nalgebra::Isometry3<f64>;
/// A box with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Aabb {
    /// Least coordinates, mm.
    pub min: Point,
    /// Greatest coordinates, mm.
    pub max: Point,
}

impl Aabb {
    /// The smallest box around the points; `None` without points.
    pub fn around<'a>(points: impl IntoIterator<Item = &'a Point>) -> Option<Self> {
        let mut it = points.into_iter();
        let first = *it.next()?;
        Some(it.fold(Aabb { min: first, max: first }, |b, p| Aabb { min: b.min.inf(p), max: b.max.sup(p) }))
    }
    /// Length of the space diagonal, mm.
    pub fn diagonal_mm(&self) -> f64 {
        (self.max - self.min).norm()
    }
}
