//! Time of a stretch on a machine, as its lines ask for it.

use crate::artifact::toolpath::{CutterLocation, PathKind, Turn};
use crate::artifact::{AxisMotion, Cone, Cones, Schedule, Toolpath};
use crate::error::{EndReason, Result};
use crate::feed::{self, FeedOptions};
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::numerics::banded::BandedMatrix;
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Silent;
use crate::parallel;
use crate::tool::Tool;

/// Words are rounded: ball centres and θ are evened by at most this, as controls even them too, mm
/// and rad.
const EVEN_MM: f64 = 0.001;
const EVEN_RAD: f64 = 0.001 * std::f64::consts::PI / 180.0;
/// Weight of third differences at first, the share that is left of it in each round about values
/// that are too far off, and so many values to either side of them.
const WEIGHT: f64 = 1e6;
const FALLS: f64 = 0.1;
const AROUND: usize = 12;
/// Rounds until the values stay as they are.
const ROUNDS: usize = 14;
/// Lines are joined to at least this time, s: what controls look at a motion in. And only so that
/// the joined way is off by less than this share of what is evened, at speeds that differ by less
/// than this. Along more than [`MANY`] lines that time grows by the same factor, up to twice.
const LEAST_S: f64 = 0.008;
const MANY: usize = 100_000;
const JOINED: f64 = 0.2;
const SAME_SPEED: f64 = 0.02;

/// The way of a ball centre without the rounding of its words.
pub(super) struct Centres {
    s_mm: Vec<f64>,
    points: Vec<Point>,
}

/// Where the tool axis points along it, and the speeds of the ball between places, mm/s.
pub(super) struct TimedWay<'a> {
    pub theta: Vec<f64>,
    pub cones: Vec<Cone>,
    pub speeds_mm_s: &'a [f64],
}

impl Centres {
    pub fn of(centres: &[Point]) -> Self {
        let mut s_mm = vec![0.0; centres.len()];
        for (k, w) in centres.windows(2).enumerate() {
            s_mm[k + 1] = s_mm[k] + (w[1] - w[0]).norm();
        }
        let columns = parallel::map(0..3, |i| even(&s_mm, centres.iter().map(|p| p[i]).collect(), EVEN_MM));
        let point = |k: usize| Point::from(Vector::from_fn(|i, _| columns[i][k]));
        let points = (0..centres.len()).map(point).collect();
        Centres { s_mm, points }
    }
}

/// The fastest motion along a way within the machine's limits, from rest to rest.
///
/// # Errors
/// Those of [`feed::plan_at`].
pub(super) fn motion(
    centres: &Centres,
    way: &TimedWay,
    (tool, machine): (&Tool, &Machine),
    chord_mm: f64,
    limit_jerk: bool,
) -> Result<AxisMotion> {
    let even = |values: Vec<f64>| even(&centres.s_mm, values, EVEN_RAD);
    let leans: Vec<f64> = way.cones.iter().map(|c| c.lean_rad).collect();
    let is_same = leans.windows(2).all(|w| w[0] == w[1]);
    let (theta, leans) = (even(way.theta.clone()), if is_same { leans } else { even(leans) });
    let rows = Unrounded { centres, theta, leans };
    let kept = kept(&rows, way.speeds_mm_s);
    let speeds = speeds(&centres.s_mm, way.speeds_mm_s, &kept);
    let (path, schedule) = taken(&rows, &way.cones, &kept, (tool.radius_mm, chord_mm));
    let options = FeedOptions { chord_mm, limit_jerk, bounded: false, ..FeedOptions::new(1.0, tool.length_mm()) };
    feed::plan_at(&path, &schedule, &speeds, machine, &options, &Silent)
}

/// A way without the rounding of its words.
struct Unrounded<'a> {
    centres: &'a Centres,
    theta: Vec<f64>,
    leans: Vec<f64>,
}

impl Unrounded<'_> {
    /// Coordinates of the ball centre, mm, θ and lean, rad.
    fn at(&self, k: usize) -> [f64; 5] {
        let p = self.centres.points[k];
        [p.x, p.y, p.z, self.theta[k], self.leans[k]]
    }
}

