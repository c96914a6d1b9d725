//! Touches of a turn while it is laid: folds, loops and islands left out, touches added and taken
//! away, ways over facets evened out.

use rayon::prelude::*;

use super::bounds::Stop;
use super::curve::{self, LevelCurve};
use super::level::Touch;
use super::neighbour::Heading;
use super::stepover::ridge_height;
use super::turn::{LEAST_SHARE, March, TurnNode};
use crate::geometry::triangle::closest_on_segment;
use crate::geometry::{Point, Vector};

/// Touches nearer to one another than this share of the usual step are too many.
const CLOSE: f64 = 0.35;
/// Touches farther from one another than this share of the usual step are too few.
const FAR: f64 = 1.5;
/// Turn of the normal from touch to touch that asks for another, rad.
const BEND_RAD: f64 = 0.2;
/// Width of the bell over which ways over facets are evened out, in stepovers on flat ground.
const EVEN_WIDTH: f64 = 0.25;
/// Standard deviations that an evened way stays under the mean of those round it.
const EVEN_CAUTION: f64 = 1.0;
/// Caution that is not needed: so much longer a way makes the ridge higher by not quite a
/// hundredth.
const FREE: f64 = 4e-3;
/// A neighbour nearer to any place of the turn than this share of its way is beyond a crossing; ...
const OVERRUN: f64 = 0.8;
/// ... where corners are followed, in which another side is nearer by right.
const OVERRUN_CORNERS: f64 = 0.96;
/// A place between two sides of a turn that run towards one another is nearer to both of them than
/// this share of its distance from the corner where they meet.
const CORNER: f64 = 0.98;
/// A way shorter than this share of the stepover on flat ground comes to no corner: it is that of a
/// ramp's beginning.
const LEAST_CORNER: f64 = 0.3;
/// Halvings towards the last place in a corner that two sides cut.
const CORNER_HALVINGS: usize = 8;
/// Distance of touches in a corner between two sides, as a share of the usual step.
const BRIDGE: f64 = 0.4;
/// Tries to bring one of them back.
const BRIDGE_TRIES: usize = 3;
/// Longest stretch that is left out, as a share of the turn: where ways cross, the shorter of the
/// two that a crossing makes.
const LOOP: f64 = 0.5;
/// The way round an island is at least so many times as long as the way past it.
const ROUND_ISLAND: f64 = 3.0;
/// Rounds of adding touches.
const MOST_ROUNDS: usize = 6;

/// A turn whose stretches may run into one another: where it lags behind in a narrow tongue, the
/// neighbours of the tongue's two sides cross, and what lies beyond the crossing is left out, as
/// with the offset of any curve.
pub(super) struct Overrun {
    turn: Vec<TurnNode>,
    /// Where the turn begins in the chain of nodes looked at.
    first: usize,
    /// Arc length at the nodes, mm.
    s_mm: Vec<f64>,
    /// Longest distance between two nodes, mm.
    longest_mm: f64,
}

impl Overrun {
    /// Of a turn with what comes before its first node and after its last.
    pub(super) fn of(before: &[TurnNode], turn: &[TurnNode], after: impl Iterator<Item = TurnNode>) -> Self {
        let chain: Vec<TurnNode> = before.iter().chain(turn).copied().chain(after).collect();
        let s_mm = arc_lengths(&chain);
        let longest_mm = s_mm.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
        Overrun { turn: chain, first: before.len(), s_mm, longest_mm }
    }

    /// The next node after `k` from which a way to another may come to a place that is `apart_mm`
    /// from `k`: a curve is never longer than its arc.
    fn after(&self, k: usize, apart_mm: f64) -> usize {
        let free = self.s_mm[k] + (apart_mm - self.longest_mm).max(0.0);
        (k + 1).max(self.s_mm.partition_point(|s| *s < free).saturating_sub(1))
    }

