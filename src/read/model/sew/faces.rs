//! Faces and edges that sewing has to bring into shape first, or to leave out.

use crate::geometry::Point;
use crate::geometry::brep::{Brep, Edge, Face};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::geometry::tessellate::edges::add_natural_loops;
use crate::geometry::tessellate::loops::Seeds;
use crate::geometry::tessellate::{TessellateOptions, tessellate};
use crate::observe::Silent;

use super::curve::{foot, length};
use super::{Match, face_of, uses};

/// Sides of a surface that are nearer than this make it closed, mm.
const CLOSED_MM: f64 = 1e-3;
/// Edges run along the sides of a parameter rectangle where they are no farther off, and together
/// no longer or shorter, than this share of the sides' length.
const WHOLE: f64 = 1e-6;
/// Places on an edge that are looked at.
const PLACES: [f64; 5] = [0.08, 0.3, 0.5, 0.7, 0.92];

/// Gives faces without loops the boundary of their parameter rectangle, so that neighbours can
/// share it. A side that is a point is left out.
pub fn write_out_natural_loops(brep: &mut Brep) {
    let spaces: Vec<ParameterSpace> = brep.faces.iter().map(|f| ParameterSpace::of(&f.surface, CLOSED_MM)).collect();
    let before = brep.edges.len();
    add_natural_loops(brep, &spaces);
    let point: Vec<bool> = brep.edges.iter().map(|e| length(e) < 1e-9).collect();
    for one in brep.faces.iter_mut().flat_map(|f| &mut f.loops) {
        one.retain(|c| c.edge < before || !point[c.edge]);
    }
}

/// Drops open edges shorter than the tolerance where their loop has others; how many.
pub fn drop_short_edges(brep: &mut Brep, tolerance_mm: f64) -> usize {
    let uses = uses(brep);
    let short: Vec<bool> = brep.edges.iter().zip(&uses).map(|(e, n)| *n == 1 && length(e) <= tolerance_mm).collect();
    let mut dropped = 0;
    for one in brep.faces.iter_mut().flat_map(|f| &mut f.loops) {
        let before = one.len();
        if one.iter().any(|c| !short[c.edge]) {
            one.retain(|c| !short[c.edge]);
        }
        dropped += before - one.len();
    }
    dropped
}

/// Drops faces no wider than the tolerance; their names. Such a face has open edges, each of which
/// runs along others of the same face, and hardly any area.
pub fn drop_slivers(brep: &mut Brep, tolerance_mm: f64) -> Vec<String> {
    let uses = uses(brep);
    let sliver = |f: &Face| {
        let all: Vec<&Edge> = f.loops.iter().flatten().map(|c| &brep.edges[c.edge]).collect();
        let loose = f.loops.iter().flatten().any(|c| uses[c.edge] == 1);
        loose && all.len() > 1 && folded(&all, tolerance_mm) && {
            let around: f64 = all.iter().map(|e| length(e)).sum();
            let narrow = |m: Mesh| m.area_mm2() <= tolerance_mm * around;
            !is_whole(f, &all, tolerance_mm) && alone(brep, f).is_none_or(narrow)
        }
    };
    let marks: Vec<bool> = brep.faces.iter().map(sliver).collect();
    remove(brep, &marks)
}

/// Whether edges run once round the parameter rectangle of a face's surface, which is wider than
/// the tolerance: that of a sphere, there and back along its seam, lies folded too, and encloses
/// all of it.
fn is_whole(f: &Face, all: &[&Edge], tolerance_mm: f64) -> bool {
    let mut natural = Brep { faces: vec![Face { loops: Vec::new(), ..f.clone() }], edges: Vec::new() };
    write_out_natural_loops(&mut natural);
    let sides: Vec<&Edge> = natural.faces[0].loops.iter().flatten().map(|c| &natural.edges[c.edge]).collect();
    let [own, whole] = [all, &sides].map(|edges| edges.iter().map(|e| length(e)).sum::<f64>());
    let off = |q: &Point, edges: &[&Edge]| edges.iter().map(|e| foot(&e.curve, e.t, q).1).fold(f64::INFINITY, f64::min);
    let along = |e: &&Edge| PLACES.iter().all(|s| off(&e.at(*s), &sides) <= WHOLE * whole);
    let [u, v] = f.surface.domain();
    let between = |[a, b]: [f64; 2], s: f64| a + (b - a) * s;
    let mut inside = PLACES.iter().flat_map(|s| PLACES.map(|t| f.surface.point(between(u, *s), between(v, t))));
    (own - whole).abs() <= WHOLE * whole && all.iter().all(along) && inside.any(|q| off(&q, &sides) > tolerance_mm)
}

