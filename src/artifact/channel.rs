//! The S–θ channel: at each cutter location the angles that the whole tool may take.

use std::fmt;

use super::{ToolPart, packed};
use crate::error::{Bound, Infeasible};

/// What limits an end of an interval of θ.
#[derive(Clone, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
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
    /// Travel of a linear axis.
    Travel {
        /// Its name.
        axis: String,
    },
    /// The permitted range of contact angle on the ball.
    ContactAngle,
    /// Nothing does: the whole circle is free, the interval was cut open opposite to the surface
    /// normal.
    Free,
}

/// The interval of the chosen chain at one cutter location; radians, unwrapped over the whole path.
#[derive(Clone, Debug, PartialEq)]
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
    /// How θ goes along the path.
    #[serde(default, skip_serializing_if = "Sweep::is_round")]
    pub sweep: Sweep,
    /// One row per cutter location.
    #[serde(with = "rows")]
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

/// How θ goes along a path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sweep {
    /// Round the axis of the cones with the surface normal, turn after turn, and never back.
    #[default]
    Round,
    /// Round the axis of the cones with the surface normal, and back where that turns back. The
    /// hulls are the walls then.
    Follow,
    /// To and fro about the reference of the cones, within half a turn of it. The hulls are the
    /// walls then.
    Swing,
}

impl Sweep {
    /// θ never turns back.
    pub fn is_round(&self) -> bool {
        *self == Sweep::Round
    }
}

impl Channel {
    /// The monotone channel of schedules that begin and end at given angles, rad; `None` where no
    /// schedule that never turns back does. Where the ends leave room it is the same channel.
    #[must_use]
    pub fn pinned(&self, [start, end]: [f64; 2]) -> Option<Channel> {
        let mut out = self.clone();
        let last = out.rows.len().checked_sub(1)?;
        let holds =
            |row: usize, theta: f64| self.rows.get(row).is_some_and(|r| (r.hull_min..=r.hull_max).contains(&theta));
        if !(start <= end && holds(0, start) && holds(last, end)) {
            return None;
        }
        for row in &mut out.rows {
            (row.hull_min, row.hull_max) = (row.hull_min.max(start), row.hull_max.min(end));
        }
        for (row, theta) in [(0, start), (last, end)] {
            let row = out.rows.get_mut(row)?;
            (row.hull_min, row.hull_max) = (theta, theta);
        }
        let width = |row: &ChannelRow| row.hull_max - row.hull_min;
        let inner = self.rows.len().saturating_sub(2);
        let narrowest =
            out.rows.iter().enumerate().skip(1).take(inner).min_by(|a, b| width(a.1).total_cmp(&width(b.1)));
        out.narrowest_row = narrowest.map_or(0, |(row, _)| row);
        out.rows.iter().all(|row| width(row) >= 0.0).then_some(out)
    }
}

/// Rows in files: a table of numbers, and a list of what limits them.
mod rows {
    use std::collections::HashMap;

    use serde::de::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    use super::packed::{self, Table};
    use super::{Binding, ChannelRow};

    const COLUMNS: [&str; 8] =
        ["theta_min", "theta_max", "hull_min", "hull_max", "tangent_min", "tangent_max", "binds_min", "binds_max"];

    #[derive(Serialize, Deserialize)]
    struct Packed {
        /// The last two columns of the table are places in this list.
        bindings: Vec<Binding>,
        table: Table,
    }

    pub(super) fn serialize<S: Serializer>(rows: &[ChannelRow], to: S) -> Result<S::Ok, S::Error> {
        let mut places = HashMap::new();
        let mut bindings = Vec::new();
        let mut place = |b: &Binding| {
            *places.entry(b.clone()).or_insert_with(|| {
                bindings.push(b.clone());
                bindings.len() as f64 - 1.0
            })
        };
        let row = |r: &ChannelRow| {
            let [min, max] = [place(&r.binds_min), place(&r.binds_max)];
            [r.theta_min, r.theta_max, r.hull_min, r.hull_max, r.tangent_min, r.tangent_max, min, max]
        };
        let table = Table::of(COLUMNS, rows.iter().map(row));
        Packed { bindings, table }.serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<ChannelRow>, D::Error> {
        let Packed { bindings, table } = Packed::deserialize(from)?;
        let binding = |k: f64| {
            let at = packed::index(k)? as usize;
            bindings
                .get(at)
                .cloned()
                .ok_or_else(|| format!("there are {} bindings, none is number {at}", bindings.len()))
        };
        let row = |[theta_min, theta_max, hull_min, hull_max, tangent_min, tangent_max, min, max]: [f64; 8]| {
            let [binds_min, binds_max] = [binding(min)?, binding(max)?];
            Ok(ChannelRow { theta_min, theta_max, hull_min, hull_max, tangent_min, tangent_max, binds_min, binds_max })
        };
        let rows = table.rows(COLUMNS).map_err(D::Error::custom)?;
        rows.into_iter().map(row).collect::<Result<_, String>>().map_err(D::Error::custom)
    }
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
    pub binds: Narrowest,
}

/// What decides the width of the channel at its narrowest place.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case", tag = "is")]
pub enum Narrowest {
    /// Walls on both sides.
    Between {
        /// What ends the free angles below; none: nothing does.
        below: Option<Bound>,
        /// What ends them above.
        above: Option<Bound>,
    },
    /// No angle leads on.
    Closed {
        /// Why, in one sentence.
        message: String,
        /// The same as data.
        why: Option<Box<Infeasible>>,
    },
    /// That it is closed is all that was asked.
    NotLookedAt,
}

impl fmt::Display for Narrowest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Narrowest::Between { below, above } => {
                let [below, above] =
                    [below, above].map(|b| b.as_ref().map_or_else(|| "nothing".to_owned(), ToString::to_string));
                write!(f, "{below} below, {above} above")
            }
            Narrowest::Closed { message, .. } => f.write_str(message),
            Narrowest::NotLookedAt => Ok(()),
        }
    }
}

impl Width {
    /// A schedule that never turns back exists.
    pub fn is_open(&self) -> bool {
        self.monotone_deg.is_some_and(|w| w >= 0.0)
    }
}
