//! A table of what `inspect` and `plan` make of every file in the folder that `BLADEWRIGHT_BLADES`
//! names, beside what is known of the file. Fails where a file makes the program panic, takes more
//! than [`SECONDS`] or more than [`MEGABYTES`], and where something is recognised wrongly without a
//! word that it is not certain. `just corpus-table` prints it.

#![allow(clippy::print_stdout)]

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Most seconds that a file may take.
const SECONDS: u64 = 60;
/// Most memory that a file may take, MB.
const MEGABYTES: u64 = 2048;
/// An axis within this angle of the true one is right, degrees.
const AXIS_DEG: f64 = 15.0;

/// What is known of a file.
struct Truth {
    file: &'static str,
    unit: &'static str,
    closed: bool,
    /// Blade axis in either sense; `None`: there is no single blade.
    axis: Option<[f64; 3]>,
    /// Rotor axis of a whole wheel, which each of its blades stands off.
    rotor: Option<[f64; 3]>,
}

const X: Option<[f64; 3]> = Some([1.0, 0.0, 0.0]);
const Y: Option<[f64; 3]> = Some([0.0, 1.0, 0.0]);
const Z: Option<[f64; 3]> = Some([0.0, 0.0, 1.0]);

const fn truth(file: &'static str, unit: &'static str, closed: bool, axis: Option<[f64; 3]>) -> Truth {
    Truth { file, unit, closed, axis, rotor: None }
}

const fn wheel(file: &'static str, unit: &'static str, closed: bool, rotor: [f64; 3]) -> Truth {
    Truth { file, unit, closed, axis: None, rotor: Some(rotor) }
}

const TRUTHS: [Truth; 22] = [
    truth("airfoil_22dx_single_surface.igs", "mm", false, Y),
    truth("centrifugal_impeller.stl", "mm", true, None),
    truth("p4119_DERIVED_loft_mm.step", "mm", true, Y),
    // From the middle of one end face to that of the other, by OpenCASCADE.
    truth("fan_DERIVED_loft.step", "mm", true, Some([0.313, 0.912, 0.261])),
    truth("hecc_main_DERIVED_loft_mm.step", "mm", true, None),
    truth("IEA-15-240-RWT_blade.stl", "m", true, Z),
    truth("IEA_15MW_CFD.stp", "m", false, Z),
    // Closed once its degenerate triangles are gone; the next too.
    truth("je1_propeller_blade_ascii.stl", "m", true, X),
    truth("pyturbo_blade.stl", "m", true, Z),
    truth("kaplan_blade_DERIVED_from_brep.step", "mm", false, X),
    wheel("openfoam_propeller.obj", "m", false, [0.0, 1.0, 0.0]),
    truth("rotor37_DERIVED_loft_mm.step", "mm", true, Z),
    truth("case7288_rotor_blade.step", "mm", true, Z),
    truth("case7288_rotor_hubwedge.step", "mm", true, Z),
    truth("case7288_rotor_hubwedge.iges", "mm", true, Z),
    truth("turbine_blade_firtree.igs", "mm", true, Z),
    truth("turbine_blade_scan.stl", "m", true, Some([-0.09, 0.91, 0.41])),
    truth("turbocharger_turbine_sector.stl", "mm", true, Z),
    truth("stage1_rotor.step", "mm", true, Z),
    truth("stage2_rotor.step", "mm", true, Z),
    truth("stage4_rotor.step", "mm", true, Z),
    // An open shell in the file, but its four faces meet all round once it is read in metres.
    truth("vki_blade_metres_open_shell.step", "m", true, X),
];

/// A run of the command under the limits.
struct Run {
    code: Option<i32>,
    stdout: String,
    stderr: String,
    seconds: f64,
    megabytes: u64,
    /// The limit that ended it.
    stopped: Option<&'static str>,
}

fn run(args: &[&str], model: &Path) -> Run {
    let folder = tempfile::tempdir().expect("temporary folder");
    let file = |name: &str| std::fs::File::create(folder.path().join(name)).expect("writable");
    let begin = Instant::now();
    let mut command = Command::new(env!("CARGO_BIN_EXE_bladewright"));
    command.arg("--quiet").arg(args[0]).arg(model).args(&args[1..]).current_dir(folder.path());
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::from(file("stdout")))
        .stderr(Stdio::from(file("stderr")))
        .spawn()
        .expect("the command starts");
    let (mut megabytes, mut stopped) = (0, None);
    let code = loop {
        if let Some(status) = child.try_wait().expect("waiting") {
            break status.code();
        }
        megabytes = megabytes.max(peak_megabytes(child.id()));
        let limit = match () {
            () if begin.elapsed() > Duration::from_secs(SECONDS) => Some("time"),
            () if megabytes > MEGABYTES => Some("memory"),
            () => None,
        };
        if limit.is_some() && stopped.is_none() {
            stopped = limit;
            child.kill().expect("the child can be ended");
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap_or_default();
    Run {
        code,
        stdout: text("stdout"),
        stderr: text("stderr"),
        seconds: begin.elapsed().as_secs_f64(),
        megabytes,
        stopped,
    }
}

/// Greatest memory of a process so far, MB; 0 where the system does not tell.
fn peak_megabytes(id: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|kb| kb.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// The value of a line of `inspect`.
fn value<'a>(text: &'a str, key: &str) -> &'a str {
    text.lines().find_map(|l| l.strip_prefix(key)).unwrap_or("").trim()
}

/// The blade's x axis of the frame that `inspect` prints.
fn axis(text: &str) -> Option<[f64; 3]> {
    let line = text.lines().find(|l| l.trim_start().starts_with("x = (") && l.starts_with("           x"))?;
    let numbers = line.split(['(', ')']).nth(1)?;
    let v: Vec<f64> = numbers.split(',').filter_map(|x| x.trim().parse().ok()).collect();
    v.try_into().ok()
}

