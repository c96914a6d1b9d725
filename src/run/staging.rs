//! Files that come into a folder together or not at all.
//!
//! ```text
//! FOLDER/.bladewright-XXXXXX/lock      held as long as its process lives
//!                            new/      files in the making
//!                            old/      files that they take the place of, from the journal's beginning to its end
//!                            journal   names of the new files; there only while files are moved
//! ```
//! The old files are moved out first, then the new ones in. Taking away the journal is the step
//! that makes the change last. So a folder never holds files of two runs side by side. Whatever
//! goes wrong on the way is undone. A killed process leaves the journal, and the next process that
//! looks at the folder undoes the change ([`settle`]).

use std::collections::BTreeSet;
use std::fs::{File, TryLockError};
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, Instant};

use crate::files;

const PREFIX: &str = ".bladewright-";
const LOCK: &str = "lock";
const NEW: &str = "new";
const OLD: &str = "old";
const JOURNAL: &str = "journal";

/// Moving files takes no longer than this; a lock on the folder that is held longer is not one of
/// ours.
const PATIENCE: Duration = Duration::from_secs(2);

/// A folder in which files are made; it goes away with this.
pub(super) struct Staging {
    // Before the folder: closed before that is taken away.
    _lock: File,
    folder: tempfile::TempDir,
}

impl Staging {
    /// Begins one in a folder, and takes away what killed processes left there.
    pub fn within(home: &Path) -> io::Result<Self> {
        let _held = hold(home);
        sweep(home)?;
        let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(home)?;
        let lock = File::create(folder.path().join(LOCK))?;
        // A file system without locks: what is left there after a kill stays.
        let _ = lock.try_lock();
        std::fs::create_dir(folder.path().join(NEW))?;
        Ok(Staging { _lock: lock, folder })
    }

    /// Where a new file is made.
    pub fn file(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    /// The folder of new files. It has the rights that the process' mask lets, the one around it is
    /// its owner's alone.
    pub fn folder(&self) -> PathBuf {
        self.folder.path().join(NEW)
    }

    /// Takes over the new files of another one.
    pub fn take(&self, other: &Staging) -> io::Result<()> {
        std::fs::remove_dir(self.folder())?;
        std::fs::rename(other.folder(), self.folder())
    }

    /// Moves the new files into the folder around this one, and those that are `gone` or replaced
    /// away. The caller holds that folder.
    pub fn swap(self, target: &Path, new: &[String], gone: &BTreeSet<String>) -> io::Result<()> {
        let staging = self.folder.path();
        let moves = moves(staging, target, new, gone)?;
        std::fs::create_dir(staging.join(OLD))?;
        write_journal(staging, new)?;
        let moved = moves.iter().try_for_each(FileMove::make).and_then(|()| {
            sync(target)?;
            std::fs::remove_file(staging.join(JOURNAL))
        });
        let Err(e) = moved else { return Ok(()) };
        match undo(staging, target) {
            Ok(()) => Err(e),
            Err(second) => {
                let left = self.folder.keep();
                let told =
                    format!("{e}; and what was there before could not be put back from {}: {second}", left.display());
                Err(io::Error::new(e.kind(), told))
            }
        }
    }
}

fn write_journal(staging: &Path, new: &[String]) -> io::Result<()> {
    let part = staging.join("journal.part");
    let mut file = File::create(&part)?;
    file.write_all(&serde_json::to_vec(new)?)?;
    file.sync_all()?;
    sync(&staging.join(NEW))?;
    std::fs::rename(&part, staging.join(JOURNAL))?;
    sync(staging)
}

/// One file on its way.
struct FileMove {
    from: PathBuf,
    to: PathBuf,
}

impl FileMove {
    fn make(&self) -> io::Result<()> {
        let name = self.from.file_name().unwrap_or_default().display();
        std::fs::rename(&self.from, &self.to).map_err(|e| io::Error::new(e.kind(), format!("{name}: {e}")))
    }
}

/// What is to be moved: first the old files out, then the new ones in.
fn moves(staging: &Path, target: &Path, new: &[String], gone: &BTreeSet<String>) -> io::Result<Vec<FileMove>> {
    let mut all = Vec::new();
    for name in gone.iter().chain(new).collect::<BTreeSet<_>>() {
        let from = target.join(name);
        match from.symlink_metadata() {
            Ok(meta) if meta.is_dir() => {
                return Err(io::Error::new(io::ErrorKind::IsADirectory, format!("{name} is a folder")));
            }
            Ok(_) => all.push(FileMove { from, to: staging.join(OLD).join(name) }),
            Err(e) if e.kind() == io::ErrorKind::NotFound => {}
            Err(e) => return Err(e),
        }
    }
    all.extend(new.iter().map(|n| FileMove { from: staging.join(NEW).join(n), to: target.join(n) }));
    Ok(all)
}

/// Puts everything back where it was before the journal was written. May be broken off and begun
/// again at any place: no old file comes back before all new ones are out.
fn undo(staging: &Path, target: &Path) -> io::Result<()> {
    let journal = staging.join(JOURNAL);
    let names: Vec<String> = match files::read(&journal, files::SHORT) {
        Ok(bytes) => serde_json::from_slice(&bytes)?,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(e) => return Err(e),
    };
    let there = |path: &Path| path.symlink_metadata().is_ok();
    for name in names.iter().filter(|n| is_plain(n)) {
        let (from, to) = (target.join(name), staging.join(NEW).join(name));
        if !there(&to) && there(&from) {
            std::fs::rename(from, to)?;
        }
    }
    for entry in std::fs::read_dir(staging.join(OLD))? {
        let entry = entry?;
        std::fs::rename(entry.path(), target.join(entry.file_name()))?;
    }
    sync(target)?;
    std::fs::remove_file(journal)
}

/// The name of a file in a folder, not a way to another folder.
pub(super) fn is_plain(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None))
}

