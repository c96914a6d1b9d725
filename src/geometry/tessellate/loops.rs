//! Loops of edges carried into the parameter plane of their face.
//!
//! Every point of a loop is projected onto the surface, starting from the point before it; closed
//! directions run on (unrolled) instead of jumping back. Where the loop passes a pole (a side of
//! the parameter rectangle that is one point in space) the ring gets two nodes there, joined along
//! that side. Loops that run round a closed surface come in pairs, or with a pole, and are joined
//! by a bridge.

use super::edges::{EdgeNet, HEAL_MM};
use super::{NO_CHORD, OWN, TessellateOptions, face_error};
use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Coedge, Face};
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::foot::{ParameterSpace, SurfaceFoot};

/// A loop point farther from its surface than this is an error, mm.
const OFF_SURFACE_MM: f64 = 0.05;

/// Corners of a ring, about, by which its place is found.
const NESTED_AT: usize = 16;

/// A closed polygon in the parameter plane.
#[derive(Clone, Debug, Default)]
pub struct TrimRing {
    /// Its corners.
    pub nodes: Vec<RingCorner>,
}

/// A corner of a ring and the side that leaves it.
#[derive(Clone, Copy, Debug)]
pub struct RingCorner {
    /// Parameters; along closed directions unrolled.
    pub uv: [f64; 2],
    /// Mesh point: shared by index, the face's own from [`OWN`] on.
    pub id: u32,
    /// Chord of the side to the next node, or [`NO_CHORD`] (a pole, a bridge).
    pub chord: u32,
    /// The side runs against the chord.
    pub against: bool,
    /// The side's edge is used twice by this face: no border.
    pub seam: bool,
}

/// The rings of a face.
#[derive(Debug, Default)]
pub struct Rings {
    /// Closed rings.
    pub rings: Vec<TrimRing>,
    /// Points on bridges; the first has the id [`OWN`].
    pub points: Vec<Point>,
    /// Mesh points that are poles, with the parameter that is free there (0 for u, 1 for v).
    pub poles: Vec<(u32, usize)>,
}

/// Guesses for feet anywhere on a surface: a grid of its points.
pub struct Seeds {
    grid: Vec<([f64; 2], Point)>,
}

/// A side of the parameter rectangle that is one point in space.
struct Pole {
    /// The parameter that is fixed there: 0 for u, 1 for v.
    fixed: usize,
    value: f64,
    point: Point,
}

/// What it takes to project onto one face.
struct Projector<'a> {
    face: &'a Face,
    space: ParameterSpace,
    seeds: Seeds,
    poles: Vec<Pole>,
    accept_mm: f64,
}

impl Seeds {
    /// Samples all knot spans.
    pub fn new(surface: &NurbsSurface) -> Self {
        let lines = |degree: usize, n: usize, knots: &[f64]| {
            let mut spans: Vec<f64> = knots[degree..=n].to_vec();
            spans.dedup();
            let pieces = (48 / spans.len().max(1)).clamp(1, 8).max(2);
            let stride = (spans.len() / 48).max(1);
            let mut out = Vec::new();
            for w in spans.windows(2).step_by(stride) {
                out.extend((0..pieces).map(|k| w[0] + (w[1] - w[0]) * k as f64 / pieces as f64));
            }
            out.extend(spans.last());
            out
        };
        let us = lines(surface.degree_u, surface.n_u, &surface.knots_u);
        let vs = lines(surface.degree_v, surface.n_v, &surface.knots_v);
        let grid = us.iter().flat_map(|u| vs.iter().map(move |v| ([*u, *v], surface.point(*u, *v)))).collect();
        Seeds { grid }
    }

    /// The best foot from the nearest few samples.
    pub fn foot(&self, surface: &NurbsSurface, q: &Point, space: &ParameterSpace) -> Option<SurfaceFoot> {
        let mut near: Vec<(f64, [f64; 2])> = Vec::new();
        for (uv, p) in &self.grid {
            let d = (p - q).norm_squared();
            if near.len() < 6 || d < near[near.len() - 1].0 {
                let at = near.partition_point(|n| n.0 <= d);
                near.insert(at, (d, *uv));
                near.truncate(6);
            }
        }
        let feet = near.iter().map(|(_, uv)| surface.foot(q, *uv, space));
        feet.min_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm))
    }
}

