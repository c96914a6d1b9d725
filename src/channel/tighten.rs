//! Ends of free intervals from the exact faces.
//!
//! The search ([`super::track`]) keeps the mesh's deflection `δ` as room: what it says is free is
//! free, but an end may be timid, by `δ/s` where the tool touches at a lever `s`, and by `√(2δ/R)`
//! where shaft and ball touch side by side. Here each end that the part binds is moved outwards to
//! where an exact point of the part forbids it, less the tolerance, and all faces are shown to be
//! clear there.
//!
//! A point that the tool can reach at all is inside it for one arc of θ about its own azimuth
//! ([`super::track`]). So what is clear at the end `θ₁`, with its azimuth not between `θ₁` and the
//! end `θ₀` that was safe already, forbids nothing in between. The faces are looked at piece by
//! piece ([`pieces`](crate::geometry::exact::pieces)), with the tool at `θ₁`: a piece is clear if
//!
//! - a tangent plane of the convex distance from each part of the tool is positive on all points in
//!   whose hull the piece lies: at the piece's middle, or where the tool comes nearest to the two
//!   triangles of its corners, or
//! - a plane across the normal of the contact, of the touch that stops the end, or of the piece,
//!   has the part of the tool on its one side and the hull on its other.
//!
//! The second decides beside the contact, where part and tool both hug one plane: at a tolerance
//! `τ` the room there is `R τ²/2`, some 10⁻⁷ mm, and only a few pieces small enough for that are
//! needed. The middle of a piece that is not clear forbids arcs in closed form; where they reach
//! beyond `θ₁` it moves inwards. At the end some point of the part forbids `θ₁` moved out by the
//! tolerance.
//!
//! **Limits**: only for tools that widen upwards ([`Profile::widens`]); no end moves by more than
//! [`FARTHEST`]; an end whose proof takes more than [`MOST_CUTS`] halvings is tried half way and
//! else stays where it was (at most 12 of 63,000 on `steam_root`).

use crate::artifact::{Cone, Toolpath};
use crate::error::{Result, Stage};
use crate::geometry::exact::pieces::{SeenPiece, Visitor, Walker};
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;

use super::arcs::{Arc, Witness, push_arcs};
use super::bound::{self, FreeSweep};
use super::clear;
use super::forbidden::{Free, ObstacleBody, ObstacleScene};
use super::profile::{Frustum, HeightRange, ToolProfile};
use super::samples::Sample;
use super::sight::Sight;
use super::track;

/// The first step of an end of which no point is known that stops it, rad.
const FIRST_STEP: f64 = 0.005;
/// The part is not farther than this from the triangles that stand for it, mm.
const NEAR_MM: f64 = 0.1;
/// No end moves by more than this, rad.
const FARTHEST: f64 = 0.5;
/// Halvings of pieces for one end, at most.
const MOST_CUTS: usize = 2000;
/// Room that is none, mm.
const NONE_MM: f64 = 1e-11;
/// An end lies within this share of the tolerance of an angle that is forbidden.
const SHARE: f64 = 0.9;
/// Points of the places before that are looked at first.
const SEEDS: usize = 4;
/// Places that one thread works on in a row; fixed, so that the result does not depend on the
/// number of threads.
const BATCH: usize = 128;

/// How ends are moved: by the exact part and the tool with its clearances alone.
pub(super) struct ExactEnds<'a> {
    pub part: &'a Part,
    pub profile: ToolProfile,
    /// Of the ends, rad.
    pub tolerance: f64,
}

/// A place of which the ends are to be moved.
struct EndsAt<'a> {
    body: &'a ObstacleBody<'a>,
    sample: &'a Sample,
    /// Where the ball touches the part, if that is known.
    contact: Option<Point>,
    /// The free intervals beside all bodies but the part.
    limits: &'a [Free],
}

