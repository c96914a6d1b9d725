//! Folds: stretches of neighbours that run backwards or beyond where others of the turn have cut.

use super::fineness::Fineness;
use super::node::Node;
use super::overrun::Overrun;
use super::{Front, Neighbours};
use crate::geometry::{Point, Vector};
use crate::path::bounds::Stop;

/// A neighbour nearer to any place of the turn than this share of its way is beyond a crossing; ...
const OVERRUN: f64 = 0.8;
/// ... where corners are followed, in which another side is nearer by right.
const OVERRUN_CORNERS: f64 = 0.96;

/// Cosine between the ways to a node and on from it under which a turn has a cusp there.
const CUSP: f64 = -0.5;

/// A turn without the nodes at which it goes back the way it came: where two sides of the turn
/// before it run into one another, what is left of one may lie within what the other leaves.
pub fn without_cusps(nodes: Vec<Node>) -> Vec<Node> {
    let is_cusp = |[a, b, c]: [&Node; 3]| {
        let (to, on) = (b.touch.centre - a.touch.centre, c.touch.centre - b.touch.centre);
        to.dot(&on) < CUSP * to.norm() * on.norm()
    };
    let mut kept: Vec<Node> = Vec::with_capacity(nodes.len());
    for node in nodes {
        while matches!(&kept[..], [.., a, b] if is_cusp([a, b, &node])) {
            kept.pop();
        }
        kept.push(node);
    }
    kept
}

/// The neighbours of a turn with which the next turn goes on.
pub struct Unfolded {
    /// They, each with the number of the node that it is the neighbour of.
    pub kept: Vec<(usize, Node)>,
    /// The last node of the turn that stays: a fold over the place where one turn becomes the next
    /// takes nodes from both.
    pub end: usize,
    /// The turn, with what lies before it and after it.
    pub chain: Overrun,
}

impl Front<'_> {
    /// The neighbours of `turn` without those that were not found and with folds cut away from both
    /// sides; `before` is what lies before its first node, and `along` are its directions. `Err`:
    /// where the ball could not go on for a stretch.
    pub fn unfolded(
        &self,
        before: &[Node],
        turn: &[Node],
        along: &[Vector],
        next: &Neighbours,
    ) -> Result<Unfolded, Point> {
        // Where the turn bends to and fro, only the direction halfway between the two says which
        // way it goes on.
        let behind = |a: (usize, &Node), b: (usize, &Node)| {
            let step = b.1.touch.centre - a.1.touch.centre;
            let onward = along[a.0] + along[b.0];
            step.dot(&onward) <= 0.1 * step.norm() * onward.norm()
        };
        let overruns = |chain: &Overrun, i: usize, node: &Node| {
            let way = node.touch.centre - turn[i].touch.centre;
            // Cutters with a corner have their neighbours aslant across the turn, and so have
            // places that are sought by their contacts.
            let is_aslant = self.across.level.inclined.is_some() || self.is_first_order();
            self.overruns(chain, i, node, &if is_aslant { way.cross(&along[i]) } else { way })
        };
        let mut end = turn.len() - 1;
        let mut kept: Vec<(usize, Node)> = Vec::new();
        let mut chain = Overrun::of(before, turn, std::iter::empty());
        let late_mm = chain.length_mm() - self.look_mm();
        let mut is_late = false;
        for i in 1..next.len() {
            if i > end {
                break;
            }
            if !is_late && chain.at_mm(i) > late_mm {
                // The turn goes on with the first of the new nodes.
                is_late = true;
                chain = Overrun::of(before, turn, kept.iter().map(|k| k.1));
            }
            let reached = next[i].map(|node| self.beyond_corner(&chain, i, node));
            let Some(node) = reached.filter(|node| !overruns(&chain, i, node)) else { continue };
            if !behind(kept.last().map_or((end, &turn[end]), |k| (k.0, &k.1)), (i, &node)) {
                kept.push((i, node));
            } else if i == end {
                while kept.last().is_some_and(|(k, last)| behind((*k, last), (end, &node))) {
                    kept.pop();
                }
                kept.push((end, node));
            } else if kept.pop().is_none() && 2 * end > turn.len() {
                end -= 1;
            }
        }
        match self.lost(turn, next, &kept, end) {
            Some(at) => Err(at),
            None => Ok(Unfolded { kept, end, chain }),
        }
    }

    /// Whether a neighbour of node `i` of a turn, `way` across from it, is beyond a crossing.
    pub fn overruns(&self, chain: &Overrun, i: usize, node: &Node, way: &Vector) -> bool {
        let least = if self.follows_corners() { OVERRUN_CORNERS } else { OVERRUN };
        node.stop.is_none() && chain.is_nearer(&node.touch.centre, i, least * way.norm())
    }

    /// So wide a stretch without a neighbour is passed over, mm.
    fn widest_mm(&self) -> f64 {
        Fineness::of(self.across.level).widest * (2.0 * self.flat_mm + 3.0 * self.step_mm)
    }

    /// Where a stretch of a turn up to the node `end` has no neighbours and is too wide to be
    /// passed over.
    pub fn lost(&self, turn: &[Node], next: &Neighbours, kept: &[(usize, Node)], end: usize) -> Option<Point> {
        let centre = |i: usize| turn[i].touch.centre;
        let mut from = 0;
        for to in kept.iter().map(|k| k.0).chain([end]) {
            let not_found = (from + 1..=to).find(|i| next[*i].is_none());
            if let Some(i) = not_found.filter(|_| (centre(to) - centre(from)).norm() > self.widest_mm()) {
                return Some(centre(i));
            }
            from = to;
        }
        kept.is_empty().then(|| centre(end))
    }

    /// Leaves out short stretches of neighbours that a wall or an edge stops, between others that
    /// go on: one touch that stays behind while all round it goes on would draw a tongue of
    /// crossing ways behind it.
    pub fn leave_out_burrs(&self, next: &mut Neighbours) {
        let stopped = |n: &Option<Node>| n.is_some_and(|n| n.stop.is_some_and(|s| s != Stop::Height));
        let free = |n: &Option<Node>| n.filter(|n| n.stop.is_none()).map(|n| n.touch.centre);
        let mut from = 0;
        while let Some(first) = (from..next.len()).find(|i| stopped(&next[*i])) {
            let after = (first..next.len()).find(|i| !stopped(&next[*i])).unwrap_or(next.len());
            let sides = first.checked_sub(1).and_then(|i| free(&next[i])).zip(next.get(after).and_then(free));
            if sides.is_some_and(|(a, b)| (b - a).norm() <= self.widest_mm()) {
                next[first..after].fill(None);
            }
            from = after;
        }
    }
}
