//! Triangle meshes.
use std::collections::HashMap;

use super::triangle::area_mm2;
use super::{Aabb, Point, Rigid, Vector};

/// An indexed triangle mesh; triangles are counter-clockwise seen from outside the part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices, mm.
    pub points: Vec<Point>,
    /// Corner indices.
    pub triangles: Vec<[u32; 3]>,
    /// Per triangle: the face (of the B-rep) or the group (of a mesh file) that it belongs to;
    /// empty: all 0.
    pub face_of: Vec<u32>,
    /// Per triangle: (u, v) of its corners on that face; empty where the part is a mesh only.
    pub corner_uv: Vec<[[f64; 2]; 3]>,
}

impl Mesh {
    /// Corners of a triangle.
    pub fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|i| self.points[i as usize])
    }
    /// Face or group of a triangle.
    pub fn face(&self, triangle: usize) -> u32 {
        self.face_of.get(triangle).copied().unwrap_or(0)
    }
    /// Unit normal of a triangle, outward; zero where it is degenerate.
    pub fn normal(&self, triangle: usize) -> Vector {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_else(Vector::zeros)
    }
    /// Winds a triangle the other way round.
    pub fn turn(&mut self, triangle: usize) {
        self.triangles[triangle].swap(1, 2);
        if let Some(uv) = self.corner_uv.get_mut(triangle) {
            uv.swap(1, 2);
        }
    }
    /// Area of a triangle, mm².
    pub fn triangle_area_mm2(&self, triangle: usize) -> f64 {
        area_mm2(&self.corners(triangle))
    }
    /// Bounding box; `None` without points.
    pub fn aabb(&self) -> Option<Aabb> {
        Aabb::around(&self.points)
    }
    /// Total area, mm².
    pub fn area_mm2(&self) -> f64 {
        (0..self.triangles.len()).map(|t| self.triangle_area_mm2(t)).sum()
    }
    /// Signed volume, mm³, by the divergence theorem; positive for a closed mesh with outward
    /// normals.
    pub fn volume_mm3(&self) -> f64 {
        (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t);
                a.coords.dot(&b.coords.cross(&c.coords)) / 6.0
            })
            .sum()
    }
    /// Both without the parameters of their corners: points, triangles and groups of the other come
    /// after the own ones.
    #[must_use]
    pub fn and(self, other: Mesh) -> Self {
        let (first, groups) = (self.points.len() as u32, self.groups());
        let face_of = (0..self.triangles.len()).map(|t| self.face(t));
        let face_of = face_of.chain((0..other.triangles.len()).map(|t| groups + other.face(t))).collect();
        let (mut points, mut triangles) = (self.points, self.triangles);
        points.extend(other.points);
        triangles.extend(other.triangles.into_iter().map(|t| t.map(|k| first + k)));
        Mesh { points, triangles, face_of, corner_uv: Vec::new() }
    }
    /// How many groups there may be: one more than the greatest number of one.
    pub fn groups(&self) -> u32 {
        self.face_of.iter().max().map_or(1, |most| most + 1)
    }
    /// Moves all points.
    #[must_use]
    pub fn moved(mut self, to_from: &Rigid) -> Self {
        for p in &mut self.points {
            *p = to_from * *p;
        }
        self
    }
}

/// What the edges of a mesh say about it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Topology {
    /// Edges with one triangle.
    pub open_edges: usize,
    /// Edges with more than two triangles.
    pub nonmanifold_edges: usize,
    /// Edges whose two triangles wind against one another.
    pub inconsistent_edges: usize,
    /// Middle of the first open edge.
    pub first_open_edge: Option<Point>,
    /// Middle of the first edge with more than two triangles.
    pub first_nonmanifold_edge: Option<Point>,
    /// Pieces that hang together over edges.
    pub components: usize,
}

impl Topology {
    /// Every edge has two triangles that wind alike.
    pub fn closed(&self) -> bool {
        self.open_edges == 0 && self.nonmanifold_edges == 0 && self.inconsistent_edges == 0
    }
}

