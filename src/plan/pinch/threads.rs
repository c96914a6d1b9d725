//! Both tools round the blade on two threads of one helix, while the table turns all along.
//!
//! **In** a [`Setup`] with its path, **out** one row of both tools. **Method** The helix of one
//! tool ([`Setup::path`]) parted into two threads ([`Threads`]). What is free for both along them
//! is a channel as any other ([`pair::chain`], [`channel::of_walls`]), with the longer way of both
//! tools for its arc length, and gets a schedule as any other ([`schedule::plan`]): first with as
//! many places as the chord tolerance asks for, then with as many more as keep both balls on their
//! way while the table turns so.

use std::ops::Range;

use super::{AroundBoth, Shared, TURNING_CHORD, closed, motion, within_turns};
use crate::artifact::paired::{Held, PairPlace};
use crate::artifact::region::Boundary;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Cone, Cones, PairedRows, Schedule, Toolpath};
use crate::channel;
use crate::error::{EndReason, Error, Infeasible, Result, Stage};
use crate::observe::{Doubt, Observer, Warning, timed};
use crate::pair::{self, Both, FreeAngles, PinchEdges, PinchOrientation, Planned};
use crate::path::pairs::Threads;
use crate::path::{self, PathOptions};
use crate::plan::Setup;
use crate::plan::planning::{MOST_ENDS, path_as_asked};
use crate::plan::schedules;
use crate::schedule;
use crate::section::{self, SectionOptions};
use crate::verify;

/// How much threads go on by their normals: the first with which the table can serve both is taken.
const BY_NORMAL: [f64; 4] = [0.1, 0.2, 0.35, 0.5];
/// Places are as near as if the table turned so many times as fast: with these it may turn
/// otherwise than with those that were there before.
const FASTER: f64 = 1.25;
/// So often at most, since the table may turn otherwise with nearer places …
const MOST_PARTINGS: usize = 3;
/// … and no more where moves would be parted into so many: they then keep to the tolerance as they
/// are, of which a share is allowed for.
const ENOUGH_PARTS: usize = 2;
/// Where the 99th percentile of the ridges is over what is asked for by more than this factor, the
/// helix is laid anew with a lower scallop …
const HIGHER: f64 = 1.04;
/// … with which it would be over it by this factor …
const ENOUGH: f64 = 1.02;
/// … so often at most.
const MOST_LOWER: usize = 3;
/// Sections on which the blade's thickness is taken.
const SECTIONS: u32 = 5;
/// A blade that is thinner than this share of its chord bends and twists under a couple.
const THIN: f64 = 0.08;

impl Setup {
    /// Both threads, and the table's angles along them.
    ///
    /// # Errors
    /// Kind `Usage` for keys that count along rows only; those of [`Setup::path`] and
    /// [`Threads`]; kind `Infeasible` where at a place no angle of the table is free for both.
    pub(super) fn double_helix(&self, at: ([Cone; 2], f64), observer: &dyn Observer) -> Result<Shared> {
        self.is_for_threads()?;
        let mut options = self.path_options();
        let mut path = timed(observer, Stage::Path, || path_as_asked(self, observer))?;
        let around = timed(observer, Stage::Channel, || self.around_both())?;
        let mut ended: Option<Doubt> = None;
        let asked_mm = options.settings.scallop_mm;
        let mut lowered = 0;
        for _ in 0..MOST_ENDS {
            let blocked = match self.least_by_normal(&path, &options, &around, at, observer)? {
                Ok(mut shared) => {
                    shared.rows.scallop_mm = asked_mm;
                    let found_mm = timed(observer, Stage::Path, || {
                        Ok(verify::threads_p99_mm(&shared.rows, &self.blade.part, asked_mm))
                    })?;
                    // Where the curvature changes abruptly, threads between two turns of the helix
                    // may leave more than these: nearer turns leave less.
                    if found_mm > HIGHER * asked_mm && lowered < MOST_LOWER {
                        lowered += 1;
                        options.settings.scallop_mm *= ENOUGH * asked_mm / found_mm;
                        path = timed(observer, Stage::Path, || path::plan(&self.blade, &options, observer))?;
                        continue;
                    }
                    ended.into_iter().for_each(|doubt| observer.warn(Warning { stage: Stage::Channel, doubt }));
                    self.warn_of_thin(path.region_x_mm, observer)?;
                    return Ok(shared);
                }
                Err(blocked) => blocked,
            };
            // An end that was asked for stays.
            let end_mm = blocked.above_mm;
            if self.job.region.end_mm.is_some() || end_mm >= self.job.region.start_mm {
                return Err(blocked.error);
            }
            options.extent.ends.retain(|end| !matches!(end, Boundary::Height(_)));
            options.extent.ends.push(Boundary::Height(end_mm));
            path = timed(observer, Stage::Path, || path::plan(&self.blade, &options, observer))?;
            let Error { message, infeasible, advice, .. } = blocked.error;
            ended = Some(Doubt::HelixEndsAbove {
                height_mm: end_mm,
                reason: EndReason::Channel { words: message, cause: infeasible },
                advice: advice.unwrap_or_else(|| "another tool".into()),
            });
        }
        self.least_by_normal(&path, &options, &around, at, observer)?.map_err(|blocked| blocked.error)
    }

