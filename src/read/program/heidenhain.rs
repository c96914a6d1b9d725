//! Heidenhain Klartext: `L`, `LN` and `SPL` blocks, `TCPM`, machine coordinates by `M91`.
//!
//! A word either is acted on, is known to be harmless, or is refused.

use super::block::{Bend, Block, Call, Destination, Feed, RotaryWay, Script};
use super::unreadable;
use crate::artifact::program::{LengthOffset, Programmed, Setting, Turning};
use crate::error::Result;

/// What a block that is refused says.
type Read<T> = std::result::Result<T, String>;

/// Words of a straight block: components of the tool axis, the point, rotary axes.
const WORDS: [&str; 9] = ["TX", "TY", "TZ", "X", "Y", "Z", "A", "B", "C"];

/// State that stays from block to block.
#[derive(Default)]
struct Modal {
    centre_point: bool,
    /// `M126`.
    shorter: bool,
    feed: Option<f64>,
    setting: Setting,
}

struct HeidenhainReader {
    programmed: Programmed,
    modal: Modal,
    script: Script,
}

/// Reads a program.
///
/// # Errors
/// A block that is not understood or not in sequence, with the line.
pub(super) fn read(text: &str, programmed: Programmed) -> Result<Script> {
    let mut reader = HeidenhainReader { programmed, modal: Modal::default(), script: Script::default() };
    for (i, line) in text.lines().enumerate() {
        let code = line.split(';').next().unwrap_or("").trim();
        let (count, rest) = code.split_once(' ').unwrap_or((code, ""));
        let rest = rest.trim();
        let number = i + 1;
        if reader.script.end.is_some() {
            if !rest.is_empty() && !rest.starts_with("END PGM") {
                reader.script.behind.push(number);
            }
            continue;
        }
        let read = if count.parse::<usize>() == Ok(i) {
            reader.statement(number, rest)
        } else {
            Err(format!("the block number is \"{count}\", it must be {i}"))
        };
        read.map_err(|e| unreadable(number, line, &e))?;
    }
    Ok(reader.script)
}

impl HeidenhainReader {
    fn statement(&mut self, number: usize, rest: &str) -> Read<()> {
        let words: Vec<&str> = rest.split_whitespace().collect();
        match &words[..] {
            []
            | ["BLK", "FORM", ..]
            | ["TOOL", "DEF", ..]
            | ["FUNCTION", "MODE", "MILL"]
            | ["PLANE", "RESET", "STAY"] => {}
            [structure, ..] if structure.starts_with('*') => {}
            ["L" | "LN", words @ ..] => return self.straight(number, words),
            ["SPL", words @ ..] => return self.spline(number, words),
            ["STOP", functions @ ..] => self.functions(number, functions)?,
            ["BEGIN", "PGM", .., "MM"] => {}
            ["BEGIN", "PGM", ..] => return Err("programs in inches are not read".into()),
            ["END", "PGM", ..] => self.script.ends(number),
            ["TOOL", "CALL", ..] => self.call(number, rest.get("TOOL CALL".len()..).unwrap_or("").trim())?,
            ["CYCL", "DEF", cycle, words @ ..] => self.cycle(cycle, words)?,
            ["FUNCTION", "TCPM", how @ ..] => self.centre_point(how)?,
            ["FUNCTION", "RESET", "TCPM"] => self.modal.centre_point = false,
            ["C" | "CC" | "CR" | "CT" | "CP" | "CHF" | "RND", ..] => return Err("arcs are not read".into()),
            [word, ..] if function_number(word).is_some() => self.functions(number, &words)?,
            [word, ..] => return Err(format!("\"{word}\" is not known")),
        }
        Ok(())
    }

