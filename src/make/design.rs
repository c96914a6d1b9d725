//! What a blade is made from, as typed: a TOML file with units in its keys.

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result, Stage};
use crate::numerics::spline::{CubicSpline, SplineEnds};
use crate::settings::from_toml;

/// A blade: exactly one of `airfoil` and `prism`, on a platform with a root. The blade stands along
/// +z:
/// root below, tip above.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BladeDesign {
    /// Name, written into the files.
    pub name: String,
    /// From the platform to the flat tip, mm.
    pub height_mm: f64,
    /// Radius of the ball that rolls in the corner between airfoil and platform, mm. 0 (prism
    /// only): a sharp corner.
    pub fillet_radius_mm: f64,
    /// A free-form airfoil.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub airfoil: Option<AirfoilDesign>,
    /// A straight stadium or circular cylinder, exact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub prism: Option<PrismDesign>,
    /// The block that carries the airfoil.
    pub platform: PlatformDesign,
    /// How finely the free-form surfaces are interpolated and the mesh is divided.
    #[serde(default)]
    pub accuracy: Accuracy,
}

/// A quantity along the height: one number, or stations `[height fraction, value]` from 0 at the
/// platform to 1 at the tip (two: linear; more: natural cubic spline).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged, expecting = "a number is wanted, or a list of [height fraction, value]")]
pub enum Law {
    /// The same at all heights.
    Constant(f64),
    /// `[height fraction, value]`.
    Stations(Vec<[f64; 2]>),
}

/// The airfoil's sections as laws of height; see [`super::profile`] for what they mean.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AirfoilDesign {
    /// Chord, mm.
    pub chord_mm: Law,
    /// Angle of the chord from x, leading to trailing edge, positive towards y, degrees.
    pub stagger_deg: Law,
    /// Angle between camber line and chord at the leading edge, degrees.
    pub inlet_deg: Law,
    /// Angle between chord and camber line at the trailing edge, degrees; inlet + outlet is the
    /// turning.
    pub outlet_deg: Law,
    /// Greatest thickness, mm.
    pub thickness_mm: Law,
    /// Where the greatest thickness is, fraction of the chord.
    pub thickness_at: Law,
    /// Radius of the leading edge, mm.
    pub leading_radius_mm: Law,
    /// Radius of the trailing edge, mm.
    pub trailing_radius_mm: Law,
    /// The camber line's point at this fraction of the chord is on the stacking axis.
    #[serde(default = "half")]
    pub stack_at: f64,
    /// Offset of the section along x, mm.
    #[serde(default = "zero")]
    pub sweep_mm: Law,
    /// Offset of the section along y, mm.
    #[serde(default = "zero")]
    pub lean_mm: Law,
}

/// A prism whose section is a stadium: two half circles joined by straight sides along x; with
/// equal `length_mm` and `width_mm` a circle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrismDesign {
    /// Over both ends, mm.
    pub length_mm: f64,
    /// Between the straight sides, mm.
    pub width_mm: f64,
    /// Angle of its length from x, degrees.
    #[serde(default)]
    pub stagger_deg: f64,
}

/// Platform and root: one polygon across the blade, drawn along x.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlatformDesign {
    /// Along x, mm.
    pub length_mm: f64,
    /// z of its top, mm.
    #[serde(default)]
    pub top_z_mm: f64,
    /// Angle of its long sides from x, degrees: 0 a rectangle, else a parallelogram.
    #[serde(default)]
    pub shear_deg: f64,
    /// Offset of its centre from the stacking axis along x, mm.
    #[serde(default)]
    pub offset_x_mm: f64,
    /// Offset of its centre from the stacking axis along y, mm.
    #[serde(default)]
    pub offset_y_mm: f64,
    /// The outline across, from the top down, the same on both sides: platform, then root (a plain
    /// shank, a dovetail, a fir tree).
    pub outline: Vec<OutlinePoint>,
}

/// A corner of the outline of platform and root.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutlinePoint {
    /// Below the platform's top, mm; 0 for the first.
    pub depth_mm: f64,
    /// Half the width along y there, mm.
    pub half_width_mm: f64,
}

/// How finely the free-form surfaces are interpolated and the mesh is divided.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Accuracy {
    /// Stations round the section; even.
    pub stations: usize,
    /// Rows from fillet to tip.
    pub rows: usize,
    /// Greatest distance between mesh and surfaces, mm.
    pub deflection_mm: f64,
}

