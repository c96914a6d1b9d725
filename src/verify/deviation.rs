//! The deviation map: what the swept ball leaves over the part, on triangles as fine as the heights
//! need.
//!
//! **In**: part and swept ball. **Out**: a [`DeviationMap`]. The height at a point of the surface
//! is where its normal enters the swept ball, as in [`super::scallop`]: exact for the straight
//! moves that the sweep is made of. The part's triangles near the path are halved across their
//! longest edge until that edge is short beside the stepover and the height in its middle is within
//! the tolerance of the mean of its ends. New corners are put onto the exact surface.
//!
//! ## Bound in triangles that are not fine enough
//! Where triangles may not be halved any further the height between corners is bounded. A ball
//! whose centre is `R sin φ` off the normal's line has there a height whose slope along the surface
//! is at most `tan φ`, and so has the lowest of several balls (a turn `δn` of the normal adds
//! `h δn` to the way). In a triangle of longest edge `ℓ` a ball gets no farther from the normal's
//! line than at a corner plus `ℓ + R δn`. No ball counts that is farther off than the reach, which
//! bounds all slopes; and only balls count that, at a corner, are no higher over the lowest one
//! than this slope makes up for on twice the way to any place of the triangle. Of those, the
//! farthest off gives `φ`. The mean distance of a place to the corners, weighted as the linear
//! interpolation weights them, is at most `ℓ/√3`. So the height is off the linear one by at most
//!
//! ```text
//! tan φ (ℓ/√3 + h δn),   R sin φ = greatest distance off a corner's normal + ℓ + R δn
//! ```
//!
//! of which [`DeviationMap::coarse_bound_mm`] is the greatest over those triangles. It says nothing
//! of triangles with a corner where the ball does not come.
//!
//! Where normals turn so fast that `sin φ` has no bound below 1 (an edge sharper than the shortest
//! triangle), a height along the normal has none either: the line may miss every ball. There the
//! *distance*
//! `g` to the swept ball is bounded instead. It changes by no more than one goes along the part, so
//! in such a triangle
//!
//! ```text
//! |g − linear height| ≤ ℓ/√3 + greatest |g − height| of its corners
//! ```
//!
//! which [`DeviationMap::sharp_bound_mm`] is the greatest of; how many there are, and their area,
//! is reported with it. Corners on a sharp edge are kept apart, one for each side, so that only
//! edges that are rounded more tightly than the triangles are short come to this.
//!
//! **Limits**: only the ball cuts; corners of one triangle on the edge of another (where one side
//! was halved and the other not) leave hairline gaps in the drawing, none in the heights.

use std::collections::BTreeMap;

use super::height::flat_stepover;
use super::sweep::Sweep;
use crate::artifact::deviation::DeviationMap;
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::geometry::part::Part;
use crate::geometry::{Point, Vector};
use crate::parallel;

/// Edges are at least this short before their heights are trusted, as a share of the stepover on a
/// plane.
const SHORT: f64 = 0.25;
/// Edges are not halved below this, mm.
const SHORTEST_MM: f64 = 0.02;
/// Most triangles.
const MOST: usize = 600_000;
/// Places farther from every pass than so many stepovers are not machined.
const REACH_STEPOVERS: f64 = 2.5;
/// Normals of one corner differ by no more than this, as a cosine (20 degrees): else it is one of
/// two sides of an edge.
const ONE_SIDE: f64 = 0.94;
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
    Ok(measure(&part, &[ToolCut::new(Sweep::cutting(path), path.scallop_mm)], tolerance_mm))
}

/// What one tool has cut.
pub(super) struct ToolCut {
    sweep: Sweep,
    /// Stepover on a plane, mm.
    stepover_mm: f64,
    /// How far from a pass a place counts as machined, mm.
    reach_mm: f64,
}

impl ToolCut {
    /// A swept ball whose passes leave ridges of about `scallop_mm`.
    pub(super) fn new(sweep: Sweep, scallop_mm: f64) -> Self {
        let stepover_mm = flat_stepover(sweep.radius_mm, scallop_mm);
        ToolCut { sweep, stepover_mm, reach_mm: (REACH_STEPOVERS * stepover_mm).max(LEAST_REACH_MM) }
    }
}

