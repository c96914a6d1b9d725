//! How far apart passes of any cutter may lie: the curvatures of cutter and part at the contact.
//!
//! Let `T` be the second fundamental form of the cutter at the contact and `S` that of the part,
//! both positive where convex, and `K = T + S`. The gap between them grows as `½ xᵀKx` from the
//! contact, so `K` must be positive definite: else the cutter cuts the part beside it. Where the
//! contacts run along the unit vector `t`, the gap left at a place `D` beside them is the least
//! over all places of the cutter on its way, `½ D² det K / tᵀKt` (the Schur complement of `K` along
//! `t`). Passes that leave the ridge `h` between them are twice that far apart:
//! ```text
//! W = 2 sqrt(2 h tᵀKt / det K)
//! ```
//! For a ball, `T = I/R`, this is [`super::scallop`]'s width to the first order in `h`. A cutter
//! with a corner of radius `r` round a disc of radius `R`, its axis leaning by `α` from the normal,
//! has
//! ```text
//! T = m mᵀ / r + p pᵀ sin α / (R + r sin α)
//! ```
//! `m` along the axis' projection on the tangent plane and `p` across it: the principal curvatures
//! of a torus. With the lead along the feed its strip is that of a ball of `R / sin α + r`.
//!
//! The formula holds while the strip is narrow beside the radii of curvature, and least where the
//! bottom is nearly flat on the part: [`width_on_part_mm`] goes on from there. A cutter that leans
//! aside leaves more on one side of a pass than on the other; the ridge is between the two.

use nalgebra::{Matrix2, Point3, Vector2, Vector3};

use super::Tool;
use crate::geometry::Vector;
use crate::geometry::nurbs::Principal;

/// Flatter on the part than this, sine, a bottom has no curvature there.
const FLAT: f64 = 1e-9;
/// Corrections of a width by the ridge that it leaves.
const CORRECTIONS: usize = 4;
/// One that is off by more than this is none: the cutter does not fit the paraboloid.
const FARTHEST: f64 = 2.0;
/// The stand that leaves least is sought so far along a pass, in widths.
const ALONG: f64 = 3.0;
const GOLDEN_STEPS: usize = 50;
/// Halvings towards the place of a ridge.
const HALVINGS: usize = 24;
/// Over all heights, mm.
const BEYOND_MM: f64 = 1e6;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Distance across passes that leave the ridge `scallop_mm` between them, mm, where the curvatures
/// of cutter and part add up to `both` (1/mm, positive convex) and contacts run along `way`, of any
/// length, in the same frame. `None` where the cutter does not fit, or an argument is none.
pub fn width_mm(both: &Matrix2<f64>, way: &Vector2<f64>, scallop_mm: f64) -> Option<f64> {
    let t = way.try_normalize(0.0)?;
    let (along, det) = (t.dot(&(both * t)), both.determinant());
    // Positive definite: by the determinant and one diagonal entry.
    let fits = det > 0.0 && both[(0, 0)] > 0.0 && scallop_mm > 0.0;
    let width = 2.0 * (2.0 * scallop_mm * along / det).sqrt();
    (fits && width.is_finite()).then_some(width)
}

/// Curvatures at a contact of a cutter with a disc and a corner of these radii, mm, in the frame of
/// two unit vectors across the unit `normal`, 1/mm, with the unit `axis` from tip to spindle.
/// `None` where a flat bottom lies on the part: then it has none.
pub fn curvature_of_disc(
    [disc, corner]: [f64; 2],
    axis: &Vector,
    normal: &Vector,
    frame: &[Vector; 2],
) -> Option<Matrix2<f64>> {
    if disc == 0.0 {
        return Some(Matrix2::identity() / corner);
    }
    let lean = axis - normal * axis.dot(normal);
    let sine = lean.norm();
    if !(sine > FLAT) {
        return None;
    }
    let m = Vector2::new(lean.dot(&frame[0]), lean.dot(&frame[1])) / sine;
    let p = Vector2::new(-m.y, m.x);
    Some(m * m.transpose() / corner + p * p.transpose() * (sine / (disc + corner * sine)))
}

/// As [`width_mm`], on a part of these principal curvatures (negative where convex, with their
/// directions) and its unit outward `normal`; `way` is the direction of the line of contacts.
///
/// The formula is the first step only. Then the ridge between two passes is measured: a paraboloid
/// stands for the part, the cutter goes along both lines with its axis as far from the normal
/// everywhere, and the width goes with the root of the ridge.
pub fn width_on_part_mm(
    tool: &Tool,
    axis: &Vector,
    (normal, bend): (&Vector, &Principal),
    way: &Vector,
    scallop_mm: f64,
) -> Option<f64> {
    let cutter = curvature_of_disc([tool.disc_radius_mm(), tool.corner_mm()], axis, normal, &bend.direction)?;
    let part = Matrix2::from_diagonal(&Vector2::new(-bend.curvature[0], -bend.curvature[1]));
    let seen = |v: &Vector| Vector3::new(v.dot(&bend.direction[0]), v.dot(&bend.direction[1]), v.dot(normal));
    let way = seen(way).xy();
    let first = width_mm(&(cutter + part), &way, scallop_mm)?;
    let passes = Passes { tool, axis: seen(axis), part, way: way.try_normalize(0.0)? };
    let mut width = first;
    for _ in 0..CORRECTIONS {
        let ridge = passes.ridge_mm(width);
        let factor = (scallop_mm / ridge).sqrt();
        if !(factor > FARTHEST.recip() && factor < FARTHEST) {
            return Some(first);
        }
        width *= factor;
    }
    Some(width)
}

