//! What the page's script draws: JSON with lists in a block of numbers ([`super::pack`]). Angles in
//! degrees, lengths in mm, times in s.

use std::ops::Range;

use serde_json::{Value, json};

use super::pack::{DIGITS, Pack, TIME};
use super::{ReportInput, free_axes, scallop, scene};
use crate::artifact::{AxisMotion, AxisRows, Plan, Section, Sweep};
use crate::machine::{Axis, Machine};
use crate::write::draw::colour;
use crate::write::preview::values;

/// Points of all S–θ curves together, about.
const CURVE_POINTS: usize = 24_000;
/// Points of all axis curves together, about.
const AXIS_POINTS: usize = 16_000;
/// Most sections.
const SECTIONS: usize = 30;
/// Most points of a section's loop.
const LOOP_POINTS: usize = 400;

/// The whole data.
pub(super) fn payload(input: &ReportInput, pack: &mut Pack) -> Value {
    json!({
        "turns": input.plan.map(|p| turns(p, input, pack)),
        "schedule": input.plan.map(|p| format!("{:?}", p.schedule.kind).to_lowercase()),
        "others": input.others.iter().map(|o| o.name).collect::<Vec<_>>(),
        "baseline": input.baseline.map(|b| b.name),
        "axes": input.plan.map(|p| axes(p, input, pack)),
        "sections": sections(input.sections, pack),
        "scallop": scallop::data(input, pack),
        "scene": scene::scene(input, pack),
        "free_axes": free_axes::data(input, &scene::picked(input.plan), pack),
        "colours": colour::STOPS.map(colour::hex),
        "no_colour": colour::hex(colour::NONE),
        "left_out": values::LEFT_OUT,
    })
}

/// Rounded to `digits` after the point.
pub(super) fn rounded(value: f64, digits: i32) -> Value {
    let scale = 10f64.powi(digits);
    // Adding 0 turns -0 into 0.
    let v = (value * scale).round() / scale + 0.0;
    if v.is_finite() { json!(v) } else { Value::Null }
}

/// The locations of each turn, within the lists that there are.
fn ranges(plan: &Plan) -> Vec<Range<usize>> {
    let n = plan.toolpath.locations.len().min(plan.channel.rows.len()).min(plan.schedule.theta.len());
    let range = |t: &crate::artifact::toolpath::Turn| t.first.min(n)..t.first.saturating_add(t.count).min(n);
    plan.toolpath.turns.iter().map(range).collect()
}

/// Cuts a turn into at most `most` stretches.
pub(super) fn stretches(range: &Range<usize>, most: usize) -> Vec<Range<usize>> {
    let count = range.len();
    let pieces = most.clamp(1, count.max(1));
    (0..pieces)
        .map(|k| range.start + k * count / pieces..range.start + (k + 1) * count / pieces)
        .filter(|r| !r.is_empty())
        .collect()
}

fn turns(plan: &Plan, input: &ReportInput, pack: &mut Pack) -> Value {
    let ranges = ranges(plan);
    let most = (CURVE_POINTS / ranges.len().max(1)).clamp(72, 400);
    let all = plan.toolpath.turns.iter().zip(&ranges);
    Value::Array(all.map(|(turn, range)| one_turn(plan, input, turn.length_mm, range, most, pack)).collect())
}