/// See [`deviation`]; of several tools what all of them together leave.
pub(super) fn measure(part: &Allowed, cuts: &[ToolCut], tolerance_mm: f64) -> DeviationMap {
    measure_within(part, cuts, tolerance_mm, MOST)
}

fn measure_within(part: &Allowed, cuts: &[ToolCut], tolerance_mm: f64, most: usize) -> DeviationMap {
    let stepover_mm = cuts.iter().map(|c| c.stepover_mm).fold(f64::INFINITY, f64::min);
    let map = DeviationMap::default();
    let mut map = Growing { part, cuts, stepover_mm, tolerance_mm, most, map, faces: Vec::new(), coarse: Vec::new() };
    map.grow();
    map.bound_coarse();
    map.keep_used();
    map.map.tolerance_mm = tolerance_mm;
    map.map
}

struct Growing<'a> {
    part: &'a Allowed<'a>,
    cuts: &'a [ToolCut],
    stepover_mm: f64,
    tolerance_mm: f64,
    most: usize,
    map: DeviationMap,
    /// Face of each corner.
    faces: Vec<u32>,
    /// Triangles of the map that are not fine enough.
    coarse: Vec<usize>,
}

/// A corner: point, normal, height.
type Corner = (Point, Vector, f64);

/// What is known of a triangle that is not fine enough.
enum KnownBound {
    /// Nothing: the ball does not come to all corners.
    None,
    /// Heights are off the linear one by no more than this, mm.
    Height(f64),
    /// Distances to the swept ball are, mm; and its area, mm².
    Distance(f64, f64),
}

