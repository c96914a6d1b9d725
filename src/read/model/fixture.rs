//! Fixtures and stock: closed bodies of which only the triangles matter.

use std::path::Path;

use super::{ModelOptions, survey};
use crate::artifact::Obstacle;
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Rigid;
use crate::geometry::part::Part;
use crate::observe::Observer;

/// Reads a fixture or stock in any format of a model, as a part of triangles alone; mm, in the
/// frame of its file. Without a unit, what the file states, else mm.
///
/// # Errors
/// `InputOutput`: the file cannot be read; the mesh has holes, or its triangles do not wind alike:
/// nobody could say what is inside it.
pub fn fixture(path: &Path, unit: Option<Unit>, observer: &dyn Observer) -> Result<Part> {
    let survey = survey(path, &ModelOptions { unit, ..ModelOptions::default() }, observer)?;
    let d = &survey.diagnosis;
    let name = path.display();
    if let Some(first) = d.openings.first() {
        let [x, y, z] = first.at_mm;
        let holes = if d.openings.len() == 1 { "a hole".into() } else { format!("{} holes", d.openings.len()) };
        return Err(Error::io(
            Stage::Model,
            format!(
                "the mesh {name} has {holes}, the longest of {} edges and {:.3} mm length at ({x:.3}, {y:.3}, {z:.3}) mm: what \
                 is inside it cannot be told",
                first.edges, first.length_mm
            ),
        )
        .advise("export it as a closed solid, or close its holes"));
    }
    if d.inconsistent_edges > 0 {
        return Err(Error::io(
            Stage::Model,
            format!("the mesh {name} has {} edges whose triangles wind against one another", d.inconsistent_edges),
        )
        .advise("export it as a closed solid"));
    }
    // The mesh alone decides; what it lies off exact faces is kept as room.
    let mut part = Part::from_mesh(survey.part.mesh);
    part.deflection_mm = survey.part.deflection_mm;
    Ok(part)
}

/// Reads a fixture, or the stock, and moves it into the blade frame; `room_mm` is what taper and
/// shank, and what the holder must keep clear of it.
///
/// # Errors
/// Those of [`fixture`].
pub fn obstacle(
    path: &Path,
    unit: Option<Unit>,
    stock: bool,
    room_mm: [f64; 2],
    model_from_blade: &Rigid,
    observer: &dyn Observer,
) -> Result<Obstacle> {
    let part = fixture(path, unit, observer)?.moved(&model_from_blade.inverse());
    let file = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    Ok(Obstacle {
        name: format!("{} {file}", if stock { "stock" } else { "fixture" }),
        part,
        clearance_mm: room_mm[0],
        holder_clearance_mm: room_mm[1],
        cut_by_the_tool: stock,
        of_the_wheel: false,
        copies: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::ErrorKind;
    use crate::observe::Silent;

    /// A cube of 10 mm as OBJ, with some of its 12 triangles.
    fn cube(triangles: usize) -> tempfile::NamedTempFile {
        let mut text = String::new();
        for i in 0..8 {
            text.push_str(&format!("v {} {} {}\n", 10 * (i & 1), 10 * (i >> 1 & 1), 10 * (i >> 2)));
        }
        let faces = [
            "1 3 4", "1 4 2", "5 6 8", "5 8 7", "1 2 6", "1 6 5", "3 7 8", "3 8 4", "1 5 7", "1 7 3", "2 4 8", "2 8 6",
        ];
        for f in &faces[..triangles] {
            text.push_str(&format!("f {f}\n"));
        }
        let file = tempfile::Builder::new().suffix(".obj").tempfile().unwrap();
        std::fs::write(file.path(), text).unwrap();
        file
    }

    #[test]
    fn a_closed_cube_is_taken_and_an_open_one_is_not() {
        let whole = fixture(cube(12).path(), Some(Unit::Mm), &Silent).unwrap();
        assert!((whole.mesh.volume_mm3() - 1000.0).abs() < 1e-9);
        let e = fixture(cube(11).path(), Some(Unit::Mm), &Silent).err().unwrap();
        assert_eq!(e.kind, ErrorKind::InputOutput);
        assert!(e.message.contains("a hole, the longest of 3 edges"), "{e}");
    }
}
