//! Edges to chords, once for all faces; end points and edges that coincide made one.

use std::collections::BTreeMap;

use nalgebra::Vector4;

use super::{Chord, TessellateOptions, face_error};
use crate::error::Result;
use crate::geometry::brep::{Brep, Coedge, Edge};
use crate::geometry::nurbs::basis::Basis;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::geometry::triangle::{angle_between, closest_on_segment};
use crate::geometry::{Point, Vector};

/// Ends of consecutive edges of a loop are the same vertex even if they are this far apart, mm: the
/// file says so. Kernels leave gaps of some hundredths where a fillet runs out; edges may lie off
/// their faces by as much.
pub(super) const HEAL_MM: f64 = 0.05;
/// Chords are bisected at most this often.
const DEEPEST: usize = 12;

/// All edges as chords.
#[derive(Clone, Debug)]
pub struct EdgeNet {
    /// Points that faces share.
    pub points: Vec<Point>,
    /// Per edge: its points in order of its parameter; fewer than two where the edge is no longer
    /// than the weld tolerance.
    pub lines: Vec<EdgeLine>,
    /// All chords.
    pub chords: Vec<Chord>,
    /// Greatest distance between chord and curve, mm.
    pub deflection_mm: f64,
}

/// An edge as chords.
#[derive(Clone, Debug, Default)]
pub struct EdgeLine {
    /// Parameters, increasing.
    pub t: Vec<f64>,
    /// Indices into [`EdgeNet::points`], as many.
    pub ids: Vec<u32>,
    /// Index of the first of its chords in [`EdgeNet::chords`].
    pub first_chord: u32,
}

/// Gives every face without loops the boundary of its parameter rectangle: sides that coincide
/// become one seam, sides that shrink to a point vanish.
pub fn add_natural_loops(brep: &mut Brep, spaces: &[ParameterSpace]) {
    for f in 0..brep.faces.len() {
        if !brep.faces[f].loops.is_empty() {
            continue;
        }
        let surface = &brep.faces[f].surface;
        let (space, d) = (&spaces[f], surface.domain());
        // Along u at v0, along v at u1, back along u at v1, back along v at u0.
        let south = Edge { curve: iso_curve(surface, 0, d[1][0]), t: d[0] };
        let east = Edge { curve: iso_curve(surface, 1, d[0][1]), t: d[1] };
        let north = Edge { curve: iso_curve(surface, 0, d[1][1]), t: d[0] };
        let west = Edge { curve: iso_curve(surface, 1, d[0][0]), t: d[1] };
        let base = brep.edges.len();
        brep.edges.extend([south, east, north, west]);
        let north_id = if space.closed[1] { base } else { base + 2 };
        let west_id = if space.closed[0] { base + 1 } else { base + 3 };
        brep.faces[f].loops.push(vec![
            Coedge { edge: base, reversed: false },
            Coedge { edge: base + 1, reversed: false },
            Coedge { edge: north_id, reversed: true },
            Coedge { edge: west_id, reversed: true },
        ]);
    }
}

/// The curve on the surface along u (0) or v (1) at a fixed value of the other parameter; exact.
pub fn iso_curve(s: &NurbsSurface, along: usize, at: f64) -> NurbsCurve {
    let sum = |basis: &Basis, pole: &dyn Fn(usize) -> Vector4<f64>| {
        basis.value().iter().enumerate().map(|(k, n)| pole(basis.first + k) * *n).sum::<Vector4<f64>>()
    };
    if along == 0 {
        let b = Basis::new(s.degree_v, s.n_v, &s.knots_v, at);
        let points = (0..s.n_u).map(|i| sum(&b, &|j| s.points[i * s.n_v + j])).collect();
        NurbsCurve { degree: s.degree_u, knots: s.knots_u.clone(), points }
    } else {
        let b = Basis::new(s.degree_u, s.n_u, &s.knots_u, at);
        let points = (0..s.n_v).map(|j| sum(&b, &|i| s.points[i * s.n_v + j])).collect();
        NurbsCurve { degree: s.degree_v, knots: s.knots_v.clone(), points }
    }
}

/// Union of indices, by least member.
struct Union(Vec<usize>);

impl Union {
    fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }
    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

