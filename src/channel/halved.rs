//! What taper, shank and holder leave of the windows of a cutter with a corner.
//!
//! The centre of its disc goes with θ. In a piece of a window it stays within a room of where it is
//! in the middle of the piece; there the search of balls ([`track`]) runs about that centre, with
//! the room added to the clearance, and looks at no angle beyond. A piece that is free with its
//! room is free; others are halved, and their room with them, down to [`ROOM_MM`].

use super::arcs::Witness;
use super::forbidden::{Free, ObstacleScene, PlaceSearch};
use super::samples::Sample;
use super::windows::{Scene, Window};
use super::{ChannelOptions, bound, track};
use crate::error::Result;
use crate::numerics::angle;
use crate::observe::Observer;
use crate::parallel;

/// Half of what the centre moves while one search stands for all angles of a piece, mm.
const ROOM_MM: f64 = 0.05;
/// Halvings of the window at most: where the centre goes farther, pieces get more room.
const MOST_HALVINGS: u32 = 8;
/// Chords by which the way of the centre over a window is measured, and what it is longer by.
const CHORDS: usize = 8;
const LONGER: f64 = 1.1;

/// What is free of windows, place by place.
pub(super) fn clear_of_tool(
    scene: &Scene,
    samples: &[Sample],
    windows: &[Window],
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let all_angles = scene.options.clone().with(|s| {
        (s.contact_angle_min_deg, s.contact_angle_max_deg) = (0.0, 180.0);
    });
    let places = Places { scene, samples, windows, all_angles: &all_angles };
    let rooms = Rooms::of(parallel::map(0..samples.len(), |place| places.way_mm(place)));
    let starts = places.starts(&rooms);
    let mut open: Vec<Piece> = Vec::new();
    let mut decided: Vec<Vec<Decided>> = vec![Vec::new(); samples.len()];
    for halving in 0..=rooms.halvings {
        open.extend(starts.iter().filter(|(at, _)| *at == halving).map(|(_, piece)| *piece));
        // Along the path in one part of the windows, then in the next.
        open.sort_by(|a, b| a.part[0].total_cmp(&b.part[0]).then(a.place.cmp(&b.place)));
        let moved: Vec<Sample> = open.iter().map(|piece| places.moved(piece)).collect();
        let free = track::free_everywhere(&places.with_room(rooms.mm(halving)), &moved, observer)?;
        for (piece, free) in std::mem::take(&mut open).into_iter().zip(free) {
            let Some([from, to]) = places.ends(&piece) else { continue };
            if halving == rooms.halvings || free.iter().any(|f| f.lo <= from && to <= f.hi) {
                decided[piece.place].push(Decided { piece, free });
            } else {
                open.extend(piece.halves());
            }
        }
    }
    let least_room = places.with_room(rooms.mm(rooms.halvings));
    Ok(parallel::map(decided, |pieces| places.joined(pieces, &least_room)))
}

/// How far the centre goes over the windows, and the room of their pieces.
struct Rooms {
    ways_mm: Vec<f64>,
    longest_mm: f64,
    /// Halvings of the longest window until its room is small enough.
    halvings: u32,
}

impl Rooms {
    fn of(ways_mm: Vec<f64>) -> Self {
        let longest_mm = ways_mm.iter().copied().fold(0.0, f64::max);
        let halvings = (longest_mm / (2.0 * ROOM_MM)).log2().ceil().clamp(0.0, f64::from(MOST_HALVINGS)) as u32;
        Rooms { ways_mm, longest_mm, halvings }
    }

    /// Room of a piece after so many halvings, mm.
    fn mm(&self, halving: u32) -> f64 {
        0.5 * self.longest_mm / f64::from(1u32 << halving)
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
struct Places<'a> {
    scene: &'a Scene<'a>,
    samples: &'a [Sample],
    windows: &'a [Window],
    /// What the search keeps to besides windows.
    all_angles: &'a ChannelOptions,
}

impl Places<'_> {
    fn with_room(&self, room_mm: f64) -> ObstacleScene<'_> {
        self.scene.around.scene_with(self.scene.tool, self.all_angles, room_mm)
    }

    /// How far the centre goes over the window of a place, at most, mm.
    fn way_mm(&self, place: usize) -> f64 {
        let Some([low, high]) = self.windows[place] else { return 0.0 };
        let at = |k: usize| low + (high - low) * k as f64 / CHORDS as f64;
        let centre = |k: usize| self.scene.centre(&self.samples[place], at(k)).map(|c| c.0);
        let chords = (0..CHORDS).filter_map(|k| Some((centre(k + 1)? - centre(k)?).norm()));
        CHORDS as f64 * LONGER * chords.fold(0.0, f64::max)
    }

    /// The pieces that are looked at first, each after how many halvings.
    ///
    /// A window has the least room that does for all of it. The tool above its bottom is not far
    /// from the contact: while that is within room and way of it no piece is free, and none is
    /// looked at.
    fn starts(&self, rooms: &Rooms) -> Vec<(u32, Piece)> {
        let bare = self.with_room(0.0);
        let of_place = |place: usize| {
            let whole = (0..=rooms.halvings).rev().find(|k| 0.5 * rooms.ways_mm[place] <= rooms.mm(*k)).unwrap_or(0);
            let contact_mm = self.contact_margin_mm(&bare, place);
            let first = (whole..rooms.halvings).find(|k| 2.0 * rooms.mm(*k) <= contact_mm).unwrap_or(rooms.halvings);
            let count = 1u32 << (first - whole);
            let share = move |k: u32| f64::from(k) / f64::from(count);
            (0..count).map(move |k| (first, Piece { place, part: [share(k), share(k + 1)] }))
        };
        (0..self.samples.len()).filter(|place| self.windows[*place].is_some()).flat_map(of_place).collect()
    }

    /// How far the contact is from taper, shank and holder amid a window, less what these keep
    /// clear by, mm.
    fn contact_margin_mm(&self, bare: &ObstacleScene, place: usize) -> f64 {
        let s = &self.samples[place];
        let middle = self.windows[place].and_then(|[low, high]| self.scene.centre(s, 0.5 * (low + high)));
        let Some(((centre, axis), body)) = middle.zip(bare.bodies.first()) else { return f64::INFINITY };
        let contact = s.centre - s.normal * self.scene.tool.corner_mm();
        bound::margin(&body.profile, &axis, &(contact - centre))
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
        // Somewhat more than that: shorter intervals are not told.
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
