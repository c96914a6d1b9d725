//! The constant-scallop neighbour of a place of a path: the place on the level set, straight across
//! from it, between which and it the ridge has the height asked for.
//!
//! *Across* is the plane through the ball centre perpendicular to the path. The level set meets it
//! in a curve; the ridge grows along that curve about as the square of the way, so the way `w` is
//! found by `w ← w √(h / ridge)`, kept within what is known to be too little and too much. Where
//! the curve turns fast (a fillet hardly larger than the ball) or has a corner (one smaller than
//! the ball) it is walked in short steps instead, and from a corner on along the other wall.

use nalgebra::{Matrix2, Vector2};

use super::fineness::{Fineness, STILL};
use crate::geometry::{Point, Vector};
use crate::path::bounds::{Bounds, STEP_RAD, Stop};
use crate::path::level::{LevelSet, Touch};
use crate::path::stepover::{Pass, ridge_over_creases, round};

/// Turn of the normal up to which a neighbour is sought by a single step, rad.
const STRAIGHT_RAD: f64 = 0.5;
/// Tries of the law of squares: three do where the curvature is steady, more on facets.
const MOST_TRIES: usize = 14;
/// Steps of a walk before it is given up.
const MOST_STEPS: usize = 400;
/// Turns by which the ball is rolled on to see whether it rolls, rad, and how often.
const ON_RAD: f64 = 0.1;
const MOST_ROLL: usize = 12;
/// The least share of the way to a neighbour on which a ball is found to roll over an edge.
const LEAST_ROLL: f64 = 0.02;
/// A turn so many times as far from a place beyond an edge as the place that it is sought from lies
/// beyond the edge itself.
const NEAR: f64 = 1.5;
/// Cosine of the angle between the blade axis and an edge up to which the edge may be one that
/// turns go over: 60°.
const UPRIGHT: f64 = 0.5;
/// Halvings towards the place where the ball begins to roll over an edge.
const EDGE_HALVINGS: usize = 16;
/// Distance at which the bend of the part is looked at, as a share of the corner's radius.
const NEAR_BY: f64 = 0.02;
/// Cosine between the way to a neighbour and the direction square to a turn, at least: where a
/// cutter leans aside more than along its way neighbours are sought square to it.
const LEAST_ASIDE: f64 = 0.15;
/// Halvings towards the last place at which a disc has room: a thousandth of the stepover.
const DISC_HALVINGS: usize = 10;
/// Halvings towards a bound: the stepover times 10⁻⁸.
const HALVINGS: usize = 27;

/// A neighbour.
#[derive(Clone, Copy, Debug)]
pub struct Next {
    /// The ball there.
    pub touch: Touch,
    /// Way to it along the level set, mm.
    pub way_mm: f64,
    /// Why it is nearer than the scallop asks for.
    pub stop: Option<Stop>,
}

/// Whether the ball rolls over one edge between two places of one way: its normal turns, and its
/// contact moves along the edge at most, which is across the turn.
fn rolls_over(a: &Next, b: &Next) -> bool {
    let turn = (b.touch.normal - a.touch.normal).try_normalize(1e-9);
    let moved = b.touch.contact - a.touch.contact;
    turn.is_some_and(|t| moved.dot(&t).abs() < STILL * (b.way_mm - a.way_mm).abs())
}

/// Whether the ball rolls round the end of an edge, or an edge that is hardly rounded, between two
/// places of one way: its contact stays about there.
fn rolls_round(a: &Next, b: &Next, share: f64) -> bool {
    (b.touch.contact - a.touch.contact).norm() < share * (b.way_mm - a.way_mm).abs()
}

/// Whether a turn, near one of its places, lies already beyond an edge over which the ball would
/// roll from `onset` to `over`, and the edge runs up the blade more than round it: a blunt trailing
/// edge, say, which the turn goes over aslant, to go on on its other side.
fn is_beyond(turn: &[Touch], from: &Heading, onset: &Touch, over: &Touch) -> bool {
    let edge = onset.normal.cross(&over.normal).try_normalize(1e-9);
    if edge.is_none_or(|e| e.x.abs() < UPRIGHT) {
        return false;
    }
    let near_mm = NEAR * (over.centre - from.touch.centre).norm();
    let half_rad = 0.5 * onset.normal.angle(&over.normal);
    turn.iter().any(|t| (t.centre - over.centre).norm() < near_mm && t.normal.angle(&over.normal) < half_rad)
}

