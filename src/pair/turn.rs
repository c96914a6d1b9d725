//! Angles along a row whose table turns while both tools cut: as slowly as can be.
//!
//! **In** what is free for both tools at each place of a row, and from each place to the next the
//! way over which the table turns. **Out** angles whose steepest slope is [`NEAR`] times the least
//! that there is, at most, and among those the ones that bend least.
//!
//! **Method** With a greatest slope `L` the angles that can be reached at a place are those within
//! `L · way` of what can be reached at the place before, as far as they are free. So whether a
//! slope is enough is decided from place to place, over all arcs at once, and the least is closed
//! in on in halves: the greatest that was not enough is a bound that no angles fall below. Within a
//! chain of arcs the ends of what can be reached from both sides have slopes of `L` at most, and so
//! has their middle. From there the sum of the squared bends is made least under the same limits
//! ([`crate::numerics::stages`]).
//!
//! From a place to the next the table turns from an arc into one that overlaps it. Both are free
//! there, so all angles between are free for one or the other place.

use std::f64::consts::TAU;
use std::ops::Range;

use super::FreeAngles;
use crate::numerics::stages::{self, Inequality, Options, Stage};

/// The steepest slope may be so many times the least.
pub const NEAR: f64 = 1.015;
/// Halves in which the least slope is closed in on.
const HALVES: usize = 60;
/// Slopes that are as near as this, as a share, are the same.
const SAME: f64 = 1e-9;
/// Limits may be missed by this share by rounding.
const ROUNDING: f64 = 1e-7;
/// Ways are taken as so long at least where bends are weighed, as a share of their mean.
const SHORT: f64 = 1e-3;

/// What a row is to the table.
#[derive(Clone, Copy, Debug)]
pub struct TurningRow<'a> {
    /// What is free for both tools at each place.
    pub common: &'a [FreeAngles],
    /// The way from each place to the next, mm: the slope is what the table turns over it.
    pub way_mm: &'a [f64],
    /// What the table may turn from each place to the next at most, rad.
    pub most_rad: &'a [f64],
    /// Room to the ends of what is free, rad; where that is narrower, its middle is taken.
    pub margin_rad: f64,
}

/// Angles along places of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct Turned {
    /// The places.
    pub places: Range<usize>,
    /// The angle at each, rad.
    pub theta_rad: Vec<f64>,
    /// No angles with that margin are less steep at their steepest place, rad/mm.
    pub least_slope: f64,
}

/// What is made least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Least {
    /// Changes of slope, each over the way that it happens on.
    Bends,
    /// Slopes, as they are.
    Slopes,
}

/// An arc that is free at a place, unrolled, and which of its angles can be reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    arc: [f64; 2],
    reach: [f64; 2],
}

