//! Greatest speed of the ball centre by what does not depend on the machine: feed, contact, chord
//! of the tool tip.

use super::FeedOptions;
use super::curve::choose;
use crate::artifact::toolpath::CutterLocation;
use crate::artifact::{Schedule, Toolpath};
use crate::geometry::{Point, Vector};

/// Slopes are taken over at least this many ball radii: contacts on facets jump.
const SPAN: f64 = 0.05;

/// Greatest speeds by what does not depend on the machine.
#[derive(Clone, Debug, Default)]
pub(super) struct Caps {
    /// Greatest ṡ² in each interval between locations, mm²/s².
    pub squares: Vec<f64>,
    /// An axis by its index, and its greatest velocity in each interval where that is less than its
    /// own limit, rad/s.
    pub turning: Option<(usize, Vec<f64>)>,
}

impl Caps {
    /// The velocity that an axis may have in an interval.
    pub fn velocity(&self, interval: usize, axis: usize, limit: f64) -> f64 {
        let own = self.turning.as_ref().filter(|(k, _)| *k == axis);
        own.and_then(|(_, of)| of.get(interval)).map_or(limit, |v| v.min(limit))
    }

    /// Greatest ṡ² in an interval.
    pub fn square(&self, interval: usize) -> f64 {
        self.squares.get(interval).copied().unwrap_or(f64::INFINITY)
    }
}

impl From<Vec<f64>> for Caps {
    fn from(squares: Vec<f64>) -> Self {
        Caps { squares, turning: None }
    }
}

/// The rates that a schedule lets the turning axis have, in each interval; `None` where it says
/// nothing.
pub(super) fn rates(path: &Toolpath, schedule: &Schedule) -> Option<Vec<f64>> {
    let of = |turn: u32| schedule.rates.get(turn as usize).copied().unwrap_or(f64::INFINITY);
    // Between turns the slower one counts.
    let between = |w: &[CutterLocation]| of(w[0].turn).min(of(w[1].turn));
    (!schedule.rates.is_empty()).then(|| path.locations.windows(2).map(between).collect())
}

/// No feed takes less along the path, whatever the schedule and the machine, s: every length at the
/// greatest speed that the programmed feed and the contact allow.
pub fn least_time(path: &Toolpath, options: &FeedOptions) -> f64 {
    let no_chord = FeedOptions { chord_mm: f64::INFINITY, ..*options };
    let still = vec![0.0; path.locations.len()];
    let caps = caps(path, &still, &no_chord);
    path.locations.windows(2).zip(caps).map(|(w, x)| (w[1].s_mm - w[0].s_mm) / x.sqrt()).sum()
}

/// Greatest ṡ² (mm²/s²) in each interval between locations.
pub(super) fn of_path(path: &Toolpath, schedule: &Schedule, options: &FeedOptions) -> Vec<f64> {
    caps(path, &schedule.theta, options)
}

fn caps(path: &Toolpath, theta: &[f64], options: &FeedOptions) -> Vec<f64> {
    let l = &path.locations;
    let n = l.len();
    let feed = options.settings.feed_mm_min / 60.0;
    let tips: Vec<Point> = path.stands(theta).map(|s| s.tip(path.radius_mm)).collect();
    let (mut a, mut b) = (0, 0);
    let mut at = Vec::with_capacity(n);
    for i in 0..n {
        let half = 0.5 * SPAN * path.radius_mm;
        while a + 1 < i && l[i].s_mm - l[a + 1].s_mm >= half {
            a += 1;
        }
        b = b.max((i + 1).min(n - 1));
        while b + 1 < n && l[b].s_mm - l[i].s_mm < half {
            b += 1;
        }
        let ds = l[b].s_mm - l[a].s_mm;
        let mut most = feed;
        if options.limit_contact && ds > 0.0 && l[a].touches() && l[b].touches() {
            let contact = options.contact_mm_s.map_or(feed, |own| own.min(feed));
            most = most.min(contact * ds / (l[b].contact - l[a].contact).norm().max(1e-3 * ds));
        }
        if a < i && i < b {
            let (p, q) = (tips[i] - tips[a], tips[b] - tips[i]);
            let per_s = (p.norm() + q.norm()) / ds;
            // Turning per length of the tip's path.
            let bend = curvature(&p, &q);
            most = most.min((8.0 * options.chord_mm / bend).sqrt() / (options.period_s * per_s));
        }
        at.push(if most.is_finite() { most * most } else { feed * feed });
    }
    at.windows(2).map(|w| w[0].min(w[1])).collect()
}

/// A straight line under `v²/q'²` over an interval, at most `most`, by its ends: where ṡ² is below
/// it, the axis' velocity is within `v`. `q1`: Bernstein coefficients of q'. The product of q'² and
/// the line has coefficients below v²; what they exceed it by is taken from the line, which is
/// little where q' changes little.
pub(super) fn of_velocity(q1: &[f64], v: f64, most: f64) -> [f64; 2] {
    let greatest = q1.iter().fold(0.0f64, |m, q| m.max(q.abs()));
    if greatest * greatest * most <= v * v {
        return [most; 2];
    }
    let level = (v / greatest).powi(2).min(most);
    let [Some(first), Some(last)] = [q1.first(), q1.last()] else { return [level; 2] };
    let ends = [first, last].map(|q| (v / q).powi(2).min(most));
    // Bernstein coefficients of the square.
    let (square, degree) = match *q1 {
        [a, b, c] => ([a * a, a * b, (2.0 * b * b + a * c) / 3.0, b * c, c * c, 0.0, 0.0, 0.0, 0.0], 4),
        _ => squared(q1),
    };
    let product = (0..=degree + 1).map(|k| {
        let share = k as f64 / (degree + 1) as f64;
        let before = if k > 0 { share * square[k - 1] * ends[1] } else { 0.0 };
        let after = if k <= degree { (1.0 - share) * square[k] * ends[0] } else { 0.0 };
        before + after
    });
    let over = product.fold(v * v, f64::max) / (v * v);
    let line = ends.map(|x| x / over);
    if line[0] + line[1] > 2.0 * level { line } else { [level; 2] }
}

/// Bernstein coefficients of the square of a polynomial of degree 4 or less, and its degree.
fn squared(q: &[f64]) -> ([f64; 9], usize) {
    let n = q.len().clamp(1, 5) - 1;
    let mut out = [0.0; 9];
    for i in 0..=n {
        for j in 0..=n {
            out[i + j] += choose(n, i) * choose(n, j) / choose(2 * n, i + j) * q[i] * q[j];
        }
    }
    (out, 2 * n)
}

/// Curvature of the circle through the ends of two steps, 1/mm; 0 where they do not make one.
fn curvature(p: &Vector, q: &Vector) -> f64 {
    let size = p.norm() * q.norm() * (p + q).norm();
    if size > 0.0 { 2.0 * p.cross(q).norm() / size } else { 0.0 }
}
