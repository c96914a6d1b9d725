//! The search for the closest point: best first over the tree, Newton on each piece that can hold
//! it.
//!
//! A piece is left out when the box in which it lies is no nearer than the best point known. It is
//! left out too when it bends towards the query point more than a sphere about it everywhere: then
//! it has no local minimum inside. Otherwise Newton finds its minimum.
//!
//! That minimum is the only one if the distance is convex on the piece. This follows if the piece's
//! curvature lies in the range measured on it. If it does not follow, the least eigenvalue of the
//! Hessian says by how much another minimum could be nearer. Where that is more than
//! [`NEGLIGIBLE_MM`] the piece is halved and its halves are searched.
//!
//! Left out too is a piece to whose normals `q` cannot belong ([`Leaf::may_hold_foot`]), and of a
//! piece that loops cross the halves beyond them. About a point from which a whole stretch is
//! equally far (the axis of a round face) halving would have no end: the more pieces a query has
//! halved, the more is negligible to it, up to [`MOST_NEGLIGIBLE_MM`].

use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::Exact;
use super::leaf::{FaceForm, Leaf, LeafArc, NO_BORDER, Rect, extents, hull};
use super::newton::{Foot, foot_on_arc, foot_on_piece};
use super::patch::CurveTable;
use super::tree::{Child, Seen};
use super::trim::{Border, EdgeChords, TrimKind};
use crate::geometry::brep::Brep;
use crate::geometry::nurbs::SurfaceDerivatives;
use crate::geometry::{Point, Vector};

/// A minimum that could be nearer by no more than this is not looked for, mm, as a rule.
pub(super) const NEGLIGIBLE_MM: f64 = 1e-7;
/// What [`NEGLIGIBLE_MM`] grows to, mm, doubled with every [`PATIENCE`] pieces that a query halves.
const MOST_NEGLIGIBLE_MM: f64 = 1e-4;
const PATIENCE: u32 = 16;
/// No piece is halved more often.
const DEEPEST: u32 = 48;
/// A query halves at most this many pieces: a bound on its time.
const MOST_CUTS: u32 = 5_000;

/// The closest point, and what it lies on.
#[derive(Clone, Copy, Debug)]
pub(super) struct FoundPoint {
    pub d2: f64,
    pub point: Point,
    pub on: On,
}

/// What a foot lies on.
#[derive(Clone, Copy, Debug)]
pub(super) enum On {
    /// A face, at these of its parameters, with this normal `S_u × S_v` (not of unit length; zero
    /// at a pole).
    Face { face: u32, uv: [f64; 2], normal: Vector },
    /// An edge, at this parameter, or its trace on the face `of`.
    Edge { edge: u32, t: f64, of: Option<u32> },
}

/// Something to look at: a node, a piece of a face, of an edge, or a piece of a piece.
type Entry = Reverse<(u64, u32)>;
const LEAF: u64 = 1;
const PART_OF_LEAF: u64 = 2;
const PART_OF_ARC: u64 = 3;

thread_local! {
    /// Storage that queries of one thread use one after another.
    static HEAP: Cell<BinaryHeap<Entry>> = const { Cell::new(BinaryHeap::new()) };
}

/// A squared distance that sorts as an integer, with two bits for what it belongs to. Rounded down
/// by a part in 2⁵⁰.
fn key(d2: f64, what: u64) -> u64 {
    (d2.to_bits() & !3) | what
}

struct ClosestSearch<'a> {
    exact: &'a Exact,
    brep: &'a Brep,
    q: Point,
    best: Option<FoundPoint>,
    limit2: f64,
    /// Nothing farther need be looked at: as `limit2`, or less where a point of the part is known
    /// to be nearer.
    reach2: f64,
    /// Whether points known to be on the part lower `reach2`, and pieces are left out by their
    /// normals.
    eager: bool,
    /// Parts of pieces, in their boxes, and how often they were halved.
    leaves: Vec<(Leaf, u32)>,
    /// Borders of `leaves`, numbered on from those of all faces.
    borders: Vec<Vec<Border>>,
    arcs: Vec<(LeafArc, u32)>,
    cuts: u32,
    /// A minimum that could be nearer by no more than this is not looked for, mm, at first.
    negligible_mm: f64,
}

