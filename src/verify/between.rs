//! Heights between two passes: which places lie between passes, and what was measured there.

use super::sweep::Sweep;
use crate::geometry::Point;

/// The ball touches the part where it is this near, mm.
pub(super) const NEAR_MM: f64 = 0.05;
/// Passes as far apart as so many stepovers are still neighbours: a turn that is missing is seen.
pub(super) const REACH_STEPOVERS: f64 = 2.5;
/// Least reach, mm.
pub(super) const LEAST_REACH_MM: f64 = 0.4;
/// Two places are on two sides where the cosine of their directions is less than this.
const OPPOSITE: f64 = -0.8;

/// A height between two passes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Height {
    pub height_mm: f64,
    pub point: Point,
    /// Leg of the nearest pass.
    pub leg: usize,
    /// How far the two passes are apart, mm.
    pub gap_mm: f64,
}

/// All of them, the lowest first.
pub(super) struct Heights {
    pub sorted: Vec<Height>,
}

impl Heights {
    /// Percentile, 0 to 1; 0 where there is no sample.
    pub fn percentile(&self, q: f64) -> f64 {
        percentile(&self.sorted, q).map_or(0.0, |h| h.height_mm)
    }
}

pub(super) fn percentile(sorted: &[Height], q: f64) -> Option<&Height> {
    sorted.get(((sorted.len().saturating_sub(1)) as f64 * q).round() as usize)
}

/// Heights in their order.
pub(super) fn sorted(mut heights: Vec<Height>) -> Heights {
    heights.sort_by(|a, b| a.height_mm.total_cmp(&b.height_mm).then(a.leg.cmp(&b.leg)));
    Heights { sorted: heights }
}

/// The leg nearest to a ball centre that lies between passes, and how far the nearest places on its
/// two sides are apart; `None` where the two are not `beside` passes: near an end of one.
pub(super) fn between(
    sweep: &Sweep,
    q: &Point,
    reach_mm: f64,
    beside: impl Fn([(usize, &Point); 2]) -> bool,
) -> Option<(usize, f64)> {
    type Near = (f64, usize, Point);
    let near: Vec<Near> = sweep.all_near(q, reach_mm).into_iter().map(|(leg, c)| ((c - q).norm(), leg, c)).collect();
    let nearer = |a: &&Near, b: &&Near| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    let (d, leg, c) = *near.iter().min_by(nearer)?;
    let side = c - q;
    let across = |(e, _, other): &&Near| *e > 1e-9 && (other - q).dot(&side) <= OPPOSITE * d * e;
    let (e, other, at) = near.iter().filter(across).min_by(nearer)?;
    beside([(leg, &c), (*other, at)]).then_some((leg, d + e))
}
