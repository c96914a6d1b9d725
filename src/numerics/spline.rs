//! Cubic splines through given values: twice continuously differentiable, of one or several
//! functions at once.
//!
//! In: strictly increasing abscissae and, at each, the values of `functions` functions. Out: on
//! every interval `f(x) = a + b t + c t² + d t³`, `t = x − x_i`. The slopes at the abscissae solve
//! a tridiagonal system (de Boor, *A Practical Guide to Splines*, ch. IV); periodic ends make it
//! cyclic. Guaranteed: C² inside, values met to rounding, linear time and memory. Not guaranteed:
//! monotonicity.

use super::banded::solve_cyclic_tridiagonal;

/// What holds at the ends of a spline.
#[derive(Clone, Debug, PartialEq)]
pub enum SplineEnds {
    /// Second derivative zero.
    Natural,
    /// Given first derivatives, one for each function.
    Clamped {
        /// At the first abscissa.
        start: Vec<f64>,
        /// At the last abscissa.
        end: Vec<f64>,
    },
    /// The last abscissa is the first one again, one period on: value, first and second derivative
    /// agree. The last values must equal the first.
    Periodic,
}

/// Why there is no spline.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SplineError {
    /// Fewer than two abscissae, or no function.
    #[error("a spline needs at least 2 abscissae and 1 function, got {abscissae} and {functions}")]
    TooFew {
        /// Abscissae given.
        abscissae: usize,
        /// Functions given.
        functions: usize,
    },
    /// Lengths do not fit together.
    #[error("{what}: expected {expected} numbers, got {got}")]
    Length {
        /// Which array.
        what: &'static str,
        /// Its right length.
        expected: usize,
        /// The length given.
        got: usize,
    },
    /// The abscissae do not increase, or a number is not finite.
    #[error("abscissa {index} ({x}) is not finite or not greater than the one before it")]
    NotIncreasing {
        /// Which.
        index: usize,
        /// Its value.
        x: f64,
    },
    /// A value or slope is not finite.
    #[error("value {index} is not finite")]
    NotFinite {
        /// Index into the array of values.
        index: usize,
    },
    /// A periodic spline whose last values differ from its first.
    #[error("function {function} of a periodic spline ends at {end}, not where it starts, {start}")]
    NotPeriodic {
        /// Which function.
        function: usize,
        /// Its first value.
        start: f64,
        /// Its last value.
        end: f64,
    },
    /// The slopes' system could not be solved: intervals of too different length.
    #[error("the intervals of the spline differ too much in length to find its slopes")]
    Singular,
}

/// A cubic spline of one or several functions.
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline {
    x: Vec<f64>,
    functions: usize,
    /// `[a, b, c, d]` of interval `i`, function `k` at `i * functions + k`.
    coefficients: Vec<[f64; 4]>,
    periodic: bool,
}

impl CubicSpline {
    /// The spline through `values` (`x.len() × functions`, row by row: function `k` at abscissa `i`
    /// is `values[i * functions + k]`).
    ///
    /// ```
    /// use bladewright::numerics::spline::{CubicSpline, Ends};
    /// let s = CubicSpline::new(&[0.0, 1.0, 3.0], &[0.0, 2.0, 6.0], 1, &Ends::Natural)?;
    /// assert!((s.value(2.0, 0) - 4.0).abs() < 1e-14);
    /// # Ok::<(), bladewright::numerics::spline::SplineError>(())
    /// ```
    pub fn new(x: &[f64], values: &[f64], functions: usize, ends: &SplineEnds) -> Result<Self, SplineError> {
        validate(x, values, functions, ends)?;
        let slopes = slopes(x, values, functions, ends).ok_or(SplineError::Singular)?;
        if slopes.iter().any(|s| !s.is_finite()) {
            return Err(SplineError::Singular);
        }
        let f = functions;
        let mut coefficients = Vec::with_capacity((x.len() - 1) * f);
        for (i, w) in x.windows(2).enumerate() {
            let h = w[1] - w[0];
            for k in 0..f {
                let (p, q) = (values[i * f + k], values[(i + 1) * f + k]);
                let (m, n) = (slopes[i * f + k], slopes[(i + 1) * f + k]);
                let d = (q - p) / h;
                coefficients.push([p, m, (3.0 * d - 2.0 * m - n) / h, (m + n - 2.0 * d) / (h * h)]);
            }
        }
        Ok(CubicSpline { x: x.to_vec(), functions, coefficients, periodic: *ends == SplineEnds::Periodic })
    }

    /// The abscissae.
    pub fn abscissae(&self) -> &[f64] {
        &self.x
    }

    /// Number of functions.
    pub fn functions(&self) -> usize {
        self.functions
    }

    /// Number of intervals.
    pub fn intervals(&self) -> usize {
        self.x.len() - 1
    }

    /// `[a, b, c, d]` of `a + b t + c t² + d t³`, `t = x − abscissae[interval]`; `None` outside the
    /// spline.
    pub fn coefficients(&self, interval: usize, function: usize) -> Option<[f64; 4]> {
        if function >= self.functions {
            return None;
        }
        self.coefficients.get(interval * self.functions + function).copied()
    }

