//! Numbers only: angles, splines, banded systems, convex problems along a line of stages. No geometry.
pub mod angle;
pub mod banded;
pub mod bezier;
pub mod spline;
pub mod stages;
