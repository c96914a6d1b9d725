//! What holds for the curve itself: extremes of its pieces, not samples.

use super::bezier;
use super::corridor::Corridor;
use crate::artifact::schedule::{BezierPiece, Quality, ScheduleKind};
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::numerics::spline::{CubicSpline, SplineEnds};

/// Turning back by less is rounding, rad.
const STILL: f64 = 1e-9;

/// Cubics in `s` with the given values and slopes (per mm) at increasing `s`.
pub(super) fn hermite(s: &[f64], theta: &[f64], slope: &[f64]) -> Vec<BezierPiece> {
    let mut out = Vec::with_capacity(s.len());
    for (i, w) in s.windows(2).enumerate() {
        let third = (w[1] - w[0]) / 3.0;
        let (Some([a, b]), Some([m, n])) = (theta.get(i..i + 2), slope.get(i..i + 2)) else { break };
        out.push([[w[0], *a], [w[0] + third, a + third * m], [w[1] - third, b - third * n], [w[1], *b]]);
    }
    out
}

/// The four `s` are evenly spaced: the piece is a cubic in `s`.
fn is_function(p: &BezierPiece) -> bool {
    let third = (p[3][0] - p[0][0]) / 3.0;
    (p[1][0] - p[0][0] - third).abs() <= 1e-9 * third && (p[3][0] - p[2][0] - third).abs() <= 1e-9 * third
}

/// `[a, b, c, d]` with the cubic `a + b t + c t² + d t³`, `t` from 0 to 1.
fn powers(c: [f64; 4]) -> [f64; 4] {
    [c[0], 3.0 * (c[1] - c[0]), 3.0 * (c[2] - 2.0 * c[1] + c[0]), c[3] - 3.0 * c[2] + 3.0 * c[1] - c[0]]
}

/// Roots of `a + b t + c t²` strictly between `from` and `to`.
fn roots(a: f64, b: f64, c: f64, from: f64, to: f64) -> impl Iterator<Item = f64> {
    let d = b * b - 4.0 * a * c;
    let q = -0.5 * (b + b.signum() * d.max(0.0).sqrt());
    let found = if d < 0.0 { [f64::NAN; 2] } else { [q / c, a / q] };
    found.into_iter().filter(move |t| *t > from && *t < to)
}

fn value(p: [f64; 4], t: f64) -> f64 {
    p[0] + t * (p[1] + t * (p[2] + t * p[3]))
}

/// Places where θ turns back, on the curve itself.
pub(super) fn reversals(pieces: &[BezierPiece]) -> usize {
    let mut extremes = Vec::with_capacity(pieces.len());
    for p in pieces {
        let c = powers(p.map(|q| q[1]));
        extremes.push(c[0]);
        let mut inner: Vec<f64> = roots(c[1], 2.0 * c[2], 3.0 * c[3], 0.0, 1.0).collect();
        inner.sort_by(f64::total_cmp);
        extremes.extend(inner.into_iter().map(|t| value(c, t)));
    }
    extremes.extend(pieces.last().map(|p| p[3][1]));
    // An extreme that differs by less than rounding from the last one that counted says nothing.
    let mut counted: Vec<f64> = Vec::with_capacity(extremes.len());
    for e in extremes {
        match counted[..] {
            [.., a, b] if (b - a) * (e - b) >= 0.0 => {
                let last = counted.len() - 1;
                counted[last] = e;
            }
            [.., b] if (e - b).abs() <= STILL => {}
            _ => counted.push(e),
        }
    }
    counted.len().saturating_sub(2)
}

