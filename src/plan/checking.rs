//! From a plan to its verdict and files.

use super::look::{self, Look};
use super::reuse::{self, Checks};
use super::{Baseline, Course, Setup, accept, compare, paths, post_all};
use crate::artifact::{CheckReport, Plan, Section};
use crate::error::{Result, Stage};
use crate::observe::{Observer, Recorder};
use crate::run::manifest::Clock;
use crate::run::summary::{self, Summary};
use crate::run::{self, RunFolder, tables};
use crate::verify::seal::{self, Subject};
use crate::verify::{self, Verdict};

/// What checking and writing came to.
pub(super) struct Checked {
    pub summary: Option<Summary>,
    pub report: CheckReport,
    pub plan: Plan,
    pub seal: String,
    /// The verdict is an earlier run's.
    pub recalled: bool,
}

/// What the stages of a run share.
pub(super) struct Run<'a, 'b> {
    pub setup: &'a Setup,
    pub course: Course,
    pub folder: &'a mut RunFolder,
    pub clock: &'a mut Clock,
    pub observer: &'a Recorder<'b>,
}

impl Run<'_, '_> {
    /// Checks the plan and writes all that follows from it.
    pub fn check_and_write(
        &mut self,
        sections: &[Section],
        plan: Plan,
        baseline: &Baseline,
        before: Option<Checks>,
    ) -> Result<Checked> {
        let (setup, course) = (self.setup, self.course);
        self.folder.add("cutter_locations.csv", tables::cutter_locations(&setup.blade, &plan))?;
        self.folder.add("axes.csv", tables::axes(&plan, setup.machine.axes()))?;
        let plan_json = run::json_compact(&plan)?;
        self.folder.add("plan.json", &plan_json)?;
        let (verdict, seal, recalled) = self.check(plan, &plan_json, before)?;
        let mut report = verdict.report().clone();
        let figures = compare(setup, verdict.value(), baseline)?;
        let mut summary = summary::summary(&setup.blade.name, verdict.value(), &report, figures);
        if setup.job.path.compare {
            let path = &verdict.value().toolpath;
            summary.other_paths =
                self.clock.time(Stage::Path, || paths::others(setup, path, &report, self.observer))?;
        }
        summary.limits_assumed = setup.machine.assumed_limits().into_iter().map(String::from).collect();
        let plan = verdict.value().clone();
        if !course.ends_at(Stage::Verify) {
            let (folder, observer) = (&mut *self.folder, self.observer);
            let mut forced = false;
            if recalled {
                self.clock.time(Stage::Verify, || {
                    verify::places(&plan, &setup.blade, &setup.verify_options(), &mut report);
                    Ok(())
                })?;
            }
            if let Some(verified) = accept(verdict, course.force) {
                forced = verified.forced();
                let posted = self.clock.time(Stage::Post, || post_all(setup, &verified, folder))?;
                report.checks.extend(posted.checks);
                summary.programs = posted.figures;
            }
            let others = self.clock.time(Stage::Schedule, || Ok(look::others(setup, &plan)))?;
            let (baseline, others, report) = (Some(baseline), &others[..], &report);
            let look = Look { sections, baseline, others, report, forced, budget_bytes: course.preview_bytes };
            let summary = look::json_of(&summary)?;
            self.clock.time(Stage::Preview, || look::write(setup, &plan, &look, &summary, folder, observer))?;
        }
        self.folder.add_json("summary.json", &summary)?;
        self.folder.add_json("verify.json", &report)?;
        Ok(Checked { summary: Some(summary), report, plan, seal, recalled })
    }

    /// The verdict with its seal, and whether it was recalled from an earlier run that was about the very same.
    fn check(&mut self, plan: Plan, plan_json: &str, before: Option<Checks>) -> Result<(Verdict<Plan>, String, bool)> {
        let (setup, options) = (self.setup, self.setup.verify_options());
        let part = reuse::part(setup);
        let about = Subject { part: &part, tool: &setup.job.tool, machine: &setup.machine, options: &options };
        let plan = match before {
            None => plan,
            Some(b) => match seal::recall(plan, plan_json, b.report, &b.seal, &about)? {
                Ok(verdict) => return Ok((verdict, b.seal, true)),
                Err(plan) => plan,
            },
        };
        let verdict = self.clock.time(Stage::Verify, || verdict(setup, plan, self.observer))?;
        let seal = seal::seal(plan_json, verdict.report(), &about)?;
        Ok((verdict, seal, false))
    }
}

/// A plan judged by all checks.
pub(super) fn verdict(setup: &Setup, plan: Plan, observer: &dyn Observer) -> Result<Verdict<Plan>> {
    let (blade, tool, options) = (&setup.blade, &setup.job.tool, setup.verify_options());
    verify::check_among(plan, blade, &setup.obstacles, tool, &setup.machine, &options, observer)
}
