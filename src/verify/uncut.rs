//! What no ball of this radius can reach: inner corners narrower than the ball, where the surface of ball centres has a crease.
//!
//! Even samples of the part near the path are tried with a ball that touches them. Where it would cut in elsewhere it is pushed
//! out, again and again along the distance to what it cuts into, until it fits: it then touches what is in the way on both
//! sides. If the swept path passes there and the sample stays farther from that ball than [`UNCUT`] of the scallop, the material over the
//! sample is left for good, whatever the stepover. Another place for the ball might come a little nearer, so the area is an upper bound
//! of that of a height of just this much.

use rayon::prelude::*;

use super::samples;
use super::scallop::{REACH_SLACK, UNCUT};
use super::sweep::Sweep;
use crate::artifact::report::UncutPlace;
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;

/// A ball that is pushed out so often has found its place to a hundredth of a micrometre in all but the shallowest corners.
const MOST_PUSHES: usize = 200;

/// Places, and the area that each stands for, mm².
pub(super) fn measure(part: &Allowed, sweep: &Sweep, scallop_mm: f64, count: usize) -> (Vec<UncutPlace>, f64) {
    let radius = sweep.radius_mm;
    let stepover = (8.0 * radius * scallop_mm).sqrt();
    // A ball in a corner is as far as its radius from where it would touch the walls.
    let all = samples::near_path(part, sweep, radius + stepover, count);
    let place = |s: &samples::Sample| {
        let touching = s.point + s.normal * radius;
        let ball = pushed_out(part, &touching, radius, REACH_SLACK * scallop_mm)?;
        let left_mm = (ball - s.point).norm() - radius;
        let passed = left_mm > UNCUT * scallop_mm && sweep.nearest(&ball, stepover, |_| true).is_some();
        passed.then(|| UncutPlace { point: s.point, normal: s.normal, left_mm })
    };
    (all.points.par_iter().filter_map(place).collect(), all.area_mm2)
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
