//! B-splines through given points, and the cutting of B-splines.
//!
//! In: grids of homogeneous points `(w x, w y, w z, w)` and the parameters of their rows and
//! columns. Out: curves and surfaces that pass through them exactly (to rounding). Interpolation is
//! done in homogeneous space, so rational surfaces with given weights are interpolated too: columns
//! that are interpolated separately with the same parameters fit together without gaps.
//!
//! Two kinds: **clamped** of any degree, knots by averaging (Piegl and Tiller, *The NURBS Book*,
//! eq. 9.8), and **periodic cubic**, knots at the parameters, C² everywhere ([`PeriodicRows`]). A
//! periodic spline is cut into clamped pieces by inserting knots (Boehm), which leaves the curve as
//! it was; neighbouring pieces share their end points bit by bit.
//!
//! Limits: weights are interpolated like coordinates and stay positive only if they vary slowly;
//! [`NurbsCurve`]s and surfaces with a weight that is not positive are refused.

use nalgebra::Vector4;

use super::basis::Basis;
use super::{NurbsCurve, NurbsSurface};
use crate::numerics::banded::{BandedLu, BandedMatrix, solve_cyclic_tridiagonal};

/// Why a fit or a cut is impossible.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// Number of points and parameters do not fit together, or there are too few.
    #[error("{what}: needs {expected}, got {got}")]
    Count {
        /// Which array.
        what: &'static str,
        /// What is needed.
        expected: String,
        /// What was given.
        got: usize,
    },
    /// Parameters do not increase strictly or are not finite.
    #[error("parameter {index} ({value}) is not finite or not greater than the one before it")]
    Parameters {
        /// Which.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A coordinate is not finite or a weight not positive.
    #[error("point {index} is not finite or has a weight that is not positive")]
    Point {
        /// Index into the points.
        index: usize,
    },
    /// A cut outside the parameter range.
    #[error("cut at {at} is not inside the parameter range {from} to {to}")]
    Cut {
        /// Where the cut should be.
        at: f64,
        /// Start of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// The interpolation has no solution for these parameters.
    #[error("the interpolation has no unique solution for these parameters")]
    Singular,
}

/// Knots for clamped interpolation at strictly increasing parameters: end knots `degree + 1` fold,
/// inner ones the average of `degree` successive parameters (The NURBS Book, eq. 9.8).
pub fn averaged_knots(params: &[f64], degree: usize) -> Result<Vec<f64>, FitError> {
    check_params(params, degree + 1)?;
    if degree == 0 {
        return Err(FitError::Count { what: "degree", expected: "at least 1".into(), got: 0 });
    }
    let n = params.len();
    let mut knots = vec![params[0]; degree + 1];
    knots.extend((1..n - degree).map(|j| params[j..j + degree].iter().sum::<f64>() / degree as f64));
    knots.extend(std::iter::repeat_n(params[n - 1], degree + 1));
    Ok(knots)
}

/// The clamped curve of the given degree through homogeneous points at the given parameters.
///
/// ```
/// use bladewright::geometry::nurbs::fit::interpolate_curve;
/// use nalgebra::Vector4;
/// let p: Vec<_> = (0..6).map(|i| Vector4::new(i as f64, (i * i) as f64, 0.0, 1.0)).collect();
/// let c = interpolate_curve(&p, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 3)?;
/// assert_eq!(c.points.len(), 6);
/// # Ok::<(), bladewright::geometry::nurbs::fit::FitError>(())
/// ```
pub fn interpolate_curve(points: &[Vector4<f64>], params: &[f64], degree: usize) -> Result<NurbsCurve, FitError> {
    let rows = interpolate_rows(points, 1, params, degree)?;
    check_points(&rows.points)?;
    Ok(NurbsCurve { degree, knots: rows.knots, points: rows.points })
}

/// The clamped surface through a grid of homogeneous points, index `i_u * params_v.len() + i_v`.
pub fn interpolate_surface(
    grid: &[Vector4<f64>],
    params_u: &[f64],
    params_v: &[f64],
    degree_u: usize,
    degree_v: usize,
) -> Result<NurbsSurface, FitError> {
    let along_u = interpolate_rows(grid, params_v.len(), params_u, degree_u)?;
    surface_through_rows(&along_u, params_v, degree_v)
}

/// Control points along u, each a row of points across v: the common form of curves (one column)
/// and surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlRows {
    /// Degree along u.
    pub degree: usize,
    /// Knots along u, clamped.
    pub knots: Vec<f64>,
    /// Points in one row.
    pub columns: usize,
    /// Row by row.
    pub points: Vec<Vector4<f64>>,
}

