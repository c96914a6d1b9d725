//! A finer mesh of exact faces for bounds alone: its triangles cover the faces within a small
//! distance, but do not fit together.
//!
//! In: the tessellation's triangles in the parameter plane. Each is halved, at the side whose
//! middle is farthest from the surface, until it is near enough; corners are points of the surface.
//! For a surface that is quadratic over a triangle the distance is at most 4/3 of the greatest at
//! the middles of its sides, since it is `Σ 4 λᵢ λⱼ dᵢⱼ`. A quarter more is left for what is not
//! quadratic: measured, as the tessellation's own deflection is. The sides of loops are straight in
//! the parameter plane; between them and the edges' own curves strips are laid. Triangles at a pole
//! are laid as two, up to the pole's whole side.

use super::Exact;
use super::measure::{OnFace, free_direction, strips};
use crate::geometry::brep::Brep;
use crate::geometry::mesh::Mesh;
use crate::geometry::tessellate::NO_CHORD;
use crate::geometry::{Point, Vector};
use crate::parallel;

/// What the distance at the middles of the sides is multiplied by.
const MARGIN: f64 = 4.0 / 3.0 * 1.25;
/// No triangle is halved more often.
const DEEPEST: u32 = 24;
/// Strips narrower than this share of the distance are left out: what they cover is within it
/// anyway.
const NARROW: f64 = 0.1;

/// Of every so many triangles of the tessellation one is looked at to find out how many there will
/// be, where that makes a sample of at least so many; and so often at most.
const SAMPLED: usize = 16;
const FEWEST_SAMPLED: usize = 500;
const ESTIMATES: usize = 8;

/// Triangles that cover a part.
#[derive(Clone, Debug, Default)]
pub struct Fine {
    /// Their corners, mm.
    pub corners: Vec<[Point; 3]>,
    /// Triangle of the part's mesh that each belongs to; `u32::MAX`: not known.
    pub parents: Vec<u32>,
    /// No point of the part is farther from them than this, mm.
    pub deflection_mm: f64,
}

/// Triangle of the parameter plane with its corners on the surface.
type Flat = ([[f64; 2]; 3], [Point; 3]);

impl OnFace<'_> {
    /// Triangles within `limit_mm` of what lies over one in the parameter plane; how far they may
    /// be off.
    fn halved(&self, uv: [[f64; 2]; 3], limit_mm: f64, out: &mut Vec<[Point; 3]>) -> f64 {
        let mut most = 0.0f64;
        let first: Flat = (uv, uv.map(|x| self.at(x)));
        let mut open = vec![(first, 0)];
        while let Some(((uv, p), depth)) = open.pop() {
            let middle = |k: usize| between(uv[k], uv[(k + 1) % 3]);
            let points = [0, 1, 2].map(|k| self.at(middle(k)));
            let off = [0, 1, 2].map(|k| (points[k] - nalgebra::center(&p[k], &p[(k + 1) % 3])).norm());
            let worst = (1..3).fold(0, |a, k| if off[k] > off[a] { k } else { a });
            let bound = MARGIN * off[worst];
            if bound <= limit_mm || depth >= DEEPEST {
                most = most.max(bound);
                out.push(p);
                continue;
            }
            let [a, b, c] = [worst, (worst + 1) % 3, (worst + 2) % 3];
            let (m, q) = (middle(worst), points[worst]);
            open.push((([m, uv[b], uv[c]], [q, p[b], p[c]]), depth + 1));
            open.push((([uv[a], m, uv[c]], [p[a], q, p[c]]), depth + 1));
        }
        most
    }
}

fn between(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|k| 0.5 * (a[k] + b[k]))
}

impl Exact {
    /// Triangles within `limit_mm` of the faces, as far as `most` of them do; `mesh` is the faces'
    /// tessellation.
    pub fn fine(&self, brep: &Brep, mesh: &Mesh, limit_mm: f64, most: usize) -> Fine {
        let mut limit_mm = self.coarse_enough(brep, mesh, limit_mm, most);
        loop {
            let fine = self.fine_within(brep, mesh, limit_mm);
            if fine.corners.len() <= most.max(2 * mesh.triangles.len()) || !(limit_mm < 1.0) {
                return fine;
            }
            limit_mm *= (fine.corners.len() as f64 / most as f64).max(1.3);
        }
    }

