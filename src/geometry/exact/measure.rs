//! Area and volume of exact faces.
//!
//! Over each triangle of the tessellation the surface itself is integrated, in the face's
//! parameters, by a rule of seven points that is exact for degree 5 (Radon 1948): area from
//! `|S_u × S_v|`, volume from `S · (S_u × S_v) / 3` (Gauss' theorem). Between the triangles'
//! straight sides in the parameter plane and the edges' own curves lie slivers; they count as
//! differences of two parabolic segments. Where a triangle touches a pole, which is a whole side of
//! the parameter rectangle, the strip between its opposite side and that one is taken.
//!
//! **Error, estimated**: what the rule of three points (exact for degree 2) gives otherwise, summed
//! without sign, and a quarter of the slivers.

use super::is_pole;
use super::trim::TrimTest;
use crate::geometry::brep::Brep;
use crate::geometry::measured::Measured;
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::geometry::nurbs::{NurbsSurface, SurfaceDerivatives};
use crate::geometry::tessellate::{Chord, NO_CHORD, Tessellation};
use crate::geometry::{Point, Vector};

/// Barycentric coordinates and weights: seven points, degree 5 (J. Radon, *Zur mechanischen
/// Kubatur*, 1948).
const SEVEN: [([f64; 3], f64); 7] = {
    const A: f64 = 0.797_426_985_353_087_3;
    const B: f64 = 0.101_286_507_323_456_33;
    const C: f64 = 0.059_715_871_789_769_82;
    const D: f64 = 0.470_142_064_105_115_1;
    const P: f64 = 0.125_939_180_544_827_15;
    const Q: f64 = 0.132_394_152_788_506_2;
    const T: f64 = 1.0 / 3.0;
    [([T, T, T], 0.225), ([A, B, B], P), ([B, A, B], P), ([B, B, A], P), ([C, D, D], Q), ([D, C, D], Q), ([D, D, C], Q)]
};
/// The same for three points, degree 2.
const THREE: [([f64; 3], f64); 3] = {
    const A: f64 = 2.0 / 3.0;
    const B: f64 = 1.0 / 6.0;
    const T: f64 = 1.0 / 3.0;
    [([A, B, B], T), ([B, A, B], T), ([B, B, A], T)]
};

/// The loops of all faces: what measuring needs besides faces and mesh, and part of what exact
/// distances need.
#[derive(Clone, Debug)]
pub struct Loops {
    pub(super) regions: Vec<TrimTest>,
    pub(super) chords: Vec<Chord>,
}

/// A face as its loops see it: parameters may lie a period or more away.
pub(super) struct OnFace<'a> {
    pub surface: &'a NurbsSurface,
    pub space: &'a ParameterSpace,
}

impl OnFace<'_> {
    /// The point of the face at these parameters.
    pub fn at(&self, uv: [f64; 2]) -> Point {
        let n = self.space.normal_form(uv);
        self.surface.point(n[0], n[1])
    }
}

impl Loops {
    /// A face of the part that these loops are of.
    pub(super) fn face<'a>(&'a self, brep: &'a Brep, face: usize) -> OnFace<'a> {
        OnFace { surface: &brep.faces[face].surface, space: &self.regions[face].trim.space }
    }

    /// Those of a tessellation.
    pub fn new(t: &Tessellation) -> Self {
        Loops { regions: t.trims.iter().map(|trim| TrimTest::new(trim.clone())).collect(), chords: t.chords.clone() }
    }

    /// Area and volume of the faces that `mesh` is the tessellation of; the volume means something
    /// where they enclose one.
    pub fn measure(&self, brep: &Brep, mesh: &Mesh) -> Measured {
        let origin = mesh.aabb().map_or_else(Point::origin, |b| nalgebra::center(&b.min, &b.max));
        let mut out = Measured::default();
        for t in 0..mesh.triangles.len() {
            self.add_triangle(brep, mesh, t, &origin, &mut out);
        }
        for face in 0..brep.faces.len() {
            self.add_slivers(brep, face, &origin, &mut out);
        }
        out
    }

