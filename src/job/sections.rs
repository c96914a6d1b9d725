//! Sections of the job file that no stage reads as they are: model, fixtures, region and tool.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axis::AxisChoice;
use crate::artifact::blade::Unit;
use crate::error::{Error, Result, Stage};
use crate::read::model::ModelOptions;
use crate::settings::{TINY, section};
use crate::tool::{CLEARANCE_MM, HOLDER_CLEARANCE_MM, HolderStage};

section! {
    /// `[model]`
    "model" ModelSettings, ModelKeys, s {
        /// The CAD file; relative to the job file.
        ///
        /// Absolute once the model is to be read, so that the saved job runs from anywhere. There
        /// is no default.
        file: String as PathBuf = PathBuf::new();
        /// Length unit of the file; default: what the file declares, else found from its size.
        ///
        /// Filled in once the file is read.
        #[serde(skip_serializing_if = "Option::is_none")]
        unit: Unit as Option<Unit> = None;
        /// Direction of the blade axis, root to tip, in the model frame; default: found.
        axis: AxisChoice = AxisChoice::Auto;
        /// Greatest distance between a NURBS part and its triangles, mm; at least two millionths of
        /// its size.
        ///
        /// Triangles only guide the search, distances are then taken to the NURBS themselves, so
        /// finer triangles cost time and gain nothing.
        deflection_mm: f64 = ModelOptions::default().deflection_mm, TINY..=10.0;
        /// Vertices of a mesh this near to one another are the same, mm; default: found where the
        /// mesh has faults.
        ///
        /// Then it is the least of 1e-7, 1e-6 and 1e-5 of its size that leaves fewest.
        #[serde(skip_serializing_if = "Option::is_none")]
        weld_mm: f64 as Option<f64> = None, TINY..=10.0;
        /// Holes of a mesh up to this extent are closed, mm; default: none.
        ///
        /// A hole may be meant.
        #[serde(skip_serializing_if = "Option::is_none")]
        close_holes_mm: f64 as Option<f64> = None, TINY..=1e6;
        /// The body to plan, by its number as `inspect` prints it; default: the blade is looked for
        /// on all of the part.
        #[serde(skip_serializing_if = "Option::is_none")]
        body: u32 as Option<u32> = None;
        /// Heights between which the airfoil lies, mm along the blade axis; default: found.
        #[serde(skip_serializing_if = "Option::is_none")]
        airfoil_mm: [f64; 2] as Option<[f64; 2]> = None;
        /// Height of the platform's top, mm along the blade axis; default: found.
        #[serde(skip_serializing_if = "Option::is_none")]
        platform_mm: f64 as Option<f64> = None;
        /// Faces of the airfoil, by number or name as `inspect` prints them; default: found.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        airfoil_faces: Vec<String> = Vec::new();
        /// Faces of the platform's top, by number or name; default: found.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        platform_faces: Vec<String> = Vec::new();
    }
}

section! {
    /// `[[fixture]]` and `[stock]`: a closed body in the frame of the model's file. Of the stock
    /// only the holder keeps clear: the cutter cuts it.
    "fixture" FixtureSettings, FixtureKeys, s {
        /// The file, in any format of a model; relative to the job file.
        ///
        /// Absolute once the job is complete. There is no default.
        file: String as PathBuf = PathBuf::new();
        /// Length unit of the file; default: what the file states, else mm.
        #[serde(skip_serializing_if = "Option::is_none")]
        unit: Unit as Option<Unit> = None;
        /// Room that taper and shank keep from it, mm; default: that of `channel`.
        clearance_mm: f64 = CLEARANCE_MM, 0.0..=100.0;
        /// Room that the holder keeps from it, mm; default: that of `channel`, or `clearance_mm`
        /// where that is given.
        holder_clearance_mm: f64 = HOLDER_CLEARANCE_MM, 0.0..=100.0;
    }
}

section! {
    /// `[wheel]`: the wheel that the blade belongs to. Its other blades and its hub are in the
    /// tool's way. A model of a whole wheel needs no section.
    "wheel" WheelSettings, WheelKeys, s {
        /// Number of blades, evenly spaced about the rotor axis; default: that of the model where
        /// it is a wheel or one sector, else there is none.
        blades: u32 = 0, 2.0..=1000.0;
        /// Direction of the rotor axis in the frame of the model; default: as for `blades`.
        axis: [f64; 3] = [0.0; 3];
        /// A point on the rotor axis in the frame of the model, mm; default: that of the model's
        /// wheel, else the origin.
        origin_mm: [f64; 3] = [0.0; 3];
        /// Contour of the hub: places along the rotor axis from `origin_mm`, rising, and the hub's
        /// radius there, mm; default: none but what the model has.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        hub_mm: Vec<[f64; 2]> = Vec::new();
        /// Contour of the blades' tips in the same coordinates, from their one edge to the other,
        /// in the order of `hub_mm`: for the blade of an impeller, whose heights lead from its hub
        /// to its tip; default: none, heights are along the blade axis, or the model's.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        tip_mm: Vec<[f64; 2]> = Vec::new();
    }
}

