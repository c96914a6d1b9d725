//! Turns laid one from the other, touch by touch, to either side.

use rayon::prelude::*;

use super::curve;
use super::level::Touch;
use super::neighbour::{Heading, Next};
use super::nodes::{Overrun, arc_lengths, is_ring};
use super::turn::{LEAST_SHARE, March, TurnNode};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::{Point, Vector};

/// More turns than this is a mistake in the options.
const MOST_TURNS: usize = 20_000;
/// Ways shorter than this share of the flat stepover are none: the ball is stuck.
const STUCK: f64 = 1e-2;
/// Length of the ramp from a turn to the next, in stepovers on flat ground: steep enough to be
/// short, and so gentle that the path tilts by less than 6° and its radius in the surface is over
/// 60 stepovers.
const RAMP_STEPOVERS: f64 = 20.0;
/// Moves, each of a stepover at most, of a place of a ring to the height of the others' contacts.
const MOST_MOVES: usize = 60;
/// Share of a turn from which on it counts as being at the end in part: a burr may stop the ball at
/// a place.
const LEAST_PART: f64 = 0.05;
/// Islands in the end that are narrower than so many stepovers of the turns that look for it are
/// passed by. Never wider than two radii: so far apart are balls on both sides of a thin part.
const ISLAND: f64 = 2.0;
/// A turn so many times as long as the first, or as the ring at the start height, runs to and fro
/// beside places that the ball cannot follow.
const TOO_LONG: f64 = 5.0;
/// A turn shorter than this share of the one before has lost a part of the way round.
const TOO_SHORT: f64 = 0.6;
/// Turns that may come no nearer to the end before one is drawn where none was given, and before a
/// given one counts as out of reach.
pub(super) const PATIENCE: [usize; 2] = [3, 100];

/// Turns laid, the first along a ring and the last node of each being the first of the next.
pub(super) struct Laid {
    pub(super) turns: Vec<Vec<TurnNode>>,
    /// Where a turn could not go on.
    pub(super) lost: Option<Point>,
}

impl Laid {
    /// The turn laid last.
    pub(super) fn last(&self) -> &[TurnNode] {
        self.turns.last().map_or(&[], Vec::as_slice)
    }

    /// Whether the last turn runs along the end all the way: it is closed then.
    pub(super) fn is_at_the_end(&self) -> bool {
        are_at_the_end(&self.turns)
    }
}

/// Whether the last of turns runs along the end all the way.
fn are_at_the_end(turns: &[Vec<TurnNode>]) -> bool {
    matches!(turns, [_, .., last] if last.iter().all(|n| n.stop.is_some()))
}

/// What of the turns is not at the end yet.
pub(super) struct Rest {
    patience: usize,
    /// The least length so far, mm.
    least_mm: f64,
    /// Turns since then.
    since: usize,
}

impl Rest {
    pub(super) fn new(patience: usize) -> Self {
        Rest { patience, least_mm: f64::INFINITY, since: 0 }
    }

    /// Whether, with one more turn, it has not become less for too long though some of it is at the
    /// end.
    pub(super) fn stays(&mut self, turn: &[TurnNode]) -> bool {
        let length = |w: &[TurnNode]| (w[1].touch.centre - w[0].touch.centre).norm();
        let whole_mm: f64 = turn.windows(2).map(length).sum();
        let is_free = |w: &&[TurnNode]| w.iter().all(|n| n.stop.is_none());
        let rest_mm: f64 = turn.windows(2).filter(is_free).map(length).sum();
        if rest_mm < self.least_mm || rest_mm > (1.0 - LEAST_PART) * whole_mm {
            (self.least_mm, self.since) = (rest_mm, 0);
        } else {
            self.since += 1;
        }
        self.since >= self.patience
    }
}