/// A use of an edge by a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct EdgeUse {
    /// The edge's vertices, the lower first.
    pub edge: [u32; 2],
    /// The triangle runs from the lower to the higher.
    pub rising: bool,
    /// The triangle.
    pub triangle: u32,
}

/// All uses of all edges, sorted, so that those of one edge are neighbours:
/// `chunk_by(|a, b| a.edge == b.edge)`.
pub fn edge_uses(triangles: &[[u32; 3]]) -> Vec<EdgeUse> {
    let mut all = Vec::with_capacity(3 * triangles.len());
    for (t, c) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (c[k], c[(k + 1) % 3]);
            all.push(EdgeUse { edge: [a.min(b), a.max(b)], rising: a < b, triangle: t as u32 });
        }
    }
    all.sort_unstable();
    all
}

/// About so many places, spread evenly over the area of the triangles that count, with their
/// triangles.
pub fn spread(mesh: &Mesh, counts: impl Fn(usize) -> bool, places: usize) -> Vec<(Point, u32)> {
    let triangles: Vec<usize> = (0..mesh.triangles.len()).filter(|t| counts(*t)).collect();
    let total: f64 = triangles.iter().map(|t| mesh.triangle_area_mm2(*t)).sum();
    let step_mm2 = total / places as f64;
    let (mut left, mut out) = (0.5 * step_mm2, Vec::with_capacity(places + 1));
    for t in triangles {
        let [a, b, c] = mesh.corners(t);
        left += mesh.triangle_area_mm2(t);
        let own = (left / step_mm2).floor();
        left -= own * step_mm2;
        for k in 0..own as usize {
            // A sequence of low discrepancy over the triangle.
            let (u, v) = ((k as f64 + 0.5) / own, (0.5 + 0.618_033_988_75 * k as f64).fract());
            let s = u.sqrt();
            out.push((a + (b - a) * (s * (1.0 - v)) + (c - a) * (s * v), t as u32));
        }
    }
    out
}

/// The mesh of some of the triangles, with the faces that they belong to.
pub fn part_of(mesh: &Mesh, triangles: &[u32]) -> Mesh {
    let mut number = vec![u32::MAX; mesh.points.len()];
    let mut out = Mesh::default();
    for &t in triangles {
        let corners = mesh.triangles[t as usize].map(|v| {
            let n = &mut number[v as usize];
            if *n == u32::MAX {
                *n = out.points.len() as u32;
                out.points.push(mesh.points[v as usize]);
            }
            *n
        });
        out.triangles.push(corners);
        out.face_of.push(mesh.face(t as usize));
    }
    out
}

/// Examines all edges, by index: points that merely coincide are different points ([`weld`] first).
pub fn topology(mesh: &Mesh) -> Topology {
    let uses = edge_uses(&mesh.triangles);
    let mut out = Topology::default();
    let mut parent: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
    out.components = parent.len();
    let middle = |e: &EdgeUse| nalgebra::center(&mesh.points[e.edge[0] as usize], &mesh.points[e.edge[1] as usize]);
    for group in uses.chunk_by(|a, b| a.edge == b.edge) {
        match group {
            [one] => {
                out.open_edges += 1;
                out.first_open_edge.get_or_insert(middle(one));
            }
            [a, b] => out.inconsistent_edges += usize::from(a.rising == b.rising),
            [a, ..] => {
                out.nonmanifold_edges += 1;
                out.first_nonmanifold_edge.get_or_insert(middle(a));
            }
            [] => {}
        }
        for pair in group.windows(2) {
            let [a, b] = [pair[0].triangle, pair[1].triangle].map(|t| root(&mut parent, t));
            if a != b {
                parent[a.max(b) as usize] = a.min(b);
                out.components -= 1;
            }
        }
    }
    out
}

