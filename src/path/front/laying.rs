//! Turns laid one from the other, touch by touch, to either side.

use super::folds::without_cusps;
use super::neighbour::{Heading, Next};
use super::node::{LEAST_SHARE, Node, arc_lengths, is_ring};
use super::overrun::Overrun;
use super::{By, Front, Neighbours, RAMP_STEPOVERS};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::parallel;
use crate::path::curve;
use crate::path::level::Touch;

/// More turns than this is a mistake in the options.
const MOST_TURNS: usize = 20_000;
/// Ways shorter than this share of the flat stepover are none: the ball is stuck.
const STUCK: f64 = 1e-2;
/// Share of a turn from which on it counts as being at the end in part: a burr may stop the ball at
/// a place.
const LEAST_PART: f64 = 0.05;
/// A turn so many times as long as the first, or as the ring at the start height, runs to and fro
/// beside places that the ball cannot follow.
const TOO_LONG: f64 = 5.0;
/// A turn shorter than this share of the one before has lost a part of the way round.
const TOO_SHORT: f64 = 0.6;
/// The greatest way to a neighbour under cutters with a corner, over the way that the share
/// [`NEAR_RANK`] of the nodes falls short of.
const TOGETHER: f64 = 2.0;
const NEAR_RANK: f64 = 0.1;

/// Turns laid, the first along a ring and the last node of each being the first of the next.
pub struct Laid {
    pub turns: Vec<Vec<Node>>,
    /// Where a turn could not go on.
    pub lost: Option<Point>,
}

impl Laid {
    /// The turn laid last.
    pub fn last(&self) -> &[Node] {
        self.turns.last().map_or(&[], Vec::as_slice)
    }

    /// Whether the last turn runs along the end all the way: it is closed then.
    pub fn is_at_the_end(&self) -> bool {
        are_at_the_end(&self.turns)
    }
}

/// Whether the last of turns runs along the end all the way.
pub fn are_at_the_end(turns: &[Vec<Node>]) -> bool {
    matches!(turns, [_, .., last] if last.iter().all(|n| n.stop.is_some()))
}

/// What of the turns is not at the end yet.
pub struct Rest {
    patience: usize,
    /// The least length so far, mm.
    least_mm: f64,
    /// Turns since then.
    pub since: usize,
}

impl Rest {
    pub fn new(patience: usize) -> Self {
        Rest { patience, least_mm: f64::INFINITY, since: 0 }
    }

    /// Whether, with one more turn, it has not become less for too long though some of it is at the
    /// end.
    pub fn stays(&mut self, turn: &[Node]) -> bool {
        let length = |w: &[Node]| (w[1].touch.centre - w[0].touch.centre).norm();
        let whole_mm: f64 = turn.windows(2).map(length).sum();
        let is_free = |w: &&[Node]| w.iter().all(|n| n.stop.is_none());
        let rest_mm: f64 = turn.windows(2).filter(is_free).map(length).sum();
        if rest_mm < self.least_mm || rest_mm > (1.0 - LEAST_PART) * whole_mm {
            (self.least_mm, self.since) = (rest_mm, 0);
        } else {
            self.since += 1;
        }
        self.since >= self.patience
    }
}

/// How a turn runs: what the neighbours of its nodes are sought by.
pub struct TurnCourse {
    /// Unit directions at its nodes.
    pub along: Vec<Vector>,
    /// Its touches, after the last ones of the turn before.
    pub round: Vec<Touch>,
    /// The shares of a stepover by which the next turn leaves it.
    pub shares: Vec<f64>,
}

