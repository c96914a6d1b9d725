//! Heights over the part, and what all that measure them share: percentiles, the scale of reaches,
//! and how far a ball must be lifted where it cannot reach.

use crate::artifact::report::Place;
use crate::geometry::allowance::Allowed;
use crate::geometry::{Point, Vector};

/// A height and where it was measured.
#[derive(Clone, Copy, Debug)]
pub(super) struct Height {
    /// Height over the part, mm.
    pub height_mm: f64,
    /// Point of the part under it.
    pub point: Point,
    /// Row of the path.
    pub row: usize,
    /// Area that it stands for, in any unit.
    pub weight: f64,
}

impl Height {
    pub fn place(&self) -> Place {
        Place { point: self.point, row: self.row, height_mm: self.height_mm }
    }
}

/// Percentile `q` (0 to 1) by area of sorted heights, interpolated linearly between the middles of
/// their areas; 0 of none.
pub(super) fn percentile(sorted: &[Height], q: f64) -> f64 {
    let (Some(first), Some(last)) = (sorted.first(), sorted.last()) else { return 0.0 };
    let total: f64 = sorted.iter().map(|h| h.weight).sum();
    let at = 0.5 * first.weight + q * (total - 0.5 * (first.weight + last.weight));
    let mut middle = 0.5 * first.weight;
    for pair in sorted.windows(2) {
        let next = middle + 0.5 * (pair[0].weight + pair[1].weight);
        if next >= at && next > middle {
            return pair[0].height_mm + (pair[1].height_mm - pair[0].height_mm) * (at - middle) / (next - middle);
        }
        middle = next;
    }
    last.height_mm
}

pub(super) fn sort(mut heights: Vec<Height>) -> Vec<Height> {
    heights.sort_by(|a, b| a.height_mm.total_cmp(&b.height_mm).then(a.row.cmp(&b.row)));
    heights
}

/// Stepover on a plane, the scale of all reaches here, mm.
pub(super) fn flat_stepover(radius: f64, scallop: f64) -> f64 {
    (8.0 * radius * scallop).sqrt()
}

/// How far a ball that touches the part at `p` must be lifted along `n` until it cuts in nowhere by
/// more than `slack_mm`: 0 where it may touch. What it leaves under itself then, mm, is no fault of
/// the stepover.
pub(super) fn lift(part: &Allowed, p: &Point, n: &Vector, radius_mm: f64, slack_mm: f64) -> f64 {
    let mut up = 0.0;
    // A distance changes no faster than its point moves, so each step is safe; in a corner the
    // steps grow geometrically few.
    for _ in 0..60 {
        match part.closest(&(p + n * (radius_mm + up)), radius_mm - slack_mm) {
            Some(c) if up < radius_mm => up += radius_mm - c.distance_mm,
            _ => break,
        }
    }
    up
}

/// How much a ball may cut in elsewhere and still count as touching, as a share of the scallop:
/// rounding and exactness of the distance only.
pub(super) const REACH_SLACK: f64 = 0.02;
/// A place counts as uncut where the ball must be lifted by this share of the scallop.
pub(super) const UNCUT: f64 = 0.5;
