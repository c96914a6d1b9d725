//! Why there is no plan, as data: what the sentence of an error of kind `Infeasible` says, for
//! programs.

use std::fmt;

/// A place on the tool path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
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

/// The frame that a point is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Frame {
    /// That of the model's file.
    Model,
    /// That of the blade.
    Blade,
}

/// A point, and the frame that it is in.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Spot {
    /// The frame.
    pub frame: Frame,
    /// The point, mm.
    pub point_mm: [f64; 3],
}

impl Spot {
    /// The point of the model with its height along the blade axis, in words.
    pub fn at_height(&self, height_mm: f64) -> String {
        let [x, y, z] = self.point_mm;
        format!("height {height_mm:.3} mm, model point ({x:.3}, {y:.3}, {z:.3})")
    }
}

/// A place along the tool path, where the model is not known.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Along {
    /// Index of the cutter location at or before it.
    pub location: usize,
    /// Its turn, from 0.
    pub turn: u32,
    /// Arc length from the turn's base point, mm.
    pub turn_s_mm: f64,
    /// Height of the ball centre along the blade axis, mm.
    pub height_mm: f64,
}

/// A check that failed, and by how much.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Missed {
    /// Name of the check.
    pub check: String,
    /// Worst value found.
    pub worst: f64,
    /// Its limit.
    pub limit: f64,
}

/// What ends the turns of a path.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stopped {
    /// The wall leans too far.
    WallLeans,
    /// The airfoil ends.
    Rim,
    /// The ball cannot follow the surface.
    BallTooLarge,
    /// The way round the airfoil does not close.
    WayOpen,
    /// Other parts of the blade are in the way all round.
    OtherParts,
    /// The ball touches another body.
    OtherBody,
    /// An edge of the part.
    Edge,
    /// A face that ends the region, by its index.
    Face(u32),
    /// A corner with a wall that leans too far.
    Corner,
    /// A cutter with a corner would cut the part beside its contact.
    CutsBeside {
        /// Inclined by at most so much, degrees.
        contact_deg: f64,
        /// With so much room for θ, degrees.
        room_deg: f64,
    },
    /// Turns that are laid up from farther down would lose the surface.
    TurnsLoseSurface,
    /// Turns come no nearer to the end of the region.
    NoNearer,
    /// The region ends.
    Region,
}

/// What a plane section lacks.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "fault")]
pub enum SectionFault {
    /// No loop at all.
    NoLoop,
    /// A loop that does not close.
    OpenLoop,
    /// No curve goes through its points.
    NoCurve,
    /// The plane runs along a face.
    AlongFace {
        /// Where.
        at: Spot,
    },
}

/// Why a design makes no blade.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "fault")]
pub enum DesignFault {
    /// No ball of the fillet's radius fits between platform and airfoil.
    FilletDoesNotFit {
        /// Radius, mm.
        radius_mm: f64,
        /// Where round the section, degrees.
        round_deg: f64,
    },
    /// The fillet is wider than the hollow of the airfoil.
    FilletWiderThanHollow {
        /// Radius, mm.
        radius_mm: f64,
        /// Where round the section, degrees.
        round_deg: f64,
    },
    /// No mesh keeps the deflection.
    MeshOffSurface {
        /// Deflection, mm.
        deflection_mm: f64,
    },
    /// The mesh would have too many points.
    MeshTooLarge {
        /// Points that it may have.
        most_points: usize,
    },
    /// A face crosses itself.
    FaceCrossesItself {
        /// Its name.
        face: String,
    },
    /// Surfaces cannot be interpolated.
    NoSurface,
    /// The surfaces make no closed solid.
    NotClosed,
}

/// What ends the free angles of the tool axis.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
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
    /// Travel of a linear axis.
    Travel {
        /// Its name.
        axis: String,
    },
    /// The permitted range of the contact angle.
    ContactAngle,
}

impl fmt::Display for Bound {
    /// In two or three words.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Bound::Part { tool, face: against } | Bound::Fixture { tool, name: against } => {
                write!(f, "{tool} against {against}")
            }
            Bound::AxisLimit => f.write_str("rotary axis"),
            Bound::Travel { axis } => write!(f, "travel of {axis}"),
            Bound::ContactAngle => f.write_str("contact angle"),
        }
    }
}

