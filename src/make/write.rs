//! A made blade as STEP (AP242) and OBJ text, and as files.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use step_io::build::{CurveInput, FaceBoundInput, SurfaceInput};
use step_io::{AuthorError, Orientation, StepBuilder, scene};

use super::MadeBlade;
use crate::error::{Error, Result, Stage};
use crate::geometry::brep::Coedge;
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};

/// The same design gives the same file, byte for byte: no clock in the header.
const TIME_STAMP: &str = "1970-01-01T00:00:00Z";

pub(super) fn curve(c: &NurbsCurve) -> scene::NurbsCurve {
    scene::NurbsCurve {
        degree: c.degree,
        control_points: c.points.iter().map(|p| [p.x / p.w, p.y / p.w, p.z / p.w]).collect(),
        weights: c.points.iter().map(|p| p.w).collect(),
        knots: c.knots.clone(),
    }
}

pub(super) fn surface(s: &NurbsSurface) -> scene::NurbsSurface {
    let rows = || s.points.chunks_exact(s.n_v);
    scene::NurbsSurface {
        degree_u: s.degree_u,
        degree_v: s.degree_v,
        control_points: rows().map(|r| r.iter().map(|p| [p.x / p.w, p.y / p.w, p.z / p.w]).collect()).collect(),
        weights: rows().map(|r| r.iter().map(|p| p.w).collect()).collect(),
        knots_u: s.knots_u.clone(),
        knots_v: s.knots_v.clone(),
    }
}

fn refused(e: AuthorError) -> Error {
    Error::io(Stage::Make, "the blade cannot be written as STEP").caused_by(e)
}

/// The blade as STEP: AP242, millimetres, one manifold solid of NURBS faces.
pub fn step_text(blade: &MadeBlade) -> Result<String> {
    let mut b = StepBuilder::new();
    let header = b.header_mut();
    header.file_name = format!("{}.step", blade.name);
    header.descriptions = vec![format!("{}, made by bladewright", blade.name)];
    header.time_stamp = TIME_STAMP.into();
    header.originating_system = concat!("bladewright ", env!("CARGO_PKG_VERSION")).into();
    let part = b.part(&blade.name);
    let vertices = blade
        .vertices
        .iter()
        .map(|p| b.vertex([p.x, p.y, p.z]))
        .collect::<std::result::Result<Vec<_>, _>>()
        .map_err(refused)?;
    let mut edges = Vec::with_capacity(blade.brep.edges.len());
    for (e, [from, to]) in blade.brep.edges.iter().zip(&blade.edge_ends) {
        edges.push(b.edge(vertices[*from], vertices[*to], CurveInput::Nurbs(curve(&e.curve))).map_err(refused)?);
    }
    let mut faces = Vec::with_capacity(blade.brep.faces.len());
    for f in &blade.brep.faces {
        let bound = |(k, l): (usize, &Vec<Coedge>)| {
            let sense = |c: &Coedge| if c.reversed { Orientation::Reversed } else { Orientation::Forward };
            let walk = l.iter().map(|c| (edges[c.edge], sense(c))).collect();
            if k == 0 { FaceBoundInput::outer(walk) } else { FaceBoundInput::inner(walk) }
        };
        let bounds = f.loops.iter().enumerate().map(bound).collect();
        let sense = if f.reversed { Orientation::Reversed } else { Orientation::Forward };
        faces.push(b.face(SurfaceInput::Nurbs(surface(&f.surface)), sense, bounds).map_err(refused)?);
    }
    b.solid(part, &blade.name, faces).map_err(refused)?;
    let mut out = Vec::new();
    step_io::write(&b.finish(), &mut out)
        .map_err(|e| Error::io(Stage::Make, "the blade cannot be written as STEP").caused_by(e))?;
    String::from_utf8(out).map_err(|e| Error::io(Stage::Make, "the STEP text is not ASCII").caused_by(e))
}

/// The blade's mesh as OBJ: millimetres, one group for every face.
pub fn obj_text(blade: &MadeBlade) -> String {
    let mut s = String::new();
    let mesh = &blade.mesh;
    // Writing to a String cannot fail.
    let _ = writeln!(s, "# {}, made by bladewright {}", blade.name, env!("CARGO_PKG_VERSION"));
    let _ = writeln!(
        s,
        "# unit: millimetre; {} points on the exact surfaces, {} triangles at most {:.4} mm from them",
        mesh.points.len(),
        mesh.triangles.len(),
        blade.deflection_mm
    );
    let _ = writeln!(s, "o {}", blade.name.replace(' ', "_"));
    for p in &mesh.points {
        // 1e-7 mm; adding zero turns -0 into 0.
        let [x, y, z] = [p.x, p.y, p.z].map(|c| (c * 1e7).round() / 1e7 + 0.0);
        let _ = writeln!(s, "v {x} {y} {z}");
    }
    let mut of_face: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
    for (t, corners) in mesh.triangles.iter().enumerate() {
        of_face.entry(mesh.face(t)).or_default().push(*corners);
    }
    for (face, triangles) in of_face {
        let name = blade.brep.faces.get(face as usize).map_or("face", |f| f.name.own());
        let _ = writeln!(s, "g {}", name.replace(' ', "_"));
        for [a, b, c] in triangles {
            let _ = writeln!(s, "f {} {} {}", a + 1, b + 1, c + 1);
        }
    }
    s
}
