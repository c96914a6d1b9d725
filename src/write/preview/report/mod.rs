//! One self-contained page about a run: verdicts, figures, a 3-D view, plots, the job and where it
//! all came from.
//!
//! **In**: a [`ReportInput`] of plain references, every part of a run optional. **Out**: HTML text
//! that needs no network: style, script and data are inside. Tables are static; the 3-D view and
//! the plots are drawn by the script `viewer/dist/viewer.js`, which is built from `viewer/src` with
//! three.js and uPlot by versions that `viewer/package-lock.json` pins. The bundle is part of the
//! repository, so building the product needs no npm, and `npm run check` there says whether it is
//! what its sources make.
//!
//! **Every figure shown is one of `summary.json`, `verify.json` or `compare.json`**: cells name the
//! file and the JSON pointer that they were made from (`data-figure`), and tests compare what is
//! shown with the files. Only the section on the channel's walls counts for itself, in the channel
//! of `plan.json`; what the sheet of setup and tool says of tool, machine and zero point is what
//! the job gives.
//!
//! Plots are thinned: each turn is cut into stretches, and a stretch shows the channel walls where
//! they come *nearest* to the schedule and the *greatest* of its velocities, accelerations and
//! jerks, so nothing that matters is smoothed away. Peaks in tables are of all cutter locations.
//! The 3-D view holds up to 40 000 points of the path and 3 MB of the rest.
//!
//! **Numbers are rounded and the data is deflated**: lengths to 0.001 mm, angles to 0.001°
//! (0.00001 rad in the 3-D view, 0.0001 rad the channel's limits there), times to 0.0001 s, and
//! what plots scale to their own height to a 4000th of the greatest value shown; what is drawn is
//! off by at most half of that (`pack.rs`). The scene is rounded as
//! [`GltfOptions::rounded`](super::GltfOptions::rounded) says. Lines of the program are those of
//! its file, byte for byte (`program.rs`). The page of a path of 47 000 locations is smaller than 4
//! MB.

mod channel;
mod data;
mod figures;
mod free_axes;
mod pack;
mod payload;
pub mod pinch;
mod program;
mod scallop;
mod scene;
mod sheet;
mod tables;
#[cfg(test)]
mod tests;

pub use payload::Payload;
use serde_json::Value;

use crate::artifact::channel::Width;
use crate::artifact::obstacle::Obstacle;
use crate::artifact::sphere::FreeAlong;
use crate::artifact::{Blade, CheckReport, Plan, Program, Section};
use crate::error::Result;
use crate::machine::Machine;
use crate::observe::Warning;
use crate::tool::Tool;
use crate::write::draw::OtherSchedule;

/// The JSON of one of the run's files.
#[derive(Clone, Copy, Debug)]
pub struct File<'a> {
    /// Its name without `.json`.
    pub name: &'static str,
    /// What is in it.
    pub json: &'a Value,
}

/// What a report is made from. All lists may be empty.
#[derive(Clone, Copy)]
pub struct ReportInput<'a> {
    /// Title of the page, e.g. the job's name.
    pub title: &'a str,
    /// The blade.
    pub blade: &'a Blade,
    /// The tool.
    pub tool: &'a Tool,
    /// The machine.
    pub machine: &'a Machine,
    /// The plan, if the run came that far.
    pub plan: Option<&'a Plan>,
    /// What to compare it with.
    pub baseline: Option<OtherSchedule<'a>>,
    /// Schedules for the same path to show beside it in the S–θ plot, the baseline among them.
    pub others: &'a [OtherSchedule<'a>],
    /// `summary.json`.
    pub summary: File<'a>,
    /// `verify.json`.
    pub verify: File<'a>,
    /// `compare.json`, if the run has one.
    pub compare: Option<File<'a>>,
    /// Width of the channel at other angles B; may be empty.
    pub widths: &'a [Width],
    /// Fixtures, stock and the rest of the wheel.
    pub obstacles: &'a [Obstacle],
    /// The free tool axes at some locations of the plan.
    pub free_axes: Option<&'a FreeAlong>,
    /// Plane sections.
    pub sections: &'a [Section],
    /// What the checks found; `None`: nothing was checked.
    pub checks: Option<&'a CheckReport>,
    /// Programs were written although checks failed.
    pub forced: bool,
    /// The program whose lines are shown beside the tool.
    pub program: Option<&'a Program>,
    /// Warnings of all stages.
    pub warnings: &'a [Warning],
    /// The resolved job as TOML.
    pub job_toml: &'a str,
    /// Where it came from: label and value (file, hash, version, date …).
    pub provenance: &'a [(String, String)],
}

