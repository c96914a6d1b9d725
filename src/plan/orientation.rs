//! Cones for each location of a path, where the job asks for more than the one of a root: what
//! `orient/` needs of the channel, and the curves that latitude and longitude follow.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::Setup;
use super::links::{self, Heights, Linked};
use crate::artifact::schedule::{Measure, ScheduleKind};
use crate::artifact::toolpath::AxisTurning;
use crate::artifact::{Channel, Cone, Cones, Toolpath, Wheel};
use crate::channel::{self, ChannelOptions, Surroundings};
use crate::error::{Error, ErrorKind, Infeasible, Result, Stage, turn_number};
use crate::geometry::{Point, Vector};
use crate::observe::{Observer, Silent, Warning};
use crate::orient::{self, DirectionGrid, OrientationKind, Way};
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
/// Before all of the way is looked at again, so much of it either side of where it stopped, mm: the
/// smooth curves there follow the walls near by.
const ABOUT_MM: f64 = 40.0;
/// From this search on narrow gaps at which a way stops are no longer looked into.
const PATIENCE: usize = 3;
/// Ends of arcs are found to this share of a cell.
const CELL_SHARE: f64 = 0.05;
/// What latitude and longitude keep from the walls while the other is held, degrees, but at most a
/// quarter of the width: at a wall of the one the other has no room.
const KEEP_DEG: f64 = 10.0;
/// Room for rounding at the ends of travel, mm or rad.
const ROUNDING: f64 = 1e-9;
/// How often the way to the last latitude that the machine reaches is halved.
const HALVINGS: usize = 40;
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
                let (path, channel) = self.on_any_grid(wheel, &path.without_links(), around, observer)?;
                if let Some(doubt) = links::doubt(&path) {
                    observer.warn(Warning { stage: Stage::Channel, doubt });
                }
                Ok((path, Some(channel)))
            }
        }
    }
}

impl Setup {
    /// The path with cones and its channel by the coarsest grid that finds a way.
    fn on_any_grid(
        &self,
        wheel: &Wheel,
        path: &Toolpath,
        around: &Surroundings,
        observer: &dyn Observer,
    ) -> Result<(Toolpath, Channel)> {
        let mut grid_deg = self.job.orientation.grid_deg;
        loop {
            match five_axis(self, wheel, path, (around, grid_deg), observer) {
                Err(e) if is_of_axes(&e) && 0.5 * grid_deg >= FINEST_DEG => grid_deg *= 0.5,
                found => return found,
            }
        }
    }
}

/// Whether other tool axes may mend it.
fn is_of_axes(e: &Error) -> bool {
    use Infeasible::{ChannelCloses, ChannelClosesOnMove, NoFreeAngle, NoToolAxis};
    let of_axes = |i: &Infeasible| {
        matches!(i, NoFreeAngle { .. } | ChannelCloses { .. } | ChannelClosesOnMove { .. } | NoToolAxis { .. })
    };
    e.infeasible.as_deref().is_some_and(of_axes)
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
    let stations = orient::stations(path, STATION_MM, STATION_RAD);
    let free = free_cells(setup, &grid, &path.at(&stations), around, observer)?;
    let closed = vec![false; stations.len()];
    let (narrow, stopped, heights, passed) = (Vec::new(), Vec::new(), Heights::default(), Vec::new());
    let mut search = Search { stations, free, closed, narrow, stopped, heights, passed };
    for tried in 0..MOST_SEARCHES {
        let Stopped { error, rows } = match along_way(setup, path, (&grid, &mut search), around, observer) {
            Ok(found) => return Ok(found),
            Err(stopped) => stopped,
        };
        // What is free may change faster than stations stand, and between two of them the way may
        // lead through what is taken: where it closes, more is looked at.
        // Where that does not help, or leaves a gap too narrow for a smooth schedule, no way leads
        // through gaps any more.
        let (links, of_axes) = (setup.job.orientation.links, is_of_axes(&error));
        if error.kind != ErrorKind::Infeasible || !(of_axes || links) {
            return Err(error);
        }
        let mut more: Vec<usize> = rows.iter().flat_map(|row| closer(&search.stations, *row)).collect();
        more.sort_unstable();
        more.dedup();
        let enough = tried >= PATIENCE || !of_axes || more.is_empty();
        if links && enough && search.close_gaps(path, &rows) {
            more.clear();
        } else if more.is_empty() {
            return Err(error);
        }
        if !more.is_empty() {
            let of_more = free_cells(setup, &grid, &path.at(&more), around, observer)?;
            search.look_at(more, of_more);
        }
    }
    along_way(setup, path, (&grid, &mut search), around, observer).map_err(|stopped| stopped.error)
}

