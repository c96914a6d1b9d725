//! Rows of opposite places along a blade, for two tools that cut at the same time.

use std::ops::Range;

use super::toolpath::{CutterLocation, PathKind, Toolpath, Turn};
use super::{Axes, AxisMotion, Cones};
use crate::error::EndReason;
use crate::geometry::{Point, Vector};

/// Where a tool's ball touches the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallContact {
    /// Ball centre, mm.
    pub centre: Point,
    /// Contact, on the part or on the stock that is left on it, mm.
    pub contact: Point,
    /// Outward unit normal at the contact.
    pub normal: Vector,
    /// Face or group of the part.
    pub face: u32,
}

/// A place of both tools at the same time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairPlace {
    /// Where the balls of tool 1 and tool 2 touch.
    pub contacts: [BallContact; 2],
    /// Centre of the greatest ball inside the part that touches at the first contact, mm.
    pub held_centre: Point,
    /// Its radius, mm: half the thickness there.
    pub held_radius_mm: f64,
    /// What the normals lack of being opposite, rad.
    pub angle_rad: f64,
    /// Distance of the two normal lines, mm.
    pub apart_mm: f64,
}

/// Why a row goes no farther.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RowEnd {
    /// The part begins or ends here, or the first ball finds no place.
    NoBall,
    /// No other place of the part is opposite: an edge.
    NoPartner,
    /// The normals lack more than is allowed of being opposite.
    Angle,
    /// A contact is not on the airfoil.
    Elsewhere,
    /// The second ball has no room at the opposite place.
    NoRoom,
    /// The two balls come too near to each other: the blade is too thin.
    TooNear,
    /// The opposite place jumps: the sheet midway between the sides branches.
    Jump,
}

impl std::fmt::Display for RowEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            RowEnd::NoBall => "the first ball finds no place",
            RowEnd::NoPartner => "nothing is opposite, as on an edge",
            RowEnd::Angle => "the normals are too far from opposite",
            RowEnd::Elsewhere => "a contact is not on the airfoil",
            RowEnd::NoRoom => "the second ball has no room",
            RowEnd::TooNear => "the balls come too near to each other",
            RowEnd::Jump => "the opposite place jumps",
        })
    }
}

/// Rows along a blade, each run by both tools in lock step, from its top down to its foot.
#[derive(Clone, Debug, PartialEq)]
pub struct PairedRows {
    /// Ball radii of tool 1 and tool 2, mm.
    pub radius_mm: [f64; 2],
    /// Stock left on the part, mm.
    pub stock_mm: f64,
    /// Scallop asked for, mm.
    pub scallop_mm: f64,
    /// Chord tolerance between places, mm.
    pub chord_mm: f64,
    /// Heights of tool 1's ball centre between which rows run, mm.
    pub heights_mm: [f64; 2],
    /// Greatest ridge that was measured between two rows on each side while they were laid, mm.
    pub planned_scallop_mm: [f64; 2],
    /// The rows, side by side: their places.
    pub rows: Vec<Range<usize>>,
    /// So many of them, the last, go round the edges: tool 1 from its side round the edge beyond
    /// the first row to the other side, tool 2 from its side round the edge beyond the last row of
    /// opposite places.
    pub edge_rows: usize,
    /// Heights between which those run, mm; `None`: there are none.
    pub edge_heights_mm: Option<[f64; 2]>,
    /// Of a double helix, which is one row round both edges: the turn of each tool at each place,
    /// from 0. `None`: rows along the blade.
    pub turns: Option<[Vec<u32>; 2]>,
    /// All places, row by row.
    pub places: Vec<PairPlace>,
    /// Why rows ended, with the number of heights at which they did.
    pub ends: Vec<(RowEnd, usize)>,
}

impl PairedRows {
    /// Whether both tools go round the blade on two threads.
    pub fn is_double_helix(&self) -> bool {
        self.turns.is_some()
    }

    /// The turn of a tool at a place: its row, or that of its thread.
    pub fn turn_of(&self, tool: usize, place: usize) -> u32 {
        let row = || self.rows.partition_point(|r| r.end <= place) as u32;
        self.turns.as_ref().and_then(|t| t[tool].get(place).copied()).unwrap_or_else(row)
    }

