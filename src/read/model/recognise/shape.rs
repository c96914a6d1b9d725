//! Measures of a section loop: how much it looks like an airfoil.
//!
//! An airfoil is slender, ends in two edges thinner than its middle, and has at most one deep
//! hollow (its concave side). Platforms, roots and discs fail at least one of these; so does a cut
//! through platform and airfoil at once, a T with a deep hollow on either side of its web.

use crate::geometry::slice::Loop;
use crate::numerics::angle::within_half_turn;

/// Measures of one closed loop.
#[derive(Clone, Copy, Debug)]
pub struct LoopShape {
    /// Area, mm².
    pub area_mm2: f64,
    /// Length of the loop, mm.
    pub perimeter_mm: f64,
    /// Centroid (y, z), mm.
    pub centroid: [f64; 2],
    /// Box: least y, least z, greatest y, greatest z, mm.
    pub bounds: [f64; 4],
    /// 4π area / perimeter²: 1 for a circle.
    pub roundness: f64,
    /// Hollows of the convex hull deeper than [`HOLLOW`] of the longest extent.
    pub hollows: usize,
    /// Depth of the second deepest of them over the longest extent; 0 where there is none.
    pub second_hollow: f64,
    /// Width near the wider end over the greatest width, both across the main axis.
    pub bluntness: f64,
    /// 0…1, product of the above as ramps.
    pub likeness: f64,
}

/// Depth of a hollow that counts, as a share of the longest extent.
const HOLLOW: f64 = 0.04;
/// A second hollow up to the first of these depths, as shares of the longest extent, may lie beside
/// a web that is as thin as the airfoil; from the second one on the cut goes through a platform.
const SECOND_HOLLOW: [f64; 2] = [0.12, 0.18];
/// Likeness of a slender bar with square ends.
pub const BLUNT: f64 = 0.3;
/// Where the ends' width is taken, as a share of the extent along the main axis.
const NEAR_END: f64 = 0.03;

impl LoopShape {
    /// Measures a closed loop of positive area; `None` for others.
    pub fn new(l: &Loop) -> Option<LoopShape> {
        let area = l.area_mm2();
        let perimeter = l.length_mm();
        if !l.closed || area <= 0.0 || perimeter <= 0.0 {
            return None;
        }
        let (centroid, axis) = moments(&l.points, area)?;
        let bounds = l.points.iter().fold([f64::MAX, f64::MAX, f64::MIN, f64::MIN], |b, p| {
            [b[0].min(p[0]), b[1].min(p[1]), b[2].max(p[0]), b[3].max(p[1])]
        });
        let roundness = 4.0 * std::f64::consts::PI * area / (perimeter * perimeter);
        let depths = hollows(&l.points);
        let (hollows, second_hollow) = (depths.len(), depths.get(1).copied().unwrap_or(0.0));
        let bluntness = bluntness(&l.points, axis);
        let pointed = falling(bluntness, 0.65, 0.95).min(1.0 - block(&l.points, perimeter, roundness));
        let likeness = falling(roundness, 0.55, 0.9)
            * [1.0, 1.0, 0.7, 0.1].get(hollows).copied().unwrap_or(0.0)
            * (0.1 + 0.9 * falling(second_hollow, SECOND_HOLLOW[0], SECOND_HOLLOW[1]))
            * (BLUNT + (1.0 - BLUNT) * pointed);
        Some(LoopShape {
            area_mm2: area,
            perimeter_mm: perimeter,
            centroid,
            bounds,
            roundness,
            hollows,
            second_hollow,
            bluntness,
            likeness,
        })
    }

    /// The same loop seen from an origin at (y, z).
    pub fn seen_from(mut self, origin: [f64; 2]) -> LoopShape {
        for k in 0..2 {
            self.centroid[k] -= origin[k];
            self.bounds[k] -= origin[k];
            self.bounds[k + 2] -= origin[k];
        }
        self
    }

    /// Whether this loop continues the other one a small step along the axis: area, perimeter and
    /// place change little.
    pub fn continues(&self, other: &LoopShape, looseness: f64) -> bool {
        let near = |a: f64, b: f64| a.max(b) < (1.0 + looseness) * a.min(b);
        let shift = (self.centroid[0] - other.centroid[0]).hypot(self.centroid[1] - other.centroid[1]);
        near(self.area_mm2, other.area_mm2)
            && near(self.perimeter_mm, other.perimeter_mm)
            && shift < 0.25 * looseness.min(1.0) * 0.5 * self.perimeter_mm.min(other.perimeter_mm)
    }
}

