//! What people look at: `preview.glb` and `report.html`, from a run or from its files.

use serde_json::Value;

use super::again::Checked;
use super::figures::compare;
use super::manifest::Input;
use super::{RunFolder, build, program, programs_again, summary};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{CheckReport, Plan, Program, Schedule, Section};
use crate::error::{Error, Result, Stage};
use crate::lead;
use crate::observe::{Observer, Recorder, Silent};
use crate::parallel;
use crate::plan::{Baseline, Setup, leads, sketch};
use crate::schedule;
use crate::section;
use crate::verify::Verdict;
use crate::write::draw::{self, PlotInput};
use crate::write::preview::report::{self, File, Payload, ReportInput};
use crate::write::preview::{self, GltfOptions, Scene};

/// A schedule for the same path that is shown beside the one in use, and its name.
pub(super) type Other = (&'static str, Schedule);

/// What is shown beside the plan.
pub(super) struct Look<'a> {
    /// Files that the run was made from: the model first.
    pub inputs: &'a [Input],
    /// Plane sections.
    pub sections: &'a [Section],
    /// The fixed lead; absent where the plots are an earlier run's.
    pub baseline: Option<&'a Baseline>,
    /// Other schedules.
    pub others: &'a [Other],
    /// All checks, those of the programs among them.
    pub report: &'a CheckReport,
    /// Programs were written although checks failed.
    pub forced: bool,
    /// The program whose lines are shown beside the tool.
    pub program: Option<&'a Program>,
    /// Most bytes of preview.glb.
    pub budget_bytes: Option<usize>,
    /// What the report's plots and its 3-D view show, where that is known.
    pub payload: Option<&'a Payload>,
}

/// The JSON that a file of the run holds.
pub(super) fn json_of(value: &impl serde::Serialize) -> Result<Value> {
    serde_json::to_value(value)
        .map_err(|e| Error::io(Stage::Preview, format!("the report's figures cannot be encoded: {e}")).caused_by(e))
}

/// Writes both files; `summary` is that of summary.json.
pub(super) fn write(
    setup: &Setup,
    plan: &Plan,
    look: &Look,
    summary: &Value,
    folder: &mut RunFolder,
    observer: &Recorder,
) -> Result<()> {
    // Figures of programs stand in the report only, where they can be written anew.
    let mut figures = summary.clone();
    figures.as_object_mut().map(|all| all.remove("programs"));
    let mut options = GltfOptions::default();
    options.budget_bytes = look.budget_bytes.unwrap_or(options.budget_bytes);
    let scene = Scene {
        blade: &setup.blade,
        obstacles: &setup.obstacles,
        tool: &setup.job.tool,
        machine: &setup.machine,
        plan: Some(plan),
        sections: look.sections,
        checks: Some(look.report),
        figures: Some(&figures),
        options: &options,
    };
    folder.add("preview.glb", preview::gltf(&scene)?)?;
    observer.progress(Stage::Preview, 1, 2);
    page(setup, plan, look, summary, folder, observer)
}

/// Writes the report.
pub(super) fn page(
    setup: &Setup,
    plan: &Plan,
    look: &Look,
    summary: &Value,
    folder: &mut RunFolder,
    observer: &Recorder,
) -> Result<()> {
    let verify = json_of(look.report)?;
    let compared = compared(folder, summary);
    if compared.is_some() {
        ["compare.json", "compare.csv", "compare.svg"].iter().for_each(|name| folder.keep(name));
    }
    let fixed = look.baseline.map(fixed_lead_of);
    let others: Vec<draw::OtherSchedule> = fixed.into_iter().chain(look.others.iter().map(shown)).collect();
    let widths = if setup.job.channel.sweep_b { setup.widths(plan, observer)? } else { Vec::new() };
    let free_axes = look.payload.is_none().then(|| setup.free_axes(plan, observer)).transpose()?;
    let input = ReportInput {
        title: &setup.blade.name,
        blade: &setup.blade,
        tool: &setup.job.tool,
        machine: &setup.machine,
        plan: Some(plan),
        baseline: fixed,
        others: &others,
        summary: File { name: "summary", json: summary },
        verify: File { name: "verify", json: &verify },
        compare: compared.as_ref().map(|json| File { name: "compare", json }),
        widths: &widths,
        obstacles: &setup.obstacles,
        free_axes: free_axes.as_ref(),
        sections: look.sections,
        checks: Some(look.report),
        forced: look.forced,
        program: look.program,
        warnings: &observer.warnings(),
        job_toml: &setup.job.to_toml()?,
        provenance: &provenance(setup, look.inputs),
    };
    let text = match look.payload {
        Some(payload) => report::page(&input, payload)?,
        None => report::html(&input)?,
    };
    folder.add("report.html", text)?;
    observer.progress(Stage::Preview, 2, 2);
    Ok(())
}

/// `compare.json` of the folder, if it is of this path.
fn compared(folder: &RunFolder, summary: &Value) -> Option<Value> {
    let found: Value = serde_json::from_str(&folder.existing("compare.json")?).ok()?;
    let same = |key: &str| found[key].is_number() && found[key] == summary[key];
    (same("cutter_locations") && same("path_length_mm")).then_some(found)
}

