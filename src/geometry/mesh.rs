//! Triangle meshes.
use super::{Aabb, Point, Rigid, Vector};

/// An indexed triangle mesh; triangles are counter-clockwise seen from outside the part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices, mm.
    pub points: Vec<Point>,
    /// Corner indices.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: the face (of the B-rep) or the group (of a mesh file) that it belongs to; empty: all 0.
    pub face_of: Vec<u32>,
    /// Per triangle: (u, v) of its corners on that face; empty where the part is a mesh only.
    pub corner_uv: Vec<[[f64; 2]; 3]>,
}

impl Mesh {
    /// Corners of a triangle.
    pub fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|i| self.points[i as usize])
    }
    /// Face or group of a triangle.
    pub fn face(&self, triangle: usize) -> u32 {
        self.face_of.get(triangle).copied().unwrap_or(0)
    }
    /// Unit normal of a triangle, outward; zero where it is degenerate.
    pub fn normal(&self, triangle: usize) -> Vector {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_else(Vector::zeros)
    }
    /// Bounding box; `None` without points.
    pub fn aabb(&self) -> Option<Aabb> {
        Aabb::around(&self.points)
    }
    /// Total area, mm².
    pub fn area_mm2(&self) -> f64 {
        (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t);
                0.5 * (b - a).cross(&(c - a)).norm()
            })
            .sum()
    }
    /// Signed volume, mm³, by the divergence theorem; positive for a closed mesh with outward normals.
    pub fn volume_mm3(&self) -> f64 {
        (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t);
                a.coords.dot(&b.coords.cross(&c.coords)) / 6.0
            })
            .sum()
    }
    /// Moves all points.
    #[must_use]
    pub fn moved(mut self, to_from: &Rigid) -> Self {
        for p in &mut self.points {
            *p = to_from * *p;
        }
        self
    }
}
