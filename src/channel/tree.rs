//! A tree of bounding spheres and boxes over the triangles of the part.

use crate::geometry::mesh::Mesh;
use crate::geometry::triangle::area_mm2;
use crate::geometry::{Point, Rigid, Vector};
use crate::parallel;

/// A node: the sphere and the box around all its triangles, about the same centre; its first child
/// follows it in the list.
#[derive(Clone, Copy, Debug)]
pub(super) struct SphereNode {
    pub centre: Point,
    pub radius: f64,
    /// Half sides of the box.
    pub half: [Vector; 3],
    /// Index of the second child, or, for a leaf, `LEAF` + piece.
    link: u32,
}

const LEAF: u32 = 1 << 31;
/// A node around nothing.
const EMPTY: SphereNode =
    SphereNode { centre: Point::new(0.0, 0.0, 0.0), radius: 0.0, half: [Vector::new(0.0, 0.0, 0.0); 3], link: 0 };

/// What is below a node.
pub(super) enum Below {
    /// Two nodes.
    Nodes(u32, u32),
    /// A leaf: one piece of a triangle.
    Leaf(u32),
}

/// The tree; node 0 is the root. Its leaves are triangles of the part, large ones in pieces.
pub(super) struct SphereTree {
    nodes: Vec<SphereNode>,
    pieces: Vec<[Point; 3]>,
    /// Smallest spheres around the pieces.
    spheres: Vec<(Point, f64)>,
    parents: Vec<u32>,
}

/// Cutting large triangles makes no more than this many pieces besides one a triangle.
const MOST_PIECES: usize = 200_000;
/// Pieces are allowed to be longer by this factor until they are few enough.
const COARSER: f64 = 1.4;

impl SphereTree {
    /// Halves the pieces at the median along the longest side of their centres' box; deterministic.
    /// Triangles are cut until their sides are no longer than `side_mm`: one that reaches far round
    /// the tool is hard to bound, and would be cut anew for every location.
    pub fn new(mesh: &Mesh, side_mm: f64) -> Self {
        let corners: Vec<[Point; 3]> = (0..mesh.triangles.len()).map(|t| mesh.corners(t)).collect();
        let parents: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
        Self::of(&corners, &parents, side_mm)
    }

    /// As [`Self::new`] for triangles that each belong to one of a mesh, in rising order.
    pub fn of(corners: &[[Point; 3]], parents: &[u32], side_mm: f64) -> Self {
        let area_mm2: f64 = corners.iter().map(area_mm2).sum();
        let mut side_mm = finest_mm(side_mm, area_mm2);
        let (pieces, parents) = loop {
            match cut(corners, parents, side_mm) {
                Some(found) => break found,
                None => side_mm *= COARSER,
            }
        };
        let centres: Vec<Point> =
            pieces.iter().map(|[a, b, c]| Point::from((a.coords + b.coords + c.coords) / 3.0)).collect();
        let twice_areas: Vec<Vector> = pieces.iter().map(|[a, b, c]| (b - a).cross(&(c - a))).collect();
        let mut order: Vec<u32> = (0..pieces.len() as u32).collect();
        let mut nodes = vec![EMPTY; (2 * order.len()).saturating_sub(1)];
        if !order.is_empty() {
            Builder { pieces: &pieces, centres: &centres, twice_areas: &twice_areas }.build(&mut order, &mut nodes, 0);
        }
        let spheres = pieces.iter().map(around_triangle).collect();
        SphereTree { nodes, pieces, spheres, parents }
    }

