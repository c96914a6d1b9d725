//! The free angles of one place after another along a path.
//!
//! **What a node's certificate is.** For a part whose profile only widens upwards, a point that is
//! no farther off than the tool is long is inside the tool, inflated by any amount, for one arc of
//! θ about its own azimuth ψ. So its margin (distance less clearance) grows with `|θ − ψ|`, and
//! what the whole interval `lo ..= hi` leaves of room for a point with ψ outside it is the lesser
//! of its margins at `lo` and at `hi`; for any point, it is at least the margin at θ = ψ. Both are
//! bounded from below over a node by tangent planes. Where neither holds (a profile that narrows, a
//! part longer than the tool) the interval is walked.
//!
//! That room is a distance from what the tool sweeps over all free intervals. It falls by no more
//! than the ball centre moves, plus the point's distance from the turning axis times what the
//! intervals grow outwards, plus its distance from the ball centre times what the cone turns by
//! from place to place. So a node is not looked at again before that is used up: the nodes at which
//! the search stopped, the *front*, are carried along the path.
//!
//! **What is known to be taken** starts at each place from a few points of the place before that
//! cover all of it. Where they do not any more, a point inside the tool is looked for in the gap; a
//! gap without one is a new free interval, and then all is looked at anew. Points found in leaves
//! that are not clear move the ends inwards, each by its closed form.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::error::{Result, Stage};
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;

use super::arcs::{Arc, Witness};
use super::bound::{self, Between, Facet, Flat, FreeSweep, NodeRoom};
use super::clear::{self, Nearness, Verdict};
use super::forbidden::{Free, ObstacleScene, PlaceSearch, Start};
use super::front::Front;
use super::planes::{Due, Now};
use super::profile::ToolProfile;
use super::samples::Sample;
use super::tree::{Below, around_triangle, halves};

/// Points of a leaf that may become known before it is halved.
const ROUNDS: usize = 12;
/// Pieces of a leaf that are looked at before it is searched as one without certificates is.
const PIECES: usize = 128;
/// Points looked for in gaps at one place.
const PROBES: usize = 256;
/// What an interval may grow by from place to place without a look whether it does, rad.
const GROWTH: f64 = 0.02;
/// Growth after which all is looked at anew, rad.
const LEAP: f64 = 0.3;
/// Points that cover what is taken should overlap by this, rad.
const OVERLAP: f64 = 0.02;
/// Steps from the ends of what seems free at which points inside the tool are looked for, greatest
/// and least, rad.
const CLOSE_IN: [f64; 2] = [0.5, 1e-3];
/// Places after which the front is made anew, coarser again.
const PLACES: usize = 64;

/// Places that one thread works on in a row: at least, at most, and in how many rows a path is cut
/// between these. Nothing depends on the number of threads. Each row begins with a look at
/// everything.
const BATCH: [usize; 2] = [128, 512];
const BATCHES: usize = 256;

/// The free intervals of every place, unwrapped; in order, whatever the number of threads.
pub(super) fn free_everywhere(
    scene: &ObstacleScene,
    samples: &[Sample],
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let done = AtomicUsize::new(0);
    let batches = samples.chunks((samples.len() / BATCHES).clamp(BATCH[0], BATCH[1]));
    let batches: Vec<Vec<Vec<Free>>> = parallel::try_map(batches, |batch| {
        observer.check(Stage::Channel)?;
        let mut tracker = Tracker::new(scene);
        let free = batch.iter().map(|s| tracker.next(s)).collect();
        let so_far = done.fetch_add(batch.len(), Ordering::Relaxed) + batch.len();
        observer.progress(Stage::Channel, so_far, samples.len());
        Ok(free)
    })?;
    Ok(batches.into_iter().flatten().collect())
}

/// A point of a body that was found inside the tool at some angle.
#[derive(Clone, Copy, PartialEq)]
struct Seed {
    body: u16,
    leaf: u32,
    point: Point,
}

/// Workspace for the places of a stretch of the path, in their order.
pub(super) struct Tracker<'a> {
    search: PlaceSearch<'a>,
    scene: &'a ObstacleScene<'a>,
    front: Front,
    /// Size of the front when it was made.
    made: usize,
    /// Places until it is made anew.
    age: usize,
    now: Now<'a>,
    last: Option<Sample>,
    before: Vec<[f64; 2]>,
    seeds: Vec<Seed>,
    ends: Vec<Start>,
    open: Vec<Due>,
}

impl<'a> Tracker<'a> {
    pub fn new(scene: &'a ObstacleScene<'a>) -> Self {
        Tracker {
            search: PlaceSearch::new(scene),
            scene,
            front: Front::default(),
            made: 0,
            age: 0,
            now: Now::new(&scene.bodies),
            last: None,
            before: Vec::new(),
            seeds: Vec::new(),
            ends: Vec::new(),
            open: Vec::new(),
        }
    }

