//! How long the path is beside the least that its area needs.
//!
//! A path whose every ridge is as high as the scallop allows has a strip of width `d(h, ρ)` for
//! each pass, `ρ` being the radius of curvature of the part across the passes; no path of that
//! scallop is shorter than
//! ```text
//! L_min = ∬ dA / d(h, ρ)
//! ```
//! over the area `A` that it machines. Both are taken along the contacts, over the inner turns: the
//! first and the last one close onto the boundaries and have a neighbour on one side only. `A` are
//! the places of the part whose ball is nearer to an inner turn than to those two, without what no
//! ball of this radius can reach.
//!
//! * On exact faces, `d` is [`width_on_part_mm`] of the true curvature, summed over even samples of
//!   `A`.
//! * A mesh has no curvature. There the ridges show it: a pass with spacing `w` and ridge `c` could
//!   have had `w sqrt(h/c)`, so `L_min = Σ ℓ sqrt(c/h)` over the pieces `ℓ` of the passes, half for
//!   the ridge on each side. This form is good to first order in `c/h − 1`; on exact faces it is
//!   computed too, as a second opinion.

use super::height::{REACH_SLACK, UNCUT, flat_stepover, lift, percentile};
use super::ridge::{self, Ridges};
use super::samples;
use super::sweep::Sweep;
use crate::artifact::report::{LimitFigures, LimitSource};
use crate::artifact::{Blade, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::geometry::allowance::Allowed;
use crate::parallel;
use crate::tool::scallop::width_on_part_mm;

/// Passes are compared with their neighbours at most at so many places.
const MOST_PLACES: usize = 6000;

/// Length, limit and ridges of the inner turns of any path over a blade, judged by the scallop
/// `scallop_mm`, with about `samples` samples of the surface.
///
/// # Errors
/// `Usage` where the path has fewer than two locations.
pub fn limit(blade: &Blade, path: &Toolpath, scallop_mm: f64, samples: usize) -> Result<LimitFigures> {
    if path.locations.len() < 2 {
        return Err(Error::usage(Stage::Verify, "the path has fewer than 2 cutter locations"));
    }
    let part = Allowed::new(&blade.part, path.stock_mm);
    Ok(measure(&part, &Sweep::cutting(path), scallop_mm, samples))
}

/// Whether a row belongs to a turn with neighbours on both sides; every row where there are fewer
/// than three turns.
fn inner(sweep: &Sweep, row: usize) -> bool {
    let (first, last) = ridge::outer_turns(sweep);
    sweep.touches(row) && (last < first + 2 || (sweep.turns[row] > first && sweep.turns[row] < last))
}

/// See [`limit`].
pub(super) fn measure(part: &Allowed, sweep: &Sweep, scallop_mm: f64, count: usize) -> LimitFigures {
    let n = sweep.centres.len();
    let path_length_mm: f64 = (0..n - 1).filter(|i| inner(sweep, *i)).map(|i| sweep.contact_way_mm(i)).sum();
    let (area_mm2, by_curvature_mm) = over_area(part, sweep, scallop_mm, count);
    let share = share_of_ridges(part, sweep, scallop_mm);
    let ratio_by_ridges = if share > 0.0 { 1.0 / share } else { 0.0 };
    let exact = part.brep.is_some() && by_curvature_mm > 0.0;
    let limit_length_mm = if exact { by_curvature_mm } else { path_length_mm * share };
    let ridges = ridge::all(part, sweep, scallop_mm, true);
    LimitFigures {
        area_mm2,
        path_length_mm,
        limit_length_mm,
        ratio: if limit_length_mm > 0.0 { path_length_mm / limit_length_mm } else { 0.0 },
        source: if exact { LimitSource::Curvature } else { LimitSource::Ridges },
        ratio_by_ridges,
        ridge_p05_mm: percentile(&ridges, 0.05),
        ridge_p50_mm: percentile(&ridges, 0.50),
        ridge_p95_mm: percentile(&ridges, 0.95),
        ridge_p99_mm: percentile(&ridges, 0.99),
        ridge_max_mm: percentile(&ridges, 1.0),
    }
}

/// Area of the inner turns, mm², and `∬ dA / d` over it, mm (0 on a mesh).
fn over_area(part: &Allowed, sweep: &Sweep, scallop_mm: f64, count: usize) -> (f64, f64) {
    let radius = sweep.radius_mm;
    let reach = (2.5 * flat_stepover(radius, scallop_mm)).max(0.4);
    let all = samples::near_path(part, sweep, reach, count);
    let share = |s: &samples::Sample| {
        let near = sweep.nearest(&(s.point + s.normal * radius), reach, |_| true)?;
        let row = near.segment + usize::from(near.t > 0.5);
        if !inner(sweep, row) || lift(part, &s.point, &s.normal, radius, REACH_SLACK * scallop_mm) > UNCUT * scallop_mm
        {
            return None;
        }
        let travel = sweep.centres[near.segment + 1] - sweep.centres[near.segment];
        let bend = s.on_face.as_ref().and_then(|at| part.curvature_at(at));
        let width = bend.and_then(|bend| width_on_part_mm(radius, scallop_mm, &bend, &travel));
        Some((part.area_ratio(s.on_face.as_ref()), width.map_or(0.0, |w| 1.0 / w)))
    };
    let shares: Vec<(f64, f64)> = parallel::filter_map(&all.points, share);
    // At a pole, or along a crease as round as the ball, there is no width: such samples count as
    // the mean of the others.
    let (mut area, mut known, mut sum) = (0.0, 0.0, 0.0);
    for (ratio, share) in shares {
        area += ratio;
        known += if share > 0.0 { ratio } else { 0.0 };
        sum += ratio * share;
    }
    let area_mm2 = area * all.area_mm2;
    (area_mm2, if known > 0.0 { area_mm2 * sum / known } else { 0.0 })
}

/// `Σ ℓ sqrt(c/h) / Σ ℓ` over the inner turns, half for the ridge on each side; 0 where no ridge
/// was met.
fn share_of_ridges(part: &Allowed, sweep: &Sweep, scallop_mm: f64) -> f64 {
    let n = sweep.centres.len();
    let every = n.div_ceil(MOST_PLACES);
    let rows: Vec<usize> = (0..n).step_by(every).filter(|row| inner(sweep, *row)).collect();
    let apart_mm = ridge::apart_mm(sweep.radius_mm, scallop_mm);
    let ridges = &Ridges { part, sweep, every, apart_mm, slack_mm: UNCUT * scallop_mm };
    let parts: Vec<(f64, f64)> = parallel::flat_map(rows, |row| {
        let turn = sweep.turns[row];
        let way = 0.5 * ridge::stretch_mm(sweep, row, every);
        let sides = [turn.checked_sub(1), turn.checked_add(1)];
        let share = move |other: u32| {
            let c = ridges.at(row, other)?;
            Some((way, way * (c.height_mm.max(0.0) / scallop_mm).sqrt()))
        };
        sides.into_iter().flatten().filter_map(share).collect::<Vec<_>>()
    });
    let (way, least) = parts.iter().fold((0.0, 0.0), |(w, l), (a, b)| (w + a, l + b));
    if way > 0.0 { least / way } else { 0.0 }
}