/// What heights of the region are measured from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RegionReference {
    /// The origin of the blade frame.
    #[default]
    Blade,
    /// The top of the platform.
    Platform,
}

impl WheelSettings {
    /// Checks what ranges of single numbers do not say.
    ///
    /// # Errors
    /// `Usage` naming the key.
    pub fn validate(&self) -> Result<()> {
        self.check(Stage::Job)?;
        let bad = |what: String| Err(Error::usage(Stage::Job, what));
        let finite = |v: &[f64]| v.iter().all(|x| x.is_finite() && x.abs() <= 1e6);
        if !(finite(&self.axis) && self.axis.iter().any(|v| v.abs() > 1e-9)) {
            return bad(
                "wheel.axis is missing or no direction: along what does the rotor turn, in the model's frame?".into()
            );
        }
        if !finite(&self.origin_mm) {
            return bad(format!("wheel.origin_mm is {:?}, three numbers of at most 1e6 mm are wanted", self.origin_mm));
        }
        for (key, contour) in [("hub_mm", &self.hub_mm), ("tip_mm", &self.tip_mm)] {
            if let Some(p) = contour.iter().find(|p| !(finite(&p[..]) && p[1] >= 0.0)) {
                return bad(format!("wheel.{key} has {p:?}, a place and a radius of at least 0 are wanted, in mm"));
            }
        }
        if self.hub_mm.len() == 1 || self.hub_mm.windows(2).any(|w| w[1][0] <= w[0][0]) {
            return bad("wheel.hub_mm must have two places or more, rising along the rotor axis".into());
        }
        if !self.tip_mm.is_empty() && (self.tip_mm.len() == 1 || self.hub_mm.is_empty()) {
            return bad("wheel.tip_mm must have two places or more, and wheel.hub_mm is wanted beside it".into());
        }
        Ok(())
    }
}

/// `[region]`: heights of the ball centre along the blade axis. The helix runs from `start_mm` down
/// to `end_mm`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RegionKeys {
    /// Height of the first ball centre, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_mm: Option<f64>,
    /// Height of the last ball centre, mm; less than `start_mm`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_mm: Option<f64>,
    /// Faces or groups, by number or name: the helix ends where the ball comes to one of them. For
    /// turns of constant scallop.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_faces: Option<Vec<String>>,
    /// What both heights are measured from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference: Option<RegionReference>,
}

/// `[region]`, heights of ball centres in the blade frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionSettings {
    /// First ball centre, mm. Default: over the lowest 30 % of the airfoil, at least 3 ball radii
    /// and at most 40 mm: what the platform keeps other operations from.
    pub start_mm: f64,
    /// Last ball centre, mm. Default, left out: as far down as the wall leans less than
    /// `path.max_lean_deg` and the ball touches the airfoil's side.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_mm: Option<f64>,
    /// Faces or groups, by number or name, at which the helix ends: where the ball comes to one of
    /// them. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub end_faces: Vec<String>,
}

/// What a tool is called in a library.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "the number or the name of a tool is wanted")]
pub enum LibraryEntry {
    /// Its number.
    Number(u32),
    /// Its name, or its number as text.
    Name(String),
}

impl std::fmt::Display for LibraryEntry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            LibraryEntry::Number(n) => n.fmt(f),
            LibraryEntry::Name(name) => name.fmt(f),
        }
    }
}

/// `[tool]`
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolKeys {
    /// A tool library: JSON of Fusion, or a tool table of LinuxCNC; relative to the job file. Keys
    /// beside it go before what it says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub library: Option<String>,
    /// Number or name of the tool in the library; may be left out where it has one ball-end cutter
    /// only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry: Option<LibraryEntry>,
    /// Length unit of a library that states none (LinuxCNC); default: mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<Unit>,
    /// Ball radius, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_mm: Option<f64>,
    /// Radius of the corner of a bull-nose or flat cutter, mm; left out, or equal to radius_mm: a
    /// ball. Such a cutter leans forwards by channel.contact_angle_min_deg to
    /// contact_angle_max_deg.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_radius_mm: Option<f64>,
    /// Half angle of the cone behind the ball, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taper_deg: Option<f64>,
    /// Radius of the shank, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shank_radius_mm: Option<f64>,
    /// From the ball centre to the first holder stage, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stickout_mm: Option<f64>,
    /// Holder stages from the cutter towards the spindle; an empty list: no holder.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub holder: Option<Vec<HolderStage>>,
}

impl ToolKeys {
    /// Radius of the corner, mm; `None`: a ball.
    pub fn corner_mm(&self) -> Option<f64> {
        self.corner_radius_mm.filter(|corner| Some(*corner) != self.radius_mm)
    }
}
