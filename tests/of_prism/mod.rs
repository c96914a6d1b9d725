//! Jobs on the prism, in memory, on the machines of the repository.
#![allow(clippy::expect_used)]

use std::path::Path;

use bladewright::error::Result;
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::plan::Setup;
use bladewright::read::model::{self, ModelOptions};
use bladewright::{job, make};

/// A job with changes as `--set` takes them.
pub fn setup(job: &str, changes: &[&str], machine: Machine) -> Result<Setup> {
    let step = make::step_text(&make::build(&make::presets::prism())?)?;
    setup_of(("prism.step", step.as_bytes()), job, changes, machine)
}

/// The same with another model, a name and what its file holds.
pub fn setup_of((name, bytes): (&str, &[u8]), job: &str, changes: &[&str], machine: Machine) -> Result<Setup> {
    let blade = model::load_bytes(Path::new(name), bytes, &ModelOptions::default(), &Silent)?;
    let mut typed = job::parse(job, "the job")?;
    changes.iter().try_for_each(|c| typed.set(c))?;
    Setup::of(&job::resolve(typed, Path::new(""))?, blade, machine, &Silent)
}

/// A machine of the repository, its file changed.
pub fn machine(name: &str, changed: impl Fn(String) -> String) -> Machine {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/machines").join(name);
    let text = std::fs::read_to_string(file).expect("a machine file");
    Machine::from_toml(&changed(text), name).expect("a machine")
}
