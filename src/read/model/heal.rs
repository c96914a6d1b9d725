//! Healing of a triangle mesh: what a mesh file has wrong and what can be put right without
//! guessing.
//!
//! In: a mesh whose coinciding corners are one vertex already. Out: the mesh, and a note for
//! everything that was changed. In order:
//!
//! 1. vertices within a tolerance become one, the tolerance being the user's or the least of a few
//!    shares of the size that leaves fewer faults;
//! 2. triangles that repeat another go; pairs that lie on one another back to back between other
//!    triangles go both;
//! 3. triangles without area are flipped away: their longest side's other triangle is cut at their
//!    third corner;
//! 4. neighbours are wound alike and every piece outward ([`super::wind`]);
//! 5. holes up to a size that the user gives are closed ([`crate::geometry::boundary::close`]).
//!
//! Guarantees: triangles that have no fault keep their corners. What stays (openings, edges with
//! more than two triangles) is not an error here: it is in the diagnosis, and whether it matters is
//! decided where the tool is known.

use std::collections::BTreeMap;

use super::published::{self, MOVED_MM};
use super::wind;
use crate::geometry::boundary;
use crate::geometry::mesh::{Mesh, topology, weld};
use crate::observe::Remark;

/// Welding tolerances that are tried where the mesh has faults, as shares of its diagonal: the
/// rounding of single precision and of files with seven and with five digits.
const WELD: [f64; 3] = [1e-7, 1e-6, 1e-5];
/// A triangle lower than this share of the mesh's diagonal has no area.
const FLAT: f64 = 1e-9;
/// Flipping a flat triangle away may make another flat one: rounds of it.
const FLIP_ROUNDS: usize = 8;

/// What the user may ask for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HealOptions {
    /// Vertices this near to one another are the same, mm; `None`: found.
    pub weld_mm: Option<f64>,
    /// Holes up to this extent are closed, mm; `None`: none.
    pub close_holes_mm: Option<f64>,
}

/// A healed mesh.
pub struct Healed {
    /// The mesh, mm.
    pub mesh: Mesh,
    /// What was changed.
    pub notes: Vec<Remark>,
    /// Triangles that are not as the file has them, as it has them.
    pub published: Option<Mesh>,
}

/// Heals a mesh.
pub fn heal(mesh: Mesh, options: &HealOptions) -> Healed {
    let mut notes = Vec::new();
    let read = mesh;
    let mut mesh = welded(&read, options.weld_mm, &mut notes);
    let repeated = drop_repeated(&mut mesh);
    if repeated > 0 {
        notes.push(Remark::RepeatedDropped { triangles: repeated });
    }
    let (flipped, left) = flip_flat(&mut mesh);
    if flipped > 0 {
        notes.push(Remark::FlatMerged { triangles: flipped });
    }
    if left > 0 {
        notes.push(Remark::FlatLeft { triangles: left });
    }
    notes.extend(wind::orient(&mut mesh));
    if let Some(most_mm) = options.close_holes_mm {
        let face = mesh.face_of.iter().max().map_or(0, |f| f + 1);
        let before = mesh.triangles.len();
        let closed = boundary::close(&mut mesh, most_mm, face);
        if closed > 0 {
            let triangles = mesh.triangles.len() - before;
            notes.push(Remark::HolesClosed { count: closed, most_mm, triangles });
            // A piece that was open may be wound inward, and nothing showed it before.
            notes.extend(wind::orient(&mut mesh));
        } else {
            notes.push(Remark::NoHoleToClose { most_mm });
        }
    }
    let published = published::triangles(&read, &mesh);
    if let Some(moved) = &published {
        notes.push(Remark::CornersMoved { triangles: moved.triangles.len(), beyond_mm: MOVED_MM });
    }
    drop_unused_points(&mut mesh);
    Healed { mesh, notes, published }
}

/// Open edges and edges with too many triangles.
fn faults(mesh: &Mesh) -> usize {
    let t = topology(mesh);
    t.open_edges + t.nonmanifold_edges
}

fn welded(mesh: &Mesh, told_mm: Option<f64>, notes: &mut Vec<Remark>) -> Mesh {
    let size = mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
    let mut best = None;
    if let Some(tolerance) = told_mm {
        best = Some((weld(mesh, tolerance), tolerance));
    } else {
        let mut least = faults(mesh);
        for tolerance in WELD.map(|w| w * size) {
            if least == 0 {
                break;
            }
            let closer = weld(mesh, tolerance);
            let now = faults(&closer);
            if now < least {
                (least, best) = (now, Some((closer, tolerance)));
            }
        }
    }
    let Some((closer, tolerance)) = best else { return mesh.clone() };
    let merged = mesh.points.len() - closer.points.len();
    let lost = mesh.triangles.len() - closer.triangles.len();
    if merged > 0 {
        notes.push(Remark::VerticesMerged { vertices: merged, within_mm: tolerance, vanished: lost });
    }
    closer
}

