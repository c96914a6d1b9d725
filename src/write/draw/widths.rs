//! Width of the channel against B as a table and as a plot (SVG).

use std::fmt::Write;

use crate::artifact::channel::Width;
use crate::write::draw::chart::{self, BLUE, Chart, ChartCurve, ORANGE};

/// `sweep_b.csv`: one row per B; empty where the channel is closed.
pub fn widths_csv(widths: &[Width]) -> String {
    let mut out = String::from("b_deg,narrowest_deg,monotone_deg,turn,S,binds\n");
    let number = |v: Option<f64>| v.map_or_else(String::new, |v| format!("{v:.4}"));
    for w in widths {
        let binds = w.binds.to_string().replace('"', "'");
        let _ = writeln!(
            out,
            "{},{},{},{},{:.3},\"{binds}\"",
            w.b_deg,
            number(w.narrowest_deg),
            number(w.monotone_deg),
            w.turn,
            w.turn_s_mm
        );
    }
    out
}

/// The plot as an SVG file: width at the narrowest place, and between the monotone hulls; nothing
/// with fewer than two angles. Closed angles are shaded.
pub fn widths_svg(widths: &[Width]) -> String {
    chart_of(widths).map_or_else(String::new, |c| chart::svg(&[c]))
}

/// The same as an element of a page.
pub fn widths_inline(widths: &[Width]) -> String {
    chart_of(widths).map_or_else(String::new, |c| chart::inline(&[c]))
}

fn chart_of(widths: &[Width]) -> Option<Chart> {
    let (first, last) = (widths.first()?.b_deg, widths.last()?.b_deg);
    if !(last > first) {
        return None;
    }
    let line = |value: fn(&Width) -> Option<f64>| {
        widths.iter().map(|w| [w.b_deg, value(w).unwrap_or(f64::NAN)]).collect::<Vec<_>>()
    };
    let half = 0.5 * (last - first) / (widths.len() - 1) as f64;
    let closed = widths.iter().filter(|w| !w.is_open());
    Some(Chart {
        title: "Width of the channel against B".into(),
        x: "B, °".into(),
        y: "width, °".into(),
        curves: vec![
            ChartCurve::line("narrowest place", line(|w| w.narrowest_deg), BLUE, "", 2.0),
            ChartCurve::line(
                "between the monotone hulls",
                line(|w| w.monotone_deg.map(|v| v.max(0.0))),
                ORANGE,
                "",
                2.0,
            ),
        ],
        closed: closed.map(|w| [(w.b_deg - half).max(first), (w.b_deg + half).min(last)]).collect(),
        floor: Some(0.0),
        ..Chart::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artifact::channel::Narrowest;
    use crate::error::Bound;

    fn width(b_deg: f64, narrowest_deg: Option<f64>) -> Width {
        let monotone_deg = narrowest_deg.map(|w| 0.5 * w - 5.0);
        let taper = Bound::Part { tool: "taper".into(), face: "\"x\"".into() };
        let binds = Narrowest::Between { below: Some(taper), above: None };
        Width { b_deg, narrowest_deg, monotone_deg, turn: 3, turn_s_mm: 1.5, binds }
    }

    #[test]
    fn closed_angles_break_the_line_and_leave_cells_empty() {
        let widths = [width(-5.0, Some(30.0)), width(0.0, None), width(5.0, Some(40.0)), width(10.0, Some(44.0))];
        let csv = widths_csv(&widths);
        assert!(csv.contains("-5,30.0000,10.0000,3,1.500,\"taper against 'x' below, nothing above\"\n0,,,3"), "{csv}");
        let svg = widths_svg(&widths);
        let shaded = |text: &str| text.matches("opacity=\"0.15\"/>\n").count();
        assert_eq!((shaded(&svg), shaded(&widths_inline(&widths))), (1, 1), "{svg}");
        let drawn = svg.lines().find(|l| l.contains(BLUE) && l.contains("linejoin")).map(|l| l.matches('M').count());
        assert_eq!(drawn, Some(2), "{svg}");
        // Within HTML the page names nothing outside.
        assert!(!widths_inline(&widths).contains("http"));
        assert!(widths_svg(&widths[..1]).is_empty());
    }
}
