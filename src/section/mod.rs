//! Plane sections of a blade, perpendicular to its axis.
//!
//! **In**: a [`Blade`]. **Out**: one [`Section`] per height, lowest first: closed loops with arc length, curvature,
//! altered points, edges, sides, chord and thickness.
//!
//! **Method.** The mesh is cut by planes `x = const` ([`crate::geometry::slice`]). Where the part has exact faces, loops are
//! made denser and every point is moved within its plane onto the exact surface, to 10⁻⁸ mm (`outline`); curvature is then the
//! surface's own (Meusnier). On meshes, and beside creases, curvature comes from local least-squares cubics in arc length, each over the widest stretch on which it keeps within a stated tolerance, so that
//! facets do not show (`curvature`). Altered points are changes of sign between stretches that bend by more than the
//! tolerance (`altered`). Edges are the middles of the highest convex curvature about the two ends of the section's greatest
//! extent; the leading edge is the blunter one (`edges`). Thickness is the diameter of the largest inscribed circle.
//!
//! The same loops as smooth curves, for callers that need more than points: [`smooth`].
//!
//! **Guaranteed**: loops are closed, counter-clockwise seen from the tip; `off_part_mm` is the greatest distance of a point from
//! the part, and `fit_error_mm` the greatest distance
//! between a point and the fit that its curvature comes from. **Not guaranteed**: curvature where an edge has fewer than about
//! five points round it; which end is the leading edge where both are equally blunt.
//!
//! **Openings.** Where the part is open, gaps up to a thousandth of a section's length are bridged by straight lines; a section
//! with a wider one is left out. Both are warnings: whether an opening matters for the tool is decided elsewhere.
//!
//! **Fails** with kind `Usage` for heights outside the part or impossible options, and `Infeasible` where no section at all closes.

mod altered;
mod curvature;
mod edges;
mod outline;
pub mod smooth;

use rayon::prelude::*;

use crate::artifact::Blade;
use crate::artifact::section::{Section, SectionLoop, Side};
use crate::error::{Error, Result, Stage};
use crate::geometry::part::Part;
use crate::observe::{Observer, Warning};
use outline::Outline;

/// Which sections, and how smooth.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionOptions {
    /// Number of heights, evenly spread from the platform (or the airfoil's lower end) to the airfoil's upper end; used
    /// where `heights_mm` is empty.
    pub count: usize,
    /// Heights along the blade axis, blade frame, mm.
    pub heights_mm: Vec<f64>,
    /// How far the smooth curve that curvature is taken from may stay off the section's points, mm; used where the part is a
    /// mesh, and beside creases.
    pub tolerance_mm: f64,
}

impl Default for SectionOptions {
    fn default() -> Self {
        SectionOptions { count: 11, heights_mm: Vec::new(), tolerance_mm: 0.002 }
    }
}

/// Sections of a blade, by rising height.
///
/// # Errors
/// Kind `Usage` for impossible options or a height that misses the part, `Infeasible` for a section that does not close,
/// `Cancelled`.
pub fn plan(blade: &Blade, options: &SectionOptions, observer: &dyn Observer) -> Result<Vec<Section>> {
    let heights = heights(blade, options)?;
    let cut: Vec<Cut> = heights
        .par_iter()
        .map(|&x_mm| {
            observer.check(Stage::Section)?;
            Ok(section(&blade.part, x_mm, options.tolerance_mm))
        })
        .collect::<Result<_>>()?;
    observer.progress(Stage::Section, heights.len(), heights.len());
    if cut.iter().all(|c| c.section.is_none()) {
        return Err(no_section(blade, &cut));
    }
    for message in cut.iter().flat_map(Cut::remarks) {
        observer.warn(Warning { stage: Stage::Section, message });
    }
    Ok(cut.into_iter().filter_map(|c| c.section).collect())
}

/// What was found at a height.
struct Cut {
    x_mm: f64,
    /// The section; none where no loop closes.
    section: Option<Section>,
    /// Holes and open chains that are left out.
    dropped: usize,
    /// Widest gap that was bridged, mm.
    bridged_mm: f64,
    /// Widest gap that was not, mm.
    open_mm: f64,
}

