//! Limits of the checks and how finely they look.

use super::settings::VerifySettings;
use crate::artifact::Wheel;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::{Direction, PathKind, SCALLOP_MM};
use crate::settings::with_settings;
use crate::tool::{CLEARANCE_MM, Chip, HOLDER_CLEARANCE_MM};

/// What a plan holds of its job. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// How turns lie.
    pub kind: PathKind,
    /// Climb or conventional milling.
    pub direction: Direction,
    /// Radius of the ball.
    pub radius_mm: f64,
    /// Stock that stays on the part.
    pub stock_mm: f64,
    /// Chord tolerance.
    pub chord_mm: f64,
    /// Height of the first ball centres.
    pub start_mm: f64,
    /// Height of the last ones; `None`: as far down as the tool comes.
    pub end_mm: Option<f64>,
    /// Greatest lean of the wall, rad.
    pub max_lean_rad: f64,
    /// Lean of the one cone about the blade axis that all locations have, rad; `None`: each has its
    /// own.
    pub b_rad: Option<f64>,
    /// Least and greatest angle between tool axis and surface normal, rad.
    pub contact_rad: [f64; 2],
    /// Limits of θ from those of the rotary axis, rad; `None`: it turns without end.
    pub theta_limits_rad: Option<[f64; 2]>,
    /// Tolerance of the channel's ends, rad.
    pub tolerance_rad: f64,
    /// How the schedule is made.
    pub schedule: ScheduleKind,
    /// Greatest feed, mm/min.
    pub feed_mm_min: f64,
    /// Radius of the leads; 0: straight.
    pub lead_radius_mm: f64,
    /// Least and greatest offset of the tool from the blade axis; `None`: any.
    pub offset_mm: Option<[f64; 2]>,
    /// What the teeth may cut; `None`: not looked at.
    pub chip: Option<Chip>,
    /// The wheel over whose hub the path goes; `None`: it goes round a blade.
    pub hub_of: Option<Wheel>,
}

/// Limits and sampling of [`super::check`]. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct VerifyOptions {
    /// What the job says of them.
    pub settings: VerifySettings,
    /// Scallop asked for, mm.
    pub scallop_mm: f64,
    /// Clearance asked for between the part and taper or shank, mm. What must be proven is less by
    /// `clearance_tolerance_mm`.
    pub clearance_mm: f64,
    /// Clearance asked for between the part and the holder, mm: likewise.
    pub holder_clearance_mm: f64,
    /// What the clearance check may miss between two of its samples, mm.
    pub clearance_resolution_mm: f64,
    /// What may be missing of a clearance asked for, mm. Default 0.005, or a hundredth of the
    /// clearance where that is more: what triangles are off exact faces, and what moves are told
    /// apart by. Planning keeps it between locations as well.
    pub clearance_tolerance_mm: f64,
    /// How far θ may leave the channel or turn back, degrees: rounding only. Default 1e-6.
    pub angle_tolerance_deg: f64,
    /// How far velocity and acceleration of an axis may exceed its limit, relative. Default 1e-4:
    /// rounding of times and positions.
    pub limit_tolerance: f64,
    /// What else the job asks for; `None`: the plan is judged by itself.
    pub asked: Option<Asked>,
}

with_settings!(VerifyOptions, VerifySettings);

impl Default for VerifyOptions {
    fn default() -> Self {
        VerifyOptions {
            settings: VerifySettings::default(),
            scallop_mm: SCALLOP_MM,
            clearance_mm: CLEARANCE_MM,
            holder_clearance_mm: HOLDER_CLEARANCE_MM,
            clearance_resolution_mm: CLEARANCE_RESOLUTION_MM,
            clearance_tolerance_mm: 0.005,
            angle_tolerance_deg: 1e-6,
            limit_tolerance: 1e-4,
            asked: None,
        }
    }
}

impl VerifyOptions {
    /// The least clearance that passes where `asked_mm` is asked for, mm.
    pub fn least_clearance(&self, asked_mm: f64) -> f64 {
        (asked_mm - self.clearance_tolerance_mm.max(TOLERATED * asked_mm)).max(0.0)
    }

    /// What is to be asked for where `least_mm` is to pass and nothing less.
    pub fn asked_clearance(&self, least_mm: f64) -> f64 {
        (least_mm + self.clearance_tolerance_mm).max(least_mm / (1.0 - TOLERATED))
    }
}

/// What checks of clearance may miss between two samples by default, mm: well below any clearance
/// asked for.
pub(super) const CLEARANCE_RESOLUTION_MM: f64 = 0.005;
/// Share of a clearance by which it may be missed.
const TOLERATED: f64 = 0.01;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_for_passes_at_the_least_and_not_below() {
        let options = VerifyOptions::default();
        for least_mm in [0.001, 0.1, 0.4949, 0.5, 5.0, 300.0] {
            let passes = options.least_clearance(options.asked_clearance(least_mm));
            assert!((passes - least_mm).abs() < 1e-12 * least_mm.max(1.0), "{least_mm} {passes}");
        }
    }
}