/// The way at the places that are kept.
fn taken(rows: &Unrounded, cones: &[Cone], kept: &[usize], (radius_mm, chord_mm): (f64, f64)) -> (Toolpath, Schedule) {
    let centres = rows.centres;
    let location = |k: &usize| {
        let (s_mm, centre) = (centres.s_mm[*k], centres.points[*k]);
        CutterLocation { turn: 0, turn_s_mm: s_mm, s_mm, centre, contact: centre, normal: Vector::x() }
    };
    let locations: Vec<CutterLocation> = kept.iter().map(location).collect();
    let length_mm = centres.s_mm.last().copied().unwrap_or(0.0);
    let path = Toolpath {
        kind: PathKind::Given,
        radius_mm,
        disc_radius_mm: 0.0,
        stock_mm: 0.0,
        scallop_mm: 0.0,
        chord_mm,
        region_x_mm: [0.0; 2],
        end_reason: EndReason::Region,
        planned_scallop_mm: 0.0,
        cones: Cones::along(kept.iter().map(|k| Cone { lean_rad: rows.leans[*k], ..cones[*k] }).collect()),
        axis_turning: None,
        turns: vec![Turn { first: 0, count: locations.len(), length_mm }],
        locations,
    };
    (path, Schedule::of_angles(kept.iter().map(|k| rows.theta[*k]).collect()))
}

/// Places between which the motion is planned, by index: lines that take less than [`LEAST_S`] are
/// joined where a cubic spline leaves none of their places by more than a share of what these were
/// evened by. Where it does, the place in the middle is kept, too.
fn kept(rows: &Unrounded, speeds_mm_s: &[f64]) -> Vec<usize> {
    let s = &rows.centres.s_mm;
    let within = [EVEN_MM, EVEN_MM, EVEN_MM, EVEN_RAD, EVEN_RAD].map(|v| JOINED * v);
    let mut out = by_time(s, speeds_mm_s);
    for _ in 0..ROUNDS {
        let at: Vec<f64> = out.iter().map(|k| s[*k]).collect();
        let values: Vec<f64> = out.iter().flat_map(|k| rows.at(*k)).collect();
        let Ok(spline) = CubicSpline::new(&at, &values, within.len(), &SplineEnds::Natural) else { break };
        let is_off = |k: usize| {
            let here = rows.at(k);
            (0..within.len()).any(|f| !((spline.value(s[k], f) - here[f]).abs() <= within[f]))
        };
        let more: Vec<usize> = parallel::filter_map(out.windows(2).collect::<Vec<_>>(), |w| {
            (w[0] + 1..w[1]).any(is_off).then_some((w[0] + w[1]) / 2)
        });
        if more.is_empty() {
            return out;
        }
        out.extend(more);
        out.sort_unstable();
    }
    (0..s.len()).collect()
}

/// The first place, the last, and of those between enough that the way from one to the next takes
/// [`LEAST_S`] or more, or is one line, at speeds that hardly differ.
fn by_time(s: &[f64], speeds_mm_s: &[f64]) -> Vec<usize> {
    let n = s.len();
    let least_s = LEAST_S * (n as f64 / MANY as f64).clamp(1.0, 2.0);
    let mut out = vec![0];
    let (mut seconds, mut least, mut most) = (0.0, f64::INFINITY, 0.0f64);
    for (k, v) in speeds_mm_s.iter().enumerate().take(n.saturating_sub(1)) {
        let own = (s[k + 1] - s[k]) / v;
        let differs = most.max(*v) > (1.0 + SAME_SPEED) * least.min(*v);
        if out.last() != Some(&k) && (seconds + own > least_s || differs) {
            out.push(k);
            (seconds, least, most) = (0.0, f64::INFINITY, 0.0);
        }
        (seconds, least, most) = (seconds + own, least.min(*v), most.max(*v));
    }
    if n > 1 {
        out.push(n - 1);
    }
    out
}

