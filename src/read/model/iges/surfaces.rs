//! Surfaces of IGES: 108 and 190 planes, 114 polynomial, 118 ruled, 120 of revolution, 122
//! tabulated cylinder, 128 NURBS, 192 cylinder, 194 cone, 196 sphere, 198 torus.
//!
//! Surfaces without end (planes, cylinders, cones) become NURBS as large as the loops on them need.
//! All but ruled surfaces by arc length (118, form 0, of curves whose parameter is not their
//! length) are exact.

use nalgebra::{Matrix4, Vector4};

use super::curves::{HIGHEST_DEGREE, MappedCurve, arc_segments, curve, monomial_to_bezier};
use super::file::{Entity, File, Params};
use super::fit::{by_length, by_parameter};
use super::param::ParamMap;
use crate::error::Result;
use crate::geometry::brep::SurfaceKind;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::geometry::nurbs::pieces::{alike, over, surface_part};
use crate::geometry::nurbs::{NurbsCurve, NurbsSurface};
use crate::geometry::{Point, Vector};

/// Sides of a surface that are nearer than this make it closed, mm.
pub const CLOSED_MM: f64 = 1e-3;
/// Unbounded surfaces reach beyond their loops by this share of the loops' size.
const BEYOND: f64 = 0.05;

/// A surface with the way from the file's parameters to points.
pub struct Carrier {
    /// What it is in the file.
    pub kind: SurfaceKind,
    /// Its shape.
    pub shape: SurfaceShape,
}

/// Shape of a surface.
pub enum SurfaceShape {
    /// As it is.
    Patch(Box<SplinePatch>),
    /// In a frame of its own, without end or with ends of its own.
    Elementary(Elementary),
}

/// A surface that is NURBS from the start.
pub struct SplinePatch {
    /// The surface, mm.
    pub surface: NurbsSurface,
    /// From the file's u and v to the surface's.
    pub maps: [ParamMap; 2],
    /// Closed directions.
    pub space: ParameterSpace,
}

/// A surface of elementary geometry in a frame: z its axis, x where angles begin; lengths in file
/// units.
pub struct Elementary {
    form: Form,
    /// Frame to model, mm.
    to: Matrix4<f64>,
}

#[derive(Clone, Copy)]
enum Form {
    Plane,
    Cylinder { radius: f64 },
    Cone { radius: f64, half_angle: f64 },
    Sphere { radius: f64 },
    Torus { major: f64, minor: f64 },
}

impl SplinePatch {
    fn new(surface: NurbsSurface, maps: [ParamMap; 2]) -> Self {
        let space = ParameterSpace::of(&surface, CLOSED_MM);
        SplinePatch { surface, maps, space }
    }

    /// Our parameters of the file's.
    pub fn ours(&self, uv: [f64; 2]) -> [f64; 2] {
        [self.maps[0].ours(uv[0]), self.maps[1].ours(uv[1])]
    }
}

impl Carrier {
    /// The point at the file's parameters, mm.
    pub fn at(&self, uv: [f64; 2]) -> Point {
        match &self.shape {
            SurfaceShape::Patch(p) => {
                let n = p.space.normal_form(p.ours(uv));
                p.surface.point(n[0], n[1])
            }
            SurfaceShape::Elementary(e) => e.at(uv),
        }
    }

    /// The surface as NURBS, large enough for these points where it has no end of its own; `None`
    /// where there are too few of them to tell.
    pub fn nurbs(&self, points: &[Point]) -> Option<NurbsSurface> {
        match &self.shape {
            SurfaceShape::Patch(p) => Some(p.surface.clone()),
            SurfaceShape::Elementary(e) => e.nurbs(points),
        }
    }
}

