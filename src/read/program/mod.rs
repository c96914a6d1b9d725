//! Programs read: from the text to blocks, and from blocks to what the machine does.
//!
//! **In**: the text of a program and its [`Language`]; for the machine's moves a [`Bench`].
//! **Out**:
//! a [`Script`] of [`Block`]s, and one [`Moved`] for each move. Each reader (`gcode`, `heidenhain`,
//! `apt`) keeps the control's modal state; [`follow`] moves the machine through the blocks;
//! [`guess`] finds the language of a text whose writer is not known; [`mod@line`] says where the
//! numbers of a line stand, for a line to be written anew; [`pinch`] reads programs of two tools.
//!
//! **Guarantees**: a word that is neither acted on nor known to be harmless is refused with its
//! line. The readers share nothing with the writers of programs.
//!
//! **Limits**: axes move evenly from line to line, on the polynomials of the line or on its arc (no
//! smoothing of the control's own), programmed vectors as the rotary axes that reach them, or on a
//! great circle where the program says so. Which forms of others are read: `docs/others.md`.
//! `G43.4` and `G43.5` fix X, Y, Z to the table as it stands where they come on, as their manuals
//! say; all other controls to the table as it stands at 0.
//!
//! **Fails** with kind `Usage` and the line.

mod apt;
mod arc;
mod block;
mod follow;
mod gcode;
mod guess;
mod heidenhain;
pub mod line;
mod moved;
pub mod pinch;
#[cfg(test)]
mod tests;
mod turn;
mod walk;

pub use block::{Arc, Bend, Block, Call, Centre, Destination, Feed, Interpolation, RotaryWay, Script};
pub use follow::{Bench, Zero, follow, follow_each};
pub use guess::{Guess, guess};
pub use moved::Moved;

use crate::artifact::program::{Grammar, Language};
use crate::error::{Error, Result, Stage};

/// Reads a program's text: its moves, and what it says beside them.
///
/// # Errors
/// Kind `Usage`: a line that is not understood, with its number.
pub fn read(text: &str, language: Language) -> Result<Script> {
    match language.grammar {
        Grammar::Gcode => gcode::read(text),
        Grammar::Heidenhain => heidenhain::read(text, language.programmed),
        Grammar::Apt => apt::read(text),
    }
}

/// Longest part of a line that is quoted.
const QUOTED: usize = 80;

/// A line that cannot be read, quoted.
fn unreadable(line: usize, text: &str, what: &str) -> Error {
    let text = text.trim();
    let mut quoted: String = text.chars().take(QUOTED).map(|c| if c.is_control() { '?' } else { c }).collect();
    if quoted.len() < text.len() && text.chars().nth(QUOTED).is_some() {
        quoted.push('…');
    }
    Error::usage(Stage::Verify, format!("line {line} of the program: {what}: `{quoted}`"))
}

/// A line that cannot be followed.
fn unreachable(line: usize, what: &str) -> Error {
    Error::usage(Stage::Verify, format!("line {line} of the program: {what}"))
}
