//! Interpolating splines.
