//! NURBS pieces as polynomials, for fast evaluation: one table per curve or surface, one polynomial
//! per knot span.
//!
//! Every span runs over [-1, 1] in its own coordinate, so that powers stay small and no digits are
//! lost; above degree [`PLAIN_DEGREE`] spans are cut into [`SHARES`] first. Homogeneous
//! coefficients; where all weights are 1 the quotient rule is left out. Beyond the ends of the
//! domain the first and the last piece are continued.

use nalgebra::Vector4;

use crate::geometry::nurbs::basis::find_span;
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface, SurfaceDerivatives};
use crate::geometry::{Point, Vector};

/// Above this degree the powers of a whole span lose digits.
const PLAIN_DEGREE: usize = 9;
/// Into so many pieces the spans are cut then: high powers of a short piece are small.
const SHARES: usize = 16;
/// A surface of more coefficients than this is evaluated by its B-spline basis, to spare memory.
pub(super) const MOST_COEFFICIENTS: usize = 4_000_000;

type Coefficient = [f64; 4];

/// The spans of one knot vector that have a length.
#[derive(Clone, Debug)]
pub(super) struct Spans {
    /// Their ends: one more than spans.
    pub breaks: Vec<f64>,
}

impl Spans {
    fn new(degree: usize, n: usize, knots: &[f64]) -> Self {
        let mut breaks = knots[degree..=n].to_vec();
        breaks.dedup();
        if degree > PLAIN_DEGREE {
            let last = breaks[breaks.len() - 1];
            let cut = |w: &[f64]| {
                let [from, to] = [w[0], w[1]];
                (0..SHARES).map(move |k| from + (to - from) * k as f64 / SHARES as f64)
            };
            breaks = breaks.windows(2).flat_map(cut).chain([last]).collect();
            breaks.dedup();
        }
        Spans { breaks }
    }
    /// How many.
    pub fn len(&self) -> usize {
        self.breaks.len() - 1
    }
    #[cfg(test)]
    /// The span in which `x` lies; the first or last one beyond the ends.
    pub fn find(&self, x: f64) -> usize {
        self.breaks.partition_point(|b| *b <= x).clamp(1, self.len()) - 1
    }
    /// Middle and half length of a span.
    pub fn frame(&self, k: usize) -> [f64; 2] {
        [0.5 * (self.breaks[k] + self.breaks[k + 1]), 0.5 * (self.breaks[k + 1] - self.breaks[k])]
    }
}

/// The basis functions on a span as polynomials of its own coordinate: `[function][power]`, and the
/// index of the first one.
fn basis_powers(degree: usize, n: usize, knots: &[f64], spans: &Spans, k: usize) -> (usize, Vec<Vec<f64>>) {
    let [middle, half] = spans.frame(k);
    let span = find_span(degree, n, knots, middle);
    let mut value = vec![vec![0.0; degree + 1]; degree + 1];
    value[0][0] = 1.0;
    // Cox and de Boor, each function a polynomial; t = middle + half s.
    for d in 1..=degree {
        let mut saved = vec![0.0; degree + 1];
        for r in 0..d {
            let (right, left) = (knots[span + r + 1], knots[span + 1 + r - d]);
            let width = right - left;
            let scaled: Vec<f64> = value[r].iter().map(|c| if width > 0.0 { c / width } else { 0.0 }).collect();
            value[r] = add(&saved, &times_linear(&scaled, right - middle, -half));
            saved = times_linear(&scaled, middle - left, half);
        }
        value[d] = saved;
    }
    (span - degree, value)
}

fn add(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(x, y)| x + y).collect()
}

/// `c(s) · (a + b s)`; the highest power must be free.
fn times_linear(c: &[f64], a: f64, b: f64) -> Vec<f64> {
    (0..c.len()).map(|k| a * c[k] + if k > 0 { b * c[k - 1] } else { 0.0 }).collect()
}

/// A surface as polynomials.
#[derive(Clone, Debug)]
pub(super) struct SurfaceTable {
    pub degree: [usize; 2],
    pub spans: [Spans; 2],
    /// Per span (u first), per power of s, per power of t.
    coefficients: Vec<Coefficient>,
    rational: bool,
    /// Per direction and break: the normal jumps there (a crease; at the ends of a closed direction
    /// a sharp seam).
    creases: [Vec<bool>; 2],
}

