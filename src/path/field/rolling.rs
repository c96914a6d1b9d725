//! Where a ball would only roll over a sharp edge of the part: its contact stays on the edge while
//! its centre goes on. A path that came there would cut nothing more.

use super::super::level::{LevelSet, Touch};
use crate::geometry::Vector;

/// Turn of a step by which the ball is tried to roll, rad.
const TRY_RAD: f64 = 0.01;
/// Turn of the steps by which the rolling is followed, rad, and how many at most.
const STEP_RAD: f64 = 0.1;
const MOST_STEPS: usize = 14;
/// While it rolls, the contact moves along the step by less than this share of what the centre
/// does: the edge is no rounder than a hundredth of the ball.
const STILL: f64 = 0.01;
/// Turn of the normal about an edge from which on the edge is sharp, rad, on exact faces and on a
/// mesh: less are the edges between faces, and facets over curved ones.
const SHARP_RAD: [f64; 2] = [0.6, 1.0];
/// Cosine of the angle between the region's axis and an edge up to which turns may go over the
/// edge: 60°. A blunt trailing edge is one.
const UPRIGHT: f64 = 0.5;
/// Least part of the region's axis within the tangent plane: on ground across it nothing rolls up
/// or down.
const LEAST_RISE: f64 = 0.05;

/// Whether the ball, moved up or down the region, rolls over a sharp edge that lies across it.
pub fn rolls_off(level: &LevelSet, touch: &Touch) -> bool {
    let axis = level.along.axis();
    let rise = axis - touch.normal * axis.dot(&touch.normal);
    if rise.norm() < LEAST_RISE {
        return false;
    }
    let up = rise.normalize();
    [up, -up].iter().any(|way| rolls(level, touch, way) && is_sharp(level, touch, way))
}

/// One step along the level set, if the ball rolls over an edge in it.
fn step(level: &LevelSet, from: &Touch, way: &Vector, turn_rad: f64) -> Option<Touch> {
    let length_mm = turn_rad * level.radius_mm;
    let to = level.touch(&(from.centre + way * length_mm), length_mm)?;
    let gone = to.centre - from.centre;
    let still = (to.contact - from.contact).dot(way).abs() < STILL * gone.norm();
    (still && gone.dot(way) > 0.5 * length_mm).then_some(to)
}

/// Whether the contact stays while the centre is moved: one closest point tells of most balls that
/// they do not roll.
fn rolls(level: &LevelSet, from: &Touch, way: &Vector) -> bool {
    let gone_mm = TRY_RAD * level.radius_mm;
    let near = level.part.closest(&(from.centre + way * gone_mm), 2.0 * level.radius_mm);
    near.is_some_and(|c| (c.point - from.contact).dot(way).abs() < STILL * gone_mm)
        && step(level, from, way, TRY_RAD).is_some()
}

/// Whether the edge on which a ball rolls turns enough, and lies across the region.
fn is_sharp(level: &LevelSet, from: &Touch, way: &Vector) -> bool {
    let ends = [*way, -way].map(|way| {
        let (mut here, mut way) = (*from, way);
        for _ in 0..MOST_STEPS {
            let Some(next) = step(level, &here, &way, STEP_RAD) else { break };
            let flat = way - next.normal * way.dot(&next.normal);
            here = next;
            match flat.try_normalize(1e-6) {
                Some(on) => way = on,
                None => break,
            }
        }
        here
    });
    let facets = usize::from(level.is_over_facets());
    let edge = ends[0].normal.cross(&ends[1].normal).try_normalize(1e-9);
    ends[0].normal.angle(&ends[1].normal) >= SHARP_RAD[facets]
        && edge.is_some_and(|e| level.along.axis().dot(&e).abs() < UPRIGHT)
}
