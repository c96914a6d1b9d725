//! Motion of the machine's axes over time.

use super::{AxisRows, packed};

/// One row per cutter location, with a column for each axis of the machine (`Machine::axes`).
/// Linear axes in mm, mm/s, …; rotary axes in rad, rad/s, ….
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxisMotion {
    /// Time at each cutter location, s, from the start of the whole motion: the first location's is
    /// later than 0 where a lead comes before it.
    #[serde(with = "packed")]
    pub t_s: Vec<f64>,
    /// Axis positions.
    pub position: AxisRows,
    /// Axis velocities.
    pub velocity: AxisRows,
    /// Axis accelerations.
    pub acceleration: AxisRows,
    /// Axis jerks just after each location (difference quotients of the accelerations where jerk
    /// was not limited).
    pub jerk: AxisRows,
    /// Feed of the ball centre towards each location, mm/s.
    #[serde(with = "packed")]
    pub feed: Vec<f64>,
    /// From the first location to the last, s.
    pub time_s: f64,
}
