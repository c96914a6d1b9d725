//! Curves of edges compared and cut.

use crate::geometry::brep::Edge;
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::fit::split_curve;
use crate::geometry::{Aabb, Point};

/// Samples of a curve where a foot point is sought.
const SAMPLES: usize = 128;
/// Samples for the box of an edge.
const BOX_SAMPLES: u32 = 64;

/// The same curve walked backwards over the same parameters.
#[must_use]
pub fn backwards(curve: &NurbsCurve) -> NurbsCurve {
    let [a, b] = curve.domain();
    NurbsCurve {
        degree: curve.degree,
        knots: curve.knots.iter().rev().map(|k| a + b - k).collect(),
        points: curve.points.iter().rev().copied().collect(),
    }
}

/// A closed curve that begins and ends at the vertex; the curve itself where it does so already or
/// cannot be cut there.
#[must_use]
pub fn from_vertex(curve: NurbsCurve, vertex: &Point, tolerance_mm: f64) -> NurbsCurve {
    let [t0, t1] = curve.domain();
    if (curve.point(t0) - vertex).norm() <= tolerance_mm || (curve.point(t0) - curve.point(t1)).norm() > tolerance_mm {
        return curve;
    }
    let (t, distance_mm) = foot(&curve, [t0, t1], vertex);
    if distance_mm > 10.0 * tolerance_mm {
        return curve;
    }
    let Ok((first, second)) = split_curve(&curve, t) else { return curve };
    let (Some(end), Some(start)) = (second.points.last(), first.points.first()) else { return curve };
    // Both halves meet at the old start; a common factor of homogeneous points leaves a curve as it
    // is.
    let scale = end.w / start.w;
    let degree = curve.degree;
    let mut knots = second.knots[..second.knots.len() - 1].to_vec();
    knots.extend(first.knots[degree + 1..].iter().map(|k| k + (t1 - t0)));
    let mut points = second.points.clone();
    points.extend(first.points[1..].iter().map(|p| p * scale));
    NurbsCurve { degree, knots, points }
}

/// Parameter and distance of the point of the curve closest to `q`: sampled, then narrowed by
/// golden section about every sample beside which it may lie. On a closed curve both ends are
/// equally near to what lies beside its beginning.
pub fn foot(curve: &NurbsCurve, t: [f64; 2], q: &Point) -> (f64, f64) {
    let at = |k: usize| t[0] + (t[1] - t[0]) * k as f64 / SAMPLES as f64;
    let distance = |t: f64| (curve.point(t) - q).norm();
    let points: Vec<Point> = (0..=SAMPLES).map(|k| curve.point(at(k))).collect();
    let off: Vec<f64> = points.iter().map(|p| (p - q).norm()).collect();
    let nearest = (0..=SAMPLES).min_by(|&i, &j| off[i].total_cmp(&off[j])).unwrap_or(0);
    let may_be_beside = |k: &usize| {
        let sides = [k.saturating_sub(1), (k + 1).min(SAMPLES)];
        let step_mm = sides.map(|j| (points[j] - points[*k]).norm());
        let is_least = sides.iter().all(|j| off[*k] <= off[*j]);
        *k == nearest || is_least && off[*k] - step_mm[0].max(step_mm[1]) < off[nearest]
    };
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let narrowed = (0..=SAMPLES).filter(may_be_beside).flat_map(|k| {
        let (mut a, mut b) = (at(k.saturating_sub(1)), at((k + 1).min(SAMPLES)));
        for _ in 0..48 {
            let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
            if distance(c) < distance(d) { b = d } else { a = c }
        }
        // The ends of the interval are feet of their own.
        [0.5 * (a + b), at(k)]
    });
    narrowed.map(|t| (t, distance(t))).min_by(|x, y| x.1.total_cmp(&y.1)).unwrap_or((t[0], 0.0))
}

/// Begin and end of an edge.
pub fn ends(e: &Edge) -> [Point; 2] {
    e.t.map(|t| e.curve.point(t))
}

/// Length of an edge by chords, mm: never more than the true one.
pub fn length(e: &Edge) -> f64 {
    (0..32).map(|k| (e.at(f64::from(k + 1) / 32.0) - e.at(f64::from(k) / 32.0)).norm()).sum()
}

