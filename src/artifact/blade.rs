//! A blade as read: the whole part in the blade frame, and what was recognised on it.

use super::region::Regions;
use super::wheel::ModelWheel;
use crate::geometry::Rigid;
use crate::geometry::part::Part;
use crate::observe::Remark;

/// Length unit of a model file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Unit {
    /// Millimetre.
    Mm,
    /// Centimetre.
    Cm,
    /// Metre.
    M,
    /// Inch, 25.4 mm.
    Inch,
}

impl Unit {
    /// Millimetres in one unit.
    pub fn mm(self) -> f64 {
        match self {
            Unit::Mm => 1.0,
            Unit::Cm => 10.0,
            Unit::M => 1000.0,
            Unit::Inch => 25.4,
        }
    }
}

/// A chain of edges that have one triangle each.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Opening {
    /// Number of edges.
    pub edges: usize,
    /// Length of the chain, mm.
    pub length_mm: f64,
    /// Diameter of a round opening, twice the width of a crack, mm.
    pub width_mm: f64,
    /// A point of the chain, model frame, mm.
    pub at_mm: [f64; 3],
}

/// What was found in the file.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct Diagnosis {
    /// Format, e.g. `STEP AP214`.
    pub format: String,
    /// Unit taken, and why.
    pub unit_reason: String,
    /// Number of bodies.
    pub bodies: usize,
    /// Faces by kind (NURBS) or groups (mesh), with counts.
    pub faces: Vec<(String, usize)>,
    /// Every edge of the mesh belongs to two triangles at least: there is no opening.
    pub closed: bool,
    /// Pieces of the mesh that hang together over edges.
    pub pieces: usize,
    /// Edges of the mesh with one triangle.
    pub open_edges: usize,
    /// Openings that these edges make, the longest first.
    pub openings: Vec<Opening>,
    /// Edges with more than two triangles.
    pub nonmanifold_edges: usize,
    /// Middle of the first of them, model frame, mm.
    pub first_nonmanifold_edge: Option<[f64; 3]>,
    /// Edges whose two triangles wind against one another.
    pub inconsistent_edges: usize,
    /// This is the mirror image of what the file holds, across z = 0 of the blade frame, made to
    /// plan in.
    #[serde(skip)]
    pub mirrored: bool,
    /// What speaks against the blade axis that was given.
    #[serde(skip)]
    pub axis_against: Option<Remark>,
    /// What was changed or looks odd.
    pub notes: Vec<Remark>,
}

/// A blade.
#[derive(Clone)]
pub struct Blade {
    /// Name for headers: the file's stem.
    pub name: String,
    /// The unit of the file.
    pub unit: Unit,
    /// The whole part, blade frame, mm.
    pub part: Part,
    /// Blade frame to model frame (mm).
    pub model_from_blade: Rigid,
    /// What lies where.
    pub regions: Regions,
    /// The wheel that the model shows, where it is one or a sector of one.
    pub wheel: Option<ModelWheel>,
    /// What was found in the file.
    pub diagnosis: Diagnosis,
}
