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
//! A pass that is straight, with the axis standing still, sweeps a prism: its section is the disc
//! seen along the way, an ellipse, with the corner rolled round it. What it leaves standing over a
//! place is where a ray meets that section ([`Swept::entry_mm`]), exactly.

use crate::artifact::Cone;
use crate::geometry::{Point, Vector};

/// Wherever a cutter can lean within the range of contact angle, it can by this much less, rad.
const SPAN_RAD: f64 = 0.05;
/// How sharply the lesser of two strips is taken.
const SHARP: f64 = 8.0;
/// Halvings towards the beginning of a window.
const HALVINGS: usize = 40;
/// A ray less across the way than this, as a share, goes along it.
const ALONG: f64 = 1e-6;
/// Steps towards the line that bounds a section where a ray meets it.
const MOST_STEPS: usize = 60;
/// Slopes of that line are looked for up to this.
const STEEPEST: f64 = 1e9;
/// A slope is known to this share.
const SLOPE: f64 = 1e-13;

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

/// Radius of the ball that leaves the same ridges on flat ground as a cutter with a disc and a
/// corner of these radii on a pass along the unit `way`, mm; 0 where the axis does not lean
/// forwards.
///
/// Of a leaning cutter the curvature across the way is that of the section which it sweeps
/// ([`super::stepover`]): `1 / (r + R (a·t)² / sin³ α)`. It is least where the axis leans forwards
/// by √2 times as much as aside.
pub fn strip_radius_mm(radii_mm: [f64; 2], axis: &Vector, normal: &Vector, way: &Vector) -> f64 {
    let [disc, corner] = radii_mm;
    let (forwards, sine) = (axis.dot(way), axis.cross(normal).norm());
    if forwards > 0.0 { corner + disc * forwards * forwards / sine.powi(3) } else { 0.0 }
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
    /// Where the cutter stands that touches with the unit `normal` at the greatest contact angle,
    /// the centre of its corner being known: centre of the disc and tool axis. Where the contact
    /// angle is greater at every θ, with its axis as near to the normal as it comes.
    pub fn stand(&self, corner: &Point, normal: &Vector) -> (Point, Vector) {
        let on = forwards_rad(&self.cone, normal, self.contact_rad[1]).unwrap_or(0.0);
        let azimuth = self.cone.theta_of(normal, 0.0).unwrap_or(0.0);
        let axis = self.cone.tool_axis(azimuth + if self.rises { on } else { -on });
        let across = normal - axis * axis.dot(normal);
        let aside = across.try_normalize(1e-9).unwrap_or_else(Vector::zeros);
        (corner + aside * self.disc_radius_mm, axis)
    }

    fn strip_mm(&self, normal: &Vector, way: &Vector, on_rad: f64) -> f64 {
        let azimuth = self.cone.theta_of(normal, 0.0).unwrap_or(0.0);
        let (on, way) = if self.rises { (on_rad, *way) } else { (-on_rad, -way) };
        let radii_mm = [self.disc_radius_mm, self.corner_radius_mm];
        strip_radius_mm(radii_mm, &self.cone.tool_axis(azimuth + on), normal, &way)
    }

    /// δ of the least and the greatest contact angle at a normal, rad.
    fn ends(&self, normal: &Vector) -> Option<[f64; 2]> {
        let [least, most] = self.contact_rad.map(|angle| forwards_rad(&self.cone, normal, angle));
        Some([least.unwrap_or(0.0), most?])
    }

    /// Radius of the ball that passes along the unit `way` are laid for, mm, and that of the cutter
    /// at the greatest contact angle: where head and wall make it lean aside too, less lean
    /// forwards may leave higher ridges. The first is about the lesser of the strips there and
    /// [`SPAN_RAD`] below, without a corner between the one and the other.
    fn strips_mm(&self, normal: &Vector, way: &Vector) -> Option<[f64; 2]> {
        let [low, high] = self.ends(normal)?;
        let strips = [high, low.max(high - SPAN_RAD)].map(|on| self.strip_mm(normal, way, on));
        let lesser = strips.iter().map(|s| s.powf(-SHARP)).sum::<f64>().powf(-1.0 / SHARP);
        Some([lesser, strips[0]])
    }

    /// How many times as high as what a cutter at the greatest contact angle leaves beside the unit
    /// `way` is what its pass is laid for.
    pub fn higher(&self, normal: &Vector, way: &Vector) -> f64 {
        // Which way along it is not said by those who ask.
        let ahead = if self.cone.unseen(&Vector::x()).cross(normal).dot(way) < 0.0 { -way } else { *way };
        let way = if self.rises { ahead } else { -ahead };
        let [laid, own] = self.strips_mm(normal, &way).unwrap_or([1.0, 1.0]);
        if laid > 0.0 { own / laid } else { 1.0 }
    }

    /// The window of δ at a normal on a pass along the unit `way`, in which the strip is as wide as
    /// passes are laid for, rad; `None` where there is none.
    pub fn window_rad(&self, normal: &Vector, way: &Vector) -> Option<[f64; 2]> {
        let [least, high] = self.ends(normal)?;
        let wanted_mm = self.strips_mm(normal, way)?[0];
        // Strips grow up to one lean, and from there on become narrower.
        let (mut low, mut wide) = (least, least.max(high - SPAN_RAD));
        if self.strip_mm(normal, way, low) >= wanted_mm {
            wide = low;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + wide);
            if self.strip_mm(normal, way, middle) < wanted_mm { low = middle } else { wide = middle }
        }
        (wide < high).then_some([wide, high])
    }

    /// Radius of the ball that leaves the same ridges on flat ground as the cutter leaning straight
    /// along its way, mm.
    pub fn flat_radius_mm(&self) -> f64 {
        self.disc_radius_mm / self.contact_rad[1].sin().max(1e-3) + self.corner_radius_mm
    }
}

