//! Faults planted one by one into the text of a program, through the command: `verify PROGRAM` must
//! find, place and name each, and nothing in the program as it is.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn bladewright(args: &[&str], dir: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright")).args(args).current_dir(dir).output().expect("the command starts")
}

/// A finished run of the prism, and its programs.
struct Shop {
    dir: tempfile::TempDir,
    model: String,
}

impl Shop {
    fn new() -> Self {
        let dir = tempfile::tempdir().expect("temporary folder");
        let model = root().join("models/prism.step").display().to_string();
        // An own dialect needs no recompile: three digits, other words for the tool call, its own
        // file name.
        let own = std::fs::read_to_string(root().join("models/posts/linuxcnc.toml")).expect("a post file");
        let own = own.replace("name = \"LinuxCNC", "name = \"My mill").replace("program.ngc", "mine.tap");
        std::fs::write(dir.path().join("mine.toml"), own.replace("length_decimals = 5", "length_decimals = 4"))
            .expect("writable");
        let controls = "post.control=[\"siemens\",\"siemens-poly\",\"linuxcnc\"]";
        let sets = ["region.start_mm=6", "path.scallop_mm=0.03", "verify.surface_samples=20000", controls];
        let keys = sets.map(|s| ["--set", s]).concat();
        let out = bladewright(&[&["--quiet", "plan", &model, "-o", "run"], &keys[..]].concat(), dir.path());
        assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
        Shop { dir, model }
    }

    fn text(&self, program: &str) -> String {
        std::fs::read_to_string(self.dir.path().join("run").join(program)).expect("readable")
    }

    /// Exit code and what is said of a program's text.
    fn judged(&self, name: &str, text: &str, more: &[&str]) -> (Option<i32>, String) {
        std::fs::write(self.dir.path().join(name), text).expect("writable");
        let args = ["verify", name, "--part", &self.model];
        let tool: &[&str] = if more.contains(&"--tool") { &[] } else { &["--tool", "run/job.resolved.toml"] };
        let scallop: &[&str] = if more.contains(&"--scallop") { &[] } else { &["--scallop", "0.03"] };
        let out = bladewright(&[&args[..], tool, scallop, more].concat(), self.dir.path());
        (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned())
    }

    /// The finding that a text must lead to, in the words of the command.
    fn finding(&self, name: &str, text: &str, more: &[&str], finding: &str) -> String {
        let (code, said) = self.judged(name, text, more);
        assert_eq!(code, Some(1), "{finding}: {said}");
        let start = said.find(&format!("finding: {finding}")).unwrap_or_else(|| panic!("{finding} not in {said}"));
        said[start..].split("finding: ").nth(1).unwrap_or("").to_owned()
    }
}

/// Numbers of the line's X, Y and Z.
fn point(line: &str) -> Option<[f64; 3]> {
    let word = |letter: char| line.split(' ').find_map(|w| w.strip_prefix(letter)?.parse().ok());
    Some([word('X')?, word('Y')?, word('Z')?])
}

