//! Faces and triangles as their file has them, where sewing and healing changed them.
//!
//! Sewing gives two edges that lie beside one another one course, so a face ends up to the sewing distance before, or beyond, the
//! edge that its file gives it, and slivers and repeated faces go. Welding moves corners of triangles. The tool is to spare what was
//! published, so what was changed stays beside the part ([`Part::with_published`]): distances are to both.
//!
//! In: the faces as read and as sewn; triangles as read and as healed. Out: those that differ by more than [`MOVED_MM`]. Which do
//! is measured on the result, not taken from what sewing says of itself.

use std::collections::BTreeSet;

use super::sew::curve::{foot, hull};
use super::sew::faces::write_out_natural_loops;
use crate::error::{ErrorKind, Result, Stage};
use crate::geometry::boundary::centroid;
use crate::geometry::brep::{Brep, Coedge, Edge, Face};
use crate::geometry::mesh::Mesh;
use crate::geometry::part::Part;
use crate::geometry::{Aabb, Point, Rigid};
use crate::observe::Observer;

/// What moved by less than this counts as not moved, mm: half of what a tessellation takes for one edge.
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
                (out.moved_mm, out.moved_at) = (moved_mm, point.map(|p| (face.name.clone(), p)));
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

    /// What was changed, in a sentence.
    pub fn note(&self) -> String {
        let dropped = self.of.iter().filter(|of| of.is_none()).count();
        let dropped = if dropped > 0 { format!(", {dropped} of them dropped") } else { String::new() };
        let at = self.moved_at.as_ref().map_or_else(String::new, |(face, p)| {
            format!(", the most {:.4} mm at {face} near ({:.3}, {:.3}, {:.3})", self.moved_mm, p.x, p.y, p.z)
        });
        format!(
            "sewing changed {} faces{dropped}{at}: the tool spares them as the file has them too",
            self.brep.faces.len()
        )
    }

    /// The faces with what exact distances need, in another frame; the names of faces of which none can be made.
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
                    without.push(face.name.clone());
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
                Ok(Prepared { part: None, of, without: self.brep.faces.iter().map(|f| f.name.clone()).collect() })
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

/// How far the edges of a face lie from the edges of the same face after sewing, at the farthest place that was looked at.
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
            // An edge that lies near none of the others has been left out with its loop; by how much does not matter.
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

/// Triangles that healing changed, as the file has them: those with a corner that is no corner any more, where it lies more than
/// [`MOVED_MM`] off the healed mesh. Triangles that lost only their like lie on it.
pub fn triangles(read: &Mesh, healed: &Mesh) -> Option<Mesh> {
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
