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
//!
//! Where walls bend so sharply that no such θ keeps between them, the multipliers of the rows that
//! contradict one another grow without end. Those intervals alone get joints between their ends,
//! and the round is run again. A trial on a part of the samples finds most of these places, and the
//! size of the numbers.

use super::bound;
use super::corridor::Corridor;
use super::rounds::{Contradicting, Goal, Solved, SolverUnits, pressure, round, values};
use super::{Pace, ScheduleOptions, bezier, by_turn, check, curve, piecewise};
use crate::artifact::schedule::{Measure, Schedule, ScheduleKind, Scope};
use crate::artifact::{Channel, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage as Room};
use crate::observe::Observer;

/// What the second round may add to the least peak, as a share.
const SPARE: f64 = 1e-3;
/// Samples of the trial that finds the size of the numbers.
const TRIAL: usize = 3000;
/// Of a trial the size of what it finds counts alone: the solver may end so far from the least.
const TRIAL_GAP: f64 = 1e-4;
/// Where nothing goes between the walls, an interval without samples in it is cut into so many.
const MORE: usize = 4;
/// Parts of an interval between locations at most.
const PARTS: f64 = 64.0;
/// Intervals either side of a place at which nothing goes between the walls that get joints.
const BESIDE: usize = 1;
/// How often joints are added, for a trial and for the whole.
const TRIES: [usize; 2] = [60, 30];
/// A schedule nearer to a wall than this touches it, rad: the best of several weights is taken that
/// bend there alone.
const NEAR: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// Blocks of a turn with a factor of their own, for the least time.
const BLOCKS: f64 = 48.0;
/// Intervals at least.
const FEWEST: usize = 200;

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
            let straight =
                NEAR.iter().flat_map(|near| f.weights.iter().map(|y| bound::at_walls(&f.walls, &f.theta, y, *near)));
            let weights = f.weights.iter().cloned().chain(straight);
            weights.map(|y| either_sign(measure, &walls, &y)).fold(0.0, f64::max)
        })
    };
    if kind == ScheduleKind::Time {
        return Ok(out);
    }
    let value = match options.settings.measure {
        Measure::PeakSecond => out.peak_acceleration,
        Measure::PeakThird => out.quality.peak_third.unwrap_or(0.0),
        Measure::SquareSecond => curve::squares(&out.pieces)[0],
        Measure::SquareThird => curve::squares(&out.pieces)[1],
    };
    out.quality.measure = Some((options.settings.measure, value, prove(options.settings.measure, false).min(value)));
    if options.own_bound_alone {
        return Ok(out);
    }
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
    let first = round(&thin, &scale, &Goal::Peak { third: false }, 1e-5).ok()?;
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

/// The walls with joints added about these samples: those of `all` between them, and where there
/// are none, [`MORE`] parts. `None` where all of that is as close as may be.
fn closer(walls: &Corridor, all: &Corridor, about: &[usize]) -> Option<Corridor> {
    let last = walls.s.len() - 1;
    let mut near = vec![about.is_empty(); last];
    for i in about {
        near[i.saturating_sub(1 + BESIDE).min(last)..(i + 1 + BESIDE).min(last)].fill(true);
    }
    let mut s = Vec::with_capacity(walls.s.len() + MORE * about.len());
    for (w, near) in walls.s.windows(2).zip(near) {
        s.push(w[0]);
        let between = all.s.partition_point(|x| *x <= w[0])..all.s.partition_point(|x| *x < w[1]);
        if !near {
            continue;
        }
        if !between.is_empty() {
            s.extend(&all.s[between]);
            continue;
        }
        let own = all.s[between.start.min(all.s.len() - 1)] - all.s[between.start.saturating_sub(1)];
        if (w[1] - w[0]) * PARTS > own * (1.0 + 1e-9) {
            s.extend((1..MORE).map(|k| w[0] + (w[1] - w[0]) * k as f64 / MORE as f64));
        }
    }
    s.extend(walls.s.last());
    s.dedup();
    (s.len() > walls.s.len()).then(|| all.at_all(&s))
}

