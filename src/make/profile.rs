//! The profile law: one section of the airfoil.
//!
//! In the chord frame, in chords, with `x` from 0 at the leading to 1 at the trailing edge:
//!
//! * camber line `y(x) = x (1 − x) [ (1 − x) tan χ1 + x tan χ2 ]`: it leaves the chord at the inlet
//!   angle χ1, returns to it at the outlet angle χ2 (a parabola where they are equal);
//! * half thickness, along the normal of the camber line, `t(x) = sqrt(x (1 − x)) g(x)` with the
//!   cubic `g` of `g(0) = sqrt(2 r_LE / (c cos χ1))`, `g(1) = sqrt(2 r_TE / (c cos χ2))`,
//!   `t(x_m) = T / 2c`, `t'(x_m) = 0` (the cosines turn lengths along the chord into lengths along
//!   the camber line).
//!
//! The square root is the circle's: with `x = (1 − cos φ)/2` it is `sin φ / 2`, so the closed
//! section
//!
//! ```text
//! P(φ) = (x, y(x)) − (sin φ / 2) g(x) (−y', 1) / sqrt(1 + y'²),   0 ≤ φ < 2π
//! ```
//!
//! is one analytic closed curve: leading edge at φ = 0, concave (pressure) side for 0 < φ < π,
//! trailing edge at φ = π, convex (suction) side back; counter-clockwise. Its curvature at the
//! edges is that of circles of the given radii. Guaranteed after [`SectionNumbers::validate`]: the
//! thickness grows up to `x_m` and falls after it.

use super::design::{AirfoilDesign, LawCurve};
use crate::error::{Error, Result, Stage};

/// One section's numbers: mm and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionNumbers {
    /// Chord, mm.
    pub chord: f64,
    /// Angle of the chord from x.
    pub stagger: f64,
    /// Tangent of the inlet angle χ1.
    pub tan_inlet: f64,
    /// Tangent of the outlet angle χ2.
    pub tan_outlet: f64,
    /// The thickness polynomial, powers of x.
    g: [f64; 4],
    /// Position on the chord that is stacked.
    stack: f64,
    /// Offset along x, mm.
    sweep: f64,
    /// Offset along y, mm.
    lean: f64,
}

fn camber(x: f64, tan_inlet: f64, tan_outlet: f64) -> [f64; 2] {
    let (a, b) = (tan_inlet, tan_outlet - tan_inlet);
    // y = x (1 − x) (a + b x)
    [x * (1.0 - x) * (a + b * x), (1.0 - 2.0 * x) * (a + b * x) + x * (1.0 - x) * b]
}

impl SectionNumbers {
    /// Half thickness over chord at `x`.
    pub fn half_thickness(&self, x: f64) -> f64 {
        (x * (1.0 - x)).max(0.0).sqrt() * self.thickness_polynomial(x)
    }

    fn thickness_polynomial(&self, x: f64) -> f64 {
        let [a, b, c, d] = self.g;
        a + x * (b + x * (c + x * d))
    }

    /// The point at φ, mm.
    pub fn point(&self, phi: f64) -> [f64; 2] {
        let (sin, cos) = phi.sin_cos();
        let x = 0.5 * (1.0 - cos);
        let [y, slope] = camber(x, self.tan_inlet, self.tan_outlet);
        let offset = -0.5 * sin * self.thickness_polynomial(x) / slope.hypot(1.0);
        let [y_stack, _] = camber(self.stack, self.tan_inlet, self.tan_outlet);
        let (px, py) = (x - slope * offset - self.stack, y + offset - y_stack);
        let (s, c) = self.stagger.sin_cos();
        [self.chord * (c * px - s * py) + self.sweep, self.chord * (s * px + c * py) + self.lean]
    }

    /// The thickness must be positive and have one maximum, where it was asked for.
    fn validate(&self, at: f64, fraction: f64) -> Result<()> {
        let n = 400;
        let t: Vec<f64> = (0..=n).map(|i| self.half_thickness(i as f64 / n as f64)).collect();
        for i in 0..n {
            let x = (i as f64 + 0.5) / n as f64;
            let grows = t[i + 1] - t[i];
            let near = (x - at).abs() < 1.5 / n as f64;
            if !near && (grows > 0.0) != (x < at) {
                return Err(Error::usage(
                    Stage::Make,
                    format!(
                        "at height fraction {fraction:.2} the thickness has a second extreme at {:.0} % of the chord",
                        100.0 * x
                    ),
                )
                .advise(
                    "bring thickness_mm, thickness_at, leading_radius_mm and trailing_radius_mm closer to an ellipse",
                ));
            }
        }
        Ok(())
    }
}

