//! README and manual run as printed: the commands in every `sh` fence of a chapter are one session
//! of a shell, in a folder that holds what a clean checkout holds.
#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::Command;

fn checkout() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README and the files of `docs/`, by their names.
fn chapters() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = std::fs::read_dir(checkout().join("docs"))
        .expect("docs")
        .map(|entry| entry.expect("an entry of docs").path())
        .filter(|path| path.extension().is_some_and(|e| e == "md"))
        .collect();
    found.push(checkout().join("README.md"));
    found.sort();
    found
}

/// The fences of a chapter: language and lines, with the number of their first line.
fn fences(chapter: &Path) -> Vec<(String, usize, Vec<String>)> {
    let text = std::fs::read_to_string(chapter).expect("a chapter");
    let mut found = Vec::new();
    let mut open: Option<(String, usize, Vec<String>)> = None;
    for (number, line) in text.lines().enumerate() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(language), None) => open = Some((language.to_owned(), number + 2, Vec::new())),
            (Some(_), Some(_)) => found.extend(open.take()),
            (None, Some(fence)) => fence.2.push(line.to_owned()),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "{}: a fence does not end", chapter.display());
    found
}

/// What cargo does is done already where a test runs: what it builds is the program that is tested,
/// and what it tests is this.
fn as_here(line: &str) -> Option<String> {
    if let Some(arguments) = line.strip_prefix("cargo run --release -- ") {
        return Some(format!("bladewright {arguments}"));
    }
    let set_up = ["cargo nextest run --release", "cargo build --release", "export PATH=\"$PWD/target/release:$PATH\""];
    (!set_up.contains(&line)).then(|| line.to_owned())
}

/// In the short form, which CI asks for, commands mill ridges three times as high as printed, on
/// chords twice as far off, and checks look at the part in fewer places; so do commands that plan a
/// job without a scallop of their own.
fn shortened(line: String) -> String {
    if std::env::var_os("BLADEWRIGHT_SHORT").is_none() {
        return line;
    }
    let coarse = "scallop_mm=0.15 --set path.chord_mm=0.002 --set verify.surface_samples=20000";
    let is_job = line.starts_with("bladewright plan examples/jobs/") && !line.contains("scallop_mm");
    let line = line.replace("scallop_mm=0.05", coarse).replace("--scallop 0.05", "--scallop 0.15");
    if is_job { format!("{line} --set path.{coarse}") } else { line }
}

fn session(chapter: &Path) -> Vec<String> {
    let fences = fences(chapter).into_iter().filter(|f| f.0 == "sh");
    fences.flat_map(|f| f.2).filter(|l| !l.is_empty()).filter_map(|l| as_here(&l)).map(shortened).collect()
}

/// Runs the commands of a chapter; gives the folder in which they ran.
fn run_as_printed(name: &str) -> tempfile::TempDir {
    let chapter = checkout().join(name);
    let folder = tempfile::tempdir().expect("a folder");
    for entry in ["Cargo.toml", "docs", "examples", "models", "src", "tests"] {
        std::os::unix::fs::symlink(checkout().join(entry), folder.path().join(entry)).expect("a link");
    }
    let binary = Path::new(env!("CARGO_BIN_EXE_bladewright"));
    let binaries = binary.parent().expect("a folder").to_path_buf();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(binaries).chain(std::env::split_paths(&path))).expect("a path");
    for line in session(&chapter) {
        let out = Command::new("bash")
            .args(["-euo", "pipefail", "-c", &line])
            .current_dir(folder.path())
            .env("PATH", &path)
            .env("HOME", folder.path())
            .output()
            .expect("bash");
        let told = String::from_utf8_lossy(&out.stderr);
        assert!(out.status.success(), "{name}: `{line}` ended with {}:\n{told}", out.status);
    }
    folder
}

/// What the README says that its first command gains.
fn gains_what_the_readme_says(folder: &Path) {
    let text = std::fs::read_to_string(checkout().join("README.md")).expect("the README");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let summary = std::fs::read(folder.join("out/turbine_camber/summary.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_slice(&summary).expect("JSON");
    let of = |key: &str| {
        let schedules = summary["schedules"].as_array().expect("schedules");
        let is = |s: &&serde_json::Value| (s["kind"] == "fixed") == (key == "fixed");
        schedules.iter().find(is).unwrap_or_else(|| panic!("no schedule {key}")).clone()
    };
    let minutes = |s: &serde_json::Value| {
        let s = s["machining_time_s"].as_f64().expect("seconds").round() as u64;
        format!("{}:{:02} min", s / 60, s % 60)
    };
    let (own, fixed) = (of("own"), of("fixed"));
    let says = format!(
        "machining takes {} instead of {}, and the rotary axis never turns back instead of {} times",
        minutes(&own),
        minutes(&fixed),
        fixed["reversals"]
    );
    assert!(text.contains(&says) && own["reversals"] == 0, "the README says otherwise than: {says}");
}

macro_rules! sessions {
    ($($test:ident: $name:literal $(, then $check:ident)?;)*) => {
        const SESSIONS: &[&str] = &[$($name),*];
        $(
            #[test]
            #[ignore = "plans many blades; `just manual` runs it"]
            fn $test() {
                let _folder = run_as_printed($name);
                $($check(_folder.path());)?
            }
        )*
    };
}

sessions! {
    readme_runs_as_printed: "README.md", then gains_what_the_readme_says;
    checking_runs_as_printed: "docs/checking.md";
    cutters_run_as_printed: "docs/cutters.md";
    families_run_as_printed: "docs/families.md";
    installing_runs_as_printed: "docs/install.md";
    machines_run_as_printed: "docs/machines.md";
    models_run_as_printed: "docs/models.md";
    pinching_runs_as_printed: "docs/pinch.md";
    planning_runs_as_printed: "docs/planning.md";
    programs_run_as_printed: "docs/programs.md";
    rescheduling_runs_as_printed: "docs/rescheduling.md";
    showing_runs_as_printed: "docs/showing.md";
    turning_runs_as_printed: "docs/turning.md";
    wheels_run_as_printed: "docs/wheels.md";
}

#[test]
fn every_chapter_with_commands_is_run() {
    for chapter in chapters() {
        let name = chapter.strip_prefix(checkout()).expect("a chapter of ours").display().to_string();
        assert!(
            SESSIONS.contains(&name.as_str()) || session(&chapter).is_empty(),
            "no test runs the commands of {name}"
        );
    }
    for name in SESSIONS {
        assert!(!session(&checkout().join(name)).is_empty(), "{name} prints no commands");
    }
}

/// A command outside a `sh` fence would be printed without being run.
#[test]
fn commands_stand_in_fences_that_are_run() {
    for chapter in chapters() {
        let name = chapter.display();
        let fences = fences(&chapter);
        for (language, number, lines) in &fences {
            assert!(["sh", "toml", "text"].contains(&language.as_str()), "{name}:{number}: a fence of no known kind");
            let command = lines.iter().find(|l| language != "sh" && l.trim_start().starts_with("bladewright "));
            assert!(command.is_none(), "{name}:{number}: no test runs `{command:?}`");
        }
        let text = std::fs::read_to_string(&chapter).expect("a chapter");
        let indented = text.lines().find(|l| l.starts_with("    bladewright ") || l.starts_with("    cargo "));
        assert!(indented.is_none(), "{name}: no test runs `{indented:?}`");
    }
}
