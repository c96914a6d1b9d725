//! Values of the field between the vertices of its mesh.

use nalgebra::{SMatrix, SVector};
use rustc_hash::FxHashMap;

use super::super::level::{LevelSet, Touch};
use super::eikonal::{ONE_SHEET, share_of_scallop, tangent_plane};
use super::feet::Curve;
use super::net::{Cell, Net, cell_of, cells_about};
use crate::geometry::{Point, Vector};

/// Weight of a place of the end beside that of a vertex: places lie four to a cell.
const OF_END: f64 = 0.3;
/// Below this value it is measured to the end itself.
const NEAR_END: f64 = 1.1;
/// Newton steps onto a value.
const MOST_STEPS: usize = 4;
/// Longest of them, in cells.
const LONGEST: f64 = 1.5;
/// A step shorter than this, in cells, is not taken: turns are polished from there.
const SHORTEST: f64 = 0.01;

/// The field.
pub struct Field<'a> {
    pub level: &'a LevelSet<'a>,
    pub net: &'a Net,
    pub phi: Vec<f64>,
    /// Where it is 0.
    pub end: &'a Curve,
    /// Numbers of the end's places in each cell.
    pub end_in: FxHashMap<Cell, Vec<u32>>,
    /// Reach of a fit, in cells.
    pub reach: f64,
    pub scallop_mm: f64,
}

impl<'a> Field<'a> {
    pub fn new(level: &'a LevelSet, net: &'a Net, phi: Vec<f64>, end: &'a Curve, reach: f64, scallop_mm: f64) -> Self {
        let mut end_in: FxHashMap<Cell, Vec<u32>> = FxHashMap::default();
        for (i, t) in end.touches.iter().enumerate() {
            end_in.entry(cell_of(&t.centre, net.cell_mm)).or_default().push(i as u32);
        }
        Field { level, net, phi, end, end_in, reach, scallop_mm }
    }

    /// Value and gradient (1/mm) at a ball: of the quadratic that fits the vertices about it best
    /// (moving least squares); the value near the end by the ridge to it.
    pub fn at(&self, at: &Touch) -> Option<(f64, Vector)> {
        let (value, gradient) = self.fit(at)?;
        if value < NEAR_END
            && !self.level.is_over_facets()
            && let Some(share) = self.end.foot(&at.centre).and_then(|f| self.share(&f, &at.centre))
        {
            return Some((share, gradient));
        }
        Some((value, gradient))
    }

    fn share(&self, foot: &Point, q: &Point) -> Option<f64> {
        let foot = self.level.touch(foot, 0.1 * self.level.radius_mm)?;
        share_of_scallop(self.level, q, &foot.centre, self.scallop_mm)
    }

    fn fit(&self, at: &Touch) -> Option<(f64, Vector)> {
        let normal = at.normal;
        let [e, f] = tangent_plane(&normal);
        let cells = self.reach.ceil() as i32;
        let reach_mm = self.reach * self.net.cell_mm;
        let mut m = SMatrix::<f64, 6, 6>::zeros();
        let mut y = SVector::<f64, 6>::zeros();
        let mut count = 0;
        let mut add = |t: &Touch, value: f64, weight: f64| {
            let off = t.centre - at.centre;
            let share = off.norm() / reach_mm;
            if share >= 1.0 || !value.is_finite() || t.normal.dot(&normal) < ONE_SHEET {
                return;
            }
            let w = weight * (1.0 - share * share).powi(2);
            let (a, b) = (off.dot(&e) / self.net.cell_mm, off.dot(&f) / self.net.cell_mm);
            let row = SVector::<f64, 6>::from([1.0, a, b, a * a, a * b, b * b]);
            m += row * row.transpose() * w;
            y += row * (w * value);
            count += 1;
        };
        for v in self.net.about(&at.centre, cells) {
            if self.net.within[v as usize] {
                add(&self.net.touches[v as usize], self.phi[v as usize], 1.0);
            }
        }
        if self.is_near_end(at) {
            for cell in cells_about(cell_of(&at.centre, self.net.cell_mm), cells) {
                for n in self.end_in.get(&cell).into_iter().flatten() {
                    add(&self.end.touches[*n as usize], 0.0, OF_END);
                }
            }
        }
        if count < 7 {
            return None;
        }
        for i in 3..6 {
            m[(i, i)] += 1e-6;
        }
        let c = m.cholesky()?.solve(&y);
        Some((c[0], (e * c[1] + f * c[2]) / self.net.cell_mm))
    }

    /// Whether the end may be within reach: some vertex about has a low value.
    fn is_near_end(&self, at: &Touch) -> bool {
        let least = self.net.about(&at.centre, 1).map(|v| self.phi[v as usize]).fold(f64::INFINITY, f64::min);
        least < 8.0 || least.is_infinite()
    }

    /// The ball moved along the gradient to where the field has a value.
    pub fn onto(&self, mut at: Touch, value: f64) -> Option<Touch> {
        let longest_mm = LONGEST * self.net.cell_mm;
        for _ in 0..MOST_STEPS {
            let (here, gradient) = self.at(&at)?;
            let step = gradient * ((value - here) / gradient.norm_squared().max(1e-12));
            let step = if step.norm() > longest_mm { step * (longest_mm / step.norm()) } else { step };
            if step.norm() < SHORTEST * self.net.cell_mm {
                break;
            }
            at = self.level.touch(&(at.centre + step), longest_mm)?;
        }
        Some(at)
    }
}
