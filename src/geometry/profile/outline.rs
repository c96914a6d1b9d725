//! The closed loops of a section, as exact as the part is.

use crate::geometry::measured::Closest;
use crate::geometry::part::Part;
use crate::geometry::slice::{Loop, slice};
use crate::geometry::{Point, Vector};

/// Points that a loop of an exact part gets at least.
pub const POINTS: f64 = 400.0;
/// A point counts as on the exact surface below this, mm.
pub const ON_SURFACE_MM: f64 = 1e-8;
/// Newton's steps; smooth places need three.
const MOST_STEPS: usize = 12;
/// A turn between neighbouring points by more than this, besides what curvature explains, is a
/// crease, rad.
const CREASE_RAD: f64 = 0.02;
/// Points on each side of a crease whose curvature is taken from the fit.
const BESIDE_CREASE: usize = 3;

/// A closed loop of a section.
pub struct Outline {
    /// (y, z), counter-clockwise.
    pub points: Vec<[f64; 2]>,
    /// What the exact faces say at each point, where they do.
    pub exact: Vec<Option<OnFace>>,
    /// Greatest distance of a point from the part, mm.
    pub off_part_mm: f64,
}

/// What a section's curve is at a point inside a face.
#[derive(Clone, Copy, Debug)]
pub struct OnFace {
    /// Curvature of the section, positive where convex, 1/mm.
    pub curvature: f64,
    /// Outward unit normal of the section.
    pub normal: [f64; 2],
}

impl Outline {
    /// A polygon of which nothing more is known.
    pub fn polygon(points: Vec<[f64; 2]>) -> Self {
        Outline { exact: vec![None; points.len()], points, off_part_mm: 0.0 }
    }
}

/// What a plane cuts out of a part.
pub struct Outlines {
    /// Outer loops, the largest first, counter-clockwise.
    pub loops: Vec<Outline>,
    /// Holes and open chains besides.
    pub dropped: usize,
    /// Widest gap in `loops` over which a straight line was drawn, mm.
    pub bridged_mm: f64,
    /// Widest gap that is too wide for that, mm.
    pub open_mm: f64,
}

/// Gaps up to this share of the length of all open chains are bridged.
const BRIDGED: f64 = 1e-3;

/// Outer loops at a height.
pub fn outlines(part: &Part, x_mm: f64) -> Outlines {
    let (closed, open): (Vec<Loop>, Vec<Loop>) = slice(&part.mesh, &part.bvh, x_mm).into_iter().partition(|l| l.closed);
    let bridged = bridged(open);
    let all = closed.len() + bridged.loops.len() + bridged.left;
    let outer = closed.into_iter().chain(bridged.loops).filter(|l| l.points.len() >= 3 && l.area_mm2() > 0.0);
    let mut outer: Vec<(f64, Vec<[f64; 2]>)> = outer.map(|l| (l.area_mm2(), l.points)).collect();
    outer.sort_by(|a, b| b.0.total_cmp(&a.0));
    let dropped = all - outer.len();
    let exact = part.brep.is_some();
    let loops =
        outer.into_iter().map(|(_, p)| if exact { refined(part, x_mm, &p) } else { distinct(Outline::polygon(p)) });
    let loops = loops.filter(|o| o.points.len() >= 3).collect();
    Outlines { loops, dropped, bridged_mm: bridged.widest_mm, open_mm: bridged.open_mm }
}

/// Open chains joined to loops.
#[derive(Default)]
struct Bridged {
    loops: Vec<Loop>,
    /// Chains that do not close.
    left: usize,
    widest_mm: f64,
    open_mm: f64,
}

/// Joins the end of each chain to the nearest beginning, where that is near; all chains have the
/// material on their left.
fn bridged(mut open: Vec<Loop>) -> Bridged {
    let most_mm = BRIDGED * open.iter().map(Loop::length_mm).sum::<f64>();
    let mut out = Bridged::default();
    while let Some(mut chain) = open.pop() {
        let mut widest_mm = 0.0_f64;
        while let (Some(&start), Some(&end)) = (chain.points.first(), chain.points.last()) {
            let begin = |l: &Loop| l.points.first().map_or(f64::INFINITY, |p| distance(end, *p));
            let other = (0..open.len()).min_by(|a, b| begin(&open[*a]).total_cmp(&begin(&open[*b])));
            let next = other.filter(|k| begin(&open[*k]) < distance(end, start));
            let gap_mm = next.map_or(distance(end, start), |k| begin(&open[k]));
            widest_mm = widest_mm.max(gap_mm);
            if gap_mm > most_mm {
                break;
            }
            match next {
                Some(k) => chain.points.extend(open.swap_remove(k).points),
                None => {
                    chain.closed = true;
                    break;
                }
            }
        }
        if chain.closed {
            out.widest_mm = out.widest_mm.max(widest_mm);
            out.loops.push(chain);
        } else {
            out.open_mm = out.open_mm.max(widest_mm);
            out.left += 1;
        }
    }
    out
}

