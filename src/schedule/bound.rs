//! Lower bounds that hold for every schedule, proved by a weight function.
//!
//! For any weight `y(s)`, straight between the samples and zero at both ends, and any θ with a
//! second derivative, `∫ y θ'' ds = Σ c θ(s)`, a sum over the samples with `c` the divided second
//! differences of `y` times lengths. Whatever θ is, it is between the walls at the samples, and
//! never falls where it is not to turn back. So the sum is at least its least value over all such
//! values: a linear problem whose exact solution takes one pass (`least_sum`). Hence
//!
//! ```text
//! max |θ''|   ≥ least Σ c θ / ∫ |y|                  ∫ θ''²  ≥ 2 least Σ c θ − ∫ y²
//! max |θ'''|  ≥ least Σ c θ / ∫ |Y|,  Y' = −y        ∫ θ'''² ≥ 2 least Σ c θ − ∫ Y²
//! ```
//!
//! whatever `y` is; a solver's multipliers only choose it well. The proof needs no trust in the
//! solver.

use std::collections::VecDeque;

use super::corridor::Corridor;
use crate::artifact::schedule::Measure;

/// The bound that the weight `y` at the samples proves. The ends of `y` are taken as zero. Not
/// negative.
pub(super) fn prove(measure: Measure, walls: &Corridor, y: &[f64]) -> f64 {
    let n = walls.s.len();
    if n < 3 || y.len() != n || !y.iter().all(|v| v.is_finite()) {
        return 0.0;
    }
    let third = matches!(measure, Measure::PeakThird | Measure::SquareThird);
    let mut y = y.to_vec();
    (y[0], y[n - 1]) = (0.0, 0.0);
    if third {
        balance(&walls.s, &mut y);
    }
    let size = if third { of_integral(&walls.s, &y) } else { of_straight(&walls.s, &y) };
    let least = least_sum(walls, &weights(&walls.s, &y));
    let bound = match measure {
        Measure::PeakSecond | Measure::PeakThird => least / size[0],
        // The best multiple of the weight.
        Measure::SquareSecond | Measure::SquareThird => least.max(0.0) * (least / size[1]),
    };
    if bound.is_finite() { bound.max(0.0) } else { 0.0 }
}

/// The weight that is `y` where θ is within `near_rad` of a wall, 0 at both ends, and straight
/// between: elsewhere the weight of the best schedule does not bend, and what a solver leaves of
/// bends there costs as much as the channel is wide.
pub(super) fn at_walls(walls: &Corridor, theta: &[f64], y: &[f64], near_rad: f64) -> Vec<f64> {
    let n = walls.s.len().min(theta.len()).min(y.len());
    let is_end = |i: usize| i == 0 || i + 1 == n;
    let touches = |i: usize| (theta[i] - walls.lo[i]).min(walls.hi[i] - theta[i]) <= near_rad;
    let kept: Vec<usize> = (0..n).filter(|i| is_end(*i) || touches(*i)).collect();
    let at = |i: usize| if is_end(i) { 0.0 } else { y[i] };
    let mut out: Vec<f64> = (0..n).map(at).collect();
    for pair in kept.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        for i in a + 1..b {
            let share = (walls.s[i] - walls.s[a]) / (walls.s[b] - walls.s[a]);
            out[i] = at(a) + share * (at(b) - at(a));
        }
    }
    out
}

/// `c` of the module's page.
fn weights(s: &[f64], y: &[f64]) -> Vec<f64> {
    let slope: Vec<f64> = s.windows(2).zip(y.windows(2)).map(|(s, y)| (y[1] - y[0]) / (s[1] - s[0])).collect();
    let mut out = vec![0.0; s.len()];
    for (i, m) in slope.iter().enumerate() {
        out[i] += m;
        out[i + 1] -= m;
    }
    // ∫ y θ'' = −∫ y' θ' = Σ over intervals of −slope (θ(next) − θ): the signs above.
    out
}

/// `∫ |y|` and `∫ y²` of a function that is straight between samples.
fn of_straight(s: &[f64], y: &[f64]) -> [f64; 2] {
    let mut out = [0.0; 2];
    for (s, y) in s.windows(2).zip(y.windows(2)) {
        let (h, a, b) = (s[1] - s[0], y[0], y[1]);
        let crosses = a * b < 0.0;
        out[0] += if crosses { 0.5 * h * (a * a + b * b) / (a.abs() + b.abs()) } else { 0.5 * h * (a + b).abs() };
        out[1] += h * (a * a + a * b + b * b) / 3.0;
    }
    out
}

