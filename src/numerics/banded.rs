//! Linear systems whose matrix is zero but for a narrow band round the diagonal, in linear time.
//!
//! In: the entries of the band and one or more right-hand sides. Out: the solutions.
//! [`BandedMatrix::factor`] is Gaussian elimination with row exchanges inside the band (Golub and
//! Van Loan, *Matrix Computations*, §4.3): cost `n · lower · (lower + upper)`.
//! [`solve_cyclic_tridiagonal`] adds the two corner entries of a periodic problem by the
//! Sherman–Morrison formula. A matrix that is singular to working precision gives `None`.

/// A square matrix with `lower` diagonals below the main one and `upper` above it.
#[derive(Clone, Debug)]
pub struct BandedMatrix {
    n: usize,
    lower: usize,
    upper: usize,
    /// Row by row, `2 lower + upper + 1` each: column `j` of row `i` is at `j + lower - i`; the
    /// last `lower` entries of a row take what the row exchanges bring in.
    band: Vec<f64>,
}

impl BandedMatrix {
    /// The zero matrix of `n` rows.
    pub fn new(n: usize, lower: usize, upper: usize) -> Self {
        BandedMatrix { n, lower, upper, band: vec![0.0; n * (2 * lower + upper + 1)] }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.n
    }

    fn width(&self) -> usize {
        2 * self.lower + self.upper + 1
    }

    /// Position of an entry, `None` outside the band.
    fn at(&self, row: usize, column: usize) -> Option<usize> {
        let inside = row < self.n && column < self.n && column + self.lower >= row && column <= row + self.upper;
        inside.then(|| row * self.width() + column + self.lower - row)
    }

    /// Adds to one entry. Returns false, and changes nothing, where the entry is outside the band.
    pub fn add(&mut self, row: usize, column: usize, value: f64) -> bool {
        match self.at(row, column) {
            Some(k) => {
                self.band[k] += value;
                true
            }
            None => false,
        }
    }

    /// One entry; zero outside the band.
    pub fn get(&self, row: usize, column: usize) -> f64 {
        self.at(row, column).map_or(0.0, |k| self.band[k])
    }

    /// LU decomposition with row exchanges; `None` if the matrix is singular or has an entry that
    /// is not finite.
    pub fn factor(mut self) -> Option<BandedLu> {
        let (n, lower, width) = (self.n, self.lower, self.width());
        let scale = self.band.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if !self.band.iter().all(|x| x.is_finite()) {
            return None;
        }
        let mut pivot = vec![0; n];
        let mut multipliers = vec![0.0; n * lower];
        for k in 0..n {
            let last = (k + lower).min(n.saturating_sub(1));
            let entry = |band: &[f64], row: usize| band[row * width + k + lower - row];
            let best =
                (k..=last).fold(k, |b, i| if entry(&self.band, i).abs() > entry(&self.band, b).abs() { i } else { b });
            if entry(&self.band, best).abs() <= scale * f64::EPSILON * 1e-3 {
                return None;
            }
            pivot[k] = best;
            let columns = k..(k + lower + self.upper + 1).min(n);
            for j in columns.clone() {
                if best != k {
                    self.band.swap(k * width + j + lower - k, best * width + j + lower - best);
                }
            }
            let diagonal = entry(&self.band, k);
            for i in k + 1..=last {
                let m = entry(&self.band, i) / diagonal;
                multipliers[k * lower + i - k - 1] = m;
                for j in columns.clone() {
                    self.band[i * width + j + lower - i] -= m * self.band[k * width + j + lower - k];
                }
            }
        }
        Some(BandedLu { n, lower, upper: self.upper, band: self.band, multipliers, pivot })
    }
}

/// The factors of a [`BandedMatrix`].
#[derive(Clone, Debug)]
pub struct BandedLu {
    n: usize,
    lower: usize,
    upper: usize,
    band: Vec<f64>,
    multipliers: Vec<f64>,
    pivot: Vec<usize>,
}

impl BandedLu {
    /// Replaces `rhs` by the solution. `rhs` holds `columns` right-hand sides, row by row: entry
    /// `(i, c)` at `i * columns + c`. Does nothing if its length is not `rows × columns`.
    pub fn solve(&self, rhs: &mut [f64], columns: usize) {
        let (n, lower) = (self.n, self.lower);
        if rhs.len() != n * columns {
            return;
        }
        for k in 0..n {
            if self.pivot[k] != k {
                for c in 0..columns {
                    rhs.swap(k * columns + c, self.pivot[k] * columns + c);
                }
            }
            for i in k + 1..=(k + lower).min(n - 1) {
                let m = self.multipliers[k * lower + i - k - 1];
                for c in 0..columns {
                    rhs[i * columns + c] -= m * rhs[k * columns + c];
                }
            }
        }
        let width = 2 * lower + self.upper + 1;
        for i in (0..n).rev() {
            for c in 0..columns {
                let mut x = rhs[i * columns + c];
                for j in i + 1..(i + lower + self.upper + 1).min(n) {
                    x -= self.band[i * width + j + lower - i] * rhs[j * columns + c];
                }
                rhs[i * columns + c] = x / self.band[i * width + lower];
            }
        }
    }
}

