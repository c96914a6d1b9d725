//! A family from Rust: `cargo run --release --example batch -- FAMILY.toml OUT`. What
//! `bladewright batch` does, in ten lines.

#![allow(clippy::print_stdout)]

use bladewright::batch::{self, BatchOptions, Family};
use bladewright::observe::Silent;

fn main() -> bladewright::error::Result<()> {
    let argument = |k: usize, or: &str| std::env::args().nth(k).unwrap_or_else(|| or.to_owned());
    let family = Family::load(argument(1, "examples/families/twist.toml").as_ref())?;
    let done = batch::run(&family, &argument(2, "out/twist"), &BatchOptions::default(), &Silent)?;
    for member in &done.records {
        println!("{} {}", member.name, member.status.word());
    }
    std::process::exit(done.exit_code().into())
}
