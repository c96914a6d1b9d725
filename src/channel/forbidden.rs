//! The forbidden angles at one place, or over one move.
//!
//! In the frame of the place's cone, with `v = p − Q = (vx, ρ cos ψ, ρ sin ψ)` for a point `p` of a
//! body, its height over the ball centre is `z = vx sin B + ρ cos B cos(θ − ψ)`. The profile (see
//! [`super::profile`]) forbids an interval of heights that depends on `|v|` alone, hence one or two
//! arcs of θ about ψ: a closed form, no search over θ.
//!
//! Branch and bound: points that were looked at give arcs that are certainly forbidden (`known`). A
//! node of the tree, or a piece of a triangle, is a ball of radius `e` about its centre; the
//! profile inflated by `e` gives arcs that contain those of all its points. If they lie in `known`
//! widened by half the tolerance, the node cannot move an end by more than that and is never
//! opened. A flat piece that touches the tool nearly along its own plane would need endless
//! halving; there the distance from the tool, a convex function, is bounded by its tangent plane
//! instead. The result is `known` widened by that much: never too small.
//!
//! A move (see [`super::region`]) is searched likewise, in a frame that turns along: an angle is
//! forbidden if it is at some time of the move; pieces are halved in space or in time, whichever
//! counts for more.

use std::collections::BinaryHeap;
use std::f64::consts::PI;

use crate::artifact::Cone;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Vector};

use super::arcs::{Arc, ArcSet, Witness, push_arcs, push_wrapped};
use super::clear::{self, Verdict};
use super::options::ChannelOptions;
use super::pending::{Open, TurnedPiece, What};
use super::profile::{HeightRange, ToolProfile};
use super::region::{EvenMove, RegionShape, SeenRegion};
use super::sight::Sight;
use super::tree::{Below, SphereTree, around_triangle, halves};

/// Steps after which a walk over angles is given up and the piece halved instead.
const WALK: usize = 48;
/// Points of a piece that may become known before it is halved.
const ROUNDS: usize = 12;
/// Ends of what is free over a move are good to this many tolerances: they only say how far walls
/// must be moved in.
pub(super) const MOVE_TOLERANCES: f64 = 5.0;

/// Something that the tool must keep clear of.
#[derive(Clone)]
pub(super) struct ObstacleBody<'a> {
    /// `part`, or the name of a fixture.
    pub name: &'a str,
    pub mesh: &'a Mesh,
    pub tree: &'a SphereTree,
    /// The tool with what it keeps clear of this body.
    pub profile: ToolProfile,
}

/// What all places have in common.
pub(super) struct ObstacleScene<'a> {
    pub bodies: Vec<ObstacleBody<'a>>,
    pub options: &'a ChannelOptions,
}

/// A free interval relative to an angle about which it was looked for.
pub(super) type Free = Arc;

/// A node of a body's tree.
pub(super) type Start = (u16, u32);

/// Where the tool is: ball centre, cone, and the angle of the frame that looks, in the middle of a
/// motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub centre: Point,
    pub cone: Cone,
    /// Angle about the cone's axis that is 0 in the frame, rad.
    pub azimuth: f64,
    /// Angles farther than this from the azimuth are not asked for, rad.
    pub within_rad: Option<f64>,
    /// In the frame of the middle.
    pub motion: EvenMove,
}

/// Workspace for one place after another. Triangles that bound the channel at one are looked at
/// first at the next.
pub(super) struct PlaceSearch<'a> {
    scene: &'a ObstacleScene<'a>,
    /// (sin B, cos B).
    b: (f64, f64),
    sight: Sight,
    centre: Point,
    azimuth: f64,
    turn: (f64, f64),
    motion: EvenMove,
    still: bool,
    known: ArcSet,
    heights: Vec<HeightRange>,
    arcs: Vec<Arc>,
    open: BinaryHeap<Open>,
    pieces: Vec<TurnedPiece>,
    seeds: Vec<(u16, u32)>,
    /// Body, leaf and point, in the frame, that `arcs` are those of.
    point: Option<(u16, u32, Vector)>,
    log: Option<Vec<Logged>>,
}

