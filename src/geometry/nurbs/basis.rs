//! B-spline basis functions with their first and second derivatives.
//!
//! The functions of degree p are raised from those of degree p − 2 (Cox and de Boor; *The NURBS
//! Book* A2.2); derivatives follow from the functions of one degree less (eq. 2.7):
//! `N'_{i,p} = p N_{i,p-1} / (u_{i+p} - u_i) - p N_{i+1,p-1} / (u_{i+p+1} - u_{i+1})`. Parameters
//! outside the domain extrapolate the first or last polynomial piece. No allocation up to degree
//! [`STACK_DEGREE`].

/// Greatest degree that is evaluated without allocation.
pub const STACK_DEGREE: usize = 16;

/// The knot span of `t`: the index `i` with `knots[i] <= t < knots[i + 1]`, within
/// `degree ..= n - 1` (so that a parameter at or beyond an end of the domain belongs to the first
/// or last span that is not empty). `n` is the number of control points.
pub fn find_span(degree: usize, n: usize, knots: &[f64], t: f64) -> usize {
    let after = knots[degree..=n].partition_point(|&k| k <= t);
    let mut span = (degree + after).saturating_sub(1).clamp(degree, n - 1);
    // At the end of the domain: back to the last span with a length.
    while span > degree && knots[span] >= knots[span + 1] {
        span -= 1;
    }
    span
}

/// Values, first and second derivatives of the `degree + 1` basis functions that live on one knot
/// span.
pub struct Basis {
    degree: usize,
    stack: [f64; 3 * (STACK_DEGREE + 1)],
    heap: Vec<f64>,
    /// Index of the first control point that takes part.
    pub first: usize,
}

impl Basis {
    /// Evaluates all of them at `t`. The knots must be valid ([`validate_knots`]).
    pub fn new(degree: usize, n: usize, knots: &[f64], t: f64) -> Self {
        let span = find_span(degree, n, knots, t);
        let heap = if degree > STACK_DEGREE { vec![0.0; 3 * (degree + 1)] } else { Vec::new() };
        let mut basis = Basis { degree, stack: [0.0; 3 * (STACK_DEGREE + 1)], heap, first: span - degree };
        let buffer = if degree > STACK_DEGREE { &mut basis.heap[..] } else { &mut basis.stack[..] };
        let (value, rest) = buffer.split_at_mut(degree + 1);
        let (d1, d2) = rest.split_at_mut(degree + 1);
        fill(degree, span, knots, t, [value, d1, &mut d2[..=degree]]);
        basis
    }

    fn buffer(&self) -> &[f64] {
        if self.degree > STACK_DEGREE { &self.heap } else { &self.stack }
    }
    /// Values.
    pub fn value(&self) -> &[f64] {
        &self.buffer()[..=self.degree]
    }
    /// First derivatives.
    pub fn d1(&self) -> &[f64] {
        &self.buffer()[self.degree + 1..2 * (self.degree + 1)]
    }
    /// Second derivatives.
    pub fn d2(&self) -> &[f64] {
        &self.buffer()[2 * (self.degree + 1)..3 * (self.degree + 1)]
    }
}

/// Fills values, first and second derivatives (each `degree + 1` long) on the span.
fn fill(degree: usize, span: usize, knots: &[f64], t: f64, [value, d1, d2]: [&mut [f64]; 3]) {
    value[0] = 1.0;
    for k in 1..=degree {
        if k == degree {
            // `value` holds degree p - 1, `d1` its first derivatives (or zero for p = 1): second
            // derivatives from those.
            differentiate(degree, span, knots, d1, d2);
            differentiate(degree, span, knots, value, d1);
        } else if k + 1 == degree {
            differentiate(k, span, knots, value, d1);
        }
        raise(k, span, knots, t, value);
    }
}

/// Raises the values of degree `k - 1` on the span (in `value[..k]`) to degree `k` (in
/// `value[..=k]`), in place.
fn raise(k: usize, span: usize, knots: &[f64], t: f64, value: &mut [f64]) {
    let mut saved = 0.0;
    for r in 0..k {
        let (right, left) = (knots[span + r + 1], knots[span + 1 + r - k]);
        let width = right - left;
        let scaled = if width > 0.0 { value[r] / width } else { 0.0 };
        value[r] = saved + (right - t) * scaled;
        saved = (t - left) * scaled;
    }
    value[k] = saved;
}

/// From functions of degree `k - 1` (`lower[..k]`, or any derivative of them) to the next
/// derivative of those of degree `k`.
fn differentiate(k: usize, span: usize, knots: &[f64], lower: &[f64], out: &mut [f64]) {
    let mut before = 0.0;
    for r in 0..k {
        let width = knots[span + r + 1] - knots[span + 1 + r - k];
        let term = if width > 0.0 { k as f64 * lower[r] / width } else { 0.0 };
        out[r] = before - term;
        before = term;
    }
    out[k] = before;
}

