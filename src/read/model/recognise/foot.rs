//! What the airfoil's wall meets the platform in: a fillet or an edge.
//!
//! From places round sections of the airfoil the surface is followed down, triangle by triangle, in
//! the plane of the blade axis and of the wall's normal there, until the way has bent outwards by
//! [`BENT_DEG`]. Where one edge of the mesh has most of that turning the two meet in an edge; where
//! it is shared out they meet in a fillet, however coarse the facets. The places vote, two thirds
//! decide. Nothing is asked of the platform's shape, so a hub along which the foot climbs is judged
//! like a flat one. Works in the blade frame.
//!
//! Limits: a fillet of one or two facets cannot be told from a chamfer, and nothing is said of it;
//! one smaller than [`TINY`] is an edge.

use crate::geometry::mesh::{Mesh, edge_uses};
use crate::geometry::slice::Loop;
use crate::geometry::{Point, Vector};

/// Ways down, evenly round the section.
const WAYS: u32 = 256;
/// A way that has turned outwards by this has left the wall.
const BENT_DEG: f64 = 45.0;
/// What is within this share of the section's length to either side of that place belongs to the
/// turn.
const NEAR: f64 = 0.05;
/// Edges of the mesh nearer to one another than this share of the section's length are one.
const TINY: f64 = 1e-3;
/// Greatest share of the turning that one edge of the mesh has in a fillet …
const ROUND: f64 = 0.45;
/// … and the least where wall and platform meet in an edge.
const SHARP: f64 = 0.7;
/// A fillet begins and ends where this share of the turning is done and left.
const ENDS: f64 = 0.15;
/// A wall leans by less than this (sine), else the section has cut a platform or a hub.
const WALL: f64 = 0.5;
/// This share of the ways must find a turn for a verdict.
const HEARD: f64 = 0.125;
/// No way crosses more triangles.
const LONGEST: usize = 20_000;
const NONE: u32 = u32::MAX;

/// What wall and platform meet in.
pub enum Joint {
    /// A fillet.
    Fillet(Foot),
    /// An edge.
    Edge,
    /// Too few ways found a turn, or they do not agree.
    Unsure,
}

/// The fillet as the ways found it.
pub struct Foot {
    /// Upper and lower end on each way, blade frame, mm.
    pub ends: Vec<[Point; 2]>,
    /// Median radius across the wall, mm.
    pub radius_mm: f64,
}

impl Foot {
    /// The height below which this share of the upper (0) or lower (1) ends lies, mm.
    pub fn height_mm(&self, end: usize, share: f64) -> f64 {
        let mut x: Vec<f64> = self.ends.iter().map(|e| e[end].x).collect();
        x.sort_by(f64::total_cmp);
        let last = x.len().saturating_sub(1);
        x.get((share * last as f64).round() as usize).copied().unwrap_or(0.0)
    }

    /// Whether the foot keeps its height to within that of the fillet itself.
    pub fn level(&self) -> bool {
        self.height_mm(1, 0.95) - self.height_mm(1, 0.05) < self.height_mm(0, 0.5) - self.height_mm(1, 0.5)
    }
}

/// Where a way bends outwards.
struct OutwardBend {
    ends: [Point; 2],
    radius_mm: f64,
    /// Share of the turning that one edge of the mesh has.
    share: f64,
}

/// Judges the turn below sections of the airfoil, each with its height, mm. `platform_mm`: height
/// of the platform, or its lowest where the foot climbs.
pub fn joint(mesh: &Mesh, sections: &[(f64, Loop)], platform_mm: f64) -> Joint {
    let across = Across::new(mesh);
    let mut asked = 0;
    let mut bends = Vec::new();
    for (x_mm, section) in sections {
        let length_mm = section.length_mm();
        let lowest_mm = platform_mm - NEAR * length_mm;
        for (p, t) in places(section, *x_mm) {
            let n = mesh.normal(t as usize);
            let wall = Vector::new(0.0, n.y, n.z).try_normalize(0.5).filter(|_| n.x.abs() < WALL);
            let Some(out) = wall else { continue };
            asked += 1;
            let way = across.way(mesh, t, &p, &out, [lowest_mm, p.x + NEAR * length_mm]);
            bends.extend(bend(&way, &out, length_mm).filter(|b| b.ends[0].x > lowest_mm));
        }
    }
    let round: Vec<&OutwardBend> = bends.iter().filter(|b| b.share < ROUND).collect();
    if bends.is_empty() || (bends.len() as f64) < HEARD * f64::from(asked) {
        return Joint::Unsure;
    }
    if 3 * round.len() >= 2 * bends.len() {
        let mut radii: Vec<f64> = round.iter().map(|b| b.radius_mm).collect();
        radii.sort_by(f64::total_cmp);
        return Joint::Fillet(Foot { ends: round.iter().map(|b| b.ends).collect(), radius_mm: radii[radii.len() / 2] });
    }
    let sharp = bends.iter().filter(|b| b.share > SHARP).count();
    if 3 * sharp >= 2 * bends.len() { Joint::Edge } else { Joint::Unsure }
}

