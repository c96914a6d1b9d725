//! The helix through the rings: locations by chord tolerance, each on the level set.

use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use super::ring::Ring;
use super::rings::Stack;
use super::stepover::{Pass, decisive_mm, ridge_height};
use super::{chords, curve};
use crate::artifact::Cones;
use crate::artifact::toolpath::{CutterLocation, Toolpath, Turn};
use crate::error::{EndReason, Error, Result, Stage};
use crate::geometry::triangle::closest_on_segment;
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;

/// One turn, from ring `a` to ring `b`.
struct Blend<'a> {
    level: &'a LevelSet<'a>,
    a: &'a Ring,
    b: &'a Ring,
    options: &'a PathOptions,
}

impl Blend<'_> {
    /// The touch at the fraction `u` of the turn.
    fn at(&self, u: f64) -> Result<Touch> {
        let (p, q) = (self.a.at(u), self.b.at(u));
        let guess = self.level.along.at(self.a.x_mm + (self.b.x_mm - self.a.x_mm) * u, &(p + (q - p) * u));
        let reach = (q - p).norm() + 0.25 * self.level.radius_mm;
        self.level.touch_in_plane(&guess, reach).ok_or_else(|| {
            Error::infeasible(
                Stage::Path,
                format!(
                    "between the turns at {:.3} and {:.3} mm a ball of radius {} mm loses the airfoil near (x {:.3}, y {:.3}, z {:.3}) of the blade frame",
                    self.a.x_mm, self.b.x_mm, self.level.radius_mm, guess.x, guess.y, guess.z
                ),
                super::loses_surface(self.level.radius_mm, &[guess]),
            )
            .advise("take a smaller ball or end the region higher")
        })
    }

    /// Touches of the turn from `u = 0` up to, not including, `u = 1`.
    fn touches(&self) -> Result<Vec<Touch>> {
        let n = (self.a.length_mm.max(self.b.length_mm) / self.options.settings.max_step_mm).ceil().max(8.0) as usize;
        let places: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
        chords::fill(self.level, |u| self.at(u), &places, self.options)
    }
}

/// The locations of one ring by itself.
pub fn closed(level: &LevelSet, ring: &Ring, options: &PathOptions) -> Result<Vec<CutterLocation>> {
    let touches = Blend { level, a: ring, b: ring, options }.touches()?;
    let Some(first) = touches.first().copied() else { return Ok(Vec::new()) };
    let (_, mut locations) = number(&[touches], first);
    locations.pop();
    Ok(locations)
}

/// Makes the helix through at least two rings; also the decisive ridge between each turn and the
/// next, mm.
pub fn blend(
    level: &LevelSet,
    stack: &Stack,
    options: &PathOptions,
    observer: &dyn Observer,
) -> Result<(Toolpath, Vec<f64>)> {
    let rings = &stack.rings;
    let done = std::sync::atomic::AtomicUsize::new(0);
    let pairs = rings.len() - 1;
    let turns: Vec<Vec<Touch>> = parallel::try_map(0..pairs, |k| {
        observer.check(Stage::Path)?;
        let touches = Blend { level, a: &rings[k], b: &rings[k + 1], options }.touches()?;
        let n = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
        observer.progress(Stage::Path, 1000 + 1000 * n / pairs, 2000);
        Ok(touches)
    })?;
    let end = Blend { level, a: &rings[pairs - 1], b: &rings[pairs], options }.at(1.0)?;
    let region_x_mm = [rings[0].x_mm, rings[pairs].x_mm];
    let (path, ridges) = assemble(level, options, &turns, end, region_x_mm, stack.end_reason.clone());
    Ok((path, ridges.into_iter().map(|r| decisive_mm(level, r)).collect()))
}

/// The toolpath of finished turns, each without the touch that the next begins with, and the ridges
/// between each turn and the next, mm.
pub fn assemble(
    level: &LevelSet,
    options: &PathOptions,
    turns: &[Vec<Touch>],
    end: Touch,
    region_x_mm: [f64; 2],
    end_reason: EndReason,
) -> (Toolpath, Vec<Vec<f64>>) {
    let ridges = ridges(level, turns);
    let planned_scallop_mm = decisive_mm(level, ridges.concat());
    let (turns, locations) = number(turns, end);
    let path = Toolpath {
        kind: options.settings.kind,
        radius_mm: options.radius_mm,
        disc_radius_mm: 0.0,
        stock_mm: options.settings.stock_mm,
        scallop_mm: options.settings.scallop_mm,
        chord_mm: options.settings.chord_mm,
        region_x_mm,
        end_reason,
        planned_scallop_mm,
        cones: Cones::about_blade(options.lean_rad),
        axis_turning: None,
        turns,
        locations,
    };
    (path, ridges)
}

