//! The machine: its axes and heads.

use super::axis::{Axis, AxisLimits, Provenance};
use super::chain::Head;
use super::config::Mount;
use crate::geometry::{Point, Rigid, Vector};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

/// A machine: a list of axes, and one head or more that share those which carry the workpiece. It
/// is built from a [`MachineFile`](super::MachineFile), and has the numbers of its kinematics
/// ready.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// Short name, for headers.
    pub name: String,
    /// Greatest diameter that turns freely about the table's axis, mm.
    pub swing_diameter_mm: f64,
    /// How the blade sits on it.
    pub mount: Mount,
    pub(super) axes: Vec<Axis>,
    /// At least one.
    pub(super) heads: Vec<Head>,
}

impl Machine {
    /// All axes, in the order of the columns of [`crate::artifact::AxisMotion`]: X, Y, Z of the
    /// first head, its rotary axes from the workpiece, then the own axes of other heads.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// All heads.
    pub fn heads(&self) -> &[Head] {
        &self.heads
    }

    /// Columns of the first head's rotary axes, that nearest to the workpiece first.
    pub fn rotary(&self) -> impl Iterator<Item = usize> + Clone + use<> {
        self.heads[0].rotary()
    }

    /// Column of the rotary axis nearest to the workpiece: the one that turns the blade, or the
    /// tool round it.
    pub fn turning_axis(&self) -> usize {
        self.heads[0].turning_axis()
    }

    /// Column of the other rotary axis of the first head: the one that leans the tool.
    pub fn leaning_axis(&self) -> Option<usize> {
        self.rotary().nth(1)
    }

    /// Columns of the first head's X, Y and Z.
    pub fn linear(&self) -> [usize; 3] {
        self.heads[0].linear()
    }

    /// Column of the linear axis that leads the tool away from the part: the one nearest to the
    /// tool axis while all axes read 0; and its sense, 1 or -1.
    pub fn retract_axis(&self) -> (usize, f64) {
        self.retract_axis_of(0).unwrap_or((self.linear()[2], 1.0))
    }

    /// The linear axis that the machine has not, as Y of many lathes.
    pub fn missing(&self) -> Option<&Axis> {
        self.axes.iter().find(|a| a.is_missing)
    }

    /// Names of the axes whose velocity, acceleration and jerk are assumed, not measured.
    pub fn assumed_limits(&self) -> Vec<&str> {
        let assumed = self.axes.iter().filter(|a| a.limits.provenance == Provenance::Assumed && !a.is_missing);
        assumed.map(|a| a.name.as_str()).collect()
    }

    /// The same machine with velocity, acceleration and jerk of all axes multiplied by `factor`
    /// (for sweeps over assumed limits).
    #[must_use]
    pub fn with_limits_scaled(self, factor: f64) -> Self {
        self.changed(|_, axis| {
            let l = &mut axis.limits;
            [&mut l.velocity, &mut l.acceleration, &mut l.jerk].into_iter().for_each(|v| *v *= factor);
        })
    }

    /// The same machine with other limits of an axis.
    #[must_use]
    pub fn with_limits(self, column: usize, limits: AxisLimits) -> Self {
        self.changed(|k, axis| {
            if k == column {
                axis.limits = limits;
            }
        })
    }

    /// The same machine with an axis that counts the other way.
    #[must_use]
    pub fn with_axis_reversed(self, column: usize) -> Self {
        self.changed(|k, axis| {
            if k == column {
                axis.direction = -axis.direction;
            }
        })
    }

    /// The same machine with the workpiece clamped otherwise: the rotor axis of a wheel along the
    /// rotary axis nearest to the workpiece. The rotor axis is a direction of the blade frame
    /// through a point of it (mm). While the rotary axis reads 0 the blade axis points towards the
    /// spindle as nearly as it can. Along the rotary axis the blade stays where it was.
    #[must_use]
    pub fn with_rotor(mut self, axis: &Vector, origin: &Point) -> Self {
        let turning = &self.axes[self.turning_axis()];
        let (u, point) = (turning.direction, turning.point);
        let square = |v: &Vector, to: &Vector| (v - to * v.dot(to)).try_normalize(1e-6);
        let any = |to: &Vector| {
            // Of the coordinate axes the one that is farthest from it.
            let k = (0..3).min_by(|a, b| to[*a].abs().total_cmp(&to[*b].abs())).unwrap_or(0);
            square(&Vector::ith(k, 1.0), to).unwrap_or_else(Vector::x)
        };
        let rotor = axis.normalize();
        let (radial, up) = (square(&Vector::x(), &rotor), square(self.heads[0].tool(), &u));
        let (radial, up) = (radial.unwrap_or_else(|| any(&rotor)), up.unwrap_or_else(|| any(&u)));
        let frame = |a: &Vector, b: &Vector| Matrix3::from_columns(&[*a, *b, a.cross(b)]);
        let turn = frame(&u, &up) * frame(&rotor, &radial).transpose();
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turn));
        let along_mm = (Point::from(self.mount.offset_mm) - point).dot(&u) + (turn * origin.coords).dot(&u);
        let at = point + u.into_inner() * along_mm;
        let placed = Rigid::from_parts((at - turn * *origin).into(), turn);
        self.mount = Mount::of(&placed);
        self.heads.iter_mut().for_each(|head| *head = head.with_mount(placed));
        self
    }

    fn changed(mut self, mut change: impl FnMut(usize, &mut Axis)) -> Self {
        self.axes.iter_mut().enumerate().for_each(|(k, axis)| change(k, axis));
        self.heads.iter_mut().for_each(|head| *head = head.with_axes(&self.axes));
        self
    }
}
