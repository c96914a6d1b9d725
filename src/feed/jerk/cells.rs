//! The path cut into cells: Bernstein forms of what is limited, in units in which numbers are of
//! size 1.

use crate::artifact::Axes;
use crate::feed::PER_THREAD;
use crate::feed::caps::{Caps, of_velocity};
use crate::feed::curve::{AxisCurve, bernstein, choose};
use crate::parallel;

/// Cells at least.
const LEAST_CELLS: usize = 24;
/// Parts of the outer intervals, from the end inwards: from rest ṡ² rises with the 4/3rd power of
/// the arc length, which parabolas follow over cells that are short beside their distance from the
/// end.
const OUTER_PARTS: [usize; 5] = [8, 4, 3, 2, 2];
/// The end cell takes this share of the outermost interval's parts.
const END_SHARE: f64 = 0.5;

/// Over a cell the slope of an axis whose velocity is to stay may change by this share, and its
/// coefficient between by this one from the mean; and parts of an interval for that at most.
const CHANGE: f64 = 0.03;
const BULGE: f64 = 4e-4;
const MOST_BY_RATE: f64 = 16.0;

/// Limits of all axes: velocity, acceleration, jerk.
pub(in crate::feed) type Limits = Axes<[f64; 3]>;

/// Bernstein coefficients of `q'`, `q''` and `q'''` of one axis over one cell, by scaled arc
/// length. Those of degree 5 lie apart: most axes are cubics, and reading them takes the time.
#[derive(Clone, Debug)]
pub(super) enum Derivatives {
    Cubic { q1: [f64; 3], q2: [f64; 2], q3: [f64; 1] },
    Quintic(Box<QuinticDerivatives>),
}

/// The same of degree 5.
#[derive(Clone, Debug)]
pub(super) struct QuinticDerivatives {
    pub q1: [f64; 5],
    pub q2: [f64; 4],
    pub q3: [f64; 3],
}

impl Default for Derivatives {
    fn default() -> Self {
        Derivatives::Cubic { q1: [0.0; 3], q2: [0.0; 2], q3: [0.0] }
    }
}

impl Derivatives {
    /// Bernstein coefficients of `q'`.
    pub fn first(&self) -> &[f64] {
        match self {
            Derivatives::Cubic { q1, .. } => q1,
            Derivatives::Quintic(own) => &own.q1,
        }
    }

    /// Those of `q''`.
    pub fn second(&self) -> &[f64] {
        match self {
            Derivatives::Cubic { q2, .. } => q2,
            Derivatives::Quintic(own) => &own.q2,
        }
    }

    /// Those of `q'''`.
    pub fn third(&self) -> &[f64] {
        match self {
            Derivatives::Cubic { q3, .. } => q3,
            Derivatives::Quintic(own) => &own.q3,
        }
    }
}

/// Rows in `(x, u, w)`, one for each Bernstein coefficient of something.
#[derive(Clone, Copy, Debug)]
pub(super) struct Forms {
    of: [[f64; 3]; 5],
    count: usize,
}

impl Forms {
    fn three(of: [[f64; 3]; 3]) -> Self {
        let [a, b, c] = of;
        Forms { of: [a, b, c, [0.0; 3], [0.0; 3]], count: 3 }
    }
}

impl std::ops::Deref for Forms {
    type Target = [[f64; 3]];
    fn deref(&self) -> &[[f64; 3]] {
        &self.of[..self.count]
    }
}

/// What `x` is taken at: its three Bernstein coefficients, then those between that it has as a
/// polynomial of degree 4, each as shares of the three.
pub(super) const SHARES_OF_X: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.5, 0.5, 0.0],
    [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0],
    [0.0, 0.5, 0.5],
];

/// The places in [`SHARES_OF_X`] of the coefficients of a bracket, by their number.
pub(super) fn places_of_x(count: usize) -> &'static [usize] {
    if count == 3 { &[0, 1, 2] } else { &[0, 3, 4, 5, 2] }
}

