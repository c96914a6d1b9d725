//! Programs of two tools: positions of the machine's axes, every line in a time of its own.
//!
//! **In**: the motion of a machine with two heads ([`PinchMotion`]) and a [`Dialect`]. **Out**: one
//! program that moves all axes in one clock, or two, one for each of two channels, that meet at
//! wait marks.
//!
//! How a control writes them is data: `[pinch]` of its post file, and `[pinch_channels]`
//! ([`PinchText`]). In two channels the axes that turn the workpiece are channel 1's. Channels keep
//! time by marks only, so a program in two channels is written only where the table stands still
//! while the tools cut: then a channel that lags moves its own tool along its own row, and nothing
//! else. Or the job states how far the channels may be apart, and the checks count that in.
//!
//! Marks stand where both tools are clear of the turning part: behind the first retract, over the
//! first place of each stretch, and behind the way up from its last.

use super::dialect::FeedWord;
use super::fixed::Fixed;
use super::moves::feed_word;
use super::pinch_text::{self, PinchText};
use super::text::Lines;
use super::{Dialect, PostSettings};
use crate::artifact::Axes;
use crate::artifact::paired::{PinchMotion, StretchMotion};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::machine::{Axis, Carries, Machine};
use crate::tool::Tool;

/// An axis that moves by less stands still, mm or rad.
const STILL: f64 = 1e-9;
/// A way down or up takes this long at least, s.
const LEAST_S: f64 = 0.01;

/// What a program of two tools is made from.
pub struct PinchProgram<'a> {
    /// Name of the program.
    pub name: &'a str,
    /// File of the part.
    pub part_file: &'a str,
    /// Hash of that file; empty: none.
    pub part_hash: &'a str,
    /// The machine, with two heads.
    pub machine: &'a Machine,
    /// What it does.
    pub motion: &'a PinchMotion,
    /// Numbers, speeds and feeds.
    pub settings: &'a PostSettings,
    /// Both tools.
    pub tools: [&'a Tool; 2],
    /// Spindle speeds of both, 1/min.
    pub spindle_rpm: [f64; 2],
    /// Channels of the control that it is for: 1 or 2.
    pub channels: u32,
    /// How far these may be apart in time, ms; `None`: not known.
    pub skew_ms: Option<f64>,
}

/// The text of a channel's program.
#[derive(Clone, Debug, PartialEq)]
pub struct PinchFile {
    /// Name of the file.
    pub name: String,
    /// The text, lines ended by `\n`.
    pub text: String,
}

/// How a dialect writes programs of two tools on a machine.
///
/// # Errors
/// Kind `Usage` where it has none, or not in as many channels, or no letter for an axis.
pub fn pinch_text<'a>(dialect: &'a Dialect, machine: &Machine, channels: u32) -> Result<&'a PinchText> {
    let file = &dialect.file;
    let advise = "set post.control to siemens, linuxcnc, iso or fanuc, or add the section to a post file of your own";
    let Some(one) = &file.pinch else {
        let message = format!("{} has no programs of two tools: its post file has no section pinch", file.name);
        return Err(Error::usage(Stage::Post, message).advise(advise));
    };
    let text = match (channels, &file.pinch_channels) {
        (2, Some(two)) => two,
        (2, None) => {
            let message = format!(
                "pinch.channels is 2, but {} has programs of two tools in one channel only: its post file has no section pinch_channels",
                file.name
            );
            return Err(Error::usage(Stage::Post, message)
                .advise("set post.control to siemens alone, or leave pinch.channels out"));
        }
        _ => one,
    };
    let named = machine.axes().iter().filter(|a| !a.is_missing);
    match named.into_iter().find(|a| !text.letters.contains(a.letter.letter())) {
        None => Ok(text),
        Some(axis) => {
            let message = format!(
                "{} has no letter for axis {} of the machine {}: its letters are {}",
                file.name, axis.name, machine.name, text.letters
            );
            Err(Error::usage(Stage::Post, message).advise(advise))
        }
    }
}

/// Whether programs of a dialect may turn the table while both tools cut.
///
/// # Errors
/// Kind `Usage` where two channels may be apart by a time that is not known, or a line's F counts
/// the way of linear axes, beside which a control counts that of the table too.
pub fn table_may_turn(dialect: &Dialect, channels: u32, skew_ms: Option<f64>) -> Result<()> {
    let file = &dialect.file;
    let since = if channels == 2 && skew_ms.is_none() {
        "pinch.channels is 2: channels keep time by wait marks only".to_owned()
    } else if file.feed != FeedWord::InverseTime {
        format!("{} takes F per minute, which counts degrees of the table as well as mm", file.name)
    } else {
        return Ok(());
    };
    Err(Error::usage(Stage::Post, format!("{since}, so the table must stand still while both tools cut")).advise(
        "leave out pinch.orientation: hold is its default; or say how far two channels may be apart (pinch.skew_ms)",
    ))
}

