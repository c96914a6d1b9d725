//! A bounding-volume tree over the triangles of a mesh, on parry3d's `Bvh`.

use parry3d_f64::bounding_volume::Aabb as ParryAabb;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};

use super::mesh::Mesh;

/// The tree; leaf data are triangle indices.
#[derive(Clone)]
pub struct MeshBvh {
    /// parry's tree, open for stages that traverse it their own way.
    pub tree: Bvh,
}

impl MeshBvh {
    /// Builds the tree; deterministic.
    pub fn new(mesh: &Mesh) -> Self {
        let boxes = (0..mesh.triangles.len()).map(|t| {
            let [a, b, c] = mesh.corners(t);
            let (lo, hi) = (a.inf(&b).inf(&c), a.sup(&b).sup(&c));
            (t, ParryAabb::new(ParryVector::new(lo.x, lo.y, lo.z), ParryVector::new(hi.x, hi.y, hi.z)))
        });
        MeshBvh { tree: Bvh::from_iter(BvhBuildStrategy::Binned, boxes) }
    }
}
