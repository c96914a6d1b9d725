//! Whether a part is one sector of a wheel: its two sides come to lie on one another where it is
//! turned about the rotor axis by one blade.
//!
//! In: the mesh. Out: axis and number of blades. The rotor axis is a coordinate axis about which
//! hub, casing or ends are surfaces of revolution ([`rotor::shaft`]). Surfaces of revolution come
//! to lie on themselves by any turn, so they do not count: what counts is surface that comes to lie
//! on surface which looks the other way.

use std::f64::consts::TAU;

use super::rotor;
use super::turned::{self, about};
use super::wheel::Wheel;
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::{Mesh, spread};
use crate::geometry::{Point, Rigid, Vector};
use crate::parallel;

/// Numbers of blades that are tried.
const BLADES: std::ops::RangeInclusive<usize> = 3..=200;
/// Places by which numbers of blades are weighed against each other.
const PLACES: usize = 3000;
/// A place comes to lie on the part within this share of the part's size.
const NEAR: f64 = 1e-3;
/// A surface whose normal has less than this round the axis is one of revolution.
const ROUND: f64 = 0.1;
/// Cosine between two sides that lie on one another is below this.
const AGAINST: f64 = -0.98;
/// At least this share of the part's surface are the sides.
const SHARE: f64 = 0.01;
/// ... and this many times what comes to lie on the part by any other turn.
const TIMES: f64 = 3.0;

/// A place on the part and its normal.
type PointAndNormal = (Point, Vector);

/// The wheel that a part is one sector of; `None`: it is none, or nothing shows it.
pub fn sector(mesh: &Mesh) -> Option<Wheel> {
    let axis = Vector::ith(rotor::shaft(mesh)?, 1.0);
    let (all, places) = sides(mesh, &axis);
    let size_mm = mesh.aabb()?.diagonal_mm();
    let bvh = MeshBvh::new(mesh);
    let within_mm = NEAR * size_mm;
    let turn = |blades: usize| about(&axis, &Point::origin(), TAU / blades as f64);
    let meets = |(p, n): &PointAndNormal, turn: &Rigid| {
        let near = bvh.closest(mesh, &(turn * p), within_mm);
        near.is_some_and(|near| mesh.normal(near.triangle as usize).dot(&(turn * n)) < AGAINST)
    };
    let count = |blades: usize| {
        let turn = turn(blades);
        (places.iter().filter(|p| meets(p, &turn)).count(), blades)
    };
    let mut counts: Vec<(usize, usize)> = parallel::map(BLADES, count);
    counts.sort_unstable_by(|a, b| b.cmp(a));
    let [(most, blades), (second, _)] = [*counts.first()?, *counts.get(1)?];
    if (most as f64) < SHARE * all as f64 || (most as f64) < TIMES * second as f64 {
        return None;
    }
    let turn = turn(blades);
    let own: Vec<Point> = places.iter().filter(|p| meets(p, &turn)).map(|p| p.0).collect();
    let off_mm = turned::off_mm((mesh, &bvh), &own, &turn, within_mm)?;
    Some(Wheel { axis, through: Point::origin(), blades, fold: blades, apart_from_mm: 0.0, off_mm })
}

/// Places spread evenly over the surface: how many, and those that are on no surface of revolution.
fn sides(mesh: &Mesh, axis: &Vector) -> (usize, Vec<PointAndNormal>) {
    let all = spread(mesh, |_| true, PLACES);
    let side = |(p, t): &(Point, u32)| {
        let (n, around) = (mesh.normal(*t as usize), axis.cross(&p.coords));
        (around.norm() > 0.0 && n.dot(&around).abs() > ROUND * around.norm()).then_some((*p, n))
    };
    (all.len(), all.iter().filter_map(side).collect())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A sector of a ring about the x axis from one radius to another, with sides that lean.
    fn ring_sector(blades: usize, lean: f64) -> Mesh {
        let (n, rows) = (720 / blades as u32, 20u32);
        let mut mesh = Mesh::default();
        for row in 0..=rows {
            let x = f64::from(row) - 10.0;
            for r in [40.0, 60.0] {
                for k in 0..=n {
                    let angle = 0.3 + lean * x + TAU / blades as f64 * f64::from(k) / f64::from(n);
                    mesh.points.push(Point::new(x, r * angle.cos(), r * angle.sin()));
                }
            }
        }
        let at = |row: u32, r: u32, k: u32| (2 * row + r) * (n + 1) + k;
        let mut quad = |a: u32, b: u32, c: u32, d: u32| mesh.triangles.extend([[a, b, c], [a, c, d]]);
        for k in 0..n {
            for row in 0..rows {
                quad(at(row, 1, k), at(row + 1, 1, k), at(row + 1, 1, k + 1), at(row, 1, k + 1));
                quad(at(row, 0, k), at(row, 0, k + 1), at(row + 1, 0, k + 1), at(row + 1, 0, k));
            }
            quad(at(0, 0, k), at(0, 1, k), at(0, 1, k + 1), at(0, 0, k + 1));
            quad(at(rows, 0, k), at(rows, 0, k + 1), at(rows, 1, k + 1), at(rows, 1, k));
        }
        for row in 0..rows {
            quad(at(row, 0, 0), at(row + 1, 0, 0), at(row + 1, 1, 0), at(row, 1, 0));
            quad(at(row, 0, n), at(row, 1, n), at(row + 1, 1, n), at(row + 1, 0, n));
        }
        mesh
    }

    #[test]
    fn sides_that_lie_on_one_another_tell_the_number_of_blades() {
        for (blades, lean) in [(5, 0.0), (12, 0.01), (36, 0.0), (67, 0.004)] {
            let found = sector(&ring_sector(blades, lean)).unwrap_or_else(|| panic!("{blades} blades"));
            assert!(found.blades == blades && found.axis == Vector::x() && found.off_mm < 0.01, "{found:?}");
        }
    }

    #[test]
    fn a_part_whose_sides_do_not_meet_is_no_sector() {
        // The sides are apart by 40.5 degrees: no number of blades.
        let mut mesh = ring_sector(12, 0.0);
        for p in &mut mesh.points {
            let (r, a) = (p.y.hypot(p.z), (p.z.atan2(p.y) - 0.3) * 1.35 + 0.3);
            (p.y, p.z) = (r * a.cos(), r * a.sin());
        }
        assert_eq!(sector(&mesh), None);
        assert_eq!(sector(&crate::read::model::sample::blade()), None);
    }
}