/// All rings of a face.
///
/// # Errors
/// A loop that does not close, whose points do not lie on the surface, or that runs round a closed
/// surface without a partner.
pub fn rings_of(
    brep: &Brep,
    f: usize,
    net: &EdgeNet,
    space: ParameterSpace,
    options: &TessellateOptions,
) -> Result<Rings> {
    let face = &brep.faces[f];
    let tolerance = 10.0 * options.weld_mm;
    let projector = Projector {
        face,
        space,
        seeds: Seeds::new(&face.surface),
        poles: poles_of(&face.surface, tolerance),
        accept_mm: 20.0 * options.weld_mm,
    };
    let mut uses = std::collections::BTreeMap::new();
    face.loops.iter().flatten().for_each(|c| *uses.entry(c.edge).or_insert(0) += 1);
    let mut out = Rings::default();
    let mut wound = Vec::new();
    for one in &face.loops {
        let corners = corners_of(face, one, net, &|edge| uses.get(&edge).is_some_and(|n| *n > 1))?;
        if corners.is_empty() {
            continue;
        }
        let (ring, turns) = projector.carry(&corners, net, &mut out.poles)?;
        if turns == [0, 0] {
            out.rings.push(ring);
        } else {
            wound.push((ring, turns));
        }
    }
    projector.join_wound(wound, options, &mut out)?;
    nest(&mut out.rings, &space);
    if out.rings.is_empty() {
        return Err(face_error(face, "has no loop of any length"));
    }
    Ok(out)
}

/// Moves rings along closed directions by whole periods so that they lie in the largest one: each
/// was unrolled by itself, and a hole beside the outer ring would be a piece of surface.
fn nest(rings: &mut [TrimRing], space: &ParameterSpace) {
    let size = |r: &TrimRing| r.signed_area().abs();
    let largest = (0..rings.len()).max_by(|a, b| size(&rings[*a]).total_cmp(&size(&rings[*b])));
    let Some(outer) = largest.filter(|_| rings.len() > 1 && space.closed.contains(&true)) else { return };
    let outer_ring = rings[outer].clone();
    let steps = |along: usize| if space.closed[along] { [0.0, -1.0, 1.0].iter() } else { [0.0].iter() };
    for ring in rings.iter_mut().enumerate().filter(|(k, _)| *k != outer).map(|(_, r)| r) {
        let stride = ring.nodes.len().div_ceil(NESTED_AT);
        let inside = |by: [f64; 2]| {
            let at = ring.nodes.iter().step_by(stride).map(|n| [n.uv[0] + by[0], n.uv[1] + by[1]]);
            at.filter(|uv| outer_ring.holds(*uv)).count()
        };
        let shifts = steps(0).flat_map(|i| steps(1).map(move |j| [i * space.period(0), j * space.period(1)]));
        // The first of those that are as good: where it is, if it can stay there.
        let best = shifts.map(|by| (inside(by), by)).reduce(|a, b| if b.0 > a.0 { b } else { a });
        let Some((_, [u, v])) = best else { continue };
        for n in &mut ring.nodes {
            n.uv = [n.uv[0] + u, n.uv[1] + v];
        }
    }
}

fn poles_of(surface: &NurbsSurface, tolerance: f64) -> Vec<Pole> {
    let domain = surface.domain();
    let mut poles = Vec::new();
    for fixed in 0..2 {
        for value in domain[fixed] {
            let at = |s: f64| {
                let other = domain[1 - fixed][0] + s * (domain[1 - fixed][1] - domain[1 - fixed][0]);
                if fixed == 0 { surface.point(value, other) } else { surface.point(other, value) }
            };
            let point = at(0.0);
            if (1..=8).all(|k| (at(f64::from(k) / 8.0) - point).norm() <= tolerance) {
                poles.push(Pole { fixed, value, point });
            }
        }
    }
    poles
}

/// What gaps between edges of a loop are closed, in words.
fn limit() -> String {
    format!("limit {HEAL_MM} mm, and a fifth of the shorter edge")
}

