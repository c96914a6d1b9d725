//! Openings, healing and doubts on real blades from the folder that `BLADEWRIGHT_BLADES` names (see
//! `tests/corpus.rs`).

use std::path::PathBuf;
use std::process::{Command, Output};

fn run(verb: &str, file: &str, options: &[&str]) -> Output {
    let folder = std::env::var_os("BLADEWRIGHT_BLADES").map(PathBuf::from);
    let folder = folder.expect("BLADEWRIGHT_BLADES names the folder of real blades");
    let dir = tempfile::tempdir().expect("temporary folder");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.args(["--quiet", verb]).arg(folder.join(file)).args(options).current_dir(dir.path());
    if verb == "plan" {
        command.args(["-o", "out"]);
    }
    command.output().expect("the command starts")
}

fn text(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

/// One face, open at both ends: its ends are in reach of the tool, or far from it.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_open_ends_matter_only_in_reach() {
    let file = "airfoil_22dx_single_surface.igs";
    let near = run("plan", file, &[]);
    assert_eq!(near.status.code(), Some(4), "{}", text(&near));
    for word in ["not closed where the tool works", "1 opening between", "in the model"] {
        assert!(text(&near).contains(word), "{word}: {}", text(&near));
    }
    let options = ["region.start_mm=62", "region.end_mm=55", "tool.radius_mm=1"].map(|v| ["--set", v]).concat();
    let far = run("plan", file, &options);
    assert_eq!(far.status.code(), Some(0), "{}", text(&far));
    assert!(text(&far).contains("out of the tool's reach"), "{}", text(&far));
}

/// A mesh with degenerate triangles, edges of four triangles and pieces: all that was changed is
/// listed.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_what_was_healed_is_listed() {
    let out = run("inspect", "je1_propeller_blade_ascii.stl", &[]);
    let text = text(&out);
    for word in [
        "the unit is a guess",
        "2 degenerate triangles were dropped",
        "were wound against their neighbours and were turned",
    ] {
        assert!(text.contains(word), "{word}:\n{text}");
    }
}

/// A unit that nothing but size and slenderness can tell.
#[test]
#[ignore = "real blades, see the file's head"]
fn corpus_units_that_are_doubted() {
    for (file, word) in [
        ("iea15mw/IEA-15-240-RWT_blade.stl", "pass --unit m,"),
        ("iea15mw/IEA_15MW_CFD.stp", "pass --unit m,"),
        ("rotor37/profile_R37.dat", "in cm 74"),
    ] {
        let out = run("inspect", file, &[]);
        let text = text(&out);
        assert!(text.contains("the unit is not certain") && text.contains(word), "{file}:\n{text}");
    }
    let plan = run("plan", "iea15mw/IEA-15-240-RWT_blade.stl", &[]);
    assert_eq!(plan.status.code(), Some(4));
    assert!(
        text(&plan).contains("the unit is not certain") && text(&plan).contains("pass --unit m,"),
        "{}",
        text(&plan)
    );
    let told = run("inspect", "iea15mw/IEA_15MW_CFD.stp", &["--unit", "mm"]);
    assert!(!text(&told).contains("the unit is not certain"));
}
