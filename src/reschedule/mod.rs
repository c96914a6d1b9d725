//! A program that others wrote, with its tool axis scheduled anew.
//!
//! **In**: the text of an NC program, how its words are meant ([`Bench`]), the [`Blade`],
//! [`RescheduleOptions`]. **Out**: a [`Rescheduled`]: the text with new orientations, what became
//! of each stretch, and audits of the program before and after.
//!
//! **Method** (Zhang, Zhao, Wu et al., "Piecewise decoupled re-scheduling", from cutter locations
//! of another system). A *stretch* is a run of lines in which one ball is in contact with the part,
//! up to where a pass turns back ([`stretches`]). Its ball centres stay as they are. Along them the
//! channel is made from the part, and in the channel a schedule that begins and ends at the
//! program's own angles, so that all other lines stay as they are ([`planned`]). Where the
//! program's own angles at the ends are outside the channel, the new schedule begins and ends at
//! the first and the last line at which they are inside. The numbers of the stretch's lines are
//! written anew in the manner of the program ([`rewrite`]). Feeds are written so that each line
//! takes the time that it took: the speed of the contact stays.
//!
//! **Guarantees**: the new text is read by the reader of programs, which shares nothing with what
//! writes: each line of a stretch ends with the ball where it ended, but for the rounding of its
//! words; all other lines end with the tool where it stood; no check of the audit fails that did
//! not fail before, and the tool comes no nearer to the part than it did but for the rounding of
//! words, or than the clearance that is asked for where no schedule that is faster keeps more. A
//! stretch is replaced only where that takes the machine less time. Lines are put between two where
//! θ turns so far that the ball would leave its way by more than half the chord tolerance, or by
//! more than it did.
//!
//! **Limits**: lines that are run more than once, arcs, polynomials, steps and statements over
//! several lines stay as they are. Times are those of each stretch by itself, from rest to rest.
//!
//! **Fails** with kind `Usage` where the program is not read or nothing of it touches the part,
//! `Infeasible` where no stretch gains by a new schedule, with the reason of each.

mod manner;
mod planned;
mod rewrite;
mod sparse;
mod stretches;
#[cfg(test)]
mod tests;
mod time;

use serde::Serialize;

use crate::artifact::program::TOUCHES_MM;
use crate::artifact::schedule::ThetaRow;
use crate::artifact::{Blade, CheckId};
use crate::channel::ChannelSettings;
use crate::error::{Error, Infeasible, Missed, Result, Stage};
use crate::machine::AxisPeak;
use crate::numerics::angle::nearest_turn;
use crate::observe::{Observer, timed};
use crate::read::program::{self, Bench, Block, Moved, Script};
use crate::schedule::ScheduleSettings;
use crate::verify::VerifyOptions;
use crate::verify::audit::{self, Audit, AuditOptions, LineCheck};
use planned::{Arounds, Planned};
use rewrite::{Edits, Rewriter};
use stretches::{Found, LineEnd};

/// What is asked of [`reschedule`]. Lengths in mm.
#[derive(Clone, Debug)]
pub struct RescheduleOptions {
    /// How θ is scheduled; the margin is not looked at, since the ends are given.
    pub schedule: ScheduleSettings,
    /// What taper, shank and holder keep from the part at least. They keep what they kept, or 5 mm,
    /// where a schedule can.
    pub channel: ChannelSettings,
    /// Stock that the program leaves, mm; `None`: found.
    pub stock_mm: Option<f64>,
    /// The ball touches where it is this near to the part with its stock, mm. Default:
    /// [`TOUCHES_MM`].
    pub contact_mm: f64,
    /// New speed of the ball centre, mm/min; `None`: each line keeps its own.
    pub feed_mm_min: Option<f64>,
    /// Chord tolerance, mm. Default 0.001.
    pub chord_mm: f64,
    /// Limits of the audits before and after.
    pub audit: AuditOptions,
}

impl Default for RescheduleOptions {
    fn default() -> Self {
        RescheduleOptions {
            schedule: ScheduleSettings::default(),
            channel: ChannelSettings::default(),
            stock_mm: None,
            contact_mm: TOUCHES_MM,
            feed_mm_min: None,
            chord_mm: crate::artifact::toolpath::CHORD_MM,
            audit: AuditOptions::default(),
        }
    }
}

/// A program as it was read.
pub(crate) struct Program<'a> {
    text: &'a str,
    script: Script,
    moves: Vec<Moved>,
    bench: Bench<'a>,
}