/// Whether every edge runs along others of the list.
fn folded(all: &[&Edge], tolerance_mm: f64) -> bool {
    all.iter().enumerate().all(|(i, e)| {
        PLACES.iter().all(|s| {
            let p = e.at(*s);
            let others = all.iter().enumerate().filter(|(j, _)| *j != i);
            others.into_iter().any(|(_, o)| foot(&o.curve, o.t, &p).1 <= tolerance_mm)
        })
    })
}

/// Drops faces that repeat another one: their edges coincide one by one, and what lies between does
/// too. Names of the dropped and of those that stay.
pub fn drop_repeated(brep: &mut Brep, found: &[Match], tolerance_mm: f64) -> Vec<(String, String)> {
    let face_of = face_of(brep);
    let uses = uses(brep);
    let mut pairs = std::collections::BTreeMap::new();
    for m in found {
        let [a, b] = m.edges.map(|e| face_of[e]);
        if a != b {
            *pairs.entry((a.min(b), a.max(b))).or_insert(0usize) += 1;
        }
    }
    let mut marks = vec![false; brep.faces.len()];
    let mut out = Vec::new();
    for ((a, b), n) in pairs {
        let open = |f: usize| {
            let all = || brep.faces[f].loops.iter().flatten();
            (all().count(), all().all(|c| uses[c.edge] == 1))
        };
        if marks[a] || marks[b] || open(a) != (n, true) || open(b) != (n, true) {
            continue;
        }
        if same_inside(brep, &brep.faces[a], &brep.faces[b], tolerance_mm) {
            marks[b] = true;
            out.push((brep.faces[b].name.to_string(), brep.faces[a].name.to_string()));
        }
    }
    remove(brep, &marks);
    out
}

/// Whether points between the edges of `a` lie on the surface of `b`.
fn same_inside(brep: &Brep, a: &Face, b: &Face, tolerance_mm: f64) -> bool {
    let Some(mesh) = alone(brep, a) else { return false };
    let seeds = Seeds::new(&b.surface);
    let [own, space] = [a, b].map(|f| ParameterSpace::of(&f.surface, CLOSED_MM));
    let every = (mesh.corner_uv.len() / 12).max(1);
    mesh.corner_uv.iter().step_by(every).all(|uv| {
        // The middle of a triangle in the parameter plane: a point of the surface itself.
        let [u, v] = own.normal_form([0, 1].map(|k| (uv[0][k] + uv[1][k] + uv[2][k]) / 3.0));
        let p: Point = a.surface.point(u, v);
        seeds.foot(&b.surface, &p, &space).is_some_and(|f| f.distance_mm <= tolerance_mm)
    })
}

/// A face by itself as triangles; `None` where it encloses nothing.
fn alone(brep: &Brep, f: &Face) -> Option<Mesh> {
    let mut own = Brep { faces: vec![f.clone()], edges: Vec::new() };
    let mut number = std::collections::BTreeMap::new();
    for c in own.faces[0].loops.iter_mut().flatten() {
        let edge = c.edge;
        c.edge = *number.entry(edge).or_insert_with(|| {
            own.edges.push(brep.edges[edge].clone());
            own.edges.len() - 1
        });
    }
    tessellate(&own, &TessellateOptions::with_deflection(0.05), &Silent).ok().map(|t| t.mesh)
}

/// Removes faces; their names. Their edges stay, without use.
fn remove(brep: &mut Brep, marks: &[bool]) -> Vec<String> {
    let mut names = Vec::new();
    let mut k = 0;
    brep.faces.retain(|f| {
        k += 1;
        if marks[k - 1] {
            names.push(f.name.to_string());
        }
        !marks[k - 1]
    });
    names
}