    /// The places of each turn of a tool: its rows, or the turns of its thread.
    fn runs(&self, tool: usize) -> Vec<Range<usize>> {
        let Some(turns) = &self.turns else { return self.rows.clone() };
        let mut from = 0;
        let run = |of: &[u32]| {
            let start = from;
            from += of.len();
            start..from
        };
        turns[tool].chunk_by(|a, b| a == b).map(run).collect()
    }

    /// The rows of tool 1 (0) or tool 2 (1) as a path, a turn for each: its arc length goes over
    /// the straight way from the end of a row to the start of the next.
    pub fn toolpath(&self, tool: usize, cones: Cones) -> Toolpath {
        let mut locations = Vec::with_capacity(self.places.len());
        let runs = self.runs(tool);
        let mut turns = Vec::with_capacity(runs.len());
        let (mut s_mm, mut last) = (0.0, None::<Point>);
        for (turn, row) in runs.iter().enumerate() {
            let mut start_mm = s_mm;
            for (k, place) in self.places[row.clone()].iter().enumerate() {
                let at = place.contacts[tool];
                s_mm += last.replace(at.centre).map_or(0.0, |before| (at.centre - before).norm());
                if k == 0 {
                    start_mm = s_mm;
                }
                locations.push(CutterLocation {
                    turn: turn as u32,
                    turn_s_mm: s_mm - start_mm,
                    s_mm,
                    centre: at.centre,
                    contact: at.contact,
                    normal: at.normal,
                });
            }
            turns.push(Turn { first: row.start, count: row.len(), length_mm: s_mm - start_mm });
        }
        Toolpath {
            kind: PathKind::Given,
            radius_mm: self.radius_mm[tool],
            disc_radius_mm: 0.0,
            stock_mm: self.stock_mm,
            scallop_mm: self.scallop_mm,
            chord_mm: self.chord_mm,
            region_x_mm: [self.heights_mm[1], self.heights_mm[0]],
            end_reason: EndReason::Region,
            planned_scallop_mm: self.planned_scallop_mm[tool],
            cones,
            axis_turning: None,
            turns,
            locations,
        }
    }

    /// The same with rows of these places only, each within one of its rows; places are numbered
    /// anew.
    #[must_use]
    pub fn only(&self, rows: &[Range<usize>]) -> Self {
        let places: Vec<PairPlace> = rows.iter().flat_map(|r| self.places[r.clone()].iter().copied()).collect();
        let mut end = 0;
        let numbered = |row: &Range<usize>| {
            let from = end;
            end += row.len();
            from..end
        };
        let first = self.places_held();
        let edge_rows = rows.iter().filter(|r| r.start >= first).count();
        let own = |turns: &Vec<u32>| rows.iter().flat_map(|r| turns[r.clone()].iter().copied()).collect();
        let turns = self.turns.as_ref().map(|turns| turns.each_ref().map(own));
        PairedRows { rows: rows.iter().map(numbered).collect(), places, edge_rows, turns, ..self.clone() }
    }

    /// The same with the first of every so many places of a row, and its last.
    #[must_use]
    pub fn thinned(&self, every: usize) -> Self {
        let mut kept = Vec::with_capacity(self.places.len() / every.max(1) + 2 * self.rows.len());
        let mut thin = |row: &Range<usize>| {
            let from = kept.len();
            kept.extend(row.clone().step_by(every.max(1)));
            if row.len() > 1 && !(row.len() - 1).is_multiple_of(every.max(1)) {
                kept.push(row.end - 1);
            }
            from..kept.len()
        };
        let rows = self.rows.iter().map(&mut thin).collect();
        let places = kept.iter().map(|k| self.places[*k]).collect();
        let own = |turns: &Vec<u32>| kept.iter().map(|k| turns[*k]).collect();
        let turns = self.turns.as_ref().map(|turns| turns.each_ref().map(own));
        PairedRows { rows, places, turns, ..self.clone() }
    }

    /// The rows whose places are opposite each other: all but those round the edges.
    pub fn held_rows(&self) -> usize {
        self.rows.len().saturating_sub(self.edge_rows)
    }

    /// Number of places that are opposite each other; those round the edges come behind them.
    pub fn places_held(&self) -> usize {
        self.rows.get(self.held_rows()).map_or(self.places.len(), |r| r.start)
    }

