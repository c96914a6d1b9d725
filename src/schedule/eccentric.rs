//! One offset of the plane of tool axes from the blade axis, kept all along: the schedule of a
//! lathe whose Y stands still (eccentric turn-milling).
//!
//! With the ball centre at the distance `ρ` and the azimuth `ψ` from the blade axis, the offset is
//! `e = ρ sin(θ − ψ)` ([`crate::artifact::axis_travel`]), so on the tool's half `θ = ψ + asin(e /
//! ρ)`. An interval of θ is one of `e`, since that rises with θ there. The offsets that all
//! locations allow are the intersection of their intervals; of these the one with most room to the
//! walls is found by bisection: the room to the lower wall grows with `e`, that to the upper one
//! shrinks.
//!
//! A cutter with a corner has the centre of its disc on its axis, and that centre turns about the
//! corner's. Its offset need not rise with θ, so it is looked at in [`LOOKS`] parts of the channel:
//! an offset has the angle nearest to where the location before stands between its walls, and the
//! offset with most room is found by trying. θ may turn back there, as with all schedules of such
//! cutters.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{ScheduleOptions, curve};
use crate::artifact::axis_travel::{CornerPlace, offset_mm};
use crate::artifact::channel::ChannelRow;
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::toolpath::CutterLocation;
use crate::artifact::{Channel, Cone, Schedule, Toolpath};
use crate::error::{Along, Error, Infeasible, Result, Stage, turn_number};
use crate::numerics::angle::nearest_turn;
use crate::observe::Observer;
use crate::parallel;

/// Offsets that are tried where that with most room turns back.
const TRIES: usize = 64;
/// Bisections of an offset.
const HALVINGS: usize = 60;

/// Parts of the channel at a location in which the offset of a disc is looked at.
const LOOKS: usize = 48;
/// Offsets of a disc that are tried, and how often between the two beside the best.
const TRIED: usize = 32;
const TRIED_AGAIN: usize = 3;

/// A location as the offset sees it.
#[derive(Clone, Debug)]
struct CentredPlace {
    /// Distance of the centre of ball or corner from the blade axis, mm.
    rho_mm: f64,
    /// Its azimuth, unwrapped over the path, rad.
    psi: f64,
    /// Angles of the channel, rad.
    walls: [f64; 2],
    /// Of a cutter with a corner.
    disc: Option<PlaceOfDisc>,
}

/// How the offset of a disc goes with θ.
#[derive(Clone, Debug)]
struct PlaceOfDisc {
    at: CornerPlace,
    /// Offsets at evenly spread angles of the channel, ends among them, mm.
    looks_mm: [f64; LOOKS + 1],
}

impl PlaceOfDisc {
    fn new(l: &CutterLocation, cone: Cone, disc_radius_mm: f64, walls: [f64; 2]) -> Self {
        let at = CornerPlace { corner: l.centre, normal: l.normal, cone, disc_radius_mm };
        let mut place = PlaceOfDisc { at, looks_mm: [0.0; LOOKS + 1] };
        place.looks_mm = std::array::from_fn(|k| place.offset_mm(angle_of(walls, k as f64)));
        place
    }

    fn offset_mm(&self, theta: f64) -> f64 {
        offset_mm(&self.at.disc_centre(theta), theta)
    }

    /// Where the channel has an offset: numbers of parts from its lower wall on, as chords between
    /// the looks have them. The nearest look where it has none.
    fn parts(&self, offset_mm: f64) -> Vec<f64> {
        let off = self.looks_mm.map(|look| look - offset_mm);
        let crosses = |k: &usize| (off[*k] <= 0.0) != (off[k + 1] <= 0.0);
        let found: Vec<f64> = (0..LOOKS).filter(crosses).map(|k| k as f64 + off[k] / (off[k] - off[k + 1])).collect();
        if found.is_empty() {
            let nearest = (0..=LOOKS).min_by(|a, b| off[*a].abs().total_cmp(&off[*b].abs()));
            return nearest.map(|k| k as f64).into_iter().collect();
        }
        found
    }

