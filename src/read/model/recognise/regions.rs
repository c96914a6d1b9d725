//! Where along the blade axis what lies: airfoil, platform, whole part. Works in the blade frame.

use super::Heights;
use super::foot::{Foot, Joint, joint};
use super::run::{HEIGHTS, LOOSENESS, Link, Run};
use super::shape::LoopShape;
use super::stitch::stitched;
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice};

/// A fillet may widen the airfoil's loop by up to this much (area) …
const FILLET_AREA: f64 = 2.2;
/// … and this much (length) before it counts as something else.
const FILLET_LENGTH: f64 = 1.3;
/// A loop smaller than this share (area) of the airfoil's is cut by a slanted or rounded end of the
/// part.
const CUT_SHORT: f64 = 0.8;
/// A loop at the airfoil's place that is larger by this factor, in area or length, is a platform or
/// hub.
const PLATFORM: f64 = 1.2;

/// What bounds the airfoil at one end.
struct AirfoilEnd {
    /// Last height with the airfoil alone, mm.
    x_mm: f64,
    /// Largest loop at the airfoil's place just beyond; `None`: the part (or body) ends.
    beyond: Option<LoopShape>,
    /// The airfoil's loop at `x_mm`.
    shape: LoopShape,
}

/// Finds the regions, and the fillet where it climbs along the foot so that no heights bound it;
/// `run` was found along the blade axis (its heights are blade x).
pub fn find(mesh: &Mesh, bvh: &MeshBvh, run: &Run) -> Option<(Heights, Option<Foot>)> {
    let (first, last) = (run.links.first()?, run.links.last()?);
    let step = (run.part_mm[1] - run.part_mm[0]) / HEIGHTS as f64;
    let root = end(mesh, bvh, first.height_mm, &first.shape, -step, run.part_mm);
    let tip = end(mesh, bvh, last.height_mm, &last.shape, step, run.part_mm);
    let has_platform = root.beyond.is_some_and(|b| {
        b.area_mm2 > PLATFORM * root.shape.area_mm2 || b.perimeter_mm > PLATFORM * root.shape.perimeter_mm
    });
    let platform_x_mm = has_platform.then(|| platform_top(mesh, root.x_mm, step));
    let airfoil_x_mm = [platform_x_mm.map_or(root.x_mm, |p| p.max(root.x_mm)), tip.x_mm];
    let [lo, hi] = run.part_mm;
    let mut reasons = vec![format!("part: x = {lo:.3} to {hi:.3} mm")];
    reasons.push(format!(
        "airfoil: x = {:.3} to {:.3} mm, where sections are one slender loop that changes steadily \
         ({:.1} mm² at x = {:.3}, {:.1} mm² at x = {:.3})",
        airfoil_x_mm[0], airfoil_x_mm[1], first.shape.area_mm2, first.height_mm, last.shape.area_mm2, last.height_mm
    ));
    let change = |e: &AirfoilEnd, b: &LoopShape| {
        format!(
            "x = {:.3} mm, where the section changes from {:.1} mm² ({:.1} mm around) to {:.1} mm² ({:.1} mm around)",
            e.x_mm, e.shape.area_mm2, e.shape.perimeter_mm, b.area_mm2, b.perimeter_mm
        )
    };
    reasons.push(match (platform_x_mm, &root.beyond) {
        (Some(x), Some(b)) => format!("platform: top at x = {x:.3} mm; the airfoil meets it at {}", change(&root, b)),
        (None, Some(_)) => format!(
            "no platform: below x = {:.3} mm sections are cut short by an end of the part that is not flat",
            root.x_mm
        ),
        _ => format!("no platform: at x = {:.3} mm the body ends", root.x_mm),
    });
    reasons.push(match &tip.beyond {
        Some(b) if b.area_mm2 > PLATFORM * tip.shape.area_mm2 => format!("tip: shroud at {}", change(&tip, b)),
        Some(_) => format!(
            "tip: above x = {:.3} mm sections are cut short (slanted or rounded tip, tenon or the like)",
            tip.x_mm
        ),
        None => format!("tip: free, at x = {:.3} mm", tip.x_mm),
    });
    let (mut fillet_x_mm, mut climbing) = (None, None);
    if let Some(platform_mm) = platform_x_mm {
        let (heights, foot, reason) = fillet(mesh, bvh, platform_mm, airfoil_x_mm, first);
        (fillet_x_mm, climbing) = (heights, foot);
        reasons.push(reason);
    }
    Some((Heights { part_x_mm: run.part_mm, airfoil_x_mm, platform_x_mm, fillet_x_mm, reasons }, climbing))
}

