//! Nodes whose planes are looked at at every place, four side by side in a processor's vectors.

use std::f64::consts::{PI, TAU};

use wide::f64x4;

use super::bound::FreeSweep;
use super::forbidden::Start;
use super::planes::{FrontNode, Now, Plane, PlaneLimit};
use crate::geometry::{Point, Vector};

const LANES: usize = 4;

/// Nodes with planes; one is found by its number, which is another's after one was taken out.
#[derive(Default)]
pub(super) struct Lanes {
    blocks: Vec<NodeBlock>,
    /// Which node each is, and which parts of the tool its planes are about.
    names: Vec<(Start, [u16; 2])>,
}

/// Four nodes, number for number as [`FrontNode`] has them. What has no node yet is one of zeros.
#[derive(Clone, Copy, Default)]
struct NodeBlock {
    centre: [f64x4; 3],
    radius: f64x4,
    others: LimitLanes,
    planes: [PlaneLanes; 2],
}

#[derive(Clone, Copy, Default)]
struct LimitLanes {
    across: f64x4,
    reach: f64x4,
    at: f64x4,
}

#[derive(Clone, Copy, Default)]
struct PlaneLanes {
    slope: [f64x4; 3],
    offset: f64x4,
    theta: f64x4,
    tilt: [f64x4; 2],
    turn: f64x4,
}

impl Lanes {
    pub fn len(&self) -> usize {
        self.names.len()
    }

    pub fn clear(&mut self) {
        self.blocks.clear();
        self.names.clear();
    }

    /// Which node it is, and which parts of the tool its planes are about.
    pub fn name(&self, k: usize) -> (Start, [u16; 2]) {
        self.names[k]
    }

    /// What the other parts leave it.
    pub fn others(&self, k: usize) -> PlaneLimit {
        self.blocks[k / LANES].others.get(k % LANES)
    }

    pub fn get(&self, k: usize) -> FrontNode {
        let (block, l) = (&self.blocks[k / LANES], k % LANES);
        let (at, parts) = self.names[k];
        FrontNode {
            at,
            centre: Point::from(block.centre.map(|c| c.as_array()[l])),
            radius: block.radius.as_array()[l],
            others: block.others.get(l),
            planes: [0, 1].map(|k| block.planes[k].get(l, parts[k])),
        }
    }

    pub fn put(&mut self, k: usize, node: &FrontNode) {
        let (block, l) = (&mut self.blocks[k / LANES], k % LANES);
        for (to, from) in block.centre.iter_mut().zip(node.centre.iter()) {
            to.as_mut_array()[l] = *from;
        }
        block.radius.as_mut_array()[l] = node.radius;
        block.others.across.as_mut_array()[l] = node.others.across;
        block.others.reach.as_mut_array()[l] = node.others.reach;
        block.others.at.as_mut_array()[l] = node.others.at;
        for (to, from) in block.planes.iter_mut().zip(&node.planes) {
            to.put(l, from);
        }
        self.names[k] = (node.at, node.planes.map(|p| p.part));
    }

    pub fn push(&mut self, node: &FrontNode) {
        let k = self.len();
        if k.is_multiple_of(LANES) {
            self.blocks.push(NodeBlock::default());
        }
        self.names.push((node.at, [0; 2]));
        self.put(k, node);
    }

    /// Takes a node out; the last one gets its number.
    pub fn swap_remove(&mut self, k: usize) {
        let last = self.len() - 1;
        if k < last {
            self.put(k, &self.get(last));
        }
        self.names.pop();
        self.blocks.truncate(last.div_ceil(LANES));
    }

    /// Room of all nodes about the one interval, mm, in `rooms`; zero or less where the planes show
    /// none.
    pub fn rooms(&self, now: &Now, sweep: &FreeSweep, rooms: &mut Vec<f64>) {
        rooms.clear();
        if sweep.hi - sweep.lo >= TAU {
            rooms.resize(self.len(), 0.0);
            return;
        }
        for block in &self.blocks {
            rooms.extend_from_slice(&block.rooms(now, sweep).to_array());
        }
        rooms.truncate(self.len());
    }
}

