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
//! | `program-curve` | angle between the tool axis *within* each polynomial line and the schedule's curve θ(S); ball centres within it count under `program-centre` |
//! | `program-chord` | distance of the ball centre from the plan's path *within* each cutting line, the control moving every word evenly |
//! | `program-missing` | distance of each cutter location from the program's path: a line that is missing shows |
//! | `program-rapids` | least distance of the whole tool to the part in rapids, those between operations among them |
//! | `program-travel` | how far an axis leaves its travel in any move, rapids, approach and retract among them |
//! | `program-feed` | time of each cutting line against the plan's between the places where it begins and ends |
//! | `program-time` | whole time of the cutting lines against the plan's |
//! | `program-words` | words outside what the control reads by its post file: value, digits after the point |
//!
//! **Limits**: axes move evenly from line to line, or on the polynomials of the line (no smoothing of the control's own), programmed vectors as the rotary axes that reach
//! them. Approach and retract at a feed are read, not judged: the way that they take is judged with the plan (`lead-clearance`).

mod apt;
mod block;
mod compare;
mod follow;
mod gcode;
mod guess;
mod heidenhain;
#[cfg(test)]
mod tests;
mod words;

pub use block::{Bend, Block, Feed, Place, Way};
pub use follow::{Bench, Moved, Zero, follow, follow_each};
pub use guess::{Guess, guess};

use super::audit;
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
    read_back_each(program, &[Operation { plan, tool }], blade, machine)
}

/// A plan and its tool, as one of several that a program was made from.
#[derive(Clone, Copy)]
pub struct Operation<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// Its tool.
    pub tool: &'a Tool,
}

/// As [`read_back`], of a program with a tool call for each operation: every one against its own plan, and all rapids, those from one operation to
/// the next among them.
///
/// # Errors
/// As [`read_back`], and where the program does not call as many tools as there are operations.
pub fn read_back_each(
    program: &Program,
    operations: &[Operation],
    blade: &Blade,
    machine: &Machine,
) -> Result<Vec<Check>> {
    let blocks = read(&program.text, program.language)?;
    let (language, zero) = (program.language, Zero::default());
    let benches: Vec<Bench> = operations.iter().map(|o| Bench { language, zero, tool: o.tool, machine }).collect();
    let moves = follow_each(&blocks, &benches)?;
    let mut out = Vec::new();
    for (k, ((o, bench), moves)) in operations.iter().zip(&benches).zip(&moves).enumerate() {
        let mut found = compare::checks(program, moves, o.plan, blade, o.tool, machine);
        found.extend(audit::rapids(&program.text, moves, blade, bench)?);
        found.extend(audit::travel(&program.text, moves, blade, bench)?);
        if operations.len() > 1 {
            found.iter_mut().for_each(|c| c.note = format!("operation {}; {}", k + 1, c.note));
        }
        out.extend(found);
    }
    out.push(words::check(program));
    Ok(out)
}

/// A line that cannot be read.
fn unreadable(line: usize, what: &str) -> Error {
    Error::usage(Stage::Verify, format!("line {line} of the program: {what}"))
}
