//! Whether a part is a bladed wheel: an impeller, a propeller, a disk with its blades.
//!
//! In: the mesh. Out: axis and number of blades. A wheel has the same moments about all lines
//! across its axis, so only a direction in which they differ can be it. Circles about it on planes
//! across it then pass through the blades one after another: as many passages, at radii over a good
//! part of the wheel. And turned by one blade of the least that repeats (where long and short
//! blades alternate, two) the blades come to lie on one another. A hexagon is no wheel of six
//! blades: its corners are too short.

use std::f64::consts::{PI, TAU};

use nalgebra::Matrix3;

use super::run::frame_along;
use super::turned::{self, Line};
use crate::geometry::bvh::MeshBvh;
use crate::geometry::mesh::Mesh;
use crate::geometry::slice::{Loop, slice};
use crate::geometry::{Point, Vector};

/// Moments across the axis differ by less than this share.
const ROUND: f64 = 0.05;
/// Planes across the axis, and circles on each.
const PLANES: usize = 16;
const CIRCLES: usize = 40;
/// Places of the blades that are turned.
const PLACES: usize = 500;
/// They come to lie on the part within this share of its radius …
const NEAR: f64 = 0.01;
/// … this share of them.
const MOST: f64 = 0.9;
/// Blades reach inwards by this share of the radius more than the corners of a polygon do.
const DEEPER: f64 = 0.05;
/// A direction this near to a coordinate axis is that axis, degrees.
const SNAP_DEG: f64 = 1.0;
/// Places by which the axis is fitted.
const FITTED: usize = 4000;
/// A fitted axis this near to a coordinate axis is that axis, degrees and mm: meshes of round parts
/// are not round.
const ROUNDING_DEG: f64 = 0.01;
/// See [`ROUNDING_DEG`].
const ROUNDING_MM: f64 = 0.005;

/// A bladed wheel.
///
/// Of a sector of one ([`mod@super::sector`]) the blades are those of the whole wheel.
#[derive(Clone, Debug, PartialEq)]
pub struct Wheel {
    /// Its axis, unit vector, the main component positive.
    pub axis: Vector,
    /// A point of the axis, mm.
    pub through: Point,
    /// Blades, long and short ones.
    pub blades: usize,
    /// How often the wheel repeats in a turn.
    pub fold: usize,
    /// Radius from which on the blades are apart, where they are so from farthest inside, mm; 0
    /// of a sector, whose blade is not sought by it.
    pub apart_from_mm: f64,
    /// How far the blades are off one another where they are turned, root of the mean square, mm.
    pub off_mm: f64,
}

impl Wheel {
    /// In words.
    pub fn in_words(&self) -> String {
        let p = self.through;
        let short = if self.fold < self.blades {
            format!(" (alike every {:.1}°)", 360.0 / self.fold as f64)
        } else {
            String::new()
        };
        format!(
            "a wheel of {} blades{short} about {} through ({:.2}, {:.2}, {:.2}) mm",
            self.blades,
            super::words(&self.axis),
            p.x,
            p.y,
            p.z
        )
    }
}

/// The wheel that a mesh is; `None`: it is none.
pub fn wheel(mesh: &Mesh) -> Option<Wheel> {
    let (centre, axes) = round_axes(mesh)?;
    axes.into_iter().find_map(|axis| about(mesh, &centre, &axis))
}

/// Middle of the surface, and the directions across which its moments are alike.
fn round_axes(mesh: &Mesh) -> Option<(Point, Vec<Vector>)> {
    let area = mesh.area_mm2();
    let weighed = |of: &dyn Fn(Vector) -> Vector| -> Vector {
        (0..mesh.triangles.len())
            .map(|t| {
                let [a, b, c] = mesh.corners(t);
                mesh.triangle_area_mm2(t) * of((a.coords + b.coords + c.coords) / 3.0)
            })
            .sum::<Vector>()
            / area
    };
    if !(area > 0.0) {
        return None;
    }
    let centre = weighed(&|p| p);
    let mut spread = Matrix3::zeros();
    for k in 0..3 {
        let column = weighed(&|p| (p - centre) * (p - centre)[k]);
        spread.set_column(k, &column);
    }
    let eigen = spread.symmetric_eigen();
    let value = |k: usize| eigen.eigenvalues[k];
    let round = |k: &usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        (value(i) - value(j)).abs() < ROUND * value(i).max(value(j))
    };
    let axes = (0..3).filter(round).map(|k| snapped(eigen.eigenvectors.column(k).into_owned())).collect();
    Some((centre.into(), axes))
}

