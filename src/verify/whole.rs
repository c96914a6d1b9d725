//! A plan agrees with itself: turns with locations, contacts with centres, the motion's columns
//! with its positions and times.
//!
//! The other checks rest on some of these numbers and pass over the rest; a plan that is read from
//! a file is judged by all of them, since others read them.
//!
//! | check | measured |
//! | --- | --- |
//! | `plan-turns` | locations whose turn, or whose length along turn and path, is not what follows from the ball centres |
//! | `plan-contacts` | distance of contacts from the centre less the ball's radius along the normal, and from the part with its stock |
//! | `plan-motion` | velocities, accelerations and jerks against positions and times; feeds against lengths and times; rest at both ends |
//!
//! Velocities are the integral of accelerations and positions that of velocities. With a jerk of at
//! most `J` the trapezoidal rule over a step `h` is off by at most `J h³/12` for positions and
//! `J h²/4` for velocities: where it is off by more, a column is not the derivative of the other.
//! Jerks may jump between locations. Small ones could be lost in these bounds. So root mean squares
//! of accelerations are compared with those of the difference quotients besides, and jerks with the
//! third derivative of the quintic through positions, velocities and accelerations at both ends of
//! a step: within a step jerk is smooth, and the quintic knows it up to the third power of the
//! step. The outermost steps are left out, ways of few rows, and where a rate of turning is kept
//! the tenth of the steps that is off most: there a plan's jerk may jump between two rows, and its
//! columns say nothing of that.

use crate::artifact::report::Check;
use crate::artifact::toolpath::CutterLocation;
use crate::artifact::{AxisMotion, Blade, CheckId, Plan};
use crate::geometry::Point;
use crate::machine::Machine;
use crate::parallel;
use crate::tool::Tool;

/// Lengths that follow from sums of thousands of distances, mm.
const LENGTH_MM: f64 = 1e-6;
/// Contacts lie on the part within this, mm: what the distance to exact faces is good for.
const CONTACT_MM: f64 = 1e-4;
/// Balls of a programmed curve may be off the part by what was proven of it, and that by no more
/// than this share of the scallop: then their contacts are feet on the part.
const OFF_SHARE: f64 = 0.25;
/// Contacts farther off are so far off, mm.
const FAR_MM: f64 = 1.0;
/// Feeds are of arcs on the leads, lengths of their chords; relative.
const FEED: f64 = 1e-3;
/// Jerks on the safe side of their limit by the solver's tolerance.
const JERK: f64 = 1.01;
/// What rounding leaves of velocities and accelerations, relative to their limits.
const ROUNDING: f64 = 1e-6;
/// Root mean squares of accelerations and of difference quotients of velocities are alike within
/// this factor.
const ALIKE: f64 = 3.0;
/// The root mean square of what jerks are off, as a share of theirs; on the roughest paths it is
/// less than a tenth.
const OFF: f64 = 0.25;
/// Share of the steps, those most off, that do not count where a rate of turning is kept: a profile
/// has joints between two rows there too, where jerk jumps within a step. They keep to the limit.
const JUMPS: f64 = 0.1;
/// Outermost steps and least number of steps within which jerk may jump.
const OUTER: usize = 5;
const FEW: usize = 24;
/// A jerk by positions is known where rounding leaves less than this share of its limit.
const KNOWN: f64 = 0.01;

/// The checks of this module.
pub(super) fn check(plan: &Plan, blade: &Blade, tool: &Tool, machine: &Machine) -> Vec<Check> {
    vec![turns(plan, blade), contacts(plan, blade, tool), motion(plan, blade, machine)]
}

/// Findings in a list, of which the first is named.
#[derive(Default)]
struct Findings {
    count: usize,
    first: Option<(usize, String)>,
}

impl Findings {
    fn add(&mut self, row: usize, says: impl FnOnce() -> String) {
        self.count += 1;
        self.first.get_or_insert_with(|| (row, says()));
    }

