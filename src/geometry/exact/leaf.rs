//! Small pieces of faces and of edges, each with a box turned along it, in which it lies, and the
//! range of its curvature.
//!
//! The box of a polynomial piece is that of its Bézier control points, in whose convex hull it lies
//! (*The NURBS Book* P4.10): a true bound. Curvature and the turn of the normal are taken at 3 × 3
//! places, with half of what they differ by as a margin: a measured range, right where they change
//! steadily over a piece, and no proof.

use super::patch::{CurveTable, SurfaceTable};
use crate::geometry::nurbs::{NurbsSurface, SurfaceDerivatives};
use crate::geometry::{Point, Vector};

/// The rounding of a box, as a share of the coordinates.
const ROUNDING: f64 = 1e-14;
/// Samples along each direction of a piece that is no polynomial of moderate degree.
const SAMPLES: usize = 7;

/// How one face is evaluated: in coordinates of a span.
pub(super) struct FaceForm<'a> {
    pub surface: &'a NurbsSurface,
    pub table: Option<&'a SurfaceTable>,
}

impl FaceForm<'_> {
    /// Middle and half length of a span along u (0) or v (1).
    pub fn frame(&self, along: usize, span: u32) -> [f64; 2] {
        match self.table {
            Some(t) => t.spans[along].frame(span as usize),
            None => {
                let [from, to] = self.surface.domain()[along];
                [0.5 * (from + to), 0.5 * (to - from)]
            }
        }
    }
    /// Number of spans along u or v.
    pub fn spans(&self, along: usize) -> usize {
        self.table.map_or(1, |t| t.spans[along].len())
    }
    /// Point and derivatives by the span's coordinates.
    #[inline]
    pub fn local(&self, span: [u32; 2], st: [f64; 2]) -> SurfaceDerivatives {
        if let Some(t) = self.table {
            return t.local(span.map(|s| s as usize), st);
        }
        let [u, v] = [0, 1].map(|a| self.frame(a, span[a]));
        let mut d = self.surface.derivatives(u[0] + u[1] * st[0], v[0] + v[1] * st[1]);
        d.du *= u[1];
        d.dv *= v[1];
        d.duu *= u[1] * u[1];
        d.duv *= u[1] * v[1];
        d.dvv *= v[1] * v[1];
        d
    }
    /// Whether a side of a rectangle lies on a crease, or whether that is not known.
    pub fn sharp(&self, rect: &Rect) -> bool {
        let Some(t) = self.table else { return true };
        let side = |a: usize, end: usize| {
            (rect.range[a][end].abs() - 1.0).abs() < 1e-12 && t.creased(a, rect.span[a] as usize, end)
        };
        (0..4).any(|k| side(k / 2, k % 2))
    }
    /// From a span's coordinates to the face's parameters.
    pub fn uv(&self, span: [u32; 2], st: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|a| {
            let [m, h] = self.frame(a, span[a]);
            m + h * st[a]
        })
    }
}

/// A rectangle of one span of one face, in the span's coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rect {
    pub face: u32,
    pub span: [u32; 2],
    /// `[along][from, to]`.
    pub range: [[f64; 2]; 2],
}

impl Rect {
    pub fn middle(&self) -> [f64; 2] {
        self.range.map(|[a, b]| 0.5 * (a + b))
    }
    /// The places at which what is not bounded by control points is measured: corners, middles of
    /// the sides, middle.
    pub fn places(&self) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [s, t] = self.range.map(|[a, b]| [a, 0.5 * (a + b), b]);
        s.into_iter().flat_map(move |s| t.map(|t| [s, t]))
    }
    /// The two halves along one direction.
    pub fn halves(&self, along: usize) -> [Rect; 2] {
        let m = self.middle()[along];
        let mut out = [*self; 2];
        out[0].range[along][1] = m;
        out[1].range[along][0] = m;
        out
    }
}

/// A box with sides along three directions of its own.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab {
    pub middle: Point,
    /// Unit vectors at right angles; the third is the piece's normal.
    pub axes: [Vector; 3],
    pub half: [f64; 3],
}