/// The programs: one, or one for each of two channels.
///
/// # Errors
/// Those of [`pinch_text`]; kind `Usage` where a number or a block does not fit; kind `Infeasible`
/// where the control reads no F as large, or where in two channels the table moves while the tools
/// cut.
pub fn pinch_programs(dialect: &Dialect, p: &PinchProgram) -> Result<Vec<PinchFile>> {
    let text = pinch_text(dialect, p.machine, p.channels)?;
    let all = 0..p.machine.axes().len();
    let is_second = |k: &usize| p.machine.axes()[*k].carries == Carries::Head(1);
    if p.channels != 2 {
        return Ok(vec![Writer::new(dialect, text, p, None, all.collect()).written()?]);
    }
    if p.skew_ms.is_none() {
        p.motion.stretches.iter().try_for_each(|stretch| table_stands(p.machine, stretch))?;
    }
    let own = [all.clone().filter(|k| !is_second(k)).collect(), all.filter(is_second).collect::<Vec<_>>()];
    own.into_iter().enumerate().map(|(k, own)| Writer::new(dialect, text, p, Some(k), own).written()).collect()
}

/// In two channels what moves the workpiece stands still from over the first place to over the
/// last.
fn table_stands(machine: &Machine, stretch: &StretchMotion) -> Result<()> {
    let shared = |axis: &Axis| !matches!(axis.carries, Carries::Head(_));
    for (k, axis) in machine.axes().iter().enumerate().filter(|(k, a)| shared(a) || *k == machine.turning_axis()) {
        let from = stretch.over[0][k];
        let rows = stretch.motion.position.iter().map(|r| r[k]).chain([stretch.over[1][k]]);
        let moved = rows.map(|at| (at - from).abs()).fold(0.0, f64::max);
        if !(moved <= STILL) {
            let moved = axis.shown(moved);
            let message = format!(
                "{} moves by {moved:.4} {} in row {} while both tools cut: two channels keep time by wait marks only, so it has to stand still",
                axis.name,
                axis.unit(),
                stretch.row + 1
            );
            let since = Infeasible::TableMovesInRow { axis: axis.name.clone(), row: stretch.row, moved };
            return Err(Error::infeasible(Stage::Post, message, since)
                .advise("leave pinch.channels out: one channel moves all axes in one clock; or state pinch.skew_ms"));
        }
    }
    Ok(())
}

/// A program in the making.
struct Writer<'a> {
    dialect: &'a Dialect,
    text: &'a PinchText,
    p: &'a PinchProgram<'a>,
    /// Channel, from 0; `None`: there is one.
    channel: Option<usize>,
    /// Columns of its axes.
    own: Vec<usize>,
    lines: Lines<'a>,
    /// Where the axes stand behind the next line.
    at: Axes,
    /// What was written of them last.
    stands: Vec<Option<Fixed>>,
    /// Time of the next line, s.
    takes_s: f64,
    /// Row and stretch, from 0.
    place: [usize; 2],
    /// Number of the wait mark that comes next.
    mark: u32,
}

impl<'a> Writer<'a> {
    fn new(
        dialect: &'a Dialect,
        text: &'a PinchText,
        p: &'a PinchProgram<'a>,
        channel: Option<usize>,
        own: Vec<usize>,
    ) -> Self {
        let axes = p.machine.axes().len();
        let at = p.motion.stretches.first().map_or_else(|| Axes::of_default(axes), |s| s.over[0]);
        let (lines, stands) = (Lines::new(&dialect.file), vec![None; axes]);
        Writer { dialect, text, p, channel, own, lines, at, stands, takes_s: 1.0, place: [0; 2], mark: 1 }
    }

    fn written(mut self) -> Result<PinchFile> {
        let (p, text) = (self.p, self.text);
        for line in &self.dialect.file.file_begin {
            let line = self.filled(&line.replace("{name}", p.name))?;
            self.lines.block(&line)?;
        }
        self.header();
        for note in &text.notes {
            let note = self.filled(note)?;
            self.lines.comment(&note);
        }
        self.lines.mark();
        self.put(&text.start)?;
        if p.settings.look_ahead {
            self.put(&text.look_ahead)?;
        }
        self.put(&text.approach)?;
        for stretch in &p.motion.stretches {
            self.stretch(stretch)?;
        }
        if p.settings.look_ahead {
            self.put(&text.look_ahead_end)?;
        }
        self.lines.mark();
        self.put(&text.end)?;
        for line in &self.dialect.file.file_end {
            self.lines.block(&line.replace("{name}", p.name))?;
        }
        Ok(PinchFile { name: file_name(text, self.channel), text: self.lines.finished().0 })
    }