fn with_point(line: &str, p: [f64; 3]) -> String {
    let word = |w: &str| match w.chars().next().and_then(|c| "XYZ".find(c)) {
        Some(k) if w.len() > 1 => format!("{}{:.5}", &w[..1], p[k]),
        _ => w.to_owned(),
    };
    line.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

/// The text with line `k` (from 0) replaced.
fn replaced(text: &str, k: usize, by: &[String]) -> String {
    let line = |(i, l): (usize, &str)| if i == k { by.join("\n") + "\n" } else { format!("{l}\n") };
    text.lines().enumerate().map(line).collect()
}

#[test]
fn every_planted_fault_is_found_placed_and_named() {
    let shop = Shop::new();
    let siemens = shop.text("program.mpf");
    for program in ["program.mpf", "program.poly.mpf", "program.ngc"] {
        let (code, said) = shop.judged("clean.nc", &shop.text(program), &[]);
        assert_eq!(code, Some(0), "{program}: {said}");
    }
    // Lines may end in CR alone; a text of two bytes a letter is told.
    let (code, said) = shop.judged("cr.mpf", &siemens.replace('\n', "\r"), &[]);
    assert_eq!(code, Some(0), "{said}");
    let wide: String = siemens.chars().flat_map(|c| [c, '\0']).collect();
    assert_eq!(shop.judged("wide.mpf", &wide, &[]).0, Some(2));
    let lines: Vec<&str> = siemens.lines().collect();
    let cutting: Vec<usize> =
        (0..lines.len()).filter(|k| lines[*k].contains("=DC(") && point(lines[*k]).is_some()).collect();
    let k = cutting[cutting.len() / 2];
    let (line, at) = (format!("line {}", k + 1), point(lines[k]).expect("a point"));

    // A gouge of 5 µm: the tip shifted towards the blade axis, square to it; how deep that is the
    // command must tell.
    let across = (at[1].hypot(at[2])).max(1e-9);
    let deeper = |mm: f64| [at[0], at[1] * (1.0 - mm / across), at[2] * (1.0 - mm / across)];
    let said = shop.finding("gouge.mpf", &replaced(&siemens, k, &[with_point(lines[k], deeper(0.008))]), &[], "gouge");
    assert!(said.contains(&line), "{said}");

    // A holder that touches: the tool sticks out by less than the room that the holder has.
    let report: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(shop.dir.path().join("run/verify.json")).expect("readable"))
            .expect("JSON");
    let checks = report["checks"].as_array().expect("a list");
    let room =
        checks.iter().find(|c| c["name"] == "holder-clearance").and_then(|c| c["worst"].as_f64()).expect("a figure");
    let job = std::fs::read_to_string(shop.dir.path().join("run/job.resolved.toml")).expect("readable");
    let mut job: toml::Table = job.parse().expect("TOML");
    let out = job["tool"]["stickout_mm"].as_float().expect("a length");
    job["tool"]["stickout_mm"] = toml::Value::Float(out - 1.1 * room);
    std::fs::write(shop.dir.path().join("short.toml"), job.to_string()).expect("writable");
    let said = shop.finding("holder.mpf", &siemens, &["--tool", "short.toml"], "holder-clearance");
    assert!(said.contains("holder 1") && said.contains("line "), "{said}");

    // A swapped sign of B.
    let swapped = siemens.replace("B=5.", "B=-5.");
    assert_ne!(swapped, siemens);
    shop.finding("sign.mpf", &swapped, &[], "b-sign");

    // A missing turn.
    let turn = |n: usize| siemens.find(&format!("; Turn {n} of")).expect("turns are marked");
    let without = format!("{}{}", &siemens[..turn(3)], &siemens[turn(4)..]);
    let said = shop.finding("turn.mpf", &without, &[], "scallop-turn");
    assert!(said.contains("a turn or a pass is missing"), "{said}");

    // A scallop twice as high as asked for.
    shop.finding("scallop.mpf", &siemens, &["--scallop", "0.015"], "scallop");

    // A travel limit exceeded by 0.01 mm.
    let said = shop.finding("travel.mpf", &siemens.replacen("Z=630.000", "Z=630.010", 1), &[], "z-travel");
    assert!(said.contains("0.010000 mm") && said.contains("Z=630.010"), "{said}");

    // A rapid through the part: to the other side and back.
    let there = with_point(lines[k], [at[0], -at[1], -at[2]]);
    let rapid = |l: &str| {
        let words: Vec<&str> = l.split(' ').filter(|w| "XYZ".contains(&w[..1])).collect();
        format!("G0 {}", words.join(" "))
    };
    let by = [lines[k].to_owned(), rapid(&there), rapid(lines[k])];
    let said = shop.finding("rapid.mpf", &replaced(&siemens, k, &by), &[], "rapid");
    assert!(said.contains(&format!("line {}", k + 2)) || said.contains(&format!("line {}", k + 3)), "{said}");
}