/// The least over the whole path, with joints at the locations; where they are too far apart to
/// bend between walls that bend, with joints between, there alone.
fn refining(
    path: &Toolpath,
    walls: &Corridor,
    options: &ScheduleOptions,
    pace: Option<Pace>,
    observer: &dyn Observer,
) -> Result<Solved> {
    let n = walls.s.len().saturating_sub(1).max(1);
    let third = matches!(options.settings.measure, Measure::PeakThird | Measure::SquareThird);
    let parts = FEWEST.div_ceil(n);
    let all = if parts == 1 { walls.clone() } else { refined(walls, parts) };
    let stuck = || stuck(walls, options);
    let (scale, on) = units(&all, path.turns.len(), third, observer)?.ok_or_else(stuck)?;
    let mut s: Vec<f64> = all.s.iter().chain(&on.s).copied().collect();
    s.sort_unstable_by(f64::total_cmp);
    s.dedup();
    let mut joints = all.at_all(&s);
    for _ in 0..TRIES[1] {
        let Contradicting(about) = match solve(path, joints.clone(), options, pace, &scale, observer)? {
            Ok(found) => return Ok(found),
            Err(contradicting) => contradicting,
        };
        joints = closer(&joints, &all, &about).ok_or_else(stuck)?;
    }
    Err(stuck())
}

/// The size of the numbers, by trials on a part of the samples, and the samples and joints between
/// them that these needed; `None` where nothing goes between the walls.
fn units(
    all: &Corridor,
    turns: usize,
    third: bool,
    observer: &dyn Observer,
) -> Result<Option<(SolverUnits, Corridor)>> {
    let mut scale = SolverUnits::of(all, turns);
    let mut on = thinned(all, TRIAL);
    let mut tries = TRIES[0];
    let mut sized = |scale: &SolverUnits, third: bool| -> Result<Option<f64>> {
        loop {
            observer.check(Room::Schedule)?;
            // Between walls that move by more than their distance from one joint to the next
            // nothing goes, though something does between more of them.
            let about = match round(&on, scale, &Goal::Peak { third }, TRIAL_GAP) {
                Ok(found) => return Ok(Some(found.v[0][3].clamp(1e-4, 1e4))),
                Err(Contradicting(about)) => about,
            };
            tries = tries.saturating_sub(1);
            match closer(&on, all, &about) {
                Some(more) if tries > 0 => on = more,
                _ => return Ok(None),
            }
        }
    };
    // Twice, since the first trial may be far off in size.
    for _ in 0..2 {
        let Some(size) = sized(&scale, false)? else { return Ok(None) };
        scale.second *= size;
    }
    if third {
        let Some(size) = sized(&scale, true)? else { return Ok(None) };
        scale.third *= size;
    }
    Ok(Some((scale, on)))
}

fn stuck(walls: &Corridor, options: &ScheduleOptions) -> Error {
    let back = if walls.one_way { " that never turns back" } else { "" };
    let message = format!("the channel leaves no room for a smooth schedule{back}");
    let since = Infeasible::NoSmoothSchedule { margin_deg: options.settings.margin_deg };
    Error::infeasible(Room::Schedule, message, since)
        .advise("allow less clearance, take a more slender or longer tool, or lower schedule.margin_deg")
}

