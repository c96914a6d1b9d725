//! The machine moved through a program's blocks.

use super::block::{Block, Feed, Place};
use super::unreadable;
use crate::artifact::program::{Language, Programmed};
use crate::error::Result;
use crate::geometry::{Point, Vector};
use crate::machine::{Machine, Pose};
use crate::tool::{self, Tool};

/// Where the machine stands, in the program's own words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// The programmed point, mm.
    pub(super) point: [f64; 3],
    /// Positions of A and B, rad; A as the axis goes, over all turns.
    pub(super) rotary: [f64; 2],
}

/// One move.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Line of the text.
    pub line: usize,
    /// Before it.
    pub from: Stand,
    /// After it.
    pub to: Stand,
    /// Time it takes, s; `None`: rapid.
    pub seconds: Option<f64>,
}

impl Moved {
    /// The tool at the share `f` of the move: every word moves evenly.
    pub fn pose(&self, f: f64, language: Language, tool: &Tool, machine: &Machine) -> Pose {
        let mix = |a: f64, b: f64| a + (b - a) * f;
        let [x, y, z] = [0, 1, 2].map(|i| mix(self.from.point[i], self.to.point[i]));
        let [a, b] = [0, 1].map(|i| mix(self.from.rotary[i], self.to.rotary[i]));
        if language.programmed == Programmed::Machine {
            return machine.forward(&[x, y, z, a, b], tool.length_mm());
        }
        let axis = tool::axis(b, machine.theta_of_a(a));
        let lift = if language.programmed == Programmed::Tip { tool.radius_mm } else { 0.0 };
        Pose { centre: Point::new(x, y, z) + axis * lift, axis }
    }
}

/// Follows the moves. The first one has no place to come from: it begins where it ends.
///
/// # Errors
/// A line whose vector is none, or lies along the rotary axis, or that moves in the blade frame before tool-centre-point control is on.
pub fn follow(blocks: &[Block], language: Language, machine: &Machine) -> Result<Vec<Moved>> {
    let mut out: Vec<Moved> = Vec::with_capacity(blocks.len());
    let mut now: Option<Stand> = None;
    for block in blocks {
        let at = now.unwrap_or(Stand { point: [0.0; 3], rotary: [0.0; 2] });
        let (point, rotary) = match block.place {
            Place::Words { point, rotary } => (point, words(block, at.rotary, rotary, language)),
            Place::Vector { point, axis } => {
                let near = machine.rotary_of_axis(&Vector::from(axis), at.rotary[0]);
                let reached =
                    near.ok_or_else(|| unreadable(block.line, "the tool axis is along the rotary axis, or none"))?;
                (point, reached)
            }
        };
        let own = language.programmed == Programmed::Machine;
        let machine_words = block.machine || own;
        if !machine_words && !block.centre_point && point.iter().any(Option::is_some) {
            return Err(unreadable(block.line, "a move in the blade frame while tool-centre-point control is off"));
        }
        let mut to = Stand { point: at.point, rotary };
        // Positions of the machine's axes say nothing about the programmed point of the blade frame, and are only passed by.
        if !block.machine || own {
            for (p, w) in to.point.iter_mut().zip(point) {
                *p = w.unwrap_or(*p);
            }
        }
        let from = if now.is_some() { at } else { to };
        let mut moved = Moved { line: block.line, from, to, seconds: None };
        moved.seconds = seconds(block.feed, &moved);
        out.push(moved);
        now = Some(to);
    }
    Ok(out)
}

/// Rotary positions after a line, rad.
fn words(block: &Block, at: [f64; 2], words: [Option<f64>; 2], language: Language) -> [f64; 2] {
    let mut to = at;
    for i in 0..2 {
        let Some(word) = words[i].map(f64::to_radians) else { continue };
        to[i] = match (block.steps[i], language.shortest_way && i == 0) {
            (true, _) => at[i] + word,
            (false, true) => {
                let turn = std::f64::consts::TAU;
                word + turn * ((at[i] - word) / turn).round()
            }
            (false, false) => word,
        };
    }
    to
}

/// How long a move takes, s; `None` for a rapid.
fn seconds(feed: Feed, moved: &Moved) -> Option<f64> {
    match feed {
        Feed::Rapid => None,
        Feed::PerMove(f) => Some(60.0 / f),
        Feed::PerMinute(f) => {
            let way = (0..3).map(|i| (moved.to.point[i] - moved.from.point[i]).powi(2)).sum::<f64>().sqrt();
            let turn = (moved.to.rotary[0] - moved.from.rotary[0]).abs().to_degrees();
            Some(60.0 * if way > 0.0 { way } else { turn } / f)
        }
    }
}
