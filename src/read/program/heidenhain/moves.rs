//! Blocks of Klartext that move: `L`, `LN`, `C` about the pole of `CC`, `CR`.

use super::{HeidenhainReader, Read};
use crate::read::program::block::{Arc, Block, Centre, Destination, Feed, Interpolation, RotaryWay};

/// Words of a block: components of the tool axis and of the surface's normal, the point, rotary
/// axes.
const WORDS: [&str; 12] = ["TX", "TY", "TZ", "NX", "NY", "NZ", "X", "Y", "Z", "A", "B", "C"];

/// What a block says.
#[derive(Default)]
struct Said {
    /// By [`WORDS`], in threes.
    values: [[Option<f64>; 3]; 4],
    /// Of them, those that are steps.
    steps: [[bool; 3]; 4],
    machine: bool,
    rapid: bool,
    ends: bool,
    radius: Option<f64>,
    /// `DR-`.
    clockwise: Option<bool>,
}

impl HeidenhainReader {
    /// One block.
    pub(super) fn moves(&mut self, line: usize, kind: &str, words: &[&str]) -> Read<()> {
        let said = self.said(kind, words)?;
        let [axis, normal, point, rotary] = said.values;
        let is_vector = kind == "LN" || axis.iter().any(Option::is_some);
        let place = match axis {
            [None, None, None] if !is_vector => Destination::Words { point, rotary },
            [Some(x), Some(y), Some(z)] => Destination::Vector { point, axis: [x, y, z] },
            _ => return Err("an LN block needs TX, TY and TZ".into()),
        };
        if is_vector && rotary.iter().any(Option::is_some) {
            return Err("a vector and words of rotary axes in one block".into());
        }
        let course = self.course(kind, &said)?;
        let moves = said.values.iter().flatten().any(Option::is_some);
        if normal.iter().any(Option::is_some) && !is_vector {
            return Err("a surface's normal without a tool axis".into());
        }
        if moves {
            let feed = match (said.rapid, self.modal.feed) {
                (true, _) => Feed::Rapid,
                (false, Some(f)) if f > 0.0 => Feed::PerMinute(f),
                _ => return Err("a move before any F".into()),
            };
            let modal = &self.modal;
            let usual = if modal.shorter { RotaryWay::Shorter } else { RotaryWay::To };
            self.push(Block {
                course,
                steps: said.steps[2],
                ways: said.steps[3].map(|step| if step { RotaryWay::By } else { usual }),
                great_circle: modal.great_circle && modal.centre_point,
                frame: modal.frames.all(),
                in_plane: modal.frames.has_plane() && !modal.centre_point,
                machine: said.machine,
                tool_length: modal.has_tool && !said.machine && !modal.centre_point,
                centre_point: modal.centre_point,
                ..Block::straight(line, place, feed)
            });
        }
        if said.ends {
            self.script.ends(line);
        }
        Ok(())
    }

    fn said(&mut self, kind: &str, words: &[&str]) -> Read<Said> {
        let mut said = Said::default();
        let mut words = words.iter().peekable();
        while let Some(word) = words.next() {
            let (step, name) = word.strip_prefix('I').map_or((false, *word), |name| (true, name));
            if let Some((at, axis)) = WORDS.iter().enumerate().find(|(_, axis)| name.starts_with(**axis)) {
                let value = self.value(name, axis)?;
                if said.values[at / 3][at % 3].replace(value).is_some() {
                    return Err(format!("\"{word}\" is a second word of its axis"));
                }
                if step && at < 6 {
                    return Err(format!("\"{word}\" is a step of a vector"));
                }
                said.steps[at / 3][at % 3] = step;
                continue;
            }
            match *word {
                "R0" => {}
                "RL" | "RR" | "R+" | "R-" => return Err("compensation of the cutter's radius is not read".into()),
                "DR+" => said.clockwise = Some(false),
                "DR-" => said.clockwise = Some(true),
                "FMAX" => said.rapid = true,
                "M91" => said.machine = true,
                "M128" => {
                    said.ends |= self.function(word)?;
                    // The feed of the movements that follow a turn, which the machine makes beside.
                    if let Some(feed) = words.next_if(|w| w.starts_with('F')) {
                        self.value(feed, "F")?;
                    }
                }
                radius if kind == "CR" && radius.starts_with('R') => said.radius = Some(self.value(radius, "R")?),
                _ if word.starts_with('F') => self.modal.feed = Some(self.value(word, "F")?),
                _ => said.ends |= self.function(word)?,
            }
        }
        if said.machine && said.steps[2].contains(&true) {
            return Err("steps in positions of the axes are not read".into());
        }
        Ok(said)
    }

    /// How the block goes: arcs are in the plane across the tool axis Z.
    fn course(&self, kind: &str, said: &Said) -> Read<Interpolation> {
        let is_arc = kind == "C" || kind == "CR";
        if !is_arc {
            let plain = said.radius.is_none() && said.clockwise.is_none();
            return if plain { Ok(Interpolation::Straight) } else { Err("words of an arc in a straight block".into()) };
        }
        if said.machine || said.rapid || said.values[0].iter().chain(&said.values[1]).any(Option::is_some) {
            return Err("an arc with M91, FMAX or a vector is not read".into());
        }
        let centre = match (kind, said.radius, self.modal.pole) {
            ("CR", Some(r), _) => Centre::Radius(r),
            ("CR", None, _) => return Err("CR without its radius".into()),
            (_, _, [Some(x), Some(y)]) => Centre::At([x, y, 0.0]),
            _ => return Err("C before its centre (CC) is said".into()),
        };
        let clockwise = said.clockwise.ok_or("an arc without DR+ or DR-")?;
        Ok(Interpolation::Arc(Arc { centre, axis: [0.0, 0.0, if clockwise { -1.0 } else { 1.0 }], turns: 0 }))
    }

    /// `CC X+10 Y+20`.
    pub(super) fn pole(&mut self, words: &[&str]) -> Read<()> {
        let mut pole = [None; 2];
        for word in words {
            let axis = ["X", "Y"].iter().position(|a| word.starts_with(a));
            let axis = axis.ok_or("CC is read with X and Y, as places")?;
            pole[axis] = Some(self.value(word, &word[..1])?);
        }
        if pole.contains(&None) {
            return Err("CC is read with X and Y, as places".into());
        }
        self.modal.pole = pole;
        Ok(())
    }
}
