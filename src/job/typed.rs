//! The job file as typed: every key optional, unknown keys refused, units in the names.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::sections::{FixtureKeys, ModelKeys, RegionKeys, ToolKeys, WheelKeys};
use crate::channel::ChannelKeys;
use crate::feed::FeedKeys;
use crate::machine::MachineKeys;
use crate::orient::OrientationKeys;
use crate::pair::PinchKeys;
use crate::path::PathKeys;
use crate::schedule::ScheduleKeys;
use crate::section::SectionKeys;
use crate::tool::CutKeys;
use crate::verify::VerifyKeys;
use crate::write::post::PostKeys;

/// The job file. A key that is left out takes its default (see [`super::Job`]); a section that is
/// left out, all of its.
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
    /// The second of two tools on one blade, for `pinch`; keys that are left out are those of
    /// `[tool]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool_2: Option<ToolKeys>,
    /// What else is in the tool's way; entries of a list.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fixture: Option<Vec<FixtureKeys>>,
    /// Material that is still to be cut away.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stock: Option<FixtureKeys>,
    /// The wheel that the blade belongs to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<WheelKeys>,
    /// The helix.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathKeys>,
    /// Which tool axes there are to choose from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orientation: Option<OrientationKeys>,
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
    /// What each tooth cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cut: Option<CutKeys>,
    /// Two tools on one blade, for `pinch`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pinch: Option<PinchKeys>,
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

impl JobFile {
    /// The files that it names, as typed: the model first.
    pub(crate) fn files_mut(&mut self) -> impl Iterator<Item = &mut String> {
        let model = self.model.iter_mut().filter_map(|m| m.file.as_mut());
        let library = self.tool.iter_mut().chain(&mut self.tool_2).filter_map(|t| t.library.as_mut());
        let bodies = self.fixture.iter_mut().flatten().chain(&mut self.stock).filter_map(|f| f.file.as_mut());
        let machine = self.machine.iter_mut().filter_map(|m| m.file.as_mut());
        let posts = self.post.iter_mut().flat_map(|p| p.files.iter_mut().flatten());
        model.chain(library).chain(bodies).chain(machine).chain(posts)
    }
}
