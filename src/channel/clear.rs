//! Whether a triangle keeps clear of a frustum at one angle.
//!
//! The margin (distance less clearance) is convex over the triangle, so a tangent plane at any point bounds it from below, and so
//! does any mean of several. A plane is kept by its values at the triangle's corners, its least value is at one of them. The
//! best mean of two planes is a tiny matrix game, solved by looking at its few vertices; where the two planes balance is
//! the point to look at next (Kelley's cutting planes, with the planes so far kept as one aggregate).

use crate::geometry::Vector;

use super::profile::Frustum;

/// Planes after which the triangle is halved instead.
const PLANES: usize = 8;

/// What is known of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// All points have a positive margin.
    Clear,
    /// This point has none.
    Taken(Vector),
    /// Too near to tell.
    Open,
}

/// Margin of `p` (seen from the ball centre) from the frustum about `axis`, and its slope in space.
pub(super) fn margin(frustum: &Frustum, axis: &Vector, p: &Vector) -> (f64, Vector) {
    let height = p.dot(axis);
    let radial = p - axis * height;
    let radius = radial.norm();
    let (margin, by_height, by_radius) = frustum.margin(height, radius);
    (margin, axis * by_height + radial * (if radius > 0.0 { by_radius / radius } else { 0.0 }))
}

/// Looks at the triangle `corners`, all of it within `radius` of its point `centre`.
pub(super) fn triangle(
    frustum: &Frustum,
    axis: &Vector,
    corners: &[Vector; 3],
    centre: Vector,
    radius: f64,
) -> Verdict {
    let at_corners = |p: &Vector, m: f64, slope: &Vector| corners.map(|c| m + slope.dot(&(c - p)));
    let (m, slope) = margin(frustum, axis, &centre);
    if m > radius {
        return Verdict::Clear;
    }
    if m <= 0.0 {
        return Verdict::Taken(centre);
    }
    let mut plane = at_corners(&centre, m, &slope);
    let (mut least, mut next) = lowest(&plane, corners);
    for _ in 0..PLANES {
        if least > 0.0 {
            return Verdict::Clear;
        }
        let (m, slope) = margin(frustum, axis, &next);
        if m <= 0.0 {
            return Verdict::Taken(next);
        }
        (least, next) = mix(&mut plane, &at_corners(&next, m, &slope), corners);
    }
    if least > 0.0 { Verdict::Clear } else { Verdict::Open }
}

fn lowest(plane: &[f64; 3], corners: &[Vector; 3]) -> (f64, Vector) {
    let mut best = (plane[0], corners[0]);
    for k in 1..3 {
        if plane[k] < best.0 {
            best = (plane[k], corners[k]);
        }
    }
    best
}

/// Replaces `a` by the mean of `a` and `b` with the greatest least value; returns that and where to look next.
fn mix(a: &mut [f64; 3], b: &[f64; 3], corners: &[Vector; 3]) -> (f64, Vector) {
    let mean = |w: f64| [0, 1, 2].map(|k| w * a[k] + (1.0 - w) * b[k]);
    let (of_a, of_b) = (lowest(a, corners), lowest(b, corners));
    let (mut best, mut weight) = if of_a.0 > of_b.0 { (of_a, 1.0) } else { (of_b, 0.0) };
    for (j, k) in [(0, 1), (1, 2), (2, 0)] {
        let (dj, dk) = (a[j] - b[j], a[k] - b[k]);
        let w = (b[k] - b[j]) / (dj - dk);
        if !(w > 0.0 && w < 1.0) {
            continue;
        }
        let least = lowest(&mean(w), corners).0;
        if least > best.0 {
            // Both planes are equal at this share of corner j.
            let share = (-dk / (dj - dk)).clamp(0.0, 1.0);
            (best, weight) = ((least, corners[k] + (corners[j] - corners[k]) * share), w);
        }
    }
    *a = mean(weight);
    best
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::tool::Segment;
    use proptest::prelude::*;

    /// Share of its size from which a triangle must be told to be clear.
    const OPEN: f64 = 0.1;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

        /// Never clear where a point of a dense grid is not, never taken at a point that is clear; not left open unless the
        /// triangle is nearer than a tenth of its size.
        #[test]
        fn agrees_with_a_grid(
            at in prop::array::uniform3(-9.0..9.0f64),
            c in prop::array::uniform9(-1.0..1.0f64),
            size in 0.01..9.0f64,
            taper in 0.0..1.0f64,
            clearance in 0.0..1.0f64,
        ) {
            let segment = Segment { name: "taper".into(), z0: 1.0, z1: 9.0, r0: 3.0, r1: 3.0 + 2.0 * taper };
            let frustum = Frustum::new(&segment, clearance);
            let corners = [0, 3, 6].map(|k| Vector::from(at) + Vector::new(c[k], c[k + 1], c[k + 2]) * size);
            let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
            let radius = corners.iter().map(|p| (p - centre).norm()).fold(0.0, f64::max);
            let axis = Vector::new(0.6, 0.0, 0.8);
            let mut least = f64::INFINITY;
            for i in 0..=40 {
                for j in 0..=40 - i {
                    let (u, v) = (i as f64 / 40.0, j as f64 / 40.0);
                    let p = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v;
                    least = least.min(margin(&frustum, &axis, &p).0);
                }
            }
            match triangle(&frustum, &axis, &corners, centre, radius) {
                Verdict::Clear => prop_assert!(least > 0.0),
                Verdict::Taken(p) => prop_assert!(margin(&frustum, &axis, &p).0 <= 0.0),
                Verdict::Open => prop_assert!(least < OPEN * radius, "open at {least}, {} of the size", least / radius),
            }
        }

        /// The slope is the difference quotient.
        #[test]
        fn slope_is_the_difference(x in -9.0..9.0f64, y in -9.0..9.0f64, z in -9.0..14.0f64) {
            let segment = Segment { name: "taper".into(), z0: 1.0, z1: 9.0, r0: 3.0, r1: 4.0 };
            let (frustum, axis, p) = (Frustum::new(&segment, 0.3), Vector::new(0.6, 0.0, 0.8), Vector::new(x, y, z));
            let (m, slope) = margin(&frustum, &axis, &p);
            for e in [Vector::x(), Vector::y(), Vector::z()] {
                let ahead = margin(&frustum, &axis, &(p + e * 1e-6)).0;
                let behind = margin(&frustum, &axis, &(p - e * 1e-6)).0;
                // Convex: between the one-sided differences, also at kinks.
                prop_assert!(slope.dot(&e) * 1e-6 <= ahead - m + 1e-11);
                prop_assert!(slope.dot(&e) * 1e-6 >= m - behind - 1e-11);
            }
        }
    }
}
