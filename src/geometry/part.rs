//! The whole part: a mesh always, exact NURBS faces where the model has them, and one distance
//! query to all of it.

use std::sync::OnceLock;

use super::brep::{Brep, Face, FaceName};
use super::bvh::MeshBvh;
use super::exact::Exact;
use super::exact::fine::Fine;
use super::exact::measure::Loops;
use super::measured::{Closest, Measured};
use super::mesh::Mesh;
use super::nurbs::Principal;
use super::tessellate::{TessellateOptions, Tessellation, tessellate};
use super::triangle::angle_at;
use super::{Point, Vector};
use crate::error::Result;
use crate::observe::Observer;
use crate::parallel;

/// The whole part in one frame.
#[derive(Clone)]
pub struct Part {
    /// Triangles of the whole part: the part itself where the model is a mesh, a tessellation where
    /// it is NURBS.
    pub mesh: Mesh,
    /// Tree over `mesh`.
    pub bvh: MeshBvh,
    /// Exact faces, if the model has them.
    pub brep: Option<Brep>,
    /// Greatest distance between `mesh` and the part, mm: the exact faces, and what was published
    /// otherwise. 0 where the model is a mesh as its file has it.
    pub deflection_mm: f64,
    /// What ties `mesh` to `brep`.
    tie: Tie,
    /// Surface as its file has it, where that was changed to close the part.
    published: Option<Box<Published>>,
    /// See [`Part::sharper`].
    sharper: OnceLock<Option<Box<Part>>>,
}

/// Surface that belongs to the part besides its own: what sewing or healing moved or left out, as
/// the file has it.
#[derive(Clone)]
struct Published {
    part: Part,
    /// The face or group of the part that each face or group of it is.
    of: Vec<Option<u32>>,
    /// How far it stands off the part's own surface, mm.
    off_mm: f64,
}

/// Published surface counts where it is nearer than the part's own by more than this, mm: nearly
/// all of it lies on that.
const NEARER_MM: f64 = 1e-5;
/// Places on each edge of published faces at which is measured how far they stand off the part.
const EDGE_PLACES: usize = 32;

/// How near the triangles of [`Part::sharper`] are, mm, as far as about so many do.
const SHARP_MM: f64 = 0.001;
const SHARP_MOST: usize = 250_000;

/// Farther from the exact faces than so many times the deflection their mesh does not lie between
/// them and a point.
const FAR: f64 = 2.0;

/// What a part knows of its exact faces besides the faces.
#[derive(Clone)]
enum Tie {
    /// The part is a mesh.
    None,
    /// The loops of the faces: enough to look at the part.
    Loops(Loops),
    /// The index for exact distances, with the loops in it.
    Exact(Box<Exact>),
}

impl Part {
    /// What a face is called in every message: as in its file (`face 12`, `face 12 (D75)`,
    /// `face 12 "hub"`), else by its number from 1; on a mesh the group of triangles by its number
    /// from 1.
    pub fn face_name(&self, face: u32) -> String {
        match self.brep.as_ref().and_then(|b| b.faces.get(face as usize)) {
            Some(Face { name: FaceName::Own(own), .. }) if own.is_empty() => format!("face {}", face + 1),
            Some(Face { name: FaceName::Own(own), .. }) => format!("face {own}"),
            Some(f) => f.name.to_string(),
            None => format!("group {}", face + 1),
        }
    }

    /// A part that is a mesh.
    pub fn from_mesh(mesh: Mesh) -> Self {
        let bvh = MeshBvh::new(&mesh);
        Part { mesh, bvh, brep: None, deflection_mm: 0.0, tie: Tie::None, published: None, sharper: OnceLock::new() }
    }

    /// As [`Part::from_brep`] without the index for exact distances: for looking at a part.
    /// Distances are to the mesh.
    ///
    /// # Errors
    /// See [`tessellate`].
    pub fn meshed(brep: Brep, deflection_mm: f64, observer: &dyn Observer) -> Result<Self> {
        let t = tessellate(&brep, &TessellateOptions::with_deflection(deflection_mm), observer)?;
        Ok(Self::tied(Tie::Loops(Loops::new(&t)), t))
    }

