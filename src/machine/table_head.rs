//! The table about X with a pivoting head in closed form: what the chain that is built from such a
//! file is held against.
#![allow(clippy::unwrap_used)]

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::UnitQuaternion;
use proptest::prelude::*;

use super::{DEMO_TOML, Machine, MachineFile, Pose, PositiveA, PositiveB};
use crate::artifact::Axes;
use crate::geometry::{Point, Rigid, Vector};
use crate::numerics::angle::within_half_turn;
use crate::tool;

/// The equations of the module's page.
struct TableHead {
    /// `σ`: the right-hand angle by which the workpiece turns per unit of `A`.
    sense: f64,
    /// Y and Z of the table's axis, mm.
    axis: [f64; 2],
    /// Sign of `B` against the lean.
    lean: f64,
    pivot_mm: f64,
    offset_mm: f64,
    mount_mm: [f64; 3],
    clamping: f64,
}

impl TableHead {
    fn of(file: &MachineFile) -> Self {
        let (table, head) = (file.table.unwrap(), file.head.unwrap());
        TableHead {
            sense: if table.positive_a_turns == PositiveA::Workpiece { 1.0 } else { -1.0 },
            axis: [table.axis_y_mm, table.axis_z_mm],
            lean: if head.positive_b_leans == PositiveB::MinusX { -1.0 } else { 1.0 },
            pivot_mm: head.pivot_length_mm,
            offset_mm: head.spindle_offset_mm,
            mount_mm: file.mount.offset_mm,
            clamping: file.mount.clamping_deg.to_radians(),
        }
    }

    fn inverse(&self, centre: &Point, theta: f64, lean: f64, gauge_length_mm: f64) -> [f64; 5] {
        let (a, b) = (self.a_of_theta(theta), self.lean * lean);
        let [x, y, z] = self.linear(centre, a, lean, gauge_length_mm);
        [x, y, z, a, b]
    }

    /// The part's place on the machine at table position `a_rad`.
    fn machine_from_part(&self, a_rad: f64) -> Rigid {
        let about_x = |angle: f64| UnitQuaternion::from_axis_angle(&Vector::x_axis(), angle);
        let clamped = Rigid::from_parts(Vector::from(self.mount_mm).into(), about_x(self.clamping));
        let c = Vector::new(0.0, self.axis[0], self.axis[1]);
        let turn = Rigid::from_parts(c.into(), about_x(self.sense * a_rad)) * Rigid::translation(-c.x, -c.y, -c.z);
        turn * clamped
    }

    fn a_of_theta(&self, theta_rad: f64) -> f64 {
        -self.sense * (theta_rad + self.clamping - FRAC_PI_2)
    }

    /// The tool axis in the machine frame under a lean.
    fn axis_in_machine(lean_rad: f64) -> Vector {
        Vector::new(lean_rad.sin(), 0.0, lean_rad.cos())
    }

    /// From the ball centre to the point that X, Y, Z read, machine frame.
    fn reading_from_centre(&self, lean_rad: f64, gauge_length_mm: f64) -> Vector {
        let (pivot, offset) = (self.pivot_mm, self.offset_mm);
        let across = Vector::new(1.0 - lean_rad.cos(), 0.0, lean_rad.sin());
        Self::axis_in_machine(lean_rad) * (pivot + gauge_length_mm) - Vector::z() * pivot + across * offset
    }

    fn linear(&self, centre: &Point, a_rad: f64, lean_rad: f64, gauge_length_mm: f64) -> [f64; 3] {
        let at = self.machine_from_part(a_rad) * centre;
        let p = at + self.reading_from_centre(lean_rad, gauge_length_mm);
        [p.x, p.y, p.z]
    }

    fn forward(&self, [x, y, z, a_rad, b_rad]: [f64; 5], gauge_length_mm: f64) -> Pose {
        let lean_rad = self.lean * b_rad;
        let axis = Self::axis_in_machine(lean_rad);
        let at = Point::new(x, y, z) - self.reading_from_centre(lean_rad, gauge_length_mm);
        let part_from_machine = self.machine_from_part(a_rad).inverse();
        Pose { centre: part_from_machine * at, axis: part_from_machine * axis }
    }
}

fn demo() -> MachineFile {
    MachineFile::from_toml(DEMO_TOML, "demo").unwrap()
}

fn built(file: &MachineFile) -> Machine {
    file.build("test").unwrap()
}

fn close(a: &[f64], b: [f64; 5]) {
    for i in 0..5 {
        assert!((a[i] - b[i]).abs() < 1e-9, "{a:?} {b:?}");
    }
}