/// The corners of a loop in order, each with the chord to the next one; `uv` still to come.
fn corners_of(face: &Face, one: &[Coedge], net: &EdgeNet, seam: &dyn Fn(usize) -> bool) -> Result<Vec<RingCorner>> {
    let mut left: Vec<Coedge> = one.iter().copied().filter(|c| net.lines[c.edge].ids.len() > 1).collect();
    let ends = |c: &Coedge| {
        let ids = &net.lines[c.edge].ids;
        let (a, b) = (ids[0], ids[ids.len() - 1]);
        if c.reversed { [b, a] } else { [a, b] }
    };
    let mut chain: Vec<Coedge> = Vec::new();
    while !left.is_empty() {
        let Some(last) = chain.last().map(ends) else {
            chain.push(left.remove(0));
            continue;
        };
        // As the loop says; if that does not fit, whichever edge does.
        let flip = |c: &Coedge| Coedge { reversed: !c.reversed, ..*c };
        let fits = left.iter().position(|c| ends(c)[0] == last[1]).map(|i| (i, false));
        let (i, turned) = fits
            .or_else(|| left.iter().position(|c| ends(&flip(c))[0] == last[1]).map(|i| (i, true)))
            .ok_or_else(|| {
                let p = net.points[last[1] as usize];
                let widths_mm = left.iter().flat_map(ends).map(|id| (net.points[id as usize] - p).norm());
                let width_mm = widths_mm.fold(f64::INFINITY, f64::min);
                let at = format!("at x {:.4} y {:.4} z {:.4} mm", p.x, p.y, p.z);
                face_error(face, &format!("has a loop with a gap of {width_mm:.4} mm {at} ({})", limit()))
            })?;
        let next = left.remove(i);
        chain.push(if turned { flip(&next) } else { next });
    }
    if let (Some(first), Some(last)) = (chain.first(), chain.last())
        && ends(first)[0] != ends(last)[1]
    {
        let p = net.points[ends(last)[1] as usize];
        let from_mm = (net.points[ends(first)[0] as usize] - p).norm();
        let at = format!("at x {:.4} y {:.4} z {:.4} mm, {from_mm:.4} mm from its beginning", p.x, p.y, p.z);
        return Err(face_error(face, &format!("has a loop that ends {at}, instead of closing ({})", limit())));
    }
    let mut out = Vec::new();
    for c in &chain {
        let line = &net.lines[c.edge];
        let n = line.ids.len() - 1;
        let seam = seam(c.edge);
        out.extend((0..n).map(|k| {
            let (from, chord) = if c.reversed { (n - k, n - 1 - k) } else { (k, k) };
            RingCorner {
                uv: [0.0; 2],
                id: line.ids[from],
                chord: line.first_chord + chord as u32,
                against: c.reversed,
                seam,
            }
        }));
    }
    Ok(out)
}

