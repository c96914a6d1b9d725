//! Rows of the channel and their monotone hulls.

use crate::artifact::channel::{Binding, ChannelRow};

use super::arcs::Witness;
use super::forbidden::{Free, Scene};
use super::samples::Sample;

/// Where no monotone schedule exists: the row with the greatest lower limit and a later one whose upper limit is less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Crossing {
    pub low_row: usize,
    pub high_row: usize,
}

/// What an end of an interval comes from, by name.
pub(super) fn binding(by: Witness, scene: &Scene) -> Binding {
    match by {
        Witness::Contact => Binding::ContactAngle,
        Witness::Cut => Binding::Free,
        Witness::Tool { segment, leaf } => {
            let triangle = scene.tree.triangle(leaf);
            Binding::Part {
                tool: scene.profile.names.get(usize::from(segment)).cloned().unwrap_or_default(),
                face: scene.mesh.face(triangle as usize),
                triangle,
            }
        }
    }
}

/// One row per location; straight walls between the places, over the arc lengths `s_mm` of the locations. Places between
/// two locations narrow both rows, as far as the straight wall between them would be outside there.
pub(super) fn rows(samples: &[Sample], chosen: &[&Free], s_mm: &[f64], scene: &Scene) -> Vec<ChannelRow> {
    let mut rows: Vec<ChannelRow> = Vec::with_capacity(s_mm.len());
    let mut last: Option<(usize, &Free)> = None;
    for (sample, f) in samples.iter().zip(chosen).filter(|(s, _)| s.fraction == 0.0) {
        if let Some((from, g)) = last {
            for row in from + 1..sample.row {
                let share = (s_mm[row] - s_mm[from]) / (s_mm[sample.row] - s_mm[from]).max(f64::MIN_POSITIVE);
                let nearer = if share < 0.5 { g } else { f };
                let at = |x: f64, y: f64| x + share * (y - x);
                rows.push(row_of(at(g.lo, f.lo), at(g.hi, f.hi), nearer, scene));
            }
        }
        rows.push(row_of(f.lo, f.hi, f, scene));
        last = Some((sample.row, f));
    }
    for (s, f) in samples.iter().zip(chosen).filter(|(s, _)| s.fraction > 0.0) {
        let Some([a, b]) = rows.get_mut(s.row..s.row + 2) else { continue };
        let at = |x: f64, y: f64| x + s.fraction * (y - x);
        let rise = f.lo - at(a.theta_min, b.theta_min);
        let fall = at(a.theta_max, b.theta_max) - f.hi;
        for row in [a, b] {
            if rise > 0.0 {
                row.theta_min += rise;
                row.binds_min = binding(f.lo_by, scene);
            }
            if fall > 0.0 {
                row.theta_max -= fall;
                row.binds_max = binding(f.hi_by, scene);
            }
        }
    }
    rows
}

fn row_of(theta_min: f64, theta_max: f64, by: &Free, scene: &Scene) -> ChannelRow {
    ChannelRow {
        theta_min,
        theta_max,
        hull_min: theta_min,
        hull_max: theta_max,
        tangent_min: theta_min,
        tangent_max: theta_max,
        binds_min: binding(by.lo_by, scene),
        binds_max: binding(by.hi_by, scene),
    }
}

/// Fills in the hulls; returns the row where they are nearest to one another.
///
/// # Errors
/// [`Crossing`] where they cross.
pub(super) fn hulls(rows: &mut [ChannelRow]) -> Result<usize, Crossing> {
    let mut low = f64::NEG_INFINITY;
    for row in rows.iter_mut() {
        low = low.max(row.theta_min);
        row.hull_min = low;
    }
    let mut high = f64::INFINITY;
    for row in rows.iter_mut().rev() {
        high = high.min(row.theta_max);
        row.hull_max = high;
    }
    let (mut narrowest, mut width) = (0, f64::INFINITY);
    for (i, row) in rows.iter().enumerate() {
        let w = row.hull_max - row.hull_min;
        if w < width {
            (narrowest, width) = (i, w);
        }
    }
    if width >= 0.0 {
        return Ok(narrowest);
    }
    let low_row = (0..=narrowest).rev().find(|&i| rows[i].theta_min >= rows[narrowest].hull_min).unwrap_or(narrowest);
    let high_row =
        (narrowest..rows.len()).find(|&i| rows[i].theta_max <= rows[narrowest].hull_max).unwrap_or(narrowest);
    Err(Crossing { low_row, high_row })
}
