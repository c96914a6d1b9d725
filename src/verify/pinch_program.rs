//! A program of two tools, read back line by line and moved through the machine.
//!
//! What counts is where both tools stand after each line. Two programs for two channels are read
//! together as their wait marks lead them ([`channels`]).

use std::ops::Range;

use super::apart;
use super::clearance::{Track, kept};
use super::cuts::{self, EndWay};
use super::options::VerifyOptions;
use super::pinch::{PinchWork, clearance, tools_apart};
use super::pinch_channels as channels;
use super::sweep::Sweep;
use crate::artifact::paired::{Held, PinchMotion};
use crate::artifact::report::Check;
use crate::artifact::{AxisCheck, Blade, CheckId, Obstacle, PartAmong, Stand};
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::machine::{Machine, Pose};
use crate::numerics::angle::nearest_turn;
use crate::read::program::pinch::{Line, Read, read};
use crate::tool::{Tool, lowest_mm};

/// Ball centres may lie so far from their places, mm.
pub(super) const CENTRE_MM: f64 = 0.001;
/// Tool axes may be turned so far, degrees.
const AXIS_DEG: f64 = 0.001;
/// A line that brings both balls this near to a place is that place's, mm.
const MEANT_MM: f64 = 0.05;
/// Balls within lines may leave the straight way by this at least, mm: what four decimals round.
const ROUNDED_MM: f64 = 1e-4;
/// The times of lines may add up to so much more or less, as a share.
const TIME_SHARE: f64 = 1e-4;
/// Derivatives of an axis may be over their limits by so much, as a share.
const LIMIT_SHARE: f64 = 1e-6;
/// A table that turns by less stands still, rad.
const STILL: f64 = 1e-9;
/// Positions this far beyond a travel are rounding, mm and degrees.
const ROUNDING: f64 = 1e-5;

/// What a program of two tools was asked for, beside its places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinchAsked {
    /// The time that its stretches should take, s.
    pub cutting_s: f64,
    /// Speeds of both spindles, 1/min.
    pub spindle_rpm: [f64; 2],
    /// How far the control may leave the lines, mm.
    pub tolerance_mm: f64,
    /// How far two channels may be apart in time while both tools cut, s; `None`: not known.
    pub skew_s: Option<f64>,
}

/// Judges the text of a program of two tools: one, or one for each of two channels.
pub fn check_pinch_program(
    texts: &[&str],
    work: &PinchWork,
    machine: &Machine,
    asked: &PinchAsked,
    options: &VerifyOptions,
) -> Vec<Check> {
    let is_two = texts.len() == 2;
    let programs = match read_all(texts, machine) {
        Ok(programs) => programs,
        Err(note) => {
            return vec![Check::at_most(CheckId::ProgramReadable, "lines that cannot be read", 1.0, 0.0, "", note)];
        }
    };
    let mut checks = set(&programs, asked);
    let expected = Expected { stretches: Some(work.held.len()), skew_s: asked.skew_s };
    let (met, lines) = joined(&programs, expected, machine);
    checks.extend(met);
    let Some(lines) = lines else { return checks };
    let poses = poses_of(&lines, work.tools, machine);
    let found = matched(work, &lines, &poses);
    checks.extend(found.checks(&lines, asked.cutting_s));
    checks.push(within_lines(work, machine, &lines, &poses, &found));
    checks.push(rapids(work.tools, &lines, &poses, turning_mm(work.blade, work.obstacles, machine)));
    checks.push(travels(&lines, machine));
    checks.extend(ways(work, &poses, &found, options));
    if is_two && found.missing == 0 {
        checks.push(channels::rendezvous(work, &lines, &poses, &found.ways));
        // Where the table turns a lag has a limit, or it is a finding.
        let (turning, still): (Vec<_>, Vec<_>) =
            found.ways.iter().cloned().partition(|s| table_turns(&lines[s.clone()], machine));
        checks.push(channels::lagging((work.tools, work.tools_apart_mm), &poses, &still));
        if let Some(skew_s) = asked.skew_s.filter(|_| !turning.is_empty()) {
            checks.extend(skewed(work, machine, (&lines, &turning), skew_s, options));
        }
    }
    checks
}

