//! Gouge of a cutter that is no ball: how deep a moving disc with a corner cuts into the part.
//!
//! `depth = r − d`, `r` the corner radius, `d` the distance from the disc to the part
//! ([`crate::geometry::near_disc`]). Between two places nothing is missed. A point `y` of the disc
//! goes along `x(t)`, `t` from 0 to 1, no faster than `V` and with no more acceleration than `A`.
//! The square of its distance from a point `p` of the part has the second derivative
//! `2 |x'|² + 2 (x − p)·x''`. Where the disc is nearest to the part on the way, that is between
//! some `y` and `p`, no farther apart than `d0 + 2V` anywhere on it, so that there
//! ```text
//! d²(t) ≥ (1 − t) d0² + t d1² − t (1 − t) L²,   L² = V² + (d0 + 2V) A
//! ```
//! whatever the part looks like. Where the axis stands still `A` is 0 and `V` the length of the
//! move: then this is the bound of balls ([`super::gouge`]). Where it turns by the angles `ωᵢ`
//! about axes that turn with one another, `V = |c'| + R Σωᵢ` and `A = R (Σωᵢ)²`, `R` the disc's
//! radius. A move is halved until the bound is within the resolution of what has been measured.

pub(super) mod ridges;

use super::gouge::{self, Gouge};
use crate::artifact::Stand;
use crate::geometry::allowance::Allowed;
use crate::geometry::disc::Disc;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::tool::Tool;

/// Moves per unit of parallel work; fixed, so that the result does not depend on the number of
/// threads.
const CHUNK: usize = 128;
/// Moves along which the disc goes no farther than this are not halved, mm.
const SHORTEST_MM: f64 = 1e-5;
/// Share of the resolution that the distance at one place may be off by.
const AT_ONE_PLACE: f64 = 0.2;
/// Of deep cuts, and of large distances, so much may be missed.
const MISSED_SHARE: f64 = 0.02;
/// A disc nearer to the part's surface than this cuts it, mm.
const CUT_MM: f64 = 1e-6;
/// Rings, and places on each, at which is looked how deep a disc in the part lies there.
const DEPTHS: [u32; 2] = [4, 24];

/// A cutter moved from stand to stand.
#[derive(Clone, Copy)]
pub(super) struct SweptCutter<'a> {
    /// Where it stands.
    pub stands: &'a [Stand],
    /// Moves that count, by their first stand.
    pub wanted: &'a [bool],
    /// The cutter.
    pub tool: &'a Tool,
}

/// The disc at a place, and how far it is from the part with its stock.
#[derive(Clone, Copy)]
struct DiscPlace {
    stand: Stand,
    /// Measured, mm; where it is farther than is looked, so far.
    found_mm: f64,
    /// No less than this, mm.
    least_mm: f64,
    /// The point of the disc that is nearest.
    on_disc: Point,
}

impl SweptCutter<'_> {
    fn counts(&self, i: usize) -> bool {
        self.wanted.get(i) == Some(&true)
    }

    fn moves(&self) -> usize {
        self.stands.len().saturating_sub(1)
    }

    fn disc(&self, stand: &Stand) -> Disc {
        self.tool.disc(stand.centre, stand.axis())
    }

    /// `V` and `A` of the module's page.
    fn rates(&self, from: &Stand, to: &Stand) -> [f64; 2] {
        let cone = if from.cone == to.cone { 0.0 } else { from.cone.rotation_to(&to.cone).norm() };
        let turn = (to.theta - from.theta).abs() + (to.cone.lean_rad - from.cone.lean_rad).abs() + cone;
        let radius = self.tool.disc_radius_mm();
        [(to.centre - from.centre).norm() + radius * turn, radius * turn * turn]
    }

    fn place(
        &self,
        part: &Allowed,
        search: &mut DiscSearch,
        stand: Stand,
        cap_mm: f64,
        tolerance_mm: f64,
    ) -> DiscPlace {
        let disc = self.disc(&stand);
        match search.closest(&disc, cap_mm + part.stock_mm, tolerance_mm) {
            Some(near) => DiscPlace {
                stand,
                found_mm: near.distance_mm - part.stock_mm,
                least_mm: (near.least_mm - part.stock_mm).max(0.0),
                on_disc: near.on_disc,
            },
            None => DiscPlace { stand, found_mm: cap_mm, least_mm: cap_mm, on_disc: stand.centre },
        }
    }
}