impl ExactEnds<'_> {
    /// Moves the ends that the part binds; nothing happens where it has no exact faces.
    ///
    /// # Errors
    /// `Cancelled`.
    pub fn tighten(
        &self,
        scene: &ObstacleScene,
        (samples, path): (&[Sample], &Toolpath),
        layers: &mut [Vec<Free>],
        observer: &dyn Observer,
    ) -> Result<()> {
        let Some((brep, faces)) = self.part.exact().filter(|_| self.profile.widens) else { return Ok(()) };
        let others = ObstacleScene { bodies: scene.bodies.iter().skip(1).cloned().collect(), options: scene.options };
        let limits = track::free_everywhere(&others, samples, observer)?;
        let Some(body) = scene.bodies.first() else { return Ok(()) };
        let places = layers.chunks_mut(BATCH).zip(samples.chunks(BATCH)).zip(limits.chunks(BATCH));
        parallel::try_map(places, |((layers, samples), limits)| {
            observer.check(Stage::Channel)?;
            let (mut seeds, mut walker) = (Vec::new(), Walker::new(faces, brep));
            for ((layer, sample), limits) in layers.iter_mut().zip(samples).zip(limits) {
                // Under an allowance of stock contacts are no points of the part.
                let location = path.locations.get(sample.row);
                let touches = location.filter(|_| sample.fraction == 0.0 && path.stock_mm == 0.0);
                let place = EndsAt { body, sample, contact: touches.map(|l| l.contact), limits };
                self.place(&place, layer, &mut walker, &mut seeds);
            }
            Ok(())
        })?;
        Ok(())
    }

    /// All ends at one place.
    fn place(&self, at: &EndsAt, layer: &mut Vec<Free>, walker: &mut Walker, seeds: &mut Vec<Point>) {
        let EndsAt { body, sample, contact, limits } = *at;
        let before = std::mem::take(seeds);
        for k in 0..layer.len() {
            for sense in [-1.0, 1.0] {
                let (at, by) = if sense < 0.0 { (layer[k].lo, layer[k].lo_by) } else { (layer[k].hi, layer[k].hi_by) };
                if !matches!(by, Witness::Tool { body: 0, .. }) {
                    continue;
                }
                let (room, stop) = farthest(layer, k, sense, limits);
                if room < 0.1 * self.tolerance {
                    continue;
                }
                let mut look = MovingEnd::new(self, sample, at, sense, room);
                let touch = self.touch(body, sample, at, by);
                if !contact.iter().chain(&before).chain(&touch).all(|p| look.takes(p)) {
                    continue;
                }
                // A point of the part that forbids what is farther out: the end is as true as it
                // need be.
                let is_true = look.taken.is_some() && look.end <= (1.0 - SHARE) * self.tolerance;
                if is_true || !self.prove(walker, &mut look) {
                    continue;
                }
                let moved = at + sense * look.end;
                let by = match look.taken {
                    Some((point, segment)) => {
                        if !seeds.contains(&point) && seeds.len() < SEEDS && contact != Some(point) {
                            seeds.push(point);
                        }
                        self.witness(body, &point, segment).unwrap_or(by)
                    }
                    None => stop,
                };
                let f = &mut layer[k];
                if sense < 0.0 {
                    (f.lo, f.lo_by) = (moved, by);
                } else {
                    (f.hi, f.hi_by) = (moved, by);
                }
            }
        }
        join(layer);
    }

    /// The point of the part nearest to where the tool at an end comes nearest to the triangle that
    /// binds it.
    fn touch(&self, body: &ObstacleBody, sample: &Sample, at: f64, by: Witness) -> Option<Point> {
        let Witness::Tool { segment, leaf, .. } = by else { return None };
        let f = self.profile.frusta.get(usize::from(segment))?;
        let axis = sample.cone.tool_axis(at);
        let corners = body.tree.corners(leaf).map(|c| c - sample.centre);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let nearest = match clear::nearest(f, &axis, &corners, &middle) {
            clear::Nearness::Clear(t) => t.at,
            clear::Nearness::Taken(p) => p,
            clear::Nearness::Open => middle,
        };
        Some(self.part.closest(&(sample.centre + nearest), NEAR_MM)?.point)
    }

    /// Finds the end and shows that it is clear; where that takes too long, half way there.
    fn prove(&self, walker: &mut Walker, look: &mut MovingEnd) -> bool {
        self.prove_by_steps(walker, look) || {
            look.set(0.5 * look.end);
            look.end > 0.0 && walker.visit(look, MOST_CUTS)
        }
    }

    /// First for small steps: most ends do not move far.
    fn prove_by_steps(&self, walker: &mut Walker, look: &mut MovingEnd) -> bool {
        let room = look.end;
        let mut step = FIRST_STEP;
        loop {
            let stop = look.taken.is_some() || step >= room;
            if !stop {
                look.set(step);
            }
            if !walker.visit(look, MOST_CUTS) {
                return false;
            }
            if stop || look.taken.is_some() {
                return true;
            }
            look.set(room);
            step *= 4.0;
        }
    }

    /// The triangle nearest to a point of the part, as what binds an end.
    fn witness(&self, body: &ObstacleBody, point: &Point, segment: u16) -> Option<Witness> {
        let triangle = self.part.closest_on_mesh(point, f64::INFINITY)?.triangle?;
        Some(Witness::Tool { segment, body: 0, leaf: body.tree.leaf_of(triangle)? })
    }
}