/// Heights of the fillet, or the fillet itself where it climbs, and what is to be said of it.
fn fillet(
    mesh: &Mesh,
    bvh: &MeshBvh,
    platform_mm: f64,
    airfoil_mm: [f64; 2],
    first: &Link,
) -> (Option<[f64; 2]>, Option<Foot>, String) {
    let leaning = leaning(mesh, bvh, platform_mm, airfoil_mm, &first.shape);
    let heights = |[foot, top]: [f64; 2]| {
        let reason =
            format!("fillet: x = {foot:.3} to {top:.3} mm, where the airfoil's wall bends towards the platform");
        (Some([foot, top]), None, reason)
    };
    // A foot that climbs is met from higher sections only, where it is high.
    let sections = JUDGED_FROM.map(|share| airfoil_mm[0] + share * (airfoil_mm[1] - airfoil_mm[0]));
    let sections: Vec<(f64, Loop)> =
        sections.iter().filter_map(|x| Some((*x, airfoil_loop(mesh, bvh, *x, &first.shape)?.0))).collect();
    let met = joint(mesh, &sections, platform_mm);
    match (met, leaning) {
        (Joint::Edge, _) => (None, None, "no fillet: the airfoil's wall meets the platform in an edge".into()),
        (_, Some(found)) => heights(found),
        (Joint::Fillet(foot), None) if foot.level() => heights([platform_mm, foot.height_mm(0, 0.95)]),
        (Joint::Fillet(foot), None) => {
            let reason = format!(
                "fillet: radius about {:.1} mm, along a foot that climbs from about x = {:.1} to {:.1} mm",
                foot.radius_mm,
                foot.height_mm(1, 0.02),
                foot.height_mm(1, 0.98)
            );
            (None, Some(foot), reason)
        }
        (Joint::Unsure, None) => {
            (None, None, "no fillet: the airfoil's wall keeps its lean down to the platform".into())
        }
    }
}

/// Follows the airfoil's loop beyond the run in quarter steps and halves the last one.
fn end(mesh: &Mesh, bvh: &MeshBvh, from_mm: f64, reference: &LoopShape, step: f64, part_mm: [f64; 2]) -> AirfoilEnd {
    let (mut good, mut shape) = (from_mm, *reference);
    let mut bad = None;
    let mut part_ends = false;
    // A fillet and what remains of the part lie within; the bound only guards against endless
    // walks.
    for _ in 0..4 * HEIGHTS {
        let x = good + 0.25 * step;
        if x <= part_mm[0] || x >= part_mm[1] {
            bad = Some(x.clamp(part_mm[0], part_mm[1]));
            part_ends = true;
            break;
        }
        match follow(mesh, bvh, x, &shape, reference) {
            Some(next) => (good, shape) = (x, next),
            None => {
                bad = Some(x);
                break;
            }
        }
    }
    let mut bad = bad.unwrap_or(good);
    let outside = bad;
    for _ in 0..20 {
        let x = 0.5 * (good + bad);
        match follow(mesh, bvh, x, &shape, reference) {
            Some(next) => (good, shape) = (x, next),
            None => bad = x,
        }
    }
    // The part's own end is known exactly; sections within rounding of it are noise.
    let last = if step < 0.0 { part_mm[0] } else { part_mm[1] };
    if (good - last).abs() < 1e-3 * step.abs() {
        good = last;
        part_ends = true;
    }
    // What lies beyond shows within one step: a rounded platform does not come at once.
    let beyond = if part_ends {
        None
    } else {
        (0..=4)
            .map(|k| (outside + 0.25 * f64::from(k) * step).clamp(part_mm[0], part_mm[1]))
            .filter_map(|x| surrounding(mesh, bvh, x, &shape))
            .max_by(|a, b| a.area_mm2.total_cmp(&b.area_mm2))
    };
    AirfoilEnd { x_mm: good, beyond, shape }
}

