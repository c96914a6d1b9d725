//! What people look at: `preview.glb` and `report.html`, from a run or from its files.

use serde_json::Value;

use super::{Baseline, Setup, compare, post_all_checks};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{CheckReport, Plan, Schedule, Section};
use crate::error::{Error, Result, Stage};
use crate::feed;
use crate::observe::{Observer, Recorder};
use crate::output::RunFolder;
use crate::output::summary::{self, Summary};
use crate::preview::drawing::{self, PlotInput};
use crate::preview::report::{self, File, ReportInput};
use crate::preview::{self, GltfOptions, Scene};
use crate::schedule;
use crate::section;
use crate::verify::Verdict;

/// What is shown beside the plan.
pub(super) struct Look<'a> {
    /// Plane sections.
    pub sections: &'a [Section],
    /// The fixed lead.
    pub baseline: &'a Baseline,
    /// Figures of the run.
    pub summary: &'a Summary,
    /// All checks, those of the programs among them.
    pub report: &'a CheckReport,
    /// Programs were written although checks failed.
    pub forced: bool,
    /// Most bytes of preview.glb.
    pub budget_bytes: Option<usize>,
}

/// The JSON that a file of the run holds.
fn json_of(value: &impl serde::Serialize) -> Result<Value> {
    serde_json::to_value(value)
        .map_err(|e| Error::io(Stage::Preview, format!("the report's figures cannot be encoded: {e}")).caused_by(e))
}

/// Writes both files.
pub(super) fn write(
    setup: &Setup,
    plan: &Plan,
    look: &Look,
    folder: &mut RunFolder,
    observer: &Recorder,
) -> Result<()> {
    let (summary, verify) = (json_of(look.summary)?, json_of(look.report)?);
    let compared = compared(folder, look.summary);
    write_from(setup, plan, look, [&summary, &verify], compared.as_ref(), folder, observer)
}

/// `compare.json` of the folder, if it is of this path.
fn compared(folder: &RunFolder, summary: &Summary) -> Option<Value> {
    let found: Value = serde_json::from_str(&folder.existing("compare.json")?).ok()?;
    let same = found["cutter_locations"].as_u64() == Some(summary.cutter_locations as u64)
        && found["path_length_mm"].as_f64() == Some(summary.path_length_mm);
    same.then_some(found)
}

fn write_from(
    setup: &Setup,
    plan: &Plan,
    look: &Look,
    [summary, verify]: [&Value; 2],
    compared: Option<&Value>,
    folder: &mut RunFolder,
    observer: &Recorder,
) -> Result<()> {
    let (blade, tool, machine) = (&setup.blade, &setup.job.tool, &setup.machine);
    let mut options = GltfOptions::default();
    options.budget_bytes = look.budget_bytes.unwrap_or(options.budget_bytes);
    let scene = Scene {
        blade,
        tool,
        machine,
        plan: Some(plan),
        sections: look.sections,
        checks: Some(look.report),
        figures: Some(summary),
        options: &options,
    };
    folder.add("preview.glb", preview::gltf(&scene)?)?;
    observer.progress(Stage::Preview, 1, 2);
    let model = &setup.inputs[0];
    let mut provenance = vec![
        ("Program".to_owned(), super::program()),
        ("Model".to_owned(), setup.post_options().part_file),
        ("BLAKE3 of the model".to_owned(), model.blake3.clone()),
    ];
    for input in setup.inputs.iter().skip(1) {
        let name = std::path::Path::new(&input.path).file_name().map(|n| n.to_string_lossy().into_owned());
        provenance.push((format!("BLAKE3 of {}", name.unwrap_or_default()), input.blake3.clone()));
    }
    let fixed =
        report::Baseline { name: "fixed lead", schedule: &look.baseline.schedule, motion: Some(&look.baseline.motion) };
    let made = others(setup, plan);
    let mut others = vec![fixed];
    others.extend(made.iter().map(|(name, schedule)| report::Baseline { name, schedule, motion: None }));
    let page = report::html(&ReportInput {
        title: &blade.name,
        blade,
        tool,
        machine,
        plan: Some(plan),
        baseline: Some(fixed),
        others: &others,
        summary: File { name: "summary", json: summary },
        verify: File { name: "verify", json: verify },
        compare: compared.map(|json| File { name: "compare", json }),
        sections: look.sections,
        checks: Some(look.report),
        forced: look.forced,
        warnings: &observer.warnings(),
        job_toml: &setup.job.to_toml()?,
        provenance: &provenance,
    })?;
    folder.add("report.html", page)?;
    observer.progress(Stage::Preview, 2, 2);
    Ok(())
}

