//! Turns at equal parts of the way from the start to the end of the region.
//!
//! Places round the blade are named by the fraction `u` of the length of a ring. The places of the
//! same name on a stack of rings ([`super::rings`]) make a *meridian*, measured along the surface
//! of ball centres; turn `k` of `n` lies at the part `(k + u)/n` of the meridian `u`. So the way
//! down is shared evenly at each place, and turns draw apart where it is long: the number of turns
//! is the least whose worst ridge is within the scallop, found by laying them, since a ridge falls
//! as the square of the number.

use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use super::ring::Ring;
use super::{chords, helix, rings};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::observe::Observer;
use crate::parallel;

/// How often the number of turns is tried.
const MOST_TRIES: usize = 8;

/// The stack of rings as meridians.
struct Meridians<'a> {
    level: &'a LevelSet<'a>,
    rings: &'a [Ring],
}

impl Meridians<'_> {
    /// The point at the part `share` of the meridian through the fraction `u` of the rings, on
    /// chords between them.
    fn point(&self, u: f64, share: f64) -> Point {
        let points: Vec<Point> = self.rings.iter().map(|r| r.at(u)).collect();
        let whole: f64 = points.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
        let mut left = share.clamp(0.0, 1.0) * whole;
        for w in points.windows(2) {
            let step = (w[1] - w[0]).norm();
            if left <= step {
                return w[0] + (w[1] - w[0]) * (left / step.max(1e-12));
            }
            left -= step;
        }
        points[points.len() - 1]
    }

    /// Length of the longest meridian, of so many, mm.
    fn longest_mm(&self, count: usize) -> f64 {
        let length = |k: usize| {
            let u = k as f64 / count as f64;
            self.rings.windows(2).map(|w| (w[1].at(u) - w[0].at(u)).norm()).sum::<f64>()
        };
        (0..count).map(length).fold(0.0, f64::max)
    }

    /// The touch of turn `k` of `n` at the fraction `u` of the way round.
    fn touch(&self, k: usize, n: usize, u: f64) -> Result<Touch> {
        let guess = self.point(u, (k as f64 + u) / n as f64);
        let reach = 0.25 * self.level.radius_mm;
        self.level.touch_in_plane(&guess, reach).ok_or_else(|| {
            Error::infeasible(
                Stage::Path,
                format!(
                    "between two rings a ball of radius {} mm loses the airfoil near (x {:.3}, y {:.3}, z {:.3}) of the blade frame",
                    self.level.radius_mm, guess.x, guess.y, guess.z
                ),
                super::loses_surface(self.level.radius_mm, &[guess]),
            )
            .advise("take a smaller ball or end the region higher")
        })
    }
}

/// Lays the helix from the height `start_x` down.
pub(super) fn plan(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let first = rings::first_ring(blade, level, options, start_x, &rings::tracing(options))?;
    let aim = rings::Aim::new(options.settings.scallop_mm);
    let stack = rings::lay(blade, level, options, vec![first], &aim, observer)?;
    let meridians = Meridians { level, rings: &stack.rings };
    let ends = [stack.rings[0].x_mm, stack.rings[stack.rings.len() - 1].x_mm];
    let perimeter = stack.rings.iter().map(|r| r.length_mm).fold(0.0, f64::max);
    let flat = options.flat_mm(options.settings.scallop_mm);
    // Two hundredths are left for what another measure of the same ridge may see.
    let most = 0.98 * options.settings.scallop_mm;
    let mut n = ((meridians.longest_mm(360) / flat).ceil() as usize).max(1);
    let (mut too_few, mut best): (usize, Option<(usize, Toolpath)>) = (0, None);
    for _ in 0..MOST_TRIES {
        let steps = (perimeter / options.settings.max_step_mm).ceil().max(8.0) as usize;
        let places: Vec<f64> = (0..=steps).map(|i| i as f64 / steps as f64).collect();
        let turns: Vec<Vec<Touch>> = parallel::try_map(0..n, |k| {
            observer.check(Stage::Path)?;
            chords::fill(level, |u| meridians.touch(k, n, u), &places, options)
        })?;
        let end = meridians.touch(n - 1, n, 1.0)?;
        let (path, _) = helix::assemble(level, options, &turns, end, ends, stack.end_reason.clone());
        let ridge = path.planned_scallop_mm;
        let wanted = ((n as f64) * (ridge / most).sqrt()).ceil() as usize;
        if ridge <= most {
            let good = wanted >= n || n <= too_few + 1;
            best = Some((n, path));
            if good {
                break;
            }
            n = wanted.clamp(too_few + 1, n - 1);
        } else {
            too_few = too_few.max(n);
            match &best {
                Some((b, _)) if *b <= n + 1 => break,
                Some((b, _)) => n = wanted.clamp(n + 1, b - 1),
                None => n = wanted.max(n + 1),
            }
        }
    }
    best.map(|(_, path)| path).ok_or_else(|| {
        let since = Infeasible::ScallopNotReached { turns: n, scallop_mm: options.settings.scallop_mm };
        Error::infeasible(Stage::Path, format!("{n} turns in equal parts leave more than the scallop still"), since)
            .advise("end the region higher, or take path.kind = \"constant-scallop\"")
    })
}