    /// `row` of a number in a column that is not what it should be.
    fn number(&mut self, row: usize, column: &str, is: f64, want: f64, slack: f64) {
        if !((is - want).abs() <= slack) {
            self.add(row, || format!("plan.json, location {row}: {column} is {is}, by the others it is {want}"));
        }
    }

    fn check(self, id: CheckId, quantity: &str, plan: &Plan, blade: &Blade) -> Check {
        let (row, note) = self.first.map_or((None, String::new()), |(row, says)| (Some(row), says));
        let check = Check::at_most(id, quantity, self.count as f64, 0.0, "", note);
        match row {
            Some(row) => check.at_location(row, plan, blade),
            None => check,
        }
    }
}

/// Turns and lengths.
fn turns(plan: &Plan, blade: &Blade) -> Check {
    let (locations, turns) = (&plan.toolpath.locations, &plan.toolpath.turns);
    let mut found = Findings::default();
    let mut next = 0;
    for (k, turn) in turns.iter().enumerate() {
        if turn.first != next || turn.count == 0 || next + turn.count > locations.len() {
            let is = format!("turn {} has locations {} to {}", k + 1, turn.first, turn.first + turn.count);
            found.add(next.min(locations.len() - 1), || format!("plan.json: {is}, the one before ends at {next}"));
            break;
        }
        let of = &locations[turn.first..turn.first + turn.count];
        let base = of[0].s_mm;
        for (i, l) in of.iter().enumerate() {
            found.number(turn.first + i, "turn", f64::from(l.turn), k as f64, 0.0);
            found.number(turn.first + i, "turn_s_mm", l.turn_s_mm, l.s_mm - base, LENGTH_MM);
        }
        next += turn.count;
        let end = locations.get(next).or(locations.last()).map_or(base, |l| l.s_mm);
        found.number(turn.first, "length_mm of the turn", turn.length_mm, end - base, LENGTH_MM);
    }
    if next != locations.len() && found.count == 0 {
        found.add(next, || format!("plan.json: turns end at location {next}, there are {}", locations.len()));
    }
    for (k, pair) in plan.toolpath.of_corner().locations.windows(2).enumerate() {
        let step = (pair[1].centre - pair[0].centre).norm();
        found.number(k + 1, "s_mm", pair[1].s_mm, pair[0].s_mm + step, LENGTH_MM * (1.0 + step));
    }
    let quantity = "locations whose turn or length is not what follows from turns and ball centres";
    found.check(CheckId::PlanTurns, quantity, plan, blade)
}

/// Contacts and normals.
fn contacts(plan: &Plan, blade: &Blade, tool: &Tool) -> Check {
    let path = &plan.toolpath;
    // A contact by the centre; where the tool is no ball, by its axis too.
    let want = |row: usize| {
        let l = &path.locations[row];
        let of_ball = l.centre - l.normal * path.radius_mm;
        let stand = plan.stand(row).filter(|_| !tool.is_ball());
        let centre = stand.and_then(|s| tool.centre_at(&l.contact, &l.normal, &s.axis(), None));
        centre.map_or(of_ball, |centre| l.contact + (l.centre - centre))
    };
    let off = |row: usize| {
        let l = &path.locations[row];
        if !l.touches() {
            return (l.normal.norm() - 1.0).abs();
        }
        let along = (want(row) - l.contact).norm().max((l.normal.norm() - 1.0).abs());
        let near = blade.part.closest(&l.contact, path.stock_mm + FAR_MM);
        along.max(near.map_or(f64::MAX, |c| (c.distance_mm - path.stock_mm).abs()))
    };
    let all: Vec<f64> = parallel::map(0..path.locations.len(), off);
    let worst = all.iter().enumerate().fold((0.0f64, 0), |best, (row, off)| {
        let off = if off.is_nan() { f64::MAX } else { *off };
        if off > best.0 { (off, row) } else { best }
    });
    let quantity =
        "distance of a contact from the part with its stock, or from where the tool touches along its normal";
    let says = |l: &CutterLocation| {
        let [is, want] = [l.contact, want(worst.1)].map(|p| format!("({:.6}, {:.6}, {:.6})", p.x, p.y, p.z));
        let by = if tool.is_ball() { "centre and normal" } else { "centre, normal and tool axis" };
        format!("plan.json, location {}: contact {is}, by {by} {want}, blade frame", worst.1)
    };
    let off = plan.curve.as_ref().map_or(0.0, |c| c.proof.inwards_mm.max(c.proof.outwards_mm));
    let limit = CONTACT_MM + off.clamp(0.0, OFF_SHARE * path.scallop_mm);
    let note = path.locations.get(worst.1).filter(|_| worst.0 > limit).map_or(String::new(), says);
    Check::at_most(CheckId::PlanContacts, quantity, worst.0, limit, "mm", note).at_location(worst.1, plan, blade)
}

