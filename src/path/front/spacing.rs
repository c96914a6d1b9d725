//! Touches of a turn neither too close nor too far apart.

use super::node::Node;
use super::{FAR, Front};
use crate::path::curve::{self, LevelCurve};
use crate::path::level::Touch;

/// Touches nearer to one another than this share of the usual step are too many.
const CLOSE: f64 = 0.35;
/// Turn of the normal from touch to touch that asks for another, rad.
const BEND_RAD: f64 = 0.2;
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
            LevelCurve { level: self.across.level, touches: &touches, tangents: curve::tangents(None, &touches, None) };
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
}
