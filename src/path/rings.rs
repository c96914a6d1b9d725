//! The stack of rings that guides the helix: from the start height down, each pitch as large as the
//! scallop allows.

use super::bounds::lowest_mm;
use super::level::{LevelSet, Touch};
use super::options::PathOptions;
use super::ring::{self, Broken, Ring, Tracing};
use super::stepover::{Pass, decisive_mm, ridge_height};
use super::{heights_mm, place, region, seed, spot, surface_end};
use crate::artifact::Blade;
use crate::error::{EndReason, Error, Infeasible, Result, Spot, Stage, Stopped, SurfaceEnd};
use crate::geometry::Point;
use crate::observe::Observer;
use crate::parallel;
use crate::tool::stepover::flat_stepover_mm;

/// A concave stretch counts when the normal turns back by this much, rad: well over what facets and
/// slivers do.
const CONCAVE_TURN_RAD: f64 = 0.035;
/// More rings than this is a mistake in the options.
const MOST_RINGS: usize = 20_000;

/// The scallop that the pitch aims at, by height.
pub(super) struct Aim {
    pub(super) target_mm: f64,
    /// Heights (lower, upper) and the factor there.
    caps: Vec<([f64; 2], f64)>,
}

impl Aim {
    /// The same everywhere.
    pub(super) fn new(target_mm: f64) -> Self {
        Aim { target_mm, caps: Vec::new() }
    }

    /// Aims lower by `factor` between two heights, on top of what is asked for there already.
    pub(super) fn cap(&mut self, heights: [f64; 2], factor: f64) {
        let so_far = self.at(heights) / self.target_mm;
        self.caps.push((heights, factor * so_far));
    }

    /// What to aim at for passes between two heights, mm.
    pub(super) fn at(&self, [lower, upper]: [f64; 2]) -> f64 {
        let there = self.caps.iter().filter(|([lo, hi], _)| *lo < upper && *hi > lower);
        self.target_mm * there.map(|(_, f)| *f).fold(1.0, f64::min)
    }
}

/// Rings from the start height down, and why the last one is the last.
pub struct Stack {
    /// At least two.
    pub rings: Vec<Ring>,
    /// In words.
    pub end_reason: EndReason,
}

/// Lays rings below those that there are, at least one.
pub fn lay(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    mut rings: Vec<Ring>,
    aim: &Aim,
    observer: &dyn Observer,
) -> Result<Stack> {
    let how = tracing(options);
    let start_x = rings[0].x_mm;
    let lowest = lowest_mm(&options.extent.ends);
    let flat = options.flat_mm(aim.target_mm);
    let mut pitch = match rings[..] {
        [.., ref a, ref b] => a.x_mm - b.x_mm,
        _ => flat,
    };
    let height = (start_x - lowest.max(heights_mm(blade, options)?[0])).max(flat);
    let end = loop {
        observer.check(Stage::Path)?;
        let last = &rings[rings.len() - 1];
        observer.progress(Stage::Path, (1000.0 * ((start_x - last.x_mm) / height).min(1.0)) as usize, 2000);
        if last.x_mm - lowest <= 1e-9 {
            break None;
        }
        match next_ring(level, last, pitch, aim, lowest, &how) {
            Ok((ring, used)) => {
                // Pitch may grow again where the wall stands up, but not from a last, shortened
                // turn.
                pitch = used.max(0.02 * flat);
                rings.push(ring);
            }
            Err(broken) => break Some(broken),
        }
        if rings.len() > MOST_RINGS {
            let since = Infeasible::TooManyTurns { most: MOST_RINGS, scallop_mm: options.settings.scallop_mm };
            return Err(Error::infeasible(Stage::Path, format!("more than {MOST_RINGS} turns would be needed"), since)
                .advise("allow a larger scallop or a smaller region"));
        }
    };
    finish(blade, options, rings, end)
}

/// How finely rings are traced for a path.
pub fn tracing(options: &PathOptions) -> Tracing {
    Tracing {
        max_step_mm: options.settings.max_step_mm,
        max_turn_rad: 0.12,
        min_step_mm: (1e-3 * options.radius_mm).min(0.25 * options.settings.max_step_mm),
        min_cos_lean: options.settings.max_lean_deg.to_radians().cos(),
    }
}

