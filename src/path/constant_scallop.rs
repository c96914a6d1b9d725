//! Turns that are one another's constant-scallop neighbours at every point.
//!
//! The helix is its own neighbour: with `φ` the number of the turn plus the fraction of the way
//! round, `|∇φ| = 1/d` on the level set, where `d` is the distance that leaves the scallop `h`. So
//! each turn is laid from the turn beside it, touch by touch ([`super::march`]): straight across,
//! as far as leaves the ridge `h` ([`super::neighbour`], measured on the part). What one turn is
//! off by does not add up: the next is measured against where the last one is.
//!
//! * **End**: a height, a face that is named as the end, a wall that leans over too much, a sharp
//!   edge over which the ball would only roll (not one that runs up the blade and that turns go
//!   over), a corner in which it touches two walls, or one of them here and another there. Turns
//!   are laid down from a ring about the start height, coarsely, to find it: a place that has come
//!   to the end stays there until all have. The closed curve of those places is the last turn. The
//!   ring's contacts, not its ball centres, are at one height: round a thin edge that leans,
//!   centres at one height send the contact along the edge, and where the end is drawn along a turn
//!   all others would do the same.
//! * **Turns** are laid up from that curve, and run through in the reverse order. So they all run
//!   alongside the end, platform or edge, however it slants, and none is cut twice. The last turn
//!   of the helix comes onto the curve by a smooth ramp of 20 stepovers: where it is off by the
//!   share `u` of the stepover it leaves `h u²`. The turns above have the same ramp one over the
//!   other, so that only there and only between the last two turns anything is cut twice.
//! * **Beginning**: the helix begins with the lowest turn that is nowhere under the start height.
//!   Where the way up is longer on one side than on the other that turn slants: by a whole number
//!   of turns no region between two given curves can be cut with one scallop everywhere, unless
//!   their distance happens to be so many stepovers all round. Places more than [`HIGHEST`] of the
//!   region's height above the start are not cut but waited at.
//! * **Touches** of a turn thin out where the lines across the turns draw together and are added
//!   where they draw apart; a stretch that would run backwards (a front that has folded) is left
//!   out.
//! * **Meshes**: ridges over facets scatter about those of the part they stand for; where they
//!   would be too high, the way across is evened out along the turn.
//! * Where the ball loses the surface on the way down, or places have come to the end and others
//!   never do, the end is drawn along the last turn but one, which could be left everywhere. Where
//!   it loses the surface on the way up too, the helix ends at one of the turns not so far down,
//!   unless its end was asked for; where that does not help, the turns are those laid down from the
//!   start.

use std::f64::consts::FRAC_PI_2;

use rayon::prelude::*;

use super::bounds::{Bounds, Stop};
use super::curve::{self, LevelCurve};
use super::level::{LevelSet, Touch};
use super::march::{Laid, March, TurnNode};
use super::neighbour::Across;
use super::options::PathOptions;
use super::stepover::flat_stepover_mm;
use super::{chords, heights_mm, helix, place, rings, spot};
use crate::artifact::toolpath::EndReason;
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage, Stopped};
use crate::geometry::Point;
use crate::observe::Observer;

