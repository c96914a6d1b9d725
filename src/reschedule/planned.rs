//! A stretch scheduled anew: channel, schedule and time.

use std::sync::OnceLock;

use super::stretches::{FEWEST, Found, LineEnd};
use super::{Keeping, Program, RescheduleOptions, sparse, time};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::GivenPlace;
use crate::artifact::{AxisMotion, Blade, Channel, Cone, Cones, Schedule, Toolpath};
use crate::channel::{self, ChannelOptions, ChannelSettings, Surroundings};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::numerics::angle::{nearest_turn, within_half_turn};
use crate::observe::{Observer, Silent, timed};
use crate::parallel;
use crate::plan::schedules::{self, ENOUGH};
use crate::schedule::{self, ScheduleOptions};
use crate::verify::{self, VerifyOptions};

/// A pass along which the normal turns by less about the blade axis has no sense of turning, rad.
const ALONG_RAD: f64 = 0.2;
/// A schedule begins and ends at the program's angles within this, rad.
const SAME_RAD: f64 = 1e-7;
/// [`ENOUGH`] of a long course, whose schedules and times are dear.
const LONG_ENOUGH: f64 = 0.003;
/// So many places on either side of a line are looked at first.
const LOOK: usize = 50;
/// How often walls are moved in for what happens between places.
const MOST_PROOFS: usize = 4;

/// A stretch as stages take it: places in the order in which θ grows.
pub(super) struct StretchCourse {
    pub path: Toolpath,
    /// The program's own θ, over all turns.
    pub theta: Vec<f64>,
    /// The program goes the other way.
    pub backwards: bool,
}

/// A new schedule for the places from `first` on, as many as the schedule has.
pub(super) struct Planned {
    pub course: StretchCourse,
    pub channel: Channel,
    pub schedule: Schedule,
    /// Index of its first place among those of the stretch.
    pub first: usize,
    /// The motion of the places as the program has them, and with the schedule.
    pub motions: [AxisMotion; 2],
    /// What taper and shank, and the holder, keep from the part, mm.
    pub clearance_mm: [f64; 2],
}

impl Planned {
    /// Index of a location's place among those of the stretch, and the other way round.
    pub fn location(&self, place: usize) -> usize {
        let at = place - self.first;
        if self.course.backwards { self.schedule.theta.len() - 1 - at } else { at }
    }
}

/// The fastest schedule, with the motion before and after; or after which places the tool would
/// come too near to the part with it.
type Fastest = std::result::Result<(Schedule, [AxisMotion; 2]), Vec<usize>>;

/// What is in the tool's way, indexed once: coarsely, and by exact faces where that is asked for.
pub(super) struct Arounds<'a> {
    blade: &'a Blade,
    radius_mm: f64,
    usual: Surroundings<'a>,
    finer: OnceLock<Surroundings<'a>>,
}

impl<'a> Arounds<'a> {
    /// # Errors
    /// Those of [`Surroundings::new`].
    pub fn new(blade: &'a Blade, radius_mm: f64) -> Result<Self> {
        Ok(Arounds { blade, radius_mm, usual: Surroundings::new(blade, &[], radius_mm)?, finer: OnceLock::new() })
    }

    fn finer(&self) -> Result<&Surroundings<'a>> {
        if let Some(made) = self.finer.get() {
            return Ok(made);
        }
        let made = Surroundings::new(self.blade, &[], self.radius_mm)?.finer(self.radius_mm);
        Ok(self.finer.get_or_init(|| made))
    }
}

/// What stretches are scheduled with.
pub(super) struct StretchScene<'a> {
    pub program: &'a Program<'a>,
    pub blade: &'a Blade,
    pub around: &'a Arounds<'a>,
    /// Lines at which the program's own clearances are least.
    pub tight_lines: &'a [usize],
    pub options: &'a RescheduleOptions,
    pub observer: &'a dyn Observer,
}