impl Slab {
    fn around(points: &[Point], axes: [Vector; 3], origin: &Point) -> Self {
        let mut span = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let mut size = origin.coords.amax();
        for p in points {
            size = size.max(p.coords.amax());
            for (s, a) in span.iter_mut().zip(&axes) {
                let x = (p - origin).dot(a);
                *s = [s[0].min(x), s[1].max(x)];
            }
        }
        let offset: Vector = axes.iter().zip(&span).map(|(a, s)| a * (0.5 * (s[0] + s[1]))).sum();
        Slab { middle: origin + offset, axes, half: span.map(|s| 0.5 * (s[1] - s[0]) + ROUNDING * size) }
    }

    /// Squared distance from `q`, mm²: never more than to anything inside.
    #[inline]
    pub fn distance2(&self, q: &Point) -> f64 {
        let r = q - self.middle;
        let mut sum = 0.0;
        for k in 0..3 {
            let over = r.dot(&self.axes[k]).abs() - self.half[k];
            let over = if over > 0.0 { over } else { 0.0 };
            sum += over * over;
        }
        sum
    }
    /// Half of its greatest extent within the tangent plane, mm.
    pub fn radius(&self) -> f64 {
        (self.half[0] * self.half[0] + self.half[1] * self.half[1]).sqrt()
    }
}

/// A piece of a face with its bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaf {
    pub slab: Slab,
    pub rect: Rect,
    /// A point of the surface, in the middle of the piece.
    pub centre: Point,
    /// From space to the span's coordinates, to first order, about `slab.middle`.
    pub inverse: [Vector; 2],
    pub start: [f64; 2],
    /// Bounds of the greater and of the lesser principal curvature, 1/mm, signed as by
    /// [`SurfaceDerivatives::principal`].
    pub greater: [f64; 2],
    pub lesser: [f64; 2],
    /// Sine, and one minus cosine, of the greatest angle between a normal of the piece and the
    /// slab's.
    pub turn: [f64; 2],
    /// The same seen along the slab's first and second axis: greatest slope of a normal (tangent of
    /// the angle).
    pub slope: [f64; 2],
    /// A point of a side of the piece may be nearest without being a foot: the surface has a crease
    /// there.
    pub sharp: bool,
    /// The piece has a pole, a cusp or wild normals: nothing follows from its curvature.
    pub wild: bool,
    /// Which sides of the loops matter here: index into the borders, or [`NO_BORDER`] where the
    /// piece lies within the face.
    pub border: u32,
}

/// No border: the whole piece belongs to its face.
pub(super) const NO_BORDER: u32 = u32::MAX;

/// Control points of a polynomial of powers on a range: by shifting to its beginning, scaling, and
/// binomial sums.
fn bezier(coefficients: &mut [[f64; 4]], stride: usize, count: usize, [from, to]: [f64; 2]) {
    let width = to - from;
    let at = |k: usize| k * stride;
    for i in 0..count {
        for k in (i..count - 1).rev() {
            let next = coefficients[at(k + 1)];
            let c = &mut coefficients[at(k)];
            (0..4).for_each(|x| c[x] += from * next[x]);
        }
    }
    let n = count - 1;
    let mut factor = 1.0;
    for k in 0..count {
        // Width to the power k over the binomial of n and k.
        coefficients[at(k)].iter_mut().for_each(|x| *x *= factor);
        if k < n {
            factor *= width * (k + 1) as f64 / (n - k) as f64;
        }
    }
    // b_j = sum over i <= j of binomial(j, i) a_i: repeated prefix sums.
    for i in 1..count {
        for k in (i..count).rev() {
            let before = coefficients[at(k - 1)];
            let c = &mut coefficients[at(k)];
            (0..4).for_each(|x| c[x] += before[x]);
        }
    }
}

/// From homogeneous control points; `None` where a weight is not positive, so that there is no
/// convex hull.
fn dehomogenised(h: &[[f64; 4]]) -> Option<Vec<Point>> {
    h.iter().map(|c| (c[3] > 0.0).then(|| Point::new(c[0] / c[3], c[1] / c[3], c[2] / c[3]))).collect()
}