fn off_deg(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    (dot(a, b).abs() / (dot(a, a) * dot(b, b)).sqrt()).min(1.0).acos().to_degrees()
}

/// How a finding ends that the report itself doubts.
const UNSURE: &str = ", said to be uncertain";

/// "right", or what is wrong, and whether the report says itself that it is not sure.
fn judge(truth: &Truth, text: &str) -> String {
    let mut wrong = Vec::new();
    let unit = value(text, "unit ").split([',', ' ']).next().unwrap_or("").to_owned();
    if unit != truth.unit {
        let told = if text.contains("the unit is not certain") { UNSURE } else { "" };
        wrong.push(format!("unit ({} in truth){told}", truth.unit));
    }
    if value(text, "closed ").starts_with("yes") != truth.closed {
        wrong.push("closedness".into());
    }
    let unsure = text.contains("not certain") || text.contains("only partly") || text.contains("no section looks");
    let across = |a: [f64; 3]| truth.rotor.is_some_and(|r| (0..3).map(|k| r[k] * a[k]).sum::<f64>().abs() < 0.5);
    match (truth.axis, axis(text)) {
        (None, None) => {}
        (None, Some(a)) if across(a) => {}
        (None, Some(_)) if unsure => wrong.push(format!("an axis of what has no single one{UNSURE}")),
        (None, Some(_)) => wrong.push("an axis of what has none".into()),
        (Some(_), None) => wrong.push("axis not found".into()),
        (Some(t), Some(a)) if off_deg(t, a) > AXIS_DEG => {
            let told = if unsure { UNSURE } else { "" };
            wrong.push(format!("axis by {:.0}°{told}", off_deg(t, a)));
        }
        _ => {}
    }
    if wrong.is_empty() { "right".into() } else { format!("wrong: {}", wrong.join("; ")) }
}

/// The first error, without folders.
fn message(run: &Run) -> String {
    if let Some(limit) = run.stopped {
        return format!("stopped at the limit of {limit}");
    }
    let line =
        run.stderr.lines().find(|l| l.starts_with("error: ")).or(run.stdout.lines().find(|l| l.contains("finding:")));
    let words: Vec<&str> = line.unwrap_or("").split(' ').map(|w| w.rsplit('/').next().unwrap_or(w)).collect();
    words.join(" ").chars().take(170).collect()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let (mut open, mut out) = (vec![folder.to_path_buf()], Vec::new());
    while let Some(dir) = open.pop() {
        for entry in std::fs::read_dir(dir).expect("readable") {
            let path = entry.expect("entry").path();
            let ext = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
            if path.is_dir() {
                open.push(path);
            } else if !["md", "png", "json"].contains(&ext.as_str()) {
                out.push(path);
            }
        }
    }
    out.sort();
    out
}

#[test]
#[ignore = "real blades, see the file's head"]
fn every_blade_inspected_and_planned() {
    let folder = std::env::var_os("BLADEWRIGHT_BLADES").map(PathBuf::from);
    let folder = folder.expect("BLADEWRIGHT_BLADES names the folder of real blades");
    let mut failed = Vec::new();
    println!("| file | inspect: unit; closed; axis | right? | s | MB | plan | s | MB |");
    println!("| --- | --- | --- | ---: | ---: | --- | ---: | ---: |");
    for path in files(&folder) {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let seen = run(&["inspect"], &path);
        let (said, right) = if seen.code == Some(0) {
            let unit = value(&seen.stdout, "unit ").split(',').next().unwrap_or("").to_owned();
            let guessed = if value(&seen.stdout, "unit ").contains("guessed") { " (guessed)" } else { "" };
            let closed = value(&seen.stdout, "closed ").split(" in ").next().unwrap_or("").to_owned();
            let axis = axis(&seen.stdout).map_or("none".into(), |a| format!("({:.2}, {:.2}, {:.2})", a[0], a[1], a[2]));
            let truth = TRUTHS.iter().find(|t| t.file == name);
            (format!("{unit}{guessed}; {closed}; {axis}"), truth.map_or("–".into(), |t| judge(t, &seen.stdout)))
        } else {
            (message(&seen), "–".into())
        };
        let mut plan = run(&["plan", "-o", "out"], &path);
        let mut how = String::new();
        if plan.stderr.contains("pass --unit m") {
            (plan, how) = (run(&["plan", "-o", "out", "--unit", "m"], &path), "--unit m: ".into());
        }
        let result = match plan.code {
            Some(0) if plan.stopped.is_none() => "runs".to_owned(),
            code => format!("{}: {}", code.map_or("ended".into(), |c| c.to_string()), message(&plan)),
        };
        if right.starts_with("wrong") && right.split("; ").any(|w| !w.ends_with(UNSURE)) {
            failed.push(format!("inspect {name}: {right}"));
        }
        println!(
            "| {name} | {said} | {right} | {:.1} | {} | {how}{result} | {:.1} | {} |",
            seen.seconds, seen.megabytes, plan.seconds, plan.megabytes
        );
        for (verb, run) in [("inspect", &seen), ("plan", &plan)] {
            let panicked = run.stderr.contains("panicked") || !matches!(run.code, Some(0..=4));
            if panicked && run.stopped.is_none() {
                failed.push(format!("{verb} {name} panicked:\n{}", run.stderr));
            }
            // Planning with every default may take long on a large blade; looking at a file may
            // not.
            if verb == "inspect"
                && let Some(limit) = run.stopped
            {
                failed.push(format!("{verb} {name}: {limit}"));
            }
        }
    }
    assert!(failed.is_empty(), "{}", failed.join("\n"));
}