    /// As [`Self::new`] for a mesh of copies, each with as many triangles and in this order: the
    /// tree of the first is built, and turned for the others.
    pub fn of_copies(mesh: &Mesh, copies: &[Rigid], side_mm: f64) -> Self {
        let count = mesh.triangles.len() / copies.len().max(1);
        let Some(first) = copies.first().filter(|_| count > 0 && count * copies.len() == mesh.triangles.len()) else {
            return Self::new(mesh, side_mm);
        };
        let area_mm2 = (0..mesh.triangles.len()).map(|t| mesh.triangle_area_mm2(t)).sum();
        let corners: Vec<[Point; 3]> = (0..count).map(|t| mesh.corners(t)).collect();
        let parents: Vec<u32> = (0..count as u32).collect();
        let one = Self::of(&corners, &parents, finest_mm(side_mm, area_mm2));
        let turns: Vec<Rigid> = copies.iter().map(|c| c * first.inverse()).collect();
        let pieces = turns.iter().flat_map(|c| one.pieces.iter().map(move |p| p.map(|p| c * p))).collect();
        let spheres = turns.iter().flat_map(|c| one.spheres.iter().map(move |(p, r)| (c * p, *r))).collect();
        let parents = (0..turns.len()).flat_map(|k| one.parents.iter().map(move |t| (k * count) as u32 + t)).collect();
        let nodes = Vec::with_capacity(2 * turns.len() * one.pieces.len());
        let mut tree = SphereTree { nodes, pieces, spheres, parents };
        tree.join(&mut (0..turns.len()).collect::<Vec<_>>(), &one, &turns);
        tree
    }

    /// Makes the node of some copies of a tree, and all below it, behind the nodes that are there.
    fn join(&mut self, order: &mut [usize], one: &SphereTree, copies: &[Rigid]) {
        let here = self.nodes.len() as u32;
        let turned = |copy: usize, node: &SphereNode| {
            let turn = &copies[copy];
            SphereNode { centre: turn * node.centre, half: node.half.map(|h| turn * h), ..*node }
        };
        if let [copy] = order {
            let piece = (*copy * one.pieces.len()) as u32;
            let linked = |n: &SphereNode| n.link + if n.link >= LEAF { piece } else { here };
            self.nodes.extend(one.nodes.iter().map(|n| SphereNode { link: linked(n), ..turned(*copy, n) }));
            return;
        }
        let roots: Vec<SphereNode> = order.iter().map(|k| turned(*k, &one.nodes[0])).collect();
        let node = around_nodes(&roots);
        let side = Vector::from(node.half.map(|h| h.norm())).imax();
        let along = |k: &usize| (copies[*k] * one.nodes[0].centre)[side];
        self.nodes.push(node);
        order.sort_by(|a, b| along(a).total_cmp(&along(b)).then(a.cmp(b)));
        let (left, right) = order.split_at_mut(order.len() / 2);
        self.join(left, one, copies);
        self.nodes[here as usize].link = self.nodes.len() as u32;
        self.join(right, one, copies);
    }

    /// Corners of a piece.
    pub fn corners(&self, piece: u32) -> [Point; 3] {
        self.pieces[piece as usize]
    }

    /// A point of a piece, and the radius about it within which the piece lies.
    pub fn sphere(&self, piece: u32) -> (Point, f64) {
        self.spheres[piece as usize]
    }

    /// The triangle that a piece belongs to.
    pub fn triangle(&self, piece: u32) -> u32 {
        self.parents[piece as usize]
    }

    /// The first piece of a triangle.
    pub fn leaf_of(&self, triangle: u32) -> Option<u32> {
        let first = self.parents.partition_point(|t| *t < triangle);
        (self.parents.get(first) == Some(&triangle)).then_some(first as u32)
    }

    pub fn root(&self) -> Option<u32> {
        (!self.nodes.is_empty()).then_some(0)
    }

    pub fn node(&self, index: u32) -> &SphereNode {
        &self.nodes[index as usize]
    }

    pub fn below(&self, index: u32) -> Below {
        let link = self.nodes[index as usize].link;
        if link >= LEAF { Below::Leaf(link - LEAF) } else { Below::Nodes(index + 1, link) }
    }
}

/// The side to which triangles of an area in all can be cut in no more than [`MOST_PIECES`].
fn finest_mm(side_mm: f64, area_mm2: f64) -> f64 {
    side_mm.max((area_mm2 / MOST_PIECES as f64).sqrt())
}

