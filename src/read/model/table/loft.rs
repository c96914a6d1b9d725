//! Surfaces through a grid of points, and their distance from the points of the table.
//!
//! Along the span the surfaces are cubic (of lower degree through two or three sections), with the
//! mean chord length as parameter; neighbouring surfaces share the control points of their common
//! boundary bit by bit (*The NURBS Book*, 9.2, global interpolation).

use super::grid::{Grid, by_number, by_shape, pieces};
use super::outline::TableOutline;
use crate::geometry::Point;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::fit::surface_through_rows;
use crate::geometry::nurbs::foot::ParameterSpace;
use crate::observe::Remark;
use crate::parallel;

/// Samples of a section are made denser until the points of the table are this near, as a share of
/// the tolerance.
const GOAL: f64 = 0.2;
/// Columns from which the foot of a point is sought.
const SEEDS: usize = 8;
/// A foot this near ends the search, mm.
const CLOSE_MM: f64 = 1e-9;
/// Most columns of a grid.
const MOST_AROUND: usize = 3000;

/// Fewest sections for the test that leaves every second one out.
const ENOUGH_SECTIONS: usize = 6;

/// Points of one section whose distance is asked.
struct Probe {
    points: Vec<Point>,
    /// Row of the grid at or below them.
    row: usize,
    /// Guess of the parameter along the span.
    v: f64,
    /// Point and column of the grid have the same number.
    aligned: bool,
}

/// Surfaces round the blade, between the anchors of their grid; `u` round, `v` along the span.
pub struct Loft {
    /// The grid that they pass through.
    pub grid: Grid,
    /// One for each anchor, from it to the next.
    pub surfaces: Vec<NurbsSurface>,
    around: Vec<f64>,
    along: Vec<f64>,
}

/// The surfaces' distance from the table's points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FitError {
    /// Greatest, mm.
    pub greatest_mm: f64,
    /// Where: section and point in the table.
    pub at: (usize, usize),
    /// Root of the mean square, mm.
    pub rms_mm: f64,
}

/// A loft of sections, how far it is from their points, and how it was made.
pub struct Fitted {
    /// The loft.
    pub loft: Loft,
    /// Its distance from the points.
    pub error: FitError,
    /// The points of the table are those of the grid.
    pub by_number: bool,
    /// What the user should know.
    pub note: Option<Remark>,
}

/// The loft through sections that are aligned: through the points themselves where they belong
/// together by number, through splines of the sections otherwise.
///
/// # Errors
/// A sentence: edges that differ, surfaces that cannot be interpolated.
pub fn fit(outlines: &[TableOutline], tolerance_mm: f64) -> Result<Fitted, String> {
    if let Some(grid) = by_number(outlines) {
        let loft = Loft::through(grid)?;
        let error = loft.error(outlines);
        return Ok(Fitted { loft, error, by_number: true, note: None });
    }
    // Where sections differ in their sharp edges, all are taken as round.
    let note = by_shape(outlines, 1, true).err().map(|reason| Remark::EdgesTakenAsRound { reason });
    let mut best: Option<Fitted> = None;
    for parts in [1, 2, 4, 8] {
        let grid = by_shape(outlines, parts, note.is_none())?;
        if best.is_some() && grid.around() > MOST_AROUND {
            break;
        }
        let loft = Loft::through(grid)?;
        let error = loft.error(outlines);
        if best.as_ref().is_none_or(|b| error.greatest_mm < b.error.greatest_mm) {
            best = Some(Fitted { loft, error, by_number: false, note: note.clone() });
        }
        if error.greatest_mm <= GOAL * tolerance_mm {
            break;
        }
    }
    best.ok_or_else(|| "there are no sections to join".into())
}

impl Loft {
    /// Interpolates a grid.
    ///
    /// # Errors
    /// A sentence: points that coincide, or parameters without a solution.
    pub fn through(grid: Grid) -> Result<Self, String> {
        let (around, along) = (grid.params_around(), grid.params_along());
        let no = |e| format!("no surface passes through the sections: {e}");
        let degree = 3.min(grid.rows.len().saturating_sub(1));
        let rows = pieces(&grid, &around).map_err(no)?;
        let surfaces = rows
            .iter()
            .map(|r| {
                let mut s = surface_through_rows(r, &along, degree)?;
                s.points.iter_mut().for_each(|p| p.w = 1.0);
                Ok(s)
            })
            .collect::<Result<Vec<_>, _>>()
            .map_err(no)?;
        Ok(Loft { grid, surfaces, around, along })
    }

