//! Cutters with a corner that lean forwards along the way of a path.
//!
//! The tool axis is one of a cone ([`Cone`]), and the path goes on round the cone's axis with
//! rising θ. With the surface normal at the angle `φ` about that axis, an axis at `θ = φ + δ` leans
//! forwards by δ, as far as the lean of head and wall leaves that: the contact angle `α` between
//! axis and normal is
//! ```text
//! cos α = sin B n_c + cos B n_h cos δ
//! ```
//! with `n_c` the part of the normal along the cone's axis and `n_h` that across it. Leaning
//! forwards the cutter touches with the front of its corner, and the back of its bottom is clear.
//!
//! How high the ridges beside its passes are depends on the lean and on how the part bends along
//! the way ([`Bending::sharpness`]).

use nalgebra::{Matrix2, Vector2};

use super::Tool;
use super::stepover::curvature_of_disc;
use crate::artifact::Cone;
use crate::geometry::disc::Disc;
use crate::geometry::{Point, Vector};

/// The bend of a surface at a place is that from so far before it to so far beyond, as a share of
/// the corner's radius.
pub const BEND: f64 = 0.2;
/// Wherever a cutter can lean within the range of contact angle, it can by this much less, rad.
pub const SPAN_RAD: f64 = 0.03;
/// Angles of a window that are looked at.
const LOOKS: usize = 24;
/// Halvings towards the beginning of a window.
const HALVINGS: usize = 40;
/// Contacts that go less than this, as a share of what the corner's centre goes, stand.
const STANDS: f64 = 1e-3;

/// How far θ is on from the angle of the unit `normal` about the cone's axis, rad, 0 to π, where
/// the contact angle is `contact_rad`; `None` where the contact angle is greater at every θ.
/// Where it is less at every θ: π.
pub fn forwards_rad(cone: &Cone, normal: &Vector, contact_rad: f64) -> Option<f64> {
    let n = cone.seen(normal);
    let (sine, cosine) = cone.lean_rad.sin_cos();
    let (up, across) = (sine * n.x, cosine * n.y.hypot(n.z));
    let off = contact_rad.cos() - up;
    (off <= across).then(|| if off <= -across { std::f64::consts::PI } else { (off / across).acos() })
}

/// A cutter with a corner, and how far it leans forwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inclined {
    /// Radius of the disc that the corner rolls over, mm.
    pub disc_radius_mm: f64,
    /// Radius of the corner, mm.
    pub corner_radius_mm: f64,
    /// Least and greatest angle between tool axis and surface normal, rad.
    pub contact_rad: [f64; 2],
    /// The tool axes.
    pub cone: Cone,
    /// Whether θ rises along the way of the path; else the path is the mirror image of one along
    /// which it does.
    pub rises: bool,
}

impl Inclined {
    /// A tool whose axis is one of a cone, along which θ rises, and leans by between these contact
    /// angles, degrees; `None`: a ball.
    pub fn new(tool: &Tool, contact_deg: [f64; 2], cone: Cone) -> Option<Self> {
        (!tool.is_ball()).then(|| Inclined {
            disc_radius_mm: tool.disc_radius_mm(),
            corner_radius_mm: tool.corner_mm(),
            contact_rad: contact_deg.map(f64::to_radians),
            cone,
            rises: true,
        })
    }

    /// The disc where the centre of the corner and the unit `normal` are those, at the greatest
    /// contact angle. Where the contact angle is greater at every θ, with its axis as near to the
    /// normal as it comes.
    pub fn disc(&self, corner: &Point, normal: &Vector) -> Disc {
        self.disc_leaning(corner, normal, self.range_rad(normal)[1])
    }

    /// The same where it leans forwards so little that θ has room of [`SPAN_RAD`].
    pub fn disc_with_room(&self, corner: &Point, normal: &Vector) -> Disc {
        let [least, high] = self.range_rad(normal);
        self.disc_leaning(corner, normal, least.max(high - SPAN_RAD))
    }

    fn disc_leaning(&self, corner: &Point, normal: &Vector, on_rad: f64) -> Disc {
        Disc::of_corner(corner, normal, self.axis(normal, on_rad), self.disc_radius_mm)
    }

