//! Curves of IGES as NURBS: 100 arc, 102 composite, 104 conic, 106 polyline, 110 line, 112
//! polynomial spline, 126 NURBS.

use nalgebra::{Matrix4, Vector4};

use super::file::{Entity, File, Params};
use super::param::ParamMap;
use crate::error::Result;
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::pieces::{joined, part};

/// Degrees above this are taken for damage.
pub const HIGHEST_DEGREE: usize = 32;
/// Composite curves inside one another deeper than this are taken for circular.
const DEEPEST: usize = 16;
/// Ends of an arc nearer than this share of its radius make it a full circle.
const FULL_CIRCLE: f64 = 1e-9;

/// A curve with the map from its parameter in the file.
#[derive(Clone, Debug)]
pub struct MappedCurve {
    /// The curve, in mm (or in parameters, where the identity places it).
    pub nurbs: NurbsCurve,
    /// From the file's parameter to that of `nurbs`.
    pub map: ParamMap,
}

impl MappedCurve {
    fn even(nurbs: NurbsCurve) -> Self {
        let d = nurbs.domain();
        MappedCurve { nurbs, map: ParamMap::even(d, d) }
    }
}

/// The pieces of a curve one after the other, placed by `to` and by the curve's own transform.
///
/// # Errors
/// Damaged parameters; an entity that is no curve or one that cannot be written as NURBS.
pub fn curve_pieces(file: &File, e: &Entity, to: &Matrix4<f64>) -> Result<Vec<MappedCurve>> {
    let mut out = Vec::new();
    let mut room = file.most_poles();
    collect(file, e, to, 0, &mut room, &mut out)?;
    Ok(out)
}

/// The curve as one.
///
/// # Errors
/// See [`curve_pieces`].
pub fn curve(file: &File, e: &Entity, to: &Matrix4<f64>) -> Result<MappedCurve> {
    let mut pieces = curve_pieces(file, e, to)?;
    if pieces.len() == 1
        && let Some(one) = pieces.pop()
    {
        return Ok(one);
    }
    let maps: Vec<ParamMap> = pieces.iter().map(|c| c.map.clone()).collect();
    let curves: Vec<NurbsCurve> = pieces.into_iter().map(|c| c.nurbs).collect();
    let nurbs = joined(&curves).ok_or_else(|| file.error(e, "is a composite of no curves"))?;
    nurbs.validate().map_err(|m| file.error(e, format!("cannot be joined: {}", m.message)))?;
    Ok(MappedCurve { nurbs, map: ParamMap::chain(&maps) })
}

fn collect(
    file: &File,
    e: &Entity,
    to: &Matrix4<f64>,
    depth: usize,
    room: &mut usize,
    out: &mut Vec<MappedCurve>,
) -> Result<()> {
    let to = to * file.transform(e)?;
    let mut p = file.params(e)?;
    if e.kind == 102 {
        if depth >= DEEPEST {
            return Err(p.error(format!("has more than {DEEPEST} composite curves inside one another")));
        }
        for _ in 0..p.count(1)? {
            // Points may stand between the curves of a composite.
            let member = p.target()?;
            if !matches!(member.kind, 116 | 132) {
                collect(file, member, &to, depth + 1, room, out)?;
            }
        }
        return Ok(());
    }
    let mut c = match e.kind {
        100 => arc(&mut p)?,
        104 => MappedCurve::even(conic(&mut p)?),
        106 => MappedCurve::even(polyline(&mut p, e.form)?),
        110 => MappedCurve::even(chain(&[p.triple()?, p.triple()?].map(pole))),
        112 => MappedCurve::even(polynomial(&mut p)?),
        126 => MappedCurve::even(nurbs(&mut p)?),
        _ => return Err(p.error("is no curve that can be read (100, 102, 104, 106, 110, 112 and 126 can)")),
    };
    *room = room
        .checked_sub(c.nurbs.points.len())
        .ok_or_else(|| p.error("repeats its curves more often than a model of this size can need"))?;
    c.nurbs.points.iter_mut().for_each(|q| *q = to * *q);
    c.nurbs.validate().map_err(|m| p.error(format!("is damaged: {}", m.message)))?;
    out.push(c);
    Ok(())
}

fn pole(p: [f64; 3]) -> Vector4<f64> {
    Vector4::new(p[0], p[1], p[2], 1.0)
}

/// A polyline, its parameter from 0 to 1 for each side.
fn chain(points: &[Vector4<f64>]) -> NurbsCurve {
    let last = points.len().saturating_sub(1);
    let mut knots = vec![0.0];
    knots.extend((0..=last).map(|k| k as f64));
    knots.push(last as f64);
    NurbsCurve { degree: 1, knots, points: points.to_vec() }
}

