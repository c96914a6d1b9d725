//! The programmed curve: ball centre and tool axis as one spline, smooth to the fourth derivative.
//!
//! In: the part, a [`Toolpath`], its [`Channel`] and [`Schedule`], an [`Objective`],
//! [`SmoothOptions`]. Out: a [`Curve`].
//!
//! ## Why
//! Programs contain straight moves between cutter locations. The locations are found one by one, so
//! their small errors make corners of some tenths of a degree, and the third derivative of whatever
//! a control rounds them to is noise. Local rounding of corners needs room along the moves that
//! dense locations do not leave: reaches of neighbouring corners overlap. So the whole path is
//! replaced at once. How far it may move is not a matter of the polyline but of the part: along the
//! normal by a fraction of a micrometre, across the path by as much as the ridges allow.
//!
//! ## Method
//! Ball centre `c(s)` and angle `θ(s)` are splines of degree 5 on the same breaks, some moves apart
//! (`start`), in the arc length `s` of the path; θ on some of them.
//!
//! 1. `θ` first (`turn`): least is `∫ θ'''²`, with ordinates of every interval between locations
//!    within the walls of the channel and near the schedule, and ordinates of every span rising.
//! 2. A fit through the locations, nearest along the normal.
//! 3. The part is looked at from the fit (`tube`): with `d` its distance and `n` its normal, a
//!    correction `e(s)` changes the distance to `d + n·e`. Least is the [`Objective`], with the
//!    ordinates of `d + n·e` within the room along the normal, and those of the parts of `e` across
//!    and along the path within theirs. A convex problem in a narrow band
//!    ([`crate::numerics::bounded`]).
//! 4. The distance of the result is proven between places that are measured (`prove`). Where it is
//!    not within the limits the part is looked at anew, then spans are halved, and in the end the
//!    path is left as it is there.
//!
//! With [`Aim::Fewest`] the breaks are searched first (`fewest`): as few as leave room in the tube.
//! The objective then decides between the curves on these breaks, and a bound says how few pieces a
//! spline may have at all (`longest`).
//!
//! The path is cut where the normal turns by more than [`CREASE_RAD`] from one location to the
//! next.
//!
//! ## Guarantees
//! Of every [`CurveStretch`](crate::artifact::curve::CurveStretch): four times continuously
//! differentiable; nowhere deeper in the part or farther off it than the options say, for all `s`,
//! measured on the part and proven between; `θ` between the walls and never falling, for all `s`.
//! Objectives are within [`SmoothOptions::gap`] of a proven bound, or by as much above it as the
//! proof says. The same bytes on any number of threads; time and memory are linear in the number of
//! locations.
//!
//! ## Limits
//! Stretches begin and end freely in the tube: where the path is left as it is, a straight move
//! leads from the end of one to the next location. Third derivatives are least in the square;
//! single places may have greater ones than another curve would.
//!
//! ## Failure
//! Kind `Usage` for options out of their limits and inputs that do not belong together. Where no
//! curve is found the path stays as it is, which [`Curve::left`] says with place and reason.

pub mod corner;
mod evened;
mod fewest;
mod form;
mod longest;
mod options;
mod prove;
mod room;
mod start;
mod stretch;
#[cfg(test)]
mod tests;
mod tube;
mod turn;

use std::ops::Range;

use stretch::SmoothStretch;
use turn::{Turned, TurningFit};

pub use evened::evened;
pub use options::{Aim, SmoothOptions};

use crate::artifact::curve::{Curve, LeftAsIs};
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Error, Result, Stage, WhyLeft};
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::machine::Machine;
use crate::observe::Observer;

/// The path is cut where the surface normal turns by more than this from one location to the next,
/// rad. Chords within their tolerance of a smooth path turn it by a few hundredths.
pub const CREASE_RAD: f64 = 0.2;
/// Locations of a stretch at least.
const FEWEST: usize = 12;
/// Share of the room along the normal that the tube takes; the rest is for what it does not see.
const KEPT: f64 = 0.8;
/// How often a stretch is cut anew where it has no curve.
const MOST_CUTS: usize = 8;

/// What is made least.
#[derive(Clone, Copy, Debug)]
pub enum Objective<'a> {
    /// Half the integral of the squared third derivative of the ball centre, on the part.
    Part,
    /// The same of the machine's linear axes, each over its limit of jerk.
    Axes {
        /// The machine.
        machine: &'a Machine,
        /// From the ball centre to the spindle's gauge line, mm.
        gauge_length_mm: f64,
        /// Lean of the tool on the cone about the blade axis, rad.
        lean_rad: f64,
    },
}

/// Makes the curve; see the module's page.
///
/// # Errors
/// Kind `Usage`: options out of their limits, lists of different length, values that are not
/// finite, arc lengths that do not rise. `Cancelled`.
pub fn plan(
    part: &Part,
    path: &Toolpath,
    channel: &Channel,
    schedule: &Schedule,
    objective: &Objective,
    options: &SmoothOptions,
    observer: &dyn Observer,
) -> Result<Curve> {
    let shares = vec![Share::WHOLE; path.locations.len()];
    let near = Near { shares: &shares, like: None, walls: &[] };
    plan_near(part, path, channel, schedule, objective, options, near, observer)
}

