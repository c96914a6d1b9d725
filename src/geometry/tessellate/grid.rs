//! How densely a face needs points along u and along v: a map of its parameter plane in which one
//! unit is one triangle.

use super::TessellateOptions;
use crate::geometry::nurbs::NurbsSurface;
use crate::geometry::nurbs::foot::ParameterSpace;

/// Samples along each direction for curvature.
const SAMPLES: usize = 33;
/// No direction gets more lines than this.
const MOST_LINES: f64 = 4000.0;
/// No face gets more cells than this: one that asks for them is damaged or in a wrong unit, and a
/// coarser mesh gives its deflection.
const MOST_CELLS: f64 = 2e5;

/// A monotone map of one parameter: piecewise linear, one unit per line of the grid.
#[derive(Clone, Debug)]
pub struct GridScale {
    at: Vec<f64>,
    to: Vec<f64>,
}

impl GridScale {
    fn new(at: Vec<f64>, density: &[f64]) -> Self {
        let mut to = vec![0.0];
        let mut sum = 0.0;
        for (k, w) in at.windows(2).enumerate() {
            sum += 0.5 * (density[k] + density[k + 1]) * (w[1] - w[0]);
            to.push(sum);
        }
        // A whole number of lines where there is more than one.
        let factor = if sum > 1.0 { sum.min(MOST_LINES).ceil() / sum } else { 1.0 };
        to.iter_mut().for_each(|x| *x *= factor);
        GridScale { at, to }
    }
    /// Grid coordinate of a parameter; continued in a straight line beyond the ends.
    pub fn map(&self, x: f64) -> f64 {
        interpolate(&self.at, &self.to, x)
    }
    /// Parameter of a grid coordinate.
    pub fn inverse(&self, y: f64) -> f64 {
        interpolate(&self.to, &self.at, y)
    }
}

fn interpolate(xs: &[f64], ys: &[f64], x: f64) -> f64 {
    let k = xs.partition_point(|a| *a <= x).clamp(1, xs.len() - 1);
    let width = xs[k] - xs[k - 1];
    if width > 0.0 { ys[k - 1] + (x - xs[k - 1]) / width * (ys[k] - ys[k - 1]) } else { ys[k] }
}

/// Both scales over the box of the rings (`[u, v][from, to]`, unrolled); `finer` multiplies all
/// densities.
pub fn scales(
    s: &NurbsSurface,
    space: &ParameterSpace,
    bounds: [[f64; 2]; 2],
    o: &TessellateOptions,
    finer: f64,
) -> [GridScale; 2] {
    let line = |along: usize| -> Vec<f64> {
        let [from, to] = bounds[along];
        (0..SAMPLES).map(|k| from + (to - from) * k as f64 / (SAMPLES - 1) as f64).collect()
    };
    let at = [line(0), line(1)];
    let mut need = [vec![0.0f64; SAMPLES], vec![0.0f64; SAMPLES]];
    let mut speed = [vec![0.0f64; SAMPLES], vec![0.0f64; SAMPLES]];
    for (i, u) in at[0].iter().enumerate() {
        for (j, v) in at[1].iter().enumerate() {
            let uv = space.normal_form([*u, *v]);
            let d = s.derivatives(uv[0], uv[1]);
            let normal = d.normal();
            let length = [d.du.norm(), d.dv.norm()];
            for (along, k) in [(0, i), (1, j)] {
                speed[along][k] = speed[along][k].max(length[along]);
            }
            let Some(n) = normal else { continue };
            let bend = [d.duu.dot(&n).abs(), d.dvv.dot(&n).abs()];
            let mut wanted = [0, 1].map(|a| density(length[a], bend[a], o));
            let extent = [0, 1].map(|a| bounds[a][1] - bounds[a][0]);
            twist(&mut wanted, length, extent, d.duv.dot(&n).abs(), o);
            for (along, k) in [(0, i), (1, j)] {
                need[along][k] = need[along][k].max(wanted[along]);
            }
        }
    }
    let size = [0, 1].map(|a| mean(&speed[a]) * (bounds[a][1] - bounds[a][0]));
    let longest = size[0].max(size[1]).max(f64::MIN_POSITIVE);
    let mut densities = [0, 1].map(|along| {
        // At least the metric, so that flat directions are neither lost nor stretched.
        let floor = mean(&speed[along]) / longest;
        let total = bounds[along][1] - bounds[along][0];
        let density: Vec<f64> =
            need[along].iter().map(|n| (n.max(floor) * finer).min(MOST_LINES / total.max(f64::MIN_POSITIVE))).collect();
        let floor_all = density.iter().copied().fold(0.0, f64::max) * 0.02;
        density.iter().map(|d| d.max(floor_all)).collect::<Vec<_>>()
    });
    let cells: f64 = (0..2).map(|a| mean(&densities[a]) * (bounds[a][1] - bounds[a][0])).product();
    if cells > MOST_CELLS {
        let factor = (MOST_CELLS / cells).sqrt();
        densities.iter_mut().flatten().for_each(|d| *d *= factor);
    }
    [0, 1].map(|a| GridScale::new(at[a].clone(), &densities[a]))
}

/// Lines per unit of one parameter that its own curvature asks for.
fn density(length: f64, bend: f64, o: &TessellateOptions) -> f64 {
    // Sagitta h² |S_uu · n| / 8 within a third of the deflection; turn h |S_uu · n| / |S_u| within
    // the angle.
    let sag = (bend / (8.0 * o.deflection_mm / 3.0)).sqrt();
    let turn = if length > 0.0 { bend / (length * o.angle_rad) } else { 0.0 };
    // Around a radius smaller than the deflection the angle says nothing.
    sag.max(turn.min(length / o.deflection_mm))
}

/// Raises both densities until the twist of a cell, h_u h_v |S_uv · n| / 4, is within a third of
/// the deflection too: first the direction in which cells are longer, then both alike.
fn twist(wanted: &mut [f64; 2], length: [f64; 2], extent: [f64; 2], uv: f64, o: &TessellateOptions) {
    let area = 4.0 * o.deflection_mm / (3.0 * uv) * length[0] * length[1];
    let cell = [0, 1].map(|a| length[a] * extent[a].min(1.0 / wanted[a]));
    if !area.is_finite() || cell[0] * cell[1] <= area {
        return;
    }
    let short = usize::from(cell[1] < cell[0]);
    let even = area.sqrt();
    let sides = if cell[short] < even { [cell[short], area / cell[short]] } else { [even, even] };
    for (a, side) in [(short, sides[0]), (1 - short, sides[1])] {
        wanted[a] = wanted[a].max(length[a] / side);
    }
}

fn mean(x: &[f64]) -> f64 {
    x.iter().sum::<f64>() / x.len().max(1) as f64
}
