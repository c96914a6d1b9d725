//! Free angles of a cutter with a corner, which leans forwards along the way.
//!
//! The contact stays while θ turns, so the disc under the corner goes with it: its centre is
//! `p + r n + R (n − a cos α) / sin α` ([`crate::tool::contact`]). Three things limit θ.
//!
//! * The contact angle, forwards, and the ridges that passes are laid for: a window of θ
//!   ([`Inclined::window_rad`]).
//! * Taper, shank and holder. The window is cut into pieces in which the centre stays within a
//!   room [`ROOM_MM`] of where it is in the middle of the piece; there the search of balls runs
//!   about that centre, with the room added to the clearance. So a wall lies at most twice that
//!   room inside the one that is asked for.
//! * The disc itself: on hollow ground its back cuts where the axis leans too little. It is
//!   looked at where angles are [`LOOK_RAD`] apart at most, and the ends of what is clear are
//!   halved to the tolerance. What lies between these angles is a matter of the checks, which
//!   follow the whole motion.

use std::f64::consts::FRAC_PI_2;

use super::arcs::Witness;
use super::forbidden::Free;
use super::report::Reporter;
use super::samples::Sample;
use super::{ChannelOptions, Surroundings, track};
use crate::artifact::{Obstacle, Toolpath};
use crate::error::{Bound, Error, Infeasible, Result, Stage};
use crate::geometry::near_disc::DiscSearch;
use crate::geometry::{Point, Vector};
use crate::observe::Observer;
use crate::parallel;
use crate::tool::Tool;
use crate::tool::inclination::{BEND, Bending, Inclined, forwards_rad};

/// Half of what the centre moves while one search stands for all angles of a piece, mm.
const ROOM_MM: f64 = 0.05;
/// Turning of the surface normal from place to place, rad: windows are hardly wider than what they
/// move by round an edge, and are to overlap.
pub(super) const TURN_RAD: f64 = 0.02;
/// Pieces of the window at most: wider ones get more room.
const MOST_PIECES: usize = 24;
/// Angles at which the disc is looked at are no farther apart than this, rad.
const LOOK_RAD: f64 = 0.05;
/// The disc may come nearer than its corner's radius by this, mm: a third of a micrometre is what
/// gouges are judged to.
const CUT_MM: f64 = 3e-4;
/// About its contact the disc is not looked at, as far as it rises by this on flat ground, mm:
/// what fits farther off fits there.
const RISES_MM: f64 = 0.01;
/// The bend of the surface is looked at over so many places at most to either side.
const MOST_BEND: usize = 50;
/// A window begins so much lower than at the place beside it at most, rad, seen from the normal.
const OPENS_RAD: f64 = 0.01;
/// Places that one thread looks at in a row.
const CHUNK: usize = 64;
/// Places at which the greatest way of the centre over a window is measured.
const WAYS: usize = 8;

/// A cutter with a corner among bodies.
struct Scene<'a> {
    around: &'a Surroundings<'a>,
    tool: &'a Tool,
    options: &'a ChannelOptions,
    path: &'a Toolpath,
}

/// θ from and to, rad.
type Window = Option<[f64; 2]>;

