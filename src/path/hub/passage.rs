//! The passage between two neighbouring blades of a wheel, along its hub.
//!
//! Places are cylindrical coordinates about the rotor axis: `z` along it, the angle `φ` round it.
//! At each of a row of stations along `z` the ball is rolled over the hub to both sides, until it
//! touches a blade or its fillet. Before and behind the blades nothing stops it; there a passage is
//! one pitch wide, so that those of all blades together cover the hub.

use super::super::level::{LevelSet, Touch};
use crate::artifact::RotorFrame;
use crate::geometry::Point;
use crate::numerics::angle::within_half_turn;

/// Stations stand so many ball radii apart.
const STATION: f64 = 0.15;
/// The ball is rolled sideways by so many radii at a time.
const SIDEWAYS: f64 = 0.25;
/// Halvings of such a step until the place where it leaves the hub is known.
const HALVINGS: usize = 32;
/// A ball that is moved onto the hub goes round the axis by no more than this, in ball radii: one
/// that goes farther was in a blade.
const ASIDE: f64 = 1e-4;
/// ... over facets so much more, of the way that it goes out or in.
const ASIDE_FACETS: f64 = 0.2;
/// Where the contact goes a smaller share of the ball's way along the axis, the ball rolls over the
/// hub's edge.
const OVER_EDGE: f64 = 0.3;
/// The middle of the passage stands aside of where the stations before let expect it by no more
/// than this, in ball radii.
const JUMP: f64 = 0.1;
/// Rows go on before and behind the blades by so many radii, where there is hub.
const BEYOND: f64 = 1.0;
/// Rows turn away from the middle of the passage by no more than this, mm round the axis by mm
/// along it: round the noses of the blades they are cut short by what a steeper way would clear.
const STEEPEST: f64 = 4.0;
/// Angles at which the hub is looked for.
const SEEDS: usize = 24;
/// The hub lies beside the blade's foot, at most so much of the blade's height above it: not where
/// tips are.
const LOW: f64 = 0.25;
/// Where the ball has no room, balls of this share of the radius are tried, and again, so often.
const SMALLER: (f64, i32) = (0.8, 30);
/// Halvings until the greatest ball that has room is known.
const ROOM_HALVINGS: usize = 10;
/// Steps of a ball that falls towards the rotor axis.
const FALLING: usize = 400;

/// Where the ball may stand on the hub at a place along the rotor axis.
#[derive(Clone, Copy, Debug)]
pub struct Station {
    /// Along the rotor axis, mm.
    pub z_mm: f64,
    /// The middle of the passage, rad.
    pub middle_rad: f64,
    /// From the middle to either blade, rad; half a pitch where there is none.
    pub half_rad: f64,
    /// Distance of the ball's centre from the rotor axis in the middle, mm.
    pub radius_mm: f64,
    /// Where the ball touches there, along the rotor axis, mm.
    contact_z_mm: f64,
}

/// Why there is no passage.
pub enum Closed {
    /// No hub is found between the blades about this place.
    NoHub(Point),
    /// The blades stand nearer than the ball is wide: the place, and the greatest ball that has
    /// room there, mm.
    Gap(Point, f64),
}

/// Where a blade stands on its hub.
pub struct BladeFoot {
    /// A point of the blade at its foot, or over it.
    pub at: Point,
    /// Height of the blade over it, mm.
    pub blade_mm: f64,
}

/// The passage beside the blade in hand, in the sense in which the wheel counts its blades.
pub struct Passage<'a> {
    /// Balls that touch the part.
    pub level: &'a LevelSet<'a>,
    /// About the rotor axis.
    pub frame: &'a RotorFrame,
}

