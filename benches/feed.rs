//! The feed beside other programs, and all schedules and the feed for 100,000 cutter locations.
//!
//! `cargo bench --bench feed [-- --locations=5000 --model=models/steam_root.step --rough]`.
//!
//! First a helix about an ellipse with the rotary axis following the normal, so that it rushes at
//! the edges: its axis positions are written to a file, with the limits in its first line, and the
//! variable `BLADEWRIGHT_PEERS` may hold commands, one on each line, that plan the fastest motion
//! through the same positions; each is run by the shell with the file's name in `FEED_SAMPLES`, and
//! what it prints is printed beside ours (`tests/motion/peers.py`: toppra and copp). Then the table
//! of seconds.
//!
//! With `--rough` instead: helices about a cylinder with noise on ball centres and angles, as
//! meshes and probes give them; seconds of wall time, peak memory of the process so far, the
//! motion, and the share by which none is proved to be faster.
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::time::Instant;

use bladewright::artifact::schedule::{Measure, ScheduleKind};
use bladewright::artifact::toolpath::{CutterLocation, PathKind};
use bladewright::artifact::{AxisMotion, Cones, Schedule, Toolpath};
use bladewright::channel::{self, ChannelOptions};
use bladewright::error::EndReason;
use bladewright::feed::{self, FeedOptions};
use bladewright::geometry::{Point, Vector};
use bladewright::machine::Machine;
use bladewright::observe::Silent;
use bladewright::path::{self, PathOptions};
use bladewright::read::model::{self, ModelOptions};
use bladewright::schedule::{self, Pace, ScheduleOptions};
use bladewright::tool::{HolderStage, Tool};

const ROUNDS: usize = 21;
const LOCATIONS: f64 = 100_000.0;

/// 20 turns about an ellipse of half axes 22 and 5 mm, and the azimuth of the normal.
fn ellipse(n: usize) -> (Toolpath, Schedule) {
    let mut s_mm = 0.0;
    let mut theta = Vec::with_capacity(n);
    let mut locations: Vec<CutterLocation> = Vec::with_capacity(n);
    for i in 0..n {
        let share = i as f64 / (n - 1) as f64;
        let phi = 20.0 * TAU * share;
        let centre = Point::new(120.0 * share, 22.0 * phi.cos(), 5.0 * phi.sin());
        let raw = (22.0 * phi.sin()).atan2(5.0 * phi.cos());
        let near = theta.last().copied().unwrap_or(raw);
        theta.push(raw + TAU * ((near - raw) / TAU).round());
        s_mm += locations.last().map_or(0.0, |l| (centre - l.centre).norm());
        let normal = Vector::new(0.0, raw.cos(), raw.sin());
        locations.push(CutterLocation {
            turn: 0,
            turn_s_mm: s_mm,
            s_mm,
            centre,
            contact: centre - 8.0 * normal,
            normal,
        });
    }
    (along(locations), Schedule::of_angles(theta))
}

fn along(locations: Vec<CutterLocation>) -> Toolpath {
    Toolpath {
        kind: PathKind::default(),
        radius_mm: 8.0,
        disc_radius_mm: 0.0,
        stock_mm: 0.0,
        scallop_mm: 0.01,
        chord_mm: 0.001,
        region_x_mm: [0.0, 120.0],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.01,
        cones: Cones::about_blade(5f64.to_radians()),
        axis_turning: None,
        turns: Vec::new(),
        locations,
    }
}

/// What is rough about a path.
struct Noise {
    /// Greatest deviation of a ball centre, mm, and of θ, rad.
    centre_mm: f64,
    theta: f64,
    /// Locations that deviate together, as on a facet.
    facet: usize,
    /// Steps are shorter by up to so many powers of ten.
    uneven: f64,
}

/// A helix about a cylinder of radius 20 mm in steps of 0.07 mm.
fn rough_helix(n: usize, noise: &Noise) -> (Toolpath, Schedule) {
    let mut state = 88_172_645_463_325_252u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let (mut s_mm, mut phi, mut off) = (0.0, 0.0f64, [0.0; 3]);
    let mut theta = Vec::with_capacity(n);
    let mut locations: Vec<CutterLocation> = Vec::with_capacity(n);
    for i in 0..n {
        if i % noise.facet == 0 {
            off = [random(), random(), random()];
        }
        phi += 0.07 / 20.0 * 10f64.powf(-noise.uneven * (0.5 + 0.5 * random()).powi(3));
        let r = 28.0 + noise.centre_mm * off[0];
        let centre = Point::new(0.3 * phi / TAU + noise.centre_mm * off[1], r * phi.cos(), r * phi.sin());
        theta.push(phi + 0.3 * (2.0 * phi).sin() + noise.theta * off[2]);
        s_mm += locations.last().map_or(0.0, |l| (centre - l.centre).norm());
        let normal = Vector::new(0.0, phi.cos(), phi.sin());
        let contact = Point::new(centre.x, 20.0 * phi.cos(), 20.0 * phi.sin());
        locations.push(CutterLocation { turn: 0, turn_s_mm: s_mm, s_mm, centre, contact, normal });
    }
    (along(locations), Schedule::of_angles(theta))
}

