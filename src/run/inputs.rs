//! The files that a job names, read: job, model, machine, tool, own post files, fixtures and stock.

use std::io::ErrorKind;
use std::path::Path;

use super::manifest::{self, Input};
use crate::artifact::{Blade, Obstacle};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::job::{self, Draft, Job, JobFile, ModelSettings, ToolKeys};
use crate::machine::Machine;
use crate::observe::Observer;
use crate::plan::Setup;
use crate::read::model::{self, ModelOptions};
use crate::read::tools;
use crate::tool::Tool;
use crate::write::post::Dialect;

/// Most bytes of a tool library: those of makers list some thousands of tools.
const LIBRARY: u64 = 64 << 20;

/// A job with its blade and machine in memory, and the files that these were read from.
pub struct Loaded {
    /// What stands still while the job is planned.
    pub setup: Setup,
    /// Input files with their hashes: the model first.
    pub inputs: Vec<Input>,
}

impl Loaded {
    /// Reads the job's files and completes it.
    ///
    /// # Errors
    /// Those of reading and of the job.
    pub fn read(draft: &Draft, observer: &dyn Observer) -> Result<Self> {
        let m = draft.model();
        // Read once: what is planned is what the manifest names.
        let bytes = model::file_bytes(&m.file)?;
        let mut inputs = vec![manifest::input_of(&m.file, &bytes)];
        // A header of a section table has its points in files of their own.
        for file in model::table::data_files(&m.file) {
            inputs.push(manifest::input(&file, Stage::Model, "files of the table")?);
        }
        let options = model_options(m);
        let blade = model::load_bytes(&m.file, &bytes, &options, observer)?;
        let machine = match draft.machine_file() {
            Some(file) => {
                inputs.push(manifest::input(file, Stage::Machine, "machine.file")?);
                machine(file)?
            }
            None => Machine::demo()?,
        };
        let mut post_files = Vec::new();
        for file in draft.post_files() {
            inputs.push(manifest::input(file, Stage::Post, "post.files")?);
            post_files.push(dialect(file)?);
        }
        let mut setup = Setup::of(draft, blade, machine, observer)?;
        if let Some(model) = inputs.first_mut() {
            model.path = setup.job.model.file.display().to_string();
            setup.part_hash = model.blake3.clone();
        }
        setup.obstacles.extend(obstacles(&setup.job, &setup.blade, &mut inputs, observer)?);
        setup.post_files = post_files;
        setup.check_program_names()?;
        Ok(Loaded { setup, inputs })
    }
}

/// How the job reads its model.
fn model_options(m: &ModelSettings) -> ModelOptions {
    ModelOptions {
        unit: m.unit,
        axis: m.axis.direction(),
        deflection_mm: m.deflection_mm,
        weld_mm: m.weld_mm,
        close_holes_mm: m.close_holes_mm,
        body: m.body,
        airfoil_mm: m.airfoil_mm,
        platform_mm: m.platform_mm,
        airfoil_faces: m.airfoil_faces.clone(),
        platform_faces: m.platform_faces.clone(),
    }
}

/// Fixtures and stock in the blade frame; their files are inputs.
fn obstacles(job: &Job, blade: &Blade, inputs: &mut Vec<Input>, observer: &dyn Observer) -> Result<Vec<Obstacle>> {
    let mut all = job.fixture.iter().map(|f| (false, f)).chain(job.stock.iter().map(|f| (true, f)));
    all.try_fold(Vec::new(), |mut out, (stock, f)| {
        inputs.push(manifest::input(&f.file, Stage::Model, if stock { "stock.file" } else { "fixture.file" })?);
        let room = [f.clearance_mm, f.holder_clearance_mm];
        out.push(model::obstacle(&f.file, f.unit, stock, room, &blade.model_from_blade, observer)?);
        Ok(out)
    })
}

