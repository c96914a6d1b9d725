//! One member: made, planned, checked, written into its folder under `work`, entered in a record.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use super::member::{BladeSource, Member};
use super::picture;
use super::record::{Record, Status};
use super::store::{RECORD, Store, trouble};
use crate::artifact::CheckReport;
use crate::error::{Error, ErrorKind, Result, Stage};
use crate::files;
use crate::job::ModelKeys;
use crate::make;
use crate::observe::{Observer, Warning};
use crate::run::manifest::StageRecord;
use crate::run::reuse::{Earlier, ReadFile};
use crate::run::{self, Course, Outcome, inputs};

/// The model of a made blade, beside its results.
const MODEL: &str = "model.step";

/// What computing a member took: for the log.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Effort {
    /// Its name.
    pub name: String,
    /// Wall clock, s.
    pub seconds: f64,
    /// Threads that it had.
    pub threads: usize,
    /// Stages whose results were taken over.
    pub taken: Vec<Stage>,
    /// Stages that were worked on; memory is the whole process'.
    pub stages: Vec<StageRecord>,
}

/// `log/times.csv`: what computing each member took when it was last computed. A stage that was
/// worked on twice counts once, with both times.
pub(super) fn times(records: &[Record], store: &dyn Store) -> Result<Vec<u8>> {
    const STAGES: [Stage; 9] = [
        Stage::Model,
        Stage::Section,
        Stage::Path,
        Stage::Channel,
        Stage::Schedule,
        Stage::Feed,
        Stage::Verify,
        Stage::Preview,
        Stage::Post,
    ];
    let heads: String = STAGES.iter().map(|s| format!(",{s}_s")).collect();
    let mut text = format!("name,seconds,threads,taken_over,peak_memory_of_process_mib{heads}\n");
    for r in records {
        let log = store.read(&format!("log/{}.json", r.name))?;
        let Some(e) = log.and_then(|t| serde_json::from_slice::<Effort>(&t).ok()) else { continue };
        let taken: Vec<String> = e.taken.iter().map(Stage::to_string).collect();
        let peak = e.stages.iter().filter_map(|s| s.peak_memory_mib).fold(0.0, f64::max);
        let of = |stage: Stage| e.stages.iter().filter(|s| s.stage == stage).map(|s| s.seconds).fold(0.0, |a, b| a + b);
        let each: String = STAGES.iter().map(|s| format!(",{:.3}", of(*s))).collect();
        let name = if e.name.contains(',') { format!("\"{}\"", e.name) } else { e.name };
        text += &format!("{name},{:.3},{},{},{peak:.0}{each}\n", e.seconds, e.threads, taken.join(" "));
    }
    Ok(text.into_bytes())
}

/// A member to be computed.
pub(super) struct Work<'a> {
    pub store: &'a dyn Store,
    pub member: &'a Member,
    pub key: &'a str,
    /// What was there before.
    pub old: Option<&'a Record>,
    /// Another member whose stages may be taken over.
    pub helper: Option<&'a str>,
    pub threads: usize,
}

/// Counts warnings on their way.
struct Counting<'a> {
    inner: &'a dyn Observer,
    warnings: AtomicUsize,
}

impl Observer for Counting<'_> {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        self.inner.progress(stage, done, total);
    }
    fn warn(&self, warning: Warning) {
        self.warnings.fetch_add(1, Ordering::Relaxed);
        self.inner.warn(warning);
    }
    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}

/// Computes a member and takes it in. A member that fails is a record like any other.
///
/// # Errors
/// Those that are not the member's: cancelled, results that cannot be written.
pub(super) fn compute(work: &Work, observer: &dyn Observer) -> Result<(Record, Effort)> {
    let start = Instant::now();
    let (store, name) = (work.store, &work.member.name);
    let folder = store.workshop(name)?;
    let observer = Counting { inner: observer, warnings: AtomicUsize::new(0) };
    let ended = catch_unwind(AssertUnwindSafe(|| plan(work, &folder, &observer))).unwrap_or_else(|panic| {
        let why = panic.downcast_ref::<String>().cloned().or(panic.downcast_ref::<&str>().map(|s| (*s).to_owned()));
        Err(Error::new(
            Stage::Batch,
            ErrorKind::InputOutput,
            format!("a fault of the program: {}", why.unwrap_or_default()),
        )
        .advise("please report it, with the model"))
    });
    let mut record = Record::missing(name, &model_name(&work.member.source), &work.member.parameters);
    let mut effort =
        Effort { name: name.clone(), seconds: 0.0, threads: work.threads, taken: Vec::new(), stages: Vec::new() };
    match ended {
        Ok(outcome) => {
            record = finished(record, work.key, &outcome)?;
            (effort.taken, effort.stages) = (outcome.taken, outcome.stages);
        }
        Err(e) if e.kind == ErrorKind::Cancelled || e.stage == Stage::Output => return Err(e),
        Err(mut e) => {
            // Where the workshop is does not matter to anyone.
            e.message = e.message.replace(&format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR), "");
            record = record.failed(work.key, &e);
        }
    }
    record.warnings = observer.warnings.into_inner();
    record.files = listing(&folder)?;
    run::write_file(&folder.join(RECORD), run::json(&record)?.as_bytes())?;
    store.take_in(&record, work.old)?;
    effort.seconds = start.elapsed().as_secs_f64();
    store.write(&format!("log/{name}.json"), run::json(&effort)?.as_bytes())?;
    Ok((record, effort))
}

