//! What the user may ask of the channel.

use super::settings::ChannelSettings;
use crate::artifact::{AxisTravel, Sweep};
use crate::error::{Error, Result, Stage};
use crate::settings::with_settings;

/// Options of [`plan`](super::plan).
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelOptions {
    /// What the job asks of it; `sweep_b` is not looked at.
    pub settings: ChannelSettings,
    /// Limits of θ from those of the rotary axis, rad, unwrapped; `None`: it turns without end.
    pub theta_limits_rad: Option<[f64; 2]>,
    /// Travel of linear axes that limits θ where the tool goes round with one lean.
    pub travel: Vec<AxisTravel>,
    /// How θ goes along the path. Angles are unwrapped about the surface normal's on a path that
    /// goes round, about 0 on one that swings.
    pub sweep: Sweep,
    /// Locations, in order, whose moves to the next are proven even without `prove_moves`.
    pub prove_at: Vec<usize>,
    /// Greatest distance between ball centres that are looked at, mm: longer moves get locations
    /// between their ends.
    pub max_step_mm: f64,
}

with_settings!(ChannelOptions, ChannelSettings);

impl Default for ChannelOptions {
    fn default() -> Self {
        ChannelOptions {
            settings: ChannelSettings::default(),
            theta_limits_rad: None,
            travel: Vec::new(),
            sweep: Sweep::Round,
            prove_at: Vec::new(),
            max_step_mm: 1.5,
        }
    }
}

impl ChannelOptions {
    /// Checks all values.
    ///
    /// # Errors
    /// Kind `Usage`, naming the value and its limit.
    pub fn validate(&self) -> Result<()> {
        let bad = |m: String| Err(Error::usage(Stage::Channel, m));
        self.settings.check(Stage::Channel)?;
        let (lo, hi) = (self.settings.contact_angle_min_deg, self.settings.contact_angle_max_deg);
        if lo >= hi {
            return bad(format!("the contact angle must lie within {lo}° to {hi}°, an empty or impossible range"));
        }
        if let Some([least, greatest]) = self.settings.offset_mm
            && !(least <= greatest && (greatest - least).is_finite())
        {
            return bad(format!(
                "channel.offset_mm is [{least}, {greatest}], the second must not be less than the first"
            ));
        }
        if !(self.max_step_mm > 1e-3 && self.max_step_mm.is_finite()) {
            return bad(format!("the channel's step is {} mm, it must be over 0.001 mm", self.max_step_mm));
        }
        Ok(())
    }
}
