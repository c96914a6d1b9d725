//! The end of the region, looked for by turns and closed.

use super::laying::{Laid, Rest, are_at_the_end, ramp};
use super::neighbour::Heading;
use super::node::{LEAST_SHARE, Node, is_ring};
use super::overrun::Overrun;
use super::{Front, RAMP_STEPOVERS};
use crate::error::Result;
use crate::parallel;
use crate::path::curve;
use crate::path::level::Touch;

/// Moves, each of a stepover at most, of a place of a ring to the height of the others' contacts.
const MOST_MOVES: usize = 60;
/// Islands in the end that are narrower than so many stepovers of the turns that look for it are
/// passed by. Never wider than two radii: so far apart are balls on both sides of a thin part.
const ISLAND: f64 = 2.0;
/// Turns that may come no nearer to the end before one is drawn where none was given, and before a
/// given one counts as out of reach.
pub const PATIENCE: [usize; 2] = [3, 100];

impl Front<'_> {
    /// Lays turns until one runs along the end all the way, or the surface is lost. Where the end
    /// is `open`, and some places have come to a wall or an edge but no more do, the end is drawn
    /// at the height that the others have then.
    pub fn find_end(&self, ring: &[Touch], open: bool, progress: &dyn Fn(f64) -> Result<()>) -> Result<Laid> {
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
    /// turns follow one another at the end already, while the rest is not, a finer search finds
    /// better where it is, unless this one `is_finest`; over facets evened ways do.
    pub fn end_of(&self, turns: &[Vec<Node>], is_finest: bool) -> Option<Vec<Touch>> {
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
        let on = (1..last).filter_map(|i| self.neighbour_of(&turn[i], &whole, along[i], 1.0 - left[i]));
        Some(self.smooth_end(&on.chain([turn[last]]).collect::<Vec<_>>()))
    }

    /// The end's touches. Over facets single ones stop the ball, and the end goes round them; turns
    /// that were laid round such an island in their turn would run into one another: it is passed
    /// by.
    fn smooth_end(&self, end: &[Node]) -> Vec<Touch> {
        let touches = |nodes: &[Node]| nodes.iter().map(|n| n.touch).collect();
        if !self.across.level.is_over_facets() {
            return touches(end);
        }
        let width_mm = (ISLAND * self.flat_mm).min(2.0 * self.across.level.radius_mm);
        touches(&Overrun::of(&[], end, std::iter::empty()).without_islands(width_mm))
    }

    /// A ring moved up or down the part until its contacts are all at their mean height. `None`
    /// where the surface does not let it.
    pub fn at_one_contact_height(&self, ring: &[Touch]) -> Option<Vec<Touch>> {
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
        parallel::map(0..n, moved).into_iter().collect()
    }
}
