//! A folder of results: one run, and what was made of it since.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::manifest::{self, Manifest};
use super::staging::{self, Staging, is_plain};
use super::{json, trouble};
use crate::error::{Error, Result, Stage};
use crate::files;

/// The job of a run, complete.
pub const JOB: &str = "job.resolved.toml";

/// Files that a run writes; programs have the names that their post files say.
const RUN: [&str; 14] = [
    JOB,
    manifest::FILE,
    "sections.json",
    "toolpath.json",
    "channel.json",
    "schedule.json",
    "cutter_locations.csv",
    "axes.csv",
    "plan.json",
    "summary.json",
    "verify.json",
    "preview.glb",
    "report.html",
    "advice.json",
];

/// Files of `compare`, `channel` and `pinch`, which look at a job without planning it to the end.
const STUDIES: [&str; 22] = [
    "compare.json",
    "compare.csv",
    "compare.svg",
    "channel_intervals.csv",
    "sweep_b.csv",
    "sweep_b.json",
    "sweep_b.svg",
    "sphere.csv",
    "sphere.svg",
    "pairs.csv",
    "cutter_locations_1.csv",
    "cutter_locations_2.csv",
    "pinch.json",
    "pinch_axes.csv",
    "pinch.svg",
    "pinch.ngc",
    "pinch.mpf",
    "pinch_ch1.mpf",
    "pinch_ch2.mpf",
    "pinch.iso.nc",
    "pinch.nc",
    "pinch.glb",
];

/// Our programs name us in one of their first lines.
const BY_US: &str = "by bladewright ";
/// Where that is looked for, bytes.
const HEAD: u64 = 4096;

/// A folder of results in the making.
pub struct RunFolder {
    target: PathBuf,
    /// Where the staging lies: the target, or the folder around it where there is no target yet.
    home: PathBuf,
    staging: Staging,
    /// Names of the programs of all controls, where all of an earlier run goes.
    replaces: Option<Vec<String>>,
    /// Names, and the files as long as they are not known to be on the disk.
    files: Vec<(String, Option<File>)>,
    hashes: BTreeMap<String, String>,
    programs: BTreeMap<String, String>,
    kept: BTreeSet<String>,
}

impl RunFolder {
    /// Begins files that come to those in the folder; fails at once where it could not be written
    /// in the end.
    ///
    /// # Errors
    /// Kind `InputOutput` where no folder can be made beside the target or the target is a file.
    pub fn begin(target: &Path) -> Result<Self> {
        if target.exists() && !target.is_dir() {
            return Err(Error::io(Stage::Output, format!("{} is a file, not a folder", target.display()))
                .advise("give a folder with -o"));
        }
        if target.is_symlink() && !target.exists() {
            return Err(Error::io(Stage::Output, format!("{} is a link that leads nowhere", target.display()))
                .advise("make the folder that it names, or give another one with -o"));
        }
        let parent = match target.parent() {
            Some(p) if !p.as_os_str().is_empty() => p.to_path_buf(),
            _ => PathBuf::from("."),
        };
        std::fs::create_dir_all(&parent).map_err(|e| trouble("cannot make the folder", &parent, e))?;
        // Inside an existing target, so that an unwritable target is found before hours of work,
        // and renames stay on one disk.
        let home = if target.is_dir() { target.to_path_buf() } else { parent };
        let staging = Staging::within(&home).map_err(|e| trouble("cannot write in", &home, e))?;
        Ok(RunFolder {
            target: target.to_path_buf(),
            home,
            staging,
            replaces: None,
            files: Vec::new(),
            hashes: BTreeMap::new(),
            programs: BTreeMap::new(),
            kept: BTreeSet::new(),
        })
    }

    /// Begins a run: everything of an earlier run goes when this one's files come. `programs`: the
    /// file names that all controls' programs have.
    ///
    /// # Errors
    /// As [`RunFolder::begin`].
    pub fn begin_run(target: &Path, programs: Vec<String>) -> Result<Self> {
        Ok(RunFolder { replaces: Some(programs), ..Self::begin(target)? })
    }

    /// Text of a file that an earlier run left in the folder.
    pub fn existing(&self, name: &str) -> Option<String> {
        files::read_text(&self.target.join(name), files::LONG).ok()
    }