/// 1 for a stout loop of four straight sides, sheared or not, as platforms and roots have; 0 for
/// one that is slender or curved.
fn block(points: &[[f64; 2]], perimeter_mm: f64, roundness: f64) -> f64 {
    let stout = 1.0 - falling(roundness, 0.45, 0.55);
    if stout == 0.0 {
        return 0.0;
    }
    let n = points.len();
    let steps: Vec<[f64; 2]> =
        points.iter().zip(points.iter().cycle().skip(1)).map(|(p, q)| [q[0] - p[0], q[1] - p[1]]).collect();
    let directions: Vec<f64> = steps.iter().map(|d| d[1].atan2(d[0])).collect();
    // How much the loop turns behind each step.
    let turns: Vec<f64> = (0..n).map(|i| within_half_turn(directions[(i + 1) % n] - directions[i])).collect();
    // From a corner on, so that no side is taken for two.
    let Some(corner) = (0..n).max_by(|&i, &j| turns[i].abs().total_cmp(&turns[j].abs())) else { return 0.0 };
    let mut sides = vec![0.0];
    let mut bent = 0.0;
    for i in (corner + 1..n).chain(0..=corner) {
        if let Some(side) = sides.last_mut() {
            *side += steps[i][0].hypot(steps[i][1]);
        }
        bent += turns[i];
        if f64::abs(bent) > STRAIGHT_RAD {
            sides.push(0.0);
            bent = 0.0;
        }
    }
    sides.sort_by(|a, b| b.total_cmp(a));
    let share = sides.iter().take(4).sum::<f64>() / perimeter_mm;
    (1.0 - falling(share, 0.75, 0.9)) * stout
}

/// A side that turns less is straight.
const STRAIGHT_RAD: f64 = 0.03;

/// 1 up to `from`, 0 beyond `to`, a straight ramp between.
fn falling(x: f64, from: f64, to: f64) -> f64 {
    ((to - x) / (to - from)).clamp(0.0, 1.0)
}

/// Centroid and unit vector of the main axis of the area, by Green's theorem.
fn moments(points: &[[f64; 2]], area: f64) -> Option<([f64; 2], [f64; 2])> {
    let o = *points.first()?;
    let (mut first, mut second) = ([0.0; 2], [0.0; 3]);
    for (i, p) in points.iter().enumerate() {
        let q = points[(i + 1) % points.len()];
        let (a, b) = ([p[0] - o[0], p[1] - o[1]], [q[0] - o[0], q[1] - o[1]]);
        let cross = a[0] * b[1] - a[1] * b[0];
        for k in 0..2 {
            first[k] += cross * (a[k] + b[k]) / 6.0;
        }
        let product =
            |i: usize, j: usize| cross * (a[i] * a[j] + b[i] * b[j] + 0.5 * (a[i] * b[j] + b[i] * a[j])) / 12.0;
        second[0] += product(0, 0);
        second[1] += product(0, 1);
        second[2] += product(1, 1);
    }
    let c = [first[0] / area, first[1] / area];
    let (yy, yz, zz) = (second[0] - area * c[0] * c[0], second[1] - area * c[0] * c[1], second[2] - area * c[1] * c[1]);
    let angle = 0.5 * (2.0 * yz).atan2(yy - zz);
    Some(([o[0] + c[0], o[1] + c[1]], [angle.cos(), angle.sin()]))
}

/// Depths of the pockets between the loop and its convex hull that are deeper than [`HOLLOW`], as
/// shares of the hull's extent, the deepest first.
fn hollows(points: &[[f64; 2]]) -> Vec<f64> {
    let hull = hull(points);
    if hull.len() < 3 {
        return Vec::new();
    }
    // The greatest extent in any of 16 directions: within 0.5 % of the diameter.
    let extent = (0..16)
        .map(|k| f64::from(k) * std::f64::consts::PI / 16.0)
        .map(|angle| {
            let along = hull.iter().map(|&i| points[i][0] * angle.cos() + points[i][1] * angle.sin());
            let (lo, hi) = along.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
            hi - lo
        })
        .fold(0.0, f64::max);
    let n = points.len();
    // The hull in the loop's own order: between two neighbours on it lies one pocket.
    let mut on_hull = hull;
    on_hull.sort_unstable();
    let mut depths: Vec<f64> = (0..on_hull.len())
        .map(|k| {
            let (i, j) = (on_hull[k], on_hull[(k + 1) % on_hull.len()]);
            let (a, b) = (points[i], points[j]);
            let length = (b[0] - a[0]).hypot(b[1] - a[1]);
            let count = (j + n - i) % n;
            let depth = (1..count)
                .map(|s| points[(i + s) % n])
                .map(|p| {
                    ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length.max(f64::MIN_POSITIVE)
                })
                .fold(0.0, f64::max);
            depth / extent
        })
        .filter(|&depth| depth > HOLLOW)
        .collect();
    depths.sort_by(|a, b| b.total_cmp(a));
    depths
}

