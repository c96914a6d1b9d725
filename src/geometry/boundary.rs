//! The openings of a mesh: where its edges have one triangle only, joined to rings; and triangles
//! that close a ring.
//!
//! In: an indexed mesh (weld it first). Out: [`Opening`]s in a fixed order, and the least-area
//! filling of a ring (Barequet and Sharir, *Filling gaps in the boundary of a polyhedron*, 1995:
//! dynamic programming over the ring's chords), which also measures how wide an opening is.
//! Guarantees: every edge with one triangle is in exactly one opening.

use std::collections::{BTreeMap, BTreeSet};

use super::mesh::{EdgeUse, Mesh, edge_uses};
use super::triangle::area_mm2;
use super::{Aabb, Point, Vector};

/// Rings of more corners are filled by a fan about their centroid: dynamic programming takes the
/// cube of their number.
const MOST_EXACT: usize = 100;

/// One opening: a chain of edges that have one triangle each.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Vertices in the order in which the triangles beside them run.
    pub vertices: Vec<u32>,
    /// The chain returns to its first vertex (which is not repeated). Chains that do not lie
    /// between triangles that wind against one another.
    pub ring: bool,
}

impl Opening {
    /// Corners of the chain.
    pub fn points(&self, mesh: &Mesh) -> Vec<Point> {
        self.vertices.iter().map(|&v| mesh.points[v as usize]).collect()
    }
    /// Number of edges.
    pub fn edges(&self) -> usize {
        if self.ring { self.vertices.len() } else { self.vertices.len().saturating_sub(1) }
    }
    /// Length of the chain, mm.
    pub fn length_mm(&self, mesh: &Mesh) -> f64 {
        let p = self.points(mesh);
        (0..self.edges()).map(|k| (p[(k + 1) % p.len()] - p[k]).norm()).sum()
    }
    /// Box around it; `None` without vertices.
    pub fn aabb(&self, mesh: &Mesh) -> Option<Aabb> {
        Aabb::around(&self.points(mesh))
    }
    /// Greatest distance of two of its corners, mm; of a very long chain the diagonal of its box,
    /// which is no less.
    pub fn extent_mm(&self, mesh: &Mesh) -> f64 {
        extent_mm(&self.points(mesh))
    }
    /// Four times the area that closes it over its length, at most its extent, mm: the diameter of
    /// a circle, twice the width of a crack. Of a chain that is no ring: its extent.
    pub fn width_mm(&self, mesh: &Mesh) -> f64 {
        let p = self.points(mesh);
        let extent = extent_mm(&p);
        if !self.ring {
            return extent;
        }
        let area: f64 = match fill(&p) {
            Some(triangles) => triangles.iter().map(|t| area_mm2(&t.map(|k| p[k]))).sum(),
            None => {
                let c = centroid(&p);
                (0..p.len()).map(|k| area_mm2(&[c, p[k], p[(k + 1) % p.len()]])).sum()
            }
        };
        (4.0 * area / self.length_mm(mesh).max(f64::MIN_POSITIVE)).min(extent)
    }
}

/// Mean of the corners.
pub fn centroid(points: &[Point]) -> Point {
    let n = points.len().max(1) as f64;
    Point::from(points.iter().map(|p| p.coords).sum::<Vector>() / n)
}

/// All openings, in the order of their lowest edges.
pub fn openings(mesh: &Mesh) -> Vec<Opening> {
    let mut next = open_edges(mesh);
    let mut out = Vec::new();
    // Ends that no edge runs into come first, so that chains which do not close are walked from
    // their beginning.
    let targets: BTreeSet<u32> = next.values().flatten().copied().collect();
    let starts: Vec<u32> = next.keys().copied().filter(|v| !targets.contains(v)).collect();
    for start in starts {
        while next.get(&start).is_some_and(|n| !n.is_empty()) {
            walk(start, &mut next, &mut out);
        }
    }
    while let Some(start) = next.iter().find(|(_, n)| !n.is_empty()).map(|(v, _)| *v) {
        walk(start, &mut next, &mut out);
    }
    out
}

/// Directed edges with one triangle: vertex → vertices that edges run to, descending.
fn open_edges(mesh: &Mesh) -> BTreeMap<u32, Vec<u32>> {
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for group in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge) {
        if let [EdgeUse { edge: [low, high], rising, .. }] = *group {
            let (from, to) = if rising { (low, high) } else { (high, low) };
            next.entry(from).or_default().push(to);
        }
    }
    next.values_mut().for_each(|n| n.sort_unstable_by(|a, b| b.cmp(a)));
    next
}

