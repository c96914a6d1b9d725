//! The two ends of a section, and its thickness.

use super::outline::{area, distance};

/// The two ends of a section, in no order that means anything.
#[derive(Clone, Debug)]
pub struct SectionEnds {
    /// Arc length from the section's first point, mm.
    pub s_mm: [f64; 2],
    /// (y, z), mm.
    pub at_mm: [[f64; 2]; 2],
    /// Radius, mm.
    pub radius_mm: [f64; 2],
    /// What the side from the first end to the second and the one back bulge out over the chord,
    /// mm².
    pub bulge_mm2: [f64; 2],
}

impl SectionEnds {
    /// From the second end to the first.
    pub fn chord(&self) -> [f64; 2] {
        let [a, b] = self.at_mm;
        [a[0] - b[0], a[1] - b[1]]
    }

    /// Distance between the ends, mm.
    pub fn chord_mm(&self) -> f64 {
        distance(self.at_mm[0], self.at_mm[1])
    }

    /// How round the section is: its area over that of the circle on its chord.
    pub fn roundness(&self) -> f64 {
        let circle_mm2 = 0.25 * std::f64::consts::PI * self.chord_mm().powi(2);
        self.bulge_mm2.iter().sum::<f64>() / circle_mm2.max(f64::MIN_POSITIVE)
    }

    /// The same with the ends exchanged.
    pub fn exchanged(&self) -> SectionEnds {
        let turn = |[a, b]: [f64; 2]| [b, a];
        let [a, b] = self.at_mm;
        let (s_mm, radius_mm, bulge_mm2) = (turn(self.s_mm), turn(self.radius_mm), turn(self.bulge_mm2));
        SectionEnds { s_mm, at_mm: [b, a], radius_mm, bulge_mm2 }
    }
}

/// An end of the section.
#[derive(Clone, Copy, Debug)]
struct Edge {
    s_mm: f64,
    point: [f64; 2],
    radius_mm: f64,
    index: usize,
}

/// Finds the ends of a closed counter-clockwise polygon: about each end of its greatest extent, the
/// middle of the stretch that bends at least half as sharply as its sharpest point.
pub fn find(points: &[[f64; 2]], s: &[f64], length: f64, curvature: &[f64]) -> SectionEnds {
    let (a, b) = farthest(points);
    let ring = LoopCurvature { points, s, length, curvature };
    let (a, b) = (ring.edge_near(a), ring.edge_near(b));
    SectionEnds {
        s_mm: [a.s_mm, b.s_mm],
        at_mm: [a.point, b.point],
        radius_mm: [a.radius_mm, b.radius_mm],
        bulge_mm2: [bulge_mm2(points, a.index, b.index), bulge_mm2(points, b.index, a.index)],
    }
}

/// The two points that are farthest apart.
fn farthest(points: &[[f64; 2]]) -> (usize, usize) {
    // Only corners of the convex hull can be: far fewer than points.
    let hull = convex_hull(points);
    let mut best = (0, 0, -1.0);
    for (k, &i) in hull.iter().enumerate() {
        for &j in &hull[k + 1..] {
            let d = distance(points[i], points[j]);
            if d > best.2 {
                best = (i, j, d);
            }
        }
    }
    (best.0, best.1)
}

/// Indices of the convex hull's corners (Andrew's monotone chain).
fn convex_hull(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a][0].total_cmp(&points[b][0]).then(points[a][1].total_cmp(&points[b][1])));
    let cross = |o: usize, a: usize, b: usize| {
        let (o, a, b) = (points[o], points[a], points[b]);
        (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
    };
    let half = |walk: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for i in walk {
            while let [.., a, b] = chain[..] {
                if cross(a, b, i) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(i);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut order.iter().copied());
    hull.extend(half(&mut order.iter().rev().copied()));
    hull
}

/// What the side from `from` to `to` bulges out over its chord, mm².
fn bulge_mm2(points: &[[f64; 2]], from: usize, to: usize) -> f64 {
    let n = points.len();
    let count = (to + n - from) % n + 1;
    let side: Vec<[f64; 2]> = (0..count).map(|k| points[(from + k) % n]).collect();
    area(&side)
}

struct LoopCurvature<'a> {
    points: &'a [[f64; 2]],
    s: &'a [f64],
    length: f64,
    curvature: &'a [f64],
}

