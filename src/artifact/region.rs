//! Regions: pieces of the part's surface, the curves at which they begin and end, and the names of
//! their sides.
//!
//! A part has a list of regions. Today it holds one airfoil, perhaps with a fillet and a platform;
//! nothing here counts on that.

use std::collections::BTreeMap;

use super::along::Along;
use super::meridian::Meridian;
use crate::geometry::mesh::Mesh;
use crate::geometry::profile::Sides;
use crate::geometry::slice::Loop;

/// What a piece of the part's surface belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Area {
    /// The airfoil's sides and edges, clear of the fillet.
    Airfoil,
    /// Between airfoil and platform.
    Fillet,
    /// The platform's side that the airfoil stands on.
    Platform,
    /// All below.
    Root,
    /// The airfoil's end and what is beyond it.
    Tip,
    /// Beside the airfoil, or not recognised.
    Other,
}

/// Surface of each face by area, mm²; `areas`: what each triangle of the mesh belongs to.
pub fn surface(mesh: &Mesh, areas: &[Area]) -> BTreeMap<u32, BTreeMap<Area, f64>> {
    let mut out: BTreeMap<u32, BTreeMap<Area, f64>> = BTreeMap::new();
    for (t, area) in areas.iter().enumerate() {
        *out.entry(mesh.face(t)).or_default().entry(*area).or_default() += mesh.triangle_area_mm2(t);
    }
    out
}

/// The area that each face belongs to by most of its surface.
pub fn of_faces(mesh: &Mesh, areas: &[Area]) -> BTreeMap<u32, Area> {
    let most = |by: &BTreeMap<Area, f64>| by.iter().max_by(|a, b| a.1.total_cmp(b.1)).map(|(a, _)| *a);
    surface(mesh, areas).iter().filter_map(|(face, by)| Some((*face, most(by)?))).collect()
}

/// A curve on the part at which a region begins or ends.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// All places at this height along the region, mm.
    Height(f64),
    /// The sharp edge or opening about this height (mm) at which a wall without a platform ends.
    Rim(f64),
    /// The border to faces or groups: one flag for each, what is missing is not one.
    Faces(Vec<bool>),
}

impl Boundary {
    /// The height that it is at or about, mm; `None` where no height says it.
    pub fn x_mm(&self) -> Option<f64> {
        match self {
            Boundary::Height(x_mm) | Boundary::Rim(x_mm) => Some(*x_mm),
            Boundary::Faces(_) => None,
        }
    }
}

/// The surface of a region, by numbers from 0 that rise.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Patch {
    /// Exact faces.
    Faces(Vec<u32>),
    /// Triangles of a part that is a mesh.
    Facets(Vec<u32>),
}

impl Patch {
    /// Some triangles of a mesh, by numbers from 0 that rise; of exact faces those that they are
    /// most of.
    pub fn most_of(mesh: &Mesh, triangles: Vec<u32>, is_exact: bool) -> Patch {
        if !is_exact {
            return Patch::Facets(triangles);
        }
        let mut areas = vec![Area::Other; mesh.triangles.len()];
        triangles.iter().for_each(|t| areas[*t as usize] = Area::Airfoil);
        let own = of_faces(mesh, &areas).into_iter().filter(|(_, area)| *area == Area::Airfoil);
        Patch::Faces(own.map(|(face, _)| face).collect())
    }

    /// Whether nothing is known to lie on it.
    pub fn is_empty(&self) -> bool {
        let (Patch::Faces(numbers) | Patch::Facets(numbers)) = self;
        numbers.is_empty()
    }

    /// Whether a triangle of the part's mesh lies on it.
    pub fn has(&self, mesh: &Mesh, triangle: u32) -> bool {
        match self {
            Patch::Faces(faces) => faces.binary_search(&mesh.face(triangle as usize)).is_ok(),
            Patch::Facets(facets) => facets.binary_search(&triangle).is_ok(),
        }
    }
}

/// A piece of the part's surface.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Region {
    /// What it is.
    pub area: Area,
    /// Its surface.
    pub patch: Patch,
    /// The way along it, from its end to its start.
    pub along: Along,
    /// Where it begins, on the side of the tip; `None` where no curve is known.
    pub start: Option<Boundary>,
    /// Where it ends, on the side of the root; `None` where no curve is known.
    pub end: Option<Boundary>,
    /// Leading and trailing edge along it, and which side is the suction side; `None` where it has
    /// none, or they are not known.
    pub sides: Option<Sides>,
}