impl StretchScene<'_> {
    /// A new schedule with the first of the clearances that allow one, or why there is none.
    ///
    /// # Errors
    /// Those of the stages but `Infeasible`, which is the reason.
    pub fn plan(&self, found: &Found, clearances: &[Keeping]) -> Result<std::result::Result<Planned, String>> {
        let mut last = Err("nothing is asked for".to_owned());
        for keeping in clearances {
            last = match self.planned(found, keeping) {
                Err(e) if e.kind == ErrorKind::Infeasible => Err(e.message),
                planned => planned?,
            };
            if last.as_ref().is_ok_and(|p| p.motions[1].time_s < p.motions[0].time_s) {
                break;
            }
        }
        Ok(last)
    }

    fn planned(&self, found: &Found, keeping: &Keeping) -> Result<std::result::Result<Planned, String>> {
        let settings = &keeping.settings;
        let count = found.places.len();
        let whole = self.course(found, [0, count - 1]);
        timed(self.observer, Stage::Channel, || self.opens(found, settings))?;
        let channel = timed(self.observer, Stage::Channel, || self.channel(&whole.path, settings, &[]))?;
        let theta = on_branch(&whole.theta, &channel);
        let Some([from, to]) = within(&theta, &channel) else {
            let why =
                "the program keeps nowhere on it to the channel, so no new θ can begin and end where its own does";
            return Ok(Err(why.into()));
        };
        let ends = [theta[from], theta[to]];
        // By places of the program.
        let [first, last] = if whole.backwards { [count - 1 - to, count - 1 - from] } else { [from, to] };
        let is_whole = from == 0 && to + 1 == count;
        let course = if is_whole { whole } else { self.course(found, [first, last]) };
        let mut channel = if is_whole { channel } else { channel::part(&channel, [from, to]) };
        let anew = |prove_at: &[usize]| {
            timed(self.observer, Stage::Channel, || self.channel(&course.path, settings, prove_at))
        };
        let places = found.places.get(first..=last).unwrap_or_default();
        let mut prove_at = Vec::new();
        for _ in 0..MOST_PROOFS {
            let short = |schedule: &Schedule| self.short(&course.path, schedule, keeping);
            match self.fastest(&course, &channel, ends, places, &short)? {
                Ok((schedule, motions)) => {
                    let clearance_mm = [settings.clearance_mm, settings.holder_clearance_mm];
                    return Ok(Ok(Planned { course, channel, schedule, first, motions, clearance_mm }));
                }
                Err(short) => prove_at.extend(short),
            }
            prove_at.sort_unstable();
            prove_at.dedup();
            channel = anew(&prove_at)?;
        }
        Ok(Err("between its lines the tool would come too near to the part".into()))
    }

    /// Looks at the places first where the program comes nearest to the part: a channel of the
    /// whole course that closes there costs much.
    ///
    /// # Errors
    /// That a place has no free angle.
    fn opens(&self, found: &Found, settings: &ChannelSettings) -> Result<()> {
        let last = found.places.len() - 1;
        for line in self.tight_lines {
            let Some(at) = found.places.iter().position(|p| self.program.line(p) == *line) else { continue };
            let near = self.course(found, [at.saturating_sub(LOOK), (at + LOOK).min(last)]);
            match self.channel(&near.path, settings, &[]) {
                Err(e) if is_taken(&e) || e.kind != ErrorKind::Infeasible => return Err(e),
                _ => {}
            }
        }
        Ok(())
    }

    /// Places of a stretch, from one to another, as stages take them.
    fn course(&self, found: &Found, [first, last]: [usize; 2]) -> StretchCourse {
        let (radius_mm, stock_mm) = (self.program.bench.tool.radius_mm, self.options.stock_mm.unwrap_or(0.0));
        let mut places: Vec<&LineEnd> = found.places.get(first..=last).unwrap_or_default().iter().collect();
        let backwards = runs_backwards(&places);
        if backwards {
            places.reverse();
        }
        let mut cones = found.cones.part(first, last + 1);
        if let (true, Cones::Each(each)) = (backwards, &mut cones) {
            each.reverse();
        }
        let mut turned_rad = 0.0;
        let given: Vec<GivenPlace> = places
            .iter()
            .enumerate()
            .map(|(k, place)| {
                turned_rad += k.checked_sub(1).map_or(0.0, |before| normal_turned(places[before], place));
                let centre = place.stand.centre;
                let foot = place.at.as_ref().map_or(centre, |c| c.point);
                let normal = (centre - foot).try_normalize(1e-12).unwrap_or(Vector::x());
                GivenPlace { centre, normal, turned_rad }
            })
            .collect();
        let path = Toolpath::given(&given, [radius_mm, stock_mm, self.options.chord_mm], cones);
        StretchCourse { path, theta: places.iter().map(|p| p.stand.theta).collect(), backwards }
    }

    /// The channel; by exact faces where it closes by their mesh. Along a long course those are
    /// dear: a mesh that is nearer to them comes before, where hardly anything is free and then
    /// everywhere. Where that leaves a place no angle at all the faces would not either.
    fn channel(&self, path: &Toolpath, settings: &ChannelSettings, prove_at: &[usize]) -> Result<Channel> {
        let (tool, machine) = (self.program.bench.tool, self.program.bench.machine);
        let stock_mm = path.stock_mm.max(0.0);
        let usual = ChannelOptions {
            settings: settings.clone(),
            theta_limits_rad: machine.theta_limits(path.cone(0).lean_rad),
            prove_at: prove_at.to_vec(),
            ..ChannelOptions::default()
        };
        let usual = usual.with(|s| {
            (s.clearance_mm, s.holder_clearance_mm) = (s.clearance_mm + stock_mm, s.holder_clearance_mm + stock_mm);
        });
        let coarse = &self.around.usual;
        if self.blade.part.brep.is_none() {
            return channel::plan_among(coarse, tool, path, &usual, &Silent);
        }
        let exact = usual.clone().with(|s| s.exact_ends = true);
        let is_long = sparse::is_long(path);
        let (mut planned, then) = match is_long {
            true => {
                let finer = || self.around.finer();
                (channel::plan_among_finer(coarse, &finer, tool, path, &usual, &Silent), &[&usual, &exact][..])
            }
            false => (channel::plan_among(coarse, tool, path, &usual, &Silent), &[&exact][..]),
        };
        let may_open = |e: &Error| e.kind == ErrorKind::Infeasible && !(is_long && is_taken(e));
        for next in then {
            self.observer.check(Stage::Channel)?;
            if !planned.as_ref().is_err_and(may_open) {
                break;
            }
            planned = channel::plan_among(self.around.finer()?, tool, path, next, &Silent);
        }
        planned
    }

    /// The fastest of the schedules that are made for the kind that is asked for, with the motion
    /// of the program's own places and its own. `Err`: moves of the one that is fastest but for
    /// jerk on which the tool comes nearer than it may, as `short` has them.
    fn fastest(
        &self,
        course: &StretchCourse,
        channel: &Channel,
        ends: [f64; 2],
        places: &[LineEnd],
        short: &(dyn Fn(&Schedule) -> Vec<usize> + Sync),
    ) -> Result<Fastest> {
        let (path, bench) = (&course.path, self.program.bench);
        let own = super::speeds(places);
        let asked = self.options.feed_mm_min.map_or_else(|| own.clone(), |feed| vec![feed / 60.0; own.len()]);
        let most_mm_min = 60.0 * asked.iter().fold(0.0f64, |m, v| m.max(*v));
        let on_machine = (bench.tool, bench.machine);
        let centres: Vec<Point> = places.iter().map(|p| p.stand.centre).collect();
        let centres = timed(self.observer, Stage::Feed, || time::Centres::of(&centres));
        let moved = |schedule: &Schedule, limit_jerk: bool| {
            let mut theta = schedule.theta.clone();
            let mut cones: Vec<Cone> = (0..theta.len()).map(|row| path.cone(row)).collect();
            if course.backwards {
                theta.reverse();
                cones.reverse();
            }
            let way = time::TimedWay { theta, cones, speeds_mm_s: &asked };
            time::motion(&centres, &way, on_machine, self.options.chord_mm, limit_jerk)
        };
        // Where one has nearly the least time that the speeds allow, no other is made.
        let steps = places.windows(2).map(|w| (w[1].stand.centre - w[0].stand.centre).norm());
        let least_s: f64 = steps.zip(&asked).map(|(mm, speed)| mm / speed).sum();
        let enough = if sparse::is_long(path) { LONG_ENOUGH } else { ENOUGH };
        let is_enough = |s: &Schedule| moved(s, false).is_ok_and(|motion| motion.time_s <= (1.0 + enough) * least_s);
        // Jerk is dear: the few that are fastest without it are looked at with it, where they keep
        // clear.
        let rough = |schedule: Schedule| Ok((moved(&schedule, false)?.time_s, schedule));
        let schedules = || -> Result<Vec<(f64, Schedule)>> {
            let made = self.schedules(course, channel, ends, most_mm_min, &is_enough)?;
            if made.len() < 2 {
                return Ok(made.into_iter().map(|schedule| (0.0, schedule)).collect());
            }
            let mut made = parallel::try_map(made, rough)?;
            schedules::keep_fastest(&mut made, |(time_s, _)| *time_s);
            Ok(made)
        };
        let before = || {
            let (theta, cones) = places.iter().map(|p| (p.stand.theta, p.stand.cone)).unzip();
            let way = time::TimedWay { theta, cones, speeds_mm_s: &own };
            time::motion(&centres, &way, on_machine, self.options.chord_mm, true)
        };
        // Schedules of one course leave a thread free.
        let (made, before) = timed(self.observer, Stage::Schedule, || parallel::both(schedules, before));
        let made = made?;
        let shorts = timed(self.observer, Stage::Channel, || parallel::map(&made, |(_, schedule)| short(schedule)));
        if let Some(first) = shorts.first().filter(|s| !s.is_empty()) {
            return Ok(Err(first.clone()));
        }
        let made: Vec<(f64, Schedule)> =
            made.into_iter().zip(shorts).filter(|(_, short)| short.is_empty()).map(|(one, _)| one).collect();
        let closely = |(_, schedule): (f64, Schedule)| Ok((moved(&schedule, true)?, schedule));
        let made = timed(self.observer, Stage::Feed, || parallel::try_map(made, closely))?;
        let best = made.into_iter().min_by(|a, b| a.0.time_s.total_cmp(&b.0.time_s));
        let Some((after, schedule)) = best else {
            let message = "no schedule of the kind begins and ends at the program's angles within the channel";
            return Err(Error::infeasible(Stage::Schedule, message, Infeasible::NoSchedules));
        };
        Ok(Ok((schedule, [before?, after])))
    }

    /// Schedules within the channel, from end to end. A long course is scheduled at some of its
    /// places, or where that makes none at all of them.
    fn schedules(
        &self,
        course: &StretchCourse,
        channel: &Channel,
        ends: [f64; 2],
        most_mm_min: f64,
        is_enough: &(dyn Fn(&Schedule) -> bool + Sync),
    ) -> Result<Vec<Schedule>> {
        let path = &course.path;
        let at_all = |s: Schedule| sparse::at_all(s, path, channel);
        let is_enough_at_all = |s: &Schedule| at_all(s.clone()).is_some_and(|s| is_enough(&s));
        if let Some((few, walls)) = sparse::course(path, channel, ends) {
            let made = match self.schedules_at(&few, &walls, ends, most_mm_min, &is_enough_at_all) {
                Err(e) if e.kind != ErrorKind::Infeasible => return Err(e),
                made => parallel::filter_map(made.unwrap_or_default(), at_all),
            };
            if !made.is_empty() {
                return Ok(made);
            }
        }
        self.schedules_at(path, channel, ends, most_mm_min, is_enough)
    }

    /// Schedules at the places of a path; of kind `time` the first alone where that is fast enough.
    fn schedules_at(
        &self,
        path: &Toolpath,
        channel: &Channel,
        ends: [f64; 2],
        most_mm_min: f64,
        is_enough: &(dyn Fn(&Schedule) -> bool + Sync),
    ) -> Result<Vec<Schedule>> {
        let machine = self.program.bench.machine;
        let pace = Some(schedules::pace(machine, most_mm_min));
        let settings = self.options.schedule;
        let options = ScheduleOptions { settings, pace, ends_rad: Some(ends), ..ScheduleOptions::default() };
        let keeps = |s: &Schedule| {
            let own = s.theta.first().zip(s.theta.last()).map(|(a, b)| [*a, *b]);
            let at_ends = own.is_some_and(|own| own.iter().zip(ends).all(|(a, b)| (a - b).abs() <= SAME_RAD));
            at_ends && schedules::machinable(s, channel)
        };
        let made = match settings.kind {
            // Nothing is to stand still at the ends: there the program goes on.
            ScheduleKind::Time => match schedule::plan(ScheduleKind::Time, path, channel, &options, &Silent) {
                Ok(own) if keeps(&own) && is_enough(&own) => vec![own],
                own => match (own, schedules::rivals(path, channel, &options)) {
                    (Err(e), rivals) if e.kind != ErrorKind::Infeasible || rivals.is_empty() => return Err(e),
                    (own, rivals) => own.into_iter().chain(rivals).collect(),
                },
            },
            kind => vec![schedule::plan(kind, path, channel, &options, &Silent)?],
        };
        Ok(made.into_iter().filter(keeps).collect())
    }

    /// Moves on which the tool comes nearer than it may.
    fn short(&self, path: &Toolpath, schedule: &Schedule, keeping: &Keeping) -> Vec<usize> {
        let (stock_mm, usual) = (path.stock_mm.max(0.0), VerifyOptions::default());
        let settings = &keeping.settings;
        let [clearance_mm, holder_clearance_mm] = match keeping.least_mm {
            Some(least_mm) => least_mm.map(|least| usual.asked_clearance(least + stock_mm)),
            None => [settings.clearance_mm, settings.holder_clearance_mm].map(|asked| asked + stock_mm),
        };
        let options = VerifyOptions { clearance_mm, holder_clearance_mm, ..usual };
        let apart = verify::apart(self.blade, &[], self.program.bench.tool, &options);
        verify::short_moves(path, &schedule.theta, &apart, &options)
    }
}

