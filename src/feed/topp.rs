//! Time-optimal speed along a given curve: reachability analysis on `x = ṡ²`, `u = s̈` (equations
//! on the stage's page).
//!
//! In every interval the limits are strips about rest, `|a u + b x| ≤ c`, so rest (0, 0) is always
//! allowed and the set of `x` from which the end can be reached is an interval that begins at 0;
//! only its greatest value is needed.

use super::caps::{Caps, of_velocity};
use super::curve::{AxisCurve, bernstein};
use crate::error::{Error, Result, Stage};
use crate::observe::Observer;
use crate::parallel;

/// Below this a coefficient of `u` is taken as 0: with limits scaled to 1 it moves the limit by
/// less than rounding.
const FLAT: f64 = 1e-14;

/// Speed squared at the locations, acceleration along the path in the intervals.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Profile {
    /// ṡ², mm²/s².
    pub x: Vec<f64>,
    /// s̈, mm/s².
    pub u: Vec<f64>,
}

/// Limits of all axes' accelerations over an interval, each a strip `|a u + b x| ≤ 1`, solved for
/// `u`.
///
/// Within the interval `u` is constant, `q'` quadratic, `q''` and `x + 2tu` linear in `t`, so the
/// acceleration `q' u + q'' (x + 2tu)` is a quadratic: it is bounded by its Bernstein coefficients,
/// each linear in `(x, u)`.
#[derive(Clone, Copy, Debug)]
struct Strips<'a> {
    rows: &'a [Strip],
    /// Greatest `x` by strips in which `u` does not matter, and by the caps of ṡ² at the start of
    /// the interval.
    most_here: f64,
    /// Greatest `x` at its end by the caps.
    most_there: f64,
    /// Its length, mm.
    length: f64,
}

/// One strip.
#[derive(Clone, Copy, Debug)]
struct Strip {
    /// `−b/a`: slope of its middle in `x`.
    slope: f64,
    /// `1/|a|`: half its height; without end where `u` does not matter.
    half: f64,
}

impl Strip {
    const WITHOUT_END: Strip = Strip { slope: 0.0, half: f64::INFINITY };

    /// `|a u + b x| ≤ 1`; where `u` does not matter it is a limit of `x` at the interval's start.
    fn of(a: f64, b: f64, caps: &mut [f64; 2]) -> Strip {
        if a.abs() > FLAT {
            return Strip { slope: -b / a, half: 1.0 / a.abs() };
        }
        if b != 0.0 {
            caps[0] = caps[0].min(1.0 / b.abs());
        }
        Strip::WITHOUT_END
    }
}

/// Bernstein coefficients of an acceleration over an interval, on cubics and on curves of degree 5.
const OF_AXIS: usize = 3;
const OF_BENT_AXIS: usize = 5;

/// The range of `u` at some `x`, with the slopes of its ends in `x`.
struct Range {
    low: f64,
    low_slope: f64,
    high: f64,
    high_slope: f64,
}

impl<'a> Strips<'a> {
    /// Of interval `i`. `limits`: velocity and acceleration of each axis; `rows`: [`OF_AXIS`] for
    /// each axis, to be filled.
    fn new(curve: &AxisCurve, i: usize, limits: &[[f64; 2]], most: &Caps, rows: &'a mut [Strip]) -> Self {
        let s = curve.abscissae();
        let h = s[i + 1] - s[i];
        let own = most.square(i);
        let mut caps = [own; 2];
        let of_axis = rows.len() / limits.len().max(1);
        for (k, ([velocity, acceleration], rows)) in
            limits.iter().zip(rows.chunks_exact_mut(of_axis.max(1))).enumerate()
        {
            rows.fill(Strip::WITHOUT_END);
            if let Some(quintic) = curve.quintic(i, k) {
                let (q1, q2, _) = bernstein(quintic, 0.0, h);
                let line = of_velocity(&q1, most.velocity(i, k, *velocity), own);
                caps = [caps[0].min(line[0]), caps[1].min(line[1])];
                // q' + 2t q'' and q'', both of degree 4.
                for (j, row) in rows.iter_mut().enumerate() {
                    let share = j as f64 / 4.0;
                    let (before, after) = (if j > 0 { q2[j - 1] } else { 0.0 }, if j < 4 { q2[j] } else { 0.0 });
                    let second = share * before + (1.0 - share) * after;
                    *row =
                        Strip::of((q1[j] + 2.0 * h * share * before) / acceleration, second / acceleration, &mut caps);
                }
                continue;
            }
            // q' = b + 2ct + 3dt², q'' = 2c + 6dt, q' + 2t q'' = b + 6ct + 15dt².
            let [_, b, c, d] = curve.cubic(i, k);
            let (c, d) = (c * h, d * h * h);
            let line = of_velocity(&[b, b + c, b + 2.0 * c + 3.0 * d], most.velocity(i, k, *velocity), own);
            caps = [caps[0].min(line[0]), caps[1].min(line[1])];
            let of_u = [b, b + 3.0 * c, b + 6.0 * c + 15.0 * d];
            let of_x = [2.0 * c, 2.0 * c + 3.0 * d, 2.0 * c + 6.0 * d].map(|v| v / h);
            for ((a, b), row) in of_u.into_iter().zip(of_x).zip(rows) {
                *row = Strip::of(a / acceleration, b / acceleration, &mut caps);
            }
        }
        Strips { rows, most_here: caps[0], most_there: caps[1], length: h }
    }

