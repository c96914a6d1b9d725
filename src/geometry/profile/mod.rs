//! Plane sections of a part as curves: the outlines at a height, their curvature, their two ends
//! and how thick they are.
//!
//! Everything is in the plane `x = const` of the part's frame: points are (y, z), mm,
//! counter-clockwise seen from the tip.

pub mod curvature;
pub mod edges;
pub mod outline;
pub mod sides;

pub use edges::SectionEnds;
pub use outline::Outline;
pub use sides::{Names, Sides};

/// How far the smooth curve that curvature is taken from may stay off a section's points where
/// nothing else is asked for, mm.
pub const TOLERANCE_MM: f64 = 0.002;

/// A closed outline with its arc length and curvature.
pub struct Profile {
    /// The outline.
    pub outline: Outline,
    /// Arc length at each point, mm.
    pub s_mm: Vec<f64>,
    /// Perimeter, mm.
    pub length_mm: f64,
    /// Curvature and normals.
    pub fit: curvature::Fit,
}

impl Profile {
    /// Measures an outline; the curve that curvature is taken from stays within the tolerance, or
    /// twice of what the points are off the part.
    pub fn of(outline: Outline, tolerance_mm: f64) -> Profile {
        let (s_mm, length_mm) = outline::arc_length(&outline.points);
        let tolerance_mm = tolerance_mm.max(2.0 * outline.off_part_mm);
        let fit = curvature::fit(&outline.points, &outline.exact, &s_mm, length_mm, tolerance_mm);
        Profile { outline, s_mm, length_mm, fit }
    }

    /// The two ends.
    pub fn ends(&self) -> SectionEnds {
        edges::find(&self.outline.points, &self.s_mm, self.length_mm, &self.fit.curvature)
    }
}
