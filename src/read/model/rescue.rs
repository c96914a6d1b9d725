//! Faces that cannot be meshed as the file trims them.
//!
//! In: exact faces as read. Out: the part, what sewing joined, and what was done to get there.
//! Faces are sewn and meshed; where that fails, it is tried with less: a smaller sewing distance
//! first (it may have joined the two sides of a sharp edge), then finer chords too (boundaries
//! nearer to one another than the deflection cross where chords are coarse). Else each face is
//! tried alone; one that fails is taken with its natural boundary where its edges run along that
//! (its trimming then says nothing more), and is left out otherwise. A part with a face left out is
//! open there and is refused for planning.

use super::published::Published;
use super::sew;
use crate::error::{Error, Result, Stage};
use crate::geometry::Point;
use crate::geometry::brep::{Brep, Face};
use crate::geometry::part::Part;
use crate::observe::{Observer, Remark};

/// Edges this share of the face's size from the natural boundary still run along it.
const ALONG: f64 = 2e-3;
/// Samples on each edge and on each side of the boundary.
const SAMPLES: usize = 64;

/// What became of faces that cannot be meshed.
#[derive(Default)]
pub struct Rescued {
    /// What was done.
    pub notes: Vec<Remark>,
    /// Why no plan may be made: a face was left out.
    pub obstacle: Option<Error>,
    /// What sewing joined.
    pub sewn: sew::Sewn,
    /// Faces that are not as the file has them.
    pub published: Option<Published>,
    /// The deflection that was asked of the mesh in the end, mm.
    pub deflection_mm: f64,
}

/// Shares of the sewing distance and of the deflection that are tried in turn.
const TRIES: [[f64; 2]; 6] = [[1.0, 1.0], [0.1, 1.0], [0.01, 1.0], [1.0, 0.1], [0.1, 0.1], [0.01, 0.01]];

/// Makes the part, without the faces that cannot be meshed if there is no other way.
///
/// # Errors
/// Where no face can be meshed: as for the first of them. `Cancelled`.
pub fn part(original: Brep, deflection_mm: f64, sew_mm: &[f64], observer: &dyn Observer) -> Result<(Part, Rescued)> {
    let mut first = None;
    for [share, finer] in TRIES {
        let within_mm: Vec<f64> = sew_mm.iter().map(|s| share * s).collect();
        let finer = finer * deflection_mm;
        observer.check(Stage::Model)?;
        let mut brep = original.clone();
        let sewn = sew::sew(&mut brep, &within_mm);
        let e = match Part::meshed(brep, finer, observer) {
            Ok(part) => {
                let note = |e: Error| {
                    let edges_mm = within_mm.last().copied().unwrap_or(0.0);
                    Remark::MadeCloser { edges_mm, faces_mm: finer, reason: e.message }
                };
                let notes = first.map(note).into_iter().collect();
                let published = changed(&original, &part);
                return Ok((part, Rescued { notes, sewn, published, deflection_mm: finer, ..Rescued::default() }));
            }
            Err(e) => e,
        };
        first.get_or_insert(e);
    }
    let first = first.unwrap_or_else(|| Error::io(Stage::Model, "there is no face to mesh"));
    let mut brep = original.clone();
    let sewn = sew::sew(&mut brep, sew_mm);
    let mut out = Rescued { sewn, deflection_mm, ..Rescued::default() };
    let mut keep = Vec::with_capacity(brep.faces.len());
    for k in 0..brep.faces.len() {
        observer.check(Stage::Model)?;
        let Err(e) = Part::meshed(alone(&brep, brep.faces[k].clone()), deflection_mm, observer) else {
            keep.push(true);
            continue;
        };
        let natural = Face { loops: Vec::new(), ..brep.faces[k].clone() };
        let follows = along_boundary(&brep, &brep.faces[k]);
        if follows && Part::meshed(alone(&brep, natural.clone()), deflection_mm, observer).is_ok() {
            out.notes.push(Remark::Untrimmed { face: natural.name.to_string(), reason: e.message });
            brep.faces[k] = natural;
            keep.push(true);
        } else {
            out.notes.push(Remark::FaceLeftOut { reason: e.message.clone() });
            out.obstacle.get_or_insert(e);
            keep.push(false);
        }
    }
    let mut k = keep.iter();
    brep.faces.retain(|_| *k.next().unwrap_or(&true));
    if brep.faces.is_empty() {
        return Err(first);
    }
    sew::sew(&mut brep, sew_mm);
    // Each face can be meshed alone; if not all together, the first error is still the one to
    // report.
    let part = Part::meshed(brep, deflection_mm, observer).map_err(|_| first)?;
    out.published = changed(&original, &part);
    Ok((part, out))
}

