//! Forward and inverse kinematics; equations on the module's page.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::UnitQuaternion;

use super::chain::Chain;
use super::{AxisName, Machine, PositiveA, PositiveB};
use crate::artifact::Axes;
use crate::error::Result;
use crate::geometry::{Point, Rigid, Vector};
use crate::tool;

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

/// A rotary table about X and a pivoting head, in the words of the module's page.
#[derive(Clone, Copy, Debug)]
pub(super) struct TableHead {
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
    /// Of a machine without a chain. A file that lacks the table or the head is refused when it is read; one that is made otherwise has both at 0.
    pub(super) fn of(machine: &Machine) -> Self {
        let (table, head) = (machine.table.as_ref(), machine.head.as_ref());
        TableHead {
            sense: match table.map(|t| t.positive_a_turns) {
                Some(PositiveA::Workpiece) => 1.0,
                _ => -1.0,
            },
            axis: table.map_or([0.0; 2], |t| [t.axis_y_mm, t.axis_z_mm]),
            lean: match head.map(|h| h.positive_b_leans) {
                Some(PositiveB::MinusX) => -1.0,
                _ => 1.0,
            },
            pivot_mm: head.map_or(0.0, |h| h.pivot_length_mm),
            offset_mm: head.map_or(0.0, |h| h.spindle_offset_mm),
            mount_mm: machine.mount.offset_mm,
            clamping: machine.mount.clamping_deg.to_radians(),
        }
    }

