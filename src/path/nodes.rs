//! Touches of a turn while it is laid: folds left out, touches added and taken away, ways over facets evened out.

use rayon::prelude::*;

use super::constant_scallop::{March, Node};
use super::curve::{self, Curve};
use super::level::Touch;
use super::neighbour::Place;
use crate::geometry::{Point, Vector};

/// Touches nearer to one another than this share of the usual step are too many.
const CLOSE: f64 = 0.35;
/// Touches farther from one another than this share of the usual step are too few.
const FAR: f64 = 1.5;
/// Turn of the normal from touch to touch that asks for another, rad.
const BEND_RAD: f64 = 0.2;
/// Standard deviations that the way over facets stays under its mean: one in fifty is then shorter by nature.
const CAUTION: f64 = 2.0;
/// Caution that is not needed: so much longer a way makes the ridge higher by not quite a hundredth.
const FREE: f64 = 4e-3;
/// Rounds of adding touches.
const MOST_ROUNDS: usize = 6;

impl March<'_> {
    /// What remains when nodes that were not found are left out and folds are cut away from both sides; ends stay. `Err`: where
    /// the ball could not go on for a stretch.
    pub(super) fn without_folds(
        &self,
        turn: &[Node],
        along: &[Vector],
        next: &[Option<Node>],
    ) -> Result<Vec<Node>, Point> {
        let n = turn.len() - 1;
        let (Some(first), Some(last)) = (next[0], next[n]) else { return Err(turn[n].touch.centre) };
        let behind = |a: &Node, b: &Node, along: &Vector| {
            let step = b.touch.centre - a.touch.centre;
            step.dot(along) <= 0.1 * step.norm()
        };
        let mut kept: Vec<(usize, Node)> = vec![(0, first)];
        for i in 1..n {
            let (Some(node), Some((_, previous))) = (&next[i], kept.last()) else { continue };
            if !behind(previous, node, &along[i]) {
                kept.push((i, *node));
            } else if kept.len() > 1 {
                kept.pop();
            }
        }
        while kept.len() > 1 && kept.last().is_some_and(|(_, k)| behind(k, &last, &along[n])) {
            kept.pop();
        }
        kept.push((n, last));
        let widest = 2.0 * self.flat_mm + 3.0 * self.step_mm;
        for w in kept.windows(2) {
            let lost = (w[0].0 + 1..w[1].0).find(|i| next[*i].is_none());
            if let Some(i) = lost
                && (turn[w[1].0].touch.centre - turn[w[0].0].touch.centre).norm() > widest
            {
                return Err(turn[i].touch.centre);
            }
        }
        Ok(kept.into_iter().map(|k| k.1).collect())
    }

    /// The same turn with its touches neither too close nor too far apart; ends stay.
    pub(super) fn tidy(&self, nodes: Vec<Node>) -> Vec<Node> {
        let mut nodes = self.thinned(nodes);
        for _ in 0..MOST_ROUNDS {
            let (more, added) = self.filled(&nodes);
            nodes = more;
            if !added {
                break;
            }
        }
        nodes
    }

    fn thinned(&self, nodes: Vec<Node>) -> Vec<Node> {
        let close = |a: &Node, b: &Node| (a.touch.centre - b.touch.centre).norm() < CLOSE * self.step_mm;
        let mut kept: Vec<Node> = Vec::with_capacity(nodes.len());
        let last = nodes.last().copied();
        for node in &nodes[..nodes.len().saturating_sub(1)] {
            if kept.last().is_none_or(|k| !close(k, node)) {
                kept.push(*node);
            }
        }
        if let Some(end) = last {
            while kept.len() > 2 && kept.last().is_some_and(|k| close(k, &end)) {
                kept.pop();
            }
            kept.push(end);
        }
        kept
    }

    /// One touch more in each gap that is too wide, and whether there was one.
    fn filled(&self, nodes: &[Node]) -> (Vec<Node>, bool) {
        let touches: Vec<Touch> = nodes.iter().map(|n| n.touch).collect();
        let curve =
            Curve { level: self.across.level, touches: &touches, tangents: curve::tangents(None, &touches, None) };
        let mut out = Vec::with_capacity(nodes.len() + 8);
        let mut added = false;
        for (i, w) in nodes.windows(2).enumerate() {
            out.push(w[0]);
            let length = (w[1].touch.centre - w[0].touch.centre).norm();
            let bends = w[0].touch.normal.angle(&w[1].touch.normal) > BEND_RAD && length > 2.0 * CLOSE * self.step_mm;
            if !(bends || length > FAR * self.step_mm) {
                continue;
            }
            if let Some(touch) = curve.between(i, 0.5) {
                let outside = !self.across.bounds.hold(&touch);
                let stop = if outside { w[0].stop.or(w[1].stop) } else { w[0].stop.and(w[1].stop) };
                out.push(Node { touch, way_mm: 0.5 * (w[0].way_mm + w[1].way_mm), stop });
                added = true;
            }
        }
        out.extend(nodes.last());
        (out, added)
    }

    /// Ways over facets scatter: each becomes the mean of those round it, weighted by a bell as wide as the stepover, less
    /// [`CAUTION`] standard deviations, so that few ridges are higher than asked for.
    pub(super) fn even_out(&self, turn: &[Node], along: &[Vector], next: Vec<Option<Node>>) -> Vec<Option<Node>> {
        let way = |i: usize| next[i].filter(|n| n.stop.is_none()).map(|n| n.way_mm.max(1e-9).ln());
        let ways: Vec<Option<f64>> = (0..next.len()).map(way).collect();
        let mean = |i: usize| {
            let (mut sum, mut squares, mut weight) = (0.0, 0.0, 0.0);
            let mut add = |k: usize, s: f64| {
                let bell = (-(s / self.flat_mm).powi(2)).exp();
                if let Some(w) = ways[k] {
                    sum += bell * w;
                    squares += bell * w * w;
                    weight += bell;
                }
            };
            let reach = 2.5 * self.flat_mm;
            let centre = |k: usize| turn[k].touch.centre;
            let off = |k: usize| (centre(k) - centre(i)).norm();
            add(i, 0.0);
            (i + 1..turn.len()).take_while(|k| off(*k) < reach).for_each(|k| add(k, off(k)));
            (0..i).rev().take_while(|k| off(*k) < reach).for_each(|k| add(k, off(k)));
            let scatter = || (squares / weight - (sum / weight).powi(2)).max(0.0).sqrt();
            (weight > 0.0).then(|| (sum / weight - (CAUTION * scatter() - FREE).max(0.0)).exp())
        };
        (0..next.len())
            .into_par_iter()
            .map(|i| {
                let Some(node) = next[i].filter(|n| i > 0 && n.stop.is_none()) else { return next[i] };
                let from = Place { touch: turn[i].touch, along: along[i] };
                let Some(found) = mean(i).and_then(|w| self.across.at_way(&from, w)) else { return Some(node) };
                let way_mm = if found.stop.is_some() { node.way_mm } else { found.way_mm };
                Some(Node { touch: found.touch, way_mm, stop: found.stop })
            })
            .collect()
    }
}