impl Default for Accuracy {
    fn default() -> Self {
        Accuracy { stations: 128, rows: 24, deflection_mm: 0.01 }
    }
}

fn zero() -> Law {
    Law::Constant(0.0)
}

fn half() -> f64 {
    0.5
}

fn wrong(what: &str, value: f64, limit: &str) -> Error {
    Error::usage(Stage::Make, format!("{what} is {value}, it must be {limit}")).advise("correct the design file")
}

fn within(what: &str, value: f64, min: f64, max: f64) -> Result<()> {
    if value.is_finite() && value >= min && value <= max {
        Ok(())
    } else {
        Err(wrong(what, value, &format!("from {min} to {max}")))
    }
}

/// Smallest and greatest length that a design may hold, mm.
const LENGTH_MM: [f64; 2] = [1e-3, 1e5];

impl Law {
    /// The law as a function of the height fraction; errors name it by `key`.
    pub(super) fn curve(&self, key: &str, min: f64, max: f64) -> Result<LawCurve> {
        match self {
            Law::Constant(value) => {
                within(key, *value, min, max)?;
                Ok(LawCurve::Constant(*value))
            }
            Law::Stations(stations) => {
                for s in stations {
                    within(&format!("height fraction of {key}"), s[0], 0.0, 1.0)?;
                    within(key, s[1], min, max)?;
                }
                let (x, y): (Vec<f64>, Vec<f64>) = stations.iter().map(|s| (s[0], s[1])).unzip();
                CubicSpline::new(&x, &y, 1, &SplineEnds::Natural).map(LawCurve::Spline).map_err(|e| {
                    Error::usage(Stage::Make, format!("the stations of {key} make no curve"))
                        .advise("give at least two, with increasing height fractions")
                        .caused_by(e)
                })
            }
        }
    }
}

/// A validated [`Law`].
#[derive(Clone, Debug)]
pub(super) enum LawCurve {
    Constant(f64),
    Spline(CubicSpline),
}

impl LawCurve {
    pub(super) fn at(&self, fraction: f64) -> f64 {
        match self {
            LawCurve::Constant(value) => *value,
            LawCurve::Spline(spline) => spline.value(fraction, 0),
        }
    }
}

impl BladeDesign {
    /// Reads a design file; unknown keys and impossible values are errors that name the key.
    pub fn from_toml(text: &str) -> Result<Self> {
        let design: BladeDesign = from_toml(text).map_err(|e| {
            Error::usage(Stage::Make, format!("the design file is not understood: {}", e.words))
                .advise("compare with the design files in models/")
                .caused_by(e)
        })?;
        design.validate()?;
        Ok(design)
    }

    /// The design as a file.
    pub fn to_toml(&self) -> Result<String> {
        toml::to_string(self)
            .map_err(|e| Error::usage(Stage::Make, "the design cannot be written as TOML").caused_by(e))
    }

    /// Checks all that can be checked without building the blade.
    pub fn validate(&self) -> Result<()> {
        let [min, max] = LENGTH_MM;
        if self.name.is_empty() || !self.name.chars().all(|c| c.is_ascii_alphanumeric() || "_-. ".contains(c)) {
            return Err(Error::usage(Stage::Make, format!("name '{}' is empty or has special characters", self.name))
                .advise("use letters, digits, space, '_', '-' and '.'"));
        }
        within("height_mm", self.height_mm, min, max)?;
        within("fillet_radius_mm", self.fillet_radius_mm, 0.0, max)?;
        if self.fillet_radius_mm >= 0.9 * self.height_mm {
            return Err(wrong("fillet_radius_mm", self.fillet_radius_mm, "less than 0.9 height_mm"));
        }
        match (&self.airfoil, &self.prism) {
            (Some(_), None) => within("fillet_radius_mm of an airfoil", self.fillet_radius_mm, min, max)?,
            (None, Some(p)) => {
                within("prism.length_mm", p.length_mm, min, max)?;
                within("prism.width_mm", p.width_mm, min, p.length_mm)?;
                within("prism.stagger_deg", p.stagger_deg, -360.0, 360.0)?;
            }
            _ => {
                return Err(Error::usage(Stage::Make, "a design needs exactly one of [airfoil] and [prism]")
                    .advise("remove or add one"));
            }
        }
        self.platform.validate()?;
        let a = &self.accuracy;
        if !(16..=1024).contains(&a.stations) || !a.stations.is_multiple_of(2) {
            return Err(wrong("accuracy.stations", a.stations as f64, "even, from 16 to 1024"));
        }
        within("accuracy.rows", a.rows as f64, 4.0, 256.0)?;
        within("accuracy.deflection_mm", a.deflection_mm, 1e-4, 10.0)
    }
}

