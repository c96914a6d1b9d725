//! A mesh of the level set: one vertex for each cell of a grid that the set runs through.
//!
//! The mesh grows from seeds over the cells that share a face with a sign change, as far as places
//! are within bounds, and one vertex farther. Each vertex is the mean of the crossings on the
//! cell's edges (naive surface nets), brought onto the level set.

use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};

use super::super::level::{LevelSet, Touch};
use crate::error::Result;
use crate::geometry::{Point, Vector};

/// A cell of the grid, or the corner it begins at.
pub type Cell = [i32; 3];

/// An edge of the mesh, the lesser vertex first.
pub type Edge = (u32, u32);

/// The mesh.
pub struct Net {
    /// Edge of a cell, mm.
    pub cell_mm: f64,
    /// The balls at the vertices.
    pub touches: Vec<Touch>,
    /// Whether a vertex is within bounds and joined to the seeds.
    pub within: Vec<bool>,
    /// The vertex of each cell.
    of: FxHashMap<Cell, u32>,
    /// Two triangles for each grid edge between four cells.
    pub triangles: Vec<[u32; 3]>,
    /// Those, and the two of the other diagonal.
    pub both_ways: Vec<[u32; 3]>,
}

/// Distance at which a border is known, mm.
const BORDER_MM: f64 = 1e-6;
/// Halvings towards a border.
const HALVINGS: usize = 40;

const CORNERS: [Cell; 8] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]];

fn plus(a: &Cell, b: &Cell) -> Cell {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// The cell of a place.
pub fn cell_of(p: &Point, cell_mm: f64) -> Cell {
    [0, 1, 2].map(|a| (p[a] / cell_mm).floor() as i32)
}

/// The cells up to so many away from one, itself among them.
pub fn cells_about([x, y, z]: Cell, n: i32) -> impl Iterator<Item = Cell> {
    (-n..=n).flat_map(move |i| (-n..=n).flat_map(move |j| (-n..=n).map(move |k| [x + i, y + j, z + k])))
}

/// Signed distances to the level set at the corners of cells.
struct Grid<'a> {
    level: &'a LevelSet<'a>,
    cell_mm: f64,
    value_mm: FxHashMap<Cell, f64>,
}

impl Grid<'_> {
    fn place(&self, k: &Cell) -> Point {
        Point::from(k.map(|i| f64::from(i) * self.cell_mm))
    }

    /// Measures the corners of cells that are not known yet.
    fn know(&mut self, cells: &[Cell]) {
        let mut asked = Vec::new();
        for corner in cells.iter().flat_map(|k| CORNERS.map(|c| plus(k, &c))) {
            self.value_mm.entry(corner).or_insert_with(|| {
                asked.push(corner);
                f64::NAN
            });
        }
        let far_mm = 3.0 * self.cell_mm;
        let radius_mm = self.level.radius_mm;
        let off = |k: &Cell| {
            let near = self.level.part.closest(&self.place(k), radius_mm + far_mm);
            near.map_or(far_mm, |c| c.distance_mm - radius_mm)
        };
        let found: Vec<f64> = asked.par_iter().map(off).collect();
        self.value_mm.extend(asked.into_iter().zip(found));
    }

    fn values(&self, k: &Cell) -> [f64; 8] {
        CORNERS.map(|c| self.value_mm.get(&plus(k, &c)).copied().unwrap_or(f64::NAN))
    }

    /// The ball in a cell, where the level set runs through it.
    fn vertex(&self, k: &Cell) -> Option<Touch> {
        let v = self.values(k);
        let (mut sum, mut count) = (Vector::zeros(), 0);
        for i in 0..8usize {
            for j in [i | 1, i | 2, i | 4] {
                if j != i && (v[i] < 0.0) != (v[j] < 0.0) {
                    let [a, b] = [i, j].map(|c| Vector::from(CORNERS[c].map(f64::from)));
                    sum += a + (b - a) * (v[i] / (v[i] - v[j]));
                    count += 1;
                }
            }
        }
        if count == 0 {
            return None;
        }
        self.level.touch(&(self.place(k) + sum * (self.cell_mm / f64::from(count))), self.cell_mm)
    }

    /// The cells beyond the faces through which the level set leaves a cell.
    fn beyond(&self, k: &Cell) -> Vec<Cell> {
        let v = self.values(k);
        let mut out = Vec::with_capacity(4);
        for axis in 0..3 {
            for side in [0, 1] {
                let on_face = |c: &usize| CORNERS[*c][axis] == side;
                let below = (0..8).filter(on_face).filter(|c| v[*c] < 0.0).count();
                if below > 0 && below < 4 {
                    let mut next = *k;
                    next[axis] += 2 * side - 1;
                    out.push(next);
                }
            }
        }
        out
    }
}

