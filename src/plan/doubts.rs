//! Doubts about a job and its blade before anything is planned, and causes to which later errors
//! are attributed.

use super::Setup;
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, ErrorKind, Result};
use crate::machine::Machine;
use crate::observe::{Doubt, Observer};
use crate::path;

impl Setup {
    /// The path of the job.
    ///
    /// # Errors
    /// Those of [`path::plan`]; the message says so where the given blade axis is likely to be the
    /// cause.
    pub fn path(&self, observer: &dyn Observer) -> Result<Toolpath> {
        path::plan(&self.blade, &self.path_options(), observer).map_err(|e| blamed_on_axis(e, &self.blade))
    }
}

/// A warning for a feed that the linear axes do not reach even together.
pub(super) fn out_of_reach(feed_mm_min: f64, machine: &Machine) -> Option<Doubt> {
    let linear_mm_min = machine.linear().map(|k| 60.0 * machine.axes()[k].limits.velocity);
    let together = linear_mm_min.iter().map(|v| v * v).sum::<f64>().sqrt();
    (feed_mm_min > together).then_some(Doubt::FeedOutOfReach { feed_mm_min, linear_mm_min })
}

/// Adds to the error what speaks against the given blade axis, where that may be the cause.
pub(super) fn blamed_on_axis(mut e: Error, blade: &Blade) -> Error {
    if let (ErrorKind::Infeasible, Some(against)) = (e.kind, &blade.diagnosis.axis_against) {
        e.message = format!("{against}; and {}", e.message);
        e.advise("the axis is the likely cause: leave --axis (model.axis) out, or give the one from root to tip")
    } else {
        e
    }
}