/// Greatest memory that the process has held so far, MB, where the system tells.
fn peak_mb() -> f64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find(|l| l.starts_with("VmHWM"));
    line.and_then(|l| l.split_whitespace().nth(1)?.parse::<f64>().ok()).unwrap_or(f64::NAN) / 1024.0
}

fn rough(out: &mut String, n: usize) -> Result<(), String> {
    let machine = Machine::demo().map_err(|e| e.message)?;
    let of = |centre_um: f64, theta_mrad: f64, facet: usize, uneven: f64| {
        (centre_um, theta_mrad, Noise { centre_mm: 1e-3 * centre_um, theta: 1e-3 * theta_mrad, facet, uneven })
    };
    let cases =
        [of(0.0, 0.0, 1, 0.0), of(1.0, 0.0, 1, 0.0), of(5.0, 0.5, 1, 0.0), of(5.0, 0.5, 5, 1.0), of(10.0, 1.0, 7, 2.0)];
    for (centre_um, theta_mrad, noise) in cases {
        let (path, schedule) = rough_helix(n, &noise);
        let start = Instant::now();
        let options = FeedOptions::new(2000.0, 60.0);
        let (m, gap) =
            feed::plan_with_bound(&path, &schedule, None, &machine, &options, &Silent).map_err(|e| e.message)?;
        let _ = writeln!(
            out,
            "{n} locations, {centre_um} um and {theta_mrad} mrad, facets of {}, uneven {}: {:.2} s, {:.0} MB so far, motion of {:.2} s, \
             none faster by more than {:.2} %",
            noise.facet,
            noise.uneven,
            start.elapsed().as_secs_f64(),
            peak_mb(),
            m.time_s,
            100.0 * gap.unwrap_or(0.0)
        );
    }
    Ok(())
}

/// Axis limits alone: nothing else slows the motion.
fn axes_alone(limit_jerk: bool) -> FeedOptions {
    FeedOptions { limit_jerk, chord_mm: 1e9, limit_contact: false, ..FeedOptions::new(6e4, 60.0) }
}

/// Median seconds of several runs and the motion.
fn timed(path: &Toolpath, s: &Schedule, machine: &Machine, options: &FeedOptions) -> Result<(f64, AxisMotion), String> {
    let mut seconds = Vec::new();
    let mut last = None;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        last = Some(feed::plan(path, s, machine, options, &Silent).map_err(|e| e.message)?);
        seconds.push(start.elapsed().as_secs_f64());
    }
    seconds.sort_by(f64::total_cmp);
    last.map(|m| (seconds[ROUNDS / 2], m)).ok_or_else(String::new)
}

/// Greatest share of its limit among divided differences of the positions, by order.
fn shares(m: &AxisMotion, machine: &Machine) -> [f64; 3] {
    let mut out = [0.0f64; 3];
    for (k, l) in machine.axes().iter().map(|a| a.limits).enumerate() {
        let mut values: Vec<f64> = m.position.iter().map(|q| q[k]).collect();
        for (order, most) in [l.velocity, l.acceleration, l.jerk].into_iter().enumerate() {
            let span = order + 1;
            let quotient = |i: usize| span as f64 * (values[i + 1] - values[i]) / (m.t_s[i + span] - m.t_s[i]);
            values = (0..values.len() - 1).map(quotient).collect();
            out[order] = out[order].max(values.iter().fold(0.0, |m, v| v.abs().max(m)) / most);
        }
    }
    out
}

