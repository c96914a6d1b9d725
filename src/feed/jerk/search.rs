//! The fastest profile of the whole path, stretch by stretch: how fast a place can be passed is
//! decided near it.
//!
//! Three times. First every stretch is searched from the start profile, with speed and acceleration
//! at its ends as that has them, which is slow. Then the joints of the stretches are moved to the
//! middles of the first ones, where the first search has found how fast the path can be run, and
//! all is searched again, from that profile made a little slower: slower, every limit is kept with
//! room. At the joints it stays as slow as that. So the neighbourhood of every joint is searched
//! from there once more, and what is found is put in between places before and after the joint
//! where it has become what the second search found. So memory is that of a stretch, a place that
//! is hard to pass holds up nobody else, and stretches are searched at the same time.

use std::ops::Range;

use super::cells::greatest;
use super::rows::{Dual, Problem, Shares};
use super::window::{self, Found, Search};
use super::{bound, relaxed};
use crate::observe::Observer;
use crate::parallel;

/// Cells of a stretch at least …
const LENGTH: usize = 400;
/// … and this many times the way on which nine cells in ten can be brought to their speed from
/// rest.
const RAMPS: f64 = 8.0;
/// Joints are where the profile is slowest, up to this share of a stretch away.
const MOVE: f64 = 0.15;
/// ṡ² is made slower by this before the second search.
const SLOWER: f64 = 1.005;
/// ṡ² may be too great by this share; it is taken out of the whole.
const EXCESS: f64 = 1e-5;
/// Cells on either side of a joint that are searched once more, as a share of a stretch.
const NEAR: f64 = 0.125;
const FIRST: Search = Search {
    begin: 3.0,
    tolerance: 3e-2,
    further: 1.0,
    excess: 1e-2,
    shares: Shares { accelerations: 0.1, others: f64::NEG_INFINITY },
};
const SECOND: Search = Search {
    begin: 0.05,
    tolerance: 2e-5,
    further: 1e-5,
    excess: EXCESS,
    shares: Shares { accelerations: 0.3, others: f64::NEG_INFINITY },
};
/// The first bound is enough if the time is greater by no more than this share.
const GOOD: f64 = 5e-3;
/// Rounds of raising a bound: of the first and of the other.
const FEW: usize = 2;
const MANY: usize = 12;

/// What was found.
pub(super) struct Fastest {
    /// `(x, u, w)` at the start of every inner cell and at the end of the last.
    pub v: Vec<[f64; 3]>,
    /// A time that no profile is shorter than, as a share of this one's; 0 where it is not asked
    /// for.
    pub least: f64,
}

/// Multipliers of all cells and of the ties at all joints.
struct Multipliers {
    duals: Vec<Dual>,
    ties: Vec<f64>,
}

/// The fastest profile from a start within all limits. `None` where numbers are not finite, or when
/// the user has asked to stop.
pub(super) fn fastest(
    problem: &Problem,
    start: &[[f64; 3]],
    bounded: bool,
    observer: &dyn Observer,
) -> Option<Fastest> {
    let n = problem.inner.len();
    let length = length(problem);
    let mut v = start.get(..n)?.to_vec();
    let ranges = stretches(&v, length, 0.0);
    let found = all(&ranges, observer, |r| first(problem, r.clone(), &v[r]))?;
    for (r, found) in ranges.into_iter().zip(found) {
        let Some(found) = found else { continue };
        v[r].copy_from_slice(&found.v);
    }
    v.iter_mut().flatten().for_each(|x| *x /= SLOWER);
    let begin = v.clone();
    let ranges = stretches(&v, length, 0.5);
    let found = all(&ranges, observer, |r| second(problem, r.clone(), &begin[r]))?;
    let mut multipliers = Multipliers { duals: vec![Dual::default(); n], ties: vec![0.0; n] };
    for (r, found) in ranges.iter().zip(found) {
        let Some(found) = found else { continue };
        v[r.clone()].copy_from_slice(&found.v);
        multipliers.duals[r.clone()].copy_from_slice(&found.duals);
        multipliers.ties[r.clone()].copy_from_slice(&found.costates);
    }
    let near = (NEAR * length as f64) as usize;
    let joints: Vec<Range<usize>> =
        ranges[1..].iter().map(|r| r.start.saturating_sub(near)..(r.start + near).min(n)).collect();
    let found = all(&joints, observer, |r| second(problem, r.clone(), &begin[r]))?;
    for (r, found) in joints.into_iter().zip(found) {
        let Some((r, found)) = found.and_then(|f| fitted(problem, r, &v, f)) else { continue };
        v[r.clone()].copy_from_slice(&found.v);
        multipliers.duals[r.clone()].copy_from_slice(&found.duals);
        multipliers.ties[r].copy_from_slice(&found.costates);
    }
    let least = if bounded { least(problem, &v, multipliers, &ranges, observer)? } else { 0.0 };
    let h = problem.inner[n - 1].h;
    let [x, u, w] = v[n - 1];
    v.push([x + h * (2.0 * u + h * w), u + h * w, 0.0]);
    Some(Fastest { v, least })
}