/// Denser, every point moved onto the exact part within the plane.
fn refined(part: &Part, x_mm: f64, points: &[[f64; 2]]) -> Outline {
    let step = arc_length(points).1 / POINTS;
    let mut out = Outline::polygon(Vec::with_capacity(points.len() + POINTS as usize));
    for (i, &a) in points.iter().enumerate() {
        let b = points[(i + 1) % points.len()];
        let parts = (distance(a, b) / step).ceil().clamp(1.0, POINTS) as usize;
        for k in 0..parts {
            let f = k as f64 / parts as f64;
            let placed = on_part(part, x_mm, [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])]);
            out.points.push(placed.at);
            out.exact.push(placed.exact);
            out.off_part_mm = out.off_part_mm.max(placed.off_mm);
        }
    }
    let mut out = distinct(out);
    forget_creases(&mut out);
    out
}

/// A point of a section of exact faces.
pub struct PlacedPoint {
    /// (y, z), mm.
    pub at: [f64; 2],
    /// What the face says there, inside one.
    pub exact: Option<OnFace>,
    /// Distance from the part, mm.
    pub off_mm: f64,
}

/// Newton's method within the section's plane for the point where the surface meets it,
/// `S(u, v) · e_x = x`: each step goes to the tangent plane of the closest point. Keeps the guess
/// where that leads away (walls along the plane).
pub fn on_part(part: &Part, x_mm: f64, guess: [f64; 2]) -> PlacedPoint {
    let cap = 10.0 * part.deflection_mm + 1e-3;
    let stays = || {
        let foot = part.closest(&Point::new(x_mm, guess[0], guess[1]), f64::INFINITY);
        PlacedPoint { at: guess, exact: None, off_mm: foot.map_or(f64::MAX, |f| f.distance_mm) }
    };
    let mut q = Point::new(x_mm, guess[0], guess[1]);
    for _ in 0..MOST_STEPS {
        let Some(foot) = part.closest(&q, 2.0 * cap) else { return stays() };
        let across = foot.normal.y * foot.normal.y + foot.normal.z * foot.normal.z;
        if across < 1e-4 {
            return stays();
        }
        if foot.distance_mm < ON_SURFACE_MM {
            return PlacedPoint { at: [q.y, q.z], exact: on_face(part, &foot), off_mm: foot.distance_mm };
        }
        let off = (foot.point - q).dot(&foot.normal);
        q += Vector::new(0.0, foot.normal.y, foot.normal.z) * (off / across);
        if distance([q.y, q.z], guess) > cap / across.sqrt() {
            return stays();
        }
    }
    stays()
}

/// Curvature of the plane section of the face at a point of it: the normal curvature along the
/// section, over the cosine between the surface's normal and the plane (Meusnier; do Carmo,
/// *Differential
/// Geometry of Curves and Surfaces*, 3-2).
fn on_face(part: &Part, foot: &Closest) -> Option<OnFace> {
    let bend = part.curvature_at(foot)?;
    let n = foot.normal;
    let across = n.y.hypot(n.z);
    let along = Vector::x().cross(&n) / across;
    let [a, b] = bend.direction.map(|d| d.dot(&along));
    let normal_curvature = bend.curvature[0] * a * a + bend.curvature[1] * b * b;
    Some(OnFace { curvature: -normal_curvature / across, normal: [n.y / across, n.z / across] })
}

/// Where the section turns more than its faces' curvature says there is a crease, whose curvature
/// no face knows: about it the fit to the points counts.
fn forget_creases(o: &mut Outline) {
    let n = o.points.len();
    let crease = |i: usize| {
        let j = (i + 1) % n;
        let (Some(a), Some(b)) = (o.exact[i], o.exact[j]) else { return true };
        let step = distance(o.points[i], o.points[j]);
        let turn = (a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0])
            .atan2(a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1]);
        turn.abs() > CREASE_RAD + 3.0 * step * a.curvature.abs().max(b.curvature.abs())
    };
    let found: Vec<usize> = (0..n).filter(|i| crease(*i)).collect();
    for i in found {
        for k in 0..2 * BESIDE_CREASE {
            o.exact[(i + n + 1 + k - BESIDE_CREASE) % n] = None;
        }
    }
}

/// Without points that (nearly) repeat the one before them: they carry no information and spoil
/// differences.
fn distinct(o: Outline) -> Outline {
    let least = 1e-6 * arc_length(&o.points).1;
    let mut out = Outline { off_part_mm: o.off_part_mm, ..Outline::polygon(Vec::with_capacity(o.points.len())) };
    for (p, exact) in o.points.into_iter().zip(o.exact) {
        if out.points.last().is_none_or(|&q| distance(p, q) > least) {
            out.points.push(p);
            out.exact.push(exact);
        }
    }
    while let (true, Some(&a), Some(&b)) = (out.points.len() > 1, out.points.first(), out.points.last()) {
        if distance(a, b) > least {
            break;
        }
        out.points.pop();
        out.exact.pop();
    }
    out
}

/// Distance between two points, mm.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Arc length at each point of a closed polygon, and its perimeter.
pub fn arc_length(points: &[[f64; 2]]) -> (Vec<f64>, f64) {
    let mut s = 0.0;
    let mut out = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        out.push(s);
        s += distance(p, points[(i + 1) % points.len()]);
    }
    (out, s)
}

/// Signed area of a closed polygon.
pub fn area(points: &[[f64; 2]]) -> f64 {
    let Some(&o) = points.first() else { return 0.0 };
    let cross = |a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    0.5 * points.windows(2).map(|w| cross(w[0], w[1])).sum::<f64>()
}
