//! The deviation map: what the swept ball leaves over the part, on triangles as fine as the heights need.
//!
//! **In**: part and swept ball. **Out**: a [`DeviationMap`]. The height at a point of the surface is where its normal enters the swept
//! ball, as in [`super::scallop`]: exact for the straight moves that the sweep is made of. The part's triangles near the path are halved
//! across their longest edge until that edge is short beside the stepover and the height in its middle is within the tolerance of the mean
//! of its ends. New corners are put onto the exact surface.
//!
//! **Limits**: only the ball cuts; corners of one triangle on the edge of another (where one side was halved and the other not) leave hairline
//! gaps in the drawing, none in the heights.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::sweep::Sweep;
use crate::artifact::deviation::DeviationMap;
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};

/// Edges are at least this short before their heights are trusted, as a share of the stepover on a plane.
const SHORT: f64 = 0.25;
/// Edges are not halved below this, mm.
const SHORTEST_MM: f64 = 0.02;
/// Most triangles.
const MOST: usize = 600_000;
/// Places farther from every pass than so many stepovers are not machined.
const REACH_STEPOVERS: f64 = 2.5;
/// Least reach, mm.
const LEAST_REACH_MM: f64 = 0.4;

/// The map of a path over a blade to `tolerance_mm`.
///
/// # Errors
/// `Usage` where the path has fewer than two locations or the tolerance is not greater than 0.
pub fn deviation(blade: &Blade, path: &Toolpath, tolerance_mm: f64) -> Result<DeviationMap> {
    if path.locations.len() < 2 || !(tolerance_mm > 0.0) {
        let what = "a deviation map needs a path of at least 2 cutter locations and a tolerance greater than 0";
        return Err(Error::usage(Stage::Verify, what));
    }
    let part = Allowed::new(&blade.part, path.stock_mm);
    Ok(measure(&part, &Sweep::new(path), path.scallop_mm, tolerance_mm))
}

/// See [`deviation`].
pub(super) fn measure(part: &Allowed, sweep: &Sweep, scallop_mm: f64, tolerance_mm: f64) -> DeviationMap {
    let stepover_mm = (8.0 * sweep.radius_mm * scallop_mm).sqrt();
    let reach_mm = (REACH_STEPOVERS * stepover_mm).max(LEAST_REACH_MM);
    let mut map = Growing { part, sweep, stepover_mm, reach_mm, tolerance_mm, map: DeviationMap::default() };
    map.grow();
    map.map.tolerance_mm = tolerance_mm;
    map.map
}

struct Growing<'a> {
    part: &'a Allowed<'a>,
    sweep: &'a Sweep,
    stepover_mm: f64,
    reach_mm: f64,
    tolerance_mm: f64,
    map: DeviationMap,
}

/// A corner: point, normal, height.
type Corner = (Point, Vector, f64);

