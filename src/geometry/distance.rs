//! The exact distance to trimmed NURBS faces, with the tessellation as guide.
//!
//! A mesh within δ of the part cannot hide its closest point: if the mesh is at distance d, every closest point of the part
//! lies at a triangle no farther than d + 2 δ. Each separate place among those triangles starts Newton on its face's surface
//! (and on the edge curve where a triangle touches one); feet outside their trimming loops are dropped, but then the
//! edge that dropped them counts. The least of what remains is the distance. Since it is a minimum over continuous
//! candidates that enter and leave only while they are not the least, it is continuous in the query point (up to the gaps
//! between edges and surfaces that the model itself has).
//!
//! Whether a foot is inside its loops is decided by the loops' polygons in the parameter plane, and near their sides by
//! the exact edge curve: on which side of its tangent the foot lies.

use super::brep::Brep;
use super::bvh::Near;
use super::mesh::Mesh;
use super::nurbs::foot::{ParameterSpace, SurfaceFoot};
use super::nurbs::{NurbsSurface, SurfaceDerivatives};
use super::part::Closest;
use super::tessellate::{Chord, NO_CHORD, Tessellation, Trim};
use super::triangle::closest_on_segment;
use super::{Point, Vector};

/// Feet this far beyond an edge still count, mm: smooth joints then have no crack.
const BEYOND_EDGE_MM: f64 = 1e-4;
/// Candidates of one face nearer to one another than this share of the distance lead to the same foot.
const SAME_PLACE: f64 = 0.25;

/// A whole round shorter than this is a pole, mm.
const POLE_MM: f64 = 1e-5;

/// What the exact distance needs besides mesh and faces.
#[derive(Clone, Debug)]
pub struct Exact {
    trims: Vec<Region>,
    chords: Vec<Chord>,
    chord_of: Vec<[u32; 3]>,
}

/// A face's trimming, ready for tests.
#[derive(Clone, Debug)]
struct Region {
    trim: Trim,
    bounds: [[f64; 2]; 2],
    /// Per ring: the face lies to the left of its sides in the parameter plane.
    left: Vec<bool>,
}

/// Where a foot lies against the loops of its face.
enum Place {
    Inside,
    /// Outside; the chord that decided, if one did.
    Outside(Option<u32>),
}

/// One candidate for the closest point.
#[derive(Clone, Copy)]
struct Candidate {
    point: Point,
    distance_mm: f64,
    normal: Option<Vector>,
    near: Near,
}

impl Exact {
    /// Takes what it needs out of a tessellation.
    pub fn new(t: &Tessellation) -> Self {
        let trims = t.trims.iter().map(|trim| Region::new(trim.clone())).collect();
        Exact { trims, chords: t.chords.clone(), chord_of: t.chord_of.clone() }
    }

    /// The closest point of the part to `q`, given the triangles `near` that may hold it, nearest first, and the greatest
    /// distance at which edges are of interest. `None` if no foot is valid.
    pub fn closest(&self, brep: &Brep, mesh: &Mesh, q: &Point, near: &[Near], reach_mm: f64) -> Option<Closest> {
        let nearest = near.first()?.distance_mm;
        let mut best: Option<Candidate> = None;
        let mut keep = |c: Candidate| {
            if best.is_none_or(|b| c.distance_mm < b.distance_mm) {
                best = Some(c);
            }
        };
        let mut tried: Vec<(u32, Point)> = Vec::with_capacity(8);
        let mut tried_edges: Vec<(u32, Point)> = Vec::with_capacity(8);
        let apart = SAME_PLACE * nearest;
        for n in near {
            let face = mesh.face(n.triangle as usize);
            if !seen(&mut tried, face, &n.foot, apart)
                && let Some(c) = self.face_foot(brep, mesh, q, n, &mut |chord| {
                    keep(self.edge_foot(brep, q, chord, 0.5, n));
                })
            {
                keep(c);
            }
            let corners = mesh.corners(n.triangle as usize);
            for (k, chord) in self.chord_of[n.triangle as usize].into_iter().enumerate() {
                if chord == NO_CHORD {
                    continue;
                }
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                let foot = closest_on_segment(&a, &b, q);
                if (foot - q).norm() <= reach_mm
                    && !seen(&mut tried_edges, self.chords[chord as usize].edge, &foot, apart)
                {
                    let share = (foot - a).norm() / (b - a).norm().max(f64::MIN_POSITIVE);
                    keep(self.edge_foot(brep, q, chord, share, n));
                }
            }
        }
        best.map(|b| self.finish(brep, mesh, b))
    }

