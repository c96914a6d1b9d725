//! A folder of results holds one run, whole: whatever was in it before, and whatever happens on the
//! way.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn command(args: &[&str], dir: &Path) -> Command {
    let mut c = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    c.args(args).current_dir(dir);
    c
}

/// Runs and expects an exit code; what it printed.
fn ends(args: &[&str], dir: &Path, code: i32) -> String {
    let out: Output = command(args, dir).output().expect("the command starts");
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(code), "{args:?}\n{text}");
    assert!(!text.contains("panicked"), "{text}");
    text
}

/// A coarse run of the prism, seconds in any build.
fn plan<'a>(model: &'a str, out: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    const COARSE: [&str; 8] = [
        "tool.radius_mm=5",
        "region.start_mm=7",
        "region.end_mm=6",
        "path.scallop_mm=0.2",
        "path.chord_mm=0.02",
        "path.max_step_mm=2",
        "verify.surface_samples=1000",
        "verify.scallop_ratio=1000",
    ];
    let coarse = COARSE.iter().flat_map(|set| ["--set", set]);
    ["--quiet", "plan", model, "-o", out].into_iter().chain(coarse).chain(more.iter().copied()).collect()
}

fn model() -> String {
    root().join("models/prism.step").display().to_string()
}

/// Names of everything in a folder, hidden things too.
fn names(dir: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(dir).expect("readable");
    let mut all: Vec<String> = entries.map(|e| e.expect("entry").file_name().to_string_lossy().into_owned()).collect();
    all.sort();
    all
}

fn contents(dir: &Path) -> BTreeMap<String, Vec<u8>> {
    let all = names(dir).into_iter().filter(|n| dir.join(n).is_file());
    all.map(|n| (n.clone(), std::fs::read(dir.join(n)).expect("readable"))).collect()
}

/// The files that the manifest names are those that are there, with the content that it tells; but
/// for the manifest and what is `foreign`.
fn manifest_is_true(dir: &Path, foreign: &[&str]) -> serde_json::Value {
    let files = contents(dir);
    let manifest: serde_json::Value = serde_json::from_slice(&files["manifest.json"]).expect("JSON");
    let told: BTreeMap<&str, &str> = manifest["outputs"]
        .as_object()
        .expect("a table")
        .iter()
        .map(|(name, hash)| (name.as_str(), hash.as_str().expect("a hash")))
        .collect();
    let hashes: BTreeMap<&str, String> = files
        .iter()
        .filter(|(n, _)| *n != "manifest.json" && !foreign.contains(&n.as_str()))
        .map(|(n, content)| (n.as_str(), blake3::hash(content).to_hex().to_string()))
        .collect();
    assert_eq!(told, hashes.iter().map(|(n, h)| (*n, h.as_str())).collect());
    manifest
}

#[test]
fn a_new_run_takes_the_place_of_the_old_one() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    let out = d.join("out");
    ends(&plan(&model, "out", &[]), d, 0);
    manifest_is_true(&out, &[]);
    std::fs::write(out.join("notes.txt"), "mine").expect("writable");
    std::fs::write(out.join("program.nc"), "(another workshop's)\n").expect("writable");
    std::fs::create_dir(out.join("plots")).expect("writable");
    let foreign = ["notes.txt", "program.nc"];

    // What comes to a run later is entered in its manifest.
    ends(&["post", "out", "--control", "heidenhain"], d, 0);
    ends(&["preview", "out"], d, 0);
    // Programs of others in the folder are judged like its own.
    assert!(ends(&["verify", "out"], d, 1).contains("finding: program-end:"));
    let manifest = manifest_is_true(&out, &foreign);
    assert_eq!(manifest["programs"]["program.h"], "heidenhain");

    // A plan that fails its checks has no programs, and none of the old run stays beside it.
    ends(&plan(&model, "out", &["--set", "verify.gouge_mm=0.0000001"]), d, 1);
    let left = names(&out);
    let programs: Vec<&String> = left.iter().filter(|n| n.contains("program")).collect();
    assert_eq!(programs, ["program.nc"], "{left:?}");
    assert!(left.contains(&"plots".to_owned()) && left.contains(&"notes.txt".to_owned()));
    manifest_is_true(&out, &foreign);

    // A run that stops early leaves nothing of a whole one.
    ends(&plan(&model, "out", &["--until", "path"]), d, 0);
    let wanted =
        ["job.resolved.toml", "manifest.json", "notes.txt", "plots", "program.nc", "sections.json", "toolpath.json"];
    assert_eq!(names(&out), wanted);

    // And one that finds no plan leaves all as it is.
    let before = contents(&out);
    ends(&plan(&model, "out", &["--set", "region.start_mm=100000"]), d, 2);
    assert!(before == contents(&out));
    assert_eq!(names(d), ["out"]);
}