    /// A part of exact faces: tessellates them to `deflection_mm`, which the distance does not
    /// depend on. What was reached is in [`Part::deflection_mm`].
    ///
    /// # Errors
    /// See [`tessellate`].
    pub fn from_brep(brep: Brep, deflection_mm: f64, observer: &dyn Observer) -> Result<Self> {
        let t = tessellate(&brep, &TessellateOptions::with_deflection(deflection_mm), observer)?;
        Ok(Self::tied(Tie::Exact(Box::new(Exact::new(&t))), t))
    }

    fn tied(tie: Tie, t: Tessellation) -> Self {
        let bvh = MeshBvh::new(&t.mesh);
        Part {
            mesh: t.mesh,
            bvh,
            brep: Some(t.brep),
            deflection_mm: t.deflection_mm,
            tie,
            published: None,
            sharper: OnceLock::new(),
        }
    }

    /// The part with surface that its file has otherwise: distances are to both from here on, and
    /// how far it stands off the part, measured at its corners and along its edges, counts as
    /// deflection. `of`: for each of its faces or groups the one of the part that it was.
    #[must_use]
    pub fn with_published(mut self, published: Part, of: Vec<Option<u32>>) -> Self {
        let off = |p: &Point| self.own_closest(p, f64::INFINITY, 0.0).map_or(0.0, |c| c.distance_mm);
        let off_mm = parallel::map(&published.places(), off).into_iter().fold(0.0, f64::max);
        self.deflection_mm += off_mm;
        self.sharper = OnceLock::new();
        self.published = Some(Box::new(Published { part: published, of, off_mm }));
        self
    }

    /// Surface that belongs to the part as its file has it, where that was changed.
    pub fn published(&self) -> Option<&Part> {
        self.published.as_ref().map(|p| &p.part)
    }

    /// Corners of the mesh and places along the edges.
    fn places(&self) -> Vec<Point> {
        let edges = self.brep.iter().flat_map(|b| &b.edges);
        let on = edges.flat_map(|e| (0..=EDGE_PLACES).map(|k| e.at(k as f64 / EDGE_PLACES as f64)));
        self.mesh.points.iter().copied().chain(on).collect()
    }

    /// Places on the edges of the faces, or of the triangles where the part is a mesh, about
    /// `step_mm` apart at most.
    pub fn along_edges(&self, step_mm: f64) -> Vec<Point> {
        let count = |length_mm: f64| (length_mm / step_mm).ceil().clamp(1.0, 1e5) as usize;
        if let Some(brep) = &self.brep {
            return brep
                .edges
                .iter()
                .flat_map(|e| {
                    let chords = (0..EDGE_PLACES).map(|k| [k, k + 1].map(|k| e.at(k as f64 / EDGE_PLACES as f64)));
                    let n = count(chords.map(|[a, b]| (b - a).norm()).sum());
                    (0..=n).map(|k| e.at(k as f64 / n as f64)).collect::<Vec<_>>()
                })
                .collect();
        }
        let sides = (0..self.mesh.triangles.len()).flat_map(|t| {
            let c = self.mesh.corners(t);
            [[c[0], c[1]], [c[1], c[2]], [c[2], c[0]]]
        });
        sides
            .flat_map(|[a, b]| {
                let n = count((b - a).norm());
                (0..=n).map(move |k| a + (b - a) * (k as f64 / n as f64))
            })
            .collect()
    }

    /// The closest point of the part to `q`, or `None` where the part is farther than `cap_mm`
    /// (which may be infinite). It lies on the exact faces where the part has them
    /// ([`super::exact`]), and on the mesh otherwise. Where the faces or triangles as published are
    /// nearer, it lies on those.
    pub fn closest(&self, q: &Point, cap_mm: f64) -> Option<Closest> {
        self.closest_within(q, cap_mm, 0.0)
    }

    /// As [`Part::closest`], but the point may be `negligible_mm` farther than the closest, and
    /// there may be none where the part is nearer than `cap_mm` by no more than that. Where much of
    /// the part is about as far, as from the axis of a round edge, that is found much sooner.
    pub fn closest_within(&self, q: &Point, cap_mm: f64, negligible_mm: f64) -> Option<Closest> {
        let own = self.own_closest(q, cap_mm, negligible_mm);
        let Some(published) = &self.published else { return own };
        let within = own.map_or(cap_mm, |c| c.distance_mm - NEARER_MM);
        if within <= 0.0 {
            return own;
        }
        let Some(near) = published.part.closest_within(q, within, negligible_mm) else { return own };
        // What has no counterpart in the part lies beside something that it has.
        let own = own.or_else(|| self.own_closest(q, f64::INFINITY, negligible_mm))?;
        Some(match published.of.get(near.face as usize).copied().flatten() {
            Some(face) => Closest { face, triangle: own.triangle, ..near },
            None => Closest { face: own.face, uv: own.uv, triangle: own.triangle, ..near },
        })
    }

