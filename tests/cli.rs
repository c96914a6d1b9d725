//! The command as a user meets it: bad input, exit codes, nothing left behind, the same bytes on
//! any number of threads.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn bladewright(args: &[&str], dir: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright")).args(args).current_dir(dir).output().expect("the command starts")
}

/// Runs and checks: exit code, every word in the message, one sentence for the error, nothing left
/// behind.
fn fails(args: &[&str], dir: &Path, code: i32, words: &[&str]) {
    let before = listing(dir);
    let out = bladewright(args, dir);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(code), "{args:?}\n{text}");
    assert!(text.contains("error: ") && !text.contains("panicked"), "{args:?}\n{text}");
    for word in words {
        assert!(
            text.to_lowercase().contains(&word.to_lowercase()),
            "`{word}` is not in the message of {args:?}:\n{text}"
        );
    }
    assert_eq!(before, listing(dir), "{args:?} left something behind");
}

fn listing(dir: &Path) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = std::fs::read_dir(dir).expect("readable").map(|e| e.expect("entry").path()).collect();
    all.sort();
    all
}

fn write(dir: &Path, name: &str, content: &[u8]) {
    std::fs::write(dir.join(name), content).expect("writable");
}

/// A closed cube of the given side as ASCII STL.
fn cube_stl(side: f64, faces: usize) -> String {
    let p = |i: usize| [i & 1, (i >> 1) & 1, (i >> 2) & 1].map(|b| b as f64 * side);
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut text = String::from("solid cube\n");
    for q in quads.iter().take(faces) {
        for t in [[q[0], q[1], q[2]], [q[0], q[2], q[3]]] {
            text += " facet normal 0 0 0\n  outer loop\n";
            for i in t {
                let [x, y, z] = p(i);
                text += &format!("   vertex {x} {y} {z}\n");
            }
            text += "  endloop\n endfacet\n";
        }
    }
    text + "endsolid cube\n"
}

#[test]
fn bad_models_are_named() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    write(d, "empty.step", b"");
    write(d, "text.step", b"this is no STEP file, only a text that says so\n");
    write(
        d,
        "nothing.step",
        b"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('n','2026-01-01T00:00:00',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n",
    );
    let mut short = vec![0u8; 84];
    short[80] = 200;
    short.extend([0u8; 50 * 20]);
    write(d, "short.stl", &short);
    write(d, "open.stl", cube_stl(40.0, 5).as_bytes());
    write(d, "nan.stl", cube_stl(40.0, 6).replacen("40", "nan", 1).as_bytes());
    write(d, "small.stl", cube_stl(5.0, 6).as_bytes());
    for (model, words) in [
        ("missing.step", vec!["missing.step"]),
        ("empty.step", vec!["empty"]),
        ("text.step", vec!["text.step"]),
        ("nothing.step", vec!["nothing.step"]),
        ("short.stl", vec!["short.stl"]),
        ("nan.stl", vec!["nan.stl"]),
    ] {
        fails(&["plan", model, "-o", "out"], d, 4, &words);
        fails(&["inspect", model], d, 4, &words);
    }
    // An open part can be looked at, and is refused where the tool would meet the opening.
    let refused = ["not closed where the tool works", "1 opening", "in the model"];
    fails(&["plan", "open.stl", "--axis", "z", "-o", "out"], d, 4, &refused);
    let out = bladewright(&["inspect", "open.stl"], d);
    let text = String::from_utf8_lossy(&out.stdout);
    assert_eq!(out.status.code(), Some(0));
    assert!(text.contains("4 open edges in 1 opening") && text.contains("160.000 mm long"), "{text}");
    fails(&["plan", "small.stl", "--axis", "z", "--set", "tool.radius_mm=8", "-o", "out"], d, 3, &["smaller than"]);
    write(d, "cube.stl", cube_stl(10.0, 6).as_bytes());
    let none = ["no blade was recognised", "no section looks like an airfoil", "--axis"];
    fails(&["plan", "cube.stl", "--unit", "mm", "-o", "out"], d, 3, &none);
}

