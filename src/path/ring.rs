//! Closed curves of ball centres at constant height along a region, traced on the level set.

use super::level::{LevelSet, Touch};
use crate::artifact::along::Along;
use crate::geometry::triangle::closest_on_segment;
use crate::geometry::{Point, Vector};

/// A closed curve of ball centres in one plane across a region, counter-clockwise seen from its
/// start, starting at its base point; the last touch is not the first repeated.
#[derive(Clone, Debug)]
pub struct Ring {
    /// The way along the region.
    pub along: Along,
    /// Height, mm.
    pub x_mm: f64,
    /// Touches in order.
    pub touches: Vec<Touch>,
    /// Arc length at each touch, mm, from 0.
    pub s_mm: Vec<f64>,
    /// Whole length, mm.
    pub length_mm: f64,
}

/// Why a ring could not be traced.
#[derive(Clone, Debug, PartialEq)]
pub enum Broken {
    /// The wall leans over more than allowed at this contact.
    Leans(Point),
    /// The airfoil ends here without a platform.
    Rim(Point),
    /// The level set could not be followed from here.
    Lost(Point),
    /// The curve did not come back to its start.
    Open(Point),
}

/// How finely rings are traced.
#[derive(Clone, Copy, Debug)]
pub struct Tracing {
    /// Greatest step, mm.
    pub max_step_mm: f64,
    /// Greatest turn of the normal from touch to touch, rad.
    pub max_turn_rad: f64,
    /// Least step, mm: turns sharper than this are creases.
    pub min_step_mm: f64,
    /// Cosine of the greatest lean.
    pub min_cos_lean: f64,
}

impl Ring {
    /// A ring through touches in order.
    pub fn new(along: Along, touches: Vec<Touch>) -> Self {
        let mut s_mm = Vec::with_capacity(touches.len());
        let mut s = 0.0;
        for (i, t) in touches.iter().enumerate() {
            if i > 0 {
                s += (t.centre - touches[i - 1].centre).norm();
            }
            s_mm.push(s);
        }
        let close = match (touches.first(), touches.last()) {
            (Some(a), Some(b)) => (a.centre - b.centre).norm(),
            _ => 0.0,
        };
        let x_mm = touches.first().map_or(0.0, |t| along.height_mm(&t.centre));
        Ring { along, x_mm, touches, s_mm, length_mm: s + close }
    }

    /// Centre at the fraction `u` in [0, 1] of the length, linear between touches.
    pub fn at(&self, u: f64) -> Point {
        let s = u.clamp(0.0, 1.0) * self.length_mm;
        let i = self.s_mm.partition_point(|x| *x <= s).saturating_sub(1);
        let n = self.touches.len();
        let a = self.touches[i].centre;
        let b = self.touches[(i + 1) % n].centre;
        let end = if i + 1 < n { self.s_mm[i + 1] } else { self.length_mm };
        let f = if end > self.s_mm[i] { (s - self.s_mm[i]) / (end - self.s_mm[i]) } else { 0.0 };
        a + (b - a) * f
    }

    /// The nearest point of the closed polyline of centres.
    pub fn nearest(&self, q: &Point) -> Point {
        let n = self.touches.len();
        let mut best = (f64::INFINITY, self.touches[0].centre);
        for i in 0..n {
            let p = closest_on_segment(&self.touches[i].centre, &self.touches[(i + 1) % n].centre, q);
            let dist = (q - p).norm_squared();
            if dist < best.0 {
                best = (dist, p);
            }
        }
        best.1
    }

    /// The same ring starting at its touch `first`.
    #[must_use]
    pub fn starting_at(mut self, first: usize) -> Self {
        self.touches.rotate_left(first);
        Ring::new(self.along, self.touches)
    }