/// Points in whose convex hull the piece lies, row by row, and the number in a row.
pub(super) fn hull(shape: &FaceForm, rect: &Rect) -> (Vec<Point>, usize) {
    if let Some(t) = shape.table {
        let [p, q] = t.degree;
        let mut c = t.piece(rect.span.map(|s| s as usize)).to_vec();
        for a in 0..=p {
            bezier(&mut c[a * (q + 1)..(a + 1) * (q + 1)], 1, q + 1, rect.range[1]);
        }
        for b in 0..=q {
            bezier(&mut c[b..], q + 1, p + 1, rect.range[0]);
        }
        if let Some(points) = dehomogenised(&c) {
            return (points, q + 1);
        }
    }
    // Samples, pushed away from their middle by what lies between them.
    let at =
        |a: usize, k: usize| rect.range[a][0] + (rect.range[a][1] - rect.range[a][0]) * k as f64 / (SAMPLES - 1) as f64;
    let mut points = Vec::with_capacity(SAMPLES * SAMPLES);
    for i in 0..SAMPLES {
        points.extend((0..SAMPLES).map(|j| shape.local(rect.span, [at(0, i), at(1, j)]).p));
    }
    let middle = points[points.len() / 2];
    points.iter_mut().for_each(|p| *p = middle + (*p - middle) * 1.25);
    (points, SAMPLES)
}

/// How far the rows and the columns of a net bend: greatest second difference along the rows'
/// direction and the other, mm.
pub(super) fn bends(points: &[Point], row: usize) -> [f64; 2] {
    let rows = points.len() / row;
    let second =
        |a: usize, b: usize, c: usize| (points[a].coords - points[b].coords * 2.0 + points[c].coords).norm() * 0.25;
    let mut out = [0.0f64; 2];
    for i in 0..rows {
        for j in 0..row {
            let k = i * row + j;
            if i > 0 && i + 1 < rows {
                out[0] = out[0].max(second(k - row, k, k + row) * ((rows - 1) * (rows - 1)) as f64 * 0.5);
            }
            if j > 0 && j + 1 < row {
                out[1] = out[1].max(second(k - 1, k, k + 1) * ((row - 1) * (row - 1)) as f64 * 0.5);
            }
        }
    }
    out
}

/// Extents of a net along both directions, mm.
pub(super) fn extents(points: &[Point], row: usize) -> [f64; 2] {
    let rows = points.len() / row;
    let mut out = [0.0f64; 2];
    for j in [0, row / 2, row - 1] {
        out[0] = out[0].max((1..rows).map(|i| (points[i * row + j] - points[(i - 1) * row + j]).norm()).sum());
    }
    for i in [0, rows / 2, rows - 1] {
        out[1] = out[1].max((1..row).map(|j| (points[i * row + j] - points[i * row + j - 1]).norm()).sum());
    }
    out
}

impl Leaf {
    /// The piece's box from its hull; nothing yet of its curvature ([`Self::measure_bend`]).
    pub fn boxed(shape: &FaceForm, rect: Rect, points: &[Point]) -> Self {
        let m = rect.middle();
        let centre = shape.local(rect.span, m);
        let [hs, ht] = rect.range.map(|[a, b]| 0.5 * (b - a));
        let (ds, dt) = (centre.du * hs, centre.dv * ht);
        let normal = centre.normal();
        let third = normal.unwrap_or_else(Vector::z);
        let long = if ds.norm_squared() >= dt.norm_squared() { ds } else { dt };
        let in_plane = long - third * long.dot(&third);
        let first = in_plane.try_normalize(1e-300).unwrap_or_else(|| any_across(&third));
        let slab = Slab::around(points, [first, third.cross(&first), third], &centre.p);
        // The tangent plane's coordinates to parameters: rows of the pseudo-inverse.
        let (e, f, g) = (centre.du.norm_squared(), centre.du.dot(&centre.dv), centre.dv.norm_squared());
        let det = e * g - f * f;
        let inverse = if det > 1e-12 * e * g {
            [(centre.du * g - centre.dv * f) / det, (centre.dv * e - centre.du * f) / det]
        } else {
            [Vector::zeros(); 2]
        };
        let offset = slab.middle - centre.p;
        let start = [m[0] + inverse[0].dot(&offset), m[1] + inverse[1].dot(&offset)];
        Leaf {
            slab,
            rect,
            centre: centre.p,
            inverse,
            start,
            greater: [f64::INFINITY, f64::NEG_INFINITY],
            lesser: [f64::INFINITY, f64::NEG_INFINITY],
            turn: [0.0; 2],
            slope: [0.0; 2],
            sharp: shape.sharp(&rect),
            wild: normal.is_none(),
            border: NO_BORDER,
        }
    }

