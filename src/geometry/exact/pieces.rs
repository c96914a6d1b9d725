//! The faces piece by piece, from coarse to fine, for questions other than the distance from a
//! point.
//!
//! A visitor is shown boxes, then pieces, each with points in whose convex hull it lies (*The NURBS
//! Book* P4.10). What it is done with is left; anything else is halved, the piece that it finds
//! most pressing first. Since the hulls close in on the surface with the square of their size, a
//! question about a convex function on the part is answered as finely as it needs to be, and
//! nowhere more finely. Of a piece that loops cross the parts beyond them are left out; beside a
//! loop the exact edge decides, to [`BEYOND_EDGE_MM`].

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::Exact;
use super::leaf::{FaceForm, NO_BORDER, Rect, bends, extents, hull};
use super::tree::Child;
use super::trim::{BEYOND_EDGE_MM, Border, EdgeChords, TrimKind};
use crate::geometry::brep::Brep;
use crate::geometry::nurbs::SurfaceDerivatives;
use crate::geometry::{Point, Vector};

/// No more pieces are kept from one question to the next.
const MOST_KEPT: usize = 60_000;
/// No piece is halved more often.
const DEEPEST: u32 = 64;
/// A net that bends less than this share of its size is halved across its longer side.
const FLAT: f64 = 0.02;

/// A piece of a face as a visitor sees it.
pub struct SeenPiece<'a> {
    /// It lies in the convex hull of these points.
    pub hull: &'a [Point],
    /// A point of the surface, in the middle of the piece.
    pub middle: Point,
    /// No point of the hull is farther from the middle, mm; not finite where that cannot be said.
    pub radius: f64,
    /// The surface's unit normal there; zero where there is none.
    pub normal: Vector,
    /// Its corners, round it, where it is a piece of a face.
    pub corners: Option<[Point; 4]>,
}

/// A question that looks at the pieces.
pub trait Visitor {
    /// Whether what lies in a box of these half sides, at right angles to each other, is to be
    /// looked at.
    fn enters(&mut self, middle: &Point, sides: &[Vector; 3]) -> bool;
    /// How pressing it is to look closer at a piece (the least first); `None`: it is done with.
    fn presses(&mut self, piece: &SeenPiece) -> Option<f64>;
    /// Takes a point of the part, of a piece that is not done with; false: nothing more need be
    /// looked at.
    fn takes(&mut self, point: &Point) -> bool;
    /// Pieces that were pressing may be done with since this was another number.
    fn state(&self) -> u32;
}

/// A piece, kept for later questions.
struct KeptPiece {
    rect: Rect,
    depth: u32,
    /// Index into the borders, or [`NO_BORDER`].
    border: u32,
    hull: Vec<Point>,
    row: usize,
    middle: Point,
    radius: f64,
    normal: Vector,
    /// The middle belongs to the face, where that is known.
    held: Option<Held>,
    /// Its halves, where they are known; [`NONE`]: beyond a loop.
    halves: Option<[u32; 2]>,
}

const NONE: u32 = u32::MAX;

/// Where the middle of a piece is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Held {
    /// On the face.
    On,
    /// Beyond a loop.
    Off,
    /// Beyond a loop like all of the piece.
    Beyond,
}

impl KeptPiece {
    fn piece(&self) -> SeenPiece<'_> {
        let (n, row) = (self.hull.len(), self.row);
        let corners = Some([0, row - 1, n - 1, n - row].map(|k| self.hull[k]));
        SeenPiece { hull: &self.hull, middle: self.middle, radius: self.radius, normal: self.normal, corners }
    }
}

