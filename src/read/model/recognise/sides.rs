//! Leading and trailing edge of the airfoil that was found, by sections all along it.

use crate::geometry::part::Part;
use crate::geometry::profile::outline::outlines;
use crate::geometry::profile::{Outline, Profile, SectionEnds, Sides, TOLERANCE_MM};
use crate::parallel;

/// Sections that say it: a blade that twists by a right angle turns by some degrees from one to the
/// next.
const SECTIONS: usize = 33;

/// The edges and sides of the airfoil between two heights, mm; `None` where no section closes.
/// `part`: blade frame; `boxes`: those of the sections that it was recognised by, with their
/// heights.
pub fn sides(part: &Part, [lo, hi]: [f64; 2], boxes: &[(f64, [f64; 4])]) -> Option<Sides> {
    let height = |k: usize| lo + (hi - lo) * (k as f64 + 0.5) / SECTIONS as f64;
    let ends = |x_mm: f64| -> Option<(f64, SectionEnds)> {
        let airfoil = outlines(part, x_mm).loops.into_iter().min_by(|a, b| {
            let [a, b] = [a, b].map(|o| away_mm(boxes, x_mm, o));
            a.total_cmp(&b)
        })?;
        Some((x_mm, Profile::of(airfoil, TOLERANCE_MM).ends()))
    };
    let sections: Vec<(f64, SectionEnds)> = parallel::filter_map(0..SECTIONS, |k| ends(height(k)));
    Sides::along(&sections)
}

/// How far the box of a loop is from that of the airfoil's section nearest in height.
fn away_mm(boxes: &[(f64, [f64; 4])], x_mm: f64, outline: &Outline) -> f64 {
    let nearest = boxes.iter().min_by(|a, b| (a.0 - x_mm).abs().total_cmp(&(b.0 - x_mm).abs()));
    let own = outline.points.iter().fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |b, p| {
        [b[0].min(p[0]), b[1].min(p[1]), b[2].max(p[0]), b[3].max(p[1])]
    });
    nearest.map_or(0.0, |(_, bounds)| bounds.iter().zip(own).map(|(a, b)| (a - b).abs()).sum())
}