/// An arc that became known, and the point that forbids it; no point: the contact angle, or a piece
/// as a whole.
#[derive(Clone, Debug)]
pub(super) struct Logged {
    pub arc: Arc,
    pub body: u16,
    pub leaf: u32,
    pub point: Option<Point>,
}

impl<'a> PlaceSearch<'a> {
    pub fn new(scene: &'a ObstacleScene<'a>) -> Self {
        PlaceSearch {
            scene,
            b: (0.0, 1.0),
            sight: Sight::of(&Cone::about_blade(0.0)),
            centre: Point::origin(),
            azimuth: 0.0,
            turn: (1.0, 0.0),
            motion: EvenMove::none(),
            still: true,
            known: ArcSet::new(scene.options.settings.tolerance_deg.to_radians()),
            heights: Vec::new(),
            arcs: Vec::new(),
            open: BinaryHeap::new(),
            pieces: Vec::new(),
            seeds: Vec::new(),
            point: None,
            log: None,
        }
    }

    /// Turns to a place; known is what the contact angle forbids, and all that is not asked for.
    /// From now on what becomes known is logged.
    pub fn begin(&mut self, view: &View, normal: &Vector) {
        self.look(view);
        self.known.reset(self.tolerance());
        self.log.get_or_insert_default().clear();
        self.forbid_contact(normal);
        self.forbid_beyond(view);
    }

    /// Makes known what a point of a body forbids.
    pub fn take_point(&mut self, body: u16, leaf: u32, point: &Point) {
        let v = self.seen(point);
        self.arcs_of(body, &v, 0.0, leaf);
        self.commit();
    }

    /// Makes known what a leaf forbids, to the tolerance.
    pub fn take_leaf(&mut self, body: u16, leaf: u32) {
        self.offer_leaf(body, leaf);
        self.search();
    }

    /// What became known at this place.
    pub fn log(&self) -> &[Logged] {
        self.log.as_deref().unwrap_or_default()
    }

    pub fn centre(&self) -> Point {
        self.centre
    }

    pub fn azimuth(&self) -> f64 {
        self.azimuth
    }

    /// (sin B, cos B).
    pub fn b(&self) -> (f64, f64) {
        self.b
    }

    pub fn sight(&self) -> &Sight {
        &self.sight
    }

    /// The free intervals at a place, rising, relative to the view's frame; looked at is what hangs
    /// below `starts`, or all bodies.
    pub fn free(&mut self, view: &View, normal: &Vector, starts: Option<&[Start]>) -> Vec<Free> {
        self.look(view);
        self.known.reset(self.tolerance());
        self.forbid_contact(normal);
        self.forbid_beyond(view);
        self.run(starts);
        let free = self.known.free(2.0 * self.scene.options.settings.tolerance_deg.to_radians());
        self.seeds.clear();
        self.remember(&free);
        free
    }

    /// The intervals that are free of the bodies during a whole move, relative to the view's frame;
    /// `taken` is known to be forbidden, what hangs below `starts`, or all bodies, is looked at.
    pub fn free_moving(&mut self, view: &View, taken: &[Arc], starts: Option<&[Start]>) -> Vec<Free> {
        self.look(view);
        self.known.reset(self.tolerance());
        for arc in taken {
            self.known.insert(*arc);
        }
        self.seeds.clear();
        self.remember(taken);
        self.run(starts);
        self.known.free(0.0)
    }

    /// Angles known to be forbidden at the last place.
    pub fn known(&self) -> &ArcSet {
        &self.known
    }

    /// The roots of all bodies' trees.
    pub fn roots(&self) -> Vec<Start> {
        let bodies = self.scene.bodies.iter().enumerate();
        bodies.filter_map(|(k, b)| b.tree.root().map(|r| (k as u16, r))).collect()
    }

    fn look(&mut self, view: &View) {
        self.centre = view.centre;
        self.sight = Sight::of(&view.cone);
        self.b = view.cone.lean_rad.sin_cos();
        self.azimuth = view.azimuth;
        let (sin, cos) = view.azimuth.sin_cos();
        self.turn = (cos, sin);
        self.motion = view.motion;
        self.still = view.motion.is_none();
        self.pieces.clear();
        self.open.clear();
    }

    /// What ends may be off by, rad.
    fn tolerance(&self) -> f64 {
        self.scene.options.settings.tolerance_deg.to_radians() * if self.still { 1.0 } else { MOVE_TOLERANCES }
    }

