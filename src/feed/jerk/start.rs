//! A profile within all limits to start from: it always exists, since ever slower it keeps every
//! limit.
//!
//! One Bernstein coefficient for each cell, its middle one, makes a curve of parabolas with
//! continuous slope: at a joint x is the mean of its neighbours' coefficients, weighted by lengths.
//! The coefficients are what each cell allows at constant speed, so reduced that neither ṡ² nor ṡ
//! rises faster over the length than a share of the acceleration and of the time `τ = a/j` in which
//! acceleration changes allow, then averaged over the way that is made in that time. Where that is
//! still too fast, those cells are slowed down and the rest anew.

use super::cells::{Cell, Limits, greatest};
use crate::parallel;

/// Share of the limits that is used: room to the limits for the solver to start in.
const SHARE: f64 = 0.7;
/// Shares of a cell's steady speed squared and of its tangential acceleration.
const STEADY: f64 = 0.5;
const RISE: f64 = 0.3;
/// Greatest change of speed over the length, in shares of 1/τ.
const SLOPE: f64 = 0.4;
/// Cells on either side that are averaged at most.
const REACH: usize = 100;
/// Rounds in which cells are slowed down.
const ROUNDS: usize = 16;

/// `(x, u, w)` at the start of every cell between the end cells, then x and u at the end of the
/// last. `ends`: length and greatest x of the end cells. `None` where numbers are not finite.
pub(super) fn profile(inner: &[Cell], ends: [[f64; 2]; 2], limits: &Limits) -> Option<Vec<[f64; 3]>> {
    let mut allowed: Vec<Allowed> = inner.iter().map(|c| Allowed::of(c, limits)).collect();
    let n = inner.len();
    allowed[0].x = allowed[0].x.min(STEADY * ends[0][1]);
    allowed[n - 1].x = allowed[n - 1].x.min(STEADY * ends[1][1]);
    let time = limits.iter().map(|l| l[1] / l[2]).fold(0.0, f64::max);
    for round in 0..=ROUNDS {
        let b = smooth(inner, &allowed, time);
        let mut v = joined(inner, &b, ends);
        let at_ends = (v[0][0] / ends[0][1]).max(v[n][0] / ends[1][1]) / SHARE;
        let excess = |(c, v): (&Cell, &[f64; 3])| c.excess(v, limits) / SHARE;
        let over: Vec<f64> = parallel::map_short(super::PER_THREAD, inner.iter().zip(&v[..n]), excess);
        let worst = over.iter().fold(at_ends, |m, e| m.max(*e));
        if !worst.is_finite() {
            return None;
        }
        if worst <= 1.0 || round == ROUNDS {
            let slower = worst.max(1.0);
            v.iter_mut().for_each(|v| v.iter_mut().for_each(|x| *x /= slower));
            return Some(v);
        }
        for (i, o) in over.iter().enumerate() {
            // What is too much may come from the neighbours' slopes.
            if *o > 1.0 {
                for a in &mut allowed[i.saturating_sub(1)..(i + 2).min(n)] {
                    a.slow_down(*o);
                }
            }
        }
    }
    None
}

/// Greatest x and greatest x'/2 of a cell.
struct Allowed {
    x: f64,
    u: f64,
}

impl Allowed {
    fn of(c: &Cell, limits: &Limits) -> Allowed {
        let u = (0..limits.len()).map(|k| limits[k][1] / greatest(c.axes[k].first())).fold(f64::INFINITY, f64::min);
        Allowed { x: STEADY * c.steady(limits), u: RISE * u }
    }

    fn slow_down(&mut self, over: f64) {
        let by = over.clamp(1.05, 4.0).sqrt();
        self.x /= by;
        self.u /= by;
    }
}

/// The middle coefficients.
fn smooth(inner: &[Cell], allowed: &[Allowed], time: f64) -> Vec<f64> {
    let n = inner.len();
    let mut x: Vec<f64> = allowed.iter().map(|a| a.x).collect();
    let next = |x: f64, i: usize, k: usize| {
        let d = 0.5 * (inner[i].h + inner[k].h);
        let by_rise = x + 2.0 * allowed[i].u.min(allowed[k].u) * d;
        by_rise.min((x.sqrt() + SLOPE * d / time).powi(2))
    };
    for i in 1..n {
        x[i] = x[i].min(next(x[i - 1], i - 1, i));
    }
    for i in (1..n).rev() {
        x[i - 1] = x[i - 1].min(next(x[i], i, i - 1));
    }
    let reach: Vec<f64> = x.iter().map(|x| 0.5 * time * x.sqrt()).collect();
    let once = averaged(inner, &x, &reach);
    averaged(inner, &once, &reach)
}

/// Means over the cells whose middles are at most `reach` from the middle of each.
fn averaged(inner: &[Cell], x: &[f64], reach: &[f64]) -> Vec<f64> {
    let n = inner.len();
    let of = |i: usize| {
        let (mut sum, mut length) = (inner[i].h * x[i], inner[i].h);
        let (mut before, mut after) = (0.0, 0.0);
        for d in 1..=REACH {
            // As far on one side as on the other: what rises evenly stays.
            let (Some(a), Some(b)) = (i.checked_sub(d), Some(i + d).filter(|b| *b < n)) else { break };
            before += 0.5 * (inner[a].h + inner[a + 1].h);
            after += 0.5 * (inner[b].h + inner[b - 1].h);
            if before.max(after) > reach[i] {
                break;
            }
            sum += inner[a].h * x[a] + inner[b].h * x[b];
            length += inner[a].h + inner[b].h;
        }
        sum / length
    };
    parallel::map_short(super::PER_THREAD, 0..n, of)
}

/// The curve of the middle coefficients. At its ends x and u are those of constant jerk from and to
/// rest: `x = 3/2 h u`.
fn joined(inner: &[Cell], b: &[f64], ends: [[f64; 2]; 2]) -> Vec<[f64; 3]> {
    let n = inner.len();
    let outer = |h: f64, near: f64, b: f64| 1.5 * h * b / (near + 1.5 * h);
    let mut out = Vec::with_capacity(n + 1);
    for i in 0..=n {
        let v = if i == 0 {
            let x = outer(ends[0][0], inner[0].h, b[0]);
            [x, (b[0] - x) / inner[0].h, 0.0]
        } else if i == n {
            let x = outer(ends[1][0], inner[n - 1].h, b[n - 1]);
            [x, (x - b[n - 1]) / inner[n - 1].h, 0.0]
        } else {
            let (before, after) = (inner[i - 1].h, inner[i].h);
            let x = (after * b[i - 1] + before * b[i]) / (before + after);
            [x, (b[i] - b[i - 1]) / (before + after), 0.0]
        };
        out.push(v);
    }
    for i in 0..n {
        out[i][2] = (out[i + 1][1] - out[i][1]) / inner[i].h;
    }
    out
}
