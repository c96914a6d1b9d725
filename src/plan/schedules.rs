//! Schedules that need the feed to be judged.

use super::{Setup, leads};
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::{AxisMotion, Channel, Lead, Schedule, Toolpath};
use crate::error::{Error, ErrorKind, Result};
use crate::feed::{self, FeedOptions};
use crate::machine::Machine;
use crate::observe::{Observer, Recorder, Silent, Warning};
use crate::parallel;
use crate::schedule::{self, Pace, ScheduleOptions};

/// Lengths over which the rotary axis stands still at either end, as shares of what the ball needs
/// to gain its feed: it is gained more slowly where several axes share it.
const STANDING: [f64; 2] = [1.0, 4.0];

/// A schedule that takes no more over the least time that path and feed allow than this share is
/// taken at once: no other can be faster by more.
pub(crate) const ENOUGH: f64 = 1e-3;
/// Schedules whose time is found with the machine's jerk: those that are fastest without it, which
/// takes a fiftieth of the work. On three blades jerk added the same share of the time to all
/// candidates, within 0.14 %; the two had the fastest among them, or one 0.01 % slower.
const CLOSELY: usize = 2;
/// And no more than this share slower than the fastest without it: several times that difference.
const SLOWER: f64 = 5e-3;

/// Keeps the candidates whose time is to be found with jerk, by their times without.
pub(crate) fn keep_fastest<T>(made: &mut Vec<T>, time_s: impl Fn(&T) -> f64) {
    made.sort_by(|a, b| time_s(a).total_cmp(&time_s(b)));
    made.truncate(CLOSELY);
    let most_s = made.first().map_or(0.0, |first| (1.0 + SLOWER) * time_s(first));
    made.retain(|one| time_s(one) <= most_s);
}

/// Which of the schedules that are planned for the least time one is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Candidate {
    /// That for the least time by the rotary axis alone. It stands still over so many times the
    /// length in which the ball gains its feed.
    Paced(f64),
    /// Another that may be faster.
    Rival(ScheduleKind, Measure),
}

impl Candidate {
    /// Those beside the paced ones. With given ends the optimal ones alone: `fixed` and
    /// `quaternion` are none, `piecewise` has less choice.
    fn rivals(options: &ScheduleOptions) -> Vec<Candidate> {
        let measure = options.settings.measure;
        let optimal = [measure, Measure::SquareSecond].map(|m| Candidate::Rival(ScheduleKind::Optimal, m));
        let published = [ScheduleKind::Piecewise, ScheduleKind::Quaternion, ScheduleKind::Fixed];
        let published = published.map(|kind| Candidate::Rival(kind, measure));
        optimal.into_iter().chain(published.into_iter().filter(|_| options.ends_rad.is_none())).collect()
    }
}

/// The fastest of the schedules that are planned for the machine: the schedule for the least time
/// by the rotary axis alone, the optimal ones and the others, with its motion, in which the leads
/// are, and which of them it is. Rivals that turn back or leave the channel do not take part.
pub(crate) fn least_time(
    setup: &Setup,
    path: &Toolpath,
    channel: &Channel,
    observer: &dyn Observer,
) -> Result<(Schedule, (AxisMotion, [Lead; 2]), Candidate)> {
    let (options, feed) = (setup.schedule_options(), setup.feed_options());
    let paced = |standing: f64| paced_standing(&setup.machine, &feed, path, channel, &options, standing);
    let without_jerk = FeedOptions { limit_jerk: false, ..feed };
    let rough = |(which, schedule): (Candidate, Schedule)| -> Result<RoughSchedule> {
        observer.check(crate::Stage::Schedule)?;
        let told = Recorder::new(&Silent);
        let leads = leads::choose(setup, path, &schedule, &told)?;
        let (motion, leads) = leads::motion_within(setup, &without_jerk, (path, &schedule, None), leads, &Silent)?;
        Ok(RoughSchedule { which, time_s: motion.time_s, schedule, leads, warnings: told.warnings() })
    };
    let moved = |rough: RoughSchedule| -> Result<MovedSchedule> {
        observer.check(crate::Stage::Schedule)?;
        let told = Recorder::new(&Silent);
        let (motion, leads) = leads::motion(setup, path, &rough.schedule, None, rough.leads, &told)?;
        let warnings = rough.warnings.into_iter().chain(told.warnings()).collect();
        Ok(MovedSchedule { which: rough.which, schedule: rough.schedule, motion, leads, warnings })
    };
    let enough_s = feed::least_time(path, &feed) * (1.0 + ENOUGH);
    let (mut made, mut open, mut closed) = (Vec::new(), Vec::new(), None);
    let paced_too = |standing: f64| Ok((Candidate::Paced(standing), paced(standing)?));
    match paced_too(0.0).and_then(rough) {
        Ok(first) if first.time_s <= enough_s => {
            let first = moved(first)?;
            if first.motion.time_s <= enough_s {
                return Ok(first.told(observer));
            }
            made.push(first);
        }
        Ok(first) => open.push(first),
        Err(e) if e.kind == ErrorKind::Infeasible => closed = Some(e),
        Err(e) => return Err(e),
    }
    let (standing, rivals) = parallel::both(
        || parallel::filter_map(&STANDING, |s| paced_too(*s).ok()),
        || made_rivals(path, channel, &options),
    );
    let others: Vec<(Candidate, Schedule)> = standing.into_iter().chain(rivals).collect();
    open.extend(parallel::try_map(others, rough)?);
    keep_fastest(&mut open, |rough| rough.time_s);
    made.extend(parallel::try_map(open, moved)?);
    // Of equals the first.
    match made.into_iter().min_by(|a, b| a.motion.time_s.total_cmp(&b.motion.time_s)) {
        Some(best) => Ok(best.told(observer)),
        None => Err(closed.unwrap_or_else(none_compares)),
    }
}

