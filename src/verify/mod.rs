//! Checks of a finished plan, written apart from the planners: nothing here is shared with them but
//! geometry, tool, machine and the artifacts themselves.
//!
//! **In**: a [`Plan`], the [`Blade`], [`Tool`] and [`Machine`] it was made for. **Out**: a
//! [`Verdict`] with a [`CheckReport`]; only a verdict that passed holds a [`Verified`] plan, and
//! only that can be posted.
//!
//! | check | measured | bound between samples |
//! | --- | --- | --- |
//! | `gouge` | ball radius less distance to the part, along the straight moves | concavity of `d² − x²`: exact |
//! | `obstacle-gouge` | the same among fixtures, the other blades of a wheel and its hub | likewise |
//! | `gouge-surface` | the same from the part's side, at surface samples | none: samples |
//! | `scallop` | height at which the normal of a surface sample meets the swept ball (capsules) | none: samples |
//! | `ridge` | lowest point of the circle in which neighbouring passes meet, over the part | none: samples |
//! | `clearance`, `holder-clearance` | least distance of the frusta to the part's triangles | Taylor bound over the move |
//! | `other-blade` | how far another blade of the wheel is off the ball where that touches the blade that was planned ([`on_other_blade`]) | locations |
//! | `lead-gouge`, `lead-clearance`, `lead-holder-clearance` | the same on the ways onto the path and off it, arc and straight line | likewise |
//! | `lead-axes`, `lead-travel`, `lead-limits` | axis positions of the leads' rows, and their difference quotients over the limits | rows |
//! | `theta-reversal`, `theta-channel` | θ from row to row, θ against the channel | rows |
//! | `x-travel` … `b-acceleration`, `time` | difference quotients of axis positions | means of the true values |
//! | `axes-centre`, `axes-direction` | forward kinematics against cutter location and `a(θ)` | rows |
//! | `job`, `job-region`, `job-feed` | the plan against what its job asks for ([`Asked`]) | none |
//! | `turn-offset`, `turn-rate`, `tooth-feed` | turn-milling: see the page of `turning.rs` | rows |
//! | `plan-turns`, `plan-contacts`, `plan-motion`, `plan-channel`, `channel-clear` | the plan against itself, and its channel against the part | rows |
//!
//! A plan with a programmed curve is judged along that too: `curve-gouge` … `curve-joints`, see the
//! page of `curve.rs`.
//!
//! Gouges, scallop and ridges are measured on the part with the stock on it that the path is to
//! leave. To the part belongs what sewing or healing moved or left out, as the file has it
//! ([`crate::geometry::part::Part::published`]): gouges are judged on both.
//!
//! A check whose bound holds between samples reports the bound as its worst value and the measured
//! value in its note.
//!
//! **Limits**: what the control does between rows is taken as a straight move of the ball centre
//! with θ even, or as the plan's curve; the clearance is measured to the part's triangles and
//! lessened by their deflection; jerk is not checked.

mod apart;
mod asked;
pub mod audit;
mod between;
mod clearance;
mod cornered;
mod curve;
mod cuts;
mod cutter;
mod deviation;
mod gouge;
mod height;
pub mod lead;
mod limit;
mod limits;
mod options;
mod pinch;
mod pinch_audit;
mod pinch_channels;
mod pinch_program;
pub mod read_back;
mod restart;
mod ridge;
mod samples;
mod scallop;
mod schedule;
pub mod seal;
mod setting;
mod settings;
mod solid;
mod sweep;
#[cfg(test)]
mod tests;
mod turning;
mod uncut;
mod verdict;
mod walls;
mod whole;

