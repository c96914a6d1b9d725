//! Certificates of nodes that are clear while tool and ball centre move on: room that is used up,
//! and planes fixed to the tool. [`super::front`] says what they hold.

use crate::artifact::Cone;
use crate::geometry::{Point, Vector};

use super::bound::{self, Flat, FreeSweep};
use super::forbidden::{ObstacleBody, Start};
use super::samples::Sample;
use super::sight::Sight;
use super::tree;

/// Room that is none, mm.
pub(super) const NONE_MM: f64 = 1e-9;

/// What tool and ball have moved by so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Used {
    /// Way of the ball centre, mm.
    pub way: f64,
    /// Growth of the intervals, rad.
    pub growth: f64,
    /// What the frames of the cones have turned by, rad.
    pub turn: f64,
    /// What the lean has changed by, rad.
    pub tip: f64,
}

impl Used {
    /// What a point within `across` of the cone's axis and `reach` of the ball centre may have come
    /// nearer by, mm.
    fn at_most(&self, across: f64, reach: f64) -> f64 {
        self.way + self.growth * across + (self.turn + self.tip) * reach
    }
}

/// Used up at: way plus growth times `across`, plus what the cone turns by times `reach`.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneLimit {
    pub across: f64,
    pub reach: f64,
    pub at: f64,
}

impl PlaneLimit {
    pub fn new(mm: f64, across: f64, reach: f64, used: &Used) -> Self {
        PlaneLimit { across, reach, at: mm + used.way + used.growth * across + (used.turn + used.tip) * reach }
    }

    pub fn holds(&self, used: &Used) -> bool {
        self.left(used) > 0.0
    }

    /// Room that is left, mm.
    pub fn left(&self, used: &Used) -> f64 {
        self.at - used.at_most(self.across, self.reach)
    }
}

/// Where tool and ball are.
pub(super) struct Now<'a> {
    pub used: Used,
    /// The last step of the ball centre, mm; the next is about as long.
    pub step_mm: f64,
    /// The ball centre.
    pub ball: Point,
    /// The frame of the cone.
    pub sight: Sight,
    /// Free intervals, absolute angles.
    pub sweeps: Vec<FreeSweep>,
    pub bodies: &'a [ObstacleBody<'a>],
}

impl<'a> Now<'a> {
    /// Nowhere yet.
    pub fn new(bodies: &'a [ObstacleBody<'a>]) -> Self {
        let sight = Sight::of(&Cone::about_blade(0.0));
        Now { used: Used::default(), step_mm: 0.0, ball: Point::origin(), sight, sweeps: Vec::new(), bodies }
    }

    /// Goes on to a place.
    pub fn go_to(&mut self, place: &Sample, last: Option<&Sample>) {
        self.step_mm = last.map_or(0.0, |l| (place.centre - l.centre).norm());
        self.used.way += self.step_mm;
        self.ball = place.centre;
        self.sight = Sight::of(&place.cone);
        if let Some(last) = last.filter(|l| l.cone != place.cone) {
            self.used.turn += last.cone.rotation_to(&place.cone).norm();
            self.used.tip += (place.cone.lean_rad - last.cone.lean_rad).abs();
        }
    }
}

/// A bound of the margin at one end, in the tool's frame, and how the node's extent along it
/// changes as the tool turns. At some angle from where the plane was laid the lowest place of the
/// node is under its centre by what is in `offset` already, the `tilt` of its longer side and its
/// other sides' `turn`, and half the angle's square times its radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub slope: Vector,
    /// Bound at the ball centre, less what sides other than the tilting one take away.
    pub offset: f64,
    pub theta: f64,
    /// Fall along half a side, mm, and how much of it comes with a radian.
    pub tilt: [f64; 2],
    /// What a radian costs besides, mm.
    pub turn: f64,
    /// The part of the tool that it is about.
    pub part: u16,
}