/// The main component positive; a coordinate axis where one is near.
fn snapped(d: Vector) -> Vector {
    let k = d.iamax();
    if d[k].abs() > SNAP_DEG.to_radians().cos() { Vector::ith(k, 1.0) } else { d * d[k].signum() }
}

/// The wheel about a line.
fn about(mesh: &Mesh, centre: &Point, axis: &Vector) -> Option<Wheel> {
    let frame = frame_along(axis);
    let mut turned = Mesh { points: mesh.points.clone(), triangles: mesh.triangles.clone(), ..Mesh::default() };
    let at = frame.inverse() * centre;
    for p in &mut turned.points {
        *p = frame.inverse() * *p;
        (p.y, p.z) = (p.y - at.y, p.z - at.z);
    }
    let bvh = MeshBvh::new(&turned);
    let b = turned.aabb()?;
    let most_mm = turned.points.iter().map(|p| p.y.hypot(p.z)).fold(0.0, f64::max);
    let passages: Vec<Vec<(f64, usize)>> = (0..PLANES)
        .map(|k| b.min.x + (k as f64 + 0.5) / PLANES as f64 * (b.max.x - b.min.x))
        .map(|x| circles(&slice(&turned, &bvh, x), most_mm))
        .collect();
    let mut counts: Vec<usize> = passages.iter().flatten().map(|(_, n)| *n).filter(|n| *n >= 3).collect();
    counts.sort_unstable();
    let mut groups: Vec<(usize, usize)> = counts.chunk_by(|a, b| a == b).map(|g| (g.len(), g[0])).collect();
    groups.sort_unstable();
    let total = counts.len();
    for (often, blades) in groups.into_iter().rev() {
        if 8 * often < total {
            break;
        }
        let Some(band) = band(&passages, blades) else { continue };
        let folds = (3..=blades).rev().filter(|f| blades.is_multiple_of(*f));
        if let Some(fold) = folds.take(4).find(|f| repeats(&turned, &bvh, band[0], most_mm, *f)) {
            let line = fitted(&turned, &bvh, band[0], most_mm, fold)?;
            let through = frame * (line.through + Vector::new(0.0, at.y, at.z));
            return Some(rounded(Wheel {
                axis: frame * line.axis,
                through,
                blades,
                fold,
                apart_from_mm: band[0],
                off_mm: line.off_mm,
            }));
        }
    }
    None
}

/// The line near the x axis about which the blades lie on one another most nearly.
fn fitted(turned: &Mesh, bvh: &MeshBvh, from_mm: f64, most_mm: f64, fold: usize) -> Option<Line> {
    let places = places(turned, from_mm, FITTED);
    turned::fit((turned, bvh), &places, (&Vector::x(), &Point::origin()), TAU / fold as f64, NEAR * most_mm)
}

/// A direction or a place that is a coordinate axis but for rounding is that axis.
fn rounded(mut wheel: Wheel) -> Wheel {
    let datum = snapped(wheel.axis);
    if datum.cross(&wheel.axis).norm() < ROUNDING_DEG.to_radians() {
        wheel.axis = datum * datum.dot(&wheel.axis).signum();
    }
    for k in (0..3).filter(|k| wheel.axis[*k].abs() < 0.5) {
        if wheel.through[k].abs() < ROUNDING_MM {
            wheel.through[k] = 0.0;
        }
    }
    wheel
}

/// About so many middles of triangles that are as far from the x axis or farther.
fn places(turned: &Mesh, from_mm: f64, most: usize) -> Vec<Point> {
    let middle = |[p, q, r]: [Point; 3]| p + ((q - p) + (r - p)) / 3.0;
    let middles = (0..turned.triangles.len()).map(|t| middle(turned.corners(t)));
    let all: Vec<Point> = middles.filter(|p| p.y.hypot(p.z) >= from_mm).collect();
    let every = (all.len() / most).max(1);
    all.into_iter().step_by(every).collect()
}

/// Radii of circles and how many bodies each passes through.
fn circles(loops: &[Loop], most_mm: f64) -> Vec<(f64, usize)> {
    let radii: Vec<f64> = (1..CIRCLES).map(|k| most_mm * k as f64 / CIRCLES as f64).collect();
    let mut crossed = vec![0usize; radii.len()];
    for l in loops {
        let n = l.points.len();
        for i in 0..if l.closed { n } else { n.saturating_sub(1) } {
            let [a, b] = [l.points[i], l.points[(i + 1) % n]].map(|p| p[0].hypot(p[1]));
            for (r, crossed) in radii.iter().zip(&mut crossed) {
                *crossed += usize::from((a < *r) != (b < *r));
            }
        }
    }
    radii.into_iter().zip(crossed).map(|(r, c)| (r, c / 2)).collect()
}

