//! The schedule θ(S): where the tool axis points, along the path.
//!
//! In: [`Toolpath`], [`Channel`] (its monotone hull), [`ScheduleOptions`]. Out: [`Schedule`].
//!
//! ## Kinds
//! * `fixed`: the baseline. θ is the azimuth of the surface normal about the blade axis plus a
//!   constant lead in the feed direction, as CAM systems give within the four-axis constraint. It
//!   knows nothing of the channel and may leave it or turn back: that is counted and reported,
//!   never an error.
//! * `lower-wall`, `upper-wall`: along a wall of the channel, or outside it by `beyond_wall_deg`:
//!   to try the channel. Between locations a wall may jump: only where the channel was planned with
//!   `prove_moves` does such a schedule keep clear there too.
//! * `quaternion`: spherical interpolation between key orientations (Ho et al. 2003), the rival
//!   that the piecewise method was published against; may leave the channel or turn back, like
//!   `fixed` (`quaternion` module).
//! * `optimal`: the least peak, or least square, of the second or third derivative of θ(S), over
//!   the whole path at once (`optimal` module), with a lower bound that is proved apart from the
//!   solver (`bound` module). With `scope = "turns"` it is planned turn by turn, each with the next
//!   in view (`by_turn` module).
//! * `time`: a candidate for the least machining time. It makes a mean over short blocks least:
//!   that of the factor by which the rotary axis would have to run slower than at full feed
//!   ([`Pace`]). Where [`Pace::standing_mm`] asks for it, the axis nearly stands still while the
//!   ball gains and loses its feed. The pipeline, which knows the machine, compares the candidates
//!   with the other kinds.
//! * `eccentric`: the tool at one offset from the blade axis all along, so that a lathe's Y stands
//!   still (`eccentric` module).
//! * `even`: the blade turns at one speed all through each turn (`even` module).
//! * `piecewise`: piecewise decoupled re-scheduling for four-axis blade milling. In order:
//!   1. *Walls*: the monotone hull of the channel, straight between cutter locations, moved inwards
//!      by a margin.
//!   2. *Straight line*: where one fits from end to end it is the answer, with zero rotary
//!      acceleration.
//!   3. *Decoupling*: at every base point θ stands still for a short stretch, at a share of the
//!      hull's width there (less an
//!      inset) at which the level stretch stays in the channel. Published is the forward limit, the
//!      greatest such angle
//!      (`base_angle = "forward-limit"`): where the channel is wide, θ has then run ahead as far as
//!      it may, and every turn
//!      begins with a long wait. The first turn is free at its start, the last at its end.
//!   4. *Linear schedule*: per turn the taut string (`taut` module) between its ends inside walls
//!      moved inwards once
//!      more; then key points whose removal blunts the corners are dropped where their neighbours
//!      can be joined.
//!   5. *Corners*: two cubic Béziers with doubled inner control points (`bezier` module). Their
//!      height ε is limited
//!      by the distance of the two half segments from the wall on the curve's side and by half the
//!      length of either
//!      segment (the whole length next to a base point, where no other corner needs it). S is
//!      divided by the length
//!      of the turn and θ by 100 full turns, since angles depend on the scales: the bisector is
//!      then the mean slope.
//!   6. *Choice*: the share and the insets of 3 and 4 and the length of the level stretch come from
//!      a short fixed list. The choice is the one that the weakest rotary axis can follow best at
//!      the programmed feed. Its cost is the greater of the peaks of velocity and acceleration,
//!      each in units of its limit (without a machine: the peak of |d²θ/ds²|).
//!
//! ## The curve
//! Every schedule is a curve of cubic pieces ([`Schedule::pieces`]). Turning points, peaks and the
//! greatest distance outside the channel are those of the curve itself: extremes of each piece and
//! of each piece less each straight stretch of wall (`curve` module), not of samples.
//!
//! ## Guarantees of `optimal`
//! θ never falls, is inside the hull walls everywhere and is twice continuously differentiable. Its
//! measure is within 1 % of the least for the walls less the margin, which
//! [`crate::artifact::schedule::Quality::measure`] proves for each run.
//!
//! ## Guarantees of `piecewise`
//! θ never falls; it is inside the hull walls everywhere (also between cutter locations, for walls
//! taken as straight there); the curve is G2: slope and curvature are continuous, with zero
//! curvature at all joints. The result is re-checked at all locations and between them before it is
//! handed out.
//!
//! ## Failure
//! Kind `Infeasible` where no monotone schedule exists (turn, S, what binds on either side) or
//! where the channel closes to a point in which the schedule would have to bend. Warnings: where
//! the margin had to give way, where a level stretch had to be shortened, and where two turns had
//! to be scheduled as one because no level stretch fits.

