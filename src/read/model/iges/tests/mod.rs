//! IGES files written by hand against closed forms; damaged ones.
#![allow(clippy::unwrap_used)]

mod damage;
mod shapes;
mod sheet;
mod units;

use std::path::Path;

use super::*;
use crate::geometry::brep::Brep;
use crate::geometry::mesh::{Mesh, topology};
use crate::geometry::tessellate::{TessellateOptions, tessellate};
use crate::observe::Silent;
use crate::read::model::sew::Sewn;
use crate::read::model::{orient, sew};

/// A file's shape.
fn shape(text: &str) -> Result<FaceModel> {
    read(Path::new("test.igs"), text.as_bytes(), None)
}

/// A part read, sewn, meshed and oriented.
struct Solid {
    brep: Brep,
    mesh: Mesh,
    sewn: Sewn,
}

/// Reads a file that must make a closed part; the mesh deviates by at most `deflection_mm`.
fn solid(text: &str, deflection_mm: f64) -> Solid {
    let mut brep = shape(text).unwrap().brep;
    let sewn = sew::sew(&mut brep, &[0.001]);
    let mut mesh = tessellate(&brep, &TessellateOptions::with_deflection(deflection_mm), &Silent).unwrap().mesh;
    orient::orient(&mut brep, &mut mesh);
    let t = topology(&mesh);
    assert!(t.closed(), "{t:?} {sewn:?}");
    Solid { brep, mesh, sewn }
}

impl Solid {
    /// Checks volume and area to a relative tolerance.
    fn measures(&self, volume_mm3: f64, area_mm2: f64, tolerance: f64) {
        let (v, a) = (self.mesh.volume_mm3() / volume_mm3 - 1.0, self.mesh.area_mm2() / area_mm2 - 1.0);
        assert!(v.abs() < tolerance && a.abs() < tolerance, "volume off by {v:.2e}, area by {a:.2e}");
    }
}
