//! Spherical interpolation between key orientations: the rival that the piecewise method is
//! compared with.
//!
//! After Ho, Hwang and Hu 2003 ("Five-axis tool orientation smoothing using quaternion
//! interpolation algorithm", Int. J. Mach. Tools Manuf. 43): orientations are chosen at a few key
//! places and unit quaternions are interpolated between them. With B fixed all orientations differ
//! by rotations about the blade axis only. Spherical interpolation (slerp) of two such rotations
//! turns evenly from one angle to the other, and the spherical cubic through many (squad) is a
//! cubic in the angle. The published cubic takes keys to be evenly spaced. Here they are not, and
//! its tangents overshoot on narrow channels, so harmonic means replace them. Between two keys θ
//! then stays between their angles. Its slope is continuous over arc length, and its second
//! derivative jumps. On wide channels tangents weighted by length have lower peaks (measured: 0.160
//! against 0.423 deg/mm² on `steam_root`). The comparison is with this form and not with the best
//! of the kind.
//!
//! *Key places*: the concave–convex altered points of the path, where the azimuth of the normal
//! turns back, and between them as many more that it turns at most 90° from one to the next. *Key
//! orientations*: the fixed lead, moved into the channel where it lies outside. The curve turns
//! back where its keys do, and nothing keeps it in the channel between them.

use super::curve;
use super::{ScheduleOptions, bezier, fixed};
use crate::artifact::schedule::ScheduleKind;
use crate::artifact::{Channel, Schedule, Toolpath};
use crate::error::{Result, Stage};
use crate::numerics::monotone::slopes;
use crate::observe::{Doubt, Observer, Warning};

/// Greatest change of the normal's azimuth between two keys, rad.
const APART: f64 = std::f64::consts::FRAC_PI_2;
/// The azimuth turns back where it does so by more than this, rad: less is noise of facets.
const TURNS_BACK: f64 = 0.05;
/// Keys are at least this many ball radii apart: between nearer ones a curve would overshoot.
const SPACING: f64 = 0.25;

/// See the module's page.
pub(super) fn plan(
    path: &Toolpath,
    channel: &Channel,
    options: &ScheduleOptions,
    observer: &dyn Observer,
) -> Result<Schedule> {
    observer.check(Stage::Schedule)?;
    let lead = fixed::angles(path, channel, options);
    let s: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let mut keys = key_places(&lead);
    thin(&mut keys, &s, SPACING * path.radius_mm);
    let at: Vec<f64> = keys.iter().map(|k| s[*k]).collect();
    let angle: Vec<f64> = keys
        .iter()
        .map(|k| {
            let r = &channel.rows[*k];
            if r.theta_min <= r.theta_max { lead[*k].clamp(r.theta_min, r.theta_max) } else { lead[*k] }
        })
        .collect();
    let pieces = curve::hermite(&at, &angle, &slopes(&at, &angle));
    let theta = bezier::sample_freely(&pieces, &s);
    let mut out = curve::schedule(ScheduleKind::Quaternion, pieces, theta, &curve::true_walls(s, channel));
    out.key_points = at.into_iter().zip(angle).map(|(s, t)| [s, t]).collect();
    if out.reversals > 0 || out.quality.outside_rad > channel.tolerance_rad {
        let outside_deg = out.quality.outside_rad.to_degrees();
        let doubt = Doubt::QuaternionLeavesChannel { outside_deg, reversals: out.reversals };
        observer.warn(Warning { stage: Stage::Schedule, doubt });
    }
    Ok(out)
}

/// First and last location, places where `angle` turns back, and places between, see the module's
/// page.
fn key_places(angle: &[f64]) -> Vec<usize> {
    let last = angle.len().saturating_sub(1);
    let mut turns = vec![0];
    let (mut sense, mut extreme) = (0.0, 0);
    for i in 1..=last {
        let ahead = angle[i] - angle[extreme];
        if sense == 0.0 {
            if ahead.abs() > TURNS_BACK {
                (sense, extreme) = (ahead.signum(), i);
            }
        } else if ahead * sense >= 0.0 {
            extreme = i;
        } else if ahead.abs() > TURNS_BACK {
            turns.push(extreme);
            (sense, extreme) = (-sense, i);
        }
    }
    turns.push(last);
    turns.dedup();
    let mut keys = vec![0];
    for w in turns.windows(2) {
        let (from, to) = (angle[w[0]], angle[w[1]]);
        let parts = ((to - from).abs() / APART).ceil().max(1.0);
        let mut i = w[0];
        for k in 1..parts as usize {
            let want = from + (to - from) * k as f64 / parts;
            while i < w[1] && (angle[i] - want) * (to - from) < 0.0 {
                i += 1;
            }
            keys.push(i);
        }
        keys.push(w[1]);
    }
    keys.dedup();
    keys
}

/// Leaves out keys nearer than `least` to the one before; the last stays.
fn thin(keys: &mut Vec<usize>, s: &[f64], least: f64) {
    let Some(last) = keys.pop() else { return };
    let mut kept: Vec<usize> = Vec::with_capacity(keys.len() + 1);
    for &k in keys.iter() {
        if kept.last().is_none_or(|b| s[k] - s[*b] >= least) {
            kept.push(k);
        }
    }
    while kept.len() > 1 && kept.last().is_some_and(|b| s[last] - s[*b] < least) {
        kept.pop();
    }
    kept.push(last);
    *keys = kept;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_where_the_normal_turns_back_and_every_quarter_turn() {
        // Rises by 4 rad, falls by 1, rises by 1; ripples of 0.002 rad are noise.
        let angle: Vec<f64> = (0..600)
            .map(|i| {
                let x = f64::from(i) / 100.0;
                let ripple = 0.002 * f64::from(i % 2);
                ripple
                    + if x < 4.0 {
                        x
                    } else if x < 5.0 {
                        8.0 - x
                    } else {
                        x - 2.0
                    }
            })
            .collect();
        let keys = key_places(&angle);
        assert_eq!(keys.len(), 6, "{keys:?}");
        assert_eq!((keys[0], keys[5]), (0, 599));
        assert!((keys[3] as i32 - 400).abs() <= 1 && (keys[4] as i32 - 500).abs() <= 1, "{keys:?}");
    }

    #[test]
    fn nothing_overshoots_between_uneven_keys() {
        let s = [0.0, 0.1, 50.0, 50.2, 50.4, 80.0];
        let theta = [0.0, 1.5, 1.4, 3.0, 4.6, 4.7];
        let pieces = curve::hermite(&s, &theta, &slopes(&s, &theta));
        assert_eq!(curve::reversals(&pieces), 2);
        // A straight line is kept.
        assert!(slopes(&s, &s).iter().all(|m| (m - 1.0).abs() < 1e-12));
    }

    #[test]
    fn keys_too_near_to_one_another_are_thinned() {
        let s = [0.0, 1.0, 1.2, 2.5, 9.0, 9.5];
        let mut keys = vec![0, 1, 2, 3, 4, 5];
        thin(&mut keys, &s, 1.0);
        assert_eq!(keys, [0, 1, 3, 5]);
    }
}
