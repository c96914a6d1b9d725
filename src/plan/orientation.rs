//! Cones for each location of a path, where the job asks for more than the one of a root: what
//! `orient/` needs of the channel, and the curves that latitude and longitude follow.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::Setup;
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::{Channel, Cone, Cones, Toolpath, Wheel};
use crate::channel::{self, ChannelOptions, Surroundings};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage, turn_number};
use crate::geometry::{Point, Vector};
use crate::observe::{Observer, Silent};
use crate::orient::{self, DirectionGrid, OrientationKind};
use crate::parallel;
use crate::schedule::{self, ScheduleOptions};

/// Stations of the search: the ball centre and the normal go no farther from one to the next.
const STATION_MM: f64 = 4.0;
const STATION_RAD: f64 = 0.12;
/// Latitudes and longitudes either side of the radial direction that are looked at, rad: at 90°
/// of latitude the tool is along the rotor axis, and the rotary axis about that places nothing.
const MOST_RAD: [f64; 2] = [1.31, 1.75];
/// Cells are free where the arc on their latitude goes on by this either side, as a share of a
/// cell; where it is narrow, by a share of it.
const INSIDE: f64 = 0.5;
/// How often the way is sought with more stations.
const MOST_SEARCHES: usize = 40;
/// Ends of arcs are found to this share of a cell.
const CELL_SHARE: f64 = 0.05;
/// What latitude and longitude keep from the walls while the other is held, degrees, but at most a
/// quarter of the width: at a wall of the one the other has no room.
const KEEP_DEG: f64 = 10.0;
/// No finer grid is tried, degrees.
const FINEST_DEG: f64 = 1.0;

impl Setup {
    /// The path with the cones that the job asks for, and its channel where that was planned on the
    /// way.
    ///
    /// # Errors
    /// Kind `Infeasible` where no tool axis is free, or none that is reached from the others, with
    /// the place; those of the channel.
    pub(crate) fn oriented(
        &self,
        path: Toolpath,
        around: &Surroundings,
        observer: &dyn Observer,
    ) -> Result<(Toolpath, Option<Channel>)> {
        let Some(wheel) = self.wheel.as_ref() else { return Ok((path, None)) };
        match self.job.orientation.kind {
            OrientationKind::Cone => Ok((path, None)),
            OrientationKind::ReferencePlane => {
                let radial = radial(wheel, self.blade.part.mesh.aabb().map(|b| nalgebra::center(&b.min, &b.max)));
                let cones = orient::reference_planes(&path, &radial).ok_or_else(|| no_plane(&path))?;
                Ok((path.with_cones(cones), None))
            }
            OrientationKind::FiveAxis => {
                let mut grid_deg = self.job.orientation.grid_deg;
                loop {
                    match five_axis(self, wheel, &path, (around, grid_deg), observer) {
                        Err(e) if e.kind == ErrorKind::Infeasible && 0.5 * grid_deg >= FINEST_DEG => grid_deg *= 0.5,
                        found => return found.map(|(path, channel)| (path, Some(channel))),
                    }
                }
            }
        }
    }
}

/// From the rotor axis towards the middle of the blade, unit: the virtual axis of the paper.
fn radial(wheel: &Wheel, middle: Option<Point>) -> Vector {
    let out = middle.and_then(|m| (m - wheel.foot(&m)).try_normalize(1e-9));
    out.unwrap_or_else(Vector::x)
}

fn no_plane(path: &Toolpath) -> Error {
    let at = path.along(0);
    let message = "the surface normal is along the radial direction all along the path: there is no reference plane";
    Error::infeasible(Stage::Channel, message, Infeasible::NoToolAxis { at }).advise("take orientation.kind five-axis")
}

