//! Lofted surfaces and two caps to one closed solid.
//!
//! A cap whose outline is flat is a plane; otherwise it is ruled between the two sides, and what
//! remains at a blunt edge is filled between that edge and its chord. Faces are oriented outward
//! for a blade whose sections run counter-clockwise seen against the span.

use super::loft::Loft;
use crate::geometry::brep::{Brep, Coedge, Edge, Face, SurfaceKind};
use crate::geometry::nurbs::fit::ruled;
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::geometry::{Point, Vector};

/// An outline is flat if no control point is farther from its plane than this share of its size.
const FLAT: f64 = 1e-7;

/// The closed solid of a loft.
///
/// # Errors
/// A sentence: a cap that cannot be made.
pub fn close(loft: &Loft) -> Result<Brep, String> {
    let n = loft.surfaces.len();
    let mut solid = TableSolid::default();
    let hub: Vec<usize> = loft.surfaces.iter().map(|s| solid.edge(row(s, 0))).collect();
    let tip: Vec<usize> = loft.surfaces.iter().map(|s| solid.edge(row(s, s.n_v - 1))).collect();
    let walls: Vec<usize> = loft.surfaces.iter().map(|s| solid.edge(column(s))).collect();
    let anchors = &loft.grid.anchors;
    for (k, surface) in loft.surfaces.iter().enumerate() {
        let next = (k + 1) % n;
        let at_edge = anchors[k].end == anchors[next].end;
        let name = match (at_edge, anchors[k].end) {
            (true, end) => format!("edge {}", end + 1),
            (false, 0) => "side 1".to_owned(),
            (false, _) => "side 2".to_owned(),
        };
        let edges = vec![forward(hub[k]), forward(walls[next]), backward(tip[k]), backward(walls[k])];
        solid.face(name, SurfaceKind::BSpline, surface.clone(), false, edges);
    }
    let ends: Vec<usize> = anchors.iter().map(|a| a.end).collect();
    solid.cap("hub", &hub, &ends, true)?;
    solid.cap("tip", &tip, &ends, false)?;
    Ok(solid.brep)
}

fn forward(edge: usize) -> Coedge {
    Coedge { edge, reversed: false }
}

fn backward(edge: usize) -> Coedge {
    Coedge { edge, reversed: true }
}

/// The boundary at the first or last control points along v.
fn row(s: &NurbsSurface, j: usize) -> NurbsCurve {
    let points = s.points.iter().skip(j).step_by(s.n_v).copied().collect();
    NurbsCurve { degree: s.degree_u, knots: s.knots_u.clone(), points }
}

/// The boundary at the start of u.
fn column(s: &NurbsSurface) -> NurbsCurve {
    NurbsCurve { degree: s.degree_v, knots: s.knots_v.clone(), points: s.points[..s.n_v].to_vec() }
}

fn poles(c: &NurbsCurve) -> impl DoubleEndedIterator<Item = Point> + '_ {
    c.points.iter().map(|p| Point::from(p.xyz() / p.w))
}

fn reversed(c: &NurbsCurve) -> NurbsCurve {
    let sum = c.knots[0] + c.knots[c.knots.len() - 1];
    NurbsCurve {
        degree: c.degree,
        knots: c.knots.iter().rev().map(|k| sum - k).collect(),
        points: c.points.iter().rev().copied().collect(),
    }
}

fn line(a: Point, b: Point) -> NurbsCurve {
    NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points: vec![a.to_homogeneous(), b.to_homogeneous()] }
}

/// The chord of a curve with the curve's own degree and knots: its control points stand at the
/// means of knots, which make a straight line of constant speed.
fn chord(c: &NurbsCurve) -> NurbsCurve {
    let (p, n) = (c.degree, c.points.len());
    let (from, to) = (c.knots[0], c.knots[c.knots.len() - 1]);
    let points = (0..n)
        .map(|i| {
            let mean = c.knots[i + 1..=i + p].iter().sum::<f64>() / p as f64;
            let s = (mean - from) / (to - from);
            c.points[0] * (1.0 - s) + c.points[n - 1] * s
        })
        .collect();
    NurbsCurve { points, ..c.clone() }
}

#[derive(Default)]
struct TableSolid {
    brep: Brep,
}

impl TableSolid {
    fn edge(&mut self, curve: NurbsCurve) -> usize {
        let t = curve.domain();
        self.brep.edges.push(Edge { curve, t });
        self.brep.edges.len() - 1
    }

    fn curve(&self, edge: usize) -> &NurbsCurve {
        &self.brep.edges[edge].curve
    }

    fn face(&mut self, name: String, kind: SurfaceKind, surface: NurbsSurface, reversed: bool, edges: Vec<Coedge>) {
        self.brep.faces.push(Face { name: name.into(), kind, surface, reversed, loops: vec![edges] });
    }