fn none_compares() -> Error {
    let message = "there is no schedule to be compared";
    Error::infeasible(crate::Stage::Schedule, message, crate::error::Infeasible::NoSchedules)
}

/// One of the candidates again, in a channel that has changed a little: the others would be as far
/// from it as they were. What there was to warn of has been said of the first.
///
/// # Errors
/// Those of its schedule and of its motion.
pub(crate) fn again(
    setup: &Setup,
    (path, channel): (&Toolpath, &Channel),
    which: Candidate,
) -> Result<(Schedule, (AxisMotion, [Lead; 2]))> {
    let options = setup.schedule_options();
    let schedule = match which {
        Candidate::Paced(standing) => {
            paced_standing(&setup.machine, &setup.feed_options(), path, channel, &options, standing)?
        }
        Candidate::Rival(kind, measure) => rival(path, channel, &options, (kind, measure))?,
    };
    let leads = leads::choose(setup, path, &schedule, &Silent)?;
    let motion = leads::motion(setup, path, &schedule, None, leads, &Silent)?;
    Ok((Schedule { kind: ScheduleKind::Time, ..schedule }, motion))
}

/// A candidate with its leads, and its time without limits of jerk.
struct RoughSchedule {
    which: Candidate,
    time_s: f64,
    schedule: Schedule,
    leads: [Lead; 2],
    warnings: Vec<Warning>,
}

/// A candidate with its fastest motion, leads included.
struct MovedSchedule {
    which: Candidate,
    schedule: Schedule,
    motion: AxisMotion,
    leads: [Lead; 2],
    warnings: Vec<Warning>,
}

impl MovedSchedule {
    /// The one that is taken: its warnings are reported, since those of candidates that are not
    /// used would mislead.
    fn told(self, observer: &dyn Observer) -> (Schedule, (AxisMotion, [Lead; 2]), Candidate) {
        self.warnings.into_iter().for_each(|w| observer.warn(w));
        (Schedule { kind: ScheduleKind::Time, ..self.schedule }, (self.motion, self.leads), self.which)
    }
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
    let plan = |standing: f64| paced_standing(machine, feed, path, channel, options, standing);
    let (first, others): (Result<Schedule>, Vec<Schedule>) =
        parallel::both(|| plan(0.0), || parallel::filter_map(&STANDING, |s| plan(*s).ok()));
    match first {
        Err(e) if e.kind != ErrorKind::Infeasible || others.is_empty() => Err(e),
        first => Ok(first.into_iter().chain(others).collect()),
    }
}

/// The one that stands still over so many times the length in which the ball gains its feed.
fn paced_standing(
    machine: &Machine,
    feed: &FeedOptions,
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    standing: f64,
) -> Result<Schedule> {
    let pace = pace(machine, feed.settings.feed_mm_min);
    let speed = feed.settings.feed_mm_min / 60.0;
    // Seconds to full feed of one axis that takes all of it.
    let to_speed = |k: usize| {
        let l = machine.axes()[k].limits;
        speed / l.acceleration
            + if feed.limit_jerk { l.acceleration.min((speed * l.jerk).sqrt()) / l.jerk } else { 0.0 }
    };
    let to_feed_mm = speed * machine.linear().into_iter().map(to_speed).fold(0.0, f64::max);
    let pace = Some(Pace { standing_mm: standing * to_feed_mm, ..pace });
    schedule::plan(ScheduleKind::Time, path, channel, &ScheduleOptions { pace, ..*options }, &Silent)
}

/// Schedules that may be faster on some machine. One that cannot be made is left out.
pub(crate) fn rivals(path: &Toolpath, channel: &Channel, options: &ScheduleOptions) -> Vec<Schedule> {
    made_rivals(path, channel, options).into_iter().map(|(_, schedule)| schedule).collect()
}

fn made_rivals(path: &Toolpath, channel: &Channel, options: &ScheduleOptions) -> Vec<(Candidate, Schedule)> {
    parallel::filter_map(&Candidate::rivals(options), |which| match which {
        Candidate::Rival(kind, measure) => Some((*which, rival(path, channel, options, (*kind, *measure)).ok()?)),
        Candidate::Paced(_) => None,
    })
}

/// # Errors
/// Those of [`schedule::plan`]; kind `Infeasible` where it turns back or leaves the channel.
fn rival(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    (kind, measure): (ScheduleKind, Measure),
) -> Result<Schedule> {
    let made = schedule::plan(kind, path, channel, &options.with(|s| s.measure = measure), &Silent)?;
    if machinable(&made, channel) { Ok(made) } else { Err(none_compares()) }
}

/// Stays in the channel, and never turns back where it is not to.
pub(crate) fn machinable(schedule: &Schedule, channel: &Channel) -> bool {
    (schedule.reversals == 0 || !channel.sweep.is_round()) && schedule.quality.outside_rad <= channel.tolerance_rad
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_fastest_are_looked_at_closely() {
        let kept = |times: &[f64]| {
            let mut all = times.to_vec();
            keep_fastest(&mut all, |t| *t);
            all
        };
        assert_eq!(kept(&[3.0, 1.001, 1.0, 1.002]), [1.0, 1.001]);
        // What is much slower without jerk is slower with it.
        assert_eq!(kept(&[1.2, 1.0, 1.1]), [1.0]);
        assert!(kept(&[]).is_empty());
    }
}
