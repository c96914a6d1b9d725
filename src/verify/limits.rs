//! The machine: every axis within its travel, velocity and acceleration, and the axes really place
//! the tool where the plan says.
//!
//! Only times and positions of the motion are read; its velocity and acceleration columns are not.
//! The difference quotient of positions is a mean of the true velocity over the interval, and the
//! difference of two neighbouring ones over half of both intervals a weighted mean of the true
//! acceleration, so a motion within its limits cannot exceed them in these figures by more than
//! rounding. They are lower bounds of the true peaks.
//!
//! Positions are turned back into ball centre and tool axis by the machine's forward kinematics and
//! compared with cutter location and `a(θ)`.

use super::options::VerifyOptions;
use crate::artifact::report::Check;
use crate::artifact::{AxisCheck, Blade, CheckId, Plan};
use crate::machine::{Axis, Machine};
use crate::tool::Tool;

/// A worst value and its row; the first of equals.
#[derive(Clone, Copy)]
struct WorstRow {
    value: f64,
    row: usize,
}

fn worst(values: impl Iterator<Item = f64>) -> WorstRow {
    values.enumerate().fold(WorstRow { value: f64::NEG_INFINITY, row: 0 }, |w, (row, value)| {
        // What is not a number is worse than everything: a step of time that is 0.
        let value = if value.is_nan() { f64::INFINITY } else { value };
        if value > w.value { WorstRow { value, row } } else { w }
    })
}

/// The worst that one axis does, and what it may.
struct AxisPeak {
    axis: usize,
    kind: AxisCheck,
    found: WorstRow,
    limit: f64,
}

/// All checks of the machine's motion.
pub(super) fn check(plan: &Plan, blade: &Blade, tool: &Tool, machine: &Machine, options: &VerifyOptions) -> Vec<Check> {
    let mut checks = vec![forward_in_time(plan, blade)];
    for (axis, Axis { limits: limit, .. }) in machine.axes().iter().enumerate() {
        let travel = limit.travel.map(|[lo, hi]| {
            let over = |q: &[f64]| (lo - q[axis]).max(q[axis] - hi);
            (AxisCheck::Travel, worst(plan.motion.position.iter().map(over)), 0.0)
        });
        let (v, a) = (velocities(plan, axis), accelerations(plan, axis));
        let v = worst(v.iter().map(|v| v.abs()));
        let a = worst(a.iter().map(|a| a.abs()));
        let dynamic = [(AxisCheck::Velocity, v, limit.velocity), (AxisCheck::Acceleration, a, limit.acceleration)];
        for (kind, found, limit) in travel.into_iter().chain(dynamic) {
            checks.push(judge(&AxisPeak { axis, kind, found, limit }, plan, blade, machine, options));
        }
    }
    checks.extend(placed(plan, blade, tool, machine, options));
    checks
}

/// Mean velocities between rows.
fn velocities(plan: &Plan, axis: usize) -> Vec<f64> {
    let (q, t) = (&plan.motion.position, &plan.motion.t_s);
    (0..t.len() - 1).map(|i| (q[i + 1][axis] - q[i][axis]) / (t[i + 1] - t[i])).collect()
}

/// Mean accelerations about rows: entry `i` belongs to row `i + 1`.
fn accelerations(plan: &Plan, axis: usize) -> Vec<f64> {
    let (v, t) = (velocities(plan, axis), &plan.motion.t_s);
    (1..v.len()).map(|i| (v[i] - v[i - 1]) / (0.5 * (t[i + 1] - t[i - 1]))).collect()
}

/// Range of an axis over the motion beside its travel, and what moves it.
fn where_it_goes(axis: usize, plan: &Plan, machine: &Machine) -> String {
    let own = &machine.axes()[axis];
    let Some(travel) = own.limits.travel else { return String::new() };
    let positions = plan.motion.position.iter().map(|q| q[axis]);
    let (lo, hi) = positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let what = match machine.linear().iter().position(|k| *k == axis) {
        Some(2) => "; a longer tool or holder raises it, machine.mount places the blade",
        Some(_) => "; machine.mount places the blade",
        None => "",
    };
    let [a, b, c, d] = [lo, hi, travel[0], travel[1]].map(|x| x * own.scale());
    format!("it runs from {a:.3} to {b:.3}, the travel is {c:.3} to {d:.3}{what}")
}

