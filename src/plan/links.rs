//! Links: where no tool axis leads on along the blade, the tool leaves it along its own axis, turns
//! to the other axis, and comes back to the same place along that.
//!
//! On the way the ball stays on the line from the place along the tool axis: up along the first
//! axis, round at one height, down along the second. A tool that grows wider from the ball on is
//! clear all the way up where it is clear on the blade. How high it has to go is found by the
//! channel's closed arcs at places of the turn: as low as the whole tool has room to turn.

use super::Setup;
use crate::artifact::toolpath::{CutterLocation, Link};
use crate::artifact::{Cones, Toolpath};
use crate::channel::{self, Surroundings};
use crate::error::{Error, Infeasible, Result, Stage, turn_number};
use crate::geometry::{Point, Vector};
use crate::numerics::angle::nearest_turn;
use crate::observe::{Doubt, Silent};
use crate::orient::{self, DirectionGrid, Way};

/// From place to place of a link, at most, mm and rad.
const STEP_MM: f64 = 1.0;
const STEP_RAD: f64 = 0.035;
/// What the ball keeps beside the clearance on the turn, mm: moves are chords of it.
const ROOM_MM: f64 = 0.5;
/// Angles either side that are free on the turn, rad: what the smooth curves may be off the way.
const ROOM_RAD: f64 = 0.05;
/// Heights are tried up to so many times the greatest length of the part.
const HIGHEST: f64 = 4.0;
/// How often the way between a height with room and one without is halved.
const HALVINGS: usize = 6;

/// How high the tool goes at rows, between axes: `None` where it has no room at any height.
#[derive(Default)]
pub(super) struct Heights(Vec<(usize, [[f64; 2]; 2], Option<f64>)>);

impl Heights {
    fn known(&self, row: usize, ends: &[[f64; 2]; 2]) -> Option<Option<f64>> {
        self.0.iter().find(|(r, e, _)| *r == row && e == ends).map(|(.., found)| *found)
    }
}

/// A path with links, and what guides the tool axis along it.
pub(super) struct Linked {
    pub path: Toolpath,
    /// The latitude of the way at each row, rad.
    pub latitude: Vec<f64>,
    /// For each row the row of the path without links that it is, or that its link leaves from.
    pub origin: Vec<usize>,
}

impl Linked {
    /// The rows from one to another.
    pub fn part(&self, [first, last]: [usize; 2]) -> Linked {
        let rows: Vec<usize> = (first..=last).collect();
        let mut path = self.path.at(&rows);
        path.turns.retain(|turn| turn.count > 0);
        Linked { path, latitude: self.latitude[first..=last].to_vec(), origin: self.origin[first..=last].to_vec() }
    }

    /// Centres, normals and latitudes: two stretches in which they are the same have the same
    /// curves and channels, wherever along the path they are.
    pub fn places(&self) -> Vec<[f64; 7]> {
        let place = |(l, latitude): (&CutterLocation, &f64)| {
            let (c, n) = (l.centre, l.normal);
            [c.x, c.y, c.z, n.x, n.y, n.z, *latitude]
        };
        self.path.locations.iter().zip(&self.latitude).map(place).collect()
    }

    /// First and last rows of the stretches that reach so far to both sides of rows of the path
    /// without links, mm.
    pub fn about(&self, rows: &[usize], reach_mm: f64) -> Vec<[usize; 2]> {
        let s = |row: usize| self.path.locations[row].s_mm;
        let mut out: Vec<[usize; 2]> = Vec::new();
        for row in (0..self.origin.len()).filter(|k| rows.contains(&self.origin[*k])) {
            let first = self.path.locations.partition_point(|l| l.s_mm < s(row) - reach_mm);
            let last = self.path.locations.partition_point(|l| l.s_mm <= s(row) + reach_mm) - 1;
            match out.last_mut() {
                Some(before) if first <= before[1] => before[1] = last,
                _ => out.push([first, last]),
            }
        }
        out
    }
}

