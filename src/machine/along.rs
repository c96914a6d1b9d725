//! Axis positions of a tool that stands on a cone of its own.
//!
//! On the cone about the blade axis a position is a function of θ over all turns, whatever came
//! before ([`Machine::inverse`]). On any other cone the rotary axes reach a tool axis in two ways
//! and over many turns: there the way nearest to where they stood is taken, so that they move on
//! without a jump.

use super::Machine;
use super::chain::Held;
use crate::artifact::{Axes, AxisRows, Stand};

impl Machine {
    /// Axis positions (mm, rad) of a tool that stands so, those nearest to `near` where several
    /// bring it there; `None`: near 0. `gauge_length_mm` as in [`Machine::inverse`]. Not numbers
    /// where the machine does not reach it.
    pub fn place(&self, stand: &Stand, near: Option<&[f64]>, gauge_length_mm: f64) -> Axes {
        if stand.cone.is_about_blade() {
            return self.inverse(&stand.centre, stand.theta, stand.cone.lean_rad, gauge_length_mm);
        }
        self.linear_at(&stand.centre, &self.turn_to(stand, near), gauge_length_mm)
    }

    /// The rotary axes (rad) where a tool stands so, as [`Machine::place`] has them.
    pub fn turn_to(&self, stand: &Stand, near: Option<&[f64]>) -> Axes {
        if stand.cone.is_about_blade() {
            return self.rotary_of(stand.theta, stand.cone.lean_rad);
        }
        let count = self.axes().len();
        let near = near.map_or(Axes::of_default(count), Axes::from);
        self.rotary_of_axis(&stand.axis(), &near).unwrap_or(Axes::from_fn(count, |_| f64::NAN))
    }

    /// Axis positions along a motion, each nearest to those before it.
    pub fn along(&self, stands: impl IntoIterator<Item = Stand>, gauge_length_mm: f64) -> AxisRows {
        let (head, count) = (self.head(), self.axes().len());
        let stands = stands.into_iter();
        let mut out = AxisRows::with_capacity(count, stands.size_hint().0);
        let mut held: Option<Held> = None;
        for stand in stands {
            let lean_rad = stand.cone.lean_rad;
            if stand.cone.is_about_blade() && !held.as_ref().is_some_and(|h| h.is_at(lean_rad)) {
                held = head.held(lean_rad, gauge_length_mm);
            }
            if let Some(held) = held.as_ref().filter(|_| stand.cone.is_about_blade()) {
                let mut row = Axes::of_default(count);
                head.place_held(&stand.centre, stand.theta, held, &mut row);
                out.push(&row);
            } else {
                let last = out.len().checked_sub(1).and_then(|k| out.get(k));
                let placed = self.place(&stand, last, gauge_length_mm);
                out.push(&placed);
            }
        }
        out
    }
}