#[test]
fn what_another_post_wrote_is_not_replaced() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    let own = std::fs::read_to_string(root().join("models/posts/apt.toml")).expect("a post file");
    std::fs::write(d.join("mine.toml"), &own).expect("writable");
    ends(&plan(&model, "out", &["--set", "post.control=[\"apt\"]"]), d, 0);
    let before = contents(&d.join("out"));
    let text = ends(&["post", "out", "--post-file", "mine.toml"], d, 2);
    assert!(text.contains("holds the program.apt that apt wrote, the one of mine.toml would"), "{text}");
    assert!(before == contents(&d.join("out")));
    // The same control may write it again, an own post file its own, and any into another folder.
    ends(&["post", "out", "--control", "apt"], d, 0);
    ends(&["post", "out", "--post-file", "mine.toml", "-o", "other"], d, 0);
    std::fs::write(d.join("mine.toml"), own.replace("program.apt", "mine.cls")).expect("writable");
    ends(&["post", "out", "--post-file", "mine.toml"], d, 0);
    ends(&["post", "out", "--post-file", "mine.toml"], d, 0);
    manifest_is_true(&d.join("out"), &[]);
    // Two programs of one run in one file.
    std::fs::write(d.join("mine.toml"), &own).expect("writable");
    let file = format!("post.files=[\"{}\"]", d.join("mine.toml").display());
    let both = ["--set", "post.control=[\"apt\"]", "--set", file.as_str()];
    let text = ends(&plan(&model, "both", &both), d, 2);
    assert!(text.contains("apt and mine.toml would both write program.apt"), "{text}");
}

#[test]
fn a_folder_in_the_way_changes_nothing() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    ends(&plan(&model, "out", &["--set", "post.control=[\"linuxcnc\"]"]), d, 0);
    std::fs::create_dir(d.join("out/program.mpf")).expect("writable");
    std::fs::write(d.join("out/program.mpf/mine"), "x").expect("writable");
    let before = contents(&d.join("out"));
    let text = ends(&plan(&model, "out", &["--set", "tool.radius_mm=4"]), d, 4);
    assert!(text.contains("program.mpf is a folder"), "{text}");
    assert!(before == contents(&d.join("out")) && d.join("out/program.mpf/mine").is_file());
    assert!(!names(&d.join("out")).iter().any(|n| n.starts_with('.')));
}

#[test]
#[cfg(unix)]
fn a_run_into_a_linked_folder() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    std::fs::create_dir(d.join("real")).expect("writable");
    std::os::unix::fs::symlink("real", d.join("out")).expect("a link");
    std::os::unix::fs::symlink("nowhere", d.join("lost")).expect("a link");
    for _ in 0..2 {
        ends(&plan(&model, "out", &["--until", "section"]), d, 0);
        assert_eq!(names(&d.join("real")), ["job.resolved.toml", "manifest.json", "sections.json"]);
    }
    assert!(d.join("out").is_symlink());
    let text = ends(&plan(&model, "lost", &["--until", "section"]), d, 4);
    assert!(text.contains("a link that leads nowhere"), "{text}");
}

#[test]
fn studies_stay_beside_a_run_of_the_same_job_only() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    let channel = |more: &[&'static str]| {
        let all = plan(&model, "out", more).into_iter().map(|a| if a == "plan" { "channel" } else { a }.to_owned());
        all.collect::<Vec<String>>()
    };
    let study = |more: &[&'static str], code: i32| {
        let args = channel(more);
        ends(&args.iter().map(String::as_str).collect::<Vec<_>>(), d, code)
    };
    study(&[], 0);
    assert!(d.join("out/channel_intervals.csv").is_file());
    ends(&plan(&model, "out", &["--until", "schedule"]), d, 0);
    assert!(d.join("out/channel_intervals.csv").is_file());
    manifest_is_true(&d.join("out"), &[]);
    study(&[], 0);
    manifest_is_true(&d.join("out"), &[]);
    let text = study(&["--set", "machine.b_deg=6"], 2);
    assert!(text.contains("holds a run of another job"), "{text}");
    ends(&plan(&model, "out", &["--until", "path", "--set", "path.scallop_mm=0.3"]), d, 0);
    assert!(!d.join("out/channel_intervals.csv").exists());
}

/// What killed runs leave goes with the next one, wherever they were.
#[test]
fn killed_runs_leave_nothing_for_ever() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), model());
    let hidden = |at: &Path| names(at).into_iter().filter(|n| n.starts_with(".bladewright-")).count();
    for out in ["out", "old"] {
        if out == "old" {
            std::fs::create_dir(d.join("old")).expect("writable");
        }
        let at = if out == "old" { d.join("old") } else { d.to_path_buf() };
        for _ in 0..3 {
            let mut child = command(&plan(&model, out, &[]), d)
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .expect("the command starts");
            while hidden(&at) == 0 {
                assert!(child.try_wait().expect("a child").is_none(), "it ended too early");
                std::thread::sleep(std::time::Duration::from_millis(2));
            }
            child.kill().expect("it can be killed");
            child.wait().expect("it ends");
        }
        assert!(hidden(&at) <= 1);
        ends(&plan(&model, out, &["--until", "section"]), d, 0);
        assert_eq!((hidden(&at), names(&d.join(out)).len()), (0, 3));
    }
}
