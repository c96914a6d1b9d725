//! `[pinch]` of the job file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::settings::{TINY, section};
use crate::tool::CLEARANCE_MM;

/// How both tools go over the blade.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PinchTopology {
    /// Rows along it, at opposite places.
    OpposedRows,
    /// Round it, on two threads of one helix, half a turn apart: in about half of the time of one
    /// tool. Nothing is held between them.
    DoubleHelix,
}

/// Who goes round the edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PinchEdges {
    /// Nobody: rows end where nothing is opposite.
    None,
    /// Tool 1 round one edge while tool 2 goes round the other.
    Both,
}

/// How the table stands along rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PinchOrientation {
    /// It stands still. A row without one free angle is cut in as few stretches as can be, with the
    /// tools off the part while the table turns.
    Hold,
    /// Along a row without one free angle it turns while both tools cut: as slowly as can be.
    Smooth,
    /// Each row without one free angle as one of both: what takes less time.
    Time,
    /// Along every row it turns as published: the tool posture curve through the angles that a
    /// fixed angle to tool 1's normal gives (`schedule.lead_deg`), and least squares where that is
    /// not free. To compare with.
    Paper,
}

section! {
    /// `[pinch]`: two tools that hold the blade between them, on both sides at the same time.
    "pinch" PinchSettings, PinchKeys, s {
        /// Rows of opposite places along the blade, or two threads of one helix round it.
        topology: PinchTopology = PinchTopology::OpposedRows;
        /// Heights of the first tool's ball centre between which rows run, mm along the blade axis;
        /// default: all of the airfoil.
        #[serde(skip_serializing_if = "Option::is_none")]
        heights_mm: [f64; 2] as Option<[f64; 2]> = None;
        /// Rows round the edges: none, or of both tools, each round one edge.
        edges: PinchEdges = PinchEdges::None;
        /// How the table stands along rows: still, or turning where it has to.
        orientation: PinchOrientation = PinchOrientation::Hold;
        /// What the normals at both contacts may lack of being opposite, degrees.
        ///
        /// Equal forces then leave at most two thirds of one of them, along the blade's stiff
        /// direction.
        max_angle_deg: f64 = 40.0, TINY..=89.0;
        /// Greatest distance of the two normal lines, mm: the 99th percentile is checked.
        ///
        /// On thin blades 0.5 mm of it add 2 % to what they bend.
        line_distance_mm: f64 = 0.2, TINY..=100.0;
        /// The angle about the blade axis by which the second head stands on from the first,
        /// degrees; default: that of a machine with two heads, else 180.
        #[serde(skip_serializing_if = "Option::is_none")]
        between_deg: f64 as Option<f64> = None, -360.0..=360.0;
        /// Lean of the second head, degrees; default: that of the first, `machine.b_deg`.
        #[serde(skip_serializing_if = "Option::is_none")]
        b_2_deg: f64 as Option<f64> = None, -85.0..=85.0;
        /// Channels of the control that programs are for: 1, or 2 that meet at wait marks.
        ///
        /// In one channel all axes have one clock.
        channels: u32 = 1, 1.0..=2.0;
        /// How far two channels may be apart in time while both tools cut, ms; left out: it is not
        /// known, and the table stands still then.
        ///
        /// Where the table turns, a channel that lags leaves its tool beside its place.
        #[serde(skip_serializing_if = "Option::is_none")]
        skew_ms: f64 as Option<f64> = None, 0.0..=1000.0;
        /// Speed of the second spindle, 1/min; default: that of the first, `post.spindle_rpm`.
        #[serde(skip_serializing_if = "Option::is_none")]
        spindle_2_rpm: f64 as Option<f64> = None, 1.0..=1e6;
        /// Room that the two tools keep from each other, mm.
        ///
        /// The blade is between them: where it is thin they are as near.
        tools_apart_mm: f64 = CLEARANCE_MM, 0.0..=100.0;
    }
}
