//! The patches round the blade: airfoil and fillet, neighbours sharing their boundary control
//! points bit by bit.

use std::f64::consts::{PI, SQRT_2, TAU};

use nalgebra::Vector4;

use super::design::{Accuracy, BladeDesign, PrismDesign};
use super::profile::BladeSections;
use super::rolling_ball::{Contact, IdealAirfoil};
use crate::error::{DesignFault, Error, Infeasible, Result, Stage};
use crate::geometry::brep::SurfaceKind;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::fit::{ControlRows, FitError, PeriodicRows, surface_through_rows};

/// One patch: `u` runs counter-clockwise seen from the tip, `v` upwards.
#[derive(Clone, Debug)]
pub(super) struct RingPatch {
    pub name: &'static str,
    pub airfoil: NurbsSurface,
    pub airfoil_kind: SurfaceKind,
    /// From the platform up to the airfoil; none: the airfoil stands on the platform.
    pub fillet: Option<NurbsSurface>,
    pub fillet_kind: SurfaceKind,
}

fn fit(e: FitError) -> Error {
    let what = Infeasible::Design { fault: DesignFault::NoSurface };
    Error::infeasible(Stage::Make, "the surfaces cannot be interpolated", what).caused_by(e)
}

/// All patches, counter-clockwise.
pub(super) fn patches(d: &BladeDesign) -> Result<Vec<RingPatch>> {
    let (z0, tip) = (d.platform.top_z_mm, d.platform.top_z_mm + d.height_mm);
    match (&d.airfoil, &d.prism) {
        (Some(a), _) => {
            let ideal = IdealAirfoil::new(BladeSections::new(a)?, z0, d.height_mm);
            free_form(&ideal, d.fillet_radius_mm, tip, &d.accuracy)
        }
        (None, Some(p)) => Ok(stadium(p, d.fillet_radius_mm, z0, tip)),
        (None, None) => Err(Error::usage(Stage::Make, "a design needs exactly one of [airfoil] and [prism]")),
    }
}

fn homogeneous(x: f64, y: f64, z: f64, w: f64) -> Vector4<f64> {
    Vector4::new(x * w, y * w, z * w, w)
}

/// Row `j` of `rows` along the height, 0 at the fillet, 1 at the tip: closer together where the
/// airfoil leaves the fillet and at the tip, since a clamped spline is least exact at its ends.
fn row_fraction(j: usize, rows: usize) -> f64 {
    let t = j as f64 / rows as f64;
    t - 0.12 * (TAU * t).sin() / TAU * 2.0
}

/// Airfoil and fillet by interpolation: cubic and C² round the section, parameters φ; the airfoil
/// cubic upwards, the fillet's cross-sections rational arcs. Cut at leading and trailing edge.
fn free_form(ideal: &IdealAirfoil, r: f64, tip: f64, accuracy: &Accuracy) -> Result<Vec<RingPatch>> {
    let n = accuracy.stations;
    let params: Vec<f64> = (0..=n).map(|i| TAU * i as f64 / n as f64).collect();
    let phi = &params[..n];
    let contacts = ideal.contacts(phi, r)?;
    let fractions: Vec<f64> = (0..=accuracy.rows).map(|j| row_fraction(j, accuracy.rows)).collect();

    let mut wall = Vec::with_capacity(n * fractions.len());
    let mut arcs = Vec::with_capacity(n * 3);
    for (&p, c) in phi.iter().zip(&contacts) {
        wall.push(c.airfoil.to_homogeneous());
        wall.extend(
            fractions[1..].iter().map(|f| ideal.point(p, c.airfoil.z + f * (tip - c.airfoil.z)).to_homogeneous()),
        );
        arcs.extend(arc(c, r));
    }
    let cuts = [0, n / 2];
    let mut walls =
        PeriodicRows::interpolate(&wall, fractions.len(), &params).and_then(|w| w.pieces(&cuts)).map_err(fit)?;
    let mut fillets = PeriodicRows::interpolate(&arcs, 3, &params).and_then(|w| w.pieces(&cuts)).map_err(fit)?;
    // Constants are interpolated to rounding only: the plane of platform and tip and weights of one
    // shall be exact.
    walls.iter_mut().for_each(|w| settle(w, &[(fractions.len() - 1, Some(tip))]));
    walls.iter_mut().flat_map(|w| &mut w.points).for_each(|p| p.w = 1.0);
    fillets.iter_mut().for_each(|f| settle(f, &[(0, Some(ideal.z0)), (2, None)]));

    let names = ["pressure side", "suction side"];
    let mut patches = Vec::with_capacity(2);
    for ((name, wall), fillet) in names.into_iter().zip(walls).zip(fillets) {
        patches.push(RingPatch {
            name,
            airfoil: surface_through_rows(&wall, &fractions, 3).map_err(fit)?,
            airfoil_kind: SurfaceKind::BSpline,
            fillet: Some(fillet.surface(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0]).map_err(fit)?),
            fillet_kind: SurfaceKind::BSpline,
        });
    }
    Ok(patches)
}

