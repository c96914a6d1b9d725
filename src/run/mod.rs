//! The files of a run: they come into its folder together or not at all, and nothing of an earlier
//! run stays beside them.
//!
//! A [`RunFolder`] collects every file in a temporary folder inside the target and moves them in at
//! the end, under a journal (`staging.rs`): an error, an interruption, a full disk or a kill leaves
//! the folder as it was.

pub mod again;
pub mod anew;
mod checking;
pub mod compare;
mod course;
mod figures;
mod folder;
pub mod inputs;
mod look;
mod making;
pub mod manifest;
pub mod operations;
pub mod pinch;
mod programs;
mod repost;
pub mod reuse;
mod staging;
pub mod summary;
pub mod tables;

use std::path::Path;

pub use course::Course;
pub use folder::RunFolder;
pub use inputs::Loaded;
pub use look::{plots, preview_again};
pub use making::{Outcome, in_memory, run, run_on};
pub use programs::{ProgramsAgain, programs_again};
use staging::Staging;
pub(crate) use staging::sync;

use crate::error::{Error, Result, Stage};

/// Name and version of this program.
pub fn program() -> String {
    format!("bladewright {}", env!("CARGO_PKG_VERSION"))
}

/// The build: a hash of the sources, the built-in data and the versions of all dependencies. Two
/// programs with the same one compute the same; what the system's own mathematics library gives for
/// the last digit of a sine is not in it.
pub fn build() -> &'static str {
    env!("BLADEWRIGHT_BUILD")
}

fn trouble(what: &str, path: &Path, e: std::io::Error) -> Error {
    Error::io(Stage::Output, format!("{what} {}: {e}", path.display()))
        .advise("check that the folder is writable and the disk has room")
        .caused_by(e)
}

/// Puts a folder right that a killed process left in the middle of bringing files in: they are
/// taken out again. To be called before files of a finished run are read.
///
/// # Errors
/// Kind `InputOutput` where they cannot be taken out.
pub fn settle(folder: &Path) -> Result<()> {
    staging::settle(folder).map_err(|e| trouble("cannot undo what was left half-done in", folder, e))
}

/// Writes one file, whole or not at all; into a pipe or a device straight.
///
/// # Errors
/// Kind `InputOutput`.
pub fn write_file(path: &Path, content: &[u8]) -> Result<()> {
    use std::io::Write;
    let write = || -> std::io::Result<()> {
        // A user who names a device means it, not a file in its place.
        if std::fs::metadata(path).is_ok_and(|m| !m.is_file() && !m.is_dir()) {
            return std::fs::File::options().write(true).open(path)?.write_all(content);
        }
        let parent = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let staging = Staging::within(parent)?;
        let part = staging.file("part");
        let mut file = std::fs::File::create(&part)?;
        file.write_all(content)?;
        file.sync_all()?;
        std::fs::rename(&part, path)
    };
    write().map_err(|e| trouble("cannot write", path, e))
}

/// A value as indented JSON with a final newline.
///
/// # Errors
/// Kind `InputOutput` where it cannot be written.
pub fn json(value: &impl serde::Serialize) -> Result<String> {
    serde_json::to_string_pretty(value)
        .map(|s| s + "\n")
        .map_err(|e| Error::io(Stage::Output, format!("a result cannot be written as JSON: {e}")).caused_by(e))
}

/// A value as JSON on one line: for files that only programs read.
///
/// # Errors
/// Kind `InputOutput` where it cannot be written.
pub fn json_compact(value: &impl serde::Serialize) -> Result<String> {
    serde_json::to_string(value)
        .map_err(|e| Error::io(Stage::Output, format!("a result cannot be written as JSON: {e}")).caused_by(e))
}
