//! The whole part: a mesh always, exact NURBS faces where the model has them, and one distance query to all of it.

use super::brep::Brep;
use super::bvh::MeshBvh;
use super::mesh::Mesh;
use super::{Point, Vector};

/// The whole part in one frame.
#[derive(Clone)]
pub struct Part {
    /// Triangles of the whole part: the part itself where the model is a mesh, a tessellation where it is NURBS.
    pub mesh: Mesh,
    /// Tree over `mesh`.
    pub bvh: MeshBvh,
    /// Exact faces, if the model has them.
    pub brep: Option<Brep>,
    /// Greatest distance between `mesh` and the exact part, mm; 0 where the model is a mesh.
    pub deflection_mm: f64,
}

/// The closest point of the part to a query point.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    /// The closest point on the part.
    pub point: Point,
    /// Unsigned distance, mm.
    pub distance_mm: f64,
    /// Outward unit normal of the part there (on an edge or vertex: of one of its faces).
    pub normal: Vector,
    /// Face or group.
    pub face: u32,
    /// Triangle from which it was found.
    pub triangle: u32,
}

impl Part {
    /// A part that is a mesh.
    pub fn from_mesh(mesh: Mesh) -> Self {
        let bvh = MeshBvh::new(&mesh);
        Part { mesh, bvh, brep: None, deflection_mm: 0.0 }
    }
}
