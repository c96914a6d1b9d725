//! The ways onto the path and off it: is there room for the whole tool, do the axes keep their
//! limits there.
//!
//! A way consists of the straight line along the tool axis from far outside, the arc of the
//! [`Lead`] where there is one, and the location itself. It is looked at with the same measures as
//! the path: the swept ball ([`super::gouge`]), taper and shank, holder ([`super::clearance`]),
//! continuously. [`obstructed`] answers for one way before it is chosen; [`check`] gives evidence
//! for both.

use super::apart::{Apart, apart};
use super::clearance::{self, NearestApproach, Track};
use super::cuts::{self, EndWay};
use super::gouge;
use super::options::VerifyOptions;
use super::sweep::Sweep;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Cone, Lead, Obstacle, Plan, Stand};
use crate::error::InTheWay;
use crate::geometry::allowance::Allowed;
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::machine::{Axis, Machine};
use crate::tool::Tool;

/// At its outer end an arc must be this share of its height off the part, or the ball has not left
/// it.
const OFF: f64 = 0.25;
/// So far does the straight line begin beyond the part, mm.
const BEYOND_MM: f64 = 5.0;

/// What stands around a way, and what moves on it.
#[derive(Clone, Copy)]
pub struct Room<'a> {
    /// The part.
    pub blade: &'a Blade,
    /// Stock that stays on the part, mm.
    pub stock_mm: f64,
    /// Fixtures, and the stock as it comes.
    pub obstacles: &'a [Obstacle],
    /// The tool.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
    /// Limits and resolution.
    pub options: &'a VerifyOptions,
}

impl<'a> Room<'a> {
    fn apart(&self) -> Vec<Apart<'a>> {
        apart(self.blade, self.obstacles, self.tool, self.options)
    }
}

/// A way from the location outwards, whichever way it is run.
struct LeadWay {
    stands: Vec<Stand>,
}

impl LeadWay {
    fn new(lead: &Lead, foot: Stand, inwards: bool, room: &Room) -> Self {
        let mut stands: Vec<Stand> = lead.stands(foot.cone).collect();
        if inwards {
            stands.reverse();
        }
        stands.insert(0, foot);
        let outer = stands.last().copied().unwrap_or(foot);
        stands.push(outer.lifted(beyond(&room.blade.part, &outer.centre, &outer.axis(), room.tool.radius_mm)));
        LeadWay { stands }
    }

    /// How near the tool comes to what it is to keep `limit_mm` of.
    fn least(&self, a: &Apart, limit_mm: f64, room: &Room) -> NearestApproach {
        let track = Track { stands: &self.stands, wanted: None };
        clearance::kept(track, a.part, &a.segments, limit_mm, room.options)
    }

    /// The way of the ball, or of the disc's centre.
    fn sweep(&self, room: &Room) -> Sweep {
        let centres: Vec<Point> = self.stands.iter().map(|s| s.centre).collect();
        let turns = vec![0; centres.len()];
        Sweep::of(centres.clone(), centres, turns, room.tool.corner_mm(), None)
    }

    fn gouge(&self, room: &Room) -> gouge::Gouge {
        let part = Allowed::new(&room.blade.part, room.stock_mm);
        let sweep = self.sweep(room);
        EndWay::new(room.tool, &sweep, &self.stands).deepest(&part, room.options.settings.resolution_mm)
    }

    /// The deepest cut of the ball into other bodies: see [`cuts::in_obstacles`].
    fn in_obstacles<'a>(&self, room: &Room<'a>) -> Option<(&'a Obstacle, f64, gouge::Gouge)> {
        let sweep = self.sweep(room);
        let way = EndWay::new(room.tool, &sweep, &self.stands);
        cuts::in_obstacles(room.obstacles, &way, room.options.settings.resolution_mm)
    }
}

/// How far along the axis the ball has to go for a plane under it to have the whole part on its
/// other side, mm.
fn beyond(part: &Part, from: &Point, axis: &Vector, radius_mm: f64) -> f64 {
    let farthest = part.mesh.points.iter().map(|p| (p - from).dot(axis)).fold(0.0, f64::max);
    farthest + radius_mm + BEYOND_MM
}

