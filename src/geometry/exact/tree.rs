//! A bounding-volume tree of eight children a node, over boxes along the axes.
//!
//! Boxes are kept in single precision about the middle of everything, rounded outwards, component by component, so that one
//! node is tested by a few vector instructions. Built by the surface-area heuristic in bins (Wald, *On fast construction of SAH-based
//! bounding volume hierarchies*, 2007); deterministic.

use crate::geometry::{Aabb, Point, Vector};

/// Children of a node.
pub(super) const WIDTH: usize = 8;
/// An empty place.
const NONE: u32 = u32::MAX;
/// Set in a child that is a node.
const NODE: u32 = 1 << 31;
const BINS: usize = 12;

/// One node: boxes by component, and what they hold.
#[derive(Clone, Debug)]
struct Node {
    low: [[f32; WIDTH]; 3],
    high: [[f32; WIDTH]; 3],
    child: [u32; WIDTH],
}

/// What a node's box holds.
pub(super) enum Child {
    /// A node, to be opened.
    Node(u32),
    /// The item of this index.
    Item(u32),
}

/// The tree.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    middle: Point,
    /// Within this distance of the middle single precision holds, mm.
    reach_mm: f64,
}

/// A query point, in the tree's own frame.
pub(super) struct Seen {
    single: [f32; 3],
    double: Vector,
    far: bool,
}

impl Tree {
    /// Over boxes; the item's index is that of its box.
    pub fn new(boxes: &[Aabb]) -> Self {
        let all = boxes.iter().fold(None, |a: Option<Aabb>, b| {
            Some(a.map_or(*b, |a| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) }))
        });
        let middle = all.map_or_else(Point::origin, |a| nalgebra::center(&a.min, &a.max));
        let size = all.map_or(0.0, |a| a.diagonal_mm());
        let mut tree = Tree { nodes: Vec::new(), middle, reach_mm: 4.0 * size };
        let mut items: Vec<u32> = (0..boxes.len() as u32).collect();
        if !items.is_empty() {
            tree.add(boxes, &mut items, 1e-6 * size);
        }
        tree
    }

    /// A node for these items; its number.
    fn add(&mut self, boxes: &[Aabb], items: &mut [u32], slack: f64) -> u32 {
        let number = self.nodes.len();
        let empty = [[f32::INFINITY; WIDTH]; 3];
        self.nodes.push(Node { low: empty, high: empty.map(|x| x.map(|y| -y)), child: [NONE; WIDTH] });
        let group = |items: &[u32], from: usize, to: usize| {
            (from, to, if to - from < 2 { -1.0 } else { area(&around(boxes, &items[from..to])) })
        };
        let mut groups = vec![group(items, 0, items.len())];
        while groups.len() < WIDTH {
            // The group with the greatest surface is cut next.
            let most = (0..groups.len()).max_by(|a, b| groups[*a].2.total_cmp(&groups[*b].2).then(b.cmp(a)));
            let Some((k, &(from, to, _))) = most.and_then(|k| Some((k, groups.get(k)?))) else { break };
            if to - from < 2 {
                break;
            }
            let cut = from + split(boxes, &mut items[from..to]);
            groups[k] = group(items, from, cut);
            groups.push(group(items, cut, to));
        }
        for (k, (from, to, _)) in groups.into_iter().enumerate() {
            let b = around(boxes, &items[from..to]);
            let child = if to - from == 1 { items[from] } else { NODE | self.add(boxes, &mut items[from..to], slack) };
            let node = &mut self.nodes[number];
            for a in 0..3 {
                node.low[a][k] = (b.min[a] - self.middle[a] - slack) as f32;
                node.high[a][k] = (b.max[a] - self.middle[a] + slack) as f32;
            }
            node.child[k] = child;
        }
        number as u32
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Prepares a query point.
    pub fn see(&self, q: &Point) -> Seen {
        let r = q - self.middle;
        Seen { single: [r.x as f32, r.y as f32, r.z as f32], double: r, far: !(r.norm() < self.reach_mm) }
    }

    /// Hands the children of a node nearer than `limit2` (squared, mm²) to `visit`, with the squared distance to their boxes.
    #[inline]
    pub fn open(&self, node: u32, q: &Seen, limit2: impl Fn() -> f64, mut visit: impl FnMut(Child, f64)) {
        let node = &self.nodes[node as usize];
        let d2 = if q.far { node.far_distances2(&q.double) } else { node.distances2(&q.single) };
        for k in 0..WIDTH {
            let child = node.child[k];
            let d2 = f64::from(d2[k]);
            if child != NONE && d2 < limit2() {
                visit(if child & NODE != 0 { Child::Node(child & !NODE) } else { Child::Item(child) }, d2);
            }
        }
    }
}