impl NodeBlock {
    fn rooms(&self, now: &Now, sweep: &FreeSweep) -> f64x4 {
        let [x, y, z] = [0, 1, 2].map(|k| self.centre[k] - now.ball[k]);
        let [x, y, z] = match now.sight.rows() {
            Some(rows) => rows.each_ref().map(|r| r.x * x + r.y * y + r.z * z),
            None => [x, y, z],
        };
        let [lo, hi] = sweep.ends.map(|(cos, sin)| [x, cos * y + sin * z, cos * z - sin * y]);
        // As `Sweep::is_beside`, by how much.
        let (before, after) = (-self.radius - lo[2], hi[2] - self.radius);
        let beside = if sweep.hi - sweep.lo > PI {
            before.fast_min(after)
        } else {
            before.fast_max(after).fast_max(-self.radius - lo[1].fast_max(hi[1]))
        };
        let used = &now.used;
        let others =
            self.others.at - (used.way + used.growth * self.others.across + (used.turn + used.tip) * self.others.reach);
        let moved = used.turn * self.radius + used.tip * self.others.reach;
        let [at_lo, at_hi] = [(0, &lo, sweep.lo), (1, &hi, sweep.hi)]
            .map(|(k, seen, theta)| self.planes[k].room(seen, theta, self.radius) - moved);
        let planes = at_lo.fast_min(at_hi);
        beside.simd_gt(f64x4::ZERO) & planes.fast_min(others)
    }
}

impl LimitLanes {
    fn get(&self, l: usize) -> PlaneLimit {
        PlaneLimit { across: self.across.as_array()[l], reach: self.reach.as_array()[l], at: self.at.as_array()[l] }
    }
}

impl PlaneLanes {
    /// What a plane leaves at the angle `theta` of the tool, in whose frame the node's centre is
    /// `seen`, mm.
    fn room(&self, seen: &[f64x4; 3], theta: f64, radius: f64x4) -> f64x4 {
        let angle = theta - self.theta;
        let over = self.offset + (self.slope[0] * seen[0] + self.slope[1] * seen[1] + self.slope[2] * seen[2]);
        let tilt = (self.tilt[0] + angle * self.tilt[1]).abs();
        over - tilt - angle.abs() * self.turn - 0.5 * angle * angle * radius
    }

    fn get(&self, l: usize, part: u16) -> Plane {
        Plane {
            slope: Vector::from(self.slope.map(|s| s.as_array()[l])),
            offset: self.offset.as_array()[l],
            theta: self.theta.as_array()[l],
            tilt: self.tilt.map(|t| t.as_array()[l]),
            turn: self.turn.as_array()[l],
            part,
        }
    }