/// Reads a program, or that of each of two channels.
///
/// # Errors
/// The line that cannot be read and what is wrong with it, in words.
pub(super) fn read_all(texts: &[&str], machine: &Machine) -> Result<Vec<Read>, String> {
    let is_two = texts.len() == 2;
    let one = |(k, text): (usize, &&str)| {
        let program = read(text, machine, is_two.then_some(k)).and_then(|p| match p.marks.first() {
            Some(mark) if !is_two => Err((mark.line, "it waits for another channel".into())),
            _ => Ok(p),
        });
        program.map_err(|(number, what)| {
            let of = if is_two { format!(" of channel {}", k + 1) } else { String::new() };
            format!("line {number}{of}: {what}")
        })
    };
    texts.iter().enumerate().map(one).collect()
}

/// What is known of two programs before they are read.
#[derive(Clone, Copy, Default)]
pub(super) struct Expected {
    /// Stretches; `None`: not known.
    pub stretches: Option<usize>,
    /// See [`PinchAsked`].
    pub skew_s: Option<f64>,
}

/// The lines of all programs in one order, `None` where channels never meet, and what was found
/// where they do.
pub(super) fn joined(programs: &[Read], expected: Expected, machine: &Machine) -> (Vec<Check>, Option<Vec<Line>>) {
    match programs {
        [one, two] => {
            let met = channels::meet([one, two], expected, machine);
            (met.checks, met.lines)
        }
        _ => (Vec::new(), Some(programs.iter().flat_map(|p| p.parts.iter().flatten().cloned()).collect())),
    }
}

/// Where both tools stand behind each line; `None` until the program has said where all axes are.
pub(super) fn poses_of(lines: &[Line], tools: [&Tool; 2], machine: &Machine) -> Vec<Option<[Pose; 2]>> {
    let gauges = tools.map(Tool::length_mm);
    let pose = |l: &Line| {
        let known = l.at.iter().all(|v| v.is_finite());
        let pose = |head: usize| machine.forward_of(head, &l.at, gauges[head]);
        Some([pose(0)?, pose(1)?]).filter(|_| known)
    };
    lines.iter().map(pose).collect()
}

/// What a program sets before it cuts, and that it ends.
fn set(programs: &[Read], asked: &PinchAsked) -> Vec<Check> {
    let unset: Vec<&str> = programs.iter().flat_map(|p| p.unset.iter().copied()).collect();
    // In two channels each has the spindle of its own tool.
    let spindles =
        [0, 1].map(|k| programs.get(k).or(programs.first()).map_or_else(Default::default, |p| p.spindles[k]));
    let wrong = |k: &usize| !spindles[*k].turns || (spindles[*k].rpm - asked.spindle_rpm[*k]).abs() > 1e-6;
    let wrong: Vec<String> = (0..2)
        .filter(wrong)
        .map(|k| match spindles[k] {
            s if !s.turns => format!("spindle {} stands", k + 1),
            s => format!("spindle {} turns at {}, asked for {}", k + 1, s.rpm, asked.spindle_rpm[k]),
        })
        .collect();
    let tolerance_mm = programs.iter().filter_map(|p| p.tolerance_mm).fold(0.0, f64::max);
    let open = programs.iter().filter(|p| !p.ends).count();
    let count = |id, quantity, n: usize, note| Check::at_most(id, quantity, n as f64, 0.0, "", note);
    vec![
        count(CheckId::ProgramFrame, "what is not set before the tools cut", unset.len(), unset.join(", ")),
        count(CheckId::ProgramSpindle, "spindles that do not turn as asked for", wrong.len(), wrong.join(", ")),
        Check::at_most(
            CheckId::ProgramSmoothing,
            "how far the control may leave the lines",
            tolerance_mm,
            asked.tolerance_mm,
            "mm",
            String::new(),
        ),
        count(CheckId::ProgramEnd, "programs without an end", open, String::new()),
    ]
}

/// Which lines are whose.
struct Matched {
    /// Lines of each stretch that was found: first to last.
    stretches: Vec<Range<usize>>,
    /// The same from the first line of the way down on.
    ways: Vec<Range<usize>>,
    places: usize,
    missing: usize,
    first_missing: Option<(usize, usize)>,
    centre_mm: (f64, usize),
    axis_deg: (f64, usize),
    /// Lines that cut and belong to no place.
    strays: Vec<usize>,
    seconds: f64,
}