/// Undoes what a killed process left half-done in a folder, and takes away what it left beside.
///
/// # Errors
/// Those of the system where files cannot be put back.
pub(super) fn settle(folder: &Path) -> io::Result<()> {
    if left_in(folder).is_empty() {
        return Ok(());
    }
    let _held = hold(folder);
    sweep(folder)
}

/// Folders in the making, or left over.
fn left_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let ours = entries.filter(|e| e.file_name().to_string_lossy().starts_with(PREFIX));
    ours.filter(|e| e.file_type().is_ok_and(|t| t.is_dir())).map(|e| e.path()).collect()
}

fn sweep(folder: &Path) -> io::Result<()> {
    for left in left_in(folder) {
        let Ok(lock) = File::open(left.join(LOCK)) else {
            // Killed before it had a lock: it is empty. What is not empty is not one of ours.
            let _ = std::fs::remove_dir(&left);
            continue;
        };
        if lock.try_lock().is_ok() {
            undo(&left, folder)?;
            // What cannot be taken away harms nobody.
            let _ = std::fs::remove_dir_all(&left);
        }
    }
    Ok(())
}

/// One process at a time moves files in a folder. Where the system has no such locks, or somebody
/// else holds one, it goes on without.
pub(super) fn hold(folder: &Path) -> Option<File> {
    let file = File::open(folder).ok()?;
    let last_try = Instant::now() + PATIENCE;
    loop {
        match file.try_lock() {
            Ok(()) => return Some(file),
            Err(TryLockError::WouldBlock) if Instant::now() < last_try => std::thread::sleep(PATIENCE / 100),
            Err(_) => return None,
        }
    }
}

