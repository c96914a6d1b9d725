//! What a program sets beside its motion: that it ends, tool, length offset, spindle, how far the
//! control may leave the path, work offset.

use crate::artifact::CheckId;
use crate::artifact::program::{Asked, LengthOffset, Program, Setting, Turning};
use crate::artifact::report::Check;
use crate::read::program::{Block, Call, Feed, Script};
use crate::tool::Tool;

/// No spindle that mills turns faster, 1/min.
const FASTEST_RPM: f64 = 200_000.0;
/// A program's speed is the job's within its rounding: relative, and 1/min.
const SPEED: (f64, f64) = (0.001, 0.5);
/// Rounding of a tolerance, relative.
const ROUNDED: f64 = 0.01;
/// A cutter that a file was computed for is the given one within this, mm.
const CUTTER_MM: f64 = 0.01;

/// A check, with its line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finding {
    /// Which check.
    pub id: CheckId,
    /// What was measured.
    pub quantity: &'static str,
    /// Worst value.
    pub worst: f64,
    /// Its limit.
    pub limit: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// The line of the first that is wrong.
    pub line: Option<usize>,
    /// What is wrong there.
    pub note: String,
}

impl Finding {
    /// A check of an own program.
    pub fn of_own(self, program: &Program) -> Check {
        let line = self.line.map(|l| format!(", line {l}")).unwrap_or_default();
        let note = if self.note.is_empty() { String::new() } else { format!("; {}", self.note) };
        let note = format!("{}{line}{note}", program.file_name);
        Check::at_most(self.id, self.quantity, self.worst, self.limit, self.unit, note)
    }
}

/// How many lines are wrong, and what is wrong in the first.
fn counted(id: CheckId, quantity: &'static str, wrong: impl Iterator<Item = (usize, String)>) -> Finding {
    let mut first = None;
    let count = wrong.map(|w| first.get_or_insert(w).0).count();
    let (line, note) = first.map_or((None, String::new()), |(line, note)| (Some(line), note));
    Finding { id, quantity, worst: count as f64, limit: 0.0, unit: "lines", line, note }
}

/// That a program ends, and that nothing stands behind its end.
pub(super) fn end(id: CheckId, script: &Script) -> Finding {
    let last = script.blocks.last().map_or(1, |b| b.line);
    let note = |line: &usize| {
        let end = script.end.unwrap_or(0);
        (*line, format!("the program ends with line {end}: what stands behind it is not machined"))
    };
    let none = script.end.is_none().then(|| (last, "the program has no end: the file may be cut off".to_owned()));
    counted(
        id,
        "lines that a program without its end lacks, or has behind it",
        script.behind.iter().map(note).chain(none),
    )
}

/// The lines at a feed.
fn at_feed(blocks: &[Block]) -> impl Iterator<Item = &Block> + Clone {
    blocks.iter().filter(|b| b.feed != Feed::Rapid)
}

/// An own program's moves of one operation, against what they were written with.
pub(super) fn own<'a>(
    script: &'a Script,
    blocks: &'a [Block],
    asked: Option<&'a Asked>,
    tool: &Tool,
) -> impl Iterator<Item = Finding> {
    let cuts = at_feed(blocks);
    let rpm = asked.map(|a| a.spindle_rpm);
    let length = asked.map(|a| a.setting.length);
    let mut out = vec![
        tools(CheckId::ProgramTool, script, blocks, asked.map(|a| a.tool_number), tool),
        lengths(CheckId::ProgramToolLength, script, cuts.clone(), length),
        spindle(CheckId::ProgramSpindle, cuts.clone(), rpm),
    ];
    if let Some(asked) = asked {
        out.push(smoothing_as_written(cuts.clone(), asked));
        out.push(frame(script, cuts, asked));
    }
    out.into_iter()
}