/// `x` at a place of [`SHARES_OF_X`], from its three coefficients.
pub(super) fn mixed(x: &[f64; 3], place: usize) -> f64 {
    if place < 3 { x[place] } else { dot(&SHARES_OF_X[place], x) }
}

/// One cell, in scaled arc length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell<'a> {
    /// Length.
    pub h: f64,
    /// Of every axis.
    pub axes: &'a [Derivatives],
    /// Greatest ṡ² by feed, contact, chord and the axes' velocities, at both ends; straight
    /// between.
    pub cap: [f64; 2],
}

/// Units: speed² by `speed`², arc length by `length`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    pub speed: f64,
    pub length: f64,
}

impl Units {
    pub fn of(grid: &[(f64, usize)], feed: f64, limits: &Limits) -> Units {
        let tangential = limits.iter().map(|l| l[1]).fold(f64::INFINITY, f64::min);
        let whole = grid.last().map_or(1.0, |g| g.0) - grid.first().map_or(0.0, |g| g.0);
        let mean = whole / grid.len() as f64;
        Units { speed: feed, length: (feed * feed / tangential).clamp(0.2 * mean, 50.0 * mean) }
    }

    /// 1/s.
    pub fn rate(self) -> f64 {
        self.speed / self.length
    }

    /// mm/s².
    pub fn acceleration(self) -> f64 {
        self.speed * self.rate()
    }

    pub fn scaled(self, limits: &Limits) -> Limits {
        let rate = self.rate();
        limits.map(|[v, a, j]| [v / rate, a / rate.powi(2), j / rate.powi(3)])
    }
}

/// Parts of an interval of the curve, so that the velocity that an axis is to keep is lost by
/// little: the caps are straight lines of ṡ² over a part, below what Bernstein coefficients of its
/// slope allow, which bulge beyond the slope itself.
fn parts_by_rate(curve: &AxisCurve, caps: &Caps, i: usize) -> usize {
    let Some((axis, _)) = &caps.turning else { return 1 };
    let h = curve.abscissae()[i + 1] - curve.abscissae()[i];
    let ([_, here, bend], [_, there, _]) = (curve.at(i, *axis, 0.0), curve.at(i, *axis, h));
    let middle = here + 0.5 * h * bend;
    let size = greatest(&[here, middle, there]).max(f64::MIN_POSITIVE);
    let (change, bulge) = ((there - here).abs() / size, (middle - 0.5 * (here + there)).abs() / size);
    (change / CHANGE).max((bulge / BULGE).sqrt()).ceil().clamp(1.0, MOST_BY_RATE) as usize
}

/// The joints of the curve with so many between that cells are short where speed changes fast: (arc
/// length, interval of the curve).
pub(super) fn grid(curve: &AxisCurve, caps: &Caps) -> Vec<(f64, usize)> {
    let s = curve.abscissae();
    let n = s.len() - 1;
    let least = LEAST_CELLS.div_ceil(n);
    let mut out = Vec::with_capacity(n * least + 40);
    for i in 0..n {
        let outer = OUTER_PARTS.get(i.min(n - 1 - i)).copied().unwrap_or(1);
        let parts = least.max(outer).max(parts_by_rate(curve, caps, i));
        let kept = |f: f64| (i > 0 || f == 0.0 || f >= END_SHARE) && (i + 1 < n || f <= 1.0 - END_SHARE);
        let shares = (0..parts).map(|j| j as f64 / parts as f64).filter(|f| kept(*f));
        out.extend(shares.map(|f| (s[i] + (s[i + 1] - s[i]) * f, i)));
    }
    out.push((s[n], n - 1));
    out
}

/// The derivatives of all axes, cell by cell: room for those of [`cells`].
pub(super) fn derivatives(grid: &[(f64, usize)], axes: usize) -> Vec<Derivatives> {
    vec![Derivatives::default(); grid.len().saturating_sub(1) * axes]
}

