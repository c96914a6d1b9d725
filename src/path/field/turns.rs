//! Turns read off the field, each polished by the ridge to the one before.

use rayon::prelude::*;

use super::super::level::Touch;
use super::super::stepover::ridge_over_creases;
use super::feet::{Curve, Place};
use super::net::{Edge, lines};
use super::values::Field;
use crate::geometry::Point;

/// Ways this near to the one that leaves the scallop, as a share, are right.
const GOOD: f64 = 5e-4;
/// Ways between which a ridge jumps are known within this share.
const CLOSE_IN: f64 = 2e-3;
/// Tries of the law of squares.
const MOST_TRIES: usize = 14;
/// A place that would have to move farther than this, in stepovers, stays where the field has it.
const FAR: f64 = 0.9;
/// Least share of a stepover by which a turn leaves the end.
const LEAST_SHARE: f64 = 1e-3;
/// Length of the ramp from a turn to the next, in stepovers.
const RAMP_STEPOVERS: f64 = 20.0;

/// A node is put midway between two where the ridge there is lower or higher by these shares, on
/// exact faces and over facets, which low ridges do not tell of, ...
const RIDGE_OFF: [[f64; 2]; 2] = [[0.03, 0.03], [1.0, 0.05]];
/// ... so many times one after the other, ...
const REFINEMENTS: usize = 3;
/// ... but not between nodes nearer than this, in steps, ...
const SHORTEST: f64 = 0.1;
/// ... nor where the turn has hardly left the end, as a share of a stepover.
const LEAST_REFINED: f64 = 0.05;

/// Feet on the turn before are sought about the same share of it, by so much to either side.
const BESIDE: f64 = 0.3;

/// A turn of fewer nodes is none.
const LEAST_NODES: usize = 8;
/// Nodes nearer to the beginning of a turn, in steps, are left out.
const CLOSE: f64 = 0.3;
/// Turns run back on the field by no more than this from one to the next.
const MOST_DRIFT: f64 = 0.5;

/// A place of a turn.
#[derive(Clone, Copy)]
pub struct Node {
    pub touch: Touch,
    pub phi: f64,
    /// Whether it waits at the border of the mesh.
    pub waits: bool,
}

/// A turn.
pub struct Turn {
    pub curve: Curve,
    /// φ at its nodes.
    phi: Vec<f64>,
    /// The value of φ about which it runs.
    value: f64,
    /// Its last node, at which the next begins.
    end: Node,
    /// Whether it is the closed end of the region.
    pub is_end: bool,
    /// Whether nodes other than the first wait.
    pub waits: Vec<bool>,
}

impl Turn {
    fn new(nodes: Vec<Node>, value: f64) -> Turn {
        let end = nodes[nodes.len() - 1];
        Turn {
            phi: nodes.iter().map(|n| n.phi).collect(),
            waits: nodes.iter().map(|n| n.waits).collect(),
            curve: Curve::new(nodes.iter().map(|n| n.touch).collect(), false),
            value,
            end,
            is_end: false,
        }
    }

    /// The end of the region, closed; `None` without balls.
    pub fn of_end(touches: Vec<Touch>) -> Option<Turn> {
        let end = Node { touch: *touches.first()?, phi: 0.0, waits: false };
        let (phi, waits) = (vec![0.0; touches.len()], vec![false; touches.len()]);
        Some(Turn { curve: Curve::new(touches, true), phi, value: 0.0, end, is_end: true, waits })
    }

    /// The balls, the first repeated at the end of a closed turn.
    pub fn touches(&self) -> Vec<Touch> {
        let touches = &self.curve.touches;
        touches.iter().chain(touches.first().filter(|_| self.is_end)).copied().collect()
    }

    /// By how much the nodes that do not wait run beside the value, in the median: polished turns
    /// drift from the field.
    fn drift(&self) -> f64 {
        let mut off: Vec<f64> =
            self.phi.iter().zip(&self.waits).filter(|(_, w)| !**w).map(|(p, _)| p - self.value).collect();
        off.sort_by(f64::total_cmp);
        off.get(off.len() / 2).copied().unwrap_or(0.0)
    }
}

