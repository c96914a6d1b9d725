//! A watertight mesh of a made blade: points exactly on its surfaces, shared along its edges.
//!
//! Airfoil and fillet are divided by a grid of parameters that neighbours share along their common
//! boundary. The divisions are halved until no chord of the grid is farther from the surface than
//! the deflection asked for; then the triangles are measured, and the grid is made finer until they
//! keep it too. Flat faces are triangulated between their boundary points (constrained Delaunay).

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::assemble::Solid;
use crate::error::{DesignFault, Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::geometry::brep::{Coedge, SurfaceKind};
use crate::geometry::mesh::Mesh;
use crate::geometry::nurbs::NurbsSurface;

/// Finest division of one knot span or patch: 2 to this power.
const MAX_HALVINGS: usize = 9;

/// Curved faces in the order of [`super::assemble`]: all airfoil patches, then all fillets.
struct PatchGrid<'a> {
    airfoil: Vec<&'a NurbsSurface>,
    fillet: Vec<&'a NurbsSurface>,
    /// Parameters along u of every patch.
    u: Vec<Vec<f64>>,
    v_airfoil: Vec<f64>,
    v_fillet: Vec<f64>,
}

/// Halves intervals until `deviation(a, b)` is within the tolerance on each.
fn divide(start: &[f64], tolerance: f64, deviation: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut out = vec![start[0]];
    for w in start.windows(2) {
        let mut stack = vec![(w[0], w[1], 0)];
        while let Some((a, b, depth)) = stack.pop() {
            if depth < MAX_HALVINGS && deviation(a, b) > tolerance {
                let m = 0.5 * (a + b);
                stack.push((m, b, depth + 1));
                stack.push((a, m, depth + 1));
            } else {
                out.push(b);
            }
        }
    }
    out
}

/// Distance of the curve `f` from its chord between `a` and `b`, at three points between.
fn chord_error(f: impl Fn(f64) -> Point, a: f64, b: f64) -> f64 {
    let (p, q) = (f(a), f(b));
    let chord = (q - p).try_normalize(0.0);
    [0.25, 0.5, 0.75]
        .map(|t| {
            let d = f(a + t * (b - a)) - p;
            chord.map_or(d.norm(), |c| (d - c * d.dot(&c)).norm())
        })
        .into_iter()
        .fold(0.0, f64::max)
}

fn range(knots: &[f64]) -> [f64; 2] {
    [knots[0], knots[knots.len() - 1]]
}

fn samples(knots: &[f64], n: usize) -> Vec<f64> {
    let [a, b] = range(knots);
    (0..=n).map(|i| a + (b - a) * i as f64 / n as f64).collect()
}

impl<'a> PatchGrid<'a> {
    fn new(airfoil: Vec<&'a NurbsSurface>, fillet: Vec<&'a NurbsSurface>, tolerance: f64) -> Self {
        let along_v = |surfaces: &[&NurbsSurface], pieces: usize| match surfaces.first() {
            Some(first) => divide(&samples(&first.knots_v, pieces), tolerance, |a, b| {
                let error = |s: &&NurbsSurface| {
                    samples(&s.knots_u, 32).iter().map(|&u| chord_error(|v| s.point(u, v), a, b)).fold(0.0, f64::max)
                };
                surfaces.iter().map(error).fold(0.0, f64::max)
            }),
            None => Vec::new(),
        };
        let u = (0..airfoil.len())
            .map(|i| {
                let mut both = vec![airfoil[i]];
                both.extend(fillet.get(i));
                // Spans of a half cylinder start at its knots; a spline's are many and need not be
                // kept.
                let knots = &airfoil[i].knots_u;
                let start = if airfoil[i].n_u <= 5 { distinct(knots) } else { samples(knots, 8) };
                divide(&start, tolerance, |a, b| {
                    let error = |s: &&NurbsSurface| {
                        samples(&s.knots_v, 8).iter().map(|&v| chord_error(|u| s.point(u, v), a, b)).fold(0.0, f64::max)
                    };
                    both.iter().map(error).fold(0.0, f64::max)
                })
            })
            .collect();
        let (v_airfoil, v_fillet) = (along_v(&airfoil, 1), along_v(&fillet, 4));
        PatchGrid { airfoil, fillet, u, v_airfoil, v_fillet }
    }
}

fn distinct(knots: &[f64]) -> Vec<f64> {
    let mut k = knots.to_vec();
    k.dedup();
    k
}

