//! A program's moves against the plan.

use std::f64::consts::TAU;

use nalgebra::Vector4;

use super::joints::{self, WorstJoint};
use crate::artifact::plan::Stretch;
use crate::artifact::program::Program;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckId, Cone, Motion, Plan, ProgrammedCurve, Stand};
use crate::geometry::triangle::share_of_segment;
use crate::geometry::{Point, Vector};
use crate::machine::{Machine, Pose};
use crate::numerics::angle::within_half_turn;
use crate::read::program::Moved;
use crate::tool::Tool;

/// Greatest distance of the ball centre after a line from the plan's path, mm: what rounding may
/// do.
const CENTRE_MM: f64 = 0.001;
/// Three words of four decimals are up to 0.087 µm off what they stand for: rounding moves a place
/// of a line by no more, mm, and no smaller chord tolerance can be seen in a program.
const ROUNDED_MM: f64 = 0.0001;
/// Greatest angle of the tool axis from the plan's, degrees.
const DIRECTION_DEG: f64 = 0.001;
/// Greatest relative difference of the whole time.
const TIME: f64 = 0.001;
/// Greatest relative difference of the time of a line.
const FEED: f64 = 0.02;
/// Times of lines that are nearer than this are the same, s: places are rounded, and with them the
/// times at which the plan is there.
const MOMENT_S: f64 = 0.01;
/// A line that ends this near to a row ends there, mm: twice what rounding does.
const AT_ROW_MM: f64 = 2.0 * ROUNDED_MM;
/// A line that comes this near to the first or last location ends there, mm.
const AT_END_MM: f64 = 0.05;
/// Places looked at within a move, its end among them.
const WITHIN: usize = 8;
/// Steps to the nearest place of a line that bends, each by a third.
const NARROWED: usize = 40;
/// Plan moves looked ahead for the one that a place belongs to: lines may be left out where
/// locations round to one.
const AHEAD: usize = 12;

/// A worst value, with the line and the cutter location.
#[derive(Clone, Copy, Default)]
struct WorstLine {
    value: f64,
    line: usize,
    row: usize,
}

impl WorstLine {
    fn take(&mut self, value: f64, line: usize, row: usize) {
        // What is not a number is worse than everything.
        let value = if value.is_nan() { f64::MAX } else { value };
        if value > self.value {
            *self = WorstLine { value, line, row };
        }
    }
}

/// A place on the plan's path: from location `row` the share `share` of the way to the next.
#[derive(Clone, Copy)]
struct OnPath {
    row: usize,
    share: f64,
    distance_mm: f64,
}

struct Comparison<'a> {
    /// The whole motion: leads and locations.
    motion: Motion<'a>,
    tool: &'a Tool,
    machine: &'a Machine,
    centre: WorstLine,
    direction: WorstLine,
    /// Greatest distance of the ball centre within a line from the plan's path, mm.
    within_mm: f64,
    /// Within polynomial lines; `None`: the program has none.
    curve: Option<WorstLine>,
    chord: WorstLine,
    missing: WorstLine,
    feed: WorstLine,
    /// Polynomial lines, by their place among the moves, and the row at or before their ends, with
    /// the share of the way to the next.
    met: Vec<(usize, OnPath)>,
    /// Where the last line ended.
    ended: Option<OnPath>,
    /// When the plan is where the line before ended, s.
    planned_s: f64,
    /// The planned θ there, over all turns, rad.
    planned_theta: f64,
}

