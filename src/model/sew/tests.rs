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
            name: String::new(),
            kind: SurfaceKind::Plane,
            surface: NurbsSurface {
                degree_u: 1,
                degree_v: 1,
                knots_u: vec![0.0, 0.0, 1.0, 1.0],
                knots_v: vec![0.0, 0.0, 1.0, 1.0],
                n_u: 2,
                n_v: 2,
                points: vec![point(x, 0.0), point(x, 1.0), point(x + 1.0, 0.0), point(x + 1.0, 1.0)],
            },
            reversed: false,
            loops: vec![(first..first + 4).map(|edge| Coedge { edge, reversed: false }).collect()],
        });
    }
    brep
}

#[test]
fn coinciding_edges_are_joined_once() {
    let mut brep = squares(1e-4);
    let before: Vec<[Point; 2]> = loop_curve::ends(&brep, 1);
    let sewn = sew(&mut brep, &[1e-3]);
    assert_eq!((sewn.joined, sewn.open, brep.edges.len()), (1, 6, 7));
    assert!((sewn.gap_mm - 1e-4).abs() < 1e-9);
    // The second face's loop still runs through the same corners.
    for (a, b) in before.iter().zip(loop_curve::ends(&brep, 1)) {
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
