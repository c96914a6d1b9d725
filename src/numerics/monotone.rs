//! Cubic curves through points that never leave the range of two neighbours.

/// Slopes at the points: the harmonic mean of those of the two neighbouring chords, 0 where these
/// differ in sign (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984, 300); at the ends that
/// of the chord. A cubic with these stays between the values of its ends. `x` rises strictly.
pub fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let chord: Vec<[f64; 2]> =
        x.windows(2).zip(y.windows(2)).map(|(x, y)| [x[1] - x[0], (y[1] - y[0]) / (x[1] - x[0])]).collect();
    let mean = |w: &[[f64; 2]]| {
        let ([h, a], [k, b]) = (w[0], w[1]);
        if a * b <= 0.0 { 0.0 } else { (h + k) / ((h + 2.0 * k) / 3.0 / a + (2.0 * h + k) / 3.0 / b) }
    };
    let mut out = vec![chord.first().map_or(0.0, |c| c[1])];
    out.extend(chord.windows(2).map(mean));
    if x.len() > 1 {
        out.push(chord.last().map_or(0.0, |c| c[1]));
    }
    out
}

/// A curve through points with those slopes; straight beyond its ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Monotone {
    x: Vec<f64>,
    y: Vec<f64>,
    slopes: Vec<f64>,
}

impl Monotone {
    /// Through points; `None` where there are not two, or `x` does not rise strictly.
    pub fn new(points: &[[f64; 2]]) -> Option<Self> {
        let [x, y] = [0, 1].map(|k| points.iter().map(|p| p[k]).collect::<Vec<f64>>());
        let rises = x.len() > 1 && x.windows(2).all(|w| w[0] < w[1]);
        rises.then(|| Monotone { slopes: slopes(&x, &y), x, y })
    }

    /// The value at a place.
    pub fn at(&self, x: f64) -> f64 {
        let last = self.x.len() - 1;
        if x <= self.x[0] {
            return self.y[0] + (x - self.x[0]) * self.slopes[0];
        }
        if x >= self.x[last] {
            return self.y[last] + (x - self.x[last]) * self.slopes[last];
        }
        let i = self.x.partition_point(|v| *v <= x).clamp(1, last) - 1;
        let h = self.x[i + 1] - self.x[i];
        let [ends, slopes] = [&self.y, &self.slopes].map(|of| [of[i], of[i + 1]]);
        hermite(ends, slopes.map(|slope| slope * h), (x - self.x[i]) / h)
    }
}

/// The value at the share `f` of the way from one value to another, of the cubic with these slopes
/// at its ends, over the whole way.
pub fn hermite([a, b]: [f64; 2], [m0, m1]: [f64; 2], f: f64) -> f64 {
    let g = 1.0 - f;
    a + (b - a) * (f * f * (3.0 - 2.0 * f)) + m0 * (f * g * g) - m1 * (f * f * g)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// It goes through its points, rises where they rise, and has no jumps.
        #[test]
        fn what_rises_stays_rising(steps in prop::collection::vec((0.01f64..2.0, 0.0f64..3.0), 1..12)) {
            let mut at = [0.0; 2];
            let points: Vec<[f64; 2]> = std::iter::once(at).chain(steps.iter().map(|(x, y)| {
                at = [at[0] + x, at[1] + y];
                at
            })).collect();
            let curve = Monotone::new(&points).unwrap();
            prop_assert!(points.iter().all(|[x, y]| (curve.at(*x) - y).abs() < 1e-12));
            let (from, to) = (-1.0, at[0] + 1.0);
            let values: Vec<f64> = (0..=4000).map(|k| curve.at(from + (to - from) * f64::from(k) / 4000.0)).collect();
            prop_assert!(values.windows(2).all(|w| w[1] >= w[0] - 1e-12));
        }
    }

    #[test]
    fn a_line_is_a_line_and_places_must_rise() {
        let line = Monotone::new(&[[0.0, 1.0], [0.5, 2.0], [3.0, 7.0]]).unwrap();
        assert!((-4..9).all(|k| (line.at(f64::from(k)) - 1.0 - 2.0 * f64::from(k)).abs() < 1e-12));
        assert!(Monotone::new(&[[0.0, 1.0]]).is_none() && Monotone::new(&[[1.0, 1.0], [1.0, 2.0]]).is_none());
    }
}
