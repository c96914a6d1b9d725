//! Near time-optimal speed under velocity, acceleration and jerk of all axes at once (equations on the stage's page).
//!
//! Over every interval `w = u'` is constant, so `u` is linear and `x` quadratic in `s`, and acceleration is continuous. In an
//! interval the axes' accelerations and the brackets of their jerks
//!
//! ```text
//! a = q' u + q'' x        j = √x (q' w + 3 q'' u + q''' x)
//! ```
//!
//! are cubic and quadratic; their Bernstein coefficients, linear in `(x, u, w)` at the interval's start, bound them over the whole of
//! it. Limits of jerk, `|bracket| ≤ J / √x`, are not convex: `1/√x` is convex in `x`, so its tangent lies below it, and with
//! the tangent in its place the limit is convex and a little too strict. The tangent is taken anew at every iterate
//! of the interior-point method ([`crate::numerics::stages`]), so at the end nothing is lost by it (sequential convexification as
//! in "TOPP3", with the sequence folded into the iterations). The time `∫ ds/√x` is convex.
//!
//! From rest, the first interval of the grid is passed with constant jerk and then as much of the opposite jerk up to constant
//! speed, likewise the last.

use crate::numerics::spline::CubicSpline;
use crate::numerics::stages::{self, Model, Options, Row, Stage};

/// Axes that take part.
const AXES: usize = 5;
/// Least speed squared, as a share of the feed's square.
const FLOOR: f64 = 1e-10;
/// Intervals of the grid at least.
const LEAST_INTERVALS: usize = 24;

/// Greater barriers that are tried where the solver loses its way.
const RETRIES: [f64; 3] = [1.0, 1e2, 1e4];

/// Limits of all axes: velocity, acceleration, jerk.
pub(super) type Limits = [[f64; 3]; AXES];

/// Speed along the path on a grid of its own.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Smooth {
    /// Arc lengths, mm; the path's locations are among them.
    pub s: Vec<f64>,
    /// ṡ², mm²/s², at the grid.
    pub x: Vec<f64>,
    /// s̈, mm/s².
    pub u: Vec<f64>,
    /// Time from the start, s.
    pub t: Vec<f64>,
    /// du/ds after each point of the grid but the last; of the first and last interval, where jerk along the path is constant
    /// instead: that jerk.
    pub w: Vec<f64>,
    /// Iterations of the solver.
    pub iterations: usize,
}

/// Bernstein coefficients of `q'` (3), `q''` (2) and `q'''` over one interval, for every axis; by scaled arc length.
#[derive(Clone, Debug)]
struct Piece {
    h: f64,
    q1: [[f64; 3]; AXES],
    q2: [[f64; 2]; AXES],
    q3: [f64; AXES],
    cap: f64,
}

/// Units: speed² by `speed`², arc length by `length`.
#[derive(Clone, Copy, Debug)]
struct Units {
    speed: f64,
    length: f64,
}

/// See the module's page. `cap`: greatest ṡ² in each interval of the curve. `None` where the solver finds no way.
pub(super) fn fastest(curve: &CubicSpline, limits: &Limits, feed: f64, cap: &[f64]) -> Option<Smooth> {
    let grid = grid(curve.abscissae());
    let tangential = limits.iter().map(|l| l[1]).fold(f64::INFINITY, f64::min);
    let mean = (grid.last()?.0 - grid.first()?.0) / grid.len() as f64;
    let units = Units { speed: feed, length: (feed * feed / tangential).clamp(0.2 * mean, 50.0 * mean) };
    let pieces: Vec<Piece> = grid.windows(2).map(|w| piece(curve, w, cap, limits, units)).collect();
    let scaled: Limits = limits.map(|[v, a, j]| {
        let rate = units.speed / units.length;
        [v / rate, a / rate.powi(2), j / rate.powi(3)]
    });
    let (first, last) = (pieces.first()?, pieces.last()?);
    let (mut up, mut down) = (ramp(first, &scaled, false), ramp(last, &scaled, true));
    let inner = pieces.get(1..pieces.len() - 1)?;
    // A constant speed that keeps all limits.
    let steady = inner.iter().map(|p| steady(p, &scaled)).fold(1.0, f64::min) * 0.5;
    let mut found = inner_profile(inner, &scaled, [up.end(), down.end()], steady, 1.0);
    for barrier in RETRIES {
        if found.is_none() {
            // From a start that keeps all limits, ends included, and from farther inside.
            let x = steady.min(up.end()).min(down.end());
            (up, down) = (Ramp::to(first.h, x), Ramp::to(last.h, x));
            found = inner_profile(inner, &scaled, [x, x], x, barrier);
        }
    }
    let found = found?;
    let mut out = assemble(&grid, inner, &found, up, down, units);
    slow_down(&mut out, &pieces, &scaled, units);
    Some(out)
}