impl PlatformDesign {
    fn validate(&self) -> Result<()> {
        let [min, max] = LENGTH_MM;
        within("platform.length_mm", self.length_mm, min, max)?;
        within("platform.top_z_mm", self.top_z_mm, -max, max)?;
        within("platform.shear_deg", self.shear_deg, -60.0, 60.0)?;
        within("platform.offset_x_mm", self.offset_x_mm, -max, max)?;
        within("platform.offset_y_mm", self.offset_y_mm, -max, max)?;
        if self.outline.len() < 2 {
            return Err(Error::usage(Stage::Make, "platform.outline has fewer than 2 points")
                .advise("give the platform's top (depth 0) and at least one point below it"));
        }
        within("first platform.outline.depth_mm", self.outline[0].depth_mm, 0.0, 0.0)?;
        for (i, p) in self.outline.iter().enumerate() {
            within("platform.outline.depth_mm", p.depth_mm, 0.0, max)?;
            within("platform.outline.half_width_mm", p.half_width_mm, min, max)?;
            let level = |a: &OutlinePoint, b: &OutlinePoint| b.depth_mm - a.depth_mm < min;
            let before = i.checked_sub(1).map(|j| &self.outline[j]);
            let falls = before.is_none_or(|b| p.depth_mm >= b.depth_mm);
            let moves = before.is_none_or(|b| !level(b, p) || (b.half_width_mm - p.half_width_mm).abs() >= min);
            let simple = i < 2 || !level(&self.outline[i - 2], p);
            if !(falls && moves && simple) {
                return Err(wrong("platform.outline.depth_mm", p.depth_mm, "deeper than the points before it")
                    .advise("depths must not decrease; two successive points may be level (a step), three may not"));
            }
        }
        let (n, first_step) = (self.outline.len(), self.outline[1].depth_mm);
        if first_step < min || self.outline[n - 1].depth_mm - self.outline[n - 2].depth_mm < min {
            return Err(wrong(
                "platform.outline.depth_mm",
                first_step,
                "different between the first two and the last two points",
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::presets;
    use super::*;

    #[test]
    fn presets_are_valid_and_survive_toml() {
        for (kind, make) in presets::ALL {
            let design = make();
            design.validate().unwrap();
            assert_eq!(BladeDesign::from_toml(&design.to_toml().unwrap()).unwrap(), design, "{kind}");
        }
    }

    #[test]
    fn wrong_designs_are_refused_by_name() {
        let text = presets::steam_root().to_toml().unwrap();
        let refused = |from: &str, to: &str, names: &str| {
            assert!(text.contains(from), "{from}");
            let e = BladeDesign::from_toml(&text.replacen(from, to, 1)).unwrap_err();
            assert!(e.message.contains(names), "{e}");
        };
        refused("height_mm = ", "heigth_mm = ", "heigth_mm");
        refused("height_mm = 2", "height_mm = -2", "height_mm");
        refused("height_mm = 2", "height_mm = nan #", "height_mm");
        refused("[airfoil]", "[prism]\nlength_mm = 3.0\nwidth_mm = 2.0\n[airfoil]", "exactly one");
        refused("stations = ", "stations = 1", "stations");
        refused("depth_mm = 0.0", "depth_mm = 1.0", "depth_mm");
        refused("shear_deg = ", "shear_deg = 8", "shear_deg");
    }

    #[test]
    fn laws_are_constant_linear_or_splines() {
        let c = |l: Law| l.curve("k", -10.0, 10.0);
        assert_eq!(c(Law::Constant(3.0)).unwrap().at(0.7), 3.0);
        assert!((c(Law::Stations(vec![[0.0, 1.0], [1.0, 3.0]])).unwrap().at(0.25) - 1.5).abs() < 1e-14);
        assert!((c(Law::Stations(vec![[0.0, 1.0], [0.5, 4.0], [1.0, 3.0]])).unwrap().at(0.5) - 4.0).abs() < 1e-14);
        assert!(c(Law::Stations(vec![[0.0, 1.0]])).is_err());
        assert!(c(Law::Stations(vec![[0.5, 1.0], [0.5, 2.0]])).is_err());
        assert!(c(Law::Constant(11.0)).is_err());
    }
}