/// Arc lengths and turn numbers; the path's last touch closes the last turn.
pub(super) fn number(turns: &[Vec<Touch>], end: Touch) -> (Vec<Turn>, Vec<CutterLocation>) {
    let mut locations: Vec<CutterLocation> = Vec::with_capacity(turns.iter().map(Vec::len).sum::<usize>() + 1);
    let mut heads = Vec::with_capacity(turns.len());
    let mut s = 0.0;
    for (k, touches) in turns.iter().enumerate() {
        let first = locations.len();
        let mut base = 0.0;
        let closing = (k + 1 == turns.len()).then_some(&end);
        for (i, t) in touches.iter().chain(closing).enumerate() {
            if let Some(last) = locations.last() {
                s += (t.centre - last.centre).norm();
            }
            if i == 0 {
                base = s;
            }
            locations.push(CutterLocation {
                turn: k as u32,
                turn_s_mm: s - base,
                s_mm: s,
                centre: t.centre,
                contact: t.contact,
                normal: t.normal,
            });
        }
        heads.push(Turn { first, count: locations.len() - first, length_mm: 0.0 });
    }
    for k in 0..heads.len() {
        let from = locations[heads[k].first].s_mm;
        let to = heads.get(k + 1).map_or(s, |n| locations[n.first].s_mm);
        heads[k].length_mm = to - from;
    }
    (heads, locations)
}

/// The scallop between each turn and the next, measured at each location, mm.
fn ridges(level: &LevelSet, turns: &[Vec<Touch>]) -> Vec<Vec<f64>> {
    parallel::map(1..turns.len(), |k| {
        let (upper, lower) = (&turns[k - 1], &turns[k]);
        let s_mm = curve::arc_lengths(lower.iter().map(|t| &t.centre));
        let mut at = 0usize;
        let ways = curve::tangents(None, upper, None);
        let ridge = |(t, way): (&Touch, &Vector)| {
            let near = nearest_between_ends(lower, &s_mm, &t.centre, &mut at)?;
            // Off the chord and onto the level set, as for the rings.
            let on_level = level.touch(&near, 0.1 * level.radius_mm)?;
            let beside = lower[at + 1].centre - lower[at].centre;
            ridge_height(level, [&Pass::new(level, t, way), &Pass::new(level, &on_level, &beside)])
        };
        upper.iter().zip(&ways).filter_map(ridge).collect()
    })
}

/// The nearest point of an open polyline of centres with these arc lengths; `at` is the segment of
/// the last answer, and of this. `None` where it is an end of the polyline: the path goes on there,
/// its nearest place is on another turn.
fn nearest_between_ends(turn: &[Touch], s_mm: &[f64], q: &Point, at: &mut usize) -> Option<Point> {
    let (first, last) = (turn.first()?.centre, turn.last()?.centre);
    let on = |i: usize| closest_on_segment(&turn[i].centre, &turn[i + 1].centre, q);
    let mut nearest = if *at + 1 < turn.len() { on(*at) } else { first };
    let mut i = 0;
    while i + 1 < turn.len() {
        let here = on(i);
        if (q - here).norm() < (q - nearest).norm() {
            (*at, nearest) = (i, here);
        }
        // Farther on by an arc length the polyline is nearer by no more than that.
        let free_mm = (q - turn[i + 1].centre).norm() - (q - nearest).norm();
        i = s_mm.partition_point(|s| *s <= s_mm[i + 1] + free_mm).max(i + 2) - 1;
    }
    (nearest != first && nearest != last).then_some(nearest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::geometry::triangle::share_of_segment;

    #[test]
    fn the_nearest_place_is_that_of_all_segments_wherever_the_last_was() {
        // A spiral with tongues: places that are near one another are far apart along it.
        let at = |k: usize| {
            let a = 0.02 * k as f64;
            let r = 10.0 + 0.3 * a + 2.0 * (40.0 * a).sin();
            Point::new(r * a.cos(), r * a.sin(), 0.1 * a)
        };
        let touch = |centre: Point| Touch { centre, contact: centre, normal: Vector::z(), face: 0 };
        let turn: Vec<Touch> = (0..700).map(|k| touch(at(k))).collect();
        let s_mm = curve::arc_lengths(turn.iter().map(|t| &t.centre));
        let mut last = 0;
        for k in 0..500usize {
            let (a, r) = (2.4 * k as f64, 15.0 * ((k * k % 97) as f64 / 97.0));
            let q = Point::new(r * a.cos(), r * a.sin(), 0.3);
            let away = |i: usize, f: f64| (turn[i].centre + (turn[i + 1].centre - turn[i].centre) * f - q).norm();
            let all = (0..turn.len() - 1).map(|i| {
                let f = share_of_segment(&turn[i].centre, &turn[i + 1].centre, &q);
                (away(i, f), i, f)
            });
            let (away_mm, i, f) = all.fold((f64::INFINITY, 0, 0.0), |best, x| if x.0 < best.0 { x } else { best });
            let is_end = i == 0 && f <= 0.0 || i + 2 == turn.len() && f >= 1.0;
            let found = nearest_between_ends(&turn, &s_mm, &q, &mut last);
            assert_eq!(found.is_none(), is_end, "{q}");
            assert!(found.is_none_or(|p| ((p - q).norm() - away_mm).abs() < 1e-12), "{q}: {found:?}, {away_mm} mm");
        }
    }
}
