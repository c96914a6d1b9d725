//! The forbidden angles at one cutter location.
//!
//! With `v = p − Q = (vx, ρ cos ψ, ρ sin ψ)` for a point `p` of the part, its height over the ball centre is
//! `z = vx sin B + ρ cos B cos(θ − ψ)`. The profile (see [`super::profile`]) forbids an interval of heights that depends
//! on `|v|` alone, hence one or two arcs of θ about ψ: a closed form, no search over θ.
//!
//! Branch and bound: points that were looked at give arcs that are certainly forbidden (`known`). A node of the tree, or
//! a piece of a triangle, is a ball of radius `e` about its centre; the profile inflated by `e` gives arcs that contain
//! those of all its points. If they lie in `known` widened by half the tolerance, the node cannot move an end by more
//! than that and is never opened. A flat piece that touches the tool nearly along its own plane would need endless
//! halving; there the distance from the tool, a convex function, is bounded by its tangent plane instead. The result is `known` widened by that much: never too small.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};

use super::arcs::{Arc, ArcSet, Witness};
use super::clear::{self, Verdict};
use super::options::ChannelOptions;
use super::profile::{HeightRange, Profile};
use super::tree::{Below, SphereTree, around_triangle, halves};

/// Steps after which a walk over angles is given up and the piece halved instead.
const WALK: usize = 48;
/// Points of a piece that may become known before it is halved.
const ROUNDS: usize = 12;

/// What all cutter locations have in common.
pub(super) struct Scene<'a> {
    pub mesh: &'a Mesh,
    pub tree: &'a SphereTree,
    pub profile: Profile,
    pub options: &'a ChannelOptions,
}

/// A free interval about the azimuth of the surface normal (angles are relative to it).
pub(super) type Free = Arc;

/// Workspace for one location after another. Triangles that bound the channel at one location are looked at first at
/// the next.
pub(super) struct Search<'a> {
    scene: &'a Scene<'a>,
    sin_b: f64,
    cos_b: f64,
    /// Ball centre and azimuth of the normal, as cosine and sine.
    centre: Point,
    azimuth: (f64, f64),
    known: ArcSet,
    heights: Vec<HeightRange>,
    arcs: Vec<Arc>,
    open: BinaryHeap<Open>,
    pieces: Vec<Piece>,
    seeds: Vec<u32>,
}

impl<'a> Search<'a> {
    pub fn new(scene: &'a Scene<'a>) -> Self {
        let (sin_b, cos_b) = scene.options.b_rad.sin_cos();
        Search {
            scene,
            sin_b,
            cos_b,
            centre: Point::origin(),
            azimuth: (1.0, 0.0),
            known: ArcSet::new(scene.options.tolerance_rad),
            heights: Vec::new(),
            arcs: Vec::new(),
            open: BinaryHeap::new(),
            pieces: Vec::new(),
            seeds: Vec::new(),
        }
    }

    /// The free intervals at a location, in rising order, relative to the azimuth `azimuth_rad`.
    pub fn free(&mut self, centre: &Point, normal: &Vector, azimuth_rad: f64) -> Vec<Free> {
        self.centre = *centre;
        let (sin, cos) = azimuth_rad.sin_cos();
        self.azimuth = (cos, sin);
        self.known.clear();
        self.forbid_contact(normal);
        self.pieces.clear();
        for leaf in std::mem::take(&mut self.seeds) {
            self.offer_leaf(leaf);
        }
        self.search();
        if let Some(root) = self.scene.tree.root() {
            self.offer_node(root);
        }
        self.search();
        let tolerance = self.scene.options.tolerance_rad;
        let free = self.known.free(2.0 * tolerance);
        self.remember(&free);
        free
    }

    fn remember(&mut self, free: &[Free]) {
        for w in free.iter().flat_map(|f| [f.lo_by, f.hi_by]) {
            if let Witness::Tool { leaf, .. } = w
                && !self.seeds.contains(&leaf)
            {
                self.seeds.push(leaf);
            }
        }
    }

    /// Angle between axis and normal outside its range: `a·n = nx sin B + m cos B cos(θ − azimuth of n)`.
    fn forbid_contact(&mut self, normal: &Vector) {
        let (min, max) = (self.scene.options.contact_angle_min_rad, self.scene.options.contact_angle_max_rad);
        let (y, z) = self.turned(normal.y, normal.z);
        let (m, psi) = (y.hypot(z) * self.cos_b, z.atan2(y));
        let off = normal.x * self.sin_b;
        self.arcs.clear();
        let by = Witness::Contact;
        if min > 0.0 {
            push_arcs(off, m, psi, (min.cos(), f64::INFINITY), (by, by), &mut self.arcs);
        }
        if max < PI {
            push_arcs(off, m, psi, (f64::NEG_INFINITY, max.cos()), (by, by), &mut self.arcs);
        }
        self.commit();
    }