    /// Whether the nearest place of the part to `q` is on surface that its file has otherwise.
    pub fn nearest_is_published(&self, q: &Point) -> bool {
        let distance = |c: Option<Closest>| c.map_or(f64::INFINITY, |c| c.distance_mm);
        distance(self.closest(q, f64::INFINITY)) < distance(self.own_closest(q, f64::INFINITY, 0.0))
    }

    /// As [`Part::closest_within`] without what was published otherwise.
    fn own_closest(&self, q: &Point, cap_mm: f64, negligible_mm: f64) -> Option<Closest> {
        match (&self.brep, &self.tie) {
            (Some(brep), Tie::Exact(exact)) => exact.closest_within(brep, q, cap_mm, negligible_mm),
            _ => self.closest_on_mesh(q, cap_mm),
        }
    }

    /// The part's own exact faces and the index of their pieces. Bounds from them keep
    /// [`Part::off_own_mm`] as room for what was published otherwise.
    pub fn exact(&self) -> Option<(&Brep, &Exact)> {
        match (&self.brep, &self.tie) {
            (Some(brep), Tie::Exact(exact)) => Some((brep, exact)),
            _ => None,
        }
    }

    /// How far surface that the file has otherwise stands off the part's own, mm; 0 where nothing
    /// was changed.
    pub fn off_own_mm(&self) -> f64 {
        self.published.as_ref().map_or(0.0, |p| p.off_mm)
    }

    /// Triangles within `limit_mm` of the exact faces, where the part has them, no more than about
    /// `most`; nearer to the part than its own mesh, for bounds alone. What was published otherwise
    /// counts in their deflection.
    pub fn fine(&self, limit_mm: f64, most: usize) -> Option<Fine> {
        let (brep, exact) = self.exact()?;
        let mut fine = exact.fine(brep, &self.mesh, limit_mm, most);
        let nearest = |p: &Point| self.closest_on_mesh(p, f64::INFINITY).and_then(|c| c.triangle);
        fine.finish(|p| nearest(p).unwrap_or(0));
        fine.deflection_mm += self.off_own_mm();
        Some(fine)
    }

    /// The part by triangles that are nearer to its exact faces than its own mesh is, for distances
    /// that the mesh is too coarse to resolve. They do not fit together. Made when it is first
    /// asked for; `None` where the part has no exact faces, or its mesh is as near.
    pub fn sharper(&self) -> Option<&Part> {
        let make = || -> Option<Box<Part>> {
            let fine = self.fine(SHARP_MM, SHARP_MOST).filter(|f| f.deflection_mm < 0.5 * self.deflection_mm)?;
            let mut mesh = Mesh::default();
            for (corners, parent) in fine.corners.iter().zip(&fine.parents) {
                let first = mesh.points.len() as u32;
                mesh.points.extend(corners);
                mesh.triangles.push([first, first + 1, first + 2]);
                mesh.face_of.push(self.mesh.face(*parent as usize));
            }
            Some(Box::new(Part { deflection_mm: fine.deflection_mm, ..Part::from_mesh(mesh) }))
        };
        self.sharper.get_or_init(|| on_own_threads(make)?).as_deref()
    }

    /// Principal curvatures of the part at a point of it, signed towards its outward normal
    /// (negative where convex, as on a ball), with their directions. On an edge those of the face
    /// that the point names. `None` at a pole, and where the part is a mesh.
    pub fn curvature_at(&self, at: &Closest) -> Option<Principal> {
        let face = self.brep.as_ref()?.faces.get(at.face as usize)?;
        let found = face.surface.curvature(at.uv[0], at.uv[1])?;
        Some(if face.reversed { found.seen_from_behind() } else { found })
    }

    /// Area and volume: of the exact faces where the part has them ([`Loops::measure`]), of the
    /// triangles otherwise.
    pub fn measure(&self) -> Measured {
        match (&self.brep, &self.tie) {
            (Some(brep), Tie::Loops(loops)) => loops.measure(brep, &self.mesh),
            (Some(brep), Tie::Exact(exact)) => exact.loops.measure(brep, &self.mesh),
            _ => Measured { area_mm2: self.mesh.area_mm2(), volume_mm3: self.mesh.volume_mm3(), ..Measured::default() },
        }
    }