impl EdgeNet {
    /// Welds vertices, makes coinciding edges one (rewriting the coedges of `brep`), cuts edges
    /// into chords.
    ///
    /// # Errors
    /// An edge that evaluates to something that is not finite, named by its face.
    pub fn new(brep: &mut Brep, options: &TessellateOptions) -> Result<Self> {
        let ends = ends_of(brep);
        check_finite(brep, &ends)?;
        let (vertex_of, points) = weld_vertices(brep, &ends, options.weld_mm);
        merge_edges(brep, &vertex_of, options);
        let mut used = vec![false; brep.edges.len()];
        brep.faces.iter().flat_map(|f| f.loops.iter().flatten()).for_each(|c| used[c.edge] = true);
        let mut net = EdgeNet { points, lines: Vec::new(), chords: Vec::new(), deflection_mm: 0.0 };
        for (e, edge) in brep.edges.iter().enumerate() {
            let line = if used[e] {
                net.cut(e as u32, edge, [vertex_of[2 * e], vertex_of[2 * e + 1]], options)
            } else {
                EdgeLine::default()
            };
            net.lines.push(line);
        }
        Ok(net)
    }

    /// Halves the marked chords. Returns which edges changed, and the new number of every old chord
    /// of the others.
    pub fn split(&mut self, brep: &Brep, marks: &[bool]) -> (Vec<bool>, Vec<u32>) {
        let mut changed = vec![false; self.lines.len()];
        let mut renumbered = vec![0; self.chords.len()];
        let old = std::mem::take(&mut self.chords);
        for (e, line) in self.lines.iter_mut().enumerate() {
            let before = std::mem::take(line);
            line.first_chord = self.chords.len() as u32;
            for (k, (&t, &id)) in before.t.iter().zip(&before.ids).enumerate() {
                line.t.push(t);
                line.ids.push(id);
                let Some(&next) = before.t.get(k + 1) else { continue };
                let number = before.first_chord as usize + k;
                renumbered[number] = self.chords.len() as u32;
                let middle = 0.5 * (t + next);
                if marks[number] && middle > t && middle < next {
                    changed[e] = true;
                    line.t.push(middle);
                    line.ids.push(self.points.len() as u32);
                    self.points.push(brep.edges[e].curve.point(middle));
                    self.chords.push(Chord { edge: e as u32, t: [t, middle] });
                    self.chords.push(Chord { edge: e as u32, t: [middle, next] });
                } else {
                    self.chords.push(old[number]);
                }
            }
        }
        (changed, renumbered)
    }

    fn cut(&mut self, e: u32, edge: &Edge, vertices: [u32; 2], options: &TessellateOptions) -> EdgeLine {
        let closed = vertices[0] == vertices[1];
        let (ts, ps) = cut_curve(edge, closed, options);
        let length: f64 = ps.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
        let first_chord = self.chords.len() as u32;
        if closed && length <= 4.0 * options.weld_mm {
            return EdgeLine { t: vec![edge.t[0]], ids: vec![vertices[0]], first_chord };
        }
        let last = ts.len() - 1;
        let mut ids = vec![vertices[0]];
        for p in &ps[1..last] {
            ids.push(self.points.len() as u32);
            self.points.push(*p);
        }
        ids.push(vertices[1]);
        for k in 0..last {
            self.chords.push(Chord { edge: e, t: [ts[k], ts[k + 1]] });
            let [a, b] = [ids[k], ids[k + 1]].map(|i| self.points[i as usize]);
            for s in [0.25, 0.5, 0.75] {
                let on = edge.curve.point(ts[k] + s * (ts[k + 1] - ts[k]));
                self.deflection_mm = self.deflection_mm.max((closest_on_segment(&a, &b, &on) - on).norm());
            }
        }
        EdgeLine { t: ts, ids, first_chord }
    }
}

fn check_finite(brep: &Brep, ends: &[Point]) -> Result<()> {
    for face in &brep.faces {
        for c in face.loops.iter().flatten() {
            if ends[2 * c.edge..2 * c.edge + 2].iter().any(|p| p.iter().any(|x| !x.is_finite())) {
                return Err(face_error(face, "has an edge whose end is not finite"));
            }
        }
    }
    Ok(())
}

