//! Locations along a curve of touches, as many as the chord tolerance asks for.

use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::triangle::closest_on_segment;

/// Halvings of the first spacing before a corner is taken as it is.
const MOST_HALVINGS: u32 = 10;

/// In a hollow chords lie off the part and leave ridges higher than asked for; so much of the
/// tolerance may they do that. Round the part they make ridges lower.
const IN_HOLLOWS: f64 = 0.25;
/// Where the contact goes so many times as far as the ball, it is a hollow edge or hardly rounder
/// than the ball: the path turns there at once, and the nearer it is followed the slower.
const EDGE: f64 = 2.0;

/// How far the chord between two touches may lie off the curve, mm.
pub fn tolerance_mm(level: &LevelSet, a: &Touch, b: &Touch, options: &PathOptions) -> f64 {
    let way = b.centre - a.centre;
    let is_hollow = (b.normal - a.normal).dot(&way) < 0.0;
    let is_edge = level.is_over_facets() || (b.contact - a.contact).norm() > EDGE * way.norm();
    if is_hollow && !is_edge { IN_HOLLOWS * options.chord_mm() } else { options.chord_mm() }
}

/// A curve of touches and the tolerance of its chords.
struct Chords<'a, F> {
    level: &'a LevelSet<'a>,
    at: F,
    options: &'a PathOptions,
}

/// Touches at the places given, which grow, the last one left out, and between them as many as keep
/// the chords within [`PathOptions::chord_mm`] of the curve `at` of touches with `level`.
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
        // No convex bend of the path is tighter than the ball: so short a chord is within the
        // tolerance as it is.
        let safe = length * length <= 8.0 * self.options.radius_mm * self.options.chord_mm();
        if safe && depth >= MOST_HALVINGS || depth >= 2 * MOST_HALVINGS {
            return Ok(());
        }
        let u = 0.5 * (l.0 + r.0);
        let mid = (self.at)(u)?;
        let off = (mid.centre - closest_on_segment(&l.1.centre, &r.1.centre, &mid.centre)).norm();
        // A long chord over facets may leave the path at its quarters and meet it again in the
        // middle.
        let quarter = |f: f64| self.leaves(&(l.1.centre + (r.1.centre - l.1.centre) * f));
        let split =
            off > tolerance_mm(self.level, l.1, r.1, self.options) || (!safe && (quarter(0.25) || quarter(0.75)));
        if split {
            self.refine(l, (u, &mid), depth + 1, out)?;
            out.push(mid);
            self.refine((u, &mid), r, depth + 1, out)?;
        }
        Ok(())
    }
    /// A place on a chord is further from the surface of ball centres than the tolerance. One
    /// closest point is enough: where the curve is there does not matter.
    fn leaves(&self, q: &Point) -> bool {
        let (radius_mm, chord_mm) = (self.options.radius_mm, self.options.chord_mm());
        let near = self.level.part.closest(q, radius_mm + 2.0 * chord_mm);
        near.is_none_or(|c| (c.distance_mm - radius_mm).abs() > chord_mm)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::curve::{LevelCurve, tangents};
    use super::*;
    use crate::artifact::along::Along;
    use crate::geometry::allowance::Allowed;
    use crate::geometry::brep::{Brep, Face, SurfaceKind};
    use crate::geometry::nurbs::shapes::cylinder;
    use crate::geometry::part::Part;
    use crate::observe::Silent;

    #[test]
    fn chords_in_a_hollow_have_a_quarter_of_the_tolerance() {
        let options = PathOptions::new(3.0, 0.01).with(|s| (s.max_step_mm, s.chord_mm) = (10.0, 0.001));
        // Round a wall, within it, and within one that is hardly rounder than the ball.
        for (wall_mm, r, most_mm) in [(20.0, 23.0f64, 0.001), (20.0, 17.0, 0.00025), (5.0, 2.0, 0.001)] {
            let face = Face {
                name: "wall".into(),
                kind: SurfaceKind::Cylinder,
                surface: cylinder(wall_mm, 40.0),
                reversed: false,
                loops: vec![],
            };
            let part = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.01, &Silent).unwrap();
            let level = LevelSet {
                part: Allowed::new(&part, 0.0),
                along: Along::BLADE,
                radius_mm: 3.0,
                inclined: None,
                rim: None,
                lowest_mm: f64::NEG_INFINITY,
            };
            let on_circle = |k: u32| {
                let (s, c) = (f64::from(k) * 0.1).sin_cos();
                level.touch(&Point::new(r * c, r * s, 20.0), 1.0).unwrap()
            };
            let touches: Vec<Touch> = (0..=20).map(on_circle).collect();
            let curve = LevelCurve { level: &level, touches: &touches, tangents: tangents(None, &touches, None) };
            let filled = fill(&level, |u| curve.at(u), &curve.places(&options), &options).unwrap();
            let off =
                |w: &[Touch]| (nalgebra::center(&w[0].centre, &w[1].centre) - Point::new(0.0, 0.0, 20.0)).norm() - r;
            let worst = filled.windows(2).map(|w| off(w).abs()).fold(0.0, f64::max);
            assert!((0.5 * most_mm..=most_mm).contains(&worst), "{r}: {worst}");
        }
    }
}