    /// The threads that go on as little by their normals as lets the table serve both; where all
    /// are blocked, that which may go on lowest.
    fn least_by_normal(
        &self,
        path: &Toolpath,
        options: &PathOptions,
        around: &AroundBoth,
        at: ([Cone; 2], f64),
        observer: &dyn Observer,
    ) -> Result<std::result::Result<Shared, Blocked>> {
        let mut lowest: Option<Blocked> = None;
        let mut threads = timed(observer, Stage::Path, || Threads::of(&self.blade, options, path))?;
        for by_normal in BY_NORMAL {
            threads.keep_step(by_normal);
            match self.threads_of(&threads, around, at, observer)? {
                Ok(shared) => return Ok(Ok(shared)),
                Err(blocked) if lowest.as_ref().is_none_or(|l| blocked.above_mm < l.above_mm) => lowest = Some(blocked),
                Err(_) => {}
            }
        }
        lowest.map(Err).ok_or_else(|| Error::usage(Stage::Path, "no threads were looked at"))
    }

    /// The places of threads, and the table's angles along them.
    fn threads_of(
        &self,
        threads: &Threads,
        around: &AroundBoth,
        at: ([Cone; 2], f64),
        observer: &dyn Observer,
    ) -> Result<std::result::Result<Shared, Blocked>> {
        let mut laid = timed(observer, Stage::Path, || threads.lay(observer))?;
        let turning = |rows: &PairedRows, closely| {
            let own = self.free_of_both(around, rows, at.0, observer)?;
            timed(observer, Stage::Schedule, || self.turning_along(rows.clone(), own, at, closely, observer))
        };
        let mut found = turning(&laid.rows, false)?;
        for round in 0..MOST_PARTINGS {
            let Ok(shared) = &found else { break };
            let mut parts = self.parts(shared);
            if round > 0 {
                parts.iter_mut().filter(|parts| **parts <= ENOUGH_PARTS).for_each(|parts| *parts = 1);
                if parts.iter().all(|parts| *parts == 1) {
                    break;
                }
            }
            laid = timed(observer, Stage::Path, || threads.parted(&laid, &parts))?;
            found = turning(&laid.rows, true)?;
        }
        Ok(found)
    }

