//! What the machine does over one move.

use crate::artifact::Axes;
use crate::artifact::program::Programmed;
use crate::geometry::{Point, Rigid};
use crate::machine::{Machine, Pose};
use crate::tool::Tool;

/// Chords that the length of a bent move is taken from.
const CHORDS: usize = 64;

/// One move.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Line of the text.
    pub line: usize,
    /// Place of its block among those that were followed: an arc takes several moves, and so does a
    /// line along which the tool axis turns in a plane.
    pub block: usize,
    /// What the columns of X, Y, Z in `from` and `to` are.
    pub words: Programmed,
    /// Before it, in the order of [`Machine::axes`]: rotary axes, rad, over all turns; in place of
    /// X, Y, Z tip or ball centre in the blade frame where `words` say so, mm.
    pub from: Axes,
    /// After it.
    pub to: Axes,
    /// Coefficients of `p²` to `p⁵` of each, `p` being the share of the move; `None`: every one
    /// moves evenly.
    pub bend: Option<Axes<[f64; 4]>>,
    /// Time it takes, s; `None`: rapid.
    pub seconds: Option<f64>,
    /// Coordinates of its line to the columns of X, Y, Z.
    pub words_from_line: Rigid,
}

impl Moved {
    /// Whether the whole move is known: false where the program has not said yet where an axis
    /// stands.
    pub fn known(&self) -> bool {
        self.from.iter().chain(self.to.iter()).all(|v| v.is_finite())
    }

    /// Whether it is one in which every word moves evenly.
    pub fn even(&self) -> bool {
        self.bend.is_none_or(|b| b.iter().flatten().all(|a| *a == 0.0))
    }

    /// The words at the share `f` of the move.
    pub fn at(&self, f: f64) -> Axes {
        // The end is known where the beginning is not.
        if f == 1.0 {
            return self.to;
        }
        let mut out = self.from;
        for (o, to) in out.iter_mut().zip(self.to.iter()) {
            *o += (to - *o) * f;
        }
        for (o, a) in out.iter_mut().zip(self.bend.iter().flat_map(|b| b.iter())) {
            *o += a.iter().zip(2..).map(|(a, k)| a * (f.powi(k) - f)).sum::<f64>();
        }
        out
    }

    /// The tool at the share `f` of the move.
    pub fn pose(&self, f: f64, tool: &Tool, machine: &Machine) -> Pose {
        pose(self.words, &self.at(f), tool, machine)
    }

    /// Positions of the machine's axes at the share `f` of the move, mm and rad.
    pub fn axes(&self, f: f64, tool: &Tool, machine: &Machine) -> Axes {
        axes(self.words, &self.at(f), tool, machine)
    }
}

/// The tool where the words say.
fn pose(words: Programmed, at: &[f64], tool: &Tool, machine: &Machine) -> Pose {
    if words == Programmed::Machine {
        return machine.forward(at, tool.length_mm());
    }
    let axis = machine.axis_at(at);
    let point = machine.linear().map(|k| at[k]);
    let lift = if words == Programmed::Tip { tool.corner_mm() } else { 0.0 };
    Pose { centre: Point::from(point) + axis * lift, axis }
}

/// Positions of the axes where the words say; the rotary ones are kept to the bit.
pub(super) fn axes(words: Programmed, at: &[f64], tool: &Tool, machine: &Machine) -> Axes {
    if words == Programmed::Machine {
        return at.into();
    }
    let centre = pose(words, at, tool, machine).centre;
    machine.linear_at(&centre, at, tool.length_mm())
}

/// The way of some words, by chords where they bend.
pub(super) fn length(moved: &Moved, words: impl Iterator<Item = usize> + Clone) -> f64 {
    let parts = if moved.even() { 1 } else { CHORDS };
    let places: Vec<Axes> = (0..=parts).map(|k| moved.at(k as f64 / parts as f64)).collect();
    let chord = |w: &[Axes]| words.clone().map(|i| (w[1][i] - w[0][i]).powi(2)).sum::<f64>().sqrt();
    places.windows(2).map(chord).sum()
}
