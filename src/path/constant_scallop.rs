//! Turns that are one another's constant-scallop neighbours at every point.
//!
//! The helix is its own neighbour: with `φ` the number of the turn plus the fraction of the way
//! round, `|∇φ| = 1/d` on the level set, where `d` is the distance that leaves the scallop `h`. So
//! each turn is laid from the turn beside it, touch by touch ([`super::front`]): straight across,
//! as far as leaves the ridge `h` measured on the part. What one turn is
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
//!   region's height above the start are not cut but waited at. Where the region begins at faces,
//!   places that have come to them are waited at, as at the end, until all have: the helix begins
//!   with the closed curve of those places. The end is looked for from a ring amid the region then.
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

use super::bounds::{Bounds, Stop};
use super::curve::{self, LevelCurve};
use super::front::{Across, By, Fineness, Front, Laid, Node, PATIENCE, Rest};
use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use super::ring::{Ring, Tracing};
use super::{chords, heights_mm, helix, place, rings, spot, surface_end};
use crate::artifact::{Blade, Toolpath};
use crate::error::{EndReason, Error, ErrorKind, Infeasible, Result, Stage, Stopped};
use crate::geometry::{Point, Vector};
use crate::observe::{Doubt, Observer, Warning};
use crate::parallel;
use crate::tool::inclination::SPAN_RAD;

/// The scallop of the turns that only look for the end, over that of the path.
const COARSER: f64 = 4.0;
/// The same over the ball radius, at most, unless the path's own is more.
const COARSEST: f64 = 0.1;
/// The decisive ridge over the scallop asked for from which on ways over facets are evened out:
/// what is left over the surface, ridges and the ground between them, is lower then.
const MOST_SCALLOP: f64 = 1.1;
/// How far over the start height a place may be cut, as a share of the height of the region.
const HIGHEST: f64 = 0.5;
/// The blade of an impeller is higher at its one end than at the other, so that many turns would be
/// over the tips there: places are waited at so many stepovers above the start.
const WAITS_OVER_HUB: f64 = 0.05;
/// By so many stepovers places are waited at lower down where turns over the start height lose the
/// surface.
const WAITING: f64 = 2.0;
/// Where turns cannot be laid up from the end, they are from a turn not so far down: so many of
/// those that looked for the end are left out ...
const LEFT_OUT: [usize; 9] = [0, 1, 3, 5, 8, 12, 18, 27, 40];
/// ... as long as this share of the mean way from the start height down to the end is cut.
const LEAST_DEPTH: f64 = 0.7;
/// Under a cutter with a corner turns may run to and fro beside a place where it has no room, and
/// hardly come on. More than this many times those that looked for the end, and so many, are none.
const MOST_OF_DOWN: f64 = 2.0;
const FEW_TURNS: usize = 10;
/// First-order neighbours that are lost after fewer turns are no path.
const FEWEST_TURNS: usize = 3;
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
    neighbours(blade, level, options, start_x, By::Ridges, observer)
}

/// The same, the turns from the end up being neighbours of one another `by` another way.
pub(super) fn neighbours(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    by: By,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let lay = |evens_ways| {
        let laying = Laying::new(blade, level, options, start_x, evens_ways, observer)?;
        Laying { by, ..laying }.lay()
    };
    let helix = better_of(lay, level, options)?;
    if matches!(helix.ended_by, Stopped::CutsBeside { .. }) {
        let [a, b] = helix.path.region_x_mm;
        let doubt = Doubt::HelixEndsAbove {
            height_mm: a.min(b),
            reason: helix.path.end_reason.clone(),
            advice: "let it lean more with channel.contact_angle_max_deg, or take a narrower cutter or a larger corner"
                .into(),
        };
        observer.warn(Warning { stage: Stage::Path, doubt });
    }
    Ok(helix.path)
}

/// The helix whose turns follow facets as they are, or that whose ways are evened out.
fn better_of(lay: impl Fn(bool) -> Result<Helix>, level: &LevelSet, options: &PathOptions) -> Result<Helix> {
    let plain = lay(false);
    if !level.is_over_facets() {
        return plain;
    }
    let rank = |h: &Helix| (!h.is_from_end, h.path.planned_scallop_mm);
    match plain {
        Ok(helix) if rank(&helix) <= (false, MOST_SCALLOP * options.settings.scallop_mm) => Ok(helix),
        Err(e) if e.kind != ErrorKind::Infeasible => Err(e),
        plain => match (plain, lay(true)) {
            (_, Err(e)) if e.kind != ErrorKind::Infeasible => Err(e),
            (Ok(one), Ok(other)) => Ok(if rank(&other) < rank(&one) { other } else { one }),
            (one, other) => one.or(other),
        },
    }
}