/// Box of an edge from samples: it may miss extremes by [`slack`].
pub fn hull(e: &Edge) -> Aabb {
    let first = e.at(0.0);
    (1..=BOX_SAMPLES).fold(Aabb { min: first, max: first }, |b, k| {
        let p = e.at(f64::from(k) / f64::from(BOX_SAMPLES));
        Aabb { min: b.min.inf(&p), max: b.max.sup(&p) }
    })
}

/// What the box of an edge may miss: a few hundredths of its size, however unevenly the parameter
/// runs.
pub fn slack(b: &Aabb) -> f64 {
    0.03 * b.diagonal_mm()
}

/// Whether two edges are the same curve: (they run in opposite senses, greatest distance found).
pub fn coincide(a: &Edge, b: &Edge, tolerance_mm: f64) -> Option<(bool, f64)> {
    let ([a0, a1], [b0, b1]) = (ends(a), ends(b));
    let same = (a0 - b0).norm().max((a1 - b1).norm());
    let crossed = (a0 - b1).norm().max((a1 - b0).norm());
    if same.min(crossed) > tolerance_mm {
        return None;
    }
    let mut gap_mm = same.min(crossed);
    // Places of one on the other, and one back: a curve may run along a part of another.
    let places = (1..8).map(|k| (a, b, f64::from(k) / 8.0)).chain([(b, a, 0.37), (b, a, 0.71)]);
    for (of, on, share) in places {
        gap_mm = gap_mm.max(foot(&on.curve, on.t, &of.at(share)).1);
        if gap_mm > tolerance_mm {
            return None;
        }
    }
    if same.max(crossed) > tolerance_mm {
        return Some((crossed < same, gap_mm));
    }
    // Closed edges: their ends say nothing, so the order of two points on the way does.
    let place = |s: f64| (foot(&b.curve, b.t, &a.at(s)).0 - b.t[0]) / (b.t[1] - b.t[0]);
    // Over a third of the way round, taken on the short way, so that it does not matter where each
    // begins.
    let step = (place(0.65) - place(0.35)).rem_euclid(1.0);
    Some((step > 0.5, gap_mm))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use nalgebra::Vector4;

    use super::*;

    /// A full circle of radius 2 about (1, 0, 0) in the plane z = 0, from (3, 0, 0).
    fn circle() -> NurbsCurve {
        let w = std::f64::consts::FRAC_1_SQRT_2;
        let corners = [(1., 0.), (1., 1.), (0., 1.), (-1., 1.), (-1., 0.), (-1., -1.), (0., -1.), (1., -1.), (1., 0.)];
        let points = corners
            .iter()
            .enumerate()
            .map(|(k, &(x, y))| {
                let w = if k % 2 == 1 { w } else { 1.0 };
                Vector4::new((1.0 + 2.0 * x) * w, 2.0 * y * w, 0.0, w)
            })
            .collect();
        NurbsCurve { degree: 2, knots: vec![0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 4.], points }
    }

    #[test]
    fn closed_curves_begin_at_their_vertex() {
        for angle in [0.0_f64, 0.3, 1.9, 3.1, 5.0] {
            let v = Point::new(1.0 + 2.0 * angle.cos(), 2.0 * angle.sin(), 0.0);
            let c = from_vertex(circle(), &v, 1e-6);
            c.validate().unwrap();
            let [t0, t1] = c.domain();
            assert!((c.point(t0) - v).norm() < 1e-6 && (c.point(t1) - v).norm() < 1e-6, "{angle}");
            for k in 0..=100 {
                let p = c.point(t0 + (t1 - t0) * f64::from(k) / 100.0);
                assert!(((p - Point::new(1.0, 0.0, 0.0)).norm() - 2.0).abs() < 1e-12, "{angle}");
            }
            // Still counter-clockwise.
            let q = c.point(t0 + 0.05 * (t1 - t0));
            assert!((v.x - 1.0) * q.y - v.y * (q.x - 1.0) > 0.0);
        }
    }

    #[test]
    fn walking_backwards_visits_the_same_points() {
        let (c, b) = (circle(), backwards(&circle()));
        for k in 0..=20 {
            let t = 4.0 * f64::from(k) / 20.0;
            assert!((c.point(t) - b.point(4.0 - t)).norm() < 1e-12);
        }
    }
}
