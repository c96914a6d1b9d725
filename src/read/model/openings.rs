//! Whether the openings of a part matter for the tool.
//!
//! In: a blade whose mesh may be open, the tool, and the heights of the ball centre. The rule: the
//! ball centre moves between two heights along the blade axis; with B fixed and any θ, the tool
//! with its holder then fills a band of heights, widened by the clearances ([`ToolReach`]). An
//! opening
//!
//! * none of whose heights lies in the band cannot be met by any part of the tool: a warning;
//! * in the band, but so narrow that the ball on it sinks by less than [`SINK_MM`] (w² / 8R for the
//!   width w), does not show: a warning;
//! * else an error that says where.
//!
//! Nothing is said of what an opening hides: surface that is missing far from the tool is missing
//! for the clearance checks too.

use crate::artifact::blade::Blade;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::boundary::openings;
use crate::observe::Doubt;
use crate::tool::Tool;

/// A ball that sinks into an opening by less than this goes on as if it were closed, mm: half the
/// usual chord tolerance.
const SINK_MM: f64 = 0.0005;

/// Heights that any part of the tool can take, whatever θ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolReach {
    /// Least and greatest height in the blade frame, mm.
    pub x_mm: [f64; 2],
    /// Ball radius, mm.
    pub radius_mm: f64,
}

impl ToolReach {
    /// For ball centres between two heights, a fixed B and a clearance around everything.
    pub fn new(tool: &Tool, centres_x_mm: [f64; 2], b_rad: f64, clearance_mm: f64) -> ToolReach {
        let r = tool.radius_mm;
        let (sin, cos) = (b_rad.sin(), b_rad.cos().abs());
        // A circle of radius r about the axis at height z over the centre spans z sin B ± r cos B;
        // the ball spans ± R.
        let spans = tool.segments().into_iter().flat_map(|s| [(s.z0, s.r0), (s.z1, s.r1)]);
        let (lo, hi) = spans.fold((-r, r), |(lo, hi), (z, r)| (lo.min(z * sin - r * cos), hi.max(z * sin + r * cos)));
        let [a, b] = centres_x_mm;
        ToolReach { x_mm: [a.min(b) + lo - clearance_mm, a.max(b) + hi + clearance_mm], radius_mm: r }
    }

    /// Openings up to this width do not show, mm.
    pub fn harmless_mm(&self) -> f64 {
        (8.0 * self.radius_mm * SINK_MM).sqrt()
    }
}

