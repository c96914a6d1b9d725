#![allow(clippy::unwrap_used)]
use proptest::prelude::*;

use super::rows::{JerkRows, Shares};
use super::*;
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::observe::Silent;

fn limits() -> Limits {
    Limits::from([[500.0, 3000.0, 50000.0]; 5])
}

/// Three axes along a circle with noise.
fn curve(n: usize, noise: f64) -> AxisCurve {
    let s: Vec<f64> = (0..n).map(|i| 0.1 * i as f64).collect();
    let wild = |i: usize, k: f64| noise * (i as f64 * k).sin();
    let q: Vec<f64> = s
        .iter()
        .enumerate()
        .flat_map(|(i, s)| {
            let f = s / 20.0;
            [wild(i, 12.9898), 20.0 * f.cos() + wild(i, 78.233), 20.0 * f.sin() + wild(i, 37.719), 0.0, 0.0]
        })
        .collect();
    CubicSpline::new(&s, &q, 5, &SplineEnds::Natural).unwrap().into()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    #[test]
    fn no_multipliers_prove_more_than_the_time_of_a_motion(
        noise in 0.0..0.01f64, size in 1e-6..0.1f64, ties in -0.1..0.1f64, step in 1.0..9.0f64,
    ) {
        let (curve, feed) = (curve(120, noise), 30.0);
        let caps = vec![feed * feed; 119].into();
        let grid = cells::grid(&curve, &caps);
        let units = Units::of(&grid, feed, &limits());
        let mut room = cells::derivatives(&grid, limits().len());
        let cells = cells::cells(&curve, &grid, &caps, (&limits(), units), &mut room);
        let scaled = units.scaled(&limits());
        let ends = [&cells[0], &cells[cells.len() - 1]].map(|c| [c.h, c.end_from_rest(&scaled)]);
        let inner = &cells[1..cells.len() - 1];
        let problem = Problem { inner, ends, limits: &scaled };
        let start = start::profile(inner, ends, &scaled).unwrap();
        let found = search::fastest(&problem, &start, true, &Silent).unwrap();
        let (n, v) = (inner.len(), &found.v[..inner.len()]);
        let time = problem.time(0, v);
        prop_assert!(found.least <= 1.0 && found.least > 0.5, "{}", found.least);
        // Any multipliers at all.
        let rows = JerkRows::of(&problem, 0..n, v, Shares::ALL);
        let wild = |k: usize| (k as f64 * step).sin();
        let count = |i: usize| rows.linear(i).len() + rows.jerk(i).len();
        let dual = |i: usize| {
            let y: Vec<f64> = (0..count(i)).map(|k| size * wild(7 * i + k).max(0.0).powi(4)).collect();
            rows.dual(i, inner[i].h, &y)
        };
        let duals: Vec<_> = (0..n).map(dual).collect();
        let r: Vec<f64> = (0..n).map(|j| ties * wild(3 * j)).collect();
        prop_assert!(bound::least_time(&problem, 0..n, &duals, &r, 4) <= time * (1.0 + 1e-9));
        // The whole is at least the sum of its parts.
        let parts: f64 = [0..50, 50..n].map(|p| bound::least_time(&problem, p.clone(), &duals[p.clone()], &r[p], 4)).iter().sum();
        prop_assert!(parts <= time * (1.0 + 1e-9));
    }
}
