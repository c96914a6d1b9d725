//! Programs of two tools in two channels: where they wait for each other, and what may happen
//! between two marks.
//!
//! Each program is read alone. Channels keep time by wait marks only: a mark is passed by both at
//! once, and between two marks any channel may lag behind the other, by an override of its own or
//! by its look-ahead. So between two marks
//!
//! * the table stands still where a tool cuts: then a lag moves a tool along its own row alone;
//! * both programs have as many lines that cut, and at each of them the same time has gone by;
//! * the tools stay apart at *every* pair of places, one of each tool, not only at those of the
//!   same time: what they sweep is parted by planes, in halves of halves of their ways as far as
//!   needed.

use std::ops::Range;

use super::pinch::{PinchWork, ToolSolid, solids};
use super::pinch_program::{CENTRE_MM, Expected, off_axis_mm};
use crate::artifact::report::Check;
use crate::artifact::{Axes, CheckId};
use crate::geometry::Vector;
use crate::machine::{Carries, Machine, Pose};
use crate::parallel;
use crate::read::program::pinch::{Line, Mark, Read};
use crate::tool::Tool;

/// The channels may be so far apart in time where both cut by their own F, s: a cycle of a control.
const LAG_S: f64 = 0.004;
/// Times that are nearer are the same, s.
const SAME_S: f64 = 1e-9;
/// An axis that moves by less stands still, mm or rad.
const STILL: f64 = 1e-9;

/// Two programs, read together.
pub(super) struct Met {
    /// What was found.
    pub(super) checks: Vec<Check>,
    /// The lines of both in one order, where their marks meet. Between two marks of rapids every
    /// place of one channel comes with every place of the other.
    pub(super) lines: Option<Vec<Line>>,
}

/// Leads both programs from mark to mark.
pub(super) fn meet(programs: [&Read; 2], expected: Expected, machine: &Machine) -> Met {
    let Expected { stretches, skew_s } = expected;
    let is_second = |k: usize| machine.axes()[k].carries == Carries::Head(1);
    let mut checks = vec![strangers(programs, machine)];
    checks.extend(marks(programs, stretches));
    if programs[0].marks.len() != programs[1].marks.len() {
        return Met { checks, lines: None };
    }
    let parts = programs[0].parts.iter().zip(&programs[1].parts);
    let (mut lines, mut at) = (Vec::new(), Axes::from_fn(machine.axes().len(), |_| f64::NAN));
    let join = |a: &Axes, b: &Axes| Axes::from_fn(a.len(), |k| if is_second(k) { b[k] } else { a[k] });
    let mut found = BetweenMarks { table_may_turn: skew_s.is_some(), ..BetweenMarks::default() };
    for (n, (one, two)) in parts.enumerate() {
        found.part(n, [one, two], programs, (machine, &at), stretches.is_some());
        let ends = [one, two].map(|p| p.last().map_or(at, |l| l.at));
        let cuts = [one, two].iter().any(|part| part.iter().any(|l| !l.is_rapid));
        lines.extend(match stretches.is_none() && cuts {
            true => by_time([one, two], &at, join),
            false => together([one, two], &at, join),
        });
        at = join(&ends[0], &ends[1]);
    }
    checks.extend(found.checks());
    Met { checks, lines: Some(lines) }
}

/// The lines of both channels between two marks.
fn together(parts: [&[Line]; 2], before: &Axes, join: impl Fn(&Axes, &Axes) -> Axes) -> Vec<Line> {
    let [one, two] = parts;
    let line = |a: Option<&Line>, b: Option<&Line>| {
        let at = join(a.map_or(before, |l| &l.at), b.map_or(before, |l| &l.at));
        let numbers = [a, b].map(|l| l.map_or(0, |l| l.numbers[0]));
        let seconds = [a, b].into_iter().flatten().filter_map(|l| l.seconds).reduce(f64::max);
        let is_rapid = [a, b].into_iter().flatten().all(|l| l.is_rapid);
        Line { numbers, is_rapid, seconds, at }
    };
    let cuts = |part: &[Line]| part.iter().any(|l| !l.is_rapid);
    if cuts(one) || cuts(two) {
        // In step; what one has more comes while the other stands at its end.
        let steps = 0..one.len().max(two.len());
        return steps.map(|k| line(one.get(k).or(one.last()), two.get(k).or(two.last()))).collect();
    }
    let all = |part: &'_ [Line]| -> Vec<Option<Line>> {
        std::iter::once(None).chain(part.iter().cloned().map(Some)).collect()
    };
    let (one, two) = (all(one), all(two));
    let pairs = one.iter().flat_map(|a| two.iter().map(move |b| (a.as_ref(), b.as_ref())));
    pairs.filter(|(a, b)| a.is_some() || b.is_some()).map(|(a, b)| line(a, b)).collect()
}