/// The schedules that cost next to nothing, beside the one in use; one that cannot be made here is left out.
fn others(setup: &Setup, plan: &Plan) -> Vec<(&'static str, Schedule)> {
    let kinds = [("quaternion", ScheduleKind::Quaternion), ("piecewise", ScheduleKind::Piecewise)];
    let options = setup.schedule_options();
    let make = |kind| schedule::plan(kind, &plan.toolpath, &plan.channel, &options, &crate::observe::Silent).ok();
    let wanted = kinds.into_iter().filter(|(_, kind)| *kind != plan.schedule.kind);
    wanted.filter_map(|(name, kind)| Some((name, make(kind)?))).collect()
}

/// preview.glb and report.html of a plan taken up again: sections, the fixed-lead baseline and the figures are made anew; paths of
/// other kinds are taken from the summary that is there.
///
/// # Errors
/// Those of the stages.
pub fn preview_again(
    setup: &Setup,
    verdict: &Verdict<Plan>,
    budget_bytes: Option<usize>,
    folder: &mut RunFolder,
    observer: &dyn Observer,
) -> Result<()> {
    let recorder = Recorder::new(observer);
    let sections = section::plan(&setup.blade, &setup.section_options(), &recorder)?;
    let plan = verdict.value();
    let baseline = fixed_lead(setup, plan, &recorder)?;
    let mut report = verdict.report().clone();
    if let Verdict::Passed(verified) = verdict {
        report.checks.extend(post_all_checks(setup, verified)?);
    }
    let figures = compare(setup, plan, &baseline)?;
    let summary = summary::summary(&setup.blade.name, plan, &report, figures);
    let (mut shown, verify) = (json_of(&summary)?, json_of(&report)?);
    let before = folder.existing("summary.json").and_then(|t| serde_json::from_str::<Value>(&t).ok());
    if let Some(paths) = before.as_ref().and_then(|b| b.get("other_paths")) {
        shown["other_paths"] = paths.clone();
    }
    let compared = compared(folder, &summary);
    let look = Look {
        sections: &sections,
        baseline: &baseline,
        summary: &summary,
        report: &report,
        forced: false,
        budget_bytes,
    };
    write_from(setup, plan, &look, [&shown, &verify], compared.as_ref(), folder, &recorder)
}

/// The fixed lead on the plan's path.
fn fixed_lead(setup: &Setup, plan: &Plan, observer: &dyn Observer) -> Result<Baseline> {
    let options = setup.schedule_options();
    let schedule = schedule::plan(ScheduleKind::Fixed, &plan.toolpath, &plan.channel, &options, observer)?;
    let motion = feed::plan(&plan.toolpath, &schedule, &setup.machine, &setup.feed_options(), observer)?;
    Ok(Baseline { schedule, motion })
}

/// The report's plots of a turn, as names and SVG texts.
///
/// # Errors
/// Those of the stages; `Usage` where there is no such turn.
pub fn plots(
    setup: &Setup,
    verdict: &Verdict<Plan>,
    turn: usize,
    observer: &dyn Observer,
) -> Result<Vec<(String, String)>> {
    let plan = verdict.value();
    let sections = section::plan(&setup.blade, &setup.section_options(), observer)?;
    let baseline = fixed_lead(setup, plan, observer)?;
    let fixed = report::Baseline { name: "fixed lead", schedule: &baseline.schedule, motion: Some(&baseline.motion) };
    let made = others(setup, plan);
    let mut shown = vec![fixed];
    shown.extend(made.iter().map(|(name, schedule)| report::Baseline { name, schedule, motion: None }));
    let input =
        PlotInput { plan, machine: &setup.machine, others: &shown, checks: verdict.report(), sections: &sections };
    drawing::plots(&input, turn)
}
