//! G code: ISO 6983 as LinuxCNC, Fanuc and Siemens 840D speak it.
//!
//! A word either is acted on, is known to be harmless ([`codes`]), or is refused.

mod axes;
mod codes;
mod words;

use super::block::{Block, Call, Destination, Feed, RotaryWay, Script};
use super::unreadable;
use crate::artifact::program::{LengthOffset, Setting, Turning};
use crate::error::Result;
use words::Word;

/// How a line goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Motion {
    Rapid,
    Straight,
    Polynomial,
}

/// Tool-centre-point control.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum Centre {
    #[default]
    Off,
    /// `G43.4`.
    Axes,
    /// `G43.5`.
    Vectors,
    /// `TRAORI`.
    Transformation,
}

/// A function that must have its line for itself, with the words that it may have.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bare {
    /// `CYCLE832(…)`.
    Call,
    /// `G5 P10000`, `G5 P0`.
    Precision,
    /// `G5.1 Q1`, `G5.1 Q0`.
    Contour,
    /// `G8 P1`, `G8 P0`.
    Ahead,
    /// `G50`.
    Unscaled,
}

/// State that stays from line to line.
#[derive(Default)]
struct Modal {
    /// The text has words that only Siemens knows: `D` is the length of the tool then.
    siemens: bool,
    /// Something has been said: no program may begin any more.
    begun: bool,
    motion: Option<Motion>,
    inverse: bool,
    steps: bool,
    inch: bool,
    inch_feed: bool,
    centre: Centre,
    /// The line that switched on `G43.4` or `G43.5`.
    fixed_by: Option<usize>,
    /// `G43`.
    length: bool,
    /// `H`.
    number: Option<u32>,
    /// `D`.
    edge: Option<u32>,
    /// `ORIMKS`.
    machine_vectors: bool,
    /// `UPATH`.
    with_path: bool,
    feed: Option<f64>,
    setting: Setting,
    frame: Option<u32>,
    /// X, Y or Z have been moved in the program's coordinates.
    placed: bool,
    /// The tool that the next change brings.
    selected: Option<String>,
}

/// What a line says.
#[derive(Default)]
struct LineWords {
    point: [Option<f64>; 3],
    rotary: [Option<f64>; 3],
    /// Of X, Y, Z and of A, B, C; `None`: as G90 or G91 says.
    ways: [[Option<RotaryWay>; 3]; 2],
    /// Coefficients of `p²` and on, of X, Y, Z and of A, B, C.
    bend: [[[f64; 4]; 3]; 2],
    /// Length of the interval of `p`.
    interval: Option<f64>,
    ijk: [Option<f64>; 3],
    abc3: [Option<f64>; 3],
    feed: Option<f64>,
    machine: bool,
    /// In positions of the axes all the same with the length of the tool: `SUPA`.
    with_length: bool,
    rpm: Option<f64>,
    turning: Option<Turning>,
    tool: Option<String>,
    change: bool,
    edge: Option<u32>,
    p: Option<f64>,
    q: Option<f64>,
    blends: bool,
    bare: Option<Bare>,
    ends: bool,
}

/// Reads a program.
///
/// # Errors
/// A word that is not understood, with the line.
pub(super) fn read(text: &str) -> Result<Script> {
    let mut reader = GcodeReader::default();
    reader.modal.siemens = siemens(text);
    for (i, line) in text.lines().enumerate() {
        reader.line(i + 1, line).map_err(|e| unreadable(i + 1, line, &e))?;
    }
    Ok(reader.finished())
}

/// Whether a line has a word that only Siemens knows.
fn siemens(text: &str) -> bool {
    let own = ["TRAORI", "TRAFOOF", "SUPA", "CYCLE832"];
    text.lines().any(|line| {
        let code = line.split([';', '(']).next().unwrap_or("");
        code.split_whitespace().any(|w| own.iter().any(|o| w.get(..o.len()).is_some_and(|w| w.eq_ignore_ascii_case(o))))
    })
}

#[derive(Default)]
struct GcodeReader {
    modal: Modal,
    script: Script,
    /// Tools that were selected and not changed to.
    selected: Vec<Call>,
    changes: bool,
    /// A tape sign has been read.
    tape: bool,
}

