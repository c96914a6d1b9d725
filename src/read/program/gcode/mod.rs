//! G code: ISO 6983 as LinuxCNC, Mach3, Fanuc and Siemens 840D speak it.
//!
//! A word either is acted on, is known to be harmless ([`codes`]), or is refused.

mod axes;
mod codes;
mod frames;
mod modal;
mod nurbs;
mod subprograms;
mod words;

use super::block::{Block, Call, RotaryWay, Script};
use super::unreadable;
use super::walk::Walk;
use crate::artifact::program::Turning;
use crate::error::Result;
use modal::{Centre, Modal, ModalMotion, Plane};
use nurbs::Curve;
use subprograms::{Jump, Subprograms};
pub(super) use words::code;
use words::{CodeWord, Constants};

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
    /// `G4`.
    Dwell,
    /// `G53.1`.
    Square,
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
    /// `G06.2` stands in the line.
    begins_curve: bool,
    /// `R`, `CR`.
    radius: Option<f64>,
    /// `RPL`.
    in_plane_deg: Option<f64>,
    /// `TURN`.
    turns: Option<u32>,
    abc3: [Option<f64>; 3],
    /// A line that sets a frame.
    frame: Option<frames::Setting>,
    swivel: Option<frames::Swivel>,
    /// `G28`, `G30`.
    home: bool,
    jump: Option<Jump>,
    /// A subprogram, by its name.
    call: Option<String>,
    /// `M98`.
    calls: bool,
    /// `L`, as it is written.
    repeats: Option<u32>,
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
    let lines: Vec<&str> = text.lines().collect();
    let subprograms = Subprograms::of(&lines);
    let mut reader = GcodeReader { modal: Modal { siemens: siemens(text), ..Modal::default() }, ..Default::default() };
    let mut walk = Walk::default();
    let last = lines.len().saturating_sub(1);
    let at_end = |e: String| unreadable(last + 1, lines.get(last).unwrap_or(&""), &e);
    while let Some(i) = walk.step(lines.len()).map_err(at_end)? {
        let line = lines[i];
        let mut run = |reader: &mut GcodeReader| {
            let jump = match subprograms.at(i)? {
                Some(jump) => Some(jump),
                None => reader.line(i + 1, line, &subprograms)?,
            };
            reader.jump(i + 1, jump, &mut walk)
        };
        run(&mut reader).map_err(|e| unreadable(i + 1, line, &e))?;
        if reader.script.end.is_some() {
            break;
        }
    }
    let behind = (reader.script.end.unwrap_or(lines.len())..lines.len()).filter(|i| {
        let says = || !words::code(lines[*i]).is_ok_and(|code| code.trim().is_empty());
        !lines[*i].trim_start().starts_with('%') && !subprograms.has_called(*i, &reader.called) && says()
    });
    reader.script.behind = behind.map(|i| i + 1).collect();
    if let Some(curve) = &reader.curve {
        return Err(at_end(curve.unfinished()));
    }
    Ok(reader.finished())
}

/// Whether a line has a word that only Siemens knows: a name of its own, or a letter with `=`.
fn siemens(text: &str) -> bool {
    let own = ["TRAORI", "TRAFOOF", "SUPA", "CYCLE", "TRANS", "ATRANS", "ROT", "AROT", "ORIWKS"];
    text.lines().any(|line| {
        let code = line.split([';', '(']).next().unwrap_or("");
        code.split_whitespace().any(|w| {
            let named = own.iter().any(|o| w.get(..o.len()).is_some_and(|w| w.eq_ignore_ascii_case(o)));
            named || w.contains('=') && w.starts_with(|c: char| c.is_ascii_alphabetic())
        }) || line.starts_with("%_N_")
    })
}

/// The constants that a line sets; such a line has nothing else.
fn set(words: &[CodeWord]) -> std::result::Result<Vec<(String, f64)>, String> {
    let sets = |w: &&CodeWord| Constants::name(w.address) && w.raw.contains('=');
    let set: Vec<&CodeWord> = words.iter().filter(sets).collect();
    let alone = words.iter().all(|w| sets(&w) || w.address == "N");
    let uses = set.iter().any(|w| set.iter().any(|other| w.value.contains(other.address)));
    if !set.is_empty() && (!alone || uses) {
        return Err("a line that sets constants (R, #) may have nothing else".into());
    }
    set.into_iter().map(|w| Ok((w.address.to_owned(), w.number()?))).collect()
}

#[derive(Default)]
struct GcodeReader {
    modal: Modal,
    script: Script,
    /// Tools that were selected and not changed to.
    selected: Vec<Call>,
    /// How many of them come before each block.
    selected_before: Vec<usize>,
    changes: bool,
    /// A tape sign has been read.
    tape: bool,
    constants: Constants,
    /// First lines of the subprograms that have been called, from 0.
    called: Vec<usize>,
    /// A curve that is not whole yet.
    curve: Option<Curve>,
}