/// Faults that only the plan tells of, by `verify RUN`: a feed, a coefficient, a travel in the
/// approach; and an own dialect.
#[test]
fn programs_of_a_run_are_compared_with_its_plan() {
    let shop = Shop::new();
    let (run, dir) = (shop.dir.path().join("run"), shop.dir.path());
    let fails = |program: &str, text: &str, finding: &str| {
        let good = shop.text(program);
        assert_ne!(good, text, "{finding}");
        std::fs::write(run.join(program), text).expect("writable");
        let out = bladewright(&["verify", "run"], dir);
        let said = String::from_utf8_lossy(&out.stdout).into_owned();
        assert!(out.status.code() == Some(1) && said.contains(&format!("finding: {finding}")), "{finding}: {said}");
        std::fs::write(run.join(program), good).expect("writable");
        said
    };
    let text = shop.text("program.mpf");
    let lines: Vec<&str> = text.lines().collect();
    let k = (lines.len() / 2..).find(|k| lines[*k].contains("=DC(")).expect("a cut");
    // One line's feed by a half.
    let (words, feed) = lines[k].rsplit_once(" F").expect("a feed");
    let faster = format!("{words} F{:.4}", 1.5 * feed.parse::<f64>().expect("a number"));
    let said = fails("program.mpf", &replaced(&text, k, &[faster]), "program-feed");
    assert!(said.contains(&format!("line {}", k + 1)), "{said}");
    fails("program.mpf", &text.replacen("Z=630.000", "Z=630.010", 1), "program-travel");
    let poly = shop.text("program.poly.mpf");
    let lines: Vec<&str> = poly.lines().collect();
    let k = (lines.len() / 2..).find(|k| lines[*k].contains(" PO[A]=(")).expect("a cut");
    let start = lines[k].find(" PO[A]=(").expect("A") + 8;
    let end = start + lines[k][start..].find(')').expect("its end");
    let first = lines[k][start..end].split(',').next().expect("an end");
    let bent = format!("{}{first},0.04000{}", &lines[k][..start], &lines[k][end..]);
    let said = fails("program.poly.mpf", &replaced(&poly, k, &[bent]), "program-curve");
    assert!(said.contains(&format!("line {}", k + 1)), "{said}");
    // An own dialect, told by a file.
    let out = bladewright(&["post", "run", "--post-file", "mine.toml"], dir);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let own = std::fs::read_to_string(run.join("mine.tap")).expect("the own dialect's file");
    assert!(own.contains("My mill") && own.lines().any(|l| l.starts_with("G1") || l.contains(" G1 ")), "{own}");
    let (code, said) = shop.judged("theirs.tap", &own, &["--post-file", "mine.toml"]);
    assert_eq!(code, Some(0), "{said}");
}

