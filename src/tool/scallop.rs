//! What two neighbouring passes of a ball leave between them, in closed form, and how far apart
//! they may lie.
//!
//! Two balls of radius `R` touch a circle of signed curvature `κ = 1/r` (positive: convex towards
//! the ball, negative: concave, 0: flat). Their centres lie `r + R` from the circle's middle, an
//! angle `2α` apart, and they meet in a cusp at `r + h`. The law of cosines, written so that
//! nothing cancels where `κ` is small:
//! ```text
//! sin²(α/2) = y²,  y = κ x / 2,  x² = h (2R − h) / ((1 + κR)(1 + κh))
//! contacts on the circle  W = 2 r α        = 4 asin(y) / κ        → 2x where it is flat
//! ball centres            d = 2 (r + R) sin α = 2 (1 + κR) x sqrt(1 − y²)
//! ```
//! This is the two-ball construction `h = |(r + R) cos α ∓ sqrt(R² − (r + R)² sin² α) − r|` solved
//! for `d`. It holds as long as the ball fits: `1 + κR > 0`.
//!
//! On a surface ([`width_on_part_mm`]) each pass is swept along its way, and the ridge is where two
//! such tubes meet. With `S` the part's shape operator (convex positive) and `M = (I + R S)⁻¹`, a
//! ball whose centre lies `x` along the surface of centres from that over a place leaves there the
//! height `xᵀMx/2R`, to second order. A pass beside the place, in the direction `t` and `D` away,
//! leaves the least of its balls: `D²/(2R wᵀM⁻¹w)`, with `w` across `t`. Since
//! `wᵀM⁻¹w = 1 + R wᵀSw`, what counts is the part's own curvature `κ = wᵀSw` across the way of the
//! ball. The ball straight beside the place is not the one that cuts lowest where the way runs
//! aslant to the principal directions, and by its height alone a crease as round as the ball would
//! seem to need passes without end. Areas shrink from the centres to the part by `det M` and
//! lengths along the pass by `|M t|`, so that the strip is `W(κ) tᵀMt/|Mt|` wide: by the cosine
//! between the way of the ball and the line of contacts.

use crate::geometry::Vector;
use crate::geometry::nurbs::Principal;

/// `x` of the module's page, mm; `None` where the ball does not fit or an argument is out of its
/// limits.
fn half_chord(radius_mm: f64, scallop_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let (r, h, k) = (radius_mm, scallop_mm, curvature_per_mm);
    let fits = (1.0 + k * r) * (1.0 + k * h);
    let x = (h * (2.0 * r - h) / fits).sqrt();
    (r > 0.0 && h > 0.0 && h < r && 1.0 + k * r > 0.0 && x.is_finite()).then_some(x)
}

/// Distance along the part between the contacts of two passes that leave the scallop `scallop_mm`,
/// mm; `None` where a ball of this radius does not fit into the curvature.
pub fn width_mm(radius_mm: f64, scallop_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let x = half_chord(radius_mm, scallop_mm, curvature_per_mm)?;
    // In a groove hardly wider than the ball one pass cuts all of it.
    let y = (0.5 * curvature_per_mm.abs() * x).min(1.0);
    let ratio = if y < 1e-3 { 1.0 + y * y / 6.0 } else { y.asin() / y };
    Some(2.0 * x * ratio)
}

/// Distance of the ball centres of the same two passes, mm; `None` as [`width_mm`].
pub fn centre_distance_mm(radius_mm: f64, scallop_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let x = half_chord(radius_mm, scallop_mm, curvature_per_mm)?;
    let y2 = (0.25 * curvature_per_mm.powi(2) * x * x).min(1.0);
    Some(2.0 * (1.0 + curvature_per_mm * radius_mm) * x * (1.0 - y2).sqrt())
}

/// Scallop that two balls leave whose centres are `distance_mm` apart, mm; `None` where they do not
/// fit or do not meet over the part.
pub fn height_mm(radius_mm: f64, distance_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let (r, d, k) = (radius_mm, distance_mm, curvature_per_mm);
    let fits = 1.0 + k * r;
    let sine = 0.5 * k * d / fits;
    let cosine = (1.0 - sine * sine).sqrt();
    // h² − (2R − qκ) h + q = 0 with q = 4 sin²(α/2) (1 + κR)/κ².
    let q = d * d / (2.0 * fits * (1.0 + cosine));
    let b = 2.0 * r - q * k;
    let h = 2.0 * q / (b + (b * b - 4.0 * q).sqrt());
    (fits > 0.0 && h.is_finite() && h >= 0.0).then_some(h)
}

