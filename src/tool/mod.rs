//! The tool as a profile of revolution: ball, taper, shank, holder stages.
//!
//! Heights `z` run from the ball centre along the tool axis towards the spindle, mm. The cone
//! leaves the ball tangentially at `z = R sin τ` with radius `R cos τ` (τ: taper half-angle), grows
//! to the shank radius, goes on as a cylinder up to the stick-out and is followed by the holder's
//! stages.

pub mod catalogue;
pub mod scallop;

use crate::artifact::ToolPart;
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::settings::in_words;

/// Room that taper and shank keep from a part where nobody asks for another, mm.
pub const CLEARANCE_MM: f64 = 0.1;
/// Room that the holder keeps from a part where nobody asks for another, mm.
pub const HOLDER_CLEARANCE_MM: f64 = 1.0;

/// A cylindrical stage of the holder.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HolderStage {
    /// Radius, mm.
    pub radius_mm: f64,
    /// Length, mm.
    pub length_mm: f64,
}

/// A ball-end tool in its holder.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Half angle of the cone behind the ball, degrees; 0: cylinder.
    pub taper_deg: f64,
    /// Radius of the shank, at which the cone ends, mm; at least `radius_mm · cos(taper)`.
    pub shank_radius_mm: f64,
    /// From the ball centre to the first holder stage, mm.
    pub stickout_mm: f64,
    /// Holder stages from the cutter towards the spindle.
    pub holder: Vec<HolderStage>,
}

/// A cone frustum of the profile: radius `r0` at height `z0` to `r1` at `z1`, `z0 < z1`, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Which part of the tool.
    pub part: ToolPart,
    /// Lower height over the ball centre, mm.
    pub z0: f64,
    /// Upper height, mm.
    pub z1: f64,
    /// Radius at `z0`, mm.
    pub r0: f64,
    /// Radius at `z1`, mm.
    pub r1: f64,
}

impl Tool {
    /// Reads the text of a tool file: TOML with the keys of this type, or with a table `[tool]` of them, so that a resolved job
    /// will do; `origin` names it in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, or a value out of its range.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let bad = |what: &str| {
            let what = what.trim().replace('\n', " ");
            Error::usage(Stage::Job, format!("{origin}: {what}")).advise(
                "a tool file has radius_mm, taper_deg, shank_radius_mm, stickout_mm (from the ball centre) and holder = \
                 [{ radius_mm = …, length_mm = … }]; job.resolved.toml of any run will do",
            )
        };
        let mut table: toml::Table = toml::from_str(text).map_err(|e| bad(&in_words(&e)))?;
        let own = match table.remove("tool") {
            Some(toml::Value::Table(tool)) => tool,
            Some(_) => return Err(bad("`tool` is not a table")),
            None => table,
        };
        let tool: Tool = own.try_into().map_err(|e: toml::de::Error| bad(&in_words(&e)))?;
        tool.validate()?;
        Ok(tool)
    }

    /// Checks all values.
    ///
    /// # Errors
    /// Kind `Usage`, naming the key and its limit.
    pub fn validate(&self) -> Result<()> {
        let bad = |m: String| Err(Error::usage(Stage::Job, m));
        if !(self.radius_mm > 0.0 && self.radius_mm.is_finite()) {
            return bad(format!("tool.radius_mm is {}, it must be greater than 0", self.radius_mm));
        }
        if !(0.0..45.0).contains(&self.taper_deg) {
            return bad(format!("tool.taper_deg is {}, it must be at least 0 and less than 45", self.taper_deg));
        }
        let r0 = self.radius_mm * self.taper_deg.to_radians().cos();
        if !(self.shank_radius_mm >= r0 - 1e-9 && self.shank_radius_mm.is_finite()) {
            return bad(format!(
                "tool.shank_radius_mm is {}, it must be at least {r0} (the cone's radius where it leaves the ball)",
                self.shank_radius_mm
            ));
        }
        if !(self.stickout_mm > self.radius_mm && self.stickout_mm.is_finite()) {
            return bad(format!("tool.stickout_mm is {}, it must be greater than the ball radius", self.stickout_mm));
        }
        for (i, h) in self.holder.iter().enumerate() {
            if !(h.radius_mm > 0.0 && h.length_mm > 0.0 && h.radius_mm.is_finite() && h.length_mm.is_finite()) {
                return bad(format!(
                    "tool.holder stage {} has radius {} and length {}, both must be greater than 0",
                    i + 1,
                    h.radius_mm,
                    h.length_mm
                ));
            }
        }
        Ok(())
    }

    /// The profile above the ball, from cutter to spindle: consecutive frusta without gaps.
    pub fn segments(&self) -> Vec<Segment> {
        let tau = self.taper_deg.to_radians();
        let (z0, r0) = (self.radius_mm * tau.sin(), self.radius_mm * tau.cos());
        let cone_end =
            if tau > 0.0 { (z0 + (self.shank_radius_mm - r0) / tau.tan()).min(self.stickout_mm) } else { z0 };
        let mut out = Vec::new();
        let mut push = |part: ToolPart, z0: f64, z1: f64, r0: f64, r1: f64| {
            if z1 > z0 {
                out.push(Segment { part, z0, z1, r0, r1 });
            }
        };
        push(ToolPart::Taper, z0, cone_end, r0, r0 + (cone_end - z0) * tau.tan());
        // Without taper the cutter's own cylinder goes on: there is no cone that could reach the
        // shank's radius.
        let shank = if tau > 0.0 { self.shank_radius_mm } else { r0 };
        push(ToolPart::Shank, cone_end, self.stickout_mm, shank, shank);
        let mut z = self.stickout_mm;
        for (stage, h) in (1..).zip(&self.holder) {
            push(ToolPart::Holder(stage), z, z + h.length_mm, h.radius_mm, h.radius_mm);
            z += h.length_mm;
        }
        out
    }

    /// The profile above the ball in two: taper and shank, and the holder. Each keeps a clearance of its own.
    pub fn cutter_and_holder(&self) -> [Vec<Segment>; 2] {
        let (holder, cutter) = self.segments().into_iter().partition(|s| s.part.is_holder());
        [cutter, holder]
    }

    /// Length from the ball centre to the end of the last holder stage, mm.
    pub fn length_mm(&self) -> f64 {
        self.stickout_mm + self.holder.iter().map(|h| h.length_mm).sum::<f64>()
    }
}

/// The tool axis, from tip to spindle, in the blade frame: `(sin B, cos B cos θ, cos B sin θ)`.
pub fn axis(b_rad: f64, theta_rad: f64) -> Vector {
    let (sb, cb) = b_rad.sin_cos();
    let (st, ct) = theta_rad.sin_cos();
    Vector::new(sb, cb * ct, cb * st)
}

/// The tool tip that belongs to a ball centre, mm.
pub fn tip(centre: &Point, axis: &Vector, radius_mm: f64) -> Point {
    centre - axis * radius_mm
}
