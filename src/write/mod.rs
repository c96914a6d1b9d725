//! Writers: programs for controls, scenes and pages for people, and the charts in them.

pub mod draw;
pub mod post;
pub mod preview;