impl<'a> Program<'a> {
    fn read(text: &'a str, bench: &Bench<'a>) -> Result<Self> {
        let script = program::read(text, bench.language)?;
        let moves = program::follow(&script.blocks, bench)?;
        Ok(Program { text, script, moves, bench: *bench })
    }

    fn audited(&self, blade: &Blade, options: &AuditOptions, observer: &dyn Observer) -> Result<Audit> {
        audit::audit_read((self.text, &self.script, &self.moves), blade, &self.bench, options, observer)
    }

    fn blocks(&self) -> &[Block] {
        &self.script.blocks
    }

    /// The number of the line that ends at a place, from 1.
    fn line(&self, place: &LineEnd) -> usize {
        self.blocks().get(place.block).map_or(0, |b| b.line)
    }

    /// First and last line on the way through places: that of the first leads to it.
    fn lines(&self, places: &[LineEnd]) -> [usize; 2] {
        [places.get(1), places.last()].map(|p| p.map_or(0, |p| self.line(p)))
    }
}

/// What became of a stretch.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StretchReport {
    /// First and last line in which the ball is in contact, as the program had them, from 1.
    pub lines: [usize; 2],
    /// First and last line that are written anew; `None`: the stretch stays as it is.
    pub new_lines: Option<[usize; 2]>,
    /// Way of the ball centre in contact, mm.
    pub length_mm: f64,
    /// Least and greatest lean about the blade axis, degrees.
    pub lean_deg: [f64; 2],
    /// How often θ turned back, before and after.
    pub reversals: Option<[usize; 2]>,
    /// Time of the lines that are written anew, before and after, s.
    pub time_s: Option<[f64; 2]>,
    /// Peaks of the axes in them, before and after.
    pub peaks: Option<[Vec<AxisPeak>; 2]>,
    /// What taper and shank, and the holder, keep from the part, mm.
    pub clearance_mm: Option<[f64; 2]>,
    /// Why it stays as it is.
    pub reason: Option<String>,
    /// θ before and after.
    #[serde(skip)]
    pub theta: Vec<ThetaRow>,
}

/// A program scheduled anew, and its evidence.
#[derive(Clone, Debug, Serialize)]
pub struct Rescheduled {
    /// The new program.
    #[serde(skip)]
    pub text: String,
    /// Stock that it leaves, mm.
    pub stock_mm: f64,
    /// The stretches, in their order.
    pub stretches: Vec<StretchReport>,
    /// Lines that say something else now.
    pub lines_changed: usize,
    /// Lines that are new.
    pub lines_added: usize,
    /// Greatest distance of a ball centre at the end of a line from where it was, mm.
    pub centre_off_mm: f64,
    /// What the rounding of words allows of it, mm.
    pub centre_limit_mm: f64,
    /// The audit before.
    pub before: Audit,
    /// The audit after.
    pub after: Audit,
}

impl Rescheduled {
    /// Time of all stretches that are written anew, before and after, s.
    pub fn time_s(&self) -> [f64; 2] {
        self.stretches.iter().filter_map(|s| s.time_s).fold([0.0; 2], |a, b| [a[0] + b[0], a[1] + b[1]])
    }
}

