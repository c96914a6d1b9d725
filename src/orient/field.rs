//! The smooth way through the free tool axes: a search in layers.
//!
//! A layer is a station of the path, a node a direction of a grid of latitudes and longitudes about
//! the rotor axis that is free there. Edges join directions of neighbouring stations that are a few
//! cells apart. The cost of a way is `∫ |a'|² ds + w ∫ p ds`: how fast the axis turns, and how near
//! it comes to what is taken (`p` falls from 1 beside it to 0 in [`DEEP`] cells). Dynamic
//! programming finds the least of all ways.

use std::f64::consts::PI;

use crate::artifact::Cone;
use crate::geometry::Vector;

/// Cells that an axis may turn by from station to station, in latitude and in longitude.
const REACH: usize = 3;
/// Cells from what is taken at which nothing is nearer.
const DEEP: u8 = 4;
/// What a millimetre beside what is taken costs, against the square of the turn over the length,
/// rad²/mm: a turn of 18° a millimetre. Room goes before evenness, which the curves bring that are
/// laid in that room afterwards.
const NEAR: f64 = 0.1;

/// What a cell costs that the axis passes between two stations while it is free at neither. A way
/// over such cells may lead through a wall, and is the last resort: a gap narrower than the cells
/// has none that are free.
const BLIND: f64 = 1000.0;
/// What it costs to leave the blade and come back with another axis: ways without come first, as
/// far as they are not blind.
const LINK: f64 = 100.0;
/// In place of the cell before: the axis comes from another cell of the same station, by a link.
const BY_LINK: u8 = u8::MAX - 1;

/// The one or two cells nearest to a point that an axis passes, counted from the cell [`REACH`]
/// before the one that it comes to, in latitude and in longitude.
type Passed = [[usize; 2]; 2];

/// What is passed from the cell at so many latitudes and longitudes, counted likewise.
fn passed(dr: usize, dc: usize) -> Vec<Passed> {
    let steps = dr.abs_diff(REACH).max(dc.abs_diff(REACH));
    let at = |from: usize, k: usize| {
        let way = from * (steps - k) + REACH * k;
        [way / steps, way.div_ceil(steps)]
    };
    let point = |k: usize| {
        let ([r0, r1], [c0, c1]) = (at(dr, k), at(dc, k));
        [[r0, c0], [r1, c1]]
    };
    (1..steps).map(point).collect()
}

/// Directions about the rotor axis: latitudes, and longitudes from the radial direction.
#[derive(Clone, Debug)]
pub struct DirectionGrid {
    /// Rotor axis, unit, blade frame.
    pub axis: Vector,
    /// Radial direction, unit, square to it: longitude 0.
    pub radial: Vector,
    /// Latitudes, rad, rising, evenly spaced.
    pub latitudes: Vec<f64>,
    /// Longitudes, rad, rising, evenly spaced.
    pub longitudes: Vec<f64>,
}

impl DirectionGrid {
    /// Directions a step apart, up to a greatest latitude and longitude either side, rad; `None`
    /// where the radial direction is along the axis.
    pub fn new(axis: Vector, radial: Vector, step_rad: f64, most_rad: [f64; 2]) -> Option<Self> {
        let cone = Cone::new(axis, radial, 0.0)?;
        let even = |most: f64| {
            let count = (most / step_rad).floor().clamp(1.0, 200.0) as i32;
            (-count..=count).map(|k| f64::from(k) * step_rad).collect()
        };
        let [latitudes, longitudes] = most_rad.map(even);
        Some(DirectionGrid { axis: cone.axis, radial: cone.reference, latitudes, longitudes })
    }

    /// The cone of a latitude.
    pub fn parallel(&self, latitude_rad: f64) -> Cone {
        Cone { axis: self.axis, reference: self.radial, lean_rad: latitude_rad }
    }

    /// The great circle of a longitude as a cone: its angle is the latitude.
    pub fn meridian(&self, longitude_rad: f64) -> Cone {
        let out = self.parallel(0.0).tool_axis(longitude_rad);
        Cone { axis: out.cross(&self.axis), reference: out, lean_rad: 0.0 }
    }

    /// From one longitude to the next, rad.
    pub fn step_rad(&self) -> f64 {
        self.longitudes.windows(2).next().map_or(0.0, |w| w[1] - w[0])
    }

    fn cells(&self) -> usize {
        self.latitudes.len() * self.longitudes.len()
    }