fn one_turn(
    plan: &Plan,
    input: &ReportInput,
    length_mm: f64,
    range: &Range<usize>,
    most: usize,
    pack: &mut Pack,
) -> Value {
    let (path, rows) = (&plan.toolpath, &plan.channel.rows);
    let pieces = stretches(range, most);
    let zero = plan.schedule.theta.get(range.start).copied().unwrap_or(0.0);
    let base_s = path.locations.get(range.start).map_or(0.0, |l| l.s_mm);
    let degrees = |v: f64| (v - zero).to_degrees();
    // The tightest wall of a stretch as seen from the schedule: θ itself rises within it.
    let theta = |i: usize| plan.schedule.theta[i];
    let mut wall = |f: &dyn Fn(usize) -> f64, tighter: fn(f64, f64) -> f64| {
        let gap = |p: &Range<usize>| p.clone().map(|i| f(i) - theta(i)).fold(f64::NAN, tighter);
        pack.list(DIGITS, pieces.iter().map(|p| degrees(theta(p.start) + gap(p))))
    };
    let walls = [
        wall(&|i| rows[i].theta_min, f64::max),
        wall(&|i| rows[i].theta_max, f64::min),
        wall(&|i| rows[i].hull_min, f64::max),
        wall(&|i| rows[i].hull_max, f64::min),
        wall(&|i| rows[i].tangent_min, f64::max),
        wall(&|i| rows[i].tangent_max, f64::min),
    ];
    let [min, max, hull_min, hull_max, tangent_min, tangent_max] = walls;
    let mut at = |f: &dyn Fn(usize) -> f64| pack.list(DIGITS, pieces.iter().map(|p| f(p.start)));
    let keys: Vec<Value> = plan
        .schedule
        .key_points
        .iter()
        .filter(|k| k[0] >= base_s - 1e-9 && k[0] <= base_s + length_mm + 1e-9)
        .map(|k| json!([rounded(k[0] - base_s, 3), rounded(degrees(k[1]), 3)]))
        .collect();
    let of = |list: &[f64], i: usize| list.get(i).map_or(f64::NAN, |v| degrees(*v));
    let others: Vec<Value> = input.others.iter().map(|o| at(&|i| of(&o.schedule.theta, i))).collect();
    json!({
        "length": rounded(length_mm, 3), "zero": rounded(zero.to_degrees(), 3), "from": rounded(base_s, 3),
        "s": at(&|i| path.locations[i].s_mm - base_s), "theta": at(&|i| degrees(theta(i))),
        "min": min, "max": max, "hull_min": hull_min, "hull_max": hull_max,
        "tangent_min": tangent_min, "tangent_max": tangent_max, "others": others, "keys": keys,
    })
}

/// Times of a turn, from its start, and for each axis position at the start of each stretch and of
/// velocity, acceleration and jerk the one of greatest size in it.
/// `counted`: an axis that is shown from the start of the range on; the others are shown where
/// they are.
pub(super) fn motion_of(
    motion: &AxisMotion,
    machine: &Machine,
    counted: Option<usize>,
    pieces: &[Range<usize>],
    pack: &mut Pack,
) -> Value {
    let begin = pieces.first().map_or(0, |p| p.start);
    let start = motion.t_s.get(begin).copied().unwrap_or(0.0);
    let first = motion.position.get(begin).unwrap_or_default();
    let t = pack.list(TIME, pieces.iter().map(|p| motion.t_s.get(p.start).map_or(f64::NAN, |t| t - start)));
    let all = machine.axes();
    let axes = (0..first.len()).map(|axis| {
        let scale = all[axis].scale();
        let zero = if counted == Some(axis) { first[axis] } else { 0.0 };
        let at = |p: &Range<usize>| motion.position.get(p.start).map_or(f64::NAN, |r| (r[axis] - zero) * scale);
        let mut peak = |rows: &AxisRows| {
            let greatest = |p: &Range<usize>| {
                let values = p.clone().filter_map(|i| rows.get(i)).map(|r| r[axis] * scale);
                values.fold(f64::NAN, |best, v| if v.abs() > best.abs() || best.is_nan() { v } else { best })
            };
            pack.scaled(pieces.iter().map(greatest))
        };
        let rates = [peak(&motion.velocity), peak(&motion.acceleration), peak(&motion.jerk)];
        let [v, a, j] = rates;
        json!([pack.list(DIGITS, pieces.iter().map(at)), v, a, j])
    });
    let axes: Vec<Value> = axes.collect();
    let zero = counted.and_then(|k| Some(first.get(k)? * all[k].scale()));
    json!({ "t": t, "from": rounded(start, 4), "zero": rounded(zero.unwrap_or(0.0), 3), "axes": axes })
}