/// Schedules the tool axis of a program anew, see the module's page.
///
/// # Errors
/// `Usage`: options out of their limits, the program is not read, or the ball touches the part in
/// no line; `Infeasible`: no stretch gains, with the reasons; `Cancelled`.
pub fn reschedule(
    text: &str,
    blade: &Blade,
    bench: &Bench,
    options: &RescheduleOptions,
    observer: &dyn Observer,
) -> Result<Rescheduled> {
    validate(options)?;
    bench.tool.validate()?;
    bench.tool.ball_only("programs are scheduled anew")?;
    let program = timed(observer, Stage::Path, || Program::read(text, bench))?;
    one_ball(&program)?;
    let places = timed(observer, Stage::Path, || stretches::places(&program, &blade.part));
    let radius_mm = bench.tool.radius_mm;
    let stock_mm = options.stock_mm.unwrap_or_else(|| stretches::stock_mm(&places, radius_mm, options.contact_mm));
    // Balls stay where they are, and so do the ridges between them.
    let audit = AuditOptions { stock_mm, clearance_closely: true, ..options.audit.clone() }
        .with(|s| s.surface_samples = s.surface_samples.min(RIDGES));
    let before = timed(observer, Stage::Verify, || program.audited(blade, &audit, observer))?;
    let clearances = clearances(&options.channel, stock_mm.max(0.0), &before);
    let options = &RescheduleOptions { stock_mm: Some(stock_mm), ..options.clone() };
    let found = stretches::find(&places, stock_mm, radius_mm, options.contact_mm);
    if found.is_empty() {
        return Err(nothing_touches(&places, radius_mm, options));
    }
    let around = Arounds::new(blade, radius_mm)?;
    let is_room = |c: &&LineCheck| [CheckId::Clearance, CheckId::HolderClearance].contains(&c.check.id);
    let tight_lines: Vec<usize> = before.checks.iter().filter(is_room).filter_map(|c| c.line).collect();
    let mut planned = Vec::with_capacity(found.len());
    for (k, stretch) in found.iter().enumerate() {
        observer.progress(Stage::Schedule, k, found.len());
        observer.check(Stage::Schedule)?;
        let scene = planned::StretchScene {
            program: &program,
            blade,
            around: &around,
            tight_lines: &tight_lines,
            options,
            observer,
        };
        planned.push(scene.plan(stretch, &clearances)?);
    }
    observer.progress(Stage::Schedule, found.len(), found.len());
    let Made { edits, reports, rounding_mm } =
        timed(observer, Stage::Post, || made(&program, &found, planned, options));
    if reports.iter().all(|r| r.new_lines.is_none()) {
        return Err(none_gains(&reports));
    }
    let (new_text, numbers) = timed(observer, Stage::Post, || edits.applied(text, bench.language.grammar));
    let new = timed(observer, Stage::Path, || Program::read(&new_text, bench))
        .map_err(|e| Error::usage(Stage::Post, format!("the new program is not read: {}", e.message)))?;
    let stays = Stays { old: &program, new: &new, numbers: &numbers, limit_mm: rounding_mm };
    let centre_off_mm = timed(observer, Stage::Path, || stays.checked(&found, &reports))?;
    let after = timed(observer, Stage::Verify, || new.audited(blade, &audit, observer))?;
    no_new_findings(&before, &after)?;
    let [lines_changed, lines_added] = edits.count();
    Ok(Rescheduled {
        text: new_text,
        stock_mm,
        stretches: reports,
        lines_changed,
        lines_added,
        centre_off_mm,
        centre_limit_mm: rounding_mm,
        before,
        after,
    })
}

/// What the tool is to keep from the stock, mm: taper and shank, and the holder.
struct Keeping {
    /// With this the channel is made.
    settings: ChannelSettings,
    /// This is proven over the whole motion; `None`: the same, to what plans are checked to.
    least_mm: Option<[f64; 2]>,
}

/// What is tried, in this order: what the program keeps, with a little more in the channel and
/// without, less and less of what it keeps over what is asked for, and that. A θ that never turns
/// back cannot keep everywhere what a swinging one kept.
fn clearances(asked: &ChannelSettings, stock_mm: f64, before: &Audit) -> Vec<Keeping> {
    let asked_mm = [asked.clearance_mm, asked.holder_clearance_mm];
    let own_mm = [CheckId::Clearance, CheckId::HolderClearance].map(|id| {
        let least = before.checks.iter().map(|c| &c.check).find(|c| c.id == id).map_or(0.0, |c| c.worst);
        (least - stock_mm).min(AMPLE_MM)
    });
    let more = [0, 1].map(|k| own_mm[k] > asked_mm[k]);
    let at = |share: f64, more_mm: f64| {
        let over = |k: usize| if more[k] { own_mm[k] * (1.0 + 0.5 * more_mm) + more_mm - asked_mm[k] } else { 0.0 };
        let mm = [0, 1].map(|k| asked_mm[k] + share * over(k));
        ChannelSettings { clearance_mm: mm[0], holder_clearance_mm: mm[1], ..asked.clone() }
    };
    let less = |share: f64| Keeping { settings: at(share, 0.0), least_mm: None };
    if more == [false; 2] {
        return vec![less(0.0)];
    }
    let passes = |k: usize| VerifyOptions::default().least_clearance(asked_mm[k]);
    let least_mm = Some([0, 1].map(|k| if more[k] { own_mm[k] } else { passes(k) }));
    let mut out = vec![Keeping { settings: at(1.0, ROUNDED_MM), least_mm }];
    out.extend(SHARES.map(less));
    out
}

