//! A turn kept even before the next is laid from it.
//!
//! Laid touch by touch, a turn keeps every corner of the one before: where two of its sides run
//! towards one another, they meet in an edge, and over facets the ways scatter. So a place that
//! runs ahead of the smooth curve through its neighbours is brought back towards it. None is
//! brought forward: no ridge becomes higher than asked for, and what a place loses, the next turn
//! makes good.

use nalgebra::{Matrix3, Vector3};

use super::Front;
use super::neighbour::Heading;
use super::node::{Node, arc_lengths};
use crate::parallel;
use crate::path::curve;
use crate::path::level::Touch;

/// Widths of the bell that a fit reaches.
const REACH: f64 = 2.5;
/// Fewest touches of a fit.
const FEWEST: usize = 5;
/// No more than this share of the stepover counts as running ahead.
const MOST: f64 = 0.4;
/// So far ahead of its neighbours a touch may stay, as a share of the stepover on flat ground.
const AHEAD: f64 = 1e-3;

impl Front<'_> {
    /// Width of the bell over which a turn is evened: the stepover on flat ground or the step
    /// between touches, whichever is longer, mm.
    fn even_mm(&self) -> f64 {
        self.flat_mm.max(self.step_mm)
    }

    /// How far along the turns before and after the evening of one looks, mm.
    pub fn look_mm(&self) -> f64 {
        REACH * self.even_mm()
    }

    /// The turn with its touches that run ahead brought back; `before` ends with the touch that the
    /// turn begins with, which stays, and `after` goes on from its last.
    pub fn even_turn(&self, before: &[Node], turn: &mut [Node], after: &[Node]) {
        let width_mm = self.even_mm();
        let lead = before.len().saturating_sub(1);
        let chain: Vec<Node> = before[..lead].iter().chain(turn.iter()).chain(after).copied().collect();
        let s_mm = arc_lengths(&chain);
        let touches: Vec<Touch> = chain.iter().map(|n| n.touch).collect();
        let along = curve::tangents(None, &touches, None);
        let even = |k: usize| -> Option<Touch> {
            let from = Heading { touch: touches[k], along: along[k] };
            let side = from.along.cross(&from.touch.normal).try_normalize(1e-6)?;
            let lo = s_mm.partition_point(|s| *s < s_mm[k] - REACH * width_mm);
            let hi = s_mm.partition_point(|s| *s <= s_mm[k] + REACH * width_mm);
            // A place at the end stays behind because it must: what goes on beside it is not ahead.
            let lo = (lo..k).rev().find(|j| chain[*j].stop.is_some()).map_or(lo, |j| j + 1);
            let hi = (k + 1..hi).find(|j| chain[*j].stop.is_some()).unwrap_or(hi);
            if hi - lo < FEWEST || lo == k || hi == k + 1 {
                return None;
            }
            let (mut a, mut b) = (Matrix3::zeros(), Vector3::zeros());
            for j in lo..hi {
                let t = (s_mm[j] - s_mm[k]) / width_mm;
                let (row, weight) = (Vector3::new(1.0, t, t * t), (-t * t).exp());
                a += row * row.transpose() * weight;
                b += row * (weight * (touches[j].centre - from.touch.centre).dot(&side));
            }
            let ahead_mm = -(a.try_inverse()? * b).x - AHEAD * self.flat_mm;
            if ahead_mm <= 0.0 {
                return None;
            }
            self.across.step(&from.back(), self.back * ahead_mm.min(MOST * self.flat_mm), 0.8).map(|(touch, _)| touch)
        };
        let evened: Vec<Option<Touch>> =
            parallel::map(1..turn.len(), |i| if turn[i].stop.is_some() { None } else { even(lead + i) });
        for (node, touch) in turn[1..].iter_mut().zip(evened) {
            node.touch = touch.unwrap_or(node.touch);
        }
    }
}
