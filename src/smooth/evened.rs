//! A path whose touches are merely evened, to tell from it what a smooth curve gains besides.

use super::validate_path;
use crate::artifact::Toolpath;
use crate::error::Result;
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};

/// Weights of the mean over five locations.
const MEAN: [f64; 5] = [1.0 / 16.0, 4.0 / 16.0, 6.0 / 16.0, 4.0 / 16.0, 1.0 / 16.0];
/// How often a mean is set onto the part again, each time nearer to it.
const ROUNDS: usize = 3;

/// Each location moved to a mean over five, its own place along the path kept, and set onto the
/// part again. Arc lengths are those of the moves.
///
/// # Errors
/// Kind `Usage` for fewer than two locations, or values that are not finite.
pub fn evened(part: &Part, path: &Toolpath) -> Result<Toolpath> {
    validate_path(path)?;
    let part = Allowed::new(part, path.stock_mm);
    let mut out = path.clone();
    let all = &path.locations;
    let mut s_mm = 0.0;
    for k in 0..all.len() {
        if k >= 2 && k + 2 < all.len() {
            let near = &all[k - 2..=k + 2];
            let mean: Vector = near.iter().zip(MEAN).map(|(l, w)| l.centre.coords * w).sum();
            let mean_s: f64 = near.iter().zip(MEAN).map(|(l, w)| l.s_mm * w).sum();
            let tangent = (all[k + 1].centre - all[k - 1].centre) / (all[k + 1].s_mm - all[k - 1].s_mm);
            let mut c = Point::from(mean + tangent * (all[k].s_mm - mean_s));
            for _ in 0..ROUNDS {
                let Some(foot) = part.closest(&c, f64::INFINITY) else { continue };
                let Some(normal) = (c - foot.point).try_normalize(1e-12) else { continue };
                c = foot.point + normal * path.radius_mm;
            }
            out.locations[k].centre = c;
        }
        if k > 0 {
            s_mm += (out.locations[k].centre - out.locations[k - 1].centre).norm();
        }
        out.locations[k].s_mm = s_mm;
    }
    Ok(out)
}
