//! All charts that stand still: SVG and PNG files for papers and slides, drawings inside pages,
//! small pictures of families. Those that answer the pointer are drawn in the browser, by
//! `viewer/src/plot.js`; `docs/decisions/charts-that-answer.md` says why.
//!
//! **In**: what the report is made from. **Out**: named SVG texts ([`plots`]), and any of them as
//! PNG ([`png()`]), whose letters are those of DejaVu Sans (Bitstream Vera licence: free to use and
//! to embed) from the crate `dejavu`; so a picture is the same on any machine. Nothing is thinned
//! but the scallop map.

pub(crate) mod chart;
pub mod colour;
mod held;
pub(in crate::write) mod histogram;
mod rescheduled;
mod scale;
mod sphere;
mod widths;

use std::sync::Arc;

use chart::{BLACK, BLUE, Chart, ChartCurve, Dots, GREEN, ORANGE, PINK, PURPLE};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg;

use crate::artifact::{AxisMotion, CheckReport, Plan, Schedule, Section};
use crate::error::{Error, Result, Stage};
use crate::machine::{Axis, Machine};

pub use chart::small;
pub use held::{HeldAngles, held_svg};
pub use rescheduled::rescheduled_svg;
pub use sphere::{sphere_csv, sphere_svg};
pub use widths::{widths_csv, widths_inline, widths_svg};

/// Most dots of the scallop map.
const DOTS: usize = 8000;

/// Another schedule for the same path, to compare with.
#[derive(Clone, Copy, Debug)]
pub struct OtherSchedule<'a> {
    /// What it is, e.g. `fixed lead`.
    pub name: &'a str,
    /// Its angles, one per cutter location of the plan.
    pub schedule: &'a Schedule,
    /// Its axis motion, if it was computed.
    pub motion: Option<&'a AxisMotion>,
}

/// What plots are made from.
pub struct PlotInput<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// The machine, for its limits.
    pub machine: &'a Machine,
    /// Other schedules for the same path.
    pub others: &'a [OtherSchedule<'a>],
    /// What the checks found.
    pub checks: &'a CheckReport,
    /// Plane sections.
    pub sections: &'a [Section],
}

/// File names without their ending, and SVG texts: S–θ plot and axes of the turn, histogram and map
/// of the scallop, the middle section. Turns count from 1.
///
/// # Errors
/// `Usage` where the plan has no such turn.
pub fn plots(input: &PlotInput, turn: usize) -> Result<Vec<(String, String)>> {
    let plan = input.plan;
    let n = plan.toolpath.locations.len().min(plan.channel.rows.len()).min(plan.schedule.theta.len());
    let turns = &plan.toolpath.turns;
    let Some(t) = turn.checked_sub(1).and_then(|k| turns.get(k)) else {
        let message = format!("there is no turn {turn}, the plan has turns 1 to {}", turns.len());
        return Err(Error::usage(Stage::Preview, message));
    };
    let rows = t.first.min(n)..t.first.saturating_add(t.count).min(n);
    let mut out = vec![(format!("channel-turn-{turn}"), chart::svg(&[channel(input, turn, rows.clone())]))];
    for (axis, Axis { name, .. }) in input.machine.axes().iter().enumerate() {
        let panels: Vec<Chart> = (0..4).map(|kind| motion(input, turn, rows.clone(), axis, kind)).collect();
        out.push((format!("axis-{}-turn-{turn}", name.to_lowercase()), chart::svg(&panels)));
    }
    out.extend(histogram(input).map(|c| ("scallop-histogram".to_owned(), chart::svg(&[c]))));
    out.extend(map(input).map(|c| ("scallop-map".to_owned(), chart::svg(&[c]))));
    let middle = input.sections.get(input.sections.len() / 2);
    out.extend(middle.map(|s| ("section".to_owned(), chart::svg(&section(s)))));
    Ok(out)
}

