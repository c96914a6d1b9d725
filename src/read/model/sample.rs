//! Meshes and files for the tests of this folder.
#![allow(clippy::unwrap_used)]

use std::fmt::Write;

use crate::geometry::mesh::Mesh;
use crate::geometry::{Point, Rigid};

/// A small generator of the xorshift family (Marsaglia, *Xorshift RNGs*, 2003): the same files on
/// every run.
pub struct Random(pub u64);

impl Random {
    /// The next number below `n`; 0 for `n` of 0.
    pub fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n.max(1) as u64) as usize
    }
}

/// Points around one section.
const AROUND: usize = 96;

/// A blade along +z: root block 40 × 16 up to z = 30, platform 60 × 30 up to z = 40, a twisted
/// airfoil to z = 120.
pub fn blade() -> Mesh {
    let mut rings = vec![
        rectangle(40.0, 16.0, 0.0),
        rectangle(40.0, 16.0, 30.0),
        rectangle(60.0, 30.0, 30.0),
        rectangle(60.0, 30.0, 40.0),
    ];
    rings.extend((0..=24).map(|k| airfoil(f64::from(k) / 24.0)));
    stack(&rings)
}

/// Height of the platform of [`blade`], mm.
pub const PLATFORM: f64 = 40.0;
/// Height of its tip, mm.
pub const TIP: f64 = 120.0;

/// A rectangle, walked counter-clockwise from +y.
fn rectangle(length: f64, width: f64, z: f64) -> Vec<Point> {
    (0..AROUND)
        .map(|k| {
            let a = (k as f64 + 0.5) / AROUND as f64 * std::f64::consts::TAU;
            let scale = (0.5 * length / a.cos().abs()).min(0.5 * width / a.sin().abs());
            Point::new(scale * a.cos(), scale * a.sin(), z)
        })
        .collect()
}

/// A cambered profile with rounded edges, twisted by 0.4 rad and shrunk by a quarter from foot to
/// tip.
fn airfoil(share: f64) -> Vec<Point> {
    let (turn, scale) = (0.4 * (share - 0.3), 36.0 * (1.0 - 0.25 * share));
    (0..AROUND)
        .map(|k| {
            let a = (k as f64 + 0.5) / AROUND as f64 * std::f64::consts::TAU;
            // An ellipse with one side thinner, bent along a parabola.
            let x = 0.5 * a.cos();
            let y = 0.055 * a.sin() * (1.0 - 0.5 * a.cos()) + 0.12 * (0.25 - x * x) - 0.02;
            let (x, y) = (scale * x, scale * y);
            Point::new(
                x * turn.cos() - y * turn.sin(),
                x * turn.sin() + y * turn.cos(),
                PLATFORM + share * (TIP - PLATFORM),
            )
        })
        .collect()
}

/// Rings of equal length to a closed mesh, wound outward.
fn stack(rings: &[Vec<Point>]) -> Mesh {
    let n = AROUND as u32;
    let mut mesh = Mesh { points: rings.concat(), ..Mesh::default() };
    for row in 0..rings.len() as u32 - 1 {
        for k in 0..n {
            let (a, b) = (row * n + k, row * n + (k + 1) % n);
            mesh.triangles.push([a, b, b + n]);
            mesh.triangles.push([a, b + n, a + n]);
        }
    }
    for (row, up) in [(0, false), (rings.len() as u32 - 1, true)] {
        let c = mesh.points.len() as u32;
        let ring = &rings[row as usize];
        mesh.points.push(Point::from(ring.iter().map(|p| p.coords).sum::<crate::geometry::Vector>() / f64::from(n)));
        for k in 0..n {
            let (a, b) = (row * n + k, row * n + (k + 1) % n);
            mesh.triangles.push(if up { [c, a, b] } else { [c, b, a] });
        }
    }
    mesh
}

/// The bytes behind the mark that editors put before UTF-8.
pub fn marked(bytes: &[u8]) -> Vec<u8> {
    [b"\xef\xbb\xbf", bytes].concat()
}

/// The mesh as ASCII STL.
pub fn ascii_stl(mesh: &Mesh) -> String {
    let mut out = String::from("solid blade\n");
    for t in 0..mesh.triangles.len() {
        out.push_str("facet normal 0 0 0\nouter loop\n");
        for p in mesh.corners(t) {
            writeln!(out, "vertex {} {} {}", p.x, p.y, p.z).unwrap();
        }
        out.push_str("endloop\nendfacet\n");
    }
    out.push_str("endsolid blade\n");
    out
}

/// The mesh as binary STL with this header.
pub fn binary_stl(mesh: &Mesh, header: &str) -> Vec<u8> {
    let mut out = header.as_bytes().to_vec();
    out.resize(80, b' ');
    out.extend((mesh.triangles.len() as u32).to_le_bytes());
    for t in 0..mesh.triangles.len() {
        out.extend([0; 12]);
        for p in mesh.corners(t) {
            for x in [p.x, p.y, p.z] {
                out.extend((x as f32).to_le_bytes());
            }
        }
        out.extend([0; 2]);
    }
    out
}

/// The mesh as OBJ with quadrilaterals left as triangles.
pub fn obj(mesh: &Mesh) -> String {
    let mut out = String::from("# test\ng blade\n");
    for p in &mesh.points {
        writeln!(out, "v {} {} {}", p.x, p.y, p.z).unwrap();
    }
    for t in &mesh.triangles {
        writeln!(out, "f {} {} {}", t[0] + 1, t[1] + 1, t[2] + 1).unwrap();
    }
    out
}

/// A rotation about an axis through the origin, then a shift.
pub fn motion(axis_angle: [f64; 3], shift: [f64; 3]) -> Rigid {
    Rigid::new(shift.into(), axis_angle.into())
}
