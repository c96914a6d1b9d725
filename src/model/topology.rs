//! Edges of a mesh file's triangles: open, shared by more than two, wound against each other; connected pieces.

use crate::geometry::Point;
use crate::geometry::mesh::Mesh;

/// What the edges of a mesh look like.
pub struct Edges {
    /// Edges with one triangle (or an odd number).
    pub open: usize,
    /// The first of them, by vertex numbers.
    pub first_open: Option<[u32; 2]>,
    /// Edges with more than two triangles.
    pub non_manifold: usize,
    /// Edges that are used more often in one direction than in the other, though they have an even number of triangles.
    pub misaligned: usize,
}

/// Uses of edges by triangles: (low vertex, high vertex, runs from low to high, triangle), sorted.
fn uses(mesh: &Mesh) -> Vec<(u32, u32, bool, u32)> {
    let mut all = Vec::with_capacity(3 * mesh.triangles.len());
    for (t, c) in mesh.triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (c[k], c[(k + 1) % 3]);
            all.push((a.min(b), a.max(b), a < b, t as u32));
        }
    }
    all.sort_unstable();
    all
}

impl Edges {
    /// Examines all edges.
    pub fn new(mesh: &Mesh) -> Self {
        let mut out = Edges { open: 0, first_open: None, non_manifold: 0, misaligned: 0 };
        for group in uses(mesh).chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let up = group.iter().filter(|u| u.2).count();
            if group.len() % 2 == 1 {
                out.open += 1;
                out.first_open.get_or_insert([group[0].0, group[0].1]);
            } else if 2 * up != group.len() {
                out.misaligned += 1;
            }
            out.non_manifold += usize::from(group.len() > 2);
        }
        out
    }
    /// Middle of the first open edge.
    pub fn first_open_mm(&self, mesh: &Mesh) -> Option<Point> {
        let [a, b] = self.first_open?;
        Some(nalgebra::center(&mesh.points[a as usize], &mesh.points[b as usize]))
    }
}

/// Winds all triangles of a piece alike, walking over edges with two triangles, and each piece outward. Returns how
/// many were turned.
pub fn align(mesh: &mut Mesh) -> usize {
    let n = mesh.triangles.len();
    let mut neighbours: Vec<Vec<(u32, bool)>> = vec![Vec::new(); n];
    for pair in uses(mesh).chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|g| g.len() == 2) {
        let against = pair[0].2 == pair[1].2;
        neighbours[pair[0].3 as usize].push((pair[1].3, against));
        neighbours[pair[1].3 as usize].push((pair[0].3, against));
    }
    let mut turn: Vec<Option<bool>> = vec![None; n];
    for seed in 0..n {
        if turn[seed].is_some() {
            continue;
        }
        turn[seed] = Some(false);
        let mut piece = vec![seed];
        let mut at = 0;
        while at < piece.len() {
            let t = piece[at];
            at += 1;
            for &(next, against) in &neighbours[t] {
                if turn[next as usize].is_none() {
                    turn[next as usize] = turn[t].map(|x| x ^ against);
                    piece.push(next as usize);
                }
            }
        }
        let volume: f64 = piece
            .iter()
            .map(|&t| {
                let [a, b, c] = mesh.corners(t);
                let v = a.coords.dot(&b.coords.cross(&c.coords));
                if turn[t] == Some(true) { -v } else { v }
            })
            .sum();
        if volume < 0.0 {
            piece.iter().for_each(|&t| turn[t] = turn[t].map(|x| !x));
        }
    }
    let mut turned = 0;
    for (corners, turn) in mesh.triangles.iter_mut().zip(turn) {
        if turn == Some(true) {
            corners.swap(1, 2);
            turned += 1;
        }
    }
    turned
}

/// Number of pieces connected through vertices.
pub fn bodies(mesh: &Mesh) -> usize {
    let mut parent: Vec<u32> = (0..mesh.points.len() as u32).collect();
    fn root(parent: &mut [u32], mut i: u32) -> u32 {
        while parent[i as usize] != i {
            parent[i as usize] = parent[parent[i as usize] as usize];
            i = parent[i as usize];
        }
        i
    }
    for &[a, b, c] in &mesh.triangles {
        for (p, q) in [(a, b), (b, c)] {
            let (p, q) = (root(&mut parent, p), root(&mut parent, q));
            parent[p.max(q) as usize] = p.min(q);
        }
    }
    let mut seen: Vec<u32> = mesh.triangles.iter().map(|t| root(&mut parent, t[0])).collect();
    seen.sort_unstable();
    seen.dedup();
    seen.len()
}
