//! Plane sections of a blade, perpendicular to its axis.
//!
//! **In**: a [`Blade`]. **Out**: one [`Section`] per height, lowest first: closed loops with arc
//! length, curvature, altered points, edges, sides, chord and thickness.
//!
//! **Method.** The mesh is cut by planes `x = const` ([`crate::geometry::slice`]). Where the part
//! has exact faces, loops are made denser and every point is moved within its plane onto the exact
//! surface, to 10⁻⁸ mm; curvature is then the surface's own (Meusnier). On meshes, and beside
//! creases, curvature comes from local least-squares cubics in arc length, each over the widest
//! stretch on which it keeps within a stated tolerance, so that facets do not show. Altered points
//! are changes of sign between stretches that bend by more than the tolerance (`altered`). Edges
//! are the middles of the highest convex curvature about the two ends of the section's greatest
//! extent. Thickness is the diameter of the largest inscribed circle. Outlines, curvature, edges
//! and thickness are [`crate::geometry::profile`]'s.
//!
//! **Names.** Which end is the leading edge and which side the suction side is known of the blade
//! as a whole ([`crate::geometry::profile::Sides`]). So a section has the same names whichever
//! others are asked for. Where the blade does not say it, the sections asked for say it together; a
//! loop that is not the airfoil's is named by its own shape. Where the ends found on an outline
//! that is folded or torn are not near the airfoil's edges, the points nearest to these are taken.
//!
//! The same loops as smooth curves, for callers that need more than points: [`smooth`].
//!
//! **Guaranteed**: loops are closed, counter-clockwise seen from the tip; `off_part_mm` is the
//! greatest distance of a point from the part, and `fit_error_mm` the greatest distance between a
//! point and the fit that its curvature comes from. **Not guaranteed**: curvature where an edge has
//! fewer than about five points round it; which end is the leading edge where both are equally
//! blunt.
//!
//! **Openings.** Where the part is open, gaps up to a thousandth of a section's length are bridged
//! by straight lines; a section with a wider one is left out. Both are warnings: whether an opening
//! matters for the tool is decided elsewhere.
//!
//! A blade over a hub that turns from along the rotor axis to across it has no such sections: there
//! are none then.
//!
//! **Fails** with kind `Usage` for heights outside the part or impossible options, and `Infeasible`
//! where no section at all closes.

mod altered;
mod settings;
pub mod smooth;

pub use settings::{SectionKeys, SectionSettings};

use crate::artifact::Blade;
use crate::artifact::section::{Section, SectionLoop, Side};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::part::Part;
use crate::geometry::profile::outline::{self, Outline};
use crate::geometry::profile::{Names, Profile, SectionEnds, Sides, TOLERANCE_MM, edges};
use crate::observe::{Doubt, Observer, Warning};
use crate::parallel;
use crate::settings::with_settings;

/// Which sections, and how smooth.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionOptions {
    /// How many heights, evenly spread from the platform (or the airfoil's lower end) to the
    /// airfoil's upper end; used where `heights_mm` is empty.
    pub settings: SectionSettings,
    /// Heights along the blade axis, blade frame, mm.
    pub heights_mm: Vec<f64>,
    /// How far the smooth curve that curvature is taken from may stay off the section's points, mm;
    /// used where the part is a mesh, and beside creases.
    pub tolerance_mm: f64,
}

with_settings!(SectionOptions, SectionSettings);

impl Default for SectionOptions {
    fn default() -> Self {
        SectionOptions { settings: SectionSettings::default(), heights_mm: Vec::new(), tolerance_mm: TOLERANCE_MM }
    }
}

/// Sections of a blade, by rising height.
///
/// # Errors
/// Kind `Usage` for impossible options or a height that misses the part, `Infeasible` for a section
/// that does not close, `Cancelled`.
pub fn plan(blade: &Blade, options: &SectionOptions, observer: &dyn Observer) -> Result<Vec<Section>> {
    // Planes cut no airfoil out of a blade whose hub turns.
    if blade.regions.over_hub().is_some() {
        return Ok(Vec::new());
    }
    let heights = heights(blade, options)?;
    let cut: Vec<SectionCut> = parallel::try_map(&heights, |&x_mm| {
        observer.check(Stage::Section)?;
        Ok(cut(&blade.part, x_mm, options.tolerance_mm))
    })?;
    observer.progress(Stage::Section, heights.len(), heights.len());
    if cut.iter().all(|c| c.loops.is_empty()) {
        return Err(no_section(blade, &cut));
    }
    for doubt in cut.iter().flat_map(SectionCut::doubts) {
        observer.warn(Warning { stage: Stage::Section, doubt });
    }
    let largest = || cut.iter().filter_map(|c| Some((c.x_mm, c.ends.first()?.clone()))).collect::<Vec<_>>();
    let sides = blade.regions.sides().cloned().or_else(|| Sides::along(&largest()));
    Ok(cut.into_iter().filter_map(|c| c.named(sides.as_ref())).collect())
}

/// What was found at a height.
struct SectionCut {
    x_mm: f64,
    /// What closes.
    loops: Vec<SectionLoop>,
    /// The ends of each.
    ends: Vec<SectionEnds>,
    /// Holes and open chains that are left out.
    dropped: usize,
    /// Widest gap that was bridged, mm.
    bridged_mm: f64,
    /// Widest gap that was not, mm.
    open_mm: f64,
}

