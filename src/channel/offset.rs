//! The least travel of Y with which a schedule that never turns back exists.
//!
//! The offset of the plane of tool axes from the blade axis ([`AxisTravel::of_offset`]) is to stay
//! within a range of least width, wherever that lies. Whether a given range does is decided by one
//! pass over the locations: of all schedules the one that is behind as far as it may be goes on
//! wherever any does. For a lower end `a` of the range let `g(a)` be the least upper end that does.
//! `g` never falls, since a higher lower end leaves less. So no range that begins within `a..b` is
//! narrower than `g(a) − b`, and cutting the intervals that may still hold a narrower one than the
//! best until none is left finds the least to any gap, with its proof.

use super::FreeInterval;
use crate::artifact::{AxisTravel, Toolpath};
use crate::error::{Result, Stage};
use crate::geometry::Point;
use crate::numerics::angle::within_half_turn;
use crate::observe::Observer;
use crate::parallel;

/// Share by which the range may be wider than the bound that is proved.
const GAP: f64 = 0.005;
/// Ranges are known to this, mm.
const TOLERANCE_MM: f64 = 1e-3;
/// Locations of the first search; a bound by some of them holds for all.
const FEW: usize = 3000;
/// Intervals that are apart by less meet, rad.
const ROUNDING_RAD: f64 = 1e-6;
/// Intervals of the lower end at the start, and rounds of cutting them.
const FIRST: usize = 64;
const ROUNDS: usize = 24;

/// The least range of the offset.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct LeastTravel {
    /// Half the width of the range, mm.
    pub half_mm: f64,
    /// Its middle, mm.
    pub middle_mm: f64,
    /// No range of less than twice this has a schedule, mm: proved at the locations.
    pub bound_mm: f64,
}

/// A location: its ball centre, its distance from the blade axis, and the free angles.
struct OffsetPlace {
    centre: Point,
    rho_mm: f64,
    free: Vec<[f64; 2]>,
}

/// The least range of the offset with which a schedule that never turns back exists in the free
/// intervals; `None` where there is none whatever the range.
///
/// # Errors
/// `Cancelled`.
pub fn least_travel(
    path: &Toolpath,
    free: &[Vec<FreeInterval>],
    observer: &dyn Observer,
) -> Result<Option<LeastTravel>> {
    let place = |(l, f): (&crate::artifact::toolpath::CutterLocation, &Vec<FreeInterval>)| OffsetPlace {
        centre: l.centre,
        rho_mm: l.centre.y.hypot(l.centre.z),
        free: f.iter().map(|f| [f.theta_min, f.theta_max]).collect(),
    };
    let all: Vec<OffsetPlace> = path.locations.iter().zip(free).map(place).collect();
    let most = all.iter().map(|p| p.rho_mm).fold(0.0, f64::max);
    if !leads_through(&all, [-most, most]) {
        return Ok(None);
    }
    let mut step = all.len().div_ceil(FEW).max(1);
    loop {
        let few: Vec<&OffsetPlace> = all.iter().step_by(step).collect();
        let found = searched(&few, &all, most, observer)?;
        let gap = found.half_mm - found.bound_mm;
        if step == 1 || gap <= 2.0 * GAP * found.half_mm || gap <= TOLERANCE_MM {
            return Ok(Some(found));
        }
        step = step.div_ceil(4);
    }
}

