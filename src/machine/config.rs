//! The machine file: what is in it, its checks, its limits in inner units.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::artifact::axis_motion::AXES;
use crate::error::{Error, Result, Stage};

/// The built-in demo machine as its file.
pub const DEMO_TOML: &str = include_str!("../../models/machines/demo_table_head.toml");

/// Where limits of velocity, acceleration and jerk come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Provenance {
    /// Of the usual size for such a machine; results on time are to be read with that in mind.
    Assumed,
    /// Measured on the machine, or its maker's figures.
    Measured,
}

/// What positive `A` turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PositiveA {
    /// The tool goes round the workpiece by the right-hand rule about +X; the table turns the other way (ISO 841).
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

/// How the blade sits on the machine while `A = 0`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mount {
    /// Origin of the blade frame in machine coordinates, mm.
    pub offset_mm: [f64; 3],
    /// Angle by which the blade is turned about X, right-hand rule, degrees.
    #[serde(default)]
    pub clamping_deg: f64,
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
#[serde(deny_unknown_fields)]
pub struct Head {
    /// From the pivot to the spindle's gauge line, mm.
    pub pivot_length_mm: f64,
    /// How far the spindle's axis passes the pivot by, along X of the machine while B = 0, mm; 0: they meet.
    #[serde(default)]
    pub spindle_offset_mm: f64,
    /// Sense of `B`.
    #[serde(default)]
    pub positive_b_leans: PositiveB,
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
}

/// All five axes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Axes {
    /// Along the blade.
    pub x: LinearAxis,
    /// Across.
    pub y: LinearAxis,
    /// Towards the spindle.
    pub z: LinearAxis,
    /// Rotary table about X.
    pub a: RotaryAxis,
    /// Pivoting head in the XZ plane.
    pub b: RotaryAxis,
}

/// A machine with a rotary table about X and a pivoting head; see the module's page for the kinematics.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Short name, for headers.
    pub name: String,
    /// One line about it.
    #[serde(default)]
    pub description: String,
    /// Greatest diameter that turns freely about the table's axis, mm.
    pub swing_diameter_mm: f64,
    /// How the blade sits on it.
    pub mount: Mount,
    /// The rotary table.
    pub table: Table,
    /// The pivoting head.
    pub head: Head,
    /// Travel and dynamic limits.
    pub axes: Axes,
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

impl LinearAxis {
    fn limits(&self) -> AxisLimits {
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
    fn limits(&self) -> AxisLimits {
        AxisLimits {
            travel: self.min_deg.zip(self.max_deg).map(|(lo, hi)| [lo.to_radians(), hi.to_radians()]),
            velocity: self.velocity_deg_s.to_radians(),
            acceleration: self.acceleration_deg_s2.to_radians(),
            jerk: self.jerk_deg_s3.to_radians(),
            provenance: self.limits,
        }
    }
}

impl Machine {
    /// The built-in demo machine ([`DEMO_TOML`]).
    ///
    /// # Errors
    /// As [`Machine::from_toml`]; the built-in file passes.
    pub fn demo() -> Result<Self> {
        Self::from_toml(DEMO_TOML, "built-in demo machine")
    }