impl Plane {
    /// Of the part's margin at the end `k`, for a node whose box has its centre at `v`.
    pub fn new(part: u16, flat: &Flat, node: &Seen, now: &Now, (sweep, k): (&FreeSweep, usize)) -> Self {
        let slope = &flat.slope;
        let theta = if k == 0 { sweep.lo } else { sweep.hi };
        let at_ball = slope.dot(&node.v);
        // Taken off again where the room is asked for: what the cone turns by after now is to
        // count.
        let moved = now.used.turn * node.radius + now.used.tip * node.reach;
        let mut plane = Plane {
            slope: sweep.tool_slope(k, slope),
            offset: flat.least - at_ball + moved,
            theta,
            tilt: [0.0; 2],
            turn: node.radius,
            part,
        };
        let [thick, long, across] = node.half.map(|h| slope.dot(&h));
        let level = flat.middle - thick.abs() - long.abs();
        // Not where the plane does for the node alone, and not for its box.
        if level - across.abs() > NONE_MM {
            let turn = node.half.map(|h| slope.y * h.z - slope.z * h.y);
            plane.offset = level - at_ball + moved;
            plane.tilt = [across, turn[2]];
            plane.turn = turn[0].abs() + turn[1].abs();
        }
        plane
    }
}

/// A node of a tree in the frame of the cone, from the ball centre.
pub(super) struct Seen {
    v: Vector,
    radius: f64,
    half: [Vector; 3],
    /// Its points stay within this of the ball centre while its certificate lasts, mm.
    pub reach: f64,
}

impl Seen {
    pub fn new(node: &tree::SphereNode, now: &Now, reach: f64) -> Self {
        let v = now.sight.seen(&(node.centre - now.ball));
        Seen { v, radius: node.radius, half: now.sight.all_seen(&node.half), reach }
    }
}

/// A node with planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct FrontNode {
    pub at: Start,
    pub centre: Point,
    pub radius: f64,
    /// Of the parts that the planes are not about.
    pub others: PlaneLimit,
    pub planes: [Plane; 2],
}

/// A node that may not be clear any more.
#[derive(Clone, Copy)]
pub(super) struct Due {
    pub at: Start,
    /// Its box was looked at: at an end of the interval planes leave no room about it.
    pub looked: bool,
}

impl Due {
    /// A node of which nothing is known.
    pub fn new(at: Start) -> Self {
        Due { at, looked: false }
    }
}

impl FrontNode {
    /// Distance of its farthest point from the turning axis and from the ball centre, mm.
    pub fn far(&self, now: &Now) -> [f64; 2] {
        let v = now.sight.seen(&(self.centre - now.ball));
        [(v.y * v.y + v.z * v.z).sqrt() + self.radius, v.norm() + self.radius]
    }

    /// A node with new planes of the same parts; an error where they leave no room.
    pub fn renewed(at: Start, parts: [u16; 2], others: PlaneLimit, now: &Now, sweep: &FreeSweep) -> Result<Self, Due> {
        let due = Due::new(at);
        let on = &now.bodies[usize::from(at.0)];
        let node = on.tree.node(at.1);
        let seen = Seen::new(node, now, others.reach);
        if others.left(&now.used) <= NONE_MM
            || !bound::one_arc(&on.profile, &seen.v, node.radius)
            || !sweep.is_beside(&seen.v, node.radius)
        {
            return Err(due);
        }
        let plane = |k: usize| {
            let f = on.profile.frusta.get(usize::from(parts[k])).ok_or(due)?;
            let flat = bound::facet_of(f, &sweep.axes[k], &seen.v, node.radius, &seen.half);
            if flat.least <= NONE_MM {
                return Err(Due { looked: true, ..due });
            }
            Ok(Plane::new(parts[k], &flat, &seen, now, (sweep, k)))
        };
        Ok(FrontNode { at, centre: node.centre, radius: node.radius, others, planes: [plane(0)?, plane(1)?] })
    }
}
