//! A job in, the files of a run out.

use std::path::{Path, PathBuf};

use super::checking::RunAtWork;
use super::course::{Course, Made, forced};
use super::figures::figures;
use super::folder::RunFolder;
use super::inputs::Loaded;
use super::manifest::{self, Clock, Manifest, SCHEMA_VERSION, StageRecord};
use super::reuse::{self, Earlier};
use super::summary::{self, StoppedFigures, Summary};
use super::{build, program, repost};
use crate::artifact::program::Control;
use crate::artifact::{CheckReport, Plan};
use crate::error::{Error, Result, Stage};
use crate::job::Draft;
use crate::observe::{Observer, Recorder, Warning, timed};
use crate::plan::Setup;
use crate::plan::planning::{self, KnownStages, Reached};
use crate::section;
use crate::verify::Verdict;
use crate::write::post::Dialect;

/// What a run came to.
pub struct Outcome {
    /// Files written, in order.
    pub files: Vec<PathBuf>,
    /// The job, complete, with its tool, blade and machine.
    pub setup: Setup,
    /// Figures, where the run went far enough.
    pub summary: Option<Summary>,
    /// Figures of what there is, where the run was stopped after its path or later.
    pub stopped: Option<StoppedFigures>,
    /// What the checks found, where the run went far enough.
    pub report: Option<CheckReport>,
    /// The plan with its verdict, where the run went far enough. A plan that fails its checks and
    /// was forced counts as passed, marked as forced.
    pub verdict: Option<Verdict<Plan>>,
    /// What the user should know.
    pub warnings: Vec<Warning>,
    /// Time and memory of each stage that was worked on.
    pub stages: Vec<StageRecord>,
    /// Stages whose results were taken over from earlier runs.
    pub taken: Vec<Stage>,
}

/// Plans, checks and writes everything.
///
/// # Errors
/// The first stage's that fails; nothing is written then.
pub fn run(draft: &Draft, out: &Path, course: Course, observer: &dyn Observer) -> Result<Outcome> {
    run_on(draft, out, course, &[], observer)
}

/// As [`run`]; stages whose inputs are those of an earlier run are taken over from it. The files
/// are the same, but for the times in `manifest.json`.
///
/// # Errors
/// As [`run`].
pub fn run_on(
    draft: &Draft,
    out: &Path,
    course: Course,
    earlier: &[Earlier],
    observer: &dyn Observer,
) -> Result<Outcome> {
    let clock = Clock::new(observer);
    let recorder = Recorder::new(&clock);
    let programs = Control::ALL.iter().map(|c| Ok(Dialect::built_in(*c)?.file_name().to_owned()));
    let mut folder = RunFolder::begin_run(out, programs.collect::<Result<_>>()?)?;
    let loaded = timed(&recorder, Stage::Model, || Loaded::read(draft, &recorder))?;
    let setup = &loaded.setup;
    folder.add_job(&setup.job.to_toml()?)?;
    let mut run = RunAtWork { loaded: &loaded, course, folder: &mut folder, observer: &recorder };
    let made = match repost::again(&mut run, earlier)? {
        Some(made) => made,
        None => make(&mut run, earlier)?,
    };
    let status = match (&made.report, course.until) {
        (Some(r), None) if !r.passed() => reuse::FINDINGS.to_owned(),
        (_, until) => until.map_or_else(|| reuse::GOOD.to_owned(), |s| format!("until {s}")),
    };
    let job = serde_json::to_value(&setup.job)
        .map_err(|e| Error::io(Stage::Output, format!("the job cannot be written as JSON: {e}")).caused_by(e))?;
    folder.add_json(
        manifest::FILE,
        &Manifest {
            schema_version: SCHEMA_VERSION,
            program: program(),
            build: build().to_owned(),
            inputs: loaded.inputs.clone(),
            job,
            stages: if course.timeless { Vec::new() } else { clock.records() },
            warnings: recorder.warnings(),
            seal: made.seal,
            outputs: folder.hashes().clone(),
            programs: folder.programs().clone(),
            status,
        },
    )?;
    let Made { summary, stopped, report, verdict, taken, .. } = made;
    Ok(Outcome {
        files: folder.finish()?,
        setup: loaded.setup,
        summary,
        stopped,
        report,
        verdict,
        warnings: recorder.warnings(),
        stages: clock.records(),
        taken,
    })
}

/// Plans and checks without a folder: nothing is written, and no program is made.
///
/// # Errors
/// The first stage's that fails.
pub fn in_memory(draft: &Draft, force: bool, observer: &dyn Observer) -> Result<Outcome> {
    let clock = Clock::new(observer);
    let recorder = Recorder::new(&clock);
    let setup = timed(&recorder, Stage::Model, || Loaded::read(draft, &recorder))?.setup;
    let Reached::Motion(planned) = planning::stages(&setup, None, KnownStages::default(), &recorder)? else {
        return Err(Error::usage(Stage::Feed, "planning ended before the motion"));
    };
    let (plan, baseline) = *planned;
    let verdict = timed(&recorder, Stage::Verify, || setup.verdict(plan, &recorder))?;
    let verdict = if force { forced(verdict) } else { verdict };
    let report = verdict.report().clone();
    let summary = figures(&setup, verdict.value(), &report, &baseline, &recorder)?;
    Ok(Outcome {
        files: Vec::new(),
        setup,
        summary: Some(summary),
        stopped: None,
        report: Some(report),
        verdict: Some(verdict),
        warnings: recorder.warnings(),
        stages: clock.records(),
        taken: Vec::new(),
    })
}

/// All stages after the model, as far as the course goes.
fn make(run: &mut RunAtWork, earlier: &[Earlier]) -> Result<Made> {
    let (setup, observer) = (&run.loaded.setup, run.observer);
    let sections = timed(observer, Stage::Section, || section::plan(&setup.blade, &setup.section_options(), observer))?;
    run.folder.add_json("sections.json", &sections)?;
    let mut made = Made::default();
    if run.course.ends_at(Stage::Section) {
        return Ok(made);
    }
    let known = reuse::take(run.loaded, earlier, observer);
    made.taken = known.stages;
    let reached = planning::stages(setup, run.course.until, known.results, observer)?;
    made.stopped = write_as_far(&reached, run.folder)?;
    if let Reached::Motion(planned) = reached {
        let (plan, baseline) = *planned;
        let checked = run.check_and_write(&sections, plan, &baseline, known.checks)?;
        made.taken.extend(checked.recalled.then_some(Stage::Verify));
        (made.summary, made.report, made.verdict) = (checked.summary, Some(checked.report), Some(checked.verdict));
        made.seal = Some(checked.seal);
    }
    Ok(made)
}

/// Writes what was planned where planning stopped early, with its figures; a whole plan is written
/// with its checks.
fn write_as_far(reached: &Reached, folder: &mut RunFolder) -> Result<Option<StoppedFigures>> {
    let (path, channel, schedule) = match reached {
        Reached::Path(path) => (path, None, None),
        Reached::Channel(path, channel) => (path, Some(channel), None),
        Reached::Schedule(all) => (&all.0, Some(&all.1), Some(&all.2)),
        Reached::Motion(..) => return Ok(None),
    };
    folder.add_json("toolpath.json", path)?;
    channel.map_or(Ok(()), |c| folder.add_json("channel.json", c))?;
    schedule.map_or(Ok(()), |s| folder.add_json("schedule.json", s))?;
    Ok(Some(summary::stopped(path, channel, schedule)))
}
