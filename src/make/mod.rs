//! The parametric blade generator.
//!
//! In: a [`BladeDesign`] (a TOML file, or one of the [`presets`]). Out: a [`MadeBlade`], a closed
//! solid of NURBS faces and a watertight mesh of it, as the text of a STEP ([`step_text`]) or an
//! OBJ file ([`obj_text`]).
//!
//! * **Airfoil**: sections from a profile law ([`profile`]) whose chord, stagger, camber,
//!   thickness, edge radii, sweep and lean are laws of height. A periodic C² cubic round the
//!   section through `stations` points, cubic upwards through `rows` rows.
//! * **Fillet**: the surface of the ball that rolls between airfoil and platform
//!   ([`rolling_ball`]): at every station an exact rational arc, interpolated round the section in
//!   homogeneous space with the airfoil's own parameters, so both share one boundary curve bit by
//!   bit.
//! * **Platform and root**: one polygon across the blade drawn along x, sides parallel or sheared:
//!   flat faces.
//! * **Prism**: a stadium or circular cylinder, exact: planes, cylinders, tori as rational
//!   quadratics.
//!
//! Guaranteed: the solid is closed and oriented (faces share their edges; truck's topology checks
//! confirm it), platform and tip are planes exactly, the mesh is within its deflection of the
//! surfaces. Measured for the presets in the tests: airfoil and fillet meet within 0.1°, the fillet
//! is within 1 µm of the rolling ball's surface. Limits: no shroud, no fillet at the root, tip
//! flat.

mod assemble;
mod closed;
pub mod design;
mod mesh;
pub mod presets;
pub mod profile;
mod ring;
pub mod rolling_ball;
mod write;

pub use design::{Accuracy, AirfoilDesign, BladeDesign, Law, OutlinePoint, PlatformDesign, PrismDesign};
pub use write::{obj_text, step_text};

use crate::error::Result;
use crate::geometry::Point;
use crate::geometry::brep::Brep;
use crate::geometry::mesh::Mesh;

/// A made blade: model frame, mm, root below, tip at +z.
#[derive(Clone, Debug)]
pub struct MadeBlade {
    /// Its name.
    pub name: String,
    /// Its faces and edges; the first loop of a face is its outer one, loops turn counter-clockwise
    /// seen from outside.
    pub brep: Brep,
    /// Start and end of every edge of `brep`, indices into `vertices`.
    pub edge_ends: Vec<[usize; 2]>,
    /// The vertices.
    pub vertices: Vec<Point>,
    /// A watertight mesh; its points are on the faces.
    pub mesh: Mesh,
    /// Greatest distance of `mesh` from the faces, as measured, mm.
    pub deflection_mm: f64,
}

/// Makes the blade. Errors: a design that is out of range (usage), or one that has no solid, for
/// example a fillet wider than the hollow of the airfoil (infeasible).
///
/// ```
/// let blade = bladewright::make::build(&bladewright::make::presets::prism())?;
/// // Stadium 60 x 20 with fillet on a platform and root: every face of the solid is there.
/// assert_eq!(blade.brep.faces.len(), 4 + 4 + 1 + 1 + 6 + 1 + 2);
/// # Ok::<(), bladewright::Error>(())
/// ```
pub fn build(design: &BladeDesign) -> Result<MadeBlade> {
    design.validate()?;
    let patches = ring::patches(design)?;
    let solid = assemble::assemble(design, &patches)?;
    let fillets = patches.iter().filter(|p| p.fillet.is_some()).count();
    closed::truck_solid(&solid)?;
    let (mesh, deflection_mm) = mesh::mesh(&solid, [patches.len(), fillets], design.accuracy.deflection_mm)?;
    Ok(MadeBlade {
        name: design.name.clone(),
        brep: solid.brep,
        edge_ends: solid.ends,
        vertices: solid.vertices,
        mesh,
        deflection_mm,
    })
}

#[cfg(test)]
mod tests;