    /// The cell nearest to a longitude and latitude, rad, in the order of [`FreeCells`].
    pub fn cell_of(&self, [longitude, latitude]: &[f64; 2]) -> usize {
        let nearest = |of: &[f64], at: f64| {
            let step = of.windows(2).next().map_or(1.0, |w| w[1] - w[0]);
            let first = of.first().copied().unwrap_or(at);
            (((at - first) / step).round().max(0.0) as usize).min(of.len().saturating_sub(1))
        };
        self.cell(nearest(&self.latitudes, *latitude), nearest(&self.longitudes, *longitude))
    }

    fn cell(&self, row: usize, column: usize) -> usize {
        row * self.longitudes.len() + column
    }
}

/// What is free at a station: one flag for each direction of the grid, latitude by latitude.
pub type FreeCells = Vec<bool>;

/// Share of a free interval that is kept either side where it is narrow.
pub const NARROW: f64 = 0.3;

/// Which directions of the grid stand for the free intervals of its latitudes, longitudes in rad:
/// those inside by `margin_rad`, or by a share of the width; where none is, the nearest to the
/// middle.
pub fn free_cells(grid: &DirectionGrid, intervals: &[Vec<[f64; 2]>], margin_rad: f64) -> FreeCells {
    let mut out = vec![false; grid.cells()];
    for (row, free) in intervals.iter().enumerate().take(grid.latitudes.len()) {
        for [lo, hi] in free {
            let margin = margin_rad.min(NARROW * (hi - lo));
            let mut any = false;
            for (column, _) in grid.longitudes.iter().enumerate().filter(|(_, at)| holds(&[*lo, *hi], **at, margin)) {
                (out[grid.cell(row, column)], any) = (true, true);
            }
            let middle = 0.5 * (lo + hi);
            let off = |column: &usize| (grid.longitudes[*column] - middle).abs();
            let nearest = (0..grid.longitudes.len()).min_by(|a, b| off(a).total_cmp(&off(b)));
            if let Some(column) = nearest.filter(|k| !any && off(k) <= margin_rad.max(0.5 * grid.step_rad())) {
                out[grid.cell(row, column)] = true;
            }
        }
    }
    out
}

/// As [`free_cells`], but only those that are inside by all of `margin_rad`.
pub fn wide_cells(grid: &DirectionGrid, intervals: &[Vec<[f64; 2]>], margin_rad: f64) -> FreeCells {
    let mut out = vec![false; grid.cells()];
    for (row, free) in intervals.iter().enumerate().take(grid.latitudes.len()) {
        for (column, at) in grid.longitudes.iter().enumerate() {
            out[grid.cell(row, column)] |= free.iter().any(|f| holds(f, *at, margin_rad));
        }
    }
    out
}

/// Whether an interval of angles, rad, holds one with a margin either side. A free circle is an
/// interval with whole turns in it.
pub fn holds([lo, hi]: &[f64; 2], at_rad: f64, margin_rad: f64) -> bool {
    [0.0, 2.0 * PI, -2.0 * PI].iter().any(|t| at_rad + t - lo >= margin_rad && hi - at_rad - t >= margin_rad)
}

/// A way over the grid: longitude and latitude, rad, with which each station is reached, and with
/// which it is left. They differ where a link leads from the ones to the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// With which the station is reached.
    pub arrives: Vec<[f64; 2]>,
    /// With which it is left.
    pub leaves: Vec<[f64; 2]>,
}