/// A key that sorts as an integer.
fn sortable(key: f64) -> i64 {
    let bits = key.to_bits() as i64;
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// The key of a [`sortable`] integer.
fn from_sortable(key: i64) -> f64 {
    f64::from_bits((key ^ (((key >> 63) as u64) >> 1) as i64) as u64)
}

/// Shows the pieces of one part, question after question; what it cut for one it keeps for the
/// next. Answers do not depend on that.
pub struct Walker<'a> {
    exact: &'a Exact,
    brep: &'a Brep,
    /// First piece of each leaf, where it is known.
    first: Vec<u32>,
    kept: Vec<KeptPiece>,
    /// Borders of parts of pieces, numbered on from those of all faces.
    borders: Vec<Vec<Border>>,
    /// What is open: key, order, piece, state of the visitor that saw it.
    open: BinaryHeap<Reverse<(i64, u32, u32, u32)>>,
    count: u32,
}

impl<'a> Walker<'a> {
    /// For the faces that `exact` was made for.
    pub fn new(exact: &'a Exact, brep: &'a Brep) -> Self {
        let first = vec![NONE; exact.leaves.len()];
        Walker { exact, brep, first, kept: Vec::new(), borders: Vec::new(), open: BinaryHeap::new(), count: 0 }
    }

    /// Shows all pieces to the visitor; false: it was not done with all of them after `most_cuts`
    /// halvings, or wanted no more.
    pub fn visit(&mut self, visitor: &mut impl Visitor, most_cuts: usize) -> bool {
        if self.kept.len() > MOST_KEPT {
            self.kept.clear();
            self.borders.clear();
            self.first.fill(NONE);
        }
        self.open.clear();
        self.count = 0;
        self.enter(visitor);
        let mut cuts = 0;
        while let Some(next) = self.open.pop() {
            let Reverse((_, _, k, state)) = next;
            if state != visitor.state() && visitor.presses(&self.kept[k as usize].piece()).is_none() {
                continue;
            }
            let held = self.held(k);
            let o = &self.kept[k as usize];
            if held == Held::Beyond {
                continue;
            }
            if held == Held::On && !visitor.takes(&o.middle) {
                return false;
            }
            if o.depth >= DEEPEST || cuts >= most_cuts {
                self.open.push(next);
                return false;
            }
            cuts += 1;
            for half in self.halves(k) {
                if half != NONE {
                    self.offer(half, visitor);
                }
            }
        }
        true
    }

    /// How pressing the most pressing piece is that a visit which was not done with all has left
    /// open; `None`: it has left none.
    pub fn left_open(&self) -> Option<f64> {
        self.open.peek().map(|Reverse((key, ..))| from_sortable(*key))
    }

    /// Goes down the tree.
    fn enter(&mut self, visitor: &mut impl Visitor) {
        let exact = self.exact;
        let mut nodes = if exact.tree.is_empty() { Vec::new() } else { vec![0] };
        while let Some(node) = nodes.pop() {
            exact.tree.children(node, |child, middle, sides| {
                if visitor.enters(middle, sides) {
                    match child {
                        Child::Node(n) => nodes.push(n),
                        Child::Item(i) => self.offer_leaf(i, visitor),
                    }
                }
            });
        }
    }