/// A program in the frame of somebody else comes back to the part; what has no single frame is
/// refused with exit code 3.
#[test]
fn the_frame_of_a_program_is_found() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let model = root().join("models/turbine_camber.step").display().to_string();
    let set = ["path.scallop_mm=0.4", "verify.surface_samples=20000", "post.control=[\"siemens-vector\",\"iso\"]"];
    let set = set.map(|s| ["--set", s]).concat();
    let plan = ["--quiet", "plan", &model, "-o", "run"];
    let out = bladewright(&[&plan[..], &set].concat(), dir.path());
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    // Turned by 90 degrees about z, then by 36.87 about x, and shifted.
    let turned = |[x, y, z]: [f64; 3]| [-y, 0.8 * x - 0.6 * z, 0.6 * x + 0.8 * z];
    let moved = |line: &str| {
        let Some(p) = point(line) else { return format!("{line}\n") };
        let [x, y, z] = turned(p);
        let line = with_point(line, [x + 310.0, y - 45.5, z + 12.25]);
        let axis: Vec<f64> = line.split(' ').filter_map(|w| w.split_once("3=")?.1.parse().ok()).collect();
        let Ok(axis) = <[f64; 3]>::try_from(axis) else { return line + "\n" };
        let axis = turned(axis);
        let word = |w: &str| match w.split_once("3=").and_then(|w| "ABC".find(w.0)) {
            Some(k) => format!("{}3={:.8}", &w[..1], axis[k]),
            None => w.to_owned(),
        };
        line.split(' ').map(word).collect::<Vec<_>>().join(" ") + "\n"
    };
    let text = std::fs::read_to_string(dir.path().join("run/program.vector.mpf")).expect("readable");
    std::fs::write(dir.path().join("moved.mpf"), text.lines().map(moved).collect::<String>()).expect("writable");
    let fit = |program: &str, part: &str, more: &[&str]| {
        let args = ["verify", program, "--part", part, "--tool", "run/job.resolved.toml", "--fit"];
        let out = bladewright(&[&args[..], more].concat(), dir.path());
        let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        (out.status.code(), said)
    };
    let (code, said) = fit("moved.mpf", &model, &["--report", "found.json"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("X Y Z are tool tips, found by trying both"), "{said}");
    let found = std::fs::read_to_string(dir.path().join("found.json")).expect("a report");
    let found: serde_json::Value = serde_json::from_str(&found).expect("JSON");
    // The inverse of the motion: the place of the program's zero, and its turn about z by -90
    // degrees after one about x by -36.87.
    let zero: Vec<f64> = (0..3).map(|i| found["fit"]["translation_mm"][i].as_f64().expect("a number")).collect();
    let there = [-(0.8 * -45.5 + 0.6 * 12.25), 310.0, -(-0.6 * -45.5 + 0.8 * 12.25)];
    assert!(zero.iter().zip(there).all(|(a, b)| (a - b).abs() < 0.002), "{zero:?} {there:?}");
    let turns: Vec<f64> = (0..3).map(|i| found["fit"]["turns_deg"][i].as_f64().expect("a number")).collect();
    let wanted = [-(0.6f64.atan2(0.8).to_degrees()), 0.0, -90.0];
    assert!(turns.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.001), "{turns:?} {wanted:?}");
    // In positions of the axes the work offset is found.
    let iso = std::fs::read_to_string(dir.path().join("run/program.iso.nc")).expect("readable");
    let shift = |w: &str| match w
        .chars()
        .next()
        .and_then(|c| "XYZ".find(c))
        .zip(w.get(1..).and_then(|v| v.parse::<f64>().ok()))
    {
        Some((k, v)) => format!("{}{:.5}", &w[..1], v + [-400.0, 3.5, -61.0][k]),
        None => w.to_owned(),
    };
    let shifted = |line: &str| match line.contains("G53") || line.starts_with('(') {
        true => format!("{line}\n"),
        false => line.split(' ').map(shift).collect::<Vec<_>>().join(" ") + "\n",
    };
    std::fs::write(dir.path().join("moved.nc"), iso.lines().map(shifted).collect::<String>()).expect("writable");
    let (code, said) = fit("moved.nc", &model, &[]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("added to X Y Z: 400.00") || said.contains("added to X Y Z: 399.99"), "{said}");
    // Another part, and two ways to say where it is.
    let other = root().join("models/prism.step").display().to_string();
    let (code, said) = fit("moved.mpf", &other, &[]);
    assert!(code == Some(3) && said.contains("no frame lays the program over the part"), "{said}");
    assert_eq!(fit("moved.mpf", &model, &["--cad"]).0, Some(2));
}

