//! The job file as typed: every key optional, unknown keys refused, units in the names.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axis::AxisChoice;
use crate::artifact::blade::Unit;
use crate::artifact::program::Control;
use crate::artifact::schedule::{BaseAngle, Measure, ScheduleKind, Scope};
use crate::artifact::toolpath::{Direction, PathKind, Start};
use crate::tool::HolderStage;

/// The job file. A key that is left out takes its default (see [`super::Job`]); a section that is left out, all of its.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobFile {
    /// The CAD file and how to read it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ModelKeys>,
    /// Where to machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<RegionKeys>,
    /// The tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<ToolKeys>,
    /// What else is in the tool's way; entries of a list.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fixture: Option<Vec<FixtureKeys>>,
    /// Material that is still to be cut away.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stock: Option<FixtureKeys>,
    /// The helix.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathKeys>,
    /// What the tool axis may do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<ChannelKeys>,
    /// The machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub machine: Option<MachineKeys>,
    /// What the tool axis does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub schedule: Option<ScheduleKeys>,
    /// How fast.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<FeedKeys>,
    /// Programs to write.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub post: Option<PostKeys>,
    /// Limits of the checks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verify: Option<VerifyKeys>,
    /// Sections to report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub section: Option<SectionKeys>,
}

