//! The resolved job: every value settled, ready to be saved with the run and run again as it is.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::axis::AxisChoice;
use crate::artifact::blade::Unit;
use crate::artifact::program::Control;
use crate::artifact::schedule::{BaseAngle, Measure, ScheduleKind, Scope};
use crate::artifact::toolpath::{Direction, PathKind, Start};
use crate::error::{Error, Result, Stage};
use crate::tool::Tool;

/// A complete job. Its TOML is a job file again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The CAD file and how to read it.
    pub model: ModelJob,
    /// Where to machine.
    pub region: RegionJob,
    /// The helix.
    pub path: PathJob,
    /// What the tool axis may do.
    pub channel: ChannelJob,
    /// The machine.
    pub machine: MachineJob,
    /// What the tool axis does.
    pub schedule: ScheduleJob,
    /// How fast.
    pub feed: FeedJob,
    /// Programs to write.
    pub post: PostJob,
    /// Limits of the checks.
    pub verify: VerifyJob,
    /// Sections to report.
    pub section: SectionJob,
    /// The tool.
    pub tool: Tool,
    /// What else is in the tool's way. Default, left out: nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixture: Vec<FixtureJob>,
    /// Material that is still to be cut away: the holder keeps clear of it. Default, left out:
    /// none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stock: Option<FixtureJob>,
}

/// `[[fixture]]` or `[stock]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FixtureJob {
    /// Its file; absolute.
    pub file: PathBuf,
    /// Length unit. Default, left out: what the file states, else mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<Unit>,
    /// Clearance of taper and shank, mm. Default: `channel.clearance_mm`.
    pub clearance_mm: f64,
    /// Clearance of the holder, mm. Default: `clearance_mm` where that is typed, else
    /// `channel.holder_clearance_mm`.
    pub holder_clearance_mm: f64,
}

/// `[model]`, known before the blade is read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ModelJob {
    /// The CAD file; absolute, so that the saved job runs from anywhere.
    pub file: PathBuf,
    /// Length unit. Default: what the file declares, else found from the size of the part; filled
    /// in once it is read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<Unit>,
    /// Blade axis in the model frame. Default `auto`: found from the part.
    pub axis: AxisChoice,
    /// Greatest distance between a NURBS part and its triangles, mm. Default 0.01: triangles only
    /// guide the search, distances are then taken to the NURBS themselves, so finer triangles cost
    /// time and gain nothing.
    pub deflection_mm: f64,
    /// Welding distance of a mesh, mm. Default, left out: only where the mesh has faults, the least
    /// of 1e-7, 1e-6 and 1e-5 of its size that leaves fewest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weld_mm: Option<f64>,
    /// Greatest extent of a hole of a mesh that is closed, mm. Default, left out: none, since a
    /// hole may be meant.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub close_holes_mm: Option<f64>,
    /// The body to plan. Default, left out: the blade is looked for on all of the part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<u32>,
    /// Heights of the airfoil, mm. Default, left out: found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub airfoil_mm: Option<[f64; 2]>,
    /// Height of the platform's top, mm. Default, left out: found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub platform_mm: Option<f64>,
    /// Faces of the airfoil. Default, left out: found.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub airfoil_faces: Vec<String>,
    /// Faces of the platform's top. Default, left out: found.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub platform_faces: Vec<String>,
}

/// Greatest lean of a wall that turns of constant scallop may go down, degrees: a platform square
/// to the blade axis.
pub(super) const MOST_LEAN_DEG: f64 = 89.5;

/// `[region]`, heights of ball centres in the blade frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionJob {
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

