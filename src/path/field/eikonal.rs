//! The field φ on the mesh: how many turns of constant scallop lie between a place and the end.
//!
//! Two balls at the centres `c`, `c'` with the contacts `p`, `p'` leave the ridge
//! `(c' − c)·(p' − p) / 8R`, to the second order, whatever the curvature; the distance on flat
//! ground is `flat_mm = √(8Rh)`. So `|∇φ| = 1/d(h, ρ, direction)` is the eikonal equation of the
//! Riemannian metric `dc·dp / flat_mm²`: φ is the length of the shortest way to the end in it.
//! Where the ball rolls over a sharp edge ways have no length, since no ridge is left.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use nalgebra::{Matrix2, Matrix3};
use rayon::prelude::*;

use super::super::level::{LevelSet, Touch};
use super::super::stepover::ridge_over_creases;
use super::net::Net;
use crate::geometry::{Point, Vector};

/// Bounds of `dc·dp / dc²`: round a sharp edge it is 0, in a hollow hardly wider than the ball it
/// is as large as one likes.
const RATIO: [f64; 2] = [1e-4, 4.0];
/// The least ratio over facets.
const LEAST_OVER_FACETS: f64 = 0.02;
/// Normals of one sheet of the level set differ by less than 84° within reach.
pub const ONE_SHEET: f64 = 0.1;
/// From this ratio on the length of an edge is taken from the ridge itself.
const HOLLOW: f64 = 1.5;
/// Times that a vertex passes its value on: in an order that the triangles do not keep to a value
/// may fall again.
const MOST_TIMES: u8 = 6;
/// Least fall of a value that is passed on.
const LEAST_FALL: f64 = 1e-6;

/// Length of the way between two balls in stepovers.
pub fn stepovers(level: &LevelSet, a: &Touch, b: &Touch, flat_mm: f64, scallop_mm: f64) -> f64 {
    let moved = b.centre - a.centre;
    let square = moved.norm_squared();
    let ratio = moved.dot(&(b.contact - a.contact)) / square.max(1e-300);
    if ratio > HOLLOW
        && let Some(share) = share_of_scallop(level, &a.centre, &b.centre, scallop_mm)
    {
        return share.max(RATIO[0].sqrt() * square.sqrt() / flat_mm);
    }
    (ratio.clamp(RATIO[0], RATIO[1]) * square).sqrt() / flat_mm
}

/// The share of a stepover by which two balls are apart: it leaves its square of the scallop.
pub fn share_of_scallop(level: &LevelSet, a: &Point, b: &Point, scallop_mm: f64) -> Option<f64> {
    let ridge = ridge_over_creases(level, a, b)?;
    ridge.is_finite().then(|| (ridge.max(0.0) / scallop_mm).sqrt())
}