/// Deepest gouge of the moves that count, measured to `resolution_mm`; distances of the cutter to
/// the part are reported up to `reach_mm` at least. The centre reported is the point of the disc
/// that is nearest to the part.
pub(super) fn measure_within(part: &Allowed, swept: &SweptCutter, resolution_mm: f64, reach_mm: f64) -> Gouge {
    let n = swept.moves();
    let chunks: Vec<Gouge> = parallel::map(0..n.div_ceil(CHUNK), |k| {
        measure_moves(part, swept, k * CHUNK..((k + 1) * CHUNK).min(n), resolution_mm, reach_mm)
    });
    chunks.into_iter().fold(Gouge::none(), Gouge::and)
}

fn measure_moves(
    part: &Allowed,
    swept: &SweptCutter,
    moves: std::ops::Range<usize>,
    resolution: f64,
    reach_mm: f64,
) -> Gouge {
    let (corner, stands) = (swept.tool.corner_mm(), swept.stands);
    let counts = moves.clone().filter(|i| swept.counts(*i));
    let longest = counts.map(|i| swept.rates(&stands[i], &stands[i + 1])[0]).fold(0.0, f64::max);
    let cap = corner + longest.max(reach_mm);
    let mut search = DiscSearch::new(part);
    let mut worst = Gouge::none();
    let see = |worst: &mut Gouge, segment: usize, at: &DiscPlace| {
        let mut depth = corner - at.found_mm;
        if depth <= worst.found_mm {
            return;
        }
        let mut centre = at.on_disc;
        if at.found_mm + part.stock_mm <= CUT_MM
            && let Some((more, deepest)) = sunk(part, &swept.disc(&at.stand))
        {
            (depth, centre) = (depth + more, deepest);
        }
        *worst = Gouge { found_mm: depth, bound_mm: worst.bound_mm.max(depth), segment, centre };
    };
    let mut last: Option<DiscPlace> = None;
    for i in moves {
        if !swept.counts(i) {
            last = None;
            continue;
        }
        let mut look = |stand: Stand| swept.place(part, &mut search, stand, cap, AT_ONE_PLACE * resolution);
        let a = last.unwrap_or_else(|| look(stands[i]));
        let b = look(stands[i + 1]);
        see(&mut worst, i, &a);
        see(&mut worst, i, &b);
        last = Some(b);
        let mut open = vec![(a, b)];
        while let Some((a, b)) = open.pop() {
            let [way, bend] = swept.rates(&a.stand, &b.stand);
            let length = (way * way + (a.found_mm.min(b.found_mm).max(0.0) + 2.0 * way) * bend).sqrt();
            let deepest = corner - gouge::least_between(a.least_mm, b.least_mm, length);
            if deepest <= enough(worst.found_mm, resolution, reach_mm > 0.0) || way < SHORTEST_MM {
                worst.bound_mm = worst.bound_mm.max(deepest);
                continue;
            }
            let mid = look(a.stand.towards(&b.stand, 0.5));
            see(&mut worst, i, &mid);
            open.push((a, mid));
            open.push((mid, b));
        }
    }
    worst
}