impl ControlRows {
    /// The curve that one column describes; `None` for a column that does not exist.
    pub fn curve(&self, column: usize) -> Option<NurbsCurve> {
        (column < self.columns).then(|| NurbsCurve {
            degree: self.degree,
            knots: self.knots.clone(),
            points: self.points.iter().skip(column).step_by(self.columns).copied().collect(),
        })
    }

    /// The surface whose control points along v are the rows as they are.
    pub fn surface(&self, degree_v: usize, knots_v: Vec<f64>) -> Result<NurbsSurface, FitError> {
        if degree_v == 0 || knots_v.len() != self.columns + degree_v + 1 {
            let expected = format!("{} for {} columns", self.columns + degree_v + 1, self.columns);
            return Err(FitError::Count { what: "knots along v", expected, got: knots_v.len() });
        }
        check_points(&self.points)?;
        Ok(NurbsSurface {
            degree_u: self.degree,
            degree_v,
            knots_u: self.knots.clone(),
            knots_v,
            n_u: self.points.len() / self.columns,
            n_v: self.columns,
            points: self.points.clone(),
        })
    }

    /// Cuts at `t`, strictly inside the knots' range, or at the knot within rounding of it: both
    /// parts describe the same as before on their side, and the last row of the first is the first
    /// row of the second.
    ///
    /// # Errors
    /// A cut at an end of the range, or within rounding of one, or outside: one part would be
    /// empty.
    pub fn split(&self, t: f64) -> Result<(ControlRows, ControlRows), FitError> {
        let (from, to) = (self.knots[0], self.knots[self.knots.len() - 1]);
        let t = self.nearest_knot(t);
        if !(t > from && t < to) {
            return Err(FitError::Cut { at: t, from, to });
        }
        let (p, c) = (self.degree, self.columns);
        let mut whole = self.clone();
        while whole.knots.iter().filter(|&&k| k == t).count() < p {
            whole.insert(t);
        }
        // First of the knots equal to t is at k: the row that lies on the surface is k − 1.
        let k = whole.knots.partition_point(|&x| x < t);
        let mut first = whole.knots[..k + p].to_vec();
        first.push(t);
        let mut second = vec![t];
        second.extend_from_slice(&whole.knots[k..]);
        let part =
            |knots, points: &[Vector4<f64>]| ControlRows { degree: p, knots, columns: c, points: points.to_vec() };
        Ok((part(first, &whole.points[..k * c]), part(second, &whole.points[(k - 1) * c..])))
    }

    /// An existing knot within rounding of `t`, or `t`.
    fn nearest_knot(&self, t: f64) -> f64 {
        let span = self.knots[self.knots.len() - 1] - self.knots[0];
        self.knots.iter().copied().find(|k| (k - t).abs() <= 1e-12 * span).unwrap_or(t)
    }

    /// Inserts one knot, inside the range and there less than `degree` fold (Boehm; The NURBS Book,
    /// eq. 5.15).
    fn insert(&mut self, t: f64) {
        let (p, c) = (self.degree, self.columns);
        let k = self.knots.partition_point(|&x| x <= t) - 1;
        let multiplicity = self.knots.iter().filter(|&&x| x == t).count();
        let mut points = self.points[..(k - p + 1) * c].to_vec();
        for i in k - p + 1..=k - multiplicity {
            let a = (t - self.knots[i]) / (self.knots[i + p] - self.knots[i]);
            points.extend((0..c).map(|j| self.points[i * c + j] * a + self.points[(i - 1) * c + j] * (1.0 - a)));
        }
        points.extend_from_slice(&self.points[(k - multiplicity) * c..]);
        self.points = points;
        self.knots.insert(k + 1, t);
    }
}

