//! A program of two tools, read back line by line and moved through the machine.
//!
//! The reader is apart from the writer: it knows the words of such a program, and refuses every
//! other. What counts is where both tools stand after each line.

use std::ops::Range;

use super::clearance::{Track, kept};
use super::options::VerifyOptions;
use super::pinch::PinchWork;
use super::sweep::Sweep;
use super::{apart, gouge};
use crate::artifact::paired::PinchMotion;
use crate::artifact::report::Check;
use crate::artifact::{Axes, AxisCheck, CheckId, PartAmong, Stand};
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::machine::{Machine, Pose};
use crate::numerics::angle::nearest_turn;
use crate::tool::{Tool, lowest_mm};

/// Ball centres may lie so far from their places, mm.
const CENTRE_MM: f64 = 0.001;
/// Tool axes may be turned so far, degrees.
const AXIS_DEG: f64 = 0.001;
/// A line that brings both balls this near to a place is that place's, mm.
const MEANT_MM: f64 = 0.05;
/// The times of lines may add up to so much more or less, as a share.
const TIME_SHARE: f64 = 1e-4;
/// Derivatives of an axis may be over their limits by so much, as a share.
const LIMIT_SHARE: f64 = 1e-6;
/// Positions this far beyond a travel are rounding, mm and degrees.
const ROUNDING: f64 = 1e-5;

/// What a line does.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    number: usize,
    is_rapid: bool,
    /// Time that it asks for, s; `None`: it has a feed or is a rapid.
    seconds: Option<f64>,
    /// Where all axes stand behind it, mm and rad; those not yet named are not numbers.
    at: Axes,
}

/// Reads a program; the text of the first line that cannot be read in its place.
fn read(text: &str, machine: &Machine) -> Result<Vec<Line>, (usize, String)> {
    let axes = machine.axes();
    let mut at = Axes::from_fn(axes.len(), |_| f64::NAN);
    let (mut rapid, mut inverse, mut out) = (true, false, Vec::new());
    for (number, line) in (1..).zip(text.lines()) {
        let code = line.split([';', '(']).next().unwrap_or_default().trim();
        if code.is_empty() || code == "%" {
            continue;
        }
        let wrong = |what: &str| (number, format!("{what} in `{}`", line.chars().take(80).collect::<String>()));
        let (mut moves, mut feed) = (false, None);
        for word in code.split_whitespace() {
            let mut rest = word.chars();
            let letter = rest.next().unwrap_or(' ');
            let value: f64 = rest.as_str().parse().map_err(|_| wrong("a word without a number"))?;
            match letter {
                'G' if value == 0.0 => rapid = true,
                'G' if value == 1.0 => rapid = false,
                'G' if value == 93.0 => inverse = true,
                'G' if value == 94.0 => inverse = false,
                'G' if [17.0, 21.0, 40.0, 49.0, 53.0, 54.0, 64.0, 80.0, 90.0].contains(&value) => {}
                'M' if [2.0, 3.0, 4.0, 5.0, 8.0, 9.0].contains(&value) => {}
                'S' | 'P' | '$' => {}
                'F' => feed = Some(value),
                _ => {
                    let Some(k) = axes.iter().position(|a| a.name.len() == 1 && a.name.starts_with(letter)) else {
                        return Err(wrong(&format!("the word {letter}")));
                    };
                    let value = value / axes[k].word_per_mm();
                    at[k] = if axes[k].is_rotary() { value.to_radians() } else { value };
                    moves = true;
                }
            }
        }
        if !moves {
            continue;
        }
        let seconds = match (rapid, inverse, feed) {
            (false, true, Some(f)) if f > 0.0 => Some(60.0 / f),
            (false, true, _) => return Err(wrong("G93 asks for F over 0 on each line")),
            _ => None,
        };
        out.push(Line { number, is_rapid: rapid, seconds, at });
    }
    Ok(out)
}

/// Judges the text of a program of two tools; `cutting_s`: the time that its stretches should take.
pub fn check_pinch_program(
    text: &str,
    work: &PinchWork,
    machine: &Machine,
    cutting_s: f64,
    options: &VerifyOptions,
) -> Vec<Check> {
    let lines = match read(text, machine) {
        Ok(lines) => lines,
        Err((number, what)) => {
            let note = format!("line {number}: {what}");
            return vec![Check::at_most(CheckId::ProgramReadable, "lines that cannot be read", 1.0, 0.0, "", note)];
        }
    };
    let gauges = work.tools.map(Tool::length_mm);
    let poses: Vec<Option<[Pose; 2]>> = lines
        .iter()
        .map(|l| {
            let known = l.at.iter().all(|v| v.is_finite());
            let pose = |head: usize| machine.forward_of(head, &l.at, gauges[head]);
            Some([pose(0)?, pose(1)?]).filter(|_| known)
        })
        .collect();
    let found = matched(work, &lines, &poses);
    let mut checks = found.checks(&lines, cutting_s);
    checks.push(rapids(work, &lines, &poses, turning_mm(work, machine)));
    checks.push(travels(&lines, machine));
    checks.extend(ways(work, &poses, &found, options));
    checks
}