/// What stands in the way of a lead to or from a location; `None`: there is room: the
/// tool keeps the clearance that is asked for.
pub fn obstructed(lead: &Lead, foot: Stand, inwards: bool, room: &Room) -> Option<InTheWay> {
    let way = LeadWay::new(lead, foot, inwards, room);
    let part = Allowed::new(&room.blade.part, room.stock_mm);
    let found = way.gouge(room);
    let depth = found.bound_mm.max(found.found_mm);
    if depth > room.options.settings.gouge_mm {
        let face = part.closest(&found.centre, f64::INFINITY).map(|c| part.face_name(c.face)).unwrap_or_default();
        return Some(InTheWay::Cut { depth_mm: depth, body: face });
    }
    if let Some((body, depth, _)) = way.in_obstacles(room).filter(|found| found.1 > 0.0) {
        return Some(InTheWay::Cut { depth_mm: depth, body: body.name.clone() });
    }
    if let Some(outer) = way.stands.iter().rev().nth(1).filter(|_| lead.is_arc()) {
        let height = room.tool.corner_mm() + OFF * lead.radius_mm * (1.0 - lead.angle_rad.cos());
        let disc = room.tool.disc(outer.centre, outer.axis());
        if DiscSearch::new(&part).closest(&disc, height, room.options.settings.resolution_mm).is_some() {
            return Some(InTheWay::OuterEnd);
        }
    }
    for a in room.apart() {
        // Whether it comes too near is a much cheaper question than how near it comes.
        if clearance::short_stands(&way.stands, &a, 0.0, room.options).is_empty() {
            continue;
        }
        let limit_mm = room.options.least_clearance(a.asked_mm);
        let kept = way.least(&a, limit_mm, room);
        if kept.least_mm < limit_mm {
            let tool = a.segments.get(kept.near.segment).map_or_else(|| "tool".into(), |s| s.part.to_string());
            return Some(InTheWay::Near { tool, least_mm: kept.least_mm, body: a.named(kept.face) });
        }
    }
    lead.is_arc().then(|| off_travel(lead, foot.cone, room)).flatten()
}

/// An axis that would leave its travel on the arc.
fn off_travel(lead: &Lead, cone: Cone, room: &Room) -> Option<InTheWay> {
    let axes = room.machine.axes();
    let gauge = room.tool.length_mm();
    room.machine.along(lead.stands(cone), gauge).into_iter().find_map(|q| {
        let out = |i: &usize| axes[*i].limits.travel.is_some_and(|[lo, hi]| !(lo..=hi).contains(&q[*i]));
        (0..q.len()).find(out).map(|i| InTheWay::Travel { axis: axes[i].name.to_string() })
    })
}

/// The checks `lead-gouge`, `lead-clearance`, `lead-holder-clearance`, and `lead-obstacle` for the
/// ball and for the rest of the tool with each fixture, over both ways; and `lead-axes`,
/// `lead-travel`, `lead-limits` where there are arcs.
pub(super) fn check(plan: &Plan, room: &Room) -> Vec<Check> {
    let ways = ways(plan, room);
    let mut out = vec![deepest(&ways, plan, room)];
    out.extend(among_obstacles(&ways, plan, room));
    out.extend(room.apart().iter().map(|a| nearest(&ways, a, plan, room)));
    if plan.leads.iter().any(Lead::is_arc) {
        out.extend([placed(plan, room), within_travel(plan, room), within_limits(plan, room)]);
    }
    out
}

