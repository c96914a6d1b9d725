//! Figures of the run as static HTML, all of them from `summary.json`: cards, schedules, kinds of
//! path, comparison, peaks of the axes.

use serde_json::Value;

use super::{ReportInput, escape, figure, number};

pub(super) fn card(out: &mut String, label: &str, value: &str, note: &str) {
    out.push_str(&format!(
        "<div class=\"card\"><dt>{label}</dt><dd>{value}{}</dd></div>\n",
        if note.is_empty() { String::new() } else { format!("<small>{note}</small>") }
    ));
}

fn value(input: &ReportInput, pointer: &str) -> f64 {
    input.summary.json.pointer(pointer).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

fn text(input: &ReportInput, pointer: &str) -> String {
    input.summary.json.pointer(pointer).and_then(Value::as_str).map(escape).unwrap_or_default()
}

/// Cards with the figures of the run.
pub(super) fn figures(input: &ReportInput) -> String {
    let mut cards = String::new();
    if input.plan.is_some() {
        plan_cards(input, &mut cards);
    }
    if input.checks.is_some() {
        check_cards(input, &mut cards);
        turning_cards(input, &mut cards);
    }
    let t = input.tool;
    let holder = t.holder.iter().map(|h| format!("R {} × {}", number(h.radius_mm), number(h.length_mm)));
    let note = format!(
        "taper {}°, shank R {}, stick-out {}; holder {}",
        number(t.taper_deg),
        number(t.shank_radius_mm),
        number(t.stickout_mm),
        holder.collect::<Vec<_>>().join(", ")
    );
    let end = if t.is_ball() {
        format!("ball R {} mm", number(t.radius_mm))
    } else {
        format!("cutter R {} mm, corner R {} mm", number(t.radius_mm), number(t.corner_mm()))
    };
    card(&mut cards, "Tool", &end, &note);
    format!("<section id=\"figures\"><h2>Figures</h2><dl class=\"cards\">{cards}</dl></section>\n")
}

/// Where the time of each program goes; nothing without programs.
pub(super) fn cycles(input: &ReportInput) -> String {
    let n = count(input, "/programs");
    if n == 0 {
        return String::new();
    }
    let line = |k: usize| {
        let f = |key: &str| figure(&input.summary, &format!("/programs/{k}/cycle/{key}"));
        let keys = ["approach_s", "lead_in_s", "cutting_s", "lead_out_s", "retract_s", "unwinding_s", "total_s"];
        row(&text(input, &format!("/programs/{k}/file")), keys.into_iter().map(f))
    };
    let body: String = (0..n).map(line).collect();
    let head = [
        ("Program", false),
        ("approach, s", true),
        ("lead-in, s", true),
        ("cutting, s", true),
        ("lead-out, s", true),
        ("retract, s", true),
        ("unwinding, s", true),
        ("total, s", true),
    ];
    format!(
        "<h3>Cycle time</h3>\n{}<p>Without tool change and the way to over the part.</p>",
        table("Cycle time", &head, &body)
    )
}

/// What is assumed of the machine, in words; nothing where all is measured.
fn assumed(input: &ReportInput) -> String {
    let axes: Vec<String> =
        (0..count(input, "/limits_assumed")).map(|k| text(input, &format!("/limits_assumed/{k}"))).collect();
    if axes.is_empty() { String::new() } else { format!("limits of {} are assumed", axes.join(", ")) }
}

fn plan_cards(input: &ReportInput, cards: &mut String) {
    let f = |pointer: &str| figure(&input.summary, pointer);
    let time = value(input, "/machining_time_s");
    let against = value(input, "/schedules/1/machining_time_s");
    let change =
        if against.is_finite() { format!("{} against fixed lead", change(time, against)) } else { String::new() };
    card(
        cards,
        "Machining time",
        &format!("{} s", f("/machining_time_s")),
        &joined(&[minutes(time), change, assumed(input)]),
    );
    if count(input, "/programs") > 0 {
        let part = |name: &str, key: &str| format!("{name} {}", f(&format!("/programs/0/cycle/{key}")));
        let parts = [
            ("approach", "approach_s"),
            ("lead-in", "lead_in_s"),
            ("cutting", "cutting_s"),
            ("lead-out", "lead_out_s"),
            ("retract", "retract_s"),
            ("unwinding", "unwinding_s"),
        ];
        let note = format!("{}: {}", text(input, "/programs/0/file"), parts.map(|(n, k)| part(n, k)).join(", "));
        card(cards, "Cycle time", &format!("{} s", f("/programs/0/cycle/total_s")), &note);
    }
    let note = format!("{} turns, {} locations", f("/turns"), f("/cutter_locations"));
    card(cards, "Path", &format!("{} mm", f("/path_length_mm")), &note);
    if value(input, "/stock_mm") > 0.0 {
        card(cards, "Stock", &format!("{} mm", f("/stock_mm")), "stays on the part");
    }
    let region = format!("{} – {} mm", f("/region_x_mm/0"), f("/region_x_mm/1"));
    card(
        cards,
        "Region",
        &region,
        &format!("{} along the blade axis; end: {}", input.tool.centre_name(), text(input, "/end_reason")),
    );
    card(
        cards,
        "Narrowest channel",
        &format!("{}°", f("/channel_width_min_deg")),
        &format!("location {}; {}° without turning back", f("/channel_narrowest_row"), f("/channel_monotone_min_deg")),
    );
    let note = format!("{} reversals of θ", f("/schedules/0/reversals"));
    card(cards, "Schedule", &text(input, "/schedules/0/kind"), &note);
}

/// Turn-milling: where the tool passes the blade axis, how evenly the blade turns, what each tooth
/// cuts.
fn turning_cards(input: &ReportInput, cards: &mut String) {
    let f = |key: &str| figure(&input.summary, &format!("/turning/{key}"));
    let there = |key: &str| value(input, &format!("/turning/{key}")).is_finite();
    if there("offset_mm/0") {
        let [least, greatest] = ["offset_mm/0", "offset_mm/1"].map(f);
        let range = if least == greatest { format!("{least} mm") } else { format!("{least} to {greatest} mm") };
        card(cards, "Offset from the blade axis", &range, "of the plane that the tool axis is in");
    }
    if there("turning_per_min/0") && there("ripple") {
        let range = format!("{} to {} 1/min", f("turning_per_min/0"), f("turning_per_min/1"));
        let note = format!("within a turn by {} %", number(100.0 * value(input, "/turning/ripple")));
        card(cards, "Blade turns at", &range, &note);
    }
    if there("tooth/feed_mm") {
        let below =
            format!("below the least {} % of the time", number(100.0 * value(input, "/turning/tooth/below_least")));
        let chip =
            if there("tooth/chip_mm") { format!("chip {} mm at most", f("tooth/chip_mm")) } else { String::new() };
        card(cards, "Feed per tooth, at most", &format!("{} mm", f("tooth/feed_mm")), &joined(&[chip, below]));
        let speed = format!("cutting speed at least {} m/min", f("tooth/least_speed_m_min"));
        card(cards, "Marks along the feed, at most", &format!("{} mm", f("tooth/mark_mm")), &speed);
    }
}

fn check_cards(input: &ReportInput, cards: &mut String) {
    let f = |pointer: &str| figure(&input.summary, pointer);
    let asked = format!("{} asked for; 99 % at most {}", f("/scallop_asked_mm"), f("/scallop_p99_mm"));
    card(cards, "Greatest scallop", &format!("{} mm", f("/scallop_max_mm")), &asked);
    // Of a cutter with a corner neither the limit nor what stays uncut is measured.
    let is_ball = input.tool.is_ball();
    if is_ball {
        card(cards, "Length over the limit", &f("/limit/ratio"), "inner turns beside the least that their area needs");
    }
    card(cards, "Deepest gouge", &format!("{} mm", f("/gouge_mm")), "");
    if is_ball {
        let most = format!("no ball of this radius reaches it; at most {} mm are left", f("/uncut_height_mm"));
        let uncut = value(input, "/uncut_area_mm2") > 0.0;
        card(cards, "Uncut", &format!("{} mm²", f("/uncut_area_mm2")), if uncut { &most } else { "" });
    }
    card(
        cards,
        "Least clearance",
        &format!("{} mm", f("/clearance_mm")),
        &format!("tool without {}", input.tool.end_name()),
    );
}

pub(super) fn joined(parts: &[String]) -> String {
    parts.iter().filter(|p| !p.is_empty()).cloned().collect::<Vec<_>>().join("; ")
}

pub(super) fn minutes(seconds: f64) -> String {
    if !(seconds.is_finite() && seconds >= 60.0) {
        return String::new();
    }
    // Whole seconds first, so that there are never 60 of them.
    let whole = seconds.round();
    format!("{:.0} min {:.0} s", (whole / 60.0).floor(), whole % 60.0)
}

/// Change from `old` to `new` in per cent, with its sign.
fn change(new: f64, old: f64) -> String {
    if old.is_finite() && new.is_finite() && old.abs() > 1e-9 {
        // Adding 0 turns the −0.0 of a small loss into 0.0.
        let percent = (1000.0 * (new / old - 1.0)).round() / 10.0 + 0.0;
        format!("{percent:+.1} %").replace('-', "−").replace("+0.0 %", "0.0 %")
    } else {
        "–".into()
    }
}

/// A table that scrolls by itself.
pub(super) fn table(label: &str, head: &[(&str, bool)], body: &str) -> String {
    let cells: String = head
        .iter()
        .map(|(name, number)| format!("<th scope=\"col\"{}>{name}</th>", if *number { " class=\"n\"" } else { "" }))
        .collect();
    format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{label}\"><table><thead><tr>{cells}</tr></thead>\
         <tbody>{body}</tbody></table></div>\n"
    )
}