impl Net {
    /// The mesh about seeds, as far as `within` holds. `goes_on` is asked between waves.
    ///
    /// # Errors
    /// Those of `goes_on`.
    pub fn grow(
        level: &LevelSet,
        seeds: &[Touch],
        cell_mm: f64,
        within: &(impl Fn(&Touch) -> bool + Sync),
        goes_on: &dyn Fn() -> Result<()>,
    ) -> Result<Net> {
        let mut grid = Grid { level, cell_mm, value_mm: FxHashMap::default() };
        let mut net = Net {
            cell_mm,
            touches: Vec::new(),
            within: Vec::new(),
            of: FxHashMap::default(),
            triangles: Vec::new(),
            both_ways: Vec::new(),
        };
        // Cells that were come to, and those of them that were come to from outside only.
        let (mut seen, mut from_outside): (FxHashSet<Cell>, FxHashSet<Cell>) =
            (FxHashSet::default(), FxHashSet::default());
        let mut wave: Vec<Cell> = Vec::new();
        for cell in seeds.iter().map(|t| cell_of(&t.centre, cell_mm)) {
            if seen.insert(cell) {
                wave.push(cell);
            }
        }
        while !wave.is_empty() {
            goes_on()?;
            grid.know(&wave);
            let found: Vec<Option<(Touch, bool)>> =
                wave.par_iter().map(|k| grid.vertex(k).map(|t| (t, within(&t)))).collect();
            let mut next = Vec::new();
            for (cell, vertex) in wave.iter().zip(found) {
                let Some((touch, holds)) = vertex else { continue };
                let is_outer = from_outside.contains(cell);
                let is_within = holds && !is_outer;
                let number = *net.of.entry(*cell).or_insert_with(|| {
                    net.touches.push(touch);
                    net.within.push(false);
                    net.touches.len() as u32 - 1
                });
                net.within[number as usize] |= is_within;
                if is_outer {
                    continue;
                }
                // One more vertex beyond those outside, so that every border has its triangles.
                for beyond in grid.beyond(cell) {
                    let is_new = seen.insert(beyond);
                    if is_within {
                        if from_outside.remove(&beyond) || is_new {
                            next.push(beyond);
                        }
                    } else if is_new {
                        from_outside.insert(beyond);
                        next.push(beyond);
                    }
                }
            }
            wave = next;
        }
        net.join(&grid);
        Ok(net)
    }