/// Greatest |θ'|, |θ''| and |θ'''| over `s`.
pub(super) fn peaks(pieces: &[BezierPiece]) -> [f64; 3] {
    let mut out = [0.0f64; 3];
    for p in pieces {
        if is_function(p) {
            let h = p[3][0] - p[0][0];
            let c = powers(p.map(|q| q[1]));
            let (start, end) = (2.0 * c[2], 2.0 * c[2] + 6.0 * c[3]);
            let rate = |t: f64| (c[1] + t * (2.0 * c[2] + 3.0 * t * c[3])).abs() / h;
            let vertex = (-c[2] / (3.0 * c[3])).clamp(0.0, 1.0);
            out[0] = out[0].max(rate(0.0)).max(rate(1.0)).max(if vertex.is_finite() { rate(vertex) } else { 0.0 });
            out[1] = out[1].max(start.abs().max(end.abs()) / (h * h));
            out[2] = out[2].max(6.0 * c[3].abs() / (h * h * h));
        } else {
            out[0] = out[0].max(bezier::peak_rate(p));
            out[1] = out[1].max(bezier::peak_acceleration(p));
            out[2] = out[2].max(bezier::peak_third(p));
        }
    }
    out
}

/// `∫ θ''² ds` and `∫ θ'''² ds` of a curve of cubics in `s`.
pub(super) fn squares(pieces: &[BezierPiece]) -> [f64; 2] {
    let mut out = [0.0; 2];
    for p in pieces {
        let h = p[3][0] - p[0][0];
        let c = powers(p.map(|q| q[1]));
        let (a, b) = (2.0 * c[2], 2.0 * c[2] + 6.0 * c[3]);
        out[0] += (a * a + a * b + b * b) / 3.0 / (h * h * h);
        out[1] += (b - a) * (b - a) / h.powi(5);
    }
    out
}

/// Whether the second derivative is continuous: its jumps at the joints are less than a millionth
/// of its greatest value, or what rounding of the control points amounts to.
fn is_continuous(pieces: &[BezierPiece], peak: f64) -> bool {
    pieces.windows(2).all(|w| {
        let jump = (bezier::derivatives(&w[0], 1.0)[2] - bezier::derivatives(&w[1], 0.0)[2]).abs();
        let h = (w[0][3][0] - w[0][0][0]).min(w[1][3][0] - w[1][0][0]);
        let size = w[0][3][1].abs().max(1.0) + w[0][3][0].abs() * bezier::derivatives(&w[0], 1.0)[1].abs();
        jump <= 1e-6 * peak + 256.0 * f64::EPSILON * size / (h * h)
    })
}

/// Greatest distance of the curve beyond the walls; 0: it is inside everywhere. Between two samples
/// of the walls and within one piece, θ less the straight wall is a cubic of the parameter: its
/// extremes decide.
pub(super) fn outside(pieces: &[BezierPiece], walls: &Corridor) -> f64 {
    let mut worst = 0.0f64;
    let mut k = 0;
    for p in pieces {
        let (s, q) = (powers(p.map(|v| v[0])), powers(p.map(|v| v[1])));
        let mut from = 0.0;
        while k + 1 < walls.s.len() && from < 1.0 {
            let to = if walls.s[k + 1] >= p[3][0] { 1.0 } else { bezier::parameter(p, walls.s[k + 1]) };
            let length = walls.s[k + 1] - walls.s[k];
            for (wall, sign) in [(&walls.lo, -1.0), (&walls.hi, 1.0)] {
                let m = (wall[k + 1] - wall[k]) / length;
                let beyond = |t: f64| sign * (value(q, t) - wall[k] - m * (value(s, t) - walls.s[k]));
                let d: [f64; 3] = std::array::from_fn(|i| (i as f64 + 1.0) * (q[i + 1] - m * s[i + 1]));
                let inner = roots(d[0], d[1], d[2], from, to).map(beyond).fold(0.0, f64::max);
                worst = worst.max(inner).max(beyond(from)).max(beyond(to));
            }
            from = to;
            if walls.s[k + 1] <= p[3][0] && k + 2 < walls.s.len() {
                k += 1;
            } else if to >= 1.0 {
                break;
            }
        }
    }
    worst
}

