//! Schedules that need the feed to be judged.

use rayon::prelude::*;

use super::{Setup, leads};
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::{AxisMotion, Channel, Lead, Schedule, Toolpath};
use crate::error::{Error, ErrorKind, Result};
use crate::feed::FeedOptions;
use crate::machine::Machine;
use crate::observe::{Observer, Recorder, Silent, Warning};
use crate::schedule::{self, Pace, ScheduleOptions};

/// Lengths over which the rotary axis stands still at either end, as shares of what the ball needs
/// to gain its feed: it is gained more slowly where several axes share it.
const STANDING: [f64; 2] = [1.0, 4.0];

/// The fastest of all schedules that are planned for the machine: the schedule for the least time
/// by the rotary axis alone, the optimal ones and the others, with its motion, in which the leads
/// are. Candidates that turn back or leave the channel do not take part.
pub(crate) fn least_time(
    setup: &Setup,
    path: &Toolpath,
    channel: &Channel,
    observer: &dyn Observer,
) -> Result<(Schedule, (AxisMotion, [Lead; 2]))> {
    let (options, feed) = (setup.schedule_options(), setup.feed_options());
    let (own, rivals) =
        rayon::join(|| paced(&setup.machine, &feed, path, channel, &options), || rivals(path, channel, &options));
    let own = match own {
        Err(e) if e.kind == ErrorKind::Infeasible && !rivals.is_empty() => Vec::new(),
        own => own?,
    };
    let moved = |schedule: Schedule| -> Result<MovedSchedule> {
        observer.check(crate::Stage::Schedule)?;
        let told = Recorder::new(&Silent);
        let leads = leads::choose(setup, path, &schedule, &told)?;
        let (motion, leads) = leads::motion(setup, path, &schedule, None, leads, &told)?;
        Ok(MovedSchedule { schedule, motion, leads, warnings: told.warnings() })
    };
    let candidates: Vec<Schedule> = own.into_iter().chain(rivals).collect();
    let moved: Vec<Result<MovedSchedule>> = candidates.into_par_iter().map(moved).collect();
    let moved = moved.into_iter().collect::<Result<Vec<_>>>()?;
    // Of equals the first.
    let best = moved.into_iter().min_by(|a, b| a.motion.time_s.total_cmp(&b.motion.time_s));
    let Some(MovedSchedule { mut schedule, motion, leads, warnings }) = best else {
        return Err(Error::infeasible(
            crate::Stage::Schedule,
            "there is no schedule to be compared",
            crate::error::Infeasible::NoSchedules,
        ));
    };
    // Warnings of candidates that are not used would mislead.
    warnings.into_iter().for_each(|w| observer.warn(w));
    schedule.kind = ScheduleKind::Time;
    Ok((schedule, (motion, leads)))
}

/// A candidate with its fastest motion, leads included.
struct MovedSchedule {
    schedule: Schedule,
    motion: AxisMotion,
    leads: [Lead; 2],
    warnings: Vec<Warning>,
}

/// What the rotary axis can follow at the programmed feed.
pub(crate) fn pace(machine: &Machine, feed_mm_min: f64) -> Pace {
    let (limits, f) = (machine.axes()[machine.turning_axis()].limits, feed_mm_min / 60.0);
    Pace { rate: limits.velocity / f, second: limits.acceleration / (f * f), standing_mm: 0.0 }
}

/// Candidates for the least time by the rotary axis alone: turning as it suits all of the path, and
/// standing still while the ball gains and loses its feed.
///
/// # Errors
/// Those of [`schedule::plan`], where it makes none of them.
pub(crate) fn paced(
    machine: &Machine,
    feed: &FeedOptions,
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
) -> Result<Vec<Schedule>> {
    let pace = pace(machine, feed.settings.feed_mm_min);
    let speed = feed.settings.feed_mm_min / 60.0;
    // Seconds to full feed of one axis that takes all of it.
    let to_speed = |k: usize| {
        let l = machine.axes()[k].limits;
        speed / l.acceleration
            + if feed.limit_jerk { l.acceleration.min((speed * l.jerk).sqrt()) / l.jerk } else { 0.0 }
    };
    let to_feed_mm = speed * machine.linear().into_iter().map(to_speed).fold(0.0, f64::max);
    let plan = |standing: f64| {
        let pace = Some(Pace { standing_mm: standing * to_feed_mm, ..pace });
        schedule::plan(ScheduleKind::Time, path, channel, &ScheduleOptions { pace, ..*options }, &Silent)
    };
    let (first, others): (Result<Schedule>, Vec<Schedule>) =
        rayon::join(|| plan(0.0), || STANDING.par_iter().filter_map(|s| plan(*s).ok()).collect());
    match first {
        Err(e) if e.kind != ErrorKind::Infeasible || others.is_empty() => Err(e),
        first => Ok(first.into_iter().chain(others).collect()),
    }
}

/// Schedules that may be faster on some machine. One that cannot be made is left out.
pub(crate) fn rivals(path: &Toolpath, channel: &Channel, options: &ScheduleOptions) -> Vec<Schedule> {
    let optimal = |measure| (ScheduleKind::Optimal, options.with(|s| s.measure = measure));
    let kinds = [
        optimal(options.settings.measure),
        optimal(Measure::SquareSecond),
        (ScheduleKind::Piecewise, *options),
        (ScheduleKind::Quaternion, *options),
        (ScheduleKind::Fixed, *options),
    ];
    kinds
        .par_iter()
        .filter_map(|(kind, options)| schedule::plan(*kind, path, channel, options, &Silent).ok())
        .filter(|s| machinable(s, channel))
        .collect()
}

/// Stays in the channel, and never turns back where it is not to.
pub(crate) fn machinable(schedule: &Schedule, channel: &Channel) -> bool {
    (schedule.reversals == 0 || !channel.sweep.is_round()) && schedule.quality.outside_rad <= channel.tolerance_rad
}
