//! Programs that others wrote: their bytes, how they are read, where they lie.

use std::path::Path;

use super::args::Manner;
use crate::artifact::Blade;
use crate::artifact::program::{Language, Programmed};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::geometry::Rigid;
use crate::read::model::format::without_mark;
use crate::read::program::{self, Zero};
use crate::run::inputs;
use crate::tool::Tool;
use crate::write::post::Dialect;

/// Largest program, bytes: what is larger is none.
const MAX_BYTES: u64 = 1 << 30;

/// The program's bytes.
///
/// # Errors
/// Kind `Io`, and kind `Usage` where it is no text of single bytes.
pub fn bytes(path: &Path) -> Result<Vec<u8>> {
    let io = |e: std::io::Error| {
        Error::io(Stage::Verify, format!("cannot read the program {}: {e}", path.display())).caused_by(e)
    };
    let bytes = files::read(path, MAX_BYTES).map_err(io)?;
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || bytes.iter().take(64).any(|b| *b == 0) {
        let what = format!("{} is not a text of single bytes (UTF-16?)", path.display());
        return Err(Error::usage(Stage::Verify, what).advise("save it as ASCII or UTF-8"));
    }
    Ok(bytes)
}

/// The program's text, to be read.
///
/// # Errors
/// As [`bytes`].
pub fn text(path: &Path) -> Result<String> {
    // Comments may be in any code page; the blocks themselves are ASCII.
    let text = String::from_utf8_lossy(without_mark(&bytes(path)?)).into_owned();
    // Lines may end in CR alone.
    Ok(if text.contains('\r') { text.replace("\r\n", "\n").replace('\r', "\n") } else { text })
}

/// How the program is to be read, and why.
///
/// # Errors
/// Kind `Usage` where it looks like no program, and those of a post file.
pub fn language(path: &Path, manner: &Manner, text: &str) -> Result<(Language, String)> {
    let (mut language, why) = match (&manner.post_file, manner.control) {
        (Some(file), _) => (inputs::dialect(file)?.language(), format!("as {} says", file.display())),
        (None, Some(control)) => {
            let dialect = Dialect::built_in(control)?;
            (dialect.language(), format!("as told: {}", dialect.name()))
        }
        (None, None) => {
            let guess = program::guess(text).ok_or_else(|| {
                Error::usage(Stage::Verify, format!("{} does not look like an NC program", path.display()))
                    .advise("--control says which dialect it is")
            })?;
            (guess.language, guess.why.to_owned())
        }
    };
    language.programmed = manner.programmed.unwrap_or(language.programmed);
    Ok((language, why))
}

/// How the program is to be read with these tools: X Y Z of a cutter with a corner are its tip,
/// where neither a post file nor the user says otherwise; of that end dialects say nothing.
pub fn with_tools(language: Language, why: String, manner: &Manner, tools: &[Tool]) -> (Language, String) {
    let told = manner.programmed.is_some() || manner.post_file.is_some();
    if told || language.programmed != Programmed::Centre || tools.iter().all(Tool::is_ball) {
        return (language, why);
    }
    let why = format!("{why}; X Y Z are taken as the tip of the cutter, --programmed says otherwise");
    (Language { programmed: Programmed::Tip, ..language }, why)
}

/// Where the program lies.
pub fn zero(manner: &Manner, blade: &Blade) -> Zero {
    let origin = manner.origin.map_or([0.0; 3], |o| o.0);
    let [x, y, z] = origin;
    let cad = if manner.cad { blade.model_from_blade.inverse() } else { Rigid::translation(x, y, z) };
    Zero { blade_from_program: cad, axes_mm: origin }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artifact::program::Grammar;

    #[test]
    fn a_cutter_with_a_corner_is_programmed_by_its_tip_unless_told() {
        let centre = Language {
            grammar: Grammar::Heidenhain,
            programmed: Programmed::Centre,
            shortest_way: true,
            feed_counts_degrees: false,
        };
        let ball = crate::sample::tool();
        let bull = Tool { corner_radius_mm: Some(1.0), ..ball.clone() };
        let told = Manner { programmed: Some(Programmed::Centre), ..Manner::default() };
        let read = |language: Language, manner: &Manner, tool: &Tool| {
            let (language, why) = with_tools(language, "so".into(), manner, std::slice::from_ref(tool));
            (language.programmed, why.contains("--programmed"))
        };
        assert_eq!(read(centre, &Manner::default(), &bull), (Programmed::Tip, true));
        assert_eq!(read(centre, &Manner::default(), &ball), (Programmed::Centre, false));
        assert_eq!(read(centre, &told, &bull), (Programmed::Centre, false));
        let axes = Language { programmed: Programmed::Machine, ..centre };
        assert_eq!(read(axes, &Manner::default(), &bull), (Programmed::Machine, false));
    }
}
