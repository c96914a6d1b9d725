//! Files that are not what they seem: names that would steer the terminal, pipes and devices in
//! place of files, tables that reach out of their folder, coordinates without bound; and signals
//! while nothing moves.
#![cfg(target_os = "linux")]

use std::io::Write;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn prism() -> String {
    root().join("models/prism.step").display().to_string()
}

fn command(args: &[&str], dir: &Path) -> Command {
    let mut c = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    c.args(args).current_dir(dir).stdin(Stdio::null());
    c
}

/// Its end, so that a test fails where it would hang.
fn ended(mut child: Child) -> Output {
    let begun = Instant::now();
    while child.try_wait().expect("a child").is_none() {
        if begun.elapsed() > Duration::from_secs(120) {
            child.kill().expect("it can be killed");
            panic!("it does not end");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    child.wait_with_output().expect("it has ended")
}

/// Exit code and all that was printed.
fn run(args: &[&str], dir: &Path) -> (Option<i32>, String) {
    let child = command(args, dir).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
    let out = ended(child);
    (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr))
}

/// Nothing but text and line ends.
#[track_caller]
fn is_plain(text: &str) {
    let steers = |c: &char| (c.is_control() && !"\n\t".contains(*c)) || ('\u{202a}'..='\u{202e}').contains(c);
    assert_eq!(text.chars().find(steers), None, "{text:?}");
}

const HOSTILE: &str = "x\u{1b}]0;OWNED\u{7}\u{1b}[2J\u{9b}31m\u{202e}";

/// A box as OBJ; its first group has the name given.
fn obj(group: &str) -> String {
    let mut text = String::from("v 0 0 0\nv 30 0 0\nv 0 10 0\nv 30 10 0\nv 0 0 60\nv 30 0 60\nv 0 10 60\nv 30 10 60\n");
    text += &format!("o {group}\ng {group}\nusemtl {group}\n");
    for [a, b, c, d] in [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]] {
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

#[test]
fn what_files_say_does_not_steer_the_terminal() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    let put = |name: &str, text: &str| std::fs::write(d.join(name), text).expect("writable");
    put("group.obj", &obj(HOSTILE));
    put("line.obj", &format!("{}f {HOSTILE} 1 2\n", obj("a")));
    put("line.stl", &format!("solid {HOSTILE}\nfacet normal 0 0 0\nouter loop\nvertex {HOSTILE} 0 0\n"));
    put("line.ply", &format!("ply\nformat ascii 1.0\nelement vertex 3\nproperty {HOSTILE} x\nend_header\n"));
    put("line.csv", &format!("+++\n[sections]\ncolumns = [\"x\", \"y\", \"z\"]\n+++\n1,2,{HOSTILE}\n"));
    put("key.toml", &format!("[model]\nfile = \"a\"\n# {HOSTILE}\nbad = \"{HOSTILE}\"\n"));
    put(&format!("{HOSTILE}.step"), "no STEP");
    let step = std::fs::read_to_string(prism()).expect("the model");
    let named = step.replace("ADVANCED_FACE(''", "ADVANCED_FACE('f\\X\\1B]0;X\\X\\07\\X\\0Aerror: planted'");
    assert!(named.contains("\\X\\1B"), "the model's faces have no names to replace");
    put("faces.step", &named);
    let hostile_step = format!("{HOSTILE}.step");
    let shown: [&[&str]; 9] = [
        &["inspect", "group.obj"],
        &["inspect", "line.obj"],
        &["inspect", "line.stl"],
        &["inspect", "line.ply"],
        &["inspect", "line.csv"],
        &["inspect", &hostile_step],
        &["inspect", "faces.step"],
        &["plan", "key.toml", "-o", "out"],
        &["plan", "group.obj", "-o", "out", "--faces", "airfoil=none"],
    ];
    for args in shown {
        let (_, text) = run(args, d);
        assert!(!text.is_empty(), "{args:?}");
        is_plain(&text);
        assert!(!text.lines().any(|l| l.starts_with("error: planted")), "{text}");
        let (_, text) = run(&[&["--json"], args].concat(), d);
        is_plain(&text);
        for line in text.lines() {
            let _: serde_json::Value = serde_json::from_str(line).unwrap_or_else(|e| panic!("{line:?}: {e}"));
        }
    }
    let (_, text) = run(&["inspect", &hostile_step], d);
    assert!(
        text.contains("x\\u{1b}]0;OWNED\\u{7}\\u{1b}[2J\\u{9b}31m\\u{202e}.step"),
        "what is hidden is shown: {text}"
    );
    let (code, text) = run(&["inspect", "group.obj", HOSTILE], d);
    assert_eq!(code, Some(2));
    is_plain(&text);
}

#[test]
fn pipes_and_devices_are_refused_at_once() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let (d, model) = (dir.path(), prism());
    for name in ["pipe.step", "pipe.toml", "pipe.bin", "pipe.csv", "pipe.nc"] {
        let made = Command::new("mkfifo").arg(d.join(name)).status().expect("this test needs `mkfifo` of coreutils");
        assert!(made.success());
    }
    symlink("/dev/zero", d.join("zero.step")).expect("a link");
    symlink("/dev/zero", d.join("zero.toml")).expect("a link");
    symlink("/dev/zero", d.join("zero.nc")).expect("a link");
    let put = |name: &str, text: &str| std::fs::write(d.join(name), text).expect("writable");
    put("buffer.gltf", "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"pipe.bin\",\"byteLength\":4}]}");
    put("table.toml", "[sections]\nfiles = \"pipe.csv\"\ncolumns = [\"x\", \"y\", \"z\"]\n");
    put("rows.toml", "design = \"prism\"\ntable = \"pipe.csv\"\n");
    put("tool.toml", "radius_mm = 3\ntaper_deg = 0\nshank_radius_mm = 3\nstickout_mm = 50\nholder = []\n");
    put("good.nc", "G94 G1 X1 Y1 Z1 F5\nM30\n");
    let set = |key: &str, file: &str| format!("{key}={}", d.join(file).display());
    let (machine, zero, post) =
        (set("machine.file", "pipe.toml"), set("machine.file", "zero.toml"), "post.files=[\"pipe.toml\"]");
    let refused: [&[&str]; 14] = [
        &["inspect", "pipe.step"],
        &["inspect", "zero.step"],
        &["plan", "pipe.step", "-o", "out"],
        &["plan", "pipe.toml", "-o", "out"],
        &["plan", "zero.toml", "-o", "out"],
        &["plan", &model, "-o", "out", "--set", &machine],
        &["plan", &model, "-o", "out", "--set", &zero],
        &["plan", &model, "-o", "out", "--set", post],
        &["inspect", "buffer.gltf"],
        &["inspect", "table.toml"],
        &["make", "pipe.toml", "-o", "out"],
        &["batch", "rows.toml", "-o", "out"],
        &["verify", "pipe.nc", "--part", &model, "--tool", "tool.toml"],
        &["verify", "good.nc", "--part", &model, "--tool", "zero.toml"],
    ];
    for args in refused {
        let (code, text) = run(args, d);
        assert!(matches!(code, Some(2 | 4)), "{args:?}: {code:?} {text}");
        assert!(text.contains("a pipe or a device, not a file"), "{args:?}: {text}");
        assert_eq!(text.matches("error: ").count(), 1, "{text}");
    }
    assert!(!d.join("out").exists());
}