/// An arc of the ellipse `(a cos φ, b sin φ, z)` about a centre from one angle to a greater one, in
/// segments of at most 90°.
fn ellipse(centre: [f64; 2], radii: [f64; 2], z: f64, [from, to]: [f64; 2]) -> (NurbsCurve, usize) {
    let segments = arc_segments(to - from);
    let step = (to - from) / segments as f64;
    let w = (0.5 * step).cos();
    let mut points = Vec::with_capacity(2 * segments + 1);
    let mut knots = vec![from; 3];
    for k in 0..=2 * segments {
        let angle = from + 0.5 * step * k as f64;
        let (w, far) = if k % 2 == 1 { (w, 1.0 / w) } else { (1.0, 1.0) };
        let x = centre[0] + radii[0] * far * angle.cos();
        let y = centre[1] + radii[1] * far * angle.sin();
        points.push(Vector4::new(x * w, y * w, z * w, w));
    }
    for k in 1..segments {
        knots.extend([from + step * k as f64; 2]);
    }
    knots.extend([to; 3]);
    (NurbsCurve { degree: 2, knots, points }, segments)
}

/// Segments of at most a quarter turn.
pub fn arc_segments(angle: f64) -> usize {
    ((angle / std::f64::consts::FRAC_PI_2 - 1e-9).ceil() as usize).clamp(1, 4)
}

/// 100: counter-clockwise from start to end in a plane of constant z; a full circle where both are
/// the same.
fn arc(p: &mut Params) -> Result<MappedCurve> {
    let z = p.real()?;
    let [cx, cy, sx, sy] = [p.real()?, p.real()?, p.real()?, p.real()?];
    let (ex, ey) = (p.real()?, p.real()?);
    let radius = (sx - cx).hypot(sy - cy);
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(p.error(format!("is an arc of radius {radius}")));
    }
    let from = (sy - cy).atan2(sx - cx);
    let mut to = (ey - cy).atan2(ex - cx);
    if to <= from || (ex - sx).hypot(ey - sy) <= FULL_CIRCLE * radius {
        to += std::f64::consts::TAU;
    }
    if to - from > std::f64::consts::TAU * (1.0 + FULL_CIRCLE) {
        to = from + std::f64::consts::TAU;
    }
    let (nurbs, segments) = ellipse([cx, cy], [radius; 2], z, [from, to]);
    Ok(MappedCurve { nurbs, map: ParamMap::arcs(from, to, segments) })
}

/// 104: `A x² + B x y + C y² + D x + E y + F = 0` from start to end.
fn conic(p: &mut Params) -> Result<NurbsCurve> {
    let [a, b, c, d, e, f] = [p.real()?, p.real()?, p.real()?, p.real()?, p.real()?, p.real()?];
    let z = p.real()?;
    let ends = [[p.real()?, p.real()?], [p.real()?, p.real()?]];
    if b == 0.0 && d == 0.0 && e == 0.0 && a * c > 0.0 && a * f < 0.0 {
        let radii = [(-f / a).sqrt(), (-f / c).sqrt()];
        let [from, mut to] = ends.map(|q| (q[1] / radii[1]).atan2(q[0] / radii[0]));
        if to <= from + FULL_CIRCLE {
            to += std::f64::consts::TAU;
        }
        return Ok(ellipse([0.0; 2], radii, z, [from, to]).0);
    }
    // One rational quadratic: the middle pole where the tangents meet, its weight from the form
    // (The NURBS Book, 7.3).
    let form = |p: [f64; 3], q: [f64; 3]| {
        a * p[0] * q[0]
            + 0.5 * b * (p[0] * q[1] + p[1] * q[0])
            + c * p[1] * q[1]
            + 0.5 * d * (p[0] * q[2] + p[2] * q[0])
            + 0.5 * e * (p[1] * q[2] + p[2] * q[1])
            + f * p[2] * q[2]
    };
    let [s, t] = ends.map(|q| [q[0], q[1], 1.0]);
    let tangent = |q: [f64; 3]| {
        [a * q[0] + 0.5 * (b * q[1] + d), 0.5 * b * q[0] + c * q[1] + 0.5 * e, 0.5 * (d * q[0] + e * q[1]) + f]
    };
    let (l, m) = (tangent(s), tangent(t));
    let meet = [l[1] * m[2] - l[2] * m[1], l[2] * m[0] - l[0] * m[2], l[0] * m[1] - l[1] * m[0]];
    let corner = [meet[0] / meet[2], meet[1] / meet[2], 1.0];
    let w = (-form(s, t) / (2.0 * form(corner, corner))).sqrt();
    if !(w.is_finite() && w > 0.0 && corner.iter().all(|x| x.is_finite())) {
        return Err(p.error("is a conic arc that its coefficients do not describe"));
    }
    let points = [(s, 1.0), (corner, w), (t, 1.0)].map(|(q, w)| Vector4::new(q[0] * w, q[1] * w, z * w, w));
    Ok(NurbsCurve { degree: 2, knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points: points.to_vec() })
}