    /// The free intervals at a place, rising, unwrapped about the azimuth of its normal.
    pub fn next(&mut self, place: &Sample) -> Vec<Free> {
        self.search.begin(&place.view(), &place.normal);
        self.now.go_to(place, self.last.as_ref());
        self.last = Some(*place);
        for s in std::mem::take(&mut self.seeds) {
            self.search.take_point(s.body, s.leaf, &s.point);
        }
        self.update_sweeps();
        for (body, leaf) in std::mem::take(&mut self.ends) {
            self.settle(body, leaf, None);
        }
        let fresh = self.fill_gaps();
        self.age += 1;
        self.open.clear();
        if fresh {
            self.close_in();
        }
        if fresh || self.age > PLACES || self.front.len() > 2 * self.made + 200 {
            self.anew();
            (self.made, self.age) = (self.front.len(), 0);
        } else {
            self.front.drop_due(&self.now, &mut self.open);
            self.verify();
        }
        self.finish(place.azimuth)
    }

    /// Makes the front anew, from all of every body.
    fn anew(&mut self) {
        self.front.clear();
        self.open.extend(self.search.roots().into_iter().map(Due::new));
        self.verify();
    }

    /// Remembers what the next place starts from.
    fn finish(&mut self, azimuth: f64) -> Vec<Free> {
        self.before = self.now.sweeps.iter().map(|s| [s.lo, s.hi]).collect();
        self.cover();
        let mut free = self.search.known().free(2.0 * self.scene.options.settings.tolerance_deg.to_radians());
        for f in &mut free {
            for by in [f.lo_by, f.hi_by] {
                if let Witness::Tool { body, leaf, .. } = by {
                    self.ends.push((body, leaf));
                }
            }
            f.lo += azimuth;
            f.hi += azimuth;
        }
        free
    }

    fn update_sweeps(&mut self) {
        let (azimuth, b) = (self.search.azimuth(), self.search.b());
        self.now.sweeps.clear();
        let free = self.search.known().free(0.0);
        self.now.sweeps.extend(free.iter().map(|f| FreeSweep::new(f.lo + azimuth, f.hi + azimuth, b)));
    }

    /// Looks for taken angles in what seems free and was not free at the place before. True: there
    /// is a gap without any, all must be looked at anew.
    fn fill_gaps(&mut self) -> bool {
        for _ in 0..PROBES {
            let mut grown = 0.0f64;
            let mut gap = None;
            for k in 0..self.now.sweeps.len() {
                let (by, middle) = self.growth_of(self.now.sweeps[k].lo, self.now.sweeps[k].hi);
                grown = grown.max(by);
                if by > GROWTH && self.probe(middle) {
                    gap = Some(middle);
                    break;
                }
            }
            if gap.is_none() {
                self.now.used.growth += grown.min(1.0);
                return grown > LEAP;
            }
            self.update_sweeps();
        }
        true
    }

    /// Brings the ends of what seems free near to where they will be. With ends too far out, nodes
    /// would be opened too far and hold too little room.
    fn close_in(&mut self) {
        let mut step = CLOSE_IN[0];
        for _ in 0..PROBES {
            if step < CLOSE_IN[1] {
                return;
            }
            let inwards = |s: &FreeSweep| step.min(0.5 * (s.hi - s.lo));
            let looked = self.now.sweeps.iter().flat_map(|s| [s.lo + inwards(s), s.hi - inwards(s)]);
            let looked: Vec<f64> = looked.collect();
            // All of them, and not only up to the first that is taken.
            let taken = looked.into_iter().filter(|theta| self.probe(*theta)).count();
            if taken > 0 {
                self.update_sweeps();
            } else {
                step *= 0.25;
            }
        }
    }

    /// By how much the interval reaches out of those of the place before, and the middle of what
    /// does.
    fn growth_of(&self, lo: f64, hi: f64) -> (f64, f64) {
        let mut best = (f64::INFINITY, 0.5 * (lo + hi));
        for [from, to] in &self.before {
            for turn in [-std::f64::consts::TAU, 0.0, std::f64::consts::TAU] {
                let (from, to) = (from + turn, to + turn);
                if to < lo || from > hi {
                    continue;
                }
                let (below, above) = (from - lo, hi - to);
                let by = below.max(above).max(0.0);
                if by < best.0 {
                    best = (by, if below > above { 0.5 * (lo + from) } else { 0.5 * (to + hi) });
                }
            }
        }
        best
    }

