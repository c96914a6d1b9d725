//! Between the places: the walls hold for the whole motion, or are moved inwards until they do.
//!
//! Between two places the ball centre moves straight and the tool may turn along any line of the
//! (time, θ) plane between a lower and an upper wall that are straight from place to place. In a
//! frame that turns along the lower wall that wall is one angle, and the search over the move
//! ([`super::forbidden::Search::free_moving`]) gives an interval that is free during the whole
//! move: how far its lower end lies above the wall is how far the wall must be moved in. Likewise
//! for the upper wall. The two intervals together cover all that is between the moved walls; where
//! they do not, one frame serves both.

use std::f64::consts::TAU;

use crate::error::{Result, Stage};
use crate::geometry::Vector;
use crate::observe::Observer;
use crate::parallel;

use super::arcs::{Arc, Witness, push_wrapped};
use super::forbidden::{Free, MOVE_TOLERANCES, ObstacleScene, PlaceSearch, Start, View};
use super::region::{EvenMove, turned_about_x};
use super::samples::Sample;
use super::sight::Sight;

/// Parts in which a move is looked at, at most.
const MOST_PARTS: f64 = 1000.0;

/// How far the walls of a move must be moved inwards at both its ends, rad, and what makes that
/// necessary.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lift {
    pub lo: f64,
    pub hi: f64,
    pub lo_by: Witness,
    pub hi_by: Witness,
}

/// The lifts of the moves that are wanted, by the place where they end, none of the others; the
/// inner error is a move during which the channel closes.
pub(super) fn lifts(
    scene: &ObstacleScene,
    samples: &[Sample],
    chosen: &[&Free],
    wanted: impl Fn(usize) -> bool + Sync,
    observer: &dyn Observer,
) -> Result<std::result::Result<Vec<Lift>, usize>> {
    let moves: Vec<usize> = (1..samples.len()).collect();
    let some = |moves: &[usize]| -> Result<Vec<Option<Lift>>> {
        observer.check(Stage::Channel)?;
        let mut search = PlaceSearch::new(scene);
        let one = |&i: &usize| {
            let (from, to) = ((&samples[i - 1], chosen[i - 1]), (&samples[i], chosen[i]));
            if !wanted(i) {
                return Some(Lift { lo: 0.0, hi: 0.0, lo_by: from.1.lo_by, hi_by: from.1.hi_by });
            }
            lift(&mut search, scene, from, to, None)
        };
        Ok(moves.iter().map(one).collect())
    };
    let all: Vec<Vec<Option<Lift>>> = parallel::try_map(moves.chunks(64), some)?;
    let all: Vec<Option<Lift>> = all.into_iter().flatten().collect();
    Ok(match all.iter().position(Option::is_none) {
        Some(i) => Err(i),
        None => Ok(all.into_iter().flatten().collect()),
    })
}

/// The intervals chosen at both ends, moved inwards as both moves beside each place ask for.
pub(super) fn moved_in(chosen: &[&Free], lifts: &[Lift]) -> Vec<Free> {
    let mut out: Vec<Free> = chosen.iter().map(|f| **f).collect();
    for (k, f) in out.iter_mut().enumerate() {
        let beside = [k.checked_sub(1).and_then(|i| lifts.get(i)), lifts.get(k)];
        let (lo, hi) = (f.lo, f.hi);
        for l in beside.into_iter().flatten() {
            if lo + l.lo > f.lo {
                (f.lo, f.lo_by) = (lo + l.lo, l.lo_by);
            }
            if hi - l.hi < f.hi {
                (f.hi, f.hi_by) = (hi - l.hi, l.hi_by);
            }
        }
    }
    out
}

/// One move, in frames that turn along its walls.
struct WallMove<'a> {
    from: (&'a Sample, &'a Free),
    to: (&'a Sample, &'a Free),
    /// Angle of all frames in the middle.
    azimuth: f64,
}

/// The part from one share of the way to another of the move from a place to the next, in a frame
/// that turns by ± `turn` about the cone's axis on the whole of it.
pub(super) fn even_move(from: &Sample, to: &Sample, turn: f64, [start, end]: [f64; 2]) -> View {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let cone = from.cone.between(&to.cone, middle);
    let azimuth = 0.5 * (from.azimuth + to.azimuth) + turn * (2.0 * middle - 1.0);
    let sight = Sight::of(&cone);
    let in_view = |v: &Vector| turned_about_x(&sight.seen(v), -azimuth);
    let way = to.centre - from.centre;
    let motion = EvenMove {
        half_move: in_view(&(way * half)),
        half_turn: 2.0 * turn * half,
        half_frame: in_view(&(from.cone.rotation_to(&to.cone) * half)),
        sway: (to.cone.lean_rad - from.cone.lean_rad).abs() * half,
    };
    View { centre: from.centre + way * middle, cone, azimuth, within_rad: None, motion }
}

