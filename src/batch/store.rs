//! Where results are kept: a folder, or an object store that speaks S3 (feature `s3`).
//!
//! ```text
//! OUT/members/NAME/…        a run's files and member.json, which is written last and says that the others are whole
//! OUT/work/NAME/…           a member in the making; gone when nothing is being computed
//! OUT/log/…                 times, memory, locks: the only place where clocks and machines leave traces
//! OUT/family.{csv,parquet,html}
//! ```
//! A member appears in one step: its folder is filled under `work`, synced to the disk and renamed.
//! A process killed in between leaves a folder under `work`. The next run takes it away, or takes
//! it in where it is whole.

use std::fs::{File, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::record::Record;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::run::sync;

/// The last file of a member.
pub(super) const RECORD: &str = "member.json";

/// A place for results. Paths are relative to it, parted by `/`.
pub(super) trait Store: Sync {
    /// A file's bytes; `None`: there is none.
    fn read(&self, path: &str) -> Result<Option<Vec<u8>>>;
    /// Writes one file whole or not at all.
    fn write(&self, path: &str, content: &[u8]) -> Result<()>;
    /// An empty folder on this machine in which a member may be made.
    fn workshop(&self, name: &str) -> Result<PathBuf>;
    /// Takes the finished folder of a member in, in place of what was there. `old`: the record of
    /// that.
    fn take_in(&self, record: &Record, old: Option<&Record>) -> Result<()>;
    /// Takes the member's workshop away.
    fn sweep(&self, name: &str) -> Result<()>;
    /// A folder in the workshop that is whole but was not taken in.
    fn left_over(&self, _name: &str) -> Option<Record> {
        None
    }
    /// The files that a record names are there as they were written, as far as that can be seen
    /// without loading them from afar.
    fn whole(&self, _record: &Record) -> bool {
        true
    }
}

/// Trouble with the place of results; no member's fault.
pub(super) fn trouble(what: &str, path: &Path, e: std::io::Error) -> Error {
    Error::io(Stage::Output, format!("{what} {}: {e}", path.display()))
        .advise("check that the folder is writable and the disk has room; what is done is kept, run it again to go on")
        .caused_by(e)
}

/// A killed process lets go of its lock when the system has taken it apart, which its successor may
/// be too early for.
const LET_GO: Duration = Duration::from_secs(2);

/// Results in a folder.
pub(super) struct Folder {
    root: PathBuf,
    // Held as long as this lives; the system lets go of it when the process ends, however it ends.
    _lock: File,
}

impl Folder {
    /// Opens or makes the folder; `part` names the shard, one process at a time may work on each.
    pub(super) fn open(root: &Path, part: &str) -> Result<Self> {
        let log = root.join("log");
        std::fs::create_dir_all(&log).map_err(|e| trouble("cannot make the folder", &log, e))?;
        let path = log.join(format!("{part}.lock"));
        let lock = File::options().create(true).truncate(false).write(true).open(&path);
        let lock = lock.map_err(|e| trouble("cannot write", &path, e))?;
        let last_try = Instant::now() + LET_GO;
        loop {
            match lock.try_lock() {
                Ok(()) => break,
                Err(TryLockError::WouldBlock) if Instant::now() < last_try => std::thread::sleep(LET_GO / 40),
                // Not the user's command that is wrong but the moment: a Job whose pods count bad
                // usage as an outcome must try this again.
                Err(TryLockError::WouldBlock) => {
                    return Err(Error::io(
                        Stage::Batch,
                        format!("another process works on {} ({part})", root.display()),
                    )
                    .advise("wait for it, or give each process a shard of its own"));
                }
                // A file system without locks: two processes on one shard are then the user's to
                // avoid.
                Err(TryLockError::Error(_)) => break,
            }
        }
        Ok(Folder { root: root.to_path_buf(), _lock: lock })
    }

    fn work(&self, name: &str) -> PathBuf {
        self.root.join("work").join(name)
    }

    fn has_all(&self, folder: &Path, record: &Record) -> bool {
        let is_whole = |(name, hash): (&String, &String)| {
            let path = folder.join(name);
            let found = files::hash(&path, files::LONG);
            found.is_ok_and(|(_, found)| found == *hash)
                || files::read(&path, files::LONG).is_ok_and(|content| record.as_written(name, content).is_some())
        };
        record.files.iter().all(is_whole)
    }
}

fn remove(folder: &Path) -> Result<()> {
    match std::fs::remove_dir_all(folder) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(trouble("cannot remove", folder, e)),
        _ => Ok(()),
    }
}

impl Store for Folder {
    fn read(&self, path: &str) -> Result<Option<Vec<u8>>> {
        let path = self.root.join(path);
        match files::read(&path, files::LONG) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(trouble("cannot read", &path, e)),
        }
    }

    fn write(&self, path: &str, content: &[u8]) -> Result<()> {
        let path = self.root.join(path);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent).map_err(|e| trouble("cannot make the folder", parent, e))?;
        }
        // A kill in between leaves traces in the log alone.
        let aside =
            self.root.join("log").join(format!("{}.part", path.file_name().unwrap_or_default().to_string_lossy()));
        let write = || -> std::io::Result<()> {
            let mut file = File::create(&aside)?;
            file.write_all(content)?;
            file.sync_all()?;
            std::fs::rename(&aside, &path)
        };
        write().map_err(|e| {
            let _ = std::fs::remove_file(&aside);
            trouble("cannot write", &path, e)
        })
    }

    fn whole(&self, record: &Record) -> bool {
        self.has_all(&self.root.join("members").join(&record.name), record)
    }

    fn workshop(&self, name: &str) -> Result<PathBuf> {
        let folder = self.work(name);
        remove(&folder)?;
        std::fs::create_dir_all(&folder).map_err(|e| trouble("cannot make the folder", &folder, e))?;
        Ok(folder)
    }

    fn take_in(&self, record: &Record, _old: Option<&Record>) -> Result<()> {
        let (from, to) = (self.work(&record.name), self.root.join("members").join(&record.name));
        let aside = self.work(&format!("{}.old", record.name));
        let members = self.root.join("members");
        let moved = || -> std::io::Result<()> {
            std::fs::create_dir_all(&members)?;
            sync(&from)?;
            if to.exists() {
                let _ = std::fs::remove_dir_all(&aside);
                std::fs::rename(&to, &aside)?;
            }
            std::fs::rename(&from, &to)?;
            sync(&members)
        };
        moved().map_err(|e| trouble("cannot write", &to, e))?;
        remove(&aside)
    }

    fn sweep(&self, name: &str) -> Result<()> {
        remove(&self.work(name))?;
        remove(&self.work(&format!("{name}.old")))?;
        // Gone with its last member; another shard may still have one in it.
        let _ = std::fs::remove_dir(self.root.join("work"));
        Ok(())
    }

    fn left_over(&self, name: &str) -> Option<Record> {
        let record: Record =
            serde_json::from_slice(&files::read(&self.work(name).join(RECORD), files::LONG).ok()?).ok()?;
        self.has_all(&self.work(name), &record).then_some(record)
    }
}