/// How finely the first ring is traced for turns of constant scallop, with their stepover on flat
/// ground: its altered points, at one of which the path begins, are those of the blade and not of
/// its facets.
pub fn tracing_along(options: &PathOptions, flat_mm: f64) -> Tracing {
    // Round an edge the ball turns by little from touch to touch anyway, and a corner of a cutter
    // may be far smaller than what it leaves on the ground.
    let of_ball = if options.inclined.is_some() { f64::INFINITY } else { 0.25 * options.radius_mm };
    Tracing { max_step_mm: of_ball.min(1.0).min(2.0 * flat_mm), ..tracing(options) }
}

/// Says why the stack ended and refuses one that is too short.
fn finish(blade: &Blade, options: &PathOptions, rings: Vec<Ring>, end: Option<Broken>) -> Result<Stack> {
    let Some(broken) = end else { return Ok(Stack { rings, end_reason: EndReason::Region }) };
    let end = stopped(blade, &broken, options);
    if rings.len() < 2 {
        let lost = matches!(broken, Broken::Lost(_));
        let message = format!("not one whole turn fits: {end}");
        let since = not_one_turn(options, end.by, Some(end.at));
        return Err(Error::infeasible(Stage::Path, message, since).advise(no_turn_advice(lost)));
    }
    Ok(Stack { rings, end_reason: EndReason::Surface(end) })
}

/// What to do where no turn fits: a smaller ball helps where the ball lost the surface, not where
/// the wall leans.
pub(super) fn no_turn_advice(lost: bool) -> &'static str {
    if lost { "start higher with region.start_mm, or take a smaller ball" } else { "start higher with region.start_mm" }
}

/// Less than a turn, as data.
pub(super) fn not_one_turn(options: &PathOptions, by: Stopped, at: Option<Spot>) -> Infeasible {
    let (radius_mm, max_lean_deg) = (options.radius_mm, options.settings.max_lean_deg);
    Infeasible::NotOneTurn { radius_mm, max_lean_deg, by, at }
}

fn stopped(blade: &Blade, broken: &Broken, options: &PathOptions) -> SurfaceEnd {
    let (by, p) = match broken {
        Broken::Leans(p) => (Stopped::WallLeans, p),
        Broken::Rim(p) => (Stopped::Rim, p),
        Broken::Lost(p) => (Stopped::BallTooLarge, p),
        Broken::Open(p) => (Stopped::WayOpen, p),
    };
    surface_end(blade, by, p, options)
}

/// The ring at the start height, beginning at its base point.
pub fn first_ring(blade: &Blade, level: &LevelSet, options: &PathOptions, x_mm: f64, how: &Tracing) -> Result<Ring> {
    let contour = seed::Contour::of(blade, region(blade, options)?, level, x_mm)?;
    let none = |by: Stopped, at: Option<Spot>| Infeasible::NoTurnRound {
        height_mm: x_mm,
        radius_mm: level.radius_mm,
        max_lean_deg: options.settings.max_lean_deg,
        by,
        at,
    };
    let too_tight = |why: String, since: Infeasible| {
        Error::infeasible(
            Stage::Path,
            format!("no ball of radius {} mm goes round the airfoil at height {x_mm:.3} mm: {why}", level.radius_mm),
            since,
        )
        .advise("take a smaller ball, or another region.start_mm")
    };
    let touch = contour.first_touch(level, x_mm).ok_or_else(|| {
        too_tight("other parts of the blade are in the way all round".into(), none(Stopped::OtherParts, None))
    })?;
    let ring = ring::trace(level, touch, how).map_err(|b| {
        let end = stopped(blade, &b, options);
        let since = none(end.by, Some(end.at.clone()));
        match &b {
            // No ball stands up a wall that leans.
            Broken::Leans(_) | Broken::Rim(_) => {
                Error::infeasible(Stage::Path, format!("no turn goes round the airfoil at height {x_mm:.3} mm: {end}"), since)
                    .advise("look with `inspect` whether this is the airfoil and its axis (--axis), or begin elsewhere with region.start_mm")
            }
            Broken::Lost(p) | Broken::Open(p) => too_tight(format!("its path is blocked at {}", place(blade, p)), since),
        }
    })?;
    if let Some(p) = contour.touches_another_body(&ring) {
        return Err(too_tight(
            format!("it touches another body at {}", place(blade, &p)),
            none(Stopped::OtherBody, Some(spot(blade, &p))),
        ));
    }
    let base = base_point(&ring, options.start_near.map(Point::from));
    Ok(ring.starting_at(base))
}

