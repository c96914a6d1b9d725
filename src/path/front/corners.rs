//! The corners of a turn, where two sides run towards one another, and the ways across them.

use super::folds::Unfolded;
use super::node::Node;
use super::overrun::Overrun;
use super::{FAR, Front};
use crate::geometry::{Point, Vector};
use crate::path::level::Touch;
use crate::path::stepover::{Pass, ridge_height};

/// A place between two sides of a turn that run towards one another is nearer to both of them than
/// this share of its distance from the corner where they meet.
const CORNER: f64 = 0.98;
/// A way shorter than this share of the stepover on flat ground comes to no corner: it is that of a
/// ramp's beginning.
const LEAST_CORNER: f64 = 0.3;
/// Places looked at between half a stepover from a corner and a place beside it, and halvings
/// towards the first of them that the sides leave.
const CORNER_PLACES: usize = 8;
const CORNER_HALVINGS: usize = 5;
/// Distance of touches in a corner between two sides, as a share of the usual step.
const BRIDGE: f64 = 0.4;
/// Tries to bring one of them back.
const BRIDGE_TRIES: usize = 3;

impl Front<'_> {
    /// Whether the corners of a turn are covered and no more: two sides that run towards one
    /// another meet in a corner and cut more there than the place where they meet, and the next
    /// turn need only come to within half a stepover of what they leave. Over facets there are such
    /// corners in every turn. Cutters with a corner, which lean aside there, and turns as published
    /// keep to the neighbours of single places on exact faces.
    pub fn follows_corners(&self) -> bool {
        let level = self.across.level;
        self.is_path && (level.is_over_facets() || (level.inclined.is_none() && !self.is_first_order()))
    }

    /// The neighbour of node `i`, farther on where that is in a corner: half a stepover beyond the
    /// last place that the sides cut.
    pub fn beyond_corner(&self, chain: &Overrun, i: usize, next: Node) -> Node {
        let from = chain.centre(i);
        let way = next.touch.centre - from;
        if !self.follows_corners() || next.stop.is_some() || way.norm() < LEAST_CORNER * self.flat_mm {
            return next;
        }
        let sides = |q: &Point| chain.sides([i; 3], self.look_mm(), q).map(|side| side - q);
        if !are_round_a_corner(&sides(&next.touch.centre), way.norm()) {
            return next;
        }
        let cut = self.cut_share(chain, [i; 3], way, 0.5);
        let touch = self.across.level.touch(&(from + way * (cut + 0.5)), 0.5 * way.norm());
        touch.filter(|t| self.across.bounds.hold(t)).map_or(next, |touch| Node { touch, ..next })
    }

    /// Up to where both sides of a turn together cut along `way` from the second of three nodes,
    /// each as far as the share `half` of the way, as a share of it. Behind a bay of the turn that
    /// is wider than a stepover and narrower than two the sides come near again: the first place
    /// that they leave counts.
    fn cut_share(&self, chain: &Overrun, of: [usize; 3], way: Vector, half: f64) -> f64 {
        let (from, half_mm) = (chain.centre(of[1]), half * way.norm());
        let is_cut = |share: f64| {
            let q = from + way * share;
            chain.sides(of, self.look_mm(), &q).iter().any(|side| (side - q).norm() <= half_mm)
        };
        let place = |k: usize| half + (1.0 - half) * k as f64 / CORNER_PLACES as f64;
        let Some(first) = (1..=CORNER_PLACES).find(|k| !is_cut(place(*k))) else { return 1.0 };
        let (mut low, mut high) = (place(first - 1), place(first));
        for _ in 0..CORNER_HALVINGS {
            let middle = 0.5 * (low + high);
            if is_cut(middle) { low = middle } else { high = middle }
        }
        low
    }

    /// The nodes that go on from `first`, with more of them where others were left out: sides that
    /// run towards one another meet in a corner, and a straight way between the last nodes of the
    /// two would pass it by at more than a stepover.
    pub fn bridged(&self, first: Node, unfolded: &Unfolded) -> Vec<Node> {
        let chain = &unfolded.chain;
        let mut nodes = vec![first];
        let mut from = 0;
        for (to, node) in &unfolded.kept {
            let last = nodes[nodes.len() - 1];
            let mut node = *node;
            let way = node.touch.centre - last.touch.centre;
            let count = (way.norm() / (BRIDGE * self.step_mm)).ceil() as usize;
            // The place where one turn becomes the next may lie in such a corner, too.
            let is_gap = *to > from + 1 || way.norm() > FAR * self.step_mm;
            if is_gap && last.stop.is_none() && node.stop.is_none() {
                let back = |touch: Touch| {
                    // Turns that are not measured are not brought back either.
                    if self.is_first_order() { Some(touch) } else { self.not_too_far(chain, [from, *to], touch) }
                };
                let is_corner = *to > from + 1 && self.follows_corners();
                if is_corner {
                    node.touch = back(node.touch).unwrap_or(node.touch);
                    // The first node is the last of the turn before.
                    if let Some(end) = nodes[1..].last_mut() {
                        end.touch = back(end.touch).unwrap_or(end.touch);
                    }
                }
                nodes.extend((1..count).filter_map(|k| {
                    let guess = last.touch.centre + way * (k as f64 / count as f64);
                    let touch = back(self.across.level.touch(&guess, way.norm())?)?;
                    Some(Node { touch, ..node })
                }));
            }
            nodes.push(node);
            from = *to;
        }
        nodes
    }

    /// A touch brought back to where it leaves no higher ridge than asked for beside nodes of the
    /// turn around two. Between two sides that run towards one another that is half a stepover
    /// beyond the first place on the way to it that they leave. Over facets, whose edges ball
    /// centres go a long way round, it is `(1 + cos β)/2` of the stepover from both sides, where
    /// the angle between the ways to them is 2β: the same between straight ones, and short of it in
    /// a bay.
    fn not_too_far(&self, chain: &Overrun, [from, to]: [usize; 2], touch: Touch) -> Option<Touch> {
        let level = self.across.level;
        let mut touch = touch;
        for _ in 0..BRIDGE_TRIES {
            let q = touch.centre;
            let of = chain.farthest([from, to], &q);
            let sides = chain.sides([from, of, to], self.look_mm(), &q);
            let ways = sides.map(|side| side - q);
            let corner_mm = (chain.centre(of) - q).norm();
            let is_corner = self.follows_corners() && are_round_a_corner(&ways, corner_mm);
            let near = sides[usize::from(ways[1].norm_squared() < ways[0].norm_squared())];
            let beside = level.touch(&near, self.flat_mm)?;
            let near = beside.centre;
            let ridge = ridge_height(level, Pass::pair(level, &beside, &touch).each_ref())?;
            let stepovers = (ridge / self.scallop_mm).max(0.0).sqrt();
            let guess = if is_corner && !level.is_over_facets() {
                let (corner, half) = (chain.centre(of), 0.5 * (q - near).norm() / stepovers / corner_mm);
                let share = match half < 1.0 {
                    true => self.cut_share(chain, [from, of, to], q - corner, half) + half,
                    false => 1.0,
                };
                if share >= 1.0 {
                    break;
                }
                corner + (q - corner) * share
            } else {
                let share = if is_corner { 0.5 + 0.5 * (0.5 * ways[0].angle(&ways[1])).cos() } else { 1.0 };
                if stepovers <= share {
                    break;
                }
                near + (q - near) * (share / stepovers)
            };
            touch = level.touch(&guess, self.flat_mm)?;
        }
        Some(touch)
    }
}

