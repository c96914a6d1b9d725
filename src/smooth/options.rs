//! Options of the smoothing stage.

use crate::artifact::schedule::MARGIN_DEG;
use crate::error::{Error, Result, Stage};

/// What the breaks of a curve are to be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Aim {
    /// Some moves apart, so that the objective becomes small.
    #[default]
    Smoothest,
    /// As few as the search finds.
    Fewest,
}

/// Options of [`super::plan`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmoothOptions {
    /// How deep the ball may be in the part, mm. Default 0.25 µm: a quarter of the usual limit of
    /// gouges.
    pub inwards_mm: f64,
    /// How far the ball may be off the part, mm. Default 0.25 µm, far less than a ridge.
    pub outwards_mm: f64,
    /// How far the ball may be beside the path on the part, as a share of the distance to the next
    /// turn. Default 0.03. A ridge grows with the square of the distance of two turns, so a single
    /// one may grow by 12 %; nearly everywhere both turns move alike, and the ridges' 99th
    /// percentile grew by 2.3 % at most on the blades it was measured on (`docs/smoothing.md`).
    pub across: f64,
    /// How far ahead of or behind its place on the path the ball may be, mm. Default 2 µm: it is
    /// the same curve, run a little otherwise.
    pub along_mm: f64,
    /// How far θ may be from the schedule, rad. Default 0.5°.
    pub turn_rad: f64,
    /// Room that θ keeps from the channel's walls where the schedule does, rad.
    pub margin_rad: f64,
    /// Share by which the result may be worse than the best on the same breaks. Default 0.005.
    pub gap: f64,
    /// What the breaks are to be. Default [`Aim::Smoothest`].
    pub aim: Aim,
    /// Also prove what no curve of any form can fall below, for [`super::Objective::Part`]; takes
    /// as long again.
    pub bound_of_any: bool,
}

impl Default for SmoothOptions {
    fn default() -> Self {
        SmoothOptions {
            inwards_mm: 0.25e-3,
            outwards_mm: 0.25e-3,
            across: 0.03,
            along_mm: 2e-3,
            turn_rad: 0.5_f64.to_radians(),
            margin_rad: MARGIN_DEG.to_radians(),
            gap: 5e-3,
            aim: Aim::Smoothest,
            bound_of_any: false,
        }
    }
}

impl SmoothOptions {
    /// Those for a part that is a mesh: along the normal as much as facets need. Inwards nearly the
    /// usual limit of gouges, outwards a quarter of the ridges.
    #[must_use]
    pub fn on_mesh(self, scallop_mm: f64) -> Self {
        SmoothOptions { inwards_mm: 0.9e-3, outwards_mm: (0.25 * scallop_mm).max(self.outwards_mm), ..self }
    }

    /// Checks all values.
    ///
    /// # Errors
    /// Kind `Usage`, naming the option and its limits.
    pub fn validate(&self) -> Result<()> {
        let limits = [
            ("inwards_mm", self.inwards_mm, 1e-6, 1.0),
            ("outwards_mm", self.outwards_mm, 1e-6, 1.0),
            ("across", self.across, 1e-5, 0.25),
            ("along_mm", self.along_mm, 1e-6, 1.0),
            ("turn_rad", self.turn_rad, 1e-6, 1.0),
            ("margin_rad", self.margin_rad, 0.0, 1.0),
            ("gap", self.gap, 1e-6, 0.5),
        ];
        match limits.into_iter().find(|(_, value, least, most)| !(least..=most).contains(&value)) {
            Some((name, value, least, most)) => {
                Err(Error::usage(Stage::Smooth, format!("smoothing's {name} is {value}, it must be {least} to {most}")))
            }
            None => Ok(()),
        }
    }
}
