//! Boundary representation: NURBS faces trimmed by loops of shared edges.

use super::nurbs::{NurbsCurve, NurbsSurface};
use super::{Point, Rigid};

/// The kind of surface that a face lay on in the file, before it was written as NURBS (all kinds
/// are exact as NURBS).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceKind {
    /// Free-form.
    BSpline,
    /// Plane.
    Plane,
    /// Cylinder.
    Cylinder,
    /// Cone.
    Cone,
    /// Sphere.
    Sphere,
    /// Torus.
    Torus,
    /// Surface of revolution.
    Revolution,
    /// Surface of linear extrusion.
    Extrusion,
    /// Anything else that could be written as NURBS.
    Other,
}

/// An edge: a curve in space, walked from `t[0]` to `t[1]` (`t[0] < t[1]`). A closed edge has one
/// vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// The curve.
    pub curve: NurbsCurve,
    /// Parameter range.
    pub t: [f64; 2],
}

impl Edge {
    /// The point at a share of its parameter range.
    pub fn at(&self, share: f64) -> Point {
        self.curve.point(self.t[0] + share * (self.t[1] - self.t[0]))
    }
}

/// An edge as a loop uses it. A seam is used twice by one face, once in each sense.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Coedge {
    /// Index into [`Brep::edges`].
    pub edge: usize,
    /// The loop walks the edge from `t[1]` to `t[0]`.
    pub reversed: bool,
}

/// What a face is called.
#[derive(Clone, Debug, PartialEq)]
pub enum FaceName {
    /// By its number in its file, from 1.
    Numbered(usize),
    /// The same, with the name that the file gives it.
    Given(usize, String),
    /// The same, with the line of the file's directory that it has.
    Listed(usize, usize),
    /// By a name alone; empty where it has none.
    Own(String),
}

impl FaceName {
    /// Its name without a number; empty where it has none.
    pub fn own(&self) -> &str {
        match self {
            FaceName::Given(_, own) | FaceName::Own(own) => own,
            FaceName::Numbered(_) | FaceName::Listed(..) => "",
        }
    }
}

impl std::fmt::Display for FaceName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            FaceName::Numbered(number) => write!(f, "face {number}"),
            FaceName::Given(number, own) => write!(f, "face {number} \"{own}\""),
            FaceName::Listed(number, line) => write!(f, "face {number} (D{line})"),
            FaceName::Own(own) => f.write_str(own),
        }
    }
}

impl From<&str> for FaceName {
    fn from(own: &str) -> Self {
        FaceName::Own(own.to_owned())
    }
}

impl From<String> for FaceName {
    fn from(own: String) -> Self {
        FaceName::Own(own)
    }
}

/// A trimmed face.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Name or number in the file, for messages.
    pub name: FaceName,
    /// What it was in the file.
    pub kind: SurfaceKind,
    /// Its surface.
    pub surface: NurbsSurface,
    /// The outward normal of the part is `-(S_u × S_v)` rather than `S_u × S_v`.
    pub reversed: bool,
    /// Closed loops of edges around the face, in any order and sense; none: the whole parameter
    /// rectangle.
    pub loops: Vec<Vec<Coedge>>,
}

/// Trimmed faces that share their edges.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Brep {
    /// The faces.
    pub faces: Vec<Face>,
    /// The edges.
    pub edges: Vec<Edge>,
}

impl Brep {
    /// The mirror image across the plane z = 0: exact, since NURBS are invariant under affine maps
    /// of their control points.
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        for face in &mut self.faces {
            face.reversed = !face.reversed;
            face.surface.points.iter_mut().for_each(|p| p.z = -p.z);
        }
        self.edges.iter_mut().flat_map(|e| e.curve.points.iter_mut()).for_each(|p| p.z = -p.z);
        self
    }

    /// Both, the faces and edges of the other after the own ones.
    #[must_use]
    pub fn and(mut self, other: Brep) -> Self {
        let first = self.edges.len();
        let shifted = other.faces.into_iter().map(|mut face| {
            face.loops.iter_mut().flatten().for_each(|c| c.edge += first);
            face
        });
        self.faces.extend(shifted);
        self.edges.extend(other.edges);
        self
    }

    /// Moves everything: exact, since NURBS are invariant under rigid motion of their control
    /// points.
    #[must_use]
    pub fn moved(mut self, to_from: &Rigid) -> Self {
        let m = to_from.to_homogeneous();
        for p in self.faces.iter_mut().flat_map(|f| f.surface.points.iter_mut()) {
            *p = m * *p;
        }
        for p in self.edges.iter_mut().flat_map(|e| e.curve.points.iter_mut()) {
            *p = m * *p;
        }
        self
    }
}
