//! What is measured of a part: its closest point, its area and its volume.

use super::{Point, Vector};

/// The closest point of the part to a query point.
#[derive(Clone, Copy, Debug)]
pub struct Closest {
    /// The closest point on the part.
    pub point: Point,
    /// Unsigned distance, mm.
    pub distance_mm: f64,
    /// Outward unit normal of the part there (on an edge or vertex: of one of its faces; the
    /// direction of the distance is then `q - point`, not this).
    pub normal: Vector,
    /// Face or group.
    pub face: u32,
    /// Parameters on that face; zero where the part is a mesh.
    pub uv: [f64; 2],
    /// Triangle that holds it, where the part is a mesh.
    pub triangle: Option<u32>,
}

/// Area and volume of a part, with what they may be wrong by.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// Area, mm².
    pub area_mm2: f64,
    /// Estimated error of the area, mm².
    pub area_error_mm2: f64,
    /// Signed volume, mm³: positive where the normals of a closed part point outwards.
    pub volume_mm3: f64,
    /// Estimated error of the volume, mm³.
    pub volume_error_mm3: f64,
}
