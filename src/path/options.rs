//! Options of the path stage.

use super::settings::PathSettings;
use crate::artifact::region::Extent;
use crate::machine::MachineSettings;
use crate::settings::with_settings;

/// What the helix should be.
#[derive(Clone, Debug, PartialEq)]
pub struct PathOptions {
    /// What the job says of it. Where turns begin is said by `start_near`; `start` and `compare`
    /// are not looked at.
    pub settings: PathSettings,
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Turns begin at the altered point nearest to this point, blade frame, mm (on a convex
    /// airfoil, at the point nearest to it); `None`: where the path enters the greatest concave
    /// stretch.
    pub start_near: Option<[f64; 3]>,
    /// The region: the contour to go round, and from where to where, see [`super::plan`].
    pub extent: Extent,
    /// Lean of the tool axis over the plane square to the blade axis, towards the tip, rad: where
    /// the spindle's pivot stays. How turns lie does not depend on it.
    pub lean_rad: f64,
}

with_settings!(PathOptions, PathSettings);

impl PathOptions {
    /// Defaults for a ball radius and a scallop, with steps of at most a quarter of the radius.
    pub fn new(radius_mm: f64, scallop_mm: f64) -> Self {
        let usual = PathSettings::default();
        PathOptions {
            settings: PathSettings { scallop_mm, max_step_mm: usual.max_step_mm.min(0.25 * radius_mm), ..usual },
            radius_mm,
            start_near: None,
            extent: Extent::default(),
            lean_rad: MachineSettings::default().b_deg.to_radians(),
        }
    }
}
