//! Single corners of a polyline, rounded by published curves and by a better one of the same form.
//!
//! The curve is a spline of degree 5 with seven control points on the breaks 0, ½, 1, symmetric
//! about the corner, which is its fourth. From the end inwards the control points are `d₁`, `d₂`,
//! `d₃` apart; the first four are on the straight move, so curvature and its derivative vanish
//! where the curve leaves it. With `θ` the interior angle (π: straight) and `ε` the distance of the
//! curve's middle from the corner (Wan et al. 2019, "G3 continuous tool path smoothing …
//! quasi-uniform quintic B-spline", Chinese Journal of Aeronautics 32(7))
//!
//! ```text
//! ε = (d₂ + 5 d₃) cos(θ/2) / 8,       κ ε = 0.8 (1 + ν)(5 + ν)/(3 + ν)² cot²(θ/2),  ν = d₂/d₃
//! ```
//!
//! Their kind makes `∫ |c''|² + β ∫ |c'''|²` least, derivatives by the parameter: a quadratic form
//! in `d = (d₁, d₂, d₃)` with `ε` given, so `d ∝ M⁻¹ (0, 1, 5)`. The rival's, Tulsyan and Altintas
//! 2015, has equal derivatives by the parameter up to the third where curve and move meet: `d₁ : d₂
//! : d₃ = 1 : 2 : 2`. [`CornerKind::LeastThird`] makes the greatest third derivative by arc length
//! itself least.
//!
//! A corner needs [`Corner::reach_mm`] of both moves. Where the reaches of two corners overlap
//! these curves do not exist, as on dense cutter locations: [`super::plan`] is for those.

use nalgebra::{Matrix3, Vector3};

use crate::geometry::Vector;
use crate::numerics::quintic::{self, Breaks, apply};

/// How a corner is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CornerKind {
    /// Tulsyan and Altintas 2015.
    EqualDerivatives,
    /// Wan et al. 2019, with the weight `β` of the third derivative; it is not published.
    LeastEnergy {
        /// The weight.
        beta: f64,
    },
    /// The least greatest third derivative by arc length.
    LeastThird,
}

/// A rounded corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Interior angle, rad.
    pub angle_rad: f64,
    /// Distances of the control points from the end inwards, mm.
    pub apart_mm: [f64; 3],
}

/// Shares of `d₁` and `d₂` of `d₃` at least: control points stay apart and in order.
const LEAST_SHARE: f64 = 1e-3;
/// Places of half a curve at which derivatives are looked at.
const PLACES: usize = 64;
/// Rounds of the search for the least third derivative; each halves the step.
const ROUNDS: usize = 16;
/// Places of each share on the grid that the search begins with.
const GRID: usize = 32;
/// Greatest share on it.
const WIDE: f64 = 6.0;
/// Neighbours in a round.
const AROUND: usize = 16;

impl Corner {
    /// The corner whose middle is `off_mm` from that of the moves. `None` where the angle is not
    /// between 0 and π, the distance or `β` not positive.
    pub fn new(kind: CornerKind, angle_rad: f64, off_mm: f64) -> Option<Corner> {
        let fits = angle_rad > 0.0 && angle_rad < std::f64::consts::PI && off_mm > 0.0 && off_mm.is_finite();
        if !fits {
            return None;
        }
        let of = |mu: f64, nu: f64| {
            let d3 = 8.0 * off_mm / ((5.0 + nu) * (0.5 * angle_rad).cos());
            Corner { angle_rad, apart_mm: [mu * d3, nu * d3, d3] }
        };
        match kind {
            CornerKind::EqualDerivatives => Some(of(0.5, 1.0)),
            CornerKind::LeastEnergy { beta } => {
                let [mu, nu] = least_energy(angle_rad, beta)?;
                Some(of(mu.max(LEAST_SHARE), nu.max(LEAST_SHARE)))
            }
            CornerKind::LeastThird => Some(least_third(&of)),
        }
    }

    /// Distance of the curve's middle from the corner, mm.
    pub fn off_mm(&self) -> f64 {
        (self.apart_mm[1] + 5.0 * self.apart_mm[2]) * (0.5 * self.angle_rad).cos() / 8.0
    }

    /// Length of each move that the curve takes the place of, mm.
    pub fn reach_mm(&self) -> f64 {
        self.apart_mm.iter().sum()
    }