impl Region {
    /// A region along the blade axis between two boundaries, of no known surface or sides.
    pub fn between(area: Area, start: Option<Boundary>, end: Option<Boundary>) -> Region {
        Region { area, patch: Patch::Faces(Vec::new()), along: Along::BLADE, start, end, sides: None }
    }

    /// Heights of its end and its start, mm; `None` where no heights bound it.
    pub fn x_mm(&self) -> Option<[f64; 2]> {
        Some([self.end.as_ref()?.x_mm()?, self.start.as_ref()?.x_mm()?])
    }

    /// Which of the loops of a plane section goes round it: the one with the greatest length on its
    /// surface; where none lies on it, the one round the blade axis or the nearest to that.
    pub fn contour(&self, mesh: &Mesh, loops: &[Loop]) -> Option<usize> {
        let on_mm = |l: &Loop| {
            let n = l.points.len();
            let length_mm = |k: usize| {
                let (p, q) = (l.points[k], l.points[(k + 1) % n]);
                (q[0] - p[0]).hypot(q[1] - p[1])
            };
            let on = l.triangles.iter().enumerate().filter(|(_, t)| self.patch.has(mesh, **t));
            on.map(|(k, _)| length_mm(k)).sum::<f64>()
        };
        let on: Vec<f64> = loops.iter().map(on_mm).collect();
        let longest = (0..loops.len()).rev().max_by(|a, b| on[*a].total_cmp(&on[*b]));
        let away_mm = |k: &usize| if loops[*k].contains([0.0; 2]) { 0.0 } else { loops[*k].distance_mm([0.0; 2]) };
        let nearest = || (0..loops.len()).min_by(|a, b| away_mm(a).total_cmp(&away_mm(b)));
        longest.filter(|k| on[*k] > 0.0).or_else(nearest)
    }

    /// That of the mirror image of the part across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Region {
        Region { along: self.along.mirrored(), sides: self.sides.as_ref().map(Sides::mirrored), ..self.clone() }
    }
}

/// What was recognised on the part.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Regions {
    /// Least and greatest height of the whole part, blade frame (`x` from root to tip), mm.
    pub part_x_mm: [f64; 2],
    /// The regions.
    pub list: Vec<Region>,
    /// How each was found, one sentence each.
    pub reasons: Vec<String>,
}

impl Regions {
    /// An airfoil between two heights and, where there is one, a platform with its top at the
    /// third; mm. The surface is not known.
    pub fn at_heights(part_x_mm: [f64; 2], airfoil_x_mm: [f64; 2], platform_x_mm: Option<f64>) -> Regions {
        let [foot, top] = airfoil_x_mm;
        let end = if platform_x_mm.is_some() { Boundary::Height(foot) } else { Boundary::Rim(foot) };
        let airfoil = Region::between(Area::Airfoil, Some(Boundary::Height(top)), Some(end));
        let platform = platform_x_mm.map(|x| Region::between(Area::Platform, Some(Boundary::Height(x)), None));
        Regions { part_x_mm, list: std::iter::once(airfoil).chain(platform).collect(), reasons: Vec::new() }
    }

    /// The first region of a kind.
    pub fn first(&self, area: Area) -> Option<&Region> {
        self.list.iter().find(|r| r.area == area)
    }

    /// Heights of the first airfoil over a hub that turns from along the rotor axis to across it;
    /// `None` where its heights are along an axis.
    pub fn over_hub(&self) -> Option<&Meridian> {
        self.first(Area::Airfoil)?.along.round()
    }

    /// Heights between which sections of the first airfoil are one loop, clear of platform, shroud
    /// and tenon; mm. The whole part's where there is no airfoil.
    pub fn airfoil_x_mm(&self) -> [f64; 2] {
        self.first(Area::Airfoil).and_then(Region::x_mm).unwrap_or(self.part_x_mm)
    }

    /// Top of the platform, mm, where there is one.
    pub fn platform_x_mm(&self) -> Option<f64> {
        self.first(Area::Platform)?.start.as_ref()?.x_mm()
    }

