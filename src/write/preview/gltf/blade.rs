//! The blade as smooth-shaded triangles, one primitive for each kind of face.

use std::collections::{BTreeMap, HashMap};

use gltf_json as json;
use json::Index;
use json::material::Material;
use json::mesh::{Mode, Primitive, Semantic};
use json::scene::Node;
use serde_json::json;

use super::glb::Glb;
use super::{mesh_node, triple};
use crate::artifact::Blade;
use crate::artifact::region::Area;
use crate::error::Result;
use crate::geometry::Vector;
use crate::geometry::brep::SurfaceKind;
use crate::geometry::mesh::Mesh;
use crate::write::preview::thin::thinned;

/// The part as it is drawn, one primitive for each kind of face.
pub(super) struct Shown {
    pub primitives: Vec<Primitive>,
    /// What the node says of it.
    note: serde_json::Value,
}

/// The node.
pub(super) fn node(glb: &mut Glb, shown: &Shown) -> Index<Node> {
    mesh_node(glb, "blade", shown.primitives.clone(), shown.note.clone())
}

/// What is drawn of the part, with about so many triangles at most; `None` where it has none.
pub(super) fn primitives(glb: &mut Glb, blade: &Blade, triangles: usize, crease_deg: f64) -> Result<Option<Shown>> {
    let (mesh, cell) = thinned(&blade.part.mesh, triangles);
    let mesh = mesh.moved(&blade.model_from_blade);
    if mesh.triangles.is_empty() {
        return Ok(None);
    }
    let normals = corner_normals(&mesh, crease_deg.to_radians().cos());
    let mut by_kind: BTreeMap<Option<SurfaceKind>, Vec<usize>> = BTreeMap::new();
    for t in 0..mesh.triangles.len() {
        by_kind.entry(kind(blade, mesh.face(t))).or_default().push(t);
    }
    let mut primitives = Vec::new();
    for (kind, triangles) in &by_kind {
        let (name, rgb) = look(*kind);
        let material = glb.material(name, rgb, true);
        primitives.push(primitive(glb, &mesh, &normals, triangles, material)?);
    }
    let note = json!({
        "triangles": mesh.triangles.len(),
        "triangles_of_part": blade.part.mesh.triangles.len(),
        "thinned_on_a_grid_of_mm": cell,
    });
    Ok(Some(Shown { primitives, note }))
}

/// The part, one primitive and colour for each [`Area`]; `None` without triangles.
pub(super) fn regions_node(glb: &mut Glb, mesh: &Mesh, areas: &[Area], crease_deg: f64) -> Result<Option<Index<Node>>> {
    if mesh.triangles.is_empty() {
        return Ok(None);
    }
    let normals = corner_normals(mesh, crease_deg.to_radians().cos());
    let mut by_area: BTreeMap<Area, Vec<usize>> = BTreeMap::new();
    for t in 0..mesh.triangles.len() {
        by_area.entry(areas.get(t).copied().unwrap_or(Area::Other)).or_default().push(t);
    }
    let mut primitives = Vec::new();
    for (area, triangles) in &by_area {
        let (name, rgb) = colour(*area);
        let material = glb.material(name, rgb, true);
        primitives.push(primitive(glb, mesh, &normals, triangles, material)?);
    }
    Ok(Some(mesh_node(glb, "regions", primitives, json!({ "triangles": mesh.triangles.len() }))))
}

fn colour(area: Area) -> (&'static str, [f32; 3]) {
    match area {
        Area::Airfoil => ("airfoil", [0.10, 0.35, 0.75]),
        Area::Fillet => ("fillet", [0.90, 0.45, 0.05]),
        Area::Platform => ("platform", [0.15, 0.60, 0.25]),
        Area::Root => ("root", [0.45, 0.40, 0.35]),
        Area::Tip => ("tip", [0.70, 0.10, 0.25]),
        Area::Other => ("other", [0.60, 0.60, 0.62]),
    }
}

fn kind(blade: &Blade, face: u32) -> Option<SurfaceKind> {
    let faces = &blade.part.brep.as_ref()?.faces;
    faces.get(usize::try_from(face).ok()?).map(|f| f.kind)
}

