//! Evidence that outlives its run: a report sealed together with everything that it is about.
//!
//! Checks follow from the plan, the part, the tool, the machine and the options alone. A seal is
//! the BLAKE3 hash of all of these and of the report. Whoever comes back with the same of each, to
//! the last bit, need not check again: the answer is in the report. A plan or a report that was
//! changed since, even in one digit, does not fit its seal and is checked anew. A seal guards
//! against change, not against forgers: it is no signature.

use super::verdict::Verdict;
use super::{VerifyOptions, well_formed};
use crate::artifact::{CheckReport, Plan};
use crate::error::{Error, Result, Stage};
use crate::machine::Machine;
use crate::tool::Tool;

/// What a report is about, besides the plan.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    /// Names the part and the program that checks: hashes of the model's files, how they were read,
    /// the version.
    pub part: String,
    /// The tool.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
    /// Limits and sampling.
    pub options: VerifyOptions,
}

/// The seal of a report; `plan_json` is the plan as [`crate::run::json_compact`] writes it.
///
/// # Errors
/// `InputOutput` where the report cannot be encoded.
pub fn seal(plan_json: &str, report: &CheckReport, about: &Subject) -> Result<String> {
    let report = serde_json::to_string(report)
        .map_err(|e| Error::io(Stage::Verify, format!("the report cannot be encoded: {e}")).caused_by(e))?;
    let mut hasher = blake3::Hasher::new();
    let about = format!("{}\n{:?}\n{:?}\n{:?}", about.part, about.tool, about.machine, about.options);
    for text in [plan_json, &report, &about] {
        hasher.update(&(text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    }
    Ok(hasher.finalize().to_hex().to_string())
}

/// The verdict of checks made before, if `seal` is that of this report about this plan; else the
/// plan again. Places that stay uncut are not in the report: their area and height are.
///
/// # Errors
/// As [`seal`].
pub fn recall(
    plan: Plan,
    plan_json: &str,
    report: CheckReport,
    sealed: &str,
    about: &Subject,
) -> Result<std::result::Result<Verdict<Plan>, Plan>> {
    let fits = well_formed(&plan, about.machine).is_ok()
        && !report.checks.is_empty()
        && seal(plan_json, &report, about)? == sealed;
    Ok(if fits { Ok(Verdict::of(plan, report)) } else { Err(plan) })
}
