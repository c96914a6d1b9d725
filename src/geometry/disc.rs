//! A flat disc in space, and its distance to points, boxes and triangles in closed form.
//!
//! A cutter with a corner is a disc with a ball rolled over it (the Minkowski sum of both), so its
//! distance to anything is the disc's less the corner radius. With `z` the height of a point over
//! the disc's plane and `q` its distance from the axis, the disc of radius `R` is
//! ```text
//! d = sqrt(z² + max(0, q − R)²)
//! ```
//! away. The disc is convex, so `d` is a convex function of the point and lies above its tangent
//! planes: the value and the gradient at one place bound it over a whole box or hull.

use super::triangle::closest_on_triangle;
use super::{Point, Vector};

/// A disc; of radius 0 it is a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its middle, mm.
    pub centre: Point,
    /// Square to it, unit.
    pub axis: Vector,
    /// Radius, mm.
    pub radius_mm: f64,
}

/// Steps that the search for the nearest place of an edge takes at most; halving alone would end
/// with all digits in so many.
const MOST_STEPS: usize = 80;
/// A ray's entry is known to this, mm.
const ENTRY_MM: f64 = 1e-12;
/// A triangle is parallel to the disc where the sine between their normals is less than this.
const PARALLEL: f64 = 1e-12;

impl Disc {
    /// The disc that a corner rolls over where it touches a surface: centre of the corner, mm, unit
    /// outward `normal`, unit `axis` from tip to spindle. About the corner's centre where the axis
    /// is along the normal.
    pub fn of_corner(corner: &Point, normal: &Vector, axis: Vector, radius_mm: f64) -> Disc {
        let across = normal - axis * axis.dot(normal);
        let aside = across.try_normalize(1e-9).unwrap_or_else(Vector::zeros);
        Disc { centre: corner + aside * radius_mm, axis, radius_mm }
    }

    /// The point of the disc that is nearest to `p`, mm.
    pub fn foot(&self, p: &Point) -> Point {
        let v = p - self.centre;
        let across = v - self.axis * v.dot(&self.axis);
        let q = across.norm();
        let share = if q > self.radius_mm { self.radius_mm / q } else { 1.0 };
        self.centre + across * share
    }

    /// Distance of `p` from the disc, mm.
    pub fn distance_mm(&self, p: &Point) -> f64 {
        (p - self.foot(p)).norm()
    }

    /// Distance of `p` from the disc, mm, and the direction in which it grows, unit; zero on the
    /// disc itself.
    pub fn distance_and_gradient(&self, p: &Point) -> (f64, Vector) {
        let away = p - self.foot(p);
        let d = away.norm();
        (d, if d > 0.0 { away / d } else { Vector::zeros() })
    }

    /// A lower bound of the distance to what lies in a box, given by its middle and its half sides
    /// at right angles to each other, mm.
    pub fn least_in_box_mm(&self, middle: &Point, sides: &[Vector; 3]) -> f64 {
        let (d, g) = self.distance_and_gradient(middle);
        d - sides.iter().map(|s| g.dot(s).abs()).sum::<f64>()
    }

    /// A lower bound of the distance to what lies in the convex hull of points, mm, from the value
    /// and the gradient at a place near them.
    pub fn least_in_hull_mm(&self, near: &Point, hull: &[Point]) -> f64 {
        let (d, g) = self.distance_and_gradient(near);
        d + hull.iter().map(|p| g.dot(&(p - near))).fold(f64::INFINITY, f64::min)
    }

    /// Where the ray from `p` along the unit vector `n` comes into what is nearer to the disc than
    /// `room_mm`, mm; infinite where it passes by, negative where `p` lies within.
    ///
    /// Along the ray the distance is a convex function, so Newton's method comes to its root from
    /// outside without going beyond it.
    pub fn entry_mm(&self, p: &Point, n: &Vector, room_mm: f64) -> f64 {
        // Nothing of it lies before this.
        let mut t = (self.centre - p).dot(n) - self.radius_mm - room_mm;
        for _ in 0..MOST_STEPS {
            let (d, g) = self.distance_and_gradient(&(p + n * t));
            let slope = g.dot(n);
            if d <= room_mm {
                break;
            }
            if !(slope < 0.0) {
                return f64::INFINITY;
            }
            let step = (d - room_mm) / slope;
            if -step <= ENTRY_MM {
                break;
            }
            t -= step;
        }
        t
    }