/// `[path]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PathJob {
    /// How the turns lie. Default `constant-scallop`: the shortest helix that leaves no higher
    /// ridge than is asked for; on a mesh, whose facets make such turns rough, `constant-height`.
    pub kind: PathKind,
    /// Greatest scallop, mm. Default 0.01: usual for finishing airfoils before polishing.
    pub scallop_mm: f64,
    /// Chord tolerance, mm; in smooth hollows of exact faces, where chords raise ridges, a quarter
    /// of it. Default for turns of constant scallop: 0.04 times the scallop, at most 0.001. Round
    /// the part chords then sink ridges by up to 4 %, and in such hollows they raise them by up to
    /// 1 %. Default for the other kinds: 0.001, a tenth of the usual scallop, so that straight
    /// moves do not show.
    pub chord_mm: f64,
    /// Greatest step, mm. Default: a quarter of the ball radius, at most 1 mm, so that the channel
    /// is sampled densely.
    pub max_step_mm: f64,
    /// Greatest lean of the wall, degrees. Default 60: beyond it turns of constant height lie on
    /// the platform. Turns of constant scallop may go on to 89.5, through the fillet to where the
    /// ball first touches a platform that is square to the blade axis.
    pub max_lean_deg: f64,
    /// Climb or conventional milling. Default `climb`: down towards the platform, usual for
    /// finishing.
    pub direction: Direction,
    /// Where turns begin. Default `concave`: where the path enters its greatest concave stretch,
    /// where the channel is narrowest next.
    pub start: Start,
    /// Stock left on the part, mm. Default 0: a finishing pass.
    pub stock_mm: f64,
    /// Lay the paths of the other kinds too and compare lengths. Default false: it takes about as
    /// long again as path and checks.
    pub compare: bool,
}

/// `[channel]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChannelJob {
    /// Clearance of taper and shank, mm. Default 0.1: the cone leaves the ball tangentially, more
    /// would forbid contact near the ball's equator.
    pub clearance_mm: f64,
    /// Clearance of the holder, mm. Default 1: holders are less well known than cutters.
    pub holder_clearance_mm: f64,
    /// Least contact angle, degrees. Default 0: with B leaning, the tip does not touch walls along
    /// the blade axis.
    pub contact_angle_min_deg: f64,
    /// Greatest contact angle, degrees. Default 90: beyond it the upper half of the ball would cut.
    pub contact_angle_max_deg: f64,
    /// Tolerance of the channel's ends, degrees. Default 0.01: well below what a rotary table
    /// repeats.
    pub tolerance_deg: f64,
    /// Prove the walls for the moves between locations too. Default: true where the schedule runs
    /// along a wall, which may jump from one location to the next; else false: it takes
    /// milliseconds a move, and the clearance check covers the motion that is used.
    #[serde(default)]
    pub prove_moves: bool,
    /// Ends of the channel from exact faces, to the tolerance. Default false: a channel takes
    /// several times as long (8 s of processor time for 39,000 locations of `steam_root`, instead
    /// of 1; 24 s, instead of 2, with a fir-tree root). Without it the deflection of the mesh is
    /// kept as room, which is safe and timid: the narrowest place of these two is 0.9 and 3.2
    /// degrees narrower. A channel that is closed for that is looked at by the exact faces in any
    /// case.
    #[serde(default)]
    pub exact_ends: bool,
    /// Show the channel's width at other angles B in the report. Default false: it takes some
    /// seconds and changes no plan; `channel --sweep-b` writes it as a table too.
    #[serde(default)]
    pub sweep_b: bool,
}

/// `[machine]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MachineJob {
    /// Machine file, absolute. Default, left out: the built-in demo machine.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Angle of B, degrees. Default 5: enough to lift the holder off the platform, as in the S–θ
    /// paper.
    pub b_deg: f64,
}

/// `[schedule]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScheduleJob {
    /// How θ(S) is made. Default `piecewise`.
    pub kind: ScheduleKind,
    /// Where kind `piecewise` stands at the start of each turn. Default `best`; the published
    /// method says `forward-limit`.
    #[serde(default)]
    pub base_angle: BaseAngle,
    /// What kind `optimal` makes least. Default `peak-second`: the rotary axis' greatest
    /// acceleration at constant feed.
    #[serde(default)]
    pub measure: Measure,
    /// Over how much of the path kind `optimal` is the best. Default `whole`.
    #[serde(default)]
    pub scope: Scope,
    /// Room to the channel's walls, degrees. Default 0.5: servo lag and set-up errors of a table
    /// stay far below it.
    pub margin_deg: f64,
    /// Lead of kind `fixed`, degrees. Default 15: what CAM users choose to keep the tip off the
    /// surface.
    pub lead_deg: f64,
    /// How far outside the channel the kinds `lower-wall` and `upper-wall` run, degrees. Default,
    /// left out: 0.
    #[serde(default, skip_serializing_if = "nothing")]
    pub beyond_wall_deg: f64,
}

