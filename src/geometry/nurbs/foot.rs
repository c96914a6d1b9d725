//! Closest points on NURBS curves and surfaces from a first guess, by safeguarded Newton.

use super::{NurbsCurve, NurbsSurface, SurfaceDerivatives};
use crate::geometry::{Point, Vector};

/// Where a surface's parameters may run: closed directions wrap, straight directions may be
/// continued, others end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterSpace {
    /// The surface's own range, `[u, v][from, to]`.
    pub domain: [[f64; 2]; 2],
    /// The range in which feet are sought: the domain, longer where a straight direction is
    /// continued.
    pub range: [[f64; 2]; 2],
    /// The surface closes upon itself along u, along v.
    pub closed: [bool; 2],
}

/// A sample of the sides of the domain, for the test whether they meet or shrink to a point.
const SIDE_SAMPLES: usize = 9;

impl ParameterSpace {
    /// Looks at the surface's sides: those that coincide within `tolerance_mm` make it closed.
    pub fn of(surface: &NurbsSurface, tolerance_mm: f64) -> Self {
        let domain = surface.domain();
        let apart = |along: usize| {
            let worst = (0..SIDE_SAMPLES).map(|k| {
                let s = k as f64 / (SIDE_SAMPLES - 1) as f64;
                let [a, b] = [0, 1].map(|side| {
                    let mut uv = [0.0; 2];
                    uv[along] = domain[along][side];
                    uv[1 - along] = domain[1 - along][0] * (1.0 - s) + domain[1 - along][1] * s;
                    surface.point(uv[0], uv[1])
                });
                (a - b).norm()
            });
            worst.fold(0.0, f64::max)
        };
        ParameterSpace { domain, range: domain, closed: [apart(0) <= tolerance_mm, apart(1) <= tolerance_mm] }
    }

    /// Length of the domain along u (0) or v (1).
    pub fn period(&self, along: usize) -> f64 {
        self.domain[along][1] - self.domain[along][0]
    }

    /// The parameter pair within the domain (closed directions) or the range (others) that means
    /// the same point.
    pub fn normal_form(&self, uv: [f64; 2]) -> [f64; 2] {
        let one = |along: usize| {
            let x = uv[along];
            if self.closed[along] {
                let [from, to] = self.domain[along];
                if (from..=to).contains(&x) { x } else { from + (x - from).rem_euclid(self.period(along)) }
            } else {
                x.clamp(self.range[along][0], self.range[along][1])
            }
        };
        [one(0), one(1)]
    }

    /// The pair that means the same point as `uv` and lies nearest to `near`, along closed
    /// directions.
    pub fn nearest_copy(&self, mut uv: [f64; 2], near: [f64; 2]) -> [f64; 2] {
        for along in 0..2 {
            if self.closed[along] {
                let period = self.period(along);
                uv[along] += ((near[along] - uv[along]) / period).round() * period;
            }
        }
        uv
    }
}

/// A closest point on a surface.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceFoot {
    /// Parameters; along closed directions they may lie beyond the domain, continuing from the
    /// guess.
    pub uv: [f64; 2],
    /// Point and derivatives there.
    pub at: SurfaceDerivatives,
    /// Distance, mm.
    pub distance_mm: f64,
}

/// Steps and gradients smaller than this, mm, end the iteration.
const CONVERGED_MM: f64 = 1e-11;

/// What a squared distance may become in a step without counting as growth: rounding must not stop
/// the last steps.
fn not_more(d2: f64) -> f64 {
    d2 * (1.0 + 1e-13) + 1e-24
}

impl NurbsSurface {
    /// A local minimum of the distance to `q`, by Newton from `guess` within the parameter space;
    /// where the Hessian is not positive definite a Gauss–Newton step, where the distance would
    /// grow a shorter one.
    pub fn foot(&self, q: &Point, guess: [f64; 2], space: &ParameterSpace) -> SurfaceFoot {
        let evaluate = |uv: [f64; 2]| {
            let n = space.normal_form(uv);
            self.derivatives(n[0], n[1])
        };
        let clamp = |mut uv: [f64; 2]| {
            for along in 0..2 {
                if !space.closed[along] {
                    uv[along] = uv[along].clamp(space.range[along][0], space.range[along][1]);
                }
            }
            uv
        };
        let mut uv = clamp(guess);
        let mut at = evaluate(uv);
        let mut d2 = (at.p - q).norm_squared();
        for _ in 0..40 {
            let step = surface_step(&at, &(at.p - q), uv, space);
            let mut scale = 1.0;
            let mut moved = false;
            for _ in 0..12 {
                let next_uv = clamp([uv[0] + scale * step[0], uv[1] + scale * step[1]]);
                let next = evaluate(next_uv);
                let next_d2 = (next.p - q).norm_squared();
                if next_d2 <= not_more(d2) {
                    moved = next_uv != uv;
                    (uv, at, d2) = (next_uv, next, next_d2);
                    break;
                }
                scale *= 0.3;
            }
            let length = (at.du * (scale * step[0])).norm() + (at.dv * (scale * step[1])).norm();
            if !moved || length < CONVERGED_MM {
                break;
            }
        }
        SurfaceFoot { uv, at, distance_mm: d2.sqrt() }
    }
}