    /// Moves the part.
    #[must_use]
    pub fn moved(self, to_from: &super::Rigid) -> Self {
        let mesh = self.mesh.moved(to_from);
        let bvh = MeshBvh::new(&mesh);
        let brep = self.brep.map(|b| b.moved(to_from));
        let tie = match (self.tie, &brep) {
            (Tie::Exact(exact), Some(b)) => Tie::Exact(Box::new(exact.moved(b, to_from))),
            (tie, _) => tie,
        };
        let published = self.published.map(|p| Box::new(Published { part: p.part.moved(to_from), ..*p }));
        Part { mesh, bvh, brep, deflection_mm: self.deflection_mm, tie, published, sharper: OnceLock::new() }
    }

    /// The part and a copy of it elsewhere as one: its faces or groups, and triangles, are followed
    /// by those of the copy.
    ///
    /// # Errors
    /// See [`tessellate`]: a part of exact faces is meshed and indexed anew.
    pub fn with_copy(&self, to: &super::Rigid, observer: &dyn Observer) -> Result<Self> {
        let deflection_mm = self.deflection_mm - self.off_own_mm();
        let own = match (&self.brep, &self.tie) {
            (Some(brep), Tie::Exact(_)) => {
                Part::from_brep(brep.clone().and(brep.clone().moved(to)), deflection_mm, observer)?
            }
            (Some(brep), _) => Part::meshed(brep.clone().and(brep.clone().moved(to)), deflection_mm, observer)?,
            (None, _) => {
                let mesh = self.mesh.clone().and(self.mesh.clone().moved(to));
                Part { deflection_mm, ..Part::from_mesh(mesh) }
            }
        };
        let Some(published) = &self.published else { return Ok(own) };
        let count = self.brep.as_ref().map_or(self.mesh.groups(), |b| b.faces.len() as u32);
        let of = published.of.iter().copied().chain(published.of.iter().map(|of| of.map(|face| face + count)));
        Ok(own.with_published(published.part.with_copy(to, observer)?, of.collect()))
    }

    /// The mirror image across the plane z = 0.
    ///
    /// # Errors
    /// See [`tessellate`]: a part of exact faces is meshed and indexed anew.
    pub fn mirrored(&self, observer: &dyn Observer) -> Result<Self> {
        let whole = self.own_mirrored(observer)?;
        let Some(published) = &self.published else { return Ok(whole) };
        Ok(whole.with_published(published.part.mirrored(observer)?, published.of.clone()))
    }

    /// As [`Part::mirrored`] without what was published otherwise.
    fn own_mirrored(&self, observer: &dyn Observer) -> Result<Self> {
        if let Some(brep) = &self.brep {
            let mirrored = brep.clone().mirrored();
            let deflection_mm = self.deflection_mm - self.off_own_mm();
            return match self.tie {
                Tie::Exact(_) => Part::from_brep(mirrored, deflection_mm, observer),
                _ => Part::meshed(mirrored, deflection_mm, observer),
            };
        }
        let mut mesh = self.mesh.clone();
        mesh.points.iter_mut().for_each(|p| p.z = -p.z);
        mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        mesh.corner_uv.iter_mut().for_each(|t| t.swap(1, 2));
        Ok(Part::from_mesh(mesh))
    }

    /// As [`Self::closest`], to the triangles alone.
    pub fn closest_on_mesh(&self, q: &Point, cap_mm: f64) -> Option<Closest> {
        let near = self.bvh.closest(&self.mesh, q, cap_mm)?;
        Some(Closest {
            point: near.foot,
            distance_mm: near.distance_mm,
            normal: self.mesh.normal(near.triangle as usize),
            face: self.mesh.face(near.triangle as usize),
            uv: [0.0; 2],
            triangle: Some(near.triangle),
        })
    }

