//! Heidenhain Klartext: `L`, `LN`, `C`, `CR` and `SPL` blocks, `TCPM`, machine coordinates by
//! `M91`, datum shifts, `PLANE SPATIAL`, calls of labels.
//!
//! A word either is acted on, is known to be harmless, or is refused.

mod labels;
mod moves;
mod plane;
mod spline;

use std::collections::HashMap;

use super::block::{Block, Call, Destination, Feed, Script};
use super::unreadable;
use super::walk::Walk;
use crate::artifact::program::{LengthOffset, Programmed, Setting, Turning};
use crate::error::Result;
use labels::Labels;
use plane::Frames;

/// What a block that is refused says.
type Read<T> = std::result::Result<T, String>;

/// State that stays from block to block.
#[derive(Default)]
struct Modal {
    centre_point: bool,
    /// `M126`.
    shorter: bool,
    /// `PATHCTRL VECTOR`.
    great_circle: bool,
    feed: Option<f64>,
    /// `CC`.
    pole: [Option<f64>; 2],
    frames: Frames,
    /// A tool is in the spindle.
    has_tool: bool,
    setting: Setting,
}

struct HeidenhainReader {
    programmed: Programmed,
    modal: Modal,
    script: Script,
    /// Values of `Q1` that the text has set.
    constants: HashMap<u32, f64>,
}

/// What a block does to the order of blocks.
enum Jump {
    /// `CALL LBL 1`.
    Call(String),
    /// `CALL LBL 1 REP 3`.
    Again(String, u32),
    /// `LBL 0`.
    Done,
}

/// Reads a program.
///
/// # Errors
/// A block that is not understood or not in sequence, with the line.
pub(super) fn read(text: &str, programmed: Programmed) -> Result<Script> {
    let lines: Vec<&str> = text.lines().collect();
    let mut reader =
        HeidenhainReader { programmed, modal: Modal::default(), script: Script::default(), constants: HashMap::new() };
    let mut labels = Labels::of(&lines);
    let mut walk = Walk::default();
    let last = lines.len().saturating_sub(1);
    let at_end = |e: String| unreadable(last + 1, lines.get(last).unwrap_or(&""), &e);
    while let Some(i) = walk.step(lines.len()).map_err(at_end)? {
        let (count, rest) = parts(lines[i]);
        let read = if count.parse::<usize>() == Ok(i) {
            reader.statement(i + 1, rest).and_then(|jump| labels.jump(i, jump, &mut walk))
        } else {
            Err(format!("the block number is \"{count}\", it must be {i}"))
        };
        read.map_err(|e| unreadable(i + 1, lines[i], &e))?;
        if reader.script.end.is_some() {
            break;
        }
    }
    let behind = (reader.script.end.unwrap_or(lines.len())..lines.len()).filter(|i| {
        let rest = parts(lines[*i]).1;
        !rest.is_empty() && !rest.starts_with("END PGM") && !labels.has_called(*i)
    });
    reader.script.behind = behind.map(|i| i + 1).collect();
    Ok(reader.script)
}

/// Number and statement of a block, without its comment.
fn parts(line: &str) -> (&str, &str) {
    let code = line.split(';').next().unwrap_or("").trim();
    let (count, rest) = code.split_once(' ').unwrap_or((code, ""));
    (count, rest.trim())
}

