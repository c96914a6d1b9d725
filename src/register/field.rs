//! Signed distances to the part with their gradients: exact, to the mesh, and interpolated on a
//! grid.

use crate::geometry::measured::Closest;
use crate::geometry::part::Part;
use crate::geometry::{Aabb, Point, Vector};
use crate::parallel;

/// Where the way to the closest point is off the normal by less than this (cosine), the normal says
/// on which side a point is; else it is at an edge.
const ALONG_NORMAL: f64 = 0.9;

/// A signed distance, mm, positive outside the part, and its gradient.
pub(super) type Distance = (f64, Vector);

/// Something that distances are taken from.
pub(super) trait Field: Sync {
    /// The distance at a point; `None` where there is none.
    fn at(&self, q: &Point) -> Option<Distance>;
}

/// The part's exact faces, where it has them.
pub(super) struct Exact<'a>(pub &'a Part);

/// The part's triangles.
pub(super) struct Triangles<'a> {
    part: &'a Part,
    bounds: Aabb,
}

impl Field for Exact<'_> {
    fn at(&self, q: &Point) -> Option<Distance> {
        let near = self.0.closest(q, f64::INFINITY)?;
        Some(signed(q, &near, || self.0.inside(q)))
    }
}

impl<'a> Triangles<'a> {
    pub fn new(part: &'a Part) -> Self {
        let none = Aabb { min: Point::origin(), max: Point::origin() };
        Triangles { part, bounds: part.mesh.aabb().unwrap_or(none) }
    }

    /// The distance, where it is not greater.
    fn within(&self, q: &Point, most_mm: f64) -> Option<Distance> {
        let (part, Aabb { min, max }) = (self.part, self.bounds);
        let near = part.closest_on_mesh(q, most_mm)?;
        let inside = || {
            let bounded = (0..3).all(|i| (min[i]..=max[i]).contains(&q[i]));
            bounded
                && part.bvh.winding(&part.mesh, q).map_or((q - near.point).dot(&near.normal) < 0.0, |turns| turns > 0)
        };
        Some(signed(q, &near, inside))
    }
}

impl Field for Triangles<'_> {
    fn at(&self, q: &Point) -> Option<Distance> {
        self.within(q, f64::INFINITY)
    }
}

fn signed(q: &Point, near: &Closest, inside: impl FnOnce() -> bool) -> Distance {
    let away = q - near.point;
    let Some(direction) = away.try_normalize(1e-9) else { return (0.0, near.normal) };
    let along = direction.dot(&near.normal);
    let is_inside = if along.abs() > ALONG_NORMAL { along < 0.0 } else { inside() };
    if is_inside { (-near.distance_mm, -direction) } else { (near.distance_mm, direction) }
}

/// Distances at the nodes of a grid, linear in each direction between them: coarse, and a hundred
/// times as fast as asking the mesh.
pub(super) struct DistanceGrid {
    min: Point,
    /// Side of a cell, mm.
    pub step_mm: f64,
    count: [usize; 3],
    distance_mm: Vec<f32>,
}

/// About so many nodes.
const NODES: f64 = 200_000.0;

impl DistanceGrid {
    /// A grid over the part and so much beside it; `None` where the part has no triangle.
    pub fn new(part: &Part, beside_mm: f64) -> Option<Self> {
        let Aabb { min, max } = part.mesh.aabb()?;
        let (min, max) = (min - Vector::repeat(beside_mm), max + Vector::repeat(beside_mm));
        let size = max - min;
        let step_mm = (size.product() / NODES).cbrt();
        if !(step_mm > 0.0 && step_mm.is_finite()) {
            return None;
        }
        let count = [size.x, size.y, size.z].map(|s| (s / step_mm).ceil() as usize + 2);
        let [nx, ny, nz] = count;
        let mesh = &Triangles::new(part);
        let row = |k: usize| {
            let start = min + Vector::new(0.0, (k % ny) as f64, (k / ny) as f64) * step_mm;
            // No node is farther from the part than the one before it and the step between them.
            let mut most_mm = f64::INFINITY;
            let node = move |i: usize| {
                let q = start + Vector::x() * (i as f64 * step_mm);
                let (d, _) = mesh.within(&q, most_mm)?;
                most_mm = d.abs() + 1.001 * step_mm;
                Some(d as f32)
            };
            (0..nx).map(node).map(|d| d.unwrap_or(f32::NAN)).collect::<Vec<_>>()
        };
        let distance_mm = parallel::flat_map(0..ny * nz, row);
        Some(DistanceGrid { min, step_mm, count, distance_mm })
    }

    fn node(&self, [x, y, z]: [usize; 3]) -> Option<f64> {
        let [nx, ny, _] = self.count;
        self.distance_mm.get((z * ny + y) * nx + x).map(|d| f64::from(*d))
    }
}

impl Field for DistanceGrid {
    fn at(&self, q: &Point) -> Option<Distance> {
        let mut cell = [0usize; 3];
        let mut share = [0.0; 3];
        let mut beyond = Vector::zeros();
        for i in 0..3 {
            let at = (q[i] - self.min[i]) / self.step_mm;
            let held = at.clamp(0.0, (self.count[i] - 1) as f64 - 1e-6);
            beyond[i] = (at - held) * self.step_mm;
            cell[i] = held as usize;
            share[i] = held - cell[i] as f64;
        }
        let mut value = 0.0;
        let mut slope = Vector::zeros();
        for corner in 0..8usize {
            let up = [corner & 1, corner >> 1 & 1, corner >> 2];
            let node = self.node([cell[0] + up[0], cell[1] + up[1], cell[2] + up[2]])?;
            let weight = |i: usize| if up[i] == 1 { share[i] } else { 1.0 - share[i] };
            let sign = |i: usize| if up[i] == 1 { 1.0 } else { -1.0 };
            let [wx, wy, wz] = [weight(0), weight(1), weight(2)];
            value += node * wx * wy * wz;
            slope += Vector::new(sign(0) * wy * wz, sign(1) * wx * wz, sign(2) * wx * wy) * (node / self.step_mm);
        }
        let out = beyond.norm();
        if !(value.is_finite() && out.is_finite()) {
            return None;
        }
        // Beside the grid as far as its edge is, and on.
        Some(if out > 1e-6 { (value + out, beyond / out) } else { (value, slope) })
    }
}
