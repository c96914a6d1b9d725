//! Rows over the hub of a wheel, along the passage between two neighbouring blades.
//!
//! The first row runs where the ball touches the one blade or its fillet, the last where it touches
//! the other; those between divide the way from the one to the other evenly at every place along
//! the rotor axis. As many are laid as leave no higher ridge than is asked for at the worst place,
//! measured on the part. The tool runs to and fro: at the end of each row it goes over to the next
//! one along the hub, so that the whole is one path.
//!
//! **Limits.** The hub is a surface of revolution, and faces away from the rotor axis; a ball that
//! rolls sideways over it touches the blades before it has gone one pitch. Where the blades stand
//! closer, ridges are lower than asked for.

mod passage;
#[cfg(test)]
mod tests;

use super::chords;
use super::helix::assemble;
use super::level::{LevelSet, Touch};
use super::{PathOptions, least_and_greatest, spot};
use crate::artifact::{Blade, RotorFrame, Toolpath, Wheel};
use crate::error::{EndReason, Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Observer;
use crate::parallel;
use passage::{BladeFoot, Closed, Passage, Station};

/// Rows are laid anew with another number of them at most so often.
const ROUNDS: usize = 5;
/// The greatest ridge may be lower than asked for by this share before fewer rows are tried.
const LOWER: f64 = 0.06;
/// A row of balls that touch hub and blade at once keeps off the blade by so many times the
/// scallop: of two contacts neither is the true one.
const OFF_BLADE: f64 = 0.5;
/// A way is measured at so many places before its locations are laid.
const SEEN: usize = 40;
/// No passage has more rows.
const MOST_ROWS: usize = 5000;
/// A ball that is not on the hub is sought nearer to the middle of the passage, at first by so much
/// of the way, then by twice as much each time, so often.
const INWARDS: (f64, i32) = (0.001, 9);
/// ... and over facets then near to the place itself, within so many of its radii.
const BESIDE: f64 = 0.2;

/// Lays the rows.
///
/// # Errors
/// Kind `Usage` where the rotor axis is along the blade; kind `Infeasible` where there is no hub
/// between the blades or they stand too close for the ball, with the place and the ball that fits;
/// kind `Cancelled`.
pub fn plan(
    blade: &Blade,
    level: &LevelSet,
    wheel: &Wheel,
    options: &PathOptions,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let frame = RotorFrame::new(wheel).ok_or_else(|| Error::usage(Stage::Path, "the rotor axis is along the blade"))?;
    let passage = Passage { level, frame: &frame };
    let [low_mm, high_mm] = blade.regions.airfoil_x_mm();
    let foot = BladeFoot { at: Point::new(low_mm, 0.0, 0.0), blade_mm: high_mm - low_mm };
    let stations = passage.stations(&foot).map_err(|why| closed(blade, why, options))?;
    let Some(rows) = HubRows::new(blade, passage, &stations, options) else {
        return Err(closed(blade, Closed::NoHub(foot.at), options));
    };
    let scallop_mm = options.settings.scallop_mm;
    let mut count = rows.least_count();
    let (mut best, mut tried_mm): (Option<Toolpath>, f64) = (None, 0.0);
    for round in 0..ROUNDS {
        observer.check(Stage::Path)?;
        observer.progress(Stage::Path, round, ROUNDS);
        let path = rows.laid(count)?;
        let height_mm = path.planned_scallop_mm;
        let is_low = height_mm <= scallop_mm;
        tried_mm = height_mm;
        if is_low && best.as_ref().is_none_or(|b| b.turns.len() > count) {
            best = Some(path);
        }
        let share = (height_mm / scallop_mm).sqrt();
        let wanted = ((count - 1) as f64 * share * (1.0 + 0.25 * LOWER)).ceil() as usize + 1;
        let next = if is_low { wanted.clamp(2, count) } else { wanted.max(count + 1) };
        let tried = best.as_ref().is_some_and(|b| next >= b.turns.len());
        let is_last = round + 1 == ROUNDS || next > MOST_ROWS;
        if is_last || tried || next == count || is_low && share * share > 1.0 - LOWER {
            break;
        }
        count = next;
    }
    best.ok_or_else(|| {
        let message = format!(
            "{count} rows over the hub between two blades leave ridges of {tried_mm:.6} mm, path.scallop_mm is {scallop_mm}"
        );
        let since = Infeasible::RowsTooHigh { rows: count, ridge_mm: tried_mm, scallop_mm };
        Error::infeasible(Stage::Path, message, since).advise("set a higher path.scallop_mm")
    })
}

/// The error of a passage that is closed.
fn closed(blade: &Blade, why: Closed, options: &PathOptions) -> Error {
    let ball_mm = options.radius_mm;
    let at = match &why {
        Closed::NoHub(p) | Closed::Gap(p, _) => spot(blade, p),
    };
    let [x, y, z] = at.point_mm;
    let place = format!("({x:.3}, {y:.3}, {z:.3}) mm of the model");
    match why {
        Closed::NoHub(_) => {
            let message = format!(
                "no hub is found beside the foot of the blade at {place}: no surface round the rotor axis that a ball of {ball_mm} mm touches between two blades"
            );
            Error::infeasible(Stage::Path, message, Infeasible::NoHub { near: at }).advise(
                "give a model that has the hub (a sector of the wheel, or all of it), and the rotor axis of that model",
            )
        }
        Closed::Gap(_, room_mm) => {
            let message = format!(
                "two blades leave no room on the hub for a ball of {ball_mm} mm at {place}: one of {room_mm:.3} mm fits there"
            );
            let cause = Infeasible::BladesTooClose { near: at, radius_mm: ball_mm, room_mm };
            Error::infeasible(Stage::Path, message, cause).advise("take a smaller ball")
        }
    }
}

/// A row, as a share of the way from the middle of the passage to either side.
struct HubRows<'a> {
    passage: Passage<'a>,
    /// Middle and half width of the passage, rad, and the ball's distance from the rotor axis, mm,
    /// over the place along that axis.
    along: CubicSpline,
    ends_mm: [f64; 2],
    options: &'a PathOptions,
    blade: &'a Blade,
}