    /// Content of a file that is in the folder; `None`: it is not there, or cannot be read.
    pub fn content(&self, name: &str) -> Option<Vec<u8>> {
        files::read(&self.target.join(name), files::LONG).ok()
    }

    /// Names of the files that are in the folder, in order; those in folders of it, and hidden
    /// ones, are left out.
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
        let to = self.target.join(name);
        if to.is_dir() {
            return Err(Error::io(
                Stage::Output,
                format!("{} is a folder, a file is to be written there", to.display()),
            )
            .advise("move it away, or give another folder with -o"));
        }
        let path = self.staging.file(name);
        let write = || -> std::io::Result<File> {
            let mut f = File::create(&path)?;
            f.write_all(content.as_ref())?;
            Ok(f)
        };
        let file = write().map_err(|e| trouble("cannot write", &to, e))?;
        self.hashes.insert(name.to_owned(), blake3::hash(content.as_ref()).to_hex().to_string());
        self.files.retain(|(known, _)| known != name);
        self.files.push((name.to_owned(), Some(file)));
        Ok(())
    }

    /// Adds a value as indented JSON.
    ///
    /// # Errors
    /// Kind `InputOutput`; a value that JSON cannot carry (NaN, ∞ become `null` in serde and are
    /// refused before).
    pub fn add_json(&mut self, name: &str, value: &impl serde::Serialize) -> Result<()> {
        self.add(name, json(value)?)
    }

    /// Adds the program of a control or of an own post file, by the name of that; one that
    /// something else wrote is not replaced.
    ///
    /// # Errors
    /// Kind `Usage` where another control or post file wrote a program of that name into the run;
    /// `InputOutput`.
    pub fn add_program(&mut self, name: &str, content: impl AsRef<[u8]>, post: &str) -> Result<()> {
        let before = if self.replaces.is_some() { None } else { self.manifest() };
        let before = before.and_then(|m| m.programs.get(name).cloned());
        if let Some(other) = before.as_ref().or(self.programs.get(name)).filter(|o| *o != post) {
            let place = self.target.display();
            return Err(Error::usage(
                Stage::Post,
                format!("{place} holds the {name} that {other} wrote, the one of {post} would take its place"),
            )
            .advise("give another folder with -o, or another `file` in the post file"));
        }
        self.programs.insert(name.to_owned(), post.to_owned());
        self.add(name, content)
    }

    /// Adds the job of a study: of `compare` or `channel`. It may stand beside a run of the same
    /// job only, and takes the place of studies of another.
    ///
    /// # Errors
    /// Kind `Usage` where the folder holds a run of another job; `InputOutput`.
    pub fn add_job_of_study(&mut self, job: &str) -> Result<()> {
        if self.existing(JOB).is_none_or(|there| there != job) {
            if self.manifest().is_some() {
                let place = self.target.display();
                return Err(Error::usage(Stage::Output, format!("{place} holds a run of another job"))
                    .advise("give another folder with -o"));
            }
            self.replaces = Some(Vec::new());
        }
        self.add(JOB, job)
    }

    /// Refuses a folder that holds a run: the study's file of this name would take the place of the
    /// run's.
    ///
    /// # Errors
    /// Kind `Usage` where the folder holds a run.
    pub fn refuse_beside_run(&self, name: &str) -> Result<()> {
        if self.manifest().is_none() {
            return Ok(());
        }
        let place = self.target.display();
        Err(Error::usage(Stage::Output, format!("{place} holds a run, whose {name} would be replaced"))
            .advise("give another folder with -o"))
    }

    /// Adds the job of a run. What was studied of the very same job stays.
    ///
    /// # Errors
    /// Kind `InputOutput`.
    pub fn add_job(&mut self, job: &str) -> Result<()> {
        if self.existing(JOB).is_some_and(|there| there == job) {
            STUDIES.iter().for_each(|name| self.keep(name));
        }
        self.add(JOB, job)
    }

    /// A file of an earlier run is of this one too.
    pub fn keep(&mut self, name: &str) {
        if let Ok(bytes) = files::read(&self.target.join(name), files::LONG) {
            self.kept.insert(name.to_owned());
            self.hashes.insert(name.to_owned(), blake3::hash(&bytes).to_hex().to_string());
        }
    }

    /// BLAKE3 hashes of the files added or kept so far, by name.
    pub fn hashes(&self) -> &BTreeMap<String, String> {
        &self.hashes
    }

    /// The programs added so far, and what wrote them.
    pub fn programs(&self) -> &BTreeMap<String, String> {
        &self.programs
    }

    /// Makes all files last through a loss of power, brings them into the target folder together,
    /// and names them.
    ///
    /// # Errors
    /// Kind `InputOutput`; the folder is then as it was.
    pub fn finish(mut self) -> Result<Vec<PathBuf>> {
        self.sync()?;
        let target = self.target.clone();
        let cannot = |e| trouble("cannot write in", &target, e);
        let written: Vec<PathBuf> = self.files.iter().map(|(name, _)| target.join(name)).collect();
        if !target.exists() {
            staging::sync(&self.staging.folder()).map_err(cannot)?;
            match std::fs::rename(self.staging.folder(), &target) {
                Ok(()) => return Ok(written),
                Err(e) if !target.is_dir() => return Err(trouble("cannot make the folder", &target, e)),
                Err(_) => {}
            }
        }
        if self.home != target {
            // The folder came into being meanwhile.
            let inside = Staging::within(&target).map_err(cannot)?;
            inside.take(&self.staging).map_err(cannot)?;
            self.staging = inside;
        }
        let _held = staging::hold(&target);
        if self.replaces.is_none() {
            self.enter()?;
        }
        let gone = self.gone();
        let names: Vec<String> = self.files.into_iter().map(|(name, _)| name).collect();
        self.staging.swap(&target, &names, &gone).map_err(cannot)?;
        Ok(written)
    }

    /// Closes the files too: Windows moves no folder in which one is open.
    fn sync(&mut self) -> Result<()> {
        for (name, file) in &mut self.files {
            let Some(file) = file.take() else { continue };
            file.sync_all().map_err(|e| trouble("cannot write", &self.target.join(name), e))?;
        }
        Ok(())
    }

    /// The manifest of the run in the folder, if it holds one.
    fn manifest(&self) -> Option<Manifest> {
        manifest::read(&self.existing(manifest::FILE)?)
    }

    /// Enters the files that come to a finished run in its manifest, where there is one.
    fn enter(&mut self) -> Result<()> {
        let Some(mut manifest) = self.manifest() else { return Ok(()) };
        let own = self.hashes.iter().filter(|(name, _)| *name != manifest::FILE);
        manifest.outputs.extend(own.map(|(name, hash)| (name.clone(), hash.clone())));
        manifest.programs.extend(self.programs.clone());
        self.add_json(manifest::FILE, &manifest)?;
        self.sync()
    }

    /// Files of an earlier run that have no place beside this one.
    fn gone(&self) -> BTreeSet<String> {
        let Some(programs) = &self.replaces else { return BTreeSet::new() };
        let before = self.manifest();
        let mut gone: BTreeSet<String> = BTreeSet::new();
        // Without a manifest or a job the folder holds no run, and its files are somebody's own.
        if before.is_some() || self.target.join(JOB).exists() {
            gone.extend(RUN.iter().chain(&STUDIES).map(|n| (*n).to_owned()));
        }
        gone.extend(before.into_iter().flat_map(|m| m.outputs.into_keys()));
        let listing = std::fs::read_dir(&self.target).into_iter().flatten().flatten();
        let names = listing.filter_map(|e| e.file_name().into_string().ok());
        let is_program = |n: &String| {
            let ends = |p: &String| n == p || (n.starts_with("from_") && n.ends_with(&format!(".{p}")));
            programs.iter().any(ends) && is_by_us(&self.target.join(n))
        };
        gone.extend(names.filter(is_program));
        gone.retain(|n| is_plain(n) && !self.kept.contains(n) && !self.target.join(n).is_dir());
        gone
    }
}

/// Whether a program is one of ours, by its header.
fn is_by_us(path: &Path) -> bool {
    use std::io::Read;
    let mut head = Vec::new();
    let open = || path.is_file().then(|| File::open(path).ok()).flatten();
    open().is_some_and(|f| f.take(HEAD).read_to_end(&mut head).is_ok())
        && String::from_utf8_lossy(&head).to_lowercase().contains(BY_US)
}

#[cfg(test)]
mod tests;
