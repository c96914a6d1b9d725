//! A schedule θ(S): the tool axis' angle about the blade axis along the path.

/// How a schedule was made.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema, clap::ValueEnum,
)]
#[serde(rename_all = "kebab-case")]
pub enum ScheduleKind {
    /// Fixed lead and tilt to the surface normal, as CAM systems give.
    Fixed,
    /// The paper's piecewise decoupled schedule.
    Piecewise,
    /// Along the lower wall of the channel: to try the channel, not to machine.
    LowerWall,
    /// Along the upper wall of the channel: to try the channel, not to machine.
    UpperWall,
}

/// A cubic Bézier piece in the (s, θ) plane; `s` is arc length from the start of the whole path, mm; θ in rad.
pub type BezierPiece = [[f64; 2]; 4];

/// The schedule.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Schedule {
    /// How it was made.
    pub kind: ScheduleKind,
    /// θ at each cutter location, rad, unwrapped over the whole path.
    pub theta: Vec<f64>,
    /// The curve itself, pieces in order, covering the whole path (empty for `fixed`, which is only sampled).
    pub pieces: Vec<BezierPiece>,
    /// Key points of the linear schedule before smoothing (s in mm, θ in rad).
    pub key_points: Vec<[f64; 2]>,
    /// Number of places where θ turns back.
    pub reversals: usize,
    /// Greatest |dθ/ds|, rad/mm.
    pub peak_rate: f64,
    /// Greatest |d²θ/ds²|, rad/mm².
    pub peak_acceleration: f64,
}