/// Follows edges from `start` until they end; every ring met on the way is cut out.
fn walk(start: u32, next: &mut BTreeMap<u32, Vec<u32>>, out: &mut Vec<Opening>) {
    let mut path = vec![start];
    let mut position: BTreeMap<u32, usize> = BTreeMap::from([(start, 0)]);
    let mut at = start;
    while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
        if let Some(&k) = position.get(&to) {
            let ring = path.split_off(k);
            ring.iter().for_each(|v| {
                position.remove(v);
            });
            out.push(Opening { vertices: ring, ring: true });
            // The walk goes on from where the ring was met.
        }
        position.insert(to, path.len());
        path.push(to);
        at = to;
        // Empty entries are left behind: looking for the next start skips them.
    }
    if path.len() > 1 {
        out.push(Opening { vertices: path, ring: false });
    }
    next.retain(|_, n| !n.is_empty());
}

/// Triangles (indices into `ring`, in its sense) of least total area that close a ring; `None` for
/// fewer than three or too many corners.
pub fn fill(ring: &[Point]) -> Option<Vec<[usize; 3]>> {
    let n = ring.len();
    if !(3..=MOST_EXACT).contains(&n) {
        return None;
    }
    // best[i][j]: least area between the chord i–j and the chain from i to j; by[i][j]: the third
    // corner.
    let mut best = vec![vec![0.0_f64; n]; n];
    let mut by = vec![vec![0usize; n]; n];
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let mut least = f64::INFINITY;
            for k in i + 1..j {
                let total = best[i][k] + best[k][j] + area_mm2(&[ring[i], ring[k], ring[j]]);
                if total < least {
                    (least, by[i][j]) = (total, k);
                }
            }
            if !least.is_finite() {
                return None;
            }
            best[i][j] = least;
        }
    }
    let mut out = Vec::with_capacity(n - 2);
    let mut todo = vec![(0, n - 1)];
    while let Some((i, j)) = todo.pop() {
        if j < i + 2 {
            continue;
        }
        let k = by[i][j];
        out.push([i, k, j]);
        todo.extend([(i, k), (k, j)]);
    }
    Some(out)
}

/// Of more points than this not all pairs are looked at.
const MOST_PAIRED: usize = 4000;

/// See [`Opening::extent_mm`].
fn extent_mm(points: &[Point]) -> f64 {
    if points.len() > MOST_PAIRED {
        return Aabb::around(points).map_or(0.0, |b| b.diagonal_mm());
    }
    let from = |(k, p): (usize, &Point)| points[k + 1..].iter().map(|q| (q - p).norm_squared()).fold(0.0, f64::max);
    points.iter().enumerate().map(from).fold(0.0, f64::max).sqrt()
}

