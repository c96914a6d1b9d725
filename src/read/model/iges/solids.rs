//! Solids: 186 manifold solid, 514 shells, 510 faces, 508 loops, 504 edges, 502 vertices.

use nalgebra::Matrix4;

use super::build::Build;
use super::curves::curve;
use super::file::Entity;
use super::surfaces::carrier;
use super::trims::boundary;
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::brep::{Coedge, Edge};
use crate::read::model::sew::from_vertex;

/// A curve that passes a vertex within this distance begins there, mm.
const VERTEX_MM: f64 = 1e-4;

/// 186: a shell and the voids in it.
///
/// # Errors
/// Damaged parameters, curves or surfaces.
pub fn add_solid(build: &mut Build, e: &Entity, to: &Matrix4<f64>) -> Result<()> {
    let to = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    let outer = p.target()?;
    let as_it_is = p.int()? != 0;
    add_shell(build, outer, &to, !as_it_is)?;
    for _ in 0..p.count(2)? {
        let void = p.target()?;
        let as_it_is = p.int()? != 0;
        add_shell(build, void, &to, !as_it_is)?;
    }
    Ok(())
}

/// 514: faces, each with or against its surface.
///
/// # Errors
/// Damaged parameters, curves or surfaces.
pub fn add_shell(build: &mut Build, e: &Entity, to: &Matrix4<f64>, reversed: bool) -> Result<()> {
    if e.kind != 514 {
        return Err(build.file.error(e, "stands where a shell (514) belongs"));
    }
    let to = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    for _ in 0..p.count(2)? {
        let face = p.target()?;
        let as_it_is = p.int()? != 0;
        add_face(build, face, &to, reversed == as_it_is)?;
    }
    Ok(())
}

/// 510: a surface and loops.
///
/// # Errors
/// Damaged parameters, curves or surfaces.
pub fn add_face(build: &mut Build, e: &Entity, to: &Matrix4<f64>, reversed: bool) -> Result<()> {
    if e.kind != 510 {
        return Err(build.file.error(e, "stands where a face (510) belongs"));
    }
    let to = to * build.file.transform(e)?;
    let mut p = build.file.params(e)?;
    let c = carrier(build.file, p.target()?, &to)?;
    let n = p.count(1)?;
    let _outer_first = p.int()?;
    let mut loops = Vec::new();
    for _ in 0..n {
        let l = p.target()?;
        let one = add_loop(build, l, &c, &to)?;
        // Loops of vertices alone mark poles, which need no trimming.
        if !one.is_empty() {
            loops.push(one);
        }
    }
    let on = |c: &Coedge| {
        let e = &build.edges()[c.edge];
        (0..=32).map(|k| e.curve.point(e.t[0] + (e.t[1] - e.t[0]) * f64::from(k) / 32.0)).collect::<Vec<Point>>()
    };
    let points: Vec<Point> = loops.iter().flatten().flat_map(on).collect();
    let surface = c.nurbs(&points).ok_or_else(|| build.file.error(e, "has loops that enclose nothing"))?;
    // A mirroring transform turns the surface's normal inside out.
    let mirrored = to.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
    build.push_face(e, &c, surface, loops, reversed != mirrored)
}

/// 508: edges of a list 504 with their senses; vertices stand for poles and are passed over.
fn add_loop(build: &mut Build, e: &Entity, c: &super::surfaces::Carrier, to: &Matrix4<f64>) -> Result<Vec<Coedge>> {
    if e.kind != 508 {
        return Err(build.file.error(e, "stands where a loop (508) belongs"));
    }
    let mut p = build.file.params(e)?;
    let mut out = Vec::new();
    for _ in 0..p.count(5)? {
        let is_vertex = p.int()? == 1;
        let list = p.target()?;
        let index = p.int()?;
        let as_it_is = p.int()? != 0;
        let mut flat = Vec::new();
        for _ in 0..p.count(2)? {
            let _along_parameter = p.int()?;
            flat.extend(p.maybe_target()?);
        }
        if is_vertex {
            continue;
        }
        match edge(build, list, index, to) {
            Ok(edge) => out.push(Coedge { edge, reversed: !as_it_is }),
            Err(error) if flat.is_empty() => return Err(error),
            // A damaged or missing curve in space: what the parameter plane says.
            Err(_) => {
                let walk = boundary(build, e, c, to, None, &flat)?;
                let (edges, senses): (Vec<Edge>, Vec<bool>) = walk.into_iter().unzip();
                let base = build.push_edges(e, edges)?;
                out.extend(senses.into_iter().enumerate().map(|(k, reversed)| Coedge { edge: base + k, reversed }));
            }
        }
    }
    Ok(out)
}

/// Edge of a list 504, once for each body.
fn edge(build: &mut Build, list: &Entity, index: i64, to: &Matrix4<f64>) -> Result<usize> {
    if let Some(known) = build.known_edge(list.line, index) {
        return Ok(known);
    }
    if list.kind != 504 {
        return Err(build.file.error(list, "stands where a list of edges (504) belongs"));
    }
    let mut p = build.file.params(list)?;
    let n = p.count(5)?;
    let k = usize::try_from(index - 1).ok().filter(|k| *k < n);
    let k = k.ok_or_else(|| build.file.error(list, format!("has no edge {index}")))?;
    for _ in 0..5 * k {
        p.optional()?;
    }
    let space = p.target()?;
    let ends = [(p.target()?, p.int()?), (p.target()?, p.int()?)];
    let mut curve = curve(build.file, space, to)?.nurbs;
    if ends[0].0.line == ends[1].0.line && ends[0].1 == ends[1].1 {
        curve = from_vertex(curve, &vertex(build, ends[0].0, ends[0].1, to)?, VERTEX_MM);
    }
    let t = curve.domain();
    let at = build.push_edges(list, vec![Edge { curve, t }])?;
    build.remember_edge(list.line, index, at);
    Ok(at)
}

/// Vertex of a list 502, mm.
fn vertex(build: &Build, list: &Entity, index: i64, to: &Matrix4<f64>) -> Result<Point> {
    let mut p = build.file.params(list)?;
    let n = if list.kind == 502 { p.count(3)? } else { 0 };
    let k = usize::try_from(index - 1).ok().filter(|k| *k < n);
    let k = k.ok_or_else(|| build.file.error(list, format!("has no vertex {index}")))?;
    for _ in 0..3 * k {
        p.optional()?;
    }
    let [x, y, z] = p.triple()?;
    Ok(Point::from((to * nalgebra::Vector4::new(x, y, z, 1.0)).xyz()))
}