    /// Whether the turn comes nearer to `q`, which is a neighbour of its node `of`, than
    /// `least_mm`.
    fn is_nearer(&self, q: &Point, of: usize, least_mm: f64) -> bool {
        let of = self.first + of;
        let distance = |k: usize| (self.turn[k].touch.centre - q).norm();
        let mut k = of;
        while k + 1 < self.turn.len() {
            let (a, b) = (&self.turn[k].touch.centre, &self.turn[k + 1].touch.centre);
            if (closest_on_segment(a, b, q) - q).norm() < least_mm {
                return true;
            }
            k = self.after(k, distance(k) - least_mm);
        }
        let mut k = of;
        while k > 0 {
            let (a, b) = (&self.turn[k - 1].touch.centre, &self.turn[k].touch.centre);
            if (closest_on_segment(a, b, q) - q).norm() < least_mm {
                return true;
            }
            let free = self.s_mm[k] - (distance(k) - least_mm - self.longest_mm).max(0.0);
            k = (k - 1).min(self.s_mm.partition_point(|s| *s <= free));
        }
        false
    }

    /// The turn without the stretches between places where it crosses itself. A turn that goes once
    /// round a part and does not cross itself has all that is cut on one side of it: where it does,
    /// it goes back over what was cut, and the turns after it would run the other way.
    pub(super) fn without_loops(&self) -> Vec<TurnNode> {
        let nodes = &self.turn;
        let way = |k: usize| [&nodes[k].touch, &nodes[k + 1].touch];
        // The way from a node may come towards it by its own length.
        self.shortened(self.longest_mm, |at, k| (k + 1 < nodes.len() && cross(way(at), way(k))).then_some(k + 1))
    }

    /// The turn without the stretches in which it goes round an island narrower than `width_mm`:
    /// away from the side of the turns after it, and back to near where it left.
    pub(super) fn without_islands(&self, width_mm: f64) -> Vec<TurnNode> {
        self.shortened(width_mm, |at, k| {
            let apart_mm = (self.turn[k].touch.centre - self.turn[at].touch.centre).norm();
            let round_mm = self.s_mm[k] - self.s_mm[at];
            let is_narrow = apart_mm < width_mm && round_mm > (ROUND_ISLAND * apart_mm).max(width_mm);
            (is_narrow && runs_to_the_left(&self.turn[at..=k])).then_some(k)
        })
    }

    /// The turn without the stretches that `ends` tells of: from a node and a later one that may be
    /// as near to it as `near_mm`, the node at which the turn goes on, if what lies between is left
    /// out. The farthest counts.
    fn shortened(&self, near_mm: f64, ends: impl Fn(usize, usize) -> Option<usize>) -> Vec<TurnNode> {
        let (nodes, s_mm) = (&self.turn, &self.s_mm);
        let most_mm = LOOP * s_mm.last().copied().unwrap_or(0.0);
        let mut kept = Vec::with_capacity(nodes.len());
        let mut at = 0;
        while at < nodes.len() {
            kept.push(nodes[at]);
            let (mut after, mut k) = (at + 1, at + 2);
            while k < nodes.len() && s_mm[k] - s_mm[at] < most_mm {
                after = ends(at, k).unwrap_or(after);
                let apart_mm = (nodes[k].touch.centre - nodes[at].touch.centre).norm();
                k = self.after(k, apart_mm - near_mm);
            }
            at = after;
        }
        kept
    }

    /// The node between two of the turn that is farthest from `q`: there two sides meet that run
    /// towards one another.
    fn farthest(&self, [from, to]: [usize; 2], q: &Point) -> usize {
        let away = |k: &usize| (self.turn[self.first + k].touch.centre - q).norm_squared();
        (from..=to).max_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(from)
    }

    /// The nearest places to `q` of the turn before its node `of` and after it, as far as `look_mm`
    /// beyond the nodes `from` and `to`.
    fn sides(&self, [from, of, to]: [usize; 3], look_mm: f64, q: &Point) -> [Point; 2] {
        let [from, of, to] = [from, of, to].map(|k| self.first + k);
        let lo = self.s_mm.partition_point(|s| *s < self.s_mm[from] - look_mm);
        let hi = self.s_mm.partition_point(|s| *s <= self.s_mm[to] + look_mm);
        let nearest = |nodes: &[TurnNode]| {
            let places = nodes.windows(2).map(|w| closest_on_segment(&w[0].touch.centre, &w[1].touch.centre, q));
            let least = places.min_by(|a, b| (a - q).norm_squared().total_cmp(&(b - q).norm_squared()));
            least.unwrap_or(self.turn[of].touch.centre)
        };
        [nearest(&self.turn[lo..=of]), nearest(&self.turn[of..hi])]
    }
}