fn look(kind: Option<SurfaceKind>) -> (&'static str, [f32; 3]) {
    match kind {
        None => ("mesh", [0.52, 0.55, 0.60]),
        Some(SurfaceKind::BSpline) => ("free-form faces", [0.52, 0.55, 0.60]),
        Some(SurfaceKind::Plane) => ("planes", [0.42, 0.40, 0.36]),
        Some(SurfaceKind::Cylinder) => ("cylinders", [0.36, 0.44, 0.48]),
        Some(SurfaceKind::Cone) => ("cones", [0.36, 0.46, 0.40]),
        Some(SurfaceKind::Sphere) => ("spheres", [0.48, 0.40, 0.46]),
        Some(SurfaceKind::Torus) => ("tori", [0.50, 0.44, 0.34]),
        Some(SurfaceKind::Revolution) => ("surfaces of revolution", [0.44, 0.42, 0.50]),
        Some(SurfaceKind::Extrusion) => ("extrusions", [0.42, 0.46, 0.42]),
        Some(SurfaceKind::Other) => ("other faces", [0.45, 0.45, 0.45]),
    }
}

/// Unit normal of each corner of each triangle: mean of the triangles around the vertex that are
/// within the crease angle, weighted by area.
pub(super) fn corner_normals(mesh: &Mesh, crease_cos: f64) -> Vec<[Vector; 3]> {
    let flat: Vec<Vector> = (0..mesh.triangles.len()).map(|t| mesh.normal(t)).collect();
    let mut around: Vec<Vec<u32>> = vec![Vec::new(); mesh.points.len()];
    for (t, corners) in (0u32..).zip(&mesh.triangles) {
        for &c in corners {
            around[c as usize].push(t);
        }
    }
    let weighted = |t: u32| {
        let [a, b, c] = mesh.corners(t as usize);
        (b - a).cross(&(c - a))
    };
    let corner = |own: &Vector, vertex: u32| {
        let near = around[vertex as usize].iter().filter(|&&t| flat[t as usize].dot(own) >= crease_cos);
        let sum: Vector = near.map(|&t| weighted(t)).sum();
        sum.try_normalize(1e-300).unwrap_or(if own.norm() > 0.5 { *own } else { Vector::z() })
    };
    mesh.triangles.iter().zip(&flat).map(|(corners, own)| corners.map(|v| corner(own, v))).collect()
}

/// Triangles of one kind, corners of one place and normal shared.
pub(super) fn primitive(
    glb: &mut Glb,
    mesh: &Mesh,
    normals: &[[Vector; 3]],
    triangles: &[usize],
    material: Index<Material>,
) -> Result<Primitive> {
    let (mut points, mut directions, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    let mut seen: HashMap<(u32, [u32; 3]), u32> = HashMap::new();
    for &t in triangles {
        for (vertex, n) in mesh.triangles[t].iter().zip(&normals[t]) {
            let n = triple(n)?;
            let next = u32::try_from(points.len()).unwrap_or(u32::MAX);
            let index = *seen.entry((*vertex, n.map(f32::to_bits))).or_insert(next);
            if index == next {
                points.push(triple(&mesh.points[*vertex as usize].coords)?);
                directions.push(n);
            }
            indices.push(index);
        }
    }
    let attributes = [(Semantic::Positions, glb.positions(&points)), (Semantic::Normals, glb.normals(&directions))];
    let indices = glb.indices(&indices);
    Ok(Glb::primitive(attributes, Some(indices), material, Mode::Triangles))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    #[test]
    fn a_crease_keeps_its_edge_and_a_cylinder_is_smooth() {
        let mesh = sample::blade().part.mesh;
        let normals = corner_normals(&mesh, 30f64.to_radians().cos());
        for (t, corners) in mesh.triangles.iter().enumerate() {
            for (v, n) in corners.iter().zip(&normals[t]) {
                let p = mesh.points[*v as usize];
                let radial = Vector::new(0.0, p.y, p.z) / sample::PART_RADIUS;
                let want = match mesh.face(t) {
                    0 => radial,
                    1 => -Vector::x(),
                    _ => Vector::x(),
                };
                // Area weights are not the same on both sides of a vertex of a triangulated strip:
                // 4 degrees.
                assert!(n.dot(&want) > 0.9975, "triangle {t}: {n} against {want}");
            }
        }
    }
}
