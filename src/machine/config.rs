//! The machine file as it is written, and limits of its axes in inner units.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use nalgebra::UnitQuaternion;

use super::axis::{AxisLimits, AxisName, Provenance};
use crate::geometry::{Rigid, Vector};

/// The built-in demo machine as its file.
pub const DEMO_TOML: &str = include_str!("../../models/machines/demo_table_head.toml");

/// What positive `A` turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PositiveA {
    /// The tool goes round the workpiece by the right-hand rule about +X; the table turns the other
    /// way (ISO 841).
    Tool,
    /// The table turns the workpiece by the right-hand rule about +X.
    Workpiece,
}

/// To which side positive `B` leans the spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PositiveB {
    /// Towards +X of the machine, the blade's tip.
    #[default]
    PlusX,
    /// Towards -X.
    MinusX,
}

/// How the blade sits on the machine while the rotary axes read 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mount {
    /// Origin of the blade frame in machine coordinates, mm.
    pub offset_mm: [f64; 3],
    /// Angle by which the blade is turned about its own x first, right-hand rule, degrees.
    #[serde(default)]
    pub clamping_deg: f64,
    /// Direction of the blade axis, root to tip, in machine coordinates, for machines with a
    /// `chain`; default: X. The blade is brought there from X by the shortest turn (straight back:
    /// by half a turn about Z).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along: Option<[f64; 3]>,
}

impl Mount {
    /// The mount of a blade frame that is there in machine coordinates.
    pub(super) fn of(machine_from_blade: &Rigid) -> Self {
        let turn = machine_from_blade.rotation;
        let along = turn * Vector::x();
        let clamping = brought(&along).inverse() * turn;
        let about_x = clamping * Vector::y();
        Mount {
            offset_mm: machine_from_blade.translation.vector.into(),
            clamping_deg: about_x.z.atan2(about_x.y).to_degrees(),
            along: Some(along.into()),
        }
    }
}

/// The turn that brings X along a direction, unit: the shortest, straight back half a turn about Z.
pub(super) fn brought(along: &Vector) -> UnitQuaternion<f64> {
    UnitQuaternion::rotation_between(&Vector::x(), along)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector::z_axis(), std::f64::consts::PI))
}

/// The spindle of a machine with a `chain`, while all axes read 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Spindle {
    /// The gauge line's point on the tool axis, machine coordinates, mm.
    pub gauge_mm: [f64; 3],
    /// The tool axis, from tip to spindle.
    pub direction: [f64; 3],
}

impl Default for Spindle {
    fn default() -> Self {
        Spindle { gauge_mm: [0.0; 3], direction: [0.0, 0.0, 1.0] }
    }
}

/// The rotary table `A` about machine X.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Y of the axis of rotation, mm.
    pub axis_y_mm: f64,
    /// Z of the axis of rotation, mm.
    pub axis_z_mm: f64,
    /// Sense of `A`.
    pub positive_a_turns: PositiveA,
}

/// The pivoting head `B`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Head")]
pub struct HeadTable {
    /// From the pivot to the spindle's gauge line, mm.
    pub pivot_length_mm: f64,
    /// How far the spindle's axis passes the pivot by, along X of the machine while B = 0, mm; 0:
    /// they meet.
    #[serde(default)]
    pub spindle_offset_mm: f64,
    /// Sense of `B`.
    #[serde(default)]
    pub positive_b_leans: PositiveB,
}

/// What words of a linear axis count where a program names positions of axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Words {
    /// Its position.
    #[default]
    Position,
    /// Twice its position: the diameter, as X of most lathes.
    Diameter,
}

impl Words {
    /// Whether it is what the file need not say.
    fn are_usual(&self) -> bool {
        *self == Words::Position
    }
}

/// A linear axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearAxis {
    /// Least position, mm.
    pub min_mm: f64,
    /// Greatest position, mm.
    pub max_mm: f64,
    /// Greatest speed, mm/s.
    pub velocity_mm_s: f64,
    /// Greatest acceleration, mm/s².
    pub acceleration_mm_s2: f64,
    /// Greatest jerk, mm/s³.
    pub jerk_mm_s3: f64,
    /// Where the last three come from.
    pub limits: Provenance,
    /// Its direction in machine coordinates, for machines with a `chain`; default: that of its
    /// name. Positive is the tool moving that way over the workpiece.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f64; 3]>,
    /// What its words in programs count; positions and limits of this file are never diameters.
    #[serde(default, skip_serializing_if = "Words::are_usual")]
    pub words: Words,
}

