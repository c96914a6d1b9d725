//! Splines of degree 5 with simple knots: four times continuously differentiable.
//!
//! In: rising breaks `s₀ < … < s_n`. A spline on them has `n + 5` control values. On span `i`, from
//! `s_i` to `s_{i+1}`, it is a polynomial of degree 5 that control values `i … i + 5` make. Its
//! *ordinates* on an interval `[a, b]` of the span are the coefficients of the Bernstein basis
//! there: the polynomial lies between the least and the greatest of them. Ordinate `j` is the
//! blossom of the span at `5 − j` times `a` and `j` times `b` (Ramshaw 1989, "Blossoms are polar
//! forms", CAGD 6), which de Boor's recursion computes.

/// Degree of the splines.
pub const DEGREE: usize = 5;
/// Control values of a span.
pub const ORDER: usize = 6;
/// No control value is greater than the greatest value of the spline by more than this factor, on
/// any breaks: `k 2^k` with the order `k` (Scherer and Shadrin 1999, "New upper bound for the
/// B-spline basis condition number II", J. Approx. Theory 99).
pub const CONDITION: f64 = 384.0;
/// Binomial coefficients of the degree.
pub const CHOOSE: [f64; ORDER] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
/// A linear map from the control values of a span to numbers of the same count.
pub type Map = [[f64; ORDER]; ORDER];

/// The breaks of a spline. At either end the knot is sixfold, so that the spline begins in its
/// first control value and ends in its last.
#[derive(Clone, Debug, PartialEq)]
pub struct Breaks(Vec<f64>);

impl Breaks {
    /// `None` where there are fewer than two, or they do not rise, or are not finite.
    pub fn new(breaks: Vec<f64>) -> Option<Self> {
        let rise = breaks.windows(2).all(|w| w[0] < w[1]);
        (breaks.len() >= 2 && rise && breaks.iter().all(|s| s.is_finite())).then_some(Breaks(breaks))
    }

    /// The breaks.
    pub fn all(&self) -> &[f64] {
        &self.0
    }

    /// Number of spans.
    pub fn spans(&self) -> usize {
        self.0.len() - 1
    }

    /// Number of control values.
    pub fn controls(&self) -> usize {
        self.spans() + DEGREE
    }

    /// Ends of a span.
    pub fn span(&self, i: usize) -> [f64; 2] {
        [self.0[i], self.0[i + 1]]
    }

    /// The span that `s` is in, the one before where two meet, the nearest where it is in none.
    pub fn span_of(&self, s: f64) -> usize {
        self.0.partition_point(|b| *b < s).clamp(1, self.spans()) - 1
    }

    /// A part of these breaks, no nearer to one another than `least`, with both ends.
    #[must_use]
    pub fn thinned(&self, least: f64) -> Breaks {
        let end = self.0[self.0.len() - 1];
        let mut out = vec![self.0[0]];
        for s in &self.0[1..self.0.len() - 1] {
            if *s - out[out.len() - 1] >= least && end - *s >= least {
                out.push(*s);
            }
        }
        out.push(end);
        Breaks(out)
    }

    /// Knot `k` of the whole vector, which begins and ends with six equal ones.
    fn knot(&self, k: usize) -> f64 {
        self.0[k.saturating_sub(DEGREE).min(self.0.len() - 1)]
    }

    /// Weights of the control values of span `i` in its blossom at five arguments.
    fn blossom(&self, i: usize, at: [f64; DEGREE]) -> [f64; ORDER] {
        let mut rows: Map = std::array::from_fn(|j| std::array::from_fn(|c| f64::from(j == c)));
        for (r, x) in (1..=DEGREE).zip(at) {
            for j in (r..=DEGREE).rev() {
                let (from, to) = (self.knot(i + j), self.knot(i + j + ORDER - r));
                let share = (x - from) / (to - from);
                for c in 0..ORDER {
                    rows[j][c] = (1.0 - share) * rows[j - 1][c] + share * rows[j][c];
                }
            }
        }
        rows[DEGREE]
    }

    /// From the control values of span `i` to the ordinates on `[a, b]`.
    pub fn ordinates(&self, i: usize, [a, b]: [f64; 2]) -> Map {
        std::array::from_fn(|j| self.blossom(i, std::array::from_fn(|k| if k < DEGREE - j { a } else { b })))
    }

    /// Weights of the control values of span `i` in the value at `s`.
    pub fn weights(&self, i: usize, s: f64) -> [f64; ORDER] {
        self.blossom(i, [s; DEGREE])
    }

    /// Greville's abscissae: with these as control values the spline is `s` itself.
    pub fn greville(&self) -> Vec<f64> {
        (0..self.controls()).map(|k| (1..=DEGREE).map(|j| self.knot(k + j)).sum::<f64>() / DEGREE as f64).collect()
    }
}

/// The sum of the first control values, each times its weight.
pub fn weighed<const D: usize>(controls: &[[f64; D]], weights: &[f64; ORDER]) -> [f64; D] {
    std::array::from_fn(|d| weights.iter().zip(controls).map(|(w, c)| c[d] * w).sum())
}

/// A map applied to the control values of a span.
pub fn apply<const D: usize>(map: &Map, controls: &[[f64; D]]) -> [[f64; D]; ORDER] {
    std::array::from_fn(|j| std::array::from_fn(|d| (0..ORDER).map(|k| map[j][k] * controls[k][d]).sum()))
}

