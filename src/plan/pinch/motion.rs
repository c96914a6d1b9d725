//! Nine axes in one clock: rows of two tools as motions of a machine with two heads.
//!
//! Each stretch is one motion, from rest to rest, while both leans stand still, and mostly the
//! table. Its parameter is the way of the tool that goes farther. Before it both tools come down
//! along their own axes, slower from the feed height on. Behind it they leave along them, until
//! every point of both is farther from the axis of the table than any point of the part: beyond a
//! plane square to the tool's direction, which the part turns under. From stretch to stretch all
//! axes move in a straight line between such places, so both tools stay beyond their planes,
//! however far the table turns.

use super::Pinch;
use crate::artifact::paired::{Held, PinchMotion, StretchMotion};
use crate::artifact::{Axes, AxisRows, PairedRows};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::feed::{self, FeedOptions};
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::observe::{Observer, Silent};
use crate::pair::Planned;
use crate::parallel;
use crate::plan::Setup;
use crate::plan::schedules::keep_fastest;
use crate::tool::lowest_mm;

/// Room beyond what the part turns in, mm.
const ROOM_MM: f64 = 5.0;
/// Positions this far beyond a travel are rounding, mm or rad.
const ROUNDING: f64 = 1e-9;
/// Shorter ways are none, mm.
const SHORTEST_MM: f64 = 1e-6;

/// The motions of a machine with two heads; `None` where it has one.
///
/// # Errors
/// Kind `Infeasible` where an axis leaves its travel; those of the feed.
pub fn motion(setup: &Setup, pinch: &Pinch, observer: &dyn Observer) -> Result<Option<PinchMotion>> {
    let Some(heads) = Heads::of(setup, &pinch.rows, pinch.between_rad) else { return Ok(None) };
    let mut stretches = Vec::with_capacity(pinch.held.len());
    let mut alone_s = [0.0; 2];
    for (n, held) in pinch.held.iter().enumerate() {
        observer.check(Stage::Feed)?;
        observer.progress(Stage::Feed, n, pinch.held.len());
        let whole = heads.rows(held)?;
        for (j, time_s) in alone_s.iter_mut().enumerate() {
            *time_s += heads.alone(held, &whole, j, observer)?;
        }
        stretches.push(heads.stretch(n, held, whole, observer)?);
    }
    let cutting_s = stretches.iter().map(|s| s.motion.time_s).sum();
    let ways_s = heads.ways_s(&stretches);
    Ok(Some(PinchMotion { stretches, cutting_s, ways_s, alone_s, turning_mm: heads.turning_mm }))
}

/// Those rows that take less time where the table turns along them than in stretches with the
/// table still, the ways between these counted: `plans` are both.
///
/// # Errors
/// Those of [`motion()`]; that of the first plan where both have one; kind `Usage` where the
/// machine has one head.
pub(super) fn quicker_turning(
    setup: &Setup,
    rows: &PairedRows,
    between_rad: f64,
    plans: [Result<Planned>; 2],
    observer: &dyn Observer,
) -> Result<Vec<usize>> {
    let Some(heads) = Heads::of(setup, rows, between_rad) else {
        let message = format!("pinch.orientation is time, but the machine {} has one head", setup.machine.name);
        return Err(Error::usage(Stage::Machine, message)
            .advise("set machine.file to one with two heads, or pinch.orientation to smooth"));
    };
    let all = (0..rows.rows.len()).collect();
    let [still, turning] = match plans {
        [Ok(still), Ok(turning)] => [still, turning],
        // Along some row it can only turn.
        [Err(_), Ok(_)] => return Ok(all),
        [still, _] => return still.map(|_| Vec::new()),
    };
    let of_row =
        |plan: &Planned, row: usize| -> Vec<Held> { plan.held.iter().filter(|h| h.row == row).cloned().collect() };
    let mut quicker = Vec::new();
    for row in turning.held.iter().filter(|h| !h.is_still()).map(|h| h.row) {
        if quicker.last() == Some(&row) {
            continue;
        }
        let [still_s, turning_s] = [&still, &turning].map(|plan| heads.time_s(&of_row(plan, row), observer));
        if turning_s? < still_s? {
            quicker.push(row);
        }
    }
    Ok(quicker)
}

/// Of ways to turn along a row the one with which the machine is fastest: the number of it. Those
/// that are fastest without limits of jerk are looked at with them.
///
/// # Errors
/// Those of the feed.
pub(super) fn fastest(
    setup: &Setup,
    rows: &PairedRows,
    between_rad: f64,
    ways: &[Held],
    observer: &dyn Observer,
) -> Result<usize> {
    let Some(heads) = Heads::of(setup, rows, between_rad) else { return Ok(0) };
    let time_s = |limit_jerk: bool, held: &Held| -> Result<f64> {
        observer.check(Stage::Feed)?;
        let Along { s_mm, rows, speeds } = heads.rows(held)?.three_at_least();
        let options = FeedOptions { limit_jerk, ..setup.feed_options() };
        Ok(feed::plan_positions(&s_mm, &rows, &speeds, &setup.machine, &options, &Silent)?.time_s)
    };
    let numbered: Vec<usize> = (0..ways.len()).collect();
    let mut rough = parallel::try_map(&numbered, |k| Ok((time_s(false, &ways[*k])?, *k)))?;
    keep_fastest(&mut rough, |(time_s, _)| *time_s);
    let close = parallel::try_map(&rough, |(_, k)| Ok((time_s(true, &ways[*k])?, *k)))?;
    Ok(close.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).map_or(0, |(_, k)| k))
}