impl Growing<'_> {
    fn grow(&mut self) {
        let mesh = &self.part.mesh;
        let mut number = BTreeMap::new();
        let (mut places, mut open) = (Vec::new(), Vec::new());
        // Corners of the mesh are shared within a face only: at an edge there are two normals.
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let face = mesh.face(t);
            let triangle = corners.map(|v| {
                *number.entry((face, v)).or_insert_with(|| {
                    places.push((mesh.points[v as usize], mesh.normal(t)));
                    places.len() as u32 - 1
                })
            });
            open.push(triangle);
        }
        let corners: Vec<Corner> = places.par_iter().map(|(p, n)| self.corner(p, n)).collect();
        self.push(corners);
        while !open.is_empty() {
            open = self.halved(open);
        }
        self.keep_used();
    }

    /// A place of the mesh put onto the surface, with its height.
    fn corner(&self, p: &Point, normal: &Vector) -> Corner {
        let exact = match &self.part.brep {
            Some(_) => Part::closest(self.part, p, 4.0 * self.part.deflection_mm + 1e-6),
            None => None,
        };
        // At an edge between faces the nearest point may be the other face's: its normal says so.
        let (q, n) = match exact {
            Some(c) if c.normal.dot(normal) > 0.5 => (c.point, c.normal),
            _ => (*p, *normal),
        };
        let q = q + n * self.part.stock_mm;
        (q, n, self.sweep.entry(&q, &n, self.reach_mm).unwrap_or(f64::NAN))
    }

    fn push(&mut self, corners: Vec<Corner>) {
        for (p, n, h) in corners {
            self.map.points.push(p);
            self.map.normals.push(n);
            self.map.heights_mm.push(h);
        }
    }

    /// Halves what needs it; what does not goes into the map. Gives the halves.
    fn halved(&mut self, open: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
        let near: Vec<[u32; 3]> = open.into_par_iter().filter(|t| self.near(t)).collect();
        let full = self.map.triangles.len() + 2 * near.len() > MOST;
        // Triangles whose longest edge is to be looked at, by that edge.
        let mut middles: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut looked = Vec::new();
        for t in near {
            let (k, length) = self.longest(&t);
            let edge = (t[k].min(t[(k + 1) % 3]), t[k].max(t[(k + 1) % 3]));
            if full || length <= SHORTEST_MM {
                self.map.coarse += 1;
                self.map.triangles.push(t);
            } else {
                middles.entry(edge).or_insert(0);
                looked.push((t, k, length, edge));
            }
        }
        let first = self.map.points.len();
        let corners: Vec<Corner> = middles
            .keys()
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|(a, b)| {
                let (a, b) = (*a as usize, *b as usize);
                let (p, n) = (&self.map.points, &self.map.normals);
                let normal = (n[a] + n[b]).try_normalize(1e-9).unwrap_or(n[a]);
                // Corners are on the stock; the part is below.
                self.corner(&(nalgebra::center(&p[a], &p[b]) - normal * self.part.stock_mm), &normal)
            })
            .collect();
        middles.values_mut().enumerate().for_each(|(i, m)| *m = (first + i) as u32);
        self.push(corners);
        let mut halves = Vec::new();
        for (t, k, length, edge) in looked {
            let mid = middles.get(&edge).copied().unwrap_or(t[k]);
            let h = |v: u32| self.map.heights_mm[v as usize];
            let off = (h(mid) - 0.5 * (h(edge.0) + h(edge.1))).abs();
            // Where the ball stops coming there is nothing to resolve.
            if length <= SHORT * self.stepover_mm && (off <= self.tolerance_mm || off.is_nan()) {
                self.map.triangles.push(t);
            } else {
                let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                halves.extend([[a, mid, c], [mid, b, c]]);
            }
        }
        halves
    }

    /// Whether the ball comes near any place of a triangle.
    fn near(&self, t: &[u32; 3]) -> bool {
        let corners = t.map(|v| self.map.points[v as usize]);
        let middle = corners[0] + ((corners[1] - corners[0]) + (corners[2] - corners[0])) / 3.0;
        let size = corners.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
        let radius = self.sweep.radius_mm;
        // Normals within a triangle may differ from that of its first corner.
        let normals = t.map(|v| self.map.normals[v as usize]);
        let spread = normals.iter().map(|n| (n - normals[0]).norm()).fold(0.0, f64::max);
        let reach = self.reach_mm + size + radius * spread;
        self.sweep.nearest(&(middle + normals[0] * radius), reach, |_| true).is_some()
    }

    /// The longest edge: its first corner and its length.
    fn longest(&self, t: &[u32; 3]) -> (usize, f64) {
        let p = t.map(|v| self.map.points[v as usize]);
        let length = |k: usize| (p[(k + 1) % 3] - p[k]).norm();
        (0..3).map(|k| (k, length(k))).fold((0, -1.0), |best, e| if e.1 > best.1 { e } else { best })
    }

    /// Leaves out corners that no triangle has.
    fn keep_used(&mut self) {
        let map = &mut self.map;
        let mut number = vec![u32::MAX; map.points.len()];
        let (mut points, mut normals, mut heights) = (Vec::new(), Vec::new(), Vec::new());
        for v in map.triangles.iter_mut().flatten() {
            let old = *v as usize;
            if number[old] == u32::MAX {
                number[old] = points.len() as u32;
                points.push(map.points[old]);
                normals.push(map.normals[old]);
                heights.push(map.heights_mm[old]);
            }
            *v = number[old];
        }
        (map.points, map.normals, map.heights_mm) = (points, normals, heights);
    }
}
