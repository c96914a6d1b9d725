//! Lines of a program: comments in plain ASCII.

use crate::artifact::program::{CutLine, CycleTime};
use crate::artifact::toolpath::PathKind;
use crate::error::{Error, Result, Stage};

use super::OperationRun;
use super::dialect::{Numbered, PostFile};

/// Printable ASCII only, so that no control chokes and no text can end a comment; signs that our
/// own texts use are spelt out.
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

/// ASCII text in pieces of at most `room` characters, parted at a space where there is one in the
/// second half of a piece; one piece at least.
fn wrapped(text: &str, room: usize) -> Vec<&str> {
    let mut out = Vec::new();
    let mut rest = text;
    while rest.len() > room {
        let space = rest[..=room].rfind(' ').filter(|at| *at > room / 2);
        let (piece, behind) = rest.split_at(space.unwrap_or(room));
        out.push(piece);
        rest = behind.strip_prefix(' ').unwrap_or(behind);
    }
    out.push(rest);
    out
}

/// The lines being written.
pub(super) struct Lines<'a> {
    text: String,
    /// How many there are.
    written: usize,
    /// Those that move the tool by the plan.
    cut_lines: Vec<CutLine>,
    file: &'a PostFile,
    /// The next line's number.
    next: u64,
    /// The next block is one of those that have a number where not all have.
    marked: bool,
}

/// Where the number of lines and of bytes will stand, each as wide as it may become.
const LINES: &str = "<<lines>>";
const BYTES: &str = "<<bytes>>>";

impl<'a> Lines<'a> {
    pub(super) fn new(file: &'a PostFile) -> Self {
        let next = file.numbering.as_ref().map_or(0, |n| n.first);
        Lines { text: String::new(), written: 0, cut_lines: Vec::new(), file, next, marked: false }
    }
    /// The next block is one that an operator would begin with.
    pub(super) fn mark(&mut self) {
        self.marked = true;
    }
    /// A comment that says how large the program is, once that is known.
    pub(super) fn size_to_come(&mut self) {
        self.comment(&format!("Size     {LINES} lines, {BYTES} bytes"));
    }
    /// The last line has brought the tool to where the plan has it at that time.
    pub(super) fn cut_until(&mut self, until_s: f64) {
        self.cut_lines.push(CutLine { line: self.written, until_s });
    }
    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
        self.written += 1;
    }
    /// The text with its size, and its lines that move the tool by the plan.
    pub(super) fn finished(self) -> (String, Vec<CutLine>) {
        let (lines, bytes) = (self.written, self.text.len());
        let in_place = |number: usize, place: &str| format!("{number:>width$}", width = place.len());
        let text = self.text.replacen(LINES, &in_place(lines, LINES), 1).replacen(BYTES, &in_place(bytes, BYTES), 1);
        (text, self.cut_lines)
    }
    /// A comment, wrapped at the longest line.
    pub(super) fn comment(&mut self, text: &str) {
        let file = self.file;
        let [before, after] = &file.comment;
        let mut text = ascii(text);
        if before.contains('(') {
            // A bracket inside would end the comment.
            text = text.replace('(', "[").replace(')', "]");
        }
        let everything = file.numbering.as_ref().is_some_and(|n| n.everything);
        let room =
            file.longest_line.saturating_sub(before.len() + after.len() + if everything { 8 } else { 0 }).max(10);
        for piece in wrapped(&text, room) {
            let number = if everything { self.number() } else { String::new() };
            self.line(&format!("{number}{before}{piece}{after}"));
        }
    }
    /// A block.
    ///
    /// # Errors
    /// It is too long, and the dialect has no sign for lines that go on.
    pub(super) fn block(&mut self, text: &str) -> Result<()> {
        // The tape's own signs have no numbers.
        let bare = text == "%" || (text.starts_with('O') && text[1..].chars().all(|c| c.is_ascii_digit()));
        let numbered = if bare { text.to_owned() } else { format!("{}{text}", self.number()) };
        let mut rest = numbered.as_str();
        while rest.len() > self.file.longest_line {
            let (sign, longest) = match &self.file.continuation {
                Some(sign) => (sign, self.file.longest_line - sign.len()),
                None => return Err(self.too_long(&numbered)),
            };
            let at = rest[..longest].rfind(',').ok_or_else(|| self.too_long(&numbered))? + 1;
            self.line(&format!("{}{sign}", &rest[..at]));
            rest = &rest[at..];
        }
        self.line(rest);
        Ok(())
    }

    fn too_long(&self, text: &str) -> Error {
        Error::usage(
            Stage::Post,
            format!(
                "a block of {} characters is longer than longest_line = {}: {text}",
                text.len(),
                self.file.longest_line
            ),
        )
        .advise("raise longest_line in the post file, or write fewer digits")
    }

    /// The number of the next line with a space, if lines have numbers.
    fn number(&mut self) -> String {
        let Some(n) = &self.file.numbering else { return String::new() };
        if n.at == Numbered::Turns && !std::mem::take(&mut self.marked) {
            return String::new();
        }
        let now = if self.file.greatest_number().is_some_and(|most| self.next > most) { n.first } else { self.next };
        self.next = now + n.step;
        format!("{}{now} ", n.prefix)
    }
}

/// What the program is, at its very head.
pub(super) fn title(run: &OperationRun, lines: &mut Lines, control: &str) {
    lines.comment(&"=".repeat(78));
    let name = &run.options.program_name;
    lines.comment(&format!("{name}  for {control}, by bladewright {}", env!("CARGO_PKG_VERSION")));
}