    /// Foot and top of the fillet between airfoil and platform, mm, where there is one that heights
    /// bound.
    pub fn fillet_x_mm(&self) -> Option<[f64; 2]> {
        self.first(Area::Fillet)?.x_mm()
    }

    /// The edges and sides of the first airfoil, where they are known.
    pub fn sides(&self) -> Option<&Sides> {
        self.first(Area::Airfoil)?.sides.as_ref()
    }

    /// Those of the mirror image of the part across z = 0.
    #[must_use]
    pub fn mirrored(&self) -> Regions {
        Regions { list: self.list.iter().map(Region::mirrored).collect(), ..self.clone() }
    }
}

/// What a path is to cover: the contour that it goes round, and from where to where.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extent {
    /// The region whose contour the path goes round, as its number in [`Regions::list`].
    pub region: usize,
    /// Where it begins; `None`: found from the region.
    pub start: Option<Boundary>,
    /// Where it ends, whichever it comes to first, besides the region's own rim. None: where the
    /// part ends it.
    pub ends: Vec<Boundary>,
}

impl Extent {
    /// The faces at which it begins, if it begins at faces.
    pub fn start_faces(&self) -> &[Boundary] {
        match &self.start {
            Some(faces @ Boundary::Faces(_)) => std::slice::from_ref(faces),
            _ => &[],
        }
    }

    /// Round the first region between two heights of the ball's centre along it, mm; `None`: found
    /// from the part.
    pub fn heights(start_mm: Option<f64>, end_mm: Option<f64>) -> Extent {
        let boundary = |x: Option<f64>| x.map(Boundary::Height);
        Extent { region: 0, start: boundary(start_mm), ends: boundary(end_mm).into_iter().collect() }
    }

    /// The same with its end at this height instead, mm.
    #[must_use]
    pub fn down_to(self, end_mm: f64) -> Extent {
        Extent { ends: vec![Boundary::Height(end_mm)], ..self }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A square of this half width about a place, on its own four triangles.
    fn square(number: u32, at: [f64; 2], half: f64) -> Loop {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let points = corners.map(|c| [at[0] + half * c[0], at[1] + half * c[1]]).to_vec();
        Loop { points, triangles: (4 * number..4 * number + 4).collect(), closed: true }
    }

    #[test]
    fn the_contour_is_the_loop_on_the_regions_own_surface() {
        let mesh =
            Mesh { triangles: vec![[0, 1, 2]; 16], face_of: (0..16).map(|t| t / 4).collect(), ..Mesh::default() };
        let loops = [square(0, [9.0, 0.0], 2.0), square(1, [0.0; 2], 1.0), square(2, [30.0, 0.0], 5.0)];
        let region = |patch: Patch| Region { patch, ..Region::between(Area::Airfoil, None, None) };
        let contour = |patch: Patch| region(patch).contour(&mesh, &loops);
        assert_eq!(contour(Patch::Facets(vec![2, 8, 9])), Some(2));
        assert_eq!(contour(Patch::Faces(vec![0])), Some(0));
        // A face that no loop lies on: the loop round the axis.
        assert_eq!(contour(Patch::Faces(vec![3])), Some(1));
        assert_eq!(region(Patch::Faces(vec![3])).contour(&mesh, &loops[..1]), Some(0));
        assert_eq!(region(Patch::Faces(vec![0])).contour(&mesh, &[]), None);
    }

    #[test]
    fn heights_are_those_of_the_boundaries() {
        let regions = Regions::at_heights([-50.0, 80.0], [0.0, 75.0], Some(-1.0));
        assert_eq!((regions.airfoil_x_mm(), regions.platform_x_mm()), ([0.0, 75.0], Some(-1.0)));
        assert_eq!((regions.fillet_x_mm(), regions.sides()), (None, None));
        assert_eq!(regions.first(Area::Airfoil).unwrap().end, Some(Boundary::Height(0.0)));
        let free = Regions::at_heights([-50.0, 80.0], [0.0, 75.0], None);
        assert_eq!((free.airfoil_x_mm(), free.platform_x_mm()), ([0.0, 75.0], None));
        assert_eq!(free.first(Area::Airfoil).unwrap().end, Some(Boundary::Rim(0.0)));
        assert_eq!(Boundary::Faces(vec![true]).x_mm(), None);
    }
}
