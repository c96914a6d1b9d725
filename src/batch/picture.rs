//! A small picture of a member: the S–θ channel of the turn where it is narrowest, with the
//! schedule through it.

use serde::{Deserialize, Serialize};

use crate::artifact::Plan;
use crate::error::turn_number;
use crate::write::draw;

/// Points of a curve.
const POINTS: usize = 48;

/// The channel over one turn, at evenly spread locations: rows of S in mm and θ in degrees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// The turn, from 0.
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
    /// As inline SVG: the channel as an area, the schedule as a line, stretched to fill the
    /// picture.
    pub fn svg(&self) -> String {
        let line = |k: usize| self.rows.iter().map(|r| [r[0], r[k]]).collect::<Vec<_>>();
        let label = format!("channel and schedule of turn {}", turn_number(self.turn));
        draw::small(&label, (&line(1), &line(2)), &line(3))
    }
}