    /// θ at an offset, where several have it the one nearest to a number of parts.
    fn theta(&self, offset_mm: f64, walls: [f64; 2], near: f64) -> f64 {
        let parts = self.parts(offset_mm).into_iter().min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()));
        let part = parts.unwrap_or(near);
        if part.fract() == 0.0 {
            return angle_of(walls, part);
        }
        let ends = [part.floor(), part.floor() + 1.0];
        let [mut low, mut high] = ends.map(|k| angle_of(walls, k));
        let rises = self.looks_mm[ends[0] as usize] <= offset_mm;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (self.offset_mm(middle) <= offset_mm) == rises { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

/// The angle so many parts from the lower wall on, rad.
fn angle_of([low, high]: [f64; 2], parts: f64) -> f64 {
    low + (high - low) * parts / LOOKS as f64
}

impl CentredPlace {
    /// θ at an offset; where the channel or the centre's distance from the axis does not have it,
    /// of the nearest that it has. `near`: where between the walls the place before stands, a
    /// share.
    fn theta(&self, offset_mm: f64, near: f64) -> f64 {
        match &self.disc {
            Some(disc) => disc.theta(offset_mm, self.walls, near * LOOKS as f64),
            None => self.psi + (offset_mm / self.rho_mm).clamp(-1.0, 1.0).asin(),
        }
    }

    /// Offsets within the walls, of balls on the tool's half; `None`: none.
    fn offsets(&self) -> Option<[f64; 2]> {
        if let Some(disc) = &self.disc {
            let least = disc.looks_mm.iter().copied().fold(f64::INFINITY, f64::min);
            return Some([least, disc.looks_mm.iter().copied().fold(f64::NEG_INFINITY, f64::max)]);
        }
        let [lo, hi] = self.walls.map(|wall| (wall - self.psi).clamp(-FRAC_PI_2, FRAC_PI_2));
        let on_half = self.walls[0] - self.psi <= FRAC_PI_2 && self.walls[1] - self.psi >= -FRAC_PI_2;
        on_half.then(|| [lo, hi].map(|angle| self.rho_mm * angle.sin()))
    }

    /// Room of a ball to the lower and to the upper wall, rad.
    fn room(&self, offset_mm: f64) -> [f64; 2] {
        let theta = self.theta(offset_mm, 0.5);
        [theta - self.walls[0], self.walls[1] - theta]
    }

    /// Room of a disc to the nearer wall, rad: at the angle that has most.
    fn room_of_disc(&self, disc: &PlaceOfDisc, offset_mm: f64) -> f64 {
        let room = |parts: f64| parts.min(LOOKS as f64 - parts) * (self.walls[1] - self.walls[0]) / LOOKS as f64;
        disc.parts(offset_mm).into_iter().map(room).fold(0.0, f64::max)
    }
}

/// The angles at an offset, one for each location, rad.
fn angles(places: &[CentredPlace], offset_mm: f64) -> Vec<f64> {
    let mut near = 0.5;
    let mut of = |p: &CentredPlace| {
        let theta = p.theta(offset_mm, near);
        near = ((theta - p.walls[0]) / (p.walls[1] - p.walls[0]).max(1e-12)).clamp(0.0, 1.0);
        theta
    };
    places.iter().map(&mut of).collect()
}

/// See the module's page. The curve is the natural cubic spline through the angles at the
/// locations.
pub(super) fn plan(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    observer.check(Stage::Schedule)?;
    if !path.cones.same().is_some_and(|cone| cone.is_about_blade()) {
        let message = "a schedule of kind eccentric turns the blade about its axis under one lean of the tool";
        return Err(Error::usage(Stage::Schedule, message).advise("leave out orientation.kind"));
    }
    let places = places(path, channel, options.disc_radius_mm);
    let allowed = on_machine(allowed(path, &places)?, options)?;
    let made = |offset_mm: f64| curve::through(ScheduleKind::Eccentric, path, angles(&places, offset_mm), channel);
    let asked = match options.settings.offset_mm {
        Some(asked) => {
            within(path, &places, allowed, asked)?;
            asked
        }
        None => roomiest(&places, allowed),
    };
    let first = made(asked)?;
    if first.reversals == 0 || !channel.sweep.is_round() {
        return Ok(first);
    }
    let turns_back = |schedule: &Schedule| {
        let row = schedule.theta.windows(2).position(|w| w[1] < w[0]).unwrap_or(0);
        let at = path.along(row);
        let message = format!(
            "with the offset {asked:.3} mm the blade would turn back, first at {}: its ball centres come round the blade axis by \
             another way there",
            place(&at)
        );
        Error::infeasible(Stage::Schedule, message, Infeasible::ScheduleFails { at })
            .advise("take schedule.kind time with channel.offset_mm, a range of offsets; `advise` prints the least")
    };
    if options.settings.offset_mm.is_some() {
        return Err(turns_back(&first));
    }
    let [low, high] = allowed;
    let mut others: Vec<f64> = (0..=TRIES).map(|k| low + (high - low) * k as f64 / TRIES as f64).collect();
    others.sort_by(|a, b| (a - asked).abs().total_cmp(&(b - asked).abs()));
    for offset in others {
        observer.check(Stage::Schedule)?;
        let other = made(offset)?;
        if other.reversals == 0 {
            return Ok(other);
        }
    }
    Err(turns_back(&first))
}

/// The locations, with azimuths unwrapped from the one nearest to the channel's middle.
fn places(path: &Toolpath, channel: &Channel, disc_radius_mm: f64) -> Vec<CentredPlace> {
    let mut psi = channel.rows.first().map_or(0.0, |r| 0.5 * (r.theta_min + r.theta_max));
    let place = |(l, r): (&CutterLocation, &ChannelRow)| {
        psi = nearest_turn(l.centre.z.atan2(l.centre.y), psi);
        let rho_mm = l.centre.y.hypot(l.centre.z);
        CentredPlace { rho_mm, psi, walls: [r.theta_min, r.theta_max], disc: None }
    };
    let mut out: Vec<CentredPlace> = path.locations.iter().zip(&channel.rows).map(place).collect();
    if disc_radius_mm > 0.0 {
        let disc = |k: usize| PlaceOfDisc::new(&path.locations[k], path.cone(k), disc_radius_mm, out[k].walls);
        let discs: Vec<PlaceOfDisc> = parallel::map_short(256, 0..out.len(), disc);
        out.iter_mut().zip(discs).for_each(|(place, disc)| place.disc = Some(disc));
    }
    out
}

fn place(at: &Along) -> String {
    format!("turn {}, S = {:.2} mm, {:.3} mm along the blade axis", turn_number(at.turn), at.turn_s_mm, at.height_mm)
}

/// The offsets that all locations allow, mm.
///
/// # Errors
/// Kind `Infeasible`: the two locations that leave none between them.
fn allowed(path: &Toolpath, places: &[CentredPlace]) -> Result<[f64; 2]> {
    let mut best = [(f64::NEG_INFINITY, 0), (f64::INFINITY, 0)];
    for (row, p) in places.iter().enumerate() {
        let Some([low, high]) = p.offsets() else {
            let at = path.along(row);
            // The channel is turns ahead then.
            let turns = ((p.walls[0] - p.psi) / TAU).abs();
            let why = if turns > 0.5 { ": its ball centres do not go round the blade axis" } else { "" };
            let message = format!(
                "no offset of the tool from the blade axis is within the channel at {}{why}: the tool would be on the far side of the \
                 blade axis",
                place(&at)
            );
            return Err(Error::infeasible(Stage::Schedule, message, Infeasible::ScheduleFails { at })
                .advise("`advise` prints the least travel of Y with which a schedule exists"));
        };
        if low > best[0].0 {
            best[0] = (low, row);
        }
        if high < best[1].0 {
            best[1] = (high, row);
        }
    }
    let [(low_mm, low_row), (high_mm, high_row)] = best;
    if low_mm <= high_mm {
        return Ok([low_mm, high_mm]);
    }
    let [low_at, high_at] = [low_row, high_row].map(|row| path.along(row));
    let message = format!(
        "no offset of the tool from the blade axis is within the channel everywhere: it must be at least {low_mm:.3} mm at {} but at \
         most {high_mm:.3} mm at {}",
        place(&low_at),
        place(&high_at)
    );
    Err(Error::infeasible(Stage::Schedule, message, Infeasible::NoOffset { low_at, low_mm, high_at, high_mm })
        .advise("`advise` prints the least travel of Y with which a schedule exists; channel.offset_mm keeps to it"))
}

/// The offsets that the machine has of them.
fn on_machine([low, high]: [f64; 2], options: &ScheduleOptions) -> Result<[f64; 2]> {
    let Some(machine) = options.offset_range_mm else { return Ok([low, high]) };
    let both = [low.max(machine[0]), high.min(machine[1])];
    if both[0] <= both[1] {
        return Ok(both);
    }
    let message = format!(
        "the channel allows offsets of the tool from the blade axis of {low:.3} to {high:.3} mm, Y has {:.3} to {:.3} mm",
        machine[0], machine[1]
    );
    let what = Infeasible::OffsetBeyondTravel { channel_mm: [low, high], travel_mm: machine };
    Err(Error::infeasible(Stage::Schedule, message, what)
        .advise("set the tool off by that much (spindle.gauge_mm), or take a machine with more travel"))
}

/// An offset that the job asks for is one that all locations allow.
fn within(path: &Toolpath, places: &[CentredPlace], [low, high]: [f64; 2], asked: f64) -> Result<()> {
    if (low..=high).contains(&asked) {
        return Ok(());
    }
    let balls = places.iter().enumerate().filter(|(_, p)| p.disc.is_none());
    let nearest = balls.min_by(|a, b| a.1.rho_mm.total_cmp(&b.1.rho_mm));
    let message = match nearest.filter(|n| n.1.rho_mm < asked.abs()) {
        Some((row, p)) => format!(
            "schedule.offset_mm is {asked} mm, but the ball centre comes as near to the blade axis as {:.3} mm, at {}",
            p.rho_mm,
            place(&path.along(row))
        ),
        None => format!("schedule.offset_mm is {asked} mm, the channel allows {low:.3} to {high:.3} mm"),
    };
    let what = Infeasible::OffsetOutside { asked_mm: asked, range_mm: [low, high] };
    Err(Error::infeasible(Stage::Schedule, message, what)
        .advise(format!("take an offset within {low:.3} to {high:.3} mm, or leave schedule.offset_mm out")))
}

/// The offset with most room to both walls.
fn roomiest(places: &[CentredPlace], [mut low, mut high]: [f64; 2]) -> f64 {
    if places.iter().any(|p| p.disc.is_some()) {
        return roomiest_of_discs(places, [low, high]);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let least = |side: usize| places.iter().map(|p| p.room(middle)[side]).fold(f64::INFINITY, f64::min);
        if least(0) < least(1) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The same by trying: room of a disc need not grow or shrink with the offset.
fn roomiest_of_discs(places: &[CentredPlace], [mut low, mut high]: [f64; 2]) -> f64 {
    let of = |p: &CentredPlace, offset: f64| p.disc.as_ref().map_or(f64::INFINITY, |d| p.room_of_disc(d, offset));
    let mut best = 0.5 * (low + high);
    for _ in 0..TRIED_AGAIN {
        let step = (high - low) / TRIED as f64;
        let rooms = parallel::map(0..TRIED + 1, |k| {
            let offset = low + step * k as f64;
            (offset, places.iter().map(|p| of(p, offset)).fold(f64::INFINITY, f64::min))
        });
        best = rooms.iter().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(best, |most| most.0);
        (low, high) = ((best - step).max(low), (best + step).min(high));
    }
    best
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::geometry::Vector;
    use crate::observe::Silent;
    use crate::sample;

    /// The sample's helix with a channel that far from the ball centre's azimuth on either side.
    fn walls(path: &Toolpath, width: impl Fn(usize) -> [f64; 2]) -> Channel {
        let mut channel = sample::plan(path.turns.len(), 360).channel;
        let mut psi = 0.0;
        for (k, (row, l)) in channel.rows.iter_mut().zip(&path.locations).enumerate() {
            psi = nearest_turn(l.centre.z.atan2(l.centre.y), psi);
            [row.theta_min, row.theta_max] = width(k).map(|w| psi + w);
        }
        channel
    }

    #[test]
    fn the_offset_is_kept_and_has_most_room() {
        let path = sample::plan(2, 360).toolpath;
        let rho = path.locations.iter().map(|l| l.centre.y.hypot(l.centre.z)).fold(f64::INFINITY, f64::min);
        let channel = walls(&path, |_| [-0.1, 0.7]);
        let made = plan(&path, &channel, &ScheduleOptions::default(), &Silent).unwrap();
        let offsets: Vec<f64> = path.locations.iter().zip(&made.theta).map(|(l, t)| offset_mm(&l.centre, *t)).collect();
        let [least, greatest] = [
            offsets.iter().copied().fold(f64::INFINITY, f64::min),
            offsets.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ];
        assert!(greatest - least < 1e-9 && made.reversals == 0 && made.kind == ScheduleKind::Eccentric);
        // In the middle of the channel where all centres are equally far from the axis.
        assert!((least / rho - 0.3f64.sin()).abs() < 0.02, "{least} of {rho}");
        let asked = ScheduleOptions::default().with(|s| s.offset_mm = Some(1.5));
        let made = plan(&path, &channel, &asked, &Silent).unwrap();
        assert!((offset_mm(&path.locations[77].centre, made.theta[77]) - 1.5).abs() < 1e-9);
    }

    #[test]
    fn a_disc_keeps_the_offset_of_its_own_centre() {
        let mut path = sample::plan(2, 360).toolpath;
        for l in &mut path.locations {
            l.normal = Vector::new(0.1, l.centre.y, 1.2 * l.centre.z).normalize();
        }
        let mut channel = walls(&path, |_| [0.0, 0.0]);
        // The cutter leans forwards by 3 to 30 degrees.
        let mut azimuth = 0.0;
        for (row, l) in channel.rows.iter_mut().zip(&path.locations) {
            azimuth = nearest_turn(l.normal.z.atan2(l.normal.y), azimuth);
            [row.theta_min, row.theta_max] = [3.0_f64, 30.0].map(|lead| azimuth + lead.to_radians());
        }
        let options = ScheduleOptions { disc_radius_mm: 1.5, ..ScheduleOptions::default() };
        let of_disc = |made: &Schedule| -> Vec<f64> {
            let offset = |(k, theta): (usize, &f64)| {
                let (l, axis) = (&path.locations[k], path.cone(k).tool_axis(*theta));
                let across = (l.normal - axis * axis.dot(&l.normal)).normalize();
                offset_mm(&(l.centre + across * 1.5), *theta)
            };
            made.theta.iter().enumerate().map(offset).collect()
        };
        let made = plan(&path, &channel, &options, &Silent).unwrap();
        let kept = of_disc(&made);
        assert!(kept.iter().all(|e| (e - kept[0]).abs() < 1e-9), "{kept:?}");
        let inside = |(row, theta): (&ChannelRow, &f64)| row.theta_min <= *theta && *theta <= row.theta_max;
        assert!(channel.rows.iter().zip(&made.theta).all(inside));
        // No other offset has more room at the place where it has least.
        let places = places(&path, &channel, 1.5);
        let room = |e: f64| {
            let of = |p: &CentredPlace| p.room_of_disc(p.disc.as_ref().unwrap(), e);
            places.iter().map(of).fold(f64::INFINITY, f64::min)
        };
        let [low, high] = allowed(&path, &places).unwrap();
        let most = (0..=500).map(|k| room(low + (high - low) * f64::from(k) / 500.0)).fold(0.0, f64::max);
        assert!(most > 0.0 && room(kept[0]) > 0.99 * most, "{} of {most}", room(kept[0]));
        let asked = options.with(|s| s.offset_mm = Some(0.9 * low + 0.1 * high));
        let kept = of_disc(&plan(&path, &channel, &asked, &Silent).unwrap());
        assert!(kept.iter().all(|e| (e - (0.9 * low + 0.1 * high)).abs() < 1e-9), "{kept:?}");
        let beyond = options.with(|s| s.offset_mm = Some(high + 1.0));
        let e = plan(&path, &channel, &beyond, &Silent).unwrap_err();
        assert!(e.message.contains("the channel allows"), "{}", e.message);
    }

    #[test]
    fn what_leaves_no_offset_is_named() {
        let path = sample::plan(2, 360).toolpath;
        let n = path.locations.len();
        let channel = walls(&path, |k| {
            if k == 100 {
                [0.3, 0.6]
            } else if k == n - 50 {
                [-0.5, -0.2]
            } else {
                [-0.6, 0.7]
            }
        });
        let e = plan(&path, &channel, &ScheduleOptions::default(), &Silent).unwrap_err();
        let Some(Infeasible::NoOffset { low_at, high_at, low_mm, high_mm }) = e.infeasible.as_deref() else {
            panic!("{e:?}")
        };
        assert!(low_at.location == 100 && high_at.location == n - 50 && *low_mm > 0.0 && *high_mm < 0.0);
        let wide = walls(&path, |_| [-0.6, 0.7]);
        let far = ScheduleOptions::default().with(|s| s.offset_mm = Some(500.0));
        let e = plan(&path, &wide, &far, &Silent).unwrap_err();
        assert!(e.message.contains("as near to the blade axis as"), "{}", e.message);
        let behind = walls(&path, |_| [2.0, 3.0]);
        let e = plan(&path, &behind, &ScheduleOptions::default(), &Silent).unwrap_err();
        assert!(e.message.contains("far side"), "{}", e.message);
    }
}
