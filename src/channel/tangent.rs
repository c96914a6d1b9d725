//! The paper's limits: tangents of the path of ball centres, seen along the axis of each location's
//! cone.
//!
//! On convex stretches the tool axis may lie between the backward and the forward tangent; on a
//! concave stretch the backward limit is that of the inflection where it begins and the forward
//! limit that of the one where it ends (there the walls of the pocket stand highest). Each limit is
//! then turned inwards by the tool's taper half angle.

use std::f64::consts::PI;

use crate::artifact::Toolpath;

/// Turning that a stretch needs before it counts as concave, rad: less is noise.
const NOISE_RAD: f64 = 2e-3;

/// Limits (least, greatest) at each location, rad; `near` gives for each location the azimuth about
/// which to unwrap.
pub(super) fn limits(path: &Toolpath, taper_rad: f64, near: &[f64]) -> Vec<(f64, f64)> {
    let forward = headings(path, near);
    // Backward tangent at i: against the heading of the step that leads to i; its azimuth is
    // heading − π.
    let mut out: Vec<(f64, f64)> = (0..near.len())
        .map(|i| {
            let before = forward[i.saturating_sub(1)];
            (before - PI, forward[i])
        })
        .collect();
    for (a, b) in concave_stretches(&forward) {
        let (least, greatest) = (out[a].0, out[b].1);
        for limit in out.iter_mut().take(b + 1).skip(a) {
            *limit = (least, greatest);
        }
    }
    for limit in &mut out {
        *limit = (limit.0 + taper_rad, limit.1 - taper_rad);
    }
    out
}

/// Unwrapped heading of the step from each location to the next (of the last step for the last
/// location), chosen near the azimuth of the normal plus a right angle.
fn headings(path: &Toolpath, near: &[f64]) -> Vec<f64> {
    let l = &path.locations;
    let mut out: Vec<f64> = Vec::with_capacity(l.len());
    for i in 0..l.len() {
        let step = l.get(i + 1).map(|n| path.cone(i).seen(&(n.centre - l[i].centre)));
        let expected = out.last().copied().unwrap_or(near[i] + 0.5 * PI);
        let heading = match step {
            Some(d) if d.y.hypot(d.z) > 0.0 => {
                let h = d.z.atan2(d.y);
                h + 2.0 * PI * ((expected - h) / (2.0 * PI)).round()
            }
            _ => expected,
        };
        out.push(heading);
    }
    out
}

/// Stretches (first and last location) over which the heading falls: between the last inflection
/// before and the first after each place where it falls by more than noise below its greatest value
/// so far.
fn concave_stretches(heading: &[f64]) -> Vec<(usize, usize)> {
    let mut out = Vec::new();
    let Some(&start) = heading.first() else { return out };
    let (mut top, mut top_at) = (start, 0);
    let mut bottom: Option<(f64, usize)> = None;
    for (i, &h) in heading.iter().enumerate() {
        match bottom {
            None if h >= top => (top, top_at) = (h, i),
            None if h < top - NOISE_RAD => bottom = Some((h, i)),
            None => {}
            Some((low, _)) if h <= low => bottom = Some((h, i)),
            Some((low, at)) if h > low + NOISE_RAD => {
                out.push((top_at, at));
                (top, top_at) = (h, i);
                bottom = None;
            }
            Some(_) => {}
        }
    }
    if let Some((_, at)) = bottom {
        out.push((top_at, at));
    }
    out
}
