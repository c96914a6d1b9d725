//! A bounding-volume tree over the triangles of a mesh, on parry3d's `Bvh`, with exact queries of
//! our own.
//!
//! All queries are deterministic and free of interior state, so they may run from any thread.

use parry3d_f64::bounding_volume::Aabb as ParryAabb;
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode, TraversalAction};

use super::mesh::Mesh;
use super::triangle::closest_on_triangle;
use super::{Point, Vector};

/// The tree; leaf data are triangle indices.
#[derive(Clone)]
pub struct MeshBvh {
    /// parry's tree, open for stages that traverse it their own way.
    pub tree: Bvh,
}

/// A triangle near a query point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// Index of the triangle.
    pub triangle: u32,
    /// Its closest point to the query point.
    pub foot: Point,
    /// Distance from the query point to `foot`, mm.
    pub distance_mm: f64,
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

    /// The closest point of the mesh to `q` that is no farther than `cap_mm` (which may be
    /// infinite); `mesh` must be the mesh that the tree was built from.
    pub fn closest(&self, mesh: &Mesh, q: &Point, cap_mm: f64) -> Option<Near> {
        // The search keeps what is strictly below its limit: one ulp or so more keeps a point at
        // the cap itself.
        let cap2 = cap_mm * cap_mm * (1.0 + 4.0 * f64::EPSILON);
        let found = self.tree.find_best(
            cap2,
            |node, _| box_distance2(node, q),
            |t, _| {
                let foot = closest_on_triangle(&mesh.corners(t as usize), q);
                Some(((q - foot).norm_squared(), foot))
            },
        );
        found.map(|(triangle, (d2, foot))| Near { triangle, foot, distance_mm: d2.sqrt() })
    }

    /// All triangles no farther than `radius_mm` from `q`, each with its closest point, in order of
    /// the tree.
    pub fn triangles_within(&self, mesh: &Mesh, q: &Point, radius_mm: f64) -> Vec<Near> {
        let mut found = Vec::new();
        self.for_each_within(mesh, q, radius_mm, |near| found.push(near));
        found
    }

    /// As [`Self::triangles_within`], handing each triangle to `visit` instead of collecting.
    pub fn for_each_within(&self, mesh: &Mesh, q: &Point, radius_mm: f64, mut visit: impl FnMut(Near)) {
        let radius2 = radius_mm * radius_mm;
        self.tree.traverse(|node| {
            if box_distance2(node, q) > radius2 {
                return TraversalAction::Prune;
            }
            if let Some(triangle) = node.leaf_data() {
                let foot = closest_on_triangle(&mesh.corners(triangle as usize), q);
                let d2 = (q - foot).norm_squared();
                if d2 <= radius2 {
                    visit(Near { triangle, foot, distance_mm: d2.sqrt() });
                }
            }
            TraversalAction::Continue
        });
    }
}

/// Directions of rays, along nothing that a part is aligned with; the first that meets no edge is
/// taken.
const RAYS: [[f64; 3]; 4] =
    [[0.713, 0.527, 0.463], [-0.619, 0.377, 0.689], [0.231, -0.857, 0.461], [-0.349, -0.571, -0.743]];
/// Volumes smaller than this share of the greatest count as zero.
const ON_EDGE: f64 = 1e-10;

impl MeshBvh {
    /// How often a closed mesh goes round `q`: 1 inside, 0 outside, more where bodies overlap, less
    /// than 0 where they are inside out; right for meshes that cross or fold over themselves too.
    /// Triangles that a ray leaves through count 1, those that it enters through −1. `None` where
    /// every ray tried runs through an edge.
    pub fn winding(&self, mesh: &Mesh, q: &Point) -> Option<i32> {
        RAYS.iter().find_map(|d| self.crossings(mesh, q, &Vector::from(*d)))
    }

    fn crossings(&self, mesh: &Mesh, q: &Point, d: &Vector) -> Option<i32> {
        let (mut sum, mut sure) = (0, true);
        self.tree.traverse(|node| {
            if !sure || !meets(node, q, d) {
                return TraversalAction::Prune;
            }
            if let Some(t) = node.leaf_data() {
                let [a, b, c] = mesh.corners(t as usize).map(|p| p - q);
                // Volumes of the ray with each side: all of one sign where it passes through.
                let v = [b.cross(&c).dot(d), c.cross(&a).dot(d), a.cross(&b).dot(d)];
                let size = v[0].abs().max(v[1].abs()).max(v[2].abs());
                let signs = v.map(|x| if x.abs() <= ON_EDGE * size { 0 } else { x.signum() as i32 });
                let whole = v[0] + v[1] + v[2];
                let apart = signs.contains(&1) && signs.contains(&-1);
                if !apart && a.cross(&b).dot(&c) * whole > 0.0 {
                    sure &= !signs.contains(&0);
                    sum += whole.signum() as i32;
                } else if !apart && whole == 0.0 {
                    // Seen from its edge, or without area: its neighbours are met there too.
                    sure &= size == 0.0 && a.cross(&b).dot(&c) == 0.0;
                }
            }
            TraversalAction::Continue
        });
        sure.then_some(sum)
    }
}

/// Whether the ray from `q` along `d` (no component zero) meets the box of a node.
fn meets(node: &BvhNode, q: &Point, d: &Vector) -> bool {
    let (lo, hi) = (node.mins(), node.maxs());
    let (mut from, mut to) = (0.0f64, f64::INFINITY);
    for (lo, hi, q, d) in [(lo.x, hi.x, q.x, d.x), (lo.y, hi.y, q.y, d.y), (lo.z, hi.z, q.z, d.z)] {
        let slack = 1e-12 * (lo.abs() + hi.abs() + q.abs());
        let (a, b) = ((lo - slack - q) / d, (hi + slack - q) / d);
        (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
    }
    from <= to
}

/// Squared distance from `q` to the box of a node, mm².
fn box_distance2(node: &BvhNode, q: &Point) -> f64 {
    let (lo, hi) = (node.mins(), node.maxs());
    let x = (lo.x - q.x).max(q.x - hi.x).max(0.0);
    let y = (lo.y - q.y).max(q.y - hi.y).max(0.0);
    let z = (lo.z - q.z).max(q.z - hi.z).max(0.0);
    x * x + y * y + z * z
}
