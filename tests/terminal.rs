//! How the command speaks on a terminal, and elsewhere. The terminal is a pseudo terminal of
//! `script` (util-linux).
#![cfg(target_os = "linux")]

use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Runs a command line on a terminal of its own; what was shown.
fn on_terminal(line: &str, no_color: bool, dir: &Path) -> String {
    let mut c = Command::new("script");
    c.args(["-qec", line, "/dev/null"]).current_dir(dir).stdin(Stdio::null());
    c.env("BLADEWRIGHT", env!("CARGO_BIN_EXE_bladewright")).env("TERM", "xterm-256color").env_remove("NO_COLOR");
    if no_color {
        c.env("NO_COLOR", "1");
    }
    let run = c.output().expect("this test needs `script` of util-linux (Debian: bsdutils)");
    String::from_utf8_lossy(&run.stdout).into_owned()
}

/// Escape sequences that change colour or weight of letters.
fn coloured(text: &str) -> bool {
    let sequences = text.split("\u{1b}[").skip(1);
    sequences
        .filter_map(|s| s.find(|c: char| !(c.is_ascii_digit() || c == ';')).map(|k| &s[k..]))
        .any(|s| s.starts_with('m'))
}

fn plain(args: &[&str], dir: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bladewright")).args(args).current_dir(dir).output().expect("the command starts")
}

fn model() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models/prism.step").display().to_string()
}

#[test]
fn no_color_is_kept() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let plan = format!("\"$BLADEWRIGHT\" plan {} -o out --until path --set region.start_mm=7", model());
    for line in ["\"$BLADEWRIGHT\" plan", "\"$BLADEWRIGHT\" --help", "\"$BLADEWRIGHT\" verify nowhere", &plan] {
        let text = on_terminal(line, true, dir.path());
        assert!(!text.is_empty() && !coloured(&text), "{line}: {text:?}");
    }
    // Where it is not asked for, there are colours: else the above would tell nothing.
    let text = on_terminal("\"$BLADEWRIGHT\" plan", false, dir.path());
    assert!(coloured(&text), "{text:?}");
}

#[test]
fn progress_is_for_terminals() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let args = ["plan", &model(), "-o", "out", "--until", "channel", "--set", "region.start_mm=7"];
    let line = format!("\"$BLADEWRIGHT\" {}", args.join(" "));
    let text = on_terminal(&line, true, dir.path());
    assert!(text.contains("path") && text.contains("(left ") && text.contains("/s"), "rate and time left: {text:?}");
    let quiet = on_terminal(&line.replace("plan", "--quiet plan"), true, dir.path());
    assert!(!quiet.contains("(left "), "{quiet:?}");
    let out = plain(&args, dir.path());
    let told = String::from_utf8_lossy(&out.stderr).into_owned() + &String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success() && !told.contains('\u{1b}') && !told.contains("(left "), "{told:?}");
}

#[test]
fn help_teaches_with_examples() {
    let dir = tempfile::tempdir().expect("temporary folder");
    let help = |args: &[&str]| String::from_utf8_lossy(&plain(args, dir.path()).stdout).into_owned();
    let all = help(&["--help"]);
    assert!(all.contains("Examples"), "{all}");
    for verb in
        ["inspect", "make", "plan", "compare", "batch", "verify", "post", "preview", "plot", "completions", "man"]
    {
        assert!(all.contains(verb), "{verb} is missing in {all}");
        let own = help(&[verb, "--help"]);
        assert!(own.contains("Examples") && own.contains(&format!("bladewright {verb}")), "{verb}: {own}");
    }
}