/// The airfoil's loop at a height.
fn airfoil_loop(mesh: &Mesh, bvh: &MeshBvh, x_mm: f64, reference: &LoopShape) -> Option<(Loop, LoopShape)> {
    let near = |l: &(Loop, LoopShape)| {
        let d = [0, 1].map(|k| l.1.centroid[k] - reference.centroid[k]);
        l.1.area_mm2 > 0.3 * reference.area_mm2 && d[0].hypot(d[1]) < 0.5 * reference.perimeter_mm
    };
    let away = |l: &(Loop, LoopShape)| (l.1.area_mm2 - reference.area_mm2).abs();
    stitched(slice(mesh, bvh, x_mm))
        .into_iter()
        .filter_map(|l| LoopShape::new(&l).map(|s| (l, s)))
        .filter(near)
        .min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// Heights over which the wall leans as a fillet does: from the platform up to where its lean is
/// that of the airfoil above.
///
/// The lean is the mean of the normal's component along the axis round the airfoil's loop. On a
/// fillet of radius r it is 1 − h/r at height h, so the top is found a share [`LEAN`] of r too low,
/// which is added.
fn leaning(
    mesh: &Mesh,
    bvh: &MeshBvh,
    platform_mm: f64,
    airfoil_mm: [f64; 2],
    reference: &LoopShape,
) -> Option<[f64; 2]> {
    let length = airfoil_mm[1] - airfoil_mm[0];
    let lean = |x: f64| -> Option<f64> {
        let (l, _) = airfoil_loop(mesh, bvh, x, reference)?;
        let (mut sum, mut all) = (0.0, 0.0);
        for (k, &t) in l.triangles.iter().enumerate() {
            let (p, q) = (l.points[k], l.points[(k + 1) % l.points.len()]);
            let d = (q[0] - p[0]).hypot(q[1] - p[1]);
            sum += d * mesh.normal(t as usize).x;
            all += d;
        }
        (all > 0.0).then(|| sum / all)
    };
    let mut usual: Vec<f64> =
        (0..=12).filter_map(|k| lean(airfoil_mm[0] + (0.4 + 0.4 * f64::from(k) / 12.0) * length)).collect();
    usual.sort_by(f64::total_cmp);
    let usual = *usual.get(usual.len() / 2)?;
    let leans = |x: f64| lean(x).is_some_and(|l| l - usual > LEAN);
    let at = |k: u32| airfoil_mm[0] + length * (1e-3 + 0.4 * f64::from(k) / f64::from(FILLET_HEIGHTS));
    let last = (0..FILLET_HEIGHTS).take_while(|&k| leans(at(k))).last()?;
    let (mut low, mut high) = (at(last), at(last + 1));
    for _ in 0..12 {
        let x = 0.5 * (low + high);
        if leans(x) { low = x } else { high = x }
    }
    let foot = platform_mm.min(airfoil_mm[0]);
    Some([foot, foot + (high - foot) / (1.0 - LEAN)])
}

/// Mean lean (sine) by which a wall is a fillet's and no longer the airfoil's.
const LEAN: f64 = 0.08;
/// The joint with the platform is judged from these shares of the airfoil's height down.
const JUDGED_FROM: [f64; 3] = [0.3, 0.55, 0.8];
/// Heights over the lowest 40 % of the airfoil at which the lean is taken.
const FILLET_HEIGHTS: u32 = 96;

/// The loop at x that continues `before` and has not outgrown `reference`.
fn follow(mesh: &Mesh, bvh: &MeshBvh, x_mm: f64, before: &LoopShape, reference: &LoopShape) -> Option<LoopShape> {
    stitched(slice(mesh, bvh, x_mm))
        .iter()
        .filter_map(LoopShape::new)
        .filter(|s| s.continues(before, LOOSENESS))
        .filter(|s| s.area_mm2 < FILLET_AREA * reference.area_mm2 && s.area_mm2 > CUT_SHORT * reference.area_mm2)
        .find(|s| s.perimeter_mm < FILLET_LENGTH * reference.perimeter_mm)
}

/// The largest loop whose box meets the box of the airfoil's loop.
fn surrounding(mesh: &Mesh, bvh: &MeshBvh, x_mm: f64, airfoil: &LoopShape) -> Option<LoopShape> {
    let b = airfoil.bounds;
    stitched(slice(mesh, bvh, x_mm))
        .iter()
        .filter_map(LoopShape::new)
        .filter(|s| s.bounds[0] < b[2] && s.bounds[2] > b[0] && s.bounds[1] < b[3] && s.bounds[3] > b[1])
        .max_by(|a, b| a.area_mm2.total_cmp(&b.area_mm2))
}

/// Top of the platform: the height at which most surface near `x_mm` faces the tip, or `x_mm` where
/// none does.
///
/// A fillet hides the platform from sections until its very foot; the platform's own triangles show
/// it exactly.
fn platform_top(mesh: &Mesh, x_mm: f64, step: f64) -> f64 {
    let (lo, hi) = (x_mm - 0.5 * step, x_mm + 1e-6 * step);
    let mut facing: Vec<(f64, f64)> = (0..mesh.triangles.len())
        .filter_map(|t| {
            let [a, b, c] = mesh.corners(t);
            let x = (a.x + b.x + c.x) / 3.0;
            let n = (b - a).cross(&(c - a));
            (x > lo && x < hi && n.x > 0.999 * n.norm()).then_some((x, 0.5 * n.x))
        })
        .collect();
    facing.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = facing.iter().map(|f| f.1).sum();
    let mut sum = 0.0;
    facing
        .iter()
        .find(|f| {
            sum += f.1;
            sum > 0.5 * total
        })
        .map_or(x_mm, |f| f.0)
}