/// Free intervals of all places of the path of corners.
pub(super) fn layers(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (samples, path): (&[Sample], &Toolpath),
    observer: &dyn Observer,
) -> Result<Vec<Vec<Free>>> {
    let scene = Scene { around, tool, options, path };
    let windows = scene.windows(samples);
    let clear_of_tool = scene.clear_of_tool(samples, &windows, observer)?;
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

/// Why no angle is free at a place, and what would do: the contact angle, or the disc.
pub(super) fn closed(
    around: &Surroundings,
    tool: &Tool,
    options: &ChannelOptions,
    (reporter, at): (&Reporter, usize),
) -> Option<Error> {
    let sample = reporter.samples.get(at)?;
    let scene = Scene { around, tool, options, path: reporter.path };
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

impl Scene<'_> {
    /// θ that contact angle and ridges leave at a place.
    fn window(&self, samples: &[Sample], k: usize) -> Window {
        let (s, settings) = (&samples[k], &self.options.settings);
        let contact_deg = [settings.contact_angle_min_deg, settings.contact_angle_max_deg];
        let inclined = Inclined::new(self.tool, contact_deg, s.cone)?;
        Some(inclined.window_rad(&self.bending(samples, k))?.map(|on| s.azimuth + on))
    }

    /// The same at all places. Where the path turns, windows open fast; walls are straight between
    /// locations, so they open no faster than by [`OPENS_RAD`] from place to place.
    fn windows(&self, samples: &[Sample]) -> Vec<Window> {
        let mut windows: Vec<Window> = parallel::map(0..samples.len(), |k| self.window(samples, k));
        let mut ease = |k: usize, before: usize| {
            if let (Some([from, _]), Some([low, high])) = (windows[before], &mut windows[k]) {
                let turned = samples[k].azimuth - samples[before].azimuth;
                *low = low.max((from + turned - OPENS_RAD).min(*high));
            }
        };
        (1..samples.len()).for_each(|k| ease(k, k - 1));
        (1..samples.len()).rev().for_each(|k| ease(k - 1, k));
        windows
    }

    /// How the surface bends along the way, from a step before a place to one beyond it.
    fn bending(&self, samples: &[Sample], k: usize) -> Bending {
        let (s, corner) = (&samples[k], self.tool.corner_mm());
        let far = |other: &&Sample| (other.centre - s.centre).norm() >= BEND * corner;
        let before = samples[..k].iter().rev().take(MOST_BEND).find(far).or(samples[..k].last()).unwrap_or(s);
        let beyond = samples[k + 1..].iter().take(MOST_BEND).find(far).or(samples.get(k + 1)).unwrap_or(s);
        Bending::of_corner(s.normal, beyond.centre - before.centre, beyond.normal - before.normal, corner)
    }

    /// Centre of the disc at θ, on the corner's centre of a place.
    fn centre(&self, s: &Sample, theta: f64) -> Option<(Point, Vector)> {
        let axis = s.cone.tool_axis(theta);
        let contact = s.centre - s.normal * self.tool.corner_mm();
        Some((self.tool.centre_at(&contact, &s.normal, &axis, None)?, axis))
    }

    /// What taper, shank and holder leave of the windows.
    fn clear_of_tool(&self, samples: &[Sample], windows: &[Window], observer: &dyn Observer) -> Result<Vec<Vec<Free>>> {
        let way = |(s, window): (&Sample, &Window)| {
            let Some([low, high]) = *window else { return 0.0 };
            let at = |k: usize| self.centre(s, low + (high - low) * k as f64 / WAYS as f64).map(|c| c.0);
            let ways = (0..WAYS).filter_map(|k| Some((at(k + 1)? - at(k)?).norm()));
            // Of chords, which are shorter than the way.
            WAYS as f64 * 1.1 * ways.fold(0.0, f64::max)
        };
        let ways = samples.iter().zip(windows).collect::<Vec<_>>();
        let longest_mm = parallel::map(&ways, |pair| way(*pair)).into_iter().fold(0.0, f64::max);
        let pieces = ((longest_mm / (2.0 * ROOM_MM)).ceil() as usize).clamp(1, MOST_PIECES);
        let room_mm = 0.5 * longest_mm / pieces as f64;
        let all_angles = self.options.clone().with(|s| {
            (s.contact_angle_min_deg, s.contact_angle_max_deg) = (0.0, 180.0);
        });
        let scene = self.around.scene_with(self.tool, &all_angles, room_mm);
        let mut out: Vec<Vec<Free>> = vec![Vec::new(); samples.len()];
        for k in 0..pieces {
            let part = |window: &Window| {
                window.map(|[low, high]| [k, k + 1].map(|j| low + (high - low) * j as f64 / pieces as f64))
            };
            let moved: Vec<Sample> = samples.iter().zip(windows).map(|(s, w)| self.moved(s, part(w))).collect();
            let free = track::free_everywhere(&scene, &moved, observer)?;
            for ((list, window), free) in out.iter_mut().zip(windows).zip(free) {
                let Some(piece) = part(window) else { continue };
                free.iter().for_each(|f| join(list, f, piece, *window));
            }
        }
        Ok(out)
    }

    /// A place with the disc's centre amid a piece of its window.
    fn moved(&self, s: &Sample, piece: Window) -> Sample {
        let middle = piece.map(|[a, b]| 0.5 * (a + b));
        let centre = middle.and_then(|theta| self.centre(s, theta)).map_or(s.centre, |c| c.0);
        Sample { centre, ..*s }
    }
}

/// Takes what of a free interval lies in a piece of a window to those before it.
fn join(list: &mut Vec<Free>, free: &Free, [from, to]: [f64; 2], window: Window) {
    let Some([low, high]) = window else { return };
    let mut new = *free;
    if new.lo <= from {
        (new.lo, new.lo_by) = (from, if from == low { Witness::Contact } else { Witness::Cut });
    }
    if new.hi >= to {
        (new.hi, new.hi_by) = (to, if to == high { Witness::Contact } else { free.hi_by });
    }
    if new.lo > new.hi {
        return;
    }
    match list.last_mut() {
        Some(last) if last.hi >= new.lo => (last.hi, last.hi_by) = (new.hi, new.hi_by),
        _ => list.push(new),
    }
}

/// What the disc would cut.
#[derive(Clone, Copy)]
struct Cut {
    /// 0: the part; else the obstacle with the number less one.
    body: u16,
    /// A point of it that is cut.
    point: Point,
}

/// The disc against the part and the bodies about it.
struct Discs<'a> {
    scene: &'a Scene<'a>,
    /// Each with how near to it the disc may come, mm.
    bodies: Vec<(u16, DiscSearch<'a>, f64)>,
}

impl<'a> Discs<'a> {
    fn new(scene: &'a Scene<'a>) -> Self {
        let corner = scene.tool.corner_mm();
        let part = (0, DiscSearch::new(&scene.around.blade.part), corner + scene.path.stock_mm - CUT_MM);
        let others = scene.around.obstacles.iter().zip(1..).filter(|(o, _)| !o.cut_by_the_tool);
        let others = others.map(|(o, k)| (k, DiscSearch::new(&o.part), corner + o.clearance_mm));
        Discs { scene, bodies: std::iter::once(part).chain(others).collect() }
    }

    /// What the disc cuts at θ, if anything.
    fn cut_at(&mut self, s: &Sample, theta: f64) -> Option<Cut> {
        let scene = self.scene;
        let (centre, axis) = scene.centre(s, theta)?;
        let disc = scene.tool.disc(centre, axis);
        let (corner, contact) = (scene.tool.corner_mm(), s.centre - s.normal * scene.tool.corner_mm());
        let flattest_mm = corner + disc.radius_mm / axis.cross(&s.normal).norm().max(1e-3);
        let spared_mm = (2.0 * RISES_MM * flattest_mm).sqrt().min(disc.radius_mm);
        self.bodies.iter_mut().find_map(|(body, search, near_mm)| {
            // About its contact it is not looked at the part: under it where stock stays there.
            let foot = contact - s.normal * scene.path.stock_mm;
            let spared_mm = if *body == 0 { spared_mm } else { 0.0 };
            // What places between locations may lie off the path.
            let off_mm = if s.fraction > 0.0 { scene.path.chord_mm } else { 0.0 };
            let point = search.cut(&disc, *near_mm - off_mm, (&foot, spared_mm))?;
            Some(Cut { body: *body, point })
        })
    }

    /// The fixture or other body that is cut; `None`: the part itself.
    fn obstacle(&self, cut: &Cut) -> Option<&'a Obstacle> {
        usize::from(cut.body).checked_sub(1).and_then(|k| self.scene.around.obstacles.get(k))
    }

    /// The triangle that is cut.
    fn triangle(&self, cut: &Cut) -> u32 {
        let part = self.obstacle(cut).map_or(&self.scene.around.blade.part, |o| &o.part);
        part.closest_on_mesh(&cut.point, f64::INFINITY).and_then(|c| c.triangle).unwrap_or(0)
    }

    /// What stands in the way, and its name.
    fn bound(&self, cut: &Cut) -> (Bound, String) {
        if let Some(obstacle) = self.obstacle(cut) {
            return (Bound::Fixture { tool: "cutter".into(), name: obstacle.name.clone() }, obstacle.name.clone());
        }
        let part = &self.scene.around.blade.part;
        let face = part.face_name(part.mesh.face(self.triangle(cut) as usize)).to_string();
        (Bound::Part { tool: "cutter".into(), face: face.clone() }, face)
    }

    /// What of a free interval the disc leaves.
    fn clear(&mut self, s: &Sample, free: &Free) -> Vec<Free> {
        let steps = ((free.hi - free.lo) / LOOK_RAD).ceil().max(2.0) as usize;
        let at = |k: usize| free.lo + (free.hi - free.lo) * k as f64 / steps as f64;
        let seen: Vec<Option<Cut>> = (0..=steps).map(|k| self.cut_at(s, at(k))).collect();
        let mut out: Vec<Free> = Vec::new();
        for k in 0..=steps {
            if seen[k].is_some() {
                continue;
            }
            let goes_on = k > 0 && seen[k - 1].is_none();
            match out.last_mut() {
                Some(last) if goes_on => last.hi = at(k),
                _ => {
                    let mut new = Free { lo: at(k), hi: at(k), ..*free };
                    if let Some(cut) = k.checked_sub(1).and_then(|j| seen[j]) {
                        (new.lo, new.lo_by) = self.end(s, (at(k), at(k - 1)), cut);
                    }
                    out.push(new);
                }
            }
            if let (Some(last), Some(Some(cut))) = (out.last_mut(), seen.get(k + 1)) {
                (last.hi, last.hi_by) = self.end(s, (at(k), at(k + 1)), *cut);
            }
        }
        out.retain(|f| f.lo < f.hi);
        out
    }

    /// Where between an angle that is clear and one that is not the disc begins to cut, on the
    /// clear side, and what it cuts.
    fn end(&mut self, s: &Sample, (mut clear, mut taken): (f64, f64), mut cut: Cut) -> (f64, Witness) {
        let tolerance = self.scene.options.settings.tolerance_deg.to_radians();
        while (taken - clear).abs() > tolerance {
            let middle = 0.5 * (clear + taken);
            match self.cut_at(s, middle) {
                Some(found) => (taken, cut) = (middle, found),
                None => clear = middle,
            }
        }
        (clear, Witness::Cutter { body: cut.body, triangle: self.triangle(&cut) })
    }
}
