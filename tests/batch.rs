//! Families as a user meets them: the same bytes however they came about, failures that harm no
//! other, exit codes.

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use super::families::{FAMILY, same, tree};

fn command(args: &[&str], dir: &Path) -> Command {
    let mut c = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    c.args(args).current_dir(dir);
    c
}

fn bladewright(args: &[&str], dir: &Path) -> Output {
    command(args, dir).output().expect("the command starts")
}

/// Runs and expects an exit code; what it printed.
fn ends(args: &[&str], dir: &Path, code: i32) -> String {
    let out = bladewright(args, dir);
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(code), "{args:?}\n{text}");
    assert!(!text.contains("panicked"), "{text}");
    text
}

#[test]
fn the_same_bytes_on_threads_in_shards_and_after_a_kill() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    std::fs::write(d.join("family.toml"), FAMILY).expect("writable");
    let text = ends(&["--threads", "2", "batch", "family.toml", "-o", "two"], d, 0);
    assert!(text.contains("4 members: 4 good; 4 computed now"), "{text}");
    for file in
        ["family.csv", "family.parquet", "family.html", "members/fillet_radius_mm-6_feed_mm_min-1000/report.html"]
    {
        assert!(d.join("two").join(file).is_file(), "{file} is missing");
    }
    assert!(!d.join("two/work").exists());
    ends(&["--threads", "1", "batch", "family.toml", "-o", "one"], d, 0);
    same(&d.join("one"), &d.join("two"));

    // Shards in one folder; tables come with the merge, which tells what is missing before.
    ends(&["batch", "family.toml", "-o", "parts", "--shard", "1/3"], d, 0);
    assert!(!d.join("parts/family.csv").exists());
    let text = ends(&["batch", "merge", "family.toml", "-o", "parts"], d, 4);
    assert!(text.contains("missing"), "{text}");
    ends(&["batch", "family.toml", "-o", "parts", "--shard", "2/3"], d, 0);
    ends(&["batch", "family.toml", "-o", "parts", "--shard", "3/3"], d, 0);
    ends(&["batch", "merge", "family.toml", "-o", "parts"], d, 0);
    same(&d.join("two"), &d.join("parts"));

    // Ctrl-C and a request to end cleanly: what is done is kept, and told.
    for signal in ["-INT", "-TERM"] {
        let out = d.join(format!("stopped{signal}"));
        let child = command(&["--threads", "1", "batch", "family.toml", "-o"], d)
            .arg(&out)
            .stderr(Stdio::null())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let begun = std::time::Instant::now();
        while !out.join("members").is_dir() && begun.elapsed() < Duration::from_secs(60) {
            std::thread::sleep(Duration::from_millis(5));
        }
        Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill starts");
        let ended = child.wait_with_output().expect("it ends");
        let text = String::from_utf8_lossy(&ended.stdout);
        assert_eq!(ended.status.code(), Some(130), "{signal}: {text}");
        assert!(text.contains("missing") && out.join("family.csv").is_file(), "{signal}: {text}");
        assert!(!out.join("work").exists());
    }

    // Killed on the way, then again.
    for wait_ms in [150, 700] {
        let mut child = command(&["--threads", "1", "batch", "family.toml", "-o", "killed"], d)
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .expect("the command starts");
        std::thread::sleep(Duration::from_millis(wait_ms));
        child.kill().expect("it can be killed");
        child.wait().expect("it ends");
    }
    ends(&["batch", "family.toml", "-o", "killed"], d, 0);
    same(&d.join("two"), &d.join("killed"));
}