    fn run(&mut self, starts: Option<&[Start]>) {
        for (body, leaf) in std::mem::take(&mut self.seeds) {
            self.offer_leaf(body, leaf);
        }
        self.search();
        match starts {
            Some(starts) => starts.iter().for_each(|&(body, index)| self.offer_node(body, index)),
            None => self.roots().into_iter().for_each(|(body, index)| self.offer_node(body, index)),
        }
        self.search();
    }

    fn remember(&mut self, arcs: &[Arc]) {
        for w in arcs.iter().flat_map(|f| [f.lo_by, f.hi_by]) {
            if let Witness::Tool { body, leaf, .. } = w
                && !self.seeds.contains(&(body, leaf))
            {
                self.seeds.push((body, leaf));
            }
        }
    }

    /// Angle between axis and normal outside its range:
    /// `a·n = nx sin B + m cos B cos(θ − azimuth of n)`.
    fn forbid_contact(&mut self, normal: &Vector) {
        self.point = None;
        let (min, max) = (
            self.scene.options.settings.contact_angle_min_deg.to_radians(),
            self.scene.options.settings.contact_angle_max_deg.to_radians(),
        );
        let normal = self.sight.seen(normal);
        let (y, z) = self.turned(normal.y, normal.z);
        let (m, psi) = (y.hypot(z) * self.b.1, z.atan2(y));
        let off = normal.x * self.b.0;
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

    /// Angles that are not asked for.
    fn forbid_beyond(&mut self, view: &View) {
        if let Some(within) = view.within_rad.filter(|w| *w < PI) {
            self.point = None;
            push_wrapped(within, 2.0 * PI - within, Witness::Cut, Witness::Cut, &mut self.arcs);
            self.commit();
        }
    }

    /// (y, z) turned by minus the azimuth.
    fn turned(&self, y: f64, z: f64) -> (f64, f64) {
        let (cos, sin) = self.turn;
        (y * cos + z * sin, z * cos - y * sin)
    }

    /// A point of a body seen from the ball centre, turned.
    fn seen(&self, point: &Point) -> Vector {
        let v = self.sight.seen(&(point - self.centre));
        let (y, z) = self.turned(v.y, v.z);
        Vector::new(v.x, y, z)
    }

    fn region_of(&self, body: u16, index: u32) -> SeenRegion {
        let node = self.scene.bodies[usize::from(body)].tree.node(index);
        let half = node.half.map(|h| {
            let h = self.sight.seen(&h);
            let (y, z) = self.turned(h.y, h.z);
            Vector::new(h.x, y, z)
        });
        SeenRegion::new(self.seen(&node.centre), node.radius, RegionShape::Box(half), self.motion)
    }

    fn profile(&self, body: u16) -> &'a ToolProfile {
        let scene = self.scene;
        &scene.bodies[usize::from(body)].profile
    }

    /// Arcs that the points of a ball of radius `extra` about `v` may forbid, in `self.arcs`.
    fn arcs_of(&mut self, body: u16, v: &Vector, extra: f64, leaf: u32) {
        self.arcs.clear();
        self.point = (extra == 0.0).then_some((body, leaf, *v));
        let off = v.x * self.b.0;
        let m = v.y.hypot(v.z) * self.b.1;
        let profile = self.profile(body);
        profile.inside(v.norm(), extra, (off - m, off + m), &mut self.heights);
        if self.heights.is_empty() {
            return;
        }
        let psi = v.z.atan2(v.y);
        for h in &self.heights {
            let by = |segment| Witness::Tool { segment, body, leaf };
            push_arcs(off, m, psi, (h.low, h.high), (by(h.low_by), by(h.high_by)), &mut self.arcs);
        }
    }

    fn commit(&mut self) {
        if let Some(log) = &mut self.log {
            let (cos, sin) = self.turn;
            let (body, leaf, point) = self.point.map_or((0, 0, None), |(body, leaf, v)| {
                let (y, z) = (v.y * cos - v.z * sin, v.z * cos + v.y * sin);
                (body, leaf, Some(self.centre + self.sight.unseen(&Vector::new(v.x, y, z))))
            });
            log.extend(self.arcs.iter().map(|&arc| Logged { arc, body, leaf, point }));
        }
        for arc in self.arcs.drain(..) {
            self.known.insert(arc);
        }
    }