    /// Where concave stretches, in which the normal turns back by `least_turn_rad` at least, begin
    /// and end.
    pub fn altered_points(&self, least_turn_rad: f64) -> Vec<usize> {
        let n = self.touches.len();
        let mut found: Vec<usize> = self.concave_entries(least_turn_rad).into_iter().map(|(i, _)| i).collect();
        // Run backwards, a stretch begins where it ends.
        let mirrored = |t: &Touch| {
            let frame = self.along.frame(&t.centre);
            let [a, b] = frame.across(&t.normal);
            Touch { normal: frame.vector(frame.lean(&t.normal), [a, -b]), ..*t }
        };
        let backwards = Ring::new(self.along, self.touches.iter().rev().map(mirrored).collect());
        found.extend(backwards.concave_entries(least_turn_rad).into_iter().map(|(i, _)| n - 1 - i));
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Where the path enters a concave stretch, with how far the normal turns back there, rad (at
    /// least `least_turn_rad`): the touches with the locally greatest azimuth. These are the
    /// papers' concave–convex altered points, met from the convex side.
    pub fn concave_entries(&self, least_turn_rad: f64) -> Vec<(usize, f64)> {
        let n = self.touches.len();
        let mut found: Vec<(usize, f64)> = Vec::new();
        let (mut azimuth, mut top, mut top_at, mut low) = (0.0, 0.0, 0, 0.0);
        // Twice round, so that a stretch across the ring's start is seen whole.
        for k in 1..=2 * n {
            let at = |k: usize| self.touches[k % n].azimuth(&self.along);
            azimuth += wrap(at(k) - at(k - 1));
            if azimuth > top {
                if top - low >= least_turn_rad {
                    found.push((top_at % n, top - low));
                }
                (top, top_at, low) = (azimuth, k, azimuth);
            }
            low = f64::min(low, azimuth);
        }
        found.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
        found.dedup_by_key(|e| e.0);
        found
    }
}

/// An angle brought to (−π, π].
pub fn wrap(a: f64) -> f64 {
    let t = std::f64::consts::TAU;
    let r = a.rem_euclid(t);
    if r > 0.5 * t { r - t } else { r }
}

/// Traces the ring through `start`.
///
/// # Errors
/// [`Broken`], with the place.
pub fn trace(level: &LevelSet, start: Touch, how: &Tracing) -> Result<Ring, Broken> {
    let (mut touches, x_mm) = (vec![start], level.along.height_mm(&start.centre));
    let mut walked = 0.0;
    let mut step = how.max_step_mm;
    // A curve longer than this many steps of least length is not a blade's section.
    for _ in 0..200_000 {
        let here = touches[touches.len() - 1];
        // Round the rim the normal leans too: the rim is the cause.
        if level.rim.is_some_and(|r| r.is_near(&here.contact)) {
            return Err(Broken::Rim(here.contact));
        }
        if here.cos_lean(&level.along) < how.min_cos_lean {
            return Err(Broken::Leans(here.contact));
        }
        let next = advance(level, x_mm, &here, &mut step, how).ok_or(Broken::Lost(here.centre))?;
        let moved = (next.centre - here.centre).norm();
        walked += moved;
        let tangent = here.tangent(&level.along);
        if walked > 4.0 * how.max_step_mm && passes(&here.centre, &next.centre, &start.centre, &tangent) {
            return Ok(Ring::new(level.along, touches));
        }
        touches.push(next);
        if walked > 1e5 {
            break;
        }
    }
    Err(Broken::Open(start.centre))
}

/// One step along the ring at height `x_mm`; `step` is the length tried first and, afterwards, the
/// one to try next.
fn advance(level: &LevelSet, x_mm: f64, here: &Touch, step: &mut f64, how: &Tracing) -> Option<Touch> {
    let tangent = here.tangent(&level.along);
    // Over a hub that turns the way leaves the height by the square of a step.
    let at_height = |q: Point| if level.along.round().is_some() { level.along.at(x_mm, &q) } else { q };
    let mut length = step.clamp(how.min_step_mm, how.max_step_mm);
    loop {
        let last_try = length <= how.min_step_mm;
        let reach = if last_try { 4.0 * length } else { length };
        let ahead = at_height(here.centre + tangent * length);
        if let Some(t) = level.touch_in_plane(&ahead, reach) {
            let turn = wrap(t.azimuth(&level.along) - here.azimuth(&level.along)).abs();
            let forward = (t.centre - here.centre).dot(&tangent) > 0.2 * length;
            if forward && (turn <= how.max_turn_rad || last_try) {
                *step = if turn < 0.4 * how.max_turn_rad { 1.6 * length } else { length };
                return Some(t);
            }
            if last_try && !forward {
                return turn_corner(level, here, &t, &ahead);
            }
        } else if last_try {
            return None;
        }
        length = (0.5 * length).max(how.min_step_mm);
    }
}

/// In a concave corner of a right angle or more, no step along one wall leads on: the ball touches
/// both walls, and the way on is along the second, the one that a step along the first would cut
/// into.
fn turn_corner(level: &LevelSet, here: &Touch, there: &Touch, into_wall: &Point) -> Option<Touch> {
    let second = level.part.closest(into_wall, 2.0 * level.radius_mm)?;
    let normal = (there.centre - second.point).try_normalize(1e-9)?;
    let touch = Touch { centre: there.centre, contact: second.point, normal, face: second.face };
    // A corner turns the normal back; anything else is a place where the curve cannot be followed.
    let turn = wrap(touch.azimuth(&level.along) - here.azimuth(&level.along));
    let touches = (second.point - there.centre).norm() <= level.radius_mm * (1.0 + 1e-3);
    (turn < -0.05 && touches).then_some(touch)
}

/// The step from `a` to `b` passes the ring's start.
fn passes(a: &Point, b: &Point, start: &Point, tangent: &Vector) -> bool {
    let d = b - a;
    let f = (start - a).dot(&d) / d.norm_squared().max(1e-300);
    (0.0..=1.0).contains(&f) && (start - (a + d * f)).norm() <= 0.5 * d.norm() && (start - a).dot(tangent) >= 0.0
}
