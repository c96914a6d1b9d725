//! Points of the part's surface, evenly by area, near the path.

use super::sweep::Sweep;
use crate::geometry::allowance::Allowed;
use crate::geometry::measured::Closest;
use crate::geometry::mesh::topology;
use crate::geometry::part::Part;
use crate::geometry::triangle::area_mm2;
use crate::geometry::{Point, Vector};
use crate::parallel;

/// A point of the surface with its outward unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The point.
    pub point: Point,
    /// Outward unit normal.
    pub normal: Vector,
    /// The place on the exact face, where the part has them.
    pub on_face: Option<Closest>,
}

/// Points of the surface that stand for equal areas.
pub(super) struct Samples {
    /// The points.
    pub points: Vec<Sample>,
    /// Area that each of them stands for, mm².
    pub area_mm2: f64,
}

/// A sample is hidden where a place so far over it is inside the part, mm, besides what the mesh is
/// off.
const HIDDEN_MM: f64 = 1e-3;

/// A piece of a mesh triangle.
#[derive(Clone, Copy)]
struct TrianglePiece {
    triangle: usize,
    corners: [Point; 3],
}

impl TrianglePiece {
    fn area(&self) -> f64 {
        area_mm2(&self.corners)
    }
    fn middle(&self) -> Point {
        let [a, b, c] = self.corners;
        a + ((b - a) + (c - a)) / 3.0
    }
    fn reach(&self) -> f64 {
        let m = self.middle();
        self.corners.iter().map(|c| (c - m).norm()).fold(0.0, f64::max)
    }
    /// Halves across the longest edge.
    fn halves(&self) -> [TrianglePiece; 2] {
        let c = self.corners;
        let lengths = [(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()];
        let k = (0..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best });
        let (a, b, opposite) = (c[k], c[(k + 1) % 3], c[(k + 2) % 3]);
        let mid = a + (b - a) * 0.5;
        let piece = |corners| TrianglePiece { triangle: self.triangle, corners };
        [piece([a, mid, opposite]), piece([mid, b, opposite])]
    }
}

/// About `count` points, evenly by area over the pieces of the part whose ball centres could lie
/// within `reach_mm` of the path. Deterministic: a low-discrepancy sequence (Roberts' R2, 2018)
/// runs over all pieces in order. Where the part is NURBS, each point is moved to the exact
/// surface, with the exact normal there.
pub(super) fn near_path(part: &Allowed, sweep: &Sweep, reach_mm: f64, count: usize) -> Samples {
    let pieces: Vec<TrianglePiece> =
        parallel::flat_map(0..part.mesh.triangles.len(), |t| pieces_near(part, sweep, reach_mm, t));
    let area: f64 = pieces.iter().map(TrianglePiece::area).sum();
    if !(area > 0.0) || count == 0 {
        return Samples { points: Vec::new(), area_mm2: 0.0 };
    }
    let spacing = area / count as f64;
    let mut raw = Vec::with_capacity(count);
    let (mut sum, mut next) = (0.0, 0.5 * spacing);
    for piece in &pieces {
        sum += piece.area();
        while next < sum && raw.len() < count {
            let k = raw.len() as f64;
            let (mut u, mut v) =
                ((0.5 + 0.754_877_666_246_692_8 * k).fract(), (0.5 + 0.569_840_290_998_053_2 * k).fract());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let [a, b, c] = piece.corners;
            raw.push((piece.triangle, a + (b - a) * u + (c - a) * v));
            next += spacing;
        }
    }
    let (by_facets, may_hide) = (part.brep.is_none(), has_several_bodies(part));
    let counts = |s: &Sample| sweep.is_for(&s.point, &s.normal, by_facets) && !(may_hide && is_hidden(part, s));
    let sample = |(t, p)| on_surface(part, t, p).filter(|s| !sweep.is_beside(part, t) && counts(s));
    let points = parallel::filter_map(raw, sample);
    Samples { points, area_mm2: spacing }
}

/// Whether the part is several closed bodies, which may reach into one another: blades that were
/// drawn into their hub, say, and never joined with it.
fn has_several_bodies(part: &Part) -> bool {
    let found = topology(&part.mesh);
    found.components > 1 && found.closed()
}

/// Whether a sample lies within another body, or on one: nothing is left standing there.
fn is_hidden(part: &Allowed, sample: &Sample) -> bool {
    let over = sample.point + sample.normal * (HIDDEN_MM + 2.0 * part.deflection_mm);
    part.bvh.winding(&part.mesh, &over).is_some_and(|times| times > 0)
}