/// The S–θ plane of a turn, less the straight line from its start to its end.
fn channel(input: &PlotInput, turn: usize, rows: std::ops::Range<usize>) -> Chart {
    let plan = input.plan;
    let theta = &plan.schedule.theta;
    let (start, end) = (rows.start, rows.end.min(theta.len().saturating_sub(1)));
    let s = |i: usize| plan.toolpath.locations[i].s_mm - plan.toolpath.locations[start].s_mm;
    let slope = if s(end) > 0.0 { (theta[end] - theta[start]) / s(end) } else { 0.0 };
    let line = |f: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
        rows.clone().map(|i| [s(i), (f(i) - theta[start] - slope * s(i)).to_degrees()]).collect()
    };
    let r = &plan.channel.rows;
    let (low, high) = (line(&|i| r[i].theta_min), line(&|i| r[i].theta_max));
    let mut curves = vec![
        ChartCurve::line("true channel", low.clone(), BLUE, "", 1.5),
        ChartCurve::line("true channel", high.clone(), BLUE, "", 1.5),
        ChartCurve::line("monotone hull", line(&|i| r[i].hull_min), GREEN, "7 4", 1.5),
        ChartCurve::line("monotone hull", line(&|i| r[i].hull_max), GREEN, "7 4", 1.5),
        ChartCurve::line("tangent channel", line(&|i| r[i].tangent_min), PURPLE, "2 3", 1.5),
        ChartCurve::line("tangent channel", line(&|i| r[i].tangent_max), PURPLE, "2 3", 1.5),
    ];
    let looks = [(ORANGE, "13 4"), (PINK, "5 3"), (GREEN, "2 5"), (PINK, "13 4"), (ORANGE, "2 5")];
    for (o, (colour, dash)) in input.others.iter().zip(looks.into_iter().cycle()) {
        let of = |i: usize| o.schedule.theta.get(i).copied().unwrap_or(f64::NAN);
        curves.push(ChartCurve::line(o.name, line(&of), colour, dash, 1.5));
    }
    let kind = format!("{:?}", plan.schedule.kind).to_lowercase();
    curves.push(ChartCurve::line(&kind, line(&|i| theta[i]), BLACK, "", 2.4));
    let from = plan.toolpath.locations[start].s_mm;
    let inside = plan.schedule.key_points.iter().filter(|k| (-1e-9..=s(end) + 1e-9).contains(&(k[0] - from)));
    let keys = inside.map(|k| [k[0] - from, (k[1] - theta[start] - slope * (k[0] - from)).to_degrees()]).collect();
    curves.push(ChartCurve {
        name: "key points".into(),
        points: keys,
        colour: BLACK,
        marks: true,
        ..ChartCurve::default()
    });
    Chart {
        title: format!("S–θ channel of turn {turn}"),
        x: format!("S, mm (turn {turn})"),
        y: "θ less the straight guide line, °".into(),
        curves,
        band: Some((low, high)),
        ..Chart::default()
    }
}

/// One panel of an axis: position, velocity, acceleration or jerk over the time from the turn's
/// start.
fn motion(input: &PlotInput, turn: usize, rows: std::ops::Range<usize>, axis: usize, kind: usize) -> Chart {
    let (turning, own_axis) = (input.machine.turning_axis(), &input.machine.axes()[axis]);
    let scale = own_axis.scale();
    let line = |m: &AxisMotion| -> Vec<[f64; 2]> {
        let list = [&m.position, &m.velocity, &m.acceleration, &m.jerk][kind];
        let start = m.t_s.get(rows.start).copied().unwrap_or(0.0);
        let zero = if kind == 0 && axis == turning { list.get(rows.start).map_or(0.0, |r| r[axis]) } else { 0.0 };
        let at = |i: usize| Some([m.t_s.get(i)? - start, (list.get(i)?[axis] - zero) * scale]);
        rows.clone().filter_map(at).collect()
    };
    let mut curves = Vec::new();
    for o in input.others {
        curves.extend(o.motion.map(|m| ChartCurve::line(o.name, line(m), ORANGE, "13 4", 1.5)));
    }
    let own = line(&input.plan.motion);
    let ends = [own.first(), own.last()].map(|p| p.map_or(0.0, |p| p[0]));
    curves.push(ChartCurve::line("this plan", own, BLUE, "", 2.0));
    let l = own_axis.limits;
    if let Some(limit) = [None, Some(l.velocity), Some(l.acceleration), Some(l.jerk)][kind] {
        // A limit far above all values would press them flat.
        let most = curves.iter().flat_map(|c| &c.points).map(|p| p[1].abs()).fold(0.0, f64::max);
        for sign in [1.0, -1.0] {
            if most > 0.3 * limit * scale {
                let level = sign * limit * scale;
                curves.push(ChartCurve::line("limit", vec![[ends[0], level], [ends[1], level]], BLACK, "2 3", 1.2));
            }
        }
    }
    let (unit, name) = (own_axis.sign(), &own_axis.name);
    let (what, per) = [("position", ""), ("velocity", "/s"), ("acceleration", "/s²"), ("jerk", "/s³")][kind];
    Chart {
        title: format!("{name} {what} of turn {turn}"),
        x: format!("time, s (turn {turn})"),
        y: format!("{name} {what}, {unit}{per}"),
        curves,
        ..Chart::default()
    }
}

