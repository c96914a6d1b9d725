//! Whether a triangle keeps clear of a frustum at one angle.
//!
//! The margin (distance less clearance) is convex over the triangle's plane. A point of the plane
//! where it is least has a closed form, from the frustum's support along the plane's normal. If the
//! triangle holds that point, it is the least; if not, the least is on an edge: along each edge the
//! derivative's root is closed in on by false position. Tangent planes bound what is left.

use crate::geometry::Vector;

use super::profile::Frustum;

/// Places on an edge that are looked at, at most.
const ROUNDS: usize = 10;
/// A margin that is none, mm.
const NONE_MM: f64 = 1e-10;

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

/// A tangent plane of the margin, at or near the point where that is least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tangent {
    pub at: Vector,
    pub margin: f64,
    pub slope: Vector,
}

impl Tangent {
    /// The value at a point, mm.
    pub fn over(&self, p: &Vector) -> f64 {
        self.margin + self.slope.dot(&(p - self.at))
    }

    /// The least value over a triangle, mm.
    pub fn least(&self, corners: &[Vector; 3]) -> f64 {
        corners.iter().map(|c| self.over(c)).fold(f64::INFINITY, f64::min)
    }
}

/// What is known of a triangle, with the proof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Nearness {
    /// All points have a positive margin.
    Clear(Tangent),
    /// This point has none.
    Taken(Vector),
    /// Too near to tell.
    Open,
}

/// Looks at the triangle `corners`, all of it within `radius` of its point `centre`.
pub(super) fn triangle(
    frustum: &Frustum,
    axis: &Vector,
    corners: &[Vector; 3],
    centre: Vector,
    radius: f64,
) -> Verdict {
    let (m, _) = margin(frustum, axis, &centre);
    if m > radius {
        return Verdict::Clear;
    }
    match nearest(frustum, axis, corners, &centre) {
        Nearness::Clear(_) => Verdict::Clear,
        Nearness::Taken(p) => Verdict::Taken(p),
        Nearness::Open => Verdict::Open,
    }
}

/// As [`triangle`], with the proof; `centre` is a point of the triangle.
pub(super) fn nearest(frustum: &Frustum, axis: &Vector, corners: &[Vector; 3], centre: &Vector) -> Nearness {
    let ends = corners.map(|c| margin(frustum, axis, &c));
    if let Some(k) = ends.iter().position(|e| e.0 <= 0.0) {
        return Nearness::Taken(corners[k]);
    }
    if let Some(normal) = (corners[1] - corners[0]).cross(&(corners[2] - corners[0])).try_normalize(1e-14) {
        let (room, slope, p) = frustum.off_plane(axis, &normal, normal.dot(&corners[0]), centre);
        if room > NONE_MM {
            return Nearness::Clear(Tangent { at: p, margin: room, slope });
        }
        let inside =
            [(0, 1), (1, 2), (2, 0)].map(|(j, k)| (corners[k] - corners[j]).cross(&(p - corners[j])).dot(&normal));
        if inside.iter().all(|s| *s >= 0.0) && margin(frustum, axis, &p).0 <= 0.0 {
            return Nearness::Taken(p);
        }
    }
    let mut least = Tangent { at: *centre, margin: f64::INFINITY, slope: Vector::zeros() };
    for (j, k) in [(0, 1), (1, 2), (2, 0)] {
        match along_edge(frustum, axis, [&corners[j], &corners[k]], [ends[j], ends[k]]) {
            Nearness::Clear(t) if t.margin < least.margin => least = t,
            Nearness::Clear(_) => {}
            other => return other,
        }
    }
    Nearness::Clear(least)
}

/// The least margin on an edge with margins and slopes `at` its ends.
fn along_edge(frustum: &Frustum, axis: &Vector, ends: [&Vector; 2], at: [(f64, Vector); 2]) -> Nearness {
    let edge = ends[1] - ends[0];
    let rise = at.map(|(_, slope)| slope.dot(&edge));
    for (k, lowest) in [(0, rise[0] >= 0.0), (1, rise[1] <= 0.0)] {
        if lowest {
            return Nearness::Clear(Tangent { at: *ends[k], margin: at[k].0, slope: at[k].1 });
        }
    }
    let (mut from, mut to) = ((0.0, rise[0]), (1.0, rise[1]));
    for round in 0..ROUNDS {
        let share = from.1 / (from.1 - to.1);
        // Every third time the middle, so that both ends of the bracket move.
        let share = if round % 3 == 2 { 0.5 } else { share };
        let t = from.0 + (to.0 - from.0) * share;
        let p = ends[0] + edge * t;
        let (m, slope) = margin(frustum, axis, &p);
        if m <= 0.0 {
            return Nearness::Taken(p);
        }
        let rise = slope.dot(&edge);
        let rest = if rise > 0.0 { t - from.0 } else { to.0 - t };
        let room = m - rise.abs() * rest;
        if room > NONE_MM && room > 0.5 * m {
            return Nearness::Clear(Tangent { at: p, margin: m, slope });
        }
        if rise > 0.0 { to = (t, rise) } else { from = (t, rise) }
    }
    Nearness::Open
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    /// Share of its size from which a triangle must be found to be clear.
    const OPEN: f64 = 0.1;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

        /// Never clear where a point of a dense grid is not, never taken at a point that is clear;
        /// not left open unless the triangle is nearer than a tenth of its size.
        #[test]
        fn agrees_with_a_grid(
            at in prop::array::uniform3(-9.0..9.0f64),
            c in prop::array::uniform9(-1.0..1.0f64),
            size in 0.01..9.0f64,
            taper in 0.0..1.0f64,
            clearance in 0.0..1.0f64,
        ) {
            let frustum = Frustum::new([1.0, 9.0], [3.0, 3.0 + 2.0 * taper], clearance);
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
            let (frustum, axis, p) = (Frustum::new([1.0, 9.0], [3.0, 4.0], 0.3), Vector::new(0.6, 0.0, 0.8), Vector::new(x, y, z));
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
