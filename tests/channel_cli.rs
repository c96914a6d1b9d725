//! The channel as a user meets it: what is in the way is named, and what would help is said.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn prism() -> String {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models/prism.step").display().to_string()
}

fn bladewright(args: &[&str], dir: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright"))
        .arg("--quiet")
        .args(args)
        .current_dir(dir)
        .output()
        .expect("the command starts")
}

fn fails(args: &[&str], dir: &Path, code: i32, words: &[&str]) {
    let out = bladewright(args, dir);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(code), "{args:?}\n{text}");
    for word in words {
        assert!(text.contains(word), "`{word}` is not in the message of {args:?}:\n{text}");
    }
}

/// A box from `lo` to `hi` as OBJ with its first `count` of 12 triangles.
fn box_obj(lo: f64, hi: f64, count: usize) -> String {
    let side = |b: usize| if b == 0 { lo } else { hi };
    let mut text = String::new();
    for i in 0..8usize {
        text += &format!("v {} {} {}\n", side(i & 1), side(i >> 1 & 1), side(i >> 2));
    }
    let faces =
        ["1 3 4", "1 4 2", "5 6 8", "5 8 7", "1 2 6", "1 6 5", "3 7 8", "3 8 4", "1 5 7", "1 7 3", "2 4 8", "2 8 6"];
    for f in faces.iter().take(count) {
        text += &format!("f {f}\n");
    }
    text
}

/// A job with one fixture.
fn job(dir: &Path, fixture: &str) {
    let text = format!(
        "[model]\nfile = {:?}\n[path]\nscallop_mm = 0.2\n[[fixture]]\nfile = {fixture:?}\nclearance_mm = 0.5\n",
        prism()
    );
    std::fs::write(dir.join("job.toml"), text).expect("writable");
}

#[test]
fn what_is_in_the_way_is_named() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let write = |name: &str, text: String| std::fs::write(d.join(name), text).expect("writable");
    write("open.obj", box_obj(-10.0, 10.0, 11));
    write("round.obj", box_obj(-400.0, 400.0, 12));
    job(d, "open.obj");
    fails(&["plan", "job.toml", "-o", "out"], d, 4, &["open.obj has a hole, the longest of 3 edges"]);
    job(d, "missing.obj");
    fails(&["plan", "job.toml", "-o", "out"], d, 4, &["missing.obj"]);
    job(d, "round.obj");
    let words = ["the tool starts in collision: the ball centre is inside fixture round.obj at turn 1"];
    fails(&["plan", "job.toml", "-o", "out"], d, 3, &words);
    let swallows = ["--set", "tool.stickout_mm=6", "--set", "tool.holder=[{radius_mm=300, length_mm=200}]"];
    let model = prism();
    let args = [&["plan", &model, "-o", "out", "--set", "path.scallop_mm=0.2"], &swallows[..]].concat();
    let words =
        ["the tool starts in collision: no angle of the tool axis is free", "holder 1 against face", "stick out"];
    fails(&args, d, 3, &words);
    assert!(!d.join("out").exists());
}

#[test]
fn the_channel_alone_is_written_with_its_width_against_b() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let args = ["channel", &prism(), "-o", "out", "--set", "path.scallop_mm=0.2", "--sweep-b=-5,15,5"];
    let out = bladewright(&args, d);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let table = std::fs::read_to_string(d.join("out/channel_intervals.csv")).expect("written");
    assert!(table.lines().count() > 100 && table.contains("taper / part / face"), "{}", &table[..500]);
    let widths = std::fs::read_to_string(d.join("out/sweep_b.csv")).expect("written");
    assert_eq!(widths.lines().count(), 6, "{widths}");
    assert!(std::fs::read_to_string(d.join("out/sweep_b.svg")).expect("written").starts_with("<svg"));
    fails(&["channel", &prism(), "-o", "out", "--sweep-b=5,1,1"], d, 2, &["FROM,TO,STEP"]);
}

