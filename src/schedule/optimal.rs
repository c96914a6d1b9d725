//! The schedule with the least peak, or least square, of its second or third derivative.
//!
//! θ is a cubic on every interval between cutter locations, twice continuously differentiable:
//! state (θ, θ', θ'', γ), control the rise of θ'' over the interval. Angles are taken relative to a
//! straight line and arc length in units of a turn, so that all numbers are of size 1. Rows at
//! every interval: the four Bézier ordinates of θ between the straight walls, the three of θ' not
//! negative (so that the cubic itself, not samples of it, satisfies both), and `|θ''| ≤ γ` or
//! `|θ'''| ≤ γ`.
//!
//! *Peaks* take two rounds. The first finds the least γ of the whole path. Most of the path can do
//! with less, and the first round leaves open what it does. The second round has a γ for each turn,
//! none above the first round's by more than [`SPARE`], and makes their mean least. A small share
//! of `∫ θ''²` makes the answer unique: it then follows the walls continuously.
//! *Squares* take one round.

use super::bound;
use super::corridor::Corridor;
use super::{Pace, ScheduleOptions, bezier, by_turn, check, curve, piecewise};
use crate::artifact::schedule::{Measure, Schedule, ScheduleKind, Scope};
use crate::artifact::{Channel, Toolpath};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage as Room};
use crate::numerics::stages::{self, Options, Row, Solution, Stage};
use crate::observe::Observer;

/// State (θ, θ', θ'', γ) and controls (rise of θ'' over the interval, rise of γ after it).
pub(super) const X: usize = 4;
pub(super) const V: usize = 6;
/// What the second round may add to the least peak, as a share.
const SPARE: f64 = 1e-3;
/// Weight of the mean square against the mean of the turns' peaks in the second round.
const ROUND: f64 = 3e-3;
/// Parts of a turn over which bands of slopes change.
const PARTS: f64 = 20.0;
/// Samples of the trial that finds the size of the numbers.
const TRIAL: usize = 3000;
/// Share of the slope that full feed allows which counts as standing still.
const STANDING: f64 = 0.01;
/// What the mean factor may be above the least, as a share, for the least time.
const PACE_GAP: f64 = 1e-2;
/// Blocks of a turn with a factor of their own, for the least time.
const BLOCKS: f64 = 48.0;
/// Intervals at least, and at most where locations are too far apart.
const FEWEST: usize = 200;
const MOST: usize = 300_000;

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

/// What the solver came to.
pub(super) struct Solved {
    /// The walls, at the joints of the curve.
    pub walls: Corridor,
    pub theta: Vec<f64>,
    pub slope: Vec<f64>,
    /// Weights that may prove the bound.
    pub weights: Vec<Vec<f64>>,
}

/// Units of the solver.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolverUnits {
    /// Length of a turn, mm.
    pub length: f64,
    /// Where the path starts, mm.
    from: f64,
    /// θ at the start and slope (rad/mm) of the straight line that angles are relative to.
    pub base: [f64; 2],
    /// θ'' of size 1, rad per turn².
    second: f64,
    /// θ''' of size 1, in `second` per turn.
    third: f64,
}

impl SolverUnits {
    fn of(walls: &Corridor, turns: usize) -> SolverUnits {
        let n = walls.s.len() - 1;
        let middle = |i: usize| 0.5 * (walls.lo[i] + walls.hi[i]);
        let whole = walls.s[n] - walls.s[0];
        let slope = (middle(n) - middle(0)) / whole;
        SolverUnits {
            length: whole / turns.max(1) as f64,
            from: walls.s[0],
            base: [middle(0), slope],
            second: 1000.0,
            third: 30.0,
        }
    }

    /// For slopes within bands: what they change by, over a part of a turn.
    pub fn of_slopes(walls: &Corridor, turns: usize, slopes: &[[f64; 2]]) -> SolverUnits {
        let usual = SolverUnits::of(walls, turns);
        let [least, greatest] =
            slopes.iter().map(|s| s[0]).fold([f64::INFINITY, 0.0], |[a, b], v| [f64::min(a, v), f64::max(b, v)]);
        let change = ((greatest - least) * usual.length).clamp(1e-2, 1e3);
        SolverUnits { second: change * PARTS, third: PARTS, ..usual }
    }

