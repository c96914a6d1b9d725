//! Near time-optimal speed under velocity, acceleration and jerk of all axes at once (equations on
//! the stage's page).
//!
//! Over every cell `w = u'` is constant, so `u` is linear and `x` quadratic in `s`, and
//! acceleration is continuous. In a cell the axes' accelerations and the brackets of their jerks
//!
//! ```text
//! a = q' u + q'' x        j = √x (q' w + 3 q'' u + q''' x)
//! ```
//!
//! are cubic and quadratic where the curve is, of degree 5 and 4 where that is of degree 5; their
//! Bernstein coefficients, linear in `(x, u, w)` at the cell's start, bound them over the whole
//! of it.
//! Limits of jerk, `|bracket| ≤ J / √x`, are not convex:
//! `1/√x` is convex in `x`, so its tangent lies below it, and with the tangent in its place the
//! limit is convex and a little too strict. The tangent is taken anew at every iterate of the
//! interior-point method ([`crate::numerics::stages`]), so at the end nothing is lost by it
//! (sequential convexification as in "TOPP3", with the sequence folded into the iterations); its
//! bend counts in the second derivative of the Lagrangian, without which rough paths would take
//! hundreds of iterations. The time `∫ ds/√x` is convex.
//!
//! The iterates do not leave the limits: they begin with a profile within them (`start` module; one
//! always exists, since ever slower every limit is kept), and what keeps the tangents keeps the
//! limits. The path is searched in stretches (`search` module); one whose search has left the
//! limits keeps the profile that it began with. So there is always an answer.
//!
//! How far it is from the fastest is proved by multipliers (`bound` module), on rough paths those
//! of a convex problem that allows more (`relaxed` module).
//!
//! From and to rest jerk along the path is constant over the outermost cells, `x = 3/2 h u` at
//! their inner ends, with the solver's choice of `u` there.

use super::PER_THREAD;
use super::caps::Caps;
use super::curve::AxisCurve;
use crate::observe::Observer;
use crate::parallel;

mod bound;
mod cells;
mod relaxed;
mod rows;
mod search;
mod start;
mod window;

pub(super) use cells::Limits;
use cells::{Cell, Units};
use rows::Problem;

/// Speed along the path on a grid of its own.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Smooth {
    /// Arc lengths, mm; the path's locations are among them.
    pub s: Vec<f64>,
    /// ṡ², mm²/s², at the grid.
    pub x: Vec<f64>,
    /// s̈, mm/s².
    pub u: Vec<f64>,
    /// Time from the start, s.
    pub t: Vec<f64>,
    /// du/ds after each point of the grid but the last; of the first and last cell, where jerk
    /// along the path is constant instead: that jerk.
    pub w: Vec<f64>,
    /// No profile on this grid that keeps the limits takes less time by more than this share;
    /// proved.
    pub gap: f64,
}

/// See the module's page. `None` where
/// derivatives of the curve are too great for numbers, or when the user has asked to stop.
pub(super) fn fastest(
    curve: &AxisCurve,
    limits: &Limits,
    (feed, bounded): (f64, bool),
    cap: &Caps,
    observer: &dyn Observer,
) -> Option<Smooth> {
    let grid = cells::grid(curve, cap);
    let units = Units::of(&grid, feed, limits);
    let mut room = cells::derivatives(&grid, limits.len());
    let cells = cells::cells(curve, &grid, cap, (limits, units), &mut room);
    let scaled = units.scaled(limits);
    let (first, last) = (cells.first()?, cells.last()?);
    let ends = [first, last].map(|c| [c.h, c.end_from_rest(&scaled)]);
    let inner = cells.get(1..cells.len() - 1).filter(|c| !c.is_empty())?;
    let begin = start::profile(inner, ends, &scaled)?;
    let problem = Problem { inner, ends, limits: &scaled };
    let found = search::fastest(&problem, &begin, bounded, observer)?;
    let mut out = assemble(&grid, &cells, &found, units);
    slow_down(&mut out, inner, &scaled, units);
    out.t.iter().chain(&out.x).all(|v| v.is_finite()).then_some(out)
}

fn assemble(grid: &[(f64, usize)], cells: &[Cell], found: &search::Fastest, units: Units) -> Smooth {
    let (rate, l, acceleration) = (units.rate(), units.length, units.acceleration());
    let s: Vec<f64> = grid.iter().map(|g| g.0).collect();
    let mut out = Smooth { s, x: vec![0.0], u: vec![0.0], t: vec![0.0], w: Vec::new(), gap: 1.0 - found.least };
    let mut t = 0.0;
    for (i, c) in cells.iter().enumerate() {
        // In an end cell x = 3/2 h u at its inner end, reached in √(6 h/u) = 3 h/√x with jerk u
        // over that time.
        let at_end = |v: &[f64; 3]| {
            let time = 3.0 * c.h / v[0].sqrt();
            (v[0] / (1.5 * c.h) / time * rate * acceleration, time)
        };
        let (w, took) = match (i, found.v.get(i.saturating_sub(1))) {
            (_, None) => continue,
            (0, Some(v)) => at_end(v),
            (i, Some(v)) if i + 1 == cells.len() => at_end(v),
            (_, Some(v)) => (v[2] * acceleration / l, duration(v, c.h)),
        };
        t += took;
        out.w.push(w);
        out.t.push(t / rate);
        let next = found.v.get(i).copied().unwrap_or_default();
        let rest = i + 1 == cells.len();
        out.x.push(if rest { 0.0 } else { next[0] * units.speed * units.speed });
        out.u.push(if rest { 0.0 } else { next[1] * acceleration });
    }
    out
}

/// `∫ ds / √(x + 2 u s + w s²)` over `h`: Gauss–Legendre, 8 points.
fn duration(v: &[f64; 3], h: f64) -> f64 {
    const NODES: [[f64; 2]; 4] = [
        [0.1834346424956498, 0.362_683_783_378_362],
        [0.525_532_409_916_329, 0.3137066458778873],
        [0.7966664774136267, 0.2223810344533745],
        [0.9602898564975363, 0.1012285362903763],
    ];
    let mut sum = 0.0;
    for [at, weight] in NODES {
        for sign in [1.0, -1.0] {
            let s = 0.5 * h * (1.0 + sign * at);
            sum += weight / (v[0] + s * (2.0 * v[1] + s * v[2])).max(f64::MIN_POSITIVE).sqrt();
        }
    }
    0.5 * h * sum
}

/// What rounding has left beyond a limit is taken out by running the whole that much slower.
fn slow_down(out: &mut Smooth, inner: &[Cell], limits: &Limits, units: Units) {
    let acceleration = units.acceleration();
    let of = |(i, c): (usize, &Cell)| {
        let k = i + 1;
        let v = [out.x[k] / units.speed.powi(2), out.u[k] / acceleration, out.w[k] * units.length / acceleration];
        c.excess(&v, limits)
    };
    let over = parallel::map_short(PER_THREAD, inner.iter().enumerate(), of).into_iter().fold(1.0, f64::max);
    if over > 1.0 {
        let (slower, last) = (over.sqrt(), out.w.len() - 1);
        out.gap = 1.0 - (1.0 - out.gap) / slower;
        out.x.iter_mut().for_each(|x| *x /= over);
        out.u.iter_mut().for_each(|u| *u /= over);
        out.t.iter_mut().for_each(|t| *t *= slower);
        for (i, w) in out.w.iter_mut().enumerate() {
            *w /= if i == 0 || i == last { over * slower } else { over };
        }
    }
}

#[cfg(test)]
mod tests;
