//! One face: its rings filled with triangles.

use std::collections::BTreeMap;

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::edges::EdgeNet;
use super::grid::{GridScale, scales};
use super::loops::{Rings, TrimRing, rings_of};
use super::{NO_CHORD, OWN, TessellateOptions, Trim, face_error};
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Face};
use crate::geometry::nurbs::foot::ParameterSpace;

/// Grid points keep this distance from the border, in units of the grid.
const CLEARANCE: f64 = 0.35;
/// The grid is refined at most this often.
const ROUNDS: usize = 5;

/// A filled face. Ids below [`OWN`] are shared points, the others `points`.
#[derive(Clone)]
pub struct Filled {
    /// The face's own points.
    pub points: Vec<Point>,
    /// Its triangles.
    pub triangles: Vec<Triangle>,
    /// Trimming.
    pub trim: Trim,
    /// Measured deflection, mm.
    pub deflection_mm: f64,
    /// Chords too long for the surface beside them.
    pub split: Vec<u32>,
}

/// A triangle of a face.
#[derive(Clone, Copy)]
pub struct Triangle {
    /// Corner ids.
    pub corners: [u32; 3],
    /// Corner parameters, unrolled.
    pub uv: [[f64; 2]; 3],
    /// Chord on each side, or [`NO_CHORD`].
    pub chords: [u32; 3],
}

impl Filled {
    /// After chords elsewhere were split: new numbers for its own.
    pub fn renumber(&mut self, new: &[u32]) {
        let number = |c: &mut u32| *c = new.get(*c as usize).copied().unwrap_or(NO_CHORD);
        self.triangles.iter_mut().flat_map(|t| &mut t.chords).for_each(number);
        self.trim.rings.iter_mut().flat_map(|r| &mut r.nodes).for_each(|n| number(&mut n.chord));
        self.split.iter_mut().for_each(number);
    }
}

/// Fills a face.
///
/// # Errors
/// See [`super::tessellate`].
pub fn fill_face(
    brep: &Brep,
    f: usize,
    net: &EdgeNet,
    space: ParameterSpace,
    options: &TessellateOptions,
) -> Result<Filled> {
    let face = &brep.faces[f];
    let rings = rings_of(brep, f, net, space, options)?;
    let bounds = bounds_of(&rings.rings);
    let mut space = space;
    for along in 0..2 {
        // Straight directions are continued as far as the loops need; others only by rounding.
        space.range[along][0] = space.range[along][0].min(bounds[along][0]);
        space.range[along][1] = space.range[along][1].max(bounds[along][1]);
    }
    let blur_mm = blur(brep, face, net, &rings.rings, &space);
    // What the model's own gaps take, no refinement can give back.
    let limit_mm = options.deflection_mm + 1.5 * gap(face, net, &rings.rings, &space);
    let beside = chords_at(&rings.rings, net);
    let mut finer = 1.0;
    let mut before = f64::INFINITY;
    let mut best: Option<Filled> = None;
    for _ in 0..ROUNDS {
        let scale = scales(&face.surface, &space, bounds, options, finer);
        let mut points = rings.points.clone();
        let triangles = triangulate(face, &rings, &scale, &space, &mut points)?;
        let point = |i: u32| if i < OWN { net.points[i as usize] } else { points[(i - OWN) as usize] };
        let sag = measure(face, &space, point, &triangles, &beside, limit_mm);
        let trim = Trim { space, rings: Vec::new(), blur_mm };
        if best.as_ref().is_none_or(|b| sag.worst < b.deflection_mm) {
            best = Some(Filled { points, triangles, trim, deflection_mm: sag.worst, split: sag.split });
        }
        if sag.inside <= limit_mm || sag.inside > 0.85 * before {
            break;
        }
        before = sag.inside;
        finer *= (1.2 * sag.inside / options.deflection_mm).sqrt().clamp(1.2, 2.0);
    }
    let mut filled = best.ok_or_else(|| face_error(face, "could not be filled"))?;
    filled.trim.rings = rings.rings;
    // Samples are not bounds: a quarter more covers what lies between them.
    filled.deflection_mm *= 1.25;
    Ok(filled)
}