/// How far an end may move for what is beside the part, and what stops it there.
fn farthest(layer: &[Free], k: usize, sense: f64, limits: &[Free]) -> (f64, Witness) {
    use std::f64::consts::TAU;
    let f = &layer[k];
    let n = layer.len();
    let (mut room, mut stop) = (FARTHEST, if sense < 0.0 { f.lo_by } else { f.hi_by });
    let next = if sense < 0.0 { &layer[(k + n - 1) % n] } else { &layer[(k + 1) % n] };
    let gap = if sense < 0.0 { f.lo - next.hi } else { next.lo - f.hi };
    room = room.min(if gap < 0.0 || n == 1 { gap + TAU } else { gap });
    let middle = 0.5 * (f.lo + f.hi);
    let around = limits.iter().find_map(|o| {
        let turn = ((middle - 0.5 * (o.lo + o.hi)) / TAU).round() * TAU;
        (o.lo + turn <= middle && middle <= o.hi + turn).then_some((o, turn))
    });
    let Some((o, turn)) = around else { return (0.0, stop) };
    let (end, by) = if sense < 0.0 { (f.lo - o.lo - turn, o.lo_by) } else { (o.hi + turn - f.hi, o.hi_by) };
    if end < room && by != Witness::Cut {
        room = end.max(0.0);
        stop = match by {
            Witness::Tool { segment, body, leaf } => Witness::Tool { segment, body: body + 1, leaf },
            other => other,
        };
    }
    (room, stop)
}

/// Makes neighbours that have met one.
fn join(layer: &mut Vec<Free>) {
    let mut out: Vec<Free> = Vec::with_capacity(layer.len());
    for f in layer.drain(..) {
        match out.last_mut() {
            Some(last) if f.lo <= last.hi => (last.hi, last.hi_by) = (f.hi, f.hi_by),
            _ => out.push(f),
        }
    }
    *layer = out;
}

/// One end on its way outwards.
struct MovingEnd<'a> {
    exact: &'a ExactEnds<'a>,
    centre: Point,
    cone: Cone,
    sight: Sight,
    /// (sin B, cos B).
    b: (f64, f64),
    /// The end that is safe, its azimuth and axis; outwards is `sense`.
    start: f64,
    sense: f64,
    /// How far out the end is that is not disproved, rad, and its axis, blade frame.
    end: f64,
    axis: Vector,
    sweep: FreeSweep,
    /// How often it moved inwards.
    moves: u32,
    /// Directions in which the tool is likely to lie beyond the part: the contact's normal, and the
    /// normal where the tool touches the point that forbids what is beyond.
    normals: [Vector; 2],
    /// How low each part of the tool reaches along them, mm.
    lowest: Vec<[f64; 2]>,
    /// The point that forbids what is beyond it, and the part of the tool.
    taken: Option<(Point, u16)>,
    heights: Vec<HeightRange>,
    arcs: Vec<Arc>,
}

impl<'a> MovingEnd<'a> {
    fn new(exact: &'a ExactEnds, sample: &Sample, start: f64, sense: f64, room: f64) -> Self {
        let b = sample.cone.lean_rad.sin_cos();
        let mut look = MovingEnd {
            exact,
            centre: sample.centre,
            cone: sample.cone,
            sight: Sight::of(&sample.cone),
            b,
            start,
            sense,
            end: 0.0,
            axis: Vector::zeros(),
            sweep: FreeSweep::new(start, start, b),
            moves: 0,
            normals: [sample.normal; 2],
            lowest: Vec::new(),
            taken: None,
            heights: Vec::new(),
            arcs: Vec::new(),
        };
        look.set(room);
        look
    }

    fn set(&mut self, end: f64) {
        let at = self.start + self.sense * end;
        self.end = end;
        self.axis = self.cone.tool_axis(at);
        self.sweep = FreeSweep::new(at.min(self.start), at.max(self.start), self.b);
        self.moves += 1;
        let frusta = &self.exact.profile.frusta;
        let touch = self.taken.and_then(|(p, segment)| {
            let (_, slope) = clear::margin(frusta.get(usize::from(segment))?, &self.axis, &(p - self.centre));
            slope.try_normalize(0.5).map(|s| -s)
        });
        self.normals[1] = touch.unwrap_or(self.normals[0]);
        self.lowest.clear();
        self.lowest.extend(frusta.iter().map(|f| self.normals.map(|n| f.lowest(&self.axis, &n))));
    }