/// The points of the curve with so many between that the first and last interval are short: (arc length, interval of
/// the curve).
fn grid(s: &[f64]) -> Vec<(f64, usize)> {
    let n = s.len() - 1;
    let parts = LEAST_INTERVALS.div_ceil(n);
    let mut out = Vec::with_capacity(n * parts + 9);
    for i in 0..n {
        let k = if i == 0 || i + 1 == n { parts.max(4) } else { parts };
        out.extend((0..k).map(|j| (s[i] + (s[i + 1] - s[i]) * j as f64 / k as f64, i)));
    }
    out.push((s[n], n - 1));
    out
}

fn piece(curve: &CubicSpline, w: &[(f64, usize)], cap: &[f64], limits: &Limits, units: Units) -> Piece {
    let (from, i) = w[0];
    let (start, l) = (curve.abscissae()[i], units.length);
    let (a, h) = (from - start, w[1].0 - from);
    let mut out = Piece {
        h: h / l,
        q1: [[0.0; 3]; AXES],
        q2: [[0.0; 2]; AXES],
        q3: [0.0; AXES],
        cap: cap.get(i).copied().unwrap_or(f64::INFINITY).min(units.speed * units.speed),
    };
    for k in 0..AXES {
        let [_, b, c, d] = curve.coefficients(i, k).unwrap_or_default();
        let first = |t: f64| b + t * (2.0 * c + 3.0 * t * d);
        let second = |t: f64| 2.0 * c + 6.0 * t * d;
        let (p, q) = (first(a), first(a + h));
        out.q1[k] = [p, p + 0.5 * h * second(a), q].map(|v| v * l);
        out.q2[k] = [second(a), second(a + h)].map(|v| v * l * l);
        out.q3[k] = 6.0 * d * l * l * l;
        let most = out.q1[k].iter().fold(0.0f64, |m, v| m.max(v.abs())) / l;
        out.cap = out.cap.min((limits[k][0] / most).powi(2));
    }
    out.cap /= units.speed * units.speed;
    out
}

/// From rest to constant speed: jerk `jerk` along the path for as long as `-jerk` after it.
#[derive(Clone, Copy, Debug)]
struct Ramp {
    jerk: f64,
    /// Time of each half.
    half: f64,
}

impl Ramp {
    /// The ramp of a jerk over a length: `length = jerk half³`.
    fn over(length: f64, jerk: f64) -> Ramp {
        Ramp { jerk, half: (length / jerk).cbrt() }
    }

    /// The ramp over a length to a speed squared.
    fn to(length: f64, x: f64) -> Ramp {
        Ramp::over(length, x.powf(1.5) / (length * length))
    }

    /// Length, speed, acceleration and jerk at a time.
    fn at(self, t: f64) -> [f64; 4] {
        let (j, h) = (self.jerk, self.half);
        if t <= h {
            return [j * t * t * t / 6.0, 0.5 * j * t * t, j * t, j];
        }
        let r = 2.0 * h - t;
        let length = j * h * h * h;
        [length - j * h * h * r + j * r * r * r / 6.0, j * h * h - 0.5 * j * r * r, j * r, -j]
    }

    /// Speed² at its end.
    fn end(self) -> f64 {
        (self.jerk * self.half * self.half).powi(2)
    }
}

/// The fastest ramp over an interval that keeps all limits, looked at in places along it.
fn ramp(p: &Piece, limits: &Limits, backwards: bool) -> Ramp {
    let mut jerk = f64::INFINITY;
    for k in 0..AXES {
        let most = p.q1[k].iter().fold(0.0f64, |m, v| m.max(v.abs()));
        jerk = jerk.min(limits[k][2] / most);
    }
    let mut out = Ramp::over(p.h, 0.95 * jerk.min(1e12));
    for _ in 0..400 {
        let fits = (0..=32).all(|i| {
            let [s, v, u, j] = out.at(out.half * f64::from(i) / 16.0);
            let f = if backwards { 1.0 - s / p.h } else { s / p.h };
            // Seen from its own end, odd derivatives of a ramp that is run backwards change sign together.
            let sign = if backwards { -1.0 } else { 1.0 };
            v * v <= 0.8 * p.cap
                && (0..AXES).all(|k| {
                    let g = 1.0 - f;
                    let q1 = sign * (g * g * p.q1[k][0] + 2.0 * f * g * p.q1[k][1] + f * f * p.q1[k][2]);
                    let (q2, q3) = (g * p.q2[k][0] + f * p.q2[k][1], sign * p.q3[k]);
                    let a = q1 * u + q2 * v * v;
                    let jerk = q3 * v * v * v + 3.0 * q2 * v * u + q1 * j;
                    a.abs() <= 0.95 * limits[k][1] && jerk.abs() <= limits[k][2]
                })
        });
        if fits {
            break;
        }
        out = Ramp::over(p.h, 0.8 * out.jerk);
    }
    out
}