impl GcodeReader {
    /// Reads a line; a call or the end of a subprogram where it has one.
    fn line(
        &mut self,
        number: usize,
        line: &str,
        subprograms: &Subprograms,
    ) -> std::result::Result<Option<Jump>, String> {
        if line.trim_start().starts_with('%') {
            // The first one, before anything else, begins the program.
            if self.tape || self.modal.begun {
                self.script.ends(number);
            }
            self.tape = true;
            return Ok(None);
        }
        let code = words::code(line)?;
        let upper = code.to_ascii_uppercase();
        let constants = std::mem::take(&mut self.constants);
        let words = words::words(&code, &upper, &constants, self.modal.siemens)?;
        let set = set(&words)?;
        let jump = if set.is_empty() { self.words(number, &words, subprograms)? } else { None };
        self.constants = constants;
        set.iter().for_each(|(name, value)| self.constants.set(name, *value));
        Ok(jump)
    }

    /// What the words of a line do.
    fn words(
        &mut self,
        number: usize,
        words: &[CodeWord],
        subprograms: &Subprograms,
    ) -> std::result::Result<Option<Jump>, String> {
        if let Some(word) = words.iter().find(|w| self.curve.is_some() && !nurbs::knows(w)) {
            return Err(format!("{} within a curve is not read", word.raw));
        }
        let mut said = LineWords::default();
        let centre = self.modal.centre;
        // Preparatory functions count for the whole line, wherever they stand.
        for word in words.iter().filter(|w| w.address == "G") {
            codes::preparatory(word, &mut self.modal, &mut said)?;
        }
        for word in words.iter().filter(|w| w.address != "G") {
            match axes::axis(word.address) {
                None if subprograms.has(word.address) && word.value.is_empty() => {
                    said.call = Some(word.address.to_owned());
                }
                Some(axis) => axes::to_axis(word, axis, &self.modal, &mut said)?,
                None => codes::take(word, &mut self.modal, &mut said)?,
            }
        }
        if self.modal.centre != centre {
            let to_table = matches!(self.modal.centre, Centre::Axes | Centre::Vectors);
            self.modal.fixed_by = to_table.then_some(number);
        }
        self.modal.begun |= words.iter().any(|w: &CodeWord| w.address != "N");
        if let Some(call) = said.subprogram(self.modal.siemens)? {
            said.jump = Some(match call {
                Called::Name(name) => subprograms.by_name(&name, said.p.map_or(1, |p| p as u32))?,
                Called::Number(number) => subprograms.by_number(number, said.repeats)?,
            });
            said.p = None;
        }
        self.finish(number, said)
    }

    /// Goes to where a line calls.
    fn jump(&mut self, line: usize, jump: Option<Jump>, walk: &mut Walk) -> std::result::Result<(), String> {
        match jump {
            None => {}
            Some(Jump::Skip(line)) => walk.skip_to(line),
            Some(Jump::Call { first, times }) => {
                self.called.push(first);
                walk.call(first, times)?;
            }
            Some(Jump::Done { ends_main }) => match (walk.done(), ends_main) {
                (true, _) => {}
                (false, true) => self.script.ends(line),
                (false, false) => return Err("the end of a subprogram that nothing has called".into()),
            },
        }
        Ok(())
    }

    /// What the words of a line do together.
    fn finish(&mut self, number: usize, mut said: LineWords) -> std::result::Result<Option<Jump>, String> {
        if said.bare == Some(Bare::Dwell) {
            // Its time, in the words that controls take for it.
            (said.point[0], said.p, said.feed) = (None, None, said.feed.filter(|_| !self.modal.siemens));
            if said.feed.is_some() || said.moves() {
                return Err("a dwell with words that are not read with it".into());
            }
        }
        if let Some(setting) = said.frame {
            if said.acts() {
                return Err("a line that sets a frame does nothing else".into());
            }
            frames::set(setting, &said, &mut self.modal)?;
            return Ok(None);
        }
        said.functions(&mut self.modal)?;
        self.tool(number, &mut said);
        let setting = &mut self.modal.setting;
        setting.turning = said.turning.unwrap_or(setting.turning);
        setting.rpm = said.rpm.or(setting.rpm);
        let (ends, jump, home) = (said.ends, said.jump, said.home);
        if jump.is_some() && (said.moves() || said.change) {
            return Err("a call of a subprogram with words of a move".into());
        }
        if let Some(swivel) = said.swivel.take() {
            if said.moves() {
                return Err("CYCLE800 with words of a move".into());
            }
            self.swivels(number, &swivel);
        } else if said.bare == Some(Bare::Square) {
            if !self.modal.frames.has_plane() {
                return Err("G53.1 without a tilted plane (G68.2)".into());
            }
            self.push(self.modal.square(number));
        } else {
            let gone = home.then(|| self.modal.gone(number, &said));
            let motion = if home { Some(ModalMotion::Rapid) } else { self.modal.motion };
            if motion == Some(ModalMotion::Curve) {
                self.curve(number, &said)?;
            } else if let Some(curve) = &self.curve {
                return Err(curve.unfinished());
            } else if !home || said.goes(self.modal.steps) {
                let block = self.modal.block(number, motion, said)?;
                block.into_iter().for_each(|b| self.push(b));
            }
            gone.into_iter().for_each(|b| self.push(b));
        }
        if ends && jump.is_none() {
            self.script.ends(number);
        }
        Ok(jump)
    }