/// Two passes on a paraboloid, seen from the place midway between them: the third direction is the
/// normal there.
struct Passes<'a> {
    tool: &'a Tool,
    axis: Vector3<f64>,
    part: Matrix2<f64>,
    way: Vector2<f64>,
}

impl Passes<'_> {
    /// The ridge between passes so far apart, mm: where both leave the same. That is midway but for
    /// cutters that lean aside.
    fn ridge_mm(&self, width_mm: f64) -> f64 {
        let (mut low, mut high) = (-0.5 * width_mm, 0.5 * width_mm);
        let left = |side: f64, at: f64| self.left_mm(side * 0.5 * width_mm, at, width_mm);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if left(-1.0, middle) < left(1.0, middle) { low = middle } else { high = middle }
        }
        left(-1.0, 0.5 * (low + high))
    }

    /// A place of the paraboloid and its normal.
    fn place(&self, at: &Vector2<f64>) -> (Point3<f64>, Vector3<f64>) {
        let slope = self.part * at;
        (Point3::new(at.x, at.y, -0.5 * at.dot(&slope)), Vector3::new(slope.x, slope.y, 1.0).normalize())
    }

    /// What a pass on one line leaves over a place of another, mm; both by their distances across.
    fn left_mm(&self, line_mm: f64, at_mm: f64, width_mm: f64) -> f64 {
        let across = Vector2::new(-self.way.y, self.way.x);
        let (place, ray) = self.place(&(across * at_mm));
        let lean = (self.axis - Vector3::z() * self.axis.z).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let (cosine, sine) = (self.axis.z, self.axis.xy().norm());
        let entry = |s: f64| {
            let (contact, normal) = self.place(&(across * line_mm + self.way * s));
            let lean = (lean - normal * normal.dot(&lean)).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
            let axis = normal * cosine + lean * sine;
            let centre = self.tool.centre_at(&contact, &normal, &axis, None);
            let met_mm = centre.map(|c| self.tool.disc(c, axis).entry_mm(&place, &ray, self.tool.corner_mm()));
            // A stand too far off to be met: nearer ones may be.
            met_mm.filter(|mm| mm.is_finite()).unwrap_or(BEYOND_MM * (1.0 + s.abs()))
        };
        let (mut a, mut b) = (-ALONG * width_mm, ALONG * width_mm);
        for _ in 0..GOLDEN_STEPS {
            let (c, d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
            if entry(c) < entry(d) { b = d } else { a = c }
        }
        entry(0.5 * (a + b))
    }
}

