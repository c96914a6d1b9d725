//! Where a cutter with a corner stands that touches a part.
//!
//! The cutter is a disc of radius `R` with a ball of radius `r` rolled over it
//! ([`crate::geometry::disc`]): a bull-nose or flat end mill of radius `R + r`, and with `R = 0` a
//! ball. It touches a surface at a contact `p` with outward normal `n` where the point of the disc
//! farthest against `n` is `p + r n`. With the tool axis `a` at the angle `α` from `n` that is on
//! the disc's rim, so
//! ```text
//! centre of the disc = p + r n + R (n − a cos α) / sin α
//! tip of the cutter  = centre − r a
//! ```
//! Where `a` is along `n` the whole bottom touches, and any point of the disc may be the one over
//! `p`.

use super::Tool;
use crate::geometry::disc::Disc;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::{Point, Vector};

/// Nearer than this to the normal, sine, an axis is along it.
const ALONG: f64 = 1e-9;
/// From here on a touch is closed in on by secants, mm.
const NEAR_MM: f64 = 1e-3;
/// A touch is known to this, mm.
const TOUCH_MM: f64 = 1e-10;
const MOST_STEPS: usize = 200;
/// Where a cutter grazes, what is left falls slower than it moves; so many times at most is made of
/// that.
const MOST_STEEPER: f64 = 10.0;
/// Places are resolved to this on the way there, mm.
const APART_MM: f64 = 1e-5;

impl Tool {
    /// The disc that the corner rolls over, for a tool with its disc's centre (a ball's own) here.
    pub fn disc(&self, centre: Point, axis: Vector) -> Disc {
        Disc { centre, axis, radius_mm: self.disc_radius_mm() }
    }

    /// Centre of the disc of a cutter that touches a surface at `contact` with the unit outward
    /// `normal`, its unit `axis` from tip to spindle, mm. `aside`, of any length, says on which
    /// side of the contact the middle lies where the axis is along the normal; `None` where that is
    /// not given then, or the axis leans away from the surface by more than a right angle.
    pub fn centre_at(&self, contact: &Point, normal: &Vector, axis: &Vector, aside: Option<&Vector>) -> Option<Point> {
        let (over, disc_mm) = (contact + normal * self.corner_mm(), self.disc_radius_mm());
        if disc_mm == 0.0 {
            return Some(over);
        }
        let cosine = axis.dot(normal);
        if !(cosine >= 0.0) {
            return None;
        }
        let across = normal - axis * cosine;
        let sine = across.norm();
        if sine > ALONG {
            return Some(over + across * (disc_mm / sine));
        }
        let aside = aside?;
        let along = (aside - axis * aside.dot(axis)).try_normalize(1e-12)?;
        Some(over + along * disc_mm)
    }