impl March<'_> {
    /// The nodes after those of `turn` without those that were not found and with folds cut away
    /// from both sides; `before` is what lies before the first node of `turn`. A fold over the
    /// place where one turn becomes the next takes nodes from the end of `turn`, too. `Err`: where
    /// the ball could not go on for a stretch.
    pub(super) fn without_folds(
        &self,
        before: &[TurnNode],
        turn: &mut Vec<TurnNode>,
        along: &[Vector],
        next: &[Option<TurnNode>],
    ) -> Result<Vec<TurnNode>, Point> {
        // Where the turn bends to and fro, only the direction halfway between the two says which
        // way it goes on.
        let behind = |a: (usize, &TurnNode), b: (usize, &TurnNode)| {
            let step = b.1.touch.centre - a.1.touch.centre;
            let onward = along[a.0] + along[b.0];
            step.dot(&onward) <= 0.1 * step.norm() * onward.norm()
        };
        let least = if self.follows_corners() { OVERRUN_CORNERS } else { OVERRUN };
        let overruns = |chain: &Overrun, i: usize, node: &TurnNode| {
            let way = (node.touch.centre - turn[i].touch.centre).norm();
            node.stop.is_none() && chain.is_nearer(&node.touch.centre, i, least * way)
        };
        let mut end = turn.len() - 1;
        let mut kept: Vec<(usize, TurnNode)> = Vec::new();
        let mut chain = Overrun::of(before, turn, std::iter::empty());
        let late_mm = chain.s_mm.last().copied().unwrap_or(0.0) - self.look_mm();
        let mut is_late = false;
        for i in 1..next.len() {
            if i > end {
                break;
            }
            if !is_late && chain.s_mm[chain.first + i] > late_mm {
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
        let widest = self.widest_mm();
        let mut from = 0;
        for to in kept.iter().map(|k| k.0).chain([end]) {
            let lost = (from + 1..=to).find(|i| next[*i].is_none());
            if let Some(i) = lost
                && (turn[to].touch.centre - turn[from].touch.centre).norm() > widest
            {
                return Err(turn[i].touch.centre);
            }
            from = to;
        }
        if kept.is_empty() {
            return Err(turn[end].touch.centre);
        }
        let is_ring = is_ring(turn);
        turn.truncate(end + 1);
        if is_ring {
            // It is left so slowly that nothing beside it is far.
            return Ok(turn.last().copied().into_iter().chain(kept.into_iter().map(|k| k.1)).collect());
        }
        Ok(self.bridged(&chain, turn[end], &kept))
    }

    /// Whether the corners of a turn are covered and no more: two sides that run towards one
    /// another meet in a corner and cut more there than the place where they meet, and the next
    /// turn need only come to within half a stepover of what they leave. Over facets there are such
    /// corners in every turn.
    fn follows_corners(&self) -> bool {
        self.is_path && self.across.level.is_over_facets()
    }

    /// The neighbour of node `i`, farther on where that is in a corner: half a stepover beyond the
    /// last place that the sides cut.
    fn beyond_corner(&self, chain: &Overrun, i: usize, next: TurnNode) -> TurnNode {
        let from = chain.turn[chain.first + i].touch.centre;
        let way = next.touch.centre - from;
        if !self.follows_corners() || next.stop.is_some() || way.norm() < LEAST_CORNER * self.flat_mm {
            return next;
        }
        let sides = |q: &Point| chain.sides([i; 3], self.look_mm(), q).map(|side| side - q);
        if !are_round_a_corner(&sides(&next.touch.centre), way.norm()) {
            return next;
        }
        let (mut low, mut high) = (0.5, 1.0);
        for _ in 0..CORNER_HALVINGS {
            let middle = 0.5 * (low + high);
            let is_cut = sides(&(from + way * middle)).iter().any(|side| side.norm() <= 0.5 * way.norm());
            if is_cut { low = middle } else { high = middle }
        }
        let touch = self.across.level.touch(&(from + way * (low + 0.5)), 0.5 * way.norm());
        touch.filter(|t| self.across.bounds.hold(t)).map_or(next, |touch| TurnNode { touch, ..next })
    }

    /// The nodes kept after `first`, with more of them where others were left out: sides that run
    /// towards one another meet in a corner, and a straight way between the last nodes of the two
    /// would pass it by at more than a stepover.
    fn bridged(&self, chain: &Overrun, first: TurnNode, kept: &[(usize, TurnNode)]) -> Vec<TurnNode> {
        let mut nodes = vec![first];
        let mut from = 0;
        for (to, node) in kept {
            let last = nodes[nodes.len() - 1];
            let mut node = *node;
            let way = node.touch.centre - last.touch.centre;
            let count = (way.norm() / (BRIDGE * self.step_mm)).ceil() as usize;
            // The place where one turn becomes the next may lie in such a corner, too.
            let is_gap = *to > from + 1 || way.norm() > FAR * self.step_mm;
            if is_gap && last.stop.is_none() && node.stop.is_none() {
                let back = |touch: Touch| self.not_too_far(chain, [from, *to], touch);
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
                    Some(TurnNode { touch, ..node })
                }));
            }
            nodes.push(node);
            from = *to;
        }
        nodes
    }

    /// A touch brought back to where it leaves no higher ridge than asked for beside nodes of the
    /// turn around two. Between two sides with the angle 2β between the ways to them, that is to (1
    /// +
    /// cos β)/2 of the stepover from each: half of it from what both leave.
    fn not_too_far(&self, chain: &Overrun, [from, to]: [usize; 2], touch: Touch) -> Option<Touch> {
        let level = self.across.level;
        let mut touch = touch;
        for _ in 0..BRIDGE_TRIES {
            let q = touch.centre;
            let of = chain.farthest([from, to], &q);
            let sides = chain.sides([from, of, to], self.look_mm(), &q);
            let ways = sides.map(|side| side - q);
            let corner_mm = (chain.turn[chain.first + of].touch.centre - q).norm();
            let is_corner = self.follows_corners() && are_round_a_corner(&ways, corner_mm);
            let share = if is_corner { 0.5 + 0.5 * (0.5 * ways[0].angle(&ways[1])).cos() } else { 1.0 };
            let near = sides[usize::from(ways[1].norm_squared() < ways[0].norm_squared())];
            let near = level.touch(&near, self.flat_mm)?.centre;
            let ridge = ridge_height(level, &near, &q)?;
            let most = self.scallop_mm * share * share;
            if ridge <= most {
                break;
            }
            let guess = near + (q - near) * (most / ridge).sqrt();
            touch = level.touch(&guess, self.flat_mm)?;
        }
        Some(touch)
    }

    /// So wide a stretch without a neighbour is passed over, mm; over facets, where single ones
    /// stop the ball, twice as wide.
    fn widest_mm(&self) -> f64 {
        let times = if self.across.level.is_over_facets() { 2.0 } else { 1.0 };
        times * (2.0 * self.flat_mm + 3.0 * self.step_mm)
    }

    /// Leaves out short stretches of neighbours that a wall or an edge stops, between others that
    /// go on: one touch that stays behind while all round it goes on would draw a tongue of
    /// crossing ways behind it.
    pub(super) fn leave_out_burrs(&self, next: &mut [Option<TurnNode>]) {
        let stopped = |n: &Option<TurnNode>| n.is_some_and(|n| n.stop.is_some_and(|s| s != Stop::Height));
        let free = |n: &Option<TurnNode>| n.filter(|n| n.stop.is_none()).map(|n| n.touch.centre);
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

    /// The same turn with its touches neither too close nor too far apart; ends stay.
    pub(super) fn tidy(&self, nodes: Vec<TurnNode>) -> Vec<TurnNode> {
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

    fn thinned(&self, nodes: Vec<TurnNode>) -> Vec<TurnNode> {
        let close = |a: &TurnNode, b: &TurnNode| (a.touch.centre - b.touch.centre).norm() < CLOSE * self.step_mm;
        let mut kept: Vec<TurnNode> = Vec::with_capacity(nodes.len());
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
    fn filled(&self, nodes: &[TurnNode]) -> (Vec<TurnNode>, bool) {
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
                out.push(TurnNode { touch, way_mm: 0.5 * (w[0].way_mm + w[1].way_mm), stop });
                added = true;
            }
        }
        out.extend(nodes.last());
        (out, added)
    }

    /// Ways over facets scatter: each becomes the mean of those round it, weighted by a bell, less
    /// some standard deviations, so that few ridges are higher than asked for. The end of the turn
    /// and its beginning, a stepover apart, count as neighbours: with the one's mean only from
    /// before and the other's only from after, a step would grow there.
    pub(super) fn even_out(
        &self,
        turn: &[TurnNode],
        round: &[Touch],
        along: &[Vector],
        shares: &[f64],
        next: Vec<Option<TurnNode>>,
    ) -> Vec<Option<TurnNode>> {
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
        (0..=n)
            .into_par_iter()
            .map(|i| {
                let Some(node) = next[i].filter(|x| i > 0 && x.stop.is_none() && shares[i] >= LEAST_SHARE) else {
                    return next[i];
                };
                let from = Heading { touch: turn[i].touch, along: along[i] };
                let Some(found) = mean(i).and_then(|w| self.across.reach(&from, round, w * shares[i])) else {
                    return Some(node);
                };
                let way_mm = if found.stop.is_some() { node.way_mm } else { found.way_mm / shares[i] };
                Some(TurnNode { touch: found.touch, way_mm, stop: found.stop })
            })
            .collect()
    }
}

