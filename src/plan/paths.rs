//! What the pipeline does about kinds of path: where turns are to begin, and other kinds for
//! comparison.

use super::Setup;
use crate::artifact::report::LimitFigures;
use crate::artifact::toolpath::PathKind;
use crate::artifact::{Blade, CheckReport, Toolpath};
use crate::error::{ErrorKind, Result, Stage};
use crate::observe::{Doubt, Observer, Warning};
use crate::path::{self, PathOptions, PathSettings};
use crate::section::{self, SectionOptions};
use crate::verify;

/// The trailing edge on the section at a height, blade frame, mm.
pub(crate) fn trailing_edge(blade: &Blade, x_mm: f64, observer: &dyn Observer) -> Result<Option<[f64; 3]>> {
    let options = SectionOptions { heights_mm: vec![x_mm], ..SectionOptions::default() };
    let sections = section::plan(blade, &options, observer)?;
    Ok(sections.first().and_then(|s| s.loops.first()).and_then(|airfoil| {
        let after = airfoil.s_mm.partition_point(|s| *s < airfoil.trailing_edge_s_mm);
        let [y, z] = *airfoil.points_mm.get(after).or(airfoil.points_mm.last())?;
        Some([x_mm, y, z])
    }))
}

/// Paths of the other kinds over the region of the path in use, with its worst ridge as their
/// scallop, each beside the limit that was measured on it. A kind whose turns cannot be laid is
/// left out, with a warning.
pub(crate) fn others(
    setup: &Setup,
    path: &Toolpath,
    report: &CheckReport,
    observer: &dyn Observer,
) -> Result<Vec<(Toolpath, LimitFigures)>> {
    let kinds = PathKind::ROUND.into_iter().filter(|k| *k != path.kind);
    let worst_mm = report.limit.ridge_p99_mm.max(0.2 * path.scallop_mm);
    // A ball that comes to an edge at the part's end has its centre beyond it.
    let [a, b] = path.region_x_mm;
    let end_mm = a.min(b).max(setup.blade.regions.part_x_mm[0]);
    let mut out = Vec::new();
    for kind in kinds {
        let own = setup.path_options();
        let extent = own.extent.clone().down_to(end_mm);
        // Turns of other kinds cannot go down to a platform: the height of the region ends them.
        let max_lean_deg = own.settings.max_lean_deg.min(path::most_lean_deg(kind));
        let settings = PathSettings { kind, scallop_mm: worst_mm, max_lean_deg, ..own.settings };
        let options = PathOptions { settings, extent, ..own };
        let other = match path::plan(&setup.blade, &options, observer) {
            Err(e) if e.kind == ErrorKind::Infeasible => {
                let doubt = Doubt::NoPathToCompare { kind: kind.name(), reason: e.message, why: e.infeasible };
                observer.warn(Warning { stage: Stage::Path, doubt });
                continue;
            }
            other => other?,
        };
        let samples = setup.job.verify.surface_samples as usize;
        let limit = verify::limit(&setup.blade, &other, path.scallop_mm, samples)?;
        out.push((other, limit));
    }
    Ok(out)
}
