//! Forward and inverse kinematics; equations on the module's page.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::UnitQuaternion;

use super::{Machine, PositiveA, PositiveB};
use crate::geometry::{Point, Rigid, Vector};

/// Where the tool is, in the blade frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Ball centre, mm.
    pub centre: Point,
    /// Tool axis, unit, from tip to spindle.
    pub axis: Vector,
}

impl Pose {
    /// The tool tip of a ball of that radius, mm.
    pub fn tip(&self, radius_mm: f64) -> Point {
        self.centre - self.axis * radius_mm
    }
}

impl Machine {
    /// `σ` of the module's page: the right-hand angle by which the workpiece turns per unit of `A`.
    fn sense(&self) -> f64 {
        match self.table.positive_a_turns {
            PositiveA::Tool => -1.0,
            PositiveA::Workpiece => 1.0,
        }
    }

    /// The part's place on the machine at table position `a_rad`.
    pub fn machine_from_part(&self, a_rad: f64) -> Rigid {
        let about_x = |angle: f64| UnitQuaternion::from_axis_angle(&Vector::x_axis(), angle);
        let clamped =
            Rigid::from_parts(Vector::from(self.mount.offset_mm).into(), about_x(self.mount.clamping_deg.to_radians()));
        let c = Vector::new(0.0, self.table.axis_y_mm, self.table.axis_z_mm);
        let turn = Rigid::from_parts(c.into(), about_x(self.sense() * a_rad)) * Rigid::translation(-c.x, -c.y, -c.z);
        turn * clamped
    }

    /// Table position that brings the tool axis angle `θ` (blade frame, unwrapped) under the spindle; unwrapped alike.
    pub fn a_of_theta(&self, theta_rad: f64) -> f64 {
        -self.sense() * (theta_rad + self.mount.clamping_deg.to_radians() - FRAC_PI_2)
    }

    /// Angle `θ` of the tool axis in the blade frame at table position `A`; unwrapped alike.
    pub fn theta_of_a(&self, a_rad: f64) -> f64 {
        -self.sense() * a_rad - self.mount.clamping_deg.to_radians() + FRAC_PI_2
    }

    /// Head position that leans the spindle by `lean_rad` towards +X.
    pub fn b_of_lean(&self, lean_rad: f64) -> f64 {
        match self.head.positive_b_leans {
            PositiveB::PlusX => lean_rad,
            PositiveB::MinusX => -lean_rad,
        }
    }

    /// Lean of the spindle towards +X, the angle `B` of plans, at head position `b_rad`.
    pub fn lean_of_b(&self, b_rad: f64) -> f64 {
        self.b_of_lean(b_rad)
    }

    /// The tool axis in the machine frame under a lean.
    fn axis_in_machine(lean_rad: f64) -> Vector {
        Vector::new(lean_rad.sin(), 0.0, lean_rad.cos())
    }

    /// From the ball centre to the point that X, Y, Z read, machine frame.
    fn reading_from_centre(&self, lean_rad: f64, gauge_length_mm: f64) -> Vector {
        let (pivot, offset) = (self.head.pivot_length_mm, self.head.spindle_offset_mm);
        let across = Vector::new(1.0 - lean_rad.cos(), 0.0, lean_rad.sin());
        Self::axis_in_machine(lean_rad) * (pivot + gauge_length_mm) - Vector::z() * pivot + across * offset
    }

    /// Axis positions (X, Y, Z in mm, A, B in rad) that put the ball centre at `centre` (blade frame) with the tool
    /// axis at `theta_rad` about the blade axis and leaning by `lean_rad` towards its tip. `gauge_length_mm`: from the ball centre to the
    /// spindle's gauge line.
    pub fn inverse(&self, centre: &Point, theta_rad: f64, lean_rad: f64, gauge_length_mm: f64) -> [f64; 5] {
        let a_rad = self.a_of_theta(theta_rad);
        let at = self.machine_from_part(a_rad) * centre;
        let p = at + self.reading_from_centre(lean_rad, gauge_length_mm);
        [p.x, p.y, p.z, a_rad, self.b_of_lean(lean_rad)]
    }

    /// The pose of the tool in the blade frame at axis positions `[X, Y, Z, A, B]` (mm, rad).
    pub fn forward(&self, axes: &[f64; 5], gauge_length_mm: f64) -> Pose {
        let [x, y, z, a_rad, b_rad] = *axes;
        let lean_rad = self.lean_of_b(b_rad);
        let axis = Self::axis_in_machine(lean_rad);
        let at = Point::new(x, y, z) - self.reading_from_centre(lean_rad, gauge_length_mm);
        let part_from_machine = self.machine_from_part(a_rad).inverse();
        Pose { centre: part_from_machine * at, axis: part_from_machine * axis }
    }

