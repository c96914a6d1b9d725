//! The page's words and tables: header, checks, warnings, where it came from.

use super::figures::table;
use super::{File, ReportInput, escape, figure};
use crate::artifact::Blade;
use crate::artifact::report::Check;
use crate::error::turn_number;
use crate::observe::Warning;

/// What the head of a page says.
pub(super) struct Head<'a> {
    /// Title of the page.
    pub(super) title: &'a str,
    /// Name of the blade.
    pub(super) blade: &'a str,
    /// Name of the machine.
    pub(super) machine: &'a str,
    /// All checks.
    pub(super) checks: Vec<&'a Check>,
    /// Programs were written although checks failed.
    pub(super) forced: bool,
    /// Sections that can be gone to, by their ids and names.
    pub(super) nav: &'a [(&'a str, &'a str)],
}

/// Header with the verdict and the ways through the page.
pub(super) fn header(head: &Head) -> String {
    let (class, mark, verdict) = verdict(&head.checks);
    let (title, blade) = (escape(head.title), escape(head.blade));
    let nav: String = head.nav.iter().map(|(id, name)| format!("<a href=\"#{id}\">{name}</a>")).collect();
    let forced = if head.forced {
        "<p class=\"forced\"><strong>Programs were written although checks failed. Do not run them on a part.</strong></p>"
    } else {
        ""
    };
    format!(
        "<a class=\"skip\" href=\"#main\">Skip to content</a>\n<header>\n<div class=\"top\"><div><p class=\"kicker\">\
         bladewright report</p><h1>{title}</h1><p class=\"sub\">Blade {blade}, machine {}</p></div>\
         <button id=\"theme\" type=\"button\" aria-pressed=\"false\">Dark</button></div>\n\
         <p class=\"verdict {class}\"><span aria-hidden=\"true\">{mark}</span> {verdict}</p>\n{forced}\n\
         <nav aria-label=\"Sections\">{nav}</nav>\n</header>\n",
        escape(head.machine)
    )
}

fn verdict(checks: &[&Check]) -> (&'static str, &'static str, String) {
    if checks.is_empty() {
        return ("none", "?", "Not checked".into());
    }
    let all = checks.len();
    let failed: Vec<String> = checks.iter().filter(|c| !c.passed).map(|c| c.id.to_string()).collect();
    if failed.is_empty() {
        ("good", "✓", format!("All {all} checks passed"))
    } else {
        ("bad", "✗", format!("{} of {all} checks failed: {}", failed.len(), escape(&failed.join(", "))))
    }
}

/// Table of all checks.
pub(super) fn checks(input: &ReportInput) -> String {
    let mut out = String::from("<section id=\"checks\"><h2>Checks</h2>\n");
    let Some(report) = input.checks.filter(|r| !r.checks.is_empty()) else {
        out.push_str("<p>Nothing was checked in this run.</p></section>\n");
        return out;
    };
    out.push_str(&check_table("Table of checks", &input.verify, "/checks", &report.checks, PathWords::PLAN));
    out.push_str("</section>\n");
    out
}

/// What the parts and the places of a path are called.
#[derive(Clone, Copy)]
pub(super) struct PathWords {
    /// Part of the path, that is counted from 1.
    pub(super) turn: &'static str,
    /// Place on the path.
    pub(super) location: &'static str,
}

impl PathWords {
    /// A path of turns.
    pub(super) const PLAN: PathWords = PathWords { turn: "turn", location: "location" };
}

/// A table of checks, whose figures stand in a list of a file.
pub(super) fn check_table(label: &str, file: &File, list: &str, checks: &[Check], words: PathWords) -> String {
    let mut body = String::new();
    for (k, c) in checks.iter().enumerate() {
        let (class, word) = if c.passed { ("good", "✓ passed") } else { ("bad", "✗ failed") };
        body.push_str(&format!(
            "<tr><td class=\"{class}\">{word}</td><th scope=\"row\">{}</th><td class=\"n\">{}</td>\
             <td class=\"n\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escape(&c.id.to_string()),
            figure(file, &format!("{list}/{k}/worst")),
            figure(file, &format!("{list}/{k}/limit")),
            escape(&c.unit),
            escape(&c.quantity),
            place(c, words)
        ));
    }
    let head = [
        ("Result", false),
        ("Check", false),
        ("Worst", true),
        ("Limit", true),
        ("Unit", false),
        ("Measured", false),
        ("Where", false),
    ];
    table(label, &head, &body)
}

fn place(c: &Check, PathWords { turn, location }: PathWords) -> String {
    let mut words = Vec::new();
    if let Some(t) = c.turn {
        words.push(format!("{turn} {}", turn_number(t)));
    }
    if let Some(r) = c.row {
        words.push(format!("<button type=\"button\" class=\"go\" data-row=\"{r}\">{location} {r}</button>"));
    }
    if let Some([x, y, z]) = c.point_mm {
        words.push(format!("model ({x:.3}, {y:.3}, {z:.3}) mm"));
    }
    if !c.note.is_empty() {
        words.push(escape(&c.note));
    }
    words.join("; ")
}

/// Warnings of all stages; nothing where there are none.
pub(super) fn warnings(warnings: &[Warning]) -> String {
    if warnings.is_empty() {
        return String::new();
    }
    let items: String =
        warnings.iter().map(|w| format!("<li><b>{}</b>: {}</li>", w.stage, escape(&w.doubt.to_string()))).collect();
    format!("<section id=\"warnings\"><h2>Warnings</h2><ul>{items}</ul></section>\n")
}

/// The job as TOML, where it came from (labels and values), what was recognised in the model.
pub(super) fn provenance(blade: &Blade, job_toml: &str, provenance: &[(String, String)]) -> String {
    let mut rows: String = provenance
        .iter()
        .map(|(k, v)| format!("<tr><th scope=\"row\">{}</th><td><code>{}</code></td></tr>", escape(k), escape(v)))
        .collect();
    let diagnosis = &blade.diagnosis;
    for (name, value) in [("Model format", &diagnosis.format), ("Unit", &diagnosis.unit_reason)] {
        if !value.is_empty() {
            rows.push_str(&format!("<tr><th scope=\"row\">{name}</th><td>{}</td></tr>", escape(value)));
        }
    }
    let reasons = blade.regions.reasons.iter().cloned();
    let reasons = reasons.chain(diagnosis.notes.iter().map(ToString::to_string));
    let reasons: String = reasons.map(|r| format!("<li>{}</li>", escape(&r))).collect();
    let recognised = if reasons.is_empty() { String::new() } else { format!("<h3>Recognised</h3><ul>{reasons}</ul>") };
    let job = if job_toml.is_empty() {
        "<p>No job was given.</p>".into()
    } else {
        format!(
            "<details><summary>Resolved job (TOML)</summary><pre tabindex=\"0\">{}</pre></details>",
            escape(job_toml)
        )
    };
    format!(
        "<section id=\"job\"><h2>Job and origin</h2><div class=\"scroll\"><table class=\"plain\"><tbody>{rows}</tbody>\
         </table></div>{recognised}{job}</section>\n"
    )
}