/// Checks one knot vector for `n` control points.
///
/// # Errors
/// One sentence that says what is wrong: degree 0, too few points, wrong count, not finite,
/// decreasing, empty domain, or an inner knot that tears the curve apart (multiplicity above the
/// degree).
pub fn validate_knots(degree: usize, n: usize, knots: &[f64]) -> Result<(), String> {
    if degree == 0 {
        return Err("degree is 0, at least 1 is needed".into());
    }
    if n <= degree {
        return Err(format!("{n} control points are too few for degree {degree}"));
    }
    if knots.len() != n + degree + 1 {
        return Err(format!("{} knots, {} are needed for {n} points of degree {degree}", knots.len(), n + degree + 1));
    }
    if let Some(i) = knots.iter().position(|k| !k.is_finite()) {
        return Err(format!("knot {i} is not finite"));
    }
    if let Some(i) = knots.windows(2).position(|w| w[0] > w[1]) {
        return Err(format!("knot {} is less than the one before it", i + 1));
    }
    let (from, to) = (knots[degree], knots[n]);
    if from >= to {
        return Err(format!("the parameter range {from} to {to} is empty"));
    }
    let torn = (degree..n)
        .find(|&i| knots[i] > from && knots[i] < to && knots[i + 1..].get(degree - 1).is_some_and(|k| *k == knots[i]));
    match torn {
        Some(i) if knots.iter().filter(|k| **k == knots[i]).count() > degree => {
            Err(format!("inner knot {} has a multiplicity above the degree {degree}", knots[i]))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOTS: [f64; 11] = [0.0, 0.0, 0.0, 0.0, 0.3, 0.5, 0.5, 1.2, 1.2, 1.2, 1.2];

    #[test]
    fn partition_of_unity_and_differences() {
        let (degree, n) = (3, 7);
        for i in 0..=120 {
            let t = i as f64 * 0.01;
            let b = Basis::new(degree, n, &KNOTS, t);
            assert!((b.value().iter().sum::<f64>() - 1.0).abs() < 1e-14);
            assert!(b.d1().iter().sum::<f64>().abs() < 1e-11);
            assert!(b.d2().iter().sum::<f64>().abs() < 1e-9);
            let h = 1e-5;
            // Differences only where both sides lie on one span.
            let span = find_span(degree, n, &KNOTS, t);
            if KNOTS[span] + h < t && t + h < KNOTS[span + 1] {
                let (l, r) = (Basis::new(degree, n, &KNOTS, t - h), Basis::new(degree, n, &KNOTS, t + h));
                for j in 0..=degree {
                    let d1 = (r.value()[j] - l.value()[j]) / (2.0 * h);
                    let d2 = (r.d1()[j] - l.d1()[j]) / (2.0 * h);
                    assert!((d1 - b.d1()[j]).abs() < 1e-6, "t {t} j {j}: {d1} {}", b.d1()[j]);
                    assert!((d2 - b.d2()[j]).abs() < 1e-5, "t {t} j {j}: {d2} {}", b.d2()[j]);
                }
            }
        }
    }

    /// Bernstein polynomials of degree 1, 2 and 20 (the last beyond the stack) in closed form.
    #[test]
    fn bernstein() {
        for p in [1usize, 2, 20] {
            let knots: Vec<f64> = std::iter::repeat_n(0.0, p + 1).chain(std::iter::repeat_n(1.0, p + 1)).collect();
            let choose = |n: usize, k: usize| (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64);
            let bern = |n: usize, i: isize, t: f64| {
                if i < 0 || i as usize > n {
                    0.0
                } else {
                    choose(n, i as usize) * t.powi(i as i32) * (1.0 - t).powi((n as isize - i) as i32)
                }
            };
            let t = 0.37;
            let b = Basis::new(p, p + 1, &knots, t);
            for j in 0..=p as isize {
                let d1 = p as f64 * (bern(p - 1, j - 1, t) - bern(p - 1, j, t));
                let d2 = if p < 2 {
                    0.0
                } else {
                    (p * (p - 1)) as f64 * (bern(p - 2, j - 2, t) - 2.0 * bern(p - 2, j - 1, t) + bern(p - 2, j, t))
                };
                assert!((b.value()[j as usize] - bern(p, j, t)).abs() < 1e-13);
                assert!((b.d1()[j as usize] - d1).abs() < 1e-11);
                assert!((b.d2()[j as usize] - d2).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn spans_at_the_ends() {
        assert_eq!(find_span(3, 7, &KNOTS, -1.0), 3);
        assert_eq!(find_span(3, 7, &KNOTS, 0.0), 3);
        assert_eq!(find_span(3, 7, &KNOTS, 0.5), 6);
        assert_eq!(find_span(3, 7, &KNOTS, 1.2), 6);
        assert_eq!(find_span(3, 7, &KNOTS, 9.0), 6);
    }

    #[test]
    fn bad_knots_are_named() {
        assert!(validate_knots(3, 7, &KNOTS).is_ok());
        let says = |d: usize, n: usize, k: &[f64], what: &str| {
            let message = validate_knots(d, n, k).err().unwrap_or_default();
            assert!(message.contains(what), "{message:?} lacks {what:?}");
        };
        says(0, 7, &KNOTS, "degree is 0");
        says(3, 3, &KNOTS, "too few");
        says(3, 6, &KNOTS, "11 knots");
        says(1, 2, &[0.0, f64::NAN, 1.0, 1.0], "not finite");
        says(1, 2, &[0.0, 1.0, 0.5, 1.0], "less than");
        says(1, 2, &[0.0, 0.0, 0.0, 1.0], "empty");
        says(1, 4, &[0.0, 0.0, 0.5, 0.5, 1.0, 1.0], "multiplicity");
    }
}
