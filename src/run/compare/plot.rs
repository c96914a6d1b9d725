//! The comparison as a picture: one turn in the S–θ plane, and times over the sweep.

use std::fmt::Write;

use super::Comparison;
use crate::artifact::{Channel, Schedule, Toolpath};

const WIDTH: f64 = 900.0;
const PANEL: f64 = 360.0;
const EDGE: f64 = 60.0;
const COLOURS: [&str; 6] = ["#888888", "#d08000", "#2060c0", "#109040", "#80c020", "#c02060"];

/// Maps a range of values to a range of the picture.
struct Axis {
    from: [f64; 2],
    to: [f64; 2],
}

impl Axis {
    fn at(&self, v: f64) -> f64 {
        let span = self.from[1] - self.from[0];
        let f = if span.abs() > 0.0 { (v - self.from[0]) / span } else { 0.5 };
        self.to[0] + f * (self.to[1] - self.to[0])
    }
}

/// Two panels, one under the other.
pub(super) fn svg(c: &Comparison, path: &Toolpath, channel: &Channel, curves: &[(&str, &Schedule)]) -> String {
    let height = 2.0 * PANEL + 40.0;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"white\"/>\n"
    );
    turn(&mut out, path, channel, curves);
    sweep(&mut out, c);
    out.push_str("</svg>\n");
    out
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [lo, hi] =
        values.filter(|v| v.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| [lo.min(v), hi.max(v)]);
    if lo <= hi { [lo, hi] } else { [0.0, 1.0] }
}

fn polyline(out: &mut String, points: impl Iterator<Item = [f64; 2]>, style: &str) {
    out.push_str("<polyline fill=\"none\" ");
    out.push_str(style);
    out.push_str(" points=\"");
    for [x, y] in points {
        let _ = write!(out, "{x:.2},{y:.2} ");
    }
    out.push_str("\"/>\n");
}

fn text(out: &mut String, x: f64, y: f64, anchor: &str, words: &str) {
    let safe = words.replace('&', "&amp;").replace('<', "&lt;");
    let _ = writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{safe}</text>");
}

/// The middle turn: walls of the channel and every schedule.
fn turn(out: &mut String, path: &Toolpath, channel: &Channel, curves: &[(&str, &Schedule)]) {
    let Some(t) = path.turns.get(path.turns.len() / 2) else { return };
    let rows = t.first..(t.first + t.count).min(path.locations.len()).min(channel.rows.len());
    let at: Vec<f64> = rows.clone().map(|i| path.locations[i].turn_s_mm).collect();
    let walls = |f: fn(&crate::artifact::channel::ChannelRow) -> f64| -> Vec<f64> {
        rows.clone().map(|i| f(&channel.rows[i]).to_degrees()).collect()
    };
    let (lo, hi) = (walls(|r| r.theta_min), walls(|r| r.theta_max));
    let x = Axis { from: range(at.iter().copied()), to: [EDGE, WIDTH - 20.0] };
    let y = Axis { from: range(lo.iter().chain(&hi).copied()), to: [PANEL - 30.0, 30.0] };
    text(
        out,
        EDGE,
        18.0,
        "start",
        "S–θ plane of the middle turn: angle (degrees) over arc length (mm); grey: outside the channel",
    );
    for (wall, side) in [(&lo, y.to[0]), (&hi, y.to[1])] {
        let line = at.iter().zip(wall).map(|(s, v)| [x.at(*s), y.at(*v)]);
        let ends = [[x.to[1], side], [x.to[0], side]];
        let mut points = String::new();
        line.chain(ends).for_each(|[a, b]| {
            let _ = write!(points, "{a:.2},{b:.2} ");
        });
        let _ = writeln!(out, "<polygon fill=\"#e4e4e4\" stroke=\"#999\" points=\"{points}\"/>");
    }
    for (k, (name, s)) in curves.iter().enumerate() {
        let colour = COLOURS[k % COLOURS.len()];
        let line =
            rows.clone().zip(&at).filter_map(|(i, at)| s.theta.get(i).map(|t| [x.at(*at), y.at(t.to_degrees())]));
        polyline(out, line, &format!("stroke=\"{colour}\" stroke-width=\"1.5\""));
        legend(out, k, name, 40.0);
    }
    for v in [x.from[0], x.from[1]] {
        text(out, x.at(v), PANEL - 12.0, "middle", &format!("{v:.1}"));
    }
    for v in [y.from[0], y.from[1]] {
        text(out, EDGE - 6.0, y.at(v) + 4.0, "end", &format!("{v:.0}"));
    }
}

fn legend(out: &mut String, k: usize, name: &str, top: f64) {
    let (x, y, colour) = (EDGE + 10.0, top + 15.0 * k as f64, COLOURS[k % COLOURS.len()]);
    let _ = writeln!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"14\" height=\"4\" fill=\"{colour}\"/>");
    text(out, x + 20.0, y + 6.0, "start", name);
}

/// Machining time over the lower bound, for each multiple of the machine's limits.
fn sweep(out: &mut String, c: &Comparison) {
    let all = c.sweep.iter().flat_map(|l| l.runs.iter().map(|r| r.over_bound));
    let top = range(all)[1].max(1.01);
    let x = Axis { from: range(c.sweep.iter().map(|l| l.scale.log2())), to: [EDGE, WIDTH - 20.0] };
    let y = Axis { from: [1.0, top], to: [2.0 * PANEL, PANEL + 50.0] };
    text(
        out,
        EDGE,
        PANEL + 30.0,
        "start",
        "Machining time over the lower bound, against the machine's limits (multiples)",
    );
    polyline(out, x.to.iter().map(|v| [*v, y.at(1.0)]), "stroke=\"#999\"");
    let names: Vec<&str> =
        c.sweep.first().map(|l| l.runs.iter().map(|r| r.name.as_str()).collect()).unwrap_or_default();
    for (k, name) in names.iter().enumerate() {
        let line = c.sweep.iter().filter_map(|l| l.runs.get(k).map(|r| [x.at(l.scale.log2()), y.at(r.over_bound)]));
        polyline(out, line, &format!("stroke=\"{}\" stroke-width=\"1.5\"", COLOURS[k % COLOURS.len()]));
        legend(out, k, name, PANEL + 60.0);
    }
    for l in &c.sweep {
        text(out, x.at(l.scale.log2()), 2.0 * PANEL + 18.0, "middle", &format!("×{}", l.scale));
    }
    for v in [1.0, top] {
        text(out, EDGE - 6.0, y.at(v) + 4.0, "end", &format!("{v:.2}"));
    }
}
