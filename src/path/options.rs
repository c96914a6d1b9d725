//! Options of the path stage.

use super::settings::PathSettings;
use crate::artifact::Wheel;
use crate::artifact::region::Extent;
use crate::machine::MachineSettings;
use crate::settings::with_settings;
use crate::tool::inclination::Inclined;
use crate::tool::stepover::flat_stepover_mm;

/// What the helix should be.
#[derive(Clone, Debug, PartialEq)]
pub struct PathOptions {
    /// What the job says of it. Where turns begin is said by `start_near`; `start` and `compare`
    /// are not looked at.
    pub settings: PathSettings,
    /// Radius of the ball, or of the corner of a cutter that is none, mm.
    pub radius_mm: f64,
    /// A cutter with a corner of that radius, which leans forwards along the way; `None`: a ball.
    pub inclined: Option<Inclined>,
    /// Turns begin at the altered point nearest to this point, blade frame, mm (on a convex
    /// airfoil, at the point nearest to it); `None`: where the path enters the greatest concave
    /// stretch.
    pub start_near: Option<[f64; 3]>,
    /// The region: the contour to go round, and from where to where, see [`super::plan`].
    pub extent: Extent,
    /// The wheel over whose hub rows are to go; `None` for all other kinds of path.
    pub hub_of: Option<Wheel>,
    /// What the ball keeps from a hub that is given by its contour alone, mm; `None` where the part
    /// has its hub.
    pub hub_clearance_mm: Option<f64>,
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
            inclined: None,
            start_near: None,
            extent: Extent::default(),
            hub_of: None,
            hub_clearance_mm: None,
            lean_rad: MachineSettings::default().b_deg.to_radians(),
        }
    }

    /// Greatest distance of a straight move from the path of balls or corners, mm. The disc under a
    /// corner goes a longer way round bends, by at most as much as its cutter is wider.
    pub fn chord_mm(&self) -> f64 {
        let wider = self.inclined.map_or(1.0, |i| 1.0 + i.disc_radius_mm / self.radius_mm);
        self.settings.chord_mm / wider
    }

    /// Distance of two passes on flat ground that leave a scallop, mm.
    pub fn flat_mm(&self, scallop_mm: f64) -> f64 {
        flat_stepover_mm(self.inclined.map_or(self.radius_mm, |i| i.flat_radius_mm()), scallop_mm)
    }
}
