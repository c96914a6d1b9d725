//! Fixed lead to the surface normal: the baseline.

use super::{ScheduleOptions, curve};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Result, Stage};
use crate::numerics::angle::nearest_turn;
use crate::observe::{Doubt, Observer, Warning};

/// Normals closer to the axis of their cone than this have no azimuth worth following (sine of the
/// angle to the axis).
const ALONG_AXIS: f64 = 1e-6;

/// θ at every location.
pub(super) fn angles(path: &Toolpath, channel: &Channel, options: &ScheduleOptions) -> Vec<f64> {
    let lead = options.settings.lead_deg.to_radians();
    let near = channel.rows.first().map_or(0.0, |r| 0.5 * (r.theta_min + r.theta_max));
    let mut last = if near.is_finite() { near } else { 0.0 };
    let mut theta = Vec::with_capacity(path.locations.len());
    for (row, l) in path.locations.iter().enumerate() {
        if let Some(azimuth) = path.cone(row).theta_of(&l.normal, ALONG_AXIS) {
            last = nearest_turn(azimuth + lead, last);
        }
        theta.push(last);
    }
    theta
}

/// See the module's page. The curve is the natural cubic spline through the angles at the
/// locations.
pub(super) fn plan(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    observer.check(Stage::Schedule)?;
    let theta = angles(path, channel, options);
    let outside = theta
        .iter()
        .zip(&channel.rows)
        .filter(|(t, r)| !(**t >= r.theta_min - channel.tolerance_rad && **t <= r.theta_max + channel.tolerance_rad))
        .count();
    let out = curve::through(ScheduleKind::Fixed, path, theta, channel)?;
    if outside > 0 || out.reversals > 0 {
        let (locations, reversals) = (out.theta.len(), out.reversals);
        let doubt = Doubt::FixedLeavesChannel { lead_deg: options.settings.lead_deg, outside, locations, reversals };
        observer.warn(Warning { stage: Stage::Schedule, doubt });
    }
    Ok(out)
}
