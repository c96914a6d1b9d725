//! Why a plan is not quite what was asked for: data, from which its words are made.

use super::infeasible::{Infeasible, Spot, Stopped};
use std::fmt;

/// Why a path ends where it ends.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EndReason {
    /// It goes as far as was asked.
    Region,
    /// The surface stops ball or tool.
    Surface(SurfaceEnd),
    /// The tool axis has no way farther down.
    Channel {
        /// What the channel says there.
        words: String,
        /// The same as data.
        cause: Option<Box<Infeasible>>,
    },
}

impl EndReason {
    /// The wall leans over by more than `path.max_lean_deg` allows.
    pub fn is_lean(&self) -> bool {
        matches!(self, EndReason::Surface(SurfaceEnd { by: Stopped::WallLeans, .. }))
    }
}

impl fmt::Display for EndReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EndReason::Region => f.write_str("the end of the region"),
            EndReason::Surface(end) => end.fmt(f),
            EndReason::Channel { words, .. } => f.write_str(words),
        }
    }
}

/// What of the surface ends the turns of a path, and where.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SurfaceEnd {
    /// What it is.
    pub by: Stopped,
    /// Height of the ball centre along the blade axis, mm.
    pub height_mm: f64,
    /// The ball centre.
    pub at: Spot,
    /// Ball radius, mm.
    pub radius_mm: f64,
    /// Greatest lean of the wall, degrees.
    pub max_lean_deg: f64,
}

impl fmt::Display for SurfaceEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most_deg = self.max_lean_deg;
        match self.by {
            Stopped::WallLeans => write!(f, "the wall leans over more than {most_deg:.0}° from the blade axis"),
            Stopped::Rim => f.write_str("the airfoil ends there, without a platform,"),
            Stopped::BallTooLarge => write!(f, "a ball of radius {} mm cannot follow the surface", self.radius_mm),
            Stopped::TurnsLoseSurface => f.write_str("turns from farther down would lose the surface"),
            Stopped::WayOpen => f.write_str("the path round the airfoil does not close"),
            Stopped::OtherParts => f.write_str("other parts of the blade are in the way"),
            Stopped::OtherBody => f.write_str("the ball touches another body"),
            Stopped::Edge => f.write_str("the ball comes to an edge of the part"),
            Stopped::Face(face) => write!(f, "the ball comes to face {}, which ends the region,", face + 1),
            Stopped::Corner => {
                write!(f, "in the corner the ball meets a wall that leans over more than {most_deg:.0}°")
            }
            Stopped::CutsBeside { contact_deg, room_deg } => write!(
                f,
                "inclined by at most {contact_deg:.0}°, with {room_deg:.1}° of room for θ, the cutter cuts the part \
                 beside its contact, first"
            ),
            Stopped::NoNearer => f.write_str("turns come no nearer to the end of the region"),
            Stopped::Region => f.write_str("the region ends"),
        }?;
        write!(f, " at {}", self.at.at_height(self.height_mm))
    }
}

/// Why a lead is no arc, or not the arc that was asked for.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "why")]
pub enum LeadReason {
    /// `feed.lead_radius_mm` is 0.
    Asked,
    /// There is no path.
    NoPath,
    /// The path has no direction at its end.
    NoDirection,
    /// The program goes on within the path.
    WithinPath,
    /// The program that the path is taken from comes and goes within it.
    OfProgram,
    /// No arc that was tried is free.
    NoRoom {
        /// What is in the way of the first, that which was asked for.
        first: InTheWay,
    },
    /// This arc is free; the one tried first was not.
    Another {
        /// What is in its way.
        first: InTheWay,
    },
}

impl fmt::Display for LeadReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LeadReason::Asked => f.write_str("asked for by feed.lead_radius_mm = 0"),
            LeadReason::NoPath => f.write_str("the path has no locations"),
            LeadReason::NoDirection => f.write_str("the path has no direction at its end"),
            LeadReason::WithinPath => f.write_str("the program goes on within the path"),
            LeadReason::OfProgram => f.write_str("the program it is taken from comes and goes within the path"),
            LeadReason::NoRoom { first } => write!(f, "there is no room for an arc, with that asked for {first}"),
            LeadReason::Another { first } => write!(f, "with the one tried first {first}"),
        }
    }
}

