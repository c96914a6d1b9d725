//! The piecewise decoupled schedule over the whole path: walls, base points, choice of insets,
//! assembly.

use super::bezier;
use super::check::{self, place};
use super::corridor::{Corridor, PathAngle};
use super::keys::{PathSpan, SpanEnd};
use super::turn::{self, MOST, Smoothed};
use super::{ScheduleOptions, curve};
use crate::artifact::channel::Binding;
use crate::artifact::schedule::{BaseAngle, BezierPiece, ScheduleKind};
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Error, Infeasible, Result, Stage};
use crate::observe::{Doubt, Observer, Warning};
use crate::parallel;

/// Insets of the base points from the walls that are tried, rad.
const BASE_INSETS: [f64; 4] = [0.02, 0.05, 0.15, 0.4];
/// Angles of the base points that are tried, in shares of the width there from the backward to the
/// forward limit. The last is the published one; where the channel is wide it makes every turn
/// begin with a wait and end with a rush.
const BASE_SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Lengths of the level stretches that are tried, in shares of the shorter neighbouring turn.
const LEVEL_SHARES: [f64; 3] = [0.02, 0.06, 0.15];
/// A level stretch is halved at most so often to fit.
const HALVINGS: usize = 6;
/// An outer turn shorter than this share of the longest is scheduled together with its neighbour.
const SHORT_TURN: f64 = 0.05;

/// See the module's page.
pub(super) fn plan(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    if !channel.sweep.is_round() {
        let message =
            "a schedule of kind piecewise goes round the blade and never turns back; here the tool axis swings";
        return Err(Error::usage(Stage::Schedule, message).advise("take schedule.kind time, optimal or quaternion"));
    }
    let (hull, walls) = walls_with_margin(path, channel, options, observer)?;
    let (keys, pieces) = match walls.straight() {
        Some([p, q]) => (vec![p, q], vec![bezier::straight(p, q)]),
        None => {
            let best = decoupled(path, channel, &walls, options, observer)?;
            best.warn(path, observer);
            best.assemble()
        }
    };
    observer.progress(Stage::Schedule, 1, 1);
    let theta = bezier::sample(&pieces, hull.s.iter().copied());
    check::inside(&pieces, &theta, &hull, path)?;
    let mut out = curve::schedule(ScheduleKind::Piecewise, pieces, theta, &hull);
    out.key_points = keys;
    Ok(out)
}

fn describe(binding: &Binding) -> String {
    match binding {
        // What its faces are called the channel says; here there is no part.
        Binding::Part { tool, .. } => format!("the tool's {tool} against the part"),
        Binding::Fixture { name, tool, .. } => format!("the tool's {tool} against {name}"),
        Binding::AxisLimit => "a limit of the rotary axis".into(),
        Binding::Travel { axis } => format!("the travel of {axis}"),
        Binding::ContactAngle => "the permitted contact angle on the ball".into(),
        Binding::Free => "the cut through a free circle".into(),
    }
}

/// The monotone hull as a corridor.
pub(super) fn hull(path: &Toolpath, channel: &Channel) -> Result<Corridor> {
    let rows = &channel.rows;
    for (i, r) in rows.iter().enumerate() {
        if !(r.hull_min.is_finite() && r.hull_max.is_finite()) {
            return Err(Error::usage(Stage::Schedule, format!("the channel is not a number at {}", place(path, i))));
        }
        if i > 0 && channel.sweep.is_round() && (r.hull_min < rows[i - 1].hull_min || r.hull_max < rows[i - 1].hull_max)
        {
            return Err(Error::usage(
                Stage::Schedule,
                format!("the channel's monotone hull falls at {}", place(path, i)),
            ));
        }
    }
    let width = |i: usize| rows[i].hull_max - rows[i].hull_min;
    let narrowest = (0..rows.len()).min_by(|a, b| width(*a).total_cmp(&width(*b))).unwrap_or(0);
    if width(narrowest) < 0.0 {
        return Err(closed(path, channel, narrowest));
    }
    Ok(Corridor {
        s: path.locations.iter().map(|l| l.s_mm).collect(),
        lo: rows.iter().map(|r| r.hull_min).collect(),
        hi: rows.iter().map(|r| r.hull_max).collect(),
        one_way: channel.sweep.is_round(),
    })
}

