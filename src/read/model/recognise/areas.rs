//! Which triangle belongs to what: airfoil, fillet, platform, root, tip.
//!
//! By height along the blade axis, by the side a triangle faces, and, so that things beside the
//! airfoil are told apart from it, by the boxes of the airfoil's sections. Faces of a B-rep that
//! belong to one area by nearly all of their surface are taken whole.

use std::collections::BTreeMap;

use super::Recognised;
use crate::artifact::region::{Area, surface};
use crate::geometry::Point;
use crate::geometry::mesh::Mesh;

/// A triangle faces the tip where its normal is within 45° of the axis.
const FACES_TIP: f64 = 0.7;
/// Sections' boxes are widened by this share for what lies between sections.
const WIDER: f64 = 0.05;
/// The platform's top is this share of the part deep: it may be crowned or slanted.
const DEEP: f64 = 0.02;
/// A quarter of a circle is beside its chord by up to a fifth of the chord; more, since places have
/// a distance.
const ARC: f64 = 0.35;
/// A face belongs to an area as a whole where this share of its surface does.
const WHOLE: f64 = 0.9;

/// The area of each triangle of a mesh of the part in the blade frame. `whole_faces`: the mesh's
/// faces are faces of a B-rep.
pub fn areas(mesh: &Mesh, found: &Recognised, whole_faces: bool) -> Vec<Area> {
    if let Some(round) = &found.round {
        // Exact faces may be meshed anew.
        let is_own = |t: usize| match whole_faces {
            true => round.faces.binary_search(&mesh.face(t)).is_ok(),
            false => round.triangles.binary_search(&(t as u32)).is_ok(),
        };
        let area = |t| if is_own(t) { Area::Airfoil } else { Area::Other };
        return (0..mesh.triangles.len()).map(area).collect();
    }
    let mut out: Vec<Area> = (0..mesh.triangles.len())
        .map(|t| {
            let [a, b, c] = mesh.corners(t);
            area(found, &Point::from((a.coords + b.coords + c.coords) / 3.0), mesh.normal(t).x)
        })
        .collect();
    if whole_faces {
        take_whole(mesh, &mut out);
    }
    out
}

fn area(found: &Recognised, p: &Point, n_x: f64) -> Area {
    let r = &found.heights;
    let [lo, hi] = r.airfoil_x_mm;
    let length = (r.part_x_mm[1] - r.part_x_mm[0]).max(f64::MIN_POSITIVE);
    let tolerance = 1e-3 * length;
    if on_climbing_fillet(found, p) {
        return Area::Fillet;
    }
    if p.x > hi + tolerance || (p.x > hi - tolerance && n_x > FACES_TIP) {
        return Area::Tip;
    }
    if p.x >= lo {
        let beside = !within(found, p);
        return match r.fillet_x_mm {
            _ if beside && n_x > FACES_TIP && r.platform_x_mm.is_some_and(|x| p.x < x + tolerance) => Area::Platform,
            _ if beside => Area::Other,
            Some([_, top]) if p.x < top => Area::Fillet,
            _ => Area::Airfoil,
        };
    }
    let platform = r.platform_x_mm.unwrap_or(f64::NEG_INFINITY);
    if n_x > FACES_TIP && p.x > platform - DEEP * length {
        return if r.platform_x_mm.is_some() { Area::Platform } else { Area::Root };
    }
    match r.fillet_x_mm {
        Some([foot, _]) if p.x > foot + tolerance && within(found, p) => Area::Fillet,
        _ => Area::Root,
    }
}

/// Whether a point lies on a fillet whose foot climbs: beside the chord of the fillet's arc at one
/// of the places where it is known.
fn on_climbing_fillet(found: &Recognised, p: &Point) -> bool {
    found.fillet.iter().any(|[top, foot]| {
        let chord = foot - top;
        let beside = ARC * chord.norm();
        let between = p.x < top.x.max(foot.x) + beside && p.x > top.x.min(foot.x) - beside;
        between && {
            let share = (p - top).dot(&chord) / chord.norm_squared().max(f64::MIN_POSITIVE);
            (0.0..=1.0).contains(&share) && (top + chord * share - p).norm() < beside
        }
    })
}

/// Whether a point lies in the box of the airfoil's section at its height, or of the nearest.
fn within(found: &Recognised, p: &Point) -> bool {
    let nearest = found.outline.iter().min_by(|a, b| (a.0 - p.x).abs().total_cmp(&(b.0 - p.x).abs()));
    let Some((_, b)) = nearest else { return true };
    let margin = |k: usize| WIDER * (b[k + 2] - b[k]) + WIDER * (b[2] - b[0]).max(b[3] - b[1]);
    let q = [p.y, p.z];
    // A fillet is wider than the section that it ends in.
    let wider = if found.heights.fillet_x_mm.is_some_and(|f| p.x < f[1]) { 6.0 } else { 1.0 };
    (0..2).all(|k| q[k] > b[k] - wider * margin(k) && q[k] < b[k + 2] + wider * margin(k))
}

