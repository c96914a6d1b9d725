//! An axis of a machine: name, direction, place, limits, and what it carries.

use nalgebra::Unit;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::geometry::{Point, Vector};

/// Letter of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum AxisName {
    /// Linear.
    X,
    /// Linear.
    Y,
    /// Linear.
    Z,
    /// Linear, of a second head.
    U,
    /// Linear, of a second head.
    V,
    /// Linear, of a second head.
    W,
    /// Rotary, about X where the file gives no direction.
    A,
    /// Rotary, about Y where the file gives no direction.
    B,
    /// Rotary, about Z where the file gives no direction.
    C,
}

impl AxisName {
    /// Its place among X, Y, Z, or among U, V, W; `None`: a rotary one.
    pub fn linear(self) -> Option<usize> {
        Self::LINEAR.iter().chain(&Self::SECOND).position(|n| *n == self).map(|k| k % 3)
    }
    /// X, Y and Z.
    pub const LINEAR: [AxisName; 3] = [AxisName::X, AxisName::Y, AxisName::Z];
    /// U, V and W: along X, Y and Z.
    pub const SECOND: [AxisName; 3] = [AxisName::U, AxisName::V, AxisName::W];
    /// A, B and C.
    pub const ROTARY: [AxisName; 3] = [AxisName::A, AxisName::B, AxisName::C];
    /// The letter.
    pub fn letter(self) -> &'static str {
        match self {
            AxisName::X => "X",
            AxisName::Y => "Y",
            AxisName::Z => "Z",
            AxisName::U => "U",
            AxisName::V => "V",
            AxisName::W => "W",
            AxisName::A => "A",
            AxisName::B => "B",
            AxisName::C => "C",
        }
    }
    /// The direction that it has by its letter.
    pub fn unit(self) -> [f64; 3] {
        match self {
            AxisName::X | AxisName::U | AxisName::A => [1.0, 0.0, 0.0],
            AxisName::Y | AxisName::V | AxisName::B => [0.0, 1.0, 0.0],
            AxisName::Z | AxisName::W | AxisName::C => [0.0, 0.0, 1.0],
        }
    }
}

/// Where limits of velocity, acceleration and jerk come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Provenance {
    /// Of the usual size for such a machine; results on time are to be read with that in mind.
    Assumed,
    /// Measured on the machine, or its maker's figures.
    Measured,
}

/// Limits of one axis in inner units: mm or rad, and s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisLimits {
    /// Least and greatest position; `None`: unlimited turns.
    pub travel: Option<[f64; 2]>,
    /// Greatest speed, mm/s or rad/s.
    pub velocity: f64,
    /// Greatest acceleration, mm/s² or rad/s².
    pub acceleration: f64,
    /// Greatest jerk, mm/s³ or rad/s³.
    pub jerk: f64,
    /// Where the last three come from.
    pub provenance: Provenance,
}

impl AxisLimits {
    /// From rest to rest over a way (mm or rad), under velocity and acceleration: a trapezoid, or a
    /// triangle where it is short, s.
    pub fn rest_to_rest_s(&self, way: f64) -> f64 {
        let (v, a) = (self.velocity, self.acceleration);
        match way {
            0.0 => 0.0,
            _ if way < v * v / a => 2.0 * (way / a).sqrt(),
            _ => way / v + v / a,
        }
    }
}

/// What an axis carries, besides the axes that follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carries {
    /// The workpiece: a linear axis stands between it and the tool. All heads share it.
    Workpiece,
    /// The tool of this head, counted from 0.
    Head(usize),
}

/// One axis of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name in tables and messages, no other axis of the machine has it.
    pub name: String,
    /// Its letter in programs.
    pub letter: AxisName,
    /// Its direction in machine coordinates while all axes read 0. Positive is the tool moving that
    /// way over the workpiece, or going round it by the right-hand rule (ISO 841).
    pub direction: Unit<Vector>,
    /// A point on it in machine coordinates while all axes read 0, mm; of a linear axis the origin.
    pub point: Point,
    /// What it carries.
    pub carries: Carries,
    /// How far and how fast it goes.
    pub limits: AxisLimits,
    /// The machine has no such axis: the tool stands at 0 of it, and programs do not name it.
    pub is_missing: bool,
    /// Its words in programs of axes are diameters: twice its position.
    pub counts_diameter: bool,
    /// Where the machine file says which sense is positive, for messages.
    pub sense_key: &'static str,
}

impl Axis {
    /// Whether its positions are angles, rad; else they are lengths, mm.
    pub fn is_rotary(&self) -> bool {
        self.letter.linear().is_none()
    }

    /// What its word in a program of axes is for a position, or a way, of 1 mm.
    pub fn word_per_mm(&self) -> f64 {
        if self.counts_diameter { 2.0 } else { 1.0 }
    }

    /// A position or one of its derivatives as people read it: angles in degrees.
    pub fn shown(&self, value: f64) -> f64 {
        if self.is_rotary() { value.to_degrees() } else { value }
    }

    /// What positions and their derivatives are multiplied by for people: 1 of lengths, degrees per
    /// radian of angles.
    pub fn scale(&self) -> f64 {
        if self.is_rotary() { 1f64.to_degrees() } else { 1.0 }
    }

    /// The unit of scaled positions in words: `mm` or `deg`.
    pub fn unit(&self) -> &'static str {
        if self.is_rotary() { "deg" } else { "mm" }
    }

    /// The unit of scaled positions as a sign: `mm` or `°`.
    pub fn sign(&self) -> &'static str {
        if self.is_rotary() { "°" } else { "mm" }
    }
}
