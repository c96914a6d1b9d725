//! The published way to smooth the axes of two tools along a row, to compare with: the tool posture
//! curve, and least squares where it leaves what is free (Song, Zhu, Xue, Feng and Lu, Materials
//! 17, 2024, 2977, equations 14 to 22).
//!
//! **In** an angle of the table for each place of a row, as a fixed angle to the first tool's
//! normal gives it. **Out** angles along the row.
//!
//! **Global smoothing** A cubic B-spline through the axes on the sphere, its parameter the angle
//! from axis to axis, its knots averaged. As printed the axes are then taken at the parameters that
//! they were interpolated at, which gives them back; here the curve is evaluated by the length of
//! the row, so its angle is spread evenly, and brought back to the sphere.
//!
//! **Local smoothing** Where the curve's angles are not free the sum of ω² is made least between
//! the places before and behind, ω being what the axis turns by over the contact's way. Leans are
//! held, so one angle turns both tools, and the paper's three cases (equations 20 to 22) are one.

use std::ops::Range;

use super::FreeAngles;
use super::turn::{Least, TurningRow, chain_of};
use crate::artifact::Cone;
use crate::geometry::Vector;
use crate::numerics::angle::nearest_turn;
use crate::numerics::banded::BandedMatrix;

/// Axes that are nearer than this to the one before are the same, rad.
const SAME_RAD: f64 = 1e-9;
/// Degree of the curve.
const DEGREE: usize = 3;

/// The angles of the posture curve through those of a row; `s_mm`: length of the row up to each
/// place.
pub fn posture(theta_rad: &[f64], s_mm: &[f64], cone: Cone) -> Vec<f64> {
    let mut axes: Vec<Vector> = Vec::new();
    let mut parameters: Vec<f64> = Vec::new();
    for axis in theta_rad.iter().map(|theta| cone.tool_axis(*theta)) {
        let turned = axes.last().map_or(0.0, |last| last.cross(&axis).norm().atan2(last.dot(&axis)));
        if axes.is_empty() || turned > SAME_RAD {
            parameters.push(parameters.last().copied().unwrap_or(0.0) + turned);
            axes.push(axis);
        }
    }
    let (Some(whole), Some(length_mm)) = (parameters.last().copied(), s_mm.last().copied()) else { return Vec::new() };
    if axes.len() <= DEGREE || !(length_mm > 0.0) {
        return theta_rad.to_vec();
    }
    parameters.iter_mut().for_each(|p| *p /= whole);
    let knots = averaged_knots(&parameters);
    let n = axes.len();
    let mut matrix = BandedMatrix::new(n, DEGREE, DEGREE);
    for (row, p) in parameters.iter().enumerate() {
        let (first, values) = basis(&knots, n, *p);
        values.iter().enumerate().for_each(|(k, v)| {
            matrix.add(row, first + k, *v);
        });
    }
    let mut controls: Vec<f64> = axes.iter().flat_map(|a| [a.x, a.y, a.z]).collect();
    let Some(factors) = matrix.factor() else { return theta_rad.to_vec() };
    factors.solve(&mut controls, 3);
    let mut last = theta_rad[0];
    let at = |s: &f64| {
        let (first, values) = basis(&knots, n, s / length_mm);
        let mut sum = Vector::zeros();
        for (k, v) in values.iter().enumerate() {
            let c = 3 * (first + k);
            sum += Vector::new(controls[c], controls[c + 1], controls[c + 2]) * *v;
        }
        last = cone.theta_of(&sum, 1e-9).map_or(last, |theta| nearest_turn(theta, last));
        last
    };
    s_mm.iter().map(at).collect()
}

/// Knots of a curve through points at these parameters: inner ones the mean of as many parameters
/// as the degree (equation 17 with its indices put right).
fn averaged_knots(parameters: &[f64]) -> Vec<f64> {
    let inner = parameters[1..parameters.len() - 1].windows(DEGREE).map(|w| w.iter().sum::<f64>() / DEGREE as f64);
    let inner: Vec<f64> = inner.collect();
    [vec![0.0; DEGREE + 1], inner, vec![1.0; DEGREE + 1]].concat()
}

/// The first of the basis functions that are not zero at a parameter, and their values (Cox, de
/// Boor).
fn basis(knots: &[f64], count: usize, at: f64) -> (usize, [f64; DEGREE + 1]) {
    let at = at.clamp(0.0, 1.0);
    let span = knots.partition_point(|k| *k <= at).clamp(DEGREE + 1, count) - 1;
    let mut values = [0.0; DEGREE + 1];
    values[0] = 1.0;
    for degree in 1..=DEGREE {
        let mut saved = 0.0;
        for k in 0..degree {
            let (right, left) = (knots[span + k + 1], knots[span + k + 1 - degree]);
            let share = if right > left { values[k] / (right - left) } else { 0.0 };
            values[k] = saved + (right - at) * share;
            saved = (at - left) * share;
        }
        values[degree] = saved;
    }
    (span - DEGREE, values)
}

