//! The exact distance to trimmed NURBS faces.
//!
//! In: faces and edges, and their trimming in the parameter plane ([`super::tessellate`]). Out: the
//! closest point of the part, with its face, parameters and normal; whether a point is inside.
//!
//! All faces are cut into small pieces ([`build`]), each a polynomial on a rectangle ([`patch`]),
//! with a box in which it lies by the convex hull of its control points, and with bounds of its
//! curvature ([`leaf`]). Pieces beyond the loops are left out, those that loops cross know the
//! sides that do ([`trim`]). Edges are cut into pieces alike. A tree over all of them ([`tree`]) is
//! searched best first ([`search`]). The result is the least of all local minima: on pieces that
//! could hold a nearer point, on all edges, and on the traces of edges on faces that they lie off
//! ([`trace`]).
//!
//! **Guarantees.** The point lies on the part, to rounding: on a face inside its loops (or at most
//! [`trim::BEYOND_EDGE_MM`] beyond, so that smooth joints have no crack) or on an edge. No point of
//! the part is nearer by more than 10⁻⁷ mm, as far as the curvature of a piece lies within the
//! bounds measured on it. Two cases have a wider bound:
//!
//! * 10⁻⁴ mm about points from which a whole stretch of a face or edge is equally far, where more
//!   would take time without end;
//! * 10⁻³ mm beside edges that lie off their faces.
//!
//! The answer depends on nothing but part and point.
//!
//! **Limits.** Faces of more than [`patch::MOST_COEFFICIENTS`] coefficients are bounded by samples
//! instead of control points, and are slower.

mod build;
pub mod fine;
mod leaf;
pub mod measure;
mod newton;
mod patch;
pub mod pieces;
mod search;
mod sign;
mod trace;
mod tree;
mod trim;

#[cfg(test)]
pub(crate) mod tests;

use super::brep::Brep;
use super::measured::Closest;
use super::nurbs::foot::{ParameterSpace, SurfaceFoot};
use super::nurbs::{NurbsSurface, SurfaceDerivatives};
use super::tessellate::Tessellation;
use super::{Aabb, Point, Vector};
use crate::parallel;
use leaf::{FaceForm, Leaf, LeafArc};
use measure::Loops;
use patch::{CurveTable, SurfaceTable};
use search::{FoundPoint, On};
use sign::Corners;
use trace::Trace;
use tree::{Hull, Tree};
use trim::Border;

/// Everything that queries to exact faces need besides the faces.
#[derive(Clone, Debug)]
pub struct Exact {
    pub(super) loops: Loops,
    tables: Vec<Option<SurfaceTable>>,
    /// Of all edges, then of all traces.
    curves: Vec<CurveTable>,
    traces: Vec<Trace>,
    leaves: Vec<Leaf>,
    borders: Vec<Vec<Border>>,
    arcs: Vec<LeafArc>,
    tree: Tree,
    corners: Corners,
}

impl Exact {
    /// From a tessellation, for its faces.
    pub fn new(t: &Tessellation) -> Self {
        let loops = Loops::new(t);
        let corners = Corners::new(t, &loops.regions);
        Self::cut(&t.brep, loops, corners)
    }

    /// For the same faces after a rigid motion; `brep` is the moved one.
    #[must_use]
    pub fn moved(self, brep: &Brep, to_from: &super::Rigid) -> Self {
        Self::cut(brep, self.loops, self.corners.moved(to_from))
    }

    fn cut(brep: &Brep, loops: Loops, corners: Corners) -> Self {
        let tables: Vec<Option<SurfaceTable>> = parallel::map(&brep.faces, |f| SurfaceTable::new(&f.surface));
        let traces = trace::traces(brep, &loops);
        let all = brep.edges.iter().map(|e| &e.curve).chain(traces.iter().map(|t| &t.curve));
        let curves: Vec<CurveTable> = all.map(CurveTable::new).collect();
        let diagonal_mm = size(brep);
        let pieces = build::faces(brep, &tables, &loops.regions, diagonal_mm);
        let mut arcs = Vec::new();
        for (e, edge) in brep.edges.iter().enumerate() {
            if corners.bounds_faces(e) {
                arcs.extend(build::arcs(&curves[e], e as u32, edge.t, diagonal_mm));
            }
        }
        for (k, trace) in traces.iter().enumerate() {
            let own = brep.edges.len() + k;
            arcs.extend(build::arcs(&curves[own], own as u32, trace.curve.domain(), diagonal_mm));
        }
        let hulls: Vec<Hull> =
            pieces.leaves.iter().map(build::leaf_hull).chain(arcs.iter().map(build::arc_hull)).collect();
        let tree = Tree::new(&hulls);
        Exact { loops, tables, curves, traces, leaves: pieces.leaves, borders: pieces.borders, arcs, tree, corners }
    }

    fn shape<'a>(&'a self, brep: &'a Brep, face: u32) -> FaceForm<'a> {
        FaceForm { surface: &brep.faces[face as usize].surface, table: self.tables[face as usize].as_ref() }
    }

    /// The closest point of the part to `q`; `None` where that is farther than `cap_mm`.
    pub fn closest(&self, brep: &Brep, q: &Point, cap_mm: f64) -> Option<Closest> {
        self.closest_within(brep, q, cap_mm, 0.0)
    }

