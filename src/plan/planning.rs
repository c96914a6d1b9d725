//! The planning stages, one after another.

use super::leads::MotionAndLeads;
use super::schedules::Candidate;
use super::{Baseline, Setup, discs, even, leads, schedules, smoothing};
use crate::artifact::region::Boundary;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{AxisMotion, Channel, Cones, Lead, Plan, ProgrammedCurve, Schedule, Toolpath};
use crate::channel;
use crate::error::{EndReason, ErrorKind, Result, Stage};
use crate::lead;
use crate::observe::{Doubt, Observer, Silent, Warning, timed};
use crate::parallel;
use crate::path;
use crate::schedule;
use crate::verify;

/// A schedule, with its motion where that is known, and which of several it is.
struct Scheduled {
    schedule: Schedule,
    motion: Option<MotionAndLeads>,
    which: Option<Candidate>,
}

/// How often walls are moved in for what happens between locations.
const MOST_PROOFS: usize = 4;
/// How often the helix is laid anew to end higher before the channel's error stands.
pub(super) const MOST_ENDS: usize = 12;

/// How far planning went.
pub(crate) enum Reached {
    Path(Toolpath),
    Channel(Toolpath, Channel),
    Schedule(Box<(Toolpath, Channel, Schedule)>),
    /// The whole plan, and a fixed lead under the same limits.
    Motion(Box<(Plan, Baseline)>),
}

/// What is known before planning begins. A stage whose result is known is not worked on; so is none
/// before it.
#[derive(Default)]
pub(crate) struct KnownStages {
    pub toolpath: Option<Toolpath>,
    pub channel: Option<Channel>,
    pub schedule: Option<Schedule>,
    pub motion: Option<(AxisMotion, [Lead; 2])>,
    /// Where the motion is one on a curve, all of the above are along it.
    pub curve: Option<ProgrammedCurve>,
}

/// The planning stages, to `until` or to the end.
pub(crate) fn stages(
    setup: &Setup,
    until: Option<Stage>,
    known: KnownStages,
    observer: &dyn Observer,
) -> Result<Reached> {
    // Path and channel are those of any machine of the kind; a motion is not.
    if !matches!(until, Some(Stage::Path | Stage::Channel | Stage::Schedule)) {
        setup.machine.check_swing(&setup.blade.part.mesh.points)?;
    }
    let mut toolpath = match known.toolpath {
        // The cones belong to the channel.
        Some(t) if known.channel.is_some() && !setup.job.orientation.kind.goes_round() => t.of_corner(),
        // How turns lie does not depend on the lean: it may be another by now.
        Some(t) => t.of_corner().with_cones(Cones::about_blade(setup.job.machine.b_deg.to_radians())),
        None => timed(observer, Stage::Path, || path_as_asked(setup, observer))?,
    };
    if until == Some(Stage::Path) {
        return Ok(Reached::Path(toolpath));
    }
    let mut channel = match known.channel {
        Some(c) => c,
        None => channel_as_far_as_it_goes(setup, &mut toolpath, observer)?,
    };
    if until == Some(Stage::Channel) {
        return Ok(Reached::Channel(toolpath, channel));
    }
    let (options, known_curve) = (setup.schedule_options(), known.curve);
    // What a baseline that nobody asked for does wrong is no warning: its figures stand in the
    // summary. Where it is the job's own schedule it is planned again below, and warns.
    let baseline = |path: &Toolpath, channel: &Channel| {
        timed(observer, Stage::Schedule, || schedule::plan(ScheduleKind::Fixed, path, channel, &options, &Silent))
    };
    let mut fixed = baseline(&toolpath, &channel)?;
    let mut made = match known.schedule {
        Some(schedule) => Scheduled { schedule, motion: known.motion, which: None },
        None => timed(observer, Stage::Schedule, || scheduled(setup, &toolpath, &channel, observer))?,
    };
    if !made.schedule.kind.is_wall() && known_curve.is_none() && setup.job.tool.is_ball() {
        keep_clear(setup, &toolpath, &mut channel, &mut made, observer)?;
    }
    let Scheduled { mut schedule, mut motion, .. } = made;
    if until == Some(Stage::Schedule) {
        let toolpath = discs::placed(&toolpath, &setup.job.tool, &schedule.theta).into_owned();
        return Ok(Reached::Schedule(Box::new((toolpath, channel, schedule))));
    }
    let mut curve = known_curve;
    if setup.job.feed.smooth && curve.is_none() {
        let before = smoothing::Before { path: &toolpath, channel: &channel, schedule: &schedule };
        if let Some(made) = smoothing::smoothed(setup, before, motion.as_ref(), observer)? {
            (toolpath, channel, schedule) = (made.path, made.channel, made.schedule);
            (motion, curve) = (None, Some(made.curve));
            fixed = baseline(&toolpath, &channel)?;
        }
    }
    let (motion, leads, fixed_motion) = timed(observer, Stage::Feed, || {
        let chosen = match &motion {
            Some((_, leads)) => leads.clone(),
            None => leads::choose(setup, &toolpath, &schedule, observer)?,
        };
        // From the same leads, so that the two are compared under the same conditions. At the same
        // time, since each takes one thread.
        let others = match setup.job.tool.is_ball() {
            true => lead::for_schedule(&chosen, &toolpath, &fixed),
            // The ends of its path are others.
            false => leads::choose(setup, &toolpath, &fixed, &Silent)?,
        };
        let on = curve.as_ref();
        let own = || motion.map_or_else(|| leads::motion(setup, &toolpath, &schedule, on, chosen, observer), Ok);
        let (own, baseline) = parallel::both(own, || leads::motion(setup, &toolpath, &fixed, None, others, &Silent));
        let ((motion, leads), (fixed_motion, _)) = (own?, baseline?);
        Ok((motion, leads, fixed_motion))
    })?;
    let baseline = Baseline { schedule: fixed, motion: fixed_motion };
    let toolpath = discs::placed(&toolpath, &setup.job.tool, &schedule.theta).into_owned();
    let plan = Plan { toolpath, channel, schedule, motion, leads, curve };
    Ok(Reached::Motion(Box::new((plan, baseline))))
}