/// Indices of the convex hull's corners (Andrew's monotone chain), counter-clockwise.
fn hull(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i][0].total_cmp(&points[j][0]).then(points[i][1].total_cmp(&points[j][1])));
    let turn = |i: usize, j: usize, k: usize| {
        let (a, b, c) = (points[i], points[j], points[k]);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let mut chain: Vec<usize> = Vec::new();
    for pass in 0..2 {
        let start = chain.len();
        let walk: Box<dyn Iterator<Item = &usize>> =
            if pass == 0 { Box::new(order.iter()) } else { Box::new(order.iter().rev()) };
        for &i in walk {
            while chain.len() >= start + 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], i) <= 0.0 {
                chain.pop();
            }
            chain.push(i);
        }
        chain.pop();
    }
    chain
}

/// Width near both ends, the greater, over the greatest width across the main axis on the way. Near
/// an end the width is taken across the direction in which the loop runs there: a cambered airfoil
/// ends aslant.
fn bluntness(points: &[[f64; 2]], axis: [f64; 2]) -> f64 {
    let (lo, hi) = range(points, axis);
    let extent = hi - lo;
    let widest = (1..20).map(|k| width(points, axis, lo + f64::from(k) / 20.0 * extent, |_| true)).fold(0.0, f64::max);
    if widest <= 0.0 {
        return 1.0;
    }
    // The circle about an end must be wider than the body there, and far smaller than the loop.
    let reach = (1.5 * widest).max(RUN_OUT[0] * extent);
    let end = |sign: f64| {
        if reach > RUN_OUT[1] * extent {
            return None;
        }
        let out = axis.map(|a| a * sign);
        let along = |p: &[f64; 2]| p[0] * out[0] + p[1] * out[1];
        let tip = points.iter().copied().max_by(|p, q| along(p).total_cmp(&along(q)))?;
        let apart = |p: &[f64; 2]| (p[0] - tip[0]).hypot(p[1] - tip[1]);
        let outer = middle(points, |p| apart(p) < reach)?;
        let inner = middle(points, |p| (reach..2.0 * reach).contains(&apart(p)))?;
        let d = [outer[0] - inner[0], outer[1] - inner[1]];
        let length = d[0].hypot(d[1]);
        let out = if length > 0.0 { d.map(|x| x / length) } else { out };
        let near: Vec<[f64; 2]> = points.iter().copied().filter(|p| apart(p) < reach).collect();
        let (_, far) = range(&near, out);
        Some(width(points, out, far - NEAR_END * extent, |p| apart(p) < 2.0 * reach))
    };
    let across = |sign: f64| {
        let at = if sign < 0.0 { lo + NEAR_END * extent } else { hi - NEAR_END * extent };
        width(points, axis, at, |_| true)
    };
    // Where an end is too wide or has too few points to give its direction, across the main axis.
    let ends = [-1.0, 1.0].map(|sign| end(sign).unwrap_or_else(|| across(sign)));
    ends[0].max(ends[1]) / widest
}

/// Least and greatest stretch of a loop that shows in which direction it ends, as a share of its
/// extent.
const RUN_OUT: [f64; 2] = [0.12, 0.3];

/// Least and greatest place along a direction.
fn range(points: &[[f64; 2]], axis: [f64; 2]) -> (f64, f64) {
    let places = points.iter().map(|p| p[0] * axis[0] + p[1] * axis[1]);
    places.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)))
}

/// Middle of those segments of the loop whose first point is wanted, weighted by length; `None`
/// where there are none.
fn middle(points: &[[f64; 2]], wanted: impl Fn(&[f64; 2]) -> bool) -> Option<[f64; 2]> {
    let (mut sum, mut length) = ([0.0; 2], 0.0);
    for (i, p) in points.iter().enumerate().filter(|(_, p)| wanted(p)) {
        let q = points[(i + 1) % points.len()];
        if !wanted(&q) {
            continue;
        }
        let d = (q[0] - p[0]).hypot(q[1] - p[1]);
        length += d;
        for k in 0..2 {
            sum[k] += 0.5 * d * (p[k] + q[k]);
        }
    }
    (length > 0.0).then(|| sum.map(|s| s / length))
}