/// The direction in which the path goes on from a touch, and the plane across it.
#[derive(Clone, Copy, Debug)]
pub struct Heading {
    /// The ball.
    pub touch: Touch,
    /// Unit direction of the path.
    pub along: Vector,
}

impl Heading {
    /// The same place of the path run the other way: across lies to the other side.
    pub fn back(&self) -> Heading {
        Heading { along: -self.along, ..*self }
    }
}

/// Seeks neighbours on one level set.
#[derive(Clone, Copy)]
pub struct Across<'a> {
    /// The level set.
    pub level: &'a LevelSet<'a>,
    /// Where to stay.
    pub bounds: Bounds<'a>,
    /// Least step of a walk, mm: turns sharper than this are corners.
    pub min_step_mm: f64,
}

impl Across<'_> {
    /// The neighbour that leaves the ridge `h_mm`; `guess_mm` is about how far off, and `turn` the
    /// turn round the place. `None` where the ball cannot go there.
    pub fn neighbour(&self, from: &Heading, turn: &[Touch], h_mm: f64, guess_mm: f64) -> Option<Next> {
        let own = Pass::new(self.level, &from.touch, &from.along);
        let ridge = |t: &Touch| {
            let beside = Pass::new(self.level, t, &from.along);
            ridge_over_creases(self.level, [&own, &beside])
        };
        let next = self
            .straight(from, ridge, h_mm, guess_mm)
            .or_else(|| self.walk(from, guess_mm, |t, _| ridge(t).unwrap_or(f64::INFINITY) >= h_mm))?;
        Some(self.short_of_cutting(from, self.short_of_an_edge(from, turn, next)))
    }

    /// The same, or the last place on the way there at which the disc of a cutter with a corner has
    /// room at the part.
    fn short_of_cutting(&self, from: &Heading, next: Next) -> Next {
        if !self.bounds.disc_fits || self.level.disc_fits(&next.touch) {
            return next;
        }
        let stop = Some(Stop::Disc(next.touch.contact));
        let mut fits = Next { touch: from.touch, way_mm: 0.0, stop };
        let mut cuts_mm = next.way_mm;
        for _ in 0..DISC_HALVINGS {
            let middle = 0.5 * (fits.way_mm + cuts_mm);
            match self.at_way(from, middle) {
                Some(n) if self.level.disc_fits(&n.touch) => fits = Next { way_mm: middle, stop, ..n },
                _ => cuts_mm = middle,
            }
        }
        fits
    }

    /// The same, or where the ball begins to roll over a sharp edge on the way there, unless the
    /// turn itself goes over that edge.
    pub fn short_of_an_edge(&self, from: &Heading, turn: &[Touch], next: Next) -> Next {
        let radius = self.level.radius_mm;
        let (bend, moved) = (next.touch.normal - from.touch.normal, next.touch.centre - from.touch.centre);
        // Rolling all the way makes this 1. Most walls are too straight, and a concave one makes it
        // negative.
        if bend.dot(&moved) * radius < LEAST_ROLL * moved.norm_squared() {
            return next;
        }
        let free = Across { bounds: Bounds::NONE, ..*self };
        let farther = |turn: f64| free.at_way(from, next.way_mm + turn * radius);
        let Some(on) = farther(ON_RAD) else { return next };
        let fineness = Fineness::of(self.level);
        let along_edge = rolls_over(&next, &on);
        if !along_edge && !rolls_round(&next, &on, fineness.round) {
            return next;
        }
        let rolls = |a: &Next, b: &Next| if along_edge { rolls_over(a, b) } else { rolls_round(a, b, fineness.round) };
        let start = Next { touch: from.touch, way_mm: 0.0, stop: None };
        let mut before = free.onset(from, start, next.way_mm, |n| rolls(n, &on));
        let sharp_rad = fineness.sharp_rad;
        let turned = |n: &Next| before.touch.normal.angle(&n.touch.normal);
        let rolled = (2..).map_while(|k| farther(f64::from(k) * ON_RAD).filter(|n| rolls(n, &on)));
        let mut over = std::iter::once(on).chain(rolled.take(MOST_ROLL));
        let Some(over) = over.find(|n| turned(n) >= sharp_rad) else { return next };
        if is_beyond(turn, from, &before.touch, &over.touch) {
            return next;
        }
        // The contact may move by a share of the way: seen from near by, that is little.
        for near_rad in [ON_RAD, 0.1 * ON_RAD] {
            let near = free.at_way(from, before.way_mm + near_rad * radius).filter(|n| n.way_mm < on.way_mm);
            if let Some(near) = near.filter(|n| rolls(n, &on)) {
                before = free.onset(from, before, near.way_mm, |n| rolls(n, &near));
            }
        }
        Next { stop: Some(Stop::Edge(on.touch.contact)), ..before }
    }

    /// The last place between two of a way, of which the second is rolling, at which the ball does
    /// not roll yet.
    fn onset(&self, from: &Heading, first: Next, rolling_mm: f64, rolls: impl Fn(&Next) -> bool) -> Next {
        let (mut before, mut low, mut high) = (first, first.way_mm, rolling_mm);
        if rolls(&first) {
            return first;
        }
        for _ in 0..EDGE_HALVINGS {
            let middle = 0.5 * (low + high);
            match self.at_way(from, middle) {
                Some(n) if !rolls(&n) => (low, before) = (middle, n),
                _ => high = middle,
            }
        }
        before
    }

    /// The place at the given way, or where the ball begins to roll over a sharp edge before it;
    /// `turn` is the turn round the place.
    pub fn reach(&self, from: &Heading, turn: &[Touch], way_mm: f64) -> Option<Next> {
        self.at_way(from, way_mm).map(|next| self.short_of_an_edge(from, turn, next))
    }

    /// The place at the given way.
    fn at_way(&self, from: &Heading, way_mm: f64) -> Option<Next> {
        if let Some((touch, way)) = self.ways(from).and_then(|ways| self.beside(from, ways, way_mm))
            && self.bounds.hold(&touch)
        {
            return Some(Next { touch, way_mm: way, stop: None });
        }
        self.walk(from, way_mm, |_, way| way >= way_mm)
    }

    /// One step across by `way_mm` and onto the level set, with the way along it; `None` where the
    /// level set turns too fast for that.
    fn beside(&self, from: &Heading, ways: [Vector; 2], way_mm: f64) -> Option<(Touch, f64)> {
        let (touch, way) = self.step_along(from, ways, way_mm, 0.8)?;
        let turn = from.touch.normal.dot(&touch.normal);
        let fair = (0.8..1.25).contains(&(way / way_mm.max(1e-300)));
        (turn >= STRAIGHT_RAD.cos() && fair).then_some((touch, way))
    }

    /// One step across by `way_mm` and onto the level set, which may be off by the share `reach` of
    /// the step, with the way along it.
    pub fn step(&self, from: &Heading, way_mm: f64, reach: f64) -> Option<(Touch, f64)> {
        self.step_along(from, self.ways(from)?, way_mm, reach)
    }

    fn step_along(&self, from: &Heading, [side, along]: [Vector; 2], way_mm: f64, reach: f64) -> Option<(Touch, f64)> {
        let guess = from.touch.centre + side * way_mm;
        let touch = self.level.touch_across(&guess, &along, reach * way_mm)?;
        let half = 0.5 * from.touch.normal.angle(&touch.normal);
        let chord = (touch.centre - from.touch.centre).norm();
        // The way along a curve of constant curvature with this chord and turn.
        let arc = if half > 1e-4 && half < 1.0 { chord * half / half.sin() } else { chord };
        Some((touch, arc))
    }

    /// The unit direction in which the neighbour of a place lies, and that across the plane in
    /// which it is sought. For a ball the first is square to the way. What a cutter with a corner
    /// leaves at a place beside its way is left by a place of it farther back or ahead, in the
    /// direction that is conjugate to the way by the curvatures `K` of cutter and part. From turn
    /// to turn places go along these lines: square to the way they would pass beyond the bends of
    /// the next turn, and bends grow.
    ///
    /// Contacts `x` go as the corner's centres `(I + r S) x`, with the part's shape `S`. Seen by
    /// centres, with `M = (I + r S)⁻¹` and the cutter's curvatures `T`, `K` is
    /// `M T M + (M − M²)/r`.
    fn ways(&self, from: &Heading) -> Option<[Vector; 2]> {
        let normal = &from.touch.normal;
        let square = from.along.cross(normal).try_normalize(1e-6)?;
        let Some(inclined) = self.level.inclined else { return Some([square, from.along]) };
        let frame = [square, normal.cross(&square)];
        let conjugate = || {
            let laid = inclined.curvatures(&round(self.level, &from.touch)?, &frame)?[1];
            let [a, b] = [self.shrunk(from, &frame[0])?, self.shrunk(from, &frame[1])?];
            let seen = |v: &Vector| Vector2::new(v.dot(&frame[0]), v.dot(&frame[1]));
            let m = Matrix2::from_columns(&[seen(&a), seen(&b)]);
            let m = 0.5 * (m + m.transpose());
            let by = (m * laid * m + (m - m * m) / self.level.radius_mm) * Vector2::y();
            let by = frame[0] * by.x + frame[1] * by.y;
            by.cross(normal).try_normalize(1e-9)
        };
        let side = conjugate().filter(|side| side.dot(&square).abs() > LEAST_ASIDE);
        let side = side.map_or(square, |side| side * side.dot(&square).signum());
        Some([side, normal.cross(&side)])
    }

    /// `M` of [`Self::ways`] times a unit direction across the normal: how contacts go where
    /// centres go along it.
    fn shrunk(&self, from: &Heading, along: &Vector) -> Option<Vector> {
        let step = NEAR_BY * self.level.radius_mm;
        let touch = |sign: f64| self.level.touch(&(from.touch.centre + along * (sign * step)), step);
        let bend = match (touch(1.0), touch(-1.0)) {
            (Some(a), Some(b)) => (a.normal - b.normal) / (2.0 * step),
            (Some(a), None) => (a.normal - from.touch.normal) / step,
            (None, Some(b)) => (from.touch.normal - b.normal) / step,
            (None, None) => return None,
        };
        let bend = bend - from.touch.normal * from.touch.normal.dot(&bend);
        Some(along - bend * self.level.radius_mm)
    }

    /// The neighbour that leaves the ridge `h_mm` by single steps; `ridge`: that between the place
    /// and another.
    fn straight(
        &self,
        from: &Heading,
        ridge: impl Fn(&Touch) -> Option<f64>,
        h_mm: f64,
        guess_mm: f64,
    ) -> Option<Next> {
        let (fineness, ways) = (Fineness::of(self.level), self.ways(from)?);
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut best: Option<Next> = None;
        let mut asked = guess_mm;
        for _ in 0..MOST_TRIES {
            let (touch, way_mm) = self.beside(from, ways, asked)?;
            let ridge = ridge(&touch)?;
            let factor = (h_mm / ridge.max(1e-3 * h_mm)).sqrt();
            let inside = self.bounds.hold(&touch);
            if !inside && factor >= 1.0 {
                return self.stopped(from, ways, &touch, asked);
            }
            let next = asked * factor.clamp(0.4, 2.5);
            if (factor - 1.0).abs() <= fineness.nearly {
                let (touch, way_mm) = if (factor - 1.0).abs() <= fineness.good {
                    (touch, way_mm)
                } else {
                    self.beside(from, ways, next)?
                };
                if !self.bounds.hold(&touch) {
                    return self.stopped(from, ways, &touch, next);
                }
                return Some(Next { touch, way_mm, stop: None });
            }
            if factor < 1.0 {
                high = asked;
            } else {
                low = asked;
                best = Some(Next { touch, way_mm, stop: None });
            }
            asked = if next > low && next < high { next } else { 0.5 * (low + high.min(4.0 * low.max(asked))) };
            if high - low < 1e-3 * low {
                break;
            }
        }
        best
    }

    /// The last place within bounds on the way to `outside`.
    fn stopped(&self, from: &Heading, ways: [Vector; 2], outside: &Touch, way_mm: f64) -> Option<Next> {
        let (mut inside, mut beyond) = ((from.touch, 0.0), *outside);
        let (mut low, mut high) = (0.0, way_mm);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let (touch, way) = self.beside(from, ways, middle)?;
            if self.bounds.hold(&touch) {
                (low, inside) = (middle, (touch, way));
            } else {
                (high, beyond) = (middle, touch);
            }
        }
        Some(Next { touch: inside.0, way_mm: inside.1, stop: Some(self.bounds.why(&inside.0, &beyond)) })
    }

    /// Walks across in short steps until `enough` says so of a touch and the way to it, or the
    /// bounds are met.
    fn walk(&self, from: &Heading, guess_mm: f64, enough: impl Fn(&Touch, f64) -> bool) -> Option<Next> {
        let mut here = *from;
        let mut walked = 0.0;
        let mut length = guess_mm / 6.0;
        for _ in 0..MOST_STEPS {
            let (touch, way) = self.advance(&here, &mut length, guess_mm / 4.0)?;
            let stops = !self.bounds.hold(&touch);
            if stops || enough(&touch, walked + way) {
                return Some(self.close_in(&here, walked, (touch, way), enough));
            }
            walked += way;
            here.touch = touch;
            if walked > 12.0 * guess_mm {
                return None;
            }
        }
        None
    }

    /// The last place between two touches of a walk that is within bounds and not yet enough.
    fn close_in(&self, here: &Heading, walked: f64, there: (Touch, f64), enough: impl Fn(&Touch, f64) -> bool) -> Next {
        let (mut inside, mut beyond) = ((here.touch, 0.0), there.0);
        let (mut low, mut high) = (0.0, there.1);
        let halvings = if self.bounds.hold(&there.0) { HALVINGS / 2 } else { HALVINGS };
        for _ in 0..halvings {
            let middle = 0.5 * (low + high);
            let Some((touch, way)) = self.step(here, middle, 4.0) else {
                high = middle;
                continue;
            };
            if self.bounds.hold(&touch) && !enough(&touch, walked + way) {
                (low, inside) = (middle, (touch, way));
            } else {
                (high, beyond) = (middle, touch);
            }
        }
        let stop = (!self.bounds.hold(&beyond)).then(|| self.bounds.why(&inside.0, &beyond));
        Next { touch: inside.0, way_mm: walked + inside.1, stop }
    }

    /// One step of a walk; `length` is the step tried first and, afterwards, the one to try next.
    fn advance(&self, here: &Heading, length: &mut f64, most_mm: f64) -> Option<(Touch, f64)> {
        let [side, _] = self.ways(here)?;
        let mut step = length.clamp(self.min_step_mm, most_mm.max(self.min_step_mm));
        loop {
            let last_try = step <= self.min_step_mm;
            if let Some((touch, way)) = self.step(here, step, if last_try { 4.0 } else { 0.8 }) {
                let forward = (touch.centre - here.touch.centre).dot(&side) > 0.2 * step;
                let turn = here.touch.normal.angle(&touch.normal);
                if forward && (turn <= STEP_RAD || last_try) {
                    *length = if turn < 0.4 * STEP_RAD { 1.6 * step } else { step };
                    return Some((touch, way));
                }
                if last_try {
                    return self.turn_corner(here, &touch, &(here.touch.centre + side * step), &side);
                }
            } else if last_try {
                return None;
            }
            step = (0.5 * step).max(self.min_step_mm);
        }
    }

    /// In a concave corner the ball touches two walls, and the way on is along the second: the one
    /// that a step along the first would cut into.
    fn turn_corner(&self, here: &Heading, there: &Touch, into_wall: &Point, side: &Vector) -> Option<(Touch, f64)> {
        let radius = self.level.radius_mm;
        let second = self.level.part.closest(into_wall, 2.0 * radius)?;
        let normal = (there.centre - second.point).try_normalize(1e-9)?;
        let touches = (second.point - there.centre).norm() <= radius * (1.0 + 1e-3);
        // A corner turns the normal back against the way; anything else is a place where the curve
        // cannot be followed.
        let turns = normal.dot(side) < here.touch.normal.dot(side) - 0.05;
        let way = (there.centre - here.touch.centre).norm();
        (touches && turns)
            .then_some((Touch { centre: there.centre, contact: second.point, normal, face: second.face }, way))
    }
}
