//! Files of a finished run changed one by one: `verify RUN` must find each, name the file and the
//! place, and leave a run that nobody touched alone. The plan is made once; each tampering works on
//! a copy of its folder.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use bladewright::artifact::channel::{Binding, ChannelRow};
use bladewright::artifact::{AxisMotion, AxisRows, Plan};
use serde_json::{Value, json};

fn bladewright(args: &[&str], dir: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright")).args(args).current_dir(dir).output().expect("the command starts")
}

fn text(out: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr))
}

/// A folder with the run `good`.
struct Shop {
    dir: tempfile::TempDir,
}

const SMALL: [&str; 6] =
    ["--set", "path.scallop_mm=0.3", "--set", "region.start_mm=30", "--set", "verify.surface_samples=4000"];

impl Shop {
    fn new() -> Self {
        let shop = Shop { dir: tempfile::tempdir().expect("temporary folder") };
        shop.plan("good", &["region.end_mm=24"], &[]);
        shop
    }

    fn plan(&self, name: &str, set: &[&str], more: &[&str]) {
        let model = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models/prism.step").display().to_string();
        let set: Vec<&str> = set.iter().flat_map(|s| ["--set", s]).collect();
        let out =
            bladewright(&[&["--quiet", "plan", &model, "-o", name], &SMALL[..], &set, more].concat(), self.dir.path());
        assert_eq!(out.status.code(), Some(0), "{}", text(&out));
    }

    /// A copy of the good run.
    fn copy(&self, name: &str) -> PathBuf {
        let to = self.dir.path().join(name);
        std::fs::create_dir(&to).expect("a folder");
        for entry in std::fs::read_dir(self.dir.path().join("good")).expect("readable") {
            let entry = entry.expect("an entry");
            std::fs::copy(entry.path(), to.join(entry.file_name())).expect("a copy");
        }
        to
    }

    /// What `verify` says of a folder.
    fn judged(&self, name: &str) -> (Option<i32>, String) {
        let out = bladewright(&["--quiet", "verify", name], self.dir.path());
        (out.status.code(), text(&out))
    }

    /// Each of the findings must be there, with all words of its line.
    fn finds(&self, name: &str, findings: &[(&str, &[&str])]) {
        let (code, said) = self.judged(name);
        assert_eq!(code, Some(1), "{name}: {said}");
        for (finding, words) in findings {
            let named = |l: &&str| l.starts_with(&format!("finding: {finding}:"));
            let lines: Vec<&str> = said.lines().filter(named).collect();
            let fits = |l: &&str| words.iter().all(|w| l.contains(w));
            assert!(lines.iter().any(fits), "{name}: {finding} with {words:?} is not in\n{said}");
        }
    }
}

fn change(file: &Path, by: impl FnOnce(String) -> String) {
    let before = std::fs::read_to_string(file).expect("readable");
    let after = by(before.clone());
    assert!(before != after, "{} is as it was", file.display());
    std::fs::write(file, after).expect("writable");
}

fn change_plan(run: &Path, by: impl FnOnce(&mut Plan)) {
    change(&run.join("plan.json"), |text| {
        let mut plan: Plan = serde_json::from_str(&text).expect("a plan");
        by(&mut plan);
        serde_json::to_string(&plan).expect("JSON")
    });
}

/// One cell of a table, by its row from 0 and its column.
fn change_cell(file: &Path, row: usize, column: &str, by: impl Fn(f64) -> f64) {
    change(file, |text| {
        let mut at = None;
        let mut seen = 0;
        let line = |l: &str| {
            if l.starts_with('#') {
                return l.to_owned();
            }
            let Some(k) = at else {
                at = l.split(',').position(|c| c == column);
                assert!(at.is_some(), "{column} in {l}");
                return l.to_owned();
            };
            seen += 1;
            if seen != row + 1 {
                return l.to_owned();
            }
            let cells = l
                .split(',')
                .enumerate()
                .map(|(i, c)| if i == k { by(c.parse().expect("a number")).to_string() } else { c.to_owned() });
            cells.collect::<Vec<_>>().join(",")
        };
        text.lines().map(line).collect::<Vec<_>>().join("\n") + "\n"
    });
}