/// The surface of an entity, placed by `to` and by its own transform.
///
/// # Errors
/// Damaged parameters; an entity that is no surface or one that cannot be written as NURBS.
pub fn carrier(file: &File, e: &Entity, to: &Matrix4<f64>) -> Result<Carrier> {
    let to = to * file.transform(e)?;
    let mut p = file.params(e)?;
    let (kind, patch) = match e.kind {
        108 => return plane(&mut p, &to),
        190 | 192 | 194 | 196 | 198 => return elementary(file, e, &mut p, &to),
        114 => (SurfaceKind::BSpline, polynomial(&mut p)?),
        118 => (SurfaceKind::Other, ruled(file, e.form, &mut p, &to)?),
        120 => (SurfaceKind::Revolution, revolution(file, &mut p)?),
        122 => (SurfaceKind::Extrusion, tabulated(file, &mut p)?),
        128 => (SurfaceKind::BSpline, nurbs(&mut p)?),
        _ => return Err(p.error("is no surface that can be read (108, 114, 118, 120, 122, 128 and 190 to 198 can)")),
    };
    let (mut surface, maps) = patch;
    if e.kind != 118 {
        surface.points.iter_mut().for_each(|q| *q = to * *q);
    }
    surface.validate().map_err(|m| p.error(format!("is damaged: {}", m.message)))?;
    Ok(Carrier { kind, shape: SurfaceShape::Patch(Box::new(SplinePatch::new(surface, maps))) })
}

type Mapped = (NurbsSurface, [ParamMap; 2]);

fn own_parameters(surface: NurbsSurface) -> Mapped {
    let [u, v] = surface.domain();
    (surface, [ParamMap::even(u, u), ParamMap::even(v, v)])
}

/// 128.
fn nurbs(p: &mut Params) -> Result<Mapped> {
    let (n_u, n_v) = (p.count(1)? + 1, p.count(1)? + 1);
    let (degree_u, degree_v) = (p.count(1)?, p.count(1)?);
    if degree_u.max(degree_v) > HIGHEST_DEGREE {
        return Err(p.error(format!("has degrees {degree_u} and {degree_v}, more than {HIGHEST_DEGREE}")));
    }
    for _ in 0..5 {
        p.int()?;
    }
    let need = n_u.checked_mul(n_v).and_then(|n| n.checked_mul(4)).map(|n| n + n_u + degree_u + n_v + degree_v + 2);
    if need.is_none_or(|n| n > p.left()) {
        return Err(p.error(format!("has too few parameters for {n_u} × {n_v} control points")));
    }
    let knots_u: Vec<f64> = (0..n_u + degree_u + 1).map(|_| p.real()).collect::<Result<_>>()?;
    let knots_v: Vec<f64> = (0..n_v + degree_v + 1).map(|_| p.real()).collect::<Result<_>>()?;
    let weights: Vec<f64> = (0..n_u * n_v).map(|_| p.real()).collect::<Result<_>>()?;
    let mut points = vec![Vector4::zeros(); n_u * n_v];
    // The file runs along u first.
    for (k, w) in weights.iter().enumerate() {
        let q = p.triple()?;
        points[(k % n_u) * n_v + k / n_u] = Vector4::new(q[0] * w, q[1] * w, q[2] * w, *w);
    }
    let whole = NurbsSurface { degree_u, degree_v, knots_u, knots_v, n_u, n_v, points };
    whole.validate().map_err(|m| p.error(format!("is damaged: {}", m.message)))?;
    let domain = whole.domain();
    let mut range = domain;
    for side in &mut range {
        let least = 1e-9 * (side[1] - side[0]);
        let (a, b) = (p.optional()?.unwrap_or(side[0]), p.optional()?.unwrap_or(side[1]));
        let inner = [if a > side[0] + least { a } else { side[0] }, if b < side[1] - least { b } else { side[1] }];
        if inner[0] < inner[1] {
            *side = inner;
        }
    }
    let clamped = |knots: &[f64], d: [f64; 2]| knots.first() == Some(&d[0]) && knots.last() == Some(&d[1]);
    let as_it_is = range == domain && clamped(&whole.knots_u, domain[0]) && clamped(&whole.knots_v, domain[1]);
    Ok(own_parameters(if as_it_is { whole } else { surface_part(&whole, range) }))
}

