//! `verify`: a finished run again, or a program that others wrote.

use super::args::Verify;
use super::out::{amount, limit, sayln};
use super::progress::Terminal;
use super::{again, fit, inspect, pinch_audit, theirs};
use crate::error::{Error, ErrorKind, Result, Stage};
use crate::machine::Machine;
use crate::read::model;
use crate::read::program::Bench;
use crate::run::{self, inputs};
use crate::verify;
use crate::verify::audit::{self, Audit, AuditOptions, LineCheck};

/// Spans of lines that are printed for one check; all are in the report.
const TOLD_SPANS: usize = 5;

/// Runs the verb; the exit code.
pub fn run(args: &Verify, quiet: bool) -> Result<u8> {
    let (Some(part), false) = (&args.part, args.tool.is_empty()) else {
        if args.what.is_file() {
            let what =
                format!("{} is a file: to check a program, its part and its tool are needed", args.what.display());
            return Err(Error::usage(Stage::Verify, what).advise("give --part MODEL and --tool FILE"));
        }
        let map = args.map.as_deref().map(|file| (file, args.map_tolerance));
        return again::verify(&args.what, map, quiet);
    };
    let text = theirs::text(&args.what)?;
    let machine = args.machine.as_ref().map_or_else(Machine::demo, |f| inputs::machine(f))?;
    if args.second.is_some() || verify::is_for_two_tools(&text, &machine) {
        return pinch_audit::run(args, part, &text, &machine, quiet);
    }
    let (language, why) = theirs::language(&args.what, &args.manner, &text)?;
    let tools = args.tool.iter().map(|t| inputs::tool(t)).collect::<Result<Vec<_>>>()?;
    let (language, why) = theirs::with_tools(language, why, &args.manner, &tools);
    let terminal = Terminal::new(quiet);
    let blade = model::load(part, &inspect::reading(&args.reading), &terminal);
    let audit = blade.and_then(|blade| {
        let zero = theirs::zero(&args.manner, &blade);
        let mut benches: Vec<Bench> =
            tools.iter().map(|tool| Bench { language, zero, tool, machine: &machine }).collect();
        let fit = fit::place((&args.manner, args.stock), &text, &mut benches, &blade, &terminal)?;
        let options = AuditOptions {
            scallop_mm: args.scallop,
            stock_mm: args.stock.unwrap_or(0.0),
            map_mm: args.map.as_ref().map(|_| args.map_tolerance),
            ..AuditOptions::default()
        }
        .with(|s| s.gouge_mm = args.gouge);
        // One tool is taken for the whole program, however often it is called.
        let audits = match &benches[..] {
            [bench] => vec![audit::audit(&text, &blade, bench, &options, &terminal)?],
            _ => audit::audit_each(&text, &blade, &benches, &options, &terminal)?,
        };
        // The last one's map is that of all.
        if let (Some(file), Some(audit)) = (&args.map, audits.last())
            && let Some(map) = &audit.map
        {
            again::write_map(file, map, &blade, args.scallop.unwrap_or(audit.scallop_p99_mm.max(0.001)))?;
        }
        Ok((audits, fit))
    });
    terminal.finish();
    let (audits, fit) = audit?;
    if let Some(file) = &args.report {
        let fitted: Vec<fit::Fitted<Audit>> = audits.iter().map(|a| fit::Fitted::new(a, fit.as_ref())).collect();
        let json = match &fitted[..] {
            [audit] => run::json(audit)?,
            all => run::json(&all)?,
        };
        run::write_file(file, json.as_bytes())?;
    }
    sayln!("program    {}: {why}", args.what.display());
    fit.iter().for_each(fit::tell);
    for (k, audit) in audits.iter().enumerate() {
        if audits.len() > 1 {
            sayln!("operation  {} of {}", k + 1, audits.len());
        }
        tell(audit);
    }
    Ok(if audits.iter().all(Audit::passed) { 0 } else { ErrorKind::Findings.exit_code() })
}

/// The audit as lines.
fn tell(audit: &Audit) {
    sayln!(
        "moves      {} at a feed ({:.1} mm, {:.1} s as programmed, {} turns, B {:.3} to {:.3} deg), {} rapids, {} not known from their beginning",
        audit.feed_moves,
        audit.feed_mm,
        audit.feed_s,
        audit.turns,
        audit.b_deg[0],
        audit.b_deg[1],
        audit.rapids,
        audit.unknown_moves
    );
    sayln!(
        "scallop    median {:.6}, 99 % {:.6}, highest {:.6} mm at {} places between passes",
        audit.scallop_p50_mm,
        audit.scallop_p99_mm,
        audit.scallop_max_mm,
        audit.scallop_samples
    );
    for LineCheck { check: c, .. } in &audit.checks {
        let verdict = if c.passed { "ok  " } else { "FAIL" };
        sayln!("{verdict} {:<28} {:>12} {:<8} limit {} {}", c.id, amount(c.worst), c.unit, limit(c.limit), c.unit);
    }
    audit.checks.iter().filter(|c| !c.check.passed).for_each(finding);
}

/// A check that failed, with where.
fn finding(found: &LineCheck) {
    let line = match (found.line, &found.block) {
        (Some(n), Some(block)) => format!(", line {n} `{block}`"),
        _ => String::new(),
    };
    super::again::finding(&found.check, &line);
    for s in found.spans.iter().take(TOLD_SPANS) {
        match s.last_line > s.first_line {
            true => sayln!("         lines {} to {}", s.first_line, s.last_line),
            false => sayln!("         line {}", s.first_line),
        }
    }
    if found.span_count > TOLD_SPANS {
        sayln!("         and {} more places", found.span_count - TOLD_SPANS);
    }
}
