//! Opposite places of a blade: where two tools can hold it between them.
//!
//! In: a part, and a place on its surface with its outward normal. Out: the greatest ball inside
//! the part that touches it there, and the other place where that ball touches ([`Pair`]).
//!
//! ## Why these
//! The normals at both places pass through the ball's centre. So two forces against the surface
//! there have no moment about it, whatever their sizes, and equal forces leave `2 sin(β/2)` of one
//! of them, along the sheet midway between the sides, which is the blade's stiff direction. `β` is
//! what the normals lack of being opposite: twice the half angle of the wedge that the sides make
//! there, nothing where the thickness does not change.
//!
//! ## Method
//! A ball that is tangent at the first place and too large holds other places of the part. The one
//! nearest to its centre makes a smaller ball that is tangent at the first place too: of radius
//! `‖p − q‖² / (2 n·(p − q))`. Radii fall, and near the end their error is squared at each step
//! (*shrinking ball*, Ma, Bae and Choi, *3D medial axis point approximation using nearest neighbors
//! and the normal field*, The Visual Computer 28, 2012). There the first place is as near to the
//! centre as the second. So the second is asked for from beyond the centre, twice, and taken where
//! it would be from the centre itself. The first ball is that of the surface's own curvature, or as
//! large as any can be where the surface is flat or hollow. On a round edge that ball is the
//! greatest already: nothing has to be told apart that is about as far from its axis.
//!
//! ## Guarantees
//! On exact faces both places lie on them, and the ball holds no place of the part by more than
//! [`HELD_MM`]. A place without a partner, as on an edge, whose ball is that of the curvature, has
//! none.

use super::measured::Closest;
use super::mesh::topology;
use super::part::Part;
use super::{Point, Vector};
use crate::error::{Error, Infeasible, Result, Stage};

/// The ball of a pair holds nothing of the part by more than this, mm.
pub const HELD_MM: f64 = 1e-6;
/// A place of the surface lies on it within this, mm.
const ON_MM: f64 = 0.01;
/// Steps of the search.
const STEPS: usize = 60;
/// Radii that differ by less than this share are the same.
const SAME: f64 = 1e-12;
/// A place has to make the radius smaller by this share at first, and by a share that is so much
/// less where there is none. A ball within the first share of that of the curvature is that.
const LOOSE: f64 = 1e-3;
const TIGHTER: f64 = 1e-4;
/// After a step that changes the radius by less than this share the error is its square.
const SETTLED: f64 = 1e-7;
/// The second place is asked for from so far beyond the centre, as a share of the radius. It moves
/// by as much times the sine of β; what is left after extrapolation is of the square.
const BEYOND: f64 = 1e-5;
/// A ball that touches again nearer than this share of its radius touches at one place.
const ONE_PLACE: f64 = 1e-3;

/// Whether a part has an inside, for balls to be in: its mesh has no open edges, winds one way and
/// encloses a volume. Bodies may touch along edges.
///
/// # Errors
/// `Infeasible`, with what is wrong and where.
pub fn has_inside(part: &Part, stage: Stage) -> Result<()> {
    let refuse =
        |message: String, advice: &str| Err(Error::infeasible(stage, message, Infeasible::NoPairs).advise(advice));
    let t = topology(&part.mesh);
    if t.open_edges > 0 {
        return refuse(
            format!("the part is open, so it has no inside: {} edges have one facet alone", t.open_edges),
            "`inspect` prints where the openings are; close the mesh (--close-holes), or export the solid",
        );
    }
    if t.inconsistent_edges > 0 || part.mesh.volume_mm3() <= 0.0 {
        let wrong = match t.inconsistent_edges {
            0 => String::new(),
            n => format!(": the facets at {n} edges wind against one another"),
        };
        return refuse(
            format!("the part encloses no volume, its surface is inside out or folded on itself{wrong}"),
            "export the solid, with normals that point outwards",
        );
    }
    Ok(())
}

/// A place on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlace {
    /// Where, mm.
    pub point: Point,
    /// Outward unit normal.
    pub normal: Vector,
}

impl SurfacePlace {
    /// Centre of a ball inside the part that is tangent there.
    fn inside(&self, radius_mm: f64) -> Point {
        self.point - self.normal * radius_mm
    }

    /// Distance of the normal line here from that at another place, mm.
    pub fn lines_apart_mm(&self, other: &SurfacePlace) -> f64 {
        let across = self.normal.cross(&other.normal);
        let between = other.point - self.point;
        // Parallel lines have no common perpendicular.
        match across.norm() {
            s if s > 1e-6 => (between.dot(&across) / s).abs(),
            _ => between.cross(&self.normal).norm(),
        }
    }
}

/// Two places that face each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The place that a partner was sought for.
    pub first: SurfacePlace,
    /// Its partner.
    pub second: SurfacePlace,
    /// Face or group of the second place.
    pub face: u32,
    /// Triangle of the second place, where the part is a mesh.
    pub triangle: Option<u32>,
    /// Centre of the greatest ball inside the part that touches at the first place.
    pub centre: Point,
    /// Its radius, mm.
    pub radius_mm: f64,
}

