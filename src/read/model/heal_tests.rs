//! Faults of meshes with closed forms.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::geometry::Point;

/// A cube of side 2, outward; each side two triangles.
fn cube() -> Mesh {
    let points =
        (0..8).map(|i: u32| Point::new(2.0 * f64::from(i & 1), 2.0 * f64::from(i >> 1 & 1), 2.0 * f64::from(i >> 2)));
    let quads: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
    Mesh { points: points.collect(), face_of: vec![0; triangles.len()], triangles, ..Mesh::default() }
}

fn sound(healed: &Healed) {
    let t = topology(&healed.mesh);
    assert!(t.closed() && t.components == 1, "{t:?} {:?}", healed.notes);
    assert!((healed.mesh.volume_mm3() - 8.0).abs() < 1e-4, "{}", healed.mesh.volume_mm3());
    assert!((healed.mesh.area_mm2() - 24.0).abs() < 1e-4);
}

fn healed(mesh: Mesh) -> Healed {
    heal(mesh, &HealOptions::default())
}

#[test]
fn a_sound_mesh_is_left_alone() {
    let h = healed(cube());
    sound(&h);
    assert!(h.notes.is_empty(), "{:?}", h.notes);
    assert_eq!(h.mesh.triangles.len(), 12);
}

#[test]
fn corners_apart_by_rounding_are_welded_and_apart_by_more_are_not() {
    for (gap, closes) in [(1e-7, true), (2e-6, true), (2e-5, true), (1e-3, false)] {
        let mut mesh = cube();
        // The two triangles of the lid get corners of their own, shifted.
        for t in [2, 3] {
            for k in 0..3 {
                let p = mesh.points[mesh.triangles[t][k] as usize];
                mesh.points.push(Point::new(p.x + gap, p.y, p.z));
                mesh.triangles[t][k] = mesh.points.len() as u32 - 1;
            }
        }
        let h = healed(mesh.clone());
        assert_eq!(topology(&h.mesh).open_edges == 0, closes, "{gap}: {:?}", h.notes);
        if closes {
            sound(&h);
            assert!(h.notes.iter().any(|n| n.to_string().contains("merged")), "{:?}", h.notes);
        }
        // The user may ask for more.
        sound_loosely(&heal(mesh, &HealOptions { weld_mm: Some(0.01), ..HealOptions::default() }));
    }
}

fn sound_loosely(h: &Healed) {
    assert!(topology(&h.mesh).closed(), "{:?}", h.notes);
    assert!((h.mesh.volume_mm3() - 8.0).abs() < 0.02);
}

#[test]
fn repeated_triangles_go() {
    let mut mesh = cube();
    for (t, turned) in [(3, false), (3, false), (7, true)] {
        let [a, b, c] = mesh.triangles[t];
        // A repeat beginning with another corner; one also wound the other way.
        mesh.triangles.push(if turned { [c, b, a] } else { [b, c, a] });
        mesh.face_of.push(0);
    }
    let h = healed(mesh);
    sound(&h);
    assert!(h.notes.iter().any(|n| n.to_string().starts_with("3 duplicate")), "{:?}", h.notes);
    assert_eq!(h.mesh.face_of.len(), h.mesh.triangles.len());
}

#[test]
fn a_wall_without_thickness_inside_goes() {
    // Two cubes on one another, each with its own wall between: the two walls cancel.
    let mut mesh = cube();
    let lower = cube();
    let shift: Vec<u32> = (0..8u32).map(|i| if i < 4 { i + 8 } else { i - 4 }).collect();
    mesh.points.extend(lower.points[..4].iter().map(|p| Point::new(p.x, p.y, -2.0)));
    mesh.triangles.extend(lower.triangles.iter().map(|c| c.map(|v| shift[v as usize])));
    // The upper side of the lower cube is cut along the other diagonal: make it the same as the
    // floor of the upper one.
    let floor: Vec<[u32; 3]> = mesh.triangles[0..2].iter().map(|c| [c[0], c[2], c[1]]).collect();
    mesh.triangles[12 + 2] = floor[0];
    mesh.triangles[12 + 3] = floor[1];
    mesh.face_of = vec![0; mesh.triangles.len()];
    assert!(topology(&mesh).nonmanifold_edges > 0);
    let h = healed(mesh);
    let t = topology(&h.mesh);
    assert!(t.closed() && t.components == 1, "{t:?} {:?}", h.notes);
    assert!((h.mesh.volume_mm3() - 16.0).abs() < 1e-12);
    assert!(h.notes.iter().any(|n| n.to_string().starts_with("4 duplicate")), "{:?}", h.notes);
}

#[test]
fn triangles_without_area_are_merged_into_their_neighbours() {
    // A vertex on the middle of one edge: one side of the edge is split there, the other gets a
    // flat triangle in between.
    let mut mesh = cube();
    let [a, b, c] = mesh.triangles[0];
    let middle = nalgebra::center(&mesh.points[a as usize], &mesh.points[b as usize]);
    mesh.points.push(middle);
    let m = mesh.points.len() as u32 - 1;
    mesh.triangles[0] = [a, m, c];
    mesh.triangles.extend([[m, b, c], [a, b, m]]);
    mesh.face_of.extend([0, 0]);
    assert!(topology(&mesh).closed());
    let h = healed(mesh);
    sound(&h);
    assert!(h.notes.iter().any(|n| n.to_string().starts_with("1 triangles without area")), "{:?}", h.notes);
    assert!((0..h.mesh.triangles.len()).all(|t| height(&h.mesh, t) > 0.1));
}

#[test]
fn holes_are_closed_on_request_only() {
    let mut mesh = cube();
    mesh.triangles.remove(4);
    mesh.face_of.remove(4);
    assert_eq!(topology(&healed(mesh.clone()).mesh).open_edges, 3);
    let small = heal(mesh.clone(), &HealOptions { close_holes_mm: Some(1.0), ..HealOptions::default() });
    assert_eq!(topology(&small.mesh).open_edges, 3);
    assert!(small.notes.iter().any(|n| n.to_string().contains("no hole up to 1 mm")), "{:?}", small.notes);
    let h = heal(mesh, &HealOptions { close_holes_mm: Some(3.0), ..HealOptions::default() });
    sound(&h);
    assert!(
        h.notes.iter().any(|n| n.to_string().contains("1 holes up to 3 mm were closed with 1 triangles")),
        "{:?}",
        h.notes
    );
}

#[test]
fn pieces_that_share_an_edge_stay_and_are_wound_each() {
    // Two tetrahedra that share one edge: four triangles at it, nothing to repair.
    let p = [[0., 0., 0.], [0., 0., 1.], [1., 0., 0.], [0., 1., 0.], [-1., 0., 0.], [0., -1., 0.]].map(Point::from);
    let mut triangles = Vec::new();
    for [a, b, c, d] in [[0, 1, 2, 3], [0, 1, 4, 5]] {
        triangles.extend([[a, b, c], [a, d, b], [b, d, c], [a, c, d]]);
    }
    let mesh = Mesh { points: p.to_vec(), face_of: vec![0; 8], triangles, ..Mesh::default() };
    let h = healed(mesh);
    let t = topology(&h.mesh);
    assert_eq!((t.nonmanifold_edges, t.open_edges, h.mesh.triangles.len()), (1, 0, 8));
    assert!((h.mesh.volume_mm3() - 2.0 / 6.0).abs() < 1e-12, "{}", h.mesh.volume_mm3());
}
