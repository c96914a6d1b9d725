#![no_main]
//! Any bytes as a file `a.step`: a survey or an error.

#[macro_use]
#[path = "../target.rs"]
mod target;

reader!("a.step");
