//! Free angles of a cutter with a corner, which leans forwards along the way.
//!
//! The contact stays while θ turns, so the disc under the corner goes with it: its centre is
//! `p + r n + R (n − a cos α) / sin α` ([`crate::tool::contact`]). Three things limit θ.
//!
//! * The contact angle, forwards, and the ridges that passes are laid for: a window of θ
//!   ([`super::windows`]).
//! * Taper, shank and holder, in pieces of the window ([`super::halved`]). Walls lie at most a
//!   tenth of a millimetre inside those that are asked for.
//! * The disc itself ([`super::discs`]): on hollow ground its back cuts where the axis leans too
//!   little. It is looked at where angles are a twentieth of a radian apart at most, and the ends
//!   of what is clear are halved to the tolerance. What lies between these angles is a matter of
//!   the checks, which follow the whole motion.

use std::f64::consts::FRAC_PI_2;

use super::discs::Discs;
use super::forbidden::Free;
use super::report::Reporter;
use super::samples::Sample;
use super::windows::WindowScene;
use super::{ChannelOptions, Surroundings, halved};
use crate::artifact::Toolpath;
use crate::error::{Bound, Error, Infeasible, Result, Stage};
use crate::observe::Observer;
use crate::parallel;
use crate::tool::Tool;
use crate::tool::inclination::forwards_rad;

/// Places that one thread looks at in a row.
const CHUNK: usize = 64;

/// Free intervals of all places of the path of corners.
pub(super) fn layers(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (samples, path): (&[Sample], &Toolpath),
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let scene = WindowScene { around, tool, options, path };
    let windows = scene.windows(samples);
    let clear_of_tool = halved::clear_of_tool(&scene, samples, &windows, observer)?;
    let chunks = samples.len().div_ceil(CHUNK);
    parallel::try_map(0..chunks, |k| {
        observer.check(Stage::Channel)?;
        let mut discs = Discs::new(&scene);
        let places = (k * CHUNK..((k + 1) * CHUNK).min(samples.len())).collect::<Vec<_>>();
        let of = |i: usize| clear_of_tool[i].iter().flat_map(|free| discs.clear(&samples[i], free)).collect();
        Ok(places.into_iter().map(of).collect::<Vec<Vec<Free>>>())
    })
    .map(|chunks: Vec<_>| chunks.into_iter().flatten().collect())
}

/// Free angles at a place that do not join on to those just before, and the inclination with which
/// they would.
pub(super) fn apart(layers: &[Vec<Free>], reporter: &Reporter, at: usize) -> Option<Error> {
    let before = at.checked_sub(1)?;
    let (last, next) = (layers.get(before)?.last()?, layers.get(at)?.first()?);
    let mut error = reporter.closed(layers, at);
    if next.lo > last.hi {
        let sample = reporter.samples.get(before)?;
        let needs_deg = sample.cone.tool_axis(next.lo).angle(&sample.normal).to_degrees();
        error.message.push_str(&format!("; at {needs_deg:.2}° just before they would"));
    }
    Some(error)
}

/// Why no angle is free at a place, and what would do: the contact angle, or the disc.
pub(super) fn closed(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (reporter, at): (&Reporter, usize),
) -> Option<Error> {
    let sample = reporter.samples.get(at)?;
    let scene = WindowScene { around, tool, options, path: reporter.path };
    let [least, most] = [options.settings.contact_angle_min_deg, options.settings.contact_angle_max_deg];
    let place = reporter.place(sample.row);
    let refused = |why: String, bound: Bound, advice: String| {
        let message = format!("no angle of the tool axis is free at {place}: {why}");
        let what = Infeasible::NoFreeAngle {
            at: reporter.at(sample.row),
            at_start: at == 0,
            bounds: vec![bound],
            region_may_end_mm: reporter.above(sample.row),
        };
        Some(Error::infeasible(Stage::Channel, message, what).advise(advice))
    };
    let Some([_, high]) = scene.window(reporter.samples, at) else {
        let azimuth = sample.azimuth;
        let nearest_deg = sample.cone.tool_axis(azimuth).angle(&sample.normal).to_degrees();
        let why = format!(
            "head and wall lean apart by {nearest_deg:.2}°, the angle between tool axis and surface normal may be at most {most}°"
        );
        let advice = "lean the head with machine.b_deg, end the region before that place, or allow more with \
                      channel.contact_angle_max_deg";
        return refused(why, Bound::ContactAngle, advice.into());
    };
    let mut discs = Discs::new(&scene);
    let cut = discs.cut_at(sample, high)?;
    let (bound, name) = discs.bound(&cut);
    let square = forwards_rad(&sample.cone, &sample.normal, FRAC_PI_2);
    let would = square.map(|on| sample.azimuth + on).filter(|end| discs.cut_at(sample, *end).is_none());
    let (advice, more) = match would {
        Some(clear) => {
            let (clear, _) = discs.end(sample, (clear, high), cut);
            let needs_deg = sample.cone.tool_axis(clear).angle(&sample.normal).to_degrees();
            (
                "let it lean more with channel.contact_angle_max_deg, or take a narrower cutter or a larger corner"
                    .to_owned(),
                format!("; at {needs_deg:.2}° it would be clear there"),
            )
        }
        None => ("take a narrower cutter, or a ball".into(), "; no inclination would do".into()),
    };
    let why = format!("inclined by {least}° to {most}° the cutter cuts {name} beside its contact{more}");
    refused(why, bound, advice)
}