fn bounds_of(rings: &[TrimRing]) -> [[f64; 2]; 2] {
    let mut b = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for n in rings.iter().flat_map(|r| &r.nodes) {
        for (side, x) in b.iter_mut().zip(n.uv) {
            *side = [side[0].min(x), side[1].max(x)];
        }
    }
    b
}

/// Greatest distance between sides of the rings on the surface and the curves that they stand for,
/// mm.
fn blur(brep: &Brep, face: &Face, net: &EdgeNet, rings: &[TrimRing], space: &ParameterSpace) -> f64 {
    let mut worst = 0.0f64;
    for ring in rings {
        for (k, n) in ring.nodes.iter().enumerate() {
            let Some(chord) = net.chords.get(n.chord as usize) else { continue };
            let next = ring.nodes[(k + 1) % ring.nodes.len()].uv;
            for s in [0.25, 0.5, 0.75] {
                let uv = space.normal_form([0, 1].map(|a| n.uv[a] + s * (next[a] - n.uv[a])));
                let p = face.surface.point(uv[0], uv[1]);
                let edge = &brep.edges[chord.edge as usize];
                let along = if n.against { 1.0 - s } else { s };
                let guess = chord.t[0] + along * (chord.t[1] - chord.t[0]);
                worst = worst.max(edge.curve.foot(&p, guess, edge.t).distance_mm);
            }
        }
    }
    1.5 * worst + 1e-6
}

/// Greatest distance between the face's edges and its surface, mm.
fn gap(face: &Face, net: &EdgeNet, rings: &[TrimRing], space: &ParameterSpace) -> f64 {
    let off = rings.iter().flat_map(|r| &r.nodes).filter(|n| n.id < OWN).map(|n| {
        let uv = space.normal_form(n.uv);
        (face.surface.point(uv[0], uv[1]) - net.points[n.id as usize]).norm()
    });
    off.fold(0.0, f64::max)
}

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Triangles inside the rings; adds the face's own points.
fn triangulate(
    face: &Face,
    outline: &Rings,
    scale: &[GridScale; 2],
    space: &ParameterSpace,
    points: &mut Vec<Point>,
) -> Result<Vec<Triangle>> {
    let rings = &outline.rings;
    let xy = |uv: [f64; 2]| [scale[0].map(uv[0]), scale[1].map(uv[1])];
    let mut cdt = Cdt::new();
    // Per vertex of the triangulation: parameters and mesh point.
    let mut known: Vec<([f64; 2], u32)> = Vec::new();
    let insert = |cdt: &mut Cdt, uv: [f64; 2], id: u32, known: &mut Vec<([f64; 2], u32)>| {
        let [x, y] = xy(uv);
        // The triangulation refuses coordinates that are tiny but not zero.
        let tidy = |x: f64| if x.abs() < 1e-30 { 0.0 } else { x };
        let handle = cdt
            .insert(Point2::new(tidy(x), tidy(y)))
            .map_err(|e| face_error(face, &format!("has a loop point that cannot be placed ({e})")))?;
        if handle.index() == known.len() {
            known.push((uv, id));
        }
        Ok::<_, crate::error::Error>(handle)
    };
    let mut handles = Vec::new();
    for ring in rings {
        let mut one = Vec::new();
        for n in &ring.nodes {
            one.push(insert(&mut cdt, n.uv, n.id, &mut known)?);
        }
        handles.push(one);
    }
    // Sides by (low, high) vertex: chord, and how often the border runs there.
    let mut sides: BTreeMap<[usize; 2], (u32, u32)> = BTreeMap::new();
    for (ring, hs) in rings.iter().zip(&handles) {
        for (k, n) in ring.nodes.iter().enumerate() {
            let (a, b) = (hs[k], hs[(k + 1) % hs.len()]);
            if a == b {
                continue;
            }
            if !cdt.exists_constraint(a, b) && cdt.try_add_constraint(a, b).is_empty() {
                return Err(face_error(face, &format!("has loops that cross one another {}", at(face, n.uv))));
            }
            let side = sides.entry([a.index().min(b.index()), a.index().max(b.index())]).or_insert((n.chord, 0));
            side.1 += 1;
        }
    }
    for [x, y] in inner_grid(rings, &xy) {
        let uv = [scale[0].inverse(x), scale[1].inverse(y)];
        let n = space.normal_form(uv);
        let before = known.len();
        insert(&mut cdt, uv, OWN + points.len() as u32, &mut known)?;
        if known.len() > before {
            points.push(face.surface.point(n[0], n[1]));
        }
    }
    collect(face, &cdt, &known, &sides, &outline.poles)
}

