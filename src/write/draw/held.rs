//! Rows of two tools: what of the table's turn is free for both, and where it stands.

use super::chart::{self, BLUE, Chart, ChartCurve, ORANGE};

/// A stretch of a row along which the table stands still, or a place of one along which it turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldAngles {
    /// Row, from 0; places of a row lie beside it.
    pub row: f64,
    /// The angle at which the table stands, degrees.
    pub held_deg: f64,
    /// The ends of what is free about it for both tools at all of the stretch, degrees.
    pub common_deg: [f64; 2],
}

/// The plot as an SVG file; nothing without rows. Rows, or turns as `of` says, count from 1.
pub fn held_svg(name: &str, of: &str, rows: &[HeldAngles]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let line = |value: &dyn Fn(&HeldAngles) -> f64| -> Vec<[f64; 2]> {
        rows.iter().map(|h| [h.row + 1.0, value(h)]).collect()
    };
    let held =
        ChartCurve { marks: true, ..ChartCurve::line("where it stands", line(&|h| h.held_deg), ORANGE, "", 1.5) };
    chart::svg(&[Chart {
        title: format!("Table of {name}: free for both tools along each {of}"),
        x: of.into(),
        y: "angle, °".into(),
        curves: vec![
            ChartCurve::line("free from", line(&|h| h.common_deg[0]), BLUE, "", 1.0),
            ChartCurve::line("free to", line(&|h| h.common_deg[1]), BLUE, "4 3", 1.0),
            held,
        ],
        band: Some((line(&|h| h.common_deg[0]), line(&|h| h.common_deg[1]))),
        ..Chart::default()
    }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stretch_is_drawn_between_its_walls() {
        let rows = [0.0, 0.0, 1.0].map(|row| HeldAngles { row, held_deg: 10.0 * row, common_deg: [-40.0, 60.0] });
        let svg = held_svg("b", "row", &rows);
        assert!(svg.contains("free for both tools along each row") && svg.contains("where it stands"), "{svg}");
        assert!(held_svg("b", "row", &[]).is_empty());
    }
}
