//! Squares, boxes and rounds of loose faces.
#![allow(clippy::unwrap_used)]
use nalgebra::Vector4;

use super::*;
use crate::geometry::brep::{Coedge, Edge, Face, SurfaceKind};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};

/// Two squares side by side, each with its own four edges, the second walked the other way.
fn squares(gap: f64) -> Brep {
    let mut brep = Brep::default();
    let line = |a: [f64; 2], b: [f64; 2]| Edge {
        curve: NurbsCurve {
            degree: 1,
            knots: vec![0.0, 0.0, 1.0, 1.0],
            points: vec![Vector4::new(a[0], a[1], 0.0, 1.0), Vector4::new(b[0], b[1], 0.0, 1.0)],
        },
        t: [0.0, 1.0],
    };
    for (x, left_to_right) in [(0.0, true), (1.0 + gap, false)] {
        let mut corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
        if !left_to_right {
            corners.reverse();
        }
        let first = brep.edges.len();
        brep.edges.extend((0..4).map(|k| line(corners[k], corners[(k + 1) % 4])));
        let point = |x: f64, y: f64| Vector4::new(x, y, 0.0, 1.0);
        brep.faces.push(Face {
            name: "".into(),
            kind: SurfaceKind::Plane,
            surface: NurbsSurface::bilinear([point(x, 0.0), point(x, 1.0), point(x + 1.0, 0.0), point(x + 1.0, 1.0)]),
            reversed: false,
            loops: vec![(first..first + 4).map(|edge| Coedge { edge, reversed: false }).collect()],
        });
    }
    brep
}

#[test]
fn coinciding_edges_are_joined_once() {
    let mut brep = squares(1e-4);
    let before: Vec<[Point; 2]> = loop_ends(&brep, 1);
    let sewn = sew(&mut brep, &[1e-3]);
    assert_eq!((sewn.joined, sewn.open, brep.edges.len()), (1, 6, 7));
    assert!((sewn.gap_mm - 1e-4).abs() < 1e-9);
    // The second face's loop still runs through the same corners.
    for (a, b) in before.iter().zip(loop_ends(&brep, 1)) {
        assert!((a[0] - b[0]).norm() < 2e-4 && (a[1] - b[1]).norm() < 2e-4);
    }
    let mut far = squares(0.1);
    assert_eq!(sew(&mut far, &[1e-3]).joined, 0);
    assert_eq!(far.edges.len(), 8);
}

fn loop_ends(brep: &Brep, face: usize) -> Vec<[Point; 2]> {
    brep.faces[face].loops[0]
        .iter()
        .map(|c| {
            let [a, b] = curve::ends(&brep.edges[c.edge]);
            if c.reversed { [b, a] } else { [a, b] }
        })
        .collect()
}

/// A flat or ruled face between four corners, its edges its own; sides may be cut at shares of
/// their length.
fn panel(brep: &mut Brep, name: &str, c: [[f64; 3]; 4], cuts: &[(usize, f64)]) {
    let pole = |p: [f64; 3]| Vector4::new(p[0], p[1], p[2], 1.0);
    let mut one = Vec::new();
    for k in 0..4 {
        let (a, b) = (c[k], c[(k + 1) % 4]);
        let mut stops: Vec<f64> = cuts.iter().filter(|x| x.0 == k).map(|x| x.1).collect();
        stops.insert(0, 0.0);
        stops.push(1.0);
        for w in stops.windows(2) {
            let [p, q] = [w[0], w[1]].map(|s| [0, 1, 2].map(|d| a[d] + s * (b[d] - a[d])));
            let curve = NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points: vec![pole(p), pole(q)] };
            one.push(Coedge { edge: brep.edges.len(), reversed: false });
            brep.edges.push(Edge { curve, t: [0.0, 1.0] });
        }
    }
    let surface = NurbsSurface::bilinear([pole(c[0]), pole(c[3]), pole(c[1]), pole(c[2])]);
    let kind = SurfaceKind::BSpline;
    brep.faces.push(Face { name: name.into(), kind, surface, reversed: false, loops: vec![one] });
}