impl TurningRow<'_> {
    /// Angles in as few stretches as can be; a stretch begins at the last place of the one before.
    ///
    /// # Errors
    /// A place without a free angle, or one to which the table cannot turn from the place before.
    pub fn turned(&self) -> Result<Vec<Turned>, usize> {
        let (mut out, mut from) = (Vec::new(), 0);
        loop {
            let layers = self.reached(from, f64::INFINITY);
            let places = from..from + layers.len();
            if places.end == self.common.len() {
                out.push(self.least(places));
                return Ok(out);
            }
            if places.len() < 2 {
                return Err(places.end);
            }
            from = places.end - 1;
            out.push(self.least(places));
        }
    }

    /// What the table may turn behind a place with a greatest slope, rad.
    fn step_rad(&self, place: usize, slope: f64) -> f64 {
        // Without a way nothing is allowed by any slope; with none asked for, all is.
        match slope == f64::INFINITY {
            true => self.most_rad[place],
            false => (slope * self.way_mm[place]).min(self.most_rad[place]),
        }
    }

    /// What can be reached from a place on, as far as anything can.
    fn reached(&self, from: usize, slope: f64) -> Vec<Vec<Node>> {
        let mut layers: Vec<Vec<Node>> = Vec::new();
        for place in from..self.common.len() {
            let arcs = self.common[place].joined();
            let layer = match layers.last() {
                None => arcs.into_iter().map(|arc| Node { arc, reach: shared([-TAU, TAU], self.inset(arc)) }).collect(),
                Some(before) => {
                    let step = self.step_rad(place - 1, slope);
                    joined(before.iter().flat_map(|node| self.next(node, &arcs, step)).collect())
                }
            };
            if layer.is_empty() {
                break;
            }
            layers.push(layer);
        }
        layers
    }

    /// What can be reached from a node, in the arcs of the next place.
    fn next(&self, node: &Node, arcs: &[[f64; 2]], step: f64) -> Vec<Node> {
        let wide = [node.reach[0] - step, node.reach[1] + step];
        let mut out = Vec::new();
        for arc in arcs {
            let turns = match arc[0].is_finite() {
                true => ((wide[0] - arc[1]) / TAU).ceil() as i64..=((wide[1] - arc[0]) / TAU).floor() as i64,
                false => 0..=0,
            };
            for turn in turns {
                let arc = arc.map(|end| end + turn as f64 * TAU);
                let reach = shared(wide, self.inset(arc));
                if is_some(shared(arc, node.arc)) && is_some(reach) {
                    out.push(Node { arc, reach });
                }
            }
        }
        out
    }

    /// An arc without the margin.
    fn inset(&self, [from, to]: [f64; 2]) -> [f64; 2] {
        if !from.is_finite() {
            return [from, to];
        }
        let margin = self.margin_rad.min(0.5 * (to - from));
        [from + margin, to - margin]
    }

    /// What no angles fall below in their steepest slope, over all of its stretches, rad/mm.
    pub(super) fn least_slope(&self) -> f64 {
        self.turned().map_or(0.0, |all| all.iter().map(|t| t.least_slope).fold(0.0, f64::max))
    }

    /// The least steep angles of places that can be passed.
    fn least(&self, places: Range<usize>) -> Turned {
        let passes = |slope: f64| self.reached_to(&places, slope).is_some();
        let moves = places.start..places.end - 1;
        let all = moves.clone().filter(|k| self.way_mm[*k] > 0.0);
        let (mut too_flat, mut enough) =
            (0.0, all.map(|k| self.most_rad[k] / self.way_mm[k]).fold(f64::MIN_POSITIVE, f64::max));
        if passes(0.0) {
            enough = 0.0;
        }
        for _ in 0..HALVES {
            if enough - too_flat <= SAME * enough {
                break;
            }
            let middle = 0.5 * (too_flat + enough);
            if passes(middle) { enough = middle } else { too_flat = middle }
        }
        // A place without a way may ask for a turn that no slope has.
        let near = [NEAR * enough, f64::INFINITY].into_iter();
        let chain = near.map(|slope| (slope, self.reached_to(&places, slope))).find_map(|(s, l)| Some((s, l?)));
        let Some((slope, layers)) = chain else {
            return Turned { places, theta_rad: Vec::new(), least_slope: too_flat };
        };
        let steps: Vec<f64> = moves.clone().map(|k| self.step_rad(k, slope)).collect();
        let walls = chain_of(&layers, &steps);
        let theta_rad = self.least_of(Least::Bends, &walls, &steps, &self.way_mm[moves.clone()]);
        Turned { places, theta_rad, least_slope: too_flat }
    }

    pub(super) fn reached_to(&self, places: &Range<usize>, slope: f64) -> Option<Vec<Vec<Node>>> {
        let row = TurningRow {
            common: &self.common[..places.end],
            way_mm: &self.way_mm[..places.end - 1],
            most_rad: &self.most_rad[..places.end - 1],
            ..*self
        };
        Some(row.reached(places.start, slope)).filter(|layers| layers.len() == places.len())
    }

    /// Between walls, with steps no greater than these, the angles with the least sum of squares.
    pub(super) fn least_of(&self, least: Least, walls: &[[f64; 2]], steps: &[f64], ways: &[f64]) -> Vec<f64> {
        let middle: Vec<f64> = walls.iter().map(|[lo, hi]| 0.5 * (lo + hi)).collect();
        // Angles in units of the mean step, ways in units of their mean.
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len().max(1) as f64;
        let (unit, way_unit) = (mean(steps), mean(ways));
        if walls.len() < 3 || !(unit > 0.0 && way_unit > 0.0 && walls.iter().flatten().all(|v| v.is_finite())) {
            return middle;
        }
        let way = |k: usize| (ways[k] / way_unit).max(SHORT);
        let n = walls.len();
        let mut all: Vec<Stage<2, 3>> = Vec::with_capacity(n);
        let mut start: Vec<[f64; 3]> = Vec::with_capacity(n);
        let mut before = 0.0;
        for k in 0..n {
            let at = (middle[k] - middle[0]) / unit;
            let mut stage = Stage::<2, 3>::default();
            let own = if k + 1 < n { way(k) } else { 1.0 };
            // State: the angle, the slope of the move before. Control: what the slope changes by.
            stage.dynamics = [[1.0, own, own], [0.0, 1.0, 1.0]];
            let over = if k == 0 || k + 1 == n { 1.0 } else { 0.5 * (way(k - 1) + own) };
            match least {
                // The first change is the slope itself, and the last is that of no move.
                Least::Bends => stage.hessian[2][2] = if k == 0 { 1e-6 } else { 1.0 / over },
                Least::Slopes if k + 1 == n => stage.hessian[2][2] = 1.0,
                Least::Slopes => [(1, 1), (1, 2), (2, 1), (2, 2)].iter().for_each(|(a, b)| stage.hessian[*a][*b] = 1.0),
            }
            let [lo, hi] = walls[k].map(|wall| (wall - middle[0]) / unit);
            stage.rows.push(Inequality { g: [1.0, 0.0, 0.0], most: hi });
            stage.rows.push(Inequality { g: [-1.0, 0.0, 0.0], most: -lo });
            let mut change = 0.0;
            if k + 1 < n {
                let most = steps[k] / unit / own;
                stage.rows.push(Inequality { g: [0.0, 1.0, 1.0], most });
                stage.rows.push(Inequality { g: [0.0, -1.0, -1.0], most });
                change = (middle[k + 1] - middle[k]) / unit / own - before;
            }
            start.push([at, before, change]);
            before += change;
            all.push(stage);
        }
        let mut options = Options { tolerance: 1e-9, excess: ROUNDING, ..Options::default() };
        options.fixed[1] = true;
        let found = stages::solve(&mut all, &start, &(), &options);
        let Some(found) = found.filter(|f| f.excess <= ROUNDING) else { return middle };
        // What is missed by rounding is put right from the walls.
        let theta = found.v.iter().zip(walls).map(|(v, [lo, hi])| (middle[0] + v[0] * unit).clamp(*lo, *hi));
        let theta: Vec<f64> = theta.collect();
        let keeps = theta.windows(2).zip(steps).all(|(w, step)| (w[1] - w[0]).abs() <= step * (1.0 + 1e-4));
        if keeps { theta } else { middle }
    }
}