    /// The longest way from a place to the next, of a ball or of a contact, mm: at full feed the
    /// time is in proportion to it.
    pub fn longest_way_mm(&self, place: usize) -> f64 {
        let Some([a, b]) = self.places.get(place..place + 2).map(|w| [&w[0].contacts, &w[1].contacts]) else {
            return 0.0;
        };
        let ways = (0..2).map(|j| (b[j].centre - a[j].centre).norm().max((b[j].contact - a[j].contact).norm()));
        ways.fold(0.0, f64::max)
    }

    /// Length of all rows on a side, mm.
    pub fn length_mm(&self, tool: usize) -> f64 {
        let of = |row: &Range<usize>| -> f64 {
            let places = &self.places[row.clone()];
            places.windows(2).map(|w| (w[1].contacts[tool].centre - w[0].contacts[tool].centre).norm()).sum()
        };
        self.rows.iter().map(of).sum()
    }

    /// Why rows ended, in words, the most frequent first.
    pub fn ends_in_words(&self) -> String {
        let all: usize = self.ends.iter().map(|(_, n)| n).sum();
        let one = |(end, n): &(RowEnd, usize)| format!("{end} ({:.0} %)", 100.0 * *n as f64 / all.max(1) as f64);
        self.ends.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}

/// A stretch of a row that is cut in one motion, and how the table stands at each of its places.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Row, from 0.
    pub row: usize,
    /// Places of the stretch; it begins at the last place of the one before where that is of the
    /// same row.
    pub places: Range<usize>,
    /// The angle of the table at each place, rad; the next stretch begins on the turn that is
    /// nearest to where this one ends.
    pub theta_rad: Vec<f64>,
    /// Room to the ends of what is free for both tools, the least of all places, rad.
    pub margin_rad: f64,
}

impl Held {
    /// A stretch along which the table stands still.
    pub fn still(row: usize, places: Range<usize>, theta_rad: f64, margin_rad: f64) -> Self {
        Held { row, theta_rad: vec![theta_rad; places.len()], places, margin_rad }
    }

    /// The angle at a place, rad; not a number where the stretch has it not.
    pub fn theta_at(&self, place: usize) -> f64 {
        let at = place.checked_sub(self.places.start).and_then(|k| self.theta_rad.get(k));
        at.copied().unwrap_or(f64::NAN)
    }

    /// The angles at its first place and its last, rad.
    pub fn ends_rad(&self) -> [f64; 2] {
        [self.theta_rad.first(), self.theta_rad.last()].map(|end| end.copied().unwrap_or(f64::NAN))
    }

    /// Whether the table stands still.
    pub fn is_still(&self) -> bool {
        self.theta_rad.windows(2).all(|w| w[0] == w[1])
    }

    /// How far the table turns while it is cut, to and fro, rad.
    pub fn turned_rad(&self) -> f64 {
        self.theta_rad.windows(2).map(|w| (w[1] - w[0]).abs()).sum()
    }
}

/// A stretch in the machine.
#[derive(Clone, Debug, PartialEq)]
pub struct StretchMotion {
    /// Which stretch, from 0.
    pub stretch: usize,
    /// Row, from 0.
    pub row: usize,
    /// Its places.
    pub places: Range<usize>,
    /// All axes, a row for each place; of two places also one between them.
    pub motion: AxisMotion,
    /// All axes over its first place and its last, both tools clear of the turning part.
    pub over: [Axes; 2],
    /// How far both tools are lifted there, along their axes, mm.
    pub lifts_mm: [[f64; 2]; 2],
    /// All axes where the way down slows: both tools at the feed height over the first place, or as
    /// far as they are lifted where that is less.
    pub near: Axes,
    /// How far both are lifted there, mm.
    pub near_mm: [f64; 2],
}

impl StretchMotion {
    /// Time of both parts of the way down, and of the way up, s, at these feeds, mm/min.
    pub fn ways_s(&self, approach_mm_min: f64, plunge_mm_min: f64) -> [f64; 3] {
        let longest = |mm: [f64; 2]| mm[0].max(mm[1]);
        let [first, last] = self.lifts_mm;
        let down_mm = [first[0] - self.near_mm[0], first[1] - self.near_mm[1]];
        let ways = [(down_mm, approach_mm_min), (self.near_mm, plunge_mm_min), (last, approach_mm_min)];
        ways.map(|(mm, feed)| 60.0 * longest(mm) / feed)
    }

