#![allow(clippy::unwrap_used)]
use crate::geometry::brep::{Brep, Face, SurfaceKind};
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{sphere, torus};
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::observe::Silent;

/// A part of one face without loops.
fn part(surface: NurbsSurface, deflection_mm: f64) -> Part {
    let face = Face { name: "face 1".into(), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
    Part::from_brep(Brep { faces: vec![face], edges: vec![] }, deflection_mm, &Silent).unwrap()
}

/// Points in a cube of this half side, in a fixed order (a linear congruential generator).
fn points(half: f64, count: usize) -> impl Iterator<Item = Point> {
    let mut state = 12345u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0) * half
    };
    (0..count).map(move |_| Point::new(next(), next(), next()))
}

#[test]
fn sphere_and_torus_in_closed_form() {
    let ball = part(sphere(10.0), 0.02);
    for q in points(16.0, 2000) {
        let c = ball.closest(&q, f64::INFINITY).unwrap();
        assert!((c.distance_mm - (q.coords.norm() - 10.0).abs()).abs() < 1e-9, "{q}: {}", c.distance_mm);
        assert!((c.normal - c.point.coords / 10.0).norm() < 1e-6);
    }
    let ring = part(torus(10.0, 3.0), 0.02);
    for q in points(16.0, 2000) {
        let c = ring.closest(&q, f64::INFINITY).unwrap();
        let exact = ((q.x.hypot(q.y) - 10.0).hypot(q.z) - 3.0).abs();
        assert!((c.distance_mm - exact).abs() < 1e-9, "{q}: {} {exact}", c.distance_mm);
        let tube = q - Vector::new(q.x, q.y, 0.0).normalize() * 10.0;
        assert!((c.normal - tube.coords.normalize()).norm() < 1e-6);
    }
}