/// The way that costs least; `s_mm` is where the stations are, rising. With `links` the tool may
/// leave the blade at a station and come back to it with any axis that is free there.
///
/// # Errors
/// The first station to which no way leads.
pub fn least_way(grid: &DirectionGrid, s_mm: &[f64], free: &[impl AsRef<[bool]>], links: bool) -> Result<Way, usize> {
    let (rows, columns) = (grid.latitudes.len(), grid.longitudes.len());
    let step = |v: &[f64]| if v.len() > 1 { v[1] - v[0] } else { 0.0 };
    let [up, along] = [step(&grid.latitudes), step(&grid.longitudes)];
    let ways = (2 * REACH + 1) * (2 * REACH + 1);
    let passed: Vec<Vec<Passed>> = (0..ways).map(|way| passed(way / (2 * REACH + 1), way % (2 * REACH + 1))).collect();
    let mut cost: Vec<f64> = Vec::new();
    let mut back: Vec<(Vec<u8>, usize)> = Vec::with_capacity(free.len());
    for (station, cells) in free.iter().map(AsRef::as_ref).enumerate() {
        let near = nearness(grid, cells);
        let last_s = station.checked_sub(1).and_then(|k| s_mm.get(k)).copied();
        let ds = last_s.map_or(0.0, |s| (s_mm[station] - s).max(1e-6));
        let mut next = vec![f64::INFINITY; grid.cells()];
        let mut from = vec![u8::MAX; grid.cells()];
        for row in 0..rows {
            let narrow = grid.latitudes[row].cos();
            for column in 0..columns {
                let here = grid.cell(row, column);
                if !cells[here] {
                    continue;
                }
                let own = NEAR * near[here] * ds.max(1e-6);
                if station == 0 {
                    next[here] = NEAR * near[here];
                    continue;
                }
                for way in 0..ways {
                    let (dr, dc) = (way / (2 * REACH + 1), way % (2 * REACH + 1));
                    let (r, c) = ((row + dr).wrapping_sub(REACH), (column + dc).wrapping_sub(REACH));
                    if r >= rows || c >= columns {
                        continue;
                    }
                    let before = cost[grid.cell(r, c)];
                    if !before.is_finite() {
                        continue;
                    }
                    let turn = [(dr as f64 - REACH as f64) * up, (dc as f64 - REACH as f64) * along * narrow];
                    let sum = before + (turn[0] * turn[0] + turn[1] * turn[1]) / ds + own;
                    if sum >= next[here] {
                        continue;
                    }
                    let was = free[station - 1].as_ref();
                    let is_free = |[r, c]: [usize; 2]| {
                        let cell = grid.cell(row + r - REACH, column + c - REACH);
                        cells[cell] || was[cell]
                    };
                    let blind = passed[way].iter().filter(|p| !p.iter().any(|at| is_free(*at))).count();
                    let sum = sum + BLIND * blind as f64;
                    if sum < next[here] {
                        (next[here], from[here]) = (sum, way as u8);
                    }
                }
            }
        }
        let cheapest = (0..next.len()).min_by(|a, b| next[*a].total_cmp(&next[*b])).unwrap_or(0);
        let least = next.get(cheapest).copied().unwrap_or(f64::INFINITY);
        if !least.is_finite() {
            return Err(station);
        }
        if links && station > 0 {
            for here in (0..next.len()).filter(|cell| cells[*cell]) {
                let sum = least + LINK + NEAR * near[here] * ds;
                if sum < next[here] {
                    (next[here], from[here]) = (sum, BY_LINK);
                }
            }
        }
        cost = next;
        back.push((from, cheapest));
    }
    let axis = |cell: usize| [grid.longitudes[cell % columns], grid.latitudes[cell / columns]];
    let mut at = (0..cost.len()).min_by(|a, b| cost[*a].total_cmp(&cost[*b])).unwrap_or(0);
    let (mut arrives, mut leaves) = (Vec::with_capacity(free.len()), Vec::with_capacity(free.len()));
    for (from, cheapest) in back.iter().rev() {
        leaves.push(axis(at));
        if from[at] == BY_LINK {
            at = *cheapest;
        }
        arrives.push(axis(at));
        let (row, column) = (at / columns, at % columns);
        let way = usize::from(from[at]);
        if way < ways {
            let (dr, dc) = (way / (2 * REACH + 1), way % (2 * REACH + 1));
            at = grid.cell(row + dr - REACH, column + dc - REACH);
        }
    }
    arrives.reverse();
    leaves.reverse();
    Ok(Way { arrives, leaves })
}