    /// Curvatures at a contact, 1/mm, in the frame of two unit vectors across its normal: of the
    /// cutter at the greatest contact angle, and those that passes are laid for. `round` is how the
    /// part bends there along a turn. `None` where a flat bottom lies on the part.
    ///
    /// Where head and wall make the cutter lean aside too, less lean forwards may leave higher
    /// ridges. So that θ has room of [`SPAN_RAD`], passes are laid for a cutter that is sharper
    /// across turns by the difference. What a pass leaves is then a smooth function of its
    /// direction, as with one cutter, and other than the greater of two heights.
    pub fn curvatures(&self, round: &Bending, frame: &[Vector; 2]) -> Option<[Matrix2<f64>; 2]> {
        let [least, high] = self.range_rad(&round.normal);
        let own = self.curvature(&round.normal, frame, high)?;
        let [_, across] = round.frame()?;
        let sharp = |on: f64| self.sharpness(round, on);
        let more = sharp(least.max(high - SPAN_RAD)).zip(sharp(high)).map_or(0.0, |(low, high)| (low - high).max(0.0));
        let across = Vector2::new(across.dot(&frame[0]), across.dot(&frame[1]));
        Some([own, own + across * across.transpose() * more])
    }

    fn sharpness(&self, place: &Bending, on_rad: f64) -> Option<f64> {
        place.sharpness(&self.curvature(&place.normal, &place.frame()?, on_rad)?)
    }

    /// δ of the least and the greatest contact angle at a normal, rad; 0 where there is none.
    fn range_rad(&self, normal: &Vector) -> [f64; 2] {
        self.contact_rad.map(|angle| forwards_rad(&self.cone, normal, angle).unwrap_or(0.0))
    }

    fn axis(&self, normal: &Vector, on_rad: f64) -> Vector {
        let azimuth = self.cone.theta_of(normal, 0.0).unwrap_or(0.0);
        self.cone.tool_axis(azimuth + if self.rises { on_rad } else { -on_rad })
    }

    fn curvature(&self, normal: &Vector, frame: &[Vector; 2], on_rad: f64) -> Option<Matrix2<f64>> {
        curvature_of_disc([self.disc_radius_mm, self.corner_radius_mm], &self.axis(normal, on_rad), normal, frame)
    }

    /// The window of δ at a place of a path, in which ridges beside it are no higher than those
    /// that passes are laid for, rad; `None` where there is none.
    pub fn window_rad(&self, place: &Bending) -> Option<[f64; 2]> {
        forwards_rad(&self.cone, &place.normal, self.contact_rad[1])?;
        let [least, high] = self.range_rad(&place.normal);
        let low = least.max(high - SPAN_RAD);
        let laid = self.sharpness(place, high)?.max(self.sharpness(place, low)?);
        let is_flat_enough = |on: f64| self.sharpness(place, on).is_some_and(|sharp| sharp <= laid);
        // From the end of what passes are laid for downwards, as far as ridges grow no higher.
        let mut wide = low;
        let step = (wide - least) / LOOKS as f64;
        for _ in 0..LOOKS {
            let mut beyond = wide - step;
            if is_flat_enough(beyond) {
                wide = beyond;
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (beyond + wide);
                if is_flat_enough(middle) { wide = middle } else { beyond = middle }
            }
            break;
        }
        (wide < high).then_some([wide, high])
    }

    /// Radius of the ball that leaves the same ridges on flat ground as the cutter leaning straight
    /// along its way, mm.
    pub fn flat_radius_mm(&self) -> f64 {
        self.disc_radius_mm / self.contact_rad[1].sin().max(1e-3) + self.corner_radius_mm
    }
}

/// How a surface bends along the way of a path.
#[derive(Clone, Copy, Debug)]
pub struct Bending {
    /// Unit normal at the place.
    pub normal: Vector,
    /// What the contact goes by along the way, mm.
    pub contact: Vector,
    /// What the unit normal turns by meanwhile.
    pub turn: Vector,
}

impl Bending {
    /// Of a corner of this radius whose centre goes by `centre` while the normal turns, mm.
    pub fn of_corner(normal: Vector, centre: Vector, turn: Vector, corner_mm: f64) -> Self {
        let mut contact = centre - turn * corner_mm;
        // Round a sharp edge contacts stand: there they are taken to go a little.
        if contact.norm() < STANDS * centre.norm() {
            contact = centre * STANDS;
        }
        Bending { normal, contact, turn }
    }

    /// Unit vectors along the contacts and across them, square to the normal.
    pub fn frame(&self) -> Option<[Vector; 2]> {
        let along = (self.contact - self.normal * self.contact.dot(&self.normal)).try_normalize(1e-12)?;
        Some([along, self.normal.cross(&along)])
    }

