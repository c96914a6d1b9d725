//! A second opinion on the topology, by truck: the faces must make one connected, oriented, closed
//! manifold shell.

use truck_modeling::{
    BSplineCurve, BSplineSurface, Curve, Edge, Face, KnotVec, NurbsCurve, NurbsSurface, Point3, Shell, Surface,
    Vector4, Vertex, Wire,
};

use super::assemble::Solid;
use crate::error::{DesignFault, Error, Infeasible, Result, Stage};

fn failed(what: String) -> Error {
    let fault = DesignFault::NotClosed;
    Error::infeasible(Stage::Make, what, Infeasible::Design { fault })
        .advise("report this design: the surfaces do not make a closed solid")
}

fn vector(p: &nalgebra::Vector4<f64>) -> Vector4 {
    Vector4::new(p.x, p.y, p.z, p.w)
}

/// The solid in truck's types; truck checks that wires close, that edges are used once in each
/// sense, that the shell is connected and that no vertex is singular.
pub(super) fn truck_solid(solid: &Solid) -> Result<truck_modeling::Solid> {
    let vertices: Vec<Vertex> = solid.vertices.iter().map(|p| Vertex::new(Point3::new(p.x, p.y, p.z))).collect();
    let mut edges: Vec<Edge> = Vec::with_capacity(solid.ends.len());
    for (e, [a, b]) in solid.brep.edges.iter().zip(&solid.ends) {
        let points = e.curve.points.iter().map(vector).collect();
        let knots = KnotVec::from(e.curve.knots.clone());
        let curve = BSplineCurve::try_new(knots, points).map_err(|e| failed(format!("an edge is no B-spline: {e}")))?;
        let curve = Curve::NurbsCurve(NurbsCurve::new(curve));
        edges.push(
            Edge::try_new(&vertices[*a], &vertices[*b], curve)
                .map_err(|e| failed(format!("an edge has no length: {e}")))?,
        );
    }
    let mut faces: Vec<Face> = Vec::with_capacity(solid.brep.faces.len());
    for f in &solid.brep.faces {
        let wire = |l: &Vec<crate::geometry::brep::Coedge>| -> Wire {
            l.iter().map(|c| if c.reversed { edges[c.edge].inverse() } else { edges[c.edge].clone() }).collect()
        };
        let s = &f.surface;
        let knots = (KnotVec::from(s.knots_u.clone()), KnotVec::from(s.knots_v.clone()));
        let rows = s.points.chunks_exact(s.n_v).map(|r| r.iter().map(vector).collect()).collect();
        let surface = BSplineSurface::try_new(knots, rows)
            .map_err(|e| failed(format!("the face '{}' is no B-spline: {e}", f.name)))?;
        let surface = Surface::NurbsSurface(NurbsSurface::new(surface));
        let face = Face::try_new(f.loops.iter().map(wire).collect(), surface);
        faces.push(face.map_err(|e| failed(format!("the loops of the face '{}' are wrong: {e}", f.name)))?);
    }
    let shell: Shell = faces.into_iter().collect();
    truck_modeling::Solid::try_new(vec![shell]).map_err(|e| failed(format!("the faces make no solid: {e}")))
}