/// All checks of a program.
pub(super) fn checks(
    program: &Program,
    moves: &[Moved],
    plan: &Plan,
    blade: &Blade,
    tool: &Tool,
    machine: &Machine,
) -> Vec<Check> {
    let mut c = Comparison {
        motion: Motion::of(plan),
        tool,
        machine,
        centre: WorstLine::default(),
        direction: WorstLine::default(),
        within_mm: plan.toolpath.chord_mm.max(ROUNDED_MM),
        curve: moves.iter().any(|m| m.bend.is_some()).then(WorstLine::default),
        chord: WorstLine::default(),
        missing: WorstLine::default(),
        feed: WorstLine::default(),
        met: Vec::new(),
        ended: None,
        planned_s: plan.rows().next().map_or(0.0, |r| r.t_s),
        planned_theta: plan.rows().next().map_or(0.0, |r| r.stand.theta),
    };
    let time = c.run(moves);
    let joint = plan.curve.as_ref().and_then(|curve| joints(&c.met, moves, curve, plan, tool, machine));
    let planned = c.motion.rows().last().map_or(0.0, |r| r.t_s) - c.motion.rows().first().map_or(0.0, |r| r.t_s);
    let before = plan.leads[0].centres.len();
    let off = WorstLine { value: (time / planned - 1.0).abs(), line: 0, row: 0 };
    let missing_mm = plan.toolpath.chord_mm.max(CENTRE_MM);
    let curve = c.curve.map(|worst| {
        (
            CheckId::ProgramCurve,
            "tool axis within a polynomial line off the schedule's curve",
            worst,
            DIRECTION_DEG,
            "deg",
        )
    });
    [
        (CheckId::ProgramCentre, "ball centre after a line off the planned path", c.centre, CENTRE_MM, "mm"),
        (
            CheckId::ProgramDirection,
            "tool axis off the planned one, or turned to it another way round",
            c.direction,
            DIRECTION_DEG,
            "deg",
        ),
        (CheckId::ProgramChord, "ball centre within a line off the planned path", c.chord, c.within_mm, "mm"),
        (CheckId::ProgramMissing, "cutter location off the program's path", c.missing, missing_mm, "mm"),
        (CheckId::ProgramFeed, "relative difference of the time of a line", c.feed, FEED, ""),
        (CheckId::ProgramTime, "relative difference of the whole time", off, TIME, ""),
    ]
    .into_iter()
    .chain(curve)
    .chain(joint.map(|(found, row)| {
        let worst = WorstLine { value: found.value, line: found.line, row };
        let quantity = "jump of a derivative where two lines of the curve meet, over what is allowed";
        (CheckId::ProgramJoints, quantity, worst, 1.0, "")
    }))
    .map(|(id, quantity, worst, limit, unit)| {
        let at = c.motion.rows().get(worst.row);
        let point = at.map(|r| blade.model_from_blade * r.stand.centre);
        let last = plan.toolpath.locations.len().saturating_sub(1);
        let line = if worst.line > 0 { format!(", line {}", worst.line) } else { String::new() };
        let note = match at.map(|r| r.stretch) {
            Some(Stretch::LeadIn) => format!("{}{line}, lead-in", program.file_name),
            Some(Stretch::LeadOut) => format!("{}{line}, lead-out", program.file_name),
            _ => format!("{}{line}", program.file_name),
        };
        let note = match joint.filter(|_| id == CheckId::ProgramJoints) {
            Some((j, _)) => format!(
                "{note}; at {} joints by {:.1e} rad, {:.1e} 1/mm and {:.1e} 1/mm² at most",
                j.count, j.jumps[0], j.jumps[1], j.jumps[2]
            ),
            None => note,
        };
        Check {
            row: Some(worst.row.saturating_sub(before).min(last)),
            turn: plan.toolpath.locations.get(worst.row.saturating_sub(before).min(last)).map(|l| l.turn),
            point_mm: point.map(|p| [p.x, p.y, p.z]),
            ..Check::at_most(id, quantity, worst.value, limit, unit, note)
        }
    })
    .collect()
}