impl March<'_> {
    /// Height of the ball's centre along the region, mm.
    fn height_mm(&self, node: &TurnNode) -> f64 {
        self.across.level.along.height_mm(&node.touch.centre)
    }

    /// Lays turns until one runs along the end all the way, or the surface is lost. Where the end
    /// is `open`, and some places have come to a wall or an edge but no more do, the end is drawn
    /// at the height that the others have then.
    pub(super) fn find_end(&self, ring: &[Touch], open: bool, progress: &dyn Fn(f64) -> Result<()>) -> Result<Laid> {
        let mut rest = Rest::new(PATIENCE[usize::from(!open)]);
        let mut laid = self.lay(self.along(ring), progress, |turn| rest.stays(turn))?;
        if laid.lost.is_some() || laid.is_at_the_end() {
            return Ok(laid);
        }
        laid.turns.truncate(laid.turns.len().saturating_sub(rest.since).max(2));
        // Over facets a place comes to a wall here and its neighbour slips by: such a front is left
        // as far as it came.
        if open && !self.across.level.is_over_facets() {
            let mut to_height = self.clone();
            to_height.across.bounds.x_mm[0] =
                laid.last().iter().map(|n| self.height_mm(n)).fold(f64::INFINITY, f64::min);
            let mut rest = Rest::new(2 * PATIENCE[0]);
            let drawn = to_height.lay(laid.turns.clone(), progress, |turn| rest.stays(turn))?;
            if drawn.is_at_the_end() {
                return Ok(drawn);
            }
        }
        Ok(laid)
    }

    /// The end as a closed curve, in the direction of the turns: the last turn where it runs along
    /// the end all the way, else the last but one, closed. From where the turn before begins the
    /// next is near by on one side and it comes onto it by a smooth ramp, as a helix ends. Where
    /// turns follow one another at the end already, while the rest is not, a finer search tells
    /// better where it is, unless this one `is_finest`; over facets evened ways do.
    pub(super) fn end_of(&self, turns: &[Vec<TurnNode>], is_finest: bool) -> Option<Vec<Touch>> {
        if are_at_the_end(turns) {
            return turns.last().map(|last| self.smooth_end(&last[1..]));
        }
        let turn = turns.len().checked_sub(2).filter(|k| *k > 0).map(|k| &turns[k])?;
        if is_ring(turn) {
            let is_known = is_finest && !self.across.level.is_over_facets();
            return is_known.then(|| self.smooth_end(&turn[1..]));
        }
        let whole: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        let along = curve::tangents(None, &whole, None);
        let left = ramp(turn, RAMP_STEPOVERS * self.flat_mm);
        let last = turn.len() - 1;
        let on = (1..last).filter_map(|i| self.next_node(&turn[i], &whole, along[i], 1.0 - left[i]));
        Some(self.smooth_end(&on.chain([turn[last]]).collect::<Vec<_>>()))
    }

    /// The end's touches. Over facets single ones stop the ball, and the end goes round them; turns
    /// that were laid round such an island in their turn would run into one another: it is passed
    /// by.
    fn smooth_end(&self, end: &[TurnNode]) -> Vec<Touch> {
        let touches = |nodes: &[TurnNode]| nodes.iter().map(|n| n.touch).collect();
        if !self.across.level.is_over_facets() {
            return touches(end);
        }
        let width_mm = (ISLAND * self.flat_mm).min(2.0 * self.across.level.radius_mm);
        touches(&Overrun::of(&[], end, std::iter::empty()).without_islands(width_mm))
    }

    /// A ring moved up or down the part until its contacts are all at their mean height. `None`
    /// where the surface does not let it.
    pub(super) fn at_one_contact_height(&self, ring: &[Touch]) -> Option<Vec<Touch>> {
        let n = ring.len();
        let height = |t: &Touch| self.across.level.along.height_mm(&t.contact);
        let height_mm = ring.iter().map(height).sum::<f64>() / n as f64;
        let centre = |k: usize| Some(&ring[k % n].centre);
        let moved = |i: usize| {
            let along = curve::tangent(centre(i + n - 1), &ring[i], centre(i + 1));
            let mut place = Heading { touch: ring[i], along };
            for _ in 0..MOST_MOVES {
                let above_mm = height(&place.touch) - height_mm;
                if above_mm.abs() < LEAST_SHARE * self.flat_mm {
                    return Some(place.touch);
                }
                let to = if above_mm > 0.0 { place } else { place.back() };
                place.touch = self.across.step(&to, above_mm.abs().min(self.flat_mm), 0.8)?.0;
            }
            None
        };
        (0..n).into_par_iter().map(moved).collect()
    }

    /// A first turn, closed, along a ring.
    pub(super) fn along(&self, ring: &[Touch]) -> Vec<Vec<TurnNode>> {
        let node = |t: &Touch| TurnNode { touch: *t, way_mm: self.flat_mm, stop: None };
        vec![self.tidy(ring.iter().chain(ring.first()).map(node).collect())]
    }

    /// Lays turns after the ones there until `enough` says so of the last, or it runs along the end
    /// all the way, or the surface is lost.
    pub(super) fn lay(
        &self,
        turns: Vec<Vec<TurnNode>>,
        progress: &dyn Fn(f64) -> Result<()>,
        mut enough: impl FnMut(&[TurnNode]) -> bool,
    ) -> Result<Laid> {
        let mut laid = Laid { turns, lost: None };
        let length_mm = |turn: &[TurnNode]| arc_lengths(turn).last().copied().unwrap_or(0.0);
        let longest_mm = TOO_LONG * laid.turns.first().map_or(0.0, |t| length_mm(t)).max(self.round_mm);
        while let Some((last, before)) = laid.turns.split_last_mut() {
            progress(self.height_mm(&last[0]))?;
            match self.next_turn(before.last(), last) {
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
    fn next_turn(
        &self,
        before: Option<&Vec<TurnNode>>,
        turn: &mut Vec<TurnNode>,
    ) -> std::result::Result<Vec<TurnNode>, Point> {
        // The end of a closed turn comes before its own beginning.
        let tail = self.tail(before.unwrap_or(turn)).to_vec();
        // Beside a ring the ramp brings a turn as near to it as it likes: to bring it back would be
        // to go beyond the end.
        if let Some(before) = before.filter(|b| !is_ring(b)) {
            let head = self.head(before, turn);
            self.even_front(&tail, turn, &head);
        }
        let n = turn.len() - 1;
        let centre = |k: usize| turn[k].touch.centre;
        let back = before.map_or(centre(n - 1), |b| b[b.len() - 2].touch.centre);
        let closed = before.is_none();
        let shares = if closed { ramp(turn, RAMP_STEPOVERS * self.flat_mm) } else { vec![1.0; n + 1] };
        let touches: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        let ahead = centre(1);
        let along = curve::tangents(Some(&back), &touches, closed.then_some(&ahead));
        let round: Vec<Touch> = tail.iter().map(|n| n.touch).chain(touches).collect();
        let mut next: Vec<Option<TurnNode>> =
            (0..=n).into_par_iter().map(|i| self.next_node(&turn[i], &round, along[i], shares[i])).collect();
        next[0] = Some(turn[n]);
        if !closed && let Some(start) = next[1] {
            // The way on from the last touch is known only now: to the first of the new turn.
            let on = curve::tangent(Some(&centre(n - 1)), &turn[n].touch, Some(&start.touch.centre));
            next[n] = self.next_node(&turn[n], &round, on, 1.0);
        }
        if self.evens_ways {
            next = self.even_out(turn, &round, &along, &shares, next);
        }
        if self.is_path {
            self.leave_out_burrs(&mut next);
        }
        let kept = self.without_folds(&tail[..tail.len() - 1], turn, &along, &next)?;
        // On exact faces stretches that run into one another are found by their neighbours; a turn
        // round a thin edge may seem to cross itself there.
        let whole = if self.across.level.is_over_facets() {
            Overrun::of(&[], &kept, std::iter::empty()).without_loops()
        } else {
            kept
        };
        Ok(self.tidy(whole))
    }

    /// The end of a turn, as long as the evening of a front looks.
    fn tail<'n>(&self, turn: &'n [TurnNode]) -> &'n [TurnNode] {
        let s_mm = arc_lengths(turn);
        let whole = s_mm.last().copied().unwrap_or(0.0);
        &turn[s_mm.partition_point(|s| *s < whole - self.look_mm())..]
    }

    /// The beginning of the turn after `turn`, as long as the evening of a front looks; its first
    /// touch, the last of `turn`, left out.
    fn head(&self, before: &[TurnNode], turn: &[TurnNode]) -> Vec<TurnNode> {
        let count = arc_lengths(turn).partition_point(|s| *s <= self.look_mm());
        let touches: Vec<Touch> = turn.iter().map(|n| n.touch).collect();
        let first = &touches[..turn.len().min(count + 1)];
        let along = curve::tangents(Some(&before[before.len() - 2].touch.centre), first, None);
        let mut head: Vec<TurnNode> = Vec::with_capacity(count);
        let last = &turn[turn.len() - 1];
        for i in 1..count {
            let Some(next) = self.next_node(&turn[i], &touches, along[i], 1.0) else { continue };
            let step = next.touch.centre - head.last().unwrap_or(last).touch.centre;
            if step.dot(&along[i]) > 0.0 {
                head.push(next);
            }
        }
        head
    }

    /// The neighbour of one node of a turn, at the share `share` of the stepover.
    fn next_node(&self, node: &TurnNode, turn: &[Touch], along: Vector, share: f64) -> Option<TurnNode> {
        if node.stop.is_some() || share < LEAST_SHARE {
            return Some(TurnNode { way_mm: self.flat_mm, ..*node });
        }
        let from = Heading { touch: node.touch, along };
        let h_mm = self.scallop_mm * share * share;
        let Next { touch, way_mm, stop } = self.across.neighbour(&from, turn, h_mm, node.way_mm * share)?;
        if stop.is_none() && way_mm < STUCK * share * self.flat_mm {
            return None;
        }
        // A last, shortened way says nothing about the next.
        Some(TurnNode { touch, way_mm: if stop.is_some() { node.way_mm } else { way_mm / share }, stop })
    }
}

/// Shares of the stepover by which a turn leaves the ring before it: from 0 to 1 with continuous
/// curvature over the ramp's length. Round a thin edge the ball's centre goes a long way and its
/// contact hardly any: a ramp there would send every contact along the edge, so the shorter of the
/// two ways counts.
fn ramp(turn: &[TurnNode], ramp_mm: f64) -> Vec<f64> {
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
        let node = |touch| TurnNode { touch, way_mm: 1.0, stop: None };
        let turn: Vec<TurnNode> = there.chain(round).chain(back).map(node).collect();
        let shares = ramp(&turn, 4.0);
        assert!(shares.windows(2).all(|w| w[0] <= w[1]));
        assert!(shares[20..=40].iter().all(|s| (s - 0.5).abs() < 1e-9), "{shares:?}");
        assert_eq!((shares[0], shares[60]), (0.0, 1.0));
    }
}