/// Places evenly round a section, with the triangle under each.
fn places(section: &Loop, x_mm: f64) -> Vec<(Point, u32)> {
    let n = section.points.len();
    let ends = |k: usize| (section.points[k], section.points[(k + 1) % n]);
    let pitch = section.length_mm() / f64::from(WAYS);
    let (mut out, mut next, mut done) = (Vec::new(), 0.5 * pitch, 0.0);
    for (k, t) in section.triangles.iter().enumerate() {
        let (a, b) = ends(k);
        let d = (b[0] - a[0]).hypot(b[1] - a[1]);
        while next < done + d && out.len() < WAYS as usize {
            let share = (next - done) / d;
            out.push((Point::new(x_mm, a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share), *t));
            next += pitch;
        }
        done += d;
    }
    out
}

/// The triangle across each side of each triangle.
struct Across(Vec<[u32; 3]>);

impl Across {
    fn new(mesh: &Mesh) -> Self {
        let mut out = vec![[NONE; 3]; mesh.triangles.len()];
        for pair in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge) {
            let [a, b] = pair else { continue };
            for (of, other) in [(a, b), (b, a)] {
                let corners = mesh.triangles[of.triangle as usize];
                let side = (0..3).find(|&k| of.edge.contains(&corners[k]) && of.edge.contains(&corners[(k + 1) % 3]));
                if let Some(side) = side {
                    out[of.triangle as usize][side] = other.triangle;
                }
            }
        }
        Across(out)
    }

    /// The way down from a point of a triangle, in the plane of the axis and of `out`, until it
    /// leaves these heights or comes to an edge of the surface.
    fn way(&self, mesh: &Mesh, from: u32, p: &Point, out: &Vector, [low, high]: [f64; 2]) -> Vec<Point> {
        let side_of = Vector::x().cross(out);
        let height = |v: u32| (mesh.points[v as usize] - p).dot(&side_of);
        // A corner in the plane counts as above it, so a triangle has two cut sides or none.
        let cut = |t: u32, k: usize| {
            let c = mesh.triangles[t as usize];
            let (a, b) = (c[k].min(c[(k + 1) % 3]), c[k].max(c[(k + 1) % 3]));
            let (ha, hb) = (height(a), height(b));
            ((ha >= 0.0) != (hb >= 0.0)).then(|| {
                let [pa, pb] = [a, b].map(|v| mesh.points[v as usize]);
                pa + (pb - pa) * (ha / (ha - hb))
            })
        };
        let mut way = vec![*p];
        let first = (0..3).filter_map(|k| Some((k, cut(from, k)?))).min_by(|a, b| a.1.x.total_cmp(&b.1.x));
        let Some((mut side, mut at)) = first else { return way };
        let mut t = from;
        while way.len() < LONGEST {
            way.push(at);
            let next = self.0[t as usize][side];
            if next == NONE || at.x < low || at.x > high {
                break;
            }
            let entered = (0..3).find(|&k| self.0[next as usize][k] == t);
            let leave = (0..3).filter(|k| Some(*k) != entered).find_map(|k| Some((k, cut(next, k)?)));
            let Some(leave) = leave else { break };
            t = next;
            (side, at) = leave;
        }
        way
    }
}

