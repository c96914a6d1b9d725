//! The stages in a straight line.
