//! IGES 5.3 (and what older versions share with it) to one B-rep in mm.
//!
//! In: the text of a file. Out: a [`FaceModel`], as from STEP: every solid (186), shell (514),
//! trimmed or bounded face (144, 143, bounded 108), subfigure instance (408, 430) and bare surface
//! becomes faces of one [`Brep`](crate::geometry::brep::Brep). Faces of solids share their edges;
//! loose ones do not and are joined by [`super::sew`].
//!
//! * [`text`]: lines, sections, free-format parameters. [`file`](mod@file): global section,
//!   directory, transforms.
//! * [`curves`], [`surfaces`]: geometry as NURBS, exact; [`param`] keeps track of how the file's
//!   parameters run.
//! * [`trims`], [`solids`]: faces with their loops. Curves in space are preferred; those in the
//!   parameter plane are carried through the surface, within [`fit::FIT_MM`].
//! * [`bodies`]: which entities are bodies, and where; [`build`]: the B-rep as it grows.
//!
//! Guarantees: a damaged file is an error that names the entity by its directory line; memory stays
//! in proportion to the file's size. Limits: offset curves and surfaces (130, 140),
//! parametric-spline surfaces of other than cubic form, CSG and the compressed and binary forms of
//! IGES are refused; annotation, colours, names and properties are passed over.

pub mod bodies;
pub mod build;
pub mod curves;
pub mod file;
pub mod fit;
pub mod param;
pub mod solids;
pub mod surfaces;
pub mod text;
pub mod trims;

use std::path::Path;

use nalgebra::Matrix4;

use super::faces::FaceModel;
use super::units::UnitSource;
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::observe::Remark;
use build::Build;
use file::{File, Global};

/// Reads an IGES file.
///
/// # Errors
/// `InputOutput`: not IGES, cut off, no faces, entities that cannot be read.
pub fn read(path: &Path, bytes: &[u8], unit: Option<Unit>) -> Result<FaceModel> {
    let file = File::new(path, bytes)?;
    let told = unit.is_some();
    let (unit, mm, unit_reason) = length_unit(&file.global, unit).map_err(|m| {
        Error::io(Stage::Model, format!("{}: {m}", path.display())).advise("pass --unit mm, cm, m or inch")
    })?;
    let mut build = Build::new(&file);
    let mut notes = bodies::build_all(&mut build, &Matrix4::new_scaling(mm))?;
    if build.brep.faces.is_empty() {
        let curves = file.entities.iter().filter(|e| matches!(e.kind, 100..=112 | 126) && !e.subordinate).count();
        return Err(Error::io(
            Stage::Model,
            format!("{} holds no solid, shell or face, only {curves} free curves", path.display()),
        )
        .advise("export the blade's surfaces or solid, not a wire frame or a drawing"));
    }
    if file.global.scale != 1.0 && unit_reason.ends_with("as the file says") {
        notes.push(Remark::ScaleUndone { scale: file.global.scale });
    }
    let version = match file.global.version {
        v @ 6..=8 => format!("IGES {}.0", v - 2),
        9 => "IGES 5.1".to_owned(),
        10 => "IGES 5.2".to_owned(),
        11 => "IGES 5.3".to_owned(),
        _ => "IGES".to_owned(),
    };
    let unit_source = if told { UnitSource::Told } else { UnitSource::Declared };
    Ok(FaceModel {
        brep: build.brep,
        bodies: build.bodies,
        format: version,
        unit,
        unit_reason,
        unit_source,
        notes,
        stacking: None,
    })
}

/// The unit of coordinates: (unit, mm per file unit, reason).
fn length_unit(global: &Global, told: Option<Unit>) -> std::result::Result<(Unit, f64, String), String> {
    let (name, mm) = declared(global)?;
    if let Some(unit) = told {
        return Ok((unit, unit.mm(), format!("{}, as told (the file says {name})", super::units::name(unit))));
    }
    let mm = mm.ok_or_else(|| format!("its unit is named \"{name}\", which is not known"))? / global.scale;
    if !(mm > 0.0 && mm.is_finite()) {
        return Err(format!("its model scale {} makes no sense", global.scale));
    }
    let known = [Unit::Mm, Unit::Cm, Unit::M, Unit::Inch].into_iter().find(|u| (u.mm() / mm - 1.0).abs() < 1e-9);
    Ok(match known {
        Some(unit) => (unit, unit.mm(), format!("{}, as the file says", super::units::name(unit))),
        None => (Unit::Mm, mm, format!("mm, converted from the file's {name} ({mm} mm)")),
    })
}

/// Name of the declared unit and its mm, if it is known.
fn declared(global: &Global) -> std::result::Result<(String, Option<f64>), String> {
    const NAMES: [(&str, f64); 10] = [
        ("inch", 25.4),
        ("mm", 1.0),
        ("foot", 304.8),
        ("mile", 1_609_344.0),
        ("m", 1000.0),
        ("km", 1e6),
        ("mil", 0.0254),
        ("micron", 1e-3),
        ("cm", 10.0),
        ("microinch", 2.54e-5),
    ];
    let at = match global.unit_flag {
        flag @ 1..=2 => flag as usize - 1,
        flag @ 4..=11 => flag as usize - 2,
        3 => {
            let name = global.unit_name.to_lowercase();
            let also = match name.as_str() {
                "in" | "inches" => "inch",
                "millimeter" | "millimetre" | "millimeters" | "millimetres" => "mm",
                "ft" | "feet" => "foot",
                "mi" | "miles" => "mile",
                "meter" | "metre" | "meters" | "metres" => "m",
                "centimeter" | "centimetre" => "cm",
                "um" => "micron",
                "uin" => "microinch",
                other => other,
            };
            let known = NAMES.iter().find(|(n, _)| *n == also).map(|(_, mm)| *mm);
            return Ok((global.unit_name.clone(), known));
        }
        other => return Err(format!("its unit flag {other} is not one of 1 to 11")),
    };
    Ok((NAMES[at].0.to_owned(), Some(NAMES[at].1)))
}

#[cfg(test)]
mod tests;
