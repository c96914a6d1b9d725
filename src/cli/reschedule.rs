//! `reschedule`: a program that others wrote, with its tool axis scheduled anew.

use std::path::Path;

use super::args::Reschedule;
use super::fit::{self, Fitted};
use super::out::{amount, limit, sayln};
use super::progress::Terminal;
use super::{inspect, theirs};
use crate::artifact::schedule::ThetaRow;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::machine::Machine;
use crate::observe::{Observer, timed};
use crate::plan::{different_files, post_name, program_name};
use crate::read::model;
use crate::read::program::Bench;
use crate::register::Fit;
use crate::reschedule::{self, RescheduleOptions, Rescheduled, StretchReport};
use crate::run::anew::{self, WrittenAnew};
use crate::run::manifest::Clock;
use crate::run::{RunFolder, inputs};
use crate::verify::audit::AuditOptions;
use crate::write::draw;
use crate::write::post::{Dialect, PostOptions};

/// Stretches that are printed; all are in the report.
const TOLD: usize = 12;

/// Runs the verb; the exit code.
pub fn run(args: &Reschedule, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let clock = Clock::new(&terminal);
    let ended = rescheduled(args, &clock);
    terminal.finish();
    let Ended { made, anew, fit, why } = ended?;
    sayln!("program    {}: {why}", args.program.display());
    fit.iter().for_each(fit::tell);
    tell(&made);
    anew.iter().for_each(tell_anew);
    told_times(&clock);
    Ok(0)
}

/// What came of it.
struct Ended {
    made: Rescheduled,
    /// The same for other controls.
    anew: Vec<WrittenAnew>,
    fit: Option<Fit>,
    /// How the program was read.
    why: String,
}

fn rescheduled(args: &Reschedule, observer: &dyn Observer) -> Result<Ended> {
    let name = args.program.file_name().map(|n| n.to_string_lossy().into_owned());
    let name = name.ok_or_else(|| Error::usage(Stage::Job, format!("{} is no file", args.program.display())))?;
    let same = |a: &Path, b: &Path| a.canonicalize().ok().zip(b.canonicalize().ok()).is_some_and(|(a, b)| a == b);
    if same(&args.program, &args.out.join(&name)) {
        let what = format!("the new program would take the place of {}", args.program.display());
        return Err(Error::usage(Stage::Job, what).advise("give another folder with -o"));
    }
    let text = Text::of(&theirs::bytes(&args.program)?);
    let dialects = dialects(args)?;
    let (language, why) = theirs::language(&args.program, &args.manner, &text.lines)?;
    let mut folder = RunFolder::begin(&args.out)?;
    let tool = inputs::tool(&args.tool)?;
    let machine = args.machine.as_ref().map_or_else(Machine::demo, |f| inputs::machine(f))?;
    let load = || model::load(&args.part, &inspect::reading(&args.reading), observer);
    let blade = timed(observer, Stage::Model, load)?;
    let zero = theirs::zero(&args.manner, &blade);
    let mut benches = [Bench { language, zero, tool: &tool, machine: &machine }];
    let fit = fit::place((&args.manner, args.stock), &text.lines, &mut benches, &blade, observer)?;
    let options = options(args);
    let made = reschedule::reschedule(&text.lines, &blade, &benches[0], &options, observer)?;
    let audit = AuditOptions { stock_mm: made.stock_mm, ..options.audit };
    let (new, post) = ((&made.text[..], &benches[0]), post_options(args, &name)?);
    let anew = timed(observer, Stage::Post, || anew::programs(new, &blade, &audit, &dialects, &post, observer))?;
    let named = made.stretches.iter().map(|s| (title(s), &s.theta[..]));
    let svg = draw::rescheduled_svg(&named.collect::<Vec<(String, &[ThetaRow])>>());
    folder.add(&name, text.bytes(&made.text))?;
    for other in &anew {
        folder.add(&other.file, other.program.text.as_bytes())?;
    }
    folder.add_json("reschedule.json", &Fitted::new(&made, fit.as_ref()).with_programs(&anew))?;
    folder.add("reschedule.svg", svg)?;
    for file in folder.finish()? {
        sayln!("{}", file.display());
    }
    Ok(Ended { made, anew, fit, why })
}