    /// A distance, at least the given one, within which about so many triangles do: by a sample of
    /// those of the tessellation, since making too many first costs more than all that are wanted.
    fn coarse_enough(&self, brep: &Brep, mesh: &Mesh, limit_mm: f64, most: usize) -> f64 {
        let sample: Vec<usize> = (0..mesh.triangles.len()).step_by(SAMPLED).collect();
        if sample.len() < FEWEST_SAMPLED {
            return limit_mm;
        }
        let mut limit_mm = limit_mm;
        for _ in 0..ESTIMATES {
            let counts = parallel::map(&sample, |t| self.covering(brep, mesh, *t, limit_mm).0.len());
            let count = (counts.iter().sum::<usize>() * mesh.triangles.len()) as f64 / sample.len() as f64;
            if count <= most as f64 || !(limit_mm < 1.0) {
                break;
            }
            limit_mm *= (count / most as f64).max(1.02);
        }
        limit_mm
    }

    /// Triangles within `limit_mm` of what a triangle of the tessellation stands for; how far they
    /// may be off.
    fn covering(&self, brep: &Brep, mesh: &Mesh, t: usize, limit_mm: f64) -> (Vec<[Point; 3]>, f64) {
        let mut out = Vec::new();
        let Some(uv) = mesh.corner_uv.get(t) else { return (out, f64::INFINITY) };
        let face = self.loops.face(brep, mesh.face(t) as usize);
        let pole = |x: [f64; 2]| {
            let n = face.space.normal_form(x);
            let d = face.surface.derivatives(n[0], n[1]);
            super::is_pole(&d, face.space).then(|| free_direction(&d, face.space))
        };
        let off = strips(*uv, pole).into_iter().map(|uv| face.halved(uv, limit_mm, &mut out));
        let off = off.fold(0.0, f64::max);
        (out, off)
    }

    fn fine_within(&self, brep: &Brep, mesh: &Mesh, limit_mm: f64) -> Fine {
        let all: Vec<(Vec<[Point; 3]>, f64)> =
            parallel::map(0..mesh.triangles.len(), |t| self.covering(brep, mesh, t, limit_mm));
        let mut fine = Fine { deflection_mm: limit_mm * NARROW, ..Fine::default() };
        for (t, (corners, off)) in all.into_iter().enumerate() {
            fine.parents.extend(std::iter::repeat_n(t as u32, corners.len()));
            fine.corners.extend(corners);
            fine.deflection_mm = fine.deflection_mm.max(off);
        }
        for face in 0..brep.faces.len() {
            self.lay_strips(brep, face, limit_mm, &mut fine);
        }
        fine
    }

    /// Between the sides of a face's loops and its edges.
    fn lay_strips(&self, brep: &Brep, face: usize, limit_mm: f64, fine: &mut Fine) {
        let on = self.loops.face(brep, face);
        for ring in &self.loops.regions[face].trim.rings {
            for (k, node) in ring.nodes.iter().enumerate().filter(|(_, n)| n.chord != NO_CHORD && !n.seam) {
                let Some(chord) = self.loops.chords.get(node.chord as usize) else { continue };
                let curve = &brep.edges[chord.edge as usize].curve;
                let next = ring.nodes[(k + 1) % ring.nodes.len()].uv;
                let t = if node.against { [chord.t[1], chord.t[0]] } else { chord.t };
                let end = |uv: [f64; 2], t: f64| (uv, on.at(uv), t, curve.point(t));
                let mut open = vec![([end(node.uv, t[0]), end(next, t[1])], 0)];
                while let Some(([a, b], depth)) = open.pop() {
                    let m = end(between(a.0, b.0), 0.5 * (a.2 + b.2));
                    let sag = |x: &Point, from: &Point, to: &Point| (x - nalgebra::center(from, to)).norm();
                    let bound = 1.25 * sag(&m.1, &a.1, &b.1).max(sag(&m.3, &a.3, &b.3));
                    let width = [&a, &m, &b].map(|e| (e.1 - e.3).norm()).into_iter().fold(0.0, f64::max);
                    if width <= NARROW * limit_mm {
                        continue;
                    }
                    if bound <= limit_mm || depth >= DEEPEST {
                        fine.corners.extend([[a.1, b.1, b.3], [a.1, b.3, a.3]]);
                        fine.parents.extend([u32::MAX; 2]);
                        fine.deflection_mm = fine.deflection_mm.max(bound);
                    } else {
                        open.extend([([m, b], depth + 1), ([a, m], depth + 1)]);
                    }
                }
            }
        }
    }
}

