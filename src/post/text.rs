//! Lines of a program: comments in plain ASCII, numbers in fixed point.

use crate::error::{Error, Result, Stage};

use super::Run;

/// Longest line written; LinuxCNC reads at most 255 characters.
pub(super) const LINE: usize = 200;

/// A number in fixed point, exactly as rounded: an integer count of `10^-decimals`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fixed {
    units: i64,
    decimals: usize,
}

impl Fixed {
    /// Rounds to `decimals` digits after the point.
    ///
    /// # Errors
    /// A value that is not finite or beyond ±10⁹.
    pub(super) fn new(value: f64, decimals: usize) -> Result<Self> {
        if !(value.is_finite() && value.abs() < 1e9) {
            return Err(Error::usage(Stage::Post, format!("{value} cannot be written as a word of a program")));
        }
        let scale = 10f64.powi(i32::try_from(decimals).unwrap_or(6));
        // The cast is exact: |value · scale| < 1e15 for at most 6 decimals.
        Ok(Fixed { units: (value * scale).round() as i64, decimals })
    }
    /// The difference from an earlier rounded number: adds up without error.
    pub(super) fn since(self, earlier: Fixed) -> Fixed {
        Fixed { units: self.units - earlier.units, decimals: self.decimals }
    }
}

impl std::fmt::Display for Fixed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let sign = if self.units < 0 { "-" } else { "" };
        let magnitude = self.units.unsigned_abs();
        if self.decimals == 0 {
            return write!(f, "{sign}{magnitude}");
        }
        let one = 10u64.pow(u32::try_from(self.decimals).unwrap_or(6));
        write!(f, "{sign}{}.{:0width$}", magnitude / one, magnitude % one, width = self.decimals)
    }
}

/// Printable ASCII only, so that no control chokes and no text can end a comment; signs that our own texts use are spelt out.
pub(super) fn ascii(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '²' => out.push_str("^2"),
            '³' => out.push_str("^3"),
            '°' => out.push_str(" deg"),
            'θ' => out.push_str("theta"),
            '–' | '−' => out.push('-'),
            c if c.is_ascii_graphic() || c == ' ' => out.push(c),
            _ => out.push('?'),
        }
    }
    out
}

/// The lines being written.
pub(super) struct Lines {
    pub(super) text: String,
    /// `Some(next)`: lines are numbered `N…`.
    number: Option<u64>,
}

impl Lines {
    pub(super) fn new(numbered: bool) -> Self {
        Lines { text: String::new(), number: numbered.then_some(10) }
    }
    /// A comment, wrapped at [`LINE`] characters.
    pub(super) fn comment(&mut self, text: &str) {
        let text = ascii(text);
        for piece in text.as_bytes().chunks(LINE - 2) {
            self.text.push_str("; ");
            self.text.push_str(&String::from_utf8_lossy(piece));
            self.text.push('\n');
        }
    }
    /// A block.
    pub(super) fn block(&mut self, text: &str) {
        if let Some(n) = &mut self.number {
            self.text.push_str(&format!("N{n} "));
            *n += 10;
        }
        self.text.push_str(text);
        self.text.push('\n');
    }
}

/// The comments at the head of every program.
pub(super) fn header(run: &Run, lines: &mut Lines, control: &str) {
    let (o, t, path) = (run.options, run.tool, &run.plan.toolpath);
    lines.comment(&"=".repeat(78));
    lines.comment(&format!("{}  for {control}, by bladewright {}", o.program_name, env!("CARGO_PKG_VERSION")));
    lines.comment(&format!("Part     {}  file {}", run.blade.name, o.part_file));
    lines.comment(&format!("Hash     {}", o.part_hash));
    lines.comment(&format!("Job      {}", o.job));
    lines.comment(&format!("Machine  {}", run.machine.name));
    lines.comment(&format!(
        "Tool     T{}  ball end, R {:.4} mm, half angle of taper {:.3} deg, shank R {:.3} mm, stick-out {:.3} mm from \
         the ball centre",
        o.tool_number, t.radius_mm, t.taper_deg, t.shank_radius_mm, t.stickout_mm
    ));
    for (i, h) in t.holder.iter().enumerate() {
        lines.comment(&format!("Holder {} R {:.3} mm, {:.3} mm long", i + 1, h.radius_mm, h.length_mm));
    }
    lines.comment(&format!(
        "Path     helix of {} turns, {} locations, {:.1} mm, blade axis x {:.3} to {:.3} mm",
        path.turns.len(),
        path.locations.len(),
        path.locations.last().map_or(0.0, |l| l.s_mm),
        path.region_x_mm[0],
        path.region_x_mm[1]
    ));
    if path.stock_mm > 0.0 {
        lines.comment(&format!("Stock    {} mm stay on the part", path.stock_mm));
    }
    lines.comment(&format!("Scallop  {} mm asked for, chord tolerance {} mm", path.scallop_mm, path.chord_mm));
    lines.comment(&format!("Time     {:.1} s of cutting", run.plan.motion.time_s));
    checks(run, lines);
    notes(run, lines);
    lines.comment(&"=".repeat(78));
}

fn checks(run: &Run, lines: &mut Lines) {
    if run.forced {
        lines.comment("NOT VERIFIED: CHECKS FAILED, PROGRAM WRITTEN ON REQUEST. DO NOT RUN ON A PART.");
    } else {
        lines.comment("Verified before posting:");
    }
    if run.report.checks.is_empty() {
        lines.comment("  no check was made");
    }
    for c in &run.report.checks {
        let verdict = if c.passed { "ok    " } else { "FAILED" };
        lines.comment(&format!("  {verdict} {}: {:.6} {u}, limit {:.6} {u}", c.name, c.worst, c.limit, u = c.unit));
    }
}

fn notes(run: &Run, lines: &mut Lines) {
    let stages: Vec<f64> = run.tool.segments().iter().flat_map(|s| [s.r0, s.r1]).collect();
    if stages.windows(2).any(|w| w[1] < w[0] - 1e-9) {
        lines.comment("CAUTION  tool or holder narrows towards the spindle: check approach and retract by hand.");
    }
    if run.ends.iter().any(|e| !e.clear) {
        lines.comment("CAUTION  the travel of the machine ends before the tool is clear of the turning part:");
        lines.comment("         approach and retract are shortened, and A is not unwound at the end.");
    }
}
