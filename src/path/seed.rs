//! Where to start: a ball that touches the airfoil, and a check that the first ring goes round the
//! airfoil only.

use std::f64::consts::{PI, TAU};

use super::level::{LevelSet, Touch};
use super::ring::Ring;
use crate::artifact::Blade;
use crate::artifact::along::Along;
use crate::artifact::region::Region;
use crate::error::{Error, Result, Stage};
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::{Mesh, part_of};
use crate::geometry::slice::{Loop, slice};
use crate::geometry::{Point, Vector};

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
        let frame = level.along.frame(&Point::origin());
        let guess = Point::from(frame.vector(x_mm, [p[0] + r * c, p[1] + r * s]));
        if let Some(t) = level.touch_in_plane(&guess, 0.5 * r) {
            let lean = frame.lean(&t.normal).abs() / t.cos_lean(&level.along).max(1e-9);
            let off_mm = (level.along.height_mm(&t.contact) - x_mm).abs();
            let allowance = 0.05 * r + level.part.stock_mm + lean * off_mm * 2.0;
            if airfoil.distance_mm(frame.across(&t.contact.coords)) <= allowance {
                return Some(t);
            }
        }
    }
    None
}

/// The first contact of the ring that lies nearer to another loop of the section than to the
/// airfoil's.
fn touches_another_body(ring: &Ring, airfoil: &Loop, others: &[Loop]) -> Option<Point> {
    if others.is_empty() {
        return None;
    }
    ring.touches.iter().map(|t| t.contact).find(|p| {
        let q = ring.along.frame(p).across(&p.coords);
        let own = airfoil.distance_mm(q);
        others.iter().any(|l| l.distance_mm(q) < own)
    })
}

/// What the first ring is to go round.
pub enum Contour {
    /// A loop of the section across the region at a height, and the other loops there.
    Section(Loop, Vec<Loop>),
    /// The surface of a blade whose hub turns.
    Surface(OwnSurface),
}

impl Contour {
    /// That of a region at a height.
    ///
    /// # Errors
    /// Kind `Usage` where its section has no closed loop there.
    pub fn of(blade: &Blade, region: &Region, level: &LevelSet, x_mm: f64) -> Result<Contour> {
        if level.along.round().is_some() {
            return Ok(Contour::Surface(OwnSurface::of(blade, region, level)));
        }
        contour(blade, region, x_mm).map(|(own, others)| Contour::Section(own, others))
    }

    /// A ball at that height that touches it.
    pub fn first_touch(&self, level: &LevelSet, x_mm: f64) -> Option<Touch> {
        match self {
            Contour::Section(own, _) => first_touch(level, own, x_mm),
            Contour::Surface(own) => own.first_touch(level, x_mm),
        }
    }

    /// A contact of the ring with another body.
    pub fn touches_another_body(&self, ring: &Ring) -> Option<Point> {
        match self {
            Contour::Section(own, others) => touches_another_body(ring, own, others),
            Contour::Surface(own) => own.touches_another_body(ring),
        }
    }
}

/// The surface of a blade whose hub turns.
pub struct OwnSurface {
    mesh: Mesh,
    bvh: MeshBvh,
    /// How far contacts may be off it, mm.
    near_mm: f64,
}

/// Places round the rotor axis at which the blade is looked for.
const ROUND: u32 = 720;
/// Where along it, from one end to the other.
const ALONG: [f64; 5] = [0.5, 0.4, 0.6, 0.3, 0.7];
/// Balls are tried from there outwards, so many radii apart, so often.
const OUTWARDS: (f64, u32) = (0.2, 60);
/// A contact is on the blade within this share of the radius, besides what the mesh is off.
const ON_BLADE: f64 = 0.02;
/// Share of a ring that may touch what is not the blade: facets that are not known to be its.
const MOST_BESIDE: f64 = 0.25;

impl OwnSurface {
    /// That of a region.
    pub fn of(blade: &Blade, region: &Region, level: &LevelSet) -> OwnSurface {
        let whole = &blade.part.mesh;
        let own: Vec<u32> = (0..whole.triangles.len() as u32).filter(|t| region.patch.has(whole, *t)).collect();
        let mesh = part_of(whole, &own);
        let near_mm = ON_BLADE * level.radius_mm + 2.0 * blade.part.deflection_mm + level.part.stock_mm;
        OwnSurface { bvh: MeshBvh::new(&mesh), mesh, near_mm }
    }

    fn has(&self, contact: &Point) -> bool {
        self.bvh.closest(&self.mesh, contact, self.near_mm).is_some()
    }

    /// A ball with its centre at this height that touches the blade.
    pub fn first_touch(&self, level: &LevelSet, x_mm: f64) -> Option<Touch> {
        let meridian = level.along.round()?;
        let n = self.mesh.points.len() as f64;
        let middle = Point::from(self.mesh.points.iter().map(|p| p.coords).sum::<Vector>() / n);
        let from = meridian.out(&middle);
        let (apart, most) = OUTWARDS;
        ALONG.into_iter().find_map(|along| {
            let at = |angle: f64| meridian.point(along, x_mm, &from, angle);
            let angles = (0..ROUND).map(|k| TAU * f64::from(k) / f64::from(ROUND));
            let away = |angle: f64| self.bvh.closest(&self.mesh, &at(angle), f64::INFINITY).map(|c| c.distance_mm);
            let on_blade = angles.filter_map(|a| Some((away(a)?, a))).min_by(|a, b| a.0.total_cmp(&b.0))?.1;
            let radius_mm = (at(0.0) - at(PI)).norm() * 0.5;
            let step = apart * level.radius_mm / radius_mm.max(level.radius_mm);
            let outwards = (1..=most).flat_map(|k| [1.0, -1.0].map(|side| on_blade + side * step * f64::from(k)));
            let mut touches = outwards.filter_map(|angle| level.touch_in_plane(&at(angle), 0.5 * level.radius_mm));
            // Small balls have room within a thick blade, too.
            touches.find(|t| self.has(&t.contact) && !level.part.inside(&t.centre))
        })
    }

    /// A contact of the ring that is not on the blade, where many are not.
    pub fn touches_another_body(&self, ring: &Ring) -> Option<Point> {
        let beside: Vec<Point> = ring.touches.iter().map(|t| t.contact).filter(|p| !self.has(p)).collect();
        let is_another = beside.len() as f64 > MOST_BESIDE * ring.touches.len() as f64;
        beside.get(beside.len() / 2).copied().filter(|_| is_another)
    }
}