/// Shares of what a program keeps over what is asked for.
const SHARES: [f64; 5] = [1.0, 0.9, 0.75, 0.5, 0.0];
/// The rounding of words brings the tool nearer by no more, as a rule, mm.
const ROUNDED_MM: f64 = 0.004;
/// Ridges are looked at in so many places.
const RIDGES: u32 = 2_000;
/// Radii that differ by less are one ball's, mm.
const SAME_BALL_MM: f64 = 1e-3;
/// Farther from the part than this the tool is clear, however far it was, mm.
const AMPLE_MM: f64 = 5.0;

/// Another tool axis leaves the part as it is only where the tool is a ball, and only the given one
/// is known.
fn one_ball(program: &Program) -> Result<()> {
    let radius_mm = program.bench.tool.radius_mm;
    let bad = |m: String| Err(Error::usage(Stage::Verify, m));
    for (line, [diameter, corner]) in &program.script.cutters {
        let is_ball = *corner > 0.0 && (2.0 * corner - diameter).abs() <= SAME_BALL_MM;
        if !is_ball {
            return bad(format!(
                "line {line} of the program: a cutter of {diameter} mm with a corner radius of {corner} mm is no ball: \
                 another tool axis would cut another part"
            ));
        }
        if (corner - radius_mm).abs() > SAME_BALL_MM {
            return bad(format!(
                "line {line} of the program: its ball has R {corner} mm, the tool has R {radius_mm} mm"
            ));
        }
    }
    let mut calls = program.script.calls.iter().filter_map(|c| Some((c.line, c.tool.as_ref()?))).filter(|c| c.1 != "0");
    if let Some((_, first)) = calls.next()
        && let Some((line, other)) = calls.find(|c| c.1 != first)
    {
        let what =
            format!("line {line} of the program: it calls tool {other} after tool {first}; one tool is scheduled");
        return Err(Error::usage(Stage::Verify, what).advise("give the part of the program that one tool runs"));
    }
    Ok(())
}

fn validate(options: &RescheduleOptions) -> Result<()> {
    options.schedule.check(Stage::Schedule)?;
    options.channel.check(Stage::Channel)?;
    let bad = |m: String| Err(Error::usage(Stage::Job, m));
    if let Some(stock) = options.stock_mm.filter(|s| !(s.is_finite() && s.abs() <= 100.0)) {
        return bad(format!("the stock is {stock} mm, it must be within 100 mm"));
    }
    if let Some(feed) = options.feed_mm_min.filter(|f| !(*f > 0.0 && *f <= 1e6)) {
        return bad(format!("the feed is {feed} mm/min, it must be over 0 and at most 1000000"));
    }
    if !(options.contact_mm > 0.0 && options.contact_mm <= 10.0) {
        return bad(format!("the distance of contact is {} mm, it must be over 0 and at most 10", options.contact_mm));
    }
    if !(options.chord_mm > 0.0 && options.chord_mm <= 1.0) {
        return bad(format!("the chord tolerance is {} mm, it must be over 0 and at most 1", options.chord_mm));
    }
    Ok(())
}

/// Speeds of the ball centre from place to place, mm/s.
fn speeds(places: &[LineEnd]) -> Vec<f64> {
    let speed = |w: &[LineEnd]| {
        let way = (w[1].stand.centre - w[0].stand.centre).norm();
        (way / w[1].seconds.unwrap_or(1.0)).clamp(1e-4, 1e5)
    };
    places.windows(2).map(speed).collect()
}

fn nothing_touches(places: &[LineEnd], radius_mm: f64, options: &RescheduleOptions) -> Error {
    let off = |p: &LineEnd| p.at.as_ref().map_or(f64::INFINITY, |c| (c.distance_mm - radius_mm).abs());
    let nearest = places.iter().filter(|p| p.barred.is_none()).map(off).fold(f64::INFINITY, f64::min);
    let barred = places.iter().find_map(|p| p.barred.filter(|_| off(p) <= options.contact_mm));
    let why = match barred {
        Some(why) => format!("where the ball touches the part a line cannot be scheduled anew: {why}"),
        None if nearest.is_finite() => format!(
            "nowhere on {} lines in a row is the ball within {} mm of contact; it comes within {nearest:.4} mm of the part",
            stretches::FEWEST,
            options.contact_mm
        ),
        None => "the ball is nowhere near the part".into(),
    };
    Error::usage(Stage::Verify, why)
        .advise("give the part's place by --origin, --cad or --fit, the ball's radius as the program has it, and its stock by --stock")
}