/// What the solver's stages are made from.
struct Profile<'a> {
    pieces: &'a [Piece],
    limits: &'a Limits,
    /// Axes of each piece that have rows of acceleration and jerk.
    active: Vec<[bool; AXES]>,
    /// Brackets of the jerks of active axes over their limits, and where those of each piece begin.
    brackets: Vec<[[f64; 3]; 3]>,
    first: Vec<usize>,
    whole: f64,
}

/// `(x, u, w)` → Bernstein coefficients of x over an interval.
fn of_x(h: f64) -> [[f64; 3]; 3] {
    [[1.0, 0.0, 0.0], [1.0, h, 0.0], [1.0, 2.0 * h, h * h]]
}

fn combine(terms: &[(f64, [f64; 3])]) -> [f64; 3] {
    let mut out = [0.0; 3];
    for (f, g) in terms {
        for k in 0..3 {
            out[k] += f * g[k];
        }
    }
    out
}

/// Bernstein coefficients of the acceleration but the last, which is the next interval's first.
fn of_acceleration(p: &Piece, k: usize) -> [[f64; 3]; 3] {
    let x = of_x(p.h);
    let u = [[0.0, 1.0, 0.0], [0.0, 1.0, p.h]];
    let (q, r) = (p.q1[k], p.q2[k]);
    [
        combine(&[(q[0], u[0]), (r[0], x[0])]),
        combine(&[(q[0] / 3.0, u[1]), (q[1] / 1.5, u[0]), (r[1] / 3.0, x[0]), (r[0] / 1.5, x[1])]),
        combine(&[(q[2] / 3.0, u[0]), (q[1] / 1.5, u[1]), (r[0] / 3.0, x[2]), (r[1] / 1.5, x[1])]),
    ]
}

/// Bernstein coefficients of the bracket of the jerk.
fn of_bracket(p: &Piece, k: usize) -> [[f64; 3]; 3] {
    let x = of_x(p.h);
    let (u, w) = ([[0.0, 1.0, 0.0], [0.0, 1.0, p.h]], [0.0, 0.0, 1.0]);
    let (q, r, t) = (p.q1[k], p.q2[k], p.q3[k]);
    [
        combine(&[(q[0], w), (3.0 * r[0], u[0]), (t, x[0])]),
        combine(&[(q[1], w), (1.5 * r[0], u[1]), (1.5 * r[1], u[0]), (t, x[1])]),
        combine(&[(q[2], w), (3.0 * r[1], u[1]), (t, x[2])]),
    ]
}

impl Profile<'_> {
    /// Rows that do not change, then those of jerk (filled in by `refresh`).
    fn stage(&self, i: usize) -> Stage<2, 3> {
        let mut out = Stage::<2, 3>::default();
        let Some(p) = self.pieces.get(i) else {
            out.rows.push(Row { g: [-1.0, 0.0, 0.0], most: -FLOOR });
            return out;
        };
        let h = p.h;
        out.dynamics = [[1.0, 2.0 * h, h * h], [0.0, 1.0, h]];
        let x = of_x(h);
        out.rows.extend(x.iter().take(2).map(|g| Row { g: g.map(|v| -v), most: -FLOOR }));
        out.rows.extend(x.iter().map(|g| Row { g: g.map(|v| v / p.cap), most: 1.0 }));
        for k in 0..AXES {
            if !self.active[i][k] {
                continue;
            }
            for g in of_acceleration(p, k) {
                let g = g.map(|v| v / self.limits[k][1]);
                out.rows.push(Row { g, most: 1.0 });
                out.rows.push(Row { g: g.map(|v| -v), most: 1.0 });
            }
        }
        let jerks = 6 * self.active[i].iter().filter(|a| **a).count();
        out.rows.extend(std::iter::repeat_n(Row { g: [0.0; 3], most: 1.0 }, jerks));
        out
    }
}

