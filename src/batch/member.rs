//! One member of a family: its blade, its job, and the parameters that tell it apart.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::design;
use crate::error::{Error, Result, Stage};
use crate::job::JobFile;
use crate::make::BladeDesign;

/// Where a member's blade comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum BladeSource {
    /// A model file, absolute.
    Model(PathBuf),
    /// The generator.
    Design(Box<BladeDesign>),
}

/// One member of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// Its name, that of its folder too.
    pub name: String,
    /// Its blade.
    pub source: BladeSource,
    /// Name of a made blade: the member's, without what varies the job alone, since members that
    /// differ by that have one blade.
    pub blade: String,
    /// Its job as typed; paths in it are absolute, `model.file` is left out.
    pub job: JobFile,
    /// The parameters by which the family file tells it apart.
    pub parameters: BTreeMap<String, serde_json::Value>,
}

/// Sets one parameter of a member.
pub(super) fn set(member: &mut Member, key: &str, value: &toml::Value) -> Result<()> {
    let wrong = |why: String| Error::usage(Stage::Batch, format!("parameter `{key}`: {why}"));
    let parts: Vec<&str> = key.split('.').map(str::trim).collect();
    let Some((section, rest)) = parts.split_first().filter(|(_, rest)| !rest.is_empty()) else {
        return Err(wrong("unknown; a parameter is a section and a name, as tool.radius_mm".into()));
    };
    if parts.iter().any(|p| p.is_empty()) || key == "model.file" || key == "design.name" {
        return Err(wrong("this cannot be varied; models are named by `models` or by a column `model`".into()));
    }
    match (*section, &mut member.source) {
        ("design" | "vary", BladeSource::Design(d)) => design::set(d, section, rest, value).map_err(wrong)?,
        ("design" | "vary", BladeSource::Model(_)) => {
            return Err(wrong("the member's blade is a model file, not a design of the generator".into()));
        }
        _ => member.job.set_value(&parts, value.clone()).map_err(|fault| wrong(fault.words))?,
    }
    let told = serde_json::to_value(value).map_err(|e| wrong(e.to_string()))?;
    member.parameters.insert(key.to_owned(), told);
    Ok(())
}
