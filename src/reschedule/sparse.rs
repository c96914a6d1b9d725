//! A long course at some of its places: what schedules are made on.
//!
//! Programs have places as near to one another as their chords ask for. A schedule bends over
//! longer ways, and making one takes more than its share of time where there are many places. The
//! walls at the places that are kept are moved inwards by what the walls between stand out of the
//! straight lines from one to the next, so that a curve within them is within all walls.

use crate::artifact::channel::ChannelRow;
use crate::artifact::toolpath::Turn;
use crate::artifact::{Channel, Cones, Schedule, Toolpath};

/// Courses of no more places are taken as they are.
const MOST: usize = 30_000;
/// At most so many places are from one that is kept to the next.
const STRIDE: usize = 32;
/// Walls are straight that are off a straight line by no more than this share of the room that θ
/// has.
const STRAIGHT_SHARE: f64 = 0.005;
/// Or by no more than this, rad.
const STRAIGHT_RAD: f64 = 1e-6;
/// So many places at either end are all kept: there θ is given.
const AT_ENDS: usize = 8;
/// Angles that differ by less are the same, rad: rounding of a cubic is no turning back.
const SAME_RAD: f64 = 1e-9;

/// So many places are more than are scheduled.
pub(super) fn is_long(path: &Toolpath) -> bool {
    path.locations.len() > MOST
}

/// The course at some of its places, with θ at both ends, rad; `None` where it has few, or where θ
/// may turn back.
pub(super) fn course(path: &Toolpath, channel: &Channel, ends: [f64; 2]) -> Option<(Toolpath, Channel)> {
    if !is_long(path) || path.locations.len() != channel.rows.len() || !channel.sweep.is_round() {
        return None;
    }
    let straight = Straight { path, channel, ends };
    let kept = straight.kept();
    let locations: Vec<_> = kept.iter().map(|k| path.locations[*k]).collect();
    let cones = match path.cones {
        Cones::Same(_) => path.cones.clone(),
        Cones::Each(_) => Cones::along(kept.iter().map(|k| path.cone(*k)).collect()),
    };
    let mut turns: Vec<Turn> = Vec::new();
    let mut open = None;
    for (k, location) in locations.iter().enumerate() {
        if open != Some(location.turn) {
            open = Some(location.turn);
            let length_mm = path.turns.get(location.turn as usize).map_or(0.0, |t| t.length_mm);
            turns.push(Turn { first: k, count: 0, length_mm });
        }
        if let Some(turn) = turns.last_mut() {
            turn.count += 1;
        }
    }
    // Every turn keeps one of its places: else turns would be counted wrongly.
    if turns.len() != path.turns.len() {
        return None;
    }
    let rows = rows(path, channel, &kept);
    if rows.iter().any(|r| r.hull_min > r.hull_max) {
        return None;
    }
    let width = |row: &ChannelRow| row.hull_max - row.hull_min;
    let narrowest = rows.iter().enumerate().min_by(|a, b| width(a.1).total_cmp(&width(b.1)));
    let narrowest_row = narrowest.map_or(0, |(row, _)| row);
    let channel = Channel { narrowest_row, proven_at: Vec::new(), rows, ..channel.clone() };
    Some((Toolpath { locations, cones, turns, ..path.clone() }, channel))
}

/// A schedule of some of the places, with its angles at all; `None` where it leaves the channel
/// there or turns back.
pub(super) fn at_all(schedule: Schedule, path: &Toolpath, channel: &Channel) -> Option<Schedule> {
    let theta: Vec<f64> = path.locations.iter().map(|l| schedule.curve_at(l.s_mm)).collect::<Option<_>>()?;
    let off = channel.tolerance_rad;
    let inside = |(t, r): (&f64, &ChannelRow)| (r.theta_min - off..=r.theta_max + off).contains(t);
    let keeps = theta.iter().zip(&channel.rows).all(inside) && theta.windows(2).all(|w| w[0] <= w[1] + SAME_RAD);
    keeps.then_some(Schedule { theta, ..schedule })
}

/// What walls count as straight in.
struct Straight<'a> {
    path: &'a Toolpath,
    channel: &'a Channel,
    /// θ at both ends, rad.
    ends: [f64; 2],
}