/// Width of the strip of the part, measured across the line of contacts, that one pass of a
/// constant-scallop path has to itself, mm: area over length of contacts. `travel` is the way of
/// the ball centre, of any length. `None` where the ball does not fit, or where `travel` runs along
/// the normal.
pub fn width_on_part_mm(radius_mm: f64, scallop_mm: f64, bend: &Principal, travel: &Vector) -> Option<f64> {
    // Inverse of M; principal curvatures are negative where convex. Where one is 0 the ball is as
    // round as the part.
    let [g1, g2] = bend.curvature.map(|k| 1.0 - k * radius_mm);
    let (a, b) = (travel.dot(&bend.direction[0]), travel.dot(&bend.direction[1]));
    let size = a.hypot(b);
    if !(g1 >= 0.0 && g2 >= 0.0 && size > 1e-6 * travel.norm()) {
        return None;
    }
    let (a, b) = (a / size, b / size);
    let curvature = -(bend.curvature[0] * b * b + bend.curvature[1] * a * a);
    let cosine = (a * a * g2 + b * b * g1) / (a * g2).hypot(b * g1);
    width_mm(radius_mm, scallop_mm, curvature).map(|w| w * cosine).filter(|w| w.is_finite())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    /// The formula as it is usually written: α from the centres' distance, then the cusp over the
    /// circle.
    fn textbook(radius: f64, d: f64, curvature: f64) -> f64 {
        if curvature == 0.0 {
            return radius - (radius * radius - 0.25 * d * d).sqrt();
        }
        let r = 1.0 / curvature.abs();
        let rho = if curvature > 0.0 { r + radius } else { r - radius };
        let alpha = (0.5 * d / rho).asin();
        let root = (radius * radius - (rho * alpha.sin()).powi(2)).sqrt();
        if curvature > 0.0 { rho * alpha.cos() - root - r } else { r - (rho * alpha.cos() + root) }.abs()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        #[test]
        fn solved_for_the_distance_it_is_the_two_ball_formula(
            radius in 0.3..10.0f64, share in 1e-4..0.05f64, bend in -0.9..20.0f64,
        ) {
            let (h, curvature) = (share * radius, bend / radius);
            let d = centre_distance_mm(radius, h, curvature).unwrap();
            prop_assert!((textbook(radius, d, curvature) - h).abs() < 1e-9 * radius, "{}", textbook(radius, d, curvature));
            prop_assert!((height_mm(radius, d, curvature).unwrap() - h).abs() < 1e-10 * radius);
            // Contacts lie on the circle at the same angle as the centres.
            let w = width_mm(radius, h, curvature).unwrap();
            let sine = (0.5 * w * curvature).sin() * (1.0 / curvature + radius);
            prop_assert!((2.0 * sine - d).abs() < 1e-9 * radius);
        }

        #[test]
        fn nothing_jumps_where_it_is_flat(radius in 0.3..10.0f64, h in 1e-3..0.05f64, tiny in -1e-7..1e-7f64) {
            let flat = 2.0 * (2.0 * radius * h - h * h).sqrt();
            prop_assert!((width_mm(radius, h, tiny).unwrap() / flat - 1.0).abs() < 1e-5);
            prop_assert!((centre_distance_mm(radius, h, 0.0).unwrap() / flat - 1.0).abs() < 1e-14);
        }

        #[test]
        fn along_a_principal_direction_the_strip_is_as_wide_as_on_the_circle_across(
            radius in 0.3..10.0f64, k1 in -0.9..5.0f64, k2 in -0.9..5.0f64, h in 1e-3..0.02f64,
        ) {
            let bend = Principal { curvature: [-k1 / radius, -k2 / radius], direction: [Vector::x(), Vector::y()] };
            let w = width_on_part_mm(radius, h, &bend, &(Vector::x() * 3.0)).unwrap();
            prop_assert!((w / width_mm(radius, h, k2 / radius).unwrap() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_ball_that_does_not_fit_has_no_width() {
        assert!(width_mm(2.0, 0.01, -0.5).is_none());
        assert!(width_mm(2.0, 0.01, f64::NAN).is_none());
        assert!(width_mm(2.0, 3.0, 0.0).is_none());
        assert!(centre_distance_mm(2.0, 0.0, 0.0).is_none());
        assert!(height_mm(2.0, 0.5, -0.6).is_none());
        assert!(height_mm(2.0, 5.0, 0.0).is_none());
    }

    /// Passes askew to the principal directions, on a saddle, a thin edge and a hollow about as
    /// round as the ball. Ball centres lie on the parallel surface of `z = −(a x² + b y²)/2`; of
    /// straight, parallel passes over it the lowest ball over the place between them is sought and
    /// compared.
    #[test]
    fn askew_passes_leave_what_is_asked_for() {
        let (radius, h) = (3.0, 1e-4);
        for [a, b] in [[0.15, -0.12], [3.0, 0.01], [-0.3, 0.02]] {
            for angle in [0.2f64, 0.7, 1.1] {
                let t = [angle.cos(), angle.sin()];
                // Near the origin, to second order: centres z = R − ½ cᵀ S M c.
                let m = [1.0 / (1.0 + a * radius), 1.0 / (1.0 + b * radius)];
                let (sa, sb) = (a * m[0], b * m[1]);
                let left = |d: f64| {
                    let height = |s: f64| {
                        let (x, y) = (s * t[0] - 0.5 * d * t[1], s * t[1] + 0.5 * d * t[0]);
                        radius - 0.5 * (sa * x * x + sb * y * y) - (radius * radius - x * x - y * y).sqrt()
                    };
                    (-4000..=4000).map(|k| height(f64::from(k) * 2e-3 * d)).fold(f64::INFINITY, f64::min)
                };
                let (mut low, mut high) = (1e-3, 1.0);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    if left(middle) < h { low = middle } else { high = middle }
                }
                // Area of the part over length of contacts, from the map of centres to contacts.
                let width = low * m[0] * m[1] / (m[0] * t[0]).hypot(m[1] * t[1]);
                let bend = Principal { curvature: [-b, -a], direction: [Vector::y(), Vector::x()] };
                let found = width_on_part_mm(radius, h, &bend, &Vector::new(t[0], t[1], 0.0)).unwrap();
                assert!((found / width - 1.0).abs() < 2e-3, "{a} {b} {angle}: {found} {width}");
            }
        }
    }

    #[test]
    fn in_a_crease_as_round_as_the_ball_the_strip_keeps_its_width() {
        let (radius, h) = (3.0, 0.01);
        let width = |hollow: f64| {
            let bend = Principal { curvature: [hollow, -0.02], direction: [Vector::y(), Vector::x()] };
            width_on_part_mm(radius, h, &bend, &Vector::new(0.99, 0.1, 0.0)).unwrap()
        };
        assert!((width(1.0 / radius) / width(0.9999 / radius) - 1.0).abs() < 0.01);
    }
}
