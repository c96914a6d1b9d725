//! Trimmed faces: 144 with 142, 143 with 141, bounded planes 108, and bare surfaces.
//!
//! Curves in space are taken where the file has them and they lie on the surface; else curves in
//! the parameter plane are carried through the surface: exactly along its parameter lines, within
//! [`super::fit::FIT_MM`] elsewhere.

use nalgebra::Matrix4;

use super::build::Build;
use super::curves::{MappedCurve, curve_pieces};
use super::file::Entity;
use super::fit::fit;
use super::surfaces::{Carrier, SplinePatch, SurfaceShape, carrier};
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::brep::{Coedge, Edge, Face};
use crate::geometry::nurbs::NurbsCurve;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::geometry::nurbs::pieces::part;
use crate::geometry::tessellate::edges::{add_natural_loops, iso_curve};

/// Curves no longer than this are points, mm.
const POINT_MM: f64 = 1e-7;
/// A curve in space farther from its surface than this gives way to one in the parameter plane, mm.
const OFF_MM: f64 = 0.01;

/// A loop as curves, each with whether it is walked backwards.
pub type Walk = Vec<(Edge, bool)>;

/// A face from any entity that is one.
///
/// # Errors
/// Damaged parameters, curves or surfaces; an entity that is no face.
pub fn add_face(build: &mut Build, e: &Entity, to: &Matrix4<f64>) -> Result<()> {
    match e.kind {
        144 => trimmed(build, e, to),
        143 => bounded(build, e, to),
        108 => bounded_plane(build, e, to),
        _ => {
            let c = carrier(build.file, e, to)?;
            let surface = c.nurbs(&[]).ok_or_else(|| build.file.error(e, "is a surface without end or boundary"))?;
            build.push_face(e, &c, surface, Vec::new(), false)
        }
    }
}

/// 144: a surface, its outer boundary (none: that of the surface), inner boundaries.
fn trimmed(build: &mut Build, e: &Entity, to: &Matrix4<f64>) -> Result<()> {
    let to = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    let surface = p.target()?;
    let own_outer = p.int()? != 0;
    let inner = p.count(1)?;
    let outer = p.maybe_target()?;
    let mut boundaries: Vec<&Entity> = outer.filter(|_| own_outer).into_iter().collect();
    for _ in 0..inner {
        boundaries.push(p.target()?);
    }
    let c = carrier(build.file, surface, &to)?;
    let mut walks = Vec::new();
    for b in boundaries {
        if b.kind != 142 {
            return Err(build.file.error(b, "stands where a curve on a surface (142) belongs"));
        }
        let at = to * build.file.transform(b)?;
        let mut p = build.file.params(b)?;
        let (_how, _surface) = (p.int()?, p.int()?);
        let (flat, space) = (p.maybe_target()?, p.maybe_target()?);
        let walk = boundary(build, b, &c, &at, space.map(|s| (s, false)), flat.as_slice())?;
        walks.push(walk);
    }
    let natural = !(own_outer && outer.is_some());
    finish(build, e, &c, walks, natural)
}

/// 143: a surface and its boundaries 141.
fn bounded(build: &mut Build, e: &Entity, to: &Matrix4<f64>) -> Result<()> {
    let to = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    let _kind = p.int()?;
    let c = carrier(build.file, p.target()?, &to)?;
    let mut walks = Vec::new();
    for _ in 0..p.count(1)? {
        let b = p.target()?;
        if b.kind != 141 {
            return Err(build.file.error(b, "stands where a boundary (141) belongs"));
        }
        let at = to * build.file.transform(b)?;
        let mut p = build.file.params(b)?;
        let (_kind, _preferred, _surface) = (p.int()?, p.int()?, p.int()?);
        let mut walk = Vec::new();
        for _ in 0..p.count(3)? {
            let space = p.target()?;
            let against = p.int()? == 2;
            let flat = (0..p.count(1)?).map(|_| p.target()).collect::<Result<Vec<_>>>()?;
            walk.extend(boundary(build, b, &c, &at, Some((space, against)), &flat)?);
        }
        walks.push(walk);
    }
    let natural = walks.is_empty();
    finish(build, e, &c, walks, natural)
}