/// Value and first five derivatives by `s` of the polynomial with these ordinates on an interval of
/// that length, at the share `t` of it.
pub fn at<const D: usize>(ordinates: &[[f64; D]; ORDER], length: f64, t: f64) -> [[f64; D]; ORDER] {
    let mut out = [[0.0; D]; ORDER];
    for d in 0..D {
        let mut differences: [f64; ORDER] = std::array::from_fn(|j| ordinates[j][d]);
        let mut factor = 1.0;
        for (k, derivative) in out.iter_mut().enumerate() {
            let degree = DEGREE - k;
            let mut c = differences;
            for r in 0..degree {
                for j in 0..degree - r {
                    c[j] += t * (c[j + 1] - c[j]);
                }
            }
            derivative[d] = factor * c[0];
            for j in 0..degree {
                differences[j] = differences[j + 1] - differences[j];
            }
            factor *= degree as f64 / length;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    fn breaks(steps: &[f64]) -> Breaks {
        let mut s = vec![-3.0];
        steps.iter().for_each(|d| s.push(s[s.len() - 1] + d));
        Breaks::new(s).unwrap()
    }

    proptest! {
        #[test]
        fn ordinates_agree_with_values_and_joints_are_smooth(
            steps in prop::collection::vec(0.2..2.0f64, 1..9),
            values in prop::collection::vec(-1.0..1.0f64, 14), cut in 0.0..0.5f64,
        ) {
            let b = breaks(&steps);
            let controls: Vec<[f64; 1]> = values[..b.controls()].iter().map(|v| [*v]).collect();
            let mut before: Option<[[f64; 1]; ORDER]> = None;
            for i in 0..b.spans() {
                let [s0, s1] = b.span(i);
                let whole = apply(&b.ordinates(i, [s0, s1]), &controls[i..]);
                // A part of the span is the same polynomial.
                let part = [s0 + cut * (s1 - s0), s1];
                let other = apply(&b.ordinates(i, part), &controls[i..]);
                for t in [0.0, 0.3, 1.0] {
                    let s = part[0] + t * (part[1] - part[0]);
                    let (p, q) = (at(&whole, s1 - s0, (s - s0) / (s1 - s0)), at(&other, part[1] - part[0], t));
                    let w = b.weights(i, s);
                    let value: f64 = (0..ORDER).map(|k| w[k] * controls[i + k][0]).sum();
                    prop_assert!((p[0][0] - value).abs() < 1e-12);
                    for k in 0..ORDER {
                        let size = 1.0 + p[k][0].abs() + 1e3 / (part[1] - part[0]).powi(k as i32);
                        prop_assert!((p[k][0] - q[k][0]).abs() < 1e-12 * size, "{k}");
                    }
                }
                let start = at(&whole, s1 - s0, 0.0);
                if let Some(end) = before {
                    for k in 0..5 {
                        prop_assert!((start[k][0] - end[k][0]).abs() < 1e-9 * (1.0 + end[k][0].abs()), "derivative {k}");
                    }
                }
                before = Some(at(&whole, s1 - s0, 1.0));
            }
        }
    }

    #[test]
    fn polynomials_are_met_exactly() {
        let b = breaks(&[1.0, 0.5, 2.0, 0.7]);
        let line = b.greville();
        for i in 0..b.spans() {
            let [s0, s1] = b.span(i);
            let controls: Vec<[f64; 1]> = line.iter().map(|v| [*v]).collect();
            let o = apply(&b.ordinates(i, [s0, s1]), &controls[i..]);
            let d = at(&o, s1 - s0, 0.4);
            assert!((d[0][0] - (s0 + 0.4 * (s1 - s0))).abs() < 1e-13 && (d[1][0] - 1.0).abs() < 1e-12);
        }
        // s⁵ through its blossom: the control values are products of knots.
        let fifth: Vec<[f64; 1]> = (0..b.controls()).map(|k| [(1..=5).map(|j| b.knot(k + j)).product()]).collect();
        let o = apply(&b.ordinates(2, b.span(2)), &fifth[2..]);
        let [s0, s1] = b.span(2);
        let s: f64 = s0 + 0.25 * (s1 - s0);
        let d = at(&o, s1 - s0, 0.25);
        for (k, want) in
            [s.powi(5), 5.0 * s.powi(4), 20.0 * s.powi(3), 60.0 * s * s, 120.0 * s, 120.0].iter().enumerate()
        {
            assert!((d[k][0] - want).abs() < 1e-9, "{k}: {} {want}", d[k][0]);
        }
    }

    #[test]
    fn bad_breaks_are_refused() {
        assert!(Breaks::new(vec![0.0]).is_none() && Breaks::new(vec![0.0, 0.0]).is_none());
        assert!(Breaks::new(vec![0.0, f64::NAN]).is_none() && Breaks::new(vec![]).is_none());
        let b = breaks(&[1.0, 1.0]);
        assert_eq!(
            (b.span_of(-9.0), b.span_of(-3.0), b.span_of(-2.0), b.span_of(-1.5), b.span_of(7.0)),
            (0, 0, 0, 1, 1)
        );
    }
}