/// Total length of the chords across the axis at one place, of those that begin on wanted points:
/// hollow stretches count only what is material.
fn width(points: &[[f64; 2]], axis: [f64; 2], at: f64, wanted: impl Fn(&[f64; 2]) -> bool) -> f64 {
    let along = |p: &[f64; 2]| p[0] * axis[0] + p[1] * axis[1];
    let across = |p: &[f64; 2]| p[1] * axis[0] - p[0] * axis[1];
    let mut hits: Vec<f64> = Vec::new();
    for (i, p) in points.iter().enumerate() {
        let q = &points[(i + 1) % points.len()];
        let (a, b) = (along(p), along(q));
        if (a > at) != (b > at) && (wanted(p) || wanted(q)) {
            hits.push(across(p) + (at - a) / (b - a) * (across(q) - across(p)));
        }
    }
    hits.sort_by(f64::total_cmp);
    hits.chunks_exact(2).map(|c| c[1] - c[0]).sum::<f64>()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn shape(points: Vec<[f64; 2]>) -> LoopShape {
        let triangles = vec![0; points.len()];
        LoopShape::new(&Loop { points, triangles, closed: true }).unwrap()
    }

    /// An arc-shaped airfoil: camber arc of this height, parabolic thickness.
    fn airfoil(camber: f64, thickness: f64, turn: f64) -> Vec<[f64; 2]> {
        let n = 60;
        let side = |k: i32, sign: f64| {
            let x = f64::from(k) / f64::from(n);
            let y = 4.0 * camber * x * (1.0 - x) + sign * 2.0 * thickness * x * (1.0 - x);
            [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()]
        };
        (0..n).map(|k| side(k, -1.0)).chain((1..=n).rev().map(|k| side(k, 1.0))).collect()
    }

    #[test]
    fn airfoils_look_like_airfoils_in_any_position() {
        for (camber, thickness) in [(0.0, 0.05), (0.05, 0.1), (0.25, 0.15), (0.4, 0.1)] {
            for turn in [0.0, 0.7, 2.0, -1.2] {
                let s = shape(airfoil(camber, thickness, turn));
                assert!(s.likeness > 0.9, "camber {camber}, thickness {thickness}: {s:?}");
                assert!(s.hollows <= 1);
            }
        }
    }

    #[test]
    fn plates_bars_circles_and_profiles_do_not() {
        let circle = (0..64).map(|k| f64::from(k) * std::f64::consts::TAU / 64.0).map(|a| [a.cos(), a.sin()]).collect();
        assert!(shape(circle).likeness < 1e-9);
        let bar = vec![[0.0, 0.0], [10.0, 0.0], [10.0, 1.0], [0.0, 1.0]];
        assert!(shape(bar).likeness < 0.31);
        // Platforms and roots sheared by 8° to 20°, corner to corner.
        for shear in [0.14, 0.25, 0.36] {
            for wide in [3.5, 4.5, 6.0] {
                let sheared = vec![[0.0, 0.0], [10.0, 10.0 * shear], [10.0, 10.0 * shear + wide], [0.0, wide]];
                let s = shape(sheared);
                assert!(s.likeness < BLUNT + 1e-9, "shear {shear}, {wide} wide: {s:?}");
            }
        }
        // An I: web between two flanges.
        let i = vec![
            [0., 0.],
            [6., 0.],
            [6., 1.],
            [3.5, 1.],
            [3.5, 9.],
            [6., 9.],
            [6., 10.],
            [0., 10.],
            [0., 9.],
            [2.5, 9.],
            [2.5, 1.],
            [0., 1.],
        ];
        assert_eq!(shape(i).hollows, 2);
    }

    #[test]
    fn an_airfoil_on_its_platform_cut_through_both_does_not() {
        for web in [0.8, 1.5, 3.0] {
            for (wide, thick) in [(8.0, 1.0), (12.0, 2.5), (20.0, 4.0)] {
                let (w, h) = (wide / 2.0, web / 2.0);
                let top = thick + 12.0;
                let t = vec![
                    [-w, 0.],
                    [w, 0.],
                    [w, thick],
                    [h, thick],
                    [0.6 * h, top],
                    [-0.6 * h, top],
                    [-h, thick],
                    [-w, thick],
                ];
                let s = shape(t);
                assert!(s.likeness < 0.11, "web {web}, platform {wide} by {thick}: {s:?}");
            }
        }
    }

    #[test]
    fn moments_of_a_rectangle() {
        let s = shape(vec![[1.0, 2.0], [5.0, 2.0], [5.0, 3.0], [1.0, 3.0]]);
        assert!((s.centroid[0] - 3.0).abs() < 1e-12 && (s.centroid[1] - 2.5).abs() < 1e-12);
        assert!((s.area_mm2 - 4.0).abs() < 1e-12 && (s.bluntness - 1.0).abs() < 1e-12);
        assert_eq!(s.bounds, [1.0, 2.0, 5.0, 3.0]);
    }
}
