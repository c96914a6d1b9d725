//! A NURBS surface in space.
use nalgebra::Vector4;

use crate::geometry::{Point, Vector};

/// A tensor-product NURBS surface.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct NurbsSurface {
    /// Degree along u, at least 1.
    pub degree_u: usize,
    /// Degree along v, at least 1.
    pub degree_v: usize,
    /// Knots along u, non-decreasing, `n_u + degree_u + 1` of them.
    pub knots_u: Vec<f64>,
    /// Knots along v, non-decreasing, `n_v + degree_v + 1` of them.
    pub knots_v: Vec<f64>,
    /// Number of control points along u.
    pub n_u: usize,
    /// Number of control points along v.
    pub n_v: usize,
    /// Homogeneous control points `(w x, w y, w z, w)`, `w > 0`, mm; index `i_u * n_v + i_v`.
    pub points: Vec<Vector4<f64>>,
}

/// Point and derivatives of a surface at one parameter pair, mm per unit of the parameters.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceDerivatives {
    /// The point.
    pub p: Point,
    /// ∂S/∂u.
    pub du: Vector,
    /// ∂S/∂v.
    pub dv: Vector,
    /// ∂²S/∂u².
    pub duu: Vector,
    /// ∂²S/∂u∂v.
    pub duv: Vector,
    /// ∂²S/∂v².
    pub dvv: Vector,
}
