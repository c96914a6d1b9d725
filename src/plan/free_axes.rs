//! The free tool axes at some locations of a path, all over the sphere: what a report shows.

use super::Setup;
use crate::artifact::channel::Binding;
use crate::artifact::sphere::{self, CellState, FreeAlong, FreeSphere, SphereCell};
use crate::artifact::toolpath::CutterLocation;
use crate::artifact::{Axes, Plan};
use crate::channel;
use crate::error::Result;
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;

/// Locations at which the sphere is looked at, at most.
const MAPS: usize = 32;
/// Cells lie within this of their middle where they are not decided, degrees.
const FINEST_DEG: f64 = 1.0;
/// Maps are spread evenly over ball centres and surface normals, where so many mm count as much as
/// normals so far apart (the length of their difference).
const EVENLY: [f64; 2] = [4.0, 0.12];
/// Room for rounding at the ends of travel, mm or rad.
const ROUNDING: f64 = 1e-9;

impl Setup {
    /// The free tool axes at up to 32 locations of a plan in five axes, spread evenly over the
    /// places that the ball comes to: every location has a map near by, also where the turn after
    /// it is farther along the path than the blade is round. No maps where all locations have one
    /// cone, of which the channel says all, and for cutters with a corner.
    ///
    /// What taper, shank, holder and contact angle leave is proven cell by cell
    /// ([`channel::spheres`]). What the machine reaches is looked at in the middle of each cell,
    /// and in the corners of large ones.
    ///
    /// # Errors
    /// Kind `Cancelled`; those of [`channel::spheres`].
    pub fn free_axes(&self, plan: &Plan, observer: &dyn Observer) -> Result<FreeAlong> {
        let (path, tool) = (&plan.toolpath, &self.job.tool);
        if path.cones.same().is_some() || path.locations.is_empty() || !tool.is_ball() {
            return Ok(FreeAlong::default());
        }
        let (rows, nearest) = spread(&path.locations, MAPS);
        let (around, options) = (self.surroundings()?, self.channel_options());
        let found = channel::spheres(&around, tool, &path.at(&rows), &options, FINEST_DEG, observer)?;
        let reached = parallel::map(rows.iter().zip(found), |(row, sphere)| {
            let (centre, near) = (path.locations[*row].centre, plan.motion.position.get(*row).map(Axes::from));
            let out = |axis: &Vector| near.as_ref().and_then(|near| self.out_of_reach(&centre, axis, near));
            (*row, within_reach(sphere, &out))
        });
        Ok(FreeAlong { maps: reached, nearest })
    }

    /// What keeps the machine from a tool axis with the ball at a place, nearest to where its axes
    /// stand; `None`: nothing does.
    fn out_of_reach(&self, centre: &Point, axis: &Vector, near: &[f64]) -> Option<Binding> {
        let Some(turned) = self.machine.rotary_of_axis(axis, near) else { return Some(Binding::AxisLimit) };
        let at = self.machine.linear_at(centre, &turned, self.job.tool.length_mm());
        let is_out = |(k, travel): (usize, Option<[f64; 2]>)| {
            travel.is_some_and(|[lo, hi]| !(lo - ROUNDING..=hi + ROUNDING).contains(&at[k]))
        };
        let axes = self.machine.axes();
        let first = axes.iter().map(|a| a.limits.travel).enumerate().position(is_out)?;
        Some(Binding::Travel { axis: axes[first].name.clone() })
    }
}

/// Up to so many locations, in rising order, and for each location the one of them that is nearest
/// to it: always the location that is farthest from all before it comes next.
fn spread(locations: &[CutterLocation], most: usize) -> (Vec<usize>, Vec<usize>) {
    let [mm, turned] = EVENLY;
    let apart = |a: &CutterLocation, b: &CutterLocation| {
        (a.centre - b.centre).norm_squared() / (mm * mm) + (a.normal - b.normal).norm_squared() / (turned * turned)
    };
    let (mut rows, mut next) = (Vec::new(), 0);
    let mut nearest = vec![(f64::INFINITY, 0); locations.len()];
    while rows.len() < most && next < locations.len() {
        let own = nearest.iter_mut().zip(locations);
        own.for_each(|(n, l)| {
            let far = apart(l, &locations[next]);
            if far < n.0 {
                *n = (far, rows.len());
            }
        });
        rows.push(next);
        let farthest = nearest.iter().enumerate().max_by(|a, b| a.1.0.total_cmp(&b.1.0).then(b.0.cmp(&a.0)));
        match farthest {
            Some((row, (far, _))) if *far > 1e-9 && far.is_finite() => next = row,
            _ => break,
        }
    }
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|k| rows[*k]);
    let mut rank = vec![0; rows.len()];
    order.iter().enumerate().for_each(|(to, from)| rank[*from] = to);
    (order.iter().map(|k| rows[*k]).collect(), nearest.iter().map(|(_, k)| rank[*k]).collect())
}