/// The first turn outwards of a way.
fn bend(way: &[Point], out: &Vector, length_mm: f64) -> Option<OutwardBend> {
    // Direction of each step, 0 down the axis, growing outwards, and the place and way done at its
    // end.
    let (mut angle, mut ends, mut done): (Vec<f64>, Vec<Point>, Vec<f64>) = Default::default();
    let mut sum = 0.0;
    for w in way.windows(2) {
        let d = w[1] - w[0];
        if !(d.norm() > 1e-9 * length_mm) {
            continue;
        }
        let here = d.dot(out).atan2(-d.x);
        let turned = angle.last().map_or(here, |a| {
            let full = std::f64::consts::TAU;
            a + (here - a) - ((here - a) / full).round() * full
        });
        sum += d.norm();
        angle.push(turned);
        ends.push(w[1]);
        done.push(sum);
    }
    let near = NEAR * length_mm;
    let least = |k: usize| {
        let before = (0..=k).rev().take_while(|&j| j == k || done[j] > done[k] - near);
        before.map(|j| angle[j]).fold(f64::INFINITY, f64::min)
    };
    let k = (0..angle.len().checked_sub(1)?).find(|&k| angle[k + 1] - least(k) >= BENT_DEG.to_radians())?;
    let after = |j: &usize| done[*j - 1] < done[k] + near;
    let low = least(k);
    let high = (k + 1..angle.len()).take_while(after).map(|j| angle[j]).fold(f64::NEG_INFINITY, f64::max);
    let turn = high - low;
    let begin = (0..=k).rev().find(|&j| angle[j] <= low + ENDS * turn)?;
    let end = (k..angle.len() - 1).find(|&j| angle[j + 1] >= high - ENDS * turn)?;
    let at = |j: usize| angle[j + 1] - angle[j];
    // Turning within a tiny way is that of one edge.
    let together = |j: usize| (j..=end).take_while(|&i| done[i] <= done[j] + TINY * length_mm).map(at).sum::<f64>();
    let most = (begin..=end).map(together).fold(0.0, f64::max);
    let turned = angle[end + 1] - angle[begin] - 0.5 * (at(begin) + at(end));
    let radius_mm = if turned > 0.0 { (done[end] - done[begin]) / turned } else { 0.0 };
    Some(OutwardBend { ends: [ends[begin], ends[end]], radius_mm, share: most / turn })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Rigid;
    use crate::geometry::bvh::MeshBvh;
    use crate::geometry::slice::slice;

    const PLACES: usize = 72;

    /// The outline of an airfoil 20 mm long and 3 mm thick, moved outwards.
    fn outline(off_mm: f64) -> impl Fn(usize) -> [f64; 2] {
        move |k| {
            let (s, c) = (std::f64::consts::TAU * k as f64 / PLACES as f64).sin_cos();
            let n = Vector::new(0.0, 1.5 * c, 10.0 * s).normalize();
            [10.0 * c + n.y * off_mm, 1.5 * s + n.z * off_mm]
        }
    }

    /// A blade on a platform with a fillet of this radius in so many facets, or with an edge (no
    /// facets): rows of (outwards, height), mm.
    fn rows(radius_mm: f64, facets: usize) -> Vec<(f64, f64)> {
        let fillet = (1..facets).map(|k| {
            let (s, c) = (std::f64::consts::FRAC_PI_2 * k as f64 / facets as f64).sin_cos();
            (radius_mm * (1.0 - s), radius_mm * (1.0 - c))
        });
        let foot = if facets == 0 { vec![(0.0, 0.0)] } else { vec![(radius_mm, 0.0), (0.0, radius_mm)] };
        let wall = (0..=12).map(|k| (0.0, 3.0 + 2.5 * f64::from(k)));
        let mut out: Vec<(f64, f64)> = [(9.0, -12.0), (9.0, 0.0), (4.0, 0.0)].into_iter().chain(foot).collect();
        let at = out.len().min(4);
        out.splice(at..at, fillet);
        out.extend(wall);
        out
    }

    /// The closed part of these rows; the platform climbs by `slope` along the chord, the tip stays
    /// level.
    fn part(rows: &[(f64, f64)], slope: f64) -> Mesh {
        let mut mesh = Mesh::default();
        for (off, x) in rows {
            let climbs = |y: f64| slope * y * (1.0 - x.max(0.0) / 33.0);
            mesh.points.extend((0..PLACES).map(outline(*off)).map(|[y, z]| Point::new(x + climbs(y), y, z)));
        }
        let n = PLACES as u32;
        let (bottom, last) = (mesh.points.len() as u32, (rows.len() as u32 - 1) * n);
        mesh.points.extend([Point::new(rows[0].1, 0.0, 0.0), Point::new(33.0, 0.0, 0.0)]);
        for k in 0..n {
            let next = (k + 1) % n;
            for r in (0..last).step_by(PLACES) {
                mesh.triangles.extend([[r + k, r + next, r + next + n], [r + k, r + next + n, r + k + n]]);
            }
            mesh.triangles.extend([[next, k, bottom], [last + k, last + next, bottom + 1]]);
        }
        mesh
    }

    fn judged(mesh: &Mesh, slope: f64) -> Joint {
        assert!(mesh.volume_mm3() > 0.0);
        let bvh = MeshBvh::new(mesh);
        joint(mesh, &[10.0, 20.0].map(|x| (x, slice(mesh, &bvh, x).remove(0))), -10.0 * slope)
    }

    #[test]
    fn a_coarse_fillet_is_told_from_an_edge() {
        for (slope, turn) in [(0.0, 0.0), (0.35, 0.0), (0.0, 1.1), (0.35, 2.3)] {
            let about = Rigid::rotation(Vector::x() * turn);
            for (radius, facets) in [(0.5, 3), (0.5, 4), (1.5, 5), (1.5, 16)] {
                let Joint::Fillet(foot) = judged(&part(&rows(radius, facets), slope).moved(&about), slope) else {
                    panic!("no fillet: radius {radius}, {facets} facets, slope {slope}, turned by {turn}")
                };
                assert!((foot.radius_mm / radius - 1.0).abs() < 0.25, "{} for {radius}", foot.radius_mm);
                assert_eq!(foot.level(), slope == 0.0);
            }
            let corner = |foot: &[(f64, f64)]| judged(&part(foot, slope).moved(&about), slope);
            assert!(matches!(corner(&rows(0.0, 0)), Joint::Edge), "slope {slope}");
            assert!(matches!(corner(&rows(0.7, 1)), Joint::Unsure), "slope {slope}");
        }
    }

    #[test]
    fn a_blade_without_platform_has_no_foot() {
        let bare: Vec<(f64, f64)> = rows(0.5, 4).into_iter().filter(|r| r.0 == 0.0).collect();
        assert!(matches!(judged(&part(&bare, 0.0), 0.0), Joint::Unsure));
    }
}
