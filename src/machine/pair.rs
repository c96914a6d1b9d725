//! Two heads at work on one workpiece: both share the axis that turns it.
//!
//! The second head's tool stands at its own ball centre with its own lean. Its angle about the
//! blade axis is that of the first and a constant of the machine, since one axis turns the
//! workpiece for both.

use super::Machine;
use super::chain::Pose;
use crate::artifact::Axes;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::numerics::angle::within_half_turn;

impl Machine {
    /// Whether it has two heads.
    pub fn has_two_heads(&self) -> bool {
        self.heads.len() > 1
    }

    /// The angle by which the tool of the second head stands on from that of the first about the
    /// blade axis, rad, within half a turn; `leans`: those of both, rad. `None` where the machine
    /// has one head, or the axis that both share is not along the blade axis.
    ///
    /// # Errors
    /// Those of [`Machine::check_lean`], of either head.
    pub fn between_heads(&self, leans: [f64; 2]) -> Result<Option<f64>> {
        let [first, second] = &self.heads[..] else { return Ok(None) };
        first.check_lean(leans[0], self.axes())?;
        second.check_lean(leans[1], self.axes())?;
        let Some(sense) = first.along_blade() else { return Ok(None) };
        let turning = self.turning_axis();
        let at = |head: usize| {
            let mut row = Axes::of_default(self.axes().len());
            self.heads[head].place_rotary(0.0, leans[head], &mut row);
            row[turning]
        };
        Ok(Some(within_half_turn(sense * (at(0) - at(1)))))
    }

    /// Axis positions (mm, rad) of both tools: ball centres of the blade frame, the angle `θ` of
    /// the first, both leans, and the lengths from ball centre to gauge line. Not numbers where an
    /// axis does not reach its place.
    ///
    /// # Errors
    /// As [`Machine::between_heads`]; kind `Usage` where that has no angle.
    pub fn place_both(
        &self,
        centres: [Point; 2],
        theta_rad: f64,
        leans: [f64; 2],
        gauge_lengths_mm: [f64; 2],
    ) -> Result<Axes> {
        let between = self.between_heads(leans)?.ok_or_else(|| {
            let message = format!("the machine {} has no two heads that share an axis along the blade", self.name);
            Error::usage(Stage::Machine, message)
        })?;
        let mut row = Axes::of_default(self.axes().len());
        self.heads[0].place(&centres[0], theta_rad, leans[0], gauge_lengths_mm[0], &mut row);
        let turned = row[self.turning_axis()];
        self.heads[1].place(&centres[1], theta_rad + between, leans[1], gauge_lengths_mm[1], &mut row);
        // The same but for whole turns: the first head's counts.
        row[self.turning_axis()] = turned;
        Ok(row)
    }

    /// The pose of a head's tool in the blade frame at axis positions; `None`: there is no such
    /// head.
    pub fn forward_of(&self, head: usize, at: &[f64], gauge_length_mm: f64) -> Option<Pose> {
        self.heads.get(head).map(|h| h.forward(at, gauge_length_mm))
    }

    /// Column of a head's linear axis that leads its tool away from the part, as
    /// [`Machine::retract_axis`] has it for the first, and its sense.
    pub fn retract_axis_of(&self, head: usize) -> Option<(usize, f64)> {
        let h = self.heads.get(head)?;
        let along = |k: &usize| self.axes[*k].direction.dot(h.tool());
        let there = h.linear().into_iter().filter(|k| !self.axes[*k].is_missing);
        // Of equals the last: Z.
        let k = there.max_by(|a, b| along(a).abs().total_cmp(&along(b).abs()))?;
        Some((k, if along(&k) < 0.0 { -1.0 } else { 1.0 }))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use std::f64::consts::PI;

    use super::*;
    use crate::artifact::Cone;

    const PINCH: &str = include_str!("../../models/machines/pinch_9x.toml");

    #[test]
    fn both_tools_come_where_they_are_sent() {
        let m = Machine::from_toml(PINCH, "m.toml").unwrap();
        let names: Vec<&str> = m.axes().iter().map(|a| a.name.as_str()).collect();
        assert_eq!(names, ["X", "Y", "Z", "A", "B", "U", "V", "W", "C"]);
        assert!(m.has_two_heads() && !Machine::demo().unwrap().has_two_heads());
        let leans = [0.1, -0.05];
        let between = m.between_heads(leans).unwrap().unwrap();
        assert!((between.abs() - PI).abs() < 1e-9, "{between}");
        for k in 0..40 {
            let theta = 0.4 * f64::from(k) - 5.0;
            let centres = [Point::new(30.0, 12.0, -4.0), Point::new(31.0, -9.0, 7.0)];
            let row = m.place_both(centres, theta, leans, [140.0, 155.0]).unwrap();
            for (head, gauge) in [(0, 140.0), (1, 155.0)] {
                let pose = m.forward_of(head, &row, gauge).unwrap();
                let axis = Cone::about_blade(leans[head]).tool_axis(theta + if head == 0 { 0.0 } else { between });
                assert!((pose.centre - centres[head]).norm() < 1e-9 && (pose.axis - axis).norm() < 1e-9, "{head} {k}");
            }
            // The first head's positions are those of a machine without the second.
            let alone = m.inverse(&centres[0], theta, leans[0], 140.0);
            assert!((0..5).all(|k| (alone[k] - row[k]).abs() < 1e-9));
        }
        assert_eq!(m.retract_axis_of(0).unwrap(), m.retract_axis());
        assert_eq!(m.retract_axis_of(1).unwrap(), (7, -1.0));
        assert!(
            m.between_heads([0.1, 1.55]).is_err() && Machine::demo().unwrap().between_heads(leans).unwrap().is_none()
        );
    }

    #[test]
    fn chains_that_are_no_second_head_are_refused() {
        for (from, to, says) in [
            ("chain = [\"A\", \"U\"", "chain = [\"U\"", "must begin as the chain does"),
            ("\"W\", \"C\"]", "\"W\"]", "axis C must be in the chain"),
            ("\"V\", \"W\"", "\"V\"", "axis W must be in the chain"),
            ("\"V\", \"W\"", "\"V\", \"V\", \"W\"", "U, V, W and at most one"),
            ("\"Z\", \"B\"]", "\"Z\", \"U\", \"B\"]", "axes of the second head"),
            ("direction = [0.0, 0.0, -1.0]", "direction = [0.0, 0.0, 0.0]", "no direction"),
        ] {
            assert!(PINCH.contains(from), "{from}");
            let e = Machine::from_toml(&PINCH.replacen(from, to, 1), "m.toml").unwrap_err();
            assert!(e.message.contains(says), "{from}: {}", e.message);
        }
    }
}