/// The path with a link at each station of the way that is left with another axis than it is
/// reached with.
///
/// # Errors
/// Kind `Infeasible` where the tool has no room to turn anywhere above such a place.
pub(super) fn linked(
    setup: &Setup,
    path: &Toolpath,
    grid: &DirectionGrid,
    (stations, way): (&[usize], &Way),
    (around, heights): (&Surroundings, &mut Heights),
) -> Result<Linked> {
    let (mut links, mut guides) = (Vec::new(), Vec::new());
    for (k, row) in stations.iter().enumerate() {
        let ends = [way.arrives[k], way.leaves[k]];
        guides.push((*row, 0, ends[0][1]));
        if ends[0] == ends[1] {
            continue;
        }
        let ends = free_ends(setup, grid, (path, *row), ends, around)?;
        let turn = Turning { grid, at: &path.locations[*row], ends, contact_rad: setup.middle_contact_rad() };
        let height_mm = match heights.known(*row, &ends) {
            Some(known) => known,
            None => {
                let found = turn.height_mm(setup, path, around)?;
                heights.0.push((*row, ends, found));
                found
            }
        };
        let height_mm = height_mm.ok_or_else(|| no_room(path, *row))?;
        let [up, round] = [turn.up(height_mm, 0.0), turn.round(height_mm)];
        let down: Vec<_> = turn.up(height_mm, 1.0).into_iter().rev().collect();
        let (first, last) = (up.len(), up.len() + round.len());
        guides.extend([(*row, first, ends[0][1]), (*row, last, ends[1][1]), (*row, last + down.len() + 1, ends[1][1])]);
        links.push(Link { row: *row, places: [up, round, down].concat() });
    }
    let (path, origin) = path.with_links(&links);
    let first = |row: usize| origin.partition_point(|of| *of < row);
    let stations: Vec<usize> = guides.iter().map(|(row, on, _)| first(*row) + on).collect();
    let latitudes: Vec<f64> = guides.iter().map(|(.., latitude)| *latitude).collect();
    let latitude = orient::between_stations(&path, &stations, &latitudes);
    Ok(Linked { path, latitude, origin })
}

/// The longitudes moved into what is free on their latitudes, rad: a cell that stands for a gap
/// narrower than itself may lie beside it.
fn free_ends(
    setup: &Setup,
    grid: &DirectionGrid,
    (path, row): (&Toolpath, usize),
    ends: [[f64; 2]; 2],
    around: &Surroundings,
) -> Result<[[f64; 2]; 2]> {
    let few = path.at(&[row, row]).with_cones(Cones::along(ends.map(|[_, l]| grid.parallel(l)).to_vec()));
    let options = setup.channel_options().with(|s| s.exact_ends = false);
    let free = channel::intervals(around, &setup.job.tool, &few, &options, &Silent)?;
    let mut out = ends;
    for (end, layer) in out.iter_mut().zip(&free) {
        let inside = |f: &channel::FreeInterval| {
            let room = ROOM_RAD.min(orient::NARROW * (f.theta_max - f.theta_min));
            let near = nearest_turn(end[0], 0.5 * (f.theta_min + f.theta_max));
            end[0] + (near.clamp(f.theta_min + room, f.theta_max - room) - near)
        };
        let off = |at: &f64| (at - end[0]).abs();
        let nearest = layer.iter().map(inside).min_by(|a, b| off(a).total_cmp(&off(b)));
        end[0] = nearest.unwrap_or(end[0]);
    }
    Ok(out)
}

/// The tool turns from one axis to another over a place of the blade.
struct Turning<'a> {
    grid: &'a DirectionGrid,
    at: &'a CutterLocation,
    /// Longitude and latitude of both axes, rad.
    ends: [[f64; 2]; 2],
    contact_rad: f64,
}

