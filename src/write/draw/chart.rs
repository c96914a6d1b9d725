//! A plot with axes, curves, a band, marks, bars and coloured dots as SVG, on white for paper and
//! slides.

use std::fmt::Write;

use crate::write::draw::colour;
use crate::write::draw::scale::Scale;

/// Size of a panel and its margins left, below, right, above, px.
const PANEL: [f64; 2] = [860.0, 320.0];
const MARGIN: [f64; 4] = [78.0, 46.0, 18.0, 34.0];
/// Width of the whole picture, px.
pub(crate) const WIDTH: f64 = PANEL[0];

/// Colours told apart with any colour vision (Okabe and Ito 2008, darkened for white paper).
pub(crate) const BLUE: &str = "#0072b2";
pub(crate) const ORANGE: &str = "#d55e00";
pub(crate) const GREEN: &str = "#008a62";
pub(crate) const PURPLE: &str = "#7a5195";
pub(crate) const PINK: &str = "#a8568a";
pub(crate) const BLACK: &str = "#111111";

/// Colours and dashes of schedules that are compared, in their order.
pub(crate) const LOOKS: [(&str, &str); 6] =
    [(ORANGE, "13 4"), (PINK, "5 3"), (GREEN, "2 5"), (BLACK, ""), (PURPLE, "7 4"), (ORANGE, "2 5")];

/// Points in order.
pub(crate) type ChartLine = Vec<[f64; 2]>;

/// One curve.
#[derive(Clone, Debug, Default)]
pub(crate) struct ChartCurve {
    pub name: String,
    pub points: ChartLine,
    pub colour: &'static str,
    /// SVG's dashes; empty: solid.
    pub dash: &'static str,
    pub width: f64,
    /// Points alone.
    pub marks: bool,
}

impl ChartCurve {
    /// A line through points; it breaks where a value is not a number.
    pub(crate) fn line(name: &str, points: ChartLine, colour: &'static str, dash: &'static str, width: f64) -> Self {
        Self { name: name.into(), points, colour, dash, width, marks: false }
    }

    fn draw(&self, out: &mut String, x: &Scale, y: &Scale) {
        if self.marks {
            for p in self.points.iter().filter(|p| p[0].is_finite() && p[1].is_finite()) {
                let (x, y) = (x.at(p[0]), y.at(p[1]));
                let _ = writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" fill=\"{}\"/>", self.colour);
            }
            return;
        }
        let _ = writeln!(
            out,
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\" stroke-linejoin=\"round\"/>",
            path_of(&mut self.points.iter(), x, y),
            self.colour,
            self.width,
            if self.dash.is_empty() { "none" } else { self.dash }
        );
    }
}

/// Coloured dots: place and share of the scale.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dots {
    pub at: Vec<([f64; 2], f64)>,
    /// Name and unit of the scale, its least and greatest value.
    pub scale: (String, [f64; 2]),
}

/// One panel.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chart {
    pub title: String,
    pub x: String,
    pub y: String,
    pub curves: Vec<ChartCurve>,
    /// Lower and upper edge of a shaded band.
    pub band: Option<(ChartLine, ChartLine)>,
    /// Left edge, width and height of bars.
    pub bars: Vec<[f64; 3]>,
    pub dots: Option<Dots>,
    /// Vertical lines with their names.
    pub lines: Vec<(f64, String)>,
    /// Same scale on both axes.
    pub equal: bool,
    /// Ranges of x that are shaded because there is nothing to show in them.
    pub closed: Vec<[f64; 2]>,
    /// Places and names of the marks along x, where round numbers do not serve.
    pub ticks: Vec<(f64, String)>,
    /// Least value of y, where it is not that of what is drawn.
    pub floor: Option<f64>,
}

pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Charts one under the other as an SVG file.
pub(crate) fn svg(charts: &[Chart]) -> String {
    let height = PANEL[1] * charts.len() as f64;
    let of_file = format!(
        "xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" color=\"{BLACK}\" \
         font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\""
    );
    let ground = format!("<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#ffffff\"/>\n");
    element(charts, &of_file, &ground)
}

/// The same as an element of a page, in the page's colour of letters and on its ground.
pub(crate) fn inline(charts: &[Chart]) -> String {
    element(charts, "role=\"img\" font-family=\"sans-serif\"", "")
}

fn element(charts: &[Chart], attributes: &str, ground: &str) -> String {
    let height = PANEL[1] * charts.len() as f64;
    let mut out =
        format!("<svg {attributes} viewBox=\"0 0 {WIDTH} {height}\" font-size=\"12\" fill=\"currentColor\">\n{ground}");
    for (k, chart) in charts.iter().enumerate() {
        chart.draw(&mut out, k);
    }
    out.push_str("</svg>\n");
    out
}