    /// Control points about a corner in the origin, with unit vectors to the ends of the moves.
    pub fn controls(&self, to_before: &Vector, to_after: &Vector) -> [[f64; 3]; 7] {
        let [d1, d2, d3] = self.apart_mm;
        let far = [d1 + d2 + d3, d2 + d3, d3];
        std::array::from_fn(|k| match k {
            0..3 => (to_before * far[k]).into(),
            3 => [0.0; 3],
            _ => (to_after * far[6 - k]).into(),
        })
    }

    /// Greatest curvature, 1/mm, and greatest third derivative by arc length, 1/mm².
    pub fn peaks(&self) -> [f64; 2] {
        let Some(breaks) = Breaks::new(vec![0.0, 0.5, 1.0]) else { return [f64::NAN; 2] };
        let (sine, cosine) = self.angle_rad.sin_cos();
        let controls = self.controls(&Vector::x(), &Vector::new(cosine, sine, 0.0));
        let ordinates = apply(&breaks.ordinates(0, [0.0, 0.5]), &controls);
        let mut out = [0.0_f64; 2];
        for k in 0..=PLACES {
            let d = quintic::at(&ordinates, 0.5, k as f64 / PLACES as f64).map(Vector::from);
            let [second, third] = by_arc_length(&d[1], &d[2], &d[3]);
            out = [out[0].max(second.norm()), out[1].max(third.norm())];
        }
        out
    }
}

/// Second and third derivative by arc length, from those by a parameter.
fn by_arc_length(d1: &Vector, d2: &Vector, d3: &Vector) -> [Vector; 2] {
    let speed = d1.norm();
    let rise = d1.dot(d2) / speed;
    let bend = (d2.norm_squared() + d1.dot(d3) - rise * rise) / speed;
    let tangent = d1 / speed;
    let second = (d2 - tangent * rise) / (speed * speed);
    let third = (d3 - second * (3.0 * speed * rise) - tangent * bend) / speed.powi(3);
    [second, third]
}

/// `d₁/d₃` and `d₂/d₃` of the least energy.
fn least_energy(angle_rad: f64, beta: f64) -> Option<[f64; 2]> {
    let cosine = angle_rad.cos();
    // Integrals over half the curve, of products of the two halves as well.
    let second = Matrix3::new(3200.0, -1110.0, -390.0, -1110.0, 620.0, 80.0, -390.0, 80.0, 180.0) / 7.0;
    let second_across = Matrix3::new(0.0, 10.0, 90.0, 10.0, 60.0, 80.0, 90.0, 80.0, -60.0) / 7.0;
    let third = Matrix3::new(23040.0, -15600.0, 2640.0, -15600.0, 11040.0, -2400.0, 2640.0, -2400.0, 1440.0);
    let third_across = Matrix3::new(0.0, -240.0, -1200.0, -240.0, 0.0, 960.0, -1200.0, 960.0, 0.0);
    let energy = second + second_across * cosine + (third + third_across * cosine) * beta;
    let d = energy.lu().solve(&Vector3::new(0.0, 1.0, 5.0))?;
    let shares = [d[0] / d[2], d[1] / d[2]];
    (beta >= 0.0 && shares.iter().all(|s| s.is_finite())).then_some(shares)
}