impl Turning<'_> {
    fn angles(&self, share: f64) -> [f64; 2] {
        let [a, b] = self.ends;
        [0, 1].map(|k| a[k] + (b[k] - a[k]) * share)
    }

    fn axis(&self, share: f64) -> Vector {
        let [longitude, latitude] = self.angles(share);
        self.grid.parallel(latitude).tool_axis(longitude)
    }

    /// The ball centre over the place, and a normal under which the axis is within the range of
    /// contact angles.
    fn place(&self, height_mm: f64, share: f64) -> (Point, Vector) {
        let axis = self.axis(share);
        let beside = (self.at.normal - axis * axis.dot(&self.at.normal)).try_normalize(1e-6);
        let normal = axis * self.contact_rad.cos() + beside.unwrap_or_default() * self.contact_rad.sin();
        (self.at.centre + axis * height_mm, normal.try_normalize(1e-9).unwrap_or(axis))
    }

    /// Places on the line up to a height, without the place itself and that height.
    fn up(&self, height_mm: f64, share: f64) -> Vec<(Point, Vector)> {
        let parts = (height_mm / STEP_MM).ceil().max(1.0) as usize;
        (1..parts).map(|k| self.place(height_mm * k as f64 / parts as f64, share)).collect()
    }

    /// Places of the turn at a height, with both its ends.
    fn round(&self, height_mm: f64) -> Vec<(Point, Vector)> {
        let parts = self.parts(height_mm);
        (0..=parts).map(|k| self.place(height_mm, k as f64 / parts as f64)).collect()
    }

    fn parts(&self, height_mm: f64) -> usize {
        let rad = self.axis(0.0).angle(&self.axis(1.0));
        (rad / STEP_RAD).max(rad * height_mm / STEP_MM).ceil().max(1.0) as usize
    }

    /// The least height at which the whole tool has room on all of the turn, about.
    fn height_mm(&self, setup: &Setup, path: &Toolpath, around: &Surroundings) -> Result<Option<f64>> {
        let box_mm = setup.blade.part.mesh.aabb().map_or(0.0, |b| (b.max - b.min).norm());
        let (mut low, mut high) = (0.0, path.radius_mm);
        while !self.has_room(setup, path, around, high)? {
            (low, high) = (high, 2.0 * high);
            if high > HIGHEST * box_mm {
                return Ok(None);
            }
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *(if self.has_room(setup, path, around, middle)? { &mut high } else { &mut low }) = middle;
        }
        Ok(Some(high))
    }

    fn has_room(&self, setup: &Setup, path: &Toolpath, around: &Surroundings, height_mm: f64) -> Result<bool> {
        let parts = self.parts(height_mm);
        let places = self.round(height_mm);
        let need_mm = path.radius_mm + setup.job.channel.clearance_mm + ROOM_MM;
        let bodies = || std::iter::once(&setup.blade.part).chain(setup.obstacles.iter().map(|o| &o.part));
        let is_off = |p: &Point| bodies().all(|part| part.closest_on_mesh(p, need_mm).is_none());
        if !places.iter().all(|(centre, _)| is_off(centre)) {
            return Ok(false);
        }
        let locations = places.iter().map(|(centre, normal)| CutterLocation {
            centre: *centre,
            contact: *centre,
            normal: *normal,
            ..*self.at
        });
        let angles: Vec<[f64; 2]> = (0..=parts).map(|k| self.angles(k as f64 / parts as f64)).collect();
        let cones = Cones::along(angles.iter().map(|[_, latitude]| self.grid.parallel(*latitude)).collect());
        let turn = Toolpath { locations: locations.collect(), cones, turns: Vec::new(), ..path.clone() };
        let options = setup.channel_options().with(|s| s.exact_ends = false);
        let free = channel::intervals(around, &setup.job.tool, &turn, &options, &Silent)?;
        let is_free = |(layer, [longitude, _]): (&Vec<channel::FreeInterval>, &[f64; 2])| {
            layer.iter().any(|f| orient::holds(&[f.theta_min, f.theta_max], *longitude, ROOM_RAD))
        };
        Ok(free.iter().zip(&angles).all(is_free))
    }
}

