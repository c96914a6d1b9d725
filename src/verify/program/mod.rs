//! Programs read back: from the text to what the machine does, and that against the plan.
//!
//! **In**: a [`Program`], the [`Plan`] it was posted from, [`Tool`], [`Machine`]. **Out**: [`Check`]s. The readers ([`gcode`],
//! [`heidenhain`], [`apt`]) share nothing with the writers of [`crate::post`]: each turns text into [`Block`]s and keeps
//! the control's modal state; [`follow`] moves the machine through them.
//!
//! | check | measured |
//! | --- | --- |
//! | `program-centre` | distance of the ball centre at the end of each cutting line from the plan's path |
//! | `program-direction` | angle between the tool axis there and the plan's, which is even in θ between locations |
//! | `program-chord` | distance of the ball centre from the plan's path *within* each cutting line, the control moving every word evenly |
//! | `program-missing` | distance of each cutter location from the program's path: a line that is missing shows |
//! | `program-time` | whole time of the cutting lines against the plan's |
//!
//! **Limits**: axes move evenly from line to line (no smoothing of the control's own), programmed vectors as the rotary axes that reach
//! them. Rapids and approach are read, not judged.

mod apt;
mod block;
mod compare;
mod follow;
mod gcode;
mod guess;
mod heidenhain;
#[cfg(test)]
mod tests;

pub use block::{Block, Feed, Place, Way};
pub use follow::{Bench, Moved, Zero, follow};
pub use guess::{Guess, guess};

use crate::artifact::program::{Grammar, Language, Program};
use crate::artifact::report::Check;
use crate::artifact::{Blade, Plan};
use crate::error::{Error, Result, Stage};
use crate::machine::Machine;
use crate::tool::Tool;

/// Reads a program's text into its moves.
///
/// # Errors
/// Kind `Usage`: a line that is not understood, with its number.
pub fn read(text: &str, language: Language) -> Result<Vec<Block>> {
    match language.grammar {
        Grammar::Gcode => gcode::read(text),
        Grammar::Heidenhain => heidenhain::read(text),
        Grammar::Apt => apt::read(text),
    }
}

/// Reads a program back and compares it with the plan that it was made from.
///
/// # Errors
/// As [`read`], and where a line cannot be reached by the machine.
pub fn read_back(program: &Program, plan: &Plan, blade: &Blade, tool: &Tool, machine: &Machine) -> Result<Vec<Check>> {
    let blocks = read(&program.text, program.language)?;
    let bench = Bench { language: program.language, zero: Zero::default(), tool, machine };
    let moves = follow(&blocks, &bench)?;
    Ok(compare::checks(program, &moves, plan, blade, tool, machine))
}

/// A line that cannot be read.
fn unreadable(line: usize, what: &str) -> Error {
    Error::usage(Stage::Verify, format!("line {line} of the program: {what}"))
}
