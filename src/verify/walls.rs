//! The channel of a plan, proven again: its hulls follow from its walls, and at places along the
//! path the whole tool keeps clear at angles all over the interval.
//!
//! | check | measured |
//! | --- | --- |
//! | `plan-channel` | rows whose hulls do not follow from the walls, or that are wider than the contact angle or the rotary axis allow |
//! | `channel-clear` | at some hundred rows, least distance of the tool without its ball to the part and to fixtures, over what is asked for, from wall to wall |
//!
//! A schedule is judged against these walls (`theta-channel`), and so must they be. Rows are looked
//! at evenly along the path, and where a wall jumps most from one row to the next: there a single
//! row that was widened shows. Walls that are narrower than they need be do no harm and are not
//! found.

use super::apart::Apart;
use super::clearance;
use super::options::Asked;
use crate::artifact::channel::ChannelRow;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Plan, Stand};
use crate::parallel;
use crate::tool::Tool;

/// Rows that are looked at along the path.
const EVENLY: usize = 160;
/// ... and those with the greatest jumps of a wall.
const JUMPS: usize = 40;
/// Angles of each: from wall to wall.
const ANGLES: usize = 5;
/// Rounding of angles, rad.
const ROUNDING: f64 = 1e-9;
/// Ends by the contact angle are closed forms, whose cosine is rounded.
const CONTACT_RAD: f64 = 1e-6;

/// The checks of this module.
pub(super) fn check(plan: &Plan, blade: &Blade, tool: &Tool, apart: &[Apart], asked: &Asked) -> Vec<Check> {
    vec![rows(plan, blade, asked), clear(plan, blade, tool, apart)]
}

/// What of all rows can be told without the part.
fn rows(plan: &Plan, blade: &Blade, asked: &Asked) -> Check {
    let (rows, round) = (&plan.channel.rows, plan.channel.sweep.is_round());
    let mut wrong: Vec<(usize, String)> = Vec::new();
    let low: Vec<f64> = rows
        .iter()
        .scan(f64::NEG_INFINITY, |m, r| {
            *m = if round { m.max(r.theta_min) } else { r.theta_min };
            Some(*m)
        })
        .collect();
    let mut high: Vec<f64> = rows
        .iter()
        .rev()
        .scan(f64::INFINITY, |m, r| {
            *m = if round { m.min(r.theta_max) } else { r.theta_max };
            Some(*m)
        })
        .collect();
    high.reverse();
    for (k, row) in rows.iter().enumerate() {
        let deg = f64::to_degrees;
        for (name, is, want) in [("hull_min", row.hull_min, low[k]), ("hull_max", row.hull_max, high[k])] {
            if !((is - want).abs() <= ROUNDING * (1.0 + want.abs())) {
                wrong.push((k, format!("{name} is {:.6}°, by the walls it is {:.6}°", deg(is), deg(want))));
            }
        }
        let says = format!("the channel goes from {:.4}° to {:.4}°", deg(row.theta_min), deg(row.theta_max));
        let width = row.theta_max - row.theta_min;
        if !(0.0..=std::f64::consts::TAU + ROUNDING).contains(&width) {
            wrong.push((k, format!("{says}, a width of {:.4}°: none, or more than the whole circle", deg(width))));
        } else if let Some([lo, hi]) =
            asked.theta_limits_rad.filter(|[lo, hi]| row.theta_min < lo - ROUNDING || row.theta_max > hi + ROUNDING)
        {
            wrong.push((k, format!("{says}, the rotary axis from {:.4}° to {:.4}°", deg(lo), deg(hi))));
        } else if let Some(angle) = contact_outside(plan, k, row, asked) {
            let [least, most] = asked.contact_rad.map(deg);
            wrong.push((
                k,
                format!("{says}, where the contact angle is {:.4}°, the job asks for {least} to {most}", deg(angle)),
            ));
        }
    }
    let narrowest = rows.iter().map(|r| r.hull_max - r.hull_min).fold(f64::INFINITY, f64::min);
    let named = rows.get(plan.channel.narrowest_row).map_or(f64::NAN, |r| r.hull_max - r.hull_min);
    if !((named - narrowest).abs() <= ROUNDING) {
        let at = plan.channel.narrowest_row;
        wrong.push((
            at.min(rows.len() - 1),
            format!(
                "narrowest_row is {at}, where the channel is {:.6}° wide; the least is {:.6}°",
                named.to_degrees(),
                narrowest.to_degrees()
            ),
        ));
    }
    let quantity = "rows of the channel that cannot be";
    let note = wrong.first().map_or(String::new(), |(k, says)| format!("plan.json, channel row {k}: {says}"));
    let check = Check::at_most(CheckId::PlanChannel, quantity, wrong.len() as f64, 0.0, "", note);
    match wrong.first() {
        Some((row, _)) => check.at_location(*row, plan, blade),
        None => check,
    }
}