/// Grid points inside the rings that keep off their sides, in grid coordinates.
fn inner_grid(rings: &[TrimRing], xy: &dyn Fn([f64; 2]) -> [f64; 2]) -> Vec<[f64; 2]> {
    let polygons: Vec<Vec<[f64; 2]>> = rings.iter().map(|r| r.nodes.iter().map(|n| xy(n.uv)).collect()).collect();
    let sides = || polygons.iter().flat_map(|p| (0..p.len()).map(move |k| (p[k], p[(k + 1) % p.len()])));
    let mut crossings: BTreeMap<i64, Vec<f64>> = BTreeMap::new();
    let mut taken = std::collections::BTreeSet::new();
    for (a, b) in sides() {
        let (lo, hi) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let mut row = lo[1].ceil();
        while row < hi[1] {
            let x = lo[0] + (row - lo[1]) / (hi[1] - lo[1]) * (hi[0] - lo[0]);
            crossings.entry(row as i64).or_default().push(x);
            row += 1.0;
        }
        let steps = (((b[0] - a[0]).hypot(b[1] - a[1]) / 0.25).ceil() as usize).clamp(1, 100_000);
        for k in 0..=steps {
            let s = k as f64 / steps as f64;
            let p = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
            let near = [p[0].round(), p[1].round()];
            if (p[0] - near[0]).hypot(p[1] - near[1]) < CLEARANCE {
                taken.insert((near[0] as i64, near[1] as i64));
            }
        }
    }
    let mut out = Vec::new();
    for (row, mut xs) in crossings {
        xs.sort_by(f64::total_cmp);
        for pair in xs.chunks_exact(2) {
            let (from, to) = (pair[0].ceil() as i64, pair[1].floor() as i64);
            out.extend((from..=to).filter(|x| !taken.contains(&(*x, row))).map(|x| [x as f64, row as f64]));
        }
    }
    out
}

/// The triangles within the border: from outside inwards, each crossing of the border changes
/// sides.
fn collect(
    face: &Face,
    cdt: &Cdt,
    known: &[([f64; 2], u32)],
    sides: &BTreeMap<[usize; 2], (u32, u32)>,
    poles: &[(u32, usize)],
) -> Result<Vec<Triangle>> {
    let count = cdt.num_all_faces();
    let mut inside: Vec<Option<bool>> = vec![None; count];
    let outer = cdt.outer_face().fix();
    inside[outer.index()] = Some(false);
    let mut stack: Vec<_> = cdt.convex_hull().map(|e| e.fix().rev()).collect();
    stack.extend(cdt.convex_hull().map(|e| e.fix()));
    let key = |a: usize, b: usize| [a.min(b), a.max(b)];
    while let Some(h) = stack.pop() {
        // From the face on the left of `h` to the one on its right.
        let e = cdt.directed_edge(h);
        let (Some(here), right) = (inside[e.face().fix().index()], e.rev().face()) else { continue };
        let index = right.fix().index();
        if inside[index].is_some() {
            continue;
        }
        let odd = sides.get(&key(e.from().fix().index(), e.to().fix().index())).is_some_and(|s| s.1 % 2 == 1);
        inside[index] = Some(here != odd);
        if let Some(inner) = right.as_inner() {
            stack.extend(inner.adjacent_edges().map(|e| e.fix()));
        }
    }
    let mut out = Vec::new();
    let mut met: BTreeMap<[usize; 2], u32> = BTreeMap::new();
    for t in cdt.inner_faces() {
        if inside[t.fix().index()] != Some(true) {
            continue;
        }
        let mut v = t.vertices().map(|v| v.fix().index());
        if face.reversed {
            v.swap(1, 2);
        }
        let chords = [0, 1, 2].map(|k| {
            let side = key(v[k], v[(k + 1) % 3]);
            sides.get(&side).map_or(NO_CHORD, |s| {
                *met.entry(side).or_insert(0) += 1;
                s.0
            })
        });
        let corners = v.map(|i| known[i].1);
        // Around a pole a triangle may have the pole twice: no area, and its neighbours meet
        // without it.
        if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
            let mut uv = v.map(|i| known[i].0);
            for k in 0..3 {
                // At a pole one parameter is free: the middle of the others.
                if let Some((_, free)) = poles.iter().find(|p| p.0 == corners[k]) {
                    uv[k][*free] = 0.5 * (uv[(k + 1) % 3][*free] + uv[(k + 2) % 3][*free]);
                }
            }
            out.push(Triangle { corners, uv, chords });
        }
    }
    if let Some((side, _)) = sides.iter().find(|(side, s)| s.1 % 2 == 1 && met.get(*side) != Some(&1)) {
        let place = at(face, known[side[0]].0);
        return Err(face_error(face, &format!("has a loop that touches itself or crosses another {place}")));
    }
    if out.is_empty() {
        return Err(face_error(face, "has loops that enclose nothing"));
    }
    Ok(out)
}

