//! Leads put to the ends of path and schedule, for the feed, and the motion of both taken apart
//! again.

use crate::artifact::toolpath::CutterLocation;
use crate::artifact::{AxisMotion, AxisRows, Lead, Schedule, Toolpath};

/// Path and schedule with the leads at their ends. Arc lengths go on before the start, below 0, and
/// behind the end. Only what the feed needs is made: locations, their angles and arc lengths; turns
/// and pieces of the schedule are those of the path alone.
pub fn extended(path: &Toolpath, schedule: &Schedule, leads: &[Lead; 2]) -> (Toolpath, Schedule) {
    let (mut path, mut schedule) = (path.clone(), schedule.clone());
    let [before, after] = leads;
    path.cones = path.cones.extended([before.centres.len(), after.centres.len()]);
    if let Some(first) = path.locations.first().copied() {
        let rows = rows(before, &first, -1.0);
        path.locations.splice(0..0, rows);
        schedule.theta.splice(0..0, before.theta.iter().copied());
    }
    if let Some(last) = path.locations.last().copied() {
        path.locations.extend(rows(after, &last, 1.0));
        schedule.theta.extend(&after.theta);
    }
    (path, schedule)
}

/// The rows of a lead as locations: the contact moves with the ball.
fn rows(lead: &Lead, end: &CutterLocation, sign: f64) -> Vec<CutterLocation> {
    let n = lead.centres.len();
    let row = |(i, centre): (usize, &crate::geometry::Point)| {
        let steps = if sign < 0.0 { n - i } else { i + 1 };
        let along = sign * lead.radius_mm * lead.angle_rad * steps as f64 / n as f64;
        CutterLocation {
            turn_s_mm: end.turn_s_mm + along,
            s_mm: end.s_mm + along,
            centre: *centre,
            contact: end.contact + (centre - end.centre),
            ..*end
        }
    };
    lead.centres.iter().enumerate().map(row).collect()
}

/// The motion over [`extended`] taken apart: the path's, and the leads with theirs. Times stay
/// those of the whole.
pub fn split(whole: &AxisMotion, leads: [Lead; 2]) -> (AxisMotion, [Lead; 2]) {
    let n = whole.t_s.len();
    let [mut before, mut after] = leads;
    let first = before.centres.len().min(n);
    let last = n.saturating_sub(after.centres.len()).max(first);
    before.motion = cut(whole, 0..first);
    after.motion = cut(whole, last..n);
    (cut(whole, first..last), [before, after])
}

fn cut(m: &AxisMotion, rows: std::ops::Range<usize>) -> AxisMotion {
    let of = |list: &AxisRows| list.part(rows.clone());
    let t_s = m.t_s.get(rows.clone()).unwrap_or_default().to_vec();
    AxisMotion {
        time_s: t_s.last().unwrap_or(&0.0) - t_s.first().unwrap_or(&0.0),
        position: of(&m.position),
        velocity: of(&m.velocity),
        acceleration: of(&m.acceleration),
        jerk: of(&m.jerk),
        feed: m.feed.get(rows.clone()).unwrap_or_default().to_vec(),
        t_s,
    }
}