/// Whether a stretch of a turn, closed by a straight way, encloses what lies to the left of the
/// straight way: it is run clockwise, seen along the surface's normals.
fn runs_to_the_left(stretch: &[TurnNode]) -> bool {
    let from = stretch[0].touch.centre;
    let area: Vector = stretch.windows(2).map(|w| (w[0].touch.centre - from).cross(&(w[1].touch.centre - from))).sum();
    let normals: Vector = stretch.iter().map(|n| n.touch.normal).sum();
    area.dot(&normals) < 0.0
}

/// Whether the ways from a place to the two sides of a turn are both shorter than that to the node
/// between, `corner_mm`: the sides run towards one another.
fn are_round_a_corner(ways: &[Vector; 2], corner_mm: f64) -> bool {
    ways.iter().all(|way| way.norm() <= CORNER * corner_mm)
}

/// Whether two ways between touches cross, seen along the surface's normal there.
fn cross([a, b]: [&Touch; 2], [c, d]: [&Touch; 2]) -> bool {
    let (one, other) = (b.centre - a.centre, d.centre - c.centre);
    let normal = a.normal + b.normal + c.normal + d.normal;
    let is_left = |from: &Touch, way: &Vector, to: &Touch| way.cross(&(to.centre - from.centre)).dot(&normal) > 0.0;
    (c.centre - a.centre).norm() <= one.norm() + other.norm()
        && a.normal.dot(&c.normal) > 0.0
        && is_left(a, &one, c) != is_left(a, &one, d)
        && is_left(c, &other, a) != is_left(c, &other, b)
}