impl Projector<'_> {
    fn pole_at(&self, p: &Point) -> Option<&Pole> {
        self.poles.iter().find(|pole| (pole.point - p).norm() <= self.accept_mm)
    }

    /// Parameters of a point of the surface, continuing from those of the point before it.
    fn project(&self, p: &Point, before: Option<[f64; 2]>) -> Result<[f64; 2]> {
        let mut best: Option<SurfaceFoot> = before.map(|uv| self.face.surface.foot(p, uv, &self.space));
        if best.is_none_or(|b| b.distance_mm > self.accept_mm) {
            let anywhere = self.seeds.foot(&self.face.surface, p, &self.space);
            best = [best, anywhere].into_iter().flatten().min_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
        }
        match best {
            Some(foot) if foot.distance_mm <= OFF_SURFACE_MM => {
                let uv = self.space.normal_form(foot.uv);
                Ok(before.map_or(uv, |b| self.space.nearest_copy(uv, b)))
            }
            other => Err(face_error(
                self.face,
                &format!(
                    "has an edge that leaves its surface by {:.4} mm at x {:.4} y {:.4} z {:.4} mm (limit {OFF_SURFACE_MM} mm)",
                    other.map_or(f64::NAN, |f| f.distance_mm),
                    p.x,
                    p.y,
                    p.z
                ),
            )),
        }
    }

    /// Gives the corners their parameters. Also returns how often the loop runs round the surface
    /// along u and v.
    fn carry(
        &self,
        corners: &[RingCorner],
        net: &EdgeNet,
        poles: &mut Vec<(u32, usize)>,
    ) -> Result<(TrimRing, [i64; 2])> {
        let point = |n: &RingCorner| net.points[n.id as usize];
        let start = corners.iter().position(|n| self.pole_at(&point(n)).is_none()).unwrap_or(0);
        let mut nodes: Vec<RingCorner> = Vec::with_capacity(corners.len() + 2);
        let mut after_pole: Vec<(usize, usize)> = Vec::new();
        for k in 0..corners.len() {
            let mut node = corners[(start + k) % corners.len()];
            let p = point(&node);
            let before = nodes.last().map(|n| n.uv);
            if let (Some(pole), Some(before)) = (self.pole_at(&p), before) {
                // Two nodes: one where the loop comes from, one where it goes on to (filled in from
                // the next point).
                node.uv = before;
                node.uv[pole.fixed] = pole.value;
                nodes.push(RingCorner { chord: NO_CHORD, seam: false, ..node });
                nodes.push(node);
                let next = point(&corners[(start + k + 1) % corners.len()]);
                let onward = self.project(&next, None)?;
                let second = nodes.len() - 1;
                nodes[second].uv[1 - pole.fixed] = self.space.nearest_copy(onward, before)[1 - pole.fixed];
                poles.push((node.id, 1 - pole.fixed));
                after_pole.push((second, 1 - pole.fixed));
            } else {
                node.uv = self.project(&p, before)?;
                nodes.push(node);
            }
        }
        let (Some(first), Some(last)) = (nodes.first().copied(), nodes.last().copied()) else {
            return Ok((TrimRing::default(), [0, 0]));
        };
        let closing = self.space.nearest_copy(first.uv, last.uv);
        let mut turns = [0, 1].map(|a| ((closing[a] - first.uv[a]) / self.space.period(a)).round() as i64);
        self.turn_at_poles(&mut nodes, &after_pole, &mut turns);
        Ok((TrimRing { nodes }, turns))
    }

    /// Which way round a pole is free: the way that closes the ring, or for a slit from pole to
    /// pole the full round. `after` holds the second node at each pole and the parameter that is
    /// free there.
    fn turn_at_poles(&self, nodes: &mut [RingCorner], after: &[(usize, usize)], turns: &mut [i64; 2]) {
        let Some(&(last, free)) = after.last() else { return };
        let period = self.space.period(free);
        let shift = -(turns[free] as f64) * period;
        turns[free] = 0;
        nodes[last..].iter_mut().for_each(|n| n.uv[free] += shift);
        let area = TrimRing { nodes: nodes.to_vec() }.signed_area().abs();
        if self.space.closed[free] && area < 1e-6 * self.space.period(0) * self.space.period(1) {
            // Between the two poles, or from the only one to the end.
            let (from, to) = if after.len() > 1 { (after[0].0, last) } else { (last, nodes.len()) };
            nodes[from..to].iter_mut().for_each(|n| n.uv[free] += period);
        }
    }

    /// Joins loops that run round the surface: two of them by a bridge, or one with a pole.
    fn join_wound(
        &self,
        mut wound: Vec<(TrimRing, [i64; 2])>,
        options: &TessellateOptions,
        out: &mut Rings,
    ) -> Result<()> {
        let Some((first, turns)) = wound.pop() else { return Ok(()) };
        let along = usize::from(turns[0] == 0);
        let step = turns[along] as f64 * self.space.period(along);
        let end = RingCorner { chord: NO_CHORD, seam: false, ..first.nodes[0] };
        let shifted = |n: RingCorner, by: f64| {
            let mut n = n;
            n.uv[along] += by;
            n
        };
        let mut nodes = first.nodes.clone();
        match wound.pop() {
            Some((second, other))
                if other[along].abs() == turns[along].abs()
                    && other[1 - along] == 0
                    && turns[1 - along] == 0
                    && wound.is_empty() =>
            {
                // Files do not agree on the sense of loops: the two have to run against one
                // another.
                let second = if other[along] == turns[along] { second.backwards() } else { second };
                let goal = first.nodes[0].uv;
                let away = |n: &RingCorner| (self.space.nearest_copy(n.uv, goal)[along] - goal[along]).abs();
                let k = (0..second.nodes.len())
                    .min_by(|a, b| away(&second.nodes[*a]).total_cmp(&away(&second.nodes[*b])))
                    .unwrap_or(0);
                let there = second.nodes[k].uv;
                let to = self.space.nearest_copy(there, goal);
                // The second ring from its node k once round, beginning opposite the end of the
                // first.
                let m = second.nodes.len();
                let by = to[along] - there[along] + step;
                let mut back: Vec<RingCorner> = (0..m)
                    .map(|j| shifted(second.nodes[(k + j) % m], by + if k + j >= m { -step } else { 0.0 }))
                    .collect();
                back.push(RingCorner { chord: NO_CHORD, seam: false, ..shifted(second.nodes[k], by - step) });
                let bridge = self.bridge(goal, to, options, out);
                nodes.push(shifted(end, step));
                nodes.extend(bridge.iter().map(|n| shifted(*n, step)));
                nodes.extend(back);
                nodes.extend(bridge.iter().rev());
            }
            None => {
                // Face to the left of its loop seen along the outward normal.
                let up = (turns[along] > 0) == (along == 0);
                let wanted = self.space.domain[1 - along][usize::from(up != self.face.reversed)];
                let candidates: Vec<&Pole> = self.poles.iter().filter(|p| p.fixed == 1 - along).collect();
                let pole = candidates.iter().find(|p| p.value == wanted).or(candidates.first()).ok_or_else(|| {
                    face_error(self.face, "has one loop that runs round its closed surface, but no second one")
                })?;
                let id = OWN + out.points.len() as u32;
                out.points.push(pole.point);
                out.poles.push((id, along));
                nodes.push(shifted(end, step));
                for by in [step, 0.0] {
                    let mut node = RingCorner { id, ..shifted(end, by) };
                    node.uv[1 - along] = pole.value;
                    nodes.push(node);
                }
            }
            _ => return Err(face_error(self.face, "has loops round its closed surface that do not pair up")),
        }
        out.rings.push(TrimRing { nodes });
        Ok(())
    }

    /// Inner nodes of a bridge, as many as its deflection needs.
    fn bridge(&self, from: [f64; 2], to: [f64; 2], options: &TessellateOptions, out: &mut Rings) -> Vec<RingCorner> {
        let at = |s: f64| {
            let uv = [0, 1].map(|a| from[a] + s * (to[a] - from[a]));
            let n = self.space.normal_form(uv);
            (uv, self.face.surface.point(n[0], n[1]))
        };
        let mut pieces = 1usize;
        let sag = |n: usize| {
            let one = |k: usize| {
                let [a, m, b] = [0.0, 0.5, 1.0].map(|h| at((k as f64 + h) / n as f64).1);
                (m - nalgebra::center(&a, &b)).norm()
            };
            (0..n).map(one).fold(0.0, f64::max)
        };
        while pieces < 512 && sag(pieces) > 0.25 * options.deflection_mm {
            pieces *= 2;
        }
        (1..pieces)
            .map(|k| {
                let (uv, p) = at(k as f64 / pieces as f64);
                out.points.push(p);
                let id = OWN + out.points.len() as u32 - 1;
                RingCorner { uv, id, chord: NO_CHORD, against: false, seam: false }
            })
            .collect()
    }
}

