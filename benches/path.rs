//! Cutter locations a second, and closed loops of ball centres at given heights ("levels") beside
//! other programs.
//!
//! `cargo bench --bench path [-- model.step ... --heights=13,33,53 --radius=3]`; without models the
//! project's `compressor_twist`. Each model with exact faces is measured twice: as it is, and as a
//! mesh of at least 200,000 triangles made from it. Printed are the helix of about 100,000
//! locations (wall time on all threads, peak memory of the process so far), and the levels
//! (computing time of one thread, median of several runs, with the greatest error of the loops: of
//! its points, and of its chords).
//!
//! The variable `BLADEWRIGHT_PEERS` may hold commands, one on each line, that measure other
//! programs on the same model; each is run by the shell before ours and what it prints is printed
//! here.
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use bladewright::artifact::Blade;
use bladewright::artifact::region::Extent;
use bladewright::artifact::toolpath::PathKind;
use bladewright::geometry::part::Part;
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};

const LOCATIONS: f64 = 100_000.0;
const TRIANGLES: usize = 200_000;
const ROUNDS: usize = 5;
/// Times all levels in a round: some systems count computing time in ticks of milliseconds.
const TIMES: usize = 20;

/// Greatest memory that the process has held so far, MB, where the system tells.
fn peak_mb() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("VmHWM"));
    line.and_then(|l| l.split_whitespace().nth(1)?.parse::<f64>().ok()).unwrap_or(f64::NAN) / 1024.0
}