    /// The row of the motion at a place of the stretch, counted from its first.
    pub fn row_at(&self, place: usize) -> usize {
        if place + 1 == self.places.len() { self.motion.t_s.len().saturating_sub(1) } else { place }
    }
}

/// All stretches.
#[derive(Clone, Debug, PartialEq)]
pub struct PinchMotion {
    /// In order.
    pub stretches: Vec<StretchMotion>,
    /// Time that both tools cut, s.
    pub cutting_s: f64,
    /// Time of the ways down, up and from row to row, about, s: rapids by velocity and acceleration
    /// of the slowest axis.
    pub ways_s: f64,
    /// Time that each tool would take for its side alone, under the same limits, s.
    pub alone_s: [f64; 2],
    /// What tools stay beyond from stretch to stretch: heights over the blade axis of what the part
    /// turns in, mm.
    pub turning_mm: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One row of places at 0, 1, 2 mm … of tool 1; those of tool 2 are so many times as far, and
    /// its contacts as far aside again.
    fn rows(count: usize, second: f64) -> PairedRows {
        let at = |x: f64, aside: f64| {
            let centre = Point::new(x, 0.0, 0.0);
            BallContact { centre, contact: centre + Vector::y() * aside, normal: Vector::y(), face: 0 }
        };
        let place = |k: usize| PairPlace {
            contacts: [at(k as f64, 0.0), at(second * k as f64, second * k as f64)],
            held_centre: Point::origin(),
            held_radius_mm: 1.0,
            angle_rad: 0.0,
            apart_mm: 0.0,
        };
        PairedRows {
            radius_mm: [1.0; 2],
            stock_mm: 0.0,
            scallop_mm: 0.1,
            chord_mm: 0.01,
            heights_mm: [0.0, 1.0],
            planned_scallop_mm: [0.1; 2],
            rows: std::iter::once(0..count).collect(),
            edge_rows: 0,
            edge_heights_mm: None,
            turns: None,
            places: (0..count).map(place).collect(),
            ends: Vec::new(),
        }
    }

    #[test]
    fn thinned_rows_keep_both_ends() {
        let rows = PairedRows { rows: vec![0..7, 7..8, 8..11, 11..11], ..rows(11, 1.0) };
        let of = |every: usize| {
            let thin = rows.thinned(every);
            let heights: Vec<usize> = thin.places.iter().map(|p| p.contacts[0].centre.x as usize).collect();
            (thin.rows, heights)
        };
        assert_eq!(of(1), (rows.rows.clone(), (0..11).collect()));
        assert_eq!(of(3), (vec![0..3, 3..4, 4..6, 6..6], vec![0, 3, 6, 7, 8, 10]));
        assert_eq!(of(4), (vec![0..3, 3..4, 4..6, 6..6], vec![0, 4, 6, 7, 8, 10]));
        assert_eq!(of(0), of(1));
    }

    #[test]
    fn turns_of_a_double_helix_are_those_of_its_threads() {
        let turns = Some([vec![0, 0, 0, 1, 1, 1], vec![0, 0, 1, 1, 1, 2]]);
        let rows = PairedRows { edge_rows: 1, turns, ..rows(6, 2.0) };
        assert!(rows.is_double_helix() && rows.held_rows() == 0 && rows.places_held() == 0);
        let firsts = |tool: usize| -> Vec<(usize, usize)> {
            let path = rows.toolpath(tool, Cones::Same(crate::artifact::Cone::about_blade(0.0)));
            path.turns.iter().map(|t| (t.first, t.count)).collect()
        };
        assert_eq!((firsts(0), firsts(1)), (vec![(0, 3), (3, 3)], vec![(0, 2), (2, 3), (5, 1)]));
        assert_eq!((rows.turn_of(0, 2), rows.turn_of(1, 2)), (0, 1));
        // Tool 2's contact goes farthest: 2 mm along and 2 mm aside.
        assert!((rows.longest_way_mm(3) - 8f64.sqrt()).abs() < 1e-12 && rows.longest_way_mm(5) == 0.0);
        let thin = rows.thinned(2);
        assert_eq!(thin.turns, Some([vec![0, 0, 1, 1], vec![0, 1, 1, 2]]));
        let only = rows.only(std::slice::from_ref(&(2..5)));
        assert_eq!((only.turns, only.edge_rows), (Some([vec![0, 1, 1], vec![1, 1, 1]]), 1));
    }
}