/// The least range by some locations, as it holds for all.
fn searched(few: &[&OffsetPlace], all: &[OffsetPlace], most: f64, observer: &dyn Observer) -> Result<LeastTravel> {
    let upper = |low: f64| least_upper(low, most, |range| stays_behind(few, range));
    // Where the lower end may be, with the least upper end of its beginning.
    let mut cells: Vec<([f64; 2], f64)> = parallel::map(0..FIRST, |k| {
        let at = |k: usize| -most + 2.0 * most * k as f64 / FIRST as f64;
        ([at(k), at(k + 1)], upper(at(k)))
    });
    let mut best = [-most, most];
    let width = |range: [f64; 2]| range[1] - range[0];
    for _ in 0..ROUNDS {
        observer.check(Stage::Channel)?;
        for ([low, _], up) in &cells {
            if up - low < width(best) {
                best = [*low, *up];
            }
        }
        // No range is narrower than none.
        let enough = |bound: f64| bound >= (1.0 - GAP) * width(best) || width(best) - bound.max(0.0) <= TOLERANCE_MM;
        let (done, open): (Vec<_>, Vec<_>) = cells.into_iter().partition(|([_, end], up)| enough(up - end));
        if open.is_empty() {
            cells = done;
            break;
        }
        let halves = parallel::map(open, |([from, to], up)| {
            let middle = 0.5 * (from + to);
            [([from, middle], up), ([middle, to], upper(middle))]
        });
        cells = done.into_iter().chain(halves.into_iter().flatten()).collect();
    }
    let bound = cells.iter().map(|([_, end], up)| up - end).fold(width(best), f64::min).max(0.0);
    // The same lower end, for all locations; or one a little lower.
    let mut whole = [-most, most];
    for k in 0..8 {
        let low = best[0] - 0.25 * GAP * f64::from(k) * width(best).max(TOLERANCE_MM);
        let up = least_upper(low, most, |range| leads_through(all, range));
        if up - low < width(whole) {
            whole = [low, up];
        }
    }
    let [half_mm, bound_mm] = [0.5 * width(whole), 0.5 * bound];
    Ok(LeastTravel { half_mm, middle_mm: 0.5 * (whole[0] + whole[1]), bound_mm: bound_mm.min(half_mm) })
}

/// The least upper end of a range with a schedule; without end where there is none.
fn least_upper(low: f64, most: f64, has: impl Fn([f64; 2]) -> bool) -> f64 {
    if !has([low, most]) {
        return f64::INFINITY;
    }
    let (mut without, mut with) = (low, most);
    while with - without > 0.1 * TOLERANCE_MM {
        let middle = 0.5 * (without + with);
        if has([low, middle]) {
            with = middle;
        } else {
            without = middle;
        }
    }
    with
}

/// What a range of the offset leaves of an interval.
fn left(place: &OffsetPlace, interval: [f64; 2], range: [f64; 2]) -> impl Iterator<Item = [f64; 2]> + use<> {
    let within = -place.rho_mm >= range[0] && place.rho_mm <= range[1];
    let cut = (!within).then(|| AxisTravel::of_offset("", range).left_of(&place.centre, interval));
    let whole = within.then_some(interval);
    whole.into_iter().chain(cut.into_iter().flatten().map(|(part, _)| part))
}

/// A schedule that never turns back may be within the range at these places, whatever is between.
fn stays_behind(places: &[&OffsetPlace], range: [f64; 2]) -> bool {
    let mut at = f64::NEG_INFINITY;
    for place in places {
        let next = place.free.iter().flat_map(|i| left(place, *i, range));
        at = next.filter(|[_, hi]| *hi >= at).map(|[lo, _]| lo.max(at)).fold(f64::INFINITY, f64::min);
        if at == f64::INFINITY {
            return false;
        }
    }
    true
}

/// How far the ends of what a range leaves go from a place to the next, rad: with the azimuth of
/// the ball centre, and with its distance from the axis.
fn ends_go(from: &OffsetPlace, to: &OffsetPlace, range: [f64; 2]) -> f64 {
    let azimuth = |place: &OffsetPlace| place.centre.z.atan2(place.centre.y);
    let ahead = |place: &OffsetPlace, offset: f64| (offset / place.rho_mm).clamp(-1.0, 1.0).asin();
    let by_distance = range.map(|offset| (ahead(to, offset) - ahead(from, offset)).abs());
    within_half_turn(azimuth(to) - azimuth(from)).abs() + by_distance[0].max(by_distance[1])
}

