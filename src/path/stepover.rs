//! The scallop between two neighbouring passes, measured on the part itself.
//!
//! A ball between two passes, on the level set like them, would touch the part at a contact point `p` with normal `n`. What
//! the two passes leave standing there is the height at which the ray from `p` along `n` enters one of their balls, and the
//! ridge is where both leave the same. On a part of constant curvature across the passes this is the cusp of the two-ball construction,
//! `h = |ρ cos α ∓ √(R² − ρ² sin² α) − r|`, `sin α = d/2ρ`; measured on the part it needs no curvature, so it holds on
//! meshes, creases and saddles alike, and what no ball of this radius can reach (sharp inner corners) does not count.

use super::level::LevelSet;
use crate::geometry::{Point, Vector};

/// Halvings of the doubt about where the ridge is highest.
const RIDGE_STEPS: usize = 3;
/// The ridge's place is known well enough within this share of the stepover: its height is flat there to a few per cent.
const RIDGE_PLACE: f64 = 0.02;

/// Height of the ridge between two balls of the level set over the part, mm; infinite where neither reaches over the
/// contact between them, `None` where there is no ball of the level set between them.
///
/// The ridge is where both balls leave the same height. That is midway only where the curvature across the passes does
/// not change, and much nearer to one of them where a wall runs into a fillet: each height grows about as the square of the
/// way from its own pass, which tells where to look next. Every place looked at is on the part, so the greatest height
/// found is left there indeed.
pub fn ridge_height(level: &LevelSet, a: &Point, b: &Point) -> Option<f64> {
    let reach = 0.5 * (b - a).norm() + 0.02 * level.radius_mm;
    let mut share = 0.5;
    let mut ridge: Option<f64> = None;
    for _ in 0..RIDGE_STEPS {
        let Some(between) = level.touch_in_plane(&(a + (b - a) * share), reach) else { break };
        let leaves = |c: &Point| ray_into_ball(&between.contact, &between.normal, c, level.radius_mm);
        let (of_a, of_b) = (leaves(a), leaves(b));
        ridge = Some(ridge.map_or(of_a.min(of_b), |r| r.max(of_a.min(of_b))));
        if !(of_a.is_finite() && of_b.is_finite()) {
            break;
        }
        let (rate_a, rate_b) = (of_a.max(0.0).sqrt() / share, of_b.max(0.0).sqrt() / (1.0 - share));
        let next = if rate_a + rate_b > 0.0 { (rate_b / (rate_a + rate_b)).clamp(0.02, 0.98) } else { share };
        if (next - share).abs() <= RIDGE_PLACE {
            break;
        }
        share = next;
    }
    ridge
}

/// Where the ray from `p` along the unit vector `n` enters the ball round `c`; infinite where it passes it by.
fn ray_into_ball(p: &Point, n: &Vector, c: &Point, radius_mm: f64) -> f64 {
    let to_centre = c - p;
    let along = to_centre.dot(n);
    let under_root = radius_mm * radius_mm - (to_centre.norm_squared() - along * along);
    if under_root < 0.0 { f64::INFINITY } else { along - under_root.sqrt() }
}

/// Distance of two passes on flat ground that leaves the scallop `h`: `√(8 R h − 4 h²)`, mm.
pub fn flat_stepover_mm(radius_mm: f64, scallop_mm: f64) -> f64 {
    (8.0 * radius_mm * scallop_mm - 4.0 * scallop_mm * scallop_mm).max(0.0).sqrt()
}

/// The figure of many ridge heights that a pitch is judged by, mm: the greatest on exact faces; on a mesh the 99th
/// percentile, since single ridges on the edges between facets tell of the facets and not of the part. 0 without heights.
pub fn decisive_mm(level: &LevelSet, mut heights_mm: Vec<f64>) -> f64 {
    heights_mm.sort_by(f64::total_cmp);
    let rank = if level.part.brep.is_some() { 1.0 } else { 0.99 };
    let last = heights_mm.len().saturating_sub(1);
    heights_mm.get((last as f64 * rank).round() as usize).copied().unwrap_or(0.0)
}
