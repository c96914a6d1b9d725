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

/// Rows whose lower wall is above an upper wall farther on, or whose upper one is below a lower one
/// before, in ascending order: no θ that never falls keeps to both.
pub(super) fn crossing_rows(rows: &[ChannelRow]) -> Vec<usize> {
    let mut low = f64::NEG_INFINITY;
    let mut crossing: Vec<bool> = rows
        .iter()
        .map(|row| {
            low = low.max(row.theta_min);
            row.theta_max < low
        })
        .collect();
    let mut high = f64::INFINITY;
    for (row, crosses) in rows.iter().zip(&mut crossing).rev() {
        high = high.min(row.theta_max);
        *crosses |= row.theta_min > high;
    }
    (0..rows.len()).filter(|k| crossing[*k]).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_whose_walls_cross_are_found() {
        let row = |[theta_min, theta_max]: [f64; 2]| ChannelRow {
            theta_min,
            theta_max,
            hull_min: theta_min,
            hull_max: theta_max,
            tangent_min: theta_min,
            tangent_max: theta_max,
            binds_min: Binding::Free,
            binds_max: Binding::Free,
        };
        let crossing = |walls: &[[f64; 2]]| crossing_rows(&walls.iter().map(|w| row(*w)).collect::<Vec<_>>());
        assert!(crossing(&[[0.0, 1.0], [0.5, 1.5], [1.0, 2.0]]).is_empty());
        // The upper wall of the last row is under the lower ones of the second and the third.
        assert_eq!(crossing(&[[0.0, 1.0], [0.5, 1.5], [0.7, 2.0], [0.1, 0.4]]), [1, 2, 3]);
        // Every row that takes part is found, whether hulls cross there or not.
        let walls = [[0.0, 9.0], [5.0, 9.0], [0.0, 9.0], [0.0, 4.0], [0.0, 9.0]];
        assert_eq!(crossing(&walls), [1, 3]);
        let rows: Vec<ChannelRow> = walls.iter().map(|w| row(*w)).collect();
        assert!(hulls(&mut rows.clone(), Sweep::default()).is_err());
    }
}
