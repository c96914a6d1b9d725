//! Rows beside the first, one after another towards an edge.

use std::collections::BTreeMap;

use super::sheet::{OrEnd, RowCurves, Sheet, Standing, along_row};
use super::{MOST_ROWS, no_pairs};
use crate::artifact::along::Along;
use crate::artifact::paired::RowEnd;
use crate::error::{Result, Stage};
use crate::numerics::runs::longest;
use crate::observe::Observer;
use crate::parallel;

/// The share of the scallop that rows aim at; chords and places between heights take the rest.
const AIM: f64 = 0.99;
/// A ridge within this share of the aim is near enough.
const NEAR_ENOUGH: f64 = 0.003;
/// Where the ridge between two heights is over the aim by more than this factor, the row is drawn
/// in there …
const OVER: f64 = 1.02;
/// … so many times at most …
const DRAWINGS: usize = 6;
/// … and each time to no less than this share of the step.
const LEAST_SHARE: f64 = 0.7;
/// A row over fewer heights is left to the edge beside it.
const LEAST_ROW: usize = 4;
/// Trials of a step.
const TRIALS: usize = 12;
/// A row within this share of the flat stepover of the row before is not worth running.
const LEAST_STEP: f64 = 0.05;

/// Rows on one side of the first.
pub(super) struct LaidSide {
    pub rows: Vec<Vec<Option<Standing>>>,
    /// Why they ended, with the number of heights.
    pub ends: BTreeMap<RowEnd, usize>,
    /// Greatest ridge on each side of the blade, mm.
    pub greatest_mm: [f64; 2],
}

/// A place of the next row, the step that led to it, and the ridges that it leaves, mm.
struct Next {
    at: Standing,
    step_mm: f64,
    ridges_mm: [f64; 2],
}

/// The rows from the first on, counter-clockwise seen from the tip where the sign is positive,
/// until no place has an opposite one.
///
/// # Errors
/// Kind `Infeasible` for more rows than can be meant; kind `Cancelled`.
pub(super) fn side_of(
    sheet: &Sheet,
    first: &[Option<Standing>],
    (sign, flat_mm): (f64, f64),
    observer: &dyn Observer,
) -> Result<LaidSide> {
    let mut out = LaidSide { rows: Vec::new(), ends: BTreeMap::new(), greatest_mm: [0.0; 2] };
    let aim_mm = AIM * sheet.options.settings.scallop_mm;
    let mut last = first.to_vec();
    let mut steps_mm = vec![flat_mm; last.len()];
    while out.rows.len() < MOST_ROWS {
        observer.check(Stage::Path)?;
        let curves = RowCurves::of(&last);
        let one = |k: usize| {
            let from = last[k].as_ref()?;
            Some(next(sheet, (&last, &curves, k), from, (sign, steps_mm[k], flat_mm)))
        };
        let found: Vec<Option<OrEnd<Next>>> = parallel::map(0..last.len(), one);
        let kept = longest(&found.iter().map(|f| matches!(f, Some(Ok(_)))).collect::<Vec<_>>());
        for (k, f) in found.iter().enumerate() {
            match f {
                Some(Err(end)) => *out.ends.entry(*end).or_default() += 1,
                // Beside a gap, or alone.
                Some(Ok(_)) if !kept.contains(&k) || kept.len() < LEAST_ROW => {
                    *out.ends.entry(RowEnd::NoPartner).or_default() += 1;
                }
                _ => {}
            }
        }
        if kept.len() < LEAST_ROW {
            return Ok(out);
        }
        let (mut row, mut ridges_mm) = (vec![None; last.len()], vec![[0.0f64; 2]; last.len()]);
        for (k, f) in found.into_iter().enumerate().filter(|(k, _)| kept.contains(k)) {
            let Some(Ok(next)) = f else { continue };
            (row[k], steps_mm[k], ridges_mm[k]) = (Some(next.at), next.step_mm, next.ridges_mm);
        }
        for _ in 0..DRAWINGS {
            let both = [&curves, &RowCurves::of(&row)];
            let between = parallel::map(kept.start..kept.end - 1, |k| sheet.ridge_between_mm(both, k));
            let mut shares = vec![1.0f64; last.len()];
            for (k, ridge_mm) in (kept.start..).zip(&between).filter(|(_, ridge_mm)| **ridge_mm > OVER * aim_mm) {
                // Each ridge grows about as the square of the step.
                let share = (aim_mm / ridge_mm).sqrt().max(LEAST_SHARE);
                shares[k..=k + 1].iter_mut().for_each(|s| *s = s.min(share));
            }
            let drawn = |k: usize| {
                let step_mm = steps_mm[k] * shares[k];
                let at = sheet.across(last[k].as_ref()?, sign * step_mm).ok()?;
                Some((k, Next { ridges_mm: sheet.ridges_mm(&curves, k, &at), at, step_mm }))
            };
            let drawn = parallel::filter_map(kept.clone().filter(|k| shares[*k] < 1.0), drawn);
            if drawn.is_empty() {
                break;
            }
            for (k, next) in drawn {
                (row[k], steps_mm[k], ridges_mm[k]) = (Some(next.at), next.step_mm, next.ridges_mm);
            }
        }
        for ridges_mm in &ridges_mm {
            out.greatest_mm = [0, 1].map(|j| out.greatest_mm[j].max(ridges_mm[j]));
        }
        // Both sides are laid at the same time: one of them decides how far it is.
        if sign > 0.0 {
            observer.progress(Stage::Path, row.iter().filter(|at| at.is_none()).count(), row.len());
        }
        out.rows.push(row.clone());
        last = row;
    }
    Err(no_pairs(format!("more than {MOST_ROWS} rows would be needed"), "allow a larger scallop"))
}

