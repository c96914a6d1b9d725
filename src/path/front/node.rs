//! What a turn is made of.

use crate::path::bounds::Stop;
use crate::path::curve;
use crate::path::level::Touch;

/// Nodes of the closed ring that are left by less than this share of a stepover stay.
pub const LEAST_SHARE: f64 = 1e-3;

/// A touch of a turn, with how it came from the turn before.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    pub touch: Touch,
    /// Way from the turn before, mm.
    pub way_mm: f64,
    /// Why it is at the end of the region.
    pub stop: Option<Stop>,
}

/// Whether a turn is closed: a ring, from which the first turn is laid, or one whose seam rests at
/// the end of the region.
pub fn is_ring(turn: &[Node]) -> bool {
    turn.first().zip(turn.last()).is_some_and(|(a, b)| a.touch.centre == b.touch.centre)
}

/// Arc lengths of a turn at its nodes, mm.
pub fn arc_lengths(turn: &[Node]) -> Vec<f64> {
    curve::arc_lengths(turn.iter().map(|n| &n.touch.centre))
}
