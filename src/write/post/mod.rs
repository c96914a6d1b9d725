//! NC programs from checked plans.
//!
//! **In**: a [`Verified`] plan, the blade, the tool, the machine, a [`Dialect`]. **Out**: a
//! [`Program`], plain ASCII text.
//!
//! A dialect is a *post file* (TOML, [`PostFile`]): fifteen are built in
//! ([`crate::artifact::program::Control`]), an own one needs no recompiling. Three kinds of
//! coordinates cover them: the tool tip or the ball centre in the blade frame, for controls with
//! tool-centre-point control, or positions of the machine's axes. With `B` fixed the tool axis lies
//! on a cone, so rotary axes are written as positions where there is a choice; vectors are written
//! for controls that turn them into rotary positions line by line.
//!
//! ## Feed
//! Where the control knows inverse time, every cutting line carries `F = 1 / Δt` (`G93`, 1/min)
//! with `Δt` from the plan's times, so that the control needs no notion of what a feed means for a
//! line that turns and moves at once. Otherwise F is the way of the programmed point, as it is
//! rounded, over `Δt`. Where `Δt` is shorter than the control can read, moves are joined as long as
//! the chord tolerance is kept, and where it would not be, that is an error: time is never
//! stretched in silence.
//!
//! ## Approach and retract
//! On the plan's leads, tangential to the path ([`crate::artifact::Lead`]), at the plan's times:
//! they are written like cuts. Before and after them, or from and to the path itself where there is
//! no room for an arc, straight along the tool axis, from and to a distance at which a plane
//! perpendicular to the tool axis separates the whole tool from a sphere around the part and what
//! stands about it, centred on the axis of `A`: there `A` may turn freely. The way is clear
//! wherever the tool is clear at its end, because the tool nowhere narrows towards the spindle
//! (where a holder does, the header says so) and because the ball leaves its contact at once
//! (contact below the ball's equator: checked). Between the equator and a taper that leaves the
//! ball at half angle τ the swept ball is at most `R (1 − cos τ)` wider than the tool itself, which
//! is less than any sensible clearance.
//!
//! ## Several operations
//! [`join`] writes finished plans one after another, each whole: a program of operations is as true
//! as its parts, and the moves between them are those of every beginning and end.
//!
//! Limits: no tool radius compensation. [`crate::verify::read_back`] reads every program back.

mod cycle;
mod dialect;
mod fixed;
mod merge;
mod moves;
mod nurbs;
pub mod pinch;
mod pinch_text;
mod polynomial;
mod settings;
mod smoothing;
mod spline;
mod template;
#[cfg(test)]
mod tests;
mod text;
mod turn_in;
mod write;

pub use dialect::{Dialect, FeedWord, Numbered, Numbering, Numbers, PostFile, Rotary, Text};
pub use pinch_text::{PINCH_KEYS, PinchText};
pub use settings::{PostKeys, PostSettings};

use std::borrow::Cow;

use crate::artifact::program::Programmed;
use crate::artifact::{Axes, Blade, CheckReport, PartAmong, Plan, Program, Stand};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::settings::with_settings;
use crate::tool::Tool;
use crate::verify::{self, Verified};

/// Room before an end of travel for the rounding of words, mm.
const ROUNDING_MM: f64 = 1e-3;

/// What a program says beyond its positions.
#[derive(Clone, Debug, PartialEq)]
pub struct PostOptions {
    /// Name of the program, for its header.
    pub program_name: String,
    /// File of the part, for the header.
    pub part_file: String,
    /// Hash of that file, for the header.
    pub part_hash: String,
    /// The job, for the header: its file or what else names it.
    pub job: String,
    /// What the job says of them; which dialects there are is decided by the caller.
    pub settings: PostSettings,
    /// Tolerance the control may smooth the tool axis by, degrees. Default 0.05.
    pub smoothing_axis_deg: f64,
    /// Begin with this turn, from 1, to go on after a break; `None`: with the first.
    pub from_turn: Option<usize>,
    /// Which blade of the wheel it is, from 1, and how many there are, where each is machined.
    pub blade: Option<[u32; 2]>,
}

