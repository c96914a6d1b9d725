//! Chains of axes: against the closed form of the table-head machine, against themselves, and where
//! they must refuse.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;

use super::{Axis, Carries, Head, Machine};
use crate::artifact::Axes;
use crate::error::ErrorKind;
use crate::geometry::{Point, Vector};
use crate::tool;

const TRUNNION: &str = include_str!("../../models/machines/trunnion_ac.toml");
const FORK: &str = include_str!("../../models/machines/fork_head_ca.toml");
const NUTATING: &str = include_str!("../../models/machines/nutating_head_cb.toml");
const FOUR: &str = include_str!("../../models/machines/four_axis_a.toml");

fn machine(text: &str) -> Machine {
    Machine::from_toml(text, "test").unwrap()
}

/// Table-table B-C: the trunnion's axis is Y.
fn trunnion_bc() -> Machine {
    let text = TRUNNION.replace("\"A\"", "\"B\"").replace("[axes.a]", "[axes.b]");
    machine(&text.replace("min_deg = -120.0\nmax_deg = 30.0", "min_deg = -30.0\nmax_deg = 120.0"))
}

/// The blade stands askew on the trunnion's table: five axes move.
fn askew() -> Machine {
    machine(&TRUNNION.replace("along = [0.0, 0.0, 1.0]", "along = [0.3, 0.1, 1.0]\nclamping_deg = 20.0"))
}

/// The blade lies along X on the trunnion's table: C swings to and fro.
fn lying() -> Machine {
    machine(
        &TRUNNION
            .replace("along = [0.0, 0.0, 1.0]", "along = [1.0, 0.0, 0.0]")
            .replace("min_deg = -120.0\nmax_deg = 30.0\n", ""),
    )
}

fn all() -> Vec<(&'static str, Machine, f64)> {
    vec![
        ("trunnion A-C", machine(TRUNNION), 0.1),
        ("trunnion B-C", trunnion_bc(), -0.2),
        ("fork head C-A", machine(FORK), 0.1),
        ("nutating head C-B", machine(NUTATING), 0.3),
        ("four axes", machine(FOUR), 0.0),
        ("askew", askew(), 0.4),
        ("lying", lying(), 0.5),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]
    #[test]
    fn forward_undoes_inverse_on_every_chain(
        which in 0..7usize, c in prop::array::uniform3(-200.0..200.0f64), theta in -60.0..60.0f64, gauge in 0.0..400.0f64,
        more in -0.05..0.05f64,
    ) {
        let (name, m, lean) = all().swap_remove(which);
        let lean = if m.rotary().count() > 1 { lean + more } else { lean };
        let centre = Point::from(c);
        let q = m.inverse(&centre, theta, lean, gauge);
        let pose = m.forward(&q, gauge);
        prop_assert!((pose.centre - centre).norm() < 1e-9, "{name}: {q:?}");
        prop_assert!((pose.axis - tool::axis(lean, theta)).norm() < 1e-11, "{name}: {q:?}");
        prop_assert!((m.axis_at(&q) - pose.axis).norm() < 1e-12);
        let again = m.linear_at(&centre, &q, gauge);
        prop_assert!(again.iter().zip(q.iter()).all(|(a, b)| (a - b).abs() < 1e-9), "{name}: {again:?} {q:?}");
        let [t, l] = m.theta_and_lean(&q, theta + 1.0);
        let turns = (t - theta) / TAU;
        prop_assert!((turns - turns.round()).abs() < 1e-9 && (l - lean).abs() < 1e-9, "{name}: {t} {theta}");
        // A vector is placed on the same branch, from nearby.
        let mut near = q;
        m.rotary().zip([0.3, 0.05]).for_each(|(k, off)| near[k] += off);
        let again = m.rotary_of_axis(&pose.axis, &near).unwrap();
        prop_assert!(again.iter().zip(q.iter()).all(|(a, b)| (a - b).abs() < 1e-7), "{name}: {again:?} {q:?}");
    }
}

