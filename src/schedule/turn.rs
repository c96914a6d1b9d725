//! One decoupled stretch of the path, from base point to base point: linear schedule and smoothing.

use std::f64::consts::TAU;

use super::bezier::{self, CornerReach};
use super::corridor::{Corridor, PathAngle, slope};
use super::keys::{self, PathSpan, SpanEnd, Walls};
use super::options::Pace;
use crate::artifact::schedule::BezierPiece;

/// Share of the local width that an inset may take on either side.
pub(super) const MOST: f64 = 0.4;
/// Insets of the key points from the walls that are tried, in shares of that of the base points.
const SHARES: [f64; 3] = [1.0, 0.5, 0.2];
/// θ is divided by so much where angles of the S–θ plane are taken (and S by the length of the
/// stretch). Many turns: slopes become small angles, whose bisector is the mean slope; both halves
/// of a corner are then equally long in S, which makes the greater of their peaks least.
const THETA_SCALE: f64 = 100.0 * TAU;
/// Share of a stretch over which key points come to their distance from the walls, behind an angle
/// that is given.
const RAMP: f64 = 0.05;
/// Angles tried at a free end.
const FREE: usize = 5;

/// What was made of it.
#[derive(Clone, Debug)]
pub(super) struct Smoothed {
    pub keys: Vec<PathAngle>,
    pub pieces: Vec<BezierPiece>,
    /// See [`cost`].
    pub cost: f64,
}

/// What is made least: the multiple of the rotary axis' limits that the pieces need at the
/// programmed feed, or, where those are not known, the greatest |d²θ/ds²|, rad/mm².
fn cost(pieces: &[BezierPiece], pace: Option<Pace>) -> f64 {
    let most = |f: fn(&BezierPiece) -> f64| pieces.iter().map(f).fold(0.0, f64::max);
    let second = most(bezier::peak_acceleration);
    pace.map_or(second, |p| p.needed(most(bezier::peak_rate), second))
}

/// Plans one stretch with key points inset by shares of `inset` and keeps the one with the least
/// cost. `walls`: where the curve may be. `Err`: the key point in which the channel leaves no room
/// to bend.
pub(super) fn plan(
    walls: &Corridor,
    stretch: &PathSpan,
    inset: f64,
    pace: Option<Pace>,
) -> Result<Smoothed, PathAngle> {
    let local = walls.between(stretch.from, stretch.to);
    let mut best: Option<Smoothed> = None;
    let mut stuck = [stretch.from, 0.0];
    for share in SHARES {
        match with_inset(&local, stretch, share * inset, pace) {
            Ok(found) if best.as_ref().is_none_or(|b| found.cost < b.cost) => best = Some(found),
            Ok(_) => {}
            Err(at) => stuck = at,
        }
    }
    best.ok_or(stuck)
}

/// One inset: all angles of the free ends.
fn with_inset(curve: &Corridor, stretch: &PathSpan, inset: f64, pace: Option<Pace>) -> Result<Smoothed, PathAngle> {
    // A given angle may be on a wall: the string leaves that little by little.
    let length = RAMP * (stretch.to - stretch.from);
    let given = [stretch.start, stretch.end].map(|e| matches!(e, SpanEnd::Free(Some(_))).then_some(length));
    let shrunk = |inset: f64, most: f64| curve.shrunk(inset, most).eased(curve, given);
    let walls = Walls { curve: curve.clone(), string: shrunk(inset, MOST), lines: shrunk(0.5 * inset, 0.5 * MOST) };
    let choices = |end: SpanEnd, s: f64| match end {
        SpanEnd::Level(theta, _) | SpanEnd::Free(Some(theta)) => vec![theta],
        SpanEnd::Free(None) => {
            let [lo, hi] = walls.string.at(s);
            (0..FREE).map(|i| lo + (hi - lo) * i as f64 / (FREE - 1) as f64).collect()
        }
    };
    let mut best: Option<Smoothed> = None;
    let mut stuck = [stretch.from, 0.0];
    for start in choices(stretch.start, stretch.from) {
        for end in choices(stretch.end, stretch.to) {
            if start > end {
                continue;
            }
            let keys = keys::linear(&walls, stretch, start, end);
            match smooth(&keys, curve, stretch, pace) {
                Ok(found) if best.as_ref().is_none_or(|b| found.cost < b.cost) => best = Some(found),
                Ok(_) => {}
                Err(at) => stuck = at,
            }
        }
    }
    best.ok_or(stuck)
}

/// What the corner `p` may use.
fn reach(p: [PathAngle; 3], curve: &Corridor, stretch: &PathSpan) -> CornerReach {
    let [before, after] = keys::reaches(p, stretch);
    let [p1, p2, p3] = p;
    let (m1, m2) = (slope(p1, p2), slope(p2, p3));
    let r1 = curve.room([p2[0] - before, p2[1] - m1 * before], p2);
    let r2 = curve.room(p2, [p2[0] + after, p2[1] + m2 * after]);
    let side = usize::from(m2 > m1);
    let length = stretch.to - stretch.from;
    CornerReach { s_mm: [before, after], room_rad: r1[side].min(r2[side]).max(0.0), scale: [length, THETA_SCALE] }
}

/// Rounds all corners and fills in the straight stretches.
fn smooth(keys: &[PathAngle], curve: &Corridor, stretch: &PathSpan, pace: Option<Pace>) -> Result<Smoothed, PathAngle> {
    let (Some(&first), Some(&last)) = (keys.first(), keys.last()) else { return Err([stretch.from, 0.0]) };
    let mut pieces = Vec::with_capacity(3 * keys.len());
    let mut at = first;
    // A shorter straight stretch would be all rounding: the corner's curve begins earlier on the
    // same line instead.
    let least = 1e-4 * (stretch.to - stretch.from);
    for i in 1..keys.len().saturating_sub(1) {
        let r = reach([keys[i - 1], keys[i], keys[i + 1]], curve, stretch);
        let Some(corner) = bezier::corner(keys[i - 1], keys[i], keys[i + 1], &r) else { continue };
        if r.room_rad <= 1e-12 {
            return Err(keys[i]);
        }
        let [mut p, q] = corner;
        if p[0][0] - at[0] > least {
            pieces.push(bezier::straight(at, p[0]));
        } else {
            p[0] = at;
        }
        at = q[3];
        pieces.extend([p, q]);
    }
    if last[0] - at[0] > least {
        pieces.push(bezier::straight(at, last));
    } else if let Some(p) = pieces.last_mut() {
        p[3] = last;
    } else {
        pieces.push(bezier::straight(first, last));
    }
    let cost = cost(&pieces, pace);
    Ok(Smoothed { keys: keys.to_vec(), pieces, cost })
}
