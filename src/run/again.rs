//! A finished run taken up again from its folder, and the files in it judged: others act on every
//! one of them.
//!
//! | check | what it counts |
//! | --- | --- |
//! | `files` | files of the run that are missing, or whose content is not that which the manifest names |
//! | `inputs` | files that the run was made from (model, machine, post files, fixtures) that are not as they were |
//! | `table-cutter-locations`, `table-axes` | cells of the tables that are not what the plan gives |
//!
//! Hashes reveal a change but not a forger, who can change them as well. So the plan is judged by
//! itself ([`crate::verify`]), and tables and programs are judged against it.

use std::path::Path;

use super::inputs::{self, Loaded};
use super::manifest::{self, Input, Manifest};
use super::reuse::{self, Checks, Earlier};
use super::{RunFolder, programs_again, settle, tables};
use crate::artifact::report::Check;
use crate::artifact::{CheckId, CheckReport, Plan};
use crate::error::{Error, Result, Stage};
use crate::files;
use crate::observe::Observer;
use crate::plan::{self, Setup};
use crate::verify::seal;
use crate::verify::{self, Verdict};

/// A finished run, its plan not checked yet.
pub struct Finished {
    /// Job, blade, machine, and the files that these were read from.
    pub loaded: Loaded,
    /// The plan; where its `cutter_locations.csv` differs, with the locations of that table: other
    /// programs read it, so it must be checked.
    pub plan: Plan,
    /// What was found on the files of the folder.
    pub checks: Vec<Check>,
    /// The run came to its end without a finding, so that it wrote all programs.
    pub wrote_programs: bool,
    /// The run was stopped before programs were written.
    pub stopped: bool,
    /// Where every file is as the run left it.
    evidence: Option<Evidence>,
}

/// The text of a plan, and what the run found by its checks.
struct Evidence {
    plan_json: String,
    checks: Checks,
}

/// What the run of a folder found by its checks; `None` where another build made it, for another
/// job, or its report cannot be read.
fn checks_of(out: &Path, loaded: &Loaded) -> Option<Checks> {
    let earlier = Earlier::open(Box::new(|name| files::read(&out.join(name), files::LONG).ok()))?;
    if earlier.differs_by_post_alone(loaded) { earlier.checks() } else { None }
}

/// A finished run with its verdict: of the plan, and of the files that others read.
pub struct Checked {
    /// Job, blade, machine, and the files that these were read from.
    pub loaded: Loaded,
    /// The verdict on the plan.
    pub verdict: Verdict<Plan>,
    /// What was found on the files of the folder: no matter of the plan, so it is not in the
    /// headers of its programs.
    pub files: Vec<Check>,
    /// The run is to have its programs: it was not stopped before, and it was good or is.
    pub wrote_programs: bool,
    /// The verdict is that of the run.
    pub recalled: bool,
}

impl Finished {
    /// Checks the plan.
    ///
    /// # Errors
    /// Those of [`Setup::verdict`].
    pub fn check(self, observer: &dyn Observer) -> Result<Checked> {
        let Finished { loaded, plan, checks: files, wrote_programs, stopped, .. } = self;
        let verdict = loaded.setup.verdict(plan, observer)?;
        let wrote_programs = wrote_programs || (!stopped && matches!(verdict, Verdict::Passed(_)));
        Ok(Checked { loaded, verdict, files, wrote_programs, recalled: false })
    }

    /// The verdict of the run itself, where every file is as that left it and the seal of its
    /// checks fits; else the plan is checked.
    ///
    /// # Errors
    /// Those of [`Finished::check`].
    pub fn recall(mut self, observer: &dyn Observer) -> Result<Checked> {
        let Some(Evidence { plan_json, checks: Checks { report, seal } }) = self.evidence.take() else {
            return self.check(observer);
        };
        let about = reuse::subject(&self.loaded);
        match seal::recall(self.plan, &plan_json, report, &seal, &about)? {
            Ok(verdict) => {
                let Finished { loaded, checks: files, wrote_programs, .. } = self;
                Ok(Checked { loaded, verdict, files, wrote_programs, recalled: true })
            }
            Err(plan) => Finished { plan, ..self }.check(observer),
        }
    }
}

impl Checked {
    /// All that the checks found: on the plan, on its programs, read back, and on the files of the
    /// folder. Those on the plan and its programs stand where a run has them.
    ///
    /// # Errors
    /// Those of [`programs_again`].
    pub fn report(self, folder: &RunFolder) -> Result<CheckReport> {
        let Checked { loaded, verdict, files, wrote_programs, .. } = self;
        let mut report = verdict.report().clone();
        if let Some(verified) = plan::accept(verdict, true) {
            report.checks.extend(programs_again(&loaded.setup, &verified, folder, wrote_programs)?.checks);
        }
        report.checks.extend(files);
        Ok(report)
    }
}

