//! Faces and edges cut into pieces small enough for good bounds.

use super::leaf::{FaceForm, Leaf, LeafArc, NO_BORDER, Rect, bends, extents, hull};
use super::patch::{CurveTable, SurfaceTable};
use super::tree::Hull;
use super::trim::{Border, TrimKind, TrimTest};
use crate::geometry::brep::Brep;
use crate::geometry::{Point, Vector};
use crate::parallel;

/// Pieces are cut until they turn by no more than this to either side, sine.
const TURN: f64 = 0.2;
/// Pieces are cut until they are no thicker than this share of the part's diagonal.
const THICKNESS: f64 = 5e-5;
/// Pieces with more sides of loops than this are cut.
const SIDES: usize = 6;
/// No piece is cut that is smaller than this share of the part's diagonal, nor more often than
/// [`DEEPEST`].
const SMALLEST: f64 = 1e-5;
/// A piece of whose curvature nothing is known and that is smaller than this share is cut
/// [`WILD_CUTS`] times more: along a line of poles or a cusp there is no end to cutting, and a
/// query cuts on where it needs to.
const SMALLEST_WILD: f64 = 1e-3;
const WILD_CUTS: usize = 6;
const DEEPEST: usize = 24;
/// A face of more pieces than this is cut anew, into pieces [`COARSER`] times as thick, at most
/// [`COARSEST`] times; then it is cut no further, and queries cut the rest where they need to. A
/// loft through splines of unlike knots may have thousands of strips as long as the blade: with the
/// first of them cut finely and the last not at all, every query would meet all of the last.
const MOST_PIECES: usize = 100_000;
const COARSER: f64 = 4.0;
const COARSEST: i32 = 4;

/// The pieces of one face.
#[derive(Default)]
pub(super) struct Pieces {
    pub leaves: Vec<Leaf>,
    pub borders: Vec<Vec<Border>>,
}

/// The pieces of all faces, in order.
pub(super) fn faces(brep: &Brep, tables: &[Option<SurfaceTable>], regions: &[TrimTest], diagonal_mm: f64) -> Pieces {
    let each = parallel::map(0..brep.faces.len(), |f| face(brep, tables, regions, f, diagonal_mm));
    let mut all = Pieces::default();
    for mut one in each {
        let base = all.borders.len() as u32;
        one.leaves.iter_mut().filter(|l| l.border != NO_BORDER).for_each(|l| l.border += base);
        all.leaves.append(&mut one.leaves);
        all.borders.append(&mut one.borders);
    }
    all
}

/// Rectangles of a face: its spans, and what its loops need beyond the domain.
fn rects(shape: &FaceForm, region: &TrimTest, face: u32) -> Vec<Rect> {
    let along = |a: usize| {
        let mut out: Vec<(u32, [f64; 2])> = (0..shape.spans(a) as u32).map(|k| (k, [-1.0, 1.0])).collect();
        let space = &region.trim.space;
        let last = shape.spans(a) as u32 - 1;
        for (span, side, end) in [(0, -1.0, 0), (last, 1.0, 1)] {
            let [middle, half] = shape.frame(a, span);
            let reach = (space.range[a][end] - middle) / half;
            if !space.closed[a] && reach * side > 1.0 {
                // Within the last span where it is short, beside it where it is long.
                if reach * side < 1.5 {
                    out[span as usize].1[end] = reach;
                } else {
                    out.push((span, if end == 0 { [reach, -1.0] } else { [1.0, reach] }));
                }
            }
        }
        out
    };
    let (us, vs) = (along(0), along(1));
    let pair = |u: &(u32, [f64; 2]), v: &(u32, [f64; 2])| Rect { face, span: [u.0, v.0], range: [u.1, v.1] };
    us.iter().flat_map(|u| vs.iter().map(|v| pair(u, v)).collect::<Vec<_>>()).collect()
}

fn face(brep: &Brep, tables: &[Option<SurfaceTable>], regions: &[TrimTest], f: usize, diagonal_mm: f64) -> Pieces {
    let shape = FaceForm { surface: &brep.faces[f].surface, table: tables[f].as_ref() };
    let rects = rects(&shape, &regions[f], f as u32);
    let cut = |coarser: i32| {
        let fineness = Fineness { thickness_mm: COARSER.powi(coarser) * THICKNESS * diagonal_mm, diagonal_mm };
        cut(&shape, &regions[f], &rects, &fineness)
    };
    // What even the coarsest pieces are too many for is cut as far as it goes.
    let fitting = (0..COARSEST).map(cut).find(|pieces| pieces.leaves.len() < MOST_PIECES);
    fitting.unwrap_or_else(|| cut(COARSEST))
}

/// How finely a face is cut.
struct Fineness {
    /// Pieces are no thicker than this, mm.
    thickness_mm: f64,
    /// Diagonal of the part, mm.
    diagonal_mm: f64,
}

