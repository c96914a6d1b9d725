//! Model files to a [`Blade`]: reading, units, healing, recognition.
//!
//! In: a STEP, IGES, OBJ, STL, PLY or glTF file, or a table of sections. Out: the whole part in the
//! blade frame in mm, the blade frame, the regions, and a diagnosis. Formats are told apart by
//! content first ([`mod@format`]); each reader gives either exact faces or loose triangles, and
//! everything after that is common, so a further format is one file and one arm of a `match`.
//!
//! [`survey()`] says what is in a file whatever its state; [`load`] goes on to a blade for
//! planning.
//!
//! Guarantees: neighbouring triangles of a mesh wind alike, closed pieces outward; a damaged file
//! is an error of kind `InputOutput` with a sentence that says what and where, never a panic.
//! Limits: one blade per file. An open part is read; [`openings::check`] decides whether an opening
//! matters for the tool.

pub mod bodies;
pub mod faces;
mod fixture;
mod folds;
pub mod format;
pub mod gltf;
pub mod heal;
pub mod iges;
pub mod inspect;
pub mod obj;
pub mod openings;
pub mod orient;
pub mod ply;
pub mod published;
pub mod recognise;
pub mod rescue;
pub mod sew;
pub mod soup;
pub mod step;
pub mod stl;
pub mod survey;
pub mod table;
pub mod units;
pub mod wind;

#[cfg(test)]
mod mesh_tests;
#[cfg(test)]
mod sample;
#[cfg(test)]
mod step_edge_tests;
#[cfg(test)]
mod step_tests;
#[cfg(test)]
mod tests;

use std::path::Path;

use crate::artifact::blade::{Blade, Unit};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::geometry::brep::{Brep, SurfaceKind};
use crate::geometry::{Aabb, Point};
use crate::observe::{Doubt, Observer, Warning};

pub use fixture::{fixture, obstacle};
use format::Format;
pub use inspect::{inspect_json, inspect_text, region_json};
pub use survey::Survey;

/// Faces that do not share their edges are joined where the edges are this near to each other, mm:
/// a few times the precision that CAD systems write, far below what a cutter leaves; then, where
/// edges are still open, as near as vertices of a loop may be.
const SEW_MM: [f64; 2] = [0.005, 0.02];

/// What the user may say about a model.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelOptions {
    /// Length unit of the file; `None`: as the file says, mm where it says nothing.
    pub unit: Option<Unit>,
    /// Blade axis from root to tip, any length, model frame; `None`: found.
    pub axis: Option<[f64; 3]>,
    /// The body to look for the blade on, from 1, as [`bodies`] numbers them; `None`: all of the
    /// part.
    pub body: Option<u32>,
    /// Greatest distance between exact faces and the mesh made of them, mm; more for parts of some
    /// metres.
    pub deflection_mm: f64,
    /// Vertices of a mesh this near to one another are the same, mm; `None`: found.
    pub weld_mm: Option<f64>,
    /// Holes of a mesh up to this extent are closed, mm; `None`: none. Openings between exact faces
    /// stay, and that is noted.
    pub close_holes_mm: Option<f64>,
    /// Heights between which the airfoil lies, mm along the blade axis; `None`: found.
    pub airfoil_mm: Option<[f64; 2]>,
    /// Height of the platform's top, mm along the blade axis; `None`: found.
    pub platform_mm: Option<f64>,
    /// Faces of the airfoil, by number (from 1) or name; empty: found.
    pub airfoil_faces: Vec<String>,
    /// Faces of the platform's top, by number (from 1) or name; empty: found.
    pub platform_faces: Vec<String>,
}

impl ModelOptions {
    /// Whether the user says what is the airfoil, so that nothing else is to be doubted.
    pub fn names_airfoil(&self) -> bool {
        self.axis.is_some() || self.airfoil_mm.is_some() || !self.airfoil_faces.is_empty()
    }
}