/// The mesh of a solid with so many airfoil patches and fillets, and its greatest measured distance
/// from the surfaces, mm.
pub(super) fn mesh(solid: &Solid, [patches, fillets]: [usize; 2], deflection: f64) -> Result<(Mesh, f64)> {
    let surfaces: Vec<&NurbsSurface> = solid.brep.faces.iter().map(|f| &f.surface).collect();
    let mut tolerance = 0.6 * deflection;
    for _ in 0..8 {
        let grid =
            PatchGrid::new(surfaces[..patches].to_vec(), surfaces[patches..patches + fillets].to_vec(), tolerance);
        let mut maker = Maker::new(solid, &grid)?;
        let measured = maker.measure();
        if measured <= deflection {
            maker.flat_faces(patches + fillets)?;
            return Ok((maker.mesh, measured));
        }
        tolerance *= 0.7;
    }
    let fault = DesignFault::MeshOffSurface { deflection_mm: deflection };
    let message = format!("no mesh keeps within {deflection} mm of the surfaces");
    Err(Error::infeasible(Stage::Make, message, Infeasible::Design { fault })
        .advise("make accuracy.deflection_mm larger"))
}

/// Points that a mesh may have.
const MOST_POINTS: usize = 20_000_000;

struct Maker<'a> {
    solid: &'a Solid,
    mesh: Mesh,
    /// Mesh points along every edge, from its start to its end; straight edges of the block: their
    /// ends.
    on_edge: Vec<Vec<u32>>,
}

impl<'a> Maker<'a> {
    fn new(solid: &'a Solid, grid: &PatchGrid) -> Result<Self> {
        let on_edge = vec![Vec::new(); solid.brep.edges.len()];
        let mut maker = Maker { solid, mesh: Mesh::default(), on_edge };
        let n = grid.airfoil.len();
        // Columns round the ring: every patch's parameters but its last, which is the next patch's
        // first.
        let columns: Vec<(usize, usize)> = (0..n).flat_map(|i| (0..grid.u[i].len() - 1).map(move |k| (i, k))).collect();
        let fillet_rows = grid.v_fillet.len().saturating_sub(1);
        let rows = fillet_rows + grid.v_airfoil.len();
        if columns.len() * rows > MOST_POINTS {
            let message = format!("the mesh would have more than {} million points", MOST_POINTS / 1_000_000);
            let fault = DesignFault::MeshTooLarge { most_points: MOST_POINTS };
            return Err(Error::infeasible(Stage::Make, message, Infeasible::Design { fault })
                .advise("make accuracy.deflection_mm larger"));
        }
        for &(i, k) in &columns {
            for row in 0..rows {
                let u = grid.u[i][k];
                let p = match row.checked_sub(fillet_rows) {
                    Some(r) => grid.airfoil[i].point(u, grid.v_airfoil[r]),
                    None => grid.fillet[i].point(u, grid.v_fillet[row]),
                };
                maker.mesh.points.push(p);
            }
        }
        let id = |column: usize, row: usize| ((column % columns.len()) * rows + row) as u32;
        let mut first = 0;
        for i in 0..n {
            let count = grid.u[i].len() - 1;
            maker.patch(i, &grid.u[i], &grid.v_airfoil, |c, r| id(first + c, r + fillet_rows));
            if fillet_rows > 0 {
                maker.patch(n + i, &grid.u[i], &grid.v_fillet, |c, r| id(first + c, r));
            }
            first += count;
        }
        maker.ring_edges(n, fillet_rows, grid, id);
        Ok(maker)
    }

    /// Triangles of one patch; each quadrangle is cut along its shorter diagonal.
    fn patch(&mut self, face: usize, u: &[f64], v: &[f64], id: impl Fn(usize, usize) -> u32) {
        for c in 0..u.len() - 1 {
            for r in 0..v.len() - 1 {
                let q = [(c, r), (c + 1, r), (c + 1, r + 1), (c, r + 1)];
                let p = q.map(|(c, r)| self.mesh.points[id(c, r) as usize]);
                let cut = if (p[2] - p[0]).norm() <= (p[3] - p[1]).norm() {
                    [[0, 1, 2], [0, 2, 3]]
                } else {
                    [[0, 1, 3], [1, 2, 3]]
                };
                for t in cut {
                    self.mesh.triangles.push(t.map(|k: usize| id(q[k].0, q[k].1)));
                    self.mesh.corner_uv.push(t.map(|k: usize| [u[q[k].0], v[q[k].1]]));
                    self.mesh.face_of.push(face as u32);
                }
            }
        }
    }

    /// Points on the edges round foot and tip, which the flat faces need. Edges are found by the
    /// loops of the faces.
    fn ring_edges(&mut self, n: usize, fillet_rows: usize, grid: &PatchGrid, id: impl Fn(usize, usize) -> u32) {
        let top = fillet_rows + grid.v_airfoil.len() - 1;
        let mut first = 0;
        for i in 0..n {
            let count = grid.u[i].len() - 1;
            let faces = &self.solid.brep.faces;
            let lower = if fillet_rows > 0 { &faces[n + i] } else { &faces[i] };
            // The loops start with the lower edge; the third is the upper one (see `assemble`).
            let (foot, tip) = (lower.loops[0][0].edge, faces[i].loops[0][2].edge);
            self.on_edge[foot] = (0..=count).map(|c| id(first + c, 0)).collect();
            self.on_edge[tip] = (0..=count).map(|c| id(first + c, top)).collect();
            first += count;
        }
    }

