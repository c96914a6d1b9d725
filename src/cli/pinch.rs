//! `pinch`: rows for two tools that hold a blade between them.

use super::args;
use super::out::{self, sayln};
use super::plan::draft_of;
use super::progress::Terminal;
use crate::artifact::report::Check;
use crate::error::{ErrorKind, Result};
use crate::observe::{Observer, Recorder};
use crate::pair::PinchEdges;
use crate::plan::pinch::{Pinch, PinchProgrammed};
use crate::run::{Loaded, RunFolder, pinch as files};
use serde_json::json;

/// Single ridges over the scallop by this factor are printed.
const HIGH: f64 = 1.5;

/// Runs the verb; the exit code.
pub fn run(args: &args::Pinch, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let ended = study(args, &terminal);
    terminal.finish();
    ended
}

fn study(args: &args::Pinch, observer: &dyn Observer) -> Result<u8> {
    let mut folder = RunFolder::begin(&args.job.out)?;
    folder.refuse_beside_run("report.html")?;
    let recorder = Recorder::new(observer);
    let loaded = Loaded::read(&draft_of(&args.job)?, &recorder)?;
    let setup = &loaded.setup;
    folder.add_job_of_study(&setup.job.to_toml()?)?;
    // What no control can have is said before rows are planned.
    setup.pinch_dialects()?;
    let pinch = setup.pinch(&recorder)?;
    let programmed = setup.pinch_program(&pinch, &recorder)?;
    for (name, text) in files::tables(setup, &pinch) {
        folder.add(name, text)?;
    }
    let figures = files::figures(setup, &pinch, programmed.as_ref());
    folder.add_json("pinch.json", &figures)?;
    folder.add("pinch.svg", files::plot(setup, &pinch))?;
    let motion = programmed.as_ref().map(|p| &p.motion);
    folder.add("pinch.glb", files::scene(setup, &pinch, motion)?)?;
    folder.add("report.html", files::report(&loaded, &pinch, motion, &figures, &recorder.warnings())?)?;
    print(&pinch, &figures);
    if figures.edge_rows == 0 && setup.pinch_settings().edges == PinchEdges::Both {
        sayln!("  WARNING: no rows go round the edges: beside the rows of opposite places no strip is worth a row");
    }
    let mut passed = pinch.checks.iter().all(|c| c.passed);
    if let Some(programmed) = &programmed {
        print_program(programmed, figures.program.as_ref());
        folder.add("pinch_axes.csv", files::axes(setup, &programmed.motion))?;
        passed &= programmed.checks.iter().all(|c| c.passed);
        for posted in &programmed.programs {
            // A program that is written is one that passed, as rows and motion have.
            let is_good = passed_before(&pinch, programmed) && posted.checks.iter().all(|c| c.passed);
            if is_good {
                posted.files.iter().try_for_each(|f| folder.add(&f.name, &f.text))?;
            } else {
                sayln!("no program is written for {}: a check failed", posted.control);
            }
            passed &= is_good;
        }
    } else {
        sayln!(
            "no program: the machine {} has one head (machine.file=models/machines/pinch_9x.toml has two)",
            setup.machine.name
        );
    }
    if out::is_json() {
        out::event(&json!({ "event": "pinch", "pinch": figures }));
    }
    sayln!();
    for file in folder.finish()? {
        sayln!("{}", file.display());
    }
    Ok(if passed { 0 } else { ErrorKind::Findings.exit_code() })
}

/// All checks of rows and motion.
fn passed_before(pinch: &Pinch, programmed: &PinchProgrammed) -> bool {
    pinch.checks.iter().chain(&programmed.checks).all(|c| c.passed)
}

