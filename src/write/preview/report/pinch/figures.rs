//! Figures of rows for two tools as static HTML, all of them from `pinch.json`: cards, the sheet of
//! setup and tools, checks, comparison with one tool, programs.

use serde_json::Value;

use super::PinchReport;
use crate::artifact::report::Check;
use crate::write::preview::report::figures::{card, joined, minutes, row, table};
use crate::write::preview::report::sheet::{self, Zero, list};
use crate::write::preview::report::tables::{self, PathWords};
use crate::write::preview::report::{escape, figure, number};

/// Lengths that are rounding and nothing else are shorter, mm.
const NOTHING_MM: f64 = 1e-6;
/// What rows and their places are called.
const ROWS: PathWords = PathWords { turn: "row", location: "place" };

fn value(input: &PinchReport, pointer: &str) -> f64 {
    input.figures.json.pointer(pointer).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

fn text(input: &PinchReport, pointer: &str) -> String {
    input.figures.json.pointer(pointer).and_then(Value::as_str).map(escape).unwrap_or_default()
}

/// A length, mm: what is less than [`NOTHING_MM`] is shown as 0.
fn length(input: &PinchReport, pointer: &str) -> String {
    match value(input, pointer).abs() < NOTHING_MM {
        true => format!("<span data-figure=\"{}{pointer}\">0</span>", input.figures.name),
        false => figure(&input.figures, pointer),
    }
}

fn count(input: &PinchReport, pointer: &str) -> usize {
    input.figures.json.pointer(pointer).and_then(Value::as_array).map_or(0, Vec::len)
}

/// Checks of one list of the figures.
pub(super) struct CheckList {
    /// Of what.
    title: String,
    /// Where they stand in the figures.
    pointer: String,
    /// The checks.
    pub(super) checks: Vec<Check>,
}

/// All lists of checks: of the rows, of the motion, of each program.
pub(super) fn check_lists(input: &PinchReport) -> Vec<CheckList> {
    let of = |title: String, pointer: String| CheckList { checks: input.checks(&pointer), title, pointer };
    let mut out = vec![of("Rows and tools".into(), "/checks".into())];
    if input.motion.is_some() {
        out.push(of("Motion of the axes".into(), "/program/checks".into()));
    }
    for k in 0..count(input, "/program/programs") {
        let at = format!("/program/programs/{k}");
        let title = format!("Program for {}, read back", text(input, &format!("{at}/control")));
        out.push(of(title, format!("{at}/checks")));
    }
    out
}

/// All checks, a table for each list; those of motion and programs are folded where all passed.
pub(super) fn checks(input: &PinchReport, lists: &[CheckList]) -> String {
    let one = |(n, l): (usize, &CheckList)| {
        if l.checks.is_empty() {
            return format!("<h3>{}</h3><p>Nothing was checked.</p>\n", l.title);
        }
        let table = tables::check_table(&l.title, &input.figures, &l.pointer, &l.checks, ROWS);
        if n == 0 {
            return format!("<h3>{}</h3>\n{table}", l.title);
        }
        let (all, failed) = (l.checks.len(), l.checks.iter().filter(|c| !c.passed).count());
        let (open, found) = match failed {
            0 => ("", format!("all {all} checks passed")),
            _ => (" open", format!("{failed} of {all} checks failed")),
        };
        format!("<details{open}><summary><strong>{}</strong>: {found}</summary>\n{table}</details>\n", l.title)
    };
    let body: String = lists.iter().enumerate().map(one).collect();
    format!("<section id=\"checks\"><h2>Checks</h2>\n{body}</section>\n")
}

/// Cards with the figures of the rows, and a table of what was measured.
pub(super) fn cards(input: &PinchReport) -> String {
    let f = |pointer: &str| figure(&input.figures, pointer);
    let mut cards = String::new();
    if input.motion.is_some() {
        let note = joined(&[
            minutes(value(input, "/program/cutting_s")),
            format!(
                "{} of the time of one tool on one side after the other",
                f("/program/share_of_one_after_the_other")
            ),
        ]);
        card(&mut cards, "Both tools cut", &format!("{} s", f("/program/cutting_s")), &note);
    }
    let threads = input.rows.is_double_helix();
    if threads {
        let turns = format!("{} and {} turns", f("/thread_turns/0"), f("/thread_turns/1"));
        let note = format!("threads of tool 1 and tool 2; {} places of both tools; nothing is held", f("/places"));
        card(&mut cards, "Double helix", &turns, &note);
    } else {
        let note = format!("{} of them with the table still; {} places of both tools", f("/still_rows"), f("/places"));
        card(&mut cards, "Rows", &f("/rows"), &note);
    }
    if threads {
        card(&mut cards, "Of the airfoil", &f("/closed"), "of its area is machined");
    } else if value(input, "/edge_rows") > 0.0 {
        let heights = [0, 1].map(|k| length(input, &format!("/edge_heights_mm/{k}"))).join(" – ");
        let note = format!("of the rows, at heights {heights} mm: {} of the airfoil's area is between", f("/closed"));
        card(&mut cards, "Round the edges", &f("/edge_rows"), &note);
    }
    let lengths = format!("{} and {} mm", f("/length_mm/0"), f("/length_mm/1"));
    let of = if threads { "Length of the threads" } else { "Length of the rows" };
    card(&mut cards, of, &lengths, "of tool 1 and tool 2");
    if !threads {
        let shares = format!("{} and {}", f("/covered/0"), f("/covered/1"));
        let note = format!("of its area, tool 1 and tool 2; rows end where {}", text(input, "/ends"));
        card(&mut cards, "Share of the airfoil between the rows", &shares, &note);
    }
    let note = format!(
        "place {}; tool 1 alone {}°, tool 2 alone {}°",
        f("/narrowest_place"),
        f("/narrowest_own_deg/0"),
        f("/narrowest_own_deg/1")
    );
    card(&mut cards, "Free for both tools, at least", &format!("{}°", f("/narrowest_deg")), &note);
    let cutting = match value(input, "/turned_cutting_deg") > 0.0 {
        true => format!("; {}° more while both tools cut", f("/turned_cutting_deg")),
        false => String::new(),
    };
    let note = format!("from stretch to stretch, in all{cutting}; {} stretches", f("/stretches"));
    card(&mut cards, "Table turns", &format!("{}°", f("/turned_deg")), &note);
    let apart = format!("{} mm", f("/measured/tools_apart_mm"));
    card(&mut cards, "Tools are apart, at least", &apart, "the blade is between them");
    let heights = [0, 1].map(|k| length(input, &format!("/heights_mm/{k}"))).join(" – ");
    let heights = format!("{heights} mm");
    card(&mut cards, "Heights", &heights, "of the ball centre of tool 1 along the blade axis");
    if value(input, "/cut_off") > 0.0 {
        card(&mut cards, "Places cut off", &f("/cut_off"), "no angle of the table is free for both tools there");
    }
    let measured = measured(input);
    format!("<section id=\"figures\"><h2>Figures</h2><dl class=\"cards\">{cards}</dl>\n{measured}</section>\n")
}

/// Percentiles of what was measured.
fn measured(input: &PinchReport) -> String {
    let line = |name: &str, key: &str, at: [Option<usize>; 5]| {
        let cell = |k: &Option<usize>| k.map_or_else(String::new, |k| length(input, &format!("/measured/{key}/{k}")));
        row(name, at.iter().map(cell))
    };
    let ridges = [Some(0), Some(1), Some(2), Some(3), Some(4)];
    let three = [None, Some(0), None, Some(1), Some(2)];
    let body = [
        line("ridges of tool 1, mm", "ridges_mm/0", ridges),
        line("ridges of tool 2, mm", "ridges_mm/1", ridges),
        if input.rows.is_double_helix() {
            String::new()
        } else {
            line("the higher of both, mm", "binding_ridges_mm", ridges)
        },
        if value(input, "/edge_rows") > 0.0 && !input.rows.is_double_helix() {
            line("where rows round the edges meet the others, mm", "border_ridges_mm", ridges)
        } else {
            String::new()
        },
        line("distance of the normal lines, mm", "line_distance_mm", three),
        line("what the normals lack of being opposite (β), °", "angle_deg", three),
    ]
    .concat();
    let head =
        [("Measured", false), ("5 %", true), ("median", true), ("95 %", true), ("99 %", true), ("greatest", true)];
    let asked = format!(
        "<p>Asked for: ridges of at most {} mm, normal lines within {} mm (99 %), β at most {}°.</p>",
        number(input.rows.scallop_mm),
        number(input.line_distance_mm),
        number(input.max_angle_deg)
    );
    format!("<h3>Ridges and opposition</h3>\n{}{asked}\n", table("Ridges and opposition", &head, &body))
}

/// The sheet of setup and tools; its style prints it on a page of its own.
pub(super) fn sheet(input: &PinchReport) -> String {
    let of_model = |label: &str| input.provenance.iter().find(|(l, _)| l == label).map(|(_, v)| escape(v));
    let files = (0..count(input, "/program/programs")).flat_map(|k| files_of(input, k)).collect::<Vec<_>>();
    let part = list(
        "Part",
        &[
            ("Blade", escape(&input.blade.name)),
            ("Model", of_model("Model").unwrap_or_default()),
            ("BLAKE3", of_model("BLAKE3 of the model").map(|h| format!("<code>{h}</code>")).unwrap_or_default()),
            ("Programs", files.join(", ")),
        ],
    );
    let degrees = |rad: f64| number(rad.to_degrees()).replace('-', "−");
    let [first, second] = input.leans_rad.map(degrees);
    let lean = format!("tool 1 leans {first}°, tool 2 leans {second}° towards the tip");
    let zero = sheet::zero(&Zero { blade: input.blade, machine: input.machine, obstacles: input.obstacles, lean });
    let tools: String = (0..2)
        .map(|k| {
            let rpm = format!("{} 1/min", number(input.spindle_rpm[k]));
            let tool = sheet::one_tool(&format!("Tool {}", k + 1), input.tools[k], &[("Spindle", rpm)]);
            format!("<div>{tool}</div>")
        })
        .collect();
    format!(
        "<section id=\"sheet\"><h2>Setup and tools</h2>\n<p class=\"hint\"><button type=\"button\" id=\"print-sheet\">Print this sheet \
         alone</button></p>\n<div class=\"pair two\"><div>{part}</div><div>{zero}</div>{tools}</div>\n{}</section>\n",
        sheet::limits(input.machine)
    )
}

/// Time of both tools beside that of one.
pub(super) fn compared(input: &PinchReport) -> String {
    let f = |key: &str| figure(&input.figures, &format!("/program/{key}"));
    let all = value(input, "/program/one_after_the_other_s");
    let line = |name: &str, key: &str| {
        let share = number(100.0 * value(input, &format!("/program/{key}")) / all);
        row(name, [f(key), share].into_iter())
    };
    let body = [
        line("both tools at the same time", "cutting_s"),
        line("&emsp;at full feed all along", "full_feed_s"),
        line("tool 1 alone, on its side", "alone_s/0"),
        line("tool 2 alone, on its side", "alone_s/1"),
        line("one side after the other", "one_after_the_other_s"),
    ]
    .concat();
    let head = [("Rows cut by", false), ("time, s", true), ("% of one side after the other", true)];
    format!(
        "<section id=\"compare\"><h2>Compared with one tool</h2>\n<p>The same rows under the same limits of the axes; the other head stands still while \
         one tool cuts alone. No motion is faster than at full feed all along. Ways from row to row are left out.</p>\n{}</section>\n",
        table("Compared with one tool", &head, &body)
    )
}

/// Names of the files of a program.
fn files_of(input: &PinchReport, program: usize) -> Vec<String> {
    let at = format!("/program/programs/{program}/files");
    (0..count(input, &at)).map(|k| text(input, &format!("{at}/{k}"))).collect()
}

/// The programs, and whether reading them back found anything.
pub(super) fn programs(input: &PinchReport, lists: &[CheckList]) -> String {
    let n = count(input, "/program/programs");
    // A program is written where all of rows, motion and its own text passed.
    let passed =
        |pointer: &str| lists.iter().filter(|l| l.pointer == pointer).flat_map(|l| &l.checks).all(|c| c.passed);
    let before = passed("/checks") && passed("/program/checks");
    let line = |k: usize| {
        let at = format!("/program/programs/{k}");
        let own = format!("{at}/checks");
        let (class, word) = match before && passed(&own) {
            true => ("good", "✓ written"),
            false => ("bad", "✗ not written: a check failed"),
        };
        let checks = lists.iter().filter(|l| l.pointer == own).map(|l| l.checks.len()).sum::<usize>();
        format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{checks}</td><td class=\"{class}\">{word}</td></tr>\n",
            text(input, &format!("{at}/control")),
            files_of(input, k).join(", "),
            figure(&input.figures, &format!("{at}/lines"))
        )
    };
    let body: String = (0..n).map(line).collect();
    let head =
        [("Control", false), ("Files", false), ("lines", true), ("checks of reading back", true), ("Result", false)];
    let all = if n == 0 { "<p>No control was asked for.</p>".to_owned() } else { table("Programs", &head, &body) };
    format!("<section id=\"programs\"><h2>Programs</h2>\n{all}</section>\n")
}