    fn add_triangle(&self, brep: &Brep, mesh: &Mesh, t: usize, origin: &Point, out: &mut Measured) {
        let f = mesh.face(t) as usize;
        let Some(uv) = mesh.corner_uv.get(t) else { return };
        let (surface, space) = (&brep.faces[f].surface, &self.regions[f].trim.space);
        let at = |uv: [f64; 2]| {
            let n = space.normal_form(uv);
            surface.derivatives(n[0], n[1])
        };
        let sign = if brep.faces[f].reversed { -1.0 } else { 1.0 };
        for [a, b, c] in strips(*uv, |x| is_pole(&at(x), space).then(|| free_direction(&at(x), space))) {
            let half = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
            let rule = |rule: &[([f64; 3], f64)]| {
                let mut sum = [0.0; 2];
                for (w, weight) in rule {
                    let d = at([0, 1].map(|k| w[0] * a[k] + w[1] * b[k] + w[2] * c[k]));
                    let n = d.du.cross(&d.dv);
                    // The triangle winds counter-clockwise seen from outside: the sign of its area
                    // is that of the normal.
                    sum[0] += weight * n.norm() * half * sign;
                    sum[1] += weight * (d.p - origin).dot(&n) * half / 3.0;
                }
                sum
            };
            let (fine, coarse) = (rule(&SEVEN), rule(&THREE));
            out.area_mm2 += fine[0];
            out.volume_mm3 += fine[1];
            out.area_error_mm2 += (fine[0] - coarse[0]).abs();
            out.volume_error_mm3 += (fine[1] - coarse[1]).abs();
        }
    }

    /// What lies between the edges and the straight sides of the loops in the parameter plane.
    fn add_slivers(&self, brep: &Brep, face: usize, origin: &Point, out: &mut Measured) {
        let region = &self.regions[face];
        let surface = &brep.faces[face].surface;
        let sign = if brep.faces[face].reversed { -1.0 } else { 1.0 };
        for (r, ring) in region.trim.rings.iter().enumerate() {
            let left = if region.is_left(r) { 1.0 } else { -1.0 };
            for (k, node) in ring.nodes.iter().enumerate() {
                let (Some(chord), false) = (self.chords.get(node.chord as usize), node.chord == NO_CHORD || node.seam)
                else {
                    continue;
                };
                let next = ring.nodes[(k + 1) % ring.nodes.len()].uv;
                let middle = region.trim.space.normal_form([0, 1].map(|a| 0.5 * (node.uv[a] + next[a])));
                let d = surface.derivatives(middle[0], middle[1]);
                let Some(normal) = d.normal() else { continue };
                let curve = &brep.edges[chord.edge as usize].curve;
                let on = curve.foot(&d.p, 0.5 * (chord.t[0] + chord.t[1]), chord.t);
                let mut along: Vector = curve.point(chord.t[1]) - curve.point(chord.t[0]);
                if node.against {
                    along = -along;
                }
                let area = left * normal.dot(&(on.point - d.p).cross(&along)) * 2.0 / 3.0;
                let volume = sign * area * (on.point - origin).dot(&normal) / 3.0;
                out.area_mm2 += area;
                out.volume_mm3 += volume;
                out.area_error_mm2 += 0.25 * area.abs();
                out.volume_error_mm3 += 0.25 * volume.abs();
            }
        }
    }
}

/// The direction in which a pole's parameter is free: 0 for u, 1 for v.
pub(super) fn free_direction(at: &SurfaceDerivatives, space: &ParameterSpace) -> usize {
    usize::from(at.dv.norm() * space.period(1) < at.du.norm() * space.period(0))
}

/// The triangle itself, or where one corner is a pole the strip from the opposite side to the
/// pole's, as two triangles. `pole` names the parameter that is free at a corner that is one.
pub(super) fn strips(uv: [[f64; 2]; 3], pole: impl Fn([f64; 2]) -> Option<usize>) -> Vec<[[f64; 2]; 3]> {
    let found = (0..3).find_map(|k| pole(uv[k]).map(|free| (k, free)));
    let Some((k, free)) = found else { return vec![uv] };
    let (a, b) = (uv[(k + 1) % 3], uv[(k + 2) % 3]);
    let onto = |mut x: [f64; 2]| {
        x[1 - free] = uv[k][1 - free];
        x
    };
    vec![[onto(a), a, b], [onto(a), b, onto(b)]]
}