impl Model<2, 3> for Profile<'_> {
    fn refresh(&self, i: usize, v: &[f64; 3], stage: &mut Stage<2, 3>) {
        let before = i.checked_sub(1).and_then(|j| self.pieces.get(j)).map_or(0.0, |p| p.h);
        let here = self.pieces.get(i);
        // The time: weight / √x, to second order.
        let weight = 0.5 * (before + here.map_or(0.0, |p| p.h)) / self.whole;
        let x = v[0].max(FLOOR);
        let (first, second) = (-0.5 * weight * x.powf(-1.5), 0.75 * weight * x.powf(-2.5));
        stage.hessian[0][0] = second;
        stage.gradient[0] = first - second * v[0];
        let Some(p) = here else { return };
        let bernstein = of_x(p.h);
        let at = bernstein.map(|g| (g[0] * v[0] + g[1] * v[1] + g[2] * v[2]).max(FLOOR));
        let mut row = stage.rows.len() - 6 * self.active[i].iter().filter(|a| **a).count();
        let root = at.map(f64::sqrt);
        let count = self.active[i].iter().filter(|a| **a).count();
        for bracket in self.brackets.iter().skip(self.first[i]).take(count) {
            for b in 0..3 {
                let (g, x) = (&bracket[b], &bernstein[b]);
                for sign in [root[b], -root[b]] {
                    let row_g = std::array::from_fn(|c| sign * g[c] + 0.5 / at[b] * x[c]);
                    if let Some(r) = stage.rows.get_mut(row) {
                        *r = Row { g: row_g, most: 1.5 };
                    }
                    row += 1;
                }
            }
        }
    }
}

/// Axes whose limits of acceleration or jerk may be reached in a piece. Where the limits of one axis bound `|u|` and `√x |w|`
/// so much that another cannot reach its own, the other is left out.
fn decisive(p: &Piece, limits: &Limits) -> [bool; AXES] {
    let least = |q: &[f64; 3]| {
        let one_sign = q.iter().all(|v| *v > 0.0) || q.iter().all(|v| *v < 0.0);
        if one_sign { q.iter().fold(f64::INFINITY, |m, v| m.min(v.abs())) } else { 0.0 }
    };
    let most = |q: &[f64]| q.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let speed = p.cap.sqrt();
    let (mut u, mut w) = (f64::INFINITY, f64::INFINITY);
    for k in 0..AXES {
        u = u.min((limits[k][1] + most(&p.q2[k]) * p.cap) / least(&p.q1[k]));
    }
    let rest = |k: usize| 3.0 * most(&p.q2[k]) * u * speed + p.q3[k].abs() * p.cap * speed;
    for k in 0..AXES {
        w = w.min((limits[k][2] + rest(k)) / least(&p.q1[k]));
    }
    std::array::from_fn(|k| {
        let q = most(&p.q1[k]);
        if q == 0.0 && p.q2[k] == [0.0; 2] {
            return false;
        }
        let (a, j) = (q * u + most(&p.q2[k]) * p.cap, q * w + rest(k));
        !(a < limits[k][1] && j < limits[k][2])
    })
}

/// The fastest profile between given speeds² at constant speed on either side.
fn inner_profile(
    pieces: &[Piece],
    limits: &Limits,
    ends: [f64; 2],
    start: f64,
    barrier: f64,
) -> Option<(Vec<[f64; 3]>, usize)> {
    let whole = pieces.iter().map(|p| p.h).sum();
    let active: Vec<[bool; AXES]> = pieces.iter().map(|p| decisive(p, limits)).collect();
    let brackets = pieces
        .iter()
        .zip(&active)
        .flat_map(|(p, a)| (0..AXES).filter(|k| a[*k]).map(|k| of_bracket(p, k).map(|g| g.map(|v| v / limits[k][2]))))
        .collect();
    let mut first = Vec::with_capacity(pieces.len());
    let mut sum = 0;
    for a in &active {
        first.push(sum);
        sum += a.iter().filter(|b| **b).count();
    }
    let model = Profile { pieces, limits, active, brackets, first, whole };
    let n = pieces.len();
    let mut stages: Vec<Stage<2, 3>> = (0..=n).map(|i| model.stage(i)).collect();
    for (i, x) in [(0, ends[0]), (n, ends[1])] {
        for (k, value) in [(0, x), (1, 0.0)] {
            let mut g = [0.0; 3];
            g[k] = 1.0;
            // In front: rows of jerk come last.
            stages[i].rows.insert(0, Row { g, most: value });
            stages[i].rows.insert(0, Row { g: g.map(|v: f64| -v), most: -value });
        }
    }
    let count: usize = stages.iter().map(|s| s.rows.len()).sum();
    let options = Options {
        tolerance: 5e-5 / count as f64,
        excess: 2e-4,
        slack: 0.05,
        barrier: barrier / count as f64,
        iterations: 120,
        ..Options::default()
    };
    let found = stages::solve(&mut stages, &vec![[start, 0.0, 0.0]; n + 1], &model, &options)?;
    (found.excess < 1e-3 && found.complementarity * (count as f64) < 1e-3).then_some((found.v, found.iterations))
}

