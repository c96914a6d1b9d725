#![allow(clippy::unwrap_used)]
use std::fs;

use super::*;
use crate::error::ErrorKind;

const PROGRAM: &str = "; BLADE  for a control, by bladewright 0.1.0\nM30\n";

fn controls() -> Vec<String> {
    ["program.mpf", "program.nc"].map(String::from).to_vec()
}

fn names(dir: &Path) -> Vec<String> {
    let mut all: Vec<String> =
        fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    all.sort();
    all
}

/// A run of the files given, with its manifest.
fn run(out: &Path, job: &str, files: &[&str]) -> Result<Vec<PathBuf>> {
    let mut folder = RunFolder::begin_run(out, controls())?;
    folder.add_job(job)?;
    for name in files {
        match name.starts_with("program") {
            true => folder.add_program(name, PROGRAM, "siemens")?,
            false => folder.add(name, format!("{name} of {job}"))?,
        }
    }
    let manifest = Manifest {
        schema_version: manifest::SCHEMA_VERSION,
        program: "p".into(),
        build: "b".into(),
        inputs: Vec::new(),
        job: serde_json::json!({ "b": 0.1, "a": { "z": 1, "y": 1e-300 } }),
        stages: Vec::new(),
        warnings: Vec::new(),
        seal: Some("s".into()),
        outputs: folder.hashes().clone(),
        programs: folder.programs().clone(),
        status: "good".into(),
    };
    folder.add_json(manifest::FILE, &manifest)?;
    folder.finish()
}

fn study(out: &Path, job: &str, file: &str) -> Result<Vec<PathBuf>> {
    let mut folder = RunFolder::begin(out)?;
    folder.add_job_of_study(job)?;
    folder.add(file, "x")?;
    folder.finish()
}

fn manifest_of(out: &Path) -> Manifest {
    serde_json::from_str(&fs::read_to_string(out.join(manifest::FILE)).unwrap()).unwrap()
}

/// Every file that the manifest names is there with that content, and is all that there is but for
/// what is `foreign`.
fn is_true(out: &Path, foreign: &[&str]) {
    let told = manifest_of(out).outputs;
    for (name, hash) in &told {
        assert_eq!(*hash, blake3::hash(&fs::read(out.join(name)).unwrap()).to_hex().to_string(), "{name}");
    }
    let known = |n: &String| told.contains_key(n) || n == manifest::FILE || foreign.contains(&n.as_str());
    assert!(names(out).iter().all(known), "{:?}, but told are {:?}", names(out), told.keys());
}

#[test]
fn a_run_takes_the_place_of_the_one_before() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let written = run(&out, "job 1", &["plan.json", "report.html", "program.mpf", "program.tap"]).unwrap();
    assert_eq!(written.last().unwrap(), &out.join(manifest::FILE));
    // The user's own: notes, plots, a program of another workshop under the name of one of ours.
    fs::write(out.join("notes"), "mine").unwrap();
    fs::write(out.join("program.nc"), "G0 X0").unwrap();
    fs::create_dir(out.join("plots")).unwrap();
    let foreign = ["notes", "program.nc", "plots"];
    is_true(&out, &foreign);
    // One that an older version left, which entered it nowhere.
    fs::write(out.join("from_turn_2.program.mpf"), PROGRAM).unwrap();
    run(&out, "job 2", &["sections.json"]).unwrap();
    assert_eq!(names(&out), [JOB, manifest::FILE, "notes", "plots", "program.nc", "sections.json"]);
    is_true(&out, &foreign);
    assert_eq!(names(dir.path()), ["out"]);
}

#[test]
fn a_folder_without_a_run_keeps_all_its_files() {
    let dir = tempfile::tempdir().unwrap();
    for name in ["plan.json", "summary.json", "program.nc"] {
        fs::write(dir.path().join(name), "somebody's").unwrap();
    }
    run(dir.path(), "job", &["sections.json"]).unwrap();
    assert_eq!(names(dir.path()), [JOB, manifest::FILE, "plan.json", "program.nc", "sections.json", "summary.json"]);
}