fn histogram(input: &PlotInput) -> Option<Chart> {
    let h = histogram::histogram(input.checks)?;
    let shares = |counts: &[usize]| {
        let all = counts.iter().sum::<usize>().max(1) as f64;
        counts.iter().map(|n| 100.0 * *n as f64 / all).collect::<Vec<_>>()
    };
    let edge = |k: usize| 1000.0 * (h.from + k as f64 * h.step);
    let bars = shares(&h.samples).iter().enumerate().map(|(k, v)| [edge(k), 1000.0 * h.step, *v]).collect();
    let steps = shares(&h.ridges).iter().enumerate().flat_map(|(k, v)| [[edge(k), *v], [edge(k + 1), *v]]).collect();
    let surface = ChartCurve { name: "surface (bars)".into(), colour: BLUE, width: 8.0, ..ChartCurve::default() };
    Some(Chart {
        title: "How often which scallop occurs".into(),
        x: "height, µm".into(),
        y: "share, %".into(),
        curves: vec![surface, ChartCurve::line("ridges", steps, ORANGE, "", 2.0)],
        bars,
        lines: vec![(1000.0 * input.plan.toolpath.scallop_mm, "asked for".into())],
        ..Chart::default()
    })
}

/// Heights over the way round the turn and along the blade.
fn map(input: &PlotInput) -> Option<Chart> {
    let (path, places) = (&input.plan.toolpath, &input.checks.scallop);
    let (lo, hi) = (places.first()?.height_mm, places.last()?.height_mm.max(path.scallop_mm));
    let dot = |p: &crate::artifact::report::Place| {
        let l = path.locations.get(p.row)?;
        let turn = path.turns.get(l.turn as usize)?;
        Some(([100.0 * l.turn_s_mm / turn.length_mm.max(1e-9), p.point.x], (p.height_mm - lo) / (hi - lo).max(1e-12)))
    };
    let at = places.iter().step_by(places.len().div_ceil(DOTS).max(1)).filter_map(dot).collect();
    Some(Chart {
        title: "Where which scallop occurs".into(),
        x: "way round the turn, %".into(),
        y: "height along the blade axis, mm".into(),
        dots: Some(Dots { at, scale: ("scallop, µm".into(), [1000.0 * lo, 1000.0 * hi]) }),
        ..Chart::default()
    })
}

/// Outlines, and the airfoil's curvature.
fn section(s: &Section) -> Vec<Chart> {
    let closed = |points: &[[f64; 2]]| points.iter().chain(points.first()).copied().collect::<Vec<_>>();
    let mut outline: Vec<ChartCurve> =
        s.loops.iter().map(|l| ChartCurve::line("", closed(&l.points_mm), BLUE, "", 1.8)).collect();
    for (name, into, colour) in [("into concave", true, ORANGE), ("into convex", false, PURPLE)] {
        let all = s.loops.iter().flat_map(|l| &l.altered_points).filter(|a| a.into_concave == into);
        let points = all.map(|a| a.point_mm).collect();
        outline.push(ChartCurve { name: name.into(), points, colour, marks: true, ..ChartCurve::default() });
    }
    let x = format!("y, mm (section at {:.3} mm)", s.x_mm);
    let mut out =
        vec![Chart { title: "Section".into(), x, y: "z, mm".into(), curves: outline, equal: true, ..Chart::default() }];
    if let Some(l) = s.loops.first() {
        let points = l.s_mm.iter().zip(&l.curvature_per_mm).map(|(s, k)| [*s, *k]).collect();
        out.push(Chart {
            title: "Curvature".into(),
            x: "arc length round the airfoil, mm".into(),
            y: "curvature, 1/mm".into(),
            curves: vec![ChartCurve::line("curvature", points, BLUE, "", 1.8)],
            ..Chart::default()
        });
    }
    out
}

