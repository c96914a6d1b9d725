//! The comparison as a picture: one turn in the S–θ plane, and times over the sweep.

use super::Comparison;
use crate::artifact::channel::ChannelRow;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::write::draw::chart::{self, BLUE, Chart, ChartCurve, LOOKS};

/// Two panels, one under the other.
pub(super) fn svg(c: &Comparison, path: &Toolpath, channel: &Channel, curves: &[(&str, &Schedule)]) -> String {
    let charts: Vec<Chart> = turn(path, channel, curves).into_iter().chain([sweep(c)]).collect();
    chart::svg(&charts)
}

/// The middle turn: walls of the channel and every schedule.
fn turn(path: &Toolpath, channel: &Channel, schedules: &[(&str, &Schedule)]) -> Option<Chart> {
    let t = path.turns.get(path.turns.len() / 2)?;
    let rows = t.first..(t.first + t.count).min(path.locations.len()).min(channel.rows.len());
    let line = |theta: &dyn Fn(usize) -> Option<f64>| -> Vec<[f64; 2]> {
        rows.clone().filter_map(|i| Some([path.locations[i].turn_s_mm, theta(i)?.to_degrees()])).collect()
    };
    let wall = |f: fn(&ChannelRow) -> f64| line(&|i| channel.rows.get(i).map(f));
    let (low, high) = (wall(|r| r.theta_min), wall(|r| r.theta_max));
    let walls = [&low, &high].map(|wall| ChartCurve::line("channel", wall.clone(), BLUE, "", 1.5));
    let made = schedules.iter().zip(LOOKS.into_iter().cycle());
    let made = made.map(|((name, s), (colour, dash))| {
        ChartCurve::line(name, line(&|i| s.theta.get(i).copied()), colour, dash, 1.5)
    });
    Some(Chart {
        title: "S–θ channel of the middle turn".into(),
        x: "S, mm (middle turn)".into(),
        y: "θ, °".into(),
        curves: walls.into_iter().chain(made).collect(),
        band: Some((low, high)),
        ..Chart::default()
    })
}

/// Machining time over the lower bound, for each multiple of the machine's limits.
fn sweep(c: &Comparison) -> Chart {
    let at = |scale: f64| scale.log2();
    let names = c.sweep.first().map(|l| l.runs.iter().map(|r| r.name.as_str())).into_iter().flatten();
    let curves = names.enumerate().zip(LOOKS.into_iter().cycle()).map(|((k, name), (colour, dash))| {
        let points = c.sweep.iter().filter_map(|l| l.runs.get(k).map(|r| [at(l.scale), r.over_bound]));
        ChartCurve::line(name, points.collect(), colour, dash, 1.5)
    });
    Chart {
        title: "Machining time over its lower bound".into(),
        x: "limits of the machine, multiples of its own".into(),
        y: "time / lower bound".into(),
        curves: curves.collect(),
        ticks: c.sweep.iter().map(|l| (at(l.scale), format!("×{}", l.scale))).collect(),
        floor: Some(1.0),
        ..Chart::default()
    }
}
