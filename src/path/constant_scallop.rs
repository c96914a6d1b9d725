//! Turns that are one another's constant-scallop neighbours at every point.
//!
//! The helix is its own neighbour: with `φ` the number of the turn plus the fraction of the way round, `|∇φ| = 1/d` on the level
//! set, where `d` is the distance that leaves the scallop `h`. So each turn is laid from the turn before it, touch by touch:
//! straight across, as far as leaves the ridge `h` ([`super::neighbour`], measured on the part). What one turn is off by does not add
//! up: the next is measured against where the last one is.
//!
//! * **Beginning**: the ring at the start height is cut whole. The turn after it leaves it by a smooth ramp of [`RAMP_STEPOVERS`]: where it
//!   is off by the share `u` of the stepover it leaves `h u²`. The turns after that have the same ramp one below the other, so that only
//!   there and only between the first two turns anything is cut twice.
//! * **End**: where a place has come to the region's end (a height, a wall that leans over too much, a sharp edge over which the ball
//!   would only roll, a corner in which it touches two walls) it stays there and the turns after it run along the end, until a whole turn does. Turns tilt
//!   where the way down is longer on one side than on the other; places that come first then wait, for as many turns as they are
//!   ahead. Where the end is left open, they wait for a few turns only, and the helix ends short of it on the other side. The last
//!   turn ends where the last place has come to the end: the rest of it was cut by the turn before.
//! * **Touches** of a turn thin out where the lines across the turns draw together and are added where they draw apart; a stretch
//!   that would run backwards (a front that has folded) is left out.
//! * **Meshes**: the ridge over facets scatters about that of the part they stand for; the way across is evened out along the turn.

use rayon::prelude::*;

use super::curve::{self, Curve};
use super::level::{LevelSet, Touch};
use super::neighbour::{Across, Bounds, Next, Place, Stop};
use super::nodes::arc_lengths;
use super::options::PathOptions;
use super::stepover::flat_stepover_mm;
use super::{chords, helix, place, rings};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::observe::{Observer, Warning};

/// More turns than this is a mistake in the options.
const MOST_TURNS: usize = 20_000;

/// Ways shorter than this share of the flat stepover are none: the ball is stuck.
const STUCK: f64 = 1e-2;
/// Length of the ramp from a turn to the next, in stepovers on flat ground: steep enough to be short, and so gentle that the path tilts by
/// less than 6° and its radius in the surface is over 60 stepovers.
const RAMP_STEPOVERS: f64 = 20.0;
/// Nodes of the closed ring that are left by less than this share of a stepover stay.
pub(super) const LEAST_SHARE: f64 = 1e-3;
/// Turns that run along the end in part before a path whose end was left open ends.
const MOST_WAITING: usize = 4;

/// A touch of a turn, with how it came from the turn before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) touch: Touch,
    /// Way from the turn before, mm.
    pub(super) way_mm: f64,
    /// Why it is at the end of the region.
    pub(super) stop: Option<Stop>,
    /// Whether the turn before was at the end here already.
    pub(super) waits: bool,
}

/// Turns laid, the last node of each being the first of the next.
struct Laid {
    turns: Vec<Vec<Node>>,
    /// Where a turn could not go on.
    lost: Option<Point>,
}

/// Lays turns from one ring down.
pub(super) struct March<'a> {
    pub(super) across: Across<'a>,
    pub(super) options: &'a PathOptions,
    /// Stepover on flat ground, mm.
    pub(super) flat_mm: f64,
    /// Usual distance of touches along a turn, mm.
    pub(super) step_mm: f64,
    /// Whether the part is a mesh.
    facets: bool,
}

