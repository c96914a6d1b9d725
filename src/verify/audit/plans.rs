//! The feed moves of a program as plans, so that a post can write them for another control.
//!
//! **In**: what [`super::audit`] takes. **Out**: [`ProgramPlans`]: a plan for each run of feed
//! moves in which the ball comes to the part, with the checks of the program as its evidence.
//!
//! A run goes from one rapid to the next. Its rows are the ends of the lines, and places between
//! them where the ball leaves the straight way, or θ the even one, by more than [`STRAIGHT_MM`]:
//! the plan is the way that the program's own control takes. Each line takes the time that it took,
//! or that its axes need where that is more: the machine would not have been faster.
//! Rapids are left out, and so are runs that come nowhere to the part: the post comes to a run and
//! leaves it along the tool axis. That there is room for these ways is checked here
//! (`lead-gouge`, `lead-clearance`, `lead-holder-clearance`); they keep what the program keeps, or
//! what plans keep where that is less.
//!
//! A program that fails a check gives plans that failed it.

use super::legs::{Leg, LegKind, Legs};
use super::{Audit, AuditOptions, MovesSource};
use crate::artifact::program::{Setting, TOUCHES_MM};
use crate::artifact::schedule::Schedule;
use crate::artifact::toolpath::{CHORD_MM, GivenPlace};
use crate::artifact::{
    AxisMotion, AxisRows, Blade, Channel, CheckId, CheckReport, Cone, Cones, Lead, Plan, Stand, Sweep, Toolpath,
};
use crate::error::{Error, LeadReason, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::numerics::angle::within_half_turn;
use crate::observe::Observer;
use crate::parallel;
use crate::read::program::{self, Bench, Moved};
use crate::verify::{Verdict, VerifyOptions, lead, setting};

/// A place is left out where ball centre and the end of the tool are nearer than this to the
/// straight way without it, mm.
const STRAIGHT_MM: f64 = 0.0005;
/// Leans that differ by less are one, rad: the rounding of words.
const SAME_LEAN_RAD: f64 = 2e-5;

/// A program as plans.
#[derive(Clone, Debug)]
pub struct ProgramPlans {
    /// The checks of the program.
    pub audit: Audit,
    /// A plan for each run of feed moves, in the order of the program.
    pub plans: Vec<Verdict<Plan>>,
    /// What the program sets where it begins to move at a feed.
    pub setting: Setting,
    /// Number or name of the tool that it calls first.
    pub tool: Option<String>,
    /// Runs of feed moves that come nowhere to the part, left out.
    pub left_out: usize,
}

/// Judges a program that cuts with a ball, and makes its feed moves plans, see the module's page.
///
/// # Errors
/// As [`super::audit`]; `Usage` where the cutter is no ball, or the ball comes nowhere to the part.
pub fn as_plans(
    text: &str,
    blade: &Blade,
    bench: &Bench,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<ProgramPlans> {
    bench.tool.ball_only("programs are written for another control")?;
    let script = program::read(text, bench.language)?;
    let mut moves = program::follow(&script.blocks, bench)?;
    let legs = Legs::new(&moves, bench)?;
    slowed(&mut moves, &legs, bench);
    let source = MovesSource { text, script: &script, blocks: &script.blocks, moves: &moves, last: true };
    let (audit, _) = super::audit_moves(&source, blade, bench, options, observer)?;
    let runs = runs(&legs, &moves, bench);
    let part = Allowed::new(&blade.part, options.stock_mm);
    let touches = |run: &&Run| {
        let within = bench.tool.radius_mm + TOUCHES_MM;
        parallel::map(&run.rows, |(stand, _)| part.closest(&stand.centre, within).is_some()).contains(&true)
    };
    let cutting: Vec<&Run> = runs.iter().filter(touches).collect();
    if cutting.is_empty() {
        return Err(Error::usage(Stage::Verify, "the ball comes nowhere to the part, so there is nothing to write")
            .advise("give the part's place by --origin, --cad or --fit"));
    }
    let verify = as_the_program(&audit, options);
    let plans = cutting.iter().map(|run| {
        let plan = plan(run, &part, bench);
        let mut report =
            CheckReport { checks: audit.checks.iter().map(|c| c.check.clone()).collect(), ..CheckReport::default() };
        let (tool, machine) = (bench.tool, bench.machine);
        let room = lead::Room { blade, stock_mm: options.stock_mm, obstacles: &[], tool, machine, options: &verify };
        report.checks.extend(lead::check(&plan, &room));
        Verdict::of(plan, report)
    });
    let plans: Vec<Verdict<Plan>> = plans.collect();
    let tool = script.calls.iter().find_map(|c| c.tool.clone().filter(|t| t != "0"));
    Ok(ProgramPlans {
        plans,
        setting: setting::at_first_feed(&script, 0),
        tool,
        left_out: runs.len() - cutting.len(),
        audit,
    })
}

/// Gives lines that ask an axis for more than it can the time that the axis needs.
fn slowed(moves: &mut [Moved], legs: &Legs, bench: &Bench) {
    let (tool, machine) = (bench.tool, bench.machine);
    let mut longer = vec![1.0f64; moves.len()];
    for leg in legs.legs.iter().filter(|l| l.kind == LegKind::Cut) {
        let Some((m, most)) = moves.get(leg.moved).zip(longer.get_mut(leg.moved)) else { continue };
        let time_s = m.seconds.unwrap_or(0.0) * (leg.share[1] - leg.share[0]);
        let [from, to] = leg.share.map(|f| m.axes(f, tool, machine));
        let needs = machine.axes().iter().enumerate().map(|(k, axis)| (to[k] - from[k]).abs() / axis.limits.velocity);
        let needs_s = needs.fold(0.0, f64::max);
        if time_s > 0.0 && needs_s > time_s {
            *most = most.max(needs_s / time_s);
        }
    }
    for (m, longer) in moves.iter_mut().zip(longer) {
        m.seconds = m.seconds.map(|s| s * longer);
    }
}

/// What the ways to a run and off it are to keep: what plans keep, or what the program does where
/// that is less.
fn as_the_program(audit: &Audit, options: &AuditOptions) -> VerifyOptions {
    let usual = VerifyOptions::default();
    let kept = |id: CheckId, asked_mm: f64| {
        let own = audit.checks.iter().find(|c| c.check.id == id).map_or(asked_mm, |c| c.check.worst);
        usual.asked_clearance(own.max(0.0)).min(asked_mm)
    };
    VerifyOptions {
        settings: options.settings,
        clearance_mm: kept(CheckId::Clearance, usual.clearance_mm),
        holder_clearance_mm: kept(CheckId::HolderClearance, usual.holder_clearance_mm),
        ..usual
    }
}

/// Feed moves that follow one another: where the tool stands, and the time since the first, s.
#[derive(Default)]
struct Run {
    rows: Vec<(Stand, f64)>,
}

impl Run {
    /// Goes on to the last of some places. What lies between is taken along where the way to it is
    /// not straight.
    fn go(&mut self, way: &[(Stand, f64)], length_mm: f64) {
        let (Some(from), Some(last)) = (self.rows.last().copied(), way.last()) else { return };
        let whole_s = last.1 - from.1;
        let off = |(stand, at_s): &(Stand, f64)| {
            let share = if whole_s > 0.0 { (at_s - from.1) / whole_s } else { 1.0 };
            let there = from.0.towards(&last.0, share);
            let end = |s: &Stand| s.centre + s.axis() * length_mm;
            (stand.centre - there.centre).norm().max((end(stand) - end(&there)).norm())
        };
        if way.iter().map(off).fold(0.0, f64::max) <= STRAIGHT_MM {
            self.rows.push(*last);
        } else {
            self.rows.extend_from_slice(way);
        }
    }
}

fn runs(legs: &Legs, moves: &[Moved], bench: &Bench) -> Vec<Run> {
    let mut out: Vec<Run> = Vec::new();
    let mut open = false;
    let mut of_move: Vec<(Stand, f64)> = Vec::new();
    let mut now_s = 0.0;
    let mut each = legs.legs.iter().enumerate().peekable();
    while let Some((i, Leg { kind, moved, share })) = each.next() {
        if *kind != LegKind::Cut {
            open = false;
            continue;
        }
        let (Some(from), Some(to)) = (legs.stands.get(i), legs.stands.get(i + 1)) else { continue };
        if !open {
            (open, now_s) = (true, 0.0);
            out.push(Run { rows: vec![(*from, 0.0)] });
        }
        now_s += moves.get(*moved).and_then(|m| m.seconds).unwrap_or(0.0) * (share[1] - share[0]);
        of_move.push((*to, now_s));
        let goes_on = each.peek().is_some_and(|(_, next)| next.moved == *moved && next.kind == LegKind::Cut);
        if let (false, Some(run)) = (goes_on, out.last_mut()) {
            run.go(&std::mem::take(&mut of_move), bench.tool.length_mm());
        }
    }
    out.retain(|run| run.rows.len() > 1);
    out
}

fn plan(run: &Run, part: &Allowed, bench: &Bench) -> Plan {
    let radius_mm = bench.tool.radius_mm;
    let normals = parallel::map(&run.rows, |(stand, _)| {
        let foot = part.closest(&stand.centre, radius_mm + TOUCHES_MM).map(|c| stand.centre - c.point);
        foot.and_then(|n| n.try_normalize(1e-12)).unwrap_or_else(|| stand.axis())
    });
    let azimuth = |s: &Stand| s.centre.z.atan2(s.centre.y);
    let mut turned_rad = 0.0;
    let mut given: Vec<GivenPlace> = Vec::with_capacity(run.rows.len());
    for (k, ((stand, _), normal)) in run.rows.iter().zip(normals).enumerate() {
        let before = k.checked_sub(1).and_then(|b| run.rows.get(b));
        turned_rad += before.map_or(0.0, |(before, _)| within_half_turn(azimuth(stand) - azimuth(before)));
        given.push(GivenPlace { centre: stand.centre, normal, turned_rad });
    }
    // Turns are counted whichever way they go.
    if turned_rad < 0.0 {
        given.iter_mut().for_each(|g| g.turned_rad = -g.turned_rad);
    }
    let cones = cones(&run.rows);
    let theta: Vec<f64> = run.rows.iter().map(|(s, _)| s.theta).collect();
    let place = |(k, (stand, _)): (usize, &(Stand, f64))| {
        bench.machine.place(&Stand { cone: cones.at(k), ..*stand }, None, bench.tool.length_mm())
    };
    let position: AxisRows = run.rows.iter().enumerate().map(place).collect();
    let t_s: Vec<f64> = run.rows.iter().map(|(_, t)| *t).collect();
    let time_s = t_s.last().copied().unwrap_or(0.0);
    let motion = AxisMotion { t_s, position, time_s, ..AxisMotion::default() };
    let toolpath = Toolpath::given(&given, [radius_mm, part.stock_mm, CHORD_MM], cones);
    let channel = Channel {
        tolerance_rad: 0.0,
        sweep: Sweep::Follow,
        rows: Vec::new(),
        narrowest_row: 0,
        chains: 0,
        proven_at: Vec::new(),
    };
    let leads = [Lead::straight(LeadReason::OfProgram), Lead::straight(LeadReason::OfProgram)];
    Plan { toolpath, channel, schedule: Schedule::of_angles(theta), motion, leads, curve: None }
}

/// The leans, as one where only the rounding of words makes them differ.
fn cones(rows: &[(Stand, f64)]) -> Cones {
    let leans: Vec<f64> = rows.iter().map(|(s, _)| s.cone.lean_rad).collect();
    let (least, most) = leans.iter().fold((f64::MAX, f64::MIN), |(a, b), v| (a.min(*v), b.max(*v)));
    if most - least <= SAME_LEAN_RAD {
        return Cones::about_blade(0.5 * (least + most));
    }
    Cones::along(leans.into_iter().map(Cone::about_blade).collect())
}
