//! Triangles of a mesh file wound alike: neighbours agree, and every piece has its normals outward.

use crate::geometry::mesh::Mesh;

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
