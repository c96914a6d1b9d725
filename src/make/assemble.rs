//! Patches, platform and root put together: vertices, edges and faces of one closed solid.
//!
//! Every edge is a boundary curve of the surfaces beside it, taken from their control points, so
//! neighbouring faces meet exactly. Loops run counter-clockwise seen from outside; the first loop
//! of a face is its outer one.

use nalgebra::Vector4;

use super::design::{BladeDesign, PlatformDesign};
use super::ring::RingPatch;
use crate::error::{Error, Result, Stage};
use crate::geometry::brep::{Brep, Coedge, Edge, Face, FaceName, SurfaceKind};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::geometry::{Point, Vector};

/// Faces and edges with the vertices that the edges share.
#[derive(Clone, Debug, Default)]
pub(super) struct Solid {
    pub brep: Brep,
    pub vertices: Vec<Point>,
    /// Start and end vertex of every edge.
    pub ends: Vec<[usize; 2]>,
}

/// Which boundary of a surface.
#[derive(Clone, Copy)]
enum SurfaceSide {
    Bottom,
    Top,
    Start,
}

fn boundary(s: &NurbsSurface, side: SurfaceSide) -> NurbsCurve {
    let (degree, knots) = match side {
        SurfaceSide::Bottom | SurfaceSide::Top => (s.degree_u, s.knots_u.clone()),
        SurfaceSide::Start => (s.degree_v, s.knots_v.clone()),
    };
    let points = match side {
        SurfaceSide::Bottom => s.points.iter().step_by(s.n_v).copied().collect(),
        SurfaceSide::Top => s.points.iter().skip(s.n_v - 1).step_by(s.n_v).copied().collect(),
        SurfaceSide::Start => s.points[..s.n_v].to_vec(),
    };
    NurbsCurve { degree, knots, points }
}

fn cartesian(p: &Vector4<f64>) -> Point {
    Point::new(p.x / p.w, p.y / p.w, p.z / p.w)
}

fn forward(edge: usize) -> Coedge {
    Coedge { edge, reversed: false }
}

fn backward(edge: usize) -> Coedge {
    Coedge { edge, reversed: true }
}

impl Solid {
    fn vertex(&mut self, p: Point) -> usize {
        self.vertices.push(p);
        self.vertices.len() - 1
    }

    fn curve(&mut self, curve: NurbsCurve, ends: [usize; 2]) -> usize {
        let t = [curve.knots[0], curve.knots[curve.knots.len() - 1]];
        self.brep.edges.push(Edge { curve, t });
        self.ends.push(ends);
        self.ends.len() - 1
    }

    fn line(&mut self, a: usize, b: usize) -> usize {
        let points = [a, b].map(|v| self.vertices[v].to_homogeneous()).to_vec();
        self.curve(NurbsCurve { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], points }, [a, b])
    }

    fn face(&mut self, name: impl Into<FaceName>, kind: SurfaceKind, surface: NurbsSurface, loops: Vec<Vec<Coedge>>) {
        self.brep.faces.push(Face { name: name.into(), kind, surface, reversed: false, loops });
    }

    /// A flat face: the bilinear rectangle around its loops, with the normal that its outer loop
    /// turns about.
    fn flat(&mut self, name: impl Into<FaceName>, loops: Vec<Vec<Coedge>>) {
        let outline: Vec<Point> = loops.first().into_iter().flatten().flat_map(|c| self.polygon(c)).collect();
        let curved = loops.iter().flatten().any(|c| self.brep.edges[c.edge].curve.degree > 1);
        let surface = rectangle(&outline, if curved && loops.len() == 1 { 0.02 } else { 0.0 });
        self.face(name, SurfaceKind::Plane, surface, loops);
    }

    /// Control points of an edge as the loop walks it, without the last.
    fn polygon(&self, c: &Coedge) -> Vec<Point> {
        let mut points: Vec<Point> = self.brep.edges[c.edge].curve.points.iter().map(cartesian).collect();
        if c.reversed {
            points.reverse();
        }
        points.pop();
        points
    }
}

