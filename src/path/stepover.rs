//! The scallop between two neighbouring passes, measured on the part itself.
//!
//! A ball halfway between two passes, on the level set like them, would touch the part at a contact point `p` with normal
//! `n`. What the two passes leave standing there is the height at which the ray from `p` along `n` enters one of their
//! balls. On a part of constant curvature across the passes this is the cusp of the two-ball construction,
//! `h = |ρ cos α ∓ √(R² − ρ² sin² α) − r|`, `sin α = d/2ρ`; measured on the part it needs no curvature, so it holds on
//! meshes, creases and saddles alike, and what no ball of this radius can reach (sharp inner corners) does not count.

use super::level::LevelSet;
use crate::geometry::{Point, Vector};

/// Height of the ridge between two balls of the level set over the part, mm; infinite where neither reaches over the
/// contact between them, `None` where there is no ball of the level set between them.
pub fn ridge_height(level: &LevelSet, a: &Point, b: &Point) -> Option<f64> {
    let between = level.touch_in_plane(&(a + (b - a) * 0.5), 0.5 * (b - a).norm() + 0.02 * level.radius_mm)?;
    let enters = |c: &Point| ray_into_ball(&between.contact, &between.normal, c, level.radius_mm);
    Some(enters(a).min(enters(b)))
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
