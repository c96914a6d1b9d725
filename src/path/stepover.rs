//! The scallop between two neighbouring passes, measured on the part itself.
//!
//! Two balls of radius R with centres d apart meet in a circle of radius √(R² − d²/4) in the plane halfway between
//! them. What they leave standing is highest where that circle comes nearest to the part; its distance to the part is
//! the scallop. On a part of constant curvature across the passes this is the closed form
//! `h = |ρ cos α ∓ √(R² − ρ² sin² α) − r|`, `sin α = d/2ρ` of the two-ball construction; measured on the part it needs no
//! curvature, so it holds on meshes, creases and saddles alike.

use crate::geometry::Point;
use crate::geometry::part::Part;

/// Height of the ridge between two balls over the part, mm; `None` where the balls do not meet or the part is out of reach.
pub fn ridge_height(part: &Part, a: &Point, b: &Point, radius_mm: f64) -> Option<f64> {
    let d = (b - a).norm();
    if d >= 2.0 * radius_mm || d < 1e-12 {
        return (d < 1e-12).then_some(0.0);
    }
    let along = (b - a) / d;
    let mid = a + (b - a) * 0.5;
    let circle = (radius_mm * radius_mm - 0.25 * d * d).sqrt();
    let mut probe = mid;
    let mut height = None;
    // The lowest point of the circle looks straight at its own foot; two repetitions settle it to far below a micrometre.
    for _ in 0..3 {
        let foot = part.closest(&probe, 2.0 * radius_mm)?;
        let mut down = foot.point - mid;
        down -= along * down.dot(&along);
        let down = down.try_normalize(1e-12)?;
        probe = mid + down * circle;
        height = Some(part.closest(&probe, 2.0 * radius_mm)?.distance_mm);
    }
    height
}

/// Distance of two passes on flat ground that leaves the scallop `h`: `√(8 R h − 4 h²)`, mm.
pub fn flat_stepover_mm(radius_mm: f64, scallop_mm: f64) -> f64 {
    (8.0 * radius_mm * scallop_mm - 4.0 * scallop_mm * scallop_mm).max(0.0).sqrt()
}