/// A path.
struct Helix {
    path: Toolpath,
    /// Whether its turns are laid up from its end.
    is_from_end: bool,
    /// What ends it.
    ended_by: Stopped,
}

/// What became of turns that are laid up from an end.
enum Up {
    /// A path, and what ends it.
    Laid(Box<Toolpath>, Stopped),
    /// None; where the surface was lost.
    Lost(Option<Point>),
}

/// What a helix is laid by.
struct Laying<'a> {
    blade: &'a Blade,
    level: &'a LevelSet<'a>,
    options: &'a PathOptions,
    observer: &'a dyn Observer,
    /// Height from which it is laid down, mm.
    start_x: f64,
    /// The ring there.
    ring: Ring,
    bounds: Bounds<'a>,
    /// Lowest height that it may come to, mm.
    lowest_mm: f64,
    tracing: Tracing,
    /// Stepover on flat ground, mm.
    flat_mm: f64,
    evens_ways: bool,
    /// How turns are laid up from the end.
    by: By,
}

impl<'a> Laying<'a> {
    fn new(
        blade: &'a Blade,
        level: &'a LevelSet,
        options: &'a PathOptions,
        start_x: f64,
        evens_ways: bool,
        observer: &'a dyn Observer,
    ) -> Result<Self> {
        let flat_mm = options.flat_mm(options.settings.scallop_mm);
        let tracing = rings::tracing_along(options, flat_mm);
        let ring = rings::first_ring(blade, level, options, start_x, &tracing)?;
        let bounds =
            Bounds::of(level.along, &options.extent.ends, level.rim, options.settings.max_lean_deg.to_radians());
        // Where the region's end is asked for, or the cutter has no room from the start, the
        // channel is refused with the inclination that would do.
        let disc_fits = options.extent.ends.is_empty() && ring.touches.iter().all(|t| level.disc_fits(t));
        let bounds = Bounds { disc_fits, ..bounds };
        let lowest_mm = bounds.x_mm[0].max(heights_mm(blade, options)?[0]);
        Ok(Laying {
            blade,
            level,
            options,
            observer,
            start_x,
            ring,
            bounds,
            lowest_mm,
            tracing,
            flat_mm,
            evens_ways,
            by: By::Ridges,
        })
    }

    /// The helix, with its ways evened out or not: laid up from the first end that was found from
    /// which turns can be, or else down from the start.
    fn lay(self) -> Result<Helix> {
        let scallop_mm = self.options.settings.scallop_mm;
        let coarse = (COARSEST * self.options.radius_mm / scallop_mm).clamp(1.0, COARSER);
        let tries: &[f64] = if coarse > 1.0 { &[coarse, 1.0] } else { &[1.0] };
        let ring = self.search(tries[0] * scallop_mm).at_one_contact_height(&self.ring.touches);
        let ring = ring.unwrap_or_else(|| self.ring.touches.clone());
        let open = self.bounds.x_mm[0] == f64::NEG_INFINITY;
        let mut down = Laid { turns: Vec::new(), lost: None };
        let mut lost_on_the_way_up = None;
        for (k, coarser) in tries.iter().enumerate() {
            let search = self.search(coarser * scallop_mm);
            down = search.find_end(&ring, open, &|x| self.progress(0.0, 300.0, self.start_x - x))?;
            match self.laid_up(&search, &down, k + 1 == tries.len())? {
                Up::Laid(path, ended_by) => return Ok(Helix { path: *path, is_from_end: true, ended_by }),
                Up::Lost(at) => lost_on_the_way_up = at.or(lost_on_the_way_up),
            }
        }
        let ended_by = stopped(&down, self.options).0;
        Ok(Helix { path: self.laid_down(down, lost_on_the_way_up)?, is_from_end: false, ended_by })
    }

