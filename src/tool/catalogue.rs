//! Cutters and chucks that can be bought, from `models/tools/cutters.toml`: what a job without a
//! tool of its own chooses from.

use super::HolderStage;
use crate::error::{Error, Result, Stage};
use crate::settings::from_toml;

/// The built-in catalogue.
const BUILT_IN: &str = include_str!("../../models/tools/cutters.toml");
/// A cutter sticks out by at most so many diameters of its shank: more is bought nowhere, and
/// bends.
const MOST_SLENDER: f64 = 10.0;
/// Half angle of a shrink-fit chuck's cone, degrees.
const CHUCK_CONE_DEG: f64 = 4.5;
/// Shanks thicker than any chuck of the catalogue get one this many times as wide …
const BEYOND_WIDE: f64 = 1.7;
/// … and this many times as long.
const BEYOND_LONG: f64 = 3.0;

/// A ball-end cutter, conical behind the ball.
#[derive(Clone, Debug, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cutter {
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Half angle of the cone behind the ball, degrees.
    pub taper_deg: f64,
    /// Diameters of the shanks that it is sold on, mm, rising.
    pub shank_diameters_mm: Vec<f64>,
}

/// A chuck for one shank.
#[derive(Clone, Debug, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chuck {
    /// Diameter of the shank, mm.
    pub shank_diameter_mm: f64,
    /// Diameter at the nose, mm.
    pub nose_diameter_mm: f64,
    /// Diameter of the body behind the cone, mm.
    pub body_diameter_mm: f64,
    /// Length before the flange of the spindle's taper, mm.
    pub length_mm: f64,
}

/// All cutters and chucks, by rising size.
#[derive(Clone, Debug, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Catalogue {
    /// Cutters by rising ball radius.
    pub cutter: Vec<Cutter>,
    /// Chucks by rising shank.
    pub chuck: Vec<Chuck>,
}

impl Cutter {
    /// The farthest that it sticks out of its chuck, mm.
    pub fn longest_mm(&self) -> f64 {
        MOST_SLENDER * self.shank_diameters_mm.last().copied().unwrap_or(0.0)
    }

    /// Diameter of the thinnest shank that is stiff enough for this stick-out, mm, or of the
    /// thickest.
    pub fn shank_for(&self, stickout_mm: f64) -> f64 {
        let stiff = self.shank_diameters_mm.iter().find(|d| MOST_SLENDER * **d >= stickout_mm);
        stiff.or(self.shank_diameters_mm.last()).copied().unwrap_or(2.0 * self.radius_mm)
    }
}

impl Chuck {
    /// The holder's stages: the cone by its radius half-way on its first half, which is nowhere
    /// thinner than the cone, then the body.
    pub fn stages(&self) -> Vec<HolderStage> {
        let (nose, body) = (0.5 * self.nose_diameter_mm, 0.5 * self.body_diameter_mm);
        let half_cone = (0.5 * (body - nose) / CHUCK_CONE_DEG.to_radians().tan()).min(0.5 * self.length_mm);
        // To a whole millimetre, upwards in radius and downwards in length: short numbers read
        // better, and are on the safe side.
        let first = HolderStage { radius_mm: (nose + body).ceil() * 0.5, length_mm: half_cone.floor() };
        let rest = HolderStage { radius_mm: body, length_mm: self.length_mm - first.length_mm };
        vec![first, rest]
    }
}

impl Catalogue {
    /// The catalogue of `models/tools/cutters.toml`.
    ///
    /// # Errors
    /// None for the built-in file, which a test reads.
    pub fn built_in() -> Result<Self> {
        from_toml(BUILT_IN).map_err(|e| Error::usage(Stage::Job, format!("models/tools/cutters.toml: {}", e.words)))
    }

    /// The cutter for a ball that need not be in the catalogue: the smallest with a ball as large,
    /// else one as it would be.
    pub fn cutter_for(&self, radius_mm: f64) -> Cutter {
        let own = |c: &&Cutter| c.radius_mm >= radius_mm * (1.0 - 1e-9);
        self.cutter.iter().find(own).cloned().unwrap_or_else(|| Cutter {
            radius_mm,
            taper_deg: 4.0,
            shank_diameters_mm: vec![(3.0 * radius_mm).ceil()],
        })
    }

    /// The chuck for a shank: the smallest that takes it, else one as it would be.
    pub fn chuck_for(&self, shank_diameter_mm: f64) -> Chuck {
        let takes = |c: &&Chuck| c.shank_diameter_mm >= shank_diameter_mm * (1.0 - 1e-9);
        self.chuck.iter().find(takes).cloned().unwrap_or_else(|| {
            let wide = (BEYOND_WIDE * shank_diameter_mm).ceil();
            Chuck {
                shank_diameter_mm,
                nose_diameter_mm: wide,
                body_diameter_mm: wide + 9.0,
                length_mm: (BEYOND_LONG * shank_diameter_mm).ceil(),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::tool::Tool;

    /// Every combination is a tool, thicker from the ball to the holder, and no more slender than
    /// can be bought.
    #[test]
    fn everything_in_the_catalogue_fits_together() {
        let catalogue = Catalogue::built_in().unwrap();
        assert!(catalogue.cutter.windows(2).all(|w| w[0].radius_mm < w[1].radius_mm));
        assert!(catalogue.chuck.windows(2).all(|w| w[0].shank_diameter_mm < w[1].shank_diameter_mm));
        for cutter in &catalogue.cutter {
            assert!(cutter.shank_diameters_mm.windows(2).all(|w| w[0] < w[1]));
            for shank in &cutter.shank_diameters_mm {
                let chuck = catalogue.chuck_for(*shank);
                assert_eq!(chuck.shank_diameter_mm, *shank, "R {} has a shank without a chuck", cutter.radius_mm);
                let tool = Tool {
                    radius_mm: cutter.radius_mm,
                    corner_radius_mm: None,
                    taper_deg: cutter.taper_deg,
                    shank_radius_mm: 0.5 * shank,
                    stickout_mm: MOST_SLENDER * shank,
                    holder: chuck.stages(),
                };
                tool.validate().unwrap();
                assert!(tool.radius_mm < tool.shank_radius_mm);
                assert!(tool.holder.iter().all(|h| h.radius_mm >= 0.5 * chuck.nose_diameter_mm && h.length_mm >= 10.0));
                assert!(tool.holder.windows(2).all(|w| w[0].radius_mm <= w[1].radius_mm));
                // Where the first stage ends the cone is no thicker than it.
                let cone = 0.5 * chuck.nose_diameter_mm + tool.holder[0].length_mm * CHUCK_CONE_DEG.to_radians().tan();
                assert!(cone <= tool.holder[0].radius_mm, "{chuck:?}");
                let length: f64 = tool.holder.iter().map(|h| h.length_mm).sum();
                assert!((length - chuck.length_mm).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_longer_cutter_has_a_thicker_shank() {
        let catalogue = Catalogue::built_in().unwrap();
        let cutter = catalogue.cutter_for(1.9);
        assert_eq!(cutter.radius_mm, 2.0);
        assert_eq!([30.0, 60.0, 61.0, 120.0, 500.0].map(|s| cutter.shank_for(s)), [6.0, 6.0, 8.0, 12.0, 12.0]);
        assert_eq!(cutter.longest_mm(), 120.0);
        // Beyond the catalogue.
        let large = catalogue.cutter_for(20.0);
        assert_eq!((large.radius_mm, large.shank_for(100.0)), (20.0, 60.0));
        assert!(catalogue.chuck_for(60.0).nose_diameter_mm > 60.0);
    }
}