/// What happened.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
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
    /// An axis would leave its travel in a row of two tools.
    RowBeyondTravel {
        /// Name of the axis.
        axis: String,
        /// Row, from 0.
        row: usize,
        /// Where it would have to stand, mm or degrees.
        at: f64,
        /// Its travel, mm or degrees.
        travel: [f64; 2],
    },
    /// What turns or moves the workpiece moves while two tools of two channels cut.
    TableMovesInRow {
        /// Name of the axis.
        axis: String,
        /// Row, from 0.
        row: usize,
        /// How far it moves, mm or degrees.
        moved: f64,
    },
    /// At a place of two tools no angle of the table is free for both.
    NoCommonAngle {
        /// Row, from 0.
        row: usize,
        /// Height of the first tool's ball centre along the blade axis, mm.
        height_mm: f64,
        /// Angles of the table that are free for the one and the other, degrees.
        free_deg: [Vec<[f64; 2]>; 2],
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
    /// There is no place at which the channel is open.
    ChannelClosedEverywhere,
    /// The walls leave no way round the path, at no place that could be named.
    NoMonotoneWay,
    /// The part is smaller than the tool.
    PartSmallerThanTool {
        /// Extent of the part, mm.
        size_mm: [f64; 3],
        /// Ball radius, mm.
        radius_mm: f64,
    },
    /// The airfoil is too low for the ball.
    AirfoilTooLow {
        /// Its height, mm.
        height_mm: f64,
        /// Least height, mm.
        least_mm: f64,
    },
    /// The ball loses the surface on the way.
    BallLosesSurface {
        /// Ball radius, mm.
        radius_mm: f64,
        /// Ball centres around the place, or the one nearest to it.
        near: Vec<Spot>,
    },
    /// No hub is found between two blades of a wheel.
    NoHub {
        /// Where it was looked for.
        near: Spot,
    },
    /// As many rows over a hub as were tried leave ridges over the scallop.
    RowsTooHigh {
        /// Their number.
        rows: usize,
        /// The greatest ridge, mm.
        ridge_mm: f64,
        /// Scallop asked for, mm.
        scallop_mm: f64,
    },
    /// Two blades of a wheel leave no room for the ball on the hub.
    BladesTooClose {
        /// Where.
        near: Spot,
        /// Ball radius, mm.
        radius_mm: f64,
        /// Radius of the greatest ball that has room there, mm.
        room_mm: f64,
    },
    /// No turn goes round the airfoil at a height.
    NoTurnRound {
        /// Height, mm.
        height_mm: f64,
        /// Ball radius, mm.
        radius_mm: f64,
        /// Greatest lean of the wall, degrees.
        max_lean_deg: f64,
        /// What is in the way.
        by: Stopped,
        /// Where, if at one place.
        at: Option<Spot>,
    },
    /// Less than one whole turn fits.
    NotOneTurn {
        /// Ball radius, mm.
        radius_mm: f64,
        /// Greatest lean of the wall, degrees.
        max_lean_deg: f64,
        /// What ends it.
        by: Stopped,
        /// Where, if at one place.
        at: Option<Spot>,
    },
    /// More turns would be needed than a path may have.
    TooManyTurns {
        /// Turns that it may have.
        most: usize,
        /// Scallop that is asked for, mm.
        scallop_mm: f64,
    },
    /// Turns in equal parts leave more than the scallop.
    ScallopNotReached {
        /// How many turns.
        turns: usize,
        /// Scallop that is asked for, mm.
        scallop_mm: f64,
    },
    /// Not a turn was laid.
    NoHelix,
    /// Sections, none of which closes.
    NoSectionCloses {
        /// How many.
        count: usize,
        /// Height of the first and the last, mm.
        heights_mm: [f64; 2],
        /// How wide the part is open, mm.
        open_mm: f64,
    },
    /// A section that has no curves.
    NoSection {
        /// Height, mm.
        height_mm: f64,
        /// What it lacks.
        #[serde(flatten)]
        fault: SectionFault,
    },
    /// The hull of the channel is closed at a place: no schedule passes without turning back.
    HullClosed {
        /// Where.
        at: Along,
        /// By how much, degrees.
        short_deg: f64,
        /// Place of the lower wall.
        lower_at: Along,
        /// Place of the upper wall.
        upper_at: Along,
    },
    /// The channel leaves no room for a schedule to bend.
    NoRoomToTurn {
        /// Where.
        at: Along,
        /// Width of the channel there, degrees.
        width_deg: f64,
        /// Margin from the walls that is asked for, degrees.
        margin_deg: f64,
    },
    /// No smooth schedule passes within the margin.
    NoSmoothSchedule {
        /// Margin from the walls that is asked for, degrees.
        margin_deg: f64,
    },
    /// The schedule that was made is none.
    ScheduleFails {
        /// Where.
        at: Along,
    },
    /// No offset of the tool from the blade axis is within the channel everywhere.
    NoOffset {
        /// Where it must be at least…
        low_at: Along,
        /// … this, mm.
        low_mm: f64,
        /// Where it may be at most…
        high_at: Along,
        /// … this, mm.
        high_mm: f64,
    },
    /// The offset that is asked for is not within the channel.
    OffsetOutside {
        /// It, mm.
        asked_mm: f64,
        /// What the channel allows, mm.
        range_mm: [f64; 2],
    },
    /// The machine has none of the offsets that the channel allows.
    OffsetBeyondTravel {
        /// What the channel allows, mm.
        channel_mm: [f64; 2],
        /// What the machine has, mm.
        travel_mm: [f64; 2],
    },
    /// No speed of turning that stays the same all through a turn is within the channel.
    NoEvenSpeed {
        /// Where θ is at least on its lower wall…
        from: Along,
        /// … and with that speed beyond its upper wall, or the other way round.
        to: Along,
        /// What the least speed of the ball lets θ rise by at most between them, and what the
        /// channel asks for at least, degrees; `None`: the channel leaves θ nothing to rise by.
        rises_deg: Option<[f64; 2]>,
    },
    /// There is no schedule to choose from.
    NoSchedules,
    /// No tool axis is free, or none near to those before.
    NoToolAxis {
        /// Where.
        at: Along,
    },
    /// The axis that turns a wheel does not reach one of its blades.
    TurnBeyondTravel {
        /// Name of the axis.
        axis: String,
        /// Where it would run, degrees.
        range_deg: [f64; 2],
        /// Its travel, degrees.
        travel_deg: [f64; 2],
    },
    /// Neighbouring blades of a wheel are not apart.
    BladesOverlap {
        /// Number of blades.
        blades: u32,
        /// How deep the one is in the other, mm.
        depth_mm: f64,
        /// Where it is deepest, model frame, mm.
        at_mm: [f64; 3],
    },
    /// The model shows another wheel than the job says.
    NotThatWheel {
        /// Blades that the job says.
        asked: u32,
        /// How often the model's wheel repeats in a turn.
        found: u32,
    },
    /// No schedule leads from one given angle to another.
    NoScheduleBetween {
        /// θ at the start, degrees.
        start_deg: f64,
        /// θ at the end, degrees.
        end_deg: f64,
    },
    /// No stretch of a program is better scheduled anew.
    NoStretchGains {
        /// How many there are.
        stretches: usize,
        /// Why, of each.
        reasons: Vec<String>,
    },
    /// A program scheduled anew would fail a check that the one before passes or fails less.
    ProgramWorse {
        /// The check, after.
        missed: Missed,
        /// Its worst value before; `None`: it was not judged.
        before: Option<f64>,
    },
    /// The tool cannot come onto the path at a turn.
    TurnNotReached {
        /// The turn, from 0.
        turn: u32,
        /// What fails.
        missed: Vec<Missed>,
    },
    /// The tool cannot leave the path along its axis.
    CannotLeave {
        /// `first` or `last` location.
        end: String,
        /// Where.
        at: Along,
        /// How far the contact is above the ball's equator, degrees.
        above_equator_deg: f64,
    },
    /// A move turns too far for one line.
    MoveTurnsTooFar {
        /// Row of the motion that it leads to.
        row: usize,
        /// Lines that it would take.
        lines: usize,
        /// Lines that it may take.
        most_lines: usize,
        /// Chord tolerance, mm.
        chord_mm: f64,
    },
    /// A move is too short for inverse time.
    MoveTooShort {
        /// When it begins, s.
        at_s: f64,
        /// Its time, s.
        takes_s: f64,
        /// Least time of a line, s.
        least_s: f64,
        /// Chord tolerance, mm.
        chord_mm: f64,
    },
    /// A feed that the control does not read.
    FeedWordOutOfRange {
        /// When the line ends, s.
        at_s: f64,
        /// Its time, s.
        takes_s: f64,
        /// The word that it needs.
        needed: f64,
        /// Least and greatest that the control reads.
        range: [f64; 2],
    },
    /// No polynomial follows the motion.
    NoPolynomial {
        /// After this time, s.
        at_s: f64,
    },
    /// No tool is in the catalogue.
    NoTools,
    /// Not even the smallest ball that is sold has room.
    NoBallFits {
        /// Its radius, mm.
        radius_mm: f64,
        /// Share of the wall that it goes to.
        share: f64,
        /// Heights between which that was looked at, mm.
        heights_mm: [f64; 2],
        /// Where it is tightest.
        at: Option<Spot>,
    },
    /// In no frame do the balls of a program touch the part.
    NoFrame {
        /// Share of its feed places that touch in the best that was found.
        touching_share: f64,
        /// How far nine tenths of the places are off there, root mean square, µm.
        rms_um: f64,
        /// What its lengths times this would do: 25.4 or 1/25.4.
        scale: Option<f64>,
        /// The radius of a ball that would do, mm.
        radius_mm: Option<f64>,
    },
    /// A program may be moved over the part, and touches it as well.
    FrameNotDetermined {
        /// How, in words.
        directions: Vec<String>,
        /// Greatest over least eigenvalue of the fit.
        condition: Option<f64>,
        /// Standard deviation of the frame, µm.
        uncertainty_um: Option<f64>,
    },
    /// A program touches the part in two frames.
    FrameAmbiguous {
        /// Angle between them, degrees.
        turned_deg: f64,
        /// How far the middle of the program is moved from one to the other, mm.
        moved_mm: f64,
        /// Residual of the second over that of the first.
        ratio: f64,
    },
    /// The model does not look like a blade.
    NotABlade,
    /// The airfoil has no inside, or no opposite sides.
    NoPairs,
    /// A design makes no blade.
    Design {
        /// Why.
        #[serde(flatten)]
        fault: DesignFault,
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
