//! NURBS: fit.
