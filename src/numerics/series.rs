//! Power series that are cut off: a function of a parameter `t` by its first coefficients, from
//! which sums, products, sines and cosines follow exactly up to the last one.

/// Coefficients kept, of `t⁰` to `t⁵`.
pub const TERMS: usize = 6;

/// `c[0] + c[1] t + … + c[5] t⁵ + O(t⁶)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Series(pub [f64; TERMS]);

impl Series {
    /// The same everywhere.
    pub fn constant(value: f64) -> Self {
        let mut out = Series::default();
        out.0[0] = value;
        out
    }

    /// Times a number.
    #[must_use]
    pub fn scaled(self, by: f64) -> Self {
        Series(self.0.map(|c| c * by))
    }

    /// Sine and cosine, by `s' = a' c`, `c' = −a' s`, coefficient by coefficient.
    pub fn sin_cos(self) -> (Self, Self) {
        let a = self.0;
        let (mut s, mut c) = ([0.0; TERMS], [0.0; TERMS]);
        (s[0], c[0]) = a[0].sin_cos();
        for n in 1..TERMS {
            let sum = |of: &[f64; TERMS]| (1..=n).map(|k| k as f64 * a[k] * of[n - k]).sum::<f64>() / n as f64;
            (s[n], c[n]) = (sum(&c), -sum(&s));
        }
        (Series(s), Series(c))
    }
}

impl std::ops::Add for Series {
    type Output = Series;
    fn add(self, other: Series) -> Series {
        Series(std::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl std::ops::Sub for Series {
    type Output = Series;
    fn sub(self, other: Series) -> Series {
        Series(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl std::ops::Mul for Series {
    type Output = Series;
    fn mul(self, other: Series) -> Series {
        Series(std::array::from_fn(|n| (0..=n).map(|k| self.0[k] * other.0[n - k]).sum()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(s: &Series, t: f64) -> f64 {
        s.0.iter().rev().fold(0.0, |sum, c| sum * t + c)
    }

    proptest! {
        #[test]
        fn functions_of_series_are_met_to_the_last_term(
            a in prop::collection::vec(-1.0..1.0f64, 6), b in prop::collection::vec(-1.0..1.0f64, 6),
        ) {
            let of = |v: &[f64]| Series(std::array::from_fn(|k| v[k]));
            let (a, b) = (of(&a), of(&b));
            let (sin, cos) = a.sin_cos();
            for t in [-0.02, 0.01, 0.02f64] {
                let (x, y) = (value(&a, t), value(&b, t));
                for (got, want) in
                    [(a * b, x * y), (a + b, x + y), (a - b, x - y), (sin, x.sin()), (cos, x.cos()), (a.scaled(3.0), 3.0 * x)]
                {
                    prop_assert!((value(&got, t) - want).abs() < 40.0 * t.abs().powi(6) + 1e-14);
                }
            }
        }
    }
}
