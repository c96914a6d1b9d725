//! Faces and triangles as their file has them, where sewing and healing changed them.
//!
//! Sewing gives two edges that lie beside one another one course, so a face ends up to the sewing
//! distance before, or beyond, the edge that its file gives it, and slivers and repeated faces go.
//! Welding moves corners of triangles. The tool is to spare what was published, so what was changed
//! stays beside the part ([`Part::with_published`]): distances are to both.
//!
//! In: the faces as read and as sewn; triangles as read and as healed. Out: those that differ by
//! more than [`MOVED_MM`]. Which do is measured on the result, not taken from what sewing says of
//! itself.

use std::collections::BTreeSet;

use super::sew::curve::{foot, hull};
use super::sew::faces::write_out_natural_loops;
use crate::error::{ErrorKind, Result, Stage};
use crate::geometry::boundary::centroid;
use crate::geometry::brep::{Brep, Coedge, Edge, Face};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Aabb, Point, Rigid};
use crate::observe::{FarthestMove, Observer, Remark};

/// What moved by less than this counts as not moved, mm: half of what a tessellation takes for one
/// edge.
pub const MOVED_MM: f64 = 5e-4;
/// Places at which an edge is compared.
const PLACES: usize = 9;
/// Edges farther from one another than this are not compared, mm: far more than sewing ever moves.
const NEAR_MM: f64 = 1.0;

/// The faces of a file that sewing changed, as the file has them.
#[derive(Clone, Debug, Default)]
pub struct Published {
    /// The faces, with edges of their own.
    pub brep: Brep,
    /// Number of each among the sewn faces; `None` where it was dropped.
    pub of: Vec<Option<u32>>,
    /// Greatest distance found between an edge of the file and those that took its place, mm.
    pub moved_mm: f64,
    /// Where that is: the face, and the point.
    pub moved_at: Option<(String, Point)>,
}

impl Published {
    /// Compares faces as read with the same faces as sewn; `None` where nothing differs.
    pub fn find(original: &Brep, sewn: &Brep) -> Option<Self> {
        let mut original = original.clone();
        write_out_natural_loops(&mut original);
        let boxes: Vec<Aabb> = sewn.edges.iter().map(hull).collect();
        let mut out = Published::default();
        let mut changed = Vec::new();
        let mut next = 0;
        for face in &original.faces {
            // Sewing keeps the order of faces, and leaves some out.
            let same = |f: &Face| f.name == face.name && f.surface == face.surface;
            let found = sewn.faces[next..].iter().position(same).map(|k| next + k);
            next = found.map_or(next, |j| j + 1);
            let Some(j) = found else {
                changed.push((face, None));
                continue;
            };
            let (moved_mm, point) = moved(&original, face, sewn, &sewn.faces[j], &boxes);
            if moved_mm > out.moved_mm {
                (out.moved_mm, out.moved_at) = (moved_mm, point.map(|p| (face.name.to_string(), p)));
            }
            if moved_mm > MOVED_MM {
                changed.push((face, Some(j as u32)));
            }
        }
        if changed.is_empty() {
            return None;
        }
        for (face, of) in changed {
            out.add(&original, face, of);
        }
        Some(out)
    }

    /// Adds a face with its edges; faces share none, so that each keeps its own.
    fn add(&mut self, from: &Brep, face: &Face, of: Option<u32>) {
        let mut face = face.clone();
        let mut number = std::collections::BTreeMap::new();
        for c in face.loops.iter_mut().flatten() {
            let Coedge { edge, .. } = *c;
            c.edge = *number.entry(edge).or_insert_with(|| {
                self.brep.edges.push(from.edges[edge].clone());
                self.brep.edges.len() - 1
            });
        }
        self.brep.faces.push(face);
        self.of.push(of);
    }

    /// Turns the faces as those of the part are turned.
    pub fn orient(&mut self, sewn: &Brep) {
        for (face, of) in self.brep.faces.iter_mut().zip(&self.of) {
            if let Some(same) = of.and_then(|j| sewn.faces.get(j as usize)) {
                face.reversed = same.reversed;
            }
        }
    }