/// The sections at all heights.
#[derive(Clone, Debug)]
pub struct BladeSections {
    chord: LawCurve,
    stagger: LawCurve,
    inlet: LawCurve,
    outlet: LawCurve,
    thickness: LawCurve,
    thickness_at: LawCurve,
    leading: LawCurve,
    trailing: LawCurve,
    sweep: LawCurve,
    lean: LawCurve,
    stack: f64,
}

impl BladeSections {
    /// Checks the laws and the sections that they make.
    pub fn new(d: &AirfoilDesign) -> Result<Self> {
        let length = |law: &super::Law, key: &str| law.curve(key, 1e-3, 1e5);
        let s = BladeSections {
            chord: length(&d.chord_mm, "airfoil.chord_mm")?,
            stagger: d.stagger_deg.curve("airfoil.stagger_deg", -360.0, 360.0)?,
            inlet: d.inlet_deg.curve("airfoil.inlet_deg", -75.0, 75.0)?,
            outlet: d.outlet_deg.curve("airfoil.outlet_deg", -75.0, 75.0)?,
            thickness: length(&d.thickness_mm, "airfoil.thickness_mm")?,
            thickness_at: d.thickness_at.curve("airfoil.thickness_at", 0.15, 0.85)?,
            leading: length(&d.leading_radius_mm, "airfoil.leading_radius_mm")?,
            trailing: length(&d.trailing_radius_mm, "airfoil.trailing_radius_mm")?,
            sweep: d.sweep_mm.curve("airfoil.sweep_mm", -1e5, 1e5)?,
            lean: d.lean_mm.curve("airfoil.lean_mm", -1e5, 1e5)?,
            stack: d.stack_at,
        };
        if !(0.0..=1.0).contains(&s.stack) {
            return Err(Error::usage(Stage::Make, format!("airfoil.stack_at is {}, it must be from 0 to 1", s.stack)));
        }
        for i in 0..=20 {
            let fraction = i as f64 / 20.0;
            // A spline may leave the range of its stations.
            let least = [&s.chord, &s.thickness, &s.leading, &s.trailing].map(|l| l.at(fraction));
            if least.iter().any(|v| *v <= 0.0) || !(0.05..=0.95).contains(&s.thickness_at.at(fraction)) {
                let message =
                    format!("the splines of the airfoil's laws leave their range at height fraction {fraction:.2}");
                return Err(Error::usage(Stage::Make, message).advise("move the stations of the laws"));
            }
            s.at(fraction).validate(s.thickness_at.at(fraction), fraction)?;
        }
        Ok(s)
    }