impl LoopCurvature<'_> {
    /// Arc length from point `i` to point `j`, the shorter way, signed.
    fn length_between(&self, i: usize, j: usize) -> f64 {
        let d = self.s[j] - self.s[i];
        d - self.length * (d / self.length).round()
    }

    fn edge_near(&self, near: usize) -> Edge {
        let n = self.points.len();
        let within = |j: usize, reach: f64| self.length_between(near, j).abs() <= reach * self.length;
        let mut peak = near;
        for j in (0..n).filter(|&j| within(j, 0.1)) {
            if self.curvature[j] > self.curvature[peak] {
                peak = j;
            }
        }
        // The stretch about the peak, its turning and first moment of turning.
        let half = 0.5 * self.curvature[peak];
        let sharp = |j: usize| self.curvature[j] >= half && self.length_between(peak, j).abs() <= 0.2 * self.length;
        let (mut first, mut last) = (peak, peak);
        while sharp((first + n - 1) % n) && (first + n - 1) % n != peak {
            first = (first + n - 1) % n;
        }
        while sharp((last + 1) % n) && (last + 1) % n != first {
            last = (last + 1) % n;
        }
        let (mut span, mut turning, mut moment) = (0.0, 0.0, 0.0);
        let mut j = first;
        loop {
            let own = 0.5 * (self.gap(j) + self.gap((j + n - 1) % n));
            span += own;
            turning += own * self.curvature[j];
            moment += own * self.curvature[j] * self.length_between(peak, j);
            if j == last {
                break;
            }
            j = (j + 1) % n;
        }
        let offset = if turning > 0.0 { moment / turning } else { 0.0 };
        self.edge_at((self.s[peak] + offset).rem_euclid(self.length), span / turning.max(1e-12))
    }

    fn edge_at(&self, s_mm: f64, radius_mm: f64) -> Edge {
        let n = self.points.len();
        let i = self.s.partition_point(|&s| s <= s_mm).saturating_sub(1);
        let gap = self.gap(i).max(1e-300);
        let f = ((s_mm - self.s[i]) / gap).clamp(0.0, 1.0);
        let (p, q) = (self.points[i], self.points[(i + 1) % n]);
        let point = [p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])];
        Edge { s_mm, point, radius_mm, index: if f < 0.5 { i } else { (i + 1) % n } }
    }

    fn gap(&self, j: usize) -> f64 {
        let next = if j + 1 == self.s.len() { self.length } else { self.s[j + 1] };
        next - self.s[j]
    }
}

/// Diameter of the largest circle inside that touches the polygon at one of up to 400 of its
/// points: for each, a circle that touches there shrinks until no other point lies inside it.
/// Points within the tolerance of the wall's tangent are its neighbours and noise.
pub fn thickness(points: &[[f64; 2]], outward: &[[f64; 2]], tolerance: f64) -> f64 {
    let step = points.len().div_ceil(400).max(1);
    let extent = 2.0 * points.iter().map(|p| distance(*p, points[0])).fold(0.0, f64::max);
    let mut greatest = 0.0f64;
    for i in (0..points.len()).step_by(step) {
        let (p, n) = (points[i], outward[i]);
        let mut radius = extent;
        for q in points {
            let v = [q[0] - p[0], q[1] - p[1]];
            let (far, inward) = (v[0] * v[0] + v[1] * v[1], -(v[0] * n[0] + v[1] * n[1]));
            // The circle through p and q that is tangent to the wall at p.
            if inward > 2.0 * tolerance && far > 0.0 {
                radius = radius.min(0.5 * far / inward);
            }
        }
        greatest = greatest.max(2.0 * radius);
    }
    greatest
}