/// 108 with a boundary curve.
fn bounded_plane(build: &mut Build, e: &Entity, to: &Matrix4<f64>) -> Result<()> {
    let c = carrier(build.file, e, to)?;
    let at = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    for _ in 0..4 {
        p.real()?;
    }
    let Some(edge) = p.maybe_target()? else {
        return Err(build.file.error(e, "is a plane without boundary"));
    };
    let walk = boundary(build, e, &c, &at, Some((edge, false)), &[])?;
    finish(build, e, &c, vec![walk], false)
}

/// One boundary: the curve in space (with whether it is walked backwards) if it lies on the
/// surface, else those in the parameter plane.
pub fn boundary(
    build: &mut Build,
    owner: &Entity,
    c: &Carrier,
    to: &Matrix4<f64>,
    space: Option<(&Entity, bool)>,
    flat: &[&Entity],
) -> Result<Walk> {
    let given =
        space.map(|(s, against)| curve_pieces(build.file, s, to).map(|pieces| (pieces, against))).transpose()?;
    if let Some((mut pieces, against)) = given
        && (flat.is_empty() || lies_on(&pieces, c))
    {
        if against {
            pieces.reverse();
        }
        let long = |c: &MappedCurve| length(&|t| c.nurbs.point(t), c.nurbs.domain()) > POINT_MM;
        let edge = |c: MappedCurve| (Edge { t: c.nurbs.domain(), curve: c.nurbs }, against);
        return Ok(pieces.into_iter().filter(long).map(edge).collect());
    }
    let mut walk = Vec::new();
    for f in flat {
        for piece in curve_pieces(build.file, f, &Matrix4::identity())? {
            walk.extend(carried(c, &piece.nurbs).ok_or_else(|| {
                build
                    .file
                    .error(owner, format!("has a parameter curve (D{}) that cannot be carried into space", f.line))
            })?);
        }
    }
    if walk.is_empty() {
        return Err(build.file.error(owner, "has no boundary curve of any length"));
    }
    Ok(walk)
}

/// Whether curves lie on a surface, by samples; unbounded ones are taken at their word.
fn lies_on(pieces: &[MappedCurve], c: &Carrier) -> bool {
    let SurfaceShape::Patch(p) = &c.shape else { return true };
    let seeds = crate::geometry::tessellate::loops::Seeds::new(&p.surface);
    pieces.iter().all(|piece| {
        let [a, b] = piece.nurbs.domain();
        [0.1, 0.5, 0.8].iter().all(|s| {
            let q = piece.nurbs.point(a + s * (b - a));
            seeds.foot(&p.surface, &q, &p.space).is_some_and(|f| f.distance_mm <= OFF_MM)
        })
    })
}

/// Length of a curve by chords, mm.
fn length(at: &dyn Fn(f64) -> Point, [a, b]: [f64; 2]) -> f64 {
    let points: Vec<Point> = (0..=32).map(|k| at(a + (b - a) * f64::from(k) / 32.0)).collect();
    points.windows(2).map(|w| (w[1] - w[0]).norm()).sum()
}

/// A curve of the parameter plane carried through the surface; nothing where it ends up as a point
/// (a pole).
fn carried(c: &Carrier, flat: &NurbsCurve) -> Option<Walk> {
    let mut walk = Vec::new();
    for range in smooth_ranges(flat) {
        let at = |t: f64| {
            let q = flat.point(t);
            c.at([q.x, q.y])
        };
        let size = length(&at, range);
        if !size.is_finite() {
            return None;
        }
        if size <= POINT_MM {
            continue;
        }
        if let SurfaceShape::Patch(p) = &c.shape
            && let Some(edge) = along_parameter(p, flat, range)
        {
            walk.push(edge);
            continue;
        }
        let edges = fit(&at, range)?.into_iter().map(|curve| (Edge { t: curve.domain(), curve }, false));
        walk.extend(edges);
    }
    Some(walk)
}

