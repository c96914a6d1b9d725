//! `verify` of a program of two tools that others wrote, in one channel or two.

use std::path::Path;

use super::args::Verify;
use super::out::{amount, limit, sayln};
use super::progress::Terminal;
use super::{again, inspect, theirs};
use crate::error::{Error, ErrorKind, Result, Stage};
use crate::machine::Machine;
use crate::pair::PinchSettings;
use crate::read::model;
use crate::run::{self, inputs};
use crate::verify::audit::AuditOptions;
use crate::verify::{self, PinchAudit, PinchBench};

/// Runs it; the exit code.
pub fn run(args: &Verify, part: &Path, text: &str, machine: &Machine, quiet: bool) -> Result<u8> {
    if args.map.is_some() || args.manner.fit {
        return Err(Error::usage(Stage::Verify, "--map and --fit are for programs of one tool")
            .advise("leave them out, or check a program of one tool"));
    }
    let second = args.second.as_ref().map(|file| theirs::text(file)).transpose()?;
    let tools = args.tool.iter().map(|t| inputs::tool(t)).collect::<Result<Vec<_>>>()?;
    let both = match &tools[..] {
        [one] => [one, one],
        [one, two] => [one, two],
        _ => {
            let message = format!("--tool is given {} times, for two heads", tools.len());
            return Err(Error::usage(Stage::Verify, message).advise("give it once, or once for each head"));
        }
    };
    let terminal = Terminal::new(quiet);
    let blade = model::load(part, &inspect::reading(&args.reading), &terminal);
    let audit = blade.and_then(|blade| {
        let options =
            AuditOptions { scallop_mm: args.scallop, stock_mm: args.stock.unwrap_or(0.0), ..AuditOptions::default() }
                .with(|s| s.gouge_mm = args.gouge);
        let asked = PinchSettings::default();
        let (tools_apart_mm, line_distance_mm) = (asked.tools_apart_mm, asked.line_distance_mm);
        let bench = PinchBench { blade: &blade, tools: both, machine, tools_apart_mm, line_distance_mm };
        let texts: Vec<&str> = std::iter::once(text).chain(second.as_deref()).collect();
        verify::audit_pinch(&texts, &bench, &options, &terminal)
    });
    terminal.finish();
    let audit = audit?;
    if let Some(file) = &args.report {
        run::write_file(file, run::json(&audit)?.as_bytes())?;
    }
    tell(&audit);
    Ok(if audit.passed() { 0 } else { ErrorKind::Findings.exit_code() })
}

fn tell(a: &PinchAudit) {
    let channels = if a.channels == 2 { "two channels" } else { "one channel" };
    sayln!(
        "program    of two tools in {channels}: {} lines at a feed ({:.1} s), {} rapids, {} before all axes are known",
        a.feed_lines,
        a.feed_s,
        a.rapids,
        a.unknown_lines
    );
    let [one, two, both] = a.touching.map(|share| 100.0 * share);
    sayln!("at work    tool 1 {one:.1} %, tool 2 {two:.1} %, both {both:.1} % of that time");
    let [one, two] = a.lean_deg.map(|[least, most]| format!("{least:.3} to {most:.3}°"));
    sayln!("leans      {one} of tool 1, {two} of tool 2; the table turns by {:.1}° while both cut", a.turned_deg);
    sayln!(
        "opposite   {} of {} rows of both tools face each other, {:.1} % of their places; lines pass within {:.4} mm (99 % {:.4}), normals lack {:.2}° (99 % {:.2}°)",
        a.rows - a.rows_elsewhere,
        a.rows,
        100.0 * a.opposite,
        a.line_distance_mm[0],
        a.line_distance_mm[1],
        a.angle_deg[0],
        a.angle_deg[1]
    );
    for (k, [p50, p99, most]) in a.scallop_mm.iter().enumerate() {
        sayln!("scallop    of tool {}: median {p50:.6}, 99 % {p99:.6}, highest {most:.6} mm", k + 1);
    }
    for c in &a.checks {
        let verdict = if c.passed { "ok  " } else { "FAIL" };
        sayln!("{verdict} {:<28} {:>12} {:<8} limit {} {}", c.id, amount(c.worst), c.unit, limit(c.limit), c.unit);
    }
    a.checks.iter().filter(|c| !c.passed).for_each(|c| again::finding(c, ""));
}
