//! Ways across over facets, evened out along a turn.

use super::laying::TurnCourse;
use super::neighbour::Heading;
use super::node::{LEAST_SHARE, Node, arc_lengths};
use super::{Front, Neighbours};
use crate::parallel;

/// Width of the bell over which ways over facets are evened out, in stepovers on flat ground.
const EVEN_WIDTH: f64 = 0.25;
/// Standard deviations that an evened way stays under the mean of those round it.
const EVEN_CAUTION: f64 = 1.0;
/// Caution that is not needed: so much longer a way makes the ridge higher by not quite a
/// hundredth.
const FREE: f64 = 4e-3;

impl Front<'_> {
    /// Ways over facets scatter: each becomes the mean of those round it, weighted by a bell, less
    /// some standard deviations, so that few ridges are higher than asked for. The end of the turn
    /// and its beginning, a stepover apart, count as neighbours: with the one's mean only from
    /// before and the other's only from after, a step would grow there.
    pub fn even_ways(&self, turn: &[Node], course: &TurnCourse, next: Neighbours) -> Neighbours {
        let TurnCourse { along, round, shares } = course;
        let n = turn.len() - 1;
        let s_mm = arc_lengths(turn);
        let ways: Vec<Option<f64>> = (0..=n)
            .map(|i| {
                next[i]
                    .filter(|x| i > 0 && x.stop.is_none() && shares[i] >= LEAST_SHARE)
                    .map(|x| x.way_mm.max(1e-9).ln())
            })
            .collect();
        let width_mm = EVEN_WIDTH * self.flat_mm;
        let reach = 2.5 * width_mm;
        let mean = |i: usize| {
            let (mut sum, mut squares, mut weight) = (0.0, 0.0, 0.0);
            let mut add = |k: usize, s: f64| {
                let bell = (-(s / width_mm).powi(2)).exp();
                if let Some(w) = ways[k] {
                    sum += bell * w;
                    squares += bell * w * w;
                    weight += bell;
                }
            };
            let whole = s_mm[n];
            let ahead = |k: usize| if k > i { s_mm[k] - s_mm[i] } else { s_mm[k] + whole - s_mm[i] };
            let behind = |k: usize| whole - ahead(k);
            add(i, 0.0);
            (i + 1..=n).chain(1..i).take_while(|k| ahead(*k) < reach).for_each(|k| add(k, ahead(k)));
            (1..i).rev().chain((i + 1..=n).rev()).take_while(|k| behind(*k) < reach).for_each(|k| add(k, behind(k)));
            let scatter = || (squares / weight - (sum / weight).powi(2)).max(0.0).sqrt();
            (weight > 0.0).then(|| (sum / weight - (EVEN_CAUTION * scatter() - FREE).max(0.0)).exp())
        };
        parallel::map(0..=n, |i| {
            let Some(node) = next[i].filter(|x| i > 0 && x.stop.is_none() && shares[i] >= LEAST_SHARE) else {
                return next[i];
            };
            let from = Heading { touch: turn[i].touch, along: along[i] };
            let Some(found) = mean(i).and_then(|w| self.across.reach(&from, round, w * shares[i])) else {
                return Some(node);
            };
            let way_mm = if found.stop.is_some() { node.way_mm } else { found.way_mm / shares[i] };
            Some(Node { touch: found.touch, way_mm, stop: found.stop })
        })
    }
}
