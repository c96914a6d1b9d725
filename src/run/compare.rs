//! All schedules side by side: at the same constant feed, and each at its own best feed under
//! limits of the machine from a quarter to four times its own. With `feed.smooth` also the path
//! beside its smooth curve.

use std::path::{Path, PathBuf};

use serde::Serialize;

use super::{Loaded, RunFolder};
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::{Axes, AxisRows, Channel, Schedule, Toolpath};
use crate::error::Result;
use crate::feed::{self, AxisPeaks, FeedOptions};
use crate::job::Draft;
use crate::machine::{Axis, Machine};
use crate::observe::{Observer, Recorder, Silent};
use crate::parallel;
use crate::plan::Setup;
use crate::plan::planning::{channel_as_far_as_it_goes, path_as_asked};
use crate::plan::schedules::{machinable, paced};
use crate::schedule;

mod paths;
mod plot;

pub use paths::PathRun;

/// Limits of the machine that are tried, as multiples of its own.
const SCALES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];

/// Name of the schedule that is optimal by the job's own measure.
const OPTIMAL: &str = "optimal";

/// A motion that was found within the limits of jerk exceeds them by less than this factor.
const JERK_ROUNDING: f64 = 1.001;

/// Velocity and acceleration of every axis; mm or degrees, and s.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Peak {
    /// Axis.
    pub axis: String,
    /// Per second.
    pub velocity: f64,
    /// Per second squared.
    pub acceleration: f64,
}

/// One schedule, whatever the machine's limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// Its name: the kind, and what an `optimal` one makes least.
    pub name: String,
    /// Places where it turns back.
    pub reversals: usize,
    /// Greatest distance outside the channel, degrees.
    pub outside_deg: f64,
    /// Never turns back and stays in the channel.
    pub machinable: bool,
    /// Greatest |θ'|, degrees per mm.
    pub rate_deg_mm: f64,
    /// Greatest |θ''|, degrees per mm².
    pub second_deg_mm2: f64,
    /// Seconds to compute.
    pub seconds: f64,
    /// Peaks at the programmed feed held constant.
    pub at_constant_feed: Vec<Peak>,
}

/// One schedule under one set of limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScheduleRun {
    /// Its name.
    pub name: String,
    /// Machining time at its own best feed, s.
    pub time_s: f64,
    /// Where jerk is limited: whether that motion keeps it. Where none is found that does, it keeps
    /// velocity and acceleration only.
    pub within_jerk: Option<bool>,
    /// That time over the lower bound.
    pub over_bound: f64,
    /// Time saved against `fixed`, as a share of the time of `fixed`.
    pub gain_on_fixed: f64,
    /// Greatest constant feed within all limits, mm/min, at most the programmed one.
    pub constant_feed_mm_min: f64,
    /// Machining time at that feed, s.
    pub constant_feed_time_s: f64,
    /// Peaks of its own best feed.
    pub peaks: Vec<Peak>,
}

/// All schedules under one set of limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Multiple of the machine's own limits.
    pub scale: f64,
    /// No schedule and no feed take less, s: every length at the greatest speed that feed and
    /// contact allow, and the least turning in the channel at the rotary axis' greatest velocity.
    pub bound_s: f64,
    /// The schedules.
    pub runs: Vec<ScheduleRun>,
}

/// The comparison.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Blade.
    pub name: String,
    /// Cutter locations.
    pub cutter_locations: usize,
    /// Path length, mm.
    pub path_length_mm: f64,
    /// Programmed feed, mm/min.
    pub feed_mm_min: f64,
    /// Whether jerk was limited.
    pub limit_jerk: bool,
    /// No schedule has a lesser greatest |θ''|, degrees per mm².
    pub bound_second_deg_mm2: Option<f64>,
    /// The schedules.
    pub schedules: Vec<Compared>,
    /// Under limits.
    pub sweep: Vec<Limits>,
    /// With `feed.smooth` the path as it is, evened and as its smooth curve, with the schedule that
    /// is optimal for the job.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub paths: Vec<PathRun>,
}