impl Comparison<'_> {
    /// Compares all cutting lines; gives their time, s.
    fn run(&mut self, moves: &[Moved]) -> f64 {
        let rows = self.motion.rows();
        let end_of = |m: &Moved| m.pose(1.0, self.tool, self.machine).centre;
        let near = |m: &Moved, row: usize| {
            m.seconds.is_some() && rows.get(row).is_some_and(|l| (end_of(m) - l.stand.centre).norm() < AT_END_MM)
        };
        let last = rows.len().saturating_sub(1);
        let (first, end) = (moves.iter().position(|m| near(m, 0)), moves.iter().rposition(|m| near(m, last)));
        let (Some(first), Some(end)) = (first, end) else {
            self.missing = WorstLine { value: f64::MAX, line: 0, row: if first.is_none() { 0 } else { last } };
            return 0.0;
        };
        let mut at = 0;
        let mut time = 0.0;
        for (k, m) in moves.iter().enumerate().take(end + 1).skip(first + 1) {
            time += m.seconds.unwrap_or(0.0);
            at = self.one(m, at);
            if let Some(on) = self.ended.take().filter(|_| m.bend.is_some()) {
                self.met.push((k, on));
            }
        }
        // Whatever the program has not come by.
        let reached = moves[end].pose(1.0, self.tool, self.machine).centre;
        for row in at + 1..self.motion.rows().len() {
            self.missing.take((self.motion.rows()[row].stand.centre - reached).norm(), moves[end].line, row);
        }
        time
    }

    /// Compares one move that begins on plan move `at`; gives the plan move on which it ends.
    fn one(&mut self, m: &Moved, at: usize) -> usize {
        let poses: Vec<Pose> =
            (0..=WITHIN).map(|k| m.pose(k as f64 / WITHIN as f64, self.tool, self.machine)).collect();
        let mut here = at;
        for (k, pose) in poses.iter().enumerate().skip(1) {
            // Within a line the ball may be off along the path by as much as across it, and θ may
            // change fast along the path: the angle to the nearest place's would show that. At
            // ends only rounding is left.
            let on = if m.bend.is_some() {
                let (on, angle_deg) = self.locate_on_curve(pose, here);
                self.centre.take(on.distance_mm, m.line, on.row);
                let worst = if k == WITHIN { &mut self.direction } else { self.curve.get_or_insert_default() };
                worst.take(angle_deg, m.line, on.row);
                if k < WITHIN {
                    self.chord.take(on.distance_mm, m.line, on.row);
                }
                on
            } else if k == WITHIN {
                let on = self.locate_pose(pose, here);
                self.centre.take(on.distance_mm, m.line, on.row);
                self.direction.take(angle_deg(&pose.axis, &self.axis(on)), m.line, on.row);
                on
            } else {
                let on = self.locate(&pose.centre, here);
                self.chord.take(on.distance_mm, m.line, on.row);
                on
            };
            here = on.row;
            if k == WITHIN {
                self.ended = Some(on);
                self.time(m, on);
                self.turn(m, on, &poses);
            }
        }
        for row in at + 1..=here {
            let Some(l) = self.motion.rows().get(row) else { break };
            let off = self.off_line(m, &poses, &l.stand.centre);
            self.missing.take(off, m.line, row);
        }
        here
    }

    /// How far a place is from a line, mm: from the polyline through its poses, or where it bends
    /// from the line itself about the nearest of these.
    fn off_line(&self, m: &Moved, poses: &[Pose], place: &Point) -> f64 {
        let off = poses.windows(2).map(|w| to_segment(place, &w[0].centre, &w[1].centre).1);
        let nearest = off.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((k, _)) = nearest.filter(|(_, off)| m.bend.is_some() && *off > ROUNDED_MM) else {
            return nearest.map_or(f64::INFINITY, |(_, off)| off);
        };
        let at = |share: f64| (m.pose(share, self.tool, self.machine).centre - place).norm();
        let [mut low, mut high] = [k.saturating_sub(1), (k + 2).min(WITHIN)].map(|k| k as f64 / WITHIN as f64);
        for _ in 0..NARROWED {
            let third = (high - low) / 3.0;
            if at(low + third) < at(high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        at(0.5 * (low + high))
    }

    /// How far a line turns against the plan: the same axis may be reached the other way round, or
    /// a turn later.
    fn turn(&mut self, m: &Moved, on: OnPath, poses: &[Pose]) {
        let cone = self.cone(on.row);
        let angle = |p: &Pose| about(&cone, p);
        let step = |w: &[Pose]| angle(&w[1]) - angle(&w[0]);
        let turned: f64 = poses.windows(2).map(step).map(within_half_turn).sum();
        let planned = self.theta(on);
        let off = turned - (planned - self.planned_theta);
        self.planned_theta = planned;
        let whole = (off / TAU).round();
        if whole != 0.0 {
            self.direction.take((TAU * whole).abs().to_degrees(), m.line, on.row);
        }
    }

    /// The time of a line against the plan's.
    fn time(&mut self, m: &Moved, on: OnPath) {
        let t = |row: usize| self.motion.rows().get(row).map_or(f64::NAN, |r| r.t_s);
        let now = t(on.row) + (t(on.row + 1) - t(on.row)) * on.share;
        let planned = now - self.planned_s;
        self.planned_s = now;
        let off = (m.seconds.unwrap_or(0.0) - planned).abs() / (planned.max(0.0) + MOMENT_S);
        self.feed.take(off, m.line, on.row);
    }

    /// The nearest place of the plan's path, from plan move `from` on: of the first stretch that is
    /// near enough. A path that turns back on itself comes by there again.
    fn locate(&self, q: &Point, from: usize) -> OnPath {
        let rows = self.motion.rows();
        let mut best = OnPath { row: from, share: 0.0, distance_mm: f64::INFINITY };
        for row in from..(from + AHEAD).min(rows.len().saturating_sub(1)) {
            let (share, distance_mm) = to_segment(q, &rows[row].stand.centre, &rows[row + 1].stand.centre);
            if distance_mm < best.distance_mm - 1e-12 {
                best = OnPath { row, share, distance_mm };
            } else if best.distance_mm <= self.within_mm && distance_mm > self.within_mm {
                break;
            }
        }
        best
    }

    /// The place of the plan's path, from plan move `from` on, with the least of distance and angle
    /// together, each over its limit: rounding moves a place along the path as well, and where θ
    /// turns hundreds of degrees in a millimetre the nearest centre alone would have another axis.
    /// Of places within both limits the first, as in [`Self::locate`].
    fn locate_pose(&self, pose: &Pose, from: usize) -> OnPath {
        let rows = self.motion.rows();
        let mut best = (f64::INFINITY, OnPath { row: from, share: 0.0, distance_mm: f64::INFINITY });
        for row in from..(from + AHEAD).min(rows.len().saturating_sub(1)) {
            let (a, b) = (&rows[row].stand, &rows[row + 1].stand);
            let lean = a.cone.lean_rad.cos().to_degrees() / DIRECTION_DEG;
            let turn = about(&a.cone, pose) - a.theta;
            let whole = if a.cone == b.cone {
                b.theta - a.theta
            } else {
                within_half_turn(a.cone.theta_of(&b.axis(), 0.0).unwrap_or(b.theta) - a.theta)
            };
            let off = |bent: f64| {
                let turn = lean * (within_half_turn(turn) - bent);
                Vector4::from_iterator((pose.centre - a.centre).iter().map(|v| v / CENTRE_MM).chain([turn]))
            };
            let way = Vector4::from_iterator((b.centre - a.centre).iter().map(|v| v / CENTRE_MM).chain([lean * whole]));
            let length = way.norm_squared();
            let along = |off: &Vector4<f64>| if length > 0.0 { (off.dot(&way) / length).clamp(0.0, 1.0) } else { 0.0 };
            // Where θ does not turn evenly, by how much it differs there.
            let bent = |share: f64| self.motion.bent(row, share);
            let off = off(bent(along(&off(bent(along(&off(0.0)))))));
            let share = along(&off);
            let apart = (off - way * share).norm();
            if apart < best.0 - 1e-9 {
                let centre = a.centre + (b.centre - a.centre) * share;
                best = (apart, OnPath { row, share, distance_mm: (pose.centre - centre).norm() });
            } else if best.0 <= 1.0 && apart > 1.0 {
                break;
            }
        }
        best.1
    }

    /// As [`Comparison::locate_pose`], θ following the schedule's curve; with the angle between the
    /// tool axis and the planned one there, degrees.
    fn locate_on_curve(&self, pose: &Pose, from: usize) -> (OnPath, f64) {
        let near = self.locate(&pose.centre, from).row;
        let last = self.motion.rows().len().saturating_sub(2);
        let around = near.saturating_sub(1).max(from)..=(near + 1).min(last);
        let places = around.flat_map(|row| self.place_on_curve(pose, row));
        let apart = |(on, angle): &(OnPath, f64)| (on.distance_mm / ROUNDED_MM).hypot(angle / DIRECTION_DEG);
        let none = (OnPath { row: near, share: 0.0, distance_mm: f64::INFINITY }, f64::INFINITY);
        places.min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(none)
    }

    /// Places of a plan move: the one nearest to the centre, and that moved along by what the angle
    /// of the tool axis asks for.
    fn place_on_curve(&self, pose: &Pose, row: usize) -> [(OnPath, f64); 2] {
        let (a, b) = (&self.motion.rows()[row].stand, &self.motion.rows()[row + 1].stand);
        let at = |share: f64| self.motion.curved(row, share).unwrap_or(*a);
        let place = |share: f64| {
            let there = at(share);
            let distance_mm = (pose.centre - there.centre).norm();
            (OnPath { row, share, distance_mm }, angle_deg(&pose.axis, &there.axis()))
        };
        let (share, _) = to_segment(&pose.centre, &a.centre, &b.centre);
        let share = match self.motion.polynomial(row) {
            // One step along the tangent: the chord's share is not the curve's.
            Some(p) => {
                let there = p.at(share);
                let (off, way) = (pose.centre - there.point(), there.derivative(1) * p.length_mm);
                (share + off.dot(&way) / way.norm_squared()).clamp(0.0, 1.0)
            }
            None => share,
        };
        let turn = within_half_turn(about(&a.cone, pose) - at(share).theta);
        // Both in units of what is allowed, by the share of the way.
        let (low, high) = ((share - 0.01).max(0.0), (share + 0.01).min(1.0));
        let lean = a.cone.lean_rad.cos().to_degrees() / DIRECTION_DEG;
        let rate = lean * (at(high).theta - at(low).theta) / (high - low);
        let way = (b.centre - a.centre).norm() / ROUNDED_MM;
        let along = lean * turn * rate / (way * way + rate * rate);
        let moved = if along.is_finite() { (share + along).clamp(0.0, 1.0) } else { share };
        [place(share), place(moved)]
    }

    /// The planned stand there.
    fn planned(&self, on: OnPath) -> Option<Stand> {
        self.motion.straight(on.row, on.share)
    }

    /// The planned tool axis there.
    fn axis(&self, on: OnPath) -> Vector {
        self.planned(on).map_or(Vector::repeat(f64::NAN), |s| s.axis())
    }

    /// The planned θ there, rad.
    fn theta(&self, on: OnPath) -> f64 {
        self.planned(on).map_or(f64::NAN, |s| s.theta)
    }

    fn cone(&self, row: usize) -> Cone {
        self.motion.rows().get(row).map_or(Cone::about_blade(0.0), |r| r.stand.cone)
    }
}

/// The joints of lines that are within the curve, judged: the worst with its row. `None`: there are
/// none.
fn joints(
    met: &[(usize, OnPath)],
    moves: &[Moved],
    curve: &ProgrammedCurve,
    plan: &Plan,
    tool: &Tool,
    machine: &Machine,
) -> Option<(WorstJoint, usize)> {
    let before = plan.leads[0].centres.len();
    let rows: Vec<Point> = plan.rows().map(|r| r.stand.centre).collect();
    // The place is at a row, or on the way to the next.
    let within = |on: &OnPath| {
        let row = if on.share > 0.5 { on.row + 1 } else { on.row };
        // Rows may stand so near to one another that rounding is a good share of their way.
        let way_mm = rows.get(on.row).zip(rows.get(on.row + 1)).map_or(0.0, |(a, b)| (b - a).norm());
        let off = on.share.abs().min((1.0 - on.share).abs());
        let at_row = off < 1e-3 || off * way_mm < AT_ROW_MM;
        let k = row.checked_sub(before)?;
        let curved = |k: Option<usize>| k.and_then(|k| curve.rows.get(k)).is_some_and(|r| r.way.is_curved());
        let joined =
            if at_row { curved(k.checked_sub(1)) && curved(Some(k)) } else { curved(on.row.checked_sub(before)) };
        joined.then_some(row)
    };
    // Two lines, between which none moves.
    let pairs = met.windows(2).filter(|w| {
        let still = |m: &Moved| m.even() && m.from.iter().zip(m.to.iter()).all(|(a, b)| (a - b).abs() < 1e-6);
        within(&w[0].1).is_some() && moves[w[0].0 + 1..w[1].0].iter().all(still)
    });
    let found = joints::worst(pairs.clone().map(|w| (&moves[w[0].0], &moves[w[1].0])), tool, machine);
    let row = pairs.filter(|w| moves[w[0].0].line == found.line).find_map(|w| within(&w[0].1));
    (found.count > 0).then_some((found, row.unwrap_or(0)))
}

/// The angle of a pose's tool axis about the axis of a cone, rad; 0 along it.
fn about(cone: &Cone, pose: &Pose) -> f64 {
    cone.theta_of(&pose.axis, 0.0).unwrap_or(0.0)
}

/// Share along a segment and distance to it, mm.
fn to_segment(q: &Point, a: &Point, b: &Point) -> (f64, f64) {
    let f = share_of_segment(a, b, q);
    (f, (q - (a + (b - a) * f)).norm())
}

fn angle_deg(a: &Vector, b: &Vector) -> f64 {
    a.cross(b).norm().atan2(a.dot(b)).to_degrees()
}