/// A schedule that never turns back leads through intervals that overlap from place to place.
fn leads_through(places: &[OffsetPlace], range: [f64; 2]) -> bool {
    // Each interval, and the least angle that is reached in it.
    let mut reached: Vec<([f64; 2], f64)> = Vec::new();
    for (k, place) in places.iter().enumerate() {
        let here = place.free.iter().flat_map(|i| left(place, *i, range));
        reached = if k == 0 {
            here.map(|i| (i, i[0])).collect()
        } else {
            let slack = ends_go(&places[k - 1], place, range) + ROUNDING_RAD;
            let least = |[lo, hi]: [f64; 2]| {
                let joined = reached.iter().filter(|([a, b], _)| *a <= hi + slack && *b >= lo - slack);
                let at = joined.map(|(_, at)| at.max(lo)).fold(f64::INFINITY, f64::min);
                (at <= hi).then_some(([lo, hi], at))
            };
            here.filter_map(least).collect()
        };
        if reached.is_empty() {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::channel::Binding;
    use crate::numerics::angle::nearest_turn;
    use crate::observe::Silent;
    use crate::sample;

    /// Free angles about the azimuth of the ball centre.
    fn about(path: &Toolpath, width: impl Fn(usize) -> [f64; 2]) -> Vec<Vec<FreeInterval>> {
        let mut psi = 0.0;
        let one = |(k, l): (usize, &crate::artifact::toolpath::CutterLocation)| {
            psi = nearest_turn(l.centre.z.atan2(l.centre.y), psi);
            let [theta_min, theta_max] = width(k).map(|w| psi + w);
            let (binds_min, binds_max) = (Binding::Free, Binding::Free);
            vec![FreeInterval { theta_min, theta_max, binds_min, binds_max }]
        };
        path.locations.iter().enumerate().map(one).collect()
    }

    /// A round helix: the offset of an angle ahead of the centre by `w` is `ρ sin w`.
    fn round() -> Toolpath {
        let mut path = sample::plan(2, 360).toolpath;
        for (k, l) in path.locations.iter_mut().enumerate() {
            let psi = 0.0174 * k as f64;
            (l.centre.y, l.centre.z) = (20.0 * psi.cos(), 20.0 * psi.sin());
        }
        path
    }

    #[test]
    fn the_least_range_joins_what_two_places_ask_for() {
        let path = round();
        let n = path.locations.len();
        // One place asks for at least 0.3 rad ahead, another for 0.2 rad behind at most.
        let free = about(&path, |k| {
            if k == 100 {
                [0.3, 0.9]
            } else if k == n - 50 {
                [-0.9, -0.2]
            } else {
                [-1.0, 1.0]
            }
        });
        let found = least_travel(&path, &free, &Silent).unwrap().unwrap();
        let [low, high] = [20.0 * (-0.2f64).sin(), 20.0 * 0.3f64.sin()];
        assert!((found.half_mm - 0.5 * (high - low)).abs() < 0.006 * (high - low), "{found:?}");
        assert!((found.middle_mm - 0.5 * (high + low)).abs() < 0.06, "{found:?}");
        assert!(found.bound_mm <= 0.5 * (high - low) + 1e-6 && found.bound_mm > 0.98 * found.half_mm, "{found:?}");
    }

    #[test]
    fn where_one_offset_does_there_is_no_range() {
        let path = round();
        let free = about(&path, |_| [0.1, 0.5]);
        let found = least_travel(&path, &free, &Silent).unwrap().unwrap();
        assert!(found.half_mm < 0.01 && (2.0..9.6).contains(&found.middle_mm), "{found:?}");
        let closed = about(&path, |k| if k == 9 { [0.5, 0.4] } else { [0.0, 1.0] });
        let mut closed = closed;
        closed[9].clear();
        assert_eq!(least_travel(&path, &closed, &Silent).unwrap(), None);
    }

    #[test]
    fn no_range_that_is_tried_is_narrower() {
        let path = round();
        let free = about(&path, |k| {
            let f = k as f64;
            [-0.2 + 0.35 * (0.031 * f).sin(), 0.1 + 0.35 * (0.031 * f).sin() + 0.1 * (0.2 * f).cos()]
        });
        let found = least_travel(&path, &free, &Silent).unwrap().unwrap();
        let places: Vec<OffsetPlace> = path
            .locations
            .iter()
            .zip(&free)
            .map(|(l, f)| OffsetPlace {
                centre: l.centre,
                rho_mm: 20.0,
                free: f.iter().map(|f| [f.theta_min, f.theta_max]).collect(),
            })
            .collect();
        let mut narrowest = f64::INFINITY;
        for k in -200..200 {
            let low = 0.1 * f64::from(k);
            narrowest = narrowest.min(0.5 * (least_upper(low, 20.0, |r| leads_through(&places, r)) - low));
        }
        assert!(found.bound_mm <= narrowest && found.half_mm <= narrowest + 0.01 * narrowest, "{found:?} {narrowest}");
        assert!(found.half_mm > 0.5 && found.bound_mm > 0.98 * found.half_mm, "{found:?}");
    }
}
