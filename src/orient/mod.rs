//! Which tool axes the schedule may choose from at each location of a path, where that is not the
//! one cone of a blade root.
//!
//! **In** a [`Toolpath`], the rotor axis and the radial direction of the blade, and what is free of
//! the part and the other blades on circles of tool axes (from `channel/`). **Out** cones, one
//! for each location.
//!
//! **Method.**
//! * *Reference planes* ([`reference_planes`]): Chen, Xu and Tang, Journal of Computational Design
//!   and Engineering 2 (2015) 197–205, equation 2.1. The plane's axes are the cone with lean 0
//!   about `radial × normal`.
//! * *Five axes*: a grid of directions about the rotor axis ([`DirectionGrid`]), of which closed
//!   arcs say what is free ([`free_cells`]); the way through it that turns least and keeps away
//!   from what is taken ([`least_way`]). `plan/` then lets latitude and longitude follow smooth
//!   curves in walls that are exact: the one with the other held, in turn.
//!
//! **Guarantees.** [`least_way`] is the least of all ways over the grid. That the tool is clear is
//! not said here: `channel/` and the checks look at the cones that come out.

mod field;
mod planes;
mod settings;

use crate::artifact::Toolpath;

pub use field::{DirectionGrid, FreeCells, NARROW, Way, free_cells, holds, least_way, wide_cells};
pub use planes::reference_planes;
pub use settings::{OrientationKeys, OrientationKind, OrientationSettings};

/// Rows of a path that stand for it: the first, the last, and some between. From one to the next
/// the ball centre goes no farther than `step_mm` and the normal turns no more than `turn_rad`,
/// where locations are that near.
pub fn stations(path: &Toolpath, step_mm: f64, turn_rad: f64) -> Vec<usize> {
    let mut out = vec![0];
    let Some(last) = path.locations.len().checked_sub(1) else { return Vec::new() };
    for row in 1..last {
        let from = &path.locations[out[out.len() - 1]];
        let next = &path.locations[row + 1];
        if next.s_mm - from.s_mm > step_mm || next.normal.angle(&from.normal) > turn_rad {
            out.push(row);
        }
    }
    if last > 0 {
        out.push(last);
    }
    out
}

/// Values at stations, straight between them over arc length, at every location of the path.
pub fn between_stations(path: &Toolpath, stations: &[usize], values: &[f64]) -> Vec<f64> {
    let mut k = 0;
    let at = |row: usize| path.locations.get(row).map_or(0.0, |l| l.s_mm);
    (0..path.locations.len())
        .map(|row| {
            while k + 2 < stations.len() && stations[k + 1] <= row {
                k += 1;
            }
            let (Some(a), Some(va)) = (stations.get(k), values.get(k)) else { return 0.0 };
            let (Some(b), Some(vb)) = (stations.get(k + 1), values.get(k + 1)) else { return *va };
            let length = at(*b) - at(*a);
            let share = if length > 0.0 { ((at(row) - at(*a)) / length).clamp(0.0, 1.0) } else { 0.0 };
            va + (vb - va) * share
        })
        .collect()
}
