//! `manifest.json`: what went in, what was done, how long it took, what came out.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use crate::error::{Error, Result, Stage};
use crate::files;
use crate::observe::{Observer, Warning};

/// Version of the files of a run; raised when a column or key changes its meaning.
pub const SCHEMA_VERSION: u32 = 1;

/// One stage of a run.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct StageRecord {
    /// Which.
    pub stage: Stage,
    /// Seconds of wall clock.
    pub seconds: f64,
    /// Peak memory of the process up to its end, MiB; absent where the system does not give it.
    pub peak_memory_mib: Option<f64>,
}

/// An input file.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Input {
    /// Path as given.
    pub path: String,
    /// Size, bytes.
    pub bytes: u64,
    /// BLAKE3 hash of its content.
    pub blake3: String,
}

/// The manifest's file.
pub const FILE: &str = "manifest.json";

/// The manifest.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Manifest {
    /// See [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// Program and version.
    pub program: String,
    /// The build: a hash of its sources.
    pub build: String,
    /// Inputs with their hashes.
    pub inputs: Vec<Input>,
    /// The resolved job, its keys by the alphabet: a manifest that is read and written again stays
    /// the same.
    pub job: serde_json::Value,
    /// Stages in order.
    pub stages: Vec<StageRecord>,
    /// Warnings in order of stage.
    pub warnings: Vec<Warning>,
    /// Seal of the checks, see [`crate::verify::seal`]; absent where nothing was checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seal: Option<String>,
    /// Files of the run, but for this one, with the BLAKE3 hashes of their content: those that it
    /// wrote, and those that came to it later.
    pub outputs: BTreeMap<String, String>,
    /// Its programs, and the control or own post file that wrote each.
    #[serde(default)]
    pub programs: BTreeMap<String, String>,
    /// `good`, `findings` or the stage up to which the run went.
    pub status: String,
}

/// The manifest that a text holds; `None`: it is none.
pub fn read(text: &str) -> Option<Manifest> {
    serde_json::from_slice(text.as_bytes()).ok()
}

/// Reads an input's size and hash; `key`: where the job names it.
///
/// # Errors
/// Kind `InputOutput` where it cannot be read.
pub fn input(path: &Path, stage: Stage, key: &str) -> Result<Input> {
    let (bytes, blake3) = files::hash(path, files::LONG)
        .map_err(|e| Error::io(stage, format!("{key}: {} cannot be read: {e}", path.display())).caused_by(e))?;
    Ok(Input { path: path.display().to_string(), bytes, blake3 })
}

/// Size and hash of an input that has been read.
pub fn input_of(path: &Path, bytes: &[u8]) -> Input {
    Input {
        path: path.display().to_string(),
        bytes: bytes.len() as u64,
        blake3: blake3::hash(bytes).to_hex().to_string(),
    }
}

/// Times stages, and passes on to another observer what is reported.
pub struct Clock<'a> {
    inner: &'a dyn Observer,
    times: Mutex<Times>,
}

#[derive(Default)]
struct Times {
    begun: Vec<Instant>,
    records: Vec<StageRecord>,
}

impl<'a> Clock<'a> {
    /// A clock before the first stage.
    pub fn new(inner: &'a dyn Observer) -> Self {
        Clock { inner, times: Mutex::default() }
    }

    /// The stages that have ended, in order, whether they ended well or not.
    pub fn records(&self) -> Vec<StageRecord> {
        self.times().records.clone()
    }

    fn times(&self) -> MutexGuard<'_, Times> {
        self.times.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Observer for Clock<'_> {
    fn progress(&self, stage: Stage, done: usize, total: usize) {
        self.inner.progress(stage, done, total);
    }
    fn begins(&self, stage: Stage) {
        self.inner.begins(stage);
        self.times().begun.push(Instant::now());
    }
    fn ends(&self, stage: Stage) {
        let mut times = self.times();
        if let Some(start) = times.begun.pop() {
            let (seconds, peak_memory_mib) = (start.elapsed().as_secs_f64(), peak_memory_mib());
            times.records.push(StageRecord { stage, seconds, peak_memory_mib });
        }
        drop(times);
        self.inner.ends(stage);
    }
    fn warn(&self, warning: Warning) {
        self.inner.warn(warning);
    }
    fn cancelled(&self) -> bool {
        self.inner.cancelled()
    }
}

/// Peak resident memory of this process, MiB, where the system gives it (Linux).
pub fn peak_memory_mib() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kib| kib / 1024.0)
}