/// Whether the ways from a place to the two sides of a turn are both shorter than that to the node
/// between, `corner_mm`: the sides run towards one another.
fn are_round_a_corner(ways: &[Vector; 2], corner_mm: f64) -> bool {
    ways.iter().all(|way| way.norm() <= CORNER * corner_mm)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::By;
    use super::super::neighbour::Across;
    use super::*;
    use crate::artifact::along::Along;
    use crate::geometry::allowance::Allowed;
    use crate::geometry::exact::tests::block;
    use crate::geometry::part::Part;
    use crate::observe::Silent;
    use crate::path::bounds::Bounds;
    use crate::path::level::LevelSet;
    use crate::path::tests::turned;
    use crate::tool::stepover::flat_stepover_mm;

    /// Looks at turns on the flat side of a bar, exact or of facets: of a front, its flat stepover,
    /// mm, and what gives the node at a place along the bar's side and up it.
    fn on_a_flat_side(is_exact: bool, look: impl Fn(&Front, f64, &dyn Fn(f64, f64) -> Node)) {
        let mut blade = turned(4, &[1.0, 200.0], |_, s, c| [100.0 * c, 100.0 * s]);
        if is_exact {
            blade.part = Part::from_brep(block(Vector::new(200.0, 100.0, 5.0)), 0.05, &Silent).unwrap();
        }
        let (radius_mm, scallop_mm) = (4.0, 0.01);
        let level = LevelSet {
            part: Allowed::new(&blade.part, 0.0),
            along: Along::BLADE,
            radius_mm,
            inclined: None,
            rim: None,
            lowest_mm: f64::NEG_INFINITY,
        };
        let flat_mm = flat_stepover_mm(radius_mm, scallop_mm);
        let across = Across { level: &level, bounds: Bounds::NONE, min_step_mm: 0.01 };
        let front = Front {
            across,
            scallop_mm,
            flat_mm,
            step_mm: 0.25 * flat_mm,
            round_edges_mm: 0.25 * flat_mm,
            round_mm: 100.0,
            back: 0.3,
            evens_ways: false,
            is_path: true,
            by: By::Ridges,
        };
        let (out, along) = (Vector::new(0.0, 1.0, 1.0).normalize(), Vector::new(0.0, -1.0, 1.0).normalize());
        let on_side = |u: f64, v: f64| {
            let guess = match is_exact {
                true => Point::new(100.0 + v, 50.0 - u, 5.0 + radius_mm),
                false => Point::new(100.0 + v, 0.0, 0.0) + out * (50f64.hypot(50.0) + radius_mm) + along * u,
            };
            Node { touch: level.touch(&guess, 1.0).unwrap(), way_mm: flat_mm, stop: None }
        };
        look(&front, flat_mm, &on_side);
    }

    #[test]
    fn corners_are_covered_and_no_more() {
        // Turns whose sides run towards one another at `half_rad` from the line between them, down
        // at 0.
        let looked_at = |front: &Front, flat_mm: f64, on_side: &dyn Fn(f64, f64) -> Node, half_rad: f64| {
            let (sine, cosine) = half_rad.sin_cos();
            let place = |k: i32| (0.25 * flat_mm * f64::from(k), 0.25 * flat_mm * f64::from(k.abs()));
            let turn: Vec<Node> = (-12..=12).map(place).map(|(u, v)| on_side(u * sine, v * cosine)).collect();
            let chain = Overrun::of(&[], &turn, std::iter::empty());
            let up = |node: &Node| (node.touch.centre.x - 100.0) / flat_mm;
            // Sides cut as far as half a stepover from them, 1 / sin of that over the corner.
            let next = front.beyond_corner(&chain, 12, on_side(0.0, flat_mm));
            assert!((up(&next) - 0.5 * (1.0 / sine + 1.0)).abs() < 0.01, "{half_rad}: {}", up(&next));
            // Where the sides' own neighbours meet, those of the places `gap` from the corner, is
            // too far.
            let gap = (4.0 * cosine / sine).ceil() as usize;
            let met = on_side(0.0, flat_mm / sine).touch;
            let back = front.not_too_far(&chain, [12 - gap, 12 + gap], met).unwrap().centre;
            let near_mm = chain.sides([12; 3], front.look_mm(), &back).map(|side| (side - back).norm());
            let near = near_mm[0].min(near_mm[1]) / flat_mm;
            assert!((near - 0.5 * (1.0 + sine)).abs() < 0.01, "{half_rad}: {near}");
            // Far from the corner a neighbour stays where it is.
            let (u, v) = place(10);
            let aside = on_side(u * sine - flat_mm * cosine, v * cosine + flat_mm * sine);
            assert_eq!(front.beyond_corner(&chain, 22, aside).touch.centre, aside.touch.centre);
        };
        let on_both = |front: &Front, flat_mm: f64, on_side: &dyn Fn(f64, f64) -> Node| {
            [0.6f64, 1.0, 1.3].into_iter().for_each(|half_rad| looked_at(front, flat_mm, on_side, half_rad));
        };
        [false, true].into_iter().for_each(|is_exact| on_a_flat_side(is_exact, on_both));
    }

    /// All of a bay wider than a stepover and narrower than two is nearer than a stepover to its
    /// shores, but its middle farther than half of one.
    #[test]
    fn the_next_turn_comes_into_a_bay_whose_shores_leave_its_middle() {
        on_a_flat_side(true, |front, flat_mm, on_side| {
            let up = |node: &Node| (node.touch.centre.x - 100.0) / flat_mm;
            let bay = |half_width: f64, shore: &[(f64, f64)]| -> Vec<Node> {
                let round = |k: i32| {
                    let angle = f64::from(k) * std::f64::consts::FRAC_PI_2 / 10.0;
                    (half_width * angle.sin(), half_width * (1.0 - angle.cos()))
                };
                let left = shore.iter().rev().map(|(u, v)| (-u, *v));
                let all = left.chain((-10..=10).map(round)).chain(shore.iter().copied());
                all.map(|(u, v)| on_side(u * flat_mm, v * flat_mm)).collect()
            };
            // Shores as far apart all the way: from beyond its mouth a way comes in to half a
            // stepover from what is left.
            let turn = bay(0.63, &[(0.63, 0.8), (0.63, 1.2), (0.63, 1.8)]);
            let chain = Overrun::of(&[], &turn, std::iter::empty());
            let middle = turn.len() / 2;
            let touch = front.not_too_far(&chain, [3, turn.len() - 4], on_side(0.0, 1.3 * flat_mm).touch).unwrap();
            let came = up(&Node { touch, ..turn[middle] });
            assert!((came - 1.0).abs() < 0.02, "{came}");
            // Shores that come near again at its mouth.
            let turn = bay(0.55, &[(0.55, 0.62), (0.42, 0.95), (0.6, 1.6)]);
            let chain = Overrun::of(&[], &turn, std::iter::empty());
            let next = front.beyond_corner(&chain, turn.len() / 2, on_side(0.0, flat_mm));
            assert!((up(&next) - 1.0).abs() < 0.02, "{}", up(&next));
        });
    }
}