#[test]
fn bad_options_are_named() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let model = root().join("models/prism.step").display().to_string();
    for (assignment, words) in [
        ("path.scallop_mm=0", vec!["path.scallop_mm", "greater than 0"]),
        ("path.scallop_mm=-1", vec!["path.scallop_mm", "greater than 0"]),
        ("tool.radius_mm=0", vec!["tool.radius_mm", "greater than 0"]),
        ("tool.radius_mm=-2", vec!["tool.radius_mm", "greater than 0"]),
        ("path.scalop_mm=0.01", vec!["scalop_mm"]),
        ("region.start_mm=100000", vec!["region.start_mm", "outside"]),
    ] {
        fails(&["plan", &model, "--set", assignment, "-o", "out"], d, 2, &words);
    }
    write(d, "job.toml", format!("[model]\nfile = {model:?}\n[tool]\nradius = 3\n").as_bytes());
    fails(&["plan", "job.toml", "-o", "out"], d, 2, &["job.toml", "radius", "line"]);
    let design = root().join("models/prism.toml").display().to_string();
    fails(&["plan", &design, "-o", "out"], d, 2, &["is the design of a blade for `make`", "bladewright make"]);
    fails(&["plan", &model, "--threads", "0", "-o", "out"], d, 2, &["threads"]);
    fails(&["verify", "nowhere"], d, 4, &["nowhere"]);
    write(d, "file", b"in the way");
    fails(&["plan", &model, "-o", "file"], d, 4, &["file"]);
    // /proc is a folder that cannot be written.
    if Path::new("/proc/self").is_dir() {
        fails(&["plan", &model, "-o", "/proc/bladewright-out"], d, 4, &["/proc"]);
    }
}

/// Runs a shell that ends with the command, so that limits and signals can be set before.
#[cfg(target_os = "linux")]
fn shell(script: &str, dir: &Path) -> Output {
    Command::new("sh")
        .args(["-c", script])
        .env("BLADEWRIGHT", env!("CARGO_BIN_EXE_bladewright"))
        .env("MODEL", root().join("models/prism.step"))
        .current_dir(dir)
        .output()
        .expect("sh starts")
}

/// What a full disk says: that it is full, with exit code 4, and nothing half-written left. Here as
/// a limit on the size of files, which any user may set.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_leaves_nothing_behind() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    // 8 blocks of 512 bytes hold job.resolved.toml, not sections.json; without the trap the signal
    // would end the program.
    let limited = |out: &str| shell(&format!("trap '' XFSZ; ulimit -f 8; exec {SECTIONS} -o {out}"), d);
    std::fs::create_dir(d.join("old")).expect("writable");
    write(&d.join("old"), "sections.json", b"from before");
    let before = listing(d);
    for out in ["new", "old"] {
        let run = limited(out);
        let text = String::from_utf8_lossy(&run.stderr).into_owned();
        assert_eq!(run.status.code(), Some(4), "{text}");
        assert!(
            text.contains("cannot write") && text.contains("sections.json") && text.contains("disk has room"),
            "{text}"
        );
        assert_eq!(before, listing(d), "something was left behind");
        assert_eq!(listing(&d.join("old")), [d.join("old/sections.json")], "something was left behind");
        assert_eq!(std::fs::read(d.join("old/sections.json")).expect("readable"), b"from before");
    }
    let glb = shell("trap '' XFSZ; ulimit -f 8; exec \"$BLADEWRIGHT\" --quiet inspect \"$MODEL\" --glb part.glb", d);
    assert_eq!(glb.status.code(), Some(4), "{}", String::from_utf8_lossy(&glb.stderr));
    assert!(String::from_utf8_lossy(&glb.stderr).contains("part.glb"));
    assert_eq!(before, listing(d), "something was left behind");
}

/// Plans the prism as far as its sections.
#[cfg(target_os = "linux")]
const SECTIONS: &str = "\"$BLADEWRIGHT\" --quiet plan \"$MODEL\" --set region.start_mm=7 --until section";

/// The same on a disk of 24 kB in a name space of its own.
#[test]
#[ignore = "needs a disk of its own: a system that lets users make name spaces (unshare -rm)"]
#[cfg(target_os = "linux")]
fn a_small_disk_that_is_full_is_left_empty() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let mount = "mkdir disk && mount -t tmpfs -o size=24k none disk";
    let real = shell(
        &format!(
            "unshare -rm sh -c '{mount} && {{ {SECTIONS} -o disk/out; code=$?; ls -A disk; exit $code; }} || exit $?'"
        ),
        d,
    );
    let (text, left) = (String::from_utf8_lossy(&real.stderr), String::from_utf8_lossy(&real.stdout));
    assert_eq!(real.status.code(), Some(4), "a disk of its own, and a plan on it: {text}");
    assert!(text.contains("No space left"), "{text}");
    assert_eq!(left.trim(), "", "left on the full disk");
}