    /// Keys that say something else.
    fn is_for_threads(&self) -> Result<()> {
        self.shares_the_table("a double helix is planned")?;
        let (job, asked, tools) = (&self.job, self.pinch_settings(), self.pinch_tools());
        if self.blade.part.brep.is_none() {
            let message =
                "the part is a mesh: places of a double helix are so near to each other that its facets shake all axes";
            return Err(Error::infeasible(Stage::Path, message, Infeasible::NoPairs)
                .advise("take the CAD model with its exact faces (STEP or IGES)"));
        }
        let refuse = |message: String, advice: &str| Err(Error::usage(Stage::Job, message).advise(advice));
        let [first, second] = tools.map(|t| t.radius_mm);
        if first != second {
            let message = format!(
                "the balls have radii of {first} and {second} mm: the threads of a double helix are for balls of one radius"
            );
            return refuse(message, "leave out tool_2.radius_mm, or take pinch.topology = \"opposed-rows\"");
        }
        if asked.edges != PinchEdges::None {
            return refuse(
                "pinch.edges is for rows: a double helix goes round both edges".into(),
                "leave out pinch.edges",
            );
        }
        if asked.heights_mm.is_some() {
            return refuse(
                "pinch.heights_mm is for rows: a double helix lies in the region of the job".into(),
                "give region.start_mm and region.end_mm",
            );
        }
        match asked.orientation {
            PinchOrientation::Hold => {}
            PinchOrientation::Smooth | PinchOrientation::Time | PinchOrientation::Paper => {
                return refuse(
                    "pinch.orientation is for rows: along a double helix the table turns all the time".into(),
                    "leave out pinch.orientation; schedule.kind says how it turns",
                );
            }
        }
        match job.schedule.kind {
            ScheduleKind::Time | ScheduleKind::Optimal | ScheduleKind::Piecewise => Ok(()),
            kind => refuse(
                format!("schedule.kind is {}: along a double helix it is time, optimal or piecewise", kind.name()),
                "leave out schedule.kind",
            ),
        }
    }

    /// A warning where the blade is too thin for a couple.
    fn warn_of_thin(&self, [a, b]: [f64; 2], observer: &dyn Observer) -> Result<()> {
        let (low, high) = (a.min(b), a.max(b));
        let at = |k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(SECTIONS);
        let options = SectionOptions { heights_mm: (0..SECTIONS).map(at).collect(), ..SectionOptions::default() };
        let sections = section::plan(&self.blade, &options, observer)?;
        let shares = sections.iter().filter_map(|s| s.loops.first()).map(|l| l.thickness_mm / l.chord_mm);
        let thickness_over_chord = shares.fold(f64::INFINITY, f64::min);
        if thickness_over_chord < THIN {
            observer.warn(Warning { stage: Stage::Path, doubt: Doubt::NothingHeld { thickness_over_chord } });
        }
        Ok(())
    }

    /// Angles along all of the threads, which never fall. `closely`: of all candidates the one with
    /// which the machine is fastest; else one that is nearly so.
    fn turning_along(
        &self,
        rows: PairedRows,
        [first, second]: [Vec<FreeAngles>; 2],
        (cones, between_rad): ([Cone; 2], f64),
        closely: bool,
        observer: &dyn Observer,
    ) -> Result<std::result::Result<Shared, Blocked>> {
        let own = [first, second.iter().map(|f| f.turned(-between_rad)).collect::<Vec<_>>()];
        let common: Vec<FreeAngles> = own[0].iter().zip(&own[1]).map(|(a, b)| a.and(b)).collect();
        let both = Both::new(self.pinch_tools(), cones, between_rad);
        let shut: Vec<usize> = (0..common.len()).filter(|k| common[*k].is_empty()).collect();
        let blocked = |places: &[usize]| self.blocked(&rows, places, closed(&rows, &own, &both, places[0]));
        if !shut.is_empty() {
            return Ok(Err(blocked(&shut)));
        }
        let walls = match pair::chain(&common) {
            Ok(walls) => walls,
            Err(place) => return Ok(Err(blocked(&[place]))),
        };
        let channel = match channel::of_walls(&walls, self.job.channel.tolerance_deg.to_radians()) {
            Ok(channel) => channel,
            Err(place) => {
                let blocked = blocked(&[place]);
                let height_mm = rows.places[place].contacts[0].centre.x;
                let message = format!(
                    "the table would have to turn back for both tools on the double helix at height {height_mm:.3} mm"
                );
                return Ok(Err(Blocked { error: Error { message, ..blocked.error }, ..blocked }));
            }
        };
        let path = on_longer_way(rows.toolpath(0, Cones::Same(cones[0])), &rows);
        let held = |schedule: &Schedule| {
            let margins = common.iter().zip(&schedule.theta).map(|(free, theta)| free.margin(*theta));
            let margin_rad = margins.fold(f64::INFINITY, f64::min);
            Held { row: 0, places: 0..rows.places.len(), theta_rad: schedule.theta.clone(), margin_rad }
        };
        let made = self.candidates((&path, &channel), closely, observer)?;
        let mut all: Vec<Held> = made.iter().map(held).collect();
        let fastest = match all.len() {
            1 => 0,
            _ => motion::fastest(self, &rows, between_rad, &all, observer)?,
        };
        let chosen = within_turns(vec![all.swap_remove(fastest)], self.theta_limits());
        let clear = |places: &Range<usize>| self.clear_along(&rows, &both, places, &|k| chosen[0].theta_rad[k]);
        if !clear(&(0..rows.places.len())) {
            let touching: Vec<usize> = (0..rows.places.len() - 1).filter(|k| !clear(&(*k..*k + 2))).collect();
            return Ok(Err(blocked(if touching.is_empty() { &[0] } else { &touching })));
        }
        let planned = Planned { held: chosen, least_slopes: Vec::new() };
        Ok(Ok(Shared { rows, cut_off: 0, own, common, planned, postures: None }))
    }

