//! Cubic Béziers in the (s, θ) plane: straight stretches and the two-piece corner of the piecewise
//! method.

use super::corridor::PathAngle;
use crate::artifact::schedule::BezierPiece;
use crate::numerics::bezier::{self as numerics, cubic};

/// A straight stretch as a cubic.
pub(super) fn straight(p: PathAngle, q: PathAngle) -> BezierPiece {
    let at = |f: f64| [p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])];
    [p, at(1.0 / 3.0), at(2.0 / 3.0), q]
}

/// What a corner may use.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerReach {
    /// Length of `s` before and after the corner that it may use, mm.
    pub s_mm: [f64; 2],
    /// Vertical distance to the wall on the side of the curve, rad.
    pub room_rad: f64,
    /// Scales by which `s` and θ are divided.
    pub scale: [f64; 2],
}

/// The corner `p1 p2 p3` rounded by two cubics with doubled inner control points (method of Bézier
/// control point assignment): zero curvature at all joints, so the whole is G2; its height over
/// `p2` is as great as `reach` allows. `None` where the corner is straight.
pub(super) fn corner(p1: PathAngle, p2: PathAngle, p3: PathAngle, reach: &CornerReach) -> Option<[BezierPiece; 2]> {
    let [ls, lt] = reach.scale;
    let angle = |a: PathAngle, b: PathAngle| ((b[1] - a[1]) / lt).atan2((b[0] - a[0]) / ls);
    let (alpha, gamma) = (angle(p1, p2), angle(p2, p3));
    let mu = 0.5 * (alpha + gamma);
    let (sin1, sin2) = ((mu - alpha).sin(), (gamma - mu).sin());
    if sin1.abs() < 1e-13 {
        return None;
    }
    // d = |ε| (cos slope + cos μ) / |sin(slope − μ)| along the segment, of which `cos slope` is
    // along s.
    let most = |s_mm: f64, slope: f64, sin: f64| s_mm / ls * sin.abs() / (slope.cos() * (slope.cos() + mu.cos()));
    let size = (reach.room_rad / lt).min(most(reach.s_mm[0], alpha, sin1)).min(most(reach.s_mm[1], gamma, sin2));
    let epsilon = size * sin1.signum();
    let near = |slope: f64, sin: f64| {
        let d = epsilon * mu.cos() / sin;
        [d * slope.cos(), d * slope.sin()]
    };
    let far = |slope: f64, sin: f64| {
        let d = epsilon * (slope.cos() + mu.cos()) / sin;
        [d * slope.cos(), d * slope.sin()]
    };
    let put = |v: [f64; 2], sign: f64| [p2[0] + sign * v[0] * ls, p2[1] + sign * v[1] * lt];
    let (i0, i1) = (put(far(alpha, sin1), -1.0), put(near(alpha, sin1), -1.0));
    let (j1, j3) = (put(near(gamma, sin2), 1.0), put(far(gamma, sin2), 1.0));
    let top = [p2[0], p2[1] + epsilon * lt];
    Some([[i0, i1, i1, top], [top, j1, j1, j3]])
}

/// θ, dθ/ds and d²θ/ds² of a piece at its parameter `t`.
pub(super) fn derivatives(piece: &BezierPiece, t: f64) -> [f64; 3] {
    let [_, s1, s2] = cubic(piece.map(|p| p[0]), t);
    let [q, q1, q2] = cubic(piece.map(|p| p[1]), t);
    [q, q1 / s1, (q2 * s1 - q1 * s2) / (s1 * s1 * s1)]
}

/// The parameter at which a piece whose `s` rises reaches `s_mm`.
pub(super) fn parameter(piece: &BezierPiece, s_mm: f64) -> f64 {
    numerics::parameter(piece.map(|p| p[0]), s_mm)
}

/// Greatest |d²θ/ds²| of a piece, rad/mm².
pub(super) fn peak_acceleration(piece: &BezierPiece) -> f64 {
    greatest(|t| derivatives(piece, t)[2].abs())
}

/// The greatest value on 0..1: a scan and a golden-section search around its greatest value.
fn greatest(f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 24;
    let mut best = (0, 0.0);
    for i in 0..=STEPS {
        let v = f(i as f64 / STEPS as f64);
        if v > best.1 {
            best = (i, v);
        }
    }
    let step = 1.0 / STEPS as f64;
    let (mut a, mut b) = ((best.0 as f64 * step - step).max(0.0), (best.0 as f64 * step + step).min(1.0));
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..24 {
        let (t1, t2) = (b - ratio * (b - a), a + ratio * (b - a));
        if f(t1) >= f(t2) { b = t2 } else { a = t1 }
    }
    best.1.max(f(0.5 * (a + b)))
}

/// Greatest |dθ/ds| of a piece.
pub(super) fn peak_rate(piece: &BezierPiece) -> f64 {
    greatest(|t| derivatives(piece, t)[1].abs())
}

/// Greatest |d³θ/ds³| of a piece, rad/mm³.
pub(super) fn peak_third(piece: &BezierPiece) -> f64 {
    // d/ds of θ'' = (θ₂ s₁ − s₂ θ₁) / s₁³, numbers being derivatives by the parameter.
    greatest(|t| {
        let [_, s1, s2] = cubic(piece.map(|p| p[0]), t);
        let [_, q1, q2] = cubic(piece.map(|p| p[1]), t);
        let third = |c: [f64; 4]| 6.0 * (c[3] - 3.0 * c[2] + 3.0 * c[1] - c[0]);
        let (s3, q3) = (third(piece.map(|p| p[0])), third(piece.map(|p| p[1])));
        let n = q2 * s1 - s2 * q1;
        (((q3 * s1 - s3 * q1) * s1 - 3.0 * n * s2) / s1.powi(5)).abs()
    })
}

