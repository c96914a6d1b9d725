//! `channel` and `advise`: the S–θ channel by itself.

use std::f64::consts::TAU;
use std::fmt::Write;

use super::args::{Advise, Channel};
use super::out::{limit, sayln};
use super::plan::{draft_from, draft_of};
use super::progress::Terminal;
use crate::artifact::Toolpath;
use crate::artifact::channel::{Binding, Width};
use crate::channel::{self, FreeInterval, Leans};
use crate::error::{Error, Result, Stage, turn_number};
use crate::geometry::Vector;
use crate::geometry::part::Part;
use crate::observe::Observer;
use crate::plan::Setup;
use crate::plan::pinch::LeanPair;
use crate::run::{self, Loaded, RunFolder};
use crate::write::draw;

/// Angles B that advice looks at: from, to, step, degrees.
const ANGLES_DEG: [f64; 3] = [-20.0, 45.0, 2.5];
/// For each of two tools.
const PAIR_ANGLES_DEG: [f64; 3] = [-20.0, 45.0, 5.0];
/// Pairs of leans that are printed.
const BEST_PAIRS: usize = 5;

/// Cells of the sphere lie within this of their middle where they are not decided, degrees.
const FINEST_DEG: f64 = 0.5;
/// Steps of the lines that are drawn on it, rad.
const STEP_RAD: f64 = 0.02;

/// Runs `channel`; the exit code.
pub fn run(args: &Channel, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let ended = study(args, &terminal);
    terminal.finish();
    ended
}

fn study(args: &Channel, observer: &dyn Observer) -> Result<u8> {
    let mut folder = RunFolder::begin(&args.job.out)?;
    let setup = Loaded::read(&draft_of(&args.job)?, observer)?.setup;
    folder.add_job_of_study(&setup.job.to_toml()?)?;
    let toolpath = setup.path(observer)?;
    let (around, options, tool) = (setup.surroundings()?, setup.channel_options(), &setup.job.tool);
    if args.sweep_b.is_some() {
        for_one_cone(&setup, "--sweep-b")?;
    }
    let (toolpath, _) = setup.oriented(toolpath, &around, observer)?;
    let intervals = channel::intervals(&around, tool, &toolpath, &options, observer)?;
    folder.add("channel_intervals.csv", table(&toolpath, &intervals, &setup.blade.part))?;
    let planned = channel::plan_among(&around, tool, &toolpath, &options, observer);
    if let Ok(channel) = &planned {
        folder.add("channel.json", run::json_compact(channel)?)?;
    }
    if let Some(sweep) = args.sweep_b {
        let angles = setup.angles_b(sweep.0);
        let leans = Leans { b_deg: &angles, places: toolpath.locations.len() };
        let widths = channel::sweep_b(&around, tool, &toolpath, &options, leans, observer)?;
        folder.add("sweep_b.csv", draw::widths_csv(&widths))?;
        folder.add_json("sweep_b.json", &widths)?;
        folder.add("sweep_b.svg", draw::widths_svg(&widths))?;
        print_widths(&widths);
    }
    if let Some(at) = args.sphere {
        let narrowest = || planned.as_ref().map_or_else(|_| least_free(&intervals), |c| c.narrowest_row);
        let row = at.0.unwrap_or_else(narrowest);
        let found = channel::sphere(&around, tool, (&toolpath, row), &options, FINEST_DEG)?;
        let cone = toolpath.cone(row);
        let axes = |from: f64, to: f64| -> Vec<Vector> {
            let steps = ((to - from) / STEP_RAD).ceil().max(1.0);
            (0..=steps as usize).map(|k| cone.tool_axis(from + (to - from) * k as f64 / steps)).collect()
        };
        let free: Vec<Vec<Vector>> = intervals[row].iter().map(|f| axes(f.theta_min, f.theta_max)).collect();
        let normal = &toolpath.locations[row].normal;
        folder.add("sphere.csv", draw::sphere_csv(&found, |b| name(b, &setup.blade.part)))?;
        folder.add("sphere.svg", draw::sphere_svg(&found, normal, &axes(0.0, TAU), &free))?;
        let [is_free, _, open] = found.shares().map(|s| 100.0 * s);
        sayln!("location {row}: {is_free:.1} % of all tool axes are free, {open:.1} % are not decided");
    }
    let closed = intervals.iter().filter(|l| l.is_empty()).count();
    sayln!("{} cutter locations, {closed} of them without a free angle", intervals.len());
    for file in folder.finish()? {
        sayln!("{}", file.display());
    }
    let channel = planned?;
    let width = channel.rows.get(channel.narrowest_row).map_or(0.0, |r| r.hull_max - r.hull_min);
    sayln!("narrowest between the monotone hulls: {:.3}°; separate channels: {}", width.to_degrees(), channel.chains);
    Ok(0)
}