    /// What a cutter with these curvatures, 1/mm, in the [`Self::frame`], leaves over flat ground
    /// at a small distance `D` beside the way, over `D²/2`, 1/mm; `None` where it does not fit.
    /// What the part's bend across the way adds to that is the same for all cutters.
    ///
    /// With the curvatures `T` of the cutter ([`super::stepover`]) and `S` of the part it is
    /// `bᵀTb − (bᵀKt)² / tᵀKt`, `K = T + S`, `t` along the contacts and `b` across.
    pub fn sharpness(&self, cutter: &Matrix2<f64>) -> Option<f64> {
        let [t, b] = self.frame()?;
        let gone = self.contact.norm();
        let (along, aside) = (cutter[(0, 0)] + t.dot(&self.turn) / gone, cutter[(1, 0)] + b.dot(&self.turn) / gone);
        (along > 0.0).then(|| cutter[(1, 1)] - aside * aside / along)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn unit(a: f64, b: f64) -> Vector {
        Vector::new(a.sin() * b.cos(), a.sin() * b.sin(), a.cos())
    }

    proptest! {
        /// The contact angle is the one asked for, forwards.
        #[test]
        fn it_leans_forwards_by_the_contact_angle(
            lean in -0.6..0.6f64, tip in 0.3..2.8f64, turn in 0.0..6.0f64, contact in 0.02..1.5f64,
        ) {
            let cone = Cone::about_blade(lean);
            let normal = Vector::new(tip.cos(), tip.sin() * turn.cos(), tip.sin() * turn.sin());
            let azimuth = cone.theta_of(&normal, 0.0).unwrap();
            let least = cone.tool_axis(azimuth).angle(&normal);
            match forwards_rad(&cone, &normal, contact) {
                None => prop_assert!(least > contact - 1e-9),
                Some(on) => {
                    let there = cone.tool_axis(azimuth + on).angle(&normal);
                    prop_assert!(on == std::f64::consts::PI && there <= contact || (there - contact).abs() < 1e-9);
                }
            }
        }

        /// What stands of a cutter along its way over a part that bends leave at a small distance
        /// beside it.
        #[test]
        fn what_is_left_beside_a_way_is_as_sharp_as_that(
            disc in 0.5..8.0f64, corner in 0.2..4.0f64, tilt in 0.05..0.6f64, turn in 0.0..6.0f64,
            k1 in -0.02..1.0f64, k2 in -0.02..0.3f64, twist in 0.0..3.0f64, beside in -1.0..1.0f64,
        ) {
            // The part is z = −½ xᵀSx, contacts go along x, the axis goes with the normal.
            let round = nalgebra::Rotation2::new(twist);
            let s = round * nalgebra::Matrix2::new(k1, 0.0, 0.0, k2) * round.inverse();
            let place = Bending {
                normal: Vector::z(),
                contact: Vector::x(),
                turn: Vector::new(s[(0, 0)], s[(1, 0)], 0.0),
            };
            let frame = place.frame().unwrap();
            let cutter = curvature_of_disc([disc, corner], &unit(tilt, turn), &Vector::z(), &frame).unwrap();
            let Some(sharp) = place.sharpness(&cutter) else { return Ok(()) };
            prop_assume!(sharp + s[(1, 1)] > 1e-3);
            let d = 1e-3 * corner * if beside < 0.0 { -1.0 } else { 1.0 };
            let left = |x: f64| {
                let n = Vector::new(s[(0, 0)] * x, s[(1, 0)] * x, 1.0).normalize();
                let contact = Point::new(x, 0.0, -0.5 * s[(0, 0)] * x * x);
                let lean = Vector::new(turn.cos(), turn.sin(), 0.0);
                let lean = (lean - n * n.dot(&lean)).normalize();
                let axis = n * tilt.cos() + lean * tilt.sin();
                let centre = contact + n * corner + (n * tilt.sin() - lean * tilt.cos()) * disc;
                let p = Point::new(0.0, d, -0.5 * s[(1, 1)] * d * d);
                Disc { centre, axis, radius_mm: disc }.entry_mm(&p, &Vector::z(), corner)
            };
            let (mut a, mut b) = (-20.0 * d.abs(), 20.0 * d.abs());
            for _ in 0..80 {
                let (c, e) = (a + 0.382 * (b - a), a + 0.618 * (b - a));
                if left(c) < left(e) { b = e } else { a = c }
            }
            let is = 2.0 * left(0.5 * (a + b)) / (d * d);
            prop_assert!((is - sharp - s[(1, 1)]).abs() < 0.02 * is.abs() + 1e-3, "{is} {sharp} {}", s[(1, 1)]);
        }
    }
}