/// What is known of the free tool axes along a path.
struct Search {
    /// Rows that are looked at, rising.
    stations: Vec<usize>,
    free: Vec<FreeStation>,
    /// Stations at which gaps narrower than a cell have turned out to lead nowhere.
    closed: Vec<bool>,
    /// Rows at which the last way leads through such a gap.
    narrow: Vec<usize>,
    /// Rows at which any way so far has stopped.
    stopped: Vec<usize>,
    heights: Heights,
    /// Places of the stretches that have turned out well.
    passed: Vec<Vec<[f64; 7]>>,
}

/// Free directions of the grid at a station.
struct FreeStation {
    all: orient::FreeCells,
    /// Without gaps narrower than a cell.
    wide: orient::FreeCells,
}

impl Search {
    /// The cells that count at each station.
    fn cells(&self) -> Vec<&orient::FreeCells> {
        fn of(free: &FreeStation, closed: bool) -> &orient::FreeCells {
            if closed && free.wide.contains(&true) { &free.wide } else { &free.all }
        }
        self.free.iter().zip(&self.closed).map(|(free, closed)| of(free, *closed)).collect()
    }

    /// Adds stations.
    fn look_at(&mut self, more: Vec<usize>, of_more: Vec<FreeStation>) {
        for (row, free) in more.into_iter().zip(of_more) {
            let at = self.stations.partition_point(|s| *s < row);
            let beside = [at.checked_sub(1), Some(at)].map(|k| k.and_then(|k| self.closed.get(k)).copied());
            self.stations.insert(at, row);
            self.free.insert(at, free);
            self.closed.insert(at, beside.iter().all(|c| *c == Some(true)));
        }
    }

    /// Lets no way lead through narrow gaps near to these rows; whether the last one did.
    fn close_gaps(&mut self, path: &Toolpath, rows: &[usize]) -> bool {
        let at = |row: usize| path.locations.get(row).map_or(0.0, |l| l.s_mm);
        let near = |row: usize| rows.iter().any(|r| (at(*r) - at(row)).abs() <= STATION_MM);
        let mut any = false;
        for (k, row) in self.stations.iter().enumerate().filter(|(_, row)| near(**row)) {
            any |= !self.closed[k] && self.narrow.binary_search(row).is_ok() && self.free[k].wide.contains(&true);
            self.closed[k] = true;
        }
        any
    }

    /// Remembers where a way leads through narrow gaps.
    fn led(&mut self, grid: &DirectionGrid, way: &Way) {
        let is_narrow =
            |k: &usize| [way.arrives[*k], way.leaves[*k]].iter().any(|at| !self.free[*k].wide[grid.cell_of(at)]);
        self.narrow = (0..self.stations.len()).filter(is_narrow).map(|k| self.stations[k]).collect();
    }
}

/// Why a way comes to nothing, and the locations of the path without links at which it stops: of
/// one that leaves no smooth schedule, those at which it leads through narrow gaps.
struct Stopped {
    error: Error,
    rows: Vec<usize>,
}

impl Stopped {
    /// Two stretches of one way: the reason is the first's.
    fn and(mut self, other: Stopped) -> Stopped {
        self.rows.extend(other.rows);
        self
    }
}

