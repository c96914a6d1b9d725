//! Limits of the checks and how finely they look.

use super::Asked;
use crate::tool::{CLEARANCE_MM, HOLDER_CLEARANCE_MM};

/// Limits and sampling of [`super::check`]. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct VerifyOptions {
    /// Deepest gouge allowed, mm. Default 0.003: the chord tolerance of 0.001 between locations and
    /// as much again for the location itself and the measurement.
    pub gouge_mm: f64,
    /// Scallop asked for, mm.
    pub scallop_mm: f64,
    /// The 99th percentile of the scallop may be this many times `scallop_mm`. Default 1.05.
    pub scallop_ratio: f64,
    /// Clearance asked for between the part and taper or shank, mm. What must be proven is less by
    /// `clearance_tolerance_mm`.
    pub clearance_mm: f64,
    /// Clearance asked for between the part and the holder, mm: likewise.
    pub holder_clearance_mm: f64,
    /// What the gouge check may miss between two of its samples, mm. Default 0.0005.
    pub resolution_mm: f64,
    /// What the clearance check may miss between two of its samples, mm. Default 0.005: well below
    /// any clearance asked for.
    pub clearance_resolution_mm: f64,
    /// What may be missing of a clearance asked for, mm. Default 0.005, or a hundredth of the
    /// clearance where that is more: what triangles are off exact faces, and what moves are told
    /// apart by. Planning keeps it between locations as well.
    pub clearance_tolerance_mm: f64,
    /// How far θ may leave the channel or turn back, degrees: rounding only. Default 1e-6.
    pub angle_tolerance_deg: f64,
    /// How far velocity and acceleration of an axis may exceed its limit, relative. Default 1e-4:
    /// rounding of times and positions.
    pub limit_tolerance: f64,
    /// What else the job asks for; `None`: the plan is judged by itself.
    pub asked: Option<Asked>,
    /// Number of surface samples over the machined band, about. Default 120 000.
    pub surface_samples: usize,
}

impl Default for VerifyOptions {
    fn default() -> Self {
        VerifyOptions {
            gouge_mm: 0.003,
            scallop_mm: 0.01,
            scallop_ratio: 1.05,
            clearance_mm: CLEARANCE_MM,
            holder_clearance_mm: HOLDER_CLEARANCE_MM,
            resolution_mm: 0.0005,
            clearance_resolution_mm: 0.005,
            clearance_tolerance_mm: 0.005,
            angle_tolerance_deg: 1e-6,
            limit_tolerance: 1e-4,
            asked: None,
            surface_samples: 120_000,
        }
    }
}

impl VerifyOptions {
    /// The least clearance that passes where `asked_mm` is asked for, mm.
    pub fn least_clearance(&self, asked_mm: f64) -> f64 {
        (asked_mm - self.clearance_tolerance_mm.max(0.01 * asked_mm)).max(0.0)
    }
}