    /// The point of a triangle that is nearest to the disc, and its distance, mm.
    pub fn nearest_of_triangle(&self, corners: &[Point; 3]) -> (Point, f64) {
        if self.radius_mm == 0.0 {
            let p = closest_on_triangle(corners, &self.centre);
            return (p, (p - self.centre).norm());
        }
        let [a, b, c] = corners;
        let mut best = (*a, self.distance_mm(a));
        let mut see = |p: Point| {
            let d = self.distance_mm(&p);
            if d < best.1 {
                best = (p, d);
            }
        };
        [(a, b), (b, c), (c, a)].into_iter().for_each(|(s, e)| see(self.nearest_of_segment(s, e)));
        // A place within the triangle is nearest only to the point of the disc that lies farthest
        // towards it; or the triangle cuts the disc, in a chord that begins within the triangle or
        // crosses a side.
        if let Some(n) = (b - a).cross(&(c - a)).try_normalize(0.0) {
            let height = (self.centre - a).dot(&n);
            let slope = n - self.axis * n.dot(&self.axis);
            let steep = slope.norm();
            if steep < PARALLEL {
                see(closest_on_triangle(corners, &self.centre));
            } else {
                let down = slope / steep;
                // Heights over the triangle's plane fall along the disc by `steep`, to no less than
                // where the plane cuts it.
                let along = (-height / steep).clamp(-self.radius_mm, self.radius_mm);
                let half = (self.radius_mm * self.radius_mm - along * along).max(0.0).sqrt();
                let aside = self.axis.cross(&down) * half;
                let on = self.centre + down * along;
                for x in [on - aside, on + aside] {
                    see(closest_on_triangle(corners, &x));
                }
            }
        }
        best
    }

    /// The point of a segment that is nearest to the disc: half the squared distance is convex
    /// along it, and its derivative is in closed form.
    fn nearest_of_segment(&self, a: &Point, b: &Point) -> Point {
        let e = b - a;
        let slope = |t: f64| {
            let p = a + e * t;
            (p - self.foot(&p)).dot(&e)
        };
        if !(slope(0.0) < 0.0) {
            return *a;
        }
        if !(slope(1.0) > 0.0) {
            return *b;
        }
        let (mut low, mut high, mut t) = (0.0, 1.0, 0.5);
        for _ in 0..MOST_STEPS {
            let s = slope(t);
            if s == 0.0 {
                break;
            }
            if s < 0.0 {
                low = t
            } else {
                high = t
            }
            // Newton where it stays between the ends, else halving.
            let newton = t - s / self.bend_along(&(a + e * t), &e);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if next == t {
                break;
            }
            t = next;
        }
        a + e * t
    }

