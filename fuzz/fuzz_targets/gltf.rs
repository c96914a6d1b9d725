#![no_main]
//! Any bytes as a file `a.glb`: a survey or an error.

#[macro_use]
#[path = "../target.rs"]
mod target;

reader!("a.glb");