/// Reads the job of a folder, the model that it names, and the plan.
///
/// # Errors
/// `InputOutput` where the folder holds no run, or none with a plan; those of the job and of the
/// model.
pub fn read(out: &Path, observer: &dyn Observer) -> Result<Finished> {
    settle(out)?;
    let file = out.join("job.resolved.toml");
    if !file.is_file() {
        return Err(Error::io(
            Stage::Job,
            format!("{} holds no finished run: job.resolved.toml is missing", out.display()),
        )
        .advise("give the folder that `plan … -o` wrote"));
    }
    let kept = text_of(out, manifest::FILE).as_deref().and_then(manifest::read);
    let stopped = kept.as_ref().and_then(|m| m.status.strip_prefix("until ")).map(str::to_owned);
    let plan_file = out.join("plan.json");
    if let Some(stage) = stopped.as_ref().filter(|_| !plan_file.is_file()) {
        return Err(Error::io(
            Stage::Output,
            format!("the run in {} was stopped at {stage}: it has no plan yet", out.display()),
        )
        .advise("plan again without --until"));
    }
    let draft = inputs::draft(inputs::job(&file)?, out)?;
    let text = files::read_text(&plan_file, files::LONG)
        .map_err(|e| Error::io(Stage::Output, format!("cannot read {}: {e}", plan_file.display())).caused_by(e))?;
    let plan: Plan = serde_json::from_slice(text.as_bytes())
        .map_err(|e| Error::io(Stage::Output, format!("{} is damaged: {e}", plan_file.display())).caused_by(e))?;
    let loaded = Loaded::read(&draft, observer)?;
    verify::well_formed(&plan, &loaded.setup.machine)?;
    let mut checks = vec![outputs(out, kept.as_ref()), changed(&loaded.inputs, kept.as_ref())];
    let (plan, tables) = read_tables(out, &loaded.setup, plan);
    checks.extend(tables);
    let untouched = checks.iter().all(|c| c.passed).then(|| checks_of(out, &loaded)).flatten();
    let evidence = untouched.map(|checks| Evidence { plan_json: text, checks });
    let wrote_programs = kept.is_none_or(|m| m.status == reuse::GOOD);
    Ok(Finished {
        loaded,
        plan,
        checks,
        evidence,
        wrote_programs,
        stopped: stopped.is_some_and(|s| s == Stage::Verify.to_string()),
    })
}

fn text_of(out: &Path, name: &str) -> Option<String> {
    files::read_text(&out.join(name), files::LONG).ok()
}

/// The plan with what others read of it, and what is not as the plan has it.
fn read_tables(out: &Path, setup: &Setup, plan: Plan) -> (Plan, [Check; 2]) {
    let wanted = [tables::cutter_locations(&setup.blade, &plan), tables::axes(&plan, setup.machine.axes())];
    let names = [(CheckId::TableCutterLocations, "cutter_locations.csv"), (CheckId::TableAxes, "axes.csv")];
    let texts = names.each_ref().map(|(_, file)| text_of(out, file));
    let checks: [Check; 2] = std::array::from_fn(|k| {
        let (id, file) = names[k].clone();
        let difference = match &texts[k] {
            Some(text) => tables::difference(text, &wanted[k]),
            None => tables::Difference { count: 1, first: "it is missing, or no text".into() },
        };
        let note = if difference.count == 0 { file.to_owned() } else { format!("{file}, {}", difference.first) };
        count(id, &format!("cells of {file} that are not what the plan gives"), difference.count, note)
    });
    // The table that is the plan's holds the same locations, but for the rounding of their frame.
    if checks[0].passed {
        return (plan, checks);
    }
    let mut read = plan.clone();
    let is_read =
        texts[0].as_deref().is_some_and(|t| tables::read_cutter_locations(t, &setup.blade, &mut read).is_ok());
    // A table that cannot be read is among the findings.
    (if is_read { read } else { plan }, checks)
}

/// Files that are not as the run, or what was done in its folder since, left them.
fn outputs(out: &Path, kept: Option<&Manifest>) -> Check {
    let quantity = "files that are missing or not as the run left them";
    let Some(kept) = kept else {
        let note = "manifest.json is missing or damaged: what the run left is not known";
        return count(CheckId::Files, quantity, 1, note.into());
    };
    let short = |hash: &str| hash.chars().take(12).collect::<String>();
    let mut wrong = Vec::new();
    for (name, want) in &kept.outputs {
        match files::hash(&out.join(name), files::LONG) {
            Err(_) => wrong.push(format!("{name} is missing or cannot be read")),
            Ok((_, is)) if is != *want => {
                wrong.push(format!("{name} has BLAKE3 {}…, manifest.json names {}…", short(&is), short(want)));
            }
            Ok(_) => {}
        }
    }
    count(CheckId::Files, quantity, wrong.len(), wrong.join("; "))
}

/// Inputs that changed since.
fn changed(now: &[Input], kept: Option<&Manifest>) -> Check {
    let quantity = "input files that are not those of the run";
    let before = kept.map(|k| &k.inputs[..]).unwrap_or_default();
    let short = |i: &Input| i.blake3.chars().take(12).collect::<String>();
    let mut wrong: Vec<String> = now
        .iter()
        .zip(before)
        .filter(|(a, b)| a.blake3 != b.blake3)
        .map(|(a, b)| format!("{} has BLAKE3 {}…, manifest.json names {}…", a.path, short(a), short(b)))
        .collect();
    if now.len() != before.len() && kept.is_some() {
        wrong.push(format!("the job names {} input files, manifest.json {}", now.len(), before.len()));
    }
    count(CheckId::Inputs, quantity, wrong.len(), wrong.join("; "))
}

/// A check that nothing was found.
fn count(id: CheckId, quantity: &str, found: usize, note: String) -> Check {
    Check::at_most(id, quantity, found as f64, 0.0, "", note)
}
