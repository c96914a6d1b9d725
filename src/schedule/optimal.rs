//! The schedule with the least peak, or least square, of its second or third derivative.
//!
//! θ is a cubic on every interval between cutter locations, twice continuously differentiable,
//! between the straight walls and never falling; `|θ''| ≤ γ` or `|θ'''| ≤ γ`. Each round is one run
//! of the solver (`rounds.rs`).
//!
//! *Peaks* take two rounds. The first finds the least γ of the whole path. Most of the path can do
//! with less, and the first round leaves open what it does. The second round has a γ for each turn,
//! none above the first round's by more than [`SPARE`], and makes their mean least. A small share
//! of `∫ θ''²` makes the answer unique: it then follows the walls continuously.
//! *Squares* take one round.

use super::bound;
use super::corridor::Corridor;
use super::rounds::{EXCESS, Goal, Solved, SolverUnits, pressure, round, trial, values};
use super::{Pace, ScheduleOptions, bezier, by_turn, check, curve, piecewise};
use crate::artifact::schedule::{Measure, Schedule, ScheduleKind, Scope};
use crate::artifact::{Channel, Toolpath};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage as Room};
use crate::observe::Observer;

/// What the second round may add to the least peak, as a share.
const SPARE: f64 = 1e-3;
/// Samples of the trial that finds the size of the numbers.
const TRIAL: usize = 3000;
/// Where nothing goes between the walls, so many times as many samples of the trial, or joints, are
/// taken.
const MORE: usize = 4;
/// Rows of a trial may be missed by this where there are so many joints that none can be added.
const TRIAL_EXCESS: f64 = 1e-5;
/// Blocks of a turn with a factor of their own, for the least time.
const BLOCKS: f64 = 48.0;
/// Intervals at least, and at most where locations are too far apart.
const FEWEST: usize = 200;
const MOST: usize = 300_000;
/// Intervals at most where there is room and the solver came to no end.
const FURTHER: usize = 20_000;

/// See the module's page.
pub(super) fn plan(
    kind: ScheduleKind,
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    let (hull, walls) = piecewise::walls_with_margin(path, channel, options, observer)?;
    let pace = match (kind, options.pace) {
        (ScheduleKind::Time, None) => {
            let message = "a schedule of kind time needs the machine's limits: options.pace is missing";
            return Err(Error::usage(Room::Schedule, message));
        }
        (ScheduleKind::Time, pace) => pace,
        _ => None,
    };
    let (pieces, proof) = match walls.straight() {
        Some([p, q]) => (vec![bezier::straight(p, q)], None),
        None => {
            let found = refining(path, &walls, options, pace, observer)?;
            (curve::hermite(&found.walls.s, &found.theta, &found.slope), Some(found))
        }
    };
    observer.progress(Room::Schedule, 1, 1);
    let theta = bezier::sample_as(hull.one_way, &pieces, &hull.s);
    check::inside(&pieces, &theta, &hull, path)?;
    let mut out = curve::schedule(kind, pieces, theta, &hull);
    let prove = |measure, whole: bool| {
        proof.as_ref().map_or(0.0, |f| {
            let walls = if whole { hull.at_all(&f.walls.s) } else { f.walls.clone() };
            f.weights.iter().map(|y| either_sign(measure, &walls, y)).fold(0.0, f64::max)
        })
    };
    if kind == ScheduleKind::Time || options.unproven {
        return Ok(out);
    }
    let value = match options.settings.measure {
        Measure::PeakSecond => out.peak_acceleration,
        Measure::PeakThird => out.quality.peak_third.unwrap_or(0.0),
        Measure::SquareSecond => curve::squares(&out.pieces)[0],
        Measure::SquareThird => curve::squares(&out.pieces)[1],
    };
    out.quality.measure = Some((options.settings.measure, value, prove(options.settings.measure, false).min(value)));
    out.quality.bound_second = match options.settings.measure {
        Measure::PeakSecond if options.settings.scope == Scope::Whole => Some(prove(Measure::PeakSecond, true)),
        _ => least_second(path, channel),
    };
    Ok(out)
}