/// Cuts a curve at `t` into two that share the point there.
pub fn split_curve(curve: &NurbsCurve, t: f64) -> Result<(NurbsCurve, NurbsCurve), FitError> {
    let rows =
        ControlRows { degree: curve.degree, knots: curve.knots.clone(), columns: 1, points: curve.points.clone() };
    check_clamped(&rows)?;
    let (a, b) = rows.split(t)?;
    let curve = |r: ControlRows| NurbsCurve { degree: r.degree, knots: r.knots, points: r.points };
    Ok((curve(a), curve(b)))
}

/// The ruled surface between two curves of one degree: `v = 0` on `a`, `v = 1` on `b`, each at the
/// same share of its parameters. The knots of each are inserted into the other, which leaves both
/// curves as they were.
///
/// # Errors
/// Degrees that differ, curves that are not clamped.
pub fn ruled(a: &NurbsCurve, b: &NurbsCurve) -> Result<NurbsSurface, FitError> {
    let unit = |c: &NurbsCurve| {
        let rows = ControlRows { degree: c.degree, knots: c.knots.clone(), columns: 1, points: c.points.clone() };
        check_clamped(&rows)?;
        let (from, to) = (c.knots[0], c.knots[c.knots.len() - 1]);
        let knots = c.knots.iter().map(|k| (k - from) / (to - from)).collect();
        Ok(ControlRows { knots, ..rows })
    };
    let (mut a, mut b) = (unit(a)?, unit(b)?);
    if a.degree != b.degree {
        return Err(FitError::Count { what: "degree", expected: a.degree.to_string(), got: b.degree });
    }
    // Knots that differ by rounding are one.
    for k in &mut b.knots {
        *k = a.nearest_knot(*k);
    }
    let inner: Vec<f64> = a.knots.iter().chain(&b.knots).copied().filter(|k| *k > 0.0 && *k < 1.0).collect();
    let count = |rows: &ControlRows, k: f64| rows.knots.iter().filter(|x| **x == k).count();
    for k in inner {
        let wanted = count(&a, k).max(count(&b, k));
        for rows in [&mut a, &mut b] {
            while count(rows, k) < wanted {
                rows.insert(k);
            }
        }
    }
    let points = a.points.iter().zip(&b.points).flat_map(|(p, q)| [*p, *q]).collect();
    ControlRows { points, columns: 2, ..a }.surface(1, vec![0.0, 0.0, 1.0, 1.0])
}

/// Cuts a surface at `u` into two that share the boundary there.
pub fn split_surface_u(surface: &NurbsSurface, u: f64) -> Result<(NurbsSurface, NurbsSurface), FitError> {
    let rows = ControlRows {
        degree: surface.degree_u,
        knots: surface.knots_u.clone(),
        columns: surface.n_v,
        points: surface.points.clone(),
    };
    check_clamped(&rows)?;
    let (a, b) = rows.split(u)?;
    Ok((a.surface(surface.degree_v, surface.knots_v.clone())?, b.surface(surface.degree_v, surface.knots_v.clone())?))
}

/// A closed C² cubic through rows of points: control rows with indices taken round the circle.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicRows {
    /// `n + 1` parameters, strictly increasing; the last one is the first, a period on.
    params: Vec<f64>,
    /// Points in one row.
    columns: usize,
    /// `n` control rows; row `i` belongs to the basis function that peaks at `params[i]`.
    points: Vec<Vector4<f64>>,
}