impl SectionCut {
    /// The section, its edges and sides named, the airfoil's loop first; none where no loop closes.
    fn named(mut self, sides: Option<&Sides>) -> Option<Section> {
        let known = sides.map_or_else(Vec::new, |s| s.names(self.x_mm, &self.ends));
        for (k, (l, ends)) in self.loops.iter_mut().zip(&self.ends).enumerate() {
            let own = known.get(k).copied().flatten();
            name(l, ends, own.unwrap_or_else(|| Names::alone(ends)));
            if let Some(sides) = sides.filter(|s| own.is_some() && s.are_elsewhere(self.x_mm, ends)) {
                put_edges(l, sides.at(self.x_mm));
            }
        }
        // Another blade or the hub may have a larger loop.
        if let Some(k) = known.iter().position(Option::is_some) {
            self.loops[..=k].rotate_right(1);
        }
        (!self.loops.is_empty()).then_some(Section { x_mm: self.x_mm, loops: self.loops })
    }

    /// Warnings on this cut.
    fn doubts(&self) -> Vec<Doubt> {
        let SectionCut { x_mm: height_mm, dropped, bridged_mm, open_mm, .. } = *self;
        let mut out = Vec::new();
        if self.loops.is_empty() {
            out.push(Doubt::NoSection { height_mm, open_mm });
        } else if dropped > 0 {
            out.push(Doubt::LoopsLeftOut { height_mm, count: dropped });
        }
        if bridged_mm > 0.0 {
            out.push(Doubt::SectionBridged { height_mm, widest_mm: bridged_mm });
        }
        out
    }
}

/// Why there is nothing to write.
fn no_section(blade: &Blade, cut: &[SectionCut]) -> Error {
    let (first, last) = (cut.first().map_or(0.0, |c| c.x_mm), cut.last().map_or(0.0, |c| c.x_mm));
    let open_mm = cut.iter().map(|c| c.open_mm).fold(0.0, f64::max);
    Error::infeasible(
        Stage::Section,
        format!("none of {} sections from {first:.3} to {last:.3} mm along the blade axis closes: the part is open there, by up to {open_mm:.3} mm", cut.len()),
        Infeasible::NoSectionCloses { count: cut.len(), heights_mm: [first, last], open_mm },
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
        options.settings.check(Stage::Section)?;
        let count = options.settings.count;
        let top = blade.regions.airfoil_x_mm()[1];
        let from = blade.regions.platform_x_mm().unwrap_or(blade.regions.airfoil_x_mm()[0]);
        let step = (top - from) / f64::from(count);
        out = (0..count).map(|i| from + (f64::from(i) + 0.5) * step).collect();
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
fn cut(part: &Part, x_mm: f64, tolerance_mm: f64) -> SectionCut {
    let outline::Outlines { loops, dropped, bridged_mm, open_mm } = outline::outlines(part, x_mm);
    let (loops, ends) = loops.into_iter().map(|o| measured(o, tolerance_mm)).unzip();
    SectionCut { x_mm, loops, ends, dropped, bridged_mm, open_mm }
}

/// A loop with everything that is measured on it, its first end as the leading edge, and its ends;
/// closed, counter-clockwise, at least three points.
fn measured(outline: Outline, tolerance_mm: f64) -> (SectionLoop, SectionEnds) {
    let profile = Profile::of(outline, tolerance_mm);
    let ends = profile.ends();
    let Profile { outline: Outline { points, off_part_mm, .. }, s_mm, length_mm, fit } = profile;
    let measured = SectionLoop {
        altered_points: altered::points(&points, &s_mm, length_mm, &fit.curvature, tolerance_mm),
        leading_edge_s_mm: ends.s_mm[0],
        trailing_edge_s_mm: ends.s_mm[1],
        side_after_leading_edge: Side::Suction,
        chord_mm: ends.chord_mm(),
        thickness_mm: edges::thickness(&points, &fit.normal, tolerance_mm),
        fit_error_mm: fit.error_mm,
        area_mm2: outline::area(&points),
        off_part_mm,
        curvature_per_mm: fit.curvature,
        length_mm,
        s_mm,
        points_mm: points,
    };
    (measured, ends)
}

/// Says which end leads and which side is which.
fn name(l: &mut SectionLoop, ends: &SectionEnds, names: Names) {
    let [first, second] = ends.s_mm;
    (l.leading_edge_s_mm, l.trailing_edge_s_mm) = if names.first_leads { (first, second) } else { (second, first) };
    l.side_after_leading_edge = if names.suction_follows_leading { Side::Suction } else { Side::Pressure };
}

/// Puts leading and trailing edge to the points nearest to where the airfoil has them.
fn put_edges(l: &mut SectionLoop, edges: [[f64; 2]; 2]) {
    let nearest = edges.map(|q| {
        let away_mm = |i: &usize| outline::distance(l.points_mm[*i], q);
        (0..l.points_mm.len()).min_by(|a, b| away_mm(a).total_cmp(&away_mm(b))).unwrap_or(0)
    });
    [l.leading_edge_s_mm, l.trailing_edge_s_mm] = nearest.map(|i| l.s_mm[i]);
    l.chord_mm = outline::distance(l.points_mm[nearest[0]], l.points_mm[nearest[1]]);
}

#[cfg(test)]
mod tests;
