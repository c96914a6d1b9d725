//! Along a wall of the channel: schedules that try the channel, not the machine.
//!
//! The tool is kept as near to the part as the channel says it may come, at every location. Where
//! the channel is right, such a schedule touches nothing; moved outwards by a fraction of a degree
//! it does, at the places that the channel names.

use super::{ScheduleOptions, curve};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::Result;
use crate::observe::{Doubt, Observer, Warning};
use crate::{Error, Stage};

/// `theta_min` (kind `lower-wall`) or `theta_max` (`upper-wall`) of every row, moved outwards by
/// `beyond_wall_deg`.
pub(super) fn plan(
    kind: ScheduleKind,
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    observer.check(Stage::Schedule)?;
    let beyond = options.settings.beyond_wall_deg.to_radians();
    let wall = |r: &crate::artifact::channel::ChannelRow| match kind {
        ScheduleKind::LowerWall => r.theta_min - beyond,
        _ => r.theta_max + beyond,
    };
    let theta: Vec<f64> = channel.rows.iter().map(wall).collect();
    if !theta.iter().all(|t| t.is_finite()) {
        return Err(Error::usage(Stage::Schedule, "the channel has walls that are not finite"));
    }
    let out = curve::through(kind, path, theta, channel)?;
    let doubt = Doubt::AlongWall { beyond_deg: options.settings.beyond_wall_deg, reversals: out.reversals };
    observer.warn(Warning { stage: Stage::Schedule, doubt });
    Ok(out)
}