    /// The interval that holds `x`: the first or last one outside the abscissae.
    pub fn interval(&self, x: f64) -> usize {
        self.x.partition_point(|&a| a <= x).clamp(1, self.x.len() - 1) - 1
    }

    /// Value, first and second derivative of one function (zeros for a function that does not
    /// exist). Outside the abscissae the end piece goes on; a periodic spline repeats.
    pub fn derivatives(&self, x: f64, function: usize) -> [f64; 3] {
        let first = self.x[0];
        let period = self.x[self.x.len() - 1] - first;
        let x = if self.periodic { first + (x - first).rem_euclid(period) } else { x };
        let i = self.interval(x);
        let t = x - self.x[i];
        let [a, b, c, d] = self.coefficients(i, function).unwrap_or_default();
        [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + 3.0 * t * d), 2.0 * c + 6.0 * t * d]
    }

    /// Value of one function; see [`CubicSpline::derivatives`].
    pub fn value(&self, x: f64, function: usize) -> f64 {
        self.derivatives(x, function)[0]
    }
}

fn validate(x: &[f64], values: &[f64], functions: usize, ends: &SplineEnds) -> Result<(), SplineError> {
    if x.len() < 2 || functions == 0 {
        return Err(SplineError::TooFew { abscissae: x.len(), functions });
    }
    let length = |what, expected, got| {
        if expected == got { Ok(()) } else { Err(SplineError::Length { what, expected, got }) }
    };
    length("values", x.len() * functions, values.len())?;
    for (i, &a) in x.iter().enumerate() {
        if !a.is_finite() || (i > 0 && a <= x[i - 1]) {
            return Err(SplineError::NotIncreasing { index: i, x: a });
        }
    }
    if let Some(index) = values.iter().position(|v| !v.is_finite()) {
        return Err(SplineError::NotFinite { index });
    }
    match ends {
        SplineEnds::Natural => {}
        SplineEnds::Clamped { start, end } => {
            length("start slopes", functions, start.len())?;
            length("end slopes", functions, end.len())?;
            if let Some(index) = start.iter().chain(end).position(|v| !v.is_finite()) {
                return Err(SplineError::NotFinite { index });
            }
        }
        SplineEnds::Periodic => {
            for function in 0..functions {
                let (start, end) = (values[function], values[(x.len() - 1) * functions + function]);
                if (start - end).abs() > 1e-9 * (1.0 + start.abs()) {
                    return Err(SplineError::NotPeriodic { function, start, end });
                }
            }
        }
    }
    Ok(())
}

