//! One offset of the plane of tool axes from the blade axis, kept all along: the schedule of a
//! lathe whose Y stands still (eccentric turn-milling).
//!
//! With the ball centre at the distance `ρ` and the azimuth `ψ` from the blade axis, the offset is
//! `e = ρ sin(θ − ψ)` ([`crate::artifact::axis_travel`]), so on the tool's half `θ = ψ + asin(e /
//! ρ)`. An interval of θ is one of `e`, since that rises with θ there. The offsets that all
//! locations allow are the intersection of their intervals; of these the one with most room to the
//! walls is found by bisection: the room to the lower wall grows with `e`, that to the upper one
//! shrinks.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{ScheduleOptions, curve};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Along, Error, Infeasible, Result, Stage, turn_number};
use crate::numerics::angle::nearest_turn;
use crate::observe::Observer;

/// Offsets that are tried where that with most room turns back.
const TRIES: usize = 64;
/// Bisections of an offset.
const HALVINGS: usize = 60;

/// A location as the offset sees it.
#[derive(Clone, Copy, Debug)]
struct CentredPlace {
    /// Distance of the ball centre from the blade axis, mm.
    rho_mm: f64,
    /// Its azimuth, unwrapped over the path, rad.
    psi: f64,
    /// Angles of the channel, rad.
    walls: [f64; 2],
}

impl CentredPlace {
    /// θ at an offset; where the centre is nearer to the axis than that, of the offset that it has.
    fn theta(&self, offset_mm: f64) -> f64 {
        self.psi + (offset_mm / self.rho_mm).clamp(-1.0, 1.0).asin()
    }

    /// Offsets within the walls, on the tool's half; `None`: none.
    fn offsets(&self) -> Option<[f64; 2]> {
        let [lo, hi] = self.walls.map(|wall| (wall - self.psi).clamp(-FRAC_PI_2, FRAC_PI_2));
        let on_half = self.walls[0] - self.psi <= FRAC_PI_2 && self.walls[1] - self.psi >= -FRAC_PI_2;
        on_half.then(|| [lo, hi].map(|angle| self.rho_mm * angle.sin()))
    }

    /// Room to the lower and to the upper wall, rad.
    fn room(&self, offset_mm: f64) -> [f64; 2] {
        let theta = self.theta(offset_mm);
        [theta - self.walls[0], self.walls[1] - theta]
    }
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
    let places = places(path, channel);
    let allowed = on_machine(allowed(path, &places)?, options)?;
    let made = |offset_mm: f64| {
        let theta = places.iter().map(|p| p.theta(offset_mm)).collect();
        curve::through(ScheduleKind::Eccentric, path, theta, channel)
    };
    let asked = match options.settings.offset_mm {
        Some(asked) => {
            within(path, &places, allowed, asked)?;
            asked
        }
        None => roomiest(&places, allowed),
    };
    let first = made(asked)?;
    if first.reversals == 0 {
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
fn places(path: &Toolpath, channel: &Channel) -> Vec<CentredPlace> {
    let mut psi = channel.rows.first().map_or(0.0, |r| 0.5 * (r.theta_min + r.theta_max));
    let place = |(l, r): (&crate::artifact::toolpath::CutterLocation, &crate::artifact::channel::ChannelRow)| {
        psi = nearest_turn(l.centre.z.atan2(l.centre.y), psi);
        CentredPlace { rho_mm: l.centre.y.hypot(l.centre.z), psi, walls: [r.theta_min, r.theta_max] }
    };
    path.locations.iter().zip(&channel.rows).map(place).collect()
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
    let nearest = places.iter().enumerate().min_by(|a, b| a.1.rho_mm.total_cmp(&b.1.rho_mm));
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::artifact::axis_travel::offset_mm;
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
