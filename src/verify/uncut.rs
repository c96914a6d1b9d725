//! What no ball of this radius can reach: inner corners narrower than the ball, where the surface
//! of ball centres has a crease.
//!
//! Even samples of the part near the path are tried with a ball that touches them. Where it would
//! cut in elsewhere it is pushed out, again and again along the distance to what it cuts into,
//! until it fits: it then touches what is in the way on both sides. If the swept path passes there
//! and the sample stays farther from that ball than [`UNCUT`] of the scallop, the material over the
//! sample is left for good, whatever the stepover.
//!
//! **Limits**: in corners that open by more than 90° the ball is pushed too far out, so that some
//! of these places are taken for beside the path: there the area is too small (by about a third at
//! 120°).

use super::height::{REACH_SLACK, UNCUT, flat_stepover};
use super::samples;
use super::sweep::Sweep;
use crate::artifact::report::UncutPlace;
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::parallel;

/// A ball that is pushed out so often has found its place to a hundredth of a micrometre in all but
/// the shallowest corners.
const MOST_PUSHES: usize = 200;

/// Places, and the area that each stands for, mm².
pub(super) fn measure(part: &Allowed, sweep: &Sweep, scallop_mm: f64, count: usize) -> (Vec<UncutPlace>, f64) {
    let radius = sweep.radius_mm;
    let stepover = flat_stepover(radius, scallop_mm);
    // A ball in a corner is as far as its radius from where it would touch the walls.
    let all = samples::near_path(part, sweep, radius + stepover, count);
    let place = |s: &samples::Sample| {
        let touching = s.point + s.normal * radius;
        let ball = pushed_out(part, &touching, radius, REACH_SLACK * scallop_mm)?;
        let left_mm = (ball - s.point).norm() - radius;
        let passed = left_mm > UNCUT * scallop_mm && sweep.nearest(&ball, stepover, |_| true).is_some();
        passed.then_some(UncutPlace { point: s.point, normal: s.normal, left_mm })
    };
    (parallel::filter_map(&all.points, place), all.area_mm2)
}

/// Where a ball fits that was to be at `centre`; `None` where it fits there, or nowhere near.
fn pushed_out(part: &Allowed, centre: &Point, radius: f64, slack_mm: f64) -> Option<Point> {
    let mut q = *centre;
    for push in 0..MOST_PUSHES {
        let Some(near) = part.closest(&q, radius - slack_mm) else {
            return (push > 0).then_some(q);
        };
        let away = (q - near.point).try_normalize(1e-9).unwrap_or(near.normal);
        q = near.point + away * radius;
        if (q - centre).norm() > 2.0 * radius {
            return None;
        }
    }
    Some(q)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::Cones;
    use crate::artifact::toolpath::{CutterLocation, PathKind, Toolpath, Turn};
    use crate::error::EndReason;
    use crate::geometry::Vector;
    use crate::geometry::mesh::Mesh;
    use crate::geometry::part::Part;

    /// Two walls, y = 0 and z = 0, that meet in an inner corner along x.
    fn corner(opening_deg: f64) -> Part {
        let (s, c) = opening_deg.to_radians().sin_cos();
        let at = |x: f64, r: f64, y: f64, z: f64| Point::new(x, r * y, r * z);
        let points = vec![
            at(-20.0, 0.0, 1.0, 0.0),
            at(20.0, 0.0, 1.0, 0.0),
            at(-20.0, 20.0, 1.0, 0.0),
            at(20.0, 20.0, 1.0, 0.0),
            at(-20.0, 20.0, c, s),
            at(20.0, 20.0, c, s),
        ];
        let triangles = vec![[0, 1, 3], [0, 3, 2], [0, 5, 1], [0, 4, 5]];
        let part = Part::from_mesh(Mesh { points, triangles, ..Mesh::default() });
        assert!(part.mesh.normal(0).z > 0.9);
        part
    }

    fn along_the_corner(radius_mm: f64, opening_deg: f64, scallop_mm: f64) -> Toolpath {
        let half = (0.5 * opening_deg).to_radians();
        let (y, z) = (radius_mm / half.tan(), radius_mm);
        let location = |k: usize| {
            let x = -8.0 + 0.25 * k as f64;
            CutterLocation {
                turn: 0,
                turn_s_mm: x + 8.0,
                s_mm: x + 8.0,
                centre: Point::new(x, y, z),
                contact: Point::new(x, y, 0.0),
                normal: Vector::z(),
            }
        };
        let locations: Vec<_> = (0..=64).map(location).collect();
        Toolpath {
            kind: PathKind::default(),
            stock_mm: 0.0,
            radius_mm,
            disc_radius_mm: 0.0,
            scallop_mm,
            chord_mm: 0.001,
            region_x_mm: [-8.0, 8.0],
            end_reason: EndReason::Region,
            planned_scallop_mm: scallop_mm,
            cones: Cones::about_blade(0.0),
            axis_turning: None,
            turns: vec![Turn { first: 0, count: locations.len(), length_mm: 16.0 }],
            locations,
        }
    }

    #[test]
    fn strips_beside_an_inner_corner_are_as_wide_as_the_closed_form() {
        let (radius, scallop) = (3.0, 0.01);
        let opening = 90.0;
        let part = corner(opening);
        let path = along_the_corner(radius, opening, scallop);
        let target = Allowed::new(&part, 0.0);
        let (places, cell) = measure(&target, &Sweep::new(&path), scallop, 40_000);
        // The ball touches each wall this far from the corner, and a point w farther in is sqrt(w²
        // +
        // R²) from its centre.
        let touches = radius / (0.5f64 * f64::to_radians(opening)).tan();
        let least = UNCUT * scallop;
        let width = touches - (2.0 * radius * least + least * least).sqrt();
        let length = 16.0 + 2.0 * (8.0 * radius * scallop).sqrt();
        let area = places.len() as f64 * cell;
        assert!((area / (2.0 * width * length) - 1.0).abs() < 0.02, "{opening}: {area} {}", 2.0 * width * length);
        let most = places.iter().map(|p| p.left_mm).fold(0.0, f64::max);
        let in_corner = touches.hypot(radius) - radius;
        assert!(most <= in_corner && most > 0.95 * in_corner, "{most} {in_corner}");
        // Where the ball fits, nothing stays.
        let flat = corner(180.0 - 1e-9);
        let path = along_the_corner(radius, 90.0, scallop);
        assert!(measure(&Allowed::new(&flat, 0.0), &Sweep::new(&path), scallop, 4000).0.is_empty());
    }
}
