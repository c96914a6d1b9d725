//! The machine moved through a program's blocks.
//!
//! The state is where the machine's axes stand. A block in machine axes moves them straight; a
//! block under tool-centre-point control moves the programmed point over the part and the rotary
//! axes evenly, in the blade frame or, where the control fixes its frame to the table when
//! tool-centre-point control comes on (`G43.4`, `G43.5`), in that which it has fixed. Under
//! polynomial interpolation every word goes as its polynomial says, from where its line says that
//! it begins, which may be off the end of the line before by what controls allow; on an arc the
//! programmed point goes evenly along it. A block in a tilted plane moves the programmed point as
//! well, while the tool is square to the plane. What the program has not said yet is not known
//! (`NaN`), save for the rotary axes, which begin at 0.

use std::f64::consts::TAU;

use super::arc::{self, ArcPiece};
use super::block::{Bend, Block, Destination, Feed, Interpolation, RotaryWay};
use super::moved::{self, Moved};
use super::turn::great_circle;
use super::unreachable;
use crate::artifact::Axes;
use crate::artifact::program::{Grammar, Language, Programmed};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Rigid, Vector};
use crate::machine::{AxisName, Machine};
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
/// The tool is square to a plane within this, rad: rotary words have three decimals.
const SQUARE_RAD: f64 = 1e-4;
/// Most moves beside one for each block, of arcs and of great circles.
const MOST: usize = 2_000_000;
/// Letters of rotary axes, in the order of a block's words.
const ROTARY: [AxisName; 3] = [AxisName::A, AxisName::B, AxisName::C];
/// A spline line may begin so far from where the line before ended, mm or degrees: the iTNC 530
/// refuses more.
const APART: f64 = 1e-3;

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

/// Follows the moves, in the order of the blocks; every block makes one at least. What a move comes
/// from is `NaN` where the program has not said it.
///
/// # Errors
/// A line whose vector is none, or lies along the rotary axis, whose arc is none, that moves in the
/// blade frame before tool-centre-point control is on, or at a feed from a reference position.
pub fn follow(blocks: &[Block], bench: &Bench) -> Result<Vec<Moved>> {
    let mut follower = Follower::new(bench, at_first(bench.machine));
    let mut out = Vec::with_capacity(blocks.len());
    for (k, block) in blocks.iter().enumerate() {
        follower.step(block, k, &mut out)?;
    }
    Ok(out)
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
    let mut rest = blocks.iter().enumerate().peekable();
    let mut out = Vec::new();
    for (k, bench) in benches.iter().enumerate() {
        let mut follower = Follower::new(bench, stood.unwrap_or_else(|| at_first(bench.machine)));
        let mut moves = Vec::new();
        while let Some((at, block)) = rest.next_if(|(_, b)| b.tool_calls <= k + 1) {
            follower.step(block, at, &mut moves)?;
        }
        stood = Some(follower.stands);
        out.push(moves);
    }
    Ok(out)
}

/// Where the axes stand at first: rotary ones at 0, as those that the machine has not, others
/// nobody knows where.
fn at_first(machine: &Machine) -> Axes {
    let axes = machine.axes();
    Axes::from_fn(axes.len(), |k| if axes[k].is_rotary() || axes[k].is_missing { 0.0 } else { f64::NAN })
}

/// An axis that the machine has not is at 0 to the rounding of words, mm.
const MISSING_MM: f64 = 1e-3;

struct Follower<'a> {
    bench: &'a Bench<'a>,
    /// Positions of the machine's axes.
    stands: Axes,
    /// The programmed point, as long as it is the program's own: not taken back from the axes, so
    /// that it keeps its digits; with the frame that it is in.
    said: Option<([f64; 3], Rigid)>,
    /// The line that fixed the frame to the table, and the frame: to the blade frame.
    fixed: Option<(usize, Rigid)>,
    /// The program has sent axes to where only the machine knows.
    away: bool,
    /// Moves beside one for each block.
    more: usize,
}

