//! Rows along a blade for two tools that hold it between them: opposite places, laid in lock step.
//!
//! **In**: a [`Blade`] with exact faces and [`PairOptions`]. **Out**: [`PairedRows`].
//!
//! ## Method
//! A place of the rows is a ball of tool 1 that touches the airfoil on its suction side, and a ball
//! of tool 2 where the greatest ball inside the part that touches at the first contact touches
//! again ([`opposite`]). Heights of tool 1's ball centre are the same for all rows, so rows and
//! heights are a grid. The *first row* (`first`) is the middle, at each height, of the part of the
//! suction side that has an opposite one, made smooth by a cubic over the height. Each *next row*
//! (`lay`) lies at each height as far across on the suction side as leaves at most the scallop on
//! both sides: ridges are measured on the part between the new balls and the nearest places of the
//! row before, not derived from curvature, so no error adds up from row to row. A row goes as far
//! as its places have partners; what is beyond is the edges', and is counted.
//!
//! *Double helix* (`threads`): instead of rows both tools go round the blade on two threads of one
//! helix.
//!
//! ## Guarantees
//! Every ball is within 1e-6 mm of its level set, both contacts are on the airfoil, the normals
//! lack at most [`PairOptions::max_angle_rad`] of being opposite, and the straight moves between
//! places stay within the chord tolerance of both level sets at their middles.
//!
//! ## Limits
//! Exact faces only: on a mesh the ball inside touches the facet beside its own first. Where
//! partners are missing amid a row it is parted, and its pieces are rows of their own.
//!
//! [`opposite`]: crate::geometry::opposite

mod edges;
mod fill;
mod first;
mod lay;
mod sheet;
#[cfg(test)]
mod tests;
mod threads;

use super::PathSettings;
use crate::artifact::paired::{PairPlace, RowEnd};
use crate::artifact::{Blade, PairedRows};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::observe::Observer;
use crate::parallel;
use crate::tool::stepover::flat_stepover_mm;
use sheet::{Sheet, Standing};
pub use threads::{Threaded, Threads};

/// Greatest distance between two heights of the grid that rows are laid on, mm …
const GRID_MM: f64 = 2.0;
/// … and as a share of the smaller ball's radius.
const GRID_SHARE: f64 = 0.25;
/// Heights of that grid at least.
const LEAST_HEIGHTS: usize = 24;
/// ... and at most.
const MOST_HEIGHTS: usize = 20_000;
/// More rows than this is a mistake in the options.
const MOST_ROWS: usize = 20_000;

/// Which rows, for which tools.
#[derive(Clone, Debug, PartialEq)]
pub struct PairOptions {
    /// Scallop, chords, steps and stock; how turns lie is not looked at.
    pub settings: PathSettings,
    /// Ball radii of tool 1 and tool 2, mm.
    pub radius_mm: [f64; 2],
    /// Heights of tool 1's ball centre between which rows run, mm; `None`: those of the airfoil.
    pub heights_mm: Option<[f64; 2]>,
    /// What the normals of a pair may lack of being opposite, rad.
    pub max_angle_rad: f64,
    /// Room that the tools keep from each other, mm.
    pub apart_mm: f64,
    /// Whether rows go round the edges too, one tool round each.
    pub edges: bool,
}