impl Front<'_> {
    /// Height of the ball's centre along the region, mm.
    pub fn height_mm(&self, node: &Node) -> f64 {
        self.across.level.along.height_mm(&node.touch.centre)
    }

    /// A first turn, closed, along a ring.
    pub fn along(&self, ring: &[Touch]) -> Vec<Vec<Node>> {
        let node = |t: &Touch| Node { touch: *t, way_mm: self.flat_mm, stop: None };
        vec![self.spaced(ring.iter().chain(ring.first()).map(node).collect())]
    }

    /// Lays turns after the ones there until `enough` says so of the last, or it runs along the end
    /// all the way, or the surface is lost.
    pub fn lay(
        &self,
        turns: Vec<Vec<Node>>,
        progress: &dyn Fn(f64) -> Result<()>,
        mut enough: impl FnMut(&[Node]) -> bool,
    ) -> Result<Laid> {
        let mut laid = Laid { turns, lost: None };
        let length_mm = |turn: &[Node]| arc_lengths(turn).last().copied().unwrap_or(0.0);
        let longest_mm = TOO_LONG * laid.turns.first().map_or(0.0, |t| length_mm(t)).max(self.round_mm);
        while let Some((last, before)) = laid.turns.split_last_mut() {
            progress(self.height_mm(&last[0]))?;
            let next = match self.by {
                By::FirstOrderRings => self.next_ring(last),
                By::Ridges | By::FirstOrder => self.next_turn(before.last(), last),
            };
            match next {
                Ok(next) if length_mm(&next) > longest_mm || length_mm(&next) < TOO_SHORT * length_mm(last) => {
                    laid.lost = next.iter().min_by(|a, b| a.way_mm.total_cmp(&b.way_mm)).map(|n| n.touch.centre);
                    break;
                }
                Ok(next) => laid.turns.push(next),
                Err(lost) => {
                    // The turn before the loss has gone as far as the ball could, past where its
                    // neighbours can follow.
                    if laid.turns.len() > 3 {
                        laid.turns.pop();
                    }
                    laid.lost = Some(lost);
                    break;
                }
            }
            if laid.is_at_the_end() || enough(laid.last()) {
                break;
            }
            if laid.turns.len() > MOST_TURNS {
                let since = Infeasible::TooManyTurns { most: MOST_TURNS, scallop_mm: self.scallop_mm };
                return Err(Error::infeasible(
                    Stage::Path,
                    format!("more than {MOST_TURNS} turns would be needed"),
                    since,
                )
                .advise("allow a larger scallop or a smaller region"));
            }
        }
        Ok(laid)
    }

    /// The turn after `turn`; without a turn `before` it, `turn` is closed and left slowly. `Err`:
    /// where the ball cannot go on.
    fn next_turn(&self, before: Option<&Vec<Node>>, turn: &mut Vec<Node>) -> std::result::Result<Vec<Node>, Point> {
        // The end of a closed turn comes before its own beginning.
        let tail = self.tail(before.unwrap_or(turn)).to_vec();
        // Beside a ring the ramp brings a turn as near to it as it likes: to bring it back would be
        // to go beyond the end.
        if let Some(before) = before.filter(|b| self.back > 0.0 && !is_ring(b)) {
            let head = self.head(before, turn);
            self.even_turn(&tail, turn, &head);
        }
        let course = self.course(before, &tail, turn);
        let mut next = self.neighbours(turn, &course, before.is_none());
        if self.across.level.inclined.is_some() {
            next = self.kept_together(turn, &course, next);
        }
        if self.evens_ways {
            next = self.even_ways(turn, &course, next);
        }
        if self.is_path {
            self.leave_out_burrs(&mut next);
        }
        let unfolded = self.unfolded(&tail[..tail.len() - 1], turn, &course.along, &next)?;
        let is_left_slowly = is_ring(turn);
        turn.truncate(unfolded.end + 1);
        let first = turn[unfolded.end];
        let nodes = if is_left_slowly {
            // Nothing beside it is far.
            std::iter::once(first).chain(unfolded.kept.into_iter().map(|k| k.1)).collect()
        } else {
            self.bridged(first, &unfolded)
        };
        // On exact faces stretches that run into one another are found by their neighbours; a turn
        // round a thin edge may seem to cross itself there.
        let nodes = if self.across.level.is_over_facets() || self.is_first_order() {
            Overrun::of(&[], &nodes, std::iter::empty()).without_loops()
        } else {
            nodes
        };
        let has_cusps = self.across.level.inclined.is_some() || self.is_first_order();
        let nodes = if has_cusps { without_cusps(nodes) } else { nodes };
        Ok(self.spaced(nodes))
    }

    /// How a turn runs; `tail` is the end of the one before.
    fn course(&self, before: Option<&Vec<Node>>, tail: &[Node], turn: &[Node]) -> TurnCourse {
        let n = turn.len() - 1;
        let is_closed = before.is_none();
        let back = before.map_or(turn[n - 1], |b| b[b.len() - 2]).touch.centre;
        let ahead = turn[1].touch.centre;
        let touches: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        TurnCourse {
            along: curve::tangents(Some(&back), &touches, is_closed.then_some(&ahead)),
            round: tail.iter().map(|n| n.touch).chain(touches).collect(),
            shares: if is_closed { ramp(turn, RAMP_STEPOVERS * self.flat_mm) } else { vec![1.0; n + 1] },
        }
    }

    /// The neighbours of a turn's nodes, each sought for itself; that of the first is the last of
    /// the turn.
    fn neighbours(&self, turn: &[Node], course: &TurnCourse, is_closed: bool) -> Neighbours {
        let n = turn.len() - 1;
        let TurnCourse { along, round, shares } = course;
        let mut next: Neighbours = parallel::map(0..=n, |i| self.neighbour_of(&turn[i], round, along[i], shares[i]));
        next[0] = Some(turn[n]);
        if !is_closed && let Some(start) = next[1] {
            // The way on from the last touch is known only now: to the first of the new turn.
            let on = curve::tangent(Some(&turn[n - 1].touch.centre), &turn[n].touch, Some(&start.touch.centre));
            next[n] = self.neighbour_of(&turn[n], round, on, 1.0);
        }
        next
    }

    /// Neighbours no farther off than [`TOGETHER`] times as far as where they are near.
    ///
    /// On hollow ground that bends hardly less than a cutter with a corner its passes leave next to
    /// nothing between them, at edges that it passes leaning aside as much as its corner does.
    /// Turns that run ahead so far on one side stand across the blade soon, where cutters lean
    /// aside all the more.
    fn kept_together(&self, turn: &[Node], course: &TurnCourse, next: Neighbours) -> Neighbours {
        let is_free = |i: usize| course.shares[i] >= LEAST_SHARE;
        let free = next.iter().enumerate().filter(|(i, _)| is_free(*i)).filter_map(|(_, n)| *n);
        let mut ways: Vec<f64> = free.filter(|n| n.stop.is_none()).map(|n| n.way_mm).collect();
        ways.sort_by(f64::total_cmp);
        let Some(near_mm) = ways.get((NEAR_RANK * ways.len() as f64) as usize) else { return next };
        let most_mm = TOGETHER * near_mm;
        let held = |i: usize| {
            let node = next[i]?;
            if i == 0 || node.stop.is_some() || node.way_mm <= most_mm || !is_free(i) {
                return Some(node);
            }
            let from = Heading { touch: turn[i].touch, along: course.along[i] };
            let Next { touch, stop, .. } = self.across.reach(&from, &course.round, most_mm * course.shares[i])?;
            Some(Node { touch, way_mm: most_mm, stop })
        };
        parallel::map(0..next.len(), held)
    }

    /// The end of a turn, as long as the evening of a front looks.
    fn tail<'n>(&self, turn: &'n [Node]) -> &'n [Node] {
        let s_mm = arc_lengths(turn);
        let whole = s_mm.last().copied().unwrap_or(0.0);
        &turn[s_mm.partition_point(|s| *s < whole - self.look_mm())..]
    }

    /// The beginning of the turn after `turn`, as long as the evening of a front looks; its first
    /// touch, the last of `turn`, left out.
    fn head(&self, before: &[Node], turn: &[Node]) -> Vec<Node> {
        let count = arc_lengths(turn).partition_point(|s| *s <= self.look_mm());
        let touches: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        let first = &touches[..turn.len().min(count + 1)];
        let along = curve::tangents(Some(&before[before.len() - 2].touch.centre), first, None);
        let mut head: Vec<Node> = Vec::with_capacity(count);
        let last = &turn[turn.len() - 1];
        for i in 1..count {
            let Some(next) = self.neighbour_of(&turn[i], &touches, along[i], 1.0) else { continue };
            let step = next.touch.centre - head.last().unwrap_or(last).touch.centre;
            if step.dot(&along[i]) > 0.0 {
                head.push(next);
            }
        }
        head
    }

    /// The neighbour of one node of a turn, at the share `share` of the stepover.
    pub fn neighbour_of(&self, node: &Node, turn: &[Touch], along: Vector, share: f64) -> Option<Node> {
        if node.stop.is_some() || share < LEAST_SHARE {
            return Some(Node { way_mm: self.flat_mm, ..*node });
        }
        let from = Heading { touch: node.touch, along };
        let h_mm = self.scallop_mm * share * share;
        let found = if self.is_first_order() {
            self.first_order(&from, turn, h_mm)
        } else {
            self.across.neighbour(&from, turn, h_mm, node.way_mm * share)
        };
        let Next { touch, way_mm, stop } = found?;
        if stop.is_none() && way_mm < STUCK * share * self.flat_mm {
            return None;
        }
        // A last, shortened way says nothing about the next.
        Some(Node { touch, way_mm: if stop.is_some() { node.way_mm } else { way_mm / share }, stop })
    }
}

