//! Options of the schedule stage.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::artifact::schedule::{BaseAngle, Measure, Scope};
use crate::error::{Error, Result, Stage};

/// Options of [`super::plan`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ScheduleOptions {
    /// Distance that a `piecewise` schedule keeps from the walls of the channel, degrees. Between cutter locations
    /// the walls are known by linear interpolation only; this is what covers it. Where the channel is narrower than
    /// four margins, a quarter of its width is kept instead, with a warning.
    pub margin_deg: f64,
    /// Angle by which a `fixed` schedule leads the surface normal in the feed direction, degrees. 15 is in the
    /// middle of what CAM systems offer for ball-end finishing.
    pub lead_deg: f64,
    /// How far outside the channel the kinds `lower-wall` and `upper-wall` run, degrees: to see that a channel is tight.
    pub beyond_wall_deg: f64,
    /// Length over which θ stands still on either side of a base point, mm; absent: the best of a few shares of the
    /// turn's length.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub level_stretch_mm: Option<f64>,
    /// Where a `piecewise` schedule stands at the start of each turn.
    pub base_angle: BaseAngle,
    /// What an `optimal` schedule makes least.
    pub measure: Measure,
    /// Over how much of the path an `optimal` schedule is the best.
    pub scope: Scope,
    /// What the rotary axis can follow at the programmed feed: kind `time` needs it, `piecewise` chooses by it.
    #[serde(skip)]
    pub pace: Option<Pace>,
}

/// What the rotary axis can follow at full feed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Greatest velocity over the feed, rad/mm.
    pub rate: f64,
    /// Greatest acceleration over the square of the feed, rad/mm².
    pub second: f64,
    /// Length at both ends of the path over which the ball gains or loses its feed, mm, if the axis
    /// is to stand still there as nearly as it can. What it turns there it has to begin and end at
    /// the ball's own acceleration. 0: it need not stand still.
    pub standing_mm: f64,
}

impl Pace {
    /// The multiple of the axis' limits that a schedule with these peaks (rad/mm, rad/mm²) needs to keep the feed.
    pub(super) fn needed(&self, rate: f64, second: f64) -> f64 {
        (rate / self.rate).max(second / self.second)
    }
}

impl Default for ScheduleOptions {
    fn default() -> Self {
        ScheduleOptions {
            margin_deg: 0.5,
            lead_deg: 15.0,
            beyond_wall_deg: 0.0,
            level_stretch_mm: None,
            base_angle: BaseAngle::default(),
            measure: Measure::default(),
            scope: Scope::default(),
            pace: None,
        }
    }
}

impl ScheduleOptions {
    /// Checks all values.
    ///
    /// # Errors
    /// Kind `Usage`, naming the key and its limit.
    pub fn validate(&self) -> Result<()> {
        let bad = |m: String| Err(Error::usage(Stage::Schedule, m));
        if !(0.0..=45.0).contains(&self.margin_deg) {
            return bad(format!("schedule.margin_deg is {}, it must be from 0 to 45", self.margin_deg));
        }
        if !(-90.0..=90.0).contains(&self.lead_deg) {
            return bad(format!("schedule.lead_deg is {}, it must be from -90 to 90", self.lead_deg));
        }
        if !(0.0..=45.0).contains(&self.beyond_wall_deg) {
            return bad(format!("schedule.beyond_wall_deg is {}, it must be from 0 to 45", self.beyond_wall_deg));
        }
        match self.level_stretch_mm {
            Some(l) if !(l > 0.0 && l.is_finite()) => {
                bad(format!("schedule.level_stretch_mm is {l}, it must be greater than 0"))
            }
            _ => Ok(()),
        }
    }
}