/// Goes through the program and the places in step.
fn matched(work: &PinchWork, lines: &[Line], poses: &[Option<[Pose; 2]>]) -> Matched {
    let mut out = Matched {
        stretches: Vec::new(),
        ways: Vec::new(),
        places: 0,
        missing: 0,
        first_missing: None,
        centre_mm: (0.0, 0),
        axis_deg: (0.0, 0),
        strays: Vec::new(),
        seconds: 0.0,
    };
    let is_at = |k: usize, poses: &[Pose; 2]| {
        (0..2).all(|j| (poses[j].centre - work.rows.places[k].contacts[j].centre).norm() <= MEANT_MM)
    };
    let mut next = 0;
    for (n, held) in work.held.iter().enumerate() {
        let places = &held.places;
        let from = (next..lines.len())
            .find(|i| !lines[*i].is_rapid && poses[*i].as_ref().is_some_and(|p| is_at(places.start, p)));
        let Some(from) = from else {
            out.missing += places.len();
            out.first_missing = out.first_missing.or(Some((n, places.start)));
            continue;
        };
        let mut last = from;
        for (i, k) in (from..).zip(places.clone()) {
            let there = poses.get(i).and_then(Option::as_ref).filter(|p| !lines[i].is_rapid && is_at(k, p));
            let Some(there) = there else {
                out.missing += places.end - k;
                out.first_missing = out.first_missing.or(Some((n, k)));
                break;
            };
            last = i;
            out.places += 1;
            if k > places.start {
                out.seconds += lines[i].seconds.unwrap_or(f64::NAN);
            }
            for j in 0..2 {
                let off = (there[j].centre - work.rows.places[k].contacts[j].centre).norm();
                let axis = work.stand(held, k, j).axis();
                let turned = 2.0 * (0.5 * (there[j].axis - axis).norm()).min(1.0).asin().to_degrees();
                if off > out.centre_mm.0 {
                    out.centre_mm = (off, i);
                }
                if turned > out.axis_deg.0 {
                    out.axis_deg = (turned, i);
                }
            }
        }
        // The way down may slow on its way.
        let slows =
            |i: &usize| *i >= next && !lines[*i].is_rapid && poses[*i].as_ref().is_some_and(|p| is_over(work, held, p));
        out.ways.push(from.checked_sub(1).filter(slows).unwrap_or(from)..last + 1);
        out.stretches.push(from..last + 1);
        next = last + 1;
    }
    // What cuts besides: all that is no rapid, but the way down before a stretch and up behind it.
    let mut mine = vec![false; lines.len()];
    for s in &out.ways {
        mine[s.start..(s.end + 1).min(lines.len())].fill(true);
    }
    out.strays = (0..lines.len()).filter(|i| !lines[*i].is_rapid && !mine[*i]).collect();
    out
}

/// Whether both tools stand on their own axes over the first place of a stretch.
fn is_over(work: &PinchWork, held: &Held, poses: &[Pose; 2]) -> bool {
    (0..2).all(|j| off_axis_mm(&work.stand(held, held.places.start, j), &poses[j]) <= CENTRE_MM)
}

/// How far a tool is beside the axis along which it goes down to a place and up from it, mm; ∞
/// where it is not over the place.
pub(super) fn off_axis_mm(place: &Stand, pose: &Pose) -> f64 {
    let (axis, way) = (place.axis(), pose.centre - place.centre);
    if way.dot(&axis) > 0.0 { way.cross(&axis).norm() } else { f64::INFINITY }
}