/// Standard output that cannot be written is an error, and a reader that goes away early is none.
#[test]
#[cfg(target_os = "linux")]
fn standard_output_may_be_full_or_closed() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let full = shell("exec \"$BLADEWRIGHT\" --quiet inspect \"$MODEL\" > /dev/full", dir.path());
    let text = String::from_utf8_lossy(&full.stderr);
    assert_eq!(full.status.code(), Some(4), "{text}");
    assert!(text.contains("standard output cannot be written") && !text.contains("panicked"), "{text}");
    let closed = shell("{ \"$BLADEWRIGHT\" --quiet inspect \"$MODEL\"; echo $? >&2; } | true", dir.path());
    assert_eq!(String::from_utf8_lossy(&closed.stderr).trim(), "0");
}

/// Every file of a run but manifest.json, which holds times and memory.
fn contents(out: &Path) -> Vec<(String, Vec<u8>)> {
    listing(out)
        .iter()
        .map(|p| (p.file_name().expect("name").to_string_lossy().into_owned(), std::fs::read(p).expect("readable")))
        .filter(|(name, _)| name != "manifest.json")
        .collect()
}

#[test]
fn plan_verify_post_and_preview_of_the_prism() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let model = root().join("models/prism.step").display().to_string();
    for threads in ["1", "2"] {
        // Fewer samples and longer chords than a user's: every command below reads and checks the
        // plan again.
        let sets = ["region.start_mm=5", "path.scallop_mm=0.1", "path.chord_mm=0.002", "verify.surface_samples=20000"];
        let keys = sets.map(|s| ["--set", s]).concat();
        let out = bladewright(&[&["--threads", threads, "plan", &model, "-o", threads], &keys[..]].concat(), d);
        assert_eq!(
            out.status.code(),
            Some(0),
            "{}{}",
            String::from_utf8_lossy(&out.stderr),
            String::from_utf8_lossy(&out.stdout)
        );
        // Nobody asked for the baseline that the summary compares with.
        assert!(!String::from_utf8_lossy(&out.stderr).contains("fixed"), "{}", String::from_utf8_lossy(&out.stderr));
    }
    let (one, two) = (contents(&d.join("1")), contents(&d.join("2")));
    let names: Vec<&str> = one.iter().map(|(n, _)| n.as_str()).collect();
    for file in [
        "axes.csv",
        "cutter_locations.csv",
        "job.resolved.toml",
        "preview.glb",
        "program.mpf",
        "program.ngc",
        "report.html",
        "sections.json",
        "summary.json",
        "verify.json",
    ] {
        assert!(names.contains(&file), "{file} is missing in {names:?}");
    }
    assert_eq!(names, two.iter().map(|(n, _)| n.as_str()).collect::<Vec<_>>());
    for ((name, a), (_, b)) in one.iter().zip(&two) {
        assert!(a == b, "{name} differs between 1 and 2 threads");
    }
    // The resolved job gives the same plan again.
    figures_are_those_of_the_files(&d.join("1"));
    let out = bladewright(&["plot", "1", "--turn", "1", "--width", "400"], d);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    for file in ["channel-turn-1.svg", "channel-turn-1.png", "axis-a-turn-1.png", "scallop-map.svg", "section.png"] {
        assert!(d.join("1/plots").join(file).is_file(), "{file}");
    }
    std::fs::remove_dir_all(d.join("1/plots")).expect("removable");
    fails(&["plot", "1", "--turn", "0"], d, 2, &["there is no turn 0, the plan has turns 1 to"]);
    let again = bladewright(&["plan", "1/job.resolved.toml", "-o", "again"], d);
    assert_eq!(again.status.code(), Some(0), "{}", String::from_utf8_lossy(&again.stderr));
    let csv = |out: &str| std::fs::read(d.join(out).join("cutter_locations.csv")).expect("readable");
    assert!(csv("1") == csv("again"), "job.resolved.toml does not give the same cutter locations");
    // Pages made anew name the figures of the files, also after these have been judged.
    for args in [&["preview", "1"][..], &["verify", "1"], &["preview", "1"], &["post", "1", "--control", "siemens"]] {
        let out = bladewright(args, d);
        assert_eq!(out.status.code(), Some(0), "{args:?}: {}", String::from_utf8_lossy(&out.stderr));
        if args[0] == "preview" {
            figures_are_those_of_the_files(&d.join("1"));
        }
    }
    // Programs are the same again: verify, preview and post work on the very plan that was written.
    for (name, before) in one.iter().filter(|(n, _)| n.starts_with("program") || n.ends_with(".csv")) {
        let after = std::fs::read(d.join("1").join(name)).expect("readable");
        assert!(*before == after, "verify, preview or post changed {name}");
    }
    // And the same checks stand in verify.json, those of the programs among them.
    let checks = |bytes: &[u8]| -> Vec<(String, bool)> {
        let report: serde_json::Value = serde_json::from_slice(bytes).expect("JSON");
        let all = report["checks"].as_array().expect("a list");
        all.iter().map(|c| (c["name"].to_string(), c["passed"] == true)).collect()
    };
    let before = one.iter().find(|(n, _)| n == "verify.json").map(|(_, bytes)| checks(bytes)).expect("verify.json");
    assert!(before.iter().filter(|(n, _)| n.contains("program-")).count() >= 10, "{before:?}");
    // What only a folder has to be judged by comes in with `verify`, and is good.
    let mut after = checks(&std::fs::read(d.join("1/verify.json")).expect("readable"));
    let of_files = ["\"files\"", "\"inputs\"", "\"table-cutter-locations\"", "\"table-axes\""];
    assert!(of_files.iter().all(|name| after.iter().any(|(n, passed)| n == name && *passed)), "{after:?}");
    after.retain(|(n, _)| !of_files.contains(&n.as_str()));
    assert_eq!(before, after);
    planted_faults_of_a_program_are_found(d);
    programs_are_checked_by_themselves(d, &model);
    planted_gouge_is_found(d);
}

