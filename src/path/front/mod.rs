//! A front of turns: each is laid from the turn beside it, touch by touch, as far across as leaves
//! the scallop.
//!
//! Lines a constant scallop apart are the offsets of one another in the metric of the ridge
//! (T. Kim, Constant cusp height tool paths as geodesic parallels on an abstract Riemannian
//! manifold, Computer-Aided Design 39, 2007; the neighbour by the ridge itself as in K. Suresh and
//! D. C. H. Yang, Constant scallop-height machining of free-form surfaces, J. Eng. Ind. 116, 1994).
//! An offset runs into itself where its curve bends more than it reaches, and what lies beyond the
//! crossings is left out, as with any offset (M. Held, On the computational geometry of pocket
//! machining, LNCS 500, 1991). From a turn to the next, in this order:
//!
//! | stage | file | from | to |
//! | --- | --- | --- | --- |
//! | evened | `evening` | the turn | the turn, nothing of it ahead of its neighbours |
//! | neighbours | `neighbour` | the turn | [`Neighbours`]: one for each node, or none |
//! | ways evened | `ways` | neighbours over facets | the same, ways of a mean length |
//! | burrs | `folds` | neighbours | the same, without short stretches that stay behind |
//! | unfolded | `folds` | neighbours | [`Unfolded`](folds::Unfolded): those that go on |
//! | bridged | `corners` | those that go on | nodes, also across the corners between them |
//! | loops | `overrun` | nodes over facets | nodes that do not cross themselves |
//! | spaced | `spacing` | nodes | the next turn |
//!
//! `laying` puts the stages in this order; `first_order` has the neighbours of a published method
//! to compare with; `end` looks for the end of the region with turns, and
//! closes it.

mod corners;
mod end;
mod evening;
mod fineness;
mod first_order;
mod folds;
mod laying;
mod neighbour;
mod node;
mod overrun;
mod spacing;
mod ways;

pub use end::PATIENCE;
pub use fineness::Fineness;
pub use laying::{Laid, Rest};
pub use neighbour::Across;
pub use node::Node;

/// Touches farther from one another than this share of the usual step are too few.
const FAR: f64 = 1.5;
/// Length of the ramp from a turn to the next, in stepovers on flat ground: steep enough to be
/// short, and so gentle that the path tilts by less than 6° and its radius in the surface is over
/// 60 stepovers.
const RAMP_STEPOVERS: f64 = 20.0;

/// The neighbours of a turn's nodes; `None` where the ball cannot go, or is not to.
type Neighbours = Vec<Option<Node>>;

/// How turns are laid from one another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// By the ridge between the two turns, measured on the part.
    Ridges,
    /// By first-order widths and steps, as published, see `first_order`.
    FirstOrder,
    /// The same, and each turn is a closed ring.
    FirstOrderRings,
}

/// Lays turns from one ring on, to the right of the way it runs: down if it runs counter-clockwise
/// seen from the tip, else up.
#[derive(Clone)]
pub struct Front<'a> {
    pub across: Across<'a>,
    /// Scallop between turns, mm.
    pub scallop_mm: f64,
    /// Stepover on flat ground, mm.
    pub flat_mm: f64,
    /// Usual distance of touches along a turn, mm.
    pub step_mm: f64,
    /// The same where the ball rolls round an edge, mm: no more.
    pub round_edges_mm: f64,
    /// Way round the part at the start height, mm: the end may run round no more than a corner of
    /// it.
    pub round_mm: f64,
    /// The share of what a place of a turn runs ahead of its neighbours by which it is brought back
    /// before the next turn is laid.
    pub back: f64,
    /// Whether ways that scatter over facets are evened out along a turn.
    pub evens_ways: bool,
    /// Whether the turns are those of the path, on a surface over which turns went already: a place
    /// where a wall or an edge stops the ball is a burr there, and passed by where the turn goes on
    /// close to both sides of it.
    pub is_path: bool,
    /// How neighbours are found.
    pub by: By,
}