/// Speeds between the places that are kept, with which the way takes the time that its lines take.
fn speeds(s: &[f64], speeds_mm_s: &[f64], kept: &[usize]) -> Vec<f64> {
    let speed = |w: &[usize]| {
        let seconds: f64 = (w[0]..w[1]).map(|k| (s[k + 1] - s[k]) / speeds_mm_s[k]).sum();
        if w[1] == w[0] + 1 { speeds_mm_s[w[0]] } else { (s[w[1]] - s[w[0]]) / seconds }
    };
    kept.windows(2).map(speed).collect()
}

/// Values over `s` that differ from the given ones by at most `within`, with third differences as
/// small as that allows (Whittaker 1923). Their weight is the same everywhere at first; where a
/// value is too far off, it falls about it.
fn even(s: &[f64], values: Vec<f64>, within: f64) -> Vec<f64> {
    let n = values.len();
    if n < 8 {
        return values;
    }
    let rows: Vec<[f64; 4]> = s.windows(4).map(third_difference).collect();
    let mut weights = vec![WEIGHT; rows.len()];
    for _ in 0..ROUNDS {
        let mut matrix = BandedMatrix::new(n, 3, 3);
        (0..n).for_each(|i| {
            matrix.add(i, i, 1.0);
        });
        for (k, (row, weight)) in rows.iter().zip(&weights).enumerate() {
            for (i, a) in row.iter().enumerate() {
                row.iter().enumerate().for_each(|(j, b)| {
                    matrix.add(k + i, k + j, weight * a * b);
                });
            }
        }
        let mut out = values.clone();
        let Some(factored) = matrix.factor() else { return values };
        factored.solve(&mut out, 1);
        let far: Vec<usize> = (0..n).filter(|i| !((out[*i] - values[*i]).abs() <= within)).collect();
        if far.is_empty() {
            return out;
        }
        let mut from = 0;
        for i in far {
            let until = (i + AROUND).min(weights.len());
            let about = i.saturating_sub(AROUND).max(from);
            weights.iter_mut().take(until).skip(about).for_each(|w| *w *= FALLS);
            from = from.max(until);
        }
    }
    values
}

