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
/// between them would be outside there. Where nothing is left between walls that are moved in alike
/// at both rows, they are turned.
pub(super) fn rows(samples: &[Sample], walls: &[Free], scene: &ObstacleScene) -> Vec<ChannelRow> {
    let of_locations = || -> Vec<ChannelRow> {
        samples.iter().zip(walls).filter(|(s, _)| s.fraction == 0.0).map(|(_, f)| row_of(f, scene)).collect()
    };
    let mut rows = of_locations();
    narrow(&mut rows, (samples, walls), scene);
    let cross = |row: &ChannelRow| row.theta_min > row.theta_max;
    if !rows.iter().any(cross) {
        return rows;
    }
    let moved_in = std::mem::replace(&mut rows, of_locations());
    let mut from = 0;
    for places in samples.chunk_by(|a, b| a.row == b.row) {
        let walls = &walls[from..from + places.len()];
        from += places.len();
        let (row, last) = (places[0].row, moved_in.len() - 1);
        match moved_in[row..=(row + 1).min(last)].iter().any(cross) {
            true => turn(&mut rows, (places, walls), scene),
            false => narrow(&mut rows, (places, walls), scene),
        }
    }
    rows
}

/// As [`narrow`] for the places of one move, by [`turned`].
fn turn(rows: &mut [ChannelRow], (places, walls): (&[Sample], &[Free]), scene: &ObstacleScene) {
    let between: Vec<(f64, &Free)> =
        places.iter().map(|p| p.fraction).zip(walls).filter(|(share, _)| *share > 0.0).collect();
    let Some(first) = places.first().map(|p| p.row).filter(|_| !between.is_empty()) else { return };
    let Some([a, b]) = rows.get_mut(first..first + 2) else { return };
    let inside: Vec<(f64, [f64; 2])> = between.iter().map(|(share, f)| (*share, [f.lo, f.hi])).collect();
    let moved = turned(&inside, [[a.theta_min, a.theta_max], [b.theta_min, b.theta_max]]);
    let farthest = |by: &dyn Fn(&Free) -> f64| between.iter().map(|(_, f)| *f).max_by(|p, q| by(p).total_cmp(&by(q)));
    let by = [farthest(&|f| f.lo).map(|f| f.lo_by), farthest(&|f| -f.hi).map(|f| f.hi_by)];
    let [lo_by, hi_by] = by.map(|by| by.map_or(Binding::Free, |by| binding(by, scene)));
    for (row, [lo, hi]) in [a, b].into_iter().zip(moved) {
        if lo > row.theta_min {
            (row.theta_min, row.binds_min) = (lo, lo_by.clone());
        }
        if hi < row.theta_max {
            (row.theta_max, row.binds_max) = (hi, hi_by.clone());
        }
    }
}

/// The walls (lower, upper) at both ends of a move, moved in until they are straight within the
/// walls at shares of the way. A wall is moved in alike at both ends, at either alone, or to one
/// angle at both; taken is what leaves most room at the narrower end.
fn turned(between: &[(f64, [f64; 2])], [a, b]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    // With a sense of -1 the upper wall is a lower one.
    let ways = |side: usize, sense: f64| -> [[f64; 2]; 4] {
        let (at_a, at_b) = (sense * a[side], sense * b[side]);
        let (mut both, mut one, mut level) = (0.0f64, [0.0f64; 2], at_a.max(at_b));
        for (share, walls) in between {
            let wall = sense * walls[side];
            let short = wall - (at_a + share * (at_b - at_a));
            both = both.max(short);
            one = [one[0].max(short / (1.0 - share)), one[1].max(short / share)];
            level = level.max(wall);
        }
        let all = [[at_a + both, at_b + both], [at_a + one[0], at_b], [at_a, at_b + one[1]], [level; 2]];
        all.map(|wall| wall.map(|v| sense * v))
    };
    let (mut best, mut most) = ([a, b], f64::NEG_INFINITY);
    for lo in ways(0, 1.0) {
        for hi in ways(1, -1.0) {
            let room = (hi[0] - lo[0]).min(hi[1] - lo[1]);
            if room > most {
                (best, most) = ([[lo[0], hi[0]], [lo[1], hi[1]]], room);
            }
        }
    }
    best
}