/// Both heads of a machine over the rows.
struct Heads<'a> {
    setup: &'a Setup,
    rows: &'a PairedRows,
    between_rad: f64,
    /// See [`PinchMotion`].
    turning_mm: f64,
}

/// All axes along a stretch: a row for each place, at these ways, with the greatest speed from each
/// to the next.
struct Along {
    s_mm: Vec<f64>,
    rows: AxisRows,
    speeds: Vec<f64>,
}

impl<'a> Heads<'a> {
    /// `None`: the machine has one.
    fn of(setup: &'a Setup, rows: &'a PairedRows, between_rad: f64) -> Option<Self> {
        let machine = &setup.machine;
        // Two heads share a table.
        let turning_mm = || machine.turns_within_mm(&setup.part_among()).unwrap_or(f64::INFINITY);
        machine.has_two_heads().then(|| Heads { setup, rows, between_rad, turning_mm: turning_mm() })
    }

    fn centres(&self, place: usize) -> [Point; 2] {
        [0, 1].map(|j| self.rows.places[place].contacts[j].centre)
    }

    fn at(&self, centres: [Point; 2], theta_rad: f64) -> Result<Axes> {
        let gauges = self.setup.pinch_tools().map(|t| t.length_mm());
        let leans = self.setup.pinch_cones().map(|c| c.lean_rad);
        self.setup.machine.place_both(centres, theta_rad, leans, gauges)
    }

    /// Both tool axes at an angle of the table.
    fn axes(&self, theta_rad: f64) -> [Vector; 2] {
        let [one, two] = self.setup.pinch_cones();
        [one.tool_axis(theta_rad), two.tool_axis(theta_rad + self.between_rad)]
    }

    fn feed_mm_s(&self) -> f64 {
        self.setup.job.feed.feed_mm_min / 60.0
    }

    /// All axes at the places of a stretch.
    fn rows(&self, held: &Held) -> Result<Along> {
        let places = &self.rows.places[held.places.clone()];
        let (mut s_mm, mut speeds, mut rows) = (vec![0.0], Vec::new(), AxisRows::with_capacity(9, places.len()));
        for (k, place) in held.places.clone().enumerate() {
            if k > 0 {
                let way = |j: usize| (places[k].contacts[j].centre - places[k - 1].contacts[j].centre).norm();
                let over = |j: usize| (places[k].contacts[j].contact - places[k - 1].contacts[j].contact).norm();
                let step = way(0).max(way(1));
                let farthest = step.max(over(0)).max(over(1));
                s_mm.push(s_mm[k - 1] + step);
                speeds.push(self.feed_mm_s() * step / farthest);
            }
            rows.push(&self.at(self.centres(place), held.theta_at(place))?);
        }
        Ok(Along { s_mm, rows, speeds })
    }

    /// The motion of a stretch, and both tools over its ends.
    fn stretch(&self, stretch: usize, held: &Held, along: Along, observer: &dyn Observer) -> Result<StretchMotion> {
        let (setup, machine) = (self.setup, &self.setup.machine);
        let Along { s_mm, rows, speeds } = along.three_at_least();
        let motion = feed::plan_positions(&s_mm, &rows, &speeds, machine, &setup.feed_options(), observer)?;
        let thetas = held.ends_rad();
        let centres = [held.places.start, held.places.end - 1].map(|k| self.centres(k));
        let ends = [0, 1].map(|k| self.lifted(thetas[k], centres[k]));
        let over = [self.at(ends[0].1, thetas[0])?, self.at(ends[1].1, thetas[1])?];
        let lifts_mm = [ends[0].0, ends[1].0];
        let near_mm = lifts_mm[0].map(|lift| lift.min(setup.job.post.feed_height_mm));
        let axes = self.axes(thetas[0]);
        let near = self.at([0, 1].map(|j| centres[0][j] + axes[j] * near_mm[j]), thetas[0])?;
        for row in over.iter().map(|r| &r[..]).chain(motion.position.iter()) {
            within_travel(machine, row, held.row)?;
        }
        Ok(StretchMotion { stretch, row: held.row, places: held.places.clone(), motion, over, lifts_mm, near, near_mm })
    }

    /// The time of the stretches of a row and of the ways to them and between them, s.
    fn time_s(&self, stretches: &[Held], observer: &dyn Observer) -> Result<f64> {
        let one = |(n, held): (usize, &Held)| self.stretch(n, held, self.rows(held)?, observer);
        let all = stretches.iter().enumerate().map(one).collect::<Result<Vec<_>>>()?;
        Ok(all.iter().map(|s| s.motion.time_s).sum::<f64>() + self.ways_s(&all))
    }