/// The schedule beside the others of the run; paths of other kinds; the comparison over the
/// machine's limits, where there is one.
pub(super) fn comparison(input: &ReportInput) -> String {
    let mut out = String::new();
    out.push_str(&schedules(input));
    out.push_str(&paths(input));
    if let Some(file) = &input.compare {
        out.push_str(&compared(file));
    }
    if out.is_empty() { out } else { format!("<section id=\"compare\"><h2>Compared</h2>\n{out}</section>\n") }
}

fn count(input: &ReportInput, pointer: &str) -> usize {
    input.summary.json.pointer(pointer).and_then(Value::as_array).map_or(0, Vec::len)
}

pub(super) fn row(name: &str, cells: impl Iterator<Item = String>) -> String {
    let cells: String = cells.map(|c| format!("<td class=\"n\">{c}</td>")).collect();
    format!("<tr><th scope=\"row\">{name}</th>{cells}</tr>\n")
}

fn schedules(input: &ReportInput) -> String {
    let n = count(input, "/schedules");
    if n == 0 {
        return String::new();
    }
    let kind = |k: usize| text(input, &format!("/schedules/{k}/kind"));
    let names: Vec<String> = (0..n).map(|k| if k == 0 { format!("{} (in use)", kind(k)) } else { kind(k) }).collect();
    let mut head = vec![("Schedule", false)];
    head.extend(names.iter().map(|n| (n.as_str(), true)));
    let turns = &input.machine.axes()[input.machine.turning_axis()].name;
    let figures = [
        ("machining time, s", "machining_time_s"),
        ("reversals of θ", "reversals"),
        ("locations outside the channel", "outside_channel"),
        ("greatest |dθ/ds|, °/mm", "theta_rate_peak_deg_per_mm"),
        ("greatest |d²θ/ds²|, °/mm²", "theta_acceleration_peak_deg_per_mm2"),
        (&format!("{turns} at full feed, °/s"), "a_velocity_at_constant_feed_deg_s"),
        (&format!("{turns} at full feed, °/s²"), "a_acceleration_at_constant_feed_deg_s2"),
    ];
    let body: String = figures
        .iter()
        .map(|(name, key)| row(name, (0..n).map(|k| figure(&input.summary, &format!("/schedules/{k}/{key}")))))
        .collect();
    format!("<h3>Schedules on this path</h3>\n{}", table("Schedules", &head, &body))
}