    /// Measures curvature and normals.
    pub fn measure_bend(&mut self, shape: &FaceForm) {
        if shape.surface.degree_u == 1 && shape.surface.degree_v == 1 && self.slab.half[2] < 1e-9 && !self.wild {
            // Flat: nothing to measure. (The curvature of a plane's parametrisation is rounding
            // only.)
            (self.greater, self.lesser) = ([0.0; 2], [0.0; 2]);
            return;
        }
        let [a, b, n] = self.slab.axes;
        let mut cosine = 1.0f64;
        for st in self.rect.places() {
            let d = shape.local(self.rect.span, st);
            let Some((m, [k1, k2])) = d.bent() else {
                self.wild = true;
                return;
            };
            let axial = m.dot(&n);
            cosine = cosine.min(axial);
            let steep = [m.dot(&a) / axial, m.dot(&b) / axial].map(f64::abs);
            self.slope = [self.slope[0].max(steep[0]), self.slope[1].max(steep[1])];
            self.greater = [self.greater[0].min(k1), self.greater[1].max(k1)];
            self.lesser = [self.lesser[0].min(k2), self.lesser[1].max(k2)];
        }
        for range in [&mut self.greater, &mut self.lesser] {
            let margin = 0.5 * (range[1] - range[0]);
            *range = [range[0] - margin, range[1] + margin];
        }
        let angle = 1.2 * cosine.clamp(-1.0, 1.0).acos() + 1e-9;
        self.wild |= angle > 1.0 || !self.greater[1].is_finite() || !self.lesser[0].is_finite();
        self.turn = [angle.sin(), 1.0 - angle.cos()];
        // What the samples differ by from the middle, and a quarter more.
        self.slope = self.slope.map(|s| 1.25 * s + 1e-9);
    }

    /// Whether the line from `q` to a point of the piece may be the piece's normal there. Where it
    /// cannot, the nearest point of the piece is on a side, and there the next piece or an edge is
    /// as near.
    #[inline]
    pub fn may_hold_foot(&self, q: &Point) -> bool {
        let r = q - self.slab.middle;
        let [a, b, n] = &self.slab.axes;
        let height = r.dot(n).abs() + self.slab.half[2];
        let slack = 1e-6 + 1e-9 * height;
        let off = [r.dot(a).abs() - self.slab.half[0], r.dot(b).abs() - self.slab.half[1]];
        self.wild
            || self.sharp
            || (off[0] <= height * self.slope[0] + slack && off[1] <= height * self.slope[1] + slack)
    }
}

/// A unit vector at right angles to another.
fn any_across(n: &Vector) -> Vector {
    let other = if n.x.abs() < 0.5 { Vector::x() } else { Vector::y() };
    n.cross(&other).normalize()
}

/// A piece of an edge with its bounds: all of it within `radius` of the segment `ends`.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeafArc {
    /// Of an edge, or, from their number on, of a trace.
    pub edge: u32,
    pub span: u32,
    pub range: [f64; 2],
    pub ends: [Point; 2],
    pub radius: f64,
    /// Curvature vector at the middle, 1/mm, and how far others may be from it; infinite where
    /// unknown.
    pub bend: Vector,
    pub bend_spread: f64,
}