/// Vertex of every edge end (two per edge), and the vertices' points.
fn weld_vertices(brep: &Brep, ends: &[Point], weld_mm: f64) -> (Vec<u32>, Vec<Point>) {
    let mut union = Union((0..ends.len()).collect());
    consecutive(brep, ends).for_each(|[a, b]| union.join(a, b));
    // Ends in the same place: a sweep along x.
    let mut order: Vec<usize> = (0..ends.len()).collect();
    order.sort_by(|a, b| ends[*a].x.total_cmp(&ends[*b].x).then(a.cmp(b)));
    for (k, &i) in order.iter().enumerate() {
        for &j in order[k + 1..].iter().take_while(|j| ends[**j].x - ends[i].x <= weld_mm) {
            if (ends[i] - ends[j]).norm() <= weld_mm {
                union.join(i, j);
            }
        }
    }
    let mut number = BTreeMap::new();
    let mut points = Vec::new();
    let vertex_of = (0..ends.len())
        .map(|i| {
            *number.entry(union.root(i)).or_insert_with(|| {
                points.push(ends[i]);
                points.len() as u32 - 1
            })
        })
        .collect();
    (vertex_of, points)
}

/// Both ends of every edge.
fn ends_of(brep: &Brep) -> Vec<Point> {
    brep.edges.iter().flat_map(|e| e.t.map(|t| e.curve.point(t))).collect()
}

/// Ends of edges that follow one another in a loop and are the same vertex, though they may be a
/// gap apart: indices as of `ends`, two for each edge.
fn consecutive(brep: &Brep, ends: &[Point]) -> impl Iterator<Item = [usize; 2]> {
    let pairs = brep.faces.iter().flat_map(|f| &f.loops).flat_map(|one| (0..one.len()).map(move |k| (one, k)));
    pairs.filter_map(|(one, k)| {
        let (c, next) = (one[k], one[(k + 1) % one.len()]);
        let (a, b) = (2 * c.edge + usize::from(!c.reversed), 2 * next.edge + usize::from(next.reversed));
        let most_mm = HEAL_MM.min(0.2 * edge_size(ends, c.edge).min(edge_size(ends, next.edge)));
        ((ends[a] - ends[b]).norm() <= most_mm).then_some([a, b])
    })
}

/// Gaps wider than `least_mm` between edges that follow one another in a loop, which a tessellation
/// closes: widths, mm, and where they are.
pub fn closed_gaps(brep: &Brep, least_mm: f64) -> Vec<(f64, Point)> {
    let ends = ends_of(brep);
    let width_mm = |[a, b]: [usize; 2]| ((ends[a] - ends[b]).norm(), ends[a]);
    consecutive(brep, &ends).map(width_mm).filter(|gap| gap.0 > least_mm).collect()
}

/// Distance between an edge's ends, or infinity where it is closed.
fn edge_size(ends: &[Point], e: usize) -> f64 {
    let d = (ends[2 * e] - ends[2 * e + 1]).norm();
    if d < 1e-9 { f64::INFINITY } else { d }
}

/// Edges between the same vertices that run along one another become the first of them.
fn merge_edges(brep: &mut Brep, vertex_of: &[u32], options: &TessellateOptions) {
    let mut by_ends: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
    let mut instead: Vec<(usize, bool)> = (0..brep.edges.len()).map(|e| (e, false)).collect();
    for e in 0..brep.edges.len() {
        let (a, b) = (vertex_of[2 * e], vertex_of[2 * e + 1]);
        let group = by_ends.entry([a.min(b), a.max(b)]).or_default();
        if let Some(found) = group
            .iter()
            .find_map(|&g| same_course(&brep.edges[g], &brep.edges[e], options).map(|reversed| (g, reversed)))
        {
            instead[e] = found;
        } else {
            group.push(e);
        }
    }
    for c in brep.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten()) {
        let (edge, reversed) = instead[c.edge];
        c.edge = edge;
        c.reversed ^= reversed;
    }
}

