//! `family.html`: one self-contained page over all members: a table that sorts, small pictures,
//! charts across the family. Its script is `viewer/dist/family.js`, built from `viewer/src`, which
//! draws charts as the report does.

use serde_json::{Value, json};

use super::columns::{Column, TableCell};
use super::record::{Record, Status};
use crate::error::{Error, Result, Stage};

/// Columns that stand in the table at once; all others can be shown.
const SHOWN: [&str; 12] = [
    "name",
    "status",
    "stage",
    "reason",
    "machining_time_s",
    "path_length_mm",
    "turns",
    "scallop_p99_mm",
    "gouge_mm",
    "clearance_mm",
    "channel_width_min_deg",
    "uncut_area_mm2",
];

/// The page's script, with the licences of what it was built from at its head.
const SCRIPT: &str = include_str!("../../viewer/dist/family.js");
/// The style of charts, and the colours of all pages.
const STYLE: &str = include_str!("../../viewer/dist/viewer.css");

/// The page; `columns` are those of the tables.
///
/// # Errors
/// `InputOutput` where the data cannot be encoded.
pub(super) fn html(name: &str, records: &[Record], columns: &[Column]) -> Result<String> {
    let data = json!({
        "columns": columns.iter().filter(|c| c.name != "key").map(|c| json!({
            "name": c.name,
            "shown": SHOWN.contains(&c.name.as_str()) || records.iter().any(|r| r.parameters.contains_key(&c.name)),
            "cells": c.cells.iter().map(value).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "links": records.iter().map(link).collect::<Vec<_>>(),
        "pictures": records.iter().map(|r| r.picture.as_ref().map(super::Picture::svg)).collect::<Vec<_>>(),
    });
    let data = serde_json::to_string(&data)
        .map_err(|e| Error::io(Stage::Output, format!("the page's data cannot be encoded: {e}")).caused_by(e))?
        // Inside a script element the text must not contain `</script` or `<!--`.
        .replace('<', "\\u003c");
    let count = |s: Status| records.iter().filter(|r| r.status == s).count();
    let counts: Vec<String> = [Status::Good, Status::Findings, Status::Failed, Status::Missing]
        .into_iter()
        .filter(|s| count(*s) > 0)
        .map(|s| format!("<span class=\"tag {0}\">{1} {0}</span>", s.word(), count(s)))
        .collect();
    let title = escape(name);
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title} – bladewright family</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}{css}</style>\n</head>\n<body>\n\
         <header><div><h1>{title}</h1><p>{n} members: {counts}</p></div>\n\
         <button id=\"theme\" type=\"button\" aria-pressed=\"false\">Dark</button></header>\n<main>\n{body}</main>\n\
         <script type=\"application/json\" id=\"data\">{data}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
        css = include_str!("page.css"),
        n = records.len(),
        counts = counts.join(" "),
        body = include_str!("page_body.html"),
    ))
}

fn value(cell: &TableCell) -> Value {
    match cell {
        TableCell::Empty => Value::Null,
        TableCell::Integer(i) => json!(i),
        TableCell::Number(x) => json!(x),
        TableCell::Truth(b) => json!(b),
        TableCell::Text(s) => json!(s),
    }
}

/// The member's report, where it has one.
fn link(record: &Record) -> Option<String> {
    record.files.contains_key("report.html").then(|| format!("members/{}/report.html", encoded(&record.name)))
}

/// A name as part of an address.
fn encoded(name: &str) -> String {
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"-_.".contains(&b);
    name.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