/// What a curve is to be near to.
#[derive(Clone, Copy, Debug)]
pub struct Near<'a> {
    /// How near to the path at each location.
    pub shares: &'a [Share],
    /// A curve of the same path with more room: with [`Aim::Fewest`] the search begins with its
    /// breaks.
    pub like: Option<&'a Curve>,
    /// Walls of the channel between locations, where they are known; in order of arc length.
    pub walls: &'a [SeenWall],
}

/// Walls of the channel at a place of the path between two locations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenWall {
    /// Arc length of the path, mm.
    pub s_mm: f64,
    /// Least θ that is free there and joins on to what is free before, rad.
    pub theta_min: f64,
    /// Greatest θ, rad.
    pub theta_max: f64,
}

/// How near to the path the curve is to be at a location: shares of what the options allow, greater
/// than 0 and at most 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Of the room across the path.
    pub across: f64,
    /// Of the angle from the schedule.
    pub turn: f64,
}

impl Share {
    /// All that the options allow.
    pub const WHOLE: Share = Share { across: 1.0, turn: 1.0 };
}

/// As [`plan`], nearer to the path at some locations.
///
/// # Errors
/// As [`plan`], and where shares are not as many as locations, or out of their limits.
#[allow(clippy::too_many_arguments)]
pub fn plan_near(
    part: &Part,
    path: &Toolpath,
    channel: &Channel,
    schedule: &Schedule,
    objective: &Objective,
    options: &SmoothOptions,
    near: Near,
    observer: &dyn Observer,
) -> Result<Curve> {
    check(path, channel, schedule, options, &near)?;
    let all = (path, channel, schedule);
    let part = Allowed::new(part, path.stock_mm);
    let mut room = room::of(path, options, KEPT);
    room.iter_mut().zip(near.shares).for_each(|(r, share)| r.across_mm *= share.across);
    let whole = path.locations.len();
    let mut curve = Curve::default();
    let mut open: Vec<(Range<usize>, usize)> = Vec::new();
    for (range, turn_rad) in cut_at_creases(path) {
        if let Some(turn_rad) = turn_rad {
            let s_mm = [range.start, range.end - 1].map(|k| path.locations[k].s_mm);
            curve.left.push(LeftAsIs { s_mm, why: WhyLeft::Crease { turn_rad } });
        } else {
            open.push((range, 0));
        }
    }
    while let Some((range, cuts)) = open.pop() {
        observer.check(Stage::Smooth)?;
        observer.progress(Stage::Smooth, range.start, whole);
        let s_mm = |k: usize| path.locations[k].s_mm;
        let ends = [s_mm(range.start), s_mm(range.end - 1)];
        if range.len() < FEWEST {
            curve.left.push(LeftAsIs { s_mm: ends, why: WhyLeft::Short });
            continue;
        }
        let stretch = SmoothStretch {
            part: &part,
            radius_mm: path.radius_mm,
            locations: &path.locations[range.clone()],
            room: &room[range.clone()],
            turning: turning(all, range.clone(), &near, options),
            options,
            objective,
        };
        let like = near.like.and_then(|c| c.stretches.iter().find(|s| s.s_mm() == ends)).map(|s| &s.breaks);
        match stretch.smooth(like) {
            Some(Ok(found)) => curve.stretches.push(found),
            Some(Err(broken)) if cuts < MOST_CUTS && !broken.is_empty() => {
                for (part, is_left) in without(path, range, &broken) {
                    let s_mm = [s_mm(part.start), s_mm(part.end - 1)];
                    if is_left {
                        curve.left.push(LeftAsIs { s_mm, why: WhyLeft::NoRoom });
                    } else {
                        open.push((part, cuts + 1));
                    }
                }
            }
            _ => curve.left.push(LeftAsIs { s_mm: ends, why: WhyLeft::NoRoom }),
        }
    }
    curve.stretches.sort_by(|a, b| a.s_mm()[0].total_cmp(&b.s_mm()[0]));
    curve.left.sort_by(|a, b| a.s_mm[0].total_cmp(&b.s_mm[0]));
    observer.progress(Stage::Smooth, whole, whole);
    Ok(curve)
}

/// θ anew within `near.walls`, the ball centre as it is. Where a stretch has no such θ it keeps its
/// own.
///
/// # Errors
/// Kind `Usage`: lists of different length, values that are not finite, arc lengths that do not
/// rise.
pub fn turned_anew(
    curve: &Curve,
    path: &Toolpath,
    channel: &Channel,
    schedule: &Schedule,
    options: &SmoothOptions,
    near: Near,
) -> Result<Curve> {
    check(path, channel, schedule, options, &near)?;
    let mut curve = curve.clone();
    for stretch in &mut curve.stretches {
        let [from, to] = stretch.s_mm();
        let first = path.locations.partition_point(|l| l.s_mm < from);
        let end = path.locations.partition_point(|l| l.s_mm <= to);
        // A curve of another path.
        if end < first + 2 {
            continue;
        }
        let fit = turning((path, channel, schedule), first..end, &near, options);
        if let Ok(Turned { breaks, theta, square: [square, bound] }) = fit.smooth(&stretch.breaks, options) {
            (stretch.theta_breaks, stretch.theta) = (breaks, theta);
            (stretch.proof.theta_square, stretch.proof.theta_bound) = (square, bound);
        }
    }
    Ok(curve)
}