#[test]
fn a_program_is_scheduled_anew_and_the_rest_of_it_stays() {
    let dir = tempfile::tempdir().expect("a folder");
    let model = root().join("models/turbine_camber.step").display().to_string();
    let sets = ["schedule.kind=\"fixed\"", "path.scallop_mm=0.5", "post.control=[\"heidenhain\"]"];
    let sets: Vec<&str> = sets.iter().flat_map(|s| ["--set", s]).collect();
    let plan = bladewright(&[&["plan", &model, "-o", "run", "--force"], &sets[..]].concat(), dir.path());
    // A fixed lead turns back, which is a finding.
    assert_eq!(plan.status.code(), Some(1), "{}", String::from_utf8_lossy(&plan.stderr));
    // As another system may write it: lines that end in CR LF, a comment in Latin letters, one
    // feed.
    let text = std::fs::read_to_string(dir.path().join("run/program.h")).expect("readable");
    let word = |w: &str| match w.strip_prefix('F').and_then(|f| f.parse::<f64>().ok()) {
        Some(f) if (10.0..2500.0).contains(&f) => "F4000".to_owned(),
        _ => w.to_owned(),
    };
    let line = |l: &str| l.split(' ').map(word).collect::<Vec<_>>().join(" ") + "\r\n";
    let mut theirs: Vec<u8> = text.lines().map(line).collect::<String>().into_bytes();
    let comment = theirs.windows(2).position(|w| w == b"; ").expect("a comment") + 2;
    theirs[comment] = 0xe4;
    std::fs::write(dir.path().join("theirs.h"), &theirs).expect("writable");
    let run = |program: &str, part: &str, out: &str, more: &[&str]| {
        let args = ["reschedule", program, "--part", part, "--tool", "run/job.resolved.toml", "-o", out];
        let out = bladewright(&[&args[..], more].concat(), dir.path());
        let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        (out.status.code(), said)
    };
    let (code, said) = run("theirs.h", &model, "new", &["--for", "linuxcnc,heidenhain"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("anew.program.ngc for LinuxCNC: 1 operation"), "{said}");
    assert!(said.contains("1 of 1 scheduled anew") && said.contains("after"), "{said}");
    let new = std::fs::read(dir.path().join("new/theirs.h")).expect("the new program");
    let report = std::fs::read_to_string(dir.path().join("new/reschedule.json")).expect("the report");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    let stretch = &report["stretches"][0];
    let number = |v: &serde_json::Value| v.as_f64().expect("a number");
    assert!(number(&stretch["time_s"][1]) < 0.9 * number(&stretch["time_s"][0]), "{stretch}");
    assert!(number(&stretch["reversals"][0]) > 0.0 && number(&stretch["reversals"][1]) == 0.0, "{stretch}");
    assert!(number(&report["centre_off_mm"]) <= number(&report["centre_limit_mm"]), "{report}");
    let svg = std::fs::read_to_string(dir.path().join("new/reschedule.svg")).expect("the plot");
    assert!(svg.contains("before") && svg.contains("<svg"));
    // All else is the same bytes.
    let lines = |bytes: &[u8]| bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect::<Vec<_>>();
    let (old, new) = (lines(&theirs), lines(&new));
    assert!(new[..new.len() - 1].iter().all(|l| l.ends_with(b"\r")));
    let [first, last] = [0, 1].map(|k| number(&stretch["new_lines"][k]) as usize);
    let added = number(&report["lines_added"]) as usize;
    assert_eq!(new.len(), old.len() + added);
    assert!(old[..first - 1] == new[..first - 1]);
    let code_of = |l: &Vec<u8>| l.iter().skip_while(|b| b.is_ascii_digit()).copied().collect::<Vec<u8>>();
    let tail = |all: &[Vec<u8>], from: usize| all[from..].iter().map(code_of).collect::<Vec<_>>();
    // One line behind the stretch may say the feed again.
    assert_eq!(tail(&old, last + 1), tail(&new, last + 1 + added));
    // The check of programs has nothing to say of the new one that it had not of the old one.
    let judged = |program: &str| {
        let args = ["verify", program, "--part", &model, "--tool", "run/job.resolved.toml", "--report", "found.json"];
        bladewright(&args, dir.path());
        let found = std::fs::read_to_string(dir.path().join("found.json")).expect("a report");
        let found: serde_json::Value = serde_json::from_str(&found).expect("JSON");
        let checks = found["checks"].as_array().expect("checks").clone();
        checks.iter().filter(|c| c["passed"] == false).map(|c| c["name"].to_string()).collect::<Vec<_>>()
    };
    let before = judged("theirs.h");
    for new in ["new/theirs.h", "new/anew.program.ngc", "new/anew.program.h"] {
        let after = judged(new);
        assert!(after.iter().all(|c| before.contains(c)), "{new}: {before:?} {after:?}");
    }
    let made = report["programs"].as_array().expect("programs");
    let failed = made.iter().flat_map(|p| p["failed"].as_array().expect("names")).map(ToString::to_string);
    assert!(made.len() == 2 && failed.clone().all(|f| before.contains(&f)), "{:?}", failed.collect::<Vec<_>>());
    let (code, said) = run("theirs.h", &model, "twice", &["--for", "iso,iso"]);
    assert!(code == Some(2) && said.contains("would both write") && !dir.path().join("twice").exists(), "{said}");
    // What cannot be done leaves nothing.
    let (code, said) = run("theirs.h", &model, ".", &[]);
    assert!(code == Some(2) && said.contains("would take the place of theirs.h"), "{said}");
    let other = root().join("models/prism.step").display().to_string();
    let (code, said) = run("theirs.h", &other, "none", &[]);
    assert!(code == Some(2) && said.contains("the part"), "{said}");
    let (code, said) = run("theirs.h", &model, "none", &["--schedule", "quaternion"]);
    assert!(code == Some(3) && said.contains("begins and ends at the program's angles"), "{said}");
    assert!(!dir.path().join("none").exists());
}
