//! What the axes would have to do at constant feed: to compare schedules.

use super::FeedOptions;
use crate::artifact::{Axes, ProgrammedCurve, Schedule, Toolpath};
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
    peaks_on(path, schedule, None, machine, options)
}

/// As [`peaks`], on the curve that a path was given; there at both ends and in the middle of every
/// interval.
///
/// # Errors
/// As [`super::plan_on`].
pub fn peaks_on(
    path: &Toolpath,
    schedule: &Schedule,
    on: Option<&ProgrammedCurve>,
    machine: &Machine,
    options: &FeedOptions,
) -> Result<AxisPeaks> {
    let curve = super::axis_curve(path, schedule, on, machine, options)?.0;
    let feed = options.settings.feed_mm_min / 60.0;
    let none = Axes::of_default(curve.functions());
    let mut out = AxisPeaks { velocity: none, acceleration: none, jerk: none };
    let s = curve.abscissae();
    for i in 0..s.len() {
        let interval = i.min(s.len() - 2);
        for k in 0..curve.functions() {
            let here = s[i] - s[interval];
            let length = s[interval + 1] - s[interval];
            let bent = [here, 0.5 * length, length];
            for t in if curve.quintic(interval, k).is_some() { &bent[..] } else { &bent[..1] } {
                let [_, q1, q2] = curve.at(interval, k, *t);
                out.velocity[k] = out.velocity[k].max((q1 * feed).abs());
                out.acceleration[k] = out.acceleration[k].max((q2 * feed * feed).abs());
                let third = curve.third(interval, k, *t);
                out.jerk[k] = out.jerk[k].max((third * feed * feed * feed).abs());
            }
        }
    }
    Ok(out)
}