/// The manifest as if the run had left its files as they are now: what a forger would do.
fn forge(run: &Path) {
    change(&run.join("manifest.json"), |text| {
        let mut manifest: Value = serde_json::from_str(&text).expect("JSON");
        for (name, hash) in manifest["outputs"].as_object_mut().expect("a map") {
            let content = std::fs::read(run.join(name)).expect("readable");
            *hash = json!(blake3::hash(&content).to_hex().to_string());
        }
        manifest.to_string()
    });
}

fn scale(rows: &mut AxisRows, by: f64) {
    rows.iter_mut().flatten().for_each(|v| *v *= by);
}

/// A run as it was left is good, also after every other verb has written into its folder; and what
/// these wrote is judged too.
#[test]
fn a_run_that_nobody_touched_is_good() {
    let shop = Shop::new();
    shop.copy("1");
    let (code, said) = shop.judged("1");
    assert_eq!(code, Some(0), "{said}");
    let run = bladewright::run::again::read(&shop.dir.path().join("1"), &bladewright::observe::Silent).expect("a run");
    assert!(run.recall(&bladewright::observe::Silent).expect("checked").recalled);
    for check in ["job", "job-region", "plan-channel", "channel-clear", "files", "inputs", "table-axes"] {
        assert!(said.lines().any(|l| l.starts_with(&format!("ok   {check} "))), "{check}: {said}");
    }
    for args in [
        &["post", "1", "--control", "heidenhain"][..],
        &["post", "1", "--control", "fanuc", "--from-turn", "2"],
        &["preview", "1"],
    ] {
        let out = bladewright(args, shop.dir.path());
        assert!(out.status.success(), "{args:?}: {}", text(&out));
        assert!(!text(&out).contains("manifest.json"), "{}", text(&out));
    }
    std::fs::write(shop.dir.path().join("1/notes.txt"), "G1 X5 is the line to look at").expect("writable");
    let (code, said) = shop.judged("1");
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(said.matches("ok   program-missing ").count(), 4, "{said}");
    // A depth of the ball 50 µm too low in what was posted later, and in what goes on with a turn.
    for (file, word) in [("program.h", " Z+"), ("from_turn_2.program.nc", " Z")] {
        change(&shop.dir.path().join("1").join(file), |text| {
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            let cuts = |l: &String| l.contains(" A") && l.contains(word) && l.contains(" X") && l.contains(" F");
            let places: Vec<usize> = (0..lines.len()).filter(|k| cuts(&lines[*k])).collect();
            let k = places[places.len() / 2];
            let at = lines[k].find(word).expect("Z") + word.len();
            let end = at + lines[k][at..].find(' ').expect("more words");
            let z: f64 = lines[k][at..end].parse().expect("a number");
            lines[k].replace_range(at..end, &format!("{:.5}", z - 0.05));
            lines.join("\n") + "\n"
        });
    }
    shop.finds(
        "1",
        &[
            ("program-centre", &["program.h"]),
            ("program-centre", &["from_turn_2.program.nc"]),
            ("files", &["program.h"]),
        ],
    );
}