/// Lays rows for two tools.
///
/// # Errors
/// Kind `Usage` for options out of their limits; kind `Infeasible` where the part has no exact
/// faces, no inside, no known edges or no opposite sides; kind `Cancelled`.
pub fn plan(blade: &Blade, options: &PairOptions, observer: &dyn Observer) -> Result<PairedRows> {
    let [low, high] = heights(blade, options)?;
    let sheet = Sheet::of(blade, options)?;
    let grid_mm = GRID_MM.min(GRID_SHARE * options.radius_mm[0].min(options.radius_mm[1]));
    let count = (((high - low) / grid_mm).ceil() as usize).clamp(LEAST_HEIGHTS, MOST_HEIGHTS);
    // From the top down, as rows are run.
    let heights_mm: Vec<f64> = (0..=count).map(|k| high + (low - high) * k as f64 / count as f64).collect();
    let first = first::row(&sheet, &heights_mm, observer)?;
    let flat_mm = flat_stepover_mm(options.radius_mm[0].min(options.radius_mm[1]), options.settings.scallop_mm);
    let lay = |sign| lay::side_of(&sheet, &first, (sign, flat_mm), observer);
    let (one, other) = parallel::both(|| lay(-1.0), || lay(1.0));
    let (one, other) = (one?, other?);
    let mut ends = one.ends;
    other.ends.into_iter().for_each(|(end, n)| *ends.entry(end).or_default() += n);
    let mut ends: Vec<(RowEnd, usize)> = ends.into_iter().collect();
    ends.sort_by_key(|(end, n)| (usize::MAX - n, *end));
    let at_first = one.rows.len();
    let laid: Vec<Vec<Option<Standing>>> =
        one.rows.into_iter().rev().chain(std::iter::once(first)).chain(other.rows).collect();

    let filled = fill::all(&sheet, &laid, observer)?;
    let edges = if options.edges { edges::rows(&sheet, (&filled, at_first), &heights_mm, observer)? } else { None };
    let mut places: Vec<PairPlace> = Vec::new();
    let mut rows = Vec::with_capacity(filled.len());
    let mut add = |row: &Vec<Standing>| {
        let from = places.len();
        places.extend(row.iter().map(Standing::place));
        rows.push(from..places.len());
    };
    filled.iter().flatten().for_each(&mut add);
    edges.iter().flat_map(|e| &e.rows).for_each(add);
    let greatest_mm = [one.greatest_mm, other.greatest_mm, edges.as_ref().map_or([0.0; 2], |e| e.greatest_mm)];
    let planned_scallop_mm = [0, 1].map(|j| greatest_mm.iter().map(|g| g[j]).fold(0.0, f64::max));
    Ok(PairedRows {
        radius_mm: options.radius_mm,
        stock_mm: options.settings.stock_mm,
        scallop_mm: options.settings.scallop_mm,
        chord_mm: options.settings.chord_mm,
        heights_mm: [low, high],
        planned_scallop_mm,
        edge_rows: edges.as_ref().map_or(0, |e| e.rows.len()),
        edge_heights_mm: edges.map(|e| e.heights_mm),
        rows,
        turns: None,
        places,
        ends,
    })
}

/// The heights asked for, or the airfoil's; all options checked.
fn heights(blade: &Blade, options: &PairOptions) -> Result<[f64; 2]> {
    let bad = |m: String| Err(Error::usage(Stage::Path, m));
    options.settings.check(Stage::Path)?;
    for (k, r) in options.radius_mm.iter().enumerate() {
        if !(*r > 0.0 && r.is_finite() && options.settings.scallop_mm < 0.5 * r) {
            return bad(format!(
                "the ball radius of tool {} is {r} mm, it must be over twice the scallop, {} mm",
                k + 1,
                options.settings.scallop_mm
            ));
        }
    }
    if !(options.max_angle_rad > 0.0 && options.max_angle_rad < std::f64::consts::FRAC_PI_2) {
        let deg = options.max_angle_rad.to_degrees();
        return bad(format!("pinch.max_angle_deg is {deg}, it must be over 0 and under 90"));
    }
    let [foot, top] = blade.regions.airfoil_x_mm();
    let [low, high] = options.heights_mm.unwrap_or([foot, top]);
    if !(low < high && low >= foot - 1e-6 && high <= top + 1e-6) {
        let m = format!(
            "rows are to run between heights {low:?} and {high:?} mm; the airfoil lies between {foot:.3} and {top:.3} mm"
        );
        return Err(Error::usage(Stage::Path, m).advise("give pinch.heights_mm within the airfoil, the lower first"));
    }
    Ok([low, high])
}

/// A part that cannot be held between two tools.
fn no_pairs(message: String, advice: &str) -> Error {
    Error::infeasible(Stage::Path, message, Infeasible::NoPairs).advise(advice)
}
