//! The scallop between two neighbouring passes, measured on the part itself.
//!
//! A ball between two passes, on the level set like them, would touch the part at a contact point `p` with normal `n`. What
//! the two passes leave standing there is the height at which the ray from `p` along `n` enters one of their balls, and the
//! ridge is where both leave the same. On a part of constant curvature across the passes this is the cusp of the two-ball construction,
//! `h = |ρ cos α ∓ √(R² − ρ² sin² α) − r|`, `sin α = d/2ρ`; measured on the part it needs no curvature, so it holds on
//! meshes, creases and saddles alike, and what no ball of this radius can reach (sharp inner corners) does not count.

use super::level::LevelSet;
use crate::geometry::{Point, Vector};

/// Places between two passes that are looked at; one does where the curvature is steady.
const RIDGE_STEPS: usize = 9;
/// A ridge's place is known well enough within this share of the way from pass to pass.
const RIDGE_PLACE: f64 = 1e-3;
/// Contacts with normals this near to one another are on facets of one wall, rad.
const ONE_WALL_RAD: f64 = 0.2;
/// The roots of both heights are equal within this share of their sum where the ridge is.
const EVEN: f64 = 0.01;

/// Height of the ridge between two balls of the level set over the part, mm; infinite where neither reaches over the
/// contact between them, `None` where there is no ball of the level set between them.
///
/// The ridge is where both balls leave the same height. That is midway only where the curvature across the passes does
/// not change, and much nearer to one of them where a wall runs into a fillet: each height grows about as the square of the
/// way from its own pass, `h_a ≈ (s_a a)²` at the share `a` of the way, which tells where to look next and, once that is near,
/// how high the ridge is: `(s_a s_b / (s_a + s_b))²`. Every place looked at is on the part, so where the curvature jumps the greatest
/// height found is left there indeed.
pub fn ridge_height(level: &LevelSet, a: &Point, b: &Point) -> Option<f64> {
    let reach = 0.5 * (b - a).norm() + 0.02 * level.radius_mm;
    let mut share = 0.5;
    // The nearest places known at which `a` leaves less than `b`, and more.
    let (mut less, mut more): (Option<Side>, Option<Side>) = (None, None);
    let mut ridge: Option<f64> = None;
    for _ in 0..RIDGE_STEPS {
        let Some(between) = level.touch(&(a + (b - a) * share), reach) else { break };
        let leaves = |c: &Point| ray_into_ball(&between.contact, &between.normal, c, level.radius_mm);
        let (of_a, of_b) = (leaves(a), leaves(b));
        ridge = Some(ridge.map_or(of_a.min(of_b), |r| r.max(of_a.min(of_b))));
        if of_a.is_infinite() && of_b.is_infinite() {
            break;
        }
        let (root_a, root_b) = (of_a.max(0.0).sqrt(), of_b.max(0.0).sqrt());
        let (rate_a, rate_b) = (root_a / share, root_b / (1.0 - share));
        if (root_a - root_b).abs() <= EVEN * (root_a + root_b) {
            return Some((rate_a * rate_b / (rate_a + rate_b).max(1e-300)).powi(2));
        }
        let side = Side { share, root_a, root_b, normal: between.normal };
        if root_a > root_b {
            more = Some(side)
        } else {
            less = Some(side)
        }
        let (low, high) = (less.map_or(0.0, |s| s.share), more.map_or(1.0, |s| s.share));
        if high - low < RIDGE_PLACE {
            break;
        }
        // Where one of them is infinite this is no number, and the middle is taken.
        let next = match (&less, &more) {
            (Some(l), Some(m)) => low + l.crossing(m) * (high - low),
            _ => rate_b / (rate_a + rate_b),
        };
        share = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    match (less, more) {
        // Between neighbouring facets the contact jumps; the ridge is between the two contacts.
        (Some(l), Some(m)) if l.finite() && m.finite() && l.normal.angle(&m.normal) < ONE_WALL_RAD => {
            Some((l.root_a + l.crossing(&m) * (m.root_a - l.root_a)).powi(2))
        }
        _ => ridge,
    }
}

/// What two passes leave at a place between them.
#[derive(Clone, Copy)]
struct Side {
    share: f64,
    /// Roots of the heights left by the one and the other.
    root_a: f64,
    root_b: f64,
    normal: Vector,
}

impl Side {
    fn finite(&self) -> bool {
        self.root_a.is_finite() && self.root_b.is_finite()
    }

    /// The share of the way from here to `more` at which both leave the same if the roots run straight; no number where one is
    /// infinite.
    fn crossing(&self, more: &Side) -> f64 {
        let here = self.root_b - self.root_a;
        here / (here + more.root_a - more.root_b).max(1e-300)
    }
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
