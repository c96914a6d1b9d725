//! `summary.json`: the figures of a run.

use crate::artifact::program::{CycleTime, Program};
use crate::artifact::report::{LimitFigures, TurningFigures};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{AxisTurning, PathKind, Toolpath};
use crate::artifact::{AxisMotion, Channel, CheckReport, Plan, Schedule};
use crate::machine::{Axis, AxisPeak, Machine};

/// A schedule's figures.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ScheduleFigures {
    /// Which.
    pub kind: ScheduleKind,
    /// Places where θ turns back.
    pub reversals: usize,
    /// Locations at which it leaves the true channel: there the tool would collide.
    pub outside_channel: usize,
    /// Greatest |dθ/ds|, degrees per mm.
    pub theta_rate_peak_deg_per_mm: f64,
    /// Greatest |d²θ/ds²|, degrees per mm².
    pub theta_acceleration_peak_deg_per_mm2: f64,
    /// Machining time under the machine's limits, s.
    pub machining_time_s: f64,
    /// Peaks of each axis with its own feed.
    pub axes: Vec<AxisPeak>,
    /// Greatest rotary velocity at the programmed feed held constant, degrees per second.
    pub a_velocity_at_constant_feed_deg_s: f64,
    /// Greatest rotary acceleration at the programmed feed held constant, degrees per second
    /// squared.
    pub a_acceleration_at_constant_feed_deg_s2: f64,
}

/// A path of another kind over the same region, laid for comparison alone.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct PathFigures {
    /// How its turns lie.
    pub kind: PathKind,
    /// Turns.
    pub turns: usize,
    /// Length of the path of ball centres, mm.
    pub path_length_mm: f64,
    /// Inner turns beside the limit, judged by the scallop asked for.
    pub limit: LimitFigures,
    /// Its ratio of length to limit if its worst ridge (99th percentile) were the same as that of
    /// the path in use: a length falls as the root of the scallop.
    pub ratio_at_same_scallop: f64,
}

/// A program of a run.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ProgramFigures {
    /// Its file.
    pub file: String,
    /// The control, in words.
    pub control: String,
    /// Lines.
    pub lines: usize,
    /// Bytes.
    pub bytes: usize,
    /// Where its time goes; without tool changes.
    pub cycle: CycleTime,
}

/// Figures of a program of one operation.
pub fn program_figures(program: &Program) -> ProgramFigures {
    ProgramFigures {
        file: program.file_name.clone(),
        control: program.control.clone(),
        lines: program.text.lines().count(),
        bytes: program.text.len(),
        cycle: program.cycles.first().copied().unwrap_or_default(),
    }
}

/// Greatest jerk of an axis at the programmed feed held constant.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SmoothedJerk {
    /// Axis.
    pub axis: String,
    /// Of the path as it was, on a spline through its locations: mm or degrees per second cubed.
    pub before: f64,
    /// Of the curve.
    pub now: f64,
}

/// What a smooth curve gains over the path that it was made from.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SmoothFigures {
    /// Length of the path that stays as it is, mm.
    pub left_mm: f64,
    /// Places where it does.
    pub left_places: usize,
    /// The ball is nowhere deeper in the part on the curve, mm: proved when it was made.
    pub inwards_mm: f64,
    /// Nowhere farther off it, mm.
    pub outwards_mm: f64,
    /// Cutter locations before; now they are places of the curve.
    pub locations_before: usize,
    /// Pieces of the curve and straight moves.
    pub pieces: usize,
    /// With `feed.fit_mm` the least number of pieces that any such curve has, where it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pieces_bound: Option<usize>,
    /// Machining time before, s.
    pub time_before_s: f64,
    /// Machining time on the curve, s.
    pub time_s: f64,
    /// Jerk of each axis.
    pub jerk: Vec<SmoothedJerk>,
}

/// What the curve of a plan gains; `None` without one.
fn smooth_figures(plan: &Plan, axes: &[Axis]) -> Option<SmoothFigures> {
    let curve = plan.curve.as_ref()?;
    let jerk = axes.iter().enumerate().filter_map(|(k, axis)| {
        let [before, now] = [curve.before.jerk.get(k), curve.before.jerk_now.get(k)];
        Some(SmoothedJerk { axis: axis.name.clone(), before: axis.shown(*before?), now: axis.shown(*now?) })
    });
    Some(SmoothFigures {
        left_mm: curve.left.iter().map(|l| l.s_mm[1] - l.s_mm[0]).sum(),
        left_places: curve.left.len(),
        inwards_mm: curve.proof.inwards_mm,
        outwards_mm: curve.proof.outwards_mm,
        locations_before: curve.before.locations,
        pieces: curve.blocks(),
        pieces_bound: curve.proof.pieces_bound,
        time_before_s: curve.before.time_s,
        time_s: plan.motion.time_s,
        jerk: jerk.collect(),
    })
}

