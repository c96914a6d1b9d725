//! Everything that a program is made from, bundled for the checks.
use super::{AxisMotion, Channel, Schedule, Toolpath};

/// A complete plan, one row of each part per cutter location.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Plan {
    /// Cutter locations.
    pub toolpath: Toolpath,
    /// What the tool axis may do.
    pub channel: Channel,
    /// What it does.
    pub schedule: Schedule,
    /// What the machine's axes do.
    pub motion: AxisMotion,
}

impl Plan {
    /// What is left of the plan from the beginning of a turn on: the same locations, angles and motion, none before. Times and lengths stay
    /// as they are in the whole. `None` where there is no such turn.
    #[must_use]
    pub fn from_turn(&self, turn: usize) -> Option<Plan> {
        let row = self.toolpath.turns.get(turn)?.first;
        let mut left = self.clone();
        left.toolpath.turns.drain(..turn);
        left.toolpath.turns.iter_mut().for_each(|t| t.first -= row.min(t.first));
        let drop = |n: usize| row.min(n);
        left.toolpath.locations.drain(..drop(self.toolpath.locations.len()));
        left.channel.rows.drain(..drop(self.channel.rows.len()));
        left.channel.narrowest_row = self.channel.narrowest_row.saturating_sub(row);
        left.schedule.theta.drain(..drop(self.schedule.theta.len()));
        let m = &mut left.motion;
        let (n, times) = (drop(m.position.len()), drop(m.t_s.len()));
        m.t_s.drain(..times);
        m.feed.drain(..row.min(m.feed.len()));
        for rows in [&mut m.position, &mut m.velocity, &mut m.acceleration, &mut m.jerk] {
            rows.drain(..n.min(rows.len()));
        }
        m.time_s = m.t_s.last().unwrap_or(&0.0) - m.t_s.first().unwrap_or(&0.0);
        Some(left)
    }
}