    /// Looks for a point inside the tool at an angle; what it forbids becomes known.
    fn probe(&mut self, theta: f64) -> bool {
        let scene = self.scene;
        let (axis, centre, sight) = (bound::axis(self.search.b(), theta), self.search.centre(), *self.search.sight());
        let mut open: Vec<Start> = self.search.roots();
        while let Some((body, index)) = open.pop() {
            let b = &scene.bodies[usize::from(body)];
            let node = b.tree.node(index);
            let v = sight.seen(&(node.centre - centre));
            if bound::least_margin(&b.profile, &axis, &v, node.radius, &sight.all_seen(&node.half)) > 0.0 {
                continue;
            }
            match b.tree.below(index) {
                Below::Nodes(left, right) => {
                    let margin =
                        |i: u32| bound::margin(&b.profile, &axis, &sight.seen(&(b.tree.node(i).centre - centre)));
                    let nearer = if margin(left) <= margin(right) { [right, left] } else { [left, right] };
                    open.extend(nearer.map(|i| (body, i)));
                }
                Below::Leaf(leaf) => {
                    let corners = b.tree.corners(leaf).map(|c| sight.seen(&(c - centre)));
                    let (middle, radius) = b.tree.sphere(leaf);
                    let middle = sight.seen(&(middle - centre));
                    for f in &b.profile.frusta {
                        if let Verdict::Taken(p) = clear::triangle(f, &axis, &corners, middle, radius) {
                            self.search.take_point(body, leaf, &(centre + sight.unseen(&p)));
                            return true;
                        }
                    }
                }
            }
        }
        false
    }

    /// Opens what is not clear; points of leaves that are not become known.
    fn verify(&mut self) {
        let scene = self.scene;
        let (centre, b, sight) = (self.search.centre(), self.search.b(), *self.search.sight());
        while let Some(Due { at: (body, index), looked }) = self.open.pop() {
            let on = &scene.bodies[usize::from(body)];
            let node = on.tree.node(index);
            let v = sight.seen(&(node.centre - centre));
            let half = sight.all_seen(&node.half);
            let room = || bound::room(&on.profile, &self.now.sweeps, b, &v, node.radius, &half);
            if let Some(room) = if looked { None } else { room() } {
                self.front.hold((body, index), &room, &self.now);
                continue;
            }
            match on.tree.below(index) {
                Below::Nodes(left, right) => self.open.extend([right, left].map(|i| Due::new((body, i)))),
                Below::Leaf(leaf) => {
                    let room = self.settle(body, leaf, Some(&v)).unwrap_or(NodeRoom::anyhow(f64::NEG_INFINITY));
                    self.front.hold((body, index), &room, &self.now);
                }
            }
        }
    }

    /// Makes known what a leaf forbids beyond what is; the room that is left, where there is any.
    /// Where nothing can be shown for the whole leaf it is halved.
    fn settle(&mut self, body: u16, leaf: u32, box_at: Option<&Vector>) -> Option<NodeRoom> {
        let scene = self.scene;
        let on = &scene.bodies[usize::from(body)];
        let (centre, b, sight) = (self.search.centre(), self.search.b(), *self.search.sight());
        let (middle, radius) = on.tree.sphere(leaf);
        let whole = sight.seen(&(middle - centre));
        let (mut least, mut looked) = (f64::INFINITY, 0);
        let mut open = Vec::new();
        let mut piece = Some((on.tree.corners(leaf).map(|c| sight.seen(&(c - centre))), whole, radius));
        'pieces: while let Some((corners, middle, radius)) = piece.take().or_else(|| open.pop()) {
            looked += 1;
            if looked > PIECES {
                self.search.take_leaf(body, leaf);
                self.update_sweeps();
                return None;
            }
            for _ in 0..ROUNDS {
                if self.now.sweeps.is_empty() {
                    return None;
                }
                let mut between = bound::between_ends(&on.profile, &self.now.sweeps, b, &corners, &middle, radius);
                let mut found = TriangleLeaves::Open;
                if let Between::Around(tall) = between {
                    found = look(tall, &self.now.sweeps, &corners, (&middle, radius), box_at);
                    let mut axes = self.now.sweeps.iter().flat_map(|s| s.axes);
                    let mut own = |p: &Vector| axes.any(|axis| bound::margin(&on.profile, &axis, p) <= 0.0);
                    let decided = match &found {
                        TriangleLeaves::Clear(_) => true,
                        TriangleLeaves::Taken(p) => own(p),
                        TriangleLeaves::Open => false,
                    };
                    if !decided {
                        found = TriangleLeaves::Open;
                        between = bound::by_steps(&on.profile, &self.now.sweeps, b, &corners, &middle, radius);
                    }
                }
                match between {
                    Between::Room(mm) => {
                        least = least.min(mm);
                        continue 'pieces;
                    }
                    Between::Ends => found = look(&on.profile, &self.now.sweeps, &corners, (&middle, radius), box_at),
                    Between::Nothing | Between::Around(_) => {}
                }
                match found {
                    TriangleLeaves::Taken(p) => {
                        self.search.take_point(body, leaf, &(centre + sight.unseen(&p)));
                        self.update_sweeps();
                    }
                    TriangleLeaves::Clear(room) if looked == 1 => return room,
                    TriangleLeaves::Clear(room) => {
                        least = least.min(room.map_or(0.0, |r| r.mm));
                        continue 'pieces;
                    }
                    TriangleLeaves::Open => break,
                }
            }
            open.extend(halves(&corners.map(Point::from)).map(|half| {
                let (middle, radius) = around_triangle(&half);
                (half.map(|c| c.coords), middle.coords, radius)
            }));
        }
        let across = (whole.y * whole.y + whole.z * whole.z).sqrt() + radius + least;
        Some(NodeRoom::new(least, across, whole.norm() + radius + least))
    }

    /// Chooses few of the points found that cover all that is known to be taken.
    fn cover(&mut self) {
        let (log, gap) = (self.search.log(), self.scene.options.settings.tolerance_deg.to_radians());
        let seeds = &mut self.seeds;
        let mut keep = |k: usize| {
            let l = &log[k];
            if let Some(point) = l.point {
                let seed = Seed { body: l.body, leaf: l.leaf, point };
                if !seeds.contains(&seed) {
                    seeds.push(seed);
                }
            }
        };
        for known in self.search.known().arcs() {
            let mut at = known.lo;
            let farthest = |from: f64| {
                let mut best: Option<(usize, &Arc)> = None;
                for (k, l) in log.iter().enumerate().filter(|(_, l)| l.arc.lo <= from) {
                    if best.is_none_or(|(_, a)| l.arc.hi > a.hi) {
                        best = Some((k, &l.arc));
                    }
                }
                best.map(|(k, a)| (k, a.hi))
            };
            let mut first = true;
            while at < known.hi {
                let near = if first { at } else { at - OVERLAP };
                let next = farthest(near).filter(|n| n.1 > at).or_else(|| farthest(at + gap).filter(|n| n.1 > at));
                let Some((k, hi)) = next else { break };
                keep(k);
                (at, first) = (hi, false);
            }
        }
    }
}

