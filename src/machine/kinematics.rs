//! Forward and inverse kinematics of the machine's first head; equations on the pages of the module
//! and of `chain.rs`.

use std::f64::consts::FRAC_PI_2;

use super::Machine;
use super::axis::{Axis, Carries};
use super::chain::{Head, Pose};
use crate::artifact::Axes;
use crate::error::Result;
use crate::geometry::{Point, Rigid, Vector};

/// A turning axis nearer to the blade axis than this is on it, mm: rounding of the mount.
const ON_AXIS_MM: f64 = 1e-9;
/// A rotor within this angle, rad, and …
const ALONG: f64 = 1e-9;
/// … this distance of the turning axis, mm, is on it: rounding of the mount.
const ON_ROTOR_MM: f64 = 1e-6;

/// A plan is made for the first head; rows have a column for every axis of the machine, those of
/// other heads at 0.
impl Machine {
    pub(super) fn head(&self) -> &Head {
        &self.heads[0]
    }

    /// Positions of the rotary axes for an angle `θ` of the tool axis (blade frame, over all turns)
    /// and a lean; over all turns alike; all others at 0. Not numbers where the machine does not
    /// reach the lean ([`Machine::check_lean`]).
    pub fn rotary_of(&self, theta_rad: f64, lean_rad: f64) -> Axes {
        let mut row = Axes::of_default(self.axes().len());
        self.head().place_rotary(theta_rad, lean_rad, &mut row);
        row
    }

    /// Angle `θ` and lean of the tool axis where the rotary axes stand. `θ` is over all turns where
    /// the first rotary axis is along the blade axis, else of the turn nearest to `near_rad`.
    pub fn theta_and_lean(&self, at: &[f64], near_rad: f64) -> [f64; 2] {
        self.head().theta_and_lean(at, near_rad)
    }

    /// The tool axis where the rotary axes stand, blade frame.
    pub fn axis_at(&self, at: &[f64]) -> Vector {
        self.head().axis(at)
    }

    /// The same positions, but X, Y, Z those that bring the ball centre to a point of the blade
    /// frame, mm. `gauge_length_mm`: from the ball centre to the spindle's gauge line. Not numbers
    /// where the linear axes do not reach it.
    pub fn linear_at(&self, centre: &Point, at: &[f64], gauge_length_mm: f64) -> Axes {
        let mut row = Axes::from(at);
        self.head().place_linear(centre, gauge_length_mm, &mut row);
        row
    }

    /// Axis positions (mm, rad) of a ball centre of the blade frame with a tool axis at angle `θ`
    /// and a lean towards the blade's tip. `gauge_length_mm`: from the ball centre to the spindle's
    /// gauge line. Not numbers where the machine does not reach it.
    pub fn inverse(&self, centre: &Point, theta_rad: f64, lean_rad: f64, gauge_length_mm: f64) -> Axes {
        let mut row = Axes::of_default(self.axes().len());
        self.head().place(centre, theta_rad, lean_rad, gauge_length_mm, &mut row);
        row
    }

    /// The pose of the tool in the blade frame at axis positions (mm, rad).
    pub fn forward(&self, at: &[f64], gauge_length_mm: f64) -> Pose {
        self.head().forward(at, gauge_length_mm)
    }

    /// The same positions, but those of the rotary axes such that the spindle is along a tool axis
    /// of the blade frame, of all the nearest to `near`; `None` where the axis is along the first
    /// rotary axis (nothing to place), out of reach, or not a direction.
    pub fn rotary_of_axis(&self, axis: &Vector, near: &[f64]) -> Option<Axes> {
        self.head().rotary_of_axis(axis, near)
    }

    /// `θ` at the ends of travel of the rotary axis that turns the blade, the least first; `None`
    /// where it has no ends, or no axis turns it alone.
    pub fn theta_limits(&self, lean_rad: f64) -> Option<[f64; 2]> {
        self.head().theta_limits(lean_rad)
    }

    /// Whether the machine can keep a lean of the tool all round the blade, within the travel of
    /// the second rotary axis and away from singular places.
    ///
    /// # Errors
    /// Kind `Infeasible`, with what does not go.
    pub fn check_lean(&self, lean_rad: f64) -> Result<()> {
        self.head().check_lean(lean_rad, self.axes())
    }

    /// Whether the machine can lean the tool by that all round the blade: see
    /// [`Machine::check_lean`].
    pub fn leans(&self, lean_rad: f64) -> bool {
        self.check_lean(lean_rad).is_ok()
    }

    /// Whether the rotary axis nearest to the workpiece alone turns the tool round the blade, while
    /// the other one stands still.
    pub fn turns_the_blade(&self) -> bool {
        self.head().along_blade().is_some()
    }