/// The summary.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Summary {
    /// Blade.
    pub name: String,
    /// Turns.
    pub turns: usize,
    /// Cutter locations.
    pub cutter_locations: usize,
    /// Length of the path of ball centres, mm.
    pub path_length_mm: f64,
    /// Heights of the first and last ball centre along the blade axis, mm.
    pub region_x_mm: [f64; 2],
    /// Why the path ends where it does.
    pub end_reason: String,
    /// Machining time along the path, s.
    pub machining_time_s: f64,
    /// Scallop asked for, mm.
    pub scallop_asked_mm: f64,
    /// Stock left on the part for a later pass, mm.
    pub stock_mm: f64,
    /// Greatest scallop that the planner foresaw, mm.
    pub scallop_planned_mm: f64,
    /// Scallop measured by the checks, mm.
    pub scallop_max_mm: f64,
    /// 99th percentile, mm.
    pub scallop_p99_mm: f64,
    /// 95th percentile, mm.
    pub scallop_p95_mm: f64,
    /// Median, mm.
    pub scallop_p50_mm: f64,
    /// 5th percentile, mm.
    pub scallop_p05_mm: f64,
    /// Radius of the disc that the corner of the cutter rolls over, mm; 0, and left out: a ball. Of
    /// such a cutter nothing of `limit` and of what stays uncut is measured: they are 0.
    #[serde(default, skip_serializing_if = "crate::artifact::toolpath::is_none")]
    pub disc_radius_mm: f64,
    /// Length of the inner turns along their contacts beside the least that their area needs, with
    /// the ridges between them.
    pub limit: LimitFigures,
    /// Paths of the other kinds with the same worst scallop; empty without `path.compare`.
    pub other_paths: Vec<PathFigures>,
    /// Area beside the path that no ball of this radius can reach, mm², and the most that is left
    /// there, mm.
    pub uncut_area_mm2: f64,
    /// Most that is left there, mm.
    pub uncut_height_mm: f64,
    /// No gouge is deeper, mm: what the checks proved.
    pub gouge_mm: f64,
    /// Taper, shank and holder come no nearer to the part, mm: what the checks proved.
    pub clearance_mm: f64,
    /// Least width of the channel, degrees: `theta_max_deg` less `theta_min_deg` of
    /// `cutter_locations.csv`.
    pub channel_width_min_deg: f64,
    /// Cutter location of the narrowest place.
    pub channel_narrowest_row: usize,
    /// Least width of the channel's monotone hull, degrees: what a schedule that never turns back
    /// has.
    #[serde(default)]
    pub channel_monotone_min_deg: f64,
    /// In five axes, how evenly longitude and latitude of the tool axis turn, each with its bound.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis_turning: Option<AxisTurning>,
    /// The schedule used first, then the baselines.
    pub schedules: Vec<ScheduleFigures>,
    /// What the smooth curve gains; absent without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smooth: Option<SmoothFigures>,
    /// Axes whose velocity, acceleration and jerk are assumed: with them every time above and
    /// below.
    #[serde(default)]
    pub limits_assumed: Vec<String>,
    /// Turn-milling, where the job asks for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turning: Option<TurningFigures>,
    /// Programs, with where their time goes.
    #[serde(default)]
    pub programs: Vec<ProgramFigures>,
    /// All checks passed.
    pub passed: bool,
}

/// Figures of one schedule; `constant_feed` are the rotary axis' greatest velocity and
/// acceleration, rad, at the programmed feed held constant.
pub fn schedule_figures(
    plan: &Plan,
    schedule: &Schedule,
    motion: &AxisMotion,
    constant_feed: [f64; 2],
    machine: &Machine,
) -> ScheduleFigures {
    let outside = schedule
        .theta
        .iter()
        .zip(&plan.channel.rows)
        .filter(|(t, r)| **t < r.theta_min - 1e-9 || **t > r.theta_max + 1e-9)
        .count();
    ScheduleFigures {
        kind: schedule.kind,
        reversals: schedule.reversals,
        outside_channel: outside,
        theta_rate_peak_deg_per_mm: schedule.peak_rate.to_degrees(),
        theta_acceleration_peak_deg_per_mm2: schedule.peak_acceleration.to_degrees(),
        machining_time_s: motion.time_s,
        axes: machine.peaks(motion),
        a_velocity_at_constant_feed_deg_s: constant_feed[0].to_degrees(),
        a_acceleration_at_constant_feed_deg_s2: constant_feed[1].to_degrees(),
    }
}