/// The path with cones through the middle of what is free, and the channel along them.
fn five_axis(
    setup: &Setup,
    wheel: &Wheel,
    path: &Toolpath,
    (around, grid_deg): (&Surroundings, f64),
    observer: &dyn Observer,
) -> Result<(Toolpath, Channel)> {
    let step_rad = grid_deg.to_radians();
    let along_blade = || Error::usage(Stage::Channel, "the rotor axis is along the blade");
    let grid = DirectionGrid::new(wheel.axis.into_inner(), Vector::x(), step_rad, MOST_RAD).ok_or_else(along_blade)?;
    let mut stations = orient::stations(path, STATION_MM, STATION_RAD);
    let mut free = free_cells(setup, &grid, &path.at(&stations), around, observer)?;
    for _ in 0..MOST_SEARCHES {
        let found = along_way(setup, path, (&grid, &stations, &free), around, observer);
        // What is free may change faster than stations stand, and between two of them the way may
        // lead through what is taken: where it closes, more is looked at.
        let Some(more) = found.as_ref().err().and_then(|e| closer(&stations, e)) else { return found };
        let of_more = free_cells(setup, &grid, &path.at(&more), around, observer)?;
        for (row, cells) in more.into_iter().zip(of_more) {
            let at = stations.partition_point(|s| *s < row);
            stations.insert(at, row);
            free.insert(at, cells);
        }
    }
    along_way(setup, path, (&grid, &stations, &free), around, observer)
}

/// The location at which a channel closes, and those midway to the stations before and behind it,
/// as far as they are none; `None` where all of them are stations.
fn closer(stations: &[usize], e: &Error) -> Option<Vec<usize>> {
    let row = match e.infeasible.as_deref()? {
        Infeasible::NoFreeAngle { at, .. } | Infeasible::ChannelCloses { at, .. } => at.location,
        Infeasible::ChannelClosesOnMove { after, .. } => after.location,
        _ => return None,
    };
    let before = stations[..stations.partition_point(|s| *s < row)].last().copied().unwrap_or(row);
    let after = stations.get(stations.partition_point(|s| *s <= row)).copied().unwrap_or(row);
    let mut more = vec![before.midpoint(row), row, row.midpoint(after)];
    more.dedup();
    more.retain(|r| stations.binary_search(r).is_err());
    (!more.is_empty()).then_some(more)
}

/// The path with cones along the least way through what is free at stations, and its channel.
fn along_way(
    setup: &Setup,
    path: &Toolpath,
    (grid, stations, free): (&DirectionGrid, &[usize], &[orient::FreeCells]),
    around: &Surroundings,
    observer: &dyn Observer,
) -> Result<(Toolpath, Channel)> {
    let s_mm: Vec<f64> = stations.iter().map(|row| path.locations[*row].s_mm).collect();
    let way = orient::least_way(grid, &s_mm, free).map_err(|k| closed(path, stations[k], free[k].contains(&true)))?;
    observer.check(Stage::Channel)?;
    let latitude: Vec<f64> = way.iter().map(|[_, latitude]| *latitude).collect();
    let latitude = orient::between_stations(path, stations, &latitude);
    // Longitude on the latitudes of the way, then latitude on the longitudes found.
    let parallels = |latitude: &[f64]| Cones::along(latitude.iter().map(|l| grid.parallel(*l)).collect());
    let longitude = curve(setup, path, (parallels(&latitude), MOST_RAD[1]), around, observer)?;
    let meridians: Vec<Cone> = longitude.iter().map(|l| grid.meridian(*l)).collect();
    let latitude = curve(setup, path, (Cones::along(meridians), MOST_RAD[0]), around, observer)?;
    let path = path.clone().with_cones(parallels(&latitude));
    let channel = channel::plan_among(around, &setup.job.tool, &path, &setup.channel_options(), observer)?;
    Ok((path, channel))
}

/// What of the grid is free at each station, and within the machine's reach.
fn free_cells(
    setup: &Setup,
    grid: &DirectionGrid,
    few: &Toolpath,
    around: &Surroundings,
    observer: &dyn Observer,
) -> Result<Vec<orient::FreeCells>> {
    // Cells are many times as wide as this; along the cones that are chosen the channel is made as
    // the job asks.
    let options = setup.channel_options().with(|s| {
        s.exact_ends = false;
        s.tolerance_deg = s.tolerance_deg.max(CELL_SHARE * grid.step_rad().to_degrees());
    });
    let mut by_station: Vec<Vec<Vec<[f64; 2]>>> = vec![Vec::with_capacity(grid.latitudes.len()); few.locations.len()];
    let done = AtomicUsize::new(0);
    let circle = |latitude: &f64| {
        observer.check(Stage::Channel)?;
        let circle = few.clone().with_cones(Cones::Same(grid.parallel(*latitude)));
        let found = channel::intervals(around, &setup.job.tool, &circle, &options, &Silent)?;
        observer.progress(Stage::Channel, done.fetch_add(1, Ordering::Relaxed) + 1, grid.latitudes.len());
        Ok(found)
    };
    for found in parallel::try_map(&grid.latitudes, circle)? {
        for (station, free) in by_station.iter_mut().zip(found) {
            station.push(free.iter().map(|f| [f.theta_min, f.theta_max]).collect());
        }
    }
    let reached = reached(setup, grid);
    let margin_rad = INSIDE * grid.step_rad();
    let cells = by_station.iter().map(|intervals| {
        let mut cells = orient::free_cells(grid, intervals, margin_rad);
        cells.iter_mut().zip(&reached).for_each(|(c, r)| *c &= r);
        cells
    });
    Ok(cells.collect())
}