pub(super) fn model_name(source: &BladeSource) -> String {
    match source {
        BladeSource::Design(d) => format!("made: {}", d.name),
        BladeSource::Model(path) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
    }
}

fn plan(work: &Work, folder: &Path, observer: &dyn Observer) -> Result<Outcome> {
    let mut job = work.member.job.clone();
    let model = match &work.member.source {
        BladeSource::Model(path) => path.clone(),
        BladeSource::Design(design) => {
            let path = folder.join(MODEL);
            run::write_file(&path, make::step_text(&make::build(design)?)?.as_bytes())?;
            std::path::absolute(&path).unwrap_or(path)
        }
    };
    let keys = job.model.get_or_insert_with(ModelKeys::default);
    keys.file = Some(model.to_string_lossy().into_owned());
    let mut draft = inputs::draft(job, folder)?;
    if matches!(work.member.source, BladeSource::Design(_)) {
        draft = draft.model_saved_as(Path::new(MODEL));
    }
    let own = work.old.filter(|r| r.status != Status::Failed).map(|r| r.name.as_str());
    let earlier: Vec<Earlier> =
        own.into_iter().chain(work.helper).filter_map(|name| earlier(work.store, name)).collect();
    let course = Course { timeless: true, ..Course::default() };
    run::run_on(&draft, folder, course, &earlier, observer)
}

/// A finished member whose stages may be taken over. A file that changed since counts as missing.
fn earlier<'a>(store: &'a dyn Store, name: &'a str) -> Option<Earlier<'a>> {
    let read = move |file: &str| store.read(&format!("members/{name}/{file}")).ok().flatten();
    let record: Record = serde_json::from_slice(&read(RECORD)?).ok()?;
    let as_written = move |file: &str| record.as_written(file, read(file)?);
    Earlier::open(Box::new(as_written) as ReadFile)
}

/// The record of a member that was planned.
fn finished(record: Record, key: &str, outcome: &Outcome) -> Result<Record> {
    let found = outcome.report.as_ref().filter(|r| !r.passed());
    let summary = outcome.summary.as_ref().map(serde_json::to_value).transpose();
    let summary = summary
        .map_err(|e| Error::io(Stage::Output, format!("a summary cannot be written as JSON: {e}")).caused_by(e))?;
    Ok(Record {
        key: key.to_owned(),
        status: if found.is_some() { Status::Findings } else { Status::Good },
        exit_code: if found.is_some() { ErrorKind::Findings.exit_code() } else { 0 },
        stage: found.map(|_| Stage::Verify),
        reason: found.and_then(finding),
        missed: found.map_or_else(Vec::new, CheckReport::missed),
        summary,
        picture: outcome.verdict.as_ref().and_then(|v| picture::of(v.value())),
        ..record
    })
}

/// The first check that failed, and how many others.
fn finding(report: &CheckReport) -> Option<String> {
    let failed: Vec<_> = report.checks.iter().filter(|c| !c.passed).collect();
    let c = failed.first()?;
    let others = match failed.len() {
        1 => String::new(),
        n => format!("; and {} more", n - 1),
    };
    // Limits are products of options: 1.05 × 0.1 is to be read as 0.105.
    let limit = (c.limit * 1e9).round() / 1e9;
    Some(format!("{}: {} is {:.6} {}, limit {limit}{others}", c.id, c.quantity, c.worst, c.unit))
}

/// The files of a folder with the hashes of their content.
fn listing(folder: &Path) -> Result<BTreeMap<String, String>> {
    let hashed = |e: std::fs::DirEntry| -> std::io::Result<(String, String)> {
        Ok((e.file_name().to_string_lossy().into_owned(), files::hash(&e.path(), files::LONG)?.1))
    };
    let read = || -> std::io::Result<BTreeMap<String, String>> {
        let entries = std::fs::read_dir(folder)?.collect::<std::io::Result<Vec<_>>>()?;
        entries.into_iter().filter(|e| e.file_type().is_ok_and(|t| t.is_file())).map(hashed).collect()
    };
    read().map_err(|e| trouble("cannot read", folder, e))
}
