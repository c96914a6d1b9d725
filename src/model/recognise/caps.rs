//! Ends of a blade: smooth patches of the surface, bounded by creases, that close it like a lid.
//!
//! A blade that is cut off at its tip, or at both ends, has a patch there that faces along the blade axis and is as large as the
//! last section. Directions across the chord have none, however much their sections look like an airfoil.

use std::collections::BTreeMap;

use super::run::{Link, Run, frame_along};
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};

/// Neighbouring triangles whose normals differ by more belong to different patches, degrees.
const CREASE_DEG: f64 = 30.0;
/// A lid's mean normal is at least this long: it is nearly flat.
const FLAT: f64 = 0.8;
/// A lid faces along the axis within this angle, degrees.
const FACING_DEG: f64 = 30.0;
/// A lid's area, seen along the axis, over that of the last section.
const LIKE: [f64; 2] = [0.5, 2.0];
/// Lids whose normals are tried as axes: the largest.
const TRIED: usize = 6;
/// Shares of the whole surface that a lid may have.
const SHARE: [f64; 2] = [0.002, 0.25];

/// A nearly flat patch.
pub struct Patch {
    area_mm2: f64,
    normal: Vector,
    middle: Point,
}

/// The nearly flat patches of the mesh, largest first.
pub fn patches(mesh: &Mesh) -> Vec<Patch> {
    let n = mesh.triangles.len();
    let normals: Vec<Vector> = (0..n).map(|t| mesh.normal(t)).collect();
    let mut sides: Vec<(u32, u32, u32)> = Vec::with_capacity(3 * n);
    for (t, c) in mesh.triangles.iter().enumerate() {
        sides.extend((0..3).map(|k| (c[k].min(c[(k + 1) % 3]), c[k].max(c[(k + 1) % 3]), t as u32)));
    }
    sides.sort_unstable();
    let cos = CREASE_DEG.to_radians().cos();
    let mut parent: Vec<u32> = (0..n as u32).collect();
    for pair in sides.windows(2).filter(|w| (w[0].0, w[0].1) == (w[1].0, w[1].1)) {
        let [a, b] = [pair[0].2, pair[1].2];
        if normals[a as usize].dot(&normals[b as usize]) > cos {
            let (a, b) = (root(&mut parent, a), root(&mut parent, b));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut sums: BTreeMap<u32, (f64, Vector, Vector)> = BTreeMap::new();
    for t in 0..n {
        let [a, b, c] = mesh.corners(t);
        let area = 0.5 * (b - a).cross(&(c - a)).norm();
        let s = sums.entry(root(&mut parent, t as u32)).or_insert((0.0, Vector::zeros(), Vector::zeros()));
        s.0 += area;
        s.1 += area * normals[t];
        s.2 += area * (a.coords + b.coords + c.coords) / 3.0;
    }
    let total = mesh.area_mm2();
    let mut out: Vec<Patch> = sums
        .into_values()
        .filter(|(area, normal, _)| *area > SHARE[0] * total && *area < SHARE[1] * total && normal.norm() > FLAT * area)
        .map(|(area, normal, middle)| Patch {
            area_mm2: area,
            normal: normal.normalize(),
            middle: Point::from(middle / area),
        })
        .collect();
    out.sort_by(|a, b| b.area_mm2.total_cmp(&a.area_mm2));
    out
}

fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Directions in which the largest patches face.
pub fn directions(patches: &[Patch]) -> Vec<Vector> {
    patches.iter().take(TRIED).map(|p| p.normal).collect()
}

/// How many ends of the run, 0 to 2, have a lid.
pub fn lids(patches: &[Patch], run: &Run) -> usize {
    let blade_from_mesh = frame_along(&run.direction).inverse();
    let lid = |end: &Link, outward: &Vector| {
        patches.iter().any(|p| {
            let facing = p.normal.dot(outward);
            let q = blade_from_mesh * p.middle;
            let beyond = (p.middle.coords.dot(&run.direction) - end.height_mm) * outward.dot(&run.direction);
            let (b, wide) = (end.shape.bounds, end.shape.perimeter_mm);
            let share = facing * p.area_mm2 / end.shape.area_mm2.max(f64::MIN_POSITIVE);
            facing > FACING_DEG.to_radians().cos()
                && beyond > -0.02 * wide
                && (LIKE[0]..=LIKE[1]).contains(&share)
                && (b[0]..=b[2]).contains(&q.y)
                && (b[1]..=b[3]).contains(&q.z)
        })
    };
    let low = run.links.first().is_some_and(|l| lid(l, &-run.direction));
    let high = run.links.last().is_some_and(|l| lid(l, &run.direction));
    usize::from(low) + usize::from(high)
}
