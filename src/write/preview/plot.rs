//! Width of the channel against B as a table and as a plot (SVG).

use std::fmt::Write;

use crate::artifact::channel::Width;
use crate::write::draw::scale::Scale;

/// Size of the plot, and of the margins left and below and right and above, px.
const SIZE: [f64; 2] = [720.0, 300.0];
const MARGIN: [f64; 4] = [56.0, 44.0, 16.0, 16.0];

/// `sweep_b.csv`: one row per B; empty where the channel is closed.
pub fn widths_csv(widths: &[Width]) -> String {
    let mut out = String::from("b_deg,narrowest_deg,monotone_deg,turn,S,binds\n");
    let number = |v: Option<f64>| v.map_or_else(String::new, |v| format!("{v:.4}"));
    for w in widths {
        let binds = w.binds.replace('"', "'");
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

/// The plot as one `<svg>` element: width at the narrowest place, and between the monotone hulls; nothing with fewer than two
/// angles. Closed angles are shaded.
pub fn widths_svg(widths: &[Width]) -> String {
    let (Some(first), Some(last)) = (widths.first(), widths.last()) else { return String::new() };
    if !(last.b_deg > first.b_deg) {
        return String::new();
    }
    let top = widths.iter().filter_map(|w| w.narrowest_deg).fold(10.0, f64::max) * 1.05;
    let x = Scale { from: [first.b_deg, last.b_deg], to: [MARGIN[0], SIZE[0] - MARGIN[2]] };
    let y = Scale { from: [0.0, top], to: [SIZE[1] - MARGIN[1], MARGIN[3]] };
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" font-family=\"sans-serif\" \
         font-size=\"12\" fill=\"currentColor\"><title>Width of the channel against B</title>\n",
        SIZE[0], SIZE[1]
    );
    for w in widths.iter().filter(|w| !w.is_open()) {
        let half = 0.5 * (x.to[1] - x.to[0]) / (widths.len() - 1) as f64;
        let (a, b) = ((x.at(w.b_deg) - half).max(x.to[0]), (x.at(w.b_deg) + half).min(x.to[1]));
        let _ = writeln!(
            out,
            "<rect x=\"{a:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"#c44\" opacity=\"0.15\"/>",
            y.to[1],
            b - a,
            y.to[0] - y.to[1]
        );
    }
    axes(&mut out, &x, &y);
    for (name, colour, value) in [
        ("narrowest place", "#2a6fb0", (|w: &Width| w.narrowest_deg) as fn(&Width) -> Option<f64>),
        ("between the monotone hulls", "#d07a1f", |w: &Width| w.monotone_deg.map(|v| v.max(0.0))),
    ] {
        curve(&mut out, widths, &x, &y, colour, value);
        let row = if colour == "#2a6fb0" { 0.0 } else { 16.0 };
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"{colour}\">{name}</text>",
            x.to[1],
            y.to[1] + 12.0 + row
        );
    }
    out.push_str("</svg>\n");
    out
}

fn axes(out: &mut String, x: &Scale, y: &Scale) {
    let (values, digits) = y.ticks(6.0);
    for v in values {
        let at = y.at(v);
        let _ = writeln!(
            out,
            "<path d=\"M{:.1} {at:.1}H{:.1}\" stroke=\"currentColor\" opacity=\"0.15\"/><text x=\"{:.1}\" y=\"{:.1}\" \
             text-anchor=\"end\">{v:.digits$}°</text>",
            x.to[0],
            x.to[1],
            x.to[0] - 6.0,
            at + 4.0
        );
    }
    let (values, digits) = x.ticks(6.0);
    for v in values {
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{v:.digits$}°</text>",
            x.at(v),
            y.to[0] + 18.0
        );
    }
    let _ = writeln!(
        out,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">B</text>",
        0.5 * (x.to[0] + x.to[1]),
        SIZE[1] - 6.0
    );
}

/// One line; broken where the channel is closed.
fn curve(out: &mut String, widths: &[Width], x: &Scale, y: &Scale, colour: &str, value: fn(&Width) -> Option<f64>) {
    let mut d = String::new();
    let mut pen_down = false;
    for w in widths {
        match value(w) {
            Some(v) => {
                let _ = write!(d, "{}{:.1} {:.1}", if pen_down { "L" } else { "M" }, x.at(w.b_deg), y.at(v));
                pen_down = true;
            }
            None => pen_down = false,
        }
    }
    let _ = writeln!(out, "<path d=\"{d}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn width(b_deg: f64, narrowest_deg: Option<f64>) -> Width {
        let monotone_deg = narrowest_deg.map(|w| 0.5 * w - 5.0);
        Width { b_deg, narrowest_deg, monotone_deg, turn: 3, turn_s_mm: 1.5, binds: "taper \"x\"".into() }
    }

    #[test]
    fn closed_angles_break_the_line_and_leave_cells_empty() {
        let widths = [width(-5.0, Some(30.0)), width(0.0, None), width(5.0, Some(40.0)), width(10.0, Some(44.0))];
        let csv = widths_csv(&widths);
        assert!(csv.contains("-5,30.0000,10.0000,3,1.500,\"taper 'x'\"\n0,,,3"), "{csv}");
        let svg = widths_svg(&widths);
        assert_eq!(svg.matches("<rect").count(), 1);
        let line = svg.split("stroke=\"#2a6fb0\"").next().map(|s| s.matches('M').count());
        assert!(line >= Some(2), "{svg}");
        assert!(widths_svg(&widths[..1]).is_empty());
    }
}