    fn stretch(&mut self, stretch: &StretchMotion) -> Result<()> {
        let (p, text, motion) = (self.p, self.text, &stretch.motion);
        if motion.position.is_empty() {
            return Ok(());
        }
        let [down_s, plunge_s, up_s] = stretch.ways_s(p.settings.approach_feed_mm_min, p.settings.plunge_feed_mm_min);
        (self.place, self.at) = ([stretch.row, stretch.stretch], stretch.over[0]);
        self.lines.mark();
        self.put(&text.row)?;
        // Down to the feed height, and slower from there on.
        if down_s > LEAST_S {
            (self.at, self.takes_s) = (stretch.near, down_s);
            self.put(&text.down)?;
        }
        (self.at, self.takes_s) = (Axes::from(&motion.position[0]), plunge_s.max(LEAST_S));
        self.put(&text.down)?;
        // A motion from one place to the next has rows between them, which are no lines.
        for place in 1..stretch.places.len() {
            let [before, k] = [place - 1, place].map(|place| stretch.row_at(place));
            (self.at, self.takes_s) = (Axes::from(&motion.position[k]), motion.t_s[k] - motion.t_s[before]);
            let lines = if self.channel.is_some() && self.is_still()? { &text.stand } else { &text.cut };
            self.put(lines)?;
        }
        (self.at, self.takes_s) = (stretch.over[1], up_s.max(LEAST_S));
        self.put(&text.up)
    }

