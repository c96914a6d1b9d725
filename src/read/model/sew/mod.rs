//! Loose faces sewn to one part: edges that faces repeat become shared edges, without which a
//! tessellation has cracks.
//!
//! In: faces whose edges may be shared (solids of STEP and IGES) or not (loose faces, some writers
//! of solids). In this order, for a tolerance and then for a coarser one where edges are still
//! open:
//!
//! 1. a face without loops gets the boundary of its parameter rectangle; edges shorter than the
//!    tolerance go ([`faces`]);
//! 2. slivers (faces no wider than the tolerance) and faces that repeat another go ([`faces`]);
//! 3. edges that coincide are joined in pairs, those nearest to one another first; two edges of one
//!    face only where nothing else fits (a seam);
//! 4. an open edge that passes the end of another open edge is cut there ([`split`]), and 3 is done
//!    again (T-junctions).
//!
//! Guarantees: only edges that one face uses once are touched; curves are never moved, one of two
//! takes the place of the other, so that a face's edge may leave its surface by the gap that is
//! reported. Everything that was done is in [`Sewn`].
//!
//! [`curve::from_vertex`]: a closed edge begins at its vertex, wherever the file's curve begins, so
//! that loops are continuous.

pub mod curve;
pub mod faces;
pub mod split;

pub use curve::{backwards, from_vertex};

use crate::geometry::Point;
use crate::geometry::brep::Brep;
use crate::observe::Remark;
use curve::{coincide, hull, slack};

/// What sewing did.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sewn {
    /// Pairs of edges that became one.
    pub joined: usize,
    /// Greatest distance between two edges that were joined, mm.
    pub gap_mm: f64,
    /// Edges that were cut where another one ends.
    pub cut: usize,
    /// Edges that were dropped since they are shorter than the tolerance.
    pub short: usize,
    /// Names of faces that were dropped since they are no wider than the tolerance.
    pub slivers: Vec<String>,
    /// Names of faces that were dropped, and of those that they repeat.
    pub repeated: Vec<(String, String)>,
    /// Edges that only one face uses, once, afterwards.
    pub open: usize,
    /// Middle of the first of them, mm.
    pub first_open: Option<Point>,
}

impl Sewn {
    /// What was done.
    pub fn notes(&self) -> Vec<Remark> {
        let mut out = Vec::new();
        if self.joined > 0 {
            out.push(Remark::EdgesJoined { count: self.joined, gap_mm: self.gap_mm });
        }
        if self.cut > 0 {
            out.push(Remark::EdgesCut { count: self.cut });
        }
        if self.short > 0 {
            out.push(Remark::EdgesDropped { count: self.short });
        }
        if !self.slivers.is_empty() {
            out.push(Remark::SliversDropped { faces: self.slivers.clone() });
        }
        if !self.repeated.is_empty() {
            let faces = self.repeated.iter().map(|(a, b)| [a.clone(), b.clone()]).collect();
            out.push(Remark::RepeatedFaces { faces });
        }
        out
    }
}

/// Two open edges that coincide.
#[derive(Clone, Copy, Debug)]
pub struct Match {
    /// Their indices.
    pub edges: [usize; 2],
    /// They run in opposite senses.
    pub opposite: bool,
    /// Greatest distance found, mm.
    pub gap_mm: f64,
}

/// Sews, with each tolerance in turn as long as edges are open.
pub fn sew(brep: &mut Brep, tolerances_mm: &[f64]) -> Sewn {
    let mut out = Sewn::default();
    faces::write_out_natural_loops(brep);
    for &tolerance_mm in tolerances_mm {
        if open_edges(brep).is_empty() {
            break;
        }
        out.short += faces::drop_short_edges(brep, tolerance_mm);
        out.slivers.extend(faces::drop_slivers(brep, tolerance_mm));
        let found = matches(brep, tolerance_mm);
        let repeated = faces::drop_repeated(brep, &found, tolerance_mm);
        // Dropping faces leaves edges without use, not other numbers.
        join(brep, &found, &mut out);
        out.repeated.extend(repeated);
        // Each round of cuts can bring forth ends at which the neighbour has to be cut.
        for _ in 0..3 {
            let cut = split::split_at_ends(brep, tolerance_mm);
            out.cut += cut;
            if cut == 0 {
                break;
            }
            let found = matches(brep, tolerance_mm);
            join(brep, &found, &mut out);
        }
    }
    drop_unused(brep);
    let open = open_edges(brep);
    out.open = open.len();
    out.first_open = open.first().map(|e| brep.edges[*e].at(0.5));
    out
}

