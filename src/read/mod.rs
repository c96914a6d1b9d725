//! Readers: model files of blades and programs of other systems, from text or bytes to data.
//!
//! [`model`] gives a part with what was recognised on it. [`program`] gives the blocks of a program
//! and the machine's moves through them. What a program is worth is judged in [`crate::verify`],
//! not here.

pub mod model;
pub mod program;
pub mod tools;