fn judge(peak: &AxisPeak, plan: &Plan, blade: &Blade, machine: &Machine, options: &VerifyOptions) -> Check {
    let AxisPeak { axis, kind, found, limit } = *peak;
    let own = &machine.axes()[axis];
    let (name, scale) = (&own.name, own.scale());
    let (quantity, per) = match kind {
        AxisCheck::Travel => ("how far it leaves its travel", ""),
        AxisCheck::Velocity => ("greatest velocity, from positions and times", "/s"),
        AxisCheck::Acceleration => ("greatest acceleration, from positions and times", "/s²"),
        AxisCheck::Jerk => ("greatest jerk, from positions and times", "/s³"),
    };
    let unit = format!("{}{per}", own.unit());
    // Rounding of positions, and the limits' own units.
    let slack = if kind == AxisCheck::Travel { 1e-9 } else { options.limit_tolerance * limit };
    let row = if kind == AxisCheck::Acceleration { found.row + 1 } else { found.row };
    let worst = match found.value {
        f64::NEG_INFINITY => 0.0, // nothing to difference: two rows have no acceleration
        v if v.is_finite() => v * scale,
        _ => f64::MAX,
    };
    let (id, quantity) = (CheckId::axis(name, kind), format!("axis {name}: {quantity}"));
    let worst = if kind == AxisCheck::Travel { worst.max(0.0) } else { worst };
    let note = if kind == AxisCheck::Travel { where_it_goes(axis, plan, machine) } else { String::new() };
    let check = Check::at_most(id, &quantity, worst, limit * scale, &unit, note);
    Check { passed: found.value <= limit + slack, ..check }.at_location(row, plan, blade)
}

/// Times rise from row to row.
fn forward_in_time(plan: &Plan, blade: &Blade) -> Check {
    let t = &plan.motion.t_s;
    let back = worst(t.windows(2).map(|w| w[0] - w[1]));
    let quantity = "greatest step back in time, seconds";
    let note = if back.value == 0.0 { "two rows at the same time".into() } else { String::new() };
    let check = Check::at_most(CheckId::Time, quantity, back.value.max(0.0), 0.0, "s", note);
    Check { passed: back.value < 0.0, ..check }.at_location(back.row, plan, blade)
}

/// The axes place ball centre and tool axis where the plan has them.
fn placed(plan: &Plan, blade: &Blade, tool: &Tool, machine: &Machine, options: &VerifyOptions) -> [Check; 2] {
    let gauge = tool.length_mm();
    let poses: Vec<_> = plan.motion.position.iter().map(|q| machine.forward(q, gauge)).collect();
    let apart = poses.iter().zip(&plan.toolpath.locations).map(|(p, l)| (p.centre - l.centre).norm());
    let centre = worst(apart);
    let turned = poses.iter().zip(plan.toolpath.stands(&plan.schedule.theta)).map(|(p, stand)| {
        let a = stand.axis();
        p.axis.cross(&a).norm().atan2(p.axis.dot(&a)).to_degrees()
    });
    let axis = worst(turned);
    let check = |id: CheckId, quantity: &str, found: WorstRow, limit: f64, unit: &str| {
        Check::at_most(id, quantity, found.value, limit, unit, String::new()).at_location(found.row, plan, blade)
    };
    let limit = options.angle_tolerance_deg;
    [
        check(
            CheckId::AxesCentre,
            "distance of the ball centre that the axes give from the cutter location",
            centre,
            1e-6,
            "mm",
        ),
        check(
            CheckId::AxesDirection,
            "angle between the tool axis that the axes give and a(θ), degrees",
            axis,
            limit,
            "deg",
        ),
    ]
}
