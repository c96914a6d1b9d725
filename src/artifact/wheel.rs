//! The wheel that a blade belongs to.

use std::f64::consts::TAU;

use crate::geometry::{Point, Rigid, Vector};
use nalgebra::{Unit, UnitQuaternion};

/// A wheel of equal blades, evenly spaced about its rotor axis; blade frame of the blade in hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wheel {
    /// Rotor axis, unit.
    pub axis: Unit<Vector>,
    /// A point on it, mm.
    pub origin: Point,
    /// Number of blades.
    pub blades: u32,
}

/// The wheel that a model shows; frame of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelWheel {
    /// Rotor axis, unit.
    pub axis: Vector,
    /// A point on it, mm.
    pub through: Point,
    /// How often the wheel repeats in a turn.
    pub blades: u32,
    /// The model has all of them; else it is one sector.
    pub whole: bool,
}

impl Wheel {
    /// The turn about the rotor axis that brings the blade in hand, number 1, to another one.
    pub fn turn_to(&self, blade: u32) -> Rigid {
        let angle = TAU * f64::from(blade.saturating_sub(1)) / f64::from(self.blades.max(1));
        let turn = UnitQuaternion::from_axis_angle(&self.axis, angle);
        Rigid::rotation_wrt_point(turn, self.origin)
    }

    /// The point of the rotor axis nearest to a point.
    pub fn foot(&self, p: &Point) -> Point {
        self.origin + self.axis.into_inner() * (p - self.origin).dot(&self.axis)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn all_turns_together_come_back() {
        let wheel = Wheel {
            axis: Unit::new_normalize(Vector::new(1.0, 0.2, -0.3)),
            origin: Point::new(3.0, -2.0, 9.0),
            blades: 7,
        };
        let p = Point::new(100.0, 4.0, 30.0);
        let radius = |p: &Point| (p - wheel.foot(p)).norm();
        let mut q = p;
        for _ in 0..7 {
            q = wheel.turn_to(2) * q;
            assert!((radius(&q) - radius(&p)).abs() < 1e-9);
        }
        assert!((q - p).norm() < 1e-9);
        assert!((wheel.turn_to(1) * p - p).norm() < 1e-12);
        assert!((wheel.turn_to(3) * p - wheel.turn_to(2) * (wheel.turn_to(2) * p)).norm() < 1e-9);
    }
}
