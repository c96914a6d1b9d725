//! Ends of a blade: smooth patches of the surface, bounded by creases, that close it like a lid.
//!
//! A blade that is cut off at its tip, or at both ends, has a patch there that faces along the
//! blade axis and is as large as the last section. Directions across the chord have none, however
//! much their sections look like an airfoil.
//!
//! Of an airfoil alone, both ends have the outline of an airfoil, whatever surfaces they lie on:
//! planes, a hub and a casing, a cone. The line from the middle of one to that of the other is the
//! way from root to tip without a single section being cut ([`end_to_end`]), so it holds where
//! sections square to any direction are cut short by the ends: blades that lean, are swept, or turn
//! from axial to radial.

use std::collections::BTreeMap;

use super::run::{Link, Run, frame_along};
use super::shape::{self, LoopShape};
use crate::geometry::mesh::{EdgeUse, Mesh, root};
use crate::geometry::slice::Loop;
use crate::geometry::{Point, Vector};

/// Neighbouring triangles whose normals differ by more belong to different patches, degrees.
const CREASE_DEG: f64 = 30.0;
/// A lid's mean normal is at least this long: it is nearly flat.
const FLAT: f64 = 0.8;
/// A lid faces along the axis within this angle, degrees.
const FACING_DEG: f64 = 30.0;
/// A lid's area, seen along the axis, over that of the last section.
const LIKE: [f64; 2] = [0.5, 2.0];
/// Lids whose normals are tried as axes: the largest, …
const TRIED: usize = 6;
/// … of those within this angle of one line only the first, degrees.
const SAME_DEG: f64 = 0.05;
/// Shares of the whole surface that a lid may have: little where a thin tip stands on a wide
/// platform.
const SHARE: [f64; 2] = [0.0004, 0.25];

/// A patch whose mean normal is at least this long is a plane.
const PLANE: f64 = 1.0 - 1e-6;

/// The outline of an airfoil's end is at least this much like an airfoil: more than a bar with
/// square ends, less than a blunt trailing edge leaves.
const OUTLINE: f64 = 0.5;
/// An airfoil's end faces along the line from end to end within this angle, degrees: more than any
/// lean that was met.
const ASLANT_DEG: f64 = 70.0;
/// Surface between the ends over that of a straight wall between their outlines: more where the
/// blade is swept and bulges between them, far more where there is a platform or root besides.
const WALL: [f64; 2] = [0.6, 1.6];

/// A nearly flat patch.
pub struct FlatPatch {
    /// Length of the mean normal: 1 for a plane.
    flatness: f64,
    area_mm2: f64,
    normal: Vector,
    middle: Point,
    /// Its longest outline, seen along the normal.
    outline: Option<LoopShape>,
}

/// The nearly flat patches of the mesh that creases bound, largest first. `sides`:
/// [`crate::geometry::mesh::edge_uses`] of its triangles.
pub fn patches(mesh: &Mesh, sides: &[EdgeUse]) -> Vec<FlatPatch> {
    let cos = CREASE_DEG.to_radians().cos();
    bounded(mesh, sides, |a, b| mesh.normal(a as usize).dot(&mesh.normal(b as usize)) > cos)
}

/// The nearly flat patches of triangles that neighbours join, largest first.
fn bounded(mesh: &Mesh, sides: &[EdgeUse], joins: impl Fn(u32, u32) -> bool) -> Vec<FlatPatch> {
    let n = mesh.triangles.len();
    let mut parent: Vec<u32> = (0..n as u32).collect();
    let smooth = |pair: &[EdgeUse]| matches!(pair, [a, b] if joins(a.triangle, b.triangle));
    for pair in sides.chunk_by(|a, b| a.edge == b.edge).filter(|pair| smooth(pair)) {
        let (a, b) = (root(&mut parent, pair[0].triangle), root(&mut parent, pair[1].triangle));
        parent[a.max(b) as usize] = a.min(b);
    }
    let mut sums: BTreeMap<u32, (f64, Vector, Vector)> = BTreeMap::new();
    for t in 0..n {
        let [a, b, c] = mesh.corners(t);
        let area = mesh.triangle_area_mm2(t);
        let s = sums.entry(root(&mut parent, t as u32)).or_insert((0.0, Vector::zeros(), Vector::zeros()));
        s.0 += area;
        s.1 += area * mesh.normal(t);
        s.2 += area * (a.coords + b.coords + c.coords) / 3.0;
    }
    let total = mesh.area_mm2();
    let wanted = |(area, normal, _): &(f64, Vector, Vector)| {
        *area > SHARE[0] * total && *area < SHARE[1] * total && normal.norm() > FLAT * area
    };
    sums.retain(|_, s| wanted(s));
    let mut borders: BTreeMap<u32, Vec<[u32; 2]>> = sums.keys().map(|k| (*k, Vec::new())).collect();
    for pair in sides.chunk_by(|a, b| a.edge == b.edge).filter(|pair| !smooth(pair)) {
        for side in pair {
            if let Some(border) = borders.get_mut(&root(&mut parent, side.triangle)) {
                let [a, b] = side.edge;
                border.push(if side.rising { [a, b] } else { [b, a] });
            }
        }
    }
    let mut out: Vec<FlatPatch> = sums
        .into_iter()
        .map(|(k, (area, normal, middle))| FlatPatch {
            flatness: normal.norm() / area,
            area_mm2: area,
            normal: normal.normalize(),
            middle: Point::from(middle / area),
            outline: borders.get(&k).and_then(|b| outline(mesh, b, &normal)),
        })
        .collect();
    out.sort_by(|a, b| b.area_mm2.total_cmp(&a.area_mm2));
    out
}