/// Plans path and channel, then all schedules, and writes `compare.json`, `compare.csv` and
/// `compare.svg`.
///
/// # Errors
/// Those of the stages; a schedule that cannot be made is an error.
pub fn compare(
    draft: &Draft,
    out: &Path,
    limit_jerk: bool,
    observer: &dyn Observer,
) -> Result<(Comparison, Vec<PathBuf>)> {
    let recorder = Recorder::new(observer);
    let mut folder = RunFolder::begin(out)?;
    let setup = Loaded::read(draft, &recorder)?.setup;
    setup.job.tool.ball_only("schedules are compared")?;
    folder.add_job_of_study(&setup.job.to_toml()?)?;
    let mut toolpath = path_as_asked(&setup, &recorder)?;
    let channel = channel_as_far_as_it_goes(&setup, &mut toolpath, &recorder)?;
    let (made, names) = all(&setup, &toolpath, &channel)?;
    let feed = FeedOptions { limit_jerk, ..setup.feed_options() };
    let ground = Ground { setup: &setup, path: &toolpath, channel: &channel, feed: &feed };
    let schedules = names
        .iter()
        .zip(&made)
        .map(|(name, (s, seconds))| ground.figures(name, s, *seconds))
        .collect::<Result<Vec<_>>>()?;
    let sweep = parallel::try_map(&SCALES, |scale| ground.under(*scale, &names, &made))?;
    let optimal = names.iter().zip(&made).find(|(name, _)| *name == OPTIMAL).filter(|_| setup.job.feed.smooth);
    let paths = match optimal {
        Some((_, (schedule, _))) => paths::all(&ground, schedule, &recorder)?,
        None => Vec::new(),
    };
    let bound = made.iter().find_map(|(s, _)| s.quality.bound_second);
    let found = Comparison {
        name: setup.blade.name.clone(),
        cutter_locations: toolpath.locations.len(),
        path_length_mm: toolpath.locations.last().map_or(0.0, |l| l.s_mm),
        feed_mm_min: feed.settings.feed_mm_min,
        limit_jerk,
        bound_second_deg_mm2: bound.map(f64::to_degrees),
        schedules,
        sweep,
        paths,
    };
    folder.add_json("compare.json", &found)?;
    folder.add("compare.csv", table(&found, setup.machine.axes()))?;
    let curves: Vec<(&str, &Schedule)> = names.iter().map(String::as_str).zip(made.iter().map(|m| &m.0)).collect();
    folder.add("compare.svg", plot::svg(&found, &toolpath, &channel, &curves))?;
    Ok((found, folder.finish()?))
}

/// Schedules with the seconds that each took, and their names.
type TimedSchedules = (Vec<(Schedule, f64)>, Vec<String>);

fn all(setup: &Setup, path: &Toolpath, channel: &Channel) -> Result<TimedSchedules> {
    let options = setup.schedule_options();
    let own = options.settings.measure;
    let mut kinds = vec![
        ("fixed", ScheduleKind::Fixed, own),
        ("quaternion", ScheduleKind::Quaternion, own),
        ("piecewise", ScheduleKind::Piecewise, own),
        (OPTIMAL, ScheduleKind::Optimal, own),
    ];
    if own != Measure::SquareSecond {
        kinds.push(("optimal square-second", ScheduleKind::Optimal, Measure::SquareSecond));
    }
    let mut made = Vec::new();
    for (_, kind, measure) in &kinds {
        let start = std::time::Instant::now();
        let s = schedule::plan(*kind, path, channel, &options.with(|s| s.measure = *measure), &Silent)?;
        made.push((s, start.elapsed().as_secs_f64()));
    }
    Ok((made, kinds.iter().map(|k| k.0.to_owned()).collect()))
}

fn peaks_of(p: &AxisPeaks, axes: &[Axis]) -> Vec<Peak> {
    let peak = |(k, axis): (usize, &Axis)| Peak {
        axis: axis.name.clone(),
        velocity: axis.shown(p.velocity[k]),
        acceleration: axis.shown(p.acceleration[k]),
    };
    axes.iter().enumerate().map(peak).collect()
}

/// What all schedules have in common: the path, its channel and the feed.
struct Ground<'a> {
    setup: &'a Setup,
    path: &'a Toolpath,
    channel: &'a Channel,
    feed: &'a FeedOptions,
}