impl Default for ModelOptions {
    fn default() -> Self {
        // A hundredth is well below usual form tolerances and keeps a blade at some 100 000
        // triangles; contact and distance are refined on the exact faces anyway.
        ModelOptions {
            unit: None,
            axis: None,
            body: None,
            deflection_mm: 0.01,
            weld_mm: None,
            close_holes_mm: None,
            airfoil_mm: None,
            platform_mm: None,
            airfoil_faces: Vec::new(),
            platform_faces: Vec::new(),
        }
    }
}

/// Reads a model for planning. What the openings of a part mean for the tool is asked later, where
/// the tool is known ([`openings::check`]).
///
/// # Errors
/// Those of [`survey()`]. `InputOutput`: no blade was recognised; the size can be no blade's; the
/// part has no volume.
pub fn load(path: &Path, options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    load_bytes(path, &file_bytes(path)?, options, observer)
}

/// As [`load`], from the bytes of the file.
///
/// # Errors
/// As [`load`].
pub fn load_bytes(path: &Path, bytes: &[u8], options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    let blade = survey_bytes(path, bytes, options, observer)?.into_blade(observer)?;
    for note in &blade.diagnosis.notes {
        observer.warn(Warning { stage: Stage::Model, doubt: Doubt::Model(note.clone()) });
    }
    Ok(blade)
}

/// Reads a model and says what is in it, whatever its state.
///
/// # Errors
/// `InputOutput`: the file is missing, empty, damaged, of unknown format, or holds no body.
/// `Usage`: a deflection or axis that makes no sense.
pub fn survey(path: &Path, options: &ModelOptions, observer: &dyn Observer) -> Result<Survey> {
    survey_bytes(path, &file_bytes(path)?, options, observer)
}

/// All bytes of a model file.
///
/// # Errors
/// `InputOutput`: it cannot be read.
pub fn file_bytes(path: &Path) -> Result<Vec<u8>> {
    files::read(path, files::LONG)
        .map_err(|e| Error::io(Stage::Model, format!("{} cannot be read: {e}", path.display())).caused_by(e))
}

/// As [`survey()`], from the bytes of the file; its name decides where the bytes leave the format
/// open.
///
/// # Errors
/// As [`survey()`].
pub fn survey_bytes(path: &Path, bytes: &[u8], options: &ModelOptions, observer: &dyn Observer) -> Result<Survey> {
    if !(options.deflection_mm > 0.0 && options.deflection_mm.is_finite()) {
        return Err(Error::usage(
            Stage::Model,
            format!("deflection {} mm is not greater than 0", options.deflection_mm),
        ));
    }
    observer.check(Stage::Model)?;
    observer.progress(Stage::Model, 0, 3);
    let bytes = format::without_mark(bytes);
    let survey = match format::detect(path, bytes)? {
        Format::StlBinary => survey::from_soup(path, stl::read_binary(path, bytes)?, options, observer),
        Format::StlAscii => survey::from_soup(path, stl::read_ascii(path, bytes)?, options, observer),
        Format::Obj => survey::from_soup(path, obj::read(path, bytes)?, options, observer),
        Format::Step => survey::from_faces(path, step::read(path, bytes, options.unit)?, options, observer),
        Format::Ply => survey::from_soup(path, ply::read(path, bytes)?, options, observer),
        Format::Gltf => survey::from_soup(path, gltf::read(path, bytes)?, options, observer),
        Format::Iges => survey::from_faces(path, iges::read(path, bytes, options.unit)?, options, observer),
        Format::Sections => survey::from_faces(path, table::read(path, bytes, options.unit)?, options, observer),
    }?;
    observer.progress(Stage::Model, 3, 3);
    Ok(survey)
}

/// Box around points of all edges; of the poles of all faces where there is no edge (a sphere
/// without trimming).
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

/// The file's name without folder and extension.
fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "blade".to_owned(), |s| s.to_string_lossy().into_owned())
}