impl TrimRing {
    /// The same ring walked the other way.
    fn backwards(&self) -> TrimRing {
        let n = self.nodes.len();
        // The side to the next node is now the one to the node before.
        let turned = |k: usize| {
            let (node, side) = (self.nodes[k], self.nodes[(k + n - 1) % n]);
            RingCorner { chord: side.chord, against: !side.against, seam: side.seam, ..node }
        };
        TrimRing { nodes: (0..n).rev().map(turned).collect() }
    }

    /// Whether a place of the parameter plane is within the ring.
    fn holds(&self, [u, v]: [f64; 2]) -> bool {
        let n = self.nodes.len();
        let crosses = |k: &usize| {
            let (a, b) = (self.nodes[*k].uv, self.nodes[(k + 1) % n].uv);
            (a[1] > v) != (b[1] > v) && u < a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
        };
        (0..n).filter(crosses).count() % 2 == 1
    }

    /// Area in the parameter plane, positive counter-clockwise.
    pub fn signed_area(&self) -> f64 {
        let n = self.nodes.len();
        let Some(o) = self.nodes.first().map(|n| n.uv) else { return 0.0 };
        let twice = |k: usize| {
            let (a, b) = (self.nodes[k].uv, self.nodes[(k + 1) % n].uv);
            (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
        };
        0.5 * (0..n).map(twice).sum::<f64>()
    }
}