/// The lines of both channels between two marks, by the time since the first of them: wherever a
/// line of either ends. Rapids take none.
fn by_time(parts: [&[Line]; 2], before: &Axes, join: impl Fn(&Axes, &Axes) -> Axes) -> Vec<Line> {
    let ends = |part: &[Line]| -> Vec<f64> {
        let mut at_s = 0.0;
        let end = |l: &Line| {
            at_s += l.seconds.filter(|s| s.is_finite()).unwrap_or(0.0);
            at_s
        };
        part.iter().map(end).collect()
    };
    let ends = parts.map(ends);
    let mut times: Vec<f64> = ends.iter().flatten().copied().collect();
    times.sort_by(f64::total_cmp);
    times.dedup_by(|b, a| *b - *a <= SAME_S);
    let mut last_s = 0.0;
    let line = |t: f64| {
        let at = [0, 1].map(|k| {
            let n = ends[k].partition_point(|end| *end < t - SAME_S);
            let Some(own) = parts[k].get(n) else {
                return (parts[k].last(), parts[k].last().map_or(*before, |l| l.at));
            };
            let (from, from_s) = n.checked_sub(1).map_or((*before, 0.0), |n| (parts[k][n].at, ends[k][n]));
            let share = if t >= ends[k][n] - SAME_S { 1.0 } else { (t - from_s) / (ends[k][n] - from_s) };
            (Some(own), if share == 1.0 { own.at } else { from.toward(&own.at, share) })
        });
        let own = at.map(|(line, _)| line);
        let numbers = own.map(|l| l.map_or(0, |l| l.numbers[0]));
        let is_rapid = own.into_iter().flatten().all(|l| l.is_rapid);
        let seconds = Some(t - std::mem::replace(&mut last_s, t)).filter(|_| !is_rapid);
        Line { numbers, is_rapid, seconds, at: join(&at[0].1, &at[1].1) }
    };
    times.into_iter().map(line).collect()
}

/// Where all axes stand at the ends of lines if channel 1, with the table, is so much behind (or,
/// below 0, before) channel 2.
pub(super) fn apart_in_time(lines: &[Line], machine: &Machine, by_s: f64) -> Vec<Axes> {
    let mut at_s = 0.0;
    let times: Vec<f64> = lines
        .iter()
        .enumerate()
        .map(|(n, l)| {
            at_s += l.seconds.filter(|s| n > 0 && s.is_finite()).unwrap_or(0.0);
            at_s
        })
        .collect();
    let first = |t: f64| {
        let n = times.partition_point(|end| *end < t).min(lines.len() - 1);
        let Some(before) = n.checked_sub(1).filter(|before| times[n] > times[*before]) else { return lines[n].at };
        let share = ((t - times[before]) / (times[n] - times[before])).clamp(0.0, 1.0);
        lines[before].at.toward(&lines[n].at, share)
    };
    let is_second = |k: usize| machine.axes()[k].carries == Carries::Head(1);
    let one = |(l, t): (&Line, &f64)| {
        let own = first(t - by_s);
        Axes::from_fn(own.len(), |k| if is_second(k) { l.at[k] } else { own[k] })
    };
    lines.iter().zip(&times).map(one).collect()
}