    /// (y, z) turned by minus the azimuth.
    fn turned(&self, y: f64, z: f64) -> (f64, f64) {
        let (cos, sin) = self.azimuth;
        (y * cos + z * sin, z * cos - y * sin)
    }

    /// A point of the part seen from the ball centre, turned.
    fn seen(&self, point: &Point) -> Vector {
        let v = point - self.centre;
        let (y, z) = self.turned(v.y, v.z);
        Vector::new(v.x, y, z)
    }

    /// Arcs that the points of a ball of radius `extra` about `v` may forbid, in `self.arcs`.
    fn arcs_of(&mut self, v: &Vector, extra: f64, leaf: u32) {
        self.arcs.clear();
        let off = v.x * self.sin_b;
        let m = v.y.hypot(v.z) * self.cos_b;
        self.scene.profile.inside(v.norm(), extra, (off - m, off + m), &mut self.heights);
        if self.heights.is_empty() {
            return;
        }
        let psi = v.z.atan2(v.y);
        for h in &self.heights {
            let by = |segment| Witness::Tool { segment, leaf };
            push_arcs(off, m, psi, (h.low, h.high), (by(h.low_by), by(h.high_by)), &mut self.arcs);
        }
    }

    fn commit(&mut self) {
        for arc in self.arcs.drain(..) {
            self.known.insert(arc);
        }
    }

    /// How much of `self.arcs` is not known yet, rad; `None` where an end can move by no more than the tolerance.
    fn excess(&self) -> Option<f64> {
        let unknown = self.arcs.iter().filter(|a| !self.known.covers(a.lo, a.hi));
        unknown.map(|a| a.hi - a.lo - self.known.overlap(a.lo, a.hi)).reduce(f64::max)
    }

    /// Puts a node off until those that may move an end farther have been looked at, unless it is clear.
    fn offer_node(&mut self, index: u32) {
        let node = self.scene.tree.node(index);
        let region = Region {
            centre: self.seen(&node.centre),
            radius: node.radius,
            shape: Shape::Box(node.half.map(|h| {
                let (y, z) = self.turned(h.y, h.z);
                Vector::new(h.x, y, z)
            })),
        };
        self.arcs_of(&region.centre, region.radius, 0);
        if let Some(excess) = self.excess().filter(|_| !self.clear(&region)) {
            self.open.push(Open { excess, what: What::Node(index) });
        }
    }

    /// Looks at the middle of a piece of a triangle and puts the rest off likewise, unless it is clear. Pieces smaller than
    /// an eighth of the tolerance seen from the ball centre are taken as they are, inflated by their size.
    fn offer_piece(&mut self, corners: [Vector; 3], leaf: u32) {
        let (centre, radius) = around_triangle(&corners.map(Point::from));
        let region = Region { centre: centre.coords, radius, shape: Shape::Triangle(corners) };
        self.arcs_of(&region.centre, radius, leaf);
        if self.excess().is_none() {
            return;
        }
        if radius <= 0.125 * self.scene.options.tolerance_rad * region.centre.norm() + 1e-9 {
            self.commit();
            return;
        }
        self.arcs_of(&region.centre, 0.0, leaf);
        self.commit();
        if !self.settle(&region, &corners, leaf) {
            self.arcs_of(&region.centre, radius, leaf);
            let excess = self.excess().unwrap_or(0.0);
            self.open.push(Open { excess, what: What::Piece(self.pieces.len()) });
            self.pieces.push(Piece { corners, leaf, centre: region.centre, radius });
        }
    }

    /// No point of the region forbids anything in `self.arcs` that is not known, shown by the distance from the tool: by its
    /// tangent planes it is bounded from below over the whole region.
    ///
    /// Where each point forbids one arc about its own azimuth (see [`Self::azimuths`]), either no point forbids anything, or
    /// all azimuths must be known; then an arc that holds anything new also holds an angle where the known ends, and to
    /// look there is enough.
    fn clear(&self, region: &Region) -> bool {
        let Some(azimuths) = self.azimuths(region) else {
            let reach = region.centre.y.hypot(region.centre.z) + region.radius;
            let walk = |from: f64, to: f64| self.walk(region, from, to, reach);
            return self.arcs.iter().all(|a| self.known.all_uncovered(a.lo, a.hi, walk));
        };
        let clear_at = |border: f64| self.least_margin(region, border) > 0.0;
        self.out_of_reach(region)
            || azimuths.iter().all(|&(lo, hi)| self.known.covers(lo, hi))
                && self.arcs.iter().all(|a| self.known.all_borders(a.lo, a.hi, clear_at))
    }

