//! Edges of a B-rep brought into the shape that a watertight tessellation needs.
//!
//! * [`from_vertex`]: a closed edge begins at its vertex, wherever the file's curve begins, so that loops are continuous.
//! * [`sew`]: edges that only one face uses and that coincide with another such edge become one edge. Files of loose
//!   faces, and some writers of solids, repeat every edge per face; without this the tessellation would leave cracks.
//!
//! Only whole edges are joined: where one edge lies along two, both stay open and are counted.

use crate::geometry::brep::{Brep, Edge};
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::fit::split_curve;
use crate::geometry::{Aabb, Point};

/// Samples of a curve where a foot point is sought.
const SAMPLES: usize = 128;

/// What sewing did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sewn {
    /// Pairs of edges that became one.
    pub joined: usize,
    /// Greatest distance between two edges that were joined, mm.
    pub gap_mm: f64,
    /// Edges that only one face uses, once, afterwards.
    pub open: usize,
    /// Middle of the first of them, mm.
    pub first_open: Option<Point>,
}

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

/// A closed curve that begins and ends at the vertex; the curve itself where it does so already or cannot be cut there.
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
    // Both halves meet at the old start; a common factor of homogeneous points leaves a curve as it is.
    let scale = end.w / start.w;
    let degree = curve.degree;
    let mut knots = second.knots[..second.knots.len() - 1].to_vec();
    knots.extend(first.knots[degree + 1..].iter().map(|k| k + (t1 - t0)));
    let mut points = second.points.clone();
    points.extend(first.points[1..].iter().map(|p| p * scale));
    NurbsCurve { degree, knots, points }
}

/// Parameter and distance of the point of the curve closest to `q`: sampled, then narrowed by golden section.
fn foot(curve: &NurbsCurve, t: [f64; 2], q: &Point) -> (f64, f64) {
    let at = |k: usize| t[0] + (t[1] - t[0]) * k as f64 / SAMPLES as f64;
    let distance = |t: f64| (curve.point(t) - q).norm();
    let nearest = (0..=SAMPLES).min_by(|&i, &j| distance(at(i)).total_cmp(&distance(at(j)))).unwrap_or(0);
    let (mut a, mut b) = (at(nearest.saturating_sub(1)), at((nearest + 1).min(SAMPLES)));
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..48 {
        let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
        if distance(c) < distance(d) { b = d } else { a = c }
    }
    let (narrowed, sampled) = (0.5 * (a + b), at(nearest));
    // The ends of the interval are feet of their own.
    [narrowed, sampled].into_iter().map(|t| (t, distance(t))).min_by(|x, y| x.1.total_cmp(&y.1)).unwrap_or((t[0], 0.0))
}

/// How often loops use each edge.
fn uses(brep: &Brep) -> Vec<usize> {
    let mut uses = vec![0; brep.edges.len()];
    for c in brep.faces.iter().flat_map(|f| f.loops.iter().flatten()) {
        if let Some(n) = uses.get_mut(c.edge) {
            *n += 1;
        }
    }
    uses
}

fn ends(e: &Edge) -> [Point; 2] {
    e.t.map(|t| e.curve.point(t))
}

fn middle(e: &Edge) -> Point {
    e.curve.point(0.5 * (e.t[0] + e.t[1]))
}

/// Joins edges that coincide within the tolerance and that one face each uses once.
pub fn sew(brep: &mut Brep, tolerance_mm: f64) -> Sewn {
    let single: Vec<usize> = uses(brep).iter().enumerate().filter(|(_, n)| **n == 1).map(|(i, _)| i).collect();
    let boxes: Vec<Option<Aabb>> = single.iter().map(|&i| hull(&brep.edges[i])).collect();
    // For each joined edge: the edge that takes its place, and whether that runs the other way.
    let mut instead: Vec<Option<(usize, bool)>> = vec![None; brep.edges.len()];
    let mut taken = vec![false; single.len()];
    let mut out = Sewn::default();
    for i in 0..single.len() {
        if taken[i] {
            continue;
        }
        for j in i + 1..single.len() {
            if taken[j] || apart(&boxes[i], &boxes[j], tolerance_mm) {
                continue;
            }
            let (a, b) = (&brep.edges[single[i]], &brep.edges[single[j]]);
            if let Some((opposite, gap_mm)) = coincide(a, b, tolerance_mm) {
                (taken[i], taken[j]) = (true, true);
                instead[single[j]] = Some((single[i], opposite));
                out.joined += 1;
                out.gap_mm = out.gap_mm.max(gap_mm);
                break;
            }
        }
    }
    for c in brep.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten()) {
        if let Some(Some((edge, opposite))) = instead.get(c.edge) {
            c.edge = *edge;
            c.reversed ^= opposite;
        }
    }
    drop_unused(brep);
    for (i, n) in uses(brep).into_iter().enumerate() {
        if n == 1 {
            out.open += 1;
            out.first_open.get_or_insert(middle(&brep.edges[i]));
        }
    }
    out
}

/// Box of an edge from samples.
fn hull(e: &Edge) -> Option<Aabb> {
    let points: Vec<Point> =
        (0..=16).map(|k| e.curve.point(e.t[0] + (e.t[1] - e.t[0]) * f64::from(k) / 16.0)).collect();
    Aabb::around(&points)
}