pub use apart::{Apart, apart};
pub use clearance::{Standing, short_moves, standing};
pub use curve::short_on_curve;
pub use deviation::deviation;
pub use limit::limit;
pub use options::{Asked, VerifyOptions};
pub use pinch::{PinchFigures, PinchWork, check as check_pinch, threads_p99_mm, turning_rad_mm};
pub use pinch_audit::{PinchAudit, PinchBench, audit as audit_pinch, is_for_two_tools};
pub use pinch_program::{PinchAsked, check_pinch_motion, check_pinch_program};
pub use restart::restart;
pub use ridge::{RidgeAt, ridges, ridges_p99};
pub use settings::{VerifyKeys, VerifySettings};
pub(crate) use turning::{BLEND_S, inner_turns};
pub use verdict::{Rejected, Verdict, Verified};

use cuts::EndWay;

use crate::artifact::{Blade, CheckReport, Obstacle, Plan};
use crate::error::{Error, Result, Stage};
use crate::geometry::Rigid;
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::machine::Machine;
use crate::observe::{Observer, Warning};
use crate::tool::Tool;

/// Checks a plan against the part, the tool and the limits of `options`.
///
/// # Errors
/// `Usage` when the plan is not one at all (no locations, rows that do not match, a number that is
/// not finite); `Cancelled`. A plan that is complete but bad is no error: it is
/// [`Verdict::Failed`].
pub fn check(
    plan: Plan,
    blade: &Blade,
    tool: &Tool,
    machine: &Machine,
    options: &VerifyOptions,
    observer: &dyn Observer,
) -> Result<Verdict<Plan>> {
    check_among(plan, &Workspace { blade, obstacles: &[], tool, machine }, options, observer)
}

/// What a plan is carried out with: the part, what stands about it, the tool and the machine.
#[derive(Clone, Copy)]
pub struct Workspace<'a> {
    /// The part.
    pub blade: &'a Blade,
    /// Fixtures and stock.
    pub obstacles: &'a [Obstacle],
    /// The cutter with its holder.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
}

/// As [`check`], with fixtures and stock.
///
/// # Errors
/// As [`check`].
pub fn check_among(
    plan: Plan,
    workspace: &Workspace,
    options: &VerifyOptions,
    observer: &dyn Observer,
) -> Result<Verdict<Plan>> {
    let Workspace { blade, obstacles, tool, machine } = *workspace;
    well_formed(&plan, machine)?;
    tool.validate()?;
    let mut report = CheckReport::default();
    let step = |done: usize| {
        observer.progress(Stage::Verify, done, 4);
        observer.check(Stage::Verify)
    };
    step(0)?;
    let part = Allowed::new(&blade.part, plan.toolpath.stock_mm);
    let hub_of = options.asked.as_ref().and_then(|a| a.hub_of);
    let (sweep, stands) = (sweep::Sweep::new(&plan.toolpath).over_hub(hub_of).round(blade), plan.stands());
    let way = EndWay::new(tool, &sweep, &stands);
    let check = cuts::check(blade, &part, &way, options);
    // What is reported is what was proven, not the best that was measured.
    report.gouge_mm = check.worst;
    report.checks.push(check);
    report.checks.extend(cuts::check_obstacles(blade, obstacles, &way, options));
    step(1)?;
    if tool.is_ball() {
        let cutting = || sweep::Sweep::cutting(&plan.toolpath).over_hub(hub_of).round(blade);
        let cutting = plan.toolpath.has_links().then(cutting);
        let cutting = cutting.as_ref().unwrap_or(&sweep);
        if let Some(doubt) = scallop::check(&plan, blade, &part, cutting, options, &mut report) {
            observer.warn(Warning { stage: Stage::Verify, doubt });
        }
    } else {
        let of = cornered::Stands { tool, stands: &stands, sweep: &sweep };
        cornered::check(&plan, blade, &part, &of, options, &mut report);
    }
    step(2)?;
    let apart = apart::apart(blade, obstacles, tool, options);
    let (checks, least) = clearance::check(&plan, blade, &apart, options);
    report.clearance_mm = least;
    report.checks.extend(checks);
    let room = lead::Room { blade, stock_mm: plan.toolpath.stock_mm, obstacles, tool, machine, options };
    report.checks.extend(lead::check(&plan, &room));
    step(3)?;
    report.checks.extend(schedule::check(&plan, blade, options));
    report.checks.extend(limits::check(&plan, blade, tool, machine, options));
    report.checks.extend(curve::check(&plan, blade, &part, &apart, options));
    if let Some(asked) = &options.asked {
        report.checks.extend(asked::check(&plan, blade, asked, options));
        if let Some((checks, figures, doubt)) = turning::check(&plan, blade, tool, machine, asked) {
            report.checks.extend(checks);
            report.turning = Some(figures);
            doubt.into_iter().for_each(|doubt| observer.warn(Warning { stage: Stage::Verify, doubt }));
        }
        report.checks.extend(whole::check(&plan, blade, tool, machine));
        report.checks.extend(walls::check(&plan, blade, tool, &apart, asked));
    }
    step(4)?;
    Ok(Verdict::of(plan, report))
}