/// Stretches of a curve between its corners: knots as many as its degree.
fn smooth_ranges(c: &NurbsCurve) -> Vec<[f64; 2]> {
    let [from, to] = c.domain();
    let folded = |k: f64| c.knots.iter().filter(|x| **x == k).count() >= c.degree;
    let mut at = vec![from];
    let mut inner: Vec<f64> = c.knots.iter().copied().filter(|k| *k > from && *k < to && folded(*k)).collect();
    inner.dedup();
    at.extend(inner);
    at.push(to);
    at.windows(2).map(|w| [w[0], w[1]]).collect()
}

/// The exact parameter line of a surface, where a stretch of a curve in the parameter plane is a
/// piece of one.
fn along_parameter(p: &SplinePatch, flat: &NurbsCurve, range: [f64; 2]) -> Option<(Edge, bool)> {
    let poles: Vec<[f64; 2]> = part(flat, range).points.iter().map(|q| p.ours([q.x / q.w, q.y / q.w])).collect();
    let domain = p.space.domain;
    let close = |along: usize| 1e-9 * p.space.period(along);
    let fixed = (0..2).find(|&a| poles.iter().all(|q| (q[a] - poles[0][a]).abs() <= close(a)))?;
    let along = 1 - fixed;
    // Monotone and inside: the curve covers the stretch between its ends once.
    let rising = poles.windows(2).all(|w| w[1][along] >= w[0][along]);
    let falling = poles.windows(2).all(|w| w[1][along] <= w[0][along]);
    let ends = [poles[0][along], poles[poles.len() - 1][along]];
    let inside = |x: f64, a: usize| x >= domain[a][0] - close(a) && x <= domain[a][1] + close(a);
    if !(rising || falling) || !ends.iter().all(|x| inside(*x, along)) || !inside(poles[0][fixed], fixed) {
        return None;
    }
    let clamp = |x: f64, a: usize| x.clamp(domain[a][0], domain[a][1]);
    let curve = iso_curve(&p.surface, along, clamp(poles[0][fixed], fixed));
    let t = [ends[0].min(ends[1]), ends[0].max(ends[1])].map(|x| clamp(x, along));
    (t[0] < t[1]).then_some((Edge { curve, t }, falling))
}

/// Adds the face with its loops; `natural`: the surface's own boundary is the outer one.
fn finish(build: &mut Build, e: &Entity, c: &Carrier, walks: Vec<Walk>, natural: bool) -> Result<()> {
    let on = |edge: &Edge| {
        (0..=32)
            .map(|k| edge.curve.point(edge.t[0] + (edge.t[1] - edge.t[0]) * f64::from(k) / 32.0))
            .collect::<Vec<_>>()
    };
    let points: Vec<Point> = walks.iter().flatten().flat_map(|(edge, _)| on(edge)).collect();
    let surface = c.nurbs(&points).ok_or_else(|| build.file.error(e, "has boundaries that enclose nothing"))?;
    let mut loops: Vec<Vec<Coedge>> = Vec::new();
    if natural && !walks.is_empty() {
        // With holes, the outline has to be written out.
        let face = Face { name: "".into(), kind: c.kind, surface: surface.clone(), reversed: false, loops: Vec::new() };
        let mut alone = crate::geometry::brep::Brep { faces: vec![face], edges: Vec::new() };
        let space = ParameterSpace::of(&surface, super::surfaces::CLOSED_MM);
        add_natural_loops(&mut alone, &[space]);
        let base = build.push_edges(e, alone.edges)?;
        let shifted = |c: &Coedge| Coedge { edge: c.edge + base, ..*c };
        loops.extend(alone.faces[0].loops.iter().map(|l| l.iter().map(shifted).collect()));
    }
    for walk in walks {
        let (edges, senses): (Vec<Edge>, Vec<bool>) = walk.into_iter().unzip();
        let base = build.push_edges(e, edges)?;
        let one: Vec<Coedge> =
            senses.into_iter().enumerate().map(|(k, reversed)| Coedge { edge: base + k, reversed }).collect();
        if !one.is_empty() {
            loops.push(one);
        }
    }
    build.push_face(e, c, surface, loops, false)
}