    /// The turns that only look for the end.
    fn search(&self, scallop_mm: f64) -> Front<'a> {
        let step_mm = self.fineness().touches_to_end.map_or(self.tracing.max_step_mm, |share| self.touches_mm(share));
        Front {
            across: Across { level: self.level, bounds: self.bounds, min_step_mm: self.tracing.min_step_mm },
            scallop_mm,
            flat_mm: self.options.flat_mm(scallop_mm),
            step_mm,
            round_edges_mm: self.round_edges_mm(step_mm),
            round_mm: self.ring.length_mm,
            back: self.fineness().back_to_end,
            evens_ways: self.evens_ways,
            is_path: false,
            by: By::Ridges,
        }
    }

    /// What is not the same over facets and on exact faces.
    fn fineness(&self) -> &'static Fineness {
        Fineness::of(self.level)
    }

    /// Distance of touches along a turn, mm, for a share of the stepover.
    fn touches_mm(&self, share: f64) -> f64 {
        let step_mm = (share * self.flat_mm).min(self.tracing.max_step_mm);
        if self.level.inclined.is_some() { step_mm } else { step_mm.min(self.edge_mm()) }
    }

    /// The same where the ball rolls round an edge: the corner of a cutter is far smaller than what
    /// it leaves on the ground.
    fn round_edges_mm(&self, step_mm: f64) -> f64 {
        if self.level.inclined.is_some() { step_mm.min(self.edge_mm()) } else { step_mm }
    }

    fn edge_mm(&self) -> f64 {
        self.fineness().touches_rad * self.options.radius_mm
    }

    fn height_mm(&self, p: &Point) -> f64 {
        self.level.along.height_mm(p)
    }

    fn progress(&self, from: f64, share: f64, way: f64) -> Result<()> {
        let done = (way / (self.start_x - self.lowest_mm).max(self.options.radius_mm)).clamp(0.0, 1.0);
        self.observer.progress(Stage::Path, (from + share * done) as usize, 2000);
        self.observer.check(Stage::Path)
    }

    /// The helix of turns laid up from the end that was found.
    fn laid_up(&self, search: &Front, down: &Laid, is_finest: bool) -> Result<Up> {
        let (mut ended_by, at) = stopped(down, self.options);
        let mut reason = end_reason(self.blade, (ended_by, at), self.options);
        let mean_mm = |end: &[Touch]| end.iter().map(|t| self.height_mm(&t.centre)).sum::<f64>() / end.len() as f64;
        let depth_mm = |end: &[Touch]| self.start_x - mean_mm(end);
        // A finer search, or ways that are evened out, may find an end from which turns can be laid
        // up. An end that was asked for stays.
        let may_end_higher =
            is_finest && self.evens_ways == self.level.is_over_facets() && self.options.extent.ends.is_empty();
        let (mut deepest_mm, mut lost) = (0.0, None);
        let finer = (search.scallop_mm / self.options.settings.scallop_mm).sqrt();
        let most_turns = match self.level.inclined {
            Some(_) => (MOST_OF_DOWN * finer * down.turns.len() as f64) as usize + FEW_TURNS,
            None => usize::MAX,
        };
        let ends = if may_end_higher { &LEFT_OUT[..] } else { &LEFT_OUT[..1] };
        for left_out in ends {
            let kept = &down.turns[..down.turns.len().saturating_sub(*left_out)];
            let Some(mut end) = search.end_of(kept, is_finest) else { continue };
            deepest_mm = depth_mm(&end).max(deepest_mm);
            if depth_mm(&end) < LEAST_DEPTH * deepest_mm {
                break;
            }
            end.reverse();
            let mut laid = self.lay_up(&end, most_turns)?;
            if self.by != By::Ridges
                && laid.turns.len() > FEWEST_TURNS
                && let Some(at) = laid.lost.take()
            {
                let doubt = Doubt::FirstOrderEnds { turns: laid.turns.len(), height_mm: self.height_mm(&at) };
                self.observer.warn(Warning { stage: Stage::Path, doubt });
            }
            if let Some(at) = laid.lost {
                lost = Some(at);
                if *left_out == 0 {
                    ended_by = Stopped::TurnsLoseSurface;
                    reason = end_reason(self.blade, (ended_by, Some(at)), self.options);
                }
                continue;
            }
            let reversed: Vec<Vec<Touch>> =
                laid.turns.iter().rev().map(|t| t.iter().rev().map(|n| n.touch).collect()).collect();
            let rings = self.by == By::FirstOrderRings;
            match finish(self.level, self.options, (&reversed, rings), reason.clone(), self.observer) {
                Err(e) if e.kind == ErrorKind::Infeasible => {}
                done => return done.map(|path| Up::Laid(Box::new(path), ended_by)),
            }
        }
        Ok(Up::Lost(lost))
    }

    /// Turns of the path from its end up, at most so many, until one is nowhere under the start
    /// height or runs along the faces at which the region begins.
    fn lay_up(&self, end: &[Touch], most_turns: usize) -> Result<Laid> {
        let (start_x, options) = (self.start_x, self.options);
        let end_x = end.iter().map(|t| self.height_mm(&t.centre)).fold(f64::INFINITY, f64::min);
        let to_faces = !self.options.extent.start_faces().is_empty();
        let above_mm = match self.level.along.round() {
            Some(_) => WAITS_OVER_HUB * self.flat_mm,
            None => HIGHEST * (start_x - end_x),
        };
        let mut highest = if to_faces { f64::INFINITY } else { start_x + above_mm };
        let mut rest = Rest::new(PATIENCE[1]);
        loop {
            let room = Bounds {
                along: self.level.along,
                x_mm: [f64::NEG_INFINITY, highest],
                max_sin_lean: (options.settings.max_lean_deg.to_radians() + ROOM_RAD).min(FRAC_PI_2).sin(),
                ends: self.options.extent.start_faces(),
                rim: None,
                disc_fits: false,
            };
            let plain = self.search(options.settings.scallop_mm);
            let step_mm = self.touches_mm(self.fineness().touches);
            let up = Front {
                across: Across { bounds: room, ..plain.across },
                step_mm,
                round_edges_mm: self.round_edges_mm(step_mm),
                back: if self.by == By::Ridges { self.fineness().back } else { 0.0 },
                is_path: true,
                by: self.by,
                ..plain
            };
            let is_over = |n: &Node| n.stop.is_some() || self.height_mm(&n.touch.centre) >= start_x;
            let mut count = 1;
            let mut laid = up.lay(up.along(end), &|x| self.progress(300.0, 700.0, x - end_x), |turn| {
                count += 1;
                count > most_turns || if to_faces { rest.stays(turn) } else { turn.iter().all(is_over) }
            })?;
            if count > most_turns {
                laid.lost = laid.last().iter().min_by(|a, b| a.way_mm.total_cmp(&b.way_mm)).map(|n| n.touch.centre);
                return Ok(laid);
            }
            if to_faces {
                let free = laid.last().iter().find(|n| n.stop.is_none());
                laid.lost = laid.lost.or(free.map(|n| n.touch.centre));
                return Ok(laid);
            }
            // Over the start height, near the tip, the surface may be lost to places that need not
            // be cut: they are waited at lower down.
            let lower = laid.lost.map(|p| self.height_mm(&p).min(highest) - WAITING * self.flat_mm);
            match lower.filter(|x| *x > start_x) {
                Some(x) => highest = x,
                None => return Ok(laid),
            }
        }
    }

    /// The helix of the turns that were laid down from the start.
    fn laid_down(&self, down: Laid, lost_on_the_way_up: Option<Point>) -> Result<Toolpath> {
        let (blade, options) = (self.blade, self.options);
        if self.by != By::Ridges {
            let at = lost_on_the_way_up.map_or_else(String::new, |p| format!(" at {}", place(blade, &p)));
            let since = rings::not_one_turn(options, Stopped::TurnsLoseSurface, None);
            let why = format!("no first-order neighbours lead up from the end of the region{at}");
            return Err(Error::infeasible(Stage::Path, why, since)
                .advise("set path.kind to constant-scallop, or end the region higher with region.end_mm"));
        }
        let reason = end_reason(blade, stopped(&down, options), options);
        if down.turns.len() < 2 {
            let (by, at) = stopped(&down, options);
            let since = rings::not_one_turn(options, by, at.map(|p| spot(blade, &p)));
            return Err(Error::infeasible(Stage::Path, format!("not one whole turn fits: {reason}"), since)
                .advise(rings::no_turn_advice(down.lost.is_some())));
        }
        if !self.options.extent.start_faces().is_empty() {
            let at = lost_on_the_way_up.or(down.lost);
            let since = rings::not_one_turn(options, Stopped::NoNearer, at.map(|p| spot(blade, &p)));
            let at = at.map_or_else(String::new, |p| format!(" at {}", place(blade, &p)));
            let why = format!("no turns lead from the end of the region up to the faces at which it begins{at}");
            return Err(Error::infeasible(Stage::Path, why, since).advise("give region.start_mm"));
        }
        let turns: Vec<Vec<Touch>> = down.turns.iter().map(|t| t.iter().map(|n| n.touch).collect()).collect();
        finish(self.level, options, (&turns, false), reason, self.observer)
    }
}