/// The bound, as a share of the profile's time: by the search's own multipliers, which is enough
/// where the problem is nearly convex, or else by those of the relaxed problem, stretch by stretch.
fn least(
    problem: &Problem,
    v: &[[f64; 3]],
    multipliers: Multipliers,
    ranges: &[Range<usize>],
    observer: &dyn Observer,
) -> Option<f64> {
    let time = problem.time(0, v);
    let own = bound::least_time(problem, 0..v.len(), &multipliers.duals, &multipliers.ties, FEW) / time;
    if own >= 1.0 - GOOD {
        return Some(own);
    }
    let parts = all(ranges, observer, |r| {
        let (duals, ties) = relaxed::multipliers(problem, r.clone(), &v[r.clone()])
            .unwrap_or_else(|| (vec![Dual::default(); r.len()], vec![0.0; r.len()]));
        Some(bound::least_time(problem, r, &duals, &ties, MANY))
    })?;
    Some(own.max(parts.into_iter().flatten().sum::<f64>() / time))
}

/// What a search of each stretch finds. `None` when the user has asked to stop.
fn all<T: Send>(
    ranges: &[Range<usize>],
    observer: &dyn Observer,
    search: impl Fn(Range<usize>) -> Option<T> + Sync,
) -> Option<Vec<Option<T>>> {
    let found = parallel::map(ranges, |r| if observer.cancelled() { None } else { search(r.clone()) });
    (!observer.cancelled()).then_some(found)
}

fn first(problem: &Problem, range: Range<usize>, v: &[[f64; 3]]) -> Option<Found> {
    // What is too fast by less will be slower by more.
    within(problem, range, v, FIRST, 0.5 * (SLOWER - 1.0))
}

fn second(problem: &Problem, range: Range<usize>, v: &[[f64; 3]]) -> Option<Found> {
    within(problem, range, v, SECOND, EXCESS)
}

/// A faster profile, whose ṡ² is too great by no more than a share. With the rows that are near
/// their limits; where others turn out to be missed, with all.
fn within(problem: &Problem, range: Range<usize>, v: &[[f64; 3]], how: Search, share: f64) -> Option<Found> {
    let search = |how| {
        let found = window::search(problem, range.clone(), v, how)?;
        let faster = problem.time(range.start, &found.v) <= problem.time(range.start, v);
        (faster && excess(problem, range.start, &found.v) <= 1.0 + share).then_some(found)
    };
    search(how).or_else(|| search(Search { shares: Shares::ALL, ..how }))
}

/// By how much ṡ² is too great over cells from one on; infinite where a number is not finite.
fn excess(problem: &Problem, from: usize, v: &[[f64; 3]]) -> f64 {
    if !v.iter().flatten().all(|x| x.is_finite()) {
        return f64::INFINITY;
    }
    problem.inner[from..].iter().zip(v).map(|(c, v)| c.excess(v, problem.limits)).fold(0.0, f64::max)
}

