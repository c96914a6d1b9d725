//! The tool as a profile of revolution: ball, taper, shank, holder stages.
//!
//! Heights `z` run from the ball centre along the tool axis towards the spindle, mm. The cone
//! leaves the ball tangentially at `z = R sin τ` with radius `R cos τ` (τ: taper half-angle), grows
//! to the shank radius, goes on as a cylinder up to the stick-out and is followed by the holder's
//! stages.
//!
//! A bull-nose or flat cutter of radius `R` has a corner of radius `r < R` instead of a ball: a
//! disc of radius `R − r` with a ball of radius `r` rolled over it ([`contact`]). Its heights run
//! from the disc's centre, which lies `r` over the tip; the cone leaves the corner at `z = r sin τ`
//! with radius `R − r + r cos τ`. What is called ball centre elsewhere is the disc's.

pub mod catalogue;
pub mod chip;
pub mod contact;
pub mod inclination;
pub mod scallop;
pub mod stepover;

pub use chip::{Chip, CutKeys, CutSettings};

use crate::artifact::ToolPart;
use crate::error::{Error, Result, Stage};
use crate::geometry::{Point, Vector};
use crate::settings::{from_toml, from_value};

/// Room that taper and shank keep from a part where nobody asks for another, mm.
pub const CLEARANCE_MM: f64 = 0.1;
/// Room that the holder keeps from a part where nobody asks for another, mm.
pub const HOLDER_CLEARANCE_MM: f64 = 1.0;

/// Least corner radius of a cutter that is no ball, mm: flat end mills that are sold have as much.
pub const LEAST_CORNER_MM: f64 = 0.05;

/// A cylindrical stage of the holder.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HolderStage {
    /// Radius, mm.
    pub radius_mm: f64,
    /// Length, mm.
    pub length_mm: f64,
}

/// A tool in its holder: with a ball end, or with a corner.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tool {
    /// Radius of the cutter, mm: a ball's own.
    pub radius_mm: f64,
    /// Radius of the corner of a bull-nose or flat cutter, mm, less than `radius_mm`; `None`: a
    /// ball.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corner_radius_mm: Option<f64>,
    /// Half angle of the cone behind the ball or corner, degrees; 0: cylinder.
    pub taper_deg: f64,
    /// Radius of the shank, at which the cone ends, mm; at least that of the cone where it leaves
    /// ball or corner.
    pub shank_radius_mm: f64,
    /// From the centre of the ball, or of the corner's arc, to the first holder stage, mm.
    pub stickout_mm: f64,
    /// Holder stages from the cutter towards the spindle.
    pub holder: Vec<HolderStage>,
}

/// A cone frustum of the profile: radius `r0` at height `z0` to `r1` at `z1`, `z0 < z1`, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Which part of the tool.
    pub part: ToolPart,
    /// Lower height over the centre of ball or disc, mm.
    pub z0: f64,
    /// Upper height, mm.
    pub z1: f64,
    /// Radius at `z0`, mm.
    pub r0: f64,
    /// Radius at `z1`, mm.
    pub r1: f64,
}

/// Where along a unit direction a tool ends, mm: of ball and frusta the lowest place. `centre`: of
/// the ball, `radius_mm` its radius, `axis` the tool axis from tip to spindle.
pub fn lowest_mm(segments: &[Segment], radius_mm: f64, centre: &Point, axis: &Vector, along: &Vector) -> f64 {
    let (at, rise) = (centre.coords.dot(along), axis.dot(along));
    // How far a circle about the axis of radius 1 comes down.
    let across = (1.0 - rise * rise).max(0.0).sqrt();
    let ends = segments.iter().flat_map(|s| [(s.z0, s.r0), (s.z1, s.r1)]);
    ends.map(|(z, r)| at + z * rise - r * across).fold(at - radius_mm, f64::min)
}