    pub fn line(&self, walls: &Corridor, i: usize) -> f64 {
        self.base[0] + self.base[1] * (walls.s[i] - self.from)
    }
}

/// What a round makes least.
pub(super) enum Goal {
    /// One γ for all.
    Peak { third: bool },
    /// A γ for each turn, at most `cap`; turns begin at `borders`.
    Turns { third: bool, cap: f64, borders: Vec<bool> },
    /// The integral of the square.
    Square { third: bool },
    /// The integral of the square of the third derivative, with θ' within limits in each interval
    /// between samples, rad/mm.
    Even { slopes: Vec<[f64; 2]> },
    /// The mean over blocks of the factor γ ≥ 1 by which θ' and θ'' exceed what the pace allows.
    /// Solved for γ / `unit`.
    Pace { pace: Pace, unit: f64, borders: Vec<bool> },
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
    let mut parts = FEWEST.div_ceil(n);
    loop {
        let found = if parts == 1 {
            solve(path, walls, options, pace, observer)
        } else {
            solve(path, &refined(walls, parts), options, pace, observer)
        };
        parts *= 4;
        match found {
            Err(e) if e.kind == ErrorKind::Infeasible && parts <= 64 && n * parts <= MOST => {}
            found => return found,
        }
    }
}

/// The least over the whole path.
fn solve(
    path: &Toolpath,
    walls: &Corridor,
    options: &ScheduleOptions,
    pace: Option<Pace>,
    observer: &dyn Observer,
) -> Result<Solved> {
    let measure = options.settings.measure;
    let third = matches!(measure, Measure::PeakThird | Measure::SquareThird);
    let stuck = || {
        let message = "the channel leaves no room for a smooth schedule that never turns back";
        let since = Infeasible::NoSmoothSchedule { margin_deg: options.settings.margin_deg };
        Error::infeasible(Room::Schedule, message, since)
            .advise("allow less clearance, take a more slender or longer tool, or lower schedule.margin_deg")
    };
    let mut scale = SolverUnits::of(walls, path.turns.len());
    let thin = thinned(walls, TRIAL);
    // Twice, since the first trial may be far off in size.
    for _ in 0..2 {
        let trial = round(&thin, &scale, &Goal::Peak { third: false }, 1e-4).ok_or_else(stuck)?;
        scale.second *= trial.v[0][3].clamp(1e-4, 1e4);
    }
    if third {
        let trial = round(&thin, &scale, &Goal::Peak { third: true }, 1e-4).ok_or_else(stuck)?;
        scale.third *= trial.v[0][3].clamp(1e-4, 1e4);
    }
    observer.check(Room::Schedule)?;
    if options.settings.scope == Scope::Turns && pace.is_none() {
        return by_turn::solve(path, walls, measure, &scale).ok_or_else(stuck);
    }
    let (last, weights) = match measure {
        _ if let Some(pace) = pace => {
            // What the mean slope and the trial's peak come to: where the machine is slow or the
            // channel bends sharply, γ is thousands.
            let second = scale.second / scale.length.powi(2);
            let unit = pace.needed(scale.base[1].abs(), second).max(1.0);
            let goal = Goal::Pace { pace, unit, borders: blocks(walls, &scale) };
            let found = round(walls, &scale, &goal, 1e-4 / unit);
            (found.ok_or_else(stuck)?, Vec::new())
        }
        Measure::PeakSecond | Measure::PeakThird => {
            let first = round(walls, &scale, &Goal::Peak { third }, 1e-5).ok_or_else(stuck)?;
            observer.check(Room::Schedule)?;
            let cap = first.v[0][3] * (1.0 + SPARE);
            let borders = borders(path, walls);
            let second = round(walls, &scale, &Goal::Turns { third, cap, borders }, 1e-4);
            let mut weights = vec![first.costates.iter().map(|c| c[1]).collect()];
            if !third {
                weights.push(pressure(walls, &first));
            }
            (second.unwrap_or(first), weights)
        }
        Measure::SquareSecond | Measure::SquareThird => {
            let found = round(walls, &scale, &Goal::Square { third }, 1e-6).ok_or_else(stuck)?;
            let weight = if third {
                found.costates.iter().map(|c| c[1]).collect()
            } else {
                found.v.iter().map(|v| v[2]).collect()
            };
            (found, vec![weight])
        }
    };
    let (theta, slope) = values(walls, &scale, &last);
    Ok(Solved { walls: walls.clone(), theta, slope, weights })
}

