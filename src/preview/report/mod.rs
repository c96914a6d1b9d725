//! One self-contained page about a run: verdicts, figures, plots, a 3-D picture, the job and where it all came from.
//!
//! **In**: a [`ReportInput`] of plain references, every part of a run optional. **Out**: HTML text that needs no
//! network: style and script (plain JavaScript, `page.js`) are inside, and the data as JSON. Tables are static; plots
//! are drawn by the script, follow the width of the window and can be read with the keyboard.
//!
//! Plots are thinned: each turn is cut into stretches, and a stretch shows the channel walls where they come *nearest*
//! to the schedule and the *greatest* of its velocities and accelerations, so nothing that matters is smoothed away. Peaks in tables are of all
//! cutter locations. The 3-D picture is in the blade frame, sorted by depth, without perspective.

mod data;
mod figures;
mod scene;
mod tables;
#[cfg(test)]
mod tests;

use crate::artifact::{AxisMotion, Blade, CheckReport, Plan, Schedule, Section};
use crate::error::{Error, Result, Stage};
use crate::machine::Machine;
use crate::observe::Warning;
use crate::tool::Tool;

/// Another schedule for the same path, to compare with.
#[derive(Clone, Copy, Debug)]
pub struct Baseline<'a> {
    /// What it is, e.g. `fixed lead`.
    pub name: &'a str,
    /// Its angles, one per cutter location of the plan.
    pub schedule: &'a Schedule,
    /// Its axis motion, if it was computed.
    pub motion: Option<&'a AxisMotion>,
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
    pub baseline: Option<Baseline<'a>>,
    /// Plane sections.
    pub sections: &'a [Section],
    /// What the checks found; `None`: nothing was checked.
    pub checks: Option<&'a CheckReport>,
    /// Programs were written although checks failed.
    pub forced: bool,
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
/// `InputOutput` where the data cannot be encoded; numbers that are not finite are shown as missing.
pub fn html(input: &ReportInput) -> Result<String> {
    let data = serde_json::to_string(&data::payload(input))
        .map_err(|e| Error::io(Stage::Preview, format!("the report's data cannot be encoded: {e}")).caused_by(e))?
        // Inside a script element the text must not contain `</script` or `<!--`.
        .replace('<', "\\u003c");
    let mut page = String::with_capacity(data.len() + 64 * 1024);
    page.push_str("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
    page.push_str(&format!("<title>{} – bladewright report</title>\n", escape(input.title)));
    page.push_str(&format!("<style>\n{}</style>\n</head>\n<body>\n", include_str!("page.css")));
    page.push_str(&tables::header(input));
    page.push_str("<main id=\"main\">\n");
    page.push_str(&figures::figures(input));
    page.push_str(&tables::checks(input));
    page.push_str(&figures::axes(input));
    page.push_str(include_str!("plots.html"));
    page.push_str(&figures::scallop(input));
    page.push_str(&tables::warnings(input));
    page.push_str(&tables::provenance(input));
    page.push_str("</main>\n");
    page.push_str(&format!("<script id=\"data\" type=\"application/json\">{data}</script>\n"));
    page.push_str(&format!("<script>\n{}</script>\n</body>\n</html>\n", include_str!("page.js")));
    Ok(page)
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
