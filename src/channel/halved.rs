//! What taper, shank and holder leave of the windows of a cutter with a corner.
//!
//! The centre of its disc goes with θ. In a piece of a window it stays within a room of where it is
//! in the middle of the piece; there the search of balls ([`track`]) runs about that centre, with
//! the room added to the clearance, and looks at no angle beyond. A piece that is free with its
//! room is free; others are halved until less room does for each half, down to [`ROOM_MM`].

use super::arcs::Witness;
use super::forbidden::{Free, ObstacleScene, PlaceSearch};
use super::samples::Sample;
use super::windows::{Window, WindowScene};
use super::{ChannelOptions, bound, track};
use crate::error::Result;
use crate::numerics::angle;
use crate::observe::Observer;
use crate::parallel;

/// Half of what the centre moves while one search stands for all angles of a piece, mm.
const ROOM_MM: f64 = 0.05;
/// Halvings of the room at most: where the centre goes farther, the least room is greater.
const MOST_HALVINGS: u32 = 8;
/// The part of a window that is halved no more: as the centre goes with θ unevenly, some pieces are
/// smaller than others that need the same room.
const LEAST_PART: f64 = 1.0 / 16_384.0;
/// Where in a piece the distance of the centre from that in the middle is measured, and what the
/// greatest distance between these places is more than at them.
const MEASURED_AT: [f64; 4] = [0.0, 0.25, 0.75, 1.0];
const BETWEEN: f64 = 1.05;

/// What is free of windows, place by place.
pub(super) fn clear_of_tool(
    scene: &WindowScene,
    samples: &[Sample],
    windows: &[Window],
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let all_angles = scene.options.clone().with(|s| {
        (s.contact_angle_min_deg, s.contact_angle_max_deg) = (0.0, 180.0);
    });
    let places = WindowPlaces { scene, samples, windows, all_angles: &all_angles };
    let whole = |place| Piece { place, part: [0.0, 1.0] };
    let reaches_mm = parallel::map(0..samples.len(), |place| places.reach_mm(&whole(place)).unwrap_or(0.0));
    let rooms = Rooms::of(reaches_mm.into_iter().fold(0.0, f64::max));
    let contacts_mm = places.contact_margins_mm();
    let mut open: Vec<Vec<Piece>> = vec![Vec::new(); rooms.halvings as usize + 1];
    let sort_in = |open: &mut Vec<Vec<Piece>>, piece: Piece, least| {
        let fitting = places.fitting(piece, &rooms, contacts_mm[piece.place], least);
        fitting.into_iter().for_each(|(halving, piece)| open[halving as usize].push(piece));
    };
    let windowed = (0..samples.len()).filter(|place| windows[*place].is_some());
    windowed.for_each(|place| sort_in(&mut open, whole(place), 0));
    let mut decided: Vec<Vec<Decided>> = vec![Vec::new(); samples.len()];
    for halving in 0..=rooms.halvings {
        let mut pieces = std::mem::take(&mut open[halving as usize]);
        // Along the path in one part of the windows, then in the next.
        pieces.sort_by(|a, b| a.part[0].total_cmp(&b.part[0]).then(a.place.cmp(&b.place)));
        let moved: Vec<Sample> = pieces.iter().map(|piece| places.moved(piece)).collect();
        let free = track::free_everywhere(&places.with_room(rooms.mm(halving)), &moved, observer)?;
        for (piece, free) in pieces.into_iter().zip(free) {
            let Some([from, to]) = places.ends(&piece) else { continue };
            if halving == rooms.halvings || free.iter().any(|f| f.lo <= from && to <= f.hi) {
                decided[piece.place].push(Decided { piece, free });
            } else {
                piece.halves().into_iter().for_each(|half| sort_in(&mut open, half, halving + 1));
            }
        }
    }
    let least_room = places.with_room(rooms.mm(rooms.halvings));
    Ok(parallel::map(decided, |pieces| places.joined(pieces, &least_room)))
}

/// The rooms that pieces are looked at with.
struct Rooms {
    greatest_mm: f64,
    /// Halvings of the greatest until it is small enough.
    halvings: u32,
}

impl Rooms {
    fn of(greatest_mm: f64) -> Self {
        let halvings = (greatest_mm / ROOM_MM).log2().ceil().clamp(0.0, f64::from(MOST_HALVINGS)) as u32;
        Rooms { greatest_mm, halvings }
    }

    /// The room after so many halvings, mm.
    fn mm(&self, halving: u32) -> f64 {
        self.greatest_mm / f64::from(1u32 << halving)
    }

    /// The halvings after which the room is the least that does for a reach, if any does.
    fn least_for(&self, reach_mm: f64) -> Option<u32> {
        (0..=self.halvings).rev().find(|halving| reach_mm <= self.mm(*halving))
    }
}

/// A piece of the window of a place.
#[derive(Clone, Copy)]
struct Piece {
    place: usize,
    /// From and to, as shares of the window.
    part: [f64; 2],
}

impl Piece {
    fn halves(&self) -> [Piece; 2] {
        let [from, to] = self.part;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|part| Piece { part, ..*self })
    }
}

/// A piece, and what is free of it and beside it.
#[derive(Clone)]
struct Decided {
    piece: Piece,
    free: Vec<Free>,
}

/// The places of a path with their windows.
struct WindowPlaces<'a> {
    scene: &'a WindowScene<'a>,
    samples: &'a [Sample],
    windows: &'a [Window],
    /// What the search keeps to besides windows.
    all_angles: &'a ChannelOptions,
}

