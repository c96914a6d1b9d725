//! What would open a channel, or open it wider: another B, a longer tool, a slimmer holder.
//!
//! All of it looks at some turns of the path ([`super::stretches`]), not at all and not at the
//! moves between locations: a plan with the values found is what proves them. Only the least travel
//! of Y (`offset` module) is found from all locations. The travel of linear axes limits none of the
//! other values: it changes with lean and tool. Stick-out and holder are found by bisection: a
//! longer shank in place of holder, or a slimmer holder, never takes room away.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::artifact::Toolpath;
use crate::artifact::channel::{Narrowest, Width};
use crate::error::{Error, Result, Stage};
use crate::observe::{Observer, Silent};
use crate::parallel;
use crate::tool::Tool;

use super::forbidden::Free;
use super::offset::{self, LeastTravel};
use super::stretches::{PathPart, stretches};
use super::{ChannelOptions, Surroundings, chain, check_input, check_lean, report, samples_of, walls};

/// Locations of the path that advice looks at, about.
const PLACES: usize = 3000;
/// Bisections stop at these.
const B_DEG: f64 = 0.1;
const STICKOUT_MM: f64 = 0.5;
const FACTOR: f64 = 0.01;
/// Distance of locations of a cutter with a corner that are looked at, mm, and the turn of the
/// surface from one to the next, rad.
const THIN_MM: f64 = 0.3;
const THIN_RAD: f64 = 0.008;
/// Greatest contact angle that is tried, steps from one to the next, and to what the least that
/// opens a channel is found, degrees.
const MOST_CONTACT_DEG: f64 = 60.0;
const CONTACT_STEP_DEG: f64 = 3.0;
const CONTACT_DEG: f64 = 0.1;
/// The widest cutter that is tried, as a multiple of the tool's own.
const WIDEST: f64 = 2.0;
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
    /// Least stick-out that has a channel at the job's B, mm, to 0.5 mm; none: no stick-out up to
    /// six times the tool's own does.
    pub least_stickout_mm: Option<f64>,
    /// Radii of the holder's stages, mm, thinner by the same factor, with which the tool has a
    /// channel at the job's B and stick-out, as thick as possible; none: not even one as thin as
    /// the shank, or the tool has no holder.
    pub holder_radii_mm: Option<Vec<f64>>,
    /// Greatest shank radius, mm, no less than the ball's, that has a channel with the rest of the
    /// tool as it is; none: not even a cutter as thin as its ball.
    pub shank_radius_mm: Option<f64>,
    /// Where no B opens it: which B leads farthest.
    pub farthest: Option<Farthest>,
    /// The least travel of Y with which a schedule exists at the job's B with the tool as it is, at
    /// all locations; none: not even without a limit of it, or the cutter has a corner.
    pub least_travel: Option<LeastTravel>,
    /// Of a cutter with a corner only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<CornerAdvice>,
    /// Locations of the path that were looked at.
    pub places: usize,
}

impl Advice {
    /// Neither another B nor any one change of the tool that was tried opens the channel.
    pub fn opens_nothing(&self) -> bool {
        self.b_ranges_deg.is_empty()
            && self.least_stickout_mm.is_none()
            && self.holder_radii_mm.is_none()
            && self.shank_radius_mm.is_none()
            && self.corner.is_none_or(|c| c.contact_deg.is_none() && c.radius_mm.is_none())
    }
}

/// What opens a channel for a cutter with a corner.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct CornerAdvice {
    /// The least greatest contact angle that has a channel with the tool as it is, degrees, to
    /// 0.1°; none: no angle up to 60° does. Passes are laid for it, so less makes strips wider.
    pub contact_deg: Option<f64>,
    /// Greatest radius of a cutter with that corner, mm, that has a channel within the job's range
    /// of contact angle, to a hundredth of the cutter's: twice the cutter's at most; none:
    /// none wider than the corner does.
    pub radius_mm: Option<f64>,
}

/// How far a channel leads before it closes.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Farthest {
    /// B, degrees.
    pub b_deg: f64,
    /// Turn in which it closes first, of those that were looked at.
    pub turn: u32,
    /// Height of the ball centre there along the blade axis, mm.
    pub height_mm: f64,
}