impl<'a> HubRows<'a> {
    /// `None` where there are too few stations for a row.
    fn new(blade: &'a Blade, passage: Passage<'a>, stations: &[Station], options: &'a PathOptions) -> Option<Self> {
        let z_mm: Vec<f64> = stations.iter().map(|s| s.z_mm).collect();
        let off_mm = OFF_BLADE * options.settings.scallop_mm;
        let values: Vec<f64> =
            stations.iter().flat_map(|s| [s.middle_rad, s.half_rad - off_mm / s.radius_mm, s.radius_mm]).collect();
        let along = CubicSpline::new(&z_mm, &values, 3, &SplineEnds::Natural).ok()?;
        let ends_mm = [*z_mm.first()?, *z_mm.last()?];
        Some(HubRows { passage, along, ends_mm, options, blade })
    }

    /// The ball of a row at a place.
    fn at(&self, z_mm: f64, row: f64) -> Result<Touch> {
        let [middle_rad, half_rad, radius_mm] = [0, 1, 2].map(|k| self.along.value(z_mm, k));
        // Where the passage stops to widen, a spline goes beyond its width.
        let (i, stations) = (self.along.interval(z_mm), self.along.abscissae());
        let [a, b] = [i, i + 1].map(|k| self.along.value(stations[k.min(stations.len() - 1)], 1));
        let half_rad = half_rad.min(a.max(b));
        let (step, most) = INWARDS;
        let nearer = (0..=most).map(|k| row * (1.0 - step * (2f64.powi(k) - 1.0)));
        let mut found = nearer.filter_map(|row| self.passage.on_hub(z_mm, middle_rad + row * half_rad, radius_mm));
        // Single facets may stand otherwise than the hub that they are of; the ball touches them
        // all the same.
        let on_facets = || {
            let guess = self.passage.frame.point(z_mm, middle_rad + row * half_rad, radius_mm);
            let level = Some(self.passage.level).filter(|level| level.is_over_facets())?;
            level.touch_across(&guess, &self.passage.frame.axis(), BESIDE * self.options.radius_mm)
        };
        found.next().or_else(on_facets).ok_or_else(|| {
            let at = spot(self.blade, &self.passage.frame.point(z_mm, middle_rad + row * half_rad, radius_mm));
            let [x, y, z] = at.point_mm;
            let message = format!(
                "the ball of {} mm loses the hub at ({x:.3}, {y:.3}, {z:.3}) mm of the model",
                self.options.radius_mm
            );
            Error::infeasible(Stage::Path, message, Infeasible::NoHub { near: at }).advise("take a smaller ball")
        })
    }

    /// As many rows as the widest place of the passage needs on flat ground.
    fn least_count(&self) -> usize {
        let z_mm = self.along.abscissae();
        let width = |pair: &[f64]| {
            let [a, b] = [pair[0], pair[1]];
            let radius_mm = self.along.value(a, 2);
            let turn = (self.along.value(b, 0) - self.along.value(a, 0)) * radius_mm / (b - a);
            2.0 * self.along.value(a, 1) * radius_mm / turn.hypot(1.0)
        };
        let widest_mm = z_mm.windows(2).map(width).fold(0.0, f64::max);
        let flat_mm = self.options.flat_mm(self.options.settings.scallop_mm);
        ((widest_mm / flat_mm).ceil() as usize + 1).clamp(2, MOST_ROWS)
    }

    /// The path of so many rows.
    fn laid(&self, count: usize) -> Result<Toolpath> {
        let share = |k: usize| 2.0 * k as f64 / (count - 1) as f64 - 1.0;
        let [a_mm, b_mm] = self.ends_mm;
        let z_mm =
            |k: usize, u: f64| if k.is_multiple_of(2) { a_mm + u * (b_mm - a_mm) } else { b_mm + u * (a_mm - b_mm) };
        let row = |k: usize| -> Result<Vec<Touch>> {
            let mut touches = self.filled(|u| self.at(z_mm(k, u), share(k)))?;
            if k + 1 < count {
                touches.extend(self.filled(|u| self.at(z_mm(k, 1.0), share(k) + u * (share(k + 1) - share(k))))?);
            }
            Ok(touches)
        };
        let rows = parallel::try_map(0..count, row)?;
        let end = self.at(z_mm(count - 1, 1.0), share(count - 1))?;
        let range_mm = least_and_greatest(rows.iter().flatten().map(|t| t.centre.x));
        Ok(assemble(self.passage.level, self.options, &rows, end, range_mm, EndReason::Region).0)
    }

    /// Touches along a way from 0 to 1, the last one left out.
    fn filled(&self, at: impl Fn(f64) -> Result<Touch>) -> Result<Vec<Touch>> {
        let seen: Vec<Touch> = (0..=SEEN).map(|k| at(k as f64 / SEEN as f64)).collect::<Result<_>>()?;
        let length_mm: f64 = seen.windows(2).map(|w| (w[1].centre - w[0].centre).norm()).sum();
        let pieces = (length_mm / self.options.settings.max_step_mm).ceil().max(1.0) as usize;
        let places: Vec<f64> = (0..=pieces).map(|k| k as f64 / pieces as f64).collect();
        chords::fill(self.passage.level, at, &places, self.options)
    }
}