impl Matched {
    fn checks(&self, lines: &[Line], cutting_s: f64) -> Vec<Check> {
        let named = |i: usize| lines.get(i).map_or_else(String::new, Line::named);
        let left = match self.first_missing {
            Some((stretch, place)) => format!("the first is place {place} of stretch {}", stretch + 1),
            None => format!("{} places", self.places),
        };
        let stray = self.strays.first().map_or_else(String::new, |i| format!("the first is {}", named(*i)));
        let off = if cutting_s > 0.0 { (self.seconds / cutting_s - 1.0).abs() } else { 0.0 };
        vec![
            Check::at_most(
                CheckId::ProgramMissing,
                "places that the program does not come by in order",
                self.missing as f64,
                0.0,
                "",
                left,
            ),
            Check::at_most(
                CheckId::ProgramReadable,
                "lines that cut at no place",
                self.strays.len() as f64,
                0.0,
                "",
                stray,
            ),
            Check::at_most(
                CheckId::ProgramCentre,
                "distance of both ball centres from their places",
                self.centre_mm.0,
                CENTRE_MM,
                "mm",
                named(self.centre_mm.1),
            ),
            Check::at_most(
                CheckId::ProgramDirection,
                "angle of both tool axes from where they should be",
                self.axis_deg.0,
                AXIS_DEG,
                "deg",
                named(self.axis_deg.1),
            ),
            Check::at_most(
                CheckId::ProgramTime,
                "times of the lines that cut against the motion, as a share",
                off,
                TIME_SHARE,
                "",
                format!("{:.3} s, planned {cutting_s:.3} s", self.seconds),
            ),
        ]
    }
}

/// The table turns within these lines.
fn table_turns(lines: &[Line], machine: &Machine) -> bool {
    let k = machine.turning_axis();
    lines.windows(2).any(|w| !((w[1].at[k] - w[0].at[k]).abs() <= STILL))
}

/// Two channels that are apart by so much: where the table turns, the second tool is beside its
/// place then. Its ball and the rest of it to the part, and both tools to each other, with channel
/// 1 before channel 2 and behind it, by all of the skew and by half.
fn skewed(
    work: &PinchWork,
    machine: &Machine,
    (lines, stretches): (&[Line], &[Range<usize>]),
    skew_s: f64,
    options: &VerifyOptions,
) -> Vec<Check> {
    let gauges = work.tools.map(Tool::length_mm);
    let (mut stands, mut wanted): ([Vec<Stand>; 2], Vec<bool>) = Default::default();
    for (by_s, own) in [-1.0, -0.5, 0.5, 1.0].iter().flat_map(|by| stretches.iter().map(move |s| (by * skew_s, s))) {
        // Tool by tool as they stand in the part; the table goes with channel 1.
        let rows = channels::apart_in_time(&lines[own.clone()], machine, by_s);
        let mut last = [None::<f64>; 2];
        for at in rows {
            for j in 0..2 {
                let Some(pose) = machine.forward_of(j, &at, gauges[j]) else { continue };
                let theta = pose.axis.z.atan2(pose.axis.y);
                let theta = last[j].map_or(theta, |last| nearest_turn(theta, last));
                last[j] = Some(theta);
                stands[j].push(Stand { centre: pose.centre, cone: work.cones[j], theta });
            }
            wanted.push(true);
        }
        if let Some(end) = wanted.last_mut() {
            *end = false;
        }
    }
    if stands[1].len() < 2 || stands[0].len() != stands[1].len() {
        return Vec::new();
    }
    wanted.pop();
    let of = format!("tool 2, channels {:.3} ms apart: ", 1e3 * skew_s);
    let name = |check: Check| Check { quantity: format!("{of}{}", check.quantity), row: None, turn: None, ..check };
    let centres: Vec<Point> = stands[1].iter().map(|s| s.centre).collect();
    let turns = vec![0; centres.len()];
    let sweep = Sweep::of(centres.clone(), centres, turns, work.tools[1].radius_mm, Some(wanted.clone()));
    let part = Allowed::new(&work.blade.part, work.rows.stock_mm);
    let mut checks = vec![name(cuts::check(work.blade, &part, &EndWay::of_ball(&sweep), options))];
    let track = Track { stands: &stands[1], wanted: Some(&wanted) };
    for a in apart(work.blade, work.obstacles, work.tools[1], options) {
        checks.push(name(clearance(&a, track, work.blade, options)));
    }
    let (least_mm, _) = tools_apart(work.tools, [&stands[0], &stands[1]], &wanted);
    let quantity = "least distance of the two tools";
    let note = format!("asked for {}", work.tools_apart_mm);
    let check = Check::at_most(CheckId::ToolsApart, quantity, least_mm, work.tools_apart_mm, "mm", note);
    checks.push(name(Check { passed: least_mm >= work.tools_apart_mm, ..check }));
    checks
}