/// The artifact of a curve, with its figures.
pub(super) fn schedule(kind: ScheduleKind, pieces: Vec<BezierPiece>, theta: Vec<f64>, channel: &Corridor) -> Schedule {
    let [peak_rate, peak_acceleration, third] = peaks(&pieces);
    let smooth = is_continuous(&pieces, peak_acceleration);
    Schedule {
        kind,
        reversals: reversals(&pieces),
        quality: Quality {
            outside_rad: outside(&pieces, channel),
            peak_third: smooth.then_some(third),
            curvature_continuous: smooth,
            ..Quality::default()
        },
        theta,
        pieces,
        key_points: Vec::new(),
        rates: Vec::new(),
        spread: 1.0,
        peak_rate,
        peak_acceleration,
    }
}

/// The natural cubic spline through angles at the locations, for schedules that are made location
/// by location.
///
/// # Errors
/// Kind `Usage` where a number is not finite.
pub(super) fn through(kind: ScheduleKind, path: &Toolpath, theta: Vec<f64>, channel: &Channel) -> Result<Schedule> {
    let s: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let spline = CubicSpline::new(&s, &theta, 1, &SplineEnds::Natural)
        .map_err(|e| Error::usage(Stage::Schedule, format!("the schedule is no function of arc length: {e}")))?;
    let mut slope: Vec<f64> = (0..s.len() - 1).map(|i| spline.coefficients(i, 0).map_or(0.0, |c| c[1])).collect();
    let last = s.len() - 2;
    let [_, b, c, d] = spline.coefficients(last, 0).unwrap_or_default();
    let h = s[last + 1] - s[last];
    slope.push(b + h * (2.0 * c + 3.0 * h * d));
    let pieces = hermite(&s, &theta, &slope);
    Ok(schedule(kind, pieces, theta, &true_walls(s, channel)))
}

/// The true channel as walls (not its monotone hull).
pub(super) fn true_walls(s_mm: Vec<f64>, channel: &Channel) -> Corridor {
    Corridor {
        s: s_mm,
        lo: channel.rows.iter().map(|r| r.theta_min).collect(),
        hi: channel.rows.iter().map(|r| r.theta_max).collect(),
        one_way: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// θ = s³ − 3 s on −2..2 in four pieces, as cubics in s.
    fn wave() -> Vec<BezierPiece> {
        let s = [-2.0, -0.7, 0.1, 0.9, 2.0];
        let theta = s.map(|s: f64| s * s * s - 3.0 * s);
        let slope = s.map(|s: f64| 3.0 * s * s - 3.0);
        hermite(&s, &theta, &slope)
    }

    #[test]
    fn extremes_between_samples_count() {
        let p = wave();
        assert_eq!(reversals(&p), 2);
        let [rate, second, third] = peaks(&p);
        assert!((rate - 9.0).abs() < 1e-12 && (second - 12.0).abs() < 1e-12 && (third - 6.0).abs() < 1e-9);
        assert!(is_continuous(&p, second));
        assert!(!is_continuous(&hermite(&[0.0, 1.0, 2.0], &[0.0, 1.0, 1.0], &[0.0; 3]), 6.0));
        assert_eq!(reversals(&hermite(&[0.0, 1.0, 2.0], &[0.0, 1.0, 2.0], &[1.0; 3])), 0);
    }

    #[test]
    fn a_bulge_between_samples_is_outside() {
        // The greatest value 2 at s = −1, between the joints −2 and −0.7 and the walls' samples −2
        // and 0.
        let walls = |hi: f64| Corridor { s: vec![-2.0, 0.0, 2.0], lo: vec![-3.0; 3], hi: vec![hi; 3], one_way: true };
        assert!(outside(&wave(), &walls(2.0)) < 1e-12);
        assert!((outside(&wave(), &walls(1.5)) - 0.5).abs() < 1e-12);
        let low = Corridor { s: vec![-2.0, 0.5, 2.0], lo: vec![-2.0, -2.0, -1.7], hi: vec![9.0; 3], one_way: true };
        assert!(outside(&wave(), &low) > 0.05);
    }
}
