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

/// A hub is a surface of revolution: its normal has no part round the rotor axis. A fillet has,
/// more than this where it is known exactly (sine).
const ROUND: f64 = 0.01;
/// Facets of a mesh stand up to this much round the axis (sine).
const ROUND_FACETS: f64 = 0.1;
/// The hub faces away from the rotor axis by at least this (cosine): no faces of the disc.
const OUTWARDS: f64 = 0.2;

impl Wheel {
    /// Whether a place with this outward unit normal is on the hub: on a surface of revolution
    /// about the rotor axis that faces away from it. `by_facets`: the surface is a mesh.
    pub fn is_hub(&self, point: &Point, normal: &Vector, by_facets: bool) -> bool {
        let Some(out) = (point - self.foot(point)).try_normalize(1e-9) else { return false };
        let round = self.axis.cross(&out);
        let most = if by_facets { ROUND_FACETS } else { ROUND };
        normal.dot(&round).abs() <= most && normal.dot(&out) >= OUTWARDS
    }

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

/// Cylindrical coordinates about a rotor axis, the angle from the blade in hand.
pub struct RotorFrame {
    wheel: Wheel,
    radial: Vector,
    round: Vector,
}

impl RotorFrame {
    /// `None` where the rotor axis is along the blade.
    pub fn new(wheel: &Wheel) -> Option<Self> {
        let axis = wheel.axis.into_inner();
        let radial = (Vector::x() - axis * axis.x).try_normalize(1e-9)?;
        Some(RotorFrame { wheel: *wheel, radial, round: axis.cross(&radial) })
    }

    /// The wheel.
    pub fn wheel(&self) -> &Wheel {
        &self.wheel
    }

    /// The rotor axis.
    pub fn axis(&self) -> Vector {
        self.wheel.axis.into_inner()
    }

    /// The angle from one blade to the next, rad.
    pub fn pitch_rad(&self) -> f64 {
        TAU / f64::from(self.wheel.blades.max(1))
    }

    /// A point by its place along the axis, its angle and its distance from the axis.
    pub fn point(&self, z_mm: f64, angle_rad: f64, radius_mm: f64) -> Point {
        let (s, c) = angle_rad.sin_cos();
        self.wheel.origin + self.axis() * z_mm + (self.radial * c + self.round * s) * radius_mm
    }

    /// Place along the axis, angle and distance from the axis of a point.
    pub fn of(&self, p: &Point) -> [f64; 3] {
        let v = p - self.wheel.origin;
        let (a, b) = (v.dot(&self.radial), v.dot(&self.round));
        [v.dot(&self.axis()), b.atan2(a), a.hypot(b)]
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn a_cone_about_the_axis_is_a_hub_and_a_blade_is_none() {
        let wheel = Wheel { axis: Vector::z_axis(), origin: Point::new(1.0, 2.0, 3.0), blades: 7 };
        for k in 0..20 {
            let (s, c) = (0.3 * f64::from(k)).sin_cos();
            let (out, round) = (Vector::new(c, s, 0.0), Vector::new(-s, c, 0.0));
            let at = wheel.origin + out * 40.0 + Vector::z() * f64::from(k);
            let tilted = |by: &Vector, rad: f64| out * rad.cos() + by * rad.sin();
            assert!(wheel.is_hub(&at, &out, false) && wheel.is_hub(&at, &tilted(&Vector::z(), 1.2), false));
            // A face of the disc, the bore, a fillet, a blade.
            assert!(!wheel.is_hub(&at, &Vector::z(), false) && !wheel.is_hub(&at, &-out, false));
            assert!(!wheel.is_hub(&at, &tilted(&round, 0.02), false) && wheel.is_hub(&at, &tilted(&round, 0.02), true));
            assert!(!wheel.is_hub(&at, &tilted(&round, 0.3), true) && !wheel.is_hub(&at, &round, true));
        }
        assert!(!wheel.is_hub(&wheel.origin, &Vector::x(), false));
    }

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
