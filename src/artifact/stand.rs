//! Where the tool stands: ball centre and tool axis.

use super::Cone;
use super::axis_travel::{offset_mm, theta_at_offset};
use crate::geometry::{Point, Vector};

/// Where the tool stands, blade frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Ball centre, mm.
    pub centre: Point,
    /// The tool axes that are allowed there.
    pub cone: Cone,
    /// Angle of the tool axis on its cone, rad, unwrapped along a motion.
    pub theta: f64,
}

impl Stand {
    /// On the cone about the blade axis with a lean, rad.
    pub fn about_blade(centre: Point, theta: f64, lean_rad: f64) -> Self {
        Stand { centre, cone: Cone::about_blade(lean_rad), theta }
    }

    /// The tool axis, unit, from tip to spindle.
    pub fn axis(&self) -> Vector {
        self.cone.tool_axis(self.theta)
    }

    /// The tip of a ball of that radius, mm.
    pub fn tip(&self, radius_mm: f64) -> Point {
        self.centre - self.axis() * radius_mm
    }

    /// With the ball centre so far along the tool axis, mm.
    #[must_use]
    pub fn lifted(&self, by_mm: f64) -> Self {
        Stand { centre: self.centre + self.axis() * by_mm, ..*self }
    }

    /// At a share of the straight move to another stand: the ball centre goes straight, θ turns
    /// evenly, the cone changes evenly.
    pub fn towards(&self, to: &Stand, share: f64) -> Stand {
        let cone = if self.cone == to.cone { self.cone } else { self.cone.between(&to.cone, share) };
        Stand {
            centre: self.centre + (to.centre - self.centre) * share,
            cone,
            theta: self.theta + (to.theta - self.theta) * share,
        }
    }

    /// As [`Stand::towards`], but θ is that at which the offset of the tool from the blade axis
    /// ([`offset_mm`]) goes evenly from one stand's to the other's.
    pub fn towards_at_offset(&self, to: &Stand, share: f64) -> Stand {
        let even = self.towards(to, share);
        let [from, to] = [self, to].map(|s| offset_mm(&s.centre, s.theta));
        Stand { theta: theta_at_offset(&even.centre, from + (to - from) * share, even.theta), ..even }
    }
}
