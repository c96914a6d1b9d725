//! Joints of polynomial lines: how far the ball's way and the turning of the tool jump in their
//! derivatives from one line to the next, computed from the text.
//!
//! Two lines may run through their polynomials at different speeds, so derivatives are those by arc
//! length of the ball centre `c`. With `v = |c'|`, `a = c'·c''/v` and
//! `b = (|c''|² + c'·c''')/v − a²/v`
//!
//! ```text
//! c_s = c'/v,     c_ss = (c'' − a c_s)/v²,     c_sss = (c''' − 3 a v c_ss − b c_s)/v³
//! ```
//!
//! and likewise of the rotary axes. Lines of degree 3 carry two derivatives: of these the third is
//! reported, not judged. What the rounding of words makes of them is allowed for: with
//! words rounded to `ε` and lines of length `h`, at most `r₀ = 15 ε/h`, `r₁ = 40 ε/h²` and
//! `r₂ = 90 ε/h³` of the words themselves. The speed `v` is off by as large a share: where `d₀`,
//! `d₁`, … are derivatives by the way, `d_k` is off by `Σ d_j r_(k−j)` more.

use crate::artifact::Axes;
use crate::artifact::program::Programmed;
use crate::geometry::Vector;
use crate::machine::Machine;
use crate::numerics::series::Series;
use crate::read::program::Moved;
use crate::tool::Tool;

/// Jumps may be this share of the greatest third derivative, times what makes lower ones of it: the
/// length of a line, and half its square.
const SHARE: f64 = 0.01;
/// Words are rounded to half of this, mm; angles to as many degrees.
const ROUNDED: f64 = 1e-8;
/// The same of positions of axes, which are control points of curves.
const POINTS_ROUNDED: f64 = 1e-4;
/// What `ε` of the words makes of the derivatives, over powers of the length: of each of two lines,
/// of three coordinates, and of the tip that turns about the ball.
const BY_ROUNDING: [f64; 3] = [15.0, 40.0, 90.0];
const WORDS: f64 = 4.0;

/// Derivatives by arc length at an end of a line: of the ball centre and of the rotary axis that
/// turns most.
#[derive(Clone, Copy, Debug)]
struct End {
    centre: [Vector; 3],
    turning: [f64; 3],
}

/// The joint that jumps most.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WorstJoint {
    /// Over what is allowed.
    pub value: f64,
    /// Line that ends there.
    pub line: usize,
    /// Greatest jumps of any joint: rad, 1/mm, 1/mm² of the ball centre.
    pub jumps: [f64; 3],
    /// Joints looked at.
    pub count: usize,
}

/// Over pairs of lines that follow one another on the curve.
pub(super) fn worst<'a>(
    joints: impl Iterator<Item = (&'a Moved, &'a Moved)> + Clone,
    tool: &Tool,
    machine: &Machine,
) -> WorstJoint {
    let ends = joints.map(|(a, b)| (a, b, end(a, 1.0, tool, machine), end(b, 0.0, tool, machine)));
    let all: Vec<_> = ends.filter_map(|(a, b, p, q)| Some((a, b, p?, q?))).collect();
    let most = all
        .iter()
        .flat_map(|(_, _, p, q)| [p, q])
        .fold([0.0f64; 2], |[c, t], e| [c.max(e.centre[2].norm()), t.max(e.turning[2].abs())]);
    let mut out = WorstJoint { count: all.len(), ..WorstJoint::default() };
    let is_cubic =
        |m: &Moved| m.bend.is_none_or(|b| b.iter().all(|[_, _, fourth, fifth]| *fourth == 0.0 && *fifth == 0.0));
    let judged = if all.iter().all(|(a, b, ..)| is_cubic(a) && is_cubic(b)) { 2 } else { 3 };
    for (a, b, p, q) in &all {
        let lengths = [a, b].map(|m| (m.pose(1.0, tool, machine).centre - m.pose(0.0, tool, machine).centre).norm());
        let h = lengths[0].min(lengths[1]).max(1e-9);
        // A third derivative that jumps by a share of the greatest over a line.
        let lower = [0.5 * h * h, h, 1.0];
        let rounded = if a.words == Programmed::Machine { POINTS_ROUNDED } else { ROUNDED };
        let by_words: [f64; 3] = std::array::from_fn(|k| WORDS * rounded * BY_ROUNDING[k] / h.powi(k as i32 + 1));
        for k in 0..3 {
            // The speed of the ball is off by a share: so are all derivatives by its way.
            let by_speed = |of: &dyn Fn(usize) -> f64| (0..=k).map(|j| of(j) * by_words[k - j]).sum::<f64>();
            let bent_by = by_speed(&|j| if j > 0 { p.centre[j].norm() } else { 0.0 });
            let rounding = by_words[k] + bent_by;
            let turned_by = by_words[k].to_radians() + by_speed(&|j| p.turning[j].abs());
            let jump = (p.centre[k] - q.centre[k]).norm();
            let turn = (p.turning[k] - q.turning[k]).abs();
            out.jumps[k] = out.jumps[k].max(jump);
            let over = jump / (SHARE * most[0] * lower[k] + rounding);
            let turned = turn / (SHARE * most[1] * lower[k] + turned_by);
            let value = if over.is_nan() || turned.is_nan() { f64::MAX } else { over.max(turned) };
            if value > out.value && k < judged {
                (out.value, out.line) = (value, a.line);
            }
        }
    }
    out
}