/// `verify PROGRAM`: clean, with a fault, and with bad input.
fn programs_are_checked_by_themselves(d: &Path, model: &str) {
    let with = |program: &str, more: &[&str]| {
        let args = ["verify", program, "--part", model, "--tool", "1/job.resolved.toml", "--scallop", "0.1"];
        bladewright(&[&args[..], more].concat(), d)
    };
    for program in ["1/program.mpf", "1/program.ngc"] {
        let out = with(program, &["--report", "findings.json", "--map", "map.glb", "--map-tolerance", "0.02"]);
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        assert_eq!(out.status.code(), Some(0), "{text}{}", String::from_utf8_lossy(&out.stderr));
        assert!(text.contains("ok   rapid") && text.contains("ok   scallop-turn"), "{text}");
        let report = std::fs::read_to_string(d.join("findings.json")).expect("a report");
        assert!(report.contains("\"name\": \"gouge\"") && report.contains("\"block\": \""), "{report}");
        assert!(std::fs::read(d.join("map.glb")).expect("a map").starts_with(b"glTF"));
        for file in ["findings.json", "map.glb"] {
            std::fs::remove_file(d.join(file)).expect("removable");
        }
    }
    let text = std::fs::read_to_string(d.join("1/program.ngc")).expect("readable");
    // With the mark that some editors put at the top.
    write(d, "theirs.ngc", format!("\u{feff}{}", text.replace("Z630.00000", "Z630.01000")).as_bytes());
    let out = with("theirs.ngc", &[]);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(1), "{said}");
    assert!(
        said.contains("finding: z-travel") && said.contains("0.010000 mm") && said.contains("`G53 G0 Z630.01000`"),
        "{said}"
    );
    runs_are_joined(d, model);
    write(d, "arc.nc", b"G94 G1 X1 Y1 Z1 F5\nG2 X4 I1\n");
    write(d, "letter.txt", b"Dear sir,\nplease mill this.\n");
    write(d, "tool.toml", b"radius_mm = 3\n");
    let tool = "1/job.resolved.toml";
    fails(
        &["verify", "arc.nc", "--part", model, "--tool", tool],
        d,
        2,
        &["line 2", "the arc begins 1.0000 mm from its centre"],
    );
    fails(&["verify", "letter.txt", "--part", model, "--tool", tool], d, 2, &["letter.txt", "does not look like"]);
    fails(&["verify", "none.nc", "--part", model, "--tool", tool], d, 4, &["none.nc"]);
    fails(&["verify", "arc.nc", "--part", model, "--tool", "tool.toml"], d, 2, &["tool.toml", "is missing"]);
    fails(&["verify", "arc.nc", "--part", "no.step", "--tool", tool], d, 4, &["no.step"]);
    fails(&["verify", "arc.nc"], d, 2, &["--part"]);
    for file in ["theirs.ngc", "arc.nc", "letter.txt", "tool.toml"] {
        std::fs::remove_file(d.join(file)).expect("removable");
    }
}

