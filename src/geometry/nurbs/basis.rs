//! NURBS: basis.
