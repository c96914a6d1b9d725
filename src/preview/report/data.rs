//! What the page's script draws, as JSON. Angles in degrees, lengths in mm; missing numbers are `null`.

use std::ops::Range;

use serde_json::{Value, json};

use super::{ReportInput, scene};
use crate::artifact::axis_motion::AXES;
use crate::artifact::{AxisMotion, Plan, Section};

/// Points of all S–θ curves together, about.
const CURVE_POINTS: usize = 16_000;
/// Points of all axis curves together, about.
const AXIS_POINTS: usize = 8_000;
/// Most sections.
const SECTIONS: usize = 30;
/// Most points of a section's loop.
const LOOP_POINTS: usize = 400;

/// The whole data.
pub(super) fn payload(input: &ReportInput) -> Value {
    json!({
        "turns": input.plan.map(|p| turns(p, input)),
        "baseline": input.baseline.map(|b| b.name),
        "axes": input.plan.map(|p| axes(p, input)),
        "sections": sections(input.sections),
        "scene": scene::scene(input),
    })
}

/// Rounded to `digits` after the point.
pub(super) fn rounded(value: f64, digits: i32) -> Value {
    let scale = 10f64.powi(digits);
    // Adding 0 turns -0 into 0.
    let v = (value * scale).round() / scale + 0.0;
    if v.is_finite() { json!(v) } else { Value::Null }
}

fn list(values: impl Iterator<Item = f64>, digits: i32) -> Value {
    Value::Array(values.map(|v| rounded(v, digits)).collect())
}

/// The locations of each turn, within the lists that there are.
fn ranges(plan: &Plan) -> Vec<Range<usize>> {
    let n = plan.toolpath.locations.len().min(plan.channel.rows.len()).min(plan.schedule.theta.len());
    let range = |t: &crate::artifact::toolpath::Turn| t.first.min(n)..t.first.saturating_add(t.count).min(n);
    plan.toolpath.turns.iter().map(range).collect()
}

/// Cuts a turn into at most `most` stretches.
fn stretches(range: &Range<usize>, most: usize) -> Vec<Range<usize>> {
    let count = range.len();
    let pieces = most.clamp(1, count.max(1));
    (0..pieces)
        .map(|k| range.start + k * count / pieces..range.start + (k + 1) * count / pieces)
        .filter(|r| !r.is_empty())
        .collect()
}

fn turns(plan: &Plan, input: &ReportInput) -> Value {
    let ranges = ranges(plan);
    let most = (CURVE_POINTS / ranges.len().max(1)).clamp(72, 400);
    let fixed = input.baseline.map(|b| &b.schedule.theta);
    let (path, rows) = (&plan.toolpath, &plan.channel.rows);
    let one = |(turn, range): (&crate::artifact::toolpath::Turn, &Range<usize>)| {
        let pieces = stretches(range, most);
        let zero = plan.schedule.theta.get(range.start).copied().unwrap_or(0.0);
        let base_s = path.locations.get(range.start).map_or(0.0, |l| l.s_mm);
        let degrees = |v: f64| (v - zero).to_degrees();
        // The tightest wall of a stretch as seen from the schedule: θ itself rises within it.
        let theta = |i: usize| plan.schedule.theta[i];
        let wall = |f: &dyn Fn(usize) -> f64, tighter: fn(f64, f64) -> f64| {
            let gap = |p: &Range<usize>| p.clone().map(|i| f(i) - theta(i)).fold(f64::NAN, tighter);
            list(pieces.iter().map(|p| degrees(theta(p.start) + gap(p))), 2)
        };
        let high = |f: &dyn Fn(usize) -> f64| wall(f, f64::max);
        let low = |f: &dyn Fn(usize) -> f64| wall(f, f64::min);
        let at = |f: &dyn Fn(usize) -> f64, digits| list(pieces.iter().map(|p| f(p.start)), digits);
        let keys: Vec<Value> = plan
            .schedule
            .key_points
            .iter()
            .filter(|k| k[0] >= base_s - 1e-9 && k[0] <= base_s + turn.length_mm + 1e-9)
            .map(|k| json!([rounded(k[0] - base_s, 3), rounded(degrees(k[1]), 2)]))
            .collect();
        json!({
            "length": rounded(turn.length_mm, 3),
            "zero": rounded(zero.to_degrees(), 3),
            "s": at(&|i| path.locations[i].s_mm - base_s, 3),
            "theta": at(&|i| degrees(theta(i)), 3),
            "min": high(&|i| rows[i].theta_min),
            "max": low(&|i| rows[i].theta_max),
            "hull_min": high(&|i| rows[i].hull_min),
            "hull_max": low(&|i| rows[i].hull_max),
            "tangent_min": high(&|i| rows[i].tangent_min),
            "tangent_max": low(&|i| rows[i].tangent_max),
            "fixed": fixed.map(|f| at(&|i| f.get(i).map_or(f64::NAN, |v| degrees(*v)), 2)),
            "keys": keys,
        })
    };
    Value::Array(path.turns.iter().zip(&ranges).map(one).collect())
}