fn nothing(value: &f64) -> bool {
    *value == 0.0
}

/// `[feed]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FeedJob {
    /// Greatest feed, mm/min. Default 2000: finishing of blade steel with a ball cutter.
    pub feed_mm_min: f64,
    /// Radius of the arcs of lead-in and lead-out, mm; 0: straight along the tool axis. Default:
    /// the ball radius, at least 2: the axes come up to their feed on it.
    pub lead_radius_mm: f64,
}

/// `[post]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PostJob {
    /// Controls. Default: Siemens and LinuxCNC.
    pub control: Vec<Control>,
    /// Own post files. Default: none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<PathBuf>,
    /// Tool number. Default 1.
    pub tool_number: u32,
    /// Spindle speed, 1/min. Default 6000.
    pub spindle_rpm: f64,
    /// Feed between the safe position and the feed height, mm/min. Default 5000.
    pub approach_feed_mm_min: f64,
    /// Feed from the feed height to the part and back, mm/min. Default 300.
    pub plunge_feed_mm_min: f64,
    /// Feed height, mm. Default 5.
    pub feed_height_mm: f64,
    /// Clearance at the safe positions, mm. Default 20.
    pub safe_clearance_mm: f64,
    /// Tolerance that the control may smooth positions by, mm. Default: as the post file has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smoothing_mm: Option<f64>,
    /// Write what switches the control's high-speed cutting on. Default true.
    #[serde(default = "PostJob::yes")]
    pub look_ahead: bool,
}

impl PostJob {
    fn yes() -> bool {
        true
    }
}

/// `[verify]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VerifyJob {
    /// Deepest gouge, mm. Default 0.003, or three chord tolerances where that is more.
    pub gouge_mm: f64,
    /// Scallop's 99th percentile over `path.scallop_mm`. Default 1.05.
    pub scallop_ratio: f64,
    /// What a check along the motion may miss, mm. Default 0.0005: half the chord tolerance.
    pub resolution_mm: f64,
    /// Surface samples. Default 120 000: percentiles are then good to 1 %.
    pub surface_samples: u32,
}

/// `[section]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionJob {
    /// Number of sections. Default 12.
    pub count: u32,
}

/// One number and where it may lie.
type Range<'a> = (&'a str, f64, f64, f64);

