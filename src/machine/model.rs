//! The machine: its axes and heads.

use super::axis::{Axis, AxisLimits, Provenance};
use super::chain::Head;
use super::config::Mount;

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

    /// Columns of the first head's X, Y and Z.
    pub fn linear(&self) -> [usize; 3] {
        self.heads[0].linear()
    }

    /// Names of the axes whose velocity, acceleration and jerk are assumed, not measured.
    pub fn assumed_limits(&self) -> Vec<&str> {
        let assumed = self.axes.iter().filter(|a| a.limits.provenance == Provenance::Assumed);
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

    fn changed(mut self, mut change: impl FnMut(usize, &mut Axis)) -> Self {
        self.axes.iter_mut().enumerate().for_each(|(k, axis)| change(k, axis));
        self.heads.iter_mut().for_each(|head| *head = head.with_axes(&self.axes));
        self
    }
}
