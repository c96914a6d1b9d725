//! The nodes at which the search stopped, and how long each of them stays clear while tool and ball centre move on.
//!
//! Two certificates each. **Room**: all of it, less the way of the ball centre, less what the intervals grow outwards times the
//! distance from the turning axis. **Facets**: the tangent planes of the nearest part's distance at both ends of the interval,
//! fixed to the tool. The distance from a part is convex in the tool's frame, so they bound it wherever the node goes there; a node's
//! extent along a plane changes by its radius times the turn, at most. The other parts keep their room. Where planes hold, the room is what they
//! leave; where they do not any more, new ones of the same parts are tried before the node is given up: near the place where the tool
//! touches, that is at every step.

use crate::geometry::{Point, Vector};

use super::bound::{self, Room, Sweep};
use super::forbidden::{Body, Start};

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

    fn holds(&self, used: [f64; 2]) -> bool {
        self.left(used) > 0.0
    }

    /// Room that is left, mm.
    fn left(&self, [way, growth]: [f64; 2]) -> f64 {
        self.at - (way + growth * self.across)
    }
}

/// Where tool and ball are.
pub(super) struct Now<'a> {
    /// Way of the ball centre, mm, and growth of the intervals, rad, so far.
    pub used: [f64; 2],
    /// The last step of the ball centre, mm; the next is about as long.
    pub step_mm: f64,
    /// The ball centre.
    pub ball: Point,
    /// Free intervals, absolute angles.
    pub sweeps: Vec<Sweep>,
    pub bodies: &'a [Body<'a>],
}

/// A bound of the margin at one end, in the tool's frame.
#[derive(Clone, Copy)]
struct Plane {
    slope: Vector,
    offset: f64,
    theta: f64,
    /// The part of the tool that it is about.
    part: u16,
}

impl Plane {
    /// Of the part's margin at the end `k`, at least `least` with this slope in space about a node's centre, seen as `v`.
    fn new(part: u16, (least, slope): (f64, &Vector), v: &Vector, sweep: &Sweep, k: usize) -> Self {
        let theta = if k == 0 { sweep.lo } else { sweep.hi };
        Plane { slope: sweep.tool_slope(k, slope), offset: least - slope.dot(v), theta, part }
    }
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

    /// Takes a node in, with its room about what is swept now.
    pub fn hold(&mut self, (at, centre, radius): (Start, Point, f64), room: &Room, now: &Now) {
        let none = Plane { slope: Vector::zeros(), offset: 0.0, theta: 0.0, part: 0 };
        let mut node = Node { at, centre, radius, others: None, planes: [none; 2] };
        if let (Some(facets), [sweep]) = (&room.facets, now.sweeps.as_slice()) {
            let others = facets[0].others.min(facets[1].others).min(MOST_MM);
            node.others = Some(Limit::new(others, room.across - room.mm + others, now.used));
            let v = centre - now.ball;
            node.planes = [0, 1].map(|k| {
                let f = &facets[k];
                Plane::new(f.part, (f.least, &f.slope), &v, sweep, k)
            });
        }
        self.limits.push(Limit::new(room.mm, room.across, now.used));
        self.nodes.push(node);
    }

    /// Takes out the nodes that may not be clear any more.
    pub fn drop_due(&mut self, now: &Now, due: &mut Vec<Due>) {
        let mut k = 0;
        while let Some(limit) = self.limits.get_mut(k) {
            if limit.holds(now.used) {
                k += 1;
                continue;
            }
            let node = &mut self.nodes[k];
            let mm = match node.prolonged(now) {
                Ok(mm) => mm,
                Err(due_now) => {
                    due.push(due_now);
                    self.limits.swap_remove(k);
                    self.nodes.swap_remove(k);
                    continue;
                }
            };
            if mm > now.step_mm {
                *limit = Limit::new(mm, node.rho(now) + mm, now.used);
            }
            k += 1;
        }
    }
}

impl Node {
    /// What planes leave of room, old ones or new ones, mm; an error where that is nothing.
    fn prolonged(&mut self, now: &Now) -> Result<f64, Due> {
        let due = Due::new(self.at);
        let (Some(others), [sweep]) = (self.others, now.sweeps.as_slice()) else { return Err(due) };
        let left = others.left(now.used);
        if left <= NONE_MM {
            return Err(due);
        }
        let seen = sweep.in_tools(&(self.centre - now.ball));
        let mm = if sweep.is_beside_tools(&seen, self.radius) { self.by_planes(&seen, sweep) } else { 0.0 };
        Ok(if mm > NONE_MM { mm } else { self.renewed(now, sweep)? }.min(left))
    }

    /// Distance of its farthest point from the turning axis, mm.
    fn rho(&self, now: &Now) -> f64 {
        let v = self.centre - now.ball;
        (v.y * v.y + v.z * v.z).sqrt() + self.radius
    }

    /// Room at both ends by the planes, with the centre seen from the tools there, mm.
    fn by_planes(&self, seen: &[Vector; 2], sweep: &Sweep) -> f64 {
        let [lo, hi] = &self.planes;
        (lo.offset + lo.slope.dot(&seen[0]) - (sweep.lo - lo.theta).abs() * self.radius)
            .min(hi.offset + hi.slope.dot(&seen[1]) - (sweep.hi - hi.theta).abs() * self.radius)
    }

    /// Room at both ends by new planes of the same parts, mm.
    fn renewed(&mut self, now: &Now, sweep: &Sweep) -> Result<f64, Due> {
        let due = Due::new(self.at);
        let on = &now.bodies[usize::from(self.at.0)];
        let node = on.tree.node(self.at.1);
        let v = node.centre - now.ball;
        if !bound::one_arc(&on.profile, &v, node.radius) || !sweep.is_beside(&v, node.radius) {
            return Err(due);
        }
        let mut room = f64::INFINITY;
        for k in 0..2 {
            let part = self.planes[k].part;
            let f = on.profile.frusta.get(usize::from(part)).ok_or(due)?;
            let (least, slope) = bound::facet_of(f, &sweep.axes[k], &v, node.radius, &node.half);
            if least <= NONE_MM {
                return Err(Due { looked: true, ..due });
            }
            room = room.min(least);
            self.planes[k] = Plane::new(part, (least, &slope), &v, sweep, k);
        }
        (self.centre, self.radius) = (node.centre, node.radius);
        Ok(room)
    }
}