/// Normals on both sides of a break closer than this, sine, are one.
const CREASE: f64 = 1e-5;
/// Ends of the domain nearer than this to each other, mm, are a seam.
const SEAM_MM: f64 = 1e-3;

impl SurfaceTable {
    /// `None` where the table would be larger than [`MOST_COEFFICIENTS`].
    pub fn new(s: &NurbsSurface) -> Option<Self> {
        let spans = [Spans::new(s.degree_u, s.n_u, &s.knots_u), Spans::new(s.degree_v, s.n_v, &s.knots_v)];
        let (p, q) = (s.degree_u, s.degree_v);
        let size = spans[0].len().checked_mul(spans[1].len())?.checked_mul((p + 1) * (q + 1))?;
        if size > MOST_COEFFICIENTS {
            return None;
        }
        let basis_v: Vec<_> = (0..spans[1].len()).map(|k| basis_powers(q, s.n_v, &s.knots_v, &spans[1], k)).collect();
        let mut coefficients = Vec::with_capacity(size);
        for i in 0..spans[0].len() {
            let (first_u, bu) = basis_powers(p, s.n_u, &s.knots_u, &spans[0], i);
            // The row of every control column, already in powers of s.
            let columns: Vec<Vec<Vector4<f64>>> = (0..=p)
                .map(|a| {
                    let at = |j: usize| (0..=p).map(|k| s.points[(first_u + k) * s.n_v + j] * bu[k][a]).sum();
                    (0..s.n_v).map(at).collect()
                })
                .collect();
            for (first_v, bv) in &basis_v {
                for column in &columns {
                    for b in 0..=q {
                        let c: Vector4<f64> = (0..=q).map(|k| column[first_v + k] * bv[k][b]).sum();
                        coefficients.push([c.x, c.y, c.z, c.w]);
                    }
                }
            }
        }
        let rational = s.points.iter().any(|p| p.w != 1.0);
        let mut table =
            SurfaceTable { degree: [p, q], spans, coefficients, rational, creases: [Vec::new(), Vec::new()] };
        table.creases = [0, 1].map(|a| table.creases_along(a));
        Some(table)
    }

    /// Looks at both sides of every break along one direction, at places spread over the other.
    fn creases_along(&self, along: usize) -> Vec<bool> {
        let (n, m) = (self.spans[along].len(), self.spans[1 - along].len());
        let at = |span: usize, other: usize, end: f64, t: f64| {
            let turn = |x: usize, y: usize| if along == 0 { [x, y] } else { [y, x] };
            let st = if along == 0 { [end, t] } else { [t, end] };
            self.local(turn(span, other), st)
        };
        let jumps = |before: usize, after: usize| {
            (0..m).any(|other| {
                [-0.9, 0.1, 0.8].into_iter().any(|t| {
                    let (a, b) = (at(before, other, 1.0, t), at(after, other, -1.0, t));
                    // Sides that do not meet are edges of the face, and edges are searched by
                    // themselves.
                    let (Some(x), Some(y)) = (a.normal(), b.normal()) else { return true };
                    (a.p - b.p).norm() < SEAM_MM && (x - y).norm() > CREASE
                })
            })
        };
        let ends = jumps(n - 1, 0);
        (0..=n).map(|k| if k == 0 || k == n { ends } else { jumps(k - 1, k) }).collect()
    }

    /// Whether the normal jumps at the beginning or the end of a span.
    pub fn creased(&self, along: usize, span: usize, end: usize) -> bool {
        self.creases[along].get(span + end).copied().unwrap_or(true)
    }

    /// Coefficients of a span, `[power of s][power of t]`.
    pub fn piece(&self, span: [usize; 2]) -> &[Coefficient] {
        let size = (self.degree[0] + 1) * (self.degree[1] + 1);
        let k = (span[0] * self.spans[1].len() + span[1]) * size;
        &self.coefficients[k..k + size]
    }

