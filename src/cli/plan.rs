//! `plan`: model or job file in, programs out.

use std::fmt::Display;
use std::path::Path;

use super::args::{Faces, Job, Plan, Reading, RegionHeights};
use super::out::sayln;
use super::progress::Terminal;
use crate::artifact::program::CycleTime;
use crate::artifact::report::TurningFigures;
use crate::error::{Error, ErrorKind, Result, Stage};
use crate::files;
use crate::job::{Draft, JobFile};
use crate::make::BladeDesign;
use crate::run::summary::{ScheduleFigures, SmoothFigures, StoppedFigures, Summary};
use crate::run::{self, Course, Outcome, inputs};

/// Runs the verb; the exit code.
pub fn run(args: &Plan, quiet: bool) -> Result<u8> {
    let draft = draft_of(&args.job)?;
    let terminal = Terminal::new(quiet);
    let preview_bytes = args.preview_budget.map(|b| b.0);
    let course = Course { until: args.until, force: args.force, preview_bytes, ..Course::default() };
    let outcome = run::run(&draft, &args.job.out, course, &terminal);
    terminal.finish();
    let outcome = outcome?;
    print(&outcome, args.until);
    let passed = outcome.report.as_ref().is_none_or(|r| r.passed());
    Ok(if passed { 0 } else { ErrorKind::Findings.exit_code() })
}

/// The job as typed: a job file, or a model with defaults; then the flags.
pub(super) fn draft_of(args: &Job) -> Result<Draft> {
    draft_from(&args.input, &args.reading, &args.set)
}

/// A model or job file, how to read it, and changed keys as a draft.
pub(super) fn draft_from(input: &Path, reading: &Reading, set: &[String]) -> Result<Draft> {
    let (mut file, base) = inputs::typed(input).map_err(|e| named(input, e))?;
    read_as(&mut file, reading)?;
    for assignment in set {
        file.set(assignment)?;
    }
    inputs::draft(file, base)
}

/// The error of what is no job file; a design for `make` in its place is named as that.
fn named(input: &Path, e: Error) -> Error {
    let design = files::read_text(input, files::SHORT).ok().and_then(|text| BladeDesign::from_toml(&text).ok());
    if design.is_none() {
        return e;
    }
    let name = input.display();
    Error::usage(Stage::Job, format!("{name} is the design of a blade for `make`, neither a job nor a model")).advise(
        format!("bladewright make {name} -o FOLDER writes the blade as STEP and OBJ; give one of these to plan"),
    )
}

/// `--unit`, `--axis`, `--body`, `--region` and `--faces` as keys of the job.
fn read_as(file: &mut JobFile, reading: &Reading) -> Result<()> {
    if let Some(unit) = reading.unit {
        let name = serde_json::to_string(&unit)
            .map_err(|e| Error::new(Stage::Job, ErrorKind::Usage, format!("--unit cannot be used: {e}")))?;
        file.set(&format!("model.unit={name}"))?;
    }
    if let Some(axis) = reading.axis {
        let [x, y, z] = axis.0;
        file.set(&format!("model.axis=[{x:?}, {y:?}, {z:?}]"))?;
    }
    let keys = file.model.get_or_insert_default();
    keys.body = reading.body.or(keys.body);
    for region in &reading.region {
        match region {
            RegionHeights::Airfoil(heights) => keys.airfoil_mm = Some(*heights),
            RegionHeights::Platform(x) => keys.platform_mm = Some(*x),
        }
    }
    for faces in &reading.faces {
        match faces {
            Faces::Airfoil(names) => keys.airfoil_faces.get_or_insert_default().extend(names.iter().cloned()),
            Faces::Platform(names) => keys.platform_faces.get_or_insert_default().extend(names.iter().cloned()),
        }
    }
    Ok(())
}

