//! Everything that a program is made from, bundled for the checks.
use super::{Axes, AxisMotion, Channel, Lead, Schedule, Toolpath};
use crate::geometry::Point;

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
    /// How the tool comes onto the first location, and leaves the last.
    #[serde(default)]
    pub leads: [Lead; 2],
}

/// What a row of the whole motion belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stretch {
    /// The way onto the path.
    LeadIn,
    /// A turn, counted from 0 in the whole plan.
    Turn(u32),
    /// The way off it.
    LeadOut,
}

/// A row of the whole motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Ball centre, mm.
    pub centre: Point,
    /// Angle of the tool axis, rad.
    pub theta: f64,
    /// Time, s.
    pub t_s: f64,
    /// What it belongs to.
    pub stretch: Stretch,
}

/// How θ goes from a location to the next.
#[derive(Clone, Copy, Debug)]
pub struct Turning<'a> {
    schedule: &'a Schedule,
    s_mm: [f64; 2],
    theta: [f64; 2],
    on_curve: bool,
}

impl Turning<'_> {
    /// θ at a share of the way, rad: on the schedule's curve where that goes through the angles of both locations, else even in θ.
    pub fn at(&self, share: f64) -> f64 {
        let [[s, s1], [theta, theta1]] = [self.s_mm, self.theta];
        let curve = self.on_curve.then(|| self.schedule.curve_at(s + (s1 - s) * share)).flatten();
        curve.unwrap_or(theta + (theta1 - theta) * share)
    }

    /// The first joint of two pieces of the curve strictly between two shares of the way.
    pub fn joint_between(&self, from: f64, to: f64) -> Option<f64> {
        let [s, s1] = self.s_mm;
        let (low, high) = (s + (s1 - s) * from, s + (s1 - s) * to);
        let pieces = &self.schedule.pieces;
        let joint = pieces.get(pieces.partition_point(|p| p[3][0] <= low)).map(|p| p[3][0]);
        joint.filter(|j| self.on_curve && *j < high).map(|j| (j - s) / (s1 - s))
    }
}

impl Lead {
    fn rows(&self, stretch: Stretch) -> impl Iterator<Item = Row> + '_ {
        let rows = self.centres.iter().zip(&self.theta).zip(&self.motion.t_s);
        rows.map(move |((centre, theta), t_s)| Row { centre: *centre, theta: *theta, t_s: *t_s, stretch })
    }
}

impl Plan {
    /// Everything that is moved at the feed of the plan, in order of time: the lead-in, all locations, the lead-out. Ends with the shortest list
    /// of each where their lengths differ.
    pub fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        let [before, after] = &self.leads;
        let path = self.toolpath.locations.iter().zip(&self.schedule.theta).zip(&self.motion.t_s);
        let path = path.map(|((l, theta), t_s)| Row {
            centre: l.centre,
            theta: *theta,
            t_s: *t_s,
            stretch: Stretch::Turn(l.turn),
        });
        before.rows(Stretch::LeadIn).chain(path).chain(after.rows(Stretch::LeadOut))
    }

    /// How θ goes from a location to the next; `None` where there is no next.
    pub fn turning(&self, location: usize) -> Option<Turning<'_>> {
        let (schedule, rows) = (&self.schedule, [location, location + 1]);
        let s_mm = rows.map(|k| self.toolpath.locations.get(k).map_or(f64::NAN, |l| l.s_mm));
        let theta = rows.map(|k| schedule.theta.get(k).copied().unwrap_or(f64::NAN));
        if !s_mm.iter().chain(&theta).all(|v| v.is_finite()) {
            return None;
        }
        let on_curve = (0..2).all(|k| schedule.curve_meets(rows[k], s_mm[k]));
        Some(Turning { schedule, s_mm, theta, on_curve })
    }

    /// Positions of the axes, row by row as [`Plan::rows`].
    pub fn axes(&self) -> impl Iterator<Item = &Axes> {
        let [before, after] = &self.leads;
        before.motion.position.iter().chain(&self.motion.position).chain(&after.motion.position)
    }

    /// What is left of the plan from the beginning of a turn on: the same locations, angles and motion, none before. Times and lengths stay
    /// as they are in the whole. `None` where there is no such turn.
    #[must_use]
    pub fn from_turn(&self, turn: usize) -> Option<Plan> {
        let row = self.toolpath.turns.get(turn)?.first;
        let mut left = self.clone();
        if turn > 0 {
            left.leads[0] = Lead::straight("the program goes on within the path");
        }
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
