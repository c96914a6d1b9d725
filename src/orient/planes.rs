//! Reference planes.

use crate::artifact::{Cone, Cones, Toolpath};
use crate::geometry::Vector;

/// A normal nearer to the radial direction than this names no plane (sine of the angle).
const ALONG: f64 = 1e-3;

/// The cones of the reference planes along a path: at each location the plane through the radial
/// direction of the blade, unit, and the surface normal. θ is 0 along the radial direction and
/// grows towards the normal. Where the normal is along the radial direction the plane before is
/// kept. `None` where no location names a plane.
pub fn reference_planes(path: &Toolpath, radial: &Vector) -> Option<Cones> {
    let plane = |normal: &Vector| {
        let across = radial.cross(normal);
        (across.norm() > ALONG).then(|| Cone::new(across, *radial, 0.0)).flatten()
    };
    let mut last = path.locations.iter().find_map(|l| plane(&l.normal))?;
    let cones = path.locations.iter().map(|l| {
        last = plane(&l.normal).unwrap_or(last);
        last
    });
    Some(Cones::along(cones.collect()))
}