/// How often loops use each edge.
pub fn uses(brep: &Brep) -> Vec<usize> {
    let mut uses = vec![0; brep.edges.len()];
    for c in brep.faces.iter().flat_map(|f| f.loops.iter().flatten()) {
        if let Some(n) = uses.get_mut(c.edge) {
            *n += 1;
        }
    }
    uses
}

/// Edges that are used once.
pub fn open_edges(brep: &Brep) -> Vec<usize> {
    uses(brep).iter().enumerate().filter(|(_, n)| **n == 1).map(|(i, _)| i).collect()
}

/// The face of every edge: the last that uses it.
fn face_of(brep: &Brep) -> Vec<usize> {
    let mut out = vec![usize::MAX; brep.edges.len()];
    for (f, face) in brep.faces.iter().enumerate() {
        face.loops.iter().flatten().for_each(|c| out[c.edge] = f);
    }
    out
}

/// All pairs of open edges that coincide, those nearest to one another first, pairs within one face
/// last.
pub fn matches(brep: &Brep, tolerance_mm: f64) -> Vec<Match> {
    let face_of = face_of(brep);
    // A sweep along x over the edges' boxes, widened by what samples may miss.
    let mut boxed: Vec<_> = open_edges(brep).into_iter().map(|e| (e, hull(&brep.edges[e]))).collect();
    boxed.sort_by(|a, b| a.1.min.x.total_cmp(&b.1.min.x).then(a.0.cmp(&b.0)));
    let widest = boxed.iter().map(|(_, b)| slack(b)).fold(0.0, f64::max) + tolerance_mm;
    let mut out = Vec::new();
    for (k, (i, a)) in boxed.iter().enumerate() {
        for (j, b) in boxed[k + 1..].iter().take_while(|(_, b)| b.min.x - a.min.x <= widest) {
            let off = tolerance_mm + slack(a).max(slack(b));
            if (a.min - b.min).amax() > off || (a.max - b.max).amax() > off {
                continue;
            }
            let edges = [*i.min(j), *i.max(j)];
            if let Some((opposite, gap_mm)) = coincide(&brep.edges[edges[0]], &brep.edges[edges[1]], tolerance_mm) {
                out.push(Match { edges, opposite, gap_mm });
            }
        }
    }
    let within = |m: &Match| face_of[m.edges[0]] == face_of[m.edges[1]];
    out.sort_by(|a, b| within(a).cmp(&within(b)).then(a.gap_mm.total_cmp(&b.gap_mm)).then(a.edges.cmp(&b.edges)));
    out
}

/// Joins pairs, each edge once: the second of a pair gives way to the first.
fn join(brep: &mut Brep, found: &[Match], out: &mut Sewn) {
    let uses = uses(brep);
    let mut taken: Vec<bool> = uses.iter().map(|n| *n != 1).collect();
    let mut instead: Vec<Option<(usize, bool)>> = vec![None; brep.edges.len()];
    for m in found {
        let [a, b] = m.edges;
        if taken[a] || taken[b] {
            continue;
        }
        (taken[a], taken[b]) = (true, true);
        instead[b] = Some((a, m.opposite));
        out.joined += 1;
        out.gap_mm = out.gap_mm.max(m.gap_mm);
    }
    for c in brep.faces.iter_mut().flat_map(|f| f.loops.iter_mut().flatten()) {
        if let Some(Some((edge, opposite))) = instead.get(c.edge) {
            c.edge = *edge;
            c.reversed ^= opposite;
        }
    }
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
mod tests;