    /// How much of `self.arcs` is not known yet, rad; `None` where an end can move by no more than
    /// the tolerance.
    fn excess(&self) -> Option<f64> {
        let unknown = self.arcs.iter().filter(|a| !self.known.covers(a.lo, a.hi));
        unknown.map(|a| a.hi - a.lo - self.known.overlap(a.lo, a.hi)).reduce(f64::max)
    }

    /// Puts a node off until those that may move an end farther have been looked at, unless it is
    /// clear.
    fn offer_node(&mut self, body: u16, index: u32) {
        let region = self.region_of(body, index);
        self.arcs_of(body, &region.centre, region.reach, 0);
        if let Some(excess) = self.excess().filter(|_| !self.clear(body, &region)) {
            self.open.push(Open { excess, what: What::Node(body, index) });
        }
    }

    /// Looks at the middle of a piece of a triangle and puts the rest off likewise, unless it is
    /// clear. Smallest pieces are taken as they are, inflated by their size `e`: an arc of
    /// half-width `w` about a point at the distance `ρ` grows to about `√(w² + 2e/ρ)`, so by less
    /// than half the tolerance `τ`, however small it is, where `e ≤ τ²ρ/8`. Over a move `τρ/8` is
    /// enough: ends there only say how far walls must be moved in.
    fn offer_piece(&mut self, piece: TurnedPiece) {
        let TurnedPiece { body, leaf, corners, .. } = piece;
        let (centre, radius) = around_triangle(&corners.map(Point::from));
        let motion = if self.still { self.motion } else { self.motion.part(piece.time, piece.share) };
        let region = SeenRegion::new(centre.coords, radius, RegionShape::Triangle(corners), motion);
        self.arcs_of(body, &region.centre, region.reach, leaf);
        if self.excess().is_none() {
            return;
        }
        let tolerance = self.tolerance();
        let smallest = 0.125 * if self.still { tolerance * tolerance } else { tolerance };
        if region.reach - region.fixed <= (smallest * region.centre.norm()).max(0.25 * region.fixed) + 1e-9 {
            self.commit();
            return;
        }
        self.arcs_of(body, &region.centre, 0.0, leaf);
        self.commit();
        let settled = if self.still {
            self.settle(body, &region, &corners, leaf)
        } else {
            self.arcs_of(body, &region.centre, region.reach, leaf);
            self.excess().is_none() || self.clear(body, &region)
        };
        if !settled {
            self.arcs_of(body, &region.centre, region.reach, leaf);
            let excess = self.excess().unwrap_or(0.0);
            self.open.push(Open { excess, what: What::Piece(self.pieces.len()) });
            self.pieces.push(TurnedPiece {
                centre: region.centre,
                radius,
                reach: region.reach,
                fixed: region.fixed,
                ..piece
            });
        }
    }

    /// No point of the region forbids anything in `self.arcs` that is not known, shown by the
    /// distance from the tool: by its tangent planes it is bounded from below over the whole
    /// region.
    ///
    /// Where each point forbids one arc about its own azimuth (see [`Region::azimuths`]), either no
    /// point forbids anything, or all azimuths must be known; then an arc that holds anything new
    /// also holds an angle where the known ends, and to look there is enough.
    fn clear(&self, body: u16, region: &SeenRegion) -> bool {
        let profile = self.profile(body);
        let Some(azimuths) = region.azimuths(profile) else {
            let reach = region.centre.y.hypot(region.centre.z) + region.reach;
            let walk = |from: f64, to: f64| self.walk(profile, region, from, to, reach);
            return self.arcs.iter().all(|a| self.known.all_uncovered(a.lo, a.hi, walk));
        };
        let clear_at = |border: f64| region.least_margin(profile, &self.axis(border)) > 0.0;
        azimuths.iter().all(|&(lo, hi)| self.known.covers(lo, hi))
            && self.arcs.iter().all(|a| self.known.all_borders(a.lo, a.hi, clear_at))
            || region.out_of_reach(profile, self.b)
    }