/// Lays the helix from the height `start_x` down.
pub(super) fn plan(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let flat_mm = flat_stepover_mm(options.radius_mm, options.scallop_mm);
    let mut how = rings::tracing(options);
    how.max_step_mm = (0.25 * options.radius_mm).min(1.0).min(2.0 * flat_mm);
    let ring = rings::first_ring(blade, level, options, start_x, &how)?;
    let bounds = Bounds {
        lowest_x_mm: options.region_x_mm[1].unwrap_or(f64::NEG_INFINITY),
        max_sin_lean: options.max_lean_rad.sin(),
    };
    let march = March {
        across: Across { level, bounds, min_step_mm: how.min_step_mm },
        options,
        flat_mm,
        step_mm: how.max_step_mm,
        facets: level.part.brep.is_none(),
    };
    let lowest = bounds.lowest_x_mm.max(blade.regions.airfoil_x_mm[0]);
    let progress = |x_mm: f64| {
        let done = ((start_x - x_mm) / (start_x - lowest).max(march.flat_mm)).clamp(0.0, 1.0);
        observer.progress(Stage::Path, (1000.0 * done) as usize, 2000);
        observer.check(Stage::Path)
    };
    let laid = march.lay(&ring.touches, progress)?;
    if laid.turns.len() < 2 {
        return Err(Error::infeasible(
            Stage::Path,
            format!("not one whole turn fits: {}", end_reason(blade, &laid, options)),
        )
        .advise("start higher with region.start_mm, or take a smaller ball"));
    }
    let reason = end_reason(blade, &laid, options);
    finish(level, options, &laid, reason, observer)
}

/// Why the helix ends, in words.
fn end_reason(blade: &Blade, laid: &Laid, options: &PathOptions) -> String {
    if let Some(p) = laid.lost {
        return format!("a ball of radius {} mm cannot follow the surface at {}", options.radius_mm, place(blade, &p));
    }
    let stops = laid.turns.last().into_iter().flatten().filter_map(|n| n.stop);
    let early = stops.into_iter().find(|s| *s != Stop::Height);
    match early {
        Some(Stop::Lean(p)) => format!(
            "the wall leans over more than {:.0}° from the blade axis at {}",
            options.max_lean_rad.to_degrees(),
            place(blade, &p)
        ),
        Some(Stop::Edge(p)) => format!("the ball comes to an edge of the part at {}", place(blade, &p)),
        Some(Stop::Corner(p)) => format!(
            "in the corner the ball meets a wall that leans over more than {:.0}° at {}",
            options.max_lean_rad.to_degrees(),
            place(blade, &p)
        ),
        _ => "the end of the region".into(),
    }
}

/// From turns to locations.
fn finish(
    level: &LevelSet,
    options: &PathOptions,
    laid: &Laid,
    reason: String,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let turns: Vec<Vec<Touch>> = laid.turns.iter().map(|t| t.iter().map(|n| n.touch).collect()).collect();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let filled: Vec<Vec<Touch>> = (0..turns.len())
        .into_par_iter()
        .map(|k| {
            observer.check(Stage::Path)?;
            let touches = &turns[k];
            let before = k.checked_sub(1).and_then(|b| turns[b].iter().rev().nth(1)).map(|t| &t.centre);
            let after = turns.get(k + 1).and_then(|t| t.get(1)).map(|t| &t.centre);
            let curve = Curve { level, touches, tangents: curve::tangents(before, touches, after) };
            let filled = chords::fill(|u| curve.at(u), &curve.places(options), options)?;
            let n = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
            observer.progress(Stage::Path, 1000 + 1000 * n / turns.len(), 2000);
            Ok(filled)
        })
        .collect::<Result<_>>()?;
    let ends = turns.first().and_then(|t| t.first()).zip(turns.last().and_then(|t| t.last()));
    let Some((first, last)) = ends else { return Err(Error::infeasible(Stage::Path, "no helix was laid")) };
    let lowest = laid.turns.last().into_iter().flatten().map(|n| n.touch.centre.x).fold(last.centre.x, f64::min);
    if let Some(end_mm) = options.region_x_mm[1].filter(|_| reason != "the end of the region") {
        observer.warn(Warning {
            stage: Stage::Path,
            message: format!(
                "the helix ends at height {lowest:.3} mm instead of region.end_mm = {end_mm} mm: {reason}"
            ),
        });
    }
    let (path, _) = helix::assemble(level, options, &filled, *last, [first.centre.x, lowest], reason);
    Ok(path)
}