fn take_whole(mesh: &Mesh, out: &mut [Area]) {
    let whole: BTreeMap<u32, Area> = surface(mesh, out)
        .iter()
        .filter_map(|(face, by)| {
            let total: f64 = by.values().sum();
            by.iter().find(|(_, s)| **s >= WHOLE * total).map(|(area, _)| (*face, *area))
        })
        .collect();
    for (t, area) in out.iter_mut().enumerate() {
        if let Some(a) = whole.get(&mesh.face(t)) {
            *area = *a;
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Rigid;
    use crate::read::model::recognise::Heights;

    /// One small triangle at each place, facing along each normal; every triangle is a face of its
    /// own.
    fn found(at: &[([f64; 3], [f64; 3])], platform: Option<f64>, fillet: Option<[f64; 2]>) -> Recognised {
        let mut mesh = Mesh::default();
        for (k, (p, n)) in at.iter().enumerate() {
            let (p, n) = (Point::from(*p), crate::geometry::Vector::from(*n).normalize());
            let e = if n.x.abs() < 0.9 { crate::geometry::Vector::x() } else { crate::geometry::Vector::y() };
            let u = (e - n * n.dot(&e)).normalize() * 1e-3;
            let v = n.cross(&u);
            let base = 3 * k as u32;
            mesh.points.extend([p - u - v, p + u - v, p + 2.0 * v]);
            mesh.triangles.push([base, base + 1, base + 2]);
            mesh.face_of.push(k as u32);
        }
        let heights = Heights {
            part_x_mm: [-50.0, 80.0],
            airfoil_x_mm: [0.0, 80.0],
            platform_x_mm: platform,
            fillet_x_mm: fillet,
            reasons: Vec::new(),
        };
        let outline = (0..9).map(|k| (10.0 * f64::from(k), [-20.0, -5.0, 20.0, 5.0])).collect();
        Recognised {
            model_from_blade: Rigid::identity(),
            mesh,
            heights,
            doubts: Vec::new(),
            against: None,
            unlike: None,
            outline,
            fillet: Vec::new(),
            round: None,
        }
    }

    fn areas_of(found: &Recognised, whole_faces: bool) -> Vec<Area> {
        areas(&found.mesh, found, whole_faces)
    }

    const UP: [f64; 3] = [1.0, 0.0, 0.0];
    const OUT: [f64; 3] = [0.0, 0.0, 1.0];

    #[test]
    fn every_place_has_its_area() {
        let places = [
            ([40.0, 0.0, 5.0], OUT, Area::Airfoil),
            ([3.0, 0.0, 5.5], OUT, Area::Fillet),
            ([0.0, 30.0, 20.0], UP, Area::Platform),
            ([-1.0, 30.0, 20.0], [1.0, 0.0, 0.3], Area::Platform),
            ([-20.0, 30.0, 20.0], OUT, Area::Root),
            ([-20.0, 30.0, 20.0], UP, Area::Root),
            ([80.0, 0.0, 0.0], UP, Area::Tip),
            ([79.9, 0.0, 5.0], OUT, Area::Airfoil),
            ([81.0, 0.0, 5.0], OUT, Area::Tip),
            ([40.0, 60.0, 5.0], OUT, Area::Other),
        ];
        let at: Vec<_> = places.iter().map(|p| (p.0, p.1)).collect();
        let got = areas_of(&found(&at, Some(0.0), Some([0.0, 6.0])), false);
        for ((p, n, want), got) in places.iter().zip(&got) {
            assert_eq!(got, want, "at {p:?} facing {n:?}");
        }
        // Without a platform the same faces are root, without a fillet the airfoil goes down to its
        // foot.
        let got = areas_of(&found(&at, None, None), false);
        assert_eq!([got[1], got[3]], [Area::Airfoil, Area::Root]);
    }

    #[test]
    fn a_fillet_that_climbs_is_where_its_ends_are() {
        let at = |x: f64, z: f64| Point::new(x, 0.0, z);
        let places = [
            ([10.2, 0.0, 5.2], Area::Fillet),
            ([20.2, 10.0, 5.2], Area::Fillet),
            ([20.2, 0.0, 5.0], Area::Airfoil),
            ([11.5, 0.0, 5.0], Area::Airfoil),
        ];
        let mut f = found(&places.map(|p| (p.0, OUT)), Some(0.0), None);
        f.fillet = (0..=40)
            .map(|k| f64::from(k) * 0.25)
            .map(|y| [at(11.0 + y, 5.0), at(10.0 + y, 6.0)].map(|p| p + crate::geometry::Vector::y() * y))
            .collect();
        assert_eq!(areas_of(&f, false), places.map(|p| p.1));
    }

    #[test]
    fn a_face_that_belongs_to_one_area_by_nine_tenths_is_taken_whole() {
        let pieces = |airfoil: usize, fillet: usize| {
            let mut at = vec![([40.0, 0.0, 5.0], OUT); airfoil];
            at.resize(airfoil + fillet, ([3.0, 0.0, 5.5], OUT));
            let mut f = found(&at, Some(0.0), Some([0.0, 6.0]));
            f.mesh.face_of = vec![0; airfoil + fillet];
            f
        };
        assert_eq!(areas_of(&pieces(19, 1), false)[19], Area::Fillet);
        assert!(areas_of(&pieces(19, 1), true).iter().all(|a| *a == Area::Airfoil));
        let mixed = areas_of(&pieces(8, 2), true);
        assert!(mixed[..8].iter().all(|a| *a == Area::Airfoil) && mixed[8..].iter().all(|a| *a == Area::Fillet));
    }
}