    /// Second derivative of half the squared distance at `p` along `e`.
    fn bend_along(&self, p: &Point, e: &Vector) -> f64 {
        let v = p - self.centre;
        let across = v - self.axis * v.dot(&self.axis);
        let q = across.norm();
        if q <= self.radius_mm {
            return e.dot(&self.axis).powi(2);
        }
        let round = self.axis.cross(&across) / q;
        e.norm_squared() - self.radius_mm / q * e.dot(&round).powi(2)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point> {
        [-6.0..6.0f64, -6.0..6.0f64, -6.0..6.0f64].prop_map(Point::from)
    }

    fn disc() -> impl Strategy<Value = Disc> {
        let radius = prop_oneof![Just(0.0), 0.01..4.0f64];
        (point(), point(), radius).prop_filter_map("no axis", |(centre, a, radius_mm)| {
            Some(Disc { centre, axis: a.coords.try_normalize(0.1)?, radius_mm })
        })
    }

    #[test]
    fn over_beside_and_beyond() {
        let d = Disc { centre: Point::new(1.0, 0.0, 0.0), axis: Vector::z(), radius_mm: 3.0 };
        for (p, is) in [([2.0, 1.0, 5.0], 5.0), ([4.0, 0.0, -2.0], 2.0), ([8.0, 0.0, 3.0], 5.0), ([1.0, 2.0, 0.0], 0.0)]
        {
            assert!((d.distance_mm(&p.into()) - is).abs() < 1e-15, "{p:?}");
        }
        // A triangle that cuts it with all sides and corners far off, one that lies flat over it,
        // and one that its rim touches within.
        let far = [[1.0, -40.0, -30.0], [1.0, 40.0, -30.0], [1.0, 0.0, 50.0]].map(Point::from);
        assert!(d.nearest_of_triangle(&far).1 < 1e-12);
        let flat = [[-90.0, -80.0, 2.5], [90.0, -80.0, 2.5], [0.0, 90.0, 2.5]].map(Point::from);
        assert!((d.nearest_of_triangle(&flat).1 - 2.5).abs() < 1e-12);
        let aslant = [[6.0, -90.0, -90.0], [6.0, 90.0, -90.0], [6.0, 0.0, 90.0]].map(Point::from);
        let (p, least) = d.nearest_of_triangle(&aslant);
        assert!((least - 2.0).abs() < 1e-12 && (p - Point::new(6.0, 0.0, 0.0)).norm() < 1e-9, "{p}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn a_radius_of_nothing_is_a_point(d in disc(), p in point()) {
            let d = Disc { radius_mm: 0.0, ..d };
            prop_assert_eq!(d.distance_mm(&p), (p - d.centre).norm());
        }

        #[test]
        fn tangent_planes_lie_below(d in disc(), p in point(), q in point(), side in point()) {
            let (value, g) = d.distance_and_gradient(&p);
            prop_assert!(d.distance_mm(&q) >= value + g.dot(&(q - p)) - 1e-12);
            prop_assert!((d.distance_mm(&q) - value).abs() <= (q - p).norm() + 1e-12);
            prop_assert!(d.least_in_hull_mm(&p, &[p, q]) <= d.distance_mm(&nalgebra::center(&p, &q)) + 1e-12);
            let sides = [side.coords * 0.2, Vector::zeros(), Vector::zeros()];
            prop_assert!(d.least_in_box_mm(&p, &sides) <= d.distance_mm(&(p + sides[0] * 0.7)) + 1e-12);
        }

        /// Where a ray comes in, found by walking along it as far as the disc is away.
        #[test]
        fn rays_come_in_where_they_are_as_near_as_that(
            d in disc(), p in point(), ray in point(), room_mm in 0.05..4.0f64,
        ) {
            let Some(n) = ray.coords.try_normalize(0.1) else { return Ok(()) };
            let found = d.entry_mm(&p, &n, room_mm);
            let mut t = -30.0;
            for _ in 0..20_000 {
                let left = d.distance_mm(&(p + n * t)) - room_mm;
                if left < 1e-9 || t > 30.0 { break; }
                t += left;
            }
            if t > 30.0 {
                // One that grazes may be either.
                prop_assert!(found.is_infinite() || (d.distance_mm(&(p + n * found)) - room_mm).abs() < 1e-6, "{found}");
            } else {
                prop_assert!((found - t).abs() < 1e-3 && d.distance_mm(&(p + n * found)) - room_mm < 1e-9, "{found} {t}");
            }
        }

        #[test]
        fn triangles_against_a_dense_grid(d in disc(), a in point(), b in point(), c in point()) {
            let (at, least) = d.nearest_of_triangle(&[a, b, c]);
            prop_assert!((d.distance_mm(&at) - least).abs() < 1e-12);
            prop_assert!((closest_on_triangle(&[a, b, c], &at) - at).norm() < 1e-9);
            let n = 60;
            let size = (b - a).norm().max((c - a).norm());
            let grid = (0..=n).flat_map(|i| (0..=n - i).map(move |j| (i, j))).map(|(i, j)| {
                d.distance_mm(&(a + (b - a) * (f64::from(i) / f64::from(n)) + (c - a) * (f64::from(j) / f64::from(n))))
            });
            let dense = grid.fold(f64::INFINITY, f64::min);
            prop_assert!(least <= dense + 1e-12 && dense - least < 1.5 * size / f64::from(n), "{least} {dense}");
        }

        /// No way from the place found along the triangle leads nearer.
        #[test]
        fn the_place_found_on_a_triangle_is_the_least(d in disc(), a in point(), b in point(), c in point()) {
            let (at, least) = d.nearest_of_triangle(&[a, b, c]);
            for corner in [a, b, c] {
                for share in [1e-6, 1e-4, 1e-2, 0.3, 1.0] {
                    let there = at + (corner - at) * share;
                    prop_assert!(d.distance_mm(&there) >= least - 1e-12, "{share}: {}", d.distance_mm(&there) - least);
                }
            }
        }
    }
}