impl Growing<'_> {
    fn grow(&mut self) {
        let mesh = &self.part.mesh;
        let mut seats: BTreeMap<(u32, u32), Vec<u32>> = BTreeMap::new();
        let (mut places, mut open): (Vec<(Point, Vector, u32)>, _) = (Vec::new(), Vec::new());
        // Corners of the mesh are shared within a face only, and on one side of a crease: at an
        // edge there are two normals.
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let (face, normal) = (mesh.face(t), mesh.normal(t));
            let triangle = corners.map(|v| {
                let own = seats.entry((face, v)).or_default();
                let same = own.iter().find(|k| places[**k as usize].1.dot(&normal) > ONE_SIDE);
                same.copied().unwrap_or_else(|| {
                    own.push(places.len() as u32);
                    places.push((mesh.points[v as usize], normal, face));
                    places.len() as u32 - 1
                })
            });
            open.push(triangle);
        }
        let corners: Vec<Corner> = parallel::map(&places, |(p, n, face)| self.corner(p, n, *face));
        self.push(corners, places.iter().map(|p| p.2));
        while !open.is_empty() {
            open = self.halved(open);
        }
    }

    /// The lowest surface that any tool leaves over a place.
    fn height(&self, q: &Point, n: &Vector) -> f64 {
        let over = self.cuts.iter().filter_map(|c| c.sweep.entry(q, n, c.reach_mm));
        over.reduce(f64::min).unwrap_or(f64::NAN)
    }

    /// What is known of the triangles that are not fine enough; see the module's page.
    fn bound_coarse(&mut self) {
        let bounds = parallel::map(&self.coarse, |t| self.triangle_bound(&self.map.triangles[*t]));
        let map = &mut self.map;
        map.coarse = bounds.len();
        for bound in bounds {
            match bound {
                KnownBound::None => {}
                KnownBound::Height(mm) => map.coarse_bound_mm = map.coarse_bound_mm.max(mm),
                KnownBound::Distance(mm, area_mm2) => {
                    map.sharp += 1;
                    map.sharp_area_mm2 += area_mm2;
                    map.sharp_bound_mm = map.sharp_bound_mm.max(mm);
                }
            }
        }
    }

    /// Distance of a place to the ball of any tool, negative inside.
    fn distance(&self, p: &Point) -> f64 {
        let one = |c: &ToolCut| c.sweep.nearest(p, f64::INFINITY, |_| true).map(|n| n.distance_mm - c.sweep.radius_mm);
        self.cuts.iter().filter_map(one).fold(f64::INFINITY, f64::min)
    }

    /// How far the height in a triangle, or the distance to the ball, may be off the linear height.
    fn triangle_bound(&self, t: &[u32; 3]) -> KnownBound {
        let (_, length) = self.longest(t);
        let normals = t.map(|v| self.map.normals[v as usize]);
        let turn = (0..3).map(|k| (normals[(k + 1) % 3] - normals[k]).norm()).fold(0.0, f64::max);
        let heights = t.map(|v| self.map.heights_mm[v as usize]);
        if heights.iter().any(|h| h.is_nan()) {
            return KnownBound::None;
        }
        let height = heights.iter().fold(0.0, |m: f64, h| m.max(h.abs()));
        let slope = |offset_mm: f64, radius_mm: f64| {
            let sine = (offset_mm + length) / radius_mm + turn;
            if sine < 1.0 { sine / (1.0 - sine * sine).sqrt() } else { f64::INFINITY }
        };
        let way = length + height * turn;
        // No ball that counts anywhere in the triangle is steeper than this.
        let steepest = self.cuts.iter().map(|c| slope(c.reach_mm, c.sweep.radius_mm)).fold(0.0, f64::max);
        // Seen from any corner; the best of them.
        let from = |k: usize| {
            let (p, n) = (&self.map.points[t[k] as usize], &self.map.normals[t[k] as usize]);
            let lowest = heights[k] + 2.0 * steepest * way;
            let one = |c: &ToolCut| {
                let radius = c.sweep.radius_mm;
                let off = c.sweep.farthest_off(p, n, c.reach_mm + length + radius * turn, [lowest, way]);
                off.map_or(0.0, |off| slope(off.min(c.reach_mm), radius))
            };
            self.cuts.iter().map(one).fold(0.0, f64::max)
        };
        let best = (0..3).map(from).fold(f64::INFINITY, f64::min);
        let bound = best * (length / 3f64.sqrt() + height * turn);
        if bound.is_finite() {
            return KnownBound::Height(bound);
        }
        let points = t.map(|v| self.map.points[v as usize]);
        let apart = (0..3).map(|k| (self.distance(&points[k]) - heights[k]).abs()).fold(0.0, f64::max);
        let area = 0.5 * (points[1] - points[0]).cross(&(points[2] - points[0])).norm();
        KnownBound::Distance(length / 3f64.sqrt() + apart, area)
    }

    /// A place of a face of the mesh put onto the surface, with its height.
    fn corner(&self, p: &Point, normal: &Vector, face: u32) -> Corner {
        let exact = match &self.part.brep {
            Some(_) => Part::closest(self.part, p, 4.0 * self.part.deflection_mm + 1e-6),
            None => None,
        };
        // At an edge between faces the nearest point may be the other face's: the place is good,
        // its normal is not.
        let (q, n) = match exact {
            Some(c) if c.normal.dot(normal) > if c.face == face { 0.5 } else { ONE_SIDE } => (c.point, c.normal),
            Some(c) if c.normal.dot(normal) > 0.0 => (c.point, *normal),
            _ => (*p, *normal),
        };
        let q = q + n * self.part.stock_mm;
        (q, n, self.height(&q, &n))
    }

    fn push(&mut self, corners: Vec<Corner>, faces: impl Iterator<Item = u32>) {
        self.faces.extend(faces);
        for (p, n, h) in corners {
            self.map.points.push(p);
            self.map.normals.push(n);
            self.map.heights_mm.push(h);
        }
    }

    /// Halves what needs it; what does not goes into the map. Gives the halves.
    fn halved(&mut self, open: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
        let near: Vec<[u32; 3]> = parallel::filter(open, |t| self.near(t));
        let full = self.map.triangles.len() + 2 * near.len() > self.most;
        // Triangles whose longest edge is to be looked at, by that edge.
        let mut middles: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut looked = Vec::new();
        for t in near {
            let (k, length) = self.longest(&t);
            let edge = (t[k].min(t[(k + 1) % 3]), t[k].max(t[(k + 1) % 3]));
            if full || length <= SHORTEST_MM {
                self.coarse.push(self.map.triangles.len());
                self.map.triangles.push(t);
            } else {
                middles.entry(edge).or_insert(0);
                looked.push((t, k, length, edge));
            }
        }
        let first = self.map.points.len();
        let corners: Vec<Corner> = parallel::map(middles.keys(), |(a, b)| {
            let (a, b) = (*a as usize, *b as usize);
            let (p, n) = (&self.map.points, &self.map.normals);
            let normal = (n[a] + n[b]).try_normalize(1e-9).unwrap_or(n[a]);
            // Corners are on the stock; the part is below.
            self.corner(&(nalgebra::center(&p[a], &p[b]) - normal * self.part.stock_mm), &normal, self.faces[a])
        });
        middles.values_mut().enumerate().for_each(|(i, m)| *m = (first + i) as u32);
        let faces: Vec<u32> = middles.keys().map(|(a, _)| self.faces[*a as usize]).collect();
        self.push(corners, faces.into_iter());
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
        // Normals within a triangle may differ from that of its first corner.
        let normals = t.map(|v| self.map.normals[v as usize]);
        let spread = normals.iter().map(|n| (n - normals[0]).norm()).fold(0.0, f64::max);
        self.cuts.iter().any(|c| {
            let radius = c.sweep.radius_mm;
            let reach = c.reach_mm + size + radius * spread;
            c.sweep.nearest(&(middle + normals[0] * radius), reach, |_| true).is_some()
        })
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::sample;

    /// A map that may not grow: heights anywhere in its triangles against the linear ones.
    #[test]
    fn the_bound_holds_in_triangles_that_may_not_be_halved() {
        let (blade, plan) = (sample::blade(), sample::plan(4, 90));
        let part = Allowed::new(&blade.part, 0.0);
        let path = &plan.toolpath;
        let cut = || ToolCut::new(Sweep::new(path), path.scallop_mm);
        let mut before = f64::INFINITY;
        for most in [20_000, 80_000] {
            let cuts = [cut()];
            let map = measure_within(&part, &cuts, 1e-5, most);
            assert!(map.coarse > 100 && map.coarse_bound_mm.is_finite(), "{} {}", map.coarse, map.coarse_bound_mm);
            let mut worst = 0.0f64;
            for (k, t) in map.triangles.iter().enumerate() {
                let h = t.map(|v| map.heights_mm[v as usize]);
                if h.iter().any(|h| h.is_nan()) {
                    continue;
                }
                // A place that differs from triangle to triangle.
                let (a, b) = (((k * 7) % 11) as f64 / 11.0, ((k * 5) % 13) as f64 / 13.0);
                let w = if a + b > 1.0 { [1.0 - a, 1.0 - b, a + b - 1.0] } else { [a, b, 1.0 - a - b] };
                let mix = |of: &dyn Fn(usize) -> Vector| (0..3).map(|i| of(i) * w[i]).sum::<Vector>();
                let p = Point::from(mix(&|i| map.points[t[i] as usize].coords));
                let n = mix(&|i| map.normals[t[i] as usize]).normalize();
                let linear: f64 = (0..3).map(|i| h[i] * w[i]).sum();
                let Some(at) = blade.part.closest(&p, 1.0) else { continue };
                let there = cuts[0].sweep.entry(&at.point, &n, cuts[0].reach_mm).unwrap_or(linear);
                worst = worst.max((there - linear).abs());
            }
            assert!(worst <= map.coarse_bound_mm, "{worst} {}", map.coarse_bound_mm);
            assert!(
                map.coarse_bound_mm < before && map.coarse_bound_mm < 100.0 * worst,
                "{worst} {}",
                map.coarse_bound_mm
            );
            before = map.coarse_bound_mm;
        }
    }

    /// Places within a triangle of the map, by weights of its corners.
    fn within(map: &DeviationMap, t: &[u32; 3]) -> Vec<(Point, f64)> {
        let grid = (0..=12).flat_map(|a| (0..=12 - a).map(move |b| [a, b, 12 - a - b].map(|w| f64::from(w) / 12.0)));
        let mix = |w: [f64; 3]| {
            let p = (0..3).map(|k| map.points[t[k] as usize].coords * w[k]).sum::<Vector>();
            (Point::from(p), (0..3).map(|k| map.heights_mm[t[k] as usize] * w[k]).sum())
        };
        grid.map(mix).collect()
    }

    /// Triangles on edges sharper than they are short: distances to the swept ball anywhere in
    /// them, against the linear heights.
    #[test]
    fn the_bound_of_distances_holds_where_normals_turn_too_fast() {
        let (blade, plan) = (sample::blade(), sample::plan(4, 90));
        let part = Allowed::new(&blade.part, 0.0);
        let cuts = [ToolCut { reach_mm: 4.0, ..ToolCut::new(Sweep::new(&plan.toolpath), plan.toolpath.scallop_mm) }];
        let mut map = DeviationMap::default();
        for (k, l) in plan.toolpath.locations.iter().enumerate().skip(95).step_by(7).take(30) {
            // Across the edge normals lean to both sides, by up to 35 degrees.
            let (lean, size) = ((20.0 + 1.5 * (k % 11) as f64).to_radians(), 0.01 + 0.002 * (k % 7) as f64);
            let across = Vector::x();
            let along = l.normal.cross(&across);
            for (side, step) in [(1.0, across * size), (-1.0, -across * size), (-1.0, along * size)] {
                let normal = (l.normal * lean.cos() + across * (side * lean.sin())).normalize();
                let point = l.contact + across * 0.17 + step;
                map.triangles
                    .extend((map.points.len() % 3 == 2).then(|| [2, 1, 0].map(|b| map.points.len() as u32 - b)));
                map.points.push(point);
                map.normals.push(normal);
                map.heights_mm.push(cuts[0].sweep.entry(&point, &normal, cuts[0].reach_mm).unwrap_or(f64::NAN));
            }
        }
        let coarse = (0..map.triangles.len()).collect();
        let mut grown = Growing {
            part: &part,
            cuts: &cuts,
            stepover_mm: 0.6,
            tolerance_mm: 0.001,
            most: 10,
            map,
            faces: Vec::new(),
            coarse,
        };
        grown.bound_coarse();
        let map = &grown.map;
        assert!(map.sharp > 10 && map.coarse == 30, "{} {}", map.sharp, map.coarse);
        assert!(
            map.coarse_bound_mm.is_finite() && map.sharp_bound_mm < 2.0,
            "{} {}",
            map.coarse_bound_mm,
            map.sharp_bound_mm
        );
        let (mut area, mut worst) = (0.0, 0.0f64);
        for t in &map.triangles {
            let KnownBound::Distance(bound, own) = grown.triangle_bound(t) else { continue };
            area += own;
            for (p, linear) in within(map, t) {
                let off = (grown.distance(&p) - linear).abs();
                assert!(off <= bound, "{off} {bound}");
                worst = worst.max(off);
            }
        }
        assert!((area - map.sharp_area_mm2).abs() < 1e-12 && worst <= map.sharp_bound_mm);
    }

    /// A mesh without groups has creases: each side has corners of its own.
    #[test]
    fn corners_on_a_crease_are_kept_apart() {
        let (blade, plan) = (sample::blade(), sample::plan(2, 60));
        let map = deviation(&blade, &plan.toolpath, 0.001).unwrap();
        let turn = |t: &[u32; 3]| {
            let n = t.map(|v| map.normals[v as usize]);
            (0..3).map(|k| (n[(k + 1) % 3] - n[k]).norm()).fold(0.0, f64::max)
        };
        let worst = map.triangles.iter().map(turn).fold(0.0, f64::max);
        assert!(worst < 0.4 && map.sharp == 0, "{worst}");
        // The tip's rim is such a crease: there are corners of both its sides, or the map would not
        // reach it.
        assert!(map.coarse_bound_mm.is_finite());
    }

    /// Two tools together leave what the lower of both leaves.
    #[test]
    fn several_tools_leave_the_lower_surface() {
        let blade = sample::blade();
        let part = Allowed::new(&blade.part, 0.0);
        let [a, b] = [sample::plan(4, 60), sample::plan(2, 60)].map(|p| p.toolpath);
        let cut = |p: &Toolpath| ToolCut::new(Sweep::new(p), p.scallop_mm);
        let map = measure_within(&part, &[cut(&a), cut(&b)], 0.001, 20_000);
        let each = [cut(&a), cut(&b)];
        let mut both = 0;
        for ((p, n), h) in map.points.iter().zip(&map.normals).zip(&map.heights_mm) {
            let over: Vec<f64> = each.iter().filter_map(|c| c.sweep.entry(p, n, c.reach_mm)).collect();
            let least = over.iter().copied().reduce(f64::min);
            assert_eq!(least.is_none(), h.is_nan());
            assert!(least.is_none_or(|l| l == *h));
            both += usize::from(over.len() == 2);
        }
        assert!(both > 100, "{both}");
    }
}
