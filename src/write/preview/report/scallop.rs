//! The scallop measured: percentiles as a table, how often which height occurs, and where.

use serde_json::{Value, json};

use super::pack::{DIGITS, Pack};
use super::{ReportInput, figure, number};
use crate::artifact::report::{LimitSource, Place};
use crate::write::draw::histogram;
use crate::write::preview::values;

/// Most places of the map.
const MAP: usize = 12_000;

/// What the script draws.
pub(super) fn data(input: &ReportInput, pack: &mut Pack) -> Value {
    let Some(checks) = input.checks else { return Value::Null };
    let asked = input.plan.map(|p| p.toolpath.scallop_mm);
    // The places are sorted by height, so that every so many of them are a fair choice; the highest
    // is always one.
    let every = checks.scallop.len().div_ceil(MAP).max(1);
    let mut shown: Vec<&Place> = checks.scallop.iter().rev().step_by(every).collect();
    // In the order of the path: what is near is alike, which packs well.
    shown.sort_by_key(|p| p.row);
    let heights = || shown.iter().map(|p| p.height_mm);
    let [least, greatest] = heights().fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], h| [lo.min(h), hi.max(h)]);
    let [low, high] = values::spanned(heights());
    let locations = input.plan.map(|p| (&p.toolpath.locations, &p.toolpath.turns));
    let round = |p: &Place| {
        let (all, turns) = locations?;
        let l = all.get(p.row)?;
        let turn = turns.get(l.turn as usize)?;
        Some(100.0 * l.turn_s_mm / turn.length_mm.max(1e-9))
    };
    json!({
        "asked": asked, "histogram": histogram::histogram(checks), "measured": checks.scallop.len(),
        "map": {
            "range": [least, greatest], "shown": [low, if high < greatest { high } else { high.max(asked.unwrap_or(high)) }],
            "height": pack.scaled(heights()),
            "x": pack.list(DIGITS, shown.iter().map(|p| p.point.x)),
            "y": pack.list(DIGITS, shown.iter().map(|p| p.point.y)),
            "z": pack.list(DIGITS, shown.iter().map(|p| p.point.z)),
            "round": pack.list(2, shown.iter().map(|p| round(p).unwrap_or(f64::NAN))),
            "s": pack.list(DIGITS, shown.iter().map(|p| locations.and_then(|(all, _)| all.get(p.row)).map_or(f64::NAN, |l| l.s_mm))),
        },
    })
}

/// Percentiles and the length beside its limit.
pub(super) fn section(input: &ReportInput) -> String {
    let mut out = String::from("<section id=\"scallop\"><h2>Scallop</h2>\n");
    let Some(r) = input.checks else {
        out.push_str("<p>Scallop was not measured in this run.</p></section>\n");
        return out;
    };
    let asked = input.plan.map_or(f64::NAN, |p| p.toolpath.scallop_mm);
    let is_ball = input.plan.is_none_or(|p| p.toolpath.disc_radius_mm == 0.0);
    let row = |name: &str, surface: &str, ridge: &str| {
        let ridge = format!("<td class=\"n\">{}</td>", figure(&input.verify, ridge));
        let ridge = if is_ball { &ridge } else { "" };
        let surface = figure(&input.verify, surface);
        format!("<tr><th scope=\"row\">{name}</th><td class=\"n\">{surface}</td>{ridge}</tr>\n")
    };
    let rows = [
        row("greatest", "/scallop_max_mm", "/ridge_max_mm"),
        row("99 %", "/scallop_p99_mm", "/ridge_p99_mm"),
        row("95 %", "/scallop_p95_mm", "/limit/ridge_p95_mm"),
        row("median", "/scallop_p50_mm", "/ridge_p50_mm"),
        row("5 %", "/scallop_p05_mm", "/ridge_p05_mm"),
    ];
    let [ridges, column] = match is_ball {
        true => [
            " and on the ridges between neighbouring turns (the 95 % of the ridges: inner turns alone)",
            "<th scope=\"col\" class=\"n\">ridges, mm</th>",
        ],
        false => [""; 2],
    };
    out.push_str(&format!(
        "<p>Height left over the part in the machined band, mm, at {} points of the surface{ridges}. \
         Asked for: {} mm.</p>\n\
         <table class=\"percentiles\"><thead><tr><th scope=\"col\">Percentile</th><th scope=\"col\" class=\"n\">surface, mm</th>\
         {column}</tr></thead><tbody>\n{}</tbody></table>\n\
         <div class=\"pair\"><div><h3>How often</h3><div class=\"chart\" id=\"chart-histogram\"></div></div>\
         <div><h3>Where</h3><div class=\"chart\" id=\"chart-map\"></div></div></div>\n",
        figure(&input.verify, "/scallop_samples"),
        number(asked),
        rows.concat()
    ));
    if !is_ball {
        out.push_str("</section>\n");
        return out;
    }
    out.push_str(&format!(
        "<p>Inner turns: {} mm along the contacts over {} mm²; the least for that area and scallop is {} mm (from the {}), so the \
         path is {} times as long as it must be.</p></section>\n",
        figure(&input.verify, "/limit/path_length_mm"),
        figure(&input.verify, "/limit/area_mm2"),
        figure(&input.verify, "/limit/limit_length_mm"),
        if r.limit.source == LimitSource::Curvature { "curvature of the faces" } else { "measured ridges" },
        figure(&input.verify, "/limit/ratio")
    ));
    out
}
