//! One run of the solver: what it makes least, its units, and its rows.
//!
//! State (θ, θ', θ'', γ), control the rise of θ'' over the interval. Angles are taken relative to a
//! straight line and arc length in units of a turn, so that all numbers are of size 1. Rows at
//! every interval: the four Bézier ordinates of θ between the straight walls, the three of θ' not
//! negative (so that the cubic itself, not samples of it, satisfies both), and those of the goal.

use super::Pace;
use super::corridor::Corridor;
use crate::numerics::stages::{self, Inequality, Options, Solution, Stage};

/// State (θ, θ', θ'', γ) and controls (rise of θ'' over the interval, rise of γ after it).
const X: usize = 4;
const V: usize = 6;
/// Weight of the mean square against the mean of the turns' peaks in the second round.
const ROUND: f64 = 3e-3;
/// Parts of a turn over which bands of slopes change.
const PARTS: f64 = 20.0;
/// Share of the slope that full feed allows which counts as standing still.
const STANDING: f64 = 0.01;
/// Rows may be missed by this, rad where they are walls.
const EXCESS: f64 = 1e-8;
/// Multipliers from which rows count as contradicting one another: this share of the greatest, or
/// so many times as large as that which all but a few samples are below.
const HOT: [f64; 2] = [1e-3, 1e2];
/// Those few, as a share.
const RARE: f64 = 0.01;
/// What the mean factor may be above the least, as a share, for the least time.
const PACE_GAP: f64 = 1e-2;

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
    pub second: f64,
    /// θ''' of size 1, in `second` per turn.
    pub third: f64,
}

