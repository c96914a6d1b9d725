//! One blade of a wheel whose hub turns from along the rotor axis to across it: an impeller.
//!
//! In: the mesh of a whole wheel or of one sector. Out: the surface of one blade, and heights from
//! the hub to the tips ([`crate::artifact::meridian`]). Amid its height and its length the blade is
//! met on a circle about the rotor axis. From both its sides there the surface is followed as far
//! as it faces round the axis, which the hub and turned tips do not. Blunt edges come with it. Of a
//! sector that is a blade which its sides do not cut.

use std::f64::consts::TAU;

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
/// A blade that half-planes meet is on the model within this share of the distance from the rotor
/// axis: so far they are apart.
const ON_MODEL: f64 = 0.02;

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

/// The blade towards `axis`, or of the longest the one nearest to a coordinate axis. `is_sector`:
/// the mesh is one sector of the wheel. `None` where the wheel has no blades between a hub that
/// turns and free tips.
pub fn blade(mesh: &Mesh, wheel: &Wheel, is_sector: bool, axis: Option<[f64; 3]>) -> Option<ImpellerBlade> {
    let planes = HalfPlanes::new(mesh, wheel, is_sector);
    let surface = Surface::new(mesh, wheel);
    let met = |q: Place| met(&planes, &surface, q, is_sector);
    let grid = planes.grid();
    let largest = met(grid.deepest()?).into_iter().max_by(|a, b| a.area_mm2.total_cmp(&b.area_mm2))?;
    let contours = grid.contours(&planes.silhouette(mesh, &largest.triangles))?;
    if turning_deg(&contours.hub) < TURNS_DEG {
        return None;
    }
    let in_model = Meridian::new(wheel.axis, wheel.through, &contours.hub, &contours.tip)?;
    let amid: Place = {
        let [foot, head] = [0, 1].map(|which| in_model.contour(which, 3)[1]);
        [0.5 * (foot[0] + head[0]), 0.5 * (foot[1] + head[1])]
    };
    let found = met(amid);
    let largest_mm2 = found.iter().map(|m| m.area_mm2).fold(0.0, f64::max);
    let candidates = found.into_iter().filter(|m| axis.is_some() || m.area_mm2 >= LARGEST * largest_mm2);
    let wanted = axis.map_or_else(|| datum(wheel), Vector::from);
    let off = |m: &Met| (m.angle_rad - planes.angle(&wanted)).cos();
    let Met { triangles, .. } = candidates.max_by(|a, b| off(a).total_cmp(&off(b)))?;
    let triangles = surface.with_edges(triangles, &in_model);
    let area_mm2 = surface.area_mm2(&triangles);
    let repeats = if is_sector { 1 } else { wheel.fold.max(1) };
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
        format!(
            "airfoil: {} triangles that stand round the rotor axis or are its edges, {area_mm2:.1} mm²",
            triangles.len()
        ),
    ];
    Some(ImpellerBlade { model_from_blade, along, triangles, reasons })
}

/// A blade that is met at a place of the half-plane.
struct Met {
    /// Angle of its middle there, rad.
    angle_rad: f64,
    triangles: Vec<u32>,
    area_mm2: f64,
}

