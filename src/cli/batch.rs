//! `batch`: a family of blades.

use std::collections::BTreeMap;
use std::io::IsTerminal;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::args::{Batch, BatchVerb};
use super::out::{self, sayln};
use crate::batch::{self, BatchOptions, Done, Effort, Family, Record, Shard, Status, Watch};
use crate::error::{Error, Result, Stage};
use crate::observe::{Observer, Warning};

/// Runs the verb; the exit code.
pub fn run(args: &Batch, quiet: bool) -> Result<u8> {
    if let Some(BatchVerb::Merge { family, out }) = &args.verb {
        let done = batch::merge(&Family::load(family)?, out)?;
        print(&done, out);
        return Ok(done.exit_code());
    }
    let missing = |what: &str| Error::usage(Stage::Job, format!("{what} is missing"));
    let family = Family::load(args.family.as_deref().ok_or_else(|| missing("the family file"))?)?;
    let shard = args.shard.unwrap_or(Shard::ALL);
    if args.list {
        list(&family, shard)?;
        return Ok(0);
    }
    let out = args.out.as_deref().ok_or_else(|| missing("-o"))?;
    let options = BatchOptions { shard, memory_mib: args.memory, retry: args.retry, ..BatchOptions::default() };
    let screen = Screen::new(quiet);
    let done = batch::run(&family, out, &options, &screen);
    screen.finish();
    let done = done?;
    print(&done, out);
    Ok(done.exit_code())
}

fn list(family: &Family, shard: Shard) -> Result<()> {
    sayln!("{:<48} {:>10} {:>12}", "member", "cost", "memory MiB");
    for m in batch::list(family, shard)? {
        sayln!("{:<48} {:>10.2} {:>12}", m.name, m.cost, m.memory_mib);
    }
    Ok(())
}

/// Counts, then every member that is not good, then the tables.
fn print(done: &Done, out: &str) {
    let count = |s: Status| done.records.iter().filter(|r| r.status == s).count();
    let all = [Status::Good, Status::Findings, Status::Failed, Status::Missing];
    let counts: Vec<String> =
        all.iter().filter(|s| count(**s) > 0).map(|s| format!("{} {}", count(*s), s.word())).collect();
    sayln!("{} members: {}; {} computed now", done.records.len(), counts.join(", "), done.computed);
    for r in done.records.iter().filter(|r| r.status != Status::Good) {
        let stage = r.stage.map(|s| format!(" in {s}")).unwrap_or_default();
        let reason = r.reason.as_deref().map(|w| format!(": {w}")).unwrap_or_default();
        sayln!("  {} {}{stage}{reason}", r.name, r.status.word());
    }
    for file in &done.files {
        sayln!(
            "{}",
            if out.starts_with("s3://") {
                format!("{out}/{file}")
            } else {
                Path::new(out).join(file).display().to_string()
            }
        );
    }
}

/// One display for all members: a bar over the family, and one for each member at work. Elsewhere
/// than on a terminal a line for each member.
struct Screen {
    bars: MultiProgress,
    whole: ProgressBar,
    stop: Arc<AtomicBool>,
    lines: bool,
    begun: AtomicUsize,
    to_do: AtomicUsize,
    warnings: Mutex<BTreeMap<String, usize>>,
}

impl Screen {
    fn new(quiet: bool) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let target = if quiet || !terminal { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bars = MultiProgress::with_draw_target(target);
        let whole = bars.add(ProgressBar::new(1));
        if let Ok(style) = ProgressStyle::with_template("{msg:<48.48} {bar:24} {pos}/{len}  {elapsed} (left {eta})") {
            whole.set_style(style);
        }
        whole.set_message("family");
        let stop = super::signals::stop_flag(super::signals::FAMILY);
        let lines = !quiet && !terminal;
        Screen {
            bars,
            whole,
            stop,
            lines,
            begun: AtomicUsize::new(0),
            to_do: AtomicUsize::new(0),
            warnings: Mutex::default(),
        }
    }

    fn finish(&self) {
        self.whole.finish_and_clear();
    }

    fn say(&self, text: &str) {
        self.bars.suspend(|| out::told(text));
    }
}

impl Watch for Screen {
    fn begins(&self, to_do: usize, kept: usize) {
        self.whole.set_length(to_do as u64);
        self.to_do.store(to_do, Ordering::Relaxed);
        if self.lines {
            self.say(&format!("{to_do} to compute, {kept} kept"));
        }
    }

    fn member(&self, name: &str) -> Box<dyn Observer + '_> {
        let bar = self.bars.add(ProgressBar::new(1));
        if let Ok(style) = ProgressStyle::with_template("{msg:<48.48} {bar:24} {percent:>3} %") {
            bar.set_style(style);
        }
        Box::new(MemberBar { screen: self, name: name.to_owned(), bar })
    }

    fn ended(&self, record: &Record, effort: &Effort) {
        self.whole.inc(1);
        let begun = self.begun.fetch_add(1, Ordering::Relaxed) + 1;
        let told = self.warnings.lock().unwrap_or_else(PoisonError::into_inner).remove(&record.name).unwrap_or(0);
        let warnings = if told > 0 { format!(", {told} warnings") } else { String::new() };
        let reason = record.reason.as_deref().map(|r| format!(": {r}")).unwrap_or_default();
        let line = format!("{} {}{reason}", record.name, record.status.word());
        if self.lines {
            let (n, s) = (self.to_do.load(Ordering::Relaxed), effort.seconds);
            self.say(&format!("[{begun}/{n}] {line} ({s:.1} s{warnings})"));
        } else if record.status != Status::Good && !self.whole.is_hidden() {
            self.say(&line);
        }
    }

    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// One member at work.
struct MemberBar<'a> {
    screen: &'a Screen,
    name: String,
    bar: ProgressBar,
}

impl Drop for MemberBar<'_> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        self.screen.bars.remove(&self.bar);
    }
}

impl Observer for MemberBar<'_> {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        self.bar.set_message(format!("{:<8} {}", stage.to_string(), out::visible(&self.name)));
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
    }

    // Warnings of thousands of members would hide each other: they are counted, and stand in each
    // member's manifest.json and report.
    fn warn(&self, _warning: Warning) {
        *self.screen.warnings.lock().unwrap_or_else(PoisonError::into_inner).entry(self.name.clone()).or_default() += 1;
    }
}
