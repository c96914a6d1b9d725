//! Time-optimal speed along a given curve: reachability analysis on `x = ṡ²`, `u = s̈` (equations on the stage's page).
//!
//! In every interval the limits are half planes `a u + b x ≤ c` with `c ≥ 0`, so rest (0, 0) is always allowed and the set
//! of `x` from which the end can be reached is an interval that begins at 0; only its greatest value is needed.

use crate::error::{Error, Result, Stage};
use crate::numerics::spline::CubicSpline;
use crate::observe::Observer;

/// Below this a coefficient of `u` is taken as 0: with limits scaled to 1 it moves the limit by less than rounding.
const FLAT: f64 = 1e-14;

/// Speed squared at the locations, acceleration along the path in the intervals.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Profile {
    /// ṡ², mm²/s².
    pub x: Vec<f64>,
    /// s̈, mm/s².
    pub u: Vec<f64>,
}

/// `a u + b x ≤ c`.
#[derive(Clone, Copy, Debug)]
struct Half {
    a: f64,
    b: f64,
    c: f64,
}

/// The range of `u` at some `x`, with the slopes of its ends in `x`.
struct Range {
    low: f64,
    low_slope: f64,
    high: f64,
    high_slope: f64,
}

fn range(halves: &[Half], x: f64) -> Range {
    let mut r = Range { low: f64::NEG_INFINITY, low_slope: 0.0, high: f64::INFINITY, high_slope: 0.0 };
    for h in halves {
        let v = (h.c - h.b * x) / h.a;
        if h.a > FLAT && v < r.high {
            (r.high, r.high_slope) = (v, -h.b / h.a);
        } else if h.a < -FLAT && v > r.low {
            (r.low, r.low_slope) = (v, -h.b / h.a);
        }
    }
    r
}

/// The greatest `x ≤ cap` for which some `u` satisfies all. The width of the range of `u` is concave in `x` and not
/// negative at 0, so Newton's method from the right falls onto the boundary in finitely many steps.
fn greatest(halves: &[Half], cap: f64) -> f64 {
    let mut x = cap;
    for h in halves {
        if h.a.abs() <= FLAT && h.b > 0.0 {
            x = x.min(h.c / h.b);
        }
    }
    for _ in 0..100 {
        let r = range(halves, x);
        let (width, slope) = (r.high - r.low, r.high_slope - r.low_slope);
        if width >= 0.0 {
            return x;
        }
        let next = x - width / slope;
        if !(next < x && slope < 0.0) {
            return x;
        }
        x = next.max(0.0);
    }
    x
}

/// Limits of all axes' accelerations over the whole of interval `i`.
///
/// Within it `u` is constant, `q'` quadratic, `q''` and `x + 2tu` linear in `t`, so the acceleration is a quadratic: it is
/// bounded by its Bernstein coefficients `f(0)`, `2 f(h/2) − (f(0) + f(h))/2`, `f(h)`, each linear in `(x, u)`.
fn halves(curve: &CubicSpline, i: usize, limits: &[[f64; 2]; 5], out: &mut Vec<Half>) {
    out.clear();
    let s = curve.abscissae();
    let h = s[i + 1] - s[i];
    let [start, middle, end] =
        [0.0, 0.5 * h, h].map(|t| super::at(curve, i, t).map(|[_, q1, q2]| [q1 + 2.0 * t * q2, q2]));
    for (k, [_, most]) in limits.iter().enumerate() {
        let inner = [0, 1].map(|j| 2.0 * middle[k][j] - 0.5 * (start[k][j] + end[k][j]));
        for [a, b] in [start[k], inner, end[k]] {
            out.push(Half { a: a / most, b: b / most, c: 1.0 });
            out.push(Half { a: -a / most, b: -b / most, c: 1.0 });
        }
    }
}

/// Greatest ṡ² at the ends of interval `i`, by its own cap and axis velocities over the whole of it; straight between.
fn cap(curve: &CubicSpline, i: usize, limits: &[[f64; 2]; 5], most: &[f64]) -> [f64; 2] {
    let s = curve.abscissae();
    let h = s[i + 1] - s[i];
    let [start, middle, end] = [0.0, 0.5 * h, h].map(|t| super::at(curve, i, t).map(|q| q[1]));
    let own = most.get(i).copied().unwrap_or(f64::INFINITY);
    limits.iter().enumerate().fold([own; 2], |m, (k, [most, _])| {
        let inner = 2.0 * middle[k] - 0.5 * (start[k] + end[k]);
        let line = super::caps::of_velocity([start[k], inner, end[k]], *most, own);
        [m[0].min(line[0]), m[1].min(line[1])]
    })
}

/// The fastest profile from rest to rest. `limits`: velocity and acceleration of each axis; `most`: greatest
/// ṡ² in each interval.
pub(super) fn fastest(
    curve: &CubicSpline,
    limits: &[[f64; 2]; 5],
    most: &[f64],
    observer: &dyn Observer,
) -> Result<Profile> {
    let s = curve.abscissae();
    let n = s.len();
    let mut lines = Vec::with_capacity(32);
    // Backwards: the greatest x from which the end can be reached at rest.
    let mut reach: Vec<f64> = vec![0.0; n];
    // Caps at the ends of the intervals, kept for the way forwards.
    let mut caps = vec![0.0; n - 1];
    for i in (0..n - 1).rev() {
        if i % 8192 == 0 {
            observer.check(Stage::Feed)?;
        }
        let h = s[i + 1] - s[i];
        halves(curve, i, limits, &mut lines);
        let [here, there] = cap(curve, i, limits, most);
        lines.push(Half { a: 2.0 * h, b: 1.0, c: reach[i + 1].min(there) });
        lines.push(Half { a: -2.0 * h, b: -1.0, c: 0.0 });
        reach[i] = greatest(&lines, here);
        caps[i] = there;
    }
    // Forwards: as fast as that allows.
    let (mut x, mut u) = (vec![0.0; n], vec![0.0; n - 1]);
    for i in 0..n - 1 {
        let h = s[i + 1] - s[i];
        halves(curve, i, limits, &mut lines);
        let most = reach[i + 1].min(caps[i]);
        x[i + 1] = (x[i] + 2.0 * h * range(&lines, x[i]).high).clamp(0.0, most);
        u[i] = (x[i + 1] - x[i]) / (2.0 * h);
        if x[i].max(x[i + 1]) <= 0.0 {
            return Err(Error::usage(
                Stage::Feed,
                format!("the axes cannot start along the path at location {i}: their positions change too abruptly"),
            ));
        }
    }
    Ok(Profile { x, u })
}
