//! The nodes at which the search stopped, and how long each of them stays clear while tool and ball centre move on.
//!
//! Two certificates each. **Room**: all of it, less the way of the ball centre, less what the intervals grow outwards times the
//! distance from the turning axis. **Facets**: the tangent planes of the nearest part's distance at both ends of the interval,
//! fixed to the tool. The distance from a part is convex in the tool's frame, so they bound it wherever the node goes there; a node's
//! extent along a plane changes by its radius times the turn, at most. The other parts keep their room.

use crate::geometry::{Point, Vector};

use super::bound::{Room, Sweep};
use super::forbidden::Start;

/// Room that is none, mm.
const NONE_MM: f64 = 1e-9;
/// Room of other parts that counts, mm.
const MOST_MM: f64 = 1e3;

/// Used up at: way plus growth times `across`.
#[derive(Clone, Copy)]
struct Limit {
    across: f64,
    at: f64,
}

impl Limit {
    fn new(mm: f64, across: f64, [way, growth]: [f64; 2]) -> Self {
        Limit { across, at: mm + way + growth * across }
    }

    fn holds(&self, [way, growth]: [f64; 2]) -> bool {
        way + growth * self.across < self.at
    }
}

/// A bound of the margin at one end, in the tool's frame.
#[derive(Clone, Copy)]
struct Plane {
    slope: Vector,
    offset: f64,
    theta: f64,
}

#[derive(Clone, Copy)]
struct Node {
    at: Start,
    centre: Point,
    radius: f64,
    /// Of the parts that the planes are not about.
    others: Option<Limit>,
    planes: [Plane; 2],
}

/// The front.
#[derive(Default)]
pub(super) struct Front {
    limits: Vec<Limit>,
    nodes: Vec<Node>,
}

impl Front {
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn clear(&mut self) {
        self.limits.clear();
        self.nodes.clear();
    }

    /// Takes a node in, `centre` seen from the ball at `ball`; `used` is the way and the growth so far, `sweeps` what its room is about.
    pub fn hold(
        &mut self,
        (at, centre, radius): (Start, Point, f64),
        room: &Room,
        used: [f64; 2],
        ball: &Point,
        sweeps: &[Sweep],
    ) {
        let none = Plane { slope: Vector::zeros(), offset: 0.0, theta: 0.0 };
        let mut node = Node { at, centre, radius, others: None, planes: [none; 2] };
        if let (Some(facets), [sweep]) = (&room.facets, sweeps) {
            let others = facets[0].others.min(facets[1].others).min(MOST_MM);
            node.others = Some(Limit::new(others, room.across - room.mm + others, used));
            for k in 0..2 {
                let f = &facets[k];
                let (slope, theta) = (sweep.tool_slope(k, &f.slope), if k == 0 { sweep.lo } else { sweep.hi });
                node.planes[k] = Plane { slope, offset: f.least - f.slope.dot(&(centre - ball)), theta };
            }
        }
        self.limits.push(Limit::new(room.mm, room.across, used));
        self.nodes.push(node);
    }

    /// Takes out the nodes that may not be clear any more.
    pub fn drop_due(&mut self, used: [f64; 2], ball: &Point, sweeps: &[Sweep], due: &mut Vec<Start>) {
        let mut k = 0;
        while let Some(limit) = self.limits.get(k) {
            if limit.holds(used) || self.nodes[k].holds(used, ball, sweeps) {
                k += 1;
                continue;
            }
            due.push(self.nodes[k].at);
            self.limits.swap_remove(k);
            self.nodes.swap_remove(k);
        }
    }
}

impl Node {
    fn holds(&self, used: [f64; 2], ball: &Point, sweeps: &[Sweep]) -> bool {
        let (Some(others), [sweep]) = (self.others, sweeps) else { return false };
        let v = self.centre - ball;
        let clear = |k: usize, theta: f64| {
            let p = &self.planes[k];
            p.offset + sweep.space_slope(k, &p.slope).dot(&v) - (theta - p.theta).abs() * self.radius > NONE_MM
        };
        others.holds(used) && clear(0, sweep.lo) && clear(1, sweep.hi) && sweep.is_beside(&v, self.radius)
    }
}
