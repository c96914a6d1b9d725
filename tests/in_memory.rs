//! The library plans in memory: the example's program is the command's, with progress, and it stops
//! when it is asked to.

#[path = "../examples/in_memory.rs"]
mod in_memory;

use std::process::Command;
use std::sync::atomic::Ordering;

use bladewright::artifact::program::Control;
use bladewright::error::ErrorKind;
use in_memory::{Window, program};

/// Lines that cut: headers name files and hashes that are not there in memory.
fn moves(text: &str) -> Vec<&str> {
    text.lines().filter(|line| !line.trim_start().starts_with([';', '('])).collect()
}

#[test]
fn a_plan_in_memory_is_the_commands_plan() {
    let window = Window::default();
    let text = program(Control::Siemens, &window).expect("a plan").expect("it passes");
    assert!(window.shown.load(Ordering::Relaxed) > 3, "progress is shown");
    let folder = tempfile::tempdir().expect("a folder");
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/models/prism.step");
    let keys = ["path.scallop_mm=0.2", "region.start_mm=30", "region.end_mm=20", "post.control=[\"siemens\"]"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.args(["--quiet", "plan", model, "-o"]).arg(folder.path());
    keys.iter().for_each(|key| {
        command.args(["--set", key]);
    });
    assert!(command.output().expect("it runs").status.success());
    let written = std::fs::read_to_string(folder.path().join("program.mpf")).expect("a program");
    assert_eq!(moves(&text), moves(&written));
}

#[test]
fn a_plan_in_memory_stops_when_it_is_asked_to() {
    let window = Window::default();
    window.stop.store(true, Ordering::Relaxed);
    let error = program(Control::Siemens, &window).expect_err("it stops");
    assert_eq!(error.kind, ErrorKind::Cancelled);
}
