//! Rows of the channel and their monotone hulls.

use crate::artifact::ToolPart;
use crate::artifact::channel::{Binding, ChannelRow, Sweep};

use super::arcs::Witness;
use super::forbidden::{Free, ObstacleScene};
use super::samples::Sample;

/// Where no monotone schedule exists: the row with the greatest lower limit and a later one whose
/// upper limit is less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Crossing {
    pub low_row: usize,
    pub high_row: usize,
}

/// What an end of an interval comes from, by name.
pub(super) fn binding(by: Witness, scene: &ObstacleScene) -> Binding {
    match by {
        Witness::Contact => Binding::ContactAngle,
        Witness::Axis => Binding::AxisLimit,
        Witness::Travel(k) => {
            let axis = scene.options.travel.get(usize::from(k)).map_or_else(String::new, |t| t.name.clone());
            Binding::Travel { axis }
        }
        Witness::Cut => Binding::Free,
        Witness::Cutter { body, triangle } => {
            let (Some(b), tool) = (scene.bodies.get(usize::from(body)), ToolPart::Cutter) else { return Binding::Free };
            match body {
                0 => Binding::Part { tool, face: b.mesh.face(triangle as usize), triangle },
                _ => Binding::Fixture { name: b.name.into(), tool, triangle },
            }
        }
        Witness::Tool { segment, body, leaf } => {
            let Some(b) = scene.bodies.get(usize::from(body)) else { return Binding::Free };
            let triangle = b.tree.triangle(leaf);
            let Some(&tool) = b.profile.parts.get(usize::from(segment)) else { return Binding::Free };
            if body == 0 {
                Binding::Part { tool, face: b.mesh.face(triangle as usize), triangle }
            } else {
                Binding::Fixture { name: b.name.into(), tool, triangle }
            }
        }
    }
}

/// One row per location; places between two locations narrow both rows, as far as the straight wall
/// between them would be outside there.
pub(super) fn rows(samples: &[Sample], walls: &[Free], scene: &ObstacleScene) -> Vec<ChannelRow> {
    let at_locations = samples.iter().zip(walls).filter(|(s, _)| s.fraction == 0.0);
    let mut rows: Vec<ChannelRow> = at_locations.map(|(_, f)| row_of(f, scene)).collect();
    for (s, f) in samples.iter().zip(walls).filter(|(s, _)| s.fraction > 0.0) {
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

fn row_of(f: &Free, scene: &ObstacleScene) -> ChannelRow {
    ChannelRow {
        theta_min: f.lo,
        theta_max: f.hi,
        hull_min: f.lo,
        hull_max: f.hi,
        tangent_min: f.lo,
        tangent_max: f.hi,
        binds_min: binding(f.lo_by, scene),
        binds_max: binding(f.hi_by, scene),
    }
}

/// Fills in the hulls: the walls themselves where θ swings. Returns the row where they are nearest
/// to one another.
///
/// # Errors
/// [`Crossing`] where they cross.
pub(super) fn hulls(rows: &mut [ChannelRow], sweep: Sweep) -> Result<usize, Crossing> {
    let from = |last: f64, least: f64| if sweep.is_round() { last } else { least };
    let mut low = f64::NEG_INFINITY;
    for row in rows.iter_mut() {
        low = from(low, f64::NEG_INFINITY).max(row.theta_min);
        row.hull_min = low;
    }
    let mut high = f64::INFINITY;
    for row in rows.iter_mut().rev() {
        high = from(high, f64::INFINITY).min(row.theta_max);
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