/// θ at increasing `s_mm` of a curve that never turns back where it is said to be `one_way`.
pub(super) fn sample_as(one_way: bool, pieces: &[BezierPiece], s_mm: &[f64]) -> Vec<f64> {
    if one_way { sample(pieces, s_mm.iter().copied()) } else { sample_freely(pieces, s_mm) }
}

/// θ at increasing `s_mm` of a curve that may turn back.
pub(super) fn sample_freely(pieces: &[BezierPiece], s_mm: &[f64]) -> Vec<f64> {
    let mut k = 0;
    let mut out = Vec::with_capacity(s_mm.len());
    for &s in s_mm {
        while k + 1 < pieces.len() && pieces[k][3][0] < s {
            k += 1;
        }
        out.extend(pieces.get(k).map(|p| cubic(p.map(|p| p[1]), parameter(p, s))[0]));
    }
    out
}

/// θ at increasing `s_mm`; pieces in order, without gaps, with control points whose θ does not
/// fall.
pub(super) fn sample(pieces: &[BezierPiece], s_mm: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut k = 0;
    let mut out: Vec<f64> = Vec::new();
    for s in s_mm {
        while k + 1 < pieces.len() && pieces[k][3][0] < s {
            k += 1;
        }
        if let Some(p) = pieces.get(k) {
            let theta = cubic(p.map(|p| p[1]), parameter(p, s))[0];
            // Ends exactly, and no step back by rounding, which a control would count as a
            // reversal.
            let theta = if s <= p[0][0] { p[0][1] } else { theta.min(p[3][1]) };
            out.push(out.last().map_or(theta, |before| theta.max(*before)));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn rounded(room_rad: f64, s_mm: [f64; 2]) -> [BezierPiece; 2] {
        let reach = CornerReach { s_mm, room_rad, scale: [10.0, 2.0] };
        corner([0.0, 0.0], [4.0, 1.0], [10.0, 9.0], &reach).unwrap()
    }

    #[test]
    fn a_corner_is_g2_and_touches_its_segments() {
        for (room, s_mm) in [(0.2, [2.0, 3.0]), (100.0, [2.0, 3.0]), (100.0, [2.0, 0.1])] {
            let [i, j] = rounded(room, s_mm);
            let (slope1, slope2) = (0.25, 8.0 / 6.0);
            let start = derivatives(&i, 0.0);
            assert!((start[1] - slope1).abs() < 1e-12 && start[2].abs() < 1e-9);
            let end = derivatives(&j, 1.0);
            assert!((end[1] - slope2).abs() < 1e-12 && end[2].abs() < 1e-9);
            let (a, b) = (derivatives(&i, 1.0), derivatives(&j, 0.0));
            assert!((a[1] - b[1]).abs() < 1e-12 && a[2].abs() < 1e-9 && b[2].abs() < 1e-9);
            assert!((i[0][1] - slope1 * i[0][0]).abs() < 1e-12);
            assert!(i[0][0] >= 4.0 - s_mm[0] - 1e-12 && j[3][0] <= 4.0 + s_mm[1] + 1e-12);
            let height = i[3][1] - 1.0;
            assert!(height > 0.0 && height <= room + 1e-12);
            // One of the three limits is reached.
            let slack = [room - height, i[0][0] - 4.0 + s_mm[0], 4.0 + s_mm[1] - j[3][0]];
            assert!(slack.iter().any(|s| s.abs() < 1e-9), "{slack:?}");
        }
    }

    #[test]
    fn derivatives_match_differences_and_parameter_inverts() {
        let [i, _] = rounded(0.2, [2.0, 3.0]);
        let (s0, s1) = (i[0][0], i[3][0]);
        let theta = |s: f64| sample(&[i], [s])[0];
        for k in 1..20 {
            let s = s0 + (s1 - s0) * f64::from(k) / 20.0;
            let h = 1e-4 * (s1 - s0);
            let [q, d1, d2] = derivatives(&i, parameter(&i, s));
            assert!((q - theta(s)).abs() < 1e-13);
            assert!((d1 - (theta(s + h) - theta(s - h)) / (2.0 * h)).abs() < 1e-5);
            assert!((d2 - (theta(s + h) - 2.0 * q + theta(s - h)) / (h * h)).abs() < 1e-3);
            assert!(d2.abs() <= peak_acceleration(&i) * (1.0 + 1e-9));
        }
    }

    #[test]
    fn the_peak_of_a_symmetric_corner_has_a_closed_form() {
        // Equal lengths and symmetric slopes ∓m in equal scales: half the corner spans 2a of s and
        // turns the slope by m with A × C = m a², so the peak is (4/3) m / a.
        let reach = CornerReach { s_mm: [1.0, 1.0], room_rad: 1e9, scale: [1.0, 1.0] };
        let m = 1e-3;
        let [i, j] = corner([-2.0, 2.0 * m], [0.0, 0.0], [2.0, 2.0 * m], &reach).unwrap();
        let want = 4.0 / 3.0 * m / 0.5;
        for p in [i, j] {
            assert!((peak_acceleration(&p) / want - 1.0).abs() < 1e-5);
        }
        assert!(corner([0.0, 0.0], [1.0, 1.0], [2.0, 2.0], &reach).is_none());
    }
}
