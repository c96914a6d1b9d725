//! `inspect`: what is in a model file.

use super::args::Inspect;
use super::progress::Terminal;
use crate::error::Result;
use crate::model::{self, ModelOptions};

/// Runs the verb; the exit code.
pub fn run(args: &Inspect, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let options =
        ModelOptions { unit: args.reading.unit, axis: args.reading.axis.map(|a| a.0), ..ModelOptions::default() };
    let blade = model::load(&args.model, &options, &terminal);
    terminal.finish();
    print!("{}", model::inspect_text(&blade?));
    Ok(0)
}
