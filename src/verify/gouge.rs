//! Gouge: how deep the swept ball cuts into the part.
//!
//! `depth = R − d(c)`, `d` the distance from the ball centre to the part. Between samples nothing
//! is missed: `d²(x) − |x|²` is concave (it is the least of the functions `|x − p|² − |x|²`, linear
//! in `x`), so on a straight move of length `L` with distances `d0`, `d1` at its ends
//! ```text
//! d²(t) ≥ (1 − t) d0² + t d1² − t (1 − t) L²
//! ```
//! whatever the part looks like. A move is halved until this bound is within the resolution of what
//! has been measured.

use super::sweep::Sweep;
use crate::geometry::Point;
use crate::geometry::allowance::Allowed;
use crate::parallel;

/// Moves per unit of parallel work; fixed, so that the result does not depend on the number of
/// threads.
const CHUNK: usize = 256;
/// Moves are not halved below this length, mm.
const SHORTEST_MM: f64 = 1e-5;

/// Of deep cuts so much may be missed.
const MISSED_SHARE: f64 = 0.02;

/// What is said of a place that the part has otherwise than its file.
const AS_PUBLISHED: &str = " as its file has it, which sewing or healing moved";

/// The deepest gouge found, and a bound on what may lie between the samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gouge {
    /// Deepest cut measured, mm; negative: the ball stays that far from the part.
    pub found_mm: f64,
    /// No place of the path cuts deeper than this, mm.
    pub bound_mm: f64,
    /// Move of the deepest cut.
    pub segment: usize,
    /// Ball centre there.
    pub centre: Point,
}

impl Gouge {
    pub fn none() -> Self {
        Gouge { found_mm: f64::NEG_INFINITY, bound_mm: f64::NEG_INFINITY, segment: 0, centre: Point::origin() }
    }
    pub fn and(self, other: Self) -> Self {
        let bound_mm = self.bound_mm.max(other.bound_mm);
        if other.found_mm > self.found_mm { Gouge { bound_mm, ..other } } else { Gouge { bound_mm, ..self } }
    }
}

/// Least of `(1 − t) d0² + t d1² − t (1 − t) L²` over `0 ≤ t ≤ 1`, as a distance.
pub(super) fn least_between(d0: f64, d1: f64, length: f64) -> f64 {
    let (a, b, l2) = (d0 * d0, d1 * d1, length * length);
    if l2 == 0.0 {
        return d0.min(d1);
    }
    let t = (0.5 * (1.0 - (b - a) / l2)).clamp(0.0, 1.0);
    ((1.0 - t) * a + t * b - t * (1.0 - t) * l2).max(0.0).sqrt()
}

/// Deepest gouge of the whole sweep, measured to `resolution_mm`. Where the ball stays farther off
/// the part than a move is long, only that is reported.
pub(super) fn measure(part: &Allowed, sweep: &Sweep, resolution_mm: f64) -> Gouge {
    measure_within(part, sweep, resolution_mm, 0.0)
}

/// As [`measure`]; distances of the ball to the part are reported up to `reach_mm` at least.
pub(super) fn measure_within(part: &Allowed, sweep: &Sweep, resolution_mm: f64, reach_mm: f64) -> Gouge {
    let n = sweep.centres.len() - 1;
    let chunks: Vec<Gouge> = parallel::map(0..n.div_ceil(CHUNK), |k| {
        measure_moves(part, sweep, k * CHUNK..((k + 1) * CHUNK).min(n), resolution_mm, reach_mm)
    });
    chunks.into_iter().fold(Gouge::none(), Gouge::and)
}

fn measure_moves(
    part: &Allowed,
    sweep: &Sweep,
    moves: std::ops::Range<usize>,
    resolution: f64,
    reach_mm: f64,
) -> Gouge {
    let radius = sweep.radius_mm;
    // Farther than this no move can gouge; a distance capped there is a true lower bound.
    let length = |i: usize| (sweep.centres[i + 1] - sweep.centres[i]).norm();
    let longest = moves.clone().filter(|i| sweep.counts(*i)).map(length).fold(0.0, f64::max);
    let cap = radius + longest.max(reach_mm);
    let distance = |c: &Point| part.closest(c, cap).map_or(cap, |f| f.distance_mm);
    let mut worst = Gouge::none();
    let see = |worst: &mut Gouge, segment: usize, centre: Point, d: f64| {
        if radius - d > worst.found_mm {
            *worst = Gouge { found_mm: radius - d, bound_mm: worst.bound_mm.max(radius - d), segment, centre };
        }
    };
    let mut d0 = f64::NAN;
    for i in moves {
        if !sweep.counts(i) {
            d0 = f64::NAN;
            continue;
        }
        let (a, b) = (sweep.centres[i], sweep.centres[i + 1]);
        if d0.is_nan() {
            d0 = distance(&a);
        }
        let d1 = distance(&b);
        see(&mut worst, i, a, d0);
        see(&mut worst, i, b, d1);
        let mut open = vec![(a, d0, b, d1)];
        while let Some((a, da, b, db)) = open.pop() {
            let length = (b - a).norm();
            let deepest = radius - least_between(da, db, length);
            let enough = worst.found_mm.max(0.0) + resolution.max(MISSED_SHARE * worst.found_mm);
            if deepest <= enough || length < SHORTEST_MM {
                worst.bound_mm = worst.bound_mm.max(deepest);
                continue;
            }
            let mid = a + (b - a) * 0.5;
            let dm = distance(&mid);
            see(&mut worst, i, mid, dm);
            open.push((a, da, mid, dm));
            open.push((mid, dm, b, db));
        }
        d0 = d1;
    }
    worst
}

