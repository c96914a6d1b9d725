//! What people look at: a 3-D scene ([`gltf()`]) and a page ([`report`]).
//!
//! **In**: the artifacts of a run. **Out**: bytes of a `.glb` file and text of a self-contained
//! `.html` file. Both are thinned for the eye and say so; neither is meant to be measured from.

pub mod gltf;
pub mod report;
mod thin;
pub mod values;

pub use gltf::{GltfOptions, PinchKey, PinchScene, Scene, deviation, gltf, pinch, regions};
pub use report::ReportInput;
