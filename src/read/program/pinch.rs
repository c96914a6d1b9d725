//! Programs of two tools, read line by line.
//!
//! Such programs move all axes of the machine, also those of the second tool, which no [`Block`] of
//! one tool has. So they have a reader that knows their words, and refuses every other. It reads
//! ISO words (`X12.3`), Siemens' (`X=12.3`, `A=DC(12.3)`, `M1=3`); comments as in all G code.
//!
//! [`Block`]: super::Block

use std::collections::BTreeSet;

use super::gcode::code;
use crate::artifact::Axes;
use crate::machine::Machine;

/// Names without a number that move nothing.
const WORDS: [&str; 10] =
    ["TRAFOOF", "TRANS", "SUPA", "SOFT", "FFWON", "FFWOF", "COMPOF", "RTLION", "FGROUP()", "STOPRE"];
/// G words that move nothing and whose meaning stays.
const SET: [f64; 15] = [5.1, 17.0, 21.0, 40.0, 49.0, 53.0, 54.0, 64.0, 80.0, 90.0, 93.0, 94.0, 500.0, 642.0, 710.0];

/// No machine has positions farther from its zero, mm and degrees.
const FARTHEST: f64 = 1e5;

/// What a line does.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its number in the text, from 1; of two channels both, else 0 for the second.
    pub numbers: [usize; 2],
    /// It is a rapid.
    pub is_rapid: bool,
    /// Time that it asks for, s; `None`: a rapid.
    pub seconds: Option<f64>,
    /// Where all axes stand behind it, mm and rad; those not yet named are not numbers.
    pub at: Axes,
}

impl Line {
    /// Which it is, in words.
    pub fn named(&self) -> String {
        match self.numbers {
            [one, 0] => format!("line {one}"),
            [one, two] => format!("line {one} of channel 1 and {two} of channel 2"),
        }
    }
}

/// A wait mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Number of its line, from 1.
    pub line: usize,
    /// Its own number.
    pub mark: u32,
    /// The channels that it waits for.
    pub channels: Vec<u32>,
}

/// A spindle where the tools begin to cut.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spindle {
    /// Its speed, 1/min.
    pub rpm: f64,
    /// It turns.
    pub turns: bool,
}

/// A program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Read {
    /// Its moves between two marks each; one more than there are marks.
    pub parts: Vec<Vec<Line>>,
    /// Its marks.
    pub marks: Vec<Mark>,
    /// Columns of the axes that it names, with the line that does so first.
    pub named: Vec<(usize, usize)>,
    /// What is not set where it first moves at a feed.
    pub unset: Vec<&'static str>,
    /// Both spindles there.
    pub spindles: [Spindle; 2],
    /// How far the control may leave the lines, mm; `None`: not said.
    pub tolerance_mm: Option<f64>,
    /// It ends: M2 or M30 is its last word.
    pub ends: bool,
}

/// Reads the program of a channel, from 0; `None`: there is one.
///
/// # Errors
/// The number of the first line that cannot be read, and what is wrong with it.
pub fn read(text: &str, machine: &Machine, channel: Option<usize>) -> Result<Read, (usize, String)> {
    let mut reader = Reader {
        machine,
        own: channel.unwrap_or(0),
        at: Axes::from_fn(machine.axes().len(), |_| f64::NAN),
        rapid: true,
        inverse: false,
        feed: None,
        seen: Vec::new(),
        began: false,
        out: Read { parts: vec![Vec::new()], ..Read::default() },
    };
    for (number, line) in (1..).zip(text.lines()) {
        let shown = || line.chars().take(80).collect::<String>();
        let wrong = |what: String| (number, format!("{what} in `{}`", shown()));
        let code = code(line).map_err(wrong)?;
        reader.block(number, &code).map_err(wrong)?;
    }
    Ok(reader.out)
}

/// The names of all words of a program, as far as its comments can be told from it: what stands
/// before a number, an equals sign or a bracket.
pub fn names(text: &str) -> BTreeSet<String> {
    let name = |word: &str| word.split(|c: char| "=(-+.".contains(c) || c.is_ascii_digit()).next().map(str::to_owned);
    let code = |line: &str| code(line).unwrap_or_default();
    text.lines().flat_map(|line| code(line).split_whitespace().filter_map(name).collect::<Vec<_>>()).collect()
}

/// How far the words of a program have led.
struct Reader<'a> {
    machine: &'a Machine,
    /// The tool of a word that names no spindle.
    own: usize,
    at: Axes,
    rapid: bool,
    inverse: bool,
    /// F per minute that was given last.
    feed: Option<f64>,
    seen: Vec<String>,
    /// It has moved at a feed.
    began: bool,
    out: Read,
}

