//! Nine axes in one clock: rows of two tools as motions of a machine with two heads.
//!
//! Each stretch is one motion, from rest to rest, while the table and both leans stand still. Its
//! parameter is the way of the tool that goes farther. Before it both tools come down along their
//! own axes, behind it they leave along them, until every point of both is farther from the axis of
//! the table than any point of the part: beyond a plane square to the tool's direction, which the
//! part turns under. From stretch to stretch all axes move in a straight line between such places,
//! so both tools stay beyond their planes, however far the table turns.

use super::Pinch;
use crate::artifact::paired::{BallContact, PinchMotion, StretchMotion};
use crate::artifact::{Axes, AxisRows};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::feed;
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::observe::Observer;
use crate::plan::Setup;
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
    let machine = &setup.machine;
    if !machine.has_two_heads() {
        return Ok(None);
    }
    let leans = setup.pinch_cones().map(|c| c.lean_rad);
    let gauges = setup.pinch_tools().map(|t| t.length_mm());
    // Two heads share a table.
    let turning_mm = machine.turns_within_mm(&setup.part_among()).unwrap_or(f64::INFINITY);
    let options = setup.feed_options();
    let feed_mm_s = setup.job.feed.feed_mm_min / 60.0;
    let mut stretches = Vec::with_capacity(pinch.held.len());
    let mut alone_s = [0.0; 2];
    for (n, held) in pinch.held.iter().enumerate() {
        observer.check(Stage::Feed)?;
        observer.progress(Stage::Feed, n, pinch.held.len());
        let places = &pinch.rows.places[held.places.clone()];
        let centres = |k: usize| [0, 1].map(|j| places[k].contacts[j].centre);
        let at = |centres: [Point; 2]| machine.place_both(centres, held.theta_rad, leans, gauges);
        let (mut s_mm, mut speeds, mut rows) = (vec![0.0], Vec::new(), AxisRows::with_capacity(9, places.len()));
        rows.push(&at(centres(0))?);
        for k in 1..places.len() {
            let way = |j: usize| (places[k].contacts[j].centre - places[k - 1].contacts[j].centre).norm();
            let over = |j: usize| (places[k].contacts[j].contact - places[k - 1].contacts[j].contact).norm();
            let step = way(0).max(way(1));
            let farthest = step.max(over(0)).max(over(1));
            s_mm.push(s_mm[k - 1] + step);
            speeds.push(feed_mm_s * step / farthest);
            rows.push(&at(centres(k))?);
        }
        for (j, time_s) in alone_s.iter_mut().enumerate() {
            *time_s += alone(setup, &rows, j, |k| places[k].contacts[j], observer)?;
        }
        let (s_mm, rows, speeds) = three_at_least(s_mm, rows, speeds);
        let motion = feed::plan_positions(&s_mm, &rows, &speeds, machine, &options, observer)?;
        let ends = [0, places.len() - 1].map(|k| lifted(setup, pinch, (held.theta_rad, leans), centres(k), turning_mm));
        let over = [at(ends[0].1)?, at(ends[1].1)?];
        let lifts_mm = [ends[0].0, ends[1].0];
        for row in over.iter().map(|r| &r[..]).chain(motion.position.iter()) {
            within_travel(machine, row, held.row)?;
        }
        let places = held.places.clone();
        stretches.push(StretchMotion { stretch: n, row: held.row, places, motion, over, lifts_mm });
    }
    let cutting_s = stretches.iter().map(|s| s.motion.time_s).sum();
    Ok(Some(PinchMotion { stretches, cutting_s, alone_s, turning_mm }))
}

/// The time that one tool takes for a stretch while the other head stands still, s.
fn alone(
    setup: &Setup,
    rows: &AxisRows,
    tool: usize,
    at: impl Fn(usize) -> BallContact,
    observer: &dyn Observer,
) -> Result<f64> {
    let machine = &setup.machine;
    let own = machine.heads()[tool].linear();
    let (mut s_mm, mut speeds, mut kept) = (vec![0.0], Vec::new(), AxisRows::with_capacity(rows.axes(), rows.len()));
    let row = |k: usize| Axes::from_fn(rows.axes(), |c| rows[if own.contains(&c) { k } else { 0 }][c]);
    kept.push(&row(0));
    for k in 1..rows.len() {
        let (a, b) = (at(k - 1), at(k));
        let way = (b.centre - a.centre).norm();
        // The other tool may go on where this one hardly moves.
        if way < SHORTEST_MM {
            continue;
        }
        s_mm.push(s_mm[s_mm.len() - 1] + way);
        let over = (b.contact - a.contact).norm();
        speeds.push(setup.job.feed.feed_mm_min / 60.0 * way / way.max(over));
        kept.push(&row(k));
    }
    if kept.len() < 2 {
        return Ok(0.0);
    }
    let (s_mm, kept, speeds) = three_at_least(s_mm, kept, speeds);
    Ok(feed::plan_positions(&s_mm, &kept, &speeds, machine, &setup.feed_options(), observer)?.time_s)
}

/// A stretch of two places gets one between them.
fn three_at_least(s_mm: Vec<f64>, rows: AxisRows, speeds: Vec<f64>) -> (Vec<f64>, AxisRows, Vec<f64>) {
    let [a, b] = s_mm[..] else { return (s_mm, rows, speeds) };
    let mut three = AxisRows::with_capacity(rows.axes(), 3);
    let (first, last) = (Axes::from(&rows[0]), Axes::from(&rows[1]));
    for row in [first, first.toward(&last, 0.5), last] {
        three.push(&row);
    }
    (vec![a, 0.5 * (a + b), b], three, [speeds.clone(), speeds].concat())
}

/// How far both tools are lifted along their axes until the turning part is under them, and their
/// ball centres then.
fn lifted(
    setup: &Setup,
    pinch: &Pinch,
    (theta_rad, leans): (f64, [f64; 2]),
    centres: [Point; 2],
    turning_mm: f64,
) -> ([f64; 2], [Point; 2]) {
    let cones = setup.pinch_cones();
    let between_rad = pinch.between_rad;
    let mut lifts = [0.0; 2];
    let lifted = [0, 1].map(|j| {
        let theta = theta_rad + if j == 0 { 0.0 } else { between_rad };
        let (axis, out) = (cones[j].tool_axis(theta), Vector::new(0.0, theta.cos(), theta.sin()));
        let tool = setup.pinch_tools()[j];
        let height = lowest_mm(&tool.segments(), tool.radius_mm, &centres[j], &axis, &out);
        lifts[j] = ((turning_mm + ROOM_MM - height) / leans[j].cos()).max(0.0);
        centres[j] + axis * lifts[j]
    });
    (lifts, lifted)
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
