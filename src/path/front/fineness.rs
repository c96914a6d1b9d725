//! What is not the same over facets and on exact faces.

use crate::path::level::LevelSet;

/// Figures by which turns are laid over one kind of surface.
pub struct Fineness {
    /// Distance of touches along a turn of the path, as a share of the stepover on flat ground:
    /// turns that go round something as small as a stepover are shaped by it, and facets are.
    pub touches: f64,
    /// The same of the turns that only look for the end; `None`: as far apart as rings have them.
    /// Round thin edges of exact faces coarse turns run up the part in folds where they follow each
    /// bend.
    pub touches_to_end: Option<f64>,
    /// Turn of the normal from touch to touch where the ball rolls round an edge, rad.
    pub touches_rad: f64,
    /// The share by which turns of the path are evened before the next is laid. Neighbours of a
    /// place that runs ahead do so, too: all of it at once leaves ridges that are too low, and the
    /// next turn swings back.
    pub back: f64,
    /// The same of the turns that only look for the end.
    pub back_to_end: f64,
    /// Ways this near to the one that leaves the ridge asked for, as a share, are right: over
    /// facets touches lie nearer to one another, and what a way is off by turns the next.
    pub good: f64,
    /// Ways this near are right after one more step by the law of squares.
    pub nearly: f64,
    /// Turn of the normal about one contact from which on an edge ends a path, rad: less are the
    /// edges between faces, and facets over curved ones.
    pub sharp_rad: f64,
    /// Round the end of an edge the contact moves by less than this share of what the centre does:
    /// an exact edge may curve there itself.
    pub round: f64,
    /// Width of a stretch without neighbours that is passed over, in two stepovers and three steps:
    /// single facets stop the ball.
    pub widest: f64,
}

/// Round an edge the contact moves, across the edge, by less than this share of what the centre
/// does: its radius is under a hundredth of the ball's.
pub const STILL: f64 = 0.01;

const EXACT: Fineness = Fineness {
    touches: 0.8,
    touches_to_end: None,
    touches_rad: 0.2,
    back: 0.4,
    back_to_end: 1.0,
    good: 5e-4,
    nearly: 0.02,
    sharp_rad: 0.6,
    round: 0.15,
    widest: 1.0,
};

const FACETS: Fineness = Fineness {
    touches: 0.25,
    touches_to_end: Some(0.5),
    touches_rad: 0.125,
    back: 0.3,
    back_to_end: 1.0,
    good: 1e-4,
    nearly: 0.004,
    sharp_rad: 1.0,
    round: STILL,
    widest: 2.0,
};

/// A ball's turn is smoother than the one before, and makes good what that was brought back by; a
/// cutter with a corner cuts with the front of its disc, which is nearly straight, and its turns
/// keep the noise of the first. It adds up.
const INCLINED: Fineness = Fineness { good: 1e-5, nearly: 1e-5, back: 0.0, back_to_end: 0.0, ..EXACT };

impl Fineness {
    /// The figures for the surface of a level set.
    pub fn of(level: &LevelSet) -> &'static Fineness {
        match (level.is_over_facets(), level.inclined.is_some()) {
            (true, _) => &FACETS,
            (false, true) => &INCLINED,
            (false, false) => &EXACT,
        }
    }
}
