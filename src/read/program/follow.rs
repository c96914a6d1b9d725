//! The machine moved through a program's blocks.
//!
//! The state is where the machine's axes stand. A block in machine axes moves them straight; a
//! block under tool-centre-point control moves the programmed point straight over the part and the
//! rotary axes evenly, in the blade frame or, where the control fixes its frame to the table when
//! tool-centre-point control comes on (`G43.4`, `G43.5`), in that which it has fixed; under
//! polynomial interpolation every word goes as its polynomial says, from where its line says that
//! it begins, which may be off the end of the line before by what controls allow. What the program
//! has not said yet is not known (`NaN`), save for the rotary axes, which begin at 0.

use std::f64::consts::TAU;

use super::block::{Block, Destination, Feed, RotaryWay};
use super::unreachable;
use crate::artifact::Axes;
use crate::artifact::program::{Grammar, Language, Programmed};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::machine::{AxisName, Machine, Pose};
use crate::numerics::angle::nearest_turn;
use crate::tool::Tool;

/// Where the zero of a program's coordinates is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Zero {
    /// Coordinates of a program under tool-centre-point control to the blade frame.
    pub blade_from_program: Rigid,
    /// What is added to X, Y, Z of a program in machine axes, mm: the work offset.
    pub axes_mm: [f64; 3],
}

impl Default for Zero {
    /// As bladewright writes programs: in the blade frame, or in positions of the axes.
    fn default() -> Self {
        Zero { blade_from_program: Rigid::identity(), axes_mm: [0.0; 3] }
    }
}

/// A vector is along the tool axis within this, rad: its components are rounded.
const ALONG_RAD: f64 = 1e-6;
/// Letters of rotary axes, in the order of a block's words.
const ROTARY: [AxisName; 3] = [AxisName::A, AxisName::B, AxisName::C];
/// A spline line may begin so far from where the line before ended, mm or degrees: the iTNC 530
/// refuses more.
const APART: f64 = 1e-3;
/// Chords that the length of a bent move is taken from.
const CHORDS: usize = 64;

/// What a program runs on.
#[derive(Clone, Copy, Debug)]
pub struct Bench<'a> {
    /// How its words are meant.
    pub language: Language,
    /// Where its zero is.
    pub zero: Zero,
    /// The tool in the spindle.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
}

/// One move.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Line of the text.
    pub line: usize,
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
    let lift = if words == Programmed::Tip { tool.radius_mm } else { 0.0 };
    Pose { centre: Point::from(point) + axis * lift, axis }
}

/// Positions of the axes where the words say; the rotary ones are kept to the bit.
fn axes(words: Programmed, at: &[f64], tool: &Tool, machine: &Machine) -> Axes {
    if words == Programmed::Machine {
        return at.into();
    }
    let centre = pose(words, at, tool, machine).centre;
    machine.linear_at(&centre, at, tool.length_mm())
}

/// Follows the moves. What a move comes from is `NaN` where the program has not said it.
///
/// # Errors
/// A line whose vector is none, or lies along the rotary axis, or that moves in the blade frame
/// before tool-centre-point control is on.
pub fn follow(blocks: &[Block], bench: &Bench) -> Result<Vec<Moved>> {
    let mut follower = Follower { bench, stands: at_first(bench.machine), said: None, fixed: None };
    blocks.iter().map(|b| follower.step(b)).collect()
}

/// As [`follow`], with a tool for each tool call, in their order: the moves with each. What comes
/// before the first call is with the first tool, and a tool stays until the next is called.
///
/// # Errors
/// As [`follow`], and where there are not as many tool calls as tools.
pub fn follow_each(blocks: &[Block], benches: &[Bench]) -> Result<Vec<Vec<Moved>>> {
    let calls = blocks.iter().map(|b| b.tool_calls).max().unwrap_or(0);
    if calls.max(1) != benches.len() {
        return Err(Error::usage(
            Stage::Verify,
            format!("the program calls a tool {calls} times, {} tools are given", benches.len()),
        ));
    }
    let mut stood = None;
    let mut rest = blocks;
    let mut out = Vec::new();
    for (k, bench) in benches.iter().enumerate() {
        let stands = stood.unwrap_or_else(|| at_first(bench.machine));
        let own = rest.iter().take_while(|b| b.tool_calls <= k + 1).count();
        let (mine, later) = rest.split_at(own);
        let mut follower = Follower { bench, stands, said: None, fixed: None };
        out.push(mine.iter().map(|b| follower.step(b)).collect::<Result<_>>()?);
        (stood, rest) = (Some(follower.stands), later);
    }
    Ok(out)
}

/// Where the axes stand at first: rotary ones at 0, others nobody knows where.
fn at_first(machine: &Machine) -> Axes {
    let axes = machine.axes();
    Axes::from_fn(axes.len(), |k| if axes[k].is_rotary() { 0.0 } else { f64::NAN })
}

