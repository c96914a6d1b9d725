//! Meshes made small enough to look at.

use std::collections::HashMap;

use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};

/// The mesh with at most `budget` triangles, and the grid's cell where it had to be thinned, mm.
/// Vertices of one cell become their mean; triangles that collapse go away (Rossignac and Borrel
/// 1993).
pub(super) fn thinned(mesh: &Mesh, budget: usize) -> (Mesh, Option<f64>) {
    let Some(bounds) = mesh.aabb() else { return (mesh.clone(), None) };
    if mesh.triangles.len() <= budget {
        return (mesh.clone(), None);
    }
    let extent = bounds.diagonal_mm();
    let mut cell = (mesh.area_mm2() / budget.max(1) as f64).sqrt().max(extent * 1e-6);
    loop {
        let small = clustered(mesh, &bounds.min, cell);
        // The largest cell holds the whole part: nothing is left, which fits every budget.
        if small.triangles.len() <= budget || !(cell.is_finite() && cell <= 2.0 * extent) {
            return (small, Some(cell));
        }
        cell *= 1.25;
    }
}

fn clustered(mesh: &Mesh, origin: &Point, cell: f64) -> Mesh {
    let mut id_of: HashMap<[i64; 3], u32> = HashMap::new();
    let mut sums: Vec<(Vector, f64)> = Vec::new();
    let ids: Vec<u32> = mesh
        .points
        .iter()
        .map(|p| {
            let q = (p - origin) / cell;
            let next = u32::try_from(sums.len()).unwrap_or(u32::MAX);
            let id = *id_of.entry([q.x.floor() as i64, q.y.floor() as i64, q.z.floor() as i64]).or_insert(next);
            if id == next {
                sums.push((Vector::zeros(), 0.0));
            }
            if let Some(s) = sums.get_mut(id as usize) {
                *s = (s.0 + p.coords, s.1 + 1.0);
            }
            id
        })
        .collect();
    let mut out = Mesh { points: sums.iter().map(|(s, n)| Point::from(s / *n)).collect(), ..Mesh::default() };
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|i| ids[i as usize]);
        if a != b && b != c && c != a {
            out.triangles.push([a, b, c]);
            out.face_of.push(mesh.face(t));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    #[test]
    fn thinning_keeps_the_budget_and_the_shape() {
        let mesh = sample::blade().part.mesh;
        let (small, cell) = thinned(&mesh, 60);
        assert!(small.triangles.len() <= 60 && cell.is_some());
        assert_eq!(thinned(&mesh, 192), (mesh.clone(), None));
        let (big, was) = (small.aabb().unwrap(), mesh.aabb().unwrap());
        assert!((big.diagonal_mm() / was.diagonal_mm() - 1.0).abs() < 0.3);
        assert!(thinned(&mesh, 0).0.triangles.is_empty());
        assert_eq!(thinned(&Mesh::default(), 0).1, None);
    }
}