/// Two runs of a part as operations of one program: written, read back, judged by themselves; what
/// cannot be is named.
fn runs_are_joined(d: &Path, model: &str) {
    let two = ["post", "1", "1", "--control", "siemens", "-o", "joined"];
    let out = bladewright(&two, d);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let text = std::fs::read_to_string(d.join("joined/program.mpf")).expect("readable");
    assert!(text.contains("Operation 1 of 2") && text.contains("Operation 2 of 2") && text.matches("M30").count() == 1);
    let tool = "1/job.resolved.toml";
    let judged = ["verify", "joined/program.mpf", "--part", model, "--tool", tool, "--tool", tool, "--scallop", "0.1"];
    let out = bladewright(&[&judged[..], &["--map", "joined/both.csv", "--map-tolerance", "0.02"]].concat(), d);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(0), "{said}");
    assert!(said.contains("operation  2 of 2") && said.matches("ok   rapid").count() == 2, "{said}");
    let table = std::fs::read_to_string(d.join("joined/both.csv")).expect("the map of what both leave");
    assert!(table.lines().count() > 1000);
    let out = bladewright(&[&two[..], &["--from-operation", "2", "--from-turn", "2"]].concat(), d);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    // What goes on within a path comes onto it on an arc of its own, at the feed.
    let rest = std::fs::read_to_string(d.join("joined/from_operation_2.from_turn_2.program.mpf")).expect("readable");
    assert!(rest.contains("GOES ON with turn 2") && rest.contains("Lead-in  arc of radius"), "{rest}");
    let lead = rest.find("; Lead-in\n").expect("lines of the lead-in");
    assert!(rest[lead..].find("; Turn 2 of").is_some_and(|k| rest[lead..lead + k].matches("G1 X").count() > 10));
    fails(&["post", "1", "1", "--control", "iso"], d, 2, &["several runs", "-o"]);
    fails(&[&two[..], &["--from-operation", "3"]].concat(), d, 2, &["operations 1 to 2"]);
    let third = [&judged[..], &["--tool", tool]].concat();
    fails(&third, d, 2, &["calls a tool 2 times, 3 tools"]);
    std::fs::remove_dir_all(d.join("joined")).expect("removable");
}

/// A program that was changed or damaged since is found by `verify`, which reads it from its file.
fn planted_faults_of_a_program_are_found(d: &Path) {
    let path = d.join("1/program.mpf");
    let text = std::fs::read_to_string(&path).expect("readable");
    let lines: Vec<&str> = text.lines().collect();
    let k = lines.len() / 2;
    let without = [&lines[..k], &lines[k + 1..]].concat().join("\n");
    let damaged = [&lines[..k], &["G1 X?"], &lines[k + 1..]].concat().join("\n");
    for (damaged, finding) in [(without, "finding: program-missing"), (damaged, "finding: program-readable")] {
        std::fs::write(&path, damaged).expect("writable");
        let out = bladewright(&["verify", "1"], d);
        let said = String::from_utf8_lossy(&out.stdout).into_owned();
        assert!(out.status.code() == Some(1) && said.contains(finding), "{finding}: {said}");
    }
    std::fs::write(&path, text).expect("writable");
}

/// A ball centre moved 20 µm into the part is found by `verify`, named, and not posted.
fn planted_gouge_is_found(d: &Path) {
    let path = d.join("1/cutter_locations.csv");
    let text = std::fs::read_to_string(&path).expect("readable");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let k = lines.len() / 2;
    let mut v: Vec<f64> = lines[k].split(',').map(|x| x.parse().expect("number")).collect();
    for i in 0..3 {
        v[3 + i] -= 0.02 * v[9 + i];
    }
    lines[k] = v.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
    std::fs::write(&path, lines.join("\n") + "\n").expect("writable");
    let out = bladewright(&["verify", "1"], d);
    assert_eq!(out.status.code(), Some(1));
    assert!(
        String::from_utf8_lossy(&out.stdout).contains("finding: gouge"),
        "{}",
        String::from_utf8_lossy(&out.stdout)
    );
    let out = bladewright(&["post", "1", "--control", "linuxcnc"], d);
    assert_eq!(out.status.code(), Some(1), "a plan with a gouge was posted");
}

