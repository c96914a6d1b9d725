//! Model files to a [`Blade`]: reading, units, healing, recognition.
//!
//! In: a STEP, IGES, OBJ, STL, PLY or glTF file. Out: the whole part in the blade frame in mm, the blade frame, the regions, and a
//! diagnosis. Formats are told apart by content first ([`mod@format`]); each reader gives either exact faces or loose
//! triangles, and everything after that is common, so a further format is one file and one arm of a `match`.
//!
//! Guarantees: a mesh that is returned is closed and wound outward; a damaged file is an error of kind `InputOutput`
//! with a sentence that says what and where, never a panic. Limits: one blade per file; open meshes are refused.

pub mod format;
pub mod gltf;
pub mod iges;
pub mod inspect;
pub mod obj;
pub mod orient;
pub mod ply;
pub mod recognise;
pub mod sew;
pub mod soup;
pub mod step;
pub mod stl;
pub mod units;
pub mod wind;

#[cfg(test)]
mod mesh_tests;
#[cfg(test)]
mod sample;
#[cfg(test)]
mod step_tests;
#[cfg(test)]
mod tests;

use std::path::Path;

use crate::artifact::blade::{Blade, Diagnosis, Unit};
use crate::error::{Error, Result, Stage};
use crate::geometry::brep::{Brep, SurfaceKind};
use crate::geometry::mesh::{Topology, topology};
use crate::geometry::part::Part;
use crate::geometry::{Aabb, Point};
use crate::observe::{Observer, Warning};

use format::Format;
pub use inspect::inspect_text;
use soup::Soup;
use step::StepShape;

/// Faces that do not share their edges are joined where the edges are this near to each other, mm: a few times the
/// precision that CAD systems write, far below what a cutter leaves.
const SEW_MM: f64 = 0.005;

/// What the user may say about a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelOptions {
    /// Length unit of the file; `None`: as the file says, mm where it says nothing.
    pub unit: Option<Unit>,
    /// Blade axis from root to tip, any length, model frame; `None`: found.
    pub axis: Option<[f64; 3]>,
    /// Greatest distance between exact faces and the mesh made of them, mm.
    pub deflection_mm: f64,
}

impl Default for ModelOptions {
    fn default() -> Self {
        // A hundredth is well below usual form tolerances and keeps a blade at some 100 000 triangles; contact and
        // distance are refined on the exact faces anyway.
        ModelOptions { unit: None, axis: None, deflection_mm: 0.01 }
    }
}

/// Reads a model.
///
/// # Errors
/// `InputOutput`: the file is missing, empty, damaged, of unknown format, holds no body, or is open; its size can be no
/// blade's. `Usage`: a deflection or axis that makes no sense.
pub fn load(path: &Path, options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    if !(options.deflection_mm > 0.0 && options.deflection_mm.is_finite()) {
        return Err(Error::usage(
            Stage::Model,
            format!("deflection {} mm is not greater than 0", options.deflection_mm),
        ));
    }
    let bytes = std::fs::read(path)
        .map_err(|e| Error::io(Stage::Model, format!("{} cannot be read: {e}", path.display())).caused_by(e))?;
    observer.check(Stage::Model)?;
    observer.progress(Stage::Model, 0, 3);
    let blade = match format::detect(path, &bytes)? {
        Format::StlBinary => from_soup(path, stl::read_binary(path, &bytes)?, options, observer),
        Format::StlAscii => from_soup(path, stl::read_ascii(path, &bytes)?, options, observer),
        Format::Obj => from_soup(path, obj::read(path, &bytes)?, options, observer),
        Format::Ply => from_soup(path, ply::read(path, &bytes)?, options, observer),
        Format::Gltf => from_soup(path, gltf::read(path, &bytes)?, options, observer),
        Format::Step => from_step(path, step::read(path, &bytes, options.unit)?, options, observer),
        Format::Iges => from_step(path, iges::read(path, &bytes, options.unit)?, options, observer),
    }?;
    for note in &blade.diagnosis.notes {
        observer.warn(Warning { stage: Stage::Model, message: note.clone() });
    }
    observer.progress(Stage::Model, 3, 3);
    Ok(blade)
}