/// Drops triangles over the same three vertices as another: repeats always, and both of a pair that
/// is wound against one another where every side has two more triangles at least (a wall without
/// thickness inside the part). Returns how many.
fn drop_repeated(mesh: &mut Mesh) -> usize {
    let mut by_corners: BTreeMap<[u32; 3], Vec<usize>> = BTreeMap::new();
    let mut uses: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for (t, c) in mesh.triangles.iter().enumerate() {
        let mut key = *c;
        key.sort_unstable();
        by_corners.entry(key).or_default().push(t);
    }
    if by_corners.len() == mesh.triangles.len() {
        return 0;
    }
    for c in &mesh.triangles {
        for k in 0..3 {
            let (a, b) = (c[k], c[(k + 1) % 3]);
            *uses.entry((a.min(b), a.max(b))).or_default() += 1;
        }
    }
    let mut keep = vec![true; mesh.triangles.len()];
    for (key, same) in by_corners.iter().filter(|(_, s)| s.len() > 1) {
        // Even: the corners in the order of the sorted key, or turned round.
        let even = |t: usize| {
            let c = mesh.triangles[t];
            let at = c.iter().position(|v| *v == key[0]).unwrap_or(0);
            c[(at + 1) % 3] == key[1]
        };
        let first = |want: bool| same.iter().copied().find(|t| even(*t) == want);
        let both = [first(true), first(false)];
        same.iter().for_each(|t| keep[*t] = false);
        // Further triangles at the side that has the fewest.
        let others = [(key[0], key[1]), (key[1], key[2]), (key[0], key[2])].iter().map(|e| uses[e] - same.len()).min();
        match (both, others.unwrap_or(0)) {
            ([Some(_), Some(_)], 2..) => {}
            ([Some(a), Some(b)], 0) => (keep[a], keep[b]) = (true, true),
            ([a, b], _) => a.or(b).into_iter().for_each(|t| keep[t] = true),
        }
    }
    retain(mesh, &keep)
}

/// Keeps the marked triangles; returns how many went.
fn retain(mesh: &mut Mesh, keep: &[bool]) -> usize {
    let before = mesh.triangles.len();
    let mut k = keep.iter();
    mesh.triangles.retain(|_| *k.next().unwrap_or(&true));
    let mut k = keep.iter();
    mesh.face_of.retain(|_| *k.next().unwrap_or(&true));
    before - mesh.triangles.len()
}

/// Flips triangles without area away. Returns how many, and how many stay.
///
/// Such a triangle has its third corner on its longest side: the triangle beyond that side is cut
/// there in two, which take the place of both. The surface does not change.
fn flip_flat(mesh: &mut Mesh) -> (usize, usize) {
    let limit = FLAT * mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
    let mut done = 0;
    for _ in 0..FLIP_ROUNDS {
        let flat: Vec<usize> = (0..mesh.triangles.len()).filter(|&t| height(mesh, t) <= limit).collect();
        if flat.is_empty() {
            return (done, 0);
        }
        let mut sides: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
        for (t, c) in mesh.triangles.iter().enumerate() {
            (0..3).for_each(|k| sides.entry(side(c[k], c[(k + 1) % 3])).or_default().push(t));
        }
        let mut touched = vec![false; mesh.triangles.len()];
        let mut changed = 0;
        for &t in &flat {
            let Some((k, other)) = partner(mesh, &sides, t).filter(|(_, o)| !touched[t] && !touched[*o]) else {
                continue;
            };
            let [a, b, c] = [0, 1, 2].map(|i| mesh.triangles[t][(k + i) % 3]);
            let Some(at) = mesh.triangles[other].iter().position(|v| *v != a && *v != b) else { continue };
            let d = mesh.triangles[other][at];
            // An edge from c to d that is there already would come to have four triangles.
            if d == c || sides.contains_key(&side(c, d)) {
                continue;
            }
            let next = mesh.triangles[other][(at + 1) % 3];
            // The side a–b, in the sense in which the other triangle runs along it.
            let (from, to) = if next == a { (a, b) } else { (b, a) };
            mesh.triangles[other] = [from, c, d];
            mesh.triangles[t] = [c, to, d];
            if let Some(f) = mesh.face_of.get(other).copied() {
                mesh.face_of[t] = f;
            }
            // Everything around has new neighbours: it waits for the next round.
            (touched[t], touched[other]) = (true, true);
            for e in [side(a, c), side(b, c), side(a, d), side(b, d)] {
                sides.get(&e).into_iter().flatten().for_each(|n| touched[*n] = true);
            }
            changed += 1;
        }
        done += changed;
        if changed == 0 {
            return (done, flat.len());
        }
    }
    let left = (0..mesh.triangles.len()).filter(|&t| height(mesh, t) <= limit).count();
    (done, left)
}

fn side(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// Height of a triangle over its longest side, mm.
fn height(mesh: &Mesh, t: usize) -> f64 {
    let p = mesh.corners(t);
    let longest = (0..3).map(|k| (p[(k + 1) % 3] - p[k]).norm()).fold(0.0, f64::max);
    (p[1] - p[0]).cross(&(p[2] - p[0])).norm() / longest.max(f64::MIN_POSITIVE)
}

/// Where the longest side of a triangle begins, and the one other triangle at it.
fn partner(mesh: &Mesh, sides: &BTreeMap<(u32, u32), Vec<usize>>, t: usize) -> Option<(usize, usize)> {
    let c = mesh.triangles[t];
    let p = mesh.corners(t);
    let length = |k: usize| (p[(k + 1) % 3] - p[k]).norm();
    let k = (0..3).max_by(|&i, &j| length(i).total_cmp(&length(j)).then(j.cmp(&i)))?;
    match sides.get(&side(c[k], c[(k + 1) % 3]))?[..] {
        [a, b] if a == t => Some((k, b)),
        [a, b] if b == t => Some((k, a)),
        _ => None,
    }
}

/// Removes vertices without triangle.
fn drop_unused_points(mesh: &mut Mesh) {
    let mut number = vec![u32::MAX; mesh.points.len()];
    let mut points = Vec::with_capacity(mesh.points.len());
    for c in mesh.triangles.iter_mut().flatten() {
        let n = &mut number[*c as usize];
        if *n == u32::MAX {
            *n = points.len() as u32;
            points.push(mesh.points[*c as usize]);
        }
        *c = *n;
    }
    mesh.points = points;
}

#[cfg(test)]
#[path = "heal_tests.rs"]
mod tests;