/// A file of the folder that holds JSON.
fn json_file(out: &Path, name: &str) -> serde_json::Value {
    let text = std::fs::read_to_string(out.join(format!("{name}.json"))).expect("readable");
    serde_json::from_str(&text).expect("JSON")
}

/// Every figure that the report shows is that of one of these files, to the last digit shown; how
/// many there are.
pub fn figures_are_those_of(out: &Path, names: &[&str]) -> usize {
    let page = std::fs::read_to_string(out.join("report.html")).expect("readable");
    let files: Vec<_> = names.iter().map(|name| (*name, json_file(out, name))).collect();
    let mut count = 0;
    for part in page.split("data-figure=\"").skip(1) {
        let Some((from, rest)) = part.split_once("\">") else { continue };
        let Some((shown, _)) = rest.split_once("</span>") else { continue };
        let Some((name, pointer)) = from.split_once('/') else { continue };
        // The page's own script has such words too.
        let Some((_, json)) = files.iter().find(|(known, _)| *known == name) else { continue };
        let value = json.pointer(&format!("/{pointer}")).and_then(serde_json::Value::as_f64).expect(from);
        let number: f64 = shown.parse().expect(from);
        let (digits, power) = shown.split_once('e').unwrap_or((shown, "0"));
        let decimals = digits.split_once('.').map_or(0, |(_, d)| d.len() as i32);
        let unit = 10f64.powi(power.parse::<i32>().expect(from) - decimals);
        assert!((number - value).abs() <= 0.500_001 * unit.max(value.abs() * 5e-4), "{from}: {shown}, {value}");
        count += 1;
    }
    count
}

fn figures_are_those_of_the_files(out: &Path) {
    let count = figures_are_those_of(out, &["summary", "verify"]);
    let verify = json_file(out, "verify");
    let checks = verify["checks"].as_array().map_or(0, Vec::len);
    assert!(count > 60 + 2 * checks, "{count} figures");
    assert!(verify["checks"].as_array().is_some_and(|c| c.iter().any(|c| c["name"] == "program-centre")));
}

#[test]
fn what_helps_to_type_the_command() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let out = bladewright(&["completions", "bash"], dir.path());
    let text = String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success() && text.contains("preview-budget") && text.contains("completions"));
    let out = bladewright(&["--json", "man", "-o", "man"], dir.path());
    assert!(out.status.success());
    let page = std::fs::read_to_string(dir.path().join("man/bladewright-plan.1")).expect("a page");
    assert!(page.contains("preview") && page.contains("Examples"));
    // Standard output is JSON lines, the last with the exit code.
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let lines: Vec<serde_json::Value> = text.lines().map(|l| serde_json::from_str(l).expect(l)).collect();
    assert!(lines.iter().any(|l| l["event"] == "output" && l["text"] == "man/bladewright.1"), "{text}");
    assert_eq!(lines.last().map(|l| l["exit_code"].clone()), Some(0.into()));
    // What stands in the way of a plan is told as data, too.
    let model = root().join("models/prism.step").display().to_string();
    let lean =
        ["--set", "machine.b_deg=60", "--set", "region.start_mm=30", "--set", "region.end_mm=28", "--until", "channel"];
    let holder = ["--set", "tool.stickout_mm=8", "--set", "path.scallop_mm=0.2"];
    let args: Vec<&str> = ["--json", "plan", &model, "-o", "closed"].into_iter().chain(lean).chain(holder).collect();
    let out = bladewright(&args, dir.path());
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let error =
        text.lines().filter_map(|l| serde_json::from_str::<serde_json::Value>(l).ok()).find(|l| l["event"] == "error");
    let error = error.expect(&text);
    assert_eq!((out.status.code(), &error["infeasible"]["what"]), (Some(3), &"no-free-angle".into()), "{text}");
    assert!(error["infeasible"]["at"]["turn"].is_u64() && error["infeasible"]["bounds"][0]["by"].is_string(), "{text}");
    let out = bladewright(&["--json", "verify", "nowhere"], dir.path());
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(text.contains("\"event\":\"error\"") && text.contains("\"exit_code\":4"), "{text}");
}