/// All rows of the motion, leads and path, and the place at each whose speed is the feed.
fn all_rows(plan: &Plan) -> (AxisMotion, Vec<Point>) {
    let [before, after] = &plan.leads;
    let mut out = AxisMotion::default();
    for m in [&before.motion, &plan.motion, &after.motion] {
        out.t_s.extend(&m.t_s);
        out.feed.extend(&m.feed);
        out.position.extend(&m.position);
        out.velocity.extend(&m.velocity);
        out.acceleration.extend(&m.acceleration);
        out.jerk.extend(&m.jerk);
    }
    (out, plan.feed_points())
}

/// The third derivative of the quintic through position, velocity and acceleration of an axis at
/// row `k` and the next, at row `k`. `None` where it is not known within `most`, since positions
/// and times are rounded.
fn third(m: &AxisMotion, k: usize, axis: usize, most: f64) -> Option<f64> {
    let h = m.t_s[k + 1] - m.t_s[k];
    let [(q0, v0, a0), (q1, v1, a1)] =
        [k, k + 1].map(|i| (m.position[i][axis], m.velocity[i][axis], m.acceleration[i][axis]));
    let size = q0.abs().max(q1.abs()) + v0.abs().max(v1.abs()) * m.t_s[k + 1].abs();
    let rounding = 120.0 * f64::EPSILON * size / h.powi(3);
    let jerk = (60.0 * (q1 - q0) / h - 36.0 * v0 - 24.0 * v1) / (h * h) - (9.0 * a0 - 3.0 * a1) / h;
    // Written so that what is not a number is judged.
    (!(rounding > most)).then_some(jerk)
}

fn mean_square(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = values.len().max(1);
    (values.map(|x| x * x).sum::<f64>() / n as f64).sqrt()
}

