//! The library plans in memory: the example's program is the command's, with progress, and it stops
//! when it is asked to.

#[path = "../examples/in_memory.rs"]
mod in_memory;

use std::path::Path;
use std::process::Command;
use std::sync::atomic::Ordering;

use bladewright::artifact::program::Control;
use bladewright::error::ErrorKind;
use bladewright::job::JobFile;
use bladewright::observe::Silent;
use bladewright::run::{self, inputs};
use bladewright::verify::Verdict;
use in_memory::{Window, program};

/// Lines that cut: headers name files and hashes that are not there in memory.
fn moves(text: &str) -> Vec<&str> {
    text.lines().filter(|line| !line.trim_start().starts_with([';', '('])).collect()
}

const MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/prism.step");
/// The keys of the example's job, and one control.
const KEYS: [&str; 4] = ["path.scallop_mm=0.2", "region.start_mm=30", "region.end_mm=20", "post.control=[\"siemens\"]"];

fn planned_by_the_command() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.args(["--quiet", "plan", MODEL, "-o"]).arg(folder.path());
    KEYS.iter().for_each(|key| {
        command.args(["--set", key]);
    });
    assert!(command.output().expect("it runs").status.success());
    folder
}

#[test]
fn a_job_in_memory_has_the_figures_of_the_command() {
    let mut job = JobFile::from_model(Path::new(MODEL));
    KEYS.iter().for_each(|key| job.set(key).expect("a key"));
    let draft = inputs::draft(job, Path::new("")).expect("a draft");
    let outcome = run::in_memory(&draft, false, &Silent).expect("a plan");
    assert!(outcome.files.is_empty() && matches!(outcome.verdict, Some(Verdict::Passed(_))));
    let text = std::fs::read(planned_by_the_command().path().join("summary.json")).expect("a summary");
    let mut written: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    // Nothing is posted in memory.
    assert!(!written["programs"].as_array().expect("programs").is_empty());
    written["programs"] = serde_json::json!([]);
    assert_eq!(serde_json::to_value(outcome.summary).expect("JSON"), written);
}

#[test]
fn a_plan_in_memory_is_the_commands_plan() {
    let window = Window::default();
    let text = program(Control::Siemens, &window).expect("a plan").expect("it passes");
    assert!(window.shown.load(Ordering::Relaxed) > 3, "progress is shown");
    let folder = planned_by_the_command();
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
