//! Trimmed NURBS faces to one watertight triangle mesh.
//!
//! In: a [`Brep`], a greatest distance between mesh and surfaces. Out: a [`Tessellation`]: the
//! mesh, and for every face the loops of its trimming curves in its parameter plane, which the
//! exact distance needs.
//!
//! How: every edge is cut into chords once ([`edges`]), and all faces use the same points, so
//! neighbouring faces fit together by construction. Each loop is carried into the face's parameter
//! plane by projecting its points ([`loops`]); closed surfaces are unrolled, poles become a side of
//! the loop. The region inside is filled with a grid that is as dense along u and along v as
//! curvature asks for, separately (long thin triangles along a straight span are wanted), by
//! constrained Delaunay ([`fill`]). The deflection is then measured inside triangles and the grid
//! refined until it holds.
//!
//! Guarantees: no face is dropped; a face that cannot be filled is an error that names it.
//! Triangles wind counter-clockwise seen from outside by [`crate::geometry::brep::Face::reversed`].
//! The result does not depend on the number of threads.
//!
//! Limits: trimming curves must not cross one another by more than their chords' tolerance; edges
//! count as shared if they are the same `Edge` or coincide within the weld tolerance.

pub mod edges;
pub mod fill;
pub mod grid;
pub mod loops;

use std::sync::atomic::{AtomicUsize, Ordering};

use super::brep::{Brep, Face};
use super::mesh::Mesh;
use super::nurbs::foot::ParameterSpace;
use super::{Point, Vector};
use crate::error::{Error, Result, Stage};
use crate::observe::Observer;
use crate::parallel;
use loops::TrimRing;

/// What the tessellation aims at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TessellateOptions {
    /// Greatest distance between mesh and part, mm.
    pub deflection_mm: f64,
    /// Greatest turn of the normal across one triangle or of the tangent along one chord, rad.
    pub angle_rad: f64,
    /// End points and edges nearer than this are the same, mm; in small parts only those nearer
    /// than [`WELD`] of the part's size.
    pub weld_mm: f64,
}

impl TessellateOptions {
    /// A deflection with usual other values: 12°, welding at 10⁻⁴ mm.
    pub fn with_deflection(deflection_mm: f64) -> Self {
        TessellateOptions { deflection_mm, angle_rad: 12f64.to_radians(), weld_mm: 1e-4 }
    }
}

/// No points farther apart than this share of the part's size are the same: the edges of small
/// blades are as thin as that.
const WELD: f64 = 2e-6;

/// No chord at this side of a triangle.
pub const NO_CHORD: u32 = u32::MAX;

/// Ids of a face's own points start here; those below are shared.
pub(crate) const OWN: u32 = 1 << 31;

/// Chords are split for the surface beside them in at most this many rounds.
const SPLIT_ROUNDS: usize = 8;

/// One chord of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// Index into the edges of [`Tessellation::brep`].
    pub edge: u32,
    /// Parameters of its ends on that edge.
    pub t: [f64; 2],
}

/// A face's trimming, in its parameter plane.
#[derive(Clone, Debug)]
pub struct Trim {
    /// How its parameters run.
    pub space: ParameterSpace,
    /// Loops around the face.
    pub rings: Vec<TrimRing>,
    /// Greatest distance between the trimming curve and the sides of `rings`, on the surface, mm.
    pub blur_mm: f64,
}

/// A mesh with its way back to the exact faces.
#[derive(Clone, Debug)]
pub struct Tessellation {
    /// The mesh.
    pub mesh: Mesh,
    /// The input, with coinciding edges made one and edges added around faces that had no loop.
    pub brep: Brep,
    /// Trimming of each face.
    pub trims: Vec<Trim>,
    /// All chords of all edges.
    pub chords: Vec<Chord>,
    /// Per triangle and side (corner k to corner k + 1): index into `chords`, or [`NO_CHORD`]
    /// inside the face.
    pub chord_of: Vec<[u32; 3]>,
    /// Measured distance between mesh and part, with a margin for what lies between samples, mm.
    pub deflection_mm: f64,
}

/// An error about one face: name, kind, and where it is.
pub(crate) fn face_error(face: &Face, what: &str) -> Error {
    let near = face.surface.points.get(face.surface.points.len() / 2).map_or([0.0; 3], |p| (p.xyz() / p.w).into());
    Error::io(
        Stage::Model,
        format!("{} ({:?}, near x {:.3} y {:.3} z {:.3} mm) {what}", face.name, face.kind, near[0], near[1], near[2]),
    )
    .advise("check this face in CAD, heal the model and export it again")
}