/// A cutter with a corner on a straight way, its axis standing still.
#[derive(Clone, Copy, Debug)]
pub struct Swept {
    /// Centre of the disc, mm.
    pub centre: Point,
    /// Unit tool axis.
    pub axis: Vector,
    /// Unit direction of the way.
    pub way: Vector,
    /// Radii of disc and corner, mm.
    pub radii_mm: [f64; 2],
}

impl Swept {
    /// Where the ray from `p` along the unit vector `n` comes into what the cutter sweeps, mm;
    /// infinite where it passes by.
    ///
    /// A convex section lies within all lines that touch it. Those that the ray comes through from
    /// outside are, with `u` the ray's direction across the way and `b` square to both, the ones
    /// with the normals `τ b − u`; the last of them is where the ray comes in, and how far that is
    /// is a concave function of `τ`.
    pub fn entry_mm(&self, p: &Point, n: &Vector) -> f64 {
        let across = |v: Vector| v - self.way * self.way.dot(&v);
        let (from, ray) = (across(p - self.centre), across(*n));
        let length = ray.norm();
        if !(length > ALONG) {
            return f64::INFINITY;
        }
        let u = ray / length;
        let b = self.way.cross(&u);
        let (along, aside) = (from.dot(&u), from.dot(&b));
        let (rise, lean) = (self.axis.dot(&u), self.axis.dot(&b));
        let [disc, corner] = self.radii_mm;
        // The disc's reach along τ b − u, squared over the disc's: a τ² + 2 c τ + d.
        let (a, c, d) = ((1.0 - lean * lean).max(0.0), lean * rise, (1.0 - rise * rise).max(0.0));
        if aside.abs() >= disc * a.sqrt() + corner {
            return f64::INFINITY;
        }
        let reach = |t: f64| ((a * t + 2.0 * c) * t + d).max(0.0).sqrt();
        let slope = |t: f64| {
            let of_disc = if disc > 0.0 { disc * (a * t + c) / reach(t).max(1e-150) } else { 0.0 };
            aside - of_disc - corner * t / t.hypot(1.0)
        };
        // Falls with τ: steps to its root, halving where they would go farther.
        let (mut low, mut high) = (-1.0, 1.0);
        while slope(high) > 0.0 && high < STEEPEST {
            (low, high) = (high, 4.0 * high);
        }
        while slope(low) < 0.0 && low > -STEEPEST {
            (low, high) = (4.0 * low, low);
        }
        let mut t = 0.5 * (low + high);
        for _ in 0..MOST_STEPS {
            let here = slope(t);
            if here > 0.0 {
                low = t
            } else {
                high = t
            }
            if high - low <= SLOPE * (1.0 + t.abs()) {
                break;
            }
            let bend = -disc * (a * d - c * c) / reach(t).max(1e-150).powi(3) - corner / t.hypot(1.0).powi(3);
            let next = t - here / bend;
            // Of such a step rounding may lead out of what is known to hold the root.
            if (next - t).abs() <= SLOPE * (1.0 + t.abs()) {
                break;
            }
            t = if next > low && next < high { next } else { 0.5 * (low + high) };
        }
        (t * aside - along - disc * reach(t) - corner * t.hypot(1.0)) / length
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::disc::Disc;
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

        /// Where a ray meets the swept cutter, found by walking along it as far as the nearest of
        /// many places of the disc is away.
        #[test]
        fn rays_meet_what_is_swept(
            disc in 0.0..8.0f64, corner in 0.1..4.0f64, tilt in 0.0..1.5f64, turn in 0.0..6.0f64,
            px in -6.0..6.0f64, py in -6.0..6.0f64, ray in 0.0..1.3f64, round in 0.0..6.0f64,
        ) {
            let swept = Swept {
                centre: Point::origin(), axis: unit(tilt, turn), way: Vector::x(), radii_mm: [disc, corner],
            };
            let (p, n) = (Point::new(px, py, -15.0), unit(ray, round));
            // The nearest place along the way: the distance is convex there.
            let left = |q: &Point| {
                let at = |s: f64| {
                    Disc { centre: Point::new(s, 0.0, 0.0), axis: swept.axis, radius_mm: disc }.distance_mm(q)
                };
                let (mut a, mut b) = (q.x - 40.0, q.x + 40.0);
                for _ in 0..200 {
                    let (c, d) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
                    if at(c) < at(d) { b = d } else { a = c }
                }
                at(0.5 * (a + b)) - corner
            };
            let mut t = 0.0;
            for _ in 0..4000 {
                let step = left(&(p + n * t));
                if step < 1e-9 || t > 200.0 {
                    break;
                }
                t += step;
            }
            let found = swept.entry_mm(&p, &n);
            if t > 200.0 {
                // One that grazes may be either.
                prop_assert!(found.is_infinite() || left(&(p + n * found)).abs() < 1e-6, "{found}");
            } else {
                prop_assert!((found - t).abs() < 1e-3 && left(&(p + n * found)).abs() < 1e-7, "{found} {t}");
            }
        }
    }

    /// A ball is met where a ray comes into a cylinder.
    #[test]
    fn without_a_disc_it_is_a_ball() {
        let swept =
            Swept { centre: Point::new(1.0, 2.0, 3.0), axis: unit(0.3, 1.0), way: Vector::x(), radii_mm: [0.0, 2.0] };
        let found = swept.entry_mm(&Point::new(0.0, 2.5, 0.0), &Vector::z());
        assert!((found - (3.0 - (4.0f64 - 0.25).sqrt())).abs() < 1e-12);
        assert!(swept.entry_mm(&Point::new(0.0, 4.5, 0.0), &Vector::z()).is_infinite());
    }
}
