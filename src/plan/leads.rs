//! The motion with its leads: arcs for which there is room, chosen by the same checks that later
//! give the evidence.

use super::{Setup, discs};
use crate::artifact::{AxisMotion, Lead, Plan, ProgrammedCurve, Schedule, Stand, Toolpath};
use crate::error::{Error, Infeasible, LeadReason, Missed, Result, Stage};
use crate::feed::{self, FeedOptions};
use crate::lead::{self, End, LeadOptions};
use crate::observe::{Doubt, Observer, Silent, Warning};
use crate::verify::lead::{Room, obstructed};
use crate::verify::{self, Verdict, Verified, VerifyOptions};
use crate::write::post::{self, PostOptions};

/// A motion with its leads.
pub(super) type MotionAndLeads = (AxisMotion, [Lead; 2]);

/// The first arc with room for it at each end. Where there is none: a straight lead with the
/// reason, which is reported unless the job asked for it.
pub(crate) fn choose(
    setup: &Setup,
    path: &Toolpath,
    schedule: &Schedule,
    observer: &dyn Observer,
) -> Result<[Lead; 2]> {
    let verify = setup.verify_options();
    let path = &*discs::placed(path, &setup.job.tool, &schedule.theta);
    let room = room(setup, path, &verify);
    let mut out = [Lead::default(), Lead::default()];
    for (end, slot) in [End::In, End::Out].into_iter().zip(&mut out) {
        *slot = one(path, schedule, end, setup.job.feed.lead_radius_mm, &room);
        observer.check(Stage::Feed)?;
        if let Some(reason) = slot.reason.clone().filter(|_| !slot.is_arc() && setup.job.feed.lead_radius_mm > 0.0) {
            let name = if end == End::In { "lead-in" } else { "lead-out" };
            observer.warn(Warning { stage: Stage::Feed, doubt: Doubt::StraightLead { lead: name.into(), reason } });
        }
    }
    Ok(out)
}

fn room<'a>(setup: &'a Setup, path: &Toolpath, options: &'a VerifyOptions) -> Room<'a> {
    Room {
        blade: &setup.blade,
        stock_mm: path.stock_mm,
        obstacles: &setup.obstacles,
        tool: &setup.job.tool,
        machine: &setup.machine,
        options,
    }
}

/// What is left of a checked plan from a turn on (from 1), with a lead-in of its own onto that turn
/// and a motion that begins at rest, and the evidence for it. The lead-in is an arc where there is
/// room for one, as at the start of the path.
///
/// # Errors
/// `Usage` where there is no such turn; `Infeasible` where the tool cannot come onto it; those of
/// the feed.
pub(crate) fn restart(setup: &Setup, whole: &Verified<Plan>, turn: usize) -> Result<Verified<Plan>> {
    let from = PostOptions { from_turn: Some(turn), ..setup.post_options() };
    let left = post::planned(whole.value(), &from)?.into_owned();
    if turn == 1 {
        return Ok(whole.clone());
    }
    let verify = setup.verify_options();
    let room = room(setup, &left.toolpath, &verify);
    let arc = one(&left.toolpath, &left.schedule, End::In, setup.job.feed.lead_radius_mm, &room);
    let mut missed: Vec<Missed> = Vec::new();
    let straight = Lead::straight(left.leads[0].reason.clone());
    for lead in [arc.is_arc().then_some(arc), Some(straight)].into_iter().flatten() {
        let mut left = left.clone();
        let leads = [lead, left.leads[1].clone()];
        (left.motion, left.leads) = motion(setup, &left.toolpath, &left.schedule, left.curve.as_ref(), leads, &Silent)?;
        match verify::restart(whole, left, &room)? {
            Verdict::Passed(passed) if !whole.forced() => return Ok(passed),
            Verdict::Passed(passed) => return Ok(passed.as_forced()),
            Verdict::Failed(rejected) if whole.forced() => return Ok(rejected.write_anyway()),
            Verdict::Failed(rejected) => missed = rejected.report().missed(),
        }
    }
    let told: Vec<String> =
        missed.iter().map(|m| format!("{} {:.6}, limit {:.6}", m.check, m.worst, m.limit)).collect();
    let found = told.join("; ");
    let message = format!("the tool cannot come onto turn {turn} within the limits of the checks: {found}");
    let index = u32::try_from(turn - 1).unwrap_or(u32::MAX);
    Err(Error::infeasible(Stage::Post, message, Infeasible::TurnNotReached { turn: index, missed })
        .advise("go on with another turn"))
}

fn one(path: &Toolpath, schedule: &Schedule, end: End, radius_mm: f64, room: &Room) -> Lead {
    if radius_mm == 0.0 {
        return Lead::straight(LeadReason::Asked);
    }
    let options = &LeadOptions { radius_mm };
    let row = if end == End::In { path.locations.first() } else { path.locations.last() };
    let theta = if end == End::In { schedule.theta.first() } else { schedule.theta.last() };
    let Some((at, theta)) = row.zip(theta) else { return Lead::straight(LeadReason::NoPath) };
    let cone = path.cone(if end == End::In { 0 } else { path.locations.len() - 1 });
    let foot = Stand { centre: at.centre, cone, theta: *theta };
    let mut first = None;
    for mut arc in lead::candidates(path, schedule, end, options) {
        match obstructed(&arc, foot, end == End::In, room) {
            None => {
                arc.reason = first.map(|first| LeadReason::Another { first });
                return arc;
            }
            Some(why) => first = first.or(Some(why)),
        }
    }
    Lead::straight(first.map_or(LeadReason::NoDirection, |first| LeadReason::NoRoom { first }))
}

/// The fastest motion over path and leads, on the programmed curve where there is one, taken apart.
pub(crate) fn motion(
    setup: &Setup,
    path: &Toolpath,
    schedule: &Schedule,
    curve: Option<&ProgrammedCurve>,
    leads: [Lead; 2],
    observer: &dyn Observer,
) -> Result<(AxisMotion, [Lead; 2])> {
    motion_within(setup, &setup.feed_options(), (path, schedule, curve), leads, observer)
}

/// As [`motion`], within other limits than those of the job.
pub(crate) fn motion_within(
    setup: &Setup,
    options: &FeedOptions,
    (path, schedule, curve): (&Toolpath, &Schedule, Option<&ProgrammedCurve>),
    leads: [Lead; 2],
    observer: &dyn Observer,
) -> Result<(AxisMotion, [Lead; 2])> {
    let path = &*discs::placed(path, &setup.job.tool, &schedule.theta);
    let (long_path, long_schedule) = lead::extended(path, schedule, &leads);
    let [before, after] = leads.each_ref().map(|l| l.centres.len());
    let s = |k: usize| long_path.locations[k].s_mm;
    let (first, end) = (before, long_path.locations.len() - after);
    let long_curve = curve.map(|c| {
        let ahead: Vec<f64> = (0..first).map(|k| s(k) - s(first)).collect();
        let behind: Vec<f64> = (end..end + after).map(|k| s(k) - s(end - 1)).collect();
        c.extended(&ahead, &behind)
    });
    let whole = feed::plan_on(&long_path, &long_schedule, long_curve.as_ref(), &setup.machine, options, observer)?;
    Ok(lead::split(&whole, leads))
}