/// Axes that a channel names though they are the other's.
fn strangers(programs: [&Read; 2], machine: &Machine) -> Check {
    let of = |channel: usize| {
        let is_own = move |k: usize| (machine.axes()[k].carries == Carries::Head(1)) == (channel == 1);
        programs[channel]
            .named
            .iter()
            .filter(move |(k, _)| !is_own(*k))
            .map(move |(k, line)| format!("{} in line {line} of channel {}", machine.axes()[*k].name, channel + 1))
    };
    let all: Vec<String> = of(0).chain(of(1)).collect();
    fault("axes that a channel names though they are the other channel's", &all)
}

/// A check that counts faults, the first of them named.
fn fault(quantity: &str, all: &[String]) -> Check {
    let note = all.first().map_or_else(String::new, |first| format!("the first is {first}"));
    Check::at_most(CheckId::ProgramChannels, quantity, all.len() as f64, 0.0, "", note)
}

/// Marks are the same in both programs. Where the stretches are known they count up by one, and
/// there are three for the first stretch and two for each after it.
fn marks(programs: [&Read; 2], stretches: Option<usize>) -> Vec<Check> {
    let all = [0, 1].map(|k| &programs[k].marks[..]);
    let last = all.iter().flat_map(|m| m.iter()).map(|m| m.mark).max().unwrap_or(0);
    let named = |channel: usize, m: &Mark| format!("mark {} in line {} of channel {}", m.mark, m.line, channel + 1);
    let (mut order, mut alone) = (Vec::new(), Vec::new());
    for channel in 0..2 {
        let mut wanted = 1;
        for m in all[channel] {
            if m.mark != wanted && stretches.is_some() {
                order.push(format!("{}, where {wanted} comes next", named(channel, m)));
            }
            if m.channels != [1, 2] {
                order.push(format!("{}, which does not wait for channels 1 and 2", named(channel, m)));
            }
            wanted = if m.mark >= last { 1 } else { m.mark + 1 };
        }
    }
    for k in 0..all[0].len().max(all[1].len()) {
        match [all[0].get(k), all[1].get(k)] {
            [Some(a), Some(b)] if a.mark == b.mark => {}
            [Some(a), Some(b)] => alone.push(format!("{}, which meets {}", named(0, a), named(1, b))),
            [Some(a), None] => alone.push(format!("{}, where channel 2 has no more", named(0, a))),
            [None, Some(b)] => alone.push(format!("{}, where channel 1 has no more", named(1, b))),
            [None, None] => {}
        }
    }
    let mut out = vec![
        fault("wait marks out of their order", &order),
        fault("wait marks at which one channel waits for ever", &alone),
    ];
    out.extend(stretches.map(|stretches| {
        let (wanted, most) = (1 + 2 * stretches, |of: &[Mark]| of.len().abs_diff(1 + 2 * stretches));
        let counted = format!("{} in channel 1, {} in channel 2, wanted {wanted}", all[0].len(), all[1].len());
        let quantity = "wait marks that are missing or too many";
        let off = most(all[0]).max(most(all[1])) as f64;
        Check::at_most(CheckId::ProgramChannels, quantity, off, 0.0, "", counted)
    }));
    out
}

/// What was found between two marks.
#[derive(Default)]
struct BetweenMarks {
    /// The table may turn where a tool cuts.
    table_may_turn: bool,
    /// Moves of the table where a tool cuts.
    table: Vec<String>,
    /// Rapids there, and lines that only one channel has.
    uneven: Vec<String>,
    /// The longest time between the channels, s, and where.
    lag_s: (f64, String),
}

