//! Whether a foot lies inside its face's loops.
//!
//! Each piece of a face that loops may cross knows the sides near it and, for a point of its own,
//! whether that is inside; any other point of the piece is inside if the way there crosses an even
//! number of sides. Near a side the exact edge curve decides: on which side of its tangent the foot
//! lies.

use super::leaf::{FaceForm, Rect};
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Edge};
use crate::geometry::nurbs::SurfaceDerivatives;
use crate::geometry::nurbs::foot::CurveFoot;
use crate::geometry::tessellate::loops::TrimRing;
use crate::geometry::tessellate::{Chord, NO_CHORD, Trim};

/// Feet this far beyond an edge still count, mm: smooth joints then have no crack.
pub(super) const BEYOND_EDGE_MM: f64 = 1e-4;

/// A place this near to a seam, as a share of the period, is on it.
const ON_SEAM: f64 = 1e-9;

/// The edges of a part, and the chords that they were cut into.
#[derive(Clone, Copy)]
pub(super) struct EdgeChords<'a> {
    pub brep: &'a Brep,
    pub chords: &'a [Chord],
}

impl EdgeChords<'_> {
    /// The edge of a chord and the foot on it, looked for from the chord's middle.
    fn foot(&self, chord: u32, p: &Point) -> Option<(&Edge, CurveFoot)> {
        let chord = self.chords.get(chord as usize)?;
        let edge = &self.brep.edges[chord.edge as usize];
        Some((edge, edge.curve.foot(p, 0.5 * (chord.t[0] + chord.t[1]), edge.t)))
    }
}

/// A side of a ring: (ring, node at which it begins).
pub(super) type RingSide = [u32; 2];

/// A face's trimming, ready for tests.
#[derive(Clone, Debug)]
pub(super) struct TrimTest {
    pub trim: Trim,
    bounds: [[f64; 2]; 2],
    /// Per ring: the face lies to the left of its sides in the parameter plane.
    left: Vec<bool>,
    /// All sides.
    all: Vec<RingSide>,
}

/// The sides that matter in one piece, for one copy of it along the face's closed directions.
#[derive(Clone, Debug)]
pub(super) struct Border {
    /// Added to parameters of the piece to reach this copy.
    shift: [f64; 2],
    /// A point of the copy, and whether it is inside.
    known: ([f64; 2], bool),
    sides: Vec<RingSide>,
}

impl Border {
    /// How many sides.
    pub fn count(&self) -> usize {
        self.sides.len()
    }
}

/// What a piece of the parameter plane is to its face.
pub(super) enum TrimKind {
    Inside,
    Outside,
    Crossed(Vec<Border>),
}

impl TrimTest {
    pub fn new(trim: Trim) -> Self {
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
        let of =
            |(r, ring): (usize, &TrimRing)| (0..ring.nodes.len()).map(|k| [r as u32, k as u32]).collect::<Vec<_>>();
        let all = trim.rings.iter().enumerate().flat_map(of).collect();
        TrimTest { trim, bounds, left, all }
    }

    /// Whether the face lies to the left of a ring, seen against `S_u × S_v`.
    pub fn is_left(&self, ring: usize) -> bool {
        self.left.get(ring).copied().unwrap_or(true)
    }

    fn ends(&self, [r, k]: RingSide) -> [[f64; 2]; 2] {
        let nodes = &self.trim.rings[r as usize].nodes;
        [nodes[k as usize].uv, nodes[(k as usize + 1) % nodes.len()].uv]
    }

    /// A side that bounds the face: no seam, no bridge.
    fn bounds_face(&self, [r, k]: RingSide) -> bool {
        let node = &self.trim.rings[r as usize].nodes[k as usize];
        node.chord != NO_CHORD && !node.seam
    }

    /// Points of the part: one on each edge near these borders.
    pub fn points_beside(&self, brep: &Brep, chords: &[Chord], borders: &[Border]) -> Vec<Point> {
        let point = |[r, k]: &RingSide| {
            let chord = chords.get(self.trim.rings[*r as usize].nodes[*k as usize].chord as usize)?;
            Some(brep.edges[chord.edge as usize].curve.point(0.5 * (chord.t[0] + chord.t[1])))
        };
        let sides = borders.iter().flat_map(|b| &b.sides).filter(|s| self.bounds_face(**s));
        sides.filter_map(point).collect()
    }

    /// Feet nearer than this to a side are decided by the exact edge, mm.
    pub fn limit_mm(&self) -> f64 {
        2.0 * self.trim.blur_mm + BEYOND_EDGE_MM
    }

    /// Which copies of a range along a closed direction may meet the loops.
    fn copies(&self, along: usize, [from, to]: [f64; 2]) -> std::ops::RangeInclusive<i64> {
        if !self.trim.space.closed[along] {
            return 0..=0;
        }
        let period = self.trim.space.period(along);
        let [low, high] = self.bounds[along];
        (((low - to) / period - 1e-9).ceil() as i64)..=(((high - from) / period + 1e-9).floor() as i64)
    }