/// The altered point before the greatest concave stretch, else the touch furthest to the first
/// direction across (y of a blade), over a hub that turns the one nearest to its end; with a point
/// to be `near`, the altered point nearest to it, else the touch nearest to it.
fn base_point(ring: &Ring, near: Option<Point>) -> usize {
    if let Some(q) = near {
        let away = |i: &usize| (ring.touches[*i].contact - q).norm();
        let nearest = |places: &mut dyn Iterator<Item = usize>| places.min_by(|a, b| away(a).total_cmp(&away(b)));
        let altered = nearest(&mut ring.altered_points(CONCAVE_TURN_RAD).into_iter());
        return altered.or_else(|| nearest(&mut (0..ring.touches.len()))).unwrap_or(0);
    }
    let side_mm = |i: usize| {
        let centre = &ring.touches[i].centre;
        match ring.along.round() {
            Some(meridian) => meridian.along(centre),
            None => ring.along.frame(centre).across(&centre.coords)[0],
        }
    };
    let furthest = || (0..ring.touches.len()).max_by(|a, b| side_mm(*a).total_cmp(&side_mm(*b))).unwrap_or(0);
    ring.concave_entries(CONCAVE_TURN_RAD)
        .into_iter()
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map_or_else(furthest, |(index, _)| index)
}

/// The ring below `last` whose scallop against it is just under the target, and the pitch before it
/// was cut to the region.
fn next_ring(
    level: &LevelSet,
    last: &Ring,
    guess_mm: f64,
    aim: &Aim,
    lowest: f64,
    how: &Tracing,
) -> std::result::Result<(Ring, f64), Broken> {
    let least = 0.02 * flat_stepover_mm(level.radius_mm, aim.target_mm);
    let mut pitch = guess_mm;
    let mut best: Option<(Ring, f64)> = None;
    let mut trouble = None;
    for attempt in 0..12 {
        let x = (last.x_mm - pitch).max(lowest);
        match ring_below(level, last, x, how) {
            Ok(ring) => {
                let target_mm = aim.at([ring.x_mm, last.x_mm]);
                let h = worst_ridge(level, last, &ring);
                let factor = (target_mm / h.max(1e-3 * target_mm)).sqrt();
                if h <= target_mm {
                    let good = attempt >= 3 || h >= 0.94 * target_mm || x <= lowest || trouble.is_some();
                    best = Some((ring, pitch));
                    if good {
                        break;
                    }
                } else if best.is_some() {
                    break;
                }
                pitch *= (0.985 * factor).clamp(0.3, 1.4);
            }
            Err(broken) => {
                if best.is_some() {
                    break;
                }
                trouble = Some(broken);
                pitch *= 0.5;
            }
        }
        if pitch < least {
            break;
        }
    }
    best.ok_or_else(|| trouble.unwrap_or(Broken::Leans(last.touches[0].contact)))
}

/// The ring at height `x` that begins next to the base point of `last`.
fn ring_below(level: &LevelSet, last: &Ring, x: f64, how: &Tracing) -> std::result::Result<Ring, Broken> {
    let guess = level.along.at(x, &last.touches[0].centre);
    let reach = 4.0 * (last.x_mm - x) + 0.05 * level.radius_mm;
    let start: Touch = level.touch_in_plane(&guess, reach).ok_or(Broken::Lost(guess))?;
    let ring = ring::trace(level, start, how)?;
    // Two neighbouring curves of the level set are of nearly equal length; a jump means another
    // body was joined.
    if ring.length_mm > 1.25 * last.length_mm || ring.length_mm < 0.8 * last.length_mm {
        return Err(Broken::Lost(start.centre));
    }
    Ok(ring)
}

/// The scallop between two rings, mm.
fn worst_ridge(level: &LevelSet, a: &Ring, b: &Ring) -> f64 {
    let heights = parallel::filter_map(&a.touches, |t| {
        // The chord between two touches of the ring lies off the level set, which would tilt a
        // close pair of balls.
        let near = level.touch_in_plane(&b.nearest(&t.centre), 0.1 * level.radius_mm)?;
        ridge_height(level, [t, &near].map(|t| Pass::new(level, t, &t.tangent(&level.along))).each_ref())
    });
    decisive_mm(level, heights)
}