impl HeidenhainReader {
    fn statement(&mut self, number: usize, rest: &str) -> Read<Option<Jump>> {
        let joined = rest.replace(" F MAX", " FMAX");
        let words: Vec<&str> = joined.split_whitespace().collect();
        match &words[..] {
            [] | ["BLK", "FORM", ..] | ["TOOL", "DEF", ..] | ["FUNCTION", "MODE", "MILL"] => {}
            [structure, ..] if structure.starts_with('*') => {}
            [kind @ ("L" | "LN" | "C" | "CR"), words @ ..] => self.moves(number, kind, words)?,
            ["SPL", words @ ..] => self.spline(number, words)?,
            ["CC", words @ ..] => self.pole(words)?,
            ["PLANE", words @ ..] => self.plane(number, words)?,
            ["TRANS", "DATUM", words @ ..] => self.datum(words)?,
            ["LBL", "0"] => return Ok(Some(Jump::Done)),
            ["LBL", _] => {}
            ["CALL", "LBL", name] => return Ok(Some(Jump::Call((*name).to_owned()))),
            ["CALL", "LBL", name, repeats @ ..] => {
                let repeats = repeats.concat();
                let count = repeats.strip_prefix("REP").and_then(|r| r.split('/').next()?.parse().ok());
                let count = count.ok_or("CALL LBL is read with its label, and REP with a number")?;
                return Ok(Some(Jump::Again((*name).to_owned(), count)));
            }
            ["STOP", functions @ ..] => self.functions(number, functions)?,
            ["BEGIN", "PGM", .., "MM"] => {}
            ["BEGIN", "PGM", ..] => return Err("programs in inches are not read".into()),
            ["END", "PGM", ..] => self.script.ends(number),
            ["TOOL", "CALL", ..] => self.call(number, rest.get("TOOL CALL".len()..).unwrap_or("").trim())?,
            ["CYCL", "DEF", cycle, words @ ..] => self.cycle(cycle, words)?,
            ["FUNCTION", "TCPM", how @ ..] => self.centre_point(how)?,
            ["FUNCTION", "RESET", "TCPM"] => self.modal.centre_point = false,
            [kind @ ("CT" | "CP" | "LP" | "CTP" | "CHF" | "RND"), ..] => {
                return Err(format!("{kind} is not read; arcs are read as C with CC, and CR"));
            }
            [word, ..] if word.starts_with('Q') || *word == "FN" || word.starts_with("FN0") => self.constant(&words)?,
            [word, ..] if function_number(word).is_some() => self.functions(number, &words)?,
            [word, ..] => return Err(format!("\"{word}\" is not known")),
        }
        Ok(None)
    }

    /// `Q1 = +5`, `FN 0: Q1 = +5`.
    fn constant(&mut self, words: &[&str]) -> Read<()> {
        let joined = words.concat();
        let plain = joined.strip_prefix("FN0:").unwrap_or(&joined);
        let (name, text) = plain.split_once('=').ok_or("only Q1 = number and FN 0 are read of parameters")?;
        let number = name.strip_prefix('Q').and_then(|n| n.parse().ok());
        let number = number.ok_or_else(|| format!("\"{name}\" is no parameter Q"))?;
        let value = self.value(text, "")?;
        self.constants.insert(number, value);
        Ok(())
    }