/// What the words of a block say together.
#[derive(Default)]
struct Block {
    /// It waits: G4, F says for how many seconds.
    waits: bool,
    /// Columns of the axes that it names.
    moves: Vec<usize>,
    feed: Option<f64>,
    speed: Option<f64>,
    /// M3, M4 and M5.
    turns: Option<bool>,
    spindle: Option<usize>,
    tolerance: Option<f64>,
    p: Option<f64>,
}

impl Reader<'_> {
    fn block(&mut self, number: usize, code: &str) -> Result<(), String> {
        let (mut block, before) = (Block::default(), self.at);
        for word in code.split_whitespace().filter(|w| *w != "%") {
            self.out.ends = false;
            self.word(number, word, &mut block)?;
        }
        // P is the spindle's number beside S, M3 and M5, else the tolerance of G64.
        let of_spindle = block.speed.is_some() || block.turns.is_some();
        match block.p {
            Some(p) if of_spindle && (p == 1.0 || p == 2.0) => block.spindle = Some(p as usize - 1),
            Some(p) if self.seen.iter().any(|w| w == "G64") && !of_spindle => block.tolerance = Some(p),
            Some(p) => return Err(format!("P{p}, which means nothing here")),
            None => {}
        }
        self.out.tolerance_mm = block.tolerance.or(self.out.tolerance_mm);
        if let (true, Some(spindle)) = (of_spindle && !self.began, self.spindle(&block)) {
            spindle.rpm = block.speed.unwrap_or(spindle.rpm);
            spindle.turns = block.turns.unwrap_or(spindle.turns);
        }
        match (block.waits, block.moves.is_empty()) {
            (true, _) => self.waited(number, &block),
            (false, true) => Ok(()),
            (false, false) => self.moved(number, &block, &before),
        }
    }

    fn spindle(&mut self, block: &Block) -> Option<&mut Spindle> {
        self.out.spindles.get_mut(block.spindle.unwrap_or(self.own))
    }

    /// The axes have new places.
    fn moved(&mut self, number: usize, block: &Block, before: &Axes) -> Result<(), String> {
        // Under G94 the last F counts on.
        self.feed = block.feed.or(self.feed.filter(|_| !self.inverse));
        let seconds = match (self.rapid, self.feed) {
            (true, _) => None,
            (false, Some(f)) if f > 0.0 && f.is_finite() => Some(self.seconds(f, before)),
            (false, _) => return Err("a line that cuts without F over 0".into()),
        };
        if !self.rapid && !self.began {
            self.began = true;
            self.out.unset = self.unset();
        }
        let line = Line { numbers: [number, 0], is_rapid: self.rapid, seconds, at: self.at };
        if let Some(part) = self.out.parts.last_mut() {
            part.push(line);
        }
        Ok(())
    }

    /// The axes stand for a time.
    fn waited(&mut self, number: usize, block: &Block) -> Result<(), String> {
        let seconds = block.feed.filter(|s| *s > 0.0 && s.is_finite() && block.moves.is_empty());
        if seconds.is_none() {
            return Err("G4 with F over 0 and nothing else waits".into());
        }
        let line = Line { numbers: [number, 0], is_rapid: false, seconds, at: self.at };
        if let Some(part) = self.out.parts.last_mut() {
            part.push(line);
        }
        Ok(())
    }

    /// The time of a line, s. A control passes one that goes nowhere at once.
    fn seconds(&self, f: f64, before: &Axes) -> f64 {
        let linear = self.machine.axes().iter().map(|a| !a.is_rotary());
        let ways = before.iter().zip(self.at.iter()).map(|(a, b)| if a == b { 0.0 } else { b - a });
        let ways: Vec<(bool, f64)> = linear.zip(ways).filter(|(_, w)| !w.is_nan()).collect();
        let way_mm = ways.iter().filter(|(linear, _)| *linear).map(|(_, w)| w * w).sum::<f64>().sqrt();
        match self.inverse {
            true if ways.iter().all(|(_, w)| *w == 0.0) => 0.0,
            true => 60.0 / f,
            false => 60.0 * way_mm / f,
        }
    }

    /// What a program of axis positions has to set, and this one has not.
    fn unset(&self) -> Vec<&'static str> {
        let needs: [(&'static str, &[&str]); 5] = [
            ("absolute positions (G90)", &["G90"]),
            ("no radius of the tool (G40)", &["G40"]),
            ("no length of the tool (G49 or D0)", &["G49", "D0"]),
            ("the work offset (G54 or G500)", &["G54", "G500"]),
            ("millimetres (G21 or G710)", &["G21", "G710"]),
        ];
        let seen = |any: &[&str]| any.iter().any(|w| self.seen.iter().any(|s| s == w));
        needs.into_iter().filter(|(_, any)| !seen(any)).map(|(what, _)| what).collect()
    }

    fn word(&mut self, number: usize, word: &str, block: &mut Block) -> Result<(), String> {
        if WORDS.contains(&word) {
            return Ok(());
        }
        // WAITMC brakes only where the other channel is late, and is passed by both together too.
        if let Some(inside) = inside(word, "WAITM").or_else(|| inside(word, "WAITMC")) {
            return self.mark(number, inside);
        }
        if inside(word, "SETMS").is_some_and(|n| n == "1" || n == "2") {
            return Ok(());
        }
        if let Some(inside) = inside(word, "FGROUP") {
            let known = |name: &str| self.machine.axes().iter().any(|a| a.name == name);
            return if inside.split(',').all(known) { Ok(()) } else { Err(format!("an axis of {word}")) };
        }
        let parted = match word.split_once('=') {
            Some((name, value)) => Some((name, value)),
            None => word.char_indices().nth(1).map(|(at, _)| word.split_at(at)),
        };
        let Some((name, value)) = parted else { return Err(format!("the word {word}")) };
        if let Some(k) = self.machine.axes().iter().position(|a| a.name == name && !a.is_missing) {
            return self.axis(number, k, value, block);
        }
        let value: f64 = value.parse().map_err(|_| format!("the word {word}"))?;
        self.set(name, value, block).ok_or_else(|| format!("the word {word}"))
    }

    /// A word that sets something; `None`: it is not known.
    fn set(&mut self, name: &str, value: f64, block: &mut Block) -> Option<()> {
        match name {
            "G" if value == 0.0 || value == 1.0 => self.rapid = value == 0.0,
            "G" if SET.contains(&value) => {
                if value == 93.0 || value == 94.0 {
                    (self.inverse, self.feed) = (value == 93.0, None);
                }
                self.seen.push(format!("G{value}"));
            }
            "G" if value == 4.0 => block.waits = true,
            "D" if value == 0.0 => self.seen.push("D0".into()),
            "M" | "M1" | "M2" if [3.0, 4.0, 5.0].contains(&value) => {
                block.turns = Some(value != 5.0);
                block.spindle = name[1..].parse::<usize>().ok().map(|n| n - 1).or(block.spindle);
            }
            "M" if value == 2.0 || value == 30.0 => self.out.ends = true,
            // Coolant, stops, a tool that is put in: none moves an axis.
            "M" if [0.0, 1.0, 6.0, 7.0, 8.0, 9.0].contains(&value) => {}
            "T" if value >= 0.0 => {}
            "S" => block.speed = Some(value),
            "S1" | "S2" => (block.speed, block.spindle) = (Some(value), name[1..].parse::<usize>().ok().map(|n| n - 1)),
            "$" if value == 0.0 || value == 1.0 => block.spindle = Some(value as usize),
            "CTOL" => block.tolerance = Some(value),
            "P" => block.p = Some(value),
            "F" => block.feed = Some(value),
            // Off or on of what G5.1 names.
            "Q" if value == 0.0 || value == 1.0 => {}
            "N" | "O" if value >= 0.0 => {}
            _ => return None,
        }
        Some(())
    }

    fn axis(&mut self, number: usize, k: usize, value: &str, block: &mut Block) -> Result<(), String> {
        let axis = &self.machine.axes()[k];
        let turns = inside(value, "DC").map(|v| (v, true));
        let (bare, within) = turns.or_else(|| inside(value, "AC").map(|v| (v, false))).unwrap_or((value, false));
        let at: f64 = bare.parse().map_err(|_| format!("{} without a number", axis.name))?;
        if !(at.abs() <= FARTHEST) || within && !(0.0..360.0).contains(&at) {
            return Err(format!("{} at {bare}, which is no position of it", axis.name));
        }
        let at = at / axis.word_per_mm();
        self.at[k] = if axis.is_rotary() { at.to_radians() } else { at };
        if self.out.named.iter().all(|(column, _)| *column != k) {
            self.out.named.push((k, number));
        }
        if block.moves.contains(&k) {
            return Err(format!("{} twice", axis.name));
        }
        block.moves.push(k);
        Ok(())
    }

    fn mark(&mut self, line: usize, inside: &str) -> Result<(), String> {
        let all: Option<Vec<u32>> = inside.split(',').map(|n| n.trim().parse().ok()).collect();
        let Some((mark, channels)) = all.as_deref().and_then(<[u32]>::split_first) else {
            return Err("a wait mark without numbers".into());
        };
        self.out.marks.push(Mark { line, mark: *mark, channels: channels.to_vec() });
        self.out.parts.push(Vec::new());
        Ok(())
    }
}

/// What stands in the brackets behind a name.
fn inside<'a>(word: &'a str, name: &str) -> Option<&'a str> {
    word.strip_prefix(name)?.strip_prefix('(')?.strip_suffix(')')
}