/// Tessellates all faces.
///
/// # Errors
/// Options that are not positive; curves and surfaces that cannot be evaluated; loops that do not
/// close or do not lie on their face; a region that cannot be filled: each with the face's name.
/// `Cancelled`.
pub fn tessellate(brep: &Brep, options: &TessellateOptions, observer: &dyn Observer) -> Result<Tessellation> {
    if !(options.deflection_mm > 0.0 && options.angle_rad > 0.0 && options.weld_mm > 0.0) {
        return Err(Error::usage(
            Stage::Model,
            "deflection, angle and weld tolerance of a tessellation must be positive",
        ));
    }
    validate(brep)?;
    let mut brep = brep.clone();
    let options = &TessellateOptions { weld_mm: options.weld_mm.min(WELD * size_mm(&brep)), ..*options };
    let spaces: Vec<ParameterSpace> =
        brep.faces.iter().map(|f| ParameterSpace::of(&f.surface, 10.0 * options.weld_mm)).collect();
    edges::add_natural_loops(&mut brep, &spaces);
    let mut net = edges::EdgeNet::new(&mut brep, options)?;
    let mut filled: Vec<Option<fill::Filled>> = vec![None; brep.faces.len()];
    for round in 0.. {
        fill_missing(&brep, &net, &spaces, options, observer, &mut filled)?;
        let mut marks = vec![false; net.chords.len()];
        filled.iter().flatten().flat_map(|f| &f.split).for_each(|c| marks[*c as usize] = true);
        if round == SPLIT_ROUNDS || !marks.contains(&true) {
            break;
        }
        let (edges, renumbered) = net.split(&brep, &marks);
        for (face, slot) in brep.faces.iter().zip(&mut filled) {
            if face.loops.iter().flatten().any(|c| edges[c.edge]) {
                *slot = None;
            } else if let Some(f) = slot {
                f.renumber(&renumbered);
            }
        }
    }
    let mut out = Tessellation {
        mesh: Mesh { points: net.points.clone(), ..Mesh::default() },
        brep: Brep::default(),
        trims: Vec::new(),
        chords: net.chords.clone(),
        chord_of: Vec::new(),
        deflection_mm: net.deflection_mm,
    };
    for (f, filled) in filled.into_iter().enumerate() {
        let filled = filled.ok_or_else(|| face_error(&brep.faces[f], "was not filled"))?;
        out.append(f as u32, filled);
    }
    out.brep = brep;
    Ok(out)
}

/// Diameter of the sphere round the middle of the edges' control points, or of the faces' where
/// there are no edges, mm: the same however the part is turned.
fn size_mm(brep: &Brep) -> f64 {
    let of_edges = brep.edges.iter().flat_map(|e| &e.curve.points);
    let of_faces = brep.faces.iter().flat_map(|f| &f.surface.points).filter(|_| brep.edges.is_empty());
    let points: Vec<Point> = of_edges.chain(of_faces).map(|p| Point::from(p.xyz() / p.w)).collect();
    let middle = points.iter().map(|p| p.coords).sum::<Vector>() / points.len().max(1) as f64;
    2.0 * points.iter().map(|p| (p.coords - middle).norm()).fold(0.0, f64::max)
}

/// Fills all faces that are not filled yet.
fn fill_missing(
    brep: &Brep,
    net: &edges::EdgeNet,
    spaces: &[ParameterSpace],
    options: &TessellateOptions,
    observer: &dyn Observer,
    filled: &mut [Option<fill::Filled>],
) -> Result<()> {
    let total = filled.len();
    let done = AtomicUsize::new(filled.iter().flatten().count());
    let missing = filled.iter_mut().enumerate().filter(|(_, slot)| slot.is_none());
    let results: Vec<Result<()>> = parallel::map(missing, |(f, slot)| {
        observer.check(Stage::Model)?;
        *slot = Some(fill::fill_face(brep, f, net, spaces[f], options)?);
        observer.progress(Stage::Model, done.fetch_add(1, Ordering::Relaxed) + 1, total);
        Ok(())
    });
    results.into_iter().collect()
}

impl Tessellation {
    /// Adds one face.
    fn append(&mut self, face: u32, filled: fill::Filled) {
        let first = self.mesh.points.len() as u32;
        self.mesh.points.extend(filled.points);
        for t in filled.triangles {
            self.mesh.triangles.push(t.corners.map(|i| if i < OWN { i } else { i - OWN + first }));
            self.mesh.corner_uv.push(t.uv);
            self.mesh.face_of.push(face);
            self.chord_of.push(t.chords);
        }
        self.deflection_mm = self.deflection_mm.max(filled.deflection_mm);
        self.trims.push(filled.trim);
    }
}

/// Checks all curves, surfaces and indices, so that nothing later can meet one that is broken.
fn validate(brep: &Brep) -> Result<()> {
    for face in &brep.faces {
        face.surface.validate().map_err(|e| face_error(face, &format!("has a broken surface: {}", e.message)))?;
        for coedge in face.loops.iter().flatten() {
            let Some(edge) = brep.edges.get(coedge.edge) else {
                return Err(face_error(face, &format!("uses edge {}, which does not exist", coedge.edge)));
            };
            edge.curve.validate().map_err(|e| face_error(face, &format!("has a broken edge: {}", e.message)))?;
            let [from, to] = edge.t;
            if !(from.is_finite() && to.is_finite() && from < to) {
                return Err(face_error(face, &format!("has an edge with the empty range {from} to {to}")));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
