//! Turn-milling: what the axes and their times say of the tool's offset, of the speed at which the
//! blade turns, and of what each tooth cuts.
//!
//! | check | measured |
//! | --- | --- |
//! | `turn-offset` | offset of the tool from the blade axis by the axes' positions: its spread where it is to stay, else how far it is beyond the range that is asked for |
//! | `turn-rate` | speed of turning from row to row, by the axes' positions and times, against the mean of its turn |
//! | `tooth-feed` | greatest feed per tooth, from contacts and times |
//!
//! Where a least feed per tooth leaves no speed that stays the same, the schedule says by how much
//! it varies; `turn-rate` allows that, up to a factor of 2.
//!
//! **Limits**: rows. Speeds of turning are not judged within [`BLEND_S`] of the ends of a turn,
//! where one speed gives way to the next, and on the first and last turn, where the axes come up
//! from rest.

use crate::artifact::axis_travel::offset_mm;
use crate::artifact::report::{Check, ToothFigures, TurningFigures};
use crate::artifact::schedule::{MOST_SPREAD, ScheduleKind};
use crate::artifact::{Blade, CheckId, Plan, Toolpath};
use crate::machine::Machine;
use crate::observe::Doubt;
use crate::tool::{Chip, Tool};

use super::options::Asked;

/// Spread of the offset where it is to stay, mm: a micrometre.
const SPREAD_MM: f64 = 1e-3;
/// What positions beyond a range are as rounding, mm.
const ROUNDING_MM: f64 = 1e-6;
/// Greatest share by which the speed of turning leaves its mean.
const RIPPLE: f64 = 1e-3;
/// Time at either end of a turn in which its speed gives way to the next, s.
pub(crate) const BLEND_S: f64 = 0.25;
/// Feeds from rounded times and straight distances may be so much higher, relative.
const FEED: f64 = 1e-4;
/// Greatest share of the scallop that marks along the feed may have without a warning.
const MARKS: f64 = 0.2;
/// Contacts on facets jump: their speed is that over this share of the ball's radius.
const SPAN: f64 = 0.05;

/// The checks of this module that the job asks for, their figures, and what is to be said of them.
pub(super) fn check(
    plan: &Plan,
    blade: &Blade,
    tool: &Tool,
    machine: &Machine,
    asked: &Asked,
) -> Option<(Vec<Check>, TurningFigures, Option<Doubt>)> {
    let turns = matches!(asked.schedule, ScheduleKind::Eccentric | ScheduleKind::Even);
    if !(turns || asked.offset_mm.is_some() || asked.chip.is_some()) {
        return None;
    }
    let (offset, offset_mm) = offset(plan, blade, tool, machine, asked);
    let rate = (asked.schedule == ScheduleKind::Even).then(|| rate(plan, blade, machine, asked.chip));
    let turning_per_min = rate.as_ref().and_then(|r| r.1);
    let ripple = rate.as_ref().zip(turning_per_min).map(|(r, _)| r.0.worst);
    let tooth = asked.chip.map(|chip| tooth(plan, blade, &chip));
    // Less than a millionth is rounding; adding 0 turns a rounded -0 into 0.
    let offset_mm = offset_mm.map(|v| (v / ROUNDING_MM).round() * ROUNDING_MM + 0.0);
    let figures = TurningFigures { offset_mm, turning_per_min, ripple, tooth: tooth.as_ref().map(|t| t.1) };
    let doubt = tooth.as_ref().zip(asked.chip).and_then(|((_, t), chip)| {
        let most_mm = MARKS * plan.toolpath.scallop_mm;
        let fz_mm = t.feed_mm * (most_mm / t.mark_mm).sqrt();
        let feed_mm_min = 60.0 * fz_mm * chip.teeth_per_s;
        (t.mark_mm > most_mm).then_some(Doubt::FeedMarks { mark_mm: t.mark_mm, most_mm, fz_mm, feed_mm_min })
    });
    let checks = offset.into_iter().chain(rate.map(|r| r.0)).chain(tooth.map(|t| t.0)).collect();
    Some((checks, figures, doubt))
}

/// The offset by the axes' positions.
fn offset(plan: &Plan, blade: &Blade, tool: &Tool, machine: &Machine, asked: &Asked) -> (Option<Check>, [f64; 2]) {
    let of = |row: usize| {
        let pose = machine.forward(&plan.motion.position[row], tool.length_mm());
        offset_mm(&pose.centre, pose.axis.z.atan2(pose.axis.y))
    };
    let all: Vec<f64> = (0..plan.motion.position.len()).map(of).collect();
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let farthest =
        |far: &dyn Fn(f64) -> f64| (0..all.len()).max_by(|a, b| far(all[*a]).total_cmp(&far(all[*b]))).unwrap_or(0);
    let check = match asked.offset_mm {
        _ if asked.schedule == ScheduleKind::Eccentric => {
            let mean = 0.5 * (least + greatest);
            let row = farthest(&|v| (v - mean).abs());
            let quantity = "spread of the offset of the tool from the blade axis";
            let note = format!("offset {mean:.4} mm");
            Some((row, Check::at_most(CheckId::TurnOffset, quantity, greatest - least, SPREAD_MM, "mm", note)))
        }
        Some([low, high]) => {
            let beyond = |v: f64| (low - v).max(v - high);
            let row = farthest(&beyond);
            let quantity = "how far the offset of the tool from the blade axis is beyond what is asked for";
            let note = format!("offsets {least:.4} to {greatest:.4} mm");
            Some((row, Check::at_most(CheckId::TurnOffset, quantity, beyond(all[row]), ROUNDING_MM, "mm", note)))
        }
        None => None,
    };
    (check.map(|(row, check)| check.at_location(row, plan, blade)), [least, greatest])
}

