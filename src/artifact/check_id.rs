//! Which check it is: its name in files and on the screen, as a type.

use std::fmt;
use std::str::FromStr;

/// What of an axis a check looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxisCheck {
    /// Position against travel.
    Travel,
    /// Velocity against its limit.
    Velocity,
    /// Acceleration against its limit.
    Acceleration,
    /// Jerk against its limit.
    Jerk,
}

const OF_AXIS: [(&str, AxisCheck); 4] = [
    ("travel", AxisCheck::Travel),
    ("velocity", AxisCheck::Velocity),
    ("acceleration", AxisCheck::Acceleration),
    ("jerk", AxisCheck::Jerk),
];

/// Each check once: its name, its variant, what it is about.
macro_rules! checks {
    ($($name:literal $id:ident $about:literal,)*) => {
        /// A kind of check. Files hold its name.
        #[derive(Clone, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
        #[serde(into = "String", try_from = "String")]
        pub enum CheckId {
            $(#[doc = concat!("`", $name, "`: ", $about)] $id,)*
            /// `x-travel` … `c-jerk`: one axis against a limit of its own.
            Axis {
                /// Name of the axis, in small letters.
                axis: String,
                /// What of it.
                what: AxisCheck,
            },
        }

        /// All checks that are no axis' own.
        const PLAIN: &[(&str, CheckId)] = &[$(($name, CheckId::$id),)*];

        impl fmt::Display for CheckId {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(CheckId::$id => f.pad($name),)*
                    CheckId::Axis { axis, what } => {
                        let what = OF_AXIS.iter().find(|(_, w)| w == what).map_or("", |(name, _)| name);
                        f.pad(&format!("{axis}-{what}"))
                    }
                }
            }
        }
    };
}

checks! {
    "gouge" Gouge "the swept ball in the part.",
    "gouge-surface" GougeSurface "samples of the surface in the swept ball.",
    "scallop" Scallop "height left over the part.",
    "scallop-turn" ScallopTurn "the same over one turn of a program.",
    "ridge" Ridge "ridges between neighbouring turns.",
    "clearance" Clearance "taper and shank to the part.",
    "holder-clearance" HolderClearance "the holder to the part.",
    "obstacle-gouge" ObstacleGouge "the swept ball in a fixture, another blade or the hub.",
    "obstacle-clearance" ObstacleClearance "the tool to a fixture or the stock.",
    "other-blade" OtherBlade "another blade of the wheel against the ball that touches this one.",
    "lead-gouge" LeadGouge "the ball in the part on the leads.",
    "lead-clearance" LeadClearance "taper and shank to the part on the leads.",
    "lead-holder-clearance" LeadHolderClearance "the holder to the part on the leads.",
    "lead-obstacle" LeadObstacle "the tool to a fixture or the stock on the leads.",
    "lead-axes" LeadAxes "axis positions of the leads against their ball centres.",
    "lead-travel" LeadTravel "axis positions of the leads against the travel.",
    "lead-limits" LeadLimits "velocity and acceleration on the leads.",
    "theta-reversal" ThetaReversal "steps of θ against the direction of travel.",
    "theta-channel" ThetaChannel "θ against the channel.",
    "curve-gouge" CurveGouge "the ball in the part along the programmed curve.",
    "curve-chord" CurveChord "straight moves against the programmed curve.",
    "curve-scallop" CurveScallop "height left over the part along the programmed curve.",
    "curve-clearance" CurveClearance "the tool to part, fixtures and stock along the programmed curve.",
    "curve-theta" CurveTheta "θ along the programmed curve.",
    "curve-joints" CurveJoints "third derivatives at the locations of the programmed curve.",
    "time" Time "times rise from row to row.",
    "axes-centre" AxesCentre "the ball centre that the axes give.",
    "axes-direction" AxesDirection "the tool axis that the axes give.",
    "job" Job "values of the plan against its job.",
    "job-region" JobRegion "heights of the path against the job's region.",
    "job-feed" JobFeed "the greatest feed against the job's.",
    "turn-offset" TurnOffset "offset of the tool from the blade axis, by the axes.",
    "turn-rate" TurnRate "speed at which the blade turns, through each turn.",
    "tooth-feed" ToothFeed "feed per tooth of the contact.",
    "plan-turns" PlanTurns "turns and lengths against the locations.",
    "plan-contacts" PlanContacts "contacts against part, centre and normal.",
    "plan-motion" PlanMotion "columns of the motion against each other.",
    "plan-channel" PlanChannel "rows of the channel against each other and the job.",
    "channel-clear" ChannelClear "the tool from wall to wall of the channel.",
    "pair-rows" PairRows "moves of the rows of two tools against their stretches.",
    "opposition" Opposition "normals at the places of two tools against each other.",
    "tools-apart" ToolsApart "two tools against each other.",
    "program-centre" ProgramCentre "ball centres after lines of a program.",
    "program-direction" ProgramDirection "tool axes after lines of a program.",
    "program-curve" ProgramCurve "tool axes within polynomial lines.",
    "program-joints" ProgramJoints "derivatives where polynomial lines meet.",
    "program-chord" ProgramChord "ball centres within lines.",
    "program-missing" ProgramMissing "cutter locations that a program does not come by.",
    "program-rapids" ProgramRapids "the tool to the part in rapids.",
    "program-travel" ProgramTravel "positions of all moves of a program against the travel.",
    "program-feed" ProgramFeed "times of lines.",
    "program-time" ProgramTime "the whole time.",
    "program-end" ProgramEnd "that a program ends.",
    "program-tool" ProgramTool "the tool that it calls.",
    "program-tool-length" ProgramToolLength "the length of the tool that counts.",
    "program-spindle" ProgramSpindle "the spindle's sense and speed.",
    "program-smoothing" ProgramSmoothing "how far the control may leave the path.",
    "program-frame" ProgramFrame "the work offset.",
    "program-words" ProgramWords "words against what the control reads.",
    "program-channels" ProgramChannels "programs of two channels against each other: wait marks, axes, the table.",
    "program-readable" ProgramReadable "that a program can be read.",
    "program-absent" ProgramAbsent "that a program which the job asks for is there.",
    "contact" Contact "that a program of others comes to the part at all.",
    "rapid" Rapid "the tool to the part in its rapids.",
    "end" End "that it ends.",
    "tool" Tool "the tool that it calls.",
    "tool-length" ToolLength "the length of the tool that counts.",
    "spindle" Spindle "the spindle's sense and speed.",
    "smoothing" Smoothing "how far the control may leave the path.",
    "b-sign" BSign "all would be well with the other sign of B.",
    "a-sense" ASense "all would be well with the other sense of A.",
    "files" Files "files of a run against its manifest.",
    "inputs" Inputs "inputs of a run against its manifest.",
    "table-cutter-locations" TableCutterLocations "`cutter_locations.csv` against the plan.",
    "table-axes" TableAxes "`axes.csv` against the plan.",
}