/// The longest ring of these sides, seen along a normal.
fn outline(mesh: &Mesh, border: &[[u32; 2]], normal: &Vector) -> Option<LoopShape> {
    let plane = frame_along(normal).inverse();
    let mut next: BTreeMap<u32, u32> = border.iter().map(|[a, b]| (*a, *b)).collect();
    let mut most: Option<LoopShape> = None;
    while let Some((&first, _)) = next.iter().next() {
        let mut points = Vec::new();
        let mut at = first;
        while let Some(to) = next.remove(&at) {
            let p = plane * mesh.points[at as usize];
            points.push([p.y, p.z]);
            at = to;
        }
        let triangles = vec![0; points.len()];
        let ring = LoopShape::new(&Loop { points, triangles, closed: at == first });
        most = [most, ring].into_iter().flatten().max_by(|a, b| a.perimeter_mm.total_cmp(&b.perimeter_mm));
    }
    most
}

/// Both ends of an airfoil alone.
#[derive(Clone, Copy, Debug)]
pub struct AirfoilEnds {
    /// Unit vector from the middle of the larger one to that of the other.
    pub line: Vector,
    /// Area of the larger one over that of the other.
    pub ratio: f64,
    /// Both are planes.
    pub flat: bool,
}

/// The ends of an airfoil alone: two patches with an airfoil's outline that face away from each
/// other, and between which there is about as much surface as a wall from one outline to the other
/// has. They are sought between creases, else among faces or groups of the file: a fillet that runs
/// out into its end leaves no crease. `sides`: [`crate::geometry::mesh::edge_uses`] of the
/// triangles. `None`: there are none.
pub fn end_to_end(mesh: &Mesh, sides: &[EdgeUse], patches: &[FlatPatch]) -> Option<AirfoilEnds> {
    let area_mm2 = mesh.area_mm2();
    ends(area_mm2, patches)
        .or_else(|| ends(area_mm2, &bounded(mesh, sides, |a, b| mesh.face(a as usize) == mesh.face(b as usize))))
}

fn ends(area_mm2: f64, patches: &[FlatPatch]) -> Option<AirfoilEnds> {
    let like: Vec<(&FlatPatch, &LoopShape)> =
        patches.iter().filter_map(|p| Some((p, p.outline.as_ref().filter(|o| o.likeness > OUTLINE)?))).collect();
    let mut best: Option<(f64, AirfoilEnds)> = None;
    // Patches come largest first.
    for (k, (a, around_a)) in like.iter().enumerate() {
        for (b, around_b) in &like[k + 1..] {
            let length = (b.middle - a.middle).norm();
            let Some(line) = (b.middle - a.middle).try_normalize(f64::MIN_POSITIVE) else { continue };
            let facing = b.normal.dot(&line).min(-a.normal.dot(&line));
            let wall = 0.5 * (around_a.perimeter_mm + around_b.perimeter_mm) * length;
            let between = (area_mm2 - a.area_mm2 - b.area_mm2) / wall;
            let alike = around_a.likeness.min(around_b.likeness);
            if facing > ASLANT_DEG.to_radians().cos()
                && (WALL[0]..WALL[1]).contains(&between)
                && best.is_none_or(|(most, _)| alike > most)
            {
                let flat = a.flatness > PLANE && b.flatness > PLANE;
                best = Some((alike, AirfoilEnds { line, ratio: a.area_mm2 / b.area_mm2, flat }));
            }
        }
    }
    best.map(|b| b.1)
}

/// Directions in which the largest patches face. Patches that face along one line are one: the
/// sides of a platform would else leave no place for a small tip.
pub fn directions(patches: &[FlatPatch]) -> Vec<Vector> {
    let mut directions: Vec<Vector> = Vec::new();
    for p in patches {
        if directions.len() == TRIED {
            break;
        }
        if !directions.iter().any(|d| d.dot(&p.normal).abs() > SAME_DEG.to_radians().cos()) {
            directions.push(p.normal);
        }
    }
    directions
}