    /// Lower bound of the margin within `radius` of `v` from a tool whose points have one arc each,
    /// at the end; `None`: all of it is clear from the end to the start. `least` bounds it at one
    /// axis, with how low the tool reaches along the normals. What has no place (numbers out of all
    /// bounds) is never clear.
    fn room(
        &self,
        v: &Vector,
        radius: f64,
        hull: &[Point],
        least: impl Fn(&ToolProfile, &[[f64; 2]]) -> f64,
    ) -> Option<f64> {
        let profile = &self.exact.profile;
        let far = v.norm() + radius;
        // Every bound below is made from `v` and what lies within the radius: where these are
        // finite, none of them is NaN.
        if !far.is_finite() {
            return Some(f64::NEG_INFINITY);
        }
        if far - 2.0 * radius > profile.farthest {
            return None;
        }
        let tall = profile.tall.as_deref().filter(|t| far <= t.length);
        let (one_arc, lowest) = match tall {
            _ if far <= profile.length => (profile, self.lowest.as_slice()),
            Some(tall) => (tall, Default::default()),
            None => return Some(-radius),
        };
        let seen = self.sight.seen(v);
        let from_ball = |p: &Point| self.sight.seen(&(p - self.centre));
        let mm = if self.sweep.is_beside(&seen, radius) || self.sweep.have_beside(hull, from_ball) {
            least(one_arc, lowest)
        } else {
            let half = [Vector::x(), Vector::y(), Vector::z()].map(|e| e * radius);
            bound::least_at_own_azimuth(one_arc, self.b, &seen, radius, &half)
        };
        (mm <= NONE_MM).then_some(mm)
    }
}

impl Visitor for MovingEnd<'_> {
    fn enters(&mut self, middle: &Point, sides: &[Vector; 3]) -> bool {
        let v = middle - self.centre;
        let radius = sides.iter().map(Vector::norm_squared).sum::<f64>().sqrt();
        let least = |p: &ToolProfile, lowest: &[[f64; 2]]| {
            let lower = |(k, f)| off_box(f, &self.axis, (&v, radius, sides), (&self.normals, lowest.get(k)));
            p.frusta.iter().enumerate().map(lower).fold(f64::INFINITY, f64::min)
        };
        self.room(&v, radius, &[], least).is_some()
    }

    fn presses(&mut self, piece: &SeenPiece) -> Option<f64> {
        let v = piece.middle - self.centre;
        let radius = piece.radius;
        let least = |p: &ToolProfile, lowest: &[[f64; 2]]| {
            let at = (&v, radius, piece, &self.centre);
            let lower = |(k, f)| off_hull(f, &self.axis, at, (&self.normals, lowest.get(k)));
            p.frusta.iter().enumerate().map(lower).fold(f64::INFINITY, f64::min)
        };
        self.room(&v, radius, piece.hull, least)
    }

    fn takes(&mut self, point: &Point) -> bool {
        let (sin_b, cos_b) = self.b;
        let v = self.sight.seen(&(point - self.centre));
        let (off, m) = (v.x * sin_b, v.y.hypot(v.z) * cos_b);
        self.exact.profile.inside(v.norm(), 0.0, (off - m, off + m), &mut self.heights);
        if self.heights.is_empty() {
            return true;
        }
        // Relative to the start.
        let (sin, cos) = self.start.sin_cos();
        let psi = (v.z * cos - v.y * sin).atan2(v.y * cos + v.z * sin);
        self.arcs.clear();
        for h in &self.heights {
            let by = |segment| Witness::Tool { segment, body: 0, leaf: 0 };
            push_arcs(off, m, psi, (h.low, h.high), (by(h.low_by), by(h.high_by)), &mut self.arcs);
        }
        let mut end = self.end;
        for a in &self.arcs {
            let (near, far, by) = if self.sense < 0.0 { (-a.hi, -a.lo, a.hi_by) } else { (a.lo, a.hi, a.lo_by) };
            if far > 0.0 && near - SHARE * self.exact.tolerance < end {
                end = near - SHARE * self.exact.tolerance;
                let segment = if let Witness::Tool { segment, .. } = by { segment } else { 0 };
                self.taken = Some((*point, segment));
            }
        }
        if end <= 0.0 {
            return false;
        }
        if end < self.end {
            self.set(end);
        }
        true
    }

    fn state(&self) -> u32 {
        self.moves
    }
}

