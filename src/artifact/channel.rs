//! The S–θ channel: at each cutter location the angles that the whole tool may take.

use super::ToolPart;

/// What limits an end of an interval of θ.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case", tag = "by")]
pub enum Binding {
    /// A part of the tool would touch a face of the part.
    Part {
        /// Which part of the tool.
        tool: ToolPart,
        /// Face or group of the part.
        face: u32,
        /// Triangle of the part's mesh.
        triangle: u32,
    },
    /// A part of the tool would touch a fixture or the stock.
    Fixture {
        /// Which.
        name: String,
        /// Which part of the tool.
        tool: ToolPart,
        /// Triangle of its mesh.
        triangle: u32,
    },
    /// A limit of the rotary axis.
    AxisLimit,
    /// The permitted range of contact angle on the ball.
    ContactAngle,
    /// Nothing does: the whole circle is free, the interval was cut open opposite to the surface
    /// normal.
    Free,
}

/// The interval of the chosen chain at one cutter location; radians, unwrapped over the whole path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ChannelRow {
    /// Least θ.
    pub theta_min: f64,
    /// Greatest θ.
    pub theta_max: f64,
    /// Monotone hull, lower wall: running greatest `theta_min`.
    pub hull_min: f64,
    /// Monotone hull, upper wall: running least `theta_max` from the end.
    pub hull_max: f64,
    /// The paper's limits from tangents of the path, for comparison.
    pub tangent_min: f64,
    /// The paper's limits from tangents of the path, for comparison.
    pub tangent_max: f64,
    /// What limits `theta_min`.
    pub binds_min: Binding,
    /// What limits `theta_max`.
    pub binds_max: Binding,
}

/// The channel over the whole path, one row per cutter location.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Channel {
    /// Tolerance of the ends, rad.
    pub tolerance_rad: f64,
    /// One row per cutter location.
    pub rows: Vec<ChannelRow>,
    /// Index of the row where the monotone channel is narrowest.
    pub narrowest_row: usize,
    /// How many separate chains could be followed round the whole path.
    pub chains: usize,
    /// Locations whose moves to the next the walls are proven for, since the tool came too near
    /// there with a schedule in walls that hold at locations.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub proven_at: Vec<usize>,
}

/// How wide the channel is at one B, over places on the path (the moves between them are not looked
/// at).
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Width {
    /// B, degrees.
    pub b_deg: f64,
    /// Width of the channel at its narrowest place, degrees; none: closed.
    pub narrowest_deg: Option<f64>,
    /// Width between the monotone hulls where they are nearest, degrees; negative: a schedule would
    /// have to turn back; none: closed.
    pub monotone_deg: Option<f64>,
    /// Turn of the narrowest place, or of where it closes.
    pub turn: u32,
    /// S there, mm.
    pub turn_s_mm: f64,
    /// What binds there, or why it is closed.
    pub binds: String,
}

impl Width {
    /// A schedule that never turns back exists.
    pub fn is_open(&self) -> bool {
        self.monotone_deg.is_some_and(|w| w >= 0.0)
    }
}