/// Whether two edges run along the same course, and if so, whether in opposite directions.
fn same_course(a: &Edge, b: &Edge, options: &TessellateOptions) -> Option<bool> {
    let limit = (10.0 * options.weld_mm).min(0.1 * options.deflection_mm);
    let on = |e: &Edge, s: f64| e.curve.point(e.t[0] + s * (e.t[1] - e.t[0]));
    let guess = |p: &Point| {
        let sampled =
            (0..=16).map(|k| k as f64 / 16.0).min_by(|x, y| (on(a, *x) - p).norm().total_cmp(&(on(a, *y) - p).norm()));
        a.t[0] + sampled.unwrap_or(0.5) * (a.t[1] - a.t[0])
    };
    let mut feet = Vec::new();
    for s in [0.15, 0.4, 0.5, 0.6, 0.85] {
        let p = on(b, s);
        let foot = a.curve.foot(&p, guess(&p), a.t);
        if foot.distance_mm > limit {
            return None;
        }
        feet.push(foot.t);
    }
    Some(feet[1] > feet[3])
}

/// Parameters and points along an edge so that chords stay within tolerance and angle.
fn cut_curve(edge: &Edge, closed: bool, options: &TessellateOptions) -> (Vec<f64>, Vec<Point>) {
    let [from, to] = edge.t;
    let mut stops = vec![from];
    stops.extend(edge.curve.knots.iter().copied().filter(|k| *k > from && *k < to));
    stops.push(to);
    stops.dedup();
    if closed && stops.len() < 4 {
        stops = (0..=4).map(|k| from + (to - from) * f64::from(k) / 4.0).collect();
    }
    // Knots alone are no reason for a point: spans are joined again where the chord allows.
    let (first, first_d, _) = edge.curve.derivatives(from);
    let mut cuts = Cuts { edge, options, before: (from, first, first_d), ts: vec![from], ps: vec![first] };
    for w in stops.windows(2) {
        cuts.go_on(w[1], 0);
    }
    let Cuts { mut ts, mut ps, .. } = cuts;
    thin(edge, closed, options, &mut ts, &mut ps);
    (ts, ps)
}

/// An edge on its way to be cut into chords.
struct Cuts<'a> {
    edge: &'a Edge,
    options: &'a TessellateOptions,
    /// The last cut: parameter, point, derivative.
    before: (f64, Point, Vector),
    ts: Vec<f64>,
    ps: Vec<Point>,
}

impl Cuts<'_> {
    /// Goes on to a parameter in one chord, or halves the way there until chords fit.
    fn go_on(&mut self, to: f64, depth: usize) {
        let (p, d, _) = self.edge.curve.derivatives(to);
        let (t, from, from_d) = self.before;
        if depth < DEEPEST && !chord_fits(self.edge, t, to, (&from, &from_d), (&p, &d), self.options) {
            self.go_on(0.5 * (t + to), depth + 1);
            self.go_on(to, depth + 1);
            return;
        }
        self.ts.push(to);
        self.ps.push(p);
        self.before = (to, p, d);
    }
}

/// Whether one chord between two parameters is near enough; half the deflection is left to the
/// faces.
fn chord_fits(
    edge: &Edge,
    t0: f64,
    t1: f64,
    a: (&Point, &Vector),
    b: (&Point, &Vector),
    o: &TessellateOptions,
) -> bool {
    let near = [0.2, 0.5, 0.8].iter().all(|s| {
        let on = edge.curve.point(t0 + s * (t1 - t0));
        (closest_on_segment(a.0, b.0, &on) - on).norm() <= 0.5 * o.deflection_mm
    });
    // Around a corner tighter than the deflection the angle says nothing.
    near && (angle_between(a.1, b.1) <= o.angle_rad || (b.0 - a.0).norm() <= 2.0 * o.deflection_mm)
}

/// Drops points that the chord over them does not need.
fn thin(edge: &Edge, closed: bool, o: &TessellateOptions, ts: &mut Vec<f64>, ps: &mut Vec<Point>) {
    let least = if closed { 5 } else { 2 };
    let mut k = 1;
    let mut run = 0;
    while k + 1 < ts.len() && ts.len() > least {
        let (a, b) = (edge.curve.derivatives(ts[k - 1]), edge.curve.derivatives(ts[k + 1]));
        let dropped_fit = (closest_on_segment(&a.0, &b.0, &ps[k]) - ps[k]).norm() <= 0.25 * o.deflection_mm;
        // At most a few in a row, so that tests at a few samples stay meaningful.
        if run < 8 && dropped_fit && chord_fits(edge, ts[k - 1], ts[k + 1], (&a.0, &a.1), (&b.0, &b.1), o) {
            ts.remove(k);
            ps.remove(k);
            run += 1;
        } else {
            k += 1;
            run = 0;
        }
    }
}
