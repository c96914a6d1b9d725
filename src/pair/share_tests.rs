#![allow(clippy::unwrap_used)]
use std::f64::consts::{PI, TAU};

use super::*;
use crate::geometry::mesh::Mesh;
use crate::observe::Silent;

/// A closed elliptic cylinder about z as a mesh; its caps come last.
fn tube(a: f64, b: f64, length: f64) -> (Mesh, Vec<Area>) {
    let n = 720u32;
    let ring = |z: f64| {
        (0..n).map(move |k| {
            let (s, c) = (TAU * f64::from(k) / f64::from(n)).sin_cos();
            Point::new(a * c, b * s, z)
        })
    };
    let mut mesh = Mesh { points: ring(0.0).chain(ring(length)).collect(), ..Mesh::default() };
    let mut areas = Vec::new();
    for k in 0..n {
        let l = (k + 1) % n;
        mesh.triangles.extend([[k, l, n + l], [k, n + l, n + k]]);
        areas.extend([Area::Airfoil; 2]);
    }
    for k in 1..n - 1 {
        mesh.triangles.extend([[0, k + 1, k], [n, n + k, n + k + 1]]);
        areas.extend([Area::Tip; 2]);
    }
    (mesh, areas)
}

#[test]
fn the_share_of_an_ellipse_is_that_of_its_flat_sides() {
    let (a, b) = (10.0, 2.0);
    let (mesh, areas) = tube(a, b, 400.0);
    let part = Part::from_mesh(mesh);
    let found = share(&part, &areas, 2.0 * a, &Silent).unwrap();
    // By arc length, where the normal is within half of the angle of the short axis.
    let steps = 100_000;
    let (mut whole, mut flat) = (0.0, 0.0);
    for k in 0..steps {
        let (s, c) = (PI * (f64::from(k) + 0.5) / f64::from(steps)).sin_cos();
        let length = (a * s).hypot(b * c);
        let slope = (c / a).atan2(s / b).abs();
        whole += length;
        flat += if slope <= 0.5 * HOLDS_DEG.to_radians() { length } else { 0.0 };
    }
    let exact = flat / whole;
    assert!((found.holds - exact).abs() < 0.02, "{found:?}, exactly {exact}");
    assert!((found.thickness_mm[2] - 2.0 * b).abs() < 0.02 && found.elsewhere < 0.02, "{found:?}");
    assert!((found.holds + found.wedge + found.elsewhere + found.none - 1.0).abs() < 1e-12);
    assert!((found.thickness_over_chord - found.thickness_mm[1] / 20.0).abs() < 1e-12);
}

#[test]
fn what_has_no_inside_is_refused() {
    let (mesh, areas) = tube(10.0, 2.0, 100.0);
    let mut open = mesh.clone();
    open.triangles.pop();
    let e = share(&Part::from_mesh(open), &areas, 20.0, &Silent).unwrap_err();
    assert!(e.message.contains("it has no inside"), "{e}");
    let mut turned = mesh.clone();
    turned.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let e = share(&Part::from_mesh(turned), &areas, 20.0, &Silent).unwrap_err();
    assert!(e.message.contains("inside out"), "{e}");
    let none = vec![Area::Other; areas.len()];
    let e = share(&Part::from_mesh(mesh), &none, 20.0, &Silent).unwrap_err();
    assert!(e.message.contains("no airfoil was found"), "{e}");
}