    /// Greatest distance of the triangles' edges' and centres' points from the surface points of
    /// the same parameters.
    fn measure(&self) -> f64 {
        let faces = &self.solid.brep.faces;
        let mut worst = 0.0_f64;
        for (t, uv) in self.mesh.corner_uv.iter().enumerate() {
            let face = &faces[self.mesh.face_of[t] as usize];
            if face.kind == SurfaceKind::Plane {
                continue;
            }
            let p = self.mesh.corners(t);
            let Some(normal) = (p[1] - p[0]).cross(&(p[2] - p[0])).try_normalize(0.0) else { continue };
            for b in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [1.0 / 3.0; 3]] {
                let at = |k: usize| (0..3).map(|c| b[c] * uv[c][k]).sum::<f64>();
                worst = worst.max((face.surface.point(at(0), at(1)) - p[0]).dot(&normal).abs());
            }
        }
        worst
    }

    /// Triangles of all flat faces.
    fn flat_faces(&mut self, first: usize) -> Result<()> {
        let mut of_vertex = vec![None; self.solid.vertices.len()];
        for face in first..self.solid.brep.faces.len() {
            let loops: Vec<Vec<u32>> = self.solid.brep.faces[face]
                .loops
                .iter()
                .map(|l| l.iter().flat_map(|c| self.along(c, &mut of_vertex)).collect())
                .collect();
            self.flat_face(face, &loops)?;
        }
        Ok(())
    }

    /// Mesh points of a coedge without its last.
    fn along(&mut self, c: &Coedge, of_vertex: &mut [Option<u32>]) -> Vec<u32> {
        if self.on_edge[c.edge].is_empty() {
            self.on_edge[c.edge] = self.solid.ends[c.edge]
                .map(|v| {
                    *of_vertex[v].get_or_insert_with(|| {
                        self.mesh.points.push(self.solid.vertices[v]);
                        self.mesh.points.len() as u32 - 1
                    })
                })
                .to_vec();
        }
        let mut ids = self.on_edge[c.edge].clone();
        if c.reversed {
            ids.reverse();
        }
        ids.pop();
        ids
    }

    fn flat_face(&mut self, face: usize, loops: &[Vec<u32>]) -> Result<()> {
        let s = &self.solid.brep.faces[face].surface;
        // Bilinear rectangle: parameters are coordinates along its sides.
        let origin = s.point(0.0, 0.0);
        let (eu, ev) = (s.point(1.0, 0.0) - origin, s.point(0.0, 1.0) - origin);
        let (lu, lv) = (eu.norm(), ev.norm());
        let failed = || {
            let name = self.solid.brep.faces[face].name.own();
            let fault = DesignFault::FaceCrossesItself { face: name.to_owned() };
            let message = format!("the face '{name}' crosses itself and cannot be meshed");
            Error::infeasible(Stage::Make, message, Infeasible::Design { fault })
                .advise("check thickness, edge radii and fillet radius against the chord")
        };
        let mut cdt = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
        let mut ids = Vec::new();
        let mut sides = Vec::new();
        for l in loops {
            let mut handles = Vec::with_capacity(l.len());
            for &i in l {
                let d = self.mesh.points[i as usize] - origin;
                let h = cdt.insert(Point2::new(d.dot(&eu) / lu, d.dot(&ev) / lv)).map_err(|_| failed())?;
                if h.index() != ids.len() {
                    return Err(failed());
                }
                ids.push(i);
                handles.push(h);
            }
            for k in 0..handles.len() {
                let (a, b) = (handles[k], handles[(k + 1) % handles.len()]);
                if !cdt.can_add_constraint(a, b) {
                    return Err(failed());
                }
                cdt.add_constraint(a, b);
                sides.push([a, b].map(|h| cdt.vertex(h).position()));
            }
        }
        let mut triangles = Vec::new();
        for f in cdt.inner_faces() {
            let v = f.vertices();
            let p = v.map(|v| v.position());
            let centre = [(p[0].x + p[1].x + p[2].x) / 3.0, (p[0].y + p[1].y + p[2].y) / 3.0];
            if inside(centre, &sides) {
                triangles.push((v.map(|v| ids[v.index()]), p.map(|p| [p.x / lu, p.y / lv])));
            }
        }
        if triangles.len() + 2 != ids.len() + 2 * (loops.len() - 1) {
            return Err(failed());
        }
        for (t, uv) in triangles {
            self.mesh.triangles.push(t);
            self.mesh.corner_uv.push(uv);
            self.mesh.face_of.push(face as u32);
        }
        Ok(())
    }
}

/// An odd number of sides is crossed on the way to infinity.
fn inside([x, y]: [f64; 2], sides: &[[Point2<f64>; 2]]) -> bool {
    let crossed = |[a, b]: &[Point2<f64>; 2]| (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    sides.iter().filter(|s| crossed(s)).count() % 2 == 1
}
