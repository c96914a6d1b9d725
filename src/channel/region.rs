//! Pieces of a body as the tool sees them during a move, and how far a function with a known slope
//! may fall over them.
//!
//! A move takes the ball centre along a straight line from `−h` to `h` about its middle, while the
//! tool turns evenly by `±β` about the axis `x̂` of its cone and the cone evenly by `±ω`, a
//! rotation vector: at time `t` all is turned by `exp(tω) exp(tβx̂)`. Seen from the ball centre in
//! a frame that turns along, a point that is at `v` in the middle of the move is at
//!
//! ```text
//! v(t) = exp(−tβx̂) exp(−tω)(v − t h) = v + t w(v) + r,   w(v) = −h − (β x̂ + ω) × v,   −1 ≤ t ≤ 1
//! |r| ≤ b²(ρ + |h|)/2 + b|h|,   b = |β| + |ω|
//! ```
//!
//! with `ρ` the distance from the cone's axis where that stays (`ω = 0`), else from the ball
//! centre. The distance from a frustum of the tool is convex, so its tangent plane at one point
//! bounds it from below everywhere. Along the motion of a point that plane is `a t + k t²` but for
//! terms of third order, with
//! `r = t²(β² x̂×(x̂×v)/2 + ω×(ω×v)/2 + β x̂×(ω×v) + (β x̂ + ω) × h) + …`, and linear in `v`: its
//! least value over a box or triangle and the whole move has a closed form for each corner. A place
//! (no move) is the move with `h = 0`, `β = 0`, `ω = 0`.
//!
//! A lean that changes on the way turns the tool differently at every angle about the cone: it is
//! kept as room, `sway` times the distance from the ball centre.

use nalgebra::UnitQuaternion;

use crate::geometry::Vector;

use super::clear;
use super::profile::ToolProfile;

/// A move of the ball centre with an even turn of the tool, about its middle, in the frame of the
/// middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EvenMove {
    /// Half of the straight move, mm.
    pub half_move: Vector,
    /// Half of the turn about the cone's axis, rad.
    pub half_turn: f64,
    /// Half of the turn of the cone: a rotation vector, rad.
    pub half_frame: Vector,
    /// How far the tool may lean off the lean in the middle, rad.
    pub sway: f64,
}

impl EvenMove {
    /// No motion.
    pub fn none() -> Self {
        EvenMove { half_move: Vector::zeros(), half_turn: 0.0, half_frame: Vector::zeros(), sway: 0.0 }
    }

    pub fn is_none(&self) -> bool {
        *self == EvenMove::none()
    }

    /// Where a point that is at `v` in the middle is at time `t`, exactly (but for swaying).
    pub fn carry(&self, v: &Vector, t: f64) -> Vector {
        self.turned_back(&(v - self.half_move * t), t)
    }

    /// The part of the move from `t − share` to `t + share`, about its own middle.
    pub fn part(&self, t: f64, share: f64) -> Self {
        EvenMove {
            half_move: self.turned_back(&self.half_move, t) * share,
            half_turn: self.half_turn * share,
            half_frame: turned_about_x(&self.half_frame, -self.half_turn * t) * share,
            sway: self.sway,
        }
    }

    /// A direction of the frame of the middle in that of time `t`.
    fn turned_back(&self, v: &Vector, t: f64) -> Vector {
        let v = if self.cone_stays() { *v } else { UnitQuaternion::from_scaled_axis(self.half_frame * -t) * v };
        turned_about_x(&v, -self.half_turn * t)
    }

    /// First-order velocity of a point: `w(v)`.
    pub fn velocity(&self, v: &Vector) -> Vector {
        -self.half_move - self.turning(v)
    }

    /// The cone neither turns nor leans on the way.
    fn cone_stays(&self) -> bool {
        self.half_frame == Vector::zeros() && self.sway == 0.0
    }

    /// Distance within which all points within `radius` of `v` are from what the tool turns about,
    /// mm.
    fn distance(&self, v: &Vector, radius: f64) -> f64 {
        if self.cone_stays() { v.y.hypot(v.z) + radius } else { v.norm() + radius }
    }

    /// How much the tool turns at most, rad.
    fn turn(&self) -> f64 {
        self.half_turn.abs() + self.half_frame.norm()
    }

    /// `(β x̂ + ω) × v`.
    fn turning(&self, v: &Vector) -> Vector {
        let about_x = Vector::new(0.0, -v.z, v.y) * self.half_turn;
        if self.cone_stays() { about_x } else { about_x + self.half_frame.cross(v) }
    }