/// What widths are looked for in.
struct WidthSearch<'a> {
    around: &'a Surroundings<'a>,
    stretches: Vec<PathPart>,
    observer: &'a dyn Observer,
    /// The stretch that was closed last: the likeliest to be closed again.
    closed: AtomicUsize,
}

impl<'a> WidthSearch<'a> {
    fn new(
        around: &'a Surroundings<'a>,
        (tool, path): (&Tool, &Toolpath),
        options: &ChannelOptions,
        places: usize,
        observer: &'a dyn Observer,
    ) -> Self {
        let far = ChannelOptions { max_step_mm: f64::INFINITY, ..options.clone() };
        let mut stretches = stretches(path, &samples_of(tool, path, &far), places);
        // Chords of a cutter with a corner are short.
        if !tool.is_ball() {
            stretches.iter_mut().for_each(|s| *s = s.thinned(THIN_MM, THIN_RAD));
        }
        WidthSearch { around, stretches, observer, closed: AtomicUsize::new(0) }
    }

    /// The same places with another lean of the tool axes, rad.
    fn leaning(&self, lean_rad: f64) -> Self {
        let closed = AtomicUsize::new(self.closed.load(Ordering::Relaxed));
        WidthSearch { stretches: self.stretches.iter().map(|s| s.leaning(lean_rad)).collect(), closed, ..*self }
    }

    /// Locations that are looked at.
    fn places(&self) -> usize {
        self.stretches.iter().map(|s| s.path.locations.len()).sum()
    }

    /// Width of the channel; of several stretches the narrowest, or the first that is closed.
    fn width(&self, tool: &Tool, options: &ChannelOptions) -> Result<Width> {
        let first_closed = AtomicUsize::new(usize::MAX);
        let one = |(i, stretch): (usize, &PathPart)| {
            // What comes after a closed one does not matter any more; what comes before does.
            if i > first_closed.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let width = self.width_of(stretch, tool, options, true)?;
            if width.monotone_deg.is_none() {
                first_closed.fetch_min(i, Ordering::Relaxed);
            }
            Ok(Some(width))
        };
        let found: Vec<Option<Width>> = parallel::try_map(self.stretches.iter().enumerate(), one)?;
        let mut all = found.into_iter().flatten();
        let Some(mut least) = all.next() else {
            return Err(Error::usage(Stage::Channel, "the tool path has no cutter locations"));
        };
        for w in all {
            if least.monotone_deg.is_none() {
                break;
            }
            let narrowest_deg = least.narrowest_deg.zip(w.narrowest_deg).map(|(a, b)| a.min(b));
            if w.monotone_deg < least.monotone_deg {
                least = w;
            }
            least.narrowest_deg = narrowest_deg.filter(|_| least.monotone_deg.is_some());
        }
        Ok(least)
    }

    /// A schedule that never turns back exists in every stretch.
    fn is_open(&self, tool: &Tool, options: &ChannelOptions) -> Result<bool> {
        let likeliest = self.closed.load(Ordering::Relaxed);
        if let Some(s) = self.stretches.get(likeliest)
            && !self.width_of(s, tool, options, false)?.is_open()
        {
            return Ok(false);
        }
        let others = self.stretches.iter().enumerate().filter(|(i, _)| *i != likeliest);
        let closed = AtomicBool::new(false);
        let ended = parallel::try_map(others, |(i, s)| {
            // Whichever is closed says it for all.
            if closed.load(Ordering::Relaxed) {
                return Err(None);
            }
            match self.width_of(s, tool, options, false) {
                Ok(w) if w.is_open() => Ok(()),
                Ok(_) => {
                    self.closed.store(i, Ordering::Relaxed);
                    closed.store(true, Ordering::Relaxed);
                    Err(None)
                }
                Err(e) => Err(Some(e)),
            }
        });
        match ended {
            Ok(_) => Ok(true),
            Err(None) => Ok(false),
            Err(Some(e)) => Err(e),
        }
    }