    /// As [`Self::clear`] for a piece of a triangle, by cutting planes; points found not to be
    /// clear become known.
    fn settle(&mut self, body: u16, region: &SeenRegion, corners: &[Vector; 3], leaf: u32) -> bool {
        let profile = self.profile(body);
        for _ in 0..ROUNDS {
            self.arcs_of(body, &region.centre, region.radius, leaf);
            if self.excess().is_none() {
                return true;
            }
            let known = |azimuths: [(f64, f64); 2]| azimuths.iter().all(|&(lo, hi)| self.known.covers(lo, hi));
            if !region.azimuths(profile).is_some_and(known) {
                return self.clear(body, region);
            }
            let mut verdict = Verdict::Clear;
            let mut look = |border: f64| {
                let axis = self.axis(border);
                let frusta = profile.frusta.iter();
                let mut verdicts = frusta.map(|f| clear::triangle(f, &axis, corners, region.centre, region.radius));
                verdict = verdicts.find(|v| *v != Verdict::Clear).unwrap_or(Verdict::Clear);
                verdict == Verdict::Clear
            };
            let _ = self.arcs.iter().all(|a| self.known.all_borders(a.lo, a.hi, &mut look));
            match verdict {
                Verdict::Clear => return true,
                Verdict::Open => return false,
                Verdict::Taken(p) => {
                    self.arcs_of(body, &p, 0.0, leaf);
                    self.commit();
                }
            }
        }
        false
    }

    /// The tool axis at a relative angle.
    fn axis(&self, theta: f64) -> Vector {
        let (sin, cos) = theta.sin_cos();
        Vector::new(self.b.0, self.b.1 * cos, self.b.1 * sin)
    }

    /// The region keeps clear from the angle `start` to `end`; the margin falls no faster with the
    /// angle than `reach`, the region's distance from the turning axis.
    fn walk(&self, profile: &ToolProfile, region: &SeenRegion, start: f64, end: f64, reach: f64) -> bool {
        let sense = if end > start { 1.0 } else { -1.0 };
        let mut at = start;
        for _ in 0..WALK {
            let margin = region.least_margin(profile, &self.axis(at));
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

    fn offer_leaf(&mut self, body: u16, leaf: u32) {
        let corners = self.scene.bodies[usize::from(body)].tree.corners(leaf).map(|c| self.seen(&c));
        for corner in &corners {
            self.arcs_of(body, corner, 0.0, leaf);
            self.commit();
        }
        self.offer_piece(TurnedPiece::whole(body, leaf, corners));
    }

    /// Opens what may move an end farthest, until nothing may move one by more than the tolerance.
    fn search(&mut self) {
        let scene = self.scene;
        while let Some(Open { what, .. }) = self.open.pop() {
            match what {
                What::Node(body, index) => {
                    let region = self.region_of(body, index);
                    self.arcs_of(body, &region.centre, region.reach, 0);
                    if self.excess().is_none() {
                        continue;
                    }
                    match scene.bodies[usize::from(body)].tree.below(index) {
                        Below::Leaf(leaf) => self.offer_leaf(body, leaf),
                        Below::Nodes(a, b) => [a, b].into_iter().for_each(|i| self.offer_node(body, i)),
                    }
                }
                What::Piece(index) => {
                    let piece = self.pieces[index];
                    self.arcs_of(piece.body, &piece.centre, piece.reach, piece.leaf);
                    if self.excess().is_some() {
                        self.halve(&piece).into_iter().for_each(|half| self.offer_piece(half));
                    }
                }
            }
        }
    }

    /// Halves a piece in space, or in time where the motion counts for more than the size.
    fn halve(&self, piece: &TurnedPiece) -> [TurnedPiece; 2] {
        if piece.reach - piece.fixed > 2.0 * piece.radius {
            let motion = self.motion.part(piece.time, piece.share);
            let share = 0.5 * piece.share;
            [-0.5, 0.5].map(|t| TurnedPiece {
                corners: piece.corners.map(|c| motion.carry(&c, t)),
                time: piece.time + t * piece.share,
                share,
                ..*piece
            })
        } else {
            halves(&piece.corners.map(Point::from))
                .map(|half| TurnedPiece { corners: half.map(|c| c.coords), ..*piece })
        }
    }
}
