//! Squares of third derivatives as quadratic forms of the control points of a span.

use crate::geometry::Point;
use crate::machine::Machine;
use crate::numerics::quintic::{Breaks, ORDER, apply};

/// A function of the control points of a span, about given ones.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form<const W: usize> {
    /// Second derivative by the control points, one after another.
    pub hessian: Box<[[f64; W]; W]>,
    /// First derivative at the given ones.
    pub gradient: [f64; W],
    /// Value there.
    pub value: f64,
}

/// Half the integral of the square of the third derivative over span `i`, about the control points
/// `x`. Third differences of the ordinates times `60/h³` are the ordinates of that derivative, a
/// polynomial of degree 2.
pub(super) fn third<const D: usize, const W: usize>(breaks: &Breaks, i: usize, x: &[[f64; D]]) -> Form<W> {
    /// Integrals of products of Bernstein's polynomials of degree 2 over an interval of length 1.
    const GRAM: [[f64; 3]; 3] = [[0.2, 0.1, 1.0 / 30.0], [0.1, 2.0 / 15.0, 0.1], [1.0 / 30.0, 0.1, 0.2]];
    let [a, b] = breaks.span(i);
    let h = b - a;
    let map = breaks.ordinates(i, [a, b]);
    let factor = 60.0 / (h * h * h);
    let third: [[f64; ORDER]; 3] = std::array::from_fn(|j| {
        std::array::from_fn(|k| factor * (map[j + 3][k] - 3.0 * map[j + 2][k] + 3.0 * map[j + 1][k] - map[j][k]))
    });
    let ordinates = apply(&map, x);
    let now: [[f64; D]; 3] = std::array::from_fn(|j| {
        std::array::from_fn(|d| {
            factor * (ordinates[j + 3][d] - ordinates[j][d] - 3.0 * (ordinates[j + 2][d] - ordinates[j + 1][d]))
        })
    });
    let mut hessian = Box::new([[0.0; W]; W]);
    let mut gradient = [0.0; W];
    let mut value = 0.0;
    for p in 0..3 {
        for q in 0..3 {
            let g = h * GRAM[p][q];
            for d in 0..D {
                value += 0.5 * g * now[p][d] * now[q][d];
                for j in 0..ORDER {
                    gradient[j * D + d] += g * third[p][j] * now[q][d];
                    for k in 0..ORDER {
                        hessian[j * D + d][k * D + d] += g * third[p][j] * third[q][k];
                    }
                }
            }
        }
    }
    Form { hessian, gradient, value }
}

/// Places on a span through which positions of axes are differentiated, evenly spread.
const NODES: usize = 9;
/// Gauss' places and weights on an interval of length 1.
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_87, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];

/// Where linear axes stand for a ball centre: `offset + Σ column[d] c[d]`, in that order of axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Linear {
    /// Positions by the coordinates of the centre.
    pub columns: [[f64; 3]; 3],
    /// Positions with the centre in the origin, mm.
    pub offset: [f64; 3],
}

/// Third derivatives by the share of an interval, at places of it, of the polynomial through values
/// at evenly spread nodes.
fn third_at(places: &[f64]) -> Vec<[f64; NODES]> {
    let node = |k: usize| k as f64 / (NODES - 1) as f64;
    let of = |t: &f64| {
        std::array::from_fn(|k| {
            // Lagrange's polynomial of node k about t: its coefficients by powers of u = x − t.
            let mut c = [0.0; 4];
            c[0] = 1.0;
            for j in (0..NODES).filter(|j| *j != k) {
                let scale = 1.0 / (node(k) - node(j));
                let root = node(j) - t;
                for p in (0..4).rev() {
                    let below = if p > 0 { c[p - 1] } else { 0.0 };
                    c[p] = scale * (below - root * c[p]);
                }
            }
            6.0 * c[3]
        })
    };
    places.iter().map(of).collect()
}

/// `½ Σ ∫ (weight q''')²` over span `i`, of three axes whose positions are linear in the centre,
/// given by the arc length.
pub(super) fn axes(
    breaks: &Breaks,
    i: usize,
    x: &[[f64; 3]],
    weight: [f64; 3],
    linear: impl Fn(f64) -> Linear,
) -> Form<18> {
    let [a, b] = breaks.span(i);
    let h = b - a;
    let at: [(Linear, [f64; ORDER]); NODES] = std::array::from_fn(|k| {
        let s = a + h * k as f64 / (NODES - 1) as f64;
        (linear(s), breaks.weights(i, s))
    });
    let places = GAUSS.map(|g| g[0]);
    let mut hessian = Box::new([[0.0; 18]; 18]);
    let mut gradient = [0.0; 18];
    let mut value = 0.0;
    for (third, [_, share]) in third_at(&places).iter().zip(GAUSS) {
        for axis in 0..3 {
            let mut g = [0.0; 18];
            let mut now = 0.0;
            for (d3, (l, w)) in third.iter().zip(&at) {
                let f = d3 * weight[axis] / (h * h * h);
                let mut position = l.offset[axis];
                for k in 0..ORDER {
                    for d in 0..3 {
                        g[3 * k + d] += f * w[k] * l.columns[d][axis];
                        position += w[k] * l.columns[d][axis] * x[k][d];
                    }
                }
                now += f * position;
            }
            let share = share * h;
            value += 0.5 * share * now * now;
            for p in 0..18 {
                gradient[p] += share * g[p] * now;
                for q in 0..18 {
                    hessian[p][q] += share * g[p] * g[q];
                }
            }
        }
    }
    Form { hessian, gradient, value }
}

impl Linear {
    /// Of a machine whose tool stands at an angle on the cone about the blade axis.
    pub fn of(machine: &Machine, theta_rad: f64, lean_rad: f64, gauge_length_mm: f64) -> Linear {
        let columns = machine.linear();
        let at = |centre: [f64; 3]| {
            let row = machine.inverse(&Point::from(centre), theta_rad, lean_rad, gauge_length_mm);
            columns.map(|k| row[k])
        };
        let offset = at([0.0; 3]);
        let column = |d: usize| {
            let mut unit = [0.0; 3];
            unit[d] = 1.0;
            let there = at(unit);
            std::array::from_fn(|k| there[k] - offset[k])
        };
        Linear { columns: std::array::from_fn(column), offset }
    }
}

/// What third derivatives of the linear axes are multiplied by: the least of their limits of jerk
/// over their own.
pub(super) fn weights(machine: &Machine) -> [f64; 3] {
    let jerk = machine.linear().map(|k| machine.axes()[k].limits.jerk);
    let least = jerk.into_iter().fold(f64::INFINITY, f64::min);
    jerk.map(|j| least / j)
}
