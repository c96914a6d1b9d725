//! Programs of two tools that others wrote, judged by themselves: no rows, no plan.
//!
//! **In**: the text of a program of nine axes, or that of each of two channels, the machine with
//! two heads, both tools, the [`Blade`]. **Out**: a [`PinchAudit`].
//!
//! Lines are read by [`crate::read::program::pinch`] and moved through the machine. Two channels
//! meet at their wait marks, and between two marks by the time that their lines take. Lines are
//! parted where axes that go straight lead a ball off the straight way or turn a tool far, so that
//! between two stations balls go straight and tools turn evenly. Then
//!
//! | of | checked |
//! | --- | --- |
//! | each tool | depth of the swept ball; the rest of the tool to the part; what stands between its passes, less what the other takes off |
//! | both tools | their distance over all moves at a feed; where both touch the part, whether what they touch is opposite |
//! | axes | travel, and the velocity that each line asks for |
//! | the program | what is not set, spindles that stand, its end, rapids over the turning part |
//! | two channels | marks that never meet, axes of the other channel, moves of the table and rapids where a tool cuts, time between them, tools apart however far one lags |

use std::ops::Range;

use super::apart::apart;
use super::audit::{AuditOptions, scallop};
use super::between::{Height, NEAR_MM, percentile};
use super::clearance::Track;
use super::cuts::{self, EndWay};
use super::options::VerifyOptions;
use super::pinch::{clearance, facing, tools_apart};
use super::pinch_channels as channels;
use super::pinch_program::{Expected, joined, poses_of, rapids, read_all, travels, turning_mm};
use super::sweep::Sweep;
use crate::artifact::report::Check;
use crate::artifact::{Axes, AxisCheck, Blade, CheckId, Cone, Stand};
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::machine::{Machine, Pose};
use crate::numerics::angle::nearest_turn;
use crate::observe::Observer;
use crate::parallel;
use crate::read::program::pinch::{Line, Read, names};
use crate::tool::Tool;

/// Balls leave the straight way between two stations by less than this, mm.
const STRAIGHT_MM: f64 = 1e-4;
/// Tools turn by less than this between two stations, rad.
const TURN_RAD: f64 = 0.02;
/// Stations of a line at most.
const MOST_PARTS: f64 = 2000.0;
/// Velocities of axes may be over their limits by this share.
const LIMIT_SHARE: f64 = 1e-4;
/// Rows face each other where half of the normals lack no more of being opposite, degrees.
const OPPOSITE_DEG: f64 = 40.0;
/// ... and half of the normal lines pass within this: beyond, the tools are not meant to hold the
/// part, as round two edges.
const BESIDE_MM: f64 = 1.0;
/// What is measured of opposition is looked at in so many places at most.
const FACING: usize = 8000;

/// What programs of two tools are judged with.
pub struct PinchBench<'a> {
    /// The part.
    pub blade: &'a Blade,
    /// Both tools, balls.
    pub tools: [&'a Tool; 2],
    /// The machine, with two heads.
    pub machine: &'a Machine,
    /// Room that the tools keep from each other, mm.
    pub tools_apart_mm: f64,
    /// Greatest distance of the two normal lines, 99th percentile, mm.
    pub line_distance_mm: f64,
}

/// What was found in a program of two tools. Lengths in mm, angles in degrees.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct PinchAudit {
    /// Channels that it is for.
    pub channels: usize,
    /// Lines at a feed whose beginning and end are known; of two channels every end of a line.
    pub feed_lines: usize,
    /// Rapids.
    pub rapids: usize,
    /// Lines before the program has said where all axes stand.
    pub unknown_lines: usize,
    /// Time at a feed, as programmed, s.
    pub feed_s: f64,
    /// Share of that time in which the ball of tool 1, of tool 2, and both are at the part.
    pub touching: [f64; 3],
    /// Least and greatest lean of each tool at the part.
    pub lean_deg: [[f64; 2]; 2],
    /// How far the table turns while both balls are at the part, in all.
    pub turned_deg: f64,
    /// Rows in which both balls are at the part, each without a break.
    pub rows: usize,
    /// Those of them that do not face each other: the tools cut at different places of the blade.
    pub rows_elsewhere: usize,
    /// Share of the places at which both are at the part that are in rows which face each other.
    pub opposite: f64,
    /// Distance of the normal lines in these: median, 99th percentile, greatest.
    pub line_distance_mm: [f64; 3],
    /// What the normals lack of being opposite in these: the same.
    pub angle_deg: [f64; 3],
    /// What stands between the passes of each tool: median, 99th percentile, greatest.
    pub scallop_mm: [[f64; 3]; 2],
    /// The tools are nowhere nearer to each other at a feed.
    pub tools_apart_mm: f64,
    /// All checks.
    pub checks: Vec<Check>,
}