    /// With `why` a closed one says what closes it.
    fn width_of(&self, stretch: &PathPart, tool: &Tool, options: &ChannelOptions, why: bool) -> Result<Width> {
        self.observer.check(Stage::Channel)?;
        let for_search = self.around.for_search(options);
        let scene = self.around.scene(tool, &for_search);
        let (path, samples) = (&stretch.path, &stretch.samples);
        let layers = self.around.layers(tool, &scene, (samples, path), &Silent)?;
        let at = |row: usize| path.locations.get(row).map_or((0, 0.0), |l| (l.turn, l.turn_s_mm));
        let b_deg = path.cone(0).lean_rad.to_degrees();
        let chain = match chain::widest(&layers, 2.0 * options.settings.tolerance_deg.to_radians()) {
            Ok(chain) => chain,
            Err(closed) => {
                let (blade, is_start) = (self.around.blade, stretch.is_start);
                let reporter = report::Reporter { blade, path, scene: &scene, samples, is_start };
                let (turn, turn_s_mm) = at(samples.get(closed.at).map_or(0, |s| s.row));
                let says = || self.around.closed(tool, options, (&reporter, &layers), closed.at);
                let binds = why
                    .then(says)
                    .map_or(Narrowest::NotLookedAt, |e| Narrowest::Closed { message: e.message, why: e.infeasible });
                return Ok(Width { b_deg, narrowest_deg: None, monotone_deg: None, turn, turn_s_mm, binds });
            }
        };
        let chosen: Vec<Free> = layers.iter().zip(&chain.chosen).filter_map(|(l, &k)| l.get(k).copied()).collect();
        let mut rows = walls::rows(samples, &chosen, &scene);
        let narrowest_deg = rows.iter().map(|r| (r.theta_max - r.theta_min).to_degrees()).reduce(f64::min);
        let _ = walls::hulls(&mut rows, options.sweep);
        let hull = rows.iter().enumerate().map(|(i, r)| (r.hull_max - r.hull_min, i));
        let (monotone, row) = hull.fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a });
        let (turn, turn_s_mm) = at(row);
        let binds = rows.get(row).map_or(Narrowest::NotLookedAt, |r| {
            let [below, above] = [&r.binds_min, &r.binds_max].map(|b| report::bound(b, &self.around.blade.part));
            Narrowest::Between { below, above }
        });
        Ok(Width { b_deg, narrowest_deg, monotone_deg: Some(monotone.to_degrees()), turn, turn_s_mm, binds })
    }

    fn sweep(&self, tool: &Tool, options: &ChannelOptions, b_deg: &[f64]) -> Result<Vec<Width>> {
        let one = |b: &f64| {
            check_lean(b.to_radians())?;
            self.leaning(b.to_radians()).width(tool, options)
        };
        parallel::try_map(b_deg, one)
    }
}

/// Angles of the pivot at which the channel's width is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Leans<'a> {
    /// The angles B, degrees.
    pub b_deg: &'a [f64],
    /// About how many locations are looked at, in whole turns.
    pub places: usize,
}

/// The channel's width at each of the angles, in their order.
///
/// # Errors
/// Those of [`super::plan`], but a closed channel is none.
pub fn sweep_b(
    around: &Surroundings,
    tool: &Tool,
    path: &Toolpath,
    options: &ChannelOptions,
    leans: Leans,
    observer: &dyn Observer,
) -> Result<Vec<Width>> {
    check_input(tool, path, options)?;
    let options = &ChannelOptions { travel: Vec::new(), ..options.clone() };
    WidthSearch::new(around, (tool, path), options, leans.places, observer).sweep(tool, options, leans.b_deg)
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
    check_input(tool, path, options)?;
    // Travel of linear axes changes with lean and stick-out: what is advised is without it.
    let options = &ChannelOptions { travel: Vec::new(), ..options.clone() };
    let look = WidthSearch::new(around, (tool, path), options, PLACES, observer);
    // Where the centre goes with θ, the offset is not that of the path.
    let least_travel = match tool.is_ball() {
        true => offset::least_travel(path, &super::intervals(around, tool, path, options, observer)?, observer)?,
        false => None,
    };
    let corner = if tool.is_ball() { None } else { Some(corner_advice(&look, tool, options)?) };
    let widths = look.sweep(tool, options, b_deg)?;
    let at_b = |b: f64| look.leaning(b.to_radians()).is_open(tool, options);
    let with = |tool: &Tool| look.is_open(tool, options);
    let mut best: Option<&Width> = None;
    for w in widths.iter().filter(|w| w.is_open()) {
        if best.is_none_or(|b| w.monotone_deg > b.monotone_deg) {
            best = Some(w);
        }
    }
    Ok(Advice {
        now: look.width(tool, options)?,
        b_ranges_deg: open_ranges(&widths, at_b)?,
        best_b_deg: best.map(|w| w.b_deg),
        least_stickout_mm: least_stickout(tool, with)?,
        holder_radii_mm: thickest_holder(tool, with)?,
        shank_radius_mm: thickest_shank(tool, with)?,
        farthest: if best.is_none() { farthest(&widths, path) } else { None },
        least_travel,
        corner,
        places: look.places(),
    })
}

