//! A bounding-volume tree of eight children a node, over boxes turned along what they hold.
//!
//! Every node has a frame of its own, along the surface in it, in which the boxes of its children
//! lie. Strips of an airfoil are thin and aslant: boxes along the axes would overlap one another,
//! boxes along the surface do not. The same frame bounds what normals a child's surface has: a
//! child on which no normal passes the query point holds no foot of it.
//!
//! Boxes are kept in single precision about the middle of everything, rounded outwards, component
//! by component, so that one node is tested by a few vector instructions. Built by the surface-area
//! heuristic in bins (Wald, *On fast construction of SAH-based bounding volume hierarchies*, 2007);
//! deterministic.

use nalgebra::{Matrix3, Rotation3};

use crate::geometry::{Aabb, Point, Vector};

/// Children of a node.
pub(super) const WIDTH: usize = 8;
/// An empty place.
const NONE: u32 = u32::MAX;
/// Set in a child that is a node.
const NODE: u32 = 1 << 31;
const BINS: usize = 12;
/// A normal farther from a node's third axis than this, cosine, is not bounded in its frame.
const STEEP: f64 = 0.1;
/// Slopes of whatever normals.
const UNKNOWN: [f64; 2] = [-1e30, 1e30];
/// What feet may be off by, mm: Newton's accuracy.
const FOOT_MM: f32 = 1e-6;

/// What an item of the tree lies in.
pub(super) struct Hull {
    /// Middle of a box.
    pub middle: Point,
    /// Its half sides, at right angles to each other; the first two along the surface.
    pub sides: [Vector; 3],
    /// The item reaches beyond the box by no more than this, mm.
    pub round: f64,
    /// Every normal of the item, either way, lies in the cone of these; `None`: not known, or its
    /// nearest point may be no foot.
    pub normals: Option<[Vector; 4]>,
}

impl Hull {
    fn along(&self, axis: &Vector) -> f64 {
        self.sides.iter().map(|s| s.dot(axis).abs()).sum::<f64>() + self.round
    }

    /// Tangents of the angles between the normals and the third axis, seen along the first and the
    /// second: least and greatest.
    fn slopes(&self, [a, b, c]: &[Vector; 3]) -> [[f64; 2]; 2] {
        let Some(normals) = &self.normals else { return [UNKNOWN; 2] };
        let side = normals[0].dot(c).signum();
        let mut out = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for n in normals {
            let height = n.dot(c) * side;
            if !(height > STEEP * n.norm()) {
                return [UNKNOWN; 2];
            }
            // Over a cone these quotients are least and greatest at its corners.
            for (range, axis) in out.iter_mut().zip([a, b]) {
                let slope = n.dot(axis) * side / height;
                *range = [range[0].min(slope), range[1].max(slope)];
            }
        }
        out
    }
}

/// One node: boxes in its frame by component, and what they hold.
#[derive(Clone, Debug)]
struct WideNode {
    axes: [Vector; 3],
    low: [[f32; WIDTH]; 3],
    high: [[f32; WIDTH]; 3],
    /// Middle and half of the range of [`Hull::slopes`], of all that the child holds.
    slope: [[f32; WIDTH]; 2],
    spread: [[f32; WIDTH]; 2],
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
    nodes: Vec<WideNode>,
    middle: Point,
    /// Within this distance of the middle single precision holds, mm.
    reach_mm: f64,
}

/// A query point, in the tree's own frame.
pub(super) struct Seen {
    from_middle: Vector,
    far: bool,
}

