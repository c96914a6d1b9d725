//! How far the curve is from where the part wants it, proven between places that are measured.
//!
//! Over an interval of the curve let `|c'|² + D |c''| ≤ M`, with `D` no less than the distance of
//! the curve from those points of the part that are nearest to a place of it. The square of the
//! distance to one such point `p` has a second derivative of `2 |c'|² + 2 (c − p)·c'' ≤ 2 M`. So
//! `d²(s) − M s²` is the least of concave functions, hence concave, and over an interval of length
//! `L` with distances `d₀`, `d₁` at its ends
//! ```text
//! d²(t) ≥ (1 − t) d₀² + t d₁² − t (1 − t) M L²
//! ```
//! whatever the part looks like. From above, `d² ≤ |c − p|²` for the foot `p` of either end, which
//! Taylor's formula bounds with the same `M`. An interval is halved until both bounds are good
//! enough.

use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};
use crate::numerics::quintic::{self, Breaks, ORDER, apply};
use crate::parallel;

/// Intervals are not halved below this length, mm.
const SHORTEST_MM: f64 = 1e-4;

/// What was proven.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Proof {
    /// No place of the ball is deeper in the part, mm; at least 0.
    pub inwards_mm: f64,
    /// No place of the ball is farther off the part, mm; at least 0.
    pub outwards_mm: f64,
}

impl Proof {
    const LOST: Proof = Proof { inwards_mm: f64::INFINITY, outwards_mm: f64::INFINITY };

    fn and(self, other: Self) -> Self {
        Proof {
            inwards_mm: self.inwards_mm.max(other.inwards_mm),
            outwards_mm: self.outwards_mm.max(other.outwards_mm),
        }
    }
}

#[derive(Clone, Copy)]
struct ProofPlace {
    t: f64,
    distance: f64,
    /// Half the derivative of the squared distance from the foot.
    slope: f64,
}

/// Proves, span by span, that the ball is no deeper in the part than `limits[0]` and no farther off
/// than `limits[1]`, mm; where it is, the proof says by how much. Infinite where the part is
/// nowhere near.
pub(super) fn prove(part: &Allowed, radius_mm: f64, breaks: &Breaks, x: &[[f64; 3]], limits: [f64; 2]) -> Vec<Proof> {
    let of = |i: usize| {
        let ordinates = apply(&breaks.ordinates(i, breaks.span(i)), &x[i..]);
        span(part, radius_mm, breaks.span(i), &ordinates, limits).unwrap_or(Proof::LOST)
    };
    parallel::map_short(16, 0..breaks.spans(), of)
}

/// The worst of all.
pub(super) fn worst(proofs: &[Proof]) -> Proof {
    proofs.iter().fold(Proof::default(), |a, b| a.and(*b))
}

fn span(part: &Allowed, radius: f64, [a, b]: [f64; 2], o: &[[f64; 3]; ORDER], limits: [f64; 2]) -> Option<Proof> {
    let h = b - a;
    let o: [Vector; ORDER] = o.map(Vector::from);
    let first = (0..5).map(|j| (o[j + 1] - o[j]).norm()).fold(0.0, f64::max) * 5.0 / h;
    let second = (0..4).map(|j| (o[j + 2] - o[j + 1] * 2.0 + o[j]).norm()).fold(0.0, f64::max) * 20.0 / (h * h);
    let cap = 2.0 * radius + h * first;
    let ordinates = o.map(<[f64; 3]>::from);
    let see = |t: f64| {
        let at = quintic::at(&ordinates, h, t);
        let c = Point::from(at[0]);
        let near = part.closest(&c, cap)?;
        let away = (c - near.point).try_normalize(1e-12)? * near.distance_mm;
        Some(ProofPlace { t, distance: near.distance_mm, slope: away.dot(&Vector::from(at[1])) })
    };
    let (start, end) = (see(0.0)?, see(1.0)?);
    let mut open = vec![(start, end)];
    let mut proven = [0.0_f64; 2];
    while let Some((p, q)) = open.pop() {
        let length = (q.t - p.t) * h;
        // Nearest points of places between are no farther from any of these than so.
        let far = p.distance.max(q.distance) + 2.0 * first * length;
        let m = first * first + far * second;
        let inwards = radius - least(p.distance, q.distance, m * length * length);
        let half = 0.5 * length;
        let most = |d: f64, slope: f64| (d * d + (2.0 * slope * half).max(0.0) + m * half * half).sqrt();
        let outwards = most(p.distance, p.slope).max(most(q.distance, -q.slope)) - radius;
        if inwards <= limits[0] && outwards <= limits[1] || length < SHORTEST_MM {
            proven = [proven[0].max(inwards), proven[1].max(outwards)];
            continue;
        }
        // Where the place itself is beyond the limit, halving does not help.
        let beyond = |p: &ProofPlace| radius - p.distance > limits[0] || p.distance - radius > limits[1];
        if (beyond(&p) || beyond(&q)) && length < 0.02 * h {
            proven = [proven[0].max(inwards), proven[1].max(outwards)];
            continue;
        }
        let middle = see(0.5 * (p.t + q.t))?;
        open.push((p, middle));
        open.push((middle, q));
    }
    Some(Proof { inwards_mm: proven[0].max(0.0), outwards_mm: proven[1].max(0.0) })
}

/// Least of `(1 − t) d₀² + t d₁² − t (1 − t) m` over `0 ≤ t ≤ 1`, as a distance.
fn least(d0: f64, d1: f64, m: f64) -> f64 {
    let (a, b) = (d0 * d0, d1 * d1);
    if m == 0.0 {
        return d0.min(d1);
    }
    let t = (0.5 * (1.0 - (b - a) / m)).clamp(0.0, 1.0);
    ((1.0 - t) * a + t * b - t * (1.0 - t) * m).max(0.0).sqrt()
}