/// The channel closes because some place has no free angle at all.
fn is_taken(e: &Error) -> bool {
    matches!(e.infeasible.as_deref(), Some(Infeasible::NoFreeAngle { .. }))
}

/// θ grows counter-clockwise about the blade axis: a pass along which the normal of the part turns
/// the other way is planned from its end. Where the normal hardly turns, the program's own θ
/// decides.
fn runs_backwards(places: &[&LineEnd]) -> bool {
    let turned: f64 = places.windows(2).map(|w| normal_turned(w[0], w[1])).sum();
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return false };
    if turned.abs() > ALONG_RAD { turned < 0.0 } else { last.stand.theta < first.stand.theta }
}

/// By how much the normal of the part turns about the blade axis from one place to the next, rad.
fn normal_turned(from: &LineEnd, to: &LineEnd) -> f64 {
    let azimuth =
        |p: &LineEnd| p.at.as_ref().map_or(0.0, |c| (p.stand.centre.z - c.point.z).atan2(p.stand.centre.y - c.point.y));
    within_half_turn(azimuth(to) - azimuth(from))
}

/// Angles by whole turns to where the channel counts them.
fn on_branch(theta: &[f64], channel: &Channel) -> Vec<f64> {
    let mut turns: Vec<f64> =
        theta.iter().zip(&channel.rows).map(|(t, r)| nearest_turn(*t, 0.5 * (r.theta_min + r.theta_max)) - t).collect();
    turns.sort_by(f64::total_cmp);
    let most = turns.get(turns.len() / 2).copied().unwrap_or(0.0);
    theta.iter().map(|t| t + most).collect()
}

/// The first and the last place at which the program's θ is in the channel, so that θ need not turn
/// back between; `None`: there is no such length.
fn within(theta: &[f64], channel: &Channel) -> Option<[usize; 2]> {
    let holds =
        |k: &usize| theta.get(*k).zip(channel.rows.get(*k)).is_some_and(|(t, r)| (r.hull_min..=r.hull_max).contains(t));
    let from = (0..theta.len()).find(holds)?;
    let to = (from + FEWEST..theta.len()).rev().find(|k| holds(k) && theta[*k] >= theta[from])?;
    Some([from, to])
}