/// 114: bicubic polynomials between break points, to Bézier pieces.
fn polynomial(p: &mut Params) -> Result<Mapped> {
    let (_kind, _product) = (p.int()?, p.int()?);
    let (m, n) = (p.count(1)?, p.count(1)?);
    let room = p.left();
    if m == 0 || n == 0 || m.checked_mul(n).and_then(|k| k.checked_mul(48)).is_none_or(|k| k > room) {
        return Err(p.error(format!("has too few parameters for {m} × {n} patches")));
    }
    let at_u: Vec<f64> = (0..=m).map(|_| p.real()).collect::<Result<_>>()?;
    let at_v: Vec<f64> = (0..=n).map(|_| p.real()).collect::<Result<_>>()?;
    let (n_u, n_v) = (3 * m + 1, 3 * n + 1);
    let mut points = vec![Vector4::new(0.0, 0.0, 0.0, 1.0); n_u * n_v];
    for i in 0..m {
        for j in 0..n {
            for axis in 0..3 {
                // Rows by powers of t, each with the powers of s.
                let mut rows = [[0.0; 4]; 4];
                for row in &mut rows {
                    *row = monomial_to_bezier([p.real()?, p.real()?, p.real()?, p.real()?], at_u[i + 1] - at_u[i]);
                }
                for a in 0..4 {
                    let column = monomial_to_bezier(rows.map(|r| r[a]), at_v[j + 1] - at_v[j]);
                    for (b, x) in column.into_iter().enumerate() {
                        points[(3 * i + a) * n_v + 3 * j + b][axis] = x;
                    }
                }
            }
        }
        // Every row ends with a patch that means nothing.
        for _ in 0..48.min(p.left()) {
            p.optional()?;
        }
    }
    let knots = |at: &[f64]| -> Vec<f64> {
        let last = at.len() - 1;
        at.iter().enumerate().flat_map(|(k, t)| [*t; 4].into_iter().skip(usize::from(k > 0 && k < last))).collect()
    };
    let (knots_u, knots_v) = (knots(&at_u), knots(&at_v));
    Ok(own_parameters(NurbsSurface { degree_u: 3, degree_v: 3, knots_u, knots_v, n_u, n_v, points }))
}

/// 118: straight lines between two curves, of equal parameter (form 1) or equal length from the
/// start (form 0).
fn ruled(file: &File, form: i64, p: &mut Params, to: &Matrix4<f64>) -> Result<Mapped> {
    let (first, second) = (p.target()?, p.target()?);
    let (against, _developable) = (p.int()?, p.optional()?);
    let unit = |c: MappedCurve| (over(c.nurbs, [0.0, 1.0]), c.map.over(Some([0.0, 1.0]), Some([0.0, 1.0])));
    let (a, map) = unit(curve(file, first, to)?);
    let (b, other) = unit(curve(file, second, to)?);
    let b = if against == 1 { super::super::sew::backwards(&b) } else { b };
    // Lines and single arcs run evenly with their length: with like spans they need no other
    // parameter.
    let even = |e: &Entity| matches!(e.kind, 100 | 110);
    let unfit = || p.error("has a rail that cannot be fitted");
    let (a, b, map) = if map == other && (form != 0 || (even(first) && even(second))) {
        (a, b, map)
    } else {
        let again = |c: &NurbsCurve, m: &ParamMap| if form == 0 { by_length(c) } else { by_parameter(c, m) };
        let none = ParamMap::even([0.0, 1.0], [0.0, 1.0]);
        (again(&a, &map).ok_or_else(unfit)?, again(&b, &other).ok_or_else(unfit)?, none)
    };
    let [a, b] = alike(&a, &b);
    let n_u = a.points.len();
    let points = a.points.iter().zip(&b.points).flat_map(|(a, b)| [*a, *b]).collect();
    let knots_v = vec![0.0, 0.0, 1.0, 1.0];
    let surface = NurbsSurface { degree_u: a.degree, degree_v: 1, knots_u: a.knots, knots_v, n_u, n_v: 2, points };
    Ok((surface, [map, ParamMap::even([0.0, 1.0], [0.0, 1.0])]))
}

