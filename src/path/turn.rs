//! What a turn is made of, and by what turns are laid.

use super::bounds::Stop;
use super::level::Touch;
use super::neighbour::Across;

/// Nodes of the closed ring that are left by less than this share of a stepover stay.
pub(super) const LEAST_SHARE: f64 = 1e-3;

/// A touch of a turn, with how it came from the turn before.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurnNode {
    pub(super) touch: Touch,
    /// Way from the turn before, mm.
    pub(super) way_mm: f64,
    /// Why it is at the end of the region.
    pub(super) stop: Option<Stop>,
}

/// Lays turns from one ring on, to the right of the way it runs: down if it runs counter-clockwise
/// seen from the tip, else up.
#[derive(Clone)]
pub(super) struct March<'a> {
    pub(super) across: Across<'a>,
    /// Scallop between turns, mm.
    pub(super) scallop_mm: f64,
    /// Stepover on flat ground, mm.
    pub(super) flat_mm: f64,
    /// Usual distance of touches along a turn, mm.
    pub(super) step_mm: f64,
    /// Way round the part at the start height, mm: the end may run round no more than a corner of
    /// it.
    pub(super) round_mm: f64,
    /// The share of what a place of a turn runs ahead of its neighbours by which it is brought back
    /// before the next turn is laid.
    pub(super) back: f64,
    /// Whether ways that scatter over facets are evened out along a turn.
    pub(super) evens_ways: bool,
    /// Whether the turns are those of the path, on a surface over which turns went already: a place
    /// where a wall or an edge stops the ball is a burr there, and passed by where the turn goes on
    /// close to both sides of it.
    pub(super) is_path: bool,
}