/// How near each cell is to one that is taken: 1 beside it, 0 from [`DEEP`] cells on.
fn nearness(grid: &DirectionGrid, free: &[bool]) -> Vec<f64> {
    let (rows, columns) = (grid.latitudes.len(), grid.longitudes.len());
    let mut depth: Vec<u8> = free.iter().map(|f| if *f { DEEP } else { 0 }).collect();
    for level in 1..DEEP {
        for row in 0..rows {
            for column in 0..columns {
                let here = grid.cell(row, column);
                if depth[here] != DEEP {
                    continue;
                }
                let beside = [(0, 1), (2, 1), (1, 0), (1, 2)].into_iter().any(|(dr, dc): (usize, usize)| {
                    let (r, c) = ((row + dr).wrapping_sub(1), (column + dc).wrapping_sub(1));
                    r < rows && c < columns && depth[grid.cell(r, c)] == level - 1
                });
                if beside {
                    depth[here] = level;
                }
            }
        }
    }
    let share = |d: u8| f64::from(DEEP - d) / f64::from(DEEP - 1);
    depth.into_iter().map(|d| share(d).min(1.0).powi(2)).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn grid() -> DirectionGrid {
        DirectionGrid::new(Vector::z(), Vector::x(), 0.1, [0.5, 0.8]).unwrap()
    }

    #[test]
    fn parallels_and_meridians_name_the_same_axes() {
        let g = grid();
        for (longitude, latitude) in [(0.3, 0.2), (-1.0, 0.7), (2.0, -0.4)] {
            let a = g.parallel(latitude).tool_axis(longitude);
            let b = g.meridian(longitude).tool_axis(latitude);
            assert!((a - b).norm() < 1e-12, "{a} {b}");
        }
    }

    /// Every way is tried on a small grid: none costs less.
    #[test]
    fn no_way_costs_less() {
        let g = DirectionGrid::new(Vector::z(), Vector::x(), 0.1, [0.1, 0.2]).unwrap();
        let s: Vec<f64> = (0..4).map(f64::from).collect();
        let mut seed = 12_345_u32;
        for _ in 0..50 {
            let mut any = || {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                seed >> 24 > 90
            };
            let free: Vec<FreeCells> = s.iter().map(|_| (0..g.cells()).map(|_| any()).collect()).collect();
            let near: Vec<Vec<f64>> = free.iter().map(|f| nearness(&g, f)).collect();
            let at = |cell: usize| [g.longitudes[cell % g.longitudes.len()], g.latitudes[cell / g.longitudes.len()]];
            // Cells on the straight line between two that are free at neither station, looked for
            // point by point.
            let blind = |p: usize, q: usize, free: [&FreeCells; 2]| {
                let place = |cell: usize| [(cell / g.longitudes.len()) as f64, (cell % g.longitudes.len()) as f64];
                let ([pr, pc], [qr, qc]) = (place(p), place(q));
                let steps = (qr - pr).abs().max((qc - pc).abs()) as i32;
                let taken = |k: &i32| {
                    let share = f64::from(*k) / f64::from(steps);
                    let (r, c) = (pr + (qr - pr) * share, pc + (qc - pc) * share);
                    let is_beside = |cell: &usize| {
                        let [row, column] = place(*cell);
                        let (dr, dc) = ((row - r).abs(), (column - c).abs());
                        dr < 1.0 - 1e-9 && dc < 1.0 - 1e-9
                    };
                    !(0..g.cells()).filter(is_beside).any(|cell| free.iter().any(|f| f[cell]))
                };
                (1..steps).filter(taken).count() as u32
            };
            let price = |way: &[usize]| {
                let mut sum = NEAR * near[0][way[0]];
                for k in 1..way.len() {
                    let (p, q) = (at(way[k - 1]), at(way[k]));
                    sum += BLIND * f64::from(blind(way[k - 1], way[k], [&free[k - 1], &free[k]]));
                    sum += (q[1] - p[1]).powi(2) + ((q[0] - p[0]) * q[1].cos()).powi(2) + NEAR * near[k][way[k]];
                }
                sum
            };
            // Reach is as wide as the grid but for its longitudes' ends.
            let joined = |p: usize, q: usize| (p % g.longitudes.len()).abs_diff(q % g.longitudes.len()) <= REACH;
            let mut least = f64::INFINITY;
            let all = 0..g.cells();
            for a in all.clone().filter(|c| free[0][*c]) {
                for b in all.clone().filter(|c| free[1][*c] && joined(a, *c)) {
                    for c in all.clone().filter(|c| free[2][*c] && joined(b, *c)) {
                        for d in all.clone().filter(|x| free[3][*x] && joined(c, *x)) {
                            least = least.min(price(&[a, b, c, d]));
                        }
                    }
                }
            }
            let found = least_way(&g, &s, &free, false).unwrap();
            assert_eq!(found.arrives, found.leaves);
            let cells: Vec<usize> =
                found.leaves.iter().map(|p| (0..g.cells()).find(|c| at(*c) == *p).unwrap()).collect();
            assert!(cells.iter().zip(&free).all(|(c, f)| f[*c]));
            assert!((price(&cells) - least).abs() < 1e-9, "{} {least}", price(&cells));
        }
    }

    /// A wall across all latitudes comes up between two stations: no way passes it but by a link,
    /// which the way takes where it costs least, once. Cells that are next to one another are
    /// reached without.
    #[test]
    fn a_link_leads_over_a_wall() {
        let g = grid();
        let (columns, rows) = (g.longitudes.len(), g.latitudes.len());
        let of = |free: &dyn Fn(usize) -> bool| -> FreeCells {
            (0..rows * columns).map(|cell| free(cell % columns)).collect()
        };
        let [left, right] = [of(&|c| c < 4), of(&|c| c > 10)];
        let both: FreeCells = left.iter().zip(&right).map(|(a, b)| *a || *b).collect();
        let s = [0.0, 1.0, 2.0, 3.0];
        let free = [left.clone(), both.clone(), both.clone(), right.clone()];
        assert_eq!(least_way(&g, &s, &free, false), Err(3));
        let way = least_way(&g, &s, &free, true).unwrap();
        let jumps: Vec<usize> = (0..4).filter(|k| way.arrives[*k] != way.leaves[*k]).collect();
        assert!(jumps.len() == 1 && (1..=2).contains(&jumps[0]), "{jumps:?}");
        let column = |at: f64| (0..columns).find(|c| g.longitudes[*c] == at).unwrap();
        for k in 0..4 {
            let [a, b] = [way.arrives[k], way.leaves[k]].map(|[longitude, _]| column(longitude));
            assert!(a < 4 && k <= jumps[0] || a > 10 && k > jumps[0], "station {k}: {a}");
            assert!(b < 4 && k < jumps[0] || b > 10 && k >= jumps[0], "station {k}: {b}");
        }
        // Where a way goes on, none is taken.
        let open = vec![true; g.cells()];
        let way = least_way(&g, &s, &[open.clone(), left.clone(), left, open], true).unwrap();
        assert_eq!(way.arrives, way.leaves);
        // Over cells that are free at neither station the way goes only where there is no link.
        let gap = of(&|c| c < 4 || c == 6);
        let way = least_way(&g, &s, &[gap.clone(), of(&|c| c < 4), of(&|c| c == 6), gap], true).unwrap();
        assert_eq!(way.arrives, way.leaves);
    }

    #[test]
    fn wide_cells_are_inside_by_all_of_the_margin() {
        let g = grid();
        let mut intervals = vec![Vec::new(); g.latitudes.len()];
        intervals[5] = vec![[-0.32, 0.12], [0.22, 0.25], [0.55, 0.75]];
        let wide = wide_cells(&g, &intervals, 0.05);
        let free = free_cells(&g, &intervals, 0.05);
        let columns = |of: &FreeCells| -> Vec<i32> {
            let inside = (0..g.longitudes.len()).filter(|c| of[g.cell(5, *c)]);
            inside.map(|c| (g.longitudes[c] * 10.0).round() as i32).collect()
        };
        assert_eq!(columns(&wide), [-2, -1, 0, 6]);
        assert_eq!(columns(&free), [-2, -1, 0, 2, 6]);
        assert!(holds(&[3.0, 3.5], 3.2 - 2.0 * PI, 0.1) && !holds(&[3.0, 3.5], 3.05, 0.1));
    }

    #[test]
    fn a_station_without_a_free_axis_is_named() {
        let g = grid();
        let open = vec![true; g.cells()];
        let free = [open.clone(), open.clone(), vec![false; g.cells()], open];
        assert_eq!(least_way(&g, &[0.0, 1.0, 2.0, 3.0], &free, false), Err(2));
        assert_eq!(least_way(&g, &[0.0, 1.0, 2.0, 3.0], &free, true), Err(2));
    }

    #[test]
    fn cells_are_free_where_the_interval_holds_them() {
        let g = grid();
        let mut intervals = vec![Vec::new(); g.latitudes.len()];
        intervals[5] = vec![[-0.32, 0.12]];
        let free = free_cells(&g, &intervals, 0.05);
        let columns: Vec<usize> = (0..g.longitudes.len()).filter(|c| free[g.cell(5, *c)]).collect();
        let angles: Vec<f64> = columns.iter().map(|c| g.longitudes[*c]).collect();
        assert_eq!(angles.len(), 3, "{angles:?}");
        assert!(angles.iter().all(|a| (-0.27..=0.07).contains(a)));
        assert_eq!(free.iter().filter(|f| **f).count(), 3);
        // What is narrower than a cell has one that stands for it.
        intervals[5] = vec![[0.22, 0.25]];
        let free = free_cells(&g, &intervals, 0.05);
        let column = (0..g.longitudes.len()).find(|c| free[g.cell(5, *c)]).unwrap();
        assert!((g.longitudes[column] - 0.2).abs() < 1e-9);
    }
}