/// Factors of the third difference of four values over `s`: 1, −3, 3, −1 where these are even.
fn third_difference(s: &[f64]) -> [f64; 4] {
    let mean = ((s[3] - s[0]) / 3.0).max(1e-12);
    std::array::from_fn(|i| {
        let product: f64 = (0..4).filter(|j| *j != i).map(|j| (s[i] - s[j]) / mean).product();
        let size = if product.abs() < 1e-9 { 1e-9f64.copysign(product) } else { product };
        6.0 / size
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn rounding_is_evened_and_corners_stay() {
        let s: Vec<f64> = (0..200).map(|k| 0.1 * f64::from(k) + 0.02 * f64::from(k % 3)).collect();
        let true_values: Vec<f64> = s.iter().map(|s| (0.3 * s).sin()).collect();
        let rounded: Vec<f64> = true_values.iter().map(|v| (v * 1000.0).round() / 1000.0).collect();
        let smooth = even(&s, rounded.clone(), 0.001);
        let off = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off(&smooth, &rounded) <= 0.001);
        // It is no rougher than what was rounded, which rounding makes much rougher.
        let rough = |v: &[f64]| -> f64 {
            let third = |k: usize| third_difference(&s[k..k + 4]).iter().zip(&v[k..]).map(|(a, b)| a * b).sum::<f64>();
            (0..v.len() - 3).map(|k| third(k).powi(2)).sum()
        };
        let [smooth, rounded, true_values] = [&smooth, &rounded, &true_values].map(|v| rough(v));
        assert!(smooth < 4.0 * true_values && rounded > 100.0 * true_values, "{smooth} {rounded} {true_values}");
        // A corner of a tenth is no rounding.
        let corner: Vec<f64> = s.iter().map(|s| (s - 10.0).abs()).collect();
        assert!(off(&even(&s, corner.clone(), 0.001), &corner) <= 0.001);
        let cubic: Vec<f64> = s.iter().map(|s| s * s).collect();
        assert!(s.windows(4).all(|w| {
            let k = s.iter().position(|v| *v == w[0]).unwrap_or(0);
            third_difference(w).iter().zip(&cubic[k..]).map(|(a, b)| a * b).sum::<f64>().abs() < 1e-6
        }));
    }

    /// Places on a screw of 11 mm about x, and the speeds between them.
    fn screw(count: usize, step_mm: f64) -> (Centres, Vec<f64>) {
        let point = |k: usize| {
            let phi = k as f64 * step_mm / 11.0;
            Point::new(0.3 * phi, 11.0 * phi.cos(), 11.0 * phi.sin())
        };
        let points: Vec<Point> = (0..count).map(point).collect();
        (Centres::of(&points), vec![66.7; count - 1])
    }

    #[test]
    fn short_lines_are_joined_where_a_curve_meets_their_places() {
        let (centres, mut speeds_mm_s) = screw(4000, 0.1);
        let n = centres.points.len();
        let theta: Vec<f64> = centres.s_mm.iter().map(|s| s / 11.0).collect();
        let rows = Unrounded { centres: &centres, theta, leans: vec![0.1; n] };
        let all = kept(&rows, &speeds_mm_s);
        assert!(all.len() < n / 3 && all.first() == Some(&0) && all.last() == Some(&(n - 1)), "{}", all.len());
        let at: Vec<f64> = all.iter().map(|k| centres.s_mm[*k]).collect();
        let values: Vec<f64> = all.iter().map(|k| centres.points[*k].z).collect();
        let spline = CubicSpline::new(&at, &values, 1, &SplineEnds::Natural).unwrap();
        let off = |k: usize| (spline.value(centres.s_mm[k], 0) - centres.points[k].z).abs();
        assert!((0..n).all(|k| off(k) <= JOINED * EVEN_MM));
        // The time that the lines take stays, also where their speeds differ.
        speeds_mm_s.iter_mut().skip(1000).for_each(|v| *v = 30.0);
        let all = kept(&rows, &speeds_mm_s);
        let joined = speeds(&centres.s_mm, &speeds_mm_s, &all);
        assert_eq!(joined.len() + 1, all.len());
        assert!(all.contains(&1000));
        let lines: f64 = centres.s_mm.windows(2).zip(&speeds_mm_s).map(|(w, v)| (w[1] - w[0]) / v).sum();
        let way = |w: &[usize]| centres.s_mm[w[1]] - centres.s_mm[w[0]];
        let time: f64 = all.windows(2).zip(&joined).map(|(w, v)| way(w) / v).sum();
        assert!((time / lines - 1.0).abs() < 1e-12);
        // Lines that take longer stay.
        let (centres, speeds_mm_s) = screw(200, 0.6);
        let theta = vec![0.0; 200];
        let rows = Unrounded { centres: &centres, theta, leans: vec![0.1; 200] };
        assert_eq!(kept(&rows, &speeds_mm_s).len(), 200);
    }

    #[test]
    fn many_short_lines_take_the_time_of_a_straight_move_within_jerk() {
        let (tool, machine) = (crate::sample::tool(), Machine::demo().unwrap());
        let limits = machine.axes()[0].limits;
        let (v, a, j) = (0.1 * limits.velocity, limits.acceleration, limits.jerk);
        // From rest to rest, with or without a length at the greatest acceleration.
        let to_speed = if v * j < a * a { 2.0 * (v / j).sqrt() } else { v / a + a / j };
        let points: Vec<Point> = (0..4000).map(|k| Point::new(0.05 * f64::from(k), 0.0, 0.0)).collect();
        let length = 0.05 * 3999.0;
        let centres = Centres::of(&points);
        let speeds = vec![v; 3999];
        let way = TimedWay { theta: vec![0.0; 4000], cones: vec![Cone::about_blade(0.1); 4000], speeds_mm_s: &speeds };
        let motion = motion(&centres, &way, (&tool, &machine), 0.001, true).unwrap();
        let time = length / v + to_speed;
        assert!((motion.time_s / time - 1.0).abs() < 5e-3, "{} {time}", motion.time_s);
        assert!(motion.t_s.len() < 3000);
    }
}
