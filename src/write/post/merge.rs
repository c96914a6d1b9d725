//! Moves joined where they are shorter in time than the control can read.
//!
//! Under inverse time `F = 1/Δt` has a greatest value, so a line takes at least `60/F` seconds. A
//! move that would take less is joined with the next, as long as all that is left out stays within
//! the chord tolerance of the line that remains. Where it would not, nothing is clamped: a
//! stretched line would be another motion than the one that was checked.

use super::moves::{Move, ball_centre};
use super::{Dialect, OperationRun};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::geometry::Point;
use crate::geometry::triangle::share_of_segment;

/// Share of the chord tolerance that joined moves may use: the rest is for rounding.
const SHARE: f64 = 0.9;
/// Places of a joined move looked at.
const WITHIN: usize = 8;
/// Times that are equal but for their last digits.
const SAME: f64 = 1e-9;

/// The moves, none shorter than `least_s`.
///
/// # Errors
/// `Infeasible` where moves are too short and cannot be joined.
pub(super) fn joined(run: &OperationRun, dialect: &Dialect, moves: Vec<Move>, least_s: f64) -> Result<Vec<Move>> {
    let long = |from: &Move, to: &Move| to.t_s - from.t_s >= least_s * (1.0 - SAME);
    if moves.windows(2).all(|w| long(&w[0], &w[1])) {
        return Ok(moves);
    }
    let mut kept: Vec<usize> = Vec::with_capacity(moves.len());
    for at in 0..moves.len() {
        let Some(&from) = kept.last() else {
            kept.push(at);
            continue;
        };
        if long(&moves[from], &moves[at]) {
            // The longest of what was passed by is what has to be within tolerance.
            if !close(run, dialect, &moves[from..=at]) {
                return Err(too_short(run, dialect, &moves[from], &moves[from + 1], least_s));
            }
            kept.push(at);
        }
    }
    // What is left at the end goes with the line before it.
    let last = moves.len() - 1;
    if kept.last() != Some(&last) {
        let short = kept.pop().unwrap_or(0);
        let from = kept.last().copied().unwrap_or(0);
        if !close(run, dialect, &moves[from..=last]) {
            return Err(too_short(run, dialect, &moves[short], &moves[last], least_s));
        }
        if kept.is_empty() {
            kept.push(0);
        }
        kept.push(last);
    }
    Ok(kept.into_iter().map(|k| moves[k]).collect())
}

/// Whether the straight move from the first to the last keeps to all that is between them, and they
/// to it.
fn close(run: &OperationRun, dialect: &Dialect, moves: &[Move]) -> bool {
    let (Some(from), Some(to)) = (moves.first(), moves.last()) else { return true };
    if moves.len() <= 2 {
        return true;
    }
    let allowed = SHARE * run.plan.toolpath.chord_mm;
    let programmed = dialect.file.programmed;
    let line: Vec<Point> =
        (0..=WITHIN).map(|k| ball_centre(run, programmed, from, to, k as f64 / WITHIN as f64)).collect();
    let path: Vec<Point> = moves.iter().map(|m| m.stand.centre).collect();
    let off = |q: &Point, way: &[Point]| way.windows(2).map(|w| to_segment(q, w)).fold(f64::INFINITY, f64::min);
    line.iter().all(|q| off(q, &path) <= allowed) && path.iter().all(|q| off(q, &line) <= allowed)
}

fn to_segment(q: &Point, ends: &[Point]) -> f64 {
    let share = share_of_segment(&ends[0], &ends[1], q);
    (q - (ends[0] + (ends[1] - ends[0]) * share)).norm()
}

fn too_short(run: &OperationRun, dialect: &Dialect, from: &Move, to: &Move, least_s: f64) -> Error {
    let (name, dt, f) = (&dialect.file.name, to.t_s - from.t_s, dialect.file.feed_range());
    let slower = run.plan.motion.feed.iter().copied().fold(0.0, f64::max) * 60.0 * (dt / least_s).max(0.01);
    Error::infeasible(
        Stage::Post,
        format!(
            "{name}: the move {:.3} s after the beginning takes {:.2} ms, which is F {:.3} under inverse time; the control reads up to \
             F {}, and joined with the next the line would leave the path by more than the chord tolerance of {} mm",
            from.t_s,
            1e3 * dt,
            60.0 / dt,
            f.greatest,
            run.plan.toolpath.chord_mm
        ),
        Infeasible::MoveTooShort { at_s: from.t_s, takes_s: dt, least_s, chord_mm: run.plan.toolpath.chord_mm },
    )
    .advise(format!(
        "take feed = \"per-minute\" in the post file, a larger path.chord_mm, or feed.feed_mm_min of about {slower:.0} and less"
    ))
}