impl PinchAudit {
    /// Whether all checks passed.
    pub fn passed(&self) -> bool {
        self.checks.iter().all(|c| c.passed)
    }
}

/// Whether a text is meant as a program of two tools on a machine with two heads: it names linear
/// axes of both heads, or waits for another channel.
pub fn is_for_two_tools(text: &str, machine: &Machine) -> bool {
    let words = names(text);
    let has = |head: usize| {
        let own = machine.heads()[head].linear().into_iter().map(|k| machine.axes()[k].name.as_str());
        own.into_iter().any(|name| words.contains(name))
    };
    machine.has_two_heads() && (has(0) && has(1) || words.contains("WAITM") || words.contains("WAITMC"))
}

/// A place of both tools in the program.
struct Station {
    /// The line that leads to it.
    line: usize,
    stands: [Stand; 2],
    /// Time from the one before, s.
    takes_s: f64,
    /// Each ball is at the part.
    touches: [bool; 2],
}

/// Judges a program of two tools, or those of two channels.
///
/// # Errors
/// Kind `Usage` for a machine with one head, cutters that are no balls, or a line that cannot be
/// read, or where nothing is at a feed; cancellation.
pub fn audit(
    texts: &[&str],
    bench: &PinchBench,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<PinchAudit> {
    let (machine, tools) = (bench.machine, bench.tools);
    if !machine.has_two_heads() {
        let message = format!("the machine {} has one head, and a program of two tools needs two", machine.name);
        return Err(Error::usage(Stage::Verify, message).advise("give --machine FILE with a section second"));
    }
    tools.into_iter().try_for_each(|t| t.ball_only("programs of two tools are checked"))?;
    let programs = read_all(texts, machine).map_err(|what| {
        let error = Error::usage(Stage::Verify, what);
        if texts.len() == 1 { error.advise("of two channels, give both programs") } else { error }
    })?;
    let mut checks = set(&programs);
    let (met, lines) = joined(&programs, Expected::default(), machine);
    checks.extend(met);
    let is_joined = lines.is_some();
    let lines = lines.unwrap_or_default();
    let poses = poses_of(&lines, tools, machine);
    let runs = runs(&lines, &poses);
    observer.check(Stage::Verify)?;
    let part = Allowed::new(&bench.blade.part, options.stock_mm);
    let stations: Vec<Vec<Station>> = runs.iter().map(|run| stations(run, &lines, &poses, bench, &part)).collect();
    let mut out = PinchAudit {
        channels: texts.len(),
        feed_lines: runs.iter().map(Range::len).sum(),
        rapids: lines.iter().filter(|l| l.is_rapid).count(),
        unknown_lines: poses.iter().filter(|p| p.is_none()).count(),
        feed_s: 0.0,
        touching: [0.0; 3],
        lean_deg: [[0.0; 2]; 2],
        turned_deg: 0.0,
        rows: 0,
        rows_elsewhere: 0,
        opposite: 0.0,
        line_distance_mm: [0.0; 3],
        angle_deg: [0.0; 3],
        scallop_mm: [[0.0; 3]; 2],
        tools_apart_mm: f64::INFINITY,
        checks,
    };
    // Channels that never meet have no lines together.
    if !is_joined {
        return Ok(out);
    }
    if stations.is_empty() {
        let message = "no line of the program moves at a feed from where all axes are known";
        return Err(Error::usage(Stage::Verify, message).advise("name every axis of the machine before the tools cut"));
    }
    out.judge(&stations, (&lines, &poses, &runs), bench, options, observer)?;
    Ok(out)
}

/// What is to be set before tools cut, spindles that stand, the end.
fn set(programs: &[Read]) -> Vec<Check> {
    let count =
        |id, quantity, all: Vec<String>| Check::at_most(id, quantity, all.len() as f64, 0.0, "", all.join(", "));
    let unset = programs.iter().flat_map(|p| p.unset.iter().map(|what| (*what).to_owned())).collect();
    // In two channels each has the spindle of its own tool.
    let spindle = |k: usize| programs.get(k).or(programs.first()).map_or_else(Default::default, |p| p.spindles[k]);
    let stands = (0..2).filter(|k| !(spindle(*k).turns && spindle(*k).rpm > 0.0));
    let stands = stands.map(|k| format!("spindle {}", k + 1)).collect();
    let open = programs.iter().enumerate().filter(|(_, p)| !p.ends);
    let open = open.map(|(k, _)| format!("that of channel {}", k + 1)).collect();
    vec![
        count(CheckId::ProgramFrame, "what is not set before the tools cut", unset),
        count(CheckId::ProgramSpindle, "spindles that stand where the tools begin to cut", stands),
        count(CheckId::ProgramEnd, "programs without an end", open),
    ]
}

/// Lines at a feed that follow one another, whose beginning is known.
fn runs(lines: &[Line], poses: &[Option<[Pose; 2]>]) -> Vec<Range<usize>> {
    let feeds = |i: &usize| {
        let known = |i: usize| poses.get(i).is_some_and(Option::is_some);
        !lines[*i].is_rapid && known(*i) && i.checked_sub(1).is_some_and(known)
    };
    let mut out: Vec<Range<usize>> = Vec::new();
    for i in (0..lines.len()).filter(feeds) {
        match out.last_mut().filter(|run| run.end == i) {
            Some(run) => run.end = i + 1,
            None => out.push(i..i + 1),
        }
    }
    out
}

/// The stations of a run, from where its first line begins.
fn stations(
    run: &Range<usize>,
    lines: &[Line],
    poses: &[Option<[Pose; 2]>],
    bench: &PinchBench,
    part: &Allowed,
) -> Vec<Station> {
    let (machine, gauges) = (bench.machine, bench.tools.map(Tool::length_mm));
    let axes = machine.axes();
    let mut found: Vec<(usize, [Pose; 2], f64)> = Vec::new();
    let first = run.start - 1;
    found.extend(poses[first].map(|pose| (run.start, pose, 0.0)));
    for i in run.clone() {
        // The table by the shorter way, as a position within a turn has it.
        let from = lines[i - 1].at;
        let to = Axes::from_fn(from.len(), |k| {
            let at = lines[i].at[k];
            if axes[k].is_rotary() { nearest_turn(at, from[k]) } else { at }
        });
        let pose = |share: f64| {
            let at = from.toward(&to, share);
            Some([machine.forward_of(0, &at, gauges[0])?, machine.forward_of(1, &at, gauges[1])?])
        };
        let (Some(a), Some(middle), Some(b)) = (pose(0.0), pose(0.5), pose(1.0)) else { continue };
        let off_mm = |j: usize| (middle[j].centre - nalgebra::center(&a[j].centre, &b[j].centre)).norm();
        let turned = |j: usize| a[j].axis.angle(&b[j].axis);
        let by_way = (off_mm(0).max(off_mm(1)) / STRAIGHT_MM).sqrt();
        let parts = by_way.max(turned(0).max(turned(1)) / TURN_RAD).clamp(1.0, MOST_PARTS).ceil();
        let takes_s = lines[i].seconds.unwrap_or(0.0) / parts;
        for n in 1..=parts as usize {
            let share = if n as f64 == parts { Some(b) } else { pose(n as f64 / parts) };
            found.extend(share.map(|pose| (i, pose, takes_s)));
        }
    }
    let mut last = [None::<f64>; 2];
    let stands: Vec<[Stand; 2]> = found
        .iter()
        .map(|(_, pose, _)| {
            [0, 1].map(|j| {
                let axis = pose[j].axis;
                let theta = axis.z.atan2(axis.y);
                let theta = last[j].map_or(theta, |last| nearest_turn(theta, last));
                last[j] = Some(theta);
                Stand { centre: pose[j].centre, cone: Cone::about_blade(axis.x.clamp(-1.0, 1.0).asin()), theta }
            })
        })
        .collect();
    let touches = parallel::map(&stands, |at| {
        [0, 1].map(|j| {
            let radius_mm = bench.tools[j].radius_mm;
            part.closest(&at[j].centre, radius_mm + NEAR_MM).is_some_and(|c| c.distance_mm <= radius_mm + NEAR_MM)
        })
    });
    let all = found.into_iter().zip(stands).zip(touches);
    all.map(|(((line, _, takes_s), stands), touches)| Station { line, stands, takes_s, touches }).collect()
}

/// Lines, where both tools stand behind each, and which of them are runs at a feed.
type Moves<'a> = (&'a [Line], &'a [Option<[Pose; 2]>], &'a [Range<usize>]);

