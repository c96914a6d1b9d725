//! Motion of the machine's axes over time.

/// One row per cutter location, in each X, Y, Z, the rotary axis nearest to the workpiece and the other one (`Machine::axis_names`). Linear axes in mm, mm/s, …; rotary axes in rad, rad/s, ….
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxisMotion {
    /// Time at each cutter location, s, from the start of the whole motion: the first location's is later than 0 where a lead comes before it.
    pub t_s: Vec<f64>,
    /// Axis positions.
    pub position: Vec<[f64; 5]>,
    /// Axis velocities.
    pub velocity: Vec<[f64; 5]>,
    /// Axis accelerations.
    pub acceleration: Vec<[f64; 5]>,
    /// Axis jerks just after each location (difference quotients of the accelerations where jerk was not limited).
    pub jerk: Vec<[f64; 5]>,
    /// Feed of the ball centre towards each location, mm/s.
    pub feed: Vec<f64>,
    /// From the first location to the last, s.
    pub time_s: f64,
}
