//! Lead-in and lead-out: how the ball comes onto the path and leaves it.
//!
//! **In**: [`Toolpath`], [`Schedule`], the angle of the head, [`LeadOptions`]. **Out**: [`Lead`]s
//! to choose from, the best first; path and schedule with the chosen ones at their ends, for the
//! feed; and the motion of that, taken apart again.
//!
//! ## Equations
//! With the ball centre `c`, the unit tangent `t` of the path (of the parabola through its last
//! three centres) and a direction `d` away from the part and across `t`, the arc of radius `r` is
//!
//! ```text
//! lead-in   c(φ) = c − r sin φ t + r (1 − cos φ) d,   φ from the angle of the arc down to 0
//! lead-out  c(φ) = c + r sin φ t + r (1 − cos φ) d,   φ from 0 up
//! ```
//!
//! so that the ball comes onto the surface along the path, and the axes reach their feed in air:
//! the mark of a tool that stands still on the part does not appear. `d` is the surface normal, the
//! tool axis, or halfway between, each taken across `t`. The tool axis goes on turning as fast as
//! at the end of the path, and less and less: `θ(σ) = θ₀ ± θ' (σ − σ²/2λ)` up to the distance `λ`
//! from the path. Where the schedule keeps one offset of the tool from the blade axis (kind
//! `eccentric`), so do the leads: `θ = ψ + asin(e / ρ)` of each centre.
//!
//! ## Guarantees
//! Rows are so close that the arc lies within the chord tolerance of its chords; tangents of arc
//! and path are the same where they meet.
//!
//! ## Limits
//! Whether there is room for an arc is not decided here: that is for [`crate::verify`], which sees
//! the whole tool. The curvature jumps where arc and path meet; the feed slows down for it where
//! the axes need that.

mod join;
#[cfg(test)]
mod tests;

pub use join::{extended, split};

use crate::artifact::axis_travel::{offset_mm, theta_at_offset};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{AxisMotion, Cone, Lead, Schedule, Toolpath};
use crate::geometry::{Point, Vector};

/// Angles of the arcs that are tried, degrees.
const ANGLES_DEG: [f64; 3] = [90.0, 60.0, 30.0];
/// Radii that are tried, over the one asked for.
const RADII: [f64; 3] = [1.0, 0.5, 0.25];
/// Rows of an arc, at least and at most.
const ROWS: [usize; 2] = [12, 400];
/// The tool axis turns no further than this on a lead, rad.
const MOST_TURN_RAD: f64 = 0.15;
/// Directions nearer to one another than this are the same, rad.
const SAME_RAD: f64 = 0.1;
/// A direction across the path must have this share of its length left.
const ACROSS: f64 = 0.3;

/// Which end of the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Onto the first location.
    In,
    /// Off the last location.
    Out,
}

/// What is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadOptions {
    /// Radius of the arcs, mm.
    pub radius_mm: f64,
}

/// An end of the path, with the tangent pointing along the path.
struct Tip {
    centre: Point,
    tangent: Vector,
    normal: Vector,
    cone: Cone,
    theta: f64,
    /// dθ/ds, rad/mm.
    rate: f64,
    /// The offset of the tool from the blade axis, mm, where the schedule keeps it all along.
    offset_mm: Option<f64>,
}

/// Arcs in order of preference: great ones first, away along the normal first. Their motion is not
/// known yet. None where the path has no three locations or no tangent at this end.
pub fn candidates(path: &Toolpath, schedule: &Schedule, end: End, options: &LeadOptions) -> Vec<Lead> {
    let Some(tip) = tip(path, schedule, end) else { return Vec::new() };
    let ways = directions(&tip);
    let mut out = Vec::new();
    for share in RADII {
        for angle in ANGLES_DEG {
            let arc = |d: &Vector| arc(&tip, d, end, share * options.radius_mm, angle.to_radians(), path.chord_mm);
            out.extend(ways.iter().map(arc));
        }
    }
    out
}