/// How far balls leave the straight line from place to place, where axes go straight: at the middle
/// of each line that cuts.
fn within_lines(
    work: &PinchWork,
    machine: &Machine,
    lines: &[Line],
    poses: &[Option<[Pose; 2]>],
    found: &Matched,
) -> Check {
    let (mut worst_mm, mut at) = (0.0, 0);
    let gauges = work.tools.map(Tool::length_mm);
    for i in found.stretches.iter().flat_map(|s| s.start + 1..s.end) {
        let axes = machine.axes();
        let middle = |(k, (a, b)): (usize, (&f64, &f64))| {
            0.5 * (a + if axes[k].is_rotary() { nearest_turn(*b, *a) } else { *b })
        };
        let middle: Vec<f64> = lines[i - 1].at.iter().zip(lines[i].at.iter()).enumerate().map(middle).collect();
        for j in 0..2 {
            let ends = [i - 1, i].map(|i| poses[i].map(|p| p[j].centre));
            let [Some(a), Some(b)] = ends else { continue };
            let there = machine.forward_of(j, &middle, gauges[j]);
            let off_mm = there.map_or(f64::INFINITY, |p| (p.centre - nalgebra::center(&a, &b)).norm());
            if !(off_mm <= worst_mm) {
                (worst_mm, at) = (off_mm, i);
            }
        }
    }
    let named = lines.get(at).map_or_else(String::new, Line::named);
    let limit_mm = work.rows.chord_mm.max(ROUNDED_MM);
    Check::at_most(
        CheckId::ProgramChord,
        "ball centres within a line off the straight way",
        worst_mm,
        limit_mm,
        "mm",
        named,
    )
}

/// How far a tool stays over the blade axis on its own side, mm: of all its points the lowest along
/// the part of its axis that is square to the blade's.
fn height_mm(tool: &Tool, pose: &Pose) -> f64 {
    let out = Vector::new(0.0, pose.axis.y, pose.axis.z).try_normalize(1e-9).unwrap_or_default();
    lowest_mm(&tool.segments(), tool.radius_mm, &pose.centre, &pose.axis, &out)
}

/// The height over the blade axis, mm, beyond which nothing is that turns with the table: the
/// greatest distance of a point of the part and what stands about it from the table's axis, and
/// that of the blade axis.
pub(super) fn turning_mm(blade: &Blade, obstacles: &[Obstacle], machine: &Machine) -> f64 {
    let part = PartAmong { blade, obstacles };
    machine.turns_within_mm(&part).unwrap_or(f64::INFINITY)
}

/// In rapids both tools stay over what the part turns in: axes that go straight keep a tool over a
/// plane that it is over at both ends, and the part turns under that plane.
pub(super) fn rapids(tools: [&Tool; 2], lines: &[Line], poses: &[Option<[Pose; 2]>], turning_mm: f64) -> Check {
    let (mut least, mut at) = (f64::INFINITY, None);
    for i in (0..lines.len()).filter(|i| lines[*i].is_rapid) {
        let ends = [i.checked_sub(1).and_then(|b| poses[b]), poses[i]];
        for pose in ends.into_iter().flatten() {
            for j in 0..2 {
                let height = height_mm(tools[j], &pose[j]);
                if height < least {
                    (least, at) = (height, Some(i));
                }
            }
        }
    }
    let quantity = "least height of both tools over the blade axis in rapids";
    Check {
        passed: least >= turning_mm,
        ..Check::at_most(
            CheckId::ProgramRapids,
            quantity,
            least,
            turning_mm,
            "mm",
            format!("{}; the part turns within {turning_mm:.3} mm", at.map_or_else(String::new, |i| lines[i].named())),
        )
    }
}

pub(super) fn travels(lines: &[Line], machine: &Machine) -> Check {
    let (mut worst, mut where_) = (0.0, String::new());
    for l in lines {
        for (axis, at) in machine.axes().iter().zip(l.at.iter()) {
            let Some([least, most]) = axis.limits.travel else { continue };
            let beyond = axis.shown((least - at).max(at - most));
            if beyond > worst {
                (worst, where_) = (beyond, format!("{} in {}", axis.name, l.named()));
            }
        }
    }
    Check::at_most(
        CheckId::ProgramTravel,
        "positions beyond the travel of an axis",
        worst,
        ROUNDING,
        "mm or deg",
        where_,
    )
}

