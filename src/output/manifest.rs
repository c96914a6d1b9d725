//! `manifest.json`: what went in, what was done, how long it took, what came out.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

use crate::error::{Error, Result, Stage};
use crate::observe::Warning;

use super::RunFolder;

/// Version of the files of a run; raised when a column or key changes its meaning.
pub const SCHEMA_VERSION: u32 = 1;

/// One stage of a run.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct StageRecord {
    /// Which.
    pub stage: Stage,
    /// Seconds of wall clock.
    pub seconds: f64,
    /// Peak memory of the process up to its end, MiB; absent where the system does not tell.
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

/// The manifest; `J` is the job.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Manifest<J> {
    /// See [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// Program and version.
    pub program: String,
    /// The build: a hash of its sources.
    pub build: String,
    /// Inputs with their hashes.
    pub inputs: Vec<Input>,
    /// The resolved job.
    pub job: J,
    /// Stages in order.
    pub stages: Vec<StageRecord>,
    /// Warnings in order of stage.
    pub warnings: Vec<Warning>,
    /// Seal of the checks, see [`crate::verify::seal`]; absent where nothing was checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seal: Option<String>,
    /// Files that the run wrote, but for this one, with the BLAKE3 hashes of their content.
    pub outputs: BTreeMap<String, String>,
    /// Files that `verify`, `post` and `preview` wrote into the folder since, likewise.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub later: BTreeMap<String, String>,
    /// `good`, `findings` or the stage up to which the run went.
    pub status: String,
}

/// Name of the manifest's file.
pub const FILE: &str = "manifest.json";

/// The manifest that a text holds, its job as it stands there; `None`: it is none.
pub fn read(text: &str) -> Option<Manifest<serde_json::Value>> {
    serde_json::from_str(text).ok()
}

/// Adds to a folder the manifest of the run that is in it, with the files that are about to come into it; nothing where there is no manifest.
///
/// # Errors
/// Kind `InputOutput` where it cannot be written.
pub fn note_later(folder: &mut RunFolder) -> Result<()> {
    let Some(mut manifest) = folder.existing(FILE).as_deref().and_then(read) else { return Ok(()) };
    manifest.later.extend(folder.hashes().clone());
    folder.add_json(FILE, &manifest)
}

/// Reads an input's size and hash.
///
/// # Errors
/// Kind `InputOutput` where it cannot be read.
pub fn input(path: &Path) -> Result<Input> {
    let bytes = std::fs::read(path)
        .map_err(|e| Error::io(Stage::Model, format!("cannot read {}: {e}", path.display())).caused_by(e))?;
    Ok(input_of(path, &bytes))
}

/// Size and hash of an input that has been read.
pub fn input_of(path: &Path, bytes: &[u8]) -> Input {
    Input {
        path: path.display().to_string(),
        bytes: bytes.len() as u64,
        blake3: blake3::hash(bytes).to_hex().to_string(),
    }
}

/// Times stages.
#[derive(Default)]
pub struct Clock {
    /// Stages so far.
    pub records: Vec<StageRecord>,
}

impl Clock {
    /// Runs a stage and records it, whether it ends well or not.
    pub fn time<T>(&mut self, stage: Stage, work: impl FnOnce() -> Result<T>) -> Result<T> {
        let start = Instant::now();
        let out = work();
        self.records.push(StageRecord {
            stage,
            seconds: start.elapsed().as_secs_f64(),
            peak_memory_mib: peak_memory_mib(),
        });
        out
    }
}

/// Peak resident memory of this process, MiB, where the system tells (Linux).
pub fn peak_memory_mib() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kib| kib / 1024.0)
}
