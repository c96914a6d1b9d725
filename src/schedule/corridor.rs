//! The walls between which a schedule runs: two piecewise linear functions of arc length. They
//! never fall where θ is never to turn back.

/// A point of the S–θ plane: arc length from the start of the path (mm) and angle (rad).
pub(super) type PathAngle = [f64; 2];

/// Slope of the straight line from `p` to `q`, rad/mm.
pub(super) fn slope(p: PathAngle, q: PathAngle) -> f64 {
    (q[1] - p[1]) / (q[0] - p[0])
}

/// Walls at strictly increasing `s`, straight between.
#[derive(Clone, Debug)]
pub(super) struct Corridor {
    pub s: Vec<f64>,
    pub lo: Vec<f64>,
    pub hi: Vec<f64>,
    /// θ is never to turn back.
    pub one_way: bool,
}

impl Corridor {
    /// Walls moved inwards by `inset_rad`, but at most by the share `most` (≤ ½) of the width
    /// there.
    ///
    /// Walls that never fall stay so: `min(lo + inset, (1 − most) lo + most hi)` is the lesser of
    /// two functions that never fall, and so is the upper wall's counterpart the greater of two.
    pub fn shrunk(&self, inset_rad: f64, most: f64) -> Corridor {
        let moved = |a: f64, b: f64| inset_rad.min(most * (b - a).max(0.0));
        let lo = self.lo.iter().zip(&self.hi).map(|(a, b)| a + moved(*a, *b)).collect();
        let hi = self.lo.iter().zip(&self.hi).map(|(a, b)| b - moved(*a, *b)).collect();
        Corridor { s: self.s.clone(), lo, hi, one_way: self.one_way }
    }

    /// Walls that were moved inwards, moved back to those that they came from over these lengths at
    /// their ends, mm; `None`: not there.
    pub fn eased(mut self, from: &Corridor, [first, last]: [Option<f64>; 2]) -> Corridor {
        let (Some(s0), Some(s1)) = (self.s.first().copied(), self.s.last().copied()) else { return self };
        for (i, s) in self.s.iter().enumerate() {
            let share = |length: Option<f64>, way: f64| length.map_or(1.0, |l| (way / l).clamp(0.0, 1.0));
            let share = share(first, s - s0).min(share(last, s1 - s));
            self.lo[i] = from.lo[i] + share * (self.lo[i] - from.lo[i]);
            self.hi[i] = from.hi[i] + share * (self.hi[i] - from.hi[i]);
        }
        if !self.one_way {
            return self;
        }
        // Walls never fall.
        (1..self.lo.len()).for_each(|i| self.lo[i] = self.lo[i].max(self.lo[i - 1]));
        (1..self.hi.len()).rev().for_each(|i| self.hi[i - 1] = self.hi[i - 1].min(self.hi[i]));
        self
    }

    /// Lower and upper wall at `s`; beyond the ends as at the ends.
    pub fn at(&self, s: f64) -> [f64; 2] {
        let last = self.s.len() - 1;
        let i = self.s.partition_point(|x| *x <= s).clamp(1, last.max(1)) - 1;
        if last == 0 {
            return [self.lo[0], self.hi[0]];
        }
        let f = ((s - self.s[i]) / (self.s[i + 1] - self.s[i])).clamp(0.0, 1.0);
        // Exact at both ends, so that a wall at a sample is met without rounding.
        let mix = |v: &[f64]| if f == 1.0 { v[i + 1] } else { v[i] + f * (v[i + 1] - v[i]) };
        [mix(&self.lo), mix(&self.hi)]
    }

    /// The walls at other places, in order.
    pub fn at_all(&self, s: &[f64]) -> Corridor {
        let walls: Vec<[f64; 2]> = s.iter().map(|s| self.at(*s)).collect();
        let [lo, hi] = [0, 1].map(|k| walls.iter().map(|w| w[k]).collect());
        Corridor { s: s.to_vec(), lo, hi, one_way: self.one_way }
    }

    /// Indices of the samples strictly between `a` and `b`.
    pub fn inside(&self, a: f64, b: f64) -> std::ops::Range<usize> {
        let first = self.s.partition_point(|x| *x <= a);
        first..self.s.partition_point(|x| *x < b).max(first)
    }

