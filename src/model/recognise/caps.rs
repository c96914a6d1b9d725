//! Ends of a blade: smooth patches of the surface, bounded by creases, that close it like a lid.
//!
//! A blade that is cut off at its tip, or at both ends, has a patch there that faces along the blade axis and is as large as the
//! last section. Directions across the chord have none, however much their sections look like an airfoil.

use std::collections::BTreeMap;

use super::run::{Link, Run, frame_along};
use crate::geometry::mesh::{Mesh, edge_uses, root};
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

/// A patch whose mean normal is at least this long is a plane.
const PLANE: f64 = 1.0 - 1e-6;

/// A nearly flat patch.
pub struct Patch {
    /// Length of the mean normal: 1 for a plane.
    flatness: f64,
    area_mm2: f64,
    normal: Vector,
    middle: Point,
}

/// The nearly flat patches of the mesh, largest first.
pub fn patches(mesh: &Mesh) -> Vec<Patch> {
    let n = mesh.triangles.len();
    let normals: Vec<Vector> = (0..n).map(|t| mesh.normal(t)).collect();
    let mut sides = edge_uses(&mesh.triangles);
    sides.sort_unstable_by_key(|s| (s.edge, s.triangle));
    let cos = CREASE_DEG.to_radians().cos();
    let mut parent: Vec<u32> = (0..n as u32).collect();
    for pair in sides.windows(2).filter(|w| w[0].edge == w[1].edge) {
        let [a, b] = [pair[0].triangle, pair[1].triangle];
        if normals[a as usize].dot(&normals[b as usize]) > cos {
            let (a, b) = (root(&mut parent, a), root(&mut parent, b));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut sums: BTreeMap<u32, (f64, Vector, Vector)> = BTreeMap::new();
    for t in 0..n {
        let [a, b, c] = mesh.corners(t);
        let area = mesh.triangle_area_mm2(t);
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
            flatness: normal.norm() / area,
            area_mm2: area,
            normal: normal.normalize(),
            middle: Point::from(middle / area),
        })
        .collect();
    out.sort_by(|a, b| b.area_mm2.total_cmp(&a.area_mm2));
    out
}

/// Directions in which the largest patches face.
pub fn directions(patches: &[Patch]) -> Vec<Vector> {
    patches.iter().take(TRIED).map(|p| p.normal).collect()
}

/// Normals of patches that are planes, largest first, and whether another such patch has the same one, in either sense, within
/// this angle, degrees.
pub fn flat_normals(patches: &[Patch], common_deg: f64) -> Vec<(Vector, bool)> {
    let planes: Vec<&Patch> = patches.iter().filter(|p| p.flatness > PLANE).collect();
    let common = |k: usize, n: &Vector| {
        planes.iter().enumerate().any(|(i, p)| i != k && p.normal.dot(n).abs() > common_deg.to_radians().cos())
    };
    planes.iter().enumerate().map(|(k, p)| (p.normal, common(k, &p.normal))).collect()
}

/// The common normal of two planes that close both ends of the run and lean from its direction by more than `lean_deg`, but by less
/// than [`MOST_LEAN_DEG`]; `None` where there are none.
pub fn slanted_ends(patches: &[Patch], run: &Run, common_deg: f64, lean_deg: f64) -> Option<Vector> {
    let (first, last) = (run.links.first()?, run.links.last()?);
    let middle = &run.links[run.links.len() / 2].shape;
    let leans = |p: &&Patch| {
        let facing = p.normal.dot(&run.direction).abs();
        let share = facing * p.area_mm2 / middle.area_mm2.max(f64::MIN_POSITIVE);
        p.flatness > PLANE
            && facing < lean_deg.to_radians().cos()
            && facing > MOST_LEAN_DEG.to_radians().cos()
            && (LIKE[0]..=LIKE[1]).contains(&share)
    };
    let room = 0.25 * middle.perimeter_mm;
    let height = |p: &Patch| p.middle.coords.dot(&run.direction);
    let top = |p: &&Patch| p.normal.dot(&run.direction) > 0.0 && height(p) > last.height_mm - room;
    let bottom = |p: &&Patch| p.normal.dot(&run.direction) < 0.0 && height(p) < first.height_mm + room;
    let ends: Vec<&Patch> = patches.iter().filter(leans).collect();
    let opposite =
        |p: &Patch| ends.iter().filter(|q| bottom(q)).any(|q| q.normal.dot(&p.normal) < -common_deg.to_radians().cos());
    ends.iter().filter(|p| top(p)).find(|p| opposite(p)).map(|p| p.normal)
}

/// Planes that lean more are sides of the part, not ends.
const MOST_LEAN_DEG: f64 = 65.0;

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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::model::recognise::run;
    use crate::sample;

    /// The cylinder of the samples has two lids, planes across its axis, and a wall that is not flat.
    #[test]
    fn a_cylinder_has_two_lids_across_its_axis_and_none_across_others() {
        let mesh = sample::blade().part.mesh;
        let patches = patches(&mesh);
        assert_eq!(patches.len(), 2);
        for p in &patches {
            let want = 0.5 * 48.0 * (std::f64::consts::TAU / 48.0).sin() * sample::PART_RADIUS.powi(2);
            assert!((p.area_mm2 - want).abs() < 1e-9 && p.normal.x.abs() > 1.0 - 1e-12, "{} {}", p.area_mm2, p.normal);
            assert!(p.middle.y.hypot(p.middle.z) < 1e-9);
        }
        assert!(flat_normals(&patches, 0.5).iter().all(|(n, common)| *common && n.x.abs() > 1.0 - 1e-12));
        assert_eq!(lids(&patches, &run::along(&mesh, &Vector::x(), None)), 2);
        assert_eq!(lids(&patches, &run::along(&mesh, &Vector::y(), None)), 0);
    }

    #[test]
    fn a_lid_that_is_bent_is_no_plane() {
        let mut mesh = sample::blade().part.mesh;
        // The middle of the tip's fan, drawn out to a flat cone.
        let top =
            mesh.points.iter_mut().filter(|p| p.y == 0.0 && p.z == 0.0).max_by(|a, b| a.x.total_cmp(&b.x)).unwrap();
        top.x += 0.2 * sample::PART_RADIUS;
        let patches = patches(&mesh);
        assert_eq!(patches.len(), 2);
        let flat = flat_normals(&patches, 0.5);
        assert!(flat.len() == 1 && !flat[0].1, "only the root's end is a plane now");
        assert_eq!(lids(&patches, &run::along(&mesh, &Vector::x(), None)), 2, "both still close the blade");
    }
}
