//! The library plans in memory: the example's program is the command's, with progress, and it stops
//! when it is asked to.

#[path = "../examples/in_memory.rs"]
mod example;

use std::path::Path;
use std::process::Command;
use std::sync::atomic::Ordering;

use bladewright::artifact::check_id::CheckId;
use bladewright::artifact::program::Control;
use bladewright::artifact::programmed::CurveRow;
use bladewright::error::ErrorKind;
use bladewright::job::JobFile;
use bladewright::observe::Silent;
use bladewright::run::{self, inputs};
use bladewright::verify::Verdict;
use example::{Window, program};

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

/// A smooth curve is programmed: the plan passes, also along the curve, the jerk of each linear
/// axis falls, and the program of polynomials, read back, is that curve with joints that fit.
#[test]
fn a_smooth_curve_is_what_is_programmed() {
    let mut job = JobFile::from_model(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step")));
    let controls = "post.control=[\"siemens-poly\",\"heidenhain-spl\"]";
    let keys = ["path.scallop_mm=0.1", "verify.surface_samples=20000", "feed.smooth=true", controls];
    keys.iter().for_each(|key| job.set(key).expect("a key"));
    let draft = inputs::draft(job, Path::new("")).expect("a draft");
    let outcome = run::in_memory(&draft, false, &Silent).expect("a plan");
    let smooth = outcome.summary.as_ref().and_then(|s| s.smooth.clone()).expect("figures of the curve");
    assert!(2 * smooth.pieces < smooth.locations_before, "{smooth:?}");
    assert!(smooth.inwards_mm <= 3e-4 && smooth.time_s < 1.002 * smooth.time_before_s, "{smooth:?}");
    for jerk in smooth.jerk.iter().filter(|j| ["X", "Y", "Z"].contains(&j.axis.as_str())) {
        assert!(jerk.now < 0.5 * jerk.before, "{jerk:?}");
    }
    let Some(Verdict::Passed(verified)) = &outcome.verdict else { panic!("it passes") };
    for id in [CheckId::CurveGouge, CheckId::CurveScallop, CheckId::CurveClearance, CheckId::CurveJoints] {
        assert!(verified.report().checks.iter().any(|c| c.id == id), "{id:?}");
    }
    for ((_, dialect), word) in outcome.setup.dialects().expect("dialects").into_iter().zip(["PO[", "SPL X"]) {
        let (program, checks) = outcome.setup.program(&dialect, verified).expect("a program");
        assert!(program.text.contains(word), "{word}");
        let joints = checks.iter().find(|c| c.id == CheckId::ProgramJoints).expect("joints are judged");
        let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
        assert!(failed.is_empty(), "{failed:?} {joints:?}");
    }
    // Curves that are spoilt at one row: into the part, off the next location, against θ.
    let middle = verified.value().toolpath.locations.len() / 2;
    let spoilt = |change: &dyn Fn(&mut CurveRow)| {
        let mut plan = verified.value().clone();
        change(&mut plan.curve.as_mut().expect("a curve").rows[middle]);
        let verdict = outcome.setup.verdict(plan, &Silent).expect("a verdict");
        let failed = verdict.report().checks.iter().filter(|c| !c.passed);
        failed.map(|c| c.id.clone()).collect::<Vec<_>>()
    };
    let normal = verified.value().toolpath.locations[middle].normal;
    let dives = |row: &mut CurveRow| (0..3).for_each(|d| row.centre[0][d] -= 0.2 * normal[d]);
    assert!(spoilt(&dives).contains(&CheckId::CurveGouge));
    assert_eq!(spoilt(&|row| row.centre[2][0] += 0.1), [CheckId::CurveJoints]);
    assert!(spoilt(&|row| row.theta[0] = -1.0).contains(&CheckId::CurveTheta));
}

/// A fit programs the same part with far fewer blocks: the plan passes, the program read back too,
/// and no curve has fewer pieces than the bound. Tolerances that the checks would not pass are
/// refused with their limit.
#[test]
fn a_fit_has_fewer_blocks_than_a_smooth_curve() {
    let set = |keys: &[&str]| {
        let mut job =
            JobFile::from_model(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step")));
        let usual = [
            "path.scallop_mm=0.1",
            "region.end_mm=8",
            "verify.surface_samples=20000",
            "post.control=[\"siemens-poly\"]",
        ];
        usual.iter().chain(keys).for_each(|key| job.set(key).expect("a key"));
        inputs::draft(job, Path::new(""))
    };
    let made = |key: &str| {
        let draft = set(&[key]).expect("a draft");
        let outcome = run::in_memory(&draft, false, &Silent).expect("a plan");
        let smooth = outcome.summary.as_ref().and_then(|s| s.smooth.clone()).expect("figures of the curve");
        let Some(Verdict::Passed(verified)) = &outcome.verdict else { panic!("it passes") };
        let dialects = outcome.setup.dialects().expect("dialects");
        let (program, checks) = outcome.setup.program(&dialects[0].1, verified).expect("a program");
        let failed: Vec<_> = checks.iter().filter(|c| !c.passed).collect();
        assert!(failed.is_empty(), "{failed:?}");
        (smooth, program.text.lines().filter(|line| line.contains("PO[")).count())
    };
    let ((few, few_blocks), (smooth, blocks)) = (made("feed.fit_mm=0.001"), made("feed.smooth=true"));
    assert!(2 * few_blocks < blocks && 2 * few.pieces < smooth.pieces, "{few_blocks} {blocks} {few:?} {smooth:?}");
    assert!(few.inwards_mm <= 0.001 && few.outwards_mm <= 0.001, "{few:?}");
    let bound = few.pieces_bound.expect("a bound");
    assert!(bound > 10 && bound <= few.pieces, "{bound} {}", few.pieces);
    assert!(smooth.pieces_bound.is_none());
    let refused = |keys: &[&str], words: &[&str]| {
        let draft = set(keys).expect("a draft");
        let e = run::in_memory(&draft, false, &Silent).err().expect("a refusal");
        words.iter().for_each(|word| assert!(e.message.contains(word), "{}", e.message));
    };
    refused(&["feed.fit_mm=0.004"], &["feed.fit_mm", "at most 0.0020", "verify.gouge_mm"]);
    refused(&["feed.fit_mm=0.001", "feed.smooth=false"], &["feed.fit_mm", "feed.smooth is false"]);
    refused(&["feed.fit_mm=0.5"], &["feed.fit_mm", "0.05"]);
}

/// A finished run on a smooth curve stands for another one whole, or not at all: the path that the
/// curve was made from is not kept.
#[test]
fn a_smooth_run_is_taken_over_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let plan = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
        let model = concat!(env!("CARGO_MANIFEST_DIR"), "/models/turbine_camber.step");
        command.args(["--quiet", "plan", model, "-o"]).arg(folder.path());
        let keys = ["path.scallop_mm=0.1", "region.start_mm=12", "region.end_mm=9", "post.control=[\"siemens-poly\"]"];
        keys.iter().chain(&["verify.surface_samples=20000"]).chain(more).for_each(|key| {
            command.args(["--set", key]);
        });
        let out = command.output().expect("it runs");
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        ["plan.json", "program.poly.mpf"].map(|f| std::fs::read_to_string(folder.path().join(f)).expect("a file"))
    };
    let [straight, _] = plan(&[]);
    assert!(!straight.contains("\"curve\""), "plans without the setting know nothing of it");
    let kinds = ["schedule.kind=optimal", "feed.smooth=true"];
    let [optimal, program] = plan(&kinds);
    assert!(optimal.contains("\"curve\"") && program.contains("PO["));
    let again = plan(&[kinds[0], kinds[1], "verify.surface_samples=60000"]);
    assert!(again[0] == optimal);
    // Another schedule is made on the path, not on the curve: as if there had been no run before.
    let fixed = plan(&["feed.smooth=true", "schedule.kind=piecewise"]);
    std::fs::remove_file(folder.path().join("manifest.json")).expect("it is there");
    assert!(plan(&["feed.smooth=true", "schedule.kind=piecewise"])[0] == fixed[0]);
}

#[test]
fn a_plan_in_memory_stops_when_it_is_asked_to() {
    let window = Window::default();
    window.stop.store(true, Ordering::Relaxed);
    let error = program(Control::Siemens, &window).expect_err("it stops");
    assert_eq!(error.kind, ErrorKind::Cancelled);
}