    /// No point of the region is inside the tool even when the tool turns to the point's own azimuth. There the margin depends
    /// on the point's `x` and distance `ρ` from the turning axis alone and is convex in both. Over the region `ρ` exceeds
    /// its tangent plane at the centre by at most `radius² / 2(ρ − radius)`. Needs [`Self::azimuths`].
    fn out_of_reach(&self, region: &Region) -> bool {
        let across = region.centre.y.hypot(region.centre.z);
        let away = Vector::new(0.0, region.centre.y, region.centre.z) / across;
        let axis = Vector::new(self.sin_b, self.cos_b * away.y, self.cos_b * away.z);
        let bend = 0.5 * region.radius * region.radius / (across - region.radius);
        self.scene.profile.frusta.iter().all(|f| {
            let (margin, slope) = clear::margin(f, &axis, &region.centre);
            margin > region.radius + bend || margin - region.fall(&slope) - (-slope.dot(&away)).max(0.0) * bend > 0.0
        })
    }

    /// The azimuths ψ of all points of the region, as one or two ranges within -π..=π, where each of its points is inside the
    /// tool for one arc about its own azimuth if at all: the profile only widens upwards and reaches beyond the region.
    fn azimuths(&self, region: &Region) -> Option<[(f64, f64); 2]> {
        let across = region.centre.y.hypot(region.centre.z);
        let profile = &self.scene.profile;
        if !profile.widens || region.centre.norm() + region.radius > profile.length || across <= region.radius {
            return None;
        }
        let psi = region.centre.z.atan2(region.centre.y);
        let spread = (region.radius / across).asin();
        let (lo, hi) = (psi - spread, psi + spread);
        Some(if lo < -PI {
            [(-PI, hi), (lo + 2.0 * PI, PI)]
        } else if hi > PI {
            [(lo, PI), (-PI, hi - 2.0 * PI)]
        } else {
            [(lo, hi), (lo, hi)]
        })
    }

    /// As [`Self::clear`] for a piece of a triangle, by cutting planes; points found not to be clear become known.
    fn settle(&mut self, region: &Region, corners: &[Vector; 3], leaf: u32) -> bool {
        for _ in 0..ROUNDS {
            self.arcs_of(&region.centre, region.radius, leaf);
            if self.excess().is_none() {
                return true;
            }
            let known = |azimuths: [(f64, f64); 2]| azimuths.iter().all(|&(lo, hi)| self.known.covers(lo, hi));
            if !self.azimuths(region).is_some_and(known) {
                return self.clear(region);
            }
            let mut verdict = Verdict::Clear;
            let mut look = |border: f64| {
                let axis = self.axis(border);
                let frusta = self.scene.profile.frusta.iter();
                let mut verdicts = frusta.map(|f| clear::triangle(f, &axis, corners, region.centre, region.radius));
                verdict = verdicts.find(|v| *v != Verdict::Clear).unwrap_or(Verdict::Clear);
                verdict == Verdict::Clear
            };
            let _ = self.arcs.iter().all(|a| self.known.all_borders(a.lo, a.hi, &mut look));
            match verdict {
                Verdict::Clear => return true,
                Verdict::Open => return false,
                Verdict::Taken(p) => {
                    self.arcs_of(&p, 0.0, leaf);
                    self.commit();
                }
            }
        }
        false
    }

    /// The tool axis at a relative angle.
    fn axis(&self, theta: f64) -> Vector {
        let (sin, cos) = theta.sin_cos();
        Vector::new(self.sin_b, self.cos_b * cos, self.cos_b * sin)
    }

    /// The region keeps clear from the angle `start` to `end`; the margin falls no faster with the angle than `reach`, the
    /// region's distance from the turning axis.
    fn walk(&self, region: &Region, start: f64, end: f64, reach: f64) -> bool {
        let sense = if end > start { 1.0 } else { -1.0 };
        let mut at = start;
        for _ in 0..WALK {
            let margin = self.least_margin(region, at);
            if margin <= 0.0 {
                return false;
            }
            at += sense * margin / reach;
            if (end - at) * sense < 0.0 {
                return true;
            }
        }
        false
    }

    /// A lower bound of the margin over all points of the region at the relative angle `theta`, mm.
    fn least_margin(&self, region: &Region, theta: f64) -> f64 {
        let axis = self.axis(theta);
        let mut least = f64::INFINITY;
        for f in &self.scene.profile.frusta {
            let (margin, slope) = clear::margin(f, &axis, &region.centre);
            if margin - region.radius < least {
                least = least.min(margin - region.fall(&slope));
            }
        }
        least
    }

