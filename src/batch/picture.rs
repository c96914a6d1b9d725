//! A small picture of a member: the S–θ channel of the turn where it is narrowest, with the schedule through it.

use serde::{Deserialize, Serialize};

use crate::artifact::Plan;

/// Points of a curve.
const POINTS: usize = 48;

/// The channel over one turn, at evenly spread locations: rows of S in mm and θ in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// The turn.
    pub turn: u32,
    /// `[S, θ min, θ max, θ]`.
    pub rows: Vec<[f64; 4]>,
}

fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0 + 0.0
}

/// The picture of a plan; `None` where it has no turns.
pub(super) fn of(plan: &Plan) -> Option<Picture> {
    let row = plan.channel.narrowest_row;
    let place = plan.toolpath.turns.iter().position(|t| (t.first..t.first + t.count).contains(&row))?;
    let turn = plan.toolpath.turns.get(place)?;
    let last = turn.count.checked_sub(1)?;
    let mut picks: Vec<usize> = (0..=POINTS).map(|k| turn.first + k * last / POINTS).collect();
    picks.push(row);
    picks.sort_unstable();
    picks.dedup();
    let rows = picks.into_iter().filter_map(|k| {
        let (c, l) = (plan.channel.rows.get(k)?, plan.toolpath.locations.get(k)?);
        let theta = plan.schedule.theta.get(k)?;
        let deg = |x: f64| rounded(x.to_degrees());
        Some([rounded(l.turn_s_mm), deg(c.theta_min), deg(c.theta_max), deg(*theta)])
    });
    Some(Picture { turn: u32::try_from(place).unwrap_or(u32::MAX), rows: rows.collect() })
}

impl Picture {
    /// As inline SVG: the channel as an area, the schedule as a line, stretched to fill the picture.
    pub fn svg(&self) -> String {
        let (width, height) = (120.0, 46.0);
        let finite = |f: fn(f64, f64) -> f64, start: f64, k: &[usize]| {
            self.rows.iter().flat_map(|r| k.iter().map(|i| r[*i])).fold(start, f)
        };
        let s = [finite(f64::min, f64::INFINITY, &[0]), finite(f64::max, f64::NEG_INFINITY, &[0])];
        let t = [finite(f64::min, f64::INFINITY, &[1, 3]), finite(f64::max, f64::NEG_INFINITY, &[2, 3])];
        let at = |r: &[f64; 4], k: usize| {
            let x = (r[0] - s[0]) / (s[1] - s[0]).max(1e-9) * (width - 2.0) + 1.0;
            let y = height - 1.0 - (r[k] - t[0]) / (t[1] - t[0]).max(1e-9) * (height - 2.0);
            format!("{x:.1},{y:.1}")
        };
        let line = |k: usize| self.rows.iter().map(|r| at(r, k)).collect::<Vec<_>>();
        let (low, mut high, own) = (line(1), line(2), line(3).join(" "));
        high.reverse();
        let area = [low, high].concat().join(" ");
        format!(
            "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"channel and schedule of turn {}\">\
             <polygon class=\"channel\" points=\"{area}\"/><polyline class=\"schedule\" points=\"{own}\"/></svg>",
            self.turn
        )
    }
}