impl WindowPlaces<'_> {
    fn with_room(&self, room_mm: f64) -> ObstacleScene<'_> {
        self.scene.around.scene_with(self.scene.tool, self.all_angles, room_mm)
    }

    /// How far the centre goes from where it is amid a piece, at most, mm.
    fn reach_mm(&self, piece: &Piece) -> Option<f64> {
        let [from, to] = self.ends(piece)?;
        let centre = |at: f64| self.scene.centre(&self.samples[piece.place], from + (to - from) * at).map(|c| c.0);
        let middle = centre(0.5)?;
        let reaches = MEASURED_AT.iter().filter_map(|at| Some((centre(*at)? - middle).norm()));
        Some(BETWEEN * reaches.fold(0.0, f64::max))
    }

    /// The parts of a piece that are looked at, each with the least room that does for it, after
    /// `least` halvings or more.
    ///
    /// The tool above its bottom is not far from the contact: while that is within room and way of
    /// it no piece is free, and none is looked at. What is too small for the least room is not
    /// free.
    fn fitting(&self, piece: Piece, rooms: &Rooms, contact_mm: f64, least: u32) -> Vec<(u32, Piece)> {
        let mut found = Vec::new();
        let mut open = vec![piece];
        while let Some(piece) = open.pop() {
            let Some(reach_mm) = self.reach_mm(&piece) else { continue };
            let fits =
                |halving: u32| halving >= least && (halving == rooms.halvings || 2.0 * rooms.mm(halving) <= contact_mm);
            match rooms.least_for(reach_mm).filter(|halving| fits(*halving)) {
                Some(halving) => found.push((halving, piece)),
                None if piece.part[1] - piece.part[0] > LEAST_PART => open.extend(piece.halves()),
                None => {}
            }
        }
        found
    }

    /// How far the contact is from taper, shank and holder amid each window, less what these keep
    /// clear by, mm.
    fn contact_margins_mm(&self) -> Vec<f64> {
        let bare = self.with_room(0.0);
        let of_place = |(s, window): (&Sample, &Window)| {
            let middle = window.and_then(|[low, high]| self.scene.centre(s, 0.5 * (low + high)));
            let Some(((centre, axis), body)) = middle.zip(bare.bodies.first()) else { return f64::INFINITY };
            let contact = s.centre - s.normal * self.scene.tool.corner_mm();
            bound::margin(&body.profile, &axis, &(contact - centre))
        };
        self.samples.iter().zip(self.windows).map(of_place).collect()
    }

    /// θ at the ends of a piece.
    fn ends(&self, piece: &Piece) -> Window {
        let [low, high] = self.windows[piece.place]?;
        Some(piece.part.map(|at| if at == 1.0 { high } else { low + (high - low) * at }))
    }

    /// A place with the disc's centre amid a piece of its window, at which that piece is looked at.
    fn moved(&self, piece: &Piece) -> Sample {
        let s = self.samples[piece.place];
        let Some([from, to]) = self.ends(piece) else { return s };
        let azimuth = 0.5 * (from + to);
        let centre = self.scene.centre(&s, azimuth).map_or(s.centre, |c| c.0);
        // Somewhat more than that: shorter intervals are not found.
        let beyond = 2.0 * self.all_angles.settings.tolerance_deg.to_radians();
        Sample { centre, azimuth, within_rad: Some(0.5 * (to - from) + beyond), ..s }
    }

    /// What is free of the window of a place, given its pieces.
    fn joined(&self, mut pieces: Vec<Decided>, least_room: &ObstacleScene) -> Vec<Free> {
        pieces.sort_by(|a, b| a.piece.part[0].total_cmp(&b.piece.part[0]));
        let mut list = Vec::new();
        for Decided { piece, free } in &pieces {
            let ends = self.ends(piece).zip(self.windows[piece.place]);
            ends.iter().for_each(|(ends, window)| free.iter().for_each(|f| join(&mut list, f, *ends, *window)));
        }
        // Where a piece is free to its end, what ends that stands in the piece beside it.
        let named = |end: f64, by: &mut Witness, side: usize| {
            let beside = pieces.iter().find(|d| self.ends(&d.piece).is_some_and(|ends| ends[side] == end));
            if let (Witness::Cut, Some(beside)) = (*by, beside) {
                *by = witness(least_room, &self.moved(&beside.piece), end);
            }
        };
        for f in &mut list {
            named(f.lo, &mut f.lo_by, 1);
            named(f.hi, &mut f.hi_by, 0);
        }
        list
    }
}

/// What ends the free interval that ends nearest to θ at a place, rad.
fn witness(scene: &ObstacleScene, place: &Sample, theta: f64) -> Witness {
    let all_round = Sample { within_rad: None, ..*place };
    let free = PlaceSearch::new(scene).free(&all_round.view(), &place.normal, None);
    let off = |end: f64| (angle::nearest_turn(place.azimuth + end, theta) - theta).abs();
    let ends = free.iter().flat_map(|f| [(off(f.lo), f.lo_by), (off(f.hi), f.hi_by)]);
    ends.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(Witness::Cut, |(_, by)| by)
}

/// Takes what of a free interval lies in a piece of a window to those before it.
fn join(list: &mut Vec<Free>, free: &Free, [from, to]: [f64; 2], [low, high]: [f64; 2]) {
    let mut new = *free;
    if new.lo <= from {
        (new.lo, new.lo_by) = (from, if from == low { Witness::Contact } else { Witness::Cut });
    }
    if new.hi >= to {
        (new.hi, new.hi_by) = (to, if to == high { Witness::Contact } else { Witness::Cut });
    }
    if new.lo > new.hi {
        return;
    }
    match list.last_mut() {
        Some(last) if last.hi >= new.lo => (last.hi, last.hi_by) = (new.hi, new.hi_by),
        _ => list.push(new),
    }
}
