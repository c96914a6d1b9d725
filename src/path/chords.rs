//! Locations along a curve of touches, as many as the chord tolerance asks for.

use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::triangle::closest_on_segment;

/// Halvings of the first spacing before a corner is taken as it is.
const MOST_HALVINGS: u32 = 10;

/// A curve of touches and the tolerance of its chords.
struct Chords<'a, F> {
    level: &'a LevelSet<'a>,
    at: F,
    options: &'a PathOptions,
}

/// Touches at the places given, which grow, the last one left out, and between them as many as keep the chords within
/// [`PathOptions::chord_mm`] of the curve `at` of touches with `level`.
///
/// # Errors
/// Those of `at`.
pub fn fill(
    level: &LevelSet,
    at: impl Fn(f64) -> Result<Touch>,
    places: &[f64],
    options: &PathOptions,
) -> Result<Vec<Touch>> {
    let Some(first) = places.first() else { return Ok(Vec::new()) };
    let chords = Chords { level, at, options };
    let mut out = Vec::with_capacity(2 * places.len());
    let mut left = (chords.at)(*first)?;
    for w in places.windows(2) {
        let right = (chords.at)(w[1])?;
        out.push(left);
        chords.refine((w[0], &left), (w[1], &right), 0, &mut out)?;
        left = right;
    }
    Ok(out)
}

impl<F: Fn(f64) -> Result<Touch>> Chords<'_, F> {
    /// Adds touches strictly between two.
    fn refine(&self, l: (f64, &Touch), r: (f64, &Touch), depth: u32, out: &mut Vec<Touch>) -> Result<()> {
        let length = (r.1.centre - l.1.centre).norm();
        // No convex bend of the path is tighter than the ball: so short a chord is within the tolerance as it is.
        let safe = length * length <= 8.0 * self.options.radius_mm * self.options.chord_mm;
        if safe && depth >= MOST_HALVINGS || depth >= 2 * MOST_HALVINGS {
            return Ok(());
        }
        let u = 0.5 * (l.0 + r.0);
        let mid = (self.at)(u)?;
        let off = (mid.centre - closest_on_segment(&l.1.centre, &r.1.centre, &mid.centre)).norm();
        // A long chord over facets may leave the path at its quarters and meet it again in the middle.
        let quarter = |f: f64| self.leaves(&(l.1.centre + (r.1.centre - l.1.centre) * f));
        let split = off > self.options.chord_mm || (!safe && (quarter(0.25) || quarter(0.75)));
        if split {
            self.refine(l, (u, &mid), depth + 1, out)?;
            out.push(mid);
            self.refine((u, &mid), r, depth + 1, out)?;
        }
        Ok(())
    }
    /// A place on a chord is further from the surface of ball centres than the tolerance. One closest point tells: where the curve is there is
    /// not asked.
    fn leaves(&self, q: &Point) -> bool {
        let (radius_mm, chord_mm) = (self.options.radius_mm, self.options.chord_mm);
        let near = self.level.part.closest(q, radius_mm + 2.0 * chord_mm);
        near.is_none_or(|c| (c.distance_mm - radius_mm).abs() > chord_mm)
    }
}