with_settings!(PostOptions, PostSettings);

impl Default for PostOptions {
    fn default() -> Self {
        PostOptions {
            program_name: "BLADE".into(),
            part_file: String::new(),
            part_hash: String::new(),
            job: String::new(),
            settings: PostSettings::default(),
            smoothing_axis_deg: 0.05,
            from_turn: None,
            blade: None,
        }
    }
}

impl PostOptions {
    fn validate(&self) -> Result<()> {
        self.settings.check(Stage::Post)?;
        let axis_deg = self.smoothing_axis_deg;
        if axis_deg > 0.0 && axis_deg.is_finite() {
            return Ok(());
        }
        let message = format!("post.smoothing_axis_deg is {axis_deg}, it must be greater than 0");
        Err(Error::usage(Stage::Post, message))
    }
}

/// The plan that a program is written from: the whole, or what is left of it from a turn on.
///
/// # Errors
/// `Usage` where there is no such turn.
pub fn planned<'a>(plan: &'a Plan, options: &PostOptions) -> Result<Cow<'a, Plan>> {
    let Some(turn) = options.from_turn else { return Ok(Cow::Borrowed(plan)) };
    // Locations keep the numbers of their turns: what has been cut off already, with a lead-in of
    // its own, stays as it is.
    if turn > 1 && plan.toolpath.locations.first().is_some_and(|l| l.turn as usize + 1 == turn) {
        return Ok(Cow::Borrowed(plan));
    }
    let left = turn.checked_sub(1).and_then(|t| plan.from_turn(t));
    left.map(Cow::Owned).ok_or_else(|| {
        let turns = plan.toolpath.turns.len();
        Error::usage(Stage::Post, format!("there is no turn {turn}, the plan has turns 1 to {turns}"))
    })
}

/// Writes a checked plan in a dialect.
///
/// # Errors
/// `Usage` where an option is out of range or the plan is none (no locations, rows that do not
/// match, numbers that are not finite, times that do not grow) or a block is too long; `Infeasible`
/// where the contact at an end of the path lies above the ball's equator, so that the tool cannot
/// leave along its axis.
pub fn post<'a>(
    dialect: &Dialect,
    plan: &Verified<Plan>,
    part: impl Into<PartAmong<'a>>,
    tool: &Tool,
    machine: &Machine,
    options: &PostOptions,
) -> Result<Program> {
    join(dialect, &[Operation { plan, tool, options }], 1, part, machine)
}

/// A checked plan with its tool, as one of several of a program.
#[derive(Clone, Copy)]
pub struct Operation<'a> {
    /// The plan.
    pub plan: &'a Verified<Plan>,
    /// Its tool.
    pub tool: &'a Tool,
    /// What the program says of it.
    pub options: &'a PostOptions,
}