/// The Newton or Gauss–Newton step for ½|S − q|², kept off walls that the parameters already touch.
fn surface_step(at: &SurfaceDerivatives, r: &Vector, uv: [f64; 2], space: &ParameterSpace) -> [f64; 2] {
    let g = [r.dot(&at.du), r.dot(&at.dv)];
    let (e, f, gg) = (at.du.norm_squared(), at.du.dot(&at.dv), at.dv.norm_squared());
    let (mut a, mut b, mut c) = (e + r.dot(&at.duu), f + r.dot(&at.duv), gg + r.dot(&at.dvv));
    if a <= 1e-6 * e || a * c - b * b <= 1e-6 * e * gg {
        (a, b, c) = (e, f, gg);
    }
    let blocked = |along: usize| {
        let [from, to] = space.range[along];
        !space.closed[along] && ((uv[along] <= from && g[along] > 0.0) || (uv[along] >= to && g[along] < 0.0))
    };
    let alone = |g: f64, h: f64| if h > 0.0 { -g / h } else { 0.0 };
    match (blocked(0), blocked(1)) {
        (true, true) => [0.0, 0.0],
        (true, false) => [0.0, alone(g[1], c)],
        (false, true) => [alone(g[0], a), 0.0],
        (false, false) => {
            let det = a * c - b * b;
            if det > 1e-12 * a * c {
                [(b * g[1] - c * g[0]) / det, (b * g[0] - a * g[1]) / det]
            } else {
                // Degenerate (a pole): each direction by itself, at half length.
                [0.5 * alone(g[0], a), 0.5 * alone(g[1], c)]
            }
        }
    }
}

/// A closest point on a curve.
#[derive(Clone, Copy, Debug)]
pub struct CurveFoot {
    /// Parameter.
    pub t: f64,
    /// The point.
    pub point: Point,
    /// First derivative there.
    pub tangent: Vector,
    /// Distance, mm.
    pub distance_mm: f64,
}

impl NurbsCurve {
    /// A local minimum of the distance to `q` on `range`, by safeguarded Newton from `guess`.
    pub fn foot(&self, q: &Point, guess: f64, range: [f64; 2]) -> CurveFoot {
        let mut t = guess.clamp(range[0], range[1]);
        let (mut p, mut d1, mut d2) = self.derivatives(t);
        let mut best = (p - q).norm_squared();
        for _ in 0..40 {
            let r = p - q;
            let (g, gauss) = (r.dot(&d1), d1.norm_squared());
            let newton = gauss + r.dot(&d2);
            let h = if newton > 1e-6 * gauss { newton } else { gauss };
            if h <= 0.0 {
                break;
            }
            let mut step = -g / h;
            let mut moved = false;
            for _ in 0..12 {
                let next = (t + step).clamp(range[0], range[1]);
                let at = self.derivatives(next);
                let d = (at.0 - q).norm_squared();
                if d <= not_more(best) {
                    moved = next != t;
                    (t, p, d1, d2, best) = (next, at.0, at.1, at.2, d);
                    break;
                }
                step *= 0.3;
            }
            if !moved || step.abs() * d1.norm() < CONVERGED_MM {
                break;
            }
        }
        CurveFoot { t, point: p, tangent: d1, distance_mm: best.sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::nurbs::shapes::{cylinder, loft, sphere, torus};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn torus_foot_in_closed_form(angle in 0.0..std::f64::consts::TAU, tilt in 0.0..std::f64::consts::TAU, d in -1.5..3.0f64) {
            let (major, minor) = (10.0, 3.0);
            let s = torus(major, minor);
            let space = ParameterSpace::of(&s, 1e-9);
            prop_assert_eq!(space.closed, [true, true]);
            let at = |r: f64| {
                let rho = major + r * tilt.cos();
                Point::new(rho * angle.cos(), rho * angle.sin(), r * tilt.sin())
            };
            // The guess is the seam, up to a third of the way round from the foot.
            let guess = [angle / std::f64::consts::TAU + 0.06, tilt / std::f64::consts::TAU - 0.08];
            let foot = s.foot(&at(minor + d), guess, &space);
            prop_assert!((foot.distance_mm - d.abs()).abs() < 1e-9);
            prop_assert!((foot.at.p - at(minor)).norm() < 1e-8);
        }

        #[test]
        fn free_form_foot_is_stationary(x in -12.0..12.0f64, y in -8.0..8.0f64, z in -5.0..45.0f64) {
            let s = loft();
            let space = ParameterSpace::of(&s, 1e-9);
            prop_assert_eq!(space.closed, [false, false]);
            let q = Point::new(x, y, z);
            let foot = s.foot(&q, [0.5, (z / 40.0).clamp(0.0, 1.0)], &space);
            let r = foot.at.p - q;
            for (along, d) in [foot.at.du, foot.at.dv].into_iter().enumerate() {
                let slope = r.dot(&d) / d.norm();
                let x = foot.uv[along];
                // Stationary inside; at a wall the distance may only fall outwards.
                let fine = slope.abs() < 1e-6 || (x <= 0.0 && slope > 0.0) || (x >= 1.0 && slope < 0.0);
                prop_assert!(fine, "uv {:?} slope {slope}", foot.uv);
            }
        }
    }

    #[test]
    fn straight_directions_can_be_continued() {
        let s = cylinder(3.0, 10.0);
        let mut space = ParameterSpace::of(&s, 1e-9);
        assert_eq!(space.closed, [true, false]);
        let q = Point::new(5.0, 0.1, 12.0);
        assert!((s.foot(&q, [0.01, 0.5], &space).at.p.z - 10.0).abs() < 1e-9);
        space.range[1] = [-1.0, 2.0];
        let foot = s.foot(&q, [0.01, 0.5], &space);
        assert!((foot.at.p.z - 12.0).abs() < 1e-9 && (foot.distance_mm - (q.x.hypot(q.y) - 3.0)).abs() < 1e-9);
    }

    #[test]
    fn over_a_pole_the_pole_is_found() {
        let s = sphere(4.0);
        let space = ParameterSpace::of(&s, 1e-9);
        let foot = s.foot(&Point::new(0.0, 0.0, 6.0), [0.3, 0.9], &space);
        assert!((foot.distance_mm - 2.0).abs() < 1e-9);
    }
}
