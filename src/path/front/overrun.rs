//! Where a turn runs into itself: the nearest places of a turn to a place beside it, and a turn
//! without the loops and islands that it goes round.

use super::node::{Node, arc_lengths};
use crate::geometry::triangle::closest_on_segment;
use crate::geometry::{Point, Vector};
use crate::path::level::Touch;

/// Longest stretch that is left out, as a share of the turn: where ways cross, the shorter of the
/// two that a crossing makes.
const LOOP: f64 = 0.5;
/// The way round an island is at least so many times as long as the way past it.
const ROUND_ISLAND: f64 = 3.0;

/// A turn whose stretches may run into one another: where it lags behind in a narrow tongue, the
/// neighbours of the tongue's two sides cross, and what lies beyond the crossing is left out, as
/// with the offset of any curve.
pub struct Overrun {
    turn: Vec<Node>,
    /// Where the turn begins in the chain of nodes looked at.
    first: usize,
    /// Arc length at the nodes, mm.
    s_mm: Vec<f64>,
    /// Longest distance between two nodes, mm.
    longest_mm: f64,
}

impl Overrun {
    /// Of a turn with what comes before its first node and after its last.
    pub fn of(before: &[Node], turn: &[Node], after: impl Iterator<Item = Node>) -> Self {
        let chain: Vec<Node> = before.iter().chain(turn).copied().chain(after).collect();
        let s_mm = arc_lengths(&chain);
        let longest_mm = s_mm.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
        Overrun { turn: chain, first: before.len(), s_mm, longest_mm }
    }

    /// Arc length at the end of the turn and of what comes after it, mm.
    pub fn length_mm(&self) -> f64 {
        self.s_mm.last().copied().unwrap_or(0.0)
    }

    /// Arc length at a node of the turn, mm.
    pub fn at_mm(&self, node: usize) -> f64 {
        self.s_mm[self.first + node]
    }

    /// Ball centre at a node of the turn.
    pub fn centre(&self, node: usize) -> Point {
        self.turn[self.first + node].touch.centre
    }

    /// The next node after `k` from which a way to another may come to a place that is `apart_mm`
    /// from `k`: a curve is never longer than its arc.
    fn after(&self, k: usize, apart_mm: f64) -> usize {
        let free = self.s_mm[k] + (apart_mm - self.longest_mm).max(0.0);
        (k + 1).max(self.s_mm.partition_point(|s| *s < free).saturating_sub(1))
    }

    /// Whether the turn comes nearer to `q`, which is a neighbour of its node `of`, than
    /// `least_mm`.
    pub fn is_nearer(&self, q: &Point, of: usize, least_mm: f64) -> bool {
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
    pub fn without_loops(&self) -> Vec<Node> {
        let nodes = &self.turn;
        let way = |k: usize| [&nodes[k].touch, &nodes[k + 1].touch];
        // The way from a node may come towards it by its own length.
        self.shortened(self.longest_mm, |at, k| (k + 1 < nodes.len() && cross(way(at), way(k))).then_some(k + 1))
    }

    /// The turn without the stretches in which it goes round an island narrower than `width_mm`:
    /// away from the side of the turns after it, and back to near where it left.
    pub fn without_islands(&self, width_mm: f64) -> Vec<Node> {
        self.shortened(width_mm, |at, k| {
            let apart_mm = (self.turn[k].touch.centre - self.turn[at].touch.centre).norm();
            let round_mm = self.s_mm[k] - self.s_mm[at];
            let is_narrow = apart_mm < width_mm && round_mm > (ROUND_ISLAND * apart_mm).max(width_mm);
            (is_narrow && runs_to_the_left(&self.turn[at..=k])).then_some(k)
        })
    }

    /// The turn without the stretches that `ends` names: from a node and a later one that may be
    /// as near to it as `near_mm`, the node at which the turn goes on, if what lies between is left
    /// out. The farthest counts.
    fn shortened(&self, near_mm: f64, ends: impl Fn(usize, usize) -> Option<usize>) -> Vec<Node> {
        let (nodes, s_mm) = (&self.turn, &self.s_mm);
        let most_mm = LOOP * self.length_mm();
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
    pub fn farthest(&self, [from, to]: [usize; 2], q: &Point) -> usize {
        let away = |k: &usize| (self.turn[self.first + k].touch.centre - q).norm_squared();
        (from..=to).max_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(from)
    }

    /// The nearest places to `q` of the turn before its node `of` and after it, as far as `look_mm`
    /// beyond the nodes `from` and `to`.
    pub fn sides(&self, [from, of, to]: [usize; 3], look_mm: f64, q: &Point) -> [Point; 2] {
        let [from, of, to] = [from, of, to].map(|k| self.first + k);
        let lo = self.s_mm.partition_point(|s| *s < self.s_mm[from] - look_mm);
        let hi = self.s_mm.partition_point(|s| *s <= self.s_mm[to] + look_mm);
        let nearest = |nodes: &[Node]| {
            let places = nodes.windows(2).map(|w| closest_on_segment(&w[0].touch.centre, &w[1].touch.centre, q));
            let least = places.min_by(|a, b| (a - q).norm_squared().total_cmp(&(b - q).norm_squared()));
            least.unwrap_or(self.turn[of].touch.centre)
        };
        [nearest(&self.turn[lo..=of]), nearest(&self.turn[of..hi])]
    }
}

/// Whether a stretch of a turn, closed by a straight way, encloses what lies to the left of the
/// straight way: it is run clockwise, seen along the surface's normals.
fn runs_to_the_left(stretch: &[Node]) -> bool {
    let from = stretch[0].touch.centre;
    let area: Vector = stretch.windows(2).map(|w| (w[0].touch.centre - from).cross(&(w[1].touch.centre - from))).sum();
    let normals: Vector = stretch.iter().map(|n| n.touch.normal).sum();
    area.dot(&normals) < 0.0
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

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(places: &[(f64, f64)], up: f64) -> Vec<Node> {
        let normal = Vector::new(0.0, 0.0, up);
        let touch = |p: &(f64, f64)| {
            let contact = Point::new(p.0, p.1, 0.0);
            Touch { centre: contact + normal, contact, normal, face: 0 }
        };
        places.iter().map(|p| Node { touch: touch(p), way_mm: 1.0, stop: None }).collect()
    }

    fn places(nodes: &[Node]) -> Vec<(f64, f64)> {
        nodes.iter().map(|n| (n.touch.centre.x, n.touch.centre.y)).collect()
    }

    fn without_loops(nodes: &[Node]) -> Vec<Node> {
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
    fn the_other_side_of_a_thin_part_is_not_crossed() {
        // Along a diagonal of a plate and, on its other side, across it.
        let diagonal: Vec<_> = (0..20).map(|k| (0.5 * f64::from(k), 0.5 * f64::from(k))).collect();
        let back: Vec<_> = (0..20).map(|k| (0.5 * f64::from(k), 9.6 - 0.5 * f64::from(k))).collect();
        let both = |up: f64| [nodes(&diagonal, 1.0), nodes(&back, up), nodes(&[(40.0, 0.0)], 1.0)].concat();
        assert_eq!(without_loops(&both(-1.0)).len(), both(-1.0).len());
        assert!(without_loops(&both(1.0)).len() < both(1.0).len());
    }
}
