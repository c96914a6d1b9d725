#![allow(clippy::unwrap_used)]
use std::f64::consts::TAU;

use super::*;
use crate::geometry::brep::{Brep, Coedge, Edge, Face, FaceName, SurfaceKind};
use crate::geometry::nurbs::shapes::{cylinder, sphere, torus};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::observe::Silent;

fn one_face(surface: NurbsSurface) -> Brep {
    let face =
        Face { name: FaceName::Numbered(1), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
    Brep { faces: vec![face], edges: vec![] }
}

#[test]
fn sphere_and_torus_without_loops() {
    for (s, volume, area) in [
        (sphere(10.0), 4.0 / 3.0 * std::f64::consts::PI * 1000.0, 400.0 * std::f64::consts::PI),
        (torus(10.0, 3.0), 2.0 * std::f64::consts::PI.powi(2) * 90.0, 4.0 * std::f64::consts::PI.powi(2) * 30.0),
    ] {
        let t = tessellate(&one_face(s), &TessellateOptions::with_deflection(0.005), &Silent).unwrap();
        assert!(t.deflection_mm < 0.01, "{}", t.deflection_mm);
        assert!((t.mesh.volume_mm3() / volume - 1.0).abs() < 2e-3, "{} {volume}", t.mesh.volume_mm3());
        assert!((t.mesh.area_mm2() / area - 1.0).abs() < 2e-3);
        let topology = crate::geometry::mesh::topology(&t.mesh);
        assert_eq!(
            (topology.open_edges, topology.nonmanifold_edges, topology.inconsistent_edges, topology.components),
            (0, 0, 0, 1)
        );
    }
}

/// An edge along straight pieces.
fn polyline(points: &[Point]) -> Edge {
    let n = points.len();
    let knots = std::iter::once(0).chain(0..n).chain([n - 1]).map(|k| k as f64).collect();
    let points = points.iter().map(|p| p.to_homogeneous()).collect();
    Edge { curve: NurbsCurve { degree: 1, knots, points }, t: [0.0, (n - 1) as f64] }
}

/// A hole is cut out wherever the outer loop begins and whichever way it runs: loops are unrolled
/// one by one, and the outer one may lie a period beside the hole.
#[test]
fn a_hole_in_a_full_cylinder_is_cut_out() {
    const RADIUS: f64 = 5.0;
    const HEIGHT: f64 = 10.0;
    let at = |angle: f64, z: f64| Point::new(RADIUS * angle.cos(), RADIUS * angle.sin(), z);
    let circle = |z: f64| polyline(&(0..=360).map(|k| at(f64::from(k % 360).to_radians(), z)).collect::<Vec<_>>());
    let hole = |middle: f64| {
        let corner = |k: u32| {
            let (s, c) = (TAU * f64::from(k % 64) / 64.0).sin_cos();
            at(middle + 0.4 * c, 5.0 + 2.0 * s)
        };
        polyline(&(0..=64).map(corner).collect::<Vec<_>>())
    };
    let full = TAU * RADIUS * HEIGHT;
    let cut = std::f64::consts::PI * 0.4 * RADIUS * 2.0;
    let coedge = |edge: usize, reversed: bool| Coedge { edge, reversed };
    for (middle, start) in [0.6, 2.0, 4.0, 5.7].into_iter().flat_map(|m| (0..4).map(move |k| (m, k))) {
        let mut outer = vec![coedge(0, false), coedge(1, false), coedge(2, true), coedge(1, true)];
        outer.rotate_left(start);
        let loops = vec![outer, vec![coedge(3, false)]];
        let face = Face { loops, ..one_face(cylinder(RADIUS, HEIGHT)).faces.remove(0) };
        let edges = vec![circle(0.0), polyline(&[at(0.0, 0.0), at(0.0, HEIGHT)]), circle(HEIGHT), hole(middle)];
        let t = tessellate(&Brep { faces: vec![face], edges }, &TessellateOptions::with_deflection(0.005), &Silent);
        let t = t.unwrap();
        let area = t.mesh.area_mm2();
        assert!((area / (full - cut) - 1.0).abs() < 5e-3, "{middle} {start}: {area}, {} wanted", full - cut);
        // The exact face ends at the hole's rim too.
        let part = crate::geometry::part::Part::from_brep(t.brep, 0.005, &Silent).unwrap();
        let over = at(middle, 5.0) * 1.1;
        let near = part.closest(&Point::new(over.x, over.y, 5.0), f64::INFINITY).unwrap();
        assert!(near.distance_mm > 1.5, "{middle} {start}: {}", near.distance_mm);
    }
}