    /// What was changed.
    pub fn note(&self) -> Remark {
        let farthest = self.moved_at.as_ref();
        Remark::FacesChanged {
            count: self.brep.faces.len(),
            dropped: self.of.iter().filter(|of| of.is_none()).count(),
            farthest: farthest.map(|(face, p)| FarthestMove {
                mm: self.moved_mm,
                face: face.clone(),
                at_mm: (*p).into(),
            }),
        }
    }

    /// The faces with what exact distances need, in another frame; the names of faces of which none
    /// can be made.
    ///
    /// # Errors
    /// `Cancelled`.
    pub fn part(&self, to_from: &Rigid, deflection_mm: f64, observer: &dyn Observer) -> Result<Prepared> {
        let mut whole = self.brep.clone().moved(to_from);
        let mut of = self.of.clone();
        let mut without = Vec::new();
        if Part::meshed(whole.clone(), deflection_mm, observer).is_err() {
            let mut keep = Vec::with_capacity(of.len());
            for face in &whole.faces {
                observer.check(Stage::Model)?;
                let alone = Brep { faces: vec![face.clone()], edges: whole.edges.clone() };
                let good = Part::meshed(alone, deflection_mm, observer).is_ok();
                if !good {
                    without.push(face.name.to_string());
                }
                keep.push(good);
            }
            let mut k = keep.iter();
            whole.faces.retain(|_| *k.next().unwrap_or(&true));
            let mut k = keep.iter();
            of.retain(|_| *k.next().unwrap_or(&true));
        }
        if whole.faces.is_empty() {
            return Ok(Prepared { part: None, of, without });
        }
        match Part::from_brep(whole, deflection_mm, observer) {
            Ok(part) => Ok(Prepared { part: Some(part), of, without }),
            Err(e) if e.kind == ErrorKind::Cancelled => Err(e),
            Err(_) => {
                Ok(Prepared { part: None, of, without: self.brep.faces.iter().map(|f| f.name.to_string()).collect() })
            }
        }
    }
}

/// Published faces ready for distances.
pub struct Prepared {
    /// The faces; `None` where no face is left.
    pub part: Option<Part>,
    /// Number of each among the sewn faces.
    pub of: Vec<Option<u32>>,
    /// Names of faces whose trimming cannot be followed as the file has it.
    pub without: Vec<String>,
}

/// How far the edges of a face lie from the edges of the same face after sewing, at the farthest
/// place that was looked at.
fn moved(original: &Brep, face: &Face, sewn: &Brep, same: &Face, boxes: &[Aabb]) -> (f64, Option<Point>) {
    let now: Vec<usize> = same.loops.iter().flatten().map(|c| c.edge).collect();
    let mut worst = (0.0, None);
    for edge in face.loops.iter().flatten().map(|c| &original.edges[c.edge]) {
        if now.iter().any(|n| holds(&sewn.edges[*n], edge)) {
            continue;
        }
        for k in 0..PLACES {
            let p = edge.at(k as f64 / (PLACES - 1) as f64);
            let near = now.iter().filter(|n| distance_to(&boxes[**n], &p) <= NEAR_MM);
            let off = near.map(|n| foot(&sewn.edges[*n].curve, sewn.edges[*n].t, &p).1).fold(f64::INFINITY, f64::min);
            // An edge that lies near none of the others has been left out with its loop; by how
            // much does not matter.
            let off = if off.is_finite() { off } else { NEAR_MM };
            if off > worst.0 {
                worst = (off, Some(p));
            }
        }
    }
    worst
}

/// Whether an edge is the other one, bit by bit.
fn holds(now: &Edge, before: &Edge) -> bool {
    now.t == before.t && now.curve == before.curve
}

fn distance_to(b: &Aabb, p: &Point) -> f64 {
    (0..3).map(|k| (b.min[k] - p[k]).max(p[k] - b.max[k]).max(0.0).powi(2)).sum::<f64>().sqrt()
}

