//! θ of the curve: between the walls of the channel, never falling. Its breaks are some of those of
//! the ball centre: where these are near to one another, numbers of one size in floating point
//! would not show third derivatives of θ.

use std::ops::Range;

use super::form::{self, Form};
use super::{Near, SmoothOptions};
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::numerics::bounded::{self, Enough, Missed, Solution, Span, Strip, SumLimit};
use crate::numerics::quintic::{Breaks, CONDITION, ORDER, apply};
use crate::parallel;

/// A span is cut where walls as seen from the curve differ by more than this share of the way
/// between them.
const EVEN: f64 = 0.05;
/// A third derivative that is nothing, rad/mm³: at 100 mm/s a jerk of 6°/s³.
const NOTHING: f64 = 1e-7;
/// Breaks of θ are no nearer to one another than these shares of the average, the first that does.
const THINNED: [f64; 3] = [1.0, 0.25, 0.0];

/// Where the schedule is outside of walls that were seen, θ may be farther from it, so far around,
/// mm.
const AROUND_MM: f64 = 1.0;

/// θ of a stretch.
pub(super) struct Turned {
    pub breaks: Breaks,
    /// Control values, rad.
    pub theta: Vec<f64>,
    /// Half the integral of the squared third derivative, and its bound on the same breaks.
    pub square: [f64; 2],
}

/// A place of a stretch with the angle that the schedule has there and those that θ may have.
#[derive(Clone, Copy, Debug)]
struct TurnLimit {
    s_mm: f64,
    theta: f64,
    lo: f64,
    hi: f64,
}

impl TurnLimit {
    fn free(s_mm: f64, theta: f64) -> TurnLimit {
        TurnLimit { s_mm, theta, lo: f64::NEG_INFINITY, hi: f64::INFINITY }
    }

    /// As near to the schedule as `keep`, and no nearer to a wall than `margin`, or than the
    /// schedule itself where that is nearer.
    fn within(&self, [least, greatest]: [f64; 2], keep: f64, margin: f64) -> TurnLimit {
        let lo = (self.theta - keep).max(self.theta.min(least + margin));
        let hi = (self.theta + keep).min(self.theta.max(greatest - margin));
        TurnLimit { lo, hi, ..*self }
    }

    /// The same where the schedule may be outside of the walls: about the nearest angle within.
    fn within_seen(&self, walls: [f64; 2], keep: f64, margin: f64) -> TurnLimit {
        let nearest = self.theta.max(walls[0]).min(walls[1]);
        TurnLimit { theta: self.theta, ..TurnLimit::free(self.s_mm, nearest).within(walls, keep, margin) }
    }
}

/// A stretch of the schedule, place by place.
pub(super) struct TurningFit(Vec<TurnLimit>);

impl TurningFit {
    /// The stretch of some locations. `joined`: whether the path goes on before and after with the
    /// schedule's own angles.
    pub fn new(
        (path, channel, schedule): (&Toolpath, &Channel, &Schedule),
        range: Range<usize>,
        near: &Near,
        joined: [bool; 2],
        options: &SmoothOptions,
    ) -> TurningFit {
        let free = |k: usize| TurnLimit::free(path.locations[k].s_mm, schedule.theta[k]);
        let own = TurningFit(range.clone().map(free).collect());
        let mut seen: Vec<(TurnLimit, [f64; 2])> = Vec::new();
        for wall in near.walls {
            let k = own.0.partition_point(|p| p.s_mm < wall.s_mm);
            let is_between = k > 0 && own.0.get(k).is_some_and(|p| p.s_mm > wall.s_mm);
            if is_between && seen.last().is_none_or(|(before, _)| before.s_mm < wall.s_mm) {
                let place = TurnLimit::free(wall.s_mm, own.at(wall.s_mm));
                seen.push((place, [wall.theta_min, wall.theta_max]));
            }
        }
        // About a place where the schedule is outside of the walls θ is as much farther from it.
        let keep = |s_mm: f64, k: usize| {
            let from = seen.partition_point(|(p, _)| p.s_mm < s_mm - AROUND_MM);
            let near_by = seen[from..].iter().take_while(|(p, _)| p.s_mm < s_mm + AROUND_MM);
            let outside = near_by.map(|(p, [least, greatest])| (least - p.theta).max(p.theta - greatest));
            options.turn_rad * near.shares[k].turn + outside.fold(0.0, f64::max)
        };
        let margin = options.margin_rad;
        let limit = |(j, place): (usize, &TurnLimit)| {
            let row = &channel.rows[range.start + j];
            place.within([row.hull_min, row.hull_max], keep(place.s_mm, range.start + j), margin)
        };
        let mut places: Vec<TurnLimit> = own.0.iter().enumerate().map(limit).collect();
        // The path goes on there, and θ is not to fall.
        if let Some(first) = places.first_mut().filter(|_| joined[0]) {
            first.lo = first.theta;
        }
        if let Some(last) = places.last_mut().filter(|_| joined[1]) {
            last.hi = last.theta;
        }
        places.extend(seen.iter().map(|(place, walls)| {
            let k = range.start + own.0.partition_point(|p| p.s_mm < place.s_mm);
            place.within_seen(*walls, keep(place.s_mm, k), margin)
        }));
        places.sort_by(|a, b| a.s_mm.total_cmp(&b.s_mm));
        TurningFit(places)
    }

