//! The page's words and tables: header, checks, warnings, where it came from.

use super::figures::table;
use super::{ReportInput, escape, figure};
use crate::artifact::report::Check;
use crate::error::turn_number;

/// Header with the verdict and the ways through the page.
pub(super) fn header(input: &ReportInput) -> String {
    let (class, mark, verdict) = verdict(input);
    let (title, blade) = (escape(input.title), escape(&input.blade.name));
    let forced = if input.forced {
        "<p class=\"forced\"><strong>Programs were written although checks failed. Do not run them on a part.</strong></p>"
    } else {
        ""
    };
    format!(
        "<a class=\"skip\" href=\"#main\">Skip to content</a>\n<header>\n<div class=\"top\"><div><p class=\"kicker\">\
         bladewright report</p><h1>{title}</h1><p class=\"sub\">Blade {blade}, machine {}</p></div>\
         <button id=\"theme\" type=\"button\" aria-pressed=\"false\">Dark</button></div>\n\
         <p class=\"verdict {class}\"><span aria-hidden=\"true\">{mark}</span> {verdict}</p>\n{forced}\n\
         <nav aria-label=\"Sections\"><a href=\"#view\">3-D view</a><a href=\"#figures\">Figures</a><a href=\"#sheet\">Setup</a><a href=\"#checks\">Checks</a>\
         <a href=\"#channel\">Channel</a><a href=\"#axes\">Axes</a><a href=\"#scallop\">Scallop</a>\
         <a href=\"#compare\">Compared</a><a href=\"#sections\">Sections</a><a href=\"#job\">Job</a></nav>\n</header>\n",
        escape(&input.machine.name)
    )
}

fn verdict(input: &ReportInput) -> (&'static str, &'static str, String) {
    let Some(report) = input.checks.filter(|r| !r.checks.is_empty()) else {
        return ("none", "?", "Not checked".into());
    };
    let (all, bad) = (report.checks.len(), report.checks.iter().filter(|c| !c.passed).count());
    if bad == 0 {
        ("good", "✓", format!("All {all} checks passed"))
    } else {
        let names: Vec<String> = report.checks.iter().filter(|c| !c.passed).map(|c| c.id.to_string()).collect();
        ("bad", "✗", format!("{bad} of {all} checks failed: {}", escape(&names.join(", "))))
    }
}

/// Table of all checks.
pub(super) fn checks(input: &ReportInput) -> String {
    let mut out = String::from("<section id=\"checks\"><h2>Checks</h2>\n");
    let Some(report) = input.checks.filter(|r| !r.checks.is_empty()) else {
        out.push_str("<p>Nothing was checked in this run.</p></section>\n");
        return out;
    };
    let mut body = String::new();
    for (k, c) in report.checks.iter().enumerate() {
        let (class, word) = if c.passed { ("good", "✓ passed") } else { ("bad", "✗ failed") };
        body.push_str(&format!(
            "<tr><td class=\"{class}\">{word}</td><th scope=\"row\">{}</th><td class=\"n\">{}</td>\
             <td class=\"n\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            escape(&c.id.to_string()),
            figure(&input.verify, &format!("/checks/{k}/worst")),
            figure(&input.verify, &format!("/checks/{k}/limit")),
            escape(&c.unit),
            escape(&c.quantity),
            place(c)
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
    out.push_str(&table("Table of checks", &head, &body));
    out.push_str("</section>\n");
    out
}

fn place(c: &Check) -> String {
    let mut words = Vec::new();
    if let Some(t) = c.turn {
        words.push(format!("turn {}", turn_number(t)));
    }
    if let Some(r) = c.row {
        words.push(format!("<button type=\"button\" class=\"go\" data-row=\"{r}\">location {r}</button>"));
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
pub(super) fn warnings(input: &ReportInput) -> String {
    if input.warnings.is_empty() {
        return String::new();
    }
    let items: String = input
        .warnings
        .iter()
        .map(|w| format!("<li><b>{}</b>: {}</li>", w.stage, escape(&w.doubt.to_string())))
        .collect();
    format!("<section id=\"warnings\"><h2>Warnings</h2><ul>{items}</ul></section>\n")
}

/// The job, where it came from, what was recognised.
pub(super) fn provenance(input: &ReportInput) -> String {
    let mut rows: String = input
        .provenance
        .iter()
        .map(|(k, v)| format!("<tr><th scope=\"row\">{}</th><td><code>{}</code></td></tr>", escape(k), escape(v)))
        .collect();
    let diagnosis = &input.blade.diagnosis;
    for (name, value) in [("Model format", &diagnosis.format), ("Unit", &diagnosis.unit_reason)] {
        if !value.is_empty() {
            rows.push_str(&format!("<tr><th scope=\"row\">{name}</th><td>{}</td></tr>", escape(value)));
        }
    }
    let reasons = input.blade.regions.reasons.iter().cloned();
    let reasons = reasons.chain(diagnosis.notes.iter().map(ToString::to_string));
    let reasons: String = reasons.map(|r| format!("<li>{}</li>", escape(&r))).collect();
    let recognised = if reasons.is_empty() { String::new() } else { format!("<h3>Recognised</h3><ul>{reasons}</ul>") };
    let job = if input.job_toml.is_empty() {
        "<p>No job was given.</p>".into()
    } else {
        format!(
            "<details><summary>Resolved job (TOML)</summary><pre tabindex=\"0\">{}</pre></details>",
            escape(input.job_toml)
        )
    };
    format!(
        "<section id=\"job\"><h2>Job and origin</h2><div class=\"scroll\"><table class=\"plain\"><tbody>{rows}</tbody>\
         </table></div>{recognised}{job}</section>\n"
    )
}
