//! The bodies of a part: what hangs together over edges and is closed, with its cavities; what is
//! open is one body together, since sheets may face each other.
//!
//! They are numbered from 1 in the order of the file's triangles or faces, so that `inspect`,
//! `--body` and a job mean the same. Crumbs, of a small share of the part's surface, have no
//! number.

use crate::geometry::Aabb;
use crate::geometry::mesh::{Mesh, edge_uses, part_of, root};

/// A piece with less of the whole surface than this share is a crumb.
const CRUMB: f64 = 0.002;

/// A body of a part.
pub struct Body {
    /// Its triangles, rising.
    pub triangles: Vec<u32>,
    /// Its surface by itself.
    pub mesh: Mesh,
    /// Box around it, model frame, mm.
    pub aabb: Aabb,
    /// Volume, mm³; of a body with openings what its triangles come to.
    pub volume_mm3: f64,
    /// Surface, mm².
    pub area_mm2: f64,
}

impl Body {
    /// Volume and box in words.
    pub fn in_words(&self) -> String {
        let (size, at) = (self.aabb.max - self.aabb.min, nalgebra::center(&self.aabb.min, &self.aabb.max));
        format!(
            "{:.1} mm³, {:.1} × {:.1} × {:.1} mm about ({:.1}, {:.1}, {:.1})",
            self.volume_mm3, size.x, size.y, size.z, at.x, at.y, at.z
        )
    }
}

/// The first of some bodies in words, with their numbers.
pub fn list(bodies: &[Body]) -> String {
    let told: Vec<String> =
        bodies.iter().take(LISTED).enumerate().map(|(k, b)| format!("{} ({})", k + 1, b.in_words())).collect();
    let more = if bodies.len() > LISTED { format!(" and {} more", bodies.len() - LISTED) } else { String::new() };
    told.join(", ") + &more
}

/// Bodies that are listed.
pub const LISTED: usize = 12;

/// The bodies of a mesh.
pub fn bodies(mesh: &Mesh) -> Vec<Body> {
    let mut parent: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
    let mut at_openings = Vec::new();
    for group in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge) {
        if let [one] = group {
            at_openings.push(one.triangle);
        }
        for pair in group.windows(2) {
            let [a, b] = [pair[0].triangle, pair[1].triangle].map(|t| root(&mut parent, t));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    for pair in at_openings.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|t| root(&mut parent, t));
        parent[a.max(b) as usize] = a.min(b);
    }
    // The representative is the lowest triangle, so pieces come in the order of the file.
    let mut pieces: std::collections::BTreeMap<u32, Vec<u32>> = Default::default();
    for t in 0..mesh.triangles.len() as u32 {
        pieces.entry(root(&mut parent, t)).or_default().push(t);
    }
    let least = CRUMB * mesh.area_mm2();
    let all = pieces.into_values().filter_map(|triangles| body(mesh, triangles)).filter(|b| b.area_mm2 >= least);
    let (mut solid, hollow): (Vec<Body>, Vec<Body>) = all.partition(|b| b.volume_mm3 >= 0.0);
    for cavity in hollow {
        let around = |b: &&mut Body| b.aabb.min <= cavity.aabb.min && b.aabb.max >= cavity.aabb.max;
        let smallest = solid.iter_mut().filter(around).min_by(|a, b| a.volume_mm3.total_cmp(&b.volume_mm3));
        match smallest {
            Some(b) => {
                let mut triangles = [std::mem::take(&mut b.triangles), cavity.triangles].concat();
                triangles.sort_unstable();
                if let Some(joined) = body(mesh, triangles) {
                    *b = joined;
                }
            }
            // Wound inwards, but in nothing: a sheet.
            None => solid.push(cavity),
        }
    }
    solid.sort_by_key(|b| b.triangles.first().copied());
    solid
}

fn body(mesh: &Mesh, triangles: Vec<u32>) -> Option<Body> {
    let own = part_of(mesh, &triangles);
    let (aabb, volume_mm3, area_mm2) = (own.aabb()?, own.volume_mm3(), own.area_mm2());
    Some(Body { triangles, mesh: own, aabb, volume_mm3, area_mm2 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::read::model::sample;

    fn joined(parts: &[Mesh]) -> Mesh {
        let mut out = Mesh::default();
        for (face, m) in parts.iter().enumerate() {
            let base = out.points.len() as u32;
            out.points.extend(&m.points);
            out.triangles.extend(m.triangles.iter().map(|t| t.map(|v| v + base)));
            out.face_of.extend(vec![face as u32; m.triangles.len()]);
        }
        out
    }

    /// Moved and scaled; a negative scale turns it inside out.
    fn placed(at: [f64; 3], scale: f64) -> Mesh {
        let mut m = sample::blade();
        let middle = m.aabb().map_or_else(Vector::zeros, |b| 0.5 * (b.min.coords + b.max.coords));
        for p in &mut m.points {
            *p = (scale.abs() * (p.coords - middle) + Vector::from(at)).into();
        }
        if scale < 0.0 {
            m.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        m
    }

    #[test]
    fn bodies_keep_the_order_of_the_file_and_their_cavities() {
        let all = joined(&[
            placed([300.0, 0.0, 0.0], 1.0),
            placed([0.0, 0.0, 0.0], -0.2),
            placed([0.0, 0.0, 0.0], 1.0),
            placed([600.0, 0.0, 0.0], 0.01),
        ]);
        let found = bodies(&all);
        assert_eq!(found.len(), 2, "the cavity is no body, the crumb neither");
        let one = placed([0.0; 3], 1.0).volume_mm3();
        assert!((found[0].volume_mm3 - one).abs() < 1e-6 * one && found[0].aabb.min.x > 200.0);
        assert!((found[1].volume_mm3 - one * (1.0 - 0.2f64.powi(3))).abs() < 1e-6 * one);
        assert!(found[1].mesh.face_of.contains(&1) && found[1].mesh.face_of.contains(&2));
        assert_eq!(bodies(&sample::blade()).len(), 1);
    }
}