/// 106, forms 11, 12 and 63: points joined by straight lines.
fn polyline(p: &mut Params, form: i64) -> Result<NurbsCurve> {
    let flag = p.int()?;
    let points = match (form, flag) {
        (11 | 63, 1) => {
            let n = p.count(2)?;
            let z = p.real()?;
            (0..n).map(|_| Ok(pole([p.real()?, p.real()?, z]))).collect::<Result<Vec<_>>>()?
        }
        (12, 2) => (0..p.count(3)?).map(|_| Ok(pole(p.triple()?))).collect::<Result<Vec<_>>>()?,
        _ => return Err(p.error(format!("is copious data of form {form}, which is no curve that can be read"))),
    };
    if points.len() < 2 {
        return Err(p.error("is a polyline of fewer than two points"));
    }
    Ok(chain(&points))
}

/// 112: cubic polynomials between break points, to Bézier pieces.
fn polynomial(p: &mut Params) -> Result<NurbsCurve> {
    let (_kind, _continuity, dimensions) = (p.int()?, p.int()?, p.int()?);
    let n = p.count(13)?;
    let at: Vec<f64> = (0..=n).map(|_| p.real()).collect::<Result<_>>()?;
    let mut points: Vec<Vector4<f64>> = Vec::with_capacity(3 * n + 1);
    let mut knots = vec![at[0]; 4];
    for k in 0..n {
        let h = at[k + 1] - at[k];
        let mut piece = [Vector4::new(0.0, 0.0, 0.0, 1.0); 4];
        for axis in 0..3 {
            let bezier = monomial_to_bezier([p.real()?, p.real()?, p.real()?, p.real()?], h);
            for (q, x) in piece.iter_mut().zip(bezier) {
                // A plane spline has its constant z in the first coefficient, and anything in the
                // others.
                q[axis] = if axis == 2 && dimensions == 2 { bezier[0] } else { x };
            }
        }
        points.extend_from_slice(&piece[usize::from(k > 0)..]);
        knots.extend(std::iter::repeat_n(at[k + 1], if k + 1 == n { 4 } else { 3 }));
    }
    Ok(NurbsCurve { degree: 3, knots, points })
}

/// Bézier ordinates over a stretch of length `h` of `a + b s + c s² + d s³`.
pub fn monomial_to_bezier([a, b, c, d]: [f64; 4], h: f64) -> [f64; 4] {
    let (b, c, d) = (b * h, c * h * h, d * h * h * h);
    [a, a + b / 3.0, a + (2.0 * b + c) / 3.0, a + b + c + d]
}

/// 126.
fn nurbs(p: &mut Params) -> Result<NurbsCurve> {
    let n = p.count(4)? + 1;
    let degree = p.count(1)?;
    if degree > HIGHEST_DEGREE {
        return Err(p.error(format!("has degree {degree}, more than {HIGHEST_DEGREE}")));
    }
    for _ in 0..4 {
        p.int()?;
    }
    if p.left() < n + degree + 1 + 4 * n {
        return Err(p.error(format!("has too few parameters for {n} control points of degree {degree}")));
    }
    let knots: Vec<f64> = (0..n + degree + 1).map(|_| p.real()).collect::<Result<_>>()?;
    let weights: Vec<f64> = (0..n).map(|_| p.real()).collect::<Result<_>>()?;
    let points = weights
        .iter()
        .map(|w| p.triple().map(|q| Vector4::new(q[0] * w, q[1] * w, q[2] * w, *w)))
        .collect::<Result<_>>()?;
    let whole = NurbsCurve { degree, knots, points };
    whole.validate().map_err(|m| p.error(format!("is damaged: {}", m.message)))?;
    let [from, to] = whole.domain();
    let (a, b) = (p.optional()?.unwrap_or(from), p.optional()?.unwrap_or(to));
    // Rounding in the file is no reason to cut; ends beyond the domain or the wrong way round are
    // not believed.
    let least = 1e-9 * (to - from);
    let range = [if a > from + least { a } else { from }, if b < to - least { b } else { to }];
    let clamped = whole.knots[0] == from && whole.knots[n + degree] == to;
    Ok(if (range == [from, to] && clamped) || range[0] >= range[1] { whole } else { part(&whole, range) })
}