impl Setup {
    /// A contact angle in the middle of the permitted range, but along the normal where that is
    /// permitted, rad.
    fn middle_contact_rad(&self) -> f64 {
        let (least, most) = (self.least_contact_deg(), self.job.channel.contact_angle_max_deg);
        if least > 0.0 { (0.5 * (least + most)).to_radians() } else { 0.0 }
    }
}

/// Where the tool leaves the blade on the way, if it does.
pub(super) fn doubt(path: &Toolpath) -> Option<Doubt> {
    let l = &path.locations;
    let starts = |w: &&[CutterLocation]| w[0].touches() && !w[1].touches();
    let first = l.windows(2).find(starts)?[0];
    let links = l.windows(2).filter(starts).count();
    let moves = l.windows(2).filter(|w| !w[0].touches() || !w[1].touches());
    let length_mm = moves.map(|w| (w[1].centre - w[0].centre).norm()).sum();
    Some(Doubt::TurnsCut { links, turn: first.turn, turn_s_mm: first.turn_s_mm, length_mm })
}

fn no_room(path: &Toolpath, row: usize) -> Error {
    let at = path.along(row);
    let place = format!("turn {}, S = {:.2} mm", turn_number(at.turn), at.turn_s_mm);
    let message = format!("no tool axis leads on at {place}, and the tool has no room above it to turn to another one");
    Error::infeasible(Stage::Channel, message, Infeasible::NoToolAxis { at })
        .advise("let the region end above, take a smaller ball, or a longer or more slender tool")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two turns of 36 places; the tool leaves at location 20 by three places and comes back.
    fn with_a_link() -> Linked {
        let path = crate::sample::plan(2, 36).toolpath;
        let at = path.locations[20];
        let places = (1..=3).map(|k| (at.centre + at.normal * f64::from(k), at.normal)).collect();
        let (path, origin) = path.with_links(&[Link { row: 20, places }]);
        Linked { latitude: (0..origin.len()).map(|k| k as f64).collect(), path, origin }
    }

    #[test]
    fn stretches_about_places_hold_what_is_within_reach_and_are_one_where_they_meet() {
        let linked = with_a_link();
        let s = |row: usize| linked.path.locations[row].s_mm;
        let reach_mm = 3.5 * (s(11) - s(10));
        // On the blade, and about a link all of it, from where it leaves to where it comes back.
        assert_eq!(linked.about(&[10], reach_mm), [[7, 13]]);
        let [first, last] = linked.about(&[20], reach_mm)[0];
        assert_eq!(linked.origin[20..=24], [20; 5]);
        assert!(first == 17 && s(last) - s(24) <= reach_mm && s(last + 1) - s(24) > reach_mm, "{first} {last}");
        assert_eq!(linked.about(&[10, 14], reach_mm), [[7, linked.about(&[14], reach_mm)[0][1]]]);
        // Ends of the path cut them short; far places have stretches of their own.
        let end = linked.origin.len() - 1;
        let about = linked.about(&[0, 72], reach_mm);
        assert_eq!((about[0], about[1][1]), ([0, 3], end));
        assert!(linked.about(&[], reach_mm).is_empty());
    }

    #[test]
    fn a_part_of_a_path_has_its_rows_and_whole_turns() {
        let linked = with_a_link();
        for rows in [[7, 13], [17, 28], [30, 50], [0, linked.origin.len() - 1]] {
            let part = linked.part(rows);
            let [first, last] = rows;
            assert_eq!(part.path.locations, linked.path.locations[first..=last]);
            assert_eq!(part.origin, linked.origin[first..=last]);
            assert_eq!(part.latitude, linked.latitude[first..=last]);
            let counts: Vec<usize> = part.path.turns.iter().map(|turn| turn.count).collect();
            assert!(counts.iter().all(|count| *count > 0) && counts.iter().sum::<usize>() == last - first + 1);
            assert!(part.path.turns.windows(2).all(|w| w[0].first + w[0].count == w[1].first));
        }
    }
}