    /// How far a cutter may come along `-normal` (unit) from `centre` until its corner touches the
    /// part, with `stock_mm` left on that, mm; no farther than `reach_mm`. `None` where nothing is
    /// met in that reach or is only grazed, or where the cutter touches or cuts the part at the
    /// beginning.
    pub fn touch_mm(
        &self,
        search: &mut DiscSearch,
        (centre, axis): (&Point, &Vector),
        normal: &Vector,
        stock_mm: f64,
        reach_mm: f64,
    ) -> Option<f64> {
        let room = self.corner_mm() + stock_mm;
        let mut left = |way: f64| {
            let disc = self.disc(centre - normal * way, *axis);
            Some((way, search.closest(&disc, f64::INFINITY, APART_MM)?.distance_mm - room))
        };
        // Ways before the touch and beyond it, with what is left then.
        let (mut low, mut high) = (left(0.0)?, None::<(f64, f64)>);
        if !(low.1 > 0.0) {
            return None;
        }
        let mut steeper = 1.0f64;
        for _ in 0..MOST_STEPS {
            if low.0 > reach_mm {
                return None;
            }
            let next = match high {
                _ if low.1 <= TOUCH_MM => return Some(low.0),
                Some(h) if h.0 - low.0 <= TOUCH_MM => return Some(low.0),
                Some(h) => {
                    let secant = low.0 + (h.0 - low.0) * low.1 / (low.1 - h.1);
                    secant.clamp(low.0 + 0.01 * (h.0 - low.0), h.0 - 0.01 * (h.0 - low.0))
                }
                // What is left falls no faster than the cutter moves: such a step goes past
                // nothing.
                None if low.1 > NEAR_MM => low.0 + low.1,
                None => low.0 + low.1 * steeper,
            };
            let there = left(next)?;
            if there.1 < 0.0 {
                high = Some(there);
            } else {
                steeper = ((there.0 - low.0) / (low.1 - there.1)).clamp(1.0, MOST_STEEPER);
                low = there;
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::brep::{Brep, Face, FaceName, SurfaceKind};
    use crate::geometry::exact::tests::block;
    use crate::geometry::nurbs::NurbsSurface;
    use crate::geometry::nurbs::shapes::{cone, cylinder, sphere, torus};
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use proptest::prelude::*;
    use std::sync::LazyLock;

    fn bull(radius_mm: f64, corner_mm: f64) -> Tool {
        let corner_radius_mm = Some(corner_mm).filter(|r| *r < radius_mm);
        Tool {
            radius_mm,
            corner_radius_mm,
            taper_deg: 0.0,
            shank_radius_mm: radius_mm,
            stickout_mm: 60.0,
            holder: vec![],
        }
    }

    fn sheet(surface: NurbsSurface) -> Part {
        let face =
            Face { name: FaceName::Numbered(1), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
        Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &Silent).unwrap()
    }

    static PARTS: LazyLock<[Part; 5]> = LazyLock::new(|| {
        let plane = Part::from_brep(block(Vector::new(90.0, 80.0, 10.0)), 0.05, &Silent).unwrap();
        [plane, sheet(sphere(12.0)), sheet(cylinder(7.0, 60.0)), sheet(cone(20.0, 80.0)), sheet(torus(15.0, 4.0))]
    });

    /// Contact and normal on a plane, a sphere, a cylinder, a cone and the outer half of a torus:
    /// on each the surface lies behind its tangent plane, so that a cutter that touches there
    /// touches nowhere else.
    fn contact(kind: usize, u: f64, v: f64) -> (&'static Part, Point, Vector) {
        let (s, c) = (std::f64::consts::TAU * u).sin_cos();
        let out = Vector::new(c, s, 0.0);
        let part = &PARTS[kind.min(4)];
        match kind {
            0 => (part, Point::new(30.0 + 30.0 * u, 20.0 + 40.0 * v, 10.0), Vector::z()),
            1 => {
                let n = out * (0.3 + 0.5 * v).cos() + Vector::z() * (0.3 + 0.5 * v).sin();
                (part, Point::from(n * 12.0), n)
            }
            2 => (part, Point::from(out * 7.0 + Vector::z() * (25.0 + 10.0 * v)), out),
            3 => {
                // Opening upwards, so its normals point down a little.
                let height = 30.0 + 20.0 * v;
                let n = Vector::new(c * 80.0, s * 80.0, -20.0).normalize();
                (part, Point::from(out * (height / 4.0) + Vector::z() * height), n)
            }
            _ => {
                let a = 1.2 * (v - 0.5);
                let n = out * a.cos() + Vector::z() * a.sin();
                (part, Point::from(out * 15.0 + n * 4.0), n)
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn closed_forms_of_five_surfaces(
            kind in 0usize..5, u in 0.0..1.0f64, v in 0.0..1.0f64, radius in 1.0..8.0f64, share in 0.01..1.0f64,
            alpha in 0.02..1.5f64, turn in 0.0..6.0f64, off in 0.0..0.7f64,
        ) {
            let (part, p, n) = contact(kind, u, v);
            let tool = bull(radius, share * radius);
            let e = n.cross(&Vector::new(0.3, -0.5, 0.8)).normalize();
            let axis = n * alpha.cos() + (e * turn.cos() + n.cross(&e) * turn.sin()) * alpha.sin();
            let centre = tool.centre_at(&p, &n, &axis, None).unwrap();
            let mut search = DiscSearch::new(part);
            // Where it touches, and lifted off along the normal.
            for off in [0.0, off] {
                let disc = tool.disc(centre + n * off, axis);
                let near = search.closest(&disc, f64::INFINITY, 1e-6).unwrap();
                let room = near.distance_mm - tool.corner_mm();
                prop_assert!((room - off).abs() < 1e-9, "{kind}: {room} {off}");
                prop_assert!(near.least_mm <= near.distance_mm && near.least_mm > near.distance_mm - 1e-3);
                prop_assert!((near.at.point - p).norm() < 1e-3, "{kind}: {} {p}", near.at.point);
                if off > 0.0 {
                    prop_assert!((near.at.normal - n).norm() < 1e-3);
                }
            }
            let way = tool.touch_mm(&mut search, (&(centre + n * (0.1 + off)), &axis), &n, 0.0, 9.0).unwrap();
            prop_assert!((way - 0.1 - off).abs() < 1e-9, "{kind}: {way} {}", 0.1 + off);
            let way = tool.touch_mm(&mut search, (&(centre + n * (0.3 + off)), &axis), &n, 0.2, 9.0).unwrap();
            prop_assert!((way - 0.1 - off).abs() < 1e-9, "{kind}: with stock, {way}");
        }
    }

    #[test]
    fn a_ball_and_a_flat_bottom() {
        let (p, n) = (Point::new(1.0, 2.0, 3.0), Vector::z());
        let ball = bull(4.0, 4.0);
        assert_eq!(ball.centre_at(&p, &n, &Vector::new(0.6, 0.0, 0.8), None).unwrap(), p + n * 4.0);
        let flat = bull(4.0, 1.0);
        assert!(flat.centre_at(&p, &n, &n, None).is_none());
        assert!(flat.centre_at(&p, &n, &-n, Some(&Vector::x())).is_none());
        let beside = flat.centre_at(&p, &n, &n, Some(&Vector::new(2.0, 0.0, 5.0))).unwrap();
        assert!((beside - Point::new(4.0, 2.0, 4.0)).norm() < 1e-12);
    }

    #[test]
    fn nothing_to_touch() {
        let part = Part::from_brep(block(Vector::new(9.0, 4.0, 6.0)), 0.05, &Silent).unwrap();
        let (mut search, tool) = (DiscSearch::new(&part), bull(3.0, 1.0));
        let mut touch = |z: f64, down: Vector, reach: f64| {
            tool.touch_mm(&mut search, (&Point::new(4.0, 2.0, z), &Vector::z()), &down, 0.0, reach)
        };
        assert!((touch(12.0, Vector::z(), 9.0).unwrap() - 5.0).abs() < 1e-9);
        assert_eq!(touch(12.0, Vector::z(), 4.0), None);
        assert_eq!(touch(12.0, -Vector::z(), 40.0), None);
        assert_eq!(touch(6.5, Vector::z(), 40.0), None);
    }
}