/// The first value outside its range, as an error.
pub(super) fn check_ranges(ranges: &[Range<'_>]) -> Result<()> {
    match ranges.iter().find(|(_, v, lo, hi)| !(*v >= *lo && *v <= *hi)) {
        None => Ok(()),
        Some((key, v, lo, hi)) => {
            let lo = if *lo == TINY { "greater than 0".to_string() } else { format!("at least {lo}") };
            Err(Error::usage(Stage::Job, format!("{key} is {v}, it must be {lo} and at most {hi}")))
        }
    }
}
/// Stands for "greater than 0" in ranges, mm or degrees: nothing smaller can be meant.
pub(super) const TINY: f64 = 1e-9;

impl Job {
    /// Checks every number.
    ///
    /// # Errors
    /// `Usage` naming key, value and limits.
    pub fn validate(&self) -> Result<()> {
        let (p, c, v) = (&self.path, &self.channel, &self.verify);
        check_ranges(&[
            ("model.deflection_mm", self.model.deflection_mm, TINY, 10.0),
            ("model.weld_mm", self.model.weld_mm.unwrap_or(TINY), TINY, 10.0),
            ("model.close_holes_mm", self.model.close_holes_mm.unwrap_or(TINY), TINY, 1e6),
            ("region.start_mm", self.region.start_mm, -1e6, 1e6),
            ("region.end_mm", self.region.end_mm.unwrap_or(0.0), -1e6, 1e6),
            ("tool.radius_mm", self.tool.radius_mm, TINY, 1000.0),
            ("path.scallop_mm", p.scallop_mm, TINY, 0.5 * self.tool.radius_mm),
            ("path.stock_mm", p.stock_mm, 0.0, 100.0),
            ("path.chord_mm", p.chord_mm, 1e-5, 1.0),
            ("path.max_step_mm", p.max_step_mm, 1e-3, 100.0),
            (
                "path.max_lean_deg",
                p.max_lean_deg,
                1.0,
                if p.kind == PathKind::ConstantScallop { MOST_LEAN_DEG } else { 85.0 },
            ),
            ("channel.clearance_mm", c.clearance_mm, 0.0, 100.0),
            ("channel.holder_clearance_mm", c.holder_clearance_mm, 0.0, 100.0),
            ("channel.contact_angle_min_deg", c.contact_angle_min_deg, 0.0, 90.0),
            ("channel.contact_angle_max_deg", c.contact_angle_max_deg, c.contact_angle_min_deg, 180.0),
            ("channel.tolerance_deg", c.tolerance_deg, 1e-4, 5.0),
            ("machine.b_deg", self.machine.b_deg, -85.0, 85.0),
            ("schedule.margin_deg", self.schedule.margin_deg, 0.0, 45.0),
            ("schedule.lead_deg", self.schedule.lead_deg, -85.0, 85.0),
            ("schedule.beyond_wall_deg", self.schedule.beyond_wall_deg, 0.0, 45.0),
            ("feed.feed_mm_min", self.feed.feed_mm_min, 0.01, 1e6),
            ("feed.lead_radius_mm", self.feed.lead_radius_mm, 0.0, 1000.0),
            ("verify.gouge_mm", v.gouge_mm, TINY, 10.0),
            ("verify.scallop_ratio", v.scallop_ratio, 0.01, 1000.0),
            ("verify.resolution_mm", v.resolution_mm, 1e-5, 1.0),
            ("verify.surface_samples", f64::from(v.surface_samples), 1000.0, 1e7),
            ("post.tool_number", f64::from(self.post.tool_number), 1.0, 99_999_999.0),
            ("post.spindle_rpm", self.post.spindle_rpm, 1.0, 1e6),
            ("post.approach_feed_mm_min", self.post.approach_feed_mm_min, 1.0, 1e6),
            ("post.plunge_feed_mm_min", self.post.plunge_feed_mm_min, 1.0, 1e6),
            ("post.feed_height_mm", self.post.feed_height_mm, TINY, 1000.0),
            ("post.safe_clearance_mm", self.post.safe_clearance_mm, TINY, 1000.0),
            ("post.smoothing_mm", self.post.smoothing_mm.unwrap_or(1.0), TINY, 1.0),
            ("section.count", f64::from(self.section.count), 1.0, 1000.0),
        ])?;
        for f in self.fixture.iter().chain(&self.stock) {
            check_ranges(&[
                ("fixture.clearance_mm", f.clearance_mm, 0.0, 100.0),
                ("fixture.holder_clearance_mm", f.holder_clearance_mm, 0.0, 100.0),
            ])?;
        }
        self.tool.validate()?;
        if self.region.end_mm.is_some_and(|end| end >= self.region.start_mm) {
            let (a, b) = (self.region.start_mm, self.region.end_mm.unwrap_or_default());
            return Err(Error::usage(
                Stage::Job,
                format!(
                    "region.end_mm ({b}) must be less than region.start_mm ({a}): the helix runs down to the platform"
                ),
            ));
        }
        if self.post.control.is_empty() && self.post.files.is_empty() {
            return Err(Error::usage(Stage::Job, "post.control is empty, it must name at least one control"));
        }
        Ok(())
    }

    /// The job as the text of a job file.
    ///
    /// # Errors
    /// `InputOutput` if a path is not Unicode.
    pub fn to_toml(&self) -> Result<String> {
        toml::to_string(self)
            .map_err(|e| Error::io(Stage::Job, format!("the resolved job cannot be written as TOML: {e}")))
    }
}