/// Distance of two passes on flat ground that leaves the scallop `h`: `√(8 R h − 4 h²)`, mm.
pub fn flat_stepover_mm(radius_mm: f64, scallop_mm: f64) -> f64 {
    (8.0 * radius_mm * scallop_mm - 4.0 * scallop_mm * scallop_mm).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Point;
    use crate::tool::scallop;
    use proptest::prelude::*;

    fn tool(radius_mm: f64, corner: f64) -> Tool {
        Tool {
            radius_mm,
            corner_radius_mm: Some(corner),
            taper_deg: 0.0,
            shank_radius_mm: radius_mm,
            stickout_mm: 60.0,
            holder: Vec::new(),
        }
    }

    fn bend(k1: f64, k2: f64) -> Principal {
        Principal { curvature: [-k1, -k2], direction: [Vector::x(), Vector::y()] }
    }

    proptest! {
        #[test]
        fn for_a_ball_it_is_the_width_of_balls(
            radius in 0.5..10.0f64, k1 in -0.8..3.0f64, k2 in -0.8..3.0f64, turn in 0.0..6.0f64,
        ) {
            let (ball, h, bend) = (tool(radius, radius), 1e-6 * radius, bend(k1 / radius, k2 / radius));
            // Contacts run along t, balls along K t.
            let t = Vector::new(turn.cos(), turn.sin(), 0.0);
            let ways = Vector::new(t.x * (1.0 + k1), t.y * (1.0 + k2), 0.0);
            let width = width_on_part_mm(&ball, &Vector::z(), (&Vector::z(), &bend), &t, h).unwrap();
            let known = scallop::width_on_part_mm(radius, h, &bend, &ways).unwrap();
            prop_assert!((width / known - 1.0).abs() < 1e-4, "{width} {known}");
        }

        /// Two passes of a leaning bull-nose on a plane, a cylinder and a saddle, each swept by
        /// many places of its disc: the ridge is where both leave the same.
        #[test]
        fn ridges_of_swept_cutters(
            kind in 0usize..3, share in 0.1..0.6f64, alpha in 0.15..0.3f64, lean in 0.0..6.0f64, part in 1e-5..2e-3f64,
        ) {
            let radius = 8.0;
            let (tool, h) = (tool(radius, share * radius), part * radius);
            let [k1, k2] = [[0.0, 0.0], [0.0, 1.0 / 40.0], [1.0 / 60.0, -1.0 / 900.0]][kind];
            // Heights of the part, z = −½ (k1 x² + k2 y²), near the origin; passes run along x.
            let height = |x: f64, y: f64| -0.5 * (k1 * x * x + k2 * y * y);
            let normal = |x: f64, y: f64| Vector::new(k1 * x, k2 * y, 1.0).normalize();
            let axis = |n: &Vector| {
                let e = Vector::new(lean.cos(), lean.sin(), 0.0);
                let e = (e - n * e.dot(n)).normalize();
                n * alpha.cos() + e * alpha.sin()
            };
            let up = Vector::z();
            let width = width_on_part_mm(&tool, &axis(&up), (&up, &bend(k1, k2)), &Vector::x(), h).unwrap();
            // What a pass with its contacts on the line y = ±W/2 leaves over a place between.
            let left = |x: f64, side: f64, at: f64| {
                let (y, n) = (0.5 * side * width, normal(x, 0.5 * side * width));
                let contact = Point::new(x, y, height(x, y));
                let centre = tool.centre_at(&contact, &n, &axis(&n), None).unwrap();
                let disc = tool.disc(centre, axis(&n));
                let (place, ray) = (Point::new(0.0, at, height(0.0, at)), normal(0.0, at));
                let mut t = 0.0;
                for _ in 0..200 {
                    let more = disc.distance_mm(&(place + ray * t)) - tool.corner_mm();
                    if more < 1e-9 { break; }
                    t += more;
                }
                t
            };
            let least = |side: f64, at: f64| {
                let (mut a, mut b) = (-3.0 * width, 3.0 * width);
                for _ in 0..50 {
                    let (c, d) = (a + 0.382 * (b - a), a + 0.618 * (b - a));
                    if left(c, side, at) < left(d, side, at) { b = d } else { a = c }
                }
                left(0.5 * (a + b), side, at)
            };
            let (mut low, mut high) = (-0.5 * width, 0.5 * width);
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                if least(-1.0, middle) < least(1.0, middle) { low = middle } else { high = middle }
            }
            let ridge = least(-1.0, low);
            // The width goes with the root of the ridge.
            prop_assert!(((ridge / h).sqrt() - 1.0).abs() < 0.003, "{kind}: {ridge} {h}, {width} wide");
        }
    }

    #[test]
    fn a_lead_makes_the_strip_as_wide_as_that_of_a_much_greater_ball() {
        let (bull, alpha, flat) = (tool(16.0, 6.0), 5.0f64.to_radians(), bend(0.0, 0.0));
        let axis = Vector::new(alpha.sin(), 0.0, alpha.cos());
        let width = |way: Vector| width_on_part_mm(&bull, &axis, (&Vector::z(), &flat), &way, 0.01).unwrap();
        let effective = 10.0 / alpha.sin() + 6.0;
        let first = |way: Vector2<f64>| {
            let cutter = curvature_of_disc([10.0, 6.0], &axis, &Vector::z(), &flat.direction).unwrap();
            width_mm(&cutter, &way, 0.01).unwrap()
        };
        let [along, across] = [effective, 6.0].map(|radius| 2.0 * (0.02f64 * radius).sqrt());
        assert!((first(Vector2::x()) - along).abs() < 1e-12 && (first(Vector2::y()) - across).abs() < 1e-12);
        // What is measured differs by the next order of the scallop.
        assert!((width(Vector::x()) / along - 1.0).abs() < 0.01 && (width(Vector::y()) / across - 1.0).abs() < 0.01);
        // On hollow ground rounder than that the heel cuts.
        let hollow = bend(0.0, -1.01 / effective);
        assert!(width_on_part_mm(&bull, &axis, (&Vector::z(), &hollow), &Vector::x(), 0.01).is_none());
        assert!(width_on_part_mm(&bull, &Vector::z(), (&Vector::z(), &flat), &Vector::x(), 0.01).is_none());
        assert!(width_mm(&Matrix2::identity(), &Vector2::zeros(), 0.01).is_none());
        assert!(width_mm(&Matrix2::identity(), &Vector2::x(), f64::NAN).is_none());
    }
}