impl Straight<'_> {
    /// Indices of the places that are kept: those at both ends, and of the others as few as the
    /// walls between allow to be straight.
    fn kept(&self) -> Vec<usize> {
        let n = self.channel.rows.len();
        let last = n.saturating_sub(AT_ENDS);
        let mut out: Vec<usize> = (0..AT_ENDS.min(n)).collect();
        let mut from = AT_ENDS.saturating_sub(1);
        while from < last {
            let to = (from + STRIDE).min(last);
            self.parted([from, to], &mut out);
            from = to;
        }
        out.extend(from + 1..n);
        out
    }

    /// Adds the last of some places, and those between that the walls ask for.
    fn parted(&self, [from, to]: [usize; 2], out: &mut Vec<usize>) {
        let most_rad = STRAIGHT_RAD.max(STRAIGHT_SHARE * self.room_rad(from).min(self.room_rad(to)));
        let is_bent = off_straight(self.path, self.channel, [from, to]).iter().flatten().any(|off| *off > most_rad);
        if is_bent && to > from + 1 {
            let middle = (from + to) / 2;
            self.parted([from, middle], out);
            self.parted([middle, to], out);
        } else {
            out.push(to);
        }
    }

    /// From one wall to the other; of a θ that never falls also from its first angle to the upper
    /// wall, and from the lower wall to its last one.
    fn room_rad(&self, k: usize) -> f64 {
        let (Some(row), [first, last]) = (self.channel.rows.get(k), self.ends) else { return 0.0 };
        (row.hull_max - row.hull_min).min(row.hull_max - first).min(last - row.hull_min)
    }
}

/// How far both walls between two places stand out of the straight lines from one to the other,
/// inwards, and how far they stay behind them, rad.
fn off_straight(path: &Toolpath, channel: &Channel, [a, b]: [usize; 2]) -> [[f64; 2]; 2] {
    let s = |k: usize| path.locations[k].s_mm;
    let row = |k: usize| &channel.rows[k];
    let mut out = [[0.0f64; 2]; 2];
    for k in a + 1..b {
        let share = (s(k) - s(a)) / (s(b) - s(a));
        let line = |from: f64, to: f64| from + share * (to - from);
        let low = row(k).hull_min - line(row(a).hull_min, row(b).hull_min);
        let high = line(row(a).hull_max, row(b).hull_max) - row(k).hull_max;
        for (off, by) in out.iter_mut().zip([low, high]) {
            *off = [off[0].max(by), off[1].max(-by)];
        }
    }
    out
}