/// The moves that cut deeper than `limit_mm` at an end or in the middle.
pub(super) fn deeper_than(part: &Allowed, sweep: &Sweep, limit_mm: f64) -> Vec<usize> {
    let deep = |c: &Point| part.closest(c, sweep.radius_mm - limit_mm).is_some();
    let cuts = |i: &usize| {
        let (a, b) = (sweep.centres[*i], sweep.centres[*i + 1]);
        deep(&b) || deep(&nalgebra::center(&a, &b))
    };
    let moves = 0..sweep.centres.len().saturating_sub(1);
    parallel::filter(moves.filter(|i| sweep.counts(*i)), cuts)
}

/// The face that is nearest to a ball centre, whether only the part's file has it so, and what to
/// do about that where it is cut too deep.
pub(super) fn where_it_is(part: &Allowed, centre: &Point, is_deep: bool) -> String {
    let face = part.closest(centre, f64::INFINITY).map(|c| part.face_name(c.face)).unwrap_or_default();
    match (part.nearest_is_published(centre), is_deep) {
        (false, _) => face,
        (true, false) => format!("{face}{AS_PUBLISHED}"),
        (true, true) => {
            format!("{face}{AS_PUBLISHED}: sew or repair the part in CAD, or allow as much with verify.gouge_mm")
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Vector;
    use crate::geometry::brep::{Brep, Face, SurfaceKind};
    use crate::geometry::exact::tests::{block, plane};
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use proptest::prelude::*;

    /// A ball rolls round the edge x = 40, y = 10 of a block of which one face passes that edge by
    /// 0.015 mm in its file.
    #[test]
    fn what_sewing_cut_away_is_gouged() {
        let part = Part::from_brep(block(Vector::new(40.0, 10.0, 60.0)), 0.02, &Silent).unwrap();
        let strip = Face {
            name: "y+".into(),
            kind: SurfaceKind::Plane,
            surface: plane(Point::new(0.0, 10.0, 0.0), Vector::x() * 40.015, Vector::z() * 60.0),
            reversed: true,
            loops: Vec::new(),
        };
        let strip = Part::from_brep(Brep { faces: vec![strip], edges: Vec::new() }, 0.02, &Silent).unwrap();
        let centres: Vec<Point> = (0..=900)
            .map(|k| f64::from(k) * 0.1_f64.to_radians())
            .map(|a| Point::new(40.0 + 3.0 * a.cos(), 10.0 + 3.0 * a.sin(), 30.0))
            .collect();
        let sweep = Sweep::of(centres.clone(), centres, vec![0; 901], 3.0, None);
        let as_sewn = measure(&Allowed::new(&part, 0.0), &sweep, 1e-4);
        assert!(as_sewn.bound_mm < 1e-4, "{as_sewn:?}");
        let whole = part.with_published(strip, vec![Some(3)]);
        let as_published = measure(&Allowed::new(&whole, 0.0), &sweep, 1e-4);
        assert!((as_published.found_mm - 0.015).abs() < 1e-9 && as_published.segment == 0, "{as_published:?}");
        assert!(whole.nearest_is_published(&as_published.centre));
    }

    proptest! {
        #[test]
        fn bound_between_samples_holds_for_a_cloud(
            cloud in prop::collection::vec([-4.0..4.0f64, -4.0..4.0f64, -4.0..4.0f64], 1..20),
            b in [-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64],
        ) {
            let (a, b) = (Point::origin(), Point::from(b));
            let d = |q: &Point| cloud.iter().map(|p| (q - Point::from(*p)).norm()).fold(f64::MAX, f64::min);
            let bound = least_between(d(&a), d(&b), (b - a).norm());
            for k in 0..=200 {
                prop_assert!(d(&(a + (b - a) * (f64::from(k) / 200.0))) >= bound - 1e-9);
            }
        }
    }
}