impl Tool {
    /// Reads the text of a tool file: TOML with the keys of this type, or with a table `[tool]` of
    /// them, so that a resolved job will do; `origin` names it in messages.
    ///
    /// # Errors
    /// Kind `Usage`: not TOML, an unknown or missing key, or a value out of its range.
    pub fn from_toml(text: &str, origin: &str) -> Result<Self> {
        let bad = |what: &str| {
            let what = what.trim().replace('\n', " ");
            Error::usage(Stage::Job, format!("{origin}: {what}")).advise(
                "a tool file has radius_mm, taper_deg, shank_radius_mm, stickout_mm (from the ball centre) and holder = \
                 [{ radius_mm = …, length_mm = … }], and corner_radius_mm for a bull-nose or flat cutter; \
                 job.resolved.toml of any run will do",
            )
        };
        let mut table: toml::Table = from_toml(text).map_err(|e| bad(&e.words))?;
        let own = match table.remove("tool") {
            Some(tool @ toml::Value::Table(_)) => tool,
            Some(_) => return Err(bad("`tool` is not a table")),
            None => table.into(),
        };
        let mut tool: Tool = from_value(&own).map_err(|e| bad(&e.words))?;
        // A corner as round as the cutter is a ball.
        tool.corner_radius_mm = tool.corner_radius_mm.filter(|r| *r != tool.radius_mm);
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
        if let Some(r) = self.corner_radius_mm {
            if !(r <= self.radius_mm) {
                return bad(format!(
                    "tool.corner_radius_mm is {r}, it must not be greater than tool.radius_mm, {}",
                    self.radius_mm
                ));
            }
            if !(r >= LEAST_CORNER_MM) {
                return bad(format!(
                    "tool.corner_radius_mm is {r}, it must be at least {LEAST_CORNER_MM}: flat end mills have a small \
                     corner too, look up what yours has"
                ));
            }
        }
        if !(0.0..45.0).contains(&self.taper_deg) {
            return bad(format!("tool.taper_deg is {}, it must be at least 0 and less than 45", self.taper_deg));
        }
        let r0 = self.disc_radius_mm() + self.corner_mm() * self.taper_deg.to_radians().cos();
        if !(self.shank_radius_mm >= r0 - 1e-9 && self.shank_radius_mm.is_finite()) {
            return bad(format!(
                "tool.shank_radius_mm is {}, it must be at least {r0} (the cone's radius where it leaves the {})",
                self.shank_radius_mm,
                if self.is_ball() { "ball" } else { "corner" }
            ));
        }
        if !(self.stickout_mm > self.corner_mm() && self.stickout_mm.is_finite()) {
            let of = if self.is_ball() { "ball" } else { "corner" };
            return bad(format!("tool.stickout_mm is {}, it must be greater than the {of} radius", self.stickout_mm));
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

    /// Whether its end is a ball.
    pub fn is_ball(&self) -> bool {
        self.disc_radius_mm() == 0.0
    }

    /// What its end is called.
    pub fn end_name(&self) -> &'static str {
        if self.is_ball() { "ball" } else { "bottom" }
    }

    /// What the centre of its ball or corner is called.
    pub fn centre_name(&self) -> &'static str {
        if self.is_ball() { "ball centre" } else { "centre of the corner's arc" }
    }

    /// Radius of the corner, a ball's own, mm: how far the tip lies below the centre of ball or
    /// disc.
    pub fn corner_mm(&self) -> f64 {
        self.corner_radius_mm.unwrap_or(self.radius_mm)
    }

    /// Radius of the disc that the corner rolls over, mm; 0 for a ball.
    pub fn disc_radius_mm(&self) -> f64 {
        self.corner_radius_mm.map_or(0.0, |r| self.radius_mm - r)
    }

    /// Asks for a ball end, where nothing else is known how to be done.
    ///
    /// # Errors
    /// Kind `Usage` for any other cutter; `what` is done with balls only, as in "plans are made".
    pub fn ball_only(&self, what: &str) -> Result<()> {
        if self.is_ball() {
            return Ok(());
        }
        let message = format!(
            "{what} for ball-end cutters only: tool.corner_radius_mm is {}, tool.radius_mm {}",
            self.corner_mm(),
            self.radius_mm
        );
        Err(Error::usage(Stage::Job, message)
            .advise("`plan` makes programs for bull-nose and flat cutters, `verify PROGRAM --part MODEL --tool FILE` checks them"))
    }

