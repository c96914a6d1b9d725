//! What the user may ask of the channel.

use crate::error::{Error, Result, Stage};
use crate::tool::{CLEARANCE_MM, HOLDER_CLEARANCE_MM};

/// Least and greatest angle between tool axis and surface normal where nobody asks for others,
/// degrees.
pub const CONTACT_ANGLE_DEG: [f64; 2] = [0.0, 90.0];
/// Tolerance of the channel's ends where nobody asks for another, degrees.
pub const TOLERANCE_DEG: f64 = 0.01;

/// Options of [`plan`](super::plan).
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelOptions {
    /// Room that taper and shank keep from the part, mm.
    pub clearance_mm: f64,
    /// Room that the holder keeps from the part, mm.
    pub holder_clearance_mm: f64,
    /// Least angle between tool axis and surface normal, rad. Near the tip of the ball the cutting
    /// speed vanishes; a pivot B of a few degrees keeps walls parallel to the blade axis away from
    /// the tip already, so that 0 is a fair default (a limit above it cuts the channel in two
    /// wherever the normal comes near the axis).
    pub contact_angle_min_rad: f64,
    /// Greatest angle between tool axis and surface normal, rad. Over 90° the ball would cut with
    /// its upper half.
    pub contact_angle_max_rad: f64,
    /// Limits of θ from those of the rotary axis, rad, unwrapped; `None`: it turns without end.
    pub theta_limits_rad: Option<[f64; 2]>,
    /// Tolerance of the channel's ends, rad; always on the safe side.
    pub tolerance_rad: f64,
    /// Prove that the walls hold at every time of the moves between places, and move them inwards
    /// where they do not. Takes milliseconds a move; otherwise walls are taken as straight between
    /// places.
    pub prove_moves: bool,
    /// Locations, in order, whose moves to the next are proven even without `prove_moves`.
    pub prove_at: Vec<usize>,
    /// Move the ends that the part binds out to where exact faces bind them, instead of keeping the
    /// deflection of their mesh as room; nothing changes where the part is a mesh. With
    /// `prove_moves` what the index of the part lies off it is kept as room instead, some
    /// ten-thousandths of the ball's radius where it is the finer one. Takes about a fifth of a
    /// millisecond of processor time a location.
    pub exact_ends: bool,
    /// Greatest distance between ball centres that are looked at, mm: longer moves get locations
    /// between their ends.
    pub max_step_mm: f64,
}

impl Default for ChannelOptions {
    fn default() -> Self {
        ChannelOptions {
            clearance_mm: CLEARANCE_MM,
            holder_clearance_mm: HOLDER_CLEARANCE_MM,
            contact_angle_min_rad: CONTACT_ANGLE_DEG[0].to_radians(),
            contact_angle_max_rad: CONTACT_ANGLE_DEG[1].to_radians(),
            theta_limits_rad: None,
            tolerance_rad: TOLERANCE_DEG.to_radians(),
            prove_moves: false,
            prove_at: Vec::new(),
            exact_ends: false,
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
        let deg = f64::to_degrees;
        for (name, v) in [("clearance", self.clearance_mm), ("holder clearance", self.holder_clearance_mm)] {
            if !(v >= 0.0 && v.is_finite()) {
                return bad(format!("the {name} is {v} mm, it must be at least 0"));
            }
        }
        let (lo, hi) = (self.contact_angle_min_rad, self.contact_angle_max_rad);
        if !(lo >= 0.0 && hi <= std::f64::consts::PI && lo < hi) {
            return bad(format!(
                "the contact angle must lie within {}° to {}°, an empty or impossible range",
                deg(lo),
                deg(hi)
            ));
        }
        if !(self.tolerance_rad >= 1e-6 && self.tolerance_rad <= 0.1) {
            return bad(format!(
                "the channel's tolerance is {}°, it must lie between 0.0001° and 5°",
                deg(self.tolerance_rad)
            ));
        }
        if !(self.max_step_mm > 1e-3 && self.max_step_mm.is_finite()) {
            return bad(format!("the channel's step is {} mm, it must be over 0.001 mm", self.max_step_mm));
        }
        Ok(())
    }
}