/// What is in the way of the tool on a lead.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "what")]
pub enum InTheWay {
    /// The ball would cut.
    Cut {
        /// How deep, mm.
        depth_mm: f64,
        /// Into which face or body.
        body: String,
    },
    /// The outer end of the arc is beside the part as well.
    OuterEnd,
    /// The rest of the tool would come too near.
    Near {
        /// Which part of the tool.
        tool: String,
        /// How near, mm.
        least_mm: f64,
        /// To which face or body.
        body: String,
    },
    /// An axis would leave its travel.
    Travel {
        /// Its name.
        axis: String,
    },
}

impl fmt::Display for InTheWay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            InTheWay::Cut { depth_mm, body } => write!(f, "the ball would cut {depth_mm:.3} mm into {body}"),
            InTheWay::OuterEnd => f.write_str("the part is beside its outer end as well"),
            InTheWay::Near { tool, least_mm, body } => {
                write!(f, "the {tool} would come within {least_mm:.3} mm of {body}")
            }
            InTheWay::Travel { axis } => write!(f, "axis {axis} would leave its travel"),
        }
    }
}

/// Why a part of a path has no smooth curve.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WhyLeft {
    /// The surface normal turns from one location to the next, rad: the ball rolls over a crease or
    /// into a corner.
    Crease {
        /// By so much.
        turn_rad: f64,
    },
    /// No curve of this many pieces stays where the part wants it.
    NoRoom,
    /// Too few locations.
    Short,
    /// With the curve θ would leave the channel, or the tool would come too near to something.
    NotClear,
}

impl fmt::Display for WhyLeft {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WhyLeft::Crease { turn_rad } => write!(
                f,
                "the surface normal turns by {:.1} degrees from one location to the next, a crease",
                turn_rad.to_degrees()
            ),
            WhyLeft::NoRoom => f.write_str("no curve of enough pieces stays as near to the part as it has to"),
            WhyLeft::Short => f.write_str("too few locations between places without a curve"),
            WhyLeft::NotClear => {
                f.write_str("on the curve θ would leave the channel, or the tool would come too near to something")
            }
        }
    }
}

/// Why a whole path has no smooth curve.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "why")]
pub enum WhyNone {
    /// The schedule runs along a wall of the channel.
    AlongWall,
    /// Tool axes are on another cone at each location.
    OtherCones,
    /// The path is too short.
    TooShort,
    /// Its longest part is left as it is.
    Left {
        /// Why.
        longest: WhyLeft,
    },
    /// The part is nowhere near.
    PartNotNear,
    /// Ridges stay too high with hardly any room across the path.
    Ridges,
    /// No channel leads along the curve.
    Channel {
        /// What the channel says.
        words: String,
        /// The same as data.
        cause: Option<Box<Infeasible>>,
    },
    /// Each round found more places at which θ leaves the channel or the tool comes too near.
    MoreAndMore,
}

impl fmt::Display for WhyNone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            WhyNone::AlongWall => f.write_str("the schedule runs along a wall of the channel"),
            WhyNone::OtherCones => f.write_str("tool axes are on another cone at each location"),
            WhyNone::TooShort => f.write_str("it is too short"),
            WhyNone::Left { longest } => longest.fmt(f),
            WhyNone::PartNotNear => f.write_str("the part is nowhere near"),
            WhyNone::Ridges => f.write_str("with hardly any room across the path its ridges are still too high"),
            WhyNone::Channel { words, .. } => write!(f, "on the curve {words}"),
            WhyNone::MoreAndMore => {
                f.write_str("θ leaves the channel, or the tool comes too near to something, at ever more places")
            }
        }
    }
}