    /// The section at a height fraction.
    pub fn at(&self, fraction: f64) -> SectionNumbers {
        let c = self.chord.at(fraction);
        let xm = self.thickness_at.at(fraction);
        let (inlet, outlet) = (self.inlet.at(fraction).to_radians(), self.outlet.at(fraction).to_radians());
        let edge = |radius: &LawCurve, angle: f64| (2.0 * radius.at(fraction) / (c * angle.cos())).sqrt();
        let (g0, g1) = (edge(&self.leading, inlet), edge(&self.trailing, outlet));
        // g = g0 (1 − x) + g1 x + x (1 − x) (a + b x) with g(xm) and g'(xm) given.
        let w = xm * (1.0 - xm);
        let gm = 0.5 * self.thickness.at(fraction) / c / w.sqrt();
        let slope = -gm * (1.0 - 2.0 * xm) / (2.0 * w);
        let s = (gm - g0 * (1.0 - xm) - g1 * xm) / w;
        let b = (slope - (g1 - g0) - (1.0 - 2.0 * xm) * s) / w;
        let a = s - b * xm;
        SectionNumbers {
            chord: c,
            stagger: self.stagger.at(fraction).to_radians(),
            tan_inlet: inlet.tan(),
            tan_outlet: outlet.tan(),
            g: [g0, g1 - g0 + a, b - a, -b],
            stack: self.stack,
            sweep: self.sweep.at(fraction),
            lean: self.lean.at(fraction),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::presets;
    use super::*;

    /// Curvature by differences; positive where the section is convex.
    fn curvature(s: &SectionNumbers, phi: f64) -> f64 {
        let h = 1e-4;
        let [a, b, c] = [phi - h, phi, phi + h].map(|p| s.point(p));
        let d = [(c[0] - a[0]) / (2.0 * h), (c[1] - a[1]) / (2.0 * h)];
        let dd = [(c[0] - 2.0 * b[0] + a[0]) / (h * h), (c[1] - 2.0 * b[1] + a[1]) / (h * h)];
        (d[0] * dd[1] - d[1] * dd[0]) / d[0].hypot(d[1]).powi(3)
    }

    fn law(v: f64) -> super::super::Law {
        super::super::Law::Constant(v)
    }

    #[test]
    fn an_ellipse_is_a_special_case() {
        // Semi-axes 20 and 4: edge radius b²/a = 0.8; no camber.
        let design = AirfoilDesign {
            chord_mm: law(40.0),
            stagger_deg: law(90.0),
            inlet_deg: law(0.0),
            outlet_deg: law(0.0),
            thickness_mm: law(8.0),
            thickness_at: law(0.5),
            leading_radius_mm: law(0.8),
            trailing_radius_mm: law(0.8),
            stack_at: 0.5,
            sweep_mm: law(1.0),
            lean_mm: law(2.0),
        };
        let s = BladeSections::new(&design).unwrap().at(0.3);
        for i in 0..50 {
            let [x, y] = s.point(0.13 * i as f64);
            assert!((((y - 2.0) / 20.0).powi(2) + ((x - 1.0) / 4.0).powi(2) - 1.0).abs() < 1e-13);
        }
        assert!((1.0 / curvature(&s, 0.0) - 0.8).abs() < 1e-5);
    }

    #[test]
    fn edges_thickness_and_angles_are_as_asked() {
        let d = presets::steam_root().airfoil.unwrap();
        let s = BladeSections::new(&d).unwrap().at(0.0);
        let c = s.chord;
        let LawCurve::Spline(_) = d.chord_mm.curve("c", 0.0, 1e3).unwrap() else { panic!("a law of height") };
        let first = |l: &super::super::Law| l.curve("l", -1e3, 1e3).unwrap().at(0.0);
        let xm = first(&d.thickness_at);
        assert!((2.0 * c * s.half_thickness(xm) - first(&d.thickness_mm)).abs() < 1e-12);
        assert!((1.0 / curvature(&s, 0.0) / first(&d.leading_radius_mm) - 1.0).abs() < 1e-4);
        assert!((1.0 / curvature(&s, std::f64::consts::PI) / first(&d.trailing_radius_mm) - 1.0).abs() < 1e-4);
        let [_, slope] = camber(0.0, s.tan_inlet, s.tan_outlet);
        assert!((slope.atan().to_degrees() - first(&d.inlet_deg)).abs() < 1e-12);
    }

    #[test]
    fn turbine_sections_have_one_concave_stretch() {
        for design in [presets::steam_root(), presets::turbine_camber()] {
            let s = BladeSections::new(design.airfoil.as_ref().unwrap()).unwrap();
            for fraction in [0.0, 0.5, 1.0] {
                let section = s.at(fraction);
                let signs: Vec<bool> =
                    (0..720).map(|i| curvature(&section, i as f64 * std::f64::consts::TAU / 720.0) > 0.0).collect();
                let changes = (0..720).filter(|&i| signs[i] != signs[(i + 1) % 720]).count();
                let concave: Vec<usize> = (0..720).filter(|&i| !signs[i]).collect();
                assert!(changes == 2 && concave.iter().all(|&i| i < 360), "{} {fraction}: {changes}", design.name);
            }
        }
    }

    #[test]
    fn a_waisted_section_is_refused() {
        let mut d = presets::steam_root().airfoil.unwrap();
        d.leading_radius_mm = law(15.0);
        assert!(BladeSections::new(&d).unwrap_err().message.contains("second extreme"));
    }
}