/// Upper bounds of `∫ |Y|` and `∫ Y²`, `Y = −∫ y`: by the Bernstein coefficients of the parabolas.
fn of_integral(s: &[f64], y: &[f64]) -> [f64; 2] {
    let (mut out, mut at) = ([0.0; 2], 0.0);
    for (s, y) in s.windows(2).zip(y.windows(2)) {
        let h = s[1] - s[0];
        let b: [f64; 3] = [at, at - 0.5 * h * y[0], at - 0.5 * h * (y[0] + y[1])];
        out[0] += h / 3.0 * b.iter().map(|v| v.abs()).sum::<f64>();
        out[1] += h / 3.0 * b.iter().map(|v| v * v).sum::<f64>();
        at = b[2];
    }
    out
}

/// Takes a multiple of a hat over the whole from `y` so that its integral is zero.
fn balance(s: &[f64], y: &mut [f64]) {
    let n = s.len();
    let length = s[n - 1] - s[0];
    let hat = |v: f64| ((v - s[0]) / length).min((s[n - 1] - v) / length);
    let integral = |f: &dyn Fn(usize) -> f64| (1..n).map(|i| 0.5 * (s[i] - s[i - 1]) * (f(i) + f(i - 1))).sum::<f64>();
    let share = integral(&|i| y[i]) / integral(&|i| hat(s[i]));
    for i in 0..n {
        y[i] -= share * hat(s[i]);
    }
}

/// The least `Σ c θ` over values between the walls.
fn least_sum(walls: &Corridor, c: &[f64]) -> f64 {
    if walls.one_way { least_rising_sum(walls, c) } else { least_free_sum(walls, c) }
}

/// The same where values may fall: each takes the wall that its weight asks for.
fn least_free_sum(walls: &Corridor, c: &[f64]) -> f64 {
    let n = walls.s.len();
    let m = (walls.lo[n - 1] - walls.lo[0]) / (walls.s[n - 1] - walls.s[0]);
    // The sums of c and of c s are 0: relative to a straight line they lose fewer digits.
    let off = |i: usize, wall: &[f64]| wall[i] - walls.lo[0] - m * (walls.s[i] - walls.s[0]);
    (0..n).map(|i| (c[i] * off(i, &walls.lo)).min(c[i] * off(i, &walls.hi))).sum()
}

