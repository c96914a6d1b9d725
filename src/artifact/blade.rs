//! A blade as read: the whole part in the blade frame, and what was recognised on it.

use crate::geometry::Rigid;
use crate::geometry::part::Part;

/// Length unit of a model file.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema, clap::ValueEnum,
)]
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

/// Where along the blade axis what was found, mm in the blade frame (`x` from root to tip).
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Regions {
    /// The whole part.
    pub part_x_mm: [f64; 2],
    /// Sections here are one airfoil loop, clear of platform, shroud and tenon.
    pub airfoil_x_mm: [f64; 2],
    /// Top of the platform on the airfoil's side, where there is a platform.
    pub platform_x_mm: Option<f64>,
    /// How each was found, one sentence each.
    pub reasons: Vec<String>,
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
    /// Every edge of the mesh belongs to exactly two triangles.
    pub closed: bool,
    /// Open edges of the mesh, and the midpoint of the first, model frame, mm.
    pub open_edges: usize,
    /// Where the first open edge is, model frame, mm.
    pub first_open_edge: Option<[f64; 3]>,
    /// What was changed or looks odd.
    pub notes: Vec<String>,
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
    /// What was found in the file.
    pub diagnosis: Diagnosis,
}