/// The schedule of the job, and its motion where that was found along with it.
fn scheduled(setup: &Setup, path: &Toolpath, channel: &Channel, observer: &dyn Observer) -> Result<Scheduled> {
    let (schedule, motion, which) = match setup.job.schedule.kind {
        ScheduleKind::Time => {
            let (schedule, motion, which) = schedules::least_time(setup, path, channel, observer)?;
            (schedule, Some(motion), Some(which))
        }
        ScheduleKind::Even => {
            let (schedule, motion) = even::even(setup, path, channel, observer)?;
            (schedule, Some(motion), None)
        }
        kind => (schedule::plan(kind, path, channel, &setup.schedule_options(), observer)?, None, None),
    };
    Ok(Scheduled { schedule, motion, which })
}

/// As [`scheduled`], in a channel that has changed a little: the same one of several, if it can be
/// made again.
fn scheduled_again(setup: &Setup, path: &Toolpath, channel: &Channel, which: Option<Candidate>) -> Result<Scheduled> {
    match which.map(|which| schedules::again(setup, (path, channel), which)) {
        Some(Ok((schedule, motion))) => Ok(Scheduled { schedule, motion: Some(motion), which }),
        _ => scheduled(setup, path, channel, &Silent),
    }
}

/// The channel's walls hold at the locations; between two of them the tool may come nearer for a
/// moment. Where it does by the schedule, the walls of these moves are proven and moved in, and the
/// schedule is made anew. Where that leaves nothing, the channel by the exact faces may lie farther
/// out. If there is no channel or no schedule then, all stays as it was, and the checks report it.
fn keep_clear(
    setup: &Setup,
    path: &Toolpath,
    channel: &mut Channel,
    made: &mut Scheduled,
    observer: &dyn Observer,
) -> Result<()> {
    let (verify, tool, mut rows) = (setup.verify_options(), &setup.job.tool, Vec::new());
    let apart = verify::apart(&setup.blade, &setup.obstacles, tool, &verify);
    for _ in 0..MOST_PROOFS {
        let short =
            timed(observer, Stage::Channel, || Ok(verify::short_moves(path, &made.schedule.theta, &apart, &verify)))?;
        if short.is_empty() {
            return Ok(());
        }
        rows.extend(short);
        rows.sort_unstable();
        rows.dedup();
        let found = timed(observer, Stage::Channel, || {
            let by_exact_faces = if setup.job.channel.exact_ends { &[true][..] } else { &[false, true] };
            for exact_ends in by_exact_faces.iter().copied() {
                if let Some(channel) = setup.channel_with_proven((path, channel), &rows, exact_ends, &Silent)? {
                    return Ok(channel);
                }
            }
            setup.channel_proven(path, &rows, true, &Silent)
        });
        let anew = found.and_then(|c| {
            let anew = timed(observer, Stage::Schedule, || scheduled_again(setup, path, &c, made.which))?;
            Ok((c, anew))
        });
        match anew {
            Ok(anew) => (*channel, *made) = anew,
            Err(e) if e.kind == ErrorKind::Infeasible => return Ok(()),
            Err(e) => return Err(e),
        }
        observer.check(Stage::Schedule)?;
    }
    Ok(())
}

