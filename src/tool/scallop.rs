//! What two neighbouring passes of a ball leave between them, in closed form, and how far apart they may lie.
//!
//! Two balls of radius `R` touch a circle of signed curvature `κ = 1/r` (positive: convex towards the ball, negative: concave,
//! 0: flat). Their centres lie `r + R` from the circle's middle, an angle `2α` apart, and they meet in a cusp at `r + h`. The law
//! of cosines, written so that nothing cancels where `κ` is small:
//! ```text
//! sin²(α/2) = y²,  y = κ x / 2,  x² = h (2R − h) / ((1 + κR)(1 + κh))
//! contacts on the circle  W = 2 r α        = 4 asin(y) / κ        → 2x where it is flat
//! ball centres            d = 2 (r + R) sin α = 2 (1 + κR) x sqrt(1 − y²)
//! ```
//! This is the two-ball construction `h = |(r + R) cos α ∓ sqrt(R² − (r + R)² sin² α) − r|` solved for `d`. It holds as long as
//! the ball fits: `1 + κR > 0`.
//!
//! On a surface ([`width_on_part_mm`]) the curvature that counts is that of the surface of ball centres across the way of the
//! ball, since the passes are swept along that way. With `S` the part's shape operator (convex positive) and `M = (I + R S)⁻¹`,
//! the surface of centres has `I/R − S_c = M/R`; with unit vectors `t` along the way of the centre and `w` across it,
//! `κ = (1/(wᵀMw) − 1)/R`. Areas shrink from there to the part by `det M` and lengths along the pass by `|M t|`.

use crate::geometry::Vector;
use crate::geometry::nurbs::Principal;

/// `x` of the module's page, mm; `None` where the ball does not fit or an argument is out of its limits.
fn half_chord(radius_mm: f64, scallop_mm: f64, curvature_per_mm: f64) -> Option<f64> {
    let (r, h, k) = (radius_mm, scallop_mm, curvature_per_mm);
    let fits = (1.0 + k * r) * (1.0 + k * h);
    let x = (h * (2.0 * r - h) / fits).sqrt();
    (r > 0.0 && h > 0.0 && h < r && 1.0 + k * r > 0.0 && x.is_finite()).then_some(x)
}

/// Distance along the part between the contacts of two passes that leave the scallop `scallop_mm`, mm; `None` where a ball
/// of this radius does not fit into the curvature.
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

/// Scallop that two balls leave whose centres are `distance_mm` apart, mm; `None` where they do not fit or do not meet over the
/// part.
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

/// Width of the strip of the part, measured across the line of contacts, that one pass of a constant-scallop path has to itself,
/// mm: area over length of contacts. `travel` is the way of the ball centre, of any length. `None` where the ball does not fit,
/// or where `travel` runs along the normal.
pub fn width_on_part_mm(radius_mm: f64, scallop_mm: f64, bend: &Principal, travel: &Vector) -> Option<f64> {
    // Principal curvatures are negative where convex.
    let [m1, m2] = bend.curvature.map(|k| 1.0 / (1.0 - k * radius_mm));
    if !(m1 > 0.0 && m2 > 0.0 && m1.is_finite() && m2.is_finite()) {
        return None;
    }
    let (a, b) = (travel.dot(&bend.direction[0]), travel.dot(&bend.direction[1]));
    let size = a.hypot(b);
    if !(size > 1e-6 * travel.norm()) {
        return None;
    }
    let (a, b) = (a / size, b / size);
    let across = m1 * b * b + m2 * a * a;
    let along = (m1 * a).hypot(m2 * b);
    let curvature = (1.0 / across - 1.0) / radius_mm;
    Some(width_mm(radius_mm, scallop_mm, curvature)? * m1 * m2 / (across * along))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use proptest::prelude::*;

    /// The formula as it is usually written: α from the centres' distance, then the cusp over the circle.
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

    /// Passes askew to the principal directions of a saddle: the surface itself decides. Ball centres lie on the parallel surface of
    /// `z = −(a x² + b y²)/2`; of straight, parallel passes through it the ridge over the part is measured and compared.
    #[test]
    fn askew_passes_on_a_saddle_leave_what_is_asked_for() {
        let (radius, h) = (3.0, 1e-4);
        let (a, b) = (0.15, -0.12);
        for angle in [0.2f64, 0.7, 1.1] {
            let t = [angle.cos(), angle.sin()];
            // Near the origin, to second order: centres z = R − ½ cᵀ S M c.
            let (sa, sb) = (a / (1.0 + a * radius), b / (1.0 + b * radius));
            let across = [-t[1], t[0]];
            let bend_c = sa * across[0] * across[0] + sb * across[1] * across[1];
            let m = [1.0 / (1.0 + a * radius), 1.0 / (1.0 + b * radius)];
            // A pass half a distance away on either side, seen along its way: circles about (±d/2, −bend d²/8) leave h at 0.
            let d = (8.0 * h / (1.0 / radius - bend_c)).sqrt();
            let left = radius - bend_c * d * d / 8.0 - (radius * radius - 0.25 * d * d).sqrt();
            assert!((left / h - 1.0).abs() < 1e-3);
            // Area of the part over length of contacts, from the map of centres to contacts.
            let width = d * m[0] * m[1] / (m[0] * t[0]).hypot(m[1] * t[1]);
            let bend = Principal { curvature: [-b, -a], direction: [Vector::y(), Vector::x()] };
            let found = width_on_part_mm(radius, h, &bend, &Vector::new(t[0], t[1], 0.0)).unwrap();
            assert!((found / width - 1.0).abs() < 1e-3, "{found} {width}");
        }
    }
}