/// Makes what was done in a folder last through a loss of power.
pub fn sync(folder: &Path) -> io::Result<()> {
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::collections::BTreeMap;
    use std::fs;

    use super::*;

    /// Names and texts of all files of a folder; those that begin with a dot too.
    fn files(folder: &Path) -> BTreeMap<String, String> {
        let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap());
        let text = |p: PathBuf| fs::read_to_string(p).unwrap_or_else(|_| "folder".into());
        entries.map(|e| (e.file_name().to_string_lossy().into_owned(), text(e.path()))).collect()
    }

    fn put(folder: &Path, all: &[(&str, &str)]) -> BTreeMap<String, String> {
        all.iter().for_each(|(name, text)| fs::write(folder.join(name), text).unwrap());
        all.iter().map(|(n, t)| ((*n).to_owned(), (*t).to_owned())).collect()
    }

    const OLD_FILES: [(&str, &str); 4] = [("a", "old a"), ("b", "old b"), ("gone", "old"), ("notes", "the user's")];

    fn staged(home: &Path) -> (Staging, Vec<String>, BTreeSet<String>) {
        let staging = Staging::within(home).unwrap();
        put(&staging.folder(), &[("a", "new a"), ("b", "new b"), ("c", "new c")]);
        (staging, ["a", "b", "c"].map(String::from).to_vec(), BTreeSet::from(["gone".to_owned()]))
    }

    #[test]
    fn files_come_in_and_old_ones_go() {
        let dir = tempfile::tempdir().unwrap();
        put(dir.path(), &OLD_FILES);
        let (staging, new, gone) = staged(dir.path());
        staging.swap(dir.path(), &new, &gone).unwrap();
        let wanted = [("a", "new a"), ("b", "new b"), ("c", "new c"), ("notes", "the user's")];
        assert_eq!(files(dir.path()), wanted.iter().map(|(n, t)| ((*n).to_owned(), (*t).to_owned())).collect());
    }

    /// A process that is killed after any number of moves leaves the old files, once the folder is
    /// looked at again; also if that is killed too.
    #[test]
    fn a_kill_at_any_move_is_undone() {
        for undone_first in [false, true] {
            for made in 0..=6 {
                let dir = tempfile::tempdir().unwrap();
                let d = dir.path();
                let before = put(d, &OLD_FILES);
                let (staging, new, gone) = staged(d);
                fs::create_dir(staging.folder.path().join(OLD)).unwrap();
                write_journal(staging.folder.path(), &new).unwrap();
                let moves = moves(staging.folder.path(), d, &new, &gone).unwrap();
                assert_eq!(moves.len(), 6);
                moves[..made].iter().for_each(|m| m.make().unwrap());
                // A living process' files are not touched.
                settle(d).unwrap();
                assert_eq!(left_in(d).len(), 1);
                // Killed: the lock goes, the folder stays.
                let Staging { _lock, folder } = staging;
                let folder = folder.keep();
                drop(_lock);
                if undone_first && made > 3 {
                    // The first step of putting back was made, then that process was killed as
                    // well.
                    fs::rename(d.join("a"), folder.join(NEW).join("a")).unwrap();
                }
                settle(d).unwrap();
                assert_eq!(files(d), before, "{made} moves");
            }
        }
    }

    #[test]
    fn trouble_on_the_way_leaves_the_old_files() {
        let dir = tempfile::tempdir().unwrap();
        let d = dir.path();
        let before = put(d, &OLD_FILES);
        // The last new file is not there, so its move fails when all others are done.
        let (staging, new, gone) = staged(d);
        fs::remove_file(staging.file("c")).unwrap();
        let e = staging.swap(d, &new, &gone).unwrap_err();
        assert!(e.to_string().starts_with("c: "), "{e}");
        assert_eq!(files(d), before);
        // A folder is in the way.
        let (staging, new, gone) = staged(d);
        fs::create_dir(d.join("c")).unwrap();
        let e = staging.swap(d, &new, &gone).unwrap_err();
        assert!(e.to_string().contains("c is a folder"), "{e}");
        fs::remove_dir(d.join("c")).unwrap();
        assert_eq!(files(d), before);
    }

    #[test]
    fn what_is_left_behind_goes_and_what_is_not_ours_stays() {
        let dir = tempfile::tempdir().unwrap();
        let d = dir.path();
        let dead = staged(d).0;
        let Staging { _lock, folder } = dead;
        let dead = folder.keep();
        drop(_lock);
        fs::create_dir(d.join(".bladewright-empty")).unwrap();
        fs::create_dir(d.join(".bladewright-notes")).unwrap();
        put(&d.join(".bladewright-notes"), &[("mine", "x")]);
        let living = Staging::within(d).unwrap();
        assert!(!dead.exists() && !d.join(".bladewright-empty").exists());
        assert!(living.folder().is_dir() && d.join(".bladewright-notes/mine").is_file());
    }

    #[test]
    fn a_journal_that_leads_elsewhere_moves_nothing_there() {
        let dir = tempfile::tempdir().unwrap();
        let d = dir.path().join("run");
        fs::create_dir_all(d.join(".bladewright-bad/new")).unwrap();
        fs::create_dir(d.join(".bladewright-bad/old")).unwrap();
        put(dir.path(), &[("secret", "x")]);
        put(&d.join(".bladewright-bad"), &[("lock", ""), ("journal", "[\"../secret\"]")]);
        settle(&d).unwrap();
        assert!(dir.path().join("secret").is_file() && files(&d).is_empty());
    }
}