/// A point no farther than `cap_mm`, and no more than `negligible_mm` farther than the closest.
pub(super) fn closest(exact: &Exact, brep: &Brep, q: &Point, cap_mm: f64, negligible_mm: f64) -> Option<FoundPoint> {
    counted(exact, brep, q, cap_mm, negligible_mm).0
}

/// The same, and how many pieces were halved for it.
pub(super) fn counted(
    exact: &Exact,
    brep: &Brep,
    q: &Point,
    cap_mm: f64,
    negligible_mm: f64,
) -> (Option<FoundPoint>, u32) {
    if !q.coords.iter().all(|x| x.is_finite()) || exact.tree.is_empty() || !(cap_mm >= 0.0) {
        return (None, 0);
    }
    let mut heap = HEAP.take();
    heap.clear();
    // One ulp or so more keeps a point at the cap itself.
    let limit2 = (cap_mm * cap_mm * (1.0 + 4.0 * f64::EPSILON)).min(f64::MAX);
    let mut search = ClosestSearch {
        exact,
        brep,
        q: *q,
        best: None,
        limit2,
        reach2: limit2,
        eager: true,
        leaves: Vec::new(),
        borders: Vec::new(),
        arcs: Vec::new(),
        cuts: 0,
        negligible_mm,
    };
    search.run(&mut heap);
    let promised =
        |s: &ClosestSearch| s.best.is_none_or(|b| b.d2.sqrt() > s.reach2.sqrt() + 2.0 * s.most_negligible_mm());
    if search.reach2 < limit2 && promised(&search) {
        // A point was promised, but Newton found none as near: once more, without promises.
        (search.eager, search.reach2) = (false, search.limit2);
        heap.clear();
        search.run(&mut heap);
    }
    HEAP.set(heap);
    (search.best, search.cuts)
}

/// Takes the nearest of the heap and of one entry beside it.
fn next(beside: Option<Entry>, heap: &mut BinaryHeap<Entry>) -> Option<Entry> {
    let Some(entry) = beside else { return heap.pop() };
    Some(match heap.peek_mut() {
        Some(mut top) if *top > entry => std::mem::replace(&mut *top, entry),
        _ => entry,
    })
}

