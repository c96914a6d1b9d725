//! Angles and whole turns. Checks round an angle as planners do: that is arithmetic, and no plan
//! depends on it.

use std::f64::consts::TAU;

/// The angle within half a turn, rad.
pub fn within_half_turn(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// The angle, whole turns on or back, that is nearest to another, rad.
pub fn nearest_turn(angle: f64, to: f64) -> f64 {
    angle + TAU * ((to - angle) / TAU).round()
}
