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
        // `before`: the gap before them, beside which theirs may be as short.
        let close = |a: &Node, b: &Node, before: Option<f64>| {
            let length = gap_mm(a, b);
            if !self.is_graded() || length >= CLOSE * self.step_mm {
                return length < CLOSE * self.step_mm;
            }
            // Half of what asks for one more between.
            let turns = a.touch.normal.angle(&b.touch.normal) > 0.5 * self.bend_rad();
            let beside = before.filter(|_| !turns).map_or(f64::INFINITY, |gap| gap.max(self.round_edges_mm));
            let usual_mm = if turns { self.round_edges_mm } else { self.step_mm };
            length < CLOSE * usual_mm.min(beside)
        };
        let before = |kept: &[Node]| match kept {
            [.., a, b] => Some(gap_mm(a, b)),
            _ => None,
        };
        let mut kept: Vec<Node> = Vec::with_capacity(nodes.len());
        let last = nodes.last().copied();
        for node in &nodes[..nodes.len().saturating_sub(1)] {
            if kept.last().is_none_or(|k| !close(k, node, before(&kept))) {
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
        let gaps: Vec<f64> = nodes.windows(2).map(|w| gap_mm(&w[0], &w[1])).collect();
        let beside = |i: usize| {
            let of = |k: Option<usize>| k.and_then(|k| gaps.get(k)).copied().unwrap_or(f64::INFINITY);
            of(i.checked_sub(1)).min(of(Some(i + 1))).max(self.round_edges_mm)
        };
        for (i, (w, &length)) in nodes.windows(2).zip(&gaps).enumerate() {
            out.push(w[0]);
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

/// Way from a node's ball centre to the next's, mm.
fn gap_mm(a: &Node, b: &Node) -> f64 {
    (a.touch.centre - b.touch.centre).norm()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::along::Along;
    use crate::geometry::allowance::Allowed;
    use crate::geometry::{Point, Vector};
    use crate::path::bounds::Bounds;
    use crate::path::front::{Across, By};
    use crate::path::level::LevelSet;
    use crate::path::tests::turned;

    #[test]
    fn touches_are_near_round_edges_alone_and_gaps_grow_slowly() {
        // Round a square bar with sides of 141 mm: the ball rolls over its edges.
        let blade = turned(4, &[1.0, 200.0], |_, s, c| [100.0 * c, 100.0 * s]);
        let level = LevelSet {
            part: Allowed::new(&blade.part, 0.0),
            along: Along::BLADE,
            radius_mm: 4.0,
            inclined: None,
            rim: None,
            lowest_mm: f64::NEG_INFINITY,
        };
        let front = |step_mm: f64, round_edges_mm: f64| Front {
            across: Across { level: &level, bounds: Bounds::NONE, min_step_mm: 0.01 },
            scallop_mm: 0.01,
            flat_mm: step_mm,
            step_mm,
            round_edges_mm,
            round_mm: 600.0,
            back: 0.3,
            evens_ways: false,
            is_path: true,
            by: By::Ridges,
        };
        let on_side = |k: u32, u: f64| {
            let (s, c) = (std::f64::consts::FRAC_PI_4 * (2.0 * f64::from(k) + 1.0)).sin_cos();
            let (out, along) = (Vector::new(0.0, c, s), Vector::new(0.0, -s, c));
            let guess = Point::new(100.0, 0.0, 0.0) + out * (50f64.hypot(50.0) + 4.0) + along * u;
            Node { touch: level.touch(&guess, 1.0).unwrap(), way_mm: 8.0, stop: None }
        };
        let sides = (0..4).flat_map(|k| [-70.0, -35.0, 0.0, 35.0, 70.0].map(|u| on_side(k, u)));
        let coarse: Vec<Node> = sides.chain([on_side(0, -70.0)]).collect();
        let graded = front(8.0, 0.8);
        let nodes = graded.spaced(coarse.clone());
        let gaps: Vec<f64> = nodes.windows(2).map(|w| gap_mm(&w[0], &w[1])).collect();
        let most_rad = |gap: f64| if gap > 2.0 * CLOSE * 0.8 { 0.5 * BEND_RAD } else { f64::INFINITY };
        assert!(nodes.windows(2).zip(&gaps).all(|(w, g)| w[0].touch.normal.angle(&w[1].touch.normal) <= most_rad(*g)));
        assert!(gaps.iter().all(|g| *g <= FAR * 8.0), "{gaps:?}");
        let grow = |w: &[f64]| w[0].max(w[1]) / w[0].min(w[1]).max(0.8);
        assert!(gaps.windows(2).all(|w| grow(w) <= GROWS + 1e-9), "{gaps:?}");
        // Under a third of the touches of one spacing as fine as round the edges; they become no
        // more from turn to turn.
        let fine = front(0.8, 0.8).spaced(coarse).len();
        assert!(nodes.len() > 100 && 3 * nodes.len() < fine, "{} {fine}", nodes.len());
        let again = (0..20).fold(nodes.clone(), |nodes, _| graded.spaced(nodes));
        let ratio = again.len() as f64 / nodes.len() as f64;
        assert!((0.9..1.1).contains(&ratio), "{} {}", nodes.len(), again.len());
    }
}