/// The least `Σ c θ` over values that never fall and are between the walls (which never fall
/// themselves; `Σ c = 0` and `Σ c s = 0`, so a straight line may be taken from θ to keep the sums
/// small). Exact: the least sum up to a sample, as a function of the greatest value allowed there,
/// is convex, falls, and is kept as its slopes between corners; every corner enters once at the
/// upper wall and leaves once at either side.
fn least_rising_sum(walls: &Corridor, c: &[f64]) -> f64 {
    let n = walls.s.len();
    let m = (walls.lo[n - 1] - walls.lo[0]) / (walls.s[n - 1] - walls.s[0]);
    let line = |i: usize| walls.lo[0] + m * (walls.s[i] - walls.s[0]);
    // Value at the lower wall, slope there, and corners (place, rise of the slope) to the right;
    // the last slope is 0.
    let (mut value, mut slope) = (0.0, 0.0);
    let mut corners: VecDeque<[f64; 2]> = VecDeque::new();
    let mut low = walls.lo[0];
    for i in 0..n {
        let (next, high) = (walls.lo[i], walls.hi[i]);
        while let Some(&[place, rise]) = corners.front() {
            if place > next {
                break;
            }
            value += slope * (place - low);
            (low, slope) = (place, slope + rise);
            corners.pop_front();
        }
        value += if corners.is_empty() { 0.0 } else { slope * (next - low) };
        low = next;
        if corners.is_empty() {
            slope = 0.0;
        }
        value += c[i] * (low - line(i));
        slope += c[i];
        let mut last = c[i];
        // The slope after the last corner is now c: beyond the upper wall it must be 0, and nowhere
        // above 0.
        if last < 0.0 {
            corners.push_back([high, -last]);
        } else {
            while last > 0.0 {
                match corners.pop_back() {
                    None => {
                        slope = 0.0;
                        break;
                    }
                    Some([place, rise]) if last - rise < 0.0 => {
                        corners.push_back([place, rise - last]);
                        break;
                    }
                    Some([_, rise]) => last -= rise,
                }
            }
        }
    }
    let mut at = low;
    for [place, rise] in corners {
        value += slope * (place - at);
        (at, slope) = (place, slope + rise);
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        #[test]
        fn the_least_sum_is_that_of_dynamic_programming(
            steps in prop::collection::vec((0u8..4, 0u8..4, -3i8..4), 2..12), width in 0u8..6,
        ) {
            // Whole numbers: the least is at whole numbers, so trying all of them is exact.
            let (mut lo, mut hi) = (0i32, i32::from(width));
            let mut walls = Corridor { s: vec![], lo: vec![], hi: vec![], one_way: true };
            let mut c = Vec::new();
            for (k, (a, b, w)) in steps.iter().enumerate() {
                lo += i32::from(*a);
                hi = (hi + i32::from(*b)).max(lo);
                walls.s.push(k as f64);
                walls.lo.push(f64::from(lo));
                walls.hi.push(f64::from(hi));
                c.push(f64::from(*w));
            }
            let top = hi as usize;
            let mut best = vec![0.0f64; top + 1];
            for k in 0..c.len() {
                let mut next = vec![f64::INFINITY; top + 1];
                for x in walls.lo[k] as usize..=walls.hi[k] as usize {
                    let before = best[..=x].iter().fold(f64::INFINITY, |m, v| m.min(*v));
                    next[x] = before + c[k] * x as f64;
                }
                best = next;
            }
            let want = best.iter().fold(f64::INFINITY, |m, v| m.min(*v));
            let n = c.len() - 1;
            let m = (walls.lo[n] - walls.lo[0]) / (walls.s[n] - walls.s[0]);
            let line: f64 = (0..=n).map(|k| c[k] * (walls.lo[0] + m * walls.s[k])).sum();
            prop_assert!((least_sum(&walls, &c) + line - want).abs() < 1e-9, "{} {want}", least_sum(&walls, &c) + line);
        }
    }

    #[test]
    fn a_parabola_between_tight_walls_proves_its_own_second_derivative() {
        let s: Vec<f64> = (0..=100).map(f64::from).collect();
        let theta: Vec<f64> = s.iter().map(|s| 0.001 * s * s).collect();
        let walls = Corridor {
            lo: theta.iter().map(|t| t - 1e-6).collect(),
            hi: theta.iter().map(|t| t + 1e-6).collect(),
            s,
            one_way: true,
        };
        let y: Vec<f64> = (0..=100).map(|i| f64::from(i.min(100 - i))).collect();
        let peak = prove(Measure::PeakSecond, &walls, &y);
        assert!(peak <= 0.002 && peak > 0.00199, "{peak}");
        let square = prove(Measure::SquareSecond, &walls, &vec![1.0; 101]);
        assert!(square <= 0.002 * 0.002 * 100.0 && square > 0.98 * 0.0004, "{square}");
        // A cubic for the third derivative: θ''' = 6e-5 on 0..100.
        let theta: Vec<f64> = walls.s.iter().map(|s| 1e-5 * s * s * s).collect();
        let tight = Corridor {
            lo: theta.iter().map(|t| t - 1e-6).collect(),
            hi: theta.iter().map(|t| t + 1e-6).collect(),
            s: walls.s,
            one_way: true,
        };
        let y: Vec<f64> = (0..=100).map(|i| (f64::from(i) * 0.0628318).sin()).map(|v| -v).collect();
        let third = prove(Measure::PeakThird, &tight, &y).max(prove(
            Measure::PeakThird,
            &tight,
            &y.iter().map(|v| -v).collect::<Vec<_>>(),
        ));
        assert!(third <= 6e-5 * (1.0 + 1e-9) && third > 5.8e-5, "{third}");
        let square = prove(Measure::SquareThird, &tight, &y).max(prove(
            Measure::SquareThird,
            &tight,
            &y.iter().map(|v| -v).collect::<Vec<_>>(),
        ));
        assert!(square <= 36e-10 * 100.0 && square > 0.3 * 36e-8, "{square}");
    }
}