/// Time that this thread has spent computing, where the system tells, else wall time, s: other
/// programs must not count.
fn now(start: &Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let ns = told.as_deref().and_then(|t| t.split_whitespace().next()).and_then(|w| w.parse::<f64>().ok());
    ns.map_or_else(|| start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// The helix, with steps such that it has about the number of locations wanted.
fn helix(out: &mut String, name: &str, blade: &Blade, radius_mm: f64, kind: PathKind) {
    let mut options = PathOptions::new(radius_mm, 0.01).with(|s| s.kind = kind);
    let [a, b] = blade.regions.airfoil_x_mm();
    options.extent = Extent::heights(Some(b - 0.2 * (b - a)), Some(a + 0.4 * (b - a)));
    let first = path::plan(blade, &options, &Silent);
    if let Ok(p) = &first {
        options.settings.max_step_mm =
            (p.locations.last().map_or(1.0, |l| l.s_mm) / LOCATIONS).min(options.settings.max_step_mm);
    }
    let start = Instant::now();
    match path::plan(blade, &options, &Silent) {
        Ok(p) => {
            let (seconds, n) = (start.elapsed().as_secs_f64(), p.locations.len() as f64);
            *out += &format!(
                "{name:34} {kind:?}: {n:.0} locations, {} turns in {seconds:.2} s, {:.2} s for 100,000; {:.0} MB\n",
                p.turns.len(),
                seconds * LOCATIONS / n,
                peak_mb()
            );
        }
        Err(e) => *out += &format!("{name}: {}\n", e.message),
    }
}

/// Distance of the points of a loop, and of places on its chords, from the surface of ball centres,
/// mm.
fn errors(blade: &Blade, radius_mm: f64, centres: &[bladewright::geometry::Point]) -> [f64; 2] {
    let off = |q| blade.part.closest(&q, 10.0 * radius_mm).map_or(f64::NAN, |c| (c.distance_mm - radius_mm).abs());
    let n = centres.len();
    let points = centres.iter().map(|c| off(*c)).fold(0.0, f64::max);
    let chords = (0..n).map(|i| off(nalgebra::center(&centres[i], &centres[(i + 1) % n]))).fold(0.0, f64::max);
    [points, chords]
}

fn levels(out: &mut String, name: &str, blade: &Blade, radius_mm: f64, heights: &[f64]) {
    let options = PathOptions::new(radius_mm, 0.01);
    let (mut times, mut worst, mut points) = (Vec::new(), [0.0f64; 2], 0);
    let start = Instant::now();
    for round in 0..ROUNDS {
        let from = now(&start);
        let mut loops = Vec::new();
        for x in (0..TIMES).flat_map(|_| heights) {
            match path::level(blade, &options, *x) {
                Ok(l) => loops.push(l.iter().map(|t| t.centre).collect::<Vec<_>>()),
                Err(e) => {
                    *out += &format!("{name}: {}\n", e.message);
                    return;
                }
            }
        }
        times.push((now(&start) - from) / (TIMES * heights.len()) as f64);
        if round == 0 {
            points = loops.iter().take(heights.len()).map(Vec::len).sum();
            for e in loops.iter().take(heights.len()).map(|l| errors(blade, radius_mm, l)) {
                worst = [worst[0].max(e[0]), worst[1].max(e[1])];
            }
        }
    }
    times.sort_by(f64::total_cmp);
    *out += &format!(
        "{name:34} level: {:.3} ms (of {} levels, {points} points), {:.4} um off at points, {:.3} um on chords\n",
        1e3 * times[ROUNDS / 2],
        heights.len(),
        1e3 * worst[0],
        1e3 * worst[1]
    );
}

/// A mesh of at least so many triangles, from the exact faces.
fn as_mesh(blade: &Blade) -> Option<Blade> {
    let brep = blade.part.brep.clone()?;
    let mut deflection_mm = blade.part.deflection_mm.max(1e-4);
    let mut part = Part::meshed(brep.clone(), deflection_mm, &Silent).ok()?;
    while part.mesh.triangles.len() < TRIANGLES && deflection_mm > 1e-5 {
        deflection_mm *= 0.5;
        part = Part::meshed(brep.clone(), deflection_mm, &Silent).ok()?;
    }
    Some(Blade { part: Part::from_mesh(part.mesh), ..blade.clone() })
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let option = |key: &str| arguments.iter().find_map(|a| a.strip_prefix(key).map(str::to_owned));
    let radius_mm = option("--radius=").and_then(|r| r.parse().ok()).unwrap_or(3.0);
    let given: Option<Vec<f64>> = option("--heights=").map(|h| h.split(',').filter_map(|x| x.parse().ok()).collect());
    let mut models: Vec<PathBuf> = arguments.iter().filter(|a| !a.starts_with("--")).map(PathBuf::from).collect();
    if models.is_empty() {
        models.push(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("models/compressor_twist.step"));
    }
    let mut out = String::new();
    for command in std::env::var("BLADEWRIGHT_PEERS").unwrap_or_default().lines().filter(|l| !l.trim().is_empty()) {
        match std::process::Command::new("sh").args(["-c", command]).output() {
            Ok(done) => out += &format!("{command}\n  {}\n", String::from_utf8_lossy(&done.stdout).trim()),
            Err(e) => out += &format!("{command}: {e}\n"),
        }
    }
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    for path in models {
        let name = path.file_stem().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let blade = match model::load(&path, &ModelOptions::default(), &Silent) {
            Ok(b) => b,
            Err(e) => {
                out += &format!("{name}: {}\n", e.message);
                continue;
            }
        };
        let [a, b] = blade.regions.airfoil_x_mm();
        let spread = || (1..=5).map(|k| a + (b - a) * (0.2 + 0.1 * f64::from(k))).collect();
        let heights = given.clone().unwrap_or_else(spread);
        let mesh = as_mesh(&blade);
        for (form, blade) in [("exact", Some(&blade)), ("mesh", mesh.as_ref())] {
            let Some(blade) = blade else { continue };
            let name = format!("{name}, {form}, {} tri", blade.part.mesh.triangles.len());
            if let Ok(pool) = &one_thread {
                pool.install(|| levels(&mut out, &name, blade, radius_mm, &heights));
            }
            for kind in [PathKind::ConstantHeight, PathKind::ConstantScallop] {
                helix(&mut out, &name, blade, radius_mm, kind);
            }
        }
    }
    let _ = std::io::stdout().write_all(out.as_bytes());
}