/// The sphere without what the machine does not reach: `out` says what keeps it from an axis.
fn within_reach(from: FreeSphere, out: &dyn Fn(&Vector) -> Option<Binding>) -> FreeSphere {
    let mut to = FreeSphere { cells: Vec::with_capacity(from.cells.len()), bindings: from.bindings };
    for cell in from.cells {
        match cell.state {
            CellState::Taken(_) => to.cells.push(cell),
            _ => reach_into(&mut to, cell, out),
        }
    }
    to
}

/// Adds a cell, or its quarters where some of its axes are reached and some are not.
fn reach_into(to: &mut FreeSphere, cell: SphereCell, out: &dyn Fn(&Vector) -> Option<Binding>) {
    let [a, b, c] = cell.corners;
    let middle = (a + b + c).normalize();
    let by = out(&middle);
    let rho = [a, b, c].iter().map(|v| v.angle(&middle)).fold(0.0, f64::max);
    // The middle of a cell of the least size speaks for all of it.
    let is_mixed = || [a, b, c].iter().any(|corner| out(corner).is_some() != by.is_some());
    if rho > FINEST_DEG.to_radians() && is_mixed() {
        let quarters = sphere::quarters(&cell.corners);
        return quarters.into_iter().for_each(|corners| reach_into(to, SphereCell { corners, ..cell }, out));
    }
    let Some(by) = by else { return to.cells.push(cell) };
    let k = to.bindings.iter().position(|b| *b == by).unwrap_or_else(|| {
        to.bindings.push(by);
        to.bindings.len() - 1
    });
    to.cells.push(SphereCell { state: CellState::Taken(k as u32), ..cell });
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    /// Maps round a cylinder stand evenly about it, and each location has the one nearest to it.
    #[test]
    fn maps_are_spread_evenly_over_the_places_of_the_path() {
        let path = sample::plan(12, 90).toolpath;
        let (rows, nearest) = spread(&path.locations, 24);
        assert!(rows.len() == 24 && nearest.len() == path.locations.len());
        assert!(rows.is_sorted() && rows.windows(2).all(|w| w[0] < w[1]));
        let off = |k: usize, row: usize| {
            let (a, b) = (&path.locations[k], &path.locations[row]);
            ((a.centre - b.centre).norm(), (a.centre - b.centre).norm() / 4.0, (a.normal - b.normal).norm() / 0.12)
        };
        for (k, map) in nearest.iter().enumerate() {
            let (mm, a, b) = off(k, rows[*map]);
            // 157 mm round and 6 mm high.
            assert!(mm < 8.0, "location {k}: {mm} mm");
            let is_farther = |(_, c, d): (f64, f64, f64)| c.hypot(d) >= a.hypot(b) - 1e-9;
            assert!(rows.iter().all(|row| is_farther(off(k, *row))), "location {k}");
        }
        // A path shorter than that has a map at each of its locations.
        let (rows, nearest) = spread(&path.locations[..5], 24);
        assert_eq!((rows, nearest), (vec![0, 1, 2, 3, 4], vec![0, 1, 2, 3, 4]));
        assert_eq!(spread(&[], 24), (Vec::new(), Vec::new()));
    }

    /// Of a free sphere the half that a machine reaches stays, but for cells across its rim.
    #[test]
    fn what_the_machine_does_not_reach_is_taken() {
        let all = sphere::octants().map(|corners| SphereCell { corners, state: CellState::Free });
        let whole = FreeSphere { cells: all.to_vec(), bindings: Vec::new() };
        let rim = Vector::new(0.6, 0.0, 0.8);
        let out = |axis: &Vector| (axis.dot(&rim) < 0.5).then(|| Binding::Travel { axis: "B".into() });
        let found = within_reach(whole.clone(), &out);
        assert_eq!(found.bindings, [Binding::Travel { axis: "B".into() }]);
        let [free, taken, open] = found.shares();
        assert!((free - 0.25).abs() < 0.02 && (free + taken - 1.0).abs() < 1e-9 && open == 0.0, "{free} {taken}");
        let off = 2.0 * FINEST_DEG.to_radians();
        for cell in &found.cells {
            let middle = (cell.corners[0] + cell.corners[1] + cell.corners[2]).normalize();
            let by = middle.dot(&rim).acos() - 0.5f64.acos();
            assert!(by.abs() < off || (by > 0.0) == (cell.state == CellState::Taken(0)), "{by}");
        }
        assert_eq!(within_reach(whole.clone(), &|_| None), whole);
    }
}