/// Which lines are whose.
struct Matched {
    /// Lines of each stretch that was found: first to last.
    stretches: Vec<Range<usize>>,
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
    for (n, (places, theta)) in work.held.iter().enumerate() {
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
                let over = if j == 0 { 0.0 } else { work.between_rad };
                let axis = work.cones[j].tool_axis(theta + over);
                let turned = 2.0 * (0.5 * (there[j].axis - axis).norm()).min(1.0).asin().to_degrees();
                if off > out.centre_mm.0 {
                    out.centre_mm = (off, i);
                }
                if turned > out.axis_deg.0 {
                    out.axis_deg = (turned, i);
                }
            }
        }
        out.stretches.push(from..last + 1);
        next = last + 1;
    }
    // What cuts besides: all that is no rapid, but the way down before a stretch and up behind it.
    let mut mine = vec![false; lines.len()];
    for s in &out.stretches {
        mine[s.start..(s.end + 1).min(lines.len())].fill(true);
    }
    out.strays = (0..lines.len()).filter(|i| !lines[*i].is_rapid && !mine[*i]).collect();
    out
}

impl Matched {
    fn checks(&self, lines: &[Line], cutting_s: f64) -> Vec<Check> {
        let number = |i: usize| lines.get(i).map_or(0, |l| l.number);
        let left = match self.first_missing {
            Some((stretch, place)) => format!("the first is place {place} of stretch {}", stretch + 1),
            None => format!("{} places", self.places),
        };
        let stray = self.strays.first().map_or_else(String::new, |i| format!("the first is line {}", number(*i)));
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
                format!("line {}", number(self.centre_mm.1)),
            ),
            Check::at_most(
                CheckId::ProgramDirection,
                "angle of both tool axes from where they should be",
                self.axis_deg.0,
                AXIS_DEG,
                "deg",
                format!("line {}", number(self.axis_deg.1)),
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

/// How far a tool stays over the blade axis on its own side, mm: of all its points the lowest along
/// the part of its axis that is square to the blade's.
fn height_mm(tool: &Tool, pose: &Pose) -> f64 {
    let out = Vector::new(0.0, pose.axis.y, pose.axis.z).try_normalize(1e-9).unwrap_or_default();
    lowest_mm(&tool.segments(), tool.radius_mm, &pose.centre, &pose.axis, &out)
}

/// The height over the blade axis, mm, beyond which nothing is that turns with the table: the
/// greatest distance of a point of the part and what stands about it from the table's axis, and
/// that of the blade axis.
fn turning_mm(work: &PinchWork, machine: &Machine) -> f64 {
    let part = PartAmong { blade: work.blade, obstacles: work.obstacles };
    machine.turns_within_mm(&part).unwrap_or(f64::INFINITY)
}

/// In rapids both tools stay over what the part turns in: axes that go straight keep a tool over a
/// plane that it is over at both ends, and the part turns under that plane.
fn rapids(work: &PinchWork, lines: &[Line], poses: &[Option<[Pose; 2]>], turning_mm: f64) -> Check {
    let (mut least, mut at) = (f64::INFINITY, 0);
    for i in (0..lines.len()).filter(|i| lines[*i].is_rapid) {
        let ends = [i.checked_sub(1).and_then(|b| poses[b]), poses[i]];
        for pose in ends.into_iter().flatten() {
            for j in 0..2 {
                let height = height_mm(work.tools[j], &pose[j]);
                if height < least {
                    (least, at) = (height, lines[i].number);
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
            format!("line {at}; the part turns within {turning_mm:.3} mm"),
        )
    }
}

fn travels(lines: &[Line], machine: &Machine) -> Check {
    let (mut worst, mut where_) = (0.0, String::new());
    for l in lines {
        for (axis, at) in machine.axes().iter().zip(l.at.iter()) {
            let Some([least, most]) = axis.limits.travel else { continue };
            let beyond = axis.shown((least - at).max(at - most));
            if beyond > worst {
                (worst, where_) = (beyond, format!("{} in line {}", axis.name, l.number));
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
        for s in &found.stretches {
            // Down from the line before, and up to the line behind.
            for ends in [[s.start.checked_sub(1), Some(s.start)], [s.end.checked_sub(1), Some(s.end)]] {
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
        checks.push(name(gouge::check(work.blade, &part, &sweep, options).0, CheckId::LeadGouge));
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
