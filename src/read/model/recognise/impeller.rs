//! One blade of a wheel whose hub turns from along the rotor axis to across it: an impeller.
//!
//! In: the mesh of a whole wheel. Out: the surface of one blade, and heights from the hub to the
//! tips ([`crate::artifact::meridian`]). Amid its height and its length the blade is met on a
//! circle about the rotor axis. From both its sides there the surface is followed as far as it
//! faces round the axis, which the hub and turned tips do not.

use super::contours::{HalfPlanes, Place};
use super::one_blade::datum;
use super::wheel::Wheel;
use super::words;
use crate::artifact::along::Along;
use crate::artifact::meridian::Meridian;
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::{Mesh, edge_uses};
use crate::geometry::{Point, Rigid, Vector};

/// A facet is of a blade where its normal has this part round the rotor axis (sine): hub and tips
/// are turned, and their facets stand up to this much round the axis.
const STANDS: f64 = 0.1;
/// The hub turns by this along the blades, degrees: that of an axial wheel is a cone at most, whose
/// blades stand along an axis.
const TURNS_DEG: f64 = 30.0;
/// It is looked at over this share of its contour at either end.
const END: f64 = 0.2;
/// The blade in hand is one whose surface is this share of the largest.
const LARGEST: f64 = 0.9;
/// The surface of one blade is no larger than this share of the wheel's repeat.
const WHOLE_REPEAT: f64 = 0.95;

/// A blade over a hub that turns.
pub struct ImpellerBlade {
    /// Blade frame to model frame: x away from the rotor axis through the middle of the blade.
    pub model_from_blade: Rigid,
    /// Heights, blade frame.
    pub along: Along,
    /// Its triangles, by numbers from 0 that rise.
    pub triangles: Vec<u32>,
    /// How axis and heights were found, one sentence each.
    pub reasons: Vec<String>,
}

/// The blade towards `axis`, or of the longest the one nearest to a coordinate axis. `None` where
/// the wheel has no blades between a hub that turns and free tips.
pub fn blade(mesh: &Mesh, wheel: &Wheel, axis: Option<[f64; 3]>) -> Option<ImpellerBlade> {
    let planes = HalfPlanes::new(mesh, wheel);
    let contours = planes.contours()?;
    if turning_deg(&contours.hub) < TURNS_DEG {
        return None;
    }
    let in_model = Meridian::new(wheel.axis, wheel.through, &contours.hub, &contours.tip)?;
    let amid: Place = {
        let [foot, head] = [0, 1].map(|which| in_model.contour(which, 3)[1]);
        [0.5 * (foot[0] + head[0]), 0.5 * (foot[1] + head[1])]
    };
    let surface = Surface::new(mesh, wheel);
    let repeats = wheel.fold.max(1);
    let found = planes.blades(amid);
    let sides = |[from, to]: [f64; 2], repeat: usize| {
        [from, to].map(|angle| planes.point(amid, angle + planes.repeat_rad() * repeat as f64))
    };
    let sized: Vec<([f64; 2], f64)> =
        found.iter().map(|b| (*b, surface.area_mm2(&surface.from(&sides(*b, 0))))).collect();
    let largest = sized.iter().map(|s| s.1).fold(0.0, f64::max);
    let candidates = sized.iter().filter(|s| axis.is_some() || s.1 >= LARGEST * largest);
    let all = candidates.flat_map(|s| (0..repeats).map(move |k| (s.0, k)));
    let wanted = axis.map_or_else(|| datum(wheel), Vector::from);
    let off = |(b, k): &([f64; 2], usize)| {
        let angle = 0.5 * (b[0] + b[1]) + planes.repeat_rad() * *k as f64 - planes.angle(&wanted);
        angle.cos()
    };
    let (blade, repeat) = all.max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let triangles = surface.from(&sides(blade, repeat));
    let area_mm2 = surface.area_mm2(&triangles);
    if triangles.is_empty() || area_mm2 > WHOLE_REPEAT * mesh.area_mm2() / repeats as f64 {
        return None;
    }
    let middle = surface.middle(&triangles);
    let foot = wheel.through + wheel.axis * wheel.axis.dot(&(middle - wheel.through));
    let out = (middle - foot).try_normalize(1e-9)?;
    let rotation = super::run::frame_along(&out).rotation;
    let model_from_blade = Rigid::from_parts(foot.into(), rotation);
    let blade_from_model = model_from_blade.inverse();
    let (axis, origin) = (blade_from_model * wheel.axis, blade_from_model * wheel.through);
    let along = Along::over_hub(Meridian::new(axis, origin, &contours.hub, &contours.tip)?);
    let reasons = vec![
        format!(
            "axis: {}, away from the rotor axis through the middle of a blade: its hub turns from along the rotor axis to across it",
            words(&out)
        ),
        format!("heights: from the hub, 0, to the tips, {:.3} mm in the mean", in_model.tip_mm()),
        format!("airfoil: {} triangles that stand round the rotor axis, {area_mm2:.1} mm²", triangles.len()),
    ];
    Some(ImpellerBlade { model_from_blade, along, triangles, reasons })
}

