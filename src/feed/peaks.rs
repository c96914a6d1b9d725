//! What the axes would have to do at constant feed: to compare schedules.

use super::FeedOptions;
use crate::artifact::{Axes, Schedule, Toolpath};
use crate::error::Result;
use crate::machine::Machine;

/// Greatest absolute velocity, acceleration and jerk of each axis, in the order of
/// [`Machine::axes`]; mm or rad, and s.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxisPeaks {
    /// Velocities, mm/s or rad/s.
    pub velocity: Axes,
    /// Accelerations, mm/s² or rad/s².
    pub acceleration: Axes,
    /// Jerks, mm/s³ or rad/s³.
    pub jerk: Axes,
}

/// Peaks over all locations at the constant programmed feed, whatever the machine's limits: `q' F`,
/// `q'' F²` and `q''' F³`.
///
/// # Errors
/// As [`super::plan`].
pub fn peaks(path: &Toolpath, schedule: &Schedule, machine: &Machine, options: &FeedOptions) -> Result<AxisPeaks> {
    let curve = super::axis_curve(path, schedule, machine, options)?;
    let feed = options.settings.feed_mm_min / 60.0;
    let none = Axes::of_default(curve.functions());
    let mut out = AxisPeaks { velocity: none, acceleration: none, jerk: none };
    let s = curve.abscissae();
    for i in 0..s.len() {
        let interval = i.min(s.len() - 2);
        for k in 0..curve.functions() {
            let [_, q1, q2] = super::at(&curve, interval, k, s[i] - s[interval]);
            out.velocity[k] = out.velocity[k].max((q1 * feed).abs());
            out.acceleration[k] = out.acceleration[k].max((q2 * feed * feed).abs());
            let third = curve.coefficients(interval, k).map_or(0.0, |c| 6.0 * c[3]);
            out.jerk[k] = out.jerk[k].max((third * feed * feed * feed).abs());
        }
    }
    Ok(out)
}