/// Both ways with their names and the row of the location that they belong to.
fn ways(plan: &Plan, room: &Room) -> Vec<(&'static str, usize, LeadWay)> {
    let rows = &plan.toolpath.locations;
    let ends = [("lead-in", 0, true), ("lead-out", rows.len().saturating_sub(1), false)];
    let way = |((name, row, inwards), lead): ((&'static str, usize, bool), &Lead)| {
        Some((name, row, LeadWay::new(lead, plan.stand(row)?, inwards, room)))
    };
    ends.into_iter().zip(&plan.leads).filter_map(way).collect()
}

fn at(check: Check, row: usize, point: Option<Point>, plan: &Plan, blade: &Blade) -> Check {
    let point_mm = point.map(|p| blade.model_from_blade * p).map(|p| [p.x, p.y, p.z]);
    Check { row: Some(row), turn: plan.toolpath.locations.get(row).map(|l| l.turn), point_mm, ..check }
}

fn deepest(ways: &[(&str, usize, LeadWay)], plan: &Plan, room: &Room) -> Check {
    let found = ways.iter().map(|(name, row, way)| (name, *row, way.gouge(room)));
    let worst = found.reduce(|a, b| if b.2.bound_mm > a.2.bound_mm { b } else { a });
    let (name, row, bound, centre) =
        worst.map_or(("", 0, 0.0, None), |(n, r, g)| (*n, r, g.bound_mm.max(g.found_mm).max(0.0), Some(g.centre)));
    let limit = room.options.settings.gouge_mm;
    let quantity = "depth of the ball in the part on the ways onto the path and off it";
    let check = Check::at_most(CheckId::LeadGouge, quantity, bound, limit, "mm", name.to_owned());
    at(check, row, centre, plan, room.blade)
}

fn among_obstacles(ways: &[(&str, usize, LeadWay)], plan: &Plan, room: &Room) -> Option<Check> {
    let found = ways.iter().filter_map(|(name, row, way)| Some((*name, *row, way.in_obstacles(room)?)));
    let (name, row, (body, depth, g)) = found.reduce(|a, b| if b.2.1 > a.2.1 { b } else { a })?;
    let quantity = "depth of the ball in other bodies on the ways onto the path and off it; negative: room";
    let note = format!("{name}: nearest is {}", body.name);
    let check = Check::at_most(CheckId::LeadObstacle, quantity, depth, 0.0, "mm", note);
    Some(at(check, row, Some(g.centre), plan, room.blade))
}

fn nearest(ways: &[(&str, usize, LeadWay)], a: &Apart, plan: &Plan, room: &Room) -> Check {
    let id = match (a.obstacle, a.is_holder) {
        (None, false) => CheckId::LeadClearance,
        (None, true) => CheckId::LeadHolderClearance,
        (Some(_), _) => CheckId::LeadObstacle,
    };
    let limit = room.options.least_clearance(a.asked_mm);
    let found = ways.iter().map(|(which, row, way)| (*which, *row, way.least(a, limit, room)));
    let worst = found.reduce(|a, b| if b.2.least_mm < a.2.least_mm { b } else { a });
    let (which, row, kept) = worst.map_or(("", 0, None), |(w, r, k)| (w, r, Some(k)));
    let worst = kept.map_or(0.0, |k| k.least_mm);
    let who = kept.and_then(|k| a.segments.get(k.near.segment)).map_or_else(String::new, |s| s.part.to_string());
    let what = kept.map_or_else(String::new, |k| a.named(k.face));
    let quantity = "least distance of the tool without its ball on the ways onto the path and off it";
    let note = format!("{which}: {who} to {what}, nowhere less than {worst:.6}; asked for {}", a.asked_mm);
    let check = Check { passed: worst >= limit, ..Check::at_most(id, quantity, worst, limit, "mm", note) };
    at(check, row, kept.map(|k| k.near.point), plan, room.blade)
}

/// The axes place ball centre and tool axis where the leads have them.
fn placed(plan: &Plan, room: &Room) -> Check {
    let gauge = room.tool.length_mm();
    let mut worst = 0.0f64;
    let last = plan.toolpath.locations.len().saturating_sub(1);
    for (lead, row) in plan.leads.iter().zip([0, last]) {
        for (stand, q) in lead.stands(plan.toolpath.cone(row)).zip(&lead.motion.position) {
            let pose = room.machine.forward(q, gauge);
            let turned = (pose.axis - stand.axis()).norm() * room.tool.length_mm();
            let off = (pose.centre - stand.centre).norm().max(turned);
            worst = if off.is_nan() { f64::MAX } else { worst.max(off) };
        }
    }
    let quantity = "distance of ball centre and gauge line that the axes give from the leads";
    Check::at_most(CheckId::LeadAxes, quantity, worst, 1e-6, "mm", String::new())
}

/// How far an axis leaves its travel on the leads.
fn within_travel(plan: &Plan, room: &Room) -> Check {
    let findings = plan.leads.iter().flat_map(|l| room.machine.check_travel(&l.motion));
    let worst = findings.max_by(|a, b| a.excess.total_cmp(&b.excess));
    let over = worst.as_ref().map_or(0.0, |w| if w.excess.is_nan() { f64::MAX } else { w.excess });
    let (scale, unit) = worst.as_ref().map_or((1.0, "mm"), |w| (w.axis.scale(), w.axis.unit()));
    let quantity = "how far an axis leaves its travel on the leads";
    let note = worst.map_or(String::new(), |w| format!("axis {}", w.axis.name));
    // Rounding of positions.
    Check { passed: over <= 1e-9, ..Check::at_most(CheckId::LeadTravel, quantity, over * scale, 0.0, unit, note) }
}

/// Velocity and acceleration of every axis from the rows of the leads to those next to them on the
/// path, as shares of the limits.
fn within_limits(plan: &Plan, room: &Room) -> Check {
    let rows: Vec<(f64, &[f64])> = plan.rows().map(|r| r.t_s).zip(plan.axes()).collect();
    let [before, after] = [&plan.leads[0], &plan.leads[1]].map(|l| l.centres.len());
    // Two rows of the path belong to the accelerations at the joint.
    let ends = [&rows[..(before + 2).min(rows.len())], &rows[rows.len().saturating_sub(after + 2)..]];
    let mut worst = (0.0f64, String::new());
    let mut take = |share: f64, axis: &str, kind: &str| {
        let share = if share.is_nan() { f64::MAX } else { share };
        if share > worst.0 {
            worst = (share, format!("axis {axis}: {kind}"));
        }
    };
    for (axis, Axis { name, limits: limit, .. }) in room.machine.axes().iter().enumerate() {
        for rows in ends {
            let v: Vec<f64> = rows.windows(2).map(|w| (w[1].1[axis] - w[0].1[axis]) / (w[1].0 - w[0].0)).collect();
            v.iter().for_each(|v| take(v.abs() / limit.velocity, name, "velocity"));
            for (i, w) in v.windows(2).enumerate() {
                let a = (w[1] - w[0]) / (0.5 * (rows[i + 2].0 - rows[i].0));
                take(a.abs() / limit.acceleration, name, "acceleration");
            }
        }
    }
    let limit = 1.0 + room.options.limit_tolerance;
    let quantity = "greatest share of an axis' velocity or acceleration on the leads";
    Check::at_most(CheckId::LeadLimits, quantity, worst.0, limit, "", worst.1)
}

#[cfg(test)]
#[path = "lead_tests.rs"]
mod tests;