/// Solves `lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = rhs[i]` with indices taken round
/// the circle; `rhs` holds `columns` right-hand sides row by row and receives the solutions. `None`
/// if the lengths differ or the matrix is singular.
///
/// ```
/// use bladewright::numerics::banded::solve_cyclic_tridiagonal;
/// let mut x = vec![4.0, 7.0, 7.0]; // 2 x[i] + x[i+1] of x = (1, 2, 3)
/// solve_cyclic_tridiagonal(&[0.0; 3], &[2.0; 3], &[1.0; 3], &mut x, 1).ok_or("singular")?;
/// assert!((x[2] - 3.0).abs() < 1e-14);
/// # Ok::<(), &str>(())
/// ```
pub fn solve_cyclic_tridiagonal(
    lower: &[f64],
    diagonal: &[f64],
    upper: &[f64],
    rhs: &mut [f64],
    columns: usize,
) -> Option<()> {
    let n = diagonal.len();
    if n == 0 || lower.len() != n || upper.len() != n || rhs.len() != n * columns {
        return None;
    }
    if n < 3 {
        // Neighbours coincide: the corner entries fall on the band itself.
        let mut m = BandedMatrix::new(n, n - 1, n - 1);
        for i in 0..n {
            m.add(i, i, diagonal[i]);
            m.add(i, (i + n - 1) % n, lower[i]);
            m.add(i, (i + 1) % n, upper[i]);
        }
        m.factor()?.solve(rhs, columns);
        return Some(());
    }
    // A = T + p q', p = (γ, 0, …, 0, upper[n-1]), q = (1, 0, …, 0, lower[0]/γ).
    let gamma = if diagonal[0] == 0.0 { 1.0 } else { -diagonal[0] };
    let mut t = BandedMatrix::new(n, 1, 1);
    for i in 0..n {
        t.add(i, i, diagonal[i]);
        if i > 0 {
            t.add(i, i - 1, lower[i]);
        }
        if i + 1 < n {
            t.add(i, i + 1, upper[i]);
        }
    }
    t.add(0, 0, -gamma);
    t.add(n - 1, n - 1, -upper[n - 1] * lower[0] / gamma);
    let t = t.factor()?;
    t.solve(rhs, columns);
    let mut p = vec![0.0; n];
    p[0] = gamma;
    p[n - 1] = upper[n - 1];
    t.solve(&mut p, 1);
    let q = lower[0] / gamma;
    let denominator = 1.0 + p[0] + q * p[n - 1];
    if !denominator.is_finite() || denominator.abs() < 1e-14 {
        return None;
    }
    for c in 0..columns {
        let f = (rhs[c] + q * rhs[(n - 1) * columns + c]) / denominator;
        for i in 0..n {
            rhs[i * columns + c] -= f * p[i];
        }
    }
    Some(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_zero_on_the_diagonal_needs_a_row_exchange() {
        // [0 1; 2 0] x = (3, 4)
        let mut m = BandedMatrix::new(2, 1, 1);
        assert!(m.add(0, 1, 1.0) && m.add(1, 0, 2.0));
        let mut x = [3.0, 4.0];
        m.factor().unwrap().solve(&mut x, 1);
        assert_eq!(x, [2.0, 3.0]);
    }

    #[test]
    fn singular_and_not_finite_are_refused() {
        let mut m = BandedMatrix::new(3, 1, 1);
        m.add(0, 0, 1.0);
        m.add(2, 2, 1.0);
        assert!(m.clone().factor().is_none());
        m.add(1, 1, f64::NAN);
        assert!(m.factor().is_none());
        assert!(!BandedMatrix::new(5, 1, 1).add(0, 2, 1.0));
        assert!(solve_cyclic_tridiagonal(&[1.0; 4], &[-2.0; 4], &[1.0; 4], &mut [1.0; 4], 1).is_none());
    }

    proptest! {
        #[test]
        fn residual_is_zero_for_any_band(
            n in 1usize..30, lower in 0usize..4, upper in 0usize..4, seed in prop::collection::vec(-1.0..1.0f64, 400),
        ) {
            let mut m = BandedMatrix::new(n, lower, upper);
            let mut s = seed.iter().cycle();
            for i in 0..n {
                for j in i.saturating_sub(lower)..(i + upper + 1).min(n) {
                    // Rows are shuffled in size, so that exchanges happen; the diagonal keeps the
                    // matrix far from singular.
                    let d = if i == j { 3.0 + (lower + upper) as f64 } else { 0.0 };
                    m.add(i, j, s.next().unwrap() + d * if i % 3 == 0 { 0.4 } else { 1.0 });
                }
            }
            let rhs: Vec<f64> = s.take(2 * n).copied().collect();
            let mut x = rhs.clone();
            if let Some(lu) = m.clone().factor() {
                lu.solve(&mut x, 2);
                for i in 0..n {
                    for c in 0..2 {
                        let sum: f64 = (0..n).map(|j| m.get(i, j) * x[2 * j + c]).sum();
                        let size = x.iter().fold(1.0f64, |a, b| a.max(b.abs()));
                        prop_assert!((sum - rhs[2 * i + c]).abs() < 1e-10 * size);
                    }
                }
            }
        }

        #[test]
        fn cyclic_residual_is_zero(n in 1usize..20, seed in prop::collection::vec(-1.0..1.0f64, 100)) {
            let (lower, upper) = (&seed[..n], &seed[20..20 + n]);
            let diagonal: Vec<f64> = seed[40..40 + n].iter().map(|x| 3.0 + x).collect();
            let rhs = seed[60..60 + n].to_vec();
            let mut x = rhs.clone();
            solve_cyclic_tridiagonal(lower, &diagonal, upper, &mut x, 1).unwrap();
            for i in 0..n {
                let sum = lower[i] * x[(i + n - 1) % n] + diagonal[i] * x[i] + upper[i] * x[(i + 1) % n];
                prop_assert!((sum - rhs[i]).abs() < 1e-12);
            }
        }
    }
}
