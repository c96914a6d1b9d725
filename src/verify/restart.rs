//! Evidence for what is left of a checked plan: a program that goes on after a break.
//!
//! The path, the angles and the channel must be those of the whole plan, to the bit, from some
//! location on: then gouge, scallop and clearance of the whole plan hold for them. What is new, a
//! lead-in and the motion from rest, is checked anew and takes the place of the whole plan's
//! figures.

use super::lead::{self, Room};
use super::{Verdict, Verified, limits, well_formed};
use crate::artifact::Plan;
use crate::error::{Error, Result, Stage};

/// Checks the lead-in and the motion of `left`, and gives it the whole plan's evidence for all
/// else. Forced evidence stays forced.
///
/// # Errors
/// `Usage` where `left` is no plan, or not the whole one's from some location on.
pub fn restart(whole: &Verified<Plan>, left: Plan, room: &Room) -> Result<Verdict<Plan>> {
    well_formed(&left, room.machine)?;
    let (all, n) = (whole.value(), left.toolpath.locations.len());
    let skip = all.toolpath.locations.len().checked_sub(n);
    let same = skip.is_some_and(|k| {
        all.toolpath.locations[k..] == left.toolpath.locations[..]
            && all.schedule.theta[k..] == left.schedule.theta[..]
            && all.schedule.pieces == left.schedule.pieces
            && all.channel.rows[k..] == left.channel.rows[..]
            && (k..k + n).all(|row| all.toolpath.cone(row) == left.toolpath.cone(row - k))
            && all.toolpath.stock_mm == left.toolpath.stock_mm
    });
    if !same {
        return Err(Error::usage(
            Stage::Verify,
            "what is to be gone on with is not the end of the plan that was checked",
        ));
    }
    let mut report = whole.report().clone();
    let mut fresh = lead::check(&left, room);
    fresh.extend(limits::check(&left, room.blade, room.tool, room.machine, room.options));
    report.checks.retain(|c| !c.id.is_of_lead() && fresh.iter().all(|f| f.id != c.id));
    report.checks.extend(fresh);
    Ok(Verdict::of(left, report))
}