/// The error for a hull that is closed at `row`, with what binds on both sides.
fn closed(path: &Toolpath, channel: &Channel, row: usize) -> Error {
    let rows = &channel.rows;
    let r = &rows[row];
    let lower = (0..=row).max_by(|a, b| rows[*a].theta_min.total_cmp(&rows[*b].theta_min)).unwrap_or(row);
    let upper = (row..rows.len()).min_by(|a, b| rows[*a].theta_max.total_cmp(&rows[*b].theta_max)).unwrap_or(row);
    Error::infeasible(
        Stage::Schedule,
        format!(
            "no schedule that never turns back exists: at {} the channel is closed by {:.3} deg, between {} at {} and \
             {} at {}",
            place(path, row),
            (r.hull_min - r.hull_max).to_degrees(),
            describe(&rows[lower].binds_min),
            place(path, lower),
            describe(&rows[upper].binds_max),
            place(path, upper),
        ),
        Infeasible::HullClosed {
            at: path.along(row),
            short_deg: (r.hull_min - r.hull_max).to_degrees(),
            lower_at: path.along(lower),
            upper_at: path.along(upper),
        },
    )
    .advise(
        "allow less clearance or a wider range of contact angles, take a more slender or longer tool or a greater B, or \
         move the region away from what is in the way",
    )
}

