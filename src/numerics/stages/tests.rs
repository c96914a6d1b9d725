#![allow(clippy::unwrap_used)]
use super::*;

/// A double integrator over `n` steps of length 1/n: state (place, speed), control speed change per
/// unit.
fn integrator(n: usize) -> Vec<Stage<2, 3>> {
    let h = 1.0 / n as f64;
    let mut all = vec![
        Stage {
            dynamics: [[1.0, h, 0.5 * h * h], [0.0, 1.0, h]],
            hessian: [[0.0; 3]; 3],
            gradient: [0.0; 3],
            rows: vec![]
        };
        n + 1
    ];
    for s in all.iter_mut().take(n) {
        s.hessian[2][2] = 2.0 * h;
    }
    all
}

fn pin(stage: &mut Stage<2, 3>, place: f64) {
    stage.rows.push(Inequality { g: [1.0, 0.0, 0.0], most: place });
    stage.rows.push(Inequality { g: [-1.0, 0.0, 0.0], most: -place });
}

#[test]
fn least_squared_acceleration_between_two_rests_is_a_cubic() {
    // ∫ u² is least for x = 3 t² − 2 t³: 12. From rest (fixed) to place 1 at rest.
    let n = 200;
    let mut stages = integrator(n);
    pin(&mut stages[n], 1.0);
    stages[n].rows.push(Inequality { g: [0.0, 1.0, 0.0], most: 0.0 });
    stages[n].rows.push(Inequality { g: [0.0, -1.0, 0.0], most: 0.0 });
    let mut o = Options::default();
    (o.fixed[0], o.fixed[1]) = (true, true);
    let found = solve(&mut stages, &vec![[0.0; 3]; n + 1], &(), &o).unwrap();
    let h = 1.0 / n as f64;
    let cost: f64 = found.v[..n].iter().map(|v| h * v[2] * v[2]).sum();
    assert!((cost - 12.0).abs() < 2e-3, "{cost} {}", found.iterations);
    assert!((found.v[n / 2][0] - 0.5).abs() < 1e-6);
}

#[test]
fn least_time_is_bang_bang() {
    // Greatest place at the end with |u| ≤ 2 and speed ≤ 0.5 from rest: 0.25 s of acceleration.
    let n = 100;
    let mut stages = integrator(n);
    for s in &mut stages {
        s.hessian = [[0.0; 3]; 3];
        s.rows.push(Inequality { g: [0.0, 0.0, 1.0], most: 2.0 });
        s.rows.push(Inequality { g: [0.0, 0.0, -1.0], most: 2.0 });
        s.rows.push(Inequality { g: [0.0, 1.0, 0.0], most: 0.5 });
    }
    stages[n].gradient[0] = -1.0;
    let mut o = Options::default();
    (o.fixed[0], o.fixed[1]) = (true, true);
    let found = solve(&mut stages, &vec![[0.0; 3]; n + 1], &(), &o).unwrap();
    assert!(found.converged && found.excess < 1e-9);
    assert!((found.v[n][0] - (0.5 - 0.0625)).abs() < 1e-7, "{}", found.v[n][0]);
    // The costate of the last place is the gradient.
    assert!((found.costates[n][0] + 1.0).abs() < 1e-6);
}

#[test]
fn what_cannot_be_is_told() {
    let mut stages = integrator(4);
    pin(&mut stages[2], 1.0);
    stages[2].rows.push(Inequality { g: [1.0, 0.0, 0.0], most: 0.0 });
    let found = solve(&mut stages, &[[0.0; 3]; 5], &(), &Options::default());
    assert!(found.is_none_or(|f| !f.converged && f.excess > 0.1));
    assert!(solve(&mut stages, &[[0.0; 3]; 3], &(), &Options::default()).is_none());
    stages[0].rows.push(Inequality { g: [f64::NAN, 0.0, 0.0], most: 0.0 });
    assert!(solve(&mut stages, &[[0.0; 3]; 5], &(), &Options::default()).is_none());
}