    /// Reads a machine from the text of its file; `origin` names the file in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, or a value outside its range.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let machine: Machine = toml::from_str(text).map_err(|e| {
            let place = e.span().map(|s| {
                let before = text.get(..s.start).unwrap_or(text);
                format!(" line {}", before.matches('\n').count() + 1)
            });
            Error::usage(Stage::Machine, format!("{origin}{}: {}", place.unwrap_or_default(), e.message()))
                .advise("models/machines/demo_table_head.toml shows every key with its unit")
        })?;
        machine.validate(origin)?;
        Ok(machine)
    }

    /// Reads a machine file.
    ///
    /// # Errors
    /// Kind `InputOutput` where the file cannot be read, else as [`Machine::from_toml`].
    pub fn load(path: &Path) -> Result<Self> {
        let text = std::fs::read_to_string(path).map_err(|e| {
            Error::io(Stage::Machine, format!("cannot read the machine file {}: {e}", path.display())).caused_by(e)
        })?;
        Self::from_toml(&text, &path.display().to_string())
    }

    /// Limits of all axes in the order of [`AXES`].
    pub fn limits(&self) -> [AxisLimits; 5] {
        let a = &self.axes;
        [a.x.limits(), a.y.limits(), a.z.limits(), a.a.limits(), a.b.limits()]
    }

    /// The same machine with velocity, acceleration and jerk of all axes multiplied by `factor` (for sweeps over
    /// assumed limits).
    #[must_use]
    pub fn with_limits_scaled(mut self, factor: f64) -> Self {
        let a = &mut self.axes;
        for l in [&mut a.x, &mut a.y, &mut a.z] {
            l.velocity_mm_s *= factor;
            l.acceleration_mm_s2 *= factor;
            l.jerk_mm_s3 *= factor;
        }
        for r in [&mut a.a, &mut a.b] {
            r.velocity_deg_s *= factor;
            r.acceleration_deg_s2 *= factor;
            r.jerk_deg_s3 *= factor;
        }
        self
    }

    /// Checks all values; see [`Machine::from_toml`].
    fn validate(&self, origin: &str) -> Result<()> {
        let bad = |m: String| Err(Error::usage(Stage::Machine, format!("{origin}: {m}")));
        let finite = |key: &str, v: f64| {
            if v.is_finite() { Ok(()) } else { bad(format!("{key} is {v}, it must be a finite number")) }
        };
        for v in self.mount.offset_mm {
            finite("mount.offset_mm", v)?;
        }
        finite("mount.clamping_deg", self.mount.clamping_deg)?;
        finite("table.axis_y_mm", self.table.axis_y_mm)?;
        finite("table.axis_z_mm", self.table.axis_z_mm)?;
        finite("head.spindle_offset_mm", self.head.spindle_offset_mm)?;
        if !(self.head.pivot_length_mm >= 0.0 && self.head.pivot_length_mm.is_finite()) {
            return bad(format!("head.pivot_length_mm is {}, it must be at least 0", self.head.pivot_length_mm));
        }
        if !(self.swing_diameter_mm > 0.0 && self.swing_diameter_mm.is_finite()) {
            return bad(format!("swing_diameter_mm is {}, it must be greater than 0", self.swing_diameter_mm));
        }
        for (axis, r) in [("a", &self.axes.a), ("b", &self.axes.b)] {
            if r.min_deg.is_some() != r.max_deg.is_some() {
                return bad(format!("axes.{axis} has only one of min_deg and max_deg, give both or none"));
            }
        }
        for (name, l) in AXES.iter().zip(self.limits()) {
            let key = format!("axes.{}", name.to_lowercase());
            for (what, v) in [("velocity", l.velocity), ("acceleration", l.acceleration), ("jerk", l.jerk)] {
                if !(v > 0.0 && v.is_finite()) {
                    return bad(format!("{key}: {what} is {v}, it must be greater than 0"));
                }
            }
            if let Some([lo, hi]) = l.travel
                && !(lo < hi && lo.is_finite() && hi.is_finite())
            {
                return bad(format!("{key}: its least position is not below its greatest"));
            }
        }
        match self.limits()[4].travel {
            Some([lo, hi]) if lo.to_degrees() >= -89.9 && hi.to_degrees() <= 89.9 => Ok(()),
            _ => bad("axes.b must be limited to -89.9 … 89.9 degrees: at 90 the tool axis is along X".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::ErrorKind;

    #[test]
    fn the_demo_machine_reads_and_round_trips() {
        let m = Machine::demo().unwrap();
        let again = Machine::from_toml(&toml::to_string(&m).unwrap(), "again").unwrap();
        assert_eq!(m, again);
        let l = m.limits();
        assert_eq!(l[3].travel, None);
        assert!((l[4].travel.unwrap()[1].to_degrees() - 87.0).abs() < 1e-12);
        assert!(l.iter().all(|l| l.provenance == Provenance::Assumed));
        assert_eq!(l[0].travel, Some([0.0, 2800.0]));
        assert_eq!(m.with_limits_scaled(0.5).limits()[1].velocity, 0.5 * l[1].velocity);
    }

    #[test]
    fn bad_files_are_usage_errors_that_name_the_key() {
        let cases = [
            ("pivot_length_mm = 200.0", "pivot_length_mm = -1.0", "pivot_length_mm"),
            ("pivot_length_mm = 200.0", "pivot_length = 200.0", "pivot_length"),
            ("spindle_offset_mm = 0.0", "spindle_offset_mm = inf", "head.spindle_offset_mm"),
            ("positive_b_leans = \"plus-x\"", "positive_b_leans = \"up\"", "up"),
            ("velocity_deg_s = 180.0", "velocity_deg_s = 0.0", "axes.a: velocity"),
            ("max_deg = 87.0", "max_deg = 90.0", "axes.b"),
            ("max_deg = 87.0", "", "only one of"),
            ("max_mm = 330.0", "max_mm = -400.0", "axes.y"),
            ("offset_mm = [1400.0", "offset_mm = [nan", "offset_mm"),
            ("limits = \"assumed\"\n\n[axes.y]", "limits = \"guessed\"\n\n[axes.y]", "guessed"),
        ];
        for (from, to, names) in cases {
            let text = DEMO_TOML.replacen(from, to, 1);
            assert_ne!(text, DEMO_TOML, "{from}");
            let e = Machine::from_toml(&text, "m.toml").unwrap_err();
            assert_eq!(e.kind, ErrorKind::Usage);
            assert!(e.message.contains(names) && e.message.contains("m.toml"), "{}", e.message);
        }
        assert_eq!(Machine::load(Path::new("/nonexistent.toml")).unwrap_err().kind, ErrorKind::InputOutput);
    }
}
