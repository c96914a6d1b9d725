//! Everything that a program is made from, bundled for the checks.
use super::{AxisMotion, Channel, Cone, Lead, ProgrammedCurve, Schedule, Stand, Toolpath};
use crate::error::LeadReason;
use crate::geometry::{Point, Rigid};

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
    /// How ball centre and θ go between cutter locations; `None`: straight and evenly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curve: Option<ProgrammedCurve>,
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
    /// Where the tool stands.
    pub stand: Stand,
    /// Time, s.
    pub t_s: f64,
    /// What it belongs to.
    pub stretch: Stretch,
}

impl Lead {
    /// Its rows; the tool keeps the cone of the location that it leads to, or from.
    fn rows(&self, cone: Cone, stretch: Stretch) -> impl Iterator<Item = Row> + '_ {
        let rows = self.stands(cone).zip(&self.motion.t_s);
        rows.map(move |(stand, t_s)| Row { stand, t_s: *t_s, stretch })
    }

    /// Where the tool stands on it, with the cone of the location that it leads to, or from.
    pub fn stands(&self, cone: Cone) -> impl Iterator<Item = Stand> + '_ {
        self.centres.iter().zip(&self.theta).map(move |(centre, theta)| Stand { centre: *centre, cone, theta: *theta })
    }
}

impl Plan {
    /// Everything that is moved at the feed of the plan, in order of time: the lead-in, all
    /// locations, the lead-out. Ends with the shortest list of each where their lengths differ.
    pub fn rows(&self) -> impl Iterator<Item = Row> + '_ {
        let [before, after] = &self.leads;
        let last = self.toolpath.locations.len().saturating_sub(1);
        let [cone_in, cone_out] = [0, last].map(|k| self.toolpath.cone(k));
        let path = self.toolpath.locations.iter().zip(&self.motion.t_s).enumerate();
        let path = path.zip(&self.schedule.theta).map(|((k, (l, t_s)), theta)| Row {
            stand: Stand { centre: l.centre, cone: self.toolpath.cone(k), theta: *theta },
            t_s: *t_s,
            stretch: Stretch::Turn(l.turn),
        });
        before.rows(cone_in, Stretch::LeadIn).chain(path).chain(after.rows(cone_out, Stretch::LeadOut))
    }

    /// The places whose speed is the feed, row by row as [`Plan::rows`]: the ball's centre; of a
    /// cutter with a corner, the centre of that, over the contact.
    pub fn feed_points(&self) -> Vec<Point> {
        let mut out: Vec<Point> = self.rows().map(|r| r.stand.centre).collect();
        if self.toolpath.disc_radius_mm > 0.0 {
            let corners = self.toolpath.of_corner().locations;
            let first = self.leads[0].centres.len();
            // On a lead it goes as the disc does.
            let aside = |k: usize| Some(corners.get(k)?.centre - self.toolpath.locations.get(k)?.centre);
            let last = corners.len().saturating_sub(1);
            for (row, point) in out.iter_mut().enumerate() {
                *point += aside(row.saturating_sub(first).min(last)).unwrap_or_default();
            }
        }
        out
    }

    /// Where the tool stands at a location; `None` where there is none.
    pub fn stand(&self, location: usize) -> Option<Stand> {
        let (at, theta) = (self.toolpath.locations.get(location)?, *self.schedule.theta.get(location)?);
        Some(Stand { centre: at.centre, cone: self.toolpath.cone(location), theta })
    }

    /// Least and greatest lean of the tool towards the tip along the path, rad: over the plane
    /// square to the blade axis.
    pub fn leans_rad(&self) -> [f64; 2] {
        match self.toolpath.cones.same() {
            Some(cone) if cone.is_about_blade() => [cone.lean_rad; 2],
            _ => {
                let leans = self.stands().into_iter().map(|s| s.axis().x.clamp(-1.0, 1.0).asin());
                leans.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], lean| [least.min(lean), most.max(lean)])
            }
        }
    }

    /// Where the tool stands at all locations.
    pub fn stands(&self) -> Vec<Stand> {
        (0..self.toolpath.locations.len()).filter_map(|k| self.stand(k)).collect()
    }

    /// Positions of the axes, row by row as [`Plan::rows`].
    pub fn axes(&self) -> impl Iterator<Item = &[f64]> {
        let [before, after] = &self.leads;
        before.motion.position.iter().chain(&self.motion.position).chain(&after.motion.position)
    }

    /// The plan of an equal blade that a turn of the wheel brings this one to: ball centres,
    /// contacts and tool axes turned, an axis of the machine farther by `by_rad`. What the channel
    /// names stays on this blade; a curve is left out.
    #[must_use]
    pub fn turned(&self, turn: &Rigid, column: usize, by_rad: f64) -> Plan {
        let mut out = Plan { curve: None, ..self.clone() };
        out.toolpath.cones = self.toolpath.cones.turned(&turn.rotation);
        for l in &mut out.toolpath.locations {
            (l.centre, l.contact, l.normal) = (turn * l.centre, turn * l.contact, turn * l.normal);
        }
        out.leads.iter_mut().flat_map(|lead| &mut lead.centres).for_each(|centre| *centre = turn * *centre);
        let leads = out.leads.iter_mut().map(|lead| &mut lead.motion);
        for positions in leads.chain([&mut out.motion]).map(|motion| &mut motion.position) {
            (0..positions.len()).for_each(|row| positions[row][column] += by_rad);
        }
        out
    }

    /// What is left of the plan from the beginning of a turn on: the same locations, angles and
    /// motion, none before. Times and lengths stay as they are in the whole. `None` where there is
    /// no such turn.
    #[must_use]
    pub fn from_turn(&self, turn: usize) -> Option<Plan> {
        let row = self.toolpath.turns.get(turn)?.first;
        let mut left = self.clone();
        if turn > 0 {
            left.leads[0] = Lead::straight(LeadReason::WithinPath);
        }
        left.toolpath.cones = self.toolpath.cones.part(row, self.toolpath.locations.len());
        left.toolpath.turns.drain(..turn);
        left.toolpath.turns.iter_mut().for_each(|t| t.first -= row.min(t.first));
        let drop = |n: usize| row.min(n);
        left.toolpath.locations.drain(..drop(self.toolpath.locations.len()));
        left.channel.rows.drain(..drop(self.channel.rows.len()));
        left.channel.narrowest_row = self.channel.narrowest_row.saturating_sub(row);
        left.schedule.theta.drain(..drop(self.schedule.theta.len()));
        if let Some(curve) = &mut left.curve {
            curve.rows.drain(..drop(curve.rows.len()));
        }
        let m = &mut left.motion;
        let (n, times) = (drop(m.position.len()), drop(m.t_s.len()));
        m.t_s.drain(..times);
        m.feed.drain(..row.min(m.feed.len()));
        for rows in [&mut m.position, &mut m.velocity, &mut m.acceleration, &mut m.jerk] {
            *rows = rows.part(n.min(rows.len())..rows.len());
        }
        m.time_s = m.t_s.last().unwrap_or(&0.0) - m.t_s.first().unwrap_or(&0.0);
        Some(left)
    }
}