/// Whether a turn is closed: a ring, from which the first turn is laid, or one whose seam rests at
/// the end of the region.
pub(super) fn is_ring(turn: &[TurnNode]) -> bool {
    turn.first().zip(turn.last()).is_some_and(|(a, b)| a.touch.centre == b.touch.centre)
}

/// Arc lengths of a turn at its nodes, mm.
pub(super) fn arc_lengths(turn: &[TurnNode]) -> Vec<f64> {
    curve::arc_lengths(turn.iter().map(|n| &n.touch.centre))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::bounds::Bounds;
    use super::super::level::LevelSet;
    use super::super::neighbour::Across;
    use super::super::stepover::flat_stepover_mm;
    use super::super::tests::turned;
    use super::*;
    use crate::artifact::along::Along;
    use crate::geometry::allowance::Allowed;

    /// Nodes on the plane `z = 0` and on its other side.
    fn nodes(places: &[(f64, f64)], up: f64) -> Vec<TurnNode> {
        let normal = Vector::new(0.0, 0.0, up);
        let touch = |p: &(f64, f64)| {
            let contact = Point::new(p.0, p.1, 0.0);
            Touch { centre: contact + normal, contact, normal, face: 0 }
        };
        places.iter().map(|p| TurnNode { touch: touch(p), way_mm: 1.0, stop: None }).collect()
    }

    fn places(nodes: &[TurnNode]) -> Vec<(f64, f64)> {
        nodes.iter().map(|n| (n.touch.centre.x, n.touch.centre.y)).collect()
    }

    fn without_loops(nodes: &[TurnNode]) -> Vec<TurnNode> {
        Overrun::of(&[], nodes, std::iter::empty()).without_loops()
    }

    #[test]
    fn a_loop_is_left_out_and_what_does_not_cross_stays() {
        let straight = |from: i32, to: i32| (from..to).map(|k| (f64::from(k), 0.0));
        // Round a circle about (10, 2) from below, which goes over the straight way beside it.
        let ring = |k: i32| (f64::from(k) * 0.3).sin_cos();
        let round = (2..20).map(ring).map(|(s, c)| (10.2 + 2.0 * s, 1.8 - 2.0 * c));
        let with_loop: Vec<_> = straight(0, 11).chain(round).chain(straight(11, 40)).collect();
        let kept = places(&without_loops(&nodes(&with_loop, 1.0)));
        assert!(kept.iter().all(|p| p.1.abs() < 0.3), "{kept:?}");
        assert!(kept.len() > 38 && kept[0] == (0.0, 0.0) && kept[kept.len() - 1] == (39.0, 0.0), "{kept:?}");
        // A narrow tongue touches itself nowhere.
        let tongue = (0..9).map(|k| (10.0, f64::from(k))).chain((0..9).rev().map(|k| (10.1, f64::from(k))));
        let with_tongue: Vec<_> = straight(0, 10).chain(tongue).chain(straight(11, 40)).collect();
        assert_eq!(places(&without_loops(&nodes(&with_tongue, 1.0))), with_tongue);
    }

    #[test]
    fn narrow_islands_are_passed_by_and_bays_and_wide_islands_are_followed() {
        // To the right of the way, which is run along x, lie the turns after it.
        let along = |width: f64, height: f64| -> Vec<_> {
            let side = (1..=20).map(|k| 0.05 * f64::from(k) * height);
            let up = side.clone().map(|y| (10.0, y));
            let down = side.rev().map(|y| (10.0 + width, y));
            let straight = |from: i32, to: i32| (from..=to).map(|k| (0.1 * f64::from(k), 0.0));
            straight(0, 100).chain(up).chain(down).chain(straight(100 + (10.0 * width) as i32, 200)).collect()
        };
        let kept = |places: &[(f64, f64)]| {
            self::places(&Overrun::of(&[], &nodes(places, 1.0), std::iter::empty()).without_islands(1.0))
        };
        let highest = |places: &[(f64, f64)]| places.iter().map(|p| p.1.abs()).fold(0.0, f64::max);
        let island = kept(&along(0.4, 3.0));
        assert!(highest(&island) < 0.8 && island.len() > 180, "{island:?}");
        assert_eq!((island[0], island[island.len() - 1]), ((0.0, 0.0), (20.0, 0.0)));
        for followed in [along(0.4, -3.0), along(1.5, 3.0), along(0.4, 0.3)] {
            assert_eq!(kept(&followed), followed);
        }
    }

    #[test]
    fn corners_are_covered_and_no_more() {
        // A turn on the flat side of a bar, whose sides run towards one another at `half_rad` from
        // the line between them, down at 0.
        let blade = turned(4, &[1.0, 200.0], |_, s, c| [100.0 * c, 100.0 * s]);
        let (radius_mm, scallop_mm) = (4.0, 0.01);
        let level = LevelSet {
            part: Allowed::new(&blade.part, 0.0),
            along: Along::BLADE,
            radius_mm,
            rim: None,
            lowest_mm: f64::NEG_INFINITY,
        };
        let flat_mm = flat_stepover_mm(radius_mm, scallop_mm);
        let across = Across { level: &level, bounds: Bounds::NONE, min_step_mm: 0.01 };
        let march = March {
            across,
            scallop_mm,
            flat_mm,
            step_mm: 0.25 * flat_mm,
            round_mm: 100.0,
            back: 0.3,
            evens_ways: false,
            is_path: true,
        };
        let (out, along) = (Vector::new(0.0, 1.0, 1.0).normalize(), Vector::new(0.0, -1.0, 1.0).normalize());
        let on_side = |u: f64, v: f64| {
            let guess = Point::new(100.0 + v, 0.0, 0.0) + out * (50f64.hypot(50.0) + radius_mm) + along * u;
            TurnNode { touch: level.touch(&guess, 1.0).unwrap(), way_mm: flat_mm, stop: None }
        };
        for half_rad in [0.6f64, 1.0, 1.3] {
            let (sine, cosine) = half_rad.sin_cos();
            let place = |k: i32| (0.25 * flat_mm * f64::from(k), 0.25 * flat_mm * f64::from(k.abs()));
            let turn: Vec<TurnNode> = (-12..=12).map(place).map(|(u, v)| on_side(u * sine, v * cosine)).collect();
            let chain = Overrun::of(&[], &turn, std::iter::empty());
            let up = |node: &TurnNode| (node.touch.centre.x - 100.0) / flat_mm;
            // Sides cut as far as half a stepover from them, 1 / sin of that over the corner.
            let next = march.beyond_corner(&chain, 12, on_side(0.0, flat_mm));
            assert!((up(&next) - 0.5 * (1.0 / sine + 1.0)).abs() < 0.01, "{half_rad}: {}", up(&next));
            // Where the sides' own neighbours meet, those of the places `gap` from the corner, is
            // too far.
            let gap = (4.0 * cosine / sine).ceil() as usize;
            let met = on_side(0.0, flat_mm / sine).touch;
            let back = march.not_too_far(&chain, [12 - gap, 12 + gap], met).unwrap().centre;
            let near_mm = chain.sides([12; 3], march.look_mm(), &back).map(|side| (side - back).norm());
            let near = near_mm[0].min(near_mm[1]) / flat_mm;
            assert!((near - 0.5 * (1.0 + sine)).abs() < 0.01, "{half_rad}: {near}");
            // Far from the corner a neighbour stays where it is.
            let (u, v) = place(10);
            let aside = on_side(u * sine - flat_mm * cosine, v * cosine + flat_mm * sine);
            assert_eq!(march.beyond_corner(&chain, 22, aside).touch.centre, aside.touch.centre);
        }
    }

    #[test]
    fn the_other_side_of_a_thin_part_is_not_crossed() {
        // Along a diagonal of a plate and, on its other side, across it.
        let diagonal: Vec<_> = (0..20).map(|k| (0.5 * f64::from(k), 0.5 * f64::from(k))).collect();
        let back: Vec<_> = (0..20).map(|k| (0.5 * f64::from(k), 9.6 - 0.5 * f64::from(k))).collect();
        let both = |up: f64| [nodes(&diagonal, 1.0), nodes(&back, up), nodes(&[(40.0, 0.0)], 1.0)].concat();
        assert_eq!(without_loops(&both(-1.0)).len(), both(-1.0).len());
        assert!(without_loops(&both(1.0)).len() < both(1.0).len());
    }
}
