//! `compare`: all schedules of a job side by side.

use super::args::Compare;
use super::out::sayln;
use super::plan::draft_of;
use super::progress::Terminal;
use crate::error::Result;
use crate::run::compare::{Comparison, PathRun, ScheduleRun, compare};

/// Runs the verb; the exit code.
pub fn run(args: &Compare, quiet: bool) -> Result<u8> {
    let draft = draft_of(&args.job)?;
    let terminal = Terminal::new(quiet);
    let found = compare(&draft, &args.job.out, !args.no_jerk, &terminal);
    terminal.finish();
    let (found, files) = found?;
    print(&found);
    sayln!();
    for file in files {
        sayln!("{}", file.display());
    }
    Ok(0)
}

fn print(c: &Comparison) {
    let jerk = if c.limit_jerk { "velocity, acceleration and jerk" } else { "velocity and acceleration" };
    sayln!("{}: {} locations, {:.1} mm, feed {} mm/min", c.name, c.cutter_locations, c.path_length_mm, c.feed_mm_min);
    sayln!();
    sayln!("at the same constant feed:");
    sayln!(
        "  {:<22} {:>9} {:>9} {:>11} {:>13} {:>9} {:>10} {:>9} {:>9}",
        "",
        "reversals",
        "outside °",
        "A °/s",
        "A °/s²",
        "Y mm/s",
        "Y mm/s²",
        "Z mm/s",
        "Z mm/s²"
    );
    for s in &c.schedules {
        let [_, y, z, a, ..] = &s.at_constant_feed[..] else { continue };
        sayln!(
            "  {:<22} {:>9} {:>9.3} {:>11.2} {:>13.2} {:>9.2} {:>10.1} {:>9.2} {:>9.1}",
            s.name,
            s.reversals,
            s.outside_deg,
            a.velocity,
            a.acceleration,
            y.velocity,
            y.acceleration,
            z.velocity,
            z.acceleration
        );
    }
    sayln!();
    sayln!("machining time in s at its own best feed ({jerk} limited), for multiples of the machine's limits:");
    let heads: String = c.sweep.iter().map(|l| format!("{:>12}", format!("x{}", l.scale))).collect();
    sayln!("  {:<22}{heads}", "");
    let Some(first) = c.sweep.first() else { return };
    for (k, r) in first.runs.iter().enumerate() {
        let times: String = c.sweep.iter().filter_map(|l| l.runs.get(k)).map(|r| format!("{:>12}", time(r))).collect();
        sayln!("  {:<22}{times}", r.name);
    }
    let bounds: String = c.sweep.iter().map(|l| format!("{:>12.2}", l.bound_s)).collect();
    sayln!("  {:<22}{bounds}", "lower bound");
    if c.sweep.iter().flat_map(|l| &l.runs).any(|r| r.within_jerk == Some(false)) {
        sayln!("  * no motion within the limits of jerk was found: the time keeps velocity and acceleration only");
    }
    print_paths(&c.paths);
}

/// The path beside its smooth curve; nothing where the job does not ask for it.
fn print_paths(paths: &[PathRun]) {
    let Some(first) = paths.first() else { return };
    sayln!();
    sayln!("path, with the optimal schedule: jerk at the same constant feed, mm or degrees per s³, and time in s");
    let heads: String = first.jerk.iter().map(|j| format!("{:>13}", j.axis)).collect();
    sayln!("  {:<22} {:>9}{heads} {:>9}", "", "blocks", "time");
    for p in paths {
        let jerks: String = p.jerk.iter().map(|j| format!("{:>13.0}", j.jerk)).collect();
        sayln!("  {:<22} {:>9}{jerks} {:>9.2}", p.name, p.blocks, p.time_s);
    }
}

fn time(r: &ScheduleRun) -> String {
    format!("{}{:.2}", if r.within_jerk == Some(false) { "*" } else { "" }, r.time_s)
}
