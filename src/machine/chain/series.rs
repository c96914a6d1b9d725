//! Inverse kinematics of motions: axis positions as power series of a parameter, from those of ball
//! centre and tool axis.
//!
//! The zeroth terms are positions. The `n`th term of the rotary axes enters that of the tool axis
//! `R₁(q₁) R₂(q₂) a₀` linearly, by the derivatives at the zeroth terms, and lower terms are known:
//! so they follow one after another. The linear axes solve `S x = c − f`, `S` of their shifts,
//! term by term likewise. Nothing is differenced, so derivatives have the digits of positions.

use nalgebra::{Matrix3, Unit};

use super::{Head, Turn};
use crate::geometry::{Point, Vector};
use crate::numerics::series::{Series, TERMS};

type VectorSeries = [Series; 3];

fn constant(v: &Vector) -> VectorSeries {
    std::array::from_fn(|k| Series::constant(v[k]))
}

fn sum(a: &VectorSeries, b: &VectorSeries) -> VectorSeries {
    std::array::from_fn(|k| a[k] + b[k])
}

fn difference(a: &VectorSeries, b: &VectorSeries) -> VectorSeries {
    std::array::from_fn(|k| a[k] - b[k])
}

/// The `n`th terms.
fn term(v: &VectorSeries, n: usize) -> Vector {
    Vector::new(v[0].0[n], v[1].0[n], v[2].0[n])
}

fn through(matrix: &Matrix3<f64>, v: &VectorSeries) -> VectorSeries {
    std::array::from_fn(|r| v[0].scaled(matrix[(r, 0)]) + v[1].scaled(matrix[(r, 1)]) + v[2].scaled(matrix[(r, 2)]))
}

/// A rotation about a fixed direction by a series of angles.
struct Rotation {
    direction: Unit<Vector>,
    sin: Series,
    cos: Series,
}

impl Rotation {
    fn new(direction: Unit<Vector>, angle: Series) -> Self {
        let (sin, cos) = angle.sin_cos();
        Rotation { direction, sin, cos }
    }

    /// Rodrigues: `w cos + u × w sin + u (u·w) (1 − cos)`.
    fn turn(&self, w: &VectorSeries) -> VectorSeries {
        let u = &self.direction;
        let along = w[0].scaled(u.x) + w[1].scaled(u.y) + w[2].scaled(u.z);
        let rest = along - along * self.cos;
        std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let cross = w[j].scaled(u[i]) - w[i].scaled(u[j]);
            w[k] * self.cos + cross * self.sin + rest.scaled(u[k])
        })
    }

    /// A point turned about a line through `about`.
    fn turn_about(&self, about: &Point, p: &VectorSeries) -> VectorSeries {
        let about = constant(&about.coords);
        sum(&self.turn(&difference(p, &about)), &about)
    }
}

impl Head {
    /// Series of the rotary axes, the first and the second, that bring the tool along `axis`
    /// (workpiece's side of the chain) from their positions `at`.
    fn rotary_series(&self, axis: &VectorSeries, at: [f64; 2]) -> [Series; 2] {
        let mut q = at.map(Series::constant);
        let tool = constant(&self.tool);
        let u = self.first.direction;
        // Where the first axis alone turns, the other stands still to the bit.
        let second: Option<&Turn> = self.second.as_ref().filter(|_| self.along_blade().is_none());
        for n in 1..TERMS {
            let first = Rotation::new(u, q[0]);
            let leant = self.second.as_ref().map_or(tool, |s| Rotation::new(s.direction, q[1]).turn(&tool));
            let reached = first.turn(&leant);
            let missing = term(axis, n) - term(&reached, n);
            let by_first = u.cross(&term(&reached, 0));
            let by_second =
                second.map_or(Vector::zeros(), |s| self.first.rotation(at[0]) * s.direction.cross(&term(&leant, 0)));
            let (aa, ab, bb) = (by_first.norm_squared(), by_first.dot(&by_second), by_second.norm_squared());
            let (ra, rb) = (by_first.dot(&missing), by_second.dot(&missing));
            let whole = aa * bb - ab * ab;
            let solved = if whole > 1e-12 * aa * bb {
                [(bb * ra - ab * rb) / whole, (aa * rb - ab * ra) / whole]
            } else {
                [ra / aa, 0.0]
            };
            q[0].0[n] = solved[0];
            q[1].0[n] = solved[1];
        }
        q
    }

    /// Axis positions as series of a parameter: of X, Y, Z, then of the first and the second rotary
    /// axis. `centre` and `axis` in the blade frame, `at`: where the rotary axes stand at 0. `None`
    /// where the linear axes do not reach all places.
    pub(in crate::machine) fn series(
        &self,
        centre: &VectorSeries,
        axis: &VectorSeries,
        at: [f64; 2],
        gauge_length_mm: f64,
    ) -> Option<[Series; 5]> {
        let mount = self.mount.rotation.to_rotation_matrix();
        let wanted = through(mount.matrix(), axis);
        let [q1, q2] = self.rotary_series(&wanted, at);
        let first = Rotation::new(self.first.direction, q1);
        let second = self.second.as_ref().map(|s| (s, Rotation::new(s.direction, q2)));
        let mut ball = constant(&(self.gauge - self.tool * gauge_length_mm).coords);
        if let Some((turn, rotation)) = &second {
            ball = rotation.turn_about(&turn.point, &ball);
        }
        let from = first.turn_about(&self.first.point, &ball);
        let place = sum(&through(mount.matrix(), centre), &constant(&self.mount.translation.vector));
        let side = difference(&place, &from);
        let column = |k: usize| {
            let (direction, before) = &self.linear[k];
            let mut w = constant(direction);
            if let (2, Some((_, rotation))) = (*before, &second) {
                w = rotation.turn(&w);
            }
            if *before > 0 { first.turn(&w) } else { w }
        };
        let columns = [column(0), column(1), column(2)];
        let matrix = |n: usize| Matrix3::from_columns(&columns.map(|c| term(&c, n)));
        let inverse = matrix(0).try_inverse()?;
        let mut x = [Series::default(); 3];
        for n in 0..TERMS {
            let known: Vector = (1..=n).map(|k| matrix(k) * term(&x, n - k)).sum();
            let solved = inverse * (term(&side, n) - known);
            (0..3).for_each(|k| x[k].0[n] = solved[k]);
        }
        Some([x[0], x[1], x[2], q1, q2])
    }
}
