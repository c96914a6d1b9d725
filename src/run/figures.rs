//! The figures of a plan.

use super::summary::{self, ScheduleFigures, Summary};
use crate::artifact::{AxisMotion, CheckReport, Plan, ProgrammedCurve, Schedule};
use crate::error::{Result, Stage};
use crate::feed;
use crate::observe::{Observer, timed};
use crate::plan::{Baseline, Setup, paths};

/// The figures of a plan, before programs are written.
pub(super) fn figures(
    setup: &Setup,
    plan: &Plan,
    report: &CheckReport,
    baseline: &Baseline,
    observer: &dyn Observer,
) -> Result<Summary> {
    let schedules = compare(setup, plan, baseline)?;
    let mut summary = summary::summary(&setup.blade.name, plan, report, schedules, setup.machine.axes());
    if setup.job.path.compare {
        let others = timed(observer, Stage::Path, || paths::others(setup, &plan.toolpath, report, observer))?;
        let figures = |(other, limit)| summary::path_figures(&other, limit, &report.limit);
        summary.other_paths = others.into_iter().map(figures).collect();
    }
    summary.limits_assumed = setup.machine.assumed_limits().into_iter().map(String::from).collect();
    Ok(summary)
}

/// Figures of the schedule in use and of the fixed-lead baseline.
pub(super) fn compare(setup: &Setup, plan: &Plan, baseline: &Baseline) -> Result<Vec<ScheduleFigures>> {
    let a = setup.machine.turning_axis();
    let figures = |schedule: &Schedule, motion: &AxisMotion, on: Option<&ProgrammedCurve>| {
        let peaks = feed::peaks_on(&plan.toolpath, schedule, on, &setup.machine, &setup.feed_options())?;
        let constant = [peaks.velocity[a], peaks.acceleration[a]];
        Ok(summary::schedule_figures(plan, schedule, motion, constant, &setup.machine))
    };
    Ok(vec![
        figures(&plan.schedule, &plan.motion, plan.curve.as_ref())?,
        figures(&baseline.schedule, &baseline.motion, None)?,
    ])
}
