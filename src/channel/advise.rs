//! What would open a channel, or open it wider: another B, a longer tool, a slimmer holder.
//!
//! All of it looks at places on the path no nearer to one another than they must be for the count asked for, and not at the moves between
//! them: a plan with the values found is what proves them. Stick-out and holder are found by bisection: a longer
//! shank in place of holder, or a slimmer holder, never takes room away.

use rayon::prelude::*;

use crate::artifact::Toolpath;
use crate::artifact::channel::Width;
use crate::error::{Result, Stage};
use crate::observe::{Observer, Silent};
use crate::tool::Tool;

use super::forbidden::Free;
use super::{ChannelOptions, Surroundings, chain, check_input, layers, report, samples, walls};

/// Places on the path that advice looks at, about.
const PLACES: usize = 2000;
/// Bisections stop at these.
const B_DEG: f64 = 0.1;
const STICKOUT_MM: f64 = 0.5;
const FACTOR: f64 = 0.01;
/// The longest stick-out that is tried, as a multiple of the tool's own.
const LONGEST: f64 = 6.0;

/// What opens a channel.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Advice {
    /// The channel as the job has it.
    pub now: Width,
    /// Ranges of B, degrees, that have a channel with the tool as it is, to 0.1°.
    pub b_ranges_deg: Vec<[f64; 2]>,
    /// The B among those looked at with the widest monotone channel.
    pub best_b_deg: Option<f64>,
    /// Least stick-out that has a channel at the job's B, mm, to 0.5 mm; none: no stick-out up to six times the tool's own does.
    pub least_stickout_mm: Option<f64>,
    /// Radii of the holder's stages, mm, thinner by the same factor, with which the tool has a channel at the job's B and stick-out,
    /// as thick as possible; none: not even without a holder.
    pub holder_radii_mm: Option<Vec<f64>>,
    /// Places on the path that were looked at.
    pub places: usize,
}

/// About `places` of the path's locations, evenly.
fn thinned(path: &Toolpath, places: usize) -> Toolpath {
    let every = path.locations.len().div_ceil(places.max(1)).max(1);
    let last = path.locations.len().saturating_sub(1);
    let keep = path.locations.iter().enumerate().filter(|(i, _)| i % every == 0 || *i == last);
    Toolpath { locations: keep.map(|(_, l)| *l).collect(), turns: Vec::new(), ..path.clone() }
}

/// Width of the channel at the places of `path` as it is.
fn width(around: &Surroundings, tool: &Tool, path: &Toolpath, options: &ChannelOptions) -> Result<Width> {
    let scene = around.scene(tool, options);
    let samples = samples::along(path, f64::INFINITY);
    let layers = layers(&scene, &samples, &Silent)?;
    let at = |row: usize| path.locations.get(row).map_or((0, 0.0), |l| (l.turn, l.turn_s_mm));
    let b_deg = options.b_rad.to_degrees();
    let chain = match chain::widest(&layers, 2.0 * options.tolerance_rad) {
        Ok(chain) => chain,
        Err(closed) => {
            let reporter = report::Reporter { blade: around.blade, path, scene: &scene, samples: &samples };
            let (turn, turn_s_mm) = at(samples.get(closed.at).map_or(0, |s| s.row));
            let binds = reporter.closed(&layers, closed.at).message;
            return Ok(Width { b_deg, narrowest_deg: None, monotone_deg: None, turn, turn_s_mm, binds });
        }
    };
    let chosen: Vec<Free> = layers.iter().zip(&chain.chosen).filter_map(|(l, &k)| l.get(k).copied()).collect();
    let mut rows = walls::rows(&samples, &chosen, &scene);
    let narrowest_deg = rows.iter().map(|r| (r.theta_max - r.theta_min).to_degrees()).reduce(f64::min);
    let _ = walls::hulls(&mut rows);
    let hull = rows.iter().enumerate().map(|(i, r)| (r.hull_max - r.hull_min, i));
    let (monotone, row) = hull.fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
    let (turn, turn_s_mm) = at(row);
    let binds = rows.get(row).map_or_else(String::new, |r| {
        let (low, high) = (report::short(&r.binds_min), report::short(&r.binds_max));
        format!("{low} below, {high} above")
    });
    Ok(Width { b_deg, narrowest_deg, monotone_deg: Some(monotone.to_degrees()), turn, turn_s_mm, binds })
}

