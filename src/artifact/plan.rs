//! Everything that a program is made from, bundled for the checks.
use super::{AxisMotion, Channel, Schedule, Toolpath};

/// A complete plan, one row of each part per cutter location.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Plan {
    /// Cutter locations.
    pub toolpath: Toolpath,
    /// What the tool axis may do.
    pub channel: Channel,
    /// What it does.
    pub schedule: Schedule,
    /// What the machine's axes do.
    pub motion: AxisMotion,
}