/// The triangles cut until no side is longer than `side_mm`, and of which triangle each piece is;
/// `None` where they would be too many. They are counted, since needles, of next to no area, make
/// as many as their length asks for.
fn cut(whole: &[[Point; 3]], of: &[u32], side_mm: f64) -> Option<(Vec<[Point; 3]>, Vec<u32>)> {
    let count = whole.len();
    let (mut pieces, mut parents, mut open) = (Vec::with_capacity(count), Vec::with_capacity(count), Vec::new());
    for (corners, &parent) in whole.iter().zip(of) {
        open.push(*corners);
        while let Some(corners) = open.pop() {
            let [a, b, c] = corners;
            if [b - a, c - b, a - c].iter().any(|s| s.norm() > side_mm) {
                open.extend(halves(&corners));
            } else if pieces.len() < MOST_PIECES + count {
                pieces.push(corners);
                parents.push(parent);
            } else {
                return None;
            }
        }
    }
    Some((pieces, parents))
}

/// Triangles below a node from which on its halves are built at the same time.
const APART: usize = 4096;

/// What the nodes are made of.
struct Builder<'a> {
    pieces: &'a [[Point; 3]],
    centres: &'a [Point],
    /// Normals as long as twice the areas.
    twice_areas: &'a [Vector],
}

impl Builder<'_> {
    /// Makes the node of `order`'s triangles, and all below it, in `nodes`, twice as many less one,
    /// of which the first is the tree's node `here`. Recursion is as deep as log2 of their number.
    fn build(&self, order: &mut [u32], nodes: &mut [SphereNode], here: u32) {
        let (centre, half) = self.around(order);
        let corners = order.iter().flat_map(|&t| &self.pieces[t as usize]);
        let radius = corners.map(|p| (p - centre).norm_squared()).fold(0.0, f64::max).sqrt() * (1.0 + 1e-12);
        let Some((node, below)) = nodes.split_first_mut() else { return };
        if let [triangle] = order {
            *node = SphereNode { centre, radius, half, link: LEAF + *triangle };
            return;
        }
        let first = self.centres[order[0] as usize];
        let (lo, hi) = order.iter().fold((first, first), |(lo, hi), &t| {
            let c = self.centres[t as usize];
            (lo.inf(&c), hi.sup(&c))
        });
        let side = (hi - lo).imax();
        let middle = order.len() / 2;
        order.select_nth_unstable_by(middle, |&a, &b| {
            self.centres[a as usize][side].total_cmp(&self.centres[b as usize][side]).then(a.cmp(&b))
        });
        let second = here + 2 * middle as u32;
        *node = SphereNode { centre, radius, half, link: second };
        let large = order.len() > APART;
        let (left, right) = order.split_at_mut(middle);
        let (lefts, rights) = below.split_at_mut(2 * middle - 1);
        if large {
            parallel::both(|| self.build(left, lefts, here + 1), || self.build(right, rights, second));
        } else {
            self.build(left, lefts, here + 1);
            self.build(right, rights, second);
        }
    }

    /// A box around the triangles: its centre and half sides, the first along their mean normal,
    /// the second as near to the blade axis as possible. Patches of a wall are flat along their
    /// normal.
    fn around(&self, order: &[u32]) -> (Point, [Vector; 3]) {
        let corners = || order.iter().flat_map(|&t| &self.pieces[t as usize]);
        let Some(first) = corners().next() else { return (Point::origin(), [Vector::zeros(); 3]) };
        let twice_area = order.iter().map(|&t| self.twice_areas[t as usize]).sum::<Vector>();
        let normal = twice_area.try_normalize(1e-12).unwrap_or_else(Vector::y);
        let lengthwise = Vector::x() - normal * normal.x;
        let lengthwise = lengthwise.try_normalize(1e-3).unwrap_or_else(|| normal.cross(&Vector::y()).normalize());
        let axes = [normal, lengthwise, normal.cross(&lengthwise)];
        let seen = |p: &Point| Vector::from(axes.map(|a| a.dot(&(p - first))));
        let start = (Vector::zeros(), Vector::zeros());
        let (lo, hi) = corners().map(seen).fold(start, |(lo, hi), v| (lo.inf(&v), hi.sup(&v)));
        let (middle, half) = ((lo + hi) * 0.5, (hi - lo) * (0.5 + 1e-12));
        let centre = first + axes[0] * middle.x + axes[1] * middle.y + axes[2] * middle.z;
        (centre, [axes[0] * half.x, axes[1] * half.y, axes[2] * half.z])
    }
}