/// The least inclination and the widest disc.
fn corner_advice(look: &WidthSearch, tool: &Tool, options: &ChannelOptions) -> Result<CornerAdvice> {
    let least_deg = options.settings.contact_angle_min_deg;
    let leaning = |most_deg: f64| {
        let leaning = options.clone().with(|s| s.contact_angle_max_deg = most_deg);
        look.is_open(tool, &leaning)
    };
    let mut shut = least_deg;
    let mut contact_deg = None;
    // Which angle opens it first is not known from one that is open: more may close it again.
    while contact_deg.is_none() && shut < MOST_CONTACT_DEG {
        let next = (shut + CONTACT_STEP_DEG).min(MOST_CONTACT_DEG);
        contact_deg = bisect(shut + CONTACT_DEG, next, CONTACT_DEG, leaning)?;
        shut = next;
    }
    let corner_mm = tool.corner_mm();
    let widest_mm = WIDEST * tool.radius_mm;
    // From the widest (0) downwards; the shank is as much wider than the cutter as the tool's own.
    let narrower = |by_mm: f64| {
        let radius_mm = widest_mm - by_mm;
        let shank_radius_mm = tool.shank_radius_mm - tool.radius_mm + radius_mm;
        look.is_open(&Tool { radius_mm, shank_radius_mm, ..tool.clone() }, options)
    };
    let found = bisect(0.0, widest_mm - corner_mm * (1.0 + FACTOR), FACTOR * tool.radius_mm, narrower)?;
    Ok(CornerAdvice { contact_deg, radius_mm: found.map(|by_mm| widest_mm - by_mm) })
}

/// Least value in `lo ..= hi` for which `open` holds, to `step`, where it holds at `hi`; `open`
/// never stops to hold.
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
    if tool.holder.is_empty() {
        return Ok(None);
    }
    let shank_mm = tool.shank_radius_mm;
    let thinner = |factor: f64| {
        let mut t = tool.clone();
        t.holder.iter_mut().for_each(|h| h.radius_mm = (h.radius_mm * factor).max(h.radius_mm.min(shank_mm)));
        t
    };
    // From the tool's own holder (0) to one that is nowhere thicker than the shank.
    let thickest_mm = tool.holder.iter().map(|h| h.radius_mm).fold(shank_mm, f64::max);
    let most = (1.0 - shank_mm / thickest_mm).max(FACTOR);
    let found = bisect(0.0, most, FACTOR, |less| open(&thinner(1.0 - less)))?;
    Ok(found.map(|less| thinner(1.0 - less).holder.iter().map(|h| h.radius_mm).collect()))
}

fn thickest_shank(tool: &Tool, open: impl Fn(&Tool) -> Result<bool>) -> Result<Option<f64>> {
    let most_mm = (tool.shank_radius_mm - tool.radius_mm).max(0.0);
    let step_mm = (FACTOR * tool.shank_radius_mm).max(0.5 * FACTOR);
    // From the tool's own shank (0) to one as thin as the ball.
    let thinner = |by_mm: f64| Tool { shank_radius_mm: tool.shank_radius_mm - by_mm, ..tool.clone() };
    let found = bisect(0.0, most_mm, step_mm, |by_mm| open(&thinner(by_mm)))?;
    Ok(found.map(|by_mm| thinner(by_mm).shank_radius_mm))
}

/// Of closed channels the one that closes last.
fn farthest(widths: &[Width], path: &Toolpath) -> Option<Farthest> {
    let far = |w: &Width| (w.turn, w.turn_s_mm);
    let mut best: Option<&Width> = None;
    for w in widths.iter().filter(|w| w.monotone_deg.is_none()) {
        if best.is_none_or(|b| far(b) < far(w)) {
            best = Some(w);
        }
    }
    let w = best?;
    let at = path.locations.iter().find(|l| far(w) <= (l.turn, l.turn_s_mm))?;
    Some(Farthest { b_deg: w.b_deg, turn: w.turn, height_mm: at.centre.x })
}