/// θ, rad, and θ', rad/mm, at the samples of the walls.
pub(super) fn values(walls: &Corridor, scale: &SolverUnits, found: &Solution<X, V>) -> (Vec<f64>, Vec<f64>) {
    let theta = found.v.iter().enumerate().map(|(i, v)| scale.line(walls, i) + v[0]);
    (theta.collect(), found.v.iter().map(|v| scale.base[1] + v[1] / scale.length).collect())
}

/// The multipliers of `|θ''| ≤ γ` per length: the other form of the weight, better where walls
/// without width leave the costates open.
fn pressure(walls: &Corridor, found: &Solution<X, V>) -> Vec<f64> {
    let n = walls.s.len();
    let mut at = 0;
    let mut out = Vec::with_capacity(n);
    for i in 0..n {
        // Rows of walls and slope come first, see `stage`.
        let [walled, sloped] = if i + 1 == n { [2, 1] } else { [6, 2] };
        let before = walled + if walls.one_way { sloped } else { 0 };
        let [up, down] = [0, 1].map(|k| found.multipliers.get(at + before + k).copied().unwrap_or(0.0));
        let length = walls.s[(i + 1).min(n - 1)] - walls.s[i.saturating_sub(1)];
        out.push((up - down) / length);
        at += before + 2;
    }
    out
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

/// One run of the solver. `None` where the rows cannot be met.
fn round(walls: &Corridor, scale: &SolverUnits, goal: &Goal, gap: f64) -> Option<Solution<X, V>> {
    round_from(walls, scale, goal, gap, None)
}

/// One run of the solver, from a given (θ, θ', θ'') in its units.
pub(super) fn round_from(
    walls: &Corridor,
    scale: &SolverUnits,
    goal: &Goal,
    gap: f64,
    from: Option<[f64; 3]>,
) -> Option<Solution<X, V>> {
    let n = walls.s.len();
    let mut all = Vec::with_capacity(n);
    for i in 0..n {
        all.push(stage(walls, scale, goal, i));
    }
    let mut start = vec![[0.0, 0.0, 0.0, 1.0, 0.0, 0.0]; n];
    let mut fixed = [false; 8];
    if let Some([theta, slope, second]) = from {
        fixed[..3].fill(true);
        // What is given is not to be limited.
        all[0].rows.retain(|r| r.g[2..].iter().any(|g| *g != 0.0));
        start[0] = [theta, slope, second, 1.0, -second, 0.0];
        for i in 1..n {
            for c in 0..X {
                start[i][c] = all[i - 1].dynamics[c].iter().zip(&start[i - 1]).map(|(d, v)| d * v).sum();
            }
        }
    }
    let count: usize = all.iter().map(|s: &Stage<X, V>| s.rows.len()).sum();
    let options = Options {
        fixed,
        tolerance: gap / count as f64,
        slack: 0.1,
        barrier: 10.0 / count as f64,
        iterations: 150,
        ..Options::default()
    };
    let found = stages::solve(&mut all, &start, &(), &options)?;
    let enough = match goal {
        Goal::Pace { .. } => PACE_GAP * mean_factor(walls, scale, &found),
        _ => 1e3 * gap,
    };
    (found.excess < 1e-8 && found.complementarity * (count as f64) < enough).then_some(found)
}

/// The mean of γ over the path, in its units.
fn mean_factor(walls: &Corridor, scale: &SolverUnits, found: &Solution<X, V>) -> f64 {
    let share = |i: usize| {
        let interval = Interval::of(walls, scale, i);
        interval.h / interval.whole
    };
    found.v.iter().enumerate().map(|(i, v)| share(i) * v[3]).sum()
}

/// Dynamics, objective and rows of one interval (of the last sample: what holds there alone).
fn stage(walls: &Corridor, scale: &SolverUnits, goal: &Goal, i: usize) -> Stage<X, V> {
    let interval = Interval::of(walls, scale, i);
    let mut out = Stage::<X, V> { dynamics: interval.dynamics(), ..Stage::default() };
    out.hessian[5][5] = 1.0;
    interval.keep_within_walls(&mut out.rows);
    match goal {
        Goal::Pace { pace, unit, .. } => interval.keep_pace(pace, *unit, &mut out.rows),
        Goal::Peak { third } | Goal::Turns { third, .. } => interval.keep_below_peak(*third, &mut out.rows),
        Goal::Even { slopes } => {
            interval.keep_slopes(slopes, &mut out.rows);
            out.hessian[3][3] = interval.h.max(1e-9);
        }
        // γ is not used; something must hold it.
        Goal::Square { .. } => out.hessian[3][3] = interval.h.max(1e-9),
    }
    interval.weigh_peak(goal, &mut out);
    interval.weigh_square(goal, &mut out.hessian);
    out
}

/// An interval of the walls from one sample to the next, in units of the solver.
struct Interval<'a> {
    walls: &'a Corridor,
    scale: &'a SolverUnits,
    /// The sample at which it begins.
    i: usize,
    /// Whether nothing follows: it has no length then.
    last: bool,
    /// Length.
    h: f64,
    /// Length of the whole path.
    whole: f64,
}