/// The first location with least free angles.
fn least_free(intervals: &[Vec<FreeInterval>]) -> usize {
    let width = |free: &Vec<FreeInterval>| free.iter().map(|f| f.theta_max - f.theta_min).sum::<f64>();
    let widths = intervals.iter().map(width).enumerate();
    widths.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(row, _)| row)
}

/// `channel_intervals.csv`: one row per free interval of a location; angles in degrees.
fn table(path: &Toolpath, intervals: &[Vec<FreeInterval>], part: &Part) -> String {
    let mut out = String::from("location,turn,S,interval,theta_min_deg,theta_max_deg,binds_min,binds_max\n");
    for (i, (l, here)) in path.locations.iter().zip(intervals).enumerate() {
        for (k, f) in here.iter().enumerate() {
            let _ = writeln!(
                out,
                "{i},{},{},{k},{},{},{},{}",
                l.turn,
                l.turn_s_mm,
                f.theta_min.to_degrees(),
                f.theta_max.to_degrees(),
                name(&f.binds_min, part),
                name(&f.binds_max, part)
            );
        }
    }
    out
}

/// A binding as one cell of a table.
fn name(b: &Binding, part: &Part) -> String {
    let plain = |text: &str| text.replace([',', '\n', '"'], " ");
    match b {
        Binding::Part { tool, face, triangle } => {
            format!("{tool} / part / {} / triangle {triangle}", plain(&part.face_name(*face)))
        }
        Binding::Fixture { name, tool, triangle } => format!("{tool} / {} / triangle {triangle}", plain(name)),
        Binding::AxisLimit => "rotary axis".into(),
        Binding::Travel { axis } => format!("travel of {}", plain(axis)),
        Binding::ContactAngle => "contact angle".into(),
        Binding::Free => "nothing".into(),
    }
}

fn print_widths(widths: &[Width]) {
    sayln!("{:>8} {:>12} {:>12}  narrowest at", "B", "narrowest", "monotone");
    for w in widths {
        let number = |v: Option<f64>| v.map_or_else(|| "closed".to_owned(), |v| format!("{v:.2}°"));
        let (a, b) = (number(w.narrowest_deg), number(w.monotone_deg));
        sayln!(
            "{:>7}° {a:>12} {b:>12}  turn {}, S = {:.2} mm: {}",
            limit(w.b_deg),
            turn_number(w.turn),
            w.turn_s_mm,
            w.binds
        );
    }
}

/// Refuses what looks at leans of one cone where the job gives each location its own.
fn for_one_cone(setup: &Setup, what: &str) -> Result<()> {
    if setup.job.orientation.kind.goes_round() {
        return Ok(());
    }
    let message = format!("{what} looks for a lean that stays the same, the job gives each location its own tool axes");
    Err(Error::usage(Stage::Channel, message)
        .advise("leave out orientation.kind, or run `channel` without `--sweep-b`"))
}

/// Runs `advise`; the exit code.
pub fn advise(args: &Advise, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let ended = advice(args, &terminal);
    terminal.finish();
    ended
}