    /// Point and derivatives by the span's own coordinates.
    pub fn local(&self, span: [usize; 2], st: [f64; 2]) -> SurfaceDerivatives {
        let c = self.piece(span);
        // Degrees known when compiled make loops without tests.
        let h = match self.degree {
            [3, 3] => horner(c, 3, 3, st),
            [2, 2] => horner(c, 2, 2, st),
            [1, 1] => horner(c, 1, 1, st),
            [2, 1] => horner(c, 2, 1, st),
            [1, 2] => horner(c, 1, 2, st),
            [3, 1] => horner(c, 3, 1, st),
            [1, 3] => horner(c, 1, 3, st),
            [2, 3] => horner(c, 2, 3, st),
            [3, 2] => horner(c, 3, 2, st),
            [5, 3] => horner(c, 5, 3, st),
            [3, 5] => horner(c, 3, 5, st),
            [5, 5] => horner(c, 5, 5, st),
            [p, q] => horner(c, p, q, st),
        };
        if self.rational { quotient(&h) } else { plain(&h) }
    }
}

#[inline(always)]
fn times_add(a: Coefficient, x: f64, b: Coefficient) -> Coefficient {
    [a[0] * x + b[0], a[1] * x + b[1], a[2] * x + b[2], a[3] * x + b[3]]
}

/// Homogeneous value and derivatives (·, s, t, ss, st, tt), by Horner's rule along t, then along s.
#[inline(always)]
fn horner(c: &[Coefficient], p: usize, q: usize, [s, t]: [f64; 2]) -> [Coefficient; 6] {
    const ZERO: Coefficient = [0.0; 4];
    let mut h = [ZERO; 6];
    for a in (0..=p).rev() {
        let row = &c[a * (q + 1)..(a + 1) * (q + 1)];
        // Value, first and half the second derivative along t.
        let (mut r0, mut r1, mut r2) = (row[q], ZERO, ZERO);
        for b in (0..q).rev() {
            r2 = times_add(r2, t, r1);
            r1 = times_add(r1, t, r0);
            r0 = times_add(r0, t, row[b]);
        }
        // The same along s.
        h[3] = times_add(h[3], s, h[1]);
        h[1] = times_add(h[1], s, h[0]);
        h[0] = times_add(h[0], s, r0);
        h[4] = times_add(h[4], s, h[2]);
        h[2] = times_add(h[2], s, r1);
        h[5] = times_add(h[5], s, r2);
    }
    h[3] = h[3].map(|x| 2.0 * x);
    h[5] = h[5].map(|x| 2.0 * x);
    h
}

fn vector(c: &Coefficient) -> Vector {
    Vector::new(c[0], c[1], c[2])
}

fn plain(h: &[Coefficient; 6]) -> SurfaceDerivatives {
    SurfaceDerivatives {
        p: Point::from(vector(&h[0])),
        du: vector(&h[1]),
        dv: vector(&h[2]),
        duu: vector(&h[3]),
        duv: vector(&h[4]),
        dvv: vector(&h[5]),
    }
}

/// The quotient rule (*The NURBS Book* eq. 4.20).
fn quotient(h: &[Coefficient; 6]) -> SurfaceDerivatives {
    let w = 1.0 / h[0][3];
    let p = vector(&h[0]) * w;
    let du = (vector(&h[1]) - p * h[1][3]) * w;
    let dv = (vector(&h[2]) - p * h[2][3]) * w;
    SurfaceDerivatives {
        p: Point::from(p),
        du,
        dv,
        duu: (vector(&h[3]) - du * (2.0 * h[1][3]) - p * h[3][3]) * w,
        duv: (vector(&h[4]) - du * h[2][3] - dv * h[1][3] - p * h[4][3]) * w,
        dvv: (vector(&h[5]) - dv * (2.0 * h[2][3]) - p * h[5][3]) * w,
    }
}

/// A curve as polynomials.
#[derive(Clone, Debug)]
pub(super) struct CurveTable {
    pub degree: usize,
    pub spans: Spans,
    coefficients: Vec<Coefficient>,
}

impl CurveTable {
    /// The curve's table.
    pub fn new(c: &NurbsCurve) -> Self {
        let spans = Spans::new(c.degree, c.points.len(), &c.knots);
        let mut coefficients = Vec::with_capacity(spans.len() * (c.degree + 1));
        for k in 0..spans.len() {
            let (first, basis) = basis_powers(c.degree, c.points.len(), &c.knots, &spans, k);
            for a in 0..=c.degree {
                let h: Vector4<f64> = (0..=c.degree).map(|j| c.points[first + j] * basis[j][a]).sum();
                coefficients.push([h.x, h.y, h.z, h.w]);
            }
        }
        CurveTable { degree: c.degree, spans, coefficients }
    }