    /// Miscellaneous functions without a move.
    fn functions(&mut self, number: usize, words: &[&str]) -> Read<()> {
        let mut ends = false;
        for (k, word) in words.iter().enumerate() {
            // The feed of the movements that follow a turn, which the machine makes beside.
            if word.starts_with('F') && k > 0 && words[k - 1] == "M128" {
                value(word, "F")?;
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
            128 => modal.centre_point = true,
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
                _ if word.starts_with('S') => self.modal.setting.rpm = Some(value(word, "S")?),
                _ if word.starts_with('F') => self.modal.feed = Some(value(word, "F")?),
                _ if word.starts_with("DL") || word.starts_with("DR") => {
                    let name = ["DR2", "DR", "DL"].into_iter().find(|n| word.starts_with(n)).unwrap_or("DL");
                    if value(word, name)? != 0.0 {
                        return Err(format!("{word} changes the tool, which is given as it is"));
                    }
                }
                _ => return Err(format!("\"{word}\" is not known")),
            }
        }
        if let Some(tool) = tool {
            let none = tool == "0";
            self.modal.setting.length = if none { LengthOffset::Off } else { LengthOffset::Unsaid };
            self.modal.setting.turning = Turning::Off;
            self.script.calls.push(Call { line, tool: Some(tool) });
        }
        Ok(())
    }

    /// The tolerance (32) and dwelling (9); all others move, or move the frame.
    fn cycle(&mut self, cycle: &str, words: &[&str]) -> Read<()> {
        match cycle {
            "9.0" | "9.1" | "32.0" | "32.2" => {}
            "32.1" => {
                let joined = words.concat();
                let tolerance = if joined.is_empty() { 0.0 } else { value(&joined, "T")? };
                self.modal.setting.tolerance_mm = (tolerance > 0.0).then_some(tolerance);
            }
            _ => return Err(format!("cycle {cycle} is not read")),
        }
        Ok(())
    }

    /// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT …`.
    fn centre_point(&mut self, how: &[&str]) -> Read<()> {
        let reference = match how {
            ["F", "TCP", "AXIS", "POS", "PATHCTRL", "AXIS"] => None,
            ["F", "TCP", "AXIS", "POS", "PATHCTRL", "AXIS", "REFPNT", reference] => Some(*reference),
            _ => return Err("TCPM is read as F TCP AXIS POS PATHCTRL AXIS only".into()),
        };
        let wanted = match self.programmed {
            Programmed::Centre => "CENTER-CENTER",
            Programmed::Tip => "TIP-TIP",
            Programmed::Machine => return Err("TCPM in a program of positions of the axes".into()),
        };
        if let Some(reference) = reference.filter(|r| *r != wanted) {
            return Err(format!("REFPNT {reference} is read as {wanted} only, by what X Y Z are taken for"));
        }
        self.modal.centre_point = true;
        Ok(())
    }

    /// One `SPL` block: `X(t) = K3X t³ + K2X t² + K1X t + X`, `t` from 1 to 0, and likewise of
    /// every axis that it names. An exponent may stand apart from its number.
    fn spline(&mut self, line: usize, words: &[&str]) -> Read<()> {
        // K1, K2, K3 of the point and the rotary axes.
        let mut factors = [[[None; 3]; 3]; 2];
        let mut rest: Vec<&str> = Vec::new();
        let mut words = words.iter().peekable();
        while let Some(word) = words.next() {
            let Some(named) = word.strip_prefix('K') else {
                rest.push(word);
                continue;
            };
            let mut letters = named.chars();
            let order = letters.next().and_then(|c| c.to_digit(10)).filter(|k| (1..=3).contains(k));
            let axis = letters.next().and_then(|c| "XYZABC".find(c));
            let (Some(order), Some(axis)) = (order, axis) else { return Err(format!("\"{word}\" is not known")) };
            let is_exponent = |next: &&&str| next.starts_with('E') && next.len() > 1;
            let whole = format!("{word}{}", words.next_if(is_exponent).unwrap_or(&""));
            let factor = value(&whole, word.get(..3).unwrap_or(""))?;
            if factors[axis / 3][axis % 3][order as usize - 1].replace(factor).is_some() {
                return Err(format!("\"{word}\" is a second word of its axis"));
            }
        }
        let before = self.script.blocks.len();
        self.straight(line, &rest)?;
        let Some(block) = self.script.blocks.get_mut(before) else { return Err("an SPL block goes nowhere".into()) };
        let Destination::Words { point, rotary } = block.place else { return Err("a vector in an SPL block".into()) };
        let mut bend = Bend { begins: Some([[0.0; 3]; 2]), ..Bend::default() };
        for (kind, ends) in [point, rotary].into_iter().enumerate() {
            for axis in 0..3 {
                let (k1, k2, k3) = match (ends[axis], factors[kind][axis]) {
                    (None, [None, None, None]) => continue,
                    (Some(_), [Some(k1), Some(k2), Some(k3)]) => (k1, k2, k3),
                    _ => return Err("an SPL block needs the end and K3, K2, K1 of every axis that it names".into()),
                };
                // From t to p = 1 - t.
                let of = if kind == 0 { &mut bend.point } else { &mut bend.rotary };
                of[axis] = [k2 + 3.0 * k3, -k3, 0.0, 0.0];
                if let Some(begins) = &mut bend.begins {
                    begins[kind][axis] = k1 + k2 + k3;
                }
            }
        }
        block.bend = Some(bend);
        Ok(())
    }

