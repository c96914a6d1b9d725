//! What a finished curve must satisfy, checked apart from how it was made.

use super::bezier;
use super::corridor::Corridor;
use crate::artifact::Toolpath;
use crate::artifact::schedule::BezierPiece;
use crate::error::{Error, Infeasible, Result, Stage, turn_number};

/// Rounding that is no finding, rad.
const ROUNDING: f64 = 1e-8;

/// `turn 3, S = 12.5 mm` of a location.
pub(super) fn place(path: &Toolpath, row: usize) -> String {
    let l = path.locations.get(row);
    l.map_or_else(String::new, |l| format!("turn {}, S = {:.3} mm", turn_number(l.turn), l.turn_s_mm))
}

/// The curve has no gaps, never turns back where it is not to, and is inside the hull at all
/// locations and half-way between.
///
/// # Errors
/// Kind `Infeasible`, with turn and S.
pub(super) fn inside(pieces: &[BezierPiece], theta: &[f64], hull: &Corridor, path: &Toolpath) -> Result<()> {
    let fail = |row: usize, what: String| {
        let since = Infeasible::ScheduleFails { at: path.along(row) };
        Err(Error::infeasible(Stage::Schedule, format!("the schedule made {what} at {}", place(path, row)), since)
            .advise("lower schedule.margin_deg or give schedule.level_stretch_mm"))
    };
    let row_at = |s: f64| hull.s.partition_point(|v| *v <= s).saturating_sub(1);
    for (i, p) in pieces.iter().enumerate() {
        let gap = i.checked_sub(1).and_then(|k| pieces.get(k)).is_some_and(|q| q[3] != p[0]);
        let back = |w: &[[f64; 2]]| hull.one_way && w[1][1] < w[0][1] - ROUNDING;
        if gap || p.windows(2).any(|w| w[1][0].is_nan() || w[1][0] < w[0][0] || w[1][1].is_nan() || back(w)) {
            return fail(row_at(p[0][0]), "has a gap or turns back".into());
        }
    }
    if theta.len() != hull.s.len() {
        return fail(theta.len(), "does not cover the whole path".into());
    }
    let middle: Vec<f64> = hull.s.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
    let between = bezier::sample_as(hull.one_way, pieces, &middle);
    for (i, at_row) in hull.s.iter().copied().zip(theta.iter().copied()).enumerate() {
        let after = middle.get(i).zip(between.get(i)).map(|(s, t)| (*s, *t));
        for (s, t) in [Some(at_row), after].into_iter().flatten() {
            let [lo, hi] = hull.at(s);
            let outside = (lo - t).max(t - hi);
            if outside.is_nan() || outside > ROUNDING {
                return fail(i, format!("leaves the channel by {} deg", outside.to_degrees()));
            }
        }
    }
    if let Some(i) = theta.windows(2).position(|w| hull.one_way && w[1] < w[0]) {
        return fail(i, "turns back".into());
    }
    Ok(())
}
