//! Model files to a [`Blade`]: reading, units, healing, recognition.
//!
//! In: a STEP, OBJ or STL file. Out: the whole part in the blade frame in mm, the blade frame, the regions, and a
//! diagnosis. Formats are told apart by content first ([`format`]); each reader gives either exact faces or loose
//! triangles, and everything after that is common, so a further format is one file and one arm of a `match`.
//!
//! Guarantees: a mesh that is returned is closed and wound outward; a damaged file is an error of kind `InputOutput`
//! with a sentence that says what and where, never a panic. Limits: one blade per file; open meshes are refused.

pub mod format;
pub mod inspect;
pub mod obj;
pub mod recognise;
pub mod soup;
pub mod step;
pub mod stl;
pub mod topology;
pub mod units;

#[cfg(test)]
mod sample;
#[cfg(test)]
mod tests;

use std::path::Path;

use crate::artifact::blade::{Blade, Diagnosis, Unit};
use crate::error::{Error, Result, Stage};
use crate::geometry::part::Part;
use crate::observe::{Observer, Warning};

use format::Format;
pub use inspect::inspect_text;
use soup::Soup;

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
        Format::Step => {
            Err(Error::io(Stage::Model, "STEP models cannot be read yet").advise("export the model as STL or OBJ"))
        }
    }?;
    for note in &blade.diagnosis.notes {
        observer.warn(Warning { stage: Stage::Model, message: note.clone() });
    }
    observer.progress(Stage::Model, 3, 3);
    Ok(blade)
}

/// Loose triangles to a blade.
fn from_soup(path: &Path, soup: Soup, options: &ModelOptions, observer: &dyn Observer) -> Result<Blade> {
    let (unit, unit_reason) = match options.unit {
        Some(unit) => (unit, format!("{}, as told", units::name(unit))),
        None => (Unit::Mm, "mm, since a mesh file names no unit".to_owned()),
    };
    let mut diagnosis = Diagnosis { format: soup.format.clone(), unit_reason, closed: true, ..Diagnosis::default() };
    diagnosis.faces = vec![("groups".into(), soup.groups.len())];
    let healed = soup.heal(path, unit.mm())?;
    observer.check(Stage::Model)?;
    observer.progress(Stage::Model, 1, 3);
    diagnosis.bodies = healed.bodies;
    diagnosis.notes = healed.notes;
    diagnosis.notes.extend(units::check_size(path, &healed.mesh, unit)?);
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