/// Exact faces to a blade.
fn from_step(path: &Path, mut shape: StepShape, options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    let sewn = sew::sew(&mut shape.brep, SEW_MM);
    let mut diagnosis = Diagnosis {
        format: shape.format,
        unit_reason: shape.unit_reason,
        bodies: shape.bodies,
        faces: kinds(&shape.brep),
        notes: shape.notes,
        ..Diagnosis::default()
    };
    if sewn.joined > 0 {
        diagnosis.notes.push(format!(
            "{} edges that faces did not share were joined, at most {:.2e} mm apart",
            sewn.joined, sewn.gap_mm
        ));
    }
    // Before meshing: in a wrong unit the tolerances of the mesh would be wrong too.
    diagnosis.notes.extend(units::check_size(path, edge_box(&shape.brep), shape.unit)?);
    observer.check(Stage::Model)?;
    let part = Part::from_brep(shape.brep.clone(), options.deflection_mm, observer)?;
    observer.progress(Stage::Model, 1, 3);
    refuse_open(path, &topology(&part.mesh))?;
    diagnosis.closed = true;
    let mut mesh = part.mesh;
    diagnosis.notes.extend(orient::orient(&mut shape.brep, &mut mesh));
    let found = recognise::recognise(&mesh, options.axis)?;
    observer.progress(Stage::Model, 2, 3);
    diagnosis.notes.extend(found.doubts);
    // Exact faces and mesh are made again in the blade frame, so that neither carries the rounding of the other's motion.
    let brep = shape.brep.moved(&found.model_from_blade.inverse());
    Ok(Blade {
        name: stem(path),
        unit: shape.unit,
        part: Part::from_brep(brep, options.deflection_mm, observer)?,
        model_from_blade: found.model_from_blade,
        regions: found.regions,
        diagnosis,
    })
}

/// Box around points of all edges; of the poles of all faces where there is no edge (a sphere without trimming).
fn edge_box(brep: &Brep) -> Option<Aabb> {
    let on_edge = |e: &crate::geometry::brep::Edge| {
        [0.0, 0.25, 0.5, 0.75, 1.0].map(|s| e.curve.point(e.t[0] + s * (e.t[1] - e.t[0])))
    };
    let points: Vec<Point> = brep.edges.iter().flat_map(on_edge).collect();
    let poles = || -> Vec<Point> {
        brep.faces.iter().flat_map(|f| &f.surface.points).map(|p| Point::from(p.xyz() / p.w)).collect()
    };
    Aabb::around(&if points.is_empty() { poles() } else { points })
}

/// Refuses a mesh with open edges: distance and clearance to it would be meaningless.
fn refuse_open(path: &Path, found: &Topology) -> Result<()> {
    let Some(m) = found.first_open_edge else { return Ok(()) };
    Err(Error::io(
        Stage::Model,
        format!(
            "{} is not closed: its mesh has {} open edges, the first at ({:.4}, {:.4}, {:.4}) mm",
            path.display(),
            found.open_edges,
            m.x,
            m.y,
            m.z
        ),
    )
    .advise("close the holes in the CAD or mesh program, or export the solid as STEP"))
}

/// Faces by kind, with counts.
fn kinds(brep: &Brep) -> Vec<(String, usize)> {
    let mut counts = std::collections::BTreeMap::new();
    for f in &brep.faces {
        *counts.entry(f.kind).or_insert(0) += 1;
    }
    counts.into_iter().map(|(kind, n)| (kind_name(kind).to_owned(), n)).collect()
}

fn kind_name(kind: SurfaceKind) -> &'static str {
    match kind {
        SurfaceKind::BSpline => "B-spline",
        SurfaceKind::Plane => "plane",
        SurfaceKind::Cylinder => "cylinder",
        SurfaceKind::Cone => "cone",
        SurfaceKind::Sphere => "sphere",
        SurfaceKind::Torus => "torus",
        SurfaceKind::Revolution => "revolution",
        SurfaceKind::Extrusion => "extrusion",
        SurfaceKind::Other => "other",
    }
}

/// Loose triangles to a blade.
fn from_soup(path: &Path, soup: Soup, options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    let (unit, unit_reason) = match (options.unit, soup.unit) {
        (Some(unit), _) => (unit, format!("{}, as told", units::name(unit))),
        (None, Some(unit)) => (unit, format!("{}, as the format says", units::name(unit))),
        (None, None) => (Unit::Mm, "mm, since a mesh file names no unit".to_owned()),
    };
    let mut diagnosis = Diagnosis { format: soup.format.clone(), unit_reason, closed: true, ..Diagnosis::default() };
    diagnosis.faces = vec![("groups".into(), soup.groups.len())];
    let healed = soup.heal(path, unit.mm())?;
    observer.check(Stage::Model)?;
    observer.progress(Stage::Model, 1, 3);
    diagnosis.bodies = healed.bodies;
    diagnosis.notes = healed.notes;
    diagnosis.notes.extend(units::check_size(path, healed.mesh.aabb(), unit)?);
    let found = recognise::recognise(&healed.mesh, options.axis)?;
    diagnosis.notes.extend(found.doubts);
    Ok(Blade {
        name: stem(path),
        unit,
        part: Part::from_mesh(found.mesh),
        model_from_blade: found.model_from_blade,
        regions: found.regions,
        diagnosis,
    })
}

/// The file's name without folder and extension.
fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "blade".to_owned(), |s| s.to_string_lossy().into_owned())
}