fn turning(
    all: (&Toolpath, &Channel, &Schedule),
    range: Range<usize>,
    near: &Near,
    options: &SmoothOptions,
) -> TurningFit {
    let joined = [range.start > 0, range.end < all.0.locations.len()];
    TurningFit::new(all, range, near, joined, options)
}

/// Stretches between creases, and the moves over creases with the angle by which the normal turns.
fn cut_at_creases(path: &Toolpath) -> Vec<(Range<usize>, Option<f64>)> {
    let mut out = Vec::new();
    let mut from = 0;
    for (k, w) in path.locations.windows(2).enumerate() {
        let turn_rad = w[0].normal.angle(&w[1].normal);
        if turn_rad > CREASE_RAD {
            out.push((from..k + 1, None));
            out.push((k..k + 2, Some(turn_rad)));
            from = k + 1;
        }
    }
    out.push((from..path.locations.len(), None));
    out
}

/// The locations of a range before, between and after places that have no curve, and those of these
/// places themselves, marked. A place takes in the location before it and the one after.
fn without(path: &Toolpath, range: Range<usize>, broken: &[[f64; 2]]) -> Vec<(Range<usize>, bool)> {
    let locations = &path.locations[range.clone()];
    let mut is_broken = vec![false; locations.len()];
    for [a, b] in broken {
        let from = locations.partition_point(|l| l.s_mm <= *a).saturating_sub(1);
        let to = (locations.partition_point(|l| l.s_mm < *b) + 1).min(locations.len());
        is_broken[from..to].iter_mut().for_each(|m| *m = true);
    }
    let mut out = Vec::new();
    let mut from = 0;
    for k in 1..=locations.len() {
        if k == locations.len() || is_broken[k] != is_broken[from] {
            out.push((range.start + from..range.start + k, is_broken[from]));
            from = k;
        }
    }
    out
}

fn check(path: &Toolpath, channel: &Channel, schedule: &Schedule, options: &SmoothOptions, near: &Near) -> Result<()> {
    options.validate()?;
    validate(path, channel, schedule)?;
    let shares = near.shares;
    if shares.len() != path.locations.len()
        || !shares.iter().flat_map(|s| [s.across, s.turn]).all(|s| s > 0.0 && s <= 1.0)
    {
        let message = "shares of the room must be greater than 0, at most 1, and one for each location";
        return Err(Error::usage(Stage::Smooth, message));
    }
    let bad_wall = |w: &SeenWall| ![w.s_mm, w.theta_min, w.theta_max].iter().all(|v| v.is_finite());
    if near.walls.iter().any(bad_wall) || near.walls.windows(2).any(|w| w[0].s_mm > w[1].s_mm) {
        let message = "walls between locations must be finite and in order of arc length";
        return Err(Error::usage(Stage::Smooth, message));
    }
    Ok(())
}

fn validate(path: &Toolpath, channel: &Channel, schedule: &Schedule) -> Result<()> {
    let n = path.locations.len();
    let bad = |m: String| Err(Error::usage(Stage::Smooth, m));
    if channel.rows.len() != n || schedule.theta.len() != n {
        let (rows, angles) = (channel.rows.len(), schedule.theta.len());
        return bad(format!(
            "the path has {n} locations, but the channel {rows} rows and the schedule {angles} angles"
        ));
    }
    validate_path(path)?;
    match schedule.theta.iter().position(|theta| !theta.is_finite()) {
        Some(k) => bad(format!("location {k} has a centre, a normal or an angle that is not one")),
        None => Ok(()),
    }
}

fn validate_path(path: &Toolpath) -> Result<()> {
    let n = path.locations.len();
    let bad = |m: String| Err(Error::usage(Stage::Smooth, m));
    if n < 2 {
        return bad(format!("the path has {n} locations, at least 2 are needed"));
    }
    if !(path.radius_mm > 0.0 && path.radius_mm.is_finite()) {
        return bad(format!("the ball's radius is {} mm, it must be greater than 0", path.radius_mm));
    }
    for (k, l) in path.locations.iter().enumerate() {
        let finite = l.centre.iter().chain(l.normal.iter()).all(|v| v.is_finite());
        if !finite || (l.normal.norm() - 1.0).abs() > 1e-3 {
            return bad(format!("location {k} has a centre, a normal or an angle that is not one"));
        }
        if k > 0 && !(l.s_mm > path.locations[k - 1].s_mm) {
            return bad(format!("arc length does not rise at location {k} ({} mm)", l.s_mm));
        }
    }
    Ok(())
}