/// The scallop of the turns that only look for the end, over that of the path.
const COARSER: f64 = 4.0;
/// The same over the ball radius, at most, unless the path's own is more.
const COARSEST: f64 = 0.1;
/// The decisive ridge over the scallop asked for from which on ways over facets are evened out:
/// what is left over the surface, ridges and the ground between them, is lower then.
const MOST_SCALLOP: f64 = 1.1;
/// Distance of touches along a turn of the path, on exact faces and over facets: a share of the
/// stepover on flat ground, since turns that go round something as small as a stepover are shaped
/// by it, ...
const TOUCHES: [f64; 2] = [0.8, 0.25];
/// ... the same of the turns that look for the end over facets, ...
const TOUCHES_SEARCH: f64 = 0.5;
/// ... and so much turn of the normal where the ball rolls round an edge, rad.
const TOUCHES_RAD: [f64; 2] = [0.2, 0.125];
/// The share by which turns of the path are evened before the next is laid. Neighbours of a place
/// that runs ahead do so, too: all of it at once leaves ridges that are too low, and the next turn
/// swings back.
const BACK: [f64; 2] = [0.4, 0.3];
/// How far over the start height a place may be cut, as a share of the height of the region.
const HIGHEST: f64 = 0.5;
/// By so many stepovers places are waited at lower down where turns over the start height lose the
/// surface.
const WAITING: f64 = 2.0;
/// Where turns cannot be laid up from the end, they are from a turn not so far down: so many of
/// those that looked for the end are left out ...
const LEFT_OUT: [usize; 9] = [0, 1, 3, 5, 8, 12, 18, 27, 40];
/// ... as long as this share of the mean way from the start height down to the end is cut.
const LEAST_DEPTH: f64 = 0.7;
/// What the turns laid up from the end may lean over or lie under the bounds that the end was found
/// by: it lies on them.
const ROOM_RAD: f64 = 0.05;

/// Lays the helix from the height `start_x` down. Turns follow facets as they are, which are a part
/// of the shape where they are longer than a stepover; where ridges scatter too high over them
/// then, or no turns can be laid up from the end, ways are evened out.
pub(super) fn plan(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let lay = |evens_ways| lay(blade, level, options, start_x, evens_ways, observer);
    let plain = lay(false);
    if !level.is_over_facets() {
        return plain.map(|helix| helix.path);
    }
    let rank = |h: &Helix| (!h.is_from_end, h.path.planned_scallop_mm);
    match plain {
        Ok(helix) if rank(&helix) <= (false, MOST_SCALLOP * options.settings.scallop_mm) => Ok(helix.path),
        Err(e) if e.kind != ErrorKind::Infeasible => Err(e),
        plain => match (plain, lay(true)) {
            (_, Err(e)) if e.kind != ErrorKind::Infeasible => Err(e),
            (Ok(one), Ok(other)) => Ok(if rank(&other) < rank(&one) { other.path } else { one.path }),
            (one, other) => one.or(other).map(|helix| helix.path),
        },
    }
}

/// A path.
struct Helix {
    path: Toolpath,
    /// Whether its turns are laid up from its end.
    is_from_end: bool,
}