/// A node around others, its box along x, y and z, without children.
fn around_nodes(nodes: &[SphereNode]) -> SphereNode {
    let reach = |n: &SphereNode| n.half.iter().map(Vector::abs).sum::<Vector>();
    let ends = nodes.iter().map(|n| (n.centre - reach(n), n.centre + reach(n)));
    let Some((lo, hi)) = ends.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1))) else { return EMPTY };
    let (centre, half) = (nalgebra::center(&lo, &hi), (hi - lo) * (0.5 + 1e-12));
    let radius = nodes.iter().map(|n| (n.centre - centre).norm() + n.radius).fold(0.0, f64::max) * (1.0 + 1e-12);
    SphereNode { centre, radius, half: [Vector::x() * half.x, Vector::y() * half.y, Vector::z() * half.z], link: 0 }
}

/// The smallest sphere around a triangle; its centre is a point of the triangle.
pub(super) fn around_triangle(corners: &[Point; 3]) -> (Point, f64) {
    let [a, b, c] = corners;
    let sides = [(b - c).norm_squared(), (c - a).norm_squared(), (a - b).norm_squared()];
    let longest = longest(&sides);
    let (opposite, others) = match longest {
        0 => (sides[0], sides[1] + sides[2]),
        1 => (sides[1], sides[2] + sides[0]),
        _ => (sides[2], sides[0] + sides[1]),
    };
    let centre = if opposite >= others * (1.0 - 1e-9) {
        match longest {
            0 => nalgebra::center(b, c),
            1 => nalgebra::center(c, a),
            _ => nalgebra::center(a, b),
        }
    } else {
        let [x, y, z] = sides;
        let w = [x * (y + z - x), y * (z + x - y), z * (x + y - z)];
        Point::from((a.coords * w[0] + b.coords * w[1] + c.coords * w[2]) / (w[0] + w[1] + w[2]))
    };
    let radius = corners.iter().map(|p| (p - centre).norm_squared()).fold(0.0, f64::max).sqrt();
    (centre, radius * (1.0 + 1e-12))
}

/// Index of the longest of three sides.
fn longest(sides: &[f64; 3]) -> usize {
    if sides[0] >= sides[1] && sides[0] >= sides[2] {
        0
    } else if sides[1] >= sides[2] {
        1
    } else {
        2
    }
}