impl TurningRow<'_> {
    /// The angles of a posture curve, where they are not free those with the least sum of ω²
    /// instead; `None`: there are none.
    pub fn local(&self, posture_rad: &[f64]) -> Option<Vec<f64>> {
        let mut theta = posture_rad.to_vec();
        let n = self.common.len();
        let mut from = 0;
        while let Some(first) = (from..n).find(|k| !self.is_free(&theta, *k)) {
            let mut bad = first..(first..n).find(|k| self.is_free(&theta, *k)).unwrap_or(n);
            // Wider where no angles lead from one end to the other.
            let (own, found) = loop {
                let own = bad.start.saturating_sub(1)..(bad.end + 1).min(n);
                match self.least_squares(&theta, &own, [own.start < bad.start, own.end > bad.end]) {
                    Some(found) => break (own, found),
                    None if own == (0..n) && bad == own => return None,
                    None => {
                        let more = bad.len();
                        bad = bad.start.saturating_sub(more)..(bad.end + more).min(n);
                    }
                }
            };
            let last = found[found.len() - 1];
            theta[own.clone()].copy_from_slice(&found);
            for k in own.end..n {
                theta[k] += nearest_turn(posture_rad[own.end - 1], last) - posture_rad[own.end - 1];
            }
            // Both ends may be free and the move between them not.
            from = bad.end.max(from + 1);
        }
        Some(theta)
    }

    /// Whether the angle at a place is free, and can be reached from the place before.
    fn is_free(&self, theta: &[f64], place: usize) -> bool {
        let is_near = |k: usize| {
            (theta[k + 1] - theta[k]).abs() <= self.most_rad[k] && {
                let [a, b] = [k, k + 1].map(|k| self.common[k].around(theta[k]));
                a[0].max(b[0]) <= a[1].min(b[1])
            }
        };
        self.common[place].has(theta[place]) && place.checked_sub(1).is_none_or(is_near)
    }

    /// The angles of places with the least sum of ω², the first and the last kept where asked for.
    fn least_squares(&self, theta: &[f64], places: &Range<usize>, keep: [bool; 2]) -> Option<Vec<f64>> {
        let mut common = self.common[places.clone()].to_vec();
        let ends = [(0, places.start), (common.len() - 1, places.end - 1)];
        for ((own, place), keep) in ends.into_iter().zip(keep) {
            if keep {
                common[own] = FreeAngles::of([[theta[place]; 2]]);
            }
        }
        let moves = places.start..places.end - 1;
        let (way_mm, most_rad) = (&self.way_mm[moves.clone()], &self.most_rad[moves]);
        let row = TurningRow { common: &common, way_mm, most_rad, ..*self };
        let layers = row.reached_to(&(0..common.len()), f64::INFINITY)?;
        let walls = chain_of(&layers, most_rad);
        // Angles that can just be reached may be lost to rounding on the way back.
        if walls.len() != common.len() {
            return None;
        }
        let found = row.least_of(Least::Slopes, &walls, most_rad, way_mm);
        let by = nearest_turn(found[0], theta[places.start]) - found[0];
        Some(found.into_iter().map(|v| v + by).collect())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    /// Angles that jump on half of the row are spread over all of it, and where they begin and end
    /// stays.
    #[test]
    fn the_curve_spreads_the_turning_over_the_row() {
        let cone = Cone::about_blade(0.2);
        let s: Vec<f64> = (0..=100).map(f64::from).collect();
        let theta: Vec<f64> =
            s.iter().map(|s| 7.0 + if *s < 50.0 { 0.001 * s } else { 0.05 + 0.02 * (s - 50.0) }).collect();
        let found = posture(&theta, &s, cone);
        let steepest = |all: &[f64]| all.windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max);
        assert!((found[0] - theta[0]).abs() < 1e-9 && (found[100] - theta[100]).abs() < 1e-9);
        let even = (theta[100] - theta[0]) / 100.0;
        assert!(steepest(&theta) > 1.9 * even && steepest(&found) < 1.02 * even, "{} {even}", steepest(&found));
        // Through the axes: at the printed parameters nothing changes.
        let one = |v: &[f64]| posture(v, &s[..v.len()], cone);
        assert_eq!(one(&[1.0, 1.0, 1.0, 1.0, 1.0]), [1.0; 5]);
        assert_eq!(one(&[1.0, 1.1]), [1.0, 1.1]);
        assert!(posture(&[], &[], cone).is_empty());
    }

    /// Between a wall that is in the way and what is free on both sides the slope is as even as
    /// the wall lets it be.
    #[test]
    fn where_the_curve_is_not_free_the_least_squares_are() {
        let n = 41;
        let posture = vec![0.0; n];
        // Amid the row what is free begins at 0.4.
        let common: Vec<FreeAngles> =
            (0..n).map(|k| FreeAngles::of([[if (15..=25).contains(&k) { 0.4 } else { -1.0 }, 2.0]])).collect();
        let row =
            TurningRow { common: &common, way_mm: &vec![1.0; n - 1], most_rad: &vec![0.05; n - 1], margin_rad: 0.0 };
        let found = row.local(&posture).unwrap();
        assert!((0..n).all(|k| common[k].margin(found[k]) > -1e-9));
        assert!((15..=25).all(|k| (found[k] - 0.4).abs() < 1e-4), "{found:?}");
        // No step may be greater than 0.05, so the way up takes eight moves at least; as many as
        // are taken are alike, and elsewhere the curve's angles stay.
        let steps: Vec<f64> = found.windows(2).map(|w| w[1] - w[0]).collect();
        let up: Vec<f64> = steps[..15].iter().copied().filter(|s| *s > 1e-4).collect();
        assert!((8..15).contains(&up.len()), "{up:?}");
        assert!(up.iter().all(|s| (s - 0.4 / up.len() as f64).abs() < 1e-4 && *s <= 0.05), "{up:?}");
        assert!(found[..15 - up.len()].iter().all(|v| *v == 0.0), "{found:?}");
        // Nothing is free at one place.
        let mut none = common.clone();
        none[20] = FreeAngles::default();
        assert!(TurningRow { common: &none, ..row }.local(&posture).is_none());
    }
}