/// Moves of a program of others: those that are known to cut, and all of them; `tolerance_mm`: how
/// far the control may leave the path.
pub(super) fn theirs<'a>(
    script: &'a Script,
    blocks: &'a [Block],
    cuts: impl Iterator<Item = &'a Block> + Clone,
    tolerance_mm: f64,
    tool: &Tool,
) -> [Finding; 4] {
    let widest = cuts.clone().filter_map(|b| b.setting.tolerance_mm.map(|t| (b.line, t)));
    let widest = widest.reduce(|a, b| if b.1 > a.1 { b } else { a });
    let smoothing = Finding {
        id: CheckId::Smoothing,
        quantity: "how far the program lets the control leave the path",
        worst: widest.map_or(0.0, |w| w.1),
        limit: tolerance_mm,
        unit: "mm",
        line: widest.map(|w| w.0),
        note: "the limit is the greater of the gouge and the scallop that are allowed".into(),
    };
    // With another length the tool may be anywhere but at the part.
    [
        tools(CheckId::Tool, script, blocks, None, tool),
        lengths(CheckId::ToolLength, script, at_feed(blocks), None),
        spindle(CheckId::Spindle, cuts, None),
        smoothing,
    ]
}

/// One tool, the one that was asked for, and the one that the file was computed for.
fn tools(id: CheckId, script: &Script, blocks: &[Block], asked: Option<u32>, tool: &Tool) -> Finding {
    let name = |call: &Call| call.tool.clone().unwrap_or_else(|| "not named".into());
    let call = |b: &Block| b.tool_calls.checked_sub(1).and_then(|k| script.calls.get(k));
    // Moves in positions of the axes go to and from a change.
    let with = blocks.iter().filter(|b| b.feed != Feed::Rapid || !b.machine).filter_map(|b| Some((b, call(b)?)));
    let first = with.clone().next().map(|(_, c)| name(c));
    let wrong = with.filter_map(|(b, c)| {
        let tool = name(c);
        let before = first.clone().filter(|f| *f != tool);
        let what = match (asked.map(|a| a.to_string()).filter(|a| *a != tool), before) {
            (Some(asked), _) => format!("line {} calls tool {tool}, the job's is {asked}", c.line),
            (None, Some(first)) => {
                format!("the program calls tool {first} and, in line {}, tool {tool}; one tool is given", c.line)
            }
            (None, None) if tool == "0" => format!("line {} puts the tool away", c.line),
            (None, None) => return None,
        };
        Some((b.line, what))
    });
    // A file of several operations says several.
    let cutter = |b: &Block| script.cutters.iter().rev().find(|c| c.0 < b.line).copied();
    let other = at_feed(blocks).filter_map(cutter).filter_map(|(line, [d, r])| {
        let same = (d - 2.0 * tool.radius_mm).abs() <= CUTTER_MM && (r - tool.corner_mm()).abs() <= CUTTER_MM;
        (!same).then(|| (line, format!("the file was computed for a cutter of diameter {d} and corner radius {r} mm")))
    });
    counted(id, "lines with another tool than the one that is given", wrong.chain(other))
}

/// As a length offset counts in a line: Siemens takes the first edge where none is said.
fn counts(said: LengthOffset, b: &Block) -> LengthOffset {
    match said {
        LengthOffset::Unsaid if b.centre_point => LengthOffset::Edge(1),
        LengthOffset::Unsaid => LengthOffset::Off,
        said => said,
    }
}

fn in_words(length: LengthOffset) -> String {
    match length {
        LengthOffset::Unsaid | LengthOffset::Off => "no length of the tool".into(),
        LengthOffset::Number(n) => format!("the length of offset H{n}"),
        LengthOffset::Edge(n) => format!("the length of edge D{n}"),
    }
}