fn none_gains(reports: &[StretchReport]) -> Error {
    let mut reasons: Vec<(String, usize)> = Vec::new();
    for why in reports.iter().filter_map(|r| r.reason.as_ref()) {
        match reasons.iter_mut().find(|(w, _)| w == why) {
            Some((_, count)) => *count += 1,
            None => reasons.push((why.clone(), 1)),
        }
    }
    reasons.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let (why, count) = reasons.first().cloned().unwrap_or_default();
    let [first, last] = reports.iter().find(|r| r.reason.as_ref() == Some(&why)).map_or([0; 2], |r| r.lines);
    let all = reports.len();
    let message =
        format!("of {all} stretches none is better scheduled anew; {count}, as lines {first} to {last}: {why}");
    let reasons = reports.iter().filter_map(|r| r.reason.clone()).collect();
    Error::infeasible(Stage::Schedule, message, Infeasible::NoStretchGains { stretches: all, reasons })
}

/// What is written.
struct Made {
    edits: Edits,
    reports: Vec<StretchReport>,
    /// How far ball centres may be off by the rounding of words, mm.
    rounding_mm: f64,
}

/// The edits of the stretches that gain, and what became of each.
fn made(
    program: &Program,
    found: &[Found],
    planned: Vec<std::result::Result<Planned, String>>,
    options: &RescheduleOptions,
) -> Made {
    let rewriter = Rewriter::new(program, options, found);
    let mut all = Edits::default();
    let mut reports = Vec::with_capacity(found.len());
    for (stretch, planned) in found.iter().zip(planned) {
        let mut report = report(program, stretch);
        let better = planned.and_then(|p| {
            let [before, after] = p.motions.each_ref().map(|m| m.time_s);
            if options.feed_mm_min.is_none() && after >= before {
                return Err(format!("it would take {after:.3} s, it takes {before:.3} s"));
            }
            let edits = rewriter.as_ref().map_err(Clone::clone).and_then(|r| r.edits(stretch, &p));
            edits.map(|edits| (edits, p))
        });
        match better {
            Err(why) => report.reason = Some(why),
            Ok((edits, p)) => {
                all.extend(edits);
                replaced(&mut report, program, stretch, &p);
            }
        }
        reports.push(report);
    }
    let rounding_mm = rewriter.map_or(0.0, |r| r.rounding_mm());
    Made { edits: all, reports, rounding_mm }
}

/// A stretch as it is found.
fn report(program: &Program, stretch: &Found) -> StretchReport {
    let lean = stretch.places.iter().map(|p| p.stand.cone.lean_rad.to_degrees());
    StretchReport {
        lines: program.lines(&stretch.places),
        new_lines: None,
        length_mm: stretch.places.windows(2).map(|w| (w[1].stand.centre - w[0].stand.centre).norm()).sum(),
        lean_deg: lean.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]),
        reversals: None,
        time_s: None,
        peaks: None,
        clearance_mm: None,
        reason: None,
        theta: Vec::new(),
    }
}

/// Completes the report of a stretch that is written anew.
fn replaced(report: &mut StretchReport, program: &Program, stretch: &Found, planned: &Planned) {
    let count = planned.schedule.theta.len();
    let places = stretch.places.get(planned.first..planned.first + count).unwrap_or_default();
    report.new_lines = Some(program.lines(places));
    report.time_s = Some(planned.motions.each_ref().map(|m| m.time_s));
    let before = |row: usize| planned.course.theta.get(row).copied().unwrap_or(0.0);
    // Whole turns to where the channel counts them.
    let shift = planned.schedule.theta.first().map_or(0.0, |t| nearest_turn(before(0), *t) - before(0));
    report.clearance_mm = Some(planned.clearance_mm);
    report.reversals = Some([reversals(&planned.course.theta), planned.schedule.reversals]);
    let rows = planned.course.path.locations.iter().zip(&planned.channel.rows).zip(&planned.schedule.theta);
    report.theta = rows
        .enumerate()
        .map(|(k, ((l, row), theta))| ThetaRow {
            s_mm: l.s_mm,
            wall_deg: [row.theta_min, row.theta_max].map(f64::to_degrees),
            before_deg: (before(k) + shift).to_degrees(),
            after_deg: theta.to_degrees(),
        })
        .collect();
    report.peaks = Some(planned.motions.each_ref().map(|m| program.bench.machine.peaks(m)));
}

/// How often angles turn back, by more than the rounding of words.
fn reversals(theta: &[f64]) -> usize {
    let (mut way, mut farthest, mut count) = (0.0f64, theta.first().copied().unwrap_or(0.0), 0);
    for t in theta {
        let step = t - farthest;
        if way * step >= 0.0 && step != 0.0 && way != 0.0 {
            farthest = *t;
        } else if step.abs() > ROUNDED_RAD {
            count += usize::from(way != 0.0);
            (way, farthest) = (step.signum(), *t);
        }
    }
    count
}