impl GcodeReader {
    fn line(&mut self, number: usize, line: &str) -> std::result::Result<(), String> {
        if line.trim_start().starts_with('%') {
            // The first one, before anything else, begins the program.
            if self.tape || self.modal.begun {
                self.script.ends(number);
            }
            self.tape = true;
            return Ok(());
        }
        if self.script.end.is_some() {
            if !words::code(line).is_ok_and(|code| code.trim().is_empty()) {
                self.script.behind.push(number);
            }
            return Ok(());
        }
        let code = words::code(line)?;
        let upper = code.to_ascii_uppercase();
        let words = words::words(&code, &upper)?;
        let mut said = LineWords::default();
        let centre = self.modal.centre;
        // Preparatory functions count for the whole line, wherever they stand.
        for word in words.iter().filter(|w| w.address == "G") {
            codes::preparatory(word, &mut self.modal, &mut said)?;
        }
        for word in words.iter().filter(|w| w.address != "G") {
            match axes::axis(word.address) {
                Some(axis) => axes::to_axis(word, axis, &self.modal, &mut said)?,
                None => codes::take(word, &mut self.modal, &mut said)?,
            }
        }
        if self.modal.centre != centre {
            let to_table = matches!(self.modal.centre, Centre::Axes | Centre::Vectors);
            self.modal.fixed_by = to_table.then_some(number);
        }
        self.modal.begun |= words.iter().any(|w: &Word| w.address != "N");
        self.finish(number, said)
    }

    /// What the words of a line do together.
    fn finish(&mut self, number: usize, mut said: LineWords) -> std::result::Result<(), String> {
        said.functions(&mut self.modal)?;
        self.tool(number, &mut said);
        let setting = &mut self.modal.setting;
        setting.turning = said.turning.unwrap_or(setting.turning);
        setting.rpm = said.rpm.or(setting.rpm);
        let ends = said.ends;
        let block = self.modal.block(number, said)?;
        self.script.blocks.extend(block.map(|b| Block { tool_calls: self.script.calls.len(), ..b }));
        if ends {
            self.script.ends(number);
        }
        Ok(())
    }

    /// Tools that are selected, and changes.
    fn tool(&mut self, line: usize, said: &mut LineWords) {
        if let Some(tool) = said.tool.take() {
            self.selected.push(Call { line, tool: Some(tool.clone()) });
            self.modal.selected = Some(tool);
        }
        if said.change {
            self.changes = true;
            self.script.calls.push(Call { line, tool: self.modal.selected.clone() });
            // A change stops the spindle, and takes the first edge.
            self.modal.setting.turning = Turning::Off;
            self.modal.edge = None;
        }
        self.modal.edge = said.edge.or(self.modal.edge);
    }

    /// The program; where it never says M6, tools are changed where they are selected.
    fn finished(mut self) -> Script {
        self.script.frame = self.modal.frame;
        if !self.changes {
            self.script.calls = self.selected;
            for block in &mut self.script.blocks {
                block.tool_calls = self.script.calls.iter().take_while(|c| c.line <= block.line).count();
            }
        }
        self.script
    }
}

impl LineWords {
    /// Functions that have words of their own.
    fn functions(&self, modal: &mut Modal) -> std::result::Result<(), String> {
        let moves = self.moves();
        let (p, q) = (self.p, self.q);
        let good = match self.bare {
            None => p.is_none() || self.blends,
            Some(Bare::Call | Bare::Unscaled) => p.is_none(),
            Some(Bare::Precision) => p == Some(10_000.0) || p == Some(0.0),
            Some(Bare::Ahead) => p == Some(1.0) || p == Some(0.0),
            Some(Bare::Contour) => p.is_none() && (q == Some(1.0) || q == Some(0.0)),
        };
        if !good || self.bare.is_some() && moves || q.is_some() && self.bare != Some(Bare::Contour) {
            return Err("a function with words that are not known".into());
        }
        if self.blends && !modal.siemens {
            modal.setting.tolerance_mm = p.map(|p| if modal.inch { 25.4 * p } else { p });
        }
        Ok(())
    }

    fn moves(&self) -> bool {
        let words = [&self.point, &self.rotary, &self.ijk, &self.abc3];
        words.into_iter().flatten().any(Option::is_some)
    }
}

