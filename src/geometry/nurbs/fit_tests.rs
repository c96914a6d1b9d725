#![allow(clippy::unwrap_used)]
use super::*;
use proptest::prelude::*;

/// Value of control rows at `t`, by their basis functions.
fn at(r: &ControlRows, t: f64, column: usize) -> Vector4<f64> {
    let n = r.points.len() / r.columns;
    let b = Basis::new(r.degree, n, &r.knots, t);
    b.value().iter().enumerate().map(|(j, value)| r.points[(b.first + j) * r.columns + column] * *value).sum()
}

fn rows(c: &NurbsCurve) -> ControlRows {
    ControlRows { degree: c.degree, knots: c.knots.clone(), columns: 1, points: c.points.clone() }
}

fn circle_points(n: usize) -> (Vec<Vector4<f64>>, Vec<f64>) {
    let t: Vec<f64> = (0..=n).map(|i| std::f64::consts::TAU * i as f64 / n as f64).collect();
    (t[..n].iter().map(|t| Vector4::new(t.cos(), t.sin(), 0.5 * t.cos(), 1.0 + 0.1 * t.sin())).collect(), t)
}

#[test]
fn clamped_curve_reproduces_a_polynomial_of_its_degree() {
    let f = |t: f64| Vector4::new(t, t * t - 1.0, t.powi(3), 1.0 + 0.01 * t);
    let params = [0.0, 0.3, 0.5, 1.1, 1.2, 2.0, 3.0];
    let points: Vec<_> = params.iter().map(|&t| f(t)).collect();
    for degree in [3, 4, 5] {
        let c = interpolate_curve(&points, &params, degree).unwrap();
        for i in 0..=30 {
            let t = 0.1 * i as f64;
            assert!((at(&rows(&c), t, 0) - f(t)).norm() < 1e-12);
        }
    }
}

#[test]
fn surface_passes_through_its_grid_and_keeps_its_boundary() {
    let (u, v) = ([0.0, 0.2, 0.5, 0.7, 1.0], [0.0, 1.0, 2.0, 2.5, 4.0, 5.0]);
    let f = |u: f64, v: f64| Vector4::new(u, v, u.sin() * v.cos(), 1.0 + 0.1 * u);
    let grid: Vec<_> = u.iter().flat_map(|&u| v.iter().map(move |&v| f(u, v))).collect();
    let s = interpolate_surface(&grid, &u, &v, 3, 2).unwrap();
    assert_eq!((s.n_u, s.n_v, s.knots_u.len(), s.knots_v.len()), (5, 6, 9, 9));
    for (i, &a) in u.iter().enumerate() {
        for (j, &b) in v.iter().enumerate() {
            let r = ControlRows { degree: 3, knots: s.knots_u.clone(), columns: 6, points: s.points.clone() };
            let row: Vec<_> = (0..6).map(|c| at(&r, a, c)).collect();
            let across = ControlRows { degree: 2, knots: s.knots_v.clone(), columns: 1, points: row };
            assert!((at(&across, b, 0) - grid[i * 6 + j]).norm() < 1e-13);
        }
    }
    assert_eq!(s.points[0], grid[0]);
    assert_eq!(s.points[29], grid[29]);
}

#[test]
fn periodic_interpolation_is_twice_continuous_round_the_whole() {
    let (points, t) = circle_points(12);
    let p = PeriodicRows::interpolate(&points, 1, &t).unwrap();
    let r = p.open(0);
    for (i, q) in points.iter().enumerate() {
        assert!((at(&r, t[i], 0) - q).norm() < 1e-14);
    }
    // Second differences across the seam agree with those of the same curve opened half way round.
    let other = p.open(6);
    for k in 1..20 {
        let s = 0.05 * k as f64;
        assert!((at(&r, s, 0) - at(&other, s + t[12], 0)).norm() < 1e-13);
        assert!((at(&r, t[12] - s, 0) - at(&other, t[12] - s, 0)).norm() < 1e-13);
    }
    assert_eq!(r.points[0], r.points[r.points.len() - 1]);
}

#[test]
fn periodic_pieces_are_the_curve_and_share_their_ends() {
    let (points, mut t) = circle_points(10);
    t[3] += 0.05;
    let p = PeriodicRows::interpolate(&points, 1, &t).unwrap();
    let whole = p.open(2);
    let pieces = p.pieces(&[2, 5, 9]).unwrap();
    assert_eq!(pieces.len(), 3);
    for (i, piece) in pieces.iter().enumerate() {
        let (a, b) = (piece.knots[0], piece.knots[piece.knots.len() - 1]);
        assert!(piece.knots[3] == a && piece.knots[4] > a && piece.knots.len() == piece.points.len() + 4);
        for k in 0..=20 {
            let s = a + (b - a) * k as f64 / 20.0;
            assert!((at(piece, s, 0) - at(&whole, s, 0)).norm() < 1e-13);
        }
        assert_eq!(piece.points[piece.points.len() - 1], pieces[(i + 1) % 3].points[0]);
    }
}