#[test]
fn a_plan_that_was_changed_is_found() {
    let shop = Shop::new();
    // Everything that the plan holds and the program does not show.
    let run = shop.copy("columns");
    change_plan(&run, |plan| {
        for r in &mut plan.channel.rows {
            (r.theta_min, r.hull_min) = (r.theta_min - 100.0, r.hull_min - 100.0);
            (r.theta_max, r.hull_max) = (r.theta_max + 100.0, r.hull_max + 100.0);
        }
        scale(&mut plan.motion.acceleration, 0.0);
        scale(&mut plan.motion.jerk, 0.0);
        plan.motion.feed.iter_mut().for_each(|v| *v *= 20.0);
        plan.toolpath.turns.clear();
    });
    forge(&run);
    shop.finds(
        "columns",
        &[
            ("plan-channel", &["plan.json, channel row 0", "more than the whole circle"]),
            ("plan-motion", &["plan.json", "acceleration"]),
            ("plan-turns", &["plan.json: turns end at location 0"]),
            ("table-cutter-locations", &["cutter_locations.csv, line ", "column theta_min_deg", "by plan.json"]),
            ("table-axes", &["axes.csv, line ", "column a"]),
        ],
    );
    let run = shop.copy("feed");
    change_plan(&run, |plan| plan.motion.feed.iter_mut().for_each(|v| *v *= 20.0));
    shop.finds("feed", &[("plan-motion", &["plan.json, location 0", "feed"]), ("files", &["plan.json has BLAKE3"])]);

    for (name, by) in [("jerk-none", 0.0), ("jerk-more", 1.5), ("jerk-against", -1.0)] {
        let run = shop.copy(name);
        change_plan(&run, |plan| scale(&mut plan.motion.jerk, by));
        shop.finds(name, &[("plan-motion", &["plan.json: the root mean square", "jerk"])]);
    }

    let run = shop.copy("leads");
    change_plan(&run, |plan| {
        for lead in &mut plan.leads {
            lead.centres.clear();
            lead.theta.clear();
            lead.motion = AxisMotion { time_s: lead.motion.time_s, ..AxisMotion::default() };
            (lead.radius_mm, lead.angle_rad) = (0.0, 0.0);
        }
    });
    forge(&run);
    shop.finds(
        "leads",
        &[("job", &["lead-in is no arc", "feed.lead_radius_mm is 4"]), ("plan-motion", &["velocity of axis"])],
    );

    // One row's wall, half a radian into the part, with all that follows from it, in the table and
    // in the manifest too: only the part tells.
    let run = shop.copy("wall");
    let (mut row, mut theta_deg) = (0, 0.0);
    change_plan(&run, |plan| {
        let rows = &mut plan.channel.rows;
        let by_part = |r: &ChannelRow| matches!(r.binds_max, Binding::Part { .. });
        let places: Vec<usize> = (0..rows.len()).filter(|k| by_part(&rows[*k])).collect();
        row = places.get(places.len() / 2).copied().unwrap_or(rows.len() / 2);
        let max = rows[row].theta_max + 0.5;
        (rows[row].theta_max, theta_deg) = (max, max.to_degrees());
        let mut least = f64::INFINITY;
        for r in rows.iter_mut().rev() {
            least = least.min(r.theta_max);
            r.hull_max = least;
        }
    });
    change_cell(&run.join("cutter_locations.csv"), row, "theta_max_deg", |_| theta_deg);
    forge(&run);
    let (code, said) = shop.judged("wall");
    let place = format!("channel row {row}");
    let found = said.lines().any(|l| {
        (l.starts_with("finding: channel-clear") || l.starts_with("finding: plan-channel")) && l.contains(&place)
    });
    assert!(code == Some(1) && found && !said.contains("finding: files"), "{said}");
}

#[test]
fn tables_and_files_that_were_changed_are_found() {
    let shop = Shop::new();
    let columns = ["turn", "s", "pz", "nx", "iy", "theta_min_deg", "theta_max_deg", "feed_mm_min"];
    let run = shop.copy("cells");
    for (k, column) in columns.into_iter().enumerate() {
        change_cell(&run.join("cutter_locations.csv"), 40 + k, column, |v| 1.5 * v + 1.0);
    }
    for (k, column) in ["X", "vA", "aZ", "jY"].into_iter().enumerate() {
        change_cell(&run.join("axes.csv"), 90 + k, column, |v| 1.5 * v + 1.0);
    }
    std::fs::remove_file(run.join("program.ngc")).expect("removable");
    std::fs::write(run.join("old.tap"), "what is this").expect("writable");
    change(&run.join("sections.json"), |text| text.replacen('1', "2", 1));
    forge_but(&run, &["program.ngc"]);
    shop.finds(
        "cells",
        &[
            ("table-cutter-locations", &["is 8.000000", "line ", "column turn", "by plan.json"]),
            ("table-axes", &["is 4.000000", "axes.csv, line 92, column X: ", "by plan.json"]),
            ("program-absent", &["program.ngc", "the job asks for it"]),
            ("program-readable", &["old.tap"]),
            ("files", &["program.ngc is missing"]),
        ],
    );
    let out = bladewright(&["post", "cells", "--control", "fanuc"], shop.dir.path());
    assert!(out.status.code() == Some(1) && !run.join("program.nc").exists(), "{}", text(&out));

    // A seal of another report is none.
    let run = shop.copy("sealed");
    change(&run.join("verify.json"), |text| text.replacen("\"worst\": 0.0", "\"worst\": 0.000001", 1));
    forge(&run);
    let read = bladewright::run::again::read(&run, &bladewright::observe::Silent).expect("a run");
    assert!(!read.recall(&bladewright::observe::Silent).expect("checked").recalled);

    let run = shop.copy("tables");
    change(&run.join("cutter_locations.csv"), |text| text.replacen("cx,cy,cz", "cy,cx,cz", 1));
    std::fs::remove_file(run.join("axes.csv")).expect("removable");
    change(&run.join("sections.json"), |text| text.replacen('1', "2", 1));
    shop.finds(
        "tables",
        &[
            ("table-cutter-locations", &["the header is `turn,S,s,cy,cx"]),
            ("table-axes", &["axes.csv", "missing"]),
            ("files", &["axes.csv is missing", "sections.json has BLAKE3"]),
        ],
    );
    let run = shop.copy("wider");
    change(&run.join("cutter_locations.csv"), |text| {
        text.lines().map(|l| if l.starts_with('#') { format!("{l}\n") } else { format!("{l},x\n") }).collect()
    });
    shop.finds("wider", &[("table-cutter-locations", &["feed_mm_min,x`, it must be"])]);
}