/// Declares the keys of one section: all optional, left out again when written.
macro_rules! keys {
    ($(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($(#[$field_doc])* #[serde(skip_serializing_if = "Option::is_none")] pub $field: Option<$type>,)*
        }
    };
}

keys! {
    /// `[model]`
    ModelKeys {
        /// The CAD file; relative to the job file.
        file: String,
        /// Length unit of the file; default: what the file declares, else found from its size.
        unit: Unit,
        /// Direction of the blade axis, root to tip, in the model frame; default: found.
        axis: AxisChoice,
        /// Greatest distance between a NURBS part and its triangles, mm; at least two millionths of its size.
        deflection_mm: f64,
        /// Vertices of a mesh this near to one another are the same, mm; default: found where the mesh has faults.
        weld_mm: f64,
        /// Holes of a mesh up to this extent are closed, mm; default: none.
        close_holes_mm: f64,
        /// The body to plan, by its number as `inspect` prints it; default: the blade is looked for on all of the part.
        body: u32,
        /// Heights between which the airfoil lies, mm along the blade axis; default: found.
        airfoil_mm: [f64; 2],
        /// Height of the platform's top, mm along the blade axis; default: found.
        platform_mm: f64,
        /// Faces of the airfoil, by number or name as `inspect` prints them; default: found.
        airfoil_faces: Vec<String>,
        /// Faces of the platform's top, by number or name; default: found.
        platform_faces: Vec<String>,
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

keys! {
    /// `[region]`: heights of the ball centre along the blade axis. The helix runs from `start_mm` down to `end_mm`.
    RegionKeys {
        /// Height of the first ball centre, mm.
        start_mm: f64,
        /// Height of the last ball centre, mm; less than `start_mm`.
        end_mm: f64,
        /// Faces or groups, by number or name: the helix ends where the ball comes to one of them. For turns of constant scallop.
        end_faces: Vec<String>,
        /// What both heights are measured from.
        reference: RegionReference,
    }
}
keys! {
    /// `[[fixture]]` and `[stock]`: a closed body in the frame of the model's file. Of the stock only the holder keeps clear: the
    /// cutter cuts it.
    FixtureKeys {
        /// The file, in any format of a model; relative to the job file.
        file: String,
        /// Length unit of the file; default: what the file states, else mm.
        unit: Unit,
        /// Room that taper and shank keep from it, mm; default: that of `channel`.
        clearance_mm: f64,
        /// Room that the holder keeps from it, mm; default: that of `channel`, or `clearance_mm` where that is given.
        holder_clearance_mm: f64,
    }
}
keys! {
    /// `[tool]`
    ToolKeys {
        /// Ball radius, mm.
        radius_mm: f64,
        /// Half angle of the cone behind the ball, degrees.
        taper_deg: f64,
        /// Radius of the shank, mm.
        shank_radius_mm: f64,
        /// From the ball centre to the first holder stage, mm.
        stickout_mm: f64,
        /// Holder stages from the cutter towards the spindle; an empty list: no holder.
        holder: Vec<HolderStage>,
    }
}

keys! {
    /// `[path]`
    PathKeys {
        /// How the turns lie.
        kind: PathKind,
        /// Greatest scallop between neighbouring turns, mm.
        scallop_mm: f64,
        /// Greatest distance of the straight moves from the exact path of ball centres, mm.
        chord_mm: f64,
        /// Greatest distance between two cutter locations, mm.
        max_step_mm: f64,
        /// The helix ends where the wall leans more than this from the blade axis, degrees; from 1 to 85, with turns of constant scallop to
        /// 89.5: down to where the ball first touches a platform that is square to the axis.
        max_lean_deg: f64,
        /// Climb or conventional milling.
        direction: Direction,
        /// Where turns begin.
        start: Start,
        /// Stock left on the part for a later pass, mm.
        stock_mm: f64,
        /// Lay the paths of the other kinds too, of the same worst scallop, and compare lengths in the summary.
        compare: bool,
    }
}
keys! {
    /// `[channel]`
    ChannelKeys {
        /// Room that taper and shank keep from the part, mm.
        clearance_mm: f64,
        /// Room that the holder keeps from the part, mm.
        holder_clearance_mm: f64,
        /// Least angle between tool axis and surface normal, degrees.
        contact_angle_min_deg: f64,
        /// Greatest angle between tool axis and surface normal, degrees.
        contact_angle_max_deg: f64,
        /// Tolerance of the channel's ends, degrees.
        tolerance_deg: f64,
        /// Prove the walls for the moves between locations too, and move them inwards where they do not hold; slow. Default: only for schedules along a wall.
        prove_moves: bool,
        /// Ends of the channel from exact faces, to the tolerance; otherwise the deflection of their mesh is kept as room.
        exact_ends: bool,
        /// Show the channel's width at other angles B in the report; takes some seconds.
        sweep_b: bool,
    }
}
keys! {
    /// `[machine]`
    MachineKeys {
        /// Machine file, relative to the job file; default: the built-in demo machine.
        file: String,
        /// Angle of the pivoting head B, degrees; positive leans the spindle away from the platform.
        b_deg: f64,
    }
}
keys! {
    /// `[schedule]`
    ScheduleKeys {
        /// How θ(S) is made.
        kind: ScheduleKind,
        /// Where kind `piecewise` stands at the start of each turn.
        base_angle: BaseAngle,
        /// What kind `optimal` makes least.
        measure: Measure,
        /// Over how much of the path at once.
        scope: Scope,
        /// Room that the schedule keeps from the channel's walls where there is room, degrees.
        margin_deg: f64,
        /// Lead of kind `fixed`: angle of the tool axis ahead of the surface normal, degrees.
        lead_deg: f64,
        /// How far outside the channel the kinds `lower-wall` and `upper-wall` run, degrees; for trying the channel.
        beyond_wall_deg: f64,
    }
}
keys! {
    /// `[feed]`
    FeedKeys {
        /// Greatest feed of the ball centre over the part, mm/min.
        feed_mm_min: f64,
        /// Radius of the arcs on which the ball comes onto the path and leaves it, mm; 0: straight along the tool axis.
        lead_radius_mm: f64,
    }
}
keys! {
    /// `[post]`
    PostKeys {
        /// Controls to write programs for.
        control: Vec<Control>,
        /// Own post files (TOML) to write programs with, besides.
        files: Vec<String>,
        /// Number of the tool.
        tool_number: u32,
        /// Spindle speed, 1/min.
        spindle_rpm: f64,
        /// Feed between the safe position and the feed height, mm/min.
        approach_feed_mm_min: f64,
        /// Feed from the feed height to the part and back, mm/min.
        plunge_feed_mm_min: f64,
        /// Feed height over the first and last location, along the tool axis, mm.
        feed_height_mm: f64,
        /// Distance between the tool and the sphere around the part at the safe positions, mm.
        safe_clearance_mm: f64,
        /// Tolerance that the control may smooth positions by, mm.
        smoothing_mm: f64,
        /// Write what switches the control's high-speed cutting on.
        look_ahead: bool,
    }
}
keys! {
    /// `[verify]`
    VerifyKeys {
        /// Deepest gouge allowed, mm.
        gouge_mm: f64,
        /// The 99th percentile of the scallop may be this many times `path.scallop_mm`.
        scallop_ratio: f64,
        /// Greatest error that a check along the motion may make between its samples, mm.
        resolution_mm: f64,
        /// Number of surface samples in the machined band, about.
        surface_samples: u32,
    }
}
keys! {
    /// `[section]`
    SectionKeys {
        /// Number of plane sections to write, spread over the airfoil.
        count: u32,
    }
}