impl LeafArc {
    pub fn new(table: &CurveTable, edge: u32, span: u32, range: [f64; 2]) -> Self {
        let mut c = table.piece(span as usize).to_vec();
        let count = c.len();
        bezier(&mut c, 1, count, range);
        let samples = [range[0], 0.5 * (range[0] + range[1]), range[1]].map(|s| table.local(span as usize, s));
        let ends = [samples[0].0, samples[2].0];
        let off = |p: &Point| (p - crate::geometry::triangle::closest_on_segment(&ends[0], &ends[1], p)).norm();
        let radius = match dehomogenised(&c) {
            Some(points) => points.iter().map(off).fold(0.0, f64::max),
            None => 2.0 * off(&samples[1].0) + (ends[1] - ends[0]).norm(),
        };
        let size = ends[0].coords.amax().max(ends[1].coords.amax());
        let bends = samples.map(|(_, d1, d2)| bend(&d1, &d2));
        let (bend, bend_spread) = match bends {
            [Some(a), Some(b), Some(c)] => (b, 1.5 * (a - b).norm().max((c - b).norm())),
            _ => (Vector::zeros(), f64::INFINITY),
        };
        LeafArc { edge, span, range, ends, radius: radius + 10.0 * ROUNDING * size, bend, bend_spread }
    }

    /// Squared distance from `q`, mm²: never more than to the piece.
    #[inline]
    pub fn distance2(&self, q: &Point) -> f64 {
        let foot = crate::geometry::triangle::closest_on_segment(&self.ends[0], &self.ends[1], q);
        let d = (q - foot).norm() - self.radius;
        if d > 0.0 { d * d } else { 0.0 }
    }

    pub fn length(&self) -> f64 {
        (self.ends[1] - self.ends[0]).norm() + 2.0 * self.radius
    }
}

/// The curvature vector of a curve, 1/mm.
pub(super) fn bend(d1: &Vector, d2: &Vector) -> Option<Vector> {
    let speed2 = d1.norm_squared();
    (speed2 > 1e-300).then(|| (d2 - d1 * (d1.dot(d2) / speed2)) / speed2)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::nurbs::shapes::{cylinder, loft, sphere, torus};

    #[test]
    fn pieces_lie_in_their_slabs_and_within_their_bounds() {
        for surface in [cylinder(3.0, 10.0), sphere(4.0), torus(10.0, 3.0), loft()] {
            let table = SurfaceTable::new(&surface).unwrap();
            let shape = FaceForm { surface: &surface, table: Some(&table) };
            for k in 0..30u32 {
                let span = [k % table.spans[0].len() as u32, (k / 4) % table.spans[1].len() as u32];
                let from = [0.07 * f64::from(k % 9) - 0.6, 0.05 * f64::from(k % 7) - 0.3];
                let range = [[from[0], from[0] + 0.2], [from[1], from[1] + 0.3]];
                let rect = Rect { face: 0, span, range };
                let (points, _) = hull(&shape, &rect);
                let mut leaf = Leaf::boxed(&shape, rect, &points);
                leaf.measure_bend(&shape);
                assert!(!leaf.wild);
                for i in 0..=10 {
                    for j in 0..=10 {
                        let st = [0, 1].map(|a| {
                            range[a][0] + (range[a][1] - range[a][0]) * 0.1 * f64::from(if a == 0 { i } else { j })
                        });
                        let d = shape.local(span, st);
                        assert!(leaf.slab.distance2(&d.p) == 0.0);
                        let p = d.principal().unwrap();
                        let slack = 1e-9;
                        assert!(p.curvature[0] <= leaf.greater[1] + slack && p.curvature[0] >= leaf.greater[0] - slack);
                        assert!(p.curvature[1] <= leaf.lesser[1] + slack && p.curvature[1] >= leaf.lesser[0] - slack);
                        assert!(d.normal().unwrap().cross(&leaf.slab.axes[2]).norm() <= leaf.turn[0] + slack);
                    }
                }
                // Tight: thickness is of the order of the sagitta.
                assert!(leaf.slab.half[2] < 0.5 * leaf.slab.radius());
            }
        }
    }
}