/// What ends the helix, and where.
fn stopped(laid: &Laid, options: &PathOptions) -> (Stopped, Option<Point>) {
    if laid.lost.is_some() {
        return (Stopped::BallTooLarge, laid.lost);
    }
    match laid.last().iter().filter_map(|n| n.stop).find(|s| *s != Stop::Height) {
        Some(Stop::Lean(p)) => (Stopped::WallLeans, Some(p)),
        Some(Stop::Edge(p)) => (Stopped::Edge, Some(p)),
        Some(Stop::Face(p, face)) => (Stopped::Face(face), Some(p)),
        Some(Stop::Rim(p)) => (Stopped::Rim, Some(p)),
        Some(Stop::Corner(p)) => (Stopped::Corner, Some(p)),
        Some(Stop::Disc(p)) => {
            let contact_deg = options.inclined.map_or(0.0, |i| i.contact_rad[1].to_degrees());
            (Stopped::CutsBeside { contact_deg, room_deg: SPAN_RAD.to_degrees() }, Some(p))
        }
        // Places that wait at the height, and others that never come to it.
        Some(Stop::Height) | None => match laid.last().iter().find(|n| n.stop.is_none()) {
            Some(free) if !laid.is_at_the_end() => (Stopped::NoNearer, Some(free.touch.centre)),
            _ => (Stopped::Region, None),
        },
    }
}