/// Normals of patches that are planes, largest first, and whether another such patch has the same
/// one, in either sense, within this angle, degrees.
pub fn flat_normals(patches: &[FlatPatch], common_deg: f64) -> Vec<(Vector, bool)> {
    let planes: Vec<&FlatPatch> = patches.iter().filter(|p| p.flatness > PLANE).collect();
    let common = |k: usize, n: &Vector| {
        planes.iter().enumerate().any(|(i, p)| i != k && p.normal.dot(n).abs() > common_deg.to_radians().cos())
    };
    planes.iter().enumerate().map(|(k, p)| (p.normal, common(k, &p.normal))).collect()
}

/// The common normal of two planes that close both ends of the run and lean from its direction by
/// more than `lean_deg`, but by less than [`MOST_LEAN_DEG`]; `None` where there are none.
pub fn slanted_ends(patches: &[FlatPatch], run: &Run, common_deg: f64, lean_deg: f64) -> Option<Vector> {
    let (first, last) = (run.links.first()?, run.links.last()?);
    let middle = &run.links[run.links.len() / 2].shape;
    let leans = |p: &&FlatPatch| {
        let facing = p.normal.dot(&run.direction).abs();
        let share = facing * p.area_mm2 / middle.area_mm2.max(f64::MIN_POSITIVE);
        p.flatness > PLANE
            && facing < lean_deg.to_radians().cos()
            && facing > MOST_LEAN_DEG.to_radians().cos()
            && (LIKE[0]..=LIKE[1]).contains(&share)
    };
    let room = 0.25 * middle.perimeter_mm;
    let height = |p: &FlatPatch| p.middle.coords.dot(&run.direction);
    let top = |p: &&FlatPatch| p.normal.dot(&run.direction) > 0.0 && height(p) > last.height_mm - room;
    let bottom = |p: &&FlatPatch| p.normal.dot(&run.direction) < 0.0 && height(p) < first.height_mm + room;
    let ends: Vec<&FlatPatch> = patches.iter().filter(leans).collect();
    let opposite = |p: &FlatPatch| {
        ends.iter().filter(|q| bottom(q)).any(|q| q.normal.dot(&p.normal) < -common_deg.to_radians().cos())
    };
    ends.iter().filter(|p| top(p)).find(|p| opposite(p)).map(|p| p.normal)
}

/// Planes that lean more are sides of the part, not ends.
const MOST_LEAN_DEG: f64 = 65.0;

/// How many ends of the run, 0 to 2, have a lid.
pub fn lids(patches: &[FlatPatch], run: &Run) -> usize {
    lids_of(patches, run).into_iter().flatten().count()
}

/// What the lids of both ends add up to, 0 to 2: one whose outline is an airfoil's counts in full,
/// the sides of a platform, bars with square ends, do not.
pub fn airfoil_lids(patches: &[FlatPatch], run: &Run) -> f64 {
    let worth = |lid: &FlatPatch| {
        lid.outline.map_or(0.0, |o| ((o.likeness - shape::BLUNT) / (OUTLINE - shape::BLUNT)).clamp(0.0, 1.0))
    };
    lids_of(patches, run).into_iter().flatten().map(worth).sum()
}

/// The lids of the low and the high end of the run, of several the one most like an airfoil.
fn lids_of<'a>(patches: &'a [FlatPatch], run: &Run) -> [Option<&'a FlatPatch>; 2] {
    let blade_from_mesh = frame_along(&run.direction).inverse();
    let lid = |end: &Link, outward: &Vector| {
        let is_lid = |p: &&FlatPatch| {
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
        };
        let likeness = |p: &FlatPatch| p.outline.map_or(0.0, |o| o.likeness);
        patches.iter().filter(is_lid).max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
    };
    [run.links.first().and_then(|l| lid(l, &-run.direction)), run.links.last().and_then(|l| lid(l, &run.direction))]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::mesh::edge_uses;
    use crate::read::model::recognise::run;
    use crate::sample;

    /// The cylinder of the samples has two lids, planes across its axis, and a wall that is not
    /// flat.
    #[test]
    fn a_cylinder_has_two_lids_across_its_axis_and_none_across_others() {
        let mesh = sample::blade().part.mesh;
        let patches = patches(&mesh, &edge_uses(&mesh.triangles));
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
        let patches = patches(&mesh, &edge_uses(&mesh.triangles));
        assert_eq!(patches.len(), 2);
        let flat = flat_normals(&patches, 0.5);
        assert!(flat.len() == 1 && !flat[0].1, "only the root's end is a plane now");
        assert_eq!(lids(&patches, &run::along(&mesh, &Vector::x(), None)), 2, "both still close the blade");
    }
}