    /// Makes the triangles: a grid edge that the level set crosses lies between four cells.
    fn join(&mut self, grid: &Grid) {
        let mut cells: Vec<Cell> = self.of.keys().copied().collect();
        cells.sort_unstable();
        for k in cells {
            let start = grid.value_mm.get(&k).copied().unwrap_or(f64::NAN);
            for axis in 0..3 {
                let mut ahead = k;
                ahead[axis] += 1;
                let Some(end) = grid.value_mm.get(&ahead) else { continue };
                if (start < 0.0) == (*end < 0.0) {
                    continue;
                }
                let (u, w) = ((axis + 1) % 3, (axis + 2) % 3);
                let at = |[du, dw]: [i32; 2]| {
                    let mut c = k;
                    c[u] -= du;
                    c[w] -= dw;
                    self.of.get(&c).copied()
                };
                let [Some(a), Some(b), Some(c), Some(d)] = [[0, 0], [1, 0], [1, 1], [0, 1]].map(at) else { continue };
                let length = |p: u32, q: u32| (self.centre(p) - self.centre(q)).norm();
                let (one, other) = ([[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]);
                self.triangles.extend(if length(a, c) < length(b, d) { one } else { other });
                self.both_ways.extend(one.into_iter().chain(other));
            }
        }
    }

    /// Ball centre of a vertex.
    pub fn centre(&self, vertex: u32) -> Point {
        self.touches[vertex as usize].centre
    }

    /// Vertices in the cells about a place, up to so many cells away.
    pub fn about(&self, p: &Point, cells: i32) -> impl Iterator<Item = u32> + '_ {
        cells_about(cell_of(p, self.cell_mm), cells).filter_map(|c| self.of.get(&c).copied())
    }

    /// Where a line of equal values crosses an edge: between two known values at their shares;
    /// `None` at the border, beyond which values are infinite.
    pub fn crossing(&self, (a, b): Edge, values: &[f64], value: f64) -> Option<Point> {
        let (at_a, at_b) = (values[a as usize], values[b as usize]);
        let share = (value - at_a) / (at_b - at_a);
        let way = self.centre(b) - self.centre(a);
        (at_a.is_finite() && at_b.is_finite()).then(|| self.centre(a) + way * share)
    }

    /// Which vertices lie within so many cells of any of these balls.
    pub fn beside(&self, touches: &[Touch], cells: i32) -> Vec<bool> {
        let mut out = vec![false; self.touches.len()];
        for t in touches {
            self.about(&t.centre, cells).for_each(|v| out[v as usize] = true);
        }
        out
    }

    /// The last ball within bounds on an edge that leaves them, and the first beyond.
    pub fn border(&self, level: &LevelSet, edge: Edge, within: &impl Fn(&Touch) -> bool) -> [Touch; 2] {
        let (a, b) = edge;
        let (inner, outer) = if self.within[a as usize] { (a, b) } else { (b, a) };
        let (mut inside, mut outside) = (self.touches[inner as usize], self.touches[outer as usize]);
        for _ in 0..HALVINGS {
            if (outside.centre - inside.centre).norm() < BORDER_MM {
                break;
            }
            let middle = nalgebra::center(&inside.centre, &outside.centre);
            match level.touch(&middle, self.cell_mm) {
                Some(t) if within(&t) => inside = t,
                Some(t) => outside = t,
                None => break,
            }
        }
        [inside, outside]
    }
}

/// Closed lines between the vertices of which `below` holds and the others, as the edges that they
/// cross in order; open ones, which end at the rim of the mesh, are left out.
pub fn lines(triangles: &[[u32; 3]], below: impl Fn(u32) -> bool) -> Vec<Vec<Edge>> {
    let mut links: FxHashMap<Edge, Vec<Edge>> = FxHashMap::default();
    for t in triangles {
        let [a, b, c] = t.map(&below);
        let sides = [(t[0], t[1], a != b), (t[1], t[2], b != c), (t[2], t[0], c != a)];
        let crossed: Vec<Edge> = sides.iter().filter(|s| s.2).map(|s| (s.0.min(s.1), s.0.max(s.1))).collect();
        if let [one, other] = crossed[..] {
            links.entry(one).or_default().push(other);
            links.entry(other).or_default().push(one);
        }
    }
    let mut starts: Vec<Edge> = links.keys().copied().collect();
    starts.sort_unstable();
    let mut used: FxHashSet<Edge> = FxHashSet::default();
    let mut out = Vec::new();
    for start in starts {
        if !used.insert(start) {
            continue;
        }
        let mut line = vec![start];
        let mut here = start;
        while let Some(next) = links[&here].iter().find(|n| !used.contains(*n)).copied() {
            used.insert(next);
            line.push(next);
            here = next;
        }
        if line.len() > 2 && links[&here].contains(&start) {
            out.push(line);
        }
    }
    out
}