/// Narrows rows to the walls at places on their moves, as far as their straight walls are outside
/// there.
pub(super) fn narrow(rows: &mut [ChannelRow], (samples, walls): (&[Sample], &[Free]), scene: &ObstacleScene) {
    // Locations first: a place between two is then measured on walls that hold at both.
    for between in [false, true] {
        for (s, f) in samples.iter().zip(walls).filter(|(s, _)| (s.fraction > 0.0) == between) {
            let last = if between { s.row + 1 } else { s.row };
            let Some(beside) = rows.get_mut(s.row..=last) else { continue };
            let [lo, hi] = straight(beside, s.fraction);
            let (rise, fall) = (f.lo - lo, hi - f.hi);
            for row in beside {
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
    }
}

/// The straight walls at a share of the way from the first of some rows to the last, rad.
fn straight(rows: &[ChannelRow], share: f64) -> [f64; 2] {
    let (Some(a), Some(b)) = (rows.first(), rows.last()) else { return [f64::NEG_INFINITY, f64::INFINITY] };
    let at = |x: f64, y: f64| x + share * (y - x);
    [at(a.theta_min, b.theta_min), at(a.theta_max, b.theta_max)]
}

/// What is free at a place of a channel: the interval that has most in common with its walls there.
pub(super) fn within(rows: &[ChannelRow], place: &Sample, layer: &[Free]) -> Option<Free> {
    let last = if place.fraction > 0.0 { place.row + 1 } else { place.row };
    let [lo, hi] = straight(rows.get(place.row..=last)?, place.fraction);
    let common = |f: &Free| f.hi.min(hi) - f.lo.max(lo);
    layer.iter().max_by(|a, b| common(a).total_cmp(&common(b))).filter(|f| common(f) >= 0.0).copied()
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
    use proptest::prelude::*;

    proptest! {
        /// Moved walls lie inside those that there were, and are straight inside all that is asked
        /// for between; no less room is left than by walls that stand at one angle.
        #[test]
        fn turned_walls_are_inside_all_of_them(
            ends in prop::array::uniform2((-2.0..0.5f64, 0.5..3.0f64)),
            between in prop::collection::vec((0.01..0.99f64, -2.0..1.0f64, 1.0..3.0f64), 1..5),
        ) {
            let ends = ends.map(|(lo, hi)| [lo, hi]);
            let between: Vec<(f64, [f64; 2])> = between.into_iter().map(|(share, lo, hi)| (share, [lo, hi])).collect();
            let [a, b] = turned(&between, ends);
            for (end, was) in [a, b].iter().zip(&ends) {
                prop_assert!(end[0] >= was[0] - 1e-12 && end[1] <= was[1] + 1e-12);
            }
            for (share, walls) in &between {
                let at = |side: usize| a[side] + share * (b[side] - a[side]);
                prop_assert!(at(0) >= walls[0] - 1e-9 && at(1) <= walls[1] + 1e-9);
            }
            let all = || between.iter().map(|(_, walls)| *walls).chain(ends);
            let level = all().map(|w| w[1]).fold(f64::INFINITY, f64::min) - all().map(|w| w[0]).fold(f64::NEG_INFINITY, f64::max);
            prop_assert!((a[1] - a[0]).min(b[1] - b[0]) >= level - 1e-12);
        }
    }

    /// Two wide intervals that have little in common, and a narrow one between: walls moved in
    /// alike at both ends would cross.
    #[test]
    fn walls_turn_where_wide_intervals_meet_at_a_narrow_place() {
        let ends = turned(&[(0.5, [11.0, 11.75])], [[-60.0, 12.0], [10.0, 87.0]]);
        assert_eq!(ends, [[11.0, 11.75]; 2]);
    }

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