/// The comments at the head of every program, under its title.
pub(super) fn header(run: &OperationRun, cycle: &CycleTime, beyond_mm: f64, lines: &mut Lines) {
    let (o, t) = (run.options, run.tool);
    lines.comment(&format!("Part     {}  file {}", run.blade.name, o.part_file));
    if let Some([blade, of]) = o.blade {
        lines.comment(&format!("Blade    {blade} of {of} of the wheel"));
    }
    lines.comment(&format!("Hash     {}", o.part_hash));
    lines.comment(&format!("Job      {}", o.job));
    lines.comment(&format!("Machine  {}", run.machine.name));
    for axis in run.machine.axes().iter().filter(|a| a.counts_diameter) {
        lines.comment(&format!(
            "DIAMETER words of {} are twice its position: the control must count diameters",
            axis.name
        ));
    }
    let assumed = run.machine.assumed_limits();
    if !assumed.is_empty() {
        lines.comment(&format!(
            "LIMITS   of {} are ASSUMED, not measured: times below are estimates",
            assumed.join(" ")
        ));
    }
    let (end, from) = match t.corner_radius_mm {
        None => (format!("ball end, R {:.4} mm", t.radius_mm), "ball"),
        Some(corner) => (format!("end mill, R {:.4} mm, corner R {corner:.4} mm", t.radius_mm), "corner"),
    };
    lines.comment(&format!(
        "Tool     T{}  {end}, half angle of taper {:.3} deg, shank R {:.3} mm, stick-out {:.3} mm from the {from} centre",
        o.settings.tool_number, t.taper_deg, t.shank_radius_mm, t.stickout_mm
    ));
    for (i, h) in t.holder.iter().enumerate() {
        lines.comment(&format!("Holder {} R {:.3} mm, {:.3} mm long", i + 1, h.radius_mm, h.length_mm));
    }
    path_and_leads(run, lines);
    lines.comment(&format!("Time     {:.1} s of cutting", run.plan.motion.time_s));
    lines.comment(&format!(
        "Cycle    {:.1} s: approach {:.1}, lead-in {:.1}, cutting {:.1}, lead-out {:.1}, retract {:.1}, unwinding {:.1}",
        cycle.total_s,
        cycle.approach_s,
        cycle.lead_in_s,
        cycle.cutting_s,
        cycle.lead_out_s,
        cycle.retract_s,
        cycle.unwinding_s
    ));
    lines.comment("         [without tool change and the way to over the part]");
    checks(run, lines);
    notes(run, lines);
    if beyond_mm > 0.0 {
        lines.comment("CAUTION  the least tolerance that the control can keep is more than the checks leave of the gouge limit: with it");
        lines.comment(&format!("         the part may be cut {beyond_mm:.6} mm deeper than that."));
    }
    lines.comment(&"=".repeat(78));
}

/// What the tool runs along.
fn path_and_leads(run: &OperationRun, lines: &mut Lines) {
    let (o, path) = (run.options, &run.plan.toolpath);
    let what = match path.kind {
        PathKind::Given => "as given".to_owned(),
        PathKind::HubRows => format!("{} rows", path.turns.len()),
        _ => format!("helix of {} turns", path.turns.len()),
    };
    lines.comment(&format!(
        "Path     {what}, {} locations, {:.1} mm, blade axis x {:.3} to {:.3} mm",
        path.locations.len(),
        path.locations.last().map_or(0.0, |l| l.s_mm),
        path.region_x_mm[0],
        path.region_x_mm[1]
    ));
    if let Some(turn) = o.from_turn {
        lines.comment(&format!("GOES ON with turn {turn}: the turns before it must have been cut"));
    }
    for (name, lead) in ["Lead-in ", "Lead-out"].into_iter().zip(&run.plan.leads) {
        let why = lead.why();
        lines.comment(&match lead.is_arc() {
            true => format!(
                "{name} arc of radius {:.3} mm, {:.1} deg, tangential to the path{why}",
                lead.radius_mm,
                lead.angle_rad.to_degrees()
            ),
            false => format!("{name} straight along the tool axis{why}"),
        });
    }
    if path.stock_mm > 0.0 {
        lines.comment(&format!("Stock    {} mm stay on the part", path.stock_mm));
    }
    match path.kind {
        PathKind::Given => lines.comment(&format!("Chords   within {} mm", path.chord_mm)),
        _ => {
            lines.comment(&format!("Scallop  {} mm asked for, chord tolerance {} mm", path.scallop_mm, path.chord_mm));
        }
    }
}

fn checks(run: &OperationRun, lines: &mut Lines) {
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
        let unit = if c.unit.is_empty() { String::new() } else { format!(" {}", c.unit) };
        lines.comment(&format!("  {verdict} {}: {:.6}{unit}, limit {:.6}{unit}", c.id, c.worst, c.limit));
    }
}

fn notes(run: &OperationRun, lines: &mut Lines) {
    let stages: Vec<f64> = run.tool.segments().iter().flat_map(|s| [s.r0, s.r1]).collect();
    if stages.windows(2).any(|w| w[1] < w[0] - 1e-9) {
        lines.comment("CAUTION  tool or holder narrows towards the spindle: check approach and retract by hand.");
    }
    if run.ends.iter().any(|e| !e.clear) {
        lines.comment("CAUTION  the travel of the machine ends before the tool is clear of the turning part:");
        lines.comment(&format!(
            "         approach and retract are shortened, and {} is not unwound at the end.",
            run.machine.axes()[run.machine.turning_axis()].name
        ));
    }
}