    /// What a rectangle is, given the sides that may matter in it (those of a rectangle around it;
    /// `None`: all).
    pub fn kind(&self, shape: &FaceForm, rect: &Rect, around: Option<&[Border]>) -> TrimKind {
        let low = shape.uv(rect.span, [rect.range[0][0], rect.range[1][0]]);
        let high = shape.uv(rect.span, [rect.range[0][1], rect.range[1][1]]);
        let margin = self.margins(shape, rect, [high[0] - low[0], high[1] - low[1]]);
        let mut crossed = Vec::new();
        let mut inside = false;
        let mut one = |shift: [f64; 2], before: Option<&Border>| {
            let box_ = [0, 1].map(|a| [low[a] + shift[a], high[a] + shift[a]]);
            let wide = [0, 1].map(|a| [box_[a][0] - margin[a], box_[a][1] + margin[a]]);
            // Not the middle itself, through which sides like to run.
            let middle = [0, 1].map(|a| box_[a][0] + [0.487_137, 0.513_811][a] * (box_[a][1] - box_[a][0]));
            let near = |sides: &[RingSide]| sides.iter().copied().filter(|s| meets(self.ends(*s), wide)).collect();
            let sides: Vec<RingSide> = before.map_or_else(|| near(&self.all), |b| near(&b.sides));
            let known = before.map_or_else(|| self.by_ray(middle), |b| self.by_way(b, middle));
            if sides.iter().any(|s| self.bounds_face(*s)) {
                crossed.push(Border { shift, known: (middle, known), sides });
            } else {
                inside |= known;
            }
        };
        match around {
            Some(list) => list.iter().for_each(|b| one(b.shift, Some(b))),
            None => {
                let copies = [0, 1].map(|a| self.copies(a, [low[a] - margin[a], high[a] + margin[a]]));
                for i in copies[0].clone() {
                    for j in copies[1].clone() {
                        one([0, 1].map(|a| [i, j][a] as f64 * self.trim.space.period(a)), None);
                    }
                }
            }
        }
        match (inside, crossed.is_empty()) {
            (true, _) => TrimKind::Inside,
            (false, true) => TrimKind::Outside,
            (false, false) => TrimKind::Crossed(crossed),
        }
    }

    /// How far, in parameters, a side may be from a rectangle and yet matter in it.
    fn margins(&self, shape: &FaceForm, rect: &Rect, size: [f64; 2]) -> [f64; 2] {
        let mut least = [f64::INFINITY; 2];
        for st in rect.places() {
            let d = shape.local(rect.span, st);
            // Heights of the parallelogram of the derivatives: distance between lines of one
            // parameter.
            let area = d.du.cross(&d.dv).norm();
            let length = [d.du.norm(), d.dv.norm()];
            for along in 0..2 {
                // Where the other parameter moves nothing (a pole), the length itself.
                let (own, other) = (length[along], length[1 - along]);
                let h = if other > 1e-9 * own { area / other } else { own };
                least[along] = least[along].min(h);
            }
        }
        [0, 1].map(|a| {
            let per_mm = shape.frame(a, rect.span[a])[1] / least[a];
            let wanted = 1.5 * self.limit_mm() * per_mm + 1e-3 * size[a];
            if wanted.is_finite() { wanted.min(self.trim.space.period(a)) } else { self.trim.space.period(a) }
        })
    }

    /// Inside by all sides.
    fn by_ray(&self, uv: [f64; 2]) -> bool {
        self.trim.rings.iter().map(|r| crossings(r, uv)).sum::<usize>() % 2 == 1
    }

    /// Inside by the sides crossed on the way from a point where that is known.
    fn by_way(&self, border: &Border, uv: [f64; 2]) -> bool {
        let (from, inside) = border.known;
        let crossed = border.sides.iter().filter(|s| crosses_way(self.ends(**s), from, uv)).count();
        inside != (crossed % 2 == 1)
    }

    /// Whether a foot in a piece with these borders is inside; `uv` the face's own parameters.
    pub fn holds(&self, edges: EdgeChords, borders: &[Border], uv: [f64; 2], at: &SurfaceDerivatives) -> bool {
        borders.iter().any(|border| {
            let uv = [0, 1].map(|a| uv[a] + border.shift[a]);
            let metric = [at.du.norm_squared(), at.du.dot(&at.dv), at.dv.norm_squared()];
            let mut nearest: Option<(f64, RingSide)> = None;
            for side in border.sides.iter().filter(|s| self.bounds_face(**s)) {
                let [a, b] = self.ends(*side);
                let d2 = side_distance2(a, b, uv, metric);
                if d2 <= self.limit_mm() * self.limit_mm() && nearest.is_none_or(|n| d2 < n.0) {
                    nearest = Some((d2, *side));
                }
            }
            let inside = self.by_way(border, uv) || self.on_seam(border, uv);
            nearest.map_or(inside, |(_, side)| self.beside_edge(edges, side, at, inside))
        })
    }