/// The speed of turning against the mean of its turn, and the least and greatest mean, 1/min.
fn rate(plan: &Plan, blade: &Blade, machine: &Machine, chip: Option<Chip>) -> (Check, Option<[f64; 2]>) {
    let (axis, t, path) = (machine.turning_axis(), &plan.motion.t_s, &plan.toolpath);
    let mut worst = (0.0, 0);
    let mut means: Vec<f64> = Vec::new();
    for rows in inner_turns(path, t) {
        let q = |row: usize| plan.motion.position[row][axis];
        let mean = (q(rows.end) - q(rows.start)) / (t[rows.end] - t[rows.start]);
        means.push((mean * 60.0 / std::f64::consts::TAU).abs());
        for i in rows {
            let off = ((q(i + 1) - q(i)) / (t[i + 1] - t[i]) / mean - 1.0).abs();
            if off > worst.0 || off.is_nan() {
                worst = (off, i);
            }
        }
    }
    let range = means
        .iter()
        .fold(None, |range: Option<[f64; 2]>, v| Some(range.map_or([*v, *v], |[a, b]| [a.min(*v), b.max(*v)])));
    let note = range.map_or_else(
        || "no turn between the first and the last is long enough".into(),
        |[least, greatest]| format!("{} turns, {least:.3} to {greatest:.3} 1/min", means.len()),
    );
    let quantity = "share by which the speed of turning leaves the mean of its turn";
    // What the schedule says that it varies by, within what any may, where the job has a reason.
    let has_reason = chip.is_some_and(|c| c.contact_mm_s[0] > 0.0);
    let varies = if has_reason { (plan.schedule.spread - 1.0).clamp(0.0, MOST_SPREAD - 1.0) } else { 0.0 };
    let check = Check::at_most(CheckId::TurnRate, quantity, worst.0, RIPPLE + varies, "", note);
    (check.at_location(worst.1, plan, blade), range)
}

/// Rows of each turn between the first and the last, without what is within [`BLEND_S`] of its
/// ends: from the first to the last of which speeds are judged.
pub(crate) fn inner_turns(path: &Toolpath, t: &[f64]) -> Vec<std::ops::Range<usize>> {
    let turns = &path.turns;
    let inner = turns.get(1..turns.len().saturating_sub(1)).unwrap_or_default();
    let rows = |turn: &crate::artifact::toolpath::Turn| {
        let (first, end) = (turn.first, (turn.first + turn.count).min(t.len() - 1));
        let from = (first..end).find(|i| t[*i] - t[first] >= BLEND_S)?;
        let to = (from..end).rev().find(|i| t[end] - t[*i] >= BLEND_S)?;
        (to > from).then_some(from..to)
    };
    inner.iter().filter_map(rows).collect()
}

/// The greatest feed per tooth, and the figures of teeth.
fn tooth(plan: &Plan, blade: &Blade, chip: &Chip) -> (Check, ToothFigures) {
    let (path, t) = (&plan.toolpath, &plan.motion.t_s);
    let l = &path.locations;
    let (mut worst, mut mark_mm, mut below, mut end) = ((0.0, 0), 0.0f64, 0.0, 0);
    for i in 0..l.len() - 1 {
        end = end.max(i + 1);
        while end + 1 < l.len() && l[end].s_mm - l[i].s_mm < SPAN * path.radius_mm {
            end += 1;
        }
        let (way, over) = (l[end].s_mm - l[i].s_mm, (l[end].contact - l[i].contact).norm());
        let contact_mm_s = over / (t[end] - t[i]);
        if contact_mm_s > worst.0 {
            worst = (contact_mm_s, i);
        }
        mark_mm = mark_mm.max(chip.mark_mm(contact_mm_s, way / over.max(1e-3 * way)));
        if contact_mm_s < chip.contact_mm_s[0] {
            below += t[i + 1] - t[i];
        }
    }
    let angles = l.iter().zip(&plan.schedule.theta).enumerate();
    let angles = angles.map(|(row, (l, theta))| path.cone(row).tool_axis(*theta).angle(&l.normal));
    let sine = angles.map(f64::sin).fold(1.0, f64::min);
    let feed_mm = chip.feed_per_tooth_mm(worst.0);
    let figures = ToothFigures {
        feed_mm,
        chip_mm: chip.sine_of_engagement.map(|sine| feed_mm * sine),
        mark_mm,
        below_least: below / (t[t.len() - 1] - t[0]),
        least_speed_m_min: chip.cutting_speed_m_min(sine),
    };
    let limit = chip.feed_per_tooth_mm(chip.contact_mm_s[1]) * (1.0 + FEED);
    let note = format!(
        "marks along the feed up to {mark_mm:.6} mm; {:.2} % of the time below the least feed per tooth; at least {:.1} m/min",
        100.0 * figures.below_least,
        figures.least_speed_m_min
    );
    let quantity = "greatest feed per tooth of the contact";
    let check = Check::at_most(CheckId::ToothFeed, quantity, feed_mm, limit.min(f64::MAX), "mm", note);
    (check.at_location(worst.1, plan, blade), figures)
}