#[test]
fn hand_worked_poses() {
    let mut m = demo();
    // B = 0, θ = 90°: nothing to turn; the gauge point is straight over the ball centre.
    close(&built(&m).inverse(&Point::new(10.0, 3.0, 20.0), FRAC_PI_2, 0.0, 100.0), [1410.0, 3.0, 120.0, 0.0, 0.0]);
    // θ = 180°: the tool comes from blade −y; A = +90° and blade −y goes up to machine +Z.
    close(
        &built(&m).inverse(&Point::new(0.0, -20.0, 0.0), 2.0 * FRAC_PI_2, 0.0, 100.0),
        [1400.0, 0.0, 120.0, FRAC_PI_2, 0.0],
    );
    // The other sense of A: same machine position, opposite sign.
    m.table.as_mut().unwrap().positive_a_turns = PositiveA::Workpiece;
    close(
        &built(&m).inverse(&Point::new(0.0, -20.0, 0.0), 2.0 * FRAC_PI_2, 0.0, 100.0),
        [1400.0, 0.0, 120.0, -FRAC_PI_2, 0.0],
    );
    // B = 30° leans towards +X: pivot at 300 mm along (½, 0, √3/2), less 200 mm down Z.
    let q = built(&m).inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
    close(&q, [1400.0 + 150.0, 0.0, 300.0 * 0.75f64.sqrt() - 200.0, 0.0, 30f64.to_radians()]);
    // A spindle whose axis passes the pivot by 10 mm swings it through (cos 30°, −sin 30°); the
    // other sense of B: the same place.
    m.head.as_mut().unwrap().spindle_offset_mm = 10.0;
    m.head.as_mut().unwrap().positive_b_leans = PositiveB::MinusX;
    let q = built(&m).inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
    let moved = 10.0 * (1.0 - 0.75f64.sqrt());
    close(&q, [1400.0 + 150.0 + moved, 0.0, 300.0 * 0.75f64.sqrt() - 200.0 + 5.0, 0.0, -30f64.to_radians()]);
    let head = m.head.as_mut().unwrap();
    (head.spindle_offset_mm, head.positive_b_leans) = (0.0, PositiveB::PlusX);
    // Clamped at 90°: blade z is machine −Y, blade y is machine +Z, so θ = 0 needs no turn.
    m.mount.clamping_deg = 90.0;
    close(&built(&m).inverse(&Point::new(0.0, 7.0, 2.0), 0.0, 0.0, 100.0), [1400.0, -2.0, 107.0, 0.0, 0.0]);
}

#[test]
fn a_follows_theta_over_many_turns() {
    let m = Machine::demo().unwrap();
    let a: Vec<f64> = (0..1000).map(|i| m.inverse(&Point::origin(), 0.1 * i as f64, 0.1, 50.0)[3]).collect();
    assert!(a.windows(2).all(|w| (w[1] - w[0] - 0.1).abs() < 1e-9));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn the_chain_stands_where_the_closed_form_says(
        c in prop::array::uniform3(-300.0..300.0f64), theta in -100.0..100.0f64, lean in -1.5..1.5f64,
        gauge in 0.0..400.0f64, offset in prop::array::uniform3(-500.0..500.0f64), clamp in -360.0..360.0f64,
        axis_at in prop::array::uniform2(-100.0..100.0f64), iso in any::<bool>(), plus in any::<bool>(),
        passes in -50.0..50.0f64,
    ) {
        let mut m = demo();
        m.mount.offset_mm = offset;
        m.mount.clamping_deg = clamp;
        let (table, head) = (m.table.as_mut().unwrap(), m.head.as_mut().unwrap());
        [table.axis_y_mm, table.axis_z_mm] = axis_at;
        table.positive_a_turns = if iso { PositiveA::Tool } else { PositiveA::Workpiece };
        head.spindle_offset_mm = passes;
        head.positive_b_leans = if plus { PositiveB::PlusX } else { PositiveB::MinusX };
        let (closed, m, centre) = (TableHead::of(&m), built(&m), Point::from(c));
        let (want, q) = (closed.inverse(&centre, theta, lean, gauge), m.inverse(&centre, theta, lean, gauge));
        for (k, off) in q.iter().zip(want).map(|(is, want)| is - want).enumerate() {
            // A may be counted from another turn where the blade is clamped turned.
            let off = if k == m.turning_axis() { within_half_turn(off) } else { off };
            prop_assert!(off.abs() < 1e-8, "{q:?} {want:?}");
        }
        for pose in [m.forward(&q, gauge), closed.forward(want, gauge)] {
            prop_assert!((pose.centre - centre).norm() < 1e-9);
            prop_assert!((pose.axis - tool::axis(lean, theta)).norm() < 1e-11);
        }
        let pose = m.forward(&q, gauge);
        let turns = (m.theta_and_lean(&q, 0.0)[0] - theta) / TAU;
        prop_assert!((turns - turns.round()).abs() < 1e-11);
        let again = m.rotary_of_axis(&pose.axis, &Axes::from([0.0, 0.0, 0.0, q[3] + 1.0, 0.0])).unwrap();
        prop_assert!((again[3] - q[3]).abs() < 1e-9 && (again[4] - q[4]).abs() < 1e-9);
        prop_assert!((m.theta_and_lean(&q, 0.0)[1] - lean).abs() < 1e-12);
        let tip = pose.tip(3.0);
        prop_assert!((tip - tool::tip(&centre, &tool::axis(lean, theta), 3.0)).norm() < 1e-9);
    }
}

#[test]
fn an_axis_along_x_places_nothing() {
    let m = Machine::demo().unwrap();
    assert_eq!(m.rotary_of_axis(&Vector::x(), &Axes::of_default(5)), None);
    assert_eq!(m.rotary_of_axis(&Vector::zeros(), &Axes::of_default(5)), None);
    assert_eq!(m.rotary_of_axis(&Vector::new(f64::NAN, 0.0, 1.0), &Axes::of_default(5)), None);
}