/// Closes every ring whose [`Opening::extent_mm`] is not over `most_mm`, with triangles of face
/// `face`. Returns how many were closed.
///
/// The filling has the least area; where one of its chords is an edge of the mesh already, or the
/// ring is too long for that, it is a fan about a new vertex in the middle.
pub fn close(mesh: &mut Mesh, most_mm: f64, face: u32) -> usize {
    let mut edges: BTreeSet<(u32, u32)> = BTreeSet::new();
    for c in &mesh.triangles {
        edges.extend((0..3).map(|k| (c[k].min(c[(k + 1) % 3]), c[k].max(c[(k + 1) % 3]))));
    }
    if mesh.face_of.is_empty() {
        mesh.face_of = vec![0; mesh.triangles.len()];
    }
    let mut closed = 0;
    for opening in openings(mesh).into_iter().filter(|o| o.ring && o.vertices.len() >= 3) {
        let points = opening.points(mesh);
        if extent_mm(&points) > most_mm {
            continue;
        }
        let v = &opening.vertices;
        let n = v.len();
        let side = |a: usize, b: usize| (a + 1) % n == b || (b + 1) % n == a;
        let taken = |a: usize, b: usize| !side(a, b) && edges.contains(&(v[a].min(v[b]), v[a].max(v[b])));
        let exact =
            fill(&points).filter(|f| !f.iter().any(|t| taken(t[0], t[1]) || taken(t[1], t[2]) || taken(t[2], t[0])));
        // The ring runs with the triangles beside it, so what closes it runs against it.
        let added: Vec<[u32; 3]> = match exact {
            Some(f) => f.iter().map(|t| [v[t[0]], v[t[2]], v[t[1]]]).collect(),
            None => {
                mesh.points.push(centroid(&points));
                let c = mesh.points.len() as u32 - 1;
                (0..n).map(|k| [v[(k + 1) % n], v[k], c]).collect()
            }
        };
        for c in added {
            edges.extend((0..3).map(|k| (c[k].min(c[(k + 1) % 3]), c[k].max(c[(k + 1) % 3]))));
            mesh.triangles.push(c);
            mesh.face_of.push(face);
        }
        closed += 1;
    }
    closed
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::mesh::topology;
    use super::*;

    /// A box a × b × c of 12 triangles, wound outward; triangles 2k and 2k + 1 are one side.
    fn cuboid(a: f64, b: f64, c: f64) -> Mesh {
        let points = (0..8).map(|i| Point::new((i & 1) as f64 * a, (i >> 1 & 1) as f64 * b, (i >> 2) as f64 * c));
        let quads: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
        Mesh { points: points.collect(), triangles, ..Mesh::default() }
    }

    #[test]
    fn a_closed_box_has_no_opening_and_a_lid_is_one() {
        let mut mesh = cuboid(3.0, 4.0, 5.0);
        assert!(openings(&mesh).is_empty());
        mesh.triangles.drain(2..4);
        let found = openings(&mesh);
        assert_eq!(found.len(), 1);
        assert!(found[0].ring && found[0].edges() == 4);
        assert!((found[0].length_mm(&mesh) - 14.0).abs() < 1e-12);
        // 4 · 12 / 14.
        assert!((found[0].width_mm(&mesh) - 48.0 / 14.0).abs() < 1e-12);
        assert_eq!(close(&mut mesh, 4.99, 7), 0);
        assert_eq!(close(&mut mesh, 5.01, 7), 1);
        assert!(topology(&mesh).closed() && (mesh.volume_mm3() - 60.0).abs() < 1e-12);
        assert_eq!(mesh.face_of[10..], [7, 7]);
    }

    #[test]
    fn rings_that_touch_in_a_vertex_are_two() {
        let mut mesh = cuboid(1.0, 1.0, 1.0);
        // Triangle 0 (0 2 3) and triangle 5 (0 5 4) share vertex 0 only.
        mesh.triangles =
            mesh.triangles.iter().enumerate().filter(|(t, _)| ![0, 5].contains(t)).map(|(_, c)| *c).collect();
        let found = openings(&mesh);
        assert_eq!(found.iter().map(|o| (o.ring, o.edges())).collect::<Vec<_>>(), [(true, 3), (true, 3)]);
        assert_eq!(close(&mut mesh, 10.0, 0), 2);
        assert!(topology(&mesh).closed() && (mesh.volume_mm3() - 1.0).abs() < 1e-12);
    }

    /// A tube without ends: circles of n corners, radius r, at x = 0 and x = l.
    fn tube(n: u32, r: f64, l: f64) -> Mesh {
        let mut mesh = Mesh::default();
        for x in [0.0, l] {
            for k in 0..n {
                let a = std::f64::consts::TAU * f64::from(k) / f64::from(n);
                mesh.points.push(Point::new(x, r * a.cos(), r * a.sin()));
            }
        }
        for k in 0..n {
            let (a, b) = (k, (k + 1) % n);
            mesh.triangles.extend([[a, b, b + n], [a, b + n, a + n]]);
        }
        mesh
    }

    #[test]
    fn long_rings_are_fanned_and_width_is_the_diameter() {
        for n in [24, 240] {
            let mut mesh = tube(n, 2.0, 5.0);
            let found = openings(&mesh);
            assert_eq!(found.len(), 2);
            for o in &found {
                assert!((o.width_mm(&mesh) - 4.0).abs() < 0.05, "{}", o.width_mm(&mesh));
            }
            assert_eq!(close(&mut mesh, 100.0, 1), 2);
            let t = topology(&mesh);
            assert!(t.closed() && t.components == 1, "{t:?}");
            let polygon = 0.5 * f64::from(n) * 4.0 * (std::f64::consts::TAU / f64::from(n)).sin();
            assert!((mesh.volume_mm3().abs() - 5.0 * polygon).abs() < 1e-9);
        }
    }

    #[test]
    fn a_crack_is_twice_its_width() {
        let p = |x: f64, y: f64| Point::new(x, y, 0.0);
        let mut crack: Vec<Point> = (0..=20).map(|k| p(f64::from(k), 0.0)).collect();
        crack.extend((0..=20).rev().map(|k| p(f64::from(k), 0.01)));
        let mesh = Mesh { points: crack, ..Mesh::default() };
        let o = Opening { vertices: (0..42).collect(), ring: true };
        assert!((o.width_mm(&mesh) - 0.02).abs() < 2e-5, "{}", o.width_mm(&mesh));
    }

    #[test]
    fn least_area_follows_a_bent_ring() {
        // Two unit squares at a right angle, sharing the side from b to e: the least filling is the
        // two squares' 2 units.
        let ring =
            [[0., 0., 0.], [1., 0., 0.], [1., 0., 1.], [1., 1., 1.], [1., 1., 0.], [0., 1., 0.]].map(Point::from);
        let f = fill(&ring).unwrap();
        let total: f64 = f.iter().map(|t| area_mm2(&t.map(|k| ring[k]))).sum();
        assert!(f.len() == 4 && (total - 2.0).abs() < 1e-12, "{f:?} {total}");
    }
}