/// A node that is being laid.
#[derive(Clone, Copy)]
struct Laid {
    node: Node,
    /// Its foot on the turn before; none where it waits, or ridges do not tell.
    near: Option<Place>,
    /// The share of a stepover by which it is to be apart from the turn before.
    share: f64,
}

/// Reads turns.
pub struct Reader<'a> {
    pub field: &'a Field<'a>,
    pub flat_mm: f64,
    pub step_mm: f64,
    /// The ball at an edge that leaves the bounds.
    pub border: &'a (dyn Fn(Edge) -> Touch + Sync),
    pub within: &'a (dyn Fn(&Touch) -> bool + Sync),
}

impl Reader<'_> {
    /// The closed line at a value, counted so that the field grows to the left of it seen from
    /// outside, at even steps.
    fn line(&self, value: f64) -> Vec<Node> {
        let (net, phi) = (self.field.net, &self.field.phi);
        let below = |v: u32| phi[v as usize] < value;
        let mut best: Option<(f64, Vec<Node>)> = None;
        for line in lines(&net.triangles, below) {
            let mut turn = 0.0;
            let nodes: Vec<(Point, bool)> = line
                .iter()
                .map(|&edge| match net.crossing(edge, phi, value) {
                    Some(p) => (p, false),
                    None => ((self.border)(edge).centre, true),
                })
                .collect();
            let n = nodes.len();
            for (i, &(a, b)) in line.iter().enumerate() {
                let (low, high) = if phi[a as usize] < value { (a, b) } else { (b, a) };
                let way = nodes[(i + 1) % n].0 - nodes[i].0;
                turn += net.touches[low as usize].normal.cross(&way).dot(&(net.centre(high) - net.centre(low)));
            }
            let mut nodes = nodes;
            if turn < 0.0 {
                nodes.reverse();
            }
            let length_mm: f64 = (0..n).map(|i| (nodes[(i + 1) % n].0 - nodes[i].0).norm()).sum();
            if best.as_ref().is_none_or(|b| length_mm > b.0) {
                best = Some((length_mm, self.even(&nodes, length_mm, value)));
            }
        }
        best.map_or_else(Vec::new, |b| b.1)
    }

    fn even(&self, nodes: &[(Point, bool)], length_mm: f64, value: f64) -> Vec<Node> {
        let n = nodes.len();
        let count = (length_mm / self.step_mm).ceil().max(12.0) as usize;
        let (mut i, mut start) = (0, 0.0);
        let length = |i: usize| (nodes[(i + 1) % n].0 - nodes[i % n].0).norm();
        let mut places = Vec::with_capacity(count);
        for k in 0..count {
            let s = length_mm * k as f64 / count as f64;
            while i + 1 < n && start + length(i) < s {
                start += length(i);
                i += 1;
            }
            let (a, b) = (nodes[i], nodes[(i + 1) % n]);
            places.push((a.0 + (b.0 - a.0) * ((s - start) / length(i).max(1e-300)).clamp(0.0, 1.0), a.1 && b.1));
        }
        let on_level = |(p, waits): &(Point, bool)| {
            let touch = self.field.level.touch(p, self.field.net.cell_mm)?;
            Some(Node { touch, phi: value, waits: *waits })
        };
        places.par_iter().filter_map(on_level).collect()
    }

    /// The foot of a ball on a curve, sought about a place of it, and the ridge between the two,
    /// mm; no ridge where ridges do not tell.
    fn ridge_to(&self, curve: &Curve, touch: &Touch, near: Place) -> Option<(Place, Point, Option<f64>)> {
        let level = self.field.level;
        let near = curve.nearest_about(&touch.centre, near)?;
        let foot = level.touch(&curve.point(near), 0.1 * level.radius_mm)?.centre;
        Some((near, foot, ridge_over_creases(level, &touch.centre, &foot)))
    }

    /// The ball at which the ridge to a curve is the scallop times the square of `share`, from a
    /// guess: the farthest found that leaves no more, where ridges jump. `None` where ridges do not
    /// tell.
    fn polished(&self, before: &Curve, guess: &Touch, near: Place, share: f64) -> Option<Touch> {
        let level = self.field.level;
        let goal_mm = self.field.scallop_mm * share * share;
        let (mut touch, mut near) = (*guess, near);
        let (mut low_mm, mut high_mm, mut best) = (0.0, f64::INFINITY, None);
        for _ in 0..MOST_TRIES {
            let (at, foot, ridge) = self.ridge_to(before, &touch, near)?;
            near = at;
            let way = touch.centre - foot;
            let way_mm = way.norm();
            let ridge = ridge.unwrap_or(f64::INFINITY);
            let factor = (goal_mm / ridge.max(1e-3 * goal_mm)).sqrt();
            if factor >= 1.0 && way_mm > low_mm {
                (low_mm, best) = (way_mm, Some(touch));
            } else if factor < 1.0 {
                high_mm = high_mm.min(way_mm);
            }
            if (factor - 1.0).abs() < GOOD {
                best = Some(touch);
                break;
            }
            if high_mm - low_mm < CLOSE_IN * low_mm {
                break;
            }
            let next_mm = way_mm * factor.clamp(0.5, 2.0);
            let next_mm = if next_mm > low_mm && next_mm < high_mm {
                next_mm
            } else {
                0.5 * (low_mm + high_mm.min(2.0 * way_mm))
            };
            touch = level.touch(&(foot + way * (next_mm / way_mm.max(1e-300))), 0.8 * next_mm)?;
        }
        best.filter(|t| (t.centre - guess.centre).norm() < FAR * self.flat_mm)
    }

    /// The turn after one, which begins where that ends; `None` where the field has no closed line
    /// there.
    pub fn next(&self, before: &Turn) -> Option<Turn> {
        let value = before.value + before.drift().max(-MOST_DRIFT) + 1.0;
        let from = before.end;
        let mut line = self.line(value);
        if line.len() < LEAST_NODES {
            return None;
        }
        // The line begins where it passes the beginning of the turn.
        let ring = Curve::new(line.iter().map(|n| n.touch).collect(), true);
        let at = ring.nearest(&from.touch.centre)?;
        let over = self.field.level.touch(&ring.point(at), self.field.net.cell_mm)?;
        let over = Node { touch: over, phi: value, waits: line[at.number].waits };
        let count = line.len();
        line.rotate_left((at.number + 1) % count);
        // A node hardly past the beginning would make a kink.
        line.retain(|n| (n.touch.centre - over.touch.centre).norm() >= CLOSE * self.step_mm);
        line.push(over);
        let shares = self.shares(&line);
        let count = line.len();
        let guessed: Vec<Laid> = (0..count)
            .into_par_iter()
            .map(|i| {
                let is_last = i + 1 == count;
                self.guess(before, line[i], if is_last { 1.0 } else { shares[i] }, i as f64 / count as f64, is_last)
            })
            .collect();
        let polished: Vec<Option<Touch>> = guessed.par_iter().map(|g| self.polish(before, g)).collect();
        let at = |(g, touch): (&Laid, Option<Touch>)| Laid {
            node: touch.map_or(g.node, |touch| Node { touch, ..g.node }),
            near: g.near.filter(|_| touch.is_some()),
            share: g.share,
        };
        let begin = Node { phi: if before.is_end { 0.0 } else { from.phi }, ..from };
        let laid = std::iter::once(Laid { node: begin, near: None, share: 0.0 });
        let laid = laid.chain(guessed.iter().zip(polished).map(at)).collect();
        let laid = self.refined(before, laid);
        let known: Vec<Node> = laid[1..]
            .par_iter()
            .map(|l| {
                let phi = self.field.at(&l.node.touch).map(|v| v.0).filter(|p| p.is_finite());
                Node { phi: phi.unwrap_or(l.node.phi), ..l.node }
            })
            .collect();
        Some(Turn::new(std::iter::once(begin).chain(known).collect(), value))
    }

    /// With more nodes where the ridge midway between two is off: the turn bends within a step.
    fn refined(&self, before: &Turn, mut laid: Vec<Laid>) -> Vec<Laid> {
        let level = self.field.level;
        let [lower, higher] = RIDGE_OFF[usize::from(level.is_over_facets())];
        let mut ask = vec![true; laid.len() - 1];
        for _ in 0..REFINEMENTS {
            let curve = Curve::new(laid.iter().map(|l| l.node.touch).collect(), false);
            let between = |i: usize| -> Option<Laid> {
                let (a, b) = (&laid[i], &laid[i + 1]);
                if !ask[i] || (b.node.touch.centre - a.node.touch.centre).norm() < SHORTEST * self.step_mm {
                    return None;
                }
                let near = if i == 0 { b.near? } else { a.near.and(b.near)? };
                let share = if i == 0 && a.share < b.share && !before.is_end { 1.0 } else { 0.5 * (a.share + b.share) };
                if share < LEAST_REFINED {
                    return None;
                }
                let touch = level.touch(&curve.point(Place { number: i, share: 0.5 }), self.field.net.cell_mm)?;
                let (near, _, ridge) = self.ridge_to(&before.curve, &touch, near)?;
                let ridge = ridge? / (self.field.scallop_mm * share * share);
                if (1.0 - lower..1.0 + higher).contains(&ridge) {
                    return None;
                }
                let touch = self.polished(&before.curve, &touch, near, share).filter(|t| (self.within)(t))?;
                Some(Laid {
                    node: Node { touch, phi: 0.5 * (a.node.phi + b.node.phi), waits: false },
                    near: Some(near),
                    share,
                })
            };
            let new: Vec<Option<Laid>> = (0..laid.len() - 1).into_par_iter().map(between).collect();
            if new.iter().all(Option::is_none) {
                break;
            }
            let mut next = vec![laid[0]];
            let mut next_ask = Vec::new();
            for (i, l) in new.into_iter().enumerate() {
                if let Some(l) = l {
                    next.push(l);
                    next_ask.extend([true, true]);
                } else {
                    next_ask.push(false);
                }
                next.push(laid[i + 1]);
            }
            (laid, ask) = (next, next_ask);
        }
        laid
    }

    /// The shares of a stepover by which a turn has left the height at which it begins: from 0 to 1
    /// with continuous curvature over the ramp. Round a thin edge the ball's centre goes a long way
    /// and its contact hardly any: the shorter of the two ways counts.
    fn shares(&self, line: &[Node]) -> Vec<f64> {
        let ramp_mm = RAMP_STEPOVERS * self.flat_mm;
        let (mut gone_mm, mut last) = (0.0, line[line.len() - 1].touch);
        line.iter()
            .map(|n| {
                let t = n.touch;
                gone_mm += (t.centre - last.centre).norm().min((t.contact - last.contact).norm());
                last = t;
                let u = (gone_mm / ramp_mm).min(1.0);
                u * u * u * (10.0 + u * (6.0 * u - 15.0))
            })
            .collect()
    }

    /// About where a node of a line goes, and its foot on the turn before; `along` is the share of
    /// the turn.
    fn guess(&self, before: &Turn, node: Node, share: f64, along: f64, is_last: bool) -> Laid {
        let (field, curve) = (self.field, &before.curve);
        if node.waits {
            return Laid { node, near: None, share };
        }
        // In the ramp first down to about its height: the turn before is to be the nearest.
        let lower =
            if share < 1.0 { field.onto(node.touch, node.phi - 1.0 + share).unwrap_or(node.touch) } else { node.touch };
        let near = if before.is_end {
            curve.nearest(&lower.centre)
        } else if is_last {
            curve.last()
        } else {
            // Where a turn begins the turn before ends, near by.
            curve.nearest_within(&lower.centre, [along - BESIDE, along + BESIDE])
        };
        let Some(near) = near else { return Laid { node: Node { touch: lower, ..node }, near, share } };
        let share = if before.is_end { share } else { 1.0 };
        let phi = curve.value(&before.phi, near) + share;
        let touch = field.onto(lower, phi).filter(|t| (self.within)(t)).unwrap_or(lower);
        Laid { node: Node { touch, phi, waits: false }, near: Some(near), share }
    }

    /// The ball where the ridge to the turn before is the scallop; `None` where ridges do not tell
    /// or the node waits.
    fn polish(&self, before: &Turn, guess: &Laid) -> Option<Touch> {
        let (near, level) = (guess.near?, self.field.level);
        if guess.share < LEAST_SHARE {
            return level.touch(&before.curve.point(near), 0.1 * level.radius_mm);
        }
        self.polished(&before.curve, &guess.node.touch, near, guess.share).filter(|t| (self.within)(t))
    }
}
