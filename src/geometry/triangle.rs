//! The closest point of one triangle, and the angle that a triangle spans at a point of its own.

use super::{Point, Vector};

/// Where the segment `a b` is nearest to `q`, as a share of its length from `a`, 0 to 1; 0 for a
/// segment without length.
pub fn share_of_segment(a: &Point, b: &Point, q: &Point) -> f64 {
    let (d, length2) = (b - a, (b - a).norm_squared());
    if length2 > 0.0 { ((q - a).dot(&d) / length2).clamp(0.0, 1.0) } else { 0.0 }
}

/// The closest point of the segment `a b` to `q`.
pub fn closest_on_segment(a: &Point, b: &Point, q: &Point) -> Point {
    let t = share_of_segment(a, b, q);
    if t == 1.0 { *b } else { a + (b - a) * t }
}

/// Area of a triangle, mm².
pub fn area_mm2([a, b, c]: &[Point; 3]) -> f64 {
    0.5 * (b - a).cross(&(c - a)).norm()
}

/// The closest point of a triangle to `q`, corners in any sense.
///
/// The projection is taken through the triangle's normal rather than through barycentric
/// coordinates, so that long thin triangles lose no digits; a triangle without area counts as its
/// three sides.
pub fn closest_on_triangle(corners: &[Point; 3], q: &Point) -> Point {
    let [a, b, c] = corners;
    let n = (b - a).cross(&(c - a));
    let n2 = n.norm_squared();
    let mut best: Option<(f64, Point)> = None;
    for (s, e) in [(a, b), (b, c), (c, a)] {
        if n2 == 0.0 || n.dot(&(e - s).cross(&(q - s))) < 0.0 {
            let foot = closest_on_segment(s, e, q);
            let d2 = (q - foot).norm_squared();
            if best.is_none_or(|(d, _)| d2 < d) {
                best = Some((d2, foot));
            }
        }
    }
    best.map_or_else(|| q - n * (n.dot(&(q - a)) / n2), |(_, foot)| foot)
}

/// The angle, rad, that a triangle spans around a point on it: 2π inside, π on a side, its angle at
/// a corner. `tolerance_mm` decides what counts as on a side or corner.
pub fn angle_at(corners: &[Point; 3], foot: &Point, tolerance_mm: f64) -> f64 {
    let [a, b, c] = corners;
    for (p, l, r) in [(a, b, c), (b, c, a), (c, a, b)] {
        if (foot - p).norm() <= tolerance_mm {
            return angle_between(&(l - p), &(r - p));
        }
    }
    let on_side =
        [(a, b), (b, c), (c, a)].iter().any(|(s, e)| (closest_on_segment(s, e, foot) - foot).norm() <= tolerance_mm);
    if on_side { std::f64::consts::PI } else { std::f64::consts::TAU }
}

/// Angle between two vectors, rad, accurate for small and large angles.
pub fn angle_between(a: &Vector, b: &Vector) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point> {
        (-5.0..5.0, -5.0..5.0, -5.0..5.0).prop_map(|(x, y, z)| Point::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        /// No point of a fine barycentric grid is nearer, and the foot lies on the triangle
        /// (variational inequality).
        #[test]
        fn foot_is_optimal(a in point(), b in point(), c in point(), q in point()) {
            let foot = closest_on_triangle(&[a, b, c], &q);
            for p in [a, b, c] {
                // q - foot makes no acute angle with any direction into the (convex) triangle.
                prop_assert!((q - foot).dot(&(p - foot)) <= 1e-9);
            }
            let n = (b - a).cross(&(c - a)).normalize();
            prop_assert!(n.dot(&(foot - a)).abs() < 1e-9);
        }
    }

    #[test]
    fn degenerate_triangle_is_its_sides() {
        let p = |x: f64| Point::new(x, 0.0, 0.0);
        let foot = closest_on_triangle(&[p(0.0), p(2.0), p(1.0)], &Point::new(1.5, 1.0, 0.0));
        assert!((foot - p(1.5)).norm() < 1e-15);
        let foot = closest_on_triangle(&[p(1.0), p(1.0), p(1.0)], &Point::new(1.5, 1.0, 0.0));
        assert_eq!(foot, p(1.0));
    }

    #[test]
    fn angles_of_a_right_triangle() {
        let t = [Point::new(0.0, 0.0, 0.0), Point::new(1.0, 0.0, 0.0), Point::new(0.0, 1.0, 0.0)];
        let angle = |x, y| angle_at(&t, &Point::new(x, y, 0.0), 1e-9);
        use std::f64::consts::PI;
        assert!((angle(0.0, 0.0) - PI / 2.0).abs() < 1e-12);
        assert!((angle(1.0, 0.0) - PI / 4.0).abs() < 1e-12);
        assert!((angle(0.5, 0.5) - PI).abs() < 1e-12);
        assert!((angle(0.2, 0.3) - 2.0 * PI).abs() < 1e-12);
    }
}