/// As [`forge`], but for files that are gone.
fn forge_but(run: &Path, gone: &[&str]) {
    for name in gone {
        std::fs::write(run.join(name), "").expect("writable");
    }
    forge(run);
    for name in gone {
        std::fs::remove_file(run.join(name)).expect("removable");
    }
}

/// A plan of another job is a good plan, of other work.
#[test]
fn a_plan_of_another_job_is_found() {
    let shop = Shop::new();
    shop.plan("short", &["region.end_mm=27", "feed.feed_mm_min=3000"], &[]);
    let run = shop.copy("mixed");
    for name in ["plan.json", "cutter_locations.csv", "axes.csv", "program.mpf", "program.ngc"] {
        std::fs::copy(shop.dir.path().join("short").join(name), run.join(name)).expect("a copy");
    }
    forge(&run);
    shop.finds(
        "mixed",
        &[("job-region", &["ends at height 27.000", "region.end_mm is 24"]), ("job-feed", &["at most 2000"])],
    );
    let out = bladewright(&["post", "mixed", "--control", "fanuc"], shop.dir.path());
    assert!(out.status.code() == Some(1) && !run.join("program.nc").exists(), "{}", text(&out));

    // The job changed, the plan not.
    let run = shop.copy("asks");
    change(&run.join("job.resolved.toml"), |text| {
        let text = text.replacen("\nclearance_mm = 0.1\n", "\nclearance_mm = 50.0\n", 1);
        let text = text.replacen("\nholder_clearance_mm = 1.0\n", "\nholder_clearance_mm = 60.0\n", 1);
        text.replacen("\nscallop_mm = 0.3\n", "\nscallop_mm = 0.2\n", 1).replacen(
            "\nb_deg = 5.0\n",
            "\nb_deg = 6.0\n",
            1,
        )
    });
    shop.finds(
        "asks",
        &[
            ("job", &["path.scallop_mm is 0.3 in plan.json, the job asks for 0.2", "machine.b_deg is 5"]),
            ("clearance", &["limit 49.5", "asked for 50"]),
            ("holder-clearance", &["limit 59.4", "asked for 60"]),
            ("lead-clearance", &["asked for 50"]),
            ("files", &["job.resolved.toml has BLAKE3"]),
        ],
    );
}

#[test]
fn what_cannot_be_done_is_said_at_once() {
    let shop = Shop::new();
    shop.plan("stopped", &["region.end_mm=24"], &["--until", "channel"]);
    for args in [&["verify", "stopped"][..], &["post", "stopped", "--control", "fanuc"], &["preview", "stopped"]] {
        let out = bladewright(args, shop.dir.path());
        let said = text(&out);
        assert!(out.status.code() == Some(4) && said.contains("was stopped at channel"), "{said}");
    }
    let out = bladewright(&["post", "good", "--control", "fanuc", "--from-turn", "99"], shop.dir.path());
    let said = text(&out);
    assert!(out.status.code() == Some(2) && said.contains("there is no turn 99, the plan has turns 1 to"), "{said}");
    // A run that ends with its checks has no programs, and none is missing.
    shop.plan("checked", &["region.end_mm=24"], &["--until", "verify"]);
    let (code, said) = shop.judged("checked");
    assert_eq!(code, Some(0), "{said}");
}
