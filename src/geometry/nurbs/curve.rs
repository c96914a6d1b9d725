//! A NURBS curve in space.
use nalgebra::Vector4;

/// A NURBS curve: clamped or unclamped knots, homogeneous control points `(w x, w y, w z, w)`.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct NurbsCurve {
    /// Degree, at least 1.
    pub degree: usize,
    /// Knots, non-decreasing, `points.len() + degree + 1` of them.
    pub knots: Vec<f64>,
    /// Homogeneous control points `(w x, w y, w z, w)`, `w > 0`, mm.
    pub points: Vec<Vector4<f64>>,
}