impl Fine {
    /// How far a point is from the nearest triangle, mm, by looking at all of them.
    #[cfg(test)]
    fn distance(&self, q: &Point) -> f64 {
        let to = |c: &[Point; 3]| (crate::geometry::triangle::closest_on_triangle(c, q) - q).norm();
        self.corners.iter().map(to).fold(f64::INFINITY, f64::min)
    }

    /// Gives every triangle without a parent one, and puts those of one parent next to one another.
    pub(in crate::geometry) fn finish(&mut self, parent: impl Fn(&Point) -> u32) {
        for (p, [a, b, c]) in self.parents.iter_mut().zip(&self.corners).filter(|(p, _)| **p == u32::MAX) {
            let sum: Vector = a.coords + b.coords + c.coords;
            *p = parent(&Point::from(sum / 3.0));
        }
        let mut order: Vec<u32> = (0..self.parents.len() as u32).collect();
        order.sort_by_key(|&k| self.parents[k as usize]);
        self.corners = order.iter().map(|&k| self.corners[k as usize]).collect();
        self.parents = order.iter().map(|&k| self.parents[k as usize]).collect();
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::geometry::Point;
    use crate::geometry::exact::tests::can;
    use crate::geometry::part::Part;
    use crate::observe::Silent;

    /// A can: its wall is curved, its caps are bounded by circles, which chords cut. A dense grid
    /// of its points is covered.
    #[test]
    fn covers_walls_and_edges() {
        let part = Part::from_brep(can(5.0, 3.0), 0.05, &Silent).unwrap();
        let coarse = part.fine(1.0, 1_000_000).unwrap();
        for limit in [0.02, 0.004] {
            let fine = part.fine(limit, 1_000_000).unwrap();
            assert!(fine.deflection_mm <= limit && fine.corners.len() > coarse.corners.len());
            assert!(fine.parents.windows(2).all(|w| w[0] <= w[1]) && fine.parents.len() == fine.corners.len());
            let mut most = 0.0f64;
            for k in 0..300 {
                let (s, c) = (std::f64::consts::TAU * f64::from(k) / 300.0).sin_cos();
                for (r, z) in [(5.0, 0.0), (5.0, 1.3), (5.0, 3.0), (4.999, 3.0), (2.0, 0.0)] {
                    most = most.max(fine.distance(&Point::new(r * c, r * s, z)));
                }
            }
            assert!(most <= fine.deflection_mm * (1.0 + 1e-9), "{most} {}", fine.deflection_mm);
            assert!(most > 0.05 * fine.deflection_mm);
        }
        // Too many are not made.
        let few = part.fine(1e-6, 3000).unwrap();
        assert!(few.corners.len() <= 3000 && few.deflection_mm > 1e-6);
    }

    /// A sample of the tessellation says how fine the triangles can be: nearly as many are made as
    /// may be.
    #[test]
    fn a_sample_tells_how_many_there_will_be() {
        let part = Part::from_brep(can(5.0, 3.0), 1e-5, &Silent).unwrap();
        assert!(part.mesh.triangles.len() > super::SAMPLED * super::FEWEST_SAMPLED);
        let most = 3 * part.mesh.triangles.len();
        let fine = part.fine(1e-9, most).unwrap();
        assert!(fine.corners.len() <= most && fine.corners.len() > most / 3, "{} {most}", fine.corners.len());
    }
}
