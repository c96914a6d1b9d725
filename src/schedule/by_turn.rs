//! The optimal schedule turn by turn: each turn is planned together with the one after it, and
//! kept.
//!
//! Where a turn ends, angle, slope and second derivative are what is best for both (free joints);
//! the next turn begins with them. The work and memory of a turn do not depend on how many there
//! are, and what lies beyond the next turn cannot change what is kept: a schedule may be begun
//! before the path is finished. Each turn's own peak (or square) is made little, not the greatest
//! of all; no bound is proved for that.

use super::corridor::Corridor;
use super::rounds::{Contradicting, Goal, Solved, SolverUnits, round_from};
use crate::artifact::Toolpath;
use crate::artifact::schedule::Measure;

/// Value, slope and second derivative for every sample of the walls.
pub(super) fn solve(
    path: &Toolpath,
    walls: &Corridor,
    measure: Measure,
    scale: &SolverUnits,
) -> std::result::Result<Solved, Contradicting> {
    let third = matches!(measure, Measure::PeakThird | Measure::SquareThird);
    let last = walls.s.len() - 1;
    let bases = path.turns.iter().skip(1).filter_map(|t| path.locations.get(t.first)).map(|l| l.s_mm);
    let mut joints = vec![0];
    joints.extend(bases.map(|s| walls.s.partition_point(|w| *w < s)));
    joints.push(last);
    // Turns of a few samples are planned with the one before.
    joints.dedup_by(|b, a| *b < *a + FEWEST && *b != last);
    if joints.len() > 2 && joints[joints.len() - 1] < joints[joints.len() - 2] + FEWEST {
        joints.remove(joints.len() - 2);
    }
    let (mut theta, mut slope) = (Vec::with_capacity(last + 1), Vec::with_capacity(last + 1));
    let mut from: Option<[f64; 3]> = None;
    for (k, pair) in joints.windows(2).enumerate() {
        let [a, b] = [pair[0], pair[1]];
        let end = joints.get(k + 2).copied().unwrap_or(last);
        let [s, lo, hi] = [&walls.s, &walls.lo, &walls.hi].map(|v| v[a..=end].to_vec());
        let part = Corridor { s, lo, hi, one_way: walls.one_way };
        let goal = match measure {
            Measure::PeakSecond | Measure::PeakThird => {
                let borders = (a..end).map(|i| i + 1 == b).collect();
                Goal::Turns { third, cap: f64::INFINITY, borders }
            }
            Measure::SquareSecond | Measure::SquareThird => Goal::Square { third },
        };
        let in_all = |Contradicting(about)| Contradicting(about.into_iter().map(|i: usize| a + i).collect());
        let found = round_from(&part, scale, &goal, 1e-5, from).map_err(in_all)?;
        let keep = if end == b { b - a + 1 } else { b - a };
        for (i, v) in found.v.iter().enumerate().take(keep) {
            theta.push(scale.line(&part, i) + v[0]);
            slope.push(scale.base[1] + v[1] / scale.length);
        }
        from = found.v.get(b - a).map(|v| [v[0], v[1], v[2]]);
        if end == b {
            break;
        }
    }
    if theta.len() != last + 1 {
        return Err(Contradicting(Vec::new()));
    }
    Ok(Solved { walls: walls.clone(), theta, slope, weights: Vec::new() })
}

/// Samples of a turn at least.
const FEWEST: usize = 8;