impl ClosestSearch<'_> {
    fn run(&mut self, heap: &mut BinaryHeap<Entry>) {
        let seen = self.exact.tree.see(&self.q);
        let mut nearest = self.open(0, &seen, heap);
        while let Some(Reverse((k, id))) = next(nearest.take(), heap) {
            if f64::from_bits(k & !3) >= self.reach2 {
                break;
            }
            match k & 3 {
                LEAF => {
                    let (exact, leaves) = (self.exact, self.exact.leaves.len() as u32);
                    if id < leaves {
                        let leaf = &exact.leaves[id as usize];
                        if self.may_be_nearer(leaf) {
                            self.face_piece(leaf, 0, heap);
                        }
                    } else {
                        let arc = &exact.arcs[(id - leaves) as usize];
                        if arc.distance2(&self.q) < self.reach2 {
                            self.edge_piece(arc, 0, heap);
                        }
                    }
                }
                PART_OF_LEAF => {
                    let (mut leaf, depth) = self.leaves[id as usize];
                    // Not before: half of the parts are never looked at.
                    leaf.measure_bend(&self.exact.shape(self.brep, leaf.rect.face));
                    if !self.eager || leaf.may_hold_foot(&self.q) {
                        self.face_piece(&leaf, depth, heap);
                    }
                }
                PART_OF_ARC => {
                    let (arc, depth) = self.arcs[id as usize];
                    self.edge_piece(&arc, depth, heap);
                }
                _ => nearest = self.open(id, &seen, heap),
            }
        }
    }

    /// Puts what a node holds on the heap, but for the nearest, which is returned.
    fn open(&mut self, node: u32, seen: &Seen, heap: &mut BinaryHeap<Entry>) -> Option<Entry> {
        let mut nearest: Option<Entry> = None;
        self.exact.tree.open(node, seen, self.eager, self.reach2, |child, d2| {
            let entry = match child {
                Child::Node(n) => Reverse((key(d2, 0), n)),
                Child::Item(i) => Reverse((key(d2, LEAF), i)),
            };
            match &mut nearest {
                Some(n) if entry > *n => heap.push(std::mem::replace(n, entry)),
                Some(_) => heap.push(entry),
                None => nearest = Some(entry),
            }
        });
        nearest
    }

    /// Whether a piece may hold a point nearer than those known; lowers `reach2` to one of its
    /// points.
    fn may_be_nearer(&mut self, leaf: &Leaf) -> bool {
        let known2 = (leaf.centre - self.q).norm_squared() * (1.0 + 1e-12);
        if self.eager && leaf.border == NO_BORDER && known2 < self.reach2 {
            self.reach2 = known2;
        }
        (!self.eager || leaf.may_hold_foot(&self.q)) && leaf.slab.distance2(&self.q) < self.reach2
    }

    fn keep(&mut self, d2: f64, point: Point, on: On) {
        if d2 < self.limit2 {
            self.limit2 = d2;
            self.reach2 = self.reach2.min(d2);
            self.best = Some(FoundPoint { d2, point, on });
        }
    }

    /// Looks for the closest point of a piece of a face.
    fn face_piece(&mut self, leaf: &Leaf, depth: u32, heap: &mut BinaryHeap<Entry>) {
        let shape = self.exact.shape(self.brep, leaf.rect.face);
        let mut bend = leaf.bend_at(&self.q);
        if matches!(bend, Minima::Unsure(_)) && !leaf.wild {
            bend = leaf.bend_sampled(&shape, &self.q);
        }
        if bend == Minima::NoMinimum {
            return;
        }
        let foot = foot_on_piece(&shape, leaf, &self.q);
        if foot.d2 < self.limit2 && self.counts(&shape, leaf, &foot) {
            let uv = shape.uv(leaf.rect.span, foot.st);
            let normal = foot.at.du.cross(&foot.at.dv);
            // Of a pole's normal only rounding is left.
            let size = foot.at.du.norm() * foot.at.dv.norm();
            let normal = if normal.norm() > 1e-10 * size { normal } else { Vector::zeros() };
            self.keep(foot.d2, foot.point, On::Face { face: leaf.rect.face, uv, normal });
        }
        let beyond = match bend {
            Minima::Unsure(beyond) => beyond,
            _ if foot.settled => return,
            _ => f64::INFINITY,
        };
        // Nothing in the piece is nearer than this: Taylor with the least eigenvalue of the
        // Hessian.
        let across = 2.0 * leaf.slab.radius();
        let least2 = if foot.settled { foot.d2 - beyond * across * across } else { f64::NEG_INFINITY };
        if least2 >= self.worth(foot.d2) || depth >= DEEPEST || self.cuts >= MOST_CUTS {
            return;
        }
        if depth == 0 && leaf.border != NO_BORDER {
            self.look_beside(leaf);
        }
        self.cuts += 1;
        let size = if leaf.wild {
            let (points, row) = hull(&shape, &leaf.rect);
            extents(&points, row)
        } else {
            let width = leaf.rect.range.map(|[from, to]| to - from);
            [foot.at.du.norm() * width[0], foot.at.dv.norm() * width[1]]
        };
        for half in leaf.rect.halves(usize::from(size[1] > size[0])) {
            let (points, _) = hull(&shape, &half);
            let mut child = Leaf::boxed(&shape, half, &points);
            let d2 = child.slab.distance2(&self.q);
            if d2 >= self.worth(d2) {
                continue;
            }
            match self.border_of(leaf, &shape, &half) {
                TrimKind::Outside => continue,
                TrimKind::Inside => child.border = NO_BORDER,
                TrimKind::Crossed(borders) => {
                    child.border = (self.exact.borders.len() + self.borders.len()) as u32;
                    self.borders.push(borders);
                }
            }
            heap.push(Reverse((key(d2, PART_OF_LEAF), self.leaves.len() as u32)));
            self.leaves.push((child, depth + 1));
        }
    }

    /// The borders of a piece that loops cross.
    fn borders(&self, leaf: &Leaf) -> &[Border] {
        let k = leaf.border as usize;
        let all = self.exact.borders.get(k).or_else(|| self.borders.get(k - self.exact.borders.len()));
        all.map_or(&[], Vec::as_slice)
    }

    /// What the loops make of a part of a piece.
    fn border_of(&self, leaf: &Leaf, shape: &FaceForm, half: &Rect) -> TrimKind {
        if leaf.border == NO_BORDER {
            return TrimKind::Inside;
        }
        self.exact.loops.regions[leaf.rect.face as usize].kind(shape, half, Some(self.borders(leaf)))
    }

    /// Lowers what need be looked at to points on the edges beside a piece: its own nearest point
    /// may not be the face's.
    fn look_beside(&mut self, leaf: &Leaf) {
        let region = &self.exact.loops.regions[leaf.rect.face as usize];
        for p in region.points_beside(self.brep, &self.exact.loops.chords, self.borders(leaf)) {
            let known2 = (p - self.q).norm_squared() * (1.0 + 1e-12);
            if self.eager && known2 < self.reach2 {
                self.reach2 = known2;
            }
        }
    }

    fn most_negligible_mm(&self) -> f64 {
        self.negligible_mm.max(MOST_NEGLIGIBLE_MM)
    }

    /// What a squared distance must be below to be worth looking for.
    fn worth(&self, d2: f64) -> f64 {
        let least = (self.negligible_mm * f64::from(self.cuts / PATIENCE).exp2()).min(self.most_negligible_mm());
        let at = d2.max(0.0).min(self.reach2);
        self.reach2 - 2.0 * least * at.sqrt() - least * least
    }

    /// Whether a foot belongs to its face.
    fn counts(&self, shape: &FaceForm, leaf: &Leaf, foot: &Foot) -> bool {
        if leaf.border == NO_BORDER {
            return true;
        }
        // Where the piece ends and the distance still falls beyond, the next piece or an edge is
        // nearer. Elsewhere Newton has settled: what its last step leaves of the slope grows with
        // the bend, and says nothing.
        let r = self.q - foot.point;
        let falls = |a: usize, d: &Vector| {
            let (slope, [from, to]) = (r.dot(d), leaf.rect.range[a]);
            let beyond = !foot.settled || if slope < 0.0 { foot.st[a] <= from } else { foot.st[a] >= to };
            beyond && slope.abs() > 1e-6 * d.norm() * r.norm().max(1e-3)
        };
        let (nu, nv) = (foot.at.du.norm(), foot.at.dv.norm());
        let pole = nu.min(nv) < 1e-9 * nu.max(nv);
        if !pole && (falls(0, &foot.at.du) || falls(1, &foot.at.dv)) {
            return false;
        }
        let region = &self.exact.loops.regions[leaf.rect.face as usize];
        let [hu, hv] = [0, 1].map(|a| shape.frame(a, leaf.rect.span[a])[1]);
        let at = SurfaceDerivatives { p: foot.point, du: foot.at.du / hu, dv: foot.at.dv / hv, ..foot.at };
        let uv = shape.uv(leaf.rect.span, foot.st);
        let edges = EdgeChords { brep: self.brep, chords: &self.exact.loops.chords };
        region.holds(edges, self.borders(leaf), uv, &at)
    }

    /// Looks for the closest point of a piece of an edge.
    fn edge_piece(&mut self, arc: &LeafArc, depth: u32, heap: &mut BinaryHeap<Entry>) {
        let table = &self.exact.curves[arc.edge as usize];
        let foot = foot_on_arc(table, arc, &self.q);
        if foot.d2 < self.limit2 {
            let [middle, half] = table.spans.frame(arc.span as usize);
            let trace = (arc.edge as usize).checked_sub(self.brep.edges.len()).map(|k| &self.exact.traces[k]);
            let (edge, of) = trace.map_or((arc.edge, None), |trace| (trace.edge, Some(trace.face)));
            self.keep(foot.d2, foot.point, On::Edge { edge, t: middle + half * foot.s, of });
        }
        let mut beyond = arc.beyond(&self.q);
        if beyond > 0.0 && beyond.is_finite() {
            beyond = arc.beyond_sampled(table, &self.q);
        }
        if beyond <= 0.0 && foot.settled {
            return;
        }
        let beyond = if foot.settled { beyond } else { f64::INFINITY };
        let length = arc.length() * 1.1;
        let least2 = if foot.settled { foot.d2 - beyond * length * length } else { f64::NEG_INFINITY };
        if least2 >= self.worth(foot.d2) || depth >= DEEPEST || self.cuts >= MOST_CUTS {
            return;
        }
        self.cuts += 1;
        let middle = 0.5 * (arc.range[0] + arc.range[1]);
        for range in [[arc.range[0], middle], [middle, arc.range[1]]] {
            let child = LeafArc::new(table, arc.edge, arc.span, range);
            let d2 = child.distance2(&self.q);
            if d2 < self.worth(d2) {
                heap.push(Reverse((key(d2, PART_OF_ARC), self.arcs.len() as u32)));
                self.arcs.push((child, depth + 1));
            }
        }
    }
}