/// Triangles that healing changed, as the file has them: those with a corner that is no corner any
/// more, where it lies more than [`MOVED_MM`] off the healed mesh. Triangles that lost only their
/// like lie on it.
pub fn triangles(read: &Mesh, healed: &Mesh) -> Option<Mesh> {
    if read.points == healed.points {
        return None;
    }
    let bits = |p: &Point| [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
    let kept: BTreeSet<[u64; 3]> = healed.points.iter().map(bits).collect();
    let gone: Vec<bool> = read.points.iter().map(|p| !kept.contains(&bits(p))).collect();
    if !gone.contains(&true) {
        return None;
    }
    let part = Part::from_mesh(healed.clone());
    let off: Vec<bool> =
        read.points.iter().zip(&gone).map(|(p, gone)| *gone && part.closest(p, MOVED_MM).is_none()).collect();
    let mut out = Mesh::default();
    for (t, corners) in read.triangles.iter().enumerate() {
        if corners.iter().any(|c| off[*c as usize]) {
            let first = out.points.len() as u32;
            let points = corners.map(|c| read.points[c as usize]);
            out.points.extend(points);
            out.triangles.push([first, first + 1, first + 2]);
            out.face_of.push(read.face(t));
            let now = part.closest(&centroid(&points), f64::INFINITY);
            if now.is_some_and(|c| c.normal.dot(&read.normal(t)) < 0.0) {
                out.turn(out.triangles.len() - 1);
            }
        }
    }
    (!out.triangles.is_empty()).then_some(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use nalgebra::Vector4;

    use super::*;
    use crate::geometry::brep::SurfaceKind;
    use crate::geometry::mesh::topology;
    use crate::geometry::nurbs::NurbsSurface;
    use crate::observe::Silent;
    use crate::read::model::{SEW_MM, rescue};

    /// Half sides of a block.
    const HALF: [f64; 3] = [20.0, 5.0, 30.0];

    /// A rectangle as a face without loops, from a corner along two sides.
    fn rectangle(name: &str, corner: [f64; 3], u: [f64; 3], v: [f64; 3], reversed: bool) -> Face {
        let at = |s: f64, t: f64| {
            let p = [0, 1, 2].map(|k| corner[k] + s * u[k] + t * v[k]);
            Vector4::new(p[0], p[1], p[2], 1.0)
        };
        let surface = NurbsSurface::bilinear([at(0.0, 0.0), at(0.0, 1.0), at(1.0, 0.0), at(1.0, 1.0)]);
        Face { name: name.into(), kind: SurfaceKind::Plane, surface, reversed, loops: Vec::new() }
    }

    /// The block as six loose faces; the last one, y = 5, passes the edge x = 20 by `beyond`.
    fn loose(beyond: f64) -> Brep {
        let [a, b, c] = HALF;
        let (x, y, z) = ([2.0 * a, 0.0, 0.0], [0.0, 2.0 * b, 0.0], [0.0, 0.0, 2.0 * c]);
        let faces = vec![
            rectangle("x+", [a, -b, -c], y, z, false),
            rectangle("x-", [-a, -b, -c], y, z, true),
            rectangle("z+", [-a, -b, c], x, y, false),
            rectangle("z-", [-a, -b, -c], x, y, true),
            rectangle("y-", [-a, -b, -c], x, z, false),
            rectangle("y+", [-a, b, -c], [2.0 * a + beyond, 0.0, 0.0], z, true),
        ];
        Brep { faces, edges: Vec::new() }
    }

    #[test]
    fn faces_that_fit_are_as_published() {
        let (part, done) = rescue::part(loose(0.0), 0.05, &SEW_MM, &Silent).unwrap();
        assert!(topology(&part.mesh).closed() && done.published.is_none());
    }

    /// Sewing cuts the strip away that passes the edge; the tool spares it.
    #[test]
    fn a_strip_that_sewing_cuts_away_still_belongs_to_the_part() {
        const BEYOND: f64 = 0.015;
        let (part, done) = rescue::part(loose(BEYOND), 0.05, &SEW_MM, &Silent).unwrap();
        assert!(topology(&part.mesh).closed());
        let published = done.published.unwrap();
        assert_eq!(published.of, [Some(5)]);
        assert!((published.moved_mm - BEYOND).abs() < 1e-6, "{}", published.moved_mm);
        assert_eq!(published.moved_at.as_ref().unwrap().0, "y+");
        let sewn = Part::from_brep(part.brep.unwrap(), 0.05, &Silent).unwrap();
        let Prepared { part: strip, of, without } = published.part(&Rigid::identity(), 0.05, &Silent).unwrap();
        assert!(without.is_empty());
        let whole = sewn.clone().with_published(strip.unwrap(), of);
        // What stands off the sewn part counts in the bounds that are taken from its mesh.
        assert!((whole.deflection_mm - sewn.deflection_mm - BEYOND).abs() < 1e-6);
        // Beside the strip the sewn part is farther, and only there.
        let q = Point::new(23.0, 5.0, 1.0);
        assert!((sewn.closest(&q, 10.0).unwrap().distance_mm - 3.0).abs() < 1e-9);
        let near = whole.closest(&q, 10.0).unwrap();
        assert!((near.distance_mm - (3.0 - BEYOND)).abs() < 1e-9 && near.face == 5);
        assert!(whole.nearest_is_published(&q) && whole.closest(&q, 3.0 - 2.0 * BEYOND).is_none());
        for q in [Point::new(3.0, 8.0, 1.0), Point::new(23.0, 1.0, 1.0), Point::new(-23.0, 5.0, 1.0)] {
            assert!(!whole.nearest_is_published(&q));
            assert_eq!(whole.closest(&q, 10.0).unwrap().distance_mm, sewn.closest(&q, 10.0).unwrap().distance_mm);
        }
    }

    /// A wedge 0.01 mm thick is dropped as a sliver, but the tool spares it.
    #[test]
    fn a_face_that_was_dropped_still_belongs_to_the_part() {
        let mut faces = loose(0.0);
        faces.faces.push(rectangle("rib", [-20.0, 5.0, 3.0], [40.0, 0.0, 0.0], [0.0, 0.01, 0.0], false));
        let (part, done) = rescue::part(faces, 0.05, &SEW_MM, &Silent).unwrap();
        assert!(topology(&part.mesh).closed(), "{:?}", done.sewn);
        let published = done.published.unwrap();
        assert_eq!(published.of, [None]);
        let Prepared { part: rib, of, .. } = published.part(&Rigid::identity(), 0.05, &Silent).unwrap();
        let whole = Part::from_brep(part.brep.unwrap(), 0.05, &Silent).unwrap().with_published(rib.unwrap(), of);
        let near = whole.closest(&Point::new(0.0, 8.0, 3.0), 10.0).unwrap();
        assert!((near.distance_mm - 2.99).abs() < 1e-9 && near.face == 5);
    }

    #[test]
    fn triangles_whose_corners_moved_are_kept() {
        let p = |x: f64, y: f64, z: f64| Point::new(x, y, z);
        let read = Mesh {
            points: vec![p(0., 0., 0.), p(9., 0., 0.), p(0., 9., 0.), p(9., 0., 0.02), p(9., 9., 0.), p(0., 9., 0.)],
            triangles: vec![[0, 1, 2], [3, 4, 5]],
            ..Mesh::default()
        };
        let healed = Mesh {
            points: vec![p(0., 0., 0.), p(9., 0., 0.), p(0., 9., 0.), p(9., 9., 0.)],
            triangles: vec![[0, 1, 2], [1, 3, 2]],
            ..Mesh::default()
        };
        let kept = triangles(&read, &healed).unwrap();
        assert_eq!(kept.points, [p(9., 0., 0.02), p(9., 9., 0.), p(0., 9., 0.)]);
        assert!(triangles(&healed, &healed).is_none());
        let whole = Part::from_mesh(healed).with_published(Part::from_mesh(kept), vec![Some(0)]);
        assert!((whole.closest(&p(9.0, 0.0, 3.0), 5.0).unwrap().distance_mm - 2.98).abs() < 1e-12);
        assert!((whole.deflection_mm - 0.02).abs() < 1e-12);
    }
}
