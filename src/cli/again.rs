//! `verify`, `post`, `preview`: a finished run taken up again from its files.

use std::path::{Path, PathBuf};

use super::args::{Format, Plot, Post, Preview};
use super::out::{amount, limit, sayln};
use super::progress::Terminal;
use crate::artifact::deviation::DeviationMap;
use crate::artifact::report::Check;
use crate::artifact::{Blade, CheckReport};
use crate::error::{Error, ErrorKind, Result, Stage, turn_number};
use crate::plan;
use crate::run::again::{Checked, read};
use crate::run::operations::{self, Done};
use crate::run::{self, RunFolder, inputs, tables};
use crate::verify;
use crate::write::post::{self, Dialect, PostOptions};
use crate::write::{draw, preview};

/// `verify`: all checks again, from the files, programs included; writes verify.json, and the
/// deviation map where it is asked for.
pub fn verify(out: &Path, map: Option<(&Path, f64)>, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let checked = read(out, &terminal).and_then(|run| run.check(&terminal));
    terminal.finish();
    let checked = checked?;
    if let Some((file, tolerance)) = map {
        let (blade, path) = (&checked.loaded.setup.blade, &checked.verdict.value().toolpath);
        let map = verify::deviation(blade, path, tolerance)?;
        write_map(file, &map, blade, path.scallop_mm)?;
    }
    let mut folder = RunFolder::begin(out)?;
    let report = checked.report(&folder)?;
    for c in &report.checks {
        let verdict = if c.passed { "ok  " } else { "FAIL" };
        sayln!("{verdict} {:<28} {:>12} {:<8} limit {} {}", c.id, amount(c.worst), c.unit, limit(c.limit), c.unit);
    }
    print_failed(&report);
    folder.add_json("verify.json", &report)?;
    folder.finish()?;
    Ok(if report.passed() { 0 } else { ErrorKind::Findings.exit_code() })
}

/// A deviation map as a scene or as a table, by the file's name.
pub fn write_map(file: &Path, map: &DeviationMap, blade: &Blade, scallop_mm: f64) -> Result<()> {
    if map.coarse > 0 {
        let (coarse, all) = (map.coarse, map.triangles.len());
        let within = format!("in those heights are within {:.4} mm of the linear ones", map.coarse_bound_mm);
        sayln!("map        {coarse} of {all} triangles could not be made finer: {within}");
        if map.sharp > 0 {
            sayln!(
                "           but for {} on edges sharper than that, {:.4} mm2 together: there the distance to what is left is within {:.4} mm of them",
                map.sharp,
                map.sharp_area_mm2,
                map.sharp_bound_mm
            );
        }
    }
    if file.extension().is_some_and(|e| e == "csv") {
        return run::write_file(file, tables::deviation(blade, map).as_bytes());
    }
    run::write_file(file, &preview::deviation(&blade.name, map, &blade.model_from_blade, scallop_mm)?)
}

/// `post`: writes the program of a run whose checks passed; checks again where a file has changed.
pub fn post(args: &Post, quiet: bool) -> Result<u8> {
    let out = match (&args.out, &args.runs[..]) {
        (Some(out), _) | (None, [out]) => out,
        (None, _) => {
            return Err(
                Error::usage(Stage::Post, "several runs need a folder for their program").advise("give -o FOLDER")
            );
        }
    };
    let (name, dialect) = match (&args.post_file, args.control) {
        (Some(file), _) => (plan::post_name(file), inputs::dialect(file)?),
        (None, Some(control)) => (control.to_string(), Dialect::built_in(control)?),
        (None, None) => return Err(Error::usage(Stage::Post, "give --control or --post-file")),
    };
    let mut done = Vec::with_capacity(args.runs.len());
    let mut passed = true;
    for (k, run) in args.runs.iter().enumerate() {
        let from_turn = args.from_turn.filter(|_| k + 1 == args.from_operation.unwrap_or(1));
        let (one, good) = checked(run, from_turn, args.force, quiet)?;
        done.push(one);
        passed &= good;
    }
    let from = operations::From { operation: args.from_operation, turn: args.from_turn };
    let extent = operations::Extent { from, every_blade: args.every_blade };
    let (program, checks) = operations::join(&done, &dialect, extent)?;
    let sound = checks.iter().all(|c| c.passed);
    if !sound {
        print_failed(&CheckReport { checks, ..CheckReport::default() });
    }
    let Some(program) = program else {
        let message = "other blades of the wheel are not as the one that was planned, so no program was written";
        return Err(Error::new(Stage::Post, ErrorKind::Findings, message)
            .advise("plan a blade that differs by itself: --axis chooses it"));
    };
    if !sound {
        return Err(Error::new(
            Stage::Post,
            ErrorKind::Findings,
            format!("{} does not come back as planned when it is read, so it was not written", program.file_name),
        )
        .advise("where words are rounded too much, write more digits in the post file"));
    }
    let mut folder = RunFolder::begin(out)?;
    folder.add_program(&program.file_name, program.text, &name)?;
    print_written(&folder.finish()?);
    Ok(if passed { 0 } else { ErrorKind::Findings.exit_code() })
}