impl PeriodicRows {
    /// Interpolates `n ≥ 3` rows of `columns` points at `params` (`n + 1` of them: the last closes
    /// the period).
    pub fn interpolate(points: &[Vector4<f64>], columns: usize, params: &[f64]) -> Result<Self, FitError> {
        check_params(params, 4)?;
        let n = params.len() - 1;
        if columns == 0 || points.len() != n * columns {
            let expected = format!("{n} rows of {columns}");
            return Err(FitError::Count { what: "points", expected, got: points.len() });
        }
        let mut rows = PeriodicRows { params: params.to_vec(), columns, points: points.to_vec() };
        // At t[i] the cubic basis functions that peak at t[i-1], t[i], t[i+1] are not zero.
        let (mut lower, mut diagonal, mut upper) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        for i in 0..n {
            let t = |j: isize| rows.knot(i as isize + j);
            let h = t(1) - t(0);
            let g = t(0) - t(-1);
            let (a, b) = (t(1) - t(-2), t(2) - t(-1));
            lower[i] = h * h / (a * (t(1) - t(-1)));
            upper[i] = g * g / (b * (t(1) - t(-1)));
            diagonal[i] = 1.0 - lower[i] - upper[i];
        }
        let mut rhs: Vec<f64> = points.iter().flat_map(|p| p.iter().copied()).collect();
        solve_cyclic_tridiagonal(&lower, &diagonal, &upper, &mut rhs, 4 * columns).ok_or(FitError::Singular)?;
        rows.points = rhs.chunks_exact(4).map(Vector4::from_column_slice).collect();
        match rows.points.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            Some(index) => Err(FitError::Point { index }),
            None => Ok(rows),
        }
    }

    /// Knot with any index, repeated by the period.
    fn knot(&self, i: isize) -> f64 {
        let n = self.params.len() as isize - 1;
        let period = self.params[n as usize] - self.params[0];
        self.params[i.rem_euclid(n) as usize] + period * i.div_euclid(n) as f64
    }

    /// The whole round as one clamped piece from `params[start]` to one period on; its last row is
    /// its first, bit by bit.
    pub fn open(&self, start: usize) -> ControlRows {
        let (n, c) = (self.params.len() - 1, self.columns);
        let s = (start % n) as isize;
        // Basis function i spans the knots i − 2 … i + 2; unclamped over one period and three more
        // on each side.
        let knots: Vec<f64> = (s - 3..=s + n as isize + 3).map(|i| self.knot(i)).collect();
        let points = (s - 1..=s + n as isize + 1)
            .flat_map(|i| (0..c).map(move |j| (i.rem_euclid(n as isize)) as usize * c + j))
            .map(|k| self.points[k])
            .collect();
        let mut rows = ControlRows { degree: 3, knots, columns: c, points };
        let (from, to) = (rows.knots[3], rows.knots[n + 3]);
        for t in [from, to] {
            while rows.knots.iter().filter(|&&k| k == t).count() < 3 {
                rows.insert(t);
            }
        }
        // Knots: 3 below, `from` threefold, …, `to` threefold, 3 above. Rows 2 … lie on or between
        // the ends.
        let (a, b) = (rows.knots.partition_point(|&k| k < from), rows.knots.partition_point(|&k| k < to));
        let mut knots = vec![from];
        knots.extend_from_slice(&rows.knots[a..b + 3]);
        knots.push(to);
        let mut points = rows.points[(a - 1) * c..b * c].to_vec();
        let last = points.len() - c;
        let first = points[..c].to_vec();
        points[last..].copy_from_slice(&first);
        ControlRows { degree: 3, knots, columns: c, points }
    }

    /// Clamped pieces between cuts at parameters with the given (increasing) indices: the last
    /// piece runs round to the first cut.
    pub fn pieces(&self, cuts: &[usize]) -> Result<Vec<ControlRows>, FitError> {
        let Some(&first) = cuts.first() else {
            return Err(FitError::Count { what: "cuts", expected: "at least 1".into(), got: 0 });
        };
        if first >= self.params.len() - 1 {
            let expected = format!("below {}", self.params.len() - 1);
            return Err(FitError::Count { what: "index of the first cut", expected, got: first });
        }
        let mut rest = self.open(first);
        let mut pieces = Vec::with_capacity(cuts.len());
        for &cut in &cuts[1..] {
            let (a, b) = rest.split(self.knot(cut as isize))?;
            pieces.push(a);
            rest = b;
        }
        pieces.push(rest);
        Ok(pieces)
    }
}