    /// The foot on the surface of a triangle's face, if it is inside the loops; otherwise the chord that keeps it out goes to `out`.
    fn face_foot(&self, brep: &Brep, mesh: &Mesh, q: &Point, n: &Near, out: &mut dyn FnMut(u32)) -> Option<Candidate> {
        let f = mesh.face(n.triangle as usize) as usize;
        let (face, region) = (&brep.faces[f], &self.trims[f]);
        let mut foot = face.surface.foot(q, guess(mesh, n), &region.trim.space);
        if is_pole(&foot.at, &region.trim.space) {
            foot = around_pole(&face.surface, q, foot, &region.trim.space);
        }
        match region.place(brep, &self.chords, region.trim.space.normal_form(foot.uv), &foot.at) {
            Place::Inside => {
                let pole = is_pole(&foot.at, &region.trim.space);
                let normal = foot.at.normal().filter(|_| !pole).map(|m| if face.reversed { -m } else { m });
                Some(Candidate { point: foot.at.p, distance_mm: foot.distance_mm, normal, near: *n })
            }
            Place::Outside(chord) => {
                if let Some(chord) = chord {
                    out(chord);
                }
                None
            }
        }
    }

    /// The foot on an edge, from a chord of it; always a point of the part.
    fn edge_foot(&self, brep: &Brep, q: &Point, chord: u32, share: f64, n: &Near) -> Candidate {
        let c = &self.chords[chord as usize];
        let edge = &brep.edges[c.edge as usize];
        // The chord may run along its edge either way: of the two guesses the nearer one.
        let [s, r] = [share, 1.0 - share].map(|s| c.t[0] + s * (c.t[1] - c.t[0]));
        let start = if (edge.curve.point(s) - q).norm() <= (edge.curve.point(r) - q).norm() { s } else { r };
        let foot = edge.curve.foot(q, start, edge.t);
        Candidate { point: foot.point, distance_mm: foot.distance_mm, normal: None, near: *n }
    }

    fn finish(&self, brep: &Brep, mesh: &Mesh, best: Candidate) -> Closest {
        let triangle = best.near.triangle;
        let face = mesh.face(triangle as usize);
        let normal = best.normal.or_else(|| {
            // On an edge: the normal of the face that led there.
            let f = &brep.faces[face as usize];
            let space = &self.trims[face as usize].trim.space;
            let foot = f.surface.foot(&best.point, guess(mesh, &best.near), space);
            let pole = is_pole(&foot.at, space);
            foot.at.normal().filter(|_| !pole).map(|m| if f.reversed { -m } else { m })
        });
        Closest {
            point: best.point,
            distance_mm: best.distance_mm,
            normal: normal.unwrap_or_else(|| mesh.normal(triangle as usize)),
            face,
            triangle,
        }
    }
}

/// Whether one parameter, over its whole range, moves the point by next to nothing.
fn is_pole(at: &SurfaceDerivatives, space: &ParameterSpace) -> bool {
    at.du.norm() * space.period(0) < POLE_MM || at.dv.norm() * space.period(1) < POLE_MM
}