impl March<'_> {
    /// Lays turns until one runs along the end all the way, or the surface is lost.
    fn lay(&self, ring: &[Touch], progress: impl Fn(f64) -> Result<()>) -> Result<Laid> {
        let node = |t: &Touch| Node { touch: *t, way_mm: self.flat_mm, stop: None, waits: false };
        let first: Vec<Node> = ring.iter().chain(ring.first()).map(node).collect();
        let mut turns = vec![self.tidy(first)];
        while let Some(last) = turns.last() {
            progress(last[0].touch.centre.x)?;
            if turns.len() > 1 && last.iter().all(|n| n.stop.is_some()) {
                close(&mut turns);
                break;
            }
            let waiting = turns.iter().rev().take_while(|t| t.iter().any(|n| n.stop.is_some())).count();
            if waiting > MOST_WAITING && self.options.region_x_mm[1].is_none() {
                break;
            }
            let laid = turns.len();
            let (before, last) = turns.split_at_mut(laid - 1);
            match self.next_turn(before.last(), &mut last[0]) {
                Ok(next) => turns.push(next),
                Err(lost) => {
                    // The turn before the loss has gone as far as the ball could, past where its neighbours can follow.
                    if turns.len() > 3 {
                        turns.pop();
                    }
                    return Ok(Laid { turns, lost: Some(lost) });
                }
            }
            if turns.len() > MOST_TURNS {
                return Err(Error::infeasible(Stage::Path, format!("more than {MOST_TURNS} turns would be needed"))
                    .advise("allow a larger scallop or a smaller region"));
            }
        }
        Ok(Laid { turns, lost: None })
    }

    /// The turn after `turn`; without a turn `before` it, `turn` is closed and left slowly. `Err`: where the ball cannot go on.
    fn next_turn(&self, before: Option<&Vec<Node>>, turn: &mut Vec<Node>) -> std::result::Result<Vec<Node>, Point> {
        let n = turn.len() - 1;
        let centre = |k: usize| turn[k].touch.centre;
        let back = before.map_or(centre(n - 1), |b| b[b.len() - 2].touch.centre);
        let closed = before.is_none();
        let shares = if closed { ramp(turn, RAMP_STEPOVERS * self.flat_mm) } else { vec![1.0; n + 1] };
        let touches: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        let ahead = centre(1);
        let along = curve::tangents(Some(&back), &touches, closed.then_some(&ahead));
        let mut next: Vec<Option<Node>> =
            (0..=n).into_par_iter().map(|i| self.next_node(&turn[i], along[i], shares[i])).collect();
        next[0] = Some(turn[n]);
        if !closed && let Some(start) = next[1] {
            // The way on from the last touch is known only now: to the first of the new turn.
            let on = curve::tangent(Some(&centre(n - 1)), &turn[n].touch, Some(&start.touch.centre));
            next[n] = self.next_node(&turn[n], on, 1.0);
        }
        if self.facets {
            next = self.even_out(turn, &along, &shares, next);
        }
        let kept = self.without_folds(turn, &along, &next)?;
        Ok(self.tidy(kept))
    }

    /// The neighbour of one node, at the share `share` of the stepover.
    fn next_node(&self, node: &Node, along: Vector, share: f64) -> Option<Node> {
        if node.stop.is_some() || share < LEAST_SHARE {
            return Some(Node { way_mm: self.flat_mm, waits: node.stop.is_some(), ..*node });
        }
        let from = Place { touch: node.touch, along };
        let h_mm = self.options.scallop_mm * share * share;
        let Next { touch, way_mm, stop } = self.across.neighbour(&from, h_mm, node.way_mm * share)?;
        if stop.is_none() && way_mm < STUCK * share * self.flat_mm {
            return None;
        }
        // A last, shortened way says nothing about the next.
        Some(Node { touch, way_mm: if stop.is_some() { node.way_mm } else { way_mm / share }, stop, waits: false })
    }
}

/// Cuts off the part of the last turn that the turn before has cut already. A short rest is joined to the turn before, so that the last turn
/// still goes all the way round.
fn close(turns: &mut Vec<Vec<Node>>) {
    let Some(last) = turns.last() else { return };
    let cut_before = last.iter().rev().take_while(|n| n.waits).count();
    let needed = (last.len() + 1).saturating_sub(cut_before).clamp(2, last.len());
    if turns.len() > 2 && 2 * needed < last.len() {
        let rest = turns.pop().unwrap_or_default();
        turns.last_mut().into_iter().for_each(|t| t.extend_from_slice(&rest[1..needed]));
    }
}

/// Shares of the stepover by which a turn leaves the ring before it: from 0 to 1 with continuous curvature over the ramp's length.
fn ramp(turn: &[Node], ramp_mm: f64) -> Vec<f64> {
    let s_mm = arc_lengths(turn);
    let whole = s_mm.last().copied().unwrap_or(0.0).min(ramp_mm).max(1e-12);
    let smooth = |t: f64| t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    s_mm.iter().map(|s| smooth((s / whole).min(1.0))).collect()
}