    /// Whether places next to one along a closed direction are inside. Sides on a seam bound
    /// nothing, but of a place on them parity says what rounding makes of it.
    fn on_seam(&self, border: &Border, uv: [f64; 2]) -> bool {
        (0..2).filter(|a| self.trim.space.closed[*a]).any(|a| {
            let by = ON_SEAM * self.trim.space.period(a);
            [-by, by].into_iter().any(|d| {
                let mut beside = uv;
                beside[a] += d;
                self.by_way(border, beside)
            })
        })
    }

    /// For a middle that is not held: whether no edge comes as near to it as `radius_mm`, so that
    /// all within that lies beyond the loops.
    pub fn is_beyond(
        &self,
        edges: EdgeChords,
        borders: &[Border],
        uv: [f64; 2],
        at: &SurfaceDerivatives,
        radius_mm: f64,
    ) -> bool {
        let metric = [at.du.norm_squared(), at.du.dot(&at.dv), at.dv.norm_squared()];
        // Lengths along the surface to first order, and sides that are off their edges.
        let reach = 1.5 * radius_mm + self.limit_mm();
        borders.iter().all(|border| {
            let uv = [0, 1].map(|a| uv[a] + border.shift[a]);
            border.sides.iter().filter(|s| self.bounds_face(**s)).all(|side| {
                let [a, b] = self.ends(*side);
                if side_distance2(a, b, uv, metric) > reach * reach {
                    return true;
                }
                let node = &self.trim.rings[side[0] as usize].nodes[side[1] as usize];
                let Some((_, on)) = edges.foot(node.chord, &at.p) else { return false };
                (on.point - at.p).norm() > radius_mm + BEYOND_EDGE_MM
            })
        })
    }

    /// Decides by the exact edge curve on which side of it the foot lies.
    fn beside_edge(&self, edges: EdgeChords, side: RingSide, at: &SurfaceDerivatives, inside: bool) -> bool {
        let node = &self.trim.rings[side[0] as usize].nodes[side[1] as usize];
        let Some((edge, on)) = edges.foot(node.chord, &at.p) else { return inside };
        let aside = at.p - on.point;
        if aside.norm() <= BEYOND_EDGE_MM {
            return true;
        }
        let tangent = if node.against { -on.tangent } else { on.tangent };
        // To the left of the ring seen against S_u × S_v, as in the parameter plane.
        let Some(left) = at.du.cross(&at.dv).cross(&tangent).try_normalize(0.0) else { return inside };
        let across = aside.dot(&left);
        if (on.t <= edge.t[0] || on.t >= edge.t[1]) && across.abs() < 0.5 * aside.norm() {
            // Beyond a corner the tangent of one edge says nothing; the polygon is exact at its
            // corners.
            return inside;
        }
        let inwards = if self.left[side[0] as usize] { across } else { -across };
        inwards >= -BEYOND_EDGE_MM
    }
}

/// Whether the side `a b` crosses the ray from `p` towards greater u.
fn crosses(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> bool {
    (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
}

fn crossings(ring: &TrimRing, p: [f64; 2]) -> usize {
    let n = ring.nodes.len();
    (0..n).filter(|k| crosses(ring.nodes[*k].uv, ring.nodes[(k + 1) % n].uv, p)).count()
}

/// Twice the area of the triangle, positive counter-clockwise.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the side crosses the way from `p` to `q`. A node on the way counts as left of it, so
/// that a crossing at a node counts once; an end of the way on the side counts as to its right seen
/// upwards, as in [`crosses`].
fn crosses_way([a, b]: [[f64; 2]; 2], p: [f64; 2], q: [f64; 2]) -> bool {
    let [a, b] = if (b[1], -b[0]) > (a[1], -a[0]) { [a, b] } else { [b, a] };
    (turn(p, q, a) > 0.0) != (turn(p, q, b) > 0.0) && (turn(a, b, p) > 0.0) != (turn(a, b, q) > 0.0)
}

/// Whether the segment meets the box (by separating axes).
fn meets([a, b]: [[f64; 2]; 2], range: [[f64; 2]; 2]) -> bool {
    for k in 0..2 {
        if a[k].max(b[k]) < range[k][0] || a[k].min(b[k]) > range[k][1] {
            return false;
        }
    }
    let corners = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]: [usize; 2]| turn(a, b, [range[0][i], range[1][j]]));
    corners.iter().any(|t| *t >= 0.0) && corners.iter().any(|t| *t <= 0.0)
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