    /// Schedules of the kind that the job asks for: of the least time several.
    fn candidates(
        &self,
        (path, channel): (&Toolpath, &Channel),
        closely: bool,
        observer: &dyn Observer,
    ) -> Result<Vec<Schedule>> {
        let (options, feed) = (self.schedule_options(), self.feed_options());
        let kind = self.job.schedule.kind;
        if kind != ScheduleKind::Time {
            return Ok(vec![schedule::plan(kind, path, channel, &options, observer)?]);
        }
        let mut all = schedules::paced(&self.machine, &feed, path, channel, &options)?;
        if closely && self.machine.has_two_heads() {
            all.extend(schedules::rivals(path, channel, &options));
        } else {
            all.truncate(1);
        }
        Ok(all)
    }

    /// An end of the helix above some places, at which it is blocked.
    fn blocked(&self, rows: &PairedRows, places: &[usize], error: Error) -> Blocked {
        let heights = places.iter().flat_map(|k| rows.places[*k].contacts.iter().map(|c| c.centre.x));
        let stepover_mm = path::flat_stepover_mm(rows.radius_mm[0], rows.scallop_mm);
        let above_mm = heights.fold(f64::NEG_INFINITY, f64::max).max(rows.heights_mm[0]) + 0.5 * stepover_mm;
        Blocked { error, above_mm }
    }

    /// How many parts each move needs while the table turns as planned.
    fn parts(&self, shared: &Shared) -> Vec<usize> {
        let chord_mm = TURNING_CHORD * self.job.path.chord_mm;
        let theta = |place: usize| shared.planned.held.first().map_or(0.0, |h| h.theta_at(place));
        let of = |(k, w): (usize, &[PairPlace])| {
            let turn = FASTER * (theta(k + 1) - theta(k)).abs();
            let off_mm = (0..2).map(|j| {
                let [a, b] = [0, 1].map(|i| &w[i].contacts[j].centre);
                let rho = [a, b].map(|p| self.off_table_axis_mm(p)).into_iter().fold(0.0, f64::max);
                (3.0 * rho * turn * turn + 2.0 * turn * (b - a).norm()) / 8.0
            });
            (off_mm.fold(0.0, f64::max) / chord_mm).sqrt().ceil().max(1.0) as usize
        };
        shared.rows.places.windows(2).enumerate().map(of).collect()
    }
}

/// A helix whose threads are blocked, and a height above which they may not be, mm.
struct Blocked {
    error: Error,
    above_mm: f64,
}

/// The way of thread 1 with lengths of the longer way of both tools, of balls or contacts: at full
/// feed the time is in proportion to them.
fn on_longer_way(mut path: Toolpath, rows: &PairedRows) -> Toolpath {
    let ways = std::iter::once(0.0).chain((0..rows.places.len()).map(|k| rows.longest_way_mm(k)));
    let mut s_mm = 0.0;
    for (l, way) in path.locations.iter_mut().zip(ways) {
        s_mm += way;
        l.s_mm = s_mm;
    }
    for k in 0..path.turns.len() {
        let first = path.turns[k].first;
        let from = path.locations[first].s_mm;
        let to = path.turns.get(k + 1).map_or(s_mm, |next| path.locations[next.first].s_mm);
        path.turns[k].length_mm = to - from;
        for l in &mut path.locations[first..first + path.turns[k].count] {
            l.turn_s_mm = l.s_mm - from;
        }
    }
    path
}
