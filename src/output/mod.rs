//! The files of a run: written whole or not at all.
//!
//! A [`RunFolder`] collects every file in a temporary folder beside the target and moves them in at the end, so an
//! error, an interruption or a full disk leaves nothing half-written behind.

pub mod manifest;
pub mod summary;
pub mod tables;

use std::collections::BTreeMap;
use std::fs::File;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result, Stage};

/// A folder of results in the making.
pub struct RunFolder {
    target: PathBuf,
    staging: tempfile::TempDir,
    files: Vec<(String, File)>,
    hashes: BTreeMap<String, String>,
}

fn trouble(what: &str, path: &Path, e: std::io::Error) -> Error {
    Error::io(Stage::Output, format!("{what} {}: {e}", path.display()))
        .advise("check that the folder is writable and the disk has room")
        .caused_by(e)
}

impl RunFolder {
    /// Begins a run folder; fails at once where the target could not be written in the end.
    ///
    /// # Errors
    /// Kind `InputOutput` where no folder can be made beside the target or the target is a file.
    pub fn begin(target: &Path) -> Result<Self> {
        if target.exists() && !target.is_dir() {
            return Err(Error::io(Stage::Output, format!("{} is a file, not a folder", target.display()))
                .advise("give a folder with -o"));
        }
        let parent = match target.parent() {
            Some(p) if !p.as_os_str().is_empty() => p.to_path_buf(),
            _ => PathBuf::from("."),
        };
        std::fs::create_dir_all(&parent).map_err(|e| trouble("cannot make the folder", &parent, e))?;
        // Inside an existing target, so that an unwritable target is found before hours of work, and renames stay on one disk.
        let home = if target.is_dir() { target.to_path_buf() } else { parent };
        let staging = tempfile::Builder::new()
            .prefix(".bladewright-")
            .tempdir_in(&home)
            .map_err(|e| trouble("cannot write in", &home, e))?;
        Ok(RunFolder { target: target.to_path_buf(), staging, files: Vec::new(), hashes: BTreeMap::new() })
    }

    /// Text of a file that an earlier run left in the folder.
    pub fn existing(&self, name: &str) -> Option<String> {
        std::fs::read_to_string(self.target.join(name)).ok()
    }

    /// Content of a file that is in the folder; `None`: it is not there, or cannot be read.
    pub fn content(&self, name: &str) -> Option<Vec<u8>> {
        std::fs::read(self.target.join(name)).ok()
    }

    /// Names of the files that are in the folder, in order; those in folders of it, and hidden ones, are left out.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.target).into_iter().flatten().flatten();
        let files = entries.filter(|e| e.path().is_file()).filter_map(|e| e.file_name().into_string().ok());
        let mut out: Vec<String> = files.filter(|name| !name.starts_with('.')).collect();
        out.sort();
        out
    }

    /// Adds a file.
    ///
    /// # Errors
    /// Kind `InputOutput`.
    pub fn add(&mut self, name: &str, content: impl AsRef<[u8]>) -> Result<()> {
        use std::io::Write;
        let path = self.staging.path().join(name);
        let write = || -> std::io::Result<File> {
            let mut f = File::create(&path)?;
            f.write_all(content.as_ref())?;
            Ok(f)
        };
        let file = write().map_err(|e| trouble("cannot write", &self.target.join(name), e))?;
        self.hashes.insert(name.to_owned(), blake3::hash(content.as_ref()).to_hex().to_string());
        self.files.retain(|(known, _)| known != name);
        self.files.push((name.to_owned(), file));
        Ok(())
    }

    /// BLAKE3 hashes of the files added so far, by name.
    pub fn hashes(&self) -> &BTreeMap<String, String> {
        &self.hashes
    }

    /// Adds a value as indented JSON.
    ///
    /// # Errors
    /// Kind `InputOutput`; a value that JSON cannot carry (NaN, ∞ become `null` in serde and are refused before).
    pub fn add_json(&mut self, name: &str, value: &impl serde::Serialize) -> Result<()> {
        self.add(name, json(value)?)
    }

    /// Makes all files last through a loss of power, moves them into the target folder and names them.
    ///
    /// # Errors
    /// Kind `InputOutput`.
    pub fn finish(self) -> Result<Vec<PathBuf>> {
        std::fs::create_dir_all(&self.target).map_err(|e| trouble("cannot make the folder", &self.target, e))?;
        let mut done = Vec::with_capacity(self.files.len());
        // All at the end: a disk that is told to keep one file keeps what was written before on the way.
        for (name, file) in &self.files {
            file.sync_all().map_err(|e| trouble("cannot write", &self.target.join(name), e))?;
        }
        for (name, _) in &self.files {
            let to = self.target.join(name);
            std::fs::rename(self.staging.path().join(name), &to).map_err(|e| trouble("cannot write", &to, e))?;
            done.push(to);
        }
        Ok(done)
    }
}

/// Temporary files are for their owner alone; a result is for whom the process' mask lets.
fn open_to_all<'a, 'b, 'c>(builder: &'c mut tempfile::Builder<'a, 'b>) -> &'c mut tempfile::Builder<'a, 'b> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// Kind `InputOutput`.
pub fn write_file(path: &Path, content: &[u8]) -> Result<()> {
    use std::io::Write;
    let parent = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let write = || -> std::io::Result<()> {
        let mut file = open_to_all(tempfile::Builder::new().prefix(".bladewright-")).tempfile_in(parent)?;
        file.write_all(content)?;
        file.as_file().sync_all()?;
        file.persist(path).map_err(|e| e.error)?;
        Ok(())
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
