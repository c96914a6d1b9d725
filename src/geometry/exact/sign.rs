//! Inside or outside by the exact normals.
//!
//! At a foot inside a face its normal decides. On an edge the sum of the normals of the faces that
//! meet there decides. At a vertex these normals are weighted with the angles that the faces span.
//! These sums give the right sign wherever the edge or vertex is the closest point (Bærentzen and
//! Aanæs, *Signed distance computation using the angle weighted pseudonormal*, 2005).
//!
//! Limits: right for faces that neither fold over nor cross themselves or one another (a normal on
//! a fold points inwards), and where faces have normals (the tip of a cusp has none);
//! [`Part::inside`](crate::geometry::part::Part::inside) asks here only near the part.

use std::collections::BTreeMap;

use super::search::{self, On};
use super::trim::TrimTest;
use super::{Exact, is_pole};
use crate::geometry::brep::Brep;
use crate::geometry::tessellate::loops::RingCorner;
use crate::geometry::tessellate::{NO_CHORD, OWN, Tessellation};
use crate::geometry::triangle::angle_between;
use crate::geometry::{Point, Rigid, Vector};

/// A face beside a chord, with its parameters at both of the chord's ends, in the chord's sense.
#[derive(Clone, Copy, Debug)]
struct Beside {
    face: u32,
    uv: [[f64; 2]; 2],
}

/// What meets in a vertex: the weighted normals' sum, whether one is lacking, and the ends of
/// edges.
#[derive(Default)]
struct Vertex {
    sum: Vector,
    lacks: bool,
    ends: Vec<(u32, usize)>,
}

/// Which faces meet in which edges, and in which vertices with what pseudonormals.
#[derive(Clone, Debug, Default)]
pub(super) struct Corners {
    /// Per edge: its chords' ends, increasing, and per chord the faces beside it.
    edges: Vec<(Vec<f64>, Vec<Vec<Beside>>)>,
    /// Per edge: its two end vertices, as indices into `vertices`.
    ends: Vec<[Option<u32>; 2]>,
    /// Angle-weighted sums of outward normals.
    vertices: Vec<Vector>,
}

impl Corners {
    pub fn new(t: &Tessellation, regions: &[TrimTest]) -> Self {
        let mut beside: Vec<Vec<Beside>> = vec![Vec::new(); t.chords.len()];
        for (f, trim) in t.trims.iter().enumerate() {
            for ring in &trim.rings {
                for (k, n) in ring.nodes.iter().enumerate() {
                    if let (Some(list), false) = (beside.get_mut(n.chord as usize), n.seam) {
                        let next = ring.nodes[(k + 1) % ring.nodes.len()].uv;
                        let uv = if n.against { [next, n.uv] } else { [n.uv, next] };
                        list.push(Beside { face: f as u32, uv });
                    }
                }
            }
        }
        let mut edges = vec![(Vec::new(), Vec::new()); t.brep.edges.len()];
        for (chord, list) in t.chords.iter().zip(beside) {
            let (ts, per): &mut (Vec<f64>, Vec<Vec<Beside>>) = &mut edges[chord.edge as usize];
            if ts.is_empty() {
                ts.push(chord.t[0]);
            }
            ts.push(chord.t[1]);
            per.push(list);
        }
        let mut out = Corners { edges, ends: vec![[None; 2]; t.brep.edges.len()], vertices: Vec::new() };
        out.weigh(t, regions);
        out
    }

    /// Sums normals at the ends of edges.
    fn weigh(&mut self, t: &Tessellation, regions: &[TrimTest]) {
        let mut at: BTreeMap<u32, Vertex> = BTreeMap::new();
        for (f, trim) in t.trims.iter().enumerate() {
            for (r, ring) in trim.rings.iter().enumerate() {
                for (k, node) in ring.nodes.iter().enumerate().filter(|(_, n)| n.chord != NO_CHORD && n.id < OWN) {
                    let Some(end) = end_there(t, node.chord, node.against) else { continue };
                    let vertex = at.entry(node.id).or_default();
                    vertex.ends.push(end);
                    let before = &ring.nodes[(k + ring.nodes.len() - 1) % ring.nodes.len()];
                    match corner(t, f, node, before, regions[f].is_left(r)) {
                        Some(n) => vertex.sum += n,
                        None => vertex.lacks = true,
                    }
                    vertex.ends.extend(end_there(t, before.chord, !before.against));
                }
            }
        }
        for vertex in at.into_values().filter(|v| !v.lacks) {
            for (edge, end) in vertex.ends {
                self.ends[edge as usize][end] = Some(self.vertices.len() as u32);
            }
            self.vertices.push(vertex.sum);
        }
    }