/// The helix, with its ways evened out or not.
fn lay(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    evens_ways: bool,
    observer: &dyn Observer,
) -> Result<Helix> {
    let mut how = rings::tracing(options);
    let flat_mm = flat_stepover_mm(options.radius_mm, options.settings.scallop_mm);
    // The ring's altered points, at one of which the path begins, are those of the blade and not of
    // its facets.
    how.max_step_mm = (0.25 * options.radius_mm).min(1.0).min(2.0 * flat_mm);
    let facets = usize::from(level.is_over_facets());
    let touches_mm = |share: f64| (TOUCHES_RAD[facets] * options.radius_mm).min(share * flat_mm).min(how.max_step_mm);
    let ring = rings::first_ring(blade, level, options, start_x, &how)?;
    let bounds = Bounds::of(&options.extent.ends, level.rim, options.settings.max_lean_deg.to_radians());
    let search = |scallop_mm| March {
        across: Across { level, bounds, min_step_mm: how.min_step_mm },
        scallop_mm,
        flat_mm: flat_stepover_mm(options.radius_mm, scallop_mm),
        // Round thin edges of exact faces coarse turns run up the part in folds where they follow
        // each bend: to find the end they need not.
        step_mm: if facets == 0 { how.max_step_mm } else { touches_mm(TOUCHES_SEARCH) },
        round_mm: ring.length_mm,
        back: 1.0,
        evens_ways,
        is_path: false,
    };
    let lowest = bounds.x_mm[0].max(heights_mm(blade, options)?[0]);
    let progress = |from: f64, share: f64, way: f64| {
        let done = (way / (start_x - lowest).max(options.radius_mm)).clamp(0.0, 1.0);
        observer.progress(Stage::Path, (from + share * done) as usize, 2000);
        observer.check(Stage::Path)
    };
    let lay_up = |end: &[Touch]| {
        let end_x = end.iter().map(|t| t.centre.x).fold(f64::INFINITY, f64::min);
        let mut highest = start_x + HIGHEST * (start_x - end_x);
        loop {
            let room = Bounds {
                x_mm: [f64::NEG_INFINITY, highest],
                max_sin_lean: (options.settings.max_lean_deg.to_radians() + ROOM_RAD).min(FRAC_PI_2).sin(),
                ends: &[],
                rim: None,
            };
            let plain = search(options.settings.scallop_mm);
            let up = March {
                across: Across { bounds: room, ..plain.across },
                step_mm: touches_mm(TOUCHES[facets]),
                back: BACK[facets],
                is_path: true,
                ..plain
            };
            let laid = up.lay(up.along(end), &|x| progress(300.0, 700.0, x - end_x), |turn| {
                turn.iter().all(|n| n.stop.is_some() || n.touch.centre.x >= start_x)
            })?;
            // Over the start height, near the tip, the surface may be lost to places that need not
            // be cut: they are waited at lower down.
            let lower = laid.lost.map(|p| p.x.min(highest) - WAITING * flat_mm);
            match lower.filter(|x| *x > start_x) {
                Some(x) => highest = x,
                None => return Ok(laid),
            }
        }
    };
    let mut down = Laid { turns: Vec::new(), lost: None };
    let coarse = (COARSEST * options.radius_mm / options.settings.scallop_mm).clamp(1.0, COARSER);
    let tries: &[f64] = if coarse > 1.0 { &[coarse, 1.0] } else { &[1.0] };
    let level_ring = search(tries[0] * options.settings.scallop_mm).at_one_contact_height(&ring.touches);
    let ring = level_ring.unwrap_or(ring.touches);
    for (k, coarser) in tries.iter().enumerate() {
        let open = bounds.x_mm[0] == f64::NEG_INFINITY;
        let lay_down = search(coarser * options.settings.scallop_mm);
        down = lay_down.find_end(&ring, open, &|x| progress(0.0, 300.0, start_x - x))?;
        let is_finest = k + 1 == tries.len();
        let mut reason = end_reason(blade, &down, options);
        let depth_mm = |end: &[Touch]| start_x - end.iter().map(|t| t.centre.x).sum::<f64>() / end.len() as f64;
        // A finer search, or ways that are evened out, may find an end from which turns can be laid
        // up. An end that was asked for stays.
        let may_end_higher = is_finest && evens_ways == (facets == 1) && options.extent.ends.is_empty();
        let mut deepest_mm = 0.0;
        let ends = if may_end_higher { &LEFT_OUT[..] } else { &LEFT_OUT[..1] };
        for left_out in ends {
            let kept = &down.turns[..down.turns.len().saturating_sub(*left_out)];
            let Some(mut end) = lay_down.end_of(kept, is_finest) else { continue };
            deepest_mm = depth_mm(&end).max(deepest_mm);
            if depth_mm(&end) < LEAST_DEPTH * deepest_mm {
                break;
            }
            end.reverse();
            let laid = lay_up(&end)?;
            if let Some(lost) = laid.lost {
                if *left_out == 0 {
                    let why = format!("turns from farther down would lose the surface at {}", place(blade, &lost));
                    reason = EndReason::Blocked(why);
                }
                continue;
            }
            let reversed = laid.turns.into_iter().rev().map(|t| t.into_iter().rev().collect()).collect();
            match finish(level, options, reversed, reason.clone(), observer) {
                Err(e) if e.kind == ErrorKind::Infeasible => {}
                done => return done.map(|path| Helix { path, is_from_end: true }),
            }
        }
    }
    let reason = end_reason(blade, &down, options);
    if down.turns.len() < 2 {
        let (by, at) = stopped(&down);
        let since = rings::not_one_turn(options, by, at.map(|p| spot(blade, &p)));
        return Err(Error::infeasible(Stage::Path, format!("not one whole turn fits: {reason}"), since)
            .advise(rings::no_turn_advice(down.lost.is_some())));
    }
    finish(level, options, down.turns, reason, observer).map(|path| Helix { path, is_from_end: false })
}