/// The page.
///
/// # Errors
/// As [`Payload::of`].
pub fn html(input: &ReportInput) -> Result<String> {
    page(input, &Payload::of(input)?)
}

/// The page with a payload that was made before; of the input only what stands in words and tables
/// counts, and the program.
///
/// # Errors
/// `InputOutput` where the program's lines cannot be encoded.
pub fn page(input: &ReportInput, payload: &Payload) -> Result<String> {
    let free_axes = free_axes::section(input);
    let mut nav = NAV.to_vec();
    if !free_axes.is_empty() {
        nav.insert(1, ("free-axes", "Free axes"));
    }
    let head = tables::Head {
        title: input.title,
        blade: &input.blade.name,
        machine: &input.machine.name,
        checks: input.checks.map(|r| r.checks.iter().collect()).unwrap_or_default(),
        forced: input.forced,
        nav: &nav,
    };
    let sections = [
        filled(include_str!("view.html"), &PLAN_WORDS),
        free_axes.to_owned(),
        figures::figures(input),
        sheet::section(input),
        tables::checks(input),
        include_str!("channel.html").to_owned(),
        filled(include_str!("axes.html"), &PLAN_WORDS),
        channel::section(input),
        figures::axes(input),
        scallop::section(input),
        figures::comparison(input),
        include_str!("sections.html").to_owned(),
        tables::warnings(input.warnings),
        tables::provenance(input.blade, input.job_toml, input.provenance),
    ];
    Ok(shell(&head, &sections, payload, &program::element(input.program)?))
}

/// Sections of the page that can be gone to, and their names.
const NAV: [(&str, &str); 10] = [
    ("view", "3-D view"),
    ("figures", "Figures"),
    ("sheet", "Setup"),
    ("checks", "Checks"),
    ("channel", "Channel"),
    ("axes", "Axes"),
    ("scallop", "Scallop"),
    ("compare", "Compared"),
    ("sections", "Sections"),
    ("job", "Job"),
];

/// What parts of a path and tools are called where a page of one path says it.
const PLAN_WORDS: [(&str, &str); 5] =
    [("turn", "turn"), ("turns", "turns"), ("Turns", "Turns"), ("tools", "the tool"), ("first", "the tool")];

/// A piece of a page with its words: `{turn}` is what the list has for `turn`.
fn filled(piece: &str, words: &[(&str, &str)]) -> String {
    words.iter().fold(piece.to_owned(), |text, (key, word)| text.replace(&format!("{{{key}}}"), word))
}

/// A whole page: its head, its sections, what its script draws, and the element with the lines of a
/// program.
fn shell(head: &tables::Head, sections: &[String], payload: &Payload, program: &str) -> String {
    let mut page = String::with_capacity(payload.len() + 1024 * 1024);
    page.push_str("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    page.push_str(&format!("<title>{} – bladewright report</title>\n", escape(head.title)));
    page.push_str("<link rel=\"icon\" href=\"data:,\">\n");
    page.push_str(&format!("<style>\n{PLOT_STYLE}{}</style>\n</head>\n<body>\n", include_str!("page.css")));
    page.push_str(&tables::header(head));
    page.push_str("<main id=\"main\">\n");
    sections.iter().for_each(|s| page.push_str(s));
    page.push_str("</main>\n");
    payload.write(&mut page);
    page.push_str(program);
    page.push_str(&format!("<script>\n{VIEWER}</script>\n</body>\n</html>\n"));
    page
}

/// The script, with the licences of what it was built from at its head.
const VIEWER: &str = include_str!("../../../../viewer/dist/viewer.js");
/// The style of charts, and the colours of all pages.
const PLOT_STYLE: &str = include_str!("../../../../viewer/dist/viewer.css");

/// A number of one of the run's files as it is shown, with the place that it came from.
fn figure(file: &File, pointer: &str) -> String {
    let value = file.json.pointer(pointer);
    let shown = match value {
        Some(Value::Number(n)) if n.is_u64() => n.to_string(),
        Some(v) => number(v.as_f64().unwrap_or(f64::NAN)),
        None => return "–".into(),
    };
    format!("<span data-figure=\"{}{pointer}\">{shown}</span>", file.name)
}

/// Text as it may stand in HTML, also in attributes.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// A number for people: four digits that count, `–` where there is none.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return "–".into();
    }
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) {
        return format!("{value:.2e}");
    }
    let digits = if size == 0.0 { 0 } else { (3 - size.log10().floor() as i32).clamp(0, 7) };
    let text = format!("{value:.*}", usize::try_from(digits).unwrap_or(0));
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}