/// At a pole one parameter moves nothing, so Newton cannot turn towards a better side: turns to the side along which
/// the distance falls most, if there is one, and starts again from there.
fn around_pole(surface: &NurbsSurface, q: &Point, stuck: SurfaceFoot, space: &ParameterSpace) -> SurfaceFoot {
    let free = usize::from(stuck.at.dv.norm() * space.period(1) < stuck.at.du.norm() * space.period(0));
    let [from, to] = space.domain[1 - free];
    let inwards = if 2.0 * stuck.uv[1 - free] < from + to { 1.0 } else { -1.0 };
    let side = |x: f64| {
        let mut uv = stuck.uv;
        uv[free] = x;
        let n = space.normal_form(uv);
        let at = surface.derivatives(n[0], n[1]);
        let d = if free == 0 { at.dv } else { at.du } * inwards;
        // How far along that side the foot lies: in mm, and as a parameter.
        let mm = (q - at.p).dot(&d) / d.norm().max(f64::MIN_POSITIVE);
        uv[1 - free] += inwards * mm / d.norm().max(f64::MIN_POSITIVE);
        (mm, uv)
    };
    let width = space.period(free) / 32.0;
    let at = |k: u32| space.domain[free][0] + width * (f64::from(k) + 0.5);
    let best = (0..32).map(at).max_by(|a, b| side(*a).0.total_cmp(&side(*b).0)).unwrap_or(stuck.uv[free]);
    let (mut low, mut high) = (best - width, best + width);
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if side(a).0 < side(b).0 { low = a } else { high = b }
    }
    let (mm, uv) = side(0.5 * (low + high));
    let turned = surface.foot(q, uv, space);
    if mm > 0.0 && turned.distance_mm < stuck.distance_mm { turned } else { stuck }
}

/// Whether this place of this face or edge was tried before; notes it if not.
fn seen(tried: &mut Vec<(u32, Point)>, what: u32, at: &Point, apart: f64) -> bool {
    if tried.iter().any(|(w, p)| *w == what && (p - at).norm() <= apart) {
        return true;
    }
    tried.push((what, *at));
    false
}

/// Parameters of a triangle's closest point, from those of its corners.
fn guess(mesh: &Mesh, n: &Near) -> [f64; 2] {
    let [a, b, c] = mesh.corners(n.triangle as usize);
    let uv = mesh.corner_uv[n.triangle as usize];
    let normal = (b - a).cross(&(c - a));
    let area2 = normal.norm_squared();
    if area2 == 0.0 {
        return uv[0];
    }
    let wb = (n.foot - a).cross(&(c - a)).dot(&normal) / area2;
    let wc = (b - a).cross(&(n.foot - a)).dot(&normal) / area2;
    [0, 1].map(|k| uv[0][k] + wb * (uv[1][k] - uv[0][k]) + wc * (uv[2][k] - uv[0][k]))
}

impl Region {
    fn new(trim: Trim) -> Self {
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for n in trim.rings.iter().flat_map(|r| &r.nodes) {
            for (side, x) in bounds.iter_mut().zip(n.uv) {
                *side = [side[0].min(x), side[1].max(x)];
            }
        }
        // A ring within an odd number of others is a hole.
        let left = (0..trim.rings.len())
            .map(|k| {
                let ring = &trim.rings[k];
                let others = trim.rings.iter().enumerate().filter(|(j, _)| *j != k);
                let at = ring.nodes.first().map_or([0.0; 2], |n| n.uv);
                let hole = others.map(|(_, r)| crossings(r, at)).sum::<usize>() % 2 == 1;
                (ring.signed_area() > 0.0) != hole
            })
            .collect();
        Region { trim, bounds, left }
    }

    /// Tests one foot; `uv` in normal form.
    fn place(&self, brep: &Brep, chords: &[Chord], uv: [f64; 2], at: &SurfaceDerivatives) -> Place {
        let mut outside = None;
        let copies = [0, 1].map(|a| self.copies(a, uv[a]));
        for i in copies[0].clone() {
            for j in copies[1].clone() {
                let shift = [i, j];
                let copy = [0, 1].map(|a| uv[a] + shift[a] as f64 * self.trim.space.period(a));
                match self.place_copy(brep, chords, copy, at) {
                    Place::Inside => return Place::Inside,
                    Place::Outside(chord) => outside = outside.or(chord),
                }
            }
        }
        Place::Outside(outside)
    }

    /// Which copies of a parameter along a closed direction may lie within the loops.
    fn copies(&self, along: usize, x: f64) -> std::ops::RangeInclusive<i64> {
        if !self.trim.space.closed[along] {
            return 0..=0;
        }
        let period = self.trim.space.period(along);
        let [from, to] = self.bounds[along];
        (((from - x) / period - 1e-9).ceil() as i64)..=(((to - x) / period + 1e-9).floor() as i64)
    }