/// Writes checked plans of one part on one machine as one program: each with its header, tool call,
/// approach, retract and unwinding. Operations are numbered from `first`; that of a program which
/// goes on after a break is not 1.
///
/// # Errors
/// Those of [`post`] of each; `Usage` where there is none, or two with the same tool number have
/// different tools.
pub fn join<'a>(
    dialect: &Dialect,
    operations: &[Operation],
    first: usize,
    part: impl Into<PartAmong<'a>>,
    machine: &Machine,
) -> Result<Program> {
    let part = part.into();
    different_tools_have_different_numbers(operations)?;
    let of_lathe = machine.axes().iter().find_map(|axis| match axis {
        axis if axis.is_missing => Some(format!("has no {}", axis.name)),
        axis if axis.counts_diameter => Some(format!("counts diameters in {}", axis.name)),
        _ => None,
    });
    if let Some(what) = of_lathe.filter(|_| dialect.language().programmed != Programmed::Machine) {
        let message = format!(
            "{} programs places over the part, for which a control moves X, Y and Z together: the machine {} {what}",
            dialect.file.name, machine.name
        );
        return Err(Error::usage(Stage::Post, message)
            .advise("set post.control to siemens-axes, fanuc-axes, linuxcnc or iso, which name positions of axes"));
    }
    let written: Vec<Cow<Plan>> =
        operations.iter().map(|o| planned(o.plan.value(), o.options)).collect::<Result<_>>()?;
    let mut runs = Vec::with_capacity(operations.len());
    for (k, (o, plan)) in operations.iter().zip(&written).enumerate() {
        o.options.validate()?;
        o.tool.validate()?;
        runs.push(OperationRun {
            number: first + k,
            plan,
            report: o.plan.report(),
            forced: o.plan.forced(),
            blade: part.blade,
            tool: o.tool,
            machine,
            options: o.options,
            ends: ends(plan, &part, o.tool, machine, o.options)?,
        });
    }
    let Some(start) = runs.first() else {
        return Err(Error::usage(Stage::Post, "there is no operation to write"));
    };
    let on_curve = written.iter().any(|p| p.curve.is_some());
    let finer = if on_curve { dialect.on_curve() } else { Cow::Borrowed(dialect) };
    let dialect: &Dialect = &finer;
    let mut file_name = dialect.file_name().to_owned();
    if let Some(turn) = start.options.from_turn {
        file_name = format!("from_turn_{turn}.{file_name}");
    }
    if first > 1 {
        file_name = format!("from_operation_{first}.{file_name}");
    }
    let (language, (text, cut_lines)) = (dialect.language(), write::write(&runs, dialect)?);
    let written = runs.iter().map(|r| (r.options.settings.tool_number, r.options.settings.spindle_rpm));
    let asked = verify::read_back::asked(&text, language, written);
    Ok(Program {
        control: dialect.file.name.clone(),
        file_name,
        language,
        ranges: dialect.file.ranges.clone(),
        cycles: runs.iter().map(|run| cycle::time(run, dialect)).collect(),
        text,
        cut_lines,
        asked,
    })
}

fn different_tools_have_different_numbers(operations: &[Operation]) -> Result<()> {
    for (i, a) in operations.iter().enumerate() {
        for (j, b) in operations.iter().enumerate().skip(i + 1) {
            if a.options.settings.tool_number == b.options.settings.tool_number && a.tool != b.tool {
                let number = a.options.settings.tool_number;
                let what = format!("operations {} and {} have different tools but both call T{number}", i + 1, j + 1);
                return Err(Error::usage(Stage::Post, what).advise("set post.tool_number in the job of one of them"));
            }
        }
    }
    Ok(())
}

/// Everything a dialect needs for an operation.
struct OperationRun<'a> {
    /// Its number in the program, from 1.
    number: usize,
    plan: &'a Plan,
    report: &'a CheckReport,
    forced: bool,
    blade: &'a Blade,
    tool: &'a Tool,
    machine: &'a Machine,
    options: &'a PostOptions,
    ends: [WayEnd; 2],
}

/// Where the straight way along the tool axis begins or ends: the outer end of the lead, or the
/// first or last location.
#[derive(Clone, Copy, Debug)]
struct WayEnd {
    /// Where the tool stands there.
    stand: Stand,
    /// Where the axes stand at the location beside it.
    near: Axes,
    /// Distance of the safe position along the tool axis, mm.
    safe_mm: f64,
    /// At the safe position the part may turn freely; false where the machine's travel ends before.
    clear: bool,
}

impl OperationRun<'_> {
    /// Axis positions with the ball centre `lift_mm` along the tool axis over an end of the path.
    fn axes_at(&self, end: &WayEnd, lift_mm: f64) -> Axes {
        self.machine.place(&end.stand.lifted(lift_mm), Some(&end.near), self.tool.length_mm())
    }

    /// The end of travel that programs retract to.
    fn safe_up(&self) -> f64 {
        let (up, sense) = self.machine.retract_axis();
        let here = self.axes_at(&self.ends[0], self.ends[0].safe_mm)[up];
        self.machine.axes()[up].limits.travel.map_or(here, |[least, most]| if sense < 0.0 { least } else { most })
    }

    /// Column of the axis that programs retract by.
    fn up(&self) -> usize {
        self.machine.retract_axis().0
    }

    /// One rotary axis alone turns while the tool is on the path: it turns the blade, and all tool
    /// axes are on one cone about that.
    fn turns_the_blade_alone(&self) -> bool {
        self.machine.turns_the_blade() && self.plan.toolpath.cones.same().is_some_and(|c| c.is_about_blade())
    }
    /// Height of the feed height, never over the safe position.
    fn feed_height(&self, end: &WayEnd) -> f64 {
        self.options.settings.feed_height_mm.min(end.safe_mm)
    }
}