    /// The profile above ball or corner, from cutter to spindle: consecutive frusta without gaps.
    pub fn segments(&self) -> Vec<Segment> {
        let tau = self.taper_deg.to_radians();
        let (z0, r0) = (self.corner_mm() * tau.sin(), self.disc_radius_mm() + self.corner_mm() * tau.cos());
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

    /// The profile above ball or corner in two: taper and shank, and the holder. Each keeps a
    /// clearance of its own.
    pub fn cutter_and_holder(&self) -> [Vec<Segment>; 2] {
        let (holder, cutter) = self.segments().into_iter().partition(|s| s.part.is_holder());
        [cutter, holder]
    }

    /// The greatest distance of any point of the tool from the centre of ball or disc, mm.
    pub fn reach_mm(&self) -> f64 {
        let ends = self.segments().into_iter().flat_map(|s| [s.z0.hypot(s.r0), s.z1.hypot(s.r1)]);
        ends.fold(self.disc_radius_mm() + self.corner_mm(), f64::max)
    }

    /// Length from the centre of ball or disc to the end of the last holder stage, mm.
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    const BALL: &str = "radius_mm = 8\ntaper_deg = 0\nshank_radius_mm = 8\nstickout_mm = 60\nholder = []\n";

    fn read(more: &str) -> Result<Tool> {
        Tool::from_toml(&format!("{BALL}{more}"), "t.toml")
    }

    #[test]
    fn a_corner_as_round_as_the_cutter_is_a_ball() {
        let (ball, same) = (read("").unwrap(), read("corner_radius_mm = 8").unwrap());
        assert_eq!(ball, same);
        assert!(ball.is_ball() && ball.ball_only("plans are made").is_ok());
        // Files of balls are what they were.
        assert_eq!(
            toml::to_string(&ball).unwrap(),
            BALL.replace("= 8", "= 8.0").replace("= 0", "= 0.0").replace("= 60", "= 60.0")
        );
        let bull = read("corner_radius_mm = 2").unwrap();
        assert_eq!((bull.corner_mm(), bull.disc_radius_mm(), bull.is_ball()), (2.0, 6.0, false));
        assert_eq!(Tool::from_toml(&toml::to_string(&bull).unwrap(), "t.toml").unwrap(), bull);
        let refused = bull.ball_only("plans are made").unwrap_err();
        assert!(refused.message.contains("only: tool.corner_radius_mm is 2, tool.radius_mm 8"), "{refused}");
    }

    #[test]
    fn corners_that_are_none_are_refused() {
        for (more, says) in [
            ("corner_radius_mm = 8.1", "must not be greater than tool.radius_mm, 8"),
            ("corner_radius_mm = 0.0", "at least 0.05: flat end mills have a small corner too"),
            ("corner_radius_mm = -1", "at least 0.05"),
            ("corner_radius_mm = nan", "tool.corner_radius_mm is NaN"),
            ("corner_radius_mm = inf", "must not be greater"),
        ] {
            let e = read(more).unwrap_err();
            assert!(e.kind == crate::error::ErrorKind::Usage && e.message.contains(says), "{more}: {e}");
        }
    }

    /// The profile begins where it is tangent to the corner, at any taper.
    #[test]
    fn the_profile_goes_on_from_the_corner() {
        for (taper_deg, corner) in [(0.0, 2.0), (3.0, 2.0), (10.0, 0.05), (3.0, 8.0)] {
            let tool = Tool {
                radius_mm: 8.0,
                corner_radius_mm: Some(corner),
                taper_deg,
                shank_radius_mm: 12.0,
                stickout_mm: 90.0,
                holder: Vec::new(),
            };
            tool.validate().unwrap();
            let first = &tool.segments()[0];
            let (s, c) = taper_deg.to_radians().sin_cos();
            assert!((first.z0 - corner * s).abs() < 1e-12 && (first.r0 - (8.0 - corner + corner * c)).abs() < 1e-12);
            let slope = (first.r1 - first.r0) / (first.z1 - first.z0);
            assert!((slope - s / c).abs() < 1e-12, "{taper_deg}");
        }
    }
}