#[test]
fn tables_stay_in_their_folder() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path().join("tables");
    std::fs::create_dir(&d).expect("writable");
    std::fs::write(dir.path().join("secret.csv"), "password 1234\n").expect("writable");
    let absolute = dir.path().join("secret.csv").display().to_string();
    for files in [absolute.as_str(), "../secret.csv", "../*.csv", "sub/../../secret.csv", "/etc/passwd"] {
        let text = format!("[sections]\nfiles = {files:?}\ncolumns = [\"x\", \"y\", \"z\"]\n");
        std::fs::write(d.join("table.toml"), text).expect("writable");
        let (code, text) = run(&["inspect", "table.toml"], &d);
        assert_eq!(code, Some(4), "{text}");
        assert!(text.contains("is not in the header's folder") && text.contains(files), "{text}");
        assert!(!text.contains("password") && !text.contains("root:"), "{text}");
    }
}

#[test]
fn meshes_without_bound_are_refused() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let d = dir.path();
    for (far, unit) in [("1e308", "mm"), ("-1e200", "m"), ("1e51", "mm"), ("1e48", "m")] {
        std::fs::write(d.join("far.obj"), obj("a").replacen("v 30 10 60", &format!("v 30 10 {far}"), 1))
            .expect("writable");
        let (code, text) = run(&["inspect", "far.obj", "--unit", unit], d);
        assert_eq!(code, Some(4), "{far}: {text}");
        assert!(text.contains("out of all bounds") && !text.contains("NaN"), "{text}");
    }
    std::fs::write(d.join("near.obj"), obj("a").replacen("v 30 10 60", "v 30 10 1e40", 1)).expect("writable");
    let (code, text) = run(&["inspect", "near.obj"], d);
    assert!(code == Some(0) && !text.contains("NaN") && !text.contains("inf "), "{text}");
}

/// The first request to end is heard although nothing moves: who reads what it prints has gone to
/// sleep.
#[test]
fn the_first_signal_ends_it() {
    for signal in ["-TERM", "-INT"] {
        let dir = tempfile::tempdir().expect("temporary folder");
        let (reader, writer) = std::io::pipe().expect("a pipe");
        let mut full = writer.try_clone().expect("its other end");
        // Kept full; ends with an error when the reader goes.
        let filler = std::thread::spawn(move || full.write_all(&[b' '; 1 << 20]).is_err());
        let mut c = command(&["--json", "plan", &prism(), "-o", "out"], dir.path());
        let child = c.stdout(writer).stderr(Stdio::null()).spawn().expect("the command starts");
        drop(c);
        let pid = child.id().to_string();
        // Until it has said that it wants to hear of signals.
        let begun = Instant::now();
        while !catches_term(&pid) {
            assert!(begun.elapsed() < Duration::from_secs(120), "it does not listen");
            std::thread::sleep(Duration::from_millis(5));
        }
        assert!(Command::new("kill").args([signal, &pid]).status().expect("kill starts").success());
        assert_eq!(ended(child).status.code(), Some(130), "{signal}");
        drop(reader);
        assert!(filler.join().expect("the filler ends"), "the pipe was read");
        assert!(!dir.path().join("out").exists());
    }
}

/// Whether a process has a handler for the request to end.
fn catches_term(pid: &str) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap_or_default();
    let caught = status.lines().find_map(|l| l.strip_prefix("SigCgt:")).map(str::trim).unwrap_or("0");
    u64::from_str_radix(caught, 16).is_ok_and(|mask| mask & (1 << 14) != 0)
}
