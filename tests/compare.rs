//! `compare`: schedules and paths of a job side by side, in its table, its files and its figures.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

const PRISM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/prism.step");

fn compare(out: &Path, more: &[&str]) -> Output {
    let out = out.display().to_string();
    let args = ["--quiet", "compare", PRISM, "-o", &out, "--set", "path.scallop_mm=0.4"];
    let region = ["--set", "region.start_mm=30", "--set", "region.end_mm=20"];
    Command::new(env!("CARGO_BIN_EXE_bladewright")).args(args).args(region).args(more).output().expect("it starts")
}

fn number(v: &Value, key: &str) -> f64 {
    v[key].as_f64().unwrap_or_else(|| panic!("{key} is no number in {v}"))
}

fn list<'a>(v: &'a Value, key: &str) -> &'a [Value] {
    v[key].as_array().unwrap_or_else(|| panic!("{key} is no list in {v}"))
}

fn named<'a>(all: &'a [Value], name: &str) -> &'a Value {
    all.iter().find(|v| v["name"] == name).unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn schedules_and_the_smooth_path_stand_side_by_side() {
    let dir = tempfile::tempdir().expect("a folder");
    let out = dir.path().join("out");
    let run = compare(&out, &["--set", "feed.smooth=true"]);
    let table = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect("a file");
    let found: Value = serde_json::from_str(&read("compare.json")).expect("JSON");

    // The published rival turns to and fro, and none of ours does.
    let schedules = list(&found, "schedules");
    assert!(number(named(schedules, "fixed"), "reversals") > 50.0);
    for name in ["piecewise", "optimal", "optimal square-second"] {
        let s = named(schedules, name);
        assert_eq!((number(s, "reversals"), number(s, "outside_deg")), (0.0, 0.0), "{name}");
        // No bound is undercut, and the smoothest is the smoothest.
        assert!(number(s, "second_deg_mm2") >= number(&found, "bound_second_deg_mm2") - 1e-12, "{name}");
        assert!(number(s, "second_deg_mm2") <= number(named(schedules, "fixed"), "second_deg_mm2"), "{name}");
    }

    // No time is under its bound or grows with the limits; `time` takes the least of ours.
    let sweep = list(&found, "sweep");
    assert_eq!(sweep.iter().map(|l| number(l, "scale")).collect::<Vec<_>>(), [0.25, 0.5, 1.0, 2.0, 4.0]);
    for level in sweep {
        let runs = list(level, "runs");
        let times = |name: &str| number(named(runs, name), "time_s");
        assert!(runs.iter().all(|r| number(r, "time_s") >= number(level, "bound_s") * (1.0 - 1e-9)), "{level}");
        for name in ["piecewise", "optimal", "optimal square-second"] {
            assert!(times("time") <= times(name) * (1.0 + 1e-6) && times(name) < times("fixed"), "{name}: {level}");
        }
    }
    for pair in sweep.windows(2) {
        for (slow, fast) in list(&pair[0], "runs").iter().zip(list(&pair[1], "runs")) {
            assert_eq!(slow["name"], fast["name"]);
            assert!(number(fast, "time_s") <= number(slow, "time_s") * 1.001, "{slow} {fast}");
        }
    }

    // The smooth path has fewer blocks and less jerk of all linear axes, and takes no longer.
    let paths = list(&found, "paths");
    let (as_it_is, smooth) = (named(paths, "as it is"), named(paths, "smooth"));
    assert!(number(smooth, "blocks") < 0.7 * number(as_it_is, "blocks"));
    assert!(number(smooth, "time_s") <= 1.002 * number(as_it_is, "time_s"));
    let jerk = |path: &Value, axis: usize| number(&list(path, "jerk")[axis], "jerk");
    for axis in 0..3 {
        assert!(jerk(smooth, axis) < jerk(as_it_is, axis) && jerk(smooth, axis) < jerk(named(paths, "evened"), axis));
    }

    // The table and the other files have the same figures.
    let csv = read("compare.csv");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|l| l.split(',').collect()).collect();
    let times: Vec<f64> = sweep.iter().flat_map(|l| list(l, "runs")).map(|r| number(r, "time_s")).collect();
    assert_eq!(rows.iter().map(|r| r[2].parse::<f64>().expect("a time")).collect::<Vec<_>>(), times);
    for run in list(&sweep[2], "runs") {
        let (name, time) = (run["name"].as_str().expect("a name"), format!("{:.2}", number(run, "time_s")));
        let says = |l: &&str| l.trim_start().starts_with(name) && l.contains(&time);
        assert!(table.lines().any(|l| says(&l)), "{name} {time}: {table}");
    }
    assert!(table.contains("lower bound") && table.contains("evened"), "{table}");
    assert!(read("compare.svg").starts_with("<svg"));

    // Without jerk no run takes longer, and nothing is compared that was not asked for.
    let plain = dir.path().join("plain");
    assert!(compare(&plain, &["--no-jerk"]).status.success());
    let text = std::fs::read_to_string(plain.join("compare.json")).expect("a file");
    let free: Value = serde_json::from_str(&text).expect("JSON");
    assert!(free["paths"].is_null(), "{}", free["paths"]);
    for (with, without) in sweep.iter().zip(list(&free, "sweep")) {
        for run in list(without, "runs") {
            let name = run["name"].as_str().expect("a name");
            assert!(number(run, "time_s") <= number(named(list(with, "runs"), name), "time_s") * 1.001, "{name}");
        }
    }
}

#[test]
fn a_comparison_that_cannot_be_made_leaves_nothing() {
    let dir = tempfile::tempdir().expect("a folder");
    let out = dir.path().join("out");
    let run = compare(&out, &["--set", "tool.radius_mm=400"]);
    let says = String::from_utf8_lossy(&run.stderr);
    assert!(!run.status.success() && says.starts_with("error:"), "{says}");
    assert!(!out.exists() && run.stdout.is_empty(), "{says}");
}
