//! What a line of a program asks for.

/// Where a line goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Words of the programmed point (mm) and of rotary axes A and B (degrees); what is not given stays.
    Words {
        /// X, Y, Z.
        point: [Option<f64>; 3],
        /// A and B.
        rotary: [Option<f64>; 2],
    },
    /// Words of the programmed point and the tool axis as a vector.
    Vector {
        /// X, Y, Z.
        point: [Option<f64>; 3],
        /// Tool axis, blade frame, from tip to spindle; of any length.
        axis: [f64; 3],
    },
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
    pub place: Place,
    /// Rotary words are steps.
    pub steps: [bool; 2],
    /// How fast.
    pub feed: Feed,
    /// Linear words are positions of the machine's axes, whatever the program's coordinates are otherwise.
    pub machine: bool,
    /// Tool-centre-point control is on.
    pub centre_point: bool,
}
