//! The rest of the wheel that a blade belongs to: the other blades and the hub, as the checks have
//! them.
//!
//! The other blades are the blade turned: each is a node with a place of its own, and they share
//! their triangles. Those on either side of the blade, between which the tool moves, have the
//! triangles of the blade as it is drawn; all others share a mesh that is thinned further.

use gltf_json as json;
use json::mesh::{Mesh, Primitive};
use json::scene::Node;
use json::{Index, material::Material};
use serde_json::json;

use super::blade::{self, Shown};
use super::glb::Glb;
use super::{Detail, Scene, group, mesh_node, single, triple};
use crate::error::Result;
use crate::geometry::{self, Rigid};
use crate::write::preview::thin::thinned;

/// Copies that are drawn with the triangles of the blade: one on either side.
const NEAR: usize = 2;
/// Triangles that all other copies together, and each other body, are drawn with at most.
const FAR_TRIANGLES: usize = 40_000;
/// Neither the colours of the blade nor those of the path, and the tool between them is seen.
const GREY: [f32; 3] = [0.36, 0.38, 0.41];
const OPACITY: f32 = 0.3;

/// The node with one for each other blade and body of the wheel; `None` where there are none.
pub(super) fn node(
    glb: &mut Glb,
    scene: &Scene,
    shown: Option<&Shown>,
    detail: &Detail,
) -> Result<Option<Index<Node>>> {
    if !scene.obstacles.iter().any(|o| o.of_the_wheel) {
        return Ok(None);
    }
    let (grey, mut children) = (glb.material("neighbours", GREY, true), Vec::new());
    glb.see_through(grey, OPACITY);
    for body in scene.obstacles.iter().filter(|o| o.of_the_wheel) {
        if body.copies.is_empty() {
            let most = detail.triangles.min(FAR_TRIANGLES);
            let primitives = drawn(glb, scene, (&body.part.mesh, most), grey)?;
            let note = json!({ "triangles_of_body": body.part.mesh.triangles.len() });
            children.extend(primitives.map(|p| mesh_node(glb, &body.name, vec![p], note)));
        } else if let Some(shown) = shown {
            children.extend(copies(glb, scene, (&body.copies, shown), detail, grey)?);
        }
    }
    if children.is_empty() {
        return Ok(None);
    }
    let note = json!({ "what": "the rest of the wheel, which the checks keep the tool from" });
    Ok(Some(group(glb, "neighbours", children, &note)))
}

/// A body of the blade frame as a primitive; `None` where nothing of it is left.
fn drawn(
    glb: &mut Glb,
    scene: &Scene,
    (mesh, most): (&geometry::mesh::Mesh, usize),
    grey: Index<Material>,
) -> Result<Option<Primitive>> {
    let mesh = thinned(mesh, most).0.moved(&scene.blade.model_from_blade);
    let all: Vec<usize> = (0..mesh.triangles.len()).collect();
    if all.is_empty() {
        return Ok(None);
    }
    let normals = blade::corner_normals(&mesh, scene.options.crease_deg.to_radians().cos());
    blade::primitive(glb, &mesh, &normals, &all, grey).map(Some)
}

/// A node for each copy of the blade, where its turn brings it.
fn copies(
    glb: &mut Glb,
    scene: &Scene,
    (turns, shown): (&[Rigid], &Shown),
    detail: &Detail,
    grey: Index<Material>,
) -> Result<Vec<Index<Node>>> {
    // The copies turned least are those on either side.
    let mut order: Vec<usize> = (0..turns.len()).collect();
    order.sort_by(|a, b| turns[*a].rotation.angle().total_cmp(&turns[*b].rotation.angle()).then(a.cmp(b)));
    let near: Vec<usize> = order.into_iter().take(NEAR).collect();
    let same = shown.primitives.iter().map(|p| Primitive { material: Some(grey), extensions: None, ..p.clone() });
    let close = glb.mesh("neighbour", same.collect());
    let distant = match turns.len() > NEAR {
        true => far(glb, scene, turns.len(), detail, grey)?.unwrap_or(close),
        false => close,
    };
    let mut out = Vec::with_capacity(turns.len());
    let (to_model, to_blade) = (scene.blade.model_from_blade, scene.blade.model_from_blade.inverse());
    for (k, turn) in turns.iter().enumerate() {
        let mesh = if near.contains(&k) { close } else { distant };
        let node = glb.node(Node { mesh: Some(mesh), name: Some(format!("blade {}", k + 2)), ..super::empty_node() });
        let at = to_model * turn * to_blade;
        let q = at.rotation.quaternion();
        glb.place(node, triple(&at.translation.vector)?, [single(q.i)?, single(q.j)?, single(q.k)?, single(q.w)?]);
        out.push(node);
    }
    Ok(out)
}

/// The mesh that copies farther off share; `None` where nothing of it would be left.
fn far(
    glb: &mut Glb,
    scene: &Scene,
    count: usize,
    detail: &Detail,
    grey: Index<Material>,
) -> Result<Option<Index<Mesh>>> {
    let most = detail.triangles.min(FAR_TRIANGLES) / count.max(1);
    let primitive = drawn(glb, scene, (&scene.blade.part.mesh, most), grey)?;
    Ok(primitive.map(|p| glb.mesh("neighbour farther off", vec![p])))
}
