//! What is in the tool's way besides the part: fixtures, stock, the other blades of a wheel.
use super::Blade;
use crate::geometry::Rigid;
use crate::geometry::part::Part;

/// A part with what stands about it.
#[derive(Clone, Copy)]
pub struct PartAmong<'a> {
    /// The part.
    pub blade: &'a Blade,
    /// What stands about it.
    pub obstacles: &'a [Obstacle],
}

impl<'a> PartAmong<'a> {
    /// The part, then what stands about it.
    pub fn bodies(&self) -> impl Iterator<Item = &'a Part> + use<'a> {
        std::iter::once(&self.blade.part).chain(self.obstacles.iter().map(|o| &o.part))
    }
}

impl<'a> From<&'a Blade> for PartAmong<'a> {
    /// With nothing about it.
    fn from(blade: &'a Blade) -> Self {
        PartAmong { blade, obstacles: &[] }
    }
}

/// A fixture, the stock, the other blades of a wheel or its hub, blade frame.
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
    /// It is the same seen from every blade of the wheel: the other blades, the hub.
    pub of_the_wheel: bool,
    /// Where it consists of copies of the part, as the other blades do: the turns that bring the
    /// part to them, blade frame, in the order of its groups. Empty: it is a body of its own.
    pub copies: Vec<Rigid>,
}
