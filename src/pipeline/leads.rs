//! The motion with its leads: arcs for which there is room, chosen by the same checks that later give the evidence.

use super::Setup;
use crate::artifact::{AxisMotion, Lead, Schedule, Toolpath};
use crate::error::{Result, Stage};
use crate::feed;
use crate::lead::{self, End, LeadOptions};
use crate::observe::{Observer, Warning};
use crate::verify::lead::{Foot, Room, obstructed};

/// The first arc with room for it at each end; where there is none, straight, with the reason, which is told.
pub(super) fn choose(
    setup: &Setup,
    path: &Toolpath,
    schedule: &Schedule,
    observer: &dyn Observer,
) -> Result<[Lead; 2]> {
    let radius_mm = setup.job.feed.lead_radius_mm;
    if radius_mm == 0.0 {
        return Ok([(); 2].map(|()| Lead::straight("asked for by feed.lead_radius_mm = 0")));
    }
    let verify = setup.verify_options();
    let b_rad = setup.job.machine.b_deg.to_radians();
    let room = Room {
        blade: &setup.blade,
        stock_mm: path.stock_mm,
        obstacles: &setup.obstacles,
        tool: &setup.job.tool,
        machine: &setup.machine,
        b_rad,
        options: &verify,
    };
    let mut out = [Lead::default(), Lead::default()];
    for (end, slot) in [End::In, End::Out].into_iter().zip(&mut out) {
        *slot = one(path, schedule, end, &LeadOptions { radius_mm, b_rad }, &room);
        observer.check(Stage::Feed)?;
        if !slot.is_arc() {
            let name = if end == End::In { "lead-in" } else { "lead-out" };
            let message = format!("the {name} is straight along the tool axis: {}", slot.reason);
            observer.warn(Warning { stage: Stage::Feed, message });
        }
    }
    Ok(out)
}

fn one(path: &Toolpath, schedule: &Schedule, end: End, options: &LeadOptions, room: &Room) -> Lead {
    let row = if end == End::In { path.locations.first() } else { path.locations.last() };
    let theta = if end == End::In { schedule.theta.first() } else { schedule.theta.last() };
    let Some((at, theta)) = row.zip(theta) else { return Lead::straight("the path has no locations") };
    let foot = Foot { centre: at.centre, theta: *theta };
    let mut first = None;
    for mut arc in lead::candidates(path, schedule, end, options) {
        match obstructed(&arc, foot, end == End::In, room) {
            None => {
                arc.reason = first.map(|why| format!("with the one tried first {why}")).unwrap_or_default();
                return arc;
            }
            Some(why) => first = first.or(Some(why)),
        }
    }
    Lead::straight(first.map_or_else(
        || "the path has no direction at its end".to_owned(),
        |why| format!("there is no room for an arc, with that asked for {why}"),
    ))
}

/// The fastest motion over path and leads, taken apart.
pub(super) fn motion(
    setup: &Setup,
    path: &Toolpath,
    schedule: &Schedule,
    leads: [Lead; 2],
    observer: &dyn Observer,
) -> Result<(AxisMotion, [Lead; 2])> {
    let (long_path, long_schedule) = lead::extended(path, schedule, &leads);
    let whole = feed::plan(&long_path, &long_schedule, &setup.machine, &setup.feed_options(), observer)?;
    Ok(lead::split(&whole, leads))
}