    /// The schedule's angle, straight between places, rad.
    fn at(&self, s_mm: f64) -> f64 {
        let k = self.0.partition_point(|p| p.s_mm <= s_mm).clamp(1, self.0.len() - 1);
        let (a, b) = (&self.0[k - 1], &self.0[k]);
        let share = ((s_mm - a.s_mm) / (b.s_mm - a.s_mm)).clamp(0.0, 1.0);
        a.theta + (b.theta - a.theta) * share
    }

    /// Control values of θ with the least square of its third derivative, and that square with its
    /// bound, on breaks as far apart as those of the ball centre are on average, or nearer where
    /// that is too far.
    pub fn smooth(&self, breaks: &Breaks, options: &SmoothOptions) -> Result<Turned, Missed> {
        let all = breaks.all();
        let mean = (all[all.len() - 1] - all[0]) / breaks.spans() as f64;
        let mut last = Missed(Vec::new());
        for share in THINNED {
            let breaks = breaks.thinned(share * mean);
            match self.smooth_on(&breaks, options) {
                Ok((theta, square)) => return Ok(Turned { breaks, theta, square }),
                Err(missed) => last = missed,
            }
        }
        Err(last)
    }

    fn smooth_on(&self, breaks: &Breaks, options: &SmoothOptions) -> Result<(Vec<f64>, [f64; 2]), Missed> {
        let x: Vec<[f64; 1]> = breaks.greville().into_iter().map(|s| [self.at(s)]).collect();
        let [first, last] = [0, self.0.len() - 1].map(|k| (self.0[k].s_mm, self.0[k].theta));
        let rate = ((last.1 - first.1) / (last.0 - first.0)).max(1e-6);
        let of = |i: usize| {
            let Form { hessian, gradient, value } = form::third::<1, 6>(breaks, i, &x[i..]);
            let span =
                Span { hessian, gradient, rows: rising(breaks, i, &x, rate), strips: self.strips(breaks, i, &x) };
            (span, value)
        };
        let (spans, values): (Vec<_>, Vec<f64>) = parallel::map(0..breaks.spans(), of).into_iter().unzip();
        let value: f64 = values.iter().sum();
        let reach = 2.0 * CONDITION * options.turn_rad;
        let enough = Enough { gap: options.gap, nothing: 0.5 * NOTHING * NOTHING * (last.0 - first.0) };
        let Solution { x: found, objective, bound, .. } = bounded::solve(&spans, value, enough, reach)?;
        let theta = x.iter().zip(&found).map(|(a, b)| a[0] + b[0]).collect();
        Ok((theta, [value + objective, (value + bound).max(0.0)]))
    }

    /// Walls are straight from place to place. A span is cut at places where the walls, as seen
    /// from the curve, are not nearly even.
    fn strips(&self, breaks: &Breaks, i: usize, x: &[[f64; 1]]) -> Vec<Strip<1>> {
        let [a, b] = breaks.span(i);
        let from = self.0.partition_point(|p| p.s_mm <= a).saturating_sub(1);
        let to = (self.0.partition_point(|p| p.s_mm < b) + 1).min(self.0.len());
        let strip = |k: usize| {
            let (s0, s1) = (self.0[k].s_mm, self.0[k + 1].s_mm);
            let [p, q] = [s0.max(a), s1.min(b)];
            let map = breaks.ordinates(i, [p, q]);
            let ordinates = apply(&map, &x[i..]);
            let [from, to] = [k, k + 1].map(|k| [self.0[k].lo, self.0[k].hi]);
            let wall = |side: usize, j: usize| {
                let share = (p + (q - p) * j as f64 / (ORDER - 1) as f64 - s0) / (s1 - s0);
                from[side] + (to[side] - from[side]) * share - ordinates[j][0]
            };
            let [lo, hi] = [0, 1].map(|side| std::array::from_fn(|j| wall(side, j)));
            (p < q).then_some(Strip { map, direction: [1.0], lo, hi })
        };
        let cut: Vec<Strip<1>> = (from..to - 1).filter_map(strip).collect();
        let extreme = |of: &dyn Fn(&Strip<1>) -> [f64; ORDER], sign: f64| {
            cut.iter().flat_map(of).fold(f64::NEG_INFINITY, |m, v| m.max(sign * v)) * sign
        };
        let (lo, hi) = (extreme(&|s| s.lo, 1.0), extreme(&|s| s.hi, -1.0));
        let (least, greatest) = (extreme(&|s| s.lo, -1.0), extreme(&|s| s.hi, 1.0));
        if (lo - least).max(greatest - hi) < EVEN * (hi - lo) {
            let map = breaks.ordinates(i, [a, b]);
            return vec![Strip { map, direction: [1.0], lo: [lo; ORDER], hi: [hi; ORDER] }];
        }
        cut
    }
}

/// Ordinates rise. In units of what θ rises by on average.
fn rising(breaks: &Breaks, i: usize, x: &[[f64; 1]], rate: f64) -> Vec<SumLimit<6>> {
    let [a, b] = breaks.span(i);
    let map = breaks.ordinates(i, [a, b]);
    let ordinates = apply(&map, &x[i..]);
    let unit = (ORDER - 1) as f64 / (rate * (b - a));
    let row = |j: usize| {
        let g = std::array::from_fn(|k| unit * (map[j + 1][k] - map[j][k]));
        SumLimit { g, lo: -unit * (ordinates[j + 1][0] - ordinates[j][0]), hi: f64::INFINITY }
    };
    (0..ORDER - 1).map(row).collect()
}
