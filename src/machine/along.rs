//! Axis positions of a tool that stands on a cone of its own.
//!
//! On the cone about the blade axis a position is a function of θ over all turns, whatever came before
//! ([`Machine::inverse`]). On any other cone the rotary axes reach a tool axis in two ways and over many turns:
//! there the way nearest to where they stood is taken, so that they move on without a jump.

use super::Machine;
use crate::artifact::Stand;

impl Machine {
    /// Axis positions (mm, rad) of a tool that stands so, those nearest to `near` where several bring it there;
    /// `None`: near 0. `gauge_length_mm` as in [`Machine::inverse`]. Not numbers where the machine does not reach it.
    pub fn place(&self, stand: &Stand, near: Option<&[f64; 5]>, gauge_length_mm: f64) -> [f64; 5] {
        if stand.cone.is_about_blade() {
            return self.inverse(&stand.centre, stand.theta, stand.cone.lean_rad, gauge_length_mm);
        }
        let rotary = self.turn_to(stand, near);
        let [x, y, z] = self.linear_at(&stand.centre, rotary, gauge_length_mm);
        [x, y, z, rotary[0], rotary[1]]
    }

    /// Rotary positions (rad) of a tool that stands so, as [`Machine::place`] has them.
    pub fn turn_to(&self, stand: &Stand, near: Option<&[f64; 5]>) -> [f64; 2] {
        if stand.cone.is_about_blade() {
            return self.rotary_of(stand.theta, stand.cone.lean_rad);
        }
        let near = near.map_or([0.0; 2], |q| [q[3], q[4]]);
        self.rotary_of_axis(&stand.axis(), near).unwrap_or([f64::NAN; 2])
    }

    /// Axis positions along a motion, each nearest to those before it.
    pub fn along<'a>(&self, stands: impl IntoIterator<Item = &'a Stand>, gauge_length_mm: f64) -> Vec<[f64; 5]> {
        let mut out: Vec<[f64; 5]> = Vec::new();
        for stand in stands {
            let placed = self.place(stand, out.last(), gauge_length_mm);
            out.push(placed);
        }
        out
    }
}
