//! Where to start: a ball that touches the airfoil, and a check that the first ring goes round the airfoil only.

use super::level::{LevelSet, Touch};
use super::ring::Ring;
use crate::artifact::Blade;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::slice::{Loop, slice};

/// The section loop that is the airfoil: the closed loop round the blade axis, else the nearest to it.
pub fn airfoil_loop(blade: &Blade, x_mm: f64) -> Result<(Loop, Vec<Loop>)> {
    let mut loops: Vec<Loop> =
        slice(&blade.part.mesh, &blade.part.bvh, x_mm).into_iter().filter(|l| l.closed && l.points.len() > 2).collect();
    let nearest = (0..loops.len()).min_by(|a, b| distance_to_axis(&loops[*a]).total_cmp(&distance_to_axis(&loops[*b])));
    match nearest {
        Some(i) => {
            let airfoil = loops.swap_remove(i);
            Ok((airfoil, loops))
        }
        None => Err(Error::usage(
            Stage::Path,
            format!(
                "the region begins at height {x_mm:.3} mm, where the section of the part has no closed loop; the part spans {:.3} to {:.3} mm along the blade axis",
                blade.regions.part_x_mm[0], blade.regions.part_x_mm[1]
            ),
        )
        .advise("choose [region] heights inside the part")),
    }
}

/// Distance of a loop from the blade axis, mm; 0 where the axis passes through it.
fn distance_to_axis(l: &Loop) -> f64 {
    let n = l.points.len();
    let mut winding = 0.0;
    let mut least = f64::INFINITY;
    for i in 0..n {
        let (a, b) = (l.points[i], l.points[(i + 1) % n]);
        least = least.min(distance_to_segment([0.0, 0.0], a, b));
        winding += super::ring::wrap(b[1].atan2(b[0]) - a[1].atan2(a[0]));
    }
    if winding.abs() > 3.0 { 0.0 } else { least }
}

/// Distance from `q` to the segment `a b` in the plane, mm.
fn distance_to_segment(q: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let f = (((q[0] - a[0]) * dx + (q[1] - a[1]) * dy) / (dx * dx + dy * dy).max(1e-300)).clamp(0.0, 1.0);
    (q[0] - a[0] - f * dx).hypot(q[1] - a[1] - f * dy)
}

/// Distance from `q` to a closed loop in the plane, mm.
fn distance_to_loop(q: [f64; 2], l: &Loop) -> f64 {
    let n = l.points.len();
    (0..n).map(|i| distance_to_segment(q, l.points[i], l.points[(i + 1) % n])).fold(f64::INFINITY, f64::min)
}

/// A ball in the plane `x_mm` that touches the airfoil, found by stepping outwards from the loop's extreme points.
pub fn first_touch(level: &LevelSet, airfoil: &Loop, x_mm: f64) -> Option<Touch> {
    let r = level.radius_mm;
    for k in 0..16 {
        let (s, c) = (k as f64 * std::f64::consts::TAU / 16.0).sin_cos();
        // The extreme point in a direction is on the loop's hull: nothing of the airfoil lies in front of it.
        let p = airfoil.points.iter().max_by(|a, b| (a[0] * c + a[1] * s).total_cmp(&(b[0] * c + b[1] * s)))?;
        let guess = Point::new(x_mm, p[0] + r * c, p[1] + r * s);
        if let Some(t) = level.touch_in_plane(&guess, 0.5 * r) {
            let lean = t.normal.x.abs() / t.cos_lean().max(1e-9);
            let allowance = 0.05 * r + level.part.stock_mm + lean * (t.contact.x - x_mm).abs() * 2.0;
            if distance_to_loop([t.contact.y, t.contact.z], airfoil) <= allowance {
                return Some(t);
            }
        }
    }
    None
}

/// The first contact of the ring that lies nearer to another loop of the section than to the airfoil's.
pub fn touches_another_body(ring: &Ring, airfoil: &Loop, others: &[Loop]) -> Option<Point> {
    if others.is_empty() {
        return None;
    }
    ring.touches.iter().map(|t| t.contact).find(|p| {
        let q = [p.y, p.z];
        let own = distance_to_loop(q, airfoil);
        others.iter().any(|l| distance_to_loop(q, l) < own)
    })
}