/// A band and a line through it without axes, as a small element of a page. The page's style gives
/// `channel` and `schedule` their colours.
pub fn small(label: &str, band: (&[[f64; 2]], &[[f64; 2]]), line: &[[f64; 2]]) -> String {
    let (width, height) = (120.0, 46.0);
    let all = || band.0.iter().chain(band.1).chain(line);
    let x = Scale { from: range(all().map(|p| p[0])), to: [1.0, width - 1.0] };
    let y = Scale { from: range(all().map(|p| p[1])), to: [height - 1.0, 1.0] };
    let points = |list: &mut dyn Iterator<Item = &[f64; 2]>| {
        list.map(|p| format!("{:.1},{:.1}", x.at(p[0]), y.at(p[1]))).collect::<Vec<_>>().join(" ")
    };
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\
         <polygon class=\"channel\" points=\"{}\"/><polyline class=\"schedule\" points=\"{}\"/></svg>",
        escape(label),
        points(&mut band.0.iter().chain(band.1.iter().rev())),
        points(&mut line.iter())
    )
}

/// Least and greatest of the finite values; 0 to 1 where there are none.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [lo, hi] =
        values.filter(|v| v.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| [lo.min(v), hi.max(v)]);
    if lo <= hi { [lo, hi] } else { [0.0, 1.0] }
}

/// Path data of a line; it breaks where a value is not a number.
fn path_of(points: &mut dyn Iterator<Item = &[f64; 2]>, x: &Scale, y: &Scale) -> String {
    let (mut data, mut pen) = (String::new(), 'M');
    for p in points {
        if p[0].is_finite() && p[1].is_finite() {
            let _ = write!(data, "{pen}{:.2} {:.2}", x.at(p[0]), y.at(p[1]));
            pen = 'L';
        } else {
            pen = 'M';
        }
    }
    data
}

impl Chart {
    /// Least and greatest of a coordinate of all that is drawn; a little more on either side where
    /// `pad`.
    fn extent(&self, axis: usize, pad: f64) -> [f64; 2] {
        let band = self.band.iter().flat_map(|(a, b)| a.iter().chain(b));
        let curves = self.curves.iter().flat_map(|c| &c.points).chain(band).map(|p| p[axis]);
        let dots = self.dots.iter().flat_map(|d| &d.at).map(|(p, _)| p[axis]);
        let bars = self.bars.iter().flat_map(|b| if axis == 0 { [b[0], b[0] + b[1]] } else { [0.0, b[2]] });
        let lines = self.lines.iter().filter(|_| axis == 0).map(|l| l.0);
        let closed = self.closed.iter().flatten().filter(|_| axis == 0).copied();
        let [lo, hi] = range(curves.chain(dots).chain(bars).chain(lines).chain(closed));
        let more = if hi > lo { pad * (hi - lo) } else { (0.05 * hi.abs()).max(0.5) };
        [lo - more, hi + more]
    }

    fn draw(&self, out: &mut String, k: usize) {
        let top = PANEL[1] * k as f64;
        let mut x = Scale { from: self.extent(0, 0.0), to: [MARGIN[0], PANEL[0] - MARGIN[2]] };
        let mut y = Scale { from: self.extent(1, 0.05), to: [top + PANEL[1] - MARGIN[1], top + MARGIN[3]] };
        if self.equal {
            let span = |s: &Scale| (s.from[1] - s.from[0]) / (s.to[1] - s.to[0]).abs();
            let unit = 1.05 * span(&x).max(span(&y));
            for s in [&mut x, &mut y] {
                let (mid, half) = (0.5 * (s.from[0] + s.from[1]), 0.5 * unit * (s.to[1] - s.to[0]).abs());
                s.from = [mid - half, mid + half];
            }
        }
        if let Some(floor) = self.floor {
            y.from = [floor, y.from[1].max(floor + 0.01 * floor.abs().max(1.0))];
        }
        let _ = writeln!(out, "<g><title>{}</title>", escape(&self.title));
        self.axes(out, &x, &y);
        self.content(out, &x, &y);
        self.legend(out, top);
        out.push_str("</g>\n");
    }

    /// Places and names of the marks along x.
    fn marks_along(&self, x: &Scale) -> Vec<(f64, String)> {
        if !self.ticks.is_empty() {
            return self.ticks.clone();
        }
        let (values, digits) = x.ticks(10.0);
        values.into_iter().map(|v| (v, format!("{v:.digits$}").replace('-', "−"))).collect()
    }

