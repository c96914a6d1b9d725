//! How the tool comes onto the path and leaves it.

use super::AxisMotion;
use crate::error::LeadReason;
use crate::geometry::Point;

/// The way of the tool before the first location, or after the last: an arc in air, tangential to
/// the path where they meet. Rows are in order of time and do not contain the location itself. No
/// rows: the tool comes or leaves straight along its axis.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Lead {
    /// Radius of the arc of ball centres, mm; 0 where there is none.
    pub radius_mm: f64,
    /// Angle of the arc, rad; 0 where there is none.
    pub angle_rad: f64,
    /// Why there is no arc, or not the one asked for.
    pub reason: Option<LeadReason>,
    /// Ball centres, blade frame, mm.
    pub centres: Vec<Point>,
    /// Angle of the tool axis about the blade axis, rad, unwrapped with the schedule.
    pub theta: Vec<f64>,
    /// What the axes do, one row for each centre, in the time of the whole plan.
    pub motion: AxisMotion,
}

impl Lead {
    /// Straight along the tool axis, and why.
    pub fn straight(reason: impl Into<Option<LeadReason>>) -> Self {
        Lead { reason: reason.into(), ..Lead::default() }
    }

    /// The reason behind a colon; empty where there is nothing to say.
    pub fn why(&self) -> String {
        self.reason.as_ref().map_or_else(String::new, |why| format!(": {why}"))
    }

    /// There is an arc.
    pub fn is_arc(&self) -> bool {
        !self.centres.is_empty()
    }
}