/// The length of the tool: on wherever a point over the part is programmed, of the tool that was
/// called, and the same all over.
fn lengths<'a>(
    id: CheckId,
    script: &Script,
    cuts: impl Iterator<Item = &'a Block>,
    asked: Option<LengthOffset>,
) -> Finding {
    let mut first: Option<(usize, LengthOffset)> = None;
    let wrong = cuts.filter(|b| !b.machine).filter_map(|b| {
        let length = counts(b.setting.length, b);
        let before = first.filter(|(calls, _)| *calls == b.tool_calls).map_or(length, |(_, before)| before);
        first = Some((b.tool_calls, before));
        let has = in_words(length);
        let called = b.tool_calls.checked_sub(1).and_then(|k| script.calls.get(k)).and_then(|c| c.tool.as_deref());
        let of_tool = called.and_then(|t| t.parse::<u32>().ok());
        let what = match (length, of_tool) {
            (LengthOffset::Off, _) if b.centre_point => format!("{has} is taken into account"),
            _ if before != length => format!("{has}, before it was {}", in_words(before)),
            _ if asked.is_some_and(|a| counts(a, b) != length) => {
                format!("{has}, written with {}", in_words(asked.unwrap_or_default()))
            }
            // Whoever writes a post file may number otherwise.
            (LengthOffset::Number(n), Some(tool)) if n != tool && asked.is_none() => format!("{has} with tool {tool}"),
            _ => return None,
        };
        Some((b.line, what))
    });
    counted(id, "lines at a feed with another length of the tool than its own", wrong)
}

/// The spindle turns, the way that cutters cut, at a speed that there is.
fn spindle<'a>(id: CheckId, cuts: impl Iterator<Item = &'a Block>, asked: Option<f64>) -> Finding {
    let wrong = cuts.filter_map(|b| {
        let what = match (b.setting.turning, b.setting.rpm) {
            (Turning::Off, _) => "the spindle stands".to_owned(),
            (Turning::Left, _) => "the spindle turns counter-clockwise, against the cutting edges".into(),
            (Turning::Right, None) => "the spindle has no speed".into(),
            (Turning::Right, Some(rpm)) if rpm <= 0.0 => format!("the spindle's speed is {rpm}"),
            (Turning::Right, Some(rpm)) if rpm > FASTEST_RPM => {
                format!("the spindle's speed is {rpm} 1/min, no spindle that mills turns faster than {FASTEST_RPM}")
            }
            (Turning::Right, Some(rpm)) => {
                let asked = asked.filter(|a| (a - rpm).abs() > SPEED.0 * a + SPEED.1)?;
                format!("the spindle's speed is {rpm} 1/min, the job's {asked}")
            }
        };
        Some((b.line, what))
    });
    counted(id, "lines at a feed with the spindle off, the wrong way or at another speed", wrong)
}

/// How far the control may leave the path, and how rotary axes go, as the program was written.
fn smoothing_as_written<'a>(cuts: impl Iterator<Item = &'a Block>, asked: &Asked) -> Finding {
    let written = asked.setting;
    let mm = |t: Option<f64>| t.map_or_else(|| "no tolerance".to_owned(), |t| format!("a tolerance of {t} mm"));
    let wrong = cuts.filter_map(|b| {
        let same = match (b.setting.tolerance_mm, written.tolerance_mm) {
            (Some(is), Some(was)) => is <= was * (1.0 + ROUNDED),
            (is, was) => is == was,
        };
        let what = match (same, written.axes_evenly && !b.setting.axes_evenly) {
            (false, _) => format!("{}, written with {}", mm(b.setting.tolerance_mm), mm(written.tolerance_mm)),
            (true, true) => "written with ORIAXES".into(),
            (true, false) => return None,
        };
        Some((b.line, what))
    });
    counted(CheckId::ProgramSmoothing, "lines in which the control may leave the path further than planned", wrong)
}

/// The work offset that the program was written in.
fn frame<'a>(script: &Script, cuts: impl Iterator<Item = &'a Block>, asked: &Asked) -> Finding {
    let name = |f: Option<u32>| f.map_or_else(|| "no work offset".to_owned(), |f| format!("G{f}"));
    let what = || format!("{}, written with {}", name(script.frame), name(asked.frame));
    let wrong = cuts.filter(|_| script.frame != asked.frame).map(|b| (b.line, what()));
    counted(CheckId::ProgramFrame, "lines at a feed in another work offset than the one written", wrong)
}

/// What an operation is set to where it begins to move at a feed; operations follow tool calls.
pub(super) fn at_first_feed(script: &Script, operation: usize) -> Setting {
    let first = at_feed(&script.blocks).find(|b| b.tool_calls.max(1) == operation + 1);
    first.map_or_else(Setting::default, |b| b.setting)
}
