//! A schedule θ(S): the tool axis' angle about the blade axis along the path.

use super::packed;
use crate::numerics::bezier::{cubic, parameter};

/// Room that θ keeps from the walls of the channel by default, degrees.
pub const MARGIN_DEG: f64 = 0.5;

/// How a schedule was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ScheduleKind {
    /// Fixed lead and tilt to the surface normal, as CAM systems give.
    Fixed,
    /// Spherical interpolation between key orientations.
    Quaternion,
    /// The paper's piecewise decoupled schedule.
    Piecewise,
    /// The least peak, or least square, of the second or third derivative of θ(S) in the channel.
    Optimal,
    /// The least machining time found, θ(S) and feed together.
    Time,
    /// The tool at one offset from the blade axis all along: a lathe's Y stands still.
    Eccentric,
    /// The blade turns at one speed all through each turn.
    Even,
    /// Along the lower wall of the channel: to try the channel, not to machine.
    LowerWall,
    /// Along the upper wall of the channel: to try the channel, not to machine.
    UpperWall,
}

impl ScheduleKind {
    /// Its name on the command line and in files.
    pub fn name(self) -> String {
        super::word(&self)
    }

    /// Runs along a wall of the channel.
    pub fn is_wall(self) -> bool {
        matches!(self, ScheduleKind::LowerWall | ScheduleKind::UpperWall)
    }
}

/// What an `optimal` schedule makes least.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Greatest |θ''|.
    #[default]
    PeakSecond,
    /// Greatest |θ'''|.
    PeakThird,
    /// ∫ θ''² ds.
    SquareSecond,
    /// ∫ θ'''² ds.
    SquareThird,
}

/// Over how much of the path an `optimal` schedule is the best.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scope {
    /// The whole path at once: nothing has a lesser greatest value.
    #[default]
    Whole,
    /// Turn by turn, each with the next in view and its end free: no turn waits for turns farther
    /// on.
    Turns,
}

/// The angle at which a `piecewise` schedule stands at the start of a turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BaseAngle {
    /// Of several between the channel's limits, the one that the weakest rotary axis can follow;
    /// the same share of the width at all turns.
    #[default]
    Best,
    /// The forward limit, as published.
    ForwardLimit,
}

/// How good a schedule is, beside its peaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(default)]
pub struct Quality {
    /// Greatest distance by which the curve itself leaves the channel between straight walls, rad;
    /// 0: nowhere.
    pub outside_rad: f64,
    /// Greatest |d³θ/ds³|, rad/mm³; absent where the second derivative jumps.
    pub peak_third: Option<f64>,
    /// Whether the second derivative is continuous everywhere.
    pub curvature_continuous: bool,
    /// No curve that never turns back and stays in the channel has a lesser greatest |θ''|,
    /// rad/mm².
    pub bound_second: Option<f64>,
    /// What an `optimal` schedule was made for, its value, and a value that no other curve falls
    /// below; rad, mm.
    pub measure: Option<(Measure, f64, f64)>,
}

/// A curve that is farther than this from the angle at a location is not the one that the tool
/// follows there, rad.
const SAME_RAD: f64 = 1e-7;

/// A cubic Bézier piece in the (s, θ) plane; `s` is arc length from the start of the whole path,
/// mm; θ in rad.
pub type BezierPiece = [[f64; 2]; 4];

/// The schedule.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Schedule {
    /// How it was made.
    pub kind: ScheduleKind,
    /// θ at each cutter location, rad, unwrapped over the whole path.
    #[serde(with = "packed")]
    pub theta: Vec<f64>,
    /// The curve itself, pieces in order, covering the whole path. A piece whose four `s` are
    /// evenly spaced is a cubic in `s`.
    pub pieces: Vec<BezierPiece>,
    /// Key points of the linear schedule before smoothing (s in mm, θ in rad).
    pub key_points: Vec<[f64; 2]>,
    /// Number of places where θ turns back.
    pub reversals: usize,
    /// Greatest |dθ/ds|, rad/mm.
    pub peak_rate: f64,
    /// Greatest |d²θ/ds²|, rad/mm².
    pub peak_acceleration: f64,
    /// How good it is.
    #[serde(default)]
    pub quality: Quality,
    /// Greatest rate at which θ grows in each turn, rad/s; empty: whatever the axes can do.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rates: Vec<f64>,
    /// Greatest over least rate within a turn that the schedule is made for; 1: one rate in each.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub spread: f64,
}

/// [`Schedule::spread`] at most.
pub const MOST_SPREAD: f64 = 2.0;

fn one() -> f64 {
    1.0
}

#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_one(value: &f64) -> bool {
    *value == 1.0
}

impl Schedule {
    /// Angles at the locations and nothing else: for a motion along them.
    pub fn of_angles(theta: Vec<f64>) -> Self {
        Schedule {
            kind: ScheduleKind::Fixed,
            theta,
            pieces: Vec::new(),
            key_points: Vec::new(),
            reversals: 0,
            peak_rate: 0.0,
            peak_acceleration: 0.0,
            quality: Quality::default(),
            rates: Vec::new(),
            spread: 1.0,
        }
    }

    /// θ of the curve at arc length `s_mm` from the start of the whole path, rad; `None` where it
    /// has no piece.
    pub fn curve_at(&self, s_mm: f64) -> Option<f64> {
        let k = self.pieces.partition_point(|p| p[3][0] < s_mm);
        // The end of the path may be rounded beyond that of the last piece.
        let piece = self.pieces.get(k).or(self.pieces.last())?;
        let t = parameter(piece.map(|p| p[0]), s_mm);
        Some(cubic(piece.map(|p| p[1]), t)[0]).filter(|theta| theta.is_finite())
    }

    /// Whether the curve goes through the angle of location `row`, which is at `s_mm`.
    pub fn curve_meets(&self, row: usize, s_mm: f64) -> bool {
        let theta = self.theta.get(row).zip(self.curve_at(s_mm));
        theta.is_some_and(|(at, curve)| (at - curve).abs() <= SAME_RAD)
    }
}

/// θ before and after at a place of a path, for plots.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThetaRow {
    /// Arc length from the first place, in the direction in which θ grows, mm.
    pub s_mm: f64,
    /// Walls of the channel, degrees.
    pub wall_deg: [f64; 2],
    /// Before, degrees.
    pub before_deg: f64,
    /// After, degrees.
    pub after_deg: f64,
}
