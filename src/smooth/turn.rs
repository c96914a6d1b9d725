//! θ of the curve: between the walls of the channel, never falling. Its breaks are some of those of
//! the ball centre: where these are near to one another, numbers of one size in floating point
//! would not show third derivatives of θ.

use super::form::{self, Form};
use super::{Share, SmoothOptions};
use crate::artifact::channel::ChannelRow;
use crate::artifact::toolpath::CutterLocation;
use crate::numerics::bounded::{self, Enough, Missed, Solution, Span, Strip, SumLimit};
use crate::numerics::quintic::{Breaks, CONDITION, ORDER, apply};
use crate::parallel;

/// A span is cut where walls as seen from the curve differ by more than this share of the way
/// between them.
const EVEN: f64 = 0.05;
/// A third derivative that is nothing, rad/mm³: at 100 mm/s a jerk of 6°/s³.
const NOTHING: f64 = 1e-7;

/// A stretch of the schedule, one entry per location.
pub(super) struct TurningFit<'a> {
    pub locations: &'a [CutterLocation],
    /// The channel.
    pub walls: &'a [ChannelRow],
    /// The schedule's angles, rad.
    pub theta: &'a [f64],
    /// Shares of the angle that θ may be from the schedule.
    pub shares: &'a [Share],
    /// Whether the path goes on before and after with the schedule's own angles.
    pub joined: [bool; 2],
}

impl TurningFit<'_> {
    /// The schedule's angle, straight between locations, rad.
    fn at(&self, s_mm: f64) -> f64 {
        let k = self.locations.partition_point(|l| l.s_mm <= s_mm).clamp(1, self.locations.len() - 1);
        let (a, b) = (self.locations[k - 1].s_mm, self.locations[k].s_mm);
        let share = ((s_mm - a) / (b - a)).clamp(0.0, 1.0);
        self.theta[k - 1] + (self.theta[k] - self.theta[k - 1]) * share
    }

    /// Least and greatest angle at a location, rad: no nearer to a wall than the margin, or than
    /// the schedule itself where that is nearer.
    fn walls(&self, k: usize, options: &SmoothOptions) -> [f64; 2] {
        let (wall, theta) = (&self.walls[k], self.theta[k]);
        let (keep, margin) = (options.turn_rad * self.shares[k].turn, options.margin_rad);
        let mut lo = (theta - keep).max(theta.min(wall.hull_min + margin));
        let mut hi = (theta + keep).min(theta.max(wall.hull_max - margin));
        // The path goes on there, and θ is not to fall.
        if k == 0 && self.joined[0] {
            lo = theta;
        }
        if k + 1 == self.theta.len() && self.joined[1] {
            hi = theta;
        }
        [lo, hi]
    }

    /// Control values of θ with the least square of its third derivative, and that square with its
    /// bound.
    pub fn smooth(&self, breaks: &Breaks, options: &SmoothOptions) -> Result<(Vec<f64>, [f64; 2]), Missed> {
        let x: Vec<[f64; 1]> = breaks.greville().into_iter().map(|s| [self.at(s)]).collect();
        let [first, last] = [0, self.theta.len() - 1].map(|k| (self.locations[k].s_mm, self.theta[k]));
        let rate = ((last.1 - first.1) / (last.0 - first.0)).max(1e-6);
        let of = |i: usize| {
            let Form { hessian, gradient, value } = form::third::<1, 6>(breaks, i, &x[i..]);
            let span = Span {
                hessian,
                gradient,
                rows: rising(breaks, i, &x, rate),
                strips: self.strips(breaks, i, &x, options),
            };
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

    /// Walls are straight from location to location. A span is cut at locations where the walls, as
    /// seen from the curve, are not nearly even.
    fn strips(&self, breaks: &Breaks, i: usize, x: &[[f64; 1]], options: &SmoothOptions) -> Vec<Strip<1>> {
        let [a, b] = breaks.span(i);
        let from = self.locations.partition_point(|l| l.s_mm <= a).saturating_sub(1);
        let to = (self.locations.partition_point(|l| l.s_mm < b) + 1).min(self.locations.len());
        let strip = |k: usize| {
            let (s0, s1) = (self.locations[k].s_mm, self.locations[k + 1].s_mm);
            let [p, q] = [s0.max(a), s1.min(b)];
            let map = breaks.ordinates(i, [p, q]);
            let ordinates = apply(&map, &x[i..]);
            let [from, to] = [k, k + 1].map(|k| self.walls(k, options));
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