    /// What the first order leaves out, for points within `distance`, mm; without what the lean
    /// takes.
    fn bend(&self, distance: f64) -> f64 {
        let (b, h) = (self.turn(), self.half_move.norm());
        0.5 * b * b * (distance + h) + b * h
    }

    /// Second order of the point's motion: what `t²` is multiplied by.
    fn second(&self, v: &Vector) -> Vector {
        let about_x = Vector::new(0.0, v.y, v.z) * (-0.5 * self.half_turn * self.half_turn);
        if self.cone_stays() {
            return about_x + self.turning(&self.half_move);
        }
        let turned = self.half_frame.cross(v);
        let both = Vector::new(0.0, -turned.z, turned.y) * self.half_turn;
        about_x + self.half_frame.cross(&turned) * 0.5 + both + self.turning(&self.half_move)
    }

    /// What the second order leaves out, for points within `distance`, and what it differs by over
    /// points within `radius`, mm; without what the lean takes.
    fn rest(&self, distance: f64, radius: f64) -> f64 {
        let (b, h) = (self.turn(), self.half_move.norm());
        b.powi(3) * (distance + h) / 6.0 + 0.5 * b * b * (h + radius)
    }
}

/// `v` turned about the first axis.
pub(super) fn turned_about_x(v: &Vector, angle: f64) -> Vector {
    if angle == 0.0 {
        return *v;
    }
    let (s, c) = angle.sin_cos();
    Vector::new(v.x, c * v.y - s * v.z, s * v.y + c * v.z)
}

/// The shape of a region about its centre.
pub(super) enum RegionShape {
    /// Half sides of a box.
    Box([Vector; 3]),
    /// Corners of a triangle.
    Triangle([Vector; 3]),
}

/// Points of a body seen from the ball centre, in the middle of a move: all within `radius` of
/// `centre`, and within a shape.
pub(super) struct SeenRegion {
    pub centre: Vector,
    pub radius: f64,
    pub shape: RegionShape,
    pub motion: EvenMove,
    /// All points are within `reach` of the centre during the whole move.
    pub reach: f64,
    /// What of that no smaller piece has less of, mm.
    pub fixed: f64,
    /// What the second order leaves out, mm.
    rest: f64,
    moving: bool,
}

/// Least value of `a t + k t²` for `−1 ≤ t ≤ 1`.
fn least_of(a: f64, k: f64) -> f64 {
    if a.abs() < 2.0 * k { -0.25 * a * a / k } else { k - a.abs() }
}

impl SeenRegion {
    pub fn new(centre: Vector, radius: f64, shape: RegionShape, motion: EvenMove) -> Self {
        let moving = !motion.is_none();
        let (mut reach, mut rest, mut fixed) = (radius, 0.0, 0.0);
        if moving {
            let distance = motion.distance(&centre, radius);
            fixed = motion.sway * (distance + motion.half_move.norm());
            rest = motion.rest(distance, radius) + fixed;
            reach += motion.velocity(&centre).norm() + motion.turn() * radius + motion.bend(distance) + fixed;
        }
        SeenRegion { centre, radius, shape, motion, reach, fixed, rest, moving }
    }

    /// How far a function with this slope (no steeper than 1), or one above it, may fall from its
    /// value at the centre, over all points and the whole move: along each point's motion it is
    /// `a t + k t²` to second order.
    pub fn fall(&self, slope: &Vector) -> f64 {
        let still = |c: &Vector| slope.dot(&(self.centre - c));
        if !self.moving {
            return match &self.shape {
                RegionShape::Box(half) => half.iter().map(|h| slope.dot(h).abs()).sum(),
                RegionShape::Triangle(c) => c.iter().map(still).fold(0.0, f64::max),
            };
        }
        let m = &self.motion;
        let k = slope.dot(&m.second(&self.centre));
        let fall = match &self.shape {
            RegionShape::Box(half) => {
                let spread =
                    |t: f64| -> f64 { half.iter().map(|h| (slope.dot(h) - t * slope.dot(&m.turning(h))).abs()).sum() };
                spread(-1.0).max(spread(1.0)) - least_of(slope.dot(&m.velocity(&self.centre)), k)
            }
            RegionShape::Triangle(c) => {
                let at = |c: &Vector| still(c) - least_of(slope.dot(&m.velocity(c)), k);
                c.iter().map(at).fold(f64::NEG_INFINITY, f64::max)
            }
        };
        fall + self.rest
    }

