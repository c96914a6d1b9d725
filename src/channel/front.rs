//! The nodes at which the search stopped, and how long each of them stays clear while tool and ball
//! centre move on.
//!
//! Two certificates each. **Room**: all of it, less the way of the ball centre, less what the
//! intervals grow outwards times the distance from the turning axis, less what the cone turns by
//! times the distance from the ball centre. **Facets**: the tangent planes of the nearest part's
//! distance at both ends of the interval, fixed to the tool. The distance from a part is convex in
//! the tool's frame, so they bound it wherever the node goes there; how far a node reaches along a
//! plane is followed side by side of its box as the tool turns. The other parts keep their room.
//! Where planes hold, the room is what they leave; where they do not any more, new ones of the same
//! parts are tried before the node is given up.
//!
//! A node with room for some steps is passed over until that is used up. Near the places where the
//! tool touches there is none for a single step: there the planes are looked at at every place.

use super::bound::NodeRoom;
use super::forbidden::Start;
use super::lanes::Lanes;
use super::planes::{Due, FrontNode, NONE_MM, Now, Plane, PlaneLimit, Seen};

/// Room of other parts that counts, mm.
const MOST_MM: f64 = 1e3;

/// Steps that a node must have room for to be passed over: less is looked up sooner than filed.
const STEPS: f64 = 8.0;

/// A node that is passed over, and its planes where it has any.
#[derive(Clone, Copy)]
struct Lasting {
    at: Start,
    node: Option<FrontNode>,
}

/// The front.
#[derive(Default)]
pub(super) struct Front {
    limits: Vec<PlaneLimit>,
    /// One for each limit.
    lasting: Vec<Lasting>,
    /// Looked at at every place.
    brief: Lanes,
    rooms: Vec<f64>,
}

impl Front {
    pub fn len(&self) -> usize {
        self.lasting.len() + self.brief.len()
    }

    pub fn clear(&mut self) {
        self.limits.clear();
        self.lasting.clear();
        self.brief.clear();
    }

    /// Takes a node in, with its room about what is swept now.
    pub fn hold(&mut self, at: Start, room: &NodeRoom, now: &Now) {
        let mut with_planes = None;
        if let (Some(facets), [sweep]) = (&room.facets, now.sweeps.as_slice()) {
            let others = facets[0].others.min(facets[1].others).min(MOST_MM);
            let reach = room.reach - room.mm + others;
            let others = PlaneLimit::new(others, room.across - room.mm + others, reach, &now.used);
            let on = now.bodies[usize::from(at.0)].tree.node(at.1);
            let seen = Seen::new(on, now, reach);
            let planes = [0, 1].map(|k| Plane::new(facets[k].part, &facets[k].flat, &seen, now, (sweep, k)));
            let node = FrontNode { at, centre: on.centre, radius: on.radius, others, planes };
            if room.mm <= STEPS * now.step_mm {
                self.brief.push(&node);
                return;
            }
            with_planes = Some(node);
        }
        self.limits.push(PlaneLimit::new(room.mm, room.across, room.reach, &now.used));
        self.lasting.push(Lasting { at, node: with_planes });
    }

    /// Takes out the nodes that may not be clear any more.
    pub fn drop_due(&mut self, now: &Now, due: &mut Vec<Due>) {
        let mut k = 0;
        while let Some(limit) = self.limits.get(k) {
            if limit.holds(&now.used) {
                k += 1;
                continue;
            }
            self.limits.swap_remove(k);
            let Lasting { at, node } = self.lasting.swap_remove(k);
            match node {
                Some(node) => self.brief.push(&node),
                None => due.push(Due::new(at)),
            }
        }
        let [sweep] = now.sweeps.as_slice() else {
            due.extend((0..self.brief.len()).map(|k| Due::new(self.brief.name(k).0)));
            self.brief.clear();
            return;
        };
        self.brief.rooms(now, sweep, &mut self.rooms);
        // From the last on, since the last takes the place of one that is taken out.
        for k in (0..self.brief.len()).rev() {
            let room = self.rooms[k];
            if room > STEPS * now.step_mm {
                let node = self.brief.get(k);
                self.brief.swap_remove(k);
                let [across, reach] = node.far(now);
                self.limits.push(PlaneLimit::new(room, across + room, reach + room, &now.used));
                self.lasting.push(Lasting { at: node.at, node: Some(node) });
            } else if room <= NONE_MM {
                let (at, parts) = self.brief.name(k);
                match FrontNode::renewed(at, parts, self.brief.others(k), now, sweep) {
                    Ok(node) => self.brief.put(k, &node),
                    Err(gone) => {
                        self.brief.swap_remove(k);
                        due.push(gone);
                    }
                }
            }
        }
    }
}