/// The walls at the places that are kept.
fn rows(path: &Toolpath, channel: &Channel, kept: &[usize]) -> Vec<ChannelRow> {
    let stands_out = |w: &[usize]| off_straight(path, channel, [w[0], w[1]]).map(|[out, _]| out);
    let beside: Vec<[f64; 2]> = kept.windows(2).map(stands_out).collect();
    let of = |side: usize, i: usize| {
        let at = |i: Option<usize>| i.and_then(|i| beside.get(i)).map_or(0.0, |b| b[side]);
        at(i.checked_sub(1)).max(at(Some(i)))
    };
    let mut rows: Vec<ChannelRow> = kept.iter().map(|k| channel.rows[*k].clone()).collect();
    // Walls never fall.
    let mut most = f64::NEG_INFINITY;
    for (i, row) in rows.iter_mut().enumerate() {
        most = most.max(row.hull_min + of(0, i));
        row.hull_min = most;
    }
    let mut least = f64::INFINITY;
    for (i, row) in rows.iter_mut().enumerate().rev() {
        least = least.min(row.hull_max - of(1, i));
        row.hull_max = least;
    }
    rows
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::channel::Binding;
    use crate::artifact::schedule::ScheduleKind;
    use crate::observe::Silent;
    use crate::sample;
    use crate::schedule::{self, ScheduleOptions};

    fn kept(path: &Toolpath, channel: &Channel, ends: [f64; 2]) -> Vec<usize> {
        Straight { path, channel, ends }.kept()
    }

    /// Walls that rise unevenly, a radian apart.
    fn walls(count: usize, step: f64) -> Channel {
        walls_apart(count, step, 1.0)
    }

    /// So far apart, rad.
    fn walls_apart(count: usize, step: f64, apart: f64) -> Channel {
        let row = |k: usize| {
            let lo = k as f64 * step + 0.05 * (k as f64 / 37.0).sin();
            let hi = lo + apart;
            ChannelRow {
                theta_min: lo,
                theta_max: hi,
                hull_min: lo,
                hull_max: hi,
                tangent_min: lo,
                tangent_max: hi,
                binds_min: Binding::Free,
                binds_max: Binding::Free,
            }
        };
        let rows = (0..count).map(row).collect();
        let sweep = Default::default();
        Channel { tolerance_rad: 1e-6, rows, narrowest_row: 0, chains: 1, proven_at: Vec::new(), sweep }
    }

    #[test]
    fn walls_between_places_that_are_left_out_hold() {
        let path = sample::plan(70, 1000).toolpath;
        let n = path.locations.len();
        let all = walls_apart(n, std::f64::consts::TAU / 1000.0, 0.1);
        let ends = [0.04, all.rows[n - 1].hull_min + 0.06];
        let (few, walls) = course(&path, &all, ends).unwrap();
        assert!(few.locations.len() < n / 2 && few.locations.len() == walls.rows.len());
        assert_eq!(few.turns.len(), path.turns.len());
        assert_eq!(few.turns.iter().map(|t| t.count).sum::<usize>(), few.locations.len());
        let mut k = 0;
        for (at, row) in path.locations.iter().zip(&all.rows) {
            while few.locations[k + 1].s_mm < at.s_mm {
                k += 1;
            }
            let [a, b] = [k, k + 1].map(|k| &few.locations[k]);
            let share = (at.s_mm - a.s_mm) / (b.s_mm - a.s_mm);
            let line = |of: fn(&ChannelRow) -> f64| {
                let [a, b] = [k, k + 1].map(|k| of(&walls.rows[k]));
                a + share * (b - a)
            };
            let [lo, hi] = [line(|r| r.hull_min) - row.hull_min, row.hull_max - line(|r| r.hull_max)];
            assert!((-1e-9..1e-3).contains(&lo) && (-1e-9..1e-3).contains(&hi), "{lo} {hi}");
        }
        // A schedule within them is within all.
        let options = ScheduleOptions { ends_rad: Some(ends), ..ScheduleOptions::default() };
        let made = schedule::plan(ScheduleKind::Optimal, &few, &walls, &options, &Silent).unwrap();
        let theta = at_all(made.clone(), &path, &all).unwrap().theta;
        assert_eq!(theta.len(), n);
        assert!((theta[0] - ends[0]).abs() < 1e-9 && (theta[n - 1] - ends[1]).abs() < 1e-9);
        let inside = theta.iter().zip(&all.rows).all(|(t, r)| (r.hull_min..=r.hull_max).contains(t));
        assert!(inside && theta.windows(2).all(|w| w[0] <= w[1]));
        // A wall at a place that was left out, which the others do not know of, is seen.
        let out = (0..n).find(|k| few.locations.iter().all(|l| l.s_mm != path.locations[*k].s_mm)).unwrap();
        let mut closer = all;
        closer.rows[out].theta_max = theta[out] - 1e-3;
        assert!(at_all(made, &path, &closer).is_none());
    }

    #[test]
    fn where_there_is_room_fewer_places_are_kept() {
        let path = sample::plan(70, 1000).toolpath;
        let n = path.locations.len();
        let all = walls(n, std::f64::consts::TAU / 1000.0);
        // The first angle is hard under the upper wall, the last one on the lower.
        let ends = [all.rows[0].hull_max - 1e-5, all.rows[n - 1].hull_min];
        let (few, walls) = course(&path, &all, ends).unwrap();
        let narrow = walls_apart(n, std::f64::consts::TAU / 1000.0, 0.01);
        let all_of_narrow = course(&path, &narrow, [0.005, narrow.rows[n - 1].hull_min + 0.005]);
        let most = all_of_narrow.map_or(n, |(course, _)| course.locations.len());
        assert!(3 * few.locations.len() < most, "{} {most}", few.locations.len());
        let options = ScheduleOptions { ends_rad: Some(ends), ..ScheduleOptions::default() };
        let made = schedule::plan(ScheduleKind::Optimal, &few, &walls, &options, &Silent).unwrap();
        let theta = at_all(made, &path, &all).unwrap().theta;
        assert!(theta.iter().zip(&all.rows).all(|(t, r)| (r.hull_min..=r.hull_max).contains(t)));
        assert!((theta[0] - ends[0]).abs() < 1e-9 && (theta[n - 1] - ends[1]).abs() < 1e-9);
    }

    #[test]
    fn short_courses_and_those_that_turn_back_stay_whole() {
        let path = sample::plan(3, 1000).toolpath;
        assert!(course(&path, &walls(path.locations.len(), 0.006), [0.5, 0.5]).is_none());
        let path = sample::plan(70, 1000).toolpath;
        let mut channel = walls(path.locations.len(), 0.006);
        channel.sweep = crate::artifact::channel::Sweep::Follow;
        assert!(course(&path, &channel, [0.5, 0.5]).is_none());
    }

    #[test]
    fn places_are_kept_at_both_ends_and_where_walls_bend() {
        let path = sample::plan(70, 1000).toolpath;
        let n = path.locations.len();
        let mut straight = walls(n, 0.0);
        straight.rows.iter_mut().for_each(|r| (r.hull_min, r.hull_max) = (0.0, 1.0));
        let few = kept(&path, &straight, [0.4, 0.6]);
        assert!(few.starts_with(&[0, 1, 2, 3, 4, 5, 6, 7]));
        assert!(few.ends_with(&[n - 4, n - 3, n - 2, n - 1]) && few.windows(2).all(|w| w[0] < w[1]));
        assert!(few.windows(2).all(|w| w[1] - w[0] <= STRIDE) && few.len() < n / STRIDE + 3 * AT_ENDS);
        // A wall with a tip is kept to the place.
        let mut tip = straight;
        tip.rows[30_000].hull_min += 0.1;
        let near = kept(&path, &tip, [0.4, 0.6]);
        assert!(near.contains(&30_000) && near.len() > few.len() && near.len() < few.len() + 12);
    }
}
