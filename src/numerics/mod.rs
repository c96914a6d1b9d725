//! Numbers only: roots, splines, banded systems. No geometry.
pub mod banded;
pub mod spline;
