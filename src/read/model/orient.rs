//! Exact faces turned so that neighbours agree and bodies face outward.
//!
//! Which way a face looks is known once it is tessellated: its triangles are wound by
//! [`Face::reversed`](crate::geometry::brep::Face::reversed), all alike. The mesh is wound
//! ([`super::wind`]), and a face whose triangles were turned by that is turned too.

use crate::geometry::brep::Brep;
use crate::geometry::mesh::Mesh;
use crate::observe::Remark;

use super::wind;

/// Turns faces and their triangles; says what was turned.
pub fn orient(brep: &mut Brep, mesh: &mut Mesh) -> Option<Remark> {
    let before = mesh.triangles.clone();
    wind::orient(mesh);
    let mut turned: Vec<Option<bool>> = vec![None; brep.faces.len()];
    for (t, (was, is)) in before.iter().zip(&mesh.triangles).enumerate() {
        if let Some(slot) = turned.get_mut(mesh.face(t) as usize) {
            slot.get_or_insert(was != is);
        }
    }
    let mut count = 0;
    for (face, turned) in brep.faces.iter_mut().zip(turned) {
        if turned == Some(true) {
            face.reversed = !face.reversed;
            count += 1;
        }
    }
    (count > 0).then_some(Remark::FacesTurned { count, of: brep.faces.len() })
}