fn paths(input: &ReportInput) -> String {
    let n = count(input, "/other_paths");
    if n == 0 {
        return String::new();
    }
    let line = |k: usize| {
        let f = |key: &str| figure(&input.summary, &format!("/other_paths/{k}/{key}"));
        let cells = ["turns", "path_length_mm", "limit/ratio", "ratio_at_same_scallop"].map(f);
        row(&text(input, &format!("/other_paths/{k}/kind")), cells.into_iter())
    };
    let body: String = (0..n).map(line).collect();
    let head = [
        ("Kind", false),
        ("turns", true),
        ("length, mm", true),
        ("over the limit", true),
        ("at the same scallop", true),
    ];
    format!("<h3>Paths of other kinds over the same region</h3>\n{}", table("Kinds of path", &head, &body))
}

/// `compare.json`: all schedules under the machine's own limits and others.
fn compared(file: &super::File) -> String {
    let list = |pointer: &str| file.json.pointer(pointer).and_then(Value::as_array).map_or(0, Vec::len);
    let name = |pointer: &str| file.json.pointer(pointer).and_then(Value::as_str).map(escape).unwrap_or_default();
    let mut out = String::new();
    for l in 0..list("/sweep") {
        let runs = list(&format!("/sweep/{l}/runs"));
        let line = |k: usize| {
            let f = |key: &str| figure(file, &format!("/sweep/{l}/runs/{k}/{key}"));
            let cells = ["time_s", "over_bound", "constant_feed_mm_min", "constant_feed_time_s"].map(f);
            row(&name(&format!("/sweep/{l}/runs/{k}/name")), cells.into_iter())
        };
        let body: String = (0..runs).map(line).collect();
        let head = [
            ("Schedule", false),
            ("time, s", true),
            ("over the bound", true),
            ("constant feed, mm/min", true),
            ("time at it, s", true),
        ];
        let scale = figure(file, &format!("/sweep/{l}/scale"));
        let bound = figure(file, &format!("/sweep/{l}/bound_s"));
        out.push_str(&format!(
            "<h4>{scale} times the machine's limits (no schedule takes less than {bound} s)</h4>\n{}",
            table("Comparison", &head, &body)
        ));
    }
    format!("<h3>All schedules over the machine's limits</h3>\n{out}")
}