impl Modal {
    /// The move that a line asks for, if any.
    fn block(&mut self, line: usize, said: LineWords) -> std::result::Result<Option<Block>, String> {
        if let Some(f) = said.feed {
            self.feed = Some(if self.inch_feed && !self.inverse { 25.4 * f } else { f });
        }
        if !said.moves() {
            return Ok(None);
        }
        let motion = self.motion.ok_or("a move before G0 or G1")?;
        let feed = self.feed(motion, said.feed)?;
        let place = self.place(motion, &said)?;
        let bend = if motion == Motion::Polynomial { Some(axes::bend(&said, self.with_path)?) } else { None };
        let usual = if self.steps { RotaryWay::By } else { RotaryWay::To };
        let [point_ways, ways] = said.ways.map(|of| of.map(|way| way.unwrap_or(usual)));
        let steps = point_ways.map(|way| way == RotaryWay::By);
        if said.machine && said.point.iter().zip(steps).any(|(word, step)| word.is_some() && step) {
            return Err("steps in positions of the axes are not read".into());
        }
        self.placed |= !said.machine && said.point.iter().any(Option::is_some);
        let (centre_point, length) = (self.centre != Centre::Off, self.offset()?);
        // Under tool-centre-point control the length is in the transformation.
        let added = matches!(length, LengthOffset::Number(_) | LengthOffset::Edge(_)) && !centre_point;
        Ok(Some(Block {
            place,
            steps,
            ways,
            bend,
            machine: said.machine,
            tool_length: added && (!said.machine || said.with_length),
            centre_point,
            fixed_by: self.fixed_by,
            setting: Setting { length, ..self.setting },
            ..Block::straight(line, place, feed)
        }))
    }

    fn feed(&self, motion: Motion, said: Option<f64>) -> std::result::Result<Feed, String> {
        let feed = match (motion, self.inverse, said, self.feed) {
            (Motion::Rapid, ..) => Feed::Rapid,
            (_, true, Some(f), _) => Feed::PerMove(f),
            (_, true, None, _) => return Err("under G93 every line needs its own F".into()),
            (_, false, _, Some(f)) => Feed::PerMinute(f),
            (_, false, _, None) => return Err("a feed move before any F".into()),
        };
        match feed {
            Feed::PerMove(f) | Feed::PerMinute(f) if f <= 0.0 => Err("F must be greater than 0".into()),
            _ => Ok(feed),
        }
    }

    fn place(&self, motion: Motion, said: &LineWords) -> std::result::Result<Destination, String> {
        let [ijk, abc3] = [said.ijk, said.abc3].map(|v| v.iter().any(Option::is_some));
        if !ijk && !abc3 {
            return Ok(Destination::Words { point: said.point, rotary: said.rotary });
        }
        if motion == Motion::Polynomial {
            return Err("vectors under POLY are not read".into());
        }
        if ijk && (abc3 || self.centre != Centre::Vectors) {
            return Err("I, J and K are read as the tool axis under G43.5 only".into());
        }
        if abc3 && self.centre != Centre::Transformation {
            return Err("A3, B3 and C3 are read under TRAORI only".into());
        }
        if abc3 && self.machine_vectors {
            return Err("a tool axis in the machine's frame (ORIMKS) is not read".into());
        }
        if said.rotary.iter().any(Option::is_some) {
            return Err("a vector and words of rotary axes in one line".into());
        }
        // A component that is left out is 0.
        let axis = if ijk { said.ijk } else { said.abc3 }.map(|v| v.unwrap_or(0.0));
        Ok(Destination::Vector { point: said.point, axis })
    }

    /// Where the length of the tool comes from.
    fn offset(&self) -> std::result::Result<LengthOffset, String> {
        let by_number = self.length || matches!(self.centre, Centre::Axes | Centre::Vectors);
        Ok(match (by_number, self.number, self.edge) {
            (true, Some(0), _) => LengthOffset::Off,
            (true, Some(n), _) => LengthOffset::Number(n),
            (true, None, _) => return Err("a length offset (G43) without its H".into()),
            (false, _, Some(0)) if self.siemens => LengthOffset::Off,
            (false, _, Some(n)) if self.siemens => LengthOffset::Edge(n),
            (false, ..) => LengthOffset::Unsaid,
        })
    }
}