#[test]
fn only_what_changed_is_computed_and_stages_are_taken_over() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let small = FAMILY.replace("[6, 7]", "[6]").replace("[1000, 2000]", "[1000]");
    let put = |text: &str| std::fs::write(d.join("family.toml"), text).expect("writable");
    let computed = |out: &str, n: usize| {
        let text = ends(&["batch", "family.toml", "-o", out], d, 0);
        assert!(text.contains(&format!("{n} computed now")), "{text}");
    };
    let log = |out: &str| {
        let file = d.join(out).join("log/fillet_radius_mm-6_feed_mm_min-1000.json");
        let log: serde_json::Value = serde_json::from_slice(&std::fs::read(file).expect("readable")).expect("JSON");
        let taken = log["taken"].as_array().expect("list");
        taken.iter().map(|s| s.as_str().expect("word").to_owned()).collect::<Vec<_>>()
    };
    put(&small);
    computed("out", 1);
    assert!(log("out").is_empty());
    let before = tree(&d.join("out"));
    computed("out", 0);
    assert!(before == tree(&d.join("out")));
    // A file that is gone is made again.
    std::fs::remove_file(d.join("out/members/fillet_radius_mm-6_feed_mm_min-1000/axes.csv")).expect("removable");
    computed("out", 1);
    assert!(before == tree(&d.join("out")));
    // Each change against a run from nothing: the same bytes.
    let all = ["section", "path", "channel", "schedule", "feed", "verify", "preview"];
    for (what, taken) in [
        ("post = { spindle_rpm = 7000 }", &all[..]),
        ("post = { control = [\"heidenhain\"] }", &all),
        ("feed = { feed_mm_min = 900 }", &all),
        ("scallop_ratio = 999", &all[1..5]),
        ("schedule = { margin_deg = 1.0 }", &all[1..3]),
        ("machine = { b_deg = 6 }", &all[1..2]),
    ] {
        let added = format!("{what}\nsection =");
        let by =
            if what.contains("scallop_ratio") { ("scallop_ratio = 1000", what) } else { ("section =", added.as_str()) };
        put(&small.replace(by.0, by.1));
        // The feed of the template is overruled by the range: nothing changes.
        computed("out", usize::from(!what.starts_with("feed")));
        if !what.starts_with("feed") {
            assert_eq!(log("out"), taken, "{what}");
        }
        ends(&["batch", "family.toml", "-o", "fresh"], d, 0);
        same(&d.join("out"), &d.join("fresh"));
        std::fs::remove_dir_all(d.join("fresh")).expect("removable");
        put(&small);
        ends(&["batch", "family.toml", "-o", "out"], d, 0);
    }
    assert!(before == tree(&d.join("out")));
    // An edit that leaves a file as long as it was is noticed, and what was edited is taken over
    // into nothing.
    let member = d.join("out/members/fillet_radius_mm-6_feed_mm_min-1000");
    for (file, taken) in [("program.mpf", &all[..]), ("plan.json", &[]), ("manifest.json", &[])] {
        let mut bytes = std::fs::read(member.join(file)).expect("readable");
        let at = bytes.len() / 2 + bytes[bytes.len() / 2..].iter().position(u8::is_ascii_digit).expect("a digit");
        bytes[at] = if bytes[at] == b'9' { b'1' } else { bytes[at] + 1 };
        std::fs::write(member.join(file), bytes).expect("writable");
        computed("out", 1);
        assert_eq!(log("out"), taken, "{file}");
        assert!(before == tree(&d.join("out")), "{file}");
    }
    // Programs that come to a member later stay, and the member is whole.
    ends(&["post", &member.display().to_string(), "--control", "fanuc"], d, 0);
    computed("out", 0);
    assert!(member.join("program.nc").is_file());
    std::fs::write(member.join("plan.json"), "").expect("writable");
    computed("out", 1);
    assert!(before == tree(&d.join("out")));
    // What is not as the earlier run left it is not taken over.
    let report = d.join("out/members/fillet_radius_mm-6_feed_mm_min-1000/report.html");
    let text = std::fs::read_to_string(&report).expect("readable");
    std::fs::write(&report, text.replace("numbers", "figures")).expect("writable");
    put(&small.replace("section =", "post = { spindle_rpm = 7000 }\nsection ="));
    computed("out", 1);
    assert_eq!(log("out"), all[1..6]);
    ends(&["batch", "family.toml", "-o", "fresh"], d, 0);
    same(&d.join("out"), &d.join("fresh"));
}