    /// A line under `G06.2`.
    fn curve(&mut self, number: usize, said: &LineWords) -> std::result::Result<(), String> {
        if said.begins_curve {
            if let Some(curve) = &self.curve {
                return Err(curve.unfinished());
            }
            self.modal.curve(said)?;
            self.curve = Some(Curve::begun(number, said)?);
            return Ok(());
        }
        let Some(mut curve) = self.curve.take() else {
            let says = said.moves() || said.feed.is_some();
            return if says {
                Err("a line behind the end of its curve: G06.2 begins another, G1 a straight move".into())
            } else {
                Ok(())
            };
        };
        if !said.moves() {
            self.curve = Some(curve);
            return Ok(());
        }
        if said.ways.as_flattened().iter().any(Option::is_some) {
            return Err("steps within a curve are not read".into());
        }
        if !curve.take(number, said)? {
            self.curve = Some(curve);
            return Ok(());
        }
        for piece in curve.pieces() {
            let block = self.modal.piece(piece)?;
            self.push(block);
        }
        Ok(())
    }

    /// `CYCLE800`: where the linear axes go is the machine's.
    fn swivels(&mut self, number: usize, swivel: &frames::Swivel) {
        if swivel.goes_away {
            self.push(self.modal.unknown(number, [true; 3], [false; 3]));
        }
        if swivel.turns {
            self.push(self.modal.square(number));
        }
    }

    fn push(&mut self, block: Block) {
        self.selected_before.push(self.selected.len());
        self.script.blocks.push(Block { tool_calls: self.script.calls.len(), ..block });
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
            for (block, calls) in self.script.blocks.iter_mut().zip(self.selected_before) {
                block.tool_calls = calls;
            }
        }
        self.script
    }
}

/// A subprogram that a line calls.
enum Called {
    Name(String),
    Number(u32),
}

impl LineWords {
    /// The subprogram that the line calls, if any.
    fn subprogram(&mut self, siemens: bool) -> std::result::Result<Option<Called>, String> {
        let whole = self.p.is_none_or(|p| p.fract() == 0.0 && (0.0..1e9).contains(&p));
        match (self.calls, self.p, self.call.take(), self.repeats) {
            (true, Some(p), None, _) if whole => Ok(Some(Called::Number(p as u32))),
            (true, ..) => Err("M98 is read with the number of a subprogram, P".into()),
            (false, _, Some(name), None) if whole => Ok(Some(Called::Name(name))),
            (false, _, None, Some(number)) if siemens && whole => Ok(Some(Called::Name(format!("L{number}")))),
            (false, _, None, None) => Ok(None),
            _ => Err("words that are not known with a call".into()),
        }
    }

    /// Whether a word leads away from where the tool is.
    fn goes(&self, steps: bool) -> bool {
        let words = [self.point, self.rotary].into_iter().flatten().zip(self.ways.into_iter().flatten());
        let usual = if steps { RotaryWay::By } else { RotaryWay::To };
        words
            .filter_map(|(word, way)| Some((word?, way.unwrap_or(usual))))
            .any(|(w, way)| way != RotaryWay::By || w != 0.0)
    }

    /// Functions that have words of their own.
    fn functions(&self, modal: &mut Modal) -> std::result::Result<(), String> {
        let moves = self.moves();
        let (p, q) = (self.p, self.q);
        let good = match self.bare {
            None => {
                let has_rank = self.begins_curve || matches!(modal.motion, Some(ModalMotion::Arc { .. })) && moves;
                p.is_none() || self.blends || has_rank
            }
            Some(Bare::Call | Bare::Unscaled | Bare::Dwell | Bare::Square) => p.is_none(),
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

    /// Whether it has functions beside its words of places.
    fn acts(&self) -> bool {
        let tool = self.tool.is_some() || self.change || self.edge.is_some();
        let spindle = self.rpm.is_some() || self.turning.is_some();
        let order = self.jump.is_some() || self.ends || self.repeats.is_some();
        let place = self.machine || self.home || self.swivel.is_some() || self.turns.is_some();
        tool || spindle || order || place || self.blends || self.bare.is_some()
    }

    fn moves(&self) -> bool {
        let words = [&self.point, &self.rotary, &self.ijk, &self.abc3];
        words.into_iter().flatten().any(Option::is_some) || self.radius.is_some()
    }
}
