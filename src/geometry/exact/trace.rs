//! Where an edge that lies off a face bounds it.
//!
//! A model's edges may lie off its faces, within the tolerance that the file gives them or that
//! sewing took. Such a face ends where the foot of its edge runs on it, and the point of the face
//! nearest to another may lie there, nearer than any of the edge. So beside the edge the search has
//! that line, the *trace* of the edge on the face, as a chain of segments within [`STRAIGHT_MM`] of
//! it.

use nalgebra::Vector4;

use super::measure::{Loops, OnFace};
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Edge};
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::tessellate::loops::RingCorner;

/// An edge nearer than this to a face bounds it by itself, mm.
const APART_MM: f64 = 1e-3;
/// Traces are within this of their segments, mm.
const STRAIGHT_MM: f64 = 1e-4;
/// No segment is halved more often.
const DEEPEST: u32 = 10;

/// The trace of a chord of an edge on a face, over the edge's own parameter.
#[derive(Clone, Debug)]
pub(super) struct Trace {
    pub edge: u32,
    pub face: u32,
    pub curve: NurbsCurve,
}

/// A place of a trace: parameter of the edge, parameters of the face, point of the face.
type TracePlace = (f64, [f64; 2], Point);

/// Of all edges that lie off a face that they bound.
pub(super) fn traces(brep: &Brep, loops: &Loops) -> Vec<Trace> {
    let mut out = Vec::new();
    for (f, region) in loops.regions.iter().enumerate().filter(|(_, r)| r.trim.blur_mm > APART_MM) {
        let on = TracedFace { loops, on: loops.face(brep, f) };
        for ring in &region.trim.rings {
            let next = |k: usize| &ring.nodes[(k + 1) % ring.nodes.len()];
            let chords: Vec<[TracePlace; 2]> =
                ring.nodes.iter().enumerate().filter_map(|(k, n)| on.chord(n, next(k))).collect();
            // All of an edge that leaves the face somewhere, so that its traces hang together.
            let mut apart = vec![false; brep.edges.len()];
            let edge = |n: &RingCorner| loops.chords.get(n.chord as usize).map(|c| c.edge);
            let bounding = || ring.nodes.iter().filter(|n| !n.seam).filter_map(edge);
            for (e, places) in bounding().zip(&chords) {
                let curve = &brep.edges[e as usize].curve;
                apart[e as usize] |= places.iter().any(|(t, _, p)| (curve.point(*t) - p).norm() > APART_MM);
            }
            for (e, places) in bounding().zip(chords).filter(|(e, _)| apart[*e as usize]) {
                let curve = on.trace(&brep.edges[e as usize], places);
                out.extend(curve.map(|curve| Trace { edge: e, face: f as u32, curve }));
            }
        }
    }
    out
}

/// A face beside its edges.
struct TracedFace<'a> {
    loops: &'a Loops,
    on: OnFace<'a>,
}

impl TracedFace<'_> {
    /// Both ends of a side of a ring, in the sense of its edge; `None` where it stands for no edge
    /// that bounds the face.
    fn chord(&self, from: &RingCorner, to: &RingCorner) -> Option<[TracePlace; 2]> {
        let chord = self.loops.chords.get(from.chord as usize).filter(|_| !from.seam)?;
        let place = |t: f64, n: &RingCorner| (t, n.uv, self.on.at(n.uv));
        let [a, b] = if from.against { [to, from] } else { [from, to] };
        Some([place(chord.t[0], a), place(chord.t[1], b)])
    }

    /// The trace between two places: halved until it is straight.
    fn trace(&self, edge: &Edge, [from, to]: [TracePlace; 2]) -> Option<NurbsCurve> {
        let (mut kept, mut open) = (vec![from], vec![(to, 0)]);
        while let (Some(&a), Some((b, depth))) = (kept.last(), open.pop()) {
            let t = 0.5 * (a.0 + b.0);
            let foot =
                self.on.surface.foot(&edge.curve.point(t), [0, 1].map(|k| 0.5 * (a.1[k] + b.1[k])), self.on.space);
            let off = (foot.at.p - nalgebra::center(&a.2, &b.2)).norm();
            if depth >= DEEPEST || (depth > 0 && off <= STRAIGHT_MM) {
                kept.push(b);
            } else {
                open.extend([(b, depth + 1), ((t, foot.uv, foot.at.p), depth + 1)]);
            }
        }
        // Where the edge's parameter does not grow there is no line.
        if !kept.windows(2).all(|w| w[0].0 < w[1].0) {
            return None;
        }
        let ends = [kept[0].0, kept[kept.len() - 1].0];
        let inner = kept.iter().map(|k| k.0);
        let knots = std::iter::once(ends[0]).chain(inner).chain([ends[1]]).collect();
        let points = kept.iter().map(|(_, _, p)| Vector4::new(p.x, p.y, p.z, 1.0)).collect();
        Some(NurbsCurve { degree: 1, knots, points })
    }
}