/// The regions of a model, for other programs.
#[test]
fn inspect_lists_regions_as_data() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let regions = |file: &str| {
        let model = root().join("models").join(file).display().to_string();
        let out = bladewright(&["--json", "inspect", &model], dir.path());
        let text = String::from_utf8_lossy(&out.stdout).into_owned();
        let lines: Vec<serde_json::Value> = text.lines().map(|l| serde_json::from_str(l).expect(l)).collect();
        let told = lines.iter().find(|l| l["event"] == "regions").unwrap_or_else(|| panic!("{text}"));
        told["regions"].as_array().expect("a list").clone()
    };
    for file in ["turbine_camber.step", "turbine_camber.obj"] {
        let list = regions(file);
        let names: Vec<_> = list.iter().filter_map(|r| r["name"].as_str()).collect();
        assert!(names.starts_with(&["airfoil"]) && names.contains(&"platform"), "{names:?}");
        let airfoil = &list[0];
        assert_eq!(airfoil["along"], serde_json::json!([1.0, 0.0, 0.0]));
        let [end, start] = [0, 1].map(|k| airfoil["heights_mm"][k].as_f64().expect("a height"));
        assert!(end < start && airfoil["start"]["height"] == start && airfoil["end"]["height"] == end, "{airfoil}");
        let sides: Vec<_> = airfoil["sides"].as_array().expect("sides").iter().filter_map(|s| s.as_str()).collect();
        assert!(sides.len() == 4 && sides[0] == "leading-edge" && sides.contains(&"suction-side"), "{sides:?}");
        let faces = airfoil["faces"].as_array();
        assert!(faces.is_some_and(|f| !f.is_empty()) == file.ends_with("step"), "{airfoil}");
    }
}

/// Why there is no plan of a model or job, as `--json` tells it; nothing is written.
fn no_plan(sets: &[&str], model: &str, dir: &Path) -> serde_json::Value {
    let sets = sets.iter().flat_map(|s| ["--set", s]);
    let args: Vec<&str> = ["--json", "plan", model, "-o", "none"].into_iter().chain(sets).collect();
    let out = bladewright(&args, dir);
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let lines = text.lines().filter_map(|l| serde_json::from_str::<serde_json::Value>(l).ok());
    let error = lines.into_iter().find(|l| l["event"] == "error").expect(&text);
    assert_eq!(out.status.code(), Some(3), "{text}");
    assert!(!dir.join("none").exists(), "{error}: something was written");
    error["infeasible"].clone()
}

/// Planted reasons for no plan, as `--json` tells them.
#[test]
fn what_leaves_no_plan_is_told_as_data() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let model = root().join("models/prism.step").display().to_string();
    let told = |sets: &[&str]| no_plan(sets, &model, dir.path());
    let small = told(&["tool.radius_mm=500"]);
    assert_eq!((&small["what"], &small["size_mm"][0]), (&"part-smaller-than-tool".into(), &130.0.into()));
    let large = told(&["tool.radius_mm=60"]);
    assert_eq!((&large["what"], &large["by"]), (&"not-one-turn".into(), &"ball-too-large".into()));
    let height_mm = large["at"]["point_mm"][2].as_f64().expect("a point");
    assert!(large["at"]["frame"] == "model" && (height_mm - 40.0).abs() < 1e-3, "{large}");
    assert_eq!(large["radius_mm"], 60.0);
}