/// Reads a job file.
///
/// # Errors
/// `InputOutput` when the file cannot be read; `Usage` with file, line and key when it is not a job
/// file.
pub fn job(path: &Path) -> Result<JobFile> {
    let short = "a job file is a short TOML text; name the CAD file in it as model.file";
    job::parse(&text_of(path, Stage::Job, "job file", short)?, &path.display().to_string())
}

/// A job file with the folder that its paths start from; of a model a job of defaults.
///
/// # Errors
/// Those of [`job()`].
pub fn typed(input: &Path) -> Result<(JobFile, &Path)> {
    let is_toml = input.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    if is_toml && !model::table::is_header_file(input) {
        return Ok((job(input)?, input.parent().unwrap_or(Path::new("."))));
    }
    Ok((JobFile::from_model(input), Path::new(".")))
}

/// Settles what does not depend on the blade, as [`job::resolve`] does, with the tool that the job
/// names in a library and with absolute paths.
///
/// # Errors
/// Those of [`job::resolve`]; `InputOutput` where the library cannot be read; `Usage` where the
/// tool is not in it.
pub fn draft(mut typed: JobFile, base_dir: &Path) -> Result<Draft> {
    if let Some(keys) = &mut typed.tool {
        from_library(keys, base_dir, "tool")?;
    }
    if let Some(keys) = &mut typed.tool_2 {
        from_library(keys, base_dir, "tool_2")?;
    }
    job::resolve(absolute(typed, base_dir), base_dir)
}

/// Paths of a job from `base`, and that from the working folder where it is relative.
pub(crate) fn absolute(mut job: JobFile, base: &Path) -> JobFile {
    // A path that is left empty is missing, and is told as such.
    for file in job.files_mut().filter(|f| !f.is_empty()) {
        let joined = base.join(&*file);
        *file = std::path::absolute(&joined).unwrap_or(joined).to_string_lossy().into_owned();
    }
    job
}

/// Puts the tool of a library where keys of a section are left out.
fn from_library(keys: &mut ToolKeys, base_dir: &Path, section: &str) -> Result<()> {
    let (entry, unit) = (keys.entry.take().map(|e| e.to_string()), keys.unit.take());
    let Some(file) = keys.library.take() else {
        let left = [(entry.is_some(), "entry"), (unit.is_some(), "unit")];
        return match left.iter().find(|(given, _)| *given) {
            None => Ok(()),
            Some((_, key)) => Err(Error::usage(Stage::Job, format!("{section}.{key} is given, but no library"))
                .advise(format!("name the tool library with {section}.library"))),
        };
    };
    let path = base_dir.join(&file);
    let bytes = files::read(&path, LIBRARY).map_err(|e| {
        Error::io(Stage::Job, format!("cannot read the tool library {}: {e}", path.display())).caused_by(e)
    })?;
    let text = String::from_utf8(bytes).map_err(|_| {
        Error::usage(Stage::Job, format!("the tool library {} is not a text in UTF-8", path.display()))
            .advise("export it as JSON; a file .tools of Fusion is an archive with tools.json in it")
    })?;
    let found = tools::tool(&text, entry.as_deref(), unit, &path.display().to_string())?;
    keys.radius_mm.get_or_insert(found.radius_mm);
    if let Some(body) = found.body {
        keys.taper_deg.get_or_insert(body.taper_deg);
        keys.shank_radius_mm.get_or_insert(body.shank_radius_mm);
        keys.stickout_mm.get_or_insert(body.stickout_mm);
        keys.holder.get_or_insert(body.stages);
    }
    Ok(())
}