/// The representative of `i` in a forest of parents (union by lower number), whose paths it
/// shortens.
pub(crate) fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Makes points within `tolerance_mm` of an earlier point that same point, and drops triangles that
/// lose a corner by it.
///
/// Points are sorted into cells of the tolerance's size: linear in their number however they lie.
#[must_use]
pub fn weld(mesh: &Mesh, tolerance_mm: f64) -> Mesh {
    let parent = near_points(&mesh.points, tolerance_mm);
    let mut number = vec![u32::MAX; mesh.points.len()];
    let mut out = Mesh::default();
    for i in 0..mesh.points.len() {
        let r = parent[i] as usize;
        if number[r] == u32::MAX {
            number[r] = out.points.len() as u32;
            out.points.push(mesh.points[r]);
        }
        number[i] = number[r];
    }
    for (t, c) in mesh.triangles.iter().enumerate() {
        let c = c.map(|i| number[i as usize]);
        if c[0] != c[1] && c[1] != c[2] && c[2] != c[0] {
            out.triangles.push(c);
            out.face_of.extend(mesh.face_of.get(t));
            out.corner_uv.extend(mesh.corner_uv.get(t));
        }
    }
    out
}

/// For each point the first of those that hang together with it by steps of at most the tolerance.
fn near_points(points: &[Point], tolerance_mm: f64) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..points.len() as u32).collect();
    let size = tolerance_mm.max(f64::MIN_POSITIVE);
    // Without tolerance equal coordinates are one cell: `-0.0` and `0.0` too.
    let cell = |p: &Point| -> [i64; 3] {
        if tolerance_mm > 0.0 {
            [p.x, p.y, p.z].map(|x| (x / size).floor() as i64)
        } else {
            [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits() as i64)
        }
    };
    let mut cells: HashMap<[i64; 3], Vec<u32>> = HashMap::with_capacity(points.len());
    for (i, p) in points.iter().enumerate() {
        cells.entry(cell(p)).or_default().push(i as u32);
    }
    let reach = i64::from(tolerance_mm > 0.0);
    for (i, p) in points.iter().enumerate() {
        let c = cell(p);
        for d in offsets(reach) {
            let near = [c[0].saturating_add(d[0]), c[1].saturating_add(d[1]), c[2].saturating_add(d[2])];
            // Only earlier points: each pair once. The first few of a crowded cell hang together
            // with the rest of it.
            let earlier = cells.get(&near).into_iter().flatten().take_while(|j| (**j as usize) < i).take(MOST_IN_CELL);
            for &j in earlier {
                if tolerance_mm <= 0.0 || (points[j as usize] - p).norm() <= tolerance_mm {
                    let [a, b] = [i as u32, j].map(|v| root(&mut parent, v));
                    parent[a.max(b) as usize] = a.min(b);
                }
            }
        }
    }
    (0..points.len() as u32).map(|i| root(&mut parent, i)).collect()
}

/// Points of one cell that a further point is compared with.
const MOST_IN_CELL: usize = 64;

/// A cell and its neighbours up to `reach`.
fn offsets(reach: i64) -> impl Iterator<Item = [i64; 3]> {
    let side = move || -reach..=reach;
    side().flat_map(move |x| side().flat_map(move |y| side().map(move |z| [x, y, z])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron whose triangles share no points.
    fn soup() -> Mesh {
        let p = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point::from);
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
        let points = faces.iter().flatten().map(|i| p[*i]).collect();
        let triangles = (0..4).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        Mesh { points, triangles, face_of: vec![0, 1, 2, 3], ..Mesh::default() }
    }

    #[test]
    fn welded_soup_is_closed() {
        let loose = topology(&soup());
        assert_eq!((loose.open_edges, loose.components), (12, 4));
        let mesh = weld(&soup(), 1e-6);
        assert_eq!((mesh.points.len(), mesh.face_of.len()), (4, 4));
        let t = topology(&mesh);
        assert!(t.closed() && t.components == 1 && t.first_open_edge.is_none());
        assert!((mesh.volume_mm3() - 1.0 / 6.0).abs() < 1e-15);
    }

    #[test]
    fn faults_are_counted() {
        let mut mesh = weld(&soup(), 1e-6);
        mesh.triangles[0].swap(1, 2);
        assert_eq!(topology(&mesh).inconsistent_edges, 3);
        mesh.triangles.push(mesh.triangles[1]);
        assert_eq!(topology(&mesh).nonmanifold_edges, 3);
        mesh.triangles.truncate(3);
        let t = topology(&mesh);
        assert!(t.open_edges == 3 && t.first_open_edge.is_some() && !t.closed());
    }
}
