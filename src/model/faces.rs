//! What readers of exact faces give.

use crate::artifact::blade::Unit;
use crate::geometry::brep::Brep;

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
    /// What the user should know.
    pub notes: Vec<String>,
}
