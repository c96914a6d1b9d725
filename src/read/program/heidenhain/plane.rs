//! Frames of Klartext: datum shifts (cycle 7, `TRANS DATUM`), and on top of them a tilted plane
//! (`PLANE SPATIAL`).

use super::{Block, Destination, Feed, HeidenhainReader, Read};
use crate::geometry::{Rigid, Vector};

/// The frames that are set.
#[derive(Clone, Copy, Default)]
pub(super) struct Frames {
    shift: [f64; 3],
    plane: Option<Rigid>,
}

impl Frames {
    /// Coordinates of a block to those of the preset.
    pub fn all(&self) -> Rigid {
        let [x, y, z] = self.shift;
        Rigid::translation(x, y, z) * self.plane.unwrap_or_default()
    }

    /// Whether a plane is tilted.
    pub fn has_plane(&self) -> bool {
        self.plane.is_some()
    }
}

impl HeidenhainReader {
    /// `X+10`, `IY-5`; `AXIS X+10`, `RESET`. What is not said stays.
    pub(super) fn datum(&mut self, words: &[&str]) -> Read<()> {
        if self.modal.frames.has_plane() {
            return Err("a datum shift in a tilted plane is not read".into());
        }
        // A pole is said in the frame that was.
        self.modal.pole = [None; 2];
        if words == ["RESET"] {
            self.modal.frames.shift = [0.0; 3];
            return Ok(());
        }
        let words = words.strip_prefix(&["AXIS"]).unwrap_or(words);
        if words.is_empty() {
            return Err("a datum shift without axes".into());
        }
        for word in words {
            let (step, name) = word.strip_prefix('I').map_or((false, *word), |name| (true, name));
            let axis = ["X", "Y", "Z"].iter().position(|a| name.starts_with(a));
            let axis = axis.ok_or_else(|| format!("\"{word}\" is not read in a datum shift"))?;
            let value = self.value(name, &name[..1])?;
            let to = &mut self.modal.frames.shift[axis];
            *to = if step { *to + value } else { value };
        }
        Ok(())
    }

    /// `SPATIAL SPA+0 SPB+45 SPC+0 TURN FMAX`, `RESET STAY`.
    pub(super) fn plane(&mut self, line: usize, words: &[&str]) -> Read<()> {
        self.modal.pole = [None; 2];
        let rest = match words {
            ["RESET", rest @ ..] => {
                self.modal.frames.plane = None;
                rest
            }
            ["SPATIAL", a, b, c, rest @ ..] => {
                let [a, b, c] = [self.value(a, "SPA")?, self.value(b, "SPB")?, self.value(c, "SPC")?];
                // About the axes of the preset: first A, then B, then C.
                let about = |axis: Vector, degrees: f64| Rigid::rotation(axis * degrees.to_radians());
                let turned = about(Vector::z(), c) * about(Vector::y(), b) * about(Vector::x(), a);
                self.modal.frames.plane = Some(turned);
                rest
            }
            [kind, ..] => return Err(format!("PLANE is read as SPATIAL with SPA, SPB, SPC and as RESET, not {kind}")),
            [] => return Err("PLANE without its kind".into()),
        };
        let goes = match rest.first() {
            Some(goes @ (&"STAY" | &"TURN" | &"MOVE")) => *goes,
            _ => return Err("PLANE without STAY, TURN or MOVE".into()),
        };
        // The linear axes hold the tip where it is, or retract to where the machine says.
        let mut away = goes == "MOVE";
        let mut words = rest[1..].iter();
        while let Some(word) = words.next() {
            match *word {
                "FMAX" | "SEQ+" | "SEQ-" | "SYM+" | "SYM-" => {}
                "TABLE" | "COORD" if words.next() == Some(&"ROT") => {}
                "MB" => {
                    away = true;
                    words.next();
                }
                plain if plain.starts_with("MB") => away = true,
                plain if plain.starts_with("DIST") => {
                    self.value(plain, "DIST")?;
                }
                plain if plain.starts_with('F') => {
                    self.value(plain, "F")?;
                }
                _ => return Err(format!("\"{word}\" is not read with PLANE")),
            }
        }
        if away {
            let nowhere = Destination::Words { point: [Some(f64::NAN); 3], rotary: [None; 3] };
            self.push(Block { machine: true, ..Block::straight(line, nowhere, Feed::Rapid) });
        }
        if goes != "STAY" {
            let square = Destination::Vector { point: [None; 3], axis: [0.0, 0.0, 1.0] };
            let frame = self.modal.frames.all();
            let block = Block::straight(line, square, Feed::Rapid);
            self.push(Block { centre_point: false, in_plane: true, frame, ..block });
        }
        Ok(())
    }

    /// Puts a block to those of the program.
    pub(super) fn push(&mut self, block: Block) {
        let (tool_calls, setting) = (self.script.calls.len(), self.modal.setting);
        self.script.blocks.push(Block { tool_calls, setting, ..block });
    }
}