impl Tree {
    /// Over hulls; the item's index is that of its hull.
    pub fn new(hulls: &[Hull]) -> Self {
        let world = [Vector::x(), Vector::y(), Vector::z()];
        let about = |h: &Hull| boxed(h, &world, &Point::origin());
        let all = hulls.iter().fold(None, |a: Option<Aabb>, h| {
            let b = about(h);
            Some(a.map_or(b, |a| Aabb { min: a.min.inf(&b.min), max: a.max.sup(&b.max) }))
        });
        let middle = all.map_or_else(Point::origin, |a| nalgebra::center(&a.min, &a.max));
        let size = all.map_or(0.0, |a| a.diagonal_mm());
        let mut tree = Tree { nodes: Vec::new(), middle, reach_mm: 4.0 * size };
        let mut items: Vec<u32> = (0..hulls.len() as u32).collect();
        let mut boxes = vec![Aabb { min: middle, max: middle }; hulls.len()];
        if !items.is_empty() {
            tree.add(hulls, &mut boxes, &mut items, 1e-6 * size);
        }
        tree
    }

    /// A node for these items; its number. `boxes` is storage.
    fn add(&mut self, hulls: &[Hull], boxes: &mut [Aabb], items: &mut [u32], slack: f64) -> u32 {
        let number = self.nodes.len();
        let axes = frame(hulls, items);
        items.iter().for_each(|i| boxes[*i as usize] = boxed(&hulls[*i as usize], &axes, &self.middle));
        let groups = groups(boxes, items);
        let mut node = WideNode::empty(axes);
        for (k, (from, to)) in groups.iter().enumerate() {
            let b = around(boxes, &items[*from..*to]);
            for a in 0..3 {
                node.low[a][k] = (b.min[a] - slack) as f32;
                node.high[a][k] = (b.max[a] + slack) as f32;
            }
            let mut slopes = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
            for i in &items[*from..*to] {
                for (range, own) in slopes.iter_mut().zip(hulls[*i as usize].slopes(&axes)) {
                    *range = [range[0].min(own[0]), range[1].max(own[1])];
                }
            }
            for (a, [least, greatest]) in slopes.into_iter().enumerate() {
                node.slope[a][k] = (0.5 * (least + greatest)) as f32;
                let rounding = 1e-5 * least.abs().max(greatest.abs()) + 1e-6;
                node.spread[a][k] = (0.5 * (greatest - least) + rounding) as f32;
            }
        }
        self.nodes.push(node);
        for (k, (from, to)) in groups.into_iter().enumerate() {
            let child =
                if to - from == 1 { items[from] } else { NODE | self.add(hulls, boxes, &mut items[from..to], slack) };
            self.nodes[number].child[k] = child;
        }
        number as u32
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Prepares a query point.
    pub fn see(&self, q: &Point) -> Seen {
        let from_middle = q - self.middle;
        Seen { from_middle, far: !(from_middle.norm() < self.reach_mm) }
    }

    /// Hands the children of a node nearer than `limit2` (squared, mm²) to `visit`, with the
    /// squared distance to their boxes; with `feet` only those that may hold a foot.
    #[inline]
    pub fn open(&self, node: u32, q: &Seen, feet: bool, limit2: f64, mut visit: impl FnMut(Child, f64)) {
        let node = &self.nodes[node as usize];
        let (r, [a, b, c]) = (&q.from_middle, &node.axes);
        let local = [a.dot(r), b.dot(r), c.dot(r)];
        let single = [local[0] as f32, local[1] as f32, local[2] as f32];
        let d2 = if q.far { node.far_distances2(&local) } else { node.distances2(&single, feet) };
        for k in 0..WIDTH {
            let child = node.child[k];
            let d2 = f64::from(d2[k]);
            if child != NONE && d2 < limit2 {
                visit(if child & NODE != 0 { Child::Node(child & !NODE) } else { Child::Item(child) }, d2);
            }
        }
    }

    /// Hands all children of a node to `visit`, with the middles and half sides of their boxes.
    pub fn children(&self, node: u32, mut visit: impl FnMut(Child, &Point, &[Vector; 3])) {
        let node = &self.nodes[node as usize];
        for (k, child) in node.child.iter().enumerate().filter(|(_, c)| **c != NONE) {
            let ends = |a: usize| [node.low[a][k], node.high[a][k]].map(f64::from);
            let middle: Vector = (0..3).map(|a| node.axes[a] * (0.5 * (ends(a)[0] + ends(a)[1]))).sum();
            let sides = [0, 1, 2].map(|a| node.axes[a] * (0.5 * (ends(a)[1] - ends(a)[0])));
            let what = if child & NODE != 0 { Child::Node(child & !NODE) } else { Child::Item(*child) };
            visit(what, &(self.middle + middle), &sides);
        }
    }
}

impl WideNode {
    fn empty(axes: [Vector; 3]) -> Self {
        let low = [[f32::INFINITY; WIDTH]; 3];
        WideNode {
            axes,
            low,
            high: low.map(|x| x.map(|y| -y)),
            slope: [[0.0; WIDTH]; 2],
            spread: [[0.0; WIDTH]; 2],
            child: [NONE; WIDTH],
        }
    }

