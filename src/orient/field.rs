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

    fn cell(&self, row: usize, column: usize) -> usize {
        row * self.longitudes.len() + column
    }
}

/// What is free at a station: one flag for each direction of the grid, latitude by latitude.
pub type FreeCells = Vec<bool>;

/// Share of a free interval that is kept either side where it is narrow.
const NARROW: f64 = 0.3;

/// Which directions of the grid stand for the free intervals of its latitudes, longitudes in rad:
/// those inside by `margin_rad`, or by a share of the width; where none is, the nearest to the
/// middle.
pub fn free_cells(grid: &DirectionGrid, intervals: &[Vec<[f64; 2]>], margin_rad: f64) -> FreeCells {
    let mut out = vec![false; grid.cells()];
    for (row, free) in intervals.iter().enumerate().take(grid.latitudes.len()) {
        for [lo, hi] in free {
            let margin = margin_rad.min(NARROW * (hi - lo));
            // A free circle is an interval with whole turns in it.
            let inside =
                |at: f64| [0.0, 2.0 * PI, -2.0 * PI].iter().any(|t| at + t - lo >= margin && hi - at - t >= margin);
            let mut any = false;
            for (column, _) in grid.longitudes.iter().enumerate().filter(|(_, at)| inside(**at)) {
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

/// The way that costs least, as longitude and latitude (rad) at each station; `s_mm` is where the
/// stations are, rising.
///
/// # Errors
/// The first station to which no way leads.
pub fn least_way(grid: &DirectionGrid, s_mm: &[f64], free: &[FreeCells]) -> Result<Vec<[f64; 2]>, usize> {
    let (rows, columns) = (grid.latitudes.len(), grid.longitudes.len());
    let step = |v: &[f64]| if v.len() > 1 { v[1] - v[0] } else { 0.0 };
    let [up, along] = [step(&grid.latitudes), step(&grid.longitudes)];
    let ways = (2 * REACH + 1) * (2 * REACH + 1);
    let mut cost: Vec<f64> = Vec::new();
    let mut back: Vec<Vec<u8>> = Vec::with_capacity(free.len());
    for (station, cells) in free.iter().enumerate() {
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
                    if sum < next[here] {
                        (next[here], from[here]) = (sum, way as u8);
                    }
                }
            }
        }
        if !next.iter().any(|c| c.is_finite()) {
            return Err(station);
        }
        cost = next;
        back.push(from);
    }
    let mut at = (0..cost.len()).min_by(|a, b| cost[*a].total_cmp(&cost[*b])).unwrap_or(0);
    let mut out = Vec::with_capacity(free.len());
    for from in back.iter().rev() {
        let (row, column) = (at / columns, at % columns);
        out.push([grid.longitudes[column], grid.latitudes[row]]);
        let way = usize::from(from[at]);
        if way < ways {
            let (dr, dc) = (way / (2 * REACH + 1), way % (2 * REACH + 1));
            at = grid.cell(row + dr - REACH, column + dc - REACH);
        }
    }
    out.reverse();
    Ok(out)
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
            let price = |way: &[usize]| {
                let mut sum = NEAR * near[0][way[0]];
                for k in 1..way.len() {
                    let (p, q) = (at(way[k - 1]), at(way[k]));
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
            let found = least_way(&g, &s, &free).unwrap();
            let cells: Vec<usize> = found.iter().map(|p| (0..g.cells()).find(|c| at(*c) == *p).unwrap()).collect();
            assert!(cells.iter().zip(&free).all(|(c, f)| f[*c]));
            assert!((price(&cells) - least).abs() < 1e-9, "{} {least}", price(&cells));
        }
    }

    #[test]
    fn a_station_without_a_free_axis_is_named() {
        let g = grid();
        let open = vec![true; g.cells()];
        let free = [open.clone(), open.clone(), vec![false; g.cells()], open];
        assert_eq!(least_way(&g, &[0.0, 1.0, 2.0, 3.0], &free), Err(2));
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