struct Follower<'a> {
    bench: &'a Bench<'a>,
    /// Positions of the machine's axes.
    stands: Axes,
    /// The programmed point, as long as it is the program's own: not taken back from the axes, so
    /// that it keeps its digits.
    said: Option<[f64; 3]>,
    /// The line that fixed the frame to the table, and the frame: to the blade frame.
    fixed: Option<(usize, Rigid)>,
}

impl Follower<'_> {
    /// Coordinates of the program to the blade frame.
    fn blade_from_program(&self) -> Rigid {
        self.fixed.map_or_else(Rigid::identity, |f| f.1) * self.bench.zero.blade_from_program
    }

    /// Fixes the frame to the table, where a line before has done so, as it stands.
    fn fix(&mut self, block: &Block, at: &[f64], in_this_line: bool) {
        if let Some(line) = block.fixed_by
            && self.fixed.is_none_or(|f| f.0 != line)
            && (line == block.line) == in_this_line
        {
            self.fixed = Some((line, self.bench.machine.blade_from_frame_fixed_at(at)));
        }
    }

    fn step(&mut self, block: &Block) -> Result<Moved> {
        if block.fixed_by.is_none() {
            self.fixed = None;
        }
        let stands = self.stands;
        self.fix(block, &stands, false);
        let (point, to) = match block.place {
            Destination::Words { point, rotary } => (point, self.rotary(block, rotary)?),
            Destination::Vector { point, axis } => {
                let axis = self.blade_from_program().rotation * Vector::from(axis);
                let machine = self.bench.machine;
                // Along the first rotary axis any position of that would do: it stays where the
                // tool stands so already.
                let stays = || axis.angle(&machine.axis_at(&stands)) < ALONG_RAD;
                let near = machine.rotary_of_axis(&axis, &stands).or_else(|| stays().then_some(stands));
                let reached = near.ok_or_else(|| {
                    unreachable(block.line, "the tool axis is along the rotary axis, out of reach, or none")
                })?;
                (point, reached)
            }
        };
        // Rotary words of the line that fixes it turn the table before.
        self.fix(block, &to, true);
        let own = self.bench.language.programmed == Programmed::Machine;
        if !own && !block.machine && !block.centre_point && point.iter().any(Option::is_some) {
            return Err(unreachable(block.line, "a move in the blade frame while tool-centre-point control is off"));
        }
        let mut moved = if own || block.machine || !block.centre_point {
            self.in_axes(block, point, to)
        } else {
            self.over_the_part(block, point, to)
        };
        if let Some(begins) = block.bend.and_then(|b| b.begins) {
            self.begin(block, begins, &mut moved)?;
        }
        moved.seconds = seconds(block.feed, &moved, self.bench.machine);
        Ok(moved)
    }

    /// Lets a move begin where its line says.
    fn begin(&self, block: &Block, [point, rotary]: [[f64; 3]; 2], moved: &mut Moved) -> Result<()> {
        let machine = self.bench.machine;
        let turned = match moved.words {
            Programmed::Machine => Vector::from(point),
            _ => self.blade_from_program().rotation * Vector::from(point),
        };
        let linear = machine.linear().into_iter().zip(turned.iter().map(|v| (*v, 1.0)));
        let of = |k: usize| ROTARY.iter().position(|letter| *letter == machine.axes()[k].letter).map(|w| rotary[w]);
        let rotary = machine.rotary().map(|k| (k, (of(k).unwrap_or(0.0).to_radians(), 1f64.to_degrees())));
        for (k, (back, unit)) in linear.chain(rotary) {
            let apart = unit * (moved.to[k] + back - moved.from[k]).abs();
            if !(apart <= APART) {
                let name = &machine.axes()[k].name;
                let what = format!("the spline begins {apart:.6} off where {name} stands, at most {APART} may be");
                return Err(unreachable(block.line, &what));
            }
            moved.from[k] = moved.to[k] + back;
        }
        Ok(())
    }

    /// X, Y, Z are positions of the axes; `to` has where the rotary axes go.
    fn in_axes(&mut self, block: &Block, point: [Option<f64>; 3], mut to: Axes) -> Moved {
        let linear = self.bench.machine.linear();
        for (i, word) in point.into_iter().enumerate() {
            let to = &mut to[linear[i]];
            if let (true, Some(step)) = (block.steps[i], word) {
                *to += step;
                continue;
            }
            // G43 adds the length to the tip along Z of the machine, however the head leans.
            let tool = self.bench.tool;
            let length = if block.tool_length && i == 2 { tool.length_mm() + tool.radius_mm } else { 0.0 };
            let zero = if block.machine { 0.0 } else { self.bench.zero.axes_mm[i] };
            *to = word.map_or(*to, |w| w + zero + length);
        }
        let bend = self.bend(block, |point| point);
        let moved = Moved { line: block.line, words: Programmed::Machine, from: self.stands, to, bend, seconds: None };
        (self.stands, self.said) = (to, None);
        moved
    }

    /// X, Y, Z are the programmed point over the part; `to` has where the rotary axes go.
    fn over_the_part(&mut self, block: &Block, point: [Option<f64>; 3], to: Axes) -> Moved {
        let Bench { language, tool, machine, .. } = *self.bench;
        let blade_from_program = self.blade_from_program();
        let words = language.programmed;
        let here = self.said.unwrap_or_else(|| {
            let pose = machine.forward(&self.stands, tool.length_mm());
            let point = if words == Programmed::Tip { pose.tip(tool.radius_mm) } else { pose.centre };
            (blade_from_program.inverse() * point).into()
        });
        let mut there = here;
        for ((t, word), step) in there.iter_mut().zip(point).zip(block.steps) {
            *t = word.map_or(*t, |w| if step { *t + w } else { w });
        }
        let at = |mut axes: Axes, point: [f64; 3]| {
            let point = blade_from_program * Point::from(point);
            machine.linear().into_iter().zip(point.iter()).for_each(|(k, v)| axes[k] = *v);
            axes
        };
        let (from, to) = (at(self.stands, here), at(to, there));
        let bend = self.bend(block, |point| blade_from_program.rotation * point);
        let moved = Moved { line: block.line, words, from, to, bend, seconds: None };
        (self.stands, self.said) = (axes(words, &to, tool, machine), Some(there));
        moved
    }

    /// Polynomials in the order of the axes; those of X, Y and Z brought to the frame of the move.
    fn bend(&self, block: &Block, turned: impl Fn(Vector) -> Vector) -> Option<Axes<[f64; 4]>> {
        let (said, machine) = (block.bend?, self.bench.machine);
        let (axes, linear) = (machine.axes(), machine.linear());
        let mut out: Axes<[f64; 4]> = Axes::of_default(axes.len());
        for k in 0..4 {
            let point = turned(Vector::from(said.point.map(|a| a[k])));
            (0..3).for_each(|i| out[linear[i]][k] = point[i]);
        }
        for k in machine.rotary() {
            let word = ROTARY.iter().position(|letter| *letter == axes[k].letter);
            out[k] = word.map_or([0.0; 4], |w| said.rotary[w].map(f64::to_radians));
        }
        Some(out)
    }

    /// Whether positions of the first rotary axis mean the shorter way to them; Klartext says so
    /// itself (`M126`).
    fn shortest_way(&self) -> bool {
        self.bench.language.shortest_way && self.bench.language.grammar == Grammar::Gcode
    }

    /// Where the axes stand after the rotary words of a line, rad.
    fn rotary(&self, block: &Block, words: [Option<f64>; 3]) -> Result<Axes> {
        let (mut to, machine) = (self.stands, self.bench.machine);
        let (axes, rotary) = (machine.axes(), machine.rotary());
        for (letter, (word, way)) in ROTARY.into_iter().zip(words.into_iter().zip(block.ways)) {
            let Some(word) = word.map(f64::to_radians) else { continue };
            let Some(k) = rotary.clone().find(|k| axes[*k].letter == letter) else {
                return Err(unreachable(block.line, &format!("the machine has no axis {}", letter.letter())));
            };
            let at = &mut to[k];
            let nearest = nearest_turn(word, *at);
            *at = match way {
                RotaryWay::By => *at + word,
                RotaryWay::Shorter => nearest,
                RotaryWay::Up => *at + (word - *at).rem_euclid(TAU),
                RotaryWay::Down => *at - (*at - word).rem_euclid(TAU),
                RotaryWay::To if self.shortest_way() && k == machine.turning_axis() => nearest,
                RotaryWay::To => word,
            };
        }
        Ok(to)
    }
}

/// How long a move takes, s; `None` for a rapid.
fn seconds(feed: Feed, moved: &Moved, machine: &Machine) -> Option<f64> {
    match feed {
        Feed::Rapid => None,
        Feed::PerMove(f) => Some(60.0 / f),
        Feed::PerMinute(f) => {
            let way = length(moved, machine.linear().into_iter());
            let turn = length(moved, machine.rotary()).to_degrees();
            Some(60.0 * if way > 0.0 { way } else { turn } / f)
        }
    }
}

/// The way of some words, by chords where they bend.
fn length(moved: &Moved, words: impl Iterator<Item = usize> + Clone) -> f64 {
    let parts = if moved.even() { 1 } else { CHORDS };
    let places: Vec<Axes> = (0..=parts).map(|k| moved.at(k as f64 / parts as f64)).collect();
    let chord = |w: &[Axes]| words.clone().map(|i| (w[1][i] - w[0][i]).powi(2)).sum::<f64>().sqrt();
    places.windows(2).map(chord).sum()
}
