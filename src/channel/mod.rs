//! The S–θ channel: at each cutter location the angles that the whole tool may take, followed round the whole path.
//!
//! **In**: a [`Blade`] (its mesh and that mesh's deflection), a [`Tool`], a [`Toolpath`] whose balls do not gouge.
//! **Out**: a [`Channel`], one row per cutter location: an interval of θ, unwrapped over the path (it grows by 2π a turn,
//! since the path runs counter-clockwise), what binds its ends, its monotone hulls, and the paper's limits from tangents.
//!
//! **Method.** The tool axis is `a(θ) = (sin B, cos B cos θ, cos B sin θ)`. A point of the part forbids one or two arcs of
//! θ in closed form (`forbidden`), also when the tool's profile is inflated (`profile`); a tree of spheres over the part's
//! triangles and branch and bound give the union of arcs over the whole part (`forbidden`, and `clear` for triangles that the
//! tool nearly touches along their plane). What is left are free intervals; the permitted range of the contact angle
//! `acos(a·n)` narrows them. Free intervals that overlap from place to place are joined to chains,
//! and the chain whose least overlap is greatest is taken (`chain`). Hulls: `hull_min` is the running greatest of the
//! lower limits, `hull_max` the running least of the upper limits from the end: a schedule that never turns back exists
//! exactly where `hull_min <= hull_max`, and then everywhere between them one can go on.
//!
//! **Guaranteed**: at every place looked at (cutter locations and places between them, no farther apart than
//! `max_step_mm` and a tenth of a radian of the normal) and every θ of its interval, no point of the part's mesh is nearer to taper, shank or holder than the
//! clearance plus the mesh's deflection. Ends are at most `tolerance_rad` inside those of the exact mesh, or of a tool
//! inflated by an eighth of the tolerance times the distance from the ball centre, where the tool touches the part
//! along a whole line at once. Between places looked at, walls are taken as straight.
//!
//! **Not looked at**: the ball itself (the path's own promise), machine parts other than the holder, axis limits.
//!
//! **Fails** with kind `Infeasible` where no chain leads round the path, or where the hulls cross; the message names the
//! turn, S, the point, the part of the tool and the face of the part.

mod arcs;
mod chain;
mod clear;
mod forbidden;
mod options;
mod profile;
mod report;
mod samples;
mod tangent;
mod tree;
mod walls;

use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::artifact::channel::ChannelRow;
use crate::artifact::{Blade, Channel, Toolpath};
use crate::error::{Error, Result, Stage};
use crate::observe::{Observer, Warning};
use crate::tool::Tool;

pub use options::ChannelOptions;

use forbidden::{Free, Scene, Search};
use profile::Profile;
use samples::Sample;
use tree::SphereTree;

/// Places that one thread works on in a row; fixed, so that the result does not depend on the number of threads.
const BATCH: usize = 64;

/// The channel of a tool path.
///
/// # Errors
/// Kind `Usage` for impossible options or tool, `Infeasible` where there is no channel or no monotone schedule in it,
/// `Cancelled`.
pub fn plan(
    blade: &Blade,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    observer: &dyn Observer,
) -> Result<Channel> {
    options.validate()?;
    tool.validate()?;
    check_input(blade, path)?;
    let part = &blade.part;
    let tree = SphereTree::new(&part.mesh, 2.0 * tool.radius_mm);
    let scene =
        Scene { mesh: &part.mesh, tree: &tree, profile: Profile::new(tool, options, part.deflection_mm), options };
    let samples = samples::along(path, options.max_step_mm);
    let layers = free_everywhere(&scene, &samples, observer)?;
    let reporter = report::Reporter { blade, path, scene: &scene, samples: &samples };
    let chain = chain::widest(&layers, 2.0 * options.tolerance_rad).map_err(|c| reporter.closed(&layers, c.at))?;
    let chosen: Vec<&Free> = layers.iter().zip(&chain.chosen).filter_map(|(l, &k)| l.get(k)).collect();
    let s_mm: Vec<f64> = path.locations.iter().map(|l| l.s_mm).collect();
    let mut rows = walls::rows(&samples, &chosen, &s_mm, &scene);
    let azimuths = samples::azimuths(path);
    for (row, (least, greatest)) in rows.iter_mut().zip(tangent::limits(path, tool.taper_deg.to_radians(), &azimuths)) {
        (row.tangent_min, row.tangent_max) = (least, greatest);
    }
    let narrowest_row = walls::hulls(&mut rows).map_err(|crossing| reporter.crossing(&rows, crossing))?;
    warn_if_narrow(&rows, narrowest_row, path, observer);
    Ok(Channel { b_rad: options.b_rad, tolerance_rad: options.tolerance_rad, rows, narrowest_row, chains: chain.count })
}

fn check_input(blade: &Blade, path: &Toolpath) -> Result<()> {
    let bad = |m: &str| Err(Error::usage(Stage::Channel, m));
    if blade.part.mesh.triangles.is_empty() {
        return bad("the part has no triangles");
    }
    if !blade.part.mesh.points.iter().all(|p| p.coords.iter().all(|c| c.is_finite())) {
        return bad("the part has points that are not finite");
    }
    if path.locations.is_empty() {
        return bad("the tool path has no cutter locations");
    }
    let finite = |v: &nalgebra::Vector3<f64>| v.iter().all(|c| c.is_finite());
    if !path.locations.iter().all(|l| finite(&l.centre.coords) && finite(&l.normal)) {
        return bad("the tool path has locations that are not finite");
    }
    Ok(())
}

/// The free intervals of every place, unwrapped; in order, whatever the number of threads.
fn free_everywhere(scene: &Scene, samples: &[Sample], observer: &dyn Observer) -> Result<Vec<Vec<Free>>> {
    let done = AtomicUsize::new(0);
    let batches: Vec<Vec<Vec<Free>>> = samples
        .par_chunks(BATCH)
        .map(|batch| {
            observer.check(Stage::Channel)?;
            let mut search = Search::new(scene);
            let free =
                batch.iter().map(|s| unwrapped(search.free(&s.centre, &s.normal, s.azimuth), s.azimuth)).collect();
            let so_far = done.fetch_add(batch.len(), Ordering::Relaxed) + batch.len();
            observer.progress(Stage::Channel, so_far, samples.len());
            Ok(free)
        })
        .collect::<Result<_>>()?;
    Ok(batches.into_iter().flatten().collect())
}

fn unwrapped(mut free: Vec<Free>, azimuth: f64) -> Vec<Free> {
    for f in &mut free {
        f.lo += azimuth;
        f.hi += azimuth;
    }
    free
}

/// Warns where the monotone channel is less than a degree wide.
fn warn_if_narrow(rows: &[ChannelRow], narrowest: usize, path: &Toolpath, observer: &dyn Observer) {
    let (Some(row), Some(at)) = (rows.get(narrowest), path.locations.get(narrowest)) else { return };
    let width = (row.hull_max - row.hull_min).to_degrees();
    if width < 1.0 {
        observer.warn(Warning {
            stage: Stage::Channel,
            message: format!(
                "the monotone channel is only {width:.3}° wide at turn {}, S = {:.3} mm: the schedule has little room there",
                at.turn, at.turn_s_mm
            ),
        });
    }
}

#[cfg(test)]
mod tests;
