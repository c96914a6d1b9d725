//! From a plan to its verdict and files.

use super::course::forced;
use super::figures::figures;
use super::inputs::Loaded;
use super::look::{self, Look};
use super::reuse::{self, Checks};
use super::summary::{self, ProgramFigures, Summary};
use super::{Course, RunFolder, json_compact, tables};
use crate::artifact::report::Check;
use crate::artifact::{CheckReport, Plan, Program, Section};
use crate::error::{Result, Stage};
use crate::observe::{Recorder, timed};
use crate::plan::{Baseline, Setup};
use crate::verify::seal;
use crate::verify::{self, Verdict, Verified};

/// What checking and writing came to.
pub(super) struct Checked {
    pub summary: Option<Summary>,
    pub report: CheckReport,
    pub verdict: Verdict<Plan>,
    pub seal: String,
    /// The verdict is an earlier run's.
    pub recalled: bool,
}

/// What the stages of a run share.
pub(super) struct RunAtWork<'a, 'b> {
    pub loaded: &'a Loaded,
    pub course: Course,
    pub folder: &'a mut RunFolder,
    pub observer: &'a Recorder<'b>,
}

impl RunAtWork<'_, '_> {
    /// Checks the plan and writes all that follows from it.
    pub fn check_and_write(
        &mut self,
        sections: &[Section],
        plan: Plan,
        baseline: &Baseline,
        before: Option<Checks>,
    ) -> Result<Checked> {
        let (setup, course) = (&self.loaded.setup, self.course);
        self.folder.add("cutter_locations.csv", tables::cutter_locations(&setup.blade, &plan))?;
        self.folder.add("axes.csv", tables::axes(&plan, setup.machine.axes()))?;
        let plan_json = json_compact(&plan)?;
        self.folder.add("plan.json", &plan_json)?;
        let (verdict, seal, recalled) = self.check(plan, &plan_json, before)?;
        let mut report = verdict.report().clone();
        let verdict = if course.force { forced(verdict) } else { verdict };
        let plan = verdict.value();
        let mut summary = figures(setup, plan, &report, baseline, self.observer)?;
        if !course.ends_at(Stage::Verify) {
            let (folder, observer) = (&mut *self.folder, self.observer);
            let (mut forced, mut program) = (false, None);
            if recalled {
                timed(observer, Stage::Verify, || {
                    verify::places(plan, &setup.blade, &setup.job.tool, &setup.verify_options(), &mut report);
                });
            }
            if let Verdict::Passed(verified) = &verdict {
                forced = verified.forced();
                let posted = timed(self.observer, Stage::Post, || post_all(setup, verified, folder))?;
                report.checks.extend(posted.checks);
                summary.programs = posted.figures;
                program = posted.first;
            }
            let others = timed(observer, Stage::Schedule, || look::others(setup, plan));
            let (baseline, others, report) = (Some(baseline), &others[..], &report);
            let (inputs, budget_bytes) = (&self.loaded.inputs[..], course.preview_bytes);
            let program = program.as_ref();
            let look =
                Look { sections, inputs, baseline, others, report, forced, program, budget_bytes, payload: None };
            let summary = look::json_of(&summary)?;
            timed(self.observer, Stage::Preview, || look::write(setup, plan, &look, &summary, folder, observer))?;
        }
        self.folder.add_json("summary.json", &summary)?;
        self.folder.add_json("verify.json", &report)?;
        Ok(Checked { summary: Some(summary), report, verdict, seal, recalled })
    }

    /// The verdict with its seal, and whether it was recalled from an earlier run that was about
    /// the very same.
    fn check(&mut self, plan: Plan, plan_json: &str, before: Option<Checks>) -> Result<(Verdict<Plan>, String, bool)> {
        let setup = &self.loaded.setup;
        let about = reuse::subject(self.loaded);
        let plan = match before {
            None => plan,
            Some(b) => match seal::recall(plan, plan_json, b.report, &b.seal, &about)? {
                Ok(verdict) => return Ok((verdict, b.seal, true)),
                Err(plan) => plan,
            },
        };
        let verdict = timed(self.observer, Stage::Verify, || setup.verdict(plan, self.observer))?;
        let seal = seal::seal(plan_json, verdict.report(), &about)?;
        Ok((verdict, seal, false))
    }
}

/// What writing all programs came to.
#[derive(Default)]
pub(super) struct Posted {
    /// Of their reading back.
    pub checks: Vec<Check>,
    /// Those that were written.
    pub figures: Vec<ProgramFigures>,
    /// The first of them.
    pub first: Option<Program>,
}

/// Writes all programs. One that does not come back as the plan is not written.
pub(super) fn post_all(setup: &Setup, verified: &Verified<Plan>, folder: &mut RunFolder) -> Result<Posted> {
    let mut posted = Posted::default();
    for (name, dialect) in setup.dialects()? {
        let (program, checks) = setup.program(&dialect, verified)?;
        if checks.iter().all(|c| c.passed) {
            posted.figures.push(summary::program_figures(&program));
            folder.add_program(&program.file_name, &program.text, &name)?;
            posted.first.get_or_insert(program);
        }
        posted.checks.extend(checks);
    }
    Ok(posted)
}