impl CheckId {
    /// The check of an axis by its name.
    pub fn axis(name: &str, what: AxisCheck) -> Self {
        CheckId::Axis { axis: name.to_lowercase(), what }
    }

    /// It judges an own program: the plan that the program was made from does not answer for it.
    pub fn is_of_program(&self) -> bool {
        use CheckId as Id;
        matches!(
            self,
            Id::ProgramCentre
                | Id::ProgramDirection
                | Id::ProgramCurve
                | Id::ProgramJoints
                | Id::ProgramChord
                | Id::ProgramMissing
                | Id::ProgramRapids
                | Id::ProgramTravel
                | Id::ProgramFeed
                | Id::ProgramTime
                | Id::ProgramEnd
                | Id::ProgramTool
                | Id::ProgramToolLength
                | Id::ProgramSpindle
                | Id::ProgramSmoothing
                | Id::ProgramFrame
                | Id::ProgramWords
                | Id::ProgramChannels
                | Id::ProgramReadable
                | Id::ProgramAbsent
        )
    }

    /// It judges the files of a finished run, not its plan.
    pub fn is_of_files(&self) -> bool {
        use CheckId as Id;
        matches!(self, Id::Files | Id::Inputs | Id::TableCutterLocations | Id::TableAxes)
    }

    /// It judges the ways onto the path and off it.
    pub fn is_of_lead(&self) -> bool {
        use CheckId as Id;
        matches!(
            self,
            Id::LeadGouge
                | Id::LeadClearance
                | Id::LeadHolderClearance
                | Id::LeadObstacle
                | Id::LeadAxes
                | Id::LeadTravel
                | Id::LeadLimits
        )
    }
}

/// A name that no check has.
#[derive(Debug, thiserror::Error)]
#[error("no check is called '{0}'")]
pub struct UnknownCheck(String);

impl FromStr for CheckId {
    type Err = UnknownCheck;

    fn from_str(name: &str) -> Result<Self, UnknownCheck> {
        let plain = PLAIN.iter().find(|(n, _)| *n == name).map(|(_, id)| id.clone());
        let of_axis = || {
            let (axis, what) = name.rsplit_once('-')?;
            let (_, what) = OF_AXIS.iter().find(|(n, _)| *n == what)?;
            let letters = axis.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit());
            (letters && !axis.is_empty()).then(|| CheckId::axis(axis, *what))
        };
        plain.or_else(of_axis).ok_or_else(|| UnknownCheck(name.to_owned()))
    }
}

impl TryFrom<String> for CheckId {
    type Error = UnknownCheck;

    fn try_from(name: String) -> Result<Self, UnknownCheck> {
        name.parse()
    }
}

impl From<CheckId> for String {
    fn from(id: CheckId) -> String {
        id.to_string()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn every_name_is_one_check_and_reads_back() {
        let axes = ["x", "b", "c2"].into_iter().flat_map(|a| OF_AXIS.map(|(_, what)| CheckId::axis(a, what)));
        let all: Vec<CheckId> = PLAIN.iter().map(|(_, id)| id.clone()).chain(axes).collect();
        let names: std::collections::BTreeSet<String> = all.iter().map(CheckId::to_string).collect();
        assert_eq!(names.len(), all.len());
        for id in &all {
            let (name, json) = (id.to_string(), serde_json::to_string(id).unwrap());
            assert_eq!((json.as_str(), &name.parse::<CheckId>().unwrap()), (format!("\"{name}\"").as_str(), id));
            assert_eq!(serde_json::from_str::<CheckId>(&json).unwrap(), *id);
            assert_eq!(
                (id.is_of_program(), id.is_of_lead()),
                (name.starts_with("program-"), name.starts_with("lead-"))
            );
        }
    }

    #[test]
    fn a_name_that_no_check_has_is_refused() {
        for name in ["", "gouges", "Gouge", "x-snap", "-travel", "program-", "the-axis-travel"] {
            let e = serde_json::from_str::<CheckId>(&format!("\"{name}\"")).unwrap_err();
            assert!(e.to_string().contains(&format!("no check is called '{name}'")), "{e}");
        }
    }
}