fn advice(args: &Advise, observer: &dyn Observer) -> Result<u8> {
    let setup = Loaded::read(&draft_from(&args.input, &args.reading, &args.set)?, observer)?.setup;
    if args.pinch {
        return pair_advice(args, &setup, observer);
    }
    for_one_cone(&setup, "advise")?;
    let toolpath = setup.path(observer)?;
    let (around, options, tool) = (setup.surroundings()?, setup.channel_options(), &setup.job.tool);
    let angles = setup.angles_b(ANGLES_DEG);
    let found = channel::advise(&around, tool, &toolpath, &options, &angles, observer)?;
    let now = &found.now;
    let row = |name: &str, value: String| sayln!("{name:<34} {value}");
    row(
        "channel as the job has it",
        match now.monotone_deg {
            Some(w) if w >= 0.0 && found.corner.is_some() => format!("open, {w:.2}° wide at the narrowest place"),
            Some(w) if w >= 0.0 => format!("open, {w:.2}° between the monotone hulls at the narrowest place"),
            Some(w) => format!("no schedule without turning back: the hulls cross by {:.2}°", -w),
            None => "closed".into(),
        },
    );
    row("decided at", format!("turn {}, S = {:.2} mm: {}", turn_number(now.turn), now.turn_s_mm, now.binds));
    let ranges: Vec<String> = found.b_ranges_deg.iter().map(|[a, b]| format!("{a:.1}° to {b:.1}°")).collect();
    let looked = angles
        .first()
        .zip(angles.last())
        .map_or_else(String::new, |(a, b)| format!(" within {}° to {}°", limit(*a), limit(*b)));
    row("B that opens it", if ranges.is_empty() { format!("none{looked}") } else { ranges.join(", ") + &looked });
    if let Some(b) = found.best_b_deg {
        row("widest at B", format!("{}°", limit(b)));
    }
    let mm =
        |v: Option<f64>, digits: usize, none: &str| v.map_or_else(|| none.to_owned(), |v| format!("{v:.digits$} mm"));
    let now_mm = format!(" (now {:.1} mm)", tool.stickout_mm);
    row("least stick-out that opens it", mm(found.least_stickout_mm, 1, "none") + &now_mm);
    let radii =
        found.holder_radii_mm.as_ref().map(|r| r.iter().map(|v| format!("{v:.1}")).collect::<Vec<_>>().join(", "));
    row(
        "thickest holder that opens it",
        radii.map_or_else(|| "none, not even as thin as the shank".into(), |r| format!("radii {r} mm")),
    );
    let now_mm = format!(" (now {:.2} mm)", tool.shank_radius_mm);
    row("thickest shank that opens it", mm(found.shank_radius_mm, 2, "none, not even as thin as the ball") + &now_mm);
    if let Some(corner) = &found.corner {
        let now = format!(" (channel.contact_angle_max_deg, now {}°)", limit(options.settings.contact_angle_max_deg));
        let least = corner.contact_deg.map_or_else(|| "none up to 60°".into(), |deg| format!("{deg:.1}°"));
        row("least inclination that opens it", least + &now);
        let now = format!(" with this corner (now {:.2} mm)", tool.radius_mm);
        row("widest cutter that opens it", mm(corner.radius_mm, 2, "none, not even one as narrow as a ball") + &now);
    } else {
        let travel = found.least_travel.map_or_else(
            || "none, not even without limit".into(),
            |t| format!("±{:.3} mm about {:.3} mm (no less than ±{:.3} mm)", t.half_mm, t.middle_mm, t.bound_mm),
        );
        row("least travel of Y that opens it", travel);
    }
    if let Some(f) = &found.farthest {
        row(
            "leads farthest",
            format!("B = {}°: to height {:.2} mm, turn {}", limit(f.b_deg), f.height_mm, turn_number(f.turn)),
        );
    }
    if now.monotone_deg.is_none_or(|w| w < 0.0) && found.opens_nothing() {
        let end = found.farthest.as_ref().map_or_else(String::new, |f| {
            format!(": end the region above height {:.2} mm (region.end_mm) with B = {}°", f.height_mm, limit(f.b_deg))
        });
        row("none of these alone opens it", format!("machine less of the blade, or take another tool{end}"));
    }
    sayln!("looked at {} locations of the path; a plan with these values proves the moves between them", found.places);
    add_advice(args, &found)?;
    Ok(0)
}

/// Which leans of two tools open the rows.
fn pair_advice(args: &Advise, setup: &Setup, observer: &dyn Observer) -> Result<u8> {
    let angles = setup.angles_b(PAIR_ANGLES_DEG);
    let found = setup.pinch_advice(&angles, observer)?;
    sayln!(
        "{:>8} {:>12} {:>12} {:>12} {:>14}  narrowest at",
        "B",
        "pinch.b_2",
        "places",
        "still rows",
        "free for both"
    );
    let row = |p: &LeanPair, name: &str| {
        let [a, b] = p.b_deg.map(|deg| limit(deg) + "°");
        let rows = format!("{} of {}", p.still_rows, p.rows);
        sayln!(
            "{a:>8} {b:>12} {:>10.1} % {rows:>12} {:>13.2}°  height {:.2} mm{name}",
            100.0 * p.open_share,
            p.narrowest_deg,
            p.narrowest_at_mm
        );
    };
    match &found.now {
        Some(now) => row(now, ", as the job has it"),
        None => sayln!("as the job has it no row is open"),
    }
    found.open.iter().take(BEST_PAIRS).for_each(|p| row(p, ""));
    if let Some(same) = found.open.iter().find(|p| p.b_deg[0] == p.b_deg[1]) {
        row(same, ", the best of equal leans");
    }
    let pairs = angles.len() * angles.len();
    sayln!("{} of {pairs} pairs of leans open rows, looked at {} places", found.open.len(), found.places);
    match found.open.first() {
        Some(best) => sayln!(
            "best: machine.b_deg={} pinch.b_2_deg={}; `bladewright pinch` with them checks all places and moves",
            limit(best.b_deg[0]),
            limit(best.b_deg[1])
        ),
        None => sayln!("none opens a row: take a slimmer or longer tool, or other pinch.heights_mm"),
    }
    add_advice(args, &found)?;
    Ok(0)
}

/// Writes what was advised where a folder is asked for.
fn add_advice(args: &Advise, found: &impl serde::Serialize) -> Result<()> {
    let Some(out) = &args.out else { return Ok(()) };
    let mut folder = RunFolder::begin(out)?;
    folder.add_json("advice.json", found)?;
    folder.finish()?.iter().for_each(|file| sayln!("{}", file.display()));
    Ok(())
}