/// The blades at a place, those of every repeat of the wheel; of a sector those that it has.
fn met(planes: &HalfPlanes, surface: &Surface, q: Place, is_sector: bool) -> Vec<Met> {
    let repeats = (TAU / planes.repeat_rad()).round() as usize;
    let blades = planes.blades(q);
    let all = blades.iter().flat_map(|b| (0..repeats).map(move |k| b.map(|a| a + planes.repeat_rad() * k as f64)));
    let met = |angles: [f64; 2]| {
        let sides = angles.map(|angle| planes.point(q, angle));
        if is_sector && !surface.has(&sides, ON_MODEL * q[1]) {
            return None;
        }
        let triangles = surface.from(&sides);
        let area_mm2 = surface.area_mm2(&triangles);
        Some(Met { angle_rad: 0.5 * (angles[0] + angles[1]), triangles, area_mm2 })
    };
    all.filter_map(met).collect()
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

    /// Whether all of some points are near.
    fn has(&self, points: &[Point], within_mm: f64) -> bool {
        points.iter().all(|p| self.bvh.closest(self.mesh, p, within_mm).is_some())
    }

    /// The triangles that hang together with those next to some points.
    fn from(&self, points: &[Point]) -> Vec<u32> {
        let near = points.iter().filter_map(|p| self.bvh.closest(self.mesh, p, f64::INFINITY).map(|n| n.triangle));
        self.spread(near.collect(), |t| self.stands[t as usize])
    }

    /// Some triangles and what hangs together with them of the blade's blunt edges.
    fn with_edges(&self, triangles: Vec<u32>, meridian: &Meridian) -> Vec<u32> {
        let own = triangles.clone();
        self.spread(triangles, |t| {
            let [a, b, c] = self.mesh.corners(t as usize);
            let middle = Point::from((a.coords + b.coords + c.coords) / 3.0);
            own.binary_search(&t).is_ok() || meridian.is_edge(&middle, &self.mesh.normal(t as usize))
        })
    }

    /// Those of some triangles that count, and all that count and hang together with them.
    fn spread(&self, from: Vec<u32>, counts: impl Fn(u32) -> bool) -> Vec<u32> {
        let mut open: Vec<u32> = from.into_iter().filter(|t| counts(*t)).collect();
        let mut seen = vec![false; self.mesh.triangles.len()];
        open.iter().for_each(|t| seen[*t as usize] = true);
        let mut out = Vec::new();
        while let Some(t) = open.pop() {
            out.push(t);
            let from = self.beside.partition_point(|pair| pair[0] < t);
            for [_, next] in self.beside[from..].iter().take_while(|pair| pair[0] == t) {
                if !seen[*next as usize] && counts(*next) {
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
    use crate::read::model::recognise::contours::Contours;
    use crate::read::model::recognise::sector::sector;
    use crate::read::model::recognise::wheel::wheel;
    use crate::sample::{IMPELLER_BLADES, add_impeller_blade, add_tube};
    use crate::sample::{impeller, impeller_contour, impeller_hub, impeller_sector};

    /// Distance of a place from a contour of the sample, mm.
    fn off_mm(which: usize, q: &Place) -> f64 {
        let places = (0..=2000).map(|k| impeller_contour(which, f64::from(k) / 2000.0));
        places.map(|p| (p[0] - q[0]).hypot(p[1] - q[1])).fold(f64::INFINITY, f64::min)
    }

    /// The contours that [`blade`] goes by.
    fn contours_of(mesh: &Mesh, found: &Wheel) -> Option<Contours> {
        let planes = HalfPlanes::new(mesh, found, false);
        let grid = planes.grid();
        let met = met(&planes, &Surface::new(mesh, found), grid.deepest()?, false);
        grid.contours(&planes.silhouette(mesh, &met[0].triangles))
    }

    #[test]
    fn contours_and_one_blade_of_an_impeller_are_found_wherever_it_stands() {
        let aside = Rigid::new(Vector::new(100.0, -30.0, 7.0), Vector::new(0.4, 1.1, -0.3));
        for place in [Rigid::identity(), aside] {
            let mesh = impeller().moved(&place);
            assert!(mesh.volume_mm3() > 0.0);
            let found = wheel(&mesh).expect("a wheel");
            assert_eq!(found.blades, IMPELLER_BLADES as usize);
            let contours = contours_of(&mesh, &found).expect("contours");
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
            let one = blade(&mesh, &found, false, None).expect("a blade");
            // Any blade can be asked for.
            for k in [0, 4] {
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(IMPELLER_BLADES) + 0.5;
                let towards = place * Vector::new(angle.cos(), angle.sin(), 0.0);
                let asked = blade(&mesh, &found, false, Some(towards.into())).unwrap();
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

    /// An impeller whose disc is cut out between the blades from a place of its contour on: there
    /// it is a plate under each of them.
    fn scalloped(from: f64) -> Mesh {
        let mut mesh = impeller_hub();
        let r_end = impeller_contour(0, from)[1];
        for p in &mut mesh.points {
            let less = (r_end / p.x.hypot(p.y)).min(1.0);
            (p.x, p.y) = (p.x * less, p.y * less);
        }
        for blade in 0..IMPELLER_BLADES {
            let turn = TAU * f64::from(blade) / f64::from(IMPELLER_BLADES);
            add_impeller_blade(&mut mesh, turn);
            let line = |u: f64, below: [f64; 2]| -> Vec<Point> {
                let place = |k: u32, below: f64| {
                    let t = from - 0.02 + (1.02 - from) * f64::from(k) / 12.0;
                    let ([z, r], angle) = (impeller_contour(0, t), turn + t + 0.2 * u);
                    Point::new(r * angle.cos(), r * angle.sin(), z - below)
                };
                (0..=12).map(|k| place(k, below[0])).chain((0..=12).rev().map(|k| place(k, below[1]))).collect()
            };
            let mut rings = vec![line(-1.0, [0.5; 2])];
            rings.extend((0..9).map(|k| line(f64::from(k) / 4.0 - 1.0, [0.0, 1.0])));
            rings.push(line(1.0, [0.5; 2]));
            add_tube(&mut mesh, &rings);
        }
        mesh
    }

    #[test]
    fn a_disc_that_is_cut_out_between_blades_is_hub() {
        let mesh = scalloped(0.7);
        let found = wheel(&mesh).expect("a wheel");
        let hub = contours_of(&mesh, &found).expect("contours").hub;
        let (origin, sense) = (found.axis.dot(&-found.through.coords), found.axis.z.signum());
        let off = hub[..hub.len() - 2].iter().map(|[along, r]| off_mm(0, &[(along - origin) * sense, *r]));
        let off = off.fold(0.0, f64::max);
        let most = hub.iter().map(|p| p[1]).fold(0.0, f64::max);
        assert!(off < 0.3 && most > 59.0, "{off} mm off, up to radius {most}");
        assert!(blade(&mesh, &found, false, None).is_some());
    }

    #[test]
    fn one_sector_tells_the_heights_that_the_whole_impeller_tells() {
        let whole = impeller();
        let of_whole = blade(&whole, &wheel(&whole).expect("a wheel"), false, None).expect("a blade");
        // The blade's own triangles, without its ends and those under the hub.
        let area_mm2 = |mesh: &Mesh, blade: &ImpellerBlade| -> f64 {
            blade.triangles.iter().map(|t| mesh.triangle_area_mm2(*t as usize)).sum()
        };
        for turn in [0.0, 0.3, 2.5, 6.2] {
            let mesh = impeller_sector().moved(&Rigid::rotation(Vector::z() * turn));
            assert!(mesh.volume_mm3() > 0.0);
            let found = sector(&mesh).expect("a sector");
            assert_eq!(found.blades, IMPELLER_BLADES as usize);
            let planes = HalfPlanes::new(&mesh, &found, true);
            let amid = planes.grid().deepest().expect("a place");
            assert_eq!(met(&planes, &Surface::new(&mesh, &found), amid, true).len(), 1);
            let one = blade(&mesh, &found, true, None).expect("a blade");
            let shares = area_mm2(&mesh, &one) / area_mm2(&whole, &of_whole);
            assert!((shares - 1.0).abs() < 1e-9, "{shares}");
            let middle = one.model_from_blade * Vector::x();
            let wanted = Rigid::rotation(Vector::z() * turn) * Vector::new(0.6f64.cos(), 0.6f64.sin(), 0.0);
            assert!(middle.angle(&wanted).to_degrees() < 5.0, "{middle} {wanted}");
            let meridians = [&one, &of_whole].map(|b| (b.along.round().unwrap(), b.model_from_blade.inverse()));
            for which in [0, 1] {
                for t in [0.1, 0.5, 0.9] {
                    let [z, r] = impeller_contour(which, t);
                    let [own, theirs] = meridians.map(|(m, place)| m.height_mm(&(place * Point::new(r, 0.0, z))));
                    assert!((own - theirs).abs() < 0.1, "{which} {t}: {own} {theirs}");
                }
            }
        }
    }

    #[test]
    fn a_blade_that_the_sides_of_its_sector_cut_is_none() {
        // Half of one blade, and half of the next.
        let mesh = impeller_sector();
        let half = |mesh: &Mesh, first: bool| {
            let kept = |t: &&[u32; 3]| {
                let p = mesh.points[t[0] as usize];
                let angle = p.y.atan2(p.x);
                (angle > 0.6) == first
            };
            Mesh { triangles: mesh.triangles.iter().filter(kept).copied().collect(), ..mesh.clone() }
        };
        let pitch = std::f64::consts::TAU / f64::from(IMPELLER_BLADES);
        let next = mesh.clone().moved(&Rigid::rotation(Vector::z() * pitch));
        let mut both = half(&mesh, true);
        let (other, n) = (half(&next, false), both.points.len() as u32);
        both.points.extend(&other.points);
        both.triangles.extend(other.triangles.iter().map(|t| t.map(|p| p + n)));
        let found = sector(&mesh).expect("a sector");
        let planes = HalfPlanes::new(&both, &found, true);
        let amid = planes.grid().deepest().expect("a place");
        assert!(met(&planes, &Surface::new(&both, &found), amid, true).is_empty());
        assert!(blade(&both, &found, true, None).is_none());
    }

    #[test]
    fn a_wheel_with_a_straight_hub_is_no_impeller() {
        let (plates, _) = crate::sample::plates(12, 2.0);
        let mesh = &plates.part.mesh;
        let found = wheel(mesh).expect("a wheel");
        assert!(blade(mesh, &found, false, None).is_none());
    }
}