#[test]
fn periodic_circle_converges_with_the_fourth_power() {
    let error = |n: usize| {
        let (points, t) = circle_points(n);
        let r = PeriodicRows::interpolate(&points, 1, &t).unwrap().open(0);
        (0..500).map(|i| 0.0125 * i as f64).map(|s| (at(&r, s, 0).x - s.cos()).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(16), error(32));
    assert!(coarse < 3e-4 && (coarse / fine - 16.0).abs() < 2.0, "{coarse} {fine}");
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let (points, t) = circle_points(5);
    assert!(matches!(interpolate_curve(&points, &t, 3), Err(FitError::Count { .. })));
    assert!(matches!(
        interpolate_curve(&points, &[0.0, 1.0, 1.0, 2.0, 3.0], 3),
        Err(FitError::Parameters { index: 2, .. })
    ));
    assert!(matches!(interpolate_curve(&points, &t[..5], 5), Err(FitError::Count { .. })));
    assert!(matches!(interpolate_curve(&points, &t[..5], 0), Err(FitError::Count { .. })));
    let bad = vec![Vector4::new(0.0, 0.0, 0.0, -1.0); 5];
    assert!(matches!(interpolate_curve(&bad, &t[..5], 3), Err(FitError::Point { index: 0 })));
    assert!(PeriodicRows::interpolate(&points, 1, &t).unwrap().pieces(&[]).is_err());
    let c = interpolate_curve(&points, &t[..5], 3).unwrap();
    assert!(matches!(split_curve(&c, 0.0), Err(FitError::Cut { .. })));
    assert!(matches!(split_curve(&c, f64::NAN), Err(FitError::Cut { .. })));
    // Within rounding of an end it is a cut at the end.
    let [from, to] = c.domain();
    for t in [from + 1e-14 * (to - from), to - 1e-14 * (to - from)] {
        assert!(matches!(split_curve(&c, t), Err(FitError::Cut { .. })), "{t}");
    }
    assert!(split_curve(&NurbsCurve { knots: vec![0.0; 3], ..c }, 1.0).is_err());
}

proptest! {
    #[test]
    fn a_cut_changes_nothing(degree in 1usize..6, n in 6usize..12, x in 0.01..0.99f64, y in prop::collection::vec(-1.0..1.0f64, 12)) {
        let params: Vec<f64> = (0..n).map(|i| i as f64).collect();
        let points: Vec<_> = (0..n).map(|i| Vector4::new(y[i], i as f64, y[11 - i], 1.0)).collect();
        let c = interpolate_curve(&points, &params, degree).unwrap();
        let t = x * (n - 1) as f64;
        let (a, b) = split_curve(&c, t).unwrap();
        prop_assert_eq!(a.points[a.points.len() - 1], b.points[0]);
        for k in 0..=20 {
            let s = (n - 1) as f64 * k as f64 / 20.0;
            let part = if s < t { &a } else { &b };
            prop_assert!(check_clamped(&rows(part)).is_ok());
            prop_assert!((at(&rows(part), s, 0) - at(&rows(&c), s, 0)).norm() < 1e-11);
        }
    }
}

/// Curves with knots of their own: the ruled surface has them both as its sides and straight lines
/// between.
#[test]
fn ruled_surface_between_two_curves() {
    let curve = |n: usize, y: f64| {
        let t: Vec<f64> = (0..n).map(|i| (i as f64 / (n - 1) as f64).powf(1.3) * 2.0).collect();
        let p: Vec<_> = t.iter().map(|t| Vector4::new(*t, y + t.sin(), t * t, 1.0)).collect();
        interpolate_curve(&p, &t, 3).unwrap()
    };
    let (a, b) = (curve(9, 0.0), curve(14, 3.0));
    let s = ruled(&a, &b).unwrap();
    for i in 0..=50 {
        let u = f64::from(i) / 50.0;
        let (p, q) = (a.point(2.0 * u), b.point(2.0 * u));
        assert!((s.point(u, 0.0) - p).norm() < 1e-12 && (s.point(u, 1.0) - q).norm() < 1e-12);
        assert!((s.point(u, 0.25) - (p + (q - p) * 0.25)).norm() < 1e-12);
    }
    let line = interpolate_curve(&a.points[..2], &[0.0, 1.0], 1).unwrap();
    assert!(matches!(ruled(&a, &line), Err(FitError::Count { what: "degree", .. })));
}
