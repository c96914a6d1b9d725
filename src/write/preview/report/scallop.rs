//! The scallop measured: percentiles as a table, how often which height occurs, and where.

use serde_json::{Value, json};

use super::pack::Pack;
use super::{ReportInput, figure, number};
use crate::artifact::CheckReport;
use crate::artifact::report::{LimitSource, Place};

/// Bars of the histogram, about.
const BARS: usize = 40;
/// Most places of the map.
const MAP: usize = 12_000;

/// A width of bars that people count in: 1, 2 or 5 times a power of ten.
fn round_step(span: f64) -> f64 {
    let raw = span / BARS as f64;
    let ten = 10f64.powf(raw.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * ten).find(|s| *s >= raw).unwrap_or(raw)
}

/// Counts of heights in bars from `from`, `step` wide; every height is in one of them.
fn counts(places: &[Place], from: f64, step: f64, bars: usize) -> Vec<usize> {
    let mut out = vec![0; bars];
    for p in places {
        let k = ((p.height_mm - from) / step).floor().max(0.0) as usize;
        if let Some(n) = out.get_mut(k.min(bars.saturating_sub(1))) {
            *n += 1;
        }
    }
    out
}

/// Counts of heights in bars.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Histogram {
    /// Lower edge of the first bar, mm.
    pub from: f64,
    /// Width of a bar, mm.
    pub step: f64,
    /// Samples of the surface in each bar.
    pub samples: Vec<usize>,
    /// Ridges in each bar.
    pub ridges: Vec<usize>,
}

/// Histogram of samples and of ridges over the same bars; nothing where nothing was measured.
pub fn histogram(checks: &CheckReport) -> Option<Histogram> {
    let heights = || checks.scallop.iter().chain(&checks.ridges).map(|p| p.height_mm).filter(|h| h.is_finite());
    let (lo, hi) = heights().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (a.min(h), b.max(h)));
    if !(lo <= hi) {
        return None;
    }
    let step = round_step((hi - lo).max(1e-6));
    let from = (lo / step).floor() * step;
    let bars = ((hi - from) / step).floor() as usize + 1;
    let (samples, ridges) = (counts(&checks.scallop, from, step, bars), counts(&checks.ridges, from, step, bars));
    Some(Histogram { from, step, samples, ridges })
}

/// What the script draws.
pub(super) fn data(input: &ReportInput, pack: &mut Pack) -> Value {
    let Some(checks) = input.checks else { return Value::Null };
    let asked = input.plan.map(|p| p.toolpath.scallop_mm);
    // The places are sorted by height, so that every so many of them are a fair choice; the highest is always one.
    let every = checks.scallop.len().div_ceil(MAP).max(1);
    let mut shown: Vec<&Place> = checks.scallop.iter().rev().step_by(every).collect();
    shown.reverse();
    let locations = input.plan.map(|p| (&p.toolpath.locations, &p.toolpath.turns));
    let round = |p: &Place| {
        let (all, turns) = locations?;
        let l = all.get(p.row)?;
        let turn = turns.get(l.turn as usize)?;
        Some(100.0 * l.turn_s_mm / turn.length_mm.max(1e-9))
    };
    json!({
        "asked": asked, "histogram": histogram(checks), "measured": checks.scallop.len(),
        "map": {
            "height": pack.list(shown.iter().map(|p| p.height_mm)),
            "x": pack.list(shown.iter().map(|p| p.point.x)),
            "y": pack.list(shown.iter().map(|p| p.point.y)),
            "z": pack.list(shown.iter().map(|p| p.point.z)),
            "round": pack.list(shown.iter().map(|p| round(p).unwrap_or(f64::NAN))),
            "s": pack.list(shown.iter().map(|p| locations.and_then(|(all, _)| all.get(p.row)).map_or(f64::NAN, |l| l.s_mm))),
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
    let row = |name: &str, surface: &str, ridge: &str| {
        format!(
            "<tr><th scope=\"row\">{name}</th><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
            figure(&input.verify, surface),
            figure(&input.verify, ridge)
        )
    };
    let rows = [
        row("greatest", "/scallop_max_mm", "/ridge_max_mm"),
        row("99 %", "/scallop_p99_mm", "/ridge_p99_mm"),
        row("95 %", "/scallop_p95_mm", "/limit/ridge_p95_mm"),
        row("median", "/scallop_p50_mm", "/ridge_p50_mm"),
        row("5 %", "/scallop_p05_mm", "/ridge_p05_mm"),
    ];
    out.push_str(&format!(
        "<p>Height left over the part in the machined band, mm, at {} points of the surface and on the ridges between neighbouring \
         turns (the 95 % of the ridges: inner turns alone). Asked for: {} mm.</p>\n\
         <table class=\"percentiles\"><thead><tr><th scope=\"col\">Percentile</th><th scope=\"col\" class=\"n\">surface, mm</th>\
         <th scope=\"col\" class=\"n\">ridges, mm</th></tr></thead><tbody>\n{}</tbody></table>\n\
         <div class=\"pair\"><div><h3>How often</h3><div class=\"chart\" id=\"chart-histogram\"></div></div>\
         <div><h3>Where</h3><div class=\"chart\" id=\"chart-map\"></div></div></div>\n",
        figure(&input.verify, "/scallop_samples"),
        number(asked),
        rows.concat()
    ));
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Point;
    use crate::sample;

    #[test]
    fn every_height_is_counted_once() {
        let place = |k: usize| Place { point: Point::origin(), row: k, height_mm: 0.002 + 1e-5 * k as f64 };
        let mut checks = sample::report();
        assert!(histogram(&checks).is_none());
        checks.scallop = (0..1000).map(place).collect();
        checks.ridges = (500..600).map(place).collect();
        let h = histogram(&checks).unwrap();
        let sum = |counts: &[usize]| counts.iter().sum::<usize>();
        assert_eq!((sum(&h.samples), sum(&h.ridges)), (1000, 100));
        assert!((20..=BARS + 1).contains(&h.samples.len()), "{}", h.samples.len());
        // Bar k holds what lies from `from + k step` on.
        let k = ((0.007_05 - h.from) / h.step) as usize;
        assert!(h.ridges[k] > 0 && h.ridges[0] == 0);
    }
}
