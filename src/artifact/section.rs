//! A plane section of the blade, perpendicular to its axis.

use crate::geometry::nurbs::NurbsCurve;

/// Which part of a section's airfoil loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Convex side.
    Suction,
    /// Concave side.
    Pressure,
}

/// A point where curvature changes sign (the papers' concave–convex altered point).
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AlteredPoint {
    /// Arc length from the loop's first point, mm.
    pub s_mm: f64,
    /// (y, z), mm.
    pub point_mm: [f64; 2],
    /// From convex to concave along increasing arc length.
    pub into_concave: bool,
}

/// One closed loop of a section, counter-clockwise seen from the tip (positive area).
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SectionLoop {
    /// (y, z), mm; the last point is not the first repeated.
    pub points_mm: Vec<[f64; 2]>,
    /// Arc length at each point, mm.
    pub s_mm: Vec<f64>,
    /// Signed curvature at each point, 1/mm; positive where convex.
    pub curvature_per_mm: Vec<f64>,
    /// Perimeter, mm.
    pub length_mm: f64,
    /// Enclosed area, mm².
    pub area_mm2: f64,
    /// Where curvature changes sign.
    pub altered_points: Vec<AlteredPoint>,
    /// Arc length of the leading edge, mm.
    pub leading_edge_s_mm: f64,
    /// Arc length of the trailing edge, mm.
    pub trailing_edge_s_mm: f64,
    /// Side from the leading edge onwards with increasing arc length, up to the trailing edge.
    pub side_after_leading_edge: Side,
    /// Chord: distance from leading to trailing edge, mm.
    pub chord_mm: f64,
    /// Greatest thickness, mm.
    pub thickness_mm: f64,
    /// Greatest distance of the smoothing fit that curvature is taken from to the section, mm; 0
    /// where all curvature is that of the exact faces.
    pub fit_error_mm: f64,
    /// Greatest distance of a point from the part, mm: a bound for each point, not for what lies
    /// between; not more than rounding where the part is a mesh.
    pub off_part_mm: f64,
}

/// One closed loop of a section as curves in its plane.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SectionCurves {
    /// Cubic B-splines (straight ones of lower degree), C² inside, each beginning where the one
    /// before it ends; blade frame, mm.
    pub pieces: Vec<NurbsCurve>,
    /// Greatest distance of the curves from the section, mm, as measured between the interpolated
    /// points, and a quarter more.
    pub off_mm: f64,
}

/// All loops at one height.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Section {
    /// Height along the blade axis, mm, blade frame.
    pub x_mm: f64,
    /// The airfoil's loop first (where there is one), then others by falling area.
    pub loops: Vec<SectionLoop>,
}
