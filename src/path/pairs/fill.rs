//! Places between the heights of the grid, as many as the chord tolerance asks for.

use super::super::chords::tolerance_mm;
use super::super::curve::{LevelCurve, tangents};
use super::super::level::Touch;
use super::super::options::PathOptions;
use super::sheet::{Sheet, Standing};
use crate::error::{Result, Stage};
use crate::geometry::triangle::closest_on_segment;
use crate::numerics::runs::longest;
use crate::observe::Observer;
use crate::parallel;

/// Halvings of a stretch between two heights.
const MOST_HALVINGS: u32 = 12;
/// On one sheet the second ball goes at most so many times as far as the first …
const JUMP: f64 = 5.0;
/// … if that goes so far, mm.
const SHORTEST_MM: f64 = 1e-4;

/// All rows with the places between their heights, each in pieces of two places at least: a row is
/// parted where places between two heights have no partner.
///
/// # Errors
/// Kind `Cancelled`.
pub(super) fn all(
    sheet: &Sheet,
    rows: &[Vec<Option<Standing>>],
    observer: &dyn Observer,
) -> Result<Vec<Vec<Vec<Standing>>>> {
    let one = |row: &Vec<Option<Standing>>| {
        observer.check(Stage::Path)?;
        let kept = longest(&row.iter().map(Option::is_some).collect::<Vec<_>>());
        Ok(filled(sheet, &row[kept].iter().flatten().copied().collect::<Vec<_>>()))
    };
    parallel::try_map(rows, one)
}

/// Whether the second ball goes on from place to place: where the sheet branches, the opposite
/// place jumps, and with it that ball.
fn is_one_way(a: &Standing, b: &Standing) -> bool {
    let way = |j: usize| (b.touches[j].centre - a.touches[j].centre).norm();
    way(1) <= JUMP * way(0).max(SHORTEST_MM)
}

/// A row through its places.
struct Filling<'a, F> {
    sheet: &'a Sheet<'a>,
    /// Both balls at a share of the way from a height to the next, beside a place.
    at: F,
    options: PathOptions,
}

/// The curve of a tool's ball through its places.
fn curve<'a>(sheet: &'a Sheet, touches: &'a [Touch], tool: usize) -> LevelCurve<'a> {
    LevelCurve { level: &sheet.levels[tool], touches, tangents: tangents(None, touches, None) }
}

/// A row on the curve of tool 1 through its places, tool 2 opposite.
fn filled(sheet: &Sheet, row: &[Standing]) -> Vec<Vec<Standing>> {
    let touches: Vec<Touch> = row.iter().map(|s| s.touches[0]).collect();
    let curve = curve(sheet, &touches, 0);
    let at = |k: usize, share: f64, a: &Standing| curve.between(k, share).and_then(|t| sheet.beside(a, t).ok());
    filled_by(sheet, row, at)
}

/// A row round both edges, each tool on a curve of its own.
pub(super) fn round_edges(sheet: &Sheet, row: &[Option<Standing>]) -> Vec<Vec<Standing>> {
    let row: Vec<Standing> = row.iter().flatten().copied().collect();
    let touches = [0, 1].map(|j| row.iter().map(|s| s.touches[j]).collect::<Vec<Touch>>());
    let curves = [0, 1].map(|j| curve(sheet, &touches[j], j));
    let stock_mm = sheet.options.settings.stock_mm;
    let at = |k: usize, share: f64, _: &Standing| {
        Some(Standing::round_edges([curves[0].between(k, share)?, curves[1].between(k, share)?], stock_mm))
    };
    filled_by(sheet, &row, at)
}

fn filled_by(
    sheet: &Sheet,
    row: &[Standing],
    at: impl Fn(usize, f64, &Standing) -> Option<Standing>,
) -> Vec<Vec<Standing>> {
    if row.len() < 2 {
        return Vec::new();
    }
    let usual = PathOptions::new(sheet.levels[0].radius_mm, sheet.options.settings.scallop_mm);
    let options = PathOptions { settings: sheet.options.settings.clone(), ..usual };
    let filling = Filling { sheet, at, options };
    let (mut pieces, mut out) = (Vec::new(), vec![row[0]]);
    for (k, w) in row.windows(2).enumerate() {
        // Where it fails, what was added up to there stays.
        if filling.between(k, [0.0, 1.0], [&w[0], &w[1]], 0, &mut out).is_none() {
            pieces.push(std::mem::take(&mut out));
        }
        out.push(w[1]);
    }
    pieces.push(out);
    pieces.retain(|piece| piece.len() > 1);
    pieces
}

impl<F: Fn(usize, f64, &Standing) -> Option<Standing>> Filling<'_, F> {
    /// Adds places strictly between two shares of the way from a height to the next; `None`: a
    /// place between them has no partner, and those before it are added.
    fn between(
        &self,
        k: usize,
        [from, to]: [f64; 2],
        [a, b]: [&Standing; 2],
        depth: u32,
        out: &mut Vec<Standing>,
    ) -> Option<()> {
        if depth >= MOST_HALVINGS {
            return is_one_way(a, b).then_some(());
        }
        let mid = 0.5 * (from + to);
        let at = (self.at)(k, mid, a)?;
        let splits = (0..2).any(|j| {
            let (l, r) = (&a.touches[j], &b.touches[j]);
            let off = (at.touches[j].centre - closest_on_segment(&l.centre, &r.centre, &at.touches[j].centre)).norm();
            let long = (r.centre - l.centre).norm() > self.options.settings.max_step_mm;
            long || off > tolerance_mm(&self.sheet.levels[j], l, r, &self.options)
        });
        if splits {
            self.between(k, [from, mid], [a, &at], depth + 1, out)?;
            out.push(at);
            return self.between(k, [mid, to], [&at, b], depth + 1, out);
        }
        // The middle may lie on a chord over a jump, at one of its ends.
        is_one_way(a, b).then_some(())
    }
}
