//! From a part in memory to program text without a file: `cargo run --release --example in_memory`.
//! With progress, and a way to stop.

#![allow(clippy::print_stdout)]

use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use bladewright::artifact::program::Control;
use bladewright::error::{Result, Stage};
use bladewright::machine::Machine;
use bladewright::observe::{Observer, Warning};
use bladewright::read::model;
use bladewright::read::model::ModelOptions;
use bladewright::write::post::Dialect;
use bladewright::{job, make, plan};

/// A coarse helix round the prism, high over its platform.
const JOB: &str = "
[model]
file = 'prism.step'

[path]
scallop_mm = 0.2

[region]
start_mm = 30
end_mm = 20
";

/// Where a program with a window of its own would show progress, and set `stop` when its user has
/// had enough.
#[derive(Default)]
pub struct Window {
    /// How often progress was shown.
    pub shown: AtomicUsize,
    /// The user wants to stop.
    pub stop: AtomicBool,
}

impl Observer for Window {
    fn progress(&self, _stage: Stage, _done: usize, _total: usize) {
        self.shown.fetch_add(1, Ordering::Relaxed);
    }
    fn warn(&self, warning: Warning) {
        eprintln!("{}: {}", warning.stage, warning.doubt);
    }
    fn cancelled(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// The program of a made blade for a control; `None` where its plan fails the checks.
///
/// # Errors
/// Those of the stages; kind `Cancelled` after `stop`.
pub fn program(control: Control, window: &Window) -> Result<Option<String>> {
    let step = make::step_text(&make::build(&make::presets::prism())?)?;
    let blade = model::load_bytes(Path::new("prism.step"), step.as_bytes(), &ModelOptions::default(), window)?;
    let draft = job::resolve(job::parse(JOB, "the job")?, Path::new(""))?;
    let setup = plan::Setup::of(&draft, blade, Machine::demo()?, window)?;
    let Some(verified) = plan::accept(plan::plan(&setup, window)?, false) else { return Ok(None) };
    let (program, checks) = setup.program(&Dialect::built_in(control)?, &verified)?;
    Ok(checks.iter().all(|c| c.passed).then_some(program.text))
}

#[allow(dead_code)]
fn main() -> Result<()> {
    let window = Window::default();
    match program(Control::Siemens, &window)? {
        Some(text) => text.lines().take(20).for_each(|line| println!("{line}")),
        None => println!("the plan fails its checks"),
    }
    Ok(())
}