impl BetweenMarks {
    /// The part behind mark `n`, counted from 0 for what comes before the first.
    /// `in_step`: both channels are to have the same lines.
    fn part(
        &mut self,
        n: usize,
        parts: [&[Line]; 2],
        programs: [&Read; 2],
        (machine, before): (&Machine, &Axes),
        in_step: bool,
    ) {
        let cuts = |part: &[Line]| part.iter().filter(|l| !l.is_rapid).count();
        if cuts(parts[0]) + cuts(parts[1]) == 0 {
            return;
        }
        let mark = |n: usize| programs[0].marks.get(n).map_or_else(|| "the end".into(), |m| format!("mark {}", m.mark));
        let between = format!("between {} and {}", n.checked_sub(1).map_or_else(|| "the start".into(), mark), mark(n));
        for (k, axis) in machine.axes().iter().enumerate() {
            let is_table = k == machine.turning_axis();
            let is_shared = !matches!(axis.carries, Carries::Head(_)) || is_table;
            let is_shared = is_shared && !(is_table && self.table_may_turn);
            let moved = parts[0].iter().find(|l| !((l.at[k] - before[k]).abs() <= STILL)).filter(|_| is_shared);
            let named = |l: &Line| format!("{} in line {} of channel 1, {between}", axis.name, l.numbers[0]);
            self.table.extend(moved.map(named));
        }
        for (channel, part) in parts.iter().enumerate() {
            let rapid = part.iter().find(|l| l.is_rapid);
            let named = |l: &Line| format!("a rapid in line {} of channel {}, {between}", l.numbers[0], channel + 1);
            self.uneven.extend(rapid.map(named));
        }
        if !in_step {
            let [one, two] = parts.map(|part| part.iter().filter_map(|l| l.seconds).sum::<f64>());
            if !((one - two).abs() <= self.lag_s.0) {
                self.lag_s = ((one - two).abs(), format!("in all {between}"));
            }
            return;
        }
        if parts[0].len() != parts[1].len() {
            let [one, two] = parts.map(<[Line]>::len);
            self.uneven.push(format!("{one} lines of channel 1 and {two} of channel 2 {between}"));
        }
        let mut since_s = [0.0; 2];
        for pair in parts[0].iter().zip(parts[1]) {
            let lines = [pair.0, pair.1];
            (0..2).for_each(|k| since_s[k] += lines[k].seconds.unwrap_or(0.0));
            let lag_s = (since_s[0] - since_s[1]).abs();
            if !(lag_s <= self.lag_s.0) {
                let [one, two] = lines.map(|l| l.numbers[0]);
                self.lag_s = (lag_s, format!("line {one} of channel 1 and {two} of channel 2, {between}"));
            }
        }
    }

    fn checks(&self) -> [Check; 3] {
        let (lag_s, at) = &self.lag_s;
        let quantity = "time between the channels where both cut";
        [
            fault("moves of the table between two wait marks of a row", &self.table),
            fault("lines between two wait marks of a row that the other channel lacks", &self.uneven),
            Check::at_most(CheckId::ProgramChannels, quantity, *lag_s, LAG_S, "s", at.clone()),
        ]
    }
}

/// At the marks of a stretch each tool stands on its own axis over the first place and the last.
pub(super) fn rendezvous(
    work: &PinchWork,
    lines: &[Line],
    poses: &[Option<[Pose; 2]>],
    stretches: &[Range<usize>],
) -> Check {
    let (mut worst_mm, mut at) = (0.0, String::new());
    for (s, held) in stretches.iter().zip(work.held) {
        let places = &held.places;
        let ends = [(s.start.checked_sub(1), places.start), (Some(s.end), places.end.saturating_sub(1))];
        for (line, place) in ends {
            let pose = line.and_then(|i| poses.get(i)?.as_ref());
            for j in 0..2 {
                let off_mm = pose.map_or(f64::INFINITY, |p| off_axis_mm(&work.stand(held, place, j), &p[j]));
                if !(off_mm <= worst_mm) {
                    let named = line.and_then(|i| lines.get(i)).map_or_else(String::new, Line::named);
                    (worst_mm, at) = (off_mm, format!("tool {} in {named}", j + 1));
                }
            }
        }
    }
    let quantity = "distance of both tools at wait marks from the axes along which they go down and up";
    Check::at_most(CheckId::ProgramChannels, quantity, worst_mm, CENTRE_MM, "mm", at)
}