impl From<Error> for Stopped {
    fn from(error: Error) -> Self {
        Stopped { error, rows: Vec::new() }
    }
}

/// The location at which a channel closes or no way goes on, and those midway to the stations
/// before and behind it, as far as they are no stations yet.
fn closer(stations: &[usize], row: usize) -> Vec<usize> {
    let before = stations[..stations.partition_point(|s| *s < row)].last().copied().unwrap_or(row);
    let after = stations.get(stations.partition_point(|s| *s <= row)).copied().unwrap_or(row);
    let mut more = vec![before.midpoint(row), row, row.midpoint(after)];
    more.dedup();
    more.retain(|r| stations.binary_search(r).is_err());
    more
}

/// The location at which a channel closes or no way goes on.
fn stops_at(e: &mut Error) -> Option<&mut usize> {
    match e.infeasible.as_deref_mut()? {
        Infeasible::NoFreeAngle { at, .. } | Infeasible::ChannelCloses { at, .. } => Some(&mut at.location),
        Infeasible::ChannelClosesOnMove { after, .. } => Some(&mut after.location),
        Infeasible::NoToolAxis { at } => Some(&mut at.location),
        _ => None,
    }
}

/// The path with cones along the least way through what is free at stations, and its channel.
fn along_way(
    setup: &Setup,
    path: &Toolpath,
    (grid, search): (&DirectionGrid, &mut Search),
    around: &Surroundings,
    observer: &dyn Observer,
) -> std::result::Result<(Toolpath, Channel), Stopped> {
    let s_mm: Vec<f64> = search.stations.iter().map(|row| path.locations[*row].s_mm).collect();
    let way = orient::least_way(grid, &s_mm, &search.cells(), setup.job.orientation.links).map_err(|k| {
        let row = search.stations[k];
        Stopped { error: closed(path, row, search.free[k].all.contains(&true)), rows: vec![row] }
    })?;
    search.led(grid, &way);
    observer.check(Stage::Channel)?;
    let linked = links::linked(setup, path, grid, (&search.stations, &way), (around, &mut search.heights))?;
    let narrow = &search.narrow;
    let stretch = |linked: &Linked, observer: &dyn Observer| {
        let mut closes = Vec::new();
        along(setup, grid, linked, (around, &mut closes), observer).map_err(|mut error| {
            let is_narrow = |row: &usize| narrow.binary_search(row).is_ok();
            let mut rows: Vec<usize> = match is_of_axes(&error) {
                true => closes.iter().filter_map(|row| linked.origin.get(*row).copied()).collect(),
                false => linked.origin.iter().copied().filter(is_narrow).collect(),
            };
            // Of the path that was asked for, without links.
            if let Some(at) = stops_at(&mut error)
                && let Some(origin) = linked.origin.get(*at)
            {
                *at = *origin;
                rows.push(*at);
            }
            rows.sort_unstable();
            rows.dedup();
            Stopped { error, rows }
        })
    };
    // All of it only where nothing stops it any more at the places that have.
    let stretches = linked.about(&search.stopped, ABOUT_MM);
    let passed = &search.passed;
    let short = parallel::map(&stretches, |rows| {
        let part = linked.part(*rows);
        let places = part.places();
        if passed.contains(&places) { Ok(None) } else { stretch(&part, &Silent).map(|_| Some(places)) }
    });
    let mut stops: Vec<Stopped> = Vec::new();
    for found in short {
        match found {
            Ok(places) => search.passed.extend(places),
            Err(stopped) => stops.push(stopped),
        }
    }
    let found = match stops.into_iter().reduce(Stopped::and) {
        Some(stopped) => Err(stopped),
        None => stretch(&linked, observer),
    };
    if let Err(stopped) = &found {
        search.stopped.extend(&stopped.rows);
    }
    found
}