/// A contact angle at an end of a row's interval that is outside what the job permits, rad.
fn contact_outside(plan: &Plan, k: usize, row: &ChannelRow, asked: &Asked) -> Option<f64> {
    let normal = plan.toolpath.locations.get(k)?.normal;
    let [least, most] = asked.contact_rad;
    let room = asked.tolerance_rad + CONTACT_RAD;
    let cone = plan.toolpath.cone(k);
    let angle = |theta: f64| normal.dot(&cone.tool_axis(theta)).clamp(-1.0, 1.0).acos();
    [row.theta_min, row.theta_max].map(angle).into_iter().find(|a| *a > most + room || *a < least - room)
}

/// Rows to look at: evenly, and where walls jump.
fn chosen(rows: &[ChannelRow]) -> Vec<usize> {
    let n = rows.len();
    let mut out: Vec<usize> = (0..n).step_by(n.div_ceil(EVENLY).max(1)).collect();
    let jump = |k: usize| {
        let (a, b) = (&rows[k], &rows[k + 1]);
        (a.theta_min - b.theta_min).abs().max((a.theta_max - b.theta_max).abs())
    };
    let mut jumps: Vec<(f64, usize)> = (0..n - 1).map(|k| (jump(k), k)).collect();
    jumps.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    out.extend(jumps.iter().take(JUMPS).flat_map(|(_, k)| [*k, k + 1]));
    out.sort_unstable();
    out.dedup();
    out
}

/// The tool from wall to wall.
fn clear(plan: &Plan, blade: &Blade, tool: &Tool, apart: &[Apart]) -> Check {
    let rows = chosen(&plan.channel.rows);
    // How much is missing of what is asked for, and where.
    let one = |&k: &usize| {
        let (row, l, cone) = (&plan.channel.rows[k], &plan.toolpath.locations[k], plan.toolpath.cone(k));
        let mut worst: Option<(f64, usize, String)> = None;
        for step in 0..ANGLES {
            let theta = row.theta_min + (row.theta_max - row.theta_min) * step as f64 / (ANGLES - 1) as f64;
            // The disc under a corner goes with θ.
            let centre = match tool.is_ball() {
                true => l.centre,
                false => tool.centre_at(&l.contact, &l.normal, &cone.tool_axis(theta), None).unwrap_or(l.centre),
            };
            let stand = Stand { centre, cone, theta };
            for a in apart {
                // Ends by exact faces may be nearer to their mesh by its deflection.
                let off_mm = if a.obstacle.is_some() { 0.0 } else { a.part.deflection_mm };
                let least_mm = a.asked_mm - off_mm;
                let near = clearance::nearer(a.part, &a.segments, &stand, least_mm);
                let Some((near, missing)) = near.map(|near| (near, least_mm - near.distance_mm)) else { continue };
                if worst.as_ref().is_none_or(|w| missing > w.0) {
                    let who = a.segments.get(near.segment).map_or_else(|| "tool".into(), |s| s.part.to_string());
                    let says = format!(
                        "plan.json, channel row {k}, from {:.4}° to {:.4}°: at {:.4}° the {who} is {:.6} from {}, asked for {}",
                        row.theta_min.to_degrees(),
                        row.theta_max.to_degrees(),
                        theta.to_degrees(),
                        near.distance_mm,
                        a.obstacle.map_or("the part", |o| o.name.as_str()),
                        a.asked_mm
                    );
                    worst = Some((missing, k, says));
                }
            }
        }
        worst
    };
    let found: Vec<_> = parallel::map(&rows, one);
    let worst = found.into_iter().flatten().reduce(|a, b| if b.0 > a.0 { b } else { a });
    let quantity = "how much is missing of the clearance between the walls of the channel, at places along the path";
    let (missing, row, note) = worst.unwrap_or((0.0, 0, format!("{} rows, {ANGLES} angles each", rows.len())));
    let check = Check::at_most(CheckId::ChannelClear, quantity, missing, clearance::TOUCH_MM, "mm", note);
    if missing > 0.0 { check.at_location(row, plan, blade) } else { check }
}