    fn place_copy(&self, brep: &Brep, chords: &[Chord], uv: [f64; 2], at: &SurfaceDerivatives) -> Place {
        let metric = [at.du.norm_squared(), at.du.dot(&at.dv), at.dv.norm_squared()];
        let limit = 2.0 * self.trim.blur_mm + BEYOND_EDGE_MM;
        let mut count = 0;
        // The nearest side in reach: squared distance, ring, node.
        let mut nearest: Option<(f64, usize, usize)> = None;
        for (r, ring) in self.trim.rings.iter().enumerate() {
            let mut from = match ring.nodes.last() {
                Some(n) => n.uv,
                None => continue,
            };
            let last = ring.nodes.len() - 1;
            for (k, node) in ring.nodes.iter().enumerate() {
                let side = if k == 0 { last } else { k - 1 };
                count += usize::from(crosses(from, node.uv, uv));
                if !ring.nodes[side].seam {
                    let d2 = side_distance2(from, node.uv, uv, metric);
                    if d2 <= limit * limit && nearest.is_none_or(|n| d2 < n.0) {
                        nearest = Some((d2, r, side));
                    }
                }
                from = node.uv;
            }
        }
        let inside = count % 2 == 1;
        match nearest {
            None if inside => Place::Inside,
            None => Place::Outside(None),
            Some((_, r, k)) => self.beside_edge(brep, chords, r, k, at, inside),
        }
    }

    /// Decides by the exact edge curve on which side of it the foot lies.
    fn beside_edge(
        &self,
        brep: &Brep,
        chords: &[Chord],
        r: usize,
        k: usize,
        at: &SurfaceDerivatives,
        inside: bool,
    ) -> Place {
        let node = &self.trim.rings[r].nodes[k];
        let by_polygon = |chord| if inside { Place::Inside } else { Place::Outside(chord) };
        let Some(chord) = chords.get(node.chord as usize) else { return by_polygon(None) };
        let edge = &brep.edges[chord.edge as usize];
        let on = edge.curve.foot(&at.p, 0.5 * (chord.t[0] + chord.t[1]), edge.t);
        let aside = at.p - on.point;
        if aside.norm() <= BEYOND_EDGE_MM {
            return Place::Inside;
        }
        let tangent = if node.against { -on.tangent } else { on.tangent };
        // To the left of the ring seen against S_u × S_v, as in the parameter plane.
        let Some(left) = at.du.cross(&at.dv).cross(&tangent).try_normalize(0.0) else {
            return by_polygon(Some(node.chord));
        };
        let across = aside.dot(&left);
        if (on.t <= edge.t[0] || on.t >= edge.t[1]) && across.abs() < 0.5 * aside.norm() {
            // Beyond a corner the tangent of one edge says nothing; the polygon is exact at its corners.
            return by_polygon(Some(node.chord));
        }
        let inwards = if self.left[r] { across } else { -across };
        if inwards >= -BEYOND_EDGE_MM { Place::Inside } else { Place::Outside(Some(node.chord)) }
    }
}

/// Whether the side `a b` crosses the ray from `p` towards greater u.
fn crosses(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> bool {
    (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
}

fn crossings(ring: &super::tessellate::loops::Ring, p: [f64; 2]) -> usize {
    let n = ring.nodes.len();
    (0..n).filter(|k| crosses(ring.nodes[*k].uv, ring.nodes[(k + 1) % n].uv, p)).count()
}

/// Squared distance from `p` to the side `a b`, mm², with the surface's metric (E, F, G) at `p`.
fn side_distance2(a: [f64; 2], b: [f64; 2], p: [f64; 2], [e, f, g]: [f64; 3]) -> f64 {
    let dot = |x: [f64; 2], y: [f64; 2]| e * x[0] * y[0] + f * (x[0] * y[1] + x[1] * y[0]) + g * x[1] * y[1];
    let d = [b[0] - a[0], b[1] - a[1]];
    let r = [p[0] - a[0], p[1] - a[1]];
    let length2 = dot(d, d);
    let s = if length2 > 0.0 { (dot(r, d) / length2).clamp(0.0, 1.0) } else { 0.0 };
    let off = [r[0] - s * d[0], r[1] - s * d[1]];
    dot(off, off)
}

#[cfg(test)]
#[path = "distance_tests.rs"]
mod tests;