#[test]
fn a_member_that_fails_harms_no_other() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    std::fs::write(d.join("broken.step"), "no STEP at all").expect("writable");
    let table = "name,model,design.fillet_radius_mm,tool.radius_mm\ngood,,6,\nbroken,broken.step,,\nabsent,absent.stl,,\nwide,,,9\n";
    std::fs::write(d.join("family.csv"), table).expect("writable");
    let family = FAMILY.split("[ranges]").next().expect("text").replace("design =", "table = \"family.csv\"\ndesign =");
    std::fs::write(d.join("family.toml"), family).expect("writable");
    let text = ends(&["batch", "family.toml", "-o", "out"], d, 4);
    assert!(text.contains("broken failed in model") && text.contains("absent failed in model"), "{text}");
    let csv = std::fs::read_to_string(d.join("out/family.csv")).expect("readable");
    assert!(csv.contains("\ngood,good,0,") && csv.contains("\nbroken,failed,4,model,"), "{csv}");
    assert!(csv.contains("\nwide,failed,3,"), "{csv}");
    // Why there is no plan stands in the record as data too.
    let wide = std::fs::read_to_string(d.join("out/members/wide/member.json")).expect("written");
    let wide: serde_json::Value = serde_json::from_str(&wide).expect("JSON");
    assert!(wide["infeasible"]["what"].is_string() && wide.get("missed").is_none(), "{wide}");
    let text = ends(&["batch", "family.toml", "-o", "out"], d, 4);
    assert!(text.contains("0 computed now"), "failures are known too: {text}");
    let text = ends(&["batch", "family.toml", "-o", "out", "--retry"], d, 4);
    assert!(text.contains("computed now") && !text.contains(" 0 computed") && !text.contains("4 computed"), "{text}");
    // What failed for want of a file is due when the file is there.
    std::fs::copy(d.join("out/members/good/model.step"), d.join("absent.stl")).expect("copied");
    let text = ends(&["batch", "family.toml", "-o", "out"], d, 4);
    assert!(text.contains("1 computed now"), "{text}");
}

#[test]
fn exit_codes_of_bad_input() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    std::fs::write(d.join("empty.toml"), "models = \"*.step\"").expect("writable");
    std::fs::write(d.join("family.toml"), FAMILY).expect("writable");
    for (args, code, word) in [
        (&["batch", "empty.toml", "-o", "out"][..], 2, "no file matches"),
        (&["batch", "none.toml", "-o", "out"], 4, "none.toml"),
        (&["batch", "family.toml"], 2, "--out"),
        (&["batch", "family.toml", "-o", "out", "--shard", "5/4"], 2, "no shard 5 of 4"),
        (&["batch", "family.toml", "-o", "out", "--shard", "x"], 2, "1/4"),
        (&["batch", "family.toml", "-o", "family.toml"], 4, "family.toml"),
    ] {
        let text = ends(args, d, code);
        assert!(text.contains(word), "{word} is not in {text}");
        assert!(!d.join("out").exists(), "{args:?} left something behind");
    }
    if !cfg!(feature = "s3") {
        let text = ends(&["batch", "family.toml", "-o", "s3://bucket/out"], d, 2);
        assert!(text.contains("--features s3"), "{text}");
    }
    let text = ends(&["batch", "family.toml", "--list"], d, 0);
    assert_eq!(text.lines().count(), 5, "{text}");
}

/// A disk that fills up in the middle: a clear error, what is done is kept, and with room the rest
/// is done.
#[test]
#[ignore = "needs a disk of its own: a system that lets users make name spaces (unshare -rm)"]
#[cfg(target_os = "linux")]
fn a_full_disk_stops_and_is_taken_up_again() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    std::fs::write(d.join("family.toml"), FAMILY).expect("writable");
    ends(&["batch", "family.toml", "-o", "whole"], d, 0);
    let script = "mkdir disk && mount -t tmpfs -o size=$(($(du -sk whole | cut -f1) * 6 / 10))k none disk || exit 77
        \"$BLADEWRIGHT\" --quiet --threads 1 batch family.toml -o disk/out; echo first $?
        ls disk/out/members | wc -l
        mount -o remount,size=200m disk || exit 77
        \"$BLADEWRIGHT\" --quiet batch family.toml -o disk/out || exit 1
        cp -r disk/out after";
    let run = Command::new("unshare")
        .args(["-rm", "sh", "-c", script])
        .env("BLADEWRIGHT", env!("CARGO_BIN_EXE_bladewright"))
        .current_dir(d)
        .output();
    let run = run.expect("this test needs `unshare` of util-linux");
    let (text, said) = (String::from_utf8_lossy(&run.stderr), String::from_utf8_lossy(&run.stdout));
    assert!(run.status.success(), "a disk of its own, and a family on it: {said}{text}");
    assert!(said.contains("first 4") && text.contains("No space left"), "{said}{text}");
    let kept: usize = said.lines().nth(1).and_then(|l| l.trim().parse().ok()).expect("a number");
    assert!((1..4).contains(&kept), "{kept} of 4 members were done when the disk was full");
    same(&d.join("whole"), &d.join("after"));
}