/// A finished run with its verdict, and whether its checks passed; a turn to go on with must be
/// one of its own.
fn checked(run: &Path, from_turn: Option<usize>, force: bool, quiet: bool) -> Result<(Done, bool)> {
    let terminal = Terminal::new(quiet);
    let checked = read(run, &terminal).and_then(|run| {
        post::planned(&run.plan, &PostOptions { from_turn, ..run.loaded.setup.post_options() })?;
        run.recall(&terminal)
    });
    terminal.finish();
    let Checked { loaded, verdict, files, .. } = checked?;
    let mut report = verdict.report().clone();
    report.checks.extend(files);
    let accepted = plan::accept(verdict, force).map(|v| if report.passed() { v } else { v.as_forced() });
    let Some(verified) = accepted.filter(|_| force || report.passed()) else {
        print_failed(&report);
        return Err(Error::new(
            Stage::Verify,
            ErrorKind::Findings,
            format!("the plan of {} fails its checks, no program was written", run.display()),
        )
        .advise("mend the job and plan again, or pass --force to write a program marked as not verified"));
    };
    Ok((Done { loaded, verified, name: run.display().to_string() }, report.passed()))
}

/// `preview`: preview.glb and report.html again.
pub fn preview(args: &Preview, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let written = read(&args.out, &terminal).and_then(|run| run.check(&terminal)).and_then(|run| {
        let mut folder = RunFolder::begin(&args.out)?;
        run::preview_again(&run, args.preview_budget.map(|b| b.0), &mut folder, &terminal)?;
        folder.finish()
    });
    terminal.finish();
    print_written(&written?);
    Ok(0)
}

/// `plot`: the report's plots as files.
pub fn plot(args: &Plot, quiet: bool) -> Result<u8> {
    let terminal = Terminal::new(quiet);
    let drawn = read(&args.run, &terminal).and_then(|run| run.check(&terminal)).and_then(|run| {
        let turn = args.turn.unwrap_or(run.verdict.value().toolpath.turns.len() / 2 + 1);
        run::plots(&run.loaded.setup, &run.verdict, turn, &terminal)
    });
    terminal.finish();
    let mut folder = RunFolder::begin(&args.out.clone().unwrap_or_else(|| args.run.join("plots")))?;
    for (name, svg) in drawn? {
        if args.format.contains(&Format::Png) {
            folder.add(&format!("{name}.png"), draw::png(&svg, args.width)?)?;
        }
        if args.format.contains(&Format::Svg) {
            folder.add(&format!("{name}.svg"), svg)?;
        }
    }
    print_written(&folder.finish()?);
    Ok(0)
}

/// Names the files that were written.
fn print_written(files: &[PathBuf]) {
    for file in files {
        sayln!("{}", file.display());
    }
}

/// One line for each check that failed.
pub fn print_failed(report: &CheckReport) {
    for c in report.checks.iter().filter(|c| !c.passed) {
        finding(c, &c.row.map(|r| format!(", location {r}")).unwrap_or_default());
    }
}

/// The line of a check that failed; `place`: where on the path or in the program, after a comma.
pub(super) fn finding(c: &Check, place: &str) {
    let turn = c.turn.map(|t| format!(", turn {}", turn_number(t))).unwrap_or_default();
    let at = c.point_mm.map(|[x, y, z]| format!(" at ({x:.3}, {y:.3}, {z:.3})")).unwrap_or_default();
    sayln!(
        "finding: {}: {} is {} {}, limit {}{at}{turn}{place}; {}",
        c.id,
        c.quantity,
        amount(c.worst),
        c.unit,
        limit(c.limit),
        c.note
    );
}
