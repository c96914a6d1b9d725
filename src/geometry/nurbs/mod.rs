//! NURBS curves and surfaces: evaluation with first and second derivatives, fitting.
//! The notation is that of Piegl and Tiller, *The NURBS Book* (1997).
pub mod basis;
pub mod curve;
pub mod fit;
pub mod foot;
pub mod pieces;
#[cfg(test)]
pub(crate) mod shapes;
pub mod surface;
pub use curve::NurbsCurve;
pub use surface::{NurbsSurface, Principal, SurfaceDerivatives};