/// An SVG text as a PNG file, `width` pixels wide.
///
/// # Errors
/// `Usage` where the width is 0 or larger than 20 000; `InputOutput` where the picture cannot be
/// drawn or encoded.
pub fn png(svg: &str, width: u32) -> Result<Vec<u8>> {
    let bad = |e: String| Error::io(Stage::Preview, format!("a plot cannot be drawn as PNG: {e}"));
    if !(1..=20_000).contains(&width) {
        return Err(Error::usage(Stage::Preview, format!("the width is {width} px, it must be from 1 to 20000")));
    }
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    let options =
        usvg::Options { fontdb: Arc::new(fonts), font_family: "DejaVu Sans".into(), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).map_err(|e| bad(e.to_string()))?;
    let scale = f64::from(width) / chart::WIDTH;
    let height = (f64::from(tree.size().height()) * scale).ceil() as u32;
    let mut pixels = Pixmap::new(width, height.max(1)).ok_or_else(|| bad("it is too large".into()))?;
    resvg::render(&tree, Transform::from_scale(scale as f32, scale as f32), &mut pixels.as_mut());
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // The ground is opaque, so what is left of the opacity is 1.
    let rgb: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    encoder.write_header().and_then(|mut w| w.write_image_data(&rgb)).map_err(|e| bad(e.to_string()))?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::report::Place;
    use crate::sample;

    fn made(turn: usize) -> Result<Vec<(String, String)>> {
        let (plan, machine, sections) = (sample::plan(3, 120), Machine::demo().unwrap(), sample::sections());
        let mut checks = sample::report();
        let l = &plan.toolpath.locations;
        checks.scallop =
            (0..360).map(|k| Place { point: l[k].contact, row: k, height_mm: 0.001 + 2e-5 * k as f64 }).collect();
        let others = [OtherSchedule { name: "a < b", schedule: &plan.schedule, motion: Some(&plan.motion) }];
        plots(
            &PlotInput { plan: &plan, machine: &machine, others: &others, checks: &checks, sections: &sections },
            turn,
        )
    }

    #[test]
    fn every_plot_is_well_formed_and_becomes_a_picture() {
        let all = made(2).unwrap();
        let names: Vec<&str> = all.iter().map(|p| p.0.as_str()).collect();
        assert_eq!(names[..2], ["channel-turn-2", "axis-x-turn-2"]);
        assert_eq!(names[6..], ["scallop-histogram", "scallop-map", "section"]);
        for (name, svg) in &all {
            assert!(!svg.contains("NaN") && !svg.contains("a < b"), "{name}");
            usvg::Tree::from_str(svg, &usvg::Options::default()).unwrap();
        }
        let picture = png(&all[0].1, 430).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(&picture)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (430, 160));
        // Letters of the axis' name are there: dark pixels at the left edge.
        let dark = (20..140).flat_map(|y| (4..12).map(move |x| 3 * (430 * y + x))).filter(|i| pixels[*i] < 128).count();
        assert!(dark > 20, "{dark}");
    }

    #[test]
    fn a_turn_that_is_not_there_is_told() {
        for turn in [0, 4] {
            let message = made(turn).unwrap_err().message;
            assert_eq!(message, format!("there is no turn {turn}, the plan has turns 1 to 3"));
        }
        // The plots of the last turn are those of its rows.
        assert!(made(3).unwrap()[0].1.contains("channel of turn 3"));
        assert!(png("<svg/>", 0).is_err() && png("no svg", 100).is_err());
    }
}
