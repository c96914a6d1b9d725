//! Real blades from the folder that `BLADEWRIGHT_BLADES` names. They are not part of the repository (their licences do not
//! allow it); where the variable is not set, each test says so and passes. Slow: `cargo nextest run --release --run-ignored only corpus`.

use std::path::PathBuf;
use std::process::Command;

fn blades() -> Option<PathBuf> {
    let folder = std::env::var_os("BLADEWRIGHT_BLADES").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("BLADEWRIGHT_BLADES is not set: no real blades to test on");
    }
    folder
}

/// Plans a blade of the corpus, checks included; the exit code must be 0.
fn plans(file: &str, options: &[&str]) {
    let Some(folder) = blades() else { return };
    let model = folder.join(file);
    let out = tempfile::tempdir().expect("temporary folder");
    let run = Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .args(["--quiet", "plan"])
        .arg(model)
        .arg("-o")
        .arg(out.path().join("out"))
        .args(options)
        .output()
        .expect("the command starts");
    let text = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    assert_eq!(run.status.code(), Some(0), "{file}\n{text}");
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_rotor_on_a_hub_wedge() {
    plans("tblade3_case7288/case7288_rotor_hubwedge.step", &["--set", "region.end_mm=73"]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_scanned_turbine_blade() {
    plans("turbine_blade_scan.stl", &["--unit", "m", "--set", "tool.radius_mm=2", "--set", "region.end_mm=12"]);
}

#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_turbocharger_sector() {
    let options =
        ["tool.radius_mm=1", "tool.taper_deg=2", "region.start_mm=36", "region.end_mm=31"].map(|v| ["--set", v]);
    plans("turbocharger_turbine_sector.stl", &options.concat());
}

/// Every file of the corpus ends with an exit code of the list, never with a panic.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_inspect_never_panics() {
    let Some(folder) = blades() else { return };
    let mut open = vec![folder];
    while let Some(dir) = open.pop() {
        for entry in std::fs::read_dir(dir).expect("readable") {
            let path = entry.expect("entry").path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let run = Command::new(env!("CARGO_BIN_EXE_bladewright"))
                .args(["--quiet", "inspect"])
                .arg(&path)
                .output()
                .expect("the command starts");
            let text = String::from_utf8_lossy(&run.stderr);
            assert!(matches!(run.status.code(), Some(0..=4)), "{}\n{text}", path.display());
            assert!(!text.contains("panicked"), "{}\n{text}", path.display());
        }
    }
}