    /// Distance of the points of the table, section by section, from the surfaces.
    pub fn error(&self, outlines: &[TableOutline]) -> FitError {
        let probe = |(row, o): (usize, &TableOutline)| Probe {
            points: o.table.clone(),
            row,
            v: self.along[row],
            aligned: false,
        };
        self.distances(&outlines.iter().enumerate().map(probe).collect::<Vec<_>>())
    }

    /// How far a loft through every second point between the anchors is from the points that it
    /// leaves out: what the surface does between the points of the table.
    pub fn without_points(&self) -> Option<FitError> {
        let thin = Loft::through(self.grid.thinned_around()).ok()?;
        let probe = |(row, points): (usize, &Vec<Point>)| Probe {
            points: points.clone(),
            row,
            v: thin.along[row],
            aligned: false,
        };
        Some(thin.distances(&self.grid.rows.iter().enumerate().map(probe).collect::<Vec<_>>()))
    }

    /// The same for every second section; only where enough of them are there.
    pub fn without_sections(&self) -> Option<FitError> {
        if self.grid.rows.len() < ENOUGH_SECTIONS {
            return None;
        }
        let thin = Loft::through(self.grid.thinned_along()).ok()?;
        let last = thin.along.len() - 1;
        // Even sections are kept, odd ones lie between two of them.
        let probes = (1..self.grid.rows.len()).step_by(2).map(|i| {
            let (row, above) = (i / 2, (i / 2 + 1).min(last));
            let v = if i + 1 == self.grid.rows.len() {
                thin.along[last]
            } else {
                0.5 * (thin.along[row] + thin.along[above])
            };
            Probe { points: self.grid.rows[i].clone(), row, v, aligned: true }
        });
        Some(thin.distances(&probes.collect::<Vec<_>>()))
    }

    fn distances(&self, probes: &[Probe]) -> FitError {
        let spaces: Vec<ParameterSpace> = self.surfaces.iter().map(|s| ParameterSpace::of(s, 1e-9)).collect();
        let one = |p: &Probe| -> Vec<f64> {
            let column = |j: usize| if p.aligned { Some(j) } else { None };
            p.points.iter().enumerate().map(|(j, q)| self.distance(q, p.row, p.v, column(j), &spaces)).collect()
        };
        let found: Vec<Vec<f64>> = parallel::map(probes, one);
        let (mut out, mut sum, mut count) = (FitError::default(), 0.0, 0usize);
        for (i, row) in found.iter().enumerate() {
            for (j, &d) in row.iter().enumerate() {
                sum += d * d;
                count += 1;
                if d > out.greatest_mm {
                    (out.greatest_mm, out.at) = (d, (i, j));
                }
            }
        }
        out.rms_mm = (sum / count.max(1) as f64).sqrt();
        out
    }

    /// Distance from the surfaces that meet the grid's nearest columns of a row: several, since on
    /// a thin blade the nearest one may be on the other side.
    fn distance(&self, q: &Point, row: usize, v: f64, column: Option<usize>, spaces: &[ParameterSpace]) -> f64 {
        let row = &self.grid.rows[row.min(self.grid.rows.len() - 1)];
        let n = row.len();
        let mut near: Vec<(f64, usize)> = Vec::with_capacity(SEEDS + 1);
        for (j, p) in row.iter().enumerate() {
            let d = (p - q).norm_squared();
            if near.len() < SEEDS || near.last().is_some_and(|l| d < l.0) {
                near.insert(near.partition_point(|x| x.0 <= d), (d, j));
                near.truncate(SEEDS);
            }
        }
        let mut best = f64::INFINITY;
        for column in column.into_iter().chain(near.into_iter().map(|(_, j)| j)) {
            for (k, surface) in self.surfaces.iter().enumerate() {
                let piece = self.grid.piece(k);
                for j in [column, column + n] {
                    if best > CLOSE_MM && piece.contains(&j) {
                        let [[u0, _], _] = surface.domain();
                        let u = u0 + self.around[j] - self.around[*piece.start()];
                        best = best.min(surface.foot(q, [u, v], &spaces[k]).distance_mm);
                    }
                }
            }
        }
        best
    }
}