/// The surface whose rows across v, at every control row along u, pass through the given points at
/// `params_v`: first and last column stay as they are, bit by bit.
pub fn surface_through_rows(rows: &ControlRows, params_v: &[f64], degree_v: usize) -> Result<NurbsSurface, FitError> {
    if params_v.len() != rows.columns {
        let expected = format!("{} columns", rows.columns);
        return Err(FitError::Count { what: "parameters along v", expected, got: params_v.len() });
    }
    let knots_v = averaged_knots(params_v, degree_v)?;
    let lu = collocation(params_v, &knots_v, degree_v)?;
    let mut points = Vec::with_capacity(rows.points.len());
    for row in rows.points.chunks_exact(rows.columns) {
        points.extend(solve_clamped(&lu, row, 1));
    }
    ControlRows { points, ..rows.clone() }.surface(degree_v, knots_v)
}

/// Clamped interpolation along u of rows of `columns` points.
pub fn interpolate_rows(
    points: &[Vector4<f64>],
    columns: usize,
    params: &[f64],
    degree: usize,
) -> Result<ControlRows, FitError> {
    if columns == 0 || points.len() != params.len() * columns {
        let expected = format!("{} rows of {columns}", params.len());
        return Err(FitError::Count { what: "points", expected, got: points.len() });
    }
    let knots = averaged_knots(params, degree)?;
    let lu = collocation(params, &knots, degree)?;
    Ok(ControlRows { degree, knots, columns, points: solve_clamped(&lu, points, columns) })
}

/// Solves for control rows; the end rows of a clamped spline are the end points themselves.
fn solve_clamped(lu: &BandedLu, points: &[Vector4<f64>], columns: usize) -> Vec<Vector4<f64>> {
    let mut rhs: Vec<f64> = points.iter().flat_map(|p| p.iter().copied()).collect();
    lu.solve(&mut rhs, 4 * columns);
    let mut out: Vec<_> = rhs.chunks_exact(4).map(Vector4::from_column_slice).collect();
    let last = out.len() - columns;
    out[..columns].copy_from_slice(&points[..columns]);
    out[last..].copy_from_slice(&points[last..]);
    out
}

/// The factored matrix of basis values at the parameters.
fn collocation(params: &[f64], knots: &[f64], degree: usize) -> Result<BandedLu, FitError> {
    let n = params.len();
    let mut m = BandedMatrix::new(n, degree, degree);
    for (i, &t) in params.iter().enumerate() {
        let basis = Basis::new(degree, n, knots, t);
        for (j, &value) in basis.value().iter().enumerate() {
            // Outside the band the basis function is zero at t (Schoenberg–Whitney).
            m.add(i, basis.first + j, value);
        }
    }
    m.factor().ok_or(FitError::Singular)
}

fn check_params(params: &[f64], least: usize) -> Result<(), FitError> {
    if params.len() < least {
        return Err(FitError::Count { what: "parameters", expected: format!("at least {least}"), got: params.len() });
    }
    match (0..params.len()).find(|&i| !params[i].is_finite() || (i > 0 && params[i] <= params[i - 1])) {
        Some(index) => Err(FitError::Parameters { index, value: params[index] }),
        None => Ok(()),
    }
}

fn check_points(points: &[Vector4<f64>]) -> Result<(), FitError> {
    let bad = |p: &Vector4<f64>| p.iter().any(|x| !x.is_finite()) || p.w <= 0.0;
    points.iter().position(bad).map_or(Ok(()), |index| Err(FitError::Point { index }))
}

/// Lengths fit together and the end knots are `degree + 1` fold.
fn check_clamped(rows: &ControlRows) -> Result<(), FitError> {
    let (p, k) = (rows.degree, &rows.knots);
    let n = rows.points.len().checked_div(rows.columns).unwrap_or(0);
    if p == 0 || n < p + 1 || k.len() != n + p + 1 || rows.points.len() != n * rows.columns {
        return Err(FitError::Count { what: "knots", expected: format!("{} for {n} points", n + p + 1), got: k.len() });
    }
    let unsorted = (1..k.len()).find(|&i| k[i].is_nan() || k[i] < k[i - 1]);
    let open = if k[0] != k[p] { Some(p) } else { (k[n] != k[n + p]).then_some(n) };
    match unsorted.or(open) {
        Some(index) => Err(FitError::Parameters { index, value: k[index] }),
        None => Ok(()),
    }
}

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