impl SolverUnits {
    pub fn of(walls: &Corridor, turns: usize) -> SolverUnits {
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

/// θ, rad, and θ', rad/mm, at the samples of the walls.
pub(super) fn values(walls: &Corridor, scale: &SolverUnits, found: &Solution<X, V>) -> (Vec<f64>, Vec<f64>) {
    let theta = found.v.iter().enumerate().map(|(i, v)| scale.line(walls, i) + v[0]);
    (theta.collect(), found.v.iter().map(|v| scale.base[1] + v[1] / scale.length).collect())
}

/// The multipliers of `|θ''| ≤ γ` per length: the other form of the weight, better where walls
/// without width leave the costates open.
pub(super) fn pressure(walls: &Corridor, found: &Solution<X, V>) -> Vec<f64> {
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

/// No curve keeps the rows: the samples at which they contradict one another. None are named where
/// the solver came to nothing at all.
#[derive(Debug)]
pub(super) struct Contradicting(pub Vec<usize>);

/// One run of the solver.
pub(super) fn round(
    walls: &Corridor,
    scale: &SolverUnits,
    goal: &Goal,
    gap: f64,
) -> std::result::Result<Solution<X, V>, Contradicting> {
    round_from(walls, scale, goal, gap, None)
}

/// One run of the solver, from a given (θ, θ', θ'') in its units.
pub(super) fn round_from(
    walls: &Corridor,
    scale: &SolverUnits,
    goal: &Goal,
    gap: f64,
    from: Option<[f64; 3]>,
) -> std::result::Result<Solution<X, V>, Contradicting> {
    let (found, rows) = run(walls, scale, goal, gap, from).ok_or(Contradicting(Vec::new()))?;
    let count: usize = rows.iter().sum();
    let enough = match goal {
        Goal::Pace { .. } => PACE_GAP * mean_factor(walls, scale, &found),
        _ => 1e3 * gap,
    };
    let is_kept = found.excess < EXCESS && found.complementarity * (count as f64) < enough;
    if is_kept { Ok(found) } else { Err(Contradicting(contradicting(&rows, &found.multipliers))) }
}

/// The samples whose rows have multipliers far beyond all others': where rows contradict one
/// another they grow without end. `rows` are the rows of each sample.
fn contradicting(rows: &[usize], multipliers: &[f64]) -> Vec<usize> {
    let mut rest = multipliers;
    let by_sample = rows.iter().map(|count| {
        let (own, after) = rest.split_at((*count).min(rest.len()));
        rest = after;
        own.iter().copied().fold(0.0, f64::max)
    });
    let by_sample: Vec<f64> = by_sample.collect();
    let mut sorted = by_sample.clone();
    sorted.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| sorted.get((share * sorted.len() as f64) as usize).or(sorted.last()).copied().unwrap_or(0.0);
    let least = (HOT[0] * at(1.0)).min(HOT[1] * at(1.0 - RARE));
    (0..rows.len()).filter(|i| by_sample[*i] > least).collect()
}

/// What the solver comes to, and how many rows each sample had.
fn run(
    walls: &Corridor,
    scale: &SolverUnits,
    goal: &Goal,
    gap: f64,
    from: Option<[f64; 3]>,
) -> Option<(Solution<X, V>, Vec<usize>)> {
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
    let rows: Vec<usize> = all.iter().map(|s: &Stage<X, V>| s.rows.len()).collect();
    let count: usize = rows.iter().sum();
    let options = Options {
        fixed,
        tolerance: gap / count as f64,
        slack: 0.1,
        barrier: 10.0 / count as f64,
        iterations: 150,
        ..Options::default()
    };
    Some((stages::solve(&mut all, &start, &(), &options)?, rows))
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
    fn keep_within_walls(&self, rows: &mut Vec<Inequality<V>>) {
        let Interval { walls, scale, i, h, .. } = *self;
        let u = scale.second;
        let level = |k: usize| [walls.lo[k] - scale.line(walls, k), walls.hi[k] - scale.line(walls, k)];
        let (here, next) = (level(i), level(if self.last { i } else { i + 1 }));
        let mut between = |g: [f64; V], share: f64| {
            let wall = [0, 1].map(|w| here[w] + share * (next[w] - here[w]));
            rows.push(Inequality { g, most: wall[1] });
            rows.push(Inequality { g: g.map(|v| -v), most: -wall[0] });
        };
        between([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], 0.0);
        let most = scale.base[1] * scale.length;
        if !self.last {
            between([1.0, h / 3.0, 0.0, 0.0, 0.0, 0.0], 1.0 / 3.0);
            between([1.0, 2.0 * h / 3.0, u * h * h / 6.0, 0.0, 0.0, 0.0], 2.0 / 3.0);
        }
        if walls.one_way && !self.last {
            rows.push(Inequality { g: [0.0, -1.0, -0.5 * u * h, 0.0, 0.0, 0.0], most });
        }
        if walls.one_way {
            rows.push(Inequality { g: [0.0, -1.0, 0.0, 0.0, 0.0, 0.0], most });
        }
    }

    /// The control points of θ' are within the limits of the interval, and where it begins within
    /// those of the one before.
    fn keep_slopes(&self, slopes: &[[f64; 2]], rows: &mut Vec<Inequality<V>>) {
        let Interval { scale, i, h, .. } = *self;
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let own = slopes.get(i).copied().unwrap_or(free);
        let before = i.checked_sub(1).and_then(|k| slopes.get(k)).copied().unwrap_or(free);
        let both = [own[0].max(before[0]), own[1].min(before[1])];
        let mut within = |g: [f64; V], [least, most]: [f64; 2]| {
            let rise = |slope: f64| (slope - scale.base[1]) * scale.length;
            if most.is_finite() {
                rows.push(Inequality { g, most: rise(most) });
            }
            if least.is_finite() {
                rows.push(Inequality { g: g.map(|v| -v), most: -rise(least) });
            }
        };
        within([0.0, 1.0, 0.0, 0.0, 0.0, 0.0], both);
        if !self.last {
            within([0.0, 1.0, 0.5 * scale.second * h, 0.0, 0.0, 0.0], own);
        }
    }

    /// γ is at least 1 and as much as θ' and θ'' exceed what the pace allows; near the ends of the
    /// path θ all but stands.
    fn keep_pace(&self, pace: &Pace, unit: f64, rows: &mut Vec<Inequality<V>>) {
        let Interval { walls, scale, i, .. } = *self;
        let [rate, second] = [1.0 / (scale.length * pace.rate), scale.second / (scale.length.powi(2) * pace.second)];
        let [rate, second, base] = [rate / unit, second / unit, scale.base[1] / (pace.rate * unit)];
        let to_end = (walls.s[i] - walls.s[0]).min(walls.s[walls.s.len() - 1] - walls.s[i]);
        // Where θ never turns back its slope has one sign.
        for sign in if walls.one_way { &[1.0][..] } else { &[1.0, -1.0] } {
            rows.push(Inequality { g: [0.0, sign * rate, 0.0, -1.0, 0.0, 0.0], most: -sign * base });
            if to_end < pace.standing_mm {
                let g = [0.0, sign * rate, 0.0, 0.0, 0.0, 0.0];
                rows.push(Inequality { g, most: STANDING / unit - sign * base });
            }
        }
        rows.push(Inequality { g: [0.0, 0.0, second, -1.0, 0.0, 0.0], most: 0.0 });
        rows.push(Inequality { g: [0.0, 0.0, -second, -1.0, 0.0, 0.0], most: 0.0 });
        rows.push(Inequality { g: [0.0, 0.0, 0.0, -1.0, 0.0, 0.0], most: -1.0 / unit });
    }

    /// γ is at least the second, or the `third` derivative, of either sign.
    fn keep_below_peak(&self, third: bool, rows: &mut Vec<Inequality<V>>) {
        for sign in [1.0, -1.0] {
            let mut g = [0.0; V];
            (g[3], g[2]) = (-1.0, sign);
            if third {
                (g[2], g[4]) = (0.0, if self.last { 0.0 } else { sign / (self.h * self.scale.third) });
            }
            rows.push(Inequality { g, most: 0.0 });
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
            out.rows.push(Inequality { g: [0.0, 0.0, 0.0, 1.0, 0.0, 0.0], most: *cap });
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