/// The path with smooth cones along its guides, and its channel. Where that closes, `closes` gets
/// every location at which it does.
fn along(
    setup: &Setup,
    grid: &DirectionGrid,
    linked: &Linked,
    (around, closes): (&Surroundings, &mut Vec<usize>),
    observer: &dyn Observer,
) -> Result<(Toolpath, Channel)> {
    let path = &linked.path;
    // Longitude on the latitudes of the way, then latitude on the longitudes found.
    let parallels = |latitude: &[f64]| Cones::along(latitude.iter().map(|l| grid.parallel(*l)).collect());
    let most = [-MOST_RAD[1], MOST_RAD[1]];
    let (longitude, of_longitude) =
        curve(setup, path, (parallels(&linked.latitude), most), (around, closes), observer)?;
    let meridians: Vec<Cone> = longitude.iter().map(|l| grid.meridian(*l)).collect();
    let reach = latitudes(setup, grid);
    let (latitude, of_latitude) = curve(setup, path, (Cones::along(meridians), reach), (around, closes), observer)?;
    let mut path = path.clone().with_cones(parallels(&latitude));
    path.axis_turning = Some(AxisTurning { longitude: of_longitude, latitude: of_latitude });
    let channel = channel::plan_or_gaps(around, &setup.job.tool, &path, &setup.channel_options(), closes, observer)?;
    Ok((path, channel))
}

/// What of the grid is free at each station, and within the machine's reach.
fn free_cells(
    setup: &Setup,
    grid: &DirectionGrid,
    few: &Toolpath,
    around: &Surroundings,
    observer: &dyn Observer,
) -> Result<Vec<FreeStation>> {
    // Cells are many times as wide as this; along the cones that are chosen the channel is made as
    // the job asks.
    let options = setup.channel_options().with(|s| {
        s.exact_ends = false;
        s.tolerance_deg = s.tolerance_deg.max(CELL_SHARE * grid.step_rad().to_degrees());
    });
    let mut by_station: Vec<Vec<Vec<[f64; 2]>>> = vec![Vec::with_capacity(grid.latitudes.len()); few.locations.len()];
    let done = AtomicUsize::new(0);
    let reached = reached(setup, grid);
    let circle = |(row, latitude): (usize, &f64)| {
        observer.check(Stage::Channel)?;
        // Where the machine reaches no longitude of a latitude, what is free there does not matter.
        let of_latitude = reached.chunks(grid.longitudes.len()).nth(row).unwrap_or_default();
        let found = match of_latitude.contains(&true) {
            true => {
                let circle = few.clone().with_cones(Cones::Same(grid.parallel(*latitude)));
                channel::intervals(around, &setup.job.tool, &circle, &options, &Silent)?
            }
            false => vec![Vec::new(); few.locations.len()],
        };
        observer.progress(Stage::Channel, done.fetch_add(1, Ordering::Relaxed) + 1, grid.latitudes.len());
        Ok(found)
    };
    for found in parallel::try_map(grid.latitudes.iter().enumerate(), circle)? {
        for (station, free) in by_station.iter_mut().zip(found) {
            station.push(free.iter().map(|f| [f.theta_min, f.theta_max]).collect());
        }
    }
    let margin_rad = INSIDE * grid.step_rad();
    let within = |mut cells: orient::FreeCells| {
        cells.iter_mut().zip(&reached).for_each(|(c, r)| *c &= r);
        cells
    };
    let station = |intervals: &Vec<Vec<[f64; 2]>>| FreeStation {
        all: within(orient::free_cells(grid, intervals, margin_rad)),
        wide: within(orient::wide_cells(grid, intervals, margin_rad)),
    };
    Ok(by_station.iter().map(station).collect())
}

/// Directions of the grid that the machine's rotary axes reach within their travel.
fn reached(setup: &Setup, grid: &DirectionGrid) -> Vec<bool> {
    let directions = grid.latitudes.iter().flat_map(|latitude| {
        let cone = grid.parallel(*latitude);
        grid.longitudes.iter().map(move |longitude| cone.tool_axis(*longitude))
    });
    directions.map(|axis| reaches(setup, &axis)).collect()
}

