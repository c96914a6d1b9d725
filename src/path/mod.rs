//! Cutter locations: one continuous helix of ball centres round the airfoil.
//!
//! In: a [`Blade`] and [`PathOptions`]. Out: a [`Toolpath`].
//!
//! ## Method
//! The centre of a ball that touches the part without cutting into it lies on the `R` level set of the distance to
//! the whole part: airfoil, fillet and platform alike. *Rings* are that set's closed curves at constant height
//! (`ring`). From ring to ring the pitch is as large as the scallop allows at the worst place of the turn, the scallop
//! being measured on the part (`stepover`), not derived from curvature. The helix runs from each ring to the next:
//! turn `k` at the fraction `u` of the way round lies at the height `(1 − u) x_k + u x_{k+1}`, and every one of its
//! locations is brought onto the level set again, so the rings only guide it.
//! It runs down from the airfoil towards the platform, counter-clockwise seen from the tip.
//!
//! Turns begin at a *base point*, the concave–convex altered point where the path enters the greatest concave stretch
//! (Section 2.1 of the paper on S–θ re-scheduling for four-axis blade milling); on a convex airfoil, at the point
//! furthest along `y`.
//!
//! ## Guarantees
//! Every location is within 1e-6 mm of the level set. The straight move between two locations stays within
//! `chord_mm` of it, measured at its middle and, where it is long, at its quarters. The scallop between turns, measured at
//! every location, is in [`Toolpath::planned_scallop_mm`] (on a mesh the 99th percentile).
//!
//! ## Limits
//! Turns at (nearly) constant height leave too much where a wall leans over: the helix ends where the lean exceeds
//! [`PathOptions::max_lean_rad`]. The scallop is at or under the limit everywhere, not constant along a turn.

mod helix;
mod level;
mod options;
mod ring;
mod rings;
mod seed;
mod stepover;
#[cfg(test)]
mod tests;

pub use options::PathOptions;
pub use stepover::flat_stepover_mm;

use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::observe::Observer;
use level::LevelSet;

/// Lays the helix.
///
/// # Errors
/// Kind `Usage` for options out of their limits; kind `Infeasible` where no ball of this radius goes round the airfoil,
/// with the place; kind `Cancelled`.
pub fn plan(blade: &Blade, options: &PathOptions, observer: &dyn Observer) -> Result<Toolpath> {
    validate(blade, options)?;
    let level = LevelSet { part: &blade.part, radius_mm: options.radius_mm };
    let start_x = start_height(blade, options);
    // The pitch varies from turn to turn and the helix blends neighbours, so a turn may meet more than its own ring pair
    // promised: aim lower, measure the helix itself, and aim lower still at the heights where that was not enough.
    let mut aim = Aim { target_mm: 0.95 * options.scallop_mm, caps: Vec::new() };
    let mut kept = Vec::new();
    let mut best: Option<Toolpath> = None;
    for _ in 0..MOST_AIMS {
        let stack = rings::lay(blade, &level, options, start_x, kept, &aim, observer)?;
        let (path, ridges) = helix::blend(&level, &stack, options, observer)?;
        // Two hundredths are left for what another measure of the same ridge may see.
        let most = 0.98 * options.scallop_mm;
        let high: Vec<usize> = (0..ridges.len()).filter(|&k| ridges[k] > most).collect();
        let enough = path.planned_scallop_mm <= most || high.is_empty();
        if best.as_ref().is_none_or(|b| path.planned_scallop_mm < b.planned_scallop_mm) {
            best = Some(path);
        }
        if enough {
            break;
        }
        for &k in &high {
            let lower = stack.rings[(k + 2).min(stack.rings.len() - 1)].x_mm;
            aim.cap([lower, stack.rings[k].x_mm], (0.95 * options.scallop_mm / ridges[k]).clamp(0.3, 0.97));
        }
        let first = high[0] + 1;
        kept = stack.rings;
        kept.truncate(first);
    }
    best.ok_or_else(|| Error::infeasible(Stage::Path, "no helix was laid"))
}

/// How often the helix is laid anew, closer where its ridges were too high.
const MOST_AIMS: usize = 8;