struct Item(f64, u32);
impl PartialEq for Item {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Item {}
impl PartialOrd for Item {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Item {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
    }
}

/// φ at all vertices: `given` values stay, and those given over 0 are where it starts; infinite
/// where no way leads, and outside.
pub fn solve(net: &Net, given: &[Option<f64>], length: impl Fn(u32, u32) -> f64 + Sync) -> Vec<f64> {
    let mut phi: Vec<f64> = given.iter().map(|g| g.unwrap_or(f64::INFINITY)).collect();
    let inner: Vec<[u32; 3]> =
        net.both_ways.iter().filter(|t| t.iter().all(|v| net.within[*v as usize])).copied().collect();
    let sides: Vec<[f64; 3]> = inner
        .par_iter()
        .map(|t| {
            // A side is no longer than the way round by the two others.
            let [a, b, c] = [0, 1, 2].map(|i| length(t[(i + 1) % 3], t[(i + 2) % 3]));
            [a.min(b + c), b.min(c + a), c.min(a + b)]
        })
        .collect();
    let mut around: Vec<Vec<u32>> = vec![Vec::new(); phi.len()];
    for (i, t) in inner.iter().enumerate() {
        t.iter().for_each(|v| around[*v as usize].push(i as u32));
    }
    let mut times = vec![0u8; phi.len()];
    let starts = (0..phi.len() as u32).filter(|v| (0.0..f64::INFINITY).contains(&phi[*v as usize]));
    let mut heap: BinaryHeap<Item> = starts.map(|v| Item(phi[v as usize], v)).collect();
    while let Some(Item(value, a)) = heap.pop() {
        if value > phi[a as usize] || times[a as usize] >= MOST_TIMES {
            continue;
        }
        times[a as usize] += 1;
        for i in &around[a as usize] {
            let t = inner[*i as usize];
            let at = t.iter().position(|v| *v == a).unwrap_or(0);
            for (to, by) in [((at + 1) % 3, (at + 2) % 3), ((at + 2) % 3, (at + 1) % 3)] {
                let (v, b) = (t[to] as usize, t[by] as usize);
                if given[v].is_some() {
                    continue;
                }
                let s = &sides[*i as usize];
                let new = from_side([value, phi[b]], [s[by], s[at], s[to]]);
                if new < phi[v] - LEAST_FALL {
                    phi[v] = new;
                    heap.push(Item(new, v as u32));
                }
            }
        }
    }
    phi
}

/// The value that a front brings to a corner of a triangle from the two others with these values,
/// at the lengths `[to_a, to_b]` from it and `a_to_b` from one another: a straight front if it
/// comes through the side, else the front that comes along one of the sides.
fn from_side([a, b]: [f64; 2], [to_a, to_b, a_to_b]: [f64; 3]) -> f64 {
    let along = (a + to_a).min(b + to_b);
    let slope = (b - a) / a_to_b;
    if slope.is_nan() || slope.abs() >= 1.0 {
        return along;
    }
    let rise = (1.0 - slope * slope).sqrt();
    let x = (to_a * to_a + a_to_b * a_to_b - to_b * to_b) / (2.0 * a_to_b);
    let y = (to_a * to_a - x * x).max(0.0).sqrt();
    let foot = x - y * slope / rise;
    if (0.0..=a_to_b).contains(&foot) { along.min(a + slope * x + rise * y) } else { along }
}

/// Length of the way between two vertices over facets, in stepovers, by the forms at both.
pub fn stepovers_by_form(net: &Net, forms: &[Matrix3<f64>], [a, b]: [u32; 2], flat_mm: f64) -> f64 {
    let moved = net.centre(b) - net.centre(a);
    let square = |v: u32| moved.dot(&(forms[v as usize] * moved));
    (0.5 * (square(a) + square(b))).max(0.0).sqrt() / flat_mm
}

/// How contacts go with centres about each vertex: the symmetric form that fits the vertices within
/// `reach_mm` best. Over facets `dc·dp` of single edges tells of the facets and not of the part.
pub fn forms(net: &Net, reach_mm: f64) -> Vec<Matrix3<f64>> {
    (0..net.touches.len()).into_par_iter().map(|v| form(net, v, reach_mm)).collect()
}

fn form(net: &Net, v: usize, reach_mm: f64) -> Matrix3<f64> {
    let at = &net.touches[v];
    let [e, f] = tangent_plane(&at.normal);
    let mut m = Matrix3::zeros();
    let mut y = Vector::zeros();
    for w in net.about(&at.centre, (reach_mm / net.cell_mm).ceil() as i32) {
        let t = &net.touches[w as usize];
        let (gone, moved) = (t.centre - at.centre, t.contact - at.contact);
        let share = gone.norm() / reach_mm;
        if share >= 1.0 || w as usize == v || t.normal.dot(&at.normal) < ONE_SHEET {
            continue;
        }
        let weight = (1.0 - share * share).powi(2);
        let (a, b) = (gone.dot(&e), gone.dot(&f));
        for (row, goal) in [(Vector::new(a, b, 0.0), moved.dot(&e)), (Vector::new(0.0, a, b), moved.dot(&f))] {
            m += row * row.transpose() * weight;
            y += row * (goal * weight);
        }
    }
    m += Matrix3::identity() * (1e-6 * reach_mm * reach_mm);
    let Some(c) = m.cholesky().map(|m| m.solve(&y)) else { return Matrix3::identity() };
    let eigen = Matrix2::new(c[0], c[1], c[1], c[2]).symmetric_eigen();
    let mut out = Matrix3::zeros();
    for k in 0..2 {
        let u = eigen.eigenvectors.column(k);
        let direction = e * u[0] + f * u[1];
        out += direction * direction.transpose() * eigen.eigenvalues[k].clamp(LEAST_OVER_FACETS, RATIO[1]);
    }
    out
}

/// Two unit vectors across a unit vector and one another.
pub fn tangent_plane(normal: &Vector) -> [Vector; 2] {
    let e = normal.cross(&if normal.x.abs() < 0.7 { Vector::x() } else { Vector::y() }).normalize();
    [e, normal.cross(&e)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A straight front over a triangle: the third corner gets its own value where the front comes
    /// to it through the side, and a greater one, along a side, where it does not.
    #[test]
    fn a_straight_front_is_carried_through_a_triangle() {
        let (mut through, mut beside) = (0, 0);
        for k in 0..2000u32 {
            let unit = |n: u32| f64::from((k * 7919 + n * 104_729) % 1000) / 1000.0;
            let (c, x, y) = (0.2 + unit(1), 2.0 * unit(2) - 0.5, 0.1 + unit(3));
            let (sin, cos) = (0.02 + 3.1 * unit(4)).sin_cos();
            let value = |p: [f64; 2]| 5.0 + cos * p[0] + sin * p[1];
            let found = from_side([value([0.0, 0.0]), value([c, 0.0])], [x.hypot(y), (x - c).hypot(y), c]);
            let exact = value([x, y]);
            assert!(found > exact - 1e-9, "{found} under {exact}");
            if (0.0..=c).contains(&(x - y * cos / sin)) {
                through += 1;
                assert!((found - exact).abs() < 1e-9, "{found} for {exact}");
            } else {
                beside += 1;
            }
        }
        assert!(through > 300 && beside > 300, "{through} through the side, {beside} beside it");
    }
}