    /// The corridor over `a..b` only, with its walls at both ends interpolated.
    pub fn between(&self, a: f64, b: f64) -> Corridor {
        let r = self.inside(a, b);
        let ([lo_a, hi_a], [lo_b, hi_b]) = (self.at(a), self.at(b));
        let pick = |v: &[f64], x: f64, y: f64| {
            let mut out = Vec::with_capacity(r.len() + 2);
            out.push(x);
            out.extend_from_slice(&v[r.clone()]);
            out.push(y);
            out
        };
        let [s, lo, hi] = [pick(&self.s, a, b), pick(&self.lo, lo_a, lo_b), pick(&self.hi, hi_a, hi_b)];
        Corridor { s, lo, hi, one_way: self.one_way }
    }

    /// Least distance of the straight line `p q` from the lower and from the upper wall; negative:
    /// it passes through.
    pub fn room(&self, p: PathAngle, q: PathAngle) -> [f64; 2] {
        let m = slope(p, q);
        let mut least = [f64::INFINITY; 2];
        let mut take = |s: f64, lo: f64, hi: f64| {
            let v = if s == q[0] { q[1] } else { p[1] + m * (s - p[0]) };
            least = [least[0].min(v - lo), least[1].min(hi - v)];
        };
        for s in [p[0], q[0]] {
            let [lo, hi] = self.at(s);
            take(s, lo, hi);
        }
        for i in self.inside(p[0], q[0]) {
            take(self.s[i], self.lo[i], self.hi[i]);
        }
        least
    }

    /// The straight line that runs from end to end with the greatest distance from the walls, if
    /// there is one.
    ///
    /// `h(m) = max(lo − m s) − min(hi − m s)` is convex in the slope `m`; a line of slope `m`
    /// exists where `h ≤ 0`.
    pub fn straight(&self) -> Option<[PathAngle; 2]> {
        let (s0, s1) = (*self.s.first()?, *self.s.last()?);
        if s1 <= s0 {
            return None;
        }
        let offsets = |m: f64| {
            let mut low = f64::NEG_INFINITY;
            let mut high = f64::INFINITY;
            for ((s, lo), hi) in self.s.iter().zip(&self.lo).zip(&self.hi) {
                low = low.max(lo - m * (s - s0));
                high = high.min(hi - m * (s - s0));
            }
            (low, high)
        };
        let h = |m: f64| {
            let (low, high) = offsets(m);
            low - high
        };
        let (first_hi, last_lo) = (*self.hi.first()?, *self.lo.last()?);
        let (first_lo, last_hi) = (*self.lo.first()?, *self.hi.last()?);
        let length = s1 - s0;
        let least = if self.one_way { 0.0 } else { f64::NEG_INFINITY };
        let (mut a, mut b) = (((last_lo - first_hi) / length).max(least), ((last_hi - first_lo) / length).max(least));
        for _ in 0..100 {
            let (m1, m2) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
            if h(m1) <= h(m2) {
                b = m2;
            } else {
                a = m1;
            }
        }
        let m = 0.5 * (a + b);
        let (low, high) = offsets(m);
        let start = 0.5 * (low + high);
        (low <= high).then_some([[s0, start], [s1, start + m * length]])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn ramp() -> Corridor {
        let s: Vec<f64> = (0..=10).map(f64::from).collect();
        Corridor { lo: s.clone(), hi: s.iter().map(|v| v + 1.0).collect(), s, one_way: true }
    }

    #[test]
    fn walls_interpolate_and_clip() {
        let c = ramp();
        assert_eq!(c.at(2.5), [2.5, 3.5]);
        assert_eq!(c.at(-1.0), [0.0, 1.0]);
        assert_eq!(c.at(11.0), [10.0, 11.0]);
        let d = c.between(0.5, 2.0);
        assert_eq!(d.s, vec![0.5, 1.0, 2.0]);
        assert_eq!(d.hi, vec![1.5, 2.0, 3.0]);
        assert_eq!(c.shrunk(0.6, 0.4).lo[3], 3.4);
        assert_eq!(c.shrunk(0.1, 0.4).hi[3], 3.9);
    }

    #[test]
    fn room_is_the_least_distance_over_the_whole_segment() {
        let c = ramp();
        assert_eq!(c.room([0.0, 0.5], [10.0, 10.5]), [0.5, 0.5]);
        let level = c.room([0.0, 0.75], [1.5, 0.75]);
        assert_eq!(level, [-0.75, 0.25]);
    }

    #[test]
    fn a_ramp_holds_a_straight_line_and_a_step_does_not() {
        let [p, q] = ramp().straight().unwrap();
        assert!((slope(p, q) - 1.0).abs() < 1e-9 && (p[1] - 0.5).abs() < 1e-6);
        let mut c = ramp();
        (6..=10).for_each(|i| {
            c.lo[i] += 3.0;
            c.hi[i] += 3.0;
        });
        assert!(c.straight().is_none());
    }
}