/// A box of loose faces from (0, 0, 0) to `size`; the top is moved by `off` along x; the side y = 0
/// comes in two halves.
fn loose_box(size: [f64; 3], off: f64) -> Brep {
    let [x, y, z] = size;
    let mut b = Brep::default();
    panel(&mut b, "bottom", [[0., 0., 0.], [0., y, 0.], [x, y, 0.], [x, 0., 0.]], &[]);
    panel(&mut b, "top", [[off, 0., z], [x + off, 0., z], [x + off, y, z], [off, y, z]], &[]);
    panel(&mut b, "left half", [[0., 0., 0.], [x / 3.0, 0., 0.], [x / 3.0, 0., z], [0., 0., z]], &[]);
    panel(&mut b, "right half", [[x / 3.0, 0., 0.], [x, 0., 0.], [x, 0., z], [x / 3.0, 0., z]], &[]);
    panel(&mut b, "back", [[0., y, 0.], [0., y, z], [x, y, z], [x, y, 0.]], &[(1, 0.25), (1, 0.5)]);
    panel(&mut b, "left", [[0., 0., 0.], [0., 0., z], [0., y, z], [0., y, 0.]], &[]);
    panel(&mut b, "right", [[x, 0., 0.], [x, y, 0.], [x, y, z], [x, 0., z]], &[]);
    b
}

/// The volume that the faces enclose once they are turned alike; area and volume of the turned
/// faces themselves must agree with those of their triangles.
fn volume(brep: &Brep) -> Option<f64> {
    let options = crate::geometry::tessellate::TessellateOptions::with_deflection(0.01);
    let t = crate::geometry::tessellate::tessellate(brep, &options, &crate::observe::Silent).unwrap();
    let loops = crate::geometry::exact::measure::Loops::new(&t);
    let (mut brep, mut mesh) = (t.brep, t.mesh);
    crate::read::model::orient::orient(&mut brep, &mut mesh);
    let volume = crate::geometry::mesh::topology(&mesh).closed().then(|| mesh.volume_mm3())?;
    let measured = loops.measure(&brep, &mesh);
    assert!((measured.area_mm2 / mesh.area_mm2() - 1.0).abs() < 1e-2, "{measured:?}");
    assert!((measured.volume_mm3 / volume - 1.0).abs() < 2e-2, "{measured:?}");
    Some(volume)
}

#[test]
fn edges_are_cut_where_others_end() {
    let mut brep = loose_box([6.0, 4.0, 5.0], 0.0);
    let sewn = sew(&mut brep, &[1e-3]);
    // The bottom's and the top's front edges are cut once, the top's rear edge twice.
    assert_eq!((sewn.open, sewn.cut, sewn.gap_mm < 1e-9), (0, 3, true), "{sewn:?}");
    assert!((volume(&brep).unwrap() - 120.0).abs() < 1e-9);
    assert!(sewn.notes().iter().any(|n| n.to_string().starts_with("3 edges were cut")));
}

#[test]
fn coarser_tolerances_are_used_where_edges_stay_open() {
    let mut fine = loose_box([6.0, 4.0, 5.0], 0.015);
    assert!(sew(&mut fine, &[0.005]).open > 0 && volume(&fine).is_none());
    let mut coarse = loose_box([6.0, 4.0, 5.0], 0.015);
    let sewn = sew(&mut coarse, &[0.005, 0.02]);
    assert_eq!(sewn.open, 0, "{sewn:?}");
    assert!((sewn.gap_mm - 0.015).abs() < 1e-9 && (volume(&coarse).unwrap() - 120.0).abs() < 0.5);
}

