//! What the search has still to open: nodes and pieces, the one that may move an end farthest
//! first.

use std::cmp::Ordering;

use crate::geometry::Vector;

/// Something whose points may forbid more than is known.
pub(super) struct Open {
    pub excess: f64,
    pub what: What,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum What {
    /// Body and node.
    Node(u16, u32),
    /// Index into the workspace's pieces.
    Piece(usize),
}

/// A piece of a triangle during a part of the motion, seen from the ball centre, turned.
#[derive(Clone, Copy)]
pub(super) struct TurnedPiece {
    pub body: u16,
    pub leaf: u32,
    /// In the middle of its time.
    pub corners: [Vector; 3],
    /// Middle of its time and half its length, as shares of half the motion.
    pub time: f64,
    pub share: f64,
    pub centre: Vector,
    pub radius: f64,
    pub reach: f64,
    /// What of that no smaller piece has less of, mm.
    pub fixed: f64,
}

impl TurnedPiece {
    pub fn whole(body: u16, leaf: u32, corners: [Vector; 3]) -> Self {
        TurnedPiece {
            body,
            leaf,
            corners,
            time: 0.0,
            share: 1.0,
            centre: Vector::zeros(),
            radius: 0.0,
            reach: 0.0,
            fixed: 0.0,
        }
    }
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        self.excess.total_cmp(&other.excess).then(other.what.cmp(&self.what))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}
