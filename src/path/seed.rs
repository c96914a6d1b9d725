//! Where to start: a ball that touches the airfoil, and a check that the first ring goes round the
//! airfoil only.

use super::level::{LevelSet, Touch};
use super::ring::Ring;
use crate::artifact::Blade;
use crate::artifact::along::Along;
use crate::artifact::region::Region;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice};

/// The section loop that goes round a region of the blade, across it, and the others.
pub fn contour(blade: &Blade, region: &Region, x_mm: f64) -> Result<(Loop, Vec<Loop>)> {
    let across = |mesh: &Mesh, bvh: &MeshBvh| slice(mesh, bvh, x_mm);
    let all = if region.along == Along::BLADE {
        across(&blade.part.mesh, &blade.part.bvh)
    } else {
        let seen = region.along.seen(&blade.part.mesh);
        across(&seen, &MeshBvh::new(&seen))
    };
    let mut loops: Vec<Loop> = all.into_iter().filter(|l| l.closed && l.points.len() > 2).collect();
    match region.contour(&blade.part.mesh, &loops) {
        Some(i) => {
            let own = loops.swap_remove(i);
            Ok((own, loops))
        }
        None => Err(Error::usage(
            Stage::Path,
            format!(
                "the region begins at height {x_mm:.3} mm, where the section of the part has no closed loop; the part spans {:.3} to {:.3} mm along the blade axis",
                blade.regions.part_x_mm[0], blade.regions.part_x_mm[1]
            ),
        )
        .advise("choose [region] heights inside the part")),
    }
}

/// A ball in the plane at `x_mm` that touches the airfoil, found by stepping outwards from the
/// loop's extreme points.
pub fn first_touch(level: &LevelSet, airfoil: &Loop, x_mm: f64) -> Option<Touch> {
    let r = level.radius_mm;
    for k in 0..16 {
        let (s, c) = (k as f64 * std::f64::consts::TAU / 16.0).sin_cos();
        // The extreme point in a direction is on the loop's hull: nothing of the airfoil lies in
        // front of it.
        let p = airfoil.points.iter().max_by(|a, b| (a[0] * c + a[1] * s).total_cmp(&(b[0] * c + b[1] * s)))?;
        let guess = Point::from(level.along.vector(x_mm, [p[0] + r * c, p[1] + r * s]));
        if let Some(t) = level.touch_in_plane(&guess, 0.5 * r) {
            let lean = level.along.lean(&t.normal).abs() / t.cos_lean(&level.along).max(1e-9);
            let off_mm = (level.along.height_mm(&t.contact) - x_mm).abs();
            let allowance = 0.05 * r + level.part.stock_mm + lean * off_mm * 2.0;
            if airfoil.distance_mm(level.along.across(&t.contact.coords)) <= allowance {
                return Some(t);
            }
        }
    }
    None
}

/// The first contact of the ring that lies nearer to another loop of the section than to the
/// airfoil's.
pub fn touches_another_body(ring: &Ring, airfoil: &Loop, others: &[Loop]) -> Option<Point> {
    if others.is_empty() {
        return None;
    }
    ring.touches.iter().map(|t| t.contact).find(|p| {
        let q = ring.along.across(&p.coords);
        let own = airfoil.distance_mm(q);
        others.iter().any(|l| l.distance_mm(q) < own)
    })
}