/// Sets columns to weight one and, where given, to a height.
fn settle(rows: &mut ControlRows, columns: &[(usize, Option<f64>)]) {
    let width = rows.columns;
    for row in rows.points.chunks_exact_mut(width) {
        for &(column, z) in columns {
            row[column].w = 1.0;
            row[column].z = z.unwrap_or(row[column].z);
        }
    }
}

/// The arc from platform to airfoil as a rational quadratic: its middle control point is where the
/// end tangents meet, its weight the cosine of half the angle.
fn arc(c: &Contact, r: f64) -> [Vector4<f64>; 3] {
    let cos = c.normal.z; // of the angle between the radii −e_z and −n
    let mut towards = -c.normal;
    towards.z -= 1.0;
    let corner = c.centre + towards * (r / (1.0 + cos));
    let w = (0.5 * (1.0 + cos)).sqrt();
    [c.platform.to_homogeneous(), homogeneous(corner.x, corner.y, corner.z, w), c.airfoil.to_homogeneous()]
}

/// A curve in the plane of the platform with its outward offset: control points `(x, y, w)` and
/// unit offset directions (radial at the control polygon's corners, so that the offset of an arc is
/// an arc).
struct OffsetCurve {
    name: &'static str,
    degree: usize,
    knots: Vec<f64>,
    points: Vec<[f64; 3]>,
    outwards: Vec<[f64; 2]>,
    straight: bool,
}

/// The stadium, exact: sides as planes (bilinear), ends as half cylinders (rational quadratic),
/// fillets as quarter cylinders and half tori.
fn stadium(p: &PrismDesign, r: f64, z0: f64, tip: f64) -> Vec<RingPatch> {
    let radius = 0.5 * p.width_mm;
    let half = 0.5 * p.length_mm - radius;
    let mut outlines = Vec::new();
    let names = [("lower side", "trailing end"), ("upper side", "leading end")];
    for (k, (side, end)) in names.into_iter().enumerate() {
        let turn = if k == 0 { 1.0 } else { -1.0 };
        if half > 0.0 {
            outlines.push(OffsetCurve {
                name: side,
                degree: 1,
                knots: vec![0.0, 0.0, 1.0, 1.0],
                points: vec![[-half * turn, -radius * turn, 1.0], [half * turn, -radius * turn, 1.0]],
                outwards: vec![[0.0, -turn]; 2],
                straight: true,
            });
        }
        // Half circle about (half, 0): corners of its control polygon are at the square around it.
        let outwards: Vec<[f64; 2]> = [[0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
            .map(|d: [f64; 2]| d.map(|x| x * turn))
            .to_vec();
        outlines.push(OffsetCurve {
            name: end,
            degree: 2,
            knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0],
            points: (0..5)
                .map(|i| {
                    let w = if i % 2 == 0 { 1.0 } else { 0.5 * SQRT_2 };
                    [half * turn + radius * outwards[i][0], radius * outwards[i][1], w]
                })
                .collect(),
            outwards,
            straight: false,
        });
    }
    let (sin, cos) = (p.stagger_deg / 180.0 * PI).sin_cos();
    outlines.iter().map(|o| o.patch(r, z0, tip, [sin, cos])).collect()
}

impl OffsetCurve {
    /// Extrudes the outline from the fillet to the tip and sweeps the fillet's quarter arc along
    /// it.
    fn patch(&self, r: f64, z0: f64, tip: f64, [sin, cos]: [f64; 2]) -> RingPatch {
        let place = |x: f64, y: f64, z: f64, w: f64| homogeneous(cos * x - sin * y, sin * x + cos * y, z, w);
        let surface = |degree_v: usize, knots_v: Vec<f64>, columns: &[(f64, f64, f64)]| NurbsSurface {
            degree_u: self.degree,
            degree_v,
            knots_u: self.knots.clone(),
            knots_v,
            n_u: self.points.len(),
            n_v: columns.len(),
            points: (self.points.iter().zip(&self.outwards))
                .flat_map(|(p, d)| {
                    columns
                        .iter()
                        .map(move |&(offset, z, w)| place(p[0] + offset * d[0], p[1] + offset * d[1], z, p[2] * w))
                })
                .collect(),
        };
        let kind = |straight, curved| if self.straight { straight } else { curved };
        let arc = [(r, z0, 1.0), (0.0, z0, 0.5 * SQRT_2), (0.0, z0 + r, 1.0)];
        RingPatch {
            name: self.name,
            airfoil: surface(1, vec![0.0, 0.0, 1.0, 1.0], &[(0.0, z0 + r, 1.0), (0.0, tip, 1.0)]),
            airfoil_kind: kind(SurfaceKind::Plane, SurfaceKind::Cylinder),
            fillet: (r > 0.0).then(|| surface(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], &arc)),
            fillet_kind: kind(SurfaceKind::Cylinder, SurfaceKind::Torus),
        }
    }
}