    /// After a rigid motion.
    #[must_use]
    pub fn moved(mut self, to_from: &Rigid) -> Self {
        self.vertices.iter_mut().for_each(|v| *v = to_from * *v);
        self
    }

    /// Whether an edge is more than a seam.
    pub fn bounds_faces(&self, edge: usize) -> bool {
        self.edges.get(edge).is_some_and(|e| e.1.iter().any(|list| !list.is_empty()))
    }

    /// The faces that meet in an edge at a parameter, each with a guess at its parameters there.
    pub fn faces_at(&self, edge: u32, t: f64) -> impl Iterator<Item = (u32, [f64; 2])> + '_ {
        let (ts, per) = &self.edges[edge as usize];
        let k = ts.partition_point(|x| *x <= t).clamp(1, ts.len().saturating_sub(1).max(1)) - 1;
        let span = ts.get(k).zip(ts.get(k + 1));
        let share = span.map_or(0.0, |(a, b)| ((t - a) / (b - a)).clamp(0.0, 1.0));
        let between = move |b: &Beside| (b.face, [0, 1].map(|a| b.uv[0][a] + share * (b.uv[1][a] - b.uv[0][a])));
        per.get(k).into_iter().flatten().map(between)
    }
}

/// The end of an edge at which one of its chords begins, seen in the ring's sense, if it is one.
fn end_there(t: &Tessellation, chord: u32, against: bool) -> Option<(u32, usize)> {
    let c = t.chords.get(chord as usize)?;
    let end = usize::from(against);
    (c.t[end] == t.brep.edges[c.edge as usize].t[end]).then_some((c.edge, end))
}

/// The direction in which a chord's edge leaves the chord's beginning, seen in the ring's sense.
fn leaving(t: &Tessellation, chord: u32, against: bool) -> Option<Vector> {
    let c = t.chords.get(chord as usize)?;
    let (_, d, _) = t.brep.edges[c.edge as usize].curve.derivatives(c.t[usize::from(against)]);
    (if against { -d } else { d }).try_normalize(0.0)
}

/// A face's outward normal at a node of its ring, times the angle that the face spans there; `None`
/// at poles and bridges.
fn corner(t: &Tessellation, face: usize, node: &RingCorner, before: &RingCorner, left: bool) -> Option<Vector> {
    let (away, back) = (leaving(t, node.chord, node.against)?, leaving(t, before.chord, !before.against)?);
    let space = &t.trims[face].space;
    let uv = space.normal_form(node.uv);
    let at = t.brep.faces[face].surface.derivatives(uv[0], uv[1]);
    if is_pole(&at, space) {
        return None;
    }
    let normal = at.normal()?;
    // Counter-clockwise about S_u × S_v from the way on to the way back, if the face lies to the
    // left of its ring.
    let turned = away.cross(&back).dot(&normal) * if left { 1.0 } else { -1.0 };
    let angle = angle_between(&away, &back);
    let angle = if turned < 0.0 { std::f64::consts::TAU - angle } else { angle };
    Some(normal * if t.brep.faces[face].reversed { -angle } else { angle })
}

/// An end of an edge counts as met within this, mm.
const AT_VERTEX_MM: f64 = 1e-9;

impl Exact {
    /// Whether `q` lies inside the part, whose faces must enclose it; a point on the part counts as
    /// outside.
    pub fn inside(&self, brep: &Brep, q: &Point) -> bool {
        let Some(found) = search::closest(self, brep, q, f64::INFINITY, search::NEGLIGIBLE_MM) else { return false };
        let direction = q - found.point;
        let normal = match found.on {
            On::Face { .. } => self.finish(brep, q, &found).normal,
            On::Edge { edge, t, .. } => {
                let ends = brep.edges[edge as usize].t;
                let curve = &brep.edges[edge as usize].curve;
                let met = (0..2).find(|k| (curve.point(ends[*k]) - found.point).norm() <= AT_VERTEX_MM);
                let vertex = met.and_then(|k| self.corners.ends[edge as usize][k]);
                match vertex.and_then(|v| self.corners.vertices.get(v as usize)) {
                    Some(v) => *v,
                    None => {
                        let faces = self.corners.faces_at(edge, t);
                        faces.filter_map(|(face, guess)| self.normal_on(brep, face, guess, &found.point).1).sum()
                    }
                }
            }
        };
        direction.dot(&normal) < 0.0
    }
}
