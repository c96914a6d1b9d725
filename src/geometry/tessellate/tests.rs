#![allow(clippy::unwrap_used)]
use super::*;
use crate::geometry::brep::{Brep, Face, SurfaceKind};
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::shapes::{sphere, torus};
use crate::observe::Silent;

fn one_face(surface: NurbsSurface) -> Brep {
    let face = Face { name: "face 1".into(), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
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