#[test]
fn the_free_axes_of_a_location_are_drawn_all_over_the_sphere() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let model = prism();
    let args = ["channel", &model, "-o", "out", "--set", "path.scallop_mm=0.2", "--sphere"];
    let out = bladewright(&args, d);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert!(said.contains("% of all tool axes are free"), "{said}");
    let svg = std::fs::read_to_string(d.join("out/sphere.svg")).expect("written");
    assert!(svg.starts_with("<svg") && svg.contains("polyline") && svg.trim_end().ends_with("</svg>"));
    // The axes in the middle of a free interval lie in free cells.
    let table = std::fs::read_to_string(d.join("out/sphere.csv")).expect("written");
    let row: usize = said.split("location ").nth(1).and_then(|t| t.split(':').next()?.parse().ok()).expect("a number");
    let intervals = std::fs::read_to_string(d.join("out/channel_intervals.csv")).expect("written");
    let job = std::fs::read_to_string(d.join("out/job.resolved.toml")).expect("written");
    let b_deg: f64 = job.lines().find_map(|l| l.strip_prefix("b_deg = ")).and_then(|v| v.parse().ok()).expect("a lean");
    let mut looked = 0;
    for line in intervals.lines().skip(1).filter(|l| l.split(',').next() == Some(&row.to_string())) {
        let ends: Vec<f64> = line.split(',').skip(4).take(2).filter_map(|v| v.parse().ok()).collect();
        let (theta, b) = ((0.5 * (ends[0] + ends[1])).to_radians(), b_deg.to_radians());
        let axis = [b.sin(), b.cos() * theta.cos(), b.cos() * theta.sin()];
        let holds = |c: &[f64]| {
            let [p, q, r] = [0, 3, 6].map(|k| [c[k], c[k + 1], c[k + 2]]);
            let side = |p: [f64; 3], q: [f64; 3]| {
                let n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
                n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2]
            };
            side(p, q) >= -1e-6 && side(q, r) >= -1e-6 && side(r, p) >= -1e-6
        };
        let cell = table.lines().skip(1).find(|l| {
            let corners: Vec<f64> = l.split(',').take(9).filter_map(|v| v.parse().ok()).collect();
            holds(&corners)
        });
        assert!(cell.is_some_and(|c| c.contains(",free,")), "{line}: {cell:?}");
        looked += 1;
    }
    assert!(looked > 0, "{intervals}");
    fails(
        &["channel", &model, "-o", "b", "--set", "path.scallop_mm=0.2", "--sphere=99999999"],
        d,
        2,
        &["location 99999999 is asked for, the path has"],
    );
    fails(&["channel", &model, "-o", "b", "--sphere=first"], d, 2, &["give the number of a location"]);
    assert!(!d.join("b").exists());
}

#[test]
fn advice_finds_a_stick_out_that_opens_a_closed_channel() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    // Only a few long chords: advice makes the channel dozens of times.
    let path = ["path.scallop_mm=0.2", "path.chord_mm=0.01", "region.start_mm=8"].map(|s| ["--set", s]).concat();
    let model = prism();
    let args = [&["advise", &model, "-o", "out", "--set", "tool.stickout_mm=12"], &path[..]].concat();
    let out = bladewright(&args, d);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let text = std::fs::read_to_string(d.join("out/advice.json")).expect("written");
    let advice: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert!(advice["now"]["monotone_deg"].is_null(), "{text}");
    let least = advice["least_stickout_mm"].as_f64().expect("a stick-out opens it");
    assert!(least > 12.0, "{text}");
    // What is advised works, and a little less does not.
    for (stickout, code) in [(least + 0.5, 0), (least - 2.0, 3)] {
        let set = format!("tool.stickout_mm={stickout}");
        let args = [&["channel", &model, "-o", "again", "--set", &set], &path[..]].concat();
        assert_eq!(bladewright(&args, d).status.code(), Some(code), "{stickout}");
    }
}

/// A blade of compressor_twist on a mesh so coarse that its deflection, kept as room, closes the
/// channel.
fn coarse(verb: &str, d: &Path, settings: &[&str]) {
    let model = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models/compressor_twist.step").display().to_string();
    let region =
        ["tool.radius_mm=3", "path.scallop_mm=0.2", "path.chord_mm=0.04", "region.start_mm=52.5", "region.end_mm=51"];
    let mut args = vec![verb, &model, "-o", "out"];
    for setting in region.iter().chain(&["model.deflection_mm=0.5", "channel.clearance_mm=2"]) {
        args.extend(["--set", setting]);
    }
    args.extend(settings);
    let out = bladewright(&args, d);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
}

/// Degrees between the monotone hulls where they are nearest.
fn narrowest_deg(d: &Path) -> f64 {
    let text = std::fs::read_to_string(d.join("out/channel.json")).expect("written");
    let channel: bladewright::artifact::Channel = serde_json::from_str(&text).expect("a channel");
    let row = &channel.rows[channel.narrowest_row];
    (row.hull_max - row.hull_min).to_degrees()
}

#[test]
fn exact_ends_open_a_channel_whose_moves_are_proven() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let proven = ["--until", "channel", "--set", "channel.tolerance_deg=0.3", "--set", "channel.prove_moves=true"];
    coarse("plan", d, &proven);
    assert!(narrowest_deg(d) > 20.0, "{}", narrowest_deg(d));
}

#[test]
fn widths_against_b_are_those_of_exact_ends_where_these_are_asked_for() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    coarse("channel", d, &["--sweep-b=5,6,1", "--set", "machine.b_deg=5", "--set", "channel.exact_ends=true"]);
    let text = std::fs::read_to_string(d.join("out/sweep_b.json")).expect("written");
    let widths: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let at_5 = widths[0]["monotone_deg"].as_f64().expect("open");
    let binds = &widths[0]["binds"];
    assert!(binds["is"] == "between" && binds["below"]["by"].is_string(), "{binds}");
    // The index's own ends are 0.005 degrees inside.
    assert!((at_5 - narrowest_deg(d)).abs() < 1e-3, "{at_5} {}", narrowest_deg(d));
}
