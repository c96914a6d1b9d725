//! Figures of the run as static HTML: cards, peaks of the axes, scallop.

use super::{ReportInput, escape, number};
use crate::artifact::AxisMotion;
use crate::artifact::axis_motion::AXES;
use crate::artifact::report::LimitSource;

fn card(out: &mut String, label: &str, value: &str, note: &str) {
    out.push_str(&format!(
        "<div class=\"card\"><dt>{label}</dt><dd>{value}{}</dd></div>\n",
        if note.is_empty() { String::new() } else { format!("<small>{note}</small>") }
    ));
}

/// Cards with the figures of the run.
pub(super) fn figures(input: &ReportInput) -> String {
    let mut cards = String::new();
    if let Some(plan) = input.plan {
        let path = &plan.toolpath;
        let length = path.locations.last().map_or(f64::NAN, |l| l.s_mm);
        card(&mut cards, "Machining time", &duration(plan.motion.time_s), &time_note(input, plan.motion.time_s));
        card(
            &mut cards,
            "Path",
            &format!("{} mm", number(length)),
            &format!("{} turns, {} locations", path.turns.len(), path.locations.len()),
        );
        if path.stock_mm > 0.0 {
            card(&mut cards, "Stock", &format!("{} mm", number(path.stock_mm)), "stay on the part");
        }
        let [from, to] = path.region_x_mm;
        card(
            &mut cards,
            "Region",
            &format!("{} – {} mm", number(from), number(to)),
            "along the blade axis, ball centres",
        );
        let row = plan.channel.rows.get(plan.channel.narrowest_row);
        let width = row.map_or(f64::NAN, |r| (r.hull_max - r.hull_min).to_degrees());
        let turn = path.locations.get(plan.channel.narrowest_row).map_or(String::new(), |l| format!("turn {}", l.turn));
        card(&mut cards, "Narrowest channel", &format!("{}°", number(width)), &turn);
        let kind = format!("{:?}", plan.schedule.kind).to_lowercase();
        card(&mut cards, "Schedule", &kind, &format!("{} reversals of θ", plan.schedule.reversals));
    }
    if let Some(r) = input.checks {
        let asked = input.plan.map_or(String::new(), |p| format!("{} asked for", number(p.toolpath.scallop_mm)));
        card(&mut cards, "Greatest scallop", &format!("{} mm", number(r.scallop_max_mm)), &asked);
        card(&mut cards, "Deepest gouge", &format!("{} mm", number(r.gouge_mm)), "");
        let uncut = format!("{} mm²", number(r.uncut_area_mm2));
        let most = format!("no ball of this radius reaches it; at most {} mm are left", number(r.uncut_height_mm));
        card(&mut cards, "Uncut", &uncut, if r.uncut_area_mm2 > 0.0 { &most } else { "" });
        card(&mut cards, "Least clearance", &format!("{} mm", number(r.clearance_mm)), "tool without ball");
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
    card(&mut cards, "Tool", &format!("ball R {} mm", number(t.radius_mm)), &note);
    format!("<section id=\"figures\"><h2>Figures</h2><dl class=\"cards\">{cards}</dl></section>\n")
}

fn duration(seconds: f64) -> String {
    if !seconds.is_finite() {
        return "–".into();
    }
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    // Whole seconds first, so that there are never 60 of them.
    let whole = seconds.round();
    format!("{:.0} min {:.0} s", (whole / 60.0).floor(), whole % 60.0)
}

fn time_note(input: &ReportInput, time_s: f64) -> String {
    match input.baseline.and_then(|b| b.motion.map(|m| (b.name, m.time_s))) {
        Some((name, other)) if other > 0.0 => {
            format!("{} against {} with {}", change(time_s, other), duration(other), escape(name))
        }
        _ => String::new(),
    }
}

/// Change from `old` to `new` in per cent, with its sign.
fn change(new: f64, old: f64) -> String {
    if old.is_finite() && new.is_finite() && old.abs() > 1e-9 {
        format!("{:+.1} %", 100.0 * (new / old - 1.0)).replace('-', "−")
    } else {
        "–".into()
    }
}

fn peak(rows: &[[f64; 5]], axis: usize) -> f64 {
    let scale = if axis < 3 { 1.0 } else { 1f64.to_degrees() };
    let peak = rows.iter().map(|r| (r[axis] * scale).abs()).fold(f64::NAN, f64::max);
    // Less is the noise of rounding: the axis stands still.
    if peak < 1e-6 { 0.0 } else { peak }
}

/// Table of peak velocity, acceleration and jerk of each axis.
pub(super) fn axes(input: &ReportInput) -> String {
    let Some(plan) = input.plan else { return String::new() };
    let baseline = input.baseline.and_then(|b| b.motion.map(|m| (b.name, m)));
    let limits = input.machine.limits();
    let mut rows = String::new();
    for (i, axis) in AXES.iter().enumerate() {
        let unit = if i < 3 { "mm" } else { "deg" };
        let scale = if i < 3 { 1.0 } else { 1f64.to_degrees() };
        type Pick = fn(&AxisMotion) -> &[[f64; 5]];
        let kinds: [(&str, &str, Pick, f64); 3] = [
            ("velocity", "/s", |m| &m.velocity, limits[i].velocity),
            ("acceleration", "/s²", |m| &m.acceleration, limits[i].acceleration),
            ("jerk (not limited)", "/s³", |m| &m.jerk, f64::NAN),
        ];
        for (kind, per, pick, limit) in kinds {
            let now = peak(pick(&plan.motion), i);
            let before = baseline.map_or(f64::NAN, |(_, m)| peak(pick(m), i));
            rows.push_str(&format!(
                "<tr><th scope=\"row\">{axis} {kind}</th><td>{unit}{per}</td><td class=\"n\">{}</td>\
                 <td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
                number(now),
                number(before),
                change(now, before),
                number(limit * scale)
            ));
        }
    }
    let name = baseline.map_or("no baseline", |(n, _)| n);
    format!(
        "<section id=\"peaks\"><h2>Peaks of the axes</h2><p>Over all cutter locations. Limits are those of the machine \
         file ({}).</p><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of peaks\"><table><thead><tr>\
         <th scope=\"col\">Axis</th><th scope=\"col\">Unit</th><th scope=\"col\" class=\"n\">This plan</th>\
         <th scope=\"col\" class=\"n\">{}</th><th scope=\"col\" class=\"n\">Change</th><th scope=\"col\" class=\"n\">Limit</th>\
         </tr></thead><tbody>{rows}</tbody></table></div></section>\n",
        if limits.iter().any(|l| l.provenance == crate::machine::Provenance::Assumed) { "assumed" } else { "measured" },
        escape(name)
    )
}

/// Bars of scallop percentiles against what was asked for.
pub(super) fn scallop(input: &ReportInput) -> String {
    let mut out = String::from("<section id=\"scallop\"><h2>Scallop</h2>\n");
    let Some(r) = input.checks else {
        out.push_str("<p>Scallop was not measured in this run.</p></section>\n");
        return out;
    };
    let asked = input.plan.map_or(f64::NAN, |p| p.toolpath.scallop_mm);
    let rows = [
        ("greatest", r.scallop_max_mm),
        ("99 %", r.scallop_p99_mm),
        ("95 %", r.scallop_p95_mm),
        ("median", r.scallop_p50_mm),
        ("5 %", r.scallop_p05_mm),
        ("ridges, greatest", r.ridge_max_mm),
        ("ridges, 99 %", r.ridge_p99_mm),
        ("ridges, median", r.ridge_p50_mm),
        ("ridges, 5 %", r.ridge_p05_mm),
    ];
    let top = rows.iter().map(|r| r.1).chain([asked]).filter(|v| v.is_finite()).fold(1e-12, f64::max);
    out.push_str(&format!(
        "<p>Height left over the part, mm: percentiles over {} points of the machined band, and of the ridges between \
         neighbouring turns. The line marks what was asked for ({} mm).</p><table class=\"bars\"><tbody>\n",
        r.scallop_samples,
        number(asked)
    ));
    for (name, value) in rows {
        let width = if value.is_finite() { (100.0 * value / top).clamp(0.0, 100.0) } else { 0.0 };
        let line = if asked.is_finite() {
            format!("<i style=\"left:{:.1}%\"></i>", (100.0 * asked / top).clamp(0.0, 100.0))
        } else {
            String::new()
        };
        out.push_str(&format!(
            "<tr><th scope=\"row\">{name}</th><td class=\"n\">{}</td><td class=\"bar\"><div><b style=\"width:{width:.1}%\"></b>\
             {line}</div></td></tr>\n",
            number(value)
        ));
    }
    out.push_str("</tbody></table>\n");
    let l = &r.limit;
    out.push_str(&format!(
        "<p>Inner turns: {} mm along the contacts over {} mm²; the least for that area and scallop is {} mm (from the {}), so the \
         path is {} times as long as it must be.</p></section>\n",
        number(l.path_length_mm),
        number(l.area_mm2),
        number(l.limit_length_mm),
        if l.source == LimitSource::Curvature { "curvature of the faces" } else { "measured ridges" },
        number(l.ratio)
    ));
    out
}