    fn shape(&self, face: u32) -> FaceForm<'a> {
        self.exact.shape(self.brep, face)
    }

    fn offer_leaf(&mut self, item: u32, visitor: &mut impl Visitor) {
        // Edges bound faces, and lie on them.
        let Some(leaf) = self.exact.leaves.get(item as usize) else { return };
        if self.first[item as usize] == NONE {
            let s = &leaf.slab;
            let sides = [0, 1, 2].map(|k| s.axes[k] * s.half[k]);
            let corner = |k: usize| {
                let sign = |bit: usize| if (k >> bit) & 1 == 0 { 1.0 } else { -1.0 };
                s.middle + sides[0] * sign(0) + sides[1] * sign(1) + sides[2] * sign(2)
            };
            let hull: [Point; 8] = std::array::from_fn(corner);
            let normal = if leaf.wild { Vector::zeros() } else { s.axes[2] };
            let (middle, radius) = (leaf.centre, radius(&hull, &leaf.centre));
            // What is known of the box holds for the piece in it: the answer is the same without
            // it.
            if visitor.presses(&SeenPiece { hull: &hull, middle, radius, normal, corners: None }).is_none() {
                return;
            }
            self.first[item as usize] = self.keep(leaf.rect, 0, leaf.border);
        }
        self.offer(self.first[item as usize], visitor);
    }

    fn keep(&mut self, rect: Rect, depth: u32, border: u32) -> u32 {
        let shape = self.shape(rect.face);
        let (hull, row) = hull(&shape, &rect);
        let at = shape.local(rect.span, rect.middle());
        let (middle, normal) = (at.p, at.normal().unwrap_or_else(Vector::zeros));
        let (radius, held) = (radius(&hull, &middle), (border == NO_BORDER).then_some(Held::On));
        self.kept.push(KeptPiece { rect, depth, border, hull, row, middle, radius, normal, held, halves: None });
        (self.kept.len() - 1) as u32
    }

    fn offer(&mut self, k: u32, visitor: &mut impl Visitor) {
        if let Some(key) = visitor.presses(&self.kept[k as usize].piece()) {
            self.open.push(Reverse((sortable(key), self.count, k, visitor.state())));
            self.count += 1;
        }
    }

    fn borders(&self, border: u32) -> &[Border] {
        let k = border as usize;
        let all = self.exact.borders.get(k).or_else(|| self.borders.get(k.checked_sub(self.exact.borders.len())?));
        all.map_or(&[], Vec::as_slice)
    }

    fn held(&mut self, k: u32) -> Held {
        let o = &self.kept[k as usize];
        if let Some(held) = o.held {
            return held;
        }
        let shape = self.shape(o.rect.face);
        let d = shape.local(o.rect.span, o.rect.middle());
        let [hu, hv] = [0, 1].map(|a| shape.frame(a, o.rect.span[a])[1]);
        let at = SurfaceDerivatives { du: d.du / hu, dv: d.dv / hv, ..d };
        let uv = shape.uv(o.rect.span, o.rect.middle());
        let loops = &self.exact.loops;
        let (region, borders) = (&loops.regions[o.rect.face as usize], self.borders(o.border));
        let edges = EdgeChords { brep: self.brep, chords: &loops.chords };
        let held = if region.holds(edges, borders, uv, &at) {
            Held::On
        } else if o.radius <= BEYOND_EDGE_MM || region.is_beyond(edges, borders, uv, &at, o.radius) {
            Held::Beyond
        } else {
            Held::Off
        };
        self.kept[k as usize].held = Some(held);
        held
    }

    fn halves(&mut self, k: u32) -> [u32; 2] {
        let o = &self.kept[k as usize];
        if let Some(halves) = o.halves {
            return halves;
        }
        let (bend, size) = (bends(&o.hull, o.row), extents(&o.hull, o.row));
        let (more, longer) = (usize::from(bend[1] > bend[0]), usize::from(size[1] > size[0]));
        let along = if bend[more] > FLAT * size[more] { more } else { longer };
        let (rect, depth, border) = (o.rect, o.depth, o.border);
        let halves = rect.halves(along).map(|half| {
            let mut own = NO_BORDER;
            if border != NO_BORDER {
                let region = &self.exact.loops.regions[rect.face as usize];
                match region.kind(&self.shape(rect.face), &half, Some(self.borders(border))) {
                    TrimKind::Outside => return NONE,
                    TrimKind::Inside => {}
                    TrimKind::Crossed(borders) => {
                        own = (self.exact.borders.len() + self.borders.len()) as u32;
                        self.borders.push(borders);
                    }
                }
            }
            self.keep(half, depth + 1, own)
        });
        self.kept[k as usize].halves = Some(halves);
        halves
    }
}

