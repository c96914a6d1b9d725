//! Closed-form surfaces for tests: all with `S_u × S_v` outwards, parameters over [0, 1]².
use nalgebra::Vector4;

use super::NurbsSurface;

/// A full circle as nine rational quadratic points `(x, y, weight)`, radius 1, counter-clockwise.
const CIRCLE: [(f64, f64, f64); 9] = {
    let w = std::f64::consts::FRAC_1_SQRT_2;
    [
        (1.0, 0.0, 1.0),
        (1.0, 1.0, w),
        (0.0, 1.0, 1.0),
        (-1.0, 1.0, w),
        (-1.0, 0.0, 1.0),
        (-1.0, -1.0, w),
        (0.0, -1.0, 1.0),
        (1.0, -1.0, w),
        (1.0, 0.0, 1.0),
    ]
};
const CIRCLE_KNOTS: [f64; 12] = [0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];

/// The profile `(r, z, weight)` turned about z.
fn revolved(profile: &[(f64, f64, f64)], degree_v: usize, knots_v: Vec<f64>) -> NurbsSurface {
    let points = CIRCLE
        .iter()
        .flat_map(|(x, y, w)| {
            profile.iter().map(move |(r, z, wp)| {
                let w = w * wp;
                Vector4::new(w * r * x, w * r * y, w * z, w)
            })
        })
        .collect();
    let knots_u = CIRCLE_KNOTS.to_vec();
    NurbsSurface { degree_u: 2, degree_v, knots_u, knots_v, n_u: 9, n_v: profile.len(), points }
}

/// A cylinder about z, from z = 0 to `height`, without caps.
pub fn cylinder(radius: f64, height: f64) -> NurbsSurface {
    revolved(&[(radius, 0.0, 1.0), (radius, height, 1.0)], 1, vec![0.0, 0.0, 1.0, 1.0])
}

/// The bilinear patch of four corners, `S_u × S_v` outwards where they run counter-clockwise.
pub fn patch(corners: [[f64; 3]; 4]) -> NurbsSurface {
    let [a, b, c, d] = corners.map(|[x, y, z]| Vector4::new(x, y, z, 1.0));
    let knots = || vec![0.0, 0.0, 1.0, 1.0];
    NurbsSurface {
        degree_u: 1,
        degree_v: 1,
        knots_u: knots(),
        knots_v: knots(),
        n_u: 2,
        n_v: 2,
        points: vec![a, d, b, c],
    }
}

/// A disc square to z at a height, its normal along z or against it.
pub fn disc(radius: f64, height: f64, up: bool) -> NurbsSurface {
    let (inner, outer) = if up { (radius, 0.0) } else { (0.0, radius) };
    revolved(&[(inner, height, 1.0), (outer, height, 1.0)], 1, vec![0.0, 0.0, 1.0, 1.0])
}

/// A cone about z with its apex at the origin, opening upwards to `radius` at `height`.
pub fn cone(radius: f64, height: f64) -> NurbsSurface {
    revolved(&[(0.0, 0.0, 1.0), (radius, height, 1.0)], 1, vec![0.0, 0.0, 1.0, 1.0])
}

/// A sphere about the origin, poles on z.
pub fn sphere(r: f64) -> NurbsSurface {
    let w = std::f64::consts::FRAC_1_SQRT_2;
    let profile = [(0.0, -r, 1.0), (r, -r, w), (r, 0.0, 1.0), (r, r, w), (0.0, r, 1.0)];
    revolved(&profile, 2, vec![0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0])
}

/// A torus about z.
pub fn torus(major: f64, minor: f64) -> NurbsSurface {
    let profile: Vec<_> = CIRCLE.iter().map(|(x, y, w)| (major + minor * x, minor * y, *w)).collect();
    revolved(&profile, 2, CIRCLE_KNOTS.to_vec())
}

/// A free-form patch (bicubic, not rational): a twisted, cambered sheet 20 × 40.
pub fn loft() -> NurbsSurface {
    let (n_u, n_v) = (7, 6);
    let points = (0..n_u)
        .flat_map(|i| {
            (0..n_v).map(move |j| {
                let (a, b) = (i as f64 / 6.0, j as f64 / 5.0);
                let twist = 0.6 * b;
                let (x, y) = (20.0 * (a - 0.5), 4.0 * (a * (1.0 - a)) + 0.8 * (5.0 * a).sin() * b);
                Vector4::new(x * twist.cos() - y * twist.sin(), x * twist.sin() + y * twist.cos(), 40.0 * b, 1.0)
            })
        })
        .collect();
    let knots = |n: usize| {
        let inner = n - 4;
        let mut k = vec![0.0; 4];
        k.extend((1..=inner).map(|i| i as f64 / (inner + 1) as f64));
        k.extend([1.0; 4]);
        k
    };
    NurbsSurface { degree_u: 3, degree_v: 3, knots_u: knots(n_u), knots_v: knots(n_v), n_u, n_v, points }
}