/// Rotary words of three decimals are rounded by half of this, rad.
const ROUNDED_RAD: f64 = 0.001 * std::f64::consts::PI / 180.0;

/// The program before and after.
struct Stays<'a> {
    old: &'a Program<'a>,
    new: &'a Program<'a>,
    /// The number that each old line has in the new text.
    numbers: &'a [usize],
    limit_mm: f64,
}

impl Stays<'_> {
    /// Every line that the program had ends with the ball where it ended, and outside the stretches
    /// with the tool as it stood. The greatest distance of a ball centre, mm.
    ///
    /// # Errors
    /// Where it does not; the writing is wrong then.
    fn checked(&self, found: &[Found], reports: &[StretchReport]) -> Result<f64> {
        let (tool, machine) = (self.old.bench.tool, self.old.bench.machine);
        let centre = |m: &Moved| m.pose(1.0, tool, machine).centre;
        let wrong = |line: usize, what: &str| {
            Error::usage(Stage::Post, format!("line {line} of the program would {what} after it is written anew"))
        };
        let is_new = self.written(found, reports);
        let after = ends(self.new);
        let mut after = after.iter().peekable();
        let mut worst = 0.0f64;
        for m in ends(self.old) {
            let number = self.numbers.get(m.line - 1).copied().unwrap_or(0);
            // Lines that are put between come first.
            while after.next_if(|to| to.line != number).is_some() {}
            let Some(to) = after.next() else { return Err(wrong(m.line, "be gone")) };
            if is_new.get(m.block) == Some(&true) {
                let off = (centre(m) - centre(to)).norm();
                worst = worst.max(off);
                if !(off <= self.limit_mm) {
                    return Err(wrong(m.line, &format!("end {off:.6} mm off")));
                }
            } else if m.to.iter().zip(to.to.iter()).any(|(a, b)| a.is_nan() != b.is_nan() || (a - b).abs() > SAME) {
                return Err(wrong(m.line, "end elsewhere"));
            } else if m.seconds.is_some() != to.seconds.is_some() {
                return Err(wrong(m.line, "be no longer what it is"));
            }
        }
        Ok(worst)
    }

    /// Which blocks of the program are written anew.
    fn written(&self, found: &[Found], reports: &[StretchReport]) -> Vec<bool> {
        let mut out = vec![false; self.old.blocks().len()];
        for (stretch, lines) in found.iter().zip(reports).filter_map(|(f, r)| Some((f, r.new_lines?))) {
            for place in &stretch.places {
                let written = (lines[0]..=lines[1]).contains(&self.old.line(place));
                if let (true, Some(flag)) = (written, out.get_mut(place.block)) {
                    *flag = true;
                }
            }
        }
        out
    }
}

/// The last move of each line.
fn ends<'a>(program: &'a Program) -> Vec<&'a Moved> {
    let next = |k: usize| program.moves.get(k + 1).map(|m| m.block);
    program.moves.iter().enumerate().filter(|(k, m)| next(*k) != Some(m.block)).map(|(_, m)| m).collect()
}

/// Lines outside the stretches end within this, mm or rad.
const SAME: f64 = 1e-9;

/// No check fails that did not fail before, and none that failed is worse.
fn no_new_findings(before: &Audit, after: &Audit) -> Result<()> {
    for check in after.checks.iter().map(|c| &c.check).filter(|c| !c.passed) {
        let was = before.checks.iter().map(|c| &c.check).find(|c| c.id == check.id);
        let worse = |was: &crate::artifact::report::Check| {
            let slack = 1e-3 * was.worst.abs().max(1e-3);
            if was.worst >= was.limit { check.worst > was.worst + slack } else { check.worst < was.worst - slack }
        };
        if was.is_none_or(|w| w.passed || worse(w)) {
            let had = was.map_or(String::new(), |w| format!(", {:.6} before", w.worst));
            let what =
                format!("the new program would fail the check {}: {:.6} {}{had}", check.id, check.worst, check.unit);
            let missed = Missed { check: check.id.to_string(), worst: check.worst, limit: check.limit };
            let since = Infeasible::ProgramWorse { missed, before: was.map(|w| w.worst) };
            return Err(Error::infeasible(Stage::Verify, what, since)
                .advise("allow more clearance, or another kind of schedule"));
        }
    }
    Ok(())
}