fn axes(plan: &Plan, input: &ReportInput, pack: &mut Pack) -> Value {
    let ranges = ranges(plan);
    let most = (AXIS_POINTS / ranges.len().max(1)).clamp(40, 400);
    let baseline = input.baseline.and_then(|b| b.motion);
    // What goes round with the blade turn after turn counts from the start of a turn.
    let turning = (plan.channel.sweep != Sweep::Swing).then(|| input.machine.turning_axis());
    let mut turns = Vec::new();
    for range in &ranges {
        let pieces = stretches(range, most);
        let s = pack.list(DIGITS, pieces.iter().map(|p| plan.toolpath.locations[p.start].s_mm));
        let own = motion_of(&plan.motion, input.machine, turning, &pieces, pack);
        let other = baseline.map(|m| motion_of(m, input.machine, turning, &pieces, pack));
        turns.push(json!({ "s": s, "plan": own, "baseline": other }));
    }
    axes_with(input.machine, turning, turns)
}

/// The axes of a machine with their motion in turns; `counted` as in [`motion_of`].
pub(super) fn axes_with(machine: &Machine, counted: Option<usize>, turns: Vec<Value>) -> Value {
    let axes = machine.axes();
    json!({
        "counted": counted,
        "names": axes.iter().map(|a| &a.name).collect::<Vec<_>>(),
        "units": axes.iter().map(Axis::sign).collect::<Vec<_>>(),
        "rotary": machine.rotary().collect::<Vec<_>>(),
        "limits": axes.iter().map(|a| (a.limits, a.scale())).map(|(l, scale)| json!([
            rounded(l.velocity * scale, 3), rounded(l.acceleration * scale, 3), rounded(l.jerk * scale, 3)
        ])).collect::<Vec<_>>(),
        "turns": turns,
    })
}

fn sections(sections: &[Section], pack: &mut Pack) -> Value {
    let shown = SECTIONS.min(sections.len());
    let pick = |k: usize| if shown > 1 { k * (sections.len() - 1) / (shown - 1) } else { 0 };
    Value::Array((0..shown).filter_map(|k| sections.get(pick(k))).map(|s| section(s, pack)).collect())
}

fn section(section: &Section, pack: &mut Pack) -> Value {
    let mut loops = Vec::new();
    for l in &section.loops {
        let stride = l.points_mm.len().div_ceil(LOOP_POINTS).max(1);
        let picked: Vec<usize> = (0..l.points_mm.len()).step_by(stride).collect();
        loops.push(json!({
            "y": pack.list(DIGITS, picked.iter().map(|&i| l.points_mm[i][0])),
            "z": pack.list(DIGITS, picked.iter().map(|&i| l.points_mm[i][1])),
            "s": pack.list(DIGITS, picked.iter().map(|&i| l.s_mm.get(i).copied().unwrap_or(f64::NAN))),
            "k": pack.scaled(picked.iter().map(|&i| l.curvature_per_mm.get(i).copied().unwrap_or(f64::NAN))),
            "length": rounded(l.length_mm, 3),
            "altered": l.altered_points.iter().map(|a| json!([
                rounded(a.point_mm[0], 3), rounded(a.point_mm[1], 3), rounded(a.s_mm, 3), a.into_concave
            ])).collect::<Vec<_>>(),
            "le": rounded(l.leading_edge_s_mm, 3),
            "te": rounded(l.trailing_edge_s_mm, 3),
            "chord": rounded(l.chord_mm, 3),
            "thickness": rounded(l.thickness_mm, 3),
        }));
    }
    json!({ "x": rounded(section.x_mm, 3), "loops": loops })
}