/// Normals and how low a frustum reaches along them, mm, where that is known.
type Below<'a> = (&'a [Vector; 2], Option<&'a [f64; 2]>);

/// Lower bound of a frustum's margin over a box by its middle, radius and half edges, mm.
fn off_box(
    f: &Frustum,
    axis: &Vector,
    (v, radius, sides): (&Vector, f64, &[Vector; 3]),
    (normals, lowest): Below,
) -> f64 {
    let (margin, slope) = clear::margin(f, axis, v);
    let reach = |n: &Vector| sides.iter().map(|s| n.dot(s).abs()).sum::<f64>();
    let least = margin - reach(&slope).min(radius);
    if least > NONE_MM {
        return least;
    }
    let below = |(n, low): (&Vector, &f64)| low - n.dot(v) - reach(n);
    lowest.map_or(least, |lowest| normals.iter().zip(lowest).map(below).fold(least, f64::max))
}

/// Lower bound of a frustum's margin over a piece by planes between them, mm: across the normals,
/// the piece's own normal, and tangent to the margin at the piece's middle or at the nearest point
/// of its corners' triangles.
fn off_hull(
    f: &Frustum,
    axis: &Vector,
    (v, radius, piece, centre): (&Vector, f64, &SeenPiece, &Point),
    (normals, lowest): Below,
) -> f64 {
    let (margin, slope) = clear::margin(f, axis, v);
    if margin > radius {
        return margin - radius;
    }
    // Over the hull, from its middle.
    let least = |n: &Vector| piece.hull.iter().map(|h| n.dot(&(h - piece.middle))).fold(0.0, f64::min);
    let below = |n: &Vector, lowest: f64| lowest - n.dot(v) + least(&-n);
    for (n, low) in normals.iter().zip(lowest.into_iter().flatten()) {
        let room = below(n, *low);
        if room > NONE_MM {
            return room;
        }
    }
    let tangent = margin + least(&slope);
    if tangent > NONE_MM {
        return tangent;
    }
    // The side of the piece on which the ball is.
    let own = if piece.normal.dot(v) > 0.0 { -piece.normal } else { piece.normal };
    let best = tangent.max(below(&own, f.lowest(axis, &own)));
    let Some(corners) = piece.corners.filter(|_| best <= NONE_MM && margin > 0.0) else { return best };
    let [a, b, c, d] = corners.map(|p| p - centre);
    let mut nearest: Option<clear::Tangent> = None;
    for flat in [[a, b, c], [a, c, d]] {
        match clear::nearest(f, axis, &flat, &flat[0]) {
            clear::Nearness::Clear(t) if nearest.is_none_or(|n| t.margin < n.margin) => nearest = Some(t),
            clear::Nearness::Clear(_) => {}
            _ => return best,
        }
    }
    nearest.map_or(best, |t| best.max(t.margin + t.slope.dot(&(v - t.at)) + least(&t.slope)))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::channel::tests::world::tool;

    /// Far above the tool nothing is in the way, unless nobody can say where it is.
    #[test]
    fn what_has_no_place_is_not_clear() {
        let part = Part::from_mesh(crate::geometry::mesh::Mesh::default());
        let profile = ToolProfile::new(&tool(3.0, 4.0), [0.0; 2], 0.0);
        let exact = ExactEnds { part: &part, profile, tolerance: 1e-4 };
        let (centre, normal, cone) = (Point::origin(), Vector::x(), Cone::about_blade(0.0));
        let sample = Sample { row: 0, fraction: 0.0, centre, normal, cone, azimuth: 0.0, within_rad: None };
        let mut look = MovingEnd::new(&exact, &sample, 0.0, 1.0, 0.1);
        let at = Point::new(0.0, -1000.0, 0.0);
        let hull = [at, at + Vector::x(), at + Vector::z()];
        let piece = SeenPiece { hull: &hull, middle: at, radius: 1.0, normal: Vector::y(), corners: None };
        let sides = [Vector::x(), Vector::y(), Vector::z()];
        assert!(look.presses(&piece).is_none() && !look.enters(&at, &sides));
        for bad in [f64::NAN, f64::INFINITY, 1e300] {
            let off = at + Vector::z() * bad;
            assert!(look.presses(&SeenPiece { middle: off, ..piece }).is_some(), "{bad}");
            assert!(look.presses(&SeenPiece { radius: bad, ..piece }).is_some(), "{bad}");
            assert!(look.enters(&off, &sides) && look.enters(&at, &[Vector::x() * bad, sides[1], sides[2]]), "{bad}");
        }
    }
}