/// Derivatives at a share of a move: 0 or 1. `None` where the ball stands still there.
fn end(m: &Moved, share: f64, tool: &Tool, machine: &Machine) -> Option<End> {
    let words = series(m, share);
    let linear = machine.linear();
    let rotary: Vec<usize> = machine.rotary().collect();
    let at = m.at(share);
    let (centre, lift) = (linear.map(|k| words[k]), tool.corner_mm());
    let centre: [Vector; 3] = match m.words {
        Programmed::Centre => [1, 2, 3].map(|n| term(&centre, n)),
        Programmed::Tip => {
            let axis = derivatives(&words, &at, machine, |row| machine.axis_at(row))?;
            [1, 2, 3].map(|n| term(&centre, n) + axis[n - 1] * lift)
        }
        Programmed::Machine => {
            derivatives(&words, &at, machine, |row| machine.forward(row, tool.length_mm()).centre.coords)?
        }
    };
    let [d1, d2, d3] = centre;
    let v = d1.norm();
    if !(v > 1e-12) {
        return None;
    }
    let a = d1.dot(&d2) / v;
    let b = (d2.norm_squared() + d1.dot(&d3)) / v - a * a / v;
    let first = d1 / v;
    let second = (d2 - first * a) / (v * v);
    let third = (d3 - second * (3.0 * a * v) - first * b) / v.powi(3);
    let turned = |k: usize| {
        let [d1, d2, d3] = [1, 2, 3].map(|n| words[k].0[n] * [1.0, 2.0, 6.0][n - 1]);
        let first = d1 / v;
        let second = (d2 - first * a) / (v * v);
        [first, second, (d3 - second * (3.0 * a * v) - first * b) / v.powi(3)]
    };
    let all = rotary.iter().map(|k| turned(*k));
    let turning = all.fold([0.0f64; 3], |m, t: [f64; 3]| if t[2].abs() > m[2].abs() || m == [0.0; 3] { t } else { m });
    Some(End { centre: [first, second, third], turning })
}

/// A derivative of a vector of series at 0.
fn term(v: &[Series; 3], n: usize) -> Vector {
    Vector::new(v[0].0[n], v[1].0[n], v[2].0[n]) * [1.0, 1.0, 2.0, 6.0][n]
}

/// The words of a move as series about a share of it.
fn series(m: &Moved, share: f64) -> Vec<Series> {
    let of = |k: usize| {
        let bend = m.bend.as_ref().map_or([0.0; 4], |b| b[k]);
        let sum: f64 = bend.iter().sum();
        let mut c = [m.from[k], m.to[k] - m.from[k] - sum, bend[0], bend[1], bend[2], bend[3]];
        for from in 0..c.len() - 1 {
            for j in (from..c.len() - 1).rev() {
                c[j] += share * c[j + 1];
            }
        }
        Series(c)
    };
    (0..m.to.len()).map(of).collect()
}

