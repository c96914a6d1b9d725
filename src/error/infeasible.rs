//! Why there is no plan, as data: what the sentence of an error of kind `Infeasible` says, for
//! programs.

/// A place on the tool path.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct At {
    /// Index of the cutter location at or before it.
    pub location: usize,
    /// Its turn, from 0.
    pub turn: u32,
    /// Arc length from the turn's base point, mm.
    pub turn_s_mm: f64,
    /// Ball centre, model frame, mm.
    pub centre_mm: [f64; 3],
    /// Height of the ball centre along the blade axis, mm.
    pub height_mm: f64,
}

/// What ends the free angles of the tool axis.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case", tag = "by")]
pub enum Bound {
    /// A part of the tool against a face of the part.
    Part {
        /// Part of the tool: `taper`, `shank`, `holder 1`.
        tool: String,
        /// Face of the part by its name.
        face: String,
    },
    /// A part of the tool against a fixture or the stock.
    Fixture {
        /// Part of the tool.
        tool: String,
        /// Name of the fixture.
        name: String,
    },
    /// A limit of the rotary axis.
    AxisLimit,
    /// The permitted range of the contact angle.
    ContactAngle,
}

/// What happened.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case", tag = "what")]
pub enum Infeasible {
    /// No angle of the tool axis is free at a place.
    NoFreeAngle {
        /// Where.
        at: At,
        /// It is the first place: the tool starts in collision.
        at_start: bool,
        /// What takes the angles.
        bounds: Vec<Bound>,
        /// A plan may exist if the region ended at this height along the blade axis already, mm.
        region_may_end_mm: Option<f64>,
    },
    /// The free angles of a place do not join on to those just before.
    ChannelCloses {
        /// Where.
        at: At,
        /// What ends the free angles there and before.
        bounds: Vec<Bound>,
        /// As above.
        region_may_end_mm: Option<f64>,
    },
    /// No straight walls lead through the move after a place.
    ChannelClosesOnMove {
        /// After which place.
        after: At,
        /// Width of the channel before and after the move, degrees.
        widths_deg: [f64; 2],
        /// What ends the free angles there.
        bounds: Vec<Bound>,
        /// As above.
        region_may_end_mm: Option<f64>,
    },
    /// A schedule would have to turn back: the lower wall at a place is above the upper wall at a
    /// later one.
    WallsCross {
        /// Place of the lower wall.
        lower_at: At,
        /// θ there, degrees.
        lower_deg: f64,
        /// Later place of the upper wall.
        upper_at: At,
        /// θ there, degrees.
        upper_deg: f64,
        /// What makes the lower and the upper wall.
        bounds: Vec<Bound>,
        /// As above.
        region_may_end_mm: Option<f64>,
    },
    /// The ball comes nearer to a fixture than it may, or is inside it.
    BallNearFixture {
        /// Where.
        at: At,
        /// Name of the fixture.
        name: String,
        /// Room that is asked for, mm.
        clearance_mm: f64,
        /// The first ball centre is inside the fixture.
        inside: bool,
    },
    /// The machine does not lean the tool so all round the blade.
    LeanOutOfReach {
        /// Lean that is asked for, degrees.
        lean_deg: f64,
        /// The one lean that the machine has, degrees, where its head has no axis.
        fixed_deg: Option<f64>,
    },
    /// At this lean the tool axis comes along the first rotary axis.
    Singular {
        /// Lean that is asked for, degrees.
        lean_deg: f64,
        /// Letter of that axis.
        axis: String,
    },
    /// At this lean a rotary axis leaves its travel on either branch.
    BeyondTravel {
        /// Lean that is asked for, degrees.
        lean_deg: f64,
        /// Letter of the axis.
        axis: String,
        /// By how much, degrees.
        excess_deg: f64,
    },
    /// The part does not turn freely on the machine.
    Swing {
        /// Distance of the part's farthest point from the table's axis, mm.
        reach_mm: f64,
        /// Swing of the machine: a diameter, mm.
        swing_diameter_mm: f64,
    },
}

impl Infeasible {
    /// A plan may exist if the region ended at this height along the blade axis already, mm (blade
    /// frame).
    pub fn region_may_end_mm(&self) -> Option<f64> {
        match self {
            Infeasible::NoFreeAngle { region_may_end_mm, .. }
            | Infeasible::ChannelCloses { region_may_end_mm, .. }
            | Infeasible::ChannelClosesOnMove { region_may_end_mm, .. }
            | Infeasible::WallsCross { region_may_end_mm, .. } => *region_may_end_mm,
            _ => None,
        }
    }
}