impl PinchAudit {
    fn judge(
        &mut self,
        runs: &[Vec<Station>],
        (lines, poses, at_feed): Moves,
        bench: &PinchBench,
        options: &AuditOptions,
        observer: &dyn Observer,
    ) -> Result<()> {
        let (blade, tools, machine) = (bench.blade, bench.tools, bench.machine);
        let part = Allowed::new(&blade.part, options.stock_mm);
        let all: Vec<&Station> = runs.iter().flatten().collect();
        let mut cuts = vec![true; all.len().saturating_sub(1)];
        let mut end = 0;
        for run in &runs[..runs.len() - 1] {
            end += run.len();
            cuts[end - 1] = false;
        }
        self.count(runs);
        let numbers = |i: usize| all.get(i).and_then(|s| lines.get(s.line)).map_or_else(String::new, Line::named);
        let named = |tool: usize, check: Check| {
            let note = match check.row {
                Some(i) => format!("{}; {}", numbers(i), check.note),
                None => check.note,
            };
            Check { quantity: format!("tool {}: {}", tool + 1, check.quantity), note, row: None, turn: None, ..check }
        };
        let run_of = runs.iter().enumerate().flat_map(|(n, run)| run.iter().map(move |_| n as u32));
        let run_of: Vec<u32> = run_of.collect();
        let centres = |j: usize| -> Vec<Point> { all.iter().map(|s| s.stands[j].centre).collect() };
        let sweeps =
            [0, 1].map(|j| Sweep::of(centres(j), centres(j), run_of.clone(), tools[j].radius_mm, Some(cuts.clone())));
        // Touching is what is not allowed, as in other programs of others.
        let limits = VerifyOptions {
            settings: options.settings,
            clearance_mm: 0.0,
            holder_clearance_mm: 0.0,
            clearance_resolution_mm: options.clearance_resolution_mm,
            ..VerifyOptions::default()
        };
        let stands = [0, 1].map(|j| all.iter().map(|s| s.stands[j]).collect::<Vec<Stand>>());
        for j in 0..2 {
            observer.check(Stage::Verify)?;
            observer.progress(Stage::Verify, j, 3);
            let nothing = format!("tool {} never comes to the part at a feed", j + 1);
            let share = self.touching[j];
            self.checks.push(Check {
                passed: share > 0.0,
                ..Check::at_most(CheckId::Contact, &nothing, share, 0.0, "", "share of the time at a feed".into())
            });
            self.checks.push(named(j, cuts::check(blade, &part, &EndWay::of_ball(&sweeps[j]), &limits)));
            let track = Track { stands: &stands[j], wanted: Some(&cuts) };
            for a in apart(blade, &[], tools[j], &limits) {
                self.checks.push(named(j, clearance(&a, track, blade, &limits)));
            }
            let widest_mm = options.scallop_mm.unwrap_or(scallop::WIDEST * tools[j].radius_mm);
            let count = options.settings.surface_samples as usize;
            let heights = scallop::of_ball(&part, &sweeps[j], &[&sweeps[1 - j]], widest_mm, count).sorted;
            let at = |q: f64| percentile(&heights, q).map_or(0.0, |h| h.height_mm);
            self.scallop_mm[j] = [at(0.5), at(0.99), at(1.0)];
            self.checks.extend(options.scallop_mm.map(|asked_mm| {
                let limit_mm = options.settings.scallop_ratio * asked_mm;
                let highest: Option<&Height> = heights.last();
                let note = format!("{} places, highest {:.6}", heights.len(), at(1.0));
                let quantity = "99th percentile of the height left between passes";
                let point_mm = highest.map(|h| (blade.model_from_blade * h.point).coords.into());
                let check = Check::at_most(CheckId::Scallop, quantity, at(0.99), limit_mm, "mm", note);
                named(j, Check { point_mm, row: highest.map(|h| h.leg), ..check })
            }));
        }
        let (least_mm, i) = tools_apart(tools, [&stands[0], &stands[1]], &cuts);
        self.tools_apart_mm = least_mm;
        let quantity = "least distance of the two tools at a feed, between places too";
        let note = format!("{}; asked for {}", numbers(i), bench.tools_apart_mm);
        self.checks.push(Check {
            passed: least_mm >= bench.tools_apart_mm,
            ..Check::at_most(CheckId::ToolsApart, quantity, least_mm, bench.tools_apart_mm, "mm", note)
        });
        observer.progress(Stage::Verify, 2, 3);
        self.opposition(runs, &numbers, bench);
        self.checks.push(rapids(tools, lines, poses, turning_mm(blade, &[], machine)));
        self.checks.push(travels(lines, machine));
        self.checks.extend(velocities(lines, at_feed, machine));
        if self.channels == 2 {
            self.checks.push(channels::lagging((tools, bench.tools_apart_mm), poses, at_feed));
        }
        Ok(())
    }