impl Passage<'_> {
    /// The ball on the hub at a place and an angle, sought from a distance from the axis; `None`
    /// where it touches something else there, or nothing.
    pub fn on_hub(&self, z_mm: f64, angle_rad: f64, radius_mm: f64) -> Option<Touch> {
        let ball_mm = self.level.radius_mm;
        let guess = self.frame.point(z_mm, angle_rad, radius_mm);
        let touch = self.level.touch_across(&guess, &self.frame.axis(), 0.6 * ball_mm)?;
        let [_, at, from_axis_mm] = self.frame.of(&touch.centre);
        let aside_mm = within_half_turn(at - angle_rad) * from_axis_mm;
        let by_facets = self.level.is_over_facets();
        // On the hub it goes straight out, or in; over facets nearly so.
        let out_mm = (from_axis_mm - radius_mm).abs();
        let most_mm = ASIDE * ball_mm + if by_facets { ASIDE_FACETS * out_mm } else { 0.0 };
        let is_hub = self.frame.wheel().is_hub(&touch.contact, &touch.normal, by_facets);
        (is_hub && aside_mm.abs() <= most_mm).then_some(touch)
    }

    /// A ball that falls towards the rotor axis from outside the wheel, until it touches something.
    fn fallen(&self, z_mm: f64, angle_rad: f64, from_mm: f64) -> Option<Touch> {
        let ball_mm = self.level.radius_mm;
        let mut radius_mm = from_mm;
        for _ in 0..FALLING {
            let near = self.level.part.closest(&self.frame.point(z_mm, angle_rad, radius_mm), f64::INFINITY)?;
            let free_mm = near.distance_mm - ball_mm;
            if free_mm <= 1e-3 * ball_mm {
                return self.on_hub(z_mm, angle_rad, radius_mm);
            }
            radius_mm -= free_mm;
            if radius_mm <= 0.0 {
                return None;
            }
        }
        None
    }

    /// A station between two blades, at `z_mm`.
    fn first(&self, foot: &BladeFoot) -> Option<Station> {
        let [z_mm, blade_rad, foot_mm] = self.frame.of(&foot.at);
        let pitch = self.frame.pitch_rad();
        let reach_mm = self.level.part.mesh.points.iter().map(|p| self.frame.of(p)[2]).fold(0.0, f64::max);
        let outside_mm = reach_mm + 2.0 * self.level.radius_mm;
        let angles = (1..SEEDS).map(|k| blade_rad + pitch * k as f64 / SEEDS as f64);
        let found = angles.filter_map(|angle| {
            let touch = self.fallen(z_mm, angle, outside_mm)?;
            let [_, _, contact_mm] = self.frame.of(&touch.contact);
            let [_, _, from_axis_mm] = self.frame.of(&touch.centre);
            (contact_mm <= foot_mm + LOW * foot.blade_mm).then_some((angle, from_axis_mm))
        });
        let (angle, from_axis_mm) = found.min_by(|a, b| a.1.total_cmp(&b.1))?;
        self.station(z_mm, angle, from_axis_mm).filter(|(_, ends)| *ends).map(|(station, _)| station)
    }

    /// The station at a place, sought from an angle and a distance from the axis; and whether
    /// blades end it.
    fn station(&self, z_mm: f64, angle_rad: f64, radius_mm: f64) -> Option<(Station, bool)> {
        let start = self.on_hub(z_mm, angle_rad, radius_mm)?;
        let [_, _, from_axis_mm] = self.frame.of(&start.centre);
        let [back, forth] = [-1.0, 1.0].map(|side| self.rolled(z_mm, angle_rad, from_axis_mm, side));
        let pitch = self.frame.pitch_rad();
        let (middle_rad, half_rad, ends) = match (back, forth) {
            (Some(a), Some(b)) if b - a < pitch => (0.5 * (a + b), 0.5 * (b - a), true),
            _ => (angle_rad, 0.5 * pitch, false),
        };
        let middle = self.on_hub(z_mm, middle_rad, from_axis_mm)?;
        let [_, _, radius_mm] = self.frame.of(&middle.centre);
        let [contact_z_mm, ..] = self.frame.of(&middle.contact);
        Some((Station { z_mm, middle_rad, half_rad, radius_mm, contact_z_mm }, ends))
    }

    /// The angle to which a ball rolls over the hub round the axis before it touches something
    /// else; `None` where it rolls on for a pitch.
    fn rolled(&self, z_mm: f64, from_rad: f64, radius_mm: f64, side: f64) -> Option<f64> {
        let step = SIDEWAYS * self.level.radius_mm / radius_mm;
        let at = |angle: f64, radius_mm: f64| {
            let touch = self.on_hub(z_mm, from_rad + side * angle, radius_mm)?;
            let [_, _, from_axis_mm] = self.frame.of(&touch.centre);
            Some(from_axis_mm)
        };
        let (mut good, mut radius_mm) = (0.0, radius_mm);
        loop {
            let next = good + step;
            if next > self.frame.pitch_rad() {
                return None;
            }
            match at(next, radius_mm) {
                Some(from_axis_mm) => (good, radius_mm) = (next, from_axis_mm),
                None => break,
            }
        }
        let mut bad = good + step;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (good + bad);
            match at(middle, radius_mm) {
                Some(from_axis_mm) => (good, radius_mm) = (middle, from_axis_mm),
                None => bad = middle,
            }
        }
        Some(from_rad + side * good)
    }

    /// Stations along the passage, rising along the rotor axis, to both sides of the blade's foot.
    ///
    /// # Errors
    /// See [`Closed`].
    pub fn stations(&self, foot: &BladeFoot) -> Result<Vec<Station>, Closed> {
        let first = self.first(foot).ok_or_else(|| self.why_no_first(foot))?;
        let mut out = self.onwards(&first, -1.0)?;
        out.reverse();
        out.push(first);
        out.extend(self.onwards(&first, 1.0)?);
        Ok(steepened(out))
    }

    /// Stations from one on to one side, until the hub ends or the blades lie behind.
    fn onwards(&self, first: &Station, side: f64) -> Result<Vec<Station>, Closed> {
        let ball_mm = self.level.radius_mm;
        let step_mm = side * STATION * ball_mm;
        let mut out: Vec<Station> = Vec::new();
        let (mut last, mut turn_rad, mut past_mm) = (*first, 0.0, 0.0);
        loop {
            let z_mm = last.z_mm + step_mm;
            let Some((mut next, ends)) = self.station(z_mm, last.middle_rad + turn_rad, last.radius_mm) else {
                return match self.greatest_ball(z_mm, &last) {
                    Some(room_mm) if past_mm == 0.0 => {
                        Err(Closed::Gap(self.frame.point(z_mm, last.middle_rad + turn_rad, last.radius_mm), room_mm))
                    }
                    _ => Ok(out),
                };
            };
            if (next.contact_z_mm - last.contact_z_mm) / step_mm < OVER_EDGE {
                return Ok(out);
            }
            let expected_rad = last.middle_rad + turn_rad;
            let aside_rad = next.middle_rad - expected_rad;
            if ends && (aside_rad * next.radius_mm).abs() > JUMP * ball_mm {
                // Where the ball comes to touch the very front of a blade, that one counts on the
                // one side and may not on the other.
                next.middle_rad = expected_rad;
                next.half_rad -= aside_rad.abs();
            }
            if ends {
                // The way of the middle over the last two radii says where it goes beyond the
                // blades.
                let back = out.len().saturating_sub((2.0 / STATION) as usize);
                if let Some(from) = out.get(back) {
                    turn_rad = (next.middle_rad - from.middle_rad) / (next.z_mm - from.z_mm) * step_mm;
                }
                past_mm = 0.0;
            } else {
                next.middle_rad = last.middle_rad + turn_rad;
                past_mm += step_mm.abs();
            }
            if past_mm > BEYOND * ball_mm {
                return Ok(out);
            }
            out.push(next);
            last = next;
        }
    }

    /// Why no station is found about the blade's foot.
    fn why_no_first(&self, foot: &BladeFoot) -> Closed {
        let with = |radius_mm: f64| {
            let level = LevelSet { radius_mm, ..*self.level };
            Passage { level: &level, frame: self.frame }.first(foot)
        };
        let (share, most) = SMALLER;
        let mut tried = (1..=most).map(|k| self.level.radius_mm * share.powi(k));
        let Some((mut good, mut found)) = tried.find_map(|r| with(r).map(|s| (r, s))) else {
            return Closed::NoHub(foot.at);
        };
        let mut bad = good / share;
        for _ in 0..ROOM_HALVINGS {
            let middle = 0.5 * (good + bad);
            match with(middle) {
                Some(station) => (good, found) = (middle, station),
                None => bad = middle,
            }
        }
        Closed::Gap(self.frame.point(found.z_mm, found.middle_rad, found.radius_mm), good)
    }

    /// The greatest ball that has room on the hub at a place, beside a station where this one has,
    /// mm; `None` where there is no hub for any.
    fn greatest_ball(&self, z_mm: f64, beside: &Station) -> Option<f64> {
        let ball_mm = self.level.radius_mm;
        let has_room = |radius_mm: f64| {
            let level = LevelSet { radius_mm, ..*self.level };
            let passage = Passage { level: &level, frame: self.frame };
            let from_axis_mm = beside.radius_mm - ball_mm + radius_mm;
            passage.station(z_mm, beside.middle_rad, from_axis_mm).is_some()
        };
        let mut good = 0.05 * ball_mm;
        let mut bad = ball_mm;
        if !has_room(good) {
            return None;
        }
        for _ in 0..ROOM_HALVINGS {
            let middle = 0.5 * (good + bad);
            if has_room(middle) { good = middle } else { bad = middle }
        }
        Some(good)
    }
}

/// The same stations, where no width grows faster along the axis than rows may turn away.
fn steepened(mut stations: Vec<Station>) -> Vec<Station> {
    let forth = (1..stations.len()).map(|k| (k - 1, k));
    let back = (1..stations.len()).rev().map(|k| (k, k - 1));
    for (from, to) in forth.chain(back) {
        let (a, b) = (stations[from], stations[to]);
        let most = a.half_rad + STEEPEST * (b.z_mm - a.z_mm).abs() / b.radius_mm;
        stations[to].half_rad = b.half_rad.min(most);
    }
    stations
}
