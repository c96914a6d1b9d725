#![no_main]
//! Any bytes as a file `a.ply`: a survey or an error.

#[macro_use]
#[path = "../target.rs"]
mod target;

reader!("a.ply");