/// Derivatives, first to third, of what the machine's forward kinematics make of axes that go by
/// these series: in differences of the sixth order, since nothing of the kinematics that programs
/// are made with is to be used.
fn derivatives(words: &[Series], at: &Axes, machine: &Machine, of: impl Fn(&Axes) -> Vector) -> Option<[Vector; 3]> {
    // Steps in which the rotary axes turn by some hundredths of a radian.
    let rotary = machine.rotary();
    let rate = rotary.clone().map(|k| words[k].0[1].abs()).fold(0.0, f64::max);
    let bend = rotary.map(|k| words[k].0[2].abs().sqrt()).fold(0.0, f64::max);
    let h = 0.02 / rate.max(bend).max(0.02);
    let place = |t: f64| {
        let mut row = *at;
        for (to, series) in row.iter_mut().zip(words) {
            *to = series.0.iter().rev().fold(0.0, |sum, c| sum * t + c);
        }
        of(&row)
    };
    let [a, b, c, d] = [1.0, 2.0, 3.0, 4.0].map(|k| (place(k * h), place(-k * h)));
    let o = place(0.0);
    let odd = |p: &(Vector, Vector)| p.0 - p.1;
    let even = |p: &(Vector, Vector)| p.0 + p.1 - o * 2.0;
    let first = (odd(&a) * 45.0 - odd(&b) * 9.0 + odd(&c)) / (60.0 * h);
    let second = (even(&a) * 270.0 - even(&b) * 27.0 + even(&c) * 2.0) / (180.0 * h * h);
    let third = (odd(&a) * -488.0 + odd(&b) * 338.0 - odd(&c) * 72.0 + odd(&d) * 7.0) / (240.0 * h.powi(3));
    [first, second, third].iter().all(|v| v.iter().all(|x| x.is_finite())).then_some([first, second, third])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Two parts of one polynomial, of different lengths, join without a jump; a changed
    /// coefficient makes one.
    #[test]
    fn parts_of_one_polynomial_join() {
        let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
        let axes = machine.axes().len();
        let [x, y, z] = machine.linear();
        let turning = machine.turning_axis();
        // Coefficients of t⁰ … t⁵ of each word over [0, 1].
        let mut c = vec![[0.0; 6]; axes];
        c[x] = [10.0, 0.02, 0.01, 0.0, 0.0, 0.0];
        c[y] = [25.0, 0.7, -0.02, 0.004, 0.001, 0.0];
        c[z] = [-3.0, 0.4, 0.05, -0.003, 0.0, 0.0005];
        c[turning] = [0.4, 0.05, 0.01, -0.002, 0.0003, 0.0];
        let part = |from: f64, to: f64, line: usize, more: f64| {
            let h = to - from;
            let of = |k: usize| {
                let mut d = c[k];
                for i in 0..5 {
                    for j in (i..5).rev() {
                        d[j] += from * d[j + 1];
                    }
                }
                (0..6).for_each(|j| d[j] *= h.powi(j as i32));
                if k == y {
                    d[3] += more;
                }
                d
            };
            let all: Vec<[f64; 6]> = (0..axes).map(of).collect();
            Moved {
                block: 0,
                line,
                words: Programmed::Tip,
                from: Axes::from_fn(axes, |k| all[k][0]),
                to: Axes::from_fn(axes, |k| all[k].iter().sum()),
                bend: Some(Axes::from_fn(axes, |k| [all[k][2], all[k][3], all[k][4], all[k][5]])),
                seconds: Some(0.1),
                words_from_line: crate::geometry::Rigid::identity(),
            }
        };
        let (a, b) = (part(0.0, 0.6, 1, 0.0), part(0.6, 1.0, 2, 0.0));
        let good = worst(std::iter::once((&a, &b)), &tool, &machine);
        assert!(good.value < 0.2 && good.count == 1, "{good:?}");
        assert!(good.jumps[0] < 1e-10 && good.jumps[1] < 1e-8 && good.jumps[2] < 1e-6, "{good:?}");
        let bad = worst(std::iter::once((&a, &part(0.6, 1.0, 2, 1e-5))), &tool, &machine);
        assert!(bad.value > 1.0 && bad.line == 1, "{bad:?}");
    }
}