/// Figures of a path laid for comparison with the one whose figures are `used`.
pub fn path_figures(path: &Toolpath, limit: LimitFigures, used: &LimitFigures) -> PathFigures {
    let scale = if used.ridge_p99_mm > 0.0 { (limit.ridge_p99_mm / used.ridge_p99_mm).sqrt() } else { 1.0 };
    PathFigures {
        kind: path.kind,
        turns: path.turns.len(),
        path_length_mm: path.locations.last().map_or(0.0, |l| l.s_mm),
        limit,
        ratio_at_same_scallop: limit.ratio * scale,
    }
}

/// Figures of a run that was stopped after its path or later.
#[derive(Clone, Debug, PartialEq)]
pub struct StoppedFigures {
    /// Turns.
    pub turns: usize,
    /// Cutter locations.
    pub cutter_locations: usize,
    /// Heights of the first and last ball centre along the blade axis, mm.
    pub region_x_mm: [f64; 2],
    /// Length of the path of ball centres, mm.
    pub path_length_mm: f64,
    /// How wide the channel is; `None`: stopped before it.
    pub channel: Option<ChannelFigures>,
    /// Places where θ turns back; `None`: stopped before the schedule.
    pub reversals: Option<usize>,
}

/// Figures of what there is of a plan.
pub fn stopped(path: &Toolpath, channel: Option<&Channel>, schedule: Option<&Schedule>) -> StoppedFigures {
    StoppedFigures {
        turns: path.turns.len(),
        cutter_locations: path.locations.len(),
        region_x_mm: path.region_x_mm,
        path_length_mm: path.locations.last().map_or(0.0, |l| l.s_mm),
        channel: channel.map(channel_figures),
        reversals: schedule.map(|s| s.reversals),
    }
}

/// How wide a channel is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelFigures {
    /// Least width, degrees.
    pub narrowest_deg: f64,
    /// Cutter location of it.
    pub narrowest_row: usize,
    /// Least width of the monotone hull, degrees.
    pub monotone_deg: f64,
}

/// Least widths of a channel.
fn channel_figures(channel: &Channel) -> ChannelFigures {
    let widths = channel.rows.iter().map(|r| r.theta_max - r.theta_min).enumerate();
    let (narrowest_row, width) = widths.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
    let hull = channel.rows.get(channel.narrowest_row);
    let monotone_deg = hull.map_or(0.0, |r| (r.hull_max - r.hull_min).to_degrees());
    ChannelFigures { narrowest_deg: width.to_degrees(), narrowest_row, monotone_deg }
}

/// The summary of a checked plan.
pub fn summary(
    name: &str,
    plan: &Plan,
    report: &CheckReport,
    schedules: Vec<ScheduleFigures>,
    axes: &[Axis],
) -> Summary {
    let path = &plan.toolpath;
    let width = channel_figures(&plan.channel);
    Summary {
        name: name.into(),
        turns: path.turns.len(),
        cutter_locations: path.locations.len(),
        path_length_mm: path.locations.last().map_or(0.0, |l| l.s_mm),
        region_x_mm: path.region_x_mm,
        end_reason: path.end_reason.to_string(),
        machining_time_s: plan.motion.time_s,
        scallop_asked_mm: path.scallop_mm,
        stock_mm: path.stock_mm,
        scallop_planned_mm: path.planned_scallop_mm,
        scallop_max_mm: report.scallop_max_mm,
        scallop_p99_mm: report.scallop_p99_mm,
        scallop_p95_mm: report.scallop_p95_mm,
        scallop_p50_mm: report.scallop_p50_mm,
        scallop_p05_mm: report.scallop_p05_mm,
        disc_radius_mm: path.disc_radius_mm,
        limit: report.limit,
        other_paths: Vec::new(),
        uncut_area_mm2: report.uncut_area_mm2,
        uncut_height_mm: report.uncut_height_mm,
        gouge_mm: report.gouge_mm,
        clearance_mm: report.clearance_mm,
        channel_width_min_deg: width.narrowest_deg,
        channel_narrowest_row: width.narrowest_row,
        channel_monotone_min_deg: width.monotone_deg,
        axis_turning: plan.toolpath.axis_turning,
        schedules,
        smooth: smooth_figures(plan, axes),
        limits_assumed: Vec::new(),
        turning: report.turning,
        programs: Vec::new(),
        passed: report.passed(),
    }
}