/// Where a block goes, in its own coordinates, and what brings these to the columns of X, Y, Z.
struct BlockWay {
    words: Programmed,
    here: [f64; 3],
    there: [f64; 3],
    from: Axes,
    to: Axes,
    words_from_block: Rigid,
}

impl<'a> Follower<'a> {
    fn new(bench: &'a Bench<'a>, stands: Axes) -> Self {
        Follower { bench, stands, said: None, fixed: None, away: false, more: 0 }
    }

    /// Coordinates of the program to the blade frame.
    fn blade_from_program(&self, block: &Block) -> Rigid {
        let own = self.bench.language.programmed == Programmed::Machine;
        let zero = if own && block.in_plane {
            let [x, y, z] = self.bench.zero.axes_mm;
            self.blade_from_tip_at_zero() * Rigid::translation(x, y, z)
        } else {
            self.fixed.map_or_else(Rigid::identity, |f| f.1) * self.bench.zero.blade_from_program
        };
        zero * block.frame
    }

    /// Positions of the linear axes that G43 would lead the tip to, the rotary axes at 0: to the
    /// blade frame.
    fn blade_from_tip_at_zero(&self) -> Rigid {
        let Bench { tool, machine, .. } = *self.bench;
        let tip = |x: f64, y: f64, z: f64| {
            let mut axes = Axes::of_default(machine.axes().len());
            let [i, j, k] = machine.linear();
            (axes[i], axes[j], axes[k]) = (x, y, z + tool.length_mm() + tool.corner_mm());
            machine.forward(&axes, tool.length_mm()).tip(tool.corner_mm())
        };
        let origin = tip(0.0, 0.0, 0.0);
        let columns = [tip(1.0, 0.0, 0.0), tip(0.0, 1.0, 0.0), tip(0.0, 0.0, 1.0)].map(|p| p - origin);
        let turned = nalgebra::Rotation3::from_matrix_unchecked(nalgebra::Matrix3::from_columns(&columns));
        Rigid::from_parts(origin.into(), nalgebra::UnitQuaternion::from_rotation_matrix(&turned))
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

    fn step(&mut self, block: &Block, at: usize, out: &mut Vec<Moved>) -> Result<()> {
        if block.fixed_by.is_none() {
            self.fixed = None;
        }
        let stands = self.stands;
        self.fix(block, &stands, false);
        let (point, to) = match block.place {
            Destination::Words { point, rotary } => (point, self.rotary(block, rotary)?),
            Destination::Vector { point, axis } => {
                let axis = self.blade_from_program(block).rotation * Vector::from(axis);
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
        let moves_point = point.iter().any(Option::is_some);
        let in_plane = block.in_plane && moves_point && !block.machine && !block.centre_point;
        if !own && !block.machine && !block.centre_point && !in_plane && moves_point {
            return Err(unreachable(block.line, "a move in the blade frame while tool-centre-point control is off"));
        }
        let by_axes = !in_plane && (own || block.machine || !block.centre_point);
        if moves_point {
            self.plain_where_diameters(block, by_axes)?;
        }
        let mut way = if in_plane {
            self.in_plane(block, point, to)?
        } else if by_axes {
            self.in_axes(block, point, to)
        } else {
            let words = self.bench.language.programmed;
            self.over_the_part(block, words, point, to)
        };
        if let Interpolation::Bent(Bend { begins: Some(begins), .. }) = block.course {
            self.begin(block, begins, &mut way)?;
        }
        self.without_missing(block, &mut way)?;
        self.drive(block, at, &way, out)
    }

    /// Where words of an axis are diameters, only straight moves by positions of axes are read:
    /// what curves and frames mean by such words differs from control to control.
    fn plain_where_diameters(&self, block: &Block, by_axes: bool) -> Result<()> {
        let Some(axis) = self.bench.machine.axes().iter().find(|a| a.counts_diameter) else { return Ok(()) };
        let shifted = !block.machine && block.frame != Rigid::identity();
        if by_axes && !shifted && matches!(block.course, Interpolation::Straight) {
            return Ok(());
        }
        let what = "only straight moves by positions of axes are read, without frames";
        Err(unreachable(block.line, &format!("words of {} are diameters on this machine, where {what}", axis.name)))
    }

    /// A way leaves an axis that the machine has not where it is: at 0.
    fn without_missing(&self, block: &Block, way: &mut BlockWay) -> Result<()> {
        let axes = self.bench.machine.axes();
        for (k, axis) in axes.iter().enumerate().filter(|(_, a)| a.is_missing) {
            // All axes are sent where only the machine knows, also those that it does not have.
            if way.to[k].abs() > MISSING_MM {
                let what = format!("{} goes to {:.4} mm, and the machine has no such axis", axis.name, way.to[k]);
                return Err(unreachable(block.line, &what));
            }
            way.to[k] = 0.0;
        }
        Ok(())
    }

    /// Lets a way begin where its line says.
    fn begin(&self, block: &Block, [point, rotary]: [[f64; 3]; 2], way: &mut BlockWay) -> Result<()> {
        let machine = self.bench.machine;
        let turned = way.words_from_block.rotation * Vector::from(point);
        let linear = machine.linear().into_iter().zip(turned.iter().map(|v| (*v, 1.0)));
        let of = |k: usize| ROTARY.iter().position(|letter| *letter == machine.axes()[k].letter).map(|w| rotary[w]);
        let rotary = machine.rotary().map(|k| (k, (of(k).unwrap_or(0.0).to_radians(), 1f64.to_degrees())));
        for (k, (back, unit)) in linear.chain(rotary) {
            let apart = unit * (way.to[k] + back - way.from[k]).abs();
            if !(apart <= APART) {
                let name = &machine.axes()[k].name;
                let what = format!("the spline begins {apart:.6} off where {name} stands, at most {APART} may be");
                return Err(unreachable(block.line, &what));
            }
            way.from[k] = way.to[k] + back;
        }
        Ok(())
    }

    /// X, Y, Z are positions of the axes, or diameters; `to` has where the rotary axes go.
    fn in_axes(&self, block: &Block, point: [Option<f64>; 3], mut to: Axes) -> BlockWay {
        let (Bench { tool, zero, machine, .. }, linear) = (*self.bench, self.bench.machine.linear());
        let point: [Option<f64>; 3] =
            std::array::from_fn(|i| Some(point[i]? / machine.axes()[linear[i]].word_per_mm()));
        let frame = if block.machine { Rigid::identity() } else { block.frame };
        let turned = frame.rotation != nalgebra::UnitQuaternion::identity();
        // G43 adds the length to the tip along Z of the machine, however the head leans.
        let length = if block.tool_length { tool.length_mm() + tool.corner_mm() } else { 0.0 };
        let added: [f64; 3] = std::array::from_fn(|i| {
            let zero = if block.machine { 0.0 } else { zero.axes_mm[i] + frame.translation.vector[i] };
            zero + if i == 2 { length } else { 0.0 }
        });
        let words_from_block = Rigid::from_parts(added.into(), frame.rotation);
        let here: [f64; 3] = if turned {
            (words_from_block.inverse() * Point::from(linear.map(|k| self.stands[k]))).into()
        } else {
            std::array::from_fn(|i| self.stands[linear[i]] - added[i])
        };
        let mut there = here;
        for (i, word) in point.into_iter().enumerate() {
            let Some(word) = word else { continue };
            there[i] = if block.steps[i] { here[i] + word } else { word };
            // Without a turn each word is one axis' own, and keeps its digits.
            let to = &mut to[linear[i]];
            *to = if block.steps[i] { *to + word } else { word + added[i] };
        }
        if turned && point.iter().any(Option::is_some) {
            let place = words_from_block * Point::from(there);
            linear.into_iter().zip(place.iter()).for_each(|(k, v)| to[k] = *v);
        }
        let words = Programmed::Machine;
        BlockWay { words, here, there, from: self.stands, to, words_from_block }
    }

    /// In a plane to which the tool is square already.
    fn in_plane(&self, block: &Block, point: [Option<f64>; 3], to: Axes) -> Result<BlockWay> {
        let machine = self.bench.machine;
        if machine.rotary().any(|k| !to[k].is_finite()) {
            return Err(unreachable(block.line, "a move in a tilted plane while the rotary axes are who knows where"));
        }
        if machine.rotary().any(|k| to[k] != self.stands[k]) {
            return Err(unreachable(block.line, "rotary axes and X, Y, Z together in a tilted plane"));
        }
        let normal = self.blade_from_program(block).rotation * Vector::z();
        let off = normal.angle(&machine.axis_at(&to));
        if !(off <= SQUARE_RAD) {
            let what = format!("the tool is {:.3}° off the direction square to the tilted plane", off.to_degrees());
            return Err(unreachable(block.line, &what));
        }
        let words = match self.bench.language.programmed {
            Programmed::Centre => Programmed::Centre,
            Programmed::Tip | Programmed::Machine => Programmed::Tip,
        };
        Ok(self.over_the_part(block, words, point, to))
    }

    /// X, Y, Z are the programmed point over the part; `to` has where the rotary axes go.
    fn over_the_part(&self, block: &Block, words: Programmed, point: [Option<f64>; 3], to: Axes) -> BlockWay {
        let Bench { tool, machine, .. } = *self.bench;
        let blade_from_program = self.blade_from_program(block);
        let here = match self.said {
            Some((here, frame)) if frame == block.frame => here,
            Some((here, frame)) => (block.frame.inverse() * frame * Point::from(here)).into(),
            None => {
                let pose = machine.forward(&self.stands, tool.length_mm());
                let point = if words == Programmed::Tip { pose.tip(tool.corner_mm()) } else { pose.centre };
                (blade_from_program.inverse() * point).into()
            }
        };
        let mut there = here;
        for ((t, word), step) in there.iter_mut().zip(point).zip(block.steps) {
            *t = word.map_or(*t, |w| if step { *t + w } else { w });
        }
        let at = |axes: Axes, point: [f64; 3]| with_point(axes, machine, blade_from_program * Point::from(point));
        let (from, to) = (at(self.stands, here), at(to, there));
        BlockWay { words, here, there, from, to, words_from_block: blade_from_program }
    }

    /// Makes the moves of a way.
    fn drive(&mut self, block: &Block, at: usize, way: &BlockWay, out: &mut Vec<Moved>) -> Result<()> {
        let Bench { tool, machine, .. } = *self.bench;
        if let Destination::Words { point, rotary } = block.place {
            self.away |= point.iter().chain(&rotary).flatten().any(|word| word.is_nan());
        }
        if self.away && block.feed != Feed::Rapid && way.from.iter().any(|v| v.is_nan()) {
            let what = "a move at a feed from where only the machine knows; a rapid must lead to its beginning";
            return Err(unreachable(block.line, what));
        }
        let first = out.len();
        let pieces = match &block.course {
            Interpolation::Arc(arc) => {
                arc::pieces(arc, way.here, way.there).map_err(|e| unreachable(block.line, &e))?
            }
            Interpolation::Straight | Interpolation::Bent(_) => Vec::new(),
        };
        let ends = if block.great_circle && way.words != Programmed::Machine {
            if !matches!(block.course, Interpolation::Straight) {
                return Err(unreachable(block.line, "a great circle of the tool axis along a bent way"));
            }
            let vector = matches!(block.place, Destination::Vector { .. });
            great_circle(machine, &way.from, &way.to, vector).map_err(|e| unreachable(block.line, &e))?
        } else {
            Vec::new()
        };
        let mut from = way.from;
        let mut push = |to: Axes, bend: Option<Axes<[f64; 4]>>| {
            let (line, words, words_from_line) = (block.line, way.words, way.words_from_block);
            out.push(Moved { line, block: at, words, from, to, bend, seconds: None, words_from_line });
            from = to;
        };
        let count = pieces.len() as f64;
        let mut to = way.to;
        for (k, piece) in pieces.iter().enumerate() {
            let end = if k + 1 == pieces.len() {
                to
            } else {
                let there = way.words_from_block * Point::from(piece.to);
                with_point(way.from.toward(&to, (k + 1) as f64 / count), machine, there)
            };
            push(end, Some(self.bent(way, piece)));
        }
        for end in &ends {
            to = *end;
            push(to, None);
        }
        if pieces.is_empty() && ends.is_empty() {
            let bend = if let Interpolation::Bent(bend) = &block.course { Some(bend) } else { None };
            push(to, bend.map(|bend| self.polynomials(bend, way)));
        }
        self.more += out.len() - first - 1;
        if self.more > MOST {
            return Err(unreachable(block.line, "the arcs of the program are too long to be followed"));
        }
        time(block.feed, &mut out[first..], machine, self.bench.language.feed_counts_degrees);
        self.stands = if way.words == Programmed::Machine { to } else { moved::axes(way.words, &to, tool, machine) };
        self.said = (way.words != Programmed::Machine).then_some((way.there, block.frame));
        Ok(())
    }

    /// The polynomials of a piece of an arc.
    fn bent(&self, way: &BlockWay, piece: &ArcPiece) -> Axes<[f64; 4]> {
        self.polynomials(&Bend { point: piece.bend, ..Bend::default() }, way)
    }

    /// Polynomials in the order of the axes; those of X, Y and Z brought to the frame of the move.
    fn polynomials(&self, said: &Bend, way: &BlockWay) -> Axes<[f64; 4]> {
        let machine = self.bench.machine;
        let (axes, linear) = (machine.axes(), machine.linear());
        let mut out: Axes<[f64; 4]> = Axes::of_default(axes.len());
        for k in 0..4 {
            let point = way.words_from_block.rotation * Vector::from(said.point.map(|a| a[k]));
            (0..3).for_each(|i| out[linear[i]][k] = point[i]);
        }
        for k in machine.rotary() {
            let word = ROTARY.iter().position(|letter| *letter == axes[k].letter);
            out[k] = word.map_or([0.0; 4], |w| said.rotary[w].map(f64::to_radians));
        }
        out
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
                // All axes are sent where only the machine knows, also those that it does not have.
                if word.is_nan() {
                    continue;
                }
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

/// The same row with X, Y, Z those of a point.
fn with_point(mut axes: Axes, machine: &Machine, point: Point) -> Axes {
    machine.linear().into_iter().zip(point.iter()).for_each(|(k, v)| axes[k] = *v);
    axes
}

/// How long the moves of one block take, s. `of_all`: F counts degrees as millimetres.
fn time(feed: Feed, moves: &mut [Moved], machine: &Machine, of_all: bool) {
    let count = moves.len() as f64;
    let way = |m: &Moved| {
        let way = moved::length(m, machine.linear().into_iter());
        if of_all { way.hypot(moved::length(m, machine.rotary()).to_degrees()) } else { way }
    };
    let ways: Vec<f64> = moves.iter().map(way).collect();
    let goes = ways.iter().any(|w| *w > 0.0);
    for (m, way) in moves.iter_mut().zip(ways) {
        m.seconds = match feed {
            Feed::Rapid => None,
            Feed::PerMove(f) => Some(60.0 / f / count),
            Feed::PerMinute(f) => {
                let way = if goes { way } else { moved::length(m, machine.rotary()).to_degrees() };
                Some(60.0 * way / f)
            }
        };
    }
}