/// The place of the next row at a height: as far across as leaves the scallop on both sides.
fn next(
    sheet: &Sheet,
    (before, curves, k): (&[Option<Standing>], &RowCurves, usize),
    from: &Standing,
    (sign, guess_mm, flat_mm): (f64, f64, f64),
) -> OrEnd<Next> {
    let aim_mm = AIM * sheet.options.settings.scallop_mm;
    // Where rows lean, a step at one height goes farther than the rows are apart.
    let slant = along_row(before, k).map_or(1.0, |along| {
        let t = from.touches[0].tangent(&Along::BLADE);
        (1.0 - along.dot(&t).powi(2)).max(0.01).sqrt()
    });
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut step_mm = guess_mm.clamp(LEAST_STEP * flat_mm, 4.0 * flat_mm / slant);
    let mut best: Option<Next> = None;
    for _ in 0..TRIALS {
        // A shorter step may still have a partner; but the row beyond is the edge's.
        let at = sheet.across(from, sign * step_mm)?;
        let ridges_mm = sheet.ridges_mm(curves, k, &at);
        let ridge_mm = ridges_mm[0].max(ridges_mm[1]);
        if ridge_mm <= aim_mm * (1.0 + NEAR_ENOUGH) && step_mm >= low {
            best = Some(Next { at, step_mm, ridges_mm });
        }
        if (ridge_mm / aim_mm - 1.0).abs() <= NEAR_ENOUGH {
            break;
        }
        if ridge_mm < aim_mm {
            low = step_mm
        } else {
            high = step_mm
        }
        let by_square = step_mm * (aim_mm / ridge_mm.max(1e-3 * aim_mm)).sqrt();
        let wanted = if by_square.is_finite() && by_square > 0.0 { by_square } else { 0.5 * step_mm };
        step_mm = match high.is_finite() {
            true if wanted <= low || wanted >= high => 0.5 * (low + high),
            true => wanted,
            false => wanted.min(2.0 * step_mm),
        };
    }
    // Rows that would lie on top of each other: the ball has no room beside the last.
    best.filter(|n| n.step_mm > LEAST_STEP * flat_mm).ok_or(RowEnd::NoBall)
}