    /// Coefficients of a span by power.
    pub fn piece(&self, span: usize) -> &[Coefficient] {
        &self.coefficients[span * (self.degree + 1)..(span + 1) * (self.degree + 1)]
    }

    /// Point, first and second derivative by the span's own coordinate.
    pub fn local(&self, span: usize, s: f64) -> (Point, Vector, Vector) {
        let (mut h0, mut h1, mut h2) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for c in self.piece(span).iter().rev() {
            h2 = times_add(h2, s, h1);
            h1 = times_add(h1, s, h0);
            h0 = times_add(h0, s, *c);
        }
        let w = 1.0 / h0[3];
        let p = vector(&h0) * w;
        let d1 = (vector(&h1) - p * h1[3]) * w;
        let d2 = (vector(&h2) * 2.0 - d1 * (2.0 * h1[3]) - p * (2.0 * h2[3])) * w;
        (Point::from(p), d1, d2)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::nurbs::shapes::{cylinder, loft, sphere, torus};
    use crate::geometry::tessellate::edges::iso_curve;

    /// A curve of degree 18: its spans are cut, and no digits are lost.
    #[test]
    fn high_degrees_keep_their_digits() {
        let degree = 18;
        let point = |k: usize| {
            let a = 0.3 * k as f64;
            Vector4::new(100.0 * a.cos(), 100.0 * a.sin(), 7.0 * a, 1.0 + 0.2 * (k % 3) as f64)
        };
        let knots = std::iter::repeat_n(0.0, degree + 1).chain([0.4]).chain(std::iter::repeat_n(1.0, degree + 1));
        let curve = NurbsCurve { degree, knots: knots.collect(), points: (0..degree + 2).map(point).collect() };
        let table = CurveTable::new(&curve);
        assert_eq!(table.spans.len(), 2 * SHARES);
        for i in 0..=300 {
            let t = f64::from(i) / 300.0;
            let span = table.spans.find(t);
            let [m, h] = table.spans.frame(span);
            let (p, d1, _) = table.local(span, (t - m) / h);
            let e = curve.derivatives(t);
            assert!((p - e.0).norm() < 1e-10 && (d1 / h - e.1).norm() < 1e-7, "{t}: {}", (p - e.0).norm());
        }
    }

    #[test]
    fn polynomials_are_the_surface() {
        for s in [cylinder(3.0, 10.0), sphere(4.0), torus(10.0, 3.0), loft()] {
            let table = SurfaceTable::new(&s).unwrap();
            for i in 0..=40 {
                for j in 0..=40 {
                    let uv = [f64::from(i) / 40.0, f64::from(j) / 40.0];
                    let span = [0, 1].map(|a| table.spans[a].find(uv[a]));
                    let frame = [0, 1].map(|a| table.spans[a].frame(span[a]));
                    let d = table.local(span, [0, 1].map(|a| (uv[a] - frame[a][0]) / frame[a][1]));
                    let e = s.derivatives(uv[0], uv[1]);
                    let [h, k] = [frame[0][1], frame[1][1]];
                    assert!((d.p - e.p).norm() < 1e-12);
                    assert!((d.du - e.du * h).norm() < 1e-11 && (d.dv - e.dv * k).norm() < 1e-11);
                    assert!((d.duu - e.duu * h * h).norm() < 1e-10 && (d.dvv - e.dvv * k * k).norm() < 1e-10);
                    assert!((d.duv - e.duv * h * k).norm() < 1e-10);
                }
            }
            let curve = iso_curve(&s, 0, 0.3);
            let table = CurveTable::new(&curve);
            for i in 0..=40 {
                let t = f64::from(i) / 40.0;
                let span = table.spans.find(t);
                let [m, h] = table.spans.frame(span);
                let (p, d1, d2) = table.local(span, (t - m) / h);
                let e = curve.derivatives(t);
                assert!((p - e.0).norm() < 1e-12 && (d1 - e.1 * h).norm() < 1e-11 && (d2 - e.2 * h * h).norm() < 1e-10);
            }
        }
    }
}