/// Directions of the grid that the machine's rotary axes reach within their travel.
fn reached(setup: &Setup, grid: &DirectionGrid) -> Vec<bool> {
    let machine = &setup.machine;
    let near = crate::artifact::Axes::of_default(machine.axes().len());
    let within = |axis: &Vector| {
        machine.rotary_of_axis(axis, &near).is_some_and(|row| {
            machine.rotary().all(|k| machine.axes()[k].limits.travel.is_none_or(|[lo, hi]| (lo..=hi).contains(&row[k])))
        })
    };
    let directions = grid.latitudes.iter().flat_map(|latitude| {
        let cone = grid.parallel(*latitude);
        grid.longitudes.iter().map(move |longitude| cone.tool_axis(*longitude))
    });
    directions.map(|axis| within(&axis)).collect()
}

/// The smooth curve of the angle along these cones, within `most_rad` either side and well inside
/// what is free: least square of its second derivative.
fn curve(
    setup: &Setup,
    path: &Toolpath,
    (cones, most_rad): (Cones, f64),
    around: &Surroundings,
    observer: &dyn Observer,
) -> Result<Vec<f64>> {
    let path = path.clone().with_cones(cones);
    let options = ChannelOptions { theta_limits_rad: Some([-most_rad, most_rad]), ..setup.channel_options() };
    let walls = channel::plan_among(around, &setup.job.tool, &path, &options, observer)?;
    let options = ScheduleOptions::default().with(|s| {
        s.measure = Measure::SquareSecond;
        s.margin_deg = KEEP_DEG;
    });
    schedule::plan(ScheduleKind::Optimal, &path, &walls, &options, &Silent).map(|s| s.theta)
}

/// The error at a station to which no way leads.
fn closed(path: &Toolpath, row: usize, any_free: bool) -> Error {
    let at = path.along(row);
    let place = format!("turn {}, S = {:.2} mm", turn_number(at.turn), at.turn_s_mm);
    let what = if any_free { "no tool axis that is free is near to those before it" } else { "no tool axis is free" };
    let message = format!("{what} at {place}, {:.3} mm along the blade axis", at.height_mm);
    Error::infeasible(Stage::Channel, message, Infeasible::NoToolAxis { at })
        .advise("let the region end above, take a smaller ball, or a longer or more slender tool")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::error::At;

    fn closes(location: usize) -> Error {
        let at = At { location, turn: 0, turn_s_mm: 0.0, centre_mm: [0.0; 3], height_mm: 0.0 };
        let since = Infeasible::ChannelCloses { at, bounds: Vec::new(), region_may_end_mm: None };
        Error::infeasible(Stage::Channel, "closed", since)
    }

    /// Places between stations come until there are none; other errors bring none.
    #[test]
    fn stations_come_closer_where_a_channel_closes() {
        let stations = [0, 40, 80];
        assert_eq!(closer(&stations, &closes(60)), Some(vec![50, 60, 70]));
        assert_eq!(closer(&stations, &closes(40)), Some(vec![20, 60]));
        assert_eq!(closer(&stations, &closes(80)), Some(vec![60]));
        assert_eq!(closer(&stations, &closes(41)), Some(vec![41, 60]));
        assert_eq!(closer(&[4, 5, 6], &closes(5)), None);
        assert_eq!(closer(&stations, &Error::usage(Stage::Channel, "another")), None);
        let mut all: Vec<usize> = stations.to_vec();
        while let Some(more) = closer(&all, &closes(37)) {
            assert!(more.iter().all(|r| all.binary_search(r).is_err()));
            all.extend(more);
            all.sort_unstable();
        }
        assert!(all.contains(&36) && all.contains(&37) && all.contains(&38) && all.len() < 30, "{all:?}");
    }
}
