//! Axis positions over the arc length of ball centres: what the feed is planned on.
//!
//! Without a programmed curve: the natural cubic spline through the positions at the locations.
//! On a programmed curve: in every interval the power series of the axes about its middle, which
//! the machine's kinematics give from those of ball centre and θ ([`Machine::along_series`]), up to
//! the fifth power. What is cut off is `(h/2)⁶ q⁽⁶⁾/720` of a position and `(h/2)³ q⁽⁶⁾/6` of a
//! third derivative, `h` being the interval. A straight move beside the curve takes up its first
//! and second derivatives where they meet, so that acceleration is continuous there too.

use super::PER_THREAD;
use crate::artifact::programmed::Polynomial;
use crate::artifact::{AxisRows, ProgrammedCurve, Schedule, Toolpath};
use crate::machine::Machine;
use crate::numerics::series::{Series, TERMS};
use crate::numerics::spline::CubicSpline;
use crate::parallel;

/// The axes over the parameter `s`, interval by interval.
pub(super) struct AxisCurve {
    spline: CubicSpline,
    /// Where each interval's polynomials of degree 5 begin among `quintics`; empty: all are cubic.
    first: Vec<Option<usize>>,
    /// Coefficients of `1, t, … t⁵`, `t` from the interval's start; axis by axis.
    quintics: Vec<[f64; TERMS]>,
    /// Positions at the locations.
    rows: AxisRows,
}

/// A programmed curve with all that it is one of.
pub(super) struct Programmed<'a> {
    pub curve: &'a ProgrammedCurve,
    pub path: &'a Toolpath,
    pub schedule: &'a Schedule,
    pub machine: &'a Machine,
    pub gauge_length_mm: f64,
}

impl From<CubicSpline> for AxisCurve {
    fn from(spline: CubicSpline) -> Self {
        AxisCurve { spline, first: Vec::new(), quintics: Vec::new(), rows: AxisRows::default() }
    }
}

impl AxisCurve {
    /// `spline` through `rows`, but on the curve where that is. `None` where the linear axes do not
    /// reach all places.
    pub fn on(spline: CubicSpline, rows: AxisRows, programmed: &Programmed) -> Option<Self> {
        let (n, axes) = (spline.intervals(), spline.functions());
        let bent = |i: usize| programmed.polynomial(i).map(|p| programmed.axes(&p, i, &rows));
        let bent: Vec<Option<Option<Vec<[f64; TERMS]>>>> = parallel::map_short(PER_THREAD / 8, 0..n, bent);
        let mut out = AxisCurve { spline, first: vec![None; n], quintics: Vec::new(), rows };
        for (i, found) in bent.into_iter().enumerate() {
            if let Some(found) = found {
                out.first[i] = Some(out.quintics.len());
                out.quintics.extend(found?);
            }
        }
        // Straight moves between a curve and anything else.
        let is_curve: Vec<bool> = out.first.iter().map(Option::is_some).collect();
        for i in (0..n).filter(|i| !is_curve[*i]) {
            let (before, after) = (i > 0 && is_curve[i - 1], i + 1 < n && is_curve[i + 1]);
            if before || after {
                let s = out.spline.abscissae();
                let h = s[i + 1] - s[i];
                let joined: Vec<[f64; TERMS]> = (0..axes)
                    .map(|k| {
                        let from = if before { out.at(i - 1, k, s[i] - s[i - 1]) } else { out.at(i, k, 0.0) };
                        let to = if after { out.at(i + 1, k, 0.0) } else { out.at(i, k, h) };
                        let at = |row: usize, d: [f64; 3]| [out.rows[row][k], d[1], d[2]];
                        hermite(at(i, from), at(i + 1, to), h)
                    })
                    .collect();
                out.first[i] = Some(out.quintics.len());
                out.quintics.extend(joined);
            }
        }
        Some(out)
    }

    /// The abscissae.
    pub fn abscissae(&self) -> &[f64] {
        self.spline.abscissae()
    }