/// A rotary axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RotaryAxis {
    /// Least position, degrees; without it and `max_deg`: unlimited turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_deg: Option<f64>,
    /// Greatest position, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_deg: Option<f64>,
    /// Greatest speed, degrees/s.
    pub velocity_deg_s: f64,
    /// Greatest acceleration, degrees/s².
    pub acceleration_deg_s2: f64,
    /// Greatest jerk, degrees/s³.
    pub jerk_deg_s3: f64,
    /// Where the last three come from.
    pub limits: Provenance,
    /// Its direction in machine coordinates while all axes read 0, for machines with a `chain`;
    /// default: that of its name. Positive is the tool going round the workpiece by the right-hand
    /// rule (ISO 841); the other way round for an axis that counts the workpiece's own turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f64; 3]>,
    /// A point on it in machine coordinates while all axes read 0, for machines with a `chain`, mm;
    /// default: the origin.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub point_mm: Option<[f64; 3]>,
}

/// All axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Axes")]
pub struct AxisTables {
    /// Along the blade. A machine with a `chain` may be without one of X, Y, Z: the chain does not
    /// name it, and the tool stands at 0 of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x: Option<LinearAxis>,
    /// Across.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y: Option<LinearAxis>,
    /// Towards the spindle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub z: Option<LinearAxis>,
    /// Of a second head, along X where the file gives no direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub u: Option<LinearAxis>,
    /// Of a second head, along Y where the file gives no direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub v: Option<LinearAxis>,
    /// Of a second head, along Z where the file gives no direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<LinearAxis>,
    /// Rotary axis A: on a machine without a `chain` the table about X.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub a: Option<RotaryAxis>,
    /// Rotary axis B: on a machine without a `chain` the head that pivots in the XZ plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub b: Option<RotaryAxis>,
    /// Rotary axis C.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub c: Option<RotaryAxis>,
}

/// A second head: its tool cuts the same workpiece at the same time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SecondHead {
    /// All axes from the workpiece to its tool: first those that it shares with the first chain, in
    /// the same order, then U, V, W and perhaps a rotary one of its own.
    pub chain: Vec<AxisName>,
    /// Its spindle.
    pub spindle: Spindle,
}

/// A machine file: a `chain` of axes, or in its place a rotary table about X and a pivoting head
/// (`table`, `head`). [`MachineFile::build`] makes the machine of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MachineFile {
    /// Short name, for headers.
    pub name: String,
    /// One line about it.
    #[serde(default)]
    pub description: String,
    /// Greatest diameter that turns freely about the table's axis, mm.
    pub swing_diameter_mm: f64,
    /// How the blade sits on it.
    pub mount: Mount,
    /// The rotary table, on a machine without a `chain`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub table: Option<Table>,
    /// The pivoting head, on a machine without a `chain`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub head: Option<HeadTable>,
    /// All axes from the workpiece to the tool: X, Y, Z (or two of them, on a lathe without Y) and
    /// one or two rotary axes. Left out: a table about X and a pivoting head.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub chain: Vec<AxisName>,
    /// The spindle of a machine with a `chain`; default: gauge point at the origin, tool axis along
    /// Z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spindle: Option<Spindle>,
    /// A second head, on a machine with a `chain`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<SecondHead>,
    /// Travel and dynamic limits.
    pub axes: AxisTables,
}

impl AxisTables {
    /// X, Y, Z, U, V or W by its name.
    pub(super) fn linear(&self, name: AxisName) -> Option<&LinearAxis> {
        match name {
            AxisName::X => self.x.as_ref(),
            AxisName::Y => self.y.as_ref(),
            AxisName::Z => self.z.as_ref(),
            AxisName::U => self.u.as_ref(),
            AxisName::V => self.v.as_ref(),
            AxisName::W => self.w.as_ref(),
            _ => None,
        }
    }
    /// Whether there is a table for an axis.
    pub(super) fn has(&self, name: AxisName) -> bool {
        self.linear(name).is_some() || self.rotary(name).is_some()
    }
    /// A rotary axis by its name.
    pub fn rotary(&self, name: AxisName) -> Option<&RotaryAxis> {
        match name {
            AxisName::A => self.a.as_ref(),
            AxisName::B => self.b.as_ref(),
            AxisName::C => self.c.as_ref(),
            _ => None,
        }
    }
}

impl LinearAxis {
    pub(super) fn limits(&self) -> AxisLimits {
        AxisLimits {
            travel: Some([self.min_mm, self.max_mm]),
            velocity: self.velocity_mm_s,
            acceleration: self.acceleration_mm_s2,
            jerk: self.jerk_mm_s3,
            provenance: self.limits,
        }
    }
}

impl RotaryAxis {
    pub(super) fn limits(&self) -> AxisLimits {
        AxisLimits {
            travel: self.min_deg.zip(self.max_deg).map(|(lo, hi)| [lo.to_radians(), hi.to_radians()]),
            velocity: self.velocity_deg_s.to_radians(),
            acceleration: self.acceleration_deg_s2.to_radians(),
            jerk: self.jerk_deg_s3.to_radians(),
            provenance: self.limits,
        }
    }
}
