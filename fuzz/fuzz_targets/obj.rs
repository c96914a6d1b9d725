#![no_main]
//! Any bytes as a file `a.obj`: a survey or an error.

use std::path::Path;

use bladewright::model::{self, ModelOptions};
use bladewright::observe::Silent;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let options = ModelOptions { deflection_mm: 0.5, ..ModelOptions::default() };
    let _ = model::survey_bytes(Path::new("a.obj"), data, &options, &Silent);
});