/// A lower bound of the greatest |θ''| of any schedule in the channel that never turns back,
/// rad/mm²: proved on a part of the samples, which is quick and valid for all. `None` where there
/// is no channel.
pub(super) fn least_second(path: &Toolpath, channel: &Channel) -> Option<f64> {
    let hull = piecewise::hull(path, channel).ok()?;
    if hull.straight().is_some() {
        return Some(0.0);
    }
    let thin = thinned(&hull, 8 * TRIAL);
    let scale = SolverUnits::of(&thin, path.turns.len());
    let first = round(&thin, &scale, &Goal::Peak { third: false }, 1e-5)?;
    let y: Vec<f64> = first.costates.iter().map(|c| c[1]).collect();
    let other = pressure(&thin, &first);
    Some(either_sign(Measure::PeakSecond, &thin, &y).max(either_sign(Measure::PeakSecond, &thin, &other)))
}

/// The better of the bounds that a weight and its negative prove.
fn either_sign(measure: Measure, walls: &Corridor, y: &[f64]) -> f64 {
    let other: Vec<f64> = y.iter().map(|v| -v).collect();
    bound::prove(measure, walls, y).max(bound::prove(measure, walls, &other))
}

/// Every so many samples of the walls that about `most` are left, with the first and the last.
fn thinned(walls: &Corridor, most: usize) -> Corridor {
    let n = walls.s.len();
    let mut s: Vec<f64> = walls.s.iter().step_by(n.div_ceil(most).max(1)).copied().collect();
    if s.last() != walls.s.last() {
        s.extend(walls.s.last());
    }
    walls.at_all(&s)
}

/// The walls with every interval cut into `parts`.
fn refined(walls: &Corridor, parts: usize) -> Corridor {
    let mut s = Vec::with_capacity(walls.s.len() * parts);
    for w in walls.s.windows(2) {
        s.extend((0..parts).map(|k| w[0] + (w[1] - w[0]) * k as f64 / parts as f64));
    }
    s.extend(walls.s.last());
    walls.at_all(&s)
}

/// The least over the whole path, with joints at the locations; where they are too far apart to
/// bend between walls that bend, with joints between.
fn refining(
    path: &Toolpath,
    walls: &Corridor,
    options: &ScheduleOptions,
    pace: Option<Pace>,
    observer: &dyn Observer,
) -> Result<Solved> {
    let n = walls.s.len().saturating_sub(1).max(1);
    let third = matches!(options.settings.measure, Measure::PeakThird | Measure::SquareThird);
    let mut parts = FEWEST.div_ceil(n);
    loop {
        let walls = if parts == 1 { walls.clone() } else { refined(walls, parts) };
        let scale = units(&walls, path.turns.len(), third);
        let most = if scale.is_some() { FURTHER } else { MOST };
        let found = match scale {
            Some(scale) => solve(path, walls, options, pace, &scale, observer),
            None => Err(stuck(&walls, options)),
        };
        parts *= MORE;
        match found {
            Err(e) if e.kind == ErrorKind::Infeasible && parts <= 64 && n * parts <= most => {}
            found => return found,
        }
    }
}

/// The size of the numbers, by trials; `None` where nothing goes between the walls with joints at
/// their samples.
fn units(walls: &Corridor, turns: usize, third: bool) -> Option<SolverUnits> {
    let mut scale = SolverUnits::of(walls, turns);
    let (mut on, mut most) = (thinned(walls, TRIAL), TRIAL);
    let excess = if MORE * walls.s.len() > FURTHER { TRIAL_EXCESS } else { EXCESS };
    let mut sized = |scale: &SolverUnits, third| {
        loop {
            let found = trial(&on, scale, third, excess);
            if found.is_some() || on.s.len() == walls.s.len() {
                return found;
            }
            // Between walls that move by more than their distance from one of these samples to the
            // next nothing goes, though something does between more of them.
            most *= MORE;
            on = if most < walls.s.len() { thinned(walls, most) } else { walls.clone() };
        }
    };
    // Twice, since the first trial may be far off in size.
    for _ in 0..2 {
        scale.second *= sized(&scale, false)?.v[0][3].clamp(1e-4, 1e4);
    }
    if third {
        scale.third *= sized(&scale, true)?.v[0][3].clamp(1e-4, 1e4);
    }
    Some(scale)
}

