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
use crate::parallel;

/// Checks all moves against all fixtures; the stock may be cut.
///
/// # Errors
/// Kind `Infeasible` at the first location whose ball comes too near, or inside; the distance asked
/// for is the ball's radius, the clearance of taper and shank, and half of the longer move beside
/// the location.
pub(super) fn check(path: &Toolpath, blade: &Blade, obstacles: &[Obstacle]) -> Result<()> {
    let Some(first) = path.locations.first() else { return Ok(()) };
    for o in obstacles.iter().filter(|o| !o.cut_by_the_tool) {
        if winding(&o.part.mesh, &first.centre).abs() > 0.5 {
            return Err(too_near(o, (path, blade), 0, "the tool starts in collision: the ball centre is inside", true));
        }
        let step = |i: usize| {
            let beside = [i.checked_sub(1), Some(i + 1)];
            let near = beside.into_iter().flatten().filter_map(|k| path.locations.get(k));
            near.map(|l| (l.centre - path.locations[i].centre).norm()).fold(0.0, f64::max)
        };
        let clear = parallel::try_map(0..path.locations.len(), |i| {
            let cap = path.radius_mm + o.clearance_mm + 0.5 * step(i);
            o.part.closest_on_mesh(&path.locations[i].centre, cap).map_or(Ok(()), |_| Err(i))
        });
        if let Err(i) = clear {
            let start = if i == 0 { "the tool starts in collision: " } else { "" };
            let what = format!("{start}the ball comes nearer than {} mm to", o.clearance_mm);
            return Err(too_near(o, (path, blade), i, &what, false));
        }
    }
    Ok(())
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