    /// Whether `q` lies inside the part; meaningful for a closed part with outward normals. Where
    /// the part has exact faces their normals decide near them, up to the part itself
    /// ([`Exact::inside`]). Farther from them than the mesh is, the winding of the mesh round the
    /// point decides ([`MeshBvh::winding`]). That stays right where faces fold over themselves, and
    /// beside cusps, where faces have no normal. On a mesh its triangles decide:
    ///
    /// The sign comes from the angle-weighted pseudonormal at the closest point (Bærentzen and
    /// Aanæs, *Signed distance computation using the angle weighted pseudonormal*, 2005), which is
    /// right on faces, edges and vertices alike. A point on the mesh counts as outside.
    pub fn inside(&self, q: &Point) -> bool {
        if let (Some(brep), Tie::Exact(exact)) = (&self.brep, &self.tie) {
            let far = exact.closest(brep, q, FAR * self.deflection_mm).is_none();
            let winding = if far { self.bvh.winding(&self.mesh, q) } else { None };
            return winding.map_or_else(|| exact.inside(brep, q), |w| w > 0);
        }
        let Some(near) = self.bvh.closest(&self.mesh, q, f64::INFINITY) else { return false };
        let direction = q - near.foot;
        // Triangles that meet at the foot are found by distance, so vertices need not be shared by
        // index.
        let scale = near.foot.coords.amax().max(near.distance_mm).max(1.0);
        let tolerance_mm = 1e-10 * scale;
        let mut pseudonormal = Vector::zeros();
        self.bvh.for_each_within(&self.mesh, &near.foot, tolerance_mm, |t| {
            let corners = self.mesh.corners(t.triangle as usize);
            pseudonormal += self.mesh.normal(t.triangle as usize) * angle_at(&corners, &near.foot, tolerance_mm);
        });
        direction.dot(&pseudonormal) < 0.0
    }
}

