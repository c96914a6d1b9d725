//! `[orientation]` of the job file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::settings::section;

/// Which tool axes the schedule may choose from at each location.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OrientationKind {
    /// The cone about the blade axis with lean `machine.b_deg`: four axes, for roots.
    #[default]
    Cone,
    /// The plane through the blade's radial direction and the surface normal, a new one at each
    /// location (Chen, Xu and Tang 2015).
    ReferencePlane,
    /// Any: a smooth field of axes in the middle of what is free among the blades of the wheel.
    FiveAxis,
}

impl OrientationKind {
    /// The tool axis turns round the blade with the path, and never back.
    pub fn goes_round(self) -> bool {
        self == OrientationKind::Cone
    }
}

section! {
    /// `[orientation]`
    #[derive(Copy)]
    "orientation" OrientationSettings, OrientationKeys, s {
        /// Which tool axes the schedule may choose from at each location.
        kind: OrientationKind = OrientationKind::Cone;
        /// Angle between the directions that kind `five-axis` tries at a place, degrees.
        ///
        /// The free axes of a wheel are some tens of degrees wide: a tenth of that finds the ways
        /// through. Where it finds none, half of it is tried, and so on down to 1°. What is tried
        /// only guides the search, the channel is proven afterwards.
        grid_deg: f64 = 3.0, 1.0..=15.0;
        /// Whether the tool may leave the blade where no axis leads on, and come back to the same
        /// place with another: kind `five-axis`. The plan says how often it does.
        links: bool = true;
    }
}

impl OrientationSettings {
    /// As in a job that says nothing of it.
    pub fn is_usual(&self) -> bool {
        *self == OrientationSettings::default()
    }
}
