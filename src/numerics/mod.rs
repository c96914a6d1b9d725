//! Numbers only, no geometry: angles, splines, banded systems, convex problems along a line of
//! stages.
pub mod angle;
pub mod banded;
pub mod bezier;
pub mod spline;
pub mod stages;