/// The demo machine with a second head of its own X, Y, Z and B under the table, its spindle
/// upwards.
fn two_heads() -> Machine {
    let mut m = Machine::demo().unwrap();
    let own = |k: usize| Axis { name: format!("{}2", m.axes[k].name), carries: Carries::Head(1), ..m.axes[k].clone() };
    let mut second: Vec<Axis> = [0, 1, 2, 4].map(own).into();
    second[3].point.z = -150.0;
    m.axes.append(&mut second);
    let (links, spindle) = ([3, 5, 6, 7, 8], (Point::origin(), -Vector::z_axis()));
    let head = Head::new(&m.axes, &links, spindle, *m.heads[0].mount()).unwrap();
    m.heads.push(head);
    m
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]
    #[test]
    fn two_heads_share_the_table_and_stand_each_at_its_own_place(
        c in prop::array::uniform6(-100.0..100.0f64), theta in -20.0..20.0f64, lean in prop::array::uniform2(-1.2..1.2f64),
    ) {
        let m = two_heads();
        let centres = [Point::new(c[0], c[1], c[2]), Point::new(c[3], c[4], c[5])];
        // Tools that face one another ask for the same table.
        let thetas = [theta, theta + PI];
        let mut row = Axes::of_default(m.axes().len());
        let mut table = [0.0; 2];
        for k in 0..2 {
            m.heads()[k].place(&centres[k], thetas[k], lean[k], 80.0, &mut row);
            table[k] = row[m.turning_axis()];
        }
        let turns = (table[0] - table[1]) / TAU;
        prop_assert!((turns - turns.round()).abs() < 1e-9, "{table:?}");
        for k in 0..2 {
            let pose = m.heads()[k].forward(&row, 80.0);
            prop_assert!((pose.centre - centres[k]).norm() < 1e-9, "{row:?}");
            prop_assert!((pose.axis - tool::axis(lean[k], thetas[k])).norm() < 1e-11, "{row:?}");
        }
        // The first head alone places its own columns only.
        let alone = m.inverse(&centres[0], theta, lean[0], 80.0);
        prop_assert!(alone.len() == 9 && alone[..3] == row[..3] && alone[5..].iter().all(|v| *v == 0.0));
    }
}

/// Rotary positions over three turns of θ, every half degree.
fn over_turns(m: &Machine, lean: f64) -> Vec<[f64; 2]> {
    let at = |k: i32| m.rotary_of((f64::from(k) * 0.5).to_radians(), lean);
    (0..=2160).map(|k| [3, 4].map(|axis| at(k).get(axis).copied().unwrap_or(0.0))).collect()
}

#[test]
fn rotary_axes_run_on_without_a_jump_and_within_travel() {
    for (name, m, lean) in all() {
        m.check_lean(lean).unwrap();
        let q = over_turns(&m, lean);
        // The axis near the cone's edge is as fast as 1 / sin of what is between them.
        let fastest =
            q.windows(2).flat_map(|w| [w[1][0] - w[0][0], w[1][1] - w[0][1]]).fold(0.0, |m: f64, d| m.max(d.abs()));
        assert!(fastest < 0.06, "{name}: {fastest}");
        let travel = m.axes().get(4).and_then(|a| a.limits.travel);
        assert!(travel.is_none_or(|[lo, hi]| q.iter().all(|q| (lo..=hi).contains(&q[1]))), "{name}");
        let turned = (q.last().unwrap()[0] - q[0][0]) / TAU;
        let wanted = if name == "lying" { 0.0 } else { 3.0 };
        assert!((turned.abs() - wanted).abs() < 1e-9, "{name}: {turned}");
        let still = q.iter().all(|r| (r[1] - q[0][1]).abs() < 1e-15);
        assert_eq!(still, m.turns_the_blade(), "{name}");
        assert_eq!(still, !["askew", "lying"].contains(&name), "{name}");
    }
}

#[test]
fn hand_worked_poses() {
    // Blade upright on the trunnion: at θ = 0 its y comes up, so A is −85° for a lean of 5°, and
    // the tool of 100 mm stands over the point.
    let m = machine(TRUNNION);
    let lean = 5f64.to_radians();
    let q = m.inverse(&Point::new(20.0, 0.0, 0.0), 0.0, lean, 100.0);
    assert!((q[4] + 85f64.to_radians()).abs() < 1e-12, "{q:?}");
    // The point is where the trunnion's axis is, 80 mm up, so tilting leaves it there.
    assert!((q[0].abs(), q[1].abs(), (q[2] - 180.0).abs()) < (1e-9, 1e-9, 1e-9), "{q:?}");
    // The fork's pivot is 320 mm along the tool axis from the ball, and reads 220 mm less.
    let f = machine(FORK);
    let q = f.inverse(&Point::new(0.0, 0.0, 0.0), 0.3, lean, 100.0);
    let out = Vector::new(q[0] - 2000.0, q[1], q[2] + 220.0 - 300.0);
    assert!((out.norm() - 320.0).abs() < 1e-9 && (out.z - 320.0 * lean.sin()).abs() < 1e-9, "{q:?}");
    // A nutating head reaches the horizontal at half a turn.
    let n = machine(NUTATING);
    assert!((n.rotary_of(0.0, 1e-6)[4] - PI).abs() < 3e-3);
    assert!((n.rotary_of(0.0, FRAC_PI_2 - 1e-3)[4]).abs() < 3e-3);
}