    /// Squared distances to all boxes; infinite, with `feet`, where there is no foot.
    #[inline]
    fn distances2(&self, q: &[f32; 3], feet: bool) -> [f32; WIDTH] {
        let mut sum = [0.0f32; WIDTH];
        for a in 0..3 {
            for k in 0..WIDTH {
                let (below, above) = (self.low[a][k] - q[a], q[a] - self.high[a][k]);
                let most = if below > above { below } else { above };
                let over = if most > 0.0 { most } else { 0.0 };
                sum[k] += over * over;
            }
        }
        // What the sums may have gained by rounding.
        sum.iter_mut().for_each(|x| *x *= 1.0 - 1e-6);
        if feet {
            for k in 0..WIDTH {
                // A foot lies where q is seen from it along a normal: the height of q above it,
                // times a slope, aside.
                let (from_low, from_high) = (q[2] - self.low[2][k], q[2] - self.high[2][k]);
                let height = 0.5 * (from_low + from_high);
                let thick = 0.5 * (from_low - from_high) + FOOT_MM;
                let mut none = false;
                for a in 0..2 {
                    let (slope, spread) = (self.slope[a][k], self.spread[a][k]);
                    let foot = q[a] - height * slope;
                    let about = height.abs() * spread + thick * (slope.abs() + spread) + FOOT_MM;
                    none |= (foot > self.high[a][k] + about) | (foot < self.low[a][k] - about);
                }
                sum[k] = if none { f32::INFINITY } else { sum[k] };
            }
        }
        sum
    }