    fn offer_leaf(&mut self, leaf: u32) {
        let corners = self.scene.tree.corners(leaf).map(|c| self.seen(&c));
        for corner in &corners {
            self.arcs_of(corner, 0.0, leaf);
            self.commit();
        }
        self.offer_piece(corners, leaf);
    }

    /// Opens what may move an end farthest, until nothing may move one by more than the tolerance.
    fn search(&mut self) {
        let scene = self.scene;
        while let Some(Open { what, .. }) = self.open.pop() {
            match what {
                What::Node(index) => {
                    let node = scene.tree.node(index);
                    self.arcs_of(&self.seen(&node.centre), node.radius, 0);
                    if self.excess().is_none() {
                        continue;
                    }
                    match scene.tree.below(index) {
                        Below::Leaf(leaf) => self.offer_leaf(leaf),
                        Below::Nodes(a, b) => [a, b].into_iter().for_each(|i| self.offer_node(i)),
                    }
                }
                What::Piece(index) => {
                    let Piece { corners, leaf, centre, radius } = self.pieces[index];
                    self.arcs_of(&centre, radius, leaf);
                    if self.excess().is_some() {
                        for half in halves(&corners.map(Point::from)) {
                            self.offer_piece(half.map(|c| c.coords), leaf);
                        }
                    }
                }
            }
        }
    }
}

/// Points of the part seen from the ball centre, turned: all within `radius` of `centre`, and within a shape.
struct Region {
    centre: Vector,
    radius: f64,
    shape: Shape,
}

enum Shape {
    /// Half sides of a box about the centre.
    Box([Vector; 3]),
    /// Corners of a triangle about the centre.
    Triangle([Vector; 3]),
}

impl Region {
    /// How far a function with this slope may fall from its value at the centre.
    fn fall(&self, slope: &Vector) -> f64 {
        match &self.shape {
            Shape::Box(half) => half.iter().map(|h| slope.dot(h).abs()).sum(),
            Shape::Triangle(c) => c.iter().map(|c| slope.dot(&(self.centre - c))).fold(0.0, f64::max),
        }
    }
}

/// Something whose points may forbid more than is known.
struct Open {
    excess: f64,
    what: What,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum What {
    Node(u32),
    /// Index into the workspace's pieces.
    Piece(usize),
}

/// A piece of a triangle in its bounding sphere, seen from the ball centre, turned.
#[derive(Clone, Copy)]
struct Piece {
    corners: [Vector; 3],
    leaf: u32,
    centre: Vector,
    radius: f64,
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        self.excess.total_cmp(&other.excess).then(other.what.cmp(&self.what))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

/// Arcs of θ within -π..=π on which `off + m cos(θ − psi)` lies in `range`; `m >= 0`, `psi` within -π..=π. `by` says what
/// the range's lower and upper end come from.
fn push_arcs(off: f64, m: f64, psi: f64, range: (f64, f64), by: (Witness, Witness), out: &mut Vec<Arc>) {
    let (below, above) = (range.0 <= off - m, range.1 >= off + m);
    if range.1 < off - m || range.0 > off + m {
        return;
    }
    if below && above {
        out.push(Arc { lo: -PI, hi: PI, lo_by: Witness::Cut, hi_by: Witness::Cut });
        return;
    }
    // Outer half width from the lower end of the range, inner from the upper end.
    let outer = if below { PI } else { ((range.0 - off) / m).clamp(-1.0, 1.0).acos() };
    let inner = if above { 0.0 } else { ((range.1 - off) / m).clamp(-1.0, 1.0).acos() };
    if above {
        push_wrapped(psi - outer, psi + outer, by.0, by.0, out);
    } else if below {
        push_wrapped(psi + inner, psi - inner + 2.0 * PI, by.1, by.1, out);
    } else {
        push_wrapped(psi + inner, psi + outer, by.1, by.0, out);
        push_wrapped(psi - outer, psi - inner, by.0, by.1, out);
    }
}

/// The arc `lo..=hi` (no longer than 2π) moved into -π..=π, cut in two where it crosses ±π.
fn push_wrapped(lo: f64, hi: f64, lo_by: Witness, hi_by: Witness, out: &mut Vec<Arc>) {
    let turn = 2.0 * PI;
    let shift = if lo >= PI {
        -turn
    } else if lo < -PI {
        turn
    } else {
        0.0
    };
    let (lo, hi) = (lo + shift, hi + shift);
    if hi <= PI {
        out.push(Arc { lo, hi, lo_by, hi_by });
    } else {
        out.push(Arc { lo, hi: PI, lo_by, hi_by: Witness::Cut });
        out.push(Arc { lo: -PI, hi: hi - turn, lo_by: Witness::Cut, hi_by });
    }
}