/// A place on a face for a message.
fn at(face: &Face, [u, v]: [f64; 2]) -> String {
    let p = face.surface.point(u, v);
    format!("at x {:.4} y {:.4} z {:.4} mm", p.x, p.y, p.z)
}

/// Per shared point: the chords that meet there, with their lengths, mm.
fn chords_at(rings: &[TrimRing], net: &EdgeNet) -> BTreeMap<u32, Vec<(u32, f64)>> {
    let mut out: BTreeMap<u32, Vec<(u32, f64)>> = BTreeMap::new();
    for ring in rings {
        for (k, n) in ring.nodes.iter().enumerate() {
            let next = ring.nodes[(k + 1) % ring.nodes.len()].id;
            if n.chord != NO_CHORD && n.id < OWN && next < OWN {
                let length = (net.points[next as usize] - net.points[n.id as usize]).norm();
                out.entry(n.id).or_default().push((n.chord, length));
                out.entry(next).or_default().push((n.chord, length));
            }
        }
    }
    out
}

/// How far triangles are from the surface.
struct Sag {
    /// Greatest of all, mm.
    worst: f64,
    /// Greatest of those that a finer grid can improve, mm.
    inside: f64,
    /// Long chords beside triangles beyond the limit.
    split: Vec<u32>,
}

/// Distance between triangles and the surface, along the triangles' normals, sampled at their
/// middle and the middles of their sides.
fn measure(
    face: &Face,
    space: &ParameterSpace,
    point: impl Fn(u32) -> Point,
    triangles: &[Triangle],
    beside: &BTreeMap<u32, Vec<(u32, f64)>>,
    limit_mm: f64,
) -> Sag {
    let mut out = Sag { worst: 0.0, inside: 0.0, split: Vec::new() };
    for t in triangles {
        let p = t.corners.map(&point);
        let Some(n) = (p[1] - p[0]).cross(&(p[2] - p[0])).try_normalize(1e-12) else { continue };
        let mut worst = 0.0f64;
        for w in [[1.0 / 3.0; 3], [0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]] {
            let uv = space.normal_form([0, 1].map(|a| (0..3).map(|k| w[k] * t.uv[k][a]).sum::<f64>()));
            worst = worst.max((face.surface.point(uv[0], uv[1]) - p[0]).dot(&n).abs());
        }
        out.worst = out.worst.max(worst);
        if worst <= limit_mm {
            continue;
        }
        // Long chords beside the triangle are to blame, not the grid: its fan cannot get shorter
        // than they are.
        let longest = [0, 1, 2].map(|k| (p[(k + 1) % 3] - p[k]).norm()).into_iter().fold(0.0, f64::max);
        let least = (0.5 * longest).max(2.0 * limit_mm);
        let found = t.corners.iter().filter_map(|id| beside.get(id)).flatten().filter(|c| c.1 > least);
        let known = out.split.len();
        out.split.extend(found.map(|c| c.0));
        if out.split.len() == known {
            out.inside = out.inside.max(worst);
        }
    }
    out
}