/// Greatest constant speed squared over a piece.
fn steady(p: &Piece, limits: &Limits) -> f64 {
    let mut most = p.cap;
    for k in 0..AXES {
        let bend = p.q2[k][0].abs().max(p.q2[k][1].abs());
        most = most.min(limits[k][1] / bend).min((limits[k][2] / p.q3[k].abs()).powf(2.0 / 3.0));
    }
    most.max(2.0 * FLOOR)
}

fn assemble(
    grid: &[(f64, usize)],
    inner: &[Piece],
    found: &(Vec<[f64; 3]>, usize),
    up: Ramp,
    down: Ramp,
    units: Units,
) -> Smooth {
    let (rate, l) = (units.speed / units.length, units.length);
    let acceleration = units.speed * rate;
    let s: Vec<f64> = grid.iter().map(|g| g.0).collect();
    let mut out = Smooth { s: s.clone(), x: vec![0.0], u: vec![0.0], t: vec![0.0], w: vec![], iterations: found.1 };
    out.w.push(up.jerk * rate * acceleration);
    let mut t = 2.0 * up.half;
    for (i, v) in found.0.iter().enumerate() {
        out.x.push(v[0].max(FLOOR) * units.speed * units.speed);
        out.u.push(v[1] * acceleration);
        out.t.push(t / rate);
        if let Some(p) = inner.get(i) {
            out.w.push(v[2] * acceleration / l);
            t += duration(v, p.h);
        }
    }
    out.w.push(down.jerk * rate * acceleration);
    t += 2.0 * down.half;
    out.x.push(0.0);
    out.u.push(0.0);
    out.t.push(t / rate);
    out
}

/// `∫ ds / √(x + 2 u s + w s²)` over `h`: Gauss–Legendre, 8 points.
fn duration(v: &[f64; 3], h: f64) -> f64 {
    const NODES: [[f64; 2]; 4] = [
        [0.1834346424956498, 0.362_683_783_378_362],
        [0.525_532_409_916_329, 0.3137066458778873],
        [0.7966664774136267, 0.2223810344533745],
        [0.9602898564975363, 0.1012285362903763],
    ];
    let mut sum = 0.0;
    for [at, weight] in NODES {
        for sign in [1.0, -1.0] {
            let s = 0.5 * h * (1.0 + sign * at);
            sum += weight / (v[0] + s * (2.0 * v[1] + s * v[2])).max(FLOOR).sqrt();
        }
    }
    0.5 * h * sum
}

/// What is left of the solver's tolerance is taken out by running the whole that much slower.
fn slow_down(out: &mut Smooth, pieces: &[Piece], limits: &Limits, units: Units) {
    let (rate, l) = (units.speed / units.length, units.length);
    let acceleration = units.speed * rate;
    let mut slower = 1.0f64;
    for (i, p) in pieces.iter().enumerate().take(pieces.len() - 1).skip(1) {
        let v = [out.x[i] / units.speed.powi(2), out.u[i] / acceleration, out.w[i] * l / acceleration];
        let dot = |g: [f64; 3]| g[0] * v[0] + g[1] * v[1] + g[2] * v[2];
        let xs = of_x(p.h).map(dot);
        let top = xs.iter().fold(0.0f64, |m, x| m.max(*x));
        slower = slower.max((top / p.cap).sqrt());
        for k in 0..AXES {
            for g in of_acceleration(p, k) {
                slower = slower.max((dot(g).abs() / limits[k][1]).sqrt());
            }
            let bracket = of_bracket(p, k).map(dot);
            for f in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let (a, b, c) = ((1.0 - f) * (1.0 - f), 2.0 * f * (1.0 - f), f * f);
                let x: f64 = (a * xs[0] + b * xs[1] + c * xs[2]).max(0.0);
                let j = (a * bracket[0] + b * bracket[1] + c * bracket[2]) * x.sqrt();
                slower = slower.max((j.abs() / limits[k][2]).cbrt());
            }
        }
    }
    if slower > 1.0 {
        let (r, last) = (1.0 / slower, out.w.len() - 1);
        out.x.iter_mut().for_each(|x| *x *= r * r);
        out.u.iter_mut().for_each(|u| *u *= r * r);
        out.t.iter_mut().for_each(|t| *t *= slower);
        for (i, w) in out.w.iter_mut().enumerate() {
            *w *= if i == 0 || i == last { r * r * r } else { r * r };
        }
    }
}