/// Work on threads of its own, for what is made under a lock. A thread of a pool that waits for its
/// share of some work takes up other work of the pool meanwhile; where that asks for the same lock,
/// it would wait for itself. `None`: the system has no threads left.
fn on_own_threads<T: Send>(work: impl FnOnce() -> T + Send) -> Option<T> {
    let threads = rayon::current_num_threads();
    std::thread::scope(|scope| {
        let pooled = || Some(rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()?.install(work));
        std::thread::Builder::new().spawn_scoped(scope, pooled).ok()?.join().ok()?
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::brep::SurfaceKind;
    use crate::geometry::nurbs::shapes;
    use crate::observe::Silent;
    use proptest::prelude::*;

    /// The unit cube [0, 1]³ as twelve triangles.
    fn cube() -> Part {
        let points = (0..8).map(|i| Point::new((i & 1) as f64, ((i >> 1) & 1) as f64, ((i >> 2) & 1) as f64)).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
        Part::from_mesh(Mesh { points, triangles, ..Mesh::default() })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        #[test]
        fn cube_against_closed_form(x in -1.0..2.0f64, y in -1.0..2.0f64, z in -1.0..2.0f64) {
            let part = cube();
            prop_assert!((part.mesh.volume_mm3() - 1.0).abs() < 1e-12);
            let q = Point::new(x, y, z);
            let c = part.closest(&q, f64::INFINITY).unwrap();
            let inside = [x, y, z].iter().all(|v| (0.0..1.0).contains(v));
            let outside = Vector::from_fn(|i, _| (-q[i]).max(q[i] - 1.0).max(0.0)).norm();
            let inner = [x, y, z].iter().map(|v| v.min(1.0 - v)).fold(f64::MAX, f64::min);
            let expected = if inside { inner } else { outside };
            prop_assert!((c.distance_mm - expected).abs() < 1e-12);
            prop_assert!(((q - c.point).norm() - c.distance_mm).abs() < 1e-15);
            prop_assert_eq!(part.inside(&q), inside);
            prop_assert!(part.closest(&q, expected * 0.999).is_none());
            prop_assert!(part.closest(&q, expected * 1.001 + 1e-12).is_some());
        }
    }

    /// A thread that makes the sharper part and waits for its share of it may take up other work
    /// that asks for it too.
    #[test]
    fn many_threads_may_ask_for_the_sharper_part() {
        let surface = shapes::torus(15.0, 4.0);
        let face =
            Face { name: FaceName::Numbered(1), kind: SurfaceKind::BSpline, surface, reversed: false, loops: vec![] };
        let brep = Brep { faces: vec![face], edges: vec![] };
        let (told, ended) = std::sync::mpsc::channel();
        std::thread::spawn(move || {
            for _ in 0..6 {
                let part = Part::from_brep(brep.clone(), 0.2, &Silent).unwrap();
                let size = |_: usize| part.sharper().map_or(0, |p| p.mesh.triangles.len());
                let sizes: Vec<usize> = parallel::map(0..64, size);
                told.send(sizes).unwrap();
            }
        });
        for _ in 0..6 {
            let sizes = ended.recv_timeout(std::time::Duration::from_mins(2)).unwrap();
            assert!(sizes[0] > 1000 && sizes.iter().all(|n| *n == sizes[0]), "{sizes:?}");
        }
    }

    #[test]
    fn winding_counts_bodies() {
        // Two cubes that overlap, and one that is inside out.
        let one = cube().mesh;
        let mut all = one.clone();
        for (shift, turned) in [([0.5, 0.4, 0.3], false), ([3.0, 0.0, 0.0], true)] {
            let base = all.points.len() as u32;
            all.points.extend(one.points.iter().map(|p| p + Vector::from(shift)));
            all.triangles.extend(one.triangles.iter().map(|t| t.map(|i| i + base)));
            if turned {
                (24..36).for_each(|t| all.turn(t));
            }
        }
        let bvh = MeshBvh::new(&all);
        let winding = |x: f64, y: f64, z: f64| bvh.winding(&all, &Point::new(x, y, z));
        assert_eq!(winding(0.2, 0.2, 0.2), Some(1));
        assert_eq!(winding(0.7, 0.6, 0.5), Some(2));
        assert_eq!(winding(1.2, 1.2, 1.1), Some(1));
        assert_eq!(winding(3.5, 0.5, 0.5), Some(-1));
        assert_eq!(winding(-0.3, 0.5, 0.5), Some(0));
        // The first ray runs through a corner: another decides.
        let cube = MeshBvh::new(&one);
        for s in [0.1, 0.4, 2.0] {
            for (k, corner) in one.points.iter().enumerate() {
                let q = corner - Vector::new(0.713, 0.527, 0.463) * s;
                let inside = q.coords.iter().all(|x| *x > 0.0 && *x < 1.0);
                assert_eq!(cube.winding(&one, &q), Some(i32::from(inside)), "corner {k}, {s}");
            }
        }
    }

    #[test]
    fn triangles_within_radius_are_those_of_brute_force() {
        let part = cube();
        let q = Point::new(0.4, 0.7, 1.3);
        let found: std::collections::BTreeSet<u32> =
            part.bvh.triangles_within(&part.mesh, &q, 0.8).iter().map(|n| n.triangle).collect();
        let expected: std::collections::BTreeSet<u32> = (0..12u32)
            .filter(|t| {
                (super::super::triangle::closest_on_triangle(&part.mesh.corners(*t as usize), &q) - q).norm() <= 0.8
            })
            .collect();
        assert!(found.len() > 2 && found.len() < 12);
        assert_eq!(found, expected);
    }

    #[test]
    fn mirror_image_has_mirrored_answers() {
        use crate::geometry::brep::{Face, SurfaceKind};
        use crate::geometry::nurbs::shapes::loft;
        let face =
            Face { name: "f".into(), kind: SurfaceKind::BSpline, surface: loft(), reversed: false, loops: vec![] };
        let sheet = Part::from_brep(Brep { faces: vec![face], edges: vec![] }, 0.05, &crate::observe::Silent).unwrap();
        for part in [sheet, cube()] {
            let image = part.mirrored(&crate::observe::Silent).unwrap();
            for q in [Point::new(1.0, 3.0, 2.0), Point::new(-4.0, 0.5, 30.0), Point::new(0.2, 0.7, 1.4)] {
                let (a, b) =
                    (part.closest(&q, 100.0).unwrap(), image.closest(&Point::new(q.x, q.y, -q.z), 100.0).unwrap());
                assert!((a.distance_mm - b.distance_mm).abs() < 1e-9);
                assert!((Vector::new(a.normal.x, a.normal.y, -a.normal.z) - b.normal).norm() < 1e-6);
            }
        }
    }

    #[test]
    fn nothing_to_find() {
        let empty = Part::from_mesh(Mesh::default());
        assert!(empty.closest(&Point::origin(), 1.0).is_none());
        assert!(!empty.inside(&Point::origin()));
        assert!(cube().closest(&Point::new(f64::NAN, 0.0, 0.0), f64::INFINITY).is_none());
    }
}