/// A checked plan on an equal blade of its wheel: the turn of the wheel that brings the blade in
/// hand to the other one, and how much farther a rotary axis then stands, rad.
///
/// The turn carries wheel and tool alike, so what was found of the one blade holds for a copy of
/// it. Two things are measured again, seen from the other blade: where the model has the blades
/// itself (`own`), ball, tool and leads against it, and how far that blade is off the ball where it
/// should touch; and what stands about the part and is not of the wheel, as fixtures.
pub fn on_other_blade(
    plan: &Verified<Plan>,
    (turn, column, by_rad): (&Rigid, usize, f64),
    own: bool,
    workspace: &Workspace,
    options: &VerifyOptions,
) -> Verdict<Plan> {
    let (first, mut report) = (plan.value(), plan.report().clone());
    let Workspace { blade, obstacles, tool, machine } = *workspace;
    if own || obstacles.iter().any(|o| !o.of_the_wheel) {
        let seen = |part: &Part| part.clone().moved(&turn.inverse());
        let moved = own.then(|| Blade { part: seen(&blade.part), ..blade.clone() });
        let blade = moved.as_ref().unwrap_or(blade);
        let about =
            |o: &Obstacle| if o.of_the_wheel { o.clone() } else { Obstacle { part: seen(&o.part), ..o.clone() } };
        let obstacles: Vec<Obstacle> = obstacles.iter().map(about).collect();
        let stock_mm = first.toolpath.stock_mm;
        let (part, sweep) = (Allowed::new(&blade.part, stock_mm), sweep::Sweep::new(&first.toolpath));
        let stands = first.stands();
        let way = EndWay::new(tool, &sweep, &stands);
        let mut again = vec![cuts::check(blade, &part, &way, options)];
        again.extend(own.then(|| cuts::check_touches(blade, &part, &way, options)));
        again.extend(cuts::check_obstacles(blade, &obstacles, &way, options));
        again.extend(clearance::check(first, blade, &apart::apart(blade, &obstacles, tool, options), options).0);
        let room = lead::Room { blade, stock_mm, obstacles: &obstacles, tool, machine, options };
        again.extend(lead::check(first, &room));
        report.checks.retain(|c| again.iter().all(|a| a.id != c.id));
        report.checks.extend(again);
    }
    match Verdict::of(first.turned(turn, column, by_rad), report) {
        // The user has asked for the program all the same.
        Verdict::Failed(found) if plan.forced() => Verdict::Passed(found.write_anyway()),
        Verdict::Passed(found) if plan.forced() => Verdict::Passed(found.as_forced()),
        verdict => verdict,
    }
}