impl<'a> Interval<'a> {
    fn of(walls: &'a Corridor, scale: &'a SolverUnits, i: usize) -> Self {
        let last = i + 1 == walls.s.len();
        let h = if last { 0.0 } else { (walls.s[i + 1] - walls.s[i]) / scale.length };
        let whole = (walls.s[walls.s.len() - 1] - walls.s[0]) / scale.length;
        Interval { walls, scale, i, last, h, whole }
    }

    /// θ, θ' and θ'' at the next sample from those here and the third derivative; γ stays.
    fn dynamics(&self) -> [[f64; V]; X] {
        let (u, h) = (self.scale.second, self.h);
        [
            [1.0, h, 0.5 * u * h * h, 0.0, u * h * h / 6.0, 0.0],
            [0.0, 1.0, u * h, 0.0, 0.5 * u * h, 0.0],
            [0.0, 0.0, 1.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        ]
    }

    /// The control points are between the walls, and θ only grows where it is to.
    fn keep_within_walls(&self, rows: &mut Vec<Row<V>>) {
        let Interval { walls, scale, i, h, .. } = *self;
        let u = scale.second;
        let level = |k: usize| [walls.lo[k] - scale.line(walls, k), walls.hi[k] - scale.line(walls, k)];
        let (here, next) = (level(i), level(if self.last { i } else { i + 1 }));
        let mut between = |g: [f64; V], share: f64| {
            let wall = [0, 1].map(|w| here[w] + share * (next[w] - here[w]));
            rows.push(Row { g, most: wall[1] });
            rows.push(Row { g: g.map(|v| -v), most: -wall[0] });
        };
        between([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 0.0);
        let most = scale.base[1] * scale.length;
        if !self.last {
            between([1.0, h / 3.0, 0.0, 0.0, 0.0, 0.0], 1.0 / 3.0);
            between([1.0, 2.0 * h / 3.0, u * h * h / 6.0, 0.0, 0.0, 0.0], 2.0 / 3.0);
        }
        if walls.one_way && !self.last {
            rows.push(Row { g: [0.0, -1.0, -0.5 * u * h, 0.0, 0.0, 0.0], most });
        }
        if walls.one_way {
            rows.push(Row { g: [0.0, -1.0, 0.0, 0.0, 0.0, 0.0], most });
        }
    }

    /// The control points of θ' are within the limits of the interval, and where it begins within
    /// those of the one before.
    fn keep_slopes(&self, slopes: &[[f64; 2]], rows: &mut Vec<Row<V>>) {
        let Interval { scale, i, h, .. } = *self;
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let own = slopes.get(i).copied().unwrap_or(free);
        let before = i.checked_sub(1).and_then(|k| slopes.get(k)).copied().unwrap_or(free);
        let both = [own[0].max(before[0]), own[1].min(before[1])];
        let mut within = |g: [f64; V], [least, most]: [f64; 2]| {
            let rise = |slope: f64| (slope - scale.base[1]) * scale.length;
            if most.is_finite() {
                rows.push(Row { g, most: rise(most) });
            }
            if least.is_finite() {
                rows.push(Row { g: g.map(|v| -v), most: -rise(least) });
            }
        };
        within([0.0, 1.0, 0.0, 0.0, 0.0, 0.0], both);
        if !self.last {
            within([0.0, 1.0, 0.5 * scale.second * h, 0.0, 0.0, 0.0], own);
        }
    }

    /// γ is at least 1 and as much as θ' and θ'' exceed what the pace allows; near the ends of the
    /// path θ all but stands.
    fn keep_pace(&self, pace: &Pace, unit: f64, rows: &mut Vec<Row<V>>) {
        let Interval { walls, scale, i, .. } = *self;
        let [rate, second] = [1.0 / (scale.length * pace.rate), scale.second / (scale.length.powi(2) * pace.second)];
        let [rate, second, base] = [rate / unit, second / unit, scale.base[1] / (pace.rate * unit)];
        let to_end = (walls.s[i] - walls.s[0]).min(walls.s[walls.s.len() - 1] - walls.s[i]);
        // Where θ never turns back its slope has one sign.
        for sign in if walls.one_way { &[1.0][..] } else { &[1.0, -1.0] } {
            rows.push(Row { g: [0.0, sign * rate, 0.0, -1.0, 0.0, 0.0], most: -sign * base });
            if to_end < pace.standing_mm {
                let g = [0.0, sign * rate, 0.0, 0.0, 0.0, 0.0];
                rows.push(Row { g, most: STANDING / unit - sign * base });
            }
        }
        rows.push(Row { g: [0.0, 0.0, second, -1.0, 0.0, 0.0], most: 0.0 });
        rows.push(Row { g: [0.0, 0.0, -second, -1.0, 0.0, 0.0], most: 0.0 });
        rows.push(Row { g: [0.0, 0.0, 0.0, -1.0, 0.0, 0.0], most: -1.0 / unit });
    }

    /// γ is at least the second, or the `third` derivative, of either sign.
    fn keep_below_peak(&self, third: bool, rows: &mut Vec<Row<V>>) {
        for sign in [1.0, -1.0] {
            let mut g = [0.0; V];
            (g[3], g[2]) = (-1.0, sign);
            if third {
                (g[2], g[4]) = (0.0, if self.last { 0.0 } else { sign / (self.h * self.scale.third) });
            }
            rows.push(Row { g, most: 0.0 });
        }
    }

    /// What γ costs, how much it may be, and where it may begin anew.
    fn weigh_peak(&self, goal: &Goal, out: &mut Stage<X, V>) {
        let borders = match goal {
            Goal::Square { .. } | Goal::Even { .. } => return,
            Goal::Peak { .. } => &[][..],
            Goal::Turns { borders, .. } | Goal::Pace { borders, .. } => borders,
        };
        out.gradient[3] = self.h / self.whole;
        if let Goal::Turns { cap, .. } = goal
            && cap.is_finite()
        {
            out.rows.push(Row { g: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], most: *cap });
        }
        if borders.get(self.i).is_some_and(|b| *b) {
            out.dynamics[3][5] = 1.0;
            out.hessian[5][5] = 0.0;
        }
    }

    /// What the integral of the square costs: all there is, or as much as keeps a curve round.
    fn weigh_square(&self, goal: &Goal, hessian: &mut [[f64; V]; V]) {
        let (third, square) = match goal {
            Goal::Peak { third } => (*third, 0.0),
            Goal::Turns { third, .. } => (*third, ROUND),
            Goal::Square { third } => (*third, 1.0),
            Goal::Even { .. } => (true, 1.0),
            Goal::Pace { .. } => (false, ROUND),
        };
        let weight = square * self.h / self.whole;
        if third {
            hessian[4][4] += if self.last { 0.0 } else { 2.0 * weight / (self.h * self.scale.third).powi(2) };
        } else {
            hessian[2][2] += 2.0 * weight;
            hessian[2][4] += weight;
            hessian[4][2] += weight;
            hessian[4][4] += 2.0 * weight / 3.0;
        }
    }
}
