//! Triangles of a mesh file wound alike: neighbours agree, and every piece has its normals outward.
//!
//! Across edges with two triangles the sense is carried on. A closed piece encloses a positive
//! volume when its normals point outward; an open one is judged as if its openings were closed by
//! cones to their common middle, and left as the file has it where that encloses next to nothing (a
//! sheet). A piece that the file winds inward and that lies wholly inside another closed piece is a
//! cavity and stays inward.

use crate::geometry::mesh::{Mesh, edge_uses};
use crate::geometry::part::Part;
use crate::geometry::{Aabb, Point};
use crate::observe::Remark;

/// An open piece with less volume than this share of its area times its size is a sheet.
const SHEET: f64 = 1e-3;
/// Vertices of a piece that are tested for lying inside another.
const SAMPLES: usize = 16;
/// With more pieces than this, none is taken for a cavity: such a file is a heap of fragments.
const MOST_PIECES: usize = 64;

/// Triangles that hang together over edges with two triangles.
struct ConnectedTriangles {
    triangles: Vec<usize>,
    /// Triangles turned so that all agree with the first.
    turned: usize,
    closed: bool,
    /// Sense in which the file winds most of it, before anything was turned: signed volume, mm³.
    given_mm3: f64,
}

/// Winds the mesh; says what was changed.
pub fn orient(mesh: &mut Mesh) -> Vec<Remark> {
    let pieces = pieces(mesh);
    let inward: Vec<bool> = pieces.iter().map(|p| p.given_mm3 < 0.0 && p.closed).collect();
    let mut notes = Vec::new();
    let (mut turned, mut whole) = (0, 0);
    for p in &pieces {
        if signed_volume(mesh, p) < 0.0 {
            p.triangles.iter().for_each(|&t| mesh.turn(t));
            if p.turned == 0 {
                whole += p.triangles.len();
            } else {
                turned += p.triangles.len() - p.turned;
            }
        } else {
            turned += p.turned;
        }
    }
    let cavities = cavities(mesh, &pieces, &inward);
    for &i in &cavities {
        pieces[i].triangles.iter().for_each(|&t| mesh.turn(t));
        whole -= if pieces[i].turned == 0 { pieces[i].triangles.len() } else { 0 };
    }
    if turned > 0 {
        notes.push(Remark::TrianglesTurned { triangles: turned });
    }
    if whole == mesh.triangles.len() {
        notes.push(Remark::AllTrianglesTurned);
    } else if whole > 0 {
        notes.push(Remark::PiecesTurned { triangles: whole });
    }
    if !cavities.is_empty() {
        notes.push(Remark::Cavities { pieces: cavities.len() });
    }
    notes
}

/// Winds all triangles of each piece like its first one.
fn pieces(mesh: &mut Mesh) -> Vec<ConnectedTriangles> {
    let n = mesh.triangles.len();
    let mut neighbours: Vec<Vec<(u32, bool)>> = vec![Vec::new(); n];
    let mut full = vec![0u8; n];
    for pair in edge_uses(&mesh.triangles).chunk_by(|a, b| a.edge == b.edge).filter(|g| g.len() == 2) {
        let against = pair[0].rising == pair[1].rising;
        for (own, other) in [(pair[0].triangle, pair[1].triangle), (pair[1].triangle, pair[0].triangle)] {
            neighbours[own as usize].push((other, against));
            full[own as usize] += 1;
        }
    }
    let mut turn: Vec<Option<bool>> = vec![None; n];
    let mut out = Vec::new();
    for seed in 0..n {
        if turn[seed].is_some() {
            continue;
        }
        turn[seed] = Some(false);
        let mut piece = vec![seed];
        let mut at = 0;
        while at < piece.len() {
            let t = piece[at];
            at += 1;
            for &(next, against) in &neighbours[t] {
                if turn[next as usize].is_none() {
                    turn[next as usize] = turn[t].map(|x| x ^ against);
                    piece.push(next as usize);
                }
            }
        }
        // The sense of most stays: less is changed, and a sheet keeps what the file meant.
        let other = piece.iter().filter(|t| turn[**t] == Some(true)).count();
        let most = 2 * other > piece.len();
        let mut p = ConnectedTriangles {
            closed: piece.iter().all(|t| full[*t] == 3),
            triangles: piece,
            turned: 0,
            given_mm3: 0.0,
        };
        p.given_mm3 = signed_volume(mesh, &p);
        for &t in &p.triangles {
            if turn[t] == Some(!most) {
                mesh.turn(t);
                p.turned += 1;
            }
        }
        out.push(p);
    }
    out
}

/// Volume of a piece, mm³; of an open one with its openings closed by cones to their middle, 0 for
/// a sheet.
fn signed_volume(mesh: &Mesh, piece: &ConnectedTriangles) -> f64 {
    let corners = |t: usize| mesh.corners(t);
    let apex = if piece.closed { corners(piece.triangles[0])[0] } else { middle_of_openings(mesh, piece) };
    let (mut volume, mut area) = (0.0, 0.0);
    let mut b = Aabb { min: apex, max: apex };
    for &t in &piece.triangles {
        let p = corners(t);
        let [u, v, w] = p.map(|q| q - apex);
        volume += u.dot(&v.cross(&w)) / 6.0;
        area += mesh.triangle_area_mm2(t);
        for q in p {
            (b.min, b.max) = (b.min.inf(&q), b.max.sup(&q));
        }
    }
    if !piece.closed && volume.abs() < SHEET * area * b.diagonal_mm() { 0.0 } else { volume }
}