/// Shares of the stepover by which a turn leaves the ring before it: from 0 to 1 with continuous
/// curvature over the ramp's length. Round a thin edge the ball's centre goes a long way and its
/// contact hardly any: a ramp there would send every contact along the edge, so the shorter of the
/// two ways counts.
pub fn ramp(turn: &[Node], ramp_mm: f64) -> Vec<f64> {
    let way_mm = |a: &Touch, b: &Touch| (b.centre - a.centre).norm().min((b.contact - a.contact).norm());
    let mut at_mm = 0.0;
    let ways = turn.windows(2).map(|w| {
        at_mm += way_mm(&w[0].touch, &w[1].touch);
        at_mm
    });
    let s_mm: Vec<f64> = std::iter::once(0.0).chain(ways).collect();
    let whole = s_mm.last().copied().unwrap_or(0.0).min(ramp_mm).max(1e-12);
    let smooth = |t: f64| t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
    s_mm.iter().map(|s| smooth((s / whole).min(1.0))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_waits_while_the_ball_rolls_round_a_thin_edge() {
        // Along a wall to its edge at y = 2, half round it, and back along the other side.
        let touch = |y: f64, angle: f64| {
            let normal = Vector::new(0.0, angle.sin(), angle.cos());
            let contact = Point::new(0.0, y, 0.0);
            Touch { centre: contact + 3.0 * normal, contact, normal, face: 0 }
        };
        let there = (0..=20).map(|k| touch(0.1 * f64::from(k), 0.0));
        let round = (1..=20).map(|k| touch(2.0, f64::from(k) * std::f64::consts::PI / 20.0));
        let back = (1..=20).map(|k| touch(2.0 - 0.1 * f64::from(k), std::f64::consts::PI));
        let node = |touch| Node { touch, way_mm: 1.0, stop: None };
        let turn: Vec<Node> = there.chain(round).chain(back).map(node).collect();
        let shares = ramp(&turn, 4.0);
        assert!(shares.windows(2).all(|w| w[0] <= w[1]));
        assert!(shares[20..=40].iter().all(|s| (s - 0.5).abs() < 1e-9), "{shares:?}");
        assert_eq!((shares[0], shares[60]), (0.0, 1.0));
    }
}