    /// `(A, B)` that align the spindle with a tool axis of the blade frame, `A` of the turn nearest to `near_a_rad`;
    /// `None` where the axis is along X (nothing to place) or is not a direction.
    pub fn rotary_of_axis(&self, axis: &Vector, near_a_rad: f64) -> Option<[f64; 2]> {
        let unit = axis.try_normalize(f64::MIN_POSITIVE)?;
        let across = unit.y.hypot(unit.z);
        if !(across > 1e-9 && near_a_rad.is_finite()) {
            return None;
        }
        let a = self.a_of_theta(unit.z.atan2(unit.y));
        Some([a + TAU * ((near_a_rad - a) / TAU).round(), self.b_of_lean(unit.x.atan2(across))])
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::Machine;
    use super::*;
    use crate::tool;
    use proptest::prelude::*;

    fn close(a: &[f64; 5], b: [f64; 5]) {
        for i in 0..5 {
            assert!((a[i] - b[i]).abs() < 1e-9, "{a:?} {b:?}");
        }
    }

    #[test]
    fn hand_worked_poses() {
        let mut m = Machine::demo().unwrap();
        // B = 0, θ = 90°: nothing to turn; the gauge point is straight over the ball centre.
        close(&m.inverse(&Point::new(10.0, 3.0, 20.0), FRAC_PI_2, 0.0, 100.0), [1410.0, 3.0, 120.0, 0.0, 0.0]);
        // θ = 180°: the tool comes from blade −y; A = +90° and blade −y goes up to machine +Z.
        close(
            &m.inverse(&Point::new(0.0, -20.0, 0.0), 2.0 * FRAC_PI_2, 0.0, 100.0),
            [1400.0, 0.0, 120.0, FRAC_PI_2, 0.0],
        );
        // The other sense of A: same machine position, opposite sign.
        m.table.positive_a_turns = PositiveA::Workpiece;
        close(
            &m.inverse(&Point::new(0.0, -20.0, 0.0), 2.0 * FRAC_PI_2, 0.0, 100.0),
            [1400.0, 0.0, 120.0, -FRAC_PI_2, 0.0],
        );
        // B = 30° leans towards +X: pivot at 300 mm along (½, 0, √3/2), less 200 mm down Z.
        let q = m.inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
        close(&q, [1400.0 + 150.0, 0.0, 300.0 * 0.75f64.sqrt() - 200.0, 0.0, 30f64.to_radians()]);
        // A spindle whose axis passes the pivot by 10 mm swings it through (cos 30°, −sin 30°); the other sense of B: the same place.
        m.head.spindle_offset_mm = 10.0;
        m.head.positive_b_leans = PositiveB::MinusX;
        let q = m.inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
        let moved = 10.0 * (1.0 - 0.75f64.sqrt());
        close(&q, [1400.0 + 150.0 + moved, 0.0, 300.0 * 0.75f64.sqrt() - 200.0 + 5.0, 0.0, -30f64.to_radians()]);
        (m.head.spindle_offset_mm, m.head.positive_b_leans) = (0.0, PositiveB::PlusX);
        // Clamped at 90°: blade z is machine −Y, blade y is machine +Z, so θ = 0 needs no turn.
        m.mount.clamping_deg = 90.0;
        close(&m.inverse(&Point::new(0.0, 7.0, 2.0), 0.0, 0.0, 100.0), [1400.0, -2.0, 107.0, 0.0, 0.0]);
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
        fn forward_undoes_inverse(
            c in prop::array::uniform3(-300.0..300.0f64), theta in -100.0..100.0f64, b in -1.5..1.5f64,
            gauge in 0.0..400.0f64, offset in prop::array::uniform3(-500.0..500.0f64), clamp in -360.0..360.0f64,
            axis_at in prop::array::uniform2(-100.0..100.0f64), iso in any::<bool>(), plus in any::<bool>(),
            passes in -50.0..50.0f64,
        ) {
            let mut m = Machine::demo().unwrap();
            m.mount.offset_mm = offset;
            m.mount.clamping_deg = clamp;
            [m.table.axis_y_mm, m.table.axis_z_mm] = axis_at;
            m.head.spindle_offset_mm = passes;
            m.head.positive_b_leans = if plus { PositiveB::PlusX } else { PositiveB::MinusX };
            m.table.positive_a_turns = if iso { PositiveA::Tool } else { PositiveA::Workpiece };
            let centre = Point::from(c);
            let q = m.inverse(&centre, theta, b, gauge);
            let pose = m.forward(&q, gauge);
            prop_assert!((pose.centre - centre).norm() < 1e-9);
            prop_assert!((pose.axis - tool::axis(b, theta)).norm() < 1e-11);
            prop_assert!((m.theta_of_a(q[3]) - theta).abs() < 1e-11);
            let [a, b2] = m.rotary_of_axis(&pose.axis, q[3] + 1.0).unwrap();
            prop_assert!((a - q[3]).abs() < 1e-9 && (b2 - q[4]).abs() < 1e-9);
            prop_assert!((m.lean_of_b(q[4]) - b).abs() < 1e-12);
            let tip = pose.tip(3.0);
            prop_assert!((tip - tool::tip(&centre, &tool::axis(b, theta), 3.0)).norm() < 1e-9);
        }
    }

    #[test]
    fn an_axis_along_x_places_nothing() {
        let m = Machine::demo().unwrap();
        assert_eq!(m.rotary_of_axis(&Vector::x(), 0.0), None);
        assert_eq!(m.rotary_of_axis(&Vector::zeros(), 0.0), None);
        assert_eq!(m.rotary_of_axis(&Vector::new(f64::NAN, 0.0, 1.0), 0.0), None);
    }
}