fn print(pinch: &Pinch, f: &files::PinchSummary) {
    let row = |name: &str, value: String| sayln!("  {name:<34} {value}");
    let [one, two] = f.radius_mm;
    row("balls", format!("R {one} mm for tool 1, R {two} mm for tool 2"));
    if let Some([one, two]) = f.thread_turns {
        row("double helix", format!("threads of {one} and {two} turns"));
    } else {
        row("rows", format!("{}, {} of them with the table still", f.rows, f.still_rows));
        if let Some([low, high]) = f.edge_heights_mm {
            row("  round the edges", format!("{} of them, at heights {low:.3} to {high:.3} mm", f.edge_rows));
        }
    }
    row("places of both tools", f.places.to_string());
    if f.cut_off > 0 {
        row("  cut off the ends of rows", format!("{}, where no angle of the table is free for both tools", f.cut_off));
    }
    row("first tool at heights", format!("{:.3} to {:.3} mm", f.heights_mm[1], f.heights_mm[0]));
    let [one, two] = f.length_mm;
    let of = if f.thread_turns.is_some() { "length of the threads" } else { "length of the rows" };
    row(of, format!("{one:.1} mm and {two:.1} mm"));
    let [one, two] = f.covered.map(|share| 100.0 * share);
    if f.thread_turns.is_some() {
        row("of the airfoil", format!("{:.1} % is machined", 100.0 * f.closed));
    } else {
        row("of the airfoil", format!("{one:.1} % lie between the rows of tool 1, {two:.1} % between those of tool 2"));
        if f.edge_rows > 0 {
            row("  with the rows round the edges", format!("{:.1} % of it is machined", 100.0 * f.closed));
        }
        row("rows end where", f.ends.clone());
    }
    let [one, two] = f.measured.ridges_mm;
    let of = ["ridges of tool 1", "ridges of tool 2", "the higher of both", "where rows meet"];
    let all = [one, two, f.measured.binding_ridges_mm, f.measured.border_ridges_mm];
    let shown = match f.edge_rows {
        _ if f.thread_turns.is_some() => 2,
        0 => all.len() - 1,
        _ => all.len(),
    };
    for (of, [p05, p50, p95, p99, most]) in of.into_iter().zip(all).take(shown) {
        let text = format!("{p05:.4} to {p95:.4} mm (median {p50:.4}, 99 % {p99:.4}, greatest {most:.4})");
        row(&format!("{of}, 5 % to 95 %"), text);
    }
    let highest = f.measured.ridges_mm.iter().map(|r| r[4]).fold(0.0, f64::max);
    if highest > HIGH * pinch.rows.scallop_mm {
        let text = format!(
            "a ridge of {highest:.4} mm is over {HIGH} times the scallop, at an end of a row: the check `ridge` says where"
        );
        row("WARNING", text);
    }
    let [median, p99, most] = f.measured.line_distance_mm;
    row("normal lines pass within", format!("{median:.4} mm (99 % {p99:.4}, greatest {most:.4})"));
    let [median, p99, most] = f.measured.angle_deg;
    row("normals lack of being opposite", format!("{median:.2}° (99 % {p99:.2}°, greatest {most:.2}°)"));
    row("free for both tools, at least", format!("{:.2}° at place {}", f.narrowest_deg, f.narrowest_place));
    row("table turns between stretches", format!("{:.1}° in all", f.turned_deg));
    if f.turned_cutting_deg > 0.0 {
        row("  while both tools cut", format!("{:.1}° in all", f.turned_cutting_deg));
        let most = |of: [f64; 2]| of.into_iter().fold(0.0, f64::max);
        let steepest = most(f.measured.turning_rad_mm);
        let least = match f.thread_turns {
            Some(_) => String::new(),
            None => format!("; the least is {:.5}", f.least_turning_rad_mm),
        };
        row("  a tool axis turns at most by", format!("{steepest:.5} rad/mm of its contact's way{least}"));
        if let Some(p) = &f.published {
            let before = [(p.fixed_rad_mm, p.fixed_outside), (p.posture_rad_mm, p.posture_outside)];
            let [fixed, curve] =
                before.map(|(of, outside)| format!("{:.5} rad/mm, {outside} places not free", most(of)));
            row("  at a fixed angle to the normal", fixed);
            row("  by the posture curves", curve);
            row("  rows without angles", p.rows_without.to_string());
        }
    }
    row("tools are apart", format!("{:.3} mm at least", f.measured.tools_apart_mm));
    print_failed(&pinch.checks);
}

fn print_program(programmed: &PinchProgrammed, figures: Option<&files::ProgramSummary>) {
    let row = |name: &str, value: String| sayln!("  {name:<34} {value}");
    if let Some(f) = figures {
        let (share, alone) = (100.0 * f.share_of_one_after_the_other, f.one_after_the_other_s);
        row("both tools cut", format!("{:.1} s, {share:.1} % of {alone:.1} s for one tool on both sides", f.cutting_s));
        row("  at full feed all along", format!("{:.1} s", f.full_feed_s));
        row("  ways down, up, from row to row", format!("{:.1} s, about", f.ways_s));
    }
    row("from row to row", format!("outside {:.1} mm of the blade axis", programmed.motion.turning_mm));
    print_failed(&programmed.checks);
    for posted in &programmed.programs {
        let files: Vec<&str> = posted.files.iter().map(|f| f.name.as_str()).collect();
        let lines: usize = posted.files.iter().map(|f| f.text.lines().count()).sum();
        row(&format!("program for {}", posted.control), format!("{}, {lines} lines", files.join(" and ")));
        print_failed(&posted.checks);
    }
}

fn print_failed(checks: &[Check]) {
    for c in checks.iter().filter(|c| !c.passed) {
        let name = format!("FAILED {}", c.id);
        sayln!("  {name:<34} {}: {:.6} {} (limit {:.6}); {}", c.quantity, c.worst, c.unit, c.limit, c.note);
    }
}