/// What the curvature of a piece says about minima of the distance on it.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Minima {
    /// Convex: one minimum.
    One,
    /// None inside.
    NoMinimum,
    /// The Hessian of half the squared distance may have eigenvalues down to minus this.
    Unsure(f64),
}

impl Leaf {
    /// Bounds of `1 - κ s` for all curvatures `κ` of the piece, with `s` the height of `q` above
    /// its tangent planes.
    pub(super) fn bend_at(&self, q: &Point) -> Minima {
        if self.wild {
            return Minima::Unsure(f64::INFINITY);
        }
        let r = q - self.slab.middle;
        let height = r.dot(&self.slab.axes[2]);
        let aside = (r.norm_squared() - height * height).max(0.0).sqrt() + self.slab.radius();
        let slack = self.slab.half[2] * 2.0 + height.abs() * self.turn[1] + aside * self.turn[0];
        let (low, high) = (height - slack, height + slack);
        let most =
            (self.greater[1] * high).max(self.greater[1] * low).max(self.lesser[0] * low).max(self.lesser[0] * high);
        if most < 1.0 {
            return Minima::One;
        }
        if (low > 0.0 && self.greater[0] * low > 1.0) || (high < 0.0 && self.lesser[1] * high > 1.0) {
            return Minima::NoMinimum;
        }
        Minima::Unsure(most - 1.0)
    }