    fn range(&self, x: f64) -> Range {
        let mut r = Range { low: f64::NEG_INFINITY, low_slope: 0.0, high: f64::INFINITY, high_slope: 0.0 };
        for Strip { slope, half } in self.rows {
            let (low, high) = (slope * x - half, slope * x + half);
            if high < r.high {
                (r.high, r.high_slope) = (high, *slope);
            }
            if low > r.low {
                (r.low, r.low_slope) = (low, *slope);
            }
        }
        r
    }

    /// The greatest `x` from which some `u` within all limits leads to at most `next` at the
    /// interval's end. The width of the range of `u` is concave in `x` and not negative at 0, so
    /// Newton's method from the right falls onto the boundary in finitely many steps.
    fn greatest(&self, next: f64) -> f64 {
        let per_length = 0.5 / self.length;
        let mut x = self.most_here;
        for _ in 0..100 {
            let mut r = self.range(x);
            let (to_next, to_rest) = ((next - x) * per_length, -x * per_length);
            if to_next < r.high {
                (r.high, r.high_slope) = (to_next, -per_length);
            }
            if to_rest > r.low {
                (r.low, r.low_slope) = (to_rest, -per_length);
            }
            let (width, slope) = (r.high - r.low, r.high_slope - r.low_slope);
            if width >= 0.0 {
                return x;
            }
            let below = x - width / slope;
            if !(below < x && slope < 0.0) {
                return x;
            }
            x = below.max(0.0);
        }
        x
    }
}

/// The fastest profile from rest to rest. `limits`: velocity and acceleration of each axis.
pub(super) fn fastest(curve: &AxisCurve, limits: &[[f64; 2]], most: &Caps, observer: &dyn Observer) -> Result<Profile> {
    let n = curve.abscissae().len();
    let of_axis = if curve.is_bent() { OF_BENT_AXIS } else { OF_AXIS };
    let of_interval = (of_axis * limits.len()).max(1);
    let mut rows = vec![Strip::WITHOUT_END; (n - 1) * of_interval];
    let rows = rows.chunks_mut(of_interval).enumerate();
    let strips = |(i, rows)| Strips::new(curve, i, limits, most, rows);
    let strips: Vec<Strips> = parallel::map_short(super::PER_THREAD, rows, strips);
    observer.check(Stage::Feed)?;
    // Backwards: the greatest x from which the end can be reached at rest.
    let mut reach = vec![0.0; n];
    for (i, strips) in strips.iter().enumerate().rev() {
        reach[i] = strips.greatest(strips.most_there.min(reach[i + 1]));
    }
    observer.check(Stage::Feed)?;
    // Forwards: as fast as that allows.
    let (mut x, mut u) = (vec![0.0; n], vec![0.0; n - 1]);
    for (i, strips) in strips.iter().enumerate() {
        let most = strips.most_there.min(reach[i + 1]);
        x[i + 1] = (x[i] + 2.0 * strips.length * strips.range(x[i]).high).clamp(0.0, most);
        u[i] = (x[i + 1] - x[i]) / (2.0 * strips.length);
        if x[i].max(x[i + 1]) <= 0.0 {
            return Err(Error::usage(
                Stage::Feed,
                format!("the axes cannot start along the path at location {i}: their positions change too abruptly"),
            ));
        }
    }
    Ok(Profile { x, u })
}