/// The least over the whole path, with joints at the samples of the walls.
fn solve(
    path: &Toolpath,
    walls: Corridor,
    options: &ScheduleOptions,
    pace: Option<Pace>,
    scale: &SolverUnits,
    observer: &dyn Observer,
) -> Result<std::result::Result<Solved, Contradicting>> {
    let measure = options.settings.measure;
    let third = matches!(measure, Measure::PeakThird | Measure::SquareThird);
    observer.check(Room::Schedule)?;
    if options.settings.scope == Scope::Turns && pace.is_none() {
        return Ok(by_turn::solve(path, &walls, measure, scale));
    }
    let found = match measure {
        _ if let Some(pace) = pace => {
            // What the mean slope and the trial's peak come to: where the machine is slow or the
            // channel bends sharply, γ is thousands.
            let second = scale.second / scale.length.powi(2);
            let unit = pace.needed(scale.base[1].abs(), second).max(1.0);
            let goal = Goal::Pace { pace, unit, borders: blocks(&walls, scale) };
            round(&walls, scale, &goal, 1e-4 / unit).map(|found| (found, Vec::new()))
        }
        Measure::PeakSecond | Measure::PeakThird => {
            let first = match round(&walls, scale, &Goal::Peak { third }, 1e-5) {
                Ok(first) => first,
                Err(contradicting) => return Ok(Err(contradicting)),
            };
            observer.check(Room::Schedule)?;
            let cap = first.v[0][3] * (1.0 + SPARE);
            let borders = borders(path, &walls);
            let second = round(&walls, scale, &Goal::Turns { third, cap, borders }, 1e-4);
            let mut weights = vec![first.costates.iter().map(|c| c[1]).collect()];
            if !third {
                weights.push(pressure(&walls, &first));
            }
            Ok((second.unwrap_or(first), weights))
        }
        Measure::SquareSecond | Measure::SquareThird => {
            round(&walls, scale, &Goal::Square { third }, 1e-6).map(|found| {
                let weight = if third {
                    found.costates.iter().map(|c| c[1]).collect()
                } else {
                    found.v.iter().map(|v| v[2]).collect()
                };
                (found, vec![weight])
            })
        }
    };
    Ok(found.map(|(last, weights)| {
        let (theta, slope) = values(&walls, scale, &last);
        Solved { walls, theta, slope, weights }
    }))
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::tests::{channel, path};
    use super::*;
    use crate::observe::Silent;

    /// Walls that are narrow about one corner, at a location: joints between locations come there
    /// alone.
    #[test]
    fn a_corner_gets_joints_of_its_own() {
        let n = 2000_i32;
        let limits: Vec<[f64; 2]> = (0..=n)
            .map(|i| {
                let corner = 0.01 * f64::from(i) + 0.1 * f64::from((i - n / 2).max(0));
                let half = if i.abs_diff(n / 2) < 10 { 2e-3 } else { 0.3 };
                [corner - half, corner + half]
            })
            .collect();
        let p = path(40, 50);
        let options = ScheduleOptions::default().with(|s| (s.margin_deg, s.measure) = (0.0, Measure::SquareSecond));
        let (_, walls) = piecewise::walls_with_margin(&p, &channel(&limits), &options, &Silent).unwrap();
        let units = SolverUnits::of(&walls, 40);
        let Contradicting(about) = solve(&p, walls.clone(), &options, None, &units, &Silent).unwrap().err().unwrap();
        assert!(about.len() < 50 && about.iter().any(|i| i.abs_diff(1000) < 3), "{about:?}");
        let found = refining(&p, &walls, &options, None, &Silent).unwrap();
        let added: Vec<f64> = found.walls.s.iter().copied().filter(|s| !walls.s.contains(s)).collect();
        assert!((1..200).contains(&added.len()), "{}", added.len());
        assert!(added.iter().all(|s| (s - walls.s[1000]).abs() < 20.0), "{added:?}");
        let s = plan(ScheduleKind::Optimal, &p, &channel(&limits), &options, &Silent).unwrap();
        assert!(s.quality.outside_rad < 1e-8 && s.reversals == 0);
    }

    /// Bends of a weight away from the walls cost as much as the channel is wide. Through 0, 1 and
    /// 0, 50 mm apart, `∫ θ''²` is `6 / 50³` at least: a weight that bends there alone proves it.
    #[test]
    fn weights_that_bend_at_the_walls_alone_prove_more() {
        let at = |i: usize, half: f64| match i {
            0 | 100 => 0.0,
            50 => 1.0,
            _ => half,
        };
        let s: Vec<f64> = (0..=100).map(f64::from).collect();
        let [lo, hi] = [-2.0, 2.0].map(|half| (0..=100).map(|i| at(i, half)).collect());
        let walls = Corridor { s, lo, hi, one_way: false };
        let theta: Vec<f64> = (0..=100).map(|i| at(i, 0.3)).collect();
        let hat = |i: usize| 1.0 - (i as f64 - 50.0).abs() / 50.0;
        let noise = |i: usize| if i == 50 { 0.0 } else { [1e-3, -1e-3][i % 2] };
        let rough: Vec<f64> = (0..=100).map(|i| hat(i) + noise(i)).collect();
        let prove = |y: &[f64]| either_sign(Measure::SquareSecond, &walls, y) * 50f64.powi(3) / 6.0;
        let straight = prove(&bound::at_walls(&walls, &theta, &rough, 0.1));
        assert!((straight - 1.0).abs() < 1e-9, "{straight}");
        assert!(prove(&rough) < 0.5, "{}", prove(&rough));
    }
}
