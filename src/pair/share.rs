//! How much of a blade's airfoil has an opposite side.

use crate::artifact::region::{Area, of_faces};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::geometry::mesh::spread;
use crate::geometry::opposite::{Pair, SurfacePlace, has_inside, partner};
use crate::geometry::part::Part;
use crate::observe::Observer;
use crate::parallel;

/// Places on the airfoil.
const PLACES: usize = 8000;
/// Places that are looked at between two looks whether the user has asked to stop.
const AT_ONCE: usize = 500;
/// Normals that lack so much of being opposite hold the blade still, degrees.
pub const HOLDS_DEG: f64 = 30.0;
/// What of the airfoil has an opposite side. Lengths in mm, angles in degrees.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Share {
    /// Places that were looked at, spread evenly over the airfoil's area.
    pub places: usize,
    /// Share of them with a partner on the airfoil whose β is at most [`HOLDS_DEG`].
    pub holds: f64,
    /// ... with a partner on the airfoil, and a greater β: wedges, as towards edges.
    pub wedge: f64,
    /// ... with a partner that is not on the airfoil.
    pub elsewhere: f64,
    /// ... without a partner: edges, whose ball is that of the curvature.
    pub none: f64,
    /// Diameter of the balls of those that hold: least, median, greatest.
    pub thickness_mm: [f64; 3],
    /// β of those that hold: median, 99th percentile.
    pub angle_deg: [f64; 2],
    /// Distance of the two normals of those that hold, 99th percentile.
    pub apart_p99_mm: f64,
    /// Median thickness over the airfoil's mean width.
    pub thickness_over_chord: f64,
}

/// The share of the airfoil with an opposite side; `areas`: what each triangle of the part's mesh
/// is; `chord_mm`: mean width of the airfoil's sections.
///
/// # Errors
/// `Infeasible`: the part has no inside, or the airfoil no opposite sides. Cancellation.
pub fn share(part: &Part, areas: &[Area], chord_mm: f64, observer: &dyn Observer) -> Result<Share> {
    let refuse =
        |message: String, advice: &str| Error::infeasible(Stage::Model, message, Infeasible::NoPairs).advise(advice);
    has_inside(part, Stage::Model)?;
    let is_airfoil = |t: usize| areas.get(t) == Some(&Area::Airfoil);
    let places = spread(&part.mesh, is_airfoil, PLACES);
    if places.is_empty() {
        return Err(refuse("no airfoil was found on the part".into(), "say where it is: --axis, --faces or --region"));
    }
    let within_mm = part.mesh.aabb().map_or(0.0, |b| b.diagonal_mm());
    let faces = of_faces(&part.mesh, areas);
    let mut found = Vec::with_capacity(places.len());
    for chunk in places.chunks(AT_ONCE) {
        observer.check(Stage::Model)?;
        found.extend(parallel::map(chunk, |(p, triangle)| one(part, p, *triangle, within_mm)));
        observer.progress(Stage::Model, found.len(), places.len());
    }
    let pairs: Vec<&Pair> = found.iter().flatten().collect();
    let on_airfoil = |p: &Pair| match p.triangle {
        Some(t) => is_airfoil(t as usize),
        None => faces.get(&p.face) == Some(&Area::Airfoil),
    };
    let (own, other): (Vec<&Pair>, Vec<&Pair>) = pairs.iter().partition(|p| on_airfoil(p));
    let (holds, wedge): (Vec<&Pair>, Vec<&Pair>) =
        own.into_iter().partition(|p| p.angle_rad().to_degrees() <= HOLDS_DEG);
    let of = |n: usize| n as f64 / found.len() as f64;
    if holds.is_empty() {
        return Err(refuse(
            format!(
                "no place of the airfoil has an opposite one: of {} places {} have a partner at more than {HOLDS_DEG}°, {} one that is not on \
                 the airfoil",
                found.len(),
                wedge.len(),
                other.len()
            ),
            "one tool can machine it",
        ));
    }
    let sorted = |value: &dyn Fn(&Pair) -> f64| {
        let mut all: Vec<f64> = holds.iter().map(|p| value(p)).collect();
        all.sort_by(f64::total_cmp);
        move |q: f64| all[((all.len() - 1) as f64 * q).round() as usize]
    };
    let thickness = sorted(&|p| 2.0 * p.radius_mm);
    let angle = sorted(&|p| p.angle_rad().to_degrees());
    let apart = sorted(&Pair::apart_mm);
    Ok(Share {
        places: found.len(),
        holds: of(holds.len()),
        wedge: of(wedge.len()),
        elsewhere: of(other.len()),
        none: of(found.len() - pairs.len()),
        thickness_mm: [thickness(0.0), thickness(0.5), thickness(1.0)],
        angle_deg: [angle(0.5), angle(0.99)],
        apart_p99_mm: apart(0.99),
        thickness_over_chord: thickness(0.5) / chord_mm,
    })
}

/// The pair of a place.
///
/// On a mesh the middle of its triangle stands for it: a ball that is tangent to a facet beside one
/// of its edges touches the next facet first.
fn one(part: &Part, p: &Point, triangle: u32, within_mm: f64) -> Option<Pair> {
    if part.brep.is_none() {
        let [a, b, c] = part.mesh.corners(triangle as usize);
        let place = SurfacePlace { point: a + ((b - a) + (c - a)) / 3.0, normal: part.mesh.normal(triangle as usize) };
        return partner(part, place, within_mm);
    }
    // A point of a facet lies beside the exact face.
    let near = part.closest(p, f64::INFINITY)?;
    partner(part, SurfacePlace { point: near.point, normal: near.normal }, within_mm)
}

#[cfg(test)]
#[path = "share_tests.rs"]
mod tests;