    /// One `L` or `LN` block.
    fn straight(&mut self, line: usize, words: &[&str]) -> Read<()> {
        // Components of the tool axis, of the point, and rotary axes.
        let mut said = [[None; 3]; 3];
        let (mut machine, mut rapid, mut ends) = (false, false, false);
        for (k, word) in words.iter().enumerate() {
            if let Some((at, name)) = WORDS.iter().enumerate().find(|(_, name)| word.starts_with(**name)) {
                if said[at / 3][at % 3].replace(value(word, name)?).is_some() {
                    return Err(format!("\"{word}\" is a second word of its axis"));
                }
                continue;
            }
            match *word {
                "R0" => {}
                "FMAX" => rapid = true,
                "M91" => machine = true,
                _ if word.starts_with('F') && k > 0 && words[k - 1] == "M128" => {
                    value(word, "F")?;
                }
                _ if word.starts_with('F') => self.modal.feed = Some(value(word, "F")?),
                _ => ends |= self.function(word)?,
            }
        }
        let [axis, point, rotary] = said;
        let place = match axis {
            [None, None, None] => Destination::Words { point, rotary },
            [Some(x), Some(y), Some(z)] => Destination::Vector { point, axis: [x, y, z] },
            _ => return Err("an LN block needs TX, TY and TZ".into()),
        };
        if matches!(place, Destination::Vector { .. }) && rotary.iter().any(Option::is_some) {
            return Err("a vector and words of rotary axes in one block".into());
        }
        if point.iter().chain(&rotary).chain(&axis).any(Option::is_some) {
            let feed = match (rapid, self.modal.feed) {
                (true, _) => Feed::Rapid,
                (false, Some(f)) if f > 0.0 => Feed::PerMinute(f),
                _ => return Err("a straight block before any F".into()),
            };
            let way = if self.modal.shorter { RotaryWay::Shorter } else { RotaryWay::To };
            self.script.blocks.push(Block {
                machine,
                centre_point: self.modal.centre_point,
                ways: [way; 3],
                tool_calls: self.script.calls.len(),
                setting: self.modal.setting,
                ..Block::straight(line, place, feed)
            });
        }
        if ends {
            self.script.ends(line);
        }
        Ok(())
    }
}

/// The number of a word `M3`.
fn function_number(word: &str) -> Option<u32> {
    word.strip_prefix('M')?.parse().ok()
}

/// The number behind a name; a comma may be the point.
fn value(word: &str, name: &str) -> Read<f64> {
    let text = word.strip_prefix(name).unwrap_or("").replace(',', ".");
    text.parse().ok().filter(|v: &f64| v.is_finite()).ok_or_else(|| format!("\"{word}\" is not a number"))
}