    /// No axis of the channel moves in the next line, as it is rounded: a control would pass that
    /// line at once.
    fn is_still(&self) -> Result<bool> {
        for k in &self.own {
            if Some(self.rounded(*k, self.at[*k])?) != self.stands[*k] {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What the program is, at its head.
    fn header(&mut self) {
        let (p, lines) = (self.p, &mut self.lines);
        let axes = p.machine.axes();
        let channel = self.channel.map_or_else(String::new, |k| format!(", channel {} of 2", k + 1));
        lines.comment(&format!(
            "{} by bladewright {} for {}{channel}: two tools on one blade",
            p.name,
            env!("CARGO_PKG_VERSION"),
            self.text.name.as_ref().unwrap_or(&self.dialect.file.name)
        ));
        if !p.part_file.is_empty() {
            let hash = if p.part_hash.is_empty() { String::new() } else { format!(", BLAKE3 {}", p.part_hash) };
            lines.comment(&format!("Part {}{hash}", p.part_file));
        }
        lines.comment(&format!("Machine {}: positions of its axes, mm and degrees.", p.machine.name));
        for axis in axes.iter().filter(|a| a.counts_diameter) {
            lines.comment(&format!(
                "DIAMETER words of {} are twice its position: the control must count diameters",
                axis.name
            ));
        }
        let assumed = p.machine.assumed_limits();
        if !assumed.is_empty() {
            lines.comment(&format!("LIMITS of {} are ASSUMED, not measured: times are estimates", assumed.join(" ")));
        }
        for (k, t) in p.tools.iter().enumerate() {
            lines.comment(&format!(
                "Tool {} ball end, R {:.4} mm, half angle of taper {:.3} deg, shank R {:.3} mm, spindle {} 1/min. \
                 It must stand out {:.4} mm from the gauge line to its TIP; any other length cuts elsewhere.",
                k + 1,
                t.radius_mm,
                t.taper_deg,
                t.shank_radius_mm,
                p.spindle_rpm[k],
                to_tip_mm(t)
            ));
        }
        lines.comment(
            "Tool lengths, pivots and the place of the part are in the positions: no length offset, no work offset.",
        );
        lines.comment(
            "Both tools are loaded before the start. With both spindles turning right one side climbs, the other cuts conventionally.",
        );
        let turning = p.machine.turning_axis();
        let moves = |s: &&StretchMotion| {
            let mut rows = s.motion.position.iter().map(|r| r[turning] - s.over[0][turning]);
            rows.any(|moved| moved.abs() > STILL)
        };
        let table = match p.motion.stretches.iter().filter(moves).count() {
            0 => "stands still while both cut".to_owned(),
            n => format!("turns in {n} of them while both cut"),
        };
        if let (Some(ms), Some(_)) = (p.skew_ms, self.channel) {
            lines.comment(&format!("CAUTION checked for channels that are at most {ms} ms apart while both cut."));
        }
        lines.comment(&format!(
            "{} rows in {} stretches; {} {table}.",
            rows(p.motion),
            p.motion.stretches.len(),
            axes[turning].name
        ));
        lines.comment(&format!(
            "Cutting {:.1} s, and about {:.1} s for the ways down, up and from row to row.",
            p.motion.cutting_s, p.motion.ways_s
        ));
    }

    /// Writes lines.
    fn put(&mut self, lines: &[String]) -> Result<()> {
        for line in lines {
            let text = self.filled(line)?;
            match text.strip_prefix("; ") {
                Some(comment) => self.lines.comment(comment),
                None => self.lines.block(text.trim_end())?,
            }
            if line.contains("{mark}") {
                self.mark = if self.text.last_mark.is_some_and(|last| self.mark >= last) { 1 } else { self.mark + 1 };
            }
            let told: &[&str] = &["{axes}", "{moving}", "{rotary}", "{sides}"];
            if told.iter().any(|key| line.contains(key)) {
                for k in self.own.clone() {
                    // What was not written yet is written in the next line.
                    let is_told = line.contains("{axes}") || self.is_told(line, k);
                    if is_told {
                        self.stands[k] = Some(self.rounded(k, self.at[k])?);
                    }
                }
            }
        }
        Ok(())
    }

    /// A line with a key for some axes names this one.
    fn is_told(&self, line: &str, k: usize) -> bool {
        let is_rotary = self.p.machine.axes()[k].is_rotary();
        match is_rotary {
            true => line.contains("{rotary}") || line.contains("{moving}"),
            false => line.contains("{moving}") || line.contains("{sides}") && !self.ups().iter().any(|u| u.0 == k),
        }
    }

    fn filled(&self, line: &str) -> Result<String> {
        let failed = std::cell::RefCell::new(None);
        let value = |key: &str| self.value(key).map_err(|e| *failed.borrow_mut() = Some(e));
        pinch_text::filled(line, value).map_err(|key| {
            let unknown = || Error::usage(Stage::Post, format!("there is no value {{{key}}} in `{line}`"));
            failed.take().unwrap_or_else(unknown)
        })
    }

    fn value(&self, key: &str) -> Result<String> {
        let (p, axes) = (self.p, self.p.machine.axes());
        let channel = self.channel.unwrap_or(0);
        let linear = |k: &usize| !axes[*k].is_rotary();
        let ups = self.ups();
        let is_up = |k: &usize| ups.iter().any(|u| u.0 == *k);
        let these = |wanted: &dyn Fn(&usize) -> bool| -> Vec<usize> {
            self.own.iter().copied().filter(|k| wanted(k)).collect()
        };
        let names = |between: &str, wanted: &dyn Fn(&usize) -> bool| {
            these(wanted).into_iter().map(|k| axes[k].name.as_str()).collect::<Vec<_>>().join(between)
        };
        Ok(match key {
            "axes" => self.words(these(&|_| true), &self.at)?,
            "rotary" => self.words(these(&|k| !linear(k)), &self.at)?,
            "sides" => self.words(these(&|k| linear(k) && !is_up(k)), &self.at)?,
            "moving" => {
                let turned = |k: &usize| self.rounded(*k, self.at[*k]).ok() != self.stands[*k];
                self.words(these(&|k| linear(k) || turned(k)), &self.at)?
            }
            "up" => {
                let mut at = self.at;
                ups.iter().for_each(|u| at[u.0] = u.1);
                self.words(ups.iter().map(|u| u.0).collect(), &at)?
            }
            "linear_names" => names(",", &linear),
            "names" => names(" ", &|_| true),
            "f" => self.feed()?,
            "seconds" => format!("{:.6}", self.takes_s),
            "row" => (self.place[0] + 1).to_string(),
            "stretch" => (self.place[1] + 1).to_string(),
            "channel" => (channel + 1).to_string(),
            "other" => (2 - channel).to_string(),
            "other_file" => file_name(self.text, Some(1 - channel)),
            "mark" => self.mark.to_string(),
            "rpm" => p.spindle_rpm[channel].to_string(),
            "rpm_1" => p.spindle_rpm[0].to_string(),
            "rpm_2" => p.spindle_rpm[1].to_string(),
            "length_1" => format!("{:.4}", to_tip_mm(p.tools[0])),
            "length_2" => format!("{:.4}", to_tip_mm(p.tools[1])),
            "turning_name" => axes[p.machine.turning_axis()].name.clone(),
            "tolerance" => tolerance_mm(self.dialect, p.settings).to_string(),
            "program_number" => "0001".into(),
            _ => return Err(Error::usage(Stage::Post, format!("there is no value {{{key}}}"))),
        })
    }

    /// Columns of the axes that lead this channel's tools away, and the ends of their travel.
    fn ups(&self) -> Vec<(usize, f64)> {
        let axes = self.p.machine.axes();
        let heads = (0..2).filter_map(|head| self.p.machine.retract_axis_of(head));
        let end = |(k, sense): (usize, f64)| {
            let travel: Option<[f64; 2]> = axes[k].limits.travel;
            (k, travel.map_or(0.0, |[least, most]| if sense < 0.0 { least } else { most }))
        };
        heads.filter(|up| self.own.contains(&up.0)).map(end).collect()
    }

    fn words(&self, columns: Vec<usize>, at: &[f64]) -> Result<String> {
        let words = columns.into_iter().map(|k| self.word(k, at[k])).collect::<Result<Vec<_>>>()?;
        Ok(words.iter().filter(|w| !w.is_empty()).map(String::as_str).collect::<Vec<_>>().join(" "))
    }

    /// The word of an axis; nothing where the machine has it not.
    fn word(&self, k: usize, at: f64) -> Result<String> {
        let axis = &self.p.machine.axes()[k];
        if axis.is_missing {
            return Ok(String::new());
        }
        let turning = self.text.turning_axis.as_ref().filter(|_| k == self.p.machine.turning_axis());
        let endless = axis.limits.travel.is_none();
        let numbers = &self.dialect.file.numbers;
        let rounded = self.rounded(k, at)?;
        let within = if turning.is_some() && endless { rounded.modulo(360) } else { rounded };
        let template = turning.unwrap_or(&self.text.axis);
        let way = if endless { "DC" } else { "AC" };
        let said = template.replace("{name}", &axis.name).replace("{way}", way);
        Ok(said.replace("{at}", &within.text(numbers.plus, numbers.trim)))
    }

    fn rounded(&self, k: usize, at: f64) -> Result<Fixed> {
        let (axis, numbers) = (&self.p.machine.axes()[k], &self.dialect.file.numbers);
        let decimals = if axis.is_rotary() { numbers.angle_decimals } else { numbers.length_decimals };
        Fixed::new(axis.shown(at) * axis.word_per_mm(), decimals)
    }

    /// F of the next line.
    fn feed(&self) -> Result<String> {
        let file = &self.dialect.file;
        let f = match file.feed {
            FeedWord::InverseTime => 60.0 / self.takes_s,
            FeedWord::PerMinute | FeedWord::PerMinuteOfAll => {
                let mut sum = 0.0;
                for k in self.own.iter().copied().filter(|k| !self.p.machine.axes()[*k].is_rotary()) {
                    let per_mm = self.p.machine.axes()[k].word_per_mm();
                    let to = self.rounded(k, self.at[k])?;
                    sum += (to.since(self.stands[k].unwrap_or(to)).value() / per_mm).powi(2);
                }
                60.0 * sum.sqrt() / self.takes_s
            }
        };
        let range = file.feed_range();
        feed_word(f, &range).ok_or_else(|| {
            let what = format!(
                "{}: a line of row {} that takes {:.3} ms would need F {f:.6}, the control reads {} to {}",
                file.name,
                self.place[0] + 1,
                1e3 * self.takes_s,
                range.least,
                range.greatest
            );
            let (at_s, range) = (0.0, [range.least, range.greatest]);
            let since = Infeasible::FeedWordOutOfRange { at_s, takes_s: self.takes_s, needed: f, range };
            Error::infeasible(Stage::Post, what, since)
                .advise("change feed.feed_mm_min or path.chord_mm, or ranges.F of the post file")
        })
    }
}

/// Tolerance that the control may smooth by, mm.
pub fn tolerance_mm(dialect: &Dialect, settings: &PostSettings) -> f64 {
    settings.smoothing_mm.or(dialect.file.resolution_mm).unwrap_or(0.001)
}

/// Name of the file of a channel's program, from 0; `None`: there is one channel.
fn file_name(text: &PinchText, channel: Option<usize>) -> String {
    text.file.replace("{channel}", &(channel.unwrap_or(0) + 1).to_string())
}

/// From the gauge line to the tip, mm.
fn to_tip_mm(tool: &Tool) -> f64 {
    tool.length_mm() + tool.radius_mm
}

/// Rows of a motion.
fn rows(motion: &PinchMotion) -> usize {
    let mut rows: Vec<usize> = motion.stretches.iter().map(|s| s.row).collect();
    rows.dedup();
    rows.len()
}