fn lift(
    search: &mut PlaceSearch,
    scene: &ObstacleScene,
    from: (&Sample, &Free),
    to: (&Sample, &Free),
    starts: Option<&[Start]>,
) -> Option<Lift> {
    let m = WallMove { from, to, azimuth: 0.5 * (from.0.azimuth + to.0.azimuth) };
    let tolerance = MOVE_TOLERANCES * scene.options.settings.tolerance_deg.to_radians();
    let (low, high) = (0.5 * (to.1.lo - from.1.lo), 0.5 * (to.1.hi - from.1.hi));
    let mut free_at = |turn: f64| m.widest(search, turn, tolerance, starts);
    let lift = if (low - high).abs() <= 0.1 * tolerance {
        let mean = 0.5 * (low + high);
        let f = free_at(mean)?;
        m.lift((f, mean), (f, mean))
    } else {
        let (l, h) = ((free_at(low)?, low), (free_at(high)?, high));
        let covered = [-1.0, 1.0].iter().all(|t| l.0.hi + l.1 * t >= h.0.lo + h.1 * t);
        if covered {
            m.lift(l, h)
        } else {
            let mean = 0.5 * (low + high);
            let f = free_at(mean)?;
            m.lift((f, mean), (f, mean))
        }
    };
    let open = |f: &Free| f.lo + lift.lo <= f.hi - lift.hi;
    (open(from.1) && open(to.1)).then_some(lift)
}

impl WallMove<'_> {
    /// The free interval of the whole move that has most in common with those of both ends, in a
    /// frame that turns by ± `turn`.
    fn widest(&self, search: &mut PlaceSearch, turn: f64, tolerance: f64, starts: Option<&[Start]>) -> Option<Free> {
        let (a, b) = (self.seen(self.from.1, -turn), self.seen(self.to.1, turn));
        let (lo, lo_by) = if a.lo > b.lo { (a.lo, a.lo_by) } else { (b.lo, b.lo_by) };
        let (hi, hi_by) = if a.hi < b.hi { (a.hi, a.hi_by) } else { (b.hi, b.hi_by) };
        if lo > hi {
            return None;
        }
        let mut taken: Vec<Arc> = Vec::new();
        let (start, end) = (hi + 0.5 * tolerance, lo - 0.5 * tolerance + TAU);
        if start < end {
            // Into the circle that the search looks at.
            let turns = ((start + std::f64::consts::PI) / TAU).floor() * TAU;
            push_wrapped(start - turns, end - turns, hi_by, lo_by, &mut taken);
        }
        let mut left = vec![Free { lo, hi, lo_by, hi_by }];
        let parts = self.parts(tolerance);
        for k in 0..parts {
            let share = [k, k + 1].map(|k| k as f64 / parts as f64);
            let found = search.free_moving(&even_move(self.from.0, self.to.0, turn, share), &taken, starts);
            left = left.iter().flat_map(|within| common(within, &found)).collect();
        }
        let mut best: Option<Free> = None;
        for piece in left {
            if best.is_none_or(|b| piece.hi - piece.lo > b.hi - b.lo) {
                best = Some(piece);
            }
        }
        best
    }

    /// In how many parts the move is looked at: a lean that changes is taken as that in the middle
    /// of a part.
    fn parts(&self, tolerance: f64) -> usize {
        let lean = (self.to.0.cone.lean_rad - self.from.0.cone.lean_rad).abs();
        (lean / (0.2 * tolerance)).ceil().clamp(1.0, MOST_PARTS) as usize
    }

    /// The interval of an end as seen in a frame that is turned by `turn` there.
    fn seen(&self, f: &Free, turn: f64) -> Free {
        Free { lo: f.lo - self.azimuth - turn, hi: f.hi - self.azimuth - turn, ..*f }
    }

    /// How far the walls lie outside: the lower one of the first interval, the upper one of the
    /// second, each with its frame.
    fn lift(&self, (low, low_turn): (Free, f64), (high, high_turn): (Free, f64)) -> Lift {
        let ends = [(-1.0, self.from.1), (1.0, self.to.1)];
        let lo = ends.map(|(t, f)| low.lo - self.seen(f, low_turn * t).lo);
        let hi = ends.map(|(t, f)| self.seen(f, high_turn * t).hi - high.hi);
        Lift { lo: lo[0].max(lo[1]).max(0.0), hi: hi[0].max(hi[1]).max(0.0), lo_by: low.lo_by, hi_by: high.hi_by }
    }
}

/// What intervals on the circle have in common with one, in their order.
fn common(within: &Free, found: &[Free]) -> Vec<Free> {
    let mut out = Vec::new();
    for f in found {
        for k in [-TAU, 0.0, TAU] {
            let piece = Free { lo: (f.lo + k).max(within.lo), hi: (f.hi + k).min(within.hi), ..*f };
            if piece.hi - piece.lo >= 0.0 {
                out.push(piece);
            }
        }
    }
    out
}