/// The widest range of radii, of one plane, on which circles pass through so many blades; `None`
/// where it is no deeper than the corners of a polygon.
fn band(passages: &[Vec<(f64, usize)>], blades: usize) -> Option<[f64; 2]> {
    // Without gaps: the corners of a bore and those of the outside are no blades.
    let of = |plane: &Vec<(f64, usize)>| {
        let runs = plane.chunk_by(|a, b| (a.1 == blades) == (b.1 == blades)).filter(|run| run[0].1 == blades);
        let ends = runs.map(|run| [run[0].0, run[run.len() - 1].0]);
        ends.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))
    };
    let widest = passages.iter().filter_map(of).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))?;
    let deep = 1.0 - widest[0] / widest[1];
    (deep > 1.0 - (PI / blades as f64).cos() + DEEPER).then_some(widest)
}

/// Whether places from a radius on come to lie on the part where it is turned by a share of a turn.
fn repeats(turned: &Mesh, bvh: &MeshBvh, from_mm: f64, most_mm: f64, fold: usize) -> bool {
    let (s, c) = (TAU / fold as f64).sin_cos();
    let places = places(turned, from_mm, PLACES);
    let lies = |p: &&Point| {
        let q = Point::new(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
        bvh.closest(turned, &q, NEAR * most_mm).is_some()
    };
    let on = places.iter().filter(lies).count();
    places.len() >= fold && on as f64 >= MOST * places.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::model::sample;

    /// A star: a prism about x whose outline has so many spikes from an inner to an outer radius;
    /// `short` ones between are half as long.
    fn star(spikes: usize, [inner, outer]: [f64; 2], short: bool) -> Mesh {
        let all = if short { 2 * spikes } else { spikes };
        let n = 8 * all;
        let radius = |k: usize| {
            let long = if short && (k / 8) % 2 == 1 { 0.5 * (inner + outer) } else { outer };
            if (2..5).contains(&(k % 8)) { long } else { inner }
        };
        let mut mesh = Mesh::default();
        for x in [-5.0, 5.0] {
            mesh.points.extend((0..n).map(|k| {
                let (s, c) = (TAU * k as f64 / n as f64).sin_cos();
                Point::new(x, radius(k) * c, radius(k) * s)
            }));
            mesh.points.push(Point::new(x, 0.0, 0.0));
        }
        let (n, top) = (n as u32, n as u32 + 1);
        for k in 0..n {
            let l = (k + 1) % n;
            mesh.triangles.extend([[k, l, top + l], [k, top + l, top + k], [n, l, k], [top + n, top + k, top + l]]);
        }
        mesh
    }

    #[test]
    fn spikes_about_an_axis_are_counted() {
        for (blades, short, fold) in [(3, false, 3), (5, false, 5), (7, false, 7), (6, true, 6)] {
            let found = wheel(&star(blades, [10.0, 40.0], short)).unwrap_or_else(|| panic!("{blades} blades"));
            assert_eq!((found.fold, found.axis), (fold, Vector::x()), "{found:?}");
            assert!(found.blades == if short { 12 } else { blades } || found.blades == blades, "{found:?}");
            assert!(found.through.coords.norm() < 1e-6);
        }
        let mut aside = star(5, [10.0, 40.0], false);
        aside.points.iter_mut().for_each(|p| (p.x, p.y, p.z) = (p.z + 100.0, p.x, p.y - 20.0));
        let found = wheel(&aside).expect("a wheel");
        assert!(
            found.axis == Vector::y()
                && (found.through.x - 100.0).abs() < 1e-6
                && (found.through.z + 20.0).abs() < 1e-6
        );
    }

    #[test]
    fn what_is_no_wheel_is_none() {
        assert_eq!(wheel(&sample::blade()), None);
        // A square, a hexagon: their corners are no blades.
        for (corners, inner) in [(4usize, 0.5f64.sqrt()), (6, 0.75f64.sqrt())] {
            assert_eq!(wheel(&star(corners, [20.0 * inner, 20.0], false)), None, "{corners} corners");
        }
        // One spike of five is missing.
        let mut broken = star(5, [10.0, 40.0], false);
        let n = broken.points.len() / 2;
        for p in broken.points.iter_mut().enumerate().filter(|(k, _)| k % n < 8).map(|(_, p)| p) {
            let r = p.y.hypot(p.z).max(1e-9);
            (p.y, p.z) = (p.y * 10.0 / r, p.z * 10.0 / r);
        }
        assert_eq!(wheel(&broken), None);
    }
}