/// The outer ends of the leads, or first and last location where they are straight, with their safe
/// positions.
fn ends(plan: &Plan, part: &PartAmong, tool: &Tool, machine: &Machine, options: &PostOptions) -> Result<[WayEnd; 2]> {
    moves::well_formed(plan)?;
    let sphere = sphere_on_axis(part, machine);
    let end = |row: usize, name: &str, outer: Option<Stand>| -> Result<WayEnd> {
        let at = plan.toolpath.locations.get(row).zip(plan.stand(row)).zip(plan.motion.position.get(row));
        let Some(((at, foot), near)) = at else {
            return Err(Error::usage(Stage::Post, format!("the plan has no location {row}")));
        };
        let stand = outer.unwrap_or(foot);
        let axis = stand.axis();
        let up = at.normal.dot(&axis);
        if up < -1e-6 && outer.is_none() {
            let above_equator_deg = up.clamp(-1.0, 1.0).asin().abs().to_degrees();
            return Err(Error::infeasible(
                Stage::Post,
                format!(
                    "at the {name} location the contact lies {above_equator_deg:.3} deg above the ball's equator, so the tool cannot \
                     leave along its axis"
                ),
                Infeasible::CannotLeave {
                    end: name.into(),
                    at: plan.toolpath.along(row),
                    above_equator_deg,
                },
            )
            .advise("lower channel.contact_angle_max_deg to at most 90"));
        }
        let over =
            (sphere.0 - stand.centre).dot(&axis) + sphere.1 + tool.radius_mm + options.settings.safe_clearance_mm;
        let wanted = over.max(options.settings.safe_clearance_mm);
        let gauge = tool.length_mm();
        let reach = travel_along(machine, &stand, near, gauge);
        Ok(WayEnd { stand, near: near.into(), safe_mm: wanted.min(reach), clear: wanted <= reach })
    };
    let last = plan.toolpath.locations.len().saturating_sub(1);
    let [before, after] = &plan.leads;
    Ok([
        end(0, "first", before.stands(plan.toolpath.cone(0)).next())?,
        end(last, "last", after.stands(plan.toolpath.cone(last)).last())?,
    ])
}

/// Centre and radius of a sphere around the part and what stands about it. The centre is on the
/// axis that turns them, so turning maps the sphere onto itself; on the blade axis where none does.
fn sphere_on_axis(part: &PartAmong, machine: &Machine) -> (Point, f64) {
    let points: Vec<&Point> = part.bodies().flat_map(|b| &b.mesh.points).collect();
    let (foot, along) = machine.turning_line().unwrap_or((Point::origin(), Vector::x()));
    let heights = points.iter().map(|p| (*p - foot).dot(&along));
    let (lo, hi) = heights.fold((f64::MAX, f64::MIN), |(lo, hi), h| (lo.min(h), hi.max(h)));
    let centre = foot + along * if points.is_empty() { 0.0 } else { 0.5 * (lo + hi) };
    (centre, points.iter().map(|p| (*p - centre).norm()).fold(0.0, f64::max))
}

/// How far the tool can go along its axis from a location before a linear axis meets the end of its
/// travel, mm.
fn travel_along(machine: &Machine, stand: &Stand, near: &[f64], gauge: f64) -> f64 {
    let [from, to] = [*stand, stand.lifted(1.0)].map(|s| machine.place(&s, Some(near), gauge));
    let mut reach = f64::INFINITY;
    for i in machine.linear() {
        let (Some([lo, hi]), rate) = (machine.axes()[i].limits.travel, to[i] - from[i]) else { continue };
        if rate.abs() > 1e-9 {
            let room = if rate > 0.0 { hi - from[i] } else { lo - from[i] };
            reach = reach.min((room / rate - ROUNDING_MM).max(0.0));
        }
    }
    reach
}