    /// A point of the part no more than `negligible_mm` farther from `q` than the closest; `None`
    /// where the part is farther than `cap_mm`, or nearer by no more than `negligible_mm`.
    pub fn closest_within(&self, brep: &Brep, q: &Point, cap_mm: f64, negligible_mm: f64) -> Option<Closest> {
        let found = search::closest(self, brep, q, cap_mm, negligible_mm.max(search::NEGLIGIBLE_MM))?;
        Some(self.finish(brep, q, &found))
    }

    fn finish(&self, brep: &Brep, q: &Point, found: &FoundPoint) -> Closest {
        let (face, uv, normal) = match found.on {
            On::Face { face, uv, normal } => {
                let outward = if brep.faces[face as usize].reversed { -normal } else { normal };
                let unit = outward.try_normalize(0.0).or_else(|| self.normal_near(brep, face, uv));
                (face, uv, unit)
            }
            On::Edge { edge, t, of } => self.beside(brep, q, &found.point, (edge, t), of),
        };
        let toward = || (q - found.point).try_normalize(0.0).unwrap_or_else(Vector::z);
        Closest {
            point: found.point,
            distance_mm: found.d2.sqrt(),
            normal: normal.unwrap_or_else(toward),
            face,
            uv,
            triangle: None,
        }
    }

    /// Of the faces that meet in an edge at a parameter the one that faces `q` most, or the one
    /// whose trace was met: number, parameters, outward normal.
    fn beside(&self, brep: &Brep, q: &Point, at: &Point, (edge, t): (u32, f64), of: Option<u32>) -> Facing {
        let toward = q - at;
        let mut best: Option<(f64, Facing)> = None;
        for (face, guess) in self.corners.faces_at(edge, t).filter(|(f, _)| of.is_none_or(|of| of == *f)) {
            let (uv, normal) = self.normal_on(brep, face, guess, at);
            let facing = normal.map_or(f64::NEG_INFINITY, |n| n.dot(&toward));
            if best.is_none_or(|b| facing > b.0) {
                best = Some((facing, (face, uv, normal)));
            }
        }
        best.map_or((0, [0.0; 2], None), |b| b.1)
    }

    /// Parameters and outward normal on a face of a point that lies on it, from a guess at the
    /// parameters.
    fn normal_on(&self, brep: &Brep, face: u32, guess: [f64; 2], at: &Point) -> ([f64; 2], Option<Vector>) {
        let f = &brep.faces[face as usize];
        let space = &self.loops.regions[face as usize].trim.space;
        let foot: SurfaceFoot = f.surface.foot(at, guess, space);
        let uv = space.normal_form(foot.uv);
        let pole = is_pole(&foot.at, space);
        let normal = foot.at.normal().filter(|_| !pole).map(|m| if f.reversed { -m } else { m });
        (uv, normal.or_else(|| self.normal_near(brep, face, uv)))
    }

    /// The mean outward normal round a pole.
    fn normal_near(&self, brep: &Brep, face: u32, uv: [f64; 2]) -> Option<Vector> {
        let f = &brep.faces[face as usize];
        let domain = f.surface.domain();
        let at = f.surface.derivatives(uv[0], uv[1]);
        let length = |d: &Vector, a: usize| d.norm() * (domain[a][1] - domain[a][0]);
        let free = usize::from(length(&at.dv, 1) < length(&at.du, 0));
        let normal = |k: u32| {
            let [from, to] = domain[free];
            let mut near = uv;
            near[free] = from + (to - from) * (f64::from(k) + 0.5) / 24.0;
            near[1 - free] += 1e-4 * (0.5 * (domain[1 - free][0] + domain[1 - free][1]) - uv[1 - free]);
            f.surface.normal(near[0], near[1])
        };
        let sum: Vector = (0..24).filter_map(normal).sum();
        sum.try_normalize(1e-9).map(|m| if f.reversed { -m } else { m })
    }

    /// Number of pieces of faces and of edges.
    pub fn pieces(&self) -> [usize; 2] {
        [self.leaves.len(), self.arcs.len()]
    }
}

/// A face, parameters on it, and its outward normal there.
type Facing = (u32, [f64; 2], Option<Vector>);

/// A whole round shorter than this is a pole, mm.
const POLE_MM: f64 = 1e-5;

/// Whether one parameter, over its whole range, moves the point by next to nothing.
fn is_pole(at: &SurfaceDerivatives, space: &ParameterSpace) -> bool {
    at.du.norm() * space.period(0) < POLE_MM || at.dv.norm() * space.period(1) < POLE_MM
}

/// Diagonal of the box of the edges' control points, or of the faces' where there are no edges, mm.
fn size(brep: &Brep) -> f64 {
    let points = |h: &nalgebra::Vector4<f64>| Point::from(h.xyz() / h.w);
    let edges: Vec<Point> = brep.edges.iter().flat_map(|e| e.curve.points.iter().map(points)).collect();
    let all = |s: &NurbsSurface| s.points.iter().map(points).collect::<Vec<_>>();
    let faces = || brep.faces.iter().flat_map(|f| all(&f.surface)).collect::<Vec<_>>();
    Aabb::around(&if edges.is_empty() { faces() } else { edges }).map_or(0.0, |b| b.diagonal_mm())
}