fn tip(path: &Toolpath, schedule: &Schedule, end: End) -> Option<Tip> {
    let n = path.locations.len();
    if n < 3 || schedule.theta.len() != n {
        return None;
    }
    let at = |k: usize| if end == End::In { k } else { n - 1 - k };
    let [a, b, c] = [0, 1, 2].map(|k| (path.locations[at(k)], schedule.theta[at(k)]));
    // Signed distances along the path from the tip; the derivative of the parabola there.
    let (h, k) = (b.0.s_mm - a.0.s_mm, c.0.s_mm - a.0.s_mm);
    let [wa, wb, wc] = [-(h + k) / (h * k), k / (h * (k - h)), -h / (k * (k - h))];
    let tangent = a.0.centre.coords * wa + b.0.centre.coords * wb + c.0.centre.coords * wc;
    let chord = (b.1 - a.1) / h;
    let rate = a.1 * wa + b.1 * wb + c.1 * wc;
    // A parabola may turn back where θ does not.
    let rate = if rate * chord > 0.0 { rate } else { chord };
    let tangent = tangent.try_normalize(1e-9).filter(|t| t.iter().all(|x| x.is_finite()) && rate.is_finite())?;
    let offset_mm = (schedule.kind == ScheduleKind::Eccentric).then(|| offset_mm(&a.0.centre, a.1));
    Some(Tip { centre: a.0.centre, tangent, normal: a.0.normal, cone: path.cone(at(0)), theta: a.1, rate, offset_mm })
}

/// Unit directions away from the part, across the tangent.
fn directions(tip: &Tip) -> Vec<Vector> {
    let across = |v: Vector| {
        let c = v - tip.tangent * v.dot(&tip.tangent);
        (c.norm() > ACROSS).then(|| c.normalize())
    };
    let axis = across(tip.cone.tool_axis(tip.theta));
    let normal = across(tip.normal);
    let between = normal.zip(axis).and_then(|(n, a)| across((n + a) * 0.5));
    let mut out: Vec<Vector> = Vec::new();
    for d in [normal, between, axis].into_iter().flatten() {
        if out.iter().all(|o| o.dot(&d) < SAME_RAD.cos()) {
            out.push(d);
        }
    }
    out
}

fn arc(tip: &Tip, d: &Vector, end: End, radius_mm: f64, angle_rad: f64, chord_mm: f64) -> Lead {
    let length = radius_mm * angle_rad;
    // Sagitta h²/8r, with a tenth to spare.
    let step = 0.9 * (8.0 * radius_mm * chord_mm).sqrt();
    let count = (length / step).ceil().clamp(ROWS[0] as f64, ROWS[1] as f64) as usize;
    let sign = if end == End::In { -1.0 } else { 1.0 };
    let row = |k: usize| {
        let phi = angle_rad * k as f64 / count as f64;
        tip.centre + tip.tangent * (sign * radius_mm * phi.sin()) + d * (radius_mm * (1.0 - phi.cos()))
    };
    let mut centres: Vec<Point> = (1..=count).map(row).collect();
    if end == End::In {
        centres.reverse();
    }
    Lead { radius_mm, angle_rad, theta: angles(tip, end, length, &centres), centres, ..Lead::default() }
}

/// The angle of the tool axis at the even steps of a lead of that length, in order of time.
fn angles(tip: &Tip, end: End, length_mm: f64, centres: &[Point]) -> Vec<f64> {
    if let Some(offset_mm) = tip.offset_mm {
        return centres.iter().map(|c| theta_at_offset(c, offset_mm, tip.theta)).collect();
    }
    let count = centres.len();
    let fade = length_mm.min(2.0 * MOST_TURN_RAD / tip.rate.abs().max(1e-12));
    let sign = if end == End::In { -1.0 } else { 1.0 };
    let row = |k: usize| {
        let sigma = (length_mm * k as f64 / count as f64).min(fade);
        tip.theta + sign * tip.rate * (sigma - sigma * sigma / (2.0 * fade))
    };
    let mut out: Vec<f64> = (1..=count).map(row).collect();
    if end == End::In {
        out.reverse();
    }
    out
}

/// The same arcs for another schedule of the same path, to compare motions; straight where the
/// schedule has no rate at the end.
pub fn for_schedule(leads: &[Lead; 2], path: &Toolpath, schedule: &Schedule) -> [Lead; 2] {
    let one = |lead: &Lead, end: End| match tip(path, schedule, end) {
        Some(tip) if lead.is_arc() => {
            let theta = angles(&tip, end, lead.radius_mm * lead.angle_rad, &lead.centres);
            Lead { theta, motion: AxisMotion::default(), ..lead.clone() }
        }
        _ => Lead::straight(lead.reason.clone()),
    };
    [one(&leads[0], End::In), one(&leads[1], End::Out)]
}