    /// Distance of a point of the part from the table's axis, mm.
    pub(super) fn off_axis_mm(&self, p: &Point) -> f64 {
        let at = self.machine_from_part(0.0) * p;
        (at.y - self.axis[0]).hypot(at.z - self.axis[1])
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

    fn theta_of_a(&self, a_rad: f64) -> f64 {
        -self.sense * a_rad - self.clamping + FRAC_PI_2
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

    fn forward(&self, axes: &[f64; 5], gauge_length_mm: f64) -> Pose {
        let [x, y, z, a_rad, b_rad] = *axes;
        let lean_rad = self.lean * b_rad;
        let axis = Self::axis_in_machine(lean_rad);
        let at = Point::new(x, y, z) - self.reading_from_centre(lean_rad, gauge_length_mm);
        let part_from_machine = self.machine_from_part(a_rad).inverse();
        Pose { centre: part_from_machine * at, axis: part_from_machine * axis }
    }

    fn rotary_of_axis(&self, axis: &Vector, near_a_rad: f64) -> Option<[f64; 2]> {
        let unit = axis.try_normalize(f64::MIN_POSITIVE)?;
        let across = unit.y.hypot(unit.z);
        if !(across > 1e-9 && near_a_rad.is_finite()) {
            return None;
        }
        let a = self.a_of_theta(unit.z.atan2(unit.y));
        Some([a + TAU * ((near_a_rad - a) / TAU).round(), self.lean * unit.x.atan2(across)])
    }
}

impl Machine {
    /// A row of positions from X, Y, Z and those of the rotary axes.
    fn row(&self, [x, y, z]: [f64; 3], [first, second]: [f64; 2]) -> Axes {
        Axes::from_fn(self.axes().len(), |k| [x, y, z, first, second][k])
    }

    fn rotary_in(&self, at: &Axes) -> [f64; 2] {
        [3, 4].map(|k| at.get(k).copied().unwrap_or(0.0))
    }

    /// Positions of the rotary axes for an angle `θ` of the tool axis (blade frame, over all turns) and a lean; over all turns alike; all others at 0.
    /// Not numbers where a machine does not reach the lean ([`Machine::check_lean`]).
    pub fn rotary_of(&self, theta_rad: f64, lean_rad: f64) -> Axes {
        let rotary = match Chain::of(self) {
            Some(chain) => chain.rotary(theta_rad, lean_rad),
            None => {
                let t = TableHead::of(self);
                [t.a_of_theta(theta_rad), t.lean * lean_rad]
            }
        };
        self.row([0.0; 3], rotary)
    }

    /// Angle `θ` and lean of the tool axis where the rotary axes stand. `θ` is over all turns where the first rotary axis is along the blade axis,
    /// else of the turn nearest to `near_rad`.
    pub fn theta_and_lean(&self, at: &Axes, near_rad: f64) -> [f64; 2] {
        let rotary = self.rotary_in(at);
        match Chain::of(self) {
            Some(chain) => chain.theta_and_lean(rotary, near_rad),
            None => {
                let t = TableHead::of(self);
                [t.theta_of_a(rotary[0]), t.lean * rotary[1]]
            }
        }
    }

    /// The tool axis where the rotary axes stand, blade frame.
    pub fn axis_at(&self, at: &Axes) -> Vector {
        let rotary = self.rotary_in(at);
        match Chain::of(self) {
            Some(chain) => chain.axis(rotary),
            None => {
                let t = TableHead::of(self);
                tool::axis(t.lean * rotary[1], t.theta_of_a(rotary[0]))
            }
        }
    }

    /// The same positions, but X, Y, Z those that bring the ball centre to a point of the blade frame, mm. `gauge_length_mm`: from the ball
    /// centre to the spindle's gauge line. Not numbers where the linear axes do not reach it.
    pub fn linear_at(&self, centre: &Point, at: &Axes, gauge_length_mm: f64) -> Axes {
        let rotary = self.rotary_in(at);
        let linear = match Chain::of(self) {
            Some(chain) => chain.linear(centre, rotary, gauge_length_mm),
            None => {
                let t = TableHead::of(self);
                t.linear(centre, rotary[0], t.lean * rotary[1], gauge_length_mm)
            }
        };
        self.row(linear, rotary)
    }

    /// Axis positions (mm, rad) of a ball centre of the blade frame with a tool axis at angle `θ` and a lean towards the blade's tip.
    /// `gauge_length_mm`: from the ball centre to the spindle's gauge line. Not numbers where the machine does not reach it.
    pub fn inverse(&self, centre: &Point, theta_rad: f64, lean_rad: f64, gauge_length_mm: f64) -> Axes {
        let (rotary, linear) = match Chain::of(self) {
            Some(chain) => {
                let rotary = chain.rotary(theta_rad, lean_rad);
                (rotary, chain.linear(centre, rotary, gauge_length_mm))
            }
            None => {
                let t = TableHead::of(self);
                let rotary = [t.a_of_theta(theta_rad), t.lean * lean_rad];
                (rotary, t.linear(centre, rotary[0], lean_rad, gauge_length_mm))
            }
        };
        self.row(linear, rotary)
    }

    /// The pose of the tool in the blade frame at axis positions (mm, rad).
    pub fn forward(&self, at: &Axes, gauge_length_mm: f64) -> Pose {
        let ([x, y, z], [a, b]) = ([0, 1, 2].map(|k| at[k]), self.rotary_in(at));
        match Chain::of(self) {
            Some(chain) => chain.forward(&[x, y, z, a, b], gauge_length_mm),
            None => TableHead::of(self).forward(&[x, y, z, a, b], gauge_length_mm),
        }
    }

    /// The same positions, but those of the rotary axes such that the spindle is along a tool axis of the blade frame, of all the nearest to `near`;
    /// `None` where the axis is along the first rotary axis (nothing to place), out of reach, or not a direction.
    pub fn rotary_of_axis(&self, axis: &Vector, near: &Axes) -> Option<Axes> {
        let rotary = self.rotary_in(near);
        let rotary = match Chain::of(self) {
            Some(chain) => chain.rotary_of_axis(axis, rotary)?,
            None => TableHead::of(self).rotary_of_axis(axis, rotary[0])?,
        };
        Some(self.row([0, 1, 2].map(|k| near[k]), rotary))
    }

    /// `θ` at the ends of travel of the rotary axis that turns the blade, the least first; `None` where it has no ends, or no axis turns it alone.
    pub fn theta_limits(&self, lean_rad: f64) -> Option<[f64; 2]> {
        match Chain::of(self) {
            Some(chain) => chain.theta_limits(lean_rad),
            None => {
                let t = TableHead::of(self);
                self.limits()[3].travel.map(|travel| {
                    let [a, b] = travel.map(|a| t.theta_of_a(a));
                    [a.min(b), a.max(b)]
                })
            }
        }
    }

    /// Whether the machine can keep a lean of the tool all round the blade, within the travel of the second rotary axis and away from singular places.
    ///
    /// # Errors
    /// Kind `Infeasible`, with what does not go; never on a machine without a chain, whose travel is a check of its own.
    pub fn check_lean(&self, lean_rad: f64) -> Result<()> {
        Chain::of(self).map_or(Ok(()), |chain| chain.check_lean(lean_rad, &self.axes()))
    }

    /// Whether the machine can lean the tool by that all round the blade: as [`Machine::check_lean`], and on a machine without a chain by the travel of `B`.
    pub fn leans(&self, lean_rad: f64) -> bool {
        if !self.chain.is_empty() {
            return self.check_lean(lean_rad).is_ok();
        }
        let b = TableHead::of(self).lean * lean_rad;
        self.limits()[4].travel.is_none_or(|[lo, hi]| (lo..=hi).contains(&b))
    }

    /// Whether the rotary axis nearest to the workpiece alone turns the tool round the blade, while the other one stands still.
    pub fn turns_the_blade(&self) -> bool {
        Chain::of(self).is_none_or(|chain| chain.along_blade().is_some())
    }

    /// Which rotary axes turn the part and not the tool: those with a linear axis between them and the tool.
    pub(super) fn table_axes(&self) -> [bool; 2] {
        if self.chain.is_empty() {
            return [true, false];
        }
        let carries = |name: AxisName| self.chain.iter().skip_while(|n| **n != name).any(|n| n.linear().is_some());
        self.rotary_names().map(|axis| axis.is_some_and(carries))
    }

    /// The frame that is fixed to the table where the blade frame is while the table reads 0, but while the axes stand at `at`: to the blade frame. Linear axes that carry
    /// the table are taken to stand at 0.
    pub fn blade_from_frame_fixed_at(&self, at: &Axes) -> Rigid {
        let rotary = self.rotary_in(at);
        let [first, second] = self.table_axes();
        let table = [if first { rotary[0] } else { 0.0 }, if second { rotary[1] } else { 0.0 }];
        match Chain::of(self) {
            Some(chain) => chain.blade_from_frame_fixed_at(table),
            None => {
                let t = TableHead::of(self);
                t.machine_from_part(table[0]).inverse() * t.machine_from_part(0.0)
            }
        }
    }

    /// The part's place under a tool that stands still, for showing it: on a machine without a chain its true place on the table, else turned
    /// about X so that the tool is over it.
    pub fn shown_part(&self, theta_rad: f64) -> Rigid {
        match Chain::of(self) {
            Some(_) => Rigid::rotation(Vector::x() * (FRAC_PI_2 - theta_rad)),
            None => {
                let t = TableHead::of(self);
                t.machine_from_part(t.a_of_theta(theta_rad))
            }
        }
    }

    /// Where [`Machine::shown_part`] stands while nothing has turned it, the Y and Z of the axis that it turns about, and the right-hand angle about
    /// it at `θ`.
    pub fn shown_table(&self) -> (Rigid, [f64; 2], impl Fn(f64) -> f64) {
        let (at_zero, axis, clamping) = match Chain::of(self) {
            Some(_) => (Rigid::identity(), [0.0; 2], 0.0),
            None => {
                let t = TableHead::of(self);
                (t.machine_from_part(0.0), t.axis, t.clamping)
            }
        };
        // The whole turn of the part brings θ to 90°.
        (at_zero, axis, move |theta: f64| FRAC_PI_2 - theta - clamping)
    }

    /// From the gauge line to the axis that leans the tool, mm, for showing it; 0 on a machine whose head has none.
    pub fn shown_pivot_mm(&self) -> f64 {
        self.head.as_ref().map_or(0.0, |h| h.pivot_length_mm)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::Machine;
    use super::*;
    use proptest::prelude::*;

    fn close(a: &[f64], b: [f64; 5]) {
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
        m.table.as_mut().unwrap().positive_a_turns = PositiveA::Workpiece;
        close(
            &m.inverse(&Point::new(0.0, -20.0, 0.0), 2.0 * FRAC_PI_2, 0.0, 100.0),
            [1400.0, 0.0, 120.0, -FRAC_PI_2, 0.0],
        );
        // B = 30° leans towards +X: pivot at 300 mm along (½, 0, √3/2), less 200 mm down Z.
        let q = m.inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
        close(&q, [1400.0 + 150.0, 0.0, 300.0 * 0.75f64.sqrt() - 200.0, 0.0, 30f64.to_radians()]);
        // A spindle whose axis passes the pivot by 10 mm swings it through (cos 30°, −sin 30°); the other sense of B: the same place.
        m.head.as_mut().unwrap().spindle_offset_mm = 10.0;
        m.head.as_mut().unwrap().positive_b_leans = PositiveB::MinusX;
        let q = m.inverse(&Point::origin(), FRAC_PI_2, 30f64.to_radians(), 100.0);
        let moved = 10.0 * (1.0 - 0.75f64.sqrt());
        close(&q, [1400.0 + 150.0 + moved, 0.0, 300.0 * 0.75f64.sqrt() - 200.0 + 5.0, 0.0, -30f64.to_radians()]);
        let head = m.head.as_mut().unwrap();
        (head.spindle_offset_mm, head.positive_b_leans) = (0.0, PositiveB::PlusX);
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
            { let t = m.table.as_mut().unwrap(); [t.axis_y_mm, t.axis_z_mm] = axis_at; }
            m.head.as_mut().unwrap().spindle_offset_mm = passes;
            m.head.as_mut().unwrap().positive_b_leans = if plus { PositiveB::PlusX } else { PositiveB::MinusX };
            m.table.as_mut().unwrap().positive_a_turns = if iso { PositiveA::Tool } else { PositiveA::Workpiece };
            let centre = Point::from(c);
            let q = m.inverse(&centre, theta, b, gauge);
            let pose = m.forward(&q, gauge);
            prop_assert!((pose.centre - centre).norm() < 1e-9);
            prop_assert!((pose.axis - tool::axis(b, theta)).norm() < 1e-11);
            prop_assert!((m.theta_and_lean(&q, 0.0)[0] - theta).abs() < 1e-11);
            let again = m.rotary_of_axis(&pose.axis, &Axes::from([0.0, 0.0, 0.0, q[3] + 1.0, 0.0])).unwrap();
            prop_assert!((again[3] - q[3]).abs() < 1e-9 && (again[4] - q[4]).abs() < 1e-9);
            prop_assert!((m.theta_and_lean(&q, 0.0)[1] - b).abs() < 1e-12);
            let tip = pose.tip(3.0);
            prop_assert!((tip - tool::tip(&centre, &tool::axis(b, theta), 3.0)).norm() < 1e-9);
        }
    }

    #[test]
    fn an_axis_along_x_places_nothing() {
        let m = Machine::demo().unwrap();
        assert_eq!(m.rotary_of_axis(&Vector::x(), &Axes::of_default(5)), None);
        assert_eq!(m.rotary_of_axis(&Vector::zeros(), &Axes::of_default(5)), None);
        assert_eq!(m.rotary_of_axis(&Vector::new(f64::NAN, 0.0, 1.0), &Axes::of_default(5)), None);
    }
}