/// Where the run came from: labels and values.
pub(super) fn provenance(setup: &Setup, inputs: &[Input]) -> Vec<(String, String)> {
    let mut rows = vec![
        ("Program".to_owned(), program()),
        ("Build".to_owned(), build().to_owned()),
        ("Model".to_owned(), setup.post_options().part_file),
        ("BLAKE3 of the model".to_owned(), setup.part_hash.clone()),
    ];
    for input in inputs.iter().skip(1) {
        let name = std::path::Path::new(&input.path).file_name().map(|n| n.to_string_lossy().into_owned());
        rows.push((format!("BLAKE3 of {}", name.unwrap_or_default()), input.blake3.clone()));
    }
    rows
}

fn fixed_lead_of(baseline: &Baseline) -> draw::OtherSchedule<'_> {
    draw::OtherSchedule { name: "fixed lead", schedule: &baseline.schedule, motion: Some(&baseline.motion) }
}

fn shown((name, schedule): &Other) -> draw::OtherSchedule<'_> {
    draw::OtherSchedule { name, schedule, motion: None }
}

/// All kinds of schedules but the fixed lead and the one in use, the costly ones as sketches; one
/// that cannot be made here is left out.
pub(super) fn others(setup: &Setup, plan: &Plan) -> Vec<Other> {
    let kinds = [
        ("quaternion", ScheduleKind::Quaternion),
        ("piecewise", ScheduleKind::Piecewise),
        ("optimal (sketch)", ScheduleKind::Optimal),
        ("time (sketch)", ScheduleKind::Time),
    ];
    let (path, channel, options) = (&plan.toolpath, &plan.channel, setup.schedule_options());
    let make = |kind| match kind {
        ScheduleKind::Optimal | ScheduleKind::Time => sketch::sketch(kind, setup, path, channel),
        _ => schedule::plan(kind, path, channel, &options, &crate::observe::Silent).ok(),
    };
    let wanted = kinds.into_iter().filter(|(_, kind)| *kind != plan.schedule.kind);
    parallel::filter_map(wanted, |(name, kind)| Some((name, make(kind)?)))
}

/// preview.glb and report.html of a plan taken up again: sections, the fixed-lead baseline and the
/// figures are made anew; paths of other kinds and the figures of programs are taken from the
/// summary that is there.
///
/// # Errors
/// Those of the stages.
pub fn preview_again(
    run: &Checked,
    budget_bytes: Option<usize>,
    folder: &mut RunFolder,
    observer: &dyn Observer,
) -> Result<()> {
    let Checked { loaded, verdict, files, wrote_programs, .. } = run;
    let setup = &loaded.setup;
    let recorder = Recorder::new(observer);
    let sections = section::plan(&setup.blade, &setup.section_options(), &recorder)?;
    let plan = verdict.value();
    let baseline = fixed_lead(setup, plan, &recorder)?;
    let (mut report, mut program) = (verdict.report().clone(), None);
    if let Verdict::Passed(verified) = verdict {
        let again = programs_again(setup, verified, folder, *wrote_programs)?;
        report.checks.extend(again.checks);
        program = again.first;
    }
    // The page names places in `verify.json`. That has the checks of the folder's files, last, only
    // where the run was verified anew; what is wrong with files is shown in any case.
    let verified = folder.existing("verify.json").and_then(|t| serde_json::from_str::<CheckReport>(&t).ok());
    let judged = verified.is_some_and(|r| r.checks.iter().any(|c| c.id.is_of_files()));
    report.checks.extend(files.iter().filter(|c| judged || !c.passed).cloned());
    let figures = compare(setup, plan, &baseline)?;
    let figures = summary::summary(&setup.blade.name, plan, &report, figures, setup.machine.axes());
    let mut summary = json_of(&figures)?;
    let before = folder.existing("summary.json").and_then(|t| serde_json::from_str::<Value>(&t).ok());
    for key in ["other_paths", "programs"] {
        if let Some(known) = before.as_ref().and_then(|b| b.get(key)) {
            summary[key] = known.clone();
        }
    }
    let look = Look {
        sections: &sections,
        inputs: &loaded.inputs,
        baseline: Some(&baseline),
        others: &others(setup, plan),
        report: &report,
        forced: false,
        program: program.as_ref(),
        budget_bytes,
        payload: None,
    };
    write(setup, plan, &look, &summary, folder, &recorder)
}

/// The fixed lead on the plan's path. What a baseline that nobody asked for does wrong is no
/// warning.
fn fixed_lead(setup: &Setup, plan: &Plan, observer: &dyn Observer) -> Result<Baseline> {
    let options = setup.schedule_options();
    let schedule = schedule::plan(ScheduleKind::Fixed, &plan.toolpath, &plan.channel, &options, &Silent)?;
    let others = lead::for_schedule(&plan.leads, &plan.toolpath, &schedule);
    let (motion, _) = leads::motion(setup, &plan.toolpath, &schedule, None, others, observer)?;
    Ok(Baseline { schedule, motion })
}

/// The report's plots of a turn, which counts from 1, as names and SVG texts.
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
    let made = others(setup, plan);
    let shown: Vec<draw::OtherSchedule> =
        std::iter::once(fixed_lead_of(&baseline)).chain(made.iter().map(shown)).collect();
    let input =
        PlotInput { plan, machine: &setup.machine, others: &shown, checks: verdict.report(), sections: &sections };
    draw::plots(&input, turn)
}
