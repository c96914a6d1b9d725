//! A smooth curve through touches, on the level set, and places along it.

use super::chords;
use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use crate::artifact::along::Along;
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};

/// A curve on the level set through touches: between two of them a cubic with their tangents,
/// brought onto the level set across its own direction. A place along it is the number of the touch
/// before it plus the share of the way to the next.
pub struct LevelCurve<'a> {
    /// The level set.
    pub level: &'a LevelSet<'a>,
    /// At least two.
    pub touches: &'a [Touch],
    /// Unit directions at the touches.
    pub tangents: Vec<Vector>,
}

/// Arc lengths of a polyline at its points, mm.
pub fn arc_lengths<'p>(points: impl Iterator<Item = &'p Point>) -> Vec<f64> {
    let (mut s, mut last) = (0.0, None);
    let length = |p: &'p Point| {
        s += last.replace(p).map_or(0.0, |before| (p - before).norm());
        s
    };
    points.map(length).collect()
}

/// Unit directions of the curve through touches, given those before the first and after the last
/// where there are any: those of the parabola through three neighbours, within the tangent plane of
/// the level set.
pub fn tangents(before: Option<&Point>, touches: &[Touch], after: Option<&Point>) -> Vec<Vector> {
    let n = touches.len();
    let centre = |i: usize| &touches[i].centre;
    (0..n)
        .map(|i| {
            let previous = if i > 0 { Some(centre(i - 1)) } else { before };
            let next = if i + 1 < n { Some(centre(i + 1)) } else { after };
            tangent(previous, &touches[i], next)
        })
        .collect()
}

/// Unit direction of the curve at a touch between two neighbours; where they are in one place, any
/// in the tangent plane.
pub fn tangent(before: Option<&Point>, at: &Touch, after: Option<&Point>) -> Vector {
    let back = before.map(|p| at.centre - p);
    let ahead = after.map(|p| p - at.centre);
    let direction = match (back, ahead) {
        (Some(b), Some(a)) => {
            let (lb, la) = (b.norm().max(1e-12), a.norm().max(1e-12));
            b * (la / lb) + a * (lb / la)
        }
        (Some(d), None) | (None, Some(d)) => d,
        (None, None) => at.tangent(&Along::BLADE),
    };
    let flat = direction - at.normal * direction.dot(&at.normal);
    flat.try_normalize(1e-12).unwrap_or_else(|| at.tangent(&Along::BLADE))
}

/// The point of a cubic between two with these tangents, at the share `f` of the way.
pub fn cubic([a, b]: [&Point; 2], [m0, m1]: [Vector; 2], f: f64) -> Point {
    let g = 1.0 - f;
    a + (b - a) * (f * f * (3.0 - 2.0 * f)) + m0 * (f * g * g) - m1 * (f * f * g)
}

impl LevelCurve<'_> {
    /// The touch at a place.
    ///
    /// # Errors
    /// `Infeasible` where the ball loses the surface.
    pub fn at(&self, place: f64) -> Result<Touch> {
        let i = (place.max(0.0).floor() as usize).min(self.touches.len().saturating_sub(2));
        let f = (place - i as f64).clamp(0.0, 1.0);
        if f == 0.0 {
            return Ok(self.touches[i]);
        }
        if f == 1.0 {
            return Ok(self.touches[i + 1]);
        }
        self.between(i, f).ok_or_else(|| {
            let (a, b) = (&self.touches[i].centre, &self.touches[i + 1].centre);
            Error::infeasible(
                Stage::Path,
                format!(
                    "a ball of radius {} mm loses the surface between ({:.3}, {:.3}, {:.3}) and ({:.3}, {:.3}, {:.3}) of the blade frame",
                    self.level.radius_mm, a.x, a.y, a.z, b.x, b.y, b.z
                ),
                super::loses_surface(self.level.radius_mm, &[*a, *b]),
            )
            .advise("take a smaller ball or end the region higher")
        })
    }

    /// The touch at the share `f` of the way from touch `i` to the next.
    pub fn between(&self, i: usize, f: f64) -> Option<Touch> {
        let (a, b) = (self.touches.get(i)?, self.touches.get(i + 1)?);
        let chord = b.centre - a.centre;
        let length = chord.norm();
        if length < 1e-9 {
            return Some(*a);
        }
        let (m0, m1) = (self.tangents[i] * length, self.tangents[i + 1] * length);
        let g = 1.0 - f;
        let guess = cubic([&a.centre, &b.centre], [m0, m1], f);
        let along = chord * (6.0 * f * g) + m0 * (g * (g - 2.0 * f)) + m1 * (f * (f - 2.0 * g));
        let reach = 0.5 * length + 0.01 * self.level.radius_mm;
        let touch = along
            .try_normalize(1e-12)
            .and_then(|t| self.level.touch_across(&guess, &t, reach))
            .or_else(|| self.level.touch(&(a.centre + chord * f), reach))?;
        // Through places at the region's end, and others that are held up above it, a smooth curve
        // swings beyond it.
        let LevelSet { along, lowest_mm, .. } = self.level;
        let swings = along.height_mm(&touch.centre) < *lowest_mm;
        let at_end = || self.level.touch_in_plane(&along.at(*lowest_mm, &touch.centre), reach);
        swings.then(at_end).flatten().or(Some(touch))
    }

    /// Places evenly shared, from the first touch to the last: near enough for the chord tolerance
    /// where the curve bends, and nowhere farther apart than the greatest step.
    pub fn places(&self, options: &PathOptions) -> Vec<f64> {
        let pieces = self.touches.len() - 1;
        let mut steps = Vec::with_capacity(pieces + 1);
        let mut total = 0.0;
        steps.push(0.0);
        for i in 0..pieces {
            let length = (self.touches[i + 1].centre - self.touches[i].centre).norm();
            let bend = self.tangents[i].angle(&self.tangents[i + 1]);
            let chord_mm = chords::tolerance_mm(self.level, &self.touches[i], &self.touches[i + 1], options);
            // The sagitta of a chord `c` where the curve turns by `bend` over `length` is c² bend /
            // (8 length).
            let bent = (0.9 * 8.0 * chord_mm * length / bend.max(1e-9)).sqrt();
            total += length / bent.min(options.settings.max_step_mm).max(1e-9);
            steps.push(total);
        }
        let count = total.ceil().max(1.0) as usize;
        let mut i = 0;
        let mut places: Vec<f64> = (0..=count)
            .map(|k| {
                let wanted = total * k as f64 / count as f64;
                while i + 1 < pieces && steps[i + 1] < wanted {
                    i += 1;
                }
                let width = steps[i + 1] - steps[i];
                i as f64 + if width > 0.0 { ((wanted - steps[i]) / width).clamp(0.0, 1.0) } else { 0.0 }
            })
            .collect();
        if let Some(last) = places.last_mut() {
            *last = pieces as f64;
        }
        places
    }
}