/// 120: a generatrix (u) turned about a line by angles v.
fn revolution(file: &File, p: &mut Params) -> Result<Mapped> {
    let (axis, generatrix) = (p.target()?, p.target()?);
    let (from, to) = (p.real()?, p.real()?);
    let identity = Matrix4::identity();
    let line = curve(file, axis, &identity)?.nurbs;
    let [a, b] = line.domain().map(|t| line.point(t));
    let turn = to - from;
    let full = std::f64::consts::TAU;
    let z = (b - a).try_normalize(0.0).filter(|z| z.norm() > 0.5);
    let Some(z) = z.filter(|_| turn > 0.0 && turn <= full * (1.0 + 1e-6)) else {
        return Err(p.error(format!("turns by {turn} rad about its axis, or has no axis")));
    };
    let g = curve(file, generatrix, &identity)?;
    Ok(revolved(&g.nurbs, g.map, &a, &z, [from, to]))
}

/// The curve (u) turned about an axis through `o` along `z` (v, in rad).
fn revolved(g: &NurbsCurve, map: ParamMap, o: &Point, z: &Vector, [from, to]: [f64; 2]) -> Mapped {
    let segments = arc_segments(to - from);
    let step = (to - from) / segments as f64;
    let half = (0.5 * step).cos();
    let turned = |p: &Vector4<f64>, k: usize| {
        let (w, far) = if k % 2 == 1 { (half, 1.0 / half) } else { (1.0, 1.0) };
        let angle = from + 0.5 * step * k as f64;
        let q = Point::from(p.xyz() / p.w) - o;
        let along = z * q.dot(z);
        let r = q - along;
        let at = o.coords + along + (r * angle.cos() + z.cross(&r) * angle.sin()) * far;
        let w = p.w * w;
        Vector4::new(at.x * w, at.y * w, at.z * w, w)
    };
    let n_v = 2 * segments + 1;
    let points = g.points.iter().flat_map(|p| (0..n_v).map(move |k| (p, k))).map(|(p, k)| turned(p, k)).collect();
    let mut knots_v = vec![from; 3];
    for k in 1..segments {
        knots_v.extend([from + step * k as f64; 2]);
    }
    knots_v.extend([to; 3]);
    let surface = NurbsSurface {
        degree_u: g.degree,
        degree_v: 2,
        knots_u: g.knots.clone(),
        knots_v,
        n_u: g.points.len(),
        n_v,
        points,
    };
    (surface, [map, ParamMap::arcs(from, to, segments)])
}

/// 122: a directrix (u) moved along a straight line (v).
fn tabulated(file: &File, p: &mut Params) -> Result<Mapped> {
    let directrix = p.target()?;
    let end = Point::from(p.triple()?);
    let c = curve(file, directrix, &Matrix4::identity())?;
    let (g, map) = (over(c.nurbs, [0.0, 1.0]), c.map.over(Some([0.0, 1.0]), Some([0.0, 1.0])));
    let move_by = end - g.point(0.0);
    if !(move_by.norm() > 0.0) {
        return Err(p.error("is a tabulated cylinder without height"));
    }
    let moved = |q: &Vector4<f64>| *q + move_by.push(0.0) * q.w;
    let points = g.points.iter().flat_map(|q| [*q, moved(q)]).collect();
    let n_u = g.points.len();
    let knots_v = vec![0.0, 0.0, 1.0, 1.0];
    let surface = NurbsSurface { degree_u: g.degree, degree_v: 1, knots_u: g.knots, knots_v, n_u, n_v: 2, points };
    Ok((surface, [map, ParamMap::even([0.0, 1.0], [0.0, 1.0])]))
}

