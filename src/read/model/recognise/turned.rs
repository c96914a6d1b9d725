//! A part that is turned about a line comes to lie on itself, or on the next sector of its wheel.
//!
//! In: the mesh, places on it, a line and an angle. Out: the line about which the places come to
//! lie on the part most nearly, in least squares of the distances along the normals, and how far
//! they are off it.

use nalgebra::{Matrix4, Unit, UnitQuaternion, Vector4};

use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid, Vector};

/// Rounds of Gauss and Newton.
const ROUNDS: usize = 5;
/// A line whose direction is determined less well than this share of the best is left as it is.
const RANK: f64 = 1e-9;

/// A line, and how far a turn about it brings places off the part.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Unit direction.
    pub axis: Vector,
    /// A point of it, mm.
    pub through: Point,
    /// Root of the mean square of the distances, mm.
    pub off_mm: f64,
}

/// The turn about a line.
pub fn about(axis: &Vector, through: &Point, angle_rad: f64) -> Rigid {
    Rigid::rotation_wrt_point(UnitQuaternion::from_axis_angle(&Unit::new_normalize(*axis), angle_rad), *through)
}

/// The normal of the mesh beside a point, and how far the point is off the mesh along it, mm;
/// `None`: farther off than `within_mm`.
fn off((mesh, bvh): (&Mesh, &MeshBvh), p: &Point, within_mm: f64) -> Option<(Vector, f64)> {
    let near = bvh.closest(mesh, p, within_mm)?;
    let normal = mesh.normal(near.triangle as usize);
    Some((normal, normal.dot(&(p - near.foot))))
}

/// The line near `axis` through `through` about which `places`, turned by `angle_rad`, come to lie
/// on the mesh; places that come to lie farther off than `within_mm` do not count. `None` where
/// fewer than a dozen do.
pub fn fit(
    on: (&Mesh, &MeshBvh),
    places: &[Point],
    (axis, through): (&Vector, &Point),
    angle_rad: f64,
    within_mm: f64,
) -> Option<Line> {
    let mut line = Line { axis: axis.normalize(), through: *through, off_mm: f64::INFINITY };
    let mut best: Option<Line> = None;
    for _ in 0..ROUNDS {
        let (across, turn) = (square(&line.axis), about(&line.axis, &line.through, angle_rad));
        let (mut normal, mut right, mut sum, mut count) = (Matrix4::zeros(), Vector4::zeros(), 0.0, 0usize);
        for p in places {
            let Some((n, off)) = off(on, &(turn * p), within_mm) else { continue };
            let arm = p - line.through;
            // A line that is shifted by v moves q by v − turned v; one that is tilted by w, by
            // w × (turned arm) − turned (w × arm).
            let shift = across.map(|v| n.dot(&(v - turn * v)));
            let tilt = across.map(|w| n.dot(&(w.cross(&(turn * arm)) - turn * w.cross(&arm))));
            let row = Vector4::new(shift[0], shift[1], tilt[0], tilt[1]);
            normal += row * row.transpose();
            right -= row * off;
            sum += off * off;
            count += 1;
        }
        if count < 12 {
            break;
        }
        line.off_mm = (sum / count as f64).sqrt();
        if best.as_ref().is_none_or(|b| line.off_mm < b.off_mm) {
            best = Some(line.clone());
        }
        let svd = normal.svd(true, true);
        let Ok(step) = svd.solve(&right, RANK * svd.singular_values[0]) else { break };
        line.through += across[0] * step[0] + across[1] * step[1];
        let tilt = across[0] * step[2] + across[1] * step[3];
        line.axis = (line.axis + tilt.cross(&line.axis)).normalize();
    }
    best
}

/// How far places are off the mesh, root of the mean square of the distances along the normals, mm,
/// where they are turned; those farther off than `within_mm` do not count.
pub fn off_mm(on: (&Mesh, &MeshBvh), places: &[Point], turn: &Rigid, within_mm: f64) -> Option<f64> {
    let all: Vec<f64> = places.iter().filter_map(|p| off(on, &(turn * p), within_mm)).map(|o| o.1 * o.1).collect();
    (!all.is_empty()).then(|| (all.iter().sum::<f64>() / all.len() as f64).sqrt())
}

/// Two directions square to a line and to one another.
fn square(axis: &Vector) -> [Vector; 2] {
    let a = axis.cross(&Vector::ith(axis.iamin(), 1.0)).normalize();
    [a, axis.cross(&a)]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A prism of five sides with sloping ends about a line, meshed coarsely.
    fn pyramids(axis: &Vector, through: &Point) -> Mesh {
        let [u, w] = square(axis);
        let at = |k: u32, h: f64, r: f64| {
            let (s, c) = (std::f64::consts::TAU * f64::from(k) / 5.0).sin_cos();
            through + axis * h + (u * c + w * s) * r
        };
        let mut mesh = Mesh::default();
        mesh.points.extend((0..5).map(|k| at(k, -3.0, 20.0)));
        mesh.points.extend((0..5).map(|k| at(k, 10.0, 30.0)));
        mesh.points.extend([through - axis * 9.0, through + axis * 17.0]);
        for k in 0..5 {
            let l = (k + 1) % 5;
            mesh.triangles.extend([[k, l, 5 + l], [k, 5 + l, 5 + k], [10, l, k], [11, 5 + k, 5 + l]]);
        }
        mesh
    }

    #[test]
    fn the_line_about_which_a_part_repeats_is_found() {
        let (axis, through) = (Vector::new(0.3, -0.2, 1.0).normalize(), Point::new(4.0, -7.0, 2.0));
        let mesh = pyramids(&axis, &through);
        let bvh = MeshBvh::new(&mesh);
        let places: Vec<Point> = (0..mesh.triangles.len())
            .flat_map(|t| {
                let [a, b, c] = mesh.corners(t);
                [[0.6, 0.3], [0.2, 0.2], [0.1, 0.7]].map(|[s, t]| a + (b - a) * s + (c - a) * t)
            })
            .collect();
        let begin = (axis + Vector::new(0.004, 0.005, 0.0)).normalize();
        let shifted = through + Vector::new(0.1, -0.15, 0.05);
        let found = fit((&mesh, &bvh), &places, (&begin, &shifted), std::f64::consts::TAU / 5.0, 5.0).unwrap();
        let beside = (found.through - through).cross(&axis).norm();
        assert!(found.axis.angle(&axis) < 1e-9 && beside < 1e-8 && found.off_mm < 1e-9, "{found:?} {beside}");
        // A turn by which it does not repeat leaves it off the part.
        let wrong = fit((&mesh, &bvh), &places, (&begin, &shifted), 0.9, 5.0).unwrap();
        assert!(wrong.off_mm > 0.2, "{wrong:?}");
    }
}