/// Halves a triangle at the middle of its longest side.
pub(super) fn halves(corners: &[Point; 3]) -> [[Point; 3]; 2] {
    let [a, b, c] = *corners;
    let sides = [(b - c).norm_squared(), (c - a).norm_squared(), (a - b).norm_squared()];
    match longest(&sides) {
        0 => {
            let m = nalgebra::center(&b, &c);
            [[a, b, m], [a, m, c]]
        }
        1 => {
            let m = nalgebra::center(&c, &a);
            [[b, c, m], [b, m, a]]
        }
        _ => {
            let m = nalgebra::center(&a, &b);
            [[c, a, m], [c, m, b]]
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A metre of needles a hundredth thick: cut by their length alone they would make millions of
    /// pieces.
    #[test]
    fn needles_make_no_more_pieces_than_other_triangles() {
        let (n, length) = (3000, 1000.0);
        let mut mesh = Mesh::default();
        for k in 0..n {
            let y = 0.01 * f64::from(k);
            mesh.points.extend([
                Point::new(0.0, y, 0.0),
                Point::new(length, y + 0.005, 0.0),
                Point::new(length, y + 0.01, 0.0),
            ]);
            mesh.triangles.push([3 * k as u32, 3 * k as u32 + 1, 3 * k as u32 + 2]);
        }
        let tree = SphereTree::new(&mesh, 1.0);
        assert!(tree.pieces.len() <= MOST_PIECES + mesh.triangles.len(), "{}", tree.pieces.len());
        assert!(tree.pieces.len() > 10 * mesh.triangles.len(), "{}", tree.pieces.len());
        // A few large triangles are cut as finely as asked.
        mesh.triangles.truncate(2);
        let tree = SphereTree::new(&mesh, 1.0);
        assert!(tree.pieces.len() > 2000 && tree.spheres.iter().all(|s| s.1 < 1.0), "{}", tree.pieces.len());
    }

    /// Every node of a tree of copies holds its pieces, and these are those of the turned mesh.
    #[test]
    fn copies_of_a_tree_are_a_tree_of_the_copies() {
        let mut mesh = Mesh::default();
        for k in 0..40 {
            let at = |i: f64| {
                Point::new(0.3 * f64::from(k), (1.7 * f64::from(k) + i).sin(), 20.0 + (f64::from(k) * i).cos())
            };
            mesh.points.extend([at(0.0), at(1.0), at(2.3)]);
            mesh.triangles.push([3 * k as u32, 3 * k as u32 + 1, 3 * k as u32 + 2]);
        }
        let copies: Vec<Rigid> = (1..8).map(|k| Rigid::rotation(Vector::x() * (0.7 * f64::from(k)))).collect();
        let mut all = Mesh::default();
        for moved in copies.iter().map(|c| mesh.clone().moved(c)) {
            let first = all.points.len() as u32;
            all.triangles.extend(moved.triangles.iter().map(|t| t.map(|p| first + p)));
            all.points.extend(moved.points);
        }
        let tree = SphereTree::of_copies(&all, &copies, 0.8);
        // Where they are no copies, it is the tree of the mesh.
        assert_eq!(SphereTree::of_copies(&all, &copies[..3], 0.8).nodes.len(), SphereTree::new(&all, 0.8).nodes.len());
        let mut met = vec![0; tree.pieces.len()];
        // From the root: the node, and those above it.
        let mut open = vec![(0, vec![])];
        while let Some((node, above)) = open.pop() {
            let above = [&above[..], &[node]].concat();
            match tree.below(node) {
                Below::Nodes(a, b) => open.extend([(a, above.clone()), (b, above)]),
                Below::Leaf(piece) => {
                    met[piece as usize] += 1;
                    for node in above.iter().map(|n| tree.node(*n)) {
                        for corner in tree.corners(piece) {
                            let off = corner - node.centre;
                            assert!(off.norm() <= node.radius + 1e-9);
                            for h in node.half {
                                assert!(off.dot(&h).abs() <= h.norm_squared() + 1e-9 * h.norm());
                            }
                        }
                    }
                }
            }
        }
        assert!(met.iter().all(|n| *n == 1));
        let area = |tree: &SphereTree| tree.pieces.iter().map(area_mm2).sum::<f64>();
        assert!((area(&tree) - 7.0 * area(&SphereTree::new(&mesh, 0.8))).abs() < 1e-9);
        // A triangle and its pieces are of one copy.
        for triangle in [1, 39, 41, 150, 279] {
            let piece = tree.leaf_of(triangle).unwrap();
            assert_eq!(tree.triangle(piece), triangle);
            let own = all.corners(triangle as usize);
            let plane = (own[1] - own[0]).cross(&(own[2] - own[0])).normalize();
            assert!(tree.corners(piece).iter().all(|c| plane.dot(&(c - own[0])).abs() < 1e-9));
        }
    }
}
