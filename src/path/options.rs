//! Options of the path stage.

use crate::artifact::region::Extent;
use crate::artifact::toolpath::{Direction, PathKind};

/// What the helix should be.
#[derive(Clone, Debug, PartialEq)]
pub struct PathOptions {
    /// How the turns lie.
    pub kind: PathKind,
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Climb or conventional milling.
    pub direction: Direction,
    /// Turns begin at the altered point nearest to this point, blade frame, mm (on a convex
    /// airfoil, at the point nearest to it); `None`: where the path enters the greatest concave
    /// stretch.
    pub start_near: Option<[f64; 3]>,
    /// Stock left on the part for a later pass, mm: everything is planned against the part with so
    /// much on it.
    pub stock_mm: f64,
    /// Greatest scallop between neighbouring turns, mm.
    pub scallop_mm: f64,
    /// Greatest distance of the straight move between two locations from the exact path of ball
    /// centres, mm; in smooth hollows of exact faces, where it leaves material standing, a quarter
    /// of it.
    pub chord_mm: f64,
    /// Greatest distance between two locations, mm.
    pub max_step_mm: f64,
    /// The region: the contour to go round, and from where to where, see [`super::plan`].
    pub extent: Extent,
    /// Greatest angle between the surface normal at the contact and the section plane, rad: where a
    /// wall leans more (deep in a fillet, on a platform) turns at constant height make no sense and
    /// the helix ends.
    pub max_lean_rad: f64,
    /// Lean of the tool axis over the plane square to the blade axis, towards the tip, rad: where
    /// the spindle's pivot stays. How turns lie does not depend on it.
    pub lean_rad: f64,
}

impl PathOptions {
    /// Defaults for a ball radius and a scallop: chord 1 µm (well under the finest scallop asked
    /// for in practice), steps of at most a quarter of the ball radius and 1 mm, lean up to 60°.
    pub fn new(radius_mm: f64, scallop_mm: f64) -> Self {
        PathOptions {
            kind: PathKind::default(),
            radius_mm,
            direction: Direction::Climb,
            start_near: None,
            stock_mm: 0.0,
            scallop_mm,
            chord_mm: 0.001,
            max_step_mm: (0.25 * radius_mm).min(1.0),
            extent: Extent::default(),
            max_lean_rad: 60f64.to_radians(),
            lean_rad: 5f64.to_radians(),
        }
    }
}
