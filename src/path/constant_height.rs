//! Turns at constant height: a stack of rings, each as far below the last as the scallop allows at
//! the worst place of the turn, and the helix that runs from each ring to the next.

use super::level::LevelSet;
use super::options::PathOptions;
use super::rings::Aim;
use super::{helix, rings};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::observe::Observer;

/// Lays the helix from the height `start_x` down.
pub(super) fn plan(
    blade: &Blade,
    level: &LevelSet,
    options: &PathOptions,
    start_x: f64,
    observer: &dyn Observer,
) -> Result<Toolpath> {
    // The pitch varies from turn to turn and the helix blends neighbours, so a turn may meet more
    // than its own ring pair promised: aim lower, measure the helix itself, and aim lower still at
    // the heights where that was not enough.
    let mut aim = Aim::new(0.95 * options.settings.scallop_mm);
    let mut kept = vec![rings::first_ring(blade, level, options, start_x, &rings::tracing(options))?];
    let mut best: Option<Toolpath> = None;
    for _ in 0..MOST_AIMS {
        let stack = rings::lay(blade, level, options, kept, &aim, observer)?;
        let (path, ridges) = helix::blend(level, &stack, options, observer)?;
        // Two hundredths are left for what another measure of the same ridge may see.
        let most = 0.98 * options.settings.scallop_mm;
        let high: Vec<usize> = (0..ridges.len()).filter(|&k| ridges[k] > most).collect();
        let enough = path.planned_scallop_mm <= most || high.is_empty();
        if best.as_ref().is_none_or(|b| path.planned_scallop_mm < b.planned_scallop_mm) {
            best = Some(path);
        }
        if enough {
            break;
        }
        for &k in &high {
            let lower = stack.rings[(k + 2).min(stack.rings.len() - 1)].x_mm;
            aim.cap([lower, stack.rings[k].x_mm], (0.95 * options.settings.scallop_mm / ridges[k]).clamp(0.3, 0.97));
        }
        let first = high[0] + 1;
        kept = stack.rings;
        kept.truncate(first);
    }
    best.ok_or_else(|| Error::infeasible(Stage::Path, "no helix was laid", Infeasible::NoHelix))
}

/// How often the helix is laid anew, closer where its ridges were too high.
const MOST_AIMS: usize = 8;