/// Faces that are not as the file has them.
fn changed(original: &Brep, part: &Part) -> Option<Published> {
    Published::find(original, part.brep.as_ref()?)
}

/// A B-rep of one face; edges keep their numbers.
fn alone(brep: &Brep, face: Face) -> Brep {
    Brep { faces: vec![face], edges: brep.edges.clone() }
}

/// Whether all edges of the face lie on the boundary of its surface's parameter rectangle, and
/// cover it.
fn along_boundary(brep: &Brep, face: &Face) -> bool {
    let [[u0, u1], [v0, v1]] = face.surface.domain();
    let at = |k: usize| k as f64 / SAMPLES as f64;
    let mut boundary: Vec<Point> = Vec::with_capacity(4 * SAMPLES + 4);
    for k in 0..=SAMPLES {
        let (u, v) = (u0 + at(k) * (u1 - u0), v0 + at(k) * (v1 - v0));
        boundary.extend([(u, v0), (u, v1), (u0, v), (u1, v)].map(|(u, v)| face.surface.point(u, v)));
    }
    let mut edges: Vec<Point> = Vec::new();
    for e in face.loops.iter().flatten().filter_map(|c| brep.edges.get(c.edge)) {
        edges.extend((0..=SAMPLES).map(|k| e.curve.point(e.t[0] + at(k) * (e.t[1] - e.t[0]))));
    }
    let Some(b) = crate::geometry::Aabb::around(&boundary) else { return false };
    // Samples of either are apart by a share of the boundary's length; between them it is taken as
    // straight.
    let tolerance = ALONG * b.diagonal_mm() + 2.0 * b.diagonal_mm() / SAMPLES as f64;
    let near = |p: &Point, set: &[Point]| set.iter().any(|q| (p - q).norm() < tolerance);
    !edges.is_empty() && edges.iter().all(|p| near(p, &boundary)) && boundary.iter().all(|p| near(p, &edges))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::mesh::topology;
    use crate::observe::Silent;
    use crate::read::model::SEW_MM;

    /// The prism: faces 5 to 8 are its fillet, 9 is its tip.
    fn prism() -> Brep {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/prism.step");
        crate::read::model::step::read(&path, &std::fs::read(&path).unwrap(), None).unwrap().brep
    }

    fn rescued(brep: Brep) -> (Part, Rescued) {
        part(brep, 0.05, &SEW_MM, &Silent).unwrap()
    }

    #[test]
    fn a_whole_part_is_left_as_it_is() {
        let (part, done) = rescued(prism());
        assert!(done.notes.is_empty() && done.obstacle.is_none() && done.deflection_mm == 0.05, "{:?}", done.notes);
        assert_eq!(topology(&part.mesh).open_edges, 0);
    }

    /// An edge from the other end of the part in a loop: nothing shows where the face ends.
    #[test]
    fn a_face_that_cannot_be_trimmed_is_left_out_and_hinders_a_plan() {
        let mut brep = prism();
        let far = brep.faces[16].loops[0][0];
        brep.faces[8].loops[0].push(far);
        let (part, done) = rescued(brep);
        assert!(done.notes.iter().any(|n| matches!(n, Remark::FaceLeftOut { .. })), "{:?}", done.notes);
        assert!(done.obstacle.is_some() && topology(&part.mesh).open_edges > 0);
    }

    #[test]
    fn a_part_without_a_face_that_can_be_meshed_is_an_error() {
        let mut brep = prism();
        let far = brep.faces[16].loops[0][0];
        brep.faces = vec![brep.faces[8].clone()];
        brep.faces[0].loops[0].push(far);
        assert!(part(brep, 0.05, &SEW_MM, &Silent).is_err());
    }
}
