//! `make`: a blade from parameters.

use std::path::Path;

use super::args::Make;
use super::out::sayln;
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::make::{self, BladeDesign};
use crate::run::RunFolder;

/// Runs the verb; the exit code.
pub fn run(args: &Make, _quiet: bool) -> Result<u8> {
    let (name, design) = design(&args.design)?;
    let blade = make::build(&design)?;
    let mut folder = RunFolder::begin(&args.out)?;
    folder.add(&format!("{name}.step"), make::step_text(&blade)?)?;
    folder.add(&format!("{name}.obj"), make::obj_text(&blade))?;
    folder.add(&format!("{name}.toml"), design.to_toml()?)?;
    for file in folder.finish()? {
        sayln!("{}", file.display());
    }
    Ok(0)
}

/// A preset by its name, else a design file.
fn design(given: &str) -> Result<(String, BladeDesign)> {
    if let Some(design) = make::presets::by_name(given) {
        return Ok((given.to_owned(), design));
    }
    let path = Path::new(given);
    let text = files::read_text(path, files::SHORT).map_err(|e| {
        Error::io(Stage::Make, format!("{given} is neither a preset nor a design file that can be read: {e}"))
            .advise("presets: steam_root, compressor_twist, turbine_camber, prism")
            .caused_by(e)
    })?;
    let name = path.file_stem().map_or_else(|| "blade".into(), |s| s.to_string_lossy().into_owned());
    Ok((name, BladeDesign::from_toml(&text)?))
}