/// The cells between the points of the grid. `room`: [`derivatives`].
pub(super) fn cells<'a>(
    curve: &AxisCurve,
    grid: &[(f64, usize)],
    cap: &Caps,
    (limits, units): (&Limits, Units),
    room: &'a mut [Derivatives],
) -> Vec<Cell<'a>> {
    let cells = room.chunks_mut(limits.len().max(1)).zip(grid.windows(2));
    parallel::map_short(PER_THREAD, cells, |(axes, w)| cell(curve, w, cap, (limits, units), axes))
}

fn cell<'a>(
    curve: &AxisCurve,
    w: &[(f64, usize)],
    caps: &Caps,
    (limits, units): (&Limits, Units),
    axes: &'a mut [Derivatives],
) -> Cell<'a> {
    let (from, i) = w[0];
    let (start, l) = (curve.abscissae()[i], units.length);
    let (a, h) = (from - start, w[1].0 - from);
    let own = caps.square(i).min(units.speed * units.speed);
    let mut cap = [own; 2];
    for (k, axis) in axes.iter_mut().enumerate() {
        if let Some(quintic) = curve.quintic(i, k) {
            let (q1, q2, q3) = bernstein(quintic, a, h);
            let line = of_velocity(&q1, caps.velocity(i, k, limits[k][0]), own);
            cap = [cap[0].min(line[0]), cap[1].min(line[1])];
            *axis = Derivatives::Quintic(Box::new(QuinticDerivatives {
                q1: q1.map(|v| v * l),
                q2: q2.map(|v| v * l * l),
                q3: q3.map(|v| v * l * l * l),
            }));
            continue;
        }
        let [_, b, c, d] = curve.cubic(i, k);
        let first = |t: f64| b + t * (2.0 * c + 3.0 * t * d);
        let second = |t: f64| 2.0 * c + 6.0 * t * d;
        let q1 = [first(a), first(a) + 0.5 * h * second(a), first(a + h)];
        *axis = Derivatives::Cubic {
            q1: q1.map(|v| v * l),
            q2: [second(a), second(a + h)].map(|v| v * l * l),
            q3: [6.0 * d * l * l * l],
        };
        let line = of_velocity(&q1, caps.velocity(i, k, limits[k][0]), own);
        cap = [cap[0].min(line[0]), cap[1].min(line[1])];
    }
    Cell { h: h / l, axes, cap: cap.map(|c| c / (units.speed * units.speed)) }
}

pub(super) fn greatest(q: &[f64]) -> f64 {
    q.iter().fold(0.0f64, |m, v| m.max(v.abs()))
}

#[inline]
pub(super) fn dot(g: &[f64; 3], v: &[f64; 3]) -> f64 {
    g[0] * v[0] + g[1] * v[1] + g[2] * v[2]
}

/// Bernstein polynomials of degree 2 at a share of a cell.
#[inline]
fn quadratic(f: f64) -> [f64; 3] {
    [(1.0 - f) * (1.0 - f), 2.0 * f * (1.0 - f), f * f]
}

/// `(x, u, w)` → Bernstein coefficients of x over a cell.
pub(super) fn of_x(h: f64) -> [[f64; 3]; 3] {
    [[1.0, 0.0, 0.0], [1.0, h, 0.0], [1.0, 2.0 * h, h * h]]
}

#[inline]
fn combine(terms: &[(f64, [f64; 3])]) -> [f64; 3] {
    let mut out = [0.0; 3];
    for (f, g) in terms {
        for k in 0..3 {
            out[k] += f * g[k];
        }
    }
    out
}

/// The first five Bernstein coefficients of a sum of products, each of which is of that degree: of
/// numbers and rows by their own coefficients.
fn product<const N: usize>(degree: usize, factors: [(&[f64], &[[f64; 3]]); N]) -> Forms {
    let mut of = [[0.0; 3]; 5];
    for (numbers, rows) in factors {
        let (m, n) = (numbers.len() - 1, rows.len() - 1);
        for (i, q) in numbers.iter().enumerate() {
            for (j, row) in rows.iter().enumerate().filter(|(j, _)| i + j < 5) {
                let factor = q * choose(m, i) * choose(n, j) / choose(degree, i + j);
                (0..3).for_each(|c| of[i + j][c] += factor * row[c]);
            }
        }
    }
    Forms { of, count: 5 }
}