    /// Number of axes.
    pub fn functions(&self) -> usize {
        self.spline.functions()
    }

    /// Some interval is of degree 5.
    pub fn is_bent(&self) -> bool {
        !self.quintics.is_empty()
    }

    /// `[a, b, c, d]` of an axis in an interval of degree 3.
    pub fn cubic(&self, interval: usize, axis: usize) -> [f64; 4] {
        self.spline.coefficients(interval, axis).unwrap_or_default()
    }

    /// Coefficients of an axis in an interval of degree 5; `None`: it is of degree 3.
    pub fn quintic(&self, interval: usize, axis: usize) -> Option<&[f64; TERMS]> {
        let first = (*self.first.get(interval)?)?;
        self.quintics.get(first + axis)
    }

    /// Position, first and second derivative of an axis at `t` from the start of an interval.
    pub fn at(&self, interval: usize, axis: usize, t: f64) -> [f64; 3] {
        if let Some(c) = self.quintic(interval, axis) {
            let d = |order: usize| derivative(c, order, t);
            return [d(0), d(1), d(2)];
        }
        let [a, b, c, d] = self.cubic(interval, axis);
        [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + 3.0 * t * d), 2.0 * c + 6.0 * t * d]
    }

    /// The third derivative there.
    pub fn third(&self, interval: usize, axis: usize, t: f64) -> f64 {
        match self.quintic(interval, axis) {
            Some(c) => derivative(c, 3, t),
            None => 6.0 * self.cubic(interval, axis)[3],
        }
    }

    /// Position of an axis at location `row`, which is at the start of its interval (the last: at
    /// the end).
    pub fn position(&self, row: usize, axis: usize, by_interval: f64) -> f64 {
        self.rows.get(row).map_or(by_interval, |r| r[axis])
    }

    /// How far the series miss the positions at the locations, mm or rad: what they cut off.
    #[cfg(test)]
    pub fn cut_off(&self) -> f64 {
        let s = self.abscissae();
        let mut worst = 0.0f64;
        for i in 0..self.spline.intervals() {
            for k in (0..self.functions()).filter(|k| self.quintic(i, *k).is_some()) {
                worst = worst.max((self.at(i, k, 0.0)[0] - self.rows[i][k]).abs());
                worst = worst.max((self.at(i, k, s[i + 1] - s[i])[0] - self.rows[i + 1][k]).abs());
            }
        }
        worst
    }
}

impl Programmed<'_> {
    fn polynomial(&self, i: usize) -> Option<Polynomial> {
        self.curve.polynomial(self.path, &self.schedule.theta, i)
    }

    /// How fast the ball centre goes by the parameter in each interval, at most.
    pub fn rates(&self) -> Vec<f64> {
        let l = &self.path.locations;
        let of = |i: usize| match self.polynomial(i) {
            Some(p) => p.greatest(1)[0],
            None => (l[i + 1].centre - l[i].centre).norm() / (self.curve.rows[i + 1].s_mm - self.curve.rows[i].s_mm),
        };
        parallel::map_short(PER_THREAD, 0..l.len().saturating_sub(1), of)
    }

    /// Coefficients of all axes in interval `i`.
    fn axes(&self, p: &Polynomial, i: usize, rows: &AxisRows) -> Option<Vec<[f64; TERMS]>> {
        const FACTORIAL: [f64; TERMS] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
        let place = p.at(0.5);
        let centre = std::array::from_fn(|d| Series(std::array::from_fn(|k| place.centre[k][d] / FACTORIAL[k])));
        let theta = Series(std::array::from_fn(|k| place.theta[k] / FACTORIAL[k]));
        let cone = self.path.cone(i);
        let stand = crate::artifact::Stand { centre: place.point(), cone, theta: place.theta[0] };
        let at = self.machine.place(&stand, rows.get(i), self.gauge_length_mm);
        let series = self.machine.along_series(&centre, theta, &cone, &at, self.gauge_length_mm)?;
        Some(series.into_iter().map(|s| shifted(s.0, -0.5 * p.length_mm)).collect())
    }
}

