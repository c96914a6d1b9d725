//! The small systems of one stage.

/// The inverse of the controls' block of a positive definite matrix whose lower half is given
/// (Gauss and Jordan).
pub(super) fn invert_controls<const X: usize, const V: usize>(m: &[[f64; V]; V]) -> Option<[[f64; V]; V]> {
    let mut a = *m;
    let mut out = [[0.0; V]; V];
    for i in X..V {
        out[i][i] = 1.0;
        for j in i + 1..V {
            a[i][j] = a[j][i];
        }
    }
    for k in X..V {
        let pivot = 1.0 / a[k][k];
        if !(a[k][k] > 0.0 && pivot.is_finite()) {
            return None;
        }
        for j in X..V {
            a[k][j] *= pivot;
            out[k][j] *= pivot;
        }
        for i in (X..V).filter(|i| *i != k) {
            let f = a[i][k];
            for j in X..V {
                a[i][j] -= f * a[k][j];
                out[i][j] -= f * out[k][j];
            }
        }
    }
    Some(out)
}

/// The change of the first state that minimises the cost to go: `P x = −p` over its free
/// components.
pub(super) fn first_state<const X: usize, const V: usize>(
    cost: &[[f64; X]; X],
    side: &[f64; V],
    fixed: &[bool; 8],
) -> Option<[f64; X]> {
    let mut a = *cost;
    let mut b = [0.0; X];
    for i in 0..X {
        b[i] = if fixed[i] { 0.0 } else { -side[i] };
        for j in 0..X {
            if fixed[i] || fixed[j] {
                a[i][j] = f64::from(u8::from(i == j));
            }
        }
    }
    // Cholesky; a component that nothing holds stays where it is.
    let size = (0..X).fold(0.0f64, |m, i| m.max(a[i][i]));
    let mut held = [true; X];
    for j in 0..X {
        for k in 0..j {
            a[j][j] -= a[j][k] * a[j][k];
        }
        held[j] = a[j][j] > 1e-15 * size;
        let root = if held[j] { a[j][j].sqrt() } else { 1.0 };
        a[j][j] = root;
        for i in j + 1..X {
            for k in 0..j {
                a[i][j] -= a[i][k] * a[j][k];
            }
            a[i][j] = if held[j] { a[i][j] / root } else { 0.0 };
        }
    }
    for i in 0..X {
        for k in 0..i {
            b[i] -= a[i][k] * b[k];
        }
        b[i] = if held[i] { b[i] / a[i][i] } else { 0.0 };
    }
    for i in (0..X).rev() {
        for k in i + 1..X {
            b[i] -= a[k][i] * b[k];
        }
        b[i] /= a[i][i];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}
