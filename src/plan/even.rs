//! The schedule that turns the blade evenly, with its motion: how fast the ball can go is known
//! only from the machine, and how fast the blade turns only from the schedule.
//!
//! A first motion, on the schedule that is smoothest by itself, gives the speeds that feed, contact
//! and the linear axes allow. The schedule of kind `even` is made for these; where its own motion
//! is held up in some places, the speeds there are what it reached, and the schedule is made again.
//! What still is held up then turns more slowly.

use super::leads::MotionAndLeads;
use super::{Setup, leads};
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::{AxisMotion, Channel, Schedule, Toolpath};
use crate::error::Result;
use crate::observe::{Doubt, Observer, Recorder, Silent, Warning};
use crate::schedule::{self, Speeds};
use crate::{Stage, verify};

/// How often the schedule is made for new speeds.
const ROUNDS: usize = 4;
/// How often turns that are held up are made slower.
const SLOWER: usize = 24;
/// The share by which the speed of turning may leave that of its turn.
const RIPPLE: f64 = 5e-4;
/// What a place that held the axes up gets as its speed, of what was reached.
const REACHED: f64 = 0.97;

/// The schedule and its motion.
pub(super) fn even(
    setup: &Setup,
    path: &Toolpath,
    channel: &Channel,
    observer: &dyn Observer,
) -> Result<(Schedule, MotionAndLeads)> {
    let options = setup.schedule_options();
    let first = options.with(|s| s.measure = Measure::SquareSecond);
    let smooth = schedule::plan(ScheduleKind::Optimal, path, channel, &first, &Silent)?;
    let ((motion, _), _) = moved(setup, path, &smooth)?;
    let limits = setup.machine.axes()[setup.machine.turning_axis()].limits;
    let mut greatest = speeds(path, &motion);
    let least = least_speeds(setup, path, &greatest);
    let made = |greatest: &[f64]| {
        let speeds = Speeds { greatest_mm_s: greatest, least_mm_s: &least, most_rad_s: 0.98 * limits.velocity };
        schedule::even(path, channel, &speeds, &options, observer)
    };
    let mut schedule = made(&greatest)?;
    let mut now = moved(setup, path, &schedule)?;
    for _ in 0..ROUNDS {
        let motion = &now.0.0;
        let held = held_up(path, &schedule, motion);
        if held.iter().all(|share| *share >= 1.0 - RIPPLE) {
            break;
        }
        for (i, share) in held.iter().enumerate().filter(|(_, share)| **share < 1.0 - RIPPLE) {
            let reached = (path.locations[i + 1].s_mm - path.locations[i].s_mm) / (motion.t_s[i + 1] - motion.t_s[i]);
            greatest[i] = greatest[i].min(REACHED * reached * share.max(0.5));
        }
        schedule = made(&greatest)?;
        observer.check(Stage::Schedule)?;
        now = moved(setup, path, &schedule)?;
    }
    for _ in 0..SLOWER {
        let motion = &now.0.0;
        let held = held_up(path, &schedule, motion);
        let mut slower = false;
        for (turn, rate) in schedule.rates.iter_mut().enumerate() {
            let rows = path.turns.get(turn).map_or(0..0, |t| t.first..(t.first + t.count).min(held.len()));
            let least = held[rows].iter().copied().fold(1.0, f64::min);
            if least < 1.0 - RIPPLE {
                *rate *= least.clamp(0.8, 0.999);
                slower = true;
            }
        }
        if !slower {
            break;
        }
        observer.check(Stage::Schedule)?;
        now = moved(setup, path, &schedule)?;
    }
    let ((motion, leads), warnings) = now;
    let worst = held_up(path, &schedule, &motion).into_iter().fold(1.0, f64::min);
    if worst < 1.0 - 2.0 * RIPPLE {
        observer.warn(Warning { stage: Stage::Schedule, doubt: Doubt::NotEven { share: 1.0 - worst } });
    }
    warnings.into_iter().for_each(|w| observer.warn(w));
    Ok((schedule, (motion, leads)))
}

/// The fastest motion on a schedule, with leads, and what is to be said of it.
fn moved(setup: &Setup, path: &Toolpath, schedule: &Schedule) -> Result<(MotionAndLeads, Vec<Warning>)> {
    let told = Recorder::new(&Silent);
    let chosen = leads::choose(setup, path, schedule, &told)?;
    let made = leads::motion(setup, path, schedule, None, chosen, &told)?;
    Ok((made, told.warnings()))
}

/// Speeds of the ball centre in the intervals, mm/s; without end at both ends of the path, where
/// the axes come up from rest and go back to it.
fn speeds(path: &Toolpath, motion: &AxisMotion) -> Vec<f64> {
    let t = &motion.t_s;
    let last = t.len() - 1;
    let of = |i: usize| {
        let way = path.locations[i + 1].s_mm - path.locations[i].s_mm;
        let at_end = t[i] - t[0] < verify::BLEND_S || t[last] - t[i + 1] < verify::BLEND_S;
        if at_end { f64::INFINITY } else { way / (t[i + 1] - t[i]) }
    };
    (0..last).map(of).collect()
}

/// Least speeds by the chip, where the speed of turning is kept at all, mm/s.
fn least_speeds(setup: &Setup, path: &Toolpath, greatest: &[f64]) -> Vec<f64> {
    let chip = setup.job.chip().ok().flatten();
    let least = chip.map_or(0.0, |c| c.contact_mm_s[0]);
    let of = |(w, most): (&[crate::artifact::toolpath::CutterLocation], &f64)| {
        let contact = (w[1].contact - w[0].contact).norm();
        let ratio = (w[1].s_mm - w[0].s_mm) / contact.max(1e-9);
        // What the machine does not reach cannot be asked for.
        if most.is_finite() { (least * ratio).min(0.9 * most) } else { 0.0 }
    };
    path.locations.windows(2).zip(greatest).map(of).collect()
}

/// The speed of turning in each interval as a share of that of its turn; 1 where it is not judged.
fn held_up(path: &Toolpath, schedule: &Schedule, motion: &AxisMotion) -> Vec<f64> {
    let mut out = vec![1.0; path.locations.len() - 1];
    for rows in verify::inner_turns(path, &motion.t_s) {
        for i in rows {
            let rate = (schedule.theta[i + 1] - schedule.theta[i]) / (motion.t_s[i + 1] - motion.t_s[i]);
            let asked = schedule.rates.get(path.locations[i].turn as usize).copied().unwrap_or(rate);
            out[i] = (rate * schedule.spread / asked).min(1.0);
        }
    }
    out
}