/// More of them, planted in machine, tool, fixture and schedule; the data name the place or the
/// figure.
#[test]
fn limits_of_machine_and_channel_are_told_as_data() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let models = root().join("models");
    let machine = |name: &str, from: &str, to: &str| {
        let text = std::fs::read_to_string(models.join("machines").join(name)).expect("readable");
        assert!(text.contains(from), "{name} has no {from}");
        write(dir.path(), &format!("its_{name}"), text.replace(from, to).as_bytes());
        format!("machine.file=\"{}\"", dir.path().join(format!("its_{name}")).display())
    };
    let small_table = machine("four_axis_a.toml", "swing_diameter_mm = 300.0", "swing_diameter_mm = 20.0");
    let short_travel =
        machine("demo_table_head.toml", "min_deg = -87.0\nmax_deg = 87.0", "min_deg = -3.0\nmax_deg = 3.0");
    write(dir.path(), "box.stl", cube_stl(60.0, 6).as_bytes());
    let prism = models.join("prism.step").display().to_string();
    let job = format!("[model]\nfile = '{prism}'\n[[fixture]]\nfile = \"box.stl\"\nunit = \"mm\"\n");
    write(dir.path(), "beside.toml", job.as_bytes());
    let twist = models.join("compressor_twist.step").display().to_string();
    let long = ["tool.shank_radius_mm=30", "tool.stickout_mm=20", "region.end_mm=20"];
    let planted: [(&str, &str, Vec<&str>); 7] = [
        ("lean-out-of-reach", &prism, vec![&small_table]),
        ("swing", &prism, vec![&small_table, "machine.b_deg=0"]),
        ("beyond-travel", &prism, vec![&short_travel]),
        ("ball-near-fixture", "beside.toml", vec!["region.end_mm=20"]),
        ("no-free-angle", &prism, vec!["region.start_mm=7", "tool.taper_deg=25", "channel.clearance_mm=3"]),
        ("channel-closes", &prism, long.to_vec()),
        ("no-offset", &twist, vec!["path.chord_mm=0.01", "schedule.kind=\"eccentric\""]),
    ];
    for (what, model, sets) in planted {
        let found = no_plan(&[&["path.scallop_mm=0.4"], &sets[..]].concat(), model, dir.path());
        assert_eq!(found["what"], what, "{found}");
        let near = |key: &str, to: f64| {
            let value = found[key].as_f64().expect(key);
            assert!((value - to).abs() < 1e-6 * to, "{what}: {key} is {value}, not {to}");
        };
        match what {
            "lean-out-of-reach" => near("lean_deg", 5.0),
            "swing" => near("swing_diameter_mm", 20.0),
            "beyond-travel" => near("excess_deg", 2.0),
            "ball-near-fixture" => assert_eq!(&found["name"], "fixture box.stl"),
            "no-offset" => assert!(found["low_mm"].as_f64() > found["high_mm"].as_f64(), "{found}"),
            "channel-closes" => assert_eq!(&found["bounds"][0]["tool"], "holder 1"),
            _ => assert!(found["at"]["turn"] == 0 && found["at_start"] == true, "{found}"),
        }
    }
}

#[test]
fn stages_can_be_stopped_after() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let model = root().join("models/prism.step").display().to_string();
    let out = bladewright(&["plan", &model, "-o", "out", "--until", "path", "--set", "region.start_mm=7"], dir.path());
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let names: Vec<String> = contents(&dir.path().join("out")).into_iter().map(|(n, _)| n).collect();
    assert_eq!(names, ["job.resolved.toml", "sections.json", "toolpath.json"]);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(said.starts_with("tool: ball R 4 mm, taper 4°, shank 12 mm, stick-out "), "{said}");
    for words in ["\n  turns  ", "\n  ball centres at heights            ", "stopped after path, as asked: model "] {
        assert!(said.contains(words), "`{words}` is not in {said}");
    }
    assert!(!said.contains("narrowest channel"), "{said}");
    // A feed that no axis reaches is told; and so is a ball that is too large.
    let options = ["feed.feed_mm_min=200000", "tool.radius_mm=10", "region.start_mm=15"].map(|o| ["--set", o]).concat();
    let out = bladewright(&[&["plan", &model, "-o", "fast", "--until", "section"][..], &options].concat(), dir.path());
    let told = String::from_utf8_lossy(&out.stderr).into_owned();
    for words in ["more than the machine's linear axes reach together", "the ball of 10 mm is too large for this blade"]
    {
        assert!(told.contains(words), "`{words}` is not in {told}");
    }
}

/// With the tool square to the blade axis the cone comes down on the platform before the ball does:
/// the helix ends above, and says so; an end that was asked for is refused instead.
#[test]
fn the_helix_ends_where_the_tool_has_no_room() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let model = root().join("models/prism.step").display().to_string();
    let options = ["machine.b_deg=0", "tool.radius_mm=4", "region.start_mm=9"].map(|o| ["--set", o]).concat();
    let until = [&["plan", &model, "-o", "out", "--until", "channel"][..], &options].concat();
    let out = bladewright(&until, dir.path());
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(0), "{text}");
    assert!(text.contains("the helix ends at height") && text.contains("taper against"), "{text}");
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(said.contains("\n  narrowest channel ") && said.contains("\n    without turning back "), "{said}");
    fails(&[&until[..], &["--set", "region.end_mm=5"]].concat(), dir.path(), 3, &["channel", "taper"]);
}