/// The rectangle around a closed polygon in its plane, enlarged by a fraction of its size;
/// `S_u × S_v` is the direction about which the polygon turns.
fn rectangle(polygon: &[Point], margin: f64) -> NurbsSurface {
    let n = polygon.len();
    let origin = polygon[0];
    let newell: Vector = (0..n).map(|i| (polygon[i] - origin).cross(&(polygon[(i + 1) % n] - origin))).sum();
    let normal = newell.normalize();
    // Along the longest side, so that rectangles fit exactly.
    let side = |i: usize| polygon[(i + 1) % n] - polygon[i];
    let longest = (0..n).fold(0, |b, i| if side(i).norm() > side(b).norm() * (1.0 + 1e-9) { i } else { b });
    let e1 = side(longest).normalize();
    let e2 = normal.cross(&e1);
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for p in polygon {
        for (r, e) in range.iter_mut().zip([e1, e2]) {
            let x = (p - origin).dot(&e);
            *r = [r[0].min(x), r[1].max(x)];
        }
    }
    let range = range.map(|[a, b]| [a - margin * (b - a), b + margin * (b - a)]);
    let corner = |a: f64, b: f64| (origin + e1 * a + e2 * b).to_homogeneous();
    let [u, v] = range;
    NurbsSurface::bilinear([corner(u[0], v[0]), corner(u[0], v[1]), corner(u[1], v[0]), corner(u[1], v[1])])
}

/// The whole solid; errors if the fillet leaves the platform.
pub(super) fn assemble(d: &BladeDesign, patches: &[RingPatch]) -> Result<Solid> {
    let mut solid = Solid::default();
    let (bottom, tip) = ring(&mut solid, patches);
    stays_on_platform(&solid, &bottom, &d.platform)?;
    solid.flat("tip", vec![tip.iter().map(|&e| forward(e)).collect()]);
    block(&mut solid, &d.platform, &bottom);
    Ok(solid)
}

/// Faces of the patches; returns the edges on the platform and at the tip, counter-clockwise.
fn ring(solid: &mut Solid, patches: &[RingPatch]) -> (Vec<usize>, Vec<usize>) {
    let n = patches.len();
    let lowest = |p: &RingPatch| p.fillet.as_ref().unwrap_or(&p.airfoil).points[0];
    let foot: Vec<usize> = patches.iter().map(|p| solid.vertex(cartesian(&lowest(p)))).collect();
    let joint: Vec<usize> = patches
        .iter()
        .zip(&foot)
        .map(|(p, &f)| if p.fillet.is_some() { solid.vertex(cartesian(&p.airfoil.points[0])) } else { f })
        .collect();
    let top: Vec<usize> =
        patches.iter().map(|p| solid.vertex(cartesian(&p.airfoil.points[p.airfoil.n_v - 1]))).collect();
    let next = |i: usize| (i + 1) % n;
    let mut bottom = Vec::new();
    let (mut joints, mut tips, mut walls, mut arcs) = (vec![], vec![], vec![], vec![]);
    for (i, p) in patches.iter().enumerate() {
        joints.push(solid.curve(boundary(&p.airfoil, SurfaceSide::Bottom), [joint[i], joint[next(i)]]));
        tips.push(solid.curve(boundary(&p.airfoil, SurfaceSide::Top), [top[i], top[next(i)]]));
        walls.push(solid.curve(boundary(&p.airfoil, SurfaceSide::Start), [joint[i], top[i]]));
        bottom.push(match &p.fillet {
            Some(f) => {
                arcs.push(solid.curve(boundary(f, SurfaceSide::Start), [foot[i], joint[i]]));
                solid.curve(boundary(f, SurfaceSide::Bottom), [foot[i], foot[next(i)]])
            }
            None => joints[i],
        });
    }
    for (i, p) in patches.iter().enumerate() {
        let edges = vec![forward(joints[i]), forward(walls[next(i)]), backward(tips[i]), backward(walls[i])];
        solid.face(p.name, p.airfoil_kind, p.airfoil.clone(), vec![edges]);
    }
    for (i, p) in patches.iter().enumerate() {
        if let Some(f) = &p.fillet {
            let edges = vec![forward(bottom[i]), forward(arcs[next(i)]), backward(joints[i]), backward(arcs[i])];
            solid.face(format!("fillet of {}", p.name), p.fillet_kind, f.clone(), vec![edges]);
        }
    }
    (bottom, tips)
}