fn print(outcome: &Outcome, until: Option<Stage>) {
    let tool = &outcome.setup.tool;
    sayln!("tool: {} ({})", tool.in_words(), tool.why);
    if let Some(summary) = &outcome.summary {
        print_summary(summary);
    }
    if let Some(stopped) = &outcome.stopped {
        sayln!("{}", outcome.setup.blade.name);
        print_stopped(stopped);
    }
    if let Some(until) = until {
        let took: Vec<String> = outcome.stages.iter().map(|s| format!("{} {:.1} s", s.stage, s.seconds)).collect();
        sayln!("stopped after {until}, as asked: {}", took.join(", "));
    }
    if let Some(report) = &outcome.report {
        super::again::print_failed(report);
    }
    sayln!();
    for file in &outcome.files {
        sayln!("{}", file.display());
    }
}

/// A figure with its name.
fn row(name: &str, value: impl Display) {
    sayln!("  {name:<34} {value}");
}

/// What a run that was stopped has.
fn print_stopped(s: &StoppedFigures) {
    print_path(s.turns, s.cutter_locations, s.region_x_mm, s.path_length_mm);
    if let Some(c) = &s.channel {
        print_channel(c.narrowest_deg, c.narrowest_row, c.monotone_deg);
    }
    if let Some(reversals) = s.reversals {
        row("reversals", reversals);
    }
}

fn print_path(turns: usize, locations: usize, [from, to]: [f64; 2], length_mm: f64) {
    row("turns", turns);
    row("cutter locations", locations);
    row("ball centres at heights", format!("{from:.3} to {to:.3} mm"));
    row("path length", format!("{length_mm:.1} mm"));
}

fn print_channel(narrowest_deg: f64, location: usize, monotone_deg: f64) {
    row("narrowest channel", format!("{narrowest_deg:.2}° at location {location}"));
    row("  without turning back", format!("{monotone_deg:.2}°"));
}

fn print_summary(s: &Summary) {
    sayln!("{}", s.name);
    print_path(s.turns, s.cutter_locations, s.region_x_mm, s.path_length_mm);
    row("machining time", minutes(s.machining_time_s));
    for p in &s.programs {
        row(&format!("  cycle, {}", p.file), cycle(&p.cycle));
    }
    if !s.limits_assumed.is_empty() {
        row("  limits assumed, not measured", s.limits_assumed.join(" "));
    }
    if let Some(smooth) = &s.smooth {
        print_smooth(smooth, s.cutter_locations);
    }
    row("worst gouge", format!("{:.4} mm", s.gouge_mm));
    row("worst scallop", format!("{:.4} mm (asked {} mm)", s.scallop_max_mm, s.scallop_asked_mm));
    row("scallop, 99th percentile", format!("{:.4} mm", s.scallop_p99_mm));
    // Of a cutter with a corner neither these nor what stays uncut is measured.
    let is_ball = s.disc_radius_mm == 0.0;
    if is_ball {
        row("ridges, 5 % to 95 %", format!("{:.4} to {:.4} mm", s.limit.ridge_p05_mm, s.limit.ridge_p95_mm));
        row("length over the limit", format!("{:.4} (inner turns)", s.limit.ratio));
    }
    for other in &s.other_paths {
        row(&format!("  as {}, same scallop", other.kind.name()), format!("{:.4}", other.ratio_at_same_scallop));
    }
    if is_ball {
        row("uncut area", format!("{:.2} mm² (no ball of this radius reaches it)", s.uncut_area_mm2));
    }
    row("least clearance", format!("{:.3} mm", s.clearance_mm));
    print_channel(s.channel_width_min_deg, s.channel_narrowest_row, s.channel_monotone_min_deg);
    if let Some(turning) = &s.axis_turning {
        let over = turning.over_bounds().map(|over| over.map_or("bound 0".to_owned(), |over| format!("{over:.4}")));
        row("longitude, latitude over bound", over.join(", "));
    }
    if let Some(turning) = &s.turning {
        print_turning(turning);
    }
    if let [used, fixed, ..] = &s.schedules[..] {
        sayln!("  {:<34} {:>14} {:>14}", "", format!("{:?}", used.kind).to_lowercase(), "fixed lead");
        let pair = |name: &str, f: &dyn Fn(&ScheduleFigures) -> String| {
            sayln!("  {name:<34} {:>14} {:>14}", f(used), f(fixed));
        };
        pair("rotary velocity at full feed", &|x| format!("{:.1} °/s", x.a_velocity_at_constant_feed_deg_s));
        pair("rotary acceleration at full feed", &|x| format!("{:.0} °/s²", x.a_acceleration_at_constant_feed_deg_s2));
        pair("reversals", &|x| x.reversals.to_string());
        pair("locations outside the channel", &|x| x.outside_channel.to_string());
        pair("time within the machine's limits", &|x| minutes(x.machining_time_s));
    }
}