    fn axes(&self, out: &mut String, x: &Scale, y: &Scale) {
        let (values, digits) = y.ticks(6.0);
        for v in values {
            let at = y.at(v);
            let _ = writeln!(
                out,
                "<path d=\"M{:.1} {at:.1}H{:.1}\" stroke=\"currentColor\" opacity=\"0.15\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                x.to[0],
                x.to[1],
                x.to[0] - 6.0,
                at + 4.0,
                format!("{v:.digits$}").replace('-', "−")
            );
        }
        for (v, name) in self.marks_along(x) {
            let _ = writeln!(
                out,
                "<path d=\"M{0:.1} {1:.1}V{2:.1}\" stroke=\"currentColor\" opacity=\"0.15\"/><text x=\"{0:.1}\" y=\"{3:.1}\" text-anchor=\"middle\">{4}</text>",
                x.at(v),
                y.to[0],
                y.to[1],
                y.to[0] + 16.0,
                escape(&name)
            );
        }
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text><text transform=\"translate(16 {:.1}) rotate(-90)\" \
             text-anchor=\"middle\">{}</text>",
            0.5 * (x.to[0] + x.to[1]),
            y.to[0] + 34.0,
            escape(&self.x),
            0.5 * (y.to[0] + y.to[1]),
            escape(&self.y)
        );
    }

    fn content(&self, out: &mut String, x: &Scale, y: &Scale) {
        self.areas(out, x, y);
        for (p, share) in self.dots.iter().flat_map(|d| &d.at) {
            let _ = writeln!(
                out,
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"3\" height=\"3\" fill=\"{}\"/>",
                x.at(p[0]) - 1.5,
                y.at(p[1]) - 1.5,
                colour::hex(colour::of(*share))
            );
        }
        for c in &self.curves {
            c.draw(out, x, y);
        }
        for (v, name) in &self.lines {
            let _ = writeln!(
                out,
                "<path d=\"M{0:.1} {1:.1}V{2:.1}\" stroke=\"currentColor\" stroke-dasharray=\"6 4\"/><text x=\"{3:.1}\" y=\"{4:.1}\" \
                 text-anchor=\"end\">{5}</text>",
                x.at(*v),
                y.to[0],
                y.to[1],
                x.at(*v) - 5.0,
                y.to[1] + 14.0,
                escape(name)
            );
        }
    }

    /// What is filled: closed ranges, the band, bars.
    fn areas(&self, out: &mut String, x: &Scale, y: &Scale) {
        for [from, to] in &self.closed {
            let (left, right) = (x.at(*from).max(x.to[0]), x.at(*to).min(x.to[1]));
            let _ = writeln!(
                out,
                "<rect x=\"{left:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{ORANGE}\" opacity=\"0.15\"/>",
                y.to[1],
                right - left,
                y.to[0] - y.to[1]
            );
        }
        if let Some((low, high)) = &self.band {
            let edge = path_of(&mut low.iter().chain(high.iter().rev()).filter(|p| p[1].is_finite()), x, y);
            let _ = writeln!(out, "<path d=\"{edge}Z\" fill=\"{BLUE}\" opacity=\"0.12\"/>");
        }
        for [left, wide, high] in &self.bars {
            let _ = writeln!(
                out,
                "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"{BLUE}\" opacity=\"0.45\"/>",
                x.at(*left),
                y.at(*high),
                (x.at(left + wide) - x.at(*left)).max(0.3),
                (y.at(0.0) - y.at(*high)).max(0.0)
            );
        }
    }

    fn legend(&self, out: &mut String, top: f64) {
        let mut left = MARGIN[0];
        let mut seen: Vec<&str> = Vec::new();
        for c in &self.curves {
            if c.name.is_empty() || seen.contains(&c.name.as_str()) {
                continue;
            }
            seen.push(&c.name);
            if c.marks {
                let _ = writeln!(
                    out,
                    "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4\" fill=\"{}\"/>",
                    left + 11.0,
                    top + 18.0,
                    c.colour
                );
            } else {
                let _ = writeln!(
                    out,
                    "<path d=\"M{left:.1} {:.1}h22\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"/>",
                    top + 18.0,
                    c.colour,
                    c.width,
                    if c.dash.is_empty() { "none" } else { c.dash }
                );
            }
            let _ = writeln!(out, "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>", left + 28.0, top + 22.0, escape(&c.name));
            left += 38.0 + 6.6 * c.name.chars().count() as f64;
        }
        let Some(dots) = &self.dots else { return };
        let wide = 200.0;
        for k in 0..50 {
            let colour = colour::hex(colour::of(f64::from(k) / 49.0));
            let _ = writeln!(
                out,
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"4.2\" height=\"10\" fill=\"{colour}\"/>",
                left + 4.0 * f64::from(k),
                top + 12.0
            );
        }
        let (name, [lo, hi]) = &dots.scale;
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\">{}: {lo:.2} (dark) to {hi:.2} (bright)</text>",
            left + wide + 10.0,
            top + 22.0,
            escape(name)
        );
    }
}