#[test]
fn what_a_chain_cannot_do_is_said() {
    for (m, lean, says) in [
        (machine(NUTATING), -0.1, "do not reach"),
        (machine(FOUR), 0.1, "always leans by 0.000000 deg"),
        (machine(&FOUR.replace("[mount]", "[mount]\nalong = [0.0, 1.0, 1.0]")), 0.0, "not along the blade axis"),
        (lying(), 1e-4, "singular"),
        (
            machine(&TRUNNION.replace("min_deg = -120.0\nmax_deg = 30.0", "min_deg = -60.0\nmax_deg = 60.0")),
            0.1,
            "leave its travel by 24.270 deg",
        ),
    ] {
        let e = m.check_lean(lean).unwrap_err();
        assert_eq!(e.kind, ErrorKind::Infeasible);
        assert!(e.message.contains(says), "{}", e.message);
        assert!(!m.leans(lean));
    }
    assert!(Machine::demo().unwrap().leans(1.5) && !Machine::demo().unwrap().leans(1.53));
    let m = machine(TRUNNION);
    assert_eq!(m.rotary_of_axis(&Vector::zeros(), &Axes::of_default(5)), None);
    assert_eq!(m.rotary_of_axis(&Vector::x(), &Axes::of_default(5)), None, "the blade's x is along C");
}

#[test]
fn the_other_branch_is_taken_where_travel_asks_for_it() {
    let other = machine(&TRUNNION.replace("min_deg = -120.0\nmax_deg = 30.0", "min_deg = -30.0\nmax_deg = 120.0"));
    for (m, sign) in [(machine(TRUNNION), -1.0), (other, 1.0)] {
        let a = m.rotary_of(1.0, 0.1)[4];
        assert!((a - sign * (FRAC_PI_2 - 0.1)).abs() < 1e-12, "{a}");
    }
    // Ends of travel of the axis that turns the blade are ends of θ.
    let short = machine(&FORK.replace("[axes.c]", "[axes.c]\nmin_deg = -360.0\nmax_deg = 360.0"));
    let [lo, hi] = short.theta_limits(0.1).unwrap();
    assert!((hi - lo - 2.0 * TAU).abs() < 1e-12);
    assert!((short.rotary_of(hi, 0.1)[3].abs() - TAU).abs() < 1e-12);
    assert_eq!(machine(FORK).theta_limits(0.1), None);
}

#[test]
fn bad_chains_are_usage_errors_that_say_what() {
    for (from, to, says) in [
        ("\"Y\", ", "", "axis Y must be in the chain and have"),
        ("\"Y\", \"Z\"", "\"Y\", \"Y\"", "axis Y twice"),
        ("[\"C\"", "[\"B\"", "axis A"),
        ("[axes.c]", "[axes.b]", "axis B must be in the chain"),
        ("along = [0.0, 0.0, 1.0]", "along = [0.0, 0.0, 0.0]", "no direction"),
        ("along = [0.0, 0.0, 1.0]", "along = [nan, 0.0, 1.0]", "mount.along"),
        ("[axes.z]\n", "[axes.z]\ndirection = [1.0, 1.0, 0.0]\n", "lie in a plane"),
        ("min_deg = -120.0\n", "", "only one of"),
        ("[mount]", "[spindle]\ndirection = [0.0, 0.0, 0.0]\n[mount]", "no direction"),
        ("[mount]", "[head]\npivot_length_mm = 1.0\n[mount]", "both a chain"),
    ] {
        let text = TRUNNION.replacen(from, to, 1);
        assert_ne!(text, TRUNNION, "{from}");
        let e = Machine::from_toml(&text, "m.toml").unwrap_err();
        assert_eq!(e.kind, ErrorKind::Usage);
        assert!(e.message.contains(says) || from == "[\"C\"", "{says}: {}", e.message);
    }
    let demo = super::DEMO_TOML;
    for (from, to, says) in [
        ("clamping_deg = 0.0", "along = [0.0, 0.0, 1.0]", "for machines with a chain"),
        ("[head]", "[axes.c]", "pivot_length_mm"),
    ] {
        let e = Machine::from_toml(&demo.replacen(from, to, 1), "m.toml").unwrap_err();
        assert!(e.message.contains(says), "{}", e.message);
    }
}