/// Derivatives and feeds.
fn motion(plan: &Plan, blade: &Blade, machine: &Machine) -> Check {
    let (m, centres) = all_rows(plan);
    let n = m.t_s.len();
    let mut found = Findings::default();
    let lengths = [m.feed.len(), m.velocity.len(), m.acceleration.len(), m.jerk.len(), centres.len()];
    let quantity = "numbers of the motion that are not what follows from positions and times";
    if lengths.iter().any(|l| *l != n) {
        found.add(0, || {
            format!("plan.json: {n} times, but {lengths:?} feeds, velocities, accelerations, jerks and centres")
        });
        return found.check(CheckId::PlanMotion, quantity, plan, blade);
    }
    let last = plan.toolpath.locations.len().saturating_sub(1);
    let row = |k: usize| k.saturating_sub(plan.leads[0].centres.len()).min(last);
    for (axis, own) in machine.axes().iter().enumerate() {
        let (unit, name, limit) = (own.scale(), &own.name, own.limits);
        let jerk = JERK * limit.jerk;
        let (still, steady) = (ROUNDING * limit.velocity, ROUNDING * limit.acceleration);
        for k in 0..n - 1 {
            let h = m.t_s[k + 1] - m.t_s[k];
            let [(q0, v0, a0), (q1, v1, a1)] =
                [k, k + 1].map(|i| (m.position[i][axis], m.velocity[i][axis], m.acceleration[i][axis]));
            let (mean_v, mean_a) = ((q1 - q0) / h, (v1 - v0) / h);
            let says = |what: &str, is: f64, want: f64| {
                let at = format!("plan.json, location {}", row(k));
                format!(
                    "{at}: the {what} of axis {name} is {} in the mean of its columns, by the one before {}",
                    is * unit,
                    want * unit
                )
            };
            if !((mean_v - 0.5 * (v0 + v1)).abs() <= jerk * h * h / 12.0 + still) {
                found.add(row(k), || says("velocity", 0.5 * (v0 + v1), mean_v));
            }
            if !((mean_a - 0.5 * (a0 + a1)).abs() <= jerk * h / 4.0 + steady) {
                found.add(row(k), || says("acceleration", 0.5 * (a0 + a1), mean_a));
            }
        }
        let steps = if n > FEW { OUTER..n - 1 - OUTER } else { 0..0 };
        let mean = |k: usize| (m.velocity[k + 1][axis] - m.velocity[k][axis]) / (m.t_s[k + 1] - m.t_s[k]);
        let is = mean_square(steps.clone().map(|k| m.acceleration[k][axis]));
        let want = mean_square(steps.clone().map(mean));
        if !(is <= ALIKE * want + steady && want <= ALIKE * is + steady) {
            let says = format!("plan.json: the root mean square of axis {name}'s acceleration is {}", is * unit);
            found.add(0, || format!("{says}, by its velocities {}", want * unit));
        }
        let mut known: Vec<(f64, f64)> =
            steps.filter_map(|k| Some((m.jerk[k][axis], third(&m, k, axis, KNOWN * limit.jerk)?))).collect();
        if !plan.schedule.rates.is_empty() {
            known.sort_by(|a, b| (a.0 - a.1).abs().total_cmp(&(b.0 - b.1).abs()));
            let jumps = known.split_off(((1.0 - JUMPS) * known.len() as f64).ceil() as usize);
            if let Some((is, _)) = jumps.iter().find(|(is, _)| !(is.abs() <= jerk)) {
                found.add(0, || format!("plan.json: a jerk of axis {name} is {}, over its limit", is * unit));
            }
        }
        let want = mean_square(known.iter().map(|(_, by)| *by));
        let off = mean_square(known.iter().map(|(is, by)| is - by));
        if !(off <= OFF * want + ROUNDING * limit.jerk) {
            let says = format!(
                "plan.json: the root mean square of axis {name}'s jerk by positions, velocities and accelerations"
            );
            found.add(0, || format!("{says} is {}, its column is off by {}", want * unit, off * unit));
        }
        for k in [0, n - 1] {
            found.number(
                row(k),
                &format!("velocity of axis {name} at the end of the way"),
                m.velocity[k][axis] * unit,
                0.0,
                still * unit,
            );
        }
    }
    found.number(0, "t_s of the first row", m.t_s[0], 0.0, 0.0);
    let (first, end) = (plan.motion.t_s.first().unwrap_or(&0.0), plan.motion.t_s.last().unwrap_or(&0.0));
    found.number(0, "time_s", plan.motion.time_s, end - first, 1e-9 * (1.0 + end.abs()));
    for k in 1..n {
        // Lead rows are arcs, whose length is a little more than the chord.
        let want = (centres[k] - centres[k - 1]).norm() / (m.t_s[k] - m.t_s[k - 1]);
        found.number(row(k), "feed_mm_s", m.feed[k], want, FEED * want);
    }
    found.check(CheckId::PlanMotion, quantity, plan, blade)
}