/// Not finite where a point is not.
fn radius(points: &[Point], middle: &Point) -> f64 {
    let more = |most: f64, x: f64| if x > most || x.is_nan() { x } else { most };
    points.iter().map(|p| (p - middle).norm_squared()).fold(0.0, more).sqrt() * (1.0 + 1e-12)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::exact::tests::can;
    use crate::geometry::part::Part;
    use crate::observe::Silent;

    /// Whether a plane is clear of the part, and how near a point of it is at least.
    struct Above {
        normal: Vector,
        least: f64,
        /// Points nearer than the least so far by no more than this are not looked for.
        enough: f64,
        /// How often the least has changed.
        moved: u32,
        looked: usize,
    }

    impl Visitor for Above {
        fn enters(&mut self, middle: &Point, sides: &[Vector; 3]) -> bool {
            let across: f64 = sides.iter().map(|s| self.normal.dot(s).abs()).sum();
            self.normal.dot(&middle.coords) + across > self.least + self.enough
        }
        fn presses(&mut self, piece: &SeenPiece) -> Option<f64> {
            self.looked += 1;
            assert!(piece.hull.iter().all(|p| (p - piece.middle).norm() <= piece.radius));
            let high = piece.hull.iter().map(|p| self.normal.dot(&p.coords)).fold(f64::NEG_INFINITY, f64::max);
            (high > self.least + self.enough).then_some(-high)
        }
        fn takes(&mut self, point: &Point) -> bool {
            let height = self.normal.dot(&point.coords);
            if height > self.least {
                (self.least, self.moved) = (height, self.moved + 1);
            }
            true
        }
        fn state(&self) -> u32 {
            self.moved
        }
    }

    #[test]
    fn a_point_that_is_not_finite_is_not_within_a_radius() {
        let p = |x: f64| Point::new(x, 0.0, 0.0);
        assert!((radius(&[p(1.0), p(-3.0), p(2.0)], &p(0.0)) - 3.0).abs() < 1e-11);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!radius(&[p(1.0), p(bad), p(2.0)], &p(0.0)).is_finite(), "{bad}");
            assert!(!radius(&[p(1.0), p(2.0)], &p(bad)).is_finite(), "{bad}");
        }
    }

    #[test]
    fn keys_sort_as_their_numbers_and_come_back() {
        let keys = [f64::NEG_INFINITY, -3.5, -1e-300, 0.0, 2e-9, 7.25, f64::INFINITY];
        assert!(keys.windows(2).all(|w| sortable(w[0]) < sortable(w[1])));
        assert!(keys.iter().all(|k| from_sortable(sortable(*k)) == *k));
    }

    /// The farthest point of a can in any direction lies on the rim of one of its caps, whose
    /// planes are larger than the caps.
    #[test]
    fn farthest_points_of_a_can() {
        let part = Part::from_brep(can(5.0, 3.0), 0.05, &Silent).unwrap();
        let (brep, exact) = part.exact().unwrap();
        let mut walker = Walker::new(exact, brep);
        for k in 0..60 {
            let (s, c) = (0.1 * f64::from(k)).sin_cos();
            let (s2, c2) = (0.037 * f64::from(k) + 0.02).sin_cos();
            let normal = Vector::new(c * c2, s * c2, s2);
            let mut look = Above { normal, least: f64::NEG_INFINITY, enough: 1e-3, moved: 0, looked: 0 };
            assert!(walker.visit(&mut look, 3000), "{k}: {} looked at", look.looked);
            let expected = 5.0 * c2.abs() + if s2 > 0.0 { 3.0 * s2 } else { 0.0 };
            assert!((look.least - expected).abs() < 1.2e-3, "{k}: {} {expected}", look.least);
            // Nothing kept from before changes an answer.
            let mut anew = Above { looked: 0, moved: 0, least: f64::NEG_INFINITY, ..look };
            let before = look.least;
            assert!(Walker::new(exact, brep).visit(&mut anew, 3000));
            assert_eq!(anew.least, before);
        }
    }
}