/// The polynomial of `t + by`.
fn shifted(mut c: [f64; TERMS], by: f64) -> [f64; TERMS] {
    for from in 0..TERMS - 1 {
        for k in (from..TERMS - 1).rev() {
            c[k] += by * c[k + 1];
        }
    }
    c
}

/// A derivative of a polynomial.
fn derivative(c: &[f64; TERMS], order: usize, t: f64) -> f64 {
    let factor = |k: usize| (0..order).map(|j| (k - j) as f64).product::<f64>();
    (order..TERMS).rev().fold(0.0, |sum, k| sum * t + factor(k) * c[k])
}

/// Coefficients of the polynomial of degree 5 with given values, first and second derivatives.
fn hermite(from: [f64; 3], to: [f64; 3], h: f64) -> [f64; TERMS] {
    let [p, d, dd] = from;
    // What is missing at the end, over powers of the length.
    let value = (to[0] - p - h * (d + 0.5 * h * dd)) / h.powi(3);
    let slope = (to[1] - d - h * dd) / (h * h);
    let bend = (to[2] - dd) / h;
    [
        p,
        d,
        0.5 * dd,
        10.0 * value - 4.0 * slope + 0.5 * bend,
        (-15.0 * value + 7.0 * slope - bend) / h,
        (6.0 * value - 3.0 * slope + 0.5 * bend) / (h * h),
    ]
}

/// Bernstein coefficients of the derivatives of a polynomial over `[a, a + h]`: of the first, the
/// second and the third.
pub(super) fn bernstein(c: &[f64; TERMS], a: f64, h: f64) -> ([f64; 5], [f64; 4], [f64; 3]) {
    let c = shifted(*c, a);
    (of_derivative(&c, 1, h), of_derivative(&c, 2, h), of_derivative(&c, 3, h))
}

fn of_derivative<const N: usize>(c: &[f64; TERMS], order: usize, h: f64) -> [f64; N] {
    // Powers of the share of the interval.
    let power = |j: usize| {
        let k = j + order;
        (0..order).map(|m| (k - m) as f64).product::<f64>() * c[k] * h.powi(j as i32)
    };
    let degree = N - 1;
    std::array::from_fn(|i| (0..=i).map(|j| choose(i, j) / choose(degree, j) * power(j)).sum())
}

/// Binomial coefficients.
pub(super) fn choose(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, j| c * (n - j) as f64 / (j + 1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn polynomials_are_the_same_in_every_form(
            c in prop::collection::vec(-1.0..1.0f64, 6), a in 0.0..1.0f64, h in 0.1..1.0f64,
        ) {
            let c: [f64; TERMS] = std::array::from_fn(|k| c[k]);
            for t in [0.0, 0.3, 1.0] {
                prop_assert!((derivative(&shifted(c, a), 0, t) - derivative(&c, 0, t + a)).abs() < 1e-12);
            }
            let (q1, q2, q3) = bernstein(&c, a, h);
            for f in [0.0, 0.25, 0.7, 1.0f64] {
                let value = |q: &[f64]| {
                    let n = q.len() - 1;
                    let of = |i: usize| choose(n, i) * f.powi(i as i32) * (1.0 - f).powi((n - i) as i32) * q[i];
                    (0..=n).map(of).sum::<f64>()
                };
                for (order, got) in [(1, value(&q1)), (2, value(&q2)), (3, value(&q3))] {
                    prop_assert!((got - derivative(&c, order, a + f * h)).abs() < 1e-10, "{order}");
                }
            }
            let at = |t: f64| [0, 1, 2].map(|k| derivative(&c, k, t));
            let again = hermite(at(0.0), at(h), h);
            for k in 0..TERMS {
                prop_assert!((again[k] - c[k]).abs() < 1e-12 * 100.0 / h.powi(5), "{k}");
            }
        }
    }
}