/// The dialects that the program is to be written in besides; no two have the same file.
fn dialects(args: &Reschedule) -> Result<Vec<Dialect>> {
    let built_in = args.controls.iter().map(|c| Ok((c.to_string(), Dialect::built_in(*c)?)));
    let own = args.post_file.iter().map(|f| Ok((post_name(f), inputs::dialect(f)?)));
    let all = built_in.chain(own).collect::<Result<Vec<_>>>()?;
    different_files(&all)?;
    Ok(all.into_iter().map(|(_, dialect)| dialect).collect())
}

/// What programs for other controls say of where they come from: the program `name`.
fn post_options(args: &Reschedule, name: &str) -> Result<PostOptions> {
    let unreadable = |e| Error::io(Stage::Model, format!("cannot read {}: {e}", args.part.display())).caused_by(e);
    Ok(PostOptions {
        program_name: program_name(&args.program.file_stem().unwrap_or_default().to_string_lossy()),
        part_file: args.part.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        part_hash: files::hash(&args.part, files::LONG).map_err(unreadable)?.1,
        job: format!("{name}, its tool axis scheduled anew"),
        ..PostOptions::default()
    })
}

/// What became of the program for another control.
fn tell_anew(made: &WrittenAnew) {
    let WrittenAnew { file, control, lines, time_s, operations, left_out, failed, .. } = made;
    let of = if *operations == 1 { "1 operation".into() } else { format!("{operations} operations") };
    sayln!("written    {file} for {control}: {of}, {lines} lines, {time_s:.1} s");
    if *left_out > 0 {
        sayln!("           {left_out} runs of feed moves come nowhere to the part, they are left out");
    }
    if !failed.is_empty() {
        sayln!("           its header says NOT VERIFIED: the program it is made from fails {}", failed.join(", "));
    }
}

fn options(args: &Reschedule) -> RescheduleOptions {
    let mut options = RescheduleOptions {
        stock_mm: args.stock,
        feed_mm_min: args.feed,
        audit: AuditOptions::default().with(|s| s.gouge_mm = args.gouge),
        ..RescheduleOptions::default()
    };
    options.schedule.kind = args.schedule.unwrap_or(options.schedule.kind);
    options.channel.clearance_mm = args.clearance.unwrap_or(options.channel.clearance_mm);
    options.channel.holder_clearance_mm = args.holder_clearance.unwrap_or(options.channel.holder_clearance_mm);
    options
}

/// A program's bytes as text, one character each, so that all that is not written anew comes back
/// as it was.
struct Text {
    lines: String,
    /// Lines end in CR alone.
    carriage: bool,
    /// Bytes before the text.
    mark: Vec<u8>,
}

impl Text {
    fn of(bytes: &[u8]) -> Self {
        let body = model::format::without_mark(bytes);
        let mark = bytes.get(..bytes.len() - body.len()).unwrap_or_default().to_vec();
        let lines: String = body.iter().map(|b| char::from(*b)).collect();
        let carriage = lines.contains('\r') && !lines.contains('\n');
        Text { lines: if carriage { lines.replace('\r', "\n") } else { lines }, carriage, mark }
    }

    /// The bytes of a text made from this one.
    fn bytes(&self, text: &str) -> Vec<u8> {
        let ends = |c: char| if self.carriage && c == '\n' { '\r' } else { c };
        let body = text.chars().map(|c| u8::try_from(ends(c)).unwrap_or(b'?'));
        self.mark.iter().copied().chain(body).collect()
    }
}

fn title(stretch: &StretchReport) -> String {
    let [first, last] = stretch.new_lines.unwrap_or(stretch.lines);
    let time = stretch.time_s.map_or_else(String::new, |[a, b]| format!(", {a:.2} s before, {b:.2} s after"));
    format!("Lines {first} to {last}{time}")
}