/// Why the helix ends.
fn end_reason(blade: &Blade, stop: (Stopped, Option<Point>), options: &PathOptions) -> EndReason {
    match stop {
        (by, Some(p)) => EndReason::Surface(surface_end(blade, by, &p, options)),
        (_, None) => EndReason::Region,
    }
}

/// Whether a turn comes back to where it began.
fn is_closed(turn: &[Touch]) -> bool {
    turn.first().zip(turn.last()).is_some_and(|(a, b)| a.centre == b.centre)
}

/// From turns to locations; closed rings are each gone round, with a way across to the next.
fn finish(
    level: &LevelSet,
    options: &PathOptions,
    (turns, are_rings): (&[Vec<Touch>], bool),
    reason: EndReason,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    let done = std::sync::atomic::AtomicUsize::new(0);
    let filled: Vec<Vec<Touch>> = parallel::try_map(0..turns.len(), |k| {
        observer.check(Stage::Path)?;
        let touches = &turns[k];
        let beside = |turn: usize| if are_rings { Some(touches) } else { turns.get(turn) };
        let before = k.checked_sub(1).or(are_rings.then_some(k)).and_then(beside);
        let before = before.and_then(|t| t.iter().rev().nth(1)).map(|t| &t.centre);
        // The last turn is closed, if the end was found.
        let on = beside(k + 1).or_else(|| is_closed(touches).then_some(touches));
        let after = on.and_then(|t| t.get(1)).map(|t| &t.centre);
        let fill = |touches: &[Touch], tangents: Vec<Vector>| {
            let curve = LevelCurve { level, touches, tangents };
            chords::fill(level, |u| curve.at(u), &curve.places(options), options)
        };
        let mut filled = fill(touches, curve::tangents(before, touches, after))?;
        if are_rings && let Some((last, first)) = touches.last().zip(turns.get(k + 1).and_then(|t| t.first())) {
            let across = [*last, *first];
            filled.extend(fill(&across, curve::tangents(None, &across, None))?);
        }
        let n = done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
        observer.progress(Stage::Path, 1000 + 1000 * n / turns.len(), 2000);
        Ok(filled)
    })?;
    let heights = |turn: Option<&Vec<Touch>>| -> Vec<f64> {
        turn.into_iter().flatten().map(|t| level.along.height_mm(&t.centre)).collect()
    };
    let highest = heights(filled.first()).into_iter().fold(f64::NEG_INFINITY, f64::max);
    let Some(last) = turns.last().and_then(|t| t.last()) else {
        return Err(Error::infeasible(Stage::Path, "no helix was laid", Infeasible::NoHelix));
    };
    let lowest = heights(filled.last()).into_iter().fold(level.along.height_mm(&last.centre), f64::min);
    let (path, _) = helix::assemble(level, options, &filled, *last, [highest, lowest], reason);
    Ok(path)
}
