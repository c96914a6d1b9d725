//! What readers of exact faces give.

use super::units::UnitSource;
use crate::artifact::blade::Unit;
use crate::geometry::Vector;
use crate::geometry::brep::Brep;
use crate::observe::Remark;

/// The faces of a model, before anything is healed.
pub struct FaceModel {
    /// All bodies, mm.
    pub brep: Brep,
    /// Number of solids, surface models and loose groups placed.
    pub bodies: usize,
    /// `STEP AP214`, `IGES 5.3` and the like.
    pub format: String,
    /// Unit taken.
    pub unit: Unit,
    /// Unit taken, and why.
    pub unit_reason: String,
    /// Who says so.
    pub unit_source: UnitSource,
    /// What the user should know.
    pub notes: Vec<Remark>,
    /// How the sections are stacked, where the faces were lofted through a table of them.
    pub stacking: Option<Stacking>,
}

/// How a table stacks its sections.
#[derive(Clone, Debug, PartialEq)]
pub struct Stacking {
    /// Unit vector along the line through the middles of the sections, from the first section to
    /// the last.
    pub line: Vector,
    /// Mean of the sections' unit normals, unit vector, the same hemisphere.
    pub normal: Vector,
    /// The sections lie in parallel planes.
    pub parallel: bool,
    /// Area of the last section over that of the first.
    pub growth: f64,
}