    /// The time of the ways down, up and from stretch to stretch, s.
    fn ways_s(&self, stretches: &[StretchMotion]) -> f64 {
        let post = &self.setup.job.post;
        let own = |s: &StretchMotion| s.ways_s(post.approach_feed_mm_min, post.plunge_feed_mm_min).iter().sum::<f64>();
        let over = |w: &[StretchMotion]| self.setup.machine.rapid_s(&w[0].over[1], &w[1].over[0]);
        stretches.iter().map(own).sum::<f64>() + stretches.windows(2).map(over).sum::<f64>()
    }

    /// The time that one tool takes for a stretch while the other head stands still, s.
    fn alone(&self, held: &Held, along: &Along, tool: usize, observer: &dyn Observer) -> Result<f64> {
        let (setup, machine, rows) = (self.setup, &self.setup.machine, &along.rows);
        let own = machine.heads()[tool].linear();
        let moves = |c: usize| own.contains(&c) || c == machine.turning_axis();
        let (mut s_mm, mut speeds, mut kept) =
            (vec![0.0], Vec::new(), AxisRows::with_capacity(rows.axes(), rows.len()));
        let row = |k: usize| Axes::from_fn(rows.axes(), |c| rows[if moves(c) { k } else { 0 }][c]);
        kept.push(&row(0));
        let at = |k: usize| self.rows.places[held.places.start + k].contacts[tool];
        for k in 1..rows.len() {
            let (a, b) = (at(k - 1), at(k));
            let way = (b.centre - a.centre).norm();
            // The other tool may go on where this one hardly moves.
            if way < SHORTEST_MM {
                continue;
            }
            s_mm.push(s_mm[s_mm.len() - 1] + way);
            let over = (b.contact - a.contact).norm();
            speeds.push(self.feed_mm_s() * way / way.max(over));
            kept.push(&row(k));
        }
        if kept.len() < 2 {
            return Ok(0.0);
        }
        let Along { s_mm, rows, speeds } = Along { s_mm, rows: kept, speeds }.three_at_least();
        Ok(feed::plan_positions(&s_mm, &rows, &speeds, machine, &setup.feed_options(), observer)?.time_s)
    }

    /// How far both tools are lifted along their axes until the turning part is under them, and
    /// their ball centres then.
    fn lifted(&self, theta_rad: f64, centres: [Point; 2]) -> ([f64; 2], [Point; 2]) {
        let (cones, axes) = (self.setup.pinch_cones(), self.axes(theta_rad));
        let mut lifts = [0.0; 2];
        let lifted = [0, 1].map(|j| {
            let theta = theta_rad + if j == 0 { 0.0 } else { self.between_rad };
            let (axis, out) = (axes[j], Vector::new(0.0, theta.cos(), theta.sin()));
            let tool = self.setup.pinch_tools()[j];
            let height = lowest_mm(&tool.segments(), tool.radius_mm, &centres[j], &axis, &out);
            lifts[j] = ((self.turning_mm + ROOM_MM - height) / cones[j].lean_rad.cos()).max(0.0);
            centres[j] + axis * lifts[j]
        });
        (lifts, lifted)
    }
}

impl Along {
    /// A stretch of two places gets one between them.
    fn three_at_least(self) -> Self {
        let Along { s_mm, rows, speeds } = self;
        let [a, b] = s_mm[..] else { return Along { s_mm, rows, speeds } };
        let mut three = AxisRows::with_capacity(rows.axes(), 3);
        let (first, last) = (Axes::from(&rows[0]), Axes::from(&rows[1]));
        for row in [first, first.toward(&last, 0.5), last] {
            three.push(&row);
        }
        Along { s_mm: vec![a, 0.5 * (a + b), b], rows: three, speeds: [speeds.clone(), speeds].concat() }
    }
}

/// Every axis within its travel.
fn within_travel(machine: &Machine, row: &[f64], of_row: usize) -> Result<()> {
    for (axis, at) in machine.axes().iter().zip(row) {
        let Some([least, most]) = axis.limits.travel else { continue };
        if *at >= least - ROUNDING && *at <= most + ROUNDING {
            continue;
        }
        let unit = if axis.is_rotary() { "°" } else { " mm" };
        let shown = |v: f64| if axis.is_rotary() { v.to_degrees() } else { v };
        let message = format!(
            "axis {} would have to stand at {:.3}{unit} in row {}, its travel is {:.3} to {:.3}{unit}",
            axis.name,
            shown(*at),
            of_row + 1,
            shown(least),
            shown(most)
        );
        let travel = [shown(least), shown(most)];
        let since = Infeasible::RowBeyondTravel { axis: axis.name.clone(), row: of_row, at: shown(*at), travel };
        return Err(Error::infeasible(Stage::Feed, message, since)
            .advise("clamp the blade elsewhere (mount.offset_mm), or take a longer tool"));
    }
    Ok(())
}
