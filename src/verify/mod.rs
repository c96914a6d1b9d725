//! Checks of a finished plan, written apart from the planners: nothing here is shared with them but geometry, tool,
//! machine and the artifacts themselves.
//!
//! **In**: a [`Plan`], the [`Blade`] and the [`Tool`] it was made for. **Out**: a [`Verdict`] with a
//! [`CheckReport`]; only a verdict that passed holds a [`Verified`] plan, and only that can be posted.

mod options;
mod schedule;
mod verdict;

pub use options::VerifyOptions;
pub use verdict::{Rejected, Verdict, Verified};

use crate::artifact::{Blade, CheckReport, Plan};
use crate::error::{Error, Result, Stage};
use crate::observe::Observer;
use crate::tool::Tool;

/// Checks a plan against the part, the tool and the limits of `options`.
///
/// # Errors
/// `Usage` when the plan is not one at all (no locations, rows that do not match, a number that is not finite);
/// `Cancelled`. A plan that is complete but bad is no error: it is [`Verdict::Failed`].
pub fn check(
    plan: Plan,
    blade: &Blade,
    tool: &Tool,
    options: &VerifyOptions,
    observer: &dyn Observer,
) -> Result<Verdict<Plan>> {
    well_formed(&plan)?;
    tool.validate()?;
    observer.check(Stage::Verify)?;
    let mut report = CheckReport::default();
    report.checks.extend(schedule::check(&plan, blade, options));
    Ok(Verdict::of(plan, report))
}

/// Every list has one row per location and every number is finite.
fn well_formed(plan: &Plan) -> Result<()> {
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
    ] {
        if len != n {
            return bad(format!("the plan has {n} cutter locations but {len} rows of {name}"));
        }
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
        None => Ok(()),
    }
}
