//! Numbers only, no geometry: angles, splines, banded systems, convex problems along a line of
//! stages and of a spline's control values.
pub mod angle;
pub mod banded;
pub mod bezier;
pub mod bounded;
pub mod elastic;
pub mod monotone;
pub mod quintic;
pub mod runs;
pub mod series;
pub mod spline;
pub mod stages;