/// How deep a bound may say that the cutter is where it was found to be so deep: by the resolution
/// more, and by a share of deep cuts. Where the distance of a cutter that stays off is asked for it
/// may be by a share of that, and must not say that the cutter touches.
fn enough(found_mm: f64, resolution_mm: f64, how_far: bool) -> f64 {
    let more = resolution_mm.max(MISSED_SHARE * found_mm.abs());
    match (found_mm > 0.0, how_far) {
        (true, _) => found_mm + more,
        (false, true) => (found_mm + more).min(0.0),
        (false, false) => resolution_mm,
    }
}

/// How deep a disc that cuts the part's surface lies in it at some of its places, mm, and the
/// deepest of them.
fn sunk(part: &Allowed, disc: &Disc) -> Option<(f64, Point)> {
    let other = if disc.axis.x.abs() < 0.9 { Vector::x() } else { Vector::y() };
    let e = disc.axis.cross(&other).normalize();
    let f = disc.axis.cross(&e);
    let [rings, round] = DEPTHS;
    let places = (0..=rings).flat_map(|i| (0..round).map(move |k| (i, k))).map(|(i, k)| {
        let (s, c) = (std::f64::consts::TAU * f64::from(k) / f64::from(round)).sin_cos();
        disc.centre + (e * c + f * s) * (disc.radius_mm * f64::from(i) / f64::from(rings))
    });
    let depth = |x: Point| Some((part.closest(&x, f64::INFINITY)?.distance_mm, x));
    places.filter(|x| part.inside(x)).filter_map(depth).reduce(|a, b| if b.0 > a.0 { b } else { a })
}

/// The moves that cut deeper than `limit_mm` at their end or in the middle.
pub(super) fn deeper_than(part: &Allowed, swept: &SweptCutter, limit_mm: f64) -> Vec<usize> {
    let n = swept.moves();
    let near = swept.tool.corner_mm() - limit_mm + part.stock_mm;
    let chunk = |k: usize| {
        let mut search = DiscSearch::new(part);
        let mut deep = |stand: &Stand| search.closest(&swept.disc(stand), near, 0.1 * limit_mm.max(1e-3)).is_some();
        let wanted = (k * CHUNK..((k + 1) * CHUNK).min(n)).filter(|i| swept.counts(*i));
        let cuts = |i: &usize| {
            let (a, b) = (&swept.stands[*i], &swept.stands[*i + 1]);
            deep(b) || deep(&a.towards(b, 0.5))
        };
        wanted.filter(cuts).collect::<Vec<usize>>()
    };
    parallel::flat_map(0..n.div_ceil(CHUNK), chunk)
}

/// Which stands are no farther from the part, its stock and the cutter's corner between them, than
/// `near_mm`.
pub(super) fn touching(part: &Allowed, stands: &[Stand], tool: &Tool, near_mm: f64) -> Vec<bool> {
    let near = tool.corner_mm() + part.stock_mm + near_mm;
    let chunk = |chunk: &[Stand]| {
        let mut search = DiscSearch::new(part);
        let touches = |s: &Stand| search.closest(&tool.disc(s.centre, s.axis()), near, 0.1 * near_mm).is_some();
        chunk.iter().map(touches).collect::<Vec<bool>>()
    };
    parallel::flat_map(stands.chunks(CHUNK), chunk)
}

/// How far the part, with its stock, is off a cutter at each stand, mm, to `tolerance_mm`.
pub(super) fn off_mm(part: &Allowed, stands: &[Stand], tool: &Tool, tolerance_mm: f64) -> Vec<f64> {
    let room = tool.corner_mm() + part.stock_mm;
    let chunk = |chunk: &[Stand]| {
        let mut search = DiscSearch::new(part);
        let mut near = |s: &Stand| search.closest(&tool.disc(s.centre, s.axis()), f64::INFINITY, tolerance_mm);
        chunk.iter().map(|s| near(s).map_or(f64::INFINITY, |n| n.distance_mm - room)).collect::<Vec<f64>>()
    };
    parallel::flat_map(stands.chunks(CHUNK), chunk)
}

#[cfg(test)]
mod tests;