    /// Closes an outline of edges that run round it, counter-clockwise seen against the span;
    /// `ends` says of which end of the section the start of each is.
    fn cap(&mut self, name: &str, outline: &[usize], ends: &[usize], down: bool) -> Result<(), String> {
        let polygon: Vec<Point> = outline
            .iter()
            .flat_map(|&e| poles(self.curve(e)).rev().skip(1).collect::<Vec<_>>().into_iter().rev())
            .collect();
        let rim: Vec<Coedge> = outline.iter().map(|&e| forward(e)).collect();
        if let Some(plane) = plane(&polygon) {
            self.face(format!("{name} cap"), SurfaceKind::Plane, plane, down, rim);
            return Ok(());
        }
        let n = outline.len();
        let sides: Vec<usize> = (0..n).filter(|&k| ends[k] != ends[(k + 1) % n]).collect();
        let [first, second] = sides[..] else {
            return Err(format!("the {name} has no two sides to rule a cap between"));
        };
        let surface = ruled(self.curve(outline[first]), &reversed(self.curve(outline[second])))
            .map_err(|e| format!("the {name} cannot be closed: {e}"))?;
        let mut edges = vec![forward(outline[first])];
        edges.extend(self.blunt(name, &between(outline, first, second), down)?);
        edges.push(forward(outline[second]));
        edges.extend(self.blunt(name, &between(outline, second, first), down)?);
        self.face(format!("{name} cap"), SurfaceKind::Other, surface, down, edges);
        Ok(())
    }

    /// The way of the main cap across a blunt edge: nothing at a sharp one, the edge itself if it
    /// is one straight line, else its chord; what lies between is closed by faces of its own.
    fn blunt(&mut self, name: &str, pieces: &[usize], down: bool) -> Result<Vec<Coedge>, String> {
        let mut chords: Vec<([Point; 2], Vec<Coedge>)> = Vec::with_capacity(pieces.len());
        for &e in pieces {
            let curve = self.curve(e).clone();
            let mut p = poles(&curve);
            let (Some(a), Some(b)) = (p.next(), p.next_back()) else { continue };
            if curve.degree == 1 && curve.points.len() == 2 {
                chords.push(([a, b], vec![forward(e)]));
                continue;
            }
            // The chord is to the left of the edge, so the surface from edge to chord looks along
            // the span.
            let surface = ruled(&curve, &chord(&curve)).map_err(|e| format!("the {name} cannot be closed: {e}"))?;
            let across = self.halves(a, b);
            let mut edges = vec![forward(e)];
            edges.extend(turned(&across));
            self.face(format!("{name} cap at an edge"), SurfaceKind::Other, surface, down, edges);
            chords.push(([a, b], across));
        }
        // A fan over the corners of the chords.
        let mut chords = chords.into_iter();
        let Some(([origin, _], mut diagonal)) = chords.next() else { return Ok(Vec::new()) };
        for ([a, b], chord) in chords {
            let next = self.halves(origin, b);
            if let Some(surface) = plane(&[origin, a, b]) {
                let mut edges = diagonal;
                edges.extend(chord);
                edges.extend(turned(&next));
                self.face(format!("{name} cap at an edge"), SurfaceKind::Plane, surface, down, edges);
            }
            diagonal = next;
        }
        Ok(diagonal)
    }

    /// A straight line in two edges: a face between a line and a curve that share both ends needs a
    /// point between them.
    fn halves(&mut self, a: Point, b: Point) -> Vec<Coedge> {
        let middle = nalgebra::center(&a, &b);
        vec![forward(self.edge(line(a, middle))), forward(self.edge(line(middle, b)))]
    }
}

/// Edges walked the other way.
fn turned(edges: &[Coedge]) -> Vec<Coedge> {
    edges.iter().rev().map(|c| Coedge { reversed: !c.reversed, ..*c }).collect()
}

/// The pieces after side `from` and before side `to`, round.
fn between(outline: &[usize], from: usize, to: usize) -> Vec<usize> {
    let n = outline.len();
    (1..n).map(|k| (from + k) % n).take_while(|&k| k != to).map(|k| outline[k]).collect()
}

/// The rectangle round a flat polygon, a little larger, with the normal about which the polygon
/// turns; `None` if it is not flat.
fn plane(polygon: &[Point]) -> Option<NurbsSurface> {
    let n = polygon.len();
    let centre = Point::from(polygon.iter().map(|p| p.coords).sum::<Vector>() / n as f64);
    let area: Vector = (0..n).map(|i| (polygon[i] - centre).cross(&(polygon[(i + 1) % n] - centre))).sum();
    let normal = area.try_normalize(0.0)?;
    let far = polygon.iter().max_by(|a, b| (*a - centre).norm().total_cmp(&(*b - centre).norm()))?;
    let size = (far - centre).norm();
    if polygon.iter().any(|p| (p - centre).dot(&normal).abs() > FLAT * size) {
        return None;
    }
    let e1 = (far - centre - normal * (far - centre).dot(&normal)).try_normalize(0.0)?;
    let e2 = normal.cross(&e1);
    let range = |e: &Vector| {
        let (from, to) = polygon
            .iter()
            .map(|p| (p - centre).dot(e))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |r, x| (r.0.min(x), r.1.max(x)));
        let margin = 0.02 * (to - from);
        [from - margin, to + margin]
    };
    let (u, v) = (range(&e1), range(&e2));
    let corner = |u: f64, v: f64| (centre + e1 * u + e2 * v).to_homogeneous();
    Some(NurbsSurface::bilinear([corner(u[0], v[0]), corner(u[0], v[1]), corner(u[1], v[0]), corner(u[1], v[1])]))
}
