//! The job file as typed: every key optional, unknown keys refused, units in the names.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::sections::{FixtureKeys, ModelKeys, RegionKeys, ToolKeys};
use crate::channel::ChannelKeys;
use crate::feed::FeedKeys;
use crate::machine::MachineKeys;
use crate::path::PathKeys;
use crate::schedule::ScheduleKeys;
use crate::section::SectionKeys;
use crate::verify::VerifyKeys;
use crate::write::post::PostKeys;

/// The job file. A key that is left out takes its default (see [`super::Job`]); a section that is left out, all of its.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobFile {
    /// The CAD file and how to read it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<ModelKeys>,
    /// Where to machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<RegionKeys>,
    /// The tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<ToolKeys>,
    /// What else is in the tool's way; entries of a list.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fixture: Option<Vec<FixtureKeys>>,
    /// Material that is still to be cut away.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stock: Option<FixtureKeys>,
    /// The helix.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathKeys>,
    /// What the tool axis may do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<ChannelKeys>,
    /// The machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub machine: Option<MachineKeys>,
    /// What the tool axis does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub schedule: Option<ScheduleKeys>,
    /// How fast.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<FeedKeys>,
    /// Programs to write.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub post: Option<PostKeys>,
    /// Limits of the checks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verify: Option<VerifyKeys>,
    /// Sections to report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub section: Option<SectionKeys>,
}