/// The path of the job; says so where it ends before the height that the job asks for.
pub(crate) fn path_as_asked(setup: &Setup, observer: &dyn Observer) -> Result<Toolpath> {
    let path = setup.path(observer)?;
    if let Some(end_mm) = setup.job.region.end_mm
        && path.end_reason != EndReason::Region
    {
        let [a, b] = path.region_x_mm;
        let reason = path.end_reason.clone();
        let doubt = Doubt::HelixEndsEarly { height_mm: a.min(b), asked_mm: end_mm, reason };
        observer.warn(Warning { stage: Stage::Path, doubt });
    }
    Ok(path)
}

/// The channel. Where the job leaves the end of the region open and the channel closes on the way
/// down, the helix is laid anew to end above that place, with a warning. A region end that the job
/// asks for is never given up.
pub(crate) fn channel_as_far_as_it_goes(
    setup: &Setup,
    toolpath: &mut Toolpath,
    observer: &dyn Observer,
) -> Result<Channel> {
    let (blade, options) = (&setup.blade, setup.channel_options());
    let around = timed(observer, Stage::Channel, || setup.surroundings())?;
    if !setup.job.orientation.kind.goes_round() {
        let path = toolpath.clone();
        let (path, planned) = timed(observer, Stage::Channel, || setup.oriented(path, &around, observer))?;
        *toolpath = path;
        let plan = || channel::plan_among(&around, &setup.job.tool, toolpath, &options, observer);
        return planned.map_or_else(|| timed(observer, Stage::Channel, plan), Ok);
    }
    let plan = |path: &Toolpath| channel::plan_among(&around, &setup.job.tool, path, &options, observer);
    let mut cut = None;
    let mut ended_mm = None;
    for _ in 0..MOST_ENDS {
        let planned = timed(observer, Stage::Channel, || plan(toolpath));
        let blocked = match planned {
            Ok(channel) => {
                if let Some(doubt) = cut {
                    observer.warn(Warning { stage: Stage::Channel, doubt });
                }
                return Ok(channel);
            }
            Err(e) => e,
        };
        let mut shorter = setup.path_options();
        // Turns that tilt may reach below the height where they begin: each end is above the one
        // before by a stepover at least.
        let stepover_mm = path::flat_stepover_mm(shorter.radius_mm, shorter.settings.scallop_mm);
        let above_mm = ended_mm.map_or(f64::NEG_INFINITY, |before| before + stepover_mm);
        // An end that was asked for stays, and the first turn at least needs room above it.
        let end_mm = blocked
            .region_may_end_mm()
            .filter(|_| setup.job.region.end_mm.is_none())
            .map(|end_mm: f64| end_mm.max(above_mm))
            .filter(|end_mm| *end_mm < setup.job.region.start_mm);
        let Some(end_mm) = end_mm else {
            return by_exact_faces(setup, toolpath, observer).unwrap_or(Err(blocked));
        };
        ended_mm = Some(end_mm);
        shorter.extent.ends.retain(|end| !matches!(end, Boundary::Height(_)));
        shorter.extent.ends.push(Boundary::Height(end_mm));
        *toolpath = timed(observer, Stage::Path, || path::plan(blade, &shorter, observer))?;
        toolpath.end_reason = EndReason::Channel { words: blocked.message, cause: blocked.infeasible };
        cut = Some(Doubt::HelixEndsAbove {
            height_mm: end_mm,
            reason: toolpath.end_reason.clone(),
            advice: blocked.advice.unwrap_or_else(|| "another tool".into()),
        });
    }
    timed(observer, Stage::Channel, || plan(toolpath))
}

/// The channel by the exact faces, for a path on which it closes by their mesh, whose deflection is
/// kept as room. `None` where there are none, where they have been asked already, where the channel
/// closes by them too, and for cutters with a corner, whose ends are by the index.
fn by_exact_faces(setup: &Setup, toolpath: &Toolpath, observer: &dyn Observer) -> Option<Result<Channel>> {
    if setup.blade.part.brep.is_none() || setup.job.channel.exact_ends || !setup.job.tool.is_ball() {
        return None;
    }
    let planned = timed(observer, Stage::Channel, || setup.channel_proven(toolpath, &[], true, observer));
    if planned.as_ref().is_err_and(|e| e.kind == ErrorKind::Infeasible) {
        return None;
    }
    if planned.is_err() {
        return Some(planned);
    }
    let doubt = Doubt::ChannelByExactFaces { proven: setup.job.channel.prove_moves };
    observer.warn(Warning { stage: Stage::Channel, doubt });
    Some(planned)
}
