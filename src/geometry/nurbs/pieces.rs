//! NURBS curves and surfaces as Bézier pieces: restricted to a range, raised in degree, brought
//! onto common knots, joined.
//!
//! Control points of a piece are values of the blossom (Ramshaw, *Blossoming: a connect-the-dots
//! approach to splines*, 1987): exact, and indifferent to whether the knots are clamped. The price
//! is that inner knots become as many as the degree; the shape stays as smooth as it was.

use nalgebra::Vector4;

use super::basis::find_span;
use super::{NurbsCurve, NurbsSurface};

type Pole = Vector4<f64>;

/// Distinct knots within a range, its ends included.
fn breaks(degree: usize, n: usize, knots: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
    let mut out = vec![from];
    out.extend(knots[degree..=n].iter().copied().filter(|k| *k > from && *k < to));
    out.push(to);
    out.dedup();
    out
}

/// Control points of the piece from `a` to `b`, which no knot may lie between.
fn piece(degree: usize, knots: &[f64], points: &[Pole], a: f64, b: f64) -> Vec<Pole> {
    let span = find_span(degree, points.len(), knots, 0.5 * (a + b));
    let blossom = |bs: usize| {
        let mut d = points[span - degree..=span].to_vec();
        for r in 1..=degree {
            let t = if r <= bs { b } else { a };
            for j in (r..=degree).rev() {
                let i = span - degree + j;
                let s = (t - knots[i]) / (knots[i + degree - r + 1] - knots[i]);
                d[j] = d[j - 1] * (1.0 - s) + d[j] * s;
            }
        }
        d[degree]
    };
    (0..=degree).map(blossom).collect()
}

/// The same Bézier piece with more control points.
fn elevated(mut points: Vec<Pole>, degree: usize) -> Vec<Pole> {
    while points.len() <= degree {
        let n = points.len() as f64;
        let inner = points.windows(2).enumerate().map(|(i, w)| {
            let s = (i + 1) as f64 / n;
            w[0] * s + w[1] * (1.0 - s)
        });
        let mut next = vec![points[0]];
        next.extend(inner);
        next.extend(points.last());
        points = next;
    }
    points
}

/// Knots of a chain of Bézier pieces between these breaks.
fn chain_knots(breaks: &[f64], degree: usize) -> Vec<f64> {
    let last = breaks.len() - 1;
    let fold = |i: usize| degree + usize::from(i == 0 || i == last);
    breaks.iter().enumerate().flat_map(|(i, b)| std::iter::repeat_n(*b, fold(i))).collect()
}

/// Pieces between `at` (which must hold all inner knots) as control points of one chain.
fn chain_points(degree: usize, knots: &[f64], points: &[Pole], at: &[f64], to_degree: usize) -> Vec<Pole> {
    let mut out = Vec::with_capacity((at.len() - 1) * to_degree + 1);
    for w in at.windows(2) {
        let one = elevated(piece(degree, knots, points, w[0], w[1]), to_degree);
        out.extend_from_slice(&one[usize::from(!out.is_empty())..]);
    }
    out
}

/// The part of a valid curve over a range of its domain (not empty), clamped.
#[must_use]
pub fn part(curve: &NurbsCurve, range: [f64; 2]) -> NurbsCurve {
    let at = breaks(curve.degree, curve.points.len(), &curve.knots, range);
    let points = chain_points(curve.degree, &curve.knots, &curve.points, &at, curve.degree);
    NurbsCurve { degree: curve.degree, knots: chain_knots(&at, curve.degree), points }
}

/// The same curve over another range of its parameter.
#[must_use]
pub fn over(mut curve: NurbsCurve, [from, to]: [f64; 2]) -> NurbsCurve {
    let [a, b] = curve.domain();
    let map = |k: f64| if k == b { to } else { from + (k - a) / (b - a) * (to - from) };
    curve.knots.iter_mut().for_each(|k| *k = map(*k));
    curve
}

/// Two valid curves with the same domain on common knots and of the same degree.
#[must_use]
pub fn alike(a: &NurbsCurve, b: &NurbsCurve) -> [NurbsCurve; 2] {
    let degree = a.degree.max(b.degree);
    let mut at = breaks(a.degree, a.points.len(), &a.knots, a.domain());
    at.extend(breaks(b.degree, b.points.len(), &b.knots, a.domain()));
    at.sort_by(f64::total_cmp);
    // Breaks that differ by rounding only would leave a piece of no length.
    let least = 1e-12 * (a.domain()[1] - a.domain()[0]);
    at.dedup_by(|x, y| *x - *y <= least);
    let end = at.len() - 1;
    at[end] = a.domain()[1];
    [a, b].map(|c| NurbsCurve {
        degree,
        knots: chain_knots(&at, degree),
        points: chain_points(c.degree, &c.knots, &c.points, &at, degree),
    })
}