/// Velocity, acceleration and jerk of all axes at the places of all stretches, against their
/// limits.
pub fn check_pinch_motion(motion: &PinchMotion, machine: &Machine) -> Vec<Check> {
    let kinds = [AxisCheck::Velocity, AxisCheck::Acceleration, AxisCheck::Jerk];
    let mut checks = Vec::new();
    for (k, axis) in machine.axes().iter().enumerate() {
        for (kind, what) in kinds.into_iter().enumerate() {
            let limit = [axis.limits.velocity, axis.limits.acceleration, axis.limits.jerk][kind];
            let (mut worst, mut row) = (0.0f64, 0);
            for s in &motion.stretches {
                let rows = [&s.motion.velocity, &s.motion.acceleration, &s.motion.jerk][kind];
                let most = rows.iter().map(|r| r[k].abs()).fold(0.0, f64::max);
                if !(most <= worst) {
                    (worst, row) = (most, s.row);
                }
            }
            let unit = format!("{}/s{}", axis.unit(), ["", "²", "³"][kind]);
            let quantity =
                format!("{} of {} while both tools cut", ["velocity", "acceleration", "jerk"][kind], axis.name);
            let limit = axis.shown(limit) * (1.0 + LIMIT_SHARE);
            checks.push(Check::at_most(
                CheckId::axis(&axis.name, what),
                &quantity,
                axis.shown(worst),
                limit,
                &unit,
                format!("row {}", row + 1),
            ));
        }
    }
    checks
}

/// The ways down to each stretch and up from it: ball and tool against the part.
fn ways(work: &PinchWork, poses: &[Option<[Pose; 2]>], found: &Matched, options: &VerifyOptions) -> Vec<Check> {
    let mut checks = Vec::new();
    for j in 0..2 {
        let (mut centres, mut stands, mut wanted): (Vec<Point>, Vec<Stand>, Vec<bool>) = Default::default();
        for (s, way) in found.stretches.iter().zip(&found.ways) {
            // Down from the line before, and up to the line behind.
            let down = (way.start..s.start + 1).map(|i| [i.checked_sub(1), Some(i)]);
            for ends in down.chain([[s.end.checked_sub(1), Some(s.end)]]) {
                let pose = |i: Option<usize>| poses.get(i?).copied().flatten().map(|p| p[j]);
                let (Some(a), Some(b)) = (pose(ends[0]), pose(ends[1])) else { continue };
                let over = a.axis.z.atan2(a.axis.y);
                for (pose, counts) in [(a, true), (b, false)] {
                    let theta = nearest_turn(pose.axis.z.atan2(pose.axis.y), over);
                    centres.push(pose.centre);
                    stands.push(Stand { centre: pose.centre, cone: work.cones[j], theta });
                    wanted.push(counts);
                }
            }
        }
        if centres.len() < 2 {
            continue;
        }
        wanted.pop();
        let name = |check: Check, id: CheckId| Check {
            quantity: format!("tool {}, ways to and from rows: {}", j + 1, check.quantity),
            id,
            row: None,
            turn: None,
            ..check
        };
        let sweep =
            Sweep::of(centres.clone(), centres, vec![0; stands.len()], work.tools[j].radius_mm, Some(wanted.clone()));
        let part = Allowed::new(&work.blade.part, work.rows.stock_mm);
        checks.push(name(cuts::check(work.blade, &part, &EndWay::of_ball(&sweep), options), CheckId::LeadGouge));
        let track = Track { stands: &stands, wanted: Some(&wanted) };
        for a in apart(work.blade, work.obstacles, work.tools[j], options) {
            let limit = options.least_clearance(a.asked_mm);
            let near = kept(track, a.part, &a.segments, limit, options);
            let id = match (a.obstacle, a.is_holder) {
                (Some(_), _) => CheckId::LeadObstacle,
                (None, true) => CheckId::LeadHolderClearance,
                (None, false) => CheckId::LeadClearance,
            };
            let check = Check::at_most(
                id.clone(),
                "least distance of the tool without its ball",
                near.least_mm,
                limit,
                "mm",
                a.named(near.face),
            );
            checks.push(name(Check { passed: near.least_mm >= limit, ..check }, id));
        }
    }
    checks
}