/// Mean of the middles of the piece's open edges.
fn middle_of_openings(mesh: &Mesh, piece: &ConnectedTriangles) -> Point {
    let triangles: Vec<[u32; 3]> = piece.triangles.iter().map(|&t| mesh.triangles[t]).collect();
    let points: Vec<Point> = edge_uses(&triangles)
        .chunk_by(|a, b| a.edge == b.edge)
        .filter(|g| g.len() != 2)
        .map(|g| g[0].edge.map(|v| mesh.points[v as usize]))
        .map(|[a, b]| nalgebra::center(&a, &b))
        .collect();
    crate::geometry::boundary::centroid(&points)
}

/// Pieces wound inward in the file that lie inside another closed piece.
fn cavities(mesh: &Mesh, pieces: &[ConnectedTriangles], inward: &[bool]) -> Vec<usize> {
    if !(2..=MOST_PIECES).contains(&pieces.len()) {
        return Vec::new();
    }
    let alone = |p: &ConnectedTriangles| {
        let triangles: Vec<[u32; 3]> = p.triangles.iter().map(|&t| mesh.triangles[t]).collect();
        let mut number = std::collections::BTreeMap::new();
        let mut m = Mesh::default();
        for c in &triangles {
            m.triangles.push(c.map(|v| {
                *number.entry(v).or_insert_with(|| {
                    m.points.push(mesh.points[v as usize]);
                    m.points.len() as u32 - 1
                })
            }));
        }
        m
    };
    let mut out = Vec::new();
    for i in (0..pieces.len()).filter(|&i| inward[i]) {
        let inner = alone(&pieces[i]);
        let every = inner.points.len().div_ceil(SAMPLES).max(1);
        let within = |outer: &ConnectedTriangles| {
            let part = Part::from_mesh(alone(outer));
            inner.points.iter().step_by(every).all(|p| part.inside(p))
        };
        let covers = |o: &ConnectedTriangles| {
            let outer = alone(o).aabb();
            outer.zip(inner.aabb()).is_some_and(|(o, i)| (0..3).all(|k| o.min[k] < i.min[k] && o.max[k] > i.max[k]))
        };
        if pieces.iter().enumerate().any(|(j, o)| j != i && o.closed && covers(o) && within(o)) {
            out.push(i);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// A cube from `lo` to `hi`, outward, appended.
    fn add_cube(mesh: &mut Mesh, lo: f64, hi: f64) {
        let base = mesh.points.len() as u32;
        let at = |bit: u32| if bit == 0 { lo } else { hi };
        mesh.points.extend((0..8u32).map(|i| Point::new(at(i & 1), at(i >> 1 & 1), at(i >> 2))));
        for q in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            let q: [u32; 4] = q;
            mesh.triangles.extend([[q[0], q[1], q[2]], [q[0], q[2], q[3]]].map(|t| t.map(|v| v + base)));
        }
    }

    #[test]
    fn a_cavity_stays_and_a_body_beside_is_turned() {
        let mut mesh = Mesh::default();
        add_cube(&mut mesh, 0.0, 10.0);
        add_cube(&mut mesh, 4.0, 6.0);
        add_cube(&mut mesh, 20.0, 22.0);
        mesh.triangles[12..].iter_mut().for_each(|t| t.swap(0, 1));
        let notes = orient(&mut mesh);
        assert!((mesh.volume_mm3() - (1000.0 - 8.0 + 8.0)).abs() < 1e-9, "{}", mesh.volume_mm3());
        assert!(
            notes.contains(&Remark::Cavities { pieces: 1 })
                && notes.iter().any(|n| n.to_string().contains("12 triangles")),
            "{notes:?}"
        );
    }

    #[test]
    fn open_pieces_are_judged_with_their_openings_closed() {
        let mut mesh = Mesh::default();
        add_cube(&mut mesh, 100.0, 110.0);
        // One side missing, all inward: far from the origin the plain sum would say anything.
        mesh.triangles.truncate(10);
        mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        assert_eq!(orient(&mut mesh), [Remark::AllTrianglesTurned]);
        let n = mesh.normal(0);
        assert!(n.z < -0.99, "{n}");
        // A flat sheet keeps its sense.
        let mut sheet = Mesh { triangles: mesh.triangles[..2].to_vec(), points: mesh.points, ..Mesh::default() };
        sheet.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        assert!(orient(&mut sheet).is_empty());
    }

    #[test]
    fn any_mixture_of_senses_comes_out_right() {
        for mask in [0b1u32, 0b1010_1010_1010, 0b1111_1111_1110, 0b0110_0110_0011] {
            let mut mesh = Mesh::default();
            add_cube(&mut mesh, -1.0, 2.0);
            for (t, c) in mesh.triangles.iter_mut().enumerate() {
                if mask >> t & 1 == 1 {
                    c.swap(0, 2);
                }
            }
            assert!(!orient(&mut mesh).is_empty());
            assert!((mesh.volume_mm3() - 27.0).abs() < 1e-9, "{mask:b}");
            assert!(orient(&mut mesh).is_empty());
        }
    }
}
