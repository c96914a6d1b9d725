//! What is known of a finished member: `member.json`, the last file of its folder that is written.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::picture::Picture;
use crate::error::{Error, Infeasible, Missed, Stage};
use crate::run::{
    self,
    manifest::{self, Manifest},
};

/// How a member ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// Planned, checked, programs written.
    Good,
    /// Planned, but a check found something; no programs.
    Findings,
    /// No plan: see stage and reason.
    Failed,
    /// Not computed yet.
    Missing,
}

impl Status {
    /// The word in tables.
    pub fn word(self) -> &'static str {
        match self {
            Status::Good => "good",
            Status::Findings => "findings",
            Status::Failed => "failed",
            Status::Missing => "missing",
        }
    }
}

/// A finished member. Holds no times of computing, no dates, nothing of the machine that computed
/// it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its name.
    pub name: String,
    /// The address of what it was computed from.
    pub key: String,
    /// How it ended.
    pub status: Status,
    /// Exit code that `plan` would have had.
    pub exit_code: u8,
    /// The stage that failed or found something.
    pub stage: Option<Stage>,
    /// Why, in one sentence.
    pub reason: Option<String>,
    /// What stands in the way of a plan, as data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub infeasible: Option<Box<Infeasible>>,
    /// The checks that found something.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missed: Vec<Missed>,
    /// What to do about it.
    pub advice: Option<String>,
    /// The model's file name, or the generator.
    pub model: String,
    /// Parameters from the family file.
    pub parameters: BTreeMap<String, serde_json::Value>,
    /// Number of warnings.
    pub warnings: usize,
    /// Its other files with the BLAKE3 hashes of their content.
    pub files: BTreeMap<String, String>,
    /// All figures of `summary.json`; absent without a plan.
    pub summary: Option<serde_json::Value>,
    /// The narrowest turn of the channel; absent without a plan.
    pub picture: Option<Picture>,
}

impl Record {
    /// A member of which nothing is known yet.
    pub fn missing(name: &str, model: &str, parameters: &BTreeMap<String, serde_json::Value>) -> Self {
        Record {
            name: name.to_owned(),
            key: String::new(),
            status: Status::Missing,
            exit_code: 0,
            stage: None,
            reason: None,
            infeasible: None,
            missed: Vec::new(),
            advice: None,
            model: model.to_owned(),
            parameters: parameters.clone(),
            warnings: 0,
            files: BTreeMap::new(),
            summary: None,
            picture: None,
        }
    }

    /// A file's content as it was when the member was finished; `None` where it has been changed
    /// since. What was entered in the manifest for files that came later is left out.
    pub(super) fn as_written(&self, file: &str, content: Vec<u8>) -> Option<Vec<u8>> {
        let hash = self.files.get(file)?;
        let fits = |content: &[u8]| blake3::hash(content).to_hex().as_str() == hash;
        if fits(&content) {
            return Some(content);
        }
        if file != manifest::FILE {
            return None;
        }
        let mut manifest: Manifest = serde_json::from_slice(&content).ok()?;
        manifest.outputs.retain(|name, _| self.files.contains_key(name));
        manifest.programs.retain(|name, _| self.files.contains_key(name));
        let content = run::json(&manifest).ok()?.into_bytes();
        fits(&content).then_some(content)
    }

    /// The same member, failed.
    pub fn failed(self, key: &str, e: &Error) -> Self {
        Record {
            key: key.to_owned(),
            status: Status::Failed,
            exit_code: e.kind.exit_code(),
            stage: Some(e.stage),
            reason: Some(e.message.clone()),
            infeasible: e.infeasible.clone(),
            advice: e.advice.clone(),
            ..self
        }
    }
}