impl Tree {
    /// Hands all children of a node to `visit`, with the middles and half sides of their boxes.
    pub fn children(&self, node: u32, mut visit: impl FnMut(Child, &Point, &Vector)) {
        let node = &self.nodes[node as usize];
        for (k, child) in node.child.iter().enumerate().filter(|(_, c)| **c != NONE) {
            let low = Vector::from([0, 1, 2].map(|a| f64::from(node.low[a][k])));
            let high = Vector::from([0, 1, 2].map(|a| f64::from(node.high[a][k])));
            let what = if child & NODE != 0 { Child::Node(child & !NODE) } else { Child::Item(*child) };
            visit(what, &(self.middle + (low + high) * 0.5), &((high - low) * 0.5));
        }
    }
}

impl Node {
    /// Squared distances to all boxes.
    #[inline]
    fn distances2(&self, q: &[f32; 3]) -> [f32; WIDTH] {
        let mut sum = [0.0f32; WIDTH];
        for a in 0..3 {
            for k in 0..WIDTH {
                let (below, above) = (self.low[a][k] - q[a], q[a] - self.high[a][k]);
                let over = if below > above { below } else { above };
                let over = if over > 0.0 { over } else { 0.0 };
                sum[k] += over * over;
            }
        }
        // What the sums may have gained by rounding.
        sum.map(|x| x * (1.0 - 1e-6))
    }

    /// The same for points so far away that single precision would not do.
    fn far_distances2(&self, q: &Vector) -> [f32; WIDTH] {
        let mut out = [0.0f32; WIDTH];
        for k in 0..WIDTH {
            let over = |a: usize| (f64::from(self.low[a][k]) - q[a]).max(q[a] - f64::from(self.high[a][k])).max(0.0);
            out[k] = ((over(0).powi(2) + over(1).powi(2) + over(2).powi(2)) * (1.0 - 1e-6)) as f32;
        }
        out
    }
}

fn around(boxes: &[Aabb], items: &[u32]) -> Aabb {
    let first = boxes[items[0] as usize];
    items.iter().fold(first, |a, i| {
        let b = &boxes[*i as usize];
        Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) }
    })
}

fn area(b: &Aabb) -> f64 {
    let d = b.max - b.min;
    d.x * d.y + d.y * d.z + d.z * d.x
}

/// Orders the items so that those before the returned place and the others make two good groups; at least one in each.
fn split(boxes: &[Aabb], items: &mut [u32]) -> usize {
    let centre = |i: u32, a: usize| boxes[i as usize].min[a] + boxes[i as usize].max[a];
    let mut best: Option<(f64, usize, f64)> = None;
    for axis in 0..3 {
        let (low, high) = items.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), i| {
            let c = centre(*i, axis);
            (l.min(c), h.max(c))
        });
        if !(high > low) {
            continue;
        }
        let bin = |i: u32| (((centre(i, axis) - low) / (high - low) * BINS as f64) as usize).min(BINS - 1);
        let mut bins: [Option<(usize, Aabb)>; BINS] = [None; BINS];
        for &i in items.iter() {
            let b = boxes[i as usize];
            bins[bin(i)] = merge(bins[bin(i)], Some((1, b)));
        }
        for cut in 1..BINS {
            let side = |r: std::ops::Range<usize>| bins[r].iter().fold(None, |a, b| merge(a, *b));
            let (Some(l), Some(r)) = (side(0..cut), side(cut..BINS)) else { continue };
            let cost = l.0 as f64 * area(&l.1) + r.0 as f64 * area(&r.1);
            if best.is_none_or(|b| cost < b.0) {
                best = Some((cost, axis, low + (high - low) * cut as f64 / BINS as f64));
            }
        }
    }
    if let Some((_, axis, at)) = best {
        items.sort_by_key(|i| centre(*i, axis) >= at);
        let cut = items.partition_point(|i| centre(*i, axis) < at);
        if cut > 0 && cut < items.len() {
            return cut;
        }
    }
    items.len() / 2
}

fn merge(a: Option<(usize, Aabb)>, b: Option<(usize, Aabb)>) -> Option<(usize, Aabb)> {
    match (a, b) {
        (Some((n, x)), Some((m, y))) => Some((n + m, Aabb { min: x.min.inf(&y.min), max: x.max.sup(&y.max) })),
        (x, None) => x,
        (None, y) => y,
    }
}
