//! A smooth curve through balls, and the feet of places on it.

use super::super::curve::tangents;
use super::super::level::Touch;
use crate::geometry::{Point, Vector};

/// Segments to either side of the last foot that a new one is sought in.
const NEAR: usize = 6;

/// A curve of cubics through balls.
pub struct Curve {
    pub touches: Vec<Touch>,
    tangents: Vec<Vector>,
    is_closed: bool,
}

/// A place of a curve: the number of the ball before it and the share of the way to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub number: usize,
    pub share: f64,
}

impl Curve {
    /// The curve; a closed one does not repeat its first ball.
    pub fn new(touches: Vec<Touch>, is_closed: bool) -> Curve {
        let (before, after) = match (&touches[..], is_closed) {
            ([first, .., last], true) => (Some(last.centre), Some(first.centre)),
            _ => (None, None),
        };
        let tangents = tangents(before.as_ref(), &touches, after.as_ref());
        Curve { touches, tangents, is_closed }
    }

    fn segments(&self) -> usize {
        if self.is_closed { self.touches.len() } else { self.touches.len().saturating_sub(1) }
    }

    fn ends(&self, i: usize) -> [usize; 2] {
        [i, (i + 1) % self.touches.len()]
    }

    /// Place and derivative by the share.
    fn along(&self, at: Place) -> (Point, Vector) {
        let [i, j] = self.ends(at.number);
        let (a, b) = (self.touches[i].centre, self.touches[j].centre);
        let length = (b - a).norm();
        let (ta, tb) = (self.tangents[i] * length, self.tangents[j] * length);
        let f = at.share;
        let (f2, f3) = (f * f, f * f * f);
        let p = a.coords * (2.0 * f3 - 3.0 * f2 + 1.0)
            + ta * (f3 - 2.0 * f2 + f)
            + b.coords * (3.0 * f2 - 2.0 * f3)
            + tb * (f3 - f2);
        let d = (a - b) * (6.0 * f2 - 6.0 * f) + ta * (3.0 * f2 - 4.0 * f + 1.0) + tb * (3.0 * f2 - 2.0 * f);
        (Point::from(p), d)
    }

    pub fn point(&self, at: Place) -> Point {
        self.along(at).0
    }

    /// The nearest place of the curve.
    pub fn nearest(&self, q: &Point) -> Option<Place> {
        self.nearest_of(q, 0..self.segments())
    }

    /// The nearest place between two shares of the segments.
    pub fn nearest_within(&self, q: &Point, shares: [f64; 2]) -> Option<Place> {
        let n = self.segments();
        let [from, to] = shares.map(|s| (s.clamp(0.0, 1.0) * n as f64) as usize);
        self.nearest_of(q, from..to.max(from + 1).min(n))
    }

    /// The nearest place near another.
    pub fn nearest_about(&self, q: &Point, near: Place) -> Option<Place> {
        let n = self.segments();
        if self.is_closed && n > 2 * NEAR {
            return self.nearest_of(q, (near.number + n - NEAR..=near.number + n + NEAR).map(|i| i % n));
        }
        self.nearest_of(q, near.number.saturating_sub(NEAR)..(near.number + NEAR + 1).min(n))
    }

    fn nearest_of(&self, q: &Point, segments: impl Iterator<Item = usize>) -> Option<Place> {
        let mut best: Option<(f64, Place)> = None;
        for number in segments {
            let [i, j] = self.ends(number);
            let a = self.touches[i].centre;
            let way = self.touches[j].centre - a;
            let share = ((q - a).dot(&way) / way.norm_squared().max(1e-300)).clamp(0.0, 1.0);
            let off = (q - (a + way * share)).norm_squared();
            if best.is_none_or(|b| off < b.0) {
                best = Some((off, Place { number, share }));
            }
        }
        let (_, mut at) = best?;
        for _ in 0..2 {
            let (p, d) = self.along(at);
            at.share = (at.share + (q - p).dot(&d) / d.norm_squared().max(1e-300)).clamp(0.0, 1.0);
        }
        Some(at)
    }

    /// The last place of an open curve.
    pub fn last(&self) -> Option<Place> {
        Some(Place { number: self.segments().checked_sub(1)?, share: 1.0 })
    }

    /// The nearest point of the curve.
    pub fn foot(&self, q: &Point) -> Option<Point> {
        Some(self.point(self.nearest(q)?))
    }

    /// A value that is known at the balls, at a place.
    pub fn value(&self, of: &[f64], at: Place) -> f64 {
        let [i, j] = self.ends(at.number);
        of[i] + (of[j] - of[i]) * at.share
    }
}
