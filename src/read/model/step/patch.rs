//! Patches of unbounded surfaces, large enough for their faces.
//!
//! `step-io` cuts planes, cylinders, cones and extrusions where the curves of the face's edges end
//! that it can write itself. Edges that it cannot ([`super::edges`]) may reach farther: the patch
//! is drawn out along its straight lines, which leaves the surface as it is.

use nalgebra::{Matrix4, Vector4};
use step_io::StepModel;
use step_io::model as m;

use super::pole;
use crate::geometry::brep::SurfaceKind;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::{Point, Vector};

/// Drawn out beyond the points by this share of their reach, so that none lies on the border; cones
/// are not, for their apex.
const MARGIN: f64 = 1e-3;
/// Lines of the surface that are looked at for its middle.
const QUARTERS: usize = 4;

/// A patch of a plane around points, mm; `None` where they lie on a line or the plane's frame is
/// damaged.
pub(super) fn of_plane(
    model: &StepModel,
    plane: &m::Plane,
    points: &[Point],
    mm: f64,
    to: &Matrix4<f64>,
) -> Option<NurbsSurface> {
    let m::Axis2Placement3dRef::Axis2Placement3d(id) = &plane.position;
    let frame = model.get(*id)?;
    let m::CartesianPointRef::CartesianPoint(origin) = &frame.location else { return None };
    let origin = <[f64; 3]>::try_from(&model.get(*origin)?.coordinates[..]).ok()?;
    let direction = |r: &Option<m::DirectionRef>, default: Vector| match r {
        None => Some(default),
        Some(m::DirectionRef::Direction(id)) => {
            let d = <[f64; 3]>::try_from(&model.get(*id)?.direction_ratios[..]).ok()?;
            Vector::from(d).try_normalize(1e-12)
        }
        Some(_) => None,
    };
    let z = direction(&frame.axis, Vector::z())?;
    let x = direction(&frame.ref_direction, Vector::x())?;
    let x = (x - z * x.dot(&z)).try_normalize(1e-9)?;
    let turned = |v: Vector| to.transform_vector(&v).try_normalize(1e-12);
    let o = Point::from(pole(&origin, 1.0, mm, to).xyz());
    let (x, y) = (turned(x)?, turned(z.cross(&x))?);
    let range = |d: &Vector| {
        let along = points.iter().map(|p| (p - o).dot(d));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)))
    };
    let ((u0, u1), (v0, v1)) = (range(&x), range(&y));
    let corner = |u: f64, v: f64| {
        let p = o + x * u + y * v;
        Vector4::new(p.x, p.y, p.z, 1.0)
    };
    (u1 > u0 && v1 > v0)
        .then(|| NurbsSurface::bilinear([corner(u0, v0), corner(u0, v1), corner(u1, v0), corner(u1, v1)]))
}

/// The same surface, drawn out so far along its straight lines that it covers the points.
pub(super) fn covering(mut surface: NurbsSurface, kind: SurfaceKind, points: &[Point]) -> NurbsSurface {
    use SurfaceKind::{Cone, Cylinder, Extrusion, Plane};
    if points.is_empty() || !matches!(kind, Plane | Cylinder | Cone | Extrusion) {
        return surface;
    }
    let margin = if kind == Cone { 0.0 } else { MARGIN };
    if surface.degree_v == 1 && surface.n_v == 2 {
        draw_out(&mut surface, 1, points, margin);
    }
    if kind == Plane && surface.degree_u == 1 && surface.n_u == 2 {
        draw_out(&mut surface, 0, points, margin);
    }
    surface
}

/// Draws the lines out along one parameter (0 for u, 1 for v), of degree 1 and one span.
fn draw_out(s: &mut NurbsSurface, along: usize, points: &[Point], margin: f64) {
    let domain = s.domain();
    let other = domain[1 - along];
    let middle = |end: f64| {
        let at = |k: usize| {
            let t = other[0] + (other[1] - other[0]) * (k as f64 / QUARTERS as f64);
            if along == 0 { s.point(end, t) } else { s.point(t, end) }
        };
        (0..QUARTERS).map(|k| at(k).coords).sum::<Vector>() / QUARTERS as f64
    };
    let [from, to] = domain[along].map(middle);
    let (axis, length2) = (to - from, (to - from).norm_squared());
    if !(length2 > 0.0) {
        return;
    }
    let across = if along == 0 { s.n_v } else { s.n_u };
    let index = |k: usize, end: usize| if along == 0 { end * s.n_v + k } else { k * s.n_v + end };
    let height = |p: &Vector| p.dot(&axis) / length2;
    let range = |heights: &mut dyn Iterator<Item = f64>| {
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)))
    };
    let base = |k: usize| {
        let p = s.points[index(k, 0)];
        height(&(p.xyz() / p.w))
    };
    let (low, high) = range(&mut (0..across).map(base));
    let (first, last) = range(&mut points.iter().map(|p| height(&p.coords)));
    let reach = [first - high, last - low];
    let [a, b] = [reach[0].min(0.0), reach[1].max(1.0)];
    if a == 0.0 && b == 1.0 || !(a.is_finite() && b.is_finite()) {
        return;
    }
    let by = margin * (b - a);
    let [a, b] = [if a < 0.0 { a - by } else { a }, if b > 1.0 { b + by } else { b }];
    for k in 0..across {
        let (i, j) = (index(k, 0), index(k, 1));
        let (p, q) = (s.points[i], s.points[j]);
        (s.points[i], s.points[j]) = (p + (q - p) * a, p + (q - p) * b);
    }
}
