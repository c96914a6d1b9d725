//! A change of the post alone: programs are written and read back, the summary gets their times,
//! the report its new words; everything else is the earlier run's, byte for byte.
//!
//! Taken from a run that came to its end, by the same build, of the same inputs in all but
//! `[post]`, whose files are as it left them (the hashes are in its manifest) and whose checks fit
//! their seal. Where any of this is not so, the run is made in the ordinary way.

use super::checking::{RunAtWork, post_all};
use super::course::{Made, forced};
use super::look::{self, Look};
use super::reuse::{self, Earlier};
use super::summary::Summary;
use crate::artifact::Plan;
use crate::error::{Result, Stage};
use crate::observe::{Observer, timed};
use crate::verify::Verdict;
use crate::verify::seal;
use crate::write::preview::report::Payload;

/// Files that know nothing of the post.
const KEPT: [&str; 5] = ["sections.json", "cutter_locations.csv", "axes.csv", "plan.json", "preview.glb"];

/// Stages that need not be worked on.
const TAKEN: [Stage; 7] =
    [Stage::Section, Stage::Path, Stage::Channel, Stage::Schedule, Stage::Feed, Stage::Verify, Stage::Preview];

/// An earlier run but for its programs.
struct KeptRun {
    files: Vec<(&'static str, Vec<u8>)>,
    /// But for its programs.
    summary: Summary,
    verdict: Verdict<Plan>,
    seal: String,
    payload: Payload,
}

/// The run, if one of the earlier ones leaves only the programs to be written.
pub(super) fn again(run: &mut RunAtWork, earlier: &[Earlier]) -> Result<Option<Made>> {
    if run.course.until.is_some() || run.course.preview_bytes.is_some() {
        return Ok(None);
    }
    let fitting = earlier.iter().filter(|e| e.differs_by_post_alone(run.loaded));
    let Some((before, kept)) = fitting.filter_map(|e| Some((e, open(run, e)?))).next() else { return Ok(None) };
    // Those of the model were given when it was read.
    before.warnings().iter().filter(|w| w.stage != Stage::Model).for_each(|w| run.observer.warn(w.clone()));
    for (name, content) in &kept.files {
        run.folder.add(name, content)?;
    }
    let (setup, folder, observer) = (&run.loaded.setup, &mut *run.folder, run.observer);
    let verdict = if run.course.force { forced(kept.verdict) } else { kept.verdict };
    let (mut report, plan) = (verdict.report().clone(), verdict.value());
    let (mut forced, mut program) = (false, None);
    let mut summary = Summary { programs: Vec::new(), ..kept.summary };
    if let Verdict::Passed(verified) = &verdict {
        forced = verified.forced();
        let posted = timed(observer, Stage::Post, || post_all(setup, verified, folder))?;
        report.checks.extend(posted.checks);
        summary.programs = posted.figures;
        program = posted.first;
    }
    let inputs = &run.loaded.inputs[..];
    let look = Look {
        sections: &[],
        inputs,
        baseline: None,
        others: &[],
        report: &report,
        forced,
        program: program.as_ref(),
        budget_bytes: None,
        payload: Some(&kept.payload),
    };
    let shown = look::json_of(&summary)?;
    timed(observer, Stage::Preview, || look::page(setup, plan, &look, &shown, folder, observer))?;
    run.folder.add_json("summary.json", &summary)?;
    run.folder.add_json("verify.json", &report)?;
    Ok(Some(Made {
        summary: Some(summary),
        verdict: Some(verdict),
        report: Some(report),
        stopped: None,
        seal: Some(kept.seal),
        taken: TAKEN.to_vec(),
    }))
}

/// Everything that is taken over; `None` where something of it is not as that run left it.
fn open(run: &RunAtWork, earlier: &Earlier) -> Option<KeptRun> {
    let files: Vec<_> = KEPT.iter().map(|name| Some((*name, earlier.file(name)?))).collect::<Option<_>>()?;
    let text = |name: &str| files.iter().find(|f| f.0 == name).and_then(|f| std::str::from_utf8(&f.1).ok());
    let (plan_json, summary) = (text("plan.json")?, earlier.file("summary.json")?);
    let payload = Payload::of_page(std::str::from_utf8(&earlier.file("report.html")?).ok()?)?;
    let plan: Plan = serde_json::from_slice(plan_json.as_bytes()).ok()?;
    let checks = earlier.checks()?;
    let verdict = seal::recall(plan, plan_json, checks.report, &checks.seal, &reuse::subject(run.loaded)).ok()?.ok()?;
    let summary = serde_json::from_slice(&summary).ok()?;
    Some(KeptRun { verdict, seal: checks.seal, summary, payload, files })
}