mod bezier;
mod bound;
mod by_turn;
mod check;
mod corridor;
mod curve;
mod eccentric;
mod even;
mod fixed;
mod keys;
mod optimal;
mod options;
mod piecewise;
mod quaternion;
mod rounds;
mod settings;
mod taut;
mod turn;
mod wall;

use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::observe::Observer;

pub use even::{Speeds, even};
pub use options::{Pace, ScheduleOptions};
pub use settings::{ScheduleKeys, ScheduleSettings};

/// Makes a schedule of the kind asked for; see the module's page.
///
/// # Errors
/// Kind `Usage` for bad options or inputs that do not belong together; `Infeasible` (only
/// `piecewise`) where no monotone schedule exists; `Cancelled`.
pub fn plan(
    kind: ScheduleKind,
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    options.validate()?;
    let bad = |m: String| Err(Error::usage(Stage::Schedule, m));
    let n = path.locations.len();
    if n != channel.rows.len() {
        return bad(format!("the path has {n} locations but the channel has {} rows", channel.rows.len()));
    }
    if n < 2 {
        return bad(format!("the path has {n} locations, at least 2 are needed"));
    }
    if let Some(i) = path
        .locations
        .windows(2)
        .position(|w| !w[0].s_mm.is_finite() || !w[1].s_mm.is_finite() || w[1].s_mm <= w[0].s_mm)
    {
        return bad(format!("arc length does not rise from location {i} to the next"));
    }
    let pinned = options.ends_rad.map(|ends| pinned(channel, ends)).transpose()?;
    let given = options.with(|s| s.margin_deg = if options.ends_rad.is_some() { 0.0 } else { s.margin_deg });
    let options = &given;
    match kind {
        ScheduleKind::Fixed => fixed::plan(path, channel, options, observer),
        ScheduleKind::Even => {
            let message = "a schedule of kind even is made along with its motion: what asks for one has no motion";
            Err(Error::usage(Stage::Schedule, message).advise("take schedule.kind time"))
        }
        ScheduleKind::Eccentric => eccentric::plan(path, channel, options, observer),
        ScheduleKind::Quaternion => quaternion::plan(path, channel, options, observer),
        ScheduleKind::Optimal | ScheduleKind::Time => {
            optimal::plan(kind, path, pinned.as_ref().unwrap_or(channel), options, observer)
        }
        ScheduleKind::Piecewise => piecewise::plan(path, channel, options, observer),
        ScheduleKind::LowerWall | ScheduleKind::UpperWall => wall::plan(kind, path, channel, options, observer),
    }
}

/// The channel of schedules from one angle to another.
fn pinned(channel: &Channel, ends: [f64; 2]) -> Result<Channel> {
    channel.pinned(ends).ok_or_else(|| {
        let [start_deg, end_deg] = ends.map(f64::to_degrees);
        let message = format!("no θ that never turns back leads from {start_deg:.3}° to {end_deg:.3}°");
        Error::infeasible(Stage::Schedule, message, Infeasible::NoScheduleBetween { start_deg, end_deg })
    })
}

#[cfg(test)]
mod optimal_tests;
#[cfg(test)]
mod tests;