/// Turn-milling.
fn print_turning(t: &TurningFigures) {
    let [least, greatest] = t.offset_mm;
    row("offset from the blade axis", format!("{least:.3} to {greatest:.3} mm"));
    if let Some(([least, greatest], ripple)) = t.turning_per_min.zip(t.ripple) {
        row("blade turns at", format!("{least:.3} to {greatest:.3} 1/min, within a turn by {:.3} %", 100.0 * ripple));
    }
    if let Some(tooth) = &t.tooth {
        let chip = tooth.chip_mm.map_or_else(String::new, |chip| format!(", chip {chip:.4} mm"));
        row("feed per tooth, at most", format!("{:.4} mm{chip}", tooth.feed_mm));
        row("  time below the least", format!("{:.2} %", 100.0 * tooth.below_least));
        row("  marks along the feed", format!("{:.5} mm", tooth.mark_mm));
        row("  cutting speed, at least", format!("{:.1} m/min", tooth.least_speed_m_min));
    }
}

/// What the smooth curve gains.
fn print_smooth(s: &SmoothFigures, locations: usize) {
    let grown = |now: f64, before: f64| if before > 0.0 { 100.0 * (now / before - 1.0) } else { 0.0 };
    let time = grown(s.time_s, s.time_before_s);
    row("smooth curve", format!("{} before, {time:+.1} %", minutes(s.time_before_s)));
    let share = s.pieces as f64 / s.locations_before.max(1) as f64;
    let (pieces, before) = (s.pieces, s.locations_before);
    row("  pieces", format!("{pieces} for {before} locations, {share:.3} each; in straight moves {locations}"));
    if let Some(bound) = s.pieces_bound {
        row("  no curve has fewer than", format!("{bound} (times {:.2})", pieces as f64 / bound.max(1) as f64));
    }
    for jerk in s.jerk.iter().filter(|j| j.before > 0.0 || j.now > 0.0) {
        let times = if jerk.now > 0.0 { format!(", 1/{:.1}", jerk.before / jerk.now) } else { String::new() };
        let name = format!("  jerk of {} at full feed", jerk.axis);
        row(&name, format!("{:.0}, before {:.0} per s³{times}", jerk.now, jerk.before));
    }
    if s.left_places > 0 {
        row("  left as it is", format!("{:.1} mm in {} places", s.left_mm, s.left_places));
    }
}

/// Where the time of a program goes, in words.
fn cycle(c: &CycleTime) -> String {
    let parts = [
        ("approach", c.approach_s),
        ("lead-in", c.lead_in_s),
        ("cutting", c.cutting_s),
        ("lead-out", c.lead_out_s),
        ("retract", c.retract_s),
        ("unwinding", c.unwinding_s),
    ];
    let parts: Vec<String> = parts.iter().map(|(name, s)| format!("{name} {s:.1}")).collect();
    format!("{}: {} s", minutes(c.total_s), parts.join(", "))
}

fn minutes(seconds: f64) -> String {
    format!("{}:{:04.1} min", (seconds / 60.0).floor(), seconds % 60.0)
}
