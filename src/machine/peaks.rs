//! What a motion asks of the axes at most.

use super::Machine;
use crate::artifact::{AxisMotion, AxisRows};

/// Greatest velocity, acceleration and jerk of one axis over a motion.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxisPeak {
    /// Axis.
    pub axis: String,
    /// mm or degrees per second.
    pub velocity: f64,
    /// Per second squared.
    pub acceleration: f64,
    /// Per second cubed.
    pub jerk: f64,
}

impl Machine {
    /// Peaks of every axis; rotary axes in degrees.
    pub fn peaks(&self, motion: &AxisMotion) -> Vec<AxisPeak> {
        let greatest = |rows: &AxisRows, i: usize| rows.iter().map(|r| r[i].abs()).fold(0.0, f64::max);
        let peak = |(i, axis): (usize, &super::Axis)| AxisPeak {
            axis: axis.name.clone(),
            velocity: axis.shown(greatest(&motion.velocity, i)),
            acceleration: axis.shown(greatest(&motion.acceleration, i)),
            jerk: axis.shown(greatest(&motion.jerk, i)),
        };
        self.axes().iter().enumerate().map(peak).collect()
    }
}