/// The part of what was found over a range that can be put into a profile, by a crossing on either
/// side of the middle. `None` where the profiles do not come near enough to one another, or nothing
/// is gained.
fn fitted(problem: &Problem, range: Range<usize>, v: &[[f64; 3]], found: Found) -> Option<(Range<usize>, Found)> {
    let (old, middle) = (&v[range.clone()], range.len() / 2);
    let (a, into) = crossing(problem, range.start, 2..middle, old, &found.v)?;
    // The two cells of one crossing are not those of the other.
    let (b, back) = crossing(problem, range.start, middle.max(a + 2)..range.len(), &found.v, old)?;
    let part = a - 2..b;
    let at = range.start + part.start..range.start + part.end;
    let mut new = found.v[part.clone()].to_vec();
    new[..2].copy_from_slice(&into);
    new[part.len() - 2..].copy_from_slice(&back);
    let faster = problem.time(at.start, &new) < problem.time(at.start, &v[at.clone()]);
    let found = Found { v: new, duals: found.duals[part.clone()].to_vec(), costates: found.costates[part].to_vec() };
    faster.then_some((at, found))
}

/// Where one profile is nearest to another and two cells lead from it to that within the limits:
/// the cell after them, and they.
fn crossing(
    problem: &Problem,
    start: usize,
    among: Range<usize>,
    from: &[[f64; 3]],
    to: &[[f64; 3]],
) -> Option<(usize, [[f64; 3]; 2])> {
    let off = |i: usize| {
        let h = problem.inner[start + i].h;
        ((from[i][0] - to[i][0]).abs() + h * (from[i][1] - to[i][1]).abs()) / from[i][0]
    };
    let across = |i: usize| {
        let [g, h] = [i - 2, i - 1].map(|k| problem.inner[start + k].h);
        let ([x, u, _], [next_x, next_u, _]) = (from[i - 2], to[i]);
        let middle = (next_x - x - g * u - h * next_u) / (g + h);
        let cells = [[x, u, (middle - u) / g], [x + g * (u + middle), middle, (next_u - middle) / h]];
        (excess(problem, start + i - 2, &cells) <= 1.0 + EXCESS).then_some((i, cells))
    };
    let mut places: Vec<usize> = among.collect();
    places.sort_by(|a, b| off(*a).total_cmp(&off(*b)));
    places.into_iter().find_map(across)
}

/// Cells of a stretch.
fn length(problem: &Problem) -> usize {
    let mut ramps: Vec<f64> = Vec::with_capacity(problem.inner.len());
    for c in problem.inner {
        let u = (0..problem.limits.len())
            .map(|k| problem.limits[k][1] / greatest(c.axes[k].first()))
            .fold(f64::INFINITY, f64::min);
        ramps.push(0.5 * c.steady(problem.limits) / (u * c.h));
    }
    let most = ramps.len() * 9 / 10;
    let (_, ramp, _) = ramps.select_nth_unstable_by(most, f64::total_cmp);
    LENGTH.max((RAMPS * *ramp).min(problem.inner.len() as f64) as usize)
}

/// The path in stretches of about a length, moved by a share of it; they meet where the profile is
/// slow.
fn stretches(v: &[[f64; 3]], length: usize, by: f64) -> Vec<Range<usize>> {
    let n = v.len();
    let count = n / length;
    if count < 2 {
        return std::iter::once(0..n).collect();
    }
    let near = (MOVE * length as f64) as usize;
    let slowest = |at: usize| {
        let (from, to) = (at.saturating_sub(near).max(1), (at + near).min(n - 1));
        (from..to).min_by(|a, b| v[*a][0].total_cmp(&v[*b][0])).unwrap_or(at)
    };
    let joints = (0..count).map(|k| (k as f64 + by) / count as f64 * n as f64).filter(|at| *at > 0.0);
    let joints: Vec<usize> = joints.map(|at| slowest(at as usize)).collect();
    let starts = std::iter::once(0).chain(joints.iter().copied());
    starts.zip(joints.iter().copied().chain([n])).map(|(a, b)| a..b).collect()
}