#[test]
fn faces_given_twice_are_dropped_and_bodies_of_two_faces_are_not() {
    let mut brep = loose_box([6.0, 4.0, 5.0], 0.0);
    panel(&mut brep, "again", [[6., 4., 5.], [6., 0., 5.], [6., 0., 0.], [6., 4., 0.]], &[]);
    let sewn = sew(&mut brep, &[1e-3]);
    assert_eq!(sewn.repeated, [("again".to_owned(), "right".to_owned())]);
    assert_eq!((brep.faces.len(), sewn.open), (7, 0));
    assert!((volume(&brep).unwrap() - 120.0).abs() < 1e-9);
    // Two saddles on the same four lines: the same edges, but room between them.
    let mut lens = Brep::default();
    let c = [[0., 0., 0.], [4., 0., 1.], [4., 4., 0.], [0., 4., 1.]];
    panel(&mut lens, "saddle", c, &[]);
    panel(&mut lens, "roof", c, &[]);
    let raised = Vector4::new(2.0, 2.0, 3.0, 1.0);
    let s = &mut lens.faces[1].surface;
    let middle = |a: usize, b: usize, p: &[Vector4<f64>]| (p[a] + p[b]) * 0.5;
    let p = s.points.clone();
    let row = |a: usize, b: usize| vec![p[a], middle(a, b, &p), p[b]];
    s.points = [row(0, 1), vec![middle(0, 2, &p), raised, middle(1, 3, &p)], row(2, 3)].concat();
    (s.degree_u, s.degree_v, s.n_u, s.n_v) = (2, 2, 3, 3);
    (s.knots_u, s.knots_v) = (vec![0., 0., 0., 1., 1., 1.], vec![0., 0., 0., 1., 1., 1.]);
    let sewn = sew(&mut lens, &[1e-3]);
    assert_eq!((sewn.repeated.len(), sewn.open, lens.faces.len()), (0, 0, 2));
    assert!(volume(&lens).unwrap() > 1.0);
}

#[test]
fn slivers_are_dropped_and_their_neighbours_joined() {
    let mut brep = loose_box([6.0, 4.0, 5.0], 0.0);
    // Between the right side and the bottom, 0.4 µm high.
    let h = 0.0004;
    let right = brep.faces.len() - 1;
    brep.faces.remove(right);
    panel(&mut brep, "right", [[6., 0., h], [6., 4., h], [6., 4., 5.], [6., 0., 5.]], &[]);
    panel(&mut brep, "sliver", [[6., 0., 0.], [6., 4., 0.], [6., 4., h], [6., 0., h]], &[]);
    let sewn = sew(&mut brep, &[1e-3]);
    assert_eq!((sewn.slivers.as_slice(), sewn.open), (["sliver".to_owned()].as_slice(), 0), "{sewn:?}");
    assert!((volume(&brep).unwrap() - 120.0).abs() < 0.01);
    // Ten times the tolerance is a face.
    let mut brep = loose_box([6.0, 4.0, 5.0], 0.0);
    panel(&mut brep, "strip", [[9., 0., 0.], [9., 4., 0.], [9., 4., 0.01], [9., 0., 0.01]], &[]);
    assert!(sew(&mut brep, &[1e-3]).slivers.is_empty());
}

#[test]
fn circles_that_begin_elsewhere_are_joined() {
    // A closed edge against the same one from another begin: both are cut at the other's.
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let ring = |turn: f64| {
        let corners = [(1., 0.), (1., 1.), (0., 1.), (-1., 1.), (-1., 0.), (-1., -1.), (0., -1.), (1., -1.), (1., 0.)];
        let (c, s) = (turn.cos(), turn.sin());
        let points = corners.iter().enumerate().map(|(k, &(x, y))| {
            let w = if k % 2 == 1 { w } else { 1.0 };
            Vector4::new((c * x - s * y) * w, (s * x + c * y) * w, 0.0, w)
        });
        let knots = vec![0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 4.];
        Edge { curve: NurbsCurve { degree: 2, knots, points: points.collect() }, t: [0.0, 4.0] }
    };
    let mut brep = Brep::default();
    let s = 2.0;
    for (k, z) in [0.0, 0.0].into_iter().enumerate() {
        panel(&mut brep, "disc", [[-s, -s, z], [s, -s, z], [s, s, z], [-s, s, z]], &[]);
        brep.edges.push(ring(1.3 * k as f64));
        let edge = brep.edges.len() - 1;
        brep.faces[k].loops = vec![vec![Coedge { edge, reversed: k == 1 }]];
    }
    let found = {
        split::split_at_ends(&mut brep, 1e-3);
        matches(&brep, 1e-3)
    };
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().all(|m| !m.opposite && m.gap_mm < 1e-9));
}
