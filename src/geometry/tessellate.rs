//! Trimmed NURBS faces to one watertight triangle mesh.