/// What ends the helix, and where.
fn stopped(laid: &Laid) -> (Stopped, Option<Point>) {
    if laid.lost.is_some() {
        return (Stopped::BallTooLarge, laid.lost);
    }
    match laid.last().iter().filter_map(|n| n.stop).find(|s| *s != Stop::Height) {
        Some(Stop::Lean(p)) => (Stopped::WallLeans, Some(p)),
        Some(Stop::Edge(p)) => (Stopped::Edge, Some(p)),
        Some(Stop::Face(p, face)) => (Stopped::Face(face), Some(p)),
        Some(Stop::Rim(p)) => (Stopped::Rim, Some(p)),
        Some(Stop::Corner(p)) => (Stopped::Corner, Some(p)),
        // Places that wait at the height, and others that never come to it.
        _ => match laid.last().iter().find(|n| n.stop.is_none()) {
            Some(free) if !laid.is_at_the_end() => (Stopped::NoNearer, Some(free.touch.centre)),
            _ => (Stopped::Region, None),
        },
    }
}

/// Why the helix ends, in words.
fn end_reason(blade: &Blade, laid: &Laid, options: &PathOptions) -> EndReason {
    let most_deg = options.settings.max_lean_deg;
    let (by, Some(p)) = stopped(laid) else { return EndReason::Region };
    let at = |why: String| format!("{why} at {}", place(blade, &p));
    EndReason::Blocked(match by {
        Stopped::WallLeans => {
            return EndReason::Lean(at(format!("the wall leans over more than {most_deg:.0}° from the blade axis")));
        }
        Stopped::Rim => rings::ends_without_platform(blade, &p),
        Stopped::Edge => at("the ball comes to an edge of the part".into()),
        Stopped::Face(face) => at(format!("the ball comes to face {}, which ends the region,", face + 1)),
        Stopped::Corner => at(format!("in the corner the ball meets a wall that leans over more than {most_deg:.0}°")),
        Stopped::NoNearer => at("turns come no nearer to the end of the region".into()),
        _ => at(format!("a ball of radius {} mm cannot follow the surface", options.radius_mm)),
    })
}

/// Whether a turn comes back to where it began.
fn is_closed(turn: &[Touch]) -> bool {
    turn.first().zip(turn.last()).is_some_and(|(a, b)| a.centre == b.centre)
}

/// From turns to locations.
fn finish(
    level: &LevelSet,
    options: &PathOptions,
    turns: Vec<Vec<TurnNode>>,
    reason: EndReason,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let turns: Vec<Vec<Touch>> = turns.iter().map(|t| t.iter().map(|n| n.touch).collect()).collect();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let filled: Vec<Vec<Touch>> = (0..turns.len())
        .into_par_iter()
        .map(|k| {
            observer.check(Stage::Path)?;
            let touches = &turns[k];
            let before = k.checked_sub(1).and_then(|b| turns[b].iter().rev().nth(1)).map(|t| &t.centre);
            // The last turn is closed, if the end was found.
            let on = turns.get(k + 1).or_else(|| is_closed(touches).then_some(touches));
            let after = on.and_then(|t| t.get(1)).map(|t| &t.centre);
            let curve = LevelCurve { level, touches, tangents: curve::tangents(before, touches, after) };
            let filled = chords::fill(level, |u| curve.at(u), &curve.places(options), options)?;
            let n = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
            observer.progress(Stage::Path, 1000 + 1000 * n / turns.len(), 2000);
            Ok(filled)
        })
        .collect::<Result<_>>()?;
    let highest = turns.first().into_iter().flatten().map(|t| t.centre.x).fold(f64::NEG_INFINITY, f64::max);
    let Some(last) = turns.last().and_then(|t| t.last()) else {
        return Err(Error::infeasible(Stage::Path, "no helix was laid", Infeasible::NoHelix));
    };
    let lowest = turns.last().into_iter().flatten().map(|t| t.centre.x).fold(last.centre.x, f64::min);
    let (path, _) = helix::assemble(level, options, &filled, *last, [highest, lowest], reason);
    Ok(path)
}