fn stuck(walls: &Corridor, options: &ScheduleOptions) -> Error {
    let back = if walls.one_way { " that never turns back" } else { "" };
    let message = format!("the channel leaves no room for a smooth schedule{back}");
    let since = Infeasible::NoSmoothSchedule { margin_deg: options.settings.margin_deg };
    Error::infeasible(Room::Schedule, message, since)
        .advise("allow less clearance, take a more slender or longer tool, or lower schedule.margin_deg")
}

/// The least over the whole path.
fn solve(
    path: &Toolpath,
    walls: Corridor,
    options: &ScheduleOptions,
    pace: Option<Pace>,
    scale: &SolverUnits,
    observer: &dyn Observer,
) -> Result<Solved> {
    let measure = options.settings.measure;
    let third = matches!(measure, Measure::PeakThird | Measure::SquareThird);
    let stuck = || stuck(&walls, options);
    observer.check(Room::Schedule)?;
    if options.settings.scope == Scope::Turns && pace.is_none() {
        return by_turn::solve(path, &walls, measure, scale).ok_or_else(stuck);
    }
    let (last, weights) = match measure {
        _ if let Some(pace) = pace => {
            // What the mean slope and the trial's peak come to: where the machine is slow or the
            // channel bends sharply, γ is thousands.
            let second = scale.second / scale.length.powi(2);
            let unit = pace.needed(scale.base[1].abs(), second).max(1.0);
            let goal = Goal::Pace { pace, unit, borders: blocks(&walls, scale) };
            let found = round(&walls, scale, &goal, 1e-4 / unit);
            (found.ok_or_else(stuck)?, Vec::new())
        }
        Measure::PeakSecond | Measure::PeakThird => {
            let first = round(&walls, scale, &Goal::Peak { third }, 1e-5).ok_or_else(stuck)?;
            observer.check(Room::Schedule)?;
            let cap = first.v[0][3] * (1.0 + SPARE);
            let borders = borders(path, &walls);
            let second = round(&walls, scale, &Goal::Turns { third, cap, borders }, 1e-4);
            let mut weights = vec![first.costates.iter().map(|c| c[1]).collect()];
            if !third {
                weights.push(pressure(&walls, &first));
            }
            (second.unwrap_or(first), weights)
        }
        Measure::SquareSecond | Measure::SquareThird => {
            let found = round(&walls, scale, &Goal::Square { third }, 1e-6).ok_or_else(stuck)?;
            let weight = if third {
                found.costates.iter().map(|c| c[1]).collect()
            } else {
                found.v.iter().map(|v| v[2]).collect()
            };
            (found, vec![weight])
        }
    };
    let (theta, slope) = values(&walls, scale, &last);
    Ok(Solved { walls, theta, slope, weights })
}

/// Whether a turn begins between a sample of the walls and the next.
fn borders(path: &Toolpath, walls: &Corridor) -> Vec<bool> {
    let mut bases = path.turns.iter().skip(1).filter_map(|t| path.locations.get(t.first)).map(|l| l.s_mm).peekable();
    let begins = |w: &[f64]| {
        let mut any = false;
        while bases.next_if(|b| *b <= w[1]).is_some() {
            any = true;
        }
        any
    };
    walls.s.windows(2).map(begins).collect()
}

/// Borders of blocks of equal length, about [`BLOCKS`] to a turn.
fn blocks(walls: &Corridor, scale: &SolverUnits) -> Vec<bool> {
    let block = |s: f64| ((s - walls.s[0]) / scale.length * BLOCKS).floor();
    walls.s.windows(2).map(|w| block(w[0]) != block(w[1])).collect()
}