fn beside_peers(out: &mut String, n: usize) -> Result<(), String> {
    let machine = Machine::demo().map_err(|e| e.message)?;
    let (path, schedule) = ellipse(n);
    let mut text = String::from("#");
    for l in machine.axes().iter().map(|a| a.limits) {
        let _ = write!(text, " {} {} {}", l.velocity, l.acceleration, l.jerk);
    }
    text.push('\n');
    for (l, theta) in path.locations.iter().zip(&schedule.theta) {
        let q = machine.inverse(&l.centre, *theta, 5f64.to_radians(), 60.0);
        let _ = writeln!(text, "{},{},{},{},{},{}", l.s_mm, q[0], q[1], q[2], q[3], q[4]);
    }
    let file = std::env::temp_dir().join(format!("bladewright-feed-{}.csv", std::process::id()));
    std::fs::write(&file, text).map_err(|e| e.to_string())?;
    for command in std::env::var("BLADEWRIGHT_PEERS").unwrap_or_default().lines().filter(|l| !l.trim().is_empty()) {
        match std::process::Command::new("sh").args(["-c", command]).env("FEED_SAMPLES", &file).output() {
            Ok(done) => {
                let _ =
                    writeln!(out, "{}{}", String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
            }
            Err(e) => {
                let _ = writeln!(out, "{command}: {e}");
            }
        }
    }
    let _ = std::fs::remove_file(&file);
    for (name, jerk) in [("velocity, acceleration", false), ("velocity, acceleration, jerk", true)] {
        let (seconds, m) = timed(&path, &schedule, &machine, &axes_alone(jerk))?;
        let share = shares(&m, &machine);
        let _ = writeln!(
            out,
            "bladewright, {name}: {n} samples, motion of {:.4} s found in {:.4} s ({:.0} samples a second); limits used to \
             {:.5} {:.5} {:.5}",
            m.time_s,
            seconds,
            n as f64 / seconds,
            share[0],
            share[1],
            share[2]
        );
    }
    Ok(())
}

fn table(out: &mut String, model: &Path) -> Result<(), String> {
    let blade = model::load(model, &ModelOptions::default(), &Silent).map_err(|e| e.message)?;
    let tool = Tool {
        radius_mm: 8.0,
        corner_radius_mm: None,
        taper_deg: 3.0,
        shank_radius_mm: 12.0,
        stickout_mm: 100.0,
        holder: vec![HolderStage { radius_mm: 25.0, length_mm: 60.0 }],
    };
    let mut options = PathOptions::new(tool.radius_mm, 0.01);
    let first = path::plan(&blade, &options, &Silent).map_err(|e| e.message)?;
    let length = first.locations.last().map_or(1.0, |l| l.s_mm);
    options.settings.max_step_mm = (length / LOCATIONS).min(options.settings.max_step_mm);
    let path = path::plan(&blade, &options, &Silent).map_err(|e| e.message)?;
    let channel = channel::plan(&blade, &tool, &path, &ChannelOptions::default(), &Silent).map_err(|e| e.message)?;
    let machine = Machine::demo().map_err(|e| e.message)?;
    let feed = FeedOptions::new(2000.0, tool.length_mm());
    let (f, a) = (feed.settings.feed_mm_min / 60.0, machine.axes()[machine.turning_axis()].limits);
    let pace = Some(Pace { rate: a.velocity / f, second: a.acceleration / (f * f), standing_mm: 0.0 });
    let _ = writeln!(out, "{}: {} cutter locations, {length:.0} mm", model.display(), path.locations.len());
    let kinds = [
        ("fixed", ScheduleKind::Fixed, Measure::default()),
        ("quaternion", ScheduleKind::Quaternion, Measure::default()),
        ("piecewise", ScheduleKind::Piecewise, Measure::default()),
        ("optimal, peak of second", ScheduleKind::Optimal, Measure::PeakSecond),
        ("optimal, peak of third", ScheduleKind::Optimal, Measure::PeakThird),
        ("optimal, square of second", ScheduleKind::Optimal, Measure::SquareSecond),
        ("optimal, square of third", ScheduleKind::Optimal, Measure::SquareThird),
        ("time (its own candidate)", ScheduleKind::Time, Measure::default()),
    ];
    let _ = writeln!(out, "{:28} {:>10} {:>16} {:>22}", "schedule", "s", "feed, no jerk: s", "feed within jerk: s");
    for (name, kind, measure) in kinds {
        let options = ScheduleOptions { pace, ..ScheduleOptions::default() }.with(|s| s.measure = measure);
        let start = Instant::now();
        let made = match schedule::plan(kind, &path, &channel, &options, &Silent) {
            Ok(s) => s,
            Err(e) => {
                let _ = writeln!(out, "{name:28} {}", e.message);
                continue;
            }
        };
        let seconds = start.elapsed().as_secs_f64();
        let of = |limit_jerk: bool| {
            let run = || {
                let start = Instant::now();
                let m = feed::plan(&path, &made, &machine, &FeedOptions { limit_jerk, ..feed }, &Silent);
                m.map(|m| (start.elapsed().as_secs_f64(), m.time_s))
            };
            let runs: Result<Vec<_>, _> = (0..if limit_jerk { 3 } else { 9 }).map(|_| run()).collect();
            let least = runs.map(|r| r.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default());
            least.map(|(s, motion_s)| format!("{s:.3} ({motion_s:.1} s)")).unwrap_or_else(|e| e.message)
        };
        let _ = writeln!(out, "{name:28} {seconds:>10.2} {:>16} {:>22}", of(false), of(true));
    }
    Ok(())
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let option = |key: &str| arguments.iter().find_map(|a| a.strip_prefix(key).map(str::to_owned));
    let n = option("--locations=").and_then(|n| n.parse().ok()).unwrap_or(5000);
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let model = option("--model=").map_or_else(|| root.join("models/steam_root.step"), Into::into);
    let mut out = String::new();
    let done = if arguments.iter().any(|a| a == "--rough") {
        vec![rough(&mut out, n)]
    } else {
        vec![beside_peers(&mut out, n), table(&mut out, &model)]
    };
    for e in done.into_iter().filter_map(Result::err) {
        let _ = writeln!(out, "{e}");
    }
    let _ = std::io::stdout().write_all(out.as_bytes());
}
