//! What is in the tool's way besides the part: fixtures and stock.
use crate::geometry::part::Part;

/// A fixture or the stock, blade frame.
#[derive(Clone)]
pub struct Obstacle {
    /// What messages call it, e.g. `fixture vice.stl`.
    pub name: String,
    /// Its closed mesh.
    pub part: Part,
    /// Room that taper and shank keep from it, mm.
    pub clearance_mm: f64,
    /// Room that the holder keeps from it, mm.
    pub holder_clearance_mm: f64,
    /// Material that the cutter may go through: only the holder must keep clear of it.
    pub cut_by_the_tool: bool,
}
