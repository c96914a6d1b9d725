//! Meshes made small enough to look at.

use std::collections::HashMap;

use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};

/// The mesh with at most `budget` triangles, and the grid's cell where it had to be thinned, mm.
/// Vertices of one cell become their mean; triangles that collapse go away (Rossignac and Borrel
/// 1993). Those that look to different sides stay apart, else both sides of a thin blade would
/// become one.
pub(super) fn thinned(mesh: &Mesh, budget: usize) -> (Mesh, Option<f64>) {
    let Some(bounds) = mesh.aabb() else { return (mesh.clone(), None) };
    if mesh.triangles.len() <= budget {
        return (mesh.clone(), None);
    }
    let extent = bounds.diagonal_mm();
    let (sides, level) = (sides(mesh), vec![0; mesh.points.len()]);
    let mut cell = (mesh.area_mm2() / budget.max(1) as f64).sqrt().max(extent * 1e-6);
    loop {
        // Within a cell as large as the part no sides are told apart, so any budget is kept.
        let sides = if cell <= extent { &sides } else { &level };
        let small = clustered(mesh, sides, &bounds.min, cell);
        // The largest cell holds the whole part: nothing is left, which fits every budget.
        if small.triangles.len() <= budget || !(cell.is_finite() && cell <= 2.0 * extent) {
            return (small, Some(cell));
        }
        cell *= 1.25;
    }
}

/// To which side of a cube each vertex looks, by the mean of its triangles' normals.
fn sides(mesh: &Mesh) -> Vec<u8> {
    let mut normals = vec![Vector::zeros(); mesh.points.len()];
    for (t, corners) in mesh.triangles.iter().enumerate() {
        let [a, b, c] = mesh.corners(t);
        let normal = (b - a).cross(&(c - a));
        corners.iter().for_each(|i| normals[*i as usize] += normal);
    }
    let side = |n: &Vector| {
        let k = n.iamax();
        2 * k as u8 + u8::from(n[k] < 0.0)
    };
    normals.iter().map(side).collect()
}

fn clustered(mesh: &Mesh, sides: &[u8], origin: &Point, cell: f64) -> Mesh {
    let mut id_of: HashMap<([i64; 3], u8), u32> = HashMap::new();
    let mut sums: Vec<(Vector, f64)> = Vec::new();
    let ids: Vec<u32> = mesh
        .points
        .iter()
        .zip(sides)
        .map(|(p, side)| {
            let q = (p - origin) / cell;
            let next = u32::try_from(sums.len()).unwrap_or(u32::MAX);
            let key = ([q.x.floor() as i64, q.y.floor() as i64, q.z.floor() as i64], *side);
            let id = *id_of.entry(key).or_insert(next);
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

    /// Two sheets a tenth of a cell apart, each looking away from the other, stay two.
    #[test]
    fn both_sides_of_a_thin_blade_stay_apart() {
        let n = 40u32;
        let mut mesh = Mesh::default();
        for (z, turned) in [(0.0, false), (0.2, true)] {
            let first = mesh.points.len() as u32;
            mesh.points.extend((0..n * n).map(|k| Point::new(f64::from(k % n), f64::from(k / n), z)));
            for k in (0..n * n - n).filter(|k| k % n < n - 1) {
                let (a, b, c, d) = (first + k, first + k + 1, first + k + n, first + k + n + 1);
                let both = [[a, c, b], [b, c, d]];
                mesh.triangles.extend(both.map(|[a, b, c]| if turned { [a, c, b] } else { [a, b, c] }));
            }
        }
        let (small, cell) = thinned(&mesh, 1000);
        assert!(small.triangles.len() <= 1000 && cell.unwrap() > 1.0);
        let heights: Vec<f64> = small.points.iter().map(|p| p.z).collect();
        assert!(heights.iter().all(|z| z.abs() < 1e-9 || (z - 0.2).abs() < 1e-9), "{heights:?}");
        assert!(small.triangles.len() > 200);
    }
}