    /// The same from 3 × 3 places, with half of what they differ by as a margin: dearer, but not
    /// misled where a query point is the centre of curvature of the whole piece.
    fn bend_sampled(&self, shape: &FaceForm, q: &Point) -> Minima {
        // The greatest eigenvalue of the product of curvature and height, at its least and at its
        // greatest.
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for st in self.rect.places() {
            let d = shape.local(self.rect.span, st);
            let Some((n, [greater, lesser])) = d.bent() else { return Minima::Unsure(f64::INFINITY) };
            let s = (q - d.p).dot(&n);
            let here = (greater * s).max(lesser * s);
            (least, most) = (least.min(here), most.max(here));
        }
        let margin = 0.5 * (most - least);
        if most + margin < 1.0 {
            Minima::One
        } else if least - margin > 1.0 {
            Minima::NoMinimum
        } else {
            Minima::Unsure(most + margin - 1.0)
        }
    }
}

impl LeafArc {
    /// How far below zero the second derivative of half the squared distance by arc length may be;
    /// not positive where convex.
    fn beyond(&self, q: &Point) -> f64 {
        let middle = nalgebra::center(&self.ends[0], &self.ends[1]);
        let reach = 0.5 * (self.ends[1] - self.ends[0]).norm() + self.radius;
        let r = q - middle;
        self.bend.dot(&r) + self.bend.norm() * reach + self.bend_spread * (r.norm() + reach) - 1.0
    }

    /// The same from three places, with half of what they differ by as a margin.
    fn beyond_sampled(&self, table: &CurveTable, q: &Point) -> f64 {
        let [from, to] = self.range;
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for s in [from, 0.5 * (from + to), to] {
            let (p, d1, d2) = table.local(self.span as usize, s);
            let Some(bend) = super::leaf::bend(&d1, &d2) else { return f64::INFINITY };
            let here = bend.dot(&(q - p));
            (least, most) = (least.min(here), most.max(here));
        }
        most + 0.5 * (most - least) - 1.0
    }
}