    /// The number behind a name, or the constant; a comma may be the point.
    fn value(&self, word: &str, name: &str) -> Read<f64> {
        let text = word.strip_prefix(name).unwrap_or("");
        let unsigned = text.trim_start_matches(['+', '-']);
        if let (Some(number), true) = (unsigned.strip_prefix('Q'), text.len() <= unsigned.len() + 1) {
            let value = number.parse().ok().and_then(|n| self.constants.get(&n));
            let value = value.ok_or_else(|| format!("{unsigned} has not been set to a number"))?;
            return Ok(if text.starts_with('-') { -value } else { *value });
        }
        let value = text.replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite());
        value.ok_or_else(|| format!("\"{word}\" is not a number"))
    }

    /// Miscellaneous functions without a move.
    fn functions(&mut self, number: usize, words: &[&str]) -> Read<()> {
        let mut ends = false;
        for (k, word) in words.iter().enumerate() {
            // The feed of the movements that follow a turn, which the machine makes beside.
            if word.starts_with('F') && k > 0 && words[k - 1] == "M128" {
                self.value(word, "F")?;
                continue;
            }
            ends |= self.function(word)?;
        }
        if ends {
            self.script.ends(number);
        }
        Ok(())
    }

    /// One miscellaneous function; whether it ends the program.
    fn function(&mut self, word: &str) -> Read<bool> {
        let modal = &mut self.modal;
        match function_number(word).ok_or_else(|| format!("\"{word}\" is not known"))? {
            2 | 30 => return Ok(true),
            3 | 13 => modal.setting.turning = Turning::Right,
            4 | 14 => modal.setting.turning = Turning::Left,
            5 | 19 => modal.setting.turning = Turning::Off,
            126 => modal.shorter = true,
            127 => modal.shorter = false,
            128 => (modal.centre_point, modal.great_circle) = (true, false),
            129 => modal.centre_point = false,
            // Stops and coolant.
            0 | 1 | 7 | 8 | 9 => {}
            _ => return Err(format!("{word} is not read")),
        }
        Ok(false)
    }

    /// `TOOL CALL 1 Z S6000 F500 DL+0 DR+0`; without a tool it only sets speed and feed.
    fn call(&mut self, line: usize, code: &str) -> Read<()> {
        let (tool, rest) = if let Some(named) = code.strip_prefix('"') {
            let (name, rest) = named.split_once('"').ok_or("a name without its second \"")?;
            (Some(name.to_owned()), rest)
        } else {
            let (first, rest) = code.split_once(' ').unwrap_or((code, ""));
            match first.parse::<f64>() {
                Ok(n) if n.is_finite() => (Some(n.to_string()), rest),
                _ => (None, code),
            }
        };
        for word in rest.split_whitespace() {
            match word {
                "Z" => {}
                _ if word.starts_with('S') => self.modal.setting.rpm = Some(self.value(word, "S")?),
                _ if word.starts_with('F') => self.modal.feed = Some(self.value(word, "F")?),
                _ if word.starts_with("DL") || word.starts_with("DR") => {
                    let name = ["DR2", "DR", "DL"].into_iter().find(|n| word.starts_with(n)).unwrap_or("DL");
                    if self.value(word, name)? != 0.0 {
                        return Err(format!("{word} changes the tool, which is given as it is"));
                    }
                }
                _ => return Err(format!("\"{word}\" is not known")),
            }
        }
        if let Some(tool) = tool {
            let none = tool == "0";
            self.modal.has_tool = !none;
            self.modal.setting.length = if none { LengthOffset::Off } else { LengthOffset::Unsaid };
            self.modal.setting.turning = Turning::Off;
            self.script.calls.push(Call { line, tool: Some(tool) });
        }
        Ok(())
    }

    /// The tolerance (32), dwelling (9) and datum shifts (7); all others move, or turn the frame.
    fn cycle(&mut self, cycle: &str, words: &[&str]) -> Read<()> {
        match cycle {
            "7.0" | "9.0" | "9.1" | "32.0" | "32.2" => {}
            "7.1" | "7.2" | "7.3" => self.datum(words)?,
            "32.1" => {
                let joined = words.concat();
                let tolerance = if joined.is_empty() { 0.0 } else { self.value(&joined, "T")? };
                self.modal.setting.tolerance_mm = (tolerance > 0.0).then_some(tolerance);
            }
            _ => return Err(format!("cycle {cycle} is not read")),
        }
        Ok(())
    }

    /// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT …`.
    fn centre_point(&mut self, how: &[&str]) -> Read<()> {
        let (path, reference) = match how {
            ["F", "TCP", "AXIS", "POS", "PATHCTRL", path] => (*path, None),
            ["F", "TCP", "AXIS", "POS", "PATHCTRL", path, "REFPNT", reference] => (*path, Some(*reference)),
            _ => ("", None),
        };
        if path != "AXIS" && path != "VECTOR" {
            return Err("TCPM is read as F TCP AXIS POS PATHCTRL AXIS or VECTOR only".into());
        }
        let wanted = match self.programmed {
            Programmed::Centre => "CENTER-CENTER",
            Programmed::Tip => "TIP-TIP",
            Programmed::Machine => return Err("TCPM in a program of positions of the axes".into()),
        };
        if let Some(reference) = reference.filter(|r| *r != wanted) {
            return Err(format!("REFPNT {reference} is read as {wanted} only, by what X Y Z are taken for"));
        }
        (self.modal.centre_point, self.modal.great_circle) = (true, path == "VECTOR");
        Ok(())
    }
}

/// The number of a word `M3`.
fn function_number(word: &str) -> Option<u32> {
    word.strip_prefix('M')?.parse().ok()
}