/// Control points enclose their curve: if they are on the platform, so is the fillet.
fn stays_on_platform(solid: &Solid, bottom: &[usize], p: &PlatformDesign) -> Result<()> {
    let shear = p.shear_deg.to_radians().tan();
    let mut excess = f64::NEG_INFINITY;
    for q in bottom.iter().flat_map(|&e| &solid.brep.edges[e].curve.points).map(cartesian) {
        let (x, y) = (q.x - p.offset_x_mm, q.y - p.offset_y_mm);
        let (dx, dy) = (x.abs() - 0.5 * p.length_mm, (y - shear * x).abs() - p.outline[0].half_width_mm);
        excess = excess.max(dx).max(dy);
    }
    if excess < -0.01 {
        return Ok(());
    }
    Err(Error::usage(
        Stage::Make,
        format!("the foot of the fillet reaches {:.2} mm over the rim of the platform", excess.max(0.0)),
    )
    .advise("make the platform larger, move it (offset_x_mm, offset_y_mm, shear_deg), or make the fillet smaller"))
}

/// Platform and root: the outline drawn along x, its top with the airfoil's foot as a hole.
fn block(solid: &mut Solid, p: &PlatformDesign, bottom: &[usize]) {
    let shear = p.shear_deg.to_radians().tan();
    let at = |end: f64, side: f64, depth: f64, half: f64| {
        let x = 0.5 * p.length_mm * end;
        Point::new(x + p.offset_x_mm, side * half + shear * x + p.offset_y_mm, p.top_z_mm - depth)
    };
    let n = p.outline.len();
    // [left, right][far end at −x, near end at +x][depth]
    let v: [[Vec<usize>; 2]; 2] = [-1.0, 1.0].map(|side| {
        [-1.0, 1.0]
            .map(|end| p.outline.iter().map(|o| solid.vertex(at(end, side, o.depth_mm, o.half_width_mm))).collect())
    });
    let [[la, lb], [ra, rb]] = &v;
    let across = |solid: &mut Solid, a: &[usize], b: &[usize]| -> Vec<usize> {
        a.iter().zip(b).map(|(&a, &b)| solid.line(a, b)).collect()
    };
    let down =
        |solid: &mut Solid, a: &[usize]| -> Vec<usize> { a.windows(2).map(|w| solid.line(w[0], w[1])).collect() };
    let (left, right) = (across(solid, la, lb), across(solid, ra, rb));
    let (dla, dlb, dra, drb) = (down(solid, la), down(solid, lb), down(solid, ra), down(solid, rb));
    let ends = |solid: &mut Solid, k: usize| (solid.line(la[k], ra[k]), solid.line(lb[k], rb[k]));
    let (top_a, top_b) = ends(solid, 0);
    let (low_a, low_b) = ends(solid, n - 1);

    let hole = bottom.iter().rev().map(|&e| backward(e)).collect();
    let rim = vec![forward(left[0]), forward(top_b), backward(right[0]), backward(top_a)];
    solid.flat("platform top", vec![rim, hole]);
    for j in 0..n - 1 {
        let name = |side: &str| if j == 0 { format!("platform {side}") } else { format!("root {side} {j}") };
        let faces = [
            ("right", vec![forward(right[j]), forward(drb[j]), backward(right[j + 1]), backward(dra[j])]),
            ("left", vec![backward(left[j]), forward(dla[j]), forward(left[j + 1]), backward(dlb[j])]),
        ];
        for (side, edges) in faces {
            solid.flat(name(side), vec![edges]);
        }
    }
    solid
        .flat("root bottom", vec![vec![forward(right[n - 1]), backward(low_b), backward(left[n - 1]), forward(low_a)]]);
    let mut near: Vec<Coedge> = dlb.iter().map(|&e| forward(e)).collect();
    near.push(forward(low_b));
    near.extend(drb.iter().rev().map(|&e| backward(e)));
    near.push(backward(top_b));
    solid.flat("end +x", vec![near]);
    let mut far: Vec<Coedge> = dra.iter().map(|&e| forward(e)).collect();
    far.push(backward(low_a));
    far.extend(dla.iter().rev().map(|&e| backward(e)));
    far.push(forward(top_a));
    solid.flat("end -x", vec![far]);
}