/// One chain of arcs through all layers: at each place the angles from which both ends can be
/// reached by the steps.
pub(super) fn chain_of(layers: &[Vec<Node>], steps: &[f64]) -> Vec<[f64; 2]> {
    let width = |[lo, hi]: [f64; 2]| hi - lo;
    let mut chain: Vec<Node> = Vec::with_capacity(layers.len());
    for (k, layer) in layers.iter().enumerate().rev() {
        let back = layer.iter().filter_map(|node| {
            let Some(next) = chain.last() else { return Some(*node) };
            let reach = shared(node.reach, [next.reach[0] - steps[k], next.reach[1] + steps[k]]);
            (is_some(reach) && is_some(shared(node.arc, next.arc))).then_some(Node { reach, ..*node })
        });
        chain.extend(back.max_by(|a, b| width(a.reach).total_cmp(&width(b.reach))));
    }
    chain.reverse();
    let mut walls: Vec<[f64; 2]> = Vec::with_capacity(chain.len());
    for (k, node) in chain.iter().enumerate() {
        let from = k.checked_sub(1).map_or(node.reach, |before| {
            let [lo, hi] = walls[before];
            shared(node.reach, [lo - steps[before], hi + steps[before]])
        });
        walls.push(from);
    }
    walls
}

/// Nodes of the same arc whose angles meet are one.
fn joined(mut nodes: Vec<Node>) -> Vec<Node> {
    nodes.sort_by(|a, b| a.arc[0].total_cmp(&b.arc[0]).then(a.reach[0].total_cmp(&b.reach[0])));
    nodes.dedup_by(|next, last| {
        let meets = next.arc == last.arc && next.reach[0] <= last.reach[1];
        if meets {
            last.reach[1] = last.reach[1].max(next.reach[1]);
        }
        meets
    });
    nodes
}

fn shared(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].min(b[1])]
}