/// How long the work took, by stage.
fn told_times(clock: &Clock) {
    let mut took: Vec<(Stage, f64)> = Vec::new();
    for record in clock.records() {
        match took.iter_mut().find(|(stage, _)| *stage == record.stage) {
            Some((_, seconds)) => *seconds += record.seconds,
            None => took.push((record.stage, record.seconds)),
        }
    }
    let took: Vec<String> = took.iter().map(|(stage, seconds)| format!("{stage} {seconds:.1} s")).collect();
    sayln!("work       {}", took.join(", "));
}

/// What became of the program, as lines.
fn tell(made: &Rescheduled) {
    let [before, after] = made.time_s();
    let new = made.stretches.iter().filter(|s| s.new_lines.is_some()).count();
    sayln!("stretches  {} of {} scheduled anew; stock {:.4} mm", new, made.stretches.len(), made.stock_mm);
    let share = if before > 0.0 { 100.0 * (after / before - 1.0) } else { 0.0 };
    sayln!("time       {before:.2} s before, {after:.2} s after ({share:+.1} %), on this machine from rest to rest");
    sayln!("lines      {} changed, {} added", made.lines_changed, made.lines_added);
    sayln!("centres    at most {:.6} mm off, {:.6} by the rounding of words", made.centre_off_mm, made.centre_limit_mm);
    let keeps = made.stretches.iter().filter_map(|s| s.clearance_mm);
    if let Some([cutter, holder]) = keeps.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])]) {
        sayln!("clearance  planned with {cutter:.3} mm of taper and shank, {holder:.3} mm of the holder");
    }
    for stretch in made.stretches.iter().take(TOLD) {
        let [first, last] = stretch.lines;
        let what = match (&stretch.reason, stretch.reversals) {
            (Some(why), _) => format!("stays: {why}"),
            (None, Some([a, b])) => {
                let [from, to] = stretch.new_lines.unwrap_or(stretch.lines);
                let [before, after] = stretch.time_s.unwrap_or_default();
                format!(
                    "anew from {from} to {to}, {before:.2} s before, {after:.2} s after; \
                     θ turns back {a} times before, {b} after"
                )
            }
            (None, None) => String::new(),
        };
        sayln!("           lines {first} to {last} ({:.1} mm): {what}", stretch.length_mm);
    }
    if made.stretches.len() > TOLD {
        sayln!("           and {} more", made.stretches.len() - TOLD);
    }
    let written = made.stretches.iter().find_map(|s| s.peaks.as_ref());
    for (was, is) in written.into_iter().flat_map(|[before, after]| before.iter().zip(after)) {
        sayln!(
            "axis {}     velocity {:.1} before, {:.1} after; acceleration {:.0} before, {:.0} after",
            is.axis,
            was.velocity,
            is.velocity,
            was.acceleration,
            is.acceleration
        );
    }
    for check in made.after.checks.iter().map(|c| &c.check) {
        let was = made.before.checks.iter().map(|c| &c.check).find(|c| c.id == check.id);
        let verdict = if check.passed { "ok  " } else { "FAIL" };
        let before = was.map_or_else(String::new, |w| format!("; {} before", amount(w.worst)));
        sayln!(
            "{verdict} {:<28} {:>12} {:<8} limit {} {}{before}",
            check.id,
            amount(check.worst),
            check.unit,
            limit(check.limit),
            check.unit
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back_as_they_were() {
        for bytes in [&b"G1 X1\r\nG1 X2 ;\xe4\n"[..], b"G1 X1\rG1 X2\r", b"\xef\xbb\xbfG1 X1\n"] {
            let text = Text::of(bytes);
            assert!(text.lines.contains('\n') && !text.lines.starts_with('\u{ef}'));
            assert_eq!(text.bytes(&text.lines), bytes);
        }
    }
}
