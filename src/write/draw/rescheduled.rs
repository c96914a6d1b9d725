//! θ of a program before and after, in its channel.

use super::chart::{self, BLUE, Chart, ChartCurve, ORANGE};
use crate::artifact::schedule::ThetaRow;

/// Panels at most: the longest stretches.
const MOST: usize = 12;

/// A panel for each stretch, with its title, as an SVG file. Angles are measured from the straight
/// line that leads from the first to the last of the new ones, so that the channel fills the panel.
pub fn rescheduled_svg(stretches: &[(String, &[ThetaRow])]) -> String {
    let mut order: Vec<usize> = (0..stretches.len()).filter(|k| stretches[*k].1.len() > 1).collect();
    let length = |k: &usize| stretches[*k].1.last().map_or(0.0, |r| r.s_mm);
    order.sort_by(|a, b| length(b).total_cmp(&length(a)));
    order.truncate(MOST);
    order.sort_unstable();
    let charts: Vec<Chart> = order.into_iter().filter_map(|k| panel(&stretches[k].0, stretches[k].1)).collect();
    chart::svg(&charts)
}

fn panel(title: &str, rows: &[ThetaRow]) -> Option<Chart> {
    let (first, last) = (rows.first()?, rows.last()?);
    let slope = (last.after_deg - first.after_deg) / (last.s_mm - first.s_mm).max(1e-9);
    let line = |value: fn(&ThetaRow) -> f64| -> Vec<[f64; 2]> {
        let off = |r: &ThetaRow| value(r) - first.after_deg - slope * (r.s_mm - first.s_mm);
        rows.iter().map(|r| [r.s_mm, off(r)]).collect()
    };
    Some(Chart {
        title: title.into(),
        // Charts show their titles where a pointer is: pictures of several need them in sight.
        x: format!("S, mm. {title}"),
        y: "θ from the even turn, °".into(),
        curves: vec![
            ChartCurve::line("before", line(|r| r.before_deg), ORANGE, "5 3", 1.5),
            ChartCurve::line("after", line(|r| r.after_deg), BLUE, "", 2.0),
        ],
        band: Some((line(|r| r.wall_deg[0]), line(|r| r.wall_deg[1]))),
        ..Chart::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_stretches_are_drawn_in_their_order() {
        let rows = |length: f64| -> Vec<ThetaRow> {
            let row = |k: i32| ThetaRow {
                s_mm: length * f64::from(k),
                wall_deg: [-5.0, 5.0],
                before_deg: 1.0,
                after_deg: 0.0,
            };
            (0..3).map(row).collect()
        };
        let all: Vec<Vec<ThetaRow>> = (1..=14).map(|k| rows(f64::from(k))).collect();
        let named: Vec<(String, &[ThetaRow])> =
            all.iter().enumerate().map(|(k, r)| (format!("lines {k}!"), &r[..])).collect();
        let svg = rescheduled_svg(&named);
        let at = |k: usize| svg.find(&format!("lines {k}!"));
        assert_eq!((at(0), at(1)), (None, None));
        assert!((2..13).all(|k| at(k) < at(k + 1) && at(k).is_some()), "{svg}");
        let flat = ThetaRow { s_mm: 0.0, wall_deg: [0.0; 2], before_deg: 0.0, after_deg: 0.0 };
        assert!(!rescheduled_svg(&[("one".into(), &[flat])]).contains("one"));
    }
}