/// How far a contour turns from its one end to the other, degrees.
fn turning_deg(contour: &[Place]) -> f64 {
    let n = contour.len();
    let part = ((END * n as f64) as usize).clamp(1, n - 1);
    let way = |a: Place, b: Place| Vector::new(b[0] - a[0], b[1] - a[1], 0.0);
    way(contour[0], contour[part]).angle(&way(contour[n - 1 - part], contour[n - 1])).to_degrees()
}

/// The wheel's surface as far as it stands round the rotor axis.
struct Surface<'a> {
    mesh: &'a Mesh,
    bvh: MeshBvh,
    stands: Vec<bool>,
    /// Pairs of triangles that share an edge, sorted.
    beside: Vec<[u32; 2]>,
}

impl<'a> Surface<'a> {
    fn new(mesh: &'a Mesh, wheel: &Wheel) -> Self {
        let stands = |t: usize| {
            let [a, b, c] = mesh.corners(t);
            let v = Point::from((a.coords + b.coords + c.coords) / 3.0) - wheel.through;
            let round = wheel.axis.cross(&v).try_normalize(1e-9);
            round.is_some_and(|round| mesh.normal(t).dot(&round).abs() > STANDS)
        };
        let mut beside = Vec::new();
        for uses in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge) {
            for a in uses {
                beside.extend(uses.iter().filter(|b| b.triangle != a.triangle).map(|b| [a.triangle, b.triangle]));
            }
        }
        beside.sort_unstable();
        Surface { mesh, bvh: MeshBvh::new(mesh), stands: (0..mesh.triangles.len()).map(stands).collect(), beside }
    }

    /// The triangles that hang together with those next to some points.
    fn from(&self, points: &[Point]) -> Vec<u32> {
        let near = points.iter().filter_map(|p| self.bvh.closest(self.mesh, p, f64::INFINITY).map(|n| n.triangle));
        let mut open: Vec<u32> = near.filter(|t| self.stands[*t as usize]).collect();
        let mut seen = vec![false; self.mesh.triangles.len()];
        open.iter().for_each(|t| seen[*t as usize] = true);
        let mut out = Vec::new();
        while let Some(t) = open.pop() {
            out.push(t);
            let from = self.beside.partition_point(|pair| pair[0] < t);
            for [_, next] in self.beside[from..].iter().take_while(|pair| pair[0] == t) {
                if self.stands[*next as usize] && !seen[*next as usize] {
                    seen[*next as usize] = true;
                    open.push(*next);
                }
            }
        }
        out.sort_unstable();
        out.dedup();
        out
    }

    fn area_mm2(&self, triangles: &[u32]) -> f64 {
        triangles.iter().map(|t| self.mesh.triangle_area_mm2(*t as usize)).sum()
    }

    /// Middle of some surface.
    fn middle(&self, triangles: &[u32]) -> Point {
        let weighed = triangles.iter().map(|t| {
            let [a, b, c] = self.mesh.corners(*t as usize);
            (a.coords + b.coords + c.coords) * (self.mesh.triangle_area_mm2(*t as usize) / 3.0)
        });
        Point::from(weighed.sum::<Vector>() / self.area_mm2(triangles).max(f64::MIN_POSITIVE))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::read::model::recognise::wheel::wheel;
    use crate::sample::{IMPELLER_BLADES, impeller, impeller_contour};

    /// Distance of a place from a contour of the sample, mm.
    fn off_mm(which: usize, q: &Place) -> f64 {
        let places = (0..=2000).map(|k| impeller_contour(which, f64::from(k) / 2000.0));
        places.map(|p| (p[0] - q[0]).hypot(p[1] - q[1])).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn contours_and_one_blade_of_an_impeller_are_found_wherever_it_stands() {
        let aside = Rigid::new(Vector::new(100.0, -30.0, 7.0), Vector::new(0.4, 1.1, -0.3));
        for place in [Rigid::identity(), aside] {
            let mesh = impeller().moved(&place);
            assert!(mesh.volume_mm3() > 0.0);
            let found = wheel(&mesh).expect("a wheel");
            assert_eq!(found.blades, IMPELLER_BLADES as usize);
            let contours = HalfPlanes::new(&mesh, &found).contours().expect("contours");
            // Along the axis from where the wheel was found to stand, in its sense.
            let origin = found.axis.dot(&(place * Point::origin() - found.through));
            let sense = found.axis.dot(&(place * Vector::z())).signum();
            for (which, contour) in [&contours.hub, &contours.tip].into_iter().enumerate() {
                // Half-planes meet the blunt ends of blades here and there.
                let amid = contour.len() / 8;
                let off = contour[amid..contour.len() - amid]
                    .iter()
                    .map(|[along, radius]| off_mm(which, &[(along - origin) * sense, *radius]));
                let off = off.fold(0.0, f64::max);
                assert!(off < 0.1, "contour {which} is {off} mm off");
            }
            let one = blade(&mesh, &found, None).expect("a blade");
            // Any blade can be asked for.
            for k in [0, 4] {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(IMPELLER_BLADES) + 0.5;
                let towards = place * Vector::new(angle.cos(), angle.sin(), 0.0);
                let asked = blade(&mesh, &found, Some(towards.into())).unwrap();
                let off = (asked.model_from_blade * Vector::x()).angle(&towards).to_degrees();
                assert!(off < 10.0, "{off} degrees off");
                let sizes = [one.triangles.len() as f64, asked.triangles.len() as f64];
                assert!((sizes[0] / sizes[1] - 1.0).abs() < 0.05, "{sizes:?}");
            }
            // Heights: 0 on the hub, those of the tips at the tips.
            let meridian = one.along.round().unwrap();
            let blade_from_model = one.model_from_blade.inverse() * place;
            let at = |which: usize, t: f64| {
                let [z, r] = impeller_contour(which, t);
                meridian.height_mm(&(blade_from_model * Point::new(r * 0.6, r * 0.8, z)))
            };
            for t in [0.2, 0.5, 0.8] {
                assert!(at(0, t).abs() < 0.15, "{}", at(0, t));
                assert!((at(1, t) - meridian.tip_mm()).abs() < 0.15, "{} {}", at(1, t), meridian.tip_mm());
            }
        }
    }

    #[test]
    fn a_wheel_with_a_straight_hub_is_no_impeller() {
        let (plates, _) = crate::sample::plates(12, 2.0);
        let mesh = &plates.part.mesh;
        let found = wheel(mesh).expect("a wheel");
        assert!(blade(mesh, &found, None).is_none());
    }
}