impl Ground<'_> {
    fn figures(&self, name: &str, s: &Schedule, seconds: f64) -> Result<Compared> {
        let Ground { setup, path, channel, feed } = *self;
        Ok(Compared {
            name: name.into(),
            reversals: s.reversals,
            outside_deg: s.quality.outside_rad.to_degrees(),
            machinable: machinable(s, channel),
            rate_deg_mm: s.peak_rate.to_degrees(),
            second_deg_mm2: s.peak_acceleration.to_degrees(),
            seconds,
            at_constant_feed: peaks_of(&feed::peaks(path, s, &setup.machine, feed)?, setup.machine.axes()),
        })
    }

    /// All schedules under scaled limits, then the fastest of those that can be machined and of the
    /// one made for these limits.
    fn under(&self, scale: f64, names: &[String], made: &[(Schedule, f64)]) -> Result<Limits> {
        let Ground { setup, path, channel, feed } = *self;
        let machine = setup.machine.clone().with_limits_scaled(scale);
        let bound_s = feed::least_time(path, feed).max(least_turning(&machine, channel));
        let mut runs = names
            .iter()
            .zip(made)
            .map(|(name, (s, _))| run(name, s, &machine, path, feed, bound_s))
            .collect::<Result<Vec<_>>>()?;
        let mut candidates = paced(&machine, feed, path, channel, &setup.schedule_options())?
            .iter()
            .map(|own| run("time", own, &machine, path, feed, bound_s))
            .collect::<Result<Vec<_>>>()?;
        let others = runs.iter().zip(made).filter(|(_, (s, _))| machinable(s, channel));
        candidates.extend(others.map(|(r, _)| ScheduleRun { name: "time".into(), ..r.clone() }));
        runs.extend(candidates.into_iter().min_by(|a, b| a.time_s.total_cmp(&b.time_s)));
        let fixed = runs.first().map_or(0.0, |r| r.time_s);
        for r in &mut runs {
            r.gain_on_fixed = 1.0 - r.time_s / fixed;
        }
        Ok(Limits { scale, bound_s, runs })
    }
}

fn run(
    name: &str,
    s: &Schedule,
    machine: &Machine,
    path: &Toolpath,
    feed: &FeedOptions,
    bound_s: f64,
) -> Result<ScheduleRun> {
    let motion = feed::plan(path, s, machine, feed, &Silent)?;
    let at = feed::peaks(path, s, machine, feed)?;
    let mut share = 1.0f64;
    let axes = machine.axes();
    for (k, l) in axes.iter().map(|a| a.limits).enumerate() {
        share = share.min(l.velocity / at.velocity[k]).min((l.acceleration / at.acceleration[k]).sqrt());
        if feed.limit_jerk {
            share = share.min((l.jerk / at.jerk[k]).cbrt());
        }
    }
    let constant = share * feed.settings.feed_mm_min;
    let greatest = |rows: &AxisRows| Axes::from_fn(axes.len(), |k| rows.iter().map(|r| r[k].abs()).fold(0.0, f64::max));
    let own = AxisPeaks {
        velocity: greatest(&motion.velocity),
        acceleration: greatest(&motion.acceleration),
        jerk: greatest(&motion.jerk),
    };
    let within = || axes.iter().zip(own.jerk.iter()).all(|(a, j)| *j <= JERK_ROUNDING * a.limits.jerk);
    Ok(ScheduleRun {
        name: name.into(),
        time_s: motion.time_s,
        within_jerk: feed.limit_jerk.then(within),
        over_bound: motion.time_s / bound_s,
        gain_on_fixed: 0.0,
        constant_feed_mm_min: constant,
        constant_feed_time_s: path.locations.last().map_or(0.0, |l| l.s_mm) / (constant / 60.0),
        peaks: peaks_of(&own, axes),
    })
}

/// The rotary axis has to turn at least from the highest start to the lowest end.
fn least_turning(machine: &Machine, channel: &Channel) -> f64 {
    let (first, last) = (channel.rows.first(), channel.rows.last());
    let turn = first.zip(last).map_or(0.0, |(a, b)| b.theta_min - a.theta_max);
    turn.max(0.0) / machine.axes()[machine.turning_axis()].limits.velocity
}

/// The sweep as a table.
fn table(c: &Comparison, axes: &[Axis]) -> String {
    let mut out = String::from(
        "scale,schedule,time_s,within_jerk,over_bound,gain_on_fixed,constant_feed_mm_min,constant_feed_time_s",
    );
    for Axis { name, .. } in axes {
        out.push_str(&format!(",v{name},a{name}"));
    }
    out.push('\n');
    for l in &c.sweep {
        for r in &l.runs {
            out.push_str(&format!(
                "{},{},{},{},{},{},{},{}",
                l.scale,
                r.name,
                r.time_s,
                r.within_jerk.map_or("", |kept| if kept { "yes" } else { "no" }),
                r.over_bound,
                r.gain_on_fixed,
                r.constant_feed_mm_min,
                r.constant_feed_time_s
            ));
            for p in &r.peaks {
                out.push_str(&format!(",{},{}", p.velocity, p.acceleration));
            }
            out.push('\n');
        }
    }
    out
}