    /// A lower bound of the margin over all points and the whole move with the tool's axis along
    /// `axis`, mm.
    pub fn least_margin(&self, profile: &ToolProfile, axis: &Vector) -> f64 {
        let mut least = f64::INFINITY;
        for f in &profile.frusta {
            let (margin, slope) = clear::margin(f, axis, &self.centre);
            if margin - self.reach < least {
                least = least.min(margin - self.fall(&slope));
            }
        }
        least
    }

    /// No point is inside the tool even when the tool turns to the point's own azimuth. There the
    /// margin depends on the point's `x` and distance `ρ` from the turning axis alone and is convex
    /// in both. Over the region `ρ` exceeds its tangent plane at the centre by at most
    /// `reach² / 2(ρ − reach)`. Needs `reach` less than the centre's `ρ`.
    pub fn out_of_reach(&self, profile: &ToolProfile, (sin_b, cos_b): (f64, f64)) -> bool {
        let across = self.centre.y.hypot(self.centre.z);
        let away = Vector::new(0.0, self.centre.y, self.centre.z) / across;
        let axis = Vector::new(sin_b, cos_b * away.y, cos_b * away.z);
        let bend = 0.5 * self.reach * self.reach / (across - self.reach);
        profile.frusta.iter().all(|f| {
            let (margin, slope) = clear::margin(f, &axis, &self.centre);
            margin > self.reach + bend || margin - self.fall(&slope) - (-slope.dot(&away)).max(0.0) * bend > 0.0
        })
    }

    /// The azimuths ψ of all points during the whole move, as one or two ranges within -π..=π,
    /// where each of its points is inside the tool for one arc about its own azimuth if at all: the
    /// profile only widens upwards and reaches beyond the region.
    pub fn azimuths(&self, profile: &ToolProfile) -> Option<[(f64, f64); 2]> {
        use std::f64::consts::PI;
        let across = self.centre.y.hypot(self.centre.z);
        if !profile.widens || self.centre.norm() + self.reach > profile.length || across <= self.reach {
            return None;
        }
        let psi = self.centre.z.atan2(self.centre.y);
        let spread = (self.reach / across).asin();
        let (lo, hi) = (psi - spread, psi + spread);
        Some(if lo < -PI {
            [(-PI, hi), (lo + 2.0 * PI, PI)]
        } else if hi > PI {
            [(lo, PI), (-PI, hi - 2.0 * PI)]
        } else {
            [(lo, hi), (lo, hi)]
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vector> {
        prop::array::uniform3(-size..size).prop_map(Vector::from)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

        /// Over points of a triangle or box and times of a move, a linear function falls no farther
        /// than is said, and no point leaves the reach; parts of a move are parts of it.
        #[test]
        fn a_move_keeps_within_its_bounds(
            centre in vector(20.0), a in vector(2.0), b in vector(2.0), c in vector(2.0),
            half_move in vector(0.7), about_x in -0.2..0.2f64, frame in vector(0.1), turns in any::<bool>(), slope in vector(1.0),
            at in -0.7..0.7f64, share in 0.05..0.3f64,
        ) {
            let half_frame = if turns { frame } else { Vector::zeros() };
            let motion = EvenMove { half_move, half_turn: about_x, half_frame, sway: 0.0 };
            let triangle = [centre + a, centre + b, centre - a - b];
            let radius = triangle.iter().map(|p| (p - centre).norm()).fold(0.0, f64::max);
            let regions = [
                SeenRegion::new(centre, radius, RegionShape::Triangle(triangle), motion),
                SeenRegion::new(centre, a.norm() + b.norm() + c.norm(), RegionShape::Box([a, b, c]), motion),
            ];
            let n = slope.norm().max(1.0);
            let slope = slope / n;
            for k in 0..=20 {
                let t = -1.0 + 0.1 * f64::from(k);
                for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.3, 0.3), (0.5, 0.5)] {
                    let p = triangle[0] + (triangle[1] - triangle[0]) * u + (triangle[2] - triangle[0]) * v;
                    let q = centre + a * (2.0 * u - 1.0) + b * (2.0 * v - 1.0) - c * t;
                    for (region, p) in regions.iter().zip([p, q]) {
                        let moved = motion.carry(&p, t) - centre;
                        prop_assert!(slope.dot(&moved) >= -region.fall(&slope) - 1e-9);
                        prop_assert!(moved.norm() <= region.reach + 1e-9);
                    }
                    let part = motion.part(at, share).carry(&motion.carry(&p, at), t);
                    prop_assert!((part - motion.carry(&p, at + share * t)).norm() < 1e-9);
                }
            }
        }
    }
}