    /// Times, leans, turning.
    fn count(&mut self, runs: &[Vec<Station>]) {
        let (mut touching, mut leans) = ([0.0; 3], [[f64::INFINITY, f64::NEG_INFINITY]; 2]);
        for w in runs.iter().flat_map(|run| run.windows(2)) {
            let [a, b] = [&w[0], &w[1]];
            let both = [0, 1].map(|j| a.touches[j] && b.touches[j]);
            self.feed_s += b.takes_s;
            for (sum, counts) in touching.iter_mut().zip([both[0], both[1], both[0] && both[1]]) {
                *sum += if counts { b.takes_s } else { 0.0 };
            }
            if both[0] && both[1] {
                self.turned_deg += (b.stands[0].theta - a.stands[0].theta).abs().to_degrees();
            }
            for j in (0..2).filter(|j| both[*j]) {
                let lean = b.stands[j].cone.lean_rad.to_degrees();
                leans[j] = [leans[j][0].min(lean), leans[j][1].max(lean)];
            }
        }
        self.touching = touching.map(|s| s / self.feed_s.max(f64::MIN_POSITIVE));
        self.lean_deg = leans.map(|[a, b]| if a <= b { [a, b] } else { [0.0; 2] });
    }

    /// Whether what both balls touch is opposite: row by row, since tools that go round two edges
    /// are not meant to hold anything.
    fn opposition(&mut self, runs: &[Vec<Station>], numbers: &dyn Fn(usize) -> String, bench: &PinchBench) {
        let mut rows: Vec<Vec<(usize, &Station)>> = Vec::new();
        let all = runs.iter().flat_map(|run| run.iter().enumerate()).enumerate();
        let mut last = None;
        for (i, (in_run, at)) in all.filter(|(_, (_, at))| at.touches == [true; 2]) {
            match rows.last_mut().filter(|_| in_run > 0 && last == Some(i - 1)) {
                Some(row) => row.push((i, at)),
                None => rows.push(vec![(i, at)]),
            }
            last = Some(i);
        }
        let every = rows.iter().map(Vec::len).sum::<usize>().div_ceil(FACING).max(1);
        let mut opposite: Vec<Faced> = Vec::new();
        let mut looked = 0;
        for row in &rows {
            let places: Vec<&(usize, &Station)> = row.iter().step_by(every).collect();
            looked += places.len();
            let found = parallel::filter_map(places, |(i, at)| {
                let [line_mm, half] = facing(&bench.blade.part, [0, 1].map(|j| &at.stands[j].centre))?;
                Some(Faced { station: *i, line_mm, angle_deg: (2.0 * half.asin()).to_degrees() })
            });
            let middle = |value: fn(&Faced) -> f64| median(&found, value);
            match middle(|f| f.angle_deg) <= OPPOSITE_DEG && middle(|f| f.line_mm) <= BESIDE_MM {
                true => opposite.extend(found),
                false => self.rows_elsewhere += 1,
            }
        }
        self.rows = rows.len();
        self.opposite = opposite.len() as f64 / looked.max(1) as f64;
        let three = |value: fn(&Faced) -> f64| {
            let mut all: Vec<f64> = opposite.iter().map(value).collect();
            all.sort_by(f64::total_cmp);
            let at = |q: f64| all.get(((all.len().max(1) - 1) as f64 * q).round() as usize);
            [0.5, 0.99, 1.0].map(|q| at(q).copied().unwrap_or(0.0))
        };
        self.line_distance_mm = three(|f| f.line_mm);
        self.angle_deg = three(|f| f.angle_deg);
        let worst = opposite.iter().max_by(|a, b| a.line_mm.total_cmp(&b.line_mm));
        let station = |f: &Faced| runs.iter().flatten().nth(f.station);
        let point = worst.and_then(station).map(|s| bench.blade.model_from_blade * s.stands[0].centre);
        let note = format!(
            "{} of {looked} places at which both balls are at the part are in rows that face each other; {}",
            opposite.len(),
            worst.map_or_else(String::new, |w| format!("greatest {:.6}, {}", w.line_mm, numbers(w.station)))
        );
        let quantity = "99th percentile of the distance of the two normal lines, in rows that face each other";
        let check =
            Check::at_most(CheckId::Opposition, quantity, self.line_distance_mm[1], bench.line_distance_mm, "mm", note);
        self.checks.push(Check { point_mm: point.map(|p| p.coords.into()), ..check });
    }
}