/// The channel's width at each of the angles `b_deg`, in their order, at about `places` of the path's locations.
///
/// # Errors
/// Those of [`super::plan`], but a closed channel is none.
pub fn sweep_b(
    around: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    b_deg: &[f64],
    places: usize,
    observer: &dyn Observer,
) -> Result<Vec<Width>> {
    check_input(tool, path, options)?;
    let path = thinned(path, places);
    let one = |b: &f64| {
        observer.check(Stage::Channel)?;
        let options = ChannelOptions { b_rad: b.to_radians(), ..options.clone() };
        options.validate()?;
        width(around, tool, &path, &options)
    };
    b_deg.par_iter().map(one).collect()
}

/// What would open a channel; `b_deg` are the angles to look at, rising.
///
/// # Errors
/// Those of [`super::plan`], but a closed channel is none.
pub fn advise(
    around: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    b_deg: &[f64],
    observer: &dyn Observer,
) -> Result<Advice> {
    let widths = sweep_b(around, tool, path, options, b_deg, PLACES, observer)?;
    let thin = thinned(path, PLACES);
    let at_b = |b: f64| width(around, tool, &thin, &ChannelOptions { b_rad: b.to_radians(), ..options.clone() });
    let with = |tool: &Tool| -> Result<bool> {
        observer.check(Stage::Channel)?;
        Ok(width(around, tool, &thin, options)?.is_open())
    };
    let mut best: Option<&Width> = None;
    for w in widths.iter().filter(|w| w.is_open()) {
        if best.is_none_or(|b| w.monotone_deg > b.monotone_deg) {
            best = Some(w);
        }
    }
    Ok(Advice {
        now: width(around, tool, &thin, options)?,
        b_ranges_deg: open_ranges(&widths, |b| Ok(at_b(b)?.is_open()))?,
        best_b_deg: best.map(|w| w.b_deg),
        least_stickout_mm: least_stickout(tool, with)?,
        holder_radii_mm: thickest_holder(tool, with)?,
        places: thin.locations.len(),
    })
}

/// Least value in `lo ..= hi` for which `open` holds, to `step`, where it holds at `hi`; `open` never stops to hold.
fn bisect(lo: f64, hi: f64, step: f64, open: impl Fn(f64) -> Result<bool>) -> Result<Option<f64>> {
    if !open(hi)? {
        return Ok(None);
    }
    let (mut shut, mut found) = (lo, hi);
    if open(lo)? {
        return Ok(Some(lo));
    }
    while (found - shut).abs() > step {
        let middle = 0.5 * (shut + found);
        if open(middle)? { found = middle } else { shut = middle }
    }
    Ok(Some(found))
}

/// Ranges of B that are open, their ends found between what was looked at.
fn open_ranges(widths: &[Width], open: impl Fn(f64) -> Result<bool>) -> Result<Vec<[f64; 2]>> {
    let mut out: Vec<[f64; 2]> = Vec::new();
    let edge = |shut: &Width, inside: &Width| {
        Ok::<f64, crate::Error>(bisect(shut.b_deg, inside.b_deg, B_DEG, &open)?.unwrap_or(inside.b_deg))
    };
    for (i, w) in widths.iter().enumerate().filter(|(_, w)| w.is_open()) {
        let before = i.checked_sub(1).and_then(|k| widths.get(k));
        if before.is_some_and(Width::is_open)
            && let Some(last) = out.last_mut()
        {
            last[1] = w.b_deg;
        } else {
            out.push([before.map_or(Ok(w.b_deg), |b| edge(b, w))?, w.b_deg]);
        }
        if let (Some(after), Some(last)) = (widths.get(i + 1).filter(|a| !a.is_open()), out.last_mut()) {
            last[1] = edge(after, w)?;
        }
    }
    Ok(out)
}

fn least_stickout(tool: &Tool, open: impl Fn(&Tool) -> Result<bool>) -> Result<Option<f64>> {
    let least = tool.radius_mm + STICKOUT_MM;
    bisect(least, LONGEST * tool.stickout_mm, STICKOUT_MM, |stickout_mm| open(&Tool { stickout_mm, ..tool.clone() }))
}

fn thickest_holder(tool: &Tool, open: impl Fn(&Tool) -> Result<bool>) -> Result<Option<Vec<f64>>> {
    let thinner = |factor: f64| {
        let mut t = tool.clone();
        t.holder.iter_mut().for_each(|h| h.radius_mm *= factor);
        t
    };
    if !open(&Tool { holder: Vec::new(), ..tool.clone() })? {
        return Ok(None);
    }
    // From the tool's own holder (0) to one of a hundredth of its radius (0.99).
    let found = bisect(0.0, 1.0 - FACTOR, FACTOR, |less| open(&thinner(1.0 - less)))?;
    Ok(found.map(|less| thinner(1.0 - less).holder.iter().map(|h| h.radius_mm).collect()))
}