/// Slopes at all abscissae, row by row. Continuity of the second derivative at abscissa `i`, with
/// `h` the lengths and `d` the divided differences:
/// `m[i-1]/h[i-1] + 2 (1/h[i-1] + 1/h[i]) m[i] + m[i+1]/h[i] = 3 (d[i-1]/h[i-1] + d[i]/h[i])`.
fn slopes(x: &[f64], values: &[f64], f: usize, ends: &SplineEnds) -> Option<Vec<f64>> {
    let n = x.len();
    let g: Vec<f64> = x.windows(2).map(|w| 1.0 / (w[1] - w[0])).collect();
    let d = |i: usize, k: usize| (values[(i + 1) * f + k] - values[i * f + k]) * g[i];
    if *ends == SplineEnds::Periodic {
        let m = n - 1;
        let before = |i: usize| (i + m - 1) % m;
        let lower: Vec<f64> = (0..m).map(|i| g[before(i)]).collect();
        let diagonal: Vec<f64> = (0..m).map(|i| 2.0 * (g[before(i)] + g[i])).collect();
        let mut s: Vec<f64> = (0..m * f)
            .map(|j| (j / f, j % f))
            .map(|(i, k)| 3.0 * (d(before(i), k) * g[before(i)] + d(i, k) * g[i]))
            .collect();
        solve_cyclic_tridiagonal(&lower, &diagonal, &g, &mut s, f)?;
        let first = s[..f].to_vec();
        s.extend(first);
        return Some(s);
    }
    // The diagonal is twice the sum of the others in its row, so elimination needs no row
    // exchanges.
    let mut above = Vec::with_capacity(n);
    let mut s = vec![0.0; n * f];
    let given = |at: &[f64], k: usize| at.get(k).copied().unwrap_or_default();
    for i in 0..n {
        let (before, after) = (i.checked_sub(1), (i + 1 < n).then_some(i));
        let [g0, g1] = [before, after].map(|i| i.map_or(0.0, |i| g[i]));
        let (lower, diagonal, upper) = match ends {
            SplineEnds::Clamped { .. } if i == 0 || i + 1 == n => (0.0, g0 + g1, 0.0),
            _ => (g0, 2.0 * (g0 + g1), g1),
        };
        let w = 1.0 / (diagonal - lower * above.last().copied().unwrap_or(0.0));
        above.push(upper * w);
        for k in 0..f {
            let right = match ends {
                SplineEnds::Clamped { start, .. } if i == 0 => given(start, k) * g1,
                SplineEnds::Clamped { end, .. } if i + 1 == n => given(end, k) * g0,
                _ => 3.0 * [before, after].into_iter().flatten().map(|i| d(i, k) * g[i]).sum::<f64>(),
            };
            let carried = if i > 0 { lower * s[(i - 1) * f + k] } else { 0.0 };
            s[i * f + k] = (right - carried) * w;
        }
    }
    for i in (0..n - 1).rev() {
        for k in 0..f {
            s[i * f + k] -= above[i] * s[(i + 1) * f + k];
        }
    }
    Some(s)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn clamped_reproduces_a_cubic() {
        let f = |x: f64| 1.0 - 2.0 * x + 0.5 * x * x - 0.25 * x.powi(3);
        let df = |x: f64| -2.0 + x - 0.75 * x * x;
        let x = [-1.0, 0.2, 0.3, 2.0, 5.0];
        let v: Vec<f64> = x.iter().flat_map(|&x| [f(x), -f(x)]).collect();
        let ends = SplineEnds::Clamped { start: vec![df(-1.0), -df(-1.0)], end: vec![df(5.0), -df(5.0)] };
        let s = CubicSpline::new(&x, &v, 2, &ends).unwrap();
        for i in 0..=60 {
            let t = -1.0 + 0.1 * i as f64;
            let [y, dy, ddy] = s.derivatives(t, 0);
            assert!((y - f(t)).abs() < 1e-12 && (dy - df(t)).abs() < 1e-12 && (ddy - (1.0 - 1.5 * t)).abs() < 1e-11);
            assert!((s.value(t, 1) + f(t)).abs() < 1e-12);
        }
    }

    #[test]
    fn periodic_sine_converges_with_the_fourth_power() {
        let error = |n: usize| {
            let x: Vec<f64> = (0..=n).map(|i| std::f64::consts::TAU * i as f64 / n as f64).collect();
            let mut v: Vec<f64> = x.iter().map(|x| x.sin()).collect();
            v[n] = v[0];
            let s = CubicSpline::new(&x, &v, 1, &SplineEnds::Periodic).unwrap();
            (0..1000).map(|i| 0.02 * i as f64 - 5.0).map(|t| (s.value(t, 0) - t.sin()).abs()).fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(16), error(32));
        assert!(coarse < 3e-4 && (coarse / fine - 16.0).abs() < 2.0, "{coarse} {fine}");
    }

    #[test]
    fn what_cannot_be_a_spline_is_refused() {
        let new = |x: &[f64], v: &[f64], e: SplineEnds| CubicSpline::new(x, v, 1, &e).unwrap_err();
        assert!(matches!(new(&[0.0], &[1.0], SplineEnds::Natural), SplineError::TooFew { .. }));
        assert!(matches!(
            new(&[0.0, 0.0], &[1.0, 2.0], SplineEnds::Natural),
            SplineError::NotIncreasing { index: 1, .. }
        ));
        assert!(matches!(new(&[0.0, 1.0], &[1.0, f64::NAN], SplineEnds::Natural), SplineError::NotFinite { index: 1 }));
        assert!(matches!(new(&[0.0, 1.0], &[1.0, 2.0], SplineEnds::Periodic), SplineError::NotPeriodic { .. }));
        let short = SplineEnds::Clamped { start: vec![], end: vec![0.0] };
        assert!(matches!(new(&[0.0, 1.0], &[1.0, 2.0], short), SplineError::Length { .. }));
    }

    proptest! {
        #[test]
        fn is_twice_continuous_and_meets_its_values(
            steps in prop::collection::vec(0.1..3.0f64, 2..20), values in prop::collection::vec(-5.0..5.0f64, 21), periodic: bool,
        ) {
            let mut x = vec![0.0];
            for h in &steps { x.push(x[x.len() - 1] + h); }
            let n = x.len();
            let mut v = values[..n].to_vec();
            if periodic { v[n - 1] = v[0]; }
            let s = CubicSpline::new(&x, &v, 1, &if periodic { SplineEnds::Periodic } else { SplineEnds::Natural }).unwrap();
            let at = |i: usize, t: f64| {
                let [a, b, c, d] = s.coefficients(i, 0).unwrap();
                [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + 3.0 * t * d), 2.0 * c + 6.0 * t * d]
            };
            for i in 0..n - 1 {
                let end = at(i, steps[i]);
                prop_assert!((end[0] - v[i + 1]).abs() < 1e-10);
                if i + 2 < n || periodic {
                    let next = at((i + 1) % (n - 1), 0.0);
                    for k in 0..3 { prop_assert!((end[k] - next[k]).abs() < 1e-7 * (1.0 + next[k].abs())); }
                } else {
                    prop_assert!(end[2].abs() < 1e-7 && at(0, 0.0)[2].abs() < 1e-9);
                }
            }
        }
    }
}
