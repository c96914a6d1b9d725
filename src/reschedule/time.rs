//! Time of a stretch on a machine, as its lines ask for it.

use crate::artifact::toolpath::{CutterLocation, PathKind, Turn};
use crate::artifact::{AxisMotion, Cones, Schedule, Stand, Toolpath};
use crate::error::{EndReason, Result};
use crate::feed::{self, FeedOptions};
use crate::geometry::{Point, Vector};
use crate::machine::Machine;
use crate::numerics::banded::BandedMatrix;
use crate::observe::Silent;
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

/// Places of the tool with the speeds of the ball between them, mm/s.
pub(super) struct Way<'a> {
    pub stands: Vec<Stand>,
    pub speeds_mm_s: &'a [f64],
}

/// The fastest motion along a way within the machine's limits, from rest to rest.
///
/// # Errors
/// Those of [`feed::plan_at`].
pub(super) fn motion(way: &Way, tool: &Tool, machine: &Machine, chord_mm: f64, limit_jerk: bool) -> Result<AxisMotion> {
    let (path, schedule) = evened(way, tool.radius_mm, chord_mm);
    let options = FeedOptions { chord_mm, limit_jerk, ..FeedOptions::new(1.0, tool.length_mm()) };
    feed::plan_at(&path, &schedule, way.speeds_mm_s, machine, &options, &Silent)
}

/// The way without the rounding of its words.
fn evened(way: &Way, radius_mm: f64, chord_mm: f64) -> (Toolpath, Schedule) {
    let stands = &way.stands;
    let mut s = vec![0.0; stands.len()];
    for (k, w) in stands.windows(2).enumerate() {
        s[k + 1] = s[k] + (w[1].centre - w[0].centre).norm();
    }
    let column = |of: &dyn Fn(&Stand) -> f64, within| even(&s, stands.iter().map(of).collect(), within);
    let [x, y, z] = [0, 1, 2].map(|i| column(&|p: &Stand| p.centre[i], EVEN_MM));
    let theta = column(&|p: &Stand| p.theta, EVEN_RAD);
    let location = |k: usize| {
        let centre = Point::new(x[k], y[k], z[k]);
        CutterLocation { turn: 0, turn_s_mm: s[k], s_mm: s[k], centre, contact: centre, normal: Vector::x() }
    };
    let locations: Vec<CutterLocation> = (0..stands.len()).map(location).collect();
    let length_mm = s.last().copied().unwrap_or(0.0);
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
        cones: Cones::along(stands.iter().map(|p| p.cone).collect()),
        turns: vec![Turn { first: 0, count: locations.len(), length_mm }],
        locations,
    };
    (path, Schedule::of_angles(theta))
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
}