/// Valid curves one behind the other as one curve, each as long in the parameter as it was; `None`
/// without curves. The end of a curve and the begin of the next should be the same point; the
/// former stays.
#[must_use]
pub fn joined(curves: &[NurbsCurve]) -> Option<NurbsCurve> {
    let degree = curves.iter().map(|c| c.degree).max()?;
    let mut at = vec![curves[0].domain()[0]];
    let mut points: Vec<Pole> = Vec::new();
    for c in curves {
        let own = breaks(c.degree, c.points.len(), &c.knots, c.domain());
        let more = chain_points(c.degree, &c.knots, &c.points, &own, degree);
        let shift = at[at.len() - 1] - own[0];
        at.extend(own[1..].iter().map(|t| t + shift));
        // A common factor of homogeneous points leaves a curve as it is.
        let factor = points.last().map_or(1.0, |p| p.w / more[0].w);
        let skip = usize::from(!points.is_empty());
        points.extend(more[skip..].iter().map(|p| p * factor));
    }
    Some(NurbsCurve { degree, knots: chain_knots(&at, degree), points })
}

/// The part of a valid surface over a rectangle of its domain (not empty), clamped.
#[must_use]
pub fn surface_part(s: &NurbsSurface, range: [[f64; 2]; 2]) -> NurbsSurface {
    transposed(&part_u(&transposed(&part_u(s, range[0])), range[1]))
}

fn part_u(s: &NurbsSurface, range: [f64; 2]) -> NurbsSurface {
    let at = breaks(s.degree_u, s.n_u, &s.knots_u, range);
    let columns: Vec<Vec<Pole>> = (0..s.n_v)
        .map(|j| {
            let column: Vec<Pole> = (0..s.n_u).map(|i| s.points[i * s.n_v + j]).collect();
            chain_points(s.degree_u, &s.knots_u, &column, &at, s.degree_u)
        })
        .collect();
    let n_u = (at.len() - 1) * s.degree_u + 1;
    let points = (0..n_u).flat_map(|i| columns.iter().map(move |c| c[i])).collect();
    NurbsSurface { knots_u: chain_knots(&at, s.degree_u), n_u, points, ..s.clone() }
}

/// The surface with u and v changed over; its normal points the other way.
#[must_use]
pub fn transposed(s: &NurbsSurface) -> NurbsSurface {
    NurbsSurface {
        degree_u: s.degree_v,
        degree_v: s.degree_u,
        knots_u: s.knots_v.clone(),
        knots_v: s.knots_u.clone(),
        n_u: s.n_v,
        n_v: s.n_u,
        points: (0..s.n_v).flat_map(|j| (0..s.n_u).map(move |i| s.points[i * s.n_v + j])).collect(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::nurbs::shapes::{loft, torus};

    /// A rational cubic over unclamped knots.
    fn unclamped() -> NurbsCurve {
        let points = (0..7)
            .map(|i| {
                let (x, w) = (f64::from(i), 1.0 + 0.3 * f64::from(i % 3));
                Pole::new(x * w, (x * 1.3).sin() * w, 0.2 * x * x * w, w)
            })
            .collect();
        NurbsCurve { degree: 3, knots: vec![-2.0, -1.5, -1.0, 0.0, 0.7, 1.0, 2.0, 3.0, 3.5, 4.0, 5.0], points }
    }

    #[test]
    fn parts_are_the_same_curve() {
        let c = unclamped();
        c.validate().unwrap();
        for range in [c.domain(), [0.3, 0.6], [0.3, 1.9]] {
            let p = part(&c, range);
            p.validate().unwrap();
            assert_eq!(p.domain(), range);
            for k in 0..=50 {
                let t = range[0] + (range[1] - range[0]) * f64::from(k) / 50.0;
                assert!((p.point(t) - c.point(t)).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn alike_and_joined_keep_the_shape() {
        let a = over(unclamped(), [0.0, 1.0]);
        let b = NurbsCurve {
            degree: 1,
            knots: vec![0.0, 0.0, 0.4, 1.0, 1.0],
            points: [[0.0, 0.0], [1.0, 2.0], [5.0, 1.0]].map(|p| Pole::new(p[0], p[1], 0.0, 1.0)).to_vec(),
        };
        let [x, y] = alike(&a, &b);
        assert_eq!((x.degree, &x.knots), (y.degree, &y.knots));
        for k in 0..=40 {
            let t = f64::from(k) / 40.0;
            assert!((x.point(t) - a.point(t)).norm() < 1e-12 && (y.point(t) - b.point(t)).norm() < 1e-12);
        }
        let one = joined(&[part(&a, [0.0, 0.5]), part(&a, [0.5, 1.0])]).unwrap();
        one.validate().unwrap();
        for k in 0..=40 {
            let t = f64::from(k) / 40.0;
            assert!((one.point(t) - a.point(t)).norm() < 1e-12);
        }
        assert!(joined(&[]).is_none());
    }

    #[test]
    fn parts_of_surfaces() {
        for s in [loft(), torus(10.0, 3.0)] {
            let range = [[0.1, 0.7], [0.3, 1.0]];
            let p = surface_part(&s, range);
            p.validate().unwrap();
            assert_eq!(p.domain(), range);
            for i in 0..=10 {
                for j in 0..=10 {
                    let (u, v) = (0.1 + 0.06 * f64::from(i), 0.3 + 0.07 * f64::from(j));
                    assert!((p.point(u, v) - s.point(u, v)).norm() < 1e-11);
                    assert!((transposed(&s).point(v, u) - s.point(u, v)).norm() < 1e-12);
                }
            }
        }
    }
}
