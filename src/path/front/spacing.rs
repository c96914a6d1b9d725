//! Touches of a turn neither too close nor too far apart.

use super::node::Node;
use super::{FAR, Front};
use crate::path::curve::{self, LevelCurve};
use crate::path::level::Touch;

/// Touches nearer to one another than this share of the usual step are too many.
const CLOSE: f64 = 0.35;
/// Turn of the normal from touch to touch that asks for another, rad.
const BEND_RAD: f64 = 0.2;
/// Beside touches round an edge gaps grow by no more than this from one to the next.
const GROWS: f64 = 2.0;
/// Rounds of adding touches.
const MOST_ROUNDS: usize = 6;

impl Front<'_> {
    /// The same nodes, neither too close nor too far apart; ends stay.
    pub fn spaced(&self, nodes: Vec<Node>) -> Vec<Node> {
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

    /// Round edges touches are nearer to one another than elsewhere.
    fn is_graded(&self) -> bool {
        self.round_edges_mm < self.step_mm
    }

    fn bend_rad(&self) -> f64 {
        if self.is_graded() { 0.5 * BEND_RAD } else { BEND_RAD }
    }

    fn thinned(&self, nodes: Vec<Node>) -> Vec<Node> {
        let length = |a: &Node, b: &Node| (a.touch.centre - b.touch.centre).norm();
        // `before`: the gap before them, beside which theirs may be as short.
        let close = |a: &Node, b: &Node, before: Option<f64>| {
            let graded = before.map_or(self.step_mm, |gap| self.step_mm.min(gap.max(self.round_edges_mm)));
            // Half of what asks for one more between.
            let turns = a.touch.normal.angle(&b.touch.normal) > 0.5 * self.bend_rad();
            length(a, b) < CLOSE * if turns { self.round_edges_mm } else { graded }
        };
        let gap = |kept: &[Node]| match kept {
            [.., a, b] if self.is_graded() => Some(length(a, b)),
            _ => None,
        };
        let mut kept: Vec<Node> = Vec::with_capacity(nodes.len());
        let last = nodes.last().copied();
        for node in &nodes[..nodes.len().saturating_sub(1)] {
            if kept.last().is_none_or(|k| !close(k, node, gap(&kept))) {
                kept.push(*node);
            }
        }
        if let Some(end) = last {
            while kept.len() > 2 && kept.last().is_some_and(|k| close(k, &end, None)) {
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
            LevelCurve { level: self.across.level, touches: &touches, tangents: curve::tangents(None, &touches, None) };
        let mut out = Vec::with_capacity(nodes.len() + 8);
        let mut added = false;
        let gaps: Vec<f64> = nodes.windows(2).map(|w| (w[1].touch.centre - w[0].touch.centre).norm()).collect();
        let beside = |i: usize| {
            let of = |k: Option<usize>| k.and_then(|k| gaps.get(k)).copied().unwrap_or(f64::INFINITY);
            of(i.checked_sub(1)).min(of(Some(i + 1))).max(self.round_edges_mm)
        };
        for (i, w) in nodes.windows(2).enumerate() {
            out.push(w[0]);
            let length = (w[1].touch.centre - w[0].touch.centre).norm();
            let bends = length > 2.0 * CLOSE * self.round_edges_mm
                && w[0].touch.normal.angle(&w[1].touch.normal) > self.bend_rad();
            let grows = self.is_graded() && length > GROWS * beside(i);
            if !(bends || grows || length > FAR * self.step_mm) {
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
}
