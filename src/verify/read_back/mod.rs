//! Programs read back: from the text to what the machine does, and that against the plan.
//!
//! **In**: a [`Program`], the [`Plan`] it was posted from, [`Tool`], [`Machine`]. **Out**:
//! [`Check`]s. [`crate::read::program`] reads the text and moves the machine through it. Neither
//! room shares anything with the writers of programs.
//!
//! | check | measured |
//! | --- | --- |
//! | `program-centre` | distance of the ball centre at the end of each cutting line from the plan's path |
//! | `program-direction` | angle between the tool axis there and the plan's, which is even in θ between locations |
//! | `program-curve` | angle between the tool axis *within* each polynomial line and the schedule's curve θ(S); ball centres within it count under `program-centre` |
//! | `program-chord` | distance of the ball centre from the plan's path *within* each cutting line, the control moving every word evenly; at most the chord tolerance, or 0.1 µm where that is less |
//! | `program-joints` | jumps of the first three derivatives of ball centre and rotary axes where two polynomial lines of a programmed curve meet, over what rounding and a hundredth of the greatest third derivative allow (page of `joints.rs`) |
//! | `program-missing` | distance of each cutter location from the program's path: a line that is missing shows |
//! | `program-rapids` | least distance of the whole tool to the part and what stands about it in rapids, those between operations among them |
//! | `program-travel` | how far an axis leaves its travel in any move, rapids, approach and retract among them |
//! | `program-feed` | time of each cutting line against the plan's between the places where it begins and ends |
//! | `program-time` | whole time of the cutting lines against the plan's |
//! | `program-end` | whether the program ends, and lines behind its end, which are not machined |
//! | `program-tool`, `program-tool-length`, `program-spindle`, `program-smoothing`, `program-frame` | lines at a feed with another tool, length offset, spindle, tolerance of the control or work offset than the program was written with ([`Asked`]) |
//! | `program-words` | words outside what the control reads by its post file: value, digits after the point |
//!
//! A word that is neither acted on nor known to be harmless is refused with its line.
//!
//! **Limits**: axes move evenly from line to line, or on the polynomials of the line (no smoothing
//! of the control's own), programmed vectors as the rotary axes that reach them. `G43.4` and
//! `G43.5` fix X, Y, Z to the table as it stands where they come on, as their manuals say; all
//! other controls to the table as it stands at 0. Approach and retract at a feed are read, not
//! judged: the way that they take is judged with the plan (`lead-clearance`).

mod compare;
mod joints;
mod words;

use super::{audit, setting};
use crate::artifact::program::{Asked, Language, Program};
use crate::artifact::report::Check;
use crate::artifact::{CheckId, PartAmong, Plan};
use crate::error::Result;
use crate::machine::Machine;
use crate::read::program::{Bench, Zero, follow_each, read};
use crate::tool::Tool;

/// Reads a program back and compares it with the plan that it was made from.
///
/// # Errors
/// As [`read`], and where a line cannot be reached by the machine.
pub fn read_back<'a>(
    program: &Program,
    plan: &Plan,
    part: impl Into<PartAmong<'a>>,
    tool: &Tool,
    machine: &Machine,
) -> Result<Vec<Check>> {
    read_back_each(program, &[Operation { plan, tool }], part, machine)
}

/// A plan and its tool, as one of several that a program was made from.
#[derive(Clone, Copy)]
pub struct Operation<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// Its tool.
    pub tool: &'a Tool,
}

/// As [`read_back`], of a program with a tool call for each operation: every one against its own
/// plan, and all rapids, those from one operation to the next among them.
///
/// # Errors
/// As [`read_back`], and where the program does not call as many tools as there are operations.
pub fn read_back_each<'a>(
    program: &Program,
    operations: &[Operation],
    part: impl Into<PartAmong<'a>>,
    machine: &Machine,
) -> Result<Vec<Check>> {
    let part = part.into();
    let script = read(&program.text, program.language)?;
    let (language, zero) = (program.language, Zero::default());
    let benches: Vec<Bench> = operations.iter().map(|o| Bench { language, zero, tool: o.tool, machine }).collect();
    let moves = follow_each(&script.blocks, &benches)?;
    let mut out = vec![setting::end(CheckId::ProgramEnd, &script).of_own(program)];
    for (k, ((o, bench), moves)) in operations.iter().zip(&benches).zip(&moves).enumerate() {
        let blocks = script.blocks_of(moves);
        let mut found = compare::checks(program, moves, o.plan, part.blade, o.tool, machine);
        found.extend(setting::own(&script, blocks, program.asked.get(k), o.tool).map(|f| f.of_own(program)));
        found.extend(audit::rapids(&program.text, moves, &part, bench)?);
        found.extend(audit::travel(&program.text, moves, part.blade, bench)?);
        if operations.len() > 1 {
            found.iter_mut().for_each(|c| c.note = format!("operation {}; {}", k + 1, c.note));
        }
        out.extend(found);
    }
    out.push(words::check(program));
    Ok(out)
}

/// What the operations of a text are written with: tool number and spindle speed of each as given,
/// the rest as the text says it. To be kept with the text, which may be another when it is read
/// back.
pub fn asked(text: &str, language: Language, operations: impl Iterator<Item = (u32, f64)>) -> Vec<Asked> {
    // What cannot be read says nothing; reading it back says why.
    let script = read(text, language).unwrap_or_default();
    let one = |(k, (tool_number, spindle_rpm)): (usize, (u32, f64))| Asked {
        tool_number,
        spindle_rpm,
        setting: setting::at_first_feed(&script, k),
        frame: script.frame,
    };
    operations.enumerate().map(one).collect()
}
