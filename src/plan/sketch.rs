//! The costly schedules, sketched: for the picture beside the one in use, planned at about a
//! thousand of the path's locations.
//!
//! In: a path with its channel. Out: θ at every location, straight between those that were planned.
//! A sketch is not to be machined: between its places the channel was not looked at. What it shows
//! of the schedule's shape is right to the width of a line.

use super::Setup;
use super::schedules;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::observe::Silent;
use crate::schedule::{self, ScheduleOptions};

/// Locations that a sketch is planned at, about.
const PLACES: usize = 1000;

/// A schedule of this kind at some of the path's locations, with θ at all of them; `None` where it
/// cannot be made.
pub(crate) fn sketch(kind: ScheduleKind, setup: &Setup, path: &Toolpath, channel: &Channel) -> Option<Schedule> {
    let kept = places(path);
    let (few, narrow) = (path.at(&kept), of(channel, &kept)?);
    let options = setup.schedule_options();
    let made = match kind {
        ScheduleKind::Time => {
            let pace = Some(schedules::pace(&setup.machine, setup.job.feed.feed_mm_min));
            schedule::plan(kind, &few, &narrow, &ScheduleOptions { pace, ..options }, &Silent)
        }
        _ => schedule::plan(kind, &few, &narrow, &options, &Silent),
    };
    let made = made.ok()?;
    let theta = spread(path, &kept, &made.theta)?;
    Some(Schedule { theta, ..made })
}

/// Rows that are kept: every so many of each turn from its first on, and the last of all.
fn places(path: &Toolpath) -> Vec<usize> {
    let step = path.locations.len().div_ceil(PLACES).max(1);
    let mut kept: Vec<usize> = path.turns.iter().flat_map(|t| (t.first..t.first + t.count).step_by(step)).collect();
    kept.extend(path.locations.len().checked_sub(1));
    kept.dedup();
    kept
}

fn of(channel: &Channel, kept: &[usize]) -> Option<Channel> {
    let rows = kept.iter().map(|k| channel.rows.get(*k).cloned()).collect::<Option<Vec<_>>>()?;
    let narrowest_row = kept.partition_point(|k| *k < channel.narrowest_row).min(rows.len().checked_sub(1)?);
    Some(Channel { rows, narrowest_row, ..channel.clone() })
}

/// Values at all locations from those at some, straight over the arc length between.
fn spread(path: &Toolpath, kept: &[usize], values: &[f64]) -> Option<Vec<f64>> {
    let mut out = Vec::with_capacity(path.locations.len());
    for (k, pair) in kept.windows(2).enumerate() {
        let (a, b) = (path.locations.get(pair[0])?.s_mm, path.locations.get(pair[1])?.s_mm);
        let (from, to) = (values.get(k)?, values.get(k + 1)?);
        for l in path.locations.get(pair[0]..pair[1])? {
            out.push(from + (to - from) * ((l.s_mm - a) / (b - a).max(1e-12)));
        }
    }
    out.push(*values.last()?);
    (out.len() == path.locations.len()).then_some(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    #[test]
    fn places_are_kept_by_turns_and_values_come_back_between() {
        let plan = sample::plan(3, 600);
        let (path, channel) = (&plan.toolpath, &plan.channel);
        let kept = places(path);
        assert!((600..=PLACES + 4).contains(&kept.len()) && kept.windows(2).all(|w| w[0] < w[1]), "{}", kept.len());
        let (few, narrow) = (path.at(&kept), of(channel, &kept).unwrap());
        assert_eq!((few.locations.len(), narrow.rows.len()), (kept.len(), kept.len()));
        for (a, b) in few.turns.iter().zip(&path.turns) {
            assert_eq!(few.locations[a.first], path.locations[b.first]);
            assert!(few.locations[a.first..a.first + a.count].iter().all(|l| l.turn == few.locations[a.first].turn));
        }
        assert_eq!(few.turns.iter().map(|t| t.count).sum::<usize>(), kept.len());
        // What is straight in arc length comes back.
        let line = |s: f64| 0.3 + 0.01 * s;
        let values: Vec<f64> = few.locations.iter().map(|l| line(l.s_mm)).collect();
        let all = spread(path, &kept, &values).unwrap();
        assert!(all.iter().zip(&path.locations).all(|(v, l)| (v - line(l.s_mm)).abs() < 1e-9));
    }
}