fn is_some([from, to]: [f64; 2]) -> bool {
    from <= to
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use proptest::prelude::*;

    use super::*;

    /// The steepest slope of angles, rad/mm.
    fn steepest(found: &Turned, way_mm: &[f64]) -> f64 {
        let slopes = found.theta_rad.windows(2).zip(&way_mm[found.places.start..]);
        slopes.map(|(w, way)| (w[1] - w[0]).abs() / way).fold(0.0, f64::max)
    }

    fn tube(walls: &[[f64; 2]]) -> Vec<FreeAngles> {
        walls.iter().map(|w| FreeAngles::of([*w])).collect()
    }

    proptest! {
        /// Between any two places the walls ask for a slope; the greatest is what there is at least
        /// (Lipschitz extension), and the angles that are found are hardly steeper.
        #[test]
        fn the_steepest_slope_is_the_least(
            places in prop::collection::vec((0.05f64..1.0, 1.0f64..2.0, 0.02f64..0.4), 3..60), around in 0.0f64..7.0
        ) {
            let way_mm: Vec<f64> = places.iter().skip(1).map(|p| p.0).collect();
            let walls: Vec<[f64; 2]> =
                places.iter().map(|(_, low, width)| [around + low, around + low + width]).collect();
            let most_rad = vec![3.0; way_mm.len()];
            let common = tube(&walls);
            let row = TurningRow { common: &common, way_mm: &way_mm, most_rad: &most_rad, margin_rad: 0.0 };
            let all = row.turned();
            // Arcs of two neighbours that do not meet are no way.
            let meet = |w: &[[f64; 2]]| w[0][0].max(w[1][0]) <= w[0][1].min(w[1][1]);
            prop_assert_eq!(all.is_ok(), walls.windows(2).all(meet));
            let Ok(all) = all else { return Ok(()) };
            prop_assert_eq!(all.len(), 1);
            let s: Vec<f64> = std::iter::once(0.0).chain(way_mm.iter().scan(0.0, |s, w| { *s += w; Some(*s) })).collect();
            let mut asked = 0f64;
            for i in 0..walls.len() {
                for j in 0..i {
                    let needed = (walls[i][0] - walls[j][1]).max(walls[j][0] - walls[i][1]);
                    asked = asked.max(needed / (s[i] - s[j]));
                }
            }
            let found = &all[0];
            let slope = steepest(found, &way_mm);
            prop_assert!(found.least_slope <= asked + 1e-12 && found.least_slope >= asked * (1.0 - 1e-6), "{} {asked}", found.least_slope);
            prop_assert!(slope <= NEAR * (1.0 + 1e-4) * asked + 1e-12, "{slope} {asked}");
            prop_assert!(found.theta_rad.iter().zip(&common).all(|(theta, free)| free.margin(*theta) >= -1e-9));
        }
    }

    /// One arc ends amid the row, the other goes on: the way is through the one that both have.
    #[test]
    fn arcs_that_lead_nowhere_are_left() {
        let common: Vec<FreeAngles> = (0..20)
            .map(|k| match k {
                0..=9 => FreeAngles::of([[0.0, 2.0], [3.0, 3.2]]),
                _ => FreeAngles::of([[3.1 + 0.02 * f64::from(k - 10), 3.6]]),
            })
            .collect();
        let row = TurningRow { common: &common, way_mm: &[1.0; 19], most_rad: &[0.5; 19], margin_rad: 0.01 };
        let all = row.turned().unwrap();
        assert_eq!(all.len(), 1);
        let theta = &all[0].theta_rad;
        assert!(theta.iter().zip(&common).all(|(theta, free)| free.margin(*theta) >= 0.01 - 1e-9), "{theta:?}");
        let slope = steepest(&all[0], &[1.0; 19]);
        assert!(slope > 0.0 && slope <= NEAR * 1.001 * all[0].least_slope, "{:?}", all[0]);
    }

    #[test]
    fn a_turn_that_is_too_great_for_one_move_parts_the_row() {
        // Both arcs meet, but their insides are 0.4 apart.
        let common: Vec<FreeAngles> =
            (0..10).map(|k| FreeAngles::of([if k < 5 { [0.0, 1.0] } else { [0.99, 2.0] }])).collect();
        let row =
            |most: &'static [f64]| TurningRow { common: &common, way_mm: &[1.0; 9], most_rad: most, margin_rad: 0.2 };
        let places = |all: Vec<Turned>| all.into_iter().map(|t| t.places).collect::<Vec<_>>();
        assert_eq!(row(&[0.4; 9]).turned().map(places), Ok(std::iter::once(0..10).collect()));
        assert_eq!(row(&[0.3; 9]).turned().map(places), Err(5));
        // An angle that all places have, and one more move that may turn: parted where it must be.
        let moving: Vec<FreeAngles> =
            (0..9).map(|k| FreeAngles::of([[0.3 * f64::from(k), 0.3 * f64::from(k) + 0.5]])).collect();
        let most = [0.02, 0.02, 0.02, 0.02, 0.3, 0.3, 0.3, 0.3];
        let found =
            TurningRow { common: &moving, way_mm: &[1.0; 8], most_rad: &most, margin_rad: 0.0 }.turned().unwrap();
        assert_eq!(places(found), [0..2, 1..3, 2..4, 3..9]);
        let none = [FreeAngles::all(), FreeAngles::default()];
        assert_eq!(TurningRow { common: &none, way_mm: &[1.0], most_rad: &[1.0], margin_rad: 0.0 }.turned(), Err(1));
        // All is free: any angle does, and the table stands.
        let all = [FreeAngles::all(), FreeAngles::all(), FreeAngles::all()];
        let found =
            TurningRow { common: &all, way_mm: &[1.0; 2], most_rad: &[1.0; 2], margin_rad: 0.1 }.turned().unwrap();
        assert!(steepest(&found[0], &[1.0; 2]) < 1e-12 && found[0].least_slope == 0.0, "{found:?}");
    }
}
