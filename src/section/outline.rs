//! The closed loops of a section, as exact as the part is.

use crate::geometry::part::Part;
use crate::geometry::slice::slice;
use crate::geometry::{Point, Vector};

/// Points that a loop of an exact part gets at least.
const POINTS: f64 = 400.0;
/// A point counts as on the exact surface below this, mm.
const ON_SURFACE_MM: f64 = 1e-8;

/// Outer loops at a height, the largest first, counter-clockwise; and how many holes and open chains there are besides.
pub(super) fn outlines(part: &Part, x_mm: f64) -> (Vec<Vec<[f64; 2]>>, usize) {
    let loops = slice(&part.mesh, &part.bvh, x_mm);
    let all = loops.len();
    let mut outer: Vec<(f64, Vec<[f64; 2]>)> = loops
        .into_iter()
        .filter(|l| l.closed && l.points.len() >= 3 && l.area_mm2() > 0.0)
        .map(|l| (l.area_mm2(), l.points))
        .collect();
    outer.sort_by(|a, b| b.0.total_cmp(&a.0));
    let dropped = all - outer.len();
    let exact = part.brep.is_some();
    let loops = outer.into_iter().map(|(_, p)| if exact { refined(part, x_mm, &p) } else { p });
    (loops.map(distinct).filter(|p| p.len() >= 3).collect(), dropped)
}

/// Denser, every point moved onto the exact part within the plane.
fn refined(part: &Part, x_mm: f64, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let step = arc_length(points).1 / POINTS;
    let mut out = Vec::with_capacity(points.len() + POINTS as usize);
    for (i, &a) in points.iter().enumerate() {
        let b = points[(i + 1) % points.len()];
        let parts = (distance(a, b) / step).ceil().clamp(1.0, POINTS) as usize;
        for k in 0..parts {
            let f = k as f64 / parts as f64;
            out.push(on_part(part, x_mm, [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])]));
        }
    }
    out
}

/// Newton's method on the distance to the foot's tangent plane, within the section's plane. Keeps the guess where that leads
/// away (walls along the plane).
fn on_part(part: &Part, x_mm: f64, guess: [f64; 2]) -> [f64; 2] {
    let cap = 10.0 * part.deflection_mm + 1e-3;
    let mut q = Point::new(x_mm, guess[0], guess[1]);
    for _ in 0..8 {
        let Some(foot) = part.closest(&q, 2.0 * cap) else { return guess };
        let off = (foot.point - q).dot(&foot.normal);
        let across = foot.normal.y * foot.normal.y + foot.normal.z * foot.normal.z;
        if across < 1e-4 {
            return guess;
        }
        q += Vector::new(0.0, foot.normal.y, foot.normal.z) * (off / across);
        if distance([q.y, q.z], guess) > cap / across.sqrt() {
            return guess;
        }
        if off.abs() < ON_SURFACE_MM {
            break;
        }
    }
    [q.y, q.z]
}

/// Without points that (nearly) repeat the one before them: they carry no information and spoil differences.
fn distinct(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let least = 1e-6 * arc_length(&points).1;
    let mut out: Vec<[f64; 2]> = Vec::with_capacity(points.len());
    for p in points {
        if out.last().is_none_or(|&q| distance(p, q) > least) {
            out.push(p);
        }
    }
    while let (true, Some(&a), Some(&b)) = (out.len() > 1, out.first(), out.last()) {
        if distance(a, b) > least {
            break;
        }
        out.pop();
    }
    out
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Arc length at each point of a closed polygon, and its perimeter.
pub(super) fn arc_length(points: &[[f64; 2]]) -> (Vec<f64>, f64) {
    let mut s = 0.0;
    let mut out = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        out.push(s);
        s += distance(p, points[(i + 1) % points.len()]);
    }
    (out, s)
}

/// Signed area of a closed polygon.
pub(super) fn area(points: &[[f64; 2]]) -> f64 {
    let Some(&o) = points.first() else { return 0.0 };
    let cross = |a: [f64; 2], b: [f64; 2]| (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    0.5 * points.windows(2).map(|w| cross(w[0], w[1])).sum::<f64>()
}