/// The pieces of the rectangles of a face, in their order.
fn cut(shape: &FaceForm, region: &TrimTest, rects: &[Rect], fineness: &Fineness) -> Pieces {
    let Fineness { thickness_mm, diagonal_mm } = *fineness;
    let mut out = Pieces::default();
    for &first in rects {
        let mut open = vec![(first, region.kind(shape, &first, None), 0, 0)];
        while let Some((rect, kind, depth, wild_cuts)) = open.pop() {
            let borders = match kind {
                TrimKind::Outside => continue,
                TrimKind::Inside => None,
                TrimKind::Crossed(borders) => Some(borders),
            };
            let (points, row) = hull(shape, &rect);
            let mut leaf = Leaf::boxed(shape, rect, &points);
            let may_be_cut = depth < DEEPEST && out.leaves.len() + open.len() < MOST_PIECES;
            let small = leaf.slab.radius() < SMALLEST_WILD * diagonal_mm;
            // Large thick pieces are cut, whatever their curvature.
            if small || !may_be_cut || leaf.slab.half[2] <= thickness_mm {
                leaf.measure_bend(shape);
            }
            // Sides that matter from afar stay many however small the piece is.
            let crowded = leaf.slab.radius() > 2.0 * region.limit_mm()
                && borders.as_ref().is_some_and(|b| b.iter().map(Border::count).sum::<usize>() > SIDES);
            let wild = leaf.wild && small;
            if may_be_cut
                && (!wild || crowded || wild_cuts < WILD_CUTS)
                && let Some(along) = to_cut(&leaf, (&points, row), crowded, fineness)
            {
                let [a, b] = rect.halves(along);
                for half in [b, a] {
                    let kind = match &borders {
                        Some(list) => region.kind(shape, &half, Some(list)),
                        None => TrimKind::Inside,
                    };
                    open.push((half, kind, depth + 1, wild_cuts + usize::from(wild)));
                }
                continue;
            }
            out.add(leaf, borders);
        }
    }
    out
}

/// The direction in which a piece is to be halved, if it is.
fn to_cut(leaf: &Leaf, (points, row): (&[Point], usize), crowded: bool, fineness: &Fineness) -> Option<usize> {
    if leaf.slab.radius() < SMALLEST * fineness.diagonal_mm {
        return None;
    }
    let bend = bends(points, row);
    let size = extents(points, row);
    let longer = usize::from(size[1] > size[0]);
    if leaf.slab.half[2] > fineness.thickness_mm || leaf.wild || leaf.turn[0] > TURN {
        let more = usize::from(bend[1] > bend[0]);
        // A twist bends neither way.
        return Some(if bend[more] > 0.02 * size[more] { more } else { longer });
    }
    crowded.then_some(longer)
}

impl Pieces {
    fn add(&mut self, mut leaf: Leaf, borders: Option<Vec<Border>>) {
        if let Some(borders) = borders {
            leaf.border = self.borders.len() as u32;
            self.borders.push(borders);
        }
        self.leaves.push(leaf);
    }
}

/// The pieces of one edge between its ends.
pub(super) fn arcs(table: &CurveTable, edge: u32, t: [f64; 2], diagonal_mm: f64) -> Vec<LeafArc> {
    let mut out = Vec::new();
    for span in 0..table.spans.len() {
        let [middle, half] = table.spans.frame(span);
        let low = if span == 0 { f64::NEG_INFINITY } else { -1.0 };
        let high = if span + 1 == table.spans.len() { f64::INFINITY } else { 1.0 };
        let range = [((t[0] - middle) / half).max(low), ((t[1] - middle) / half).min(high)];
        if range[0] >= range[1] {
            continue;
        }
        let mut open = vec![(range, 0)];
        while let Some((range, depth)) = open.pop() {
            let arc = LeafArc::new(table, edge, span as u32, range);
            let length = arc.length();
            let straight = arc.radius <= THICKNESS * diagonal_mm && arc.bend.norm() * length <= 2.0 * TURN;
            if straight || depth >= DEEPEST || length < SMALLEST * diagonal_mm {
                out.push(arc);
            } else {
                let m = 0.5 * (range[0] + range[1]);
                open.push(([m, range[1]], depth + 1));
                open.push(([range[0], m], depth + 1));
            }
        }
    }
    out
}

/// What an arc lies in.
pub(super) fn arc_hull(arc: &LeafArc) -> Hull {
    let half = 0.5 * (arc.ends[1] - arc.ends[0]);
    let sides = [half, Vector::zeros(), Vector::zeros()];
    Hull { middle: nalgebra::center(&arc.ends[0], &arc.ends[1]), sides, round: arc.radius, normals: None }
}

/// What a piece of a face lies in.
pub(super) fn leaf_hull(leaf: &Leaf) -> Hull {
    let [a, b, n] = leaf.slab.axes;
    let sides = [0, 1, 2].map(|k| leaf.slab.axes[k] * leaf.slab.half[k]);
    let [s, t] = leaf.slope;
    let normals = [n + a * s + b * t, n + a * s - b * t, n - a * s + b * t, n - a * s - b * t];
    let normals = (!leaf.wild && !leaf.sharp).then_some(normals);
    Hull { middle: leaf.slab.middle, sides, round: 0.0, normals }
}
