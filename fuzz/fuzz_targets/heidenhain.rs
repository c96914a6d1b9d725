#![no_main]
//! Any bytes as a program of `heidenhain`: moves or an error.

#[macro_use]
#[path = "../target.rs"]
mod target;

program!("heidenhain");
