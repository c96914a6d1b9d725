//! Options of the schedule stage.

use super::settings::ScheduleSettings;
use crate::error::{Error, Result, Stage};
use crate::settings::with_settings;

/// Options of [`super::plan`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScheduleOptions {
    /// What the job asks of it. Which kind is made is said to [`super::plan`]; `kind` is not looked
    /// at.
    pub settings: ScheduleSettings,
    /// Length over which θ stands still on either side of a base point, mm; `None`: the best of a
    /// few shares of the turn's length.
    pub level_stretch_mm: Option<f64>,
    /// θ at both ends of the path, where it is given, rad: kinds `optimal`, `time` and `piecewise`
    /// keep to it. No margin is kept from the walls then, since an end may be on one.
    pub ends_rad: Option<[f64; 2]>,
    /// Least and greatest offset of the tool from the blade axis that the machine has for kind
    /// `eccentric`, mm; `None`: any.
    pub offset_range_mm: Option<[f64; 2]>,
    /// Radius of the disc that the cutter's corner rolls over, mm; 0 for a ball. Kind `eccentric`
    /// keeps the offset of its centre, which turns about the corner's.
    pub disc_radius_mm: f64,
    /// What the rotary axis can follow at the programmed feed: kind `time` needs it, `piecewise`
    /// chooses by it.
    pub pace: Option<Pace>,
    /// No bound is proven but that of the measure: for curves of which the peak does not count.
    pub own_bound_alone: bool,
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
    /// The multiple of the axis' limits that a schedule with these peaks (rad/mm, rad/mm²) needs to
    /// keep the feed.
    pub(super) fn needed(&self, rate: f64, second: f64) -> f64 {
        (rate / self.rate).max(second / self.second)
    }
}

with_settings!(ScheduleOptions, ScheduleSettings);

impl ScheduleOptions {
    /// Checks all values.
    ///
    /// # Errors
    /// Kind `Usage`, naming the key and its limit.
    pub fn validate(&self) -> Result<()> {
        self.settings.check(Stage::Schedule)?;
        match self.level_stretch_mm {
            Some(l) if !(l > 0.0 && l.is_finite()) => Err(Error::usage(
                Stage::Schedule,
                format!("schedule.level_stretch_mm is {l}, it must be greater than 0"),
            )),
            _ => Ok(()),
        }
    }
}