    /// The same for points so far away that single precision would not do; wherever feet may be.
    fn far_distances2(&self, q: &[f64; 3]) -> [f32; WIDTH] {
        let mut out = [0.0f32; WIDTH];
        for k in 0..WIDTH {
            let over = |a: usize| (f64::from(self.low[a][k]) - q[a]).max(q[a] - f64::from(self.high[a][k])).max(0.0);
            let d2 = (over(0).powi(2) + over(1).powi(2) + over(2).powi(2)) * (1.0 - 1e-6);
            // Beyond single precision a box is very far, not nowhere: an infinite distance would
            // shut it for good.
            out[k] = d2.min(f64::from(f32::MAX)) as f32;
        }
        out
    }
}

/// Axes along the surface of these items: the first where it is longest, the third its mean normal.
fn frame(hulls: &[Hull], items: &[u32]) -> [Vector; 3] {
    let (mut normals, mut weight, mut mean) = (Matrix3::zeros(), 0.0, Vector::zeros());
    let of = |i: &u32| &hulls[*i as usize];
    let faces = |h: &Hull| h.sides[0].cross(&h.sides[1]);
    // Edges have a length, no area: a little weight, so that they count where there is nothing
    // else.
    let weigh = |h: &Hull| faces(h).norm() + 1e-6 * h.sides[0].norm_squared();
    for h in items.iter().map(of) {
        let n = faces(h);
        normals += n * n.transpose() / n.norm().max(f64::MIN_POSITIVE);
        mean += h.middle.coords * weigh(h);
        weight += weigh(h);
    }
    mean /= weight.max(f64::MIN_POSITIVE);
    let mut spread = Matrix3::zeros();
    for h in items.iter().map(of) {
        let r = h.middle.coords - mean;
        let own: Matrix3<f64> = h.sides.iter().map(|s| s * s.transpose()).sum();
        spread += (r * r.transpose() + own / 3.0) * weigh(h);
    }
    let greatest = |m: Matrix3<f64>| {
        let scale = m.amax();
        if !(scale > 0.0 && scale.is_finite()) {
            return None;
        }
        let e = (m / scale).symmetric_eigen();
        e.eigenvectors.column(e.eigenvalues.imax()).into_owned().try_normalize(0.5)
    };
    let third =
        greatest(normals).or_else(|| greatest(spread).map(|d| Rotation3::face_towards(&d, &across(&d)) * Vector::x()));
    let c = third.unwrap_or_else(Vector::z);
    let flat = Matrix3::identity() - c * c.transpose();
    let a = greatest(flat * spread * flat).map(|a| a - c * a.dot(&c)).and_then(|a| a.try_normalize(0.5));
    let a = a.unwrap_or_else(|| across(&c));
    [a, c.cross(&a), c]
}

/// A unit vector at right angles to another.
fn across(n: &Vector) -> Vector {
    let other = if n.x.abs() < 0.5 { Vector::x() } else { Vector::y() };
    n.cross(&other).normalize()
}

/// The box of an item along axes, about an origin.
fn boxed(h: &Hull, axes: &[Vector; 3], origin: &Point) -> Aabb {
    let r = h.middle - origin;
    let middle = Vector::from([0, 1, 2].map(|a| axes[a].dot(&r)));
    let half = Vector::from([0, 1, 2].map(|a| h.along(&axes[a])));
    Aabb { min: Point::from(middle - half), max: Point::from(middle + half) }
}

/// Orders the items into at most [`WIDTH`] groups; where each begins and ends.
fn groups(boxes: &[Aabb], items: &mut [u32]) -> Vec<(usize, usize)> {
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
    groups.into_iter().map(|(from, to, _)| (from, to)).collect()
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

/// Orders the items so that those before the returned place and the others make two good groups; at
/// least one in each.
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
        // Sums from below and from above meet at every cut.
        let mut below = [None; BINS];
        for cut in 1..BINS {
            below[cut] = merge(below[cut - 1], bins[cut - 1]);
        }
        let mut above = None;
        for cut in (1..BINS).rev() {
            above = merge(above, bins[cut]);
            let (Some(l), Some(r)) = (below[cut], above) else { continue };
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Numbers in -1..1 in a fixed order (SplitMix64).
    struct Spread(u64);

    impl Spread {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = self.0;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            2.0 * (((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64) - 1.0
        }
        fn vector(&mut self) -> Vector {
            Vector::new(self.next(), self.next(), self.next())
        }
    }

    /// The item of which `p` is a point is reached from `q`, where `q - p` is a normal of it.
    fn reached(tree: &Tree, q: &Point, p: &Point, item: u32) -> bool {
        let (seen, limit2) = (tree.see(q), (q - p).norm_squared() * (1.0 + 1e-9) + 1e-12);
        let (mut open, mut found) = (vec![0], false);
        while let Some(node) = open.pop() {
            tree.open(node, &seen, true, limit2, |child, _| match child {
                Child::Node(n) => open.push(n),
                Child::Item(i) => found |= i == item,
            });
        }
        found
    }

    /// Thin boxes askew, some rounded, some of unknown normals; points on normals of theirs, near
    /// and so far that single precision would not do.
    #[test]
    fn no_foot_is_lost() {
        let mut s = Spread(1);
        let hull = |k: usize, s: &mut Spread| {
            let n = s.vector().normalize();
            let a = across(&n);
            let (sides, slope) = ([a * (2.0 + s.next()), n.cross(&a) * (0.5 + 0.4 * s.next()), n * 0.02], 0.1);
            let b = n.cross(&a);
            let cone = [n + (a + b) * slope, n + (a - b) * slope, n - (a - b) * slope, n - (a + b) * slope];
            let normals = (!k.is_multiple_of(5)).then_some(cone);
            Hull {
                middle: Point::from(s.vector() * 50.0),
                sides,
                round: if k.is_multiple_of(7) { 0.3 } else { 0.0 },
                normals,
            }
        };
        let hulls: Vec<Hull> = (0..700).map(|k| hull(k, &mut s)).collect();
        let tree = Tree::new(&hulls);
        for k in 0..20_000 {
            let item = k % hulls.len();
            let h = &hulls[item];
            let p =
                h.middle + h.sides.iter().map(|side| side * s.next()).sum::<Vector>() + s.vector() * (h.round / 2.0);
            let n = match &h.normals {
                Some(c) => c.iter().map(|v| v * (1.0 + s.next())).sum::<Vector>().try_normalize(1e-9).unwrap_or(c[0]),
                None => s.vector().normalize(),
            };
            let far = [1.0, 30.0, 3e5, 1e22][k % 4];
            let q = p + n * (s.next() * far);
            assert!(reached(&tree, &q, &p, item as u32), "{k}: item {item}");
        }
    }

    /// How many nodes are opened for a point, and the items that may hold its foot.
    fn looked_at(tree: &Tree, q: &Point) -> (usize, Vec<u32>) {
        let (seen, mut open, mut nodes, mut items) = (tree.see(q), vec![0], 0, Vec::new());
        while let Some(node) = open.pop() {
            nodes += 1;
            tree.open(node, &seen, true, f64::INFINITY, |child, _| match child {
                Child::Node(n) => open.push(n),
                Child::Item(i) => items.push(i),
            });
        }
        (nodes, items)
    }

    /// What is left out is worth it: of a strip of pieces few are looked at.
    #[test]
    fn strips_aslant_are_told_apart() {
        let n = Vector::new(1.0, 1.0, 1.0).normalize();
        let a = across(&n);
        let hull = |k: usize| {
            let sides = [a * 5.0, n.cross(&a) * 0.5, n * 0.001];
            let cone = [n; 4];
            Hull { middle: Point::origin() + n.cross(&a) * k as f64, sides, round: 0.0, normals: Some(cone) }
        };
        let hulls: Vec<Hull> = (0..1000).map(hull).collect();
        let items = looked_at(&Tree::new(&hulls), &(hulls[500].middle + n * 40.0)).1;
        assert!(items.len() <= 2, "{items:?}");
    }

    /// Over a hollow the piece under the point is distinguished from those beside it: their normals
    /// lie on one side of its own.
    #[test]
    fn a_hollow_is_looked_at_where_its_foot_is() {
        let (count, radius) = (400, 50.0);
        let half = 0.25 * std::f64::consts::PI / f64::from(count);
        let out = |k: u32| {
            let (s, c) = (f64::from(2 * k + 1) * half).sin_cos();
            (Vector::new(c, s, 0.0), Vector::new(-s, c, 0.0))
        };
        let hull = |k: u32| {
            let (n, along) = out(k);
            let sides = [Vector::z() * 5.0, along * (radius * half), n * (radius * half * half)];
            let cone = [1.0, 1.0, -1.0, -1.0].map(|x| n + along * (x * half));
            Hull { middle: Point::from(n * radius), sides, round: 0.0, normals: Some(cone) }
        };
        let tree = Tree::new(&(0..count).map(hull).collect::<Vec<_>>());
        for k in 0..count {
            let (nodes, items) = looked_at(&tree, &Point::from(out(k).0 * (0.3 * radius) + Vector::z()));
            assert!(items.contains(&k) && items.len() <= 7 && nodes <= 15, "{k}: {items:?}, {nodes} nodes");
        }
    }
}
