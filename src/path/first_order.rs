//! Turns as a published method for turn-milling lays them, to compare with: each is the first-order
//! neighbour of the turn before ([`super::front`], `first_order`), and what one is off by adds up.
//!
//! The end of the region is found as for turns of constant scallop, so that all three kinds have
//! the same last turn and go over the same surface; from it on up nothing is measured.
//!
//! * [`PathKind::FirstOrder`]: a helix, as the workpiece turns. Published, the workpiece's turn is
//!   a shift of the face's parameters for each pass. In coordinates of the part a path does not
//!   know the spindle: the shift says when the tool is where, and what differs is that turns go on
//!   into one another.
//! * [`PathKind::FirstOrderRings`]: closed rings with a move across from each to the next, as on a
//!   part that stands still.
//!
//! Turns of this kind may run into one another so that none goes on. The path has those up to there
//! then, with a warning.

use super::constant_scallop;
use super::front::By;
use super::level::LevelSet;
use super::options::PathOptions;
use crate::artifact::toolpath::PathKind;
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::observe::Observer;

/// Lays the turns from the end of the region up to the height `start_x`.
///
/// # Errors
/// Kind `Usage` on a mesh, with stock and for cutters other than balls; those of turns of constant
/// scallop.
pub(super) fn plan(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let kind = options.settings.kind;
    let wants = |what: &str, advice: &str| {
        Err(Error::usage(Stage::Path, format!("path.kind is {}, which {what}", kind.name())).advise(advice.to_owned()))
    };
    if level.is_over_facets() {
        return wants("needs the curvature of exact faces, but the part is a mesh", "give a STEP or IGES file");
    }
    if options.settings.stock_mm != 0.0 {
        return wants("lies on the part itself, but path.stock_mm is not 0", "leave out path.stock_mm");
    }
    if level.inclined.is_some() {
        return wants("is known for balls alone, but the cutter has a corner", "leave out tool.corner_radius_mm");
    }
    let by = if kind == PathKind::FirstOrderRings { By::FirstOrderRings } else { By::FirstOrder };
    constant_scallop::neighbours(blade, level, options, start_x, by, observer)
}
