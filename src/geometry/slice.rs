//! Plane sections of a triangle mesh.
//!
//! In: a mesh and a height `x_mm`. Out: the loops in which the plane `x = x_mm` cuts it, with the
//! triangle under every segment.
//!
//! A vertex in the plane counts as above it (a symbolic perturbation: the plane lies an
//! infinitesimal amount lower), so every cut triangle has exactly two cut edges and no case is
//! special. Each cut edge is interpolated from its lower-numbered vertex, so both of its triangles
//! compute the very same point. Segments run from the edge where the triangle's own boundary goes
//! down through the plane to the edge where it comes up; the next triangle takes over there. On a
//! closed, consistently wound mesh every loop closes and has the material on its left: outer loops
//! run counter-clockwise seen from `+x` (positive area), holes clockwise. Where the mesh is open or
//! its winding is inconsistent the chain ends and is returned with `closed == false`.
//!
//! Order is deterministic: loops begin at their lowest-numbered triangle and come in the order of
//! those.

use std::collections::BTreeMap;

use parry3d_f64::partitioning::TraversalAction;

use super::Point;
use super::bvh::MeshBvh;
use super::mesh::Mesh;

/// Distance from `q` to the segment `a b` in the plane, mm.
fn distance_to_segment(q: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let f = (((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / (dx * dx + dy * dy).max(1e-300)).clamp(0.0, 1.0);
    (q[0] - a[0] - f * dx).hypot(q[1] - a[1] - f * dy)
}

/// One chain of segments in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// (y, z), mm. Segment `i` runs from point `i` to the next; the last point of a closed loop is
    /// not the first repeated. Consecutive points differ.
    pub points: Vec<[f64; 2]>,
    /// Triangle under segment `i`: as many as points where closed, one less where open.
    pub triangles: Vec<u32>,
    /// The chain returns to its first point.
    pub closed: bool,
}

impl Loop {
    /// Signed area, mm²: positive where counter-clockwise seen from `+x`. Of an open chain: closed
    /// by its chord.
    pub fn area_mm2(&self) -> f64 {
        let Some(&o) = self.points.first() else { return 0.0 };
        let cross = |a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
        0.5 * self.points.windows(2).map(|w| cross(w[0], w[1])).sum::<f64>()
    }
    /// Length, mm; of a closed loop with its closing segment.
    pub fn length_mm(&self) -> f64 {
        let d = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let open: f64 = self.points.windows(2).map(|w| d(w[0], w[1])).sum();
        match (self.closed, self.points.first(), self.points.last()) {
            (true, Some(&a), Some(&b)) => open + d(a, b),
            _ => open,
        }
    }
    /// Distance of (y, z) from the loop, mm; a closed one's last segment included.
    pub fn distance_mm(&self, q: [f64; 2]) -> f64 {
        let closing = self.points.last().filter(|_| self.closed).zip(self.points.first());
        let segments = self.points.windows(2).map(|w| (&w[0], &w[1])).chain(closing);
        segments.map(|(a, b)| distance_to_segment(q, *a, *b)).fold(f64::INFINITY, f64::min)
    }
    /// Whether (y, z) lies inside the loop (even–odd rule; open chains are closed by their chord).
    pub fn contains(&self, q: [f64; 2]) -> bool {
        let mut inside = false;
        let mut before = match self.points.last() {
            Some(&p) => p,
            None => return false,
        };
        for &p in &self.points {
            if (p[1] > q[1]) != (before[1] > q[1]) {
                let y = before[0] + (q[1] - before[1]) / (p[1] - before[1]) * (p[0] - before[0]);
                inside ^= q[0] < y;
            }
            before = p;
        }
        inside
    }
}

/// Cuts the mesh at `x = x_mm`. Empty where the plane misses the mesh.
pub fn slice(mesh: &Mesh, bvh: &MeshBvh, x_mm: f64) -> Vec<Loop> {
    let mut hit = Vec::new();
    bvh.tree.traverse(|node| {
        if node.mins().x > x_mm || node.maxs().x < x_mm {
            return TraversalAction::Prune;
        }
        hit.extend(node.leaf_data());
        TraversalAction::Continue
    });
    hit.sort_unstable();
    slice_triangles(mesh, &hit, x_mm)
}

/// Cuts only the given triangles (ascending indices): for callers that have their own index over
/// the mesh.
pub fn slice_triangles(mesh: &Mesh, triangles: &[u32], x_mm: f64) -> Vec<Loop> {
    let cuts: Vec<CutTriangle> = triangles.iter().filter_map(|&t| CutTriangle::new(mesh, t, x_mm)).collect();
    // Position in `cuts` by the edge where the cut begins and where it ends; several on one edge
    // where not manifold.
    let mut begins: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    let mut ends: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    for (i, cut) in cuts.iter().enumerate().rev() {
        begins.entry(cut.begin).or_default().push(i);
        ends.entry(cut.end).or_default().push(i);
    }
    let mut used = vec![false; cuts.len()];
    let mut loops = Vec::new();
    for first in 0..cuts.len() {
        if used[first] {
            continue;
        }
        used[first] = true;
        let mut chain = vec![first];
        let mut closed = false;
        let mut last = first;
        while !closed {
            let Some(next) = take(&begins, &mut used, cuts[last].end) else {
                closed = cuts[last].end == cuts[first].begin;
                break;
            };
            chain.push(next);
            last = next;
            closed = cuts[last].end == cuts[first].begin;
        }
        if !closed {
            let mut before = Vec::new();
            let mut head = first;
            while let Some(i) = take(&ends, &mut used, cuts[head].begin) {
                before.push(i);
                head = i;
            }
            before.reverse();
            before.append(&mut chain);
            chain = before;
        }
        loops.extend(assemble(mesh, &cuts, &chain, closed, x_mm));
    }
    loops
}

/// One cut triangle: its edges as (vertex above, vertex below).
struct CutTriangle {
    triangle: u32,
    begin: [u32; 2],
    end: [u32; 2],
}

impl CutTriangle {
    fn new(mesh: &Mesh, triangle: u32, x_mm: f64) -> Option<CutTriangle> {
        let corners = *mesh.triangles.get(triangle as usize)?;
        let above = corners.map(|v| mesh.points[v as usize].x >= x_mm);
        let (mut begin, mut end) = (None, None);
        for k in 0..3 {
            let (a, b) = (k, (k + 1) % 3);
            match (above[a], above[b]) {
                (true, false) => begin = Some([corners[a], corners[b]]),
                (false, true) => end = Some([corners[b], corners[a]]),
                _ => {}
            }
        }
        Some(CutTriangle { triangle, begin: begin?, end: end? })
    }
}

/// The first unused cut at this edge.
fn take(at: &BTreeMap<[u32; 2], Vec<usize>>, used: &mut [bool], edge: [u32; 2]) -> Option<usize> {
    let i = at.get(&edge)?.iter().rev().copied().find(|&i| !used[i])?;
    used[i] = true;
    Some(i)
}

/// Points of a chain of cuts, without repeated ones; `None` where it shrinks to a point or a line.
fn assemble(mesh: &Mesh, cuts: &[CutTriangle], chain: &[usize], closed: bool, x_mm: f64) -> Option<Loop> {
    let at = |e: [u32; 2]| crossing(mesh, e, x_mm);
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(chain.len() + 1);
    let mut triangles: Vec<u32> = Vec::with_capacity(chain.len());
    for &i in chain {
        let p = at(cuts[i].begin);
        if points.last() == Some(&p) {
            // The segment that began here had no length: this one takes its place.
            triangles.pop();
        } else {
            points.push(p);
        }
        triangles.push(cuts[i].triangle);
    }
    let end = at(cuts[*chain.last()?].end);
    let repeats = points.last() == Some(&end);
    if closed {
        while points.len() > 1 && points.last() == points.first() {
            points.pop();
            triangles.pop();
        }
        return (points.len() >= 3).then_some(Loop { points, triangles, closed });
    }
    if repeats {
        triangles.pop();
    } else {
        points.push(end);
    }
    (points.len() >= 2).then_some(Loop { points, triangles, closed })
}

/// Where the edge meets the plane, interpolated from its lower-numbered vertex.
fn crossing(mesh: &Mesh, edge: [u32; 2], x_mm: f64) -> [f64; 2] {
    let (i, j) = (edge[0].min(edge[1]), edge[0].max(edge[1]));
    let (a, b): (Point, Point) = (mesh.points[i as usize], mesh.points[j as usize]);
    // A vertex in the plane is met exactly, whatever the other end.
    if a.x == x_mm {
        return [a.y, a.z];
    }
    if b.x == x_mm {
        return [b.y, b.z];
    }
    let t = (x_mm - a.x) / (b.x - a.x);
    [a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A tube of n sides about the x axis, radius r(x), closed by fans at both ends.
    fn tube(n: u32, xs: &[f64], r: impl Fn(f64) -> f64) -> Mesh {
        let mut mesh = Mesh::default();
        for &x in xs {
            for k in 0..n {
                let a = std::f64::consts::TAU * f64::from(k) / f64::from(n);
                mesh.points.push(Point::new(x, r(x) * a.cos(), r(x) * a.sin()));
            }
        }
        for row in 0..(xs.len() as u32 - 1) {
            for k in 0..n {
                let (a, b) = (row * n + k, row * n + (k + 1) % n);
                mesh.triangles.push([a, b + n, b]);
                mesh.triangles.push([a, a + n, b + n]);
            }
        }
        for (row, x, up) in [(0, xs[0], false), (xs.len() as u32 - 1, xs[xs.len() - 1], true)] {
            let c = mesh.points.len() as u32;
            mesh.points.push(Point::new(x, 0.0, 0.0));
            for k in 0..n {
                let (a, b) = (row * n + k, row * n + (k + 1) % n);
                mesh.triangles.push(if up { [c, b, a] } else { [c, a, b] });
            }
        }
        // The winding above is inward or outward by construction; make it outward.
        if mesh.volume_mm3() < 0.0 {
            mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        mesh
    }

    fn cut(mesh: &Mesh, x: f64) -> Vec<Loop> {
        slice(mesh, &MeshBvh::new(mesh), x)
    }

    #[test]
    fn section_of_a_tube_is_its_polygon() {
        let mesh = tube(12, &[0.0, 1.0, 2.5, 4.0], |_| 2.0);
        let polygon = 0.5 * 12.0 * 4.0 * (std::f64::consts::TAU / 12.0).sin();
        // Between rings, and exactly through a ring of vertices.
        for x in [0.3, 1.0, 2.5, 3.9, 4.0] {
            let loops = cut(&mesh, x);
            assert_eq!(loops.len(), 1, "x = {x}");
            assert!(loops[0].closed);
            assert_eq!(loops[0].points.len(), loops[0].triangles.len());
            assert!((loops[0].area_mm2() - polygon).abs() < 1e-12, "x = {x}: {}", loops[0].area_mm2());
            assert!(loops[0].contains([0.1, -0.2]) && !loops[0].contains([2.1, 0.0]));
        }
    }

    #[test]
    fn planes_that_miss_or_only_touch_give_nothing() {
        let mesh = tube(7, &[0.0, 1.0], |_| 1.0);
        assert!(cut(&mesh, -0.1).is_empty());
        assert!(cut(&mesh, 1.1).is_empty());
        // The bottom ring counts as above the plane: nothing is cut.
        assert!(cut(&mesh, 0.0).is_empty());
        // A double cone touched at its apex.
        let spike = tube(7, &[0.0, 1.0, 2.0], |x| if x == 1.0 { 1.0 } else { 0.0 });
        assert!(cut(&spike, 2.0).is_empty());
        assert_eq!(cut(&spike, 1.0).len(), 1);
    }

    #[test]
    fn segments_lie_on_their_triangles() {
        let mesh = tube(9, &[0.0, 1.0, 2.0], |x| 1.0 + 0.4 * x);
        for l in cut(&mesh, 0.7) {
            for i in 0..l.points.len() {
                let (p, q) = (l.points[i], l.points[(i + 1) % l.points.len()]);
                let t = l.triangles[i] as usize;
                let (n, c) = (mesh.normal(t), mesh.corners(t)[0]);
                for e in [p, q] {
                    assert!((Point::new(0.7, e[0], e[1]) - c).dot(&n).abs() < 1e-12);
                }
                // Material on the left: the outward normal points to the right of the walk.
                let d = [q[0] - p[0], q[1] - p[1]];
                assert!(d[1] * n.y - d[0] * n.z > 0.0);
            }
        }
    }

    #[test]
    fn a_missing_triangle_opens_the_loop() {
        let mut mesh = tube(12, &[0.0, 1.0], |_| 2.0);
        mesh.triangles.remove(4);
        let loops = cut(&mesh, 0.5);
        assert_eq!(loops.len(), 1);
        assert!(!loops[0].closed);
        assert_eq!(loops[0].points.len(), loops[0].triangles.len() + 1);
        assert_eq!(loops[0].triangles.len(), 23);
    }

    #[test]
    fn holes_run_the_other_way() {
        let outer = tube(12, &[0.0, 1.0], |_| 2.0);
        let mut mesh = outer.clone();
        let inner = tube(12, &[0.0, 1.0], |_| 1.0);
        let base = mesh.points.len() as u32;
        mesh.points.extend(&inner.points);
        mesh.triangles.extend(inner.triangles.iter().map(|t| [t[0] + base, t[2] + base, t[1] + base]));
        let loops = cut(&mesh, 0.5);
        assert_eq!(loops.len(), 2);
        assert!(loops[0].area_mm2() > 0.0 && loops[1].area_mm2() < 0.0);
    }

    proptest::proptest! {
        /// Areas of sections integrate to the volume (a twisted, scaled tube, many random heights
        /// included vertices).
        #[test]
        fn every_section_of_a_closed_mesh_closes(x in 0.0_f64..3.0, n in 3u32..20, tilt in -0.4_f64..0.4) {
            let mut mesh = tube(n, &[0.0, 1.0, 2.0, 3.0], |x| 1.0 + 0.3 * x);
            for p in &mut mesh.points { p.x += tilt * p.y; }
            for at in [x, mesh.points[(x * 7.0) as usize % mesh.points.len()].x] {
                for l in cut(&mesh, at) {
                    proptest::prop_assert!(l.closed);
                    proptest::prop_assert!(l.area_mm2() > 0.0);
                }
            }
        }
    }
}