impl Cut {
    /// Warnings on this cut.
    fn remarks(&self) -> Vec<String> {
        let Cut { x_mm, dropped, bridged_mm, open_mm, .. } = self;
        let mut out = Vec::new();
        if self.section.is_none() {
            out.push(format!(
                "there is no section at {x_mm:.3} mm: the part is open there, by {open_mm:.3} mm at the widest; the others are written"
            ));
        } else if *dropped > 0 {
            out.push(format!("the section at {x_mm:.3} mm has {dropped} hole(s) or open chain(s), left out"));
        }
        if *bridged_mm > 0.0 {
            out.push(format!(
                "the section at {x_mm:.3} mm is drawn straight over gaps of the part, {bridged_mm:.3} mm at the widest"
            ));
        }
        out
    }
}

/// Why there is nothing to write.
fn no_section(blade: &Blade, cut: &[Cut]) -> Error {
    let (first, last) = (cut.first().map_or(0.0, |c| c.x_mm), cut.last().map_or(0.0, |c| c.x_mm));
    let open_mm = cut.iter().map(|c| c.open_mm).fold(0.0, f64::max);
    Error::infeasible(
        Stage::Section,
        format!("none of {} sections from {first:.3} to {last:.3} mm along the blade axis closes: the part is open there, by up to {open_mm:.3} mm", cut.len()),
    )
    .advise(if blade.part.brep.is_some() {
        "sew or close the faces in CAD and export a solid"
    } else {
        "close the mesh, here with --set model.close_holes_mm=… (greatest extent of a hole) if it should be closed flat"
    })
}

fn heights(blade: &Blade, options: &SectionOptions) -> Result<Vec<f64>> {
    if !(options.tolerance_mm > 0.0 && options.tolerance_mm.is_finite()) {
        return Err(Error::usage(
            Stage::Section,
            format!("the smoothing tolerance is {} mm, it must be greater than 0", options.tolerance_mm),
        ));
    }
    let [low, high] = blade.regions.part_x_mm;
    let mut out = options.heights_mm.clone();
    if out.is_empty() {
        if options.count == 0 {
            return Err(Error::usage(Stage::Section, "neither heights nor a number of sections is given"));
        }
        let top = blade.regions.airfoil_x_mm[1];
        let from = blade.regions.platform_x_mm.unwrap_or(blade.regions.airfoil_x_mm[0]);
        let step = (top - from) / options.count as f64;
        out = (0..options.count).map(|i| from + (i as f64 + 0.5) * step).collect();
    }
    if let Some(x) = out.iter().find(|x| !(**x > low && **x < high)) {
        return Err(Error::usage(
            Stage::Section,
            format!(
                "a section at {x} mm along the blade axis misses the part, which lies between {low:.3} and {high:.3} mm"
            ),
        ));
    }
    out.sort_by(f64::total_cmp);
    out.dedup();
    Ok(out)
}

/// What a plane cuts out, measured.
fn section(part: &Part, x_mm: f64, tolerance_mm: f64) -> Cut {
    let outline::Outlines { loops, dropped, bridged_mm, open_mm } = outline::outlines(part, x_mm);
    let loops: Vec<SectionLoop> = loops.into_iter().map(|o| measured(o, tolerance_mm)).collect();
    let section = (!loops.is_empty()).then_some(Section { x_mm, loops });
    Cut { x_mm, section, dropped, bridged_mm, open_mm }
}

/// A loop with everything that is measured on it; closed, counter-clockwise, at least three points.
fn measured(outline: Outline, tolerance_mm: f64) -> SectionLoop {
    let Outline { points, exact, off_part_mm } = outline;
    let (s_mm, length_mm) = outline::arc_length(&points);
    let fit = curvature::fit(&points, &exact, &s_mm, length_mm, tolerance_mm.max(2.0 * off_part_mm));
    let altered_points = altered::points(&points, &s_mm, length_mm, &fit.curvature, tolerance_mm);
    let ends = edges::find(&points, &s_mm, length_mm, &fit.curvature);
    SectionLoop {
        altered_points,
        leading_edge_s_mm: ends.leading.s_mm,
        trailing_edge_s_mm: ends.trailing.s_mm,
        side_after_leading_edge: if ends.suction_first { Side::Suction } else { Side::Pressure },
        chord_mm: outline::distance(ends.leading.point, ends.trailing.point),
        thickness_mm: edges::thickness(&points, &fit.normal, tolerance_mm),
        fit_error_mm: fit.error_mm,
        area_mm2: outline::area(&points),
        off_part_mm,
        curvature_per_mm: fit.curvature,
        length_mm,
        s_mm,
        points_mm: points,
    }
}

#[cfg(test)]
mod tests;