/// The corner with the least third derivative: the best of a grid, then of the neighbours, nearer
/// and nearer. The greatest of many places has creases along which a search that goes straight
/// stands still, so neighbours are looked at all round.
fn least_third(of: &dyn Fn(f64, f64) -> Corner) -> Corner {
    let value = |[mu, nu]: [f64; 2]| of(mu, nu).peaks()[1];
    let grid = (0..GRID * GRID).map(|k| [k / GRID, k % GRID].map(|j| LEAST_SHARE + WIDE * j as f64 / GRID as f64));
    let (mut best, mut least) = ([0.5, 1.0], value([0.5, 1.0]));
    for shares in grid {
        let there = value(shares);
        if there < least {
            (best, least) = (shares, there);
        }
    }
    let mut step = WIDE / GRID as f64;
    for _ in 0..ROUNDS {
        let mut moved = true;
        while moved {
            moved = false;
            for k in 0..AROUND {
                let (sine, cosine) = (std::f64::consts::TAU * k as f64 / AROUND as f64).sin_cos();
                let next = [best[0] + step * cosine, best[1] + step * sine].map(|v: f64| v.max(LEAST_SHARE));
                let there = value(next);
                if there < least * (1.0 - 1e-9) {
                    (best, least, moved) = (next, there, true);
                }
            }
        }
        step *= 0.5;
    }
    of(best[0], best[1])
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const OFF: f64 = 0.1;

    fn corner(kind: CornerKind, deg: f64) -> Corner {
        Corner::new(kind, deg.to_radians(), OFF).unwrap()
    }

    #[test]
    fn the_middle_is_as_far_off_as_asked_and_ends_are_straight() {
        let breaks = Breaks::new(vec![0.0, 0.5, 1.0]).unwrap();
        for deg in [10.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0, 170.0] {
            for kind in [CornerKind::EqualDerivatives, CornerKind::LeastEnergy { beta: 0.04 }, CornerKind::LeastThird] {
                let c = corner(kind, deg);
                assert!((c.off_mm() - OFF).abs() < 1e-12);
                let (sine, cosine) = deg.to_radians().sin_cos();
                let controls = c.controls(&Vector::x(), &Vector::new(cosine, sine, 0.0));
                let middle: Vector =
                    breaks.weights(0, 0.5).iter().zip(controls).map(|(w, p)| Vector::from(p) * *w).sum();
                assert!((middle.norm() - OFF).abs() < 1e-9, "{kind:?} {deg}");
                let first = apply(&breaks.ordinates(0, [0.0, 0.5]), &controls);
                let d = quintic::at(&first, 0.5, 0.0).map(Vector::from);
                let [second, third] = by_arc_length(&d[1], &d[2], &d[3]);
                // Curvature and the part of its derivative across the move vanish.
                assert!(second.norm() < 1e-9 / OFF && third.norm() < 1e-6 / (OFF * OFF), "{kind:?} {deg}");
                let d = quintic::at(&first, 0.5, 1.0).map(Vector::from);
                let nu = c.apart_mm[1] / c.apart_mm[2];
                let cot = 1.0 / (0.5 * deg.to_radians()).tan();
                let want = 0.8 * (1.0 + nu) * (5.0 + nu) / (3.0 + nu).powi(2) * cot * cot / OFF;
                assert!((by_arc_length(&d[1], &d[2], &d[3])[0].norm() / want - 1.0).abs() < 1e-9);
            }
        }
    }

    /// Greatest curvature and third derivative, and reach, of the rival; what the published kind
    /// with β = 0.04 and the least third derivative save.
    #[test]
    fn known_figures_are_met() {
        let rows = [
            (30.0, 83.57, 7330.0, 0.345, 0.197, 0.47),
            (45.0, 34.97, 1296.0, 0.361, 0.180, 0.47),
            (60.0, 18.00, 349.0, 0.385, 0.158, 0.47),
            (90.0, 6.00, 41.7, 0.471, 0.115, 0.33),
            (120.0, 2.00, 5.74, 0.667, 0.067, 0.19),
            (150.0, 0.431, 0.511, 1.288, 0.006, 0.065),
        ];
        for (deg, curvature, third, reach, published, own) in rows {
            let rival = corner(CornerKind::EqualDerivatives, deg);
            let [k, c] = rival.peaks();
            assert!((k / curvature - 1.0).abs() < 2e-3 && (c / third - 1.0).abs() < 4e-3, "{deg}: {k} {c}");
            assert!((rival.reach_mm() / reach - 1.0).abs() < 2e-3, "{deg}: {}", rival.reach_mm());
            let [_, energy] = corner(CornerKind::LeastEnergy { beta: 0.04 }, deg).peaks();
            assert!((1.0 - energy / c - published).abs() < 6e-3, "{deg}: {}", 1.0 - energy / c);
            let [_, least] = corner(CornerKind::LeastThird, deg).peaks();
            let found = corner(CornerKind::LeastThird, deg).apart_mm;
            assert!(1.0 - least / c >= own, "{deg}: {} {found:?}", 1.0 - least / c);
        }
    }

    #[test]
    fn nearly_straight_the_published_kind_is_its_rival() {
        let c = Corner::new(CornerKind::LeastEnergy { beta: 0.3 }, 179.99_f64.to_radians(), OFF).unwrap();
        let [d1, d2, d3] = c.apart_mm;
        assert!((d1 / d3 - 0.5).abs() < 1e-3 && (d2 / d3 - 1.0).abs() < 1e-3, "{} {}", d1 / d3, d2 / d3);
    }

    #[test]
    fn no_corner_without_an_angle() {
        for (angle, off) in [(0.0, 0.1), (std::f64::consts::PI, 0.1), (1.0, 0.0), (f64::NAN, 0.1), (1.0, f64::NAN)] {
            for kind in [CornerKind::EqualDerivatives, CornerKind::LeastThird] {
                assert!(Corner::new(kind, angle, off).is_none());
            }
        }
        assert!(Corner::new(CornerKind::LeastEnergy { beta: -1.0 }, 1.0, 0.1).is_none());
    }
}