/// The scallop that the pitch aims at, by height.
struct Aim {
    target_mm: f64,
    /// Heights (lower, upper) and the factor there.
    caps: Vec<([f64; 2], f64)>,
}

impl Aim {
    /// Aims lower by `factor` between two heights, on top of what is asked for there already.
    fn cap(&mut self, heights: [f64; 2], factor: f64) {
        let so_far = self.at(heights) / self.target_mm;
        self.caps.push((heights, factor * so_far));
    }

    /// What to aim at for passes between two heights, mm.
    fn at(&self, [lower, upper]: [f64; 2]) -> f64 {
        let there = self.caps.iter().filter(|([lo, hi], _)| *lo < upper && *hi > lower);
        self.target_mm * there.map(|(_, f)| *f).fold(1.0, f64::min)
    }
}

/// Where the path begins, mm along the blade axis: given, or far enough above the platform for the root region.
///
/// The root region is taken as the lowest 30 % of the airfoil, at least three ball radii and at most 40 mm: what the
/// wide-line operation of the airfoil cannot reach because of the platform.
fn start_height(blade: &Blade, options: &PathOptions) -> f64 {
    let [a, b] = blade.regions.airfoil_x_mm;
    let height = (0.3 * (b - a)).max(3.0 * options.radius_mm).min(40.0).min(0.9 * (b - a));
    options.region_x_mm[0].unwrap_or(a + height)
}

fn validate(blade: &Blade, o: &PathOptions) -> Result<()> {
    let positive = [
        ("tool.radius_mm", o.radius_mm),
        ("path.scallop_mm", o.scallop_mm),
        ("path.chord_mm", o.chord_mm),
        ("path.max_step_mm", o.max_step_mm),
    ];
    for (key, value) in positive {
        if !(value > 0.0 && value.is_finite()) {
            return Err(Error::usage(Stage::Path, format!("{key} is {value}, it must be greater than 0")));
        }
    }
    if o.scallop_mm >= 0.5 * o.radius_mm {
        return Err(Error::usage(
            Stage::Path,
            format!(
                "path.scallop_mm is {}, it must be less than half the ball radius ({} mm)",
                o.scallop_mm, o.radius_mm
            ),
        ));
    }
    let [lo, hi] = blade.regions.part_x_mm;
    for (key, x) in [("region.start_mm", o.region_x_mm[0]), ("region.end_mm", o.region_x_mm[1])] {
        if let Some(x) = x.filter(|x| !(lo..=hi).contains(x)) {
            return Err(Error::usage(
                Stage::Path,
                format!("{key} is {x} mm, outside the part, which spans {lo:.3} to {hi:.3} mm along the blade axis"),
            )
            .advise("choose heights inside the part; `inspect` prints where the airfoil and the platform are"));
        }
    }
    if let [Some(a), Some(b)] = o.region_x_mm
        && b >= a
    {
        return Err(Error::usage(
            Stage::Path,
            format!(
                "region.end_mm ({b} mm) must be below region.start_mm ({a} mm): the helix runs from the airfoil towards the platform"
            ),
        ));
    }
    if let Some(size) = blade.part.mesh.aabb().map(|b| b.max - b.min).filter(|s| s.max() < 2.0 * o.radius_mm) {
        return Err(Error::infeasible(
            Stage::Path,
            format!(
                "the part ({:.3} × {:.3} × {:.3} mm) is smaller than the tool, a ball of {} mm in diameter",
                size.x,
                size.y,
                size.z,
                2.0 * o.radius_mm
            ),
        )
        .advise("take a smaller ball, or check the model's unit with --unit"));
    }
    let [a, b] = blade.regions.airfoil_x_mm;
    if b - a < 0.5 * o.radius_mm {
        return Err(Error::infeasible(
            Stage::Path,
            format!("the airfoil is {:.3} mm high, less than half the ball radius of {} mm: the part is smaller than the tool", b - a, o.radius_mm),
        )
        .advise("take a smaller ball, or check the model's unit with --unit"));
    }
    Ok(())
}

/// A point of the blade frame in words, with its place in the model.
fn place(blade: &Blade, p: &Point) -> String {
    let m = blade.model_from_blade * p;
    format!("height {:.3} mm, model point ({:.3}, {:.3}, {:.3})", p.x, m.x, m.y, m.z)
}