    /// The frame that is fixed to the table where the blade frame is while the table reads 0, but
    /// while the axes stand at `at`: to the blade frame. Linear axes that carry the table are taken
    /// to stand at 0.
    pub fn blade_from_frame_fixed_at(&self, at: &[f64]) -> Rigid {
        let axes = self.axes();
        let table = Axes::from_fn(axes.len(), |k| if axes[k].carries == Carries::Workpiece { at[k] } else { 0.0 });
        self.head().blade_from_turned(&table)
    }

    /// The part's place on the machine while the axes stand at `at` (rad), blade frame to machine
    /// frame: turned by all rotary axes that carry it. Linear axes that carry it are taken to stand
    /// at 0.
    pub fn part_at(&self, at: &[f64]) -> Rigid {
        self.head().mount() * self.blade_from_frame_fixed_at(at).inverse()
    }

    /// Distance of a point of the blade, in the blade frame, from the axis of the table that turns
    /// it, mm; `None` on a machine on which the blade stands still.
    pub fn off_table_axis_mm(&self, p: &Point) -> Option<f64> {
        let turning = &self.axes()[self.turning_axis()];
        (turning.carries == Carries::Workpiece).then(|| self.head().off_axis_mm(p))
    }

    /// A point on the axis of the table that turns the part, and its direction, unit, blade frame;
    /// `None` on a machine on which the part stands still.
    pub fn turning_line(&self) -> Option<(Point, Vector)> {
        let turning = &self.axes()[self.turning_axis()];
        let (point, along) = self.head().first_axis_in_part();
        let on_blade_axis = self.turns_the_blade() && point.coords.norm() < ON_AXIS_MM;
        let line = if on_blade_axis { (Point::origin(), Vector::x() * along.x.signum()) } else { (point, along) };
        (turning.carries == Carries::Workpiece).then_some(line)
    }

    /// Whether the rotary axis nearest to the workpiece goes on (1) or back (-1) where the tool
    /// follows the part in a turn about an axis of the blade frame, by the right-hand rule; `None`
    /// where the part does not turn about that axis.
    pub fn sense_about(&self, axis: &Vector, through: &Point) -> Option<f64> {
        let (point, along) = self.turning_line()?;
        let (parallel, off_mm) = (along.cross(axis).norm() < ALONG, (through - point).cross(&along).norm());
        (parallel && off_mm < ON_ROTOR_MM).then(|| along.dot(axis).signum())
    }

    /// The part's place under a tool that stands still, for showing it: see
    /// [`Machine::shown_table`].
    pub fn shown_part(&self, theta_rad: f64) -> Rigid {
        let (at_zero, [y, z], turn) = self.shown_table();
        let about = Vector::new(0.0, y, z);
        let turned = Rigid::rotation(Vector::x() * turn(theta_rad));
        Rigid::from_parts(about.into(), turned.rotation) * Rigid::translation(0.0, -y, -z) * at_zero
    }

    /// Where [`Machine::shown_part`] stands while nothing has turned it, the Y and Z of the axis
    /// that it turns about, and the right-hand angle about it at `θ`. Its true place where a table
    /// turns the blade about X and the tool leans in the plane of X and Z; on other machines it is
    /// turned about X so that the tool is over it.
    pub fn shown_table(&self) -> (Rigid, [f64; 2], impl Fn(f64) -> f64 + use<>) {
        let (at_zero, axis, clamping) = match self.table_about_x() {
            Some(table) => (*self.head().mount(), [table.point.y, table.point.z], self.mount.clamping_deg.to_radians()),
            None => (Rigid::identity(), [0.0; 2], 0.0),
        };
        // The whole turn of the part brings θ to 90°.
        (at_zero, axis, move |theta: f64| FRAC_PI_2 - theta - clamping)
    }

    /// From the gauge line to the axis that leans the tool, mm, for showing it; 0 where the part is
    /// not shown in its true place, or none leans it.
    pub fn shown_pivot_mm(&self) -> f64 {
        let leaning = self.leaning_axis().filter(|_| self.table_about_x().is_some());
        leaning.map_or(0.0, |k| self.head().along_tool_mm(&self.axes()[k].point))
    }

    /// The table that turns the blade about X under a tool that stays in the plane of X and Z.
    fn table_about_x(&self) -> Option<&Axis> {
        let along = |v: &Vector, k: usize| v[k].abs() == v.norm();
        let turning = &self.axes()[self.turning_axis()];
        let in_plane = self.rotary().skip(1).all(|k| along(&self.axes()[k].direction, 1));
        let of_table = turning.carries == Carries::Workpiece && along(&turning.direction, 0);
        (of_table && in_plane && self.turns_the_blade() && self.head().tool().y == 0.0).then_some(turning)
    }
}
