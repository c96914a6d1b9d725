//! The regions of a part: for each area its faces or facets, the curves that bound it, and the
//! names of its sides.

use super::areas::areas;
use super::sides::sides;
use super::{Heights, Recognised};
use crate::artifact::region::{Area, Boundary, Patch, Region, Regions, of_faces};
use crate::geometry::part::Part;

/// The regions of the part that a blade was recognised on, the airfoil first. `part`: blade frame.
pub fn pieces(part: &Part, found: &Recognised) -> Regions {
    let h = &found.heights;
    let is_exact = part.brep.is_some();
    let areas = areas(&part.mesh, found, is_exact);
    let by_face = of_faces(&part.mesh, &areas);
    let faces = |area| Patch::Faces(by_face.iter().filter(|(_, own)| **own == area).map(|(face, _)| *face).collect());
    let mut list: Vec<Region> = [Area::Airfoil, Area::Fillet, Area::Platform, Area::Root, Area::Tip, Area::Other]
        .into_iter()
        .map(|area| {
            let (start, end) = boundaries(h, area);
            let patch = if is_exact { faces(area) } else { facets(&areas, area) };
            Region { patch, ..Region::between(area, start, end) }
        })
        .filter(|r| r.area == Area::Airfoil || r.start.is_some() || !r.patch.is_empty())
        .collect();
    match &found.round {
        Some(round) => list.iter_mut().for_each(|r| r.along = round.along),
        None => list[0].sides = sides(part, h.airfoil_x_mm, &found.outline),
    }
    Regions { part_x_mm: h.part_x_mm, list, reasons: h.reasons.clone() }
}

/// Where a region begins and ends, as far as heights or a rim say it.
fn boundaries(h: &Heights, area: Area) -> (Option<Boundary>, Option<Boundary>) {
    let height = |x_mm: f64| Some(Boundary::Height(x_mm));
    let [foot, top] = h.airfoil_x_mm;
    match area {
        Area::Airfoil if h.platform_x_mm.is_some() => (height(top), height(foot)),
        Area::Airfoil => (height(top), Some(Boundary::Rim(foot))),
        Area::Fillet => (h.fillet_x_mm.and_then(|f| height(f[1])), h.fillet_x_mm.and_then(|f| height(f[0]))),
        Area::Platform => (h.platform_x_mm.and_then(height), None),
        Area::Root | Area::Tip | Area::Other => (None, None),
    }
}

/// The triangles of an area.
fn facets(areas: &[Area], area: Area) -> Patch {
    Patch::Facets((0..areas.len() as u32).filter(|t| areas[*t as usize] == area).collect())
}