/// What a triangle leaves at the ends of the free intervals.
enum TriangleLeaves {
    /// It is clear there; the room that can be shown.
    Clear(Option<NodeRoom>),
    /// This point is too near.
    Taken(Vector),
    /// Too near to tell.
    Open,
}

/// Looks at a triangle at the ends of all intervals; it lies within `radius` of its point `middle`,
/// and the box of its node about `box_at`.
fn look(
    profile: &ToolProfile,
    sweeps: &[FreeSweep],
    corners: &[Vector; 3],
    (middle, radius): (&Vector, f64),
    box_at: Option<&Vector>,
) -> TriangleLeaves {
    let box_at = box_at.unwrap_or(middle);
    let mut facets = Some([Facet::none(); 2]);
    for axes in sweeps.iter().map(|s| &s.axes) {
        for (k, axis) in axes.iter().enumerate() {
            let (z, r) = bound::height_and_radius(axis, middle);
            for (part, f) in profile.frusta.iter().enumerate() {
                let above = f.above(z) - radius;
                if above > 0.0 && facets.as_ref().is_none_or(|both| above >= both[k].flat.least) {
                    if let Some(both) = &mut facets {
                        both[k].others = both[k].others.min(above);
                    }
                    continue;
                }
                let (m, by_z, by_r) = f.margin(z, r);
                if m > radius {
                    if let Some(both) = &mut facets {
                        let t = if r > 0.0 { by_r / r } else { 0.0 };
                        let slope = middle * t + axis * (by_z - t * z);
                        both[k].add(part, Flat { least: m - radius, middle: m + slope.dot(&(box_at - middle)), slope });
                    }
                    continue;
                }
                match clear::nearest(f, axis, corners, middle) {
                    Nearness::Clear(tangent) => {
                        let least = tangent.least(corners);
                        match &mut facets {
                            Some(both) if least > 1e-9 => {
                                both[k].add(part, Flat { least, middle: tangent.over(box_at), slope: tangent.slope })
                            }
                            _ => facets = None,
                        }
                    }
                    Nearness::Taken(p) => return TriangleLeaves::Taken(p),
                    Nearness::Open => return TriangleLeaves::Open,
                }
            }
        }
    }
    let rho = (middle.y * middle.y + middle.z * middle.z).sqrt() + radius;
    TriangleLeaves::Clear(facets.filter(|_| sweeps.len() == 1).map(|both| {
        let mm = both[0].flat.least.min(both[1].flat.least);
        NodeRoom { mm, across: rho + mm, reach: middle.norm() + radius + mm, facets: Some(both) }
    }))
}
