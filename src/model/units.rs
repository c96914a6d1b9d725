//! Units: their names, and whether a part's size can be a blade's.

use std::path::Path;

use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::geometry::Aabb;

/// Sizes (largest side of the box) that blades have, mm: below or above, the unit is probably wrong.
const USUAL_MM: [f64; 2] = [3.0, 5000.0];
/// Sizes for which no plan can make sense, mm.
const POSSIBLE_MM: [f64; 2] = [0.5, 500_000.0];

/// A unit's name, as the command line takes it.
pub fn name(unit: Unit) -> &'static str {
    match unit {
        Unit::Mm => "mm",
        Unit::Cm => "cm",
        Unit::M => "m",
        Unit::Inch => "inch",
    }
}

/// The unit with which a part of `size` file units would be of a blade's size, if another than `unit` does better.
fn likely(size: f64, unit: Unit) -> Option<Unit> {
    let fits = |u: Unit| (20.0..=2000.0).contains(&(size * u.mm()));
    // Metres are what simulation programs write, so they come first.
    [Unit::M, Unit::Mm, Unit::Inch, Unit::Cm].into_iter().find(|&u| u != unit && fits(u))
}

/// A note where the part's size (its box, mm) is unusual for a blade.
///
/// # Errors
/// `InputOutput`: the size cannot be a blade's at all.
pub fn check_size(path: &Path, b: Option<Aabb>, unit: Unit) -> Result<Option<String>> {
    let Some(b) = b else { return Ok(None) };
    let size_mm = (b.max - b.min).max();
    if (USUAL_MM[0]..=USUAL_MM[1]).contains(&size_mm) {
        return Ok(None);
    }
    let advice = likely(size_mm / unit.mm(), unit)
        .map(|u| format!("the file is probably in {}: pass --unit {0}", name(u)))
        .unwrap_or_else(|| "check the unit".to_owned());
    let side = if size_mm < USUAL_MM[0] { "small" } else { "large" };
    let message = format!("{} is {size_mm:.4} mm across in {}, too {side} for a blade", path.display(), name(unit));
    if (POSSIBLE_MM[0]..=POSSIBLE_MM[1]).contains(&size_mm) {
        Ok(Some(format!("{message} ({advice})")))
    } else {
        Err(Error::io(Stage::Model, message).advise(advice))
    }
}