#[test]
fn axes_are_named_and_say_what_they_carry() {
    let said = |m: &Machine| {
        let carries = |a: &Axis| if a.carries == Carries::Workpiece { "workpiece" } else { "tool" };
        m.axes().iter().map(|a| format!("{} {}", a.name, carries(a))).collect::<Vec<_>>().join(", ")
    };
    assert_eq!(said(&machine(FOUR)), "X tool, Y tool, Z tool, A workpiece");
    assert_eq!(said(&machine(TRUNNION)), "X tool, Y tool, Z tool, C workpiece, A workpiece");
    assert_eq!(said(&machine(FORK)), "X tool, Y tool, Z tool, C tool, A tool");
    assert_eq!(said(&Machine::demo().unwrap()), "X tool, Y tool, Z tool, A workpiece, B tool");
}

/// With a wheel on it the rotary axis nearest to the workpiece turns the tool about the rotor axis
/// alone, on every machine with two rotary axes, and the file says the same place again.
#[test]
fn a_rotor_sits_on_the_first_rotary_axis() {
    for (name, m, _) in all() {
        let (axis, origin) = (Vector::new(0.2, -0.7, 1.1), Point::new(12.0, 5.0, -180.0));
        let wheel = m.clone().with_rotor(&axis, &origin);
        let row = Axes::from_fn(m.axes().len(), |k| 0.1 + 0.2 * k as f64);
        let (k, turn) = (wheel.turning_axis(), 0.7);
        let mut turned = row;
        turned[k] += turn;
        let about = nalgebra::Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(axis), turn);
        let [p, q] = [row, turned].map(|r| wheel.forward(&r, 90.0));
        let off = (about * p.axis - q.axis).norm().min((about.inverse() * p.axis - q.axis).norm());
        assert!(off < 1e-9, "{name}: {off}");
        // Seen from the machine the tool stands still while a table turns, and the part while a
        // head does.
        let [from, to] = [(&row, &p), (&turned, &q)].map(|(at, pose)| {
            let part = wheel.part_at(at);
            if wheel.axes()[k].carries == Carries::Workpiece { part * pose.centre } else { part * origin }
        });
        assert!((from - to).norm() < 1e-8, "{name}: {from} {to}");
        // Points of the rotor axis stay on the axis of the machine.
        assert!(wheel.head().off_axis_mm(&origin) < 1e-9, "{name}");
        assert!(wheel.head().off_axis_mm(&(origin + axis * 77.0)) < 1e-9, "{name}");
        let back = wheel.inverse(&p.centre, 0.3, 0.1, 90.0);
        if back.iter().all(|v| v.is_finite()) {
            assert!((wheel.forward(&back, 90.0).centre - p.centre).norm() < 1e-8, "{name}");
        }
        assert!(wheel.mount.along.is_some_and(|a| (Vector::from(a).norm() - 1.0).abs() < 1e-12), "{name}");
        let again = wheel.clone().with_rotor(&axis, &origin);
        let [a, b] = [&wheel, &again].map(|m| m.forward(&row, 90.0));
        assert!((a.centre - b.centre).norm() < 1e-8 && (a.axis - b.axis).norm() < 1e-10, "{name}");
    }
}

/// Where a wheel is clamped is a mount of the machine's file: read again it is the same place.
#[test]
fn the_mount_of_a_wheel_is_one_of_the_file() {
    let wheel = machine(TRUNNION).with_rotor(&Vector::new(1.0, 0.1, 0.0), &Point::new(3.0, 0.0, -200.0));
    let mount = wheel.mount;
    let list = |v: [f64; 3]| format!("[{:?}, {:?}, {:?}]", v[0], v[1], v[2]);
    let text = TRUNNION
        .replace("offset_mm = [0.0, 0.0, 60.0]", &format!("offset_mm = {}", list(mount.offset_mm)))
        .replace("along = [0.0, 0.0, 1.0]", &format!("along = {}", list(mount.along.unwrap())))
        .replace("[axes.x]", &format!("clamping_deg = {:?}\n\n[axes.x]", mount.clamping_deg));
    let read = machine(&text);
    let row = Axes::from([10.0, -20.0, 30.0, 0.4, -0.3]);
    let [a, b] = [&wheel, &read].map(|m| m.forward(&row, 90.0));
    assert!((a.centre - b.centre).norm() < 1e-9 && (a.axis - b.axis).norm() < 1e-12);
}