impl Pair {
    /// The angle β by which the normals are not opposite, radians.
    pub fn angle_rad(&self) -> f64 {
        // Of the sum, since a cosine near −1 says little.
        let sum = (self.first.normal + self.second.normal).norm();
        2.0 * (0.5 * sum).clamp(0.0, 1.0).asin()
    }

    /// Distance of the two normal lines, by the surface's own normals, mm.
    pub fn apart_mm(&self) -> f64 {
        self.first.lines_apart_mm(&self.second)
    }
}

/// The partner of a place; `within_mm`: no ball inside the part is larger. `None`: the ball touches
/// nowhere else, or is outside the part.
pub fn partner(part: &Part, first: SurfacePlace, within_mm: f64) -> Option<Pair> {
    partner_across_creases(part, first, within_mm, 0.0)
}

/// The partner of a place whose ball may hold of the part, besides [`HELD_MM`], a share of its
/// radius: beside a crease between two faces of one wall, where the ball that is tangent to one of
/// them is cut by the other, it is the partner across the wall still. Both normals pass through the
/// ball's centre as those of any pair.
pub fn partner_across_creases(part: &Part, first: SurfacePlace, within_mm: f64, held_share: f64) -> Option<Pair> {
    // A ball that touches there is no larger than the surface bends.
    let bent = part.closest(&first.point, ON_MM).and_then(|at| part.curvature_at(&at));
    let round_mm = bent.map(|p| -1.0 / p.curvature[1]).filter(|r| *r > 0.0 && *r < within_mm);
    let is_round = |radius_mm: f64| round_mm.is_some_and(|r| radius_mm >= r * (1.0 - LOOSE));
    let start_mm = round_mm.unwrap_or(within_mm);
    let (rough, radius_mm) = shrunk(part, &first, start_mm, held_share, &is_round)?;
    let centre = |radius: f64| first.inside(radius);
    // Far enough that what the ball may hold beside the first place is not nearest.
    let beyond = BEYOND.max(2.0 * held_share);
    let from = |share: f64| {
        let from = centre(radius_mm * (1.0 + share * beyond));
        let near = part.closest(&from, (rough.point - from).norm() * (1.0 + LOOSE))?;
        // Of a place that has none beside it the first place itself is the nearest.
        ((near.point - rough.point).norm() < 0.5 * (near.point - first.point).norm()).then_some(near)
    };
    let (one, two) = (from(1.0)?, from(2.0)?);
    let second = part.closest(&(one.point + (one.point - two.point)), f64::INFINITY)?;
    let arm = first.point - second.point;
    let off = first.normal.dot(&arm);
    if arm.norm() < 2.0 * ONE_PLACE * radius_mm || !(off > 0.0) {
        return None;
    }
    let radius_mm = arm.norm_squared() / (2.0 * off);
    if is_round(radius_mm) {
        return None;
    }
    let centre = centre(radius_mm);
    let held = part.closest(&centre, radius_mm * (1.0 - held_share) - HELD_MM).is_some();
    let inside = part.inside(&centre);
    let place = SurfacePlace { point: second.point, normal: second.normal };
    (inside && !held).then_some(Pair {
        first,
        second: place,
        face: second.face,
        triangle: second.triangle,
        centre,
        radius_mm,
    })
}

/// The place that a ball comes to rest on as it shrinks from a radius on, tangent at the first
/// place, and its radius then, mm. `None` where there is none, or the ball is that of the
/// curvature.
fn shrunk(
    part: &Part,
    first: &SurfacePlace,
    start_mm: f64,
    held_share: f64,
    is_round: &dyn Fn(f64) -> bool,
) -> Option<(Closest, f64)> {
    let (mut radius_mm, mut beside, mut last) = (start_mm, LOOSE, None);
    for _ in 0..STEPS {
        // Of two places that are as near, which one is nearer is dear to tell. So a place has to be
        // nearer than the first one by a share of the radius. The share falls as the ball comes to
        // rest: while that is much too large any place well inside it makes it smaller.
        let share = beside.max(held_share);
        let found = part.closest_within(&first.inside(radius_mm), radius_mm * (1.0 - share), share * radius_mm);
        let Some(near) = found else {
            if share <= SAME.max(held_share) || is_round(radius_mm) {
                break;
            }
            beside = (beside * TIGHTER).max(SAME);
            continue;
        };
        let arm = first.point - near.point;
        let off = first.normal.dot(&arm);
        if arm.norm() < ONE_PLACE * radius_mm {
            break;
        }
        if !(off > 0.0) {
            return None;
        }
        let smaller = arm.norm_squared() / (2.0 * off);
        last = Some(near);
        let change = 1.0 - smaller / radius_mm;
        if !(change > SAME) {
            break;
        }
        radius_mm = smaller;
        if change < SETTLED {
            break;
        }
        beside = beside.min(change * change).max(SAME);
    }
    last.filter(|_| !is_round(radius_mm)).map(|near| (near, radius_mm))
}

#[cfg(test)]
mod tests;