/// How what both balls touch at a station faces each other.
struct Faced {
    station: usize,
    /// Distance of the two normal lines.
    line_mm: f64,
    /// What the normals lack of being opposite.
    angle_deg: f64,
}

fn median(found: &[Faced], value: fn(&Faced) -> f64) -> f64 {
    let mut all: Vec<f64> = found.iter().map(value).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(f64::INFINITY)
}

/// What each line at a feed asks of each axis, on the mean, against its velocity.
fn velocities(lines: &[Line], at_feed: &[Range<usize>], machine: &Machine) -> Vec<Check> {
    let of = |(k, axis): (usize, &crate::machine::Axis)| {
        let (mut worst, mut at) = (0.0, String::new());
        for i in at_feed.iter().flat_map(Clone::clone) {
            let [from, to] = [i - 1, i].map(|i| lines[i].at[k]);
            let to = if axis.is_rotary() { nearest_turn(to, from) } else { to };
            let seconds = lines[i].seconds.filter(|s| *s > 0.0);
            // A line of no time goes nowhere; where it does not, no velocity is enough.
            let asked = match seconds {
                Some(s) => (to - from).abs() / s,
                None if (to - from).abs() > 1e-9 => f64::INFINITY,
                None => 0.0,
            };
            if !(asked <= worst) {
                (worst, at) = (asked, lines[i].named());
            }
        }
        let limit = axis.shown(axis.limits.velocity) * (1.0 + LIMIT_SHARE);
        let unit = format!("{}/s", axis.unit());
        let quantity = format!("velocity of {} that a line asks for", axis.name);
        Check::at_most(CheckId::axis(&axis.name, AxisCheck::Velocity), &quantity, axis.shown(worst), limit, &unit, at)
    };
    machine.axes().iter().enumerate().filter(|(_, a)| !a.is_missing).map(of).collect()
}