#[test]
fn what_comes_to_a_run_is_entered_in_its_manifest() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    run(d, "job", &["plan.json", "program.mpf", "verify.json"]).unwrap();
    let before = fs::read_to_string(d.join(manifest::FILE)).unwrap();
    let mut folder = RunFolder::begin(d).unwrap();
    folder.add("verify.json", "again").unwrap();
    folder.add_program("mine.tap", PROGRAM, "mine.toml").unwrap();
    let written = folder.finish().unwrap();
    assert_eq!(written, ["verify.json", "mine.tap"].map(|n| d.join(n)), "the manifest is not what was asked for");
    is_true(d, &[]);
    let mut manifest = manifest_of(d);
    assert_eq!(manifest.programs["mine.tap"], "mine.toml");
    // Nothing else of it has changed, to the byte.
    let told = format!("{}", blake3::hash(b"verify.json of job").to_hex());
    manifest.outputs.insert("verify.json".into(), told);
    manifest.outputs.remove("mine.tap");
    manifest.programs.remove("mine.tap");
    assert_eq!(json(&manifest).unwrap(), before);
}

#[test]
fn a_program_of_another_post_is_not_replaced() {
    let dir = tempfile::tempdir().unwrap();
    run(dir.path(), "job", &["program.mpf"]).unwrap();
    let mut folder = RunFolder::begin(dir.path()).unwrap();
    let e = folder.add_program("program.mpf", PROGRAM, "mine.toml").unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("siemens wrote"), "{e}");
    folder.add_program("program.mpf", PROGRAM, "siemens").unwrap();
    folder.add_program("a.tap", PROGRAM, "mine.toml").unwrap();
    assert!(folder.add_program("a.tap", PROGRAM, "other.toml").is_err());
    // A new run is another matter.
    let mut folder = RunFolder::begin_run(dir.path(), controls()).unwrap();
    folder.add_program("program.mpf", PROGRAM, "mine.toml").unwrap();
}

#[test]
fn studies_stay_beside_the_same_job() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    study(d, "job 1", "compare.json").unwrap();
    study(d, "job 1", "sweep_b.csv").unwrap();
    assert_eq!(names(d), ["compare.json", JOB, "sweep_b.csv"]);
    // Those of another job take their place, and go with a run of another one.
    study(d, "job 2", "sweep_b.csv").unwrap();
    assert_eq!(names(d), [JOB, "sweep_b.csv"]);
    run(d, "job 2", &["plan.json"]).unwrap();
    is_true(d, &[]);
    assert!(d.join("sweep_b.csv").exists());
    let e = study(d, "job 3", "compare.json").unwrap_err();
    assert!(e.kind == ErrorKind::Usage && e.message.contains("a run of another job"), "{e}");
    study(d, "job 2", "compare.json").unwrap();
    is_true(d, &[]);
    run(d, "job 4", &["plan.json"]).unwrap();
    assert_eq!(names(d), [JOB, manifest::FILE, "plan.json"]);
}

#[test]
fn what_is_in_the_way_changes_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let d = dir.path();
    run(d, "job 1", &["plan.json", "program.mpf"]).unwrap();
    let before: Vec<_> = names(d).iter().map(|n| fs::read(d.join(n)).unwrap()).collect();
    fs::create_dir(d.join("summary.json")).unwrap();
    let e = run(d, "job 2", &["plan.json", "summary.json"]).unwrap_err();
    assert!(e.kind == ErrorKind::InputOutput && e.message.contains("summary.json is a folder"), "{e}");
    fs::remove_dir(d.join("summary.json")).unwrap();
    assert_eq!(before, names(d).iter().map(|n| fs::read(d.join(n)).unwrap()).collect::<Vec<_>>());
    fs::write(d.join("file"), "").unwrap();
    assert!(RunFolder::begin(&d.join("file")).is_err_and(|e| e.message.contains("is a file")));
}

#[test]
#[cfg(unix)]
fn the_target_may_be_a_link() {
    let dir = tempfile::tempdir().unwrap();
    let (real, out) = (dir.path().join("real"), dir.path().join("out"));
    fs::create_dir(&real).unwrap();
    std::os::unix::fs::symlink(&real, &out).unwrap();
    run(&out, "job 1", &["plan.json"]).unwrap();
    run(&out, "job 2", &["sections.json"]).unwrap();
    assert_eq!(names(&real), [JOB, manifest::FILE, "sections.json"]);
    fs::remove_dir_all(&real).unwrap();
    assert!(RunFolder::begin(&out).is_err_and(|e| e.message.contains("leads nowhere")));
}

/// Two processes that make the same folder: the second one's run is the one that stays, whole.
#[test]
fn a_folder_that_comes_into_being_meanwhile() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out");
    let mut late = RunFolder::begin_run(&out, controls()).unwrap();
    late.add_job("late").unwrap();
    run(&out, "early", &["plan.json"]).unwrap();
    late.finish().unwrap();
    assert_eq!(names(&out), [JOB]);
    assert_eq!(names(dir.path()), ["out"]);
}