    fn put(&mut self, l: usize, plane: &Plane) {
        for (to, from) in self.slope.iter_mut().zip(plane.slope.iter()) {
            to.as_mut_array()[l] = *from;
        }
        self.offset.as_mut_array()[l] = plane.offset;
        self.theta.as_mut_array()[l] = plane.theta;
        for (to, from) in self.tilt.iter_mut().zip(plane.tilt) {
            to.as_mut_array()[l] = from;
        }
        self.turn.as_mut_array()[l] = plane.turn;
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::planes::Seen;
    use super::super::samples::Sample;
    use super::*;
    use crate::artifact::Cone;
    use crate::channel::bound;
    use crate::channel::clear::margin;
    use crate::channel::profile::Frustum;
    use crate::channel::tree::SphereTree;
    use proptest::prelude::*;

    fn node(number: u32) -> FrontNode {
        let k = f64::from(number);
        let plane = |part: u16, shift: f64| Plane {
            slope: Vector::new(k, k + 0.1, k + 0.2),
            offset: k + shift,
            theta: k - shift,
            tilt: [k + 0.3, k + 0.4],
            turn: k + 0.5,
            part,
        };
        FrontNode {
            at: (3, number),
            centre: Point::new(k, 2.0 * k, 3.0 * k),
            radius: 4.0 * k,
            others: PlaneLimit { across: 5.0 * k, reach: 7.0 * k, at: 6.0 * k },
            planes: [plane(number as u16, 0.6), plane(number as u16 + 1, 0.7)],
        }
    }

    #[test]
    fn nodes_come_out_as_they_went_in() {
        let mut lanes = Lanes::default();
        let mut list: Vec<u32> = (0..11).collect();
        list.iter().for_each(|k| lanes.push(&node(*k)));
        for gone in [10, 3, 0, 6, 6, 4] {
            lanes.swap_remove(gone);
            list.swap_remove(gone);
            assert_eq!(lanes.len(), list.len());
            for (k, number) in list.iter().enumerate() {
                assert_eq!(format!("{:?}", lanes.get(k)), format!("{:?}", node(*number)));
            }
        }
        lanes.put(2, &node(77));
        assert_eq!((lanes.name(2), lanes.others(2).at), (((3, 77), [77, 78]), 462.0));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

        /// Wherever ball and interval have gone since the planes were laid, no point of the node
        /// comes nearer to the tool at either end than the room says.
        #[test]
        fn no_point_is_nearer_than_the_room(
            c in prop::array::uniform9(-1.0..1.0f64),
            size in 0.01..2.0f64,
            away in (-2.0..8.0f64, 0.0..2.0f64),
            from in (-2.0..2.0f64, 0.1..6.0f64),
            gone in (prop::array::uniform3(-0.3..0.3f64), -0.3..0.3f64, -0.3..0.3f64),
            turned in prop_oneof![Just([0.0; 4]), prop::array::uniform4(-0.1..0.1f64)],
            b_rad in -0.7..0.7f64,
            taper in 0.0..0.5f64,
            of_triangle in any::<bool>(),
        ) {
            let frustum = Frustum::new([0.0, 9.0], [2.0, 2.0 + 9.0 * taper], 0.1);
            let b = b_rad.sin_cos();
            let then = FreeSweep::new(from.0, from.0 + from.1, b);
            // Beside the tool at the lower end.
            let side = Vector::x().cross(&then.axes[0]).try_normalize(1e-6).unwrap_or_else(Vector::y);
            let at = then.axes[0] * away.0 - side * (2.5 + away.1 + 9.0 * taper);
            let corners = [0, 3, 6].map(|k| Point::from(at + Vector::new(c[k], c[k + 1], c[k + 2]) * size));
            let tree = SphereTree::of(&[corners], &[0], 1e3);
            let on = tree.node(0);
            let ball = Point::origin();
            let v = on.centre - ball;
            let first = Now::new(&[]);
            // As far as anything of the node can be from the ball centre here.
            let seen = Seen::new(on, &first, v.norm() + on.radius + 1.0);
            let flats = [0, 1].map(|k| bound::facet_of(&frustum, &then.axes[k], &v, on.radius, &on.half));
            // None is held that has no room.
            if flats.iter().any(|f| f.least <= 0.0) {
                return Ok(());
            }
            let planes = [0, 1].map(|k| {
                let mut flat = flats[k];
                if of_triangle {
                    let over = |p: &Point| flat.middle + flat.slope.dot(&(p - on.centre));
                    flat.least = corners.iter().map(over).fold(f64::INFINITY, f64::min);
                }
                Plane::new(0, &flat, &seen, &first, (&then, k))
            });
            let others = PlaneLimit { across: 0.0, reach: seen.reach, at: f64::MAX };
            let mut lanes = Lanes::default();
            lanes.push(&node(1));
            lanes.push(&FrontNode { at: (0, 0), centre: on.centre, radius: on.radius, others, planes });
            let ball = ball + Vector::from(gone.0);
            // The cone turns and leans too.
            let place = |ball: Point, cone: Cone| Sample {
                row: 0,
                fraction: 0.0,
                centre: ball,
                normal: Vector::y(),
                cone,
                azimuth: 0.0,
                within_rad: None,
            };
            let by = nalgebra::UnitQuaternion::from_scaled_axis(Vector::new(turned[0], turned[1], turned[2]));
            let cone = Cone { axis: by * Vector::x(), reference: by * Vector::y(), lean_rad: b_rad + 0.3 * turned[3] };
            let sweep = FreeSweep::new(then.lo + gone.1, then.hi + gone.2, cone.lean_rad.sin_cos());
            let mut now = Now::new(&[]);
            now.go_to(&place(ball, cone), Some(&place(Point::origin(), Cone::about_blade(b_rad))));
            now.sweeps = vec![sweep];
            let mut rooms = Vec::new();
            lanes.rooms(&now, &sweep, &mut rooms);
            prop_assert_eq!(rooms.len(), 2);
            if rooms[1] <= 0.0 {
                return Ok(());
            }
            prop_assert!(sweep.is_beside(&now.sight.seen(&(on.centre - ball)), on.radius), "room is said of a node that the interval passes");
            let mut points = Vec::new();
            for i in 0..=8 {
                for j in 0..=8 - i {
                    let (s, t) = (f64::from(i) / 8.0, f64::from(j) / 8.0);
                    points.push(corners[0] + (corners[1] - corners[0]) * s + (corners[2] - corners[0]) * t);
                }
            }
            if !of_triangle {
                for n in 0..125 {
                    let [i, j, k] = [n / 25, n / 5 % 5, n % 5].map(|n| 0.5 * f64::from(n) - 1.0);
                    let off = on.half[0] * i + on.half[1] * j + on.half[2] * k;
                    if off.norm() <= on.radius {
                        points.push(on.centre + off);
                    }
                }
            }
            for (p, axis) in points.iter().flat_map(|p| sweep.axes.iter().map(move |a| (p, a))) {
                let true_mm = margin(&frustum, axis, &now.sight.seen(&(p - ball))).0;
                prop_assert!(true_mm >= rooms[1] - 1e-12, "{true_mm} mm, said {}", rooms[1]);
            }
        }
    }
}
