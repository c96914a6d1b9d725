//! The programs of a finished run, read back from its folder.

use super::RunFolder;
use crate::artifact::program::Control;
use crate::artifact::report::Check;
use crate::artifact::{CheckId, Plan, Program};
use crate::error::Result;
use crate::plan::{Setup, leads};
use crate::read::program::{Guess, guess};
use crate::verify::{self, Verified};
use crate::write::post::{self, Dialect};

/// Ends of names that programs have and nothing else in the folder of a run.
const PROGRAMS: [&str; 16] =
    ["apt", "arc", "cls", "cnc", "eia", "gcode", "h", "i", "iso", "mpf", "nc", "ngc", "pgm", "prg", "spf", "tap"];
/// Ends of names that programs do not have, though words in them may look like those of one.
const NO_PROGRAMS: [&str; 22] = [
    "csv", "glb", "gltf", "html", "iges", "igs", "jpg", "json", "log", "md", "obj", "parquet", "pdf", "ply", "png",
    "step", "stl", "stp", "svg", "toml", "txt", "zip",
];

/// What the programs of a finished run come to.
pub struct ProgramsAgain {
    /// What reading them back finds.
    pub checks: Vec<Check>,
    /// The first that the job asks for, where it is in the folder as the plan is written now.
    pub first: Option<Program>,
}

/// Reads the programs of a finished run back: those that its job asks for, and every
/// other file in its folder that is a program. One that the job asks for and that is not there is a
/// finding where the run was to write them: `wrote_programs`.
///
/// # Errors
/// Those of the dialects.
pub fn programs_again(
    setup: &Setup,
    verified: &Verified<Plan>,
    folder: &RunFolder,
    wrote_programs: bool,
) -> Result<ProgramsAgain> {
    let dialects: Vec<Dialect> = setup.dialects()?.into_iter().map(|(_, dialect)| dialect).collect();
    let (mut found, mut first) = (Vec::new(), None);
    for (k, dialect) in dialects.iter().enumerate() {
        let name = dialect.file_name();
        let Some(content) = folder.content(name) else {
            found.extend(wrote_programs.then(|| absent(name)));
            continue;
        };
        let written = posted(setup, dialect, verified)?;
        if k == 0 && written.text.as_bytes() == content {
            first = Some(written.clone());
        }
        found.extend(one(setup, name, &content, written, verified.value()));
    }
    for name in folder.names().iter().filter(|n| dialects.iter().all(|d| d.file_name() != n.as_str())) {
        let Some(content) = folder.content(name) else { continue };
        found.extend(other(setup, name, &content, &dialects, verified)?);
    }
    Ok(ProgramsAgain { checks: found, first })
}

/// What a dialect writes of a plan now.
fn posted(setup: &Setup, dialect: &Dialect, verified: &Verified<Plan>) -> Result<Program> {
    post::post(dialect, verified, setup.part_among(), &setup.job.tool, &setup.machine, &setup.post_options())
}

/// Checks a program of a plan. What is written now shows with which values the program was written.
fn one(setup: &Setup, name: &str, content: &[u8], written: Program, plan: &Plan) -> Vec<Check> {
    match text_of(content) {
        Some(text) => read_back(setup, Program { file_name: name.to_owned(), text, ..written }, plan),
        None => vec![unreadable(name, "it is not a text in UTF-8".into())],
    }
}

fn text_of(content: &[u8]) -> Option<String> {
    String::from_utf8(content.to_vec()).ok()
}

fn read_back(setup: &Setup, program: Program, plan: &Plan) -> Vec<Check> {
    let (part, tool, machine) = (setup.part_among(), &setup.job.tool, &setup.machine);
    match verify::read_back::read_back(&program, plan, part, tool, machine) {
        Ok(checks) => checks,
        Err(e) => vec![unreadable(&program.file_name, e.message)],
    }
}

/// A program that nobody knows the dialect of, read as it looks.
fn guessed(setup: &Setup, name: &str, text: String, look: Guess, plan: &Plan) -> Vec<Check> {
    let post = &setup.job.post;
    let with = std::iter::once((post.tool_number, post.spindle_rpm));
    let program = Program {
        control: look.why.to_owned(),
        file_name: name.to_owned(),
        language: look.language,
        ranges: Default::default(),
        cycles: Vec::new(),
        cut_lines: Vec::new(),
        asked: verify::read_back::asked(&text, look.language, with),
        text,
    };
    read_back(setup, program, plan)
}

/// A file beside the programs that the job asks for; empty: it is no program.
fn other(
    setup: &Setup,
    name: &str,
    content: &[u8],
    asked: &[Dialect],
    verified: &Verified<Plan>,
) -> Result<Vec<Check>> {
    let built_in = Control::ALL.into_iter().map(Dialect::built_in).collect::<Result<Vec<_>>>()?;
    let dialect = |name: &str| asked.iter().chain(&built_in).find(|d| d.file_name() == name);
    if let Some(dialect) = dialect(name) {
        return Ok(one(setup, name, content, posted(setup, dialect, verified)?, verified.value()));
    }
    if name.starts_with("from_operation_") {
        let why =
            "it goes on within a program of several runs, which this plan cannot judge: take it out of the folder";
        return Ok(vec![unreadable(name, why.into())]);
    }
    let rest = name.strip_prefix("from_turn_").and_then(|n| n.split_once('.'));
    let rest = rest.and_then(|(turn, rest)| Some((turn.parse::<usize>().ok()?, dialect(rest)?)));
    if let Some((turn, dialect)) = rest {
        return match leads::restart(setup, verified, turn) {
            Ok(left) => Ok(one(setup, name, content, posted(setup, dialect, &left)?, left.value())),
            Err(e) => Ok(vec![unreadable(name, e.message)]),
        };
    }
    let end = name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase()).unwrap_or_default();
    if NO_PROGRAMS.contains(&end.as_str()) {
        return Ok(Vec::new());
    }
    let text = text_of(content);
    Ok(match text.and_then(|text| guess(&text).map(|look| (text, look))) {
        Some((text, look)) => guessed(setup, name, text, look, verified.value()),
        None if PROGRAMS.contains(&end.as_str()) => {
            vec![unreadable(name, "nobody knows how it is to be read: take it out of the folder".into())]
        }
        None => Vec::new(),
    })
}

/// A program that a control would not understand either, or that nobody can judge.
fn unreadable(file_name: &str, why: String) -> Check {
    let quantity = format!("{file_name}: lines that cannot be read");
    Check::at_most(CheckId::ProgramReadable, &quantity, 1.0, 0.0, "lines", format!("{file_name}: {why}"))
}

fn absent(file_name: &str) -> Check {
    let note = format!("{file_name} is not in the folder, the job asks for it: write it with `post`, or plan again");
    Check::at_most(CheckId::ProgramAbsent, "programs that the job asks for and that are not there", 1.0, 0.0, "", note)
}
