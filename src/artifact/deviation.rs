//! How far the machined surface is from the part, as a map.

use crate::geometry::{Point, Vector};

/// Triangles on the part, blade frame, with what is left standing over each corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeviationMap {
    /// Corners, on the part (on its stock, where some is to stay), mm.
    pub points: Vec<Point>,
    /// Outward unit normals there.
    pub normals: Vec<Vector>,
    /// Height of the machined surface along the normal, mm: material left where positive, a gouge
    /// where negative, not a number where the ball does not come.
    pub heights_mm: Vec<f64>,
    /// Corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The height in the middle of an edge is off the mean of its ends by no more than this, mm,
    /// but for `coarse`.
    pub tolerance_mm: f64,
    /// Triangles that were not divided further because the map had become too large, or their edges
    /// too short.
    pub coarse: usize,
    /// In those the height anywhere is off the linear one between the corners by no more than this,
    /// mm, where the ball comes to all three; but for `sharp`.
    pub coarse_bound_mm: f64,
    /// Those of them that lie on an edge sharper than they are small: a normal there may miss the
    /// ball, so heights have no bound.
    pub sharp: usize,
    /// Their area, mm².
    pub sharp_area_mm2: f64,
    /// In those the distance of any place to what is left standing is off the linear height by no
    /// more than this, mm.
    pub sharp_bound_mm: f64,
}