/// The monotone hull, and the same with the margin kept from its walls; a warning where there is no
/// room for it.
pub(super) fn walls_with_margin(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<(Corridor, Corridor)> {
    observer.check(Stage::Schedule)?;
    let hull = hull(path, channel)?;
    let margin = options.settings.margin_deg.to_radians();
    warn_of_margin(&hull, margin, path, observer);
    let walls = hull.shrunk(margin, 0.25);
    Ok((hull, walls))
}

fn warn_of_margin(hull: &Corridor, margin: f64, path: &Toolpath, observer: &dyn Observer) {
    let width = |i: usize| hull.hi[i] - hull.lo[i];
    let narrow = (0..hull.s.len()).filter(|i| width(*i) < 4.0 * margin).count();
    let Some(worst) = (0..hull.s.len()).min_by(|a, b| width(*a).total_cmp(&width(*b))) else { return };
    if let Some(at) = path.locations.get(worst).filter(|_| narrow > 0) {
        let doubt = Doubt::MarginNotKept {
            margin_deg: margin.to_degrees(),
            locations: narrow,
            least_deg: 0.25 * width(worst).to_degrees(),
            turn: at.turn,
            turn_s_mm: at.turn_s_mm,
        };
        observer.warn(Warning { stage: Stage::Schedule, doubt });
    }
}

/// What is chosen alike for all turns.
#[derive(Clone, Copy)]
struct Choice {
    /// Of the base points from the walls, rad.
    inset: f64,
    /// Length of the level stretches, as a share of the shorter neighbouring turn.
    level: f64,
    /// Angle of the base points, see [`BASE_SHARES`].
    base: f64,
}

/// A choice, carried out.
struct Attempt {
    stretches: Vec<Smoothed>,
    /// See [`turn::cost`].
    cost: f64,
    /// Turns whose base point got a shorter level stretch, and its length, mm.
    shortened: Vec<(u32, f64)>,
    /// Turns scheduled together with the one before.
    merged: Vec<u32>,
}

/// Tries all choices and keeps the one with the least cost.
fn decoupled(
    path: &Toolpath,
    channel: &Channel,
    walls: &Corridor,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Attempt> {
    // A length that was asked for, or a path without inner base points, leaves nothing to choose.
    let given = options.level_stretch_mm.is_some() || path.turns.len() < 2;
    let shares = if given { &LEVEL_SHARES[..1] } else { &LEVEL_SHARES[..] };
    let published = options.settings.base_angle == BaseAngle::ForwardLimit || path.turns.len() < 2;
    let places = if published { &BASE_SHARES[BASE_SHARES.len() - 1..] } else { &BASE_SHARES[..] };
    let choices: Vec<Choice> = BASE_INSETS
        .iter()
        .flat_map(|inset| shares.iter().map(move |level| (*inset, *level)))
        .flat_map(|(inset, level)| places.iter().map(move |base| Choice { inset, level, base: *base }))
        .collect();
    let tried: Vec<Result<std::result::Result<Attempt, PathAngle>>> = parallel::map(&choices, |choice| {
        observer.check(Stage::Schedule)?;
        Ok(attempt(path, walls, options, *choice))
    });
    let mut best: Option<Attempt> = None;
    let mut stuck = [0.0, 0.0];
    for t in tried {
        match t? {
            Ok(a) if best.as_ref().is_none_or(|b| a.cost < b.cost) => best = Some(a),
            Ok(_) => {}
            Err(at) => stuck = at,
        }
    }
    best.ok_or_else(|| {
        let row = walls.s.partition_point(|s| *s < stuck[0]).min(walls.s.len().saturating_sub(1));
        let r = &channel.rows[row];
        Error::infeasible(
            Stage::Schedule,
            format!(
                "the channel leaves no room to turn smoothly at {}: it is {:.6} deg wide there, between {} and {}",
                place(path, row),
                (r.hull_max - r.hull_min).to_degrees(),
                describe(&r.binds_min),
                describe(&r.binds_max)
            ),
            Infeasible::NoRoomToTurn {
                at: path.along(row),
                width_deg: (r.hull_max - r.hull_min).to_degrees(),
                margin_deg: options.settings.margin_deg,
            },
        )
        .advise("allow less clearance, take a more slender or longer tool, or lower schedule.margin_deg")
    })
}

/// Base points, level stretches and all turns for one choice. `Err`: where a key point has no room
/// to bend.
fn attempt(
    path: &Toolpath,
    walls: &Corridor,
    options: &ScheduleOptions,
    choice: Choice,
) -> std::result::Result<Attempt, PathAngle> {
    let (Some(&start), Some(&end)) = (walls.s.first(), walls.s.last()) else { return Err([0.0, 0.0]) };
    let inner = walls.shrunk(choice.inset, MOST);
    let bases: Vec<(u32, f64)> = (1u32..)
        .zip(path.turns.iter().skip(1))
        .filter_map(|(k, t)| path.locations.get(t.first).map(|l| (k, l.s_mm)))
        .collect();
    let longest = path.turns.iter().fold(0.0, |m: f64, t| m.max(t.length_mm)).min(end - start);
    let mut found = Attempt { stretches: Vec::new(), cost: 0.0, shortened: Vec::new(), merged: Vec::new() };
    let mut stretches = Vec::new();
    let [first, last] = options.ends_rad.map_or([None; 2], |ends| ends.map(Some));
    let (mut from, mut open) = (start, SpanEnd::Free(first));
    for (i, &(k, s)) in bases.iter().enumerate() {
        let next = bases.get(i + 1).map_or(end, |b| b.1);
        let short = SHORT_TURN * longest;
        let shorter = (s - from).min(next - s);
        let level =
            if s - from < short || next - s < short { None } else { level(&inner, s, shorter, choice, options) };
        match level {
            Some((theta, length, asked)) => {
                if length < asked {
                    found.shortened.push((k, length));
                }
                stretches.push(PathSpan { from, to: s, start: open, end: SpanEnd::Level(theta, length) });
                (from, open) = (s, SpanEnd::Level(theta, length));
            }
            None => found.merged.push(k),
        }
    }
    stretches.push(PathSpan { from, to: end, start: open, end: SpanEnd::Free(last) });
    found.stretches = parallel::try_map(&stretches, |s| turn::plan(walls, s, choice.inset, options.pace))?;
    found.cost = found.stretches.iter().fold(0.0, |m, s| m.max(s.cost));
    Ok(found)
}

/// Angle, half length and asked-for half length of the level stretch around the base point at `s`:
/// what stays inside over the whole stretch is what lies between the lower wall at its end and the
/// upper wall at its start. Halved until it fits.
fn level(inner: &Corridor, s: f64, shorter: f64, choice: Choice, options: &ScheduleOptions) -> Option<(f64, f64, f64)> {
    let asked = options.level_stretch_mm.unwrap_or(choice.level * shorter);
    let mut length = asked.min(0.4 * shorter);
    for _ in 0..=HALVINGS {
        let (greatest, least) = (inner.at(s - length)[1], inner.at(s + length)[0]);
        if greatest >= least {
            // Exactly the wall at a share of 1.
            return Some((greatest - (1.0 - choice.base) * (greatest - least), length, asked));
        }
        length *= 0.5;
    }
    None
}

impl Attempt {
    fn warn(&self, path: &Toolpath, observer: &dyn Observer) {
        let warn = |doubt: Doubt| observer.warn(Warning { stage: Stage::Schedule, doubt });
        if let Some((turn, length_mm)) = self.shortened.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)) {
            let base_points = path.turns.len().saturating_sub(1);
            warn(Doubt::LevelShortened { count: self.shortened.len(), base_points, turn, length_mm });
        }
        if let Some(first_turn) = self.merged.first().copied() {
            warn(Doubt::TurnsMerged { count: self.merged.len(), first_turn });
        }
    }

    /// Key points and pieces of all stretches in order, joined exactly.
    fn assemble(self) -> (Vec<PathAngle>, Vec<BezierPiece>) {
        let mut keys: Vec<PathAngle> = Vec::new();
        let mut pieces: Vec<BezierPiece> = Vec::new();
        for s in self.stretches {
            let skip = usize::from(!keys.is_empty() && keys.last() == s.keys.first());
            keys.extend(s.keys.into_iter().skip(skip));
            pieces.extend(s.pieces);
        }
        (keys, pieces)
    }
}