/// 108: `A x + B y + C z = D`.
fn plane(p: &mut Params, to: &Matrix4<f64>) -> Result<Carrier> {
    let n = Vector::from(p.triple()?);
    let d = p.real()?;
    let size = n.norm();
    if !(size > 0.0 && size.is_finite()) {
        return Err(p.error("is a plane without normal"));
    }
    let origin = Point::from(n * (d / (size * size)));
    let shape = SurfaceShape::Elementary(Elementary { form: Form::Plane, to: to * frame(&origin, &n, None) });
    Ok(Carrier { kind: SurfaceKind::Plane, shape })
}

/// Frame with its z along `z` and its x as near to `x` as can be.
fn frame(origin: &Point, z: &Vector, x: Option<Vector>) -> Matrix4<f64> {
    let z = z.normalize();
    let other = if z.x.abs() < 0.8 { Vector::x() } else { Vector::y() };
    let across = |x: Vector| (x - z * x.dot(&z)).try_normalize(1e-9);
    let x = x.and_then(across).or_else(|| across(other)).unwrap_or_else(Vector::x);
    let y = z.cross(&x);
    Matrix4::from_columns(&[x.push(0.0), y.push(0.0), z.push(0.0), origin.coords.push(1.0)])
}

/// 190 to 198: a point, an axis, lengths, and for the forms with parameters of their own a
/// direction where angles begin.
fn elementary(file: &File, e: &Entity, p: &mut Params, to: &Matrix4<f64>) -> Result<Carrier> {
    let triple = |of: &Entity, kind: u32| -> Result<[f64; 3]> {
        if of.kind != kind {
            return Err(file.error(of, format!("stands where an entity {kind} belongs")));
        }
        file.params(of)?.triple()
    };
    let at = p.target()?;
    let origin = Point::from(triple(at, 116)?);
    let early_axis = if e.kind == 196 { None } else { Some(p.target()?) };
    let (kind, form) = match e.kind {
        190 => (SurfaceKind::Plane, Form::Plane),
        192 => (SurfaceKind::Cylinder, Form::Cylinder { radius: p.real()? }),
        194 => (SurfaceKind::Cone, Form::Cone { radius: p.real()?, half_angle: p.real()?.to_radians() }),
        196 => (SurfaceKind::Sphere, Form::Sphere { radius: p.real()? }),
        _ => (SurfaceKind::Torus, Form::Torus { major: p.real()?, minor: p.real()? }),
    };
    let sound = match form {
        Form::Plane => true,
        Form::Cylinder { radius } | Form::Sphere { radius } => radius > 0.0,
        Form::Cone { radius, half_angle } => radius >= 0.0 && half_angle > 0.0 && half_angle < 1.56,
        Form::Torus { major, minor } => minor > 0.0 && major > minor,
    };
    if !sound {
        return Err(p.error("has radii or an angle that describe no surface"));
    }
    let axis = match early_axis {
        Some(a) => Some(a),
        None => p.maybe_target()?,
    };
    let z = axis.map(|a| triple(a, 123)).transpose()?.map_or_else(Vector::z, Vector::from);
    let x = p.maybe_target()?.map(|a| triple(a, 123)).transpose()?.map(Vector::from);
    if !(z.norm() > 0.0) {
        return Err(p.error("has an axis without direction"));
    }
    Ok(Carrier { kind, shape: SurfaceShape::Elementary(Elementary { form, to: to * frame(&origin, &z, x) }) })
}