/// Whether the rotary axes are within their travel along a tool axis.
fn reaches(setup: &Setup, axis: &Vector) -> bool {
    let (machine, near) = (&setup.machine, crate::artifact::Axes::of_default(setup.machine.axes().len()));
    machine.rotary_of_axis(axis, &near).is_some_and(|row| {
        let is_in = |k: usize| {
            let travel = machine.axes()[k].limits.travel;
            travel.is_none_or(|[lo, hi]| (lo - ROUNDING..=hi + ROUNDING).contains(&row[k]))
        };
        machine.rotary().all(is_in)
    })
}

/// From the least to the greatest latitude that the machine reaches, rad: the wheel is clamped with
/// its rotor axis along one of the rotary axes, so the other one's travel limits latitudes.
fn latitudes(setup: &Setup, grid: &DirectionGrid) -> [f64; 2] {
    let is_in = |latitude: f64| reaches(setup, &grid.parallel(latitude).tool_axis(0.0));
    let mut rows = grid.latitudes.iter().copied().filter(|l| is_in(*l));
    let Some(first) = rows.next() else { return [-MOST_RAD[0], MOST_RAD[0]] };
    let last = rows.next_back().unwrap_or(first);
    let end = |inside: f64, side: f64| {
        let (mut inside, mut outside) = (inside, (inside + side * grid.step_rad()).clamp(-MOST_RAD[0], MOST_RAD[0]));
        if is_in(outside) {
            return outside;
        }
        for _ in 0..HALVINGS {
            let middle = inside.midpoint(outside);
            *(if is_in(middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    };
    [end(first, -1.0), end(last, 1.0)]
}

/// The smooth curve of the angle along these cones, within `limits_rad` and well inside what is
/// free: least square of its second derivative. Second: that, rad²/mm³, and a number that no such
/// curve falls below.
fn curve(
    setup: &Setup,
    path: &Toolpath,
    (cones, limits_rad): (Cones, [f64; 2]),
    (around, closes): (&Surroundings, &mut Vec<usize>),
    observer: &dyn Observer,
) -> Result<(Vec<f64>, [f64; 2])> {
    let path = path.clone().with_cones(cones);
    let options = ChannelOptions { theta_limits_rad: Some(limits_rad), ..setup.channel_options() };
    let walls = channel::plan_or_gaps(around, &setup.job.tool, &path, &options, closes, observer)?;
    let options = ScheduleOptions { own_bound_alone: true, ..ScheduleOptions::default() }.with(|s| {
        s.measure = Measure::SquareSecond;
        s.margin_deg = KEEP_DEG;
    });
    let curve = schedule::plan(ScheduleKind::Optimal, &path, &walls, &options, &Silent)?;
    let square = curve.quality.measure.map_or([0.0; 2], |(_, value, bound)| [value, bound]);
    Ok((curve.theta, square))
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
        assert_eq!(closer(&stations, 60), [50, 60, 70]);
        assert_eq!(closer(&stations, 40), [20, 60]);
        assert_eq!(closer(&stations, 80), [60]);
        assert_eq!(closer(&stations, 41), [41, 60]);
        assert!(closer(&[4, 5, 6], 5).is_empty());
        assert_eq!(stops_at(&mut closes(60)), Some(&mut 60));
        assert_eq!(stops_at(&mut Error::usage(Stage::Channel, "another")), None);
        let mut all: Vec<usize> = stations.to_vec();
        loop {
            let more = closer(&all, 37);
            if more.is_empty() {
                break;
            }
            assert!(more.iter().all(|r| all.binary_search(r).is_err()));
            all.extend(more);
            all.sort_unstable();
        }
        assert!(all.contains(&36) && all.contains(&37) && all.contains(&38) && all.len() < 30, "{all:?}");
    }
}
