//! The path beside its smooth curve, and beside the same path with touches that are merely evened:
//! what is gained over both is more than noise that went.

use serde::Serialize;

use super::Ground;
use crate::artifact::{ProgrammedCurve, Schedule, Toolpath};
use crate::error::Result;
use crate::feed;
use crate::observe::Observer;
use crate::plan::smoothing::{Before, smoothed};
use crate::smooth;

/// Greatest jerk of an axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AxisJerk {
    /// Axis.
    pub axis: String,
    /// At the programmed feed held constant, mm or degrees per second cubed.
    pub jerk: f64,
}

/// A path or its curve, with the same schedule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PathRun {
    /// `as it is`, `evened` or `smooth`.
    pub name: String,
    /// Blocks that a program of it has: straight moves, or pieces of the curve.
    pub blocks: usize,
    /// Of each axis.
    pub jerk: Vec<AxisJerk>,
    /// Machining time at its own best feed, without leads, s.
    pub time_s: f64,
}

/// All three; without the smooth one where the path stays as it is, which the observer gets as a
/// warning.
pub(super) fn all(ground: &Ground, schedule: &Schedule, observer: &dyn Observer) -> Result<Vec<PathRun>> {
    let before = Before { path: ground.path, channel: ground.channel, schedule };
    let even = smooth::evened(&ground.setup.blade.part, ground.path)?;
    let made = smoothed(ground.setup, before, None, observer)?;
    let mut out =
        vec![run("as it is", ground, (ground.path, schedule), None)?, run("evened", ground, (&even, schedule), None)?];
    if let Some(made) = made {
        out.push(run("smooth", ground, (&made.path, &made.schedule), Some(&made.curve))?);
    }
    Ok(out)
}

fn run(
    name: &str,
    ground: &Ground,
    (path, schedule): (&Toolpath, &Schedule),
    curve: Option<&ProgrammedCurve>,
) -> Result<PathRun> {
    let machine = &ground.setup.machine;
    let motion = feed::plan_on(path, schedule, curve, machine, ground.feed, &crate::observe::Silent)?;
    let peaks = feed::peaks_on(path, schedule, curve, machine, ground.feed)?;
    let jerk = machine.axes().iter().zip(peaks.jerk.iter());
    Ok(PathRun {
        name: name.into(),
        blocks: curve.map_or(path.locations.len().saturating_sub(1), ProgrammedCurve::blocks),
        jerk: jerk.map(|(axis, jerk)| AxisJerk { axis: axis.name.clone(), jerk: axis.shown(*jerk) }).collect(),
        time_s: motion.time_s,
    })
}
