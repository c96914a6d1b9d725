//! The ball among fixtures: it must keep clear of them too, and the tool must not be inside one
//! from the start.
//!
//! From the part the ball is kept by the path. A fixture is closed: where the first ball centre is
//! outside and no move brings the ball to its surface, ball and tool stay outside.

use super::report;
use crate::artifact::{Blade, Obstacle, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage, turn_number};
use crate::geometry::Point;
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::parallel;

/// Of a shorter part of a move its ends say enough, mm: in between the ball comes nearer by half as
/// much at most.
const SHORTEST_MM: f64 = 1e-3;

/// Checks all moves against all fixtures; the stock may be cut.
///
/// # Errors
/// Kind `Infeasible` at the first location whose ball comes too near, there or on the move to the
/// next, or inside; the distance asked for is the ball's radius and the clearance of taper and
/// shank.
pub(super) fn check(path: &Toolpath, blade: &Blade, obstacles: &[Obstacle]) -> Result<()> {
    let Some(first) = path.locations.first() else { return Ok(()) };
    for o in obstacles.iter().filter(|o| !o.cut_by_the_tool) {
        if winding(&o.part.mesh, &first.centre).abs() > 0.5 {
            return Err(too_near(o, (path, blade), 0, "the tool starts in collision: the ball centre is inside", true));
        }
        let need_mm = path.radius_mm + o.clearance_mm;
        let clear = parallel::try_map(0..path.locations.len(), |i| {
            let from = path.locations[i].centre;
            let to = path.locations.get(i + 1).map_or(from, |l| l.centre);
            if keeps_off(&o.part, [from, to], need_mm) { Ok(()) } else { Err(i) }
        });
        if let Err(i) = clear {
            let start = if i == 0 { "the tool starts in collision: " } else { "" };
            let what = format!("{start}the ball comes nearer than {} mm to", o.clearance_mm);
            return Err(too_near(o, (path, blade), i, &what, false));
        }
    }
    Ok(())
}

/// Whether all of a straight move keeps so far from the surface of a body: it is halved until the
/// distances at both ends say so for all between, or one of them is too small, or a part is as
/// short as nothing.
fn keeps_off(part: &Part, ends: [Point; 2], need_mm: f64) -> bool {
    let off = |p: &Point, cap_mm: f64| part.closest_on_mesh(p, cap_mm).map_or(cap_mm, |c| c.distance_mm);
    let mut parts = vec![ends];
    while let Some([a, b]) = parts.pop() {
        let length_mm = (b - a).norm();
        let cap_mm = need_mm + length_mm;
        let (from, to) = (off(&a, cap_mm), off(&b, cap_mm));
        if from.min(to) < need_mm {
            return false;
        }
        if 0.5 * (from + to - length_mm) < need_mm && length_mm > SHORTEST_MM {
            let middle = nalgebra::center(&a, &b);
            parts.extend([[a, middle], [middle, b]]);
        }
    }
    true
}

fn too_near(o: &Obstacle, (path, blade): (&Toolpath, &Blade), i: usize, what: &str, inside: bool) -> Error {
    let place = path.locations.get(i).map_or_else(String::new, |l| {
        let turn = turn_number(l.turn);
        format!("turn {turn}, S = {:.2} mm, {:.3} mm along the blade axis", l.turn_s_mm, l.centre.x)
    });
    let since = Infeasible::BallNearFixture {
        at: report::at(path, i, |p| blade.model_from_blade * p),
        name: o.name.clone(),
        clearance_mm: o.clearance_mm,
        inside,
    };
    Error::infeasible(Stage::Channel, format!("{what} {} at {place}", o.name), since)
        .advise("move the fixture, let the region end before it, or let it keep less clearance")
}

/// How often the closed mesh winds round a point: 0 outside, ±1 inside.
fn winding(mesh: &Mesh, p: &Point) -> f64 {
    let solid_angle = |t: usize| {
        let [a, b, c] = mesh.corners(t).map(|q| q - p);
        let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
        let below = la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb;
        2.0 * a.dot(&b.cross(&c)).atan2(below)
    };
    (0..mesh.triangles.len()).map(solid_angle).sum::<f64>() / (4.0 * std::f64::consts::PI)
}
