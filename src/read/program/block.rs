//! What a line of a program asks for, and a program as it was read.

use super::moved::Moved;
use crate::artifact::program::Setting;
use crate::geometry::Rigid;

/// Where a line goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Destination {
    /// Words of the programmed point (mm) and of rotary axes (degrees); what is not given stays.
    Words {
        /// X, Y, Z.
        point: [Option<f64>; 3],
        /// A, B and C.
        rotary: [Option<f64>; 3],
    },
    /// Words of the programmed point and the tool axis as a vector.
    Vector {
        /// X, Y, Z.
        point: [Option<f64>; 3],
        /// Tool axis, blade frame, from tip to spindle; of any length.
        axis: [f64; 3],
    },
}

/// How a rotary word is meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RotaryWay {
    /// A position over all turns, or the shorter way to it where the control goes that way.
    #[default]
    To,
    /// A step: `IC()`.
    By,
    /// The shorter way to a position within a turn: `DC()`.
    Shorter,
    /// To a position within a turn, turning up: `ACP()`.
    Up,
    /// To a position within a turn, turning down: `ACN()`.
    Down,
}

/// How the words of a line bend on their way, under polynomial interpolation: coefficients of `p²`
/// to `p⁵`, `p` going from 0 to 1 over the line. That of `p` is what brings a word to its end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bend {
    /// X, Y, Z, mm.
    pub point: [[f64; 4]; 3],
    /// A, B, C, degrees.
    pub rotary: [[f64; 4]; 3],
    /// Where the line itself says that it begins, as steps from its end: X, Y, Z, mm, and A, B, C,
    /// degrees; `None`: where the line before ended.
    pub begins: Option<[[f64; 3]; 2]>,
}

/// Where the centre of an arc is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Centre {
    /// From where the arc begins, mm.
    FromStart([f64; 3]),
    /// A point, mm.
    At([f64; 3]),
    /// As far from both ends, mm; less than 0: the way is more than half a turn.
    Radius(f64),
}

/// A circle, or a helix where the ends are not in one plane across its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Its centre, in the coordinates of the line.
    pub centre: Centre,
    /// Its axis, of any length, in the coordinates of the line: the way is counter-clockwise seen
    /// against it.
    pub axis: [f64; 3],
    /// Whole turns beside the way from one end to the other.
    pub turns: u32,
}

/// How X, Y and Z go to their ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Interpolation {
    /// Straight, every word evenly.
    #[default]
    Straight,
    /// On polynomials.
    Bent(Bend),
    /// On an arc, evenly along it.
    Arc(Arc),
}

/// The feed of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feed {
    /// As fast as the axes can.
    Rapid,
    /// Inverse time, 1/min.
    PerMove(f64),
    /// mm/min (degrees/min on lines that turn only).
    PerMinute(f64),
}

/// A move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Number of the line in the text, from 1.
    pub line: usize,
    /// Where to.
    pub place: Destination,
    /// X, Y, Z are steps from where they are.
    pub steps: [bool; 3],
    /// How the rotary words are meant.
    pub ways: [RotaryWay; 3],
    /// How the words go to their ends.
    pub course: Interpolation,
    /// The tool axis turns in the plane of its ends, evenly; the rotary axes follow it.
    pub great_circle: bool,
    /// Coordinates of the line to those of the program's zero.
    pub frame: Rigid,
    /// X, Y, Z are over the part without tool-centre-point control, in a plane to which the tool is
    /// square: Z of `frame`.
    pub in_plane: bool,
    /// How fast.
    pub feed: Feed,
    /// Linear words are positions of the machine's axes, whatever the program's coordinates are
    /// otherwise.
    pub machine: bool,
    /// The tool's length is added to Z: G43.
    pub tool_length: bool,
    /// Tool-centre-point control is on.
    pub centre_point: bool,
    /// The line that fixed X, Y, Z to the table as it stood there; `None`: to the table as it
    /// stands at 0.
    pub fixed_by: Option<usize>,
    /// Tool calls before it.
    pub tool_calls: usize,
    /// What is set beside.
    pub setting: Setting,
}

/// A call of a tool.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// Number of the line, from 1.
    pub line: usize,
    /// Number or name of the tool; `None`: not said.
    pub tool: Option<String>,
}

/// A program as it was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// Its moves, up to its end.
    pub blocks: Vec<Block>,
    /// Its tool calls, in their order.
    pub calls: Vec<Call>,
    /// Its work offset: 54 for `G54`.
    pub frame: Option<u32>,
    /// Diameters and corner radii of the cutters that it says it was computed for, mm, and their
    /// lines.
    pub cutters: Vec<(usize, [f64; 2])>,
    /// The line that ends it.
    pub end: Option<usize>,
    /// Lines behind that one which say something.
    pub behind: Vec<usize>,
}

impl Script {
    /// The blocks that some moves were made from, which follow one another.
    pub fn blocks_of(&self, moves: &[Moved]) -> &[Block] {
        let (first, last) = (moves.first().map_or(0, |m| m.block), moves.last().map_or(0, |m| m.block + 1));
        self.blocks.get(first..last).unwrap_or_default()
    }

    /// The program ends with a line, where it has not ended before.
    pub(super) fn ends(&mut self, line: usize) {
        self.end.get_or_insert(line);
    }
}

impl Block {
    /// A straight move to a place in the program's coordinates, its words as they stand, under
    /// tool-centre-point control, before any tool call.
    pub(super) fn straight(line: usize, place: Destination, feed: Feed) -> Self {
        Block {
            line,
            place,
            steps: [false; 3],
            ways: [RotaryWay::To; 3],
            course: Interpolation::Straight,
            great_circle: false,
            frame: Rigid::identity(),
            in_plane: false,
            feed,
            machine: false,
            tool_length: false,
            centre_point: true,
            fixed_by: None,
            tool_calls: 0,
            setting: Setting::default(),
        }
    }
}