/// Judges all openings of the part; returns doubts about those that do not matter.
///
/// # Errors
/// `InputOutput`: openings that the tool can meet, with their number, the widest and its place in
/// the model frame.
pub fn check(blade: &Blade, reach: &ToolReach) -> Result<Vec<Doubt>> {
    let mesh = &blade.part.mesh;
    let [lo, hi] = reach.x_mm;
    let (mut far, mut narrow) = (Vec::new(), Vec::new());
    let mut met: Vec<(f64, Point)> = Vec::new();
    let mut extent_mm: f64 = 0.0;
    for o in openings(mesh) {
        let Some(b) = o.aabb(mesh) else { continue };
        let width_mm = o.width_mm(mesh);
        if b.max.x < lo || b.min.x > hi {
            far.push(width_mm);
        } else if width_mm <= reach.harmless_mm() {
            narrow.push(width_mm);
        } else {
            let into = |p: &Point| (p.x - p.x.clamp(lo, hi)).abs();
            let points = o.points(mesh);
            let nearest = points.iter().min_by(|p, q| into(p).total_cmp(&into(q))).copied().unwrap_or(b.min);
            met.push((width_mm, nearest));
            extent_mm = extent_mm.max(o.extent_mm(mesh));
        }
    }
    if let Some((width_mm, p)) = met.iter().copied().max_by(|a, b| a.0.total_cmp(&b.0)) {
        let m = blade.model_from_blade * p;
        let n = met.len();
        return Err(Error::io(
            Stage::Model,
            format!(
                "{} is not closed where the tool works: {n} opening{} between x = {lo:.2} and {hi:.2} mm along the blade axis, the \
                 widest {width_mm:.3} mm, at ({:.3}, {:.3}, {:.3}) mm in the model",
                blade.name,
                if n == 1 { "" } else { "s" },
                m.x,
                m.y,
                m.z
            ),
        )
        .advise(if blade.part.brep.is_some() {
            "close the body in CAD and export it as a solid, or machine a region away from the opening".to_owned()
        } else {
            // Rounded up to what has two digits behind the point.
            let most_mm = (extent_mm * 100.0).ceil() / 100.0;
            format!(
                "close the mesh, here with --set model.close_holes_mm={most_mm} if it should be closed flat, or machine \
                 a region away from the opening"
            )
        }));
    }
    let widest = |list: &[f64]| list.iter().copied().reduce(f64::max).map(|widest_mm| (list.len(), widest_mm));
    let far =
        widest(&far).map(|(count, widest_mm)| Doubt::OpeningsOutOfReach { count, widest_mm, heights_mm: reach.x_mm });
    let narrow = widest(&narrow).map(|(count, widest_mm)| Doubt::OpeningsTooNarrow { count, widest_mm });
    Ok(far.into_iter().chain(narrow).collect())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::tool::HolderStage;

    fn tool() -> Tool {
        let holder = vec![HolderStage { radius_mm: 20.0, length_mm: 60.0 }];
        Tool { radius_mm: 4.0, corner_radius_mm: None, taper_deg: 0.0, shank_radius_mm: 4.0, stickout_mm: 50.0, holder }
    }

    #[test]
    fn the_reach_is_that_of_the_outermost_circle() {
        let b = 5f64.to_radians();
        let r = ToolReach::new(&tool(), [10.0, 2.0], b, 1.0);
        assert!((r.x_mm[1] - (10.0 + 110.0 * b.sin() + 20.0 * b.cos() + 1.0)).abs() < 1e-12);
        assert!((r.x_mm[0] - (2.0 + 50.0 * b.sin() - 20.0 * b.cos() - 1.0)).abs() < 1e-12);
        // Leaning the other way mirrors it.
        let m = ToolReach::new(&tool(), [-10.0, -2.0], -b, 1.0);
        assert!((r.x_mm[0] + m.x_mm[1]).abs() < 1e-12 && (r.x_mm[1] + m.x_mm[0]).abs() < 1e-12);
        // w²/8R.
        let w = r.harmless_mm();
        assert!((4.0 - (16.0 - 0.25 * w * w).sqrt() - SINK_MM).abs() < 1e-7);
    }

    /// The tube of the samples, x from 0 to 40 or so, with the triangles dropped that `drop` says.
    fn opened(drop: impl Fn(f64) -> bool) -> Blade {
        let mut blade = crate::sample::blade();
        let mut mesh = blade.part.mesh.clone();
        let keep: Vec<bool> =
            (0..mesh.triangles.len()).map(|t| !drop(mesh.corners(t).iter().map(|p| p.x).sum::<f64>() / 3.0)).collect();
        let mut k = keep.iter();
        mesh.triangles.retain(|_| *k.next().unwrap());
        let mut k = keep.iter();
        mesh.face_of.retain(|_| *k.next().unwrap());
        blade.part = crate::geometry::part::Part::from_mesh(mesh);
        blade
    }

    #[test]
    fn openings_in_reach_are_errors_and_others_warnings() {
        let whole = opened(|_| false);
        let b = whole.part.mesh.aabb().unwrap();
        let (lo, hi) = (b.min.x, b.max.x);
        let at = |x: f64| ToolReach { x_mm: [x, x + 0.1 * (hi - lo)], radius_mm: 4.0 };
        let middle = at(0.5 * (lo + hi));
        assert!(check(&whole, &middle).unwrap().is_empty());
        let no_lid = opened(|x| x > hi - 1e-6);
        let warnings = check(&no_lid, &middle).unwrap();
        assert!(
            warnings.len() == 1 && warnings[0].to_string().contains("1 openings out of the tool's reach"),
            "{warnings:?}"
        );
        let e = check(&no_lid, &at(hi - 0.05 * (hi - lo))).unwrap_err();
        assert!(
            e.to_string().contains("not closed where the tool works") && e.to_string().contains("in the model"),
            "{e}"
        );
        // The number that the advice names closes it, and a hundredth less does not.
        let named = e.to_string();
        let named = named.split_once("close_holes_mm=").unwrap().1.split(' ').next().unwrap();
        let most_mm: f64 = named.parse().unwrap();
        let closed_by = |most_mm: f64| {
            let mut mesh = no_lid.part.mesh.clone();
            crate::geometry::boundary::close(&mut mesh, most_mm, 0)
        };
        assert_eq!((closed_by(most_mm), closed_by(most_mm - 0.01)), (1, 0));
    }
}
