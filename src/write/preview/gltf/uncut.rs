//! Places that no ball of this radius can reach, as little squares on the part in a colour of their
//! own.

use gltf_json as json;
use json::Index;
use json::scene::Node;
use serde_json::json;

use super::blade::{corner_normals, primitive};
use super::glb::Glb;
use super::{Scene, mesh_node};
use crate::error::Result;
use crate::geometry::Vector;
use crate::geometry::mesh::Mesh;

/// Most squares.
const MOST: usize = 20_000;
/// Red.
const COLOUR: [f32; 3] = [0.85, 0.05, 0.05];

/// The node, or `None` where all can be reached.
pub(super) fn node(glb: &mut Glb, scene: &Scene) -> Result<Option<Index<Node>>> {
    let Some(checks) = scene.checks.filter(|c| !c.uncut.is_empty()) else { return Ok(None) };
    let (places, cell_mm2) = (&checks.uncut, checks.uncut_cell_mm2);
    let every = places.len().div_ceil(MOST);
    let half = 0.5 * (cell_mm2 * every as f64).max(0.0).sqrt();
    let mut mesh = Mesh::default();
    for place in places.iter().step_by(every) {
        let n = place.normal;
        let aside = if n.x.abs() < 0.8 { Vector::x() } else { Vector::y() };
        let e = n.cross(&aside).normalize() * half;
        let f = n.cross(&e);
        // A little over the surface, so that it is seen.
        let p = place.point + n * (0.05 * half);
        let first = u32::try_from(mesh.points.len()).unwrap_or(0);
        mesh.points.extend([p - e - f, p + e - f, p + e + f, p - e + f]);
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    let mesh = mesh.moved(&scene.blade.model_from_blade);
    let normals = corner_normals(&mesh, 0.5);
    let all: Vec<usize> = (0..mesh.triangles.len()).collect();
    let material = glb.material("uncut", COLOUR, true);
    let shown = primitive(glb, &mesh, &normals, &all, material)?;
    let note = json!({
        "places": places.len(),
        "shown_one_in": every,
        "area_mm2": places.len() as f64 * cell_mm2,
        "highest_left_mm": places.iter().map(|p| p.left_mm).fold(0.0, f64::max),
    });
    Ok(Some(mesh_node(glb, "uncut", vec![shown], note)))
}