/// Scale of an axis from inner units to those shown.
fn scale(axis: usize) -> f64 {
    if axis < 3 { 1.0 } else { 1f64.to_degrees() }
}

/// Position at the start of each stretch; of rates the one of greatest size in the stretch.
fn axis_curves(motion: &AxisMotion, pieces: &[Range<usize>], axis: usize, zero: f64) -> Value {
    let position =
        pieces.iter().map(|p| motion.position.get(p.start).map_or(f64::NAN, |r| (r[axis] - zero) * scale(axis)));
    let peak = |rows: &[[f64; 5]]| {
        let greatest = |p: &Range<usize>| {
            p.clone()
                .filter_map(|i| rows.get(i))
                .map(|r| r[axis] * scale(axis))
                .fold(f64::NAN, |best, v| if v.abs() > best.abs() || best.is_nan() { v } else { best })
        };
        list(pieces.iter().map(greatest), 2)
    };
    json!([list(position, 3), peak(&motion.velocity), peak(&motion.acceleration)])
}

fn axes(plan: &Plan, input: &ReportInput) -> Value {
    let ranges = ranges(plan);
    let most = (AXIS_POINTS / ranges.len().max(1)).clamp(40, 300);
    let baseline = input.baseline.and_then(|b| b.motion);
    let limits = input.machine.limits();
    let one = |range: &Range<usize>| {
        let pieces = stretches(range, most);
        let s0 = plan.toolpath.locations.get(range.start).map_or(0.0, |l| l.s_mm);
        let s = pieces.iter().map(|p| plan.toolpath.locations[p.start].s_mm - s0);
        let curves = |motion: &AxisMotion| {
            let first = motion.position.get(range.start).copied().unwrap_or_default();
            // A is shown from the turn's start on, the others where they are.
            let zero = |axis: usize| if axis == 3 { first[3] } else { 0.0 };
            Value::Array((0..AXES.len()).map(|a| axis_curves(motion, &pieces, a, zero(a))).collect())
        };
        json!({ "s": list(s, 3), "plan": curves(&plan.motion), "baseline": baseline.map(curves) })
    };
    json!({
        "names": AXES,
        "units": AXES.iter().enumerate().map(|(i, _)| if i < 3 { "mm" } else { "deg" }).collect::<Vec<_>>(),
        "limits": limits.iter().enumerate().map(|(i, l)| json!([
            rounded(l.velocity * scale(i), 3), rounded(l.acceleration * scale(i), 3)
        ])).collect::<Vec<_>>(),
        "turns": ranges.iter().map(one).collect::<Vec<_>>(),
    })
}

fn sections(sections: &[Section]) -> Value {
    let shown = SECTIONS.min(sections.len());
    let pick = |k: usize| if shown > 1 { k * (sections.len() - 1) / (shown - 1) } else { 0 };
    Value::Array((0..shown).filter_map(|k| sections.get(pick(k))).map(section).collect())
}

fn section(section: &Section) -> Value {
    let loops = section.loops.iter().map(|l| {
        let stride = l.points_mm.len().div_ceil(LOOP_POINTS).max(1);
        let picked: Vec<usize> = (0..l.points_mm.len()).step_by(stride).collect();
        json!({
            "p": picked.iter().flat_map(|&i| l.points_mm[i]).map(|v| rounded(v, 3)).collect::<Vec<_>>(),
            "s": list(picked.iter().map(|&i| l.s_mm.get(i).copied().unwrap_or(f64::NAN)), 3),
            "k": list(picked.iter().map(|&i| l.curvature_per_mm.get(i).copied().unwrap_or(f64::NAN)), 5),
            "length": rounded(l.length_mm, 3),
            "altered": l.altered_points.iter().map(|a| json!([
                rounded(a.point_mm[0], 3), rounded(a.point_mm[1], 3), a.into_concave
            ])).collect::<Vec<_>>(),
            "le": rounded(l.leading_edge_s_mm, 3),
            "te": rounded(l.trailing_edge_s_mm, 3),
            "first_side": l.side_after_leading_edge,
            "chord": rounded(l.chord_mm, 3),
            "thickness": rounded(l.thickness_mm, 3),
        })
    });
    json!({ "x": rounded(section.x_mm, 3), "loops": loops.collect::<Vec<_>>() })
}