/// Table of peak velocity, acceleration and jerk of each axis.
pub(super) fn axes(input: &ReportInput) -> String {
    if input.plan.is_none() {
        return String::new();
    }
    let others = count(input, "/schedules") > 1;
    let mut rows = String::new();
    for (i, axis) in input.machine.axes().iter().enumerate() {
        let (name, unit, scale, limits) = (&axis.name, axis.sign(), axis.scale(), axis.limits);
        let kinds = [
            ("velocity", "/s", limits.velocity),
            ("acceleration", "/s²", limits.acceleration),
            ("jerk", "/s³", limits.jerk),
        ];
        for (kind, per, limit) in kinds {
            let at = |k: usize| format!("/schedules/{k}/axes/{i}/{kind}");
            let (now, before) = (value(input, &at(0)), value(input, &at(1)));
            let cells = [
                figure(&input.summary, &at(0)),
                if others { figure(&input.summary, &at(1)) } else { "–".into() },
                change(now, before),
                number(limit * scale),
                number(100.0 * now / (limit * scale)),
            ];
            rows.push_str(&row(&format!("{name} {kind}, {unit}{per}"), cells.into_iter()));
        }
    }
    let head = [
        ("Axis", false),
        ("This plan", true),
        ("fixed lead", true),
        ("Change", true),
        ("Limit", true),
        ("% of limit", true),
    ];
    format!(
        "<section id=\"peaks\"><h2>Peaks of the axes</h2><p>Over all cutter locations. Limits are those of the machine \
         file ({}).</p>{}</section>\n",
        if !input.machine.assumed_limits().is_empty() { "assumed" } else { "measured" },
        table("Peaks of the axes", &head, &rows)
    )
}