/// The pieces of a triangle that lie near the path, none much larger than `reach_mm`.
fn pieces_near(part: &Allowed, sweep: &Sweep, reach_mm: f64, triangle: usize) -> Vec<TrianglePiece> {
    let normal = part.mesh.normal(triangle);
    // On a curved face the normals of a facet's points differ from the facet's own.
    let slack = if part.brep.is_some() { 0.5 * sweep.radius_mm } else { 0.0 };
    let mut open = vec![TrianglePiece { triangle, corners: part.mesh.corners(triangle) }];
    let mut near = Vec::new();
    while let Some(piece) = open.pop() {
        let (middle, size) = (piece.middle() + normal * (sweep.radius_mm + part.stock_mm), piece.reach());
        if normal.norm_squared() == 0.0 || sweep.nearest(&middle, reach_mm + size + slack, |_| true).is_none() {
            continue;
        }
        if size > 2.0 * reach_mm { open.extend(piece.halves()) } else { near.push(piece) }
    }
    near
}

fn on_surface(part: &Allowed, triangle: usize, p: Point) -> Option<Sample> {
    if part.brep.is_none() {
        let normal = part.mesh.normal(triangle);
        return Some(Sample { point: p + normal * part.stock_mm, normal, on_face: None });
    }
    let face: &Part = part;
    let exact = face.closest(&p, 4.0 * part.deflection_mm + 1e-6)?;
    Some(Sample { point: exact.point + exact.normal * part.stock_mm, normal: exact.normal, on_face: Some(exact) })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::region::{Area, Patch, Region};
    use crate::sample::{impeller, impeller_contour};

    /// What the ball comes near to on the platform beside a blade is not looked at.
    #[test]
    fn the_platform_beside_a_path_has_no_samples() {
        let mut blade = crate::sample::blade();
        let mesh = &blade.part.mesh;
        let top: Vec<u32> = (0..mesh.triangles.len() as u32).filter(|t| mesh.normal(*t as usize).x > 0.9).collect();
        let [height_mm, wide_mm] = [0, 1].map(|k| mesh.points.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max));
        let centres: Vec<Point> = (0..=60)
            .map(|k| (f64::from(k) * 0.1).sin_cos())
            .map(|(s, c)| Point::new(height_mm + 2.0, 0.5 * wide_mm * c, 0.5 * wide_mm * s))
            .collect();
        let sweep = || Sweep::of(centres.clone(), centres.clone(), vec![0; 61], 2.0, None);
        let count = |sweep: Sweep, blade: &crate::artifact::Blade| {
            near_path(&Allowed::new(&blade.part, 0.0), &sweep, 1.0, 300).points.len()
        };
        let bare = count(sweep().round(&blade), &blade);
        blade.regions.list.retain(|r| r.area != Area::Platform);
        blade.regions.list.push(Region { patch: Patch::Facets(top), ..Region::between(Area::Platform, None, None) });
        assert!(bare > 250, "{bare}");
        assert_eq!(count(sweep().round(&blade), &blade), 0);
    }

    /// Blades that reach into their hub hide what of it is under them, and their own roots.
    #[test]
    fn surface_within_another_body_is_hidden() {
        let mut mesh = crate::geometry::mesh::weld(&impeller(), 1e-6);
        crate::geometry::boundary::close(&mut mesh, f64::INFINITY, 1);
        let part = Part::from_mesh(mesh);
        assert!(has_several_bodies(&part));
        let part = Allowed::new(&part, 0.0);
        // Amid the length of a blade, at an angle from it, so far off the hub; facing round or out.
        let hidden = |angle: f64, share: f64, faces_out: bool| {
            let [foot, head] = [0, 1].map(|which| impeller_contour(which, 0.5));
            let [z, r] = [0, 1].map(|k| foot[k] + (head[k] - foot[k]) * share);
            let (s, c) = (0.5 + angle).sin_cos();
            let out = Vector::new(c * (head[1] - foot[1]), s * (head[1] - foot[1]), head[0] - foot[0]).normalize();
            let round = Vector::new(-s, c, 0.0);
            let normal = if faces_out { out } else { round };
            is_hidden(&part, &Sample { point: Point::new(r * c, r * s, z), normal, on_face: None })
        };
        let half = 1.0 / impeller_contour(0, 0.5)[1];
        assert!(hidden(0.0, 0.01, true) && hidden(0.5 * half, 0.01, true), "hub under the blade");
        assert!(!hidden(6.0 * half, 0.01, true), "hub between two blades");
        assert!(hidden(1.1 * half, -0.02, false), "root in the hub");
        assert!(!hidden(1.1 * half, 0.3, false), "side of the blade");
    }
}