/// How near the tools come between the marks of a stretch, however far one of them lags.
pub(super) fn lagging(
    (tools, asked_mm): ([&Tool; 2], f64),
    poses: &[Option<[Pose; 2]>],
    stretches: &[Range<usize>],
) -> Check {
    let segments = tools.map(Tool::segments);
    let one = |n: &usize| {
        let s = &stretches[*n];
        let from = s.start.saturating_sub(1);
        let known = poses.get(from..(s.end + 1).min(poses.len())).unwrap_or_default();
        let of = |j: usize| -> Vec<Vec<ToolSolid>> {
            let stand = |p: &[Pose; 2]| solids(&segments[j], tools[j].radius_mm, &p[j].centre, &p[j].axis);
            known.iter().flatten().map(stand).collect()
        };
        // The side of the blade axis that tool 1 is on.
        let side = known.iter().flatten().map(|p| Vector::new(0.0, p[0].axis.y, p[0].axis.z)).next();
        let out = side.and_then(|v| v.try_normalize(1e-9)).unwrap_or_default();
        let ways = Ways { tools: [of(0), of(1)], out, asked_mm };
        (ways.apart_mm(), *n)
    };
    let all: Vec<(f64, usize)> = parallel::map(&(0..stretches.len()).collect::<Vec<_>>(), one);
    let (least_mm, n) = all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((f64::INFINITY, 0));
    let quantity = "least distance of the two tools between wait marks, however far one lags, as far as asked for";
    let note = format!("stretch {}; asked for {asked_mm}", n + 1);
    Check {
        passed: least_mm >= asked_mm,
        ..Check::at_most(CheckId::ToolsApart, quantity, least_mm, asked_mm, "mm", note)
    }
}

/// The ways of both tools, each as the solids of its places in order.
struct Ways {
    tools: [Vec<Vec<ToolSolid>>; 2],
    /// The direction in which tool 1 stands.
    out: Vector,
    asked_mm: f64,
}

impl Ways {
    /// A lower bound of the distance of any place of tool 1 from any of tool 2, mm; it ends where
    /// one is less than asked for, and says no more than that where none is.
    fn apart_mm(&self) -> f64 {
        let whole = |j: usize| 0..self.tools[j].len();
        if whole(0).is_empty() || whole(1).is_empty() {
            return f64::NEG_INFINITY;
        }
        let (mut open, mut least_mm) = (vec![[whole(0), whole(1)]], f64::INFINITY);
        while let Some(ranges) = open.pop() {
            let gap_mm = self.gap_mm(&ranges);
            let halves = halves(&ranges);
            if gap_mm >= self.asked_mm || halves.is_none() {
                least_mm = least_mm.min(gap_mm);
            }
            if least_mm < self.asked_mm {
                return least_mm;
            }
            open.extend(halves.into_iter().flatten().filter(|_| gap_mm < self.asked_mm));
        }
        least_mm
    }

    /// A lower bound between two ranges of places and all straight ways within them.
    fn gap_mm(&self, ranges: &[Range<usize>; 2]) -> f64 {
        let [a, b] = [0, 1].map(|j| &self.tools[j][ranges[j].clone()]);
        let middle = |of: &'_ [Vec<ToolSolid>]| of.len() / 2;
        let mut least_mm = f64::INFINITY;
        for i in 0..a[0].len() {
            for k in 0..b[0].len() {
                let gap = |d: &Vector| {
                    let low = a.iter().map(|s| s[i].farthest(&-d).coords.dot(d)).fold(f64::INFINITY, f64::min);
                    let high = b.iter().map(|s| s[k].farthest(d).coords.dot(d)).fold(f64::NEG_INFINITY, f64::max);
                    low - high
                };
                let mut best_mm = gap(&self.out);
                if best_mm < self.asked_mm {
                    let (p, q) = (&a[middle(a)][i], &b[middle(b)][k]);
                    let along = [p.towards(q), p.between(q)].into_iter().flatten();
                    best_mm = along.map(|d| gap(&d)).fold(best_mm, f64::max);
                }
                least_mm = least_mm.min(best_mm);
                if least_mm < self.asked_mm {
                    return least_mm;
                }
            }
        }
        least_mm
    }
}

/// Two halves of the longer range, which meet at a place; `None`: both are single ways.
fn halves(ranges: &[Range<usize>; 2]) -> Option<[[Range<usize>; 2]; 2]> {
    let [a, b] = ranges;
    let half = |r: &Range<usize>| {
        let middle = r.start + r.len() / 2;
        [r.start..middle + 1, middle..r.end]
    };
    if a.len().max(b.len()) <= 2 {
        return None;
    }
    Some(if a.len() >= b.len() { half(a).map(|part| [part, b.clone()]) } else { half(b).map(|part| [a.clone(), part]) })
}