impl Elementary {
    /// The point at the file's parameters: lengths, and angles in degrees.
    fn at(&self, [u, v]: [f64; 2]) -> Point {
        let (a, b) = (u.to_radians(), v.to_radians());
        let local = match self.form {
            Form::Plane => [u, v, 0.0],
            Form::Cylinder { radius } => [radius * a.cos(), radius * a.sin(), v],
            Form::Cone { radius, half_angle } => {
                let r = radius + v * half_angle.tan();
                [r * a.cos(), r * a.sin(), v]
            }
            Form::Sphere { radius } => [radius * b.cos() * a.cos(), radius * b.cos() * a.sin(), radius * b.sin()],
            Form::Torus { major, minor } => {
                let r = major + minor * b.cos();
                [r * a.cos(), r * a.sin(), minor * b.sin()]
            }
        };
        Point::from((self.to * Vector4::new(local[0], local[1], local[2], 1.0)).xyz())
    }

    fn nurbs(&self, points: &[Point]) -> Option<NurbsSurface> {
        let back = self.to.try_inverse()?;
        let local: Vec<Point> = points.iter().map(|p| Point::from((back * p.coords.push(1.0)).xyz())).collect();
        let range = |axis: usize| {
            let (lo, hi) = local.iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p[axis]), b.max(p[axis])));
            let more = BEYOND * (hi - lo) + 1e-6 * lo.abs().max(hi.abs());
            (lo < hi + 1e-300 && more > 0.0).then_some([lo - more, hi + more])
        };
        let round = |profile: &[(f64, f64, f64)], knots: Vec<f64>, degree: usize| {
            let points = profile.iter().map(|(r, z, w)| Vector4::new(r * w, 0.0, z * w, *w)).collect();
            let g = NurbsCurve { degree, knots, points };
            let none = ParamMap::even([0.0, 1.0], [0.0, 1.0]);
            let (s, _) = revolved(&g, none, &Point::origin(), &Vector::z(), [0.0, std::f64::consts::TAU]);
            crate::geometry::nurbs::pieces::transposed(&s)
        };
        let line = |[a, b]: [f64; 2]| vec![a, a, b, b];
        let w = std::f64::consts::FRAC_1_SQRT_2;
        let mut s = match self.form {
            Form::Plane => {
                let (x, y) = (range(0)?, range(1)?);
                let corner = |x: f64, y: f64| Vector4::new(x, y, 0.0, 1.0);
                NurbsSurface {
                    degree_u: 1,
                    degree_v: 1,
                    knots_u: line(x),
                    knots_v: line(y),
                    n_u: 2,
                    n_v: 2,
                    points: vec![corner(x[0], y[0]), corner(x[0], y[1]), corner(x[1], y[0]), corner(x[1], y[1])],
                }
            }
            Form::Cylinder { radius } => {
                let [a, b] = range(2)?;
                round(&[(radius, a, 1.0), (radius, b, 1.0)], line([a, b]), 1)
            }
            Form::Cone { radius, half_angle } => {
                let [a, b] = range(2)?;
                // Not beyond the apex, where the cone would turn inside out.
                let a = a.max(-radius / half_angle.tan());
                let r = |z: f64| (radius + z * half_angle.tan()).max(0.0);
                (a < b).then(|| round(&[(r(a), a, 1.0), (r(b), b, 1.0)], line([a, b]), 1))?
            }
            Form::Sphere { radius: r } => {
                let profile = [(0.0, -r, 1.0), (r, -r, w), (r, 0.0, 1.0), (r, r, w), (0.0, r, 1.0)];
                round(&profile, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0], 2)
            }
            Form::Torus { major, minor } => {
                let c =
                    [(1., 0.), (1., 1.), (0., 1.), (-1., 1.), (-1., 0.), (-1., -1.), (0., -1.), (1., -1.), (1., 0.)];
                let profile: Vec<(f64, f64, f64)> = c
                    .iter()
                    .enumerate()
                    .map(|(k, (x, y))| (major + minor * x, minor * y, if k % 2 == 1 { w } else { 1.0 }))
                    .collect();
                round(&profile, vec![0., 0., 0., 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1., 1., 1.], 2)
            }
        };
        s.points.iter_mut().for_each(|q| *q = self.to * *q);
        s.validate().is_ok().then_some(s)
    }
}