/// With brackets of jerk within `J/√x` at the Bernstein coefficients of x, jerk is within J times
/// this over the whole cell: the mean of `1/√x` is greater than that of the mean, the more so the
/// more x changes.
#[inline]
pub(super) fn jensen(x: [f64; 3]) -> f64 {
    let (low, high) = (x[0].min(x[1]).min(x[2]), x[0].max(x[1]).max(x[2]));
    let inverse = x.map(|x| 1.0 / x.sqrt());
    let at = |f: f64| {
        let b = quadratic(f);
        dot(&b, &inverse) * dot(&b, &x).sqrt()
    };
    if high < 2.0 * low {
        // What is greater between these places is greater by less than a tenth.
        return 1.0 + 1.1 * (at(0.25).max(at(0.5)).max(at(0.75)) - 1.0);
    }
    (1..8).map(|k| at(0.125 * f64::from(k))).fold(1.0, f64::max)
}

impl Cell<'_> {
    /// Bernstein coefficients of the acceleration of one of the axes but the last, which is the
    /// next cell's first.
    #[inline]
    pub fn acceleration(&self, axis: &Derivatives) -> Forms {
        match axis {
            Derivatives::Cubic { q1, q2, .. } => Forms::three(self.acceleration_of_cubic(q1, q2)),
            Derivatives::Quintic(own) => {
                product(5, [(&own.q1[..], &self.of_u()[..]), (&own.q2[..], &of_x(self.h)[..])])
            }
        }
    }

    #[inline]
    fn acceleration_of_cubic(&self, q: &[f64; 3], r: &[f64; 2]) -> [[f64; 3]; 3] {
        let (x, u) = (of_x(self.h), self.of_u());
        [
            combine(&[(q[0], u[0]), (r[0], x[0])]),
            combine(&[(q[0] / 3.0, u[1]), (q[1] / 1.5, u[0]), (r[1] / 3.0, x[0]), (r[0] / 1.5, x[1])]),
            combine(&[(q[2] / 3.0, u[0]), (q[1] / 1.5, u[1]), (r[0] / 3.0, x[2]), (r[1] / 1.5, x[1])]),
        ]
    }

    /// Bernstein coefficients of the bracket of the jerk of one of the axes.
    #[inline]
    pub fn bracket(&self, axis: &Derivatives) -> Forms {
        match axis {
            Derivatives::Cubic { q1, q2, q3 } => Forms::three(self.bracket_of_cubic(q1, q2, q3[0])),
            Derivatives::Quintic(own) => {
                let (x, u, w) = (of_x(self.h), self.of_u(), [[0.0, 0.0, 1.0]]);
                let triple = own.q2.map(|r| 3.0 * r);
                product(4, [(&own.q1[..], &w[..]), (&triple[..], &u[..]), (&own.q3[..], &x[..])])
            }
        }
    }

    #[inline]
    fn bracket_of_cubic(&self, q: &[f64; 3], r: &[f64; 2], t: f64) -> [[f64; 3]; 3] {
        let (x, u, w) = (of_x(self.h), self.of_u(), [0.0, 0.0, 1.0]);
        [
            combine(&[(q[0], w), (3.0 * r[0], u[0]), (t, x[0])]),
            combine(&[(q[1], w), (1.5 * r[0], u[1]), (1.5 * r[1], u[0]), (t, x[1])]),
            combine(&[(q[2], w), (3.0 * r[1], u[1]), (t, x[2])]),
        ]
    }

    /// `(x, u, w)` → Bernstein coefficients of u.
    fn of_u(&self) -> [[f64; 3]; 2] {
        [[0.0, 1.0, 0.0], [0.0, 1.0, self.h]]
    }

    /// Bernstein coefficients of `cap`.
    pub fn caps(&self) -> [f64; 3] {
        [self.cap[0], 0.5 * (self.cap[0] + self.cap[1]), self.cap[1]]
    }

    /// Greatest constant speed squared over the cell.
    pub fn steady(&self, limits: &Limits) -> f64 {
        let mut most = self.cap[0].min(self.cap[1]);
        for (axis, [_, a_max, j_max]) in self.axes.iter().zip(limits.iter()) {
            most = most.min(a_max / greatest(axis.second()));
            most = most.min((j_max / greatest(axis.third())).powf(2.0 / 3.0));
        }
        most
    }

    /// By how much ṡ² is too great: with a `κ`th of it (and of u and w) every limit is kept over
    /// the whole cell.
    pub fn excess(&self, v: &[f64; 3], limits: &Limits) -> f64 {
        let xs = of_x(self.h).map(|g| dot(&g, v));
        // Squares of jerks, which grow with the cube of ṡ².
        let mut jerk = 0.0f64;
        let mut most = xs.iter().zip(self.caps()).fold(0.0f64, |m, (x, cap)| m.max(x.abs() / cap));
        for (axis, [_, a_max, j_max]) in self.axes.iter().zip(limits.iter()) {
            let [acceleration, squared] = match axis {
                Derivatives::Cubic { q1, q2, q3 } => self.cubic((q1, q2, q3[0]), v, &xs),
                Derivatives::Quintic(_) => self.quintic(axis, v, &xs),
            };
            most = most.max(acceleration / a_max);
            jerk = jerk.max(squared / (j_max * j_max));
        }
        most.max(jerk.cbrt())
    }

    /// Greatest acceleration and square of the jerk of an axis of degree 3 at places of the cell.
    #[inline]
    fn cubic(&self, (q1, q2, q3): (&[f64; 3], &[f64; 2], f64), v: &[f64; 3], xs: &[f64; 3]) -> [f64; 2] {
        let most = self.acceleration_of_cubic(q1, q2).iter().fold(0.0f64, |m, g| m.max(dot(g, v).abs()));
        let bracket = self.bracket_of_cubic(q1, q2, q3).map(|g| dot(&g, v));
        let squared = |f: f64| {
            let shares = quadratic(f);
            let (x, j) = (dot(&shares, xs).max(0.0), dot(&shares, &bracket));
            j * j * x
        };
        [most, [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().fold(0.0f64, |m, f| m.max(squared(f)))]
    }

    /// The same of degree 5.
    fn quintic(&self, axis: &Derivatives, v: &[f64; 3], xs: &[f64; 3]) -> [f64; 2] {
        let most = self.acceleration(axis).iter().fold(0.0f64, |m, g| m.max(dot(g, v).abs()));
        let bracket = self.bracket(axis).of.map(|g| dot(&g, v));
        let squared = |f: f64| {
            let share = |i: usize| choose(4, i) * f.powi(i as i32) * (1.0 - f).powi(4 - i as i32);
            let j: f64 = bracket.iter().enumerate().map(|(i, q)| share(i) * q).sum();
            j * j * dot(&quadratic(f), xs).max(0.0)
        };
        [most, (0..=8).fold(0.0f64, |m, k| m.max(squared(0.125 * f64::from(k))))]
    }

    /// From rest over the whole cell with constant jerk: the greatest ṡ² at its end within all
    /// limits. Speed, acceleration and jerk of an axis are greatest at the end or bounded by what
    /// they would be there with the greatest derivatives of the cell.
    pub fn end_from_rest(&self, limits: &Limits) -> f64 {
        let h = self.h;
        let mut u = self.cap[0].min(self.cap[1]) / (1.5 * h);
        for (axis, [_, a_max, j_max]) in self.axes.iter().zip(limits.iter()) {
            let (q1, q2, q3) = (greatest(axis.first()), greatest(axis.second()), greatest(axis.third()));
            u = u.min(a_max / (q1 + 1.5 * h * q2));
            let jerk = q1 / (6.0 * h).sqrt() + 3.0 * q2 * (1.5 * h).sqrt() + q3 * (1.5 * h).powf(1.5);
            u = u.min((j_max / jerk).powf(2.0 / 3.0));
        }
        1.5 * h * u
    }
}