/// Puts the places into a report that was read from a file: where the scallop, the ridges and what
/// stays uncut were measured. Its figures stay as they are.
pub fn places(plan: &Plan, blade: &Blade, tool: &Tool, options: &VerifyOptions, report: &mut CheckReport) {
    let part = Allowed::new(&blade.part, plan.toolpath.stock_mm);
    let hub_of = options.asked.as_ref().and_then(|a| a.hub_of);
    let sweep = sweep::Sweep::cutting(&plan.toolpath).over_hub(hub_of).round(blade);
    if tool.is_ball() {
        scallop::measure(&part, &sweep, options, report);
    } else {
        let of = cornered::Stands { tool, stands: &plan.stands(), sweep: &sweep };
        report.scallop = cornered::places(&part, &of, options);
    }
}

/// Every list has one row per location, rows of the motion have a column for each axis of the
/// machine, and every number is finite.
///
/// # Errors
/// `Usage`, naming the list or the row.
pub fn well_formed(plan: &Plan, machine: &Machine) -> Result<()> {
    let n = plan.toolpath.locations.len();
    let bad = |what: String| Err(Error::usage(Stage::Verify, what));
    if n < 2 {
        return bad(format!("the plan has {n} cutter locations, at least 2 are needed"));
    }
    for (name, len) in [
        ("channel", plan.channel.rows.len()),
        ("schedule", plan.schedule.theta.len()),
        ("axis motion", plan.motion.position.len()),
        ("axis times", plan.motion.t_s.len()),
        ("feeds", plan.motion.feed.len()),
    ] {
        if len != n {
            return bad(format!("the plan has {n} cutter locations but {len} rows of {name}"));
        }
    }
    for (name, lead) in ["lead-in", "lead-out"].into_iter().zip(&plan.leads) {
        let k = lead.centres.len();
        if lead.theta.len() != k || lead.motion.position.len() != k || lead.motion.t_s.len() != k {
            return bad(format!(
                "the {name} of the plan has {k} ball centres but other numbers of angles, positions or times"
            ));
        }
    }
    if let Some(curve) = &plan.curve {
        let rows = &curve.rows;
        if rows.len() != n {
            return bad(format!("the plan has {n} cutter locations but {} rows of its curve", rows.len()));
        }
        if let Some(i) = rows.windows(2).position(|w| w[1].s_mm.is_nan() || w[1].s_mm <= w[0].s_mm) {
            return bad(format!("the parameter of the plan's curve does not rise after cutter location {i}"));
        }
        if plan.toolpath.cones.same().is_none() {
            return bad("the plan has a curve, but another cone of tool axes at each cutter location".into());
        }
    }
    if !plan.toolpath.cones.fit(n) {
        return bad("the cones of tool axes of the plan are not finite, or not as many as its cutter locations".into());
    }
    let (columns, [before, after]) = (machine.axes().len(), &plan.leads);
    let motions = [&before.motion, &plan.motion, &after.motion];
    let tables = motions.into_iter().flat_map(|m| [&m.position, &m.velocity, &m.acceleration, &m.jerk]);
    if let Some(rows) = tables.into_iter().find(|rows| !rows.is_empty() && rows.axes() != columns) {
        return bad(format!("the machine has {columns} axes, a row of the plan's motion has {}", rows.axes()));
    }
    let finite = |i: usize| {
        let (l, c) = (&plan.toolpath.locations[i], &plan.channel.rows[i]);
        l.centre.iter().chain(l.contact.iter()).chain(l.normal.iter()).all(|x| x.is_finite())
            && plan.motion.position[i].iter().all(|x| x.is_finite())
            && [l.s_mm, plan.schedule.theta[i], plan.motion.t_s[i], c.theta_min, c.theta_max]
                .iter()
                .all(|x| x.is_finite())
    };
    match (0..n).find(|&i| !finite(i)) {
        Some(i) => bad(format!("cutter location {i} of the plan has a value that is not a finite number")),
        None if !plan.rows().all(|r| r.stand.centre.iter().chain([&r.stand.theta, &r.t_s]).all(|x| x.is_finite())) => {
            bad("a row of a lead has a value that is not a finite number".into())
        }
        None => Ok(()),
    }
}