/// Whether two boxes of the same curve could not differ by so much: the least corners, or the greatest, are far apart.
fn apart(a: &Option<Aabb>, b: &Option<Aabb>, tolerance_mm: f64) -> bool {
    let (Some(a), Some(b)) = (a, b) else { return true };
    // Samples of differently parametrised curves miss extremes by a share of the size.
    let slack = tolerance_mm + 0.1 * a.diagonal_mm().max(b.diagonal_mm());
    (a.min - b.min).amax() > slack || (a.max - b.max).amax() > slack
}

/// Whether two edges are the same curve: (they run in opposite senses, greatest distance found).
fn coincide(a: &Edge, b: &Edge, tolerance_mm: f64) -> Option<(bool, f64)> {
    let ([a0, a1], [b0, b1]) = (ends(a), ends(b));
    let same = (a0 - b0).norm().max((a1 - b1).norm());
    let crossed = (a0 - b1).norm().max((a1 - b0).norm());
    if same.min(crossed) > tolerance_mm {
        return None;
    }
    let mut gap_mm = same.min(crossed);
    for k in 1..8 {
        let p = a.curve.point(a.t[0] + (a.t[1] - a.t[0]) * f64::from(k) / 8.0);
        gap_mm = gap_mm.max(foot(&b.curve, b.t, &p).1);
        if gap_mm > tolerance_mm {
            return None;
        }
    }
    if same.max(crossed) > tolerance_mm {
        return Some((crossed < same, gap_mm));
    }
    // Closed edges: their ends say nothing, so the order of two points on the way does.
    let at = |s: f64| foot(&b.curve, b.t, &a.curve.point(a.t[0] + s * (a.t[1] - a.t[0]))).0;
    Some((at(0.3) > at(0.6), gap_mm))
}

/// Removes edges without use and renumbers the rest.
fn drop_unused(brep: &mut Brep) {
    let uses = uses(brep);
    let mut number = vec![0; uses.len()];
    let mut kept = Vec::with_capacity(uses.len());
    for (i, edge) in std::mem::take(&mut brep.edges).into_iter().enumerate() {
        if uses[i] > 0 {
            number[i] = kept.len();
            kept.push(edge);
        }
    }
    brep.edges = kept;
    for c in brep.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten()) {
        c.edge = number[c.edge];
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use nalgebra::Vector4;

    use super::*;
    use crate::geometry::brep::{Coedge, Face, SurfaceKind};
    use crate::geometry::nurbs::NurbsSurface;

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

    /// Two squares side by side, each with its own four edges, the second walked the other way.
    fn squares(gap: f64) -> Brep {
        let mut brep = Brep::default();
        let line = |a: [f64; 2], b: [f64; 2]| Edge {
            curve: NurbsCurve {
                degree: 1,
                knots: vec![0.0, 0.0, 1.0, 1.0],
                points: vec![Vector4::new(a[0], a[1], 0.0, 1.0), Vector4::new(b[0], b[1], 0.0, 1.0)],
            },
            t: [0.0, 1.0],
        };
        for (x, left_to_right) in [(0.0, true), (1.0 + gap, false)] {
            let mut corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
            if !left_to_right {
                corners.reverse();
            }
            let first = brep.edges.len();
            brep.edges.extend((0..4).map(|k| line(corners[k], corners[(k + 1) % 4])));
            let point = |x: f64, y: f64| Vector4::new(x, y, 0.0, 1.0);
            brep.faces.push(Face {
                name: String::new(),
                kind: SurfaceKind::Plane,
                surface: NurbsSurface {
                    degree_u: 1,
                    degree_v: 1,
                    knots_u: vec![0.0, 0.0, 1.0, 1.0],
                    knots_v: vec![0.0, 0.0, 1.0, 1.0],
                    n_u: 2,
                    n_v: 2,
                    points: vec![point(x, 0.0), point(x, 1.0), point(x + 1.0, 0.0), point(x + 1.0, 1.0)],
                },
                reversed: false,
                loops: vec![(first..first + 4).map(|edge| Coedge { edge, reversed: false }).collect()],
            });
        }
        brep
    }

    #[test]
    fn coinciding_edges_are_joined_once() {
        let mut brep = squares(1e-4);
        let before: Vec<[Point; 2]> = loop_ends(&brep, 1);
        let sewn = sew(&mut brep, 1e-3);
        assert_eq!((sewn.joined, sewn.open, brep.edges.len()), (1, 6, 7));
        assert!((sewn.gap_mm - 1e-4).abs() < 1e-9);
        // The second face's loop still runs through the same corners.
        for (a, b) in before.iter().zip(loop_ends(&brep, 1)) {
            assert!((a[0] - b[0]).norm() < 2e-4 && (a[1] - b[1]).norm() < 2e-4);
        }
        let mut far = squares(0.1);
        assert_eq!(sew(&mut far, 1e-3).joined, 0);
        assert_eq!(far.edges.len(), 8);
    }

    fn loop_ends(brep: &Brep, face: usize) -> Vec<[Point; 2]> {
        brep.faces[face].loops[0]
            .iter()
            .map(|c| {
                let [a, b] = ends(&brep.edges[c.edge]);
                if c.reversed { [b, a] } else { [a, b] }
            })
            .collect()
    }
}