/// The text of a file that is written by hand; `what` it is, and what is said where it is
/// `too_large` to be that.
///
/// # Errors
/// `InputOutput` where it cannot be read; `Usage` where it is too large, or no text.
pub(crate) fn text_of(path: &Path, stage: Stage, what: &str, too_large: &str) -> Result<String> {
    let shown = path.display();
    let bytes = files::read(path, files::SHORT).map_err(|e| match e.kind() {
        ErrorKind::FileTooLarge => Error::usage(stage, format!("{shown} is too large for a {what}")).advise(too_large),
        _ => Error::io(stage, format!("the {what} {shown} cannot be read: {e}")).caused_by(e),
    })?;
    String::from_utf8(bytes).map_err(|e| Error::usage(stage, format!("{shown} is not a text in UTF-8: {e}")))
}

/// Reads a machine file.
///
/// # Errors
/// Kind `InputOutput` where the file cannot be read, else as [`Machine::from_toml`].
pub fn machine(path: &Path) -> Result<Machine> {
    Machine::from_toml(&named(path, Stage::Machine, "machine file")?, &path.display().to_string())
}

/// Reads a tool file: TOML with the keys of [`Tool`], or with a table `[tool]` of them, so that a
/// resolved job will do.
///
/// # Errors
/// Kind `InputOutput` where the file cannot be read, else as [`Tool::from_toml`].
pub fn tool(path: &Path) -> Result<Tool> {
    Tool::from_toml(&named(path, Stage::Job, "tool file")?, &path.display().to_string())
}

/// Reads a post file.
///
/// # Errors
/// Kind `InputOutput` where the file cannot be read, else as [`Dialect::from_toml`].
pub fn dialect(path: &Path) -> Result<Dialect> {
    Dialect::from_toml(&named(path, Stage::Post, "post file")?, &path.display().to_string())
}

fn named(path: &Path, stage: Stage, what: &str) -> Result<String> {
    files::read_text(path, files::SHORT)
        .map_err(|e| Error::io(stage, format!("cannot read the {what} {}: {e}", path.display())).caused_by(e))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn keys_go_before_what_a_library_says() {
        let dir = tempfile::tempdir().unwrap();
        std::fs::copy("models/tools/library.json", dir.path().join("t.json")).unwrap();
        std::fs::write(dir.path().join("t.tbl"), "T3 D4").unwrap();
        std::fs::write(dir.path().join("t.tools"), [0x50, 0x4b, 0x03, 0xff]).unwrap();
        let filled = |text: &str| {
            let mut keys = toml::from_str::<ToolKeys>(text).unwrap();
            from_library(&mut keys, dir.path(), "tool").map(|()| keys)
        };
        let keys = filled("library = \"t.json\"\nentry = 12\nstickout_mm = 35").unwrap();
        let of = (keys.radius_mm, keys.taper_deg, keys.shank_radius_mm, keys.stickout_mm);
        assert_eq!(of, (Some(1.5), Some(4.0), Some(3.0), Some(35.0)));
        assert!(keys.library.is_none() && keys.entry.is_none() && keys.holder.unwrap().len() > 1);
        let keys = filled("library = \"t.tbl\"\nunit = \"inch\"").unwrap();
        assert_eq!((keys.radius_mm, keys.holder), (Some(50.8), None));
        for (text, says) in [
            ("entry = \"12\"", "tool.entry is given, but no library"),
            ("library = \"none.json\"", "cannot read the tool library"),
            ("library = \"t.tools\"", "not a text in UTF-8"),
            ("library = \"t.json\"", "several ball-end cutters"),
        ] {
            assert!(filled(text).unwrap_err().message.contains(says), "{text}");
        }
    }

    #[test]
    fn a_file_that_is_not_there_is_named() {
        let file = Path::new("/nonexistent.toml");
        let said = [job(file).err(), machine(file).err(), tool(file).err(), dialect(file).err()];
        for (e, what) in
            said.into_iter().map(Option::unwrap).zip(["job file", "machine file", "tool file", "post file"])
        {
            assert_eq!(e.kind, crate::ErrorKind::InputOutput);
            assert!(e.message.contains(what) && e.message.contains("/nonexistent.toml"), "{}", e.message);
        }
    }
}
