//! Curves that are not NURBS by nature, fitted within a stated bound: curves in the parameter plane
//! of a surface carried into space, and curves run by their length.

use super::param::ParamMap;
use crate::geometry::Point;
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::fit::interpolate_curve;
use crate::geometry::nurbs::pieces::joined;

/// Greatest distance between a fitted curve and what it stands for, mm: a tenth of what the
/// tessellation welds.
pub const FIT_MM: f64 = 1e-5;
/// A fit with more points than this is cut in two instead.
const MOST_POINTS: usize = 256;
/// Times that a range is cut in two: what has not been met then is a jump.
const DEEPEST: usize = 14;
/// A curve that needs more pieces than this is noise.
const MOST_PIECES: usize = 400;

/// Curves over consecutive ranges within [`FIT_MM`] of `at`; `None` where it jumps or is not
/// finite.
pub fn fit(at: &dyn Fn(f64) -> Point, range: [f64; 2]) -> Option<Vec<NurbsCurve>> {
    let mut out = Vec::new();
    split_fit(at, range, 0, &mut out)?;
    Some(out)
}

fn split_fit(at: &dyn Fn(f64) -> Point, range: [f64; 2], depth: usize, out: &mut Vec<NurbsCurve>) -> Option<()> {
    if let Some(c) = one_fit(at, range) {
        out.push(c);
        return Some(());
    }
    let [a, b] = range.map(at);
    if !(a - b).norm().is_finite() {
        return None;
    }
    if depth == DEEPEST || out.len() >= MOST_PIECES {
        return None;
    }
    let middle = 0.5 * (range[0] + range[1]);
    split_fit(at, [range[0], middle], depth + 1, out)?;
    split_fit(at, [middle, range[1]], depth + 1, out)
}

fn one_fit(at: &dyn Fn(f64) -> Point, [from, to]: [f64; 2]) -> Option<NurbsCurve> {
    let mut n = 4;
    let mut before = f64::INFINITY;
    while n <= MOST_POINTS {
        let t: Vec<f64> = (0..=n).map(|k| from + (to - from) * k as f64 / n as f64).collect();
        let poles: Vec<_> = t.iter().map(|t| at(*t).coords.push(1.0)).collect();
        let c = interpolate_curve(&poles, &t, 3).ok()?;
        let step = (to - from) / n as f64;
        let off = t[..n].iter().flat_map(|t| [0.25, 0.5, 0.75].map(|s| t + s * step));
        let worst = off.map(|t| (c.point(t) - at(t)).norm()).fold(0.0, f64::max);
        // Samples are not bounds: half is left for what lies between them.
        if worst <= 0.5 * FIT_MM {
            return Some(c);
        }
        // A smooth curve gains a factor of sixteen; without any gain there is a corner.
        if !(worst < 0.6 * before) && n >= 32 {
            return None;
        }
        before = worst;
        n *= 2;
    }
    None
}

/// The curve over [0, 1] run evenly by the file's parameter; `None` where it cannot be fitted.
pub fn by_parameter(c: &NurbsCurve, map: &ParamMap) -> Option<NurbsCurve> {
    if map.is_even() {
        return Some(c.clone());
    }
    joined(&fit(&|s| c.point(map.ours(s)), [0.0, 1.0])?)
}

/// The curve over [0, 1] run evenly by its length; `None` where it cannot be fitted.
pub fn by_length(c: &NurbsCurve) -> Option<NurbsCurve> {
    const STEPS: usize = 4096;
    let param = |k: usize| k as f64 / STEPS as f64;
    let mut sum = vec![0.0];
    for k in 0..STEPS {
        // Simpson's rule over the speed.
        let speed = |t: f64| c.derivatives(t).1.norm();
        let (a, b) = (param(k), param(k + 1));
        sum.push(sum[k] + (b - a) / 6.0 * (speed(a) + 4.0 * speed(0.5 * (a + b)) + speed(b)));
    }
    let total = sum[STEPS];
    if !(total > 0.0) {
        return None;
    }
    let at = |s: f64| {
        let goal = s.clamp(0.0, 1.0) * total;
        let k = sum.partition_point(|x| *x <= goal).clamp(1, STEPS);
        let share = (goal - sum[k - 1]) / (sum[k] - sum[k - 1]).max(f64::MIN_POSITIVE);
        c.point(param(k - 1) + share * (param(k) - param(k - 1)))
    };
    joined(&fit(&at, [0.0, 1.0])?)
}
